"""The driver of Tapenade with a program that plays its part: it looks at the command line and answers
with files as Tapenade 3.16 writes them, or with what can go wrong."""

import ctypes
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOLS = ROOT / "tools" / "tapenade"
sys.path.insert(0, str(TOOLS))

import engine  # noqa: E402  needs the path
import engine_tapenade  # noqa: E402
from tapenade_answers import ANSWERS, KERNEL_H, SCALE_C, TOPO_H  # noqa: E402

FAKE = """#!{python}
import json, os, sys
arguments, folder = sys.argv[1:], os.environ["FAKE_FOLDER"]
with open(os.path.join(folder, "log"), "a") as log:
    json.dump(arguments, log)
    log.write("\\n")
answers = json.load(open(os.path.join(folder, "answers")))
source = open(arguments[-1]).read()
assert "MAGGI_RE" not in source and "KIND_" not in source
mode = ("b" if "-b" in arguments else "dv" if "-vector" in arguments else "d")
name = os.path.basename(arguments[-1])[:-2] + "_" + mode
print("@@ Creating", name)
for end, text in answers.get(name, {{}}).items():
    if end == "say":
        print(text)
    elif end == "status":
        sys.exit(text)
    else:
        open(os.path.join(arguments[arguments.index("-O") + 1], name + end), "w").write(text)
"""


class Case:
    """A kernel of one head, a fake Tapenade and what it answers."""

    def __init__(self, folder, monkeypatch):
        self.folder = folder
        self.kernel = folder / "kernel"
        self.kernel.mkdir()
        (self.kernel / "topo.h").write_text(TOPO_H)
        (self.kernel / "kernel.h").write_text(KERNEL_H)
        (self.kernel / "scale.c").write_text(SCALE_C)
        home = folder / "tapenade_3.16"
        self.program = home / "bin" / "tapenade"
        self.program.parent.mkdir(parents=True)
        self.program.write_text(FAKE.format(python=sys.executable))
        self.program.chmod(0o755)
        self.rules = home / "ADFirstAidKit" / "PUSHPOPGeneralLib"
        self.rules.parent.mkdir()
        self.rules.write_text("")
        self.answers = {name[:-2]: {".c": text, ".msg": "\n"} for name, text in ANSWERS.items()}
        self.head = engine.Head("maggi_scale", ["y", "total"], ["p", "x", "total"],
                                ["d", "dv", "b", "b_d"], ["scale.c"], {"kind": "1"})
        monkeypatch.setenv("FAKE_FOLDER", str(folder))

    def run(self):
        (self.folder / "answers").write_text(json.dumps(self.answers))
        return engine_tapenade.differentiate(
            [self.kernel / "scale.c"], [self.head], [str(self.kernel)], str(self.program)
        )

    def fails(self):
        with pytest.raises(engine_tapenade.TapenadeError) as error:
            self.run()
        assert "\n" not in str(error.value)
        return str(error.value)

    def log(self):
        return [json.loads(line) for line in (self.folder / "log").read_text().splitlines()]


@pytest.fixture
def case(tmp_path, monkeypatch):
    return Case(tmp_path, monkeypatch)


def test_command_lines(case):
    files, version, commands = case.run()
    assert sorted(files) == ["heads.c", "maggi_ad.h", "scale_b.c", "scale_b_d.c", "scale_d.c",
                             "scale_dv.c"]
    assert version == "3.16 (develop)"
    tangent = ["-fixinterface", "-copyname", "%_nd_d"]
    assert case.log() == [
        ["-d", *tangent, "-head", "maggi_scale(y,total)/(p,x,total,y)", "-O", "d", "scale.c"],
        ["-d", "-vector", "-fixinterface", "-copyname", "%_nd_dv",
         "-head", "maggi_scale(y,total)/(p,x,total,y)", "-O", "dv", "scale.c"],
        ["-b", "-fixinterface", "-copyname", "%_nd_b",
         "-head", "maggi_scale(p,x,total,y)/(p,x,total,y)", "-O", "b", "scale.c"],
        ["-d", "-fixinterface", "-copyname", "%_nd_b_d", "-ext", str(case.rules),
         "-head", "maggi_scale_b(pb,xb,totalb,yb)/(p,x,total,pb,xb,totalb,yb)",
         "-O", "b_d", "scale_b.c"],
    ]
    assert len(commands) == 4
    assert commands[0] == ("tapenade -d -fixinterface -copyname %_nd_d -head "
                           "'maggi_scale(y,total)/(p,x,total,y)' -O d scale.c")
    assert str(case.folder) not in "".join(commands) + "".join(files.values())


