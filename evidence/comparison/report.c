/* compare.json, metrics.csv and residuals.csv. */
#include "evidence/comparison/report.h"

#include <math.h>
#include <stdio.h>

#include "base/core/csv.h"
#include "base/core/json.h"
#include "evidence/comparison/figures.h"
#include "evidence/comparison/page.h"
#include "evidence/comparison/plot.h"
#include "evidence/measurements/time_text.h"

#define ALL_LABEL "all"

static const struct um_compare_channel *channel_of(const struct um_compare_comparison *c, size_t i)
{
  return &c->run.plan->measurements->channel[c->channel[i].channel];
}

/* --- compare.json ---------------------------------------------------------------------------- */

static void json_shares(FILE *file, const char *key, const struct um_compare_share *share, size_t n)
{
  fprintf(file, ", \"%s\": {", key);
  for (size_t i = 0; i < n; i++) {
    fputs(i > 0 ? ", " : "", file);
    um_core_json_string(file, share[i].name);
    fputs(": ", file);
    um_core_json_number(file, share[i].value);
  }
  fputc('}', file);
}

static void json_interval(FILE *file, const struct um_compare_interval *w, bool heat)
{
  char from[40], to[40];
  um_compare_time_text(w->from, from);
  um_compare_time_text(w->to, to);
  fprintf(file, "{\"from_utc\": \"%s\", \"to_utc\": \"%s\", \"count\": %zu", from, to, w->count);
  um_core_json_field(file, ", ", "chi2", w->chi2);
  um_core_json_field(file, ", ", "bias", w->bias);
  um_core_json_field(file, ", ", "mean_measured", w->mean_measured);
  um_core_json_field(file, ", ", "sunlit_fraction", w->sunlit);
  json_shares(file, heat ? "heat_W" : "mechanism_W_sr", w->mechanism, w->nmechanism);
  if (!heat) json_shares(file, "material_W_sr", w->material, w->nmaterial);
  fputc('}', file);
}

static void json_correlations(FILE *file, const struct um_compare_channel_comparison *channel)
{
  fputs(",\n     \"correlations\": [", file);
  for (size_t j = 0; j < channel->ncorrelation; j++) {
    const struct um_compare_correlation *r = &channel->correlation[j];
    um_core_json_text(file, j > 0 ? ",\n       {" : "\n       {", "coordinate", r->name);
    fprintf(file, ", \"count\": %zu", r->count);
    um_core_json_field(file, ", ", "correlation", r->value);
    um_core_json_field(file, ", ", "p", r->p);
    fputc('}', file);
  }
  fputc(']', file);
}

static void json_channel(FILE *file, const struct um_compare_comparison *c, size_t i)
{
  const struct um_compare_channel_comparison *channel = &c->channel[i];
  enum um_compare_quantity quantity = channel_of(c, i)->quantity;
  fprintf(file, "%s\n    {", i > 0 ? "," : "");
  um_compare_json_channel(file, channel_of(c, i));
  fprintf(file, ", \"left_out\": %zu,\n", channel->left_out);
  um_compare_json_metrics(file, "     \"metrics\": {\n       ", ALL_LABEL, &channel->all);
  for (int s = 0; s < UM_SEGMENT_COUNT; s++)
    if (channel->segment[s].count > 0)
      um_compare_json_metrics(file, ",\n       ",
                              um_compare_segment_name((enum um_compare_segment)s),
                              &channel->segment[s]);
  fputs("},\n     \"worst\": [", file);
  for (size_t w = 0; w < channel->nworst; w++) {
    fputs(w > 0 ? ",\n       " : "\n       ", file);
    json_interval(file, &channel->worst[w], quantity == UM_QUANTITY_TEMPERATURE);
  }
  fputc(']', file);
  json_correlations(file, channel);
  fputc('}', file);
}

void um_compare_write_json(const struct um_compare_comparison *comparison, const char *command,
                           const char *version, FILE *file)
{
  const struct um_compare_comparison *c = comparison;
  um_core_json_text(file, "{\n  ", "scenario", c->run.model->scenario->name);
  um_core_json_text(file, ",\n  ", "measurements", c->run.plan->measurements->path);
  um_core_json_text(file, ",\n  ", "command", command);
  um_core_json_text(file, ",\n  ", "version", version);
  um_core_json_field(file, ",\n  ", "chi2", c->chi2);
  um_core_json_field(file, ", ", "dof", c->dof);
  um_core_json_field(file, ", ", "chi2_red", c->chi2_reduced);
  um_core_json_field(file, ",\n  ", "model_share", c->model_share);
  fprintf(file, ", \"optics_samples\": %d, \"optics_samples_of_scenario\": %d", c->samples,
          c->samples_before);
  fputs(",\n  \"channels\": [", file);
  for (size_t i = 0; i < c->nchannel; i++) json_channel(file, c, i);
  fputs("]\n}\n", file);
}

