/* A map of the Earth as a table: one row per month, latitude and longitude, every combination once,
 * in any order. A missing column of months or longitudes: the same in all of them. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "base/core/order.h"
#include "environment/map_impl.h"

enum { MONTH, LATITUDE, LONGITUDE, AXES };

static const char *const axis_column[AXES] = {"month", "latitude_deg", "longitude_deg"};
static const double axis_minimum[AXES] = {1.0, -90.0, -180.0},
                    axis_maximum[AXES] = {12.0, 90.0, 360.0};
static const char *const quantity_column[UM_MAP_QUANTITIES] = {
    "albedo", "olr_W_m2", "brightness_temperature_K", "surface_temperature_K", "cloud_fraction"};

struct table {
  const struct um_core_csv *csv;
  size_t nrow;
  size_t column[AXES], quantity[UM_MAP_QUANTITIES]; /* (size_t)-1: not there */
  double *row[AXES];                                /* [nrow] in degrees; months as they are */
  double *node[AXES];                               /* [nnode] ascending, different */
  size_t nnode[AXES];
};

/* A header row that is one of ours, with at least one quantity. */
static enum um_status find_columns(struct um_context *context, struct table *t)
{
  const char *path = um_core_csv_name(t->csv);
  size_t found = 0;
  for (int q = 0; q < UM_MAP_QUANTITIES; q++) {
    t->quantity[q] = um_core_csv_find(t->csv, quantity_column[q]);
    found += t->quantity[q] != (size_t)-1;
  }
  for (int a = 0; a < AXES; a++) t->column[a] = um_core_csv_find(t->csv, axis_column[a]);
  UM_TRY(um_core_csv_require(context, t->csv, axis_column[LATITUDE], &t->column[LATITUDE]));
  for (size_t c = 0; c < um_core_csv_columns(t->csv); c++) {
    bool known = false;
    for (int a = 0; a < AXES; a++) known = known || t->column[a] == c;
    for (int q = 0; q < UM_MAP_QUANTITIES; q++) known = known || t->quantity[q] == c;
    if (!known)
      return um_core_fail(context, UM_ERR_INPUT,
                          "%s: column '%s'; accepted: month, latitude_deg, longitude_deg, albedo, "
                          "olr_W_m2, brightness_temperature_K, surface_temperature_K, "
                          "cloud_fraction",
                          path, um_core_csv_header(t->csv, c));
  }
  if (found > 0 && t->nrow > 0) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s: %s; accepted: rows with one or more of albedo, olr_W_m2, "
                      "brightness_temperature_K, surface_temperature_K, cloud_fraction",
                      path, found == 0 ? "no quantity" : "no rows");
}

static enum um_status read_axis(struct um_context *context, struct table *t, int a)
{
  UM_TRY(um_core_allocate(context, t->nrow, sizeof(double), &t->row[a]));
  UM_TRY(um_core_allocate(context, t->nrow, sizeof(double), &t->node[a]));
  for (size_t i = 0; i < t->nrow; i++) {
    double *x = &t->row[a][i];
    *x = a == MONTH ? 1.0 : 0.0;
    if (t->column[a] == (size_t)-1) continue;
    UM_TRY(um_core_csv_number(context, t->csv, i, t->column[a], x));
    if (!(*x >= axis_minimum[a] && *x <= axis_maximum[a]) || (a == MONTH && *x != floor(*x)))
      return um_core_csv_fail(context, t->csv, i, t->column[a], "%g; accepted: %s%g to %g", *x,
                              a == MONTH ? "whole numbers from " : "", axis_minimum[a],
                              axis_maximum[a]);
    if (a == LONGITUDE && *x >= 180.0) *x -= 360.0;
  }
  memcpy(t->node[a], t->row[a], t->nrow * sizeof(double));
  qsort(t->node[a], t->nrow, sizeof(double), um_core_order_double);
  for (size_t i = 0; i < t->nrow; i++)
    if (i == 0 || t->node[a][i] > t->node[a][t->nnode[a] - 1])
      t->node[a][t->nnode[a]++] = t->node[a][i];
  return UM_OK;
}

static size_t index_of(const struct table *t, int a, double x)
{
  const double *at = bsearch(&x, t->node[a], t->nnode[a], sizeof(double), um_core_order_double);
  return (size_t)(at - t->node[a]);
}

