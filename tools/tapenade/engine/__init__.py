"""Source transformation of the kernel subset of C: tangent, vector tangent, adjoint, and the tangent
of the adjoint.

    differentiate(sources, heads, include_dirs) -> {file name: text}
"""
from __future__ import annotations

import os
import re
from dataclasses import dataclass, field

from . import ir, normal, write
from .adjoint import Adjoint
from .front import Program
from .inline import Inliner
from .ir import Refusal
from .tangent import Tangent

VERSION = "1.0"
MODES = ("d", "dv", "b", "b_d")
KIND = {"d": "Tangent", "dv": "Vector tangent, one strip of MAGGI_NDIR directions",
        "b": "Adjoint", "b_d": "Tangent of the adjoint"}

__all__ = ["Head", "Program", "Refusal", "differentiate", "MODES", "VERSION"]


@dataclass
class Head:
    name: str
    outputs: list
    inputs: list
    modes: list = field(default_factory=lambda: list(MODES))
    sources: list = field(default_factory=list)
    integers: dict = field(default_factory=dict)  # values of int arguments, for tests
    place: tuple = ("heads.txt", 1)


def differentiate(sources, heads, include_dirs=(), defines=(), includes=("kernel.h",)):
    """sources: paths of C files; includes: headers that declare the heads.  Raises Refusal."""
    program = Program(sources, include_dirs, defines)
    files = {}  # (base, mode) -> Output
    done = []
    for head in heads:
        one = _Differentiated(program, head)
        done.append(one)
        path = program.functions[head.name].file.path
        base = os.path.splitext(os.path.basename(path))[0]
        for mode in head.modes:
            out = files.setdefault((base, mode), _Output(path, mode))
            out.add(one, mode)
    result = {f"{base}_{mode}.c": out.text() for (base, mode), out in files.items()}
    result["maggi_ad.h"] = _header(done, includes)
    result["heads.c"] = _table(done)
    return dict(sorted(result.items()))


class _Differentiated:
    """A head in all its modes: writers by mode."""

    def __init__(self, program, head):
        self.head = head
        if head.name not in program.functions:
            raise Refusal(*head.place, f"there is no function `{head.name}`")
        flat = Inliner(program).flatten(head.name)
        self.params = flat.params
        self.flat_comment = flat.comment
        known = {p.name: p for p in flat.params}
        for n in head.inputs + head.outputs:
            if n not in known or known[n].kind not in ("array", "double"):
                raise Refusal(*head.place, f"`{n}` is not a real argument of `{head.name}`")
        for n in head.outputs:
            if known[n].const or known[n].kind != "array":
                raise Refusal(*head.place, f"`{head.name}` cannot write `{n}`")
        normal.check(flat, program)
        normal.split_webs(flat)
        active = normal.activity(flat, head.inputs, head.outputs)
        normal.check_integers(flat, head.inputs)
        for n in head.outputs:
            if n not in active:
                raise Refusal(*head.place, f"`{n}` of `{head.name}` does not depend on "
                                           f"{', '.join(head.inputs)}")
        for p in flat.params:
            if p.name in active and p.name not in head.inputs + head.outputs:
                raise Refusal(*head.place, f"`{p.name}` of `{head.name}` depends on "
                                           f"{', '.join(head.inputs)} and is used, but is not an "
                                           f"output")
        active |= set(head.inputs)
        normal.Normaliser(flat, active).run()
        normal.cache_reads(flat, active)
        active = normal.activity(flat, head.inputs, head.outputs) | set(head.inputs)
        self.active = {p.name for p in flat.params if p.name in active}
        self.role = {}
        for p in flat.params:
            if p.kind in ("array", "double"):
                self.role[p.name] = self.role_of(p, flat)
        self.passive_functions, self.tables = flat.passive_functions, flat.tables
        self.writers = {}
        for mode in ("d", "dv"):
            if mode in head.modes:
                f = flat.copy()
                t = Tangent(f, set(active), True)
                body = t.run()
                local = dict(f.locals)
                if mode == "dv":
                    local[write.DIRECTION] = ("int", ())
                self.writers[mode] = write.Writer(
                    f"{head.name}_{mode}", write.parameters(f.params, self.active, mode), local,
                    body, {t.companions.names[n] for n in active}, mode == "dv")
        if "b" in head.modes or "b_d" in head.modes:
            f = flat.copy()
            a = Adjoint(f, set(active))
            body = a.run()
            if "b" in head.modes:
                self.writers["b"] = write.Writer(
                    f"{head.name}_b", write.parameters(f.params, self.active, "b"),
                    dict(f.locals), body)
            if "b_d" in head.modes:
                self.second(f, a, body)

    def role_of(self, p, flat):
        """how the head uses an argument: PASSIVE, INPUT, OUTPUT, or BOTH when it only adds to it"""
        if p.name not in self.active:
            return "PASSIVE"
        assigned = {s.op for s in ir.every(flat.body) if isinstance(s, ir.Assign)
                    and s.target.name == p.name}
        if not assigned:
            return "INPUT"
        return "OUTPUT" if "=" in assigned else "BOTH"

    def second(self, flat, first, body):
        """tangent of the adjoint"""
        head = self.head
        names = first.companions.names
        adjoints = [ir.Parameter(names[p.name], "array", p.dims, False) for p in flat.params
                    if p.name in self.active]
        f = flat.copy()
        f.params = list(flat.params) + adjoints
        f.body = ir.copy_statements(body)
        inputs = sorted(self.active) + [p.name for p in adjoints]
        active = normal.activity(f, inputs, [p.name for p in adjoints])
        active |= self.active | {p.name for p in adjoints}
        t = Tangent(f, active, False)
        code = t.run()
        self.writers["b_d"] = write.Writer(
            f"{head.name}_b_d", write.parameters(flat.params, self.active, "b_d"), dict(f.locals),
            code)


