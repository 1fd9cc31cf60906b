/* maggi: dynamics of multibody systems with exact loops, in plain C.
 *
 * A model is built once (from C with maggi_builder_*, or from a YAML file with maggi_model_load)
 * and never changes: many threads may share it.  A maggi_data is the workspace of one simulation:
 * one per thread.  The flow is one way:
 *
 *   maggi_builder or file -> maggi_model -> maggi_data -> maggi_data_reset -> maggi_step -> get
 *
 * Units are SI and radians.  Geometry is given in the initial position, in the global frame: every
 * point, axis and inertia tensor as one would measure it on the real machine, where all joint
 * coordinates are zero.  All real numbers of a model are entries of one parameter vector p, each
 * with a path such as "bodies.crank.mass" (see maggi_parameter_find).
 *
 * Nothing here prints, exits or aborts.  Functions that can fail return maggi_status, 0 is success.
 *
 * [1] A. Callejo, Dynamic Response Optimization of Vehicles through Efficient Multibody
 *     Formulations and Automatic Differentiation Techniques, PhD thesis, UPM, 2013.
 */
#ifndef MAGGI_MAGGI_H
#define MAGGI_MAGGI_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define MAGGI_VERSION "0.5.0"

/* ---------------------------------------------------------------------------------- status */

#define MAGGI_STATUS_LIST(X)                                                                       \
  X(MAGGI_OK, "success")                                                                           \
  X(MAGGI_E_MEMORY, "out of memory")                                                               \
  X(MAGGI_E_FILE, "a file cannot be read or written")                                              \
  X(MAGGI_E_MODEL, "the model is wrong")                                                           \
  X(MAGGI_E_NAME, "no such name")                                                                  \
  X(MAGGI_E_VALUE, "a value is out of range")                                                      \
  X(MAGGI_E_ASSEMBLY, "the loops cannot be closed in the initial position")                        \
  X(MAGGI_E_LOCKUP, "the mechanism locks up")                                                      \
  X(MAGGI_E_MASS, "the mass matrix is singular")                                                   \
  X(MAGGI_E_NOT_FINITE, "the solution is not finite")                                              \
  X(MAGGI_E_STOPPED, "stopped by the caller")

typedef enum maggi_status {
#define X(name, text) name,
  MAGGI_STATUS_LIST(X)
#undef X
      MAGGI_STATUS_COUNT
} maggi_status;

/* Text of a status, never NULL, owned by the library. */
const char *maggi_status_text(maggi_status status);

/* --------------------------------------------------------------------------------- builder */

typedef struct maggi_builder maggi_builder;
typedef struct maggi_model maggi_model;
typedef struct maggi_data maggi_data;

#define MAGGI_GROUND        "ground" /* the name of the fixed body */
#define MAGGI_JOINT_DOF_MAX 6

/* Joints of the tree.  Compound joints are chains of revolutes (R) and prismatics (P) with massless
 * bodies between, in the order given; their coordinates are NAME.1, NAME.2, ..
 *
 *   revolute     R about axis through point                                       1 coordinate
 *   prismatic    P along axis                                                     1
 *   cylindrical  P along axis, then R about it                                    2
 *   universal    R about axis (fixed in the parent), R about axis2 (in the body)  2
 *   planar       P along axis2, P along axis x axis2, R about axis (the normal)   3
 *   spherical    R about global z, y, x through point                             3
 *   free         P along global z, y, x, then R about z, y, x through point       6
 *   fixed        rigidly attached                                                 0
 */
typedef enum maggi_joint_type {
  MAGGI_JOINT_REVOLUTE,
  MAGGI_JOINT_PRISMATIC,
  MAGGI_JOINT_CYLINDRICAL,
  MAGGI_JOINT_UNIVERSAL,
  MAGGI_JOINT_PLANAR,
  MAGGI_JOINT_SPHERICAL,
  MAGGI_JOINT_FREE,
  MAGGI_JOINT_FIXED,
  MAGGI_JOINT_TYPE_COUNT
} maggi_joint_type;

/* Whether and how an initial position or velocity of a coordinate is prescribed. */
typedef enum maggi_initial {
  MAGGI_INITIAL_FREE,  /* the value is where Newton starts; 0 unless given                       */
  MAGGI_INITIAL_GIVEN, /* held exactly; the other coordinates close the loops around it          */
  MAGGI_INITIAL_COUNT
} maggi_initial;

/* A body and the joint that attaches it to its parent.  maggi_body_def_init fills the defaults:
 * ground, revolute about x through the origin, no mass.  Strings and arrays are copied.
 *
 *   mass    [kg]            paths  bodies.NAME.mass
 *   cog     [m]                    bodies.NAME.cog.x ..                  (not of a bar)
 *   inertia about the cog,
 *           xx yy zz xy xz yz,
 *           entries of the tensor
 *           [kg m^2]               bodies.NAME.inertia.xx ..             (not of a bar)
 *   bar     uniform thin bar
 *           between two points [m] bodies.NAME.bar.from.x .. bar.to.z
 *   joint   point [m], axis,
 *           axis2 (any length)     bodies.NAME.joint.point.x, .axis.x, .axis2.x
 *   position, velocity
 *           initial [rad or m]     bodies.NAME.joint.position, .velocity (.1, .2 .. if compound)
 *   motion  function of time that guides the coordinate, or NULL; a guided coordinate takes no
 *           initial position and velocity
 *
 * axis2 of a planar joint may be left zero: a direction in the plane is chosen.
 */
typedef struct maggi_body_def {
  const char *name;
  const char *parent;
  maggi_joint_type joint;
  double point[3];
  double axis[3];
  double axis2[3];
  maggi_initial position_given[MAGGI_JOINT_DOF_MAX];
  double position[MAGGI_JOINT_DOF_MAX];
  maggi_initial velocity_given[MAGGI_JOINT_DOF_MAX];
  double velocity[MAGGI_JOINT_DOF_MAX];
  const char *motion[MAGGI_JOINT_DOF_MAX];
  double mass;
  int is_bar;
  double cog[3];
  double inertia[6];
  double bar_from[3];
  double bar_to[3];
} maggi_body_def;

/* A point mass added to a body: paths bodies.BODY.point_masses.NAME.mass, .point.x .. */
typedef struct maggi_point_mass_def {
  const char *name;
  const char *body;
  double mass;
  double point[3];
} maggi_point_mass_def;

/* A loop, cut at a joint between body_a and body_b.  [1] 2.39-2.50
 *
 *   spherical    the two points coincide                                        3 equations
 *   revolute     and the two axes, as unit vectors                              6, rank 5 at most
 *   universal    points coincide, axis_a (in body_a) keeps its angle to axis_b  4
 *   cylindrical  the two axes stay on one line                                  4
 *   prismatic    and do not turn about it                                       5
 *   point_plane  point_a stays in the plane of body_b through point_b whose
 *                normal is axis_b                                               1
 *
 * A prismatic loop whose axes differ in the file takes the turn about them from the smallest turn that
 * brings one onto the other.
 * point_b and axis_b are used when has_b is true; else the loop is closed in the file and both sides
 * share point_a and axis_a (universal always needs axis_b).  When has_b is true and the two sides
 * differ, the model is assembled when a simulation starts.
 * Paths: loops.NAME.point.x, .axis.x; with has_b loops.NAME.point_a.x, .point_b.x, .axis_a.x, ..
 * A universal loop has axis_a and axis_b in either case, point_plane one, axis.
 */
typedef enum maggi_loop_type {
  MAGGI_LOOP_SPHERICAL,
  MAGGI_LOOP_REVOLUTE,
  MAGGI_LOOP_UNIVERSAL,
  MAGGI_LOOP_CYLINDRICAL,
  MAGGI_LOOP_PRISMATIC,
  MAGGI_LOOP_POINT_PLANE,
  MAGGI_LOOP_TYPE_COUNT
} maggi_loop_type;

typedef struct maggi_loop_def {
  const char *name;
  maggi_loop_type type;
  const char *body_a;
  const char *body_b;
  int has_b;
  double point_a[3];
  double point_b[3];
  double axis_a[3];
  double axis_b[3];
} maggi_loop_def;

/* A rod: two points at constant distance; uniform thin rod of the given mass, without inertia about
 * its own axis (a mass of 0 is allowed).  [1] 2.84
 * length: NAN means the distance of the points in the file; a number is a parameter of its own.
 * Paths: rods.NAME.mass, .point_a.x .., .point_b.x .., .length if given.
 */
typedef struct maggi_rod_def {
  const char *name;
  const char *body_a;
  const char *body_b;
  double point_a[3];
  double point_b[3];
  double mass;
  double length;
} maggi_rod_def;

/* Spring and damper between two points, force along the line, tension positive:
 *
 *   F = stiffness*(l - free_length) + damping*l'      or
 *   F = stiffness*(l - l_file) + preload + damping*l'      when free_length is NAN
 *
 * and, when has_slopes, plus the four-slope damper of [1] 3.8, a continuous piecewise linear force
 * of v = l' (v > 0 is rebound) with slopes c1 up to v11 and c2 above; c3 down to v22 and c4 below.
 * Paths: springs.NAME.stiffness, .free_length or .preload, .damping, .point_a.x .., .c1 .. .c4,
 * .v11, .v22.
 */
typedef struct maggi_spring_def {
  const char *name;
  const char *body_a;
  const char *body_b;
  double point_a[3];
  double point_b[3];
  double stiffness;
  double free_length;
  double preload;
  double damping;
  int has_slopes;
  double c[4];
  double v11;
  double v22;
} maggi_spring_def;

/* Spring and damper on joint coordinates, [1] 3.9 when two coordinates are named:
 *
 *   tau = -stiffness*(z - rest) - damping*z' - preload     on the coordinate z, or z = z_1 - z_2
 *                                                          (then tau on 1 and -tau on 2)
 * coordinate: "NAME" of a body with a one-DOF joint, or "NAME.2" inside a compound joint.
 * coordinate2: NULL for a spring on one coordinate.
 * Paths: joint_springs.NAME.stiffness, .damping, .rest, .preload.
 */
typedef struct maggi_joint_spring_def {
  const char *name;
  const char *coordinate;
  const char *coordinate2;
  double stiffness;
  double damping;
  double rest;
  double preload;
} maggi_joint_spring_def;

