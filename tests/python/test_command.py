"""The command maggi: what it prints, writes and returns, for right and wrong command lines.

The binary is $MAGGI, else build/maggi.  Most tests use the multiple four-bar of the generator,
which needs no file; wrong model files are tested elsewhere.
"""

import csv
import json
import os
import pathlib
import pty
import re
import resource
import signal
import stat
import subprocess
import sys
import time

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
MAGGI = os.environ.get("MAGGI", str(ROOT / "build" / "maggi"))
MODEL = "multiple-four-bar:1x1"
LONG = ["--time", "1e5", "--step", "1e-4"]  # a thousand million steps: only to be interrupted
NOT_FINITE = ["--time", "1e300", "--step", "1e300"]  # a run that fails in its first step


def maggi(*arguments, **options):
    options.setdefault("timeout", 120)
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
    assert result.returncode == status
    assert re.fullmatch(r"maggi: [^\n]+\n", result.stderr), result.stderr
    assert text in result.stderr
    return result


def read(path):
    with open(path, newline="", encoding="ascii") as file:
        header, *rows = csv.reader(file)
    assert all(len(row) == len(header) for row in rows)
    return {name: [float(row[k]) for row in rows] for k, name in enumerate(header)}


def coordinates(model=MODEL):
    return [c["name"] for c in json.loads(done("info", model, "--json"))["coordinates"]]


# ------------------------------------------------------------------ wrong command lines

WRONG = [
    # arguments, exit status, part of the line
    ([], 2, "no command"),
    (["simulte", MODEL], 2, 'did you mean "simulate"'),
    (["xyzzy"], 2, 'unknown command "xyzzy"'),
    (["--jason"], 2, "--jason"),
    (["help", "simulat"], 2, 'did you mean "simulate"'),
    (["help", "info", "models"], 2, "help"),
    (["version", "now"], 2, '"now"'),
    (["models", "four-bar"], 2, '"four-bar"'),
    (["models", "--jsn"], 2, 'did you mean "--json"'),
    (["simulate"], 2, "no MODEL"),
    (["simulate", ""], 2, "MODEL is empty"),
    (["simulate", MODEL, "other.yaml"], 2, "other.yaml"),
    (["simulate", MODEL, "--tme", "1"], 2, 'did you mean "--time"'),
    (["simulate", MODEL, "-t", "1"], 2, "unknown option -t"),
    (["simulate", MODEL, "--time"], 2, "--time needs"),
    (["simulate", MODEL, "--out", "--json"], 2, "--out needs"),
    (["simulate", MODEL, "--time", "1", "--time", "2"], 2, "--time is given twice"),
    (["simulate", MODEL, "--json=yes"], 2, "--json takes no value"),
    (["simulate", MODEL, "--time", "1s"], 2, '--time: "1s" is not a number'),
    (["simulate", MODEL, "--time", ""], 2, '--time: "" is not a number'),
    (["simulate", MODEL, "--time", " 1"], 2, "is not a number"),
    (["simulate", MODEL, "--time", "0x10"], 2, "is not a number"),
    (["simulate", MODEL, "--time", "inf"], 2, '--time: "inf" is not a number'),
    (["simulate", MODEL, "--time", "1e999"], 2, "--time: 1e999 is too large"),
    (["simulate", MODEL, "--time", "-1"], 2, "--time: -1 is not above zero"),
    (["simulate", MODEL, "--time=0"], 2, "--time: 0 is not above zero"),
    (["simulate", MODEL, "--step", "nan"], 2, '--step: "nan" is not a number'),
    (["simulate", MODEL, "--step", "0"], 2, "--step: 0 is not above zero"),
    (["simulate", MODEL, "--time", "1", "--step", "2"], 2, "--step: 2 s is longer"),
    (["simulate", MODEL, "--time", "1", "--step", "1e-10"], 2, "more than 1000000000 steps"),
    (["simulate", MODEL, "--every", "0"], 2, "--every: 0 is too small"),
    (["simulate", MODEL, "--every", "-3"], 2, "--every: -3 is too small"),
    (["simulate", MODEL, "--every", "1.5"], 2, "--every"),
    (["simulate", MODEL, "--every", "99999999999999999999"], 2, "too large"),
    (["simulate", MODEL, "--tolerance", "0"], 2, "--tolerance"),
    (["simulate", MODEL, "--out", ""], 2, "--out"),
    (["simulate", MODEL, "--set"], 2, "--set needs PATH=VALUE"),
    (["simulate", MODEL, "--set", "bodies.v_1_1.mass"], 2, "PATH=VALUE"),
    (["simulate", MODEL, "--set", "=1"], 2, "PATH=VALUE"),
    (["simulate", MODEL, "--set", "bodies.v_1_1.mass=heavy"], 2, '"heavy" is not a number'),
    (["simulate", MODEL, "--set", "bodies.v_1_1.mass=nan"], 2, "bodies.v_1_1.mass"),
    (["simulate", MODEL, "--set", "bodies.v_1_1.mas=1"], 2, 'mean "bodies.v_1_1.mass"'),
    (["simulate", MODEL, "--set", "v_1_1.mass=1"], 2, 'mean "bodies.v_1_1.mass"'),
    (["simulate", MODEL, "--set", "bodies.v_1_1.mass=-1"], 2, "bodies.v_1_1.mass=-1"),
    (["simulate", MODEL, "--set", "bodies.v_1_1.mass=1", "bodies.v_1_1.mass=2"], 2, "set twice"),
    (["simulate", MODEL, "--reactions", "v_1_11"], 2, 'no body "v_1_11"'),
    (["simulate", MODEL, "--reactions", "v_1_1,,h_1_1"], 2, "empty name"),
    (["simulate", MODEL, "--reactions", "v_1_1,v_1_1"], 2, "named twice"),
    (["simulate", MODEL, "--reactions", "ground"], 2, "ground"),
    (["simulate", "multiple-four-bar"], 1, "multiple-four-bar:7x15"),
    (["simulate", "multiple-four-bar:7"], 2, "NYxNZ"),
    (["simulate", "multiple-four-bar:0x1"], 2, "NYxNZ"),
    (["simulate", "multiple-four-bar:1x-1"], 2, "NYxNZ"),
    (["simulate", "multiple-four-bar:1x1x1"], 2, "NYxNZ"),
    (["simulate", "multiple-four-bar:99999999999x1"], 2, "NYxNZ"),
    (["simulate", "no-such-model"], 1, "no-such-model"),
    (["simulate", "two\nlines"], 1, "two?lines"),
    (["simulate", "./missing.yaml"], 1, "./missing.yaml"),
    (["simulate", MODEL, "--out", "/tmp"], 1, "/tmp: is a directory"),
    (["simulate", MODEL, "--out", "/no/such/directory/a.csv"], 1, "/no/such/directory/a.csv"),
    (["simulate", MODEL, *NOT_FINITE], 1, MODEL),
    (["info"], 2, "no MODEL"),
    (["info", MODEL, "--parameters", "tyres.*"], 2, '"tyres.*"'),
    (["info", MODEL, "--set", "bodies.v_1_1.mass=1e"], 2, '"1e" is not a number'),
    (["info", MODEL, "--energy"], 2, "unknown option --energy"),
]


