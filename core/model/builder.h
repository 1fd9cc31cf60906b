/* What a builder has collected: copies of the definitions, checked one by one. */
#ifndef MAGGI_BUILDER_H
#define MAGGI_BUILDER_H

#include "arena.h"
#include "maggi/maggi.h"

enum { MAGGI_MESSAGE_SIZE = 512 };

/* kind, section of the model file */
#define MAGGI_BUILDER_LIST(X)                                                                      \
  X(body, bodies)                                                                                  \
  X(point_mass, point_masses)                                                                      \
  X(loop, loops)                                                                                   \
  X(rod, rods)                                                                                     \
  X(spring, springs)                                                                               \
  X(joint_spring, joint_springs)                                                                   \
  X(force, forces)                                                                                 \
  X(tyre, tyres)                                                                                   \
  X(road, roads)                                                                                   \
  X(wheel, wheels)                                                                                 \
  X(function, functions)                                                                           \
  X(sensor, sensors)                                                                               \
  X(filter, filters)                                                                               \
  X(objective, objectives)                                                                         \
  X(design, design)

typedef struct maggi_setting {
  const char *name; /* path, glob or design parameter */
  double value;
} maggi_setting;

struct maggi_builder {
  maggi_arena arena;
  const char *name;
  const char *source;
  double gravity[3];
  maggi_simulation_def simulation;
  maggi_start_def start;
#define X(kind, section)                                                                           \
  maggi_##kind##_def *kind;                                                                        \
  int n##kind, cap##kind;
  MAGGI_BUILDER_LIST(X)
#undef X
  maggi_setting *setting;
  int nsetting, capsetting;
  char message[MAGGI_MESSAGE_SIZE];
};

/* Sets the message and returns status. */
maggi_status maggi_builder_fail(maggi_builder *b, maggi_status status, const char *format, ...);
/* The same for what is wrong with an entry: `section.name: text`. */
maggi_status maggi_fail_at(maggi_builder *b, const char *section, const char *name,
                           const char *format, ...);

/* check.c */
int maggi_all_finite(const double *a, int n);
maggi_status maggi_check_name(maggi_builder *b, const char *section, const char *name);
#define X(kind, section)                                                                           \
  maggi_status maggi_check_##kind(maggi_builder *b, const maggi_##kind##_def *def);
MAGGI_BUILDER_LIST(X)
#undef X

#endif
