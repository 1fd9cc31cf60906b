"""maggi sensitivity and maggi verify: options, reports, files, messages, exit status.

What the gradients are is tested elsewhere; here two are compared with differences of maggi simulate.
The binary is $MAGGI, else build/maggi.
"""

import csv
import json
import math
import os
import pathlib
import pty
import re
import signal
import stat
import subprocess
import sys
import time

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
MAGGI = os.environ.get("MAGGI", str(ROOT / "build" / "maggi"))
GENERATED = "multiple-four-bar:1x1"
TIME = ["--time", "0.2"]
END = ["--objective", "terminal(crank.v)", *TIME]
LONG = ["--time", "1e4", "--step", "1e-4"]  # only to be interrupted
DESIGN = ["m", "Ix", "yCOG", "zCOG", "c", "k"]  # of the model four-bar

SMALL = """format: maggi
version: 1
name: small
gravity: [0, -9.81, 0]
bodies:
  - name: bar
    joint: {type: revolute, point: [0, 0, 0], axis: [0, 0, 1], velocity: 0}
    mass: 1
    bar: {from: [0, 0, 0], to: [0, -1, 0]}
"""
LOCKUP = """format: maggi
version: 1
name: lockup
gravity: [0, 0, 0]
bodies:
  - {name: a, mass: 1, joint: {type: prismatic, axis: [1, 0, 0], motion: f}}
  - {name: b, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},
     joint: {type: revolute, point: [0, 0, 0], axis: [0, 0, 1]}}
functions: [{name: f, type: polynomial, coefficients: [0, 1]}]
rods: [{name: tie, body_a: a, body_b: b, point_a: [1, 0, 0], point_b: [0, 1, 0]}]
"""


def maggi(*arguments, **options):
    options.setdefault("timeout", 300)
    options.setdefault("stdin", subprocess.DEVNULL)
    options.setdefault("stdout", subprocess.PIPE)
    options.setdefault("stderr", subprocess.PIPE)
    return subprocess.run([MAGGI, *map(str, arguments)], text=True, **options)


def done(*arguments, **options):
    """Standard output of a run without complaint."""
    result = maggi(*arguments, **options)
    assert (result.returncode, result.stderr) == (0, "")
    return result.stdout


def failed(status, text, *arguments, **options):
    result = maggi(*arguments, **options)
    assert result.returncode == status, result.stderr
    assert re.fullmatch(r"maggi: [^\n]+\n", result.stderr), result.stderr
    assert text in result.stderr
    return result


def sensitivity(*arguments, model="four-bar", **options):
    return json.loads(done("sensitivity", model, *arguments, "--json", **options))


def read(path):
    with open(path, newline="", encoding="utf-8") as file:
        header, *rows = csv.reader(file)
    assert all(len(row) == len(header) for row in rows)
    return [dict(zip(header, row)) for row in rows]


def with_python():
    """An environment whose python3 is this one."""
    path = os.path.dirname(sys.executable) + os.pathsep + os.environ.get("PATH", "")
    return dict(os.environ, PATH=path)


@pytest.fixture
def small(tmp_path):
    """A model without objectives and design parameters."""
    model = tmp_path / "small.yaml"
    model.write_text(SMALL)
    return model


# ------------------------------------------------------------------ wrong command lines

