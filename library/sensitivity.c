/* The matrix of sensitivities as a result, and what it says of other values. */
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "evidence/sensitivity/own.h"
#include "evidence/sensitivity/report/write.h"
#include "library/measurements_impl.h"
#include "library/run_impl.h"
#include "library/scenario_impl.h"
#include "library/source_impl.h"
#include "model/build/build.h"
#include "orbit/time.h"

struct sensitivity {
  struct um_library_source source;
  struct um_model_options options;
  struct umbra_measurements *measurements; /* shared; NULL: the scenario's own set */
  struct um_compare_measurements *own;
  struct um_sensitivity_forward *forward;
  struct um_sensitivity_matrix *matrix;
  struct umbra_sensitivity said;
  struct umbra_derivative *derivative; /* [nderivative] */
  size_t *row;                         /* [nderivative] of the matrix */
  const char **name;                   /* [ncurve] */
};

static void sensitivity_release(struct um_context *context, void *work)
{
  struct sensitivity *s = work;
  um_sensitivity_matrix_destroy(context, &s->matrix);
  um_sensitivity_forward_destroy(context, &s->forward);
  um_compare_measurements_destroy(context, &s->own);
  um_library_measurements_drop(&s->measurements);
  um_library_source_release(context, &s->source);
  UM_FREE(context, s->derivative, s->row, (void *)s->name, s);
}

static enum um_status sensitivity_write(struct um_context *context,
                                        const struct umbra_result *result,
                                        const struct umbra_write *write,
                                        struct um_core_folder *folder)
{
  const struct sensitivity *s = result->work;
  const struct um_sensitivity_report report = {
      .matrix = s->matrix, .command = write->command, .version = UM_LIBRARY_VERSION};
  return um_sensitivity_report_write(context, &report, write->pictures != 0, folder);
}

static const struct um_model *sensitivity_model(const void *work)
{
  return ((const struct sensitivity *)work)->forward->model;
}

static const struct um_library_kind kind = {sensitivity_write, sensitivity_release,
                                            sensitivity_model};

/* --- the matrix ------------------------------------------------------------------------------- */

static enum um_status make_own(struct um_context *context, struct sensitivity *s)
{
  struct um_model *model;
  UM_TRY(um_model_create(context, s->source.path, &s->options, &model));
  enum um_status status = um_sensitivity_own_create(context, model, &s->own);
  um_model_destroy(context, &model);
  return status;
}

static enum um_status compute(struct umbra *umbra, const struct umbra_scenario *scenario,
                              struct umbra_measurements *measurements,
                              const struct umbra_sensitivity_settings *asked, struct sensitivity *s)
{
  struct um_context *context = umbra->context;
  const struct um_sensitivity_candidates_options which = {.only = asked->only,
                                                          .nonly = asked->nonly,
                                                          .exclude = asked->exclude,
                                                          .nexclude = asked->nexclude};
  UM_TRY(um_library_source_copy(context, &scenario->source, &s->source));
  s->options = um_library_source_options(&s->source, umbra);
  if (measurements != NULL)
    s->measurements = um_library_measurements_share(measurements);
  else
    UM_TRY(make_own(context, s));
  UM_TRY(um_sensitivity_forward_create(context, s->source.path, &s->options,
                                       measurements != NULL ? measurements->set : s->own,
                                       UM_SENSITIVITY_MATRIX_TOLERANCE, &s->forward));
  return um_sensitivity_matrix_create(context, s->forward, measurements == NULL, &which,
                                      &s->matrix);
}

static struct umbra_derivative derivative_of(const struct um_sensitivity_row *r)
{
  const struct um_effect *effect = r->candidate->effect;
  bool is_switch = r->parameter == SIZE_MAX;
  return (struct umbra_derivative){.name = r->name,
                                   .effect = effect->name,
                                   .target = r->candidate->target,
                                   .parameter =
                                       is_switch ? NULL : effect->parameters[r->parameter].name,
                                   .unit = r->unit,
                                   .null_value = r->null_value,
                                   .minimum = r->minimum,
                                   .maximum = r->maximum,
                                   .width = r->width,
                                   .method = um_sensitivity_way_name(r->quality.way),
                                   .step = r->quality.step,
                                   .error = r->quality.error,
                                   .reach = r->quality.reach,
                                   .not_smooth = r->why};
}

