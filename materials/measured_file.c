/* A table of a BRDF over the hemisphere: rows of a whole grid, ascending. */
#include <math.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "materials/measured.h"

#define SAME  1e-9  /* [deg] */
#define LEAST 1e-12 /* BRDF [1/sr] */
#define MOST  1e9

enum { INCIDENCE, SCATTERING, AZIMUTH, VALUE, COLUMNS };

struct table {
  struct um_core_csv *csv;
  size_t column[COLUMNS];
  double *row; /* [nrow][COLUMNS] [deg], [1/sr] */
  size_t nrow;
  size_t count[3]; /* of angles, by column */
};

static double at(const struct table *t, size_t row, size_t c) { return t->row[row * COLUMNS + c]; }

static enum um_status read_rows(struct um_context *context, struct table *t)
{
  static const double most[COLUMNS] = {90.0, 90.0, 360.0, 0.0};
  t->nrow = um_core_csv_rows(t->csv);
  if (t->nrow == 0 || t->nrow > UM_MATERIALS_MEASURED_NODES)
    return um_core_fail(context, UM_ERR_INPUT, "%s: %zu rows; accepted: 1 to %d directions",
                        um_core_csv_name(t->csv), t->nrow, UM_MATERIALS_MEASURED_NODES);
  UM_TRY(um_core_allocate(context, t->nrow * COLUMNS, sizeof *t->row, &t->row));
  for (size_t r = 0; r < t->nrow; r++)
    for (size_t c = 0; c < COLUMNS; c++) {
      double *value = &t->row[r * COLUMNS + c];
      UM_TRY(um_core_csv_number(context, t->csv, r, t->column[c], value));
      if (c == VALUE && !(*value >= LEAST && *value <= MOST))
        return um_core_csv_fail(context, t->csv, r, t->column[c],
                                "%g; accepted: %g to %g [1/sr], the limit of detection where "
                                "nothing was found",
                                *value, LEAST, MOST);
      if (c != VALUE && !(*value >= 0.0 && *value <= most[c]))
        return um_core_csv_fail(context, t->csv, r, t->column[c], "%g; accepted: 0 to %g [deg]",
                                *value, most[c]);
    }
  return UM_OK;
}

/* How many rows, or blocks of `step` rows, begin with the first value of a column. */
static size_t run(const struct table *t, size_t step, size_t same)
{
  size_t n = 0;
  while (n * step < t->nrow && at(t, n * step, same) == at(t, 0, same)) n++;
  return n;
}

/* The grid by its first rows, and every row held to it. */
static enum um_status check_grid(struct um_context *context, struct table *t)
{
  for (size_t c = 0; c < 3; c++)
    if (!(at(t, 0, c) == 0.0))
      return um_core_csv_fail(context, t->csv, 0, t->column[c],
                              "begins at %g; accepted: angles from 0 [deg]", at(t, 0, c));
  size_t azimuths = run(t, 1, SCATTERING), first = run(t, 1, INCIDENCE), pairs;
  if (first < azimuths) azimuths = first;
  pairs = run(t, azimuths, INCIDENCE);
  t->count[AZIMUTH] = azimuths;
  t->count[SCATTERING] = pairs;
  t->count[INCIDENCE] = (t->nrow + azimuths * pairs - 1) / (azimuths * pairs);
  const size_t step[3] = {azimuths * pairs, azimuths, 1};
  for (size_t r = 0; r < t->nrow; r++)
    for (size_t c = 0; c < 3; c++) {
      size_t place = r / step[c] % t->count[c];
      double expected = at(t, place * step[c], c);
      if (r == place * step[c] && place > 0 && !(expected > at(t, (place - 1) * step[c], c)))
        return um_core_csv_fail(context, t->csv, r, t->column[c],
                                "%g follows %g; accepted: ascending angles [deg], each pair of "
                                "polar angles with all azimuths",
                                expected, at(t, (place - 1) * step[c], c));
      if (!(fabs(at(t, r, c) - expected) <= SAME))
        return um_core_csv_fail(context, t->csv, r, t->column[c],
                                "%g where %g is expected; accepted: a whole grid, ascending by "
                                "incidence, scattering, azimuth, without gaps [deg]",
                                at(t, r, c), expected);
    }
  if (t->nrow % step[INCIDENCE] != 0)
    return um_core_csv_fail(context, t->csv, t->nrow - 1, t->column[INCIDENCE],
                            "the table ends within the incidence of %g deg; accepted: a whole grid",
                            at(t, t->nrow - 1, INCIDENCE));
  return UM_OK;
}

/* Place of an angle among those of reflection; their count where it is none. */
static size_t place_of(const struct table *t, double angle)
{
  size_t n = t->count[SCATTERING], k = 0;
  while (k < n && fabs(at(t, k * t->count[AZIMUTH], SCATTERING) - angle) > SAME) k++;
  return k;
}