def test_results_are_right(case, tmp_path):
    """As compiled C, for both kinds: against the derivatives by hand, from garbage, outputs kept."""
    files, _, _ = case.run()
    build = tmp_path / "build"
    build.mkdir()
    for name, text in files.items():
        (build / name).write_text(text)
    shutil.copy(TOOLS / "runtime" / "adStack.c", build)
    library = build / "scale.so"
    command = [os.environ.get("CC", "cc"), "-std=gnu17", "-Wall", "-Wextra", "-Werror", "-O1",
               "-shared", "-fPIC", "-DMAGGI_NDIR=8", f"-I{build}", f"-I{case.kernel}",
               f"-I{TOOLS / 'runtime'}", "-o", library, *build.glob("*.c"), case.kernel / "scale.c",
               "-lm"]
    subprocess.run(command, check=True)
    c = ctypes.CDLL(str(library))

    class Topo(ctypes.Structure):
        _fields_ = [("n", ctypes.c_int), ("first", ctypes.c_void_p)]

    n, random_number = 3, random.Random(1)
    topo = Topo(n, None)

    def numbers(count):
        return (ctypes.c_double * count)(*(random_number.uniform(-2, 2) for _ in range(count)))

    def value(kind, w, p, x):
        return [w * p * v * v if kind == 1 and v > 0 else p * v for v in x]

    for kind in (0, 1):
        w = 0.7
        p, x, pd, xd, xdv, pdv = (numbers(k) for k in (1, 2 * n, 1, 2 * n, 16 * n, 8))
        y = (ctypes.c_double * (2 * n))(*value(kind, w, p[0], x))
        total = (ctypes.c_double * 1)(p[0] * sum(x[::2]))
        held = list(y), list(total)
        first = (ctypes.byref(topo), kind, ctypes.c_double(w))
        square = [kind == 1 and v > 0 for v in x]
        by_p = [w * v * v if s else v for s, v in zip(square, x)]
        by_x = [2 * w * p[0] * v if s else p[0] for s, v in zip(square, x)]

        yd, totald = numbers(2 * n), numbers(1)
        before = totald[0]
        c.maggi_scale_d(*first, p, pd, x, xd, y, yd, total, totald)
        assert list(yd) == pytest.approx([a * pd[0] + b * d for a, b, d in zip(by_p, by_x, xd)])
        rate = sum(x[2 * i] * pd[0] + p[0] * xd[2 * i] for i in range(n))
        assert totald[0] - before == pytest.approx(rate)

        ydv, totaldv = numbers(16 * n), (ctypes.c_double * 8)()
        c.maggi_scale_dv(*first, p, pdv, x, xdv, y, ydv, total, totaldv, 8)
        for i in range(2 * n):
            for k in range(8):
                assert ydv[8 * i + k] == pytest.approx(by_p[i] * pdv[k] + by_x[i] * xdv[8 * i + k])

        pb, xb, yb, totalb = (numbers(k) for k in (1, 2 * n, 2 * n, 1))
        pb0, xb0, yb0, totalb0 = list(pb), list(xb), list(yb), totalb[0]
        c.maggi_scale_b(*first, p, pb, x, xb, y, yb, total, totalb)
        assert list(yb) == [0.0] * (2 * n) and totalb[0] == totalb0
        grow_p = sum(a * b for a, b in zip(by_p, yb0)) + totalb0 * sum(x[::2])
        grow_x = [b * v + (p[0] * totalb0 if i % 2 == 0 else 0.0)
                  for i, (b, v) in enumerate(zip(by_x, yb0))]
        assert pb[0] - pb0[0] == pytest.approx(grow_p)
        assert [a - b for a, b in zip(xb, xb0)] == pytest.approx(grow_x)

        # the tangent of the adjoint: differences of the adjoint, whose part in x is of degree two
        pbd, xbd, ybd, totalbd = (numbers(k) for k in (1, 2 * n, 2 * n, 1))
        start, yd = list(xbd), numbers(2 * n)
        ybd0, totalbd0, totald0 = list(ybd), totalbd[0], totald[0]
        xb = (ctypes.c_double * (2 * n))()
        yb = (ctypes.c_double * (2 * n))(*yb0)
        c.maggi_scale_b_d(*first, p, pd, pb, pbd, x, xd, xb, xbd, y, yd, yb, ybd,
                          total, totald, totalb, totalbd)
        assert list(xb) == pytest.approx(grow_x)
        by_xd = [2 * w * (pd[0] * v + p[0] * d) if s else pd[0]
                 for s, v, d in zip(square, x, xd)]
        expected = [bd * v + b * vd + (pd[0] * totalb0 + p[0] * totalbd0 if i % 2 == 0 else 0.0)
                    for i, (bd, v, b, vd) in enumerate(zip(by_xd, yb0, by_x, ybd0))]
        assert [a - b for a, b in zip(xbd, start)] == pytest.approx(expected)
        assert list(ybd) == [0.0] * (2 * n) and totalbd[0] == totalbd0

        assert (list(y), list(total)) == held, "the values that the caller holds"
        assert totald[0] == totald0


def test_comparisons_are_of_real_parts(case):
    files, _, _ = case.run()
    assert "MAGGI_RE(x[k]) > MAGGI_RE(0.0)" in files["scale_d.c"]
    assert "if (branch == 0)" in files["scale_b.c"]


@pytest.mark.parametrize("name", ["scale_d", "scale_dv", "scale_b", "scale_b_d"])
def test_a_message_is_an_error(case, name):
    case.answers[name][".msg"] = "\n 3 maggi_scale: (TC30) Type mismatch\n 4 more\n"
    assert case.fails() == (f"tapenade, {'scale_b.c' if name == 'scale_b_d' else 'scale.c'}, mode "
                            f"{name[6:]}: 3 maggi_scale: (TC30) Type mismatch (and 1 lines more)")


