/* The heads as a table, for tests: see tools/tapenade/runtime/heads.h.
 * Written by tools/tapenade/generate: edit the kernel, then `make regenerate`. */
#include "heads.h"

#include <stddef.h>

#include "maggi_ad.h"

static int size_np(const maggi_topo *t)
{
  return t->np;
}

static int size_3(const maggi_topo *t)
{
  (void)t;
  return 3;
}

static int size_nbody_3(const maggi_topo *t)
{
  return t->nbody * 3;
}

static const maggi_head_argument joint_constants_arguments[] = {
    {"p", MAGGI_HEAD_INPUT, size_np},
    {"origin", MAGGI_HEAD_PASSIVE, size_3},
    {"offset0", MAGGI_HEAD_OUTPUT, size_nbody_3},
    {"axis0", MAGGI_HEAD_OUTPUT, size_nbody_3},
};

static void joint_constants_call(const maggi_topo *t, double *x[])
{
  maggi_joint_constants(t, (void *)x[0], (void *)x[1], (void *)x[2], (void *)x[3]);
}

static void joint_constants_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_joint_constants_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)x[2], (void *)xd[2],
                          (void *)x[3], (void *)xd[3]);
}

#ifndef MAGGI_COMPLEX
static void joint_constants_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_joint_constants_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)x[2],
                           (void *)xd[2], (void *)x[3], (void *)xd[3], MAGGI_NDIR);
}
#else
#define joint_constants_call_dv NULL
#endif

static void joint_constants_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_joint_constants_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)x[2], (void *)xb[2],
                          (void *)x[3], (void *)xb[3]);
}

static void joint_constants_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                                     double *xbd[])
{
  maggi_joint_constants_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0],
                            (void *)x[1], (void *)x[2], (void *)xd[2], (void *)xb[2],
                            (void *)xbd[2], (void *)x[3], (void *)xd[3], (void *)xb[3],
                            (void *)xbd[3]);
}

static int size_nbody_10(const maggi_topo *t)
{
  return t->nbody * 10;
}

static const maggi_head_argument inertia_constants_arguments[] = {
    {"p", MAGGI_HEAD_INPUT, size_np},
    {"body0", MAGGI_HEAD_OUTPUT, size_nbody_10},
};

static void inertia_constants_call(const maggi_topo *t, double *x[])
{
  maggi_inertia_constants(t, (void *)x[0], (void *)x[1]);
}

static void inertia_constants_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_inertia_constants_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1]);
}

#ifndef MAGGI_COMPLEX
static void inertia_constants_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_inertia_constants_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1],
                             MAGGI_NDIR);
}
#else
#define inertia_constants_call_dv NULL
#endif

static void inertia_constants_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_inertia_constants_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1]);
}

static void inertia_constants_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                                       double *xbd[])
{
  maggi_inertia_constants_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0],
                              (void *)x[1], (void *)xd[1], (void *)xb[1], (void *)xbd[1]);
}

static int size_npoint_3(const maggi_topo *t)
{
  return t->npoint * 3;
}

static int size_ndir_3(const maggi_topo *t)
{
  return t->ndir * 3;
}

static int size_nprim(const maggi_topo *t)
{
  return t->nprim;
}

static int size_nspring(const maggi_topo *t)
{
  return t->nspring;
}

static const maggi_head_argument point_constants_arguments[] = {
    {"p", MAGGI_HEAD_INPUT, size_np},
    {"origin", MAGGI_HEAD_PASSIVE, size_3},
    {"point0", MAGGI_HEAD_OUTPUT, size_npoint_3},
    {"dir0", MAGGI_HEAD_OUTPUT, size_ndir_3},
    {"prim0", MAGGI_HEAD_OUTPUT, size_nprim},
    {"spring0", MAGGI_HEAD_OUTPUT, size_nspring},
};

static void point_constants_call(const maggi_topo *t, double *x[])
{
  maggi_point_constants(t, (void *)x[0], (void *)x[1], (void *)x[2], (void *)x[3], (void *)x[4],
                        (void *)x[5]);
}

static void point_constants_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_point_constants_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)x[2], (void *)xd[2],
                          (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4], (void *)x[5],
                          (void *)xd[5]);
}

#ifndef MAGGI_COMPLEX
static void point_constants_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_point_constants_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)x[2],
                           (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4],
                           (void *)x[5], (void *)xd[5], MAGGI_NDIR);
}
#else
#define point_constants_call_dv NULL
#endif

static void point_constants_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_point_constants_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)x[2], (void *)xb[2],
                          (void *)x[3], (void *)xb[3], (void *)x[4], (void *)xb[4], (void *)x[5],
                          (void *)xb[5]);
}

static void point_constants_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                                     double *xbd[])
{
  maggi_point_constants_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0],
                            (void *)x[1], (void *)x[2], (void *)xd[2], (void *)xb[2],
                            (void *)xbd[2], (void *)x[3], (void *)xd[3], (void *)xb[3],
                            (void *)xbd[3], (void *)x[4], (void *)xd[4], (void *)xb[4],
                            (void *)xbd[4], (void *)x[5], (void *)xd[5], (void *)xb[5],
                            (void *)xbd[5]);
}

static int size_nspline_3(const maggi_topo *t)
{
  return t->nspline * 3;
}

static const maggi_head_argument spline_constants_arguments[] = {
    {"p", MAGGI_HEAD_INPUT, size_np},
    {"spline0", MAGGI_HEAD_OUTPUT, size_nspline_3},
};

static void spline_constants_call(const maggi_topo *t, double *x[])
{
  maggi_spline_constants(t, (void *)x[0], (void *)x[1]);
}

static void spline_constants_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_spline_constants_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1]);
}

#ifndef MAGGI_COMPLEX
static void spline_constants_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_spline_constants_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1],
                            MAGGI_NDIR);
}
#else
#define spline_constants_call_dv NULL
#endif

static void spline_constants_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_spline_constants_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1]);
}

static void spline_constants_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                                      double *xbd[])
{
  maggi_spline_constants_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0],
                             (void *)x[1], (void *)xd[1], (void *)xb[1], (void *)xbd[1]);
}

static int size_1(const maggi_topo *t)
{
  (void)t;
  return 1;
}

static int size_nfun_3(const maggi_topo *t)
{
  return t->nfun * 3;
}

static const maggi_head_argument functions_arguments[] = {
    {"p", MAGGI_HEAD_INPUT, size_np},
    {"spline0", MAGGI_HEAD_INPUT, size_nspline_3},
    {"time", MAGGI_HEAD_PASSIVE, size_1},
    {"fun", MAGGI_HEAD_OUTPUT, size_nfun_3},
};

static void functions_call(const maggi_topo *t, double *x[])
{
  maggi_functions(t, (void *)x[0], (void *)x[1], x[2][0], (void *)x[3]);
}

static void functions_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_functions_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], x[2][0],
                    (void *)x[3], (void *)xd[3]);
}

#ifndef MAGGI_COMPLEX
static void functions_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_functions_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], x[2][0],
                     (void *)x[3], (void *)xd[3], MAGGI_NDIR);
}
#else
#define functions_call_dv NULL
#endif

static void functions_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_functions_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1], x[2][0],
                    (void *)x[3], (void *)xb[3]);
}

static void functions_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                               double *xbd[])
{
  maggi_functions_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0], (void *)x[1],
                      (void *)xd[1], (void *)xb[1], (void *)xbd[1], x[2][0], (void *)x[3],
                      (void *)xd[3], (void *)xb[3], (void *)xbd[3]);
}

static int size_nq(const maggi_topo *t)
{
  return t->nq;
}

static int size_nbody_2(const maggi_topo *t)
{
  return t->nbody * 2;
}

static int size_nbody_1_9(const maggi_topo *t)
{
  return (t->nbody + 1) * 9;
}

static int size_nbody_1_3(const maggi_topo *t)
{
  return (t->nbody + 1) * 3;
}

static int size_nbody_6(const maggi_topo *t)
{
  return t->nbody * 6;
}

