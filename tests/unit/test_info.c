/* core/model/info.c, words.c, arena.c, multiple_four_bar.c: what one can ask a model. */
#include "arena.h"
#include "fixture.h"

static const char everything[] =
    "source: \"a \\u00fc test\"\n"
    "gravity: [1, 2, 3]\n"
    "simulation: {time: 5, step: 0.25}\n"
    "bodies:\n"
    "- {name: late, parent: early, mass: 2, bar: {from: [0, 0, 1], to: [0, 0, 2]},"
    " joint: {type: universal, point: [0, 0, 1], axis: [1, 0, 0], axis2: [0, 1, 0],"
    " positions: [0.5, null], velocities: [null, 3]}}\n"
    "- {name: early, mass: 1, cog: [7, 8, 9], inertia: {xx: 1, yy: 1.5, zz: 2, xy: 0.1, xz: 0.2,"
    " yz: 0.3}, joint: {type: revolute, point: [4, 5, 6], axis: [0, 3, 4], guess: 0.25}}\n"
    "- {name: slide, mass: 1, joint: {type: prismatic, axis: [1, 0, 0], motion: m}}\n"
    "- {name: plane, mass: 1, inertia: {xx: 1, yy: 1, zz: 1}, joint: {type: planar,"
    " point: [0, 0, 0], axis: [0, 0, 1], axis2: [1, 0, 0]}, point_masses: [{name: p, mass: 3,"
    " point: [1, 2, 3]}]}\n"
    "- {name: weld, parent: plane, mass: 1, joint: {type: fixed}}\n"
    "- {name: ball, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
    " joint: {type: free, point: [0, 0, 0]}}\n"
    "- {name: drawer, mass: 1, inertia: {xx: 1, yy: 1, zz: 1},"
    " joint: {type: cylindrical, point: [0, 0, 0], axis: [0, 0, 1]}}\n"
    "functions:\n"
    "- {name: m, type: sine, amplitude: 0.1, omega: 2, phase: 3, offset: 4}\n"
    "- {name: c, type: constant, value: 5}\n"
    "- {name: p, type: polynomial, coefficients: [1, 2, 3]}\n"
    "- {name: s, type: step, t0: 1, t1: 2, y0: 3, y1: 4}\n"
    "- {name: k, type: knots, times: [1, 2], values: [3, 4]}\n"
    "- {name: q, type: spline, times: [1, 2, 3], values: [3, 4, 6]}\n"
    "loops:\n"
    "- {name: l1, type: spherical, body_a: ball, body_b: ground, point: [1, 2, 3]}\n"
    "- {name: l2, type: universal, body_a: ball, body_b: plane, point: [1, 2, 3],"
    " axis_a: [1, 0, 0], axis_b: [0, 1, 0]}\n"
    "- {name: l3, type: prismatic, body_a: ball, body_b: drawer, point_a: [1, 2, 3],"
    " point_b: [1, 2, 4], axis_a: [0, 0, 1], axis_b: [0, 0, 1]}\n"
    "rods:\n"
    "- {name: r, body_a: ball, body_b: late, point_a: [1, 0, 0], point_b: [0, 0, 2], mass: 6}\n"
    "- {name: long, body_a: ball, body_b: late, point_a: [1, 0, 0], point_b: [0, 0, 2],"
    " length: 2}\n"
    "springs:\n"
    "- {name: s, body_a: ball, body_b: late, point_a: [1, 0, 0], point_b: [0, 0, 2], stiffness: 1,"
    " free_length: 2, damping: 3, slopes: {c1: 4, c2: 5, c3: 6, c4: 7, v11: 8, v22: -9}}\n"
    "- {name: t, body_a: ball, body_b: late, point_a: [1, 0, 0], point_b: [0, 0, 2], preload: 4}\n"
    "joint_springs:\n"
    "- {name: a, coordinate: early, stiffness: 1, damping: 2, rest: 3, preload: 4}\n"
    "- {name: b, coordinate: plane.1, coordinate2: plane.2, stiffness: 1}\n"
    "forces:\n"
    "- {name: f, type: force, body: ball, point: [1, 2, 3], value: [4, 5, 6]}\n"
    "- {name: g, type: torque_body, body: ball, value: [4, 5, 6]}\n"
    "- {name: h, type: joint, coordinate: ball.6, effort: 7}\n"
    "sensors:\n"
    "- {name: x, type: position, body: ball, point: [1, 2, 3]}\n"
    "- {name: y, type: angles, body: ball}\n"
    "- {name: z, type: acceleration, body: ball, point: [1, 2, 3]}\n";

