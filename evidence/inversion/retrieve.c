/* From measured light in thermal bands to temperatures: rows of one time become intensities of
 * their bands, which grey bodies are fitted to. */
#include "evidence/inversion/retrieve.h"

#include <math.h>

#include "base/core/csv.h"
#include "model/build/bands.h"
#include "model/geometry/precompute.h"
#include "orbit/time.h"

/* Intensities of one time. */
struct spectrum {
  size_t nband;
  struct um_instrument_bins *bins;
  double *intensity, *sigma; /* [W/sr] */
};

struct work {
  const struct um_model *model;
  struct um_compare_plan *plan;
  struct um_model_tables *tables;
  struct um_instrument_bins *bins; /* [nband of the model] */
  size_t *first;                   /* [ntime + 1] of the rows of each time in `row` */
  size_t *row;                     /* rows of light in thermal bands, by time */
  struct spectrum spectrum;
};

static bool is_wanted(const struct work *w, size_t row)
{
  const struct um_compare_measurements *m = w->plan->measurements;
  size_t channel = m->row[row].channel;
  enum um_compare_quantity quantity = m->channel[channel].quantity;
  return w->plan->observation[row] != UM_COMPARE_NOWHERE &&
         (quantity == UM_QUANTITY_BAND_IRRADIANCE || quantity == UM_QUANTITY_RADIANT_INTENSITY) &&
         um_model_band_is_thermal(&w->model->band[w->plan->source[channel]]);
}

/* Rows by their time, counted first. */
static enum um_status sort_rows(struct um_context *context, struct work *w)
{
  const struct um_compare_measurements *m = w->plan->measurements;
  size_t most = 0;
  UM_TRY(um_core_allocate(context, w->plan->ntime + 1, sizeof *w->first, &w->first));
  UM_TRY(um_core_allocate(context, m->count, sizeof *w->row, &w->row));
  for (size_t i = 0; i < m->count; i++)
    if (is_wanted(w, i)) w->first[w->plan->observation[i]]++;
  for (size_t k = 0; k < w->plan->ntime; k++) most = w->first[k] > most ? w->first[k] : most;
  for (size_t k = 0; k < w->plan->ntime; k++) w->first[k + 1] += w->first[k];
  for (size_t i = m->count;
       i-- > 0;) /* from behind: first[k] goes from the end of k to its start */
    if (is_wanted(w, i)) w->row[--w->first[w->plan->observation[i]]] = i;
  UM_TRY(um_core_allocate(context, most, sizeof *w->spectrum.bins, &w->spectrum.bins));
  UM_TRY(um_core_allocate(context, most, sizeof(double), &w->spectrum.intensity));
  return um_core_allocate(context, most, sizeof(double), &w->spectrum.sigma);
}

/* Irradiance becomes intensity by the square of the range. */
static enum um_status take(struct um_context *context, struct work *w, size_t k)
{
  const struct um_compare_measurements *m = w->plan->measurements;
  size_t nsub = w->tables->nsub;
  double range = w->tables->sample[k * nsub + nsub / 2].range;
  struct spectrum *s = &w->spectrum;
  s->nband = 0;
  for (size_t i = w->first[k]; i < w->first[k + 1]; i++) {
    const struct um_compare_measurement *r = &m->row[w->row[i]];
    bool irradiance = m->channel[r->channel].quantity == UM_QUANTITY_BAND_IRRADIANCE;
    double scale = irradiance ? range * range : 1.0;
    if (isnan(r->sigma))
      return um_core_fail(context, UM_ERR_INPUT,
                          "%s:%d: column 'sigma': is empty; accepted: a number above 0, which "
                          "temperatures are weighed by",
                          um_compare_row_path(m, (size_t)(r - m->row)), r->line);
    s->bins[s->nband] = w->bins[w->plan->source[r->channel]];
    s->intensity[s->nband] = r->value * scale;
    s->sigma[s->nband++] = r->sigma * scale;
  }
  return UM_OK;
}

static enum um_status fit(struct um_context *context, const struct spectrum *s, size_t n,
                          struct um_instrument_grey_body *out)
{
  return um_instrument_grey_body_try(context, s->bins, s->intensity, s->sigma, s->nband, n, out);
}

