"""The oracles against the reference files: who guards the guardians."""

import numpy
import oracles


def test_pendulum(reference):
    ref = reference("A01_pendulum")
    assert numpy.max(abs(oracles.pendulum(ref["t"]) - ref["phi"])) < 1e-12


def test_multiple_four_bar(reference):
    ref = reference("T6_multi_fourbar")
    th, thd = oracles.multiple_four_bar(1, 15, ref["t"])
    for i in range(15):
        assert numpy.max(abs(th[i] - ref[f"th{i + 1}"])) < 1e-11
        assert numpy.max(abs(thd[i] - ref[f"thd{i + 1}"])) < 1e-10


def test_double_pendulum(reference):
    ref = reference("T4_double_pendulum")
    z, zd = oracles.double_pendulum(0.0, ref["t"])
    for i in range(2):
        assert numpy.max(abs(z[i] - ref[f"z{i + 1}"])) < 1e-11
        assert numpy.max(abs(zd[i] - ref[f"z{i + 1}d"])) < 1e-10


def test_four_bar(reference):
    ref = reference("T5_fourbar")
    th, thd = oracles.four_bar((1.0, 0.0), ref["t"])
    assert numpy.max(abs(th[0] - ref["z1"])) < 1e-11
    assert numpy.max(abs(th[1] - th[0] - ref["z2"])) < 1e-11
    assert numpy.max(abs(th[2] - ref["z4"])) < 1e-11
    assert numpy.max(abs(thd[0] - ref["z1d"])) < 1e-11
