"""Wrong model files: each has its one line of message, `FILE:LINE: ..`, status 1, and no output.

Rows are small edits of GOOD, the text `old` replaced by `new`.  The line expected is the one that
holds the row's `at`: the wrong text itself where the reader sees it, else the entry it belongs to.
"""

import dataclasses
import re

import pytest

GOOD = """\
format: maggi
version: 1
name: good
gravity: [0, 0, -9.81]
simulation:
  time: 0.01
  step: 0.001
bodies:
  - name: crank
    joint:
      type: revolute
      point: [0, 0, 0]
      axis: [1, 0, 0]
      velocity: -1
    mass: 1
    bar:
      from: [0, 0, 0]
      to: [0, 0, -1]
  - name: coupler
    parent: crank
    joint:
      type: universal
      point: [0, 0, -1]
      axis: [1, 0, 0]
      axis2: [0, 0, 1]
    mass: 1.2
    bar:
      from: [0, 0, -1]
      to: [0, 1.2, -1]
  - name: follower
    joint:
      type: revolute
      point: [0, 1.2, 0]
      axis: [2, 0, 0]
    mass: 1
    bar:
      from: [0, 1.2, 0]
      to: [0, 1.2, -1]
  - name: ball
    joint:
      type: spherical
      point: [0, 3, 0]
    mass: 2
    cog: [0, 3, -0.5]
    inertia:
      xx: 0.1
      yy: 0.1
      zz: 0.02
      xy: 0.001
    point_masses:
      - name: lead
        mass: 0.5
        point: [0, 3, -0.9]
  - name: wheel
    joint:
      type: revolute
      point: [0, 5, 0]
      axis: [0, 1, 0]
      motion: turn
    mass: 3
    cog: [0, 5, 0.1]
    inertia:
      xx: 0.3
      yy: 0.4
      zz: 0.3
  - name: base
    joint:
      type: fixed
    mass: 7
loops:
  - name: tip
    type: spherical
    body_a: coupler
    body_b: follower
    point: [0, 1.2, -1]
rods:
  - name: strut
    body_a: ground
    body_b: ball
    point_a: [1, 3, -1]
    point_b: [0, 3, -1]
    mass: 0.25
springs:
  - name: coil
    body_a: ground
    body_b: crank
    point_a: [0, -1, 0]
    point_b: [0, 0, -0.5]
    stiffness: 100
    damping: 3
joint_springs:
  - name: twist
    coordinate: crank
    coordinate2: follower
    stiffness: 5
forces:
  - name: push
    type: force
    body: ball
    point: [0, 3, -1]
    value: [1, 0, 0]
    function: pulse
  - name: air
    type: drag
    body: ball
    point: [0, 3, -0.5]
    density: 1.2
    coefficient: 0.47
    area: 0.03
    low_speed: 0.001
    wind: [5, 0, 0]
  - name: keep
    type: speed_controller
    body: coupler
    point: [0, 1.2, -1]
    coordinates: [crank, follower]
    speed: 1
    gain: 0.1
    torque: 2
    low_speed: 0.01
drivers:
  - name: pilot
    body: coupler
    point: [0, 1.2, -1]
    coordinate: follower
    preview: 0.1
    gain: 0.2
    limit: 0.4
    stiffness: 1.5
    x: [0, 7, 14]
    y: [0, 8, 8]
functions:
  - name: turn
    type: sine
    amplitude: 1
    omega: 2
  - name: pulse
    type: knots
    times: [0, 1, 2]
    values: [0, 1, 0]
  - name: road
    type: spline
    times: [0, 0.5, 1, 2]
    values: [0, 0.1, 0, 0]
sensors:
  - name: end
    type: position
    body: crank
    point: [0, 0, -1]
  - {name: slide, type: sideslip, body: crank, low_speed: 0.01}
  - {name: sum, type: combination, terms: [slide.speed, end.z], weights: [1, 2], unit: m}
filters:
  - {name: felt, signal: end.y, weighting: Wk}
  - {name: own, signal: end.z, f1: 0.4, f2: 90, f3: 12, f4: 13, q4: 0.6, f5: 2, q5: 1, f6: 3,
     q6: 0.9, gain: 1}
objectives:
  - {name: J1, type: integral_square, signal: coupler.1.q}
  - {name: high, type: smooth_maximum, signal: end.z, sharpness: 50}
  - {name: at, type: value, signal: end.y, times: [0.005, 0.01]}
  - {name: fit, type: least_squares, signal: end.y, times: [0, 0.01], values: [0, 0]}
  - {name: total, type: sum, terms: [J1, high], weights: [1, 0.1]}
  - {name: settling, type: norm, signal: end.z, from: 0.002, to: 0.008, reference: final}
  - {name: gain, type: slope, signal: end.z, against: end.y}
design:
  - {name: mass, parameters: [bodies.crank.mass, bodies.coupler.mass], factors: [1, 1.2],
     nominal: 1, lower: 0.5, upper: 2}
set:
  - {name: "springs.co*.damping", value: 4}
  - {name: springs.coil.stiffness, value: 90}
"""


@dataclasses.dataclass
class Row:
    what: str
    old: str
    new: str
    at: str  # the first line that contains it; "" is line 1
    message: str


