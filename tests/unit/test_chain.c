/* core/implicit/chain*.c, rest.c: w = Q - M z'' - Phi_z^T lambda is zero in the motion of the Maggi
 * formulation with its multipliers, and what M z'' and Phi_z^T lambda are; tangents against
 * differences, adjoints against tangents by the dot product. */
#include "chain.h"
#include "machine.h"

enum { W = MAGGI_NDIR };

static const double alpha = 300.0;

/* ----------------------------------------------------------------------------------- in motion */

static double largest(const double *x, int n)
{
  double y = 0.0;
  int i;

  for (i = 0; i < n; ++i) y = fmax(y, fabs(x[i]));
  return y;
}

/* nothing is left but what the guides give */
static void check_balance(maggi_model *m, double h, int steps)
{
  maggi_data *d = test_start(m);
  const maggi_topo *t = &d->t;
  double *lambda = calloc((size_t)t->nrow + 1, sizeof *lambda);
  double drive[TEST_COORDINATES_MAX], size;
  test_state s;
  int i, q;

  test_step(d, h, steps);
  maggi_evaluate(d, d->time); /* where a step was interpolated */
  s = test_get(d);
  maggi_get_drives(d, drive);
  maggi_get_multipliers(d, lambda);
  maggi_chain_forces(d, d->time);
  size = largest(d->w, t->nq);
  CHECK(size > 1e-2);
  for (i = 0; i < m->ncoordinate; ++i) d->v[m->coordinate[i].q] = s.v[i];
  for (i = 0; i < m->ncoordinate; ++i) d->a[m->coordinate[i].q] = s.a[i];
  maggi_chain_evaluate(d, d->time, 0.0);
  memcpy(d->lambda, lambda, (size_t)t->nrow * sizeof *lambda);
  maggi_chain_balance(d);
  for (i = 0; i < m->ncoordinate; ++i) {
    q = m->coordinate[i].q;
    CHECK_NEAR(d->w[q] + drive[i], 0.0, 0.0, 1e-12 * size);
  }
  free(lambda);
  test_free(d, m);
}

/* ----------------------------------------------------------------------- parts, loops are open */

/* a state that closes nothing */
static void disturb(maggi_data *d, unsigned long long *seed)
{
  int i;

  for (i = 0; i < d->t.nq; ++i) {
    d->q[i] += 0.1 * random11(seed);
    d->v[i] += random11(seed);
    d->a[i] += 3.0 * random11(seed);
  }
  d->time += 0.1;
}

static double half_square(const maggi_data *d)
{
  double sum = 0.0;
  int i;

  for (i = 0; i < d->t.nrow; ++i) sum += 0.5 * d->res[i] * d->res[i];
  return sum;
}

