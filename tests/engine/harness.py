"""Generate, compile and check derivatives of small C programs.

A Library is compiled twice: with real numbers, and with complex ones, where the plain function
gives derivatives by the complex step and the adjoint gives them for the tangent of the adjoint.
A shim in C gives each function one shape: (structure, array of pointers, .. of companions).

Semantics that `check` expects: see tools/tapenade/README.md, "Conventions, of both engines".
"""

import ctypes
import dataclasses
import os
import pathlib
import re
import shlex
import subprocess

import numpy

import engine

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
RUNTIME = ROOT / "tools" / "tapenade" / "runtime"
MODES = ("d", "dv", "b", "b_d")
STEP = 2.0**-100
# vla-parameter: gcc 12 takes the same text of prototype and definition for different bounds
WARNINGS = ("-Wall", "-Wextra", "-Werror", "-Wno-unknown-warning-option", "-Wno-vla-parameter")
FLAGS = ("-O2", *WARNINGS)

# companions of an array, and how a scalar takes them
COMPANIONS = {
    "f": [],
    "d": ["d"],
    "dv": ["d"],
    "b": ["b"],
    "b_d": ["d", "b", "bd"],
}
BY_VALUE = {"", "d"}  # of a scalar in f, d and b_d


class CompileError(Exception):
    """What the compiler said about generated code."""


@dataclasses.dataclass
class Argument:
    """One argument of a head: kind is structure, int, scalar or array; dims are C expressions."""

    name: str
    kind: str
    dims: list
    role: str = "passive"  # of what is double: passive, input, output, both


def commas(text):
    """Split at commas outside of brackets."""
    parts, depth = [""], 0
    for c in text:
        depth += (c in "([") - (c in ")]")
        if c == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += c
    return [part.strip() for part in parts]


def signature(head, text):
    """Arguments of the definition of a head in C text."""
    match = re.search(rf"\b{head.name}\s*\(([^{{;]*)\)\s*{{", text)
    assert match, f"{head.name} is not defined"
    arguments = []
    for part in commas(match[1]):
        name = re.search(r"(\w+)\s*(\[.*\])?$", part)
        dims = re.findall(r"\[((?:[^\[\]]|\[[^\]]*\])*)\]", name[2] or "")
        if "double" not in part:
            kind = "structure" if "*" in part else "int"
            arguments.append(Argument(name[1], kind, dims))
            continue
        role = {
            (False, False): "passive",
            (True, False): "input",
            (False, True): "output",
            (True, True): "both",
        }[name[1] in head.inputs, name[1] in head.outputs]
        arguments.append(Argument(name[1], "array" if dims else "scalar", dims, role))
    return arguments


def shim(head, arguments, modes):
    """C text: sizes of the double arguments, and one function of one shape for each mode."""
    doubles = [a for a in arguments if a.kind in ("scalar", "array")]
    t = next((a.name for a in arguments if a.kind == "structure"), "t")
    integers = "".join(f"  const int {name} = {value};\n" for name, value in head.integers.items())
    sizes = ", ".join("*".join(f"({d})" for d in a.dims) or "1" for a in doubles)
    out = [
        f"int size_{head.name}(const structure *{t}, int argument)\n{{\n{integers}"
        f"  const int size[] = {{{sizes}}};\n\n  return size[argument];\n}}\n"
    ]
    for mode in ("f", *modes):
        call = []
        number = 0
        for a in arguments:
            if a.kind == "structure":
                call.append(t)
            elif a.kind == "int":
                call.append(a.name)
            else:
                companions = COMPANIONS[mode] if a.role != "passive" else []
                for suffix in ["", *companions]:
                    value = (
                        a.kind == "scalar" and suffix in BY_VALUE and not (suffix and mode == "dv")
                    )
                    call.append(f"{'*' if value else '(void *)'}x{suffix}[{number}]")
                number += 1
        if mode == "dv":
            call.append("MAGGI_NDIR")
        name = head.name if mode == "f" else f"{head.name}_{mode}"
        parameters = "".join(f", double **x{suffix}" for suffix in ["", *COMPANIONS[mode]])
        out.append(
            f"void call_{head.name}_{mode}(const structure *{t}{parameters})\n{{\n{integers}"
            f"  {name}({', '.join(call)});\n}}\n"
        )
    return "\n".join(out)


def compile_library(output, files, flags, includes):
    command = [
        *shlex.split(os.environ.get("CC", "cc")),
        "-std=gnu17",
        "-fPIC",
        "-shared",
        "-fopenmp-simd",
        *flags,
        *(f"-I{folder}" for folder in includes),
        "-o",
        output,
        *files,
        "-lm",
    ]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise CompileError("\n".join(done.stderr.splitlines()[:40]))


