/* core/kernel/tyre.c: the formula against reference points of another program; wheels on a road. */
#include "data.h"
#include "fixture.h"

enum { COLUMNS = 22, ROWS_MAX = 1000 };
enum {
  FZ,
  KAPPA,
  ALPHA,
  GAMMA,
  FX,
  FY,
  MX,
  MY,
  MZ,
  FY_ALPHA,
  FX_KAPPA,
  FX_MIRROR = 19,
  FY_MIRROR,
  MZ_MIRROR
};

static double row[ROWS_MAX][COLUMNS];

static int read_rows(void)
{
  FILE *f = fopen(MAGGI_REFERENCES_DIR "/pac2002/reference.csv", "r");
  char line[2000], *s;
  int n = 0, k;

  if (!f) return 0;
  while (fgets(line, sizeof line, f) && n < ROWS_MAX) {
    if (strncmp(line, "Fz,", 3) == 0) continue;
    for (s = line, k = 0; k < COLUMNS; ++k) {
      row[n][k] = strtod(s, &s);
      s += *s == ',';
    }
    ++n;
  }
  fclose(f);
  return n;
}

static maggi_model *cart(void)
{
  char message[512] = "";
  maggi_model *m = NULL;

  if (maggi_model_load(MAGGI_MODELS_DIR "/wheeled-frame.yaml", &m, message, sizeof message) !=
      MAGGI_OK) {
    fprintf(stderr, "%s\n", message);
    exit(1);
  }
  return m;
}

/* the formula at a slip */
static void formula(const maggi_data *d, const double slip[5], double f[6])
{
  maggi_tyre(d->t.tyreadr[0], d->t.np, d->p, slip, f);
}

static void test_reference(void)
{
  maggi_model *m = cart();
  maggi_data *d = test_data(m);
  double f[6], s[3], slip[5], a;
  int i, n = read_rows();

  test_set(m, d, "tyres.truck.low_camber", 1e-4);
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  CHECK(n == 200);
  CHECK(d->t.ntyre == 1 && d->t.nwheel == 4);
  for (i = 0; i < n; ++i) {
    a = tan(row[i][ALPHA]);
    slip[0] = row[i][KAPPA];
    slip[1] = a;
    slip[2] = row[i][GAMMA];
    slip[3] = row[i][FZ];
    slip[4] = 16.7;
    formula(d, slip, f);
    CHECK_NEAR(f[0], row[i][FX], 1e-9, 0.0);
    CHECK_NEAR(f[1], row[i][FY], 1e-9, 0.0);
    CHECK_NEAR(f[2], row[i][FZ], 0.0, 0.0);
    CHECK_NEAR(f[3], row[i][MX], 1e-9, 0.0);
    CHECK_NEAR(f[4], row[i][MY], 1e-9, 0.0);
    CHECK_NEAR(f[5], row[i][MZ], 1e-9, 0.0);
    maggi_tyre_slopes(d->t.tyreadr[0], d->t.np, d->p, slip, s);
    CHECK_NEAR(s[0], row[i][FY_ALPHA], 1e-9, 0.0);
    CHECK_NEAR(s[1], row[i][FX_KAPPA], 1e-9, 0.0);
    slip[1] = -slip[1];
    slip[2] = -slip[2];
    formula(d, slip, f);
    CHECK_NEAR(f[0], row[i][FX_MIRROR], 1e-9, 0.0);
    CHECK_NEAR(-f[1], row[i][FY_MIRROR], 1e-9, 0.0);
    CHECK_NEAR(-f[5], row[i][MZ_MIRROR], 1e-9, 0.0);
  }
  test_free(d, m);
}

/* NOTES of the coach 1.2: driving pushes forward, sliding to the left pushes right and turns back,
 * camber to the right pushes right, rolling resistance brakes */
