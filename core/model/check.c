/* What each part of a model must be in itself. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "builder.h"
#include "definition.h"

int maggi_all_finite(const double *a, int n)
{
  int i;

  for (i = 0; i < n; ++i)
    if (!isfinite(a[i])) return 0;
  return 1;
}

static int is_zero(const double a[3])
{
  return a[0] == 0.0 && a[1] == 0.0 && a[2] == 0.0;
}

static int is_same(const double a[3], const double b[3])
{
  return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

static int is_parallel(const double a[3], const double b[3])
{
  double c[3], cc, aa, bb;

  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
  cc = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
  aa = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
  bb = b[0] * b[0] + b[1] * b[1] + b[2] * b[2];
  return cc <= 1e-20 * aa * bb;
}

/* a tensor of inertia is positive semidefinite, and no moment exceeds the sum of the others */
static int is_inertia(const double J[6])
{
  double trace = J[0] + J[1] + J[2], tol = 1e-9 * trace;
  double e[3], P[6];
  int i;

  /* second moments of mass P = trace/2 I - J must be positive semidefinite */
  for (i = 0; i < 3; ++i) P[i] = 0.5 * trace - J[i] + tol;
  for (i = 3; i < 6; ++i) P[i] = -J[i];
  e[0] = P[0] * P[1] - P[3] * P[3];
  e[1] = P[0] * P[2] - P[4] * P[4];
  e[2] = P[0] * (P[1] * P[2] - P[5] * P[5]) - P[3] * (P[3] * P[2] - P[5] * P[4]) +
         P[4] * (P[3] * P[5] - P[1] * P[4]);
  if (trace == 0.0)
    return J[0] == 0.0 && J[1] == 0.0 && J[2] == 0.0 && J[3] == 0.0 && J[4] == 0.0 && J[5] == 0.0;
  return trace > 0.0 && P[0] >= 0.0 && P[1] >= 0.0 && P[2] >= 0.0 &&
         P[1] * P[2] - P[5] * P[5] >= 0.0 && e[0] >= 0.0 && e[1] >= 0.0 && e[2] >= -tol * tol * tol;
}

maggi_status maggi_check_name(maggi_builder *b, const char *section, const char *name)
{
  static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";

  if (!name || !*name)
    return maggi_builder_fail(b, MAGGI_E_MODEL, "%s: an entry has no name", section);
  if (name[strspn(name, letters)] != '\0')
    return maggi_builder_fail(b, MAGGI_E_MODEL, "%s.%s: a name has only letters, digits, _ and -",
                              section, name);
  if (strlen(name) > 100)
    return maggi_builder_fail(b, MAGGI_E_MODEL, "%s.%.20s..: a name has at most 100 characters",
                              section, name);
  return MAGGI_OK;
}

/* fails with `section.name: text` when ok is false */
#define REQUIRE(ok, section, name, ...)                                                            \
  do {                                                                                             \
    if (!(ok)) return maggi_fail_at(b, section, name, __VA_ARGS__);                                \
  } while (0)

maggi_status maggi_fail_at(maggi_builder *b, const char *section, const char *name,
                           const char *format, ...)
{
  char text[MAGGI_MESSAGE_SIZE - 160];
  va_list args;

  va_start(args, format);
  vsnprintf(text, sizeof text, format, args);
  va_end(args);
  return maggi_builder_fail(b, MAGGI_E_MODEL, "%s.%s: %s", section, name, text);
}

