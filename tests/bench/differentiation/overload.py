#!/usr/bin/env python3
"""The kernel and the evaluation as C++ over a number type `real`, for tools that overload operators.

usage: overload.py CORE FOLDER

Writes FOLDER/kernel.inc from core/kernel and the lists of core/dynamics/data.h,
FOLDER/evaluate.inc from core/dynamics/evaluate.c, with the first part of accelerate as `reduce`, and
FOLDER/chain.inc, the forces of the open chain, from core/implicit/chain.c.
C++ has no parameters of variable length and no conversion from void *, and a tool may record the
copy of what is passed by value; rows are copied by the copy_rows of who includes: nothing else changes.  evaluation.inc includes both, perhaps twice, so there are no include guards.
"""
import pathlib
import re
import sys

FOREIGN = {"topo.h", "maggi/maggi.h"}               # as they are, by who includes the result
WITHOUT = {"energy.c", "reaction.c", "sensor.c"}    # no part of an evaluation
EVALUATE = ["maggi_constants", "maggi_evaluate_positions", "move", "accelerate"]
CHAIN = ["guide", "move", "resist", "sum", "maggi_chain_forces"]
REDUCE = r"(.*?)\baccelerate(\(.*?\bmaggi_reduced_force\([^;]*;\n)"  # all before the solve

RULES = [
    (r"(?s)\A(.*?)^#ifndef MAGGI_\w+_H\n#define MAGGI_\w+_H\n(.*)^#endif\n\Z", r"\1\2"),
    (r"^#include <.*\n", ""),
    (r"^#pragma omp .*\n", ""),
    (r"\bdouble\b", "real"),
    # an array in a parameter: its first length, where it is not a constant
    (r"(\breal \w+)\[[^\]]*[a-z][^\]]*\]", r"\1[]"),
    # a number in a parameter
    (r"([(,]\s*)real (\w+)(?=[,)])", r"\1const real &\2"),
    # product or number: two types where products are expressions
    (r"\? ([0-9.]+ \* [^?:;]+) : ([^?:;]+);", r"? real(\1) : real(\2);"),
    (r"\bvoid \*(\w+) =", r"auto *\1 ="),
    (r"\bmemcpy\((\S+), (\S+), (.*) \* sizeof \*\1\);", r"copy_rows(\1, \2, \3);"),
]


def overload(text):
    for pattern, replacement in RULES:
        text = re.sub(pattern, replacement, text, flags=re.MULTILINE)
    return text


def with_includes(path, seen):
    """A file of the kernel as C++, after what it includes and nobody has included before."""
    if path.name in seen:
        return ""
    seen.add(path.name)
    return re.sub(r'^#include "(.*)"\n',
                  lambda include: "" if include[1] in FOREIGN else
                  with_includes(path.parent / include[1], seen),
                  overload(path.read_text(encoding="utf-8")), flags=re.MULTILINE)


def find(pattern, path, what):
    found = re.findall(pattern, path.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
    if not found:
        sys.exit(f"overload.py: {path}: {what} is not there")
    return found


def take(names, path):
    """Functions of a file as C++."""
    return [overload(find(rf"^(?:static )?void {name}\(.*?^}}\n", path, name)[0]) for name in names]


def write(path, parts):
    path.write_text("/* by overload.py */\n" + "\n".join(parts), encoding="utf-8")


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__.split("\n\n")[1])
    core, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    seen = set()
    parts = find(r"^#define MAGGI_\w+\(X\).*?[^\\]\n", core / "dynamics/data.h", "a list")
    parts += [with_includes(path, seen) for path in sorted((core / "kernel").glob("*.c"))
              if path.name not in WITHOUT]
    write(folder / "kernel.inc", parts)
    evaluate = core / "dynamics/evaluate.c"
    functions = take(EVALUATE, evaluate)
    reduce = re.match(REDUCE, functions[-1], flags=re.DOTALL)
    if not reduce:
        sys.exit(f"overload.py: {evaluate}: accelerate has no reduced force")
    write(folder / "evaluate.inc", functions + [f"{reduce[1]}reduce{reduce[2]}}}\n"])
    write(folder / "chain.inc", take(CHAIN, core / "implicit/chain.c"))


if __name__ == "__main__":
    main()
