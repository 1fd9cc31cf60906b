"""What both sweeps want: activity, elementary operations in statements of their own, locals that are
assigned once, array elements read once.  And the checks that only the whole head allows."""
from __future__ import annotations

import re

from . import ir
from .ir import Assign, Bin, Call, Cond, For, If, Num, Ref, Refusal, Un, Var
from .rules import ELEMENTARY

COMPARE = {"<", "<=", ">", ">=", "==", "!=", "&&", "||", "%"}


def value_names(e):
    """names on whose values e depends continuously: not indices, comparisons, integers"""
    if isinstance(e, Var):
        return {e.name}
    if isinstance(e, Ref):
        return {e.name}
    if isinstance(e, Cond):
        return value_names(e.a) | value_names(e.b)
    if isinstance(e, Call):
        if e.name not in ELEMENTARY and e.name != "(double)":
            return set()
        return set().union(*(value_names(a) for a in e.args))
    if isinstance(e, Bin) and e.op in COMPARE or isinstance(e, Un) and e.op == "!":
        return set()
    return set().union(set(), *(value_names(x) for x in ir.children(e)))


def depending(flat, inputs):
    """names whose values depend on the inputs"""
    varied = set(inputs)
    while True:
        n = len(varied)
        for s in ir.every(flat.body):
            if isinstance(s, Assign) and not flat.is_int(s.target.name) and \
                    value_names(s.value) & varied:
                varied.add(s.target.name)
        if len(varied) == n:
            return varied


def activity(flat, inputs, outputs):
    """names that depend on inputs and on which outputs depend"""
    varied, useful = depending(flat, inputs), set(outputs)
    while True:
        n = len(useful)
        for s in ir.every(flat.body):
            if isinstance(s, Assign) and s.target.name in useful:
                useful |= value_names(s.value)
        if len(useful) == n:
            return {x for x in varied & useful if not flat.is_int(x)}


def mentions(s, x):
    return any(x in ir.reads(y) or ir.writes(y) == x for y in ir.every([s]))


def rename(stmts, old, new):
    """in place"""
    def f(e):
        if isinstance(e, Var):
            return Var(new) if e.name == old else e
        return ir.rebuild(e, f)

    for s in ir.every(stmts):
        if isinstance(s, Assign):
            s.target, s.value = f(s.target), f(s.value)
        elif isinstance(s, If):
            s.test = f(s.test)
        elif isinstance(s, For):
            s.var = new if s.var == old else s.var
            s.start, s.bound = f(s.start), f(s.bound)


# ---------------------------------------------------------------------------------------- checks


def check(flat, program):
    """single assignment of array elements, and integers that do not depend on active values"""
    _check_list(flat, flat.body, [], {})
    assigned = {s.target.name for s in ir.every(flat.body) if isinstance(s, Assign)}
    counters = {s.var for s in ir.every(flat.body) if isinstance(s, For)} - assigned
    _check_counters(flat.body, counters)


def _check_counters(stmts, outside):
    for s in stmts:
        for x in sorted(ir.reads(s) & outside):
            raise Refusal(*s.place, f"the loop variable `{x}` is read outside of its loop")
        inner = outside - {s.var} if isinstance(s, For) else outside
        for part in ir.lists(s):
            _check_counters(part, inner)


def _text(ref):
    return repr(ref)


def _check_list(flat, stmts, loops, seen):
    for s in stmts:
        if isinstance(s, Assign) and isinstance(s.target, Ref) and flat.is_array(s.target.name):
            key = _text(s.target)
            if s.op == "=":
                if key in seen:
                    raise Refusal(*s.place, f"an element of `{s.target.name}` is written again, "
                                            f"first in line {seen[key]}")
                for loop in loops:
                    if not ir.names(Ref("", s.target.index)) & varying(loop):
                        raise Refusal(*s.place, f"an element of `{s.target.name}` is written in "
                                                f"each pass of the loop over `{loop.var}`")
            seen[key] = s.place[1]
        if isinstance(s, Assign) and not isinstance(s.target, Ref) and flat.is_int(s.target.name):
            for key in [k for k in seen if f"Var(name={s.target.name!r})" in k]:
                del seen[key]
        if isinstance(s, If):
            one, two = dict(seen), dict(seen)
            _check_list(flat, s.then, loops, one)
            _check_list(flat, s.other, loops, two)
            seen.update(one)
            seen.update(two)
        if isinstance(s, For):
            inner = {k: v for k, v in seen.items() if f"Var(name={s.var!r})" not in k}
            _check_list(flat, s.body, loops + [s], inner)
            for key, line in inner.items():
                if not any(f"Var(name={n!r})" in key for n in varying(s)):
                    seen[key] = line


