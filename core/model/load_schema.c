/* The keys of a model file, once: type, whether required, and where the value goes.
 *
 * models/README.md says what each key means.
 */
#include "load_file.h"

/* rows of the tables: T is the struct, the key is the name of its member */
#define TEXT(T, key)     CYAML_FIELD_STRING_PTR(#key, CYAML_FLAG_POINTER, T, key, 0, ANY_NUMBER)
#define OPT_TEXT(T, key) CYAML_FIELD_STRING_PTR(#key, OPTIONAL_POINTER, T, key, 0, ANY_NUMBER)
#define REAL(T, key)     CYAML_FIELD_FLOAT(#key, CYAML_FLAG_DEFAULT, T, key)
#define ZERO(T, key)     CYAML_FIELD_FLOAT(#key, CYAML_FLAG_OPTIONAL, T, key)
#define OPT_REAL(T, key) CYAML_FIELD_FLOAT_PTR(#key, OPTIONAL_POINTER, T, key)
#define VEC3(T, key)     CYAML_FIELD_SEQUENCE_FIXED(#key, CYAML_FLAG_DEFAULT, T, key, &real, 3)
#define OPT_VEC3(T, key) CYAML_FIELD_SEQUENCE_FIXED(#key, OPTIONAL_POINTER, T, key, &real, 3)
#define LIST(T, key, entry, min, max)                                                              \
  CYAML_FIELD_SEQUENCE(#key, OPTIONAL_POINTER, T, key, &entry, min, max)
#define MANY(T, key, entry) LIST(T, key, entry, 0, ANY_NUMBER)

#define OPTIONAL_POINTER (CYAML_FLAG_OPTIONAL | CYAML_FLAG_POINTER)
#define ANY_NUMBER       CYAML_UNLIMITED

static const cyaml_schema_value_t real = {CYAML_VALUE_FLOAT(CYAML_FLAG_DEFAULT, double)};
static const cyaml_schema_value_t real_or_null = {
    CYAML_VALUE_FLOAT(CYAML_FLAG_POINTER_NULL_STR, double)};
static const cyaml_schema_value_t text = {
    CYAML_VALUE_STRING(CYAML_FLAG_POINTER, char, 0, ANY_NUMBER)};
static const cyaml_schema_value_t text_or_null = {
    CYAML_VALUE_STRING(CYAML_FLAG_POINTER_NULL_STR, char, 0, ANY_NUMBER)};

static const cyaml_schema_field_t joint_keys[] = {
    TEXT(load_joint, type),
    OPT_VEC3(load_joint, point),
    OPT_VEC3(load_joint, axis),
    OPT_VEC3(load_joint, axis2),
    OPT_REAL(load_joint, position),
    OPT_REAL(load_joint, velocity),
    OPT_REAL(load_joint, guess),
    OPT_TEXT(load_joint, motion),
    LIST(load_joint, positions, real_or_null, 1, MAGGI_JOINT_DOF_MAX),
    LIST(load_joint, velocities, real_or_null, 1, MAGGI_JOINT_DOF_MAX),
    LIST(load_joint, guesses, real_or_null, 1, MAGGI_JOINT_DOF_MAX),
    LIST(load_joint, motions, text_or_null, 1, MAGGI_JOINT_DOF_MAX),
    CYAML_FIELD_END};

static const cyaml_schema_field_t inertia_keys[] = {
    ZERO(load_inertia, xx), ZERO(load_inertia, yy), ZERO(load_inertia, zz), ZERO(load_inertia, xy),
    ZERO(load_inertia, xz), ZERO(load_inertia, yz), CYAML_FIELD_END};

static const cyaml_schema_field_t bar_keys[] = {VEC3(load_bar, from), VEC3(load_bar, to),
                                                CYAML_FIELD_END};

static const cyaml_schema_field_t point_mass_keys[] = {
    TEXT(load_point_mass, name), REAL(load_point_mass, mass), VEC3(load_point_mass, point),
    CYAML_FIELD_END};
static const cyaml_schema_value_t point_mass = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, load_point_mass, point_mass_keys)};

