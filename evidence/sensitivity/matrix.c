/* The matrix of derivatives: columns of candidates (derivative.c), ordered by curve and time. */
#include "evidence/sensitivity/matrix.h"

#include <math.h>
#include <omp.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "evidence/sensitivity/difference_impl.h"
#include "evidence/sensitivity/own.h"
#include "evidence/sensitivity/policy.h"
#include "evidence/sensitivity/stated.h"

#define KELVIN 100.0 /* size of a curve of temperature [K] */

const char *um_sensitivity_way_name(enum um_sensitivity_way way)
{
  static const char *const name[UM_SENSITIVITY_WAYS] = {"none", "behind", "light", "tangent",
                                                        "runs", "motion", "switch"};
  return way < UM_SENSITIVITY_WAYS ? name[way] : "none";
}

/* --- curves ----------------------------------------------------------------------------------- */

static enum um_status name_curve(struct um_context *context,
                                 const struct um_compare_channel *channel,
                                 struct um_sensitivity_curve *out)
{
  enum um_compare_quantity q = channel->quantity;
  out->temperature = q == UM_QUANTITY_TEMPERATURE;
  out->unit = um_compare_residual_unit(q);
  if (out->temperature || q == UM_QUANTITY_BAND_IRRADIANCE)
    return um_core_strdup(context, channel->label, &out->name);
  return um_core_asprintf(context, &out->name, "%s:%s", um_compare_quantity_name(q),
                          channel->label);
}

/* Light first. */
static enum um_status make_curves(struct um_context *context, struct um_sensitivity_matrix *m)
{
  const struct um_compare_measurements *set = m->forward->measurements;
  m->ntime = m->forward->plan->ntime;
  m->time = m->forward->plan->time;
  UM_TRY(um_core_allocate(context, set->nchannel, sizeof *m->curve, &m->curve));
  for (int heat = 0; heat < 2; heat++) {
    for (size_t c = 0; c < set->nchannel; c++) {
      if ((set->channel[c].quantity == UM_QUANTITY_TEMPERATURE) != (heat == 1)) continue;
      m->curve_of[c] = m->ncurve;
      UM_TRY(name_curve(context, &set->channel[c], &m->curve[m->ncurve++]));
    }
    if (heat == 0) m->nlight = m->ncurve;
  }
  return UM_OK;
}

void um_sensitivity_matrix_spread(const struct um_sensitivity_matrix *m, const double *value,
                                  double *out)
{
  const struct um_sensitivity_observations *o = &m->forward->observations;
  for (size_t i = 0; i < m->ncurve * m->ntime; i++) out[i] = NAN;
  for (size_t j = 0; j < o->count; j++)
    out[m->curve_of[o->channel[j]] * m->ntime + m->forward->plan->observation[o->row[j]]] =
        value[j];
}

static void measure_curves(struct um_sensitivity_matrix *m)
{
  for (size_t c = 0; c < m->ncurve; c++) {
    struct um_sensitivity_curve *curve = &m->curve[c];
    for (size_t k = 0; k < m->ntime; k++) /* fmax leaves NaN out */
      curve->size = fmax(curve->size, fabs(m->value[c * m->ntime + k]));
    if (curve->temperature) curve->size = KELVIN;
  }
}

/* --- rows ------------------------------------------------------------------------------------- */

static double log_scale(const struct um_sensitivity_forward *f,
                        const struct um_sensitivity_candidate *c, size_t p)
{
  struct um_effect_stated stated;
  double null = c->null_value[p], scale = null;
  if (um_sensitivity_stated_find(f, c->effect, c->target, p, null, &stated)) {
    if (stated.change == UM_CHANGE_ADDS) scale = stated.value;
    if (stated.change == UM_CHANGE_STRETCHES) scale = 1.0 + null;
  }
  return scale == 0.0 ? (double)NAN : scale;
}

