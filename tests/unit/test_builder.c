/* core/model/builder.c, compile*.c: what is refused, with which message; what may come in any
 * order. */
#include "fixture.h"

/* a definition that is right, then one change, then the message */
#define REFUSED(kind, change, text)                                                                \
  do {                                                                                             \
    maggi_##kind##_def d = good_##kind();                                                          \
    maggi_builder *b = builder();                                                                  \
    change;                                                                                        \
    CHECK(maggi_builder_##kind(b, &d) == MAGGI_E_MODEL);                                           \
    CHECK_TEXT(maggi_builder_message(b), text);                                                    \
    maggi_builder_free(b);                                                                         \
  } while (0)

/* the same for what only the whole model shows */
#define NO_MODEL(kind, change, text)                                                               \
  do {                                                                                             \
    maggi_##kind##_def d = good_##kind();                                                          \
    maggi_builder *b = builder();                                                                  \
    maggi_model *m = (maggi_model *)b;                                                             \
    add_bodies(b);                                                                                 \
    change;                                                                                        \
    CHECK(maggi_builder_##kind(b, &d) == MAGGI_OK);                                                \
    CHECK(maggi_model_create(b, &m) == MAGGI_E_MODEL);                                             \
    CHECK(m == NULL);                                                                              \
    CHECK_TEXT(maggi_builder_message(b), text);                                                    \
    maggi_builder_free(b);                                                                         \
  } while (0)

static maggi_builder *builder(void)
{
  maggi_builder *b = NULL;

  CHECK(maggi_builder_create("test", &b) == MAGGI_OK);
  return b;
}

static maggi_body_def good_body(void)
{
  maggi_body_def d;

  maggi_body_def_init(&d);
  d.name = "b";
  d.mass = 1.0;
  d.inertia[0] = d.inertia[1] = d.inertia[2] = 1.0;
  return d;
}

static maggi_body_def good_bar(void)
{
  maggi_body_def d = good_body();

  d.is_bar = 1;
  d.bar_to[2] = 1.0;
  return d;
}

static maggi_point_mass_def good_point_mass(void)
{
  maggi_point_mass_def d;

  maggi_point_mass_def_init(&d);
  d.name = "p";
  d.body = "b1";
  d.mass = 1.0;
  return d;
}

static maggi_loop_def good_loop(void)
{
  maggi_loop_def d;

  maggi_loop_def_init(&d);
  d.name = "l";
  d.type = MAGGI_LOOP_REVOLUTE;
  d.body_a = "b1";
  d.body_b = "b2";
  return d;
}

static maggi_rod_def good_rod(void)
{
  maggi_rod_def d;

  maggi_rod_def_init(&d);
  d.name = "r";
  d.body_a = "b1";
  d.body_b = "b2";
  d.point_b[1] = 1.0;
  return d;
}

static maggi_spring_def good_spring(void)
{
  maggi_spring_def d;

  maggi_spring_def_init(&d);
  d.name = "s";
  d.body_a = "b1";
  d.body_b = "b2";
  d.point_b[1] = 1.0;
  return d;
}

static maggi_joint_spring_def good_joint_spring(void)
{
  maggi_joint_spring_def d;

  maggi_joint_spring_def_init(&d);
  d.name = "t";
  d.coordinate = "b1";
  return d;
}

static maggi_force_def good_force(void)
{
  maggi_force_def d;

  maggi_force_def_init(&d);
  d.name = "f";
  d.body = "b1";
  return d;
}

/* a force too */
typedef maggi_force_def maggi_drag_def;

static maggi_status maggi_builder_drag(maggi_builder *b, const maggi_drag_def *d)
{
  return maggi_builder_force(b, d);
}

static maggi_force_def good_drag(void)
{
  maggi_force_def d = good_force();

  d.type = MAGGI_FORCE_DRAG;
  d.density = 1.2;
  d.coefficient = 0.5;
  d.area = 2.0;
  d.low_speed = 1e-3;
  return d;
}

static const double rising[3] = {0.0, 1.0, 2.0}, falling[3] = {0.0, 2.0, 2.0};
static const double infinite[4] = {0.0, 1.0, INFINITY, 3.0}, late[4] = {2.0, 2.0, 0.0, 1.0};

static maggi_function_def good_function(void)
{
  maggi_function_def d;

  maggi_function_def_init(&d);
  d.name = "f";
  d.type = MAGGI_FUNCTION_SPLINE;
  d.number = 3;
  d.times = rising;
  d.values = falling;
  return d;
}

static maggi_sensor_def good_sensor(void)
{
  maggi_sensor_def d;

  maggi_sensor_def_init(&d);
  d.name = "s";
  d.body = "b1";
  return d;
}

static const char *const one_path[2] = {"bodies.b*.mass", "bodies.b1.mass"};
static const char *const one_term[1] = {"o"};

static maggi_objective_def good_objective(void)
{
  maggi_objective_def d;

  maggi_objective_def_init(&d);
  d.name = "o";
  d.signal = "b1.q";
  return d;
}

static maggi_design_def good_design(void)
{
  maggi_design_def d;

  maggi_design_def_init(&d);
  d.name = "g";
  d.number = 1;
  d.paths = one_path;
  return d;
}

/* b1 and b2 with one coordinate, b3 with six, b4 with none */
static void add_bodies(maggi_builder *b)
{
  maggi_body_def d = good_body();

  d.name = "b1";
  CHECK(maggi_builder_body(b, &d) == MAGGI_OK);
  d.name = "b2";
  CHECK(maggi_builder_body(b, &d) == MAGGI_OK);
  d.name = "b3";
  d.joint = MAGGI_JOINT_FREE;
  CHECK(maggi_builder_body(b, &d) == MAGGI_OK);
  d.name = "b4";
  d.joint = MAGGI_JOINT_FIXED;
  CHECK(maggi_builder_body(b, &d) == MAGGI_OK);
}

static void test_names(void)
{
  static const char name101[] =
      "a234567890123456789012345678901234567890123456789012345678901234567890123456789012345678901"
      "2345678901";

  CHECK(strlen(name101) == 101);
  REFUSED(body, d.name = NULL, "bodies: an entry has no name");
  REFUSED(body, d.name = "", "bodies: an entry has no name");
  REFUSED(body, d.name = "a.b", "bodies.a.b: a name has only letters, digits, _ and -");
  REFUSED(body, d.name = "a b", "bodies.a b: a name has only letters, digits, _ and -");
  REFUSED(body, d.name = "\xc3\xa9", "bodies.\xc3\xa9: a name has only letters, digits, _ and -");
  REFUSED(body, d.name = name101,
          "bodies.a2345678901234567890..: a name has at most 100 characters");
  REFUSED(body, d.name = "ground", "bodies.ground: this name is the fixed body's");
  REFUSED(point_mass, d.name = NULL, "point_masses: an entry has no name");
  REFUSED(loop, d.name = "", "loops: an entry has no name");
  REFUSED(rod, d.name = "", "rods: an entry has no name");
  REFUSED(spring, d.name = "", "springs: an entry has no name");
  REFUSED(joint_spring, d.name = "", "joint_springs: an entry has no name");
  REFUSED(force, d.name = "", "forces: an entry has no name");
  REFUSED(function, d.name = "", "functions: an entry has no name");
  REFUSED(sensor, d.name = "", "sensors: an entry has no name");
  REFUSED(objective, d.name = "", "objectives: an entry has no name");
  REFUSED(objective, d.name = "rms(b1.q)",
          "objectives.rms(b1.q): a name has only letters, digits, _ and -");
  REFUSED(design, d.name = NULL, "design: an entry has no name");
  REFUSED(design, d.name = "all", "design.all: this name means all parameters");
}

static void test_body(void)
{
  static const char shape[] = "bodies.b: inertia is not that of a body (positive, each moment at "
                              "most the sum of the others)";

  REFUSED(body, d.joint = (maggi_joint_type)99, "bodies.b: joint type 99 does not exist");
  REFUSED(body, d.joint = (maggi_joint_type)-1, "bodies.b: joint type -1 does not exist");
  REFUSED(body, d.point[1] = NAN, "bodies.b: joint point is not finite");
  REFUSED(body, d.axis[2] = INFINITY, "bodies.b: joint axis is not finite");
  REFUSED(body, d.axis2[2] = -INFINITY, "bodies.b: joint axis2 is not finite");
  REFUSED(body, d.axis[0] = 0.0, "bodies.b: joint axis is zero");
  REFUSED(body, d.joint = MAGGI_JOINT_PLANAR; d.axis[0] = 0.0, "bodies.b: joint axis is zero");
  REFUSED(body, d.joint = MAGGI_JOINT_UNIVERSAL, "bodies.b: joint axis2 is zero");
  REFUSED(body, d.joint = MAGGI_JOINT_UNIVERSAL;
          d.axis2[0] = -3.0, "bodies.b: joint axis and axis2 are parallel");
  REFUSED(body, d.joint = MAGGI_JOINT_PLANAR;
          d.axis2[0] = 2.0,
          "bodies.b: joint axis2 does not lie in the plane: it is parallel to axis");
  REFUSED(body, d.mass = NAN, "bodies.b: mass is not finite");
  REFUSED(body, d.mass = -2.0, "bodies.b: mass is negative (-2)");
  REFUSED(body, d.cog[0] = NAN, "bodies.b: cog is not finite");
  REFUSED(body, d.inertia[5] = NAN, "bodies.b: inertia is not finite");
  REFUSED(body, d.inertia[0] = -1.0, shape);
  REFUSED(body, d.inertia[0] = 2.5, shape);
  REFUSED(body, d.inertia[0] = 0.0; d.inertia[1] = 0.0; d.inertia[2] = 1.0, shape);
  REFUSED(body, d.inertia[3] = 0.6, shape);
  REFUSED(body, d.inertia[3] = d.inertia[4] = 0.3; d.inertia[5] = 0.4, shape);
  REFUSED(body, memset(d.inertia, 0, sizeof d.inertia); d.inertia[4] = 1e-9, shape);
  REFUSED(body, d = good_bar(); d.bar_to[2] = 0.0, "bodies.b: the bar has no length");
  REFUSED(body, d = good_bar(); d.bar_from[2] = NAN, "bodies.b: an end of the bar is not finite");
  REFUSED(body, d.position[0] = NAN, "bodies.b: initial position is not finite");
  REFUSED(body, d.velocity[0] = NAN, "bodies.b: initial velocity is not finite");
  REFUSED(body, d.motion[0] = "f";
          d.position_given[0] = MAGGI_INITIAL_GIVEN,
          "bodies.b: a guided coordinate takes its position and velocity from its motion");
  REFUSED(body, d.motion[0] = "f";
          d.velocity_given[0] = MAGGI_INITIAL_GIVEN,
          "bodies.b: a guided coordinate takes its position and velocity from its motion");
  REFUSED(body, d.motion[1] = "f", "bodies.b: a revolute joint has 1 coordinates, more are given");
  REFUSED(body, d.joint = MAGGI_JOINT_FIXED;
          d.velocity_given[0] = MAGGI_INITIAL_GIVEN,
          "bodies.b: a fixed joint has 0 coordinates, more are given");
  REFUSED(body, d.joint = MAGGI_JOINT_SPHERICAL;
          d.position_given[3] = MAGGI_INITIAL_GIVEN,
          "bodies.b: a spherical joint has 3 coordinates, more are given");
}

/* bodies at the edge of what is possible */
static void test_good_bodies(void)
{
  maggi_builder *b = builder();
  maggi_body_def d = good_body();

  d.inertia[0] = 2.0; /* flat */
  CHECK(maggi_builder_body(b, &d) == MAGGI_OK);
  d.name = "rod";
  d.inertia[0] = 0.0; /* thin */
  d.inertia[1] = d.inertia[2] = 1.0 / 12.0;
  CHECK(maggi_builder_body(b, &d) == MAGGI_OK);
  d.name = "inclined_rod"; /* along (1, 1, 1): 1/12 (e.e I - e e^T) */
  d.inertia[0] = d.inertia[1] = d.inertia[2] = 2.0 / 12.0;
  d.inertia[3] = d.inertia[4] = d.inertia[5] = -1.0 / 12.0;
  CHECK(maggi_builder_body(b, &d) == MAGGI_OK);
  d.name = "nothing";
  d.mass = 0.0;
  memset(d.inertia, 0, sizeof d.inertia);
  CHECK(maggi_builder_body(b, &d) == MAGGI_OK);
  d.name = "b"; /* the name is there */
  CHECK(maggi_builder_body(b, &d) == MAGGI_E_MODEL);
  CHECK_TEXT(maggi_builder_message(b), "bodies.b: this name is there already");
  maggi_builder_free(b);
}

static void test_parts(void)
{
  REFUSED(point_mass, d.mass = -1.0, "point_masses.p: mass is negative (-1)");
  REFUSED(point_mass, d.mass = NAN, "point_masses.p: a number is not finite");
  REFUSED(point_mass, d.point[0] = NAN, "point_masses.p: a number is not finite");

  REFUSED(loop, d.type = (maggi_loop_type)7, "loops.l: loop type 7 does not exist");
  REFUSED(loop, d.type = (maggi_loop_type)-1, "loops.l: loop type -1 does not exist");
  REFUSED(loop, d.point_a[0] = NAN, "loops.l: point is not finite");
  REFUSED(loop, d.has_b = 1; d.point_b[0] = NAN, "loops.l: point is not finite");
  REFUSED(loop, d.axis_a[0] = NAN, "loops.l: axis is not finite");
  REFUSED(loop, d.axis_a[0] = 0.0, "loops.l: axis is zero");
  REFUSED(loop, d.has_b = 1; d.axis_b[0] = NAN, "loops.l: axis_b is not finite");
  REFUSED(loop, d.has_b = 1; d.axis_b[0] = 0.0, "loops.l: axis_b is zero");
  REFUSED(loop, d.type = MAGGI_LOOP_UNIVERSAL, "loops.l: axis_a and axis_b are parallel");

  REFUSED(rod, d.point_a[0] = NAN, "rods.r: an end is not finite");
  REFUSED(rod, d.point_b[1] = 0.0, "rods.r: the rod has no length");
  REFUSED(rod, d.mass = INFINITY, "rods.r: mass is not finite");
  REFUSED(rod, d.mass = -1.0, "rods.r: mass is negative (-1)");
  REFUSED(rod, d.length = 0.0, "rods.r: length is not positive (0)");
  REFUSED(rod, d.length = -2.0, "rods.r: length is not positive (-2)");
  REFUSED(rod, d.length = INFINITY, "rods.r: length is not positive (inf)");

  REFUSED(spring, d.point_a[0] = NAN, "springs.s: an end is not finite");
  REFUSED(spring, d.point_b[1] = 0.0, "springs.s: the ends coincide, the force has no direction");
  REFUSED(spring, d.stiffness = NAN, "springs.s: a number is not finite");
  REFUSED(spring, d.damping = NAN, "springs.s: a number is not finite");
  REFUSED(spring, d.preload = NAN, "springs.s: a number is not finite");
  REFUSED(spring, d.free_length = -1.0, "springs.s: free_length is negative (-1)");
  REFUSED(spring, d.free_length = 1.0;
          d.preload = 1.0, "springs.s: free_length and preload exclude each other");
  REFUSED(spring, d.has_slopes = 1; d.c[3] = NAN, "springs.s: a slope is not finite");
  REFUSED(spring, d.has_slopes = 1; d.v11 = -1.0, "springs.s: v11 is negative (-1)");
  REFUSED(spring, d.has_slopes = 1; d.v22 = 1.0, "springs.s: v22 is positive (1)");

  REFUSED(joint_spring, d.stiffness = NAN, "joint_springs.t: a number is not finite");
  REFUSED(joint_spring, d.damping = NAN, "joint_springs.t: a number is not finite");
  REFUSED(joint_spring, d.rest = NAN, "joint_springs.t: a number is not finite");
  REFUSED(joint_spring, d.preload = NAN, "joint_springs.t: a number is not finite");

  REFUSED(force, d.type = (maggi_force_type)9, "forces.f: force type 9 does not exist");
  REFUSED(force, d.type = (maggi_force_type)-1, "forces.f: force type -1 does not exist");
  REFUSED(force, d.point[0] = NAN, "forces.f: a number is not finite");
  REFUSED(force, d.value[0] = NAN, "forces.f: a number is not finite");

  REFUSED(function, d.type = (maggi_function_type)9, "functions.f: function type 9 does not exist");
  REFUSED(function, d.number = 1, "functions.f: at least two points are needed, not 1");
  REFUSED(function, d.type = MAGGI_FUNCTION_KNOTS;
          d.number = -5, "functions.f: at least two points are needed, not -5");
  REFUSED(function, d.type = MAGGI_FUNCTION_POLYNOMIAL;
          d.number = 0, "functions.f: a polynomial needs a coefficient");
  REFUSED(function, d.values = NULL, "functions.f: a value is not finite");
  REFUSED(function, d.values = infinite, "functions.f: a value is not finite");
  REFUSED(function, d.times = NULL, "functions.f: a time is not finite");
  REFUSED(function, d.times = infinite, "functions.f: a time is not finite");
  REFUSED(function, d.times = falling, "functions.f: times do not increase (2 after 2)");
  REFUSED(function, d.type = MAGGI_FUNCTION_STEP;
          d.values = late, "functions.f: t1 is not after t0");

  REFUSED(sensor, d.type = (maggi_sensor_type)99, "sensors.s: sensor type 99 does not exist");
  REFUSED(sensor, d.point[0] = NAN, "sensors.s: point is not finite");
  REFUSED(sensor, d.type = MAGGI_SENSOR_COMBINATION, "sensors.s: terms are missing");
}

/* (each wrong definition: test_objective.c, test_design.c) */
static void test_definitions(void)
{
  REFUSED(objective, d.signal = NULL, "objectives.o: signal is missing");
  REFUSED(objective, d.type = MAGGI_OBJECTIVE_SMOOTH_MAXIMUM,
          "objectives.o: sharpness is not positive (0)");
  REFUSED(objective, d.type = MAGGI_OBJECTIVE_VALUE; d.number = 3;
          d.times = falling, "objectives.o: times do not increase (2 after 2)");
  REFUSED(design, d.number = 0, "design.g: parameters are missing");
  REFUSED(design, d.lower = 3.0; d.upper = 2.0, "design.g: lower is above upper (3, 2)");

  NO_MODEL(objective, d.signal = "b1.z", "objectives.o: signal \"b1.z\" does not exist");
  NO_MODEL(objective, d.type = MAGGI_OBJECTIVE_SUM; d.nterm = 1;
           d.terms = one_path, "objectives.o: terms: \"bodies.b*.mass\" does not exist");
  NO_MODEL(objective, d.type = MAGGI_OBJECTIVE_SUM; d.nterm = 1;
           d.terms = one_term, "objectives.o: terms: \"o\" is a sum itself");
  NO_MODEL(design, d.paths = one_term, "design.g: parameters: \"o\" does not exist");
  NO_MODEL(design, d.number = 2, "design.g: parameters: \"bodies.b1.mass\" is there twice");
}

static void test_links(void)
{
  NO_MODEL(body, d.parent = "x", "bodies.b: parent \"x\" does not exist");
  NO_MODEL(body, d.parent = "b", "bodies.b: its parents lead back to itself and not to the ground");
  NO_MODEL(body, d.motion[0] = "x", "bodies.b: function \"x\" does not exist");
  NO_MODEL(point_mass, d.body = NULL, "point_masses.p: body is missing");
  NO_MODEL(point_mass, d.body = "x", "point_masses.p: body \"x\" does not exist");
  NO_MODEL(point_mass, d.body = "ground", "point_masses.p: the ground takes no mass");
  NO_MODEL(loop, d.body_a = NULL, "loops.l: body_a is missing");
  NO_MODEL(loop, d.body_a = "x", "loops.l: body_a \"x\" does not exist");
  NO_MODEL(loop, d.body_b = "x", "loops.l: body_b \"x\" does not exist");
  NO_MODEL(loop, d.body_b = "b1", "loops.l: body_a and body_b are the same body");
  NO_MODEL(loop, d.body_a = "ground";
           d.body_b = "ground", "loops.l: body_a and body_b are the same body");
  NO_MODEL(rod, d.body_a = "x", "rods.r: body_a \"x\" does not exist");
  NO_MODEL(rod, d.body_b = "b1", "rods.r: body_a and body_b are the same body");
  NO_MODEL(spring, d.body_b = "x", "springs.s: body_b \"x\" does not exist");
  NO_MODEL(spring, d.body_b = "b1", "springs.s: body_a and body_b are the same body");
  NO_MODEL(joint_spring, d.coordinate = NULL, "joint_springs.t: coordinate is missing");
  NO_MODEL(joint_spring, d.coordinate = "x", "joint_springs.t: coordinate \"x\" does not exist");
  NO_MODEL(joint_spring, d.coordinate = "b1.1",
           "joint_springs.t: coordinate \"b1.1\" does not exist");
  NO_MODEL(
      joint_spring, d.coordinate = "b3",
      "joint_springs.t: coordinate \"b3\" has a free joint, name one of its coordinates .1, .2 ..");
  NO_MODEL(joint_spring, d.coordinate = "b4",
           "joint_springs.t: coordinate \"b4\" has a fixed joint, without a coordinate");
  NO_MODEL(joint_spring, d.coordinate2 = "x", "joint_springs.t: coordinate2 \"x\" does not exist");
  NO_MODEL(joint_spring, d.coordinate2 = "b1", "joint_springs.t: the two coordinates are the same");
  NO_MODEL(force, d.body = NULL, "forces.f: body is missing");
  NO_MODEL(force, d.body = "x", "forces.f: body \"x\" does not exist");
  NO_MODEL(force, d.body = "ground", "forces.f: a load on the ground does nothing");
  NO_MODEL(force, d.reaction = "x", "forces.f: reaction \"x\" does not exist");
  NO_MODEL(force, d.reaction = "b1", "forces.f: body and reaction are the same body");
  NO_MODEL(force, d.function = "x", "forces.f: function \"x\" does not exist");
  NO_MODEL(force, d.type = MAGGI_FORCE_JOINT, "forces.f: coordinate is missing");
  NO_MODEL(drag, d.density = -1.0, "forces.f.density must not be negative (-1)");
  NO_MODEL(drag, d.density = NAN, "forces.f.density must be finite (nan)");
  NO_MODEL(drag, d.coefficient = -0.5, "forces.f.coefficient must not be negative (-0.5)");
  NO_MODEL(drag, d.area = -2.0, "forces.f.area must not be negative (-2)");
  NO_MODEL(drag, d.low_speed = 0.0, "forces.f.low_speed must be positive (0)");
  NO_MODEL(drag, d.wind[1] = INFINITY, "forces.f.wind.y must be finite (inf)");
  NO_MODEL(sensor, d.body = NULL, "sensors.s: body is missing");
  NO_MODEL(sensor, d.body = "x", "sensors.s: body \"x\" does not exist");
  NO_MODEL(sensor, d.at_cog = 1;
           d.body = MAGGI_GROUND,
           "sensors.s: point is missing, and the ground has no centre of gravity");
  NO_MODEL(sensor, d.type = MAGGI_SENSOR_SPRING, "sensors.s: element is missing");
  NO_MODEL(sensor, d.type = MAGGI_SENSOR_SPRING;
           d.element = "x", "sensors.s: element \"x\" is no spring");
  NO_MODEL(sensor, d.type = MAGGI_SENSOR_JOINT_SPRING;
           d.element = "x", "sensors.s: element \"x\" is no joint spring");
  NO_MODEL(sensor, d.type = MAGGI_SENSOR_ROD;
           d.element = "x", "sensors.s: element \"x\" is no rod");
}

/* a failed addition leaves the builder as it was, a failed model too */
static void test_rest(void)
{
  static const double bad[3] = {0.0, NAN, 0.0};
  maggi_builder *b = builder();
  maggi_model *m;
  maggi_body_def d = good_body();
  maggi_simulation_def s = {-1.0, 0.0};

  CHECK(maggi_model_create(b, &m) == MAGGI_E_MODEL);
  CHECK_TEXT(maggi_builder_message(b), "bodies: a model needs at least one body");
  CHECK(maggi_builder_gravity(b, bad) == MAGGI_E_MODEL);
  CHECK_TEXT(maggi_builder_message(b), "gravity: a number is not finite");
  CHECK(maggi_builder_simulation(b, &s) == MAGGI_E_MODEL);
  CHECK_TEXT(maggi_builder_message(b), "simulation: time is not a positive number (-1)");
  s.time = 1.0;
  s.step = NAN;
  CHECK(maggi_builder_simulation(b, &s) == MAGGI_E_MODEL);
  d.name = "b1";
  d.parent = "b2";
  CHECK(maggi_builder_body(b, &d) == MAGGI_OK);
  CHECK(maggi_builder_body(b, &d) == MAGGI_E_MODEL);
  CHECK_TEXT(maggi_builder_message(b), "bodies.b1: this name is there already");
  CHECK(maggi_model_create(b, &m) == MAGGI_E_MODEL);
  CHECK_TEXT(maggi_builder_message(b), "bodies.b1: parent \"b2\" does not exist");
  d.name = "b2";
  d.parent = "b3";
  CHECK(maggi_builder_body(b, &d) == MAGGI_OK);
  d.name = "b3";
  d.parent = "b1";
  CHECK(maggi_builder_body(b, &d) == MAGGI_OK);
  CHECK(maggi_model_create(b, &m) == MAGGI_E_MODEL);
  CHECK_TEXT(maggi_builder_message(b),
             "bodies.b1: its parents lead back to itself and not to the ground");
  maggi_builder_free(b);
  maggi_builder_free(NULL);
  maggi_model_free(NULL);
  maggi_data_free(NULL);
}

/* names are unique in their list, and free in others; those of point masses, in their body */
static void test_scopes(void)
{
  maggi_builder *b = builder();
  maggi_model *m;
  maggi_loop_def l = good_loop();
  maggi_rod_def r = good_rod();
  maggi_spring_def s = good_spring();
  maggi_joint_spring_def t = good_joint_spring();
  maggi_force_def f = good_force();
  maggi_function_def u = good_function();
  maggi_sensor_def e = good_sensor();
  maggi_point_mass_def p = good_point_mass();
  maggi_objective_def o = good_objective();
  maggi_design_def g = good_design();

  add_bodies(b);
  l.name = r.name = s.name = t.name = f.name = u.name = e.name = p.name = o.name = g.name = "b1";
#define TWICE(kind, def)                                                                           \
  CHECK(maggi_builder_##kind(b, &def) == MAGGI_OK);                                                \
  CHECK(maggi_builder_##kind(b, &def) == MAGGI_E_MODEL)
  TWICE(loop, l);
  TWICE(rod, r);
  TWICE(spring, s);
  TWICE(joint_spring, t);
  TWICE(force, f);
  TWICE(function, u);
  TWICE(sensor, e);
  TWICE(objective, o);
  TWICE(design, g);
  TWICE(point_mass, p);
  CHECK_TEXT(maggi_builder_message(b), "point_masses.b1: this name is there already");
  p.body = "b2";
  TWICE(point_mass, p);
  CHECK(maggi_model_create(b, &m) == MAGGI_OK);
  CHECK_TEXT(maggi_builder_message(b), "");
  maggi_model_free(m);
  /* and the builder may be used further */
  p.name = "more";
  CHECK(maggi_builder_point_mass(b, &p) == MAGGI_OK);
  CHECK(maggi_model_create(b, &m) == MAGGI_OK);
  maggi_model_free(m);
  maggi_builder_free(b);
}

/* strings and arrays are copied */
static void test_copies(void)
{
  maggi_builder *b = builder();
  maggi_model *m;
  maggi_body_def d = good_body();
  maggi_function_def f = good_function();
  char name[] = "crank", motion[] = "f", function[] = "f";
  double times[3] = {0, 1, 2}, values[3] = {5, 6, 8}, factor = 2.0;
  char signal[] = "crank.q", path[] = "bodies.*.mass", unit[] = "t", term[] = "o";
  const char *paths[] = {path}, *terms[] = {term};
  maggi_objective_def o = good_objective(), sum = good_objective();
  maggi_design_def g = good_design();
  maggi_objective *objective;
  maggi_design *design;
  maggi_data *data;

  d.name = name;
  d.motion[0] = motion;
  CHECK(maggi_builder_body(b, &d) == MAGGI_OK);
  f.name = function;
  f.times = times;
  f.values = values;
  CHECK(maggi_builder_function(b, &f) == MAGGI_OK);
  o.signal = signal;
  o.type = MAGGI_OBJECTIVE_LEAST_SQUARES;
  o.number = 3;
  o.times = times;
  o.values = values;
  CHECK(maggi_builder_objective(b, &o) == MAGGI_OK);
  sum.name = "sum";
  sum.type = MAGGI_OBJECTIVE_SUM;
  sum.nterm = 1;
  sum.terms = terms;
  sum.weights = &factor;
  CHECK(maggi_builder_objective(b, &sum) == MAGGI_OK);
  g.paths = paths;
  g.factors = &factor;
  g.unit = unit;
  CHECK(maggi_builder_design(b, &g) == MAGGI_OK);
  factor = 0.0;
  paths[0] = terms[0] = NULL;
  signal[0] = path[0] = unit[0] = term[0] = 'x';
  memset(name, 'x', 3);
  motion[0] = function[0] = 'x';
  times[1] = values[1] = NAN;
  CHECK(maggi_model_create(b, &m) == MAGGI_OK);
  maggi_builder_free(b);
  CHECK_TEXT(maggi_body_name(m, 0), "crank");
  CHECK(maggi_parameter_default(m, maggi_parameter_find(m, "functions.f.values.2")) == 6.0);
  CHECK(maggi_parameter_default(m, maggi_parameter_find(m, "functions.f.times.2")) == 1.0);
  CHECK(maggi_objective_named(m, "sum", &objective, NULL, 0) == MAGGI_OK);
  CHECK_TEXT(maggi_objective_unit(objective), "rad^2");
  maggi_objective_free(objective);
  data = test_data(m);
  CHECK(maggi_design_create(data, &design) == MAGGI_OK);
  CHECK(maggi_design_select(design, "g", NULL, 0) == MAGGI_OK);
  CHECK_TEXT(maggi_design_unit(design, 0), "t");
  CHECK(maggi_design_value(design, 0) == 0.5);
  maggi_design_free(design);
  maggi_data_free(data);
  maggi_model_free(m);
}

/* a branched spatial model with a loop, bodies in this order or reversed or shuffled: the same
 * motion; names keep the order of the file */
static void test_order(void)
{
  static const char *const body[5] = {
      "- {name: a, mass: 1, cog: [0.2, 0.1, 0.4], inertia: {xx: 0.2, yy: 0.3, zz: 0.25},"
      " joint: {type: revolute, point: [0, 0, 0], axis: [1, 0.3, 0], velocity: 2}}\n",
      "- {name: b, parent: a, mass: 0.7, cog: [0, 0.9, 0.2], inertia: {xx: 0.1, yy: 0.1, zz: 0.1},"
      " joint: {type: universal, point: [0, 0.5, 0.3], axis: [0, 0.2, 1], axis2: [1, 0, 0]}}\n",
      "- {name: c, parent: b, mass: 0.4, cog: [0.3, 1.2, 0.1], inertia: {xx: 0.1, yy: 0.1, zz: "
      "0.1},"
      " joint: {type: spherical, point: [0.1, 1, 0.2]}}\n",
      "- {name: e, parent: a, mass: 0.9, bar: {from: [0.5, 0, 0], to: [1, 0.8, 0.3]},"
      " joint: {type: revolute, point: [0.5, 0, 0], axis: [0, 0.1, 1]}}\n",
      "- {name: f, mass: 1.4, cog: [1.5, 0.5, 0], inertia: {xx: 0.3, yy: 0.3, zz: 0.4},"
      " joint: {type: planar, point: [1.5, 0.5, 0], axis: [0, 0, 1]}}\n",
  };
  static const int orders[4][5] = {
      {0, 1, 2, 3, 4}, {4, 3, 2, 1, 0}, {2, 4, 0, 3, 1}, {3, 2, 0, 1, 4}};
  static const char *const coordinates[10] = {"a",   "b.1", "b.2", "c.1", "c.2",
                                              "c.3", "e",   "f.1", "f.2", "f.3"};
  maggi_model *m;
  maggi_data *d;
  test_state s;
  double energy = 0.0, q0[10], a0[10];
  int i, k, at;

  for (i = 0; i < 4; ++i) {
    m = test_model("bodies:\n%s%s%s%s%s"
                   "rods: [{name: r, body_a: e, body_b: f, point_a: [1, 0.8, 0.3],"
                   " point_b: [1.5, 1, 0], mass: 0.4}]\n"
                   "loops: [{name: l, type: spherical, body_a: c, body_b: f,"
                   " point: [1.1, 1.1, 0.1]}]\n",
                   body[orders[i][0]], body[orders[i][1]], body[orders[i][2]], body[orders[i][3]],
                   body[orders[i][4]]);
    d = test_start(m);
    CHECK_TEXT(maggi_body_name(m, 0), i == 0 ? "a" : i == 1 ? "f" : i == 2 ? "c" : "e");
    test_step(d, 1e-3, 200);
    s = test_get(d);
    if (i == 0) energy = test_energy(d);
    CHECK_NEAR(test_energy(d), energy, 1e-12, 0.0);
    /* the independent coordinates may be others, and with them the error of the steps */
    for (k = 0; k < 10; ++k) {
      at = maggi_coordinate_find(m, coordinates[k]);
      if (!CHECK(at >= 0)) continue;
      if (i == 0) {
        q0[k] = s.q[at];
        a0[k] = s.a[at];
      }
      CHECK_NEAR(s.q[at], q0[k], 1e-10, 1e-10);
      CHECK_NEAR(s.a[at], a0[k], 1e-9, 1e-9);
    }
    test_free(d, m);
  }
}

int main(void)
{
  test_names();
  test_body();
  test_good_bodies();
  test_parts();
  test_definitions();
  test_links();
  test_rest();
  test_scopes();
  test_copies();
  test_order();
  return check_done();
}