@pytest.mark.parametrize("arguments, status, text", WRONG, ids=[" ".join(w[0]) for w in WRONG])
def test_wrong_command_line(arguments, status, text, tmp_path):
    assert failed(status, text, *arguments, cwd=tmp_path).stdout == ""
    assert os.listdir(tmp_path) == []


# ------------------------------------------------------------------ help, version, models, info


def test_help_and_version():
    general = done("help")
    assert done("--help") == general and done("-h") == general
    for command in "simulate info equilibrium modes models help version".split():
        assert f"maggi {command}" in general
        assert done("help", command).startswith(f"maggi {command}")
    for command in ["simulate", "info", "equilibrium", "modes", "models"]:
        assert done(command, "--help") == done("help", command)
    assert done("simulate", MODEL, "-h") == done("help", "simulate")
    for option in "time step out every energy reactions set tolerance json".split():
        assert f"--{option}" in done("help", "simulate")
    assert "energy_drift" in done("help", "simulate")
    assert re.fullmatch(r"maggi \d+\.\d+\.\d+\n", done("version"))
    assert done("--version") == done("version")


def shipped():
    models = json.loads(done("models", "--json"))["models"]
    return [model for model in models if model["path"]]


def test_models():
    text = done("models")
    assert "multiple-four-bar:NYxNZ" in text
    names = [model["name"] for model in shipped()]
    assert names == sorted(set(names))
    for model in shipped():
        assert model["description"] in text and "\n" not in model["description"]
        assert json.loads(done("info", model["name"], "--json"))["source"] is not None
        assert os.path.isfile(model["path"])


