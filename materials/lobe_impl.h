/* Private: the list of lobes, and the quadrature of Beckmann's. */
#ifndef UMBRA_MATERIALS_LOBE_IMPL_H
#define UMBRA_MATERIALS_LOBE_IMPL_H

#include <math.h>

#include "materials/lobe.h"

#define UM_LOBE(name) extern const struct um_materials_lobe_kind um_materials_lobe_##name;
#include "materials/lobes.def"
#undef UM_LOBE

/* The member `reflect` of a kind whose samples for o have nothing in common, by
 * reflect_one(lobe, drawn, o). */
#define UM_MATERIALS_REFLECT_EACH(reflect_one)                                                     \
  static void reflect(const struct um_materials_lobe *lobe, const struct um_vec3 *drawn, size_t n, \
                      struct um_vec3 o, double toward, struct um_materials_reflected *out)         \
  {                                                                                                \
    (void)toward;                                                                                  \
    for (size_t k = 0; k < n; k++) out[k] = reflect_one(lobe, drawn[k], o);                        \
  }

/* Beckmann with separable masking and one roughness: its directional albedo stands in a table. */
static inline bool um_materials_lobe_is_tabulated(const struct um_materials_lobe *lobe)
{
  return lobe->kind == &um_materials_lobe_beckmann && !lobe->correlated &&
         !um_materials_lobe_is_anisotropic(lobe);
}

/* A lobe of normal slopes, or one like it, that the disc of the Sun widens: alpha^2 + theta_s^2/8
 * (docs/physics/roughness-and-lobes.md). */
static inline struct um_materials_lobe
um_materials_lobe_widened(const struct um_materials_lobe *lobe, double sun_radius)
{
  struct um_materials_lobe wide = *lobe;
  double sun2 = sun_radius * sun_radius / 8.0;
  wide.alpha = sqrt(lobe->alpha * lobe->alpha + sun2);
  wide.alpha_across = sqrt(lobe->alpha_across * lobe->alpha_across + sun2);
  return wide;
}

/* Directional albedo of a tabulated Beckmann lobe for F = 1 at cos_o > 0, sample by sample; sink
 * may be NULL; better for its number of points than um_materials_lobe_quadrature. */
double um_materials_beckmann_quadrature(const struct um_materials_lobe *lobe, double cos_o, int nr,
                                        int nphi, um_materials_lobe_sink sink, void *self);

#endif