static void test_signs(void)
{
  maggi_model *m = cart();
  maggi_data *d = test_start(m);
  double zero[5] = {0, 0, 0, 22500, 14}, s[5], f[6], f0[6];

  formula(d, zero, f0);
  memcpy(s, zero, sizeof s);
  s[0] = 0.02;
  formula(d, s, f);
  CHECK(f[0] > f0[0] + 1000.0);
  CHECK(f[4] < 0.0);
  memcpy(s, zero, sizeof s);
  s[1] = 0.02;
  formula(d, s, f);
  CHECK(f[1] < f0[1] - 1000.0);
  CHECK(f[5] > f0[5]);
  memcpy(s, zero, sizeof s);
  s[2] = 0.02;
  formula(d, s, f);
  CHECK(f[1] < f0[1]);
  CHECK_NEAR(f0[1], -427.0, 0.0, 1.0);
  test_free(d, m);
}

/* runs straight: to the side nothing moves, though each tyre pulls; and what it loses is work */
static void test_straight(void)
{
  maggi_model *m = cart();
  maggi_data *d = test_data(m);
  maggi_energy e;
  double s[48], start, vx;

  test_set(m, d, "bodies.chassis.joint.velocity.2", 0.0);
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  maggi_get_energy(d, &e);
  start = e.kinetic + e.potential;
  vx = test_get(d).v[2];
  CHECK_NEAR(vx, 10.0, 0.0, 0.0);
  test_step(d, 1e-3, 3000);
  maggi_get_energy(d, &e);
  CHECK_NEAR(e.kinetic + e.potential - e.work, start, 1e-7, 0.0);
  maggi_get_sensors(d, s);
  CHECK_NEAR(test_get(d).q[1], 0.0, 0.0, 1e-6);
  CHECK_NEAR(test_get(d).q[3], 0.0, 0.0, 1e-6);
  CHECK(test_get(d).v[2] < 10.0 && test_get(d).v[2] > 9.0);
  CHECK(s[6] < 0.0);                    /* fx brakes */
  CHECK_NEAR(s[7], -300.0, 0.0, 250.0); /* the pull of a left tyre */
  test_free(d, m);
}

/* a cart in the air falls freely, without forces of its tyres */
static void test_no_contact(void)
{
  maggi_model *m = cart();
  maggi_data *d = test_data(m);
  double s[48];
  int k;

  test_set(m, d, "roads.road.point.z", -0.5);
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  CHECK_NEAR(test_get(d).a[0], -9.81, 1e-14, 0.0);
  maggi_get_sensors(d, s);
  for (k = 6; k < 12; ++k) CHECK(s[k] == 0.0);
  test_step(d, 1e-3, 350);
  maggi_get_sensors(d, s);
  CHECK(s[8] > 0.0);
  test_free(d, m);
}

/* Fz of the loaded radius; on a slope the rest of the weight pulls down the slope */
static void test_slope(void)
{
  maggi_model *m = cart();
  maggi_data *d = test_data(m);
  double s[48], slope = 0.1, c = 1.0 / sqrt(1.0 + slope * slope);

  maggi_data_reset(d);
  maggi_get_sensors(d, s);
  CHECK_NEAR(s[8], 784944.0 * (0.548 - 0.533), 1e-12, 0.0);
  test_set(m, d, "roads.road.slope", slope);
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  maggi_get_sensors(d, s);
  CHECK_NEAR(s[8], fmax(0.0, 784944.0 * (0.548 - c * (0.533 - 1.5 * slope))), 1e-12, 0.0);
  test_free(d, m);
}

/* at rest there is a force for every speed, and no division by it */
static void test_rest(void)
{
  maggi_model *m = cart();
  maggi_data *d = test_data(m);
  static const char *const wheel[] = {"front_left", "front_right", "rear_left", "rear_right"};
  char path[80];
  int i;

  test_set(m, d, "bodies.chassis.joint.velocity.2", 0.0);
  test_set(m, d, "bodies.chassis.joint.velocity.3", 0.0);
  for (i = 0; i < 4; ++i) {
    snprintf(path, sizeof path, "bodies.%s.joint.velocity", wheel[i]);
    test_set(m, d, path, 0.0);
  }
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  test_step(d, 1e-3, 1000);
  CHECK(fabs(test_get(d).v[2]) < 0.05);
  test_free(d, m);
}

