"""maggi report, maggi simulate --report: the page, its numbers, and what is wrong with tables.

The binary is $MAGGI, else build/maggi.
"""

import html.parser
import json
import os
import pathlib
import re
import shutil
import subprocess

import numpy
import pytest
from conftest import read_csv

ROOT = pathlib.Path(__file__).resolve().parents[2]
MAGGI = os.path.abspath(os.environ.get("MAGGI", ROOT / "build" / "maggi"))
CAR = ROOT / "models" / "wheeled-frame-waves.yaml"
VOID = {"meta", "line", "path", "br"}
G = 9.80665


def maggi(*arguments, **options):
    return subprocess.run(
        [MAGGI, *map(str, arguments)],
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
        **options,
    )


def done(*arguments, note=False, **options):
    result = maggi(*arguments, **options)
    assert result.returncode == 0, result.stderr
    assert note or result.stderr == ""
    return result


def failed(status, text, *arguments, **options):
    result = maggi(*arguments, **options)
    assert result.returncode == status
    assert re.fullmatch(r"maggi: [^\n]+\n", result.stderr), result.stderr
    assert text in result.stderr
    return result


class Page(html.parser.HTMLParser):
    """Elements of a page that must be balanced; text of figures and rows of tables."""

    def __init__(self, path):
        super().__init__()
        self.open, self.ids, self.figures, self.rows, self.links = [], [], [], [], []
        self.text, self.elements = "", []
        self.source = pathlib.Path(path).read_text(encoding="utf-8")
        self.feed(self.source)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        self.elements.append((tag, attrs))
        if "id" in attrs:
            self.ids.append(attrs["id"])
        for key in ("href", "src", "xlink:href", "data", "action"):
            if key in attrs:
                self.links.append(attrs[key])
        if tag == "figure":
            self.figures.append({"paths": 0, "labels": [], "title": "", "legend": ""})
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th") and self.rows:
            self.rows[-1].append("")
        if tag not in ("meta", "br"):
            self.open.append((tag, attrs))

    def handle_startendtag(self, tag, attrs):
        if tag == "path" and "cv" in dict(attrs).get("class", "") and "d" in dict(attrs):
            self.figures[-1]["paths"] += not any(t == "li" for t, _ in self.open)

    def handle_endtag(self, tag):
        assert self.open and self.open[-1][0] == tag, f"</{tag}> in {self.open[-3:]}"
        self.open.pop()

    def handle_data(self, data):
        inside = [tag for tag, _ in self.open]
        if "script" not in inside and "style" not in inside:
            self.text += data
        if "figure" in inside and inside[-1] == "text" and "lab" in self.open[-1][1]["class"]:
            self.figures[-1]["labels"].append(data)
        if "figure" in inside and inside[-1] == "figcaption":
            self.figures[-1]["title"] += data
        if "figure" in inside and inside[-1] == "li":
            self.figures[-1]["legend"] += data + ";"
        if self.rows and inside and ("td" in inside or "th" in inside):
            self.rows[-1][-1] += data

    def row(self, first):
        """Cells behind the row whose heading is `first`."""
        found = [row[1:] for row in self.rows if row and row[0] == first]
        assert len(found) == 1, (first, found)
        return found[0]

    def number(self, first, cell=1):
        return float(self.row(first)[cell].split(" at ")[0].replace("−", "-"))


def check(path):
    """A page as it must be, whatever is on it."""
    page = Page(path)
    assert page.source.startswith("<!DOCTYPE html>\n")
    assert not re.search(r"https?://|url\(|@import|fetch\(|XMLHttp", page.source)
    assert all(link.startswith("#") and link[1:] in page.ids for link in page.links)
    assert len(page.ids) == len(set(page.ids))
    assert page.figures
    for figure in page.figures:
        assert figure["title"].strip() and figure["paths"] >= 1, figure
        assert len(figure["labels"]) == 2 and all(
            re.search(r"\[[^]]+\]$", label) for label in figure["labels"]
        ), figure
    for tag, attrs in page.elements:
        if attrs.get("aria-labelledby"):
            assert all(name in page.ids for name in attrs["aria-labelledby"].split())
    assert len(page.source) < 3e6
    return page


