/* Entries of all lists but `bodies`. */
#include "load_build.h"

#include <math.h>

/* the two parts of a load_key */
#define KEY(entry, key) #key, entry->key != NULL

static const char *loop_word(int i)
{
  return maggi_loop_type_name((maggi_loop_type)i);
}

static const char *force_word(int i)
{
  return maggi_force_type_name((maggi_force_type)i);
}

static const char *function_word(int i)
{
  return maggi_function_type_name((maggi_function_type)i);
}

static const char *sensor_word(int i)
{
  return maggi_sensor_type_name((maggi_sensor_type)i);
}

static const load_words loop_words = {loop_word, maggi_loop_type_find};
static const load_words force_words = {force_word, maggi_force_type_find};
static const load_words function_words = {function_word, maggi_function_type_find};
static const load_words sensor_words = {sensor_word, maggi_sensor_type_find};

static double number_or_zero(const double *number)
{
  return number ? *number : 0.0;
}

/* ------------------------------------------------------------------------------- loops and rods */

/* A side pair is `point`, shared by both bodies, or `point_a` and `point_b`; likewise the axes. */
static maggi_status check_sides(const load_build *b, const char *key, const double *shared,
                                const double *side_a, const double *side_b)
{
  if (shared && (side_a || side_b))
    return maggi_load_fail_at(b, "", "\"%s\" is for both bodies, so without \"%s_a\" and \"%s_b\"",
                              key, key, key);
  if (!shared && !(side_a && side_b))
    return maggi_load_fail_at(b, "", "key \"%s\" is missing, or \"%s_a\" and \"%s_b\"", key, key,
                              key);
  return MAGGI_OK;
}

maggi_status maggi_load_loop(const load_build *b, const load_loop *loop)
{
  maggi_loop_def def;
  int any_axis = loop->axis || loop->axis_a || loop->axis_b;
  int type;
  maggi_status status;

  maggi_loop_def_init(&def);
  status = maggi_load_word(b, ".type", loop->type, &loop_words, &type);
  if (status) return status;
  if (type == MAGGI_LOOP_SPHERICAL && any_axis)
    return maggi_load_fail_at(b, "", "type %s has no axis", loop->type);
  if (type == MAGGI_LOOP_POINT_PLANE && (loop->axis_a || loop->axis_b))
    return maggi_load_fail_at(b, "", "type %s has one \"axis\", the normal of the plane",
                              loop->type);
  if (type == MAGGI_LOOP_UNIVERSAL && loop->axis)
    return maggi_load_fail_at(b, "", "type %s has \"axis_a\" and \"axis_b\"", loop->type);
  status = check_sides(b, "point", loop->point, loop->point_a, loop->point_b);
  if (status == MAGGI_OK && type != MAGGI_LOOP_SPHERICAL)
    status = check_sides(b, "axis", loop->axis, loop->axis_a, loop->axis_b);
  if (status) return status;

  def.name = loop->name;
  def.type = (maggi_loop_type)type;
  def.body_a = loop->body_a;
  def.body_b = loop->body_b;
  def.has_b = loop->point_b || (loop->axis_b && type != MAGGI_LOOP_UNIVERSAL);
  maggi_load_copy3(def.point_a, loop->point ? loop->point : loop->point_a);
  maggi_load_copy3(def.point_b, loop->point ? loop->point : loop->point_b);
  maggi_load_copy3(def.axis_a, loop->axis ? loop->axis : loop->axis_a);
  maggi_load_copy3(def.axis_b, loop->axis ? loop->axis : loop->axis_b);
  return maggi_load_added(b, "", maggi_builder_loop(b->builder, &def));
}

maggi_status maggi_load_rod(const load_build *b, const load_rod *rod)
{
  maggi_rod_def def;

  maggi_rod_def_init(&def);
  def.name = rod->name;
  def.body_a = rod->body_a;
  def.body_b = rod->body_b;
  maggi_load_copy3(def.point_a, rod->point_a);
  maggi_load_copy3(def.point_b, rod->point_b);
  def.mass = rod->mass;
  if (rod->length) def.length = *rod->length;
  return maggi_load_added(b, "", maggi_builder_rod(b->builder, &def));
}

/* --------------------------------------------------------------------------- springs and forces */