BUMPS = "bumps, radius: 2, height: 0.05, first: 3"

ROADS = [  # kind, what is wrong, type and keys, message
    ("sine", "no wavelength", "sine, amplitude: 1", '"wavelength" is missing'),
    ("bumps", "no height", "bumps, radius: 2, first: 3", '"height" is missing'),
    ("bumps", "no first", "bumps, radius: 2, height: 0.05", '"first" is missing'),
    ("bumps", "slope", BUMPS + ", slope: 0.1", 'no key "slope"'),
    ("bumps", "none", BUMPS + ", number: 0", "0 is not a number of bumps"),
    ("bumps", "a half", BUMPS + ", number: 2.5, spacing: 5", "2.5 is not a number of bumps"),
    ("bumps", "too near", BUMPS + ", number: 2, spacing: 0.5", "spacing must be at least"),
    ("bumps", "too high", "bumps, radius: 2, height: 2.1, first: 3", "height must be between"),
    ("bumps", "of no height", "bumps, radius: 2, height: 0, first: 3", "height must be between"),
    ("bumps", "of no radius", "bumps, radius: 0, height: 0, first: 3", "radius must be positive"),
    ("bumps", "long fillet", BUMPS + ", fillet: 1", "fillet must be between"),
    ("bumps", "negative fillet", BUMPS + ", fillet: -0.1", "fillet must be between"),
    ("profile", "no heights", "profile, x: [0, 1]", '"z" is missing'),
    ("profile", "one point", "profile, x: [0], z: [1]", "at least two points"),
    ("profile", "points and heights", "profile, x: [0, 1], z: [1]", "1 heights for 2 points"),
    ("profile", "backwards", "profile, x: [0, 1, 1], z: [1, 0, 0]", "x does not increase"),
    ("profile", "radius", "profile, x: [0, 1], z: [1, 0], radius: 1", 'no key "radius"'),
]

BODIES = GOOD[GOOD.index("bodies:") :]  # and what refers to them

