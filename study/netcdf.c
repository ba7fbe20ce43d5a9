/* study.nc: netCDF-4 with a coordinate variable for every dimension, as xarray and others want it;
 * made in memory, so that a full disk is an error of the stream. */
#include <netcdf.h>
#include <netcdf_mem.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/file.h"
#include "orbit/time.h"
#include "output/netcdf_text.h"
#include "study/study.h"

#define FIRST_SIZE 65536 /* of the image in memory, which grows [bytes] */

enum axis { POINT, PARAMETER, TIME, BAND, PLACE, METRIC, AXES };

struct writer {
  struct um_context *context;
  const struct um_study_result *r;
  int file, axis[AXES];
  size_t nband, nplace, nmetric;
  const char **band, **place, **metric; /* [nband], [nplace], [nmetric] borrowed */
};

static enum um_status check(const struct writer *w, int code)
{
  UM_TRY(um_core_stop_check(w->context, "study.nc was written"));
  if (code == NC_NOERR) return UM_OK;
  return um_core_fail(w->context, UM_ERR_IO, "study.nc: netCDF: %s", nc_strerror(code));
}

static enum um_status note(const struct writer *w, int id, const char *name, const char *text)
{
  return check(w, um_output_netcdf_text(w->file, id, name, text));
}

static enum um_status define(const struct writer *w, const char *name, nc_type type,
                             const enum axis *axes, int naxis, const char *units,
                             const char *long_name, int *id)
{
  int dimension[AXES];
  for (int i = 0; i < naxis; i++) dimension[i] = w->axis[axes[i]];
  UM_TRY(check(w, nc_def_var(w->file, name, type, naxis, dimension, id)));
  if (units != NULL) UM_TRY(note(w, *id, "units", units));
  UM_TRY(note(w, *id, "long_name", long_name));
  if (naxis > 1 && type != NC_STRING) UM_TRY(check(w, nc_def_var_deflate(w->file, *id, 1, 1, 4)));
  return UM_OK;
}

static enum um_status texts(const struct writer *w, const char *name, enum axis axis,
                            const char *long_name, const char **text)
{
  int id;
  UM_TRY(define(w, name, NC_STRING, &axis, 1, NULL, long_name, &id));
  return check(w, nc_put_var_string(w->file, id, text));
}

static enum um_status numbers(const struct writer *w, const char *name, const enum axis *axes,
                              int naxis, const char *units, const char *long_name,
                              const double *value)
{
  int id;
  UM_TRY(define(w, name, NC_DOUBLE, axes, naxis, units, long_name, &id));
  return check(w, nc_put_var_double(w->file, id, value));
}

/* --- axes ------------------------------------------------------------------------------------ */

static bool is_kind(const struct um_study_quantity *q, const char *kind)
{
  size_t n = strlen(kind);
  return strncmp(q->name, kind, n) == 0 && q->name[n] == ':';
}

/* Against measurements: one value a point. */
static bool is_metric(const struct um_study_quantity *q)
{
  return is_kind(q, "rms") || is_kind(q, "chi2_reduced");
}

static enum um_status find_axes(struct writer *w)
{
  const struct um_study_result *r = w->r;
  UM_TRY(um_core_allocate(w->context, r->nquantity, sizeof *w->band, &w->band));
  UM_TRY(um_core_allocate(w->context, r->nquantity, sizeof *w->place, &w->place));
  UM_TRY(um_core_allocate(w->context, r->nquantity, sizeof *w->metric, &w->metric));
  for (size_t q = 0; q < r->nquantity; q++) {
    if (is_metric(&r->quantity[q])) w->metric[w->nmetric++] = r->quantity[q].name;
    if (is_kind(&r->quantity[q], "irradiance")) w->band[w->nband++] = r->quantity[q].of;
    if (is_kind(&r->quantity[q], "temperature")) w->place[w->nplace++] = r->quantity[q].of;
  }
  static const char *const name[AXES] = {"point", "parameter", "time", "band", "place", "metric"};
  const size_t length[AXES] = {r->npoint, r->nparameter, r->ntime, w->nband, w->nplace, w->nmetric};
  for (int a = 0; a < AXES; a++)
    if (length[a] > 0) UM_TRY(check(w, nc_def_dim(w->file, name[a], length[a], &w->axis[a])));
  return UM_OK;
}

