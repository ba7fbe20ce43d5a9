/* Monthly grids of what the Earth reflects and emits, from a file.
 *
 * CSV (docs/files.md): columns month, latitude_deg, longitude_deg and at least one of albedo,
 * olr_W_m2, brightness_temperature_K, surface_temperature_K, cloud_fraction. netCDF, as of CERES:
 * variables lat, lon and time, and (time, lat, lon) of toa_sw_all_mon with solar_mon (their ratio
 * is the albedo), toa_lw_all_mon, cldarea_total_daynight_mon, or our own albedo, olr,
 * brightness_temperature, surface_temperature and cloud_fraction. What a file lacks is Knocke's or
 * of its belt of latitude, and the log says so; a brightness temperature that it lacks follows from
 * its longwave, where it has that. */
#ifndef UMBRA_ENVIRONMENT_MAP_H
#define UMBRA_ENVIRONMENT_MAP_H

#include "base/core/context.h"
#include "environment/ground.h"

/* t_tai [s]: of a file with many years, the months nearest to this date are taken, where they are
 * within half a year of it; other months are means over all years.
 * UM_ERR_IO: not there. UM_ERR_INPUT: path, line or variable, what is accepted. UM_ERR_LIBRARY: the
 * netCDF library crashed or ran on (it works in a process of its own). The caller destroys. */
enum um_status um_environment_map_read(struct um_context *context, const char *path, double t_tai,
                                       struct um_environment_map **out);
/* Accepts NULL, sets NULL. */
void um_environment_map_destroy(struct um_context *context, struct um_environment_map **map);

/* Do both hold the same numbers on the same grid? NULL: no map. */
bool um_environment_map_equal(const struct um_environment_map *a,
                              const struct um_environment_map *b);

/* Put what the map has at geocentric latitude and longitude [rad] in place of what is in `ground`.
 * month: as of um_environment_month_of. Linear in latitude, longitude and month; constant from the
 * last row of latitudes to the pole, periodic in the other two. */
void um_environment_map_at(const struct um_environment_map *map, double latitude, double longitude,
                           double month, struct um_environment_ground *ground);

#endif