/* w by z'' is -M z'', w by alpha the gradient of -alpha Phi.Phi/2 */
static void check_parts(maggi_model *m)
{
  maggi_data *d = test_start(m);
  const maggi_topo *t = &d->t;
  double *w = calloc(4 * (size_t)t->nq + 1, sizeof *w), *x = w + t->nq, *q = x + t->nq,
         *rows = q + t->nq, size, g;
  unsigned long long seed = 8;
  int i, k;

  disturb(d, &seed);
  maggi_chain_evaluate(d, d->time, 0.0);
  memcpy(w, d->w, (size_t)t->nq * sizeof *w);
  memset(rows, 0, (size_t)t->nq * sizeof *w);
  for (i = 0; i < t->nq; ++i) x[i] = random11(&seed);
  maggi_composite_inertias(t, d->p, (void *)d->r, (void *)d->I, d->IS);
  maggi_mass_matrix(t, d->p, (void *)d->b, (void *)d->r, (void *)d->IS, d->Fb, d->rodjac, d->M);
  for (k = 0; k < t->npair; ++k) {
    rows[t->pairi[k]] += d->M[k] * x[t->pairj[k]];
    if (t->pairi[k] != t->pairj[k]) rows[t->pairj[k]] += d->M[k] * x[t->pairi[k]];
  }
  for (i = 0; i < t->nq; ++i) d->a[i] += x[i];
  maggi_chain_accelerate(d, 0.0);
  size = largest(d->w, t->nq);
  for (i = 0; i < t->nq; ++i) CHECK_NEAR(d->w[i] - w[i], -rows[i], 0.0, 1e-13 * size);

  memset(d->a, 0, (size_t)t->nq * sizeof *d->a);
  maggi_chain_accelerate(d, 0.0);
  memcpy(w, d->w, (size_t)t->nq * sizeof *w);
  maggi_chain_forces(d, d->time);
  for (i = 0; i < t->nq; ++i) {
    CHECK(t->nguide > 0 || d->w[i] == w[i]);
    if (t->nguide > 0) CHECK_NEAR(d->w[i], w[i], 0.0, 1e-13 * size);
  }

  memset(d->a, 0, (size_t)t->nq * sizeof *d->a);
  maggi_chain_accelerate(d, alpha);
  for (i = 0; i < t->nq; ++i) w[i] = d->w[i] - w[i];
  memcpy(q, d->q, (size_t)t->nq * sizeof *q);
  for (i = 0; i < t->nq; ++i) {
    if (t->qguide[i] >= 0) continue;
    for (g = 0.0, k = 1; k >= -1; k -= 2) {
      d->q[i] = q[i] + 1e-5 * k;
      maggi_evaluate_positions(d, d->time);
      g += k * half_square(d) / 2e-5;
    }
    d->q[i] = q[i];
    CHECK_NEAR(w[i], -alpha * g, 0.0, 1e-7 * alpha);
  }
  CHECK(t->nrow == 0 || largest(w, t->nq) > 1e-3 * alpha);
  free(w);
  test_free(d, m);
}

/* ---------------------------------------------------------------------------------- derivatives */

/* what a pass computes from positions, velocities, accelerations and parameters */
typedef enum pass { FORCES, BALANCE, RATES, GAMMA, PASSES } pass;

static int outputs(const maggi_data *d, pass way)
{
  return way == FORCES || way == BALANCE ? d->t.nq : d->t.nrow;
}

static const double *evaluate(maggi_data *d, pass way)
{
  const maggi_topo *t = &d->t;

  if (way == FORCES) {
    maggi_chain_forces(d, d->time);
    return d->w;
  }
  maggi_chain_evaluate(d, d->time, alpha);
  maggi_point_accelerations(t, 0, t->npointdyn, (void *)d->r, (void *)d->rv, (void *)d->Z,
                            (void *)d->Za, d->ra);
  maggi_loop_rates(t, d->prim0, (void *)d->r, (void *)d->dir, (void *)d->rv, (void *)d->Z, d->rate);
  maggi_loop_gamma(t, d->prim0, (void *)d->r, (void *)d->dir, (void *)d->rv, (void *)d->ra,
                   (void *)d->Z, (void *)d->Za, d->gama);
  return way == BALANCE ? d->w : way == RATES ? d->rate : d->gama;
}

static const double *strip(maggi_derivative *D, pass way)
{
  if (way == FORCES) {
    maggi_strip_forces(D);
    return D->strip.w;
  }
  if (way == BALANCE) {
    maggi_strip_balance(D, alpha);
    return D->strip.w;
  }
  maggi_strip_positions(D);
  maggi_strip_rates(D);
  if (way == GAMMA) maggi_strip_gamma(D);
  return way == RATES ? D->strip.rate : D->strip.gama;
}

/* adjoints of q, v, a, p; of guided coordinates none */
static void adjoint(maggi_derivative *D, pass way, const double *bar, double *p)
{
  const maggi_companion *s = &D->adjoint;
  double *out[] = {s->w, s->w, s->rate, s->gama};
  int i;

  maggi_companion_clear(s);
  maggi_parameters_clear(D);
  memcpy(out[way], bar, (size_t)outputs(D->d, way) * sizeof *bar);
  if (way == FORCES) maggi_adjoint_forces(D);
  if (way == BALANCE) maggi_adjoint_balance(D, alpha);
  if (way == RATES) maggi_adjoint_rates_of(D);
  if (way == GAMMA) maggi_adjoint_gamma(D);
  if (way != FORCES) maggi_adjoint_positions(D);
  maggi_parameters_vjp(D, p);
  for (i = 0; i < D->d->t.nq; ++i)
    if (D->d->t.qguide[i] >= 0) s->q[i] = s->v[i] = s->a[i] = 0.0;
}

