"""What is generated: files, signatures, comments, for any structure, compiler and width."""

import os
import re
import shutil
import subprocess
import sys

import engine
import harness
import numpy
import pytest
from functions import CONSTRUCTS, check, define, files, generate, heads
from programs import HEADER, STRUCTURES


VECTORS = """#include "kernel.h"

double dot(const double a[3], const double b[3])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void cross(const double a[3], const double b[3], double r[3])
{
  r[0] = a[1] * b[2] - a[2] * b[1];
  r[1] = a[2] * b[0] - a[0] * b[2];
  r[2] = a[0] * b[1] - a[1] * b[0];
}
"""


def one_of(file, name):
    return next(head for head in heads(CONSTRUCTS[file]) if head.name == name)


def test_plain_comparison(tmp_path):
    """Comparisons without MAGGI_RE give the same code as with it."""
    body = """
  int i;
  double a;

  for (i = 0; i < t->n; ++i) {
    a = LESS(q[i], p[i]) ? q[i] * q[i] : sin(s);
    if (LESS(a * s, 0.25)) a = a * s;
    y[i] = a * a;
  }
"""
    texts = []
    for form in (r"\1 < \2", r"MAGGI_RE(\1) < MAGGI_RE(\2)"):
        generated = generate(tmp_path, define("head", re.sub(r"LESS\((.*?), (.*?)\)", form, body)))
        texts.append(
            {file: re.sub(r"MAGGI_RE\(([^()]*)\)", r"\1", text) for file, text in generated.items()}
        )
    assert texts[0] == texts[1]


@pytest.mark.parametrize("width", [1, 4, 8, 40])
def test_width(build, width):
    """The number of directions is a compile definition."""
    head = one_of("calls", "all_together")
    library = build(
        files(CONSTRUCTS["calls"]), [head], structures=STRUCTURES, width=width, modes=("d", "dv")
    )
    check(library, head, points=1)


@pytest.mark.parametrize("compiler", ["gcc", "clang"])
@pytest.mark.parametrize("flags", [["-O0"], ["-O3", "-march=native"]])
def test_compilers(build, monkeypatch, compiler, flags):
    """Without a warning, and right, whatever the compiler makes of restrict and simd."""
    if not shutil.which(compiler):
        pytest.skip(f"no {compiler}")
    monkeypatch.setenv("CC", compiler)
    if compiler == "clang":  # it may say that it did not vectorise
        flags = [*flags, "-Wno-pass-failed"]
    head = one_of("calls", "all_together")
    library = build(
        files(CONSTRUCTS["calls"]),
        [head],
        structures=STRUCTURES,
        flags=(*flags, *harness.WARNINGS),
    )
    check(library, head, points=2)


@pytest.mark.parametrize("names", ["q", "s", "X", "Xs", "qXs"])
def test_active_inputs(build, names):
    """The same function with each set of inputs: what is not listed has no companion."""
    text = define(
        "head",
        """
  int i;
  double a, b;

  for (i = 0; i < t->n; ++i) {
    a = q[i] * s;
    b = X[i][0] * X[i][1] + sin(s);
    y[i] = a * b + q[i] * X[t->parent[i]][2];
  }
""",
    )
    head = heads(text)[0]
    head.inputs = list(names)
    library = build(files(text), [head], structures=STRUCTURES)
    harness.check(library.problem(head), numpy.random.default_rng(0))


def test_two_files(build):
    """Heads in two files, helpers in a third, shared."""
    kernel = (
        HEADER[: -len("#endif\n")]
        + """
double dot(const double a[3], const double b[3]);
void cross(const double a[3], const double b[3], double r[3]);
void first(const topo *t, const double X[t->n + 1][3], double y[t->n]);
void second(const topo *t, int begin, int end, const double X[t->n + 1][3],
            const double y[t->n], double Y[t->n + 1][3]);
void third(const topo *t, const double X[t->n + 1][3], double s, double e[1]);

#endif
"""
    )
    files = {
        "kernel.h": kernel,
        "vec.c": VECTORS,
        "a.c": """#include "kernel.h"

void first(const topo *t, const double X[t->n + 1][3], double y[t->n])
{
  int i;

  for (i = 0; i < t->n; ++i) y[i] = dot(X[i], X[t->parent[i]]);
}

static double own(double x)
{
  return x * x;
}

void third(const topo *t, const double X[t->n + 1][3], double s, double e[1])
{
  e[0] = own(s) * dot(X[0], X[1]) * t->n;
}
""",
        "b.c": """#include "kernel.h"

static double own(double x)
{
  return sin(x);
}

void second(const topo *t, int begin, int end, const double X[t->n + 1][3],
            const double y[t->n], double Y[t->n + 1][3])
{
  int i, k;
  double r[3];

  for (i = begin; i < end; ++i) {
    cross(X[i], X[t->n], r);
    for (k = 0; k < 3; ++k) Y[i][k] = own(r[k]) * y[i];
  }
}
""",
    }
    heads = [
        engine.Head("first", ["y"], ["X"]),
        engine.Head("third", ["e"], ["X", "s"]),
        engine.Head("second", ["Y"], ["X", "y"], integers={"begin": "1", "end": "t->n"}),
    ]
    library = build(files, heads, structures=STRUCTURES)
    for head in heads:
        for structure in (0, 1):
            harness.check(library.problem(head, structure), numpy.random.default_rng(1))
    assert set(library.files) == {"maggi_ad.h", "heads.c"} | {
        f"{name}_{mode}.c" for name in "ab" for mode in harness.MODES
    }


