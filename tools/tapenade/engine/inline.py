"""One head as one function: helpers inlined, short loops unrolled, small local arrays made scalars.

What is left has the parameters of the head, scalar locals (local arrays only where an index is not a
constant), assignments, ifs and loops.
"""
from __future__ import annotations

import copy
import re

from . import ir
from .ir import (Assign, Bin, Call, Cond, For, If, Invoke, Num, Ref, Refusal, Return, Un, Var,
                 integer)
from .rules import ELEMENTARY, PASSIVE_CALLS

UNROLL = 3  # longer loops stay loops, unless they index local arrays
UNROLL_LOCAL = 64


def _c_int(op, a, b):
    if op in "/%":
        if b == 0:
            return None
        q = abs(a) // abs(b) * (1 if (a < 0) == (b < 0) else -1)
        return q if op == "/" else a - q * b
    return {"+": a + b, "-": a - b, "*": a * b, "<": int(a < b), "<=": int(a <= b),
            ">": int(a > b), ">=": int(a >= b), "==": int(a == b), "!=": int(a != b),
            "&&": int(bool(a) and bool(b)), "||": int(bool(a) or bool(b)),
            "&": a & b, "|": a | b}.get(op)


def fold(e, enumerators):
    """integer constants evaluated; enumerators only where they are compared"""
    if isinstance(e, (Num, Var)):
        return e
    e = ir.rebuild(e, lambda x: fold(x, enumerators))

    def value(x):
        if isinstance(x, Var) and x.name in enumerators:
            return enumerators[x.name]
        return integer(x)

    if isinstance(e, Un) and e.op == "!":
        v = value(e.a)
        return e if v is None else ir.int_expr(int(not v))
    if isinstance(e, Cond):
        v = value(e.test)
        return e if v is None else (e.a if v else e.b)
    if not isinstance(e, Bin):
        return e
    a, b = value(e.a), value(e.b)
    if a is not None and b is not None:
        v = _c_int(e.op, a, b)
        return e if v is None else ir.int_expr(v)
    if e.op == "&&" and (a == 0 or b == 0):
        return Num("0")
    if e.op == "||" and (a or b):
        return Num("1")
    if e.op == "&&":
        return e.b if a else e.a if b else e
    if e.op == "||":
        return e.b if a == 0 else e.a if b == 0 else e
    if e.op == "*" and (a == 0 or b == 0):
        return Num("0")
    if e.op == "*" and (a == 1 or b == 1):
        return e.b if a == 1 else e.a
    if e.op in "+-" and b == 0:
        return e.a
    if e.op == "+" and a == 0:
        return e.b
    if e.op in "+-" and b is not None and isinstance(e.a, Bin) and e.a.op in "+-":
        c = integer(e.a.b)
        if c is not None:  # (x + c) + b
            n = (c if e.a.op == "+" else -c) + (b if e.op == "+" else -b)
            return e.a.a if n == 0 else Bin("+" if n > 0 else "-", e.a.a, Num(str(abs(n))))
    return e


class Flat:
    """A head after inlining."""

    def __init__(self, function):
        self.name = function.name
        self.place = function.place
        self.comment = function.comment
        self.params = function.params
        self.locals = {}  # name -> (type, dims)
        self.body = []
        self.passive_functions = {}  # name of the copy -> text
        self.tables = {}  # constants of the file -> text
        self.taken = {p.name for p in function.params} | {"nd", "nbdirs"}

    def copy(self):
        c = copy.copy(self)
        c.locals, c.taken = dict(self.locals), set(self.taken)
        c.body = ir.copy_statements(self.body)
        return c

    def is_local(self, name):
        return name in self.locals

    def is_int(self, name):
        if "->" in name:
            return True
        if name in self.locals:
            return self.locals[name][0] == "int"
        p = next((p for p in self.params if p.name == name), None)
        return p is None or p.kind in ("int", "ints", "topo")

    def is_array(self, name):
        """an array of doubles that is a parameter"""
        return any(p.name == name and p.kind == "array" for p in self.params)

    def new(self, name, kind="double", dims=()):
        name = re.sub(r"\W", "", name)

        def free(c):
            own = {c, c + "d", c + "b", c + "bd"}
            return not own & self.taken and not any(
                c == n + s for n in self.taken for s in ("d", "b", "bd"))

        name = re.sub(r"_\d+$", "", name)
        candidate, k = name, 1
        while not free(candidate):
            k += 1
            candidate = f"{name}{'_' if name[-1:].isdigit() else ''}{k}"
        self.taken.add(candidate)
        self.locals[candidate] = (kind, tuple(dims))
        return candidate