typedef struct entry {
  const char *path;
  double value;
  const char *unit;
} entry;

/* paths of maggi.h: one of each kind */
static const entry entries[] = {
    {"gravity.y", 2, "m/s^2"},
    {"bodies.early.mass", 1, "kg"},
    {"bodies.early.cog.z", 9, "m"},
    {"bodies.early.inertia.xx", 1, "kg m^2"},
    {"bodies.early.inertia.yz", 0.3, "kg m^2"},
    {"bodies.early.joint.point.x", 4, "m"},
    {"bodies.early.joint.axis.z", 4, "-"},
    {"bodies.early.joint.position", 0.25, "rad"},
    {"bodies.early.joint.velocity", 0, "rad/s"},
    {"bodies.late.bar.to.z", 2, "m"},
    {"bodies.late.bar.from.z", 1, "m"},
    {"bodies.late.joint.axis2.y", 1, "-"},
    {"bodies.late.joint.position.1", 0.5, "rad"},
    {"bodies.late.joint.velocity.2", 3, "rad/s"},
    {"bodies.plane.joint.axis2.x", 1, "-"},
    {"bodies.plane.joint.velocity.1", 0, "m/s"},
    {"bodies.plane.joint.position.3", 0, "rad"},
    {"bodies.plane.point_masses.p.mass", 3, "kg"},
    {"bodies.plane.point_masses.p.point.y", 2, "m"},
    {"bodies.ball.joint.position.3", 0, "m"},
    {"bodies.ball.joint.position.4", 0, "rad"},
    {"bodies.drawer.joint.position.1", 0, "m"},
    {"bodies.drawer.joint.position.2", 0, "rad"},
    {"functions.m.amplitude", 0.1, "-"},
    {"functions.m.omega", 2, "rad/s"},
    {"functions.m.phase", 3, "rad"},
    {"functions.m.offset", 4, "-"},
    {"functions.c.value", 5, "-"},
    {"functions.p.coefficients.0", 1, "-"},
    {"functions.p.coefficients.2", 3, "-"},
    {"functions.s.t1", 2, "s"},
    {"functions.s.y0", 3, "-"},
    {"functions.k.times.1", 1, "s"},
    {"functions.k.values.2", 4, "-"},
    {"functions.q.times.3", 3, "s"},
    {"functions.q.values.3", 6, "-"},
    {"loops.l1.point.z", 3, "m"},
    {"loops.l2.axis_b.y", 1, "-"},
    {"loops.l3.point_b.z", 4, "m"},
    {"loops.l3.axis_a.z", 1, "-"},
    {"rods.r.mass", 6, "kg"},
    {"rods.r.point_b.z", 2, "m"},
    {"rods.long.length", 2, "m"},
    {"springs.s.stiffness", 1, "N/m"},
    {"springs.s.free_length", 2, "m"},
    {"springs.s.damping", 3, "N s/m"},
    {"springs.s.c3", 6, "N s/m"},
    {"springs.s.v22", -9, "m/s"},
    {"springs.t.preload", 4, "N"},
    {"springs.t.point_a.x", 1, "m"},
    {"joint_springs.a.stiffness", 1, "N m/rad"},
    {"joint_springs.a.damping", 2, "N m s/rad"},
    {"joint_springs.a.rest", 3, "rad"},
    {"joint_springs.a.preload", 4, "N m"},
    {"joint_springs.b.stiffness", 1, "N/m"},
    {"forces.f.value.y", 5, "N"},
    {"forces.f.point.z", 3, "m"},
    {"forces.g.value.x", 4, "N m"},
    {"forces.h.value", 7, "N m"},
    {"sensors.x.point.z", 3, "m"},
};
enum { ENTRIES = sizeof entries / sizeof *entries };