/* An applied load: what its type says times function(t), or alone when function is NULL.
 *
 *   MAGGI_FORCE_GLOBAL   force [N] at a point of a body, components in global axes
 *   MAGGI_FORCE_BODY     force [N] at a point of a body, components in body axes, i.e. in the global
 *                        axes of the initial position, then turning with the body
 *   MAGGI_TORQUE_GLOBAL  torque [N m] on a body, global axes
 *   MAGGI_TORQUE_BODY    torque [N m] on a body, body axes
 *   MAGGI_FORCE_JOINT    torque or force on a joint coordinate: value[0]
 *   MAGGI_FORCE_DRAG     drag [N] of the air at a point of a body, global axes:
 *                          -density/2 coefficient area |u| u,   |u| = sqrt(u.u + low_speed^2),
 *                        u = velocity of the point - wind.  Below low_speed, which is positive, it
 *                        is linear in u and so has all derivatives at rest, where sqrt(u.u) has none
 *
 *   MAGGI_FORCE_SPEED    controller of speed: on each of several joint coordinates the torque [N m]
 *                          gain torque e |e|,   e = speed function(t) - |v|,
 *                        |v| = sqrt(v.v + low_speed^2) of a point of a body; function is 1 if NULL
 *   MAGGI_FORCE_SPEED_LINEAR  the same with gain torque e
 *
 * The same load acts reversed on `reaction` when that names a body (NULL: the ground takes it).
 * Paths: forces.NAME.value.x .. (.value for a joint), forces.NAME.point.x ..; of a drag .density,
 * .coefficient, .area, .low_speed, .wind.x ..; of a controller .speed, .gain, .torque, .low_speed
 */
typedef enum maggi_force_type {
  MAGGI_FORCE_GLOBAL,
  MAGGI_FORCE_BODY,
  MAGGI_TORQUE_GLOBAL,
  MAGGI_TORQUE_BODY,
  MAGGI_FORCE_JOINT,
  MAGGI_FORCE_DRAG,
  MAGGI_FORCE_SPEED,
  MAGGI_FORCE_SPEED_LINEAR,
  MAGGI_FORCE_TYPE_COUNT
} maggi_force_type;

typedef struct maggi_force_def {
  const char *name;
  maggi_force_type type;
  const char *body;       /* not of MAGGI_FORCE_JOINT */
  const char *reaction;   /* or NULL */
  const char *coordinate; /* of MAGGI_FORCE_JOINT, named as in maggi_joint_spring_def */
  const char *function;   /* or NULL */
  double point[3];
  double value[3];
  double density, coefficient, area, low_speed; /* of MAGGI_FORCE_DRAG, kg/m^3, -, m^2, m/s */
  double wind[3];                               /* m/s */
  int ncoordinate;                              /* of MAGGI_FORCE_SPEED.., with low_speed: */
  const char *const *coordinates;               /* named as in maggi_joint_spring_def */
  double speed;                                 /* m/s; or */
  const char *driver;                           /* NULL, or the one whose speeds it keeps */
  double gain;                                  /* s^2/m^2, linear: s/m */
  double torque;                                /* N m, on a coordinate that shifts N */
} maggi_force_def;

/* A tyre: the numbers of PAC2002, of which many wheels may share one set.  Names are those of property
 * files (.tir) in small letters, so are the paths: tyres.NAME.pcx1.  Missing in a file are 0, scaling
 * factors (l..) 1; NAN says that a number has to be given.  Steady state needs no others.
 *
 *   low_camber   |gamma| has two derivatives in |gamma| < low_camber [rad], is 0 at 0 and exact beyond
 *   low_speed    rolling resistance changes its sign like tanh(Vx / low_speed)
 *   vxlow        below it slips are relative to (vxlow + Vx^2 / vxlow) / 2 instead of |Vx|
 *
 * name, key, unit, default, bound */
#define MAGGI_TYRE_LIST(X)                                                                         \
  X(FNOMIN, fnomin, "N", NAN, POSITIVE)                                                            \
  X(UNLOADED_RADIUS, unloaded_radius, "m", NAN, POSITIVE)                                          \
  X(VERTICAL_STIFFNESS, vertical_stiffness, "N/m", NAN, POSITIVE)                                  \
  X(VERTICAL_DAMPING, vertical_damping, "N s/m", 0.0, NOT_NEGATIVE)                                \
  X(BREFF, breff, "-", 0.0, NONE)                                                                  \
  X(DREFF, dreff, "-", 0.0, NONE)                                                                  \
  X(FREFF, freff, "-", 0.0, NONE)                                                                  \
  X(LONGVL, longvl, "m/s", 16.7, POSITIVE)                                                         \
  X(VXLOW, vxlow, "m/s", 1.0, POSITIVE)                                                            \
  X(LOW_CAMBER, low_camber, "rad", 1e-4, POSITIVE)                                                 \
  X(LOW_SPEED, low_speed, "m/s", 0.1, POSITIVE)                                                    \
  X(LFZO, lfzo, "-", 1.0, POSITIVE)                                                                \
  X(LCX, lcx, "-", 1.0, NONE)                                                                      \
  X(LMUX, lmux, "-", 1.0, POSITIVE)                                                                \
  X(LEX, lex, "-", 1.0, NONE)                                                                      \
  X(LKX, lkx, "-", 1.0, NONE)                                                                      \
  X(LHX, lhx, "-", 1.0, NONE)                                                                      \
  X(LVX, lvx, "-", 1.0, NONE)                                                                      \
  X(LGAX, lgax, "-", 1.0, NONE)                                                                    \
  X(LCY, lcy, "-", 1.0, NONE)                                                                      \
  X(LMUY, lmuy, "-", 1.0, POSITIVE)                                                                \
  X(LEY, ley, "-", 1.0, NONE)                                                                      \
  X(LKY, lky, "-", 1.0, NONE)                                                                      \
  X(LHY, lhy, "-", 1.0, NONE)                                                                      \
  X(LVY, lvy, "-", 1.0, NONE)                                                                      \
  X(LGAY, lgay, "-", 1.0, NONE)                                                                    \
  X(LTR, ltr, "-", 1.0, NONE)                                                                      \
  X(LRES, lres, "-", 1.0, NONE)                                                                    \
  X(LGAZ, lgaz, "-", 1.0, NONE)                                                                    \
  X(LXAL, lxal, "-", 1.0, NONE)                                                                    \
  X(LYKA, lyka, "-", 1.0, NONE)                                                                    \
  X(LVYKA, lvyka, "-", 1.0, NONE)                                                                  \
  X(LS, ls, "-", 1.0, NONE)                                                                        \
  X(LMX, lmx, "-", 1.0, NONE)                                                                      \
  X(LVMX, lvmx, "-", 1.0, NONE)                                                                    \
  X(LMY, lmy, "-", 1.0, NONE)                                                                      \
  X(PCX1, pcx1, "-", NAN, NONE)                                                                    \
  X(PDX1, pdx1, "-", NAN, NONE)                                                                    \
  X(PDX2, pdx2, "-", 0.0, NONE)                                                                    \
  X(PDX3, pdx3, "-", 0.0, NONE)                                                                    \
  X(PEX1, pex1, "-", 0.0, NONE)                                                                    \
  X(PEX2, pex2, "-", 0.0, NONE)                                                                    \
  X(PEX3, pex3, "-", 0.0, NONE)                                                                    \
  X(PEX4, pex4, "-", 0.0, NONE)                                                                    \
  X(PKX1, pkx1, "-", NAN, NONE)                                                                    \
  X(PKX2, pkx2, "-", 0.0, NONE)                                                                    \
  X(PKX3, pkx3, "-", 0.0, NONE)                                                                    \
  X(PHX1, phx1, "-", 0.0, NONE)                                                                    \
  X(PHX2, phx2, "-", 0.0, NONE)                                                                    \
  X(PVX1, pvx1, "-", 0.0, NONE)                                                                    \
  X(PVX2, pvx2, "-", 0.0, NONE)                                                                    \
  X(RBX1, rbx1, "-", 0.0, NONE)                                                                    \
  X(RBX2, rbx2, "-", 0.0, NONE)                                                                    \
  X(RCX1, rcx1, "-", 0.0, NONE)                                                                    \
  X(REX1, rex1, "-", 0.0, NONE)                                                                    \
  X(REX2, rex2, "-", 0.0, NONE)                                                                    \
  X(RHX1, rhx1, "-", 0.0, NONE)                                                                    \
  X(PCY1, pcy1, "-", NAN, NONE)                                                                    \
  X(PDY1, pdy1, "-", NAN, NONE)                                                                    \
  X(PDY2, pdy2, "-", 0.0, NONE)                                                                    \
  X(PDY3, pdy3, "-", 0.0, NONE)                                                                    \
  X(PEY1, pey1, "-", 0.0, NONE)                                                                    \
  X(PEY2, pey2, "-", 0.0, NONE)                                                                    \
  X(PEY3, pey3, "-", 0.0, NONE)                                                                    \
  X(PEY4, pey4, "-", 0.0, NONE)                                                                    \
  X(PKY1, pky1, "-", NAN, NONE)                                                                    \
  X(PKY2, pky2, "-", NAN, NONE)                                                                    \
  X(PKY3, pky3, "-", 0.0, NONE)                                                                    \
  X(PHY1, phy1, "-", 0.0, NONE)                                                                    \
  X(PHY2, phy2, "-", 0.0, NONE)                                                                    \
  X(PHY3, phy3, "-", 0.0, NONE)                                                                    \
  X(PVY1, pvy1, "-", 0.0, NONE)                                                                    \
  X(PVY2, pvy2, "-", 0.0, NONE)                                                                    \
  X(PVY3, pvy3, "-", 0.0, NONE)                                                                    \
  X(PVY4, pvy4, "-", 0.0, NONE)                                                                    \
  X(RBY1, rby1, "-", 0.0, NONE)                                                                    \
  X(RBY2, rby2, "-", 0.0, NONE)                                                                    \
  X(RBY3, rby3, "-", 0.0, NONE)                                                                    \
  X(RCY1, rcy1, "-", 0.0, NONE)                                                                    \
  X(REY1, rey1, "-", 0.0, NONE)                                                                    \
  X(REY2, rey2, "-", 0.0, NONE)                                                                    \
  X(RHY1, rhy1, "-", 0.0, NONE)                                                                    \
  X(RHY2, rhy2, "-", 0.0, NONE)                                                                    \
  X(RVY1, rvy1, "-", 0.0, NONE)                                                                    \
  X(RVY2, rvy2, "-", 0.0, NONE)                                                                    \
  X(RVY3, rvy3, "-", 0.0, NONE)                                                                    \
  X(RVY4, rvy4, "-", 0.0, NONE)                                                                    \
  X(RVY5, rvy5, "-", 0.0, NONE)                                                                    \
  X(RVY6, rvy6, "-", 0.0, NONE)                                                                    \
  X(QSX1, qsx1, "-", 0.0, NONE)                                                                    \
  X(QSX2, qsx2, "-", 0.0, NONE)                                                                    \
  X(QSX3, qsx3, "-", 0.0, NONE)                                                                    \
  X(QSY1, qsy1, "-", 0.0, NONE)                                                                    \
  X(QSY2, qsy2, "-", 0.0, NONE)                                                                    \
  X(QSY3, qsy3, "-", 0.0, NONE)                                                                    \
  X(QSY4, qsy4, "-", 0.0, NONE)                                                                    \
  X(QBZ1, qbz1, "-", 0.0, NONE)                                                                    \
  X(QBZ2, qbz2, "-", 0.0, NONE)                                                                    \
  X(QBZ3, qbz3, "-", 0.0, NONE)                                                                    \
  X(QBZ4, qbz4, "-", 0.0, NONE)                                                                    \
  X(QBZ5, qbz5, "-", 0.0, NONE)                                                                    \
  X(QBZ9, qbz9, "-", 0.0, NONE)                                                                    \
  X(QBZ10, qbz10, "-", 0.0, NONE)                                                                  \
  X(QCZ1, qcz1, "-", 0.0, NONE)                                                                    \
  X(QDZ1, qdz1, "-", 0.0, NONE)                                                                    \
  X(QDZ2, qdz2, "-", 0.0, NONE)                                                                    \
  X(QDZ3, qdz3, "-", 0.0, NONE)                                                                    \
  X(QDZ4, qdz4, "-", 0.0, NONE)                                                                    \
  X(QDZ6, qdz6, "-", 0.0, NONE)                                                                    \
  X(QDZ7, qdz7, "-", 0.0, NONE)                                                                    \
  X(QDZ8, qdz8, "-", 0.0, NONE)                                                                    \
  X(QDZ9, qdz9, "-", 0.0, NONE)                                                                    \
  X(QEZ1, qez1, "-", 0.0, NONE)                                                                    \
  X(QEZ2, qez2, "-", 0.0, NONE)                                                                    \
  X(QEZ3, qez3, "-", 0.0, NONE)                                                                    \
  X(QEZ4, qez4, "-", 0.0, NONE)                                                                    \
  X(QEZ5, qez5, "-", 0.0, NONE)                                                                    \
  X(QHZ1, qhz1, "-", 0.0, NONE)                                                                    \
  X(QHZ2, qhz2, "-", 0.0, NONE)                                                                    \
  X(QHZ3, qhz3, "-", 0.0, NONE)                                                                    \
  X(QHZ4, qhz4, "-", 0.0, NONE)                                                                    \
  X(SSZ1, ssz1, "-", 0.0, NONE)                                                                    \
  X(SSZ2, ssz2, "-", 0.0, NONE)                                                                    \
  X(SSZ3, ssz3, "-", 0.0, NONE)                                                                    \
  X(SSZ4, ssz4, "-", 0.0, NONE)

