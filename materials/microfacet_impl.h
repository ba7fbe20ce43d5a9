/* Private: lobes of facets, what the distributions share (Walter et al. 2007; Heitz 2014).
 *
 *   f = D(h) G(i, o) / (4 cos_i cos_o),  int D cos_h dw_h = 1
 * With two roughnesses slopes are stretched: Smith's Lambda toward a direction is that of the
 * isotropic surface of roughness sqrt(alpha^2 cos^2 phi + alpha_across^2 sin^2 phi) (Heitz 2014,
 * sec. 5.4). Masking of the two directions is taken apart, G1(i) G1(o), or by the common height of
 * the facet, 1/(1 + Lambda_i + Lambda_o) (his eqs 98 and 99).
 * With h drawn from D cos_h, f cos_i dw_i = G (o.h)/(cos_o cos_h) of the facets' measure, as
 * dw_i = 4 (o.h) dw_h (Walter et al. 2007, eq. 14). */
#ifndef UMBRA_MATERIALS_MICROFACET_IMPL_H
#define UMBRA_MATERIALS_MICROFACET_IMPL_H

#include <math.h>

#include "base/core/constants.h"
#include "materials/compensation_impl.h"
#include "materials/lobe_impl.h"

/* A file that includes this defines these three, and has what follows of its facets. */

/* D(h) cos_h^4 alpha alpha_across [1/sr] by r^2 = x^2/alpha^2 + y^2/alpha_across^2 of the slopes x,
 * y along and across the grain. */
static double um_materials_facet_slopes(double r2);
/* Smith's Lambda by a = cot theta/alpha toward a direction, a^2 = c2/s2; coarse: for sums over many
 * facets. */
typedef double (*um_materials_smith)(double c2, double s2);
static double um_materials_facet_smith(double c2, double s2);
static double um_materials_facet_smith_coarse(double c2, double s2);

/* r^2 of the half vector. */
static inline double um_materials_facet_slope2(const struct um_materials_lobe *lobe, double cos_h,
                                               double along_h)
{
  double c2 = cos_h * cos_h, ax = lobe->alpha, ay = lobe->alpha_across;
  double sin2 = fmax(0.0, (1.0 - cos_h) * (1.0 + cos_h));
  if (ax == ay) return sin2 / (c2 * ax * ax);
  double x2 = fmin(along_h * along_h, sin2);
  return (x2 / (ax * ax) + (sin2 - x2) / (ay * ay)) / c2;
}

/* Lambda toward a direction. */
static inline double um_materials_facet_lambda(const struct um_materials_lobe *lobe,
                                               um_materials_smith smith, double cosine,
                                               double along)
{
  double ax = lobe->alpha, ay = lobe->alpha_across;
  double sin2 = fmax(0.0, (1.0 - cosine) * (1.0 + cosine));
  if (ax == ay) return smith(cosine * cosine, ax * ax * sin2);
  double x2 = fmin(along * along, sin2);
  return smith(cosine * cosine, ax * ax * x2 + ay * ay * (sin2 - x2));
}

/* 1/G(i, o). */
static inline double um_materials_facet_unmasked(const struct um_materials_lobe *lobe,
                                                 double lambda_i, double lambda_o)
{
  return lobe->correlated ? 1.0 + lambda_i + lambda_o : (1.0 + lambda_i) * (1.0 + lambda_o);
}

/* Normal of slopes r (alpha cos 2 pi v, alpha_across sin 2 pi v). */
static inline struct um_vec3 um_materials_facet_normal(const struct um_materials_lobe *lobe,
                                                       double r, double v)
{
  double phi = 2.0 * UM_PI * v, x = lobe->alpha * r * cos(phi),
         y = lobe->alpha_across * r * sin(phi);
  double cosine = 1.0 / sqrt(1.0 + x * x + y * y);
  return um_vec3(x * cosine, y * cosine, cosine);
}

