"""maggi tyre, and the slopes of tyres as objectives: against the reference points of the coach."""

import csv
import io
import json
import os
import pathlib
import subprocess

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
MAGGI = os.environ.get("MAGGI", str(ROOT / "build" / "maggi"))
TIR = ROOT / "models" / "tyres" / "pac2002_315_80R22_5.tir"
REFERENCE = ROOT / "tests" / "references" / "pac2002" / "reference.csv"


def maggi(*arguments):
    return subprocess.run(
        [MAGGI, *map(str, arguments)], text=True, capture_output=True, timeout=120, check=False
    )


def rows(text):
    return list(csv.DictReader(io.StringIO(text)))


def done(*arguments):
    result = maggi("tyre", TIR, *arguments)
    assert (result.returncode, result.stderr) == (0, "")
    return result.stdout


def test_reference():
    right = rows(REFERENCE.read_text())
    found = rows(done("--file", REFERENCE))
    assert len(found) == len(right) == 200
    for a, b in zip(found, right):
        for name in ["Fx", "Fy", "Mx", "My", "Mz", "dFy_dalpha", "dFx_dkappa"]:
            assert float(a[name.lower()]) == pytest.approx(float(b[name]), rel=1e-9, abs=0)


def test_mirrored():
    """The reference mirrors the tyre and not its slip: F(kappa, -alpha, -gamma), turned over."""
    right = rows(REFERENCE.read_text())
    found = rows(done("--file", REFERENCE, "--side", "right"))
    for a, b in zip(found, right):
        for name in ["Fx", "Fy", "Mz"]:
            assert float(a[name.lower()]) == pytest.approx(float(b[name + "_mirror"]), rel=1e-9)


def test_slopes_on_both_sides():
    left = ["--alpha", 0.03, "--gamma", 0.01, "--kappa", 0.02, "--json"]
    right = ["--alpha", -0.03, "--gamma", -0.01, "--kappa", 0.02, "--side", "right", "--json"]
    left, right = (json.loads(done(*a))["points"][0] for a in (left, right))
    for name, way in [("fx", 1), ("fy", -1), ("mz", -1), ("my", 1)]:
        assert right[name] == way * left[name]
    for name in ["dfy_dalpha", "dfx_dkappa", "utilisation"]:
        assert right[name] == left[name]
    assert left["dfy_dalpha"] < -1e5


def test_slopes_are_slopes():
    h = 1e-5
    for name, force, slope in [("alpha", "fy", "dfy_dalpha"), ("kappa", "fx", "dfx_dkappa")]:
        for side in ["left", "right"]:
            at = ["--fz", 22500, "--gamma", 0.02, "--side", side]
            at += ["--kappa", 0.03] if name == "alpha" else ["--alpha", 0.04]
            low, mid, high = rows(done(*at, "--sweep", f"{name}={0.05 - h}:{0.05 + h}:3"))
            difference = (float(high[force]) - float(low[force])) / (2 * h)
            assert float(mid[slope]) == pytest.approx(difference, rel=1e-7)


def test_sweep_and_point():
    swept = rows(done("--sweep", "alpha=-0.1:0.1:5", "--fz", "3e4"))
    assert [float(r["alpha"]) for r in swept] == pytest.approx([-0.1, -0.05, 0, 0.05, 0.1])
    alpha = swept[3]["alpha"]
    point = json.loads(done("--alpha", alpha, "--fz", "3e4", "--json"))
    assert point["side"] == "left"
    assert point["points"] == [{k: float(v) for k, v in swept[3].items()}]
    assert f"{float(swept[3]['fy']):.15g}" in done("--alpha", alpha, "--fz", "3e4")
    assert all(float(r[k]) == 0 for r in rows(done("--sweep", "fz=-1:0:2")) for k in ["fx", "fy", "mz"])


def test_out(tmp_path):
    out = tmp_path / "out.csv"
    assert done("--sweep", "kappa=-1:1:21", "--out", out) == ""
    assert len(rows(out.read_text())) == 21
    assert done("--sweep", "kappa=-1:1:21") == out.read_text()


@pytest.mark.parametrize(
    "arguments, status, message",
    [
        (["--side", "middle"], 2, "none of left, right"),
        (["--sweep", "alpha=0:1"], 2, "is not NAME=FROM:TO:N"),
        (["--sweep", "delta=0:1:3"], 2, "none of kappa"),
        (["--sweep", "alpha=0:x:3"], 2, "not a number"),
        (["--sweep", "alpha=0:1:1"], 2, "too small"),
        (["--sweep", "alpha=0:1:3", "--file", "x.csv"], 2, "do not go together"),
        (["--json", "--out", "-"], 2, "standard output"),
        (["--fz", "heavy"], 2, "not a number"),
        (["--file", "nowhere.csv"], 1, "nowhere.csv: cannot be opened"),
        (["--file", str(TIR)], 1, "no column is"),
    ],
)
def test_wrong(arguments, status, message):
    result = maggi("tyre", TIR, *arguments)
    assert (result.returncode, result.stdout) == (status, "")
    assert message in result.stderr and result.stderr.count("\n") == 1


def test_wrong_files(tmp_path):
    table = tmp_path / "points.csv"
    for text, message in [
        ("kappa,alpha\n0.1,0\n0.1,abc\n", "points.csv:3: "),
        ("kappa,alpha\n0.1\n", "points.csv:2: fewer"),
        ("kappa,Kappa\n0,0\n", "twice"),
        ("kappa\n", "no points"),
    ]:
        table.write_text(text)
        result = maggi("tyre", TIR, "--file", table)
        assert result.returncode == 1 and message in result.stderr
    result = maggi("tyre", tmp_path / "none.tir")
    assert result.returncode == 1 and "none.tir: cannot be opened" in result.stderr
    result = maggi("tyre")
    assert result.returncode == 2 and "no FILE.tir" in result.stderr


def gradient(method):
    """Of the grip constraint: the largest dFy/dalpha of a wheel over time."""
    result = maggi(
        *["sensitivity", "wheeled-frame-obstacles", "--objective", "maximum(right.dfy_dalpha)"],
        *["--parameters", "tyres.truck.pky1,tyres.truck.pdy1,bodies.chassis.mass,roads.ramp.z.2"],
        *["--time", 0.3, "--method", method, "--json"],
    )
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)["gradient"]


def test_grip_constraint():
    adjoint, direct, difference = map(gradient, ["adjoint", "direct", "difference"])
    assert direct == pytest.approx(adjoint, rel=1e-9)
    assert difference == pytest.approx(adjoint, rel=1e-5)
