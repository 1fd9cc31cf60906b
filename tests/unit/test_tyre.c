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
  double s[12], start, vx;

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
  double s[12];
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
  double s[12], slope = 0.1, c = 1.0 / sqrt(1.0 + slope * slope);

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

int main(void)
{
  test_reference();
  test_signs();
  test_straight();
  test_no_contact();
  test_slope();
  test_rest();
  return check_done();
}