static const maggi_head_argument positions_arguments[] = {
    {"offset0", MAGGI_HEAD_INPUT, size_nbody_3},
    {"axis0", MAGGI_HEAD_INPUT, size_nbody_3},
    {"q", MAGGI_HEAD_INPUT, size_nq},
    {"turn", MAGGI_HEAD_OUTPUT, size_nbody_2},
    {"A", MAGGI_HEAD_OUTPUT, size_nbody_1_9},
    {"x", MAGGI_HEAD_OUTPUT, size_nbody_1_3},
    {"b", MAGGI_HEAD_OUTPUT, size_nbody_6},
};

static void positions_call(const maggi_topo *t, double *x[])
{
  maggi_positions(t, (void *)x[0], (void *)x[1], (void *)x[2], (void *)x[3], (void *)x[4],
                  (void *)x[5], (void *)x[6]);
}

static void positions_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_positions_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                    (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4],
                    (void *)x[5], (void *)xd[5], (void *)x[6], (void *)xd[6]);
}

#ifndef MAGGI_COMPLEX
static void positions_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_positions_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                     (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4],
                     (void *)x[5], (void *)xd[5], (void *)x[6], (void *)xd[6], MAGGI_NDIR);
}
#else
#define positions_call_dv NULL
#endif

static void positions_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_positions_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1], (void *)x[2],
                    (void *)xb[2], (void *)x[3], (void *)xb[3], (void *)x[4], (void *)xb[4],
                    (void *)x[5], (void *)xb[5], (void *)x[6], (void *)xb[6]);
}

static void positions_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                               double *xbd[])
{
  maggi_positions_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0], (void *)x[1],
                      (void *)xd[1], (void *)xb[1], (void *)xbd[1], (void *)x[2], (void *)xd[2],
                      (void *)xb[2], (void *)xbd[2], (void *)x[3], (void *)xd[3], (void *)xb[3],
                      (void *)xbd[3], (void *)x[4], (void *)xd[4], (void *)xb[4], (void *)xbd[4],
                      (void *)x[5], (void *)xd[5], (void *)xb[5], (void *)xbd[5], (void *)x[6],
                      (void *)xd[6], (void *)xb[6], (void *)xbd[6]);
}

static const maggi_head_argument points_arguments[] = {
    {"point0", MAGGI_HEAD_INPUT, size_npoint_3},
    {"A", MAGGI_HEAD_INPUT, size_nbody_1_9},
    {"x", MAGGI_HEAD_INPUT, size_nbody_1_3},
    {"r", MAGGI_HEAD_OUTPUT, size_npoint_3},
};

static void points_call(const maggi_topo *t, double *x[])
{
  maggi_points(t, 0, t->npoint, (void *)x[0], (void *)x[1], (void *)x[2], (void *)x[3]);
}

static void points_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_points_d(t, 0, t->npoint, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1],
                 (void *)x[2], (void *)xd[2], (void *)x[3], (void *)xd[3]);
}

#ifndef MAGGI_COMPLEX
static void points_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_points_dv(t, 0, t->npoint, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1],
                  (void *)x[2], (void *)xd[2], (void *)x[3], (void *)xd[3], MAGGI_NDIR);
}
#else
#define points_call_dv NULL
#endif

static void points_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_points_b(t, 0, t->npoint, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1],
                 (void *)x[2], (void *)xb[2], (void *)x[3], (void *)xb[3]);
}

static void points_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                            double *xbd[])
{
  maggi_points_b_d(t, 0, t->npoint, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0],
                   (void *)x[1], (void *)xd[1], (void *)xb[1], (void *)xbd[1], (void *)x[2],
                   (void *)xd[2], (void *)xb[2], (void *)xbd[2], (void *)x[3], (void *)xd[3],
                   (void *)xb[3], (void *)xbd[3]);
}

static const maggi_head_argument directions_arguments[] = {
    {"dir0", MAGGI_HEAD_INPUT, size_ndir_3},
    {"A", MAGGI_HEAD_INPUT, size_nbody_1_9},
    {"dir", MAGGI_HEAD_OUTPUT, size_ndir_3},
};

static void directions_call(const maggi_topo *t, double *x[])
{
  maggi_directions(t, (void *)x[0], (void *)x[1], (void *)x[2]);
}

static void directions_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_directions_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                     (void *)xd[2]);
}

#ifndef MAGGI_COMPLEX
static void directions_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_directions_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                      (void *)xd[2], MAGGI_NDIR);
}
#else
#define directions_call_dv NULL
#endif

static void directions_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_directions_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1], (void *)x[2],
                     (void *)xb[2]);
}

static void directions_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                                double *xbd[])
{
  maggi_directions_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0], (void *)x[1],
                       (void *)xd[1], (void *)xb[1], (void *)xbd[1], (void *)x[2], (void *)xd[2],
                       (void *)xb[2], (void *)xbd[2]);
}

static int size_nrow(const maggi_topo *t)
{
  return t->nrow;
}

static const maggi_head_argument loop_residual_arguments[] = {
    {"prim0", MAGGI_HEAD_INPUT, size_nprim},
    {"r", MAGGI_HEAD_INPUT, size_npoint_3},
    {"dir", MAGGI_HEAD_INPUT, size_ndir_3},
    {"res", MAGGI_HEAD_OUTPUT, size_nrow},
};

static void loop_residual_call(const maggi_topo *t, double *x[])
{
  maggi_loop_residual(t, (void *)x[0], (void *)x[1], (void *)x[2], (void *)x[3]);
}

static void loop_residual_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_loop_residual_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                        (void *)xd[2], (void *)x[3], (void *)xd[3]);
}

#ifndef MAGGI_COMPLEX
static void loop_residual_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_loop_residual_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                         (void *)xd[2], (void *)x[3], (void *)xd[3], MAGGI_NDIR);
}
#else
#define loop_residual_call_dv NULL
#endif

static void loop_residual_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_loop_residual_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1], (void *)x[2],
                        (void *)xb[2], (void *)x[3], (void *)xb[3]);
}

static void loop_residual_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                                   double *xbd[])
{
  maggi_loop_residual_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0],
                          (void *)x[1], (void *)xd[1], (void *)xb[1], (void *)xbd[1], (void *)x[2],
                          (void *)xd[2], (void *)xb[2], (void *)xbd[2], (void *)x[3], (void *)xd[3],
                          (void *)xb[3], (void *)xbd[3]);
}

static int size_nphi(const maggi_topo *t)
{
  return t->nphi;
}

static const maggi_head_argument loop_entries_arguments[] = {
    {"prim0", MAGGI_HEAD_INPUT, size_nprim},
    {"r", MAGGI_HEAD_INPUT, size_npoint_3},
    {"dir", MAGGI_HEAD_INPUT, size_ndir_3},
    {"b", MAGGI_HEAD_INPUT, size_nbody_6},
    {"phi", MAGGI_HEAD_OUTPUT, size_nphi},
};

static void loop_entries_call(const maggi_topo *t, double *x[])
{
  maggi_loop_entries(t, (void *)x[0], (void *)x[1], (void *)x[2], (void *)x[3], (void *)x[4]);
}

static void loop_entries_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_loop_entries_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                       (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4]);
}

#ifndef MAGGI_COMPLEX
static void loop_entries_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_loop_entries_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                        (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4],
                        MAGGI_NDIR);
}
#else
#define loop_entries_call_dv NULL
#endif

static void loop_entries_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_loop_entries_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1], (void *)x[2],
                       (void *)xb[2], (void *)x[3], (void *)xb[3], (void *)x[4], (void *)xb[4]);
}

static void loop_entries_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                                  double *xbd[])
{
  maggi_loop_entries_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0],
                         (void *)x[1], (void *)xd[1], (void *)xb[1], (void *)xbd[1], (void *)x[2],
                         (void *)xd[2], (void *)xb[2], (void *)xbd[2], (void *)x[3], (void *)xd[3],
                         (void *)xb[3], (void *)xbd[3], (void *)x[4], (void *)xd[4], (void *)xb[4],
                         (void *)xbd[4]);
}

static int size_nbody_1_6(const maggi_topo *t)
{
  return (t->nbody + 1) * 6;
}

static const maggi_head_argument velocities_arguments[] = {
    {"p", MAGGI_HEAD_INPUT, size_np},
    {"b", MAGGI_HEAD_INPUT, size_nbody_6},
    {"v", MAGGI_HEAD_INPUT, size_nq},
    {"Z", MAGGI_HEAD_OUTPUT, size_nbody_1_6},
    {"Z0", MAGGI_HEAD_OUTPUT, size_nbody_1_6},
};

