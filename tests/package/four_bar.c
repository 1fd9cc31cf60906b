/* A user's program: a planar four-bar linkage built in C, five seconds, energy kept.
 *
 * Crank (0,0,0)-(0,0,-1), coupler (0,0,-1)-(0,1.2,-1), follower (0,1.2,-1)-(0,1.2,0), uniform thin
 * bars of 1 kg; revolutes about x, cut between coupler and follower; crank rate -1 rad/s.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <maggi/maggi.h>

static const double x_axis[3] = {1.0, 0.0, 0.0};

static maggi_status add_bar(maggi_builder *b, const char *name, const char *parent,
                            const double joint[3], const double end[3], double velocity)
{
  maggi_body_def def;

  maggi_body_def_init(&def);
  def.name = name;
  def.parent = parent;
  def.joint = MAGGI_JOINT_REVOLUTE;
  memcpy(def.point, joint, sizeof def.point);
  memcpy(def.axis, x_axis, sizeof def.axis);
  if (velocity != 0.0) {
    def.velocity_given[0] = MAGGI_INITIAL_GIVEN;
    def.velocity[0] = velocity;
  }
  def.mass = 1.0;
  def.is_bar = 1;
  memcpy(def.bar_from, joint, sizeof def.bar_from);
  memcpy(def.bar_to, end, sizeof def.bar_to);
  return maggi_builder_body(b, &def);
}

static maggi_status build(maggi_builder *b, maggi_model **m)
{
  const double A[3] = {0.0, 0.0, 0.0};
  const double B[3] = {0.0, 0.0, -1.0};
  const double C[3] = {0.0, 1.2, -1.0};
  const double D[3] = {0.0, 1.2, 0.0};
  maggi_loop_def def;
  maggi_status status;

  if ((status = add_bar(b, "crank", MAGGI_GROUND, A, B, -1.0))) return status;
  if ((status = add_bar(b, "coupler", "crank", B, C, 0.0))) return status;
  if ((status = add_bar(b, "follower", MAGGI_GROUND, D, C, 0.0))) return status;
  maggi_loop_def_init(&def);
  def.name = "tip";
  def.type = MAGGI_LOOP_REVOLUTE;
  def.body_a = "coupler";
  def.body_b = "follower";
  memcpy(def.point_a, C, sizeof def.point_a);
  memcpy(def.axis_a, x_axis, sizeof def.axis_a);
  if ((status = maggi_builder_loop(b, &def))) return status;
  return maggi_model_create(b, m);
}

static int fail(const char *what, maggi_status status, const char *message)
{
  fprintf(stderr, "%s: %s: %s\n", what, maggi_status_text(status), message);
  return 1;
}

static double energy(maggi_data *d)
{
  maggi_energy e;

  maggi_get_energy(d, &e);
  return e.kinetic + e.potential - e.work;
}

int main(void)
{
  maggi_builder *b;
  maggi_model *m;
  maggi_data *d;
  maggi_model_info info;
  maggi_loop_state loops;
  maggi_status status;
  double q[3], e0, drift;
  int i;

  if ((status = maggi_builder_create("four_bar", &b))) return fail("builder", status, "");
  if ((status = build(b, &m))) return fail("model", status, maggi_builder_message(b));
  maggi_builder_free(b);
  maggi_model_get_info(m, &info);
  if (info.coordinates != 3) return fail("model", MAGGI_OK, "not three coordinates");
  if ((status = maggi_data_create(m, &d))) return fail("data", status, "");
  if ((status = maggi_data_reset(d))) return fail("reset", status, maggi_data_message(d));
  maggi_get_loop_state(d, &loops);
  if (loops.dof != 1) return fail("reset", MAGGI_OK, "not one degree of freedom");

  e0 = energy(d);
  for (i = 0; i < 5000; ++i)
    if ((status = maggi_step(d, 1e-3))) return fail("step", status, maggi_data_message(d));
  drift = fabs(energy(d) - e0);
  maggi_get_coordinates(d, q, NULL, NULL);
  printf("t %g s, crank %.12f rad, energy %.6f J, drift %.1e J\n", maggi_get_time(d), q[0], e0,
         drift);
  maggi_data_free(d);
  maggi_model_free(m);
  return drift < 1e-8 ? 0 : fail("step", MAGGI_OK, "energy is not kept");
}
