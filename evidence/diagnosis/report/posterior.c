/* Draws from a posterior as tables, and in diagnosis.json. */
#include <math.h>

#include "base/core/csv.h"
#include "base/core/json.h"
#include "evidence/diagnosis/report/channels.h"
#include "evidence/diagnosis/report/report_impl.h"
#include "evidence/diagnosis/value_text.h"
#include "evidence/measurements/time_text.h"

/* A row a draw: its weight, then the parameters, whose names carry their units. */
static void write_draws(const struct um_diagnosis *d, FILE *file)
{
  const struct um_diagnosis_posterior *p = d->posterior;
  char name[160];
  fputs("weight", file);
  for (size_t k = 0; k < p->nfitted; k++) {
    um_diagnosis_fitted_text(&d->fitted[k], name);
    um_core_csv_put_text(file, name, "");
  }
  fputc('\n', file);
  for (size_t i = 0; i < p->n; i++) {
    fprintf(file, "%.9g", p->weight[i]);
    for (size_t k = 0; k < p->nfitted; k++)
      um_core_csv_put_number(file, p->value[i * p->nfitted + k]);
    fputc('\n', file);
  }
}

/* The rows of fit.csv. Of magnitudes the fainter end is the higher number. */
static enum um_status write_curves(struct um_context *context, const struct um_diagnosis *d,
                                   FILE *file)
{
  const struct um_diagnosis_posterior *p = d->posterior;
  fputs("time_utc,quantity,of,low_5,median,high_95\n", file);
  for (size_t c = 0; c < d->forward->measurements->nchannel; c++) {
    const struct um_compare_channel *channel = um_diagnosis_report_channel(d, c);
    bool magnitude = um_compare_is_magnitude(channel->quantity);
    size_t *row, n;
    UM_TRY(um_diagnosis_report_channel_rows(context, d, c, &row, &n));
    for (size_t i = 0; i < n; i++) {
      char time[40];
      um_compare_time_text(d->forward->observations.t[row[i]], time);
      fprintf(file, "%s,%s,", time, um_compare_quantity_name(channel->quantity));
      um_core_csv_put(file, channel->label, "");
      for (size_t b = 0; b < UM_DIAGNOSIS_BAND; b++) {
        size_t of = magnitude ? UM_DIAGNOSIS_BAND - 1 - b : b;
        um_core_csv_put_number(
            file,
            um_diagnosis_report_in_unit(channel->quantity, p->band[of * p->nobservation + row[i]]));
      }
      fputc('\n', file);
    }
    um_core_free(context, row);
  }
  return UM_OK;
}

enum um_status um_diagnosis_report_posterior_write(struct um_context *context,
                                                   const struct um_diagnosis *d,
                                                   struct um_core_folder *folder)
{
  FILE *file;
  if (d->posterior == NULL) return UM_OK;
  UM_TRY(um_core_folder_open(context, folder, "posterior.csv", &file));
  write_draws(d, file);
  UM_TRY(um_core_file_close(context, "posterior.csv", &file));
  UM_TRY(um_core_folder_open(context, folder, "posterior_curves.csv", &file));
  enum um_status status = write_curves(context, d, file);
  enum um_status closed = um_core_file_close(context, "posterior_curves.csv", &file);
  return status != UM_OK ? status : closed;
}

/* ---- diagnosis.json ---- */

static const char *const quantile[UM_DIAGNOSIS_QUANTILES] = {"low_95", "low_68", "median",
                                                             "high_68", "high_95"};

/* Members of an object, at the quantiles; null where they cannot be stated. scale: of the
 * parameter, or of the whole that it makes. */
