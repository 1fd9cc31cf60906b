/* Entries of `bodies`: the body, its joint and its point masses. */
#include "load_build.h"

#include <stdio.h>

static const char *joint_word(int i)
{
  return maggi_joint_type_name((maggi_joint_type)i);
}

static const load_words joint_words = {joint_word, maggi_joint_type_find};

/* A quantity of the coordinates of a joint is a number, `position`, where there is one coordinate,
 * and otherwise a list, `positions`, of as many entries as there are coordinates. */
static maggi_status check_count(const load_build *b, const char *key, int given,
                                const char *list_key, unsigned nlist, int dof)
{
  if (given && nlist)
    return maggi_load_fail_at(b, ".joint", "\"%s\" and \"%s\" together", key, list_key);
  if ((given || nlist) && dof == 0)
    return maggi_load_fail_at(b, ".joint", "this joint has no coordinates");
  if (given && dof != 1)
    return maggi_load_fail_at(
        b, ".joint", "\"%s\" is for one coordinate; \"%s\" takes a list of %d", key, list_key, dof);
  if (nlist && nlist != (unsigned)dof)
    return maggi_load_fail_at(b, ".joint", "\"%s\" has %u entries, the joint has %d coordinates",
                              list_key, nlist, dof);
  return MAGGI_OK;
}

static const double *pick(const double *single, double *const *list, unsigned nlist, int i)
{
  return nlist ? list[i] : single;
}

static maggi_status set_coordinates(const load_build *b, const load_joint *j, maggi_body_def *def)
{
  const double *position, *velocity, *guess;
  int dof = maggi_joint_dof(def->joint);
  int i;
  maggi_status status;

  status = check_count(b, "position", j->position != NULL, "positions", j->positions_count, dof);
  if (status == MAGGI_OK)
    status =
        check_count(b, "velocity", j->velocity != NULL, "velocities", j->velocities_count, dof);
  if (status == MAGGI_OK)
    status = check_count(b, "guess", j->guess != NULL, "guesses", j->guesses_count, dof);
  if (status == MAGGI_OK)
    status = check_count(b, "motion", j->motion != NULL, "motions", j->motions_count, dof);
  if (status) return status;

  for (i = 0; i < dof; ++i) {
    position = pick(j->position, j->positions, j->positions_count, i);
    velocity = pick(j->velocity, j->velocities, j->velocities_count, i);
    guess = pick(j->guess, j->guesses, j->guesses_count, i);
    if (position && guess)
      return maggi_load_fail_at(b, ".joint", "position and guess of the same coordinate");
    if (position) def->position_given[i] = MAGGI_INITIAL_GIVEN;
    if (position || guess) def->position[i] = position ? *position : *guess;
    if (velocity) def->velocity_given[i] = MAGGI_INITIAL_GIVEN;
    if (velocity) def->velocity[i] = *velocity;
    def->motion[i] = j->motions_count ? j->motions[i] : j->motion;
  }
  return MAGGI_OK;
}

static maggi_status set_joint(const load_build *b, const load_joint *j, maggi_body_def *def)
{
  /* point, axis, axis2 */
  static const char *const rules[MAGGI_JOINT_TYPE_COUNT] = {
      [MAGGI_JOINT_REVOLUTE] = "rr",    [MAGGI_JOINT_PRISMATIC] = "or",
      [MAGGI_JOINT_CYLINDRICAL] = "rr", [MAGGI_JOINT_UNIVERSAL] = "rrr",
      [MAGGI_JOINT_PLANAR] = "rro",     [MAGGI_JOINT_SPHERICAL] = "r",
      [MAGGI_JOINT_FREE] = "r",         [MAGGI_JOINT_FIXED] = "o"};
  const load_key keys[] = {{"point", j->point != NULL},
                           {"axis", j->axis != NULL},
                           {"axis2", j->axis2 != NULL},
                           {NULL, 0}};
  int type;
  maggi_status status;

  status = maggi_load_word(b, ".joint.type", j->type, &joint_words, &type);
  if (status == MAGGI_OK) status = maggi_load_keys(b, ".joint", j->type, rules[type], keys);
  if (status) return status;
  def->joint = (maggi_joint_type)type;
  maggi_load_copy3(def->point, j->point);
  maggi_load_copy3(def->axis, j->axis);
  maggi_load_copy3(def->axis2, j->axis2);
  return set_coordinates(b, j, def);
}

static maggi_status add_point_masses(const load_build *b, const load_body *body)
{
  maggi_point_mass_def def;
  unsigned i;
  char rest[40];
  maggi_status status;

  for (i = 0; i < body->point_masses_count; ++i) {
    maggi_point_mass_def_init(&def);
    def.name = body->point_masses[i].name;
    def.body = body->name;
    def.mass = body->point_masses[i].mass;
    maggi_load_copy3(def.point, body->point_masses[i].point);
    snprintf(rest, sizeof rest, ".point_masses[%u]", i);
    status = maggi_load_added(b, rest, maggi_builder_point_mass(b->builder, &def));
    if (status) return status;
  }
  return MAGGI_OK;
}

maggi_status maggi_load_body(const load_build *b, const load_body *body)
{
  maggi_body_def def;
  maggi_status status;

  maggi_body_def_init(&def);
  def.name = body->name;
  if (body->parent) def.parent = body->parent;
  status = set_joint(b, &body->joint, &def);
  if (status) return status;
  if (body->bar && (body->cog || body->inertia))
    return maggi_load_fail_at(b, ".bar", "a bar has its own \"cog\" and \"inertia\"");
  def.mass = body->mass;
  maggi_load_copy3(def.cog, body->cog);
  if (body->inertia) {
    def.inertia[0] = body->inertia->xx;
    def.inertia[1] = body->inertia->yy;
    def.inertia[2] = body->inertia->zz;
    def.inertia[3] = body->inertia->xy;
    def.inertia[4] = body->inertia->xz;
    def.inertia[5] = body->inertia->yz;
  }
  if (body->bar) {
    def.is_bar = 1;
    maggi_load_copy3(def.bar_from, body->bar->from);
    maggi_load_copy3(def.bar_to, body->bar->to);
  }
  status = maggi_load_added(b, "", maggi_builder_body(b->builder, &def));
  if (status) return status;
  return add_point_masses(b, body);
}
