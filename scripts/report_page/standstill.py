"""Static equilibrium and modes of vehicles, as maggi equilibrium and maggi modes find them."""
import calendar
import html
import json
import os
import subprocess
import time

from . import sheet

PATIENCE = 120  # at most for a command [s]
MODES = 30  # rows of the table


def changed(run):
    """Whether the model file is not the one of the run any more."""
    path = run.record.get("path")
    if not path:
        return False
    try:
        made = calendar.timegm(time.strptime(run.record["date"], "%Y-%m-%dT%H:%M:%SZ"))
        return os.path.getmtime(path) > made + 1.0
    except (OSError, KeyError, ValueError):
        return True


def ask(maggi, command, run):
    """What `maggi COMMAND MODEL --json` says of the model of a run, {} if nothing."""
    file = run.record.get("path") or run.record.get("file")
    if not maggi or not file or changed(run):
        return {}
    arguments = [maggi, command, file, "--json"]
    for path, value in run.record.get("set", {}).items():
        arguments += ["--set", f"{path}={value!r}"]
    try:
        done = subprocess.run(arguments, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              timeout=PATIENCE, check=False)
        return json.loads(done.stdout) if done.returncode == 0 else {}
    except (OSError, ValueError, subprocess.TimeoutExpired):
        return {}


def named(found, part):
    return {entry["name"]: entry for entry in found.get(part, [])}


def equilibrium(vehicles, found):
    rows, wheels = [], [named(f, "wheels") for f in found]
    for k, axle in enumerate(vehicles[0].axles):
        cells = []
        for v, loads in zip(vehicles, wheels):
            names = [w["name"] for w in v.axles[k].wheels] if k < len(v.axles) else []
            whole = names and all(name in loads for name in names)
            cells.append(sheet.number(sum(loads[n]["load"] for n in names)/sheet.gravity(v.run)) if whole
                         else "–")
        rows.append([f"Axle {axle.name}: load", "kg"] + cells)
    for name in dict.fromkeys(n for loads in wheels for n in loads):
        rows.append([f"Tyre {html.escape(name)}: load", "N"] +
                    [sheet.number(loads[name]["load"] if name in loads else None) for loads in wheels])
    springs = [named(f, "springs") for f in found]
    for name in dict.fromkeys(n for each in springs for n in each):
        rows.append([f"Spring {html.escape(name)}: length / force", "m / N"] + [
            f"{sheet.number(each[name]['length'])} / {sheet.number(round(each[name]['force'], 6) + 0.0)}"
            if name in each else "–" for each in springs])
    return rows


def modes(found):
    """Frequencies and damping, in the order of the command; the first ones."""
    lists, rows = [f.get("modes", []) for f in found], []
    for k in range(min(MODES, max(map(len, lists), default=0))):
        row = [str(k + 1)]
        for each in lists:
            mode = each[k] if k < len(each) else None
            row += ["–"]*3 if mode is None else [
                sheet.number(mode["frequency"], 4), sheet.number(mode["damping"], 3),
                html.escape(mode["coordinate"])]
        rows.append(row)
    return rows


def sections(vehicles, maggi):
    text, runs = "", [v.run for v in vehicles]
    labels = [html.escape(run.label) if len(runs) > 1 else "value" for run in runs]
    found = [ask(maggi, "equilibrium", run) for run in runs]
    if any(found):
        text += sheet.card("Static equilibrium", sheet.table(["", "unit"] + labels,
                                                             equilibrium(vehicles, found), "num"))
    found = [ask(maggi, "modes", run) for run in runs]
    if any(f.get("modes") for f in found):
        head = ["mode"]
        for label in labels:
            of = f" {label}" if len(runs) > 1 else ""
            head += [f"frequency [Hz]{of}", f"damping [-]{of}", f"moves most{of}"]
        text += sheet.card("Modes", sheet.table(head, modes(found), "num"))
    return text
