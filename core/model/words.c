/* The words of model files and the texts of the enumerations of maggi.h. */
#include <string.h>

#include "maggi/maggi.h"

static const char *const joint_words[] = {"revolute", "prismatic", "cylindrical", "universal",
                                          "planar",   "spherical", "free",        "fixed"};
static const char *const loop_words[] = {"spherical",   "revolute",  "universal",
                                         "cylindrical", "prismatic", "point_plane"};
static const char *const force_words[] = {
    "force", "force_body", "torque",           "torque_body",
    "joint", "drag",       "speed_controller", "speed_controller_linear"};
static const char *const function_words[] = {"constant", "polynomial", "sine", "step",
                                             "knots",    "spline",     "ramp"};
static const char *const sensor_words[] = {"position",
                                           "velocity",
                                           "acceleration",
                                           "angles",
                                           "angle_rates",
                                           "angular_velocity",
                                           "angular_acceleration",
                                           "spring",
                                           "joint_spring",
                                           "rod",
                                           "tyre_slip",
                                           "tyre_force",
                                           "tyre_moment",
                                           "tyre_contact",
                                           "tyre_slope",
                                           "lateral_acceleration",
                                           "sideslip",
                                           "level_velocity",
                                           "level_acceleration",
                                           "body_acceleration",
                                           "combination",
                                           "speed_controller",
                                           "driver"};
static const char *const road_words[] = {"flat", "sine", "bumps", "profile"};
static const char *const weighting_words[] = {"Wk", "Wd", "Wf", "Wc", "We", "Wj", "Wb", "Wg"};
static const char *const objective_words[] = {"integral",
                                              "integral_square",
                                              "mean",
                                              "mean_square",
                                              "rms",
                                              "rmq",
                                              "vdv",
                                              "maximum",
                                              "minimum",
                                              "peak",
                                              "smooth_maximum",
                                              "value",
                                              "terminal",
                                              "least_squares",
                                              "sum",
                                              "norm",
                                              "violation",
                                              "slope"};
static const char *const reference_words[] = {"none", "initial", "final"};
static const int joint_dofs[] = {1, 1, 2, 2, 3, 3, 6, 0};

static int find(const char *const words[], int n, const char *word)
{
  int i;

  for (i = 0; word && i < n; ++i)
    if (strcmp(words[i], word) == 0) return i;
  return -1;
}

#define WORDS(kind, count)                                                                         \
  const char *maggi_##kind##_type_name(maggi_##kind##_type type)                                   \
  {                                                                                                \
    return (int)type >= 0 && (int)type < count ? kind##_words[type] : NULL;                        \
  }                                                                                                \
  int maggi_##kind##_type_find(const char *name)                                                   \
  {                                                                                                \
    return find(kind##_words, count, name);                                                        \
  }

WORDS(joint, MAGGI_JOINT_TYPE_COUNT)
WORDS(loop, MAGGI_LOOP_TYPE_COUNT)
WORDS(force, MAGGI_FORCE_TYPE_COUNT)
WORDS(road, MAGGI_ROAD_TYPE_COUNT)
WORDS(function, MAGGI_FUNCTION_TYPE_COUNT)
WORDS(sensor, MAGGI_SENSOR_TYPE_COUNT)
WORDS(weighting, MAGGI_WEIGHTING_TYPE_COUNT)
WORDS(objective, MAGGI_OBJECTIVE_TYPE_COUNT)
WORDS(reference, MAGGI_REFERENCE_TYPE_COUNT)

int maggi_joint_dof(maggi_joint_type type)
{
  return (int)type >= 0 && (int)type < MAGGI_JOINT_TYPE_COUNT ? joint_dofs[type] : -1;
}

const char *maggi_status_text(maggi_status status)
{
  static const char *const texts[] = {
#define X(name, text) text,
      MAGGI_STATUS_LIST(X)
#undef X
  };

  return (int)status >= 0 && (int)status < MAGGI_STATUS_COUNT ? texts[status] : "unknown status";
}
