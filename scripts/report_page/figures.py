"""Key figures of a vehicle's run: (label, unit, value, time or None, and where if it is a wheel's)."""
import numpy

from . import measure
from .vehicle import G

STILL = 0.02  # of its range: a steering that moves by less stands still
SLOW_END = 0.1  # share of the run that is its steady end


class Manoeuvre:
    """What the steering does: none, still, step (goes over and stays), ramp (goes on), other."""

    def __init__(self, v):
        self.kind, self.t50 = "none", None
        s = v.get("steer")
        if s is None:
            return
        low, high = float(numpy.min(s)), float(numpy.max(s))
        if high - low < 1e-9:
            self.kind = "still"
            return
        rise, size = s - s[0], high - low
        turn = numpy.sign(rise[int(numpy.argmax(numpy.abs(rise)))])
        self.kind = "other"
        if numpy.min(numpy.diff(turn*rise)) < -1e-6*size or abs(turn*rise[-1] - size) > STILL*size:
            return
        moving = numpy.flatnonzero((turn*rise > STILL*size) & (turn*rise < (1.0 - STILL)*size))
        if len(moving) == 0:
            self.t50 = measure.crossing(v.t, turn*rise, 0.5*size)
            self.kind = "step"
            return
        length = v.t[-1] - v.t[0]
        if v.t[-1] - v.t[moving[-1]] >= 0.2*length and v.t[moving[-1]] - v.t[moving[0]] <= 0.4*length:
            self.kind, self.t50 = "step", measure.crossing(v.t, turn*rise, 0.5*size)
        elif v.t[moving[-1]] - v.t[moving[0]] >= 0.4*length:
            self.kind = "ramp"


def steer_of(v):
    """(angle, what it is): of the front wheels where they are measured, else of the coordinate."""
    if "road_wheel" in v.channel:
        return v.get("road_wheel"), "front wheels"
    return v.get("steer"), "steering coordinate"


def gain_over_time(v):
    """da_y/dδ of [1] figure 3.39 while the steering moves, or None."""
    s, a = v.get("steer"), v.get("ay")
    if s is None or a is None or v.manoeuvre.kind != "ramp":
        return None
    rate = numpy.gradient(s, v.t)
    moves = numpy.abs(rate) > 0.5*numpy.max(numpy.abs(rate))
    gain = numpy.full(len(s), numpy.nan)
    gain[moves] = numpy.gradient(a, v.t)[moves]/rate[moves]
    return gain


def prepare(v):
    v.manoeuvre = Manoeuvre(v)
    v.gain = gain_over_time(v)


def extremes(v):
    """Peaks of the motion."""
    out = []

    def add(label, unit, key, factor=1.0):
        if v.get(key) is not None:
            found = measure.peak(v.t, v.get(key)/factor)
            if found:
                out.append((label, unit, *found))

    add("Lateral acceleration, peak", "g", "ay", G)
    add("Yaw rate, peak", "rad/s", "yaw_rate")
    add("Sideslip angle, peak", "rad", "sideslip")
    add("Roll angle, peak", "rad", "roll")
    add("Roll rate, peak", "rad/s", "roll_rate")
    add("Steering, peak", "rad", "steer")
    for axle in v.axles:
        add(f"Load transfer {axle.name}, peak", "N", f"transfer {axle.name}")
    for axle in v.axles:
        add(f"Load transfer ratio {axle.name}, peak", "-", f"ratio {axle.name}")
    if "speed" in v.channel:
        for name, which in (("smallest", numpy.nanargmin), ("largest", numpy.nanargmax)):
            out.append((f"Speed, {name}", "m/s", *measure.extreme(v.t, v.get("speed"), which)))
    add("Drive torque on a wheel, peak", "N m", "torque")
    add("Vertical acceleration, peak", "m/s^2", "az")
    return out


def of_tyres(v):
    out = []

    def worst(label, unit, table, end, which, size):
        found = []
        for name, columns in table.items():
            if end in columns and measure.extreme(v.t, size(columns[end]), which):
                found.append((*measure.extreme(v.t, size(columns[end]), which), name))
        if found:
            value, time, name = (min if which is numpy.nanargmin else max)(found)
            out.append((label, unit, value, time, name))

    worst("Smallest vertical force of a tyre", "N", v.force, "fz", numpy.nanargmin, lambda s: s)
    worst("Largest vertical force of a tyre", "N", v.force, "fz", numpy.nanargmax, lambda s: s)
    worst("Largest slip angle", "rad", v.slip, "alpha", numpy.nanargmax, numpy.abs)
    worst("Largest longitudinal slip", "-", v.slip, "kappa", numpy.nanargmax, numpy.abs)
    use = {}
    for wheel in v.wheels:
        used = v.friction(wheel)
        if used is not None:
            use[wheel["name"]] = {"use": numpy.hypot(*used)}
    worst("Largest use of friction", "-", use, "use", numpy.nanargmax, lambda s: s)
    return out


