"""Every construct of the subset, in all modes: tangent, vector tangent and adjoint against the complex
step of the same C, the tangent of the adjoint against the complex step of the adjoint."""

import os
import re
import shutil
import subprocess
import sys

import engine
import harness
import numpy
import pytest
from programs import HEADER, STRUCTURES

DECLARATIONS = {
    "p": "const double p[t->np]",
    "q": "const double q[t->n]",
    "X": "const double X[t->n + 1][3]",
    "s": "double s",
    "c": "const double c[t->n]",  # passive
    "y": "double y[t->n]",
    "Y": "double Y[t->n + 1][3]",
    "e": "double e[1]",
    "F": "double F[t->n + 1][3]",  # only added to
}
INPUTS, OUTPUTS, BOTH = "pqXs", "yYe", "F"
ENUM = "enum { KIND_ZERO, KIND_ONE, KIND_TWO, KIND_THREE = KIND_TWO + 1 };\n\n"


def function(name, body, helpers=""):
    """(prototype, text, head) of a function whose arguments are those of DECLARATIONS that the body
    names; its helpers get names of their own."""
    used = [x for x in DECLARATIONS
            if re.search(rf"\b{x}\b" if x == "s" else rf"\b{x}\b(\[|[,)])", body)]
    for helper in re.findall(r"^static \w+ (\w+)\(", helpers, re.M):
        body, helpers = (re.sub(rf"\b{helper}\(", f"{helper}_{name}(", x) for x in (body, helpers))
    signature = f"void {name}(const topo *t, {', '.join(DECLARATIONS[x] for x in used)})"
    head = engine.Head(name, [x for x in used if x in OUTPUTS + BOTH],
                       [x for x in used if x in INPUTS + BOTH])
    return signature + ";\n", f"{helpers}\n{signature}\n{{{body}}}\n", head


def sources(functions):
    """Files with some functions."""
    prototypes, texts, _ = zip(*functions)
    return {"kernel.h": HEADER.replace("} topo;\n", "} topo;\n\n" + ENUM + "".join(prototypes)),
            "a.c": '#include "kernel.h"\n' + "".join(texts)}


def check(library, head, points=4, ranges=None):
    seen = 0.0
    for structure in range(len(STRUCTURES)):
        for seed in range(points):
            _, J = harness.check(library.problem(head, structure), numpy.random.default_rng(seed),
                                 ranges)
            seen = max(seen, numpy.abs(J).max())
    assert seen > 0.0, "the derivative is identically zero"


def build_and_check(build, body, helpers="", points=4, ranges=None, **options):
    one = function("head", body, helpers)
    library = build(sources([one]), [one[2]], structures=STRUCTURES, **options)
    check(library, library.heads[0], points, ranges)


def generate(folder, body, helpers="", modes=harness.MODES):
    """Text of the generated files of one function, `head`."""
    one = function("head", body, helpers)
    for name, text in sources([one]).items():
        (folder / name).write_text(text, encoding="utf-8")
    one[2].modes = list(modes)
    return engine.differentiate([str(folder / "a.c")], [one[2]], [str(folder)])


class Group:
    """Functions that are compiled together; when that fails, each one is on its own."""

    def __init__(self, folders, cases, **options):
        self.folders, self.options = folders, options
        self.cases = {name: function(f"f{k}", *case) for k, (name, case) in enumerate(cases.items())}
        try:
            self.library = self.build(self.cases.values())
        except (engine.Refusal, harness.CompileError):
            self.library = None

    def build(self, functions):
        return harness.Library(self.folders.mktemp("group"), sources(functions),
                               [head for _, _, head in functions], structures=STRUCTURES,
                               **self.options)

    def check(self, name, **options):
        library = self.library or self.build([self.cases[name]])
        check(library, self.cases[name][2], **options)


# ------------------------------------------------------------------------------ elementary functions

ELEMENTARY = {
    "sin": "sin({a})",
    "cos": "cos({a})",
    "tan": "tan(0.9 * sin({a}))",
    "asin": "asin(0.9 * sin({a}))",
    "acos": "acos(0.9 * sin({a}))",
    "atan": "atan({a})",
    "atan2": "atan2({a}, 1.5 + cos({b}))",
    "atan2 left": "atan2({a}, -1.5 - cos({b}))",
    "atan2 of a passive": "atan2(c[i], 2.0 + {a})",
    "atan2 by a passive": "atan2({a}, c[i])",
    "sinh": "sinh({a})",
    "cosh": "cosh({a})",
    "tanh": "tanh({a})",
    "exp": "exp({a})",
    "log": "log(0.5 + {a} * {a})",
    "sqrt": "sqrt(0.5 + {a} * {a})",
    "fabs": "fabs({a})",
    "pow": "pow(0.5 + {a} * {a}, {b})",
    "pow two": "pow({a}, 2)",
    "pow three": "pow({a}, 3.0)",
    "pow one": "pow({a}, 1)",
    "pow zero": "pow({a}, 0) * {b}",
    "pow minus": "pow(2.0 + {a}, -2)",
    "pow half": "pow(2.0 + {a}, 0.5)",
    "pow integer": "pow({a}, t->kind[i])",
    "pow counter": "pow({a}, i + 1)",
    "pow passive exponent": "pow(2.0 + {a}, c[i])",
    "pow passive base": "pow(2.0, {a})",
}


PLACES = {
    "element": "y[i] = {call};",
    "local": "u = {call};\n    y[i] = u * u;",
    "inside": "y[i] = 1.5 - q[i] * (2.0 * {call} + p[i]) / (3.0 + {call});",
    "added": "y[i] = p[i];\n    y[i] += 0.5 * {call};\n    y[i] -= {call};",
    "first, then added to": "y[i] = {call};\n    y[i] += p[i] * q[i];",
    "of itself": "y[i] = {call};",
}


