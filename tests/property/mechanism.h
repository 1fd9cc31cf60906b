/* Random mechanisms as plain descriptions, and their motion computed without the library.
 *
 * A description holds the definitions of maggi.h with indices in place of names, so that it can be
 * copied, moved, turned and built in any order of its parts (generate.c, transform.c, build.c).
 * mech_motion computes poses, velocities and accelerations of all bodies from the coordinates by
 * the textbook formulas of moving frames (motion.c): nothing of core/ is used, so the tests compare
 * two derivations.
 */
#ifndef MAGGI_TESTS_MECHANISM_H
#define MAGGI_TESTS_MECHANISM_H

#include <stdint.h>

#include "maggi/maggi.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
  MECH_GROUND = -1,
  MECH_BODIES = 40,
  MECH_COORDINATES = 6 * MECH_BODIES,
  MECH_LOOPS = 48,
  MECH_RODS = 8,
  MECH_POINT_MASSES = 4,
  MECH_SPRINGS = 6,
  MECH_JOINT_SPRINGS = 6,
  MECH_FORCES = 6,
  MECH_FUNCTIONS = 6,
  MECH_SENSORS = 16,
  MECH_KNOTS = 6,
  MECH_NAME = 16
};

/* what a seed makes: seed % MECH_KINDS */
#define MECH_KIND_LIST(X)                                                                          \
  X(MECH_TREE, "tree in space")                                                                    \
  X(MECH_TREE_GUIDED, "tree in space, guided coordinates")                                         \
  X(MECH_FLOATING, "tree on a free base")                                                          \
  X(MECH_LOOPS_SPACE, "loops of all types in space")                                               \
  X(MECH_LOOPS_RODS, "loops in space closed by rods")                                              \
  X(MECH_LOOPS_GUIDED, "loops in space, guided coordinates")                                       \
  X(MECH_LOOPS_OPEN, "loops in space that are open in the drawing")                                \
  X(MECH_PLANE, "loops in a plane, redundant")                                                     \
  X(MECH_PLANE_GUIDED, "loops in a plane, guided coordinates")                                     \
  X(MECH_PARALLELOGRAMS, "chain of parallelograms and other windows")                              \
  X(MECH_PLATFORM, "platform on parallel cranks, redundant across loops")                          \
  X(MECH_SARRUS, "Sarrus linkage, overconstrained in space")                                       \
  X(MECH_HINGES, "joints doubled by a loop on the same axis, rank 0")                              \
  X(MECH_MIXED, "loops in space and a Sarrus linkage in one model")

typedef enum mech_kind {
#define X(name, text) name,
  MECH_KIND_LIST(X)
#undef X
      MECH_KINDS
} mech_kind;

typedef struct mech_body {
  maggi_body_def def;
  int parent;                      /* body or MECH_GROUND */
  int motion[MAGGI_JOINT_DOF_MAX]; /* function or -1 */
  int q;                           /* first coordinate */
  int dof;
} mech_body;

typedef struct mech_loop {
  maggi_loop_def def;
  int a, b;
} mech_loop;

typedef struct mech_rod {
  maggi_rod_def def;
  int a, b;
} mech_rod;

typedef struct mech_point_mass {
  maggi_point_mass_def def;
  int body;
} mech_point_mass;

typedef struct mech_spring {
  maggi_spring_def def;
  int a, b;
} mech_spring;

typedef struct mech_joint_spring {
  maggi_joint_spring_def def;
  int q, q2; /* coordinates, q2 may be -1 */
} mech_joint_spring;

typedef struct mech_force {
  maggi_force_def def;
  int body, reaction, q, function; /* reaction may be MECH_GROUND, function -1 */
  int q2;                          /* of a controller, or -1 */
} mech_force;

typedef struct mech_function {
  maggi_function_def def;
  double times[MECH_KNOTS], values[MECH_KNOTS];
} mech_function;

typedef struct mech_sensor {
  maggi_sensor_def def;
  int body, element; /* spring, spring on coordinates or rod; -1 if none */
} mech_sensor;

typedef struct mechanism {
  uint64_t seed;
  mech_kind kind;
  int nq, nbody, nloop, nrod, npoint_mass, nspring, njoint_spring, nforce, nfunction, nsensor;
  double gravity[3];
  mech_body body[MECH_BODIES];
  mech_loop loop[MECH_LOOPS];
  mech_rod rod[MECH_RODS];
  mech_point_mass point_mass[MECH_POINT_MASSES];
  mech_spring spring[MECH_SPRINGS];
  mech_joint_spring joint_spring[MECH_JOINT_SPRINGS];
  mech_force force[MECH_FORCES];
  mech_function function[MECH_FUNCTIONS];
  mech_sensor sensor[MECH_SENSORS];
} mechanism;

/* random numbers: splitmix64 */
typedef struct mech_random {
  uint64_t state;
} mech_random;

double mech_uniform(mech_random *g, double low, double high);
int mech_integer(mech_random *g, int n); /* 0 .. n - 1 */

const char *mech_kind_text(mech_kind kind);

/* body that a coordinate belongs to */
int mech_body_of(const mechanism *m, int q);

/* The mechanism of a seed; further attempts of the same seed give others of the same kind. */
void mech_generate(uint64_t seed, int attempt, mechanism *m);

/* The same mechanism elsewhere, or in a turned world (gravity and loads too); R row major. */
void mech_translate(mechanism *m, const double d[3]);
void mech_rotate(mechanism *m, const double R[9]);

/* Without what acts on coordinates about global axes (spherical, free, some planar), which is other
 * physics in a turned world, and without sensors of springs on coordinates; number of parts dropped, or -1 when such a coordinate is guided. */
int mech_drop_axis_bound(mechanism *m);

/* Model of a mechanism.  shuffle: NULL for the order of the description, else parts of each kind
 * are added in a random order.  message of nmessage characters on failure. */
maggi_status mech_build(const mechanism *m, mech_random *shuffle, maggi_model **model,
                        char *message, size_t nmessage);

/* index in the model of each coordinate of the description, and of each body */
int mech_coordinate_map(const mechanism *m, const maggi_model *model, int map[MECH_COORDINATES]);
int mech_body_map(const mechanism *m, const maggi_model *model, int map[MECH_BODIES]);

/* A state in the coordinates of the description and as the turned description has it: coordinates
 * about global axes (spherical, free, some planar) are others there. */
void mech_rotate_state(const mechanism *m, const mechanism *turned, const double R[9],
                       const double *q, const double *v, double *q2, double *v2);

/* A body in motion: rotation since the drawing; joint point of the body: position, velocity,
 * acceleration; angular velocity and acceleration; for each coordinate its screw at the joint point
 * (linear, angular); and the relative acceleration (linear at the joint point, angular) of the body
 * to its parent when the second derivatives of its coordinates are zero. */
typedef struct mech_pose {
  double A[9];
  double o[3], v[3], a[3];
  double w[3], dw[3];
  double screw[MAGGI_JOINT_DOF_MAX][6];
  double bias[6];
} mech_pose;

void mech_motion(const mechanism *m, const double *q, const double *v, const double *a,
                 mech_pose *pose);

/* Point of a body (given in the drawing): position, velocity, acceleration; the ground has them
 * too. */
void mech_point(const mechanism *m, const mech_pose *pose, int body, const double point[3],
                double r[3], double v[3], double a[3]);

/* value, first and second derivative */
void mech_function_value(const mech_function *f, double t, double y[3]);

#ifdef __cplusplus
}
#endif

#endif