def titles(page):
    return [figure["title"] for figure in page.figures]


@pytest.fixture(scope="module")
def car(tmp_path_factory):
    """Two runs of a vehicle with all its sensors, light and heavy."""
    folder = tmp_path_factory.mktemp("car")
    shutil.copytree(ROOT / "models" / "tyres", folder / "tyres")
    text = CAR.read_text(encoding="utf-8")
    for wheel in ["front_left", "front_right", "rear_left", "rear_right"]:
        text += f"  - {{name: F_{wheel}, type: tyre_force, element: {wheel}}}\n"
        text += f"  - {{name: S_{wheel}, type: tyre_slip, element: {wheel}}}\n"
    text += "objectives:\n  - {name: comfort, type: rms, signal: chassis.z}\n"
    (folder / "car.yaml").write_text(text)
    for name, mass in (("light", 4400), ("heavy", 6000)):
        out = folder / f"{name}.csv"
        arguments = ["--set", f"bodies.chassis.mass={mass}", "--energy", "--objectives"]
        done("simulate", folder / "car.yaml", "--time", 1, *arguments, "--out", out)
    return folder


# ------------------------------------------------------------------ the record beside a table


def test_record(tmp_path):
    out = tmp_path / "a b.csv"
    change = ["--set", "bodies.bar1.mass=2", "--time", 0.5, "--every", 10, "--energy"]
    summary = json.loads(
        done("simulate", "double-pendulum", *change, "--reactions", "bar2", "--out", out, "--json").stdout
    )
    record = json.loads((tmp_path / "a b.csv.json").read_text())
    assert (record["format"], record["version"]) == ("maggi-run", 1)
    assert record["set"] == {"bodies.bar1.mass": 2.0} and record["every"] == 10
    assert f"'{out}'" in record["command"] and record["command"].startswith("maggi simulate ")
    assert re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", record["date"])
    assert os.path.samefile(record["path"], ROOT / "models" / "double-pendulum.yaml")
    assert [c["name"] for c in record["columns"]] == list(read_csv(out))
    assert record["run"] == summary
    info = json.loads(done("info", "double-pendulum", *change[:2], "--json").stdout)
    assert {k: record["model"][k] for k in info if k != "coordinates"} == {
        k: info[k] for k in info if k != "coordinates"
    }
    units = {c["name"]: c["unit"] for c in record["columns"]}
    assert units["t"] == "s" and units["bar1.v"] == "rad/s" and units["bar2.mx"] == "N m"
    assert units["energy.work"] == "J" and units["tip.x"] == "m"


def test_record_of_what_is_no_file(tmp_path):
    done("simulate", "pendulum", "--time", 0.01, "--out", "/dev/null", cwd=tmp_path)
    done("simulate", "pendulum", "--time", 0.01, cwd=tmp_path)
    result = maggi("simulate", "pendulum", "--time", 0.01, "--out", "-", cwd=tmp_path)
    assert result.returncode == 0 and os.listdir(tmp_path) == []
    assert not os.path.exists("/dev/null.json")


def test_record_that_cannot_be_written(tmp_path):
    (tmp_path / "a.csv.json").mkdir()
    failed(1, "a.csv.json: is a directory", "simulate", "pendulum", "--out", tmp_path / "a.csv")
    assert os.listdir(tmp_path) == ["a.csv.json"]


