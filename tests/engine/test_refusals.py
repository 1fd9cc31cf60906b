"""What the engine refuses: file, line and reason of each.

The line is the one that ends in HERE.  Everything here is C that a compiler accepts.
"""

import pathlib
import re
import subprocess

import engine
import harness
import pytest
from programs import HEADER

HEAD = """
void head(const topo *t, const double p[t->np], const double q[t->n],
          const double X[t->n + 1][3], double s, double y[t->n], double Y[t->n + 1][3])
{%s}
"""
LOOP = """
  int i;

  for (i = 0; i < t->n; ++i) y[i] = %s; // HERE
"""

CROSS = """
static void cross(const double a[3], const double b[3], double r[3])
{
  r[0] = a[1] * b[2] - a[2] * b[1];
  r[1] = a[2] * b[0] - a[0] * b[2];
  r[2] = a[0] * b[1] - a[1] * b[0];
}
"""

UNKNOWN = ["floor", "ceil", "hypot", "cbrt", "fma", "expm1", "log1p", "fmod", "fmax", "log10", "exp2",
           "erf", "round", "copysign"]
UNKNOWN_REASON = "no derivative is known of `{}`, which is neither in these sources nor elementary"
ARGUMENTS = {"hypot": 2, "fma": 3, "fmod": 2, "fmax": 2, "copysign": 2}