static void json_quantiles(FILE *file, const struct um_diagnosis *d, size_t k, bool whole)
{
  const struct um_diagnosis_posterior *p = d->posterior;
  const struct um_diagnosis_fitted *f = &d->fitted[k];
  double at[UM_DIAGNOSIS_QUANTILES];
  for (size_t q = 0; q < UM_DIAGNOSIS_QUANTILES; q++) {
    struct um_diagnosis_whole of;
    at[q] = p->quantile[q * p->nfitted + k];
    if (whole &&
        um_diagnosis_whole_find(d->forward, f->effect, f->target, f->parameter, at[q], NAN, &of))
      at[q] = of.value;
  }
  bool falls = at[0] > at[UM_DIAGNOSIS_QUANTILES - 1]; /* a whole may fall as its parameter rises */
  for (size_t q = 0; q < UM_DIAGNOSIS_QUANTILES; q++)
    um_core_json_field(file, q > 0 ? ", " : "", quantile[q],
                       p->sound ? at[falls ? UM_DIAGNOSIS_QUANTILES - 1 - q : q] : (double)NAN);
}

static void json_parameter(FILE *file, const struct um_diagnosis *d, size_t k)
{
  const struct um_diagnosis_fitted *f = &d->fitted[k];
  struct um_diagnosis_whole whole;
  um_diagnosis_report_json_use(file, d, f->effect, f->target);
  um_core_json_text(file, ", ", "name", f->effect->parameters[f->parameter].name);
  um_core_json_text(file, ", ", "unit", f->effect->parameters[f->parameter].unit);
  um_core_json_bool(file, ", ", "nuisance", f->nuisance);
  fputs(", ", file);
  json_quantiles(file, d, k, false);
  if (um_diagnosis_whole_find(d->forward, f->effect, f->target, f->parameter, f->value, NAN,
                              &whole)) {
    um_core_json_text(file, ", \"whole\": {", "what", whole.what);
    um_core_json_text(file, ", ", "unit", whole.unit);
    um_core_json_field(file, ", ", "instead_of", whole.instead_of);
    fputs(", ", file);
    json_quantiles(file, d, k, true);
    fputc('}', file);
  }
}

static void json_ties(FILE *file, const struct um_diagnosis *d)
{
  fputs(",\n  \"only_together\": [", file);
  for (size_t i = 0; i < d->ntie; i++) {
    const struct um_diagnosis_tie *t = &d->tie[i];
    char a[160], b[160], words[640];
    um_diagnosis_fitted_text(&d->fitted[t->a], a);
    um_diagnosis_fitted_text(&d->fitted[t->b], b);
    um_diagnosis_tie_text(d->fitted, t, words);
    um_core_json_text(file, i > 0 ? ",\n    {" : "\n    {", "first", a);
    um_core_json_text(file, ", ", "second", b);
    um_core_json_field(file, ", ", "correlation", t->correlation);
    um_core_json_bool(file, ", ", "product", t->product);
    um_core_json_field(file, ", ", "power", t->power);
    um_core_json_field(file, ", ", "value", t->value);
    um_core_json_field(file, ", ", "sigma", t->sigma);
    um_core_json_text(file, ", ", "sentence", words);
    fputc('}', file);
  }
  fputc(']', file);
}

void um_diagnosis_report_json_posterior(FILE *file, const struct um_diagnosis *d)
{
  const struct um_diagnosis_posterior *p = d->posterior;
  json_ties(file, d);
  fputs(",\n  \"posterior\": ", file);
  if (p == NULL) {
    fputs("null", file);
    return;
  }
  fprintf(file, "{\"draws\": %zu, \"seed\": %llu", p->n, (unsigned long long)p->seed);
  um_core_json_field(file, ", ", "effective_draws", p->effective);
  um_core_json_field(file, ", ", "tail", p->tail);
  um_core_json_bool(file, ", ", "sound", p->sound);
  fputs(", \"parameters\": [", file);
  for (size_t k = 0; k < p->nfitted; k++) {
    fputs(k > 0 ? ",\n    {" : "\n    {", file);
    json_parameter(file, d, k);
    fputc('}', file);
  }
  fputs("]}", file);
}
