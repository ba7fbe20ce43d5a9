/* The Sun through the Earth's limb.
 *
 * A ray that arrives from the nadir angle theta' passes at the height h of its lowest point,
 * sin theta' = (R + h)/r, and comes from the true nadir angle theta(h) = theta' - alpha(h), alpha
 * the bending of limb_air.h. Radiance is kept along a ray, so that what arrives of the disc is
 *
 *   F = int w(theta) T(h) (d theta'/d theta) (sin theta'/sin theta) d theta,
 *
 * w the disc's light by its angle above the limb, T the transmission, d theta'/d theta the
 * dilution by refraction (Baum & Code 1953, Astron. J. 58:108: 1/(1 + D alpha/H) of an exponential
 * atmosphere) and the last factor what the round limb gathers. Over a cell of heights the light of
 * the disc between both true angles is exact, the rest taken at its middle. Rays lower than the
 * ground do not arrive, nor those that meet a cloud: the share of clear sight at height h is
 *
 *   (1 + erf((h - h_cloud)/(sqrt 2 s)))/2,   s = 2.5 km,
 *
 * half at the height of the clouds' tops that the environment states (SAGE II sees as much: Wang et
 * al. 1996, J. Geophys. Res. 101:29407).
 *
 * The limb is round: across the disc it falls off by eta^2/2 cot(theta), eta the angle along it, in
 * the mean of a chord (a^2 - v^2)/6 cot(theta). Light that air scatters into the shadow is left
 * out. */
#include "environment/shadow_light.h"

#include <math.h>

#include "base/core/constants.h"
#include "environment/shadow_impl.h"

#define SHORTEST     0.25e-6 /* [m] */
#define LONGEST      4e-6    /* [m] */
#define CLOUD_SPREAD 2.5e3   /* s [m] */
#define FAR          3.0     /* radii of the Sun that the Earth is wide at least [1] */
#define DARK         60.0    /* optical depth beyond which nothing is left [1] */

void um_environment_limb_make(const struct um_environment *environment,
                              struct um_environment_limb *out)
{
  struct um_environment_limb_profile standard = um_environment_limb_standard();
  double sum = 0.0, ratio = log(LONGEST / SHORTEST) / UM_LIMB_BANDS;
  um_environment_limb_air_make(&standard, environment->shadow_radius, &out->air);
  for (int k = 0; k < UM_LIMB_BANDS; k++) {
    double from = SHORTEST * exp(ratio * k), to = from * exp(ratio);
    out->share[k] = um_environment_solar_band(environment, from, to);
    um_environment_limb_depth(sqrt(from * to), out->depth[k]);
    sum += out->share[k];
  }
  for (int k = 0; k < UM_LIMB_BANDS; k++) out->share[k] = sum > 0.0 ? out->share[k] / sum : 0.0;
}

/* Light of a disc of radius 1, darkened by 1 - u (1 - mu), below the height x of its centre. */
static double disc_below(double x, double u)
{
  if (x <= -1.0) return 0.0;
  if (x >= 1.0) return 1.0;
  double c = sqrt((1.0 - x) * (1.0 + x));
  double uniform = x * c + asin(x) + 0.5 * UM_PI,
         dome = 0.5 * UM_PI * (x - x * x * x / 3.0 + 2.0 / 3.0);
  return ((1.0 - u) * uniform + u * dome) / (UM_PI * (1.0 - u / 3.0));
}

struct edge {
  struct um_environment_limb_sight sight;
  double darkening, curve; /* u; cot(theta)/6 times the disc's radius [1] */
};

/* Light of the disc below an angle above the limb [rad]. */
static double light_below(const struct edge *e, double angle)
{
  double x = (angle - e->sight.angle) / e->sight.disc;
  if (fabs(x) < 1.0) x -= e->curve * (1.0 - x * x);
  return disc_below(x, e->darkening);
}

/* Apparent angle above the limb of the rays that pass at a height. */
static double apparent(const struct edge *e, double height)
{
  double sine = sin(e->sight.nadir) + height / e->sight.distance;
  return asin(fmin(sine, 1.0)) - e->sight.nadir;
}

static double clear(const struct um_environment *environment, double height)
{
  return 0.5 * erfc((environment->cloud_top - height) / (sqrt(2.0) * CLOUD_SPREAD));
}

/* Rays between nodes k and k + 1, at a share x of the way up; columns are exponential between. */
static void add_rays(const struct um_environment *environment, int k, double x, double share,
                     struct um_environment_shadow_light *out)
{
  const double stated[UM_LIMB_CONSTITUENTS] = {environment->air_factor, environment->ozone_dobson,
                                               environment->haze, environment->aerosol};
  const struct um_environment_limb_air *air = &environment->limb->air;
  share *= clear(environment, (k + x) * UM_LIMB_STEP);
  if (!(share > 0.0)) return;
  out->share[out->count] = share;
  for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++)
    out->depth[c][out->count] =
        stated[c] * pow(air->column[c][k], 1.0 - x) * pow(air->column[c][k + 1], x);
  out->count++;
}