static const cyaml_schema_field_t body_keys[] = {
    TEXT(load_body, name),
    OPT_TEXT(load_body, parent),
    CYAML_FIELD_MAPPING("joint", CYAML_FLAG_DEFAULT, load_body, joint, joint_keys),
    ZERO(load_body, mass),
    OPT_VEC3(load_body, cog),
    CYAML_FIELD_MAPPING_PTR("inertia", OPTIONAL_POINTER, load_body, inertia, inertia_keys),
    CYAML_FIELD_MAPPING_PTR("bar", OPTIONAL_POINTER, load_body, bar, bar_keys),
    MANY(load_body, point_masses, point_mass),
    CYAML_FIELD_END};
static const cyaml_schema_value_t body = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, load_body, body_keys)};

static const cyaml_schema_field_t loop_keys[] = {TEXT(load_loop, name),
                                                 TEXT(load_loop, type),
                                                 TEXT(load_loop, body_a),
                                                 TEXT(load_loop, body_b),
                                                 OPT_VEC3(load_loop, point),
                                                 OPT_VEC3(load_loop, point_a),
                                                 OPT_VEC3(load_loop, point_b),
                                                 OPT_VEC3(load_loop, axis),
                                                 OPT_VEC3(load_loop, axis_a),
                                                 OPT_VEC3(load_loop, axis_b),
                                                 CYAML_FIELD_END};
static const cyaml_schema_value_t loop = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, load_loop, loop_keys)};

static const cyaml_schema_field_t rod_keys[] = {TEXT(load_rod, name),       TEXT(load_rod, body_a),
                                                TEXT(load_rod, body_b),     VEC3(load_rod, point_a),
                                                VEC3(load_rod, point_b),    ZERO(load_rod, mass),
                                                OPT_REAL(load_rod, length), CYAML_FIELD_END};
static const cyaml_schema_value_t rod = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, load_rod, rod_keys)};

static const cyaml_schema_field_t slopes_keys[] = {
    REAL(load_slopes, c1),  REAL(load_slopes, c2),  REAL(load_slopes, c3), REAL(load_slopes, c4),
    REAL(load_slopes, v11), REAL(load_slopes, v22), CYAML_FIELD_END};

static const cyaml_schema_field_t spring_keys[] = {
    TEXT(load_spring, name),
    TEXT(load_spring, body_a),
    TEXT(load_spring, body_b),
    VEC3(load_spring, point_a),
    VEC3(load_spring, point_b),
    ZERO(load_spring, stiffness),
    OPT_REAL(load_spring, free_length),
    OPT_REAL(load_spring, preload),
    ZERO(load_spring, damping),
    CYAML_FIELD_MAPPING_PTR("slopes", OPTIONAL_POINTER, load_spring, slopes, slopes_keys),
    CYAML_FIELD_END};
static const cyaml_schema_value_t spring = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, load_spring, spring_keys)};

static const cyaml_schema_field_t joint_spring_keys[] = {TEXT(load_joint_spring, name),
                                                         TEXT(load_joint_spring, coordinate),
                                                         OPT_TEXT(load_joint_spring, coordinate2),
                                                         ZERO(load_joint_spring, stiffness),
                                                         ZERO(load_joint_spring, damping),
                                                         ZERO(load_joint_spring, rest),
                                                         ZERO(load_joint_spring, preload),
                                                         CYAML_FIELD_END};
static const cyaml_schema_value_t joint_spring = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, load_joint_spring, joint_spring_keys)};

static const cyaml_schema_field_t force_keys[] = {
    TEXT(load_force, name),
    TEXT(load_force, type),
    OPT_TEXT(load_force, body),
    OPT_TEXT(load_force, reaction),
    OPT_TEXT(load_force, coordinate),
    OPT_TEXT(load_force, function),
    OPT_VEC3(load_force, point),
    OPT_VEC3(load_force, value),
    OPT_REAL(load_force, effort),
    OPT_REAL(load_force, density),
    OPT_REAL(load_force, coefficient),
    OPT_REAL(load_force, area),
    OPT_REAL(load_force, low_speed),
    OPT_VEC3(load_force, wind),
    LIST(load_force, coordinates, text, 1, ANY_NUMBER),
    OPT_REAL(load_force, speed),
    OPT_REAL(load_force, gain),
    OPT_REAL(load_force, torque),
    OPT_TEXT(load_force, driver),
    CYAML_FIELD_END};
static const cyaml_schema_value_t force = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, load_force, force_keys)};

static const cyaml_schema_field_t tyre_keys[] = {TEXT(load_tyre, name), TEXT(load_tyre, file),
                                                 OPT_REAL(load_tyre, low_camber),
                                                 OPT_REAL(load_tyre, low_speed), CYAML_FIELD_END};
