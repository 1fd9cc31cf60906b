/* A table of the heads of heads.txt, by which tests try every derivative in the same way.
 *
 * x[i] points to argument i, the double arguments only, in the order of the function.  Arrays of
 * derivatives are as long as their arguments; those of `dv` have MAGGI_NDIR numbers for each number,
 * one after the other.  Arguments without derivatives are not looked at in xd, xb and xbd. */
#ifndef MAGGI_HEADS_H
#define MAGGI_HEADS_H

#include "topo.h"

/* role of an argument; BOTH: the function adds to it */
enum { MAGGI_HEAD_PASSIVE, MAGGI_HEAD_INPUT, MAGGI_HEAD_OUTPUT, MAGGI_HEAD_BOTH };

typedef struct maggi_head_argument {
  const char *name;
  int role;
  int (*size)(const maggi_topo *t); /* numbers */
} maggi_head_argument;

typedef struct maggi_head {
  const char *name;
  int narg;
  const maggi_head_argument *arg;
  void (*f)(const maggi_topo *t, double *x[]);
  void (*d)(const maggi_topo *t, double *x[], double *xd[]);
  void (*dv)(const maggi_topo *t, double *x[], double *xd[]);
  void (*b)(const maggi_topo *t, double *x[], double *xb[]);
  void (*b_d)(const maggi_topo *t, double *x[], double *xd[], double *xb[], double *xbd[]);
} maggi_head;

extern const maggi_head maggi_heads[];
extern const int maggi_nhead;

#endif
