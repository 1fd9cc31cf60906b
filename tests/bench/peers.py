#!/usr/bin/env python3
"""maggi and MuJoCo on the same mechanisms, turn by turn.

usage: peers.py BENCH MAGGI REPEAT [--rounds N] [--markdown] [--csv FILE]

BENCH is the program of bench.c, MAGGI the command, REPEAT the library of repeat.c: make bench-peers
knows where they are.  The MJCF is written from the numbers of `maggi info --json`, so both programs
have one source.  MuJoCo closes loops by soft constraints, here with the time constant of one step
(which gives it the smallest errors) and with dense or sparse matrices, whichever is faster.
"""
import argparse
import collections
import csv
import ctypes
import glob
import json
import math
import os
import statistics
import subprocess
import sys
import time
from xml.etree import ElementTree

MODELS = ["spatial-four-bar", "chain-30",
          "multiple-four-bar:1x15", "multiple-four-bar:4x15", "multiple-four-bar:7x15"]
ARRAY = "multiple-four-bar:1x15"
STEP = 1e-3
MOVING = 0.2          # time of the state that is evaluated and compared [s]
SAMPLE = 1e-3         # CPU time of a sample, at least [s]
SAMPLES = 11
RUN_STEPS = [0.01, 0.008, 0.00625, 0.005, 0.004, 0.002, 0.001]
REFERENCE = (-1.101711811731, -0.652517178718)  # th1, th15 of 1x15 at 5 s: tests/references/T6_..
REFERENCE_TIME = 5.0
ROWS = 15
ERROR = 3e-7          # [rad]
AXIAL = 1e-9          # MuJoCo wants inertia about the axis of a thin bar: this part of m l^2
IMPEDANCE = 0.9999    # the hardest constraint that MuJoCo knows


def fail(text):
    sys.exit("bench-peers: " + text)


def call(*command):
    command = [str(word) for word in command]
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode != 0:
        fail(f"{' '.join(command)}: {result.stderr.strip() or result.returncode}")
    return result.stdout


# ------------------------------------------------------------------------------------- MJCF

Model = collections.namedtuple("Model", "name p bodies loops")


def read_model(maggi, name):
    info = json.loads(call(maggi, "info", name, "--json"))
    p = {entry["path"]: entry["value"] for entry in info["parameters"]}
    return Model(name, p, info["bodies"], info["loops"])


def vector(p, path):
    return [p[f"{path}.{axis}"] for axis in "xyz"]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def words(numbers):
    return " ".join(repr(float(x)) for x in numbers)


