/* Modes of small motions y'' = a_q y + a_v y'. */
#ifndef TOOL_MODES_H
#define TOOL_MODES_H

/* An eigenvalue lambda [1/s], and the coordinate with the largest share of its kinetic energy.  Of a pair of
 * complex ones that with the positive imaginary part. */
typedef struct mode {
  double real, imaginary;
  int coordinate; /* of y */
} mode;

/* Modes by frequency |lambda|, slowest first: their number, at most 2 n; -1 without memory or convergence,
 * -2 in a build that cannot.
 *
 * in    n                coordinates y
 *       a_q, a_v, mass   (n x n)
 * out   modes            (2 n)
 */
int modes_find(int n, const double *a_q, const double *a_v, const double *mass, mode *modes);

#endif