ROWS = [
    # the file as YAML
    Row("syntax: bracket", "[0, 0, -9.81]", "[0, 0, -9.81", "[0, 0, -9.81", ""),
    Row("syntax: tab", "    mass: 3", "\tmass: 3", "\tmass: 3", "not YAML"),
    Row("syntax: quote", "name: good", "name: 'good' four-bar", "name: 'good'", "not YAML"),
    Row("empty file", GOOD, "", "", "empty"),
    Row("a list", GOOD, "- format: maggi\n- version: 1\n", "", "must be a mapping"),
    Row("a scalar", GOOD, "four-bar\n", "", "must be a mapping"),
    Row("alias", "[0, 0, -9.81]", "*g", "*g", "alias"),
    Row("two documents", "sensors:", "---\nformat: maggi\nsensors:", "---", "second document"),
    # head
    Row("format missing", "format: maggi\n", "", "version: 1", "format: maggi"),
    Row("format wrong", "format: maggi", "format: adams", "format: adams", "adams"),
    Row("version missing", "version: 1\n", "", "name: good", "version: 1"),
    Row("version wrong", "version: 1", "version: 2", "version: 2", "version 1"),
    Row("version not a number", "version: 1", "version: one", "version: one", "one"),
    Row("name missing", "name: good\n", "", "", '"name" is missing'),
    # keys and kinds of values
    Row("unknown key", "gravity:", "gravitation:", "gravitation:", 'unknown key "gravitation"'),
    Row("unknown key in a joint", "velocity: -1", "speed: -1", "speed: -1", 'unknown key "speed"'),
    Row("key twice", "    mass: 3", "    mass: 3\n    mass: 4", "mass: 4", "twice"),
    Row(
        "body without name", "- name: ball\n    joint:", "- joint:", "- joint:", '"name" is missing'
    ),
    Row(
        "body without joint",
        "  - name: base\n    joint:\n      type: fixed\n",
        "  - name: base\n",
        "name: base",
        '"joint" is missing',
    ),
    Row("text for a number", "mass: 1.2", "mass: heavy", "mass: heavy", "not a number"),
    Row("number with a unit", "mass: 1.2", "mass: 1.2 kg", "mass: 1.2 kg", "not a number"),
    Row("comma for point", "mass: 1.2", "mass: 1,2", "mass: 1,2", "not a number"),
    Row("NaN", "mass: 1.2", "mass: .nan", ".nan", "not a number"),
    Row("infinity", "mass: 1.2", "mass: .inf", ".inf", "not a number"),
    Row("overflow", "mass: 1.2", "mass: 1e999", "1e999", "too large"),
    Row("number missing", "mass: 1.2", "mass:", "mass:\n", "number"),
    Row("vector too short", "[0, 0, -9.81]", "[0, -9.81]", "[0, -9.81]", "3"),
    Row("vector too long", "[0, 0, -9.81]", "[0, 0, 0, -9.81]", "[0, 0, 0, -9.81]", "3"),
    Row("number for a vector", "[0, 0, -9.81]", "-9.81", "-9.81", "list of 3"),
    Row(
        "list for a mapping",
        "simulation:\n  time: 0.01\n  step: 0.001",
        "simulation: [0.01, 0.001]",
        "simulation:",
        "mapping",
    ),
    Row("negative step", "step: 0.001", "step: -0.001", "step: -0.001", "step"),
    # bodies
    Row("no bodies", BODIES, "bodies: []\n", "bodies: []", "at least one body"),
    Row(
        "body twice",
        "name: wheel",
        "name: ball",
        "name: ball\n    joint:\n      type: revolute",
        "already",
    ),
    Row("body named ground", "name: wheel", "name: ground", "name: ground", "ground"),
    Row("bad characters", "name: wheel", "name: front wheel", "front wheel", "front wheel"),
    Row("unknown parent", "parent: crank", "parent: frame", "parent: frame", '"frame"'),
    Row("own parent", "parent: crank", "parent: coupler", "name: coupler", "parents"),
    Row(
        "cycle of parents",
        "  - name: crank\n",
        "  - name: crank\n    parent: coupler\n",
        "name: crank",
        "parents",
    ),
    Row(
        "unknown joint",
        "type: spherical\n      point: [0, 3",
        "type: ball\n      point: [0, 3",
        "type: ball",
        '"ball"',
    ),
    Row("zero axis", "axis: [2, 0, 0]", "axis: [0, 0, 0]", "axis: [0, 0, 0]", "axis"),
    Row(
        "axes of a universal parallel",
        "axis2: [0, 0, 1]",
        "axis2: [3, 0, 0]",
        "axis: [1, 0, 0]\n      axis2",
        "parallel",
    ),
    Row("negative mass", "mass: 1.2", "mass: -1.2", "mass: -1.2", "negative"),
    Row("negative point mass", "mass: 0.5", "mass: -0.5", "- name: lead", "negative"),
    Row("negative inertia", "zz: 0.02", "zz: -0.02", "inertia:", "inertia"),
    Row("inertia of no body", "zz: 0.02", "zz: 0.5", "inertia:", "inertia"),
    Row("inertia not definite", "xy: 0.001", "xy: 0.2", "inertia:", "inertia"),
    Row(
        "bar and inertia",
        "    cog: [0, 3, -0.5]",
        "    bar: {from: [0, 3, 0], to: [0, 3, -1]}",
        "bar: {",
        "inertia",
    ),
    Row(
        "bar of no length",
        "to: [0, 1.2, -1]\n  - name: follower",
        "to: [0, 0, -1]\n  - name: follower",
        "- name: coupler",
        "length",
    ),
    Row(
        "motion on a fixed joint",
        "type: fixed",
        "type: fixed\n      motion: turn",
        "joint:\n      type: fixed",
        "no coordinates",
    ),
    Row("unknown motion", "motion: turn", "motion: spin", "- name: wheel", '"spin"'),
    Row(
        "motion and velocity",
        "motion: turn",
        "motion: turn\n      velocity: 3",
        "- name: wheel",
        "guided",
    ),
    Row(
        "velocity of a compound",
        "axis2: [0, 0, 1]",
        "axis2: [0, 0, 1]\n      velocity: 1",
        "joint:\n      type: universal",
        '"velocities" takes a list of 2',
    ),
    Row(
        "too many velocities",
        "axis2: [0, 0, 1]",
        "axis2: [0, 0, 1]\n      velocities: [1, 2, 3]",
        "joint:\n      type: universal",
        '"velocities" has 3',
    ),
    # drivers and controllers of speed
    Row("no coordinates", "    coordinates: [crank, follower]\n", "", "- name: keep", '"coordinates" is missing'),
    Row("unknown coordinate", "[crank, follower]\n    speed", "[crank, rocker]\n    speed", "coordinates: [crank", '"rocker"'),
    Row("coordinate twice", "[crank, follower]\n    speed", "[crank, crank]\n    speed", "coordinates: [crank", "twice"),
    Row("speed and driver", "speed: 1\n", "speed: 1\n    driver: pilot\n", "- name: keep", "either"),
    Row("unknown driver", "speed: 1\n", "driver: nobody\n", "driver: nobody", '"nobody"'),
    Row("driver without speeds", "speed: 1\n", "driver: pilot\n", "driver: pilot", "no speeds"),
    Row("low_speed zero", "low_speed: 0.01", "low_speed: -2", "low_speed: -2", "positive"),
    Row("two points", "x: [0, 7, 14]\n    y: [0, 8, 8]", "x: [0, 7]\n    y: [0, 8]", "- name: pilot", "three points"),
    Row("points coincide", "x: [0, 7, 14]\n    y: [0, 8, 8]", "x: [0, 7, 7]\n    y: [0, 8, 8]", "- name: pilot", "coincide"),
    Row("points of unequal number", "y: [0, 8, 8]", "y: [0, 8]", "y: [0, 8]", "2 numbers for 3"),
    Row("speeds of unequal number", "y: [0, 8, 8]", "y: [0, 8, 8]\n    speeds: [5]", "speeds: [5]", "1 numbers for 3"),
    Row("steers unknown", "coordinate: follower\n    preview", "coordinate: wheels\n    preview", "coordinate: wheels", '"wheels"'),
    Row("limit zero", "limit: 0.4", "limit: -2", "limit: -2", "positive"),
    # loops, rods, springs
    Row("axes of a plane", "type: spherical\n    body_a", "type: point_plane\n    axis_a: [1, 0, 0]\n    body_a", "name: tip", "normal"),
    Row("loop on unknown body", "body_b: follower", "body_b: rocker", "body_b: rocker", '"rocker"'),
    Row(
        "loop of a body with itself",
        "body_b: follower",
        "body_b: coupler",
        "body_a: coupler",
        "the same body",
    ),
    Row(
        "unknown loop",
        "type: spherical\n    body_a",
        "type: welded\n    body_a",
        "type: welded",
        '"welded"',
    ),
    Row("loop without a point", "    point: [0, 1.2, -1]\n", "", "name: tip", "point"),
    Row(
        "loop without an axis",
        "type: spherical\n    body_a",
        "type: revolute\n    body_a",
        "name: tip",
        "axis",
    ),
    Row("rod of no length", "point_a: [1, 3, -1]", "point_a: [0, 3, -1]", "name: strut", "length"),
    Row("rod of negative length", "mass: 0.25", "length: -1", "length: -1", "length"),
    Row("rod on unknown body", "body_b: ball", "body_b: bell", "body_b: bell", '"bell"'),
    Row(
        "spring of no length",
        "point_a: [0, -1, 0]",
        "point_a: [0, 0, -0.5]",
        "- name: coil",
        "coincide",
    ),
    Row(
        "free length and preload",
        "damping: 3",
        "free_length: 1\n    preload: 2",
        "- name: coil",
        "preload",
    ),
    # coordinates, loads, functions, sensors
    Row(
        "unknown coordinate",
        "coordinate: crank",
        "coordinate: rocker",
        "coordinate: rocker",
        '"rocker"',
    ),
    Row(
        "coordinate out of range",
        "coordinate: crank",
        "coordinate: coupler.3",
        "coupler.3",
        '"coupler.3"',
    ),
    Row(
        "coordinate of a compound",
        "coordinate: crank",
        "coordinate: ball",
        "coordinate: ball",
        '"ball"',
    ),
    Row(
        "spring between one coordinate",
        "coordinate2: follower",
        "coordinate2: crank",
        "- name: twist",
        "the same",
    ),
    Row("unknown load", "type: force\n", "type: push\n", "type: push", '"push"'),
    Row(
        "load on unknown body",
        "body: ball\n    point",
        "body: bell\n    point",
        "body: bell",
        '"bell"',
    ),
    Row("drag without area", "    area: 0.03\n", "", "- name: air", '"area" is missing'),
    Row(
        "value of a drag",
        "density: 1.2",
        "value: [1, 0, 0]\n    density: 1.2",
        "- name: air",
        'no key "value"',
    ),
    Row(
        "density of a force",
        "function: pulse",
        "density: 1.2",
        "- name: push",
        'no key "density"',
    ),
    Row("negative density", "density: 1.2", "density: -1.2", "density: -1.2", "negative"),
    Row("negative area", "area: 0.03", "area: -0.03", "area: -0.03", "negative"),
    Row(
        "low speed of zero",
        "low_speed: 0.001",
        "low_speed: 0",
        "low_speed: 0",
        "must be positive",
    ),
    Row("wind too short", "wind: [5, 0, 0]", "wind: [5, 0]", "wind: [5, 0]", "3"),
    Row("unknown function", "function: pulse", "function: step", "function: step", '"step"'),
    Row("unknown kind of function", "type: knots", "type: polygon", "type: polygon", '"polygon"'),
    Row("function twice", "name: pulse", "name: turn", "name: turn\n    type: knots", "already"),
    Row(
        "times not increasing",
        "times: [0, 1, 2]",
        "times: [0, 1, 1]",
        "times: [0, 1, 1]",
        "increas",
    ),
    Row("times and values", "values: [0, 1, 0]", "values: [0, 1]", "values: [0, 1]", "3 times"),
    Row(
        "spline of one point",
        "times: [0, 0.5, 1, 2]\n    values: [0, 0.1, 0, 0]",
        "times: [0]\n    values: [0]",
        "name: road",
        "point",
    ),
    Row(
        "step backwards",
        "type: sine\n    amplitude: 1\n    omega: 2",
        "type: step\n    t0: 1\n    t1: 0\n    y0: 0\n    y1: 1",
        "t1: 0",
        "t1 is not after t0",
    ),
    Row(
        "ramp backwards",
        "type: sine\n    amplitude: 1\n    omega: 2",
        "type: ramp\n    t0: 1\n    t1: 0\n    rate: 1",
        "t1: 0",
        "t1 is not after t0",
    ),
    Row(
        "ramp without a rate",
        "type: sine\n    amplitude: 1\n    omega: 2",
        "type: ramp\n    t0: 1\n    t1: 2",
        "- name: turn",
        '"rate" is missing',
    ),
    Row(
        "key of another function",
        "omega: 2",
        "omega: 2\n    times: [0, 1]",
        "- name: turn",
        "times",
    ),
    Row("key of a function missing", "    omega: 2\n", "", "- name: turn", '"omega" is missing'),
    *[
        Row(f"{kind} road: {what}", "sensors:\n", f"roads:\n  - {{name: way, type: {text}}}\nsensors:\n", "- {name: way", message)
        for kind, what, text, message in ROADS
    ],
    Row("unknown sensor", "type: position", "type: jerk", "type: jerk", '"jerk"'),
    Row(
        "sensor on unknown body",
        "body: crank\n    point",
        "body: crunk\n    point",
        "body: crunk",
        '"crunk"',
    ),
    Row(
        "sensor without a body",
        "body: crank\n    point: [0, 0, -1]\n  - {name: slide",
        "point: [0, 0, -1]\n  - {name: slide",
        "- name: end",
        '"body" is missing',
    ),
    Row(
        "centre of gravity of the ground",
        "body: crank\n    point: [0, 0, -1]\n  - {name: slide",
        "body: ground\n  - {name: slide",
        "- name: end",
        "point is missing",
    ),
    Row(
        "element of a position",
        "type: position\n    body: crank\n    point",
        "type: position\n    element: coil\n    body: crank\n    point",
        "- name: end",
        'no key "element"',
    ),
    Row(
        "point of angles",
        "type: position",
        "type: angles",
        "- name: end",
        'no key "point"',
    ),
    Row(
        "sensor of no element",
        "type: position\n    body: crank\n    point: [0, 0, -1]",
        "type: spring",
        "- name: end",
        '"element" is missing',
    ),
    Row(
        "sensor of a spring that is none",
        "type: position\n    body: crank\n    point: [0, 0, -1]",
        "type: spring\n    element: strut",
        "element: strut",
        '"strut" is no spring',
    ),
    Row(
        "body of a spring",
        "type: position\n    body: crank\n    point: [0, 0, -1]",
        "type: spring\n    body: crank\n    element: coil",
        "- name: end",
        'no key "body"',
    ),
    Row("no low speed", "crank, low_speed: 0.01", "crank, low_speed: 0", "name: slide", "must be positive"),
    Row("low speed of a point", "type: sideslip", "type: velocity", "slide", '"low_speed"'),
    Row("terms of a sideslip", "crank, low_speed: 0.01", "crank, terms: [end.z]", "slide", 'no key "terms"'),
    Row("sum of nothing", "terms: [slide.speed, end.z], ", "", "name: sum", '"terms" is missing'),
    Row("sum of a later one", "[slide.speed, end.z]", "[slide.speed, sum.value]", "sum", "before it"),
    Row("sum of no column", "[slide.speed, end.z]", "[slide.speed, end.w]", "sum", '"end.w"'),
    Row("weights of a sum", "weights: [1, 2]", "weights: [1]", "weights: [1]", "1 weights for 2"),
    Row("body of a sum", "type: combination", "type: combination, body: crank", "sum", '"body"'),
    # filters
    Row("unknown weighting", "weighting: Wk", "weighting: Wq", "weighting: Wq", '"Wq" is none of Wk, Wd'),
    Row("no signal of a filter", "signal: end.y, weighting", "weighting", "name: felt", '"signal"'),
    Row("unknown signal of a filter", "end.y, weighting", "end.w, weighting", "end.w", '"end.w" is no column'),
    Row("filter of a coordinate", "end.y, weighting", "crank.q, weighting", "crank.q", "no column of a sensor"),
    Row("filter of a filter", "end.y, weighting", "own.weighted, weighting", "own.weighted", "no column"),
    Row("filter twice", "name: own,", "name: felt,", "name: felt, signal: end.z", "already"),
    Row("weighting with numbers", "weighting: Wk", "weighting: Wk, gain: 2", "name: felt", "numbers of another"),
    Row("neither weighting nor numbers", ", weighting: Wk", "", "name: felt", '"weighting" is missing'),
    Row("frequency not a number", "f1: 0.4", "f1: NaN", "f1: NaN", '"NaN" is not a number'),
    Row("infinite frequency of the high pass", "f1: 0.4", "f1: inf", "f1: inf", '"inf" is not a number'),
    Row("transition not a number", "f4: 13", "f4: nan", "f4: nan", "neither a number nor inf"),
    Row("negative frequency", "f2: 90", "f2: -90", "f2: -90", "f2 is not positive (-90)"),
    Row("negative transition", "f4: 13", "f4: -inf", "f4: -inf", "neither a number nor inf"),
    Row("quality of zero", "q4: 0.6", "q4: 0", "q4: 0", "q4 is not positive"),
    Row("quality missing", "q4: 0.6, ", "", "name: own", "q4 is missing"),
    Row("half of a transition", "f4: 13", "f4: inf", "f3: 12", "f3 needs f4"),
    Row("half of a step", "f6: 3", "f6: inf", "f5: 2", "f5 and f6"),
    Row("unknown key of a filter", "f6: 3", "f7: 3", "name: own", '"f7"'),
    # objectives and design parameters
    Row("unknown objective", "type: integral_square", "type: area", "type: area", '"area"'),
    Row("objective twice", "name: high", "name: J1", "name: J1, type: smooth", "already"),
    Row("no signal", ", signal: coupler.1.q", "", "name: J1", '"signal" is missing'),
    Row("unknown signal", "coupler.1.q", "coupler.q", "coupler.q", '"coupler.q"'),
    Row("no sharpness", ", sharpness: 50", "", "name: high", '"sharpness" is missing'),
    Row("sharpness of zero", "sharpness: 50", "sharpness: 0", "name: high", "not positive"),
    Row("key of another objective", "coupler.1.q}", "coupler.1.q, times: [1]}", "J1", '"times"'),
    Row("times not rising", "[0.005, 0.01]", "[0.01, 0.005]", "name: at", "increase"),
    Row("values of a record", "values: [0, 0]", "values: [0]", "values: [0]", "1 values for 2"),
    Row("record twice", "values: [0, 0]", "values: [0, 0], file: a.csv", "name: fit", '"file"'),
    Row(
        "no record",
        "times: [0, 0.01], values: [0, 0]",
        "file: none.csv",
        "file: none.csv",
        "none.csv: cannot be opened",
    ),
    Row("unknown term", "[J1, high]", "[J1, low]", "name: total", '"low"'),
    Row("sum of sums", "[J1, high]", "[J1, total]", "name: total", "a sum itself"),
    Row("too many weights", "[1, 0.1]", "[1, 0.1, 2]", "[1, 0.1, 2]", "3 weights for 2 terms"),
    Row("window of nothing", "from: 0.002", "from: 0.008", "name: settling", "window is empty"),
    Row("window from the past", "from: 0.002", "from: -1", "name: settling", "before 0"),
    Row("window of a sum", "[1, 0.1]}", "[1, 0.1], to: 1}", "name: total", 'no key "to"'),
    Row("begin of an end", "norm, signal: end.z,", "terminal, signal: end.z,", "settling", 'no key'),
    Row("unknown reference", "reference: final", "reference: first", "reference: first", '"first"'),
    Row("reference of a peak", "type: norm", "type: peak", "name: settling", 'no key "reference"'),
    Row("slope of one signal", ", against: end.y", "", "name: gain", '"against" is missing'),
    Row("slope over nothing", "against: end.y", "against: end.w", "against: end.w", '"end.w"'),
    Row("target of a slope", "against: end.y", "against: end.y, target: 1", "name: gain", '"target"'),
    Row("no parameters", "[bodies.crank.mass, bodies.coupler.mass]", "[]", "name: mass", "empty"),
    Row(
        "unknown parameter",
        "[bodies.crank.mass,",
        "[bodies.crank.mess,",
        "bodies.crank.mess",
        '"bodies.crank.mess" does not exist',
    ),
    Row(
        "parameter twice",
        "[bodies.crank.mass,",
        '["bodies.c*.mass",',
        '"bodies.c*.mass"',
        '"bodies.coupler.mass" is there twice',
    ),
    Row("too few factors", "[1, 1.2]", "[1]", "factors: [1]", "1 factors for 2"),
    Row("factor of zero", "[1, 1.2]", "[1, 0]", "factors: [1, 0]", "zero"),
    Row("bounds crossed", "lower: 0.5", "lower: 3", "lower: 3", "above upper"),
    Row("nothing to set", "springs.coil.stiffness", "springs.coil.s", "springs.coil.s", "no number"),
    Row("set without a name", "{name: springs.coil.stiffness, v", "{v", "{value: 90", "is missing"),
    Row("set without a value", ", value: 90", "", "springs.coil.stiffness", "is missing"),
    Row("set twice", '"springs.co*.damping"', "springs.coil.stiffness", "value: 90", "already"),
    Row("set to what cannot be", "springs.coil.stiffness", "bodies.ball.mass, value: -1}  #", "bodies.ball.mass,", "set.bodies.ball.mass: bodies.ball.mass must not be negative"),
    Row("nominal out of bounds", "nominal: 1,", "nominal: 3,", "nominal: 3", "between"),
]


