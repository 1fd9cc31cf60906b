"""Derivatives of the elementary functions.

PARTIAL[name](args, value) is the list of partial derivatives, one for each argument; `value` is the
variable that holds the function's value.  SECOND_ARGUMENT_PASSIVE: the last one is not differentiated
when it is passive.
"""
from __future__ import annotations

from .ir import Bin, Call, Cond, Num, ONE, Un, ZERO, add, div, mul, neg, number, sub


def _square(x):
    return mul(x, x)


def _two(x):
    return mul(Num("2.0"), x)


def _power(args, y):
    x, n = args
    k = number(n)
    if k is not None:
        lower = Num(repr(k - 1.0))
        first = mul(n, x) if k == 2.0 else mul(n, Call("pow", (x, lower)))
    else:
        lower = Bin("-", n, ONE)
        zero = Bin("==", n, Num("0"))  # where pow(0, -1) would not be finite
        first = Cond(zero, ZERO, mul(n, Call("pow", (x, lower))))
    return [first, mul(y, Call("log", (x,)))]


def _atan2(args, _):
    y, x = args
    r = add(_square(x), _square(y))
    return [div(x, r), neg(div(y, r))]


def _sign(x):
    return Cond(Bin("<", Call("MAGGI_RE", (x,)), Num("0.0")), Un("-", ONE), ONE)


PARTIAL = {
    "sin": lambda a, y: [Call("cos", a)],
    "cos": lambda a, y: [neg(Call("sin", a))],
    "tan": lambda a, y: [add(ONE, _square(y))],
    "asin": lambda a, y: [div(ONE, Call("sqrt", (sub(ONE, _square(a[0])),)))],
    "acos": lambda a, y: [neg(div(ONE, Call("sqrt", (sub(ONE, _square(a[0])),))))],
    "atan": lambda a, y: [div(ONE, add(ONE, _square(a[0])))],
    "atan2": _atan2,
    "sinh": lambda a, y: [Call("cosh", a)],
    "cosh": lambda a, y: [Call("sinh", a)],
    "tanh": lambda a, y: [sub(ONE, _square(y))],
    "exp": lambda a, y: [y],
    "log": lambda a, y: [div(ONE, a[0])],
    "sqrt": lambda a, y: [div(ONE, _two(y))],
    "pow": _power,
    "fabs": lambda a, y: [_sign(a[0])],
}
ELEMENTARY = set(PARTIAL)
PASSIVE_CALLS = {"MAGGI_RE", "(int)", "(double)"}