def varying(loop):
    """integers that change from pass to pass"""
    found = {loop.var}
    while True:
        n = len(found)
        for s in ir.every(loop.body):
            if isinstance(s, Assign) and isinstance(s.target, Var) and \
                    ir.names(s.value) & found:
                found.add(s.target.name)
            if isinstance(s, For) and (ir.names(s.start) | ir.names(s.bound)) & found:
                found.add(s.var)
        if len(found) == n:
            return found


def check_integers(flat, inputs):
    active = depending(flat, inputs)
    for s in ir.every(flat.body):
        for e in ir.own_expressions(s):
            for x in ir.walk(e):
                if isinstance(x, Call) and x.name == "(int)" and \
                        set().union(*(value_names(a) for a in x.args)) & active:
                    raise Refusal(*s.place, "an active value is converted to int")
        if isinstance(s, Assign) and flat.is_int(s.target.name) and \
                value_names(s.value) & active:
            raise Refusal(*s.place, f"`{s.target.name}` is an int and gets an active value")


# ---------------------------------------------------------------------- assigned once, where possible


def split_webs(flat):
    """a local that is used for different things gets different names"""
    done = set()
    while True:
        new = [n for n, (_, dims) in flat.locals.items() if not dims and n not in done]
        if not new:
            return
        times = {}
        for s in ir.every(flat.body):
            times[ir.writes(s)] = times.get(ir.writes(s), 0) + 1
        for x in (n for n in new if times.get(n, 0) > 1):
            _split_branches(flat, flat.body, x)
            _split_list(flat, flat.body, x)
        done.update(new)


def _own(s, x):
    return x in ir.reads(s) or ir.writes(s) == x


def _count(stmts, x):
    return sum(_own(s, x) for s in ir.every(stmts))


def _split_branches(flat, stmts, x):
    """branches of an if that use it each for itself"""
    for s in stmts:
        for part in ir.lists(s):
            _split_branches(flat, part, x)
        if isinstance(s, If) and s.then and s.other and not _own(s, x) and \
                _count(s.then, x) and _count(s.other, x) and \
                _count([s], x) == _count(flat.body, x) and \
                x not in ir.read_first(s.then)[0] | ir.read_first(s.other)[0]:
            rename(s.other, x, flat.new(x, flat.locals[x][0]))


def _split_list(flat, stmts, x):
    """statements of a list, or parts of it that each begin with an assignment"""
    for s in stmts:
        for part in ir.lists(s):
            _split_list(flat, part, x)
    users = [i for i, s in enumerate(stmts) if mentions(s, x)]
    if len(users) < 2 or _count(stmts, x) != _count(flat.body, x) or \
            x in ir.read_first(stmts)[0]:
        return
    if all(isinstance(stmts[i], (If, For)) and not _own(stmts[i], x) and
           not any(x in ir.read_first(part)[0] for part in ir.lists(stmts[i])) for i in users):
        starts = users
    else:
        starts = [i for i in users if isinstance(stmts[i], Assign) and
                  stmts[i].target == Var(x) and stmts[i].op == "="]
        if not starts or starts[0] != users[0]:
            return
    previous = x
    for k, i in enumerate(starts[1:], 1):
        new = flat.new(x, flat.locals[x][0])
        end = starts[k + 1] if k + 1 < len(starts) else len(stmts)
        first = stmts[i]
        if isinstance(first, Assign):  # its right-hand side may read the value before
            held = Assign(value=first.value, target=Var(new))
            rename([held], x, previous)
            rename(stmts[i:end], x, new)
            first.value = held.value
        else:
            rename(stmts[i:end], x, new)
        previous = new


