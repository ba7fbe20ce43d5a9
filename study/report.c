/* Statistics of a study as tables. Numbers are written with the fewest digits that read back. */
#include "study/report.h"

#include <math.h>

#include "base/core/csv.h"
#include "orbit/time.h"
#include "study/page.h"
#include "study/per_point.h"
#include "study/rule.h"
#include "study/shortfall.h"

static bool is_curve(const struct um_study_result *r, const struct um_study_quantity *q)
{
  return q->count == r->ntime && q->count > 1;
}

/* ---- summary.csv ---- */

/* Errors as stated, and as asked. */
static void put_errors(const struct um_study_result *r, size_t q, FILE *file)
{
  double asked = r->quantity[q].asked;
  um_core_csv_put_exact(file, r->error != NULL ? r->error[q] : NAN);
  um_core_csv_put_exact(file, asked > 0.0 ? asked : NAN);
}

static enum um_status summary(struct um_context *context, const struct um_study_result *r,
                              const struct um_study_statistics *l, FILE *file)
{
  fputs("quantity,statistic,unit,points,nominal,mean,standard_deviation,q05,q25,q50,q75,q95", file);
  for (size_t i = 0; i < r->nparameter; i++) {
    fputs(",share:", file);
    um_core_csv_put(file, r->parameter_name[i], "");
  }
  fputs(",error,error_asked\n", file);
  for (size_t q = 0; q < r->nquantity; q++) {
    const struct um_study_quantity *of = &r->quantity[q];
    for (enum um_study_statistic s = 0; s < (of->count > 1 ? UM_STUDY_STATISTICS : 1); s++) {
      struct um_study_summary spread;
      UM_TRY(um_study_summarise(context, r, of, s, NULL, &spread));
      um_core_csv_put(file, of->name, "");
      fputs(",", file);
      fprintf(file, "%s,", um_study_statistic_word(of, s));
      um_core_csv_put(file, of->unit, "");
      fprintf(file, ",%zu", um_study_points_of(r, of));
      um_core_csv_put_exact(file, spread.nominal);
      um_core_csv_put_exact(file, spread.mean);
      um_core_csv_put_exact(file, spread.deviation);
      for (size_t p = 0; p < UM_STUDY_QUANTILES; p++)
        um_core_csv_put_exact(file, spread.quantile[p]);
      for (size_t i = 0; i < r->nparameter; i++)
        um_core_csv_put_exact(
            file, s == 0 && l->over_curve != NULL ? l->over_curve[i * r->nquantity + q] : NAN);
      put_errors(r, q, file);
      fputs("\n", file);
    }
  }
  return UM_OK;
}

/* ---- curves.csv, indices.csv ---- */

static void curves(const struct um_study_result *r, const struct um_study_statistics *l, FILE *file)
{
  fputs("time_utc,quantity,unit,nominal,mean,standard_deviation,q05,q25,q50,q75,q95\n", file);
  for (size_t q = 0; q < r->nquantity; q++) {
    const struct um_study_quantity *of = &r->quantity[q];
    for (size_t k = 0; k < of->count && is_curve(r, of); k++) {
      char time[32];
      size_t at = of->first + k;
      um_orbit_time_format(r->time[k], time);
      fprintf(file, "%s,", time);
      um_core_csv_put(file, of->name, "");
      um_core_csv_put_text(file, of->unit, "");
      um_core_csv_put_exact(file, r->nominal == NULL ? NAN : r->nominal[at]);
      um_core_csv_put_exact(file, l->mean[at]);
      um_core_csv_put_exact(file, l->deviation[at]);
      for (size_t p = 0; p < UM_STUDY_QUANTILES; p++)
        um_core_csv_put_exact(file, l->quantile[p * r->nvalue + at]);
      fputs("\n", file);
    }
  }
}

/* One row an instant, columns in fours for each parameter, so that a picture stacks them. */
static void indices(const struct um_study_result *r, const struct um_study_statistics *l,
                    FILE *file)
{
  static const char *const column[] = {"first", "first_error", "total", "correlation"};
  const double *const from[] = {l->first, l->first_error, l->total, l->correlation};
  fputs("time_utc,quantity,standard_deviation", file);
  for (size_t i = 0; i < r->nparameter; i++)
    for (size_t c = 0; c < 4; c++) {
      fprintf(file, ",%s:", column[c]);
      um_core_csv_put(file, r->parameter_name[i], "");
    }
  fputs("\n", file);
  for (size_t q = 0; q < r->nquantity; q++) {
    const struct um_study_quantity *of = &r->quantity[q];
    for (size_t k = 0; k < of->count && is_curve(r, of); k++) {
      char time[32];
      um_orbit_time_format(r->time[k], time);
      fprintf(file, "%s,", time);
      um_core_csv_put(file, of->name, "");
      um_core_csv_put_exact(file, l->deviation[of->first + k]);
      for (size_t i = 0; i < r->nparameter; i++)
        for (size_t c = 0; c < 4; c++)
          um_core_csv_put_exact(file,
                                from[c] == NULL ? NAN : from[c][i * r->nvalue + of->first + k]);
      fputs("\n", file);
    }
  }
}