enum {
#define X(name, key, unit, value, bound) MAGGI_TYRE_##name,
  MAGGI_TYRE_LIST(X)
#undef X
      MAGGI_TYRE_NUMBERS
};

typedef enum maggi_side { MAGGI_LEFT, MAGGI_RIGHT } maggi_side;

typedef struct maggi_tyre_def {
  const char *name;
  maggi_side side; /* for which the numbers hold; wheels on the other side are mirrored */
  double value[MAGGI_TYRE_NUMBERS];
} maggi_tyre_def;

/* A road: its height is a function of x alone, from a point on.  z is up.
 * Paths: roads.NAME.point.x .., .slope; .amplitude, .wavelength; .radius, .height, .first, .spacing,
 * .fillet; .x.1, .x.2 .., .z.1 ..
 *
 *   flat     z = point.z + slope (x - point.x)
 *   sine     z = point.z + amplitude sin(2 pi (x - point.x) / wavelength)
 *   bumps    `number` cylinders across a level road, their tops at `height`, their axes at
 *            x - point.x = first, first + spacing ..; their edges are rounded with two continuous
 *            derivatives, over the length `fillet` of the road.  Wheels meet the cylinder straight
 *            below, and it pushes them up, not back: the normal is vertical
 *   profile  `number` points x, z from `point` joined by a natural C2 cubic spline, extended by
 *            straight lines
 */
typedef enum maggi_road_type {
  MAGGI_ROAD_FLAT,
  MAGGI_ROAD_SINE,
  MAGGI_ROAD_BUMPS,
  MAGGI_ROAD_PROFILE,
  MAGGI_ROAD_TYPE_COUNT
} maggi_road_type;

typedef struct maggi_road_def {
  const char *name;
  maggi_road_type type;
  double point[3];
  double slope;                                  /* of MAGGI_ROAD_FLAT */
  double amplitude, wavelength;                  /* of MAGGI_ROAD_SINE, m */
  double radius, height, first, spacing, fillet; /* of MAGGI_ROAD_BUMPS, m; fillet 0: sharp edges */
  int number;                                    /* of bumps, or of points */
  const double *x, *z;                           /* of MAGGI_ROAD_PROFILE, x rising, m */
} maggi_road_def;

/* A wheel with a tyre on a road: a rigid disc, contact where the steepest line from its centre down its
 * plane meets the plane that touches the road below, loaded radius r.  Magic Formula PAC2002, steady state,
 * lateral argument tan(alpha):
 *
 *   Fz = vertical_stiffness (R0 - r) + vertical_damping (R0 - r)', never negative
 *   kappa = -(Vx - Omega Re) / |Vx|,  tan(alpha) = Vy / |Vx|,  sin(gamma) = axis . normal
 *
 * Omega = w.u is the turn of the body about the axis u, which points to the left (+y of the vehicle) on all
 * wheels, V = v_C + (w - Omega u) x r e the velocity of the place on the road below it, which the turn of
 * neither body nor carrier about the axis moves.  TYDEX W axes, ISO:
 * x forward on the road, y left, z its normal.  Forces act on the body; the ground takes them.  All of
 * their power, of the vertical spring too, counts as work.
 * Paths: wheels.NAME.point.x .., .axis.x ..
 */
typedef struct maggi_wheel_def {
  const char *name;
  const char *body;
  const char *carrier;
  const char *tyre;
  const char *road;
  maggi_side side;
  double point[3]; /* centre */
  double axis[3];
} maggi_wheel_def;

/* A function of time, for motions and loads.
 *
 *   constant    value                                            parameters: value
 *   polynomial  sum_k c_k t^k                                    coefficients.0, .1, ..
 *   sine        offset + amplitude sin(omega t + phase)          amplitude, omega, phase, offset
 *   step        C2 quintic step from y0 at t0 to y1 at t1,
 *               constant outside                                 t0, t1, y0, y1
 *   knots       points joined by quintic steps, constant outside times.1, .2 .., values.1, ..
 *   spline      natural C2 cubic spline through the points,
 *               extended by straight lines                       times.1, .2 .., values.1, ..
 *   ramp        y0 up to t0, straight with slope `rate` from t1
 *               on; the slope is a quintic step between: C3      t0, t1, y0, rate
 *
 * number: entries of `values` (polynomial, knots, spline) and of `times` (knots, spline).
 * The scalar kinds take their parameters, in the order above, from `values`.
 * Paths: functions.NAME.amplitude ..
 */
typedef enum maggi_function_type {
  MAGGI_FUNCTION_CONSTANT,
  MAGGI_FUNCTION_POLYNOMIAL,
  MAGGI_FUNCTION_SINE,
  MAGGI_FUNCTION_STEP,
  MAGGI_FUNCTION_KNOTS,
  MAGGI_FUNCTION_SPLINE,
  MAGGI_FUNCTION_RAMP,
  MAGGI_FUNCTION_TYPE_COUNT
} maggi_function_type;

typedef struct maggi_function_def {
  const char *name;
  maggi_function_type type;
  int number;
  const double *times;
  const double *values;
} maggi_function_def;

/* A driver: a torque on the coordinate that steers, such that a point of a body follows a path.
 *
 *   P = r + preview v                 the point ahead, in the horizontal plane
 *   error e                           of P from the path, positive where the path is to its left
 *   demand = limit tanh((gain e + feedforward curvature) / limit)
 *   torque = stiffness (demand - delta) - damping delta'
 *
 * The path is a natural cubic spline through at least three points (x, y), counted from `origin`, its
 * parameter the length of the polyline up to a point; straight beyond its ends.  P is projected on it from
 * the nearest point of the polyline on: where a path crosses itself or comes near to itself, on the part
 * that is nearest; a path of several laps on any of them.  P must stay nearer than half the radius of curvature.
 * `speeds`, one for each point, or NULL: what a controller of speed that names the driver keeps.
 * Paths: drivers.NAME.preview, .gain, .feedforward, .limit, .stiffness, .damping, .point.x ..,
 * .origin.x .., .x.1 .., .y.1 .., .speeds.1 ..
 */
typedef struct maggi_driver_def {
  const char *name;
  const char *body;
  const char *coordinate; /* named as in maggi_joint_spring_def */
  double point[3];
  double origin[3];
  double preview;            /* s */
  double gain;               /* rad/m */
  double feedforward;        /* rad m */
  double limit;              /* rad, positive */
  double stiffness, damping; /* N m/rad, N m s/rad */
  int number;
  const double *x, *y, *speeds;
} maggi_driver_def;

