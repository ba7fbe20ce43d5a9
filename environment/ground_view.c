/* Albedo, emitted flux and brightness temperature of every place: uniform, Knocke's zones, a map;
 * and on top of them the region that differs.
 *
 *   value = base (1 + w (factor - 1)) + w offset
 *
 * w, the region's weight, is the product of its weight in time and that in place. */
#include "environment/ground_view.h"

#include <math.h>

#include "base/core/constants.h"
#include "environment/knocke.h"
#include "environment/map.h"
#include "environment/zones.h"

bool um_environment_region_is_neutral(const struct um_environment_region *region)
{
  return region->albedo_factor == 1.0 && region->albedo_offset == 0.0 &&
         region->longwave_factor == 1.0 && region->longwave_offset == 0.0 &&
         region->brightness_shift == 0.0;
}

bool um_environment_earth_varies(const struct um_environment *environment)
{
  return environment->earth != UM_EARTH_UNIFORM ||
         !um_environment_region_is_neutral(&environment->region);
}

bool um_environment_earth_is_spectral(const struct um_environment *environment)
{
  return environment->earth_spectrum_on && environment->earth != UM_EARTH_UNIFORM;
}

bool um_environment_earth_is_anisotropic(const struct um_environment *environment)
{
  return environment->earth_anisotropy_on && environment->daylight != NULL &&
         environment->earth != UM_EARTH_UNIFORM;
}

/* From 0 to 1 like a cosine while x goes from -width/2 to width/2. */
static double rise(double x, double width)
{
  if (x <= -0.5 * width) return x == 0.0 ? 1.0 : 0.0; /* without a width at once */
  if (x >= 0.5 * width) return 1.0;
  return 0.5 * (1.0 + sin(UM_PI * x / width));
}

static double weight_at_time(const struct um_environment_region *region, double t_tai)
{
  if (um_environment_region_is_neutral(region)) return 0.0;
  return rise(t_tai - region->from_tai, region->ramp) * rise(region->to_tai - t_tai, region->ramp);
}

struct um_environment_ground_view
um_environment_ground_view(const struct um_environment *environment,
                           const struct um_environment_globe *globe, double sun_distance)
{
  struct um_environment_ground_view view = {
      .environment = environment, .spectral = um_environment_earth_is_spectral(environment)};
  if (globe == NULL) return view;
  if (um_environment_earth_is_anisotropic(environment)) view.daylight = environment->daylight;
  const struct um_environment_region *region = &environment->region;
  double relative = UM_AU / sun_distance;
  view.pole = globe->pole;
  view.greenwich = globe->greenwich;
  view.east = um_vec3_cross(globe->pole, globe->greenwich);
  view.season = um_environment_knocke_season(globe->t_tai);
  view.irradiance = UM_SOLAR_IRRADIANCE * relative * relative;
  view.month = um_environment_month_of(globe->t_tai);
  view.weight = weight_at_time(region, globe->t_tai);
  double c = cos(region->latitude), s = sin(region->latitude);
  view.centre = um_vec3_axpy(
      um_vec3_axpy(um_vec3_scale(view.pole, s), c * cos(region->longitude), view.greenwich),
      c * sin(region->longitude), view.east);
  return view;
}

static struct um_environment_ground knocke_at(const struct um_environment_ground_view *view,
                                              double sine)
{
  struct um_environment_ground ground;
  double emissivity;
  um_environment_knocke(sine, view->season, &ground.albedo, &emissivity);
  ground.longwave = emissivity * 0.25 * view->irradiance;
  ground.brightness = um_environment_window_temperature(ground.longwave);
  return ground;
}

/* The Earth without the region. */
static struct um_environment_ground base_at(const struct um_environment_ground_view *view,
                                            struct um_vec3 place)
{
  const struct um_environment *e = view->environment;
  if (e->earth == UM_EARTH_UNIFORM)
    return (struct um_environment_ground){
        .albedo = e->albedo,
        .longwave = e->outgoing_longwave,
        .brightness = e->brightness_temperature,
        .surface = e->brightness_temperature,
    };
  double sine = fmin(fmax(um_vec3_dot(place, view->pole), -1.0), 1.0);
  struct um_environment_ground ground = knocke_at(view, sine);
  um_environment_zones(asin(sine), view->month, &ground.surface, &ground.cloud);
  ground.land = um_environment_zone_land(asin(sine));
  if (e->earth == UM_EARTH_MAP && e->map != NULL) {
    double longitude = atan2(um_vec3_dot(place, view->east), um_vec3_dot(place, view->greenwich));
    um_environment_map_at(e->map, asin(sine), longitude, view->month, &ground);
  }
  ground.own_albedo = ground.albedo;
  ground.albedo *= e->albedo_factor;
  ground.longwave *= e->longwave_factor;
  ground.brightness += e->brightness_shift;
  ground.surface += e->brightness_shift;
  return ground;
}

struct um_environment_ground um_environment_ground_at(const struct um_environment_ground_view *view,
                                                      struct um_vec3 place)
{
  const struct um_environment_region *region = &view->environment->region;
  struct um_environment_ground ground = base_at(view, place);
  double w = view->weight;
  if (w > 0.0 && !region->everywhere)
    w *= rise(region->radius - um_vec3_angle(place, view->centre), region->edge);
  if (w > 0.0) {
    ground.albedo *= 1.0 + w * (region->albedo_factor - 1.0);
    ground.albedo += w * region->albedo_offset;
    ground.longwave *= 1.0 + w * (region->longwave_factor - 1.0);
    ground.longwave += w * region->longwave_offset;
    ground.brightness += w * region->brightness_shift;
  }
  ground.albedo = fmin(fmax(ground.albedo, 0.0), 1.0);
  ground.longwave = fmax(ground.longwave, 0.0);
  ground.brightness = fmax(ground.brightness, 0.0);
  return ground;
}

double um_environment_ground_toward(const struct um_environment_ground_view *view,
                                    const struct um_environment_ground *ground,
                                    struct um_vec3 place, struct um_vec3 sun, struct um_vec3 toward)
{
  if (view->daylight == NULL) return 1.0;
  struct um_environment_daylight_pair pair = {.sun = fmin(fmax(um_vec3_dot(place, sun), 0.0), 1.0),
                                              .view =
                                                  fmin(fmax(um_vec3_dot(place, toward), 0.0), 1.0)};
  double sines = sqrt((1.0 - pair.sun * pair.sun) * (1.0 - pair.view * pair.view));
  double along = um_vec3_dot(sun, toward) - pair.sun * pair.view;
  pair.azimuth = sines > 0.0 ? along / sines : 0.0;
  /* snow goes by the place's own temperature; in single precision, in which a shift that is added
   * and taken away leaves no trace */
  struct um_environment_ground own = *ground;
  own.surface = (double)(float)(own.surface - view->environment->brightness_shift);
  struct um_environment_daylight_place scenes = um_environment_daylight_place(view->daylight, &own);
  return um_environment_daylight_factor(view->daylight, &scenes, pair);
}
