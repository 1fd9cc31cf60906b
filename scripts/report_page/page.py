"""The page: sections in their order."""
import html
import json
import os

from . import figures, plots, sheet, standstill, svg
from .svg import pretty
from .vehicle import Vehicle, is_vehicle

FOLDER = os.path.dirname(os.path.realpath(__file__))
MOST_SIGNALS = 24  # rows of the table of all signals that are shown unfolded


def beside(name):
    with open(os.path.join(FOLDER, name), encoding="utf-8") as file:
        return file.read()


def script():
    """What reads numbers off the curves."""
    sizes = {"WIDTH": svg.WIDTH, "LEFT": svg.LEFT, "TOP": svg.TOP, "FINE": svg.FINE,
             "W": svg.WIDTH - svg.LEFT - svg.RIGHT, "H": svg.HEIGHT - svg.TOP - svg.BOTTOM}
    return f"const SIZE = {json.dumps(sizes)};\n" + beside("hover.js")


def common_columns(runs):
    """(columns that all have with the same unit, those that only some have)."""
    every = list(dict.fromkeys(c for run in runs for c in run.table))
    common = [c for c in runs[0].table if c != "t" and all(
        c in run.table and run.unit.get(c) == runs[0].unit.get(c) for run in runs)]
    return common, [c for c in every if c != "t" and c not in common]


def section(name, title, body):
    return f'<section id="{name}" aria-labelledby="{name}-h"><h2 id="{name}-h">{title}</h2>{body}</section>' \
        if body else ""


def row(cards):
    return f'<div class="cards">{cards}</div>' if cards else ""


def draw(found):
    """A grid of plots, "" when there is none with a number in it."""
    text = "".join(plot.draw() for plot in found)
    return f'<div class="plots">{text}</div>' if text else ""


def folded(title, body, is_open=False):
    return f'<details{" open" if is_open else ""}><summary>{title}</summary>{body}</details>' if body else ""


# ------------------------------------------------------------------ key figures


def place(time, wheel=None):
    """When, and at which wheel."""
    words = ([f"at {sheet.number(time, 4)} s"] if time is not None else []) + \
        ([html.escape(wheel)] if wheel else [])
    return f' <small>{", ".join(words)}</small>' if words else ""


def vehicle_figures(vehicles):
    """Tables of what each vehicle came to, side by side."""
    each = [dict(figures.of_vehicle(v)) for v in vehicles]
    text = []
    for heading in dict.fromkeys(h for groups in each for h in groups):
        rows, labels = [], dict.fromkeys((r[0], r[1]) for groups in each for r in groups.get(heading, []))
        for label, unit in labels:
            cells = []
            for groups in each:
                row = next((r for r in groups.get(heading, []) if r[0] == label), None)
                cells.append("–" if row is None else sheet.number(row[2]) + place(*row[3:]))
            rows.append([html.escape(label), html.escape(pretty(unit))] + cells)
        head = ["", "unit"] + [html.escape(v.run.label) if len(vehicles) > 1 else "value" for v in vehicles]
        text.append(sheet.card(heading, sheet.table(head, rows, "num")))
    return "".join(text)


def objectives(runs):
    """Those that the model declares, or why they have no value."""
    found = [{o["name"]: o for o in run.record.get("run", {}).get("objectives", [])} for run in runs]
    names = list(dict.fromkeys(n for run in runs for n in run.model.get("objectives", [])))
    if not names:
        return ""
    if not any(found):
        return sheet.card("Objectives", '<p class="note">The model declares ' + html.escape(", ".join(names)) +
                          "; maggi simulate --objectives evaluates them.</p>")
    rows = []
    for name in names:
        unit = next((f[name]["unit"] for f in found if name in f), "")
        rows.append([html.escape(name), html.escape(pretty(unit))] +
                    [sheet.number(f[name]["value"], 8) if name in f else "–" for f in found])
    head = ["", "unit"] + [html.escape(run.label) if len(runs) > 1 else "value" for run in runs]
    return sheet.card("Objectives", sheet.table(head, rows, "num"))


