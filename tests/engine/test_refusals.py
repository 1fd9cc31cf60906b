"""What the engine refuses: file, line and reason.

refusals.c is C that a compiler accepts, a head each; a comment stands above what is refused.
"""

import pathlib
import re
import subprocess

import engine
import harness
import pytest
from functions import PROTOTYPE, define, files, heads

TEXT = (harness.HERE / "refusals.c").read_text(encoding="utf-8")
UNKNOWN = ["floor", "ceil", "hypot", "cbrt", "fma", "expm1", "log1p", "fmod", "fmax", "log10"]
UNKNOWN += ["exp2", "erf", "round", "copysign"]
ARGUMENTS = {"hypot": 2, "fma": 3, "fmod": 2, "fmax": 2, "copysign": 2}
UNKNOWN_REASON = "no derivative is known of `{}`, which is neither in these sources nor elementary"


def refused():
    """head -> (line, reason)"""
    found = {}
    for comment in re.finditer(r"/\* REFUSED (.*?) \*/", TEXT, re.S):
        line = TEXT.count("\n", 0, comment.end()) + 2
        reason = re.sub(r"\s*\n[ *]*", " ", comment[1]).strip()
        reason = re.sub(r"@-(\d)", lambda back: str(line - int(back[1])), reason)
        # the head around the comment, or the next one
        end = TEXT.index("\n}\n", comment.end())
        inside = [
            head[2]
            for head in PROTOTYPE.finditer(TEXT, 0, comment.start())
            if TEXT.index("\n}\n", head.end()) == end
        ]
        found[inside[0] if inside else PROTOTYPE.search(TEXT, comment.end())[2]] = (line, reason)
    return found


REFUSED = refused()


def write(folder, text):
    for name, content in files(text).items():
        (folder / name).write_text(content, encoding="utf-8")


def refusal(folder, head):
    with pytest.raises(engine.Refusal) as caught:
        engine.differentiate([str(folder / "a.c")], [head], [str(folder)])
    return caught.value


def test_all_have_a_reason():
    assert list(REFUSED) == [head.name for head in heads(TEXT)]


def test_is_c(tmp_path):
    write(tmp_path, TEXT)
    done = subprocess.run(
        ["cc", "-std=gnu17", "-fsyntax-only", "-w", tmp_path / "a.c"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("head", heads(TEXT), ids=lambda head: head.name)
def test_refused(tmp_path, head):
    write(tmp_path, TEXT)
    found = refusal(tmp_path, head)
    assert (found.line, found.reason) == REFUSED[head.name]
    assert str(found) == f"{tmp_path / 'a.c'}:{found.line}: {found.reason}"


def loop(value):
    return define("head", f"\n  int i;\n\n  for (i = 0; i < t->n; ++i) y[i] = {value};\n")


@pytest.mark.parametrize("name", UNKNOWN)
@pytest.mark.parametrize("values", ["q[i], s, p[i]", "1.5, 2.0, 2.5"])
def test_unknown_derivative(tmp_path, name, values):
    """Of passive values too, where it would not matter: there is one list of functions."""
    values = ", ".join(values.split(", ")[: ARGUMENTS.get(name, 1)])
    text = loop(f"q[i] * {name}({values})")
    write(tmp_path, text)
    found = refusal(tmp_path, heads(text)[0])
    assert (found.line, found.reason) == (7, UNKNOWN_REASON.format(name))


PLAIN = """\
void head(const topo *t, const double p[t->np], const double q[t->n], double s, double y[t->n],
          double Y[t->n + 1][3])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = q[i] * s;
}
"""
OTHER = """
void other(const topo *t, const double q[t->n], double y[t->n], double Y[t->n + 1][3])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    Y[i][0] = q[i] * q[i];
    y[i] = Y[i][0] * 2.0;
  }
}
"""

# what is wrong with a line of heads.txt: outputs, inputs, reason
HEADS = {
    "no such head": ("tail", ["y"], ["q"], "there is no function `tail`"),
    "no such output": ("head", ["z"], ["q"], "`z` is not a real argument of `head`"),
    "no such input": ("head", ["y"], ["z"], "`z` is not a real argument of `head`"),
    "structure as an input": ("head", ["y"], ["t"], "`t` is not a real argument of `head`"),
    "const output": ("head", ["q"], ["p"], "`head` cannot write `q`"),
    "scalar output": ("head", ["s"], ["p"], "`head` cannot write `s`"),
    "unused input": ("head", ["y"], ["p"], "`y` of `head` does not depend on p"),
    "output that is not written": ("head", ["y", "Y"], ["q"], "`Y` of `head` does not depend on q"),
    "a result on the way that is not listed": (
        "other",
        ["y"],
        ["q"],
        "`Y` of `other` depends on q and is used, but is not an output",
    ),
}


@pytest.mark.parametrize("name", HEADS)
def test_heads(tmp_path, name):
    """A refusal of a line of heads.txt has the place that the line has."""
    function, outputs, inputs, reason = HEADS[name]
    write(tmp_path, PLAIN + OTHER)
    head = engine.Head(function, outputs, inputs)
    head.place = ("heads.txt", 12)
    assert str(refusal(tmp_path, head)) == f"heads.txt:12: {reason}"


def test_head_with_a_value(tmp_path):
    write(tmp_path, "double value(double x)\n{\n  return x * x;\n}\n")
    found = refusal(tmp_path, engine.Head("value", ["x"], ["x"]))
    assert (found.line, found.reason) == (3, "`value` is a head and returns a value")


def test_not_c(tmp_path):
    """What the parser does not understand has a place too."""
    write(tmp_path, loop("q[i] * "))
    found = refusal(tmp_path, engine.Head("head", ["y"], ["q"]))
    assert (pathlib.Path(found.file).name, found.line) == ("a.c", 7)
    assert found.reason.startswith("a syntax error: ")


def test_no_file(tmp_path):
    found = refusal(tmp_path, engine.Head("head", ["y"], ["q"]))
    assert found.reason == "cannot be read: No such file or directory"


def test_no_header(tmp_path):
    (tmp_path / "a.c").write_text('#include "none.h"\nvoid head(double x[2])\n{\n}\n')
    found = refusal(tmp_path, engine.Head("head", ["x"], ["x"]))
    assert found.reason.startswith("preprocessor: ") and "none.h" in found.reason


def test_only_what_is_reached(tmp_path):
    """Functions that no head calls may be what they like."""
    forever = """
static double forever(double *x)
{
  while (*x > 0.0) *x = *x - floor(*x);
  return *x;
}

double other(double x)
{
  return forever(&x);
}
"""
    write(tmp_path, PLAIN + forever)
    head = engine.Head("head", ["y"], ["q", "s"])
    generated = engine.differentiate([str(tmp_path / "a.c")], [head], [str(tmp_path)])
    assert set(generated) == {"maggi_ad.h", "heads.c", *(f"a_{mode}.c" for mode in harness.MODES)}