/* A sensor writes three columns, a combination one:
 *
 *   position, velocity, acceleration  NAME.x NAME.y NAME.z of a body point [m, m/s, m/s^2], global axes
 *   angles                NAME.roll NAME.pitch NAME.yaw [rad] of R = Rz(yaw) Ry(pitch) Rx(roll), the
 *                         rotation of the body since the initial position
 *   angle_rates           NAME.roll_rate NAME.pitch_rate NAME.yaw_rate [rad/s], their rates; they grow
 *                         without bound where pitch is a right angle
 *   angular_velocity, angular_acceleration  NAME.x NAME.y NAME.z of the body [rad/s, rad/s^2], global
 *                         axes
 *   spring                NAME.length [m], NAME.rate [m/s], NAME.force [N] of a spring, tension
 *                         positive, its damper included
 *   joint_spring          NAME.value, NAME.rate, NAME.torque of a spring on coordinates [rad, rad/s,
 *                         N m; m, m/s, N]: torque or force on `coordinate`
 *   rod                   NAME.length [m], NAME.rate [m/s], NAME.force [N] of a rod: its multiplier,
 *                         tension positive
 *   tyre_slip             NAME.kappa [-], NAME.alpha [rad], NAME.gamma [rad] of a wheel
 *   tyre_force            NAME.fx NAME.fy NAME.fz [N], at the contact point in its axes
 *   tyre_moment           NAME.mx NAME.my NAME.mz [N m]
 *   tyre_contact          NAME.deflection, NAME.loaded_radius, NAME.rolling_radius [m]: R0 - r,
 *                         negative above the road; r; Re
 *   tyre_slope            NAME.dfy_dalpha, NAME.dfx_dkappa [N/rad, N] at this slip and load, negative and
 *                         positive while more slip still gives more force (PKY1 < 0);
 *                         NAME.utilisation [-]: sqrt((Fx / Dx)^2 + (Fy / Dy)^2), D the peaks of pure
 *                         slip at this load and camber.  All 0 in the air
 *   lateral_acceleration  of a body point with velocity v and acceleration a [m/s^2], [1] 3.19-3.21:
 *                         NAME.exact        |a - (a.v / v.v) v|, what is across the path in space
 *                         NAME.planar       (v_x a_y - v_y a_x) / |(v_x, v_y)|, positive to the left
 *                         NAME.approximate  |(a_x, a_y)|
 *   sideslip              of a body point: NAME.angle [rad] of its velocity in level axes, positive to
 *                         the left; NAME.speed [m/s], horizontal; NAME.curvature [1/m] of its path
 *                         seen from above, positive to the left
 *   level_velocity, level_acceleration  NAME.x NAME.y NAME.z of a body point [m/s, m/s^2] in level axes:
 *                         global axes turned by the yaw of the body alone, x its forward axis where that
 *                         is global x in the drawing (the intermediate axes of ISO 8855)
 *   body_acceleration     NAME.x NAME.y NAME.z of a body point [m/s^2] in axes of the body
 *   combination           NAME.value, the sum of weights times columns of sensors that stand before it
 *
 * Accelerations are those of the motion: nothing is added for gravity.  Level axes have no numbers where
 * pitch is a right angle.  At rest there is no path: with low = low_speed, v.v is v.v + low^2 where it
 * divides, so that the columns of lateral_acceleration are |a|, 0 and |(a_x, a_y)| there and those of
 * sideslip 0; |n|, an acceleration, is n.n / sqrt(n.n + low_acceleration^2).  So all have derivatives, and
 * are exact but for (low / what is measured)^2.
 *   speed_controller      NAME.error [m/s], NAME.torque [N m] on each coordinate, NAME.speed [m/s]
 *   driver                NAME.error [m] of the point ahead, positive to the right of the path,
 *                         NAME.distance [m] along the path, NAME.demand [rad]
 *
 * at_cog: the point is the centre of gravity of the body as its `cog` says, or the middle of its bar;
 * then `point` is no parameter.
 * Paths: sensors.NAME.point.x .., .low_speed, .low_acceleration, .weights.1 ..
 */
typedef enum maggi_sensor_type {
  MAGGI_SENSOR_POSITION,
  MAGGI_SENSOR_VELOCITY,
  MAGGI_SENSOR_ACCELERATION,
  MAGGI_SENSOR_ANGLES,
  MAGGI_SENSOR_ANGLE_RATES,
  MAGGI_SENSOR_ANGULAR_VELOCITY,
  MAGGI_SENSOR_ANGULAR_ACCELERATION,
  MAGGI_SENSOR_SPRING,
  MAGGI_SENSOR_JOINT_SPRING,
  MAGGI_SENSOR_ROD,
  MAGGI_SENSOR_TYRE_SLIP,
  MAGGI_SENSOR_TYRE_FORCE,
  MAGGI_SENSOR_TYRE_MOMENT,
  MAGGI_SENSOR_TYRE_CONTACT,
  MAGGI_SENSOR_TYRE_SLOPE,
  MAGGI_SENSOR_LATERAL_ACCELERATION,
  MAGGI_SENSOR_SIDESLIP,
  MAGGI_SENSOR_LEVEL_VELOCITY,
  MAGGI_SENSOR_LEVEL_ACCELERATION,
  MAGGI_SENSOR_BODY_ACCELERATION,
  MAGGI_SENSOR_COMBINATION,
  MAGGI_SENSOR_SPEED,
  MAGGI_SENSOR_DRIVER,
  MAGGI_SENSOR_TYPE_COUNT
} maggi_sensor_type;

typedef struct maggi_sensor_def {
  const char *name;
  maggi_sensor_type type;
  const char *body;                   /* not of springs, rods, wheels and combinations */
  double point[3];                    /* of what is said above to be of a point */
  int at_cog;                         /* true: instead of `point` */
  const char *element;                /* name of the spring, rod or wheel */
  double low_speed, low_acceleration; /* positive [m/s, m/s^2]; 1e-3 */
  int nterm;                          /* of a combination */
  const char *const *terms;           /* names of columns (nterm) */
  const double *weights;              /* (nterm); NULL: 1 */
  const char *unit;                   /* NULL: that of all terms, "-" where they differ */
} maggi_sensor_def;

/* A filter weights a column of a sensor by frequency, as people feel vibration: a system of first order
 * that is integrated with the motion from rest on, and differentiated with it.  It never acts on the
 * mechanism.  Its signal is NAME.weighted, in the unit of the column.  w_k = 2 pi f_k:
 *
 *   H(s) = gain  s^2 / (s^2 + sqrt(2) w_1 s + w_1^2)                  high pass
 *                w_2^2 / (s^2 + sqrt(2) w_2 s + w_2^2)                low pass
 *                w_4^2 (1 + s/w_3) / (s^2 + w_4/q4 s + w_4^2)         transition
 *                (s^2 + w_5/q5 s + w_5^2) / (s^2 + w_6/q6 s + w_6^2)  upward step
 *
 * f4 infinite: without transition, then f3 is infinite too; f3 infinite: its numerator is w_4^2; f5 and f6
 * infinite: without step.  Two states a section.  Steps must resolve f2: classical Runge-Kutta is stable
 * below h = 2.7 / w_2, 4 ms for 100 Hz.
 * Paths: filters.NAME.f1 .. .gain; what is infinite, and its q, is no parameter.
 */
typedef struct maggi_filter_def {
  const char *name;
  const char *signal;            /* column of a sensor, as "seat.z" */
  double f1, f2, f3, f4, f5, f6; /* [Hz] */
  double q4, q5, q6;             /* quality factors */
  double gain;
} maggi_filter_def;

/* Weightings of ISO 2631-1, ISO 2631-4 (Wb), BS 6841 (Wg), with the numbers of ISO 8041:
 *
 *   Wk  vertical, seat      Wd  horizontal, seat     Wf  motion sickness   Wc  horizontal, seat-back
 *   We  rotation            Wj  vertical, head       Wb  vertical, rail    Wg  vertical, manual control
 */
typedef enum maggi_weighting_type {
  MAGGI_WEIGHTING_WK,
  MAGGI_WEIGHTING_WD,
  MAGGI_WEIGHTING_WF,
  MAGGI_WEIGHTING_WC,
  MAGGI_WEIGHTING_WE,
  MAGGI_WEIGHTING_WJ,
  MAGGI_WEIGHTING_WB,
  MAGGI_WEIGHTING_WG,
  MAGGI_WEIGHTING_TYPE_COUNT
} maggi_weighting_type;

/* The numbers of a weighting, which must exist, into a definition. */
void maggi_filter_def_weighting(maggi_filter_def *def, maggi_weighting_type weighting);

/* What a model file proposes for a simulation; 0 means: no proposal. */
typedef struct maggi_simulation_def {
  double time; /* [s] */
  double step; /* [s] */
} maggi_simulation_def;

/* How a simulation starts, where not at the initial positions and velocities as they are given.
 *
 *   equilibrium  true: positions are those of static equilibrium.  All coordinates but those in `hold` and
 *                guided ones move until their accelerations vanish, with everything at rest, functions
 *                held at their values of t = 0, and of wheels the vertical springs alone.  Initial
 *                positions are where the search begins, those of coordinates in `hold` are honoured.
 *                Velocities are then as given: only the position is one of equilibrium
 *   hold         names of coordinates, or of bodies for all coordinates of their joints; a guided
 *                coordinate is held in any case                                       (nhold)
 *   rolling      true: every wheel starts with the spin at which it rolls freely, kappa = 0, whatever
 *                initial velocity its coordinate has.  Its body has to turn on the carrier by a
 *                revolute joint through its centre, with a coordinate that is neither guided nor part
 *                of a loop
 */
typedef struct maggi_start_def {
  int equilibrium;
  int nhold;
  const char *const *hold;
  int rolling;
} maggi_start_def;

/* Fill a definition with its defaults (zeros; ground; x axis, y axis of a wheel; scaling factors of a
 * tyre 1; of a filter no transition, no step, gain 1; NAN where documented). */
void maggi_body_def_init(maggi_body_def *def);
void maggi_point_mass_def_init(maggi_point_mass_def *def);
void maggi_loop_def_init(maggi_loop_def *def);
void maggi_rod_def_init(maggi_rod_def *def);
void maggi_spring_def_init(maggi_spring_def *def);
void maggi_joint_spring_def_init(maggi_joint_spring_def *def);
void maggi_force_def_init(maggi_force_def *def);
void maggi_tyre_def_init(maggi_tyre_def *def);
void maggi_road_def_init(maggi_road_def *def);
void maggi_wheel_def_init(maggi_wheel_def *def);
void maggi_driver_def_init(maggi_driver_def *def);
void maggi_function_def_init(maggi_function_def *def);
void maggi_sensor_def_init(maggi_sensor_def *def);
void maggi_start_def_init(maggi_start_def *def);
void maggi_filter_def_init(maggi_filter_def *def);