static bool is_in(const size_t *list, size_t n, size_t value)
{
  for (size_t i = 0; i < n; i++)
    if (list[i] == value) return true;
  return false;
}

/* Why there is no column, or none that a small step follows. */
static const char *why_of(const struct um_sensitivity_row *row)
{
  const struct um_sensitivity_candidate *c = row->candidate;
  const struct um_effect_parameter *p =
      row->parameter == SIZE_MAX ? NULL : &c->effect->parameters[row->parameter];
  if (c->insensitive) return c->why != NULL ? c->why : "nothing changes";
  if (p == NULL) return "a switch: its whole change";
  if (p->chosen) return "a number that is chosen";
  if (row->column == NULL && is_in(c->unidentified, c->nunidentified, row->parameter))
    return "does nothing while the effect is at its null value";
  if (row->column == NULL) return "nothing changes";
  if (p->is_temperature) return "a temperature at which something switches";
  if (!(row->quality.error <= UM_SENSITIVITY_BROKEN)) return "its slope depends on the step";
  return NULL;
}

static enum um_status add_row(struct um_context *context, struct um_sensitivity_matrix *m,
                              const struct um_sensitivity_candidate *c, size_t p,
                              const double *column)
{
  struct um_sensitivity_row *row = &m->row[m->nrow++];
  *row = (struct um_sensitivity_row){.candidate = c, .parameter = p, .unit = "1"};
  if (p == SIZE_MAX) {
    double value = c->effect->nparameter > 0 ? c->null_value[0] : NAN;
    row->minimum = row->maximum = row->log_scale = NAN;
    row->null_value = 0.0;
    row->width = 1.0;
    row->quality = c->quality[0];
    UM_TRY(c->effect->nparameter > 0 ? um_core_asprintf(context, &row->name, "%s.%s=%g", c->name,
                                                        c->effect->parameters[0].name, value)
                                     : um_core_strdup(context, c->name, &row->name));
  } else {
    const struct um_effect_parameter *of = &c->effect->parameters[p];
    row->unit = of->unit;
    row->null_value = c->null_value[p];
    row->minimum = c->minimum[p];
    row->maximum = c->maximum[p];
    row->width = isfinite(of->prior_sigma)
                     ? of->prior_sigma * (of->logarithmic ? fabs(row->null_value) : 1.0)
                     : fabs(um_sensitivity_first_step(c, p, row->null_value));
    row->log_scale = log_scale(m->forward, c, p);
    row->quality = c->quality[p];
    UM_TRY(um_core_asprintf(context, &row->name, "%s.%s", c->name, of->name));
  }
  row->column = column;
  if (column == NULL) row->quality = (struct um_sensitivity_quality){.error = NAN, .reach = NAN};
  row->why = why_of(row);
  row->smooth = row->why == NULL;
  return UM_OK;
}

/* Signature of a parameter; NULL: it has none. */
static const double *column_of(const struct um_sensitivity_candidate *c, size_t p, size_t n)
{
  for (size_t k = 0; k < c->ncolumn && !c->insensitive; k++)
    if (c->is_switch || c->parameter[k] == p) return c->signature + k * n;
  return NULL;
}

/* Rows of all candidates, of which the signatures are spread and given back. */
static enum um_status make_rows(struct um_context *context, struct um_sensitivity_matrix *m)
{
  size_t rows = 0, columns = 0, n = m->ncurve * m->ntime, used = 0;
  for (size_t i = 0; i < m->list->count; i++) {
    const struct um_sensitivity_candidate *c = &m->list->candidate[i];
    rows += c->is_switch ? 1 : c->effect->nparameter;
    columns += c->insensitive ? 0 : c->ncolumn;
  }
  UM_TRY(um_core_allocate(context, rows, sizeof *m->row, &m->row));
  UM_TRY(um_core_allocate(context, columns * n, sizeof *m->columns, &m->columns));
  for (size_t i = 0; i < m->list->count; i++) {
    struct um_sensitivity_candidate *c = &m->list->candidate[i];
    size_t np = c->is_switch ? 1 : c->effect->nparameter;
    for (size_t p = 0; p < np; p++) {
      const double *column = column_of(c, p, m->list->nobservation);
      double *to = NULL;
      if (column != NULL) {
        to = m->columns + used++ * n;
        um_sensitivity_matrix_spread(m, column, to);
      }
      UM_TRY(add_row(context, m, c, c->is_switch ? SIZE_MAX : p, to));
    }
    um_core_free(context, c->signature);
    c->signature = NULL;
  }
  return UM_OK;
}

