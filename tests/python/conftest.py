"""Run the command maggi and read what it writes.

The binary is build/maggi, or what the environment variable MAGGI names.
"""

import os
import pathlib
import subprocess

import numpy
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
REFERENCES = ROOT / "tests" / "references"
BINARY = pathlib.Path(os.environ.get("MAGGI", ROOT / "build" / "maggi")).resolve()


def pytest_configure(config):
    config.addinivalue_line("markers", "slow: not run with sanitizers")


def read_csv(path):
    """Columns by name; an empty file or a ragged row is an error."""
    with open(path, encoding="utf-8") as file:
        names = file.readline().rstrip("\n").split(",")
        rows = numpy.loadtxt(file, delimiter=",", ndmin=2)
    assert rows.shape[1] == len(names), f"{path}: {len(names)} names, {rows.shape[1]} columns"
    assert len(set(names)) == len(names), f"{path}: a column name twice"
    return dict(zip(names, rows.T))


class Maggi:
    """The command, with a folder for its files."""

    def __init__(self, folder):
        self.folder = folder
        self.count = 0

    def run(self, *arguments, timeout=300):
        return subprocess.run(
            [BINARY, *map(str, arguments)],
            cwd=self.folder,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=timeout,
            check=False,
        )

    def simulate(self, model, time, step, every=1, reactions=(), energy=False, sets=None):
        """Simulate and return the columns of the CSV file; failure is a failed test."""
        self.count += 1
        out = self.folder / f"{self.count}.csv"
        arguments = ["simulate", model, "--time", repr(time), "--step", repr(step)]
        arguments += ["--every", every, "--out", out]
        if reactions:
            arguments += ["--reactions", ",".join(reactions)]
        if energy:
            arguments += ["--energy"]
        for path, value in (sets or {}).items():
            arguments += ["--set", f"{path}={value!r}"]
        result = self.run(*arguments)
        assert result.returncode == 0, result.stderr
        assert result.stderr == "", result.stderr
        return read_csv(out)


@pytest.fixture(scope="session", autouse=True)
def binary():
    if not BINARY.exists():
        pytest.exit(f"{BINARY} does not exist: build it first", returncode=3)
    return BINARY


@pytest.fixture
def maggi(tmp_path):
    return Maggi(tmp_path)


@pytest.fixture(scope="session")
def reference():
    """reference("T5_fourbar") -> columns of its reference.csv"""
    return lambda folder, name="reference.csv": read_csv(REFERENCES / folder / name)
