/* The scenes of a place, and what they send toward a view. */
#include <math.h>

#include "base/core/constants.h"
#include "environment/daylight.h"
#include "environment/quadrature_impl.h"

#define THAW   273.0 /* warmer ground has no snow [K] */
#define FROZEN 263.0 /* colder ground is snow, sea too [K] */

/* Place among the cosines: the node below, and how far toward the next one, 0..1. */
static int node_of(double cosine, double *part)
{
  int i = 0;
  while (i + 2 < UM_DAYLIGHT_COSINES && cosine >= um_environment_gauss_16[i + 1].x) i++;
  double from = um_environment_gauss_16[i].x, to = um_environment_gauss_16[i + 1].x;
  *part = fmin(fmax((cosine - from) / (to - from), 0.0), 1.0);
  return i;
}

/* The nodes about a pair of directions. */
struct corners {
  int sun, view, azimuth;
  double s, v, a;
};

static struct corners corners_of(struct um_environment_daylight_pair pair)
{
  struct corners c;
  double at = acos(fmin(fmax(-pair.azimuth, -1.0), 1.0)) / UM_PI * (UM_DAYLIGHT_AZIMUTHS - 1);
  c.sun = node_of(pair.sun, &c.s);
  c.view = node_of(pair.view, &c.v);
  c.azimuth = (int)fmin(at, UM_DAYLIGHT_AZIMUTHS - 2.0);
  c.a = at - c.azimuth;
  return c;
}

static double reflectance_at(const struct um_environment_daylight *daylight, int scene,
                             const struct corners *c)
{
  double sum = 0.0;
  for (int k = 0; k < 4; k++) {
    const float *row =
        &daylight->reflectance[scene][c->sun + (k & 1)][c->view + (k >> 1)][c->azimuth];
    sum += (k & 1 ? c->s : 1.0 - c->s) * (k >> 1 ? c->v : 1.0 - c->v) *
           ((1.0 - c->a) * (double)row[0] + c->a * (double)row[1]);
  }
  return sum;
}

static double flux_at(const struct um_environment_daylight *daylight, int scene, int sun, double s)
{
  return (1.0 - s) * daylight->flux[scene][sun] + s * daylight->flux[scene][sun + 1];
}

double um_environment_daylight_reflectance(const struct um_environment_daylight *daylight,
                                           enum um_daylight_scene scene,
                                           struct um_environment_daylight_pair pair)
{
  struct corners c = corners_of(pair);
  return reflectance_at(daylight, (int)scene, &c);
}

double um_environment_daylight_flux(const struct um_environment_daylight *daylight,
                                    enum um_daylight_scene scene, double sun)
{
  double s;
  int i = node_of(sun, &s);
  return flux_at(daylight, (int)scene, i, s);
}

struct um_environment_daylight_place
um_environment_daylight_place(const struct um_environment_daylight *daylight,
                              const struct um_environment_ground *ground)
{
  struct um_environment_daylight_place place = {.cloud = 0};
  const double *clouds = daylight->albedo + UM_DAYLIGHT_CLOUD;
  double snow = fmin(fmax((THAW - ground->surface) / (THAW - FROZEN), 0.0), 1.0);
  double land = (1.0 - snow) * ground->land, sea = (1.0 - snow) * (1.0 - ground->land);
  double cover = fmin(fmax(ground->cloud, 0.0), 1.0), clear = 1.0 - cover;
  double below = sea * daylight->albedo[UM_DAYLIGHT_SEA] +
                 land * daylight->albedo[UM_DAYLIGHT_LAND] +
                 snow * daylight->albedo[UM_DAYLIGHT_SNOW];
  double wanted = cover > 0.0 ? (ground->own_albedo - clear * below) / cover : 0.0;
  int k = 0;
  while (k + 2 < UM_DAYLIGHT_CLOUDS && wanted >= clouds[k + 1]) k++;
  double v = fmin(fmax((wanted - clouds[k]) / (clouds[k + 1] - clouds[k]), 0.0), 1.0);
  place.cloud = k;
  place.share[0] = clear * sea;
  place.share[1] = clear * land;
  place.share[2] = clear * snow;
  place.share[3] = cover * (1.0 - v);
  place.share[4] = cover * v;
  return place;
}

double um_environment_daylight_factor(const struct um_environment_daylight *daylight,
                                      const struct um_environment_daylight_place *place,
                                      struct um_environment_daylight_pair pair)
{
  struct corners c = corners_of(pair);
  double radiance = 0.0, flux = 0.0;
  for (int k = 0; k < 5; k++) {
    if (!(place->share[k] > 0.0)) continue;
    int scene = k < UM_DAYLIGHT_CLOUD ? k : UM_DAYLIGHT_CLOUD + place->cloud + (k - 3);
    radiance += place->share[k] * reflectance_at(daylight, scene, &c);
    flux += place->share[k] * flux_at(daylight, scene, c.sun, c.s);
  }
  return radiance / flux;
}