maggi_status maggi_load_spring(const load_build *b, const load_spring *spring)
{
  maggi_spring_def def;

  maggi_spring_def_init(&def);
  if (spring->free_length && spring->preload)
    return maggi_load_fail_at(b, "", "\"free_length\" and \"preload\" together");
  def.name = spring->name;
  def.body_a = spring->body_a;
  def.body_b = spring->body_b;
  maggi_load_copy3(def.point_a, spring->point_a);
  maggi_load_copy3(def.point_b, spring->point_b);
  def.stiffness = spring->stiffness;
  def.free_length = spring->free_length ? *spring->free_length : NAN;
  def.preload = spring->preload ? *spring->preload : 0.0;
  def.damping = spring->damping;
  if (spring->slopes) {
    def.has_slopes = 1;
    def.c[0] = spring->slopes->c1;
    def.c[1] = spring->slopes->c2;
    def.c[2] = spring->slopes->c3;
    def.c[3] = spring->slopes->c4;
    def.v11 = spring->slopes->v11;
    def.v22 = spring->slopes->v22;
  }
  return maggi_load_added(b, "", maggi_builder_spring(b->builder, &def));
}

maggi_status maggi_load_joint_spring(const load_build *b, const load_joint_spring *spring)
{
  maggi_joint_spring_def def;

  maggi_joint_spring_def_init(&def);
  def.name = spring->name;
  def.coordinate = spring->coordinate;
  def.coordinate2 = spring->coordinate2;
  def.stiffness = spring->stiffness;
  def.damping = spring->damping;
  def.rest = spring->rest;
  def.preload = spring->preload;
  return maggi_load_added(b, "", maggi_builder_joint_spring(b->builder, &def));
}

maggi_status maggi_load_force(const load_build *b, const load_force *force)
{
  /* body, reaction, point, value; coordinate, effort; density, coefficient, area, low_speed, wind;
   * coordinates, speed, gain, torque, driver */
  static const char *const rules[MAGGI_FORCE_TYPE_COUNT] = {
      [MAGGI_FORCE_GLOBAL] = "rorr",
      [MAGGI_FORCE_BODY] = "rorr",
      [MAGGI_TORQUE_GLOBAL] = "ro-r",
      [MAGGI_TORQUE_BODY] = "ro-r",
      [MAGGI_FORCE_JOINT] = "----rr",
      [MAGGI_FORCE_DRAG] = "ror---rrrro",
      [MAGGI_FORCE_SPEED] = "r-r------r-rorro",
      [MAGGI_FORCE_SPEED_LINEAR] = "r-r------r-rorro"};
  const load_key keys[] = {{KEY(force, body)},
                           {KEY(force, reaction)},
                           {KEY(force, point)},
                           {KEY(force, value)},
                           {KEY(force, coordinate)},
                           {KEY(force, effort)},
                           {KEY(force, density)},
                           {KEY(force, coefficient)},
                           {KEY(force, area)},
                           {KEY(force, low_speed)},
                           {KEY(force, wind)},
                           {KEY(force, coordinates)},
                           {KEY(force, speed)},
                           {KEY(force, gain)},
                           {KEY(force, torque)},
                           {KEY(force, driver)},
                           {NULL, 0}};
  maggi_force_def def;
  int type;
  maggi_status status;

  maggi_force_def_init(&def);
  status = maggi_load_word(b, ".type", force->type, &force_words, &type);
  if (status == MAGGI_OK) status = maggi_load_keys(b, "", force->type, rules[type], keys);
  if (status) return status;
  def.name = force->name;
  def.type = (maggi_force_type)type;
  def.body = force->body;
  def.reaction = force->reaction;
  def.coordinate = force->coordinate;
  def.function = force->function;
  maggi_load_copy3(def.point, force->point);
  maggi_load_copy3(def.value, force->value);
  if (force->effort) def.value[0] = *force->effort;
  def.density = number_or_zero(force->density);
  def.coefficient = number_or_zero(force->coefficient);
  def.area = number_or_zero(force->area);
  def.low_speed = number_or_zero(force->low_speed);
  maggi_load_copy3(def.wind, force->wind);
  if ((type == MAGGI_FORCE_SPEED || type == MAGGI_FORCE_SPEED_LINEAR) &&
      !force->speed == !force->driver)
    return maggi_load_fail_at(b, "", "either \"speed\" or \"driver\" is needed");
  def.driver = force->driver;
  def.ncoordinate = (int)force->coordinates_count;
  def.coordinates = (const char *const *)force->coordinates;
  def.speed = number_or_zero(force->speed);
  def.gain = number_or_zero(force->gain);
  def.torque = number_or_zero(force->torque);
  return maggi_load_added(b, "", maggi_builder_force(b->builder, &def));
}