S = ["sensitivity", "four-bar", *END]
WRONG = [
    # arguments, exit status, part of the line
    (["sensitivity"], 2, "no MODEL"),
    (["sensitivity", "no-such-model"], 1, "no-such-model"),
    (["sensitivity", "four-bar", "--objective"], 2, "--objective needs"),
    (["sensitivity", "four-bar", "--objective", "J5"], 2, 'no objective "J5"'),
    (["sensitivity", "four-bar", "--objective", "lod"], 2, 'did you mean "load"'),
    (["sensitivity", "four-bar", "--objective", "rms(crnk.q)"], 2, 'mean "rms(crank.q)"'),
    (["sensitivity", "four-bar", "--objective", "rmss(crnk.q)"], 2, 'mean "rms(crank.q)"'),
    (["sensitivity", "four-bar", "--objective", "value(crank.q)"], 2, "value(crank.q)"),
    (["sensitivity", "four-bar", "--objective", "J1,,J2"], 2, "empty name"),
    (["sensitivity", "four-bar", "--objective", "J1,J1"], 2, "J1 is named twice"),
    ([*S, "--parameters", "crank.mass"], 2, 'did you mean "bodies.crank.mass"'),
    ([*S, "--parameters", "yCOGG"], 2, 'did you mean "yCOG"'),
    ([*S, "--parameters", "tyres.*"], 2, '"tyres.*"'),
    ([*S, "--parameters", "m,m"], 2, "m is named twice"),
    ([*S, "--parameters", "m,?"], 2, '"m" is there already'),
    ([*S, "--parameters", "x="], 2, "NAME=[FACTOR*]PATH"),
    ([*S, "--parameters", "=gravity.z"], 2, "NAME=[FACTOR*]PATH"),
    ([*S, "--parameters", "x=2*"], 2, "NAME=[FACTOR*]PATH"),
    ([*S, "--parameters", "x=gravity.z+"], 2, "NAME=[FACTOR*]PATH"),
    ([*S, "--parameters", "x=gravity.z:1:0"], 2, "NAME=[FACTOR*]PATH"),
    ([*S, "--parameters", "x=gravity.z:one"], 2, '"one" is not a number'),
    ([*S, "--parameters", "x=1e*gravity.z"], 2, '"1e" is not a number'),
    ([*S, "--parameters", "x=gravity.zz"], 2, 'did you mean "gravity.z"'),
    ([*S, "--parameters", "x=gravity.z::2:1"], 2, "above"),
    ([*S, "--method", "adjont"], 2, 'did you mean "adjoint"'),
    ([*S, "--method", "difference", "--perturbation", "0"], 2, "--perturbation: 0 is not above"),
    ([*S, "--method", "difference", "--perturbation", "-1e-6"], 2, "is not above zero"),
    ([*S, "--snapshots", "0"], 2, "--snapshots"),
    ([*S, "--memory", "1T"], 2, "--memory"),
    ([*S, "--memory", "0"], 2, "--memory: 0 is too small"),
    ([*S, "--memory", "99999999999G"], 2, "too large"),
    ([*S, "--threads", "0"], 2, "--threads: 0 is too small"),
    ([*S, "--threads", "1025"], 2, "--threads: 1025 is more than"),
    ([*S, "--states", "a.csv"], 2, "--states: only with --method direct"),
    ([*S, "--csv", ""], 2, "--csv: the file name is empty"),
    ([*S, "--plot", "-"], 2, "--plot"),
    ([*S, "--method", "direct", "--csv", "a.csv", "--states", "a.csv"], 2, "a.csv"),
    ([*S, "--csv", "/no/such/directory/a.csv"], 1, "/no/such/directory/a.csv"),
    ([*S, "--csv", "/tmp"], 1, "/tmp: is a directory"),
    ([*S, "--csv", "/dev/full"], 1, "/dev/full: No space left"),
    ([*S, "--step", "1"], 2, "--step: 1 s is longer"),
    ([*S, "--set", "bodies.crank.mas=1"], 2, 'mean "bodies.crank.mass"'),
    ([*S, "--set", "bodies.crank.mass=-1"], 2, "bodies.crank.mass=-1"),
    (
        [
            "sensitivity",
            GENERATED,
            "--objective",
            "rms(v_1_1.q)",
            "--time",
            "1e300",
            "--step",
            "1e300",
        ],
        1,
        GENERATED,
    ),
    (["verify"], 2, "no MODEL"),
    (["verify", "four-bar", "--objective", "J5"], 2, 'no objective "J5"'),
    (["verify", "four-bar", "--limit", "0"], 2, "--limit: 0 is not above zero"),
    (["verify", "four-bar", "--method", "direct"], 2, "unknown option --method"),
]


@pytest.mark.parametrize("arguments, status, text", WRONG, ids=[" ".join(w[0]) for w in WRONG])
def test_wrong_command_line(arguments, status, text, tmp_path):
    assert failed(status, text, *arguments, cwd=tmp_path).stdout == ""
    assert os.listdir(tmp_path) == []


def test_objective_is_needed(small):
    failed(
        2, 'declares no objective; give one, as in --objective "rms(bar.q)"', "sensitivity", small
    )


