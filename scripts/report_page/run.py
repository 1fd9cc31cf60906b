"""A run: the table of maggi simulate and the record beside it."""
import json
import os
import re

import numpy

from . import Failure

WRENCH = (".fx", ".fy", ".fz", ".mx", ".my", ".mz")
ENERGY = ("energy.kinetic", "energy.potential", "energy.total", "energy.work")


def reason(error):
    return getattr(error, "strerror", None) or str(error)


def read_table(name):
    """Columns of a CSV of maggi simulate by name, in its order."""
    wrong = f"{name}: is not a table of maggi simulate (a header with column t, then rows)"
    try:
        with open(name, encoding="utf-8") as file:
            header = file.readline().rstrip("\r\n").split(",")
            if header[0] != "t":
                raise Failure(wrong)
            try:
                rows = numpy.loadtxt(file, delimiter=",", ndmin=2, comments=None)
            except ValueError as error:
                raise Failure(name + explain(str(error))) from None
    except UnicodeDecodeError:
        raise Failure(f"{name}: is not text") from None
    except OSError as error:
        raise Failure(f"{name}: {reason(error)}") from None
    if rows.size == 0:
        raise Failure(f"{name}: has no rows")
    if rows.shape[1] != len(header):
        raise Failure(f"{name}: {rows.shape[1]} cells under {len(header)} columns")
    if len(set(header)) != len(header):
        twice = next(title for title in header if header.count(title) > 1)
        raise Failure(f"{name}: column {twice} is there twice")
    if len(rows) < 2:
        raise Failure(f"{name}: has one row only: nothing to plot")
    if not numpy.all(numpy.diff(rows[:, 0]) > 0.0):
        raise Failure(f"{name}: t does not increase")
    return dict(zip(header, rows.T))


def explain(text):
    """What numpy has to say, behind the name of the file: rows as lines of the file."""
    found = re.search(r"columns changed from (\d+) to (\d+) at row (\d+)", text)
    if found:
        return f":{int(found[3]) + 1}: {found[2]} cells under {found[1]} columns"
    found = re.search(r"convert string (.+) to \S+ at row (\d+)", text)
    if found:
        return f":{int(found[2]) + 2}: {found[1]} is not a number"
    return ": " + text.splitlines()[0]


def read_record(name, columns, rows):
    """(record, note): what stands beside the table, {} and why not if there is nothing fit."""
    path = name + ".json"
    try:
        with open(path, encoding="utf-8") as file:
            record = json.load(file)
        titles = [column["name"] for column in record["columns"]]
        if record["format"] != "maggi-run":
            raise KeyError
        if titles != list(columns) or record["run"]["rows"] != rows:
            return {}, f"{path}: belongs to another table"
        return record, None
    except FileNotFoundError:
        return {}, f"{path}: is not there: the page has only what the columns say"
    except (OSError, ValueError, KeyError, TypeError) as error:
        text = reason(error) if isinstance(error, OSError) else "is no record of maggi simulate"
        return {}, f"{path}: {text}"


class Run:
    """Columns, their units and kinds, and the model they come from."""

    def __init__(self, name):
        self.name = name
        self.table = read_table(name)
        self.t = self.table["t"]
        self.record, self.note = read_record(name, self.table, len(self.t))
        self.kept = not self.record or self.record["run"].get("out") is not None
        self.model = self.record.get("model", {})
        self.title = self.model.get("model") or os.path.splitext(os.path.basename(name))[0]
        self.label = os.path.splitext(os.path.basename(name))[0]
        self.unit = {c["name"]: c["unit"] for c in self.record.get("columns", [])}
        self.parameter = {p["path"]: p["value"] for p in self.model.get("parameters", [])}
        self.sensors = {s["name"]: s for s in self.model.get("sensors", [])}
        self.coordinates = {c["name"]: c for c in self.model.get("coordinates", [])}
        if not self.record:
            self.guess()

    def guess(self):
        """Units of columns whose names say what they are, and a coordinate for each NAME.q."""
        for column in self.table:
            stem, dot, end = column.rpartition(".")
            if column in ENERGY:
                self.unit[column] = "J"
            elif dot + end in WRENCH and all(stem + w in self.table for w in WRENCH):
                self.unit[column] = "N" if end[0] == "f" else "N m"
            elif end == "q" and stem + ".v" in self.table:
                self.coordinates[stem] = {"name": stem, "unit": None, "guided": False}
        self.unit["t"] = "s"

    def kind(self, column):
        """coordinate, energy, reaction, loops or sensor"""
        stem, dot, end = column.rpartition(".")
        if column in self.sensors:
            return "sensor"
        if column in ENERGY:
            return "energy"
        if column.startswith("loops."):
            return "loops"
        if end in ("q", "v", "a") and stem in self.coordinates:
            return "coordinate"
        if dot + end in WRENCH and all(stem + w in self.table for w in WRENCH):
            return "reaction"
        return "sensor"

    def sensor_columns(self, kind, **wanted):
        """{end of the column: values} of the first sensor of a type that looks at body or element."""
        found, name = {}, None
        for column, sensor in self.sensors.items():
            if sensor.get("type") != kind or column not in self.table:
                continue
            if any(sensor.get(key) != value for key, value in wanted.items()):
                continue
            if name not in (None, sensor["sensor"]):
                break
            name = sensor["sensor"]
            found[column[len(name) + 1:]] = self.table[column]
        return found

    def point(self, path):
        """A vector parameter, or None."""
        value = [self.parameter.get(f"{path}.{axis}") for axis in "xyz"]
        return None if None in value else numpy.array(value)
