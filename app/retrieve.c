/* umbra retrieve: temperature and infrared cross-section of what was measured in several thermal
 * bands, of one grey body and, from five bands on, of two. */
#include <math.h>
#include <string.h>

#include "app/app.h"
#include "app/terminal.h"
#include "compare/measurements.h"
#include "compare/predict.h"
#include "core/file.h"
#include "instrument/grey_body.h"
#include "model/build.h"
#include "model/precompute.h"
#include "orbit/time.h"

#define BANDS_MOST 64

/* Light of one time. */
struct spectrum {
  double t_tai;
  size_t nband;
  struct um_instrument_bins bins[BANDS_MOST];
  double intensity[BANDS_MOST], sigma[BANDS_MOST]; /* [W/sr] */
  struct um_instrument_grey_body one, two;         /* n 0: too few bands, or no fit */
};

/* Bins of the scenario's bands. */
struct bands {
  struct um_instrument_bins *bins; /* [nband] */
  double *edge;                    /* centres and widths of all */
};

static enum um_status bands_create(struct um_context *context, const struct um_model *model,
                                   struct bands *out)
{
  size_t n = 0;
  for (size_t b = 0; b < model->nband; b++) n += (size_t)model->band[b].bins;
  UM_TRY(um_core_allocate(context, model->nband, sizeof *out->bins, &out->bins));
  UM_TRY(um_core_allocate(context, 2 * n, sizeof *out->edge, &out->edge));
  double *at = out->edge;
  for (size_t b = 0; b < model->nband; b++) {
    const struct um_optics_band *band = &model->band[b];
    double *width = at + band->bins;
    for (int i = 0; i < band->bins; i++) {
      double from = um_optics_band_edge(band, i), to = um_optics_band_edge(band, i + 1);
      at[i] = 0.5 * (from + to);
      width[i] = to - from;
    }
    out->bins[b] = (struct um_instrument_bins){(size_t)band->bins, at, width, band->transmission};
    at += 2 * band->bins;
  }
  return UM_OK;
}

static bool is_thermal(const struct um_optics_band *band)
{
  return band->from >= UM_INSTRUMENT_THERMAL_FROM && band->to <= UM_INSTRUMENT_THERMAL_TO;
}

/* A row of a thermal band joins the spectrum of its time; irradiance by the square of the range. */
static enum um_status add(struct um_context *context, const struct um_model *model,
                          const struct um_compare_plan *plan,
                          const struct um_model_precomputed *precomputed, const struct bands *bands,
                          size_t row, struct spectrum *spectrum)
{
  const struct um_compare_measurements *m = plan->measurements;
  const struct um_compare_measurement *r = &m->row[row];
  const struct um_compare_channel *c = &m->channel[r->channel];
  size_t k = plan->observation[row];
  bool irradiance = c->quantity == UM_QUANTITY_BAND_IRRADIANCE;
  if (k == UM_COMPARE_NOWHERE) return UM_OK;
  if (!irradiance && c->quantity != UM_QUANTITY_RADIANT_INTENSITY) return UM_OK;
  size_t band = plan->source[r->channel];
  if (!is_thermal(&model->band[band])) return UM_OK;
  if (isnan(r->sigma))
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s:%d: column 'sigma': is empty; accepted: a number above 0, which "
                        "temperatures are weighed by",
                        m->path, r->line);
  struct spectrum *s = &spectrum[k];
  if (s->nband == BANDS_MOST)
    return um_core_fail(context, UM_ERR_INPUT, "%s:%d: more than %d thermal bands at one time",
                        m->path, r->line, BANDS_MOST);
  double range = precomputed->sample[k * precomputed->nsub + precomputed->nsub / 2].range;
  double scale = irradiance ? range * range : 1.0;
  s->t_tai = precomputed->t_obs[k];
  s->bins[s->nband] = bands->bins[band];
  s->intensity[s->nband] = r->value * scale;
  s->sigma[s->nband++] = r->sigma * scale;
  return UM_OK;
}

/* A spectrum that no grey body fits keeps its row, empty. */
static enum um_status fit(struct um_context *context, struct spectrum *s, size_t n,
                          struct um_instrument_grey_body *out)
{
  if (s->nband < 2 * n + 1) return UM_OK;
  enum um_status status =
      um_instrument_grey_body_fit(context, s->bins, s->intensity, s->sigma, s->nband, n, out);
  if (status != UM_ERR_INPUT && status != UM_ERR_NUMERIC) return status;
  um_core_message_clear(context);
  *out = (struct um_instrument_grey_body){0};
  return UM_OK;
}

static void put_number(FILE *file, bool known, double value)
{
  if (known && isfinite(value))
    fprintf(file, ",%.9g", value);
  else
    fputc(',', file);
}

static void put_body(FILE *file, const struct um_instrument_grey_body *body, size_t n)
{
  for (size_t j = 0; j < n; j++) {
    put_number(file, body->n > 0, body->temperature[j]);
    put_number(file, body->n > 0, body->temperature_sigma[j]);
    put_number(file, body->n > 0, body->area[j]);
    put_number(file, body->n > 0, body->area_sigma[j]);
  }
  put_number(file, body->n > 0, body->chi2);
}

