/* maggi modes: frequencies and damping of small motions about static equilibrium. */
#include "modes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <maggi/maggi.h>

#include "commands.h"
#include "json.h"
#include "message.h"
#include "standstill.h"

/* of coordinates [m/s, rad/s], at which slopes of dampers are taken: far below their knees */
static const double small_rate = 1e-6;
static const double turn = 6.28318530717958647693;

static double frequency(const mode *x)
{
  return hypot(x->real, x->imaginary) / turn;
}

static double damping(const mode *x)
{
  double size = hypot(x->real, x->imaginary);

  return size > 0.0 ? -x->real / size : 0.0;
}

static const char *most(const standstill *s, const int *coordinate, const mode *x)
{
  return maggi_coordinate_name(s->model, coordinate[x->coordinate]);
}

/* what was found, with the dampers (n) and without them (nundamped) */
typedef struct findings {
  int n, nundamped;
  mode *modes, *undamped;
} findings;

static void print_text(const standstill *s, const int *coordinate, const findings *f)
{
  const mode *modes = f->modes;
  int i;

  printf("model         %s\n", s->info.name);
  printf(
      "modes         of %d coordinates about static equilibrium; dampers with the mean of their\n"
      "              slopes at rest, wheels as vertical springs\n\n",
      s->state.coordinates);
  puts("      frequency        damped    damping  most kinetic energy");
  for (i = 0; i < f->n; ++i)
    printf("%3d  %10.6g Hz  %10.6g Hz  %9.6f  %s\n", i + 1, frequency(&modes[i]),
           modes[i].imaginary / turn, damping(&modes[i]), most(s, coordinate, &modes[i]));
  puts("\nwithout dampers");
  for (i = 0; i < f->nundamped; ++i)
    printf("%3d  %10.6g Hz  %26s  %s\n", i + 1, frequency(&f->undamped[i]), "",
           most(s, coordinate, &f->undamped[i]));
}

static void print_json(const standstill *s, const int *coordinate, const findings *f)
{
  const mode *modes = f->modes;
  json j;
  int i;

  json_init(&j, stdout);
  json_open_object(&j, NULL);
  json_string(&j, "model", s->info.name);
  json_open_array(&j, "modes");
  for (i = 0; i < f->n; ++i) {
    json_open_object(&j, NULL);
    json_number(&j, "frequency", frequency(&modes[i]));
    json_number(&j, "damped_frequency", modes[i].imaginary / turn);
    json_number(&j, "damping", damping(&modes[i]));
    json_number(&j, "real", modes[i].real);
    json_number(&j, "imaginary", modes[i].imaginary);
    json_string(&j, "coordinate", most(s, coordinate, &modes[i]));
    json_close_object(&j);
  }
  json_close_array(&j);
  json_open_array(&j, "undamped");
  for (i = 0; i < f->nundamped; ++i) {
    json_open_object(&j, NULL);
    json_number(&j, "frequency", frequency(&f->undamped[i]));
    json_string(&j, "coordinate", most(s, coordinate, &f->undamped[i]));
    json_close_object(&j);
  }
  json_close_array(&j);
  json_close_object(&j);
}

/* room has a_q, a_v and mass */
static int find_and_print(const standstill *s, double *room, int *coordinate, findings *f)
{
  int n = s->state.coordinates;
  double *a_q = room, *a_v = a_q + n * n, *mass = a_v + n * n;

  if (maggi_equilibrium_motions(s->data, small_rate, coordinate, a_q, a_v, mass, NULL) != MAGGI_OK)
    return message_fail(STATUS_FAILED, "%s: %s", s->spec, maggi_data_message(s->data));
  f->n = modes_find(n, a_q, a_v, mass, f->modes);
  memset(a_v, 0, (size_t)n * (size_t)n * sizeof *a_v);
  f->nundamped = f->n < 0 ? f->n : modes_find(n, a_q, a_v, mass, f->undamped);
  if (f->nundamped == -2)
    return message_fail(STATUS_FAILED, "modes: this build has none, it was made without GSL");
  if (f->nundamped < 0) return message_fail(STATUS_FAILED, "%s: no eigenvalues", s->spec);
  (s->json ? print_json : print_text)(s, coordinate, f);
  return STATUS_DONE;
}

static int show(const standstill *s)
{
  size_t n = (size_t)s->state.coordinates;
  double *room = calloc(3 * n * n + 1, sizeof *room);
  int *coordinate = calloc(n + 1, sizeof *coordinate);
  mode *modes = calloc(4 * n + 2, sizeof *modes);
  findings f = {.modes = modes, .undamped = modes ? modes + 2 * n + 1 : NULL};
  int status;

  if (room && coordinate && modes)
    status = find_and_print(s, room, coordinate, &f);
  else
    status = message_fail(STATUS_FAILED, "%s: out of memory", s->spec);
  free(room);
  free(coordinate);
  free(modes);
  return status;
}

int command_modes(int argc, char **argv)
{
  return standstill_run(argc, argv, show);
}
