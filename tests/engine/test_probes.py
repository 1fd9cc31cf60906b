"""tools/tapenade/probes: what the engines do with idioms of C, against the table of its README.md.

Our side always; Tapenade itself when the environment variable TAPENADE names the program.
"""

import ctypes
import itertools
import os
import pathlib
import re
import shutil
import subprocess
import sys
import textwrap

import engine
import harness
import numpy
import pytest

PROBES = harness.ROOT / "tools" / "tapenade" / "probes"
TAPENADE = os.environ.get("TAPENADE")
STRUCTURE = "{4, (int[]){2, 2, 3, 4}, (int[]){0, 1, 2, 1}}"
COLUMNS = ("d", "dv", "b")
# what a cell may say for what happens
MEANS = {
    "ok": {"ok"},
    "wrong": {"wrong"},
    "does not compile": {"does not compile"},
    "argument lost": {"argument lost"},
    "no derivative": {"no derivative"},
    "no": {"wrong", "does not compile", "argument lost", "no derivative"},
    "partly": {"ok", "wrong", "does not compile", "argument lost", "no derivative"},
}
MEANS["mostly not"] = MEANS["partly"]


def table():
    """file -> (what ours says, the three cells of Tapenade)"""
    rows = {}
    for line in (PROBES / "README.md").read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if len(cells) == 6 and cells[0].endswith(".c"):
            rows[cells[0]] = (cells[2], cells[3:])
    return rows


TABLE = table()


def test_table():
    """Each file has its row, and says in its first line what the table says."""
    assert set(TABLE) == {path.name for path in PROBES.glob("*.c")}
    for line in (PROBES / "README.md").read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if cells[0] in TABLE:
            first = (PROBES / cells[0]).read_text(encoding="utf-8").splitlines()[0]
            assert first == f"/* {cells[1]} */"