# ---------------------------------------------------------------- elementary operations on their own


class Normaliser:
    def __init__(self, flat, active):
        self.flat, self.active = flat, active
        self.summed = ir.summed_arrays(flat)

    def run(self):
        self.flat.body = self.block(self.flat.body)

    def is_active(self, e):
        return bool(value_names(e) & self.active)

    def block(self, stmts):
        out = []
        for s in stmts:
            if isinstance(s, If):
                s.test = self.test(s, out)
                s.then, s.other = self.block(s.then), self.block(s.other)
                out.append(s)
            elif isinstance(s, For):
                s.body = self.block(s.body)
                out.append(s)
            elif isinstance(s, Assign) and s.target.name in self.active:
                out += self.assign(s)
            else:
                out.append(s)
        return out

    def test(self, s, out):
        """a condition whose variables may change later is kept in an integer"""
        for n in sorted(ir.names(s.test)):
            if self.flat.is_local(n) and self.flat.locals[n][1] == () and self.writes_of(n) > 1:
                flag = self.flat.new("is_" + n, "int")
                out.append(Assign(s.place, (), Var(flag), "=", s.test))
                return Var(flag)
        return s.test

    def writes_of(self, n):
        return sum(ir.writes(s) == n and not isinstance(s, For) for s in ir.every(self.flat.body))

    def assign(self, s):
        out, self.place = [], s.place
        if s.op != "=" and isinstance(s.target, Var) and s.target.name in value_names(s.value):
            s = Assign(s.place, s.comment, s.target, "=", Bin(s.op[0], s.target, s.value))
        once = s.target.name not in self.summed if isinstance(s.target, Ref) else \
            self.writes_of(s.target.name) <= 1
        linear = s.op == "=" and s.target.name not in value_names(s.value)
        if s.op == "=" and not linear and not isinstance(s.target, Ref):
            # x = f(x): the new value apart, so that both are at hand
            new = self.temporary(s.target.name)
            first = Assign(s.place, (), Var(new), "=", s.value)
            out += self.assign(first)
            out.append(Assign(s.place, (), s.target, "=", Var(new)))
        else:
            value = self.expr(s.value, out, linear and once, s.target)
            if value is None:  # an if was written instead
                out[0].comment = s.comment + out[0].comment
                return out
            out.append(Assign(s.place, (), s.target, s.op, value))
        out[0].comment = s.comment
        return out

    def temporary(self, base="t"):
        new = self.flat.new(base)
        self.active.add(new)
        return new

    def hoist(self, e, out, base="t"):
        new = self.flat.new(base)
        if self.is_active(e):
            self.active.add(new)
        out.append(Assign(self.place, (), Var(new), "=", e))
        return Var(new)

    def simple(self, e, out):
        e = self.expr(e, out, False, None)
        parameter = isinstance(e, Ref) and self.flat.is_array(e.name)
        return e if parameter or isinstance(e, (Num, Var)) else self.hoist(e, out)

    def expr(self, e, out, top, target):
        """e with what is not a sum or product in variables of its own; `top`: the whole right-hand side"""
        if isinstance(e, (Num, Var, Ref)):
            return e
        if not self.is_active(e):
            calls = any(isinstance(x, Call) and x.name in ELEMENTARY for x in ir.walk(e))
            return self.hoist(e, out) if calls and not isinstance(e, Var) else e
        if isinstance(e, Cond):
            new = target if top and isinstance(target, Var) else Var(self.temporary())
            test = e.test
            then, other = [], []
            then += self.assign(Assign(self.place, (), new, "=", e.a))
            other += self.assign(Assign(self.place, (), new, "=", e.b))
            one = If(self.place, (), test, then, other)
            one.test = self.test(one, out)
            out.append(one)
            return None if new is target else new
        if isinstance(e, Call):
            if e.name == "(double)":
                return self.expr(e.args[0], out, top, target)
            args = tuple(self.simple(a, out) if self.is_active(a) else self.passive(a, out)
                         for a in e.args)
            e = Call(e.name, args)
            return e if top else self.hoist(e, out)
        if isinstance(e, Bin) and e.op == "/" and self.is_active(e.b):
            e = Bin("/", self.expr(e.a, out, False, None), self.simple(e.b, out))
            return e if top else self.hoist(e, out)
        if isinstance(e, Un) and e.op == "-":
            return Un("-", self.expr(e.a, out, False, None))
        if isinstance(e, Bin):
            return Bin(e.op, self.expr(e.a, out, False, None), self.expr(e.b, out, False, None))
        raise Refusal(*self.place, "an active value in an operation that has no derivative")

    def passive(self, e, out):
        return e if isinstance(e, (Num, Var)) else self.hoist(e, out)


