/* The model file in memory, and the steps that read it:
 *
 *   load.c         bytes of the file, message, order of the steps
 *   load_check.c   every key, type, length and number against the tables, with the line of an error
 *   load_schema.c  the tables of keys, for load_check.c and for libcyaml, which fills load_model
 *   load_base.c    the file and those that it builds on as one load_model
 *   load_build.c   load_model -> maggi_builder -> maggi_model, with
 *   load_body.c    .. the bodies and
 *   load_element.c .. lists of the mechanism,
 *   load_filter.c  .. filters,
 *   load_tyre.c    .. tyres with their property files, roads and wheels,
 *   load_definition.c .. objectives and design parameters, with
 *   load_record.c  .. the records of objectives, CSV
 *   load_line.c    line of an entry, for errors that are found later
 *
 * load_check.c does not leave checking to libcyaml because libcyaml 1.3 takes "1.0abc" and "1,5"
 * as 1, drops all documents but the first, and cannot say which keys it would have liked.
 */
#ifndef MAGGI_MODEL_LOAD_FILE_H
#define MAGGI_MODEL_LOAD_FILE_H

#include "maggi/maggi.h"

#include <cyaml/cyaml.h>
#include <stdbool.h>

/* Where a message goes: message is nmessage chars, or NULL. */
typedef struct load_error {
  const char *file;
  char *message;
  size_t nmessage;
} load_error;

/* What the keys hold.  A pointer is NULL when its key is absent; vectors are three numbers; a list
 * is followed by its count, as libcyaml wants it.  The first member of an entry of a list of the model is
 * its name, for load_base.c. */

typedef struct load_joint {
  char *type;
  double *point;
  double *axis;
  double *axis2;
  double *position; /* of joints with one coordinate; the lists are for all others */
  double *velocity;
  double *guess;
  char *motion;
  double **positions; /* an entry is NULL when it is null in the file */
  unsigned positions_count;
  double **velocities;
  unsigned velocities_count;
  double **guesses;
  unsigned guesses_count;
  char **motions;
  unsigned motions_count;
} load_joint;

typedef struct load_inertia {
  double xx, yy, zz, xy, xz, yz;
} load_inertia;

typedef struct load_bar {
  double from[3];
  double to[3];
} load_bar;

typedef struct load_point_mass {
  char *name;
  double mass;
  double point[3];
} load_point_mass;

typedef struct load_body {
  char *name;
  char *parent;
  load_joint joint;
  double mass;
  double *cog;
  load_inertia *inertia;
  load_bar *bar;
  load_point_mass *point_masses;
  unsigned point_masses_count;
} load_body;

typedef struct load_loop {
  char *name;
  char *type;
  char *body_a;
  char *body_b;
  double *point;
  double *point_a;
  double *point_b;
  double *axis;
  double *axis_a;
  double *axis_b;
} load_loop;

typedef struct load_rod {
  char *name;
  char *body_a;
  char *body_b;
  double point_a[3];
  double point_b[3];
  double mass;
  double *length;
} load_rod;

typedef struct load_slopes {
  double c1, c2, c3, c4, v11, v22;
} load_slopes;

typedef struct load_spring {
  char *name;
  char *body_a;
  char *body_b;
  double point_a[3];
  double point_b[3];
  double stiffness;
  double *free_length;
  double *preload;
  double damping;
  load_slopes *slopes;
} load_spring;

typedef struct load_joint_spring {
  char *name;
  char *coordinate;
  char *coordinate2;
  double stiffness;
  double damping;
  double rest;
  double preload;
} load_joint_spring;

typedef struct load_force {
  char *name;
  char *type;
  char *body;
  char *reaction;
  char *coordinate;
  char *function;
  double *point;
  double *value;
  double *effort;
  double *density, *coefficient, *area, *low_speed, *wind;
  char **coordinates;
  unsigned coordinates_count;
  double *speed, *gain, *torque;
  char *driver;
} load_force;

typedef struct load_tyre {
  char *name;
  char *file;
  double *low_camber;
  double *low_speed;
} load_tyre;

typedef struct load_road {
  char *name;
  char *type;
  double *point;
  double *slope, *amplitude, *wavelength;
  double *radius, *height, *first, *spacing, *fillet;
  double *number;
  double *x, *z;
  unsigned x_count, z_count;
} load_road;

typedef struct load_wheel {
  char *name;
  char *body;
  char *carrier;
  char *tyre;
  char *road;
  char *side;
  double point[3];
  double *axis;
} load_wheel;

typedef struct load_driver {
  char *name;
  char *body;
  char *coordinate;
  double point[3];
  double *origin;
  double preview, gain, feedforward, limit, stiffness, damping;
  double *x;
  unsigned x_count;
  double *y;
  unsigned y_count;
  double *speeds;
  unsigned speeds_count;
} load_driver;

typedef struct load_function {
  char *name;
  char *type;
  double *value;
  double *amplitude;
  double *omega;
  double *phase;
  double *offset;
  double *t0;
  double *t1;
  double *y0;
  double *y1;
  double *rate;
  double *coefficients;
  unsigned coefficients_count;
  double *times;
  unsigned times_count;
  double *values;
  unsigned values_count;
} load_function;

typedef struct load_sensor {
  char *name;
  char *type;
  char *body;
  double *point;
  char *element;
  double *low_speed;
  double *low_acceleration;
  char **terms;
  unsigned terms_count;
  double *weights;
  unsigned weights_count;
  char *unit;
} load_sensor;

typedef struct load_filter {
  char *name;
  char *signal;
  char *weighting;
  double *f1, *f2, *q4, *q5, *q6, *gain;
  char *f3, *f4, *f5, *f6; /* may be inf */
} load_filter;

