/* Wheels: derivatives by each number alone, against complex step, of slips, forces and slopes: by every
 * number of the tyre, of the road and of what the slip follows from.  Along random directions, as in
 * derivative_heads.c, small numbers hide behind large ones. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "call.h"
#include "fixture.h"

/* of an output; a wrench at P is a sum of larger ones, so all six numbers count */
static double size_of(const call *c, int j, int m)
{
  double size = 0.0;
  int k;

  if (strcmp(c->head->arg[j].name, "F") != 0) return fabs(c->y.of[j][m]);
  for (k = 0; k < 6; ++k) size = fmax(size, fabs(c->y.of[j][m / 6 * 6 + k]));
  return size;
}

/* largest change of an output per relative change of all arguments, of SHAKES shaken calls */
enum { SHAKES = 4 };

static double change_of(const call *c, const call s[], int j, int m)
{
  double change = 0.0;
  int i;

  for (i = 0; i < SHAKES; ++i) change = fmax(change, fabs(s[i].y.of[j][m] - c->y.of[j][m]));
  return change / CALL_TREMOR;
}

/* whether number k of argument i moves the speeds that make a slip */
static int is_motion(const call *c, int i, int k)
{
  const char *name = c->head->arg[i].name;
  int w;

  if (strcmp(name, "p") != 0) return strcmp(name, "slip") != 0 && strcmp(name, "grip") != 0;
  for (w = 0; w < c->t->nwheel; ++w)
    if (k >= c->t->wheelaxis[w] && k < c->t->wheelaxis[w] + 3) return 1;
  return 0;
}

/* Largest error of the derivatives by number k of argument i, each relative to itself, to its output, and
 * to how much it depends on the last digits of the arguments (arguments_distance): s is c, shaken.
 *
 * The longitudinal slip of a wheel that rolls freely is 5e-5, the difference of two speeds, and its
 * slope 2e5 N.  Derivatives by what moves the speeds are such differences too, wrong by some
 * roundings of the terms: there an output counts with a part in 1e2 of what it changes by when its
 * arguments change by themselves, so that 1e-14 of that is allowed. */
static double error_of(const call *c, const call s[], int i, int k)
{
  arguments xd = arguments_create(c, 1), yd = arguments_create(c, 1), y = arguments_create(c, 1);
  arguments right = arguments_create(c, 1), shaken = arguments_create(c, 1);
  double worst = 0.0, size, scale = fabs(c->x.of[i][k]) + 1.0;
  int j, m;

  xd.of[i][k] = 1.0;
  call_tangent(c, &xd, &yd);
  call_tangent(s, &xd, &shaken);
  call_complex_tangent(c, &xd, &y, &right);
  for (j = 0; j < c->head->narg; ++j) {
    for (m = 0; call_is_output(c, j) && m < call_size(c, j); ++m) {
      size = size_of(c, j, m) + 1.0;
      if (is_motion(c, i, k)) size += 1e-2 * change_of(c, s, j, m);
      size = fabs(right.of[j][m]) + size / scale +
             0.1 / CALL_TREMOR * fabs(shaken.of[j][m] - yd.of[j][m]);
      if (!(fabs(yd.of[j][m] - right.of[j][m]) <= worst * size))
        worst = fabs(yd.of[j][m] - right.of[j][m]) / size;
    }
  }
  arguments_free(c, &xd);
  arguments_free(c, &yd);
  arguments_free(c, &y);
  arguments_free(c, &right);
  arguments_free(c, &shaken);
  return worst;
}

static int head_of(const char *name)
{
  int i;

  for (i = 0; i < maggi_nhead; ++i)
    if (strcmp(maggi_heads[i].name, name) == 0) return i;
  abort();
}

/* by every number of the arguments with one of these names */
static void check_head(const maggi_data *d, const char *head, const char *const names[])
{
  int index = head_of(head), i, j, k;
  inputs in;
  call c, shaken[SHAKES];

  inputs_real(&in, d);
  CHECK(call_create(&c, &maggi_heads[index], index, &in, 1));
  for (i = 0; i < SHAKES; ++i) shaken[i] = call_shaken(&c);
  for (i = 0; i < c.head->narg; ++i) {
    for (j = 0; names[j] && strcmp(names[j], c.head->arg[i].name) != 0; ++j) continue;
    for (k = 0; names[j] && k < call_size(&c, i); ++k)
      if (!CHECK_NEAR(error_of(&c, shaken, i, k), 0.0, 0.0, 1e-12))
        fprintf(stderr, "%s: %s %d\n", head, names[j], k);
  }
  for (i = 0; i < SHAKES; ++i) call_free(&shaken[i]);
  call_free(&c);
  inputs_free(&in);
}

static void check_model(const char *file)
{
  static const char *const wheels[] = {"p", "A", "Z", "r", "rv", NULL};
  static const char *const sensors[] = {"p", "slip", "grip", NULL};
  maggi_model *m = test_file(file);
  maggi_data *d = test_start(m);
  int n;

  for (n = 0; n < 3; ++n) {
    maggi_results(d);
    check_head(d, "maggi_wheel_forces", wheels);
    check_head(d, "maggi_sensors", sensors);
    test_step(d, 1e-3, 200);
  }
  test_free(d, m);
}

int main(void)
{
  check_model("wheeled-frame.yaml");
  check_model("wheeled-frame-waves.yaml");
  check_model("wheeled-frame-obstacles.yaml");
  return check_done();
}