def test_objectives():
    text = done("simulate", "double-pendulum", "--objectives").stdout
    summary = json.loads(done("simulate", "double-pendulum", "--objectives", "--json").stdout)
    names = json.loads(done("info", "double-pendulum", "--json").stdout)["objectives"]
    assert [o["name"] for o in summary["objectives"]] == names
    gradient = json.loads(
        done("sensitivity", "double-pendulum", "--parameters", "bodies.bar1.mass", "--json").stdout
    )
    for ours, theirs in zip(summary["objectives"], gradient["objectives"]):
        assert ours["value"] == pytest.approx(theirs["value"], rel=1e-12)
        assert ours["unit"] == theirs["unit"] and ours["name"] in text
    assert "objectives" not in json.loads(done("simulate", "double-pendulum", "--json").stdout)


def test_info_says_what_sensors_and_wheels_are():
    info = json.loads(done("info", CAR, "--json").stdout)
    slip = next(s for s in info["sensors"] if s["name"] == "slip.alpha")
    assert (slip["sensor"], slip["type"], slip["element"]) == ("slip", "tyre_slip", "front_left")
    body = next(s for s in info["sensors"] if s["name"] == "chassis.x")
    assert (body["type"], body["body"], body["at_cog"]) == ("position", "chassis", True)
    assert [w["side"] for w in info["wheels"]] == ["left", "right", "left", "right"]
    assert info["wheels"][2]["point"] == [-1.5, 1, 0.5] and info["wheels"][2]["carrier"] == "chassis"
    assert info["roads"] == [{"name": "road", "type": "sine"}]


# ------------------------------------------------------------------ the page


@pytest.mark.parametrize("model", ["four-bar", "double-pendulum", "flyball-governor", "spatial-four-bar"])
def test_any_model(model, tmp_path):
    done("simulate", model, "--report", tmp_path / "a.html")
    assert os.listdir(tmp_path) == ["a.html"]
    page = check(tmp_path / "a.html")
    info = json.loads(done("info", model, "--json").stdout)
    assert page.row("Degrees of freedom") == [str(info["dof"])]
    assert any("Energy balance" in title for title in titles(page))
    assert any("pivot ratio" in title for title in titles(page)) == bool(info["loops"])
    assert model in page.text


def test_numbers_of_a_signal(car):
    done("report", car / "light.csv", "--out", car / "a.html")
    page, table = check(car / "a.html"), read_csv(car / "light.csv")
    t = table["t"]
    for name in ["chassis.z", "F_rear_left.fy", "energy.kinetic"]:
        s, row = table[name], [c.replace("−", "-") for c in page.row(name)]
        length = t[-1] - t[0]
        low, high = numpy.argmin(s), numpy.argmax(s)
        fourth = numpy.trapezoid(s**4, t)
        expected = [s[low], t[low], s[high], t[high], (numpy.trapezoid(s**2, t) / length) ** 0.5]
        expected += [(fourth / length) ** 0.25, fourth**0.25, s[-1]]
        assert [float(x) for x in row[1:]] == pytest.approx(expected, rel=6e-4)