def line_of(text, at):
    """Number of the line where `at` begins; the newlines at its end belong to it."""
    return text[: text.index(at)].count("\n") + 1 if at else 1


def check_failure(maggi, path, message, line=None, arguments=()):
    out = maggi.folder / "out.csv"
    result = maggi.run("simulate", path, "--out", out, *arguments)
    assert result.returncode == 1, result
    assert result.stdout == ""
    assert result.stderr.count("\n") == 1 and result.stderr.endswith("\n"), result.stderr
    where = f"{path}:{line}: " if line else f"{path}: "
    assert re.fullmatch(r"(maggi: )?" + re.escape(where) + ".+\n", result.stderr), (
        where,
        result.stderr,
    )
    assert message in result.stderr, result.stderr
    assert not out.exists()
    return result.stderr


def test_good(maggi):
    (maggi.folder / "good.yaml").write_text(GOOD)
    columns = maggi.simulate("good.yaml", 0.01, 1e-3)
    assert len(columns["t"]) == 11


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row.what)
def test_bad_model(maggi, row):
    assert GOOD.count(row.old) >= 1, "the edit edits nothing"
    text = GOOD.replace(row.old, row.new, 1)
    (maggi.folder / "bad.yaml").write_text(text)
    check_failure(maggi, "bad.yaml", row.message, line_of(text, row.at))


