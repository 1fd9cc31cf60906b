"""Numbers of a signal over time."""
import numpy


def integral(t, s):
    """By the trapezoidal rule on the rows."""
    return float(numpy.sum(0.5*(s[1:] + s[:-1])*numpy.diff(t)))


def rms(t, s):
    return (integral(t, s**2)/(t[-1] - t[0]))**0.5


def rmq(t, s):
    return (integral(t, s**4)/(t[-1] - t[0]))**0.25


def vdv(t, s):
    return integral(t, s**4)**0.25


def extreme(t, s, which=numpy.nanargmax):
    """(value, time) of the largest or smallest s; None where there is no number."""
    if not numpy.any(numpy.isfinite(s)):
        return None
    k = int(which(s))
    return float(s[k]), float(t[k])


def peak(t, s):
    """(signed value, time) of the largest |s|."""
    found = extreme(t, numpy.abs(s))
    if not found:
        return None
    k = int(numpy.nanargmax(numpy.abs(s)))
    return float(s[k]), float(t[k])


def slope(x, y):
    """(slope, R2) of the line of least squares through the points."""
    dx, dy = x - numpy.mean(x), y - numpy.mean(y)
    sxx, syy = float(dx @ dx), float(dy @ dy)
    if sxx <= 0.0:
        return None
    b = float(dx @ dy)/sxx
    return b, 1.0 if syy <= 0.0 else b*b*sxx/syy


def crossing(t, s, level, start=0.0):
    """First time from `start` on at which s, linear between rows, has come up to the level."""
    k = numpy.flatnonzero((s >= level) & (t >= start))
    if len(k) == 0:
        return None
    k = int(k[0])
    if k == 0 or s[k - 1] >= level:
        return float(t[k])
    return float(t[k - 1] + (level - s[k - 1])/(s[k] - s[k - 1])*(t[k] - t[k - 1]))