static void test_parameters(const maggi_model *m)
{
  static const char *const none[] = {"",
                                     "gravity",
                                     "gravity.w",
                                     "bodies.early",
                                     "zzz",
                                     "bodies.early.mass.x",
                                     "rods.r.length",
                                     "springs.s.preload",
                                     "springs.t.free_length",
                                     "bodies.slide.joint.position",
                                     "loops.l1.axis.x",
                                     "bodies.late.cog.x"};
  maggi_model_info info;
  int i, at;

  maggi_model_get_info(m, &info);
  for (i = 0; i < info.parameters; ++i) {
    CHECK(maggi_parameter_path(m, i) && *maggi_parameter_path(m, i));
    CHECK(maggi_parameter_unit(m, i) && *maggi_parameter_unit(m, i));
    CHECK(isfinite(maggi_parameter_default(m, i)));
    /* found under its own path: so no two have the same */
    CHECK(maggi_parameter_find(m, maggi_parameter_path(m, i)) == i);
  }
  for (i = 0; i < ENTRIES; ++i) {
    at = maggi_parameter_find(m, entries[i].path);
    if (!CHECK(at >= 0)) {
      fprintf(stderr, "  %s\n", entries[i].path);
      continue;
    }
    CHECK(maggi_parameter_default(m, at) == entries[i].value);
    CHECK_TEXT(maggi_parameter_unit(m, at), entries[i].unit);
  }
  for (i = 0; i < (int)(sizeof none / sizeof *none); ++i)
    CHECK(maggi_parameter_find(m, none[i]) == -1);
  CHECK(maggi_parameter_path(m, -1) == NULL);
  CHECK(maggi_parameter_path(m, info.parameters) == NULL);
  CHECK(maggi_parameter_unit(m, info.parameters) == NULL);
  CHECK(isnan(maggi_parameter_default(m, -1)));
}