def test_numbers_of_a_vehicle(car):
    done("report", car / "light.csv", "--out", car / "a.html")
    page, table = check(car / "a.html"), read_csv(car / "light.csv")
    t = table["t"]
    vx, vy = table["chassis.3.v"], table["chassis.2.v"]
    ax, ay = table["chassis.3.a"], table["chassis.2.a"]
    lateral = (vx * ay - vy * ax) / numpy.hypot(vx, vy)
    k = numpy.argmax(abs(lateral))
    assert page.number("Lateral acceleration, peak") == pytest.approx(lateral[k] / G, rel=1e-4)
    assert float(page.row("Lateral acceleration, peak")[1].split(" at ")[1][:-2]) == t[k]
    side = numpy.arctan2(vy, vx) - table["chassis.4.q"]
    assert page.number("Sideslip angle, peak") == pytest.approx(side[numpy.argmax(abs(side))], rel=1e-4)
    front = table["F_front_right.fz"] - table["F_front_left.fz"]
    peak = front[numpy.argmax(abs(front))]
    assert page.number("Load transfer front, peak") == pytest.approx(peak, rel=1e-4)
    loads = {w: table[f"F_{w}.fz"] for w in ["front_left", "front_right", "rear_left", "rear_right"]}
    name = min(loads, key=lambda w: loads[w].min())
    assert page.number("Smallest vertical force of a tyre") == pytest.approx(loads[name].min(), rel=1e-4)
    assert page.row("Smallest vertical force of a tyre")[1].endswith(f", {name}")
    roll = table["chassis.6.q"]
    busy = abs(lateral) > 0.2 * abs(lateral).max()
    slope = numpy.polyfit(lateral[busy] / G, roll[busy], 1)[0]
    assert page.number("Roll gradient dφ/da_y") == pytest.approx(slope, rel=1e-4)
    start = (table["F_front_left.fz"] + table["F_front_right.fz"])[0] / 9.81
    assert page.row("Axle front: load at t = 0") == [f"{start:.5g} kg"]
    assert page.row("Wheelbase") == ["3 m"] and page.row("Axle rear: track") == ["2 m"]
    record = json.loads((car / "light.csv.json").read_text())
    assert page.number("comfort") == pytest.approx(record["run"]["objectives"][0]["value"], rel=1e-7)
    for title in ["Lateral acceleration", "Roll angle", "Load transfer, front", "Load transfer, rear"]:
        assert any(title in shown for shown in titles(page))
    for title in ["Path seen from above", "Speed", "Tyres: slip angle", "Friction used", "Energy"]:
        assert any(title in shown for shown in titles(page))
    assert "--set bodies.chassis.mass=4400" in page.text


def test_several_runs(car):
    done("report", car / "light.csv", car / "heavy.csv", "--out", car / "b.html", "--title", "A & <B>")
    page = check(car / "b.html")
    assert "A & <B>" in page.text and "<B>" not in page.source
    assert page.row("Mass") == ["5000 kg", "6600 kg"]
    for figure in page.figures:
        assert figure["paths"] % 2 == 0 or "Friction" in figure["title"], figure
        assert "light" in figure["legend"] and "heavy" in figure["legend"]
    for k, name in enumerate(["light", "heavy"]):
        roll = read_csv(car / f"{name}.csv")["chassis.6.q"]
        assert page.number("Roll angle, peak", 1 + k) == pytest.approx(
            roll[numpy.argmax(abs(roll))], rel=1e-4
        )


def test_common_columns_only(car, tmp_path):
    done("simulate", car / "car.yaml", "--time", 0.5, "--out", tmp_path / "plain.csv")
    result = done("report", car / "light.csv", tmp_path / "plain.csv", "--out", tmp_path / "a.html", note=True)
    assert re.fullmatch(r"maggi: note: not in all runs, [^\n]*energy\.kinetic[^\n]*\n", result.stderr)
    page = check(tmp_path / "a.html")
    assert "not in all runs" in page.text
    assert not any("Energy" in title for title in titles(page))


def test_without_record(car, tmp_path):
    shutil.copy(car / "light.csv", tmp_path / "a.csv")
    result = done("report", tmp_path / "a.csv", note=True)
    assert "a.csv.json: is not there" in result.stderr
    page = check(tmp_path / "a.html")
    assert any("Coordinates" in title for title in titles(page))
    shutil.copy(car / "heavy.csv.json", tmp_path / "a.csv.json")
    done("report", tmp_path / "a.csv")  # the same columns and rows: nobody can tell
    done("simulate", "pendulum", "--out", tmp_path / "p.csv")
    shutil.copy(tmp_path / "p.csv.json", tmp_path / "a.csv.json")
    assert "belongs to another table" in done("report", tmp_path / "a.csv", note=True).stderr
    (tmp_path / "a.csv.json").write_text("[]")
    assert "is no record" in done("report", tmp_path / "a.csv", note=True).stderr


