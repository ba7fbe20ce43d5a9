/* Pictures of what a diagnosis found: the ranking of the candidates, the history of missing heat.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/inference/distributions.h"
#include "evidence/comparison/shade.h"
#include "evidence/diagnosis/report/channels.h"
#include "evidence/diagnosis/report/report_impl.h"
#include "evidence/diagnosis/value_text.h"

#define BARS 15

/* Pixels. */
#define WIDTH UM_DIAGNOSIS_PLOT_WIDTH
#define LEFT  230
#define RIGHT 580
#define TOP   74
#define BAR   30
#define BELOW 112

static const char *const role_colour[UM_DIAGNOSIS_BAR_ROLES] = {
    [UM_DIAGNOSIS_BAR_LINEAR] = "#d5d9e0",
    [UM_DIAGNOSIS_BAR_FITTED] = "#8f98a8",
    [UM_DIAGNOSIS_BAR_TIED] = "#e8a33d",
    [UM_DIAGNOSIS_BAR_WINNER] = "#1f4e9c"};

/* The candidate as the first step fitted it: the winner, those that cannot be told from it, and
 * those that are worse. */
static struct um_diagnosis_report_bar bar_of(const struct um_diagnosis *d,
                                             const struct um_diagnosis_alternative *score)
{
  struct um_diagnosis_report_bar bar = {score, NULL, UM_DIAGNOSIS_BAR_LINEAR};
  for (size_t i = 0; d->nstep > 0 && i < d->step[0].nalternative; i++) {
    const struct um_diagnosis_alternative *alternative = &d->step[0].alternative[i];
    if (alternative->candidate != score->candidate) continue;
    if (alternative->fitted && isfinite(alternative->bic)) bar.fit = alternative;
    bar.role = d->step[0].candidate == alternative->candidate ? UM_DIAGNOSIS_BAR_WINNER
               : alternative->indistinguishable               ? UM_DIAGNOSIS_BAR_TIED
               : bar.fit != NULL                              ? UM_DIAGNOSIS_BAR_FITTED
                                                              : UM_DIAGNOSIS_BAR_LINEAR;
  }
  return bar;
}

/* The winner, fits by BIC, linear models by what they explain. */
static int by_evidence(const void *a, const void *b)
{
  const struct um_diagnosis_report_bar *x = a, *y = b;
  if ((x->role == UM_DIAGNOSIS_BAR_WINNER) != (y->role == UM_DIAGNOSIS_BAR_WINNER))
    return x->role == UM_DIAGNOSIS_BAR_WINNER ? -1 : 1;
  if ((x->fit == NULL) != (y->fit == NULL)) return x->fit == NULL ? 1 : -1;
  if (x->fit != NULL && x->fit->bic != y->fit->bic) return x->fit->bic < y->fit->bic ? -1 : 1;
  double p = x->score->score.statistic, q = y->score->score.statistic;
  if (p != q) return p < q ? 1 : -1;
  return x->score->candidate < y->score->candidate ? -1 : 1;
}

enum um_status um_diagnosis_report_bars(struct um_context *context, const struct um_diagnosis *d,
                                        struct um_diagnosis_report_bar **out, size_t *shown,
                                        size_t *tested)
{
  struct um_diagnosis_report_bar *bar;
  *tested = 0;
  UM_TRY(um_core_allocate(context, d->nranking, sizeof *bar, &bar));
  for (size_t i = 0; i < d->nranking; i++)
    if (!d->ranking[i].score.absorbed && isfinite(d->ranking[i].score.statistic))
      bar[(*tested)++] = bar_of(d, &d->ranking[i]);
  qsort(bar, *tested, sizeof *bar, by_evidence);
  *shown = *tested < BARS ? *tested : BARS;
  *out = bar;
  return UM_OK;
}

/* Chi-square of one parameter that is as rare as `level` among n tests (Sidak). */
static double threshold(double level, size_t n)
{
  double p = 1.0 - pow(1.0 - level, 1.0 / (double)(n > 0 ? n : 1)), low = 0.0, high = 1000.0;
  for (int i = 0; i < 60; i++) {
    double middle = 0.5 * (low + high);
    if (um_inference_chi2_q(middle, 1.0) > p)
      low = middle;
    else
      high = middle;
  }
  return low;
}

