/* report.html of a study: how far its curves are spread, who causes it when, and what each value
 * comes to. */
#include "study/page.h"

#include <math.h>
#include <string.h>

#include "orbit/time.h"
#include "study/per_point.h"
#include "study/plot_impl.h"
#include "study/rule.h"

struct work {
  struct um_page_writer *p;
  struct um_page *page; /* the writer's */
  const struct um_study_result *r;
  const struct um_study_statistics *l;
};

static enum um_status times(struct work *w)
{
  const struct um_study_result *r = w->r;
  double *t;
  UM_TRY(UM_PAGE_ROOM(w->p, r->ntime, &t));
  for (size_t k = 0; k < r->ntime; k++) t[k] = um_orbit_time_unix(r->time[k]);
  return um_page_writer_times(w->p, r->ntime, t, r->sunlit);
}

/* A parameter's index of each instant, none where nothing varies it. */
static enum um_status shares(struct work *w, const struct um_study_quantity *q,
                             struct um_page_series *series)
{
  const struct um_study_result *r = w->r;
  double quiet = um_study_quiet(w->l, q);
  for (size_t i = 0; i < r->nparameter; i++) {
    double *share;
    UM_TRY(UM_PAGE_ROOM(w->p, q->count, &share));
    for (size_t k = 0; k < q->count; k++) {
      double value = w->l->first[i * r->nvalue + q->first + k];
      bool varies = w->l->deviation[q->first + k] > quiet;
      share[k] = varies && isfinite(value) ? fmin(fmax(value, 0.0), 1.0) : 0.0;
    }
    series[i] = (struct um_page_series){
        .name = r->parameter_name[i], .role = "part", .mark = UM_PAGE_AREA, .value = share};
  }
  return UM_OK;
}

/* Quantiles of a curve, and below them who causes its variance when. */
static enum um_status curve(struct work *w, size_t index)
{
  const struct um_study_result *r = w->r;
  const struct um_study_quantity *q = &r->quantity[index];
  const double *quantile[UM_STUDY_QUANTILES];
  struct um_page_series spread[3], *share;
  const char *id;
  UM_TRY(um_page_words(w->p, &id, "curve-%zu", index + 1));
  for (size_t i = 0; i < UM_STUDY_QUANTILES; i++)
    quantile[i] = w->l->quantile + i * r->nvalue + q->first;
  spread[0] = (struct um_page_series){.name = "median, 5 to 95 % of the points",
                                      .role = "model",
                                      .value = quantile[2],
                                      .low = quantile[0],
                                      .high = quantile[4]};
  spread[1] = (struct um_page_series){.name = "25 to 75 %",
                                      .role = "model",
                                      .value = quantile[2],
                                      .low = quantile[1],
                                      .high = quantile[3]};
  if (r->nominal != NULL)
    spread[2] = (struct um_page_series){
        .name = "the scenario as it stands", .role = "before", .value = r->nominal + q->first};
  UM_TRY(UM_PAGE_ROOM(w->p, r->nparameter, &share));
  bool known = w->l->first != NULL && !q->withheld;
  if (known) UM_TRY(shares(w, q, share));
  const struct um_page_panel panel[] = {
      {.name = q->name,
       .unit = q->unit,
       .scale = strcmp(q->unit, "mag") == 0 ? UM_PAGE_MAGNITUDE : UM_PAGE_LINEAR,
       .series = spread,
       .nseries = r->nominal != NULL ? 3 : 2},
      {.name = "share of the variance",
       .unit = "1",
       .stacked = true,
       .series = share,
       .nseries = r->nparameter}};
  const struct um_page_figure figure = {.id = id, .title = q->name};
  um_page_axes(w->page, &figure, &w->p->time, w->p->shade, w->p->nshade, panel, known ? 2 : 1);
  return UM_OK;
}

static enum um_status curves(struct work *w)
{
  const struct um_study_result *r = w->r;
  bool any = false;
  for (size_t q = 0; q < r->nquantity; q++) any = any || um_study_is_curve(r, &r->quantity[q]);
  if (!any) return UM_OK;
  um_page_section(w->page, "curves", "How far are the curves spread, and what causes it when?",
                  UM_PAGE_PLAIN);
  for (size_t q = 0; q < r->nquantity && w->l->first != NULL; q++) {
    char *sentence = NULL;
    if (!um_study_is_curve(r, &r->quantity[q])) continue;
    UM_TRY(um_study_sentence(w->p->context, r, w->l, &r->quantity[q], &sentence));
    um_page_text(w->page, "%s", sentence);
    um_core_free(w->p->context, sentence);
  }
  um_page_text(w->page, "Shares are %s.", um_study_indices_words(w->l->indices));
  for (size_t q = 0; q < r->nquantity; q++)
    if (um_study_is_curve(r, &r->quantity[q])) UM_TRY(curve(w, q));
  return UM_OK;
}

/* ---- numbers of each point ---- */