/* What a UTC clock shows, as in run.nc (output/netcdf_times.c). */
static enum um_status put_time(const struct writer *w)
{
  enum um_status status;
  const struct um_study_result *r = w->r;
  const enum axis axis = TIME;
  double *clock = NULL, day, mjd, seconds;
  char units[64], first[32];
  int id;
  UM_CHECK(um_core_allocate(w->context, r->ntime, sizeof *clock, &clock));
  um_orbit_time_utc_clock(r->time[0], &day, &seconds);
  um_orbit_time_format(um_orbit_time_from_utc_jd(2400000.5, day + 0.5), first);
  for (size_t k = 0; k < r->ntime; k++) {
    um_orbit_time_utc_clock(r->time[k], &mjd, &seconds);
    clock[k] = (mjd - day) * 86400.0 + seconds;
  }
  snprintf(units, sizeof units, "seconds since %.10s 00:00:00", first);
  UM_CHECK(define(w, "time", NC_DOUBLE, &axis, 1, units,
                  "UTC of mid-exposure at the observer, light received", &id));
  UM_CHECK(note(w, id, "standard_name", "time"));
  UM_CHECK(note(w, id, "calendar", "standard"));
  UM_CHECK(check(w, nc_put_var_double(w->file, id, clock)));
  UM_CHECK(numbers(w, "time_tai", &axis, 1, "s",
                   "TAI of mid-exposure since 2000-01-01T12:00:00 TAI", r->time));
done:
  um_core_free(w->context, clock);
  return status;
}

static enum um_status put_axes(const struct writer *w)
{
  const struct um_study_result *r = w->r;
  enum um_status status;
  enum axis axis = POINT;
  int id, *number = NULL;
  const char **name = NULL;
  UM_CHECK(um_core_allocate(w->context, r->npoint, sizeof *number, &number));
  UM_CHECK(um_core_allocate(w->context, r->nparameter, sizeof *name, &name));
  for (size_t i = 0; i < r->npoint; i++) number[i] = (int)i;
  UM_CHECK(define(w, "point", NC_INT, &axis, 1, NULL, "number of the point, from 0", &id));
  UM_CHECK(check(w, nc_put_var_int(w->file, id, number)));
  for (size_t j = 0; j < r->nparameter; j++) name[j] = r->parameter_name[j];
  UM_CHECK(texts(w, "parameter", PARAMETER, "what is moved", name));
  for (size_t j = 0; j < r->nparameter; j++) name[j] = r->parameter_unit[j];
  UM_CHECK(texts(w, "parameter_unit", PARAMETER, "unit of the parameter", name));
  if (w->nband > 0) UM_CHECK(texts(w, "band", BAND, "spectral band", w->band));
  if (w->nplace > 0) UM_CHECK(texts(w, "place", PLACE, "place of the satellite", w->place));
  if (w->nmetric > 0) UM_CHECK(texts(w, "metric", METRIC, "what is held against", w->metric));
  UM_CHECK(put_time(w));
done:
  UM_FREE(w->context, number, (void *)name);
  return status;
}

/* --- points and curves ----------------------------------------------------------------------- */

static enum um_status put_points(const struct writer *w)
{
  static const enum axis each[] = {POINT, PARAMETER};
  const struct um_study_result *r = w->r;
  const enum axis point = POINT, parameter = PARAMETER;
  UM_TRY(numbers(w, "parameter_value", each, 2, NULL, "value of the parameter at the point",
                 r->parameter));
  UM_TRY(numbers(w, "coordinate", each, 2, "1", "share of the parameter's values below it",
                 r->coordinate));
  UM_TRY(numbers(w, "parameter_nominal", &parameter, 1, NULL,
                 "value in the scenario as it stands; NaN: not known", r->at_nominal));
  const char **reason = NULL;
  UM_TRY(um_core_allocate(w->context, r->npoint, sizeof *reason, &reason));
  for (size_t i = 0; i < r->npoint; i++) reason[i] = r->reason[i] != NULL ? r->reason[i] : "";
  enum um_status status =
      texts(w, "reason", point, "why the point could not be computed; empty: it could", reason);
  um_core_free(w->context, (void *)reason);
  return status;
}

/* All curves of one kind over (point, time, axis), those of the scenario as it stands over (time,
 * axis), and their error over (axis). */