/* Number of coordinates of a joint, or -1 for a wrong type. */
int maggi_joint_dof(maggi_joint_type type);

/* Words of the model file for the enumerations ("revolute", ..), NULL outside the range; *_find is
 * the inverse and returns -1 for an unknown word. */
const char *maggi_joint_type_name(maggi_joint_type type);
const char *maggi_loop_type_name(maggi_loop_type type);
const char *maggi_force_type_name(maggi_force_type type);
const char *maggi_road_type_name(maggi_road_type type);
const char *maggi_function_type_name(maggi_function_type type);
const char *maggi_sensor_type_name(maggi_sensor_type type);
const char *maggi_weighting_type_name(maggi_weighting_type type);
int maggi_joint_type_find(const char *name);
int maggi_loop_type_find(const char *name);
int maggi_force_type_find(const char *name);
int maggi_road_type_find(const char *name);
int maggi_function_type_find(const char *name);
int maggi_sensor_type_find(const char *name);
int maggi_weighting_type_find(const char *name);

/* Build a model: create, add in any order (a parent may come after its child), then
 * maggi_model_create.
 *
 * in    def     copied, strings too
 * status        MAGGI_OK; MAGGI_E_MEMORY; MAGGI_E_MODEL for what is wrong in itself (no name, a name
 *               twice, longer than 100 characters or with others than letters, digits, _ and -, a
 *               number that is not finite, a negative mass, a zero axis, ..); what refers to other
 *               parts, and other bounds of parameters, are checked by maggi_model_create.  The text
 *               is in maggi_builder_message, until the next call.
 * memory        the builder owns its copies; maggi_builder_free(NULL) does nothing
 * threads       a builder belongs to one thread
 * since         0.1
 */
maggi_status maggi_builder_create(const char *name, maggi_builder **builder);
void maggi_builder_free(maggi_builder *builder);
const char *maggi_builder_message(const maggi_builder *builder);
maggi_status maggi_builder_gravity(maggi_builder *b,
                                   const double gravity[3]); /* default 0,0,-9.81 */
maggi_status maggi_builder_source(maggi_builder *b, const char *text);
maggi_status maggi_builder_simulation(maggi_builder *b, const maggi_simulation_def *def);
maggi_status maggi_builder_start(maggi_builder *b, const maggi_start_def *def);
maggi_status maggi_builder_body(maggi_builder *b, const maggi_body_def *def);
maggi_status maggi_builder_point_mass(maggi_builder *b, const maggi_point_mass_def *def);
maggi_status maggi_builder_loop(maggi_builder *b, const maggi_loop_def *def);
maggi_status maggi_builder_rod(maggi_builder *b, const maggi_rod_def *def);
maggi_status maggi_builder_spring(maggi_builder *b, const maggi_spring_def *def);
maggi_status maggi_builder_joint_spring(maggi_builder *b, const maggi_joint_spring_def *def);
maggi_status maggi_builder_force(maggi_builder *b, const maggi_force_def *def);
maggi_status maggi_builder_tyre(maggi_builder *b, const maggi_tyre_def *def);
maggi_status maggi_builder_road(maggi_builder *b, const maggi_road_def *def);
maggi_status maggi_builder_wheel(maggi_builder *b, const maggi_wheel_def *def);
maggi_status maggi_builder_driver(maggi_builder *b, const maggi_driver_def *def);
maggi_status maggi_builder_function(maggi_builder *b, const maggi_function_def *def);
maggi_status maggi_builder_sensor(maggi_builder *b, const maggi_sensor_def *def);
/* Another value for the numbers whose path is `name`, or which match it as a glob, whatever the definitions
 * above say; or for the design parameter of that name, after all paths.  Setting an initial position or
 * velocity prescribes it.  Each name once. */
maggi_status maggi_builder_set(maggi_builder *b, const char *name, double value);
maggi_status maggi_builder_filter(maggi_builder *b, const maggi_filter_def *def);

/* ----------------------------------------------------------------------------------- model */

/* Compile a builder into a model.
 *
 * out   model   immutable, shared by threads; free with maggi_model_free
 * status        MAGGI_OK; MAGGI_E_MEMORY; MAGGI_E_MODEL with a text in maggi_builder_message, which
 *               begins with the path of the culprit: `bodies.crank: parent "frame" does not exist`
 * memory        the builder may be freed or used further
 * since         0.1
 */
maggi_status maggi_model_create(maggi_builder *b, maggi_model **model);
void maggi_model_free(maggi_model *model);

/* Read a YAML model file (format: models/README.md).
 *
 * out   model     NULL on failure
 *       message   one line, `FILE:LINE: what is wrong`; without LINE when the file cannot be read
 *                                                                           (nmessage chars)
 * status          MAGGI_OK, MAGGI_E_MEMORY, MAGGI_E_FILE, MAGGI_E_MODEL
 * since           0.1; only in builds with MAGGI_WITH_YAML
 */
maggi_status maggi_model_load(const char *path, maggi_model **model, char *message,
                              size_t nmessage);

/* Read the property file (.tir) of a tyre, as model files name it.
 *
 * out   def       its numbers; name NULL
 *       message   one line, as of maggi_model_load                            (nmessage chars)
 * status          MAGGI_OK, MAGGI_E_MEMORY, MAGGI_E_FILE, MAGGI_E_MODEL
 * since           0.5; only in builds with MAGGI_WITH_YAML
 */
maggi_status maggi_tyre_load(const char *path, maggi_tyre_def *def, char *message, size_t nmessage);

/* The formula of a tyre by itself, as wheels use it.
 *
 * in    side    of the vehicle: mirrored when it is not def->side
 *       slip    kappa [-], alpha [rad], gamma [rad], Fz [N], Vx [m/s]
 * out   force   Fx, Fy, Fz [N], Mx, My, Mz [N m]; all 0 where Fz is not positive
 *       slope   dFy/dalpha [N/rad], dFx/dkappa [N], utilisation [-] as of a sensor tyre_slope, or NULL
 * since         0.5
 */
void maggi_tyre_forces(const maggi_tyre_def *def, maggi_side side, const double slip[5],
                       double force[6], double slope[3]);

/* The multiple four-bar mechanism of [1] 4.6.2, ny four-bars side by side in each of nz rows, with
 * z_1'(0) = pi/3 rad/s on the first vertical bar.  (2*ny + 1)*nz bars of 1 m and 1 kg in the yz
 * plane, as many coordinates, nz degrees of freedom.  Vertical bars v_R_C and horizontal ones h_R_C,
 * rows R and columns C from 1; v_R_C turns relative to the vertical above it, h_R_C to v_R_C.
 * Objectives: swing, load, energy, turn.
 *
 * in    ny, nz   at least 1
 * status         MAGGI_OK, MAGGI_E_VALUE, MAGGI_E_MEMORY
 * since          0.1
 */
maggi_status maggi_model_multiple_four_bar(int ny, int nz, maggi_model **model);

/* What a model is made of.  Counts:
 *   bodies           as in the file, without the ground and without the massless bodies of compounds
 *   coordinates      joint coordinates, guided ones included
 *   guided           of which follow a function of time
 *   loops            cut joints and rods
 *   loop_equations   their equations
 *   parameters       length of p
 *   sensor_columns   of all sensors
 *   filters, filter_states
 */
typedef struct maggi_model_info {
  const char *name;
  const char *source; /* "" if none */
  int bodies;
  int coordinates;
  int guided;
  int loops;
  int loop_equations;
  int parameters;
  int sensors;
  int sensor_columns;
  int filters;
  int filter_states;
  maggi_simulation_def simulation;
} maggi_model_info;

void maggi_model_get_info(const maggi_model *m, maggi_model_info *info);

/* Names, owned by the model; NULL outside the range.  Order as in the file (coordinates: bodies in
 * the order of the file, coordinates of a compound joint from parent to body; loops: cut joints,
 * then rods). */
const char *maggi_body_name(const maggi_model *m, int body);
const char *maggi_body_parent(const maggi_model *m, int body);
maggi_joint_type maggi_body_joint(const maggi_model *m, int body);
const char *maggi_coordinate_name(const maggi_model *m, int coordinate);
int maggi_coordinate_is_guided(const maggi_model *m, int coordinate);
int maggi_coordinate_is_angle(const maggi_model *m, int coordinate); /* else a length */
const char *maggi_loop_name(const maggi_model *m, int loop);
const char *maggi_loop_kind(const maggi_model *m, int loop); /* "revolute", .., "rod" */
int maggi_loop_rows(const maggi_model *m, int loop);
const char *maggi_spring_name(const maggi_model *m, int spring);
const char *maggi_wheel_name(const maggi_model *m, int wheel);
const char *maggi_sensor_column_name(const maggi_model *m, int column);
const char *maggi_sensor_column_unit(const maggi_model *m, int column);
const char *maggi_coordinate_motion(const maggi_model *m, int coordinate); /* function, or NULL */
const char *maggi_model_road(const maggi_model *m, int index, const char **type);
const char *maggi_model_function(const maggi_model *m, int index, const char **type);
const char *maggi_filter_column_name(const maggi_model *m, int filter); /* NAME.weighted */
const char *maggi_filter_column_unit(const maggi_model *m, int filter);
int maggi_body_find(const maggi_model *m, const char *name);       /* -1: none */
int maggi_coordinate_find(const maggi_model *m, const char *name); /* -1: none */

/* Sensors, wheels and forces as they were defined, in the order of the file, the sensor being that of a
 * column: strings are owned by the model, numbers of sensors and wheels are those of the file; forces
 * without numbers, none with arrays.  NULL outside the range.  since 0.5 */
const maggi_sensor_def *maggi_model_sensor(const maggi_model *m, int column);
const maggi_wheel_def *maggi_model_wheel(const maggi_model *m, int index);
const maggi_force_def *maggi_model_force(const maggi_model *m, int index);

/* Parameters: path, unit and default value of the entry `index` of p; path is NULL and value NAN
 * outside the range.  find returns -1 for an unknown path. */
const char *maggi_parameter_path(const maggi_model *m, int index);
const char *maggi_parameter_unit(const maggi_model *m, int index);
double maggi_parameter_default(const maggi_model *m, int index);
int maggi_parameter_find(const maggi_model *m, const char *path);

/* ------------------------------------------------------------------------------------ data */