def gradients(v):
    """Slopes over the lateral acceleration."""
    out, a = [], v.get("ay")
    if a is None or numpy.nanmax(numpy.abs(a)) < 0.02*G:
        return out
    busy = numpy.isfinite(a) & (numpy.abs(a) > 0.2*numpy.nanmax(numpy.abs(a)))
    if v.get("roll") is not None and numpy.count_nonzero(busy) > 2:
        found = measure.slope(a[busy]/G, v.get("roll")[busy])
        if found:
            out.append(("Roll gradient dφ/da_y", "rad/g", found[0], None))
    if v.manoeuvre.kind in ("ramp", "step"):
        out += understeer(v, a, busy)
    return out


def understeer(v, a, busy):
    """While a ramp goes on, or at the steady end of a step."""
    out = []
    steer, what = steer_of(v)
    yaw, speed = v.get("yaw_rate"), v.get("speed")
    slips = v.axle_slip(v.axles[0]), v.axle_slip(v.axles[-1])
    have = len(v.axles) > 1 and slips[0] is not None and slips[1] is not None
    differ = slips[1] - slips[0] if have else None
    if v.manoeuvre.kind == "ramp":
        slope = lambda s: measure.slope(a[busy]/G, s[busy])[0]
        out.append((f"dδ/da_y, {what}", "rad/g", slope(steer), None))
        if yaw is not None:
            out.append(("Yaw-rate gain dψ'/dδ", "1/s", measure.slope(steer[busy], yaw[busy])[0], None))
        if differ is not None:
            out.append(("Understeer gradient d(α_r − α_f)/da_y", "rad/g", slope(differ), None))
    else:
        end = v.t >= v.t[-1] - SLOW_END*(v.t[-1] - v.t[0])
        mean = lambda s: float(numpy.mean(s[end]))
        d_steer = mean(steer) - float(steer[0])
        out.append((f"Lateral acceleration per steering, steady, {what}", "g/rad", mean(a)/G/d_steer, None))
        if yaw is not None:
            out.append((f"Yaw-rate gain, steady, {what}", "1/s", mean(yaw)/d_steer, None))
        if differ is not None:
            out.append(("Understeer gradient (α_r − α_f)/a_y, steady", "rad/g",
                        mean(differ)/(mean(a)/G), None))
    if "road_wheel" in v.channel and speed is not None and v.wheelbase():
        neutral = v.wheelbase()*G/float(numpy.mean(speed[busy]))**2
        out.append(("Neutral steer L/V² in the same unit", "rad/g", neutral, None))
    return out


def step_response(v):
    """ISO 7401: times from the moment at which half of the steering is there."""
    out, t50 = [], v.manoeuvre.t50
    if v.manoeuvre.kind != "step" or t50 is None:
        return out
    end = v.t >= v.t[-1] - SLOW_END*(v.t[-1] - v.t[0])
    for key, name in (("yaw_rate", "yaw rate"), ("ay", "lateral acceleration")):
        s = v.get(key)
        if s is None or not numpy.all(numpy.isfinite(s)) or abs(numpy.mean(s[end])) < 1e-6:
            continue
        steady = float(numpy.mean(s[end]))
        relative = s/steady
        rise = measure.crossing(v.t, relative, 0.9, t50)
        if rise is None:
            continue
        out.append((f"Response time of {name} (90 %)", "s", rise - t50, rise))
        largest, time = measure.extreme(v.t, numpy.where(v.t >= t50, relative, -numpy.inf))
        if largest > 1.0 + 1e-3 and time < v.t[end][0]:
            out.append((f"Peak time of {name}", "s", time - t50, time))
            out.append((f"Overshoot of {name}", "-", largest - 1.0, time))
            if key == "yaw_rate" and v.get("sideslip") is not None:
                slip = abs(float(numpy.mean(v.get("sideslip")[end])))
                out.append(("TB factor (peak time of yaw rate × steady sideslip)", "s rad",
                            (time - t50)*slip, None))
        out.append((f"Steady {name}", "g" if key == "ay" else "rad/s",
                    steady/G if key == "ay" else steady, None))
    return out


def of_vehicle(v):
    """[(heading, rows)]"""
    groups = [("Motion", extremes(v)), ("Tyres", of_tyres(v)), ("Gradients", gradients(v)),
              ("Response to the step, ISO 7401", step_response(v))]
    return [(heading, rows) for heading, rows in groups if rows]


def of_signal(t, s):
    """(min, at, max, at, rms, rmq, vdv, final) of a column, None where it has no number."""
    if not numpy.all(numpy.isfinite(s)):
        good = numpy.isfinite(s)
        if numpy.count_nonzero(good) < 2:
            return None
        t, s = t[good], s[good]
    low, high = measure.extreme(t, s, numpy.argmin), measure.extreme(t, s)
    return (*low, *high, measure.rms(t, s), measure.rmq(t, s), measure.vdv(t, s), float(s[-1]))
