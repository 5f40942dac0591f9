/* Our generated C under the names of CasADi's wrapper (benches/peers/casadi_c.py), so that one program measures both. */
#include "body.h"

void ffrf_accelerations(const real *q, const real *r, const real *w, const real *f, real *a)
{
    body_forward_dynamics(q, w, r, f, a);
}

void ffrf_equations(const real *q, const real *r, const real *w, const real *f, real *m, real *g, real *a)
{
    body_equations_of_motion(q, w, r, f, m, g, a);
}
