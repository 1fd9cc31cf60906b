#include "call.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reference.h"

int call_size(const call *c, int i)
{
  return c->head->arg[i].size(c->t);
}

int call_is_active(const call *c, int i)
{
  return c->head->arg[i].role != MAGGI_HEAD_PASSIVE;
}

int call_is_output(const call *c, int i)
{
  return c->head->arg[i].role == MAGGI_HEAD_OUTPUT;
}

/* ----------------------------------------------------------------------------------- arguments */

static void *room(size_t bytes)
{
  void *a = aligned_alloc(64, (bytes + 127) / 64 * 64);

  if (!a) abort();
  memset(a, 0, (bytes + 127) / 64 * 64);
  return a;
}

arguments arguments_create(const call *c, int width)
{
  arguments a;
  int i;

  memset(&a, 0, sizeof a);
  for (i = 0; i < c->head->narg; ++i)
    a.of[i] = room((size_t)call_size(c, i) * (size_t)width * sizeof(double));
  return a;
}

void arguments_free(const call *c, arguments *a)
{
  int i;

  for (i = 0; i < c->head->narg; ++i) free(a->of[i]);
}

void arguments_copy(const call *c, const arguments *from, arguments *to)
{
  int i;

  for (i = 0; i < c->head->narg; ++i)
    memcpy(to->of[i], from->of[i], (size_t)call_size(c, i) * sizeof(double));
}

void arguments_random(call *c, double scale, arguments *a)
{
  int i, k;

  for (i = 0; i < c->head->narg; ++i)
    for (k = 0; call_is_active(c, i) && k < call_size(c, i); ++k)
      a->of[i][k] = mech_uniform(&c->random, -scale, scale);
}

void arguments_shake(call *c, const arguments *from, arguments *to)
{
  int i, k;

  for (i = 0; i < c->head->narg; ++i)
    for (k = 0; k < call_size(c, i); ++k)
      to->of[i][k] = from->of[i][k] * (1.0 + mech_uniform(&c->random, -CALL_TREMOR, CALL_TREMOR));
}

double arguments_dot(const call *c, const arguments *a, const arguments *b, double *terms)
{
  double sum = 0.0;
  int i, k;

  for (i = 0; i < c->head->narg; ++i) {
    for (k = 0; call_is_active(c, i) && k < call_size(c, i); ++k) {
      sum += a->of[i][k] * b->of[i][k];
      *terms += fabs(a->of[i][k] * b->of[i][k]);
    }
  }
  return sum;
}

/* largest of |a - b|, of |a| when b is NULL */
static double largest(int n, const double *a, const double *b)
{
  double y = 0.0, x;
  int k;

  for (k = 0; k < n; ++k) {
    x = b ? a[k] - b[k] : a[k];
    if (!isfinite(x)) return INFINITY;
    y = fmax(y, fabs(x));
  }
  return y;
}

double arguments_distance(const call *c, const arguments *a, const arguments *b,
                          const arguments *shaken)
{
  double worst = 0.0, most = 0.0, error, size;
  int i, n;

  for (i = 0; i < c->head->narg; ++i)
    if (call_is_active(c, i)) most = fmax(most, largest(call_size(c, i), b->of[i], NULL));
  for (i = 0; i < c->head->narg; ++i) {
    if (!call_is_active(c, i)) continue;
    n = call_size(c, i);
    error = largest(n, a->of[i], b->of[i]);
    if (isinf(error)) return error;
    size = fmax(largest(n, b->of[i], NULL), 1e-3 * most);
    if (shaken) size += 0.1 * largest(n, shaken->of[i], b->of[i]) / CALL_TREMOR;
    worst = fmax(worst, error > 0.0 ? error / size : 0.0);
  }
  return worst;
}

/* ---------------------------------------------------------------------------------------- calls */

int call_create(call *c, const maggi_head *head, int index, inputs *in, uint64_t seed)
{
  const double *from;
  int i, k, ok = 1;

  memset(c, 0, sizeof *c);
  c->head = head;
  c->t = in->t;
  c->index = index;
  c->random.state = seed;
  c->x = arguments_create(c, 1);
  c->y = arguments_create(c, 1);
  for (i = 0; i < c->head->narg; ++i) {
    c->written[i] = room((size_t)call_size(c, i));
    for (k = 0; k < call_size(c, i); ++k) c->x.of[i][k] = NAN;
    if (call_is_output(c, i)) continue;
    from = inputs_get(in, c->head->arg[i].name, call_size(c, i));
    if (from) memcpy(c->x.of[i], from, (size_t)call_size(c, i) * sizeof(double));
    ok = ok && from;
  }
  /* what is still not a number after the call has not been written */
  arguments_copy(c, &c->x, &c->y);
  c->head->f(c->t, c->y.of);
  for (i = 0; i < c->head->narg; ++i) {
    for (k = 0; call_is_output(c, i) && k < call_size(c, i); ++k) {
      c->written[i][k] = !isnan(c->y.of[i][k]);
      c->x.of[i][k] = mech_uniform(&c->random, -1.0, 1.0);
      if (!c->written[i][k]) c->y.of[i][k] = c->x.of[i][k];
    }
  }
  return ok;
}

