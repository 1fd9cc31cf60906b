"""Tables of the page: how it was run, the model, the vehicle, the manoeuvre."""
import html

import numpy

from .svg import pretty


def number(value, digits=5):
    if value is None or (isinstance(value, float) and not numpy.isfinite(value)):
        return "–"
    return f"{value + 0:.{digits}g}".replace("-", "−")  # + 0: no minus before a zero


def cell(value, unit=""):
    return f'{number(value)}{" " + pretty(unit) if unit not in ("", "-") else ""}'


def card(title, text):
    """A part that stands beside others where there is room."""
    return f"<div><h3>{title}</h3>{text}</div>" if text else ""


def table(head, rows, kind=""):
    """Rows of texts; the first is a heading of its row."""
    text = [f'<div class="wide"><table class="{kind}">']
    if head:
        text.append("<thead><tr>" + "".join(f'<th scope="col">{h}</th>' for h in head) + "</tr></thead>")
    text.append("<tbody>")
    for first, *rest in rows:
        if kind == "" and len(rest) > 1 and len(set(rest)) == 1:
            text.append(f'<tr><th scope="row">{first}</th><td colspan="{len(rest)}">{rest[0]}</td></tr>')
            continue
        text.append(f'<tr><th scope="row">{first}</th>' + "".join(f"<td>{c}</td>" for c in rest) + "</tr>")
    text.append("</tbody></table></div>")
    return "".join(text)


def how(runs):
    """How each run was made."""
    head = [""] + [html.escape(run.label) for run in runs] if len(runs) > 1 else None
    rows = []

    def add(title, value):
        cells = [value(run) for run in runs]
        if any(c not in (None, "") for c in cells):
            rows.append([title] + [html.escape(str(c)) if c not in (None, "") else "–" for c in cells])

    def of_run(key):
        return lambda run: run.record.get("run", {}).get(key)

    add("Model", lambda run: run.title)
    add("Model file", lambda run: run.record.get("path") or run.record.get("file"))
    add("Table", lambda run: run.name if run.kept else "")
    add("Date", lambda run: run.record.get("date", "").replace("T", " ").replace("Z", " UTC"))
    add("maggi", lambda run: run.record.get("maggi"))
    add("Set", lambda run: ", ".join(f"{k} = {number(v, 12)}" for k, v in run.record.get("set", {}).items())
        or ("nothing" if run.record else ""))
    add("Formulation", of_run("formulation"))
    add("Time", lambda run: f"{number(float(run.t[-1]), 9)} s" + (
        ", interrupted" if run.record.get("run", {}).get("interrupted") else ""))
    add("Step", lambda run: f"{number(of_run('step')(run), 9)} s" if run.record else "")
    add("Rows", lambda run: len(run.t))
    add("Computed in", lambda run: f"{number(of_run('wall_s')(run), 3)} s" if run.record else "")
    add("Energy drift", lambda run: number(of_run("energy_drift")(run), 2) if run.record else "")
    add("Largest violation of a loop", lambda run: number(of_run("max_loop_violation")(run), 2)
        if run.record and run.model.get("loops") else "")
    text = table(head, rows)
    for run in runs:
        if run.record.get("command"):
            text += f'<pre tabindex="0"><code>{html.escape(run.record["command"])}</code></pre>'
    return text


# ------------------------------------------------------------------ the model


def masses(run):
    """(total mass, centre of gravity as the file has it) of bodies, point masses and rods."""
    total, moment = 0.0, numpy.zeros(3)
    for path, mass in run.parameter.items():
        if not path.endswith(".mass"):
            continue
        stem = path[:-5]
        points = [run.point(stem + end) for end in (".cog", ".point")]
        points = [p for p in points if p is not None]
        for ends in ((".bar.from", ".bar.to"), (".point_a", ".point_b")):
            pair = [run.point(stem + end) for end in ends]
            if pair[0] is not None and pair[1] is not None:
                points.append(0.5*(pair[0] + pair[1]))
        if points and stem.split(".")[0] in ("bodies", "rods"):
            total += mass
            moment += mass*points[0]
    return total, moment/total if total > 0.0 else None


def gravity(run):
    """Its size in the model [m/s^2]."""
    g = run.point("gravity")
    return float(numpy.linalg.norm(g)) or 9.81 if g is not None else 9.81


def model(runs):
    head = [""] + [html.escape(run.label) for run in runs] if len(runs) > 1 else None
    rows = []

    def add(title, value):
        cells = [value(run) if run.model else None for run in runs]
        if any(c is not None for c in cells):
            rows.append([title] + ["–" if c is None else c for c in cells])

    add("Bodies", lambda run: str(len(run.model["bodies"])))
    add("Coordinates", lambda run: "{} ({} guided)".format(
        len(run.model["coordinates"]), sum(c["guided"] for c in run.model["coordinates"])))
    add("Degrees of freedom", lambda run: str(run.model["dof"]))
    add("Loops", lambda run: "{} with {} equations of rank {}".format(
        len(run.model["loops"]), run.model["loop_equations"], run.model["rank"]))
    add("Mass", lambda run: cell(masses(run)[0], "kg"))
    add("Centre of gravity, as in the file", lambda run: "({}) m".format(
        ", ".join(number(round(float(x), 9) + 0.0, 4) for x in masses(run)[1])) if masses(run)[1] is not None else None)
    add("Source", lambda run: html.escape(run.model.get("source", "")) or None)
    return table(head, rows)


