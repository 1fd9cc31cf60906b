#!/usr/bin/env python3
"""Write chain-N.yaml: a spatial chain of N bars, for benchmarks.

usage: generate_chain.py N > chain-N.yaml
"""
import sys

HEAD = """\
# Spatial chain of {n} bars of 1 m and 1 kg, for benchmarks: no loops, {n} coordinates.
#
# Bars run along +Y, -Z, +X in turn, a staircase; the revolute at the beginning of each is about X,
# Y, Z in turn, square to its bar, so that no bar spins about itself.  The first is on the ground at
# the origin.  At rest at first; the motion soon is chaotic: compare energies, not positions.
#
# Written by generate_chain.py {n}.
format: maggi
version: 1
name: chain-{n}
source: "maggi, made for benchmarks"
gravity: [0, 0, -9.81]
simulation: {{time: 1, step: 0.001}}

bodies:
"""

TAIL = """\

sensors:
  - {{name: tip, type: position, body: bar{n}, point: {tip}}}

objectives:
  - {{name: drop, type: mean, signal: tip.z}}
  - {{name: energy, type: integral, signal: energy.kinetic}}
  - {{name: swing, type: integral_square, signal: bar{n}.q}}
  - {{name: load, type: smooth_maximum, signal: bar1.fz, sharpness: 0.05}}

design:
  - {{name: mass, parameters: ["bodies.*.mass"]}}
  - {{name: mass{n}, parameters: [bodies.bar{n}.mass]}}
  - {{name: gravity, parameters: [gravity.z], factors: [-1]}}
"""


def model(n):
    """Text of the model file."""
    text = [HEAD.format(n=n)]
    point = [0, 0, 0]
    for i in range(n):
        end = list(point)
        end[(i + 1) % 3] += -1 if i % 3 == 1 else 1
        axis = [int(k == i % 3) for k in range(3)]
        text.append(f"  - name: bar{i + 1}\n")
        if i:
            text.append(f"    parent: bar{i}\n")
        text.append(f"    joint: {{type: revolute, point: {point}, axis: {axis}}}\n")
        text.append(f"    mass: 1\n    bar: {{from: {point}, to: {end}}}\n")
        point = end
    text.append(TAIL.format(n=n, tip=point))
    return "".join(text)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.stdout.write(model(int(sys.argv[1])))
