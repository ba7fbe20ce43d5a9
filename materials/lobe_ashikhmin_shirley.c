/* Ashikhmin and Shirley's anisotropic lobe, its specular part.
 *
 *   f = p(h) / (4 cos_d max(cos_i, cos_o))
 *   p(h) = sqrt((nx + 1)(ny + 1))/(2 pi) cos_h^(nx cos^2 phi + ny sin^2 phi)
 * (Ashikhmin & Shirley 2000, eqs 4 and 6 to 8). p is a density of half vectors, so what is thrown
 * by it has the weight min(1, cos_i/cos_o): nothing is gained at any angle. Near the normal cos_h^n
 * = exp(-n tan^2 theta_h/2), Beckmann's distribution of alpha^2 = 2/n: n = 2/alpha^2, and the Sun's
 * disc adds theta_s^2/8 to alpha^2 as it does there. */
#include <math.h>

#include "base/core/constants.h"
#include "materials/lobe_impl.h"

static double exponent(double alpha) { return 2.0 / (alpha * alpha); }

static double half_density(const struct um_materials_lobe *lobe,
                           const struct um_materials_pair *pair)
{
  double nx = exponent(lobe->alpha), ny = exponent(lobe->alpha_across), c = pair->cos_h;
  if (!(c > 0.0)) return 0.0;
  double sin2 = fmax(0.0, (1.0 - c) * (1.0 + c)), x2 = fmin(pair->along_h * pair->along_h, sin2);
  if (!um_materials_lobe_is_anisotropic(lobe)) x2 = sin2;
  /* log(cos_h)/sin_h^2, -1/2 at the normal */
  double slope = sin2 > 0.0 ? 0.5 * log1p(-sin2) / sin2 : -0.5;
  return sqrt((nx + 1.0) * (ny + 1.0)) / (2.0 * UM_PI) * exp((nx * x2 + ny * (sin2 - x2)) * slope);
}

static double evaluate(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair)
{
  if (!(pair->cos_i > 0.0 && pair->cos_o > 0.0 && pair->cos_d > 0.0)) return 0.0;
  return half_density(lobe, pair) / (4.0 * pair->cos_d * fmax(pair->cos_i, pair->cos_o));
}

static double sunlit(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair,
                     double sun_radius)
{
  struct um_materials_lobe wide = um_materials_lobe_widened(lobe, sun_radius);
  return evaluate(&wide, pair);
}

/* tan phi = sqrt((nx + 1)/(ny + 1)) tan(2 pi v), in the same quadrant (their eqs 9 and 10). */
static struct um_vec3 draw(const struct um_materials_lobe *lobe, double u, double v)
{
  double nx = exponent(lobe->alpha), ny = exponent(lobe->alpha_across), angle = 2.0 * UM_PI * v;
  double x = sqrt(ny + 1.0) * cos(angle), y = sqrt(nx + 1.0) * sin(angle), r2 = x * x + y * y;
  double n = (nx * x * x + ny * y * y) / r2;
  double c2 = exp(2.0 / (n + 1.0) * log1p(-u)), s = sqrt(fmax(0.0, 1.0 - c2) / r2);
  return um_vec3(s * x, s * y, sqrt(c2));
}

static struct um_materials_reflected reflect_one(const struct um_materials_lobe *lobe,
                                                 struct um_vec3 drawn, struct um_vec3 o)
{
  (void)lobe;
  struct um_materials_reflected t = {.cos_d = um_vec3_dot(o, drawn)};
  t.i = um_vec3_axpy(um_vec3_scale(o, -1.0), 2.0 * t.cos_d, drawn);
  if (t.cos_d > 0.0 && t.i.z > 0.0) t.weight = fmin(1.0, t.i.z / o.z);
  return t;
}

UM_MATERIALS_REFLECT_EACH(reflect_one)

static double density(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair)
{
  return pair->cos_d > 0.0 ? half_density(lobe, pair) / (4.0 * pair->cos_d) : 0.0;
}

const struct um_materials_lobe_kind um_materials_lobe_ashikhmin_shirley = {
    .name = "ashikhmin_shirley",
    .summary = "a power of the facet's cosine, with two exponents",
    .reference = "Ashikhmin & Shirley 2000, Journal of Graphics Tools 5(2)",
    .rough = true,
    .anisotropic = true,
    .exponent = 2.0,
    .evaluate = evaluate,
    .sunlit = sunlit,
    .draw = draw,
    .reflect = reflect,
    .density = density,
};
