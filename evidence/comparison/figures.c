/* How channels and their figures stand in result files. */
#include "evidence/comparison/figures.h"

#include <string.h>

#include "base/core/json.h"

void um_compare_figures(const struct um_compare_metrics *m,
                        struct um_compare_figure out[UM_COMPARE_FIGURES])
{
  const struct um_compare_figure all[UM_COMPARE_FIGURES] = {{"mean_measured", m->mean_measured},
                                                            {"mean_model", m->mean_model},
                                                            {"bias", m->bias},
                                                            {"sd", m->sd},
                                                            {"rms", m->rms},
                                                            {"rms_over_mean", m->rms_over_mean},
                                                            {"median_ratio", m->median_ratio},
                                                            {"scale", m->scale},
                                                            {"rms_scaled", m->rms_scaled},
                                                            {"correlation", m->correlation},
                                                            {"bias_mag", m->bias_mag},
                                                            {"rms_mag", m->rms_mag},
                                                            {"model_share", m->model_share},
                                                            {"chi2", m->chi2},
                                                            {"dof", m->dof},
                                                            {"chi2_red", m->chi2_reduced},
                                                            {"chi2_p", m->chi2_p},
                                                            {"durbin_watson", m->durbin_watson},
                                                            {"white_p", m->white_p}};
  memcpy(out, all, sizeof all);
}

void um_compare_json_metrics(FILE *file, const char *before, const char *name,
                             const struct um_compare_metrics *metrics)
{
  struct um_compare_figure all[UM_COMPARE_FIGURES];
  um_compare_figures(metrics, all);
  fprintf(file, "%s\"%s\": {\"count\": %zu", before, name, metrics->count);
  for (size_t i = 0; i < UM_COMPARE_FIGURES; i++)
    um_core_json_field(file, ", ", all[i].name, all[i].value);
  fputc('}', file);
}

void um_compare_json_channel(FILE *file, const struct um_compare_channel *channel)
{
  fprintf(file, "\"quantity\": \"%s\", \"of\": ", um_compare_quantity_name(channel->quantity));
  um_core_json_string(file, channel->label);
  fprintf(file, ", \"unit\": \"%s\", \"residual_unit\": \"%s\"",
          um_compare_quantity_unit(channel->quantity), um_compare_residual_unit(channel->quantity));
}

void um_compare_channel_words(const struct um_compare_channel *channel, char *out, size_t size)
{
  char quantity[64];
  snprintf(quantity, sizeof quantity, "%s", um_compare_quantity_name(channel->quantity));
  for (char *c = quantity; *c != '\0'; c++)
    if (*c == '_') *c = ' ';
  if (channel->quantity == UM_QUANTITY_MAGNITUDE_AB) strcpy(quantity, "AB magnitude");
  if (channel->quantity == UM_QUANTITY_MAGNITUDE_VEGA) strcpy(quantity, "Vega magnitude");
  snprintf(out, size, "%s %s", quantity, channel->label);
}

enum um_status um_compare_channel_file(struct um_context *context,
                                       const struct um_compare_channel *channel, char **out)
{
  UM_TRY(um_core_asprintf(context, out, "%s_%s", um_compare_quantity_name(channel->quantity),
                          channel->label));
  for (char *c = *out; *c != '\0'; c++)
    if (strchr("/\\:'\" ", *c) != NULL) *c = '_';
  return UM_OK;
}