def test_a_missing_file_is_an_error(case):
    del case.answers["scale_b"][".c"]
    case.answers["scale_b"]["say"] = "Job is completed"
    assert case.fails() == ("tapenade, scale.c, mode b: it wrote no scale_b.c; its last words: "
                            "Job is completed")


def test_an_exception_is_an_error(case):
    case.answers["scale_dv"]["say"] = "java.lang.NullPointerException: somewhere"
    assert "java.lang.NullPointerException: somewhere" in case.fails()


def test_a_status_is_an_error(case):
    case.answers["scale_d"] = {"say": "no Java", "status": 3}
    assert case.fails() == "tapenade, scale.c, mode d: status 3: no Java"


def test_garbage_is_an_error(case):
    case.answers["scale_d"][".c"] = "@@ garbage ("
    assert case.fails().startswith(
        "tapenade, scale.c, mode d as Tapenade wrote it is not C: ")


def test_an_empty_file_is_an_error(case):
    case.answers["scale_d"][".c"] = ""
    assert case.fails() == "tapenade, scale.c, mode d: it wrote no function maggi_scale_d"


def test_what_does_not_compile_is_an_error(case):
    text = case.answers["scale_d"][".c"]
    case.answers["scale_d"][".c"] = text.replace("yd[k] = x[k]", "yd[k] = unknown")
    message = case.fails()
    assert message.startswith("what Tapenade wrote does not compile: scale_d.c:")
    assert "unknown" in message


def test_unknown_headers_are_an_error(case):
    case.answers["scale_d"][".c"] = '#include "adContext.h"\n' + case.answers["scale_d"][".c"]
    assert "includes adContext.h" in case.fails()


def test_overwritten_adjoints_are_an_error(case):
    text = case.answers["scale_b"][".c"]
    case.answers["scale_b"][".c"] = text.replace("**x:incr", "**x:out")
    assert "the adjoint of x of maggi_scale is `out`" in case.fails()
    case.answers["scale_b"][".c"] = text.replace("**y:in-out", "**y:in-killed")
    assert "the adjoint of y of maggi_scale is `in-killed`" in case.fails()


def test_other_arguments_are_an_error(case):
    text = case.answers["scale_d"][".c"]
    case.answers["scale_d"][".c"] = text.replace("\n        const double pd[1], const double x[t",
                                                 "\n        const double x[t")
    assert "has 0 derivatives of p, not 1" in case.fails()
    case.answers["scale_d"][".c"] = text.replace("double weight, const double p[1],\n",
                                                 "double weight, double weightd, "
                                                 "const double p[1],\n")
    assert "has 1 derivatives of weight, not 0" in case.fails()


def test_stack_without_rules_is_an_error(case):
    case.rules.unlink()
    assert "the adjoint of scale.c uses the stack" in case.fails()


def test_black_boxes_are_refused(case):
    (case.kernel / "kernel.h").write_text(KERNEL_H + "double maggi_black(double x);\n")
    (case.kernel / "scale.c").write_text(SCALE_C.replace("p[0] * x[k];", "maggi_black(x[k]);"))
    with pytest.raises((engine.Refusal, engine_tapenade.TapenadeError)) as error:
        case.run()
    assert "maggi_black" in str(error.value)


def test_no_program(case):
    case.program.unlink()
    assert case.fails() == f"{case.program} is not a program"


def test_whole_kernel(tmp_path):
    """Every head in every mode, compiled, with the built-in engine in Tapenade's place."""
    output = tmp_path / "out"
    subprocess.run([sys.executable, TOOLS / "generate", "--engine", "tapenade", "--tapenade",
                    ROOT / "tests" / "engine" / "standin_tapenade.py", "--output", output],
                   check=True)
    written = (output / "maggi_ad.h").read_text()
    for line in (TOOLS / "heads.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            name, source = line.split()[0], re.search(r"(\w+)\.c", line)[1]
            for mode in ("d", "dv", "b", "b_d"):
                assert f"void {name}_{mode}(" in written
                assert f"\nvoid {name}_{mode}(" in (output / f"{source}_{mode}.c").read_text()
    assert (output / "MANIFEST").read_text().startswith(
        "engine   tapenade\nversion  3.16 (stand-in)\n"
        "command  tools/tapenade/generate --engine tapenade\ncommand  tapenade -d ")


def test_generate_says_it_in_one_line(tmp_path):
    program = tmp_path / "tapenade"
    program.write_text("#!/bin/sh\nexit 0\n")
    program.chmod(0o755)
    output = tmp_path / "out"
    done = subprocess.run(
        [sys.executable, TOOLS / "generate", "--engine", "tapenade", "--tapenade", program,
         "--output", output], capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert done.stderr.startswith("generate: tapenade, ") and done.stderr.count("\n") == 1
    assert "it wrote no" in done.stderr
    assert list(tmp_path.iterdir()) == [program], "nothing is left behind"