static enum um_status check_angles(struct um_context *context, const struct table *t)
{
  size_t n = t->count[SCATTERING], na = t->count[AZIMUTH], block = n * na;
  const char *name = um_core_csv_name(t->csv);
  if (n < 4 || na < 3)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: %zu polar angles and %zu azimuths; accepted: 4 and 3 or more, the "
                        "whole hemisphere",
                        name, n, na);
  double reach = at(t, (n - 1) * na, SCATTERING), turn = at(t, na - 1, AZIMUTH);
  if (!(reach >= UM_MATERIALS_MEASURED_REACH))
    return um_core_csv_fail(context, t->csv, (n - 1) * na, t->column[SCATTERING],
                            "the last is %g; accepted: a hemisphere measured to %g deg or more",
                            reach, UM_MATERIALS_MEASURED_REACH);
  if (!(turn >= 180.0))
    return um_core_csv_fail(context, t->csv, na - 1, t->column[AZIMUTH],
                            "the last is %g; accepted: from 0 to 180, or around to 360 [deg]",
                            turn);
  double from = at(t, t->nrow - 1, INCIDENCE);
  if (t->count[INCIDENCE] < 4 || !(from >= UM_MATERIALS_MEASURED_FROM))
    return um_core_csv_fail(context, t->csv, t->nrow - 1, t->column[INCIDENCE],
                            "%zu incidences to %g; accepted: 4 or more, to %g deg or more",
                            t->count[INCIDENCE], from, UM_MATERIALS_MEASURED_FROM);
  for (size_t k = 0; k < t->count[INCIDENCE]; k++)
    if (place_of(t, at(t, k * block, INCIDENCE)) == n)
      return um_core_csv_fail(
          context, t->csv, k * block, t->column[INCIDENCE],
          "%g is no angle of reflection; accepted: incidences that are, so that "
          "both ways round were measured [deg]",
          at(t, k * block, INCIDENCE));
  return UM_OK;
}

/* Place of the azimuth that lies on the other side; the count where there is none. */
static size_t mirrored(const struct table *t, size_t k)
{
  double other = 360.0 - at(t, k, AZIMUTH);
  for (size_t j = 0; j < t->count[AZIMUTH]; j++)
    if (fabs(at(t, j, AZIMUTH) - other) <= SAME) return j;
  return at(t, k, AZIMUTH) == 0.0 ? 0 : t->count[AZIMUTH];
}

/* Azimuths to 180 deg; where both sides were measured each must be there twice. */
static enum um_status fold(struct um_context *context, const struct table *t,
                           struct um_materials_measured_grid *out)
{
  size_t n = t->count[SCATTERING], na = t->count[AZIMUTH], half = 0;
  bool both = at(t, na - 1, AZIMUTH) > 180.0 + SAME;
  while (half < na && at(t, half, AZIMUTH) <= 180.0 + SAME) half++;
  for (size_t k = 0; k < na && both; k++)
    if (mirrored(t, k) == na)
      return um_core_csv_fail(context, t->csv, k, t->column[AZIMUTH],
                              "%g has no %g on the other side; accepted: the same azimuths on both",
                              at(t, k, AZIMUTH), 360.0 - at(t, k, AZIMUTH));
  if (!(fabs(at(t, half - 1, AZIMUTH) - 180.0) <= SAME))
    return um_core_csv_fail(context, t->csv, half - 1, t->column[AZIMUTH],
                            "%g is the last to 180; accepted: azimuths with 180 [deg]",
                            at(t, half - 1, AZIMUTH));
  out->npolar = n;
  out->nazimuth = half;
  UM_TRY(um_core_allocate(context, n, sizeof *out->polar, &out->polar));
  UM_TRY(um_core_allocate(context, half, sizeof *out->azimuth, &out->azimuth));
  UM_TRY(um_core_allocate(context, n, sizeof *out->known, &out->known));
  UM_TRY(um_core_allocate(context, n * n * half, sizeof *out->f, &out->f));
  for (size_t a = 0; a < n; a++) out->polar[a] = at(t, a * na, SCATTERING) * UM_DEG;
  for (size_t k = 0; k < half; k++) out->azimuth[k] = at(t, k, AZIMUTH) * UM_DEG;
  out->azimuth[half - 1] = UM_PI;
  double squares = 0.0;
  for (size_t p = 0; p < t->count[INCIDENCE] * n; p++) {
    size_t from = place_of(t, at(t, p * na, INCIDENCE));
    out->known[from] = true;
    for (size_t k = 0; k < half; k++) {
      double right = at(t, p * na + k, VALUE);
      double left = both ? at(t, p * na + mirrored(t, k), VALUE) : right;
      out->f[(from * n + p % n) * half + k] = 0.5 * (right + left);
      squares += log(right / left) * log(right / left);
    }
  }
  out->sides = sqrt(squares / (double)(t->count[INCIDENCE] * n * half));
  return UM_OK;
}

enum um_status um_materials_measured_read(struct um_context *context, const char *path,
                                          struct um_materials_measured_grid *out)
{
  static const char *const names[COLUMNS] = {"incidence_deg", "scattering_deg", "azimuth_deg",
                                             "brdf_1_sr"};
  enum um_status status = UM_OK;
  struct table t = {0};
  *out = (struct um_materials_measured_grid){0};
  UM_CHECK(um_core_csv_read(context, path, &t.csv));
  for (size_t c = 0; c < COLUMNS; c++)
    UM_CHECK(um_core_csv_require(context, t.csv, names[c], &t.column[c]));
  UM_CHECK(read_rows(context, &t));
  UM_CHECK(check_grid(context, &t));
  UM_CHECK(check_angles(context, &t));
  UM_CHECK(fold(context, &t, out));
done:
  um_core_free(context, t.row);
  um_core_csv_destroy(&t.csv);
  if (status != UM_OK) um_materials_measured_grid_free(context, out);
  return status;
}

void um_materials_measured_grid_free(struct um_context *context,
                                     struct um_materials_measured_grid *grid)
{
  UM_FREE(context, grid->polar, grid->azimuth, grid->f, grid->known);
  *grid = (struct um_materials_measured_grid){0};
}
