/* What verify works with: one gradient after the other. */
#ifndef TOOL_VERIFY_WORK_H
#define TOOL_VERIFY_WORK_H

#include "progress.h"
#include "verify.h"

#define WORK_GRADIENTS (6 + 3 * VERIFY_PERTURBATIONS) /* in all */

typedef struct work {
  verify *v;
  maggi_design *direct, *difference; /* the most relevant parameters              */
  double *raw;                       /* (objectives x parameters), as it comes    */
  double *other, *half;              /* the same, in the places of the parameters */
  double *value;                     /* (objectives)                              */
  progress progress;
  int done; /* gradients                                 */
} work;

/* 0, or -1 without memory; work_free in either case. */
int work_init(work *w, verify *v);
void work_free(work *w);

/* Entries of a gradient of all objectives. */
size_t work_count(const verify *v);

maggi_gradient_options work_ask(work *w, maggi_method method);

/* A gradient by the first n of the most relevant parameters, or by all n in the order of the study. */
maggi_status work_compute(work *w, maggi_gradient_options *o, const maggi_design *design, int n,
                          double *gradient);

/* Whether the work must end. */
int work_is_end(maggi_status status);

void work_note_failure(trial *t, const maggi_data *d, maggi_status status);

/* A trial by its method, timed: MAGGI_OK too when the method fails, which is noted. */
maggi_status work_attempt(work *w, trial_kind kind, maggi_gradient_options *o,
                          const maggi_design *design, int n, double limit);

/* Error and verdict of a trial that is there. */
void work_judge(verify *v, trial_kind kind);

#endif