def test_own_models_come_first(tmp_path):
    if not shipped():
        pytest.skip("no model ships")
    name, text = shipped()[0]["name"], pathlib.Path(shipped()[0]["path"]).read_bytes()
    (tmp_path / "my-own-model.yaml").write_bytes(text)
    (tmp_path / "deep").mkdir()
    (tmp_path / "deep" / "deep.yaml").write_bytes(text)
    (tmp_path / f"{name}.yaml").write_bytes(text)
    own = dict(os.environ, MAGGI_MODELS=str(tmp_path))
    listed = {m["name"]: m["path"] for m in json.loads(done("models", "--json", env=own))["models"]}
    assert listed["my-own-model"] == str(tmp_path / "my-own-model.yaml")
    assert listed["deep"] == str(tmp_path / "deep" / "deep.yaml")
    assert listed[name] == str(tmp_path / f"{name}.yaml")
    assert done("info", "deep", env=own) == done("info", "my-own-model", env=own)
    failed(1, 'did you mean "my-own-model"', "info", "my-won-model", env=own)


def test_models_in_folders(tmp_path):
    """FOLDER/NAME, or NAME where the folder has that name too; a file of the user comes first."""
    names = [model["name"] for model in shipped()]
    assert "coach" in names and "coach/turn" in names and "coach/coach" not in names
    assert done("info", "coach/coach").splitlines()[0] == "coach"
    assert done("info", "coach/turn", cwd=tmp_path).splitlines()[0] == "coach-turn"
    failed(1, 'did you mean "coach/turn"', "info", "coach/trun")
    failed(1, "./coach/turn: cannot be opened", "info", "./coach/turn", cwd=tmp_path)
    (tmp_path / "coach").mkdir()
    (tmp_path / "coach/turn").write_text("format: maggi\n")
    failed(1, "coach/turn:1: ", "info", "coach/turn", cwd=tmp_path)


def test_directory_of_models_must_exist(tmp_path):
    failed(1, "MAGGI_MODELS", "models", env=dict(os.environ, MAGGI_MODELS=str(tmp_path / "none")))


def test_broken_model_does_not_hide_the_others(tmp_path):
    (tmp_path / "broken.yaml").write_text("[\n")
    own = dict(os.environ, MAGGI_MODELS=str(tmp_path))
    result = failed(1, "broken.yaml", "models", env=own)
    assert "broken" in result.stdout and "multiple-four-bar:NYxNZ" in result.stdout


def test_info():
    text = done("info", "multiple-four-bar:2x3")
    info = json.loads(done("info", "multiple-four-bar:2x3", "--json"))
    assert len(info["bodies"]) == len(info["coordinates"]) == 15
    assert info["dof"] == 3 and info["rank"] == 12
    assert info["loop_equations"] == sum(loop["rows"] for loop in info["loops"])
    assert sum(c["independent"] for c in info["coordinates"]) == 3
    assert {b["joint"] for b in info["bodies"]} == {"revolute"}
    assert re.search(r"rank 12, 3 degrees of freedom", text)
    for body in info["bodies"]:
        assert re.search(rf"-- {body['name']}  revolute", text)
        assert body["coordinates"] == [body["name"]]
    depth = {b["name"]: b["parent"] for b in info["bodies"]}
    assert depth["v_1_1"] == "ground" and depth["v_2_1"] == "v_1_1"
    for parameter in info["parameters"]:
        assert parameter["path"] in text
    for loop in info["loops"]:
        assert loop["kind"] == "revolute" and loop["name"] in text


def test_info_parameters():
    def masses(*arguments):
        found = json.loads(done("info", MODEL, "--json", "--parameters", "*.mass", *arguments))
        return {p["path"]: p for p in found["parameters"]}

    assert masses()["bodies.v_1_1.mass"] == {
        "path": "bodies.v_1_1.mass",
        "unit": "kg",
        "value": 1.0,
        "default": 1.0,
    }
    changed = masses("--set", "bodies.v_1_1.mass=2.5", "bodies.h_1_1.mass=0.1")
    assert changed["bodies.v_1_1.mass"]["value"] == 2.5
    assert changed["bodies.v_1_1.mass"]["default"] == 1.0
    assert changed["bodies.h_1_1.mass"]["value"] == 0.1
    assert masses("--set", "bodies.v_1_1.mass=2.5", "--set=bodies.h_1_1.mass=0.1") == changed
    lines = done("info", MODEL, "--parameters=bodies.v_1_?.mass").splitlines()
    assert [line.split() for line in lines] == [
        ["bodies.v_1_1.mass", "1", "kg"],
        ["bodies.v_1_2.mass", "1", "kg"],
    ]
    assert done("info", "--parameters", MODEL) == done("info", MODEL, "--parameters")


