/* Every head of tools/tapenade/heads.txt, on every mechanism, with the arguments of a real evaluation
 * and with random ones (call.h has the notation):
 *
 *   tangent     against complex step
 *   vector      each direction of _dv against _d
 *   adjoint     y'.y_ = x'.x_, of random numbers everywhere
 *   garbage     what the adjoint adds to x_ does not depend on what is there
 *   difference  central differences at steps h and h/2: the error at h/2
 *   order       that error over the one at h: a quarter
 *   second      _b_d against complex step of _b
 *   symmetry    u.H w = w.H u
 *
 * Errors are relative to the largest number of an array and to how much it depends on changes of the
 * arguments in their last digits (arguments_distance); those of sums to their terms.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "call.h"
#include "check.h"
#include "sample.h"

enum { HEADS = 64 };

#define KIND_LIST(X)                                                                               \
  X(TANGENT, "tangent", 1e-12)                                                                     \
  X(VECTOR, "vector", 1e-12)                                                                       \
  X(ADJOINT, "adjoint", 1e-13)                                                                     \
  X(GARBAGE, "garbage", 1e-12)                                                                     \
  X(DIFFERENCE, "difference", 1e-4)                                                                \
  X(ORDER, "order", 0.3)                                                                           \
  X(SECOND, "second", 1e-11)                                                                       \
  X(SYMMETRY, "symmetry", 1e-13)

enum {
#define X(kind, text, limit) kind,
  KIND_LIST(X)
#undef X
      KINDS
};

static const char *const kind_text[] = {
#define X(kind, text, limit) text,
    KIND_LIST(X)
#undef X
};

static const double kind_limit[] = {
#define X(kind, text, limit) limit,
    KIND_LIST(X)
#undef X
};

static struct {
  long cases;
  double worst[KINDS];
  int moves[CALL_ARGUMENTS]; /* an input: moves some output; an output: is moved by some input */
  int bends;                 /* some second derivative is not zero */
} table[HEADS];

/* sums of their arguments, without second derivatives */
static const char *const linear[] = {"maggi_accumulate"};

/* for messages */
static const char *sample_name;

/* ------------------------------------------------------------------------------------- results */

static void residual(const call *c, int kind, double error)
{
  double *worst = &table[c->index].worst[kind], limit = check_scale() * kind_limit[kind];

  ++check_count;
  if (!(error <= *worst)) *worst = error;
  if (check_scale() == 0.0)
    printf("%s: %s: %s: residual %.3g, limit %.3g\n", sample_name, c->head->name, kind_text[kind],
           error, kind_limit[kind]);
  else if (!(error <= limit) && check_fail())
    fprintf(stderr, "%s: %s: %s: residual %.3g exceeds %.3g\n", sample_name, c->head->name,
            kind_text[kind], error, limit);
}

static void so(const call *c, const char *what, int ok)
{
  ++check_count;
  if (!ok && check_fail())
    fprintf(stderr, "%s: %s: not so: %s\n", sample_name, c->head->name, what);
}

/* an identity of sums, relative to their terms */
static void identity(const call *c, int kind, double left, double right, double terms)
{
  double error = fabs(left - right);

  residual(c, kind, error > 0.0 ? error / terms : error);
}

/* -------------------------------------------------------------------------------------- tangent */

static void check_tangent(call *c, const arguments *xd, const arguments *yd)
{
  call s = call_shaken(c);
  arguments y = arguments_create(c, 1), right = arguments_create(c, 1);
  arguments sxd = arguments_create(c, 1), syd = arguments_create(c, 1);

  arguments_shake(c, xd, &sxd);
  call_tangent(&s, &sxd, &syd);
  call_complex_tangent(c, xd, &y, &right);
  residual(c, TANGENT, arguments_distance(c, yd, &right, &syd));
  so(c, "complex numbers have the same value", arguments_distance(c, &c->y, &y, &s.y) < 1e-12);
  call_free(&s);
  arguments_free(c, &y);
  arguments_free(c, &right);
  arguments_free(c, &sxd);
  arguments_free(c, &syd);
}

