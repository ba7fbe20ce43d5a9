/* The Sun through the Earth's limb.
 *
 * A ray that arrives from the nadir angle theta' has the impact height b, sin theta' = (R + b)/r,
 * and comes from the true nadir angle theta(b) = theta' - alpha(b), alpha the bending of
 * limb_air.h. Radiance is kept along a ray, so that what arrives of the disc is
 *
 *   F = int w(theta) T(b) (d theta'/d theta) (sin theta'/sin theta) d theta,
 *
 * w the disc's light by its angle above the limb, T the transmission, d theta'/d theta the
 * dilution by refraction (Baum & Code 1953, Astron. J. 58:108: 1/(1 + D alpha/H) of an exponential
 * atmosphere) and the last factor what the round limb gathers. Over a cell of heights the light of
 * the disc between both true angles is exact, the rest taken at its middle. Rays lower than the
 * ground do not arrive, nor those that meet a cloud: the share of clear sight of a ray whose lowest
 * point is at height h is
 *
 *   (1 + erf((h - h_cloud)/(sqrt 2 s)))/2,   s = 2.5 km,
 *
 * half at the height of the clouds' tops that the environment states (SAGE II sees as much: Wang et
 * al. 1996, J. Geophys. Res. 101:29407), or of the latitude over which the straight line to the Sun
 * is lowest; so is ozone.
 *
 * Blue light is bent more than red, alpha = q alpha(0.55 um), q the refractivity's ratio: the light
 * of each cell is taken at two q, and a straight line between. The rest changes less.
 *
 * The limb is round: across the disc it falls off by eta^2/2 cot(theta), eta the angle along it, in
 * the mean of a chord (a^2 - v^2)/6 cot(theta). Light that air scatters into the shadow is that
 * of umbra_scatter.c. */
#include "environment/shadow_light.h"

#include <math.h>

#include "base/core/constants.h"
#include "environment/shadow_impl.h"

#define SHORTEST     0.25e-6 /* [m] */
#define LONGEST      4e-6    /* [m] */
#define CLOUD_SPREAD 2.5e3   /* s [m] */
#define FAR          3.0     /* radii of the Sun that the Earth is wide at least [1] */
#define DARK         60.0    /* optical depth beyond which nothing is left [1] */
#define LEAST_BENT   0.983   /* q of infrared light [1] */
#define MOST_BENT    1.02    /* of 0.39 um */
#define STEEPEST     1.04    /* of 0.3 um, beyond which ozone leaves nothing */

