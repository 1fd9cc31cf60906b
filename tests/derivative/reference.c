#include "heads.h"

void reference_head(int head, const maggi_topo *t, reference_number *x[])
{
  maggi_heads[head].f(t, x);
}

void reference_adjoint(int head, const maggi_topo *t, reference_number *x[], reference_number *xb[])
{
  maggi_heads[head].b(t, x, xb);
}
