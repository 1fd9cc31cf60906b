"""Plots as inline SVG: curves thinned to what the pixels show, no peak lost."""
import html
import itertools
import math

import numpy

WIDTH, HEIGHT = 680, 280  # of the picture [px]
LEFT, RIGHT, TOP, BOTTOM = 76, 14, 10, 44
FINE = 10  # units of a path in one pixel
COLOURS = 8  # --c0 .. --c7 of the style sheet
DASHES = ["", "7 3", "12 3 2 3", "4 2", "9 3 2 3 2 3", "2 2"]
ZOOM = {-9: "n", -6: "µ", -3: "m", 3: "k", 6: "M", 9: "G"}
PREFIXED = ("m", "N", "J", "N m", "rad", "Pa", "W", "m/s", "rad/s")
NUMBER = itertools.count(1)


def pretty(unit):
    """m/s^2 as m/s²"""
    for end, sign in (("^2", "²"), ("^3", "³"), ("^4", "⁴")):
        unit = unit.replace(end, sign)
    return unit.replace("N m", "N·m")


def scale_of(unit, size):
    """(factor, unit) in which numbers up to size have few digits: N as kN, 1e-5 m/s^2 as 10⁻⁶ m/s²."""
    if size <= 0.0 or not math.isfinite(size) or 1e-2 <= size < 1e4:
        return 1.0, pretty(unit)
    power = 3*math.floor(math.log10(size)/3)
    if power in ZOOM and unit in PREFIXED:
        return 10.0**power, ZOOM[power] + pretty(unit)
    digits = str(power).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    return 10.0**power, f"10{digits}" + (f" {pretty(unit)}" if unit not in ("", "-") else "")


def ticks(low, high, most):
    """Round numbers from low to high, at most `most` of them, and their step."""
    raw = (high - low)/max(most - 1, 1)
    power = 10.0**math.floor(math.log10(raw))
    step = next(m*power for m in (1, 2, 2.5, 5, 10) if m*power >= raw*(1 - 1e-9))
    first = math.ceil(low/step - 1e-9)
    return [step*k for k in range(first, math.floor(high/step + 1e-9) + 1)], step


def tick_text(value, step):
    digits = max(0, -math.floor(math.log10(step) + 1e-9))
    if abs(step*10**digits - round(step*10**digits)) > 1e-6:
        digits += 1
    text = f"{value:.{digits}f}"
    return ("0" if float(text) == 0.0 else text).replace("-", "−")


def span(low, high):
    """A range with room around it."""
    if not (math.isfinite(low) and math.isfinite(high)):
        return 0.0, 1.0
    size = max(abs(low), abs(high))
    if high - low <= 1e-9*size or high == low:
        pad = 0.05*size if size > 0.0 else 1.0
    else:
        pad = 0.05*(high - low)
    return low - pad, high + pad


# ------------------------------------------------------------------ thinning


def buckets(x, y):
    """First, lowest, highest and last point of each pixel column: numbers of points in rising order."""
    column = x//FINE
    start = numpy.flatnonzero(numpy.r_[True, column[1:] != column[:-1]])
    end = numpy.r_[start[1:], len(x)]
    kept = set()
    for a, b in zip(start, end):
        part = y[a:b]
        kept.update((a, b - 1, a + int(numpy.argmin(part)), a + int(numpy.argmax(part))))
    return numpy.array(sorted(kept))


def straighten(x, y, tolerance=1.0):
    """Points without which straight lines stay within the tolerance, the farthest first."""
    keep = numpy.zeros(len(x), bool)
    keep[[0, -1]] = True
    todo = [(0, len(x) - 1)]
    while todo:
        a, b = todo.pop()
        if b - a < 2:
            continue
        dx, dy = x[b] - x[a], y[b] - y[a]
        length = math.hypot(dx, dy)
        mx, my = x[a + 1:b] - x[a], y[a + 1:b] - y[a]
        off = numpy.abs(dx*my - dy*mx)/length if length else numpy.hypot(mx, my)
        k = int(numpy.argmax(off))
        if off[k] > tolerance:
            k += a + 1
            keep[k] = True
            todo += [(a, k), (k, b)]
    return numpy.flatnonzero(keep)


