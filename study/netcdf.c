/* study.nc: points, parameters and curves of a study. */
#include <stdio.h>
#include <string.h>

#include "output/netcdf_grid.h"
#include "study/shortfall.h"
#include "study/study.h"

enum axis { POINT, PARAMETER, TIME, BAND, PLACE, METRIC, AXES };

struct writer {
  struct um_context *context;
  const struct um_study_result *r;
  struct um_output_grid grid;
  size_t nband, nplace, nmetric;
  const char **band, **place, **metric; /* [nband], [nplace], [nmetric] borrowed */
};

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
  for (int a = 0; a < AXES; a++) UM_TRY(um_output_grid_axis(&w->grid, a, name[a], length[a]));
  return UM_OK;
}

static enum um_status put_axes(const struct writer *w)
{
  const struct um_study_result *r = w->r;
  enum um_status status;
  int *number = NULL;
  const char **name = NULL;
  UM_CHECK(um_core_allocate(w->context, r->npoint, sizeof *number, &number));
  UM_CHECK(um_core_allocate(w->context, r->nparameter, sizeof *name, &name));
  for (size_t i = 0; i < r->npoint; i++) number[i] = (int)i;
  UM_CHECK(um_output_grid_counts(&w->grid, "point", POINT, "number of the point, from 0", number));
  for (size_t j = 0; j < r->nparameter; j++) name[j] = r->parameter_name[j];
  UM_CHECK(um_output_grid_texts(&w->grid, "parameter", PARAMETER, "what is moved", name));
  for (size_t j = 0; j < r->nparameter; j++) name[j] = r->parameter_unit[j];
  UM_CHECK(
      um_output_grid_texts(&w->grid, "parameter_unit", PARAMETER, "unit of the parameter", name));
  if (w->nband > 0)
    UM_CHECK(um_output_grid_texts(&w->grid, "band", BAND, "spectral band", w->band));
  if (w->nplace > 0)
    UM_CHECK(um_output_grid_texts(&w->grid, "place", PLACE, "place of the satellite", w->place));
  if (w->nmetric > 0)
    UM_CHECK(um_output_grid_texts(&w->grid, "metric", METRIC, "what is held against", w->metric));
  UM_CHECK(um_output_grid_times(&w->grid, TIME, r->time, r->ntime));
done:
  UM_FREE(w->context, number, (void *)name);
  return status;
}

/* --- points and curves ----------------------------------------------------------------------- */

static enum um_status put_points(const struct writer *w)
{
  static const int each[] = {POINT, PARAMETER};
  const struct um_study_result *r = w->r;
  const int point = POINT, parameter = PARAMETER;
  UM_TRY(um_output_grid_numbers(&w->grid, "parameter_value", each, 2, NULL,
                                "value of the parameter at the point", r->parameter));
  UM_TRY(um_output_grid_numbers(&w->grid, "coordinate", each, 2, "1",
                                "share of the parameter's values below it", r->coordinate));
  UM_TRY(um_output_grid_numbers(&w->grid, "parameter_nominal", &parameter, 1, NULL,
                                "value in the scenario as it stands; NaN: not known",
                                r->at_nominal));
  const char **reason = NULL;
  UM_TRY(um_core_allocate(w->context, r->npoint, sizeof *reason, &reason));
  for (size_t i = 0; i < r->npoint; i++) reason[i] = r->reason[i] != NULL ? r->reason[i] : "";
  enum um_status status = um_output_grid_texts(
      &w->grid, "reason", point, "why the point could not be computed; empty: it could", reason);
  um_core_free(w->context, (void *)reason);
  return status;
}

/* All curves of one kind over (point, time, axis), those of the scenario as it stands over (time,
 * axis), and their error over (axis). */
static enum um_status put_curves(const struct writer *w, const char *kind, int axis, size_t n,
                                 const char *units, const char *error_units)
{
  const int all[] = {POINT, TIME, axis}, nominal[] = {TIME, axis};
  const struct um_study_result *r = w->r;
  size_t rows = r->npoint + 1, column = 0; /* the last of them nominal */
  double *value = NULL, *error = NULL, *asked;
  char name[64], words[128];
  enum um_status status;
  UM_CHECK(um_core_allocate(w->context, rows * r->ntime * n, sizeof *value, &value));
  UM_CHECK(um_core_allocate(w->context, n, 2 * sizeof *error, &error));
  asked = error + n;
  for (size_t q = 0; q < r->nquantity; q++) {
    if (!is_kind(&r->quantity[q], kind)) continue;
    for (size_t i = 0; i < rows; i++) {
      const double *from =
          (i < r->npoint ? r->value + i * r->nvalue : r->nominal) + r->quantity[q].first;
      for (size_t k = 0; k < r->ntime; k++) value[(i * r->ntime + k) * n + column] = from[k];
    }
    asked[column] = r->quantity[q].asked > 0.0 ? r->quantity[q].asked : (double)NAN;
    error[column++] = r->error[q];
  }
  if (column == 0) goto done;
  snprintf(words, sizeof words, "%s of a point", kind);
  UM_CHECK(um_output_grid_numbers(&w->grid, kind, all, 3, units, words, value));
  snprintf(name, sizeof name, "%s_nominal", kind);
  snprintf(words, sizeof words, "%s of the scenario as it stands", kind);
  UM_CHECK(um_output_grid_numbers(&w->grid, name, nominal, 2, units, words,
                                  value + r->npoint * r->ntime * n));
  snprintf(name, sizeof name, "%s_error", kind);
  snprintf(words, sizeof words, "stated largest error of %s", kind);
  UM_CHECK(um_output_grid_numbers(&w->grid, name, &axis, 1, error_units, words, error));
  snprintf(name, sizeof name, "%s_error_asked", kind);
  snprintf(words, sizeof words, "error of %s that was asked; NaN: none", kind);
  UM_CHECK(um_output_grid_numbers(&w->grid, name, &axis, 1, error_units, words, asked));
done:
  UM_FREE(w->context, value, error);
  return status;
}

/* Over (point, metric); chi-square [1], rms in the unit of its curve. */
static enum um_status put_metrics(const struct writer *w)
{
  const int all[] = {POINT, METRIC};
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
  enum um_status status = um_output_grid_numbers(
      &w->grid, "against_measurements", all, 2, NULL,
      "a point against measurements: rms in the unit of its curve, reduced chi-square", value);
  um_core_free(w->context, value);
  return status;
}

/* In what the file falls short, as a note on it. */
static enum um_status put_shortfall(const struct writer *w)
{
  char *text = NULL;
  UM_TRY(um_study_shortfall(w->context, w->r, &text));
  enum um_status status = text != NULL ? um_output_grid_note(&w->grid, "falls_short", text) : UM_OK;
  um_core_free(w->context, text);
  return status;
}

static enum um_status put_all(struct writer *w)
{
  const struct um_study_result *r = w->r;
  UM_TRY(find_axes(w));
  UM_TRY(um_output_grid_note(&w->grid, "title", r->name));
  UM_TRY(um_output_grid_note(&w->grid, "scenario", r->scenario));
  UM_TRY(um_output_grid_note(&w->grid, "Conventions", "CF-1.8"));
  UM_TRY(um_output_grid_note(&w->grid, "mode", r->surrogate != NULL ? "surrogate" : "exact"));
  UM_TRY(put_shortfall(w));
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
  UM_TRY(um_output_grid_begin(context, "study.nc", &w.grid));
  enum um_status status = um_output_grid_end(&w.grid, put_all(&w), file);
  UM_FREE(context, (void *)w.band, (void *)w.place, (void *)w.metric);
  return status;
}