class _Output:
    """One generated C file."""

    def __init__(self, source, mode):
        self.source, self.mode = source, mode
        self.functions, self.passive, self.tables, self.stack = [], {}, {}, False

    def add(self, one, mode):
        w = one.writers[mode]
        self.functions.append(one.flat_comment and list(one.flat_comment) or [])
        self.functions.append(w)
        called = {x.name for s in ir.every(w.body) for e in ir.own_expressions(s)
                  for x in ir.walk(e) if isinstance(x, ir.Call)}
        for name in reversed(one.passive_functions):  # who calls stands behind what it calls
            text = one.passive_functions[name]
            if name in called:
                called |= set(re.findall(r"\w+", text))
                self.passive = {name: text, **self.passive}
        used = ir.all_reads(w.body)
        self.tables.update({n: text for n, text in one.tables.items() if n in used})
        self.stack |= any(isinstance(s, ir.Stack) for s in ir.every(w.body))

    def text(self):
        name = os.path.basename(self.source)
        with open(self.source, encoding="utf-8") as f:
            includes = [x for x in re.findall(r'^#include ("[^"]+"|<[^>]+>)', f.read(), re.M)
                        if x not in ('"kernel.h"', '"vec.h"', "<math.h>")]
        lines = [f"/* {KIND[self.mode]} of core/kernel/{name}.",
                 " * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */",
                 '#include "maggi_ad.h"']
        lines += ["#include " + x for x in includes]
        if self.stack:
            lines.append('#include "adStack.h"')
        for text in [*self.tables.values(), *self.passive.values()]:
            lines += ["", text]
        for i in range(0, len(self.functions), 2):
            lines.append("")
            lines += write.comment_lines(self.functions[i], 0)
            lines += self.functions[i + 1].lines()
        return "\n".join(lines) + "\n"


def _header(done, includes):
    lines = ["/* Derivatives of the kernel.",
             " *",
             " *   _d    tangent                 arguments are followed by their derivatives",
             " *   _dv   vector tangent          derivatives have MAGGI_NDIR directions, the last index",
             " *   _b    adjoint                 adjoints of inputs are added to, those of outputs consumed",
             " *   _b_d  tangent of the adjoint",
             " *",
             " * Plain arguments hold the values of an evaluation, outputs too.  Arrays do not overlap.",
             " * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */",
             "#ifndef MAGGI_AD_H", "#define MAGGI_AD_H", ""]
    lines += [f'#include "{x}"' for x in includes]
    lines += ["", "/* directions of a strip; a build option (MAGGI_DIRECTIONS) */",
              "#ifndef MAGGI_NDIR", "#define MAGGI_NDIR 8", "#endif"]
    for one in done:
        lines.append("")
        for mode in one.head.modes:
            lines += one.writers[mode].signature(";")
    return "\n".join(lines + ["", "#endif"]) + "\n"


