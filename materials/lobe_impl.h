/* Private: quadrature over the facets of a Beckmann lobe. */
#ifndef UMBRA_MATERIALS_LOBE_IMPL_H
#define UMBRA_MATERIALS_LOBE_IMPL_H

/* One sample: o.h [1] and its share [1] of the directional albedo for F = 1. */
typedef void (*um_materials_lobe_sink)(void *self, double cos_oh, double weight);

/* Directional albedo of the lobe for F = 1 at cos_o > 0, sample by sample; sink may be NULL. */
double um_materials_lobe_sample(double alpha, double cos_o, int nr, int nphi,
                                um_materials_lobe_sink sink, void *self);

#endif
