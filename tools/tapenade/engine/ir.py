"""Expressions and statements between parser and writer.

Expressions are immutable and compared by value; statements are changed in place or copied.  A field
of the structure of integers is a variable with an arrow in its name, `t->nbody`.
"""
from __future__ import annotations

from dataclasses import dataclass, field


class Refusal(Exception):
    """What the subset does not allow: file, line and reason."""

    def __init__(self, file, line, reason):
        super().__init__(f"{file}:{line}: {reason}")
        self.file, self.line, self.reason = file, line, reason


# ------------------------------------------------------------------------------------ expressions


@dataclass(frozen=True)
class Num:
    text: str


@dataclass(frozen=True)
class Var:
    name: str


@dataclass(frozen=True)
class Ref:
    """element of an array, or a row of one where a call takes rows"""

    name: str
    index: tuple


@dataclass(frozen=True)
class Un:
    op: str
    a: object


@dataclass(frozen=True)
class Bin:
    op: str
    a: object
    b: object


@dataclass(frozen=True)
class Cond:
    test: object
    a: object
    b: object


@dataclass(frozen=True)
class Call:
    name: str
    args: tuple


ZERO = Num("0.0")
ONE = Num("1.0")


def children(e):
    if isinstance(e, Ref):
        return e.index
    if isinstance(e, Un):
        return (e.a,)
    if isinstance(e, Bin):
        return (e.a, e.b)
    if isinstance(e, Cond):
        return (e.test, e.a, e.b)
    if isinstance(e, Call):
        return e.args
    return ()


def rebuild(e, f):
    """e with f applied to its children"""
    if isinstance(e, Ref):
        return Ref(e.name, tuple(f(x) for x in e.index))
    if isinstance(e, Un):
        return Un(e.op, f(e.a))
    if isinstance(e, Bin):
        return Bin(e.op, f(e.a), f(e.b))
    if isinstance(e, Cond):
        return Cond(f(e.test), f(e.a), f(e.b))
    if isinstance(e, Call):
        return Call(e.name, tuple(f(x) for x in e.args))
    return e


def walk(e):
    yield e
    for x in children(e):
        yield from walk(x)


def names(e):
    """names of all variables and arrays in e; kept with it"""
    known = e.__dict__.get("_names")
    if known is None:
        own = (e.name,) if isinstance(e, (Var, Ref)) else ()
        known = frozenset(own).union(*(names(x) for x in children(e)))
        object.__setattr__(e, "_names", known)
    return known


def number(e):
    """value of a literal, else None"""
    if isinstance(e, Num):
        try:
            return float(e.text)
        except ValueError:
            return None
    if isinstance(e, Un) and e.op == "-":
        v = number(e.a)
        return None if v is None else -v
    return None


def integer(e):
    """value of an integer literal, else None"""
    if isinstance(e, Num) and e.text.isdigit():
        return int(e.text)
    if isinstance(e, Un) and e.op == "-":
        v = integer(e.a)
        return None if v is None else -v
    return None


def int_expr(n):
    return Num(str(n)) if n >= 0 else Un("-", Num(str(-n)))


# arithmetic that leaves out zeros and ones


def is_zero(e):
    return number(e) == 0.0


def neg(a):
    if is_zero(a):
        return ZERO
    if isinstance(a, Un) and a.op == "-":
        return a.a
    if isinstance(a, Bin) and a.op in "*/":
        return Bin(a.op, neg(a.a), a.b) if isinstance(a.a, Un) else Un("-", a)
    return Un("-", a)


def add(a, b):
    if is_zero(a):
        return b
    if is_zero(b):
        return a
    if isinstance(b, Un) and b.op == "-":
        return Bin("-", a, b.a)
    return Bin("+", a, b)


def sub(a, b):
    if is_zero(b):
        return a
    if is_zero(a):
        return neg(b)
    if isinstance(b, Un) and b.op == "-":
        return Bin("+", a, b.a)
    return Bin("-", a, b)


def mul(a, b):
    if is_zero(a) or is_zero(b):
        return ZERO
    if number(a) == 1.0:
        return b
    if number(b) == 1.0:
        return a
    if isinstance(a, Un) and a.op == "-":
        return neg(mul(a.a, b))
    if isinstance(b, Un) and b.op == "-":
        return neg(mul(a, b.a))
    return Bin("*", a, b)


def div(a, b):
    if is_zero(a):
        return ZERO
    if number(b) == 1.0:
        return a
    if isinstance(a, Un) and a.op == "-":
        return neg(div(a.a, b))
    return Bin("/", a, b)


# ------------------------------------------------------------------------------------- statements


@dataclass
class Statement:
    place: tuple = ("", 0)  # file and line in the kernel
    comment: tuple = ()  # equations that stand above it