static void velocities_call(const maggi_topo *t, double *x[])
{
  maggi_velocities(t, (void *)x[0], (void *)x[1], (void *)x[2], (void *)x[3], (void *)x[4]);
}

static void velocities_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_velocities_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                     (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4]);
}

#ifndef MAGGI_COMPLEX
static void velocities_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_velocities_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                      (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4],
                      MAGGI_NDIR);
}
#else
#define velocities_call_dv NULL
#endif

static void velocities_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_velocities_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1], (void *)x[2],
                     (void *)xb[2], (void *)x[3], (void *)xb[3], (void *)x[4], (void *)xb[4]);
}

static void velocities_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                                double *xbd[])
{
  maggi_velocities_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0], (void *)x[1],
                       (void *)xd[1], (void *)xb[1], (void *)xbd[1], (void *)x[2], (void *)xd[2],
                       (void *)xb[2], (void *)xbd[2], (void *)x[3], (void *)xd[3], (void *)xb[3],
                       (void *)xbd[3], (void *)x[4], (void *)xd[4], (void *)xb[4], (void *)xbd[4]);
}

static const maggi_head_argument point_velocities_arguments[] = {
    {"r", MAGGI_HEAD_INPUT, size_npoint_3},
    {"Z", MAGGI_HEAD_INPUT, size_nbody_1_6},
    {"rv", MAGGI_HEAD_OUTPUT, size_npoint_3},
};

static void point_velocities_call(const maggi_topo *t, double *x[])
{
  maggi_point_velocities(t, 0, t->npoint, (void *)x[0], (void *)x[1], (void *)x[2]);
}

static void point_velocities_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_point_velocities_d(t, 0, t->npoint, (void *)x[0], (void *)xd[0], (void *)x[1],
                           (void *)xd[1], (void *)x[2], (void *)xd[2]);
}

#ifndef MAGGI_COMPLEX
static void point_velocities_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_point_velocities_dv(t, 0, t->npoint, (void *)x[0], (void *)xd[0], (void *)x[1],
                            (void *)xd[1], (void *)x[2], (void *)xd[2], MAGGI_NDIR);
}
#else
#define point_velocities_call_dv NULL
#endif

static void point_velocities_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_point_velocities_b(t, 0, t->npoint, (void *)x[0], (void *)xb[0], (void *)x[1],
                           (void *)xb[1], (void *)x[2], (void *)xb[2]);
}

static void point_velocities_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                                      double *xbd[])
{
  maggi_point_velocities_b_d(t, 0, t->npoint, (void *)x[0], (void *)xd[0], (void *)xb[0],
                             (void *)xbd[0], (void *)x[1], (void *)xd[1], (void *)xb[1],
                             (void *)xbd[1], (void *)x[2], (void *)xd[2], (void *)xb[2],
                             (void *)xbd[2]);
}

static const maggi_head_argument loop_rates_arguments[] = {
    {"prim0", MAGGI_HEAD_INPUT, size_nprim},
    {"r", MAGGI_HEAD_INPUT, size_npoint_3},
    {"dir", MAGGI_HEAD_INPUT, size_ndir_3},
    {"rv", MAGGI_HEAD_INPUT, size_npoint_3},
    {"Z", MAGGI_HEAD_INPUT, size_nbody_1_6},
    {"rate", MAGGI_HEAD_OUTPUT, size_nrow},
};

static void loop_rates_call(const maggi_topo *t, double *x[])
{
  maggi_loop_rates(t, (void *)x[0], (void *)x[1], (void *)x[2], (void *)x[3], (void *)x[4],
                   (void *)x[5]);
}

static void loop_rates_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_loop_rates_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                     (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4],
                     (void *)x[5], (void *)xd[5]);
}

#ifndef MAGGI_COMPLEX
static void loop_rates_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_loop_rates_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                      (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4],
                      (void *)x[5], (void *)xd[5], MAGGI_NDIR);
}
#else
#define loop_rates_call_dv NULL
#endif

static void loop_rates_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_loop_rates_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1], (void *)x[2],
                     (void *)xb[2], (void *)x[3], (void *)xb[3], (void *)x[4], (void *)xb[4],
                     (void *)x[5], (void *)xb[5]);
}

static void loop_rates_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                                double *xbd[])
{
  maggi_loop_rates_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0], (void *)x[1],
                       (void *)xd[1], (void *)xb[1], (void *)xbd[1], (void *)x[2], (void *)xd[2],
                       (void *)xb[2], (void *)xbd[2], (void *)x[3], (void *)xd[3], (void *)xb[3],
                       (void *)xbd[3], (void *)x[4], (void *)xd[4], (void *)xb[4], (void *)xbd[4],
                       (void *)x[5], (void *)xd[5], (void *)xb[5], (void *)xbd[5]);
}

static const maggi_head_argument accelerations_arguments[] = {
    {"b", MAGGI_HEAD_INPUT, size_nbody_6},
    {"Z0", MAGGI_HEAD_INPUT, size_nbody_1_6},
    {"a", MAGGI_HEAD_INPUT, size_nq},
    {"W", MAGGI_HEAD_OUTPUT, size_nbody_1_6},
    {"Za", MAGGI_HEAD_OUTPUT, size_nbody_1_6},
};

static void accelerations_call(const maggi_topo *t, double *x[])
{
  maggi_accelerations(t, (void *)x[0], (void *)x[1], (void *)x[2], (void *)x[3], (void *)x[4]);
}

static void accelerations_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_accelerations_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                        (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4]);
}

#ifndef MAGGI_COMPLEX
static void accelerations_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_accelerations_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                         (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4],
                         MAGGI_NDIR);
}
#else
#define accelerations_call_dv NULL
#endif

static void accelerations_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_accelerations_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1], (void *)x[2],
                        (void *)xb[2], (void *)x[3], (void *)xb[3], (void *)x[4], (void *)xb[4]);
}

static void accelerations_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                                   double *xbd[])
{
  maggi_accelerations_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0],
                          (void *)x[1], (void *)xd[1], (void *)xb[1], (void *)xbd[1], (void *)x[2],
                          (void *)xd[2], (void *)xb[2], (void *)xbd[2], (void *)x[3], (void *)xd[3],
                          (void *)xb[3], (void *)xbd[3], (void *)x[4], (void *)xd[4], (void *)xb[4],
                          (void *)xbd[4]);
}

static const maggi_head_argument point_accelerations_arguments[] = {
    {"r", MAGGI_HEAD_INPUT, size_npoint_3},
    {"rv", MAGGI_HEAD_INPUT, size_npoint_3},
    {"Z", MAGGI_HEAD_INPUT, size_nbody_1_6},
    {"Za", MAGGI_HEAD_INPUT, size_nbody_1_6},
    {"ra", MAGGI_HEAD_OUTPUT, size_npoint_3},
};

static void point_accelerations_call(const maggi_topo *t, double *x[])
{
  maggi_point_accelerations(t, 0, t->npoint, (void *)x[0], (void *)x[1], (void *)x[2], (void *)x[3],
                            (void *)x[4]);
}

static void point_accelerations_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_point_accelerations_d(t, 0, t->npoint, (void *)x[0], (void *)xd[0], (void *)x[1],
                              (void *)xd[1], (void *)x[2], (void *)xd[2], (void *)x[3],
                              (void *)xd[3], (void *)x[4], (void *)xd[4]);
}

#ifndef MAGGI_COMPLEX
static void point_accelerations_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_point_accelerations_dv(t, 0, t->npoint, (void *)x[0], (void *)xd[0], (void *)x[1],
                               (void *)xd[1], (void *)x[2], (void *)xd[2], (void *)x[3],
                               (void *)xd[3], (void *)x[4], (void *)xd[4], MAGGI_NDIR);
}
#else
#define point_accelerations_call_dv NULL
#endif

static void point_accelerations_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_point_accelerations_b(t, 0, t->npoint, (void *)x[0], (void *)xb[0], (void *)x[1],
                              (void *)xb[1], (void *)x[2], (void *)xb[2], (void *)x[3],
                              (void *)xb[3], (void *)x[4], (void *)xb[4]);
}