void um_environment_limb_make(const struct um_environment *environment,
                              struct um_environment_limb *out)
{
  struct um_environment_limb_profile middle = um_environment_limb_standard(UM_LIMB_MIDDLE);
  double sum = 0.0, ratio = log(LONGEST / SHORTEST) / UM_LIMB_BANDS;
  um_environment_limb_air_make(&middle, environment->shadow_radius, &out->straight);
  for (int z = 0; z < UM_LIMB_ZONES; z++) {
    struct um_environment_limb_profile zone =
        um_environment_limb_standard((enum um_environment_limb_zone)z);
    um_environment_limb_air_bent(&zone, environment->shadow_radius, &out->bent[z]);
  }
  for (int k = 0; k < UM_LIMB_BANDS; k++) {
    double from = SHORTEST * exp(ratio * k), to = from * exp(ratio);
    out->share[k] = um_environment_solar_band(environment, from, to);
    um_environment_limb_depth(sqrt(from * to), out->depth[k]);
    out->dispersion[k] = um_environment_limb_dispersion(sqrt(from * to));
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

/* Apparent angle above the limb of the rays of an impact height. */
static double apparent(const struct edge *e, double height)
{
  double sine = sin(e->sight.nadir) + height / e->sight.distance;
  return asin(fmin(sine, 1.0)) - e->sight.nadir;
}

/* What the environment holds where the rays pass: of each zone's air [units of
 * um_environment_limb_depth], and the height of the clouds' tops [m]. */
struct place {
  double amount[UM_LIMB_CONSTITUENTS][UM_LIMB_ZONES];
  double cloud_top;
};

static struct place place_of(const struct um_environment *environment, struct um_vec3 r,
                             struct um_vec3 sun, struct um_vec3 pole)
{
  struct um_vec3 low = um_vec3_sub(r, um_vec3_scale(sun, um_vec3_dot(r, sun)));
  double sine = um_vec3_dot(low, pole) / um_vec3_norm(low), share[UM_LIMB_ZONES];
  struct place place = {.cloud_top = environment->cloud_shift};
  um_environment_limb_zones(asin(fmax(fmin(sine, 1.0), -1.0)), share);
  for (int z = 0; z < UM_LIMB_ZONES; z++) {
    enum um_environment_limb_zone zone = (enum um_environment_limb_zone)z;
    double dobson = environment->ozone_dobson, cloud = environment->cloud_top;
    if (isnan(dobson)) dobson = um_environment_limb_zone_ozone(zone);
    if (isnan(cloud)) cloud = um_environment_limb_zone_cloud(zone);
    place.amount[UM_LIMB_AIR][z] = share[z] * environment->air_factor;
    place.amount[UM_LIMB_OZONE][z] = share[z] * environment->ozone_factor * dobson;
    place.amount[UM_LIMB_HAZE][z] = share[z] * environment->haze;
    place.amount[UM_LIMB_AEROSOL][z] = share[z] * environment->aerosol;
    place.cloud_top += share[z] * cloud;
  }
  return place;
}

/* Depths of the rays between nodes k and k + 1, at a share x of the way up: exponential between. */
static void add_depths(const struct um_environment_limb *limb, const struct place *place, int k,
                       double x, struct um_environment_shadow_light *out)
{
  for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++) {
    double low = 0.0, high = 0.0;
    for (int z = 0; z < UM_LIMB_ZONES; z++) {
      low += place->amount[c][z] * limb->bent[z].column[c][k];
      high += place->amount[c][z] * limb->bent[z].column[c][k + 1];
    }
    out->depth[c][out->count] = pow(low, 1.0 - x) * pow(high, x);
  }
}

double um_environment_limb_clear(double cloud_top, double height)
{
  return height < 0.0 ? 0.0 : 0.5 * erfc((cloud_top - height) / (sqrt(2.0) * CLOUD_SPREAD));
}

/* Rays of a cell of impact heights: apparent and true angles above the limb at its ends, and the
 * light of the disc below these. */
struct cell {
  double seen[2], angle[2], below[2];
};

/* Light of a cell, spread; at a share x of the way up it. */
static double light_of(const struct edge *e, const struct cell *c, double *x)
{
  double light = c->below[1] - c->below[0], size = c->angle[1] - c->angle[0];
  *x = 0.5;
  if (!(light > 0.0 && size > 0.0)) return 0.0;
  double low = fmax(c->angle[0], e->sight.angle - e->sight.disc);
  double high = fmin(c->angle[1], e->sight.angle + e->sight.disc);
  double middle = 0.5 * (low + high);
  *x = fmin(fmax((middle - c->angle[0]) / size, 0.0), 1.0);
  double seen = c->seen[0] + *x * (c->seen[1] - c->seen[0]);
  double gathered = sin(e->sight.nadir + seen) / fmax(fabs(sin(e->sight.nadir + middle)), 1e-3);
  return light * (c->seen[1] - c->seen[0]) / size * gathered;
}

/* The cell below node k, bent least and most. */
static void add_cell(const struct um_environment *environment, const struct edge *e,
                     const struct place *place, int k, const struct cell cell[2],
                     struct um_environment_shadow_light *out)
{
  const double *height = environment->limb->bent[0].height;
  double x[2], least = light_of(e, &cell[0], &x[0]), most = light_of(e, &cell[1], &x[1]);
  if (!(least + most > 0.0)) return;
  double at = (least * x[0] + most * x[1]) / (least + most);
  double lowest = height[k - 1] + at * (height[k] - height[k - 1]);
  double sight = um_environment_limb_clear(place->cloud_top, lowest);
  if (!(sight > 0.0)) return;
  double slope = (most - least) / (MOST_BENT - LEAST_BENT);
  out->share[out->count] = sight * (least + slope * (1.0 - LEAST_BENT));
  out->slope[out->count] = sight * slope;
  add_depths(environment->limb, place, k - 1, at, out);
  out->count++;
}

static void through_air(const struct um_environment *environment, const struct edge *e,
                        const struct place *place, struct um_environment_shadow_light *out)
{
  static const double bent[2] = {LEAST_BENT, MOST_BENT};
  const struct um_environment_limb_air *air = &environment->limb->bent[0]; /* all bend alike */
  struct cell c[2] = {{{0}, {0}, {0}}, {{0}, {0}, {0}}};
  for (int k = 0; k < UM_LIMB_NODES; k++) {
    double seen = apparent(e, k * UM_LIMB_STEP);
    for (int q = 0; q < 2; q++) {
      c[q].seen[1] = seen;
      c[q].angle[1] = seen - bent[q] * air->bending[k];
      c[q].below[1] = light_below(e, c[q].angle[1]);
    }
    if (k > 0) add_cell(environment, e, place, k, c, out);
    for (int q = 0; q < 2; q++) {
      c[q].seen[0] = c[q].seen[1];
      c[q].angle[0] = c[q].angle[1];
      c[q].below[0] = c[q].below[1];
    }
  }
  out->direct = 1.0 - c[0].below[1];
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
  struct place place = place_of(environment, r, sun, pole);
  through_air(environment, &e, &place, out);
}

/* Sum of the bundles, each dimmed by exp(-depth); none is less than nothing. */
static double through(const struct um_environment_shadow_light *light,
                      const double depth[UM_LIMB_CONSTITUENTS], double dispersion)
{
  double sum = light->direct, more = fmin(dispersion, STEEPEST) - 1.0;
  for (size_t i = 0; i < light->count; i++) {
    double tau = 0.0;
    for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++) tau += depth[c] * light->depth[c][i];
    if (tau < DARK) sum += fmax(light->share[i] + more * light->slope[i], 0.0) * exp(-tau);
  }
  return fmin(sum, 1.0);
}

double um_environment_shadow_light_at(const struct um_environment_shadow_light *light,
                                      double wavelength)
{
  double depth[UM_LIMB_CONSTITUENTS];
  if (light->count == 0) return light->direct;
  um_environment_limb_depth(wavelength, depth);
  return through(light, depth, um_environment_limb_dispersion(wavelength));
}

double um_environment_shadow_light_mean(const struct um_environment_limb *limb,
                                        const struct um_environment_shadow_light *light)
{
  double sum = 0.0;
  if (light->count == 0) return light->direct;
  for (int k = 0; k < UM_LIMB_BANDS; k++)
    sum += limb->share[k] * through(light, limb->depth[k], limb->dispersion[k]);
  return sum;
}

double um_environment_sunlit_fraction(const struct um_environment *environment, struct um_vec3 r,
                                      struct um_vec3 sun, double distance, struct um_vec3 pole)
{
  struct um_environment_shadow_light light;
  um_environment_shadow_light(environment, r, sun, distance, pole, &light);
  return um_environment_shadow_light_mean(environment->limb, &light);
}