def path(x, y, is_function):
    """The d of a path through points in units of the path; gaps where one is not a number."""
    text, good = [], numpy.isfinite(x) & numpy.isfinite(y)
    edges = numpy.flatnonzero(numpy.diff(numpy.r_[False, good, False].astype(int)))
    for a, b in zip(edges[::2], edges[1::2]):
        px, py = numpy.round(x[a:b]), numpy.round(y[a:b])
        if is_function:
            kept = buckets(px, py)
            px, py = px[kept], py[kept]
        kept = straighten(px, py)
        px, py = px[kept].astype(int), py[kept].astype(int)
        text.append(f"M{px[0]} {py[0]}")
        if len(px) == 1:
            text.append("h0")
            continue
        steps = [f"{dx}{dy:+d}" if dy < 0 else f"{dx} {dy}"
                 for dx, dy in zip(numpy.diff(px), numpy.diff(py))]
        text.append("l" + " ".join(steps))
    return "".join(text)


# ------------------------------------------------------------------ the picture


class Curve:
    """Label, points, colour (0 .. COLOURS-1) and dash (index in DASHES)."""

    def __init__(self, label, x, y, colour=0, dash=0):
        self.label, self.x, self.y = label, numpy.asarray(x, float), numpy.asarray(y, float)
        self.colour, self.dash = colour % COLOURS, dash % len(DASHES)