class Library:
    """Plain and generated functions of some heads.

    files      name -> C text; all .c files are differentiated
    heads      engine.Head, their sources are filled in here
    structure  type of the first argument of the heads; `structures` are initialisers of values
    header     declares the heads and the structure
    """

    def __init__(
        self,
        folder,
        files,
        heads,
        structure="topo",
        structures=("{0}",),
        modes=MODES,
        flags=FLAGS,
        width=8,
        header="kernel.h",
    ):
        self.folder, self.heads, self.modes, self.width = folder, heads, modes, width
        source, generated = folder / "source", folder / "generated"
        source.mkdir()
        generated.mkdir()
        for name, text in files.items():
            (source / name).write_text(text, encoding="utf-8")
        names = [name for name in files if name.endswith(".c")]
        text = "\n".join(files[name] for name in names)
        for head in heads:
            head.sources, head.modes = names, list(modes)
        self.arguments = {head.name: signature(head, text) for head in heads}
        self.files = engine.differentiate(
            [str(source / name) for name in names], heads, [str(source)], includes=(header,)
        )
        for name, content in self.files.items():
            (generated / name).write_text(content, encoding="utf-8")

        complex_modes = [mode for mode in modes if mode == "b"]
        runtime = sorted(RUNTIME.glob("*.c"))
        self.library = {}
        for kind, shim_modes in (("real", modes), ("complex", complex_modes)):
            main = folder / f"shim_{kind}.c"
            main.write_text(
                '#pragma GCC diagnostic ignored "-Wunused-parameter"\n'
                '#pragma GCC diagnostic ignored "-Wunused-variable"\n'
                f'#include "{header}"\n#include "maggi_ad.h"\n\ntypedef {structure} structure;\n\n'
                + "static const structure all[] = {"
                + ", ".join(structures)
                + "};\n\n"
                "const structure *structure_of(int k)\n{\n  return &all[k];\n}\n\n"
                + "\n".join(shim(h, self.arguments[h.name], shim_modes) for h in heads),
                encoding="utf-8",
            )
            plain = [source / name for name in names]
            chosen = [
                generated / f"{name[:-2]}_{mode}.c"
                for name in names
                for mode in shim_modes
                if f"{name[:-2]}_{mode}.c" in self.files
            ]
            extra = [f"-DMAGGI_NDIR={width}", *flags]
            if kind == "complex":
                extra += ["-w", "-include", HERE / "complex_step.h"]
            output = folder / f"{kind}.so"
            compile_library(
                output, [main, *plain, *chosen, *runtime], extra, [source, generated, RUNTIME]
            )
            self.library[kind] = ctypes.CDLL(output)
            self.library[kind].structure_of.restype = ctypes.c_void_p

    def problem(self, head, structure=0):
        return Problem(self, head, structure)


def aligned(shape, dtype=float):
    """An array that begins at a multiple of 64 bytes, as generated code may expect."""
    n = int(numpy.prod(shape)) * numpy.dtype(dtype).itemsize
    buffer = numpy.zeros(n + 64, dtype=numpy.uint8)
    start = -buffer.ctypes.data % 64
    return buffer[start : start + n].view(dtype).reshape(shape)


class Problem:
    """One head with one structure; calls take and return lists of flat arrays, one an argument."""

    def __init__(self, library, head, structure):
        self.library, self.head = library, head
        self.structure = {
            kind: ctypes.c_void_p(so.structure_of(structure))
            for kind, so in library.library.items()
        }
        self.arguments = [a for a in library.arguments[head.name] if a.kind in ("scalar", "array")]
        size = library.library["real"]["size_" + head.name]
        self.sizes = [size(self.structure["real"], k) for k in range(len(self.arguments))]
        self.roles = [a.role for a in self.arguments]
        self.functions = {}

    def where(self, *roles):
        return [k for k, role in enumerate(self.roles) if role in roles]

    def call(self, mode, *groups, kind="real"):
        """Copies the arrays of each group (x, xd, xb, xbd as the mode has them), calls, returns
        the copies."""
        copies = []
        for group in groups:
            copies.append([])
            for values in group:
                dtype = complex if kind == "complex" else float
                array = aligned(numpy.shape(values), dtype)
                array[...] = values
                copies[-1].append(array)
        key = (mode, kind)
        if key not in self.functions:
            function = self.library.library[kind][f"call_{self.head.name}_{mode}"]
            function.restype = None
            self.functions[key] = function
        pointers = [
            (ctypes.c_void_p * len(group))(*(a.ctypes.data for a in group)) for group in copies
        ]
        self.functions[key](self.structure[kind], *pointers)
        return copies

    def step(self, x, xd):
        """Plain function at x with imaginary parts along xd."""
        point = [a + (1j * STEP) * numpy.nan_to_num(d) for a, d in zip(x, xd)]
        return self.call("f", point, kind="complex")[0]