static void test_names(const maggi_model *m)
{
  static const char *const coordinates[] = {"late.1",  "late.2",  "early",  "slide",    "plane.1",
                                            "plane.2", "plane.3", "ball.1", "ball.2",   "ball.3",
                                            "ball.4",  "ball.5",  "ball.6", "drawer.1", "drawer.2"};
  static const int is_angle[] = {1, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0, 1};
  static const char *const loops[] = {"l1", "l2", "l3", "r", "long"};
  static const char *const kinds[] = {"spherical", "universal", "prismatic", "rod", "rod"};
  static const int rows[] = {3, 4, 5, 1, 1};
  static const char *const columns[] = {"x.x",   "x.y", "x.z", "y.roll", "y.pitch",
                                        "y.yaw", "z.x", "z.y", "z.z"};
  maggi_model_info info;
  const maggi_sensor_def *sensor;
  const char *type;
  int i;

  maggi_model_get_info(m, &info);
  CHECK_TEXT(info.name, "test");
  CHECK_TEXT(info.source, "a \xc3\xbc test");
  CHECK(info.bodies == 7 && info.coordinates == 15 && info.guided == 1 && info.loops == 5);
  CHECK(info.loop_equations == 14 && info.sensors == 3 && info.sensor_columns == 9);
  CHECK(info.simulation.time == 5.0 && info.simulation.step == 0.25);
  for (i = 0; i < 15; ++i) {
    CHECK_TEXT(maggi_coordinate_name(m, i), coordinates[i]);
    CHECK(maggi_coordinate_find(m, coordinates[i]) == i);
    CHECK(maggi_coordinate_is_angle(m, i) == is_angle[i]);
    CHECK(maggi_coordinate_is_guided(m, i) == (i == 3));
  }
  for (i = 0; i < 5; ++i) {
    CHECK_TEXT(maggi_loop_name(m, i), loops[i]);
    CHECK_TEXT(maggi_loop_kind(m, i), kinds[i]);
    CHECK(maggi_loop_rows(m, i) == rows[i]);
  }
  for (i = 0; i < 9; ++i) CHECK_TEXT(maggi_sensor_column_name(m, i), columns[i]);
  CHECK_TEXT(maggi_sensor_column_unit(m, 0), "m");
  CHECK_TEXT(maggi_sensor_column_unit(m, 3), "rad");
  CHECK_TEXT(maggi_sensor_column_unit(m, 8), "m/s^2");
  CHECK_TEXT(maggi_body_name(m, 0), "late");
  CHECK_TEXT(maggi_body_parent(m, 0), "early");
  CHECK_TEXT(maggi_body_parent(m, 1), "ground");
  CHECK(maggi_body_joint(m, 0) == MAGGI_JOINT_UNIVERSAL);
  CHECK(maggi_body_joint(m, 4) == MAGGI_JOINT_FIXED);
  CHECK(maggi_body_find(m, "weld") == 4 && maggi_body_find(m, "ground") == -1);
  CHECK(maggi_coordinate_find(m, "ball") == -1 && maggi_coordinate_find(m, "weld") == -1);
  for (i = -1; i <= 99; i += 100) {
    CHECK(!maggi_body_name(m, i) && !maggi_body_parent(m, i) && !maggi_coordinate_name(m, i));
    CHECK(!maggi_loop_name(m, i) && !maggi_loop_kind(m, i) && maggi_loop_rows(m, i) == 0);
    CHECK(!maggi_sensor_column_name(m, i) && !maggi_sensor_column_unit(m, i));
    CHECK(maggi_body_joint(m, i) == MAGGI_JOINT_TYPE_COUNT);
    CHECK(!maggi_coordinate_is_guided(m, i) && !maggi_coordinate_is_angle(m, i));
  }
  CHECK_TEXT(maggi_coordinate_motion(m, 3), "m");
  CHECK(!maggi_coordinate_motion(m, 0) && !maggi_coordinate_motion(m, -1));
  CHECK_TEXT(maggi_model_function(m, 4, &type), "k");
  CHECK_TEXT(type, "knots");
  CHECK(!maggi_model_function(m, 6, &type) && !maggi_model_road(m, 0, &type));
  for (i = 0; i < 9; ++i) {
    sensor = maggi_model_sensor(m, i);
    CHECK(strncmp(columns[i], sensor->name, strlen(sensor->name)) == 0);
  }
  CHECK(!maggi_model_sensor(m, 9) && !maggi_model_sensor(m, -1) && !maggi_model_wheel(m, 0));
  CHECK_TEXT(maggi_model_force(m, 0)->body, "ball");
  CHECK_TEXT(maggi_model_force(m, 2)->coordinate, "ball.6");
  CHECK(maggi_model_force(m, 1)->type == MAGGI_TORQUE_BODY && !maggi_model_force(m, 3));
}

