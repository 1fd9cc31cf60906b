/* core/kernel/vehicle.c and combinations: sensors of vehicles against formulas. */
#include "fixture.h"

enum { COLUMNS = 18 };

/* a body that turns about the origin with w + alpha t: at (1, -4) it goes forward, which is x, and to the
 * left a little */
static maggi_model *turntable(double w, double alpha)
{
  return test_model(
      "bodies: [{name: b, mass: 1, joint: {type: revolute, point: [0, 0, 0], axis: [0, 0, 1],"
      " motion: f}}]\n"
      "functions: [{name: f, type: polynomial, coefficients: [0, %.17g, %.17g]}]\n"
      "sensors:\n"
      "  - {name: lat, type: lateral_acceleration, body: b, point: [1, -4, 0], low_speed: 1e-6,"
      " low_acceleration: 1e-6}\n"
      "  - {name: slip, type: sideslip, body: b, point: [1, -4, 0], low_speed: 1e-6}\n"
      "  - {name: lv, type: level_velocity, body: b, point: [1, -4, 0]}\n"
      "  - {name: la, type: level_acceleration, body: b, point: [1, -4, 0]}\n"
      "  - {name: ba, type: body_acceleration, body: b, point: [1, -4, 0]}\n"
      "  - {name: sum, type: combination, terms: [lat.planar, la.y], weights: [2, -0.5]}\n"
      "  - {name: all, type: combination, terms: [sum.value, slip.angle]}\n"
      "  - {name: named, type: combination, terms: [lv.x], weights: [3], unit: knots}\n",
      w, 0.5 * alpha);
}

static void check_turntable(double w, double alpha)
{
  maggi_model *m = turntable(w, alpha);
  maggi_data *d = test_data(m);
  double s[COLUMNS], r = sqrt(17.0), a[2], v = fabs(w) * r;
  int i;

  CHECK(maggi_data_reset(d) == MAGGI_OK);
  maggi_get_sensors(d, s);
  a[0] = 4.0 * alpha - w * w; /* alpha x (1, -4) - w^2 (1, -4) */
  a[1] = alpha + 4.0 * w * w;
  CHECK_NEAR(s[0], w * w * r, 1e-11, 0.0);
  CHECK_NEAR(s[1], w > 0.0 ? w * w * r : -w * w * r, 1e-11, 0.0);
  CHECK_NEAR(s[2], hypot(a[0], a[1]), 1e-11, 0.0);
  CHECK_NEAR(s[3], atan2(w * 1.0, w * 4.0), 1e-11, 0.0);
  CHECK_NEAR(s[4], v, 1e-11, 0.0);
  CHECK_NEAR(s[5], w > 0.0 ? 1.0 / r : -1.0 / r, 1e-11, 0.0);
  CHECK_NEAR(s[6], 4.0 * w, 1e-14, 0.0);
  CHECK_NEAR(s[7], 1.0 * w, 1e-14, 0.0);
  CHECK(s[8] == 0.0 && s[11] == 0.0 && s[14] == 0.0);
  for (i = 0; i < 2; ++i) {
    CHECK_NEAR(s[9 + i], a[i], 1e-14, 0.0);
    CHECK_NEAR(s[12 + i], a[i], 1e-14, 0.0);
  }
  CHECK_NEAR(s[15], 2.0 * s[1] - 0.5 * s[10], 1e-15, 0.0);
  CHECK_NEAR(s[16], s[15] + s[3], 1e-15, 0.0);
  CHECK_NEAR(s[17], 3.0 * s[6], 1e-15, 0.0);
  test_free(d, m);
}

static void test_turning(void)
{
  check_turntable(0.7, 0.3);
  check_turntable(0.7, 0.0);
  check_turntable(-0.7, 0.3); /* backwards */
  check_turntable(5.0, -20.0);
}