maggi_status maggi_load_driver(const load_build *b, const load_driver *driver)
{
  maggi_driver_def def;

  maggi_driver_def_init(&def);
  if (driver->x_count != driver->y_count)
    return maggi_load_fail_at(b, ".y", "%u numbers for %u in x", driver->y_count, driver->x_count);
  if (driver->speeds && driver->speeds_count != driver->x_count)
    return maggi_load_fail_at(b, ".speeds", "%u numbers for %u points", driver->speeds_count,
                              driver->x_count);
  def.name = driver->name;
  def.body = driver->body;
  def.coordinate = driver->coordinate;
  maggi_load_copy3(def.point, driver->point);
  maggi_load_copy3(def.origin, driver->origin);
  def.preview = driver->preview;
  def.gain = driver->gain;
  def.feedforward = driver->feedforward;
  def.limit = driver->limit;
  def.stiffness = driver->stiffness;
  def.damping = driver->damping;
  def.number = (int)driver->x_count;
  def.x = driver->x;
  def.y = driver->y;
  def.speeds = driver->speeds;
  return maggi_load_added(b, "", maggi_builder_driver(b->builder, &def));
}

/* ------------------------------------------------------------------------ functions and sensors */

maggi_status maggi_load_function(const load_build *b, const load_function *f)
{
  /* value; amplitude, omega, phase, offset; t0, t1, y0, y1; coefficients; times, values; rate */
  static const char *const rules[MAGGI_FUNCTION_TYPE_COUNT] = {
      [MAGGI_FUNCTION_CONSTANT] = "r",         [MAGGI_FUNCTION_POLYNOMIAL] = "---------r",
      [MAGGI_FUNCTION_SINE] = "-rroo",         [MAGGI_FUNCTION_STEP] = "-----rrrr",
      [MAGGI_FUNCTION_KNOTS] = "----------rr", [MAGGI_FUNCTION_SPLINE] = "----------rr",
      [MAGGI_FUNCTION_RAMP] = "-----rro----r"};
  const load_key keys[] = {{KEY(f, value)},  {KEY(f, amplitude)},
                           {KEY(f, omega)},  {KEY(f, phase)},
                           {KEY(f, offset)}, {KEY(f, t0)},
                           {KEY(f, t1)},     {KEY(f, y0)},
                           {KEY(f, y1)},     {KEY(f, coefficients)},
                           {KEY(f, times)},  {KEY(f, values)},
                           {KEY(f, rate)},   {NULL, 0}};
  maggi_function_def def;
  double scalars[4] = {0.0, 0.0, 0.0, 0.0};
  int type;
  maggi_status status;

  maggi_function_def_init(&def);
  status = maggi_load_word(b, ".type", f->type, &function_words, &type);
  if (status == MAGGI_OK) status = maggi_load_keys(b, "", f->type, rules[type], keys);
  if (status) return status;
  if (f->times_count != f->values_count)
    return maggi_load_fail_at(b, ".values", "%u values for %u times", f->values_count,
                              f->times_count);
  def.name = f->name;
  def.type = (maggi_function_type)type;
  def.values = scalars;
  switch (def.type) {
  case MAGGI_FUNCTION_CONSTANT:
    def.number = 1;
    scalars[0] = *f->value;
    break;
  case MAGGI_FUNCTION_SINE:
    def.number = 4;
    scalars[0] = *f->amplitude;
    scalars[1] = *f->omega;
    scalars[2] = number_or_zero(f->phase);
    scalars[3] = number_or_zero(f->offset);
    break;
  case MAGGI_FUNCTION_STEP:
    def.number = 4;
    scalars[0] = *f->t0;
    scalars[1] = *f->t1;
    scalars[2] = *f->y0;
    scalars[3] = *f->y1;
    break;
  case MAGGI_FUNCTION_RAMP:
    def.number = 4;
    scalars[0] = *f->t0;
    scalars[1] = *f->t1;
    scalars[2] = number_or_zero(f->y0);
    scalars[3] = *f->rate;
    break;
  case MAGGI_FUNCTION_POLYNOMIAL:
    def.number = (int)f->coefficients_count;
    def.values = f->coefficients;
    break;
  default: /* knots, spline */
    def.number = (int)f->times_count;
    def.times = f->times;
    def.values = f->values;
    break;
  }
  return maggi_load_added(b, "", maggi_builder_function(b->builder, &def));
}

