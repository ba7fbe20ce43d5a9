/* How probable it is that a band is brighter than a limit. */
#include <math.h>
#include <string.h>

#include "base/core/csv.h"
#include "base/uncertainty/statistics.h"
#include "orbit/time.h"
#include "study/plot_impl.h"
#include "study/report.h"
#include "study/study_impl.h"

static size_t find(const struct um_study *study, const struct um_study_file_limit *limit)
{
  size_t q = 0;
  bool magnitude = !isnan(limit->brighter_than);
  for (; q < study->noutput; q++)
    if (study->output[q].kind == (magnitude ? UM_STUDY_MAGNITUDE : UM_STUDY_IRRADIANCE) &&
        strcmp(study->output[q].of, limit->of) == 0)
      break;
  return q;
}

enum um_status um_study_limits_check(struct um_context *context, const struct um_study *study)
{
  const struct um_study_file_limit *limit = study->file->limits.items;
  for (size_t i = 0; i < study->file->limits.count; i++) {
    if (isnan(limit[i].above) == isnan(limit[i].brighter_than))
      return um_document_mark_fail(context, &limit[i].at,
                                   "a limit wants one of: above [W/m2], brighter_than [mag]");
    if (find(study, &limit[i]) == study->noutput)
      return um_document_mark_fail(context, &limit[i].at,
                                   "no %s of '%.60s' among the outputs; accepted: a band of "
                                   "outputs.bands%s",
                                   isnan(limit[i].above) ? "magnitude" : "irradiance", limit[i].of,
                                   isnan(limit[i].above) ? ", with outputs.magnitudes" : "");
  }
  return UM_OK;
}

enum um_status um_study_limits_make(struct um_context *context, const struct um_study *study,
                                    struct um_study_result *result)
{
  const struct um_study_file_limit *limit = study->file->limits.items;
  result->nlimit = study->file->limits.count;
  UM_TRY(um_core_allocate(context, result->nlimit, sizeof *result->limit, &result->limit));
  for (size_t i = 0; i < result->nlimit; i++)
    result->limit[i] = (struct um_study_limit){
        .quantity = find(study, &limit[i]),
        .value = isnan(limit[i].above) ? limit[i].brighter_than : limit[i].above};
  return UM_OK;
}

static bool magnitude(const struct um_study_quantity *q) { return strcmp(q->unit, "mag") == 0; }

/* Probability at each time of the curve, probability and error [count + 1], and at any time behind
 * them. work [npoint][count + 1], with the sign of what is brighter. */
static void probabilities(const struct um_study_result *r, const struct um_study_limit *limit,
                          double *work, double *above, double *probability, double *error)
{
  const struct um_study_quantity *q = &r->quantity[limit->quantity];
  size_t n = q->count + 1;
  double sign = magnitude(q) ? -1.0 : 1.0;
  for (size_t k = 0; k < n; k++) above[k] = sign * limit->value;
  for (size_t p = 0; p < r->npoint; p++) {
    const double *value = um_study_result_values(r, p, q);
    double most = NAN;
    for (size_t k = 0; k < q->count; k++) {
      work[p * n + k] = sign * value[k];
      most = fmax(most, sign * value[k]); /* the number where one is NaN */
    }
    work[p * n + q->count] = most;
  }
  um_uncertainty_probability_above(r->npoint, n, work, NULL, above, probability, error);
}

static void put_row(const struct um_study_result *r, const struct um_study_limit *limit,
                    const char *time, double probability, double error, FILE *file)
{
  fputs(time, file);
  um_core_csv_put_text(file, r->quantity[limit->quantity].name, "");
  um_core_csv_put_exact(file, limit->value);
  um_core_csv_put_exact(file, probability);
  um_core_csv_put_exact(file, error);
  fputs("\n", file);
}

enum um_status um_study_limits_write(struct um_context *context,
                                     const struct um_study_result *result, FILE *file, FILE *words)
{
  enum um_status status;
  double *work = NULL, *row = NULL;
  size_t n = result->ntime + 1;
  UM_CHECK(um_core_allocate(context, result->npoint, n * sizeof *work, &work));
  UM_CHECK(um_core_allocate(context, 3 * n, sizeof *row, &row));
  if (file != NULL) fputs("time_utc,quantity,limit,probability,standard_error\n", file);
  for (size_t i = 0; i < result->nlimit; i++) {
    const struct um_study_limit *limit = &result->limit[i];
    const struct um_study_quantity *q = &result->quantity[limit->quantity];
    double *probability = row + n, *error = row + 2 * n;
    probabilities(result, limit, work, row, probability, error);
    for (size_t k = 0; k < q->count && file != NULL; k++) {
      char time[32];
      um_orbit_time_format(result->time[k], time);
      put_row(result, limit, time, probability[k], error[k], file);
    }
    if (file != NULL) put_row(result, limit, "", probability[q->count], error[q->count], file);
    if (words != NULL)
      fprintf(words, "%s %s %.4g %s at some time: probability %.3g +- %.1g\n", q->name,
              magnitude(q) ? "brighter than" : "above", limit->value, q->unit,
              probability[q->count], error[q->count]);
  }
done:
  UM_FREE(context, work, row);
  return status;
}

void um_study_plot_limits(struct um_plot *plot, const struct um_study_result *r)
{
  enum { WIDTH = 1000, LEFT = 104, RIGHT = 980, TOP = 92, PANEL = 240, BELOW = 58 };
  char start[32];
  if (r->nlimit == 0) return;
  um_orbit_time_format(r->time[0], start);
  struct um_plot_time time = um_plot_time(r->time[0], r->time[r->ntime - 1], start);
  um_plot_picture(plot, "limits", WIDTH, TOP + PANEL + BELOW + 20 * (int)r->nlimit);
  int top = TOP + 20 * (int)r->nlimit;
  um_plot_title(plot, r->name, "probability to be above or brighter; bands: standard error");
  um_plot_time_axis(plot, &time);
  if (r->sunlit != NULL) um_plot_shade(plot, &time, r->ntime, r->time, r->sunlit);
  um_plot_panel(plot, LEFT, top, RIGHT, top + PANEL);
  um_plot_time_label(plot, &time);
  um_plot_ylabel(plot, "", "probability");
  um_plot_add(plot, "set yrange [-0.02:1.02]\nset key vertical maxrows %zu\nplot ", r->nlimit);
  for (size_t i = 0; i < r->nlimit; i++) {
    const struct um_study_quantity *q = &r->quantity[r->limit[i].quantity];
    size_t first = 1 + i * (r->ntime + 1), last = first + r->ntime - 1;
    char words[200];
    snprintf(words, sizeof words, "%s %s %.4g %s", q->name,
             magnitude(q) ? "brighter than" : "above", r->limit[i].value, q->unit);
    um_plot_add(plot, i == 0 ? "" : ", ");
    um_plot_add(plot,
                "'limits.csv' every ::%zu::%zu using (x(1)):(column(4)-column(5)):(column(4)+"
                "column(5)) with filledcurves fillcolor rgb %s fillstyle transparent solid 0.3 "
                "notitle, '' every ::%zu::%zu using (x(1)):4 with lines linewidth 2 linecolor rgb "
                "%s title %s noenhanced",
                first, last, um_study_colour(i), first, last, um_study_colour(i), words);
  }
  um_plot_add(plot, "\n");
}