def test_help():
    for command in ["sensitivity", "verify"]:
        assert f"maggi {command} MODEL" in done("help")
        assert done("help", command).startswith(f"maggi {command} MODEL")
        assert done(command, "--help") == done("help", command)
    text = done("help", "sensitivity")
    for option in (
        "objective parameters method perturbation time step set tolerance snapshots memory threads "
        "states every csv plot all-rows json"
    ).split():
        assert f"--{option}" in text
    for method in ["direct", "continuous-adjoint", "forward-difference"]:
        assert method in text
    assert "MAGGI_SCRIPTS" in text
    for option in "objective parameters time step set tolerance limit plot json".split():
        assert f"--{option}" in done("help", "verify")


def test_info_has_objectives_and_design(small):
    info = json.loads(done("info", "four-bar", "--json"))
    assert info["design"] == DESIGN and "J1" in info["objectives"]
    text = done("info", "four-bar")
    assert ", ".join(DESIGN) in text and "objectives\n  J1" in text
    assert json.loads(done("info", small, "--json"))["objectives"] == []
    assert "objectives" not in done("info", small)


# ------------------------------------------------------------------ what is computed


def final(path, value, quantity="v"):
    arguments = ["--time", "0.2", "--json", "--set", f"{path}={value!r}"]
    return json.loads(done("simulate", "four-bar", *arguments))[quantity]["crank"]


def test_gradient_is_that_of_simulate():
    found = sensitivity(*END, "--parameters", "bodies.crank.mass,joint_springs.spring1.damping")
    h = 1e-5
    for path, gradient in found["gradient"].items():
        difference = (final(path, 1 + h) - final(path, 1 - h)) / (2 * h)
        assert gradient == pytest.approx(difference, rel=1e-7)
    assert found["value"] == final("bodies.crank.mass", 1.0)


def test_keys_of_one_objective():
    found = sensitivity(*END)
    assert found["model"] == "four-bar" and found["objective"] == "terminal(crank.v)"
    assert found["unit"] == "rad/s" and found["method"] == "adjoint"
    for key in ["gradient", "units", "normalised", "nominal"]:
        assert list(found[key]) == DESIGN, key
    assert found["units"] == {
        "m": "(rad/s)/kg",
        "Ix": "(rad/s)/(kg m^2)",
        "yCOG": "(rad/s)/m",
        "zCOG": "(rad/s)/m",
        "c": "(rad/s)/(N m s/rad)",
        "k": "(rad/s)/(N m/rad)",
    }
    assert found["parameters"] == 6 and found["steps"] == 200 and found["recomputed"] == 0
    assert (found["time"], found["step"], found["threads"]) == (0.2, 0.001, 1)
    assert found["ratio"] == pytest.approx(found["wall_s"] / found["simulation_wall_s"], rel=1e-12)
    assert found["wall_s"] > 0.0 and "relevance" not in found and "objectives" not in found


def test_normalised_and_ranking():
    found = sensitivity(*END)
    b, gradient = found["nominal"], found["gradient"]
    assert b["yCOG"] == 0.0 and found["normalised"]["yCOG"] is None and gradient["yCOG"] != 0.0
    for name in DESIGN:
        if b[name] != 0.0:
            expected = b[name] * gradient[name] / found["value"]
            assert found["normalised"][name] == pytest.approx(expected, rel=1e-14)
    weight = {name: (abs(b[name] * gradient[name]), abs(gradient[name])) for name in DESIGN}
    assert found["ranking"] == sorted(DESIGN, key=weight.get, reverse=True)
    assert found["ranking"][-1] == "yCOG"


def test_several_objectives_are_those_of_each():
    names = ["J1", "load", "rms(crank_end.y)"]
    together = sensitivity("--objective", ",".join(names), *TIME)
    assert "gradient" not in together and "nominal" in together
    assert [part["objective"] for part in together["objectives"]] == names
    for name, part in zip(names, together["objectives"]):
        alone = sensitivity("--objective", name, *TIME)
        assert part["value"] == alone["value"] and part["unit"] == alone["unit"]
        for key in DESIGN:
            assert part["gradient"][key] == pytest.approx(alone["gradient"][key], rel=1e-12)