/* Rays of a cell of heights: apparent and true angles above the limb at its ends, and the light of
 * the disc below these. */
struct cell {
  double seen[2], angle[2], below[2];
};

static void add_cell(const struct um_environment *environment, const struct edge *e, int k,
                     const struct cell *c, struct um_environment_shadow_light *out)
{
  double light = c->below[1] - c->below[0], size = c->angle[1] - c->angle[0];
  if (!(light > 0.0 && size > 0.0)) return;
  double low = fmax(c->angle[0], e->sight.angle - e->sight.disc);
  double high = fmin(c->angle[1], e->sight.angle + e->sight.disc);
  double middle = 0.5 * (low + high), x = fmin(fmax((middle - c->angle[0]) / size, 0.0), 1.0);
  double seen = c->seen[0] + x * (c->seen[1] - c->seen[0]);
  double gathered = sin(e->sight.nadir + seen) / fmax(fabs(sin(e->sight.nadir + middle)), 1e-3);
  add_rays(environment, k, x, light * (c->seen[1] - c->seen[0]) / size * gathered, out);
}

static void through_air(const struct um_environment *environment, const struct edge *e,
                        struct um_environment_shadow_light *out)
{
  const struct um_environment_limb_air *air = &environment->limb->air;
  struct cell c = {{0}, {0}, {0}};
  for (int k = 0; k < UM_LIMB_NODES; k++) {
    c.seen[1] = apparent(e, k * UM_LIMB_STEP);
    c.angle[1] = c.seen[1] - air->bending[k];
    c.below[1] = light_below(e, c.angle[1]);
    if (k > 0) add_cell(environment, e, k - 1, &c, out);
    c.seen[0] = c.seen[1];
    c.angle[0] = c.angle[1];
    c.below[0] = c.below[1];
  }
  out->direct = 1.0 - c.below[1];
}

/* Where only the bare Earth counts. */
static bool airless(const struct um_environment *environment, const struct edge *e)
{
  bool round = environment->shadow == UM_SHADOW_SPHERE || environment->shadow == UM_SHADOW_OBLATE;
  return environment->limb == NULL || !environment->shadow_refraction_on || !round ||
         environment->disc == UM_DISC_POINT || !(e->sight.nadir >= FAR * e->sight.disc) ||
         !(e->sight.angle > -0.5 * UM_PI);
}

void um_environment_shadow_light(const struct um_environment *environment, struct um_vec3 r,
                                 struct um_vec3 sun, double distance, struct um_vec3 pole,
                                 struct um_environment_shadow_light *out)
{
  struct edge e = {.sight = um_environment_limb_sight(environment, r, sun, distance, pole)};
  out->direct = 1.0;
  out->count = 0;
  if (airless(environment, &e)) {
    out->direct = um_environment_airless_fraction(environment, r, sun, distance, pole);
    return;
  }
  if (apparent(&e, (UM_LIMB_NODES - 1) * UM_LIMB_STEP) <= e.sight.angle - e.sight.disc) return;
  if (environment->disc == UM_DISC_LIMB_DARKENED) e.darkening = environment->limb_darkening;
  e.curve = e.sight.disc / (6.0 * tan(e.sight.nadir));
  through_air(environment, &e, out);
}

/* Sum of the bundles, each dimmed by exp(-depth). */
static double through(const struct um_environment_shadow_light *light,
                      const double depth[UM_LIMB_CONSTITUENTS])
{
  double sum = light->direct;
  for (size_t i = 0; i < light->count; i++) {
    double tau = 0.0;
    for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++) tau += depth[c] * light->depth[c][i];
    if (tau < DARK) sum += light->share[i] * exp(-tau);
  }
  return fmin(sum, 1.0);
}

double um_environment_shadow_light_at(const struct um_environment_shadow_light *light,
                                      double wavelength)
{
  double depth[UM_LIMB_CONSTITUENTS];
  if (light->count == 0) return light->direct;
  um_environment_limb_depth(wavelength, depth);
  return through(light, depth);
}

double um_environment_shadow_light_mean(const struct um_environment_limb *limb,
                                        const struct um_environment_shadow_light *light)
{
  double sum = 0.0;
  if (light->count == 0) return light->direct;
  for (int k = 0; k < UM_LIMB_BANDS; k++) sum += limb->share[k] * through(light, limb->depth[k]);
  return sum;
}

double um_environment_sunlit_fraction(const struct um_environment *environment, struct um_vec3 r,
                                      struct um_vec3 sun, double distance, struct um_vec3 pole)
{
  struct um_environment_shadow_light light;
  um_environment_shadow_light(environment, r, sun, distance, pole, &light);
  return um_environment_shadow_light_mean(environment->limb, &light);
}
