/* Creased surfaces before the renderer.
 *
 * A skin is a material as it is on some surfaces: creased by some tilt, or flat. Spectra are made
 * skin by skin, as geometry and spectra factor within one. A creased surface has the lobe of its
 * record widened by the tilt, alpha^2 + 2 s^2 (docs/physics/creases.md), wherever many patches
 * count together: to the Earth's light, for what masking keeps back, in inter-reflection. Toward
 * the Sun it has its patches one by one, so that glints come and go with them; where more than
 * UM_OPTICS_PATCHES_MANY of a facet's patches mirror at once, which is 1 % of Poisson's
 * fluctuation, the widened lobe stands for them there too. What is absorbed and emitted is that of
 * the flat surface. */
#ifndef UMBRA_OPTICS_CREASES_H
#define UMBRA_OPTICS_CREASES_H

#include "geometry/creases.h"
#include "materials/materials.h"

#define UM_OPTICS_PATCHES_MANY 1e4

struct um_optics_creases {
  size_t nskin;
  uint32_t *skin;                      /* [nsurface] */
  uint32_t *material;                  /* [nskin], a skin below the number of materials is flat */
  double *slope_variance;              /* [nskin] s^2 per axis [1]; 0: flat */
  struct um_geometry_creases *patches; /* never NULL */
};

/* creasing: by group of the geometry [ngroup]; material: [nmaterial], its order. Surfaces without a
 * lobe stay flat. *out is NULL where no surface is creased. UM_ERR_INPUT: too many patches (part
 * named); UM_ERR_MEMORY. The caller destroys. */
enum um_status um_optics_creases_create(struct um_context *context,
                                        const struct um_geometry *geometry,
                                        const struct um_geometry_creasing *creasing,
                                        const struct um_materials_record *const *material,
                                        struct um_optics_creases **out);
void um_optics_creases_destroy(struct um_context *context, struct um_optics_creases **creases);

#endif
