/* Drawing a tree:
 *
 *   ground
 *   |-- crank  revolute
 *   |   `-- coupler  spherical  coupler.1 .. coupler.3
 *   `-- rocker  revolute
 */
#include "tree.h"

#include <stdlib.h>
#include <string.h>

/* Children of node i (0 is the ground, body b is b + 1): first[i], then next[] of each, -1 ends. */
typedef struct tree {
  const maggi_model *model;
  FILE *out;
  int *first;
  int *next;
  char *prefix; /* what stands left of the present branch, 4 characters a level */
} tree;

int tree_coordinate(const maggi_model *m, int body, int k)
{
  char name[512];
  int dof = maggi_joint_dof(maggi_body_joint(m, body));

  if (k >= dof) return -1;
  if (dof == 1) return maggi_coordinate_find(m, maggi_body_name(m, body));
  snprintf(name, sizeof name, "%s.%d", maggi_body_name(m, body), k + 1);
  return maggi_coordinate_find(m, name);
}

static void print_body(const tree *t, int body)
{
  const char *name = maggi_body_name(t->model, body);
  maggi_joint_type joint = maggi_body_joint(t->model, body);
  int dof = maggi_joint_dof(joint);
  int coordinate = tree_coordinate(t->model, body, 0);

  fprintf(t->out, "%s  %s", name, maggi_joint_type_name(joint));
  if (dof > 1) fprintf(t->out, "  %s.1 .. %s.%d", name, name, dof);
  if (dof == 1 && coordinate >= 0 && maggi_coordinate_is_guided(t->model, coordinate))
    fputs("  guided", t->out);
  putc('\n', t->out);
}

static void print_children(const tree *t, int node, size_t depth)
{
  int child;

  for (child = t->first[node]; child >= 0; child = t->next[child]) {
    t->prefix[4 * depth] = '\0';
    fprintf(t->out, "  %s%s", t->prefix, t->next[child] >= 0 ? "|-- " : "`-- ");
    print_body(t, child - 1);
    memcpy(t->prefix + 4 * depth, t->next[child] >= 0 ? "|   " : "    ", 4);
    print_children(t, child, depth + 1);
  }
}

int tree_print(const maggi_model *m, FILE *out)
{
  maggi_model_info info;
  tree t;
  size_t n;
  int i, parent, failed;

  maggi_model_get_info(m, &info);
  n = (size_t)info.bodies + 1;
  t.model = m;
  t.out = out;
  t.first = malloc(n * sizeof *t.first);
  t.next = malloc(n * sizeof *t.next);
  t.prefix = calloc(4 * n + 1, 1);
  failed = !t.first || !t.next || !t.prefix;
  if (!failed) {
    for (i = 0; i <= info.bodies; ++i) t.first[i] = -1;
    for (i = info.bodies; i > 0; --i) { /* backwards: children come out in the order of the file */
      parent = maggi_body_find(m, maggi_body_parent(m, i - 1)) + 1; /* the ground is not found */
      t.next[i] = t.first[parent];
      t.first[parent] = i;
    }
    fprintf(out, "  %s\n", MAGGI_GROUND);
    print_children(&t, 0, 0);
  }
  free(t.first);
  free(t.next);
  free(t.prefix);
  return failed ? -1 : 0;
}
