"""Reverse mode: the backward sweep of a normalised head.

The workspace is the tape: arrays hold their values.  Locals of a loop body are computed again in each
pass of the reversed loop, before its backward statements; nothing is stored.  Only a local whose value
is overwritten while a backward statement still needs it is pushed and popped.
"""
from __future__ import annotations

from . import ir
from .ir import (Assign, Bin, Call, For, If, Num, Ref, Refusal, Stack, Un, Var, div, int_expr,
                 is_zero, mul, neg)
from .inline import fold
from .normal import mentions, value_names, varying
from .rules import PARTIAL
from .tangent import Companions, drop_unused, known_values, replace, stored_locals


class Piece:
    """what the backward sweep does for one statement"""

    def __init__(self, statement, code, pops):
        self.statement, self.code, self.pops = statement, code, pops


class Adjoint:
    def __init__(self, flat, active):
        self.flat, self.active = flat, active
        self.companions = Companions(flat, active, "b")
        self.adjoints = set(self.companions.names.values())

    def run(self):
        flat = self.flat
        self.writes = {}
        for s in ir.every(flat.body):
            w = ir.writes(s)
            if w:
                self.writes[w] = self.writes.get(w, 0) + 1
        assigned = {s.target.name for s in ir.every(flat.body) if isinstance(s, Assign)}
        self.counters = {s.var for s in ir.every(flat.body) if isinstance(s, For)} - assigned
        self.homes, self.around, self.tangled = {}, {}, set()
        self.total = self.counts(flat.body)
        self.find_homes(flat.body, [])
        for n in self.active:
            if n in flat.locals:
                flat.locals[self.companions.names[n]] = flat.locals[n]
        self.filled_once = self.arrays_filled_once()
        self.stored, self.summed = stored_locals(flat), ir.summed_arrays(flat)
        body = drop_unused(self.sweep(flat.body, None), set(flat.locals))
        self.check_passes(flat.body, [], ir.all_reads(body))
        return body

    def source(self, s):
        """how a local gets its value again: from the workspace when it has been stored there"""
        if s.op == "=" and isinstance(s.target, Var) and s.target.name in self.stored and \
                not isinstance(s.value, (Var, Num)):
            return self.stored[s.target.name]
        return s.value

    # ------------------------------------------------------------------ where a local belongs

    def find_homes(self, stmts, around):
        """A scope is the body of a loop or a branch of an if, known by the identity of its list.
        homes[x] is the innermost scope in which every use of x lies and that sets it first."""
        for s in stmts:
            for part in ir.lists(s):
                here = around + [id(part)]
                self.around[id(part)] = here
                if isinstance(s, If) and self.is_tangled(part):
                    self.tangled.add(id(s))
                if not (isinstance(s, If) and any(self.is_tangled(p) for p in ir.lists(s))):
                    unset = ir.read_first(part)[0]
                    for x, n in self.counts(part).items():
                        if x in self.flat.locals and n == self.total[x] and \
                                not (isinstance(s, For) and x == s.var) and \
                                self.starts_anew(part, x, unset):
                            self.homes[x] = id(part)
                self.find_homes(part, here)

    def is_tangled(self, part):
        """whether a branch changes a local of outside that it also reads: then the values that its
        backward statements want are computed before, with the rest of the scope around it"""
        written = ir.all_writes(part) & ir.all_reads(part)
        inside = self.counts(part)
        return any(x in self.flat.locals and inside[x] != self.total[x] for x in written)

    def starts_anew(self, body, x, unset):
        """whether a pass sets x before it reads it; of an array, whether it begins with that"""
        if not self.flat.locals[x][1]:
            return x not in unset
        first = next(s for s in ir.every(body) if x in ir.reads(s) or ir.writes(s) == x)
        return x not in ir.reads(first)

    def counts(self, stmts):
        n = {}
        for s in ir.every(stmts):
            for x in ir.reads(s) | ({ir.writes(s)} - {None}):
                n[x] = n.get(x, 0) + 1
        return n

    def inside(self, x, scope):
        """whether the home of x is this scope or lies in it"""
        home = self.homes.get(x)
        return home is not None and (scope is None or id(scope) in self.around[home])

    # ------------------------------------------------------------------------------- one scope

    def sweep(self, stmts, scope):
        """forward part that recomputes locals, then the backward part, of a scope or of the head"""
        pieces = self.pieces(stmts, set())
        code = self.emit(pieces)
        forward = self.forward(stmts, self.needed(code, scope), pieces, scope)
        return forward + self.initialise(code, self.own_adjoints(scope))

    def own_adjoints(self, scope):
        home = None if scope is None else id(scope)
        return {self.companions.names[x] for x in self.active
                if x in self.flat.locals and self.homes.get(x) == home}

    def pieces(self, stmts, before):
        """pieces in program order; before: names that backward code of earlier statements reads"""
        out, seen = [], set(before)
        known = known_values(stmts, self.stored, self.summed)
        for s in stmts:
            self.known = known
            self.check_local_arrays(s, seen)
            if isinstance(s, Assign):
                code = self.assign(s)
                pops = [s.target.name] if self.must_keep(s.target.name, seen) else []
                p = Piece(s, code, pops)
            elif id(s) in self.tangled:
                p = Piece(s, (self.pieces(s.then, seen), self.pieces(s.other, seen)), [])
            else:
                parts = ir.lists(s)
                kept = [x for x in sorted(ir.all_writes([s])) if self.must_keep(x, seen)
                        and not any(self.inside(x, part) for part in parts)]
                p = Piece(s, [self.sweep(part, part) for part in parts], kept)
                if isinstance(s, For):
                    p.carried = self.carried(s, p.code[0])
            out.append(p)
            seen |= ir.all_reads(self.emit([p]))
            self.check_order(s, out)
        return out

    def must_keep(self, x, seen):
        """whether backward statements of what came before read the value that is overwritten"""
        return x in seen and x in self.flat.locals and not self.flat.locals[x][1] and \
            x not in self.counters

    def arrays_filled_once(self):
        """local arrays whose elements are set in one loop, or none, and never again"""
        where, texts = {}, {}

        def scan(stmts, loop):
            for s in stmts:
                if isinstance(s, Assign) and isinstance(s.target, Ref) and \
                        s.target.name in self.flat.locals:
                    x = s.target.name
                    where.setdefault(x, set()).add(id(loop) if s.op == "=" else s.op)
                    texts.setdefault(x, []).append((s.target, id(stmts)))
                for part in ir.lists(s):
                    scan(part, s if isinstance(s, For) else loop)

        scan(self.flat.body, None)
        return {x for x in where if len(where[x]) == 1 and len(texts[x]) == len(set(texts[x]))}

    def check_local_arrays(self, s, seen):
        """local arrays are not pushed: what backward statements of before read must stay"""
        for y in ir.every([s]):
            x = ir.writes(y)
            once = isinstance(y, Assign) and y.op == "=" and x in self.filled_once
            if x in seen and x in self.flat.locals and self.flat.locals[x][1] and not once:
                raise Refusal(*y.place, f"`{x}` changes after its values were used: give the new ones "
                                        f"an array of their own")

    def check_passes(self, stmts, loops, read):
        """the same from pass to pass of a loop, unless the array belongs to the pass"""
        for s in stmts:
            if isinstance(s, Assign) and isinstance(s.target, Ref) and s.op == "=" and \
                    s.target.name in read and s.target.name in self.flat.locals:
                around = self.around.get(self.homes.get(s.target.name), ())
                for loop in loops:
                    if id(loop.body) not in around and \
                            not ir.names(Ref("", s.target.index)) & varying(loop):
                        raise Refusal(*s.place, f"`{s.target.name}` is written in each pass of the "
                                                f"loop over `{loop.var}`")
            for part in ir.lists(s):
                self.check_passes(part, loops + [s] if isinstance(s, For) else loops, read)

    def check_order(self, s, pieces):
        """an element that later statements of the list add to must not have been needed before"""
        if isinstance(s, Assign) and isinstance(s.target, Ref) and \
                self.flat.is_array(s.target.name):
            for p in pieces[:-1]:
                if isinstance(p.statement, Assign) and s.target in ir.walk(p.statement.value):
                    for c in p.code:
                        for e in ir.own_expressions(c):
                            if s.target in ir.walk(e):
                                raise Refusal(*s.place, f"an element of `{s.target.name}` changes "
                                                        f"after its value was used in line "
                                                        f"{p.statement.place[1]}")

    def carried(self, s, body):
        """locals that a pass of the loop takes over from the one before and whose values the reversed
        pass needs"""
        unset = ir.read_first(body)[0]
        return [x for x in sorted(ir.all_writes(s.body))
                if x in unset and x in self.flat.locals and not self.flat.locals[x][1]
                and not self.inside(x, s.body) and x != s.var]

    def emit(self, pieces):
        out = []
        for p in reversed(pieces):
            s = p.statement
            if isinstance(s, Assign):
                out += [self.pop(s, x) for x in p.pops]
                if p.code:
                    p.code[0].comment = s.comment
                out += p.code
            elif isinstance(s, If):
                then, other = (self.emit(c) for c in p.code) if id(s) in self.tangled else p.code
                if then or other:
                    out.append(If(s.place, s.comment, s.test, then, other))
            else:
                body = [self.pop(s, x) for x in reversed(p.carried)] + p.code[0]
                if body:
                    out.append(self.reversed_loop(s, body))
            if not isinstance(s, Assign):
                out += [self.pop(s, x) for x in reversed(p.pops)]
        return out

    def pop(self, s, x):
        return Stack(s.place, (), False, self.flat.locals[x][0], x)

    def push(self, s, x):
        return Stack(s.place, (), True, self.flat.locals[x][0], x)

    def reversed_loop(self, s, body):
        """the same values of the variable, last one first"""
        up = s.step > 0
        edge = s.bound if s.op in ("<=", ">=") else \
            fold(Bin("-" if up else "+", s.bound, Num("1")), {})
        if abs(s.step) == 1:
            last = edge
        else:
            n = Num(str(abs(s.step)))
            span = Bin("-", edge, s.start) if up else Bin("-", s.start, edge)
            whole = Bin("*", Bin("/", span, n), n)
            last = fold(Bin("+" if up else "-", s.start, whole), {})
            # without a pass, -1 / 2 rounds to 0: start from beyond
            last = ir.Cond(Bin("<" if up else ">", edge, s.start),
                           fold(Bin("-" if up else "+", s.start, n), {}), last)
        op, bound = (">=" if up else "<="), s.start
        if op == "<=" and isinstance(bound, Bin) and bound.op == "-" and bound.b == Num("1"):
            op, bound = "<", bound.a
        return For(s.place, s.comment, s.var, last, op, bound, -s.step, body)

    # --------------------------------------------------------------------------------- forward

    def needed(self, code, scope):
        """locals whose values the backward statements of a scope read, but not those that deeper
        scopes compute for themselves"""
        home = None if scope is None else id(scope)
        return {x for x in ir.all_reads(code) if x in self.flat.locals and x not in self.adjoints
                and (self.homes.get(x) == home or not self.inside(x, scope))}

    def forward(self, stmts, needed, pieces, scope):
        """the statements that compute `needed`, with what must be pushed"""
        needed = set(needed)
        while True:
            n = len(needed)
            self.closure(stmts, needed)
            if len(needed) == n:
                break
        return self.cut(stmts, needed, pieces, scope)

    def closure(self, stmts, needed):
        for s in stmts:
            if isinstance(s, Assign):
                if s.target.name in needed and s.target.name in self.flat.locals:
                    needed |= {x for x in ir.names(self.source(s)) if x in self.flat.locals}
                    needed |= self.locals_in(s) if isinstance(s.target, Ref) else set()
            elif isinstance(s, (If, For)):
                if any(isinstance(y, Assign) and y.target.name in needed
                       and y.target.name in self.flat.locals for y in ir.every([s])):
                    needed |= self.locals_in(s)
                for part in ir.lists(s):
                    self.closure(part, needed)

    def locals_in(self, s):
        return {x for e in ir.own_expressions(s) for x in ir.names(e) if x in self.flat.locals}

    def cut(self, stmts, needed, pieces, scope):
        by = {id(p.statement): p for p in pieces} if pieces else {}
        out = []
        for s in stmts:
            p = by.get(id(s))
            if p:
                out += [self.push(s, x) for x in p.pops]
            if isinstance(s, Assign):
                x = s.target.name
                if x in self.flat.locals and (p and p.pops or x in needed and
                                              self.may_recompute(x, scope)):
                    out.append(Assign(s.place, (), s.target, s.op, self.source(s)))
            elif isinstance(s, If):
                inner = p.code if p and id(s) in self.tangled else (None, None)
                then, other = (self.cut(part, needed, c, scope)
                               for part, c in zip(ir.lists(s), inner))
                if then or other:
                    out.append(If(s.place, (), s.test, then, other))
            else:
                body = self.cut(s.body, needed, None, scope)
                if p:
                    body = [self.push(s, x) for x in p.carried] + body
                if body:
                    out.append(For(s.place, (), s.var, s.start, s.op, s.bound, s.step, body))
        return out

    def may_recompute(self, x, scope):
        """a local array is computed once, where it belongs"""
        return scope is None or not self.flat.locals[x][1] or self.inside(x, scope)

    # -------------------------------------------------------------------- backward statements

    def assign(self, s):
        """backward statements of one assignment"""
        x = s.target.name
        if x not in self.active:
            return []
        self.out, self.place = [], s.place
        bar = self.bar(s.target)
        if s.op == "+=" or s.op == "-=":
            seed = bar
            if isinstance(bar, Ref):
                seed = self.seed_of(s, bar)
            self.spread(s.value, neg(seed) if s.op == "-=" else seed, s)
            return self.out
        if isinstance(s.target, Ref):
            if self.is_active(s.value):
                seed = self.seed_of(s, bar)
                self.spread(s.value, seed, s)
                if seed == bar:  # used once: read, then cleared
                    self.out.append(Assign(s.place, (), bar, "=", ir.ZERO))
                else:
                    self.out.insert(1, Assign(s.place, (), bar, "=", ir.ZERO))
            else:
                self.out.append(Assign(s.place, (), bar, "=", ir.ZERO))
            return self.out
        self.spread(s.value, bar, s)
        if self.writes.get(x, 0) > 1:
            self.out.append(Assign(s.place, (), bar, "=", ir.ZERO))
        return self.out

    def leaves(self, e):
        """active variables and elements in e, with repetitions"""
        return [y for y in ir.walk(e) if isinstance(y, (Var, Ref)) and y.name in self.active]

    def seed_of(self, s, bar):
        """the adjoint of an element in a local, when it is used more than once"""
        if len(self.leaves(s.value)) <= 1 and not isinstance(s.value, Call):
            return bar
        new = self.flat.new("tb")
        self.flat.locals[new] = ("double", ())
        self.out.append(Assign(s.place, (), Var(new), "=", bar))
        return Var(new)

    def is_active(self, e):
        return bool(value_names(e) & self.active)

    def bar(self, target):
        """adjoint of a variable or element; that of a parameter passed by value is a pointer"""
        if isinstance(target, Var) and target.name not in self.flat.locals:
            return Ref(self.companions.names[target.name], ())
        return self.companions.of(target)

    def put(self, target, seed):
        if is_zero(seed):
            return
        bar = self.bar(target)
        negative = isinstance(seed, Un) and seed.op == "-"
        self.out.append(Assign(self.place, (), bar, "-=" if negative else "+=",
                               seed.a if negative else seed))

    def hold(self, e, base):
        """e in a local, unless it is simple"""
        sign = isinstance(e, Un) and e.op == "-"
        inner = e.a if sign else e
        if isinstance(inner, (Var, Num)):
            return e
        new = self.flat.new(base)
        self.flat.locals[new] = ("double", ())
        self.out.append(Assign(self.place, (), Var(new), "=", inner))
        return neg(Var(new)) if sign else Var(new)

    def spread(self, e, seed, s):
        """seed times the partial derivatives of e, to the adjoints of what it reads"""
        if not self.is_active(e):
            return
        if isinstance(e, (Var, Ref)):
            self.put(e, seed)
        elif isinstance(e, Un):
            self.spread(e.a, neg(seed), s)
        elif isinstance(e, Call):
            if e.name == "(double)":
                self.spread(e.args[0], seed, s)
                return
            several = sum(self.is_active(x) for x in e.args) > 1
            if several:
                seed = self.hold(seed, "tb")
            for x, c in zip(e.args, PARTIAL[e.name](e.args, s.target)):
                if self.is_active(x):
                    self.spread(x, mul(seed, replace(c, self.known)), s)
        elif e.op in "+-":
            if self.is_active(e.a) and self.is_active(e.b):
                seed = self.hold(seed, "tb")
            self.spread(e.a, seed, s)
            self.spread(e.b, neg(seed) if e.op == "-" else seed, s)
        elif e.op == "*":
            both = self.is_active(e.a) and self.is_active(e.b)
            if both:
                seed = self.hold(seed, "tb")
            for x, y in ((e.a, e.b), (e.b, e.a)):
                if self.is_active(x):
                    partial = mul(seed, y)
                    self.spread(x, self.hold(partial, "tb") if len(self.leaves(x)) > 1 else partial,
                                s)
        elif not self.is_active(e.b):
            partial = div(seed, e.b)
            self.spread(e.a, self.hold(partial, "tb") if len(self.leaves(e.a)) > 1 else partial, s)
        else:  # y = a / b
            t = self.hold(div(seed, e.b), "tb")
            self.spread(e.a, t, s)
            self.spread(e.b, neg(mul(t, s.target)), s)

    # ------------------------------------------------------------------- first contributions

    def initialise(self, code, own):
        """adjoints of the scope's own locals start from zero: the first sum becomes an assignment"""
        pending = set(own)
        out = []
        for s in code:
            used = {x for x in pending if mentions(s, x)}
            for x in sorted(used):
                pending.discard(x)
                dims = self.flat.locals[x][1]
                if dims:
                    out += self.clear(s, x, dims)
                elif isinstance(s, Assign) and s.target == Var(x) and s.op in ("+=", "-="):
                    s.value = neg(s.value) if s.op == "-=" else s.value
                    s.op = "="
                elif isinstance(s, Assign) and s.target == Var(x) and x not in ir.names(s.value):
                    pass  # set at once
                else:
                    out.append(Assign(s.place, (), Var(x), "=", ir.ZERO))
            out.append(s)
        return out

    def clear(self, s, x, dims):
        out, index = [], []
        body = out
        for n in dims:
            k = self.flat.new("k", "int")
            index.append(Var(k))
            loop = For(s.place, (), k, Num("0"), "<", int_expr(n), 1, [])
            body.append(loop)
            body = loop.body
        body.append(Assign(s.place, (), Ref(x, tuple(index)), "=", ir.ZERO))
        return out
