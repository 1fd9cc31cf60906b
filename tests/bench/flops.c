/* Flops of the loops of core/kernel, function by function.  `bench flops` compares them with what
 * is executed; after a change of the kernel it says which function here has to follow. */
#include "flops.h"

#include <math.h>
#include <string.h>

#include "maggi/maggi.h"

/* building blocks of vec.c */
enum {
  DOT = 5,
  DOT6 = 11,
  CROSS = 9,
  MUL = 15,        /* 3 x 3 times vector */
  POINT_RATE = 12, /* s + w x r */
  WRENCH_ADD = 15,
  INERTIA_MUL = 42 /* I Z */
};

/* columns that a loop over begin..end by blocks of `width` touches */
static long columns(int begin, int end, int width)
{
  int from = begin / width * width;

  return end > from ? (long)(end - from + width - 1) / width * width : 0;
}

static int rows_of(int kind)
{
  return kind == MAGGI_PRIM_POINT || kind == MAGGI_PRIM_AXIS ? 3 : 1;
}

/* time-dependent ones as if t were inside their interval; pow is not counted */
static long function(int kind, int n)
{
  switch (kind) {
  case MAGGI_FUNCTION_POLYNOMIAL:
    return 5L * (n - 1) + 4L * (n > 2 ? n - 2 : 0);
  case MAGGI_FUNCTION_SINE:
    return 15;
  case MAGGI_FUNCTION_STEP:
  case MAGGI_FUNCTION_KNOTS:
    return 32;
  case MAGGI_FUNCTION_SPLINE:
    return 37;
  case MAGGI_FUNCTION_RAMP:
    return 34;
  default:
    return 0;
  }
}

static void positions(const maggi_topo *t, long f[])
{
  int i;

  for (i = 0; i < t->nfun; ++i) f[STAGED_maggi_functions] += function(t->funkind[i], t->funn[i]);
  f[STAGED_maggi_positions] += 6L * t->nbase;
  for (i = 0; i < t->nbody; ++i) {
    if (t->joint[i] == MAGGI_ONE_REVOLUTE) /* sin cos, Rot, Ap Rot, offset and axis, x x u */
      f[STAGED_maggi_positions] += 2 + 28 + 45 + 2 * MUL + 3 + CROSS;
    else if (t->joint[i] == MAGGI_ONE_PRISMATIC)
      f[STAGED_maggi_positions] += 2 * MUL + 9;
    else
      f[STAGED_maggi_positions] += MUL + 3;
  }
  f[STAGED_maggi_points] += (MUL + 3L) * t->npointdyn;
  f[STAGED_maggi_directions] += (long)MUL * t->ndir;
}

static long residual(int kind)
{
  switch (kind) {
  case MAGGI_PRIM_POINT:
    return 3;
  case MAGGI_PRIM_AXIS:
    return 3 + 3;
  case MAGGI_PRIM_ANGLE:
    return 3 + DOT + 1;
  case MAGGI_PRIM_PLANE:
    return 3 + DOT;
  default:
    return 3 + DOT + 4;
  }
}

static long entry(int kind)
{
  switch (kind) {
  case MAGGI_PRIM_POINT:
    return POINT_RATE + 3;
  case MAGGI_PRIM_AXIS:
    return CROSS + 3;
  case MAGGI_PRIM_ANGLE:
    return CROSS + DOT + 1;
  case MAGGI_PRIM_PLANE:
    return POINT_RATE + DOT + 1;
  default:
    return POINT_RATE + 3 + DOT + 2;
  }
}

static long gamma_of(int kind)
{
  const long rates = 2 * (3 * CROSS + 3);

  switch (kind) {
  case MAGGI_PRIM_POINT:
    return 9;
  case MAGGI_PRIM_AXIS:
    return 9 + rates + 3;
  case MAGGI_PRIM_ROD:
    return 9 + 2 * DOT + 2;
  default:
    return 9 + rates + 3 * DOT + 3;
  }
}

/* rate of a building block for n columns */
static long rate(int kind, long n)
{
  switch (kind) {
  case MAGGI_PRIM_POINT:
    return 27 * n;
  case MAGGI_PRIM_AXIS:
    return 21 * n;
  case MAGGI_PRIM_ROD:
    return 6 + 2 * CROSS + 20 * n;
  default:
    return 2 * CROSS + 20 * n;
  }
}

/* least squares with m rows and n unknowns, refined once, for one column */
static long refined(long m, long n)
{
  return 6 * m * n + 4 * n * n + 2 * n;
}

/* the same for a column alone: refined only when the pivots are far apart, see needs_refinement in
 * core/kernel/solve.c; L has the inverse pivots on its diagonal */
static long single(long m, long n, const double *L)
{
  double least = L[0], most = L[0];
  long i;

  for (i = 1; i < n; ++i) {
    least = fmin(least, L[i * n + i]);
    most = fmax(most, L[i * n + i]);
  }
  return 1 + (most < 16.0 * least ? 2 * m * n + 2 * n * n : refined(m, n));
}

