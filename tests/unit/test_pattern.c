/* core/implicit/pattern.c: numbers of [1] table 4.4; what each element adds to a tree of which the
 * entries are known, all of them there in J by differences of the kernel; the models of models/. */
#include <dirent.h>

#include "fixture.h"
#include "open_chain.h"

/* ----------------------------------------------------------------------------------- table 4.4 */

static void check_numbers(const maggi_model *m, int n, int entries)
{
  maggi_pattern *p;
  int i, j, k, rising = 1;

  if (!CHECK(maggi_pattern_create(&m->topo, &p) == MAGGI_OK)) exit(1);
  CHECK(p->n == n && p->J.nrow == n && p->J.ncol == 2 * n);
  CHECK(p->J.coladr[0] == 0 && p->J.coladr[2 * n] == entries);
  for (j = 0; j < 2 * n; ++j)
    for (k = p->J.coladr[j]; k < p->J.coladr[j + 1]; ++k)
      rising = rising && p->J.row[k] < n &&
               (k > p->J.coladr[j] ? p->J.row[k] > p->J.row[k - 1] : p->J.row[k] >= 0);
  CHECK(rising);
  for (i = 0; i < n; ++i) CHECK(p->index[p->q[i]] == i && m->topo.qguide[p->q[i]] < 0);
  maggi_pattern_free(p);
}

/* The last two are beyond the thesis.  Columns of verticals are chains, horizontals hang from all
 * of them but the last. */
static void test_numbers(void)
{
  static const int size[][3] = {
      {1, 15, 1410}, {4, 15, 4290}, {7, 15, 7170}, {20, 15, 0}, {60, 15, 0}};
  maggi_model *m = test_file("spatial-four-bar.yaml");
  int i, ny, nz, entries;

  check_numbers(m, 4, 20);
  maggi_model_free(m);
  for (i = 0; i < (int)(sizeof size / sizeof *size); ++i) {
    ny = size[i][0];
    nz = size[i][1];
    entries = 2 * ((ny + 1) * nz * nz + ny * (nz + nz * (nz + 1)));
    CHECK(size[i][2] == 0 || size[i][2] == entries);
    if (!CHECK(maggi_model_multiple_four_bar(ny, nz, &m) == MAGGI_OK)) exit(1);
    check_numbers(m, nz * (2 * ny + 1), entries);
    maggi_model_free(m);
  }
}

/* ------------------------------------------------------------------------------------- elements */

/* c carries the branches a1, a2 (two coordinates) and b1, x (fixed), b2 */
static const char tree[] =
    "gravity: [0.5, -1, -9]\n"
    "bodies:\n"
    "- {name: c, mass: 1.1, cog: [0.2, 0.1, 0.4], inertia: {xx: 0.2, yy: 0.3, zz: 0.25},"
    " joint: {type: revolute, point: [0, 0, 0], axis: [1, 0.3, 0.2]}}\n"
    "- {name: a1, parent: c, mass: 0.7, cog: [0.1, 0.9, 0.2], inertia: {xx: 0.1, yy: 0.12, zz: "
    "0.08},"
    " joint: {type: revolute, point: [0, 0.5, 0.3], axis: [0.1, 0.2, 1]}}\n"
    "- {name: a2, parent: a1, mass: 0.4, cog: [0.3, 1.2, 0.1], inertia: {xx: 0.1, yy: 0.2, zz: "
    "0.3},"
    " joint: {type: universal, point: [0.1, 1, 0.2], axis: [1, 0.2, 0], axis2: [0, 0.3, 1]}}\n"
    "- {name: b1, parent: c, mass: 0.9, cog: [0.5, 0.2, 0.1], inertia: {xx: 0.2, yy: 0.1, zz: 0.3},"
    " joint: {type: revolute, point: [0.5, 0, 0], axis: [0, 0.1, 1]%s}}\n"
    "- {name: x, parent: b1, mass: 0.2, cog: [0.6, 0.4, 0.2], inertia: {xx: 0.1, yy: 0.1, zz: 0.1},"
    " joint: {type: fixed}}\n"
    "- {name: b2, parent: x, mass: 0.3, cog: [0.9, 0.7, 0.1], inertia: {xx: 0.1, yy: 0.3, zz: 0.2},"
    " joint: {type: revolute, point: [0.7, 0.5, 0.3], axis: [1, 0.5, 0.2]}}\n"
    "functions: [{name: f, type: polynomial, coefficients: [0, 1]}]\n"
    "%s\n";

#define SPRING(a, b)                                                                               \
  "springs: [{name: s, body_a: " a ", body_b: " b ", point_a: [0.4, 1.5, 0.3],"                    \
  " point_b: [0.8, 0.6, -0.4], stiffness: 5, free_length: 0.3, damping: 0.2}]"
#define ROD(a, b)                                                                                  \
  "rods: [{name: s, body_a: " a ", body_b: " b ", point_a: [0.4, 1.5, 0.3],"                       \
  " point_b: [0.8, 0.6, -0.4]}]"
#define LOAD(type, more) "forces: [{name: l, type: " type ", body: a2, function: f, " more "}]"
#define FORCE            "point: [0.4, 1.5, 0.3], value: [1, 2, 3]"
#define AIR                                                                                        \
  "point: [0.4, 1.5, 0.3], density: 1, coefficient: 1, area: 1, low_speed: 0.1, wind: [1, 2, 3]"