def test_defaults_are_those_of_the_model(small):
    found = sensitivity(*TIME)
    info = json.loads(done("info", "four-bar", "--json"))
    assert [part["objective"] for part in found["objectives"]] == info["objectives"]
    assert list(found["nominal"]) == info["design"]
    other = sensitivity("--objective", "terminal(bar.q)", model=small)
    paths = [p["path"] for p in json.loads(done("info", small, "--json"))["parameters"]]
    assert list(other["gradient"]) == paths
    everything = sensitivity(*END, "--parameters", "all")
    assert list(everything["gradient"]) == [p["path"] for p in info["parameters"]]


def test_parameters():
    one = sensitivity(*END, "--parameters", "gravity.z,bodies.*.mass,?COG")
    assert list(one["gradient"]) == [
        "gravity.z",
        "bodies.crank.mass",
        "bodies.coupler.mass",
        "bodies.follower.mass",
        "yCOG",
        "zCOG",
    ]
    items = [
        "all_masses=bodies.*.mass",
        "a=-2*bodies.crank.mass+1e+1*gravity.z:3",
        "b=*.crank.mass::0.5:2",
        "c=.5*gravity.z:4:::lb",
    ]
    found = sensitivity(*END, "--parameters", ",".join(items))
    gradient = one["gradient"]
    masses = sum(gradient[f"bodies.{body}.mass"] for body in ["crank", "coupler", "follower"])
    assert found["gradient"]["all_masses"] == pytest.approx(masses, rel=1e-12)
    mixed = -2 * gradient["bodies.crank.mass"] + 10 * gradient["gravity.z"]
    assert found["gradient"]["a"] == pytest.approx(mixed, rel=1e-12)
    assert found["gradient"]["b"] == pytest.approx(gradient["bodies.crank.mass"], rel=1e-12)
    assert found["gradient"]["c"] == pytest.approx(0.5 * gradient["gravity.z"], rel=1e-12)
    assert found["nominal"] == {"all_masses": 1.0, "a": 3.0, "b": 1.0, "c": 4.0}
    assert found["units"]["c"] == "(rad/s)/lb" and found["units"]["b"] == "(rad/s)/kg"


def test_methods():
    exact = sensitivity(*END)["gradient"]
    for method, accuracy in [
        ("direct", 1e-11),
        ("continuous-adjoint", 1e-7),
        ("difference", 1e-6),
        ("forward-difference", 1e-4),
        ("backward-difference", 1e-4),
    ]:
        found = sensitivity(*END, "--method", method)
        assert found["method"] == method
        for name in DESIGN:
            assert found["gradient"][name] == pytest.approx(exact[name], rel=accuracy), method
    rough = sensitivity(*END, "--method", "difference", "--perturbation", "0.05")["gradient"]
    assert rough["m"] != pytest.approx(exact["m"], rel=1e-5)
    assert rough["m"] == pytest.approx(exact["m"], rel=1e-1)


def test_settings_and_tolerance():
    path = "bodies.crank.mass"
    changed = sensitivity(*END, "--set", f"{path}=2", "--tolerance", "1e-12")
    assert changed["nominal"]["m"] == 2.0 and changed["value"] == pytest.approx(final(path, 2.0))
    difference = (final(path, 2.0001) - final(path, 1.9999)) / 2e-4
    assert changed["gradient"]["m"] == pytest.approx(difference, rel=1e-6)


def test_snapshots_and_memory():
    full, few = sensitivity(*END), sensitivity(*END, "--snapshots", "5")
    assert few["gradient"] == full["gradient"] and few["value"] == full["value"]
    assert full["recomputed"] == 0 and few["recomputed"] > 0 and few["kept"] <= 5
    less = sensitivity(*END, "--memory", "64K")
    assert less["gradient"] == full["gradient"] and less["kept"] < full["kept"]


@pytest.mark.parametrize("method", ["direct", "difference", "backward-difference"])
def test_threads_do_not_change_a_bit(method):
    def numbers(threads):
        found = sensitivity(
            "--objective",
            "J1,load",
            *TIME,
            "--method",
            method,
            "--parameters",
            "all",
            "--threads",
            threads,
        )
        assert found.pop("threads") == int(threads)
        return {key: found[key] for key in found if "wall" not in key and key != "ratio"}

    one = numbers("1")
    assert one == numbers("2") == numbers("5")