static void check_vector(call *c)
{
  arguments xdv = arguments_create(c, MAGGI_NDIR), ydv = arguments_create(c, MAGGI_NDIR);
  arguments xd = arguments_create(c, 1), yd = arguments_create(c, 1);
  arguments right = arguments_create(c, 1);
  double worst = 0.0;
  int i, k, n;

  for (i = 0; i < c->head->narg; ++i)
    for (k = 0; call_is_active(c, i) && k < MAGGI_NDIR * call_size(c, i); ++k)
      xdv.of[i][k] = mech_uniform(&c->random, -1.0, 1.0);
  call_tangents(c, &xdv, &ydv);
  for (n = 0; n < MAGGI_NDIR; ++n) {
    for (i = 0; i < c->head->narg; ++i) {
      for (k = 0; k < call_size(c, i); ++k) {
        xd.of[i][k] = xdv.of[i][k * MAGGI_NDIR + n];
        yd.of[i][k] = ydv.of[i][k * MAGGI_NDIR + n];
      }
    }
    call_tangent(c, &xd, &right);
    worst = fmax(worst, arguments_distance(c, &yd, &right, NULL));
  }
  residual(c, VECTOR, worst);
  arguments_free(c, &xdv);
  arguments_free(c, &ydv);
  arguments_free(c, &xd);
  arguments_free(c, &yd);
  arguments_free(c, &right);
}

/* -------------------------------------------------------------------------------------- adjoint */

/* adjoints of outputs afterwards: zero where the call writes, as they were where it does not */
static int is_consumed(const call *c, const arguments *yb, const arguments *xb)
{
  int i, k, ok = 1;

  for (i = 0; i < c->head->narg; ++i) {
    for (k = 0; k < call_size(c, i); ++k) {
      if (call_is_output(c, i))
        ok = ok && xb->of[i][k] == (c->written[i][k] ? 0.0 : yb->of[i][k]);
      else if (c->head->arg[i].role == MAGGI_HEAD_BOTH)
        ok = ok && xb->of[i][k] == yb->of[i][k];
    }
  }
  return ok;
}

/* x_ = g + J^T y_ for g zero, small and large */
static void check_garbage(call *c, const arguments *yb)
{
  static const double size[] = {1.0, 100.0};
  arguments zb = arguments_create(c, 1), xb = arguments_create(c, 1);
  arguments share = arguments_create(c, 1), right = arguments_create(c, 1);
  double worst = 0.0;
  int i, k, n;

  arguments_copy(c, yb, &zb);
  for (i = 0; i < c->head->narg; ++i)
    for (k = 0; c->head->arg[i].role == MAGGI_HEAD_INPUT && k < call_size(c, i); ++k)
      zb.of[i][k] = 0.0;
  call_adjoint(c, &zb, &share);
  for (n = 0; n < 2; ++n) {
    arguments_copy(c, &share, &right);
    for (i = 0; i < c->head->narg; ++i) {
      for (k = 0; c->head->arg[i].role == MAGGI_HEAD_INPUT && k < call_size(c, i); ++k) {
        zb.of[i][k] = mech_uniform(&c->random, -size[n], size[n]);
        right.of[i][k] += zb.of[i][k];
      }
    }
    call_adjoint(c, &zb, &xb);
    worst = fmax(worst, arguments_distance(c, &xb, &right, NULL));
  }
  residual(c, GARBAGE, worst);
  arguments_free(c, &zb);
  arguments_free(c, &xb);
  arguments_free(c, &share);
  arguments_free(c, &right);
}

static void check_adjoint(call *c, const arguments *xd, const arguments *yd)
{
  arguments yb = arguments_create(c, 1), xb = arguments_create(c, 1);
  double left, right, terms = 0.0;

  arguments_random(c, 1.0, &yb);
  call_adjoint(c, &yb, &xb);
  so(c, "the adjoint consumes what the head writes", is_consumed(c, &yb, &xb));
  left = arguments_dot(c, &yb, yd, &terms);
  right = arguments_dot(c, &xb, xd, &terms);
  identity(c, ADJOINT, left, right, terms);
  check_garbage(c, &yb);
  arguments_free(c, &yb);
  arguments_free(c, &xb);
}

/* --------------------------------------------------------------------------------- differences */

