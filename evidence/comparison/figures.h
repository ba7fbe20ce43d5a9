/* How channels and their figures stand in result files, once for comparisons and diagnoses. Errors
 * of writing are the stream's. */
#ifndef UMBRA_COMPARE_FIGURES_H
#define UMBRA_COMPARE_FIGURES_H

#include <stdio.h>

#include "evidence/comparison/metrics.h"
#include "evidence/measurements/set.h"

/* Name, as in JSON and in headers of tables, and value of every figure but the count. */
struct um_compare_figure {
  const char *name;
  double value;
};
#define UM_COMPARE_FIGURES 19
void um_compare_figures(const struct um_compare_metrics *metrics,
                        struct um_compare_figure out[UM_COMPARE_FIGURES]);
/* before "name": {"count": 3, "mean_measured": ...} */
void um_compare_json_metrics(FILE *file, const char *before, const char *name,
                             const struct um_compare_metrics *metrics);
/* "quantity": ..., "of": ..., "unit": ..., "residual_unit": ... without braces. */
void um_compare_json_channel(FILE *file, const struct um_compare_channel *channel);

/* "band irradiance lwir", "AB magnitude vis" for a person. */
void um_compare_channel_words(const struct um_compare_channel *channel, char *out, size_t size);
/* The names of a channel as a file name: "band_irradiance_lwir"; the caller frees. */
enum um_status um_compare_channel_file(struct um_context *context,
                                       const struct um_compare_channel *channel, char **out);

#endif
