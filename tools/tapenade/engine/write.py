"""From statements to C: functions, the header, and the table of heads for tests."""
from __future__ import annotations

import re
import textwrap

from . import ir
from .ir import Assign, Bin, Call, Cond, For, If, Num, Ref, Stack, Un, Var

WIDTH = 100
RANK = {"||": 2, "&&": 3, "|": 4, "^": 4, "&": 5, "==": 6, "!=": 6, "<": 7, "<=": 7, ">": 7,
        ">=": 7, "<<": 8, ">>": 8, "+": 9, "-": 9, "*": 10, "/": 10, "%": 10}
DIRECTION = "nd"


def text(e, rank=0):
    if isinstance(e, Num):
        return e.text
    if isinstance(e, Var):
        return e.name
    if isinstance(e, Ref):
        if not e.index:
            return f"*{e.name}" if rank <= 11 else f"(*{e.name})"
        return e.name + "".join(f"[{text(i)}]" for i in e.index)
    if isinstance(e, Call):
        if e.name.startswith("("):
            return e.name + text(e.args[0], 11)
        return f"{e.name}({', '.join(text(a) for a in e.args)})"
    if isinstance(e, Cond):
        out = f"{text(e.test, 2)} ? {text(e.a, 2)} : {text(e.b, 1)}"
        return f"({out})" if rank > 1 else out
    if isinstance(e, Un):
        inner = text(e.a, 11)
        out = e.op + (f"({inner})" if inner.startswith(e.op) else inner)
        return f"({out})" if rank > 9 and e.op == "-" and rank != 10 or rank > 11 else out
    r = RANK[e.op]
    if e.op in ("&&", "||"):  # parentheses that compilers ask for
        a, b = (text(x, 6 if isinstance(x, Bin) and x.op in ("&&", "||") and x.op != e.op else r)
                for x in (e.a, e.b))
    else:
        a, b = text(e.a, r), text(e.b, r + 1)
    out = f"{a} {e.op} {b}"
    return f"({out})" if r < rank else out


def comment_lines(comment, indent):
    if not comment:
        return []
    pad = "  " * indent
    lines = [pad + ("/* " if i == 0 else " * ") + x for i, x in enumerate(comment)]
    lines = [x.rstrip() for x in lines]
    lines[-1] += " */"
    return lines


def wrap(line, indent, extra=4):
    pad = "  " * indent
    if len(pad + line) <= WIDTH:
        return [pad + line]
    return textwrap.wrap(line, WIDTH, initial_indent=pad, subsequent_indent=pad + " " * extra,
                         break_long_words=False, break_on_hyphens=False)


def call_lines(start, items, end):
    """items in parentheses, broken between items and aligned behind the parenthesis"""
    lines, line = [], start
    for i, item in enumerate(items):
        last = i + 1 == len(items)
        piece = item + (end if last else ",")
        space = "" if line.endswith("(") else " "
        if len(line + space + piece) > WIDTH and line.strip() and not line.endswith("("):
            lines.append(line)
            line, space = " " * len(start), ""
        line += space + piece
    return lines + [line]


def declare(kind, names, indent):
    return wrap(f"{kind} {', '.join(names)};", indent) if names else []


