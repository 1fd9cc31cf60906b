"""The penalty formulation on the command line: maggi simulate and maggi sensitivity --formulation penalty.

The binary is $MAGGI, else build/maggi.  Numbers of the thesis: tables 4.4 and 4.5.
"""

import csv
import json
import os
import pathlib
import re
import subprocess

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
MAGGI = os.environ.get("MAGGI", str(ROOT / "build" / "maggi"))
PENALTY = ["--formulation", "penalty"]
WAYS = ["difference", "difference-coloured", "tangent", "tangent-coloured", "adjoint"]


def maggi(*arguments):
    return subprocess.run(
        [MAGGI, *map(str, arguments)],
        text=True,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        timeout=300,
    )


def done(*arguments):
    """Standard output of a run without complaint."""
    result = maggi(*arguments)
    assert (result.returncode, result.stderr) == (0, "")
    return result.stdout


def simulate(model, *arguments):
    return json.loads(done("simulate", model, *arguments, "--json"))


def sensitivity(model, *arguments):
    return json.loads(done("sensitivity", model, *arguments, "--json"))


# ------------------------------------------------------------------------------ simulate


@pytest.mark.parametrize(
    "array, nonzeros, step, drift, jacobians",
    [
        ("1x15", 1410, 0.01, (0.0145, 0.0155), (500, 500)),
        ("1x15", 1410, 0.02, (0.0570, 0.0580), (275, 290)),
        ("7x15", 7170, 0.02, (0.0570, 0.0590), (275, 290)),
    ],
)
def test_thesis(tmp_path, array, nonzeros, step, drift, jacobians):
    """Drift is the extreme of (E - E(0)) / |E(0)| in per cent, E with its datum at the top joints."""
    out = tmp_path / "out.csv"
    summary = simulate(
        f"multiple-four-bar:{array}", *PENALTY, "--time", 5, "--step", step, "--energy", "--out", out
    )
    with open(out, newline="", encoding="ascii") as file:
        header, *rows = csv.reader(file)
    total = [float(row[header.index("energy.total")]) for row in rows]
    extreme = max((100 * (e - total[0]) / abs(total[0]) for e in total), key=abs)
    assert drift[0] <= extreme <= drift[1]
    assert jacobians[0] <= summary["jacobians"] <= jacobians[1]
    assert summary["newton_iterations"] > summary["jacobians"]
    assert (summary["nonzeros"], summary["colours"]) == (nonzeros, 60)
    assert summary["steps"] == round(5 / step)


def test_keys():
    summary = simulate("four-bar", *PENALTY, "--time", 0.1, "--penalty", "1e7", "--tolerance", "1e-11")
    assert summary["formulation"] == "penalty"
    assert (summary["penalty"], summary["newton_tolerance"]) == (1e7, 1e-11)
    assert summary["jacobian"] == "tangent-coloured"
    assert (summary["evaluations"], summary["us_per_evaluation"]) == (0, None)
    summary = simulate("four-bar", "--time", 0.1, "--formulation", "maggi")
    assert summary["formulation"] == "maggi"
    assert "newton_iterations" not in summary and summary["evaluations"] > 0
    text = done("simulate", "four-bar", *PENALTY, "--time", 0.1)
    assert re.search(r"^formulation   penalty 1e\+08, \d+ Newton iterations$", text, re.M)
    assert re.search(r"^Jacobians     \d+, tangent-coloured, 20 nonzeros, 6 colours$", text, re.M)
    text = done("simulate", "four-bar", *PENALTY, "--time", 0.1, "--jacobian", "adjoint")
    assert re.search(r"^Jacobians     \d+, adjoint, 20 nonzeros, 8 columns$", text, re.M)
    assert "Newton" not in done("simulate", "four-bar", "--time", 0.1)


def test_penalty_and_tolerance():
    """A larger penalty closes the loops better, a smaller tolerance takes more iterations."""
    loose = simulate("four-bar", *PENALTY, "--step", 0.01, "--penalty", "1e6")
    stiff = simulate("four-bar", *PENALTY, "--step", 0.01, "--penalty", "1e8")
    assert 50 < loose["max_loop_violation"] / stiff["max_loop_violation"] < 200
    exact = simulate("four-bar", *PENALTY, "--step", 0.01, "--tolerance", "1e-13")
    assert exact["newton_iterations"] > stiff["newton_iterations"]


def test_ways():
    runs = [
        simulate("rssr", *PENALTY, "--time", 1, "--step", 0.01, "--jacobian", way) for way in WAYS
    ]
    for run in runs:
        for key in ["newton_iterations", "jacobians"]:
            assert run[key] == runs[-1][key]
        for name, q in run["q"].items():
            assert q == pytest.approx(runs[-1]["q"][name], abs=1e-9)


@pytest.mark.parametrize("model", ["four-bar", "triple-pendulum-closed", "bricard"])
def test_order(model):
    """Twice as many steps: a quarter of the distance to Maggi's formulation."""
    exact = simulate(model, "--time", 0.5, "--step", 0.0005)["q"]
    error = []
    for step in [0.01, 0.005]:
        q = simulate(
            model, *PENALTY, "--time", 0.5, "--step", step, "--penalty", "1e11", "--tolerance", "1e-11"
        )["q"]
        error.append(max(abs(q[name] - exact[name]) for name in q))
    assert 3.8 < error[0] / error[1] < 4.2
    assert error[1] < 1e-3


