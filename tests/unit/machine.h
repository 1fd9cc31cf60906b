/* A mechanism with one of each: loop, rod with mass, guided coordinate, open branch, springs, loads
 * of all types, functions of time, given initial position and velocity. */
#ifndef MAGGI_TEST_MACHINE_H
#define MAGGI_TEST_MACHINE_H

#include "fixture.h"

/* crank - coupler (universal) - slider closed by a ball; a rod from the crank to an arm that is
 * guided on a rocker; a bob with drag hangs from the slider */
static inline maggi_model *machine_model(void)
{
  return test_model(
      "gravity: [0.3, -0.2, -9.81]\n"
      "bodies:\n"
      "- {name: crank, mass: 1.4, cog: [0.02, 0.1, 0.2], inertia: {xx: 0.1, yy: 0.08, zz: 0.09,"
      " xy: 0.01, xz: -0.005, yz: 0.006}, joint: {type: revolute, point: [0, 0, 0],"
      " axis: [1, 0.1, 0], position: 0.2, velocity: 2.5}}\n"
      "- {name: coupler, parent: crank, mass: 0.8, bar: {from: [0, 0, 0.4], to: [0.2, 1.1, 0.1]},"
      " joint: {type: universal, point: [0, 0, 0.4], axis: [1, 0.1, 0], axis2: [-0.1, 1, 0.3]}}\n"
      "- {name: slider, mass: 0.7, cog: [0.2, 1.15, 0.12], inertia: {xx: 0.02, yy: 0.03, zz: 0.02},"
      " joint: {type: prismatic, axis: [0.1, 1, 0.05]}}\n"
      "- {name: rocker, mass: 0.9, cog: [0.5, 0.3, 0.3], inertia: {xx: 0.05, yy: 0.06, zz: 0.04,"
      " xy: 0.004, xz: 0.002, yz: -0.006}, joint: {type: revolute, point: [0.6, 0.2, 0],"
      " axis: [0.2, 1, 0.1]}}\n"
      "- {name: arm, parent: rocker, mass: 0.3, cog: [0.6, 0.4, 0.6], inertia: {xx: 0.01, yy: 0.02,"
      " zz: 0.015}, joint: {type: revolute, point: [0.5, 0.3, 0.4], axis: [0.3, 1, 0.2],"
      " motion: sway}}\n"
      "- {name: bob, parent: slider, mass: 0.5, cog: [0.25, 1.2, -0.4], inertia: {xx: 0.02, yy: "
      "0.03,"
      " zz: 0.01}, joint: {type: spherical, point: [0.2, 1.2, 0.1], velocities: [0.3, 1, -0.8]}}\n"
      "loops:\n"
      "- {name: pin, type: spherical, body_a: coupler, body_b: slider, point: [0.2, 1.1, 0.1]}\n"
      "rods:\n"
      "- {name: rod, body_a: crank, body_b: arm, point_a: [0.1, 0.05, 0.3],"
      " point_b: [0.55, 0.3, 0.55], mass: 0.4}\n"
      "springs:\n"
      "- {name: spring, body_a: bob, body_b: arm, point_a: [0.3, 1.1, -0.3],"
      " point_b: [0.6, 0.5, 0.7], stiffness: 12, free_length: 0.7, damping: 0.4}\n"
      "joint_springs:\n"
      "- {name: hinge, coordinate: crank, coordinate2: rocker, stiffness: 1.5, damping: 0.1,"
      " rest: 0.2, preload: 0.3}\n"
      "functions:\n"
      "- {name: sway, type: sine, amplitude: 0.3, omega: 4, phase: 0.5, offset: 0.1}\n"
      "- {name: wave, type: sine, amplitude: 2, omega: 3, phase: 0, offset: 1}\n"
      "forces:\n"
      "- {name: push, type: force, body: coupler, point: [0.1, 0.5, 0.3], value: [0.5, 1, -2],"
      " function: wave}\n"
      "- {name: thrust, type: force_body, body: bob, reaction: rocker, point: [0.3, 1.2, -0.4],"
      " value: [1, 0.5, 0.2]}\n"
      "- {name: twist, type: torque_body, body: bob, value: [0.1, -0.2, 0.3]}\n"
      "- {name: motor, type: joint, coordinate: crank, effort: 0.8, function: wave}\n"
      "- {name: air, type: drag, body: bob, point: [0.25, 1.2, -0.5], density: 1.2,"
      " coefficient: 0.9, area: 0.3, low_speed: 0.2, wind: [1, 0.5, 0]}\n"
      "sensors:\n"
      "- {name: tip, type: acceleration, body: bob, point: [0.3, 1.1, -0.5]}\n"
      "- {name: force, type: rod, element: rod}\n");
}

#endif