def test_missing_file(maggi):
    check_failure(maggi, "no-such.yaml", "No such file")


def test_directory(maggi):
    (maggi.folder / "folder.yaml").mkdir()
    check_failure(maggi, "folder.yaml", "directory")


def test_binary(maggi):
    (maggi.folder / "bad.yaml").write_bytes(bytes(range(256)) * 16)
    check_failure(maggi, "bad.yaml", "not YAML", 1)


def test_zeros(maggi):
    (maggi.folder / "bad.yaml").write_bytes(bytes(4096))
    check_failure(maggi, "bad.yaml", "", 1)


def test_deep_nesting(maggi):
    (maggi.folder / "bad.yaml").write_text("[" * 100000)
    check_failure(maggi, "bad.yaml", "", 1)


# Models that read well and fail later: no line to point at, but a name.

LINKAGE = """\
format: maggi
version: 1
name: linkage
gravity: [0, 0, 0]
simulation:
  time: 2
  step: 0.001
bodies:
  - name: crank
    joint: {{type: revolute, point: [0, 0, 0], axis: [1, 0, 0], {crank}}}
    mass: 1
    bar: {{from: [0, 0, 0], to: [0, 1, 0]}}
  - name: coupler
    parent: crank
    joint: {{type: revolute, point: [0, 1, 0], axis: [1, 0, 0]}}
    mass: 1
    bar: {{from: [0, 1, 0], to: [0, 1.6, 0.8]}}
  - name: follower
    joint: {{type: revolute, point: [0, 2.2, 0], axis: [1, 0, 0], {follower}}}
    mass: {mass}
    bar: {{from: [0, 2.2, 0], to: [0, 1.6, 0.8]}}
loops:
  - name: tip
    type: revolute
    body_a: coupler
    body_b: follower
    point_a: [0, 1.6, 0.8]
    point_b: {point_b}
    axis: [1, 0, 0]
functions:
  - name: turn
    type: polynomial
    coefficients: [0, 1]
"""
TIP = "[0, 1.6, 0.8]"


