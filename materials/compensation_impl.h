/* Private: compensation for multiple scattering, the light that facets of a rough surface pass on
 * to each other. */
#ifndef UMBRA_MATERIALS_COMPENSATION_IMPL_H
#define UMBRA_MATERIALS_COMPENSATION_IMPL_H

#include "materials/facet_table_impl.h"
#include "materials/lobe.h"

/* [separable, height-correlated] */
extern const double um_materials_compensation_beckmann[2][UM_MATERIALS_FACET_ROUGHNESSES]
                                                      [UM_MATERIALS_FACET_PLACES];
extern const double um_materials_compensation_ggx[2][UM_MATERIALS_FACET_ROUGHNESSES]
                                                 [UM_MATERIALS_FACET_PLACES];

/* How much of what is lost comes back by s [1]: all of it where the lobe is alike all round. */
double um_materials_compensation_share(const struct um_materials_lobe *lobe);
/* s toward a direction of a lobe of facets, Beckmann's or GGX; 1 where the lobe is of single
 * scattering. along: component of the direction along the grain, read where the lobe has one. */
double um_materials_compensation(const struct um_materials_lobe *lobe, double cosine, double along);

#endif