# name -> (body of the head, reason[, what stands before the head])
REFUSED = {
    # control
    "goto": ("""
  y[0] = q[0];
  goto end; // HERE
end:
  y[1] = q[1];
""", "goto"),
    "while": ("""
  int i;

  i = 0;
  while (i < t->n) { // HERE
    y[i] = q[i];
    i += 1;
  }
""", "a while loop: its number of passes must come from the integers"),
    "do": ("""
  int i;

  i = 0;
  do { // HERE
    y[i] = q[i];
    i += 1;
  } while (i < t->n);
""", "a do loop: its number of passes must come from the integers"),
    "break": ("""
  int i;

  for (i = 0; i < t->n; ++i) {
    y[i] = q[i];
    if (t->kind[i] == 2) break; // HERE
  }
""", "break out of a loop"),
    "continue": ("""
  int i;

  for (i = 0; i < t->n; ++i) {
    if (t->kind[i] == 2) continue; // HERE
    y[i] = q[i];
  }
""", "continue"),
    "early return": ("""
  y[0] = q[0];
  if (t->n < 2) return; // HERE
  y[1] = q[1];
""", "early return in a differentiated function"),
    "early return of a value": (LOOP.replace(" // HERE", "") % "clip(q[i])", "early return in a differentiated function", """
static double clip(double x)
{
  if (MAGGI_RE(x) < 0.0) return 0.0; // HERE
  return x;
}
"""),
    "no return": (LOOP.replace(" // HERE", "") % "both(q[i])", "`both` does not end with its return",
                  """
static double both(double x) // HERE
{
  if (MAGGI_RE(x) < 0.0)
    return 0.0;
  else
    return x;
}
"""),
    "recursion": (LOOP.replace(" // HERE", "") % "power(q[i], 3)", "`power` is recursive", """
static double power(double x, int n)
{
  return n > 0 ? x * power(x, n - 1) : 1.0; // HERE
}
"""),
    "recursion through another": (LOOP.replace(" // HERE", "") % "one(q[i], 3)", "`one` is recursive",
                                  """
static double one(double x, int n);

static double two(double x, int n)
{
  return n > 0 ? x * one(x, n - 1) : 1.0; // HERE
}

static double one(double x, int n)
{
  return two(x, n) + x;
}
"""),
    "falling through a case": ("""
  int i;

  for (i = 0; i < t->n; ++i) {
    switch (t->kind[i]) {
    case 0: // HERE
      y[i] = q[i];
    case 1:
      y[i] = s;
      break;
    }
  }
""", "a case that falls through"),

    # loops
    "counter changed": ("""
  int i;

  for (i = 0; i < t->n; ++i) { // HERE
    y[i] = q[i];
    i += 1;
  }
""", "the loop variable `i` is changed in the loop"),
    "bound changed": ("""
  int i, m;

  m = t->n;
  for (i = 0; i < m; ++i) { // HERE
    y[i] = q[i];
    if (t->kind[i] == 2) m = m - 1;
  }
""", "the loop bound `m` is changed in the loop"),
    "bound from an active value": ("""
  int i;

  for (i = 0; i < s; ++i) y[i] = q[i]; // HERE
""", "a loop bound that is not an expression of integers"),
    "loop over a double": ("""
  double a;

  y[0] = 0.0;
  for (a = 0.0; a < 1.0; a += 0.25) y[0] += a * s; // HERE
""", "a for loop that is not `for (i = a; i < b; ++i)`"),
    "loop with two counters": ("""
  int i, k;

  for (i = 0, k = 2; i < t->n; ++i) y[i] = q[i] + X[0][k]; // HERE
""", "a for loop that is not `for (i = a; i < b; ++i)`"),
    "loop that doubles": ("""
  int i;

  for (i = 1; i < t->n; i *= 2) y[i] = q[i]; // HERE
""", "a for loop that is not `for (i = a; i < b; ++i)`"),
    "loop without end": ("""
  int i;

  for (i = 0; ; ++i) y[i] = q[i]; // HERE
""", "a for loop that is not `for (i = a; i < b; ++i)`"),

    # pointers
    "address of an element": ("""
  cross(&p[0], X[0], Y[0]); // HERE
""", "an interior pointer: pass a row of a two-dimensional array, or the array and an index", CROSS),
    "array plus a number": ("""
  cross(p + 3, X[0], Y[0]); // HERE
""", "an interior pointer: `p` in an expression; pass a row of a two-dimensional array, or the array "
     "and an index", CROSS),
    "local pointer": ("""
  const double *u; // HERE

  u = q;
  y[0] = u[0];
""", "`u` is a local pointer"),
    "local pointer with a value": ("""
  const double *u = q; // HERE

  y[0] = u[0];
""", "`u` is a local pointer"),
    "pointer followed": ("""
  y[0] = *q * s; // HERE
""", "a pointer is followed"),
    "bare pointer": ("""
  y[0] = first(q) * s;
""", "`a` is a bare pointer: say how long the array is", """
static double first(const double *a) // HERE
{
  return a[0];
}
"""),
    "restrict pointer": ("""
  y[0] = first(q) * s;
""", "`a` is a bare pointer: say how long the array is", """
static double first(const double *restrict a) // HERE
{
  return a[0];
}
"""),
    "static in brackets": ("""
  y[0] = first(q) * s;
""", "`a`: `static` in brackets", """
static double first(const double a[static 3]) // HERE
{
  return a[0];
}
"""),
    "pointer to a pointer": ("""
  y[0] = q[0] * s;
  touch(0);
""", "`a` is a pointer to a pointer", """
static void touch(double **a) // HERE
{
  (void)a;
}
"""),
    "function pointer": ("""
  y[0] = apply(sin, q[0]);
""", "`f` is a pointer to a function", """
static double apply(double (*f)(double), double x) // HERE
{
  return f(x);
}
"""),
    "three dimensions": ("""
  y[0] = q[0] * s;
  touch(0);
""", "`A` has more than two dimensions", """
static void touch(double A[2][3][3]) // HERE
{
  (void)A;
}
"""),
    "memory": ("""
  double *a = malloc(3 * sizeof(double)); // HERE

  a[0] = q[0];
  y[0] = a[0];
  free(a);
""", "`a` is a local pointer", "void *malloc(unsigned long size);\nvoid free(void *p);\n"),
    "memcpy": ("""
  memcpy(y, q, t->n * 8); // HERE
""", "`memcpy` on active data",
     "void *memcpy(void *to, const void *from, unsigned long size);\n"),
    "memset": ("""
  memset(y, 0, t->n * 8); // HERE
  y[0] += q[0];
""", "`memset` on active data",
     "void *memset(void *to, int c, unsigned long size);\n"),

    # aliases
    "output is an input": ("""
  double r[3];

  r[0] = q[0];
  r[1] = s;
  r[2] = q[1];
  cross(X[0], r, r); // HERE
  y[0] = r[0];
""", "output `r` of `cross` is an input as well: `b`", CROSS),
    "output row is an input row": ("""
  int i, k;

  for (k = 0; k < 3; ++k) Y[t->n][k] = X[0][k];
  for (i = 0; i < t->n; ++i) cross(X[i], Y[i], Y[i]); // HERE
""", "output `r` of `cross` is an input as well: `b`", CROSS),
    "output is another output": ("""
  double r[3];

  both(X[0], r, r); // HERE
  y[0] = r[0];
""", "output `u` of `both` is another output as well: `v`", """
static void both(const double a[3], double u[3], double v[3])
{
  int k;

  for (k = 0; k < 3; ++k) {
    u[k] = a[k];
    v[k] = 2.0 * a[k];
  }
}
"""),
    "whole array and its row": ("""
  int i;

  for (i = 0; i < t->n; ++i) row(t, i, Y[i], Y); // HERE
""", "output `B` of `row` is an input as well: `a`", """
static void row(const topo *t, int i, const double a[3], double B[t->n + 1][3])
{
  int k;

  for (k = 0; k < 3; ++k) B[i + 1][k] = a[k];
}
"""),

    # declarations
    "initialiser": ("""
  double a = sin(q[0]); // HERE

  y[0] = a * s;
""", "`a` is initialised where it is declared: assign to it"),
    "initialiser of an array": ("""
  double a[3] = {q[0], -s, 0.0}; // HERE

  y[0] = a[0] * a[1];
""", "`a` is initialised where it is declared: assign to it"),
    "const local": ("""
  int i;

  for (i = 0; i < t->n; ++i) {
    const double a = q[i] * s; // HERE
    y[i] = a * a;
  }
""", "`a` is a const local: the adjoint would read it unset"),
    "const integer local": ("""
  int i;

  for (i = 0; i < t->n; ++i) {
    const int k = t->parent[i]; // HERE
    y[i] = X[k][0] * s;
  }
""", "`k` is a const local: the adjoint would read it unset"),
    "static local": ("""
  static double count; // HERE

  count = q[0];
  y[0] = count;
""", "`count` is static: it keeps a value between calls"),
    "global variable read": ("""
  y[0] = scale * q[0]; // HERE
""", "`scale` is a variable outside of functions", "static double scale = 2.0;\n"),
    "global variable written": ("""
  last = q[0]; // HERE
  y[0] = q[0];
""", "`last` is a variable outside of functions", "double last;\n"),
    "variable length": ("""
  int i;
  double a[t->n]; // HERE

  for (i = 0; i < t->n; ++i) a[i] = q[i];
  for (i = 0; i < t->n; ++i) y[i] = a[i] * s;
""", "`a` is a local array of variable length"),
    "float": ("""
  float a; // HERE

  a = q[0];
  y[0] = a * s;
""", "`a` is a local float"),
    "struct by value": ("""
  pair a; // HERE

  a.x = q[0];
  y[0] = a.x;
""", "`a` is a local pair", "typedef struct pair { double x, y; } pair;\n"),
    "struct argument by value": ("""
  y[0] = sum(m) * q[0];
""", "`a` is passed by value and is neither int nor double (pair)", """
typedef struct pair { double x, y; } pair;

static const pair m = {1.0, 2.0};

static double sum(pair a) // HERE
{
  return a.x + a.y;
}
"""),
    "member of type double": ("""
  y[0] = q[0] * m.x; // HERE
""", "a member of a structure", "typedef struct pair { double x, y; } pair;\n"
     "static const pair m = {1.0, 2.0};\n"),
    "union": ("""
  union { double x; int i; } u; // HERE

  u.x = q[0];
  y[0] = u.x;
""", "`u` is a local union"),
    "variable number of arguments": ("""
  y[0] = total(2, q[0], s);
""", "a variable number of arguments", """
static double total(int n, ...) // HERE
{
  return n;
}
"""),
    "float argument": ("""
  y[0] = half(q[0]);
""", "`x` is passed by value and is neither int nor double (float)", """
static double half(float x) // HERE
{
  return 0.5 * x;
}
"""),
    "float value": ("""
  y[0] = half(q[0]);
""", "`half` returns neither double nor int nor void", """
static float half(double x) // HERE
{
  return 0.5 * x;
}
"""),
    "argument overwritten": ("""
  s = sin(s); // HERE
  y[0] = s * q[0];
""", "the parameter `s` is overwritten"),

    # expressions
    "index with a side effect": ("""
  int i;

  i = 0;
  y[i++] = q[0]; // HERE
""", "a side effect in an expression (++)"),
    "assignment in an expression": ("""
  double a, b;

  a = b = q[0]; // HERE
  y[0] = a * b;
""", "a side effect in an expression (an assignment)"),
    "comma": ("""
  double a;

  a = (s, q[0]); // HERE
  y[0] = a;
""", "the comma operator"),
    "statement with a comma": ("""
  y[0] = q[0], y[1] = q[1]; // HERE
""", "the comma operator"),
    "active value as an integer": ("""
  int k;

  k = (int)q[0]; // HERE
  y[0] = p[k] * s;
""", "an active value is converted to int"),
    "active value assigned to an integer": ("""
  int k;

  k = q[0]; // HERE
  y[0] = p[k] * s;
""", "`k` is an int and gets an active value"),
    "active value as an index": ("""
  y[0] = p[(int)q[0]] * s; // HERE
""", "an active value is converted to int"),
    "unknown function": ("""
  y[0] = mystery(q[0]); // HERE
""", UNKNOWN_REASON.format("mystery"), "double mystery(double x);\n"),
    "unknown function without value": ("""
  mystery(q, y); // HERE
""", UNKNOWN_REASON.format("mystery"),
     "void mystery(const double a[3], double r[3]);\n"),

    # writing twice
    "written again": ("""
  y[0] = q[0];
  y[1] = q[1];
  y[0] = q[0] * s; // HERE
""", "an element of `y` is written again, first in line {first}"),
    "written again from itself": ("""
  int i;

  for (i = 0; i < t->n; ++i) {
    y[i] = q[i];
    y[i] = y[i] * s; // HERE
  }
""", "an element of `y` is written again, first in line {first}"),
    "written after it was added to": ("""
  int i;

  for (i = 0; i < t->n; ++i) {
    y[i] += q[i];
    y[i] = q[i] * s; // HERE
  }
""", "an element of `y` is written again, first in line {first}"),
    "written in each pass": ("""
  int i;

  for (i = 0; i < t->n; ++i) y[0] = q[i]; // HERE
""", "an element of `y` is written in each pass of the loop over `i`"),
    "written in each pass of the outer loop": ("""
  int i, k;

  for (i = 0; i < t->n; ++i)
    for (k = 0; k < 3; ++k) Y[0][k] = X[i][k]; // HERE
""", "an element of `Y` is written in each pass of the loop over `i`"),
    "multiplied": ("""
  int i;

  for (i = 0; i < t->n; ++i) {
    y[i] = q[i];
    y[i] *= s; // HERE
  }
""", "`y` is overwritten: *= on an array element"),
    "divided": ("""
  int i;

  for (i = 0; i < t->n; ++i) {
    y[i] = q[i];
    y[i] /= s; // HERE
  }
""", "`y` is overwritten: /= on an array element"),
    "read before it is complete": ("""
  int i;

  for (i = 0; i < t->n; ++i) {
    y[i] = q[i] * s;
    Y[i][0] = y[i] * y[i];
    y[i] += q[i]; // HERE
  }
""", "an element of `y` changes after its value was used in line {before}"),
}