static enum um_status fill(struct um_context *context, struct work *w,
                           struct um_compare_retrieved *out)
{
  size_t fits = 0;
  for (size_t k = 0; k < w->plan->ntime; k++) {
    if (w->first[k] == w->first[k + 1]) continue;
    UM_TRY(um_core_stop_check(context, "temperatures were retrieved"));
    UM_TRY(take(context, w, k));
    struct um_compare_retrieved_row *row = &out->row[out->count++];
    row->t_tai = w->tables->t_obs[k];
    row->nband = w->spectrum.nband;
    UM_TRY(fit(context, &w->spectrum, 1, &row->one));
    UM_TRY(fit(context, &w->spectrum, 2, &row->two));
    fits += row->one.n;
  }
  if (fits > 0) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s: at no time light in three bands of %g to %g um; accepted: "
                      "band_irradiance or radiant_intensity of three or more such bands at a time",
                      w->plan->measurements->path, UM_INSTRUMENT_THERMAL_FROM * 1e6,
                      UM_INSTRUMENT_THERMAL_TO * 1e6);
}

static void work_release(struct um_context *context, struct work *w)
{
  for (size_t b = 0; w->bins != NULL && b < w->model->nband; b++)
    um_model_band_bins_clear(context, &w->bins[b]);
  UM_FREE(context, w->bins, w->first, w->row, w->spectrum.bins, w->spectrum.intensity,
          w->spectrum.sigma);
  um_model_tables_destroy(context, &w->tables);
  um_compare_plan_destroy(context, &w->plan);
}

enum um_status um_compare_retrieve(struct um_context *context, const struct um_model *model,
                                   const struct um_compare_measurements *measurements,
                                   struct um_compare_retrieved **out)
{
  enum um_status status;
  struct work w = {.model = model};
  struct um_compare_retrieved *made = NULL;
  *out = NULL;
  UM_CHECK(um_compare_plan_create(context, model, measurements, &w.plan));
  UM_CHECK(um_compare_plan_trace(context, model, w.plan, &w.tables));
  UM_CHECK(um_core_allocate(context, model->nband, sizeof *w.bins, &w.bins));
  for (size_t b = 0; b < model->nband; b++)
    UM_CHECK(um_model_band_bins(context, &model->band[b], &w.bins[b]));
  UM_CHECK(sort_rows(context, &w));
  UM_CHECK(um_core_allocate(context, 1, sizeof *made, &made));
  UM_CHECK(um_core_allocate(context, w.plan->ntime, sizeof *made->row, &made->row));
  UM_CHECK(fill(context, &w, made));
  *out = made;
  made = NULL;
done:
  um_compare_retrieved_destroy(context, &made);
  work_release(context, &w);
  return status;
}

void um_compare_retrieved_destroy(struct um_context *context,
                                  struct um_compare_retrieved **retrieved)
{
  if (*retrieved == NULL) return;
  UM_FREE(context, (*retrieved)->row, *retrieved);
  *retrieved = NULL;
}

bool um_compare_retrieved_prefers_two(const struct um_compare_retrieved_row *row)
{
  return um_instrument_grey_body_prefers_two(&row->one, &row->two);
}

/* ---- retrieved.csv ---- */

static void put_body(FILE *file, const struct um_instrument_grey_body *body, size_t n)
{
  bool known = body->n > 0;
  for (size_t j = 0; j < n; j++) {
    um_core_csv_put_number(file, known ? body->temperature[j] : (double)NAN);
    um_core_csv_put_number(file, known ? body->temperature_sigma[j] : (double)NAN);
    um_core_csv_put_number(file, known ? body->area[j] : (double)NAN);
    um_core_csv_put_number(file, known ? body->area_sigma[j] : (double)NAN);
  }
  um_core_csv_put_number(file, known ? body->chi2 : (double)NAN);
}

void um_compare_retrieved_write(const struct um_compare_retrieved *retrieved, FILE *file)
{
  fputs("time_utc,bands,temperature_K,temperature_sigma_K,cross_section_m2,cross_section_sigma_m2,"
        "chi2,cold_K,cold_sigma_K,cold_m2,cold_sigma_m2,hot_K,hot_sigma_K,hot_m2,hot_sigma_m2,"
        "two_chi2,effective_K,two_delta_bic\n",
        file);
  for (size_t k = 0; k < retrieved->count; k++) {
    const struct um_compare_retrieved_row *r = &retrieved->row[k];
    bool two = r->two.n > 0, both = two && r->one.n > 0;
    char time[32];
    um_orbit_time_format(r->t_tai, time);
    fprintf(file, "%s,%zu", time, r->nband);
    put_body(file, &r->one, 1);
    put_body(file, &r->two, 2);
    um_core_csv_put_number(file, two ? um_instrument_grey_body_effective(&r->two) : (double)NAN);
    um_core_csv_put_number(file, both ? r->two.bic - r->one.bic : (double)NAN);
    fputc('\n', file);
  }
}
