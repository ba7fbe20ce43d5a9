/* From rows to observations and back. */
#include "evidence/comparison/predict.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/sort.h"
#include "evidence/comparison/predict_source_impl.h"
#include "evidence/measurements/time_text.h"
#include "model/geometry/precompute.h"
#include "model/scenario/station.h"

#define SAME_TIME 0.5e-6 /* times nearer than this are one [s] */

/* --- times ----------------------------------------------------------------------------------- */

struct wanted {
  double t, exposure; /* [s]; NaN: not said */
  size_t row, set;
  struct um_model_point point; /* with an orbit only its station */
};

static int compare_numbers(double x, double y) { return (x > y) - (x < y); }

/* Of stations and places alone. */
static int compare_points(const struct um_model_point *x, const struct um_model_point *y)
{
  if (x->station != y->station) return x->station < y->station ? -1 : 1;
  int by = compare_numbers(x->azimuth, y->azimuth);
  if (by == 0) by = compare_numbers(x->elevation, y->elevation);
  return by != 0 ? by : compare_numbers(x->height, y->height);
}

/* In order of time; at one time, rows of one place and set stand together. */
static int compare_wanted(const void *a, const void *b)
{
  const struct wanted *x = a, *y = b;
  int by = compare_numbers(x->t, y->t);
  if (by == 0) by = compare_points(&x->point, &y->point);
  if (by == 0) by = (x->set > y->set) - (x->set < y->set);
  return by != 0 ? by : x->row < y->row ? -1 : x->row > y->row;
}

/* Who looked: what the row says, or its set. */
static enum um_status station_of(struct um_context *context, const struct um_model *model,
                                 const struct um_compare_measurements *m, size_t row, size_t *out)
{
  const struct um_compare_measurement *r = &m->row[row];
  const char *of_set = m->file[r->set].station, *name = of_set != NULL ? of_set : "";
  if (r->station != SIZE_MAX) name = m->station[r->station];
  enum um_status status = um_model_station_find(context, model->scenario->observer, name, out);
  if (status != UM_OK)
    um_core_message_prefix(context, "%s:%d: column 'station'", um_compare_row_path(m, row),
                           r->line);
  return status;
}

static enum um_status point_of(struct um_context *context, const struct um_model *model,
                               const struct um_compare_measurements *m, size_t row,
                               struct um_model_point *out)
{
  const struct um_compare_measurement *r = &m->row[row];
  *out = (struct um_model_point){.t = r->t_tai};
  if (model->points) {
    out->height = r->satellite_height;
    out->azimuth = r->azimuth;
    out->elevation = r->elevation;
  }
  return station_of(context, model, m, row, &out->station);
}

static enum um_status sample_of(struct um_context *context, const struct um_model *model,
                                const struct wanted *wanted)
{
  struct um_environment_sample sample;
  struct um_orbit_look look;
  if (model->points) return um_model_sample_point(context, model, &wanted->point, &sample, &look);
  if (model->has_observer)
    return um_model_sample_from(context, model, wanted->point.station, wanted->t, &sample, &look);
  return um_model_sample_at(context, model, wanted->t, &sample);
}

/* Within the scenario's own time, and where orbit and attitude are known. */
static enum um_status check_time(struct um_context *context, const struct um_model *model,
                                 const struct um_compare_measurements *m,
                                 const struct wanted *wanted)
{
  size_t row = wanted->row;
  const struct um_scenario_time *time = model->scenario->time;
  double t = m->row[row].t_tai;
  if (!(t >= time->start - time->step_s && t <= time->stop + time->step_s)) {
    char text[40], start[40], stop[40];
    um_compare_time_text(t, text);
    um_compare_time_text(time->start, start);
    um_compare_time_text(time->stop, stop);
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s:%d: column '%s': %s is outside the scenario; accepted: %s to %s "
                        "(time.start_utc, time.stop_utc)",
                        um_compare_row_path(m, row), m->row[row].line,
                        um_compare_row_time_column(m, row), text, start, stop);
  }
  enum um_status status = sample_of(context, model, wanted);
  if (status != UM_OK)
    um_core_message_prefix(context, "%s:%d", um_compare_row_path(m, row), m->row[row].line);
  return status;
}

/* The observation of n rows of one time, exposures joined; those that overlap an observation before
 * cannot be followed in one run. */