def test_more_threads_than_parameters():
    found = sensitivity(*END, "--method", "direct", "--threads", "20")
    assert found["threads"] == len(DESIGN)


def test_relevance(tmp_path):
    out = tmp_path / "a.csv"
    found = sensitivity(*END, "--method", "direct", "--states", out)
    relevance = found["relevance"]
    values = [entry["value"] for entry in relevance.values()]
    assert sorted(relevance) == sorted(DESIGN) and values == sorted(values, reverse=True)
    rows = read(out)
    for name, entry in relevance.items():
        column = f"d({entry['coordinate']}.q)/d({name})"
        assert entry["value"] == max(abs(float(row[column])) for row in rows)
        for other in ["crank", "coupler.1", "coupler.2", "follower"]:
            assert entry["value"] >= max(abs(float(row[f"d({other}.q)/d({name})"])) for row in rows)
    assert relevance["m"]["unit"] == "rad/kg"


# ------------------------------------------------------------------ text


def test_report():
    text = done("sensitivity", "four-bar", *END, "--parameters", "all")
    assert "terminal(crank.v) = " in text and "rad/s" in text and "(rad/s)/kg" in text
    ranks = [int(rank) for rank in re.findall(r"^ *(\d+)  \S+ ", text, re.M)]
    assert ranks == list(range(1, 36))
    more = int(re.search(r"and (\d+) more \(--all-rows\)", text).group(1))
    paths = len(json.loads(done("info", "four-bar", "--json"))["parameters"])
    assert more == paths - 35
    everything = done("sensitivity", "four-bar", *END, "--parameters", "all", "--all-rows")
    assert len(re.findall(r"^ *(\d+)  \S+ ", everything, re.M)) == paths
    assert "more" not in everything and "b is 0" in everything
    assert re.search(r"^method +adjoint, \d+ parameters$", text, re.M)
    assert re.search(r"^computed in +\S+ s, \S+ times the \S+ s of a simulation$", text, re.M)
    assert "relevance" not in text
    direct = done("sensitivity", "four-bar", *END, "--method", "direct", "--threads", 2)
    assert "relevance" in direct and "2 threads" in direct


def test_objective_of_zero(small):
    arguments = ["--objective", "terminal(bar.q)", "--parameters", "bodies.bar.joint.*,gravity.*"]
    found = sensitivity(*arguments, model=small)
    assert found["value"] == 0.0 and set(found["normalised"].values()) == {None}
    assert found["gradient"]["gravity.x"] != 0.0
    text = done("sensitivity", small, *arguments)
    assert "J is 0" in text and "b/J dJ/db " not in text


def test_root_of_zero(small):
    for method in ["adjoint", "direct", "continuous-adjoint"]:
        arguments = ["--objective", "rms(bar.q)", "--method", method]
        assert failed(1, "root of zero", "sensitivity", small, *arguments).stdout == ""


def test_lock_up(tmp_path):
    model, out = tmp_path / "lockup.yaml", tmp_path / "a.csv"
    model.write_text(LOCKUP)
    out.write_text("old\n")
    for method in ["adjoint", "direct", "difference", "continuous-adjoint"]:
        arguments = ["--objective", "rms(b.q)", "--time", 3, "--method", method, "--csv", out]
        result = failed(1, "the mechanism locks up", "sensitivity", model, *arguments)
        assert 'rod "tie"' in result.stderr and "lockup.yaml" in result.stderr
    failed(
        1,
        "the mechanism locks up",
        "sensitivity",
        model,
        "--objective",
        "rms(b.q)",
        "--time",
        3,
        "--method",
        "direct",
        "--threads",
        3,
    )
    failed(1, "the mechanism locks up", "verify", model, "--time", 3)
    assert out.read_text() == "old\n" and sorted(os.listdir(tmp_path)) == ["a.csv", "lockup.yaml"]