def linkage(crank="position: 0", follower="guess: 0", mass="1", point_b=TIP):
    return LINKAGE.format(crank=crank, follower=follower, mass=mass, point_b=point_b)


def fail_with(maggi, text, message, arguments=()):
    (maggi.folder / "bad.yaml").write_text(text)
    return check_failure(maggi, "bad.yaml", message, None, arguments)


def test_linkage(maggi):
    (maggi.folder / "good.yaml").write_text(linkage(crank="velocity: 0.1"))
    maggi.simulate("good.yaml", 0.1, 1e-3)


def test_contradictory_velocities(maggi):
    text = linkage(crank="velocity: 1", follower="velocity: 7")
    said = fail_with(maggi, text, "velocit")
    assert "crank" in said or "follower" in said or "tip" in said


def test_contradictory_positions(maggi):
    said = fail_with(maggi, linkage(crank="position: 0.1", follower="position: 0.1"), "tip")
    assert "close" in said


def test_loop_cannot_close(maggi):
    said = fail_with(maggi, linkage(point_b="[0, 9, 9]"), "tip")
    assert "close" in said


def test_lock_up(maggi):
    """The crank's tip is 2 m from the follower's pivot at cos(t) = (1 + 2.2^2 - 4)/4.4."""
    said = fail_with(maggi, linkage(crank="motion: turn"), "tip")
    time = re.search(r"t = ([0-9.e+-]+)", said)
    assert time, said
    assert 1.13 < float(time.group(1)) < 1.141