def flat(arrays, which):
    return numpy.concatenate([numpy.ravel(arrays[k]) for k in which] or [numpy.zeros(0)])


@dataclasses.dataclass
class Residuals:
    """Largest errors over the tolerance that `check` allows."""

    d: float = 0.0
    dv: float = 0.0
    b: float = 0.0
    b_d: float = 0.0
    dot: float = 0.0
    symmetry: float = 0.0


def check(problem, rng, ranges=None, modes=None, tolerance=1e-12, second=1e-11):
    """All modes of a head at a random point; AssertionError says which one is wrong where.

    Tangents are compared relative to the largest sum |J_ij xd_j|, adjoints to the largest
    sum |yb_i J_ij|: what round-off of a correct code can be.
    Returns the largest relative errors and the Jacobian.
    """
    p, modes = problem, modes or problem.library.modes
    inputs, outputs = p.where("input"), p.where("output")
    both, ends = p.where("both"), p.where("output", "both")
    active = p.where("input", "output", "both")
    names = [a.name for a in p.arguments]
    width = p.library.width
    found = Residuals()

    def random(k):
        low, high = (ranges or {}).get(names[k], (-1.5, 1.5))
        return rng.uniform(low, high, p.sizes[k])

    def garbage():
        return [rng.uniform(-1.0, 1.0, n) for n in p.sizes]

    def same(got, expected, k, what):
        """exactly, NaN included"""
        assert numpy.array_equal(
            got[k], expected[k], equal_nan=True
        ), f"{p.head.name}: {what} of {names[k]}: {got[k]}, not {expected[k]}"

    def near(got, expected, k, scale, bound, what):
        error = numpy.abs(numpy.asarray(got) - expected)
        worst = numpy.max(error, initial=0.0) / scale
        assert not numpy.isnan(got).any() and worst <= bound, (
            f"{p.head.name}: {what} of {names[k]}: relative error {worst:.2e}\n"
            f"  got      {numpy.array2string(numpy.asarray(got), max_line_width=100)}\n"
            f"  expected {numpy.array2string(numpy.asarray(expected), max_line_width=100)}"
        )
        return worst

    # plain values: x0 before the call, x after; what the function does not write stays NaN
    x0 = [random(k) for k in range(len(names))]
    for k in outputs:
        x0[k][:] = numpy.nan
    x = p.call("f", x0)[0]
    written = {k: ~numpy.isnan(x[k]) for k in outputs}
    written.update({k: numpy.ones(p.sizes[k], bool) for k in both})
    assert any(mask.any() for mask in written.values()), f"{p.head.name} writes nothing"
    for k in p.where("passive", "input"):
        same(x, x0, k, "plain value")

    # Jacobian of all written outputs (rows) by inputs, then initial values of accumulated outputs
    columns = []
    for k in inputs + both:
        for i in range(p.sizes[k]):
            xd = [numpy.zeros(n) for n in p.sizes]
            xd[k][i] = 1.0
            y = p.step(x0, xd)
            columns.append(numpy.concatenate([y[m].imag[written[m]] / STEP for m in ends]))
    J = numpy.array(columns).T.reshape(sum(int(written[m].sum()) for m in ends), -1)
    assert numpy.isfinite(J).all(), f"{p.head.name}: the reference is not finite"
    largest = numpy.abs(J).max(initial=0.0)

    def rows(arrays):
        return numpy.concatenate([arrays[m][written[m]] for m in ends])

    def directions():
        """derivatives of inputs; accumulated outputs begin with one, overwritten ones with NaN"""
        xd = garbage()
        for k in outputs:
            xd[k][:] = numpy.nan
        for k in p.where("passive"):
            xd[k][:] = 0.0
        return xd

    def tangent(xd):
        """of the plain function, by complex step; NaN where it does not write"""
        y = p.step(x0, xd)
        yd = [a.copy() for a in xd]
        for m in ends:
            yd[m][written[m]] = y[m].imag[written[m]] / STEP
        return yd

    xd = directions()
    yd = tangent(xd)
    scale = (numpy.abs(J) @ numpy.abs(flat(xd, inputs + both))).max(initial=1e-300)
    if "d" in modes:
        got, gotd = p.call("d", x, xd)
        for k in range(len(names)):
            same(got, x, k, "d: plain value")
        for k in inputs:
            same(gotd, xd, k, "d: derivative")
        for k in ends:
            found.d = max(
                found.d,
                near(gotd[k][written[k]], yd[k][written[k]], k, scale, tolerance, "d: tangent"),
            )
            unwritten = ~written[k]
            assert numpy.isnan(gotd[k][unwritten]).all(), f"d: {names[k]} written where f does not"

    if "dv" in modes:
        several = [directions() for _ in range(width)]
        refs = [tangent(one) for one in several]
        stacked = [
            numpy.ascontiguousarray(numpy.stack([one[k] for one in several], axis=-1))
            for k in range(len(names))
        ]
        got, gotd = p.call("dv", x, stacked)
        bound = max(
            (numpy.abs(J) @ numpy.abs(flat(one, inputs + both))).max(initial=1e-300)
            for one in several
        )
        for k in range(len(names)):
            same(got, x, k, "dv: plain value")
        for k in inputs:
            same(gotd, stacked, k, "dv: derivative")
        for k in ends:
            ref = numpy.stack([one[k] for one in refs], axis=-1)
            found.dv = max(
                found.dv,
                near(gotd[k][written[k]], ref[written[k]], k, bound, tolerance, "dv: tangent"),
            )

    def seeds():
        """adjoints: weights of outputs (NaN where nothing is written), garbage under inputs"""
        xb = garbage()
        for k in outputs:
            xb[k][~written[k]] = numpy.nan
        return xb

    def consumed(got, start, what):
        for k in outputs:
            assert (
                got[k][written[k]] == 0.0
            ).all(), f"{p.head.name}: {what} of {names[k]} is not left zero: {got[k]}"
        for k in both:
            same(got, start, k, what)

    if "b" in modes:
        xb = seeds()
        weights = rows(xb)
        gradient = numpy.split(weights @ J, numpy.cumsum([p.sizes[k] for k in inputs + both]))
        got, gotb = p.call("b", x, xb)
        bound = max(
            (numpy.abs(weights) @ numpy.abs(J)).max(initial=1e-300),
            numpy.abs(flat(xb, inputs)).max(initial=0.0),
        )
        for k in range(len(names)):
            same(got, x, k, "b: plain value")
        consumed(gotb, xb, "b: adjoint")
        for k, g in zip(inputs, gradient):
            found.b = max(found.b, near(gotb[k], xb[k] + g, k, bound, tolerance, "b: adjoint"))
        # yb.yd = xb.xd with the codes themselves, adjoints begun from zero
        if "d" in modes:
            zero = [a if k in ends else 0.0 * a for k, a in enumerate(xb)]
            _, gotb = p.call("b", x, zero)
            _, gotd = p.call("d", x, xd)
            left = weights @ rows(gotd)
            right = flat(gotb, inputs) @ flat(xd, inputs) + flat(xb, both) @ flat(xd, both)
            size = numpy.abs(weights) @ numpy.abs(J) @ numpy.abs(flat(xd, inputs + both))
            found.dot = abs(left - right) / max(size, 1e-300)
            assert found.dot <= tolerance, f"{p.head.name}: dot product {left} {right}"

    if "b_d" in modes:
        xb, xbd = seeds(), seeds()
        point = p.step(x0, xd)  # inputs and outputs along xd
        adjoint = [a + (1j * STEP) * b for a, b in zip(xb, xbd)]
        reference = p.call("b", point, adjoint, kind="complex")[1]
        got, gotd, gotb, gotbd = p.call("b_d", x, yd, xb, xbd)
        for k in range(len(names)):
            same(got, x, k, "b_d: plain value")
            same(gotd, yd, k, "b_d: derivative")
        consumed(gotb, xb, "b_d: adjoint")
        consumed(gotbd, xbd, "b_d: derivative of the adjoint")
        bound = max(
            numpy.abs(flat(reference, inputs).imag / STEP).max(initial=0.0),
            numpy.abs(flat(reference, inputs).real).max(initial=0.0),
            1.0,
            largest,
        )
        for k in inputs:
            near(gotb[k], reference[k].real, k, bound, tolerance, "b_d: adjoint")
            found.b_d = max(
                found.b_d,
                near(
                    gotbd[k],
                    reference[k].imag / STEP,
                    k,
                    bound,
                    second,
                    "b_d: derivative of the adjoint",
                ),
            )
        # symmetric: u.(H w) = w.(H u)
        u, w = directions(), directions()
        zero = [numpy.zeros(n) for n in p.sizes]
        begin = [xb[k] if k in ends else zero[k] for k in range(len(names))]
        for k in both:
            u[k][:] = 0.0
            w[k][:] = 0.0
        Hu = p.call("b_d", x, tangent(u), begin, zero)[3]
        Hw = p.call("b_d", x, tangent(w), begin, zero)[3]
        left = flat(w, inputs) @ flat(Hu, inputs)
        right = flat(u, inputs) @ flat(Hw, inputs)
        size = max(
            numpy.abs(flat(w, inputs)) @ numpy.abs(flat(Hu, inputs)),
            numpy.abs(flat(u, inputs)) @ numpy.abs(flat(Hw, inputs)),
            1.0,
            largest,
        )
        found.symmetry = abs(left - right) / size
        assert found.symmetry <= second, f"{p.head.name}: second derivatives {left} {right}"
    return found, J