static const cyaml_schema_value_t tyre = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, load_tyre, tyre_keys)};

static const cyaml_schema_field_t road_keys[] = {TEXT(load_road, name),
                                                 TEXT(load_road, type),
                                                 OPT_VEC3(load_road, point),
                                                 OPT_REAL(load_road, slope),
                                                 OPT_REAL(load_road, amplitude),
                                                 OPT_REAL(load_road, wavelength),
                                                 OPT_REAL(load_road, radius),
                                                 OPT_REAL(load_road, height),
                                                 OPT_REAL(load_road, first),
                                                 OPT_REAL(load_road, spacing),
                                                 OPT_REAL(load_road, number),
                                                 OPT_REAL(load_road, fillet),
                                                 LIST(load_road, x, real, 1, ANY_NUMBER),
                                                 LIST(load_road, z, real, 1, ANY_NUMBER),
                                                 CYAML_FIELD_END};
static const cyaml_schema_value_t road = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, load_road, road_keys)};

static const cyaml_schema_field_t wheel_keys[] = {
    TEXT(load_wheel, name),  TEXT(load_wheel, body),     TEXT(load_wheel, carrier),
    TEXT(load_wheel, tyre),  TEXT(load_wheel, road),     TEXT(load_wheel, side),
    VEC3(load_wheel, point), OPT_VEC3(load_wheel, axis), CYAML_FIELD_END};
static const cyaml_schema_value_t wheel = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, load_wheel, wheel_keys)};

static const cyaml_schema_field_t driver_keys[] = {TEXT(load_driver, name),
                                                   TEXT(load_driver, body),
                                                   TEXT(load_driver, coordinate),
                                                   VEC3(load_driver, point),
                                                   OPT_VEC3(load_driver, origin),
                                                   REAL(load_driver, preview),
                                                   REAL(load_driver, gain),
                                                   ZERO(load_driver, feedforward),
                                                   REAL(load_driver, limit),
                                                   REAL(load_driver, stiffness),
                                                   ZERO(load_driver, damping),
                                                   LIST(load_driver, x, real, 1, ANY_NUMBER),
                                                   LIST(load_driver, y, real, 1, ANY_NUMBER),
                                                   LIST(load_driver, speeds, real, 1, ANY_NUMBER),
                                                   CYAML_FIELD_END};
static const cyaml_schema_value_t driver = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, load_driver, driver_keys)};

static const cyaml_schema_field_t function_keys[] = {
    TEXT(load_function, name),
    TEXT(load_function, type),
    OPT_REAL(load_function, value),
    OPT_REAL(load_function, amplitude),
    OPT_REAL(load_function, omega),
    OPT_REAL(load_function, phase),
    OPT_REAL(load_function, offset),
    OPT_REAL(load_function, t0),
    OPT_REAL(load_function, t1),
    OPT_REAL(load_function, y0),
    OPT_REAL(load_function, y1),
    OPT_REAL(load_function, rate),
    LIST(load_function, coefficients, real, 1, ANY_NUMBER),
    LIST(load_function, times, real, 1, ANY_NUMBER),
    LIST(load_function, values, real, 1, ANY_NUMBER),
    CYAML_FIELD_END};
static const cyaml_schema_value_t function = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, load_function, function_keys)};

static const cyaml_schema_field_t sensor_keys[] = {TEXT(load_sensor, name),
                                                   TEXT(load_sensor, type),
                                                   OPT_TEXT(load_sensor, body),
                                                   OPT_VEC3(load_sensor, point),
                                                   OPT_TEXT(load_sensor, element),
                                                   OPT_REAL(load_sensor, low_speed),
                                                   OPT_REAL(load_sensor, low_acceleration),
                                                   LIST(load_sensor, terms, text, 1, ANY_NUMBER),
                                                   LIST(load_sensor, weights, real, 1, ANY_NUMBER),
                                                   OPT_TEXT(load_sensor, unit),
                                                   CYAML_FIELD_END};
static const cyaml_schema_value_t sensor = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, load_sensor, sensor_keys)};

static const cyaml_schema_field_t filter_keys[] = {
    TEXT(load_filter, name),          TEXT(load_filter, signal),
    OPT_TEXT(load_filter, weighting), OPT_REAL(load_filter, f1),
    OPT_REAL(load_filter, f2),        OPT_TEXT(load_filter, f3),
    OPT_TEXT(load_filter, f4),        OPT_REAL(load_filter, q4),
    OPT_TEXT(load_filter, f5),        OPT_REAL(load_filter, q5),
    OPT_TEXT(load_filter, f6),        OPT_REAL(load_filter, q6),
    OPT_REAL(load_filter, gain),      CYAML_FIELD_END};
