/* Lambert's lobe: alike in all directions, f = 1/pi. */
#include <math.h>

#include "base/core/constants.h"
#include "materials/lobe_impl.h"

static double evaluate(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair)
{
  (void)lobe;
  return pair->cos_i > 0.0 && pair->cos_o > 0.0 ? 1.0 / UM_PI : 0.0;
}

static double sunlit(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair,
                     double sun_radius)
{
  (void)sun_radius;
  return evaluate(lobe, pair);
}

static struct um_vec3 draw(const struct um_materials_lobe *lobe, double u, double v)
{
  double r = sqrt(u), phi = 2.0 * UM_PI * v;
  (void)lobe;
  return um_vec3(r * cos(phi), r * sin(phi), sqrt(1.0 - u));
}

static struct um_materials_reflected reflect_one(const struct um_materials_lobe *lobe,
                                                 struct um_vec3 drawn, struct um_vec3 o)
{
  (void)lobe;
  return (struct um_materials_reflected){drawn, 0.5 * um_vec3_norm(um_vec3_add(drawn, o)), 1.0};
}

UM_MATERIALS_REFLECT_EACH(reflect_one)

static double density(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair)
{
  (void)lobe;
  return fmax(0.0, pair->cos_i) / UM_PI;
}

const struct um_materials_lobe_kind um_materials_lobe_lambert = {
    .name = "lambert",
    .summary = "alike in all directions",
    .reference = "Lambert 1760, Photometria",
    .evaluate = evaluate,
    .sunlit = sunlit,
    .draw = draw,
    .reflect = reflect,
    .density = density,
};