maggi_status maggi_check_body(maggi_builder *b, const maggi_body_def *d)
{
  int dof = maggi_joint_dof(d->joint), i;

  REQUIRE(strcmp(d->name, MAGGI_GROUND) != 0, "bodies", d->name, "this name is the fixed body's");
  REQUIRE(dof >= 0, "bodies", d->name, "joint type %d does not exist", (int)d->joint);
  REQUIRE(maggi_all_finite(d->point, 3), "bodies", d->name, "joint point is not finite");
  REQUIRE(maggi_all_finite(d->axis, 3), "bodies", d->name, "joint axis is not finite");
  REQUIRE(maggi_all_finite(d->axis2, 3), "bodies", d->name, "joint axis2 is not finite");
  if (d->joint <= MAGGI_JOINT_PLANAR)
    REQUIRE(!is_zero(d->axis), "bodies", d->name, "joint axis is zero");
  if (d->joint == MAGGI_JOINT_UNIVERSAL) {
    REQUIRE(!is_zero(d->axis2), "bodies", d->name, "joint axis2 is zero");
    REQUIRE(!is_parallel(d->axis, d->axis2), "bodies", d->name,
            "joint axis and axis2 are parallel");
  }
  if (d->joint == MAGGI_JOINT_PLANAR && !is_zero(d->axis2))
    REQUIRE(!is_parallel(d->axis, d->axis2), "bodies", d->name,
            "joint axis2 does not lie in the plane: it is parallel to axis");
  REQUIRE(isfinite(d->mass), "bodies", d->name, "mass is not finite");
  REQUIRE(d->mass >= 0.0, "bodies", d->name, "mass is negative (%g)", d->mass);
  if (d->is_bar) {
    REQUIRE(maggi_all_finite(d->bar_from, 3) && maggi_all_finite(d->bar_to, 3), "bodies", d->name,
            "an end of the bar is not finite");
    REQUIRE(!is_same(d->bar_from, d->bar_to), "bodies", d->name, "the bar has no length");
  } else {
    REQUIRE(maggi_all_finite(d->cog, 3), "bodies", d->name, "cog is not finite");
    REQUIRE(maggi_all_finite(d->inertia, 6), "bodies", d->name, "inertia is not finite");
    REQUIRE(is_inertia(d->inertia), "bodies", d->name,
            "inertia is not that of a body (positive, each moment at most the sum of the others)");
  }
  for (i = 0; i < dof; ++i) {
    REQUIRE(isfinite(d->position[i]), "bodies", d->name, "initial position is not finite");
    REQUIRE(isfinite(d->velocity[i]), "bodies", d->name, "initial velocity is not finite");
    REQUIRE(!d->motion[i] || (d->position_given[i] == MAGGI_INITIAL_FREE &&
                              d->velocity_given[i] == MAGGI_INITIAL_FREE),
            "bodies", d->name,
            "a guided coordinate takes its position and velocity from its motion");
  }
  for (; i < MAGGI_JOINT_DOF_MAX; ++i)
    REQUIRE(!d->motion[i] && d->position_given[i] == MAGGI_INITIAL_FREE &&
                d->velocity_given[i] == MAGGI_INITIAL_FREE,
            "bodies", d->name, "a %s joint has %d coordinates, more are given",
            maggi_joint_type_name(d->joint), dof);
  return MAGGI_OK;
}

maggi_status maggi_check_point_mass(maggi_builder *b, const maggi_point_mass_def *d)
{
  REQUIRE(isfinite(d->mass) && maggi_all_finite(d->point, 3), "point_masses", d->name,
          "a number is not finite");
  REQUIRE(d->mass >= 0.0, "point_masses", d->name, "mass is negative (%g)", d->mass);
  return MAGGI_OK;
}

maggi_status maggi_check_loop(maggi_builder *b, const maggi_loop_def *d)
{
  REQUIRE((int)d->type >= 0 && d->type < MAGGI_LOOP_TYPE_COUNT, "loops", d->name,
          "loop type %d does not exist", (int)d->type);
  REQUIRE(maggi_all_finite(d->point_a, 3) && (!d->has_b || maggi_all_finite(d->point_b, 3)),
          "loops", d->name, "point is not finite");
  if (d->type != MAGGI_LOOP_SPHERICAL) {
    REQUIRE(maggi_all_finite(d->axis_a, 3), "loops", d->name, "axis is not finite");
    REQUIRE(!is_zero(d->axis_a), "loops", d->name, "axis is zero");
    if (d->has_b || d->type == MAGGI_LOOP_UNIVERSAL) {
      REQUIRE(maggi_all_finite(d->axis_b, 3), "loops", d->name, "axis_b is not finite");
      REQUIRE(!is_zero(d->axis_b), "loops", d->name, "axis_b is zero");
    }
  }
  if (d->type == MAGGI_LOOP_UNIVERSAL)
    REQUIRE(!is_parallel(d->axis_a, d->axis_b), "loops", d->name, "axis_a and axis_b are parallel");
  return MAGGI_OK;
}

