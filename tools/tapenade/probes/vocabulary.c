/* + - * / and the elementary functions */
#include "probe.h"

void probe(const topo *t, const double x[t->n], double y[t->n])
{
  y[0] = sin(x[0]) + cos(x[1]) - tan(0.3 * x[2]) * asin(0.3 * x[3]) / acos(0.3 * x[0]);
  y[1] = atan(x[0]) + atan2(x[1], 2.0 + x[2]) + sinh(x[3]) * cosh(x[0]) - tanh(x[1]);
  y[2] = exp(x[0]) + log(2.0 + x[1]) + sqrt(2.0 + x[2]) + pow(2.0 + x[3], 1.5) * fabs(x[0]);
  y[3] = pow(2.0 + x[0], x[1]);
}
