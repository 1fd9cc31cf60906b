"""Every construct of the subset, in all modes: tangent, vector tangent and adjoint against the
complex step of the same C, the tangent of the adjoint against the complex step of the adjoint."""

import harness
import pytest
from functions import CONSTRUCTS, Group, define, heads

# ----------------------------------------------------------------------------- elementary functions

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
    "pow of zero": "pow({a} - {a}, i % 3 + 1) + pow({a}, i)",
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


FUNCTION_NAMES = {
    (name, place): f"f{k}_{m}"
    for k, name in enumerate(ELEMENTARY)
    for m, place in enumerate(PLACES)
}


def elementary(name, place):
    call = ELEMENTARY[name].format(a="q[i]", b="p[i]")
    if place == "of itself":
        call = ELEMENTARY[name].format(a=f"sin({call})", b="p[i]")
    local = "  double u;\n" * (place == "local")
    body = f"    {PLACES[place].format(call=call)}\n"
    return define(
        FUNCTION_NAMES[name, place],
        f"\n  int i;\n{local}\n  for (i = 0; i < t->n; ++i) {{\n{body}  }}\n",
    )


@pytest.fixture(scope="module")
def elementary_group(tmp_path_factory):
    return Group(tmp_path_factory, "".join(elementary(*key) for key in FUNCTION_NAMES))


@pytest.mark.parametrize("name", ELEMENTARY)
@pytest.mark.parametrize("place", PLACES)
def test_elementary(elementary_group, name, place):
    """A function as the value of an element or of a local, in an expression, added, of itself."""
    elementary_group.check(FUNCTION_NAMES[name, place], points=2)


# --------------------------------------------------------------------------------------- expressio

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
    text = [define(f"f{k}", body.format(x)) for k, x in enumerate(EXPRESSIONS)]
    return Group(tmp_path_factory, "".join(text))


@pytest.mark.parametrize("expression", EXPRESSIONS)
def test_expression(expression_group, expression):
    name = f"f{EXPRESSIONS.index(expression)}"
    expression_group.check(name, ranges={"c": (0.5, 1.5)})


# ---------------------------------------------------------------------------------- constructs/*.c


@pytest.fixture(scope="module")
def construct_groups(tmp_path_factory):
    flags = ("-O3", *harness.WARNINGS, "-Wno-empty-body")
    return {file: Group(tmp_path_factory, text, flags=flags) for file, text in CONSTRUCTS.items()}


@pytest.mark.parametrize(
    "file, name", [(file, head.name) for file, text in CONSTRUCTS.items() for head in heads(text)]
)
def test_construct(construct_groups, file, name):
    construct_groups[file].check(name)
