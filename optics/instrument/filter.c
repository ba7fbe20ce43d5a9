/* Transmission curves from files. */
#include "optics/instrument/filter.h"

#include <math.h>
#include <string.h>

#include "base/core/csv.h"
#include "base/core/data.h"
#include "base/core/interpolation.h"

#define SHORTEST 0.1e-6 /* [m] */
#define LONGEST  100e-6 /* [m] */
#define LEAST    1e-12  /* of the largest transmission, below which no light passes [1] */
#define TAIL     ".csv"

void um_instrument_filter_destroy(struct um_context *context, struct um_instrument_filter **filter)
{
  if (filter == NULL || *filter == NULL) return;
  UM_FREE(context, (*filter)->wavelength, (*filter)->transmission, *filter);
  *filter = NULL;
}

/* Column of the wavelength and its unit [m]. */
static enum um_status wavelength_column(struct um_context *context, const struct um_core_csv *csv,
                                        size_t *column, double *unit)
{
  size_t um = um_core_csv_find(csv, "wavelength_um"), nm = um_core_csv_find(csv, "wavelength_nm");
  if ((um == (size_t)-1) == (nm == (size_t)-1))
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: %s; accepted: one of the columns wavelength_um and wavelength_nm",
                        um_core_csv_name(csv),
                        um == (size_t)-1 ? "no column of wavelengths" : "wavelengths twice");
  *column = um != (size_t)-1 ? um : nm;
  *unit = um != (size_t)-1 ? 1e-6 : 1e-9;
  return UM_OK;
}

static enum um_status fill(struct um_context *context, const struct um_core_csv *csv,
                           struct um_instrument_filter *f)
{
  size_t x = 0, y = 0;
  double unit = 1.0, largest = 0.0;
  UM_TRY(wavelength_column(context, csv, &x, &unit));
  UM_TRY(um_core_csv_require(context, csv, "transmission", &y));
  f->n = um_core_csv_rows(csv);
  if (f->n < 2)
    return um_core_fail(context, UM_ERR_INPUT, "%s: %zu rows; accepted: 2 or more",
                        um_core_csv_name(csv), f->n);
  UM_TRY(um_core_allocate(context, f->n, sizeof *f->wavelength, &f->wavelength));
  UM_TRY(um_core_allocate(context, f->n, sizeof *f->transmission, &f->transmission));
  for (size_t i = 0; i < f->n; i++) {
    double value, l;
    UM_TRY(um_core_csv_number(context, csv, i, x, &value));
    l = value * unit;
    if (!(l >= SHORTEST && l <= LONGEST))
      return um_core_csv_fail(context, csv, i, x, "%g; accepted: %g to %g", value, SHORTEST / unit,
                              LONGEST / unit);
    if (i > 0 && !(l > f->wavelength[i - 1]))
      return um_core_csv_fail(context, csv, i, x, "%g follows %g; accepted: ascending values",
                              value, f->wavelength[i - 1] / unit);
    f->wavelength[i] = l;
    UM_TRY(um_core_csv_number(context, csv, i, y, &value));
    if (!(value >= 0.0 && value <= 1.0))
      return um_core_csv_fail(context, csv, i, y, "%g; accepted: 0 to 1, not in percent", value);
    f->transmission[i] = value;
    largest = fmax(largest, value);
  }
  if (largest >= LEAST) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s: column 'transmission': %g in every row, or less; accepted: a filter "
                      "through which light passes, %g or more in one row",
                      um_core_csv_name(csv), largest, LEAST);
}

enum um_status um_instrument_filter_read(struct um_context *context, const char *path,
                                         struct um_instrument_filter **out)
{
  enum um_status status;
  struct um_core_csv *csv = NULL;
  struct um_instrument_filter *f = NULL;
  *out = NULL;
  UM_CHECK(um_core_csv_read(context, path, &csv));
  UM_CHECK(um_core_allocate(context, 1, sizeof *f, &f));
  UM_CHECK(fill(context, csv, f));
  *out = f;
  f = NULL;
done:
  um_instrument_filter_destroy(context, &f);
  um_core_csv_destroy(&csv);
  return status;
}

enum um_status um_instrument_filter_names(struct um_context *context, char ***names, size_t *count)
{
  return um_core_data_names(context, "filters", TAIL, names, count);
}

enum um_status um_instrument_filter_find(struct um_context *context, const char *name,
                                         struct um_instrument_filter **out)
{
  char *path;
  *out = NULL;
  UM_TRY(um_core_data_find(context, "filter", "filters", TAIL, name, &path));
  enum um_status status = um_instrument_filter_read(context, path, out);
  um_core_free(context, path);
  return status;
}

double um_instrument_filter_mean(const struct um_instrument_filter *filter, double from, double to)
{
  return um_core_integrate_linear(filter->wavelength, filter->transmission, filter->n, from, to) /
         (to - from);
}

/* int_0^1 u / (1 + x u) du, without the difference that a narrow piece would lose. */
static double upper_share(double x)
{
  return x < 1e-3 ? 1.0 / 2.0 - x * (1.0 / 3.0 - x * (1.0 / 4.0 - x * (1.0 / 5.0 - x / 6.0)))
                  : (1.0 - log1p(x) / x) / x;
}

double um_instrument_filter_pivot(const struct um_instrument_filter *filter)
{
  double up = 0.0, down = 0.0;
  for (size_t i = 1; i < filter->n; i++) {
    double a = filter->wavelength[i - 1], b = filter->wavelength[i], w = b - a, x = w / a;
    double ta = filter->transmission[i - 1], tb = filter->transmission[i];
    double upper = x * upper_share(x);
    up += w * (ta * (2.0 * a + b) + tb * (a + 2.0 * b)) / 6.0;
    down += ta * (log1p(x) - upper) + tb * upper;
  }
  return sqrt(up / down);
}