static enum um_status add_observation(struct um_context *context, const struct um_model *model,
                                      const struct wanted *wanted, size_t n,
                                      struct um_compare_plan *plan)
{
  const struct um_compare_measurements *m = plan->measurements;
  size_t k = plan->ntime;
  double exposure = NAN;
  for (size_t i = 0; i < n; i++) {
    if (isnan(wanted[i].exposure)) continue;
    if (!isnan(exposure) && wanted[i].exposure != exposure)
      return um_core_fail(context, UM_ERR_INPUT,
                          "%s:%d: column 'exposure_s': %g s, another row of this time has %g s; "
                          "accepted: one exposure at a time",
                          um_compare_row_path(m, wanted[i].row), m->row[wanted[i].row].line,
                          wanted[i].exposure, exposure);
    exposure = wanted[i].exposure;
  }
  if (isnan(exposure)) exposure = model->scenario->time->exposure_s;
  UM_TRY(check_time(context, model, m, &wanted[0]));
  if (!model->points && k > 0 &&
      wanted[0].t - plan->time[k - 1] < 0.5 * (exposure + plan->exposure[k - 1]) - SAME_TIME)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s:%d: column 'exposure_s': the exposure of %g s begins before the one "
                        "before it ends; accepted: exposures that do not overlap",
                        um_compare_row_path(m, wanted[0].row), m->row[wanted[0].row].line,
                        exposure);
  plan->time[k] = wanted[0].t;
  plan->exposure[k] = exposure;
  plan->set[k] = m->file[wanted[0].set].name;
  plan->station[k] = wanted[0].point.station;
  if (model->points) plan->point[k] = wanted[0].point;
  for (size_t i = 0; i < n; i++) plan->observation[wanted[i].row] = k;
  plan->ntime++;
  return UM_OK;
}

static enum um_status merge(struct um_context *context, const struct um_model *model,
                            struct wanted *wanted, size_t n, struct um_compare_plan *plan)
{
  UM_TRY(um_core_allocate(context, n, sizeof *plan->time, &plan->time));
  UM_TRY(um_core_allocate(context, n, sizeof *plan->exposure, &plan->exposure));
  UM_TRY(um_core_allocate(context, n, sizeof *plan->set, (void *)&plan->set));
  UM_TRY(um_core_allocate(context, n, sizeof *plan->station, &plan->station));
  if (model->points) UM_TRY(um_core_allocate(context, n, sizeof *plan->point, &plan->point));
  UM_TRY(um_core_sort(context, wanted, n, sizeof *wanted, compare_wanted));
  for (size_t i = 0, end; i < n; i = end) {
    for (end = i + 1; end < n && wanted[end].t - wanted[i].t <= SAME_TIME &&
                      compare_points(&wanted[end].point, &wanted[i].point) == 0 &&
                      wanted[end].set == wanted[i].set;)
      end++;
    UM_TRY(add_observation(context, model, wanted + i, end - i, plan));
  }
  return UM_OK;
}

static enum um_status plan_times(struct um_context *context, const struct um_model *model,
                                 struct um_compare_plan *plan)
{
  const struct um_compare_measurements *m = plan->measurements;
  struct wanted *wanted = NULL;
  size_t n = 0;
  enum um_status status;
  UM_TRY(um_core_allocate(context, m->count, sizeof *wanted, &wanted));
  for (size_t i = 0; i < m->count; i++) {
    plan->observation[i] = UM_COMPARE_NOWHERE;
    if (m->row[i].flag != 0) continue;
    wanted[n] = (struct wanted){
        .t = m->row[i].t_tai, .exposure = m->row[i].exposure, .row = i, .set = m->row[i].set};
    UM_CHECK(point_of(context, model, m, i, &wanted[n].point));
    n++;
  }
  if (n == 0)
    status =
        um_core_fail(context, UM_ERR_INPUT,
                     "%s: every row is flagged; accepted: at least one row with flag 0", m->path);
  else
    status = merge(context, model, wanted, n, plan);
done:
  um_core_free(context, wanted);
  return status;
}

/* --- plan ------------------------------------------------------------------------------------ */

/* Rows say where the satellite is, or the scenario does. */
static enum um_status check_geometry(struct um_context *context, const struct um_model *model,
                                     const struct um_compare_measurements *m)
{
  if (model->points && !m->independent)
    return um_core_fail(
        context, UM_ERR_INPUT,
        "%s: header: columns satellite_height_km, azimuth_deg and elevation_deg are "
        "missing; accepted: all three, because the scenario's orbit is 'points'",
        m->path);
  if (!model->points && m->independent)
    um_core_log(context, UM_LOG_WARNING,
                "%s: satellite height, azimuth and elevation are not used: the scenario's orbit "
                "says where the satellite is (orbit.points takes them)",
                m->path);
  return UM_OK;
}