#define CHECK_WORDS(kind, count)                                                                   \
  for (i = 0; i < count; ++i)                                                                      \
    CHECK(maggi_##kind##_type_find(maggi_##kind##_type_name((maggi_##kind##_type)i)) == i);        \
  CHECK(maggi_##kind##_type_name((maggi_##kind##_type) - 1) == NULL);                              \
  CHECK(maggi_##kind##_type_name((maggi_##kind##_type)count) == NULL);                             \
  CHECK(maggi_##kind##_type_find("no such word") == -1);                                           \
  CHECK(maggi_##kind##_type_find("") == -1);                                                       \
  CHECK(maggi_##kind##_type_find(NULL) == -1)

static void test_words(void)
{
  static const int dof[] = {1, 1, 2, 2, 3, 3, 6, 0};
  int i, k;

  CHECK_WORDS(joint, MAGGI_JOINT_TYPE_COUNT);
  CHECK_WORDS(loop, MAGGI_LOOP_TYPE_COUNT);
  CHECK_WORDS(force, MAGGI_FORCE_TYPE_COUNT);
  CHECK_WORDS(function, MAGGI_FUNCTION_TYPE_COUNT);
  CHECK_WORDS(sensor, MAGGI_SENSOR_TYPE_COUNT);
  CHECK_TEXT(maggi_joint_type_name(MAGGI_JOINT_FREE), "free");
  for (i = 0; i < MAGGI_JOINT_TYPE_COUNT; ++i)
    CHECK(maggi_joint_dof((maggi_joint_type)i) == dof[i]);
  CHECK(maggi_joint_dof((maggi_joint_type)-1) == -1);
  CHECK(maggi_joint_dof(MAGGI_JOINT_TYPE_COUNT) == -1);
  for (i = 0; i < MAGGI_STATUS_COUNT; ++i)
    for (k = 0; k < i; ++k)
      CHECK(strcmp(maggi_status_text((maggi_status)i), maggi_status_text((maggi_status)k)) != 0);
  CHECK_TEXT(maggi_status_text((maggi_status)-1), "unknown status");
  CHECK_TEXT(maggi_status_text(MAGGI_STATUS_COUNT), "unknown status");
}

static void test_arena(void)
{
  maggi_arena a = {NULL};
  char *text[200], expected[32];
  double *x;
  int i;

  for (i = 0; i < 200; ++i) {
    x = maggi_arena_alloc(&a, (size_t)i * 40);
    CHECK(x != NULL);
    CHECK(i == 0 || ((size_t)x % sizeof(double) == 0 && x[0] == 0.0 && x[5 * i - 1] == 0.0));
    memset(x, 0xff, (size_t)i * 40);
    text[i] = i % 2 ? maggi_arena_format(&a, "%s.%d", "text", i) : maggi_arena_text(&a, "plain");
  }
  for (i = 0; i < 200; ++i) {
    snprintf(expected, sizeof expected, i % 2 ? "text.%d" : "plain", i);
    CHECK_TEXT(text[i], expected);
  }
  maggi_arena_free(&a);
  CHECK(a.blocks == NULL);
}

/* (2 ny + 1) nz coordinates, nz degrees of freedom; rest state as the thesis says */
static void test_multiple_four_bar(void)
{
  static const int sizes[][2] = {{1, 1}, {1, 3}, {4, 2}, {2, 5}, {7, 15}};
  maggi_model *m;
  maggi_data *d;
  maggi_model_info info;
  double v[1024];
  int i, k, ny, nz;

  for (i = 0; i < 5; ++i) {
    ny = sizes[i][0];
    nz = sizes[i][1];
    CHECK(maggi_model_multiple_four_bar(ny, nz, &m) == MAGGI_OK);
    maggi_model_get_info(m, &info);
    CHECK(info.coordinates == (2 * ny + 1) * nz);
    CHECK(info.bodies == info.coordinates && info.loops == ny * nz);
    d = test_start(m);
    CHECK(test_loops(d).dof == nz && test_loops(d).rank == 2 * ny * nz);
    maggi_get_coordinates(d, NULL, v, NULL);
    for (k = 0; k < info.coordinates; ++k) {
      if (strcmp(maggi_coordinate_name(m, k), "v_1_1") == 0)
        CHECK_NEAR(v[k], acos(-1.0) / 3.0, 1e-15, 0.0);
      else if (strncmp(maggi_coordinate_name(m, k), "v_1_", 4) == 0)
        CHECK_NEAR(v[k], acos(-1.0) / 3.0, 1e-12, 0.0);
      else if (maggi_coordinate_name(m, k)[0] == 'v' && maggi_coordinate_is_independent(d, k))
        CHECK(v[k] == 0.0);
    }
    test_free(d, m);
  }
  CHECK(maggi_model_multiple_four_bar(0, 1, &m) == MAGGI_E_VALUE && !m);
  CHECK(maggi_model_multiple_four_bar(1, 0, &m) == MAGGI_E_VALUE && !m);
  CHECK(maggi_model_multiple_four_bar(-1, 1, &m) == MAGGI_E_VALUE && !m);
}

int main(void)
{
  maggi_model *m = test_model("%s", everything);

  test_parameters(m);
  test_names(m);
  test_words();
  test_arena();
  test_multiple_four_bar();
  maggi_model_free(m);
  return check_done();
}