def vehicle(vehicles):
    """Wheelbase, tracks, tyres."""
    rows = [["Body that carries the wheels"] + [html.escape(str(v.body)) for v in vehicles]]
    if vehicles[0].wheelbase():
        rows.append(["Wheelbase"] + [cell(v.wheelbase(), "m") for v in vehicles])
    for k, axle in enumerate(vehicles[0].axles):
        mine = [v.axles[k] if k < len(v.axles) else axle for v in vehicles]
        rows.append([f"Axle {axle.name}: wheels"] +
                    [html.escape(", ".join(w["name"] for w in a.wheels)) for a in mine])
        rows.append([f"Axle {axle.name}: track"] + [cell(a.track(), "m") for a in mine])
        loads = [v.vertical(a.wheels)[0]/gravity(v.run) if v.has(a, v.force) else None for v, a in zip(vehicles, mine)]
        if any(load is not None for load in loads):
            rows.append([f"Axle {axle.name}: load at t = 0"] + [cell(load, "kg") for load in loads])
    rows.append(["Tyres"] + [html.escape(", ".join(dict.fromkeys(w["tyre"] for w in v.wheels)))
                             for v in vehicles])
    rows.append(["Road"] + [html.escape(", ".join(road(v))) for v in vehicles])
    head = [""] + [html.escape(v.run.label) for v in vehicles] if len(vehicles) > 1 else None
    return table(head, rows)


def at_start(runs, vehicles):
    """Tyres and springs at t = 0, which is the static equilibrium where a model starts in it."""
    text, head = "", ["", "unit"] + [html.escape(r.label) if len(runs) > 1 else "value" for r in runs]
    rows, by_run = [], {v.run: v for v in vehicles}
    for name in dict.fromkeys(w["name"] for v in vehicles for w in v.wheels):
        loads = [by_run[r].force.get(name, {}).get("fz") if r in by_run else None for r in runs]
        if any(load is not None for load in loads):
            rows.append([f"Tyre {html.escape(name)}: load", "kg"] +
                        [number(None if load is None else float(load[0])/gravity(r))
                         for load, r in zip(loads, runs)])
    springs = dict.fromkeys(s["sensor"] for r in runs for s in r.sensors.values()
                            if s.get("type") == "spring")
    for name in springs:
        cells = []
        for r in runs:
            length, force = (r.table.get(f"{name}.{end}") for end in ("length", "force"))
            cells.append("–" if length is None else
                         f"{number(float(length[0]))} / {number(round(float(force[0]), 6) + 0.0)}")
        rows.append([f"Spring {html.escape(name)}: length / force", "m / N"] + cells)
    if rows:
        text = card(f"At the start, t = {number(float(runs[0].t[0]))} s", table(head, rows, "num"))
    return text


def road(v):
    kinds = {r["name"]: r["type"] for r in v.run.model.get("roads", [])}
    return [f"{name} ({kinds.get(name, '?')})" for name in dict.fromkeys(w["road"] for w in v.wheels)]


def manoeuvre(runs, vehicles):
    """What is imposed: guided coordinates and their functions, speed, road, duration."""
    rows = [["Duration"] + [cell(float(run.t[-1] - run.t[0]), "s") for run in runs]]
    by_run = {v.run: v for v in vehicles}
    speeds = [by_run[run].get("speed") if run in by_run else None for run in runs]
    if any(s is not None for s in speeds):
        rows.append(["Speed at the start, at the end"] + [
            "–" if s is None else f"{cell(float(s[0]), 'm/s')} ({number(3.6*float(s[0]), 4)} km/h), "
            f"{cell(float(s[-1]), 'm/s')}" for s in speeds])
    if by_run:
        rows.append(["Road"] + [html.escape(", ".join(road(by_run[run]))) if run in by_run else "–"
                                for run in runs])
        rows.append(["Steering"] + [kind(by_run[run]) if run in by_run else "–" for run in runs])
    kinds = {f["name"]: f["type"] for f in runs[0].model.get("functions", [])}
    for c in runs[0].coordinates.values():
        if not c.get("guided"):
            continue
        cells = []
        for run in runs:
            s, name = run.table.get(c["name"] + ".q"), c.get("motion", "?")
            cells.append("–" if s is None else f"function {html.escape(name)} ({kinds.get(name, '?')}), "
                         f"from {cell(float(s.min()), c['unit'])} to {cell(float(s.max()), c['unit'])}")
        rows.append([f"Guided: {html.escape(c['name'])}"] + cells)
    head = [""] + [html.escape(run.label) for run in runs] if len(runs) > 1 else None
    return table(head, rows)


def kind(v):
    return {"none": "no guided steering angle", "still": "stands still", "step": "step: goes over and stays",
            "ramp": "ramp: goes on to the end", "other": "goes to and fro"}[v.manoeuvre.kind]