def test_no_effect_is_said():
    for option, value, method in [
        ("--perturbation", "1e-3", "adjoint"),
        ("--snapshots", "5", "direct"),
        ("--memory", "1M", "difference"),
        ("--threads", "2", "adjoint"),
        ("--every", "2", "direct"),
    ]:
        result = maggi("sensitivity", "four-bar", *END, "--method", method, option, value)
        assert result.returncode == 0 and f"note: {option} has no effect" in result.stderr
        assert result.stderr.count("\n") == 1


def test_shorter_last_step_is_said():
    result = maggi("sensitivity", "four-bar", "--objective", "J1", "--time", 1, "--step", 0.03)
    assert result.returncode == 0
    assert re.fullmatch(r"maggi: note: 1 s is not a multiple .* is 0\.01 s\n", result.stderr)


# ------------------------------------------------------------------ files


def test_csv(tmp_path):
    out = tmp_path / "a.csv"
    arguments = ["--objective", "J1,load", *TIME, "--method", "direct", "--csv", out]
    found = sensitivity(*arguments)
    rows = read(out)
    assert (
        list(rows[0])
        == (
            "objective rank parameter nominal unit gradient gradient_unit normalised relevance "
            "relevance_unit coordinate"
        ).split()
    )
    assert len(rows) == 2 * len(DESIGN)
    for part in found["objectives"]:
        mine = [row for row in rows if row["objective"] == part["objective"]]
        assert [row["parameter"] for row in mine] == part["ranking"]
        assert [int(row["rank"]) for row in mine] == list(range(1, 7))
        for row in mine:
            name = row["parameter"]
            assert float(row["gradient"]) == part["gradient"][name]
            assert row["gradient_unit"] == part["units"][name]
            assert float(row["nominal"]) == found["nominal"][name]
            assert float(row["relevance"]) == found["relevance"][name]["value"]
            normalised = part["normalised"][name]
            assert float(row["normalised"]) == normalised or (
                normalised is None and math.isnan(float(row["normalised"]))
            )
    done("sensitivity", "four-bar", *END, "--csv", out)
    assert list(read(out)[0])[-1] == "normalised"


def test_csv_with_quotes(tmp_path):
    out = tmp_path / "a.csv"
    done("sensitivity", "four-bar", *END, "--parameters", 'x=gravity.z::::a"b', "--csv", out)
    assert read(out)[0]["unit"] == 'a"b'


def test_states(tmp_path):
    out = tmp_path / "a.csv"
    arguments = ["--objective", "rms(crank_end.z),J1", *TIME, "--method", "direct"]
    done(
        "sensitivity",
        "four-bar",
        *arguments,
        "--parameters",
        "m,bodies.crank.joint.velocity",
        "--states",
        out,
        "--every",
        30,
    )
    rows = read(out)
    signals = [f"{c}.{x}" for c in ["crank", "coupler.1", "coupler.2", "follower"] for x in "qva"]
    parameters = ["m", "bodies.crank.joint.velocity"]
    columns = [f"d({s})/d({b})" for s in [*signals, "crank_end.z"] for b in parameters]
    assert list(rows[0]) == ["t", *columns]
    assert [float(row["t"]) for row in rows] == [0.0, 0.03, 0.06, 0.09, 0.12, 0.15, 0.18, 0.2]
    assert float(rows[0]["d(crank.v)/d(bodies.crank.joint.velocity)"]) == 1.0
    assert float(rows[0]["d(crank.q)/d(m)"]) == 0.0
    end = sensitivity("--objective", "terminal(crank.v)", *TIME)["gradient"]["m"]
    assert float(rows[-1]["d(crank.v)/d(m)"]) == pytest.approx(end, rel=1e-11)


def test_table_on_standard_output():
    result = maggi("sensitivity", "four-bar", *END, "--csv", "-", "--json")
    assert result.returncode == 0 and len(result.stdout.splitlines()) == 1 + len(DESIGN)
    assert json.loads(result.stderr)["parameters"] == len(DESIGN)


def test_files_are_whole_or_not_there(small, tmp_path):
    out = tmp_path / "a.csv"
    run = ["sensitivity", small, "--objective", "terminal(bar.v)"]
    failed(1, "is the model file", *run, "--csv", small)
    out.write_text("old\n")
    out.chmod(0o640)
    done(*run, "--csv", out)
    assert stat.S_IMODE(out.stat().st_mode) == 0o640 and len(read(out)) > 1
    with open("/dev/full", "w") as full:
        failed(1, "standard output: No space left", *run, stdout=full)
    failed(1, "/dev/full", *run, "--method", "direct", "--states", "/dev/full")
    assert sorted(os.listdir(tmp_path)) == ["a.csv", "small.yaml"]


