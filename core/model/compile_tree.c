/* The tree: bodies in the order of the file become chains of one-DOF joints, numbered from the leaves
 * to the root so that a subtree is a range of numbers. */
#include <stdio.h>

#include "compile.h"

/* one joint of a chain, from the parent on */
typedef struct link {
  int kind;    /* MAGGI_ONE_.. */
  int dirkind; /* MAGGI_DIR_.. */
  int axis;    /* of a global direction */
} link;

static const link chain[][MAGGI_JOINT_DOF_MAX] = {
    [MAGGI_JOINT_REVOLUTE] = {{MAGGI_ONE_REVOLUTE, MAGGI_DIR_PARAMETER, 0}},
    [MAGGI_JOINT_PRISMATIC] = {{MAGGI_ONE_PRISMATIC, MAGGI_DIR_PARAMETER, 0}},
    [MAGGI_JOINT_CYLINDRICAL] = {{MAGGI_ONE_PRISMATIC, MAGGI_DIR_PARAMETER, 0},
                                 {MAGGI_ONE_REVOLUTE, MAGGI_DIR_PARAMETER, 0}},
    [MAGGI_JOINT_UNIVERSAL] = {{MAGGI_ONE_REVOLUTE, MAGGI_DIR_PARAMETER, 0},
                               {MAGGI_ONE_REVOLUTE, MAGGI_DIR_PARAMETER, 1}},
    [MAGGI_JOINT_PLANAR] = {{MAGGI_ONE_PRISMATIC, MAGGI_DIR_ACROSS, 0},
                            {MAGGI_ONE_PRISMATIC, MAGGI_DIR_NORMAL, 0},
                            {MAGGI_ONE_REVOLUTE, MAGGI_DIR_PARAMETER, 0}},
    [MAGGI_JOINT_SPHERICAL] = {{MAGGI_ONE_REVOLUTE, MAGGI_DIR_GLOBAL, 2},
                               {MAGGI_ONE_REVOLUTE, MAGGI_DIR_GLOBAL, 1},
                               {MAGGI_ONE_REVOLUTE, MAGGI_DIR_GLOBAL, 0}},
    [MAGGI_JOINT_FREE] = {{MAGGI_ONE_PRISMATIC, MAGGI_DIR_GLOBAL, 2},
                          {MAGGI_ONE_PRISMATIC, MAGGI_DIR_GLOBAL, 1},
                          {MAGGI_ONE_PRISMATIC, MAGGI_DIR_GLOBAL, 0},
                          {MAGGI_ONE_REVOLUTE, MAGGI_DIR_GLOBAL, 2},
                          {MAGGI_ONE_REVOLUTE, MAGGI_DIR_GLOBAL, 1},
                          {MAGGI_ONE_REVOLUTE, MAGGI_DIR_GLOBAL, 0}},
    [MAGGI_JOINT_FIXED] = {{MAGGI_ONE_FIXED, 0, 0}},
};

/* where the numbers of a body of the file lie in p */
typedef struct addresses {
  int point, axis, axis2, inertia;
  int position[MAGGI_JOINT_DOF_MAX], velocity[MAGGI_JOINT_DOF_MAX];
} addresses;

static int links(maggi_joint_type joint)
{
  int dof = maggi_joint_dof(joint);

  return dof ? dof : 1;
}

static int is_zero(const double a[3])
{
  return a[0] == 0.0 && a[1] == 0.0 && a[2] == 0.0;
}

