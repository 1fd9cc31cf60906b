"""heads.txt, tools/tapenade/generate and cmake/check_generated.cmake, on a copy with two heads."""

import pathlib
import shutil
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools" / "tapenade"))

import heads  # noqa: E402  needs the path

TWO = """# two
maggi_generalised_forces (f)/(b FS tau)  mass.c vec.c  d dv b b_d
maggi_reactions (wrench)/(x FS)         reaction.c    d
"""


class Project:
    def __init__(self, root):
        self.root = root
        self.output = root / "ad_generated"
        self.heads = root / "tools" / "tapenade" / "heads.txt"

    def generate(self, *arguments, status=0):
        done = subprocess.run(
            [sys.executable, self.root / "tools" / "tapenade" / "generate", *arguments],
            capture_output=True, text=True, check=False, cwd=self.root.parent)
        assert done.returncode == status, done.stderr
        return done.stderr if status else done.stdout

    def stale(self):
        """what the build says; empty when nothing is to do"""
        done = subprocess.run(
            ["cmake", "-D", f"SOURCE={self.root}", "-D", f"FOLDER={self.output}",
             "-D", "TYPE=tools/tapenade/generate", "-P", self.root / "cmake/check_generated.cmake"],
            capture_output=True, text=True, check=False)
        assert (done.returncode != 0) == bool(done.stderr)
        return " ".join(done.stderr.split())

    def files(self):
        return {path.name: path.read_bytes() for path in self.output.iterdir()}


@pytest.fixture(scope="module")
def generated(tmp_path_factory):
    project = Project(tmp_path_factory.mktemp("generated") / "project")
    for folder in ("tools/tapenade", "core/kernel", "core/include", "cmake"):
        shutil.copytree(ROOT / folder, project.root / folder,
                        ignore=shutil.ignore_patterns("__pycache__"))
    project.heads.write_text(TWO)
    project.generate()
    return project


@pytest.fixture
def project(generated, tmp_path):
    shutil.copytree(generated.root, tmp_path / "project")
    return Project(tmp_path / "project")


def test_files(generated):
    assert sorted(generated.files()) == [
        "MANIFEST", "heads.c", "maggi_ad.h", "mass_b.c", "mass_b_d.c", "mass_d.c", "mass_dv.c",
        "reaction_d.c"]
    manifest = (generated.output / "MANIFEST").read_text().splitlines()
    assert manifest[0] == "engine   built-in"
    assert manifest[2] == "command  tools/tapenade/generate"
    read = [line.split()[2] for line in manifest if line.startswith("read ")]
    assert {"core/kernel/mass.c", "core/kernel/vec.c", "core/kernel/kernel.h", "core/kernel/topo.h",
            "core/kernel/vec.h", "tools/tapenade/heads.txt"} <= set(read)
    assert any(line.endswith("  tools/tapenade/engine/__init__.py") for line in manifest
               if line.startswith("tool "))
    assert "core/kernel/loop.c" not in read
    written = [line.split()[2] for line in manifest if line.startswith("written ")]
    assert written == sorted(set(generated.files()) - {"MANIFEST"})
    assert not any(str(generated.root) in text.decode() for text in generated.files().values())
    assert sorted(path.name for path in generated.root.iterdir()) == [
        "ad_generated", "cmake", "core", "tools"]


def test_the_same_again(project):
    before = {path.name: path.stat().st_mtime_ns for path in project.output.iterdir()}
    assert project.generate() == "ad_generated: 8 files, 0 changed, built-in engine\n"
    assert {path.name: path.stat().st_mtime_ns for path in project.output.iterdir()} == before
    assert "8 files as generated" in project.generate("--check")
    assert project.stale() == ""


def test_check_lists_what_differs(project):
    text = (project.output / "mass_b.c").read_text()
    (project.output / "mass_b.c").write_text(text.replace("\n", "\nint x;\n", 1))
    (project.output / "mass_d.c").unlink()
    (project.output / "old_d.c").write_text("")
    before = project.files()
    assert project.generate("--check", status=1).splitlines() == [
        "ad_generated/mass_b.c:2: differs",
        "ad_generated/mass_d.c: is missing",
        "ad_generated/old_d.c: is not generated",
        "generate: ad_generated is not what generate writes: run tools/tapenade/generate",
    ]
    assert project.files() == before
    assert "ad_generated/mass_b.c is not as it was generated: type tools/" in project.stale()
    project.generate()
    project.generate("--check")
    assert project.stale() == ""