/* ---- table.md ---- */

static void cell(FILE *file, const char *text)
{
  for (; *text != '\0'; text++) {
    if (*text == '|') fputc('\\', file);
    fputc(*text == '\n' || *text == '\r' ? ' ' : *text, file);
  }
}

static void number(FILE *file, double value)
{
  if (isfinite(value))
    fprintf(file, " %.4g |", value);
  else
    fputs(" - |", file);
}

/* What falls short, a paragraph a line. */
static enum um_status shortfall(struct um_context *context, const struct um_study_result *r,
                                FILE *file)
{
  char *text = NULL;
  UM_TRY(um_study_shortfall(context, r, &text));
  if (text != NULL) fputs("\n", file);
  for (const char *at = text; at != NULL && *at != '\0'; at++) {
    if (*at == '|') fputc('\\', file);
    fputc(*at, file);
    if (*at == '\n') fputc('\n', file);
  }
  if (text != NULL) fputs("\n", file);
  um_core_free(context, text);
  return UM_OK;
}

static enum um_status table(struct um_context *context, const struct um_study_result *r,
                            const struct um_study_statistics *l, FILE *file)
{
  fputs("| quantity | unit | nominal | median | 5 % | 95 % |", file);
  for (size_t i = 0; i < r->nparameter; i++) {
    fputs(" ", file);
    cell(file, r->parameter_name[i]);
    fputs(" [%] |", file);
  }
  fputs("\n|---|---|--:|--:|--:|--:|", file);
  for (size_t i = 0; i < r->nparameter; i++) fputs("--:|", file);
  fputs("\n", file);
  for (size_t q = 0; q < r->nquantity; q++) {
    const struct um_study_quantity *of = &r->quantity[q];
    struct um_study_summary spread;
    UM_TRY(um_study_summarise(context, r, of, UM_STUDY_MEAN, NULL, &spread));
    fputs("| ", file);
    cell(file, of->name);
    fputs(of->count > 1 ? ", mean | " : " | ", file);
    cell(file, of->unit);
    fputs(" |", file);
    number(file, spread.nominal);
    number(file, spread.quantile[2]);
    number(file, spread.quantile[0]);
    number(file, spread.quantile[4]);
    for (size_t i = 0; i < r->nparameter; i++) {
      double share = l->over_curve == NULL ? NAN : l->over_curve[i * r->nquantity + q];
      if (isfinite(share))
        fprintf(file, " %.0f |", fmax(100.0 * share, 0.0)); /* sampled ones may be -0.4 % */
      else
        fputs(" - |", file);
    }
    fputs("\n", file);
  }
  fprintf(file,
          "\n%zu points; of curves the mean over time; last columns: share of the variance of "
          "the curve, %s.\n",
          l->ndone, um_study_indices_words(l->indices));
  UM_TRY(shortfall(context, r, file));
  for (size_t q = 0; q < r->nquantity; q++) {
    char *sentence = NULL;
    if (!is_curve(r, &r->quantity[q])) continue;
    UM_TRY(um_study_sentence(context, r, l, &r->quantity[q], &sentence));
    fputs("\n", file);
    cell(file, sentence);
    fputs("\n", file);
    um_core_free(context, sentence);
  }
  return UM_OK;
}

/* ---- all ---- */

static enum um_status end(struct um_context *context, const char *name, enum um_status written,
                          FILE **file)
{
  enum um_status closed = um_core_file_close(context, name, file);
  return written != UM_OK ? written : closed;
}

enum um_status um_study_report_write(struct um_context *context,
                                     const struct um_study_result *result,
                                     const struct um_study_statistics *statistics,
                                     struct um_core_folder *folder)
{
  FILE *file = NULL;
  UM_TRY(um_core_folder_open(context, folder, "summary.csv", &file));
  UM_TRY(end(context, "summary.csv", summary(context, result, statistics, file), &file));
  UM_TRY(um_core_folder_open(context, folder, "curves.csv", &file));
  curves(result, statistics, file);
  UM_TRY(end(context, "curves.csv", UM_OK, &file));
  UM_TRY(um_core_folder_open(context, folder, "indices.csv", &file));
  indices(result, statistics, file);
  UM_TRY(end(context, "indices.csv", UM_OK, &file));
  if (result->nlimit > 0) {
    UM_TRY(um_core_folder_open(context, folder, "limits.csv", &file));
    UM_TRY(end(context, "limits.csv", um_study_limits_write(context, result, file, NULL), &file));
  }
  UM_TRY(um_core_folder_open(context, folder, "table.md", &file));
  UM_TRY(end(context, "table.md", table(context, result, statistics, file), &file));
  return um_study_write_page(context, result, statistics, folder);
}