/* Every combination of the nodes once. */
static enum um_status check_grid(struct um_context *context, const struct table *t)
{
  double cells = (double)t->nnode[LATITUDE] * (double)t->nnode[LONGITUDE];
  double all = cells * (double)t->nnode[MONTH];
  if (cells > UM_MAP_CELLS_MOST)
    return um_core_fail(context, UM_ERR_INPUT, "%s: %g places; accepted: up to %d",
                        um_core_csv_name(t->csv), cells, UM_MAP_CELLS_MOST);
  if (all == (double)t->nrow) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s: %zu rows for %zu months, %zu latitudes and %zu longitudes; accepted: "
                      "every combination once, %.0f rows",
                      um_core_csv_name(t->csv), t->nrow, t->nnode[MONTH], t->nnode[LATITUDE],
                      t->nnode[LONGITUDE], all);
}

static enum um_status put_row(struct um_context *context, const struct table *t, size_t i,
                              uint8_t *taken, struct um_environment_map *map)
{
  size_t at = (index_of(t, MONTH, t->row[MONTH][i]) * map->nlatitude +
               index_of(t, LATITUDE, t->row[LATITUDE][i])) *
                  map->nlongitude +
              index_of(t, LONGITUDE, t->row[LONGITUDE][i]);
  if (taken[at])
    return um_core_csv_fail(context, t->csv, i, t->column[LATITUDE],
                            "month %g, latitude %g, longitude %g stand in an earlier row too; "
                            "accepted: every combination once",
                            t->row[MONTH][i], t->row[LATITUDE][i], t->row[LONGITUDE][i]);
  taken[at] = 1;
  for (int q = 0; q < UM_MAP_QUANTITIES; q++) {
    double value;
    if (map->value[q] == NULL || um_core_csv_text(t->csv, i, t->quantity[q])[0] == '\0') continue;
    UM_TRY(um_core_csv_number(context, t->csv, i, t->quantity[q], &value));
    const struct um_environment_map_range *range = &um_environment_map_range[q];
    if (!(value >= range->minimum && value <= range->maximum))
      return um_core_csv_fail(context, t->csv, i, t->quantity[q],
                              "%g; accepted: %g to %g %s, or nothing where it is not known", value,
                              range->minimum, range->maximum, range->unit);
    map->value[q][at] = (float)value;
  }
  return UM_OK;
}

static enum um_status fill(struct um_context *context, const struct table *t, uint8_t *taken,
                           struct um_environment_map *map)
{
  for (size_t i = 0; i < map->nlatitude; i++) map->latitude[i] = t->node[LATITUDE][i] * UM_DEG;
  for (size_t i = 0; i < map->nlongitude; i++) map->longitude[i] = t->node[LONGITUDE][i] * UM_DEG;
  for (size_t i = 0; i < map->nmonth; i++) map->month[i] = t->node[MONTH][i] - 1.0;
  for (size_t i = 0; i < t->nrow; i++) UM_TRY(put_row(context, t, i, taken, map));
  return UM_OK;
}

enum um_status um_environment_map_read_csv(struct um_context *context, const char *path,
                                           struct um_environment_map **out)
{
  enum um_status status;
  struct um_core_csv *csv = NULL;
  struct um_environment_map *map = NULL;
  struct table t = {0};
  uint8_t *taken = NULL;
  bool has[UM_MAP_QUANTITIES];
  *out = NULL;
  UM_TRY(um_core_csv_read(context, path, &csv));
  t.csv = csv;
  t.nrow = um_core_csv_rows(csv);
  UM_CHECK(find_columns(context, &t));
  for (int a = 0; a < AXES; a++) UM_CHECK(read_axis(context, &t, a));
  UM_CHECK(check_grid(context, &t));
  for (int q = 0; q < UM_MAP_QUANTITIES; q++) has[q] = t.quantity[q] != (size_t)-1;
  UM_CHECK(um_core_allocate(context, t.nrow, 1, &taken));
  UM_CHECK(um_environment_map_create(context, t.nnode[LATITUDE], t.nnode[LONGITUDE], t.nnode[MONTH],
                                     has, &map));
  UM_CHECK(fill(context, &t, taken, map));
  *out = map;
  map = NULL;
done:
  um_environment_map_destroy(context, &map);
  um_core_free(context, taken);
  for (int a = 0; a < AXES; a++) {
    UM_FREE(context, t.row[a], t.node[a]);
  }
  um_core_csv_destroy(&csv);
  return status;
}