def add_inertia(element, p, name, origin):
    """Thin bar: m/12 (l^2 I - e e^T), and a little about its axis."""
    path = f"bodies.{name}"
    begin, end = vector(p, path + ".bar.from"), vector(p, path + ".bar.to")
    mass, e = p[path + ".mass"], minus(end, begin)
    square = sum(x*x for x in e)
    tensor = [mass/12*((i == j)*square - e[i]*e[j]) + mass*AXIAL*e[i]*e[j]
              for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
    centre = [0.5*(a + b) for a, b in zip(begin, end)]
    ElementTree.SubElement(element, "inertial", pos=words(minus(centre, origin)), mass=repr(mass),
                           fullinertia=words(tensor))


def loop_bodies(model, loop):
    """Bodies that a loop joins; the information of maggi does not tell."""
    if model.name.startswith("multiple-four-bar"):  # h_R_C ends at the foot of v_R_(C+1)
        _, row, column = loop.split("_")
        return loop, f"v_{row}_{int(column) + 1}"
    return {("spatial-four-bar", "coupler_end"): ("coupler", "follower")}[model.name, loop]


def mjcf(model, step, jacobian):
    """Frames of bodies are global at qpos = 0, as those of maggi."""
    p = model.p
    root = ElementTree.Element("mujoco", model=model.name)
    ElementTree.SubElement(root, "compiler", angle="radian")
    option = ElementTree.SubElement(root, "option", timestep=repr(step), integrator="RK4",
                                    gravity=words(vector(p, "gravity")), solver="Newton",
                                    iterations="100", jacobian=jacobian)
    ElementTree.SubElement(option, "flag", contact="disable", refsafe="disable")
    frame, origin = {"ground": ElementTree.SubElement(root, "worldbody")}, {"ground": [0.0]*3}
    waiting = list(model.bodies)
    while waiting:
        body = waiting.pop(0)
        name, parent = body["name"], body["parent"]
        if parent not in frame:
            waiting.append(body)
            continue
        if body["joint"] not in ("revolute", "universal"):
            fail(f"{model.name}: no MJCF for a {body['joint']} joint")
        origin[name] = vector(p, f"bodies.{name}.joint.point")
        frame[name] = ElementTree.SubElement(frame[parent], "body", name=name,
                                             pos=words(minus(origin[name], origin[parent])))
        add_inertia(frame[name], p, name, origin[name])
        for coordinate, axis in zip(body["coordinates"], ("axis", "axis2")):
            ElementTree.SubElement(frame[name], "joint", name=coordinate,
                                   axis=words(vector(p, f"bodies.{name}.joint.{axis}")))
    equality = ElementTree.SubElement(root, "equality")
    for loop in model.loops:
        a, b = loop_bodies(model, loop["name"])
        anchor = minus(vector(p, f"loops.{loop['name']}.point"), origin[a])
        ElementTree.SubElement(equality, "connect", body1=a, body2=b, anchor=words(anchor),
                               solref=words([step, 1.0]),
                               solimp=words([IMPEDANCE, IMPEDANCE, 0.001, 0.5, 2.0]))
    return ElementTree.tostring(root, encoding="unicode")


# ---------------------------------------------------------------------------------- MuJoCo

class Peer:
    """A model in MuJoCo, at the state of motion that maggi reports."""

    def __init__(self, mujoco, repeat, model, step=STEP, jacobian="auto"):
        self.mujoco, self.repeat = mujoco, repeat
        self.model = mujoco.MjModel.from_xml_string(mjcf(model, step, jacobian))
        self.data = mujoco.MjData(self.model)
        library = ctypes.CDLL(glob.glob(os.path.dirname(mujoco.__file__) + "/libmujoco.so*")[0])
        self.functions = {name: ctypes.cast(getattr(library, name), ctypes.c_void_p)
                          for name in ("mj_forward", "mj_step")}

    def index(self, names):
        return [self.model.joint(name).qposadr[0] for name in names]

    def set(self, state):
        at = self.index(state["names"])
        self.mujoco.mj_resetData(self.model, self.data)
        self.data.qpos[at] = state["q"]
        self.data.qvel[at] = state["v"]

    def times(self, function, n):
        """CPU seconds of n calls."""
        begin = time.thread_time()
        self.repeat(self.functions[function], ctypes.c_void_p(self.model._address),
                    ctypes.c_void_p(self.data._address), n)
        return time.thread_time() - begin

    def microseconds(self, function):
        """Median of a call."""
        n = 1
        while self.times(function, n) < SAMPLE:
            n *= 2
        return 1e6*statistics.median(self.times(function, n) for _ in range(SAMPLES))/n

    def acceleration_error(self, state):
        """Largest difference of accelerations, relative to the largest acceleration."""
        self.set(state)
        self.mujoco.mj_forward(self.model, self.data)
        mine = self.data.qacc[self.index(state["names"])]
        return max(abs(mine - state["a"]))/max(map(abs, state["a"]))

    def motion_error(self, start, end):
        """Largest difference of coordinates at the time of `end`."""
        self.set(start)
        self.times("mj_step", round((end["time"] - start["time"])/self.model.opt.timestep))
        return max(abs(self.data.qpos[self.index(end["names"])] - end["q"]))

    def run(self, start):
        """Five seconds of 1x15: CPU seconds, end error."""
        self.set(start)
        cpu = self.times("mj_step", round(REFERENCE_TIME/self.model.opt.timestep))
        angles = self.data.qpos[self.index([f"v_{row}_1" for row in range(1, ROWS + 1)])]
        return cpu, max(abs(angles[0] - REFERENCE[0]), abs(sum(angles) - REFERENCE[1]))


# ------------------------------------------------------------------------------------ suites

def print_table(head, rows, markdown):
    table = [head] + rows
    width = [max(len(row[k]) for row in table) for k in range(len(head))]
    for k, row in enumerate(table):
        cells = [row[0].ljust(width[0])] + [cell.rjust(w) for cell, w in zip(row[1:], width[1:])]
        print("| " + " | ".join(cells) + " |" if markdown else "  ".join(cells))
        if k == 0:
            print("|" + "|".join("-"*(w + 1) + ":" for w in width) + "|" if markdown else
                  "  ".join("-"*w for w in width))
    print()


def states(bench, name):
    return [json.loads(call(bench, "state", name, at, STEP)) for at in (0, MOVING)]


def fastest(mujoco, repeat, model, moving):
    """With dense or sparse matrices, whichever is faster here."""
    peers = {}
    for jacobian in ("dense", "sparse"):
        peer = Peer(mujoco, repeat, model, jacobian=jacobian)
        peer.set(moving)
        peers[jacobian] = peer
    return min(peers.values(), key=lambda peer: peer.microseconds("mj_step"))


def evaluations(options, mujoco, repeat):
    rows = []
    for name in MODELS:
        model = read_model(options.maggi, name)
        start, moving = states(options.bench, name)
        peer = fastest(mujoco, repeat, model, moving)
        ours, theirs, ours_step, theirs_step = [], [], [], []
        for _ in range(options.rounds):
            ours.append(float(call(options.bench, "evaluation", name).split()[0]))
            peer.set(moving)
            peer.times("mj_step", 2)
            theirs.append(peer.microseconds("mj_forward"))
            ours_step.append(float(call(options.bench, "step", name, STEP, 200)))
            peer.set(start)
            theirs_step.append(1e6*peer.times("mj_step", 200)/800)
        ratio = statistics.median(a/b for a, b in zip(ours, theirs))
        ratio_step = statistics.median(a/b for a, b in zip(ours_step, theirs_step))
        rows.append([name, f"{statistics.median(ours):.2f}", f"{statistics.median(theirs):.2f}",
                     f"{ratio:.2f}", f"{1/ratio:.1f}",
                     f"{statistics.median(ours_step):.2f}", f"{statistics.median(theirs_step):.2f}",
                     f"{ratio_step:.2f}",
                     f"{peer.acceleration_error(moving):.0e}",
                     f"{peer.motion_error(start, moving):.0e}"])
        options.table.writerow(["evaluation", name, STEP, statistics.median(ours), "", "maggi"])
        options.table.writerow(["evaluation", name, STEP, statistics.median(theirs), "", "mujoco"])
    print("One forward evaluation (maggi_evaluate, mj_forward), and a quarter of a step of RK4\n")
    print_table(["model", "maggi us", "MuJoCo us", "ratio", "times faster", "maggi step/4",
                 "MuJoCo step/4", "ratio", "accelerations differ", f"motion at {MOVING} s differs"],
                rows, options.markdown)


def seconds_at(runs):
    """CPU time at ERROR: a line in logarithms through the runs within a factor of ten of it, since
    the errors of single runs scatter."""
    near = [(math.log(cpu), math.log(error)) for _, cpu, error in runs if 0.1 < error/ERROR < 10]
    if len(near) < 2:
        return math.nan
    slope, level = statistics.linear_regression([x for x, _ in near], [y for _, y in near])
    return math.exp((math.log(ERROR) - level)/slope)


def accuracy(options, mujoco, repeat):
    model = read_model(options.maggi, ARRAY)
    start, moving = states(options.bench, ARRAY)
    jacobian = {mujoco.mjtJacobian.mjJAC_SPARSE: "sparse"}.get(
        fastest(mujoco, repeat, model, moving).model.opt.jacobian, "dense")
    ours, theirs, rows = [], [], []
    for step in RUN_STEPS:
        peer = Peer(mujoco, repeat, model, step, jacobian=jacobian)
        mine, other = [], []
        for _ in range(max(3, options.rounds//3)):
            mine.append([float(x) for x in call(options.bench, "run", step).split()])
            other.append(peer.run(start))
        pair = [(statistics.median(x[0] for x in runs), runs[0][1]) for runs in (mine, other)]
        ours.append((step, *pair[0]))
        theirs.append((step, *pair[1]))
        rows.append([f"{1e3*step:g}", f"{pair[0][0]:.4f}", f"{pair[0][1]:.1e}", f"{pair[1][0]:.4f}",
                     f"{pair[1][1]:.1e}", f"{pair[0][0]/pair[1][0]:.2f}"])
        for (cpu, error), who in zip(pair, ("maggi", "mujoco")):
            options.table.writerow(["accuracy", ARRAY, step, cpu, error, who])
    print("Five seconds of 1x15 by RK4\n")
    print_table(["step ms", "maggi s", "end error rad", "MuJoCo s", "end error rad",
                 "ratio of times"], rows, options.markdown)
    a, b = seconds_at(ours), seconds_at(theirs)
    print(f"at an end error of {ERROR:g} rad: maggi {a:.4f} s, MuJoCo {b:.4f} s, ratio {a/b:.3f} "
          "(target at most 0.33)")


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("\n\n")[1].removeprefix("usage: "))
    parser.add_argument("bench")
    parser.add_argument("maggi")
    parser.add_argument("repeat")
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--markdown", action="store_true")
    parser.add_argument("--csv")
    options = parser.parse_args()
    try:
        import mujoco
    except ImportError:
        print(f"bench-peers: MuJoCo is not installed: {sys.executable} -m pip install mujoco")
        return
    repeat = ctypes.CDLL(options.repeat).maggi_repeat
    repeat.argtypes = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int]
    repeat.restype = None
    with open(options.csv or os.devnull, "w", newline="", encoding="utf-8") as file:
        options.table = csv.writer(file)
        options.table.writerow(["suite", "case", "step_s", "time", "error_rad", "program"])
        print(f"MuJoCo {mujoco.__version__}, medians of {options.rounds} turns\n")
        evaluations(options, mujoco, repeat)
        accuracy(options, mujoco, repeat)


if __name__ == "__main__":
    main()
