/* The equations of maggi, in the subset of C that both differentiation engines read (AD.md): plain
 * loops with bounds from the integers, arrays passed in, every intermediate written once into its
 * place in the workspace.  Kernels return nothing, check nothing and allocate nothing.
 *
 * All positions are relative to the reference point P of FORMULATION 2, which rides with the base of
 * the model; the axes are global.  Spatial vectors are (linear, angular): velocity of the body-fixed
 * point now at P and angular velocity; force and moment about P.  Inertia is 10 numbers at P:
 * mass, first moment (3), J xx yy zz xy xz yz.  Acceleration of the ground is minus gravity, so that
 * weights need no term of their own.
 */
#ifndef MAGGI_KERNEL_H
#define MAGGI_KERNEL_H

#include <math.h>

#include "topo.h"
#include "vec.h"

/* the real part of a number in a comparison; the complex-step build of the tests redefines it */
#ifndef MAGGI_RE
#define MAGGI_RE(x) (x)
#endif

/* Rows of columns come in blocks of this many numbers, so that inner loops have a constant length; a
 * block may reach beyond a range of columns into zeros. */
#define MAGGI_WIDTH 8

/* constants.c: what depends on p alone */
void maggi_joint_constants(const maggi_topo *t, const double p[t->np], const double origin[3],
                           double offset0[t->nbody][3], double axis0[t->nbody][3]);
void maggi_inertia_constants(const maggi_topo *t, const double p[t->np],
                             double body0[t->nbody][10]);
void maggi_point_constants(const maggi_topo *t, const double p[t->np], const double origin[3],
                           double point0[t->npoint][3], double dir0[t->ndir][3],
                           double prim0[t->nprim], double spring0[t->nspring]);

/* spline.c: natural cubic splines, f: value and two derivatives; function.c: time functions and their two derivatives */
int maggi_piece(int np, const double p[np], int adr, int n, double x);
void maggi_spline(int np, const double p[np], int adr, int n, int row, int nspline,
                  double s[nspline][3]);
void maggi_spline_value(int np, const double p[np], int adr, int n, int madr, int nspline,
                        const double m[nspline][3], double time, double f[3]);
void maggi_spline_constants(const maggi_topo *t, const double p[t->np],
                            double spline0[t->nspline][3]);
void maggi_functions(const maggi_topo *t, const double p[t->np],
                     const double spline0[t->nspline][3], double time, double fun[t->nfun][3]);

/* position.c: poses and joints */
void maggi_positions(const maggi_topo *t, const double offset0[t->nbody][3],
                     const double axis0[t->nbody][3], const double q[t->nq],
                     double turn[t->nbody][2], double A[t->nbody + 1][9], double x[t->nbody + 1][3],
                     double b[t->nbody][6]);
void maggi_points(const maggi_topo *t, int begin, int end, const double point0[t->npoint][3],
                  const double A[t->nbody + 1][9], const double x[t->nbody + 1][3],
                  double r[t->npoint][3]);
void maggi_directions(const maggi_topo *t, const double dir0[t->ndir][3],
                      const double A[t->nbody + 1][9], double dir[t->ndir][3]);

/* velocity.c */
void maggi_velocities(const maggi_topo *t, const double p[t->np], const double b[t->nbody][6],
                      const double v[t->nq], double Z[t->nbody + 1][6], double Z0[t->nbody + 1][6]);
void maggi_accelerations(const maggi_topo *t, const double b[t->nbody][6],
                         const double Z0[t->nbody + 1][6], const double a[t->nq],
                         double W[t->nbody + 1][6], double Za[t->nbody + 1][6]);
void maggi_point_velocities(const maggi_topo *t, int begin, int end, const double r[t->npoint][3],
                            const double Z[t->nbody + 1][6], double rv[t->npoint][3]);
void maggi_point_accelerations(const maggi_topo *t, int begin, int end,
                               const double r[t->npoint][3], const double rv[t->npoint][3],
                               const double Z[t->nbody + 1][6], const double Za[t->nbody + 1][6],
                               double ra[t->npoint][3]);

/* loop.c: loop closure */
void maggi_loop_residual(const maggi_topo *t, const double prim0[t->nprim],
                         const double r[t->npoint][3], const double dir[t->ndir][3],
                         double res[t->nrow]);
int maggi_prim_rows(int kind); /* 3 or 1 */
void maggi_prim_entry(int kind, int side, double length, const double b[6], const double ra[3],
                      const double rb[3], const double da[3], const double db[3], double e[3]);
void maggi_loop_entries(const maggi_topo *t, const double prim0[t->nprim],
                        const double r[t->npoint][3], const double dir[t->ndir][3],
                        const double b[t->nbody][6], double phi[t->nphi]);
void maggi_loop_rates(const maggi_topo *t, const double prim0[t->nprim],
                      const double r[t->npoint][3], const double dir[t->ndir][3],
                      const double rv[t->npoint][3], const double Z[t->nbody + 1][6],
                      double rate[t->nrow]);