def elementary(name, place):
    call = ELEMENTARY[name].format(a="q[i]", b="p[i]")
    if place == "of itself":
        call = ELEMENTARY[name].format(a=f"sin({call})", b="p[i]")
    local = "  double u;\n" if place == "local" else ""
    return (f"\n  int i;\n{local}\n  for (i = 0; i < t->n; ++i) {{\n"
            f"    {PLACES[place].format(call=call)}\n  }}\n",)


@pytest.fixture(scope="module")
def elementary_group(tmp_path_factory):
    return Group(tmp_path_factory, {(name, place): elementary(name, place)
                                    for name in ELEMENTARY for place in PLACES})


@pytest.mark.parametrize("name", ELEMENTARY)
@pytest.mark.parametrize("place", PLACES)
def test_elementary(elementary_group, name, place):
    """A function as the value of an element or of a local, inside an expression, added, of itself."""
    elementary_group.check((name, place), points=2)


# --------------------------------------------------------------------------------------- expressions

EXPRESSIONS = [
    "q[i] + p[i] - s",
    "q[i] - (p[i] - s)",
    "q[i] - (p[i] + s) * q[i]",
    "-q[i]",
    "-(q[i] + p[i])",
    "-q[i] * -p[i]",
    "q[i] - -p[i]",
    "-(-q[i])",
    "+q[i] * 2",
    "q[i] * p[i] * s",
    "q[i] * (p[i] * s)",
    "(q[i] + p[i]) * (s - q[i])",
    "q[i] / (2.0 + p[i])",
    "1.0 / (2.0 + q[i])",
    "q[i] / (2.0 + p[i]) / (3.0 + s)",
    "q[i] / ((2.0 + p[i]) * (3.0 + s))",
    "q[i] / ((2.0 + p[i]) / (3.0 + s))",
    "q[i] * (p[i] / (2.0 + s))",
    "q[i] / 2",
    "q[i] / c[i]",
    "c[i] * c[i] * q[i] + c[i]",
    "2 * q[i] - 3 * p[i] * 4",
    "1e-1 * q[i] + .5 * p[i] + 2. * s",
    "(i + 1) * q[i]",
    "q[i] * (i / 2)",
    "i / 2 * q[i]",
    "q[i] * i / 2",
    "q[i] * (5 / 3) + 7 / 2 * p[i]",
    "q[i] * (t->kind[i] % 2 + 1)",
    "t->kind[i] * (t->kind[i] - 1) * q[i]",
    "(2 * i - 1) * q[i]",
    "(double)i * q[i]",
    "(double)t->kind[i] / 2 * q[i]",
    "(double)q[i] * p[i]",
    "t->kind[i] == 1 ? q[i] : p[i] * s",
    "t->kind[i] ? q[i] * q[i] : 0.0",
    "i > 0 && t->kind[i] != 2 ? q[i] : -q[i]",
    "!(i == 1) || t->kind[i] >= 1 ? q[i] * s : s",
    "MAGGI_RE(q[i]) < MAGGI_RE(p[i]) ? q[i] * q[i] : p[i] * s",
    "MAGGI_RE(q[i]) > 0.0 && MAGGI_RE(s) < 0.5 ? q[i] * s : 2.0 * q[i]",
    "MAGGI_RE(sin(q[i]) * s) >= MAGGI_RE(p[i]) ? sin(q[i]) : cos(s)",
    "1.0 + (t->kind[i] > 1 ? q[i] : s) * (MAGGI_RE(p[i]) < 0.0 ? p[i] : q[i])",
    "t->kind[i] > 1 ? (i > 1 ? q[i] : s) : MAGGI_RE(s) > 0.0 ? p[i] : p[i] * s",
    "sin(t->kind[i] > 1 ? q[i] : s)",
    "exp(sin(q[i]) * cos(p[i])) * sqrt(1.0 + exp(sin(q[i]) * cos(p[i])))",
    "q[t->perm[i]] * p[t->adr[i] + 2]",
    "p[t->adr[t->perm[i]] + i % 3] * q[t->n - 1 - i]",
    "X[t->parent[i]][2] * X[i][(i + 1) % 3] * X[t->n][0]",
    "q[i] * q[0] + q[t->perm[0]] * q[i]",
]


@pytest.fixture(scope="module")
def expression_group(tmp_path_factory):
    body = "\n  int i;\n\n  for (i = 0; i < t->n; ++i) y[i] = {};\n"
    return Group(tmp_path_factory, {x: (body.format(x),) for x in EXPRESSIONS})


@pytest.mark.parametrize("expression", EXPRESSIONS)
def test_expression(expression_group, expression):
    expression_group.check(expression, ranges={"c": (0.5, 1.5)})


# ---------------------------------------------------------------------------------------- statements

CROSS = """
static void cross(const double a[3], const double b[3], double r[3])
{
  r[0] = a[1] * b[2] - a[2] * b[1];
  r[1] = a[2] * b[0] - a[0] * b[2];
  r[2] = a[0] * b[1] - a[1] * b[0];
}
"""
DOT = """
static double dot(const double a[3], const double b[3])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
"""
ADD = """
static void add(const double a[3], double f, double r[3])
{
  int k;

  for (k = 0; k < 3; ++k) r[k] += f * a[k];
}
"""