# ------------------------------------------------------------------ simulate: rows and columns


def test_columns_and_rows(tmp_path):
    out = tmp_path / "a.csv"
    done("simulate", MODEL, "--time", 1, "--step", 0.1, "--out", out)
    table = read(out)
    names = [f"{name}.{x}" for name in coordinates() for x in "qva"]
    assert list(table) == ["t", *names, "loops.pivot_ratio", "loops.violation"]
    assert table["t"] == [k / 10 for k in range(11)]
    assert out.read_text().endswith("\n") and "\r" not in out.read_text()


def test_all_columns(tmp_path):
    out = tmp_path / "a.csv"
    done("simulate", MODEL, "--time", 0.01, "--energy", "--reactions", "v_1_2,h_1_1", "--out", out)
    table = read(out)
    names = [f"{name}.{x}" for name in coordinates() for x in "qva"]
    names += [f"energy.{x}" for x in ["kinetic", "potential", "total", "work"]]
    names += [
        f"{name}.{x}" for name in ["v_1_2", "h_1_1"] for x in ["fx", "fy", "fz", "mx", "my", "mz"]
    ]
    assert list(table) == ["t", *names, "loops.pivot_ratio", "loops.violation"]
    for kinetic, potential, total in zip(
        *(table[f"energy.{x}"] for x in ["kinetic", "potential", "total"])
    ):
        assert total == kinetic + potential


def test_reactions_of_all(tmp_path):
    out = tmp_path / "a.csv"
    done("simulate", MODEL, "--time", 0.01, "--reactions=all", "--out", out)
    bodies = [b["name"] for b in json.loads(done("info", MODEL, "--json"))["bodies"]]
    assert [name[:-3] for name in read(out) if name.endswith(".fx")] == bodies


def test_sensor_columns(tmp_path):
    for model in shipped():
        info = json.loads(done("info", model["name"], "--json"))
        if info["sensors"]:
            out = tmp_path / "a.csv"
            done("simulate", model["name"], "--time", 0.002, "--step", 0.001, "--out", out)
            columns = [sensor["name"] for sensor in info["sensors"]]
            assert [name for name in read(out) if name in columns] == columns
            return
    pytest.skip("no model with sensors ships")


@pytest.mark.parametrize("every, rows", [(1, 11), (3, 5), (5, 3), (10, 2), (1000, 2)])
def test_every(every, rows, tmp_path):
    out = tmp_path / "a.csv"
    done("simulate", MODEL, "--time", 1, "--step", 0.1, "--every", every, "--out", out)
    t = read(out)["t"]
    assert len(t) == rows and t[0] == 0.0 and t[-1] == 1.0
    assert t[:-1] == [k * every / 10 for k in range(rows - 1)]


@pytest.mark.parametrize(
    "end, step, steps",
    [
        ("0.3", "0.1", 3),
        ("0.7", "0.1", 7),
        ("2.1", "0.3", 7),
        ("0.01", "1e-5", 1000),
        ("5", "5", 1),
    ],
)
def test_multiple_of_the_step(end, step, steps):
    summary = json.loads(done("simulate", MODEL, "--time", end, "--step", step, "--json"))
    assert (summary["time"], summary["steps"]) == (float(end), steps)
    assert summary["step"] == summary["last_step"] == float(step)


def test_last_step_shortened(tmp_path):
    out = tmp_path / "a.csv"
    result = maggi("simulate", MODEL, "--time", 1, "--step", 0.3, "--out", out, "--json")
    summary = json.loads(result.stdout)
    assert result.returncode == 0
    assert re.fullmatch(
        r"maggi: note: 1 s is not a multiple of the step of 0\.3 s: "
        r"the last of 4 steps is 0\.1 s\n",
        result.stderr,
    )
    assert summary["steps"] == 4 and summary["last_step"] == pytest.approx(0.1)
    assert read(out)["t"] == pytest.approx([0.0, 0.3, 0.6, 0.9, 1.0], abs=1e-15)
    assert read(out)["t"][-1] == 1.0


