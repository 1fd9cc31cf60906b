/* The matrices of the penalty formulation, sparse with the same places for all:
 *
 *   B = M + h^2/4 alpha Phi_z^T Phi_z             of the projections
 *   W = B + h/2 C + h^2/4 K,  K = -dQ/dz,  C = -dQ/dz'      of Newton's method, [1] 4.9
 *
 * The exact derivative of h^2/4 (M z'' + Phi_z^T alpha Phi - Q) has these places too; W leaves out
 * those of M and Phi_z. */
#ifndef MAGGI_TANGENT_MATRIX_H
#define MAGGI_TANGENT_MATRIX_H

#include "jacobian.h"

typedef struct maggi_tangent_matrix {
  maggi_data *d;
  const maggi_pattern *pattern;
  maggi_sparsity places;       /* n x n */
  double *projection, *newton; /* B, W: values in the order of places.row */
  int *force;                  /* (entries of dQ/dz) place of each */
  int *mass;                   /* (2 npair) places of a pair and of its mirror, -1: none */
  int *loop;                   /* places of a loop: (its path x its path), -1: none */
  int *loopadr;                /* (nloop + 1) the first of them */
  double (*row)[6];            /* (longest path) rows of Phi_z of a loop, by coordinates */
} maggi_tangent_matrix;

/* status MAGGI_OK, MAGGI_E_MEMORY; the pattern must stay; free(NULL) does nothing */
maggi_status maggi_tangent_matrix_create(maggi_data *d, const maggi_pattern *pattern,
                                         maggi_tangent_matrix **matrix);
void maggi_tangent_matrix_free(maggi_tangent_matrix *m);
/* B at positions that have been evaluated */
void maggi_tangent_matrix_project(maggi_tangent_matrix *m, double h, double alpha);
/* W from B and J, in the order of pattern->J */
void maggi_tangent_matrix_newton(maggi_tangent_matrix *m, double h, const double *J);

#endif