void maggi_loop_gamma(const maggi_topo *t, const double prim0[t->nprim],
                      const double r[t->npoint][3], const double dir[t->ndir][3],
                      const double rv[t->npoint][3], const double ra[t->npoint][3],
                      const double Z[t->nbody + 1][6], const double Z0[t->nbody + 1][6],
                      double gam[t->nrow]);

/* island.c: dependent velocities by columns, and one by one; multipliers */
void maggi_island_factors(const maggi_topo *t, const double phi[t->nphi], double chol[t->nchol]);
void maggi_island_columns(const maggi_topo *t, const double prim0[t->nprim],
                          const double r[t->npoint][3], const double dir[t->ndir][3],
                          const double b[t->nbody][6], const double phi[t->nphi],
                          const double chol[t->nchol], double V[t->nvrow * 6 * t->stride],
                          double Y[t->nrow * t->stride], double R[t->nq * t->stride],
                          double work[t->nq * MAGGI_WIDTH * 2]);
void maggi_island_vector(const maggi_topo *t, const double prim0[t->nprim],
                         const double r[t->npoint][3], const double dir[t->ndir][3],
                         const double b[t->nbody][6], const double phi[t->nphi],
                         const double chol[t->nchol], const double rhs[t->nrow],
                         double v1[t->nvrow * 6], double y1[t->nrow], double x[t->nq],
                         double work[t->nq * MAGGI_WIDTH * 2]);
void maggi_island_rates(const maggi_topo *t, int k, int n, const double prim0[t->nprim],
                        const double r[t->npoint][3], const double dir[t->ndir][3],
                        const double b[t->nbody][6], const double x[t->nq * n],
                        double V[t->nvrow * 6 * n], double Y[t->nrow * n]);
void maggi_loop_multipliers(const maggi_topo *t, const double prim0[t->nprim],
                            const double r[t->npoint][3], const double dir[t->ndir][3],
                            const double b[t->nbody][6], const double phi[t->nphi],
                            const double chol[t->nchol], const double w[t->nq],
                            double G[t->nvrow * 6], double y1[t->nrow], double mu[t->nq],
                            double lambda[t->nrow], double work[t->nq * MAGGI_WIDTH * 2]);
void maggi_expand(const maggi_topo *t, const double R[t->nq * t->stride],
                  const double vcol[t->stride], const double x0[t->nq], double v[t->nq]);

/* inertia.c */
void maggi_body_inertias(const maggi_topo *t, const double body0[t->nbody][10],
                         const double A[t->nbody + 1][9], const double x[t->nbody + 1][3],
                         double I[t->nbody][10]);
void maggi_inertia_forces(const maggi_topo *t, const double I[t->nbody][10],
                          const double Z[t->nbody + 1][6], const double Za[t->nbody + 1][6],
                          double F[t->nbody + 1][6]);
void maggi_rod_forces(const maggi_topo *t, const double p[t->np], const double r[t->npoint][3],
                      const double ra[t->npoint][3], double F[t->nbody + 1][6]);
void maggi_composite_inertias(const maggi_topo *t, const double p[t->np],
                              const double r[t->npoint][3], const double I[t->nbody][10],
                              double IS[t->nbody + 1][10]);
void maggi_accumulate(const maggi_topo *t, const double F[t->nbody + 1][6],
                      const double Q[t->nbody + 1][6], double FS[t->nbody + 1][6]);

/* vehicle.c: what a sensor on a vehicle sees */
void maggi_level(const double A[9], const double u[3], double s[3]);
void maggi_in_body(const double A[9], const double u[3], double s[3]);
void maggi_lateral_acceleration(double low_speed, double low, const double v[3], const double a[3],
                                double s[3]);
void maggi_sideslip(double low, const double A[9], const double v[3], const double a[3],
                    double s[3]);

/* spring.c: laws of springs and dampers */
void maggi_spring(int adr, int preload, int withslopes, int np, const double p[np], double l0,
                  const double ra[3], const double rb[3], const double va[3], const double vb[3],
                  double u[3], double z[2], double f[2]);
void maggi_joint_spring(int a, int b, int adr, int np, const double p[np], int nq,
                        const double q[nq], const double v[nq], double z[2], double torque[1]);

/* pac2002.c: the formula of a tyre; its slopes.  road.c: height of a road.  tyre.c: wheels */
void maggi_tyre(int adr, int np, const double p[np], const double slip[5], double f[6]);
void maggi_tyre_slopes(int adr, int np, const double p[np], const double slip[5], double s[3]);
void maggi_road_height(int kind, int adr, int n, int spline, int np, const double p[np],
                       int nspline, const double spline0[nspline][3], double x, double h[3]);
void maggi_wheel_forces(const maggi_topo *t, const double p[t->np],
                        const double spline0[t->nspline][3], const double A[t->nbody + 1][9],
                        const double Z[t->nbody + 1][6], const double r[t->npoint][3],
                        const double rv[t->npoint][3], double slip[t->nwheel][MAGGI_SLIP_NUMBERS],
                        double f[t->nwheel][6], double F[t->nwheel][6]);

