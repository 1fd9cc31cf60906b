"""The sensitivities by hand against the reference files, before maggi is compared with them."""

import analytical
import numpy
import pytest

CASES = {
    "T4_double_pendulum": (
        lambda steps: analytical.double_pendulum(5, steps, (1, 0)),
        {"J1": "z2", "J2": "z1", "J3": "z2d", "J4": "z2dd"},
    ),
    "T5_fourbar": (
        lambda steps: analytical.four_bar(5, steps),
        {"J1": "z4", "J2": "z2", "J3": "z4d", "J4": "z4dd"},
    ),
    "S1_slidercrank_sundials": (lambda steps: analytical.slider_crank(10, steps), {}),
}


def distance(x, ref):
    return numpy.max(abs(x - ref)) / numpy.max(abs(ref))


@pytest.mark.parametrize("case", CASES)
def test_analytical(reference, case):
    """Order 4 in each value and derivative; extrapolated, they are the reference."""
    compute, objectives = CASES[case]
    values, derivatives = reference(case), reference(case, "sensitivities.csv")
    n = len(values["t"]) - 1
    coarse, fine = compute(5 * n), compute(10 * n)
    names = {name: values[name] for name in fine.columns}
    pairs = []
    for name in fine.columns:
        pairs.append((coarse.value(name)[::5], fine.value(name)[::10], values[name]))
        for b in fine.parameters:
            pairs.append(
                (
                    coarse.derivative(name, b)[::5],
                    fine.derivative(name, b)[::10],
                    derivatives[f"d{name}/d{b}"],
                )
            )
    for objective, name in objectives.items():
        ref = [derivatives[objective][-1]]
        ref += [derivatives[f"d{objective}/d{b}"][-1] for b in fine.parameters]
        x, y = coarse.integral_square(name), fine.integral_square(name)
        pairs.append((x / ref, y / ref, numpy.ones(len(ref))))
    assert len(pairs) > 20
    for x, y, ref in pairs:
        assert 10 < numpy.max(abs(x - ref)) / numpy.max(abs(y - ref)) < 20
        assert distance(y + (y - x) / 15, ref) < 1e-9


def test_slider_crank_objective():
    """the published gradient of SUNDIALS, to the digits of the reference"""
    ref = numpy.array([3.336606799482784408, 0.33344810612843790677, -0.36375403397094977105])
    g = [
        analytical.slider_crank_objective(analytical.slider_crank(10, n)).astype(float)
        for n in (1000, 2000)
    ]
    assert numpy.all(abs(g[1] - ref) < abs(g[0] - ref) / 12)
    assert distance(g[1] + (g[1] - g[0]) / 15, ref) < 1e-12


@pytest.mark.parametrize("n", [1, 2, 3, 5, 6, 7, 11, 40])
def test_quadrature(n):
    """polynomials of degree 5 (fewer points: less) are integrated exactly"""
    t = numpy.arange(n + 1) / analytical.REAL(n)
    for degree in range(min(5, n) + 1):
        w = analytical._weights(n) / n
        assert abs(w @ t**degree - 1 / analytical.REAL(degree + 1)) < 1e-15
    if n >= 40:
        assert numpy.max(abs(n * w[10:-10] - 1)) < 1e-15
