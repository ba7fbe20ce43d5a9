/* Beckmann facets with Smith masking: slopes are normally distributed.
 *
 *   D(h)  = exp(-tan^2 theta_h / alpha^2) / (pi alpha^2 cos^4 theta_h),  int D cos dw = 1
 *   G1(v) = 1/(1 + Lambda),  Lambda = (erf(a) - 1)/2 + exp(-a^2)/(2 a sqrt(pi)),
 *           a = 1/(alpha tan theta)
 *   lobe  = D(h) G1(i) G1(o) / (4 cos_i cos_o)
 * (Beckmann & Spizzichino 1963; Walter et al. 2007, eqs 20, 25 and appendix; Heitz 2014). With two
 * roughnesses or height-correlated masking as microfacet_impl.h has it. The Sun's disc spreads half
 * vectors over a disc of radius theta_s/2, whose variance per axis theta_s^2/16 is that of a
 * Beckmann distribution of alpha^2 = theta_s^2/8: sunlit is the lobe of the wider alpha.
 * alpha = sqrt(2) Rq / tau reproduces Table 1 of the Flying Laptop paper (tests/materials/bsdf). */
#include <assert.h>
#include <math.h>
#include <stddef.h>

#include "base/core/constants.h"
#include "materials/bsdf.h"
#include "materials/microfacet_impl.h"

double um_materials_beckmann_distribution(double alpha, double cos_h)
{
  assert(alpha > 0.0);
  if (!(cos_h > 0.0)) return 0.0;
  double c2 = cos_h * cos_h, a2 = alpha * alpha;
  return exp((c2 - 1.0) / (c2 * a2)) / (UM_PI * a2 * c2 * c2);
}

/* Smith's Lambda. */
static double lambda_at(double a) { return -0.5 * erfc(a) + exp(-a * a) / (2.0 * a * sqrt(UM_PI)); }

double um_materials_beckmann_masking(double alpha, double cos_theta)
{
  assert(alpha > 0.0);
  if (!(cos_theta > 0.0)) return 0.0;
  if (cos_theta >= 1.0) return 1.0;
  double a = cos_theta / (alpha * sqrt((1.0 - cos_theta) * (1.0 + cos_theta)));
  if (a > 6.0) return 1.0; /* Lambda < 1e-17 */
  return 1.0 / (1.0 + lambda_at(a));
}

double um_materials_beckmann_lobe(double alpha, double cos_h, double cos_i, double cos_o)
{
  if (!(cos_h > 0.0 && cos_i > 0.0 && cos_o > 0.0)) return 0.0;
  double g =
      um_materials_beckmann_masking(alpha, cos_i) * um_materials_beckmann_masking(alpha, cos_o);
  return um_materials_beckmann_distribution(alpha, cos_h) * g / (4.0 * cos_i * cos_o);
}

double um_materials_roughness_alpha(double rq, double tau) { return sqrt(2.0) * rq / tau; }

/* --- the kind -------------------------------------------------------------------------------- */

static double um_materials_facet_slopes(double r2) { return exp(-r2) / UM_PI; }

static double um_materials_facet_smith(double c2, double s2)
{
  if (c2 > 36.0 * s2) return 0.0; /* Lambda < 1e-17 */
  return c2 > 0.0 ? lambda_at(sqrt(c2 / s2)) : INFINITY;
}

/* For sums over many facets: nothing below 1e-9. */
static double um_materials_facet_smith_coarse(double c2, double s2)
{
  return c2 > 16.0 * s2 ? 0.0 : um_materials_facet_smith(c2, s2);
}

static double evaluate(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair)
{
  if (um_materials_lobe_is_tabulated(lobe))
    return um_materials_compensation(lobe, pair->cos_i, 0.0) *
           um_materials_compensation(lobe, pair->cos_o, 0.0) *
           um_materials_beckmann_lobe(lobe->alpha, pair->cos_h, pair->cos_i, pair->cos_o);
  return um_materials_facet_lobe(lobe, um_materials_facet_distribution(lobe, pair), pair);
}

static double sunlit(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair,
                     double sun_radius)
{
  struct um_materials_lobe wide = um_materials_lobe_widened(lobe, sun_radius);
  return evaluate(&wide, pair);
}

static struct um_vec3 draw(const struct um_materials_lobe *lobe, double u, double v)
{
  return um_materials_facet_normal(lobe, sqrt(-log1p(-u)), v);
}

const struct um_materials_lobe_kind um_materials_lobe_beckmann = {
    .name = "beckmann",
    .summary = "facets of normally distributed slopes (Cook-Torrance)",
    .reference = "Beckmann & Spizzichino 1963; Cook & Torrance 1982; Walter et al. 2007",
    .evaluate = evaluate,
    .sunlit = sunlit,
    .draw = draw,
    UM_MATERIALS_FACETS,
};

/* With tan theta_h = alpha r the facets' measure D cos_h dw_h is 2 r exp(-r^2) dr dphi/(2 pi), and
 * f cos_i dw_i = G1(i) G1(o) (o.h) / (cos_o cos_h) of it (Walter et al. 2007, eq. 14), times s(i)
 * s(o). Midpoints in r and phi; the sample is handed on with its o.h. Returns the sum of the
 * weights. */
double um_materials_beckmann_quadrature(const struct um_materials_lobe *lobe, double cos_o, int nr,
                                        int nphi, um_materials_lobe_sink sink, void *self)
{
  const double r_end = 5.5; /* exp(-30) of the facets lie beyond */
  double alpha = lobe->alpha, sin_o = sqrt((1.0 - cos_o) * (1.0 + cos_o));
  double g_o =
      um_materials_compensation(lobe, cos_o, 0.0) * um_materials_beckmann_masking(alpha, cos_o);
  double dr = r_end / nr, sum = 0.0;
  for (int j = 0; j < nr; j++) {
    double r = (j + 0.5) * dr, tan_h = alpha * r;
    double cos_h = 1.0 / sqrt(1.0 + tan_h * tan_h), sin_h = tan_h * cos_h;
    double facets = 2.0 * r * exp(-r * r) * dr / nphi;
    for (int p = 0; p < nphi; p++) {
      double phi = UM_PI * (p + 0.5) / nphi; /* the other half is its mirror image */
      double oh = cos_o * cos_h + sin_o * sin_h * cos(phi);
      double cos_i = 2.0 * oh * cos_h - cos_o;
      if (!(oh > 0.0 && cos_i > 0.0)) continue;
      double g = g_o * um_materials_compensation(lobe, cos_i, 0.0) *
                 um_materials_beckmann_masking(alpha, cos_i);
      double weight = facets * g * oh / (cos_o * cos_h);
      sum += weight;
      if (sink != NULL) sink(self, oh, weight);
    }
  }
  /* Euler-Maclaurin term of the midpoint rule at r = 0, where the slope of the integrand is 2 g(0):
   * there h = n, o.h = cos_o, G = G1(o)^2 */
  double correction = -dr * dr / 12.0 * g_o * g_o;
  if (sink != NULL) sink(self, cos_o, correction);
  return sum + correction;
}

double um_materials_beckmann_albedo(double alpha, double cos_i)
{
  double c = cos_i > 1.0 ? 1.0 : cos_i;
  if (!(c > 0.0)) return 0.0;
  const struct um_materials_lobe lobe = {
      .kind = &um_materials_lobe_beckmann, .alpha = alpha, .alpha_across = alpha};
  return fmin(1.0, um_materials_beckmann_quadrature(&lobe, c, 128, 128, NULL, NULL));
}