/* Workspace of one simulation of a model.  The model must outlive it.
 *
 * status     MAGGI_OK, MAGGI_E_MEMORY
 * memory     all that a simulation needs is allocated here; free with maggi_data_free
 * threads    one thread per maggi_data
 * since      0.1
 */
maggi_status maggi_data_create(const maggi_model *m, maggi_data **data);
void maggi_data_free(maggi_data *d);

/* Text of the last failure of a call on d, one line, "" if none; owned by d. */
const char *maggi_data_message(const maggi_data *d);

/* Parameters of this simulation, defaults of the model at first.  Setting an initial position or
 * velocity prescribes it (MAGGI_INITIAL_GIVEN).
 *
 * status     MAGGI_OK; MAGGI_E_NAME for an index out of range; MAGGI_E_VALUE for a number that the
 *            model cannot have (not finite, negative mass, ..; the old value stays)
 * note       takes effect at the next maggi_data_reset
 */
maggi_status maggi_data_set_parameter(maggi_data *d, int index, double value);
double maggi_data_get_parameter(const maggi_data *d, int index);

/* Tolerance on the loop equations [m, rad]: positions are projected after a step that leaves them
 * further open; default 1e-10.  status MAGGI_OK, MAGGI_E_VALUE. */
maggi_status maggi_data_set_tolerance(maggi_data *d, double tolerance);

/* Start a simulation at t = 0: constants from p, assembly of the loops (Newton), choice of the
 * independent coordinates, completion of the velocities, one evaluation.  Filters start at rest.
 *
 * Given positions and velocities are honoured exactly; independent coordinates that are not given
 * start at their file position and at rest.  Where the model asks for it (maggi_start_def) positions are
 * those of static equilibrium, found by Newton's method with the exact Jacobian, and wheels roll.
 *
 * status     MAGGI_OK; MAGGI_E_VALUE (a zero axis, ..); MAGGI_E_ASSEMBLY, also where no equilibrium is
 *            found; MAGGI_E_MASS; MAGGI_E_NOT_FINITE; text in maggi_data_message
 * since      0.1
 */
maggi_status maggi_data_reset(maggi_data *d);

/* Static equilibrium, from which a reset starts where the model asks for it (maggi_start_def): after a
 * reset, of the parameters then.
 *
 *   coordinates   independent ones: not held, not guided, not made dependent by loops
 *   iterations    of Newton's method
 *   damped        steps of the damped run that led there, 0: it was not needed
 *   residual      largest acceleration that is left [m/s^2, rad/s^2]
 *
 * springs           length [m] and force [N] of springs, tension positive, in their order
 * wheels            force that the road exerts on wheels along its normal [N]
 * status            MAGGI_OK; MAGGI_E_MODEL where no reset has found an equilibrium
 * since             0.5
 */
typedef struct maggi_equilibrium_state {
  int coordinates;
  int iterations;
  int damped;
  double residual;
} maggi_equilibrium_state;
maggi_status maggi_get_equilibrium(const maggi_data *d, maggi_equilibrium_state *state);
maggi_status maggi_equilibrium_get_springs(const maggi_data *d, double *length, double *force);
maggi_status maggi_equilibrium_get_wheels(const maggi_data *d, double *load);

/* Small motions about static equilibrium, of what its search moves (n coordinates, see above):
 *
 *   y'' = a_q y + a_v y',   positions of all coordinates = those of equilibrium + shape y,
 *   kinetic energy y'^T mass y' / 2
 *
 * in    rate   of coordinates [m/s, rad/s], small: a_v is the mean of the derivatives at velocities of
 *              about +rate and -rate, so that a damper with other slopes in rebound than in compression
 *              counts with their mean
 * out   coordinate   which they are                (n)
 *       a_q, a_v     in m, rad and s               (n x n)
 *       mass         in kg, m, rad                 (n x n)
 *       shape                                      (coordinates x n)       NULL: not wanted
 *
 * status     MAGGI_OK; MAGGI_E_MODEL where no reset has found an equilibrium; MAGGI_E_MEMORY
 * since      0.5
 */
maggi_status maggi_equilibrium_motions(maggi_data *d, double rate, int *coordinate, double *a_q,
                                       double *a_v, double *mass, double *shape);

/* Put the simulation at a given time and state: loops are closed by moving the dependent
 * coordinates, dependent velocities follow from the independent ones.  Filters are at rest.  Replaces a
 * reset.
 *
 * in    q, v   coordinates and velocities                              (coordinates)
 * status       as maggi_data_reset
 */
maggi_status maggi_data_set_state(maggi_data *d, double t, const double *q, const double *v);

/* One step of the classical Runge-Kutta method of order 4 of size h > 0 (h < 0 integrates back),
 * drift control and, when the independent coordinates have become bad ones, a new choice of them.
 * Four evaluations, more where a loop passes a singular position.  After it the accelerations of the
 * new state are at hand.  [1] 2.62-2.66
 *
 * status     MAGGI_OK; MAGGI_E_LOCKUP naming time and loop; MAGGI_E_MASS; MAGGI_E_NOT_FINITE
 *            (step too large); MAGGI_E_VALUE for h = 0 or not finite; MAGGI_E_MODEL before a reset
 * memory     none allocated
 * since      0.1
 */
maggi_status maggi_step(maggi_data *d, double h);

/* State of the simulation. */
double maggi_get_time(const maggi_data *d);
/* q, v, a: positions, velocities, accelerations (coordinates each); any may be NULL. */
void maggi_get_coordinates(const maggi_data *d, double *q, double *v, double *a);
/* Columns of all sensors (sensor_columns). */
void maggi_get_sensors(maggi_data *d, double *values);
/* What all filters say (filters). */
void maggi_get_filters(maggi_data *d, double *values);
/* Torque or force of each joint coordinate's guide (coordinates): what drives a guided coordinate,
 * 0 for the others. */
void maggi_get_drives(maggi_data *d, double *drives);

/* Wrench that the parent exerts on each body through its joint: force [N] and moment [N m] at the
 * joint point, global axes (bodies x 6).  Springs, drives and loads on the joint itself are part of
 * it.  Where loops have redundant equations, the share of smallest norm among loops that are solved
 * together.  [1] 2.69-2.85 */
void maggi_get_reactions(maggi_data *d, double *wrenches);
/* Multipliers of the loop equations (loop_equations), loops in order; a rod's is its axial force,
 * tension positive. */
void maggi_get_multipliers(maggi_data *d, double *lambda);

/* Energies [J]: kinetic; potential of weights (zero at the global origin) and springs; and work
 * since the start of dampers, loads and drives. */
typedef struct maggi_energy {
  double kinetic;
  double potential;
  double work;
} maggi_energy;
void maggi_get_energy(maggi_data *d, maggi_energy *energy);

/* How well the loops stand; a cheap read, after a successful reset.
 *   dof             degrees of freedom: coordinates - guided - rank
 *   rank            of the loop equations on the coordinates that are not guided
 *   violation       largest |Phi| now [m, rad]; 0 without loops
 *   pivot_ratio     singularity indicator: smallest pivot of the loops now over its size in the
 *                   position where the independent coordinates were chosen; 1 there and without
 *                   loops, near 0 at a singular position
 *   changes         times the independent coordinates were changed
 *   projections     Newton iterations of drift control
 *   evaluations     of the right-hand side
 */
typedef struct maggi_loop_state {
  int dof;
  int rank;
  double violation;
  double pivot_ratio;
  long changes;
  long projections;
  long evaluations;
} maggi_loop_state;
void maggi_get_loop_state(const maggi_data *d, maggi_loop_state *state);

/* Whether coordinate is independent at present. */
int maggi_coordinate_is_independent(const maggi_data *d, int coordinate);

/* ------------------------------------------------------------------------------ derivatives */

/* Exact derivatives of the equations of motion at one state: of all velocities v and accelerations a
 *
 *   (v, a) = f(q, v_i, p)        q   positions of all coordinates
 *                                v_i velocities of the independent ones
 *                                p   parameters
 *
 * f is what one evaluation computes: dependent velocities and accelerations solve the loop equations
 * at the position q, whether it closes them or not, so that f is a function of each entry of q by
 * itself.  Which coordinates are independent is held.  Positions and velocities of guided coordinates
 * are functions of time and p: as directions they are ignored, as gradients they are 0; so are
 * velocities of dependent coordinates.  f does not depend on parameters that are initial positions and
 * velocities.
 *
 * Derivation: core/sensitivity/derivative.h; [1] chapter 5.
 */
typedef struct maggi_derivative maggi_derivative;

/* Workspace of derivatives of one simulation.
 *
 * in    d           outlives it
 *       ndirection  directions of maggi_motion_jac whose parameters it treats together, at least 0
 * status            MAGGI_OK, MAGGI_E_MEMORY
 * memory            all of it here when d has been reset before, else by the first maggi_linearise; more
 *                   only when a new choice of independent coordinates needs it.
 *                   maggi_derivative_free(NULL) does nothing
 * threads           one thread for d and all its derivatives
 * since             0.2
 */
maggi_status maggi_derivative_create(maggi_data *d, int ndirection, maggi_derivative **derivative);
void maggi_derivative_free(maggi_derivative *D);

/* What the derivatives at the present state of the simulation share; before the functions below, after
 * each maggi_data_reset, maggi_data_set_state and maggi_step, with no parameter set in between.  Near a
 * singular position of a loop, where a step ends between two evaluations, it evaluates the state.
 *
 * status    MAGGI_OK; MAGGI_E_MODEL before a reset; MAGGI_E_NOT_FINITE at a singular position;
 *           MAGGI_E_MEMORY; text in maggi_data_message
 * since     0.2
 */
maggi_status maggi_linearise(maggi_derivative *D);

/* Derivative of f along one direction.
 *
 * in    q, v     direction of positions and velocities        (coordinates)  NULL: zero
 *       p        direction of parameters                      (parameters)   NULL: zero
 * out   v_out    derivative of velocities                     (coordinates)  NULL: not wanted
 *       a_out    derivative of accelerations                  (coordinates)  NULL: not wanted
 *
 * memory         none allocated; outputs may be the inputs
 * threads        one thread for d and all its derivatives
 * since          0.2
 */
void maggi_motion_jvp(maggi_derivative *D, const double *q, const double *v, const double *p,
                      double *v_out, double *a_out);