def test_a_changed_kernel_stops_the_build(project):
    kernel = project.root / "core" / "kernel"
    for name in ("mass.c", "vec.h"):
        before = (kernel / name).read_text()
        (kernel / name).write_text(before + "\n")
        assert (f"core/kernel/{name} changed after the derivatives were generated: "
                "type tools/tapenade/generate") in project.stale()
        project.generate("--check", status=1)
        (kernel / name).write_text(before)
    with open(kernel / "loop.c", "a", encoding="utf-8") as file:
        file.write("\n")  # not of these heads
    assert project.stale() == ""
    project.heads.write_text(TWO.replace("reaction.c    d", "reaction.c    d b"))
    assert "tools/tapenade/heads.txt changed" in project.stale()
    assert "ad_generated: 9 files, 4 changed" in project.generate()
    assert project.stale() == ""
    shutil.rmtree(project.output)
    assert "MANIFEST is missing: type tools/tapenade/generate" in project.stale()


def test_errors_leave_everything_as_it_was(project):
    before = project.files()
    source = project.root / "core" / "kernel" / "mass.c"
    text = source.read_text()
    source.write_text(text.replace("maggi_dot6(b[", "unknown(b["))
    message = project.generate(status=1)
    assert message.startswith("generate: core/kernel/mass.c:") and message.count("\n") == 1
    source.write_text(text)
    project.heads.write_text(TWO + "maggi_reactions (wrench)/(x) reaction.c d\n")
    assert project.generate(status=1) == (
        "generate: heads.txt:4: maggi_reactions stands already in line 3\n")
    project.heads.write_text("maggi_sensor (s)/(p) sensor.c d\n")
    assert project.generate(status=1).startswith("generate: heads.txt:1: ")
    assert project.files() == before
    assert sorted(path.name for path in project.root.iterdir()) == [
        "ad_generated", "cmake", "core", "tools"]


def test_other_peoples_folders_are_left_alone(project, tmp_path):
    mine = tmp_path / "mine"
    mine.mkdir()
    (mine / "thesis.txt").write_text("")
    assert "has files but no MANIFEST" in project.generate("--output", mine, status=1)
    assert list(mine.iterdir()) == [mine / "thesis.txt"]
    assert "does not exist" in project.generate("--check", "--output", tmp_path / "x", status=1)
    assert "is not a folder" in project.generate("--output", mine / "thesis.txt", status=1)
    project.generate("--output", tmp_path / "new" / "folder")
    assert sorted(path.name for path in (tmp_path / "new").iterdir()) == ["folder"]


def test_usage(project):
    assert "usage" in project.generate("--help")
    assert "--tapenade goes with" in project.generate("--tapenade", "x", status=2)
    assert "invalid choice" in project.generate("--engine", "adolc", status=2)


@pytest.mark.parametrize("line, reason", [
    ("maggi_sensors", "expected: function (outputs)/(inputs)"),
    ("maggi_sensors (s) (p) sensor.c d", "expected: function (outputs)/(inputs)"),
    ("maggi-sensors (s)/(p) sensor.c d", "expected: function (outputs)/(inputs)"),
    ("maggi_sensors ()/(p) sensor.c d", "no arguments between parentheses"),
    ("maggi_sensors (s)/(p,q) sensor.c d", "`p,q` is not the name of an argument"),
    ("maggi_sensors (s)/(p r p) sensor.c d", "argument p is listed twice"),
    ("maggi_sensors (s)/(p) d", "no source file"),
    ("maggi_sensors (s)/(p) sensor.c", "no mode (d dv b b_d)"),
    ("maggi_sensors (s)/(p) sensr.c d", "no file sensr.c in kernel"),
    ("maggi_sensors (s)/(p) sensor.c sensor.c d", "source sensor.c is listed twice"),
    ("maggi_sensors (s)/(p) sensor.c d d", "mode d is listed twice"),
    ("maggi_sensors (s)/(p) sensor.c d b_d", "mode b_d, the tangent of the adjoint, needs mode b"),
    ("maggi_sensors (s)/(p) sensor.c d e", "`e` is no source file, no mode (d, dv, b, b_d)"),
    ("maggi_sensors (s)/(p) sensor.c d n=", "`n=` is not int=expression"),
    ("maggi_sensors (s)/(p) sensor.c d n=1 n=2", "integer n is given twice"),
    ("# nothing", "no heads"),
])
def test_lines(tmp_path, line, reason):
    path = tmp_path / "heads.txt"
    path.write_text(line + "\n")
    with pytest.raises(heads.HeadsError) as error:
        heads.read(path, ROOT / "core" / "kernel")
    assert str(error.value).startswith(f"heads.txt:1: {reason}")


def test_a_good_line(tmp_path):
    path = tmp_path / "heads.txt"
    path.write_text("\n  maggi_points (r)/( point0 A x )  position.c vec.c b d begin=0 "
                    "end=t->npoint # x\n")
    assert heads.read(path, ROOT / "core" / "kernel") == [{
        "name": "maggi_points", "outputs": ["r"], "inputs": ["point0", "A", "x"],
        "modes": ["b", "d"], "sources": ["position.c", "vec.c"],
        "integers": {"begin": "0", "end": "t->npoint"}, "place": ("heads.txt", 2)}]
