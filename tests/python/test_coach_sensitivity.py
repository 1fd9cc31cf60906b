"""Sensitivities of the coach: the study of scripts/coach-sensitivity, and the relevance of its 35 parameters beside the thesis."""

import csv
import json
import os
import pathlib
import subprocess
import sys

import numpy
import pytest
from conftest import BINARY, ROOT, Maggi

SCRIPT = ROOT / "scripts" / "coach-sensitivity"
THESIS = ROOT / "models" / "coach" / "relevance.csv"
# read in another way than in the thesis: models/coach/README.md
OTHERWISE = {15, 17, 20, 21, 30, 31, 33, 34}


def study(*arguments, binary=BINARY):
    pytest.importorskip("matplotlib")
    return subprocess.run(
        [sys.executable, SCRIPT, *map(str, arguments)],
        env={**os.environ, "MAGGI": str(binary)},
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )


def rows(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def column(table, name):
    return numpy.array([float(row[name]) for row in table])


@pytest.mark.slow
def test_study(tmp_path):
    done = study("--out", tmp_path / "out", "--time", 0.06, "--manoeuvres", "turn")
    assert done.returncode == 0 and done.stderr == ""
    text = pathlib.Path(done.stdout.strip()).read_text(encoding="utf-8")
    out = tmp_path / "out"
    for name in ["difference.png", "roll.png", "z.png"]:
        assert (out / name).read_bytes().startswith(b"\x89PNG") and f"({name})" in text

    table = rows(out / "gradient.csv")
    assert len(table) == 35 and [row["number"] for row in table] == [str(i) for i in range(1, 36)]
    direct = column(table, "direct")
    error = {name: numpy.linalg.norm(column(table, name) - direct) for name in table[0] if name.startswith(("adj", "diff"))}
    size = numpy.linalg.norm(direct)
    assert error["adjoint"] < 1e-11 * size
    assert error["difference 1e-6"] < 1e-3 * size
    assert error["difference 1e-14"] > 100 * error["difference 1e-6"]

    table = rows(out / "relevance.csv")
    assert len(table) == 35
    for kind in ["turn", "straight"]:
        assert (column(table, f"{kind}_relevance") >= 0).all()
        assert sorted(column(table, f"{kind}_rank"))[-1] == 35

    table = rows(out / "all.csv")
    assert sum("." in row["path"] for row in table) == 1103
    assert sum("." not in row["path"] for row in table) == 57
    assert "| turn | 1103 | 57 | 1 |" in text


def test_study_fails_with_one_line(tmp_path):
    for arguments, binary, words in [
        (["--out", tmp_path / "none"], tmp_path / "maggi", "does not exist"),
        (["--out", "/dev/null/x"], BINARY, "Not a directory"),
        (["--out", tmp_path, "--time", "-1"], BINARY, "--time"),
    ]:
        done = study(*arguments, binary=binary)
        assert done.returncode == 1 and words in done.stderr, done.stderr
        assert done.stderr.count("\n") == 1 and done.stderr.startswith("coach-sensitivity: ")


def ranks(values):
    return numpy.array([numpy.sum(values < x) + 0.5 * numpy.sum(values == x) for x in values])


@pytest.mark.parametrize("model, kind, limit", [("turn", "turn", 0.9), ("relevance", "straight", 0.95)])
@pytest.mark.slow
def test_relevance_is_that_of_the_thesis(tmp_path, model, kind, limit):
    """Of table 5.6, masses and moments of inertia times themselves."""
    thesis = rows(THESIS)
    names = [row["parameter"] for row in thesis]
    objective = ["--objective", "integral_square(bodywork_acceleration.z)"]
    result = Maggi(tmp_path).run(
        "sensitivity", f"coach/{model}", *objective, "--method", "direct", "--parameters", ",".join(names), "--json"
    )
    assert result.returncode == 0, result.stderr
    found = json.loads(result.stdout)
    ours = numpy.array([found["relevance"][name]["value"] for name in names])
    ours *= [found["nominal"][name] if "mass" in name or "inertia" in name else 1.0 for name in names]
    alike = [int(row["number"]) not in OTHERWISE for row in thesis]
    assert sum(alike) == 27
    correlation = numpy.corrcoef(ranks(ours[alike]), ranks(column(thesis, kind)[alike]))[0, 1]
    assert correlation > limit