# --------------------------------------------------------------------------- elements read once


def cache_reads(flat, active):
    """within a block, an element of an active array that is read more than once, or that is written
    and then read, is kept in a local"""
    flat.body = _cache_list(flat, active, flat.body)


def _name_of(ref):
    def text(e):
        if isinstance(e, Var):
            return e.name.split("->")[-1]
        if isinstance(e, Num):
            return e.text
        if isinstance(e, Ref):
            return "".join(text(i) for i in e.index)
        return "".join(text(x) for x in ir.children(e))

    parts = [re.sub(r"\W", "", text(i)) for i in ref.index]
    name = ref.name + "_" + "".join(p if len(p) <= 8 else "" for p in parts)
    return name.rstrip("_")


def _cache_list(flat, active, stmts):
    out, block = [], []
    for s in stmts:
        if isinstance(s, Assign):
            block.append(s)
            continue
        out += _cache_block(flat, active, block)
        block = []
        if isinstance(s, If):
            s.then = _cache_list(flat, active, s.then)
            s.other = _cache_list(flat, active, s.other)
        elif isinstance(s, For):
            s.body = _cache_list(flat, active, s.body)
        out.append(s)
    return out + _cache_block(flat, active, block)


def _cache_block(flat, active, block):
    if not block:
        return block
    arrays = {n for n in active if flat.is_array(n)}
    summed = {s.target.name for s in block if isinstance(s.target, Ref) and s.op != "="}
    count, written = {}, set()
    ints = {s.target.name for s in block if isinstance(s.target, Var)
            and flat.is_int(s.target.name)}

    def good(x):
        return isinstance(x, Ref) and x.name in arrays and x.name not in summed and \
            not ir.names(Ref("", x.index)) & ints

    for s in block:
        for x in ir.walk(s.value):
            if good(x):
                count[x] = count.get(x, 0) + 1
        if isinstance(s.target, Ref) and good(s.target):
            written.add(s.target)
    held = {}

    def use(e):
        if e in held:
            return held[e]
        return ir.rebuild(e, use)

    chosen = {x for x in count if count[x] > 1 or x in written}
    out = []
    for s in block:
        for x in ir.walk(s.value):
            if x in chosen and x not in held:
                held[x] = Var(flat.new(_name_of(x)))
                active.add(held[x].name)
                out.append(Assign(s.place, (), held[x], "=", x))
        value = use(s.value)
        if isinstance(s.target, Ref) and s.target in chosen and s.op == "=":
            new = Var(flat.new(_name_of(s.target)))
            active.add(new.name)
            out.append(Assign(s.place, s.comment, new, "=", value))
            out.append(Assign(s.place, (), s.target, "=", new))
            held[s.target] = new
        else:
            out.append(Assign(s.place, s.comment, s.target, s.op, value))
    if out:  # the comment of the block stays first
        first = next((s for s in out if s.comment), None)
        if first and first is not out[0] and first is block[0]:
            out[0].comment, first.comment = first.comment, ()
    return out
