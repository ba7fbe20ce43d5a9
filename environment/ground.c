/* Albedo, emitted flux and brightness temperature of every place: uniform, Knocke's zones, a map;
 * and on top of them the region that differs.
 *
 *   value = base (1 + w (factor - 1)) + w offset
 *
 * w, the region's weight, is the product of its weight in time and that in place. */
#include "environment/ground.h"

#include <math.h>

#include "core/constants.h"
#include "environment/environment.h"
#include "environment/map_impl.h"

#define DAY              86400.0
#define KNOCKE_EPOCH_DAY 6584.5   /* from 1981-12-22 0 h to 2000-01-01 12 h [d] */
#define WINDOW_A         1.228    /* Ohring, Gruber & Ellingson 1984 [1] */
#define WINDOW_B         1.106e-3 /* the same [1/K] */

void um_environment_knocke(double sine_latitude, double season, double *albedo, double *emissivity)
{
  double p1 = sine_latitude, p2 = 0.5 * (3.0 * sine_latitude * sine_latitude - 1.0);
  *albedo = 0.34 + 0.10 * season * p1 + 0.29 * p2;
  *emissivity = 0.68 - 0.07 * season * p1 - 0.18 * p2;
}

double um_environment_knocke_season(double t_tai)
{
  return cos(2.0 * UM_PI * (t_tai / DAY + KNOCKE_EPOCH_DAY) / 365.25);
}

double um_environment_window_temperature(double longwave)
{
  double flux_temperature = pow(fmax(longwave, 0.0) / UM_STEFAN_BOLTZMANN, 0.25);
  double root = WINDOW_A * WINDOW_A - 4.0 * WINDOW_B * flux_temperature;
  return (WINDOW_A - sqrt(fmax(root, 0.0))) / (2.0 * WINDOW_B);
}

/* Gregorian year, month 0..11 and time of the month [d] of days since 2000-03-01 0 h: a year that
 * begins in March ends with its leap day, and 400 of them have 146097 days. */
int um_environment_month_split(double days, int *year, double *in_month)
{
  static const int first[13] = {0, 31, 61, 92, 122, 153, 184, 214, 245, 275, 306, 337, 366};
  double era = floor(days / 146097.0), rest = days - era * 146097.0;
  int day = (int)rest, y = 0;
  y = (day - day / 1460 + day / 36524 - day / 146096) / 365;
  int of_year = day - (365 * y + y / 4 - y / 100), m = 0;
  while (m < 11 && of_year >= first[m + 1]) m++;
  *in_month = of_year - first[m] + (rest - day);
  *year = 2000 + 400 * (int)era + y + (m >= 10);
  return (m + 2) % 12;
}

double um_environment_month_of(double t_tai)
{
  static const double length[12] = {31, 28.25, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  int year;
  double in_month, days = t_tai / DAY + 0.5 - 60.0; /* since 2000-03-01 0 h */
  int m = um_environment_month_split(days, &year, &in_month);
  return m + fmin(in_month / length[m], 1.0) - 0.5;
}

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
  struct um_environment_ground_view view = {.environment = environment};
  if (globe == NULL) return view;
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
    return (struct um_environment_ground){e->albedo, e->outgoing_longwave,
                                          e->brightness_temperature};
  double sine = fmin(fmax(um_vec3_dot(place, view->pole), -1.0), 1.0);
  struct um_environment_ground ground = knocke_at(view, sine);
  if (e->earth == UM_EARTH_MAP && e->map != NULL) {
    double longitude = atan2(um_vec3_dot(place, view->east), um_vec3_dot(place, view->greenwich));
    um_environment_map_at(e->map, asin(sine), longitude, view->month, &ground);
  }
  ground.albedo *= e->albedo_factor;
  ground.longwave *= e->longwave_factor;
  ground.brightness += e->brightness_shift;
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
