"""Equations of motion in minimal coordinates, for what no reference file covers.

They share nothing with maggi, are integrated by scipy's DOP853 at the edge of double precision, and
are themselves compared with the reference files in test_oracles.py.
"""

import numpy
from scipy.integrate import solve_ivp
from scipy.special import ellipj, ellipk

GRAVITY = 9.81


def _integrate(acceleration, q, v, times):
    n = len(q)
    solution = solve_ivp(
        lambda t, y: numpy.concatenate([y[n:], acceleration(y[:n], y[n:])]),
        (0.0, times[-1]),
        numpy.concatenate([q, v]),
        method="DOP853",
        t_eval=times,
        rtol=3e-14,
        atol=1e-14,
    )
    assert solution.success
    return solution.y[:n], solution.y[n:]


def pendulum(times):
    """phi(t), from the downward vertical, of a pendulum of 1 m released at phi = -pi/2."""
    m = 0.5  # sin(phi_max / 2)^2
    sn = ellipj(ellipk(m) - numpy.sqrt(GRAVITY) * numpy.asarray(times), m)[0]
    return -2.0 * numpy.arcsin(numpy.sqrt(m) * sn)


def multiple_four_bar(ny, nz, times):
    """th_i(t), rows by times: absolute angles of the verticals, ../references/T6_multi_fourbar."""
    i = numpy.arange(1, nz + 1)
    m = numpy.maximum.outer(i, i)
    c = (ny + 1) * (0.5 + nz - m) + ny * (nz - m + 1)
    c[i - 1, i - 1] = (ny + 1) * (1.0 / 3.0 + nz - i) + ny * (nz - i + 1)
    weight = GRAVITY * ((ny + 1) * (0.5 + nz - i) + ny * (nz - i + 1))

    def acceleration(th, thd):
        delta = th[:, None] - th[None, :]
        right = -weight * numpy.sin(th) - (c * numpy.sin(delta)) @ thd**2
        return numpy.linalg.solve(c * numpy.cos(delta), right)

    return _integrate(acceleration, numpy.zeros(nz), numpy.full(nz, numpy.pi / 3.0), times)


def double_pendulum(start, times):
    """z(t), z'(t) of ../references/T4_double_pendulum, bars at first at the angle start from +Y."""

    def acceleration(z, zd):
        a, b = start + z[0], start + z[0] + z[1]
        ad, bd = zd[0], zd[0] + zd[1]
        mass = [[4.0 / 3.0, 0.5 * numpy.cos(a - b)], [0.5 * numpy.cos(a - b), 1.0 / 3.0]]
        right = [
            -0.5 * numpy.sin(a - b) * bd**2 - 1.5 * GRAVITY * numpy.cos(a) - z[0] - zd[0],
            0.5 * numpy.sin(a - b) * ad**2 - 0.5 * GRAVITY * numpy.cos(b),
        ]
        add, bdd = numpy.linalg.solve(mass, right)
        return numpy.array([add, bdd - add])

    return _integrate(acceleration, numpy.zeros(2), numpy.array([-1.0, 0.0]), times)


def four_bar(end, times):
    """Angles, rates of crank, coupler, follower of ../references/T5_fourbar with D at (0, *end).

    Three absolute angles about +X with two multipliers.
    """
    bars = numpy.array([[0.0, -1.0], [1.0, 0.0], [1.0 - end[0], -1.0 - end[1]]]).T  # AB, BC, DC
    sign = numpy.array([1.0, 1.0, -1.0])  # AB + BC - DC = AD
    arms = numpy.zeros((3, 3))  # COG of bar k = sum of arms[k, j] bar j
    arms[0, 0] = arms[1, 1] = arms[2, 2] = 0.5
    arms[1, 0] = 1.0
    inertia = numpy.diag(numpy.sum(bars**2, axis=0) / 12.0)

    def geometry(th):
        u = numpy.cos(th) * bars + numpy.sin(th) * numpy.array([-bars[1], bars[0]])
        return u, numpy.array([-u[1], u[0]])

    def acceleration(th, thd):
        u, w = geometry(th)
        mass = inertia + (arms.T @ arms) * (w.T @ w)
        centrifugal = arms @ (u * thd**2).T  # of each COG, reversed
        force = numpy.array([-th[0] - thd[0], 0.0, 0.0])
        for k in range(3):
            force = force + (arms[k] * w).T @ (numpy.array([0.0, -GRAVITY]) + centrifugal[k])
        loop = sign * w
        system = numpy.block([[mass, loop.T], [loop, numpy.zeros((2, 2))]])
        return numpy.linalg.solve(system, numpy.append(force, u @ (sign * thd**2)))[:3]

    _, w = geometry(numpy.zeros(3))
    rest = numpy.linalg.solve((sign * w)[:, 1:], w[:, 0])
    return _integrate(acceleration, numpy.zeros(3), numpy.append(-1.0, rest), times)