def test_any_structure(build):
    """The integers may be in a structure of any name, behind an argument of any name."""
    kernel = """#pragma once
#include <math.h>

typedef struct {
  int rows, pairs;
  int *left, right[4];
} plan;

void head(const double x[2], const plan *m, double z[m->rows][2]);
"""
    text = """#include "kernel.h"

void head(const double x[2], const plan *m, double z[m->rows][2])
{
  int i;

  for (i = 0; i < m->rows; ++i) {
    z[i][0] = x[m->left[i]] * x[m->right[i]];
    z[i][1] = m->pairs * sin(x[1]);
  }
}
"""
    head = engine.Head("head", ["z"], ["x"])
    library = build(
        {"kernel.h": kernel, "a.c": text},
        [head],
        structure="plan",
        structures=["{3, 2, (int[]){0, 1, 1}, {1, 1, 0, 0}}"],
    )
    harness.check(library.problem(head), numpy.random.default_rng(0))


def test_no_structure(build):
    """A head may do without."""
    kernel = (
        "#pragma once\n#include <math.h>\n\nvoid head(int n, const double x[n], double z[n]);\n"
    )
    text = """#include "kernel.h"

void head(int n, const double x[n], double z[n])
{
  int i;

  for (i = 0; i < n; ++i) z[i] = x[i] * x[0];
}
"""
    head = engine.Head("head", ["z"], ["x"], integers={"n": "5"})
    library = build({"kernel.h": kernel, "a.c": text}, [head], structure="int", structures=["0"])
    harness.check(library.problem(head), numpy.random.default_rng(0))


# ------------------------------------------------------------------------------- what is generated


TABLE = """#include <stdio.h>
#include "heads.h"

int main(void)
{
  const maggi_topo t = {.n = 3};
  double x[3] = {1.0, 2.0, 3.0}, s[1] = {2.0}, F[3] = {1.0, 1.0, 1.0}, y[3];
  double xd[3] = {1.0, 0.0, 2.0}, sd[1] = {0.5}, Fd[3] = {1.0, 0.0, 0.0}, yd[3];
  double *v[4] = {x, s, F, y}, *vd[4] = {xd, sd, Fd, yd};
  int i, k;

  for (i = 0; i < maggi_nhead; ++i) {
    const maggi_head *h = &maggi_heads[i];
    printf("%s %d%d%d%d\\n", h->name, h->d != NULL, h->dv != NULL, h->b != NULL, h->b_d != NULL);
    for (k = 0; k < h->narg; ++k)
      printf("  %s %d %d\\n", h->arg[k].name, h->arg[k].role, h->arg[k].size(&t));
    h->f(&t, v);
    h->d(&t, v, vd);
    printf("  %g %g %g, %g %g %g\\n", y[1], y[2], F[1], yd[1], yd[2], Fd[2]);
  }
  return 0;
}
"""


def test_table(tmp_path):
    """heads.c: names, roles, sizes and functions of all heads."""
    text = """
void head(const maggi_topo *t, int begin, const double x[t->n], double s, double F[t->n],
          double y[t->n])
{
  int i;

  for (i = begin; i < t->n; ++i) {
    y[i] = x[i] * s;
    F[i] += x[i] * x[i];
  }
}
"""
    header = HEADER.replace("topo", "maggi_topo")
    prototype = text.split("\n{")[0] + ";\n"
    (tmp_path / "kernel.h").write_text(header[: -len("#endif\n")] + prototype + "#endif\n")
    (tmp_path / "a.c").write_text('#include "kernel.h"\n' + text)
    (tmp_path / "topo.h").write_text('#include "kernel.h"\n')  # what heads.h includes
    (tmp_path / "main.c").write_text(TABLE)
    head = engine.Head("head", ["y", "F"], ["x", "s", "F"], ["d", "b"], integers={"begin": "1"})
    generated = engine.differentiate([str(tmp_path / "a.c")], [head], [str(tmp_path)])
    for name, content in generated.items():
        (tmp_path / name).write_text(content)
    subprocess.run(
        [
            "cc",
            *harness.WARNINGS,
            "-o",
            "main",
            "main.c",
            "a.c",
            "a_d.c",
            "a_b.c",
            "heads.c",
            f"-I{harness.RUNTIME}",
            "-I.",
            "-lm",
        ],
        cwd=tmp_path,
        check=True,
    )
    done = subprocess.run([tmp_path / "main"], check=True, capture_output=True, text=True)
    # roles: passive, input, output, both
    assert done.stdout.split("\n") == [
        "head 1010",
        "  x 1 3",
        "  s 1 1",
        "  F 3 3",
        "  y 2 3",
        "  4 6 5, 1 5.5 12",
        "",
    ]