/* D(h) [1/sr]. */
static inline double um_materials_facet_distribution(const struct um_materials_lobe *lobe,
                                                     const struct um_materials_pair *pair)
{
  if (!(pair->cos_h > 0.0)) return 0.0;
  double c2 = pair->cos_h * pair->cos_h;
  return um_materials_facet_slopes(um_materials_facet_slope2(lobe, pair->cos_h, pair->along_h)) /
         (lobe->alpha * lobe->alpha_across * c2 * c2);
}

/* s(i) s(o) D G/(4 cos_i cos_o) [1/sr]; 0 where a cosine is not positive. */
static inline double um_materials_facet_lobe(const struct um_materials_lobe *lobe,
                                             double distribution,
                                             const struct um_materials_pair *pair)
{
  if (!(pair->cos_h > 0.0 && pair->cos_i > 0.0 && pair->cos_o > 0.0)) return 0.0;
  double lambda_i =
      um_materials_facet_lambda(lobe, um_materials_facet_smith, pair->cos_i, pair->along_i);
  double lambda_o =
      um_materials_facet_lambda(lobe, um_materials_facet_smith, pair->cos_o, pair->along_o);
  double compensation = um_materials_compensation(lobe, pair->cos_i, pair->along_i) *
                        um_materials_compensation(lobe, pair->cos_o, pair->along_o);
  return compensation * distribution /
         (um_materials_facet_unmasked(lobe, lambda_i, lambda_o) * 4.0 * pair->cos_i * pair->cos_o);
}

/* i = 2 (o.h) h - o and its weight, of a facet drawn from D cos_h; compensation_o: s(o). */
static inline struct um_materials_reflected
um_materials_facet_reflect_one(const struct um_materials_lobe *lobe, struct um_vec3 h,
                               struct um_vec3 o, double lambda_o, double compensation_o)
{
  struct um_materials_reflected r = {.cos_d = um_vec3_dot(o, h)};
  r.i = um_vec3_axpy(um_vec3_scale(o, -1.0), 2.0 * r.cos_d, h);
  if (!(r.cos_d > 0.0) || !(r.i.z > 0.0)) return r;
  double lambda_i = um_materials_facet_lambda(lobe, um_materials_facet_smith_coarse, r.i.z, r.i.x);
  double compensation = compensation_o * um_materials_compensation(lobe, r.i.z, r.i.x);
  r.weight =
      compensation * r.cos_d / (um_materials_facet_unmasked(lobe, lambda_i, lambda_o) * o.z * h.z);
  return r;
}

/* Members of the kind, as lobe.h has them. */

static double um_materials_facet_toward(const struct um_materials_lobe *lobe, struct um_vec3 o)
{
  return um_materials_facet_lambda(lobe, um_materials_facet_smith_coarse, o.z, o.x);
}

static void um_materials_facet_reflect(const struct um_materials_lobe *lobe,
                                       const struct um_vec3 *drawn, size_t n, struct um_vec3 o,
                                       double toward, struct um_materials_reflected *out)
{
  double compensation = um_materials_compensation(lobe, o.z, o.x);
  for (size_t k = 0; k < n; k++)
    out[k] = um_materials_facet_reflect_one(lobe, drawn[k], o, toward, compensation);
}

/* D cos_h/(4 cos_d) [1/sr]. */
static double um_materials_facet_density(const struct um_materials_lobe *lobe,
                                         const struct um_materials_pair *pair)
{
  return pair->cos_d > 0.0
             ? um_materials_facet_distribution(lobe, pair) * pair->cos_h / (4.0 * pair->cos_d)
             : 0.0;
}

#define UM_MATERIALS_FACETS                                                                        \
  .rough = true, .masked = true, .anisotropic = true, .toward = um_materials_facet_toward,         \
  .reflect = um_materials_facet_reflect, .slopes = um_materials_facet_slopes,                      \
  .density = um_materials_facet_density

#endif
