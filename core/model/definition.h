/* Definitions of objectives and design parameters: what the builder, the model and studies share. */
#ifndef MAGGI_DEFINITION_H
#define MAGGI_DEFINITION_H

#include "arena.h"
#include "maggi/maggi.h"

/* What is wrong with one in itself, in text; MAGGI_OK or MAGGI_E_VALUE. */
maggi_status maggi_objective_wrong(const maggi_objective_def *d, char *text, size_t n);
maggi_status maggi_design_wrong(const maggi_design_def *d, char *text, size_t n);

/* Replaces all that it points to by copies, but for the name; 0 without memory. */
int maggi_objective_own(maggi_arena *arena, maggi_objective_def *d);
int maggi_design_own(maggi_arena *arena, maggi_design_def *d);
int maggi_sensor_own(maggi_arena *arena, maggi_sensor_def *d);

/* The one declared in a model, NULL if there is none. */
const maggi_objective_def *maggi_model_find_objective(const maggi_model *m, const char *name);

/* Whether a glob (* ? [a-z]) stands for a text. */
int maggi_matches(const char *glob, const char *text);
/* First entry of p from the given one on whose path a glob stands for, -1 if there is none. */
int maggi_parameter_match(const maggi_model *m, const char *glob, int from);

#endif