def test_massless_leaf(maggi):
    text = linkage().replace(
        "loops:\n",
        "  - name: vane\n    parent: crank\n    joint: {type: revolute, point: [0, 1, 0], axis: [0, 1, 0]}\nloops:\n",
    )
    fail_with(maggi, text, "vane")


def test_step_too_large(maggi):
    """A stiff damper: each step of Runge-Kutta multiplies the velocity by some 1e30."""
    text = linkage(crank="velocity: 1")
    text = text[: text.index("  - name: coupler")]
    text += "joint_springs:\n  - {name: stiff, coordinate: crank, damping: 1e9}\n"
    said = fail_with(maggi, text, "finite", ["--step", "0.5", "--time", "1000"])
    assert "t = " in said


def test_step_too_large_for_a_loop(maggi):
    text = linkage(crank="velocity: 1").replace(
        "functions:\n",
        "joint_springs:\n  - {name: stiff, coordinate: crank, damping: 1e9}\nfunctions:\n",
    )
    said = fail_with(maggi, text, "", ["--step", "0.5", "--time", "1000"])
    assert "t = " in said and ("finite" in said or "tip" in said)


# A file that builds on another: the message names the one that has the fault.

VARIANT = """\
format: maggi
version: 1
name: variant
base: good.yaml
remove: [rods.strut, functions.road]
gravity: [0, 0, -1]
springs:
  - name: coil
    body_a: ground
    body_b: follower
    point_a: [0, -1, 0]
    point_b: [0, 1.2, -0.5]
    stiffness: 200
functions:
  - {name: pulse, type: constant, value: 1}
"""