maggi_status maggi_check_rod(maggi_builder *b, const maggi_rod_def *d)
{
  REQUIRE(maggi_all_finite(d->point_a, 3) && maggi_all_finite(d->point_b, 3), "rods", d->name,
          "an end is not finite");
  REQUIRE(!is_same(d->point_a, d->point_b), "rods", d->name, "the rod has no length");
  REQUIRE(isfinite(d->mass), "rods", d->name, "mass is not finite");
  REQUIRE(d->mass >= 0.0, "rods", d->name, "mass is negative (%g)", d->mass);
  REQUIRE(isnan(d->length) || (isfinite(d->length) && d->length > 0.0), "rods", d->name,
          "length is not positive (%g)", d->length);
  return MAGGI_OK;
}

maggi_status maggi_check_spring(maggi_builder *b, const maggi_spring_def *d)
{
  REQUIRE(maggi_all_finite(d->point_a, 3) && maggi_all_finite(d->point_b, 3), "springs", d->name,
          "an end is not finite");
  REQUIRE(!is_same(d->point_a, d->point_b), "springs", d->name,
          "the ends coincide, the force has no direction");
  REQUIRE(isfinite(d->stiffness) && isfinite(d->damping) && isfinite(d->preload), "springs",
          d->name, "a number is not finite");
  REQUIRE(isnan(d->free_length) || (isfinite(d->free_length) && d->free_length >= 0.0), "springs",
          d->name, "free_length is negative (%g)", d->free_length);
  REQUIRE(isnan(d->free_length) || d->preload == 0.0, "springs", d->name,
          "free_length and preload exclude each other");
  if (d->has_slopes) {
    REQUIRE(maggi_all_finite(d->c, 4) && isfinite(d->v11) && isfinite(d->v22), "springs", d->name,
            "a slope is not finite");
    REQUIRE(d->v11 >= 0.0, "springs", d->name, "v11 is negative (%g)", d->v11);
    REQUIRE(d->v22 <= 0.0, "springs", d->name, "v22 is positive (%g)", d->v22);
  }
  return MAGGI_OK;
}

maggi_status maggi_check_joint_spring(maggi_builder *b, const maggi_joint_spring_def *d)
{
  REQUIRE(isfinite(d->stiffness) && isfinite(d->damping) && isfinite(d->rest) &&
              isfinite(d->preload),
          "joint_springs", d->name, "a number is not finite");
  return MAGGI_OK;
}

static maggi_status check_speed(maggi_builder *b, const maggi_force_def *d)
{
  int i;

  REQUIRE(d->ncoordinate >= 1 && d->coordinates, "forces", d->name, "coordinates are missing");
  for (i = 0; i < d->ncoordinate; ++i)
    REQUIRE(d->coordinates[i], "forces", d->name, "coordinates: number %d is missing", i + 1);
  REQUIRE(isfinite(d->speed) && isfinite(d->gain) && isfinite(d->torque), "forces", d->name,
          "a number is not finite");
  return MAGGI_OK;
}

maggi_status maggi_check_force(maggi_builder *b, const maggi_force_def *d)
{
  REQUIRE((int)d->type >= 0 && d->type < MAGGI_FORCE_TYPE_COUNT, "forces", d->name,
          "force type %d does not exist", (int)d->type);
  REQUIRE(maggi_all_finite(d->point, 3) && maggi_all_finite(d->value, 3), "forces", d->name,
          "a number is not finite");
  if (d->type == MAGGI_FORCE_SPEED || d->type == MAGGI_FORCE_SPEED_LINEAR) return check_speed(b, d);
  return MAGGI_OK;
}

maggi_status maggi_check_tyre(maggi_builder *b, const maggi_tyre_def *d)
{
  static const char *const keys[MAGGI_TYRE_NUMBERS] = {
#define X(name, key, unit, value, bound) #key,
      MAGGI_TYRE_LIST(X)
#undef X
  };
  int i;

  REQUIRE(d->side == MAGGI_LEFT || d->side == MAGGI_RIGHT, "tyres", d->name,
          "side %d does not exist", (int)d->side);
  for (i = 0; i < MAGGI_TYRE_NUMBERS; ++i) {
    REQUIRE(!isnan(d->value[i]), "tyres", d->name, "%s is missing", keys[i]);
    REQUIRE(isfinite(d->value[i]), "tyres", d->name, "%s is not finite", keys[i]);
  }
  return MAGGI_OK;
}

