#include "term_kind.h"

int maggi_term_power(maggi_objective_type type)
{
  switch (type) {
  case MAGGI_OBJECTIVE_INTEGRAL:
  case MAGGI_OBJECTIVE_MEAN:
    return 1;
  case MAGGI_OBJECTIVE_INTEGRAL_SQUARE:
  case MAGGI_OBJECTIVE_MEAN_SQUARE:
  case MAGGI_OBJECTIVE_RMS:
  case MAGGI_OBJECTIVE_NORM:
  case MAGGI_OBJECTIVE_VIOLATION:
    return 2;
  case MAGGI_OBJECTIVE_RMQ:
  case MAGGI_OBJECTIVE_VDV:
    return 4;
  default:
    return 0;
  }
}

int maggi_term_is_mean(maggi_objective_type type)
{
  return type == MAGGI_OBJECTIVE_MEAN || type == MAGGI_OBJECTIVE_MEAN_SQUARE ||
         type == MAGGI_OBJECTIVE_RMS || type == MAGGI_OBJECTIVE_RMQ ||
         type == MAGGI_OBJECTIVE_SMOOTH_MAXIMUM;
}

int maggi_term_is_root(maggi_objective_type type)
{
  return type == MAGGI_OBJECTIVE_RMS || type == MAGGI_OBJECTIVE_NORM ||
         type == MAGGI_OBJECTIVE_RMQ || type == MAGGI_OBJECTIVE_VDV;
}

int maggi_term_is_extremum(maggi_objective_type type)
{
  return type == MAGGI_OBJECTIVE_MAXIMUM || type == MAGGI_OBJECTIVE_MINIMUM ||
         type == MAGGI_OBJECTIVE_PEAK;
}

int maggi_term_has_times(maggi_objective_type type)
{
  return type == MAGGI_OBJECTIVE_VALUE || type == MAGGI_OBJECTIVE_LEAST_SQUARES;
}
