"""maggi equilibrium and maggi modes: known equilibria, frequencies, and what cannot be done."""

import json
import math
import re

import pytest
from conftest import ROOT

# the coach's own numbers, of a program of another method: z, pitch, z and pitch of the rear support; loads of
# the wheels FL FR RLi RLo RRi RRo; forces of the springs.  Digits as printed
LADEN = {
    "q": {
        "R_CHASSIS.1": -0.0356141957,
        "R_CHASSIS.5": -0.00328669733,
        "R_SUPPORT.1": -0.00651409618,
        "R_SUPPORT.3": 0.00277975996,
        "R_SUPPORT.5": -0.000882021701,
        "R_L_STAB": -0.084813035,
        "L_S_TRIANG": -0.0355609673,
        "R_I_TRIANG": 0.0297049059,
        "LST_AUX2": 0.000413223561,
        "L_CARRIER": 0.000119553508,
        "F_R_STAB": 0.0266703216,
    },
    "load": [30724.48, 30724.48, 26447.98, 26447.98, 26447.98, 26447.98],
    "force": [-28017.18, -28017.18, -22563.71, -23047.11, -22563.71, -23047.11],
}
UNLADEN = {
    "q": {
        "R_CHASSIS.1": 2.54127389e-06,
        "R_CHASSIS.5": 5.6571407e-06,
        "R_SUPPORT.1": 7.09881677e-07,
        "R_SUPPORT.3": -4.38187164e-06,
        "R_L_STAB": 3.39372254e-05,
        "L_S_TRIANG": -5.72514859e-05,
        "F_R_STAB": 4.29936378e-05,
    },
    "load": [23539.25, 23539.25, 21334.22, 21334.22, 21334.22, 21334.22],
    "force": [-20621.00, -20621.00, -17699.32, -17699.14, -17699.32, -17699.14],
}


def answer(maggi, *arguments):
    result = maggi.run(*arguments, "--json")
    assert (result.returncode, result.stderr) == (0, "")
    return json.loads(result.stdout)


@pytest.mark.parametrize("laden", [True, False])
def test_coach(maggi, tmp_path, laden):
    model = "coach/turn"
    if not laden:
        file = tmp_path / "unladen.yaml"
        text = (ROOT / "models/coach/straight.yaml").read_text(encoding="utf-8")
        base = f"base: {ROOT}/models/coach/coach.yaml"
        file.write_text(text.replace("base: coach-laden.yaml", base), encoding="utf-8")
        model = str(file)
    known = LADEN if laden else UNLADEN
    found = answer(maggi, "equilibrium", model)
    q = {c["name"]: c["value"] for c in found["coordinates"]}
    for name, value in known["q"].items():
        assert q[name] == pytest.approx(value, rel=2e-9, abs=2e-11), name
    assert [w["load"] for w in found["wheels"]] == pytest.approx(known["load"], abs=6e-3)
    assert [s["force"] for s in found["springs"]][:6] == pytest.approx(known["force"], abs=6e-3)
    assert 0 < found["iterations"] < 10 and found["damped"] == 0
    assert found["residual"] < 1e-9


def test_text(maggi):
    text = maggi.run("equilibrium", "sprung-frame").stdout
    assert re.search(r"^equilibrium +7 coordinates, \d+ iterations of Newton's method;", text, re.M)
    assert re.search(r"^  fl +load +[\d.]+ N$", text, re.M)
    assert re.search(r"^  rear_l +length +[\d.]+ m  force +-[\d.]+ N$", text, re.M)


MASSES = """\
format: maggi
version: 1
name: masses
start: {equilibrium: true}
bodies:
  - {name: lower, mass: 2, joint: {type: prismatic, axis: [0, 0, 1]}}
  - {name: upper, mass: 3, joint: {type: prismatic, axis: [0, 0, 1]}}
springs:
  - {name: a, body_a: lower, body_b: ground, point_a: [0, 0, 1], point_b: [0, 0, 0], stiffness: 900, damping: 4}
  - name: b
    body_a: upper
    body_b: ground
    point_a: [1, 0, 1]
    point_b: [1, 0, 0]
    stiffness: 2700
    slopes: {c1: 40, c2: 10, c3: 20, c4: 5, v11: 0.1, v22: -0.1}
"""


def test_modes(maggi, tmp_path):
    file = tmp_path / "masses.yaml"
    file.write_text(MASSES, encoding="utf-8")
    result = maggi.run("modes", file)
    if "without GSL" in result.stderr:
        pytest.skip("a build without GSL")
    modes = answer(maggi, "modes", file)["modes"]
    assert [m["coordinate"] for m in modes] == ["lower", "upper"]
    for mode, (mass, stiffness, damping) in zip(modes, [(2, 900, 4), (3, 2700, 30)]):
        omega = math.sqrt(stiffness / mass)
        ratio = damping / (2 * mass * omega)
        assert mode["frequency"] == pytest.approx(omega / (2 * math.pi), rel=1e-12)
        assert mode["damping"] == pytest.approx(ratio, rel=1e-10)
        damped = omega * math.sqrt(1 - ratio**2) / (2 * math.pi)
        assert mode["damped_frequency"] == pytest.approx(damped, rel=1e-12)
    assert re.search(r"^  1 +3\.37\d+ Hz .* lower$", result.stdout, re.M)
    # overdamped: two modes that do not oscillate
    modes = answer(maggi, "modes", file, "--set", "springs.a.damping=400")["modes"]
    real = [m for m in modes if m["coordinate"] == "lower"]
    assert [m["damped_frequency"] for m in real] == [0, 0]
    assert [m["damping"] for m in real] == pytest.approx([1, 1])
    product = real[0]["real"] * real[1]["real"]
    assert product == pytest.approx(450, rel=1e-10)


@pytest.mark.parametrize("command", ["equilibrium", "modes"])
def test_failures(maggi, tmp_path, command):
    result = maggi.run(command, "pendulum")
    assert (result.returncode, result.stdout) == (1, "")
    assert result.stderr == "maggi: pendulum: the model does not say start: {equilibrium: true}\n"
    file = tmp_path / "masses.yaml"
    file.write_text(MASSES.replace("stiffness: 2700", "stiffness: 0"), encoding="utf-8")
    result = maggi.run(command, file)
    assert (result.returncode, result.stdout) == (1, "")
    assert 'static equilibrium: not found, "upper" still accelerates by -9.81 m/s^2' in result.stderr
    assert maggi.run(command).returncode == 2
    assert maggi.run(command, "pendulum", "--time", "1").returncode == 2


@pytest.mark.parametrize(
    "old, new, line, text",
    [
        ("equilibrium: true", "equilibrium: yes", 4, '"yes" is neither true nor false'),
        ("equilibrium: true", "balance: true", 4, 'unknown key "balance"'),
        ("true}", "true, hold: [middle]}", 4, 'coordinate "middle" does not exist'),
        ("true}", "true, hold: middle}", 4, "start.hold must be a list"),
        ("{equilibrium: true}", "[equilibrium]", 4, "start must be a mapping"),
    ],
)
def test_wrong_start(maggi, tmp_path, old, new, line, text):
    file = tmp_path / "wrong.yaml"
    file.write_text(MASSES.replace(old, new), encoding="utf-8")
    result = maggi.run("simulate", file)
    assert result.returncode == 1 and text in result.stderr
    assert result.stderr.startswith(f"maggi: {file}:{line}: ")