/* Derivatives of f along n directions, several at a time for little more than the price of one.
 *
 * in    n        number of directions, of any size
 *       q, v     directions, row by row with the direction last    (coordinates x n)  NULL: zero
 *       p        the same of parameters                            (parameters x n)   NULL: zero
 * out   v_out    derivatives of velocities                         (coordinates x n)  NULL: not wanted
 *       a_out    derivatives of accelerations                      (coordinates x n)  NULL: not wanted
 *
 * memory         none allocated; outputs must not be the inputs
 * threads        one thread for d and all its derivatives
 * since          0.2
 */
void maggi_motion_jac(maggi_derivative *D, int n, const double *q, const double *v, const double *p,
                      double *v_out, double *a_out);

/* Gradient of the scalar v_bar.v + a_bar.a with respect to everything.
 *
 * in    v_bar    weights of velocities                              (coordinates)  NULL: zero
 *       a_bar    weights of accelerations                           (coordinates)  NULL: zero
 * out   q_out    gradient with respect to positions                 (coordinates)  NULL: not wanted
 *       v_out    with respect to independent velocities             (coordinates)  NULL: not wanted
 *       p_out    with respect to parameters                         (parameters)   NULL: not wanted
 *
 * memory         none allocated; outputs may be the inputs
 * threads        one thread for d and all its derivatives
 * since          0.2
 */
void maggi_motion_vjp(maggi_derivative *D, const double *v_bar, const double *a_bar, double *q_out,
                      double *v_out, double *p_out);

/* Second derivative of the scalar v_bar.v + a_bar.a times one direction: the change along it of the
 * gradient that maggi_motion_vjp computes.
 *
 * in    v_bar    weights of velocities                              (coordinates)  NULL: zero
 *       a_bar    weights of accelerations                           (coordinates)  NULL: zero
 *       q, v     direction of positions and velocities              (coordinates)  NULL: zero
 *       p        direction of parameters                            (parameters)   NULL: zero
 * out   q_out    change of the gradient by positions                (coordinates)  NULL: not wanted
 *       v_out    of that by independent velocities                  (coordinates)  NULL: not wanted
 *       p_out    of that by parameters                              (parameters)   NULL: not wanted
 *
 * memory         none allocated; outputs may be the inputs
 * threads        one thread for d and all its derivatives
 * since          0.2
 */
void maggi_motion_hvp(maggi_derivative *D, const double *v_bar, const double *a_bar,
                      const double *q, const double *v, const double *p, double *q_out,
                      double *v_out, double *p_out);

/* -------------------------------------------------------------- signals, objectives, design */

/* A signal is a scalar over time: each column of maggi simulate but t, energy.work and loops.*, by the
 * name it has there: NAME.q NAME.v NAME.a of a coordinate, energy.kinetic energy.potential
 * energy.total, BODY.fx .. BODY.mz of a reaction, the columns of the sensors, NAME.weighted of filters.
 * Numbered from 0 in this order.  A name that several have means the first. */
int maggi_signal_number(const maggi_model *m);
const char *maggi_signal_name(const maggi_model *m, int signal); /* NULL outside the range */
const char *maggi_signal_unit(const maggi_model *m, int signal);
int maggi_signal_find(const maggi_model *m, const char *name); /* -1: none */
/* Present values of n signals of a simulation. */
void maggi_get_signals(maggi_data *d, int n, const int *signal, double *values);

/* Points of time of a simulation of `time` seconds in steps of `step`: 0, step, 2 step, .. and `time`
 * itself, so that the last step may be shorter.  What is a multiple but for rounding counts as one.
 * init: status MAGGI_OK; MAGGI_E_VALUE when a number is not positive or not finite, or for more than
 * 1e9 steps. */
typedef struct maggi_grid {
  double time, step; /* [s] */
  long steps;
  int is_multiple;
} maggi_grid;

maggi_status maggi_grid_init(maggi_grid *grid, double time, double step);
double maggi_grid_time(const maggi_grid *grid, long k); /* after k steps */

/* A scalar function of the signals of a whole simulation, on the points of time of its grid.  With
 * s(t) = signal - target, T the length of the simulation:
 *
 *   integral         int s dt                          value         sum of s at given times
 *   integral_square  int s^2 dt                        terminal      s(T)
 *   mean             int s dt / T                      maximum       largest s
 *   mean_square      int s^2 dt / T                    minimum       smallest s
 *   rms              sqrt(int s^2 dt / T)              peak          largest |s|
 *   rmq              (int s^4 dt / T)^(1/4)            smooth_maximum
 *   vdv              (int s^4 dt)^(1/4)                  log(int exp(sharpness s) dt / T) / sharpness
 *   least_squares    sum (s - value)^2 / number over points (time, value) of a record
 *   sum              sum of weights times other objectives
 *   norm             sqrt(int s^2 dt)
 *   violation        int max(0, s)^2 dt: 0 where the signal stays below the target
 *   slope            that of the straight line which fits the signal over another one, r, best:
 *                      (T int r s dt - int r dt int s dt) / (T int r^2 dt - (int r dt)^2)
 *
 * With a window, integrals and extrema are those between its ends, T is its length, and terminal is s
 * there.  With a reference, s = signal - its value at an end of the window - target; that value moves
 * with the motion, and the derivative knows it.
 *
 * Integrals are those of the piecewise polynomial of degree 5 through the samples; between samples
 * (maximum, value, least_squares) s is that polynomial too.  The sample before a last step shorter than
 * 0.28 of the others is left out of it. */
typedef enum maggi_objective_type {
  MAGGI_OBJECTIVE_INTEGRAL,
  MAGGI_OBJECTIVE_INTEGRAL_SQUARE,
  MAGGI_OBJECTIVE_MEAN,
  MAGGI_OBJECTIVE_MEAN_SQUARE,
  MAGGI_OBJECTIVE_RMS,
  MAGGI_OBJECTIVE_RMQ,
  MAGGI_OBJECTIVE_VDV,
  MAGGI_OBJECTIVE_MAXIMUM,
  MAGGI_OBJECTIVE_MINIMUM,
  MAGGI_OBJECTIVE_PEAK,
  MAGGI_OBJECTIVE_SMOOTH_MAXIMUM,
  MAGGI_OBJECTIVE_VALUE,
  MAGGI_OBJECTIVE_TERMINAL,
  MAGGI_OBJECTIVE_LEAST_SQUARES,
  MAGGI_OBJECTIVE_SUM,
  MAGGI_OBJECTIVE_NORM,
  MAGGI_OBJECTIVE_VIOLATION,
  MAGGI_OBJECTIVE_SLOPE,
  MAGGI_OBJECTIVE_TYPE_COUNT
} maggi_objective_type;

/* What is subtracted from a signal besides the target: nothing, its value at the begin of the window or
 * at the end. */
typedef enum maggi_reference_type {
  MAGGI_REFERENCE_NONE,
  MAGGI_REFERENCE_INITIAL,
  MAGGI_REFERENCE_FINAL,
  MAGGI_REFERENCE_TYPE_COUNT
} maggi_reference_type;

/* A scalar made of several signals: returns g(t, signals) and fills its gradient, n numbers. */
typedef double (*maggi_signal_function)(void *context, double t, int n, const double *signals,
                                        double *gradient);

/* Definition of an objective.  Strings and arrays are copied, `context` must stay.
 *
 *   signal     name, or, when `function` is there, NULL and nsignal names in `signals`
 *   target     subtracted; default 0
 *   reference  of integral, integral_square, mean, mean_square, rms, rmq, vdv and norm
 *   from, to   window [s], NAN: begin and end of the simulation, which are the defaults.  Not of value,
 *              least_squares and sum; of terminal, `to` alone
 *   against    of slope: name of the other signal
 *   sharpness  of smooth_maximum, positive, in one over the unit of the signal
 *   times      of value and least_squares, in rising order          (number)
 *   values     of least_squares                                     (number)
 *   terms, weights  of sum: names of objectives declared in the model, not sums   (nterm);
 *              weights NULL: 1
 */
typedef struct maggi_objective_def {
  const char *name;
  maggi_objective_type type;
  const char *signal;
  int nsignal;
  const char *const *signals;
  maggi_signal_function function;
  void *context;
  double target;
  double sharpness;
  maggi_reference_type reference;
  double from, to;
  const char *against;
  int number;
  const double *times;
  const double *values;
  int nterm;
  const char *const *terms;
  const double *weights;
} maggi_objective_def;

/* A design parameter b: a name for one or several entries of p that it moves together,
 *
 *   p_j = p_j0 + factor_j (b - nominal)
 *
 *   paths    of entries, or globs (* ? [a-z]) that stand for all entries they match   (number)
 *   factors  one for each path; NULL: 1                                               (number)
 *   nominal  value of b at p_0; NAN: that of the first entry over its factor
 *   lower, upper  bounds of b, for optimisers; -INFINITY, INFINITY: none
 *   unit     NULL: that of the first entry
 */
typedef struct maggi_design_def {
  const char *name;
  const char *unit;
  int number;
  const char *const *paths;
  const double *factors;
  double nominal, lower, upper;
} maggi_design_def;

void maggi_objective_def_init(maggi_objective_def *def);
void maggi_design_def_init(maggi_design_def *def);
const char *maggi_objective_type_name(maggi_objective_type type); /* "integral", .. */
int maggi_objective_type_find(const char *name);
const char *maggi_reference_type_name(maggi_reference_type type); /* "none", "initial", "final" */
int maggi_reference_type_find(const char *name);

/* Declare them in a model; as the other maggi_builder_.. */
maggi_status maggi_builder_objective(maggi_builder *b, const maggi_objective_def *def);
maggi_status maggi_builder_design(maggi_builder *b, const maggi_design_def *def);

/* Names of those declared in a model, owned by it, NULL outside the range. */
const char *maggi_model_objective(const maggi_model *m, int index);
const maggi_objective_def *maggi_model_objective_def(const maggi_model *m, int index);
const char *maggi_model_design(const maggi_model *m, int index);

/* An objective to be evaluated: of a definition; or by name, one declared in the model or
 * `TYPE(SIGNAL)`, as in "rms(tip.z)", for types that need no more.
 *
 * out   objective  NULL on failure
 *       message    what is wrong, one line                              (nmessage chars)
 * status           MAGGI_OK; MAGGI_E_MEMORY; MAGGI_E_NAME; MAGGI_E_VALUE
 * memory           its own; free with maggi_objective_free, before the model
 * threads          one thread at a time
 * since            0.3
 */
