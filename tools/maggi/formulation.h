/* --formulation and the options that go with it: Maggi's, or the penalty formulation. */
#ifndef TOOL_FORMULATION_H
#define TOOL_FORMULATION_H

#include <maggi/maggi.h>

typedef struct formulation {
  int is_penalty;
  maggi_penalty_options options; /* of the penalty formulation                */
  const char *only;              /* an option given that only it has, or NULL */
} formulation;

void formulation_init(formulation *f);

/* Values of --formulation, --penalty, --jacobian: 0, or -1 after a message. */
int formulation_name(formulation *f, const char *text);
int formulation_penalty(formulation *f, const char *text);
int formulation_jacobian(formulation *f, const char *text);

/* When all options have been seen; tolerance is that of --tolerance, 0 if not given, and Newton's
 * with the penalty formulation.  Exit status, after a message when it is not STATUS_DONE. */
int formulation_check(formulation *f, double tolerance);

/* d with that tolerance, if it is on loops: exit status as above. */
int formulation_tolerance(const formulation *f, maggi_data *d, double tolerance);

/* A simulation by the formulation: *penalty is NULL for Maggi's; maggi_data_message(d). */
maggi_status formulation_create(const formulation *f, maggi_data *d, maggi_penalty **penalty);
maggi_status formulation_reset(maggi_data *d, maggi_penalty *penalty);
maggi_status formulation_step(maggi_data *d, maggi_penalty *penalty, double h);

#endif
