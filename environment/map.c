/* Grids by month: storage, what is missing, interpolation.
 *
 * A place lies between two latitudes, two longitudes and two months; the eight values are weighted
 * by the products of linear weights. */
#include "environment/map_impl.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/file.h"
#include "base/core/file_snapshot.h"
#include "base/core/interpolation.h"
#include "environment/knocke.h"
#include "environment/zones.h"

#define PERIHELION 0.1    /* month in which the Earth is nearest to the Sun: 3 January */
#define NEARER     0.0334 /* irradiance there over its mean, less 1: 2 e */

const struct um_environment_map_range um_environment_map_range[UM_MAP_QUANTITIES] = {
    {"albedo", "1", 0.0, 1.0},
    {"outgoing longwave radiation", "W/m^2", 0.0, 600.0},
    {"brightness temperature", "K", 100.0, 400.0},
    {"ground's temperature", "K", 150.0, 400.0},
    {"cover of cloud", "1", 0.0, 1.0}};

enum um_status um_environment_map_create(struct um_context *context, size_t nlatitude,
                                         size_t nlongitude, size_t nmonth,
                                         const bool has[UM_MAP_QUANTITIES],
                                         struct um_environment_map **out)
{
  enum um_status status;
  struct um_environment_map *map = NULL;
  size_t n = nlatitude * nlongitude * nmonth;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *map, &map));
  map->nlatitude = nlatitude;
  map->nlongitude = nlongitude;
  map->nmonth = nmonth;
  UM_CHECK(um_core_allocate(context, nlatitude, sizeof(double), &map->latitude));
  UM_CHECK(um_core_allocate(context, nlongitude, sizeof(double), &map->longitude));
  UM_CHECK(um_core_allocate(context, nmonth, sizeof(double), &map->month));
  for (int q = 0; q < UM_MAP_QUANTITIES; q++) {
    if (!has[q]) continue;
    UM_CHECK(um_core_allocate(context, n, sizeof(float), &map->value[q]));
    for (size_t i = 0; i < n; i++) map->value[q][i] = NAN;
  }
  *out = map;
  map = NULL;
done:
  um_environment_map_destroy(context, &map);
  return status;
}

void um_environment_map_destroy(struct um_context *context, struct um_environment_map **map)
{
  if (map == NULL || *map == NULL) return;
  UM_FREE(context, (*map)->latitude, (*map)->longitude, (*map)->month);
  for (int q = 0; q < UM_MAP_QUANTITIES; q++) um_core_free(context, (*map)->value[q]);
  um_core_free(context, *map);
  *map = NULL;
}

/* What is taken for a quantity in the middle of a month: Knocke's, whose irradiance is that of the
 * season, or that of its belt. */
static double value_without(int quantity, double latitude, double month)
{
  double surface, cloud;
  um_environment_zones(latitude, month, &surface, &cloud);
  if (quantity == UM_MAP_SURFACE) return surface;
  if (quantity == UM_MAP_CLOUD) return cloud;
  double t = (month + 0.5) * 365.25 / 12.0 * 86400.0; /* of a year like any other */
  double albedo, emissivity;
  um_environment_knocke(sin(latitude), um_environment_knocke_season(t), &albedo, &emissivity);
  if (quantity == UM_MAP_ALBEDO) return albedo;
  double sun =
      UM_SOLAR_IRRADIANCE * (1.0 + NEARER * cos(2.0 * UM_PI * (month + 0.5 - PERIHELION) / 12.0));
  double longwave = emissivity * 0.25 * sun;
  return quantity == UM_MAP_LONGWAVE ? longwave : um_environment_window_temperature(longwave);
}

/* Share of the Earth's area and of the year that had to be filled [1]. */
static double fill(struct um_environment_map *map, int quantity)
{
  double missing = 0.0, all = 0.0;
  for (size_t m = 0; m < map->nmonth; m++)
    for (size_t i = 0; i < map->nlatitude; i++)
      for (size_t j = 0; j < map->nlongitude; j++) {
        size_t at = (m * map->nlatitude + i) * map->nlongitude + j;
        double area = cos(map->latitude[i]);
        all += area;
        if (!isnan(map->value[quantity][at])) continue;
        missing += area;
        const float *longwave = quantity == UM_MAP_BRIGHTNESS ? map->value[UM_MAP_LONGWAVE] : NULL;
        map->value[quantity][at] =
            (float)(longwave != NULL ? um_environment_window_temperature((double)longwave[at])
                                     : value_without(quantity, map->latitude[i], map->month[m]));
      }
  return all > 0.0 ? missing / all : 0.0;
}

void um_environment_map_finish(struct um_context *context, const char *path,
                               struct um_environment_map *map)
{
  for (int q = 0; q < UM_MAP_QUANTITIES; q++) {
    const char *name = um_environment_map_range[q].name;
    bool window = q == UM_MAP_BRIGHTNESS && map->value[UM_MAP_LONGWAVE] != NULL;
    bool belts = q == UM_MAP_SURFACE || q == UM_MAP_CLOUD;
    const char *instead = belts ? "the mean of its belt of latitude is taken"
                          : window
                              ? "taken from its outgoing longwave radiation by the relation of "
                                "Ohring, Gruber & Ellingson 1984"
                              : "that of Knocke, Ries & Tapley 1988 is taken";
    double missing = map->value[q] == NULL ? 1.0 : fill(map, q);
    if (map->value[q] == NULL)
      um_core_log(context, UM_LOG_INFO, "%s: no %s: %s", path, name, instead);
    else if (missing > 0.0)
      um_core_log(context, UM_LOG_INFO, "%s: %s missing on %.2g %% of the Earth: %s", path, name,
                  100.0 * missing, instead);
  }
  if (map->nmonth == 1) {
    um_core_log(context, UM_LOG_INFO, "%s: one month, or none stated: the same all year", path);
    return;
  }
  if (map->nmonth < 12)
    um_core_log(context, UM_LOG_INFO,
                "%s: %zu of 12 months; between them, and from the last to the first, it is linear",
                path, map->nmonth);
}