def write(folder, body, before=""):
    kernel = HEADER.replace("} topo;\n", "} topo;\n\n" + (HEAD % "").split("\n{")[0].strip() + ";\n")
    text = '#include "kernel.h"\n' + before + HEAD % body
    (folder / "kernel.h").write_text(kernel, encoding="utf-8")
    (folder / "a.c").write_text(text, encoding="utf-8")
    return text


def refusal(folder, body, before="", outputs=None):
    text = write(folder, body, before)
    outputs = outputs or [name for name in "yY" if re.search(rf"\b{name}\b", body)]
    head = engine.Head("head", outputs, ["p", "q", "X", "s"], sources=["a.c"])
    with pytest.raises(engine.Refusal) as caught:
        engine.differentiate([str(folder / "a.c")], [head], [str(folder)])
    return caught.value, text.split("\n")


@pytest.mark.parametrize("name", REFUSED)
def test_refused(tmp_path, name):
    body, reason, *before = REFUSED[name]
    found, lines = refusal(tmp_path, body, *before)
    line = next(k for k, text in enumerate(lines, 1) if text.endswith("// HERE"))
    reason = reason.format(first=line - 2 if "y[1]" in body else line - 1, before=line - 1)
    assert (pathlib.Path(found.file).name, found.line, found.reason) == ("a.c", line, reason)
    assert str(found) == f"{found.file}:{line}: {reason}"