VARIANT_ROWS = [
    ("no base", "good.yaml", "better.yaml", "variant.yaml", "base:", "better.yaml: cannot be opened"),
    ("base is a folder", "good.yaml", ".", "variant.yaml", "base:", "directory"),
    ("its own base", "good.yaml", "./variant.yaml", "variant.yaml", "base:", "builds on itself"),
    ("no base at all", "base: good.yaml\n", "", "variant.yaml", "remove:", '"base"'),
    ("nothing removed", "[rods.strut,", "[]  #", "variant.yaml", "remove:", "empty"),
    ("removed twice", "rods.strut,", "rods.strut, rods.strut,", "variant.yaml", "remove:",
     '"rods.strut" is not in the base'),
    ("removed is not there", "rods.strut", "rods.strand", "variant.yaml", "remove:",
     '"rods.strand" is not in the base'),
    ("removed from no list", "rods.strut", "gravity.x", "variant.yaml", "remove:", "LIST.NAME"),
    ("removed without a name", "rods.strut", "rods", "variant.yaml", "remove:", "LIST.NAME"),
    ("own entry twice", "functions:\n", "functions:\n  - {name: pulse, type: constant, value: 2}\n",
     "variant.yaml", "value: 1", "already"),
    ("own number wrong", "functions:", "set: [{name: springs.coil.x.y, value: 1}]\nfunctions:", "variant.yaml",
     "set: [", "no number"),
    ("own key wrong", "gravity:", "gravitation:", "variant.yaml", "gravitation:", "unknown key"),
    ("own entry wrong", "body_b: follower", "body_b: foll", "variant.yaml", "body_b:", '"foll"'),
    ("needed by the base", "[rods.strut,", "[bodies.ball, rods.strut,", "good.yaml",
     "    body: ball", '"ball"'),
    ("function needed by the base", "[rods.strut,", "[functions.turn, rods.strut,", "good.yaml",
     "- name: wheel", '"turn"'),
]  # fmt: skip


# of the reader, of an entry, and of what the whole model finds
BASE_ROWS = [
    row
    for row in ROWS
    if row.what
    in (
        "syntax: tab",
        "unknown key in a joint",
        "key twice",
        "body without joint",
        "text for a number",
        "negative step",
        "body twice",
        "unknown parent",
        "zero axis",
        "inertia not definite",
        "unknown motion",
        "loop without a point",
        "negative density",
        "unknown parameter",
    )
]


def check_variant(maggi, text, base, where, at, message, folder="."):
    for path, content in ((f"{folder}/variant.yaml", text), ("good.yaml", base)):
        (maggi.folder / path).parent.mkdir(exist_ok=True)
        (maggi.folder / path).write_text(content)
    result = maggi.run("info", f"{folder}/variant.yaml")
    if message is None:
        assert result.returncode == 0, result.stderr
        return
    assert result.returncode == 1 and result.stdout == "" and result.stderr.count("\n") == 1, result
    content = base if where.endswith("good.yaml") else text
    assert result.stderr.startswith(f"maggi: {folder}/{where}:{line_of(content, at)}: "), result.stderr
    assert message in result.stderr, result.stderr


def test_variant(maggi):
    check_variant(maggi, VARIANT, GOOD, "", "", None)
    check_variant(maggi, VARIANT.replace("good", "../good"), GOOD, "", "", None, "sub")


@pytest.mark.parametrize("row", VARIANT_ROWS, ids=lambda row: row[0])
def test_bad_variant(maggi, row):
    _, old, new, where, at, message = row
    assert VARIANT.count(old) >= 1
    check_variant(maggi, VARIANT.replace(old, new, 1), GOOD, where, at, message)


@pytest.mark.parametrize("row", BASE_ROWS, ids=lambda row: row.what)
def test_bad_base(maggi, row):
    """A fault of the base has the line of the base, from another folder too."""
    base = GOOD.replace(row.old, row.new, 1)
    variant = VARIANT.replace("good", "../good")
    check_variant(maggi, variant, base, "../good.yaml", row.at, row.message, "sub")


def test_base_cycle(maggi):
    head = "format: maggi\nversion: 1\nname: n\nbase: "
    (maggi.folder / "sub").mkdir()
    (maggi.folder / "a.yaml").write_text(head + "sub/b.yaml\n")
    (maggi.folder / "sub/b.yaml").write_text(head + "../sub/./../a.yaml\n")
    result = maggi.run("info", "a.yaml")
    assert result.returncode == 1
    assert result.stderr.startswith("maggi: sub/b.yaml:4: base: ") and "itself" in result.stderr


def test_base_chain(maggi):
    """Sixteen files build on each other, not seventeen."""
    for i in range(17):
        base = f"base: {i - 1}.yaml\n" if i else GOOD[GOOD.index("gravity") :]
        (maggi.folder / f"{i}.yaml").write_text(f"format: maggi\nversion: 1\nname: n{i}\n{base}")
    assert maggi.run("info", "15.yaml").returncode == 0
    result = maggi.run("info", "16.yaml")
    assert result.returncode == 1 and "1.yaml:4: base: more than 16 files" in result.stderr