typedef struct part {
  const char *guide, *text;
  int entries;
} part;

/* Bodies: 6 + 2 (6 + 3) entries.  Between branches of 3 and 2 coordinates: 12, of a load alone 6 */
static const part parts[] = {
    {"", "", 24},
    {"", SPRING("a2", "b2"), 36},
    {"", SPRING("a1", "b2"), 28},
    {"", SPRING("x", "a1"), 26},
    {"", SPRING("a2", "c"), 24},
    {"", SPRING("a2", "a1"), 24},
    {"", SPRING("a2", "ground"), 24},
    {"", ROD("a2", "b2"), 36},
    {"", ROD("b1", "a2"), 30},
    {"", ROD("c", "a2"), 24},
    {"", ROD("ground", "a2"), 24},
    {"", LOAD("force", FORCE), 24},
    {"", LOAD("force", FORCE ", reaction: b2"), 30},
    {"", LOAD("force", FORCE ", reaction: x"), 27},
    {"", LOAD("force", FORCE ", reaction: c"), 24},
    {"", LOAD("force_body", FORCE ", reaction: b2"), 30},
    {"", LOAD("torque", "value: [1, 2, 3], reaction: b2"), 24},
    {"", LOAD("torque_body", "value: [1, 2, 3], reaction: b2"), 30},
    {"", LOAD("drag", AIR), 24},
    {"", LOAD("drag", AIR ", reaction: b2"), 30},
    {"", "forces: [{name: l, type: joint, coordinate: a1, effort: 2}]", 24},
    {"", "joint_springs: [{name: s, coordinate: a1, stiffness: 3}]", 24},
    {"", "joint_springs: [{name: s, coordinate: a1, coordinate2: a2.2, stiffness: 3}]", 24},
    {"", "joint_springs: [{name: s, coordinate: b2, coordinate2: a2.2, stiffness: 3}]", 26},
    {", motion: f", "", 19},
    {", motion: f", SPRING("a2", "b2"), 25},
    {", motion: f", SPRING("a2", "b1"), 19},
    {", motion: f", LOAD("force", FORCE ", reaction: b2"), 22},
};

static void test_elements(void)
{
  open_chain_findings f;
  maggi_model *m;
  maggi_data *d;
  int i;

  for (i = 0; i < (int)(sizeof parts / sizeof *parts); ++i) {
    m = test_model(tree, parts[i].guide, parts[i].text);
    d = test_start(m);
    f = open_chain_examine(d, 2, (unsigned long long)i);
    if (!CHECK(f.n == (*parts[i].guide ? 5 : 6) && f.entries == parts[i].entries && f.wrong == 0 &&
               f.vanished == 0 && f.outside <= 1e-11))
      fprintf(stderr, "  %s: n %d, %d entries, %d wrong, %d vanish, outside %.3g\n", parts[i].text,
              f.n, f.entries, f.wrong, f.vanished, f.outside);
    test_free(d, m);
  }
}

static void test_no_coordinates(void)
{
  maggi_model *m =
      test_model("bodies: [{name: a, mass: 1, joint: {type: prismatic, axis: [1, 0, 0],"
                 " motion: f}}]\n"
                 "functions: [{name: f, type: polynomial, coefficients: [0, 1]}]\n");

  check_numbers(m, 0, 0);
  maggi_model_free(m);
}

/* ----------------------------------------------------------------------------------- models/ */

/* Entries that symmetries switch off: of bodies that slide or turn about a vertical line; on a level road
 * the vertical force on a frame by its place, its heading and the turn of each wheel, on a ramp by the
 * turn alone; the moment on a rocker, which reaches no wheel, by the three ways its frame translates. */
static int vanishing(const char *name)
{
  static const struct {
    const char *name;
    int entries;
  } known[] = {{"flyball-governor.yaml", 2}, {"triple-pendulum-closed.yaml", 27},
               {"wheeled-frame.yaml", 7},    {"wheeled-frame-obstacles.yaml", 2},
               {"seat-shaker.yaml", 1},      {"path-follower.yaml", 7},
               {"sprung-frame.yaml", 6}};
  int i;

  for (i = 0; i < (int)(sizeof known / sizeof *known); ++i)
    if (strcmp(known[i].name, name) == 0) return known[i].entries;
  return 0;
}

static void test_models(void)
{
  DIR *folder = opendir(MAGGI_MODELS_DIR);
  struct dirent *entry;
  open_chain_findings f;
  const char *end;
  maggi_model *m;
  maggi_data *d;
  int n = 0;

  while (folder && (entry = readdir(folder))) {
    end = strrchr(entry->d_name, '.');
    if (!end || strcmp(end, ".yaml") != 0) continue;
    ++n;
    m = test_file(entry->d_name);
    d = test_start(m);
    f = open_chain_examine(d, 12, 7); /* every wheel is on the road in some */
    if (!CHECK(f.wrong == 0 && f.outside <= 1e-11 && f.vanished == vanishing(entry->d_name)))
      fprintf(stderr, "  %s: %d wrong, %d vanish, outside %.3g\n", entry->d_name, f.wrong,
              f.vanished, f.outside);
    test_free(d, m);
  }
  if (folder) closedir(folder);
  CHECK(n > 10);
}

int main(void)
{
  test_numbers();
  test_elements();
  test_no_coordinates();
  test_models();
  return check_done();
}