static enum um_status write_table(struct um_context *context, struct um_core_folder *folder,
                                  const struct spectrum *spectrum, size_t n)
{
  FILE *file = NULL;
  UM_TRY(um_core_folder_open(context, folder, "retrieved.csv", &file));
  fputs("time_utc,bands,temperature_K,temperature_sigma_K,cross_section_m2,cross_section_sigma_m2,"
        "chi2,cold_K,cold_sigma_K,cold_m2,cold_sigma_m2,hot_K,hot_sigma_K,hot_m2,hot_sigma_m2,"
        "two_chi2,effective_K,two_delta_bic\n",
        file);
  for (size_t k = 0; k < n; k++) {
    const struct spectrum *s = &spectrum[k];
    char time[32];
    if (s->nband == 0) continue;
    um_orbit_time_format(s->t_tai, time);
    fprintf(file, "%s,%zu", time, s->nband);
    put_body(file, &s->one, 1);
    put_body(file, &s->two, 2);
    put_number(file, s->two.n > 0, um_instrument_grey_body_effective(&s->two));
    put_number(file, s->two.n > 0, s->two.bic - s->one.bic);
    fputc('\n', file);
  }
  return um_core_file_close(context, "retrieved.csv", &file);
}

static void print_summary(const struct spectrum *spectrum, size_t n, const char *folder)
{
  size_t fits = 0, twos = 0, better = 0;
  double low = INFINITY, high = -INFINITY;
  printf("%-24s%6s%24s%30s\n", "UTC", "bands", "temperature [K]", "cross-section [m2]");
  for (size_t k = 0; k < n; k++) {
    const struct um_instrument_grey_body *b = &spectrum[k].one;
    char time[32], text[2][40];
    if (b->n == 0) continue;
    fits++;
    twos += spectrum[k].two.n > 0;
    better += spectrum[k].two.n > 0 && spectrum[k].two.bic < b->bic;
    low = fmin(low, b->temperature[0]);
    high = fmax(high, b->temperature[0]);
    if (fits > 10) continue;
    um_orbit_time_format(spectrum[k].t_tai, time);
    snprintf(text[0], sizeof text[0], "%.2f +- %.2g", b->temperature[0], b->temperature_sigma[0]);
    snprintf(text[1], sizeof text[1], "%.4g +- %.2g", b->area[0], b->area_sigma[0]);
    printf("%-24s%6zu%24s%30s\n", time, spectrum[k].nband, text[0], text[1]);
  }
  if (fits > 10) printf("... %zu times in all\n", fits);
  printf("one grey body: %.2f to %.2f K\n", low, high);
  if (twos > 0)
    printf("two grey bodies explain more than their two parameters at %zu of %zu times\n", better,
           twos);
  printf("results in %s\n", folder);
}

static enum um_status retrieve(struct um_context *context, const struct um_model *model,
                               const struct um_compare_plan *plan,
                               const struct um_model_precomputed *precomputed,
                               const struct bands *bands, struct spectrum *spectrum)
{
  size_t fits = 0;
  for (size_t i = 0; i < plan->measurements->count; i++)
    UM_TRY(add(context, model, plan, precomputed, bands, i, spectrum));
  for (size_t k = 0; k < plan->ntime; k++) {
    UM_TRY(um_core_stop_check(context, "temperatures were retrieved"));
    UM_TRY(fit(context, &spectrum[k], 1, &spectrum[k].one));
    UM_TRY(fit(context, &spectrum[k], 2, &spectrum[k].two));
    fits += spectrum[k].one.n;
  }
  if (fits > 0) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s: at no time light in three bands of %g to %g um; accepted: "
                      "band_irradiance or radiant_intensity of three or more such bands at a time",
                      plan->measurements->path, UM_INSTRUMENT_THERMAL_FROM * 1e6,
                      UM_INSTRUMENT_THERMAL_TO * 1e6);
}

int um_app_retrieve(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_model *model = NULL;
  struct um_model_precomputed *precomputed = NULL;
  struct um_compare_measurements *measurements = NULL;
  struct um_compare_plan *plan = NULL;
  struct um_core_folder *folder = NULL;
  struct spectrum *spectrum = NULL;
  struct bands bands = {NULL, NULL};
  struct um_model_options changes = um_app_model_options(options);
  char *out = NULL;
  UM_CHECK(um_compare_measurements_read(context, options->positional[1], &measurements));
  UM_CHECK(um_model_create(context, options->positional[0], &changes, &model));
  UM_CHECK(um_compare_plan_create(context, model, measurements, &plan));
  UM_CHECK(um_app_out_folder(context, options, model->scenario->name, &out));
  UM_CHECK(um_core_folder_begin(context, out, options->force, &folder));
  UM_CHECK(um_compare_plan_trace(context, model, plan, &precomputed));
  UM_CHECK(bands_create(context, model, &bands));
  UM_CHECK(um_core_allocate(context, plan->ntime, sizeof *spectrum, &spectrum));
  UM_CHECK(retrieve(context, model, plan, precomputed, &bands, spectrum));
  UM_CHECK(write_table(context, folder, spectrum, plan->ntime));
  UM_CHECK(um_core_folder_commit(context, &folder));
  um_app_terminal_clear();
  print_summary(spectrum, plan->ntime, out);
done:
  um_core_folder_abort(&folder);
  um_core_free(context, spectrum);
  um_core_free(context, bands.edge);
  um_core_free(context, bands.bins);
  um_model_precomputed_destroy(context, &precomputed);
  um_compare_plan_destroy(context, &plan);
  um_compare_measurements_destroy(context, &measurements);
  um_model_destroy(context, &model);
  um_core_free(context, out);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