@pytest.mark.parametrize("modes", [["d"], ["b"], ["d", "dv"], ["b", "b_d"]])
def test_modes(tmp_path, modes):
    """Only what is asked for is generated."""
    text = define("head", "\n  int i;\n\n  for (i = 0; i < t->n; ++i) y[i] = q[i] * s;\n")
    generated = generate(tmp_path, text, modes)
    assert set(generated) == {"maggi_ad.h", "heads.c", *(f"a_{mode}.c" for mode in modes)}
    assert set(re.findall(r"\bhead_(\w+)\(", generated["maggi_ad.h"])) == set(modes)


def test_same_text_again(tmp_path):
    """The text does not depend on the order in sets: two processes write the same."""
    script = (
        "import sys, pathlib; sys.path[:0] = sys.argv[1].split(':'); import functions\n"
        "text = functions.CONSTRUCTS['branches']\n"
        "print(functions.generate(pathlib.Path(sys.argv[2]), text))"
    )
    path = f"{harness.HERE}:{harness.ROOT / 'tools' / 'tapenade'}"
    texts = {
        subprocess.run(
            [sys.executable, "-B", "-c", script, path, tmp_path],
            check=True,
            capture_output=True,
            text=True,
            env={**os.environ, "PYTHONHASHSEED": str(seed)},
        ).stdout
        for seed in range(4)
    }
    assert len(texts) == 1 and "switch_on_integers_b_d" in texts.pop()


def test_signatures(tmp_path):
    """The declarations that tools/tapenade/README.md promises."""
    (tmp_path / "kernel.h").write_text(HEADER)
    (tmp_path / "a.c").write_text(
        """#include "kernel.h"

void f(const topo *t, int begin, const double x[t->n][3], double s, const double c[3],
       double y[t->n + 1])
{
  int i;

  for (i = begin; i < t->n; ++i) y[i] = x[i][0] * x[i][1] * s * c[0];
}
"""
    )
    head = engine.Head("f", ["y"], ["x", "s"], integers={"begin": "0"})
    files = engine.differentiate([str(tmp_path / "a.c")], [head], [str(tmp_path)])
    found = {}
    for name, arguments in re.findall(r"void (f_\w+)\((.*?)\);", files["maggi_ad.h"], re.S):
        text = re.sub(r"\s*\brestrict\b\s*", "", re.sub(r"\s+", " ", arguments))
        found[name] = text
    x, y = "const double x[t->n][3]", "double y[t->n + 1]"
    assert found == {
        "f_d": f"const topo *t, int begin, {x}, const double xd[t->n][3], double s, double sd, "
        f"const double c[3], {y}, double yd[t->n + 1]",
        "f_dv": f"const topo *t, int begin, {x}, const double xd[t->n][3][MAGGI_NDIR], double s, "
        f"const double sd[MAGGI_NDIR], const double c[3], {y}, "
        "double yd[t->n + 1][MAGGI_NDIR], int nbdirs",
        "f_b": f"const topo *t, int begin, {x}, double xb[t->n][3], double s, double *sb, "
        f"const double c[3], {y}, double yb[t->n + 1]",
        "f_b_d": f"const topo *t, int begin, {x}, const double xd[t->n][3], double xb[t->n][3], "
        "double xbd[t->n][3], double s, double sd, double *sb, double *sbd, "
        f"const double c[3], {y}, double yd[t->n + 1], double yb[t->n + 1], "
        "double ybd[t->n + 1]",
    }


def test_comments(tmp_path):
    """Equations of the source stand above the lines that come from them."""
    equation = "/* a = q^2 s,  [1] 3.7 */"
    text = define(
        "head",
        f"""
  int i;
  double a;

  for (i = 0; i < t->n; ++i) {{
    {equation}
    a = q[i] * q[i] * s;
    y[i] = sin(a);
  }}
""",
    )
    generated = generate(tmp_path, text)
    for mode in harness.MODES:
        assert equation in generated[f"a_{mode}.c"], mode


def test_nothing_is_recomputed(tmp_path):
    """The workspace is the tape: results are read from it, and nothing is pushed for them."""
    text = define(
        "head",
        """
  int i;

  for (i = 0; i < t->n; ++i) y[i] = sin(q[i]);
  e[0] = 0.0;
  for (i = 0; i < t->n; ++i) e[0] += y[i] * y[i] * s;
""",
    )
    generated = generate(tmp_path, text)
    for mode in ("d", "dv", "b"):
        assert "sin(" not in generated[f"a_{mode}.c"], f"{mode} recomputes sin"
        assert "push" not in generated[f"a_{mode}.c"]
