/* One number of a curve per point, and its spread. */
#include "study/per_point.h"

#include <math.h>
#include <string.h>

#include "base/uncertainty/statistics.h"

static bool magnitude(const struct um_study_quantity *quantity)
{
  return strcmp(quantity->unit, "mag") == 0;
}

const char *um_study_statistic_word(const struct um_study_quantity *quantity,
                                    enum um_study_statistic statistic)
{
  if (quantity->count == 1) return "value";
  if (statistic == UM_STUDY_MEAN) return "mean";
  return magnitude(quantity) ? "brightest" : "largest";
}

double um_study_statistic_of(const struct um_study_quantity *quantity, const double *value,
                             enum um_study_statistic statistic)
{
  double sum = 0.0, count = 0.0, most = NAN, sign = magnitude(quantity) ? -1.0 : 1.0;
  for (size_t k = 0; k < quantity->count; k++) {
    if (isnan(value[k])) continue;
    sum += value[k];
    count += 1.0;
    if (!(sign * value[k] <= sign * most)) most = value[k];
  }
  if (statistic == UM_STUDY_LARGEST) return most;
  return count > 0.0 ? sum / count : NAN;
}

void um_study_per_point(const struct um_study_result *result,
                        const struct um_study_quantity *quantity, enum um_study_statistic statistic,
                        double *out)
{
  for (size_t i = 0; i < result->npoint; i++)
    out[i] =
        um_study_statistic_of(quantity, um_study_result_values(result, i, quantity), statistic);
}

enum um_status um_study_summarise(struct um_context *context, const struct um_study_result *result,
                                  const struct um_study_quantity *quantity,
                                  enum um_study_statistic statistic, const double *weight,
                                  struct um_study_summary *out)
{
  double *value = NULL;
  UM_TRY(um_core_allocate(context, result->npoint, sizeof *value, &value));
  um_study_per_point(result, quantity, statistic, value);
  out->nominal =
      result->nominal == NULL
          ? NAN
          : um_study_statistic_of(quantity, result->nominal + quantity->first, statistic);
  um_uncertainty_mean(result->npoint, 1, value, weight, &out->mean, &out->deviation);
  enum um_status status =
      um_uncertainty_quantiles(context, result->npoint, 1, value, weight, UM_STUDY_QUANTILES,
                               um_study_quantile, out->quantile);
  um_core_free(context, value);
  return status;
}
