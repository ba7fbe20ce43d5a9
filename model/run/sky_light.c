/* The sky behind the satellite: lamps and line of sight of environment/sky_light.h. */
#include "model/run/sky_light.h"

#include <math.h>

#include "base/core/constants.h"
#include "environment/airmass.h"
#include "environment/moonlight.h"
#include "environment/sky_light.h"
#include "orbit/sun.h"

#define DAY      (-1.0 * UM_DEG)  /* the Sun's elevation down to which the Moon is nothing */
#define NIGHT    (-20.0 * UM_DEG) /* below which a lamp lights nothing */
#define ABOVE    2e6              /* height at which moonlight is taken: nothing hides it [m] */
#define STEP     10e-9            /* between wavelengths [m] */
#define SAMPLING 20e-9            /* of a bin [m] */

/* Sun or Moon as the station has it. */
struct lamp {
  double elevation, separation;          /* [rad], [1] */
  double scale;                          /* of its irradiance of the Sun's at 1 au [1] */
  struct um_environment_moonlight light; /* of the Moon; its scale 0: the Sun */
};

/* Radiance at a wavelength, over the Sun's irradiance at 1 au [1/sr]. */
static double shining(const struct lamp *lamp, const struct um_environment_sky_path *path,
                      double wavelength)
{
  double scale =
      lamp->light.scale > 0.0 ? um_environment_moonlight_at(&lamp->light, wavelength) : lamp->scale;
  return scale * um_environment_sky_path_radiance(path, wavelength, false);
}

static double node(size_t i) { return UM_SKY_LIGHT_SHORTEST + STEP * (double)i; }

static void add(const struct um_model *model, const struct lamp *lamp, double elevation,
                double from, double to, struct um_model_sky *out)
{
  struct um_environment_sky_path path;
  um_environment_sky_path(model->sky_light, &model->environment,
                          um_environment_apparent_elevation(elevation), lamp->elevation,
                          lamp->separation, &path);
  for (size_t i = 0; i < UM_MODEL_SKY_NODES; i++)
    if (node(i) > from - STEP && node(i) < to + STEP)
      out->relative[i] += shining(lamp, &path, fmin(node(i), UM_SKY_LIGHT_LONGEST));
  out->lit = true;
}

/* Geocentric directions; the Moon's elevation is that over a round Earth, 0.2 deg off at most. */
static struct lamp moon_of(const struct um_model *model, const struct um_environment_sample *sample,
                           struct um_vec3 station, struct um_vec3 to_satellite)
{
  struct um_vec3 moon = um_orbit_moon_position(sample->t_tai);
  struct um_vec3 toward = um_vec3_unit(um_vec3_sub(moon, station));
  struct um_environment_sample above = *sample; /* the Sun's direction moves by 0.05 arcsec */
  above.r = um_vec3_scale(um_vec3_unit(moon), UM_EARTH_RADIUS + ABOVE);
  struct um_vec3 from_there = um_vec3_sub(moon, above.r);
  double far = um_vec3_norm(um_vec3_sub(moon, station));
  above.moon_distance = um_vec3_norm(from_there);
  above.moon = um_vec3_scale(from_there, 1.0 / above.moon_distance);
  struct lamp lamp = {.elevation = asin(um_vec3_dot(toward, um_vec3_unit(station))),
                      .separation = um_vec3_dot(toward, to_satellite)};
  um_environment_moonlight(&model->environment, &above, &lamp.light);
  lamp.light.scale *= above.moon_distance * above.moon_distance / (far * far);
  return lamp;
}

void um_model_sky(const struct um_model *model, const struct um_model_tables *tables, size_t k,
                  double from, double to, struct um_model_sky *out)
{
  size_t middle = k * tables->nsub + tables->nsub / 2;
  const struct um_orbit_look *look = &tables->look[middle];
  const struct um_environment_sample *sample = &tables->sample[middle];
  *out = (struct um_model_sky){.environment = &model->environment};
  if (model->sky_light == NULL || !model->environment.sky.on || tables->hidden[k]) return;
  if (!(from < UM_SKY_LIGHT_LONGEST)) return;
  struct um_vec3 to_satellite = um_vec3_scale(look->to_observer, -1.0);
  struct um_vec3 station = um_vec3_axpy(look->r_gcrs, -look->range, to_satellite);
  double relative = UM_AU / sample->sun_distance;
  struct lamp sun = {.elevation = look->sun_elevation,
                     .separation = um_vec3_dot(sample->sun, to_satellite),
                     .scale = relative * relative};
  if (sun.elevation > NIGHT) add(model, &sun, look->elevation, from, to, out);
  if (!model->environment.moonlight_on || sun.elevation > DAY) return;
  struct lamp moon = moon_of(model, sample, station, to_satellite);
  if (moon.elevation > NIGHT && moon.light.scale > 0.0)
    add(model, &moon, look->elevation, from, to, out);
}

static double relative_at(const struct um_model_sky *sky, double wavelength)
{
  double place = (wavelength - UM_SKY_LIGHT_SHORTEST) / STEP;
  if (!(place >= 0.0 && place <= UM_MODEL_SKY_NODES - 1)) return 0.0;
  size_t i = (size_t)fmin(place, UM_MODEL_SKY_NODES - 2);
  double x = place - (double)i;
  return (1.0 - x) * sky->relative[i] + x * sky->relative[i + 1];
}

double um_model_sky_radiance(const struct um_model_sky *sky, double from, double to)
{
  int n = (int)fmax(ceil((to - from) / SAMPLING), 1.0);
  double sum = 0.0;
  if (!sky->lit) return 0.0;
  for (int j = 0; j < n; j++) {
    double begin = from + (to - from) * j / n, end = from + (to - from) * (j + 1) / n;
    double relative = relative_at(sky, 0.5 * (begin + end));
    if (relative > 0.0) sum += relative * um_environment_solar_band(sky->environment, begin, end);
  }
  return sum / (to - from);
}

double um_model_sky_band(const struct um_model_sky *sky, const struct um_instrument_bins *bins)
{
  double sum = 0.0;
  for (size_t i = 0; i < bins->n; i++) {
    double half = 0.5 * bins->width[i], l = bins->wavelength[i];
    double passes = bins->transmission != NULL ? bins->transmission[i] : 1.0;
    if (passes > 0.0)
      sum += passes * bins->width[i] * um_model_sky_radiance(sky, l - half, l + half);
  }
  return sum;
}