call call_shaken(call *c)
{
  call s = *c;

  s.x = arguments_create(c, 1);
  s.y = arguments_create(c, 1);
  memset(s.written, 0, sizeof s.written);
  arguments_shake(c, &c->x, &s.x);
  arguments_copy(&s, &s.x, &s.y);
  s.head->f(s.t, s.y.of);
  return s;
}

void call_free(call *c)
{
  int i;

  arguments_free(c, &c->x);
  arguments_free(c, &c->y);
  for (i = 0; i < c->head->narg; ++i) free(c->written[i]);
}

void call_evaluate(const call *c, double h, const arguments *xd, arguments *y)
{
  int i, k;

  arguments_copy(c, &c->x, y);
  for (i = 0; i < c->head->narg; ++i)
    for (k = 0; call_is_active(c, i) && k < call_size(c, i); ++k) y->of[i][k] += h * xd->of[i][k];
  c->head->f(c->t, y->of);
}

/* Derivatives get copies of the values: generated code may compute them once more. */

void call_tangent(const call *c, const arguments *xd, arguments *yd)
{
  arguments y = arguments_create(c, 1);

  arguments_copy(c, &c->y, &y);
  arguments_copy(c, xd, yd);
  c->head->d(c->t, y.of, yd->of);
  arguments_free(c, &y);
}

void call_tangents(const call *c, const arguments *xdv, arguments *ydv)
{
  arguments y = arguments_create(c, 1);
  int i;

  arguments_copy(c, &c->y, &y);
  for (i = 0; i < c->head->narg; ++i)
    memcpy(ydv->of[i], xdv->of[i], (size_t)call_size(c, i) * MAGGI_NDIR * sizeof(double));
  c->head->dv(c->t, y.of, ydv->of);
  arguments_free(c, &y);
}

void call_adjoint(const call *c, const arguments *yb, arguments *xb)
{
  arguments y = arguments_create(c, 1);

  arguments_copy(c, &c->y, &y);
  arguments_copy(c, yb, xb);
  c->head->b(c->t, y.of, xb->of);
  arguments_free(c, &y);
}

void call_second(const call *c, const arguments *yd, const arguments *yb, const arguments *ybd,
                 arguments *xb, arguments *xbd)
{
  arguments y = arguments_create(c, 1), tangent = arguments_create(c, 1);

  arguments_copy(c, &c->y, &y);
  arguments_copy(c, yd, &tangent);
  arguments_copy(c, yb, xb);
  arguments_copy(c, ybd, xbd);
  c->head->b_d(c->t, y.of, tangent.of, xb->of, xbd->of);
  arguments_free(c, &y);
  arguments_free(c, &tangent);
}

/* --------------------------------------------------------------------------------- complex step */

typedef struct complex_arguments {
  reference_number *of[CALL_ARGUMENTS];
} complex_arguments;

/* x + i h x' */
static complex_arguments complex_create(const call *c, const arguments *x, const arguments *xd)
{
  complex_arguments z;
  int i, k;

  for (i = 0; i < c->head->narg; ++i) {
    z.of[i] = room((size_t)call_size(c, i) * sizeof(reference_number));
    for (k = 0; k < call_size(c, i); ++k)
      z.of[i][k] = x->of[i][k] + _Complex_I * REFERENCE_STEP * xd->of[i][k];
  }
  return z;
}

static void complex_free(const call *c, complex_arguments *z)
{
  int i;

  for (i = 0; i < c->head->narg; ++i) free(z->of[i]);
}

static void complex_parts(const call *c, const complex_arguments *z, arguments *x, arguments *xd)
{
  int i, k;

  for (i = 0; i < c->head->narg; ++i) {
    for (k = 0; k < call_size(c, i); ++k) {
      x->of[i][k] = (double)creall(z->of[i][k]);
      xd->of[i][k] = (double)(cimagl(z->of[i][k]) / REFERENCE_STEP);
    }
  }
}

void call_complex_tangent(const call *c, const arguments *xd, arguments *y, arguments *yd)
{
  complex_arguments z = complex_create(c, &c->x, xd);

  reference_head(c->index, c->t, z.of);
  complex_parts(c, &z, y, yd);
  complex_free(c, &z);
}

void call_complex_second(const call *c, const arguments *xd, const arguments *yb,
                         const arguments *ybd, arguments *xb, arguments *xbd)
{
  complex_arguments z = complex_create(c, &c->x, xd), w = complex_create(c, yb, ybd);

  reference_head(c->index, c->t, z.of);
  reference_adjoint(c->index, c->t, z.of, w.of);
  complex_parts(c, &w, xb, xbd);
  complex_free(c, &z);
  complex_free(c, &w);
}