static maggi_status check_bumps(maggi_builder *b, const maggi_road_def *d)
{
  double c = sqrt(d->height * (2.0 * d->radius - d->height));

  REQUIRE(d->number >= 1, "roads", d->name, "the number of bumps must be positive (%d)", d->number);
  REQUIRE(d->radius > 0.0 && isfinite(d->radius), "roads", d->name, "radius must be positive (%g)",
          d->radius);
  REQUIRE(d->height > 0.0 && d->height <= d->radius, "roads", d->name,
          "height must be between 0 and the radius (%g, %g)", d->height, d->radius);
  REQUIRE(isfinite(d->first), "roads", d->name, "first is not finite");
  REQUIRE(d->fillet >= 0.0 && d->fillet <= 2.0 * c, "roads", d->name,
          "fillet must be between 0 and the length of a bump (%g, %g)", d->fillet, 2.0 * c);
  REQUIRE(isfinite(d->spacing) && (d->number == 1 || d->spacing >= 2.0 * c + d->fillet), "roads",
          d->name, "spacing must be at least the length of a bump with its fillet (%g, %g)",
          d->spacing, 2.0 * c + d->fillet);
  return MAGGI_OK;
}

static maggi_status check_profile(maggi_builder *b, const maggi_road_def *d)
{
  int i;

  REQUIRE(d->number >= 2, "roads", d->name, "at least two points are needed, not %d", d->number);
  REQUIRE(d->x && d->z && maggi_all_finite(d->x, d->number) && maggi_all_finite(d->z, d->number),
          "roads", d->name, "a point is not finite");
  for (i = 1; i < d->number; ++i)
    REQUIRE(d->x[i] > d->x[i - 1], "roads", d->name, "x does not increase (%g after %g)", d->x[i],
            d->x[i - 1]);
  return MAGGI_OK;
}

maggi_status maggi_check_road(maggi_builder *b, const maggi_road_def *d)
{
  REQUIRE((int)d->type >= 0 && d->type < MAGGI_ROAD_TYPE_COUNT, "roads", d->name,
          "road type %d does not exist", (int)d->type);
  REQUIRE(maggi_all_finite(d->point, 3) && isfinite(d->slope) && isfinite(d->amplitude), "roads",
          d->name, "a number is not finite");
  if (d->type == MAGGI_ROAD_BUMPS) return check_bumps(b, d);
  if (d->type == MAGGI_ROAD_PROFILE) return check_profile(b, d);
  return MAGGI_OK;
}

maggi_status maggi_check_wheel(maggi_builder *b, const maggi_wheel_def *d)
{
  REQUIRE(d->side == MAGGI_LEFT || d->side == MAGGI_RIGHT, "wheels", d->name,
          "side %d does not exist", (int)d->side);
  REQUIRE(maggi_all_finite(d->point, 3), "wheels", d->name, "point is not finite");
  REQUIRE(maggi_all_finite(d->axis, 3), "wheels", d->name, "axis is not finite");
  REQUIRE(!is_zero(d->axis), "wheels", d->name, "axis is zero");
  return MAGGI_OK;
}

maggi_status maggi_check_driver(maggi_builder *b, const maggi_driver_def *d)
{
  int i;

  REQUIRE(isfinite(d->preview) && isfinite(d->gain) && isfinite(d->feedforward) &&
              isfinite(d->limit) && isfinite(d->stiffness) && isfinite(d->damping) &&
              maggi_all_finite(d->point, 3) && maggi_all_finite(d->origin, 3),
          "drivers", d->name, "a number is not finite");
  REQUIRE(d->number >= 3 && d->x && d->y, "drivers", d->name,
          "a path needs at least three points, not %d", d->number);
  REQUIRE(maggi_all_finite(d->x, d->number) && maggi_all_finite(d->y, d->number) &&
              (!d->speeds || maggi_all_finite(d->speeds, d->number)),
          "drivers", d->name, "a point or a speed is not finite");
  for (i = 1; i < d->number; ++i)
    REQUIRE(hypot(d->x[i] - d->x[i - 1], d->y[i] - d->y[i - 1]) > 1e-6, "drivers", d->name,
            "points %d and %d of the path coincide (%g, %g)", i, i + 1, d->x[i], d->y[i]);
  return MAGGI_OK;
}