maggi_status maggi_load_sensor(const load_build *b, const load_sensor *sensor)
{
  /* body, point, element; low_speed, low_acceleration; terms, weights, unit */
  static const char *const rules[MAGGI_SENSOR_TYPE_COUNT] = {
      [MAGGI_SENSOR_POSITION] = "ro",
      [MAGGI_SENSOR_VELOCITY] = "ro",
      [MAGGI_SENSOR_ACCELERATION] = "ro",
      [MAGGI_SENSOR_ANGLES] = "r",
      [MAGGI_SENSOR_ANGLE_RATES] = "r",
      [MAGGI_SENSOR_ANGULAR_VELOCITY] = "r",
      [MAGGI_SENSOR_ANGULAR_ACCELERATION] = "r",
      [MAGGI_SENSOR_SPRING] = "--r",
      [MAGGI_SENSOR_JOINT_SPRING] = "--r",
      [MAGGI_SENSOR_ROD] = "--r",
      [MAGGI_SENSOR_TYRE_SLIP] = "--r",
      [MAGGI_SENSOR_TYRE_FORCE] = "--r",
      [MAGGI_SENSOR_TYRE_MOMENT] = "--r",
      [MAGGI_SENSOR_TYRE_CONTACT] = "--r",
      [MAGGI_SENSOR_TYRE_SLOPE] = "--r",
      [MAGGI_SENSOR_LATERAL_ACCELERATION] = "ro-oo",
      [MAGGI_SENSOR_SIDESLIP] = "ro-o",
      [MAGGI_SENSOR_LEVEL_VELOCITY] = "ro",
      [MAGGI_SENSOR_LEVEL_ACCELERATION] = "ro",
      [MAGGI_SENSOR_BODY_ACCELERATION] = "ro",
      [MAGGI_SENSOR_COMBINATION] = "-----roo",
      [MAGGI_SENSOR_SPEED] = "--r",
      [MAGGI_SENSOR_DRIVER] = "--r"};
  const load_key keys[] = {{KEY(sensor, body)},
                           {KEY(sensor, point)},
                           {KEY(sensor, element)},
                           {KEY(sensor, low_speed)},
                           {KEY(sensor, low_acceleration)},
                           {KEY(sensor, terms)},
                           {KEY(sensor, weights)},
                           {KEY(sensor, unit)},
                           {NULL, 0}};
  maggi_sensor_def def;
  int type;
  maggi_status status;

  maggi_sensor_def_init(&def);
  status = maggi_load_word(b, ".type", sensor->type, &sensor_words, &type);
  if (status == MAGGI_OK) status = maggi_load_keys(b, "", sensor->type, rules[type], keys);
  if (status) return status;
  if (sensor->weights && sensor->weights_count != sensor->terms_count)
    return maggi_load_fail_at(b, ".weights", "%u weights for %u terms", sensor->weights_count,
                              sensor->terms_count);
  def.name = sensor->name;
  def.type = (maggi_sensor_type)type;
  def.body = sensor->body;
  def.at_cog = sensor->point == NULL;
  maggi_load_copy3(def.point, sensor->point);
  def.element = sensor->element;
  if (sensor->low_speed) def.low_speed = *sensor->low_speed;
  if (sensor->low_acceleration) def.low_acceleration = *sensor->low_acceleration;
  def.nterm = (int)sensor->terms_count;
  def.terms = (const char *const *)sensor->terms;
  def.weights = sensor->weights;
  def.unit = sensor->unit;
  return maggi_load_added(b, "", maggi_builder_sensor(b->builder, &def));
}