@pytest.mark.parametrize("name", TABLE)
def test_is_c(name):
    done = subprocess.run(
        [
            "cc",
            "-std=gnu17",
            "-fsyntax-only",
            "-Wall",
            "-Wextra",
            "-Werror",
            "-Wno-unused-parameter",
            PROBES / name,
        ],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("name", [name for name in TABLE if TABLE[name][0] == "accepted"])
def test_accepted(build, name):
    head = engine.Head("probe", ["y"], ["x"])
    files = {file: (PROBES / file).read_text(encoding="utf-8") for file in ("probe.h", name)}
    library = build(files, [head], structures=[STRUCTURE], header="probe.h")
    for seed in range(4):
        harness.check(library.problem(head), numpy.random.default_rng(seed))


@pytest.mark.parametrize("name", [name for name in TABLE if TABLE[name][0] != "accepted"])
def test_refused(name):
    head = engine.Head("probe", ["y"], ["x"], sources=[name])
    with pytest.raises(engine.Refusal) as caught:
        engine.differentiate([str(PROBES / name)], [head], [str(PROBES)], includes=("probe.h",))
    refusal = caught.value
    assert pathlib.Path(refusal.file).name == name
    assert f"line {refusal.line}: {refusal.reason}" == TABLE[name][0]


# ---------------------------------------------------------------------------------------- Tapenade

OPTIONS = {"d": ["-d"], "dv": ["-d", "-vector"], "b": ["-b"]}
ARGUMENTS = {"d": "t, x, xd, y, yd", "dv": "t, x, xd, y, yd, nbdirs", "b": "t, x, xb, y, yb"}
WIDTH = 8
MAIN = """#include "probe.h"

static const topo structure = %s;

void run_f(double *x, double *y)
{
  probe(&structure, x, y);
}

void run(double *x, double *xd, double *y, double *yd)
{
%s}
"""
CALL = {
    "d": """  void probe_d(const topo *, const double *, const double *, double *, double *);

  probe_d(&structure, x, xd, y, yd);
""",
    "dv": f"""  void probe_dv(const topo *, const double *, const double (*)[{WIDTH}], double *,
                double (*)[{WIDTH}], int);

  probe_dv(&structure, x, (void *)xd, y, (void *)yd, {WIDTH});
""",
    "b": """  void probe_b(const topo *, const double *, double *, double *, double *);

  probe_b(&structure, x, xd, y, yd);
""",
}


def tapenade(program, folder, name, mode):
    """What happens, in the words of the table."""
    for path in (PROBES / "probe.h", PROBES / name):
        shutil.copy(path, folder)
    output = folder / "out"
    output.mkdir()
    command = [
        program,
        *OPTIONS[mode],
        "-head",
        "probe(y)/(x)",
        "-copyname",
        f"%_nd_{mode}",
        *(["-nbdirsmax", str(WIDTH)] if mode == "dv" else []),
        "-I",
        ".",
        "-O",
        "out",
        name,
    ]
    done = subprocess.run(
        command,
        cwd=folder,
        capture_output=True,
        text=True,
        errors="replace",
        stdin=subprocess.DEVNULL,
        timeout=600,
        check=False,
    )
    said = done.stdout + done.stderr
    said += "".join(path.read_text(errors="replace") for path in output.glob("*.msg"))
    code = output / f"{name[:-2]}_{mode}.c"
    if not code.exists() or re.search(
        r"derivative .*(unknown|not (known|defined|provided))", said, re.IGNORECASE
    ):
        return "no derivative"
    text = code.read_text(errors="replace")
    definition = re.search(rf"\bprobe_{mode}\s*\(([^;{{]*)\)\s*{{", text)
    if not definition:
        return "no derivative"
    if len(harness.commas(definition[1])) < len(ARGUMENTS[mode].split()):
        return "argument lost"
    (output / "DIFFSIZES.inc").write_text(f"#define NBDirsMax {WIDTH}\n")
    (output / "DIFFSIZES.h").write_text(f"#define NBDirsMax {WIDTH}\n")
    (folder / "main.c").write_text(MAIN % (STRUCTURE, CALL[mode]))
    try:
        harness.compile_library(
            folder / "probe.so",
            [folder / "main.c", folder / name, code, *sorted(harness.RUNTIME.glob("*.c"))],
            ["-O1", "-w"],
            [folder, output, harness.RUNTIME],
        )
    except harness.CompileError:
        return "does not compile"
    # in a process of its own: wrong code may end it
    done = subprocess.run(
        [sys.executable, "-B", __file__, folder / "probe.so", mode],
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
    )
    return "ok" if done.returncode == 0 else "wrong"


def right(library, mode):
    """Whether the derivative agrees with differences."""
    so = ctypes.CDLL(library)
    n = 4

    def call(function, *arrays):
        getattr(so, function)(*(ctypes.c_void_p(a.ctypes.data) for a in arrays))

    def f(x):
        y = numpy.zeros(n)
        call("run_f", numpy.array(x), y)
        return y

    for seed in range(4):
        rng = numpy.random.default_rng(seed)
        x = rng.uniform(-0.9, 0.9, n)
        J = numpy.array([(f(x + 1e-6 * e) - f(x - 1e-6 * e)) / 2e-6 for e in numpy.eye(n)]).T
        y = f(x)
        if mode == "b":
            weights = rng.uniform(-1.0, 1.0, n)
            got = rng.uniform(-1.0, 1.0, n)  # Tapenade sets the adjoints of pure inputs
            call("run", numpy.array(x), got, y, numpy.array(weights))
            expected = weights @ J
        else:
            shape = (n, WIDTH) if mode == "dv" else (n,)
            direction, got = rng.uniform(-1.0, 1.0, shape), numpy.zeros(shape)
            call("run", numpy.array(x), numpy.array(direction), y, got)
            expected = J @ direction
        if not numpy.allclose(got, expected, rtol=1e-6, atol=1e-6):
            return False
    return True


# one skipped test without it
@pytest.mark.parametrize("name, mode", itertools.product(TABLE, COLUMNS) if TAPENADE else [])
def test_tapenade(tmp_path, name, mode):
    cell = TABLE[name][1][COLUMNS.index(mode)]
    happens = tapenade(TAPENADE, tmp_path, name, mode)
    if cell == "not tried":
        pytest.skip(f"not tried until now: {happens}")
    allowed = set().union(*(MEANS[word.strip()] for word in cell.split(",")))
    assert happens in allowed, f"{name}, {mode}: the table says {cell}, Tapenade: {happens}"


STAND_IN = """\
    #!{python}
    import pathlib, sys
    sys.path.insert(0, {tools!r})
    import engine
    arguments = sys.argv[1:]
    source, folder = arguments[-1], pathlib.Path(arguments[arguments.index("-O") + 1])
    mode = "b" if "-b" in arguments else "d" + "v"*("-vector" in arguments)
    head = engine.Head("probe", ["y"], ["x"], [mode])
    files = engine.differentiate([source], [head], ["."], includes=("probe.h",))
    name = source[:-2] + "_" + mode + ".c"
    text = files[name]
    {change}
    (folder / name).write_text(text)
    (folder / "maggi_ad.h").write_text(files["maggi_ad.h"])
"""


@pytest.mark.parametrize(
    "change, mode, happens",
    [
        ("", "d", "ok"),
        ("", "dv", "ok"),
        (
            "text = text.replace('xb[0] += ', 'xb[0] = ').replace('xb[i] += ', 'xb[i] = ')",
            "b",
            "ok",
        ),
        ("text = text.rstrip()[:-1] + '  yd[0] += 1.0;\\n}\\n'", "d", "wrong"),
        ("text = text.replace('{\\n', '{\\n  *(int *)0 = 1;\\n', 1)", "d", "wrong"),
        ("text = text.replace(';', '', 1)", "b", "does not compile"),
        (
            "text = text.replace(', double yd', ', ...); void probe_no(double yd')",
            "d",
            "no derivative",
        ),
        ("text = text.replace('probe_d(', 'probe_e(')", "d", "no derivative"),
        ("sys.exit()", "b", "no derivative"),
        ("print('(AD03) Command: derivative of floor is unknown')", "d", "no derivative"),
        (
            "text = 'void probe_d(const topo *t, const double *x, double *y)\\n{\\n}\\n'",
            "d",
            "argument lost",
        ),
    ],
)
def test_runner(tmp_path, change, mode, happens):
    """The words for what a program does that plays Tapenade's part: each is found."""
    program = tmp_path / "tapenade"
    program.write_text(
        textwrap.dedent(STAND_IN).format(
            python=sys.executable, tools=str(harness.ROOT / "tools" / "tapenade"), change=change
        )
    )
    program.chmod(0o755)
    work = tmp_path / "work"
    work.mkdir()
    assert tapenade(program, work, "integers.c", mode) == happens


if __name__ == "__main__":
    sys.exit(0 if right(sys.argv[1], sys.argv[2]) else 1)
