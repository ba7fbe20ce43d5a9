/* Phong's lobe about the mirror direction, reciprocal, of energy at most one.
 *
 *   f = (n + 1)/(2 pi) cos^n delta / max(cos_i, cos_o),  delta between o and the mirror image of i
 * (Neumann, Neumann & Szirmay-Kalos 1999; their n + 2 reflects all at normal incidence, but more
 * than all at other angles where n is small). The weight of a direction thrown by cos^n delta is
 * min(1, cos_i/cos_o), so that a mirror is its limit at any angle; without the maximum (Lafortune &
 * Willems 1994) that would reflect cos_i. Near the mirror direction cos^n delta =
 * exp(-n delta^2/2), as facets of slope delta/2 have with alpha^2 = 1/(2 n): n = 1/(2 alpha^2). The
 * Sun's disc has the variance theta_s^2/4 per axis: 1/n' = 1/n + theta_s^2/4. */
#include <math.h>

#include "base/core/constants.h"
#include "materials/lobe_impl.h"

static double exponent(double alpha) { return 0.5 / (alpha * alpha); }

/* cos^n delta; 0 behind the surface's mirror. */
static double power(double n, const struct um_materials_pair *pair)
{
  double offset = um_materials_pair_offset(pair);
  return offset < 1.0 ? exp(n * log1p(-offset)) : 0.0;
}

static double lobe_of(double n, const struct um_materials_pair *pair)
{
  if (!(pair->cos_i > 0.0 && pair->cos_o > 0.0)) return 0.0;
  return (n + 1.0) / (2.0 * UM_PI) * power(n, pair) / fmax(pair->cos_i, pair->cos_o);
}

static double evaluate(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair)
{
  return lobe_of(exponent(lobe->alpha), pair);
}

static double sunlit(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair,
                     double sun_radius)
{
  double n = exponent(lobe->alpha);
  return lobe_of(n / (1.0 + 0.25 * n * sun_radius * sun_radius), pair);
}

/* About z; reflect turns z into the mirror direction of o. */
static struct um_vec3 draw(const struct um_materials_lobe *lobe, double u, double v)
{
  double cosine = pow(1.0 - u, 1.0 / (exponent(lobe->alpha) + 1.0)), phi = 2.0 * UM_PI * v;
  double sine = sqrt(fmax(0.0, (1.0 - cosine) * (1.0 + cosine)));
  return um_vec3(sine * cos(phi), sine * sin(phi), cosine);
}

static struct um_materials_reflected reflect_one(const struct um_materials_lobe *lobe,
                                                 struct um_vec3 drawn, struct um_vec3 o)
{
  (void)lobe;
  struct um_materials_reflected t = {.cos_d = 0.0};
  /* the turn about z x r that takes z to r = (-o.x, -o.y, o.z): d + k x d + k x (k x d)/(1 + r.z)
   */
  struct um_vec3 k = um_vec3(o.y, -o.x, 0.0), across = um_vec3_cross(k, drawn);
  t.i = um_vec3_axpy(um_vec3_add(drawn, across), 1.0 / (1.0 + o.z), um_vec3_cross(k, across));
  if (!(t.i.z > 0.0)) return t;
  t.cos_d = 0.5 * um_vec3_norm(um_vec3_add(t.i, o));
  t.weight = fmin(1.0, t.i.z / o.z);
  return t;
}

UM_MATERIALS_REFLECT_EACH(reflect_one)

static double density(const struct um_materials_lobe *lobe, const struct um_materials_pair *pair)
{
  double n = exponent(lobe->alpha);
  return (n + 1.0) / (2.0 * UM_PI) * power(n, pair);
}

const struct um_materials_lobe_kind um_materials_lobe_phong = {
    .name = "phong",
    .summary = "a power of the cosine from the mirror direction",
    .reference =
        "Phong 1975; Neumann, Neumann & Szirmay-Kalos 1999, Compact metallic reflectance models",
    .rough = true,
    .exponent = 0.5,
    .evaluate = evaluate,
    .sunlit = sunlit,
    .draw = draw,
    .reflect = reflect,
    .density = density,
};