static enum um_status put_curves(const struct writer *w, const char *kind, enum axis axis, size_t n,
                                 const char *units, const char *error_units)
{
  const enum axis all[] = {POINT, TIME, axis}, nominal[] = {TIME, axis};
  const struct um_study_result *r = w->r;
  size_t rows = r->npoint + 1, column = 0; /* the last of them nominal */
  double *value = NULL, *error = NULL;
  char name[64], words[128];
  enum um_status status;
  UM_CHECK(um_core_allocate(w->context, rows * r->ntime * n, sizeof *value, &value));
  UM_CHECK(um_core_allocate(w->context, n, sizeof *error, &error));
  for (size_t q = 0; q < r->nquantity; q++) {
    if (!is_kind(&r->quantity[q], kind)) continue;
    for (size_t i = 0; i < rows; i++) {
      const double *from =
          (i < r->npoint ? r->value + i * r->nvalue : r->nominal) + r->quantity[q].first;
      for (size_t k = 0; k < r->ntime; k++) value[(i * r->ntime + k) * n + column] = from[k];
    }
    error[column++] = r->error[q];
  }
  if (column == 0) goto done;
  snprintf(words, sizeof words, "%s of a point", kind);
  UM_CHECK(numbers(w, kind, all, 3, units, words, value));
  snprintf(name, sizeof name, "%s_nominal", kind);
  snprintf(words, sizeof words, "%s of the scenario as it stands", kind);
  UM_CHECK(numbers(w, name, nominal, 2, units, words, value + r->npoint * r->ntime * n));
  snprintf(name, sizeof name, "%s_error", kind);
  snprintf(words, sizeof words, "stated largest error of %s", kind);
  UM_CHECK(numbers(w, name, &axis, 1, error_units, words, error));
done:
  UM_FREE(w->context, value, error);
  return status;
}

/* Over (point, metric); chi-square [1], rms in the unit of its curve. */
static enum um_status put_metrics(const struct writer *w)
{
  const enum axis all[] = {POINT, METRIC};
  const struct um_study_result *r = w->r;
  double *value = NULL;
  size_t column = 0;
  if (w->nmetric == 0) return UM_OK;
  UM_TRY(um_core_allocate(w->context, r->npoint * w->nmetric, sizeof *value, &value));
  for (size_t q = 0; q < r->nquantity; q++) {
    if (!is_metric(&r->quantity[q])) continue;
    for (size_t i = 0; i < r->npoint; i++)
      value[i * w->nmetric + column] = r->value[i * r->nvalue + r->quantity[q].first];
    column++;
  }
  enum um_status status = numbers(
      w, "against_measurements", all, 2, NULL,
      "a point against measurements: rms in the unit of its curve, reduced chi-square", value);
  um_core_free(w->context, value);
  return status;
}

static enum um_status put_all(struct writer *w)
{
  const struct um_study_result *r = w->r;
  UM_TRY(find_axes(w));
  UM_TRY(note(w, NC_GLOBAL, "title", r->name));
  UM_TRY(note(w, NC_GLOBAL, "scenario", r->scenario));
  UM_TRY(note(w, NC_GLOBAL, "Conventions", "CF-1.8"));
  UM_TRY(note(w, NC_GLOBAL, "mode", r->surrogate != NULL ? "surrogate" : "exact"));
  UM_TRY(put_axes(w));
  UM_TRY(put_points(w));
  UM_TRY(put_curves(w, "irradiance", BAND, w->nband, "W m-2", "1"));
  UM_TRY(put_curves(w, "magnitude", BAND, w->nband, NULL, NULL));
  UM_TRY(put_metrics(w));
  return put_curves(w, "temperature", PLACE, w->nplace, "K", "K");
}

enum um_status um_study_write_netcdf(struct um_context *context,
                                     const struct um_study_result *result, FILE *file)
{
  struct writer w = {.context = context, .r = result};
  NC_memio image = {0};
  UM_TRY(check(&w, nc_create_mem("study.nc", NC_NETCDF4, FIRST_SIZE, &w.file)));
  enum um_status status = put_all(&w);
  int code = nc_close_memio(w.file, &image);
  if (status == UM_OK) status = check(&w, code);
  if (status == UM_OK)
    status = um_core_file_write(context, "study.nc", image.memory, image.size, file);
  free(image.memory);
  UM_FREE(context, (void *)w.band, (void *)w.place, (void *)w.metric);
  return status;
}