@pytest.mark.parametrize("name", REFUSED)
def test_is_c(tmp_path, name):
    """What is refused is C: the compiler takes it."""
    body, _, *before = REFUSED[name]
    write(tmp_path, body, *before)
    done = subprocess.run(["cc", "-std=gnu17", "-fsyntax-only", "-w", tmp_path / "a.c"],
                          capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("name", UNKNOWN)
def test_unknown_derivative(tmp_path, name):
    arguments = ", ".join(["q[i]", "s", "p[i]"][:ARGUMENTS.get(name, 1)])
    found, lines = refusal(tmp_path, LOOP % f"2.0 * {name}({arguments})")
    line = next(k for k, text in enumerate(lines, 1) if text.endswith("// HERE"))
    assert (found.line, found.reason) == (line, UNKNOWN_REASON.format(name))


@pytest.mark.parametrize("name", ["floor", "hypot"])
def test_unknown_derivative_of_passive_values(tmp_path, name):
    """Also where it would not matter: the subset has one list of functions."""
    found, _ = refusal(tmp_path, LOOP % f"q[i] * {name}({'1.5, 2.0' if name == 'hypot' else '1.5'})")
    assert found.reason == UNKNOWN_REASON.format(name)


PLAIN = LOOP.replace(" // HERE", "") % "q[i] * s"

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
    "a result on the way that is not listed": ("other", ["y"], ["q"], "`Y` of `other` depends on q and "
                                               "is used, but is not an output"),
}