# ------------------------------------------------------------------ pictures


def is_picture(path):
    return path.read_bytes().startswith(b"\x89PNG")


def test_plot(tmp_path):
    pytest.importorskip("matplotlib")
    picture, table, object_ = (tmp_path / name for name in ["a.png", "b.csv", "c.json"])
    text = done(
        "sensitivity",
        "four-bar",
        *TIME,
        "--plot",
        picture,
        "--csv",
        table,
        "--json",
        env=with_python(),
    )
    assert is_picture(picture)
    object_.write_text(text)
    script = [sys.executable, ROOT / "scripts" / "plot-sensitivity"]
    for file in [table, object_]:
        subprocess.run([*script, file, "--top", "3"], check=True, timeout=120)
        assert is_picture(file.with_suffix(".png"))
    wrong = subprocess.run(
        [*script, tmp_path / "none.csv"], capture_output=True, text=True, timeout=120
    )
    assert wrong.returncode == 1 and wrong.stderr.count("\n") == 1
    (tmp_path / "bad.csv").write_text("a,b\n1,2\n")
    wrong = subprocess.run(
        [*script, tmp_path / "bad.csv"], capture_output=True, text=True, timeout=120
    )
    assert wrong.returncode == 1 and "bad.csv: is not a table" in wrong.stderr


def test_plot_is_refused_before_the_work(tmp_path):
    pytest.importorskip("matplotlib")
    for name, text in [
        ("/no/such/directory/a.png", "/no/such/directory/a.png: No such file"),
        (str(tmp_path), "is a directory"),
        ("a.txt", ".txt is no format"),
    ]:
        failed(
            1,
            text,
            "sensitivity",
            "four-bar",
            "--objective",
            "J1",
            *LONG,
            "--plot",
            name,
            env=with_python(),
            cwd=tmp_path,
            timeout=60,
        )
    assert os.listdir(tmp_path) == []


def script(folder, text):
    (folder / "scripts").mkdir()
    (folder / "scripts" / "plot-sensitivity").write_text(text)
    (folder / "scripts" / "plot-sensitivity").chmod(0o755)
    return dict(os.environ, MAGGI_SCRIPTS=str(folder / "scripts"))


def test_plot_without_matplotlib(tmp_path):
    env = script(tmp_path, "#!/bin/sh\necho more >&2\necho 'matplotlib is needed' >&2\nexit 1\n")
    failed(
        1,
        "--plot: matplotlib is needed",
        *S[:4],
        *LONG,
        "--plot",
        "a.png",
        env=env,
        cwd=tmp_path,
        timeout=60,
    )


def test_plot_without_python(tmp_path):
    env = script(tmp_path, "#!/usr/bin/env no-such-python\n")
    failed(
        1,
        "--plot: python3 with matplotlib is needed",
        *S[:4],
        *LONG,
        "--plot",
        "a.png",
        env=env,
        cwd=tmp_path,
        timeout=60,
    )


def test_plot_that_fails(tmp_path):
    env = script(
        tmp_path, "#!/bin/sh\n[ $1 = --check ] || { cat >&2; echo 'no ink' >&2; exit 3; }\n"
    )
    failed(1, "--plot: no ink", *S, "--plot", "a.png", env=env, cwd=tmp_path)


# ------------------------------------------------------------------ interruption and progress