class Writer:
    """One function.  `strip`: derivative statements run over the directions of a strip."""

    def __init__(self, name, params, local, body, derivatives=frozenset(), strip=False, static=False):
        self.name, self.params, self.local = name, params, local
        self.body, self.derivatives, self.strip = body, derivatives, strip
        self.static = static

    # ------------------------------------------------------------------------------ signature

    def signature(self, end):
        return call_lines(f"void {self.name}(", self.params, f"){end}")

    def lines(self):
        self.arrays = set()  # derivative locals that live across direction loops
        body = self.grouped(self.body) if self.strip else self.body
        code = []
        self.block(body, 1, code)
        used = ir.all_reads(self.body) | ir.all_writes(self.body)
        if self.strip and any(getattr(s, "derivative", False) for s in ir.every(self.body)):
            used.add(DIRECTION)
        out = self.signature("")
        out.append("{")
        ints = sorted(n for n, (k, d) in self.local.items() if k == "int" and n in used)
        out += declare("int", ints, 1)
        plain, other = [], []
        for n, (kind, dims) in sorted(self.local.items()):
            if kind == "int" or n not in used:
                continue
            if self.strip and n in self.derivatives:
                if n in self.arrays or dims:
                    other.append(n + "".join(f"[{d}]" for d in dims) + "[MAGGI_NDIR]")
            elif dims:
                other.append(n + "".join(f"[{d}]" for d in dims))
            else:
                plain.append(n)
        out += declare("double", plain, 1) + declare("double", other, 1)
        if len(out) > len(self.signature("")) + 1:
            out.append("")
        mentioned = used | {x.split("->")[0] for x in used}
        for p in self.params:
            n = re.match(r".*?(\w+)(\[.*)?$", p).group(1)
            if n not in mentioned:
                out.append(f"  (void){n};")
        unset = ir.read_first(self.body)[0]  # as far as a compiler may see
        out += [f"  {n} = {'0' if n in ints else '0.0'};" for n in plain + ints if n in unset]
        return out + code + ["}"]

    # ---------------------------------------------------------------------------- direction loops

    def grouped(self, stmts):
        """derivative statements that follow one another share a loop over directions"""
        out, group, read = [], [], set()

        def flush():
            if group:
                out.append(Group(list(group)))
                group.clear()
                read.clear()

        for s in stmts:
            if isinstance(s, Assign) and s.derivative:
                group.append(s)
                read.update(ir.reads(s))
                if isinstance(s.target, Ref):
                    read.update(ir.names(Ref("", s.target.index)))
            elif isinstance(s, Assign):
                if s.target.name in read:
                    flush()
                out.append(s)
            elif isinstance(s, Stack):
                flush()
                out.append(s)
            else:
                flush()
                parts = [self.grouped(p) for p in ir.lists(s)]
                out.append(If(s.place, s.comment, s.test, *parts) if isinstance(s, If) else
                           For(s.place, s.comment, s.var, s.start, s.op, s.bound, s.step, *parts))
        flush()
        if stmts is self.body:
            self.find_arrays(out)
        return out

    def find_arrays(self, stmts):
        where = {}

        def scan(stmts):
            for s in stmts:
                if isinstance(s, Group):
                    for x in {n for y in s.body for n in ir.reads(y) | {ir.writes(y)}}:
                        if x in self.derivatives and x in self.local:
                            where.setdefault(x, []).append(s)
                else:
                    for part in ir.lists(s):
                        scan(part)

        scan(stmts)
        for x, groups in where.items():
            first = next(y for y in groups[0].body if x in ir.reads(y) or ir.writes(y) == x)
            if len(groups) > 1 or x in ir.reads(first):
                self.arrays.add(x)

    def over_directions(self, e):
        if isinstance(e, Ref) and e.name in self.derivatives:
            return Ref(e.name, e.index + (Var(DIRECTION),))
        if isinstance(e, Var) and e.name in self.derivatives and \
                (e.name in self.arrays or e.name not in self.local):
            return Ref(e.name, (Var(DIRECTION),))
        return ir.rebuild(e, self.over_directions)

    # ------------------------------------------------------------------------------- statements

    def block(self, stmts, indent, out):
        pad = "  " * indent
        for s in stmts:
            if isinstance(s, Group):
                self.group(s, indent, out)
                continue
            out += comment_lines(s.comment, indent)
            if isinstance(s, Assign):
                out += self.assign(s, indent)
            elif isinstance(s, Stack):
                kind = "Real8" if s.kind == "double" else "Integer4"
                word = f"push{kind}({s.var})" if s.push else f"pop{kind}(&{s.var})"
                out.append(f"{pad}{word};")
            elif isinstance(s, For):
                step = {1: f"++{s.var}", -1: f"--{s.var}"}.get(
                    s.step, f"{s.var} {'+' if s.step > 0 else '-'}= {abs(s.step)}")
                head = f"for ({s.var} = {text(s.start)}; {s.var} {s.op} {text(s.bound)}; {step}) {{"
                out += wrap(head, indent)
                self.block(s.body, indent + 1, out)
                out.append(pad + "}")
            else:
                self.branch(s, indent, out)

    def branch(self, s, indent, out):
        pad = "  " * indent
        if not s.then:
            out += wrap(f"if ({text(negation(s.test))}) {{", indent)
            self.block(s.other, indent + 1, out)
            out.append(pad + "}")
            return
        out += wrap(f"if ({text(s.test)}) {{", indent)
        self.block(s.then, indent + 1, out)
        while s.other:
            if len(s.other) == 1 and isinstance(s.other[0], If) and s.other[0].then and \
                    not s.other[0].comment:
                s = s.other[0]
                out += wrap(f"}} else if ({text(s.test)}) {{", indent)
                self.block(s.then, indent + 1, out)
            else:
                out.append(pad + "} else {")
                self.block(s.other, indent + 1, out)
                break
        out.append(pad + "}")

    def assign(self, s, indent):
        target = text(s.target)
        return wrap(f"{target} {s.op} {text(s.value)};", indent)

    def group(self, g, indent, out):
        pad = "  " * indent
        out.append("#pragma omp simd")
        out.append(f"{pad}for ({DIRECTION} = 0; {DIRECTION} < MAGGI_NDIR; ++{DIRECTION}) {{")
        own = sorted({y.target.name for y in g.body if isinstance(y.target, Var)
                      and y.target.name in self.local and y.target.name not in self.arrays})
        out += declare("double", own, indent + 1)
        if own:
            out.append("")
        for s in g.body:
            out += comment_lines(s.comment, indent + 1)
            c = Assign(s.place, (), self.over_directions(s.target), s.op,
                       self.over_directions(s.value))
            out += self.assign(c, indent + 1)
        out.append(pad + "}")


