/* Loops and rods: building blocks, paths through the tree, entries of the mass matrix. */
#include <math.h>

#include "compile.h"
#include "kernel.h"

static int push_direction(maggi_compile *c, int body, int kind, int adr, int aux, int lean)
{
  PUSH(dirbody, body);
  PUSH(dirkind, kind);
  PUSH(diradr, adr);
  PUSH(diraux, aux);
  PUSH(dirlean, lean);
  return c->dirbody.n - 1;
}

/* one building block between bodies a and b; what it does not use stays 0 */
static void push_prim(maggi_compile *c, int kind, int ba, int bb, int pa, int pb, int da, int db,
                      int adr)
{
  PUSH(primkind, kind);
  PUSH(primloop, c->m->nloop);
  PUSH(primba, ba);
  PUSH(primbb, bb);
  PUSH(primpa, pa);
  PUSH(primpb, pb);
  PUSH(primda, da);
  PUSH(primdb, db);
  PUSH(primadr, adr);
  PUSH(primrow, c->t->nrow);
  c->t->nrow += maggi_prim_rows(kind);
}

static void push_point_plane(maggi_compile *c, const maggi_loop_def *d, int ba, int bb)
{
  int pa, pb, db;

  pa = pb = maggi_parameter_add3(c, d->point_a, "m",
                                 d->has_b ? "loops.%s.point_a" : "loops.%s.point", d->name);
  if (d->has_b) pb = maggi_parameter_add3(c, d->point_b, "m", "loops.%s.point_b", d->name);
  db = maggi_parameter_add3(c, d->has_b ? d->axis_b : d->axis_a, "-", "loops.%s.axis", d->name);
  db = push_direction(c, bb, MAGGI_DIR_PARAMETER, db, -1, 0);
  pa = maggi_compile_point(c, ba, pa);
  push_prim(c, MAGGI_PRIM_PLANE, ba, bb, pa, maggi_compile_point(c, bb, pb), db, db, -1);
}

static void push_loop(maggi_compile *c, const maggi_loop_def *d, int ba, int bb)
{
  int pa, pb, pta, ptb, aa = -1, ab = -1, da = 0, db = 0, va, vb, wb, k;

  pa = pb = maggi_parameter_add3(c, d->point_a, "m",
                                 d->has_b ? "loops.%s.point_a" : "loops.%s.point", d->name);
  if (d->has_b) pb = maggi_parameter_add3(c, d->point_b, "m", "loops.%s.point_b", d->name);
  if (d->type != MAGGI_LOOP_SPHERICAL) {
    k = d->has_b || d->type == MAGGI_LOOP_UNIVERSAL;
    aa = ab =
        maggi_parameter_add3(c, d->axis_a, "-", k ? "loops.%s.axis_a" : "loops.%s.axis", d->name);
    if (k) ab = maggi_parameter_add3(c, d->axis_b, "-", "loops.%s.axis_b", d->name);
    da = push_direction(c, ba, MAGGI_DIR_PARAMETER, aa, -1, 0);
    db = push_direction(c, bb, MAGGI_DIR_PARAMETER, ab, -1, 0);
  }
  pta = maggi_compile_point(c, ba, pa);
  ptb = maggi_compile_point(c, bb, pb);

  if (d->type <= MAGGI_LOOP_UNIVERSAL) push_prim(c, MAGGI_PRIM_POINT, ba, bb, pta, ptb, 0, 0, -1);
  if (d->type == MAGGI_LOOP_REVOLUTE) push_prim(c, MAGGI_PRIM_AXIS, ba, bb, pta, ptb, da, db, -1);
  if (d->type == MAGGI_LOOP_UNIVERSAL) push_prim(c, MAGGI_PRIM_ANGLE, ba, bb, pta, ptb, da, db, -1);
  if (d->type >= MAGGI_LOOP_CYLINDRICAL) {
    k = maggi_least_axis(d->has_b ? d->axis_b : d->axis_a);
    vb = push_direction(c, bb, MAGGI_DIR_ACROSS_GLOBAL, ab, k, 0);
    wb = push_direction(c, bb, MAGGI_DIR_NORMAL_GLOBAL, ab, k, 0);
    push_prim(c, MAGGI_PRIM_PLANE, ba, bb, pta, ptb, da, vb, -1);
    push_prim(c, MAGGI_PRIM_PLANE, ba, bb, pta, ptb, da, wb, -1);
    push_prim(c, MAGGI_PRIM_ANGLE, ba, bb, pta, ptb, da, vb, -2);
    push_prim(c, MAGGI_PRIM_ANGLE, ba, bb, pta, ptb, da, wb, -2);
    if (d->type == MAGGI_LOOP_PRISMATIC) {
      va = push_direction(c, ba, MAGGI_DIR_CARRIED, aa, ab, k);
      push_prim(c, MAGGI_PRIM_ANGLE, ba, bb, pta, ptb, va, wb, -2);
    }
  }
}

