/* The summary of a study on the terminal. */
#include <string.h>

#include "base/uncertainty/surrogate.h"
#include "study/per_point.h"
#include "study/report.h"
#include "study/rule.h"

#define REASONS 3 /* that are shown of points that failed */

static void failures(const struct um_study_result *r, const struct um_study_statistics *l,
                     FILE *file)
{
  size_t shown = 0;
  for (size_t i = 0; i < r->npoint && shown < REASONS; i++) {
    if (r->reason[i] == NULL) continue;
    fprintf(file, "  point %zu failed: %s\n", i, r->reason[i]);
    shown++;
  }
  if (r->npoint - l->ndone > shown)
    fprintf(file, "  and %zu more, see points.csv\n", r->npoint - l->ndone - shown);
}

static enum um_status rows(struct um_context *context, const struct um_study_result *r,
                           const struct um_study_statistics *l, FILE *file)
{
  size_t width = 8;
  for (size_t q = 0; q < r->nquantity; q++)
    if (strlen(r->quantity[q].name) > width) width = strlen(r->quantity[q].name);
  if (width > 40) width = 40;
  fprintf(file, "%-*s %-10s %11s %11s %11s %11s  %s\n", (int)width, "quantity", "statistic",
          "nominal", "5 %", "50 %", "95 %", "unit");
  for (size_t q = 0; q < r->nquantity; q++) {
    const struct um_study_quantity *of = &r->quantity[q];
    for (enum um_study_statistic s = 0; s < (of->count > 1 ? UM_STUDY_STATISTICS : 1); s++) {
      struct um_study_summary spread;
      UM_TRY(um_study_summarise(context, r, of, s, NULL, &spread));
      fprintf(file, "%-*s %-10s %11.5g %11.5g %11.5g %11.5g  %s\n", (int)width, of->name,
              um_study_statistic_word(of, s), spread.nominal, spread.quantile[0],
              spread.quantile[2], spread.quantile[4], of->unit);
    }
  }
  fprintf(file, "%s:\n", um_study_indices_words(l->indices));
  return UM_OK;
}

enum um_status um_study_report_print(struct um_context *context,
                                     const struct um_study_result *result,
                                     const struct um_study_statistics *statistics, FILE *file)
{
  failures(result, statistics, file);
  if (result->surrogate != NULL)
    fprintf(file,
            "surrogate of %zu points, %zu of them held out; %zu had no say and state its error\n",
            um_uncertainty_surrogate_evaluations(result->surrogate),
            um_uncertainty_surrogate_held_out(result->surrogate),
            um_uncertainty_surrogate_stating(result->surrogate));
  UM_TRY(rows(context, result, statistics, file));
  for (size_t q = 0; q < result->nquantity && statistics->first != NULL; q++) {
    char *sentence = NULL;
    UM_TRY(um_study_sentence(context, result, statistics, &result->quantity[q], &sentence));
    fprintf(file, "  %s\n", sentence);
    um_core_free(context, sentence);
  }
  return um_study_limits_write(context, result, NULL, file);
}