/* A value for a set that is not there does nothing, and may be a misspelling. */
static void warn_of_sets(struct um_context *context, const struct um_model *model,
                         const struct um_compare_measurements *m)
{
  for (size_t i = 0; i < model->neffect; i++) {
    const struct um_model_effect *e = &model->effect[i];
    if (!e->off && e->set != NULL && um_compare_set_find(m, e->set) == UM_COMPARE_NOWHERE)
      um_core_log(context, UM_LOG_WARNING,
                  "effect %s:%s does nothing: none of the measurements is a set '%s'",
                  e->effect->name, e->target, e->set);
  }
}

enum um_status um_compare_plan_create(struct um_context *context, const struct um_model *model,
                                      const struct um_compare_measurements *measurements,
                                      struct um_compare_plan **out)
{
  struct um_compare_plan *plan = NULL;
  enum um_status status;
  *out = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *plan, &plan));
  plan->measurements = measurements;
  UM_CHECK(check_geometry(context, model, measurements));
  warn_of_sets(context, model, measurements);
  UM_CHECK(um_core_allocate(context, measurements->nchannel, sizeof *plan->source, &plan->source));
  UM_CHECK(um_core_allocate(context, measurements->count, sizeof *plan->observation,
                            &plan->observation));
  for (size_t c = 0; c < measurements->nchannel; c++)
    UM_CHECK(um_compare_source_find(context, model, measurements, c, &plan->source[c]));
  UM_CHECK(plan_times(context, model, plan));
  *out = plan;
  plan = NULL;
done:
  um_compare_plan_destroy(context, &plan);
  return status;
}

void um_compare_plan_destroy(struct um_context *context, struct um_compare_plan **plan)
{
  if (plan == NULL || *plan == NULL) return;
  UM_FREE(context, (*plan)->time, (*plan)->exposure, (*plan)->point, (*plan)->station,
          (*plan)->observation, (*plan)->source, (void *)(*plan)->set, *plan);
  *plan = NULL;
}

struct um_model_instants um_compare_plan_instants(const struct um_compare_plan *plan)
{
  return (struct um_model_instants){.time = plan->time,
                                    .exposure = plan->exposure,
                                    .set = plan->set,
                                    .station = plan->station,
                                    .point = plan->point,
                                    .count = plan->ntime};
}

enum um_status um_compare_plan_sample(struct um_context *context, const struct um_model *model,
                                      const struct um_compare_plan *plan, size_t k,
                                      struct um_environment_sample *sample,
                                      struct um_orbit_look *look)
{
  if (plan->point != NULL)
    return um_model_sample_point(context, model, &plan->point[k], sample, look);
  return um_model_sample_from(context, model, plan->station[k], plan->time[k], sample, look);
}

enum um_status um_compare_plan_trace(struct um_context *context, const struct um_model *model,
                                     const struct um_compare_plan *plan,
                                     struct um_model_tables **out)
{
  const struct um_model_instants instants = um_compare_plan_instants(plan);
  return um_model_precompute_over(context, model, &instants, out);
}

/* --- values ---------------------------------------------------------------------------------- */

static enum um_status refuse_hidden(struct um_context *context,
                                    const struct um_compare_measurements *m, size_t row,
                                    const struct um_model_tables *tables, size_t k)
{
  double lowest = INFINITY; /* [rad] */
  for (size_t i = k * tables->nsub; i < (k + 1) * tables->nsub; i++)
    lowest = fmin(lowest, tables->look[i].elevation); /* NaN without a station */
  if (isinf(lowest))
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s:%d: column 'time_utc': the Earth stands between satellite and "
                        "observer; accepted: rows in which it does not, or a flag that leaves the "
                        "row out",
                        um_compare_row_path(m, row), m->row[row].line);
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s:%d: column '%s': the satellite is below the horizon (elevation "
                      "%.2f deg); accepted: rows above it, or a flag that leaves the row out",
                      um_compare_row_path(m, row), m->row[row].line,
                      um_compare_row_time_column(m, row), lowest / UM_DEG);
}

/* Temperature or area of all thermal bands together; NaN where no grey body fits. */
static double grey_body_of(enum um_compare_quantity quantity, const struct um_model_result *result,
                           size_t k)
{
  const struct um_instrument_grey_body *one = &result->grey_body[k].one;
  if (one->n == 0) return NAN;
  return quantity == UM_QUANTITY_INFRARED_CROSS_SECTION ? one->area[0] : one->temperature[0];
}