typedef struct directions {
  double *q, *v, *a, *p; /* (.. x W), in one memory */
} directions;

/* directions of parameters in their size: those that are 0 in that of 0.1 */
static directions choose(const maggi_data *d, int with_parameters)
{
  const maggi_topo *t = &d->t;
  directions x;
  unsigned long long seed = 21;
  int i, c;

  x.q = calloc((3 * (size_t)t->nq + (size_t)t->np) * W + 1, sizeof(double));
  if (!x.q) exit(1);
  x.v = x.q + t->nq * W;
  x.a = x.v + t->nq * W;
  x.p = x.a + t->nq * W;
  for (i = 0; i < t->nq; ++i) {
    for (c = 0; c < W && t->qguide[i] < 0; ++c) {
      x.q[i * W + c] = random11(&seed);
      x.v[i * W + c] = random11(&seed);
      x.a[i * W + c] = random11(&seed);
    }
  }
  for (i = 0; i < t->np && with_parameters; ++i)
    for (c = 0; c < W; ++c) x.p[i * W + c] = (fabs(d->p[i]) + 0.1) * random11(&seed);
  return x;
}

/* central difference along direction c, extrapolated from two steps */
static void differentiate(maggi_data *d, pass way, const directions *x, int c, double *out)
{
  static const double step[] = {4e-4, 2e-4}, weight[] = {-1.0 / 3.0, 4.0 / 3.0};
  const maggi_topo *t = &d->t;
  int n = outputs(d, way), i, k, sign;
  const double *y;
  double *p = malloc(((size_t)t->np + 3 * (size_t)t->nq + 1) * sizeof *p), *q = p + t->np, h;

  memcpy(p, d->p, (size_t)t->np * sizeof *p);
  memcpy(q, d->q, (size_t)t->nq * sizeof *q);
  memcpy(q + t->nq, d->v, (size_t)t->nq * sizeof *q);
  memcpy(q + 2 * t->nq, d->a, (size_t)t->nq * sizeof *q);
  memset(out, 0, (size_t)n * sizeof *out);
  for (k = 0; k < 2; ++k) {
    for (sign = 1; sign >= -1; sign -= 2) {
      h = sign * step[k];
      for (i = 0; i < t->np; ++i) d->p[i] = p[i] + h * x->p[i * W + c];
      maggi_constants(d);
      for (i = 0; i < t->nq; ++i) {
        d->q[i] = q[i] + h * x->q[i * W + c];
        d->v[i] = q[t->nq + i] + h * x->v[i * W + c];
        d->a[i] = q[2 * t->nq + i] + h * x->a[i * W + c];
      }
      y = evaluate(d, way);
      for (i = 0; i < n; ++i) out[i] += weight[k] * y[i] / (2.0 * h);
    }
  }
  memcpy(d->p, p, (size_t)t->np * sizeof *p);
  maggi_constants(d);
  memcpy(d->q, q, (size_t)t->nq * sizeof *q);
  memcpy(d->v, q + t->nq, (size_t)t->nq * sizeof *q);
  memcpy(d->a, q + 2 * t->nq, (size_t)t->nq * sizeof *q);
  evaluate(d, way);
  free(p);
}

static double dot(const double *x, const double *y, int n, int stride)
{
  double sum = 0.0;
  int i;

  for (i = 0; i < n; ++i) sum += x[i] * y[i * stride];
  return sum;
}

static void load(maggi_derivative *D, const directions *x)
{
  size_t row = W * sizeof(double), nq = (size_t)D->d->t.nq;

  memcpy(D->strip.q, x->q, nq * row);
  memcpy(D->strip.v, x->v, nq * row);
  memcpy(D->strip.a, x->a, nq * row);
  memcpy(D->strip.p, x->p, (size_t)D->d->t.np * row);
  maggi_strip_constants(D);
}