maggi_status maggi_check_function(maggi_builder *b, const maggi_function_def *d)
{
  int i, n = d->number;

  REQUIRE((int)d->type >= 0 && d->type < MAGGI_FUNCTION_TYPE_COUNT, "functions", d->name,
          "function type %d does not exist", (int)d->type);
  if (d->type == MAGGI_FUNCTION_CONSTANT)
    n = 1;
  else if (d->type == MAGGI_FUNCTION_SINE || d->type == MAGGI_FUNCTION_STEP ||
           d->type == MAGGI_FUNCTION_RAMP)
    n = 4;
  else if (d->type == MAGGI_FUNCTION_POLYNOMIAL)
    REQUIRE(n >= 1, "functions", d->name, "a polynomial needs a coefficient");
  else
    REQUIRE(n >= 2, "functions", d->name, "at least two points are needed, not %d", n);
  REQUIRE(d->values && maggi_all_finite(d->values, n), "functions", d->name,
          "a value is not finite");
  if (d->type == MAGGI_FUNCTION_STEP || d->type == MAGGI_FUNCTION_RAMP)
    REQUIRE(d->values[1] > d->values[0], "functions", d->name, "t1 is not after t0");
  if (d->type == MAGGI_FUNCTION_KNOTS || d->type == MAGGI_FUNCTION_SPLINE) {
    REQUIRE(d->times && maggi_all_finite(d->times, n), "functions", d->name,
            "a time is not finite");
    for (i = 1; i < n; ++i)
      REQUIRE(d->times[i] > d->times[i - 1], "functions", d->name,
              "times do not increase (%g after %g)", d->times[i], d->times[i - 1]);
  }
  return MAGGI_OK;
}

maggi_status maggi_check_sensor(maggi_builder *b, const maggi_sensor_def *d)
{
  int i;

  REQUIRE((int)d->type >= 0 && d->type < MAGGI_SENSOR_TYPE_COUNT, "sensors", d->name,
          "sensor type %d does not exist", (int)d->type);
  REQUIRE(maggi_all_finite(d->point, 3), "sensors", d->name, "point is not finite");
  if (d->type != MAGGI_SENSOR_COMBINATION) return MAGGI_OK;
  REQUIRE(d->nterm >= 1 && d->terms, "sensors", d->name, "terms are missing");
  for (i = 0; i < d->nterm; ++i)
    REQUIRE(d->terms[i], "sensors", d->name, "terms: number %d is missing", i + 1);
  REQUIRE(!d->weights || maggi_all_finite(d->weights, d->nterm), "sensors", d->name,
          "weights are not finite");
  return MAGGI_OK;
}

maggi_status maggi_check_filter(maggi_builder *b, const maggi_filter_def *d)
{
  static const char *const keys[] = {"f1", "f2", "f3", "f4", "f5", "f6", "q4", "q5", "q6", "gain"};
  const double values[] = {d->f1, d->f2, d->f3, d->f4, d->f5, d->f6, d->q4, d->q5, d->q6, d->gain};
  int has_transition = isfinite(d->f4), has_step = isfinite(d->f5);
  int i;

  for (i = 0; i < 10; ++i) {
    if ((i == 6 && !has_transition) || ((i == 7 || i == 8) && !has_step)) continue;
    REQUIRE(!isnan(values[i]), "filters", d->name, "%s is missing", keys[i]);
    REQUIRE(isfinite(values[i]) || (i >= 2 && i < 6), "filters", d->name, "%s is not finite",
            keys[i]);
    REQUIRE(values[i] > 0.0 || i == 9, "filters", d->name, "%s is not positive (%g)", keys[i],
            values[i]);
  }
  REQUIRE(has_transition || !isfinite(d->f3), "filters", d->name,
          "f3 needs f4 and q4, those of the same section");
  REQUIRE(has_step == isfinite(d->f6), "filters", d->name,
          "f5 and f6 are of the same section: both or none");
  return MAGGI_OK;
}

maggi_status maggi_check_objective(maggi_builder *b, const maggi_objective_def *d)
{
  char text[200];

  REQUIRE(maggi_objective_wrong(d, text, sizeof text) == MAGGI_OK, "objectives", d->name, "%s",
          text);
  return MAGGI_OK;
}

maggi_status maggi_check_design(maggi_builder *b, const maggi_design_def *d)
{
  char text[200];

  REQUIRE(strcmp(d->name, "all") != 0, "design", d->name, "this name means all parameters");
  REQUIRE(maggi_design_wrong(d, text, sizeof text) == MAGGI_OK, "design", d->name, "%s", text);
  return MAGGI_OK;
}