@dataclass
class Assign(Statement):
    target: object = None  # Var or Ref
    op: str = "="  # = += -=
    value: object = None
    derivative: bool = False  # runs over directions


@dataclass
class If(Statement):
    test: object = None
    then: list = field(default_factory=list)
    other: list = field(default_factory=list)


@dataclass
class For(Statement):
    """for (var = start; var OP bound; var += step)"""

    var: str = ""
    start: object = None
    op: str = "<"
    bound: object = None
    step: int = 1
    body: list = field(default_factory=list)


@dataclass
class Invoke(Statement):
    """call of a function without value, before inlining"""

    name: str = ""
    args: tuple = ()


@dataclass
class Return(Statement):
    value: object = None


@dataclass
class Stack(Statement):
    """push or pop of a local variable"""

    push: bool = True
    kind: str = "double"
    var: str = ""
    derivative: bool = False


def lists(s):
    """the statement lists inside a statement"""
    if isinstance(s, If):
        return [s.then, s.other]
    if isinstance(s, For):
        return [s.body]
    return []


def every(stmts):
    """all statements, outer ones first"""
    for s in stmts:
        yield s
        for part in lists(s):
            yield from every(part)


def own_expressions(s):
    """expressions that a statement reads itself, its inner lists apart"""
    if isinstance(s, Assign):
        yield s.value
        if isinstance(s.target, Ref):
            yield from s.target.index
    elif isinstance(s, If):
        yield s.test
    elif isinstance(s, For):
        yield s.start
        yield s.bound
    elif isinstance(s, Invoke):
        yield from s.args
    elif isinstance(s, Return):
        yield s.value


def reads(s):
    """names that a statement reads itself; a pushed variable is read"""
    found = set()
    for e in own_expressions(s):
        found |= names(e)
    if isinstance(s, Assign) and s.op != "=":
        found.add(s.target.name)
    if isinstance(s, Stack) and s.push:
        found.add(s.var)
    return found


def read_first(stmts):
    """(names that may be read before they are written, names that are written for sure)"""
    exposed, written = set(), set()
    for s in stmts:
        exposed |= reads(s) - written
        if isinstance(s, If):
            one, two = read_first(s.then), read_first(s.other)
            exposed |= (one[0] | two[0]) - written
            written |= one[1] & two[1]
        elif isinstance(s, For):
            exposed |= read_first(s.body)[0] - written - {s.var}
            written.add(s.var)
        elif writes(s):
            written.add(writes(s))
    return exposed, written


def writes(s):
    if isinstance(s, Assign):
        return s.target.name
    if isinstance(s, For):
        return s.var
    if isinstance(s, Stack) and not s.push:
        return s.var
    return None


def all_reads(stmts):
    found = set()
    for s in every(stmts):
        found |= reads(s)
    return found


def all_writes(stmts):
    return {writes(s) for s in every(stmts)} - {None}


def summed_arrays(flat):
    """arrays whose elements change after they are first written"""
    return {s.target.name for s in every(flat.body) if isinstance(s, Assign)
            and isinstance(s.target, Ref) and (s.op != "=" or flat.is_local(s.target.name))}


def copy_statements(stmts, f=lambda e: e, var=lambda v: v):
    """deep copy with f applied to every whole expression and var to names of loop variables"""
    out = []
    for s in stmts:
        if isinstance(s, Assign):
            c = Assign(s.place, s.comment, f(s.target), s.op, f(s.value), s.derivative)
        elif isinstance(s, If):
            c = If(s.place, s.comment, f(s.test), copy_statements(s.then, f, var),
                   copy_statements(s.other, f, var))
        elif isinstance(s, For):
            c = For(s.place, s.comment, var(s.var), f(s.start), s.op, f(s.bound), s.step,
                    copy_statements(s.body, f, var))
        elif isinstance(s, Invoke):
            c = Invoke(s.place, s.comment, s.name, tuple(f(a) for a in s.args))
        elif isinstance(s, Return):
            c = Return(s.place, s.comment, f(s.value))
        else:
            c = Stack(s.place, s.comment, s.push, s.kind, var(s.var), s.derivative)
        out.append(c)
    return out


# -------------------------------------------------------------------------------------- functions


@dataclass
class Parameter:
    name: str
    kind: str  # topo, int, double, array, ints
    dims: tuple = ()  # expressions
    const: bool = False
    type: str = ""  # of topo


@dataclass
class Function:
    name: str
    kind: str  # void, double, int
    params: list = None
    locals: dict = None  # name -> ("int" | "double", dims)
    body: list = None
    place: tuple = ("", 0)
    comment: tuple = ()
    static: bool = False
    text: str = ""  # as written

    def parameter(self, name):
        return next((p for p in self.params if p.name == name), None)
