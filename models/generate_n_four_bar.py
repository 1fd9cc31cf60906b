#!/usr/bin/env python3
"""Write n-four-bar-N.yaml: N four-bar windows side by side (IFToMM A02).

usage: generate_n_four_bar.py N TIME > n-four-bar-N.yaml
"""
import sys

HEAD = """\
# {n} four-bar windows side by side: {links} bars of 1 m and 1 kg in the XY plane.
#
#   crank_i    from A_i (i, 0) up to B_i (i, 1), revolute on the ground,  i = 0 .. {n}
#   coupler_i  from B_(i-1) to B_i, revolute on crank_(i-1), closed by a loop at crank_i
#
# Passes horizontal positions, where it has {n} degrees of freedom more for an instant; the cranks
# are parallel before and after.  The reference's angle is theta = pi/2 + crank_0.
#
# Written by generate_n_four_bar.py {n} {time}.
format: maggi
version: 1
name: n-four-bar-{n}
source: "{source}"
gravity: [0, -9.81, 0]
simulation: {{time: {time}, step: 0.001}}

# source: A02: 1 m, 1 kg uniform; B_0 starts with 1 m/s along +x, so all cranks with -1 rad/s
bodies:
"""

CRANK = """\
  - name: crank_{i}
    joint: {{type: revolute, point: [{i}, 0, 0], axis: [0, 0, 1]{velocity}}}
    mass: 1
    bar: {{from: [{i}, 0, 0], to: [{i}, 1, 0]}}
"""

COUPLER = """\
  - name: coupler_{i}
    parent: crank_{before}
    joint: {{type: revolute, point: [{before}, 1, 0], axis: [0, 0, 1]}}
    mass: 1
    bar: {{from: [{before}, 1, 0], to: [{i}, 1, 0]}}
"""

LOOP = """\
  - name: B_{i}
    type: revolute
    body_a: coupler_{i}
    body_b: crank_{i}
    point: [{i}, 1, 0]
    axis: [0, 0, 1]
"""

TAIL = """\

sensors:
  - {name: B0, type: position, body: crank_0, point: [0, 1, 0]}
  - {name: B0_velocity, type: velocity, body: crank_0, point: [0, 1, 0]}

objectives:
  - {name: swing, type: integral_square, signal: crank_0.v}
  - {name: height, type: mean, signal: B0.y}
  - {name: energy, type: smooth_maximum, signal: energy.kinetic, sharpness: 0.05}
  - {name: turn, type: terminal, signal: crank_0.q}

# masses, gravity and speed only: other lengths would not close where the windows are flat
design:
  - {name: mass, parameters: ["bodies.*.mass"]}
  - {name: mass0, parameters: [bodies.crank_0.mass]}
  - {name: gravity, parameters: [gravity.y], factors: [-1]}
  - {name: rate, parameters: [bodies.crank_0.joint.velocity]}
"""

SOURCE = {
    2: "IFToMM library of computational benchmark problems, A02 N-four-bar mechanism, N = 2",
    40: "Laboratorio de Ingenieria Mecanica, University of La Coruna, MBS benchmark A02, N = 40",
}


def model(n, time):
    """Text of the model file."""
    source = SOURCE.get(n, f"IFToMM A02 N-four-bar mechanism with N = {n}")
    text = [HEAD.format(n=n, links=2 * n + 1, time=time, source=source)]
    text.append(CRANK.format(i=0, velocity=", velocity: -1"))
    for i in range(1, n + 1):
        text.append(COUPLER.format(i=i, before=i - 1))
        text.append(CRANK.format(i=i, velocity=""))
    text.append("\nloops:\n")
    text.extend(LOOP.format(i=i) for i in range(1, n + 1))
    text.append(TAIL)
    return "".join(text)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.stdout.write(model(int(sys.argv[1]), sys.argv[2]))
