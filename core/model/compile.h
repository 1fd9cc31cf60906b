/* A model while it is compiled: growing lists of integers that become those of its topology. */
#ifndef MAGGI_COMPILE_H
#define MAGGI_COMPILE_H

#include "builder.h"
#include "model.h"

typedef struct maggi_list {
  int *v;
  int n, cap;
} maggi_list;

typedef struct maggi_compile {
  maggi_builder *b;
  maggi_model *m;
  maggi_topo *t;
  int no_memory; /* set by what could not grow; checked at the end of each part */
#define X(name, size, text) maggi_list name;
  MAGGI_TOPO_LIST(X)
#undef X
} maggi_compile;

void maggi_push(maggi_compile *c, maggi_list *list, int value);
#define PUSH(list, value) maggi_push(c, &c->list, value)

/* Appends a parameter with a path made of a format, returns its address in p. */
int maggi_parameter_add(maggi_compile *c, double value, const char *unit, maggi_bound bound,
                        const char *format, ...);
/* Appends x, y, z with the given path before them; returns the address of x. */
int maggi_parameter_add3(maggi_compile *c, const double value[3], const char *unit,
                         const char *format, ...);

/* Body of the file by name, -1 for the ground, -2 unknown. */
int maggi_compile_body(const maggi_compile *c, const char *name);
/* Expanded body by name; fails with the message `section.name: key "body" does not exist`. */
maggi_status maggi_compile_link(maggi_compile *c, const char *section, const char *name,
                                const char *key, const char *body, int *id);
/* Internal coordinate by name; fails likewise. */
maggi_status maggi_compile_coordinate(maggi_compile *c, const char *section, const char *name,
                                      const char *key, const char *coordinate, int *q);
maggi_status maggi_compile_function(maggi_compile *c, const char *section, const char *name,
                                    const char *function, int *id);
/* column of a sensor there is so far, -1: none */
int maggi_compile_column(const maggi_model *m, const char *name);
int maggi_compile_point(maggi_compile *c, int body, int adr);
/* Whether an internal coordinate is an angle. */
int maggi_compile_is_angle(const maggi_compile *c, int q);

/* Global axis that a leans on least: 0, 1, 2. */
int maggi_least_axis(const double a[3]);

maggi_status maggi_compile_tree(maggi_compile *c);
maggi_status maggi_compile_functions(maggi_compile *c);
maggi_status maggi_compile_loops(maggi_compile *c);
maggi_status maggi_compile_elements(maggi_compile *c);
maggi_status maggi_compile_speed(maggi_compile *c, const maggi_force_def *d);
maggi_status maggi_compile_sensors(maggi_compile *c);
maggi_status maggi_compile_filters(maggi_compile *c);
maggi_status maggi_compile_signals(maggi_model *m); /* after all others but: */
maggi_status maggi_compile_definitions(maggi_compile *c);
maggi_status maggi_compile_settings(maggi_compile *c); /* after them */
maggi_status maggi_compile_start(maggi_compile *c);    /* once the topology of c->m has its lists */
/* compile_start.c: m->twin */
maggi_status maggi_twin_create(maggi_model *m);
void maggi_twin_free(maggi_model *twin);
maggi_status maggi_compile_parts(maggi_compile *c);

#endif