/* Rows that have a column. */
static enum um_status say(struct um_context *context, struct sensitivity *s)
{
  const struct um_sensitivity_matrix *m = s->matrix;
  size_t n = 0;
  UM_TRY(um_core_allocate(context, m->nrow, sizeof *s->derivative, &s->derivative));
  UM_TRY(um_core_allocate(context, m->nrow, sizeof *s->row, &s->row));
  UM_TRY(um_core_allocate(context, m->ncurve, sizeof *s->name, &s->name));
  for (size_t i = 0; i < m->nrow; i++) {
    if (m->row[i].column == NULL) continue;
    s->derivative[n] = derivative_of(&m->row[i]);
    s->row[n++] = i;
  }
  for (size_t c = 0; c < m->ncurve; c++) s->name[c] = m->curve[c].name;
  s->said = (struct umbra_sensitivity){.derivative = s->derivative,
                                       .nderivative = n,
                                       .band = s->name,
                                       .place = s->name + m->nlight,
                                       .nband = m->nlight,
                                       .nplace = m->ncurve - m->nlight};
  return UM_OK;
}

/* --- arrays ----------------------------------------------------------------------------------- */

/* Of values [ncurve][ntime] the light and the temperatures, each where there is some. */
static enum um_status show_curves(struct um_context *context, const struct um_sensitivity_matrix *m,
                                  const double *value, struct umbra_result *result)
{
  static const char *const name[2] = {"light", "temperature"};
  for (int heat = 0; heat < 2; heat++) {
    size_t first = heat ? m->nlight : 0, n = heat ? m->ncurve - m->nlight : m->nlight;
    double *data;
    if (n == 0) continue;
    const struct umbra_array array = {.shape = {n, m->ntime},
                                      .axis = {heat ? "place" : "band", "time"}};
    UM_TRY(um_library_result_make(context, result, array, name[heat], heat ? "K" : m->curve[0].unit,
                                  &data));
    memcpy(data, value + first * m->ntime, n * m->ntime * sizeof *data);
  }
  return UM_OK;
}

static enum um_status show_derivatives(struct um_context *context, const struct sensitivity *s,
                                       struct umbra_result *result)
{
  static const char *const name[2] = {"d_light", "d_temperature"};
  const struct um_sensitivity_matrix *m = s->matrix;
  size_t rows = s->said.nderivative;
  for (int heat = 0; heat < 2; heat++) {
    size_t first = heat ? m->nlight : 0, n = heat ? m->ncurve - m->nlight : m->nlight;
    double *data;
    if (n == 0) continue;
    const struct umbra_array array = {.shape = {rows, n, m->ntime},
                                      .axis = {"parameter", heat ? "place" : "band", "time"}};
    UM_TRY(um_library_result_make(context, result, array, name[heat], "per unit of the parameter",
                                  &data));
    for (size_t i = 0; i < rows; i++)
      memcpy(data + i * n * m->ntime, m->row[s->row[i]].column + first * m->ntime,
             n * m->ntime * sizeof *data);
  }
  return UM_OK;
}

static enum um_status show_times(struct um_context *context, const struct um_sensitivity_matrix *m,
                                 struct umbra_result *result)
{
  double *data;
  const struct umbra_array array = {.shape = {m->ntime}, .axis = {"time"}};
  UM_TRY(um_library_result_make(context, result, array, "time_unix_s", "s", &data));
  for (size_t k = 0; k < m->ntime; k++) data[k] = um_orbit_time_unix(m->time[k]);
  return UM_OK;
}

