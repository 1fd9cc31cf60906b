"""What maggi sensitivity computes: against sensitivities by hand, references and differences."""

import json
import os
import subprocess

import analytical
import numpy
import pytest
from conftest import BINARY, read_csv

DESIGN = ["m", "Ix", "yCOG", "zCOG", "c", "k"]
MOTION = {"": "q", "d": "v", "dd": "a"}


class Case:
    """A reference: model, coordinate of each of its columns, objectives, the same by hand."""

    def __init__(self, model, folder, names, objectives, parameters, time, by_hand):
        self.model = model
        self.folder = folder
        self.names = names
        self.objectives = objectives
        self.parameters = parameters
        self.time = time
        self.by_hand = by_hand

    def columns(self):
        for name, coordinate in self.names.items():
            for suffix, kind in MOTION.items():
                yield name + suffix, f"{coordinate}.{kind}"


def squares(objectives):
    return lambda motion: {o: motion.integral_square(n) for o, n in objectives.items()}


DOUBLE = {"J1": "z2", "J2": "z1", "J3": "z2d", "J4": "z2dd"}
FOUR_BAR = {"J1": "z4", "J2": "z2", "J3": "z4d", "J4": "z4dd"}
CASES = {
    "T4": Case(
        "double-pendulum",
        "T4_double_pendulum",
        {"z1": "bar1", "z2": "bar2"},
        squares(DOUBLE),
        DESIGN,
        5.0,
        lambda steps: analytical.double_pendulum(5, steps, (1, 0)),
    ),
    "hanging": Case(
        "double-pendulum-hanging",
        None,
        {"z1": "bar1", "z2": "bar2"},
        squares(DOUBLE),
        DESIGN,
        5.0,
        lambda steps: analytical.double_pendulum(5, steps, (0, -1)),
    ),
    "T5": Case(
        "four-bar",
        "T5_fourbar",
        {"z1": "crank", "z2": "coupler.1", "z4": "follower"},
        squares(FOUR_BAR),
        DESIGN,
        5.0,
        lambda steps: analytical.four_bar(5, steps),
    ),
    "S1": Case(
        "slider-crank",
        "S1_slidercrank_sundials",
        {"q": "crank", "x": "slider", "p": "rod"},
        lambda motion: {"G": analytical.slider_crank_objective(motion)},
        ["k", "c"],
        10.0,
        lambda steps: analytical.slider_crank(10, steps),
    ),
}


def sensitivity(maggi, model, objectives, *arguments):
    """value and gradient of each objective"""
    result = maggi.run(
        "sensitivity", model, "--objective", ",".join(objectives), "--json", *arguments
    )
    assert result.returncode == 0, result.stderr
    report = json.loads(result.stdout)
    reports = report.get("objectives", [report])
    return {o["objective"]: (o["value"], o["gradient"]) for o in reports}


def run(maggi, case, objectives, step, method, *arguments):
    """value and gradient as one array, for each objective"""
    found = sensitivity(
        maggi,
        case.model,
        objectives,
        *["--parameters", ",".join(case.parameters), "--method", method],
        *["--time", repr(case.time), "--step", repr(step)],
        *arguments,
    )
    return {
        name: numpy.array([value] + [gradient[p] for p in case.parameters])
        for name, (value, gradient) in found.items()
    }


def near(x, ref, limit):
    assert numpy.max(abs(x - ref)) <= limit * numpy.max(abs(ref))


def near_columns(states, name, signal, motion, case, limit):
    for p in case.parameters:
        near(states[f"d({signal})/d({p})"], motion.derivative(name, p), limit)


@pytest.mark.parametrize("name", CASES)
def test_by_hand(maggi, tmp_path, name):
    """The same steps of the same equations: alike to round-off.

    The slider-crank is integrated in other coordinates: alike at small steps.
    """
    case = CASES[name]
    steps = 10000
    step = case.time / steps
    motion = case.by_hand(steps)
    exact = case.objectives(motion)
    out = tmp_path / "states.csv"
    direct = run(maggi, case, exact, step, "direct", "--states", out)
    adjoint = run(maggi, case, exact, step, "adjoint")
    for objective, ref in exact.items():
        near(direct[objective], ref, 1e-11)
        near(adjoint[objective], ref, 1e-11)
    states = read_csv(out)
    for column, signal in case.columns():
        near_columns(states, column, signal, motion, case, 1e-11)


@pytest.mark.parametrize("name", ["T4", "hanging", "T5"])
def test_by_hand_at_large_steps(maggi, name):
    """Coordinates are linear in those of the equations by hand: the truncation error is the same."""
    case = CASES[name]
    exact = case.objectives(case.by_hand(500))
    adjoint = run(maggi, case, exact, case.time / 500, "adjoint")
    for objective, ref in exact.items():
        near(adjoint[objective], ref, 1e-11)