def test_defaults():
    summary = json.loads(done("simulate", MODEL, "--json"))
    info = json.loads(done("info", MODEL, "--json"))["simulation"]
    assert summary["time"] == info.get("time", 1.0)
    assert summary["step"] == info.get("step", 1e-3)


def test_set_changes_the_motion():
    def motion(*arguments):
        return json.loads(done("simulate", MODEL, "--json", *arguments))["q"]

    assert motion("--set", "bodies.h_1_1.mass=1") == motion()  # the value that it has
    assert motion("--set", "bodies.h_1_1.mass=2") != motion()
    assert motion("--set", "bodies.h_1_1.mass=2", "bodies.v_1_1.mass=3") == motion(
        "--set", "bodies.v_1_1.mass=3", "--set", "bodies.h_1_1.mass=2"
    )


def test_set_design_parameters():
    """A name of `design` moves all that it stands for; paths come first."""

    def values(*arguments):
        found = json.loads(done("info", "pendulum", "--json", "--parameters", *arguments))
        return {p["path"]: p["value"] for p in found["parameters"]}

    changed = values("--set", "length=2", "bodies.bar.mass=3", "gravity=1")
    assert changed["bodies.bar.cog.x"] == -2 and changed["sensors.mass.point.x"] == -2
    assert changed["bodies.bar.mass"] == 3 and changed["gravity.y"] == -1
    assert values("--set", "mass=3") == values("--set", "bodies.bar.mass=3")
    moved = values("--set", "length=2", "bodies.bar.cog.x=-1.5")
    assert moved["bodies.bar.cog.x"] == -2 and moved["sensors.mass.point.x"] == -1.5
    for setting, text in (
        ("lengt=1", 'mean "length"'),
        ("mass=-1", "mass=-1: bodies.bar.mass"),
        ("len*=1", "no parameter"),
    ):
        failed(2, text, "simulate", "pendulum", "--set", setting)


def test_set_globs():
    """A glob stands for all the numbers that it matches."""

    def masses(*arguments):
        found = json.loads(done("info", "four-bar", "--json", "--parameters", "bodies.*.mass", *arguments))
        return [p["value"] for p in found["parameters"]]

    assert masses("--set", "bodies.*.mass=3") == [3.0] * len(masses()) != masses()
    failed(2, "no parameter", "simulate", "four-bar", "--set", "bodies.*.mas=1")
    failed(2, "bodies.crank.mass must not be negative", "simulate", "four-bar", "--set", "bodies.*.mass=-1")


# ------------------------------------------------------------------ simulate: summary

KEYS = """model bodies coordinates dof loop_equations rank time step steps evaluations wall_s
us_per_evaluation max_loop_violation min_pivot_ratio min_pivot_time changes_of_coordinates
projections energy_drift interrupted q v""".split()


def test_json_summary(tmp_path):
    out = tmp_path / "a.csv"
    summary = json.loads(
        done(
            "simulate",
            "multiple-four-bar:2x3",
            "--time",
            0.5,
            "--step",
            0.001,
            "--energy",
            "--json",
            "--out",
            out,
        )
    )
    table = read(out)
    assert set(KEYS) <= set(summary)
    assert (summary["bodies"], summary["coordinates"]) == (15, 15)
    assert (summary["dof"], summary["rank"], summary["steps"]) == (3, 12, 500)
    assert summary["rows"] == 501 and summary["interrupted"] is False
    assert summary["evaluations"] >= 4 * 500
    assert summary["us_per_evaluation"] == pytest.approx(
        1e6 * summary["wall_s"] / summary["evaluations"], rel=1e-12
    )
    for name in coordinates("multiple-four-bar:2x3"):
        assert summary["q"][name] == table[f"{name}.q"][-1]
        assert summary["v"][name] == table[f"{name}.v"][-1]
    assert summary["max_loop_violation"] == max(table["loops.violation"])
    assert summary["min_pivot_ratio"] == min(table["loops.pivot_ratio"])
    k = table["loops.pivot_ratio"].index(summary["min_pivot_ratio"])
    assert summary["min_pivot_time"] == table["t"][k]