def test_curves_keep_their_peaks(tmp_path):
    """A spike of one row in a hundred thousand is drawn to its height."""
    t = numpy.arange(100000) / 1000
    s = numpy.sin(37 * t)
    s[61234] = 5.0
    table = tmp_path / "a.csv"
    numpy.savetxt(table, numpy.c_[t, s], delimiter=",", header="t,x", comments="")
    done("report", table, note=True)
    page = check(tmp_path / "a.html")
    low, high = map(float, re.search(r'data-r="\S+ \S+ (\S+) (\S+)"', page.source).groups())
    d = re.search(r'class="cv c0" d="(M[^"]+)"', page.source).group(1)
    assert len(d) < 60000
    numbers = [int(n) for n in re.findall(r"-?\d+", d)]
    heights = numpy.cumsum(numbers[1::2])
    assert high - heights.min() / 2260 * (high - low) == pytest.approx(5.0, abs=(high - low) / 1000)


# ------------------------------------------------------------------ what is wrong

BAD = [
    ("", "is not a table of maggi simulate"),
    ("a,b\n1,2\n", "is not a table of maggi simulate"),
    ("t,x\n", "has no rows"),
    ("t,x\n0,1\n", "one row only"),
    ("t,x\n0,1\n1\n", "bad.csv:3: 1 cells under 2 columns"),
    ("t,x\n0,1,2\n1,2,3\n", "3 cells under 2 columns"),
    ("t,x\n0,1\n1,one\n", "bad.csv:3: 'one' is not a number"),
    ("t,x\n0,1\n0,2\n", "t does not increase"),
    ("t,x,x\n0,1,1\n1,2,2\n", "column x is there twice"),
    ("t,x\n0,\xff\n", "is not text"),
]


@pytest.mark.parametrize("text, message", BAD)
def test_bad_tables(text, message, tmp_path):
    table = tmp_path / "bad.csv"
    table.write_bytes(text.encode("latin-1"))
    failed(1, message, "report", table, "--out", tmp_path / "a.html")
    assert os.listdir(tmp_path) == ["bad.csv"]


def test_wrong_command_lines(tmp_path):
    failed(2, "no RUN.csv given", "report")
    failed(2, "unknown option --ot", "report", "a.csv", "--ot", "b")
    failed(1, "none.csv: No such file", "report", tmp_path / "none.csv")
    failed(2, "--report: the table must be a file", "simulate", "pendulum", "--out", "-", "--report", "a.html")
    assert done("help", "report").stdout == done("report", "--help").stdout
    nowhere = tmp_path / "none" / "a.html"
    failed(1, "none/a.html: No such file", "simulate", "pendulum", "--report", nowhere)
    assert os.listdir(tmp_path) == []


def test_pages_that_cannot_be_written(car, tmp_path):
    failed(1, "is a directory", "report", car / "light.csv", "--out", tmp_path)
    failed(1, "is a table of a run", "report", car / "light.csv", "--out", car / "light.csv")
    failed(1, "/dev/full: No space left", "report", car / "light.csv", "--out", "/dev/full")
    nothing = dict(os.environ, MAGGI_SCRIPTS="", PATH="/nonexistent")
    result = failed(1, "python3", "report", car / "light.csv", "--out", tmp_path / "a.html", env=nothing)
    assert "numpy is needed" in result.stderr
    assert os.listdir(tmp_path) == []


def test_old_page_stays_until_the_new_one_is_whole(car, tmp_path):
    page = tmp_path / "a.html"
    page.write_text("old")
    page.chmod(0o640)
    failed(1, "none.csv", "report", tmp_path / "none.csv", "--out", page)
    assert page.read_text() == "old"
    done("report", car / "light.csv", "--out", page)
    check(page)
    assert page.stat().st_mode & 0o777 == 0o640 and os.listdir(tmp_path) == ["a.html"]