/* ------------------------------------------------------------------------------------- roads */

static maggi_model *obstacles(void)
{
  return test_file("wheeled-frame-obstacles.yaml");
}

/* height, its slope, and the slope of the plane of a wheel */
static void height(const maggi_data *d, int road, double x, double h[3])
{
  const maggi_topo *t = &d->t;

  maggi_road_height(t->roadkind[road], t->roadadr[road], t->roadn[road], t->roadspline[road], t->np,
                    d->p, t->nspline, (void *)d->spline0, x, h);
}

/* cylinders where they are given, level between them, and fillets that join both with two derivatives */
static void test_bumps(void)
{
  maggi_model *m = obstacles();
  maggi_data *d = test_start(m);
  const double c = sqrt(0.03 * (4.0 - 0.03)), f = 0.15, e = 1e-4;
  double at[3], low[3], high[3], x;
  int i, k, end;

  for (k = 0; k < 3; ++k) {
    height(d, 0, 4.0 + 5.0 * k, at);
    CHECK_NEAR(at[0], 0.03, 1e-13, 0.0);
    CHECK(at[1] == 0.0 && fabs(at[2]) < 1e-12);
    height(d, 0, 4.0 + 5.0 * k - 0.1, at);
    CHECK_NEAR(at[0], sqrt(4.0 - 0.01) - 1.97, 1e-12, 0.0);
    CHECK_NEAR(at[2], 0.1 / sqrt(4.0 - 0.01), 1e-12, 0.0);
    for (end = -1; end <= 1; end += 2) {
      height(d, 0, 4.0 + 5.0 * k + end * (c + f + 1e-9), at);
      CHECK(at[0] == 0.0 && at[1] == 0.0 && at[2] == 0.0);
      for (i = 0; i < 2; ++i) { /* both ends of a fillet: no jump of h, h', h'' */
        x = 4.0 + 5.0 * k + end * (c + (i ? f : -f));
        height(d, 0, x - e, low);
        height(d, 0, x, at);
        height(d, 0, x + e, high);
        CHECK_NEAR(high[0] + low[0] - 2.0 * at[0], 0.0, 0.0, 1e-8);
        CHECK_NEAR((high[0] - low[0]) / (2.0 * e), at[2], 0.0, 1e-7);
        CHECK_NEAR((high[2] - at[2]) / e, (at[2] - low[2]) / e, 0.0, 5e-3);
      }
      x = 4.0 + 5.0 * k + end * c;
      height(d, 0, x - e, low);
      height(d, 0, x, at);
      height(d, 0, x + e, high);
      CHECK(at[0] > 0.0 && at[0] < 0.02);
      CHECK_NEAR((high[0] - low[0]) / (2.0 * e), at[2], 0.0, 1e-7);
    }
  }
  for (x = 5.0; x < 8.0; x += 0.1) {
    height(d, 0, x, at);
    CHECK(at[0] == 0.0);
  }
  test_set(m, d, "roads.bumps.fillet", 0.0);
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  height(d, 0, 4.0 + c - 1e-6, at);
  CHECK_NEAR(at[0], 1e-6 * c / 1.97, 1e-5, 0.0);
  height(d, 0, 4.0 + c, at);
  CHECK(fabs(at[0]) < 1e-15);
  test_free(d, m);
}

