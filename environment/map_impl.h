/* Storage of a map of the Earth and its readers, private to the environment. */
#ifndef UMBRA_ENVIRONMENT_MAP_IMPL_H
#define UMBRA_ENVIRONMENT_MAP_IMPL_H

#include "environment/map.h"

enum {
  UM_MAP_ALBEDO,
  UM_MAP_LONGWAVE,
  UM_MAP_BRIGHTNESS,
  UM_MAP_SURFACE,
  UM_MAP_CLOUD,
  UM_MAP_QUANTITIES
};

#define UM_MAP_CELLS_MOST 1036800 /* 0.25 deg */

struct um_environment_map {
  size_t nlatitude, nlongitude, nmonth;
  double *latitude;                /* [nlatitude] ascending [rad] */
  double *longitude;               /* [nlongitude] ascending, -pi..pi [rad] */
  double *month;                   /* [nmonth] ascending, 0..11 */
  float *value[UM_MAP_QUANTITIES]; /* [nmonth][nlatitude][nlongitude]; NULL: not in the file */
};

/* With room for the grid and those quantities that `has` names, filled with NaN. UM_ERR_MEMORY. */
enum um_status um_environment_map_create(struct um_context *context, size_t nlatitude,
                                         size_t nlongitude, size_t nmonth,
                                         const bool has[UM_MAP_QUANTITIES],
                                         struct um_environment_map **out);
/* Replace what is NaN by Knocke's model and belts of latitude (zones.h), and say what was missing
 * in the log. */
void um_environment_map_finish(struct um_context *context, const char *path,
                               struct um_environment_map *map);
enum um_status um_environment_map_read_csv(struct um_context *context, const char *path,
                                           struct um_environment_map **out);
enum um_status um_environment_map_read_netcdf(struct um_context *context, const char *path,
                                              double t_tai, struct um_environment_map **out);
/* What a quantity may be; the name by which messages call it, and its unit. */
struct um_environment_map_range {
  const char *name, *unit;
  double minimum, maximum;
};
extern const struct um_environment_map_range um_environment_map_range[UM_MAP_QUANTITIES];

#endif