static void point_accelerations_call_b_d(const maggi_topo *t, double *x[], double *xd[],
                                         double *xb[], double *xbd[])
{
  maggi_point_accelerations_b_d(t, 0, t->npoint, (void *)x[0], (void *)xd[0], (void *)xb[0],
                                (void *)xbd[0], (void *)x[1], (void *)xd[1], (void *)xb[1],
                                (void *)xbd[1], (void *)x[2], (void *)xd[2], (void *)xb[2],
                                (void *)xbd[2], (void *)x[3], (void *)xd[3], (void *)xb[3],
                                (void *)xbd[3], (void *)x[4], (void *)xd[4], (void *)xb[4],
                                (void *)xbd[4]);
}

static const maggi_head_argument loop_gamma_arguments[] = {
    {"prim0", MAGGI_HEAD_INPUT, size_nprim},
    {"r", MAGGI_HEAD_INPUT, size_npoint_3},
    {"dir", MAGGI_HEAD_INPUT, size_ndir_3},
    {"rv", MAGGI_HEAD_INPUT, size_npoint_3},
    {"ra", MAGGI_HEAD_INPUT, size_npoint_3},
    {"Z", MAGGI_HEAD_INPUT, size_nbody_1_6},
    {"Z0", MAGGI_HEAD_INPUT, size_nbody_1_6},
    {"gam", MAGGI_HEAD_OUTPUT, size_nrow},
};

static void loop_gamma_call(const maggi_topo *t, double *x[])
{
  maggi_loop_gamma(t, (void *)x[0], (void *)x[1], (void *)x[2], (void *)x[3], (void *)x[4],
                   (void *)x[5], (void *)x[6], (void *)x[7]);
}

static void loop_gamma_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_loop_gamma_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                     (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4],
                     (void *)x[5], (void *)xd[5], (void *)x[6], (void *)xd[6], (void *)x[7],
                     (void *)xd[7]);
}

#ifndef MAGGI_COMPLEX
static void loop_gamma_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_loop_gamma_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                      (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4],
                      (void *)x[5], (void *)xd[5], (void *)x[6], (void *)xd[6], (void *)x[7],
                      (void *)xd[7], MAGGI_NDIR);
}
#else
#define loop_gamma_call_dv NULL
#endif

static void loop_gamma_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_loop_gamma_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1], (void *)x[2],
                     (void *)xb[2], (void *)x[3], (void *)xb[3], (void *)x[4], (void *)xb[4],
                     (void *)x[5], (void *)xb[5], (void *)x[6], (void *)xb[6], (void *)x[7],
                     (void *)xb[7]);
}

static void loop_gamma_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                                double *xbd[])
{
  maggi_loop_gamma_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0], (void *)x[1],
                       (void *)xd[1], (void *)xb[1], (void *)xbd[1], (void *)x[2], (void *)xd[2],
                       (void *)xb[2], (void *)xbd[2], (void *)x[3], (void *)xd[3], (void *)xb[3],
                       (void *)xbd[3], (void *)x[4], (void *)xd[4], (void *)xb[4], (void *)xbd[4],
                       (void *)x[5], (void *)xd[5], (void *)xb[5], (void *)xbd[5], (void *)x[6],
                       (void *)xd[6], (void *)xb[6], (void *)xbd[6], (void *)x[7], (void *)xd[7],
                       (void *)xb[7], (void *)xbd[7]);
}

static int size_nwheel_MAGGI_SLIP_NUMBERS(const maggi_topo *t)
{
  return t->nwheel * MAGGI_SLIP_NUMBERS;
}

static int size_nwheel_6(const maggi_topo *t)
{
  return t->nwheel * 6;
}

static const maggi_head_argument wheel_forces_arguments[] = {
    {"p", MAGGI_HEAD_INPUT, size_np},
    {"spline0", MAGGI_HEAD_INPUT, size_nspline_3},
    {"A", MAGGI_HEAD_INPUT, size_nbody_1_9},
    {"Z", MAGGI_HEAD_INPUT, size_nbody_1_6},
    {"r", MAGGI_HEAD_INPUT, size_npoint_3},
    {"rv", MAGGI_HEAD_INPUT, size_npoint_3},
    {"slip", MAGGI_HEAD_OUTPUT, size_nwheel_MAGGI_SLIP_NUMBERS},
    {"f", MAGGI_HEAD_OUTPUT, size_nwheel_6},
    {"F", MAGGI_HEAD_OUTPUT, size_nwheel_6},
};

static void wheel_forces_call(const maggi_topo *t, double *x[])
{
  maggi_wheel_forces(t, (void *)x[0], (void *)x[1], (void *)x[2], (void *)x[3], (void *)x[4],
                     (void *)x[5], (void *)x[6], (void *)x[7], (void *)x[8]);
}

static void wheel_forces_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_wheel_forces_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                       (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4],
                       (void *)x[5], (void *)xd[5], (void *)x[6], (void *)xd[6], (void *)x[7],
                       (void *)xd[7], (void *)x[8], (void *)xd[8]);
}

#ifndef MAGGI_COMPLEX
static void wheel_forces_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_wheel_forces_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                        (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4],
                        (void *)x[5], (void *)xd[5], (void *)x[6], (void *)xd[6], (void *)x[7],
                        (void *)xd[7], (void *)x[8], (void *)xd[8], MAGGI_NDIR);
}
#else
#define wheel_forces_call_dv NULL
#endif

static void wheel_forces_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_wheel_forces_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1], (void *)x[2],
                       (void *)xb[2], (void *)x[3], (void *)xb[3], (void *)x[4], (void *)xb[4],
                       (void *)x[5], (void *)xb[5], (void *)x[6], (void *)xb[6], (void *)x[7],
                       (void *)xb[7], (void *)x[8], (void *)xb[8]);
}

static void wheel_forces_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                                  double *xbd[])
{
  maggi_wheel_forces_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0],
                         (void *)x[1], (void *)xd[1], (void *)xb[1], (void *)xbd[1], (void *)x[2],
                         (void *)xd[2], (void *)xb[2], (void *)xbd[2], (void *)x[3], (void *)xd[3],
                         (void *)xb[3], (void *)xbd[3], (void *)x[4], (void *)xd[4], (void *)xb[4],
                         (void *)xbd[4], (void *)x[5], (void *)xd[5], (void *)xb[5], (void *)xbd[5],
                         (void *)x[6], (void *)xd[6], (void *)xb[6], (void *)xbd[6], (void *)x[7],
                         (void *)xd[7], (void *)xb[7], (void *)xbd[7], (void *)x[8], (void *)xd[8],
                         (void *)xb[8], (void *)xbd[8]);
}

static const maggi_head_argument element_forces_arguments[] = {
    {"p", MAGGI_HEAD_INPUT, size_np},
    {"fun", MAGGI_HEAD_INPUT, size_nfun_3},
    {"spring0", MAGGI_HEAD_INPUT, size_nspring},
    {"q", MAGGI_HEAD_INPUT, size_nq},
    {"v", MAGGI_HEAD_INPUT, size_nq},
    {"A", MAGGI_HEAD_INPUT, size_nbody_1_9},
    {"Z", MAGGI_HEAD_PASSIVE, size_nbody_1_6},
    {"r", MAGGI_HEAD_INPUT, size_npoint_3},
    {"rv", MAGGI_HEAD_INPUT, size_npoint_3},
    {"roll", MAGGI_HEAD_INPUT, size_nwheel_6},
    {"Q", MAGGI_HEAD_OUTPUT, size_nbody_1_6},
    {"tau", MAGGI_HEAD_OUTPUT, size_nq},
    {"power", MAGGI_HEAD_PASSIVE, size_1},
};

static void element_forces_call(const maggi_topo *t, double *x[])
{
  maggi_element_forces(t, (void *)x[0], (void *)x[1], (void *)x[2], (void *)x[3], (void *)x[4],
                       (void *)x[5], (void *)x[6], (void *)x[7], (void *)x[8], (void *)x[9],
                       (void *)x[10], (void *)x[11], (void *)x[12]);
}

