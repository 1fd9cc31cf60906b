/* The multiple four-bar mechanism ny x nz of [1] 4.6.2: an array of parallelograms that hangs in the
 * yz plane.  Vertical bars v_R_C hang from the verticals above, the first row from the ground;
 * horizontal bars h_R_C hang from the foot of the left vertical and are cut by a revolute at the foot
 * of the right one. */
#include <stdio.h>

#include "maggi/maggi.h"

static maggi_status add_bar(maggi_builder *b, const char *name, const char *parent, double y,
                            double z, double dy, double dz, int held, double rate)
{
  maggi_body_def d;

  maggi_body_def_init(&d);
  d.name = name;
  d.parent = parent;
  d.point[1] = y;
  d.point[2] = z;
  d.mass = 1.0;
  d.is_bar = 1;
  d.bar_from[1] = y;
  d.bar_from[2] = z;
  d.bar_to[1] = y + dy;
  d.bar_to[2] = z + dz;
  d.velocity_given[0] = held ? MAGGI_INITIAL_GIVEN : MAGGI_INITIAL_FREE;
  d.velocity[0] = rate;
  return maggi_builder_body(b, &d);
}

static maggi_status add_row(maggi_builder *b, int ny, int row)
{
  static const double rate = 1.04719755119659774615; /* pi/3 */
  maggi_status status = MAGGI_OK;
  maggi_loop_def cut;
  char name[48], above[48], foot[48];
  int col;

  for (col = 1; col <= ny + 1 && status == MAGGI_OK; ++col) {
    snprintf(name, sizeof name, "v_%d_%d", row, col);
    snprintf(above, sizeof above, "v_%d_%d", row - 1, col);
    status = add_bar(b, name, row == 1 ? MAGGI_GROUND : above, col - 1, 1 - row, 0.0, -1.0,
                     col == 1, row == 1 && col == 1 ? rate : 0.0);
  }
  for (col = 1; col <= ny && status == MAGGI_OK; ++col) {
    snprintf(name, sizeof name, "h_%d_%d", row, col);
    snprintf(above, sizeof above, "v_%d_%d", row, col);
    snprintf(foot, sizeof foot, "v_%d_%d", row, col + 1);
    status = add_bar(b, name, above, col - 1, -row, 1.0, 0.0, 0, 0.0);
    if (status != MAGGI_OK) break;
    maggi_loop_def_init(&cut);
    cut.name = name;
    cut.type = MAGGI_LOOP_REVOLUTE;
    cut.body_a = name;
    cut.body_b = foot;
    cut.point_a[1] = col;
    cut.point_a[2] = -row;
    status = maggi_builder_loop(b, &cut);
  }
  return status;
}

static maggi_status add_objectives(maggi_builder *b)
{
  static const struct {
    const char *name, *signal;
    maggi_objective_type type;
  } list[] = {{"swing", "v_1_1.v", MAGGI_OBJECTIVE_INTEGRAL_SQUARE},
              {"load", "v_1_1.fz", MAGGI_OBJECTIVE_RMS},
              {"energy", "energy.kinetic", MAGGI_OBJECTIVE_MEAN},
              {"turn", "h_1_1.q", MAGGI_OBJECTIVE_TERMINAL}};
  maggi_objective_def def;
  maggi_status status = MAGGI_OK;
  size_t i;

  for (i = 0; i < sizeof list / sizeof *list && status == MAGGI_OK; ++i) {
    maggi_objective_def_init(&def);
    def.name = list[i].name;
    def.signal = list[i].signal;
    def.type = list[i].type;
    status = maggi_builder_objective(b, &def);
  }
  return status;
}

maggi_status maggi_model_multiple_four_bar(int ny, int nz, maggi_model **model)
{
  static const maggi_simulation_def simulation = {5.0, 0.001};
  maggi_builder *b;
  maggi_status status;
  char name[64];
  int row;

  *model = NULL;
  if (ny < 1 || nz < 1 || ny > 10000 || nz > 10000) return MAGGI_E_VALUE;
  snprintf(name, sizeof name, "multiple-four-bar:%dx%d", ny, nz);
  status = maggi_builder_create(name, &b);
  if (status != MAGGI_OK) return status;
  status =
      maggi_builder_source(b, "Multiple four-bar mechanism of Callejo's thesis (2013), 4.6.2.");
  if (status == MAGGI_OK) status = maggi_builder_simulation(b, &simulation);
  for (row = 1; row <= nz && status == MAGGI_OK; ++row) status = add_row(b, ny, row);
  if (status == MAGGI_OK) status = add_objectives(b);
  if (status == MAGGI_OK) status = maggi_model_create(b, model);
  maggi_builder_free(b);
  return status;
}
