"""Forward mode: the derivative statements of a normalised head.

The first pass knows that the workspace holds all results (`tape`): of the plain statements it keeps
those that compute locals which derivative statements need.  The second pass, over adjoint code, keeps
them all.
"""
from __future__ import annotations

from . import ir
from .ir import Assign, Bin, Call, For, If, Num, Ref, Stack, Un, Var, add, div, is_zero, mul, neg, sub
from .normal import value_names
from .rules import PARTIAL


class Companions:
    """Names of derivatives: Tapenade's, x -> xd, xd0 if taken."""

    def __init__(self, flat, active, suffix):
        self.flat, self.suffix = flat, suffix
        self.names = {}
        for p in flat.params:
            if p.name in active:
                self.add(p.name)
        for n in sorted(active):
            if n not in self.names:
                self.add(n)

    def add(self, n):
        c, k = n + self.suffix, 0
        while c in self.flat.taken:
            c, k = f"{n}{self.suffix}{k}", k + 1
        self.flat.taken.add(c)
        self.names[n] = c

    def of(self, e):
        name = self.names[e.name]
        return Var(name) if isinstance(e, Var) else Ref(name, e.index)


class Tangent:
    def __init__(self, flat, active, tape):
        self.flat, self.active, self.tape = flat, active, tape
        self.companions = Companions(flat, active, "d")
        self.inverse = {}  # denominators
        self.stored = stored_locals(flat) if tape else {}
        self.known = {}

    def run(self):
        body = self.block(self.flat.body)
        body = self.slice(body)
        for n in self.active:
            if n in self.flat.locals:
                self.flat.locals[self.companions.names[n]] = self.flat.locals[n]
        return body

    def block(self, stmts):
        out = []
        saved = dict(self.inverse), self.known
        if self.tape:
            self.known = known_values(stmts, self.stored, ir.summed_arrays(self.flat))
        for s in stmts:
            if isinstance(s, If):
                out.append(If(s.place, s.comment, s.test, self.block(s.then), self.block(s.other)))
            elif isinstance(s, For):
                self.inverse = {}
                out.append(For(s.place, s.comment, s.var, s.start, s.op, s.bound, s.step,
                               self.block(s.body)))
                self.inverse = {}
            elif isinstance(s, Stack):
                out += self.stack(s)
            else:
                out += self.assign(s)
        self.inverse, self.known = saved
        return out

    def stack(self, s):
        if s.var not in self.active:
            return [s]
        d = Stack(s.place, (), s.push, s.kind, self.companions.names[s.var], True)
        return [s, d] if s.push else [d, s]

    def assign(self, s):
        if s.target.name not in self.active:
            return [s] if self.keeps(s) else []
        before = []
        d = self.derivative(s, before)
        line = Assign(s.place, s.comment, self.companions.of(s.target), s.op, d, True)
        none = s.op != "=" and is_zero(d)
        plain = [Assign(s.place, (), s.target, s.op, s.value)] if self.keeps(s) else []
        if none:
            return plain
        if s.target.name in ir.names(s.value):
            return before + [line] + plain
        return plain + before + [line]

    def keeps(self, s):
        return not self.tape or not self.flat.is_array(s.target.name)

    # ------------------------------------------------------------------------------ expressions

    def derivative(self, s, before):
        e = s.value
        if isinstance(e, Call) and e.name in PARTIAL:
            total = ir.ZERO
            for x, c in zip(e.args, PARTIAL[e.name](e.args, s.target)):
                if self.is_active(x):
                    c = self.hold(replace(c, self.known), s, before)
                    total = add(total, mul(c, self.d(x)))
            return total
        if isinstance(e, Bin) and e.op == "/" and self.is_active(e.b):
            r = self.reciprocal(e.b, s, before)
            return mul(sub(self.d(e.a), mul(s.target, self.d(e.b))), r)
        return self.d(e)

    def hold(self, c, s, before):
        """a coefficient in a local of its own, unless it is a variable or a product of two"""
        calls = any(isinstance(x, Call) or isinstance(x, ir.Cond) or isinstance(x, Bin)
                    and x.op == "/" for x in ir.walk(c))
        if not calls or isinstance(c, (Num, Var)):
            return c
        new = self.flat.new("c")
        assign = Assign(s.place, (), Var(new), "=", c)
        if not self.tape:
            return c
        before.append(assign)
        return Var(new)

    def reciprocal(self, b, s, before):
        if not self.tape:
            return div(ir.ONE, b)
        if b not in self.inverse:
            new = self.flat.new(f"{b.name}inv" if isinstance(b, Var) else "inv")
            before.append(Assign(s.place, (), Var(new), "=", div(ir.ONE, b)))
            self.inverse[b] = Var(new)
        return self.inverse[b]

    def is_active(self, e):
        return bool(value_names(e) & self.active)

    def d(self, e):
        if not self.is_active(e):
            return ir.ZERO
        if isinstance(e, (Var, Ref)):
            return self.companions.of(e)
        if isinstance(e, Un):
            return neg(self.d(e.a))
        if isinstance(e, ir.Cond):
            return ir.Cond(e.test, self.d(e.a), self.d(e.b))
        if isinstance(e, Call):  # (double) of what is active, or a coefficient of adjoint code
            if e.name == "(double)":
                return self.d(e.args[0])
            total = ir.ZERO
            for x, c in zip(e.args, PARTIAL[e.name](e.args, e)):
                if self.is_active(x):
                    total = add(total, mul(c, self.d(x)))
            return total
        if e.op == "+":
            return add(self.d(e.a), self.d(e.b))
        if e.op == "-":
            return sub(self.d(e.a), self.d(e.b))
        if e.op == "*":
            return add(mul(self.d(e.a), e.b), mul(e.a, self.d(e.b)))
        if not self.is_active(e.b):
            return div(self.d(e.a), e.b)
        return div(sub(self.d(e.a), mul(e, self.d(e.b))), e.b)

    # ---------------------------------------------------------------------- what is not needed

    def slice(self, body):
        """drop plain statements whose locals nothing needs, and derivatives that nothing needs"""
        local = set(self.flat.locals) | {self.companions.names[n] for n in self.active
                                         if n in self.flat.locals}
        if self.tape:
            body = rematerialise(body, self.stored)
        return drop_unused(body, local)


