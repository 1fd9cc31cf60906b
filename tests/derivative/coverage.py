#!/usr/bin/env python3
"""Both outcomes of every branch of the heads and of their derivatives, measured by gcov.

    coverage.py GCOV OBJECTS PROGRAM ARGUMENTS..

PROGRAM runs; OBJECTS is the folder of what was compiled with --coverage: kernel sources, of which the
functions that ran count, and generated ones, of which every function must have run.  What is missing
is printed, `file.c:12: function: outcome 2 of 2 never taken: if (x > 0)`, and the exit code is 1.
"""

import json
import pathlib
import subprocess
import sys

# (function without the suffix of its derivative, text in the line): reason
EXCEPTIONS = {}


def measure(gcov, objects):
    """What gcov knows of each source file; one that was never entered has no counts.

    Names are relative to the folder of the compiler where it was called with relative ones, as ccache does.
    """
    notes = sorted(objects.rglob("*.gcno"))
    if not notes:
        sys.exit(f"{objects}: nothing was compiled with --coverage")
    for note in notes:
        output = subprocess.run([gcov, "--branch-probabilities", "--json-format", "--stdout", note],
                                capture_output=True, check=True, text=True).stdout
        for line in output.splitlines():
            unit = json.loads(line)
            for file in unit["files"]:
                yield pathlib.Path(unit["current_working_directory"], file["file"]).resolve(), file


def source_name(function):
    """The name in the source: CMakeLists.txt calls maggi_x covered_x."""
    return function.replace("covered_", "maggi_", 1) if function.startswith("covered_") else function


def excepted(function, text):
    for (name, part), _ in EXCEPTIONS.items():
        if part in text and function in (name, *(name + end for end in ("_d", "_dv", "_b", "_b_d"))):
            return True
    return False


def missing(path, lines, functions):
    """Lines of a report on one source file, and the number of outcomes in it."""
    text = path.read_text(encoding="utf-8").splitlines()
    found, outcomes = [], 0
    for name, count in functions.items():
        if count == 0 and path.parent.name == "ad_generated":
            found.append(f"{path.name}: {source_name(name)}: never called")
    for line in lines:
        name, number = line.get("function_name"), line["line_number"]
        if not functions.get(name):
            continue
        branches = [branch for branch in line["branches"] if not branch["throw"]]
        outcomes += len(branches)
        for k, branch in enumerate(branches):
            if branch["count"] == 0 and not excepted(source_name(name), text[number - 1]):
                found.append(f"{path.name}:{number}: {source_name(name)}: outcome {k + 1} of {len(branches)} "
                             f"never taken: {text[number - 1].strip()}")
    return found, outcomes


def main():
    gcov, objects, program = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
    for data in objects.rglob("*.gcda"):
        data.unlink()
    run = subprocess.run(program, stdout=subprocess.DEVNULL, check=False)
    if run.returncode != 0:
        sys.exit(f"{program[0]} failed")
    report, files, functions, outcomes = [], 0, 0, 0
    for path, file in measure(gcov, objects):
        if path.suffix != ".c" or path.parent.name not in ("kernel", "ad_generated"):
            continue
        if not path.exists():
            continue  # of an earlier build
        called = {f["name"]: f["execution_count"] for f in file["functions"]}
        found, number = missing(path, file["lines"], called)
        report += found
        files += 1
        functions += sum(count > 0 for count in called.values())
        outcomes += number
    print("\n".join(report))
    print(f"{files} files, {functions} functions, {outcomes} outcomes of branches, "
          f"{len(report)} missing, {len(EXCEPTIONS)} exceptions")
    return 1 if report or outcomes == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