typedef struct maggi_objective maggi_objective;
maggi_status maggi_objective_create(const maggi_model *m, const maggi_objective_def *def,
                                    maggi_objective **objective, char *message, size_t nmessage);
maggi_status maggi_objective_named(const maggi_model *m, const char *name,
                                   maggi_objective **objective, char *message, size_t nmessage);
void maggi_objective_free(maggi_objective *objective);
const char *maggi_objective_name(const maggi_objective *objective);
const char *maggi_objective_unit(const maggi_objective *objective); /* "m^2 s", "(rad/s)^2", .. */
/* The signals it reads, each once: their number; *signal is owned by the objective. */
int maggi_objective_signals(const maggi_objective *objective, const int **signal);

/* The design parameters of a study, in the order in which they were added.  p_0 are the parameters of d
 * when it is created.
 *
 * add      of a definition
 * select   all that a pattern means: "all" every entry of p by its path; else the declared design
 *          parameters whose name matches the glob; else the entries of p whose path does
 * set      p of d for values b of the design parameters (number); what several do to one entry adds
 *          up.  As maggi_data_set_parameter, but does not prescribe initial positions and velocities;
 *          on failure these entries are those of p_0
 * status   MAGGI_OK; MAGGI_E_MEMORY; MAGGI_E_NAME for a name that is nowhere or there already;
 *          MAGGI_E_VALUE; text in message
 * threads  as memory: shared after it has been filled
 * since    0.3
 */
typedef struct maggi_design maggi_design;
maggi_status maggi_design_create(const maggi_data *d, maggi_design **design);
void maggi_design_free(maggi_design *design);
maggi_status maggi_design_add(maggi_design *design, const maggi_design_def *def, char *message,
                              size_t nmessage);
maggi_status maggi_design_select(maggi_design *design, const char *pattern, char *message,
                                 size_t nmessage);
maggi_status maggi_design_set(const maggi_design *design, maggi_data *d, const double *b);
int maggi_design_number(const maggi_design *design);
const char *maggi_design_name(const maggi_design *design, int index);
const char *maggi_design_unit(const maggi_design *design, int index);
double maggi_design_value(const maggi_design *design, int index); /* nominal */
double maggi_design_lower(const maggi_design *design, int index);
double maggi_design_upper(const maggi_design *design, int index);

/* ---------------------------------------------------------------- penalty formulation, implicit */

/* Ways to the Jacobian J = [dQ/dz dQ/dz'] of the forces, [1] chapter 4: centred differences or
 * tangents, column by column or by colours (columns without a common row together), or row by row by
 * adjoints. */
typedef enum maggi_jacobian {
  MAGGI_JACOBIAN_DIFFERENCE,
  MAGGI_JACOBIAN_DIFFERENCE_COLOURED,
  MAGGI_JACOBIAN_TANGENT,
  MAGGI_JACOBIAN_TANGENT_COLOURED,
  MAGGI_JACOBIAN_ADJOINT,
  MAGGI_JACOBIAN_COUNT
} maggi_jacobian;
const char *maggi_jacobian_name(maggi_jacobian way); /* "tangent-coloured", ..; NULL: none */
int maggi_jacobian_find(const char *name);           /* -1: none */

/*   penalty     alpha: force on a loop that is open by 1 [N/m, N m]; default 1e8
 *   tolerance   Newton's method ends when no coordinate moves by more [rad, m]; default 1e-8
 *   jacobian    default tangent-coloured
 *   reuse       iterations with the same Jacobian; default 3
 *   iterations  at most; default 30 */
typedef struct maggi_penalty_options {
  double penalty, tolerance;
  maggi_jacobian jacobian;
  int reuse, iterations;
} maggi_penalty_options;
void maggi_penalty_options_init(maggi_penalty_options *options);

/* steps, Newton iterations and Jacobians since the reset; nonzeros of J and colours of its columns
 * (columns, where the way does not use colours) */
typedef struct maggi_penalty_state {
  long steps, iterations, jacobians;
  int nonzeros, colours;
} maggi_penalty_state;

/* The simulation d by the semi-recursive penalty formulation and the trapezoidal rule, of order 2 and
 * implicit, [1] 4.2: all coordinates are integrated, springs of stiffness `penalty` hold the loops
 * together, velocities and accelerations are projected onto what the loops allow.  reset and step
 * stand in for maggi_data_reset and maggi_step; all that one can ask of d is that of the present state.
 *
 * status     of create MAGGI_OK, MAGGI_E_MEMORY, MAGGI_E_VALUE; of reset as maggi_data_reset; of step
 *            MAGGI_OK, MAGGI_E_NOT_FINITE when Newton's method does not converge, MAGGI_E_MASS,
 *            MAGGI_E_VALUE, MAGGI_E_MODEL; text in maggi_data_message
 * memory     all of it in create, reset and the first step; more only where factors of large matrices
 *            need other pivots.  free(NULL) does nothing
 * threads    one thread for d and what hangs on it
 * since      0.4
 */
typedef struct maggi_penalty maggi_penalty;
maggi_status maggi_penalty_create(maggi_data *d, const maggi_penalty_options *options,
                                  maggi_penalty **penalty);
void maggi_penalty_free(maggi_penalty *s);
maggi_status maggi_penalty_reset(maggi_penalty *s);
maggi_status maggi_penalty_step(maggi_penalty *s, double h);
void maggi_penalty_get_state(const maggi_penalty *s, maggi_penalty_state *state);

/* -------------------------------------------------------------- sensitivities of a simulation */

/* State sensitivities: derivatives with respect to the design parameters, carried along with the
 * simulation (direct differentiation, [1] 5.3).  Exact derivatives of what maggi_data_reset and
 * maggi_step compute: the initial state follows its assembly, drift control and changes of the
 * independent coordinates are differentiated; the sequence of steps and choices is held.
 *
 *   create   for the design parameters there are (n), which must stay
 *   reset    maggi_data_reset with derivatives of the initial state
 *   step     maggi_step with derivatives.  Steps of d without it end the sensitivities: reset again
 *   get      derivatives of the present state, parameter last; NULL: not wanted
 *            q, v, a (coordinates x n); signals (nsignal x n)
 *
 * status   as maggi_data_reset, maggi_step; MAGGI_E_MEMORY; text in maggi_data_message
 * memory   all of it in create and the first reset, but for changes of independent coordinates
 * threads  one thread for d and what hangs on it
 * since    0.3
 */
typedef struct maggi_direct maggi_direct;
maggi_status maggi_direct_create(maggi_data *d, const maggi_design *design, maggi_direct **direct);
void maggi_direct_free(maggi_direct *s);
maggi_status maggi_direct_reset(maggi_direct *s);
maggi_status maggi_direct_step(maggi_direct *s, double h);
void maggi_direct_get_coordinates(const maggi_direct *s, double *q, double *v, double *a);
void maggi_direct_get_signals(maggi_direct *s, int nsignal, const int *signal, double *values);

/* How a gradient is computed.
 *
 *   direct              state sensitivities; cost grows with the number of design parameters
 *   adjoint             of the discrete simulation, backwards through its Runge-Kutta steps: the same
 *                       numbers as direct; cost hardly depends on the number of design parameters
 *   continuous_adjoint  adjoint equations of the continuous motion, integrated backwards ([1] 5.4):
 *                       differs from the others by the truncation error of both integrations
 *   difference          centred differences of whole simulations; forward_, backward_difference
 */
typedef enum maggi_method {
  MAGGI_METHOD_DIRECT,
  MAGGI_METHOD_ADJOINT,
  MAGGI_METHOD_CONTINUOUS_ADJOINT,
  MAGGI_METHOD_DIFFERENCE,
  MAGGI_METHOD_FORWARD_DIFFERENCE,
  MAGGI_METHOD_BACKWARD_DIFFERENCE,
  MAGGI_METHOD_COUNT
} maggi_method;
const char *maggi_method_name(maggi_method method);
int maggi_method_find(const char *name);

/* in    time, step    of the simulation [s]
 *       penalty       options of the penalty formulation, NULL: maggi_step.  Newton's method then goes to a
 *                     tolerance of 1e-12 at most; the adjoint method keeps all states
 *       perturbation  of differences, relative to the value of a design parameter, absolute where that
 *                     is 0; default 1e-6
 *       snapshots     adjoint: states kept at a time, others are computed again from them by the
 *                     schedule with the fewest steps; 0: all of them if `memory` suffices
 *       memory        bytes for states of the simulation; default 1 GiB
 *       progress      called now and then with the part that is done; NULL: none.  True stops
 * out   relevance     direct: largest |q_b| over time of each parameter ([1] 5.45), and the coordinate;
 *       coordinate    NULL: not wanted                                  (design parameters)
 *       steps         of one simulation
 *       recomputed    adjoint: steps computed again, besides the one that precedes its reversal
 *       kept          adjoint: snapshots at most
 */
typedef struct maggi_gradient_options {
  double time, step;
  maggi_method method;
  const maggi_penalty_options *penalty;
  double perturbation;
  int snapshots;
  size_t memory;
  int (*progress)(void *context, double part);
  void *context;
  double *relevance;
  int *coordinate;
  long steps, recomputed, kept;
} maggi_gradient_options;
void maggi_gradient_options_init(maggi_gradient_options *options);

/* Objectives of a simulation from maggi_data_reset on, and their gradients.
 *
 * in    d          parameters and tolerance as they are
 *       objective                                                     (nobjective)
 * out   value      of the objectives                                  (nobjective)
 *       gradient   NULL: values alone          (nobjective x design parameters)
 *
 * status     as maggi_data_reset, maggi_step; MAGGI_E_MEMORY; MAGGI_E_VALUE naming an objective
 *            without a value (a time that the simulation does not reach) or without derivative (the
 *            root of zero); MAGGI_E_STOPPED; text in maggi_data_message
 * memory     allocated and freed within
 * threads    one thread for d; several d may share the design, not the objectives
 * since      0.3
 */
maggi_status maggi_gradient(maggi_data *d, const maggi_design *design, int nobjective,
                            maggi_objective *const *objective, maggi_gradient_options *options,
                            double *value, double *gradient);

#ifdef __cplusplus
}
#endif

#endif