static enum um_status summary(struct work *w)
{
  static const struct um_page_figure figure = {.id = "summary", .title = "Spread over the points"};
  enum { NOMINAL, MEAN, DEVIATION, LOW, MIDDLE, HIGH, ERROR, COLUMNS };
  const struct um_study_result *r = w->r;
  size_t most = r->nquantity * UM_STUDY_STATISTICS, n = 0;
  const char **name, **what, **unit;
  double *value[COLUMNS];
  UM_TRY(UM_PAGE_ROOM(w->p, most, &name));
  UM_TRY(UM_PAGE_ROOM(w->p, most, &what));
  UM_TRY(UM_PAGE_ROOM(w->p, most, &unit));
  for (int i = 0; i < COLUMNS; i++) UM_TRY(UM_PAGE_ROOM(w->p, most, &value[i]));
  for (size_t q = 0; q < r->nquantity; q++)
    for (enum um_study_statistic s = 0; s < (r->quantity[q].count > 1 ? UM_STUDY_STATISTICS : 1);
         s++) {
      struct um_study_summary spread;
      UM_TRY(um_study_summarise(w->p->context, r, &r->quantity[q], s, NULL, &spread));
      name[n] = r->quantity[q].name;
      what[n] = um_study_statistic_word(&r->quantity[q], s);
      unit[n] = r->quantity[q].unit;
      value[NOMINAL][n] = spread.nominal;
      value[MEAN][n] = spread.mean;
      value[DEVIATION][n] = spread.deviation;
      value[LOW][n] = spread.quantile[0];
      value[MIDDLE][n] = spread.quantile[2];
      value[HIGH][n] = spread.quantile[4];
      value[ERROR][n++] = r->error != NULL ? r->error[q] : (double)NAN;
    }
  const struct um_page_column columns[] = {
      {.name = "quantity", .text = name},
      {.name = "statistic", .text = what},
      {.name = "unit", .text = unit},
      {.name = "the scenario as it stands", .value = value[NOMINAL]},
      {.name = "mean", .value = value[MEAN]},
      {.name = "standard deviation", .value = value[DEVIATION]},
      {.name = "5 %", .value = value[LOW]},
      {.name = "median", .value = value[MIDDLE]},
      {.name = "95 %", .value = value[HIGH]},
      {.name = "error of the surrogate (of light relative)", .value = value[ERROR]}};
  um_page_section(w->page, "summary", "What does it come to?", UM_PAGE_PLAIN);
  um_page_table(w->page, &figure, columns, sizeof columns / sizeof columns[0], n);
  return UM_OK;
}

/* The mean of every curve, or a single value, against each parameter. */
static enum um_status against(struct work *w, size_t parameter)
{
  const struct um_study_result *r = w->r;
  struct um_page_series *series;
  struct um_page_panel *panel;
  double *x;
  const char *id;
  size_t n = 0;
  UM_TRY(UM_PAGE_ROOM(w->p, r->npoint, &x));
  UM_TRY(UM_PAGE_ROOM(w->p, r->nquantity, &series));
  UM_TRY(UM_PAGE_ROOM(w->p, r->nquantity, &panel));
  for (size_t j = 0; j < r->npoint; j++) x[j] = r->parameter[j * r->nparameter + parameter];
  for (size_t q = 0; q < r->nquantity; q++) {
    double *value;
    UM_TRY(UM_PAGE_ROOM(w->p, r->npoint, &value));
    um_study_per_point(r, &r->quantity[q], UM_STUDY_MEAN, value);
    series[n] =
        (struct um_page_series){.name = um_study_statistic_word(&r->quantity[q], UM_STUDY_MEAN),
                                .role = "model",
                                .mark = UM_PAGE_POINTS,
                                .value = value};
    panel[n] = (struct um_page_panel){
        .name = r->quantity[q].name,
        .unit = r->quantity[q].unit,
        .scale = strcmp(r->quantity[q].unit, "mag") == 0 ? UM_PAGE_MAGNITUDE : UM_PAGE_LINEAR,
        .series = &series[n],
        .nseries = 1};
    n++;
  }
  UM_TRY(um_page_words(w->p, &id, "against-%zu", parameter + 1));
  const char *unit = r->parameter_unit[parameter];
  const struct um_page_axis axis = {r->parameter_name[parameter], unit[0] != '\0' ? unit : "1",
                                    UM_PAGE_LINEAR, x, r->npoint};
  const struct um_page_figure figure = {.id = id, .title = r->parameter_name[parameter]};
  um_page_axes(w->page, &figure, &axis, NULL, 0, panel, n);
  return UM_OK;
}

static enum um_status fill(struct um_page_writer *p, const void *of)
{
  struct work whole = *(const struct work *)of, *w = &whole;
  const struct um_study_result *r = w->r;
  w->p = p;
  w->page = p->page;
  UM_TRY(times(w));
  um_page_lead(w->page, "%zu points of %s, %zu of them solved.", r->npoint, r->scenario, r->exact);
  if (r->falls_short != NULL) um_page_lead(w->page, "Warning: %s", r->falls_short);
  for (size_t i = 0; i < r->nparameter; i++) {
    double least, most;
    um_study_extent(r, i, &least, &most);
    bool none = r->parameter_unit[i][0] == '\0' || strcmp(r->parameter_unit[i], "1") == 0;
    um_page_fact(w->page, r->parameter_name[i], "%.4g to %.4g%s%s", least, most, none ? "" : " ",
                 none ? "" : r->parameter_unit[i]);
  }
  UM_TRY(curves(w));
  UM_TRY(um_study_page_surfaces(w->p, r, w->l));
  UM_TRY(summary(w));
  um_page_section(w->page, "points", "How does each value depend on each parameter?",
                  UM_PAGE_PLAIN);
  um_page_text(w->page, "Every dot is a point of the study. Of a curve its mean is shown.");
  for (size_t i = 0; i < r->nparameter; i++) UM_TRY(against(w, i));
  return UM_OK;
}

enum um_status um_study_write_page(struct um_context *context, const struct um_study_result *result,
                                   const struct um_study_statistics *statistics,
                                   struct um_core_folder *folder)
{
  const struct work of = {.r = result, .l = statistics};
  const struct um_page_head head = {
      .command = "umbra study", .kind = "study", .title = result->name};
  return um_page_report(context, &head, fill, &of, folder);
}