static void loops(const maggi_topo *t, const double *chol, int width, long f[])
{
  long m, n, j;
  int i, k, kind;

  for (i = 0; i < t->nprim; ++i) {
    f[STAGED_maggi_loop_residual] += residual(t->primkind[i]);
    if (t->ndep > 0) f[STAGED_maggi_loop_gamma] += gamma_of(t->primkind[i]);
  }
  for (i = 0; i < t->nent; ++i) f[STAGED_maggi_loop_entries] += entry(t->primkind[t->entprim[i]]);
  for (k = 0; k < t->nisland; ++k) {
    m = t->islrow[k + 1] - t->islrow[k];
    n = t->isldep[k + 1] - t->isldep[k];
    f[STAGED_maggi_island_factors] += n * (n + 1) * m; /* Phi^T Phi */
    for (j = 0; j < n; ++j)                            /* its factor */
      f[STAGED_maggi_island_factors] += j * (j - 1) + j + 2 * j + 2;
    for (i = t->islvop[k]; i < t->islvop[k + 1]; ++i) {
      j = t->vopdst[i];
      f[STAGED_maggi_island_columns] += 12 * columns(t->vrowbeg[j], t->vrowend[j], width);
      f[STAGED_maggi_island_vector] += 12;
    }
    for (i = t->islprim[k]; i < t->islprim[k + 1]; ++i) {
      kind = t->primkind[t->primorder[i]];
      f[STAGED_maggi_island_columns] += rate(kind, columns(t->islbeg[k], t->islend[k], width));
      f[STAGED_maggi_island_vector] += rate(kind, 1) + rows_of(kind);
    }
    f[STAGED_maggi_island_columns] += refined(m, n) * columns(t->islbeg[k], t->islend[k], width);
    f[STAGED_maggi_island_vector] += single(m, n, chol + t->islchol[k]);
  }
  f[STAGED_maggi_island_factors] += t->ndep > 0 ? t->ndep + 2 : 1; /* smallest pivot */
}

static void velocities(const maggi_topo *t, long f[])
{
  int passes = (t->ndep > 0) + (t->nrod > 0);

  f[STAGED_maggi_velocities] += 54L * t->nq;
  f[STAGED_maggi_point_velocities] += (long)POINT_RATE * t->npointdyn;
  f[STAGED_maggi_point_accelerations] += passes * (POINT_RATE + 12L) * t->npointdyn;
  if (t->ndep > 0) f[STAGED_maggi_accelerations] += 12L * t->nq + 12L * t->nbody;
}

static void elements(const maggi_topo *t, long f[])
{
  long n = 0;
  int i;

  for (i = 0; i < t->nspring; ++i) /* slopes as if below the knees */
    n += 60 + 2 + (t->springpreload[i] ? 1 : 0) + (t->springslopes[i] ? 2 : 0);
  for (i = 0; i < t->njspring; ++i) n += t->jspringq2[i] >= 0 ? 12 : 9;
  for (i = 0; i < t->nforce; ++i) {
    if (t->forcekind[i] == MAGGI_FORCE_JOINT) {
      n += 5;
      continue;
    }
    n += t->forcekind[i] == MAGGI_FORCE_DRAG ? 3 + DOT + 3 + 4 + 6 : 3;
    if (t->forcekind[i] == MAGGI_FORCE_BODY || t->forcekind[i] == MAGGI_TORQUE_BODY) n += MUL;
    n += t->forcepoint[i] >= 0 ? 2 * WRENCH_ADD + 2 * POINT_RATE + 2 * DOT + 2 : 6 + 8 + 1;
  }
  f[STAGED_maggi_element_forces] += n;
}

enum { SPLINE = 37 }; /* a value with two derivatives */

/* height of a road, bumps as if between them */
static long road(int kind, int n)
{
  switch (kind) {
  case MAGGI_ROAD_FLAT:
    return 1;
  case MAGGI_ROAD_SINE:
    return 8;
  case MAGGI_ROAD_BUMPS:
    return 3L * (n - 1) + 3 + 8;
  default:
    return SPLINE;
  }
}

/* on the road, moving, cambered by more than what counts as little; exp, atan, atan2, tanh are not counted */
static void wheels(const maggi_topo *t, long f[])
{
  const long axis = MUL + DOT + 1 + 3 + 3, contact = 8 + 5 + DOT + CROSS + 6 + 6 + 3 + CROSS + 12;
  const long slip = 5 + 6 + CROSS + 3 + DOT + 8 + 4 + 9 + 3 + 6;
  const long tyre =
      3 + 32 + 45 + 37 + 24 + 32 + 2 + 89 + 40; /* maggi_tyre: as its functions come */
  int i, k;

  for (i = 0; i < t->nwheel; ++i) {
    k = t->wheelroad[i];
    f[STAGED_maggi_wheel_forces] += axis + contact + 2 * road(t->roadkind[k], t->roadn[k]) + slip +
                                    (t->wheelgrip[i] ? 5 + tyre : 0) + 18 + CROSS + 18;
    f[STAGED_maggi_element_forces] += 6 + DOT6 + 1;
  }
}

