"""Sensors of vehicles and objectives of windows on a frame with tyres, against numpy."""

import json

import numpy
import pytest

from conftest import ROOT

POINT = "point: [1.5, 0.4, 0.9]"
SENSORS = f"""  - {{name: v, type: velocity, body: chassis, {POINT}}}
  - {{name: a, type: acceleration, body: chassis, {POINT}}}
  - {{name: turn, type: angles, body: chassis}}
  - {{name: lat, type: lateral_acceleration, body: chassis, low_acceleration: 1e-7, {POINT}}}
  - {{name: beta, type: sideslip, body: chassis, {POINT}}}
  - {{name: lv, type: level_velocity, body: chassis, {POINT}}}
  - {{name: la, type: level_acceleration, body: chassis, {POINT}}}
  - {{name: ba, type: body_acceleration, body: chassis, {POINT}}}
  - {{name: mix, type: combination, terms: [lat.planar, la.z, turn.roll], weights: [2, -1, 0.5]}}
objectives:
  - {{name: settle, type: norm, signal: lat.planar, from: 0.333, to: 0.8125, reference: final}}
  - {{name: drift, type: rms, signal: v.y, from: 0.25, reference: initial}}
  - {{name: gain, type: slope, signal: lat.planar, against: turn.roll, from: 0.21, to: 0.987}}
  - {{name: over, type: violation, signal: mix.value, target: -0.05, from: 0.2}}
  - {{name: top, type: peak, signal: beta.angle, from: 0.1, to: 0.4321}}
  - {{name: late, type: terminal, signal: lv.y, to: 0.777}}
"""
TIME, STEP = 1.0, 0.005
PARAMETERS = "tyres.truck.lmuy,bodies.chassis.mass,sensors.lat.point.z,sensors.mix.weights.1"


@pytest.fixture(name="model")
def fixture_model(maggi):
    """wheeled-frame.yaml with more sensors, sliding sideways."""
    text = (ROOT / "models" / "wheeled-frame.yaml").read_text(encoding="utf-8")
    for line in text.splitlines():
        if "file:" in line:
            name = line.split("file:")[1].strip(" }")
            text = text.replace(name, str(ROOT / "models" / name))
    path = maggi.folder / "vehicle.yaml"
    path.write_text(text.rstrip("\n") + "\n" + SENSORS, encoding="utf-8")
    return path


def vector(columns, name):
    return numpy.array([columns[f"{name}.{k}"] for k in "xyz"])


def test_sensors(maggi, model):
    c = maggi.simulate(model, TIME, STEP, sets={"bodies.chassis.joint.velocity.2": 0.8})
    v, a = vector(c, "v"), vector(c, "a")
    roll, pitch, yaw = (c[f"turn.{k}"] for k in ("roll", "pitch", "yaw"))
    assert max(abs(roll)) > 1e-3 and max(abs(yaw)) > 1e-4
    across = a - (a * v).sum(axis=0) / (v * v).sum(axis=0) * v
    near = {"rtol": 1e-6, "atol": 1e-6}
    numpy.testing.assert_allclose(c["lat.exact"], numpy.sqrt((across**2).sum(axis=0)), **near)
    planar = (v[0] * a[1] - v[1] * a[0]) / numpy.hypot(v[0], v[1])
    numpy.testing.assert_allclose(c["lat.planar"], planar, **near)
    numpy.testing.assert_allclose(c["lat.approximate"], numpy.hypot(a[0], a[1]), **near)
    numpy.testing.assert_allclose(c["beta.angle"], numpy.arctan2(v[1], v[0]) - yaw, **near)
    numpy.testing.assert_allclose(c["beta.speed"], numpy.hypot(v[0], v[1]), **near)
    curvature = planar / numpy.hypot(v[0], v[1]) ** 2
    numpy.testing.assert_allclose(c["beta.curvature"], curvature, **near)
    level = numpy.array(
        [
            [numpy.cos(yaw), numpy.sin(yaw), 0 * yaw],
            [-numpy.sin(yaw), numpy.cos(yaw), 0 * yaw],
            [0 * yaw, 0 * yaw, 1 + 0 * yaw],
        ]
    )
    exact = {"rtol": 1e-11, "atol": 1e-11}
    numpy.testing.assert_allclose(vector(c, "lv"), numpy.einsum("ijk,jk->ik", level, v), **exact)
    la = numpy.einsum("ijk,jk->ik", level, a)
    numpy.testing.assert_allclose(vector(c, "la"), la, **exact)
    x = numpy.cos(pitch) * la[0] - numpy.sin(pitch) * la[2]
    down = numpy.sin(pitch) * la[0] + numpy.cos(pitch) * la[2]
    y = numpy.cos(roll) * la[1] + numpy.sin(roll) * down
    z = numpy.cos(roll) * down - numpy.sin(roll) * la[1]
    numpy.testing.assert_allclose(vector(c, "ba"), numpy.array([x, y, z]), **exact)
    mix = 2 * c["lat.planar"] - c["la.z"] + 0.5 * roll
    numpy.testing.assert_allclose(c["mix.value"], mix, **exact)


@pytest.mark.parametrize("formulation", ["maggi", "penalty"])
def test_gradients(maggi, model, formulation):
    """direct, adjoint (whole tape and few states) and differences say the same"""

    def run(method, *more):
        arguments = ["sensitivity", model, "--parameters", PARAMETERS, "--json", "--method", method]
        arguments += ["--time", TIME, "--step", STEP, "--formulation", formulation]
        arguments += ["--set", "bodies.chassis.joint.velocity.2=0.8"]
        result = maggi.run(*arguments, "--objective", "settle,drift,gain,over,top,late", *more)
        assert result.returncode == 0, result.stderr
        parts = json.loads(result.stdout)["objectives"]
        return [p["value"] for p in parts], numpy.array([list(p["gradient"].values()) for p in parts])

    value, direct = run("direct")
    assert numpy.all(numpy.abs(direct).max(axis=1) > 0)
    scale = numpy.abs(direct).max(axis=1, keepdims=True)
    runs = [run("adjoint"), run("direct", "--memory", "1K")]
    if formulation == "maggi":
        runs.append(run("adjoint", "--snapshots", "5"))
    for other, gradient in runs:
        numpy.testing.assert_allclose(other, value, rtol=1e-12)
        assert numpy.max(abs(gradient - direct) / scale) < 1e-9
    other, gradient = run("difference", "--perturbation", "1e-4")
    numpy.testing.assert_allclose(other, value, rtol=1e-12)
    assert numpy.max(abs(gradient - direct) / scale) < 1e-4