# name -> (body, helpers)
STATEMENTS = {
    # loops
    "loop up": ("""
  int i;

  for (i = 0; i < t->n; ++i) y[i] = q[i] * q[i];
""", ""),
    "loop up to and with": ("""
  int i, k;

  for (i = 0; i <= t->n; i++)
    for (k = 0; k <= 2; k += 1) Y[i][k] = X[i][k] * X[i][2 - k];
""", ""),
    "loop down": ("""
  int i;

  y[t->n - 1] = sin(s);
  for (i = t->n - 2; i >= 0; --i) y[i] = y[i + 1] * q[i];
""", ""),
    "loop down above": ("""
  int i;

  y[0] = s;
  for (i = t->n - 1; i > 0; i--) y[i] = q[i] * q[i - 1];
""", ""),
    "loop with step": ("""
  int i;

  for (i = 0; i < t->n; i += 2) y[i] = sin(q[i]);
  for (i = t->n - 1 - t->n % 2; i >= 0; i -= 2) y[i] = cos(q[i]);
""", ""),
    "loop with large step": ("""
  int i;

  e[0] = 0.0;
  for (i = 0; i < t->np; i += 3) e[0] += p[i] * p[i];
  for (i = t->np - 1; i >= 1; i -= 4) e[0] -= p[i] * s;
""", ""),
    "loop without passes": ("""
  int i;

  e[0] = s * s;
  for (i = 2; i < 2; ++i) e[0] += q[i];
  for (i = 0; i < t->kind[1] - 2; ++i) e[0] += q[i];
""", ""),
    "counter declared in the loop": ("""
  for (int i = 0; i < t->n; ++i) {
    for (int k = 0; k < t->kind[i]; ++k) e[0] += 0.0;
    y[i] = q[i] * s;
  }
  e[0] = 2.0 * s;
""".replace("e[0] += 0.0", "(void)k"), ""),
    "bounds from another loop": ("""
  int i, k;

  e[0] = 0.0;
  for (i = 0; i < t->n; ++i)
    for (k = i; k < t->n; ++k) e[0] += q[i] * q[k];
""", ""),
    "bounds from integers": ("""
  int i, k, m;

  for (i = 0; i < t->n; ++i) y[i] = p[0];
  for (i = 0; i < t->n; ++i) {
    m = t->count[i];
    for (k = 0; k < m; ++k) y[i] += p[t->adr[i] + k] * p[k];
    for (k = t->first[i]; k < t->first[i + 1]; ++k) y[i] -= X[t->from[k]][0] * X[t->to[k]][1];
  }
""", ""),
    "sum over edges": ("""
  int k, m;

  for (m = 0; m <= t->n; ++m)
    for (k = 0; k < 3; ++k) Y[m][k] = 0.0;
  for (m = 0; m < t->ne; ++m)
    for (k = 0; k < 3; ++k) {
      Y[t->from[m]][k] += X[t->from[m]][k] * X[t->to[m]][k];
      Y[t->to[m]][k] -= X[t->from[m]][k] * s;
    }
""", ""),
    "sum over a tree": ("""
  int i, k;

  for (i = 0; i <= t->n; ++i)
    for (k = 0; k < 3; ++k) Y[i][k] = X[i][k] * X[i][k];
  for (i = 0; i < t->n; ++i)
    for (k = 0; k < 3; ++k) Y[t->parent[i]][k] += Y[i][k];
""", ""),
    "nonlinear sum over a tree": ("""
  int i, k;

  for (i = 0; i <= t->n; ++i)
    for (k = 0; k < 3; ++k) Y[i][k] = X[i][k] * X[i][k];
  for (i = 0; i < t->n; ++i)
    for (k = 0; k < 3; ++k) Y[t->parent[i]][k] += sin(Y[i][k]) * s;
""", ""),
    "recursion from the root": ("""
  int i, k;

  for (k = 0; k < 3; ++k) Y[t->n][k] = k == 0 ? s : 1.0;
  for (i = t->n - 1; i >= 0; --i)
    for (k = 0; k < 3; ++k)
      Y[i][k] = Y[t->parent[i]][k] * cos(q[i]) + Y[t->parent[i]][(k + 1) % 3] * X[i][k];
""", ""),
    "loop without braces in a branch": ("""
  int i;

  for (i = 0; i < t->n; ++i)
    if (t->kind[i] == 1)
      y[i] = q[i];
    else
      y[i] = s * q[i];
""", ""),
    "pragma": ("""
  int i;

#pragma omp simd
  for (i = 0; i < t->n; ++i) y[i] = q[i] * s;
""", ""),

    # locals
    "locals": ("""
  int i;
  double a, b, d;

  for (i = 0; i < t->n; ++i) {
    a = sin(q[i]);
    b = a * s;
    d = a * b + b;
    y[i] = d * a;
  }
""", ""),
    "locals before a loop": ("""
  int i;
  double a, b;

  a = s * s;
  b = sin(a);
  for (i = 0; i < t->n; ++i) y[i] = b * q[i] * a;
""", ""),
    "assignments to locals": ("""
  int i;
  double a, b;

  for (i = 0; i < t->n; ++i) {
    a = q[i];
    a += s;
    a -= p[i] * a;
    a *= q[i] + 1.0;
    a /= 3.0 + s;
    b = a;
    a = b * a;
    a = a + 1.0;
    a = -a;
    y[i] = a * b;
  }
""", ""),
    "local carried through a loop": ("""
  int i;
  double a;

  a = s;
  for (i = 0; i < t->n; ++i) a = a * q[i] + sin(a);
  e[0] = a * a;
""", ""),
    "carried locals that need one another": ("""
  int i;
  double a, b, d;

  a = s;
  b = 1.0;
  for (i = 0; i < t->np; ++i) {
    d = a * 0.5 + b * p[i];
    b = a * b * 0.5;
    a = sin(d) * b + 0.25 * a;
  }
  e[0] = a * b;
""", ""),
    "carried local read after the loop": ("""
  int i;
  double a;

  a = 1.0;
  for (i = 0; i < t->n; ++i) {
    y[i] = a * q[i];
    a = cos(a * q[i]);
  }
  e[0] = a * s;
""", ""),
    "carried through two loops": ("""
  int i, k;
  double a;

  a = s;
  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k) a = 0.5 * a * X[i][k] + sin(a);
    a *= cos(q[i]);
    y[i] = a;
  }
""", ""),
    "carried through loops with different ends": ("""
  int i, k;
  double a, b;

  a = s;
  for (i = 0; i < t->n; ++i) {
    b = a;
    for (k = 0; k < t->count[i]; ++k) b = b * p[k] + a * b;
    if (t->kind[i] > 0) a = sin(b);
    y[i] = a * b;
  }
""", ""),
    "sum in a local": ("""
  int i, k;
  double sum;

  for (i = 0; i < t->n; ++i) {
    sum = 0.0;
    for (k = 0; k < 3; ++k) sum += X[i][k] * X[i][k];
    y[i] = sqrt(1.0 + sum);
  }
""", ""),
    "product in a local": ("""
  int i;
  double prod;

  prod = 1.0;
  for (i = 0; i < t->n; ++i) prod *= q[i];
  e[0] = prod;
""", ""),
    "local assigned conditionally": ("""
  int i;
  double a;

  for (i = 0; i < t->n; ++i) {
    a = q[i];
    if (t->kind[i] > 1) a = a * a;
    if (MAGGI_RE(a) < MAGGI_RE(s)) a = a * s;
    y[i] = sin(a) * a;
  }
""", ""),
    "local assigned in all branches": ("""
  int i;
  double a, b;

  for (i = 0; i < t->n; ++i) {
    if (t->kind[i] == 0) {
      a = q[i];
      b = a * s;
    } else if (t->kind[i] == 1) {
      b = cos(s);
      a = b;
    } else {
      a = 1.0;
      b = q[i] * q[i];
    }
    y[i] = a * b;
  }
""", ""),
    "local of one pass kept for the next": ("""
  int i;
  double a, last;

  last = s;
  for (i = 0; i < t->n; ++i) {
    a = q[i] * last;
    y[i] = a * a;
    last = a;
  }
""", ""),
    "same local in several loops": ("""
  int i;
  double a;

  for (i = 0; i < t->n; ++i) {
    a = q[i] * q[i];
    y[i] = a * a;
  }
  e[0] = 0.0;
  for (i = 0; i < t->n; ++i) {
    a = p[i] * s;
    e[0] += a * a;
  }
  a = s;
  e[0] += a * a;
""", ""),
    "integer locals": ("""
  int i, k, up, m = 0;

  for (i = 0; i < t->n; ++i) {
    up = t->parent[i];
    k = t->adr[i] + 1;
    k += 1;
    if (t->kind[i] == 1) k = 0;
    y[i] = X[up][0] * p[k] * X[up][1];
    m = k + i;
    y[i] += p[m % t->np] * s;
  }
""", ""),
    "an integer overwritten after it was an index": ("""
  int i, k;

  for (i = 0; i < t->n; ++i) {
    k = t->adr[i];
    y[i] = p[k] * p[k];
    k = t->parent[i];
    y[i] += X[k][0] * X[k][1];
    k = 0;
  }
""", ""),
    "an integer carried through a loop": ("""
  int i, k;

  k = 0;
  for (i = 0; i < t->n; ++i) {
    y[i] = p[k] * p[k] * q[i];
    k = (k + t->kind[i] + 1) % 5;
  }
""", ""),

    # arrays
    "accumulation in elements": ("""
  int i;

  for (i = 0; i < t->n; ++i) {
    y[i] = q[i] * s;
    y[i] += s * s;
    y[i] -= q[i] * p[i] * q[i];
  }
""", ""),
    "element added to in branches": ("""
  int i;

  for (i = 0; i < t->n; ++i) {
    if (t->kind[i] > 1)
      y[i] = tanh(q[i]);
    else
      y[i] = exp(0.5 * q[i]);
    if (MAGGI_RE(q[i]) > MAGGI_RE(s)) y[i] += s * s;
    y[i] -= q[i] / (3.0 + s);
  }
""", ""),
    "elementary function, then added to": ("""
  int i;

  for (i = 0; i < t->n; ++i) {
    y[i] = tanh(q[i]);
    y[i] += sqrt(2.0 + s);
    y[i] += exp(s) * s;
  }
""", ""),
    "only added to": ("""
  int i, k;

  for (i = 0; i < t->ne; ++i)
    for (k = 0; k < 3; ++k) {
      F[t->from[i]][k] += X[t->to[i]][k] * s;
      F[t->to[i]][2 - k] -= sin(X[t->from[i]][k]);
    }
""", ""),
    "some elements stay unwritten": ("""
  int i;

  for (i = 0; i < t->n; ++i)
    if (t->kind[i] != 1) y[i] = q[i] * q[i];
""", ""),
    "elements of one array from one another": ("""
  int i;

  y[0] = sin(s);
  y[1] = y[0] * y[0] * q[0];
  y[2] = y[1] * y[0];
  for (i = 3; i < t->n; ++i) y[i] = y[i - 1] * y[i - 2];
""", ""),
    "outputs read by later outputs": ("""
  int i, k;

  for (i = 0; i < t->n; ++i) y[i] = sin(q[i]);
  for (i = 0; i < t->n; ++i)
    for (k = 0; k < 3; ++k) Y[i][k] = y[i] * X[i][k] * y[t->perm[i]];
  for (k = 0; k < 3; ++k) Y[t->n][k] = 0.0;
  e[0] = 0.0;
  for (i = 0; i < t->n; ++i) e[0] += Y[i][0] * y[i];
""", ""),
    "scatter by a permutation": ("""
  int i;

  for (i = 0; i < t->n; ++i) y[t->perm[i]] = q[i] * p[i];
""", ""),
    "local array": ("""
  int i, k;
  double w[3];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k) w[k] = X[i][k] * q[i];
    y[i] = w[0] * w[1] + w[2];
  }
""", ""),
    "local array of two dimensions": ("""
  int i, k, m;
  double w[3][2];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k)
      for (m = 0; m < 2; ++m) w[k][m] = X[i][k] * X[i + 1][m];
    y[i] = w[0][0] * w[2][1] + w[1][0] * s;
  }
""", ""),
    "local array element by element": ("""
  int i;
  double w[3];

  for (i = 0; i < t->n; ++i) {
    w[0] = q[i];
    w[1] = w[0] * s;
    w[2] = w[1] * w[0];
    y[i] = w[2] * w[1];
  }
""", ""),
    "local array that is added to": ("""
  int i, k, m;
  double w[3];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k) w[k] = 0.0;
    for (m = 0; m < t->ne; ++m)
      for (k = 0; k < 3; ++k) w[k] += X[t->from[m]][k] * q[i];
    y[i] = w[0] * w[1] * w[2];
  }
""", ""),
    "long local array": ("""
  int i, k;
  double w[12];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 12; ++k) w[k] = q[i] * (k + 1) + s;
    y[i] = 0.0;
    for (k = 0; k < 12; ++k) y[i] += w[k] * w[11 - k];
  }
""", ""),
    "local array indexed by integers": ("""
  int i, k;
  double w[4];

  for (k = 0; k < 4; ++k) w[k] = sin(s + k);
  for (i = 0; i < t->n; ++i) y[i] = w[t->kind[i]] * q[i] * w[t->kind[i]];
""", ""),
    "local array through a loop": ("""
  int i, k;
  double w[3];

  for (k = 0; k < 3; ++k) w[k] = X[0][k];
  for (i = 0; i < t->n; ++i) {
    y[i] = q[i];
    for (k = 0; k < 3; ++k) w[k] += q[i] * X[i][k];
  }
  e[0] = w[0] * w[1] * w[2];
""", ""),
    "local array written in branches": ("""
  int i, k;
  double w[3];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k)
      if (t->kind[i] > k)
        w[k] = X[i][k] * s;
      else
        w[k] = 0.5 * q[i];
    y[i] = w[0] * w[1] * w[2];
  }
""", ""),
    "local array of variable index": ("""
  int i;
  double g[5];

  for (i = 0; i < t->n; ++i) g[i] = q[i] * q[i];
  for (i = 0; i < t->n; ++i) y[i] = g[t->perm[i]] * g[i] * g[0];
""", ""),
    "local array of variable index in each pass": ("""
  int i, k;
  double g[5];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < t->n; ++k) g[k] = X[k][0] * q[i] + sin(s);
    y[i] = g[t->perm[i]] * g[0];
  }
""", ""),
    "local array of variable index, each from the one before": ("""
  int i;
  double g[5];

  g[0] = s;
  for (i = 1; i < t->n; ++i) g[i] = sin(g[i - 1]) * q[i];
  for (i = 0; i < t->n; ++i) y[i] = g[i] * g[i];
""", ""),
    "local rows": ("""
  int i;
  double G[5][3];

  for (i = t->n; i >= 0; --i) {
    if (i == t->n)
      cross(X[0], X[1], G[i]);
    else
      cross(G[t->parent[i]], X[i], G[i]);
  }
  for (i = 0; i < t->n; ++i) y[i] = dot(G[i], X[t->perm[i]]) + G[i][0] * G[i][1];
""", CROSS + DOT),
    "local array of variable index added to after it was read": ("""
  int i;
  double g[5];

  for (i = 0; i < t->n; ++i) g[i] = q[i];
  for (i = 0; i < t->n; ++i) {
    y[i] = g[i] * g[i];
    g[t->perm[i]] += s * q[i];
  }
""", ""),
    "local array of variable index written again": ("""
  int i;
  double g[5];

  for (i = 0; i < t->n; ++i) g[i] = q[i] * s;
  for (i = 0; i < t->n; ++i) y[i] = g[i] * g[i];
  for (i = 0; i < t->n; ++i) g[i] = sin(q[i]);
  e[0] = 0.0;
  for (i = 0; i < t->n; ++i) e[0] += g[i] * g[i];
""", ""),
    "local array of variable index carried": ("""
  int i, k;
  double g[5];

  for (k = 0; k < t->n; ++k) g[k] = q[k];
  for (i = 0; i < t->n; ++i) {
    y[i] = g[i] * g[0];
    for (k = 0; k < t->n; ++k) g[k] = 0.5 * g[k] * g[k] + X[i][0];
  }
""", ""),
    "passive local array": ("""
  int i, k;
  double w[3];

  for (k = 0; k < 3; ++k) w[k] = k == 1 ? 2.0 : 0.5 * c[k];
  for (i = 0; i < t->n; ++i) y[i] = w[0] * q[i] + w[1] * q[i] * q[i] + w[2];
""", ""),
    "local array reused": ("""
  int i, k;
  double w[3];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k) w[k] = X[i][k] * q[i];
    y[i] = w[0] * w[1] * w[2];
  }
  e[0] = 0.0;
  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k) w[k] = X[i][k] * s;
    e[0] += w[0] * w[1] * w[2];
  }
""", ""),

    # branches
    "if on integers": ("""
  int i;

  for (i = 0; i < t->n; ++i) {
    if (t->kind[i] == 0) {
      y[i] = q[i] * s;
    } else if (t->kind[i] == 1 || i == 0) {
      y[i] = q[i] * q[i];
    } else {
      y[i] = sin(q[i]);
    }
  }
""", ""),
    "if on active values": ("""
  int i;

  for (i = 0; i < t->n; ++i) {
    if (MAGGI_RE(q[i]) < MAGGI_RE(p[i]))
      y[i] = q[i] * s;
    else if (MAGGI_RE(q[i] * s) <= 0.25)
      y[i] = q[i] * q[i];
    else
      y[i] = s;
  }
""", ""),
    "if on a local that changes": ("""
  int i;
  double a;

  for (i = 0; i < t->n; ++i) {
    a = q[i];
    if (MAGGI_RE(a) > 0.0) a = -2.0 * a * a;
    if (MAGGI_RE(a) > -1.0) a = a * s;
    y[i] = a;
  }
""", ""),
    "if on a local array": ("""
  int i, k;
  double w[3];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k) w[k] = X[i][k];
    if (MAGGI_RE(w[0]) < MAGGI_RE(w[1])) w[2] += w[0] * w[1];
    y[i] = w[2] * w[0];
  }
""", ""),
    "if on an integer that changes": ("""
  int i, k;

  for (i = 0; i < t->n; ++i) {
    k = t->kind[i];
    if (k > 1) {
      k = 0;
      y[i] = q[i] * q[i];
    } else {
      y[i] = s;
    }
    if (k == 0) y[i] += q[i] * s;
  }
""", ""),
    "loop in a branch in a loop": ("""
  int i, k;
  double a;

  for (i = 0; i < t->n; ++i) {
    a = s;
    if (t->kind[i] > 0) {
      for (k = 0; k < t->kind[i]; ++k) a = sin(a) * q[i];
    } else {
      a *= q[i];
    }
    y[i] = a;
  }
""", ""),
    "empty branch": ("""
  int i;

  for (i = 0; i < t->n; ++i) {
    y[i] = q[i];
    if (t->kind[i] == 0) {
    } else {
      y[i] += s * s;
    }
    if (t->kind[i] == 1) ;
  }
""", ""),
    "switch": ("""
  int i;

  for (i = 0; i < t->n; ++i) {
    switch (t->kind[i]) {
    case 0:
      y[i] = q[i] * s;
      break;
    case 1:
      y[i] = sin(q[i]);
      break;
    default:
      y[i] = s;
      break;
    }
  }
""", ""),
    "switch on enumerators": ("""
  int i;
  double a;

  for (i = 0; i < t->n; ++i) {
    a = q[i];
    switch (t->kind[i]) {
    case KIND_ONE:
    case KIND_TWO: {
      a = a * a;
      break;
    }
    case KIND_THREE:
      a *= s;
      break;
    }
    if (t->kind[i] == KIND_ZERO) a = sin(a);
    y[i] = a;
  }
""", ""),

    "enumerators of the file": ("""
  int i;

  for (i = 0; i < t->n; ++i) {
    if (t->kind[i] == HERE_TWO)
      y[i] = q[i] * q[HERE_ONE];
    else
      y[i] = s * HERE_TWO;
  }
""", "enum { HERE_ZERO, HERE_ONE, HERE_TWO };"),
    "constants of the file": ("""
  int i;

  for (i = 0; i < t->n; ++i) y[i] = q[i] * weight[i % 3] + s * third + q[next[i % 3]];
""", """
static const double weight[3] = {0.5, 0.25, 0.125};
static const double third = 1.0 / 3.0;
static const int next[3] = {1, 2, 0};
"""),
    "macros": ("""
  int i;

  for (i = 0; i < t->n; ++i) y[i] = SQUARE(q[i]) * HALF + s;
""", """
#define HALF 0.5
#define SQUARE(x) ((x) * (x))
"""),

    # calls
    "value of a helper": ("""
  int i;

  for (i = 0; i < t->n; ++i) y[i] = square(q[i]) * square(s + p[i]) + square(2.0);
""", """
static double square(double a)
{
  return a * a;
}
"""),
    "helper of helpers": ("""
  int i;

  for (i = 0; i < t->n; ++i) y[i] = twice(square(q[i]), i) - twice(s, 1);
""", """
static double square(double a)
{
  return a * a;
}

static double twice(double a, int k)
{
  double b, d;

  b = square(a);
  d = b;
  if (k > 0) d = square(b) * a;
  return 2.0 * d + b;
}
"""),
    "helper with branches": ("""
  int i;

  for (i = 0; i < t->n; ++i) y[i] = slopes(p[0], p[1], p[2] * p[2], s, q[i]);
""", """
static double slopes(double c1, double c2, double v1, double v2, double v)
{
  double f;

  if (MAGGI_RE(v) > MAGGI_RE(v1))
    f = c1 * v1 + c2 * (v - v1);
  else if (MAGGI_RE(v) > 0.0)
    f = c1 * v;
  else if (MAGGI_RE(v) > MAGGI_RE(v2))
    f = c2 * v;
  else
    f = c2 * v2 + c1 * (v - v2);
  return f;
}
"""),
    "rows as arguments": ("""
  int i;

  for (i = 0; i < t->n; ++i) cross(X[i], X[t->parent[i]], Y[i]);
""", CROSS),
    "rows of one array in and out": ("""
  int i, k;

  for (k = 0; k < 3; ++k) Y[t->n][k] = X[t->n][k];
  for (i = t->n - 1; i >= 0; --i) cross(Y[t->parent[i]], X[i], Y[i]);
""", CROSS),
    "one array twice as an argument": ("""
  int i, k;
  double w[3];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k) w[k] = X[i][k] * s;
    y[i] = dot(w, w) + dot(X[i], X[i]);
  }
""", DOT),
    "two rows that may be one": ("""
  int i;

  for (i = 0; i < t->n; ++i) {
    y[i] = dot(X[t->from[i]], X[t->to[i]]) + dot(X[0], X[i]);
    cross(X[t->perm[i]], X[i], Y[i]);
  }
""", DOT + CROSS),
    "local arrays as arguments": ("""
  int i, k;
  double a[3], b[3], r[3];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k) {
      a[k] = X[i][k] * s;
      b[k] = sin(X[i][k]);
    }
    cross(a, b, r);
    y[i] = dot(r, X[t->n]) + dot(b, a) * dot(r, r);
  }
""", CROSS + DOT),
    "local array written by a call in each pass": ("""
  int i;
  double r[3], u[3];

  for (i = 0; i < t->n; ++i) {
    cross(X[i], X[t->parent[i]], r);
    cross(r, X[t->n], u);
    y[i] = dot(u, X[t->parent[i]]) * dot(r, r);
  }
""", CROSS + DOT),
    "output that a helper adds to": ("""
  int m;

  for (m = 0; m < t->ne; ++m) {
    add(X[t->from[m]], s, F[t->to[m]]);
    add(X[t->to[m]], -s * s, F[t->from[m]]);
  }
""", ADD),
    "local array that a helper adds to": ("""
  int i, k;
  double w[3];

  for (i = 0; i < t->n; ++i) {
    for (k = 0; k < 3; ++k) w[k] = X[i][k];
    add(X[t->parent[i]], q[i], w);
    add(X[t->n], s, w);
    y[i] = w[0] * w[1] * w[2];
  }
""", ADD),
    "arrays and their length as arguments": ("""
  int i;

  for (i = 0; i < t->n; ++i) {
    fetch(t->np, p, t->adr[i], Y[i]);
    y[i] = horner(t->np, p, t->count[i] + 1, q[i]);
  }
""", """
static void fetch(int n, const double a[n], int adr, double r[3])
{
  r[0] = a[adr] * a[adr];
  r[1] = a[adr + 1];
  r[2] = a[adr + 2] * r[1];
}

static double horner(int n, const double a[n], int m, double x)
{
  int k;
  double f;

  f = a[0];
  for (k = 1; k < m; ++k) f = f * x + a[k];
  return f;
}
"""),
    "whole arrays of two dimensions as arguments": ("""
  int i;

  for (i = t->n; i >= 0; --i) row(t, i, X, Y);
""", """
static void row(const topo *t, int i, const double A[t->n + 1][3], double B[t->n + 1][3])
{
  int k;

  for (k = 0; k < 3; ++k) {
    if (i == t->n)
      B[i][k] = A[i][k];
    else
      B[i][k] = B[t->parent[i]][k] * A[i][(k + 1) % 3];
  }
}
"""),
    "outputs at an index": ("""
  int i;

  for (i = 0; i < t->n; ++i) put(i, t->n, X[i], q[i], y);
""", """
static void put(int at, int n, const double a[3], double x, double r[n])
{
  if (at % 2 == 0)
    r[at] = a[0] * x;
  else
    r[at] = a[1] / (2.0 + x);
}
"""),
    "integer helper": ("""
  int i, k;

  for (i = 0; i < t->n; ++i) {
    k = piece(t->np, p, q[i]);
    if (k < 0) k = 0;
    y[i] = p[k] * q[i] * p[k] + rows(t->kind[i]) * s;
  }
""", """
static int rows(int kind)
{
  return kind == 1 || kind == 2 ? 3 : 1;
}

static int piece(int n, const double a[n], double x)
{
  int k;

  for (k = 0; k < n; ++k)
    if (MAGGI_RE(x) < MAGGI_RE(a[k])) return k;
  return n - 1;
}
"""),
    "one helper, active and passive": ("""
  int i;

  for (i = 0; i < t->n; ++i) y[i] = mix(c[i], q[i]) + mix(q[i], c[i]) + mix(c[i], c[0]) + mix(s, s);
""", """
static double mix(double a, double b)
{
  double d;

  d = a * b;
  return sin(d) * a + b;
}
"""),
    "expressions as arguments": ("""
  int i;

  for (i = 0; i < t->n; ++i) y[i] = mix(q[i] * s + 1.0, t->kind[i] > 1 ? q[i] : sin(s), i + 1);
""", """
static double mix(double a, double b, int k)
{
  return a * b / k + a * a;
}
"""),
    "a call in a condition": ("""
  int i;

  for (i = 0; i < t->n; ++i) {
    if (MAGGI_RE(dot(X[i], X[t->n])) < MAGGI_RE(s))
      y[i] = dot(X[i], X[i]);
    else
      y[i] = s * q[i];
  }
""", DOT),
    "names that a derivative could take": ("""
  int i;
  double qd, yb, qb0, a, ad, sd, t1, inv;

  for (i = 0; i < t->n; ++i) {
    qd = q[i] * q[i];
    yb = qd * s;
    qb0 = sin(yb);
    a = qb0 * qd;
    ad = a / (2.0 + qd * qd);
    sd = ad * a;
    t1 = sd * sd;
    inv = tanh(t1);
    y[i] = inv * inv + ad;
  }
""", ""),
}