/* --- life ------------------------------------------------------------------------------------- */

enum um_status um_sensitivity_matrix_create(struct um_context *context,
                                            struct um_sensitivity_forward *forward, bool own,
                                            const struct um_sensitivity_candidates_options *options,
                                            struct um_sensitivity_matrix **out)
{
  enum um_status status;
  struct um_sensitivity_matrix *m = NULL;
  struct um_sensitivity_candidates_options all = {.derivatives = true};
  double begin = omp_get_wtime();
  *out = NULL;
  if (options != NULL) all = *options;
  all.derivatives = true;
  um_sensitivity_own_weigh(forward, own);
  UM_CHECK(um_core_allocate(context, 1, sizeof *m, &m));
  m->forward = forward;
  m->seconds_run = forward->seconds_first;
  UM_CHECK(um_core_allocate(context, forward->measurements->nchannel, sizeof *m->curve_of,
                            &m->curve_of));
  UM_CHECK(make_curves(context, m));
  UM_CHECK(um_sensitivity_candidates_create(context, forward, NULL, 0, &all, &m->list));
  UM_CHECK(um_core_allocate(context, m->ncurve * m->ntime, sizeof *m->value, &m->value));
  um_sensitivity_matrix_spread(m, m->list->base, m->value);
  measure_curves(m);
  UM_CHECK(make_rows(context, m));
  m->seconds = omp_get_wtime() - begin;
  *out = m;
  m = NULL;
done:
  um_sensitivity_matrix_destroy(context, &m);
  return status;
}

void um_sensitivity_matrix_destroy(struct um_context *context,
                                   struct um_sensitivity_matrix **matrix)
{
  if (matrix == NULL || *matrix == NULL) return;
  struct um_sensitivity_matrix *m = *matrix;
  for (size_t c = 0; c < m->ncurve; c++) um_core_free(context, m->curve[c].name);
  for (size_t i = 0; i < m->nrow; i++) um_core_free(context, m->row[i].name);
  um_sensitivity_candidates_destroy(context, &m->list);
  UM_FREE(context, m->curve, m->curve_of, m->value, m->row, m->columns, m);
  *matrix = NULL;
}

double um_sensitivity_matrix_strength(const struct um_sensitivity_matrix *m,
                                      const struct um_sensitivity_row *row, size_t curve,
                                      size_t from, size_t to, double step)
{
  double most = 0.0;
  if (row->column == NULL || !(m->curve[curve].size > 0.0)) return 0.0;
  for (size_t k = from; k < to; k++) /* fmax leaves NaN out */
    most = fmax(most, fabs(row->column[curve * m->ntime + k]));
  return most * fabs(step) / m->curve[curve].size;
}

void um_sensitivity_matrix_apply(const struct um_sensitivity_matrix *m, const size_t *row,
                                 const double *to, size_t n, double *out)
{
  size_t count = m->ncurve * m->ntime;
  memcpy(out, m->value, count * sizeof *out);
  for (size_t i = 0; i < n; i++) {
    const struct um_sensitivity_row *r = &m->row[row[i]];
    double way = to[i] - r->null_value;
    if (r->column == NULL) continue;
    for (size_t j = 0; j < count; j++) out[j] += way * r->column[j];
  }
}
