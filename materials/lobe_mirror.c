/* A true mirror: of a source of small solid angle it shows the image.
 *
 *   L = F E/Omega_sun where the mirror image of the observer lies in the Sun's disc, 0 elsewhere,
 * so that L = F E cos_i f gives f = 1/(Omega_sun cos_i) there, Omega_sun = 4 pi sin^2(theta_s/2).
 * The Sun has no limb darkening here. A curved body made of flat facets shows as many images as
 * facets that happen to point: facets must be smaller than 0.2 deg of its curve to sum up right. */
#include <math.h>

#include "base/core/constants.h"
#include "materials/lobe_impl.h"

/* A point has no image of finite radiance. */
static double evaluate(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair)
{
  (void)lobe;
  (void)pair;
  return 0.0;
}

static double sunlit(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair,
                     double sun_radius)
{
  double half = sin(0.5 * sun_radius), radius = 2.0 * half * half; /* 1 - cos(theta_s) */
  (void)lobe;
  if (!(pair->cos_i > 0.0 && pair->cos_o > 0.0 && pair->cos_h > 0.0)) return 0.0;
  return um_materials_pair_offset(pair) < radius ? 1.0 / (2.0 * UM_PI * radius * pair->cos_i) : 0.0;
}

static struct um_vec3 draw(const struct um_materials_lobe *lobe, double u, double v)
{
  (void)lobe;
  (void)u;
  (void)v;
  return um_vec3(0.0, 0.0, 1.0);
}

static struct um_materials_reflected reflect_one(const struct um_materials_lobe *lobe,
                                                 struct um_vec3 drawn, struct um_vec3 o)
{
  (void)lobe, (void)drawn;
  return (struct um_materials_reflected){um_vec3(-o.x, -o.y, o.z), o.z, o.z > 0.0 ? 1.0 : 0.0};
}

UM_MATERIALS_REFLECT_EACH(reflect_one)

static double density(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair)
{
  (void)lobe;
  (void)pair;
  return 0.0;
}

const struct um_materials_lobe_kind um_materials_lobe_mirror = {
    .name = "mirror",
    .summary = "a true mirror: the Sun's image",
    .reference = "L = F E/Omega_sun",
    .delta = true,
    .evaluate = evaluate,
    .sunlit = sunlit,
    .draw = draw,
    .reflect = reflect,
    .density = density,
};