@pytest.fixture(scope="module")
def statement_group(tmp_path_factory):
    return Group(tmp_path_factory, STATEMENTS,
                 flags=("-O3", "-Wall", "-Wextra", "-Werror", "-Wno-empty-body"))


@pytest.mark.parametrize("name", STATEMENTS)
def test_statement(statement_group, name):
    statement_group.check(name)


def test_plain_comparison(build, tmp_path):
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
    plain = re.sub(r"LESS\((.*?), (.*?)\)", r"\1 < \2", body)
    real = re.sub(r"LESS\((.*?), (.*?)\)", r"MAGGI_RE(\1) < MAGGI_RE(\2)", body)
    texts = [{file: re.sub(r"MAGGI_RE\(([^()]*)\)", r"\1", content)
              for file, content in generate(tmp_path, text).items()} for text in (plain, real)]
    assert texts[0] == texts[1]
    build_and_check(build, real)


@pytest.mark.parametrize("width", [1, 4, 8, 40])
def test_width(build, width):
    """The number of directions is a compile definition."""
    body, helpers = STATEMENTS["local arrays as arguments"]
    build_and_check(build, body, helpers, points=1, width=width, modes=("d", "dv"))


@pytest.mark.parametrize("compiler", ["gcc", "clang"])
@pytest.mark.parametrize("flags", [["-O0"], ["-O3", "-march=native"]])
def test_compilers(build, monkeypatch, compiler, flags):
    """Without a warning, and right, whatever the compiler makes of restrict and simd."""
    if not shutil.which(compiler):
        pytest.skip(f"no {compiler}")
    monkeypatch.setenv("CC", compiler)
    body = """
  int i, k, m;
  double a, r[3], w[3];

  for (i = 0; i < t->n; ++i) {
    cross(X[t->perm[i]], X[i], r);
    for (k = 0; k < 3; ++k) w[k] = r[k] * q[i];
    add(r, s, w);
    a = s;
    for (m = t->first[i]; m < t->first[i + 1]; ++m) a = 0.5 * a * dot(X[t->from[m]], w) + sin(a);
    if (MAGGI_RE(a) < MAGGI_RE(s)) a = tanh(a * a);
    y[i] = a + dot(w, w) / (2.0 + s);
    add(w, a, F[t->parent[i]]);
  }
"""
    if compiler == "clang":  # it may say that it did not vectorise
        flags = [*flags, "-Wno-pass-failed"]
    build_and_check(build, body, CROSS + DOT + ADD, points=2,
                    flags=(*flags, "-Wall", "-Wextra", "-Werror"))