static int is_ancestor(const maggi_compile *c, int up, int body)
{
  while (body < up) body = c->parent.v[body];
  return body == up;
}

static int common_body(const maggi_compile *c, int a, int b)
{
  while (!is_ancestor(c, a, b)) a = c->parent.v[a];
  return a;
}

/* coordinates from `top` (exclusive) down to body, from the root on */
static void push_side(maggi_compile *c, int top, int body, int side)
{
  int begin = c->pathq.n, i, k, q;

  for (; body != top; body = c->parent.v[body]) {
    if (c->qid.v[body] >= 0) {
      PUSH(pathq, c->qid.v[body]);
      PUSH(pathside, side);
    }
  }
  if (c->no_memory) return;
  for (i = begin, k = c->pathq.n - 1; i < k; ++i, --k) {
    q = c->pathq.v[i];
    c->pathq.v[i] = c->pathq.v[k];
    c->pathq.v[k] = q;
  }
}

static void push_path(maggi_compile *c, int ba, int bb)
{
  int common = common_body(c, ba, bb);

  PUSH(loopcommon, common);
  push_side(c, common, ba, 0);
  push_side(c, common, bb, 1);
  PUSH(pathadr, c->pathq.n);
}

static maggi_status link_ends(maggi_compile *c, const char *section, const char *name,
                              const char *body_a, const char *body_b, int *ba, int *bb)
{
  maggi_status status;

  status = maggi_compile_link(c, section, name, "body_a", body_a, ba);
  if (status == MAGGI_OK) status = maggi_compile_link(c, section, name, "body_b", body_b, bb);
  if (status == MAGGI_OK && *ba == *bb)
    status = maggi_builder_fail(c->b, MAGGI_E_MODEL, "%s.%s: body_a and body_b are the same body",
                                section, name);
  return status;
}

static maggi_status add_loop(maggi_compile *c, const maggi_loop_def *d)
{
  maggi_model_loop *loop = &c->m->loop[c->m->nloop];
  maggi_status status;
  int ba, bb;

  status = link_ends(c, "loops", d->name, d->body_a, d->body_b, &ba, &bb);
  if (status != MAGGI_OK) return status;
  loop->name = maggi_arena_text(&c->m->arena, d->name);
  loop->kind = maggi_loop_type_name(d->type);
  loop->row = c->t->nrow;
  if (d->type == MAGGI_LOOP_POINT_PLANE)
    push_point_plane(c, d, ba, bb);
  else
    push_loop(c, d, ba, bb);
  loop->rows = c->t->nrow - loop->row;
  push_path(c, ba, bb);
  ++c->m->nloop;
  return loop->name ? MAGGI_OK : MAGGI_E_MEMORY;
}

static maggi_status add_rod(maggi_compile *c, const maggi_rod_def *d)
{
  maggi_model_loop *loop = &c->m->loop[c->m->nloop];
  maggi_status status;
  int ba, bb, adr, adra, adrb, length = -1, pa, pb, k;

  status = link_ends(c, "rods", d->name, d->body_a, d->body_b, &ba, &bb);
  if (status != MAGGI_OK) return status;
  loop->name = maggi_arena_text(&c->m->arena, d->name);
  loop->kind = "rod";
  loop->row = c->t->nrow;
  loop->rows = 1;
  adr = maggi_parameter_add(c, d->mass, "kg", MAGGI_BOUND_NOT_NEGATIVE, "rods.%s.mass", d->name);
  adra = maggi_parameter_add3(c, d->point_a, "m", "rods.%s.point_a", d->name);
  adrb = maggi_parameter_add3(c, d->point_b, "m", "rods.%s.point_b", d->name);
  if (!isnan(d->length))
    length =
        maggi_parameter_add(c, d->length, "m", MAGGI_BOUND_POSITIVE, "rods.%s.length", d->name);
  pa = maggi_compile_point(c, ba, adra);
  pb = maggi_compile_point(c, bb, adrb);
  push_prim(c, MAGGI_PRIM_ROD, ba, bb, pa, pb, 0, 0, length);
  push_path(c, ba, bb);
  for (k = 0; k < 2; ++k) {
    if ((k ? bb : ba) == c->t->nbody) continue;
    PUSH(lumpkind, k ? MAGGI_LUMP_ROD_B : MAGGI_LUMP_ROD_A);
    PUSH(lumpbody, k ? bb : ba);
    PUSH(lumpadr, adr);
  }
  PUSH(rodadr, adr);
  PUSH(rodpa, pa);
  PUSH(rodpb, pb);
  PUSH(rodcommon, common_body(c, ba, bb));
  ++c->m->nloop;
  return loop->name ? MAGGI_OK : MAGGI_E_MEMORY;
}