@pytest.mark.parametrize("name", HEADS)
def test_heads(tmp_path, name):
    """A refusal of a line of heads.txt has the place that the line has."""
    function, outputs, inputs, reason = HEADS[name]
    write(tmp_path, PLAIN, """
void other(const topo *t, const double q[t->n], double y[t->n], double Y[t->n + 1][3])
{
  int i;

  for (i = 0; i < t->n; ++i) {
    Y[i][0] = q[i] * q[i];
    y[i] = Y[i][0] * 2.0;
  }
}
""")
    head = engine.Head(function, outputs, inputs, sources=["a.c"])
    head.place = ("heads.txt", 12)
    with pytest.raises(engine.Refusal) as caught:
        engine.differentiate([str(tmp_path / "a.c")], [head], [str(tmp_path)])
    assert str(caught.value) == f"heads.txt:12: {reason}"


def test_head_with_a_value(tmp_path):
    write(tmp_path, PLAIN, "double value(double x)\n{\n  return x * x;\n}\n")
    with pytest.raises(engine.Refusal) as caught:
        engine.differentiate([str(tmp_path / "a.c")], [engine.Head("value", ["x"], ["x"])],
                             [str(tmp_path)])
    assert caught.value.reason == "`value` is a head and returns a value"


def test_not_c(tmp_path):
    """What the parser does not understand has a place too."""
    write(tmp_path, "\n  y[0] = q[0] * ;\n")
    with pytest.raises(engine.Refusal) as caught:
        engine.differentiate([str(tmp_path / "a.c")], [engine.Head("head", ["y"], ["q"])],
                             [str(tmp_path)])
    assert pathlib.Path(caught.value.file).name == "a.c" and caught.value.line == 6
    assert caught.value.reason.startswith("not C as the parser knows it")


def test_no_file(tmp_path):
    with pytest.raises(engine.Refusal) as caught:
        engine.differentiate([str(tmp_path / "none.c")], [engine.Head("head", ["y"], ["q"])], [])
    assert caught.value.reason == "cannot be read: No such file or directory"


def test_no_header(tmp_path):
    (tmp_path / "a.c").write_text('#include "none.h"\nvoid head(double x[2])\n{\n}\n')
    with pytest.raises(engine.Refusal) as caught:
        engine.differentiate([str(tmp_path / "a.c")], [engine.Head("head", ["x"], ["x"])], [])
    assert caught.value.reason.startswith("preprocessor: ") and "none.h" in caught.value.reason


def test_only_what_is_reached(tmp_path):
    """Functions that no head calls may be what they like."""
    write(tmp_path, PLAIN, """
static double forever(double *x)
{
  while (*x > 0.0) *x = *x - floor(*x);
  return *x;
}

double other(double x)
{
  return forever(&x);
}
""")
    head = engine.Head("head", ["y"], ["q", "s"], sources=["a.c"])
    files = engine.differentiate([str(tmp_path / "a.c")], [head], [str(tmp_path)])
    assert set(files) == {"maggi_ad.h", "heads.c"} | {f"a_{mode}.c" for mode in harness.MODES}