class Group(ir.Statement):
    def __init__(self, body):
        super().__init__()
        self.body = body


def negation(e):
    opposite = {"==": "!=", "!=": "==", "<": ">=", ">=": "<", ">": "<=", "<=": ">"}
    if isinstance(e, Bin) and e.op in opposite and \
            not any(isinstance(x, Call) for x in ir.walk(e)):
        return Bin(opposite[e.op], e.a, e.b)
    return Un("!", e)


# -------------------------------------------------------------------------------------- parameters


def dims_text(p):
    """sizes of an array parameter with the qualifier that says that it overlaps no other"""
    first, rest = p.dims[0], p.dims[1:]
    size = "" if first is None else " " + text(first)
    return f"[restrict{size}]" + "".join(f"[{text(d)}]" for d in rest)


def plain(p):
    if p.kind == "topo":
        return f"{'const ' if p.const else ''}{p.type} *{p.name}"
    if p.kind in ("int", "double"):
        return f"{p.kind} {p.name}"
    kind = "int" if p.kind == "ints" else "double"
    size = dims_text(p) if kind == "double" else "[]"
    return f"{'const ' if p.const else ''}{kind} {p.name}{size}"


def parameters(params, active, mode):
    """parameters of a derivative: every active one is followed by its derivatives"""
    out = []
    for p in params:
        out.append(plain(p))
        if p.name not in active:
            continue
        const = "const " if p.const else ""
        if p.kind == "double":
            companions = {
                "d": [f"double {p.name}d"],
                "dv": [f"const double {p.name}d[restrict MAGGI_NDIR]"],
                "b": [f"double *restrict {p.name}b"],
                "b_d": [f"double {p.name}d", f"double *restrict {p.name}b",
                        f"double *restrict {p.name}bd"]}
        else:
            size = dims_text(p)
            companions = {
                "d": [f"{const}double {p.name}d{size}"],
                "dv": [f"{const}double {p.name}d{size}[MAGGI_NDIR]"],
                "b": [f"double {p.name}b{size}"],
                "b_d": [f"{const}double {p.name}d{size}", f"double {p.name}b{size}",
                        f"double {p.name}bd{size}"]}
        out += companions[mode]
    if mode == "dv":
        out.append("int nbdirs")
    return out