/* What a bar explains of the baseline's chi-square. */
double um_diagnosis_report_explained(const struct um_diagnosis *d,
                                     const struct um_diagnosis_report_bar *bar)
{
  return fmax(bar->fit != NULL ? d->chi2 - bar->fit->chi2 : bar->score->score.statistic, 0.0);
}

/* "power_W 4.2 ± 0.3" of the first parameter, "" of a switch. */
void um_diagnosis_report_bar_text(const struct um_diagnosis *d,
                                  const struct um_diagnosis_report_bar *bar, char out[160])
{
  const struct um_sensitivity_candidate *candidate =
      um_diagnosis_report_candidate_of(d, bar->score);
  out[0] = '\0';
  if (candidate->is_switch || candidate->ncolumn == 0) return;
  size_t k = candidate->parameter[0];
  const struct um_effect_parameter *parameter = &candidate->effect->parameters[k];
  double value, sigma;
  char text[80];
  if (bar->fit != NULL) {
    value = bar->fit->value[k];
    sigma = bar->fit->sigma[k];
  } else {
    um_diagnosis_report_estimate(candidate, &bar->score->score, 0, &value, &sigma);
  }
  um_diagnosis_value_text(value, sigma, "±", text);
  bool within = value >= parameter->minimum && value <= parameter->maximum;
  bool bound = bar->fit != NULL && (value == parameter->minimum || value == parameter->maximum);
  snprintf(out, 160, "%.60s %s%s", parameter->name, within ? text : "beyond its range",
           bound ? ", at its bound" : "");
}

/* What stands behind a bar. */
static void caption(const struct um_diagnosis *d, const struct um_diagnosis_report_bar *bar,
                    char out[240])
{
  char text[160];
  um_diagnosis_report_bar_text(d, bar, text);
  if (bar->fit == NULL)
    snprintf(out, 240, "linear model %.4g   %s", bar->score->score.statistic, text);
  else if (bar->role == UM_DIAGNOSIS_BAR_WINNER)
    snprintf(out, 240, "BIC %+.4g against the baseline   %s", d->step[0].delta_bic, text);
  else
    snprintf(out, 240, "BIC %s%+.4g   %s", bar->fit->converged ? "" : "up to ",
             bar->fit->bic - d->step[0].alternative[0].bic, text);
}

static void put_bars(const struct um_diagnosis *d, const struct um_diagnosis_report_bar *bar,
                     size_t shown, struct um_plot *plot)
{
  um_plot_add(plot, "$ranking << EOD\n");
  for (size_t i = 0; i < shown; i++)
    um_plot_add(plot, "%zu,%.6g,%.6g,%u\n", i, um_diagnosis_report_explained(d, &bar[i]),
                bar[i].score->score.statistic,
                (unsigned)strtoul(role_colour[bar[i].role] + 1, NULL, 16));
  um_plot_add(plot, "EOD\n");
  for (size_t i = 0; i < shown; i++) {
    char text[240];
    caption(d, &bar[i], text);
    um_plot_add(plot, "set label %zu %s at graph -0.02, first %zu right font ',10' noenhanced\n",
                2 * i + 1, um_diagnosis_report_candidate_of(d, bar[i].score)->name, i);
    um_plot_add(plot,
                "set label %zu %s at graph 1.03, first %zu left font ',9' textcolor rgb %s "
                "noenhanced\n",
                2 * i + 2, text, i, bar[i].fit != NULL ? "#222222" : "#777777");
  }
}