static void element_forces_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_element_forces_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                         (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4],
                         (void *)x[5], (void *)xd[5], (void *)x[6], (void *)x[7], (void *)xd[7],
                         (void *)x[8], (void *)xd[8], (void *)x[9], (void *)xd[9], (void *)x[10],
                         (void *)xd[10], (void *)x[11], (void *)xd[11], (void *)x[12]);
}

#ifndef MAGGI_COMPLEX
static void element_forces_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_element_forces_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                          (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4],
                          (void *)x[5], (void *)xd[5], (void *)x[6], (void *)x[7], (void *)xd[7],
                          (void *)x[8], (void *)xd[8], (void *)x[9], (void *)xd[9], (void *)x[10],
                          (void *)xd[10], (void *)x[11], (void *)xd[11], (void *)x[12], MAGGI_NDIR);
}
#else
#define element_forces_call_dv NULL
#endif

static void element_forces_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_element_forces_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1], (void *)x[2],
                         (void *)xb[2], (void *)x[3], (void *)xb[3], (void *)x[4], (void *)xb[4],
                         (void *)x[5], (void *)xb[5], (void *)x[6], (void *)x[7], (void *)xb[7],
                         (void *)x[8], (void *)xb[8], (void *)x[9], (void *)xb[9], (void *)x[10],
                         (void *)xb[10], (void *)x[11], (void *)xb[11], (void *)x[12]);
}

static void element_forces_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                                    double *xbd[])
{
  maggi_element_forces_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0],
                           (void *)x[1], (void *)xd[1], (void *)xb[1], (void *)xbd[1], (void *)x[2],
                           (void *)xd[2], (void *)xb[2], (void *)xbd[2], (void *)x[3],
                           (void *)xd[3], (void *)xb[3], (void *)xbd[3], (void *)x[4],
                           (void *)xd[4], (void *)xb[4], (void *)xbd[4], (void *)x[5],
                           (void *)xd[5], (void *)xb[5], (void *)xbd[5], (void *)x[6], (void *)x[7],
                           (void *)xd[7], (void *)xb[7], (void *)xbd[7], (void *)x[8],
                           (void *)xd[8], (void *)xb[8], (void *)xbd[8], (void *)x[9],
                           (void *)xd[9], (void *)xb[9], (void *)xbd[9], (void *)x[10],
                           (void *)xd[10], (void *)xb[10], (void *)xbd[10], (void *)x[11],
                           (void *)xd[11], (void *)xb[11], (void *)xbd[11], (void *)x[12]);
}

static int size_nspeed_3(const maggi_topo *t)
{
  return t->nspeed * 3;
}

static const maggi_head_argument control_forces_arguments[] = {
    {"p", MAGGI_HEAD_INPUT, size_np},
    {"fun", MAGGI_HEAD_INPUT, size_nfun_3},
    {"v", MAGGI_HEAD_PASSIVE, size_nq},
    {"rv", MAGGI_HEAD_INPUT, size_npoint_3},
    {"speed", MAGGI_HEAD_OUTPUT, size_nspeed_3},
    {"tau", MAGGI_HEAD_BOTH, size_nq},
    {"power", MAGGI_HEAD_PASSIVE, size_1},
};

static void control_forces_call(const maggi_topo *t, double *x[])
{
  maggi_control_forces(t, (void *)x[0], (void *)x[1], (void *)x[2], (void *)x[3], (void *)x[4],
                       (void *)x[5], (void *)x[6]);
}

static void control_forces_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_control_forces_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                         (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4], (void *)x[5],
                         (void *)xd[5], (void *)x[6]);
}

#ifndef MAGGI_COMPLEX
static void control_forces_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_control_forces_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                          (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4], (void *)x[5],
                          (void *)xd[5], (void *)x[6], MAGGI_NDIR);
}
#else
#define control_forces_call_dv NULL
#endif

static void control_forces_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_control_forces_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1], (void *)x[2],
                         (void *)x[3], (void *)xb[3], (void *)x[4], (void *)xb[4], (void *)x[5],
                         (void *)xb[5], (void *)x[6]);
}

static void control_forces_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                                    double *xbd[])
{
  maggi_control_forces_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0],
                           (void *)x[1], (void *)xd[1], (void *)xb[1], (void *)xbd[1], (void *)x[2],
                           (void *)x[3], (void *)xd[3], (void *)xb[3], (void *)xbd[3], (void *)x[4],
                           (void *)xd[4], (void *)xb[4], (void *)xbd[4], (void *)x[5],
                           (void *)xd[5], (void *)xb[5], (void *)xbd[5], (void *)x[6]);
}

static const maggi_head_argument body_inertias_arguments[] = {
    {"body0", MAGGI_HEAD_INPUT, size_nbody_10},
    {"A", MAGGI_HEAD_INPUT, size_nbody_1_9},
    {"x", MAGGI_HEAD_INPUT, size_nbody_1_3},
    {"I", MAGGI_HEAD_OUTPUT, size_nbody_10},
};

static void body_inertias_call(const maggi_topo *t, double *x[])
{
  maggi_body_inertias(t, (void *)x[0], (void *)x[1], (void *)x[2], (void *)x[3]);
}

static void body_inertias_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_body_inertias_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                        (void *)xd[2], (void *)x[3], (void *)xd[3]);
}

#ifndef MAGGI_COMPLEX
static void body_inertias_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_body_inertias_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                         (void *)xd[2], (void *)x[3], (void *)xd[3], MAGGI_NDIR);
}
#else
#define body_inertias_call_dv NULL
#endif

static void body_inertias_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_body_inertias_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1], (void *)x[2],
                        (void *)xb[2], (void *)x[3], (void *)xb[3]);
}

static void body_inertias_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                                   double *xbd[])
{
  maggi_body_inertias_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0],
                          (void *)x[1], (void *)xd[1], (void *)xb[1], (void *)xbd[1], (void *)x[2],
                          (void *)xd[2], (void *)xb[2], (void *)xbd[2], (void *)x[3], (void *)xd[3],
                          (void *)xb[3], (void *)xbd[3]);
}

static const maggi_head_argument inertia_forces_arguments[] = {
    {"I", MAGGI_HEAD_INPUT, size_nbody_10},
    {"Z", MAGGI_HEAD_INPUT, size_nbody_1_6},
    {"Za", MAGGI_HEAD_INPUT, size_nbody_1_6},
    {"F", MAGGI_HEAD_OUTPUT, size_nbody_1_6},
};

static void inertia_forces_call(const maggi_topo *t, double *x[])
{
  maggi_inertia_forces(t, (void *)x[0], (void *)x[1], (void *)x[2], (void *)x[3]);
}

static void inertia_forces_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_inertia_forces_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                         (void *)xd[2], (void *)x[3], (void *)xd[3]);
}

#ifndef MAGGI_COMPLEX
static void inertia_forces_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_inertia_forces_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                          (void *)xd[2], (void *)x[3], (void *)xd[3], MAGGI_NDIR);
}
#else
#define inertia_forces_call_dv NULL
#endif

static void inertia_forces_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_inertia_forces_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1], (void *)x[2],
                         (void *)xb[2], (void *)x[3], (void *)xb[3]);
}

static void inertia_forces_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                                    double *xbd[])
{
  maggi_inertia_forces_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0],
                           (void *)x[1], (void *)xd[1], (void *)xb[1], (void *)xbd[1], (void *)x[2],
                           (void *)xd[2], (void *)xb[2], (void *)xbd[2], (void *)x[3],
                           (void *)xd[3], (void *)xb[3], (void *)xbd[3]);
}

static const maggi_head_argument rod_forces_arguments[] = {
    {"p", MAGGI_HEAD_INPUT, size_np},
    {"r", MAGGI_HEAD_INPUT, size_npoint_3},
    {"ra", MAGGI_HEAD_INPUT, size_npoint_3},
    {"F", MAGGI_HEAD_BOTH, size_nbody_1_6},
};

static void rod_forces_call(const maggi_topo *t, double *x[])
{
  maggi_rod_forces(t, (void *)x[0], (void *)x[1], (void *)x[2], (void *)x[3]);
}

static void rod_forces_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_rod_forces_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                     (void *)xd[2], (void *)x[3], (void *)xd[3]);
}