def test_energy_drift_is_as_documented(tmp_path):
    out = tmp_path / "a.csv"
    summary = json.loads(
        done("simulate", MODEL, "--time", 1, "--step", 0.01, "--energy", "--json", "--out", out)
    )
    table = read(out)
    kinetic, potential, work = (table[f"energy.{x}"] for x in ["kinetic", "potential", "work"])
    change = [t + v - w - (kinetic[0] + potential[0]) for t, v, w in zip(kinetic, potential, work)]
    scale = abs(kinetic[0] + potential[0])
    if scale < 1e-6 * max(kinetic):
        scale = max(kinetic)
    drift = max(map(abs, change)) / scale
    assert summary["energy_drift"] == pytest.approx(drift, rel=1e-6, abs=1e-15)


def test_text_summary(tmp_path):
    text = done("simulate", MODEL, "--time", 0.1, "--out", tmp_path / "a.csv")
    for word in [
        "multiple",
        "3 coordinates",
        "1 degrees of freedom",
        "100 steps",
        "evaluations",
        "energy drift",
        "pivot ratio",
        "101 rows",
        "a.csv",
        "v_1_1",
        "rad/s",
    ]:
        assert word in text


def test_table_on_standard_output():
    result = maggi("simulate", MODEL, "--time", 0.01, "--out", "-", "--json")
    assert result.returncode == 0
    assert len(result.stdout.splitlines()) == 12 and result.stdout.startswith("t,")
    assert json.loads(result.stderr)["steps"] == 10


def test_options_in_any_order_and_form():
    a = json.loads(done("simulate", "--json", "--step=0.01", MODEL, "--time=0.1"))
    b = json.loads(done("simulate", MODEL, "--time", "0.1", "--step", "1e-2", "--json"))
    c = json.loads(done("simulate", "--json", "--time", "+.1", "--step", "0.01", "--", MODEL))
    assert a["q"] == b["q"] == c["q"]


def test_no_effect_is_said():
    result = maggi("simulate", MODEL, "--time", 0.1, "--reactions", "all")
    assert result.returncode == 0 and "--reactions has no effect without --out" in result.stderr


def test_tolerance():
    done("simulate", MODEL, "--time", 0.1, "--tolerance", 1e-12)


# ------------------------------------------------------------------ simulate: files


def test_failure_leaves_the_old_file(tmp_path):
    out = tmp_path / "a.csv"
    out.write_text("old\n")
    failed(1, MODEL, "simulate", MODEL, *NOT_FINITE, "--out", out)
    assert out.read_text() == "old\n" and os.listdir(tmp_path) == ["a.csv"]


def test_replaced_file_keeps_link_and_rights(tmp_path):
    out, link = tmp_path / "a.csv", tmp_path / "link.csv"
    out.write_text("old\n")
    out.chmod(0o640)
    link.symlink_to("a.csv")
    done("simulate", MODEL, "--time", 0.01, "--out", link)
    assert link.is_symlink() and len(read(out)["t"]) == 11
    assert stat.S_IMODE(out.stat().st_mode) == 0o640
    assert sorted(os.listdir(tmp_path)) == ["a.csv", "link.csv", "link.csv.json"]


def test_model_file_is_not_overwritten(tmp_path):
    if not shipped():
        pytest.skip("no model ships")
    model = tmp_path / "m.yaml"
    model.write_bytes(pathlib.Path(shipped()[0]["path"]).read_bytes())
    failed(1, "is the model file", "simulate", model, "--out", model)


def test_full_disk(tmp_path):
    failed(1, "/dev/full: No space left", "simulate", MODEL, "--out", "/dev/full")
    with open("/dev/full", "w") as full:
        failed(1, "standard output: No space left", "simulate", MODEL, "--out", "-", stdout=full)
        failed(1, "standard output: No space left", "simulate", MODEL, stdout=full)
        failed(1, "standard output: No space left", "info", MODEL, stdout=full)
        failed(1, "standard output: No space left", "help", stdout=full)

    def small_files():
        resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))

    failed(
        1,
        "a.csv: File too large",
        "simulate",
        MODEL,
        "--out",
        tmp_path / "a.csv",
        preexec_fn=small_files,
    )
    assert os.listdir(tmp_path) == []


def test_closed_standard_output(tmp_path):
    out = tmp_path / "a.csv"
    failed(
        1,
        "standard output",
        "simulate",
        MODEL,
        "--time",
        1,
        "--out",
        out,
        stdout=None,
        preexec_fn=lambda: os.close(1),
    )
    assert len(read(out)["t"]) == 1001


