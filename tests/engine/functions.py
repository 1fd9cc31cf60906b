"""Functions in C whose arguments have a meaning by name: heads, files and libraries of them."""

import re

import engine
import harness
import numpy
from programs import HEADER, STRUCTURES

CONSTRUCTS = {
    path.stem: path.read_text(encoding="utf-8")
    for path in sorted((harness.HERE / "constructs").glob("*.c"))
}
# arguments of functions that are written here; `c` is passive, F is only added to
ARGUMENTS = {
    "p": "const double p[t->np]",
    "q": "const double q[t->n]",
    "X": "const double X[t->n + 1][3]",
    "s": "double s",
    "c": "const double c[t->n]",
    "y": "double y[t->n]",
    "e": "double e[1]",
    "F": "double F[t->n + 1][3]",
}
PROTOTYPE = re.compile(r"^(void (\w+)\([^{;]*\))\s*{", re.M)


def define(name, body):
    """Text of a function whose arguments are those of ARGUMENTS that the body names."""
    used = [x for x in ARGUMENTS if re.search(rf"\b{x}\b" + r"(\[|[,)])" * (x != "s"), body)]
    return f"void {name}(const topo *t, {', '.join(ARGUMENTS[x] for x in used)})\n{{{body}}}\n\n"


def heads(text, modes=harness.MODES):
    """Heads of all functions of a text: what is const is an input, `c` apart."""
    found = []
    for signature, name in PROTOTYPE.findall(text):
        arguments = harness.commas(signature.split("(", 1)[1][:-1])
        real = {re.search(r"(\w+)(\[.*)?$", x)[1]: x for x in arguments if "double" in x}
        outputs = [x for x, text in real.items() if "[" in text and "const" not in text]
        inputs = [x for x in real if x not in outputs and x != "c"] + ["F"] * ("F" in outputs)
        found.append(engine.Head(name, outputs, inputs, list(modes)))
    return found


def files(text):
    """The text as a file, and the header that declares its functions."""
    declared = "".join(f"{signature};\n" for signature, _ in PROTOTYPE.findall(text))
    return {
        "kernel.h": HEADER[: -len("#endif\n")] + declared + "\n#endif\n",
        "a.c": text if text.startswith("/*") else '#include "kernel.h"\n\n' + text,
    }


def check(library, head, points=4, ranges=None):
    seen = 0.0
    for structure in range(len(STRUCTURES)):
        for seed in range(points):
            _, J = harness.check(
                library.problem(head, structure), numpy.random.default_rng(seed), ranges
            )
            seen = max(seen, numpy.abs(J).max())
    assert seen > 0.0, "the derivative is identically zero"


def generate(folder, text, modes=harness.MODES):
    """Text of the generated files."""
    for name, content in files(text).items():
        (folder / name).write_text(content, encoding="utf-8")
    return engine.differentiate([str(folder / "a.c")], heads(text, modes), [str(folder)])


class Group:
    """Functions that are compiled together; when that fails, each one is on its own."""

    def __init__(self, folders, text, **options):
        self.folders, self.text, self.options = folders, text, options
        self.heads = {head.name: head for head in heads(text)}
        try:
            self.library = self.build(self.heads.values())
        except (engine.Refusal, harness.CompileError):
            self.library = None

    def build(self, some):
        return harness.Library(
            self.folders.mktemp("group"),
            files(self.text),
            list(some),
            structures=STRUCTURES,
            **self.options,
        )

    def check(self, name, **options):
        head = self.heads[name]
        check(self.library or self.build([head]), head, **options)
