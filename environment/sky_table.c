/* Transmission and radiance of air from a file. */
#include "environment/sky_table.h"

#include <math.h>
#include <stddef.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "base/core/interpolation.h"
#include "environment/airmass.h"

#define LEAST 1e-12 /* transmission of which a logarithm is still taken [1] */

struct um_environment_sky_table {
  size_t nangle, n;
  double *airmass;      /* [nangle] ascending [1] */
  double *wavelength;   /* [n] ascending [m] */
  double *transmission; /* [nangle][n] [1] */
  double *radiance;     /* [nangle][n] [W/m^2/sr/m]; 0 where it is not known */
};

void um_environment_sky_table_destroy(struct um_context *context,
                                      struct um_environment_sky_table **table)
{
  if (table == NULL || *table == NULL) return;
  UM_FREE(context, (*table)->airmass, (*table)->wavelength, (*table)->transmission,
          (*table)->radiance, *table);
  *table = NULL;
}

/* --- reading --------------------------------------------------------------------------------- */

struct reader {
  struct um_context *context;
  const struct um_core_csv *csv;
  size_t zenith, wavelength, transmission, radiance; /* columns; the last may be missing */
  struct um_environment_sky_table *to;
  double angle; /* of the rows before [deg] */
};

/* A number between two bounds. */
static enum um_status number(const struct reader *r, size_t row, size_t column, double low,
                             double high, double *out)
{
  UM_TRY(um_core_csv_number(r->context, r->csv, row, column, out));
  if (*out >= low && *out <= high) return UM_OK;
  return um_core_csv_fail(r->context, r->csv, row, column, "%g; accepted: %g to %g", *out, low,
                          high);
}

static enum um_status read_row(struct reader *r, size_t row)
{
  struct um_environment_sky_table *t = r->to;
  size_t at = row % t->n, angle = row / t->n;
  double zenith, wavelength, value;
  UM_TRY(number(r, row, r->zenith, 0.0, 89.0, &zenith));
  UM_TRY(number(r, row, r->wavelength, 0.1, 100.0, &wavelength));
  if (at == 0 && angle > 0 && !(zenith > r->angle))
    return um_core_csv_fail(r->context, r->csv, row, r->zenith,
                            "%g follows %g; accepted: ascending angles", zenith, r->angle);
  if (at > 0 && zenith != r->angle)
    return um_core_csv_fail(r->context, r->csv, row, r->zenith,
                            "%g deg after %zu wavelengths; accepted: %zu at every angle", zenith,
                            at, t->n);
  if (at == 0) t->airmass[angle] = um_environment_airmass((90.0 - zenith) * UM_DEG);
  r->angle = zenith;
  if (angle == 0 && at > 0 && !(wavelength * 1e-6 > t->wavelength[at - 1]))
    return um_core_csv_fail(r->context, r->csv, row, r->wavelength,
                            "%g follows %g; accepted: ascending values", wavelength,
                            t->wavelength[at - 1] * 1e6);
  if (angle == 0) t->wavelength[at] = wavelength * 1e-6;
  if (!(fabs(wavelength * 1e-6 - t->wavelength[at]) <= 1e-9 * t->wavelength[at]))
    return um_core_csv_fail(r->context, r->csv, row, r->wavelength,
                            "%g where the first angle has %g; accepted: the same wavelengths",
                            wavelength, t->wavelength[at] * 1e6);
  UM_TRY(number(r, row, r->transmission, 0.0, 1.0, &t->transmission[row]));
  if (r->radiance == (size_t)-1) return UM_OK;
  UM_TRY(number(r, row, r->radiance, 0.0, 1e6, &value));
  t->radiance[row] = value * 1e6; /* per um to per m */
  return UM_OK;
}

/* Wavelengths of the first angle: rows until another one begins. */
static enum um_status count(struct reader *r)
{
  double first, angle;
  size_t rows = um_core_csv_rows(r->csv), n = 0;
  if (rows < 2)
    return um_core_fail(r->context, UM_ERR_INPUT, "%s: %zu rows; accepted: 2 or more",
                        um_core_csv_name(r->csv), rows);
  UM_TRY(um_core_csv_number(r->context, r->csv, 0, r->zenith, &first));
  for (angle = first; n < rows; n++) {
    UM_TRY(um_core_csv_number(r->context, r->csv, n, r->zenith, &angle));
    if (angle != first) break;
  }
  if (n >= 2 && rows % n == 0) {
    r->to->n = n;
    r->to->nangle = rows / n;
    return UM_OK;
  }
  return um_core_fail(r->context, UM_ERR_INPUT,
                      "%s: %zu rows, %zu of them at the first angle; accepted: as many at every "
                      "angle, 2 or more",
                      um_core_csv_name(r->csv), rows, n);
}

