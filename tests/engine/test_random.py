"""Random programs of the subset: tangent, vector tangent and adjoint against the complex step, the
tangent of the adjoint against the complex step of the adjoint.

    MAGGI_RANDOM_PROGRAMS  how many (2000)
    MAGGI_RANDOM_SEED      the first seed (1)
    MAGGI_RANDOM_FLAGS     of the compiler (-O0, and locals that begin as NaN or large numbers)

A failure prints the seed and the program.  Programs are generated and compiled many at a time; when
that fails, each of them is tried on its own.
"""

import os
import shutil

import engine
import harness
import numpy
import pytest
from programs import HEADER, STRUCTURES, Program

PROGRAMS = int(os.environ.get("MAGGI_RANDOM_PROGRAMS", "2000"))
SEED = int(os.environ.get("MAGGI_RANDOM_SEED", "1"))
FLAGS = os.environ.get("MAGGI_RANDOM_FLAGS", "-O0 -ftrivial-auto-var-init=pattern").split()
BATCH = 50


def build(folder, programs):
    header = HEADER.replace(
        "} topo;\n", "} topo;\n\n" + "".join(f"{program.signature};\n" for program in programs)
    )
    text = '#include "kernel.h"\n\n' + "\n".join(program.text for program in programs)
    heads = [
        engine.Head(program.name, list(program.outputs), list(program.inputs))
        for program in programs
    ]
    return harness.Library(
        folder,
        {"kernel.h": header, "a.c": text},
        heads,
        structures=STRUCTURES,
        flags=(*FLAGS, "-w"),
    )


def check(library, head, program):
    """Message of the first failure, or None."""
    for structure in range(len(STRUCTURES)):
        try:
            harness.check(library.problem(head, structure), numpy.random.default_rng(program.seed))
        except AssertionError as error:
            return f"structure {structure}: {error}"
    return None


def alone(folders, program):
    """Why a program fails on its own, or None."""
    try:
        library = build(folders.mktemp(program.name), [program])
    except (engine.Refusal, harness.CompileError) as error:
        return f"{type(error).__name__}: {error}"
    except Exception as error:  # the engine itself
        return f"the engine raised {error!r}"
    return check(library, library.heads[0], program)


@pytest.mark.parametrize("first", range(SEED, SEED + PROGRAMS, BATCH))
def test_random(tmp_path_factory, monkeypatch, first):
    if "CC" not in os.environ and shutil.which("clang"):
        monkeypatch.setenv("CC", "clang")  # without optimisation several times faster than gcc
    programs = [Program(seed) for seed in range(first, min(first + BATCH, SEED + PROGRAMS))]
    failures = []
    try:
        library = build(tmp_path_factory.mktemp(f"batch{first}"), programs)
    except Exception:
        failures = [(program, alone(tmp_path_factory, program)) for program in programs]
        assert any(reason for _, reason in failures), "fails only in one file with others"
    else:
        failures = [
            (program, check(library, head, program))
            for program, head in zip(programs, library.heads)
        ]
    text = [
        f"seed {program.seed}: {reason}\n\n{program.text}\n  outputs {program.outputs} inputs "
        f"{program.inputs}"
        for program, reason in failures
        if reason
    ]
    if text:
        pytest.fail(
            f"{len(text)} of {len(programs)} programs\n\n" + "\n\n".join(text[:3]), pytrace=False
        )
