"""Sensitivities by hand: equations of motion, every partial derivative written out, one system.

The double pendulum, the four-bar and the slider-crank of ../references, each with what the thesis
differentiates it by ([1] 5.6, "manual differentiation").  Equation and variational equation

    F(q, v, a, b) = 0        F_a a_b = -(F_q q_b + F_v v_b + F_b)

are integrated together by the classical Runge-Kutta method with constant steps, in 80-bit numbers
where the machine has them: what maggi computes by the same steps must be the same to round-off, when
its coordinates are linear in these.
"""

from fractions import Fraction

import numpy

REAL = numpy.longdouble
GRAVITY = REAL("9.81")
SIXTH = REAL(1) / 6


# ------------------------------------------------------------------------------ integration


def _weights(n):
    """Of the integral of the piecewise polynomial of degree 5 through n + 1 samples, step 1."""
    degree = min(5, n)
    interval = []  # weights of the samples of a stencil for each of its intervals
    for k in range(degree):
        row = []
        for i in range(degree + 1):
            polynomial = [Fraction(1)]  # of Lagrange: one at sample i, zero at the others
            for j in range(degree + 1):
                if j == i:
                    continue
                scale = Fraction(1, i - j)
                shifted = [Fraction(0)] + [scale * c for c in polynomial]
                for power, c in enumerate(polynomial):
                    shifted[power] -= j * scale * c
                polynomial = shifted
            row.append(
                sum(
                    c * (Fraction(k + 1) ** (power + 1) - Fraction(k) ** (power + 1)) / (power + 1)
                    for power, c in enumerate(polynomial)
                )
            )
        interval.append([REAL(w.numerator) / REAL(w.denominator) for w in row])
    weights = numpy.zeros(n + 1, REAL)
    for k in range(n):
        first = min(max(k - degree // 2, 0), n - degree)
        weights[first : first + degree + 1] += interval[k - first]
    return weights


class Motion:
    """Columns over time: value first, then the derivatives by the parameters."""

    def __init__(self, parameters, step, columns):
        self.parameters = parameters
        self.step = step
        self.columns = columns

    def value(self, name):
        return self.columns[name][:, 0]

    def derivative(self, name, parameter):
        return self.columns[name][:, 1 + self.parameters.index(parameter)]

    def integral_square(self, name, end=None):
        """Value and gradient of the integral of the square up to sample `end`."""
        x = self.columns[name][: None if end is None else end + 1]
        w = self.step * _weights(len(x) - 1)
        integral = 2 * w @ (x[:, :1] * x)
        integral[0] /= 2
        return integral


def _integrate(acceleration, start, nparameter, time, steps):
    """q, v, a over time, each (steps + 1) x coordinates x (1 + parameters)."""
    h = REAL(time) / steps
    y = numpy.zeros((2, len(start[0]), 1 + nparameter), REAL)
    y[:, :, 0] = start
    nodes = numpy.empty((steps + 1, 3) + y.shape[1:], REAL)

    def slope(z):
        return numpy.stack([z[1], acceleration(z[0], z[1])])

    for k in range(steps + 1):
        k1 = slope(y)
        nodes[k, :2] = y
        nodes[k, 2] = k1[1]
        k2 = slope(y + h / 2 * k1)
        k3 = slope(y + h / 2 * k2)
        k4 = slope(y + h * k3)
        y = y + h * SIXTH * (k1 + 2 * (k2 + k3) + k4)
    return h, nodes[:, 0], nodes[:, 1], nodes[:, 2]


# -------------------------------------------------------------------------- double pendulum

BAR1 = ("m", "Ix", "yCOG", "zCOG", "c", "k")


def double_pendulum(time, steps, bars, start=(-1, 0)):
    """../references/T4_double_pendulum; bars: direction (y, z) of both bars at t = 0.

    Absolute angles x, y of the bars, d = x - y, bar direction (e, f), g gravity, A = Ix + m r^2 + 1:

      F1 = A x'' + cos d y''/2 + sin d y'^2/2 + k x + c x'
           + g (m (yCOG cos x - zCOG sin x) + e cos x - f sin x)
      F2 = cos d x''/2 + y''/3 - sin d x'^2/2 + g/2 (e cos y - f sin y)

    z1 = x and z2 = y - x; start: z1'(0), z2'(0).
    """
    e, f = (REAL(x) for x in bars)
    m, ix, c, k = REAL(1), REAL(1) / 12, REAL(1), REAL(1)
    yc, zc = e / 2, f / 2
    inertia = ix + m * (yc * yc + zc * zc) + 1
    half, third = REAL(1) / 2, REAL(1) / 3

    def acceleration(q, v):
        (x, y), (xd, yd) = q[:, 0], v[:, 0]
        sx, cx, sy, cy = numpy.sin(x), numpy.cos(x), numpy.sin(y), numpy.cos(y)
        sd, cd = numpy.sin(x - y), numpy.cos(x - y)
        determinant = inertia * third - half * cd * half * cd

        def solve(f1, f2):
            """accelerations that balance F1, F2 without them"""
            return numpy.array(
                [half * cd * f2 - third * f1, half * cd * f1 - inertia * f2]
            ) / determinant

        weight = m * (yc * cx - zc * sx) + e * cx - f * sx
        a = numpy.empty_like(q)
        a[:, 0] = xdd, ydd = solve(
            half * sd * yd * yd + k * x + c * xd + GRAVITY * weight,
            -half * sd * xd * xd + GRAVITY / 2 * (e * cy - f * sy),
        )
        # partial derivatives of F1, F2 by x, y, x', y'
        f1x = -half * sd * ydd + half * cd * yd * yd + k
        f1x += GRAVITY * (-m * (yc * sx + zc * cx) - e * sx - f * cx)
        f1y = half * sd * ydd - half * cd * yd * yd
        f1xd = c
        f1yd = 2 * half * sd * yd
        f2x = -half * sd * xdd - half * cd * xd * xd
        f2y = half * sd * xdd + half * cd * xd * xd + GRAVITY / 2 * (-e * sy - f * cy)
        f2xd = -2 * half * sd * xd
        # of F1 by m, Ix, yCOG, zCOG, c, k; F2 has none of them
        f1b = numpy.array(
            [
                (yc * yc + zc * zc) * xdd + GRAVITY * (yc * cx - zc * sx),
                xdd,
                2 * m * yc * xdd + GRAVITY * m * cx,
                2 * m * zc * xdd - GRAVITY * m * sx,
                xd,
                x,
            ]
        )
        (xb, yb), (xdb, ydb) = q[:, 1:], v[:, 1:]
        a[:, 1:] = solve(
            f1x * xb + f1y * yb + f1xd * xdb + f1yd * ydb + f1b, f2x * xb + f2y * yb + f2xd * xdb
        )
        return a

    h, *motion = _integrate(acceleration, [(0, 0), (start[0], sum(start))], 6, time, steps)
    columns = {}
    for name, x in zip(("", "d", "dd"), motion):
        columns["z1" + name] = x[:, 0]
        columns["z2" + name] = x[:, 1] - x[:, 0]
    return Motion(BAR1, h, columns)


# -------------------------------------------------------------------------------- four-bar


def four_bar(time, steps):
    """../references/T5_fourbar, a parallelogram whatever the numbers of the crank are.

    The coupler does not turn and moves as its end B of the crank, the follower turns as the crank.
    J = Ix + m (yCOG^2 + zCOG^2) + 1 + 1/3, heights of the COGs yCOG sin z + zCOG cos z, -cos z,
    -cos z/2:

      F = J z'' + g (m (yCOG cos z - zCOG sin z) + 3/2 sin z) + k z + c z'
    """
    m, ix, yc, zc, c, k = REAL(1), REAL(1) / 12, REAL(0), REAL(-1) / 2, REAL(1), REAL(1)
    inertia = ix + m * (yc * yc + zc * zc) + 1 + REAL(1) / 3

    def acceleration(q, v):
        z, zd = q[0, 0], v[0, 0]
        s, co = numpy.sin(z), numpy.cos(z)
        a = numpy.empty_like(q)
        zdd = -(GRAVITY * (m * (yc * co - zc * s) + 3 * s / 2) + k * z + c * zd) / inertia
        a[0, 0] = zdd
        # partial derivatives of F by z, z' and by m, Ix, yCOG, zCOG, c, k
        fz = GRAVITY * (m * (-yc * s - zc * co) + 3 * co / 2) + k
        fzd = c
        fb = numpy.array(
            [
                (yc * yc + zc * zc) * zdd + GRAVITY * (yc * co - zc * s),
                zdd,
                2 * m * yc * zdd + GRAVITY * m * co,
                2 * m * zc * zdd - GRAVITY * m * s,
                zd,
                z,
            ]
        )
        a[0, 1:] = -(fz * q[0, 1:] + fzd * v[0, 1:] + fb) / inertia
        return a

    h, *motion = _integrate(acceleration, [(0,), (-1,)], 6, time, steps)
    columns = {}
    for name, x in zip(("", "d", "dd"), motion):
        columns["z1" + name] = columns["z4" + name] = x[:, 0]
        columns["z2" + name] = -x[:, 0]
    return Motion(BAR1, h, columns)


# ---------------------------------------------------------------------------- slider-crank


def slider_crank(time, steps):
    """../references/S1_slidercrank_sundials with its loop solved: sin p = -r sin q, r = 1/2.

    x = cos p + r cos q; p' = P q' and x' = X q' with P = -r cos q/cos p, X = r sin q (P - 1); the
    loaded point is at x + cos p, whose rate is E q', E = r sin q (2 P - 1); the spring lies level
    and is x/2 long.  With D = 1 + X^2 + 2 P^2 and dashes for derivatives by q:

      F = D q'' + D' q'^2/2 - E + (k (x/2 - 1) + c X q'/2) X/2
    """
    r, c, k = REAL(1) / 2, REAL(1), REAL(1)

    def geometry(q):
        s, co = numpy.sin(q), numpy.cos(q)
        sp = -r * s
        cp = numpy.sqrt(1 - sp * sp)
        x = cp + r * co
        P = -r * co / cp
        P1 = r * s * (1 - P * P) / cp
        P2 = (r * co * (1 - P * P) - 3 * r * s * P * P1) / cp
        X = r * s * (P - 1)
        X1 = r * co * (P - 1) + r * s * P1
        X2 = -r * s * (P - 1) + 2 * r * co * P1 + r * s * P2
        E = r * s * (2 * P - 1)
        E1 = r * co * (2 * P - 1) + 2 * r * s * P1
        return numpy.arcsin(sp), x, P, P1, P2, X, X1, X2, E, E1

    def acceleration(q, v):
        _, x, P, P1, P2, X, X1, X2, E, E1 = geometry(q[0, 0])
        w = v[0, 0]
        D = 1 + X * X + 2 * P * P
        D1 = 2 * X * X1 + 4 * P * P1
        D2 = 2 * (X1 * X1 + X * X2) + 4 * (P1 * P1 + P * P2)
        force = k * (x / 2 - 1) + c * X * w / 2
        a = numpy.empty_like(q)
        wd = -(D1 * w * w / 2 - E + force * X / 2) / D
        a[0, 0] = wd
        # partial derivatives of F by q, q' and by k, c
        fq = D1 * wd + D2 * w * w / 2 - E1 + (k * X / 2 + c * X1 * w / 2) * X / 2 + force * X1 / 2
        fw = D1 * w + c * X * X / 4
        fb = numpy.array([(x / 2 - 1) * X / 2, X * w / 2 * X / 2])
        a[0, 1:] = -(fq * q[0, 1:] + fw * v[0, 1:] + fb) / D
        return a

    h, q, v, a = _integrate(acceleration, [(numpy.arctan(REAL(1)) * 2,), (0,)], 2, time, steps)
    q, v, a = q[:, 0], v[:, 0], a[:, 0]
    p, x, P, P1, P2, X, X1, X2, _, _ = geometry(q[:, :1])

    def column(value, derivative):
        return numpy.hstack([value, derivative])

    q0, v0, a0, qb, vb, ab = q[:, :1], v[:, :1], a[:, :1], q[:, 1:], v[:, 1:], a[:, 1:]
    columns = {"q": q, "qd": v, "qdd": a}
    for name, z, Z, Z1, Z2 in (("x", x, X, X1, X2), ("p", p, P, P1, P2)):
        columns[name] = column(z, Z * qb)
        columns[name + "d"] = column(Z * v0, Z1 * v0 * qb + Z * vb)
        columns[name + "dd"] = column(
            Z1 * v0 * v0 + Z * a0,
            (Z2 * v0 * v0 + Z1 * a0) * qb + 2 * Z1 * v0 * vb + Z * ab,
        )
    return Motion(("k", "c"), h, columns)


def slider_crank_objective(motion):
    """G, value and gradient."""
    return (
        motion.integral_square("qd") / 2
        + motion.integral_square("xd") / 2
        + motion.integral_square("pd")
    )