static void check_pass(const char *name, maggi_data *d, pass way)
{
  const maggi_topo *t = &d->t;
  int n = outputs(d, way), c, i;
  directions x = choose(d, way != FORCES);
  maggi_derivative *D;
  const double *y;
  double *out = calloc((size_t)n + 1, sizeof *out), *bar = calloc((size_t)n + 1, sizeof *bar);
  double *p = calloc((size_t)t->np + 1, sizeof *p), size = 0.0, left, right;
  unsigned long long seed = 33;

  if (!CHECK(maggi_derivative_create(d, 0, &D) == MAGGI_OK)) exit(1);
  D->time = d->time;
  evaluate(d, way);
  load(D, &x);
  y = strip(D, way);
  size = largest(y, n * W);
  if (!CHECK(n == 0 || size > 1e-2)) fprintf(stderr, "  %s: pass %d\n", name, way);
  for (c = 0; c < 3; ++c) {
    differentiate(d, way, &x, c, out);
    for (i = 0; i < n; ++i)
      if (!CHECK_NEAR(y[i * W + c], out[i], 0.0, 1e-9 * size))
        fprintf(stderr, "  %s: pass %d, output %d\n", name, way, i);
  }
  for (i = 0; i < n; ++i) bar[i] = random11(&seed);
  adjoint(D, way, bar, p);
  for (c = 0; c < W; ++c) {
    left = dot(bar, y + c, n, W);
    right = dot(D->adjoint.q, x.q + c, t->nq, W) + dot(D->adjoint.v, x.v + c, t->nq, W) +
            dot(D->adjoint.a, x.a + c, t->nq, W) + dot(p, x.p + c, t->np, W);
    if (!CHECK_NEAR(left, right, 0.0, 1e-13 * size))
      fprintf(stderr, "  %s: pass %d, direction %d\n", name, way, c);
  }
  maggi_derivative_free(D);
  free(x.q);
  free(out);
  free(bar);
  free(p);
}

/* bodies at rest but for z'': w = -M x - Phi^T lambda, and its tangent by x, lambda and
 * positions */