static void add_parameters(maggi_compile *c, const maggi_body_def *d, addresses *adr)
{
  static const char *const tensor[] = {"xx", "yy", "zz", "xy", "xz", "yz"};
  int k, dof = maggi_joint_dof(d->joint);
  const char *unit;
  char dot[16];

  adr->inertia =
      maggi_parameter_add(c, d->mass, "kg", MAGGI_BOUND_NOT_NEGATIVE, "bodies.%s.mass", d->name);
  if (d->is_bar) {
    maggi_parameter_add3(c, d->bar_from, "m", "bodies.%s.bar.from", d->name);
    maggi_parameter_add3(c, d->bar_to, "m", "bodies.%s.bar.to", d->name);
  } else {
    maggi_parameter_add3(c, d->cog, "m", "bodies.%s.cog", d->name);
    for (k = 0; k < 6; ++k)
      maggi_parameter_add(c, d->inertia[k], "kg m^2",
                          k < 3 ? MAGGI_BOUND_NOT_NEGATIVE : MAGGI_BOUND_NONE,
                          "bodies.%s.inertia.%s", d->name, tensor[k]);
  }
  adr->point = maggi_parameter_add3(c, d->point, "m", "bodies.%s.joint.point", d->name);
  adr->axis = adr->axis2 = -1;
  if (d->joint <= MAGGI_JOINT_PLANAR)
    adr->axis = maggi_parameter_add3(c, d->axis, "-", "bodies.%s.joint.axis", d->name);
  if (d->joint == MAGGI_JOINT_UNIVERSAL || (d->joint == MAGGI_JOINT_PLANAR && !is_zero(d->axis2)))
    adr->axis2 = maggi_parameter_add3(c, d->axis2, "-", "bodies.%s.joint.axis2", d->name);
  for (k = 0; k < dof; ++k) {
    adr->position[k] = adr->velocity[k] = -1;
    if (d->motion[k]) continue;
    dot[0] = '\0';
    if (dof > 1) snprintf(dot, sizeof dot, ".%d", k + 1);
    unit = chain[d->joint][k].kind == MAGGI_ONE_REVOLUTE ? "rad" : "m";
    adr->position[k] = maggi_parameter_add(c, d->position[k], unit, MAGGI_BOUND_INITIAL_POSITION,
                                           "bodies.%s.joint.position%s", d->name, dot);
    unit = chain[d->joint][k].kind == MAGGI_ONE_REVOLUTE ? "rad/s" : "m/s";
    adr->velocity[k] = maggi_parameter_add(c, d->velocity_given[k] ? d->velocity[k] : 0.0, unit,
                                           MAGGI_BOUND_INITIAL_VELOCITY,
                                           "bodies.%s.joint.velocity%s", d->name, dot);
  }
}

/* parents, and no cycles: order[] lists the bodies with each parent before its children */
static maggi_status resolve_parents(maggi_compile *c, int *parent, int *order, int *depth)
{
  maggi_builder *b = c->b;
  int i, k, steps, n = 0;

  for (i = 0; i < b->nbody; ++i) {
    parent[i] = maggi_compile_body(c, b->body[i].parent);
    if (parent[i] == -2)
      return maggi_builder_fail(b, MAGGI_E_MODEL, "bodies.%s: parent \"%s\" does not exist",
                                b->body[i].name, b->body[i].parent);
  }
  for (i = 0; i < b->nbody; ++i) {
    steps = 0;
    for (k = i; k >= 0; k = parent[k])
      if (++steps > b->nbody)
        return maggi_builder_fail(
            b, MAGGI_E_MODEL, "bodies.%s: its parents lead back to itself and not to the ground",
            b->body[i].name);
    depth[i] = steps;
  }
  for (k = 1; n < b->nbody; ++k)
    for (i = 0; i < b->nbody; ++i)
      if (depth[i] == k) order[n++] = i;
  return MAGGI_OK;
}

/* numbers of the expanded bodies: subtrees are ranges, a body lies before its own chain */
static void number_bodies(maggi_compile *c, const int *parent, const int *order, int *size,
                          int *top)
{
  maggi_builder *b = c->b;
  int i, k, n, next;

  for (i = 0; i < b->nbody; ++i) size[i] = 0;
  for (k = b->nbody - 1; k >= 0; --k) {
    i = order[k];
    size[i] += links(b->body[i].joint);
    if (parent[i] >= 0) size[parent[i]] += size[i];
  }
  /* top[i]: one after the highest number of the subtree; then the children share what is below */
  next = 0;
  for (k = 0; k < b->nbody; ++k) {
    i = order[k];
    if (parent[i] < 0) {
      next += size[i];
      top[i] = next;
    } else {
      top[i] = c->m->body[parent[i]].coordinate; /* room left below the parent */
      c->m->body[parent[i]].coordinate -= size[i];
    }
    n = links(b->body[i].joint);
    c->m->body[i].body = top[i] - n;
    c->m->body[i].coordinate = top[i] - n;
  }
  c->t->nbody = next;
}

