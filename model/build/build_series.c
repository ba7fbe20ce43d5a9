/* Numbers of a scenario by time, power or angle: a CSV of time_utc and a column. */
#include "model/build/steps_impl.h"

#include "base/core/csv.h"
#include "model/build/messages_group.h"
#include "orbit/time.h"

/* Rows in order; two at one time are a jump, more would hide one. */
static enum um_status times_check(struct um_context *context, const struct um_core_csv *csv,
                                  size_t column, const double *t, size_t row)
{
  if (row > 0 && !(t[row] >= t[row - 1]))
    return um_core_csv_fail(context, csv, row, column,
                            "%s is before the row above (%s); accepted: ascending, two rows at one "
                            "time are a jump",
                            um_core_csv_text(csv, row, column),
                            um_core_csv_text(csv, row - 1, column));
  if (row > 1 && t[row] == t[row - 2])
    return um_core_csv_fail(context, csv, row, column,
                            "%s stands there three times; accepted: twice, a jump",
                            um_core_csv_text(csv, row, column));
  return UM_OK;
}

static enum um_status rows_read(struct um_context *context, struct um_model *model,
                                const struct um_core_csv *csv,
                                const struct um_model_series_kind *kind,
                                struct um_model_series *out)
{
  size_t time, value, rows = um_core_csv_rows(csv);
  double *t, *v;
  UM_TRY(um_core_csv_require(context, csv, "time_utc", &time));
  UM_TRY(um_core_csv_require(context, csv, kind->column, &value));
  if (rows < 2)
    return um_core_fail(context, UM_ERR_INPUT, "%s: %zu row%s; accepted: 2 or more, %s",
                        um_core_csv_name(csv), rows, rows == 1 ? "" : "s", kind->outside);
  UM_TRY(um_core_arena_allocate(context, &model->memory, rows, sizeof *t, &t));
  UM_TRY(um_core_arena_allocate(context, &model->memory, rows, sizeof *v, &v));
  for (size_t i = 0; i < rows; i++) {
    char why[160];
    if (!um_orbit_time_parse_field(um_core_csv_text(csv, i, time), &t[i], why, sizeof why))
      return um_core_csv_fail(context, csv, i, time, "%s", why);
    UM_TRY(times_check(context, csv, time, t, i));
    UM_TRY(um_core_csv_number(context, csv, i, value, &v[i]));
    v[i] *= kind->unit;
  }
  *out = (struct um_model_series){rows, t, v};
  return UM_OK;
}

enum um_status um_model_series_read(struct um_context *context, struct um_model *model,
                                    const struct um_mark *at, const char *file,
                                    const struct um_model_series_kind *kind,
                                    struct um_model_series *out)
{
  enum um_status status;
  const char *path = NULL;
  struct um_core_csv *csv = NULL;
  UM_CHECK(um_model_resolve(context, model, at, file, &path));
  UM_CHECK(um_core_csv_read(context, path, &csv));
  UM_CHECK(rows_read(context, model, csv, kind, out));
done:
  um_core_csv_destroy(&csv);
  return um_model_blame(context, at, kind->key, status);
}

enum um_status um_model_power_history(struct um_context *context, struct um_model *model,
                                      const struct um_mark *at, const char *file,
                                      const struct um_thermal_power_history **out)
{
  static const struct um_model_series_kind kind = {"power_file", "power_W", 1.0,
                                                   "the power is 0 outside of them"};
  struct um_thermal_power_history *history = NULL;
  struct um_model_series series;
  *out = NULL;
  if (file == NULL) return UM_OK;
  UM_TRY(um_model_series_read(context, model, at, file, &kind, &series));
  UM_TRY(um_core_arena_allocate(context, &model->memory, 1, sizeof *history, &history));
  history->nrow = series.nrow;
  history->t = series.t;
  history->power = series.value;
  *out = history;
  return UM_OK;
}