def stored_locals(flat):
    """locals that are copied to the workspace: name -> element"""
    summed = ir.summed_arrays(flat)
    assigned = {}
    for s in ir.every(flat.body):
        if isinstance(s, Assign) and isinstance(s.target, Var):
            assigned[s.target.name] = assigned.get(s.target.name, 0) + 1
    stored = {}

    def scan(stmts):
        here = set()
        for s in stmts:
            if isinstance(s, Assign) and isinstance(s.target, Var) and s.op == "=":
                here.add(s.target.name)
            elif isinstance(s, Assign) and isinstance(s.value, Var) and s.op == "=" and \
                    flat.is_array(s.target.name) and s.target.name not in summed and \
                    s.value.name in here and assigned.get(s.value.name) == 1 and \
                    not ir.names(Ref("", s.target.index)) & set(assigned) - _before(stmts, s):
                stored.setdefault(s.value.name, s.target)
            for part in ir.lists(s):
                scan(part)

    scan(flat.body)
    return stored


def known_values(stmts, stored, summed):
    """elementary functions whose values the workspace holds, of one list: call -> element"""
    known = {}
    for s in stmts:
        if isinstance(s, Assign) and s.op == "=" and isinstance(s.value, Call):
            element = stored.get(s.target.name) if isinstance(s.target, Var) else s.target
            if element is not None and element.name not in summed:
                known[s.value] = element
    return known


def replace(e, known):
    return known[e] if e in known else ir.rebuild(e, lambda x: replace(x, known)) if known else e


def rematerialise(body, stored):
    """with a tape, a local whose value has been stored in the workspace is read from there"""
    out = []
    for s in body:
        if isinstance(s, Assign) and not s.derivative and isinstance(s.target, Var) and \
                s.target.name in stored and not isinstance(s.value, (Var, Num)):
            s = Assign(s.place, s.comment, s.target, "=", stored[s.target.name])
        elif isinstance(s, If):
            s.then, s.other = rematerialise(s.then, stored), rematerialise(s.other, stored)
        elif isinstance(s, For):
            s.body = rematerialise(s.body, stored)
        out.append(s)
    return out


def _before(stmts, last):
    """integers that are set before the first active statement of a list, such as `up`"""
    found = set()
    for s in stmts:
        if s is last or not (isinstance(s, Assign) and isinstance(s.target, Var)):
            break
        found.add(s.target.name)
    return found


def drop_unused(body, local):
    """without statements that only compute locals which nothing reads"""
    while True:
        used = set()
        for s in ir.every(body):
            r = reads_beyond_itself(s)
            used |= r
        kept = _drop(body, local, used)
        if sum(1 for _ in ir.every(kept)) == sum(1 for _ in ir.every(body)):
            return kept
        body = kept


def reads_beyond_itself(s):
    r = ir.reads(s)
    if isinstance(s, Assign) and isinstance(s.target, Var):
        r = r - {s.target.name}
    elif isinstance(s, Assign) and s.op != "=":
        r = r - ({s.target.name} - ir.names(s.value) - ir.names(Ref("", s.target.index)))
    return r


def _drop(stmts, local, used):
    out = []
    carried = ()
    for s in stmts:
        gone = isinstance(s, Assign) and s.target.name in local and s.target.name not in used
        if not gone and isinstance(s, (If, For)):
            parts = [_drop(p, local, used) for p in ir.lists(s)]
            if isinstance(s, If):
                s = If(s.place, s.comment, s.test, *parts)
            else:
                s = For(s.place, s.comment, s.var, s.start, s.op, s.bound, s.step, *parts)
            gone = not any(parts)
        if gone:
            carried += s.comment
            continue
        if carried:
            s.comment = carried + tuple(c for c in s.comment)
            carried = ()
        out.append(s)
    return out