static void push_joint(maggi_compile *c, const maggi_body_def *d, const addresses *adr, int k)
{
  const link *l = &chain[d->joint][k];
  int kind = l->dirkind, at = adr->axis, aux = -1;

  if (kind == MAGGI_DIR_GLOBAL) {
    at = l->axis;
  } else if (kind == MAGGI_DIR_PARAMETER && l->axis == 1) {
    at = adr->axis2;
  } else if (kind == MAGGI_DIR_ACROSS || kind == MAGGI_DIR_NORMAL) {
    aux = adr->axis2;
    if (aux < 0) {
      kind = kind == MAGGI_DIR_ACROSS ? MAGGI_DIR_ACROSS_GLOBAL : MAGGI_DIR_NORMAL_GLOBAL;
      aux = maggi_least_axis(d->axis);
    }
  }
  PUSH(joint, l->kind);
  PUSH(jdirkind, kind);
  PUSH(jdiradr, at);
  PUSH(jdiraux, aux);
  PUSH(jpointadr, adr->point);
}

/* expanded bodies in the order of their numbers; file body and place in its chain of each */
static void push_bodies(maggi_compile *c, const int *parent, const addresses *adr, int *owner)
{
  maggi_builder *b = c->b;
  maggi_model *m = c->m;
  int i, k, n, up, nq = 0;

  for (i = 0; i < b->nbody; ++i)
    for (k = 0; k < links(b->body[i].joint); ++k) owner[m->body[i].body + k] = i;
  for (i = 0; i < c->t->nbody; ++i) {
    n = links(b->body[owner[i]].joint);
    k = n - 1 - (i - m->body[owner[i]].body);
    up = i + 1;
    if (k == 0) up = parent[owner[i]] < 0 ? c->t->nbody : m->body[parent[owner[i]]].body;
    PUSH(parent, up);
    push_joint(c, &b->body[owner[i]], &adr[owner[i]], k);
    if (b->body[owner[i]].joint == MAGGI_JOINT_FIXED) {
      PUSH(qid, -1);
    } else {
      PUSH(qid, nq++);
      PUSH(qbody, i);
    }
  }
  c->t->nq = nq;
}

static void push_lumps(maggi_compile *c, const addresses *adr)
{
  maggi_builder *b = c->b;
  int i;

  for (i = 0; i < b->nbody; ++i) {
    PUSH(lumpkind, b->body[i].is_bar ? MAGGI_LUMP_BAR : MAGGI_LUMP_RIGID);
    PUSH(lumpbody, c->m->body[i].body);
    PUSH(lumpadr, adr[i].inertia);
    PUSH(massive, c->m->body[i].body);
  }
}

static maggi_status push_point_masses(maggi_compile *c)
{
  maggi_builder *b = c->b;
  maggi_status status;
  int i, id, adr;

  for (i = 0; i < b->npoint_mass; ++i) {
    const maggi_point_mass_def *d = &b->point_mass[i];

    status = maggi_compile_link(c, "point_masses", d->name, "body", d->body, &id);
    if (status != MAGGI_OK) return status;
    if (id == c->t->nbody)
      return maggi_builder_fail(b, MAGGI_E_MODEL, "point_masses.%s: the ground takes no mass",
                                d->name);
    adr = maggi_parameter_add(c, d->mass, "kg", MAGGI_BOUND_NOT_NEGATIVE,
                              "bodies.%s.point_masses.%s.mass", d->body, d->name);
    maggi_parameter_add3(c, d->point, "m", "bodies.%s.point_masses.%s.point", d->body, d->name);
    PUSH(lumpkind, MAGGI_LUMP_POINT);
    PUSH(lumpbody, id);
    PUSH(lumpadr, adr);
  }
  return MAGGI_OK;
}

