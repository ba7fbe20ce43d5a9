/* CVODES' vectors with loops of our own. Private to thermal/solver/. */
#ifndef UMBRA_THERMAL_VECTOR_IMPL_H
#define UMBRA_THERMAL_VECTOR_IMPL_H

#include <sundials/sundials_nvector.h>

/* A serial vector of n zeros, NULL where memory runs out; its clones work like it. Sums and
 * products give the bits of SUNDIALS' own, norms are summed in four strands. */
N_Vector um_thermal_vector_create(size_t n, SUNContext sun);

#endif