void maggi_rolling(const maggi_topo *t, const double p[t->np], const double spline0[t->nspline][3],
                   const double A[t->nbody + 1][9], const double b[t->nbody][6],
                   const double r[t->npoint][3], const double Z[t->nbody + 1][6],
                   double spin[t->nwheel]);

/* element.c: springs, dampers, loads, wheels; Q on bodies, tau on coordinates, power of what dissipates or
 * feeds energy */
void maggi_element_forces(const maggi_topo *t, const double p[t->np], const double fun[t->nfun][3],
                          const double spring0[t->nspring], const double q[t->nq],
                          const double v[t->nq], const double A[t->nbody + 1][9],
                          const double Z[t->nbody + 1][6], const double r[t->npoint][3],
                          const double rv[t->npoint][3], const double roll[t->nwheel][6],
                          double Q[t->nbody + 1][6], double tau[t->nq], double power[1]);

/* control.c: controllers of speed; adds to tau and power */
void maggi_control_forces(const maggi_topo *t, const double p[t->np], const double fun[t->nfun][3],
                          const double v[t->nq], const double rv[t->npoint][3],
                          double speed[t->nspeed][3], double tau[t->nq], double power[1]);

/* mass.c: mass matrix, its reduction, right-hand side */
void maggi_mass_matrix(const maggi_topo *t, const double p[t->np], const double b[t->nbody][6],
                       const double r[t->npoint][3], const double IS[t->nbody + 1][10],
                       double Fb[t->nq][6], double rodjac[t->nrodjac][3], double M[t->npair]);
void maggi_reduced_mass(const maggi_topo *t, const double M[t->npair],
                        const double R[t->nq * t->stride], double MR[t->nq * t->stride],
                        double Mr[t->ncol * t->stride]);
void maggi_generalised_forces(const maggi_topo *t, const double b[t->nbody][6],
                              const double FS[t->nbody + 1][6], const double tau[t->nq],
                              double f[t->nq]);
void maggi_reduced_force(const maggi_topo *t, const double f[t->nq],
                         const double R[t->nq * t->stride], double fr[t->stride]);
void maggi_drives(const maggi_topo *t, const double Mr[t->ncol * t->stride],
                  const double fr[t->ncol], const double acol[t->ncol], double drive[t->ncol]);

/* solve.c: linear solves, differentiated by rule and not by line */
void maggi_cholesky_island(int n, int adr, double chol[]);
void maggi_solve_columns(int m, int n, int phiadr, const double phi[], int choladr,
                         const double chol[], int yrow, const double Y[], int stride, int begin,
                         int end, int depadr, const int dep[], double X[], double work[]);
void maggi_solve_vector(int m, int n, int phiadr, const double phi[], int choladr,
                        const double chol[], int yrow, const double y[], int depadr,
                        const int dep[], double x[], double work[]);
void maggi_factor_mass(const maggi_topo *t, const double Mr[], double Ur[], double dinv[]);
void maggi_solve_mass(const maggi_topo *t, const double Mr[], const double fr[], const double Ur[],
                      const double dinv[], double acol[]);

/* reaction.c */
void maggi_loop_forces(const maggi_topo *t, const double prim0[t->nprim],
                       const double r[t->npoint][3], const double dir[t->ndir][3],
                       const double lambda[t->nrow], double F[t->nbody + 1][6]);
void maggi_reactions(const maggi_topo *t, const double x[t->nbody + 1][3],
                     const double FS[t->nbody + 1][6], double wrench[t->nbody][6]);

/* energy.c */
void maggi_kinetic_energy(const maggi_topo *t, const double p[t->np], const double I[t->nbody][10],
                          const double Z[t->nbody + 1][6], const double rv[t->npoint][3],
                          double energy[1]);
void maggi_potential_energy(const maggi_topo *t, const double p[t->np], const double origin[3],
                            const double body0[t->nbody][10], const double spring0[t->nspring],
                            const double q[t->nq], const double A[t->nbody + 1][9],
                            const double x[t->nbody + 1][3], const double r[t->npoint][3],
                            double energy[1]);

/* sensor.c */
void maggi_sensors(const maggi_topo *t, const double p[t->np], const double origin[3],
                   const double spring0[t->nspring], const double q[t->nq], const double v[t->nq],
                   const double A[t->nbody + 1][9], const double x[t->nbody + 1][3],
                   const double r[t->npoint][3], const double Z[t->nbody + 1][6],
                   const double rv[t->npoint][3], const double Za[t->nbody + 1][6],
                   const double ra[t->npoint][3], const double lambda[t->nrow],
                   const double slip[t->nwheel][MAGGI_SLIP_NUMBERS],
                   const double grip[t->nwheel][6], double s[t->nsensor][3]);

#endif