#ifndef MAGGI_COMPLEX
static void rod_forces_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_rod_forces_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                      (void *)xd[2], (void *)x[3], (void *)xd[3], MAGGI_NDIR);
}
#else
#define rod_forces_call_dv NULL
#endif

static void rod_forces_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_rod_forces_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1], (void *)x[2],
                     (void *)xb[2], (void *)x[3], (void *)xb[3]);
}

static void rod_forces_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                                double *xbd[])
{
  maggi_rod_forces_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0], (void *)x[1],
                       (void *)xd[1], (void *)xb[1], (void *)xbd[1], (void *)x[2], (void *)xd[2],
                       (void *)xb[2], (void *)xbd[2], (void *)x[3], (void *)xd[3], (void *)xb[3],
                       (void *)xbd[3]);
}

static const maggi_head_argument loop_forces_arguments[] = {
    {"prim0", MAGGI_HEAD_INPUT, size_nprim},
    {"r", MAGGI_HEAD_INPUT, size_npoint_3},
    {"dir", MAGGI_HEAD_INPUT, size_ndir_3},
    {"lambda", MAGGI_HEAD_INPUT, size_nrow},
    {"F", MAGGI_HEAD_BOTH, size_nbody_1_6},
};

static void loop_forces_call(const maggi_topo *t, double *x[])
{
  maggi_loop_forces(t, (void *)x[0], (void *)x[1], (void *)x[2], (void *)x[3], (void *)x[4]);
}

static void loop_forces_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_loop_forces_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                      (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4]);
}

#ifndef MAGGI_COMPLEX
static void loop_forces_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_loop_forces_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                       (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4],
                       MAGGI_NDIR);
}
#else
#define loop_forces_call_dv NULL
#endif

static void loop_forces_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_loop_forces_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1], (void *)x[2],
                      (void *)xb[2], (void *)x[3], (void *)xb[3], (void *)x[4], (void *)xb[4]);
}

static void loop_forces_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                                 double *xbd[])
{
  maggi_loop_forces_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0], (void *)x[1],
                        (void *)xd[1], (void *)xb[1], (void *)xbd[1], (void *)x[2], (void *)xd[2],
                        (void *)xb[2], (void *)xbd[2], (void *)x[3], (void *)xd[3], (void *)xb[3],
                        (void *)xbd[3], (void *)x[4], (void *)xd[4], (void *)xb[4], (void *)xbd[4]);
}

static const maggi_head_argument accumulate_arguments[] = {
    {"F", MAGGI_HEAD_INPUT, size_nbody_1_6},
    {"Q", MAGGI_HEAD_INPUT, size_nbody_1_6},
    {"FS", MAGGI_HEAD_OUTPUT, size_nbody_1_6},
};

static void accumulate_call(const maggi_topo *t, double *x[])
{
  maggi_accumulate(t, (void *)x[0], (void *)x[1], (void *)x[2]);
}

static void accumulate_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_accumulate_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                     (void *)xd[2]);
}

#ifndef MAGGI_COMPLEX
static void accumulate_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_accumulate_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                      (void *)xd[2], MAGGI_NDIR);
}
#else
#define accumulate_call_dv NULL
#endif

static void accumulate_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_accumulate_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1], (void *)x[2],
                     (void *)xb[2]);
}

static void accumulate_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                                double *xbd[])
{
  maggi_accumulate_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0], (void *)x[1],
                       (void *)xd[1], (void *)xb[1], (void *)xbd[1], (void *)x[2], (void *)xd[2],
                       (void *)xb[2], (void *)xbd[2]);
}

static const maggi_head_argument generalised_forces_arguments[] = {
    {"b", MAGGI_HEAD_INPUT, size_nbody_6},
    {"FS", MAGGI_HEAD_INPUT, size_nbody_1_6},
    {"tau", MAGGI_HEAD_INPUT, size_nq},
    {"f", MAGGI_HEAD_OUTPUT, size_nq},
};

static void generalised_forces_call(const maggi_topo *t, double *x[])
{
  maggi_generalised_forces(t, (void *)x[0], (void *)x[1], (void *)x[2], (void *)x[3]);
}

static void generalised_forces_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_generalised_forces_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1],
                             (void *)x[2], (void *)xd[2], (void *)x[3], (void *)xd[3]);
}

#ifndef MAGGI_COMPLEX
static void generalised_forces_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_generalised_forces_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1],
                              (void *)x[2], (void *)xd[2], (void *)x[3], (void *)xd[3], MAGGI_NDIR);
}
#else
#define generalised_forces_call_dv NULL
#endif

static void generalised_forces_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_generalised_forces_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1],
                             (void *)x[2], (void *)xb[2], (void *)x[3], (void *)xb[3]);
}

static void generalised_forces_call_b_d(const maggi_topo *t, double *x[], double *xd[],
                                        double *xb[], double *xbd[])
{
  maggi_generalised_forces_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0],
                               (void *)x[1], (void *)xd[1], (void *)xb[1], (void *)xbd[1],
                               (void *)x[2], (void *)xd[2], (void *)xb[2], (void *)xbd[2],
                               (void *)x[3], (void *)xd[3], (void *)xb[3], (void *)xbd[3]);
}

static int size_nwheel(const maggi_topo *t)
{
  return t->nwheel;
}

static const maggi_head_argument rolling_arguments[] = {
    {"p", MAGGI_HEAD_INPUT, size_np},
    {"spline0", MAGGI_HEAD_INPUT, size_nspline_3},
    {"A", MAGGI_HEAD_INPUT, size_nbody_1_9},
    {"b", MAGGI_HEAD_INPUT, size_nbody_6},
    {"r", MAGGI_HEAD_INPUT, size_npoint_3},
    {"Z", MAGGI_HEAD_INPUT, size_nbody_1_6},
    {"spin", MAGGI_HEAD_OUTPUT, size_nwheel},
};

static void rolling_call(const maggi_topo *t, double *x[])
{
  maggi_rolling(t, (void *)x[0], (void *)x[1], (void *)x[2], (void *)x[3], (void *)x[4],
                (void *)x[5], (void *)x[6]);
}

static void rolling_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_rolling_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                  (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4],
                  (void *)x[5], (void *)xd[5], (void *)x[6], (void *)xd[6]);
}

#ifndef MAGGI_COMPLEX
static void rolling_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_rolling_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                   (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4],
                   (void *)x[5], (void *)xd[5], (void *)x[6], (void *)xd[6], MAGGI_NDIR);
}
#else
#define rolling_call_dv NULL
#endif

static void rolling_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_rolling_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1], (void *)x[2],
                  (void *)xb[2], (void *)x[3], (void *)xb[3], (void *)x[4], (void *)xb[4],
                  (void *)x[5], (void *)xb[5], (void *)x[6], (void *)xb[6]);
}

static void rolling_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                             double *xbd[])
{
  maggi_rolling_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0], (void *)x[1],
                    (void *)xd[1], (void *)xb[1], (void *)xbd[1], (void *)x[2], (void *)xd[2],
                    (void *)xb[2], (void *)xbd[2], (void *)x[3], (void *)xd[3], (void *)xb[3],
                    (void *)xbd[3], (void *)x[4], (void *)xd[4], (void *)xb[4], (void *)xbd[4],
                    (void *)x[5], (void *)xd[5], (void *)xb[5], (void *)xbd[5], (void *)x[6],
                    (void *)xd[6], (void *)xb[6], (void *)xbd[6]);
}

static const maggi_head_argument reactions_arguments[] = {
    {"x", MAGGI_HEAD_INPUT, size_nbody_1_3},
    {"FS", MAGGI_HEAD_INPUT, size_nbody_1_6},
    {"wrench", MAGGI_HEAD_OUTPUT, size_nbody_6},
};

static void reactions_call(const maggi_topo *t, double *x[])
{
  maggi_reactions(t, (void *)x[0], (void *)x[1], (void *)x[2]);
}

static void reactions_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_reactions_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                    (void *)xd[2]);
}

#ifndef MAGGI_COMPLEX
static void reactions_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_reactions_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                     (void *)xd[2], MAGGI_NDIR);
}
#else
#define reactions_call_dv NULL
#endif

static void reactions_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_reactions_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1], (void *)x[2],
                    (void *)xb[2]);
}

