/* GGX facets (Trowbridge-Reitz): slopes with a long tail, as ground and blasted surfaces have.
 *
 *   D(h) = alpha^2 / (pi cos^4 theta_h (alpha^2 + tan^2 theta_h)^2)
 *   Lambda = (sqrt(1 + 1/a^2) - 1)/2,  a = 1/(alpha tan theta)
 * (Trowbridge & Reitz 1975; Walter et al. 2007, eqs 33-34; Heitz 2014). The cumulative distribution
 * of r = tan theta_h/alpha is r^2/(1 + r^2).
 *
 * The Sun's disc spreads half vectors over a disc of radius R = theta_s/2 in slopes. P is a uniform
 * sphere in stereographic projection, in which a disc is a cap; so its mean over a disc about t is
 *   2 alpha^2 / (pi S (S + T)),  T = alpha^2 + t^2 - R^2,  S = sqrt((T + 2 R^2)^2 - 4 t^2 R^2),
 * exact, for alpha = 0 too, where it is 1/(pi R^2) inside the disc and 0 outside. With two
 * roughnesses alpha^2 + R^2 takes the place of either, which keeps the peak of this. */
#include <math.h>

#include "base/core/constants.h"
#include "materials/microfacet_impl.h"

static double um_materials_facet_slopes(double r2)
{
  return 1.0 / (UM_PI * (1.0 + r2) * (1.0 + r2));
}

static double um_materials_facet_smith(double c2, double s2)
{
  if (!(c2 > 0.0)) return INFINITY;
  double x = s2 / c2;
  return 0.5 * x / (sqrt(1.0 + x) + 1.0);
}

static double um_materials_facet_smith_coarse(double c2, double s2)
{
  return um_materials_facet_smith(c2, s2);
}

static double evaluate(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair)
{
  return um_materials_facet_lobe(lobe, um_materials_facet_distribution(lobe, pair), pair);
}

/* Mean of P over the Sun's disc, back as D. */
static double widened(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair,
                      double sun_radius)
{
  double c2 = pair->cos_h * pair->cos_h, a2 = lobe->alpha * lobe->alpha,
         disc2 = 0.25 * sun_radius * sun_radius;
  if (!(pair->cos_h > 0.0)) return 0.0;
  if (um_materials_lobe_is_anisotropic(lobe)) {
    struct um_materials_lobe wide = *lobe;
    wide.alpha = sqrt(a2 + disc2);
    wide.alpha_across = sqrt(lobe->alpha_across * lobe->alpha_across + disc2);
    return um_materials_facet_distribution(&wide, pair);
  }
  double t2 = fmax(0.0, (1.0 - pair->cos_h) * (1.0 + pair->cos_h)) / c2, t = a2 + t2 - disc2;
  double s = sqrt(fmax(0.0, (t + 2.0 * disc2) * (t + 2.0 * disc2) - 4.0 * t2 * disc2));
  double mean = t > 0.0 ? 2.0 * a2 / (s * (s + t)) : 0.5 * (1.0 - t / s) / disc2;
  return mean / (UM_PI * c2 * c2);
}

static double sunlit(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair,
                     double sun_radius)
{
  return um_materials_facet_lobe(lobe, widened(lobe, pair, sun_radius), pair);
}

static struct um_vec3 draw(const struct um_materials_lobe *lobe, double u, double v)
{
  return um_materials_facet_normal(lobe, sqrt(u / (1.0 - u)), v);
}

const struct um_materials_lobe_kind um_materials_lobe_ggx = {
    .name = "ggx",
    .summary = "facets with a long tail of steep slopes (Trowbridge-Reitz)",
    .reference = "Trowbridge & Reitz 1975; Walter et al. 2007, EGSR; Heitz 2014, JCGT 3(2)",
    .evaluate = evaluate,
    .sunlit = sunlit,
    .draw = draw,
    UM_MATERIALS_FACETS,
};