static double difference_error(const call *c, double h, const arguments *xd, const arguments *yd,
                               const arguments *syd)
{
  arguments a = arguments_create(c, 1), b = arguments_create(c, 1);
  double error;
  int i, k;

  call_evaluate(c, h, xd, &a);
  call_evaluate(c, -h, xd, &b);
  for (i = 0; i < c->head->narg; ++i)
    for (k = 0; call_is_active(c, i) && k < call_size(c, i); ++k)
      a.of[i][k] = (a.of[i][k] - b.of[i][k]) / (2.0 * h);
  error = arguments_distance(c, &a, yd, syd);
  arguments_free(c, &a);
  arguments_free(c, &b);
  return error;
}

static void check_difference(call *c, const arguments *xd, const arguments *yd)
{
  static const double h = 2e-4, round_off = 1e-9;
  call s = call_shaken(c);
  arguments syd = arguments_create(c, 1);
  double coarse, fine;

  call_tangent(&s, xd, &syd);
  coarse = difference_error(c, h, xd, yd, &syd);
  fine = difference_error(c, 0.5 * h, xd, yd, &syd);
  residual(c, DIFFERENCE, fine);
  if (fine > round_off) residual(c, ORDER, (fine - round_off) / coarse);
  call_free(&s);
  arguments_free(c, &syd);
}

/* --------------------------------------------------------------------------- second derivatives */

static void check_second(call *c, const arguments *xd, const arguments *yd)
{
  call s = call_shaken(c);
  arguments yb = arguments_create(c, 1), ybd = arguments_create(c, 1);
  arguments xb = arguments_create(c, 1), xbd = arguments_create(c, 1);
  arguments right = arguments_create(c, 1), rightd = arguments_create(c, 1);
  arguments syd = arguments_create(c, 1), syb = arguments_create(c, 1);
  arguments sxb = arguments_create(c, 1), sxbd = arguments_create(c, 1);

  arguments_random(c, 1.0, &yb);
  arguments_random(c, 1.0, &ybd);
  call_second(c, yd, &yb, &ybd, &xb, &xbd);
  so(c, "the tangent of the adjoint consumes what the head writes",
     is_consumed(c, &yb, &xb) && is_consumed(c, &ybd, &xbd));
  arguments_shake(c, xd, &sxb);
  call_tangent(&s, &sxb, &syd);
  arguments_shake(c, &yb, &syb);
  arguments_shake(c, &ybd, &sxbd);
  call_second(&s, &syd, &syb, &ybd, &sxb, &sxbd);
  call_complex_second(c, xd, &yb, &ybd, &right, &rightd);
  so(c, "the adjoint comes with its tangent", arguments_distance(c, &xb, &right, &sxb) < 1e-12);
  residual(c, SECOND, arguments_distance(c, &xbd, &rightd, &sxbd));
  call_free(&s);
  arguments_free(c, &yb);
  arguments_free(c, &ybd);
  arguments_free(c, &xb);
  arguments_free(c, &xbd);
  arguments_free(c, &right);
  arguments_free(c, &rightd);
  arguments_free(c, &syd);
  arguments_free(c, &syb);
  arguments_free(c, &sxb);
  arguments_free(c, &sxbd);
}

/* H u from the tangent of y along u, H the second derivative of y_.y */
static void bend(const call *c, const arguments *yd, const arguments *yb, arguments *hu)
{
  arguments zero = arguments_create(c, 1), xb = arguments_create(c, 1);

  call_second(c, yd, yb, &zero, &xb, hu);
  arguments_free(c, &zero);
  arguments_free(c, &xb);
}

static void check_symmetry(call *c, const arguments *u, const arguments *yd)
{
  arguments yb = arguments_create(c, 1), w = arguments_create(c, 1), wd = arguments_create(c, 1);
  arguments hu = arguments_create(c, 1), hw = arguments_create(c, 1);
  double left, right, terms = 0.0;

  arguments_random(c, 1.0, &yb);
  arguments_random(c, 1.0, &w);
  call_tangent(c, &w, &wd);
  bend(c, yd, &yb, &hu);
  bend(c, &wd, &yb, &hw);
  left = arguments_dot(c, &w, &hu, &terms);
  right = arguments_dot(c, u, &hw, &terms);
  identity(c, SYMMETRY, left, right, terms);
  if (terms > 0.0) table[c->index].bends = 1;
  arguments_free(c, &yb);
  arguments_free(c, &w);
  arguments_free(c, &wd);
  arguments_free(c, &hu);
  arguments_free(c, &hw);
}

