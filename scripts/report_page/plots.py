"""Which plots a set of runs gets."""
import re

import numpy

from . import tracks
from .svg import Curve, Plot
from .vehicle import G

MOST = 8  # curves of one run in a plot


def spread(plots, title, label, unit, per_run, note=""):
    """Plots over time of signals, [(name, [(run, t, values)])], in groups of MOST; colours are signals,
    dashes runs, or both runs where there is one signal."""
    for begin in range(0, len(per_run), MOST):
        part = per_run[begin:begin + MOST]
        curves = []
        for k, (name, lines) in enumerate(part):
            for run, t, values in lines:
                several = len(lines) > 1
                text = name if not several else run.label if len(part) == 1 else f"{name}, {run.label}"
                curves.append(Curve(text, t, values, run.number if len(part) == 1 else k, run.number))
        more = f" ({begin//MOST + 1} of {-(-len(per_run)//MOST)})" if len(per_run) > MOST else ""
        plots.append(Plot(title + more, "time", "s", label, unit, curves, note=note))


def channel_lines(vehicles, key, factor=1.0):
    return [(v.run, v.t, v.get(key)/factor) for v in vehicles if v.get(key) is not None]


def over_time(plots, vehicles, title, keys, label=None, unit=None, factor=1.0, names=None, note=""):
    """One plot of channels that at least one vehicle has."""
    first = next((v for v in vehicles for k in keys if k in v.channel), None)
    if first is None:
        return
    per_run, shown = [], None
    for key in keys:
        lines = channel_lines(vehicles, key, factor)
        if lines:
            shown = shown or next(v.channel[key] for v in vehicles if key in v.channel)
            name = (names or {}).get(key) or next(v.channel[key].label for v in vehicles
                                                  if key in v.channel)
            per_run.append((name, lines))
    if not note and len(vehicles) == 1 and shown.source:
        note = f"Of: {shown.source}."
    spread(plots, title, label or shown.label, unit or shown.unit, per_run, note)


def wheel_lines(vehicles, table, end):
    names = [w["name"] for w in vehicles[0].wheels]
    out = []
    for name in names:
        lines = [(v.run, v.t, getattr(v, table)[name][end]) for v in vehicles
                 if end in getattr(v, table).get(name, {})]
        if lines:
            out.append((name, lines))
    return out


def handling(vehicles):
    """Figures 3.28 to 3.39 of [1], and what a tyre sees."""
    plots = []
    over_time(plots, vehicles, "Steering input", ["steer"])
    over_time(plots, vehicles, "Angle of the front wheels", ["road_wheel"])
    over_time(plots, vehicles, "Lateral acceleration", ["ay"], "lateral acceleration", "g", G)
    if len(vehicles) == 1 and "ay" in vehicles[0].channel:
        v = vehicles[0]
        lines = [("exact (3.19)", [(v.run, v.t, v.get("ay_exact")/G)]),
                 ("approximate (3.21)", [(v.run, v.t, v.get("ay_approximate")/G)]),
                 ("their difference", [(v.run, v.t, (v.get("ay_approximate") - v.get("ay_exact"))/G)])]
        spread(plots, "Lateral acceleration, exact and approximate", "lateral acceleration", "g", lines)
    over_time(plots, vehicles, "Roll angle", ["roll"])
    over_time(plots, vehicles, "Yaw rate", ["yaw_rate"])
    over_time(plots, vehicles, "Sideslip angle", ["sideslip"])
    for axle in vehicles[0].axles:
        over_time(plots, vehicles, f"Load transfer, {axle.name}", [f"transfer {axle.name}"],
                  label="ΔFz, right − left", note="Vertical forces of the right tyres less those of the left.")
    gain = [(v.run, v.t, v.gain) for v in vehicles if getattr(v, "gain", None) is not None]
    if gain:
        spread(plots, "Gain of the lateral acceleration, da_y/dδ", "da_y/dδ", "m/s^2/rad",
               [("da_y/dδ", gain)], "Of the rates of both over time, while the steering moves.")
    return plots


def tyres(vehicles):
    plots = []
    for end, axis in (("fz", "vertical force"), ("fy", "lateral force"), ("fx", "longitudinal force")):
        lines = wheel_lines(vehicles, "force", end)
        if lines:
            spread(plots, f"Tyres: {axis}", axis, "N", lines)
    for end, axis, unit in (("alpha", "slip angle", "rad"), ("kappa", "longitudinal slip", "-"),
                            ("gamma", "inclination", "rad")):
        lines = wheel_lines(vehicles, "slip", end)
        if lines:
            spread(plots, f"Tyres: {axis}", axis, unit, lines)
    for end, axis in (("mz", "aligning moment"), ("mx", "overturning moment"), ("my", "rolling moment")):
        lines = wheel_lines(vehicles, "moment", end)
        if lines:
            spread(plots, f"Tyres: {axis}", axis, "N m", lines)
    ellipse = []
    for k, wheel in enumerate(vehicles[0].wheels):
        for v in vehicles:
            used = v.friction(wheel)
            if used is not None:
                name = wheel["name"] if len(vehicles) == 1 else f"{wheel['name']}, {v.run.label}"
                ellipse.append(Curve(name, used[1], used[0], k, v.run.number))
    if ellipse:
        angle = numpy.linspace(0.0, 2*numpy.pi, 181)
        circle = Curve("limit", numpy.cos(angle), numpy.sin(angle))
        plots.append(Plot("Friction used: forces over the largest at this load", "lateral, Fy/(μy Fz)", "-",
                          "longitudinal, Fx/(μx Fz)", "-", ellipse, [circle], equal=True))
    return plots