static void reactions_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                               double *xbd[])
{
  maggi_reactions_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0], (void *)x[1],
                      (void *)xd[1], (void *)xb[1], (void *)xbd[1], (void *)x[2], (void *)xd[2],
                      (void *)xb[2], (void *)xbd[2]);
}

static int size_nsensor_3(const maggi_topo *t)
{
  return t->nsensor * 3;
}

static const maggi_head_argument sensors_arguments[] = {
    {"p", MAGGI_HEAD_INPUT, size_np},
    {"origin", MAGGI_HEAD_PASSIVE, size_3},
    {"spring0", MAGGI_HEAD_INPUT, size_nspring},
    {"q", MAGGI_HEAD_INPUT, size_nq},
    {"v", MAGGI_HEAD_INPUT, size_nq},
    {"A", MAGGI_HEAD_INPUT, size_nbody_1_9},
    {"x", MAGGI_HEAD_INPUT, size_nbody_1_3},
    {"r", MAGGI_HEAD_INPUT, size_npoint_3},
    {"Z", MAGGI_HEAD_INPUT, size_nbody_1_6},
    {"rv", MAGGI_HEAD_INPUT, size_npoint_3},
    {"Za", MAGGI_HEAD_INPUT, size_nbody_1_6},
    {"ra", MAGGI_HEAD_INPUT, size_npoint_3},
    {"lambda", MAGGI_HEAD_INPUT, size_nrow},
    {"slip", MAGGI_HEAD_INPUT, size_nwheel_MAGGI_SLIP_NUMBERS},
    {"grip", MAGGI_HEAD_INPUT, size_nwheel_6},
    {"s", MAGGI_HEAD_OUTPUT, size_nsensor_3},
};

static void sensors_call(const maggi_topo *t, double *x[])
{
  maggi_sensors(t, (void *)x[0], (void *)x[1], (void *)x[2], (void *)x[3], (void *)x[4],
                (void *)x[5], (void *)x[6], (void *)x[7], (void *)x[8], (void *)x[9], (void *)x[10],
                (void *)x[11], (void *)x[12], (void *)x[13], (void *)x[14], (void *)x[15]);
}

static void sensors_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_sensors_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)x[2], (void *)xd[2],
                  (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4], (void *)x[5],
                  (void *)xd[5], (void *)x[6], (void *)xd[6], (void *)x[7], (void *)xd[7],
                  (void *)x[8], (void *)xd[8], (void *)x[9], (void *)xd[9], (void *)x[10],
                  (void *)xd[10], (void *)x[11], (void *)xd[11], (void *)x[12], (void *)xd[12],
                  (void *)x[13], (void *)xd[13], (void *)x[14], (void *)xd[14], (void *)x[15],
                  (void *)xd[15]);
}

#ifndef MAGGI_COMPLEX
static void sensors_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_sensors_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)x[2], (void *)xd[2],
                   (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4], (void *)x[5],
                   (void *)xd[5], (void *)x[6], (void *)xd[6], (void *)x[7], (void *)xd[7],
                   (void *)x[8], (void *)xd[8], (void *)x[9], (void *)xd[9], (void *)x[10],
                   (void *)xd[10], (void *)x[11], (void *)xd[11], (void *)x[12], (void *)xd[12],
                   (void *)x[13], (void *)xd[13], (void *)x[14], (void *)xd[14], (void *)x[15],
                   (void *)xd[15], MAGGI_NDIR);
}
#else
#define sensors_call_dv NULL
#endif

static void sensors_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_sensors_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)x[2], (void *)xb[2],
                  (void *)x[3], (void *)xb[3], (void *)x[4], (void *)xb[4], (void *)x[5],
                  (void *)xb[5], (void *)x[6], (void *)xb[6], (void *)x[7], (void *)xb[7],
                  (void *)x[8], (void *)xb[8], (void *)x[9], (void *)xb[9], (void *)x[10],
                  (void *)xb[10], (void *)x[11], (void *)xb[11], (void *)x[12], (void *)xb[12],
                  (void *)x[13], (void *)xb[13], (void *)x[14], (void *)xb[14], (void *)x[15],
                  (void *)xb[15]);
}

static void sensors_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                             double *xbd[])
{
  maggi_sensors_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0], (void *)x[1],
                    (void *)x[2], (void *)xd[2], (void *)xb[2], (void *)xbd[2], (void *)x[3],
                    (void *)xd[3], (void *)xb[3], (void *)xbd[3], (void *)x[4], (void *)xd[4],
                    (void *)xb[4], (void *)xbd[4], (void *)x[5], (void *)xd[5], (void *)xb[5],
                    (void *)xbd[5], (void *)x[6], (void *)xd[6], (void *)xb[6], (void *)xbd[6],
                    (void *)x[7], (void *)xd[7], (void *)xb[7], (void *)xbd[7], (void *)x[8],
                    (void *)xd[8], (void *)xb[8], (void *)xbd[8], (void *)x[9], (void *)xd[9],
                    (void *)xb[9], (void *)xbd[9], (void *)x[10], (void *)xd[10], (void *)xb[10],
                    (void *)xbd[10], (void *)x[11], (void *)xd[11], (void *)xb[11], (void *)xbd[11],
                    (void *)x[12], (void *)xd[12], (void *)xb[12], (void *)xbd[12], (void *)x[13],
                    (void *)xd[13], (void *)xb[13], (void *)xbd[13], (void *)x[14], (void *)xd[14],
                    (void *)xb[14], (void *)xbd[14], (void *)x[15], (void *)xd[15], (void *)xb[15],
                    (void *)xbd[15]);
}

static const maggi_head_argument kinetic_energy_arguments[] = {
    {"p", MAGGI_HEAD_INPUT, size_np},
    {"I", MAGGI_HEAD_INPUT, size_nbody_10},
    {"Z", MAGGI_HEAD_INPUT, size_nbody_1_6},
    {"rv", MAGGI_HEAD_INPUT, size_npoint_3},
    {"energy", MAGGI_HEAD_OUTPUT, size_1},
};

static void kinetic_energy_call(const maggi_topo *t, double *x[])
{
  maggi_kinetic_energy(t, (void *)x[0], (void *)x[1], (void *)x[2], (void *)x[3], (void *)x[4]);
}

static void kinetic_energy_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_kinetic_energy_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                         (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4]);
}

#ifndef MAGGI_COMPLEX
static void kinetic_energy_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_kinetic_energy_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)xd[1], (void *)x[2],
                          (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4],
                          MAGGI_NDIR);
}
#else
#define kinetic_energy_call_dv NULL
#endif

static void kinetic_energy_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_kinetic_energy_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)xb[1], (void *)x[2],
                         (void *)xb[2], (void *)x[3], (void *)xb[3], (void *)x[4], (void *)xb[4]);
}

static void kinetic_energy_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                                    double *xbd[])
{
  maggi_kinetic_energy_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0],
                           (void *)x[1], (void *)xd[1], (void *)xb[1], (void *)xbd[1], (void *)x[2],
                           (void *)xd[2], (void *)xb[2], (void *)xbd[2], (void *)x[3],
                           (void *)xd[3], (void *)xb[3], (void *)xbd[3], (void *)x[4],
                           (void *)xd[4], (void *)xb[4], (void *)xbd[4]);
}

static const maggi_head_argument potential_energy_arguments[] = {
    {"p", MAGGI_HEAD_INPUT, size_np},
    {"origin", MAGGI_HEAD_PASSIVE, size_3},
    {"body0", MAGGI_HEAD_INPUT, size_nbody_10},
    {"spring0", MAGGI_HEAD_INPUT, size_nspring},
    {"q", MAGGI_HEAD_INPUT, size_nq},
    {"A", MAGGI_HEAD_INPUT, size_nbody_1_9},
    {"x", MAGGI_HEAD_INPUT, size_nbody_1_3},
    {"r", MAGGI_HEAD_INPUT, size_npoint_3},
    {"energy", MAGGI_HEAD_OUTPUT, size_1},
};

static void potential_energy_call(const maggi_topo *t, double *x[])
{
  maggi_potential_energy(t, (void *)x[0], (void *)x[1], (void *)x[2], (void *)x[3], (void *)x[4],
                         (void *)x[5], (void *)x[6], (void *)x[7], (void *)x[8]);
}

