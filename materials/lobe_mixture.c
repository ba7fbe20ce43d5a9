/* Two lobes at once: a surface part of which is smooth and part rough, or that has a core and a
 * wide foot.
 *
 *   f = w f_1 + (1 - w) f_2
 * Either lobe gives half of the samples, whatever its share, so that strata of u stay whole; a
 * sample counts for the lobe that gave it alone, 2 w_k times its weight there. Over both that is f,
 * and no sample of the wide lobe sees the peak of the narrow one, which sums over rings would miss.
 * Which of the two drew a vector is in its sign: no lobe draws one below the surface. Creases add 2
 * s^2 to alpha^2 of both. */
#include <math.h>

#include "materials/lobe_impl.h"

struct parts {
  struct um_materials_lobe lobe[2];
  double share[2];
};

static struct parts parts_of(const struct um_materials_lobe *lobe)
{
  const struct um_materials_mixture *m = lobe->mixture;
  struct parts p = {.share = {m->share, 1.0 - m->share}};
  for (int k = 0; k < 2; k++) {
    double alpha = m->of[k].ratio * lobe->alpha;
    if (lobe->tilted > 0.0 && m->of[k].kind->rough) alpha = sqrt(alpha * alpha + lobe->tilted);
    p.lobe[k] = (struct um_materials_lobe){.kind = m->of[k].kind,
                                           .alpha = alpha,
                                           .alpha_across = alpha,
                                           .correlated = m->of[k].correlated,
                                           .compensated = lobe->compensated};
  }
  return p;
}

static double evaluate(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair)
{
  struct parts p = parts_of(lobe);
  return p.share[0] * p.lobe[0].kind->evaluate(&p.lobe[0], pair) +
         p.share[1] * p.lobe[1].kind->evaluate(&p.lobe[1], pair);
}

static double sunlit(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair,
                     double sun_radius)
{
  struct parts p = parts_of(lobe);
  return p.share[0] * p.lobe[0].kind->sunlit(&p.lobe[0], pair, sun_radius) +
         p.share[1] * p.lobe[1].kind->sunlit(&p.lobe[1], pair, sun_radius);
}

static struct um_vec3 draw(const struct um_materials_lobe *lobe, double u, double v)
{
  struct parts p = parts_of(lobe);
  int k = u < 0.5 ? 0 : 1;
  struct um_vec3 drawn = p.lobe[k].kind->draw(&p.lobe[k], 2.0 * u - k, v);
  return k == 0 ? drawn : um_vec3_scale(drawn, -1.0);
}

static void reflect(const struct um_materials_lobe *lobe, const struct um_vec3 *drawn, size_t n,
                    struct um_vec3 o, double none, struct um_materials_reflected *out)
{
  struct parts p = parts_of(lobe);
  double toward[2] = {um_materials_lobe_toward(&p.lobe[0], o),
                      um_materials_lobe_toward(&p.lobe[1], o)};
  (void)none;
  for (size_t j = 0; j < n; j++) {
    int k = drawn[j].z < 0.0 ? 1 : 0;
    struct um_vec3 own = k == 0 ? drawn[j] : um_vec3_scale(drawn[j], -1.0);
    p.lobe[k].kind->reflect(&p.lobe[k], &own, 1, o, toward[k], &out[j]);
    out[j].weight *= 2.0 * p.share[k];
  }
}

static double density(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair)
{
  struct parts p = parts_of(lobe);
  return 0.5 *
         (p.lobe[0].kind->density(&p.lobe[0], pair) + p.lobe[1].kind->density(&p.lobe[1], pair));
}

const struct um_materials_lobe_kind um_materials_lobe_mixture = {
    .name = "mixture",
    .summary = "two lobes, each of a share of the surface",
    .reference = "f = w f_1 + (1 - w) f_2",
    .rough = true,
    .mixed = true,
    .evaluate = evaluate,
    .sunlit = sunlit,
    .draw = draw,
    .reflect = reflect,
    .density = density,
};