/* coordinates in the order of the file, their names and initial values */
static maggi_status name_coordinates(maggi_compile *c, const addresses *adr)
{
  maggi_builder *b = c->b;
  maggi_model *m = c->m;
  maggi_topo *t = c->t;
  int i, k, n, dof, q;
  size_t nq = (size_t)t->nq;

  m->coordinate = maggi_arena_alloc(&m->arena, nq * sizeof *m->coordinate);
  m->initial_position = maggi_arena_alloc(&m->arena, nq * sizeof(int));
  m->initial_velocity = maggi_arena_alloc(&m->arena, nq * sizeof(int));
  m->position_given = maggi_arena_alloc(&m->arena, nq * sizeof(int));
  m->velocity_given = maggi_arena_alloc(&m->arena, nq * sizeof(int));
  if (!m->coordinate || !m->initial_position || !m->initial_velocity || !m->position_given ||
      !m->velocity_given)
    return MAGGI_E_MEMORY;
  n = 0;
  for (i = 0; i < b->nbody; ++i) {
    dof = maggi_joint_dof(b->body[i].joint);
    m->body[i].coordinate = n;
    for (k = 0; k < dof; ++k) {
      q = c->qid.v[m->body[i].body + dof - 1 - k];
      m->coordinate[n].name = dof > 1
                                  ? maggi_arena_format(&m->arena, "%s.%d", b->body[i].name, k + 1)
                                  : m->body[i].name;
      m->coordinate[n].q = q;
      m->coordinate[n].is_angle = chain[b->body[i].joint][k].kind == MAGGI_ONE_REVOLUTE;
      m->coordinate[n].guided = b->body[i].motion[k] != NULL;
      if (b->body[i].motion[k])
        m->coordinate[n].motion = maggi_arena_text(&m->arena, b->body[i].motion[k]);
      if (b->body[i].motion[k] && !m->coordinate[n].motion) return MAGGI_E_MEMORY;
      m->initial_position[q] = adr[i].position[k];
      m->initial_velocity[q] = adr[i].velocity[k];
      m->position_given[q] = b->body[i].position_given[k];
      m->velocity_given[q] = b->body[i].velocity_given[k];
      if (!m->coordinate[n].name) return MAGGI_E_MEMORY;
      if (adr[i].position[k] >= 0 && !c->no_memory) {
        m->parameter[adr[i].position[k]].coordinate = q;
        m->parameter[adr[i].velocity[k]].coordinate = q;
      }
      ++n;
    }
  }
  m->ncoordinate = n;
  return MAGGI_OK;
}

/* the chain of prismatic joints that carries every other body */
static void push_base(maggi_compile *c)
{
  int i, at = c->t->nbody, next, children;

  for (;;) {
    children = 0;
    next = -1;
    for (i = 0; i < c->t->nbody; ++i) {
      if (c->parent.v[i] == at) {
        ++children;
        next = i;
      }
    }
    if (children != 1 || c->joint.v[next] != MAGGI_ONE_PRISMATIC) return;
    PUSH(base, next);
    at = next;
  }
}

maggi_status maggi_compile_tree(maggi_compile *c)
{
  maggi_builder *b = c->b;
  maggi_model *m = c->m;
  maggi_status status;
  size_t n = (size_t)b->nbody;
  int i, *parent, *order, *work, *top, *owner;
  addresses *adr;

  m->nbody = b->nbody;
  m->body = maggi_arena_alloc(&m->arena, n * sizeof *m->body);
  parent = maggi_arena_alloc(&m->arena, n * sizeof(int));
  order = maggi_arena_alloc(&m->arena, n * sizeof(int));
  work = maggi_arena_alloc(&m->arena, n * sizeof(int));
  top = maggi_arena_alloc(&m->arena, n * sizeof(int));
  owner = maggi_arena_alloc(&m->arena, n * MAGGI_JOINT_DOF_MAX * sizeof(int));
  adr = maggi_arena_alloc(&m->arena, n * sizeof *adr);
  if (!m->body || !parent || !order || !work || !top || !owner || !adr) return MAGGI_E_MEMORY;

  status = resolve_parents(c, parent, order, work);
  if (status != MAGGI_OK) return status;
  for (i = 0; i < b->nbody; ++i) {
    m->body[i].name = maggi_arena_text(&m->arena, b->body[i].name);
    m->body[i].parent = parent[i];
    m->body[i].joint = b->body[i].joint;
    if (!m->body[i].name) return MAGGI_E_MEMORY;
    add_parameters(c, &b->body[i], &adr[i]);
  }
  number_bodies(c, parent, order, work, top);
  push_bodies(c, parent, adr, owner);
  push_lumps(c, adr);
  if (c->no_memory) return MAGGI_E_MEMORY;
  status = push_point_masses(c);
  if (status == MAGGI_OK) status = name_coordinates(c, adr);
  if (status != MAGGI_OK) return status;
  push_base(c);
  m->originadr = adr[order[0]].point;
  c->t->nmassive = c->massive.n;
  c->t->nbase = c->base.n;
  return c->no_memory ? MAGGI_E_MEMORY : MAGGI_OK;
}
