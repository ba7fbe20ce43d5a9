/* A lobe on a surface that is creased (docs/physics/creases.md): facets tilted further at random,
 * and the light of patches that each have a tilt of their own (lobe.h has the equation).
 *
 * Normal slopes of patches, variance s^2 per axis, and of facets, alpha^2/2, add up to those of
 * alpha_eff^2 = alpha^2 + 2 s^2 in the mean over patches, without approximation: what is drawn here
 * is the sum of two height fields. */
#include <math.h>

#include "materials/lobe_impl.h"

#define FAR 40.0 /* r^2 beyond which normal slopes are none: 4e-18 */

struct um_materials_lobe um_materials_lobe_tilted(const struct um_materials_lobe *lobe,
                                                  double slope_variance)
{
  struct um_materials_lobe out = *lobe;
  if (!(slope_variance > 0.0) || lobe->kind == NULL) return out;
  if (lobe->kind->delta) {
    out = (struct um_materials_lobe){.kind = &um_materials_lobe_beckmann,
                                     .compensated = lobe->compensated};
  } else if (!lobe->kind->rough) {
    return out;
  }
  if (lobe->kind->mixed) {
    out.tilted += 2.0 * slope_variance;
    return out;
  }
  out.alpha = sqrt(out.alpha * out.alpha + 2.0 * slope_variance);
  out.alpha_across = sqrt(out.alpha_across * out.alpha_across + 2.0 * slope_variance);
  return out;
}

/* Density of slopes [1] of a patch's own lobe, mean over the patches, at the slopes x, y. */
static double realised(double (*slopes)(double), const struct um_materials_lobe *own, double x,
                       double y, const struct um_materials_patches *patches)
{
  double ax = 1.0 / own->alpha, ay = 1.0 / own->alpha_across, sum = 0.0;
  bool normal = slopes == um_materials_lobe_beckmann.slopes;
  for (size_t k = 0; k < patches->n; k++) {
    double dx = (x - (double)patches->along[k]) * ax, dy = (y - (double)patches->across[k]) * ay;
    double r2 = dx * dx + dy * dy;
    if (normal && r2 > FAR) continue;
    sum += (double)patches->share[k] * slopes(r2);
  }
  return sum * ax * ay;
}

double um_materials_lobe_patches(const struct um_materials_lobe *lobe,
                                 const struct um_materials_lobe *tilted,
                                 const struct um_materials_pair *pair, double across_h,
                                 double sun_radius, const struct um_materials_patches *patches)
{
  double (*slopes)(double) = tilted->kind->slopes;
  if (slopes == NULL || patches->n == 0) return tilted->kind->sunlit(tilted, pair, sun_radius);
  if (!(pair->cos_h > 0.0)) return 0.0;
  struct um_materials_lobe own = *lobe, wide = um_materials_lobe_widened(tilted, sun_radius);
  if (own.kind->delta) own.alpha = own.alpha_across = 0.0;
  own = um_materials_lobe_widened(&own, sun_radius);
  double x = pair->along_h / pair->cos_h, y = across_h / pair->cos_h;
  double u = x / wide.alpha, v = y / wide.alpha_across;
  double expected = slopes(u * u + v * v) / (wide.alpha * wide.alpha_across);
  if (!(expected > 1e-280)) return 0.0; /* 25 standard deviations away */
  return wide.kind->evaluate(&wide, pair) * (realised(slopes, &own, x, y, patches) / expected);
}