double um_compare_predict_at(const struct um_compare_plan *plan,
                             const struct um_model_tables *tables,
                             const struct um_model_result *result, size_t channel, size_t k)
{
  enum um_compare_quantity quantity = plan->measurements->channel[channel].quantity;
  size_t s = plan->source[channel];
  if (quantity == UM_QUANTITY_TEMPERATURE) return result->place[s].mean[k];
  if (um_compare_is_grey_body(quantity)) return grey_body_of(quantity, result, k);
  if (quantity == UM_QUANTITY_RADIANT_INTENSITY) /* the satellite's own */
    return result->measured_intensity[k * result->nband + s];
  if (tables->hidden[k]) return NAN;
  if (quantity == UM_QUANTITY_BAND_IRRADIANCE) return result->irradiance[k * result->nband + s];
  if (quantity == UM_QUANTITY_COUNT_RATE) return result->count_rate[k * result->nsensor + s];
  double vega = quantity == UM_QUANTITY_MAGNITUDE_VEGA ? result->vega_ab[s] : 0.0;
  return result->magnitude_ab[k * result->nband + s] - vega;
}

/* A row for which the model has no value. */
static enum um_status refuse(struct um_context *context, const struct um_compare_measurements *m,
                             size_t row, const struct um_model_tables *tables, size_t k)
{
  enum um_compare_quantity quantity = m->channel[m->row[row].channel].quantity;
  if (!um_compare_is_grey_body(quantity)) return refuse_hidden(context, m, row, tables, k);
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s:%d: column 'quantity': %s: no grey body fits the model's light of this "
                      "time; accepted: light above 0 in the thermal bands, or a flag that leaves "
                      "the row out",
                      um_compare_row_path(m, row), m->row[row].line,
                      um_compare_quantity_name(quantity));
}

enum um_status um_compare_predict(struct um_context *context, const struct um_compare_plan *plan,
                                  const struct um_model_tables *tables,
                                  const struct um_model_result *result, double *value)
{
  const struct um_compare_measurements *m = plan->measurements;
  for (size_t i = 0; i < m->count; i++) {
    size_t k = plan->observation[i];
    enum um_compare_quantity quantity = m->channel[m->row[i].channel].quantity;
    value[i] = NAN;
    if (k == UM_COMPARE_NOWHERE) continue;
    value[i] = um_compare_predict_at(plan, tables, result, m->row[i].channel, k);
    bool sky = quantity != UM_QUANTITY_TEMPERATURE && quantity != UM_QUANTITY_RADIANT_INTENSITY;
    if (sky && (um_compare_is_grey_body(quantity) ? isnan(value[i]) : tables->hidden[k]))
      return refuse(context, m, i, tables, k);
  }
  return UM_OK;
}

void um_compare_predict_error(const struct um_compare_plan *plan,
                              const struct um_model_result *result, double *model_sigma)
{
  const struct um_compare_measurements *m = plan->measurements;
  for (size_t i = 0; i < m->count; i++) {
    size_t k = plan->observation[i], channel = m->row[i].channel, s = plan->source[channel];
    model_sigma[i] = NAN;
    if (k == UM_COMPARE_NOWHERE) continue;
    size_t at = k * result->nband + s;
    switch (m->channel[channel].quantity) {
    case UM_QUANTITY_TEMPERATURE:
      model_sigma[i] = 0.0;
      break;
    case UM_QUANTITY_RADIANT_INTENSITY:
      model_sigma[i] = result->standard_error[at];
      break;
    case UM_QUANTITY_BAND_IRRADIANCE:
      model_sigma[i] = result->irradiance_error[at];
      break;
    case UM_QUANTITY_CHARACTERISTIC_TEMPERATURE:
      model_sigma[i] = result->grey_body[k].temperature_error;
      break;
    case UM_QUANTITY_INFRARED_CROSS_SECTION:
      model_sigma[i] = result->grey_body[k].area_error;
      break;
    case UM_QUANTITY_COUNT_RATE:
      model_sigma[i] = result->count_rate_error[k * result->nsensor + s];
      break;
    case UM_QUANTITY_MAGNITUDE_VEGA: /* flux relative to another zero */
      model_sigma[i] = result->magnitude_error[at] * pow(10.0, 0.4 * result->vega_ab[s]);
      break;
    default:
      model_sigma[i] = result->magnitude_error[at];
    }
  }
}

size_t um_compare_band(const struct um_compare_plan *plan, const struct um_model *model,
                       size_t channel)
{
  size_t source = plan->source[channel];
  return plan->measurements->channel[channel].quantity == UM_QUANTITY_COUNT_RATE
             ? model->sensor[source].band
             : source;
}