class _Scope:
    def __init__(self):
        self.scalars = {}  # name -> expression
        self.arrays = {}  # name -> (base, prefix)


class Inliner:
    def __init__(self, program):
        self.program = program

    def flatten(self, name):
        f = self.program.functions.get(name)
        f.file.convert(f)
        self.path = f.file.path
        flat = self.flat = Flat(f)
        if f.kind != "void":
            raise Refusal(*f.place, f"`{name}` is a head and returns a value")
        scope = _Scope()
        for p in f.params:
            if p.kind in ("array", "ints"):
                scope.arrays[p.name] = (p.name, ())
            elif p.kind == "double" and p.name in ir.all_writes(f.body):
                place = next(s.place for s in ir.every(f.body) if ir.writes(s) == p.name)
                raise Refusal(*place, f"the parameter `{p.name}` is overwritten")
            else:
                scope.scalars[p.name] = Var(p.name)
        self.topo = {p.name: p.name for p in f.params if p.kind == "topo"}
        self.stack = [name]
        flat.body = self.function_body(f, scope)
        self.scalarise()
        return flat

    def lookup(self, name):
        f = self.program.find(name, self.path)
        f.file.convert(f)
        return f

    # ------------------------------------------------------------------------------- functions

    def function_body(self, f, scope):
        for name, (kind, dims) in f.locals.items():
            new = self.flat.new(name, kind, dims)
            if dims:
                scope.arrays[name] = (new, ())
            else:
                scope.scalars[name] = Var(new)
        stmts = f.body
        if f.kind != "void":
            if not stmts or not isinstance(stmts[-1], Return):
                raise Refusal(*f.place, f"`{f.name}` does not end with its return")
        out = []
        for i, s in enumerate(stmts):
            if isinstance(s, Return) and i == len(stmts) - 1:
                break
            out += self.statement(s, scope)
        return out

    def call(self, name, args, scope, place, comment, out):
        """inline a call; returns the value of the function or None"""
        f = self.lookup(name)
        if name in self.stack:
            raise Refusal(*place, f"`{name}` is recursive")
        if len(args) != len(f.params):
            raise Refusal(*place, f"`{name}` takes {len(f.params)} arguments")
        inner, written = _Scope(), ir.all_writes(f.body)
        uses = {}
        for s in ir.every(f.body):
            for e in ir.own_expressions(s):
                for x in ir.walk(e):
                    if isinstance(x, Var):
                        uses[x.name] = uses.get(x.name, 0) + 1 + isinstance(s, For)
        rows, topo = [], {}
        for p, arg in zip(f.params, args):
            if p.kind in ("array", "ints"):
                base, prefix = self.row(arg, scope, place, name, p)
                inner.arrays[p.name] = (base, prefix)
                rows.append((p, base, prefix))
            elif p.kind == "topo":
                if not isinstance(arg, Var) or arg.name not in self.topo:
                    raise Refusal(*place, f"`{p.name}` of `{name}` is not the structure of integers")
                topo[p.name] = self.topo[arg.name]
                inner.scalars[p.name] = Var(self.topo[arg.name])
            else:
                value = self.expr(arg, scope, place, out)
                simple = isinstance(value, (Num, Var)) or p.kind == "int" or \
                    isinstance(value, Ref) or uses.get(p.name, 0) <= 1
                if p.name in written or not simple or self.changes(value, f):
                    new = self.flat.new(p.name, p.kind)
                    out.append(Assign(place, (), Var(new), "=", value))
                    value = Var(new)
                inner.scalars[p.name] = value
        self.check_aliases(name, rows, written, place)
        outer, path = self.topo, self.path
        self.topo, self.path = topo, f.file.path
        self.stack.append(name)
        body = self.function_body(f, inner)
        if body:
            own = f.comment if f.static else ()
            body[0].comment = comment + own + body[0].comment
        out += body
        value = None
        if f.kind != "void":
            value = self.expr(f.body[-1].value, inner, f.body[-1].place, out)
        self.stack.pop()
        self.topo, self.path = outer, path
        return value

    def changes(self, value, f):
        """whether f writes an array that the expression reads"""
        arrays = {x.name for x in ir.walk(value) if isinstance(x, Ref)}
        return bool(arrays) and any(p.kind == "array" and not p.const for p in f.params) and any(
            self.flat.is_local(a) for a in arrays)

    def row(self, arg, scope, place, name, p):
        if isinstance(arg, Var) and arg.name in scope.arrays:
            return scope.arrays[arg.name]
        if isinstance(arg, Ref) and arg.name in scope.arrays and len(p.dims) == 1:
            base, prefix = scope.arrays[arg.name]
            out = []
            index = tuple(self.expr(x, scope, place, out) for x in arg.index)
            if not out:
                return base, prefix + index
        if isinstance(arg, Var) and "->" in arg.name and p.kind == "ints":
            return self.field(arg.name), ()
        raise Refusal(*place, f"`{p.name}` of `{name}` wants an array or a row of one")

    def check_aliases(self, name, rows, written, place):
        for p, base, prefix in rows:
            if p.const or p.name not in written and not self.passes_on(name, p.name):
                continue
            for other, base2, prefix2 in rows:
                if other is p or base != base2:
                    continue
                n = min(len(prefix), len(prefix2))
                if prefix[:n] == prefix2[:n]:
                    what = "another output" if not other.const and other.name in written \
                        else "an input"
                    raise Refusal(*place, f"output `{p.name}` of `{name}` is {what} as well: "
                                          f"`{other.name}`")

    def passes_on(self, name, param):
        return any(param in ir.names(a) for s in ir.every(self.lookup(name).body)
                   if isinstance(s, Invoke) for a in s.args)

    # ------------------------------------------------------------------------------ statements

    def statement(self, s, scope):
        out, place = [], s.place
        enum = self.program.enumerators
        if isinstance(s, Assign):
            value = fold(self.expr(s.value, scope, place, out), enum)
            target = fold(self.expr(s.target, scope, place, out), enum)
            if not isinstance(target, (Var, Ref)):
                raise Refusal(*place, "the parameter that is overwritten here has a fixed value")
            out.append(Assign(place, (), target, s.op, value))
        elif isinstance(s, If):
            test = fold(self.expr(s.test, scope, place, out), enum)
            fixed = integer(test)
            if fixed is not None:
                for x in s.then if fixed else s.other:
                    out += self.statement(x, scope)
            else:
                then = [y for x in s.then for y in self.statement(x, scope)]
                other = [y for x in s.other for y in self.statement(x, scope)]
                if then or other:
                    out.append(If(place, (), test, then, other))
        elif isinstance(s, For):
            out += self.loop(s, scope)
        elif isinstance(s, Invoke):
            if s.name in ELEMENTARY:
                raise Refusal(*place, f"the value of `{s.name}` is not used")
            if not self.program.find(s.name, self.path):
                raise Refusal(*place, self.unknown(s.name))
            self.call(s.name, s.args, scope, place, s.comment, out)
        elif isinstance(s, Return):
            raise Refusal(*place, "early return in a differentiated function")
        if out and s.comment and s.comment != out[0].comment[:len(s.comment)]:
            out[0].comment = s.comment + out[0].comment
        return out

    def loop(self, s, scope):
        out, place, enum = [], s.place, self.program.enumerators
        start = fold(self.expr(s.start, scope, place, out), enum)
        bound = fold(self.expr(s.bound, scope, place, out), enum)
        real = any(isinstance(x, (Var, Ref)) and not self.flat.is_int(x.name)
                   for e in (start, bound) for x in ir.walk(e))
        if out or real:
            raise Refusal(*place, "a loop bound that is not an expression of integers")
        a, b = integer(start), integer(bound)
        var = scope.scalars[s.var]
        if a is not None and b is not None:
            passes = list(range(a, b + {"<": 0, "<=": 1, ">": 0, ">=": -1}[s.op], s.step))
            if len(passes) <= UNROLL or \
                    (self.indexes_local(s.body, s.var, scope) and len(passes) <= UNROLL_LOCAL):
                if s.var in {x for y in ir.every(s.body) if isinstance(y, For) for x in (y.var,)}:
                    raise Refusal(*place, f"the loop variable `{s.var}` is changed in the loop")
                for k in passes:
                    scope.scalars[s.var] = ir.int_expr(k)
                    for x in s.body:
                        out += self.statement(x, scope)
                scope.scalars[s.var] = var
                for x in out:
                    x.comment = () if x is not out[0] else x.comment
                return out
        body = [y for x in s.body for y in self.statement(x, scope)]
        return [For(place, (), var.name, start, s.op, bound, s.step, body)] if body else []

    def indexes_local(self, body, var, scope):
        """whether a loop uses its variable to index an array of this function or of its caller that
        is local to the head"""
        def local(name):
            return name in scope.arrays and self.flat.is_local(scope.arrays[name][0])

        for s in ir.every(body):
            for e in ir.own_expressions(s):
                for x in ir.walk(e):
                    if isinstance(x, Ref) and local(x.name) and var in ir.names(x):
                        return True
            if isinstance(s, Assign) and isinstance(s.target, Ref) and local(s.target.name) and \
                    var in ir.names(s.target):
                return True
        return False

    # ----------------------------------------------------------------------------- expressions

    def field(self, name):
        t, member = name.split("->")
        return f"{self.topo.get(t, t)}->{member}"

    def unknown(self, name):
        return f"no derivative is known of `{name}`, which is neither in these sources nor " \
               f"elementary"

    def expr(self, e, scope, place, out):
        if isinstance(e, Num):
            return e
        if isinstance(e, Var):
            if "->" in e.name:
                return Var(self.field(e.name))
            if e.name in scope.scalars:
                return scope.scalars[e.name]
            if e.name in scope.arrays:
                return Var(scope.arrays[e.name][0])
            if e.name in self.program.own_enumerators.get(self.path, ()):
                return ir.int_expr(self.program.enumerators[e.name])
            self.keep_table(e.name)
            return e  # an enumerator or a constant
        if isinstance(e, Ref):
            index = tuple(self.expr(x, scope, place, out) for x in e.index)
            if "->" in e.name:
                return Ref(self.field(e.name), index)
            if e.name not in scope.arrays:
                self.keep_table(e.name)
                return Ref(e.name, index)
            base, prefix = scope.arrays[e.name]
            return Ref(base, prefix + index)
        if isinstance(e, Call):
            return self.value_call(e, scope, place, out)
        return fold(ir.rebuild(e, lambda x: self.expr(x, scope, place, out)),
                    self.program.enumerators)

    def keep_table(self, name):
        if (self.path, name) in self.program.tables:
            self.flat.tables[name] = self.program.tables[self.path, name]
            self.flat.taken.add(name)

    def value_call(self, e, scope, place, out):
        if e.name in ELEMENTARY or e.name in PASSIVE_CALLS:
            return Call(e.name, tuple(self.expr(a, scope, place, out) for a in e.args))
        f = self.program.find(e.name, self.path)
        if f is None:
            raise Refusal(*place, self.unknown(e.name))
        if f.kind == "int":
            f.file.convert(f)
            if not (len(f.body) == 1 and isinstance(f.body[0], Return)):
                return self.passive_call(f, e, scope, place, out)
        if f.kind == "void":
            raise Refusal(*place, f"`{e.name}` has no value")
        return self.call(e.name, e.args, scope, place, (), out)

    def passive_call(self, f, e, scope, place, out):
        """a function of integers that is called as it is, such as the search in a table"""
        if any(p.kind == "array" and not p.const for p in f.params):
            raise Refusal(*place, f"`{f.name}` returns an integer and writes an array")
        args = []
        for p, a in zip(f.params, e.args):
            if p.kind in ("array", "ints"):
                base, prefix = self.row(a, scope, place, f.name, p)
                args.append(Ref(base, prefix) if prefix else Var(base))
            else:
                args.append(self.expr(a, scope, place, out))
        return Call(self.copy(f), tuple(args))

    def copy(self, f):
        """the name of a copy in the generated file, with what it calls, unless a header declares it"""
        if f.name in self.program.declared:
            return f.name
        name = f"{f.name}_nodiff"
        if name not in self.flat.passive_functions:
            self.flat.passive_functions[name] = ""  # it may call itself
            text = f.text if f.static else "static " + f.text
            for word in sorted(set(re.findall(r"\b(\w+)\s*\(", text))):
                called = self.program.find(word, f.file.path)
                if called:
                    text = re.sub(rf"\b{word}\b(?=\s*\()", self.copy(called), text)
            del self.flat.passive_functions[name]  # behind what it calls
            self.flat.passive_functions[name] = text
        return name

    # ---------------------------------------------------------------------------- local arrays

    def scalarise(self):
        flat = self.flat
        arrays = {n for n, (k, dims) in flat.locals.items() if dims}

        def every_ref():
            for s in ir.every(flat.body):
                if isinstance(s, Assign):
                    yield from ir.walk(s.target)
                for e in ir.own_expressions(s):
                    yield from ir.walk(e)

        refs = [x for x in every_ref() if x.__class__ in (Ref, Var) and x.name in arrays]
        keep = {x.name for x in refs if isinstance(x, Var) or
                any(integer(i) is None for i in x.index)}
        named = {}

        def scalar(x):
            x = ir.rebuild(x, scalar)
            if isinstance(x, Ref) and x.name in arrays and x.name not in keep:
                if x not in named:
                    kind, dims = flat.locals[x.name]
                    i = [integer(k) for k in x.index]
                    if len(i) != len(dims) or any(not 0 <= a < n for a, n in zip(i, dims)):
                        raise Refusal(*flat.place, f"an index of `{x.name}` is out of range")
                    named[x] = Var(flat.new(x.name + "_".join(map(str, i)), kind))
                return named[x]
            return x

        flat.body = ir.copy_statements(flat.body, scalar)
        for n in arrays - keep:
            del flat.locals[n]
