#!/usr/bin/env python3
"""Writes four-post.yaml: the laden coach, the centres of its wheels moved up and down by random profiles.

    generate_four_post.py > four-post.yaml          the model
    generate_four_post.py --profile > profile.csv   the points of the linear profile, amplitude 13.6 mm

Points every 0.5 m at 50 km/h, 0.036 s, w_k = A (2 u_k - 1), w_0 = 0; u_k from splitmix64, seed 20130000 + post, in the
order FL, FR, RL, RR. A C2 spline through them, level at both ends: so that a natural spline is, 20 points before and after
them are their mirror images (what they miss by is 0.27^20 = 4e-12 of a slope).
"""

import sys

POSTS = ["FL", "FR", "RL", "RR"]
INTERVALS, STEP, MIRRORED = 140, 0.036, 20
LINEAR, SPLINE = 0.0136, 0.012

# post, body, point
ENDS = {"FL": ("L_CARRIER", "[0, 1.025, 0.51801]"), "FR": ("R_CARRIER", "[0, -1.025, 0.51801]"),
        "RL": ("R_SUPPORT", "[-6.25, 0.91, 0.52082]"), "RR": ("R_SUPPORT", "[-6.25, -0.91, 0.52082]")}

HEAD = """\
# Written by generate_four_post.py.  Four-post ride test (thesis 6.3.4): the heights of the wheel centres are given, tyres
# are left out.  A post is a massless body on a guided slide; the centre of a wheel stays in its horizontal plane.  The dual
# wheels share one rigid support, so the rear posts act on it, in the middle between the wheels of a side.
#
# Random heights every 0.5 m at 50 km/h with an amplitude of 12 mm (estimated: fitted to the two objectives, 0.062 and
# 1.410 in the thesis), joined by a C2 spline.  The steering is held; nothing else holds the coach in the plane.
format: maggi
version: 1
name: coach-four-post
source: Coach of A. Callejo, PhD thesis, UPM 2013, section 6.3.4, random profile on four posts.
base: coach-laden.yaml
simulation: {time: 5.04, step: 0.001}
start: {equilibrium: true, hold: [R_CHASSIS.2, R_CHASSIS.3, R_CHASSIS.4, R_L_WHEEL, R_L_WHEEL_2,
  R_R_WHEEL, R_R_WHEEL_2, F_L_WHEEL, F_R_WHEEL]}
remove: [wheels.FL, wheels.FR, wheels.RLi, wheels.RLo, wheels.RRi, wheels.RRo, sensors.FL, sensors.FR, sensors.RLi,
  sensors.RLo, sensors.RRi, sensors.RRo, sensors.FL_slip, sensors.FR_slip, sensors.RLi_slip, sensors.RLo_slip,
  sensors.RRi_slip, sensors.RRo_slip, sensors.transfer_front, sensors.transfer_rear, sensors.transfer_dual]
bodies:
  - name: L_STEER
    parent: F_CHASSIS
    joint: {type: revolute, point: [0.2142, 0.384, 0.42], axis: [0, 0, 1], motion: steering}
    mass: 14
    cog: [0.0231, 0.384, 0.42]
    inertia: {xx: 0.05, yy: 0.22, zz: 0.22}"""


def numbers(seed):
    """splitmix64 in [0, 1)"""
    mask, x = 2**64 - 1, seed
    while True:
        x = (x + 0x9E3779B97F4A7C15) & mask
        z = ((x ^ (x >> 30)) * 0xBF58476D1CE4E5B9) & mask
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & mask
        yield ((z ^ (z >> 31)) >> 11) * 2.0**-53


def profile(post, amplitude):
    """heights of the points, the first 0"""
    u = numbers(20130000 + post)
    w = [amplitude * (2.0 * next(u) - 1.0) for _ in range(INTERVALS + 1)]
    return [0.0] + w[1:]


def wrapped(key, values):
    """a list over many lines"""
    rows = [values[i:i + 10] for i in range(0, len(values), 10)]
    return f"    {key}: [\n" + ",\n".join("      " + ", ".join(row) for row in rows) + "]"


def main():
    if sys.argv[1:] == ["--profile"]:
        print("k,t_rel," + ",".join(POSTS))
        for k, row in enumerate(zip(*(profile(i, LINEAR) for i in range(4)))):
            print(f"{k},{STEP * k:.3f}," + ",".join(f"{w:.12g}" for w in row))
        return
    print(HEAD)
    for post in POSTS:
        print(f"  - {{name: POST_{post}, joint: {{type: prismatic, axis: [0, 0, 1], motion: profile_{post}}}}}")
    print("loops:")
    for post in POSTS:
        body, point = ENDS[post]
        print(f"  - {{name: POST_{post}, type: point_plane, body_a: {body}, body_b: POST_{post}, point: {point}, "
              "axis: [0, 0, 1]}")
    print("functions:\n  - {name: steering, type: constant, value: 0}")
    times = [f"{STEP * k:.3f}" for k in range(-MIRRORED, INTERVALS + MIRRORED + 1)]
    for i, post in enumerate(POSTS):
        w = profile(i, SPLINE)
        w = w[MIRRORED:0:-1] + w + w[-2:-MIRRORED - 2:-1]
        print(f"  - name: profile_{post}\n    type: spline")
        print(wrapped("times", times))
        print(wrapped("values", [f"{x:.12g}" for x in w]))
    print("sensors:")
    for post in POSTS:
        body, point = ENDS[post]
        print(f"  - {{name: POST_{post}, type: position, body: {body}, point: {point}}}")
    print("objectives:\n  - {name: PRF1, type: vdv, signal: bodywork_velocity.z}\n"
          "  - {name: PRF2, type: vdv, signal: bodywork_acceleration.z}")


if __name__ == "__main__":
    main()
