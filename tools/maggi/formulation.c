/* Which equations are integrated, and how. */
#include "formulation.h"

#include <string.h>

#include "message.h"
#include "nearest.h"
#include "options.h"

void formulation_init(formulation *f)
{
  memset(f, 0, sizeof *f);
  maggi_penalty_options_init(&f->options);
}

int formulation_name(formulation *f, const char *text)
{
  static const char *const word[] = {"maggi", "penalty"};
  nearest n;
  int i;

  nearest_init(&n, text);
  for (i = 0; i < 2; ++i) {
    nearest_offer(&n, word[i]);
    f->is_penalty = i;
    if (strcmp(text, word[i]) == 0) return 0;
  }
  message_fail(STATUS_USAGE, "--formulation: no formulation \"%s\"%s", text, nearest_hint(&n));
  return -1;
}

int formulation_penalty(formulation *f, const char *text)
{
  f->only = "--penalty";
  return options_positive("--penalty", text, &f->options.penalty);
}

int formulation_jacobian(formulation *f, const char *text)
{
  nearest n;
  int i, found = maggi_jacobian_find(text);

  f->only = "--jacobian";
  if (found >= 0) {
    f->options.jacobian = (maggi_jacobian)found;
    return 0;
  }
  nearest_init(&n, text);
  for (i = 0; i < MAGGI_JACOBIAN_COUNT; ++i)
    nearest_offer(&n, maggi_jacobian_name((maggi_jacobian)i));
  message_fail(STATUS_USAGE, "--jacobian: no way \"%s\"%s", text, nearest_hint(&n));
  return -1;
}

int formulation_check(formulation *f, double tolerance)
{
  if (f->only && !f->is_penalty)
    return message_fail(STATUS_USAGE, "%s: only with --formulation penalty", f->only);
  if (tolerance > 0.0) f->options.tolerance = tolerance;
  return STATUS_DONE;
}

int formulation_tolerance(const formulation *f, maggi_data *d, double tolerance)
{
  if (!f->is_penalty && tolerance > 0.0 && maggi_data_set_tolerance(d, tolerance) != MAGGI_OK)
    return message_fail(STATUS_USAGE, "--tolerance: %.6g is refused", tolerance);
  return STATUS_DONE;
}

maggi_status formulation_create(const formulation *f, maggi_data *d, maggi_penalty **penalty)
{
  *penalty = NULL;
  return f->is_penalty ? maggi_penalty_create(d, &f->options, penalty) : MAGGI_OK;
}

maggi_status formulation_reset(maggi_data *d, maggi_penalty *penalty)
{
  return penalty ? maggi_penalty_reset(penalty) : maggi_data_reset(d);
}

maggi_status formulation_step(maggi_data *d, maggi_penalty *penalty, double h)
{
  return penalty ? maggi_penalty_step(penalty, h) : maggi_step(d, h);
}