/* ------------------------------------------------------------------------------------- not zero */

/* whether a tangent of inputs alone moves an output */
static int is_moved(const call *c, int output, const arguments *xd, const arguments *yd)
{
  int k;

  if (c->head->arg[output].role == MAGGI_HEAD_INPUT || !call_is_active(c, output)) return 0;
  for (k = 0; k < call_size(c, output); ++k)
    if (yd->of[output][k] != xd->of[output][k]) return 1;
  return 0;
}

static void note_moves(call *c)
{
  arguments xd = arguments_create(c, 1), yd = arguments_create(c, 1);
  int i, j, k, *moves = table[c->index].moves;

  for (i = 0; i < c->head->narg; ++i) {
    if (!call_is_active(c, i) || call_is_output(c, i)) continue;
    for (k = 0; k < call_size(c, i); ++k) xd.of[i][k] = mech_uniform(&c->random, -1.0, 1.0);
    call_tangent(c, &xd, &yd);
    for (j = 0; j < c->head->narg; ++j) {
      if (i == j ? c->head->arg[i].role == MAGGI_HEAD_BOTH : is_moved(c, j, &xd, &yd))
        moves[i] = moves[j] = 1;
    }
    for (k = 0; k < call_size(c, i); ++k) xd.of[i][k] = 0.0;
  }
  arguments_free(c, &xd);
  arguments_free(c, &yd);
}

static int is_linear(const char *head)
{
  size_t i;

  for (i = 0; i < sizeof linear / sizeof *linear; ++i)
    if (strcmp(linear[i], head) == 0) return 1;
  return 0;
}

static void check_not_zero(int index)
{
  const maggi_head *head = &maggi_heads[index];
  int i;

  for (i = 0; i < head->narg; ++i) {
    if (head->arg[i].role == MAGGI_HEAD_PASSIVE) continue;
    if (!CHECK(table[index].moves[i])) fprintf(stderr, "%s: %s\n", head->name, head->arg[i].name);
  }
  if (!CHECK(table[index].bends != is_linear(head->name))) fprintf(stderr, "%s\n", head->name);
}

/* ---------------------------------------------------------------------------------------- main */

/* smooth: far enough from kinks for differences */
static void check_inputs(inputs *in, uint64_t seed, int smooth)
{
  arguments xd, yd;
  call c;
  int i, ok;

  for (i = 0; i < maggi_nhead; ++i) {
    ok = call_create(&c, &maggi_heads[i], i, in, seed * HEADS + (uint64_t)i);
    so(&c, "all arguments have numbers", ok);
    xd = arguments_create(&c, 1);
    yd = arguments_create(&c, 1);
    arguments_random(&c, 1.0, &xd);
    call_tangent(&c, &xd, &yd);
    check_tangent(&c, &xd, &yd);
    check_vector(&c);
    check_adjoint(&c, &xd, &yd);
    if (!in->d && smooth) check_difference(&c, &xd, &yd);
    check_second(&c, &xd, &yd);
    check_symmetry(&c, &xd, &yd);
    note_moves(&c);
    ++table[i].cases;
    arguments_free(&c, &xd);
    arguments_free(&c, &yd);
    call_free(&c);
  }
  inputs_free(in);
}

/* a direction of any kind from any parameters, two vectors of which have none in common */
static void random_direction(mech_random *g, int np, int *kind, int *adr, int *aux, int *lean)
{
  *kind = mech_integer(g, MAGGI_DIR_CARRIED + 1);
  *adr = mech_integer(g, *kind == MAGGI_DIR_GLOBAL ? 3 : np - 2);
  *aux = mech_integer(g, 3);
  *lean = mech_integer(g, 3);
  if (*kind != MAGGI_DIR_ACROSS_GLOBAL && *kind != MAGGI_DIR_NORMAL_GLOBAL)
    *aux = (*adr + 3 + mech_integer(g, np - 7)) % (np - 2);
}

/* Random arguments, and axes of joints and directions of all kinds, while models have some only of
 * the one and some of the other. */