/* through its points, with the slope that it has, straight on beyond them */
static void test_profile(void)
{
  static const double px[] = {-3, 0, 2, 3, 4.5, 6, 8, 11, 15};
  static const double pz[] = {0, 0, 0.004, 0.006, 0.015, 0.01, -0.01, 0.005, 0};
  maggi_model *m = obstacles();
  maggi_data *d = test_start(m);
  double at[3], low[3], high[3], x;
  int i;

  for (i = 0; i < 9; ++i) {
    height(d, 1, px[i], at);
    CHECK_NEAR(at[0], pz[i], 0.0, 1e-15);
  }
  for (x = -4.05; x < 17.0; x += 0.1) {
    height(d, 1, x - 1e-4, low);
    height(d, 1, x, at);
    height(d, 1, x + 1e-4, high);
    CHECK_NEAR((high[0] - low[0]) / 2e-4, at[1], 0.0, 1e-9);
    CHECK(at[2] == 0.0);
    if (x < px[0] || x > px[8]) CHECK_NEAR(high[1], low[1], 0.0, 1e-14);
    height(d, 2, x, at);
    CHECK_NEAR(at[0], (x + 3.0) * 0.05 / 33.0, 0.0, 1e-15);
    CHECK_NEAR(at[1], 0.05 / 33.0, 1e-13, 0.0);
  }
  test_free(d, m);
}

/* a bump pushes up by its height below the wheel, not back; dampers of tyres feel how it rises */
static void test_over_bump(void)
{
  maggi_model *m = obstacles();
  maggi_data *d = test_data(m);
  const double dx = 0.1, h = sqrt(4.0 - dx * dx) - 1.97, level = 784944.0 * (0.548 - 0.533);
  double s[15], rise;

  test_set(m, d, "roads.bumps.first", 1.5 + dx);
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  maggi_get_sensors(d, s);
  CHECK_NEAR(s[5], level + 784944.0 * h, 1e-11, 0.0);
  CHECK_NEAR(s[6], 0.015 + h, 1e-12, 0.0);
  CHECK_NEAR(s[7], 0.533 - h, 1e-13, 0.0);
  CHECK(s[8] > s[7] && s[8] < 0.548);
  test_set(m, d, "tyres.truck.vertical_damping", 1e3);
  CHECK(maggi_data_reset(d) == MAGGI_OK);
  maggi_get_sensors(d, s);
  rise = dx / sqrt(4.0 - dx * dx) * 10.0;
  CHECK_NEAR(s[5], level + 784944.0 * h + 1e3 * rise, 1e-10, 0.0);
  test_free(d, m);
}

/* slopes of the formula by central differences, on both sides of the vehicle; none in the air */
static void test_slopes(void)
{
  maggi_tyre_def def;
  char message[200];
  double slip[5] = {0.03, -0.06, 0.01, 27000.0, 12.0}, f[6], low[6], high[6], g[3], h = 1e-6;
  int k, side;

  CHECK(maggi_tyre_load(MAGGI_MODELS_DIR "/tyres/pac2002_315_80R22_5.tir", &def, message,
                        sizeof message) == MAGGI_OK);
  for (side = MAGGI_LEFT; side <= MAGGI_RIGHT; ++side) {
    for (k = 0; k < 2; ++k) {
      slip[k] += h;
      maggi_tyre_forces(&def, (maggi_side)side, slip, high, NULL);
      slip[k] -= 2.0 * h;
      maggi_tyre_forces(&def, (maggi_side)side, slip, low, NULL);
      slip[k] += h;
      maggi_tyre_forces(&def, (maggi_side)side, slip, f, g);
      CHECK_NEAR(g[1 - k], (high[k] - low[k]) / (2.0 * h), 1e-7, 0.0);
    }
    CHECK(g[0] < 0.0 && g[1] > 0.0 && g[2] > 0.1 && g[2] < 1.0);
  }
  slip[3] = 0.0;
  maggi_tyre_forces(&def, MAGGI_LEFT, slip, f, g);
  for (k = 0; k < 6; ++k) CHECK(f[k] == 0.0);
  for (k = 0; k < 3; ++k) CHECK(g[k] == 0.0);
  CHECK(maggi_tyre_load("none.tir", &def, message, sizeof message) == MAGGI_E_FILE);
  CHECK(strstr(message, "none.tir: cannot be opened") != NULL);
}

int main(void)
{
  test_bumps();
  test_profile();
  test_over_bump();
  test_slopes();
  test_reference();
  test_signs();
  test_straight();
  test_no_contact();
  test_slope();
  test_rest();
  return check_done();
}