static void check_rest(maggi_data *d)
{
  const maggi_topo *t = &d->t;
  directions x = choose(d, 1);
  double *base = calloc(3 * ((size_t)t->nq + 1) + (size_t)t->nrow, sizeof *base);
  double *at = base + t->nq, *w = at + t->nq, *lambda = w + t->nq, *bar, *p, *rows, left, right, f,
         size;
  static const double step[] = {4e-4, 2e-4}, weight[] = {-1.0 / 3.0, 4.0 / 3.0};
  unsigned long long seed = 77;
  maggi_derivative *D;
  maggi_rest rest;
  int i, k, c, sign;

  if (!CHECK(maggi_derivative_create(d, 0, &D) == MAGGI_OK)) exit(1);
  if (!CHECK(maggi_rest_create(d, D, &rest) == MAGGI_OK)) exit(1);
  maggi_chain_evaluate(d, d->time, alpha);
  for (i = 0; i < t->nq; ++i) rest.data.a[i] = at[i] = random11(&seed);
  for (i = 0; i < t->nrow; ++i) rest.data.lambda[i] = lambda[i] = random11(&seed);

  /* differences of the balance of the simulation itself */
  memcpy(base, d->w, (size_t)t->nq * sizeof *base);
  for (i = 0; i < t->nq; ++i) d->a[i] += at[i];
  for (i = 0; i < t->nrow; ++i) d->lambda[i] += lambda[i];
  maggi_chain_balance(d);
  maggi_rest_evaluate(&rest);
  size = largest(d->w, t->nq);
  for (i = 0; i < t->nq; ++i) CHECK_NEAR(rest.data.w[i], d->w[i] - base[i], 0.0, 1e-12 * size);

  D->time = d->time;
  load(D, &x);
  maggi_strip_positions(D);
  maggi_rest_choose(D, &rest);
  memcpy(rest.strip.a, x.a, (size_t)t->nq * W * sizeof(double));
  rows = calloc((size_t)t->nrow * W + 1, sizeof *rows);
  for (i = 0; i < t->nrow * W; ++i) rows[i] = rest.strip.lambda[i] = random11(&seed);
  maggi_strip_rest(D, &rest);
  memcpy(base, d->q, (size_t)t->nq * sizeof *base);
  memset(w, 0, (size_t)t->nq * sizeof *w);
  p = malloc(((size_t)t->np + 1) * sizeof *p);
  memcpy(p, d->p, (size_t)t->np * sizeof *p);
  for (k = 0; k < 2; ++k) {
    for (sign = 1; sign >= -1; sign -= 2) {
      f = sign * step[k];
      for (i = 0; i < t->np; ++i) d->p[i] = p[i] + f * x.p[i * W];
      maggi_constants(d);
      for (i = 0; i < t->nq; ++i) d->q[i] = base[i] + f * x.q[i * W];
      maggi_chain_evaluate(d, d->time, alpha);
      for (i = 0; i < t->nq; ++i) rest.data.a[i] = at[i] + f * x.a[i * W];
      for (i = 0; i < t->nrow; ++i) rest.data.lambda[i] = lambda[i] + f * rows[i * W];
      maggi_rest_evaluate(&rest);
      for (i = 0; i < t->nq; ++i) w[i] += weight[k] * rest.data.w[i] / (2.0 * f);
    }
  }
  size = largest(rest.strip.w, t->nq * W);
  for (i = 0; i < t->nq; ++i) CHECK_NEAR(rest.strip.w[i * W], w[i], 0.0, 1e-9 * size);

  memcpy(d->p, p, (size_t)t->np * sizeof *p);
  maggi_constants(d);
  memcpy(d->q, base, (size_t)t->nq * sizeof *base);
  maggi_chain_evaluate(d, d->time, alpha);
  memcpy(rest.data.a, at, (size_t)t->nq * sizeof *at);
  memcpy(rest.data.lambda, lambda, (size_t)t->nrow * sizeof *lambda);
  maggi_rest_evaluate(&rest);
  bar = w;
  for (k = 0; k < 2; ++k) { /* the second time after a clear */
    maggi_companion_clear(&D->adjoint);
    maggi_parameters_clear(D);
    maggi_rest_clear(&rest);
    for (i = 0; i < t->nq; ++i) rest.adjoint.w[i] = bar[i] = random11(&seed);
    maggi_adjoint_rest(D, &rest);
  }
  maggi_adjoint_positions(D);
  maggi_parameters_vjp(D, p);
  for (i = 0; i < t->nq; ++i)
    if (t->qguide[i] >= 0) D->adjoint.q[i] = 0.0;
  for (c = 0; c < W; ++c) {
    left = dot(bar, rest.strip.w + c, t->nq, W);
    right = dot(rest.adjoint.a, x.a + c, t->nq, W) +
            dot(rest.adjoint.lambda, rows + c, t->nrow, W) + dot(D->adjoint.q, x.q + c, t->nq, W) +
            dot(p, x.p + c, t->np, W);
    CHECK_NEAR(left, right, 0.0, 1e-13 * size);
  }
  maggi_rest_free(&rest);
  maggi_derivative_free(D);
  free(base);
  free(rows);
  free(p);
  free(x.q);
}

static void check_derivatives(const char *name, maggi_model *m)
{
  maggi_data *d = test_start(m);
  unsigned long long seed = 13;
  int way;

  disturb(d, &seed);
  for (way = 0; way < PASSES; ++way) check_pass(name, d, (pass)way);
  check_rest(d);
  test_free(d, m);
}

int main(void)
{
  static const char *const name[] = {"double-pendulum.yaml",
                                     "four-bar.yaml",
                                     "rssr.yaml",
                                     "bricard.yaml",
                                     "triple-pendulum-closed.yaml",
                                     "spatial-four-bar-spring.yaml",
                                     "n-four-bar-2.yaml"};
  size_t i;

  for (i = 0; i < sizeof name / sizeof *name; ++i) {
    check_balance(test_file(name[i]), 1e-3, 50);
    check_parts(test_file(name[i]));
    check_derivatives(name[i], test_file(name[i]));
  }
  check_balance(machine_model(), 1e-3, 50);
  check_parts(machine_model());
  check_derivatives("machine", machine_model());
  return check_done();
}