static void potential_energy_call_d(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_potential_energy_d(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)x[2],
                           (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4],
                           (void *)x[5], (void *)xd[5], (void *)x[6], (void *)xd[6], (void *)x[7],
                           (void *)xd[7], (void *)x[8], (void *)xd[8]);
}

#ifndef MAGGI_COMPLEX
static void potential_energy_call_dv(const maggi_topo *t, double *x[], double *xd[])
{
  maggi_potential_energy_dv(t, (void *)x[0], (void *)xd[0], (void *)x[1], (void *)x[2],
                            (void *)xd[2], (void *)x[3], (void *)xd[3], (void *)x[4], (void *)xd[4],
                            (void *)x[5], (void *)xd[5], (void *)x[6], (void *)xd[6], (void *)x[7],
                            (void *)xd[7], (void *)x[8], (void *)xd[8], MAGGI_NDIR);
}
#else
#define potential_energy_call_dv NULL
#endif

static void potential_energy_call_b(const maggi_topo *t, double *x[], double *xb[])
{
  maggi_potential_energy_b(t, (void *)x[0], (void *)xb[0], (void *)x[1], (void *)x[2],
                           (void *)xb[2], (void *)x[3], (void *)xb[3], (void *)x[4], (void *)xb[4],
                           (void *)x[5], (void *)xb[5], (void *)x[6], (void *)xb[6], (void *)x[7],
                           (void *)xb[7], (void *)x[8], (void *)xb[8]);
}

static void potential_energy_call_b_d(const maggi_topo *t, double *x[], double *xd[], double *xb[],
                                      double *xbd[])
{
  maggi_potential_energy_b_d(t, (void *)x[0], (void *)xd[0], (void *)xb[0], (void *)xbd[0],
                             (void *)x[1], (void *)x[2], (void *)xd[2], (void *)xb[2],
                             (void *)xbd[2], (void *)x[3], (void *)xd[3], (void *)xb[3],
                             (void *)xbd[3], (void *)x[4], (void *)xd[4], (void *)xb[4],
                             (void *)xbd[4], (void *)x[5], (void *)xd[5], (void *)xb[5],
                             (void *)xbd[5], (void *)x[6], (void *)xd[6], (void *)xb[6],
                             (void *)xbd[6], (void *)x[7], (void *)xd[7], (void *)xb[7],
                             (void *)xbd[7], (void *)x[8], (void *)xd[8], (void *)xb[8],
                             (void *)xbd[8]);
}

const maggi_head maggi_heads[] = {
  {"maggi_joint_constants", 4, joint_constants_arguments, joint_constants_call,
      joint_constants_call_d, joint_constants_call_dv, joint_constants_call_b,
      joint_constants_call_b_d},
  {"maggi_inertia_constants", 2, inertia_constants_arguments, inertia_constants_call,
      inertia_constants_call_d, inertia_constants_call_dv, inertia_constants_call_b,
      inertia_constants_call_b_d},
  {"maggi_point_constants", 6, point_constants_arguments, point_constants_call,
      point_constants_call_d, point_constants_call_dv, point_constants_call_b,
      point_constants_call_b_d},
  {"maggi_spline_constants", 2, spline_constants_arguments, spline_constants_call,
      spline_constants_call_d, spline_constants_call_dv, spline_constants_call_b,
      spline_constants_call_b_d},
  {"maggi_functions", 4, functions_arguments, functions_call, functions_call_d, functions_call_dv,
      functions_call_b, functions_call_b_d},
  {"maggi_positions", 7, positions_arguments, positions_call, positions_call_d, positions_call_dv,
      positions_call_b, positions_call_b_d},
  {"maggi_points", 4, points_arguments, points_call, points_call_d, points_call_dv, points_call_b,
      points_call_b_d},
  {"maggi_directions", 3, directions_arguments, directions_call, directions_call_d,
      directions_call_dv, directions_call_b, directions_call_b_d},
  {"maggi_loop_residual", 4, loop_residual_arguments, loop_residual_call, loop_residual_call_d,
      loop_residual_call_dv, loop_residual_call_b, loop_residual_call_b_d},
  {"maggi_loop_entries", 5, loop_entries_arguments, loop_entries_call, loop_entries_call_d,
      loop_entries_call_dv, loop_entries_call_b, loop_entries_call_b_d},
  {"maggi_velocities", 5, velocities_arguments, velocities_call, velocities_call_d,
      velocities_call_dv, velocities_call_b, velocities_call_b_d},
  {"maggi_point_velocities", 3, point_velocities_arguments, point_velocities_call,
      point_velocities_call_d, point_velocities_call_dv, point_velocities_call_b,
      point_velocities_call_b_d},
  {"maggi_loop_rates", 6, loop_rates_arguments, loop_rates_call, loop_rates_call_d,
      loop_rates_call_dv, loop_rates_call_b, loop_rates_call_b_d},
  {"maggi_accelerations", 5, accelerations_arguments, accelerations_call, accelerations_call_d,
      accelerations_call_dv, accelerations_call_b, accelerations_call_b_d},
  {"maggi_point_accelerations", 5, point_accelerations_arguments, point_accelerations_call,
      point_accelerations_call_d, point_accelerations_call_dv, point_accelerations_call_b,
      point_accelerations_call_b_d},
  {"maggi_loop_gamma", 8, loop_gamma_arguments, loop_gamma_call, loop_gamma_call_d,
      loop_gamma_call_dv, loop_gamma_call_b, loop_gamma_call_b_d},
  {"maggi_wheel_forces", 9, wheel_forces_arguments, wheel_forces_call, wheel_forces_call_d,
      wheel_forces_call_dv, wheel_forces_call_b, wheel_forces_call_b_d},
  {"maggi_element_forces", 13, element_forces_arguments, element_forces_call, element_forces_call_d,
      element_forces_call_dv, element_forces_call_b, element_forces_call_b_d},
  {"maggi_control_forces", 7, control_forces_arguments, control_forces_call, control_forces_call_d,
      control_forces_call_dv, control_forces_call_b, control_forces_call_b_d},
  {"maggi_body_inertias", 4, body_inertias_arguments, body_inertias_call, body_inertias_call_d,
      body_inertias_call_dv, body_inertias_call_b, body_inertias_call_b_d},
  {"maggi_inertia_forces", 4, inertia_forces_arguments, inertia_forces_call, inertia_forces_call_d,
      inertia_forces_call_dv, inertia_forces_call_b, inertia_forces_call_b_d},
  {"maggi_rod_forces", 4, rod_forces_arguments, rod_forces_call, rod_forces_call_d,
      rod_forces_call_dv, rod_forces_call_b, rod_forces_call_b_d},
  {"maggi_loop_forces", 5, loop_forces_arguments, loop_forces_call, loop_forces_call_d,
      loop_forces_call_dv, loop_forces_call_b, loop_forces_call_b_d},
  {"maggi_accumulate", 3, accumulate_arguments, accumulate_call, accumulate_call_d,
      accumulate_call_dv, accumulate_call_b, accumulate_call_b_d},
  {"maggi_generalised_forces", 4, generalised_forces_arguments, generalised_forces_call,
      generalised_forces_call_d, generalised_forces_call_dv, generalised_forces_call_b,
      generalised_forces_call_b_d},
  {"maggi_rolling", 7, rolling_arguments, rolling_call, rolling_call_d, rolling_call_dv,
      rolling_call_b, rolling_call_b_d},
  {"maggi_reactions", 3, reactions_arguments, reactions_call, reactions_call_d, reactions_call_dv,
      reactions_call_b, reactions_call_b_d},
  {"maggi_sensors", 16, sensors_arguments, sensors_call, sensors_call_d, sensors_call_dv,
      sensors_call_b, sensors_call_b_d},
  {"maggi_kinetic_energy", 5, kinetic_energy_arguments, kinetic_energy_call, kinetic_energy_call_d,
      kinetic_energy_call_dv, kinetic_energy_call_b, kinetic_energy_call_b_d},
  {"maggi_potential_energy", 9, potential_energy_arguments, potential_energy_call,
      potential_energy_call_d, potential_energy_call_dv, potential_energy_call_b,
      potential_energy_call_b_d},
};

const int maggi_nhead = 30;