/* no path: what is said in maggi.h, and derivatives by everything */
static void test_rest(void)
{
  static const char *const name[] = {"lat.exact",  "lat.planar", "lat.approximate",
                                     "slip.angle", "slip.speed", "slip.curvature",
                                     "all.value"};
  double value[7], *gradient, s[COLUMNS], alpha;
  maggi_gradient_options o;
  maggi_objective *J[7];
  maggi_design *design;
  maggi_model *m;
  maggi_data *d;
  char text[200], call[64];
  int i, n, still;

  for (still = 0; still < 2; ++still) {
    alpha = still ? 0.0 : 0.3;
    m = turntable(0.0, alpha);
    d = test_data(m);
    CHECK(maggi_data_reset(d) == MAGGI_OK);
    maggi_get_sensors(d, s);
    CHECK_NEAR(s[0], alpha * sqrt(17.0), 1e-11, 0.0);
    CHECK_NEAR(s[2], alpha * sqrt(17.0), 1e-11, 0.0);
    CHECK(s[1] == 0.0 && s[3] == 0.0 && s[4] == 0.0 && s[5] == 0.0);
    CHECK(maggi_design_create(d, &design) == MAGGI_OK);
    CHECK(maggi_design_select(design, "all", text, sizeof text) == MAGGI_OK);
    n = maggi_design_number(design);
    gradient = calloc(7 * (size_t)n, sizeof *gradient);
    for (i = 0; i < 7; ++i) {
      snprintf(call, sizeof call, "mean(%s)", name[i]);
      CHECK(maggi_objective_named(m, call, &J[i], text, sizeof text) == MAGGI_OK);
    }
    maggi_gradient_options_init(&o);
    o.time = 0.1;
    o.step = 0.01;
    CHECK(maggi_gradient(d, design, 7, J, &o, value, gradient) == MAGGI_OK);
    for (i = 0; i < 7 * n; ++i) CHECK(isfinite(gradient[i]));
    o.method = MAGGI_METHOD_DIRECT;
    CHECK(maggi_gradient(d, design, 7, J, &o, value, gradient) == MAGGI_OK);
    for (i = 0; i < 7 * n; ++i) CHECK(isfinite(gradient[i]));
    for (i = 0; i < 7; ++i) maggi_objective_free(J[i]);
    maggi_design_free(design);
    free(gradient);
    test_free(d, m);
  }
}

/* a body that yaws 0.7, pitches 0.3 and rolls 0.2, and moves along (3, -2, 1) t + (1, 2, -0.5) t^2/2 */
static void test_axes(void)
{
  static const double v[] = {3.0, -2.0, 1.0}, a[] = {1.0, 2.0, -0.5};
  double cy = cos(0.7), sy = sin(0.7), cp = cos(0.3), sp = sin(0.3), cr = cos(0.2), sr = sin(0.2);
  double R[3][3] = {{cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr},
                    {sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr},
                    {-sp, cp * sr, cp * cr}};
  maggi_model *m =
      test_model("bodies: [{name: b, mass: 1, cog: [0, 0, 0], joint: {type: free, point: [0, 0, 0],"
                 " motions: [z, y, x, yaw, pitch, roll]}}]\n"
                 "functions:\n"
                 "  - {name: x, type: polynomial, coefficients: [0, 3, 0.5]}\n"
                 "  - {name: y, type: polynomial, coefficients: [0, -2, 1]}\n"
                 "  - {name: z, type: polynomial, coefficients: [0, 1, -0.25]}\n"
                 "  - {name: yaw, type: constant, value: 0.7}\n"
                 "  - {name: pitch, type: constant, value: 0.3}\n"
                 "  - {name: roll, type: constant, value: 0.2}\n"
                 "sensors:\n"
                 "  - {name: lv, type: level_velocity, body: b}\n"
                 "  - {name: la, type: level_acceleration, body: b, point: [1, 2, 3]}\n"
                 "  - {name: ba, type: body_acceleration, body: b}\n"
                 "  - {name: lat, type: lateral_acceleration, body: b}\n"
                 "  - {name: slip, type: sideslip, body: b}\n");
  maggi_data *d = test_data(m);
  double s[15], vv = 14.0, av = -1.5, c = av / vv, square = 0.0, V = sqrt(13.0);
  int i;

  CHECK(maggi_data_reset(d) == MAGGI_OK);
  maggi_get_sensors(d, s);
  CHECK_NEAR(s[0], cy * v[0] + sy * v[1], 1e-13, 0.0);
  CHECK_NEAR(s[1], cy * v[1] - sy * v[0], 1e-13, 0.0);
  CHECK_NEAR(s[2], v[2], 1e-13, 0.0);
  CHECK_NEAR(s[3], cy * a[0] + sy * a[1], 1e-13, 0.0);
  CHECK_NEAR(s[4], cy * a[1] - sy * a[0], 1e-13, 0.0);
  CHECK_NEAR(s[5], a[2], 1e-13, 0.0);
  for (i = 0; i < 3; ++i) {
    CHECK_NEAR(s[6 + i], R[0][i] * a[0] + R[1][i] * a[1] + R[2][i] * a[2], 1e-13, 0.0);
    square += pow(a[i] - c * v[i], 2);
  }
  CHECK_NEAR(s[9], sqrt(square), 2e-7, 0.0); /* (1e-3 / |n|)^2 / 2 */
  CHECK_NEAR(s[10], (v[0] * a[1] - v[1] * a[0]) / V, 1e-7, 0.0);
  CHECK_NEAR(s[11], sqrt(5.0), 2e-7, 0.0);
  CHECK_NEAR(s[12], atan2(v[1], v[0]) - 0.7, 1e-7, 0.0);
  CHECK_NEAR(s[13], V, 1e-7, 0.0);
  CHECK_NEAR(s[14], (v[0] * a[1] - v[1] * a[0]) / (V * V * V), 2e-7, 0.0);
  test_free(d, m);
}