@pytest.mark.parametrize("names", ["q", "s", "X", "Xs", "qXs"])
def test_active_inputs(build, names):
    """The same function with each set of inputs: what is not listed has no companion."""
    one = function("head", """
  int i;
  double a, b;

  for (i = 0; i < t->n; ++i) {
    a = q[i] * s;
    b = X[i][0] * X[i][1] + sin(s);
    y[i] = a * b + q[i] * X[t->parent[i]][2];
  }
""")
    one[2].inputs = list(names)
    library = build(sources([one]), [one[2]], structures=STRUCTURES)
    harness.check(library.problem(one[2]), numpy.random.default_rng(0))


def test_two_files(build):
    """Heads in two files, helpers in a third, shared."""
    kernel = HEADER.replace("} topo;\n", """} topo;

double dot(const double a[3], const double b[3]);
void cross(const double a[3], const double b[3], double r[3]);
void first(const topo *t, const double X[t->n + 1][3], double y[t->n]);
void second(const topo *t, int begin, int end, const double X[t->n + 1][3],
            const double y[t->n], double Y[t->n + 1][3]);
void third(const topo *t, const double X[t->n + 1][3], double s, double e[1]);
""")
    files = {
        "kernel.h": kernel,
        "vec.c": '#include "kernel.h"\n' + DOT.replace("static ", "") + CROSS.replace("static ", ""),
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
    heads = [engine.Head("first", ["y"], ["X"]), engine.Head("third", ["e"], ["X", "s"]),
             engine.Head("second", ["Y"], ["X", "y"],
                         integers={"begin": "1", "end": "t->n"})]
    library = build(files, heads, structures=STRUCTURES)
    for head in heads:
        for structure in (0, 1):
            harness.check(library.problem(head, structure), numpy.random.default_rng(1))
    assert set(library.files) == {"maggi_ad.h", "heads.c"} | {
        f"{name}_{mode}.c" for name in "ab" for mode in harness.MODES}


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
    library = build({"kernel.h": kernel, "a.c": text}, [head], structure="plan",
                    structures=["{3, 2, (int[]){0, 1, 1}, {1, 1, 0, 0}}"])
    harness.check(library.problem(head), numpy.random.default_rng(0))


def test_no_structure(build):
    """A head may do without."""
    kernel = "#pragma once\n#include <math.h>\n\nvoid head(int n, const double x[n], double z[n]);\n"
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


@pytest.mark.parametrize("modes", [["d"], ["b"], ["d", "dv"], ["b", "b_d"]])
def test_modes(tmp_path, modes):
    """Only what is asked for is generated."""
    files = generate(tmp_path, *STATEMENTS["if on active values"], modes)
    assert set(files) == {"maggi_ad.h", "heads.c", *(f"a_{mode}.c" for mode in modes)}
    assert set(re.findall(r"\bhead_(\w+)\(", files["maggi_ad.h"])) == set(modes)


def test_same_text_again(tmp_path):
    """The text does not depend on the order in sets: two processes write the same."""
    script = ("import sys, pathlib; sys.path[:0] = sys.argv[1].split(':'); import test_constructs\n"
              "case = test_constructs.STATEMENTS['local arrays as arguments']\n"
              "print(test_constructs.generate(pathlib.Path(sys.argv[2]), *case))")
    path = f"{harness.HERE}:{harness.ROOT / 'tools' / 'tapenade'}"
    texts = {subprocess.run([sys.executable, "-c", script, path, tmp_path], check=True,
                            capture_output=True, text=True,
                            env={**os.environ, "PYTHONHASHSEED": str(seed)}).stdout
             for seed in range(4)}
    assert len(texts) == 1 and "head_b_d" in texts.pop()


def test_signatures(tmp_path):
    """The declarations that tools/tapenade/README.md promises."""
    (tmp_path / "kernel.h").write_text(HEADER)
    (tmp_path / "a.c").write_text("""#include "kernel.h"

void f(const topo *t, int begin, const double x[t->n][3], double s, const double c[3],
       double y[t->n + 1])
{
  int i;

  for (i = begin; i < t->n; ++i) y[i] = x[i][0] * x[i][1] * s * c[0];
}
""")
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
    generated = generate(tmp_path, """
  int i;
  double a;

  for (i = 0; i < t->n; ++i) {
    /* a = q^2 s,  [1] 3.7 */
    a = q[i] * q[i] * s;
    y[i] = sin(a);
  }
""")
    for mode in harness.MODES:
        assert "/* a = q^2 s,  [1] 3.7 */" in generated[f"a_{mode}.c"], mode


def test_nothing_is_recomputed(tmp_path):
    """The workspace is the tape: results are read from it, and nothing is pushed for them."""
    generated = generate(tmp_path, """
  int i;

  for (i = 0; i < t->n; ++i) y[i] = sin(q[i]);
  for (i = 0; i < t->n; ++i) Y[i][0] = y[i] * y[i] * s;
""")
    for mode in ("d", "dv", "b"):
        text = generated[f"a_{mode}.c"]
        assert "sin(" not in text, f"{mode} recomputes sin"
        assert "push" not in text
