/* Multiple-scattering compensation: light that facets of a rough surface pass on to each other.
 *
 * A facet reflects F of what it gets. Where another facet stands in the way the light goes on from
 * there, and single scattering, f = D G/(4 cos_i cos_o), loses it: E(o) = int f cos_i dw_i < 1 for
 * F =
 * 1. At grazing angles, where the most is lost, it is passed on along much the same azimuth (a walk
 * over Smith's microsurface, Heitz et al. 2016: within 5 deg of the mirrored one at alpha 0.03,
 * within 15 deg at 0.3), so that it is given back where the lobe is, by a factor that keeps f
 * reciprocal,
 *
 *   f' = s(i) s(o) f,   s(o) int f s(i) cos_i dw_i = 1  for every o:
 *
 * what is reflected for F = 1 is all that arrives. Sinkhorn's scaling (1967) finds s, s = 1.06 at
 * most for Beckmann's at small alpha, where E >= 0.91. Two roughnesses: s of the roughness toward
 * each direction, as Smith's Lambda has it (microfacet_impl.h), reflects too much by about c
 * ln^2(alpha / alpha_across), c 0.055 alpha^3 for Beckmann's, 0.09 alpha^1.5 for GGX; so as much of
 * s is taken as leaves ALLOWED of that, and what is then lost goes the other way (spectrum.c).
 * Turquin (2019) scales by 1/E(o), which is not reciprocal. For rough surfaces, alpha above 0.5,
 * light that is passed on spreads wider than the lobe. Test: materials/conformance. */
#include "materials/compensation_impl.h"

#include "materials/lobe_impl.h"

#define ALLOWED 2e-4 /* reflected above what arrives */

static double roughness(const struct um_materials_lobe *lobe, double sin2, double along)
{
  double ax = lobe->alpha, ay = lobe->alpha_across;
  if (ax == ay || !(sin2 > 0.0)) return ax;
  double x2 = fmin(along * along, sin2) / sin2;
  return sqrt(ax * ax * x2 + ay * ay * (1.0 - x2));
}

double um_materials_compensation_share(const struct um_materials_lobe *lobe)
{
  if (!lobe->compensated || !lobe->kind->masked) return 0.0;
  if (!um_materials_lobe_is_anisotropic(lobe)) return 1.0;
  double alpha = fmax(lobe->alpha, lobe->alpha_across),
         turn = log(lobe->alpha / lobe->alpha_across);
  bool beckmann = lobe->kind == &um_materials_lobe_beckmann;
  double excess =
      (beckmann ? 0.055 * alpha * alpha * alpha : 0.09 * alpha * sqrt(alpha)) * turn * turn;
  return ALLOWED / (ALLOWED + excess);
}

bool um_materials_lobe_is_whole(const struct um_materials_lobe *lobe)
{
  if (lobe->kind == NULL || !lobe->compensated) return false;
  if (!lobe->kind->mixed) return um_materials_compensation_share(lobe) >= 1.0;
  return lobe->mixture->of[0].kind->masked && lobe->mixture->of[1].kind->masked;
}

double um_materials_compensation(const struct um_materials_lobe *lobe, double cosine, double along)
{
  double share = um_materials_compensation_share(lobe);
  if (!(share > 0.0 && cosine > 0.0)) return 1.0;
  bool beckmann = lobe->kind == &um_materials_lobe_beckmann;
  double c = fmin(cosine, 1.0), sin2 = (1.0 - c) * (1.0 + c);
  double alpha = roughness(lobe, sin2, along), width = alpha * sqrt(sin2);
  if (beckmann && alpha < 0.1 && c > 9.0 * width) return 1.0; /* |s - 1| < 1e-6 */
  double s =
      um_materials_facet_at((beckmann ? um_materials_compensation_beckmann
                                      : um_materials_compensation_ggx)[lobe->correlated ? 1 : 0],
                            alpha, c / (c + width));
  return 1.0 + share * (s - 1.0);
}