/* names, units and numbers of columns; parameters */
static void test_columns(void)
{
  static const char *const column[][2] = {
      {"lat.exact", "m/s^2"}, {"lat.planar", "m/s^2"}, {"lat.approximate", "m/s^2"},
      {"slip.angle", "rad"},  {"slip.speed", "m/s"},   {"slip.curvature", "1/m"},
      {"lv.x", "m/s"},        {"lv.y", "m/s"},         {"lv.z", "m/s"},
      {"la.x", "m/s^2"},      {"la.y", "m/s^2"},       {"la.z", "m/s^2"},
      {"ba.x", "m/s^2"},      {"ba.y", "m/s^2"},       {"ba.z", "m/s^2"},
      {"sum.value", "m/s^2"}, {"all.value", "-"},      {"named.value", "knots"}};
  maggi_model *m = turntable(1.0, 0.0);
  maggi_model_info info;
  int i;

  maggi_model_get_info(m, &info);
  CHECK(info.sensors == 8 && info.sensor_columns == COLUMNS);
  for (i = 0; i < COLUMNS; ++i) {
    CHECK_TEXT(maggi_sensor_column_name(m, i), column[i][0]);
    CHECK_TEXT(maggi_sensor_column_unit(m, i), column[i][1]);
    CHECK(maggi_signal_find(m, column[i][0]) == maggi_signal_number(m) - COLUMNS + i);
  }
  CHECK(!maggi_sensor_column_name(m, COLUMNS));
  CHECK(maggi_parameter_default(m, maggi_parameter_find(m, "sensors.sum.weights.2")) == -0.5);
  CHECK_TEXT(maggi_parameter_unit(m, maggi_parameter_find(m, "sensors.sum.weights.2")), "-");
  CHECK_TEXT(maggi_parameter_unit(m, maggi_parameter_find(m, "sensors.named.weights.1")),
             "knots/(m/s)");
  CHECK_TEXT(maggi_parameter_unit(m, maggi_parameter_find(m, "sensors.all.weights.2")), "1/rad");
  CHECK(maggi_parameter_find(m, "sensors.lat.low_speed") >= 0);
  CHECK(maggi_parameter_find(m, "sensors.lat.low_acceleration") >= 0);
  CHECK(maggi_parameter_find(m, "sensors.lv.low_speed") < 0);
  maggi_model_free(m);
}

int main(void)
{
  test_turning();
  test_rest();
  test_axes();
  test_columns();
  return check_done();
}
