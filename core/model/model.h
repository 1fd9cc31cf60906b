/* The immutable model: topology, parameter table, names. */
#ifndef MAGGI_MODEL_H
#define MAGGI_MODEL_H

#include "arena.h"
#include "maggi/maggi.h"
#include "topo.h"

/* what a parameter must be besides finite */
typedef enum maggi_bound {
  MAGGI_BOUND_NONE,
  MAGGI_BOUND_NOT_NEGATIVE,
  MAGGI_BOUND_NOT_POSITIVE,
  MAGGI_BOUND_POSITIVE,
  MAGGI_BOUND_INITIAL_POSITION, /* none, but setting it prescribes the position of a coordinate */
  MAGGI_BOUND_INITIAL_VELOCITY
} maggi_bound;

typedef struct maggi_parameter {
  const char *path;
  const char *unit;
  double value;
  maggi_bound bound;
  int coordinate; /* internal, of initial positions and velocities */
} maggi_parameter;

/* What is wrong with a value for a parameter: "must be positive", ..; NULL if nothing. */
const char *maggi_parameter_wrong(const maggi_parameter *p, double value);

typedef struct maggi_model_body {
  const char *name;
  int parent; /* -1: ground */
  maggi_joint_type joint;
  int body;       /* expanded body that carries it */
  int coordinate; /* first coordinate in the order of the file */
} maggi_model_body;

typedef struct maggi_model_coordinate {
  const char *name;
  int q; /* internal number */
  int is_angle;
  int guided;
  const char *motion; /* function that guides it, or NULL */
} maggi_model_coordinate;

typedef struct maggi_model_loop {
  const char *name;
  const char *kind;
  int row, rows;
} maggi_model_loop;

/* a road or a function */
typedef struct maggi_model_kind {
  const char *name;
  const char *type;
} maggi_model_kind;

struct maggi_model {
  maggi_arena arena;
  maggi_topo topo; /* without the plan */
  const char *name;
  const char *source;
  maggi_simulation_def simulation;
  int nparameter, capparameter;
  maggi_parameter *parameter;
  int *pathindex; /* parameters sorted by path */
  int nbody;
  maggi_model_body *body;
  int ncoordinate;
  maggi_model_coordinate *coordinate;
  int nloop;
  maggi_model_loop *loop;
  int originadr;         /* joint point of the first body on the ground */
  int *initial_position; /* (nq) address in p, -1 for guided coordinates */
  int *initial_velocity; /* (nq) */
  int *position_given;   /* (nq) maggi_initial */
  int *velocity_given;   /* (nq) */
  int *reach;            /* (nq) number of loops whose path holds the coordinate */
  const char **springname;
  const char **wheelname;
  int ncolumn;           /* of sensors */
  const char **sensorcolumn;
  const char **sensorunit;
  int *sensorplace; /* 3 times the sensor, and which of its numbers */
  const char **filtercolumn;
  const char **filterunit;
  int nsignal;
  const char **signalname;
  const char **signalunit;
  int rolling;       /* whether wheels start with the spin at which they roll */
  int nhold, *hold;  /* coordinates held while the others find equilibrium */
  maggi_model *twin; /* static twin, NULL: initial positions are those of p */
  int nobjective;
  maggi_objective_def *objective;
  int ndesign;
  maggi_design_def *design;
  maggi_sensor_def *sensor; /* (topo.nsensor) */
  int nwheel;
  maggi_wheel_def *wheel;
  int nforce;
  maggi_force_def *force;
  int nroad;
  maggi_model_kind *road;
  int nfunction;
  maggi_model_kind *function;
};

/* what a signal is, and which one */
typedef enum maggi_signal_kind {
  MAGGI_SIGNAL_POSITION,     /* internal coordinate */
  MAGGI_SIGNAL_VELOCITY,     /* internal coordinate */
  MAGGI_SIGNAL_ACCELERATION, /* internal coordinate */
  MAGGI_SIGNAL_KINETIC,
  MAGGI_SIGNAL_POTENTIAL,
  MAGGI_SIGNAL_TOTAL,  /* kinetic + potential energy */
  MAGGI_SIGNAL_WRENCH, /* 6 times the expanded body, and the component */
  MAGGI_SIGNAL_SENSOR, /* 3 times the sensor, and which of its numbers */
  MAGGI_SIGNAL_FILTER  /* its number */
} maggi_signal_kind;

typedef struct maggi_signal_place {
  maggi_signal_kind kind;
  int index;
} maggi_signal_place;

/* signal.c */
maggi_signal_place maggi_signal_at(const maggi_model *m, int signal);

#endif