typedef struct load_objective {
  char *name;
  char *type;
  char *signal;
  double *target;
  double *sharpness;
  char *reference;
  double *from;
  double *to;
  char *against;
  double *times;
  unsigned times_count;
  double *values;
  unsigned values_count;
  char *file;
  char *column;
  char **terms;
  unsigned terms_count;
  double *weights;
  unsigned weights_count;
} load_objective;

typedef struct load_design {
  char *name;
  char **parameters;
  unsigned parameters_count;
  double *factors;
  unsigned factors_count;
  double *nominal;
  double *lower;
  double *upper;
  char *unit;
} load_design;

typedef struct load_set {
  char *name;
  double value;
} load_set;

typedef struct load_simulation {
  double time;
  double step;
} load_simulation;

typedef struct load_start {
  bool equilibrium;
  bool rolling;
  char **hold;
  unsigned hold_count;
} load_start;

typedef struct load_model {
  char *format;
  int version;
  char *name;
  char *source;
  char *base;
  char **remove;
  unsigned remove_count;
  double *gravity;
  load_simulation *simulation;
  load_start *start;
  load_body *bodies;
  unsigned bodies_count;
  load_loop *loops;
  unsigned loops_count;
  load_rod *rods;
  unsigned rods_count;
  load_spring *springs;
  unsigned springs_count;
  load_joint_spring *joint_springs;
  unsigned joint_springs_count;
  load_force *forces;
  unsigned forces_count;
  load_tyre *tyres;
  unsigned tyres_count;
  load_road *roads;
  unsigned roads_count;
  load_wheel *wheels;
  unsigned wheels_count;
  load_driver *drivers;
  unsigned drivers_count;
  load_function *functions;
  unsigned functions_count;
  load_sensor *sensors;
  unsigned sensors_count;
  load_filter *filters;
  unsigned filters_count;
  load_objective *objectives;
  unsigned objectives_count;
  load_design *design;
  unsigned design_count;
  load_set *set;
  unsigned set_count;
} load_model;

/* A file that was read. */
typedef struct load_source {
  load_error error;  /* with its name */
  const char *bytes; /* its text (n) */
  size_t n;
  load_model *file; /* what its keys hold */
  char *path;       /* its name and its text where they were made here, of a base */
  char *owned;
} load_source;

/* Where an entry comes from: files->source[source], list[number]. */
typedef struct load_origin {
  int source;
  unsigned number;
} load_origin;

enum {
  MAGGI_LOAD_FILES = 16,   /* the most that build on each other */
  MAGGI_LOAD_KEYS_MAX = 32 /* of the model file */
};

/* The model file, its base, the base of that, .., and all of them as one model, whose lists are its own
 * and whose entries are those of the sources. */
typedef struct load_files {
  load_source source[MAGGI_LOAD_FILES];
  int number;
  load_model all;
  load_origin
      *origin[MAGGI_LOAD_KEYS_MAX]; /* of the entries of each list, in the order of the keys */
} load_files;

#define MAGGI_LOAD_FORMAT  "maggi" /* of the key `format`, the first of a file */
#define MAGGI_LOAD_VERSION "1"     /* of the key `version`, the second         */

/* The table of the whole file, a mapping. */
extern const cyaml_schema_value_t maggi_load_schema;

/* Write `FILE:LINE: text` on one line; line 0 is left out.  Returns MAGGI_E_MODEL. */
maggi_status maggi_load_fail(const load_error *e, size_t line, const char *format, ...);

/* Check the text against the tables; status MAGGI_OK, MAGGI_E_MODEL, MAGGI_E_MEMORY. */
maggi_status maggi_load_check(const load_error *e, const char *bytes, size_t n);

/* Whether a text is a decimal number. */
int maggi_load_is_decimal(const char *text);

/* All bytes of e->file, NULL on failure, the caller's to free; status MAGGI_OK, MAGGI_E_MEMORY,
 * MAGGI_E_FILE. */
maggi_status maggi_load_read(const load_error *e, char **bytes, size_t *n);

/* Columns `t` and `column` of the CSV file e->file; load_record_free in any case. */
typedef struct load_record {
  double *times, *values;
  int n, cap;
} load_record;

maggi_status maggi_load_record(const load_error *e, const char *column, load_record *record);
void maggi_load_record_free(load_record *record);

/* Numbers of the property file (.tir) e->file with the text bytes. */
maggi_status maggi_load_tir(const load_error *e, const char *bytes, size_t n, maggi_tyre_def *def);

/* Line of a path such as bodies[3].joint.axis or bodies.crank.joint: that of the deepest part of it
 * which exists, at least 1. */
size_t maggi_load_line(const char *bytes, size_t n, const char *path);

/* Check the text of a source and read it; maggi_load_parse_free in any case. */
maggi_status maggi_load_parse(load_source *source);
void maggi_load_parse_free(load_source *source);

/* Read source[0], whose text is there (number = 1), and all that it builds on;
 * maggi_load_files_free in any case. */
maggi_status maggi_load_files(load_files *files);
void maggi_load_files_free(load_files *files);

/* Source of the entry all.LIST[i] and its number there. */
const load_source *maggi_load_entry_source(const load_files *files, const char *list, unsigned i,
                                           unsigned *number);
/* Source of what a text such as `bodies.crank: axis is zero` or `gravity: ..` begins with; otherwise
 * the model file. */
const load_source *maggi_load_text_source(const load_files *files, const char *text);

/* A path that is said in the file `from`, which begins where that is; NULL without memory, to free. */
char *maggi_load_relative(const char *from, const char *file);

/* Build the model; status as maggi_model_create. */
maggi_status maggi_load_build(const load_files *files, maggi_model **model);

#endif