static enum um_status fill(struct reader *r)
{
  struct um_environment_sky_table *t = r->to;
  UM_TRY(um_core_csv_require(r->context, r->csv, "zenith_deg", &r->zenith));
  UM_TRY(um_core_csv_require(r->context, r->csv, "wavelength_um", &r->wavelength));
  UM_TRY(um_core_csv_require(r->context, r->csv, "transmission", &r->transmission));
  r->radiance = um_core_csv_find(r->csv, "radiance_W_m2_sr_um");
  UM_TRY(count(r));
  size_t rows = um_core_csv_rows(r->csv);
  UM_TRY(um_core_allocate(r->context, t->nangle, sizeof *t->airmass, &t->airmass));
  UM_TRY(um_core_allocate(r->context, t->n, sizeof *t->wavelength, &t->wavelength));
  UM_TRY(um_core_allocate(r->context, rows, sizeof *t->transmission, &t->transmission));
  UM_TRY(um_core_allocate(r->context, rows, sizeof *t->radiance, &t->radiance));
  for (size_t row = 0; row < rows; row++) UM_TRY(read_row(r, row));
  return UM_OK;
}

enum um_status um_environment_sky_table_read(struct um_context *context, const char *path,
                                             struct um_environment_sky_table **out)
{
  enum um_status status;
  struct um_core_csv *csv = NULL;
  struct reader r = {.context = context, .angle = NAN};
  *out = NULL;
  UM_CHECK(um_core_csv_read(context, path, &csv));
  UM_CHECK(um_core_allocate(context, 1, sizeof *r.to, &r.to));
  r.csv = csv;
  UM_CHECK(fill(&r));
  *out = r.to;
  r.to = NULL;
done:
  um_environment_sky_table_destroy(context, &r.to);
  um_core_csv_destroy(&csv);
  return status;
}

/* --- values ---------------------------------------------------------------------------------- */

bool um_environment_sky_table_covers(const struct um_environment_sky_table *table, double from,
                                     double to)
{
  return from >= table->wavelength[0] * (1.0 - 1e-9) &&
         to <= table->wavelength[table->n - 1] * (1.0 + 1e-9);
}

/* Angles about an airmass and the place between them; beyond the table's its outermost one. */
static size_t place(const struct um_environment_sky_table *t, double airmass, double *fraction)
{
  *fraction = 0.0;
  if (t->nangle == 1 || airmass <= t->airmass[0]) return 0;
  if (airmass >= t->airmass[t->nangle - 1]) return t->nangle - 1;
  size_t i = um_core_interval_find(t->airmass, t->nangle, airmass);
  *fraction = (airmass - t->airmass[i]) / (t->airmass[i + 1] - t->airmass[i]);
  return i;
}

static double mean(const struct um_environment_sky_table *t, const double *row, double from,
                   double to)
{
  return um_core_integrate_linear(t->wavelength, row, t->n, from, to) / (to - from);
}

static double depth(const struct um_environment_sky_table *t, size_t angle, double from, double to)
{
  return -log(fmax(mean(t, t->transmission + angle * t->n, from, to), LEAST));
}

double um_environment_sky_table_transmission(const struct um_environment_sky_table *table,
                                             double from, double to, double airmass)
{
  double f;
  size_t i = place(table, airmass, &f);
  if (f > 0.0)
    return exp(-(1.0 - f) * depth(table, i, from, to) - f * depth(table, i + 1, from, to));
  return exp(-depth(table, i, from, to) * airmass / table->airmass[i]);
}

double um_environment_sky_table_radiance(const struct um_environment_sky_table *table, double from,
                                         double to, double airmass)
{
  double f;
  size_t i = place(table, airmass, &f);
  double low = mean(table, table->radiance + i * table->n, from, to);
  if (f > 0.0)
    return (1.0 - f) * low + f * mean(table, table->radiance + (i + 1) * table->n, from, to);
  return low * airmass / table->airmass[i];
}