def test_reader_goes_away():
    process = subprocess.Popen(
        [MAGGI, "simulate", MODEL, *LONG, "--out", "-"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    process.stdout.readline()
    process.stdout.close()
    message = process.stderr.read()
    assert process.wait(60) == 1
    assert message == "maggi: standard output: Broken pipe\n"


# ------------------------------------------------------------------ interruption and progress


def wait_for(condition):
    end = time.monotonic() + 60.0
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.02)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_interrupted(number, tmp_path):
    out = tmp_path / "a.csv"
    process = subprocess.Popen(
        [MAGGI, "simulate", MODEL, *LONG, "--out", str(out), "--json"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    part = tmp_path / f"a.csv.part.{process.pid}"
    wait_for(lambda: part.exists() and part.stat().st_size > 100000)
    assert not out.exists()
    process.send_signal(number)
    text, message = process.communicate(timeout=60)
    summary, table = json.loads(text), read(out)
    assert process.returncode == 130 and message == ""
    assert summary["interrupted"] is True and summary["time"] == table["t"][-1]
    assert summary["rows"] == len(table["t"]) == summary["steps"] + 1
    assert sorted(os.listdir(tmp_path)) == ["a.csv", "a.csv.json"]


def test_interrupted_between_rows(tmp_path):
    out = tmp_path / "a.csv"
    process = subprocess.Popen(
        [MAGGI, "simulate", MODEL, *LONG, "--every", "99999999", "--out", str(out)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    wait_for(lambda: os.listdir(tmp_path))
    time.sleep(0.3)
    process.send_signal(signal.SIGTERM)
    text, message = process.communicate(timeout=60)
    assert process.returncode == 130 and message == "" and "interrupted   at t = " in text
    assert len(read(out)["t"]) == 2


def terminal(arguments, seconds=None):
    """Exit status and what stands on a terminal that is standard error."""
    ours, theirs = pty.openpty()
    process = subprocess.Popen([MAGGI, *arguments], stdout=subprocess.DEVNULL, stderr=theirs)
    os.close(theirs)
    if seconds:
        time.sleep(seconds)
        process.send_signal(signal.SIGINT)
    status = process.wait(60)
    text = b""
    try:
        while chunk := os.read(ours, 65536):
            text += chunk
    except OSError:  # the other end is closed
        pass
    os.close(ours)
    return status, text.decode()


def test_progress_on_a_terminal():
    status, text = terminal(["simulate", MODEL, *LONG], seconds=2.0)
    lines = text.split("\r")
    assert status == 130
    assert lines[0] == "" and lines[-1] == "" and lines[-2].strip() == ""  # erased at the end
    shown = lines[1:-2]
    assert 3 <= len(shown) <= 10  # from 0.5 s on, five times a second at most
    for line in shown:
        assert re.match(r" *\d+ %  t = [\d.e+-]+ of 1e\+05 s  .+ left *$", line)


def test_no_progress_in_a_short_run():
    assert terminal(["simulate", MODEL, "--time", "0.01"]) == (0, "")


# ------------------------------------------------------------------ scripts/plot


def plot(*arguments):
    return subprocess.run(
        [sys.executable, ROOT / "scripts" / "plot", *arguments],
        capture_output=True,
        text=True,
        timeout=120,
    )


def test_plot(tmp_path):
    pytest.importorskip("matplotlib")
    table, image = tmp_path / "a.csv", tmp_path / "b.png"
    done("simulate", MODEL, "--energy", "--reactions", "all", "--out", table)
    assert plot(table).returncode == 0
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")
    assert plot(table, "--columns", "v_1_?.q,energy.*", "--out", image).returncode == 0
    assert image.read_bytes().startswith(b"\x89PNG")
    missing = plot(table, "--columns", "v_1_1.q,v_1_3.q")
    assert missing.returncode == 1
    assert re.fullmatch(
        r'plot: .*a\.csv: no column matches "v_1_3\.q"; did you mean .*\n', missing.stderr
    )
    nothing = plot(tmp_path / "none.csv")
    assert nothing.returncode == 1 and nothing.stderr.count("\n") == 1
    (tmp_path / "bad.csv").write_text("t,x\n0,1\n1\n")
    assert "bad.csv:3: 1 cells under 2 columns" in plot(tmp_path / "bad.csv").stderr