def _table(done):
    """the table of heads that tests run through"""
    lines = ["/* The heads as a table, for tests: see tools/tapenade/runtime/heads.h.",
             " * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */",
             '#include "heads.h"', "", "#include <stddef.h>", "", '#include "maggi_ad.h"']
    rows, sizes = [], {}
    for one in done:
        head = one.head
        topo = next((p for p in one.params if p.kind == "topo"), None)
        t = f"const {topo.type} *{topo.name}" if topo else "const maggi_topo *t"
        unused = [f"  (void){topo.name if topo else 't'};"]
        real = [p for p in one.params if p.kind in ("array", "double")]
        at = {p.name: i for i, p in enumerate(real)}
        short = re.sub(r"^maggi_", "", head.name)
        entries = []
        for p in real:
            size = " * ".join(write.text(d, 10) for d in p.dims) if p.kind == "array" else "1"
            size = size or "1"
            if (t, size) not in sizes:
                name = re.sub(r"_+", "_", re.sub(r"\W", "_", size.replace("->", "_"))).strip("_")
                sizes[t, size] = f"size_{re.sub(r'^t_', '', name)}"
                lines += ["", f"static int {sizes[t, size]}({t})", "{"]
                if f"{topo.name if topo else 't'}->" not in size:
                    lines += unused
                lines += write.wrap(f"return {size};", 1) + ["}"]
            entries.append(f'    {{"{p.name}", MAGGI_HEAD_{one.role[p.name]}, {sizes[t, size]}}},')
        lines += ["", f"static const maggi_head_argument {short}_arguments[] = {{"] + entries
        lines.append("};")
        thunks = []
        for mode in ("f", "d", "dv", "b", "b_d"):
            if mode != "f" and mode not in head.modes:
                thunks.append("NULL")
                continue
            sets = {"f": ["x"], "d": ["x", "xd"], "dv": ["x", "xd"], "b": ["x", "xb"],
                    "b_d": ["x", "xd", "xb", "xbd"]}[mode]
            args = []
            for p in one.params:
                if p.kind == "topo":
                    args.append(p.name)
                elif p.kind == "int":
                    args.append(head.integers.get(p.name, "0"))
                elif p.kind == "ints":
                    args.append("NULL")
                else:
                    i = at[p.name]
                    for s in sets:
                        if s != "x" and p.name not in one.active:
                            continue
                        by_value = p.kind == "double" and (s == "x" or s == "xd" and mode != "dv")
                        args.append(f"{s}[{i}][0]" if by_value else f"(void *){s}[{i}]")
            if mode == "dv":
                args.append("MAGGI_NDIR")
            name = f"{short}_call" + ("" if mode == "f" else "_" + mode)
            guard = mode == "dv"
            if guard:
                lines += ["", "#ifndef MAGGI_COMPLEX"]
            lines += ([] if guard else [""]) + write.call_lines(
                f"static void {name}(", [t] + [f"double *{s}[]" for s in sets], ")")
            call = f"  {head.name}{'' if mode == 'f' else '_' + mode}("
            lines += ["{"] + (unused if topo is None else []) + write.call_lines(call, args, ");")
            lines += ["}"]
            if guard:
                lines += ["#else", f"#define {name} NULL", "#endif"]
            thunks.append(name)
        rows += write.wrap(f'{{"{head.name}", {len(real)}, {short}_arguments, '
                           f"{', '.join(thunks)}}},", 1)
    lines += ["", "const maggi_head maggi_heads[] = {"] + rows + ["};"]
    lines += ["", f"const int maggi_nhead = {len(done)};"]
    return "\n".join(lines) + "\n"
