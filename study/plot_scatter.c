/* Points against what they come to: single values (metrics against measurements) or, where there
 * are none, the means of the bands. A panel for each parameter. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/csv.h"
#include "study/per_point.h"
#include "study/plot_impl.h"

#define WIDTH  1000
#define LEFT   96
#define TOP    92
#define PANEL  250
#define ACROSS 3  /* panels beside each other */
#define GAP    40 /* between them */
#define BELOW  64 /* a row of them */

static bool drawn(const struct um_study_result *r, const struct um_study_quantity *of)
{
  bool metrics = false;
  for (size_t q = 0; q < r->nquantity; q++) metrics = metrics || r->quantity[q].count == 1;
  return metrics ? of->count == 1 : of->light || strcmp(of->unit, "mag") == 0;
}

/* point, the parameters, weight, the quantities that are drawn */
static void write(const struct um_study_result *r, const double *weight, FILE *file)
{
  fputs("point", file);
  for (size_t i = 0; i < r->nparameter; i++) um_core_csv_put_text(file, r->parameter_name[i], "");
  fputs(",weight", file);
  for (size_t q = 0; q < r->nquantity; q++) {
    if (!drawn(r, &r->quantity[q])) continue;
    um_core_csv_put_text(file, r->quantity[q].name, r->quantity[q].count > 1 ? " mean" : "");
  }
  fputs("\n", file);
  for (size_t p = 0; p < r->npoint; p++) {
    fprintf(file, "%zu", p);
    for (size_t i = 0; i < r->nparameter; i++)
      um_core_csv_put_exact(file, r->parameter[p * r->nparameter + i]);
    um_core_csv_put_exact(file, weight == NULL ? NAN : weight[p]);
    for (size_t q = 0; q < r->nquantity; q++)
      if (drawn(r, &r->quantity[q]))
        um_core_csv_put_exact(file,
                              um_study_statistic_of(&r->quantity[q],
                                                    um_study_result_values(r, p, &r->quantity[q]),
                                                    UM_STUDY_MEAN));
    fputs("\n", file);
  }
}

/* Of what hardly moves the picture shows that, not rounding: a tenth of the value each way. */
static void yrange(struct um_plot *plot, double least, double most, double unit)
{
  double size = fmax(fabs(least), fabs(most)) / unit;
  if (most - least > 1e-6 * size * unit)
    um_plot_add(plot, "set autoscale y\n");
  else
    um_plot_add(plot, "set yrange [%.9g:%.9g]\n", least / unit - 0.1 * size,
                most / unit + 0.1 * size);
}

/* column: of the quantity in scatter.csv, from 1. */
static void picture(struct um_plot *plot, const struct um_study_result *r,
                    const struct um_study_quantity *of, size_t column, const double *weight)
{
  char name[200], unit[100], words[300];
  int rows = (int)((r->nparameter + ACROSS - 1) / ACROSS);
  int across = r->nparameter < ACROSS ? (int)r->nparameter : ACROSS;
  int wide = (WIDTH - LEFT - 24 - (across - 1) * GAP) / across;
  double largest = 0.0, heaviest = 0.0, least = INFINITY, most = -INFINITY;
  for (size_t p = 0; p < r->npoint; p++) {
    double v = um_study_statistic_of(of, um_study_result_values(r, p, of), UM_STUDY_MEAN);
    largest = fmax(largest, fabs(v));
    least = fmin(least, v);
    most = fmax(most, v);
    if (weight != NULL) heaviest = fmax(heaviest, weight[p]);
  }
  double power = um_study_axis_unit(of, largest, unit);
  snprintf(name, sizeof name, "scatter_%s", of->name);
  um_plot_picture(plot, name, WIDTH, TOP + rows * (PANEL + BELOW));
  snprintf(words, sizeof words, "%s%s at each point%s", of->name,
           of->count > 1 ? ", mean over time," : "",
           weight == NULL ? "" : "; area: weight by the measurements");
  um_plot_title(plot, r->name, words);
  for (size_t i = 0; i < r->nparameter; i++) {
    int column_at = (int)i % ACROSS, left = LEFT + column_at * (wide + GAP);
    int top = TOP + (int)i / ACROSS * (PANEL + BELOW);
    um_plot_panel(plot, left, top, left + wide, top + PANEL);
    um_plot_ylabel(plot, column_at == 0 ? of->name : "", column_at == 0 ? unit : "");
    um_study_plot_xaxis(plot, r, i, wide);
    yrange(plot, least, most, power);
    um_plot_add(plot, "set format y %s\n", column_at == 0 ? "%g" : "");
    um_plot_add(plot, "plot 'scatter.csv' using (column(%zu)):(column(%zu) / %g)", i + 2, column,
                power);
    if (weight == NULL)
      um_plot_add(plot,
                  " with points pointtype 7 pointsize 0.45 linecolor rgb '#b00072b2' notitle");
    else
      um_plot_add(plot,
                  " with points pointtype 7 pointsize 0.25 linecolor rgb '#aaaaaa' notitle, '' "
                  "using (column(%zu)):(column(%zu) / %g):(1.8 * sqrt(column(%zu) / %g)) with "
                  "points pointtype 7 pointsize variable linecolor rgb '#800072b2' notitle",
                  i + 2, column, power, r->nparameter + 2, heaviest);
    if (r->nominal != NULL && isfinite(r->at_nominal[i]))
      um_plot_add(plot,
                  ", '+' every ::0::0 using (%.9g):(%.9g) with points pointtype 6 pointsize 1.6 "
                  "linewidth 2 linecolor rgb '#d55e00' title %s",
                  r->at_nominal[i],
                  um_study_statistic_of(of, r->nominal + of->first, UM_STUDY_MEAN) / power,
                  i == 0 ? "as the scenario stands" : "");
    um_plot_add(plot, "\n");
  }
}

enum um_status um_study_plot_scatter(struct um_context *context, struct um_plot *plot,
                                     const struct um_study_result *result, const double *weight,
                                     struct um_core_folder *folder)
{
  FILE *file = NULL;
  UM_TRY(um_core_folder_open(context, folder, "scatter.csv", &file));
  write(result, weight, file);
  UM_TRY(um_core_file_close(context, "scatter.csv", &file));
  size_t column = result->nparameter + 3;
  for (size_t q = 0; q < result->nquantity; q++)
    if (drawn(result, &result->quantity[q]))
      picture(plot, result, &result->quantity[q], column++, weight);
  return UM_OK;
}