/* In a panel of its own: beside the bars it would be too narrow. */
static void put_key(struct um_plot *plot, double level, size_t tested)
{
  static const char *const title[UM_DIAGNOSIS_BAR_ROLES] = {
      [UM_DIAGNOSIS_BAR_LINEAR] = "linear model, not fitted",
      [UM_DIAGNOSIS_BAR_FITTED] = "fitted, and worse",
      [UM_DIAGNOSIS_BAR_TIED] = "cannot be told from it",
      [UM_DIAGNOSIS_BAR_WINNER] = "chosen first"};
  char chance[80];
  snprintf(chance, sizeof chance, "%.3g %% by chance among %zu", 100.0 * level, tested);
  um_plot_add(plot,
              "unset label\nunset arrow\nunset xtics\nunset xlabel\nset border 0\n"
              "set xrange [0:1]\nset yrange [0:1]\n"
              "set key at graph 0.5,0.5 center center horizontal samplen 1.6 maxrows 2\nplot ");
  for (int role = UM_DIAGNOSIS_BAR_ROLES - 1; role >= 0; role--)
    um_plot_add(plot, "NaN with boxes linecolor rgb %s title %s, ", role_colour[role], title[role]);
  um_plot_add(plot,
              "NaN with points pointtype 2 pointsize 0.8 linewidth 1.2 linecolor rgb '#111111' "
              "title 'by the linear model', NaN with lines linewidth 1.5 dashtype (6,4) linecolor "
              "rgb '#b3261e' title %s\n",
              chance);
}

enum um_status um_diagnosis_report_plot_ranking(struct um_context *context,
                                                const struct um_diagnosis *diagnosis,
                                                struct um_plot *plot)
{
  const struct um_diagnosis *d = diagnosis;
  struct um_diagnosis_report_bar *bar;
  size_t shown, tested;
  char below[200];
  UM_TRY(um_diagnosis_report_bars(context, d, &bar, &shown, &tested));
  double level = d->level > 0.0 ? d->level : UM_MISSING_HEAT_LEVEL;
  double line = threshold(level, tested), longest = line;
  for (size_t i = 0; i < shown; i++)
    longest = fmax(longest,
                   fmax(um_diagnosis_report_explained(d, &bar[i]), bar[i].score->score.statistic));
  int bottom = TOP + BAR * (int)shown;
  um_plot_picture(plot, "ranking", WIDTH, bottom + BELOW);
  snprintf(
      below, sizeof below,
      "what each effect alone explains of the baseline’s χ² of %.4g (%.4g degrees of freedom)%s",
      d->chi2, d->dof, d->nstep > 0 ? "; BIC: above that of the one chosen first" : "");
  um_plot_title(plot, d->forward->model->scenario->name, below);
  um_plot_panel(plot, LEFT, TOP, RIGHT, bottom);
  put_bars(d, bar, shown, plot);
  um_plot_add(plot,
              "set xtics nomirror %g\nunset ytics\nset border 3\nset style fill solid noborder\n"
              "set yrange [%.1f:-0.6]\nset xrange [0:%.6g]\n"
              "set xlabel 'χ² explained, after nuisances'\n"
              "set arrow 1 from first %.6g, graph 0 to first %.6g, graph 1 nohead front linewidth "
              "1.5 dashtype (6,4) linecolor rgb '#b3261e'\n"
              "plot $ranking using (0):1:(0):2:($1-0.34):($1+0.34):4 with boxxyerror linecolor rgb "
              "variable notitle, '' using 3:1 with points pointtype 2 pointsize 0.8 linewidth 1.2 "
              "linecolor rgb '#111111' notitle\n",
              um_plot_spacing(longest), (double)shown - 0.4, 1.04 * longest, line, line);
  um_plot_panel(plot, LEFT - 130, bottom + 52, WIDTH - 100, bottom + BELOW);
  put_key(plot, level, tested);
  um_core_free(context, bar);
  return UM_OK;
}

/* ---- heat ---- */

#define HEAT 360 /* height of the panel [pixels] */

/* By the heat and its course; what is known worse than a few times either leaves the axis. Returns
 * the unit of the axis [W] in *unit. */
static enum um_status heat_axis(struct um_context *context, const struct um_missing_heat *h,
                                struct um_plot *plot, double *unit)
{
  size_t n = h->nbin + 1;
  double *value;
  struct um_plot_range range;
  char scaled[80], words[120];
  UM_TRY(um_core_allocate(context, 3 * n, sizeof *value, &value));
  value[0] = h->power;
  for (size_t i = 0; i < h->nbin; i++) {
    value[1 + i] = h->heat[i];
    value[n + 2 * i] = h->low[i];
    value[n + 2 * i + 1] = h->high[i];
  }
  const struct um_plot_values of[] = {{value, n, UM_PLOT_MOST},
                                      {value + n, 2 * h->nbin, UM_PLOT_NEAR}};
  enum um_status status = um_plot_range(context, of, 2, 0.0, UM_PLOT_STRETCH, &range);
  um_core_free(context, value);
  if (status != UM_OK) return status;
  *unit = um_plot_power(fmax(fabs(range.low), fabs(range.high)), "W", scaled);
  snprintf(words, sizeof words, "missing heat [%s]", scaled);
  um_plot_ylabel(plot, "", words);
  um_plot_ordinate(plot, &range, *unit, false);
  return UM_OK;
}