/* --- tables ---------------------------------------------------------------------------------- */

static void csv_metrics(FILE *file, const struct um_compare_channel *channel, const char *segment,
                        const struct um_compare_metrics *m)
{
  struct um_compare_figure all[UM_COMPARE_FIGURES];
  um_compare_figures(m, all);
  fprintf(file, "%s,", um_compare_quantity_name(channel->quantity));
  um_core_csv_put(file, channel->label, "");
  fprintf(file, ",%s,%s,%zu", segment, um_compare_residual_unit(channel->quantity), m->count);
  for (size_t i = 0; i < UM_COMPARE_FIGURES; i++) um_core_csv_put_number(file, all[i].value);
  fputc('\n', file);
}

static void write_metrics(const struct um_compare_comparison *c, FILE *file)
{
  struct um_compare_figure all[UM_COMPARE_FIGURES];
  um_compare_figures(&(struct um_compare_metrics){0}, all);
  fputs("quantity,of,segment,unit,count", file);
  for (size_t i = 0; i < UM_COMPARE_FIGURES; i++) fprintf(file, ",%s", all[i].name);
  fputc('\n', file);
  for (size_t i = 0; i < c->nchannel; i++) {
    csv_metrics(file, channel_of(c, i), ALL_LABEL, &c->channel[i].all);
    for (int s = 0; s < UM_SEGMENT_COUNT; s++)
      if (c->channel[i].segment[s].count > 0)
        csv_metrics(file, channel_of(c, i), um_compare_segment_name((enum um_compare_segment)s),
                    &c->channel[i].segment[s]);
  }
}

static void residual_row(const struct um_compare_comparison *c, size_t row, FILE *file)
{
  const struct um_compare_measurements *m = c->run.plan->measurements;
  const struct um_compare_measurement *r = &m->row[row];
  const struct um_compare_residual *of = &c->residual[row];
  size_t k = c->run.plan->observation[row];
  char time[40];
  um_compare_time_text(r->t_tai, time);
  fprintf(file, "%s,%s,", time, um_compare_quantity_name(m->channel[r->channel].quantity));
  um_core_csv_put(file, m->channel[r->channel].label, "");
  um_core_csv_put_number(file, r->value);
  um_core_csv_put_number(file, c->model[row]);
  um_core_csv_put_number(file, r->sigma);
  um_core_csv_put_number(file, of->measured - of->model);
  um_core_csv_put_number(file, isnan(of->sigma) ? (double)NAN : um_compare_residual_normalised(of));
  fprintf(file, ",%s,%s", um_compare_segment_name(c->light[k]),
          um_compare_segment_name(c->motion[k]));
  um_core_csv_put_number(file, of->model_sigma);
  for (size_t j = 0; j < c->coordinates->count; j++)
    um_core_csv_put_number(file, c->coordinates->coordinate[j].value[k]);
  fputc('\n', file);
}

/* Channel after channel, each in order of time; rows that are left out do not appear. */
static void write_residuals(const struct um_compare_comparison *c, FILE *file)
{
  fputs("time_utc,quantity,of,measured,model,sigma,residual,residual_in_sigma,light,motion,model_"
        "sigma",
        file);
  for (size_t j = 0; j < c->coordinates->count; j++)
    um_core_csv_put_text(file, c->coordinates->coordinate[j].name, "");
  fputc('\n', file);
  for (size_t i = 0; i < c->nchannel; i++)
    for (size_t r = 0; r < c->channel[i].count; r++) residual_row(c, c->channel[i].row[r], file);
}

enum um_status um_compare_write(struct um_context *context,
                                const struct um_compare_comparison *comparison, const char *command,
                                const char *version, bool pictures, struct um_core_folder *folder)
{
  FILE *file;
  UM_TRY(um_core_folder_open(context, folder, "compare.json", &file));
  um_compare_write_json(comparison, command, version, file);
  UM_TRY(um_core_file_close(context, "compare.json", &file));
  UM_TRY(um_core_folder_open(context, folder, "metrics.csv", &file));
  write_metrics(comparison, file);
  UM_TRY(um_core_file_close(context, "metrics.csv", &file));
  UM_TRY(um_core_folder_open(context, folder, "residuals.csv", &file));
  write_residuals(comparison, file);
  UM_TRY(um_core_file_close(context, "residuals.csv", &file));
  if (pictures) UM_TRY(um_compare_plot(context, comparison, um_core_folder_path(folder)));
  return um_compare_write_page(context, comparison, command, folder);
}