@pytest.mark.parametrize("method", ["adjoint", "direct", "difference"])
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_interrupted(method, number, tmp_path):
    out = tmp_path / "a.csv"
    process = subprocess.Popen(
        [
            MAGGI,
            "sensitivity",
            "four-bar",
            "--objective",
            "J1",
            *LONG,
            "--method",
            method,
            "--threads",
            "1" if method == "adjoint" else "2",
            "--csv",
            out,
            "--json",
        ],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    end = time.monotonic() + 60.0
    while not list(tmp_path.iterdir()):
        assert time.monotonic() < end
        time.sleep(0.02)
    time.sleep(0.3)
    process.send_signal(number)
    assert process.communicate(timeout=60) == ("", "")
    assert process.returncode == 130 and os.listdir(tmp_path) == []


def test_progress_on_a_terminal():
    ours, theirs = pty.openpty()
    process = subprocess.Popen(
        [
            MAGGI,
            "sensitivity",
            "pendulum",
            "--objective",
            "terminal(bar.v)",
            "--method",
            "direct",
            "--time",
            "40",
            "--step",
            "1e-4",
            "--parameters",
            "gravity.y",
        ],
        stdout=subprocess.DEVNULL,
        stderr=theirs,
    )
    os.close(theirs)
    assert process.wait(120) == 0
    text = b""
    try:
        while chunk := os.read(ours, 65536):
            text += chunk
    except OSError:  # the other end is closed
        pass
    os.close(ours)
    lines = text.decode().split("\r")
    shown = [line for line in lines if line.strip()]
    assert lines[0] == "" and lines[-1] == ""
    assert shown and all(re.match(r" *\d+ %  .+ left *$", line) for line in shown)


# ------------------------------------------------------------------ verify

METHODS = [
    "adjoint",
    "adjoint, 10 snapshots",
    "direct",
    "continuous-adjoint",
    "difference",
    "forward-difference",
    "backward-difference",
]


@pytest.mark.slow
@pytest.mark.parametrize("model, end", [("four-bar", 0.5), ("double-pendulum", 1)])
def test_verify_passes(model, end):
    found = json.loads(done("verify", model, "--time", end, "--parameters", "all", "--json"))
    assert found["pass"] is True and [m["method"] for m in found["methods"]] == METHODS
    by_name = {method["method"]: method for method in found["methods"]}
    assert all(method["pass"] and method["failure"] is None for method in by_name.values())
    assert by_name["adjoint, 10 snapshots"]["error"] == 0.0 and found["recomputed"] > 0
    assert 0.0 < by_name["direct"]["error"] < 1e-10
    assert 0.0 < by_name["difference"]["error"] < 1e-6
    assert found["continuous"]["order"] == pytest.approx(4.0, abs=0.5)
    table = found["perturbations"]
    assert table["perturbation"] == pytest.approx([10.0**-k for k in range(2, 15)], rel=1e-12)
    errors = table["difference"]
    best = min(errors)
    assert best < 1e-3 * errors[0] and best < 1e-3 * errors[-1]  # a V
    assert errors[1] == pytest.approx(errors[0] / 100, rel=0.2)  # of order 2
    assert table["forward-difference"][2] == pytest.approx(
        table["forward-difference"][1] / 10, rel=0.2
    )
    assert len(found["pairs"]) == len(METHODS) * (len(METHODS) - 1) // 2
    assert {pair["a"] for pair in found["pairs"]} == set(METHODS[1:])
    assert by_name["direct"]["parameters"] == 24 and by_name["difference"]["parameters"] == 5


@pytest.mark.slow
def test_verify_text_plot_and_failure(tmp_path):
    arguments = ["verify", "double-pendulum", "--time", 0.5]
    text = done(*arguments)
    assert text.endswith("\nall pass\n") and text.count("  pass\n") == len(METHODS) - 1
    for word in [*METHODS, "perturbation", "order", "each with each other"]:
        assert word in text
    result = maggi(*arguments, "--limit", "1e-30")
    assert result.returncode == 1 and result.stderr == ""
    assert result.stdout.endswith("\nFAIL\n") and re.search(
        r"^direct .* FAIL ", result.stdout, re.M
    )
    assert json.loads(maggi(*arguments, "--limit", "1e-30", "--json").stdout)["pass"] is False
    pytest.importorskip("matplotlib")
    done(*arguments, "--plot", tmp_path / "v.png", env=with_python())
    assert is_picture(tmp_path / "v.png")


@pytest.mark.slow
def test_verify_proposes_objectives(small):
    arguments = ["--time", 0.3, "--set", "bodies.bar.joint.velocity=1"]
    found = json.loads(done("verify", small, *arguments, "--json"))
    assert list(found["objectives"]) == [
        "integral_square(bar.q)",
        "terminal(bar.v)",
        "rms(energy.kinetic)",
    ]