class Plot:
    """A figure: title, axes with units, curves, lines in the background."""

    def __init__(self, title, x_label, x_unit, y_label, y_unit, curves, background=(), equal=False,
                 note=""):
        self.title, self.note = title, note
        self.x_label, self.x_unit, self.y_label, self.y_unit = x_label, x_unit, y_label, y_unit
        self.curves, self.background, self.equal = curves, background, equal
        self.is_function = x_label == "time"

    def ranges(self):
        every = list(self.curves) + list(self.background)
        x = numpy.concatenate([c.x[numpy.isfinite(c.x) & numpy.isfinite(c.y)] for c in every])
        y = numpy.concatenate([c.y[numpy.isfinite(c.x) & numpy.isfinite(c.y)] for c in every])
        if len(x) == 0:
            return None
        x0, x1, y0, y1 = x.min(), x.max(), y.min(), y.max()
        if not self.is_function or x0 == x1:
            x0, x1 = span(x0, x1)
        y0, y1 = span(y0, y1)
        if self.equal:
            per_px = max((x1 - x0)/(WIDTH - LEFT - RIGHT), (y1 - y0)/(HEIGHT - TOP - BOTTOM))
            x0, x1 = grow(x0, x1, per_px*(WIDTH - LEFT - RIGHT))
            y0, y1 = grow(y0, y1, per_px*(HEIGHT - TOP - BOTTOM))
        return x0, x1, y0, y1

    def draw(self):
        """The figure element, or "" if there is no number to draw."""
        found = self.ranges()
        if not found:
            return ""
        x0, x1, y0, y1 = (float(v) for v in found)
        fx, x_unit = scale_of(self.x_unit, max(abs(x0), abs(x1)))
        fy, y_unit = scale_of(self.y_unit, max(abs(y0), abs(y1)))
        x0, x1, y0, y1 = x0/fx, x1/fx, y0/fy, y1/fy
        w, h = WIDTH - LEFT - RIGHT, HEIGHT - TOP - BOTTOM
        number = next(NUMBER)
        name = f"f{number}"
        axis_x, axis_y = axis(self.x_label, x_unit), axis(self.y_label, y_unit)
        out = [
            f'<figure id="{name}" data-r="{x0:.9g} {x1:.9g} {y0:.9g} {y1:.9g}" '
            f'data-x="{html.escape(self.x_label)}" data-xu="{x_unit}" data-yu="{y_unit}"'
            f'{"" if self.is_function else " data-xy=1"}>',
            f'<figcaption><b>{number}</b> {html.escape(self.title)}'
            '<output class="at" aria-live="polite"></output></figcaption>',
            f'<svg viewBox="0 0 {WIDTH} {HEIGHT}" role="img" tabindex="0" '
            f'aria-labelledby="{name}t {name}d"><title id="{name}t">{html.escape(self.title)}</title>'
            f'<desc id="{name}d">{html.escape(self.describe(axis_x, axis_y, fy, y_unit))}</desc>',
        ]
        out += self.frame(x0, x1, y0, y1, axis_x, axis_y)
        out.append(f'<g transform="translate({LEFT} {TOP}) scale({1/FINE:g})">')
        for group, kind in ((self.background, "bg"), (self.curves, "cv")):
            for c in group:
                d = path((c.x/fx - x0)/(x1 - x0)*w*FINE, (y1 - c.y/fy)/(y1 - y0)*h*FINE,
                         self.is_function)
                dash = f' stroke-dasharray="{DASHES[c.dash]}"' if DASHES[c.dash] else ""
                style = f"cv c{c.colour}" if kind == "cv" else "bg"
                out.append(f'<path class="{style}"{dash} d="{d}"/>')
        out.append(f'</g><line class="cur" y1="{TOP}" y2="{HEIGHT - BOTTOM}" visibility="hidden"/></svg>')
        out.append(self.legend(y_unit))
        if self.note:
            out.append(f'<p class="note">{html.escape(self.note)}</p>')
        out.append("</figure>")
        return "".join(out)

    def describe(self, axis_x, axis_y, fy, y_unit):
        parts = [f"{axis_y} against {axis_x}."]
        for c in self.curves:
            good = c.y[numpy.isfinite(c.y)]
            if len(good):
                parts.append(f"{c.label}: from {good.min()/fy:.4g} to {good.max()/fy:.4g} {y_unit}.")
        return " ".join(parts)

    def frame(self, x0, x1, y0, y1, axis_x, axis_y):
        w, h, out = WIDTH - LEFT - RIGHT, HEIGHT - TOP - BOTTOM, []
        values, step = ticks(x0, x1, 9)
        for v in values:
            x = LEFT + (v - x0)/(x1 - x0)*w
            out.append(f'<path class="grid" d="M{x:.1f} {TOP}v{h}"/>'
                       f'<text class="tx" x="{x:.1f}" y="{TOP + h + 16}">{tick_text(v, step)}</text>')
        values, step = ticks(y0, y1, 7)
        for v in values:
            y = TOP + (y1 - v)/(y1 - y0)*h
            zero = " zero" if abs(v) < 1e-9*step else ""
            out.append(f'<path class="grid{zero}" d="M{LEFT} {y:.1f}h{w}"/>'
                       f'<text class="ty" x="{LEFT - 6}" y="{y + 4:.1f}">{tick_text(v, step)}</text>')
        out.append(f'<path class="box" d="M{LEFT} {TOP}v{h}h{w}"/>')
        out.append(f'<text class="tx lab" x="{LEFT + w/2:.0f}" y="{HEIGHT - 8}">{html.escape(axis_x)}'
                   f'</text><text class="tx lab" transform="translate(13 {TOP + h/2:.0f}) rotate(-90)">'
                   f'{html.escape(axis_y)}</text>')
        return out

    def legend(self, y_unit):
        items = []
        for c in self.curves:
            dash = f' stroke-dasharray="{DASHES[c.dash]}"' if DASHES[c.dash] else ""
            items.append(f'<li><svg viewBox="0 0 26 8" aria-hidden="true"><path class="cv c{c.colour}"'
                         f'{dash} d="M0 4h26"/></svg>{html.escape(c.label)}<output></output></li>')
        for label in dict.fromkeys(c.label for c in self.background if c.label):
            items.append('<li><svg viewBox="0 0 26 8" aria-hidden="true"><path class="bg" d="M0 4h26"/>'
                         f'</svg>{html.escape(label)}</li>')
        return f'<ul class="legend">{"".join(items)}</ul>'


def grow(low, high, size):
    middle = 0.5*(low + high)
    return middle - 0.5*size, middle + 0.5*size


def axis(label, unit):
    return f"{label} [{unit or '-'}]"