static void check_directions(const sample *s)
{
  mech_random g = {s->seed};
  maggi_topo t = s->data->t;
  size_t njoint = (size_t)t.nbody * sizeof(int), ndir = ((size_t)t.ndir + 1) * sizeof(int);
  inputs in;
  int i, unused;

  t.jdirkind = malloc(njoint);
  t.jdiradr = malloc(njoint);
  t.jdiraux = malloc(njoint);
  t.dirkind = malloc(ndir);
  t.diradr = malloc(ndir);
  t.diraux = malloc(ndir);
  t.dirlean = malloc(ndir);
  if (!t.jdirkind || !t.jdiradr || !t.jdiraux || !t.dirkind || !t.diradr || !t.diraux || !t.dirlean)
    abort();
  for (i = 0; i < t.nbody; ++i)
    random_direction(&g, t.np, &t.jdirkind[i], &t.jdiradr[i], &t.jdiraux[i], &unused);
  for (i = 0; i < t.ndir; ++i)
    random_direction(&g, t.np, &t.dirkind[i], &t.diradr[i], &t.diraux[i], &t.dirlean[i]);
  inputs_random(&in, &t, ~s->seed);
  check_inputs(&in, s->seed, s->data->t.nwheel == 0);
  free(t.jdirkind);
  free(t.jdiradr);
  free(t.jdiraux);
  free(t.dirkind);
  free(t.diradr);
  free(t.diraux);
  free(t.dirlean);
}

/* Random arguments in the topology of a model at rest: functions without rates, wheels without grip,
 * controllers without torque. */
static void check_rest(const sample *s)
{
  maggi_topo t = s->data->t;
  inputs in;
  int i;

  t.funheld = malloc(((size_t)t.nfun + 1) * sizeof(int));
  t.wheelgrip = calloc((size_t)t.nwheel + 1, sizeof(int));
  t.speedheld = malloc(((size_t)t.nspeed + 1) * sizeof(int));
  if (!t.funheld || !t.wheelgrip || !t.speedheld) abort();
  for (i = 0; i < t.nfun; ++i) t.funheld[i] = 1;
  for (i = 0; i < t.nspeed; ++i) t.speedheld[i] = 1;
  inputs_random(&in, &t, s->seed + 1);
  check_inputs(&in, s->seed, t.nwheel == 0);
  free(t.funheld);
  free(t.wheelgrip);
  free(t.speedheld);
}

/* Few models have wheels, of which the branches are many. */
enum { WHEEL_INPUTS = 24 };

static void check_sample(const sample *s)
{
  inputs in;
  int i;

  sample_name = s->name;
  inputs_real(&in, s->data);
  check_inputs(&in, s->seed, s->data->t.nwheel == 0);
  inputs_random(&in, &s->data->t, s->seed);
  check_inputs(&in, s->seed, s->data->t.nwheel == 0);
  check_directions(s);
  if (s->data->t.nfun + s->data->t.nwheel + s->data->t.nspeed > 0) check_rest(s);
  for (i = 0; i < WHEEL_INPUTS && s->data->t.nwheel > 0; ++i) {
    inputs_random(&in, &s->data->t, s->seed + 1000u * (uint64_t)(i + 1));
    check_inputs(&in, s->seed, 0);
  }
}

static void summary(void)
{
  int i, k;

  printf("%-28s %7s", "largest errors", "cases");
  for (k = 0; k < KINDS; ++k) printf(" %10s", kind_text[k]);
  printf("\n%-28s %7s", "limits", "");
  for (k = 0; k < KINDS; ++k) printf(" %10.2g", kind_limit[k]);
  for (i = 0; i < maggi_nhead; ++i) {
    printf("\n%-28s %7ld", maggi_heads[i].name, table[i].cases);
    for (k = 0; k < KINDS; ++k) printf(" %10.2g", table[i].worst[k]);
  }
  printf("\n");
}

int main(int argc, char **argv)
{
  report_options options = {1, 300, 0};
  int i, failed;

  if (!report_parse(argc, argv, &options)) return 2;
  CHECK(maggi_nhead > 0 && maggi_nhead <= HEADS);
  sample_each(&options, check_sample);
  for (i = 0; i < maggi_nhead && !options.verbose; ++i) check_not_zero(i);
  summary();
  failed = report_done("derivative_heads");
  return check_done() || failed;
}
