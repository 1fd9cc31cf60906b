"""Paths, and the folder that each test compiles in."""

import pathlib
import sys

import pytest

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "tools" / "tapenade")]

import harness  # noqa: E402  needs the paths


@pytest.fixture
def build(tmp_path):
    """build(files, heads, ..) -> harness.Library, compiled in tmp_path"""
    return lambda *arguments, **options: harness.Library(tmp_path, *arguments, **options)