static const cyaml_schema_value_t filter = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, load_filter, filter_keys)};

static const cyaml_schema_field_t objective_keys[] = {
    TEXT(load_objective, name),
    TEXT(load_objective, type),
    OPT_TEXT(load_objective, signal),
    OPT_REAL(load_objective, target),
    OPT_REAL(load_objective, sharpness),
    OPT_TEXT(load_objective, reference),
    OPT_REAL(load_objective, from),
    OPT_REAL(load_objective, to),
    OPT_TEXT(load_objective, against),
    LIST(load_objective, times, real, 1, ANY_NUMBER),
    LIST(load_objective, values, real, 1, ANY_NUMBER),
    OPT_TEXT(load_objective, file),
    OPT_TEXT(load_objective, column),
    LIST(load_objective, terms, text, 1, ANY_NUMBER),
    LIST(load_objective, weights, real, 1, ANY_NUMBER),
    CYAML_FIELD_END};
static const cyaml_schema_value_t objective = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, load_objective, objective_keys)};

static const cyaml_schema_field_t design_keys[] = {
    TEXT(load_design, name),
    CYAML_FIELD_SEQUENCE("parameters", CYAML_FLAG_POINTER, load_design, parameters, &text, 1,
                         ANY_NUMBER),
    LIST(load_design, factors, real, 1, ANY_NUMBER),
    OPT_REAL(load_design, nominal),
    OPT_REAL(load_design, lower),
    OPT_REAL(load_design, upper),
    OPT_TEXT(load_design, unit),
    CYAML_FIELD_END};
static const cyaml_schema_value_t design = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, load_design, design_keys)};

static const cyaml_schema_field_t set_keys[] = {TEXT(load_set, name), REAL(load_set, value),
                                                CYAML_FIELD_END};
static const cyaml_schema_value_t set = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, load_set, set_keys)};

static const cyaml_schema_field_t simulation_keys[] = {
    ZERO(load_simulation, time), ZERO(load_simulation, step), CYAML_FIELD_END};

static const cyaml_schema_field_t start_keys[] = {
    CYAML_FIELD_BOOL("equilibrium", CYAML_FLAG_OPTIONAL, load_start, equilibrium),
    LIST(load_start, hold, text, 0, ANY_NUMBER),
    CYAML_FIELD_BOOL("rolling", CYAML_FLAG_OPTIONAL, load_start, rolling), CYAML_FIELD_END};

static const cyaml_schema_field_t model_keys[] = {
    TEXT(load_model, format), /* these two come first in a file too, see load_check.c */
    CYAML_FIELD_INT("version", CYAML_FLAG_DEFAULT, load_model, version),
    TEXT(load_model, name),
    OPT_TEXT(load_model, source),
    OPT_TEXT(load_model, base),
    LIST(load_model, remove, text, 1, ANY_NUMBER),
    OPT_VEC3(load_model, gravity),
    CYAML_FIELD_MAPPING_PTR("simulation", OPTIONAL_POINTER, load_model, simulation,
                            simulation_keys),
    CYAML_FIELD_MAPPING_PTR("start", OPTIONAL_POINTER, load_model, start, start_keys),
    MANY(load_model, bodies, body),
    MANY(load_model, loops, loop),
    MANY(load_model, rods, rod),
    MANY(load_model, springs, spring),
    MANY(load_model, joint_springs, joint_spring),
    MANY(load_model, forces, force),
    MANY(load_model, tyres, tyre),
    MANY(load_model, roads, road),
    MANY(load_model, wheels, wheel),
    MANY(load_model, drivers, driver),
    MANY(load_model, functions, function),
    MANY(load_model, sensors, sensor),
    MANY(load_model, filters, filter),
    MANY(load_model, objectives, objective),
    MANY(load_model, design, design),
    MANY(load_model, set, set),
    CYAML_FIELD_END};

_Static_assert(sizeof model_keys / sizeof *model_keys <= MAGGI_LOAD_KEYS_MAX + 1,
               "MAGGI_LOAD_KEYS_MAX");

const cyaml_schema_value_t maggi_load_schema = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_POINTER, load_model, model_keys)};