@pytest.mark.parametrize("name", ["T4", "T5", "S1"])
def test_reference(maggi, tmp_path, reference, name):
    """Order 4 towards the references: gradients and sensitivities over time."""
    case = CASES[name]
    ref = reference(case.folder, "sensitivities.csv")
    rows = len(ref["t"]) - 1
    errors = []
    for k in (5, 10):
        out = tmp_path / f"{k}.csv"
        step = case.time / (rows * k)
        objectives = ["G"] if name == "S1" else ["J1", "J2", "J3", "J4"]
        found = run(maggi, case, objectives, step, "direct", "--states", out, "--every", k)
        states = read_csv(out)
        largest = []
        for column, signal in case.columns():
            for p in case.parameters:
                exact = ref[f"d{column}/d{p}"]
                error = numpy.max(abs(states[f"d({signal})/d({p})"] - exact))
                largest.append(error / numpy.max(abs(exact)))
        for objective in objectives:
            exact = numpy.array([ref[f"d{objective}/d{p}"][-1] for p in case.parameters])
            error = numpy.max(abs(found[objective][1:] - exact))
            largest.append(error / numpy.max(abs(exact)))
        errors.append(numpy.array(largest))
    assert numpy.max(errors[1]) < 2e-8
    # below 1e-11 round-off counts
    ratio = errors[0][errors[1] > 1e-11] / errors[1][errors[1] > 1e-11]
    assert len(ratio) > 0
    assert numpy.all((10 < ratio) & (ratio < 24)), ratio


# ------------------------------------------------------------------------------------- differences

SPATIAL = """format: maggi
version: 1
name: coupler-length
bodies:
  - name: crank
    joint: {{type: revolute, point: [0, 0, 0], axis: [1, 0, 0], velocity: 2}}
    mass: 1
    bar: {{from: [0, 0, 0], to: [0, 0.3, 0.2]}}
  - name: follower
    joint: {{type: revolute, point: [0.8, 0.9, 0], axis: [0.2, 1, 0.1]}}
    mass: 2
    bar: {{from: [0.8, 0.9, 0], to: [0.9, 0.8, 0.7]}}
rods:
  - {{name: coupler, body_a: crank, body_b: follower, point_a: [0, 0.3, 0.2],
     point_b: [0.9, 0.8, 0.7], mass: 0.5, length: {length}}}
"""

FIVE_BAR = """format: maggi
version: 1
name: five-bar
bodies:
  - name: a
    joint: {type: revolute, point: [0, 0, 0], axis: [1, 0, 0]}
    mass: 1
    bar: {from: [0, 0, 0], to: [0, -0.3, 1]}
  - name: b
    parent: a
    joint: {type: revolute, point: [0, -0.3, 1], axis: [1, 0, 0]}
    mass: 1
    bar: {from: [0, -0.3, 1], to: [0, 0.5, 1.6]}
  - name: d
    joint: {type: revolute, point: [0, 1, 0], axis: [1, 0, 0]}
    mass: 1
    bar: {from: [0, 1, 0], to: [0, 1.3, 1]}
  - name: c
    parent: d
    joint: {type: revolute, point: [0, 1.3, 1], axis: [1, 0, 0]}
    mass: 1
    bar: {from: [0, 1.3, 1], to: [0, 0.5, 1.6]}
loops:
  - {name: top, type: revolute, body_a: b, body_b: c, point: [0, 0.5, 1.6], axis: [1, 0, 0]}
springs:
  - {name: left, body_a: ground, body_b: b, point_a: [0, 0, 0], point_b: [0, 0.5, 1.6],
     stiffness: 100, free_length: 1.5, damping: 2}
  - {name: right, body_a: ground, body_b: c, point_a: [0, 1, 0], point_b: [0, 0.5, 1.6],
     stiffness: 120, free_length: 1.6, damping: 1}
"""

MODELS = {
    # a length that is not the one drawn: the initial position has to be assembled
    "spatial": (
        SPATIAL.format(length=1.15),
        ["rms(crank.v)", "terminal(follower.q)", "mean(crank.fx)"],
        {"rods.coupler.length": 1.15, "rods.coupler.mass": 0.5},
    ),
    "five-bar": (
        FIVE_BAR,
        ["rms(a.v)", "terminal(c.q)", "integral_square(d.a)"],
        {"springs.left.free_length": 1.5, "springs.right.free_length": 1.6},
    ),
}


@pytest.mark.parametrize("name", MODELS)
def test_against_differences(maggi, tmp_path, name):
    """Direct and adjoint are the same; centred differences of the command's values come near."""
    text, objectives, parameters = MODELS[name]
    model = tmp_path / "model.yaml"
    model.write_text(text, encoding="utf-8")
    run_time = ["--time", "1", "--step", "0.002", "--parameters", ",".join(parameters)]

    def compute(method, *arguments):
        return sensitivity(maggi, model, objectives, "--method", method, *run_time, *arguments)

    adjoint, direct = compute("adjoint"), compute("direct")
    difference = compute("difference", "--perturbation", "1e-5")
    for path, value in parameters.items():
        h = 1e-5 * value
        low, high = (
            compute("adjoint", "--set", f"{path}={value + sign * h!r}") for sign in (-1, 1)
        )
        for o in objectives:
            g = adjoint[o][1][path]
            scale = max(abs(x) for x in adjoint[o][1].values())
            assert abs(g) > 1e-6
            assert abs(direct[o][1][path] - g) < 1e-10 * scale
            slope = (high[o][0] - low[o][0]) / (2 * h)
            assert abs(slope - g) < 1e-6 * scale
            assert abs(difference[o][1][path] - g) < 1e-6 * scale


def peak_memory(time):
    """kB of an adjoint with few states kept."""
    arguments = ["sensitivity", "four-bar", "--objective", "J1", "--memory", "100K", "--time", str(time)]
    process = subprocess.Popen([BINARY, *arguments], stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    assert process.returncode == 0
    return usage.ru_maxrss


@pytest.mark.slow
def test_memory_does_not_grow_with_time():
    assert peak_memory(200) < peak_memory(10) + 500