/* within the path */
static void controls(const maggi_topo *t, long f[])
{
  const long part = 11, nearer = 16;
  long n = 0;
  int i;

  for (i = 0; i < t->ndriver; ++i)
    n += 3 + 4 + (t->drivern[i] - 1) * (part + 11) + part + 3 + 12 * SPLINE + 6 * nearer +
         2 * SPLINE + 4 + 6 + 6 + 5 + 4 + (t->driverspeeds[i] ? SPLINE : 0) +
         (t->driverheld[i] ? 0 : 3);
  for (i = 0; i < t->nspeed; ++i)
    n += 1 + DOT + 5 + (t->speedlinear[i] ? 1 : 2) + 3L * t->speedqnum[i];
  f[STAGED_maggi_control_forces] += n;
}

static void inertias(const maggi_topo *t, long f[])
{
  f[STAGED_maggi_body_inertias] += (MUL + 9L + DOT + 45 + 6 + 24 + 30) * t->nmassive;
  f[STAGED_maggi_inertia_forces] += (2L * INERTIA_MUL + 36) * t->nmassive;
  f[STAGED_maggi_rod_forces] += 2L * (6 + WRENCH_ADD) * t->nrod;
  f[STAGED_maggi_accumulate] += 6L * (t->nbody + 1) + 6L * t->nbody;
  f[STAGED_maggi_composite_inertias] += 10L * t->nbody + 47L * t->nrod;
}

static void mass_matrix(const maggi_topo *t, int width, long f[])
{
  long n;
  int i, j, c, k;

  f[STAGED_maggi_mass_matrix] += (long)INERTIA_MUL * t->nq + (long)DOT6 * t->ntreepair +
                                 (POINT_RATE + 3L) * t->nrodjac + (DOT + 1L) * t->nrodpair;
  for (i = 0; i < t->nrodjac; ++i) f[STAGED_maggi_mass_matrix] += t->rodjacadr[i] >= 0 ? 1 : 0;
  n = t->nii + t->nid;
  for (i = 0; i < t->ndep; ++i) {
    k = t->dep[i];
    /* row of M_dd R: all columns of the row for each pair when by blocks, else those of its source */
    for (c = t->ddadr[i]; c < t->ddadr[i + 1]; ++c) {
      j = t->ddsrc[c];
      n += width > 1 ? 2 * columns(t->zbeg[k], t->zend[k], width) +
                           (j == k) * columns(t->zbeg[k], t->zend[k], width) / width
                     : 2 * columns(t->rbeg[j], t->rend[j], 1) + (j == k);
    }
    for (c = t->zbeg[k]; c < t->rbeg[k]; ++c) n += 2 * columns(t->rbeg[k], t->rend[k], width);
    for (c = t->rbeg[k]; c < t->rend[k]; ++c)
      n += 2 * columns(c, t->zend[k], width) + 2 * columns(c, t->rend[k], width);
  }
  f[STAGED_maggi_reduced_mass] += n;
}

static void solve(const maggi_topo *t, int width, long f[])
{
  long n = t->nind;
  int i, k;

  f[STAGED_maggi_generalised_forces] += (DOT6 + 1L) * t->nq;
  for (i = 0; i < t->ndep; ++i) {
    k = t->dep[i];
    f[STAGED_maggi_reduced_force] += 2L * columns(t->rbeg[k], t->rend[k], width);
    f[STAGED_maggi_expand] += 2 * (2L * columns(t->rbeg[k], t->rend[k], width) + 1); /* v and a */
  }
  for (k = 0; k < n; ++k) {
    f[STAGED_maggi_factor_mass] += 2 + columns(k, (int)n, width);
    for (i = k + 1; i < n; ++i)
      if (t->first[i] <= k) f[STAGED_maggi_factor_mass] += 2 * columns(i, (int)n, width);
  }
  f[STAGED_maggi_solve_mass] += 2 * n * (t->ncol - n) + 2 * n * (n - 1) + 3 * n;
  f[STAGED_maggi_drives] += (2L * t->ncol + 2) * t->nguide;
}

void flops_derive(const maggi_topo *t, const double *chol, int width, long flops[STAGED_COUNT])
{
  memset(flops, 0, STAGED_COUNT * sizeof *flops);
  positions(t, flops);
  loops(t, chol, width, flops);
  velocities(t, flops);
  elements(t, flops);
  wheels(t, flops);
  controls(t, flops);
  inertias(t, flops);
  mass_matrix(t, width, flops);
  solve(t, width, flops);
}