def all_signals(runs, columns):
    rows = []
    for c in columns:
        for run in runs:
            found = figures.of_signal(run.t, run.table[c])
            if found is None:
                continue
            low, t_low, high, t_high, *rest = found
            name = html.escape(c) + (f" <small>{html.escape(run.label)}</small>" if len(runs) > 1 else "")
            rows.append([name, html.escape(pretty(run.unit.get(c) or "")), sheet.number(low),
                         sheet.number(t_low, 4), sheet.number(high), sheet.number(t_high, 4)] +
                        [sheet.number(x) for x in rest])
    head = ["", "unit", "min", "at [s]", "max", "at [s]", "RMS", "RMQ", "VDV", "final"]
    text = sheet.table(head, rows, "num")
    return folded(f"All signals: {len(columns)} columns", text + (
        '<p class="note">RMS = (∫s²dt/T)^(1/2), RMQ = (∫s⁴dt/T)^(1/4), VDV = (∫s⁴dt)^(1/4), in the unit of the '
        'signal, VDV in that times s^(1/4); integrals by the trapezoidal rule on the rows of the table.</p>'),
        len(rows) <= MOST_SIGNALS)


# ------------------------------------------------------------------ all of it


def build(runs, title, maggi, width):
    """The text of the page."""
    for number, run in enumerate(runs):
        run.number = number
    common, rest = common_columns(runs)
    vehicles = [Vehicle(run) for run in runs if is_vehicle(run)]
    for v in vehicles:
        figures.prepare(v)
    title = title or " / ".join(dict.fromkeys(run.title for run in runs))
    notes = [run.note for run in runs if run.note]
    if rest:
        shown = ", ".join(rest[:12]) + (f" and {len(rest) - 12} more" if len(rest) > 12 else "")
        notes.append(f"not in all runs, left out of what is drawn together: {shown}")

    model, cards = "", ""
    if any(run.model for run in runs):
        model = sheet.model(runs)
        cards = sheet.card("Vehicle", sheet.vehicle(vehicles) if vehicles else "")
        cards += standstill.sections(vehicles, maggi) or sheet.at_start(runs, vehicles)
    used = vehicle_figures(vehicles) if vehicles else ""
    parts = [
        section("how", "How it was run", sheet.how(runs)),
        section("model", "Model", model + row(cards)),
        section("manoeuvre", "Manoeuvre" if vehicles else "Input", sheet.manoeuvre(runs, vehicles)),
        section("figures", "Key figures", row(used + objectives(runs)) + all_signals(runs, common)),
    ]
    if vehicles:
        parts.append(section("handling", "Handling", draw(plots.handling(vehicles))))
        parts.append(section("ride", "Path and ride", draw(plots.travel(vehicles, width))))
        parts.append(section("tyres", "Tyres", draw(plots.tyres(vehicles))))
    parts.append(section("sensors", "Sensors", draw(plots.sensors(runs, common, bool(vehicles)))))
    parts.append(section("balance", "Energy and loops", draw(plots.balance(runs, common))))
    parts.append(section("coordinates", "Coordinates", draw(plots.coordinates(runs, common))))
    parts.append(section("reactions", "Joint reactions", draw(plots.reactions(runs, common))))
    return wrap(title, runs, notes, [p for p in parts if p]), notes


def wrap(title, runs, notes, parts):
    links = "".join(f'<a href="#{p.split(chr(34))[1]}">{p.split("<h2", 1)[1].split(">", 1)[1].split("<", 1)[0]}</a>'
                    for p in parts)
    dates = ", ".join(dict.fromkeys(run.record["date"][:10] for run in runs if run.record.get("date")))
    versions = ", ".join(dict.fromkeys(run.record["maggi"] for run in runs if run.record.get("maggi")))
    under = [text for text in (dates, f"maggi {versions}" if versions else "",
                               ", ".join(run.name for run in runs if run.kept)) if text]
    said = "".join(f'<p class="note">Note: {html.escape(note)}</p>' for note in notes)
    return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
            f'<meta name="viewport" content="width=device-width, initial-scale=1">'
            f'<meta name="generator" content="maggi {html.escape(versions)}">'
            f'<title>{html.escape(title)}</title>\n<style>\n{beside("style.css")}</style></head>\n<body>'
            f'<header><h1>{html.escape(title)}</h1><p class="sub">{html.escape(" · ".join(under))}</p>{said}'
            f'<nav aria-label="Sections">{links}</nav></header>\n<main>\n' + "\n".join(parts) +
            f'\n</main>\n<script>\n{script()}</script></body></html>\n')
