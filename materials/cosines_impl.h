/* Private: the angular grid of tables. */
#ifndef UMBRA_MATERIALS_COSINES_IMPL_H
#define UMBRA_MATERIALS_COSINES_IMPL_H

#include <stddef.h>

#define UM_MATERIALS_COSINES 49 /* nodes, cos = u^2, u uniform in 0..1 */

/* Nodes of the angular grid, and 2 int x cos dcos of values at them; ncos 1: constant. */
double um_materials_node_cosine(size_t j);
double um_materials_hemispherical_mean(const double *x, size_t ncos);
/* A row of values at them, by cubics at u = sqrt(cos), 0..1. */
double um_materials_along_cosines(const double row[UM_MATERIALS_COSINES], double u);

#endif