/* Two neighbours and the weight of the second, on a periodic axis of n ascending nodes. */
static void around(const double *node, size_t n, double period, double x, size_t at[2],
                   double *weight)
{
  at[0] = at[1] = 0;
  *weight = 0.0;
  if (n < 2) return;
  x -= period * floor((x - node[0]) / period); /* node[0] <= x < node[0] + period */
  at[0] = x >= node[n - 1] ? n - 1 : um_core_interval_find(node, n, x);
  at[1] = (at[0] + 1) % n;
  double to = at[1] == 0 ? node[0] + period : node[at[1]];
  *weight = (x - node[at[0]]) / (to - node[at[0]]);
}

void um_environment_map_at(const struct um_environment_map *map, double latitude, double longitude,
                           double month, struct um_environment_ground *ground)
{
  size_t row[2] = {0, 0}, column[2], page[2];
  double wrow = 0.0, wcolumn, wpage, sum[UM_MAP_QUANTITIES] = {0.0};
  if (map->nlatitude > 1) {
    row[0] = um_core_interval_find(map->latitude, map->nlatitude, latitude);
    row[1] = row[0] + 1;
    double from = map->latitude[row[0]], to = map->latitude[row[1]];
    wrow = fmin(fmax((latitude - from) / (to - from), 0.0), 1.0);
  }
  around(map->longitude, map->nlongitude, 2.0 * UM_PI, longitude, column, &wcolumn);
  around(map->month, map->nmonth, 12.0, month, page, &wpage);
  for (int k = 0; k < 8; k++) {
    double w = (k & 1 ? wcolumn : 1.0 - wcolumn) * (k & 2 ? wrow : 1.0 - wrow) *
               (k & 4 ? wpage : 1.0 - wpage);
    if (!(w > 0.0)) continue;
    size_t at = (page[k >> 2] * map->nlatitude + row[k >> 1 & 1]) * map->nlongitude + column[k & 1];
    for (int q = 0; q < UM_MAP_QUANTITIES; q++)
      if (map->value[q] != NULL) sum[q] += w * (double)map->value[q][at];
  }
  if (map->value[UM_MAP_ALBEDO] != NULL) ground->albedo = sum[UM_MAP_ALBEDO];
  if (map->value[UM_MAP_LONGWAVE] != NULL) {
    ground->longwave = sum[UM_MAP_LONGWAVE];
    ground->brightness = um_environment_window_temperature(ground->longwave);
  }
  if (map->value[UM_MAP_BRIGHTNESS] != NULL) ground->brightness = sum[UM_MAP_BRIGHTNESS];
  if (map->value[UM_MAP_SURFACE] != NULL) ground->surface = sum[UM_MAP_SURFACE];
  if (map->value[UM_MAP_CLOUD] != NULL) ground->cloud = sum[UM_MAP_CLOUD];
}

bool um_environment_map_equal(const struct um_environment_map *a,
                              const struct um_environment_map *b)
{
  if (a == b) return true;
  if (a == NULL || b == NULL || a->nlatitude != b->nlatitude || a->nlongitude != b->nlongitude ||
      a->nmonth != b->nmonth)
    return false;
  size_t n = a->nmonth * a->nlatitude * a->nlongitude;
  for (int q = 0; q < UM_MAP_QUANTITIES; q++) {
    if ((a->value[q] == NULL) != (b->value[q] == NULL)) return false;
    if (a->value[q] != NULL && memcmp(a->value[q], b->value[q], n * sizeof(float)) != 0)
      return false;
  }
  return memcmp(a->latitude, b->latitude, a->nlatitude * sizeof(double)) == 0 &&
         memcmp(a->longitude, b->longitude, a->nlongitude * sizeof(double)) == 0 &&
         memcmp(a->month, b->month, a->nmonth * sizeof(double)) == 0;
}

enum um_status um_environment_map_read(struct um_context *context, const char *path, double t_tai,
                                       struct um_environment_map **out)
{
  char head[8] = {0};
  *out = NULL;
  FILE *file;
  UM_TRY(um_core_file_open(context, path, &file));
  size_t n = fread(head, 1, sizeof head, file);
  fclose(file);
  bool netcdf =
      (n >= 4 && memcmp(head, "CDF", 3) == 0 && (head[3] == 1 || head[3] == 2 || head[3] == 5)) ||
      (n == 8 && memcmp(head, "\211HDF\r\n\032\n", 8) == 0);
  if (netcdf) {
    UM_TRY(um_core_snapshot_note(context, path));
    UM_TRY(um_environment_map_read_netcdf(context, path, t_tai, out));
  } else {
    UM_TRY(um_environment_map_read_csv(context, path, out));
  }
  um_environment_map_finish(context, path, *out);
  return UM_OK;
}