enum umbra_status umbra_sensitivity(struct umbra *umbra, const struct umbra_scenario *scenario,
                                    struct umbra_measurements *measurements,
                                    const struct umbra_sensitivity_settings *settings,
                                    struct umbra_result **out)
{
  struct um_context *context = um_library_begin(umbra);
  struct umbra_sensitivity_settings asked = UMBRA_SENSITIVITY_SETTINGS;
  struct sensitivity *s = NULL;
  struct umbra_result *result = NULL;
  enum um_status status;
  *out = NULL;
  if (settings != NULL) {
    UM_CHECK(um_library_check_size(context, "struct umbra_sensitivity_settings", settings->size,
                                   sizeof *settings));
    asked = *settings;
  }
  UM_CHECK(um_core_allocate(context, 1, sizeof *s, &s));
  UM_CHECK(compute(umbra, scenario, measurements, &asked, s));
  UM_CHECK(say(context, s));
  UM_CHECK(um_library_result_create(context, umbra, &kind, s, &result));
  const struct sensitivity *kept = s;
  s = NULL;
  UM_CHECK(show_times(context, kept->matrix, result));
  UM_CHECK(show_curves(context, kept->matrix, kept->matrix->value, result));
  UM_CHECK(show_derivatives(context, kept, result));
  *out = result;
done:
  if (s != NULL) sensitivity_release(context, s);
  if (status != UM_OK) umbra_result_close(&result);
  return um_library_status(status);
}

const struct umbra_sensitivity *umbra_result_sensitivity(const struct umbra_result *result)
{
  return result->kind == &kind ? &((const struct sensitivity *)result->work)->said : NULL;
}

/* --- what if ---------------------------------------------------------------------------------- */

static void nothing_release(struct um_context *context, void *work) { (void)context, (void)work; }

static enum um_status nothing_write(struct um_context *context, const struct umbra_result *result,
                                    const struct umbra_write *write, struct um_core_folder *folder)
{
  (void)result, (void)write, (void)folder;
  return um_core_fail(context, UM_ERR_INPUT,
                      "what a matrix says of other values; accepted: the matrix itself");
}

static const struct um_model *nothing_model(const void *work)
{
  (void)work;
  return NULL;
}

static const struct um_library_kind kind_what_if = {nothing_write, nothing_release, nothing_model};

static enum um_status find_rows(struct um_context *context, const struct umbra_result *of,
                                const size_t *column, const double *value, size_t n, size_t *row)
{
  if (of->kind != &kind)
    return um_core_fail(context, UM_ERR_INPUT,
                        "another result; accepted: one of umbra_sensitivity");
  const struct sensitivity *s = of->work;
  for (size_t i = 0; i < n; i++) {
    if (column[i] >= s->said.nderivative)
      return um_core_fail(context, UM_ERR_INPUT, "column %zu; accepted: 0 to %zu", column[i],
                          s->said.nderivative - 1);
    const struct umbra_derivative *d = &s->derivative[column[i]];
    bool is_switch = d->parameter == NULL;
    double low = is_switch ? 0.0 : d->minimum, high = is_switch ? 1.0 : d->maximum;
    if (!(value[i] >= low && value[i] <= high))
      return um_core_fail(context, UM_ERR_INPUT, "%s %g; accepted: %g to %g %s", d->name, value[i],
                          low, high, d->unit);
    row[i] = s->row[column[i]];
  }
  return UM_OK;
}

enum umbra_status umbra_what_if(struct umbra *umbra, const struct umbra_result *sensitivity,
                                const size_t *column, const double *value, size_t n,
                                struct umbra_result **out)
{
  struct um_context *context = um_library_begin(umbra);
  struct umbra_result *result = NULL;
  size_t *row = NULL;
  double *curves = NULL;
  enum um_status status;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, n, sizeof *row, &row));
  UM_CHECK(find_rows(context, sensitivity, column, value, n, row));
  const struct um_sensitivity_matrix *m = ((const struct sensitivity *)sensitivity->work)->matrix;
  UM_CHECK(um_core_allocate(context, m->ncurve * m->ntime, sizeof *curves, &curves));
  um_sensitivity_matrix_apply(m, row, value, n, curves);
  UM_CHECK(um_library_result_create(context, umbra, &kind_what_if, NULL, &result));
  UM_CHECK(show_curves(context, m, curves, result));
  *out = result;
done:
  UM_FREE(context, row, curves);
  if (status != UM_OK) umbra_result_close(&result);
  return um_library_status(status);
}
