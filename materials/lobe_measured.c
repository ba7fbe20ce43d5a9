/* A BRDF as it was measured: a table over the hemisphere (measured.h).
 *
 * Half vectors are drawn by an inverse distribution of their angle from the normal, which does not
 * know the observer; i = 2 (o.h) h - o has the density p(h)/(4 o.h) (Walter et al. 2007, eq. 14).
 * The Sun's disc is narrower than what a goniometer tells apart: its mean is the value. */
#include <math.h>

#include "base/core/constants.h"
#include "materials/lobe_impl.h"
#include "materials/measured.h"

static double evaluate(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair)
{
  return um_materials_measured_evaluate(lobe->measured, pair->cos_i, pair->cos_o, pair->cos_d);
}

static double sunlit(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair,
                     double sun_radius)
{
  (void)sun_radius;
  return evaluate(lobe, pair);
}

static struct um_vec3 draw(const struct um_materials_lobe *lobe, double u, double v)
{
  double cosine = um_materials_measured_draw(lobe->measured, u), phi = 2.0 * UM_PI * v;
  double sine = sqrt(fmax(0.0, (1.0 - cosine) * (1.0 + cosine)));
  return um_vec3(sine * cos(phi), sine * sin(phi), cosine);
}

static struct um_materials_reflected reflect_one(const struct um_materials_lobe *lobe,
                                                 struct um_vec3 h, struct um_vec3 o)
{
  const struct um_materials_measured *m = lobe->measured;
  struct um_materials_reflected r = {.cos_d = um_vec3_dot(o, h)};
  r.i = um_vec3_axpy(um_vec3_scale(o, -1.0), 2.0 * r.cos_d, h);
  if (!(r.cos_d > 0.0) || !(r.i.z > 0.0)) return r;
  r.weight = um_materials_measured_evaluate(m, r.i.z, o.z, r.cos_d) * r.i.z * 4.0 * r.cos_d /
             um_materials_measured_half_density(m, h.z);
  return r;
}

UM_MATERIALS_REFLECT_EACH(reflect_one)

static double density(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair)
{
  if (!(pair->cos_d > 0.0)) return 0.0;
  return um_materials_measured_half_density(lobe->measured, pair->cos_h) / (4.0 * pair->cos_d);
}

const struct um_materials_lobe_kind um_materials_lobe_measured = {
    .name = "measured",
    .summary = "a table over the hemisphere, as it was measured",
    .reference = "f(i, o) = f(o, i), ln f by cubics; Walter et al. 2007, eq. 14, for its samples",
    .absorbs = true,
    .evaluate = evaluate,
    .sunlit = sunlit,
    .draw = draw,
    .reflect = reflect,
    .density = density,
};