# --------------------------------------------------------------------------- sensitivity

SHORT = ["--time", "0.3", "--step", "0.01"]
END = ["--objective", "terminal(follower.q)", *SHORT]


def test_gradient():
    """Direct and adjoint are the same, and the change of a simulation."""
    names = ["bodies.crank.mass", "bodies.follower.mass"]
    common = [*PENALTY, *END, "--parameters", ",".join(names)]
    adjoint = sensitivity("four-bar", *common)
    direct = sensitivity("four-bar", *common, "--method", "direct")
    difference = sensitivity("four-bar", *common, "--method", "difference", "--perturbation", "1e-4")
    for name in names:
        g = adjoint["gradient"][name]
        assert g != 0
        assert direct["gradient"][name] == pytest.approx(g, rel=1e-9)
        assert difference["gradient"][name] == pytest.approx(g, rel=1e-5)
        b = adjoint["nominal"][name]
        ends = [
            simulate(
                "four-bar", *PENALTY, *SHORT, "--tolerance", "1e-13", "--set", f"{name}={b + d!r}"
            )["q"]["follower"]
            for d in [1e-3, -1e-3]
        ]
        assert (ends[0] - ends[1]) / 2e-3 == pytest.approx(g, rel=1e-5)
    assert adjoint["formulation"] == "penalty"
    assert (adjoint["penalty"], adjoint["jacobian"]) == (1e8, "tangent-coloured")
    assert sensitivity("four-bar", *END)["formulation"] == "maggi"


def test_gradient_is_that_of_the_formulation():
    """Of second order: coarse steps of the two differ, fine ones less."""
    distance = []
    for step in ["0.02", "0.01"]:
        common = ["--objective", "terminal(follower.v)", "--time", "0.4", "--step", step]
        a = sensitivity("four-bar", *common)["gradient"]["m"]
        b = sensitivity("four-bar", *PENALTY, *common)["gradient"]["m"]
        distance.append(abs(a - b))
    assert 3.5 < distance[0] / distance[1] < 4.5


def test_report_and_notes():
    result = maggi("sensitivity", "four-bar", *PENALTY, *END, "--snapshots", "5")
    assert result.returncode == 0
    assert "--snapshots has no effect with the penalty formulation" in result.stderr
    assert "formulation   penalty 1e+08, Jacobians by tangent-coloured\n" in result.stdout
    assert "snapshots" not in result.stdout


# ---------------------------------------------------------------------- what goes wrong

WRONG = [
    (["simulate", "--penalty", "1e8"], 2, "--penalty: only with --formulation penalty"),
    (["simulate", "--jacobian", "adjoint"], 2, "--jacobian: only with --formulation penalty"),
    (
        ["simulate", "--formulation", "maggi", "--penalty", "1"],
        2,
        "--penalty: only with --formulation penalty",
    ),
    (["simulate", "--formulation", "penlty"], 2, 'did you mean "penalty"'),
    (["simulate", "--formulation"], 2, "--formulation needs maggi or penalty"),
    (["simulate", *PENALTY, "--penalty", "0"], 2, "--penalty"),
    (["simulate", *PENALTY, "--penalty", "stiff"], 2, '--penalty: "stiff" is not a number'),
    (["simulate", *PENALTY, "--jacobian", "tangnt"], 2, 'no way "tangnt"; did you mean "tangent"?'),
    (["simulate", *PENALTY, "--time", "20", "--step", "5"], 1, "is the step too large?"),
    (["sensitivity", "--penalty", "1e8"], 2, "--penalty: only with --formulation penalty"),
    (
        ["sensitivity", *PENALTY, "--method", "continuous-adjoint"],
        2,
        "continuous-adjoint not with --formulation penalty",
    ),
    (
        ["sensitivity", *PENALTY, "--method", "direct", "--states", "x.csv"],
        2,
        "--states: not with --formulation penalty",
    ),
    (["sensitivity", *PENALTY, "--memory", "1K"], 1, "do not fit into the memory allowed"),
    (["sensitivity", *PENALTY, "--time", "20", "--step", "5"], 1, "is the step too large?"),
    (["verify", *PENALTY], 2, "--formulation"),
]


@pytest.mark.parametrize("arguments, status, text", WRONG, ids=[" ".join(w[0]) for w in WRONG])
def test_wrong(tmp_path, arguments, status, text):
    result = maggi(arguments[0], "four-bar", *arguments[1:])
    assert result.returncode == status
    assert re.fullmatch(r"maggi: [^\n]+\n", result.stderr), result.stderr
    assert text in result.stderr
    assert result.stdout == ""


def test_help():
    for command in ["simulate", "sensitivity"]:
        text = done("help", command)
        for option in ["--formulation", "--penalty ALPHA", "--jacobian WAY"]:
            assert option in text
    for way in WAYS:
        assert way in done("help", "simulate")