/* pairs of the tree: each coordinate with itself and its ancestors */
static void push_tree_pairs(maggi_compile *c)
{
  int i, body;

  PUSH(pairadr, 0);
  for (i = 0; i < c->t->nq; ++i) {
    for (body = c->qbody.v[i]; body != c->t->nbody; body = c->parent.v[body]) {
      if (c->qid.v[body] >= 0) {
        PUSH(pairi, i);
        PUSH(pairj, c->qid.v[body]);
      }
    }
    PUSH(pairadr, c->pairi.n);
  }
  c->t->ntreepair = c->pairi.n;
}

/* entry of the mass matrix of two coordinates: of the tree if one carries the other, else appended */
static int find_pair(maggi_compile *c, int i, int j)
{
  int k, low = i < j ? i : j, high = i < j ? j : i;

  for (k = c->pairadr.v[low]; k < c->pairadr.v[low + 1]; ++k)
    if (c->pairj.v[k] == high) return k;
  for (k = c->t->ntreepair; k < c->pairi.n; ++k)
    if (c->pairi.v[k] == low && c->pairj.v[k] == high) return k;
  PUSH(pairi, low);
  PUSH(pairj, high);
  return c->pairi.n - 1;
}

/* coordinates that move one end of a rod: below the common body first, then it and above */
static void push_rod_end(maggi_compile *c, int point, int adr, int common, int *own, int *all)
{
  int body;

  *own = 0;
  *all = 0;
  for (body = c->pointbody.v[point]; body != c->t->nbody; body = c->parent.v[body]) {
    if (c->qid.v[body] < 0) continue;
    PUSH(rodjacpoint, point);
    PUSH(rodjacq, c->qid.v[body]);
    PUSH(rodjacadr, adr);
    PUSH(rodjacother, 0);
    PUSH(rodjacnum, 0);
    ++*all;
    if (body < common) ++*own;
  }
}

/* J_a of a coordinate of side a alone meets J_b of all coordinates that move end b, and conversely;
 * coordinates of the common body are in its composite inertia */
static void push_rod_pairs(maggi_compile *c, int rod)
{
  int common = c->rodcommon.v[rod], owna, alla, ownb, allb, ea, eb, i, j;

  ea = c->rodjacq.n;
  push_rod_end(c, c->rodpa.v[rod], c->rodadr.v[rod], common, &owna, &alla);
  eb = c->rodjacq.n;
  push_rod_end(c, c->rodpb.v[rod], -1, common, &ownb, &allb);
  if (c->no_memory) return;
  for (i = 0; i < alla; ++i) {
    c->rodjacother.v[ea + i] = eb;
    c->rodjacnum.v[ea + i] = i < owna ? allb : ownb;
    for (j = 0; j < c->rodjacnum.v[ea + i]; ++j)
      PUSH(rodpairm, find_pair(c, c->rodjacq.v[ea + i], c->rodjacq.v[eb + j]));
  }
}

maggi_status maggi_compile_loops(maggi_compile *c)
{
  maggi_builder *b = c->b;
  maggi_model *m = c->m;
  maggi_topo *t = c->t;
  maggi_status status = MAGGI_OK;
  int i, k;

  m->loop = maggi_arena_alloc(&m->arena, (size_t)(b->nloop + b->nrod + 1) * sizeof *m->loop);
  m->reach = maggi_arena_alloc(&m->arena, ((size_t)t->nq + 1) * sizeof(int));
  if (!m->loop || !m->reach) return MAGGI_E_MEMORY;
  PUSH(pathadr, 0);
  for (i = 0; i < b->nloop && status == MAGGI_OK; ++i) status = add_loop(c, &b->loop[i]);
  for (i = 0; i < b->nrod && status == MAGGI_OK; ++i) status = add_rod(c, &b->rod[i]);
  if (status != MAGGI_OK) return status;
  push_tree_pairs(c);
  if (c->no_memory) return MAGGI_E_MEMORY;
  for (i = 0; i < c->rodadr.n; ++i) push_rod_pairs(c, i);
  for (k = 0; k < c->pathq.n; ++k) ++m->reach[c->pathq.v[k]];
  t->nlump = c->lumpkind.n;
  t->ndir = c->dirbody.n;
  t->nprim = c->primkind.n;
  t->nloop = m->nloop;
  t->nloop1 = m->nloop + 1;
  t->nq1 = t->nq + 1;
  t->npath = c->pathq.n;
  t->nrod = c->rodadr.n;
  t->nrodjac = c->rodjacq.n;
  t->nrodpair = c->rodpairm.n;
  t->npair = c->pairi.n;
  return c->no_memory ? MAGGI_E_MEMORY : MAGGI_OK;
}