def travel(vehicles, width):
    """Path, speed, and what a passenger feels: figures 3.25, 3.29, 3.41, 3.44."""
    plots, curves = [], []
    for v in vehicles:
        if v.get("x") is not None:
            curves.append(Curve(v.run.label if len(vehicles) > 1 else "path of the body", v.get("x"),
                                v.get("y"), v.run.number, v.run.number))
    if curves:
        track = tracks.double_lane_change(vehicles[0], width)
        plots.append(Plot("Path seen from above", "x", "m", "y", "m", curves,
                          [Curve(label, x, y) for label, x, y in track],
                          note=tracks.NOTE.format(width=tracks.width_of(vehicles[0], width))
                          if track else ""))
    over_time(plots, vehicles, "Speed", ["speed"])
    over_time(plots, vehicles, "Drive torque of the speed controller", ["torque"], "torque on a wheel")
    over_time(plots, vehicles, "Vertical position", ["z"])
    over_time(plots, vehicles, "Pitch angle", ["pitch"])
    over_time(plots, vehicles, "Vertical acceleration", ["az"])
    over_time(plots, vehicles, "Roll acceleration", ["roll_acceleration"])
    return plots


# ------------------------------------------------------------------ any model


def lines_of(runs, column):
    return [(run, run.t, run.table[column]) for run in runs]


def grouped(plots, runs, columns, title, label, unit, cut=""):
    if columns:
        spread(plots, title, label, unit or "SI",
               [(c[:len(c) - len(cut)] if cut and c.endswith(cut) else c, lines_of(runs, c))
                for c in columns])


def coordinates(runs, common):
    plots = []
    for end, what in (("q", "position"), ("v", "velocity"), ("a", "acceleration")):
        columns = [c for c in common if runs[0].kind(c) == "coordinate" and c.endswith("." + end)]
        units = dict.fromkeys(runs[0].unit.get(c) for c in columns)
        for unit in units:
            mine = [c for c in columns if runs[0].unit.get(c) == unit]
            turn = unit and unit.startswith("rad")
            name = {"position": "angle"}.get(what, "angular " + what) if turn else what
            grouped(plots, runs, mine, f"Coordinates: {name}", name, unit, "." + end)
    return plots


def sensors(runs, common, has_tyres):
    """A plot for each type of sensor and column of it; tyres may have theirs."""
    plots, groups = [], {}
    for c in common:
        sensor = runs[0].sensors.get(c, {})
        if runs[0].kind(c) != "sensor" or has_tyres and sensor.get("type", "").startswith("tyre_"):
            continue
        kind = sensor.get("type", "sensor").replace("_", " ")
        stem, end = (sensor["sensor"], c[len(sensor["sensor"]) + 1:]) if "sensor" in sensor else \
            (c.rpartition(".")[0], "")
        groups.setdefault((kind, end, runs[0].unit.get(c)), []).append((c, stem))
    for (kind, end, unit), columns in groups.items():
        title = f"Sensors: {kind} {end}".strip().replace("_", " ")
        name = re.sub("_", " ", f"{kind} {end}").strip() if end else "value"
        grouped(plots, runs, [c for c, _ in columns], title, name, unit, "." + end if end else "")
    return plots


def balance(runs, common):
    """Energies, and what they add up to."""
    plots = []
    names = [c for c in common if runs[0].kind(c) == "energy"]
    grouped(plots, runs, names, "Energy", "energy", "J")
    if {"energy.total", "energy.work"} <= set(names):
        off = []
        for run in runs:
            total = run.table["energy.total"] - run.table["energy.work"]
            off.append((run, run.t, total - total[0]))
        spread(plots, "Energy balance: kinetic + potential − work, less its start", "energy", "J",
               [("balance", off)])
    grouped(plots, runs, [c for c in common if c == "loops.pivot_ratio"], "Loops: pivot ratio",
            "pivot ratio", "-")
    grouped(plots, runs, [c for c in common if c == "loops.violation"], "Loops: violation", "violation",
            "m, rad")
    return plots


def reactions(runs, common):
    plots = []
    columns = [c for c in common if runs[0].kind(c) == "reaction"]
    for body in dict.fromkeys(c.rpartition(".")[0] for c in columns):
        for letter, what, unit in (("f", "force", "N"), ("m", "moment", "N m")):
            grouped(plots, runs, [f"{body}.{letter}{axis}" for axis in "xyz"],
                    f"Joint of {body}: {what}", what, unit)
    return plots


__all__ = ["handling", "tyres", "travel", "coordinates", "sensors", "balance", "reactions"]