/* $course: what was fitted, to the end of the axis. */
static enum um_status plot_course(struct um_context *context, const struct um_missing_heat *h,
                                  const struct um_plot_time *time, double unit,
                                  struct um_plot *plot)
{
  size_t n = um_thermal_course_rows(&h->course, h->t[h->nbin], NULL, NULL);
  double *t = NULL, *power = NULL;
  enum um_status status;
  UM_CHECK(um_core_allocate(context, n, sizeof *t, &t));
  UM_CHECK(um_core_allocate(context, n, sizeof *power, &power));
  um_thermal_course_rows(&h->course, h->t[h->nbin], t, power);
  um_plot_add(plot, "$course << EOD\n0,0\n");
  for (size_t i = 0; i < n; i++)
    um_plot_add(plot, "%.6f,%.6g\n",
                fmin(um_plot_time_at(time, t[i]), um_plot_time_at(time, time->last)),
                h->power / unit * power[i]);
  um_plot_add(plot, "%.6f,%.6g\nEOD\n", um_plot_time_at(time, time->last),
              h->power / unit * power[n - 1]);
done:
  UM_FREE(context, t, power);
  return status;
}

enum um_status um_diagnosis_report_plot_heat(struct um_context *context,
                                             const struct um_diagnosis *diagnosis,
                                             struct um_plot *plot)
{
  const struct um_missing_heat *h = &diagnosis->unexplained->heat[0];
  struct um_plot_time time = um_diagnosis_report_plot_time(h->t[0], h->t[h->nbin]);
  char energy[80], below[300], best[40];
  double unit;
  um_diagnosis_value_text(h->energy, h->energy_sigma, "±", energy);
  snprintf(below, sizeof below, "%s %.150s: %s of %s J",
           diagnosis->unexplained->found ? "missing heat of" : "explains only a part: heat of",
           h->place, um_thermal_course_name(h->course.shape), energy);
  snprintf(best, sizeof best, "best %s", um_thermal_course_name(h->course.shape));
  um_plot_picture(plot, "heat", WIDTH, TOP + 24 + HEAT + 58);
  um_plot_title(plot, diagnosis->forward->model->scenario->name, below);
  um_plot_time_axis(plot, &time);
  UM_TRY(um_compare_plot_shade(context, diagnosis->forward->model, &time, plot));
  um_plot_panel(plot, UM_DIAGNOSIS_PLOT_LEFT, TOP + 24, UM_DIAGNOSIS_PLOT_RIGHT, TOP + 24 + HEAT);
  um_plot_time_label(plot, &time);
  UM_TRY(heat_axis(context, h, plot, &unit));
  um_plot_add(plot, "$heat << EOD\n");
  for (size_t i = 0; i < h->nbin; i++)
    um_plot_add(plot, "%.6f,%.6f,%.6g,%.6g,%.6g\n", um_plot_time_at(&time, h->t[i]),
                um_plot_time_at(&time, h->t[i + 1]), h->heat[i] / unit, h->low[i] / unit,
                h->high[i] / unit);
  um_plot_add(plot, "EOD\n");
  UM_TRY(plot_course(context, h, &time, unit, plot));
  um_plot_add(
      plot,
      "set style fill transparent solid 0.25 noborder\n"
      "plot 0 with lines linecolor rgb '#888888' notitle, $heat using 1:3:1:2:4:5 "
      "with boxxyerror linecolor rgb '#1f4e9c' title '95 %%', $heat using 1:3:($2-$1):(0) "
      "with vectors nohead linewidth 2 linecolor rgb '#1f4e9c' title 'reconstructed', $course "
      "using 1:2 with lines linewidth 2 dashtype (6,4) linecolor rgb '#c2410c' title %s\n",
      best);
  return UM_OK;
}
