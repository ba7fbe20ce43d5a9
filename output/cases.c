/* limits.csv and its picture. */
#include "output/cases.h"

#include <math.h>
#include <string.h>

#include "output/csv_impl.h"
#include "plot/plot.h"

#define WIDTH  1100 /* pixels */
#define LEFT   230
#define ROW    26 /* of a bar */
#define MARGIN 90 /* above and below the bars */
#define ROWS   60 /* shown at most */

void um_output_write_cases(const struct um_model_cases *cases, FILE *file)
{
  fputs("case,analysis,place,mean_K,lowest_K,highest_K,minimum_K,maximum_K,uncertainty_K,"
        "margin_low_K,margin_high_K\n",
        file);
  for (size_t i = 0; i < cases->count; i++)
    for (size_t p = 0; p < cases->item[i].nplace; p++) {
      const struct um_model_case *c = &cases->item[i];
      const struct um_model_case_place *place = &c->place[p];
      um_core_csv_put(file, c->name, "");
      um_output_csv_text(file, um_model_analysis_name(c->analysis), "");
      um_output_csv_text(file, place->name, "");
      const double value[] = {place->mean,       place->lowest,     place->highest,
                              place->minimum,    place->maximum,    place->uncertainty,
                              place->margin_low, place->margin_high};
      for (size_t k = 0; k < sizeof value / sizeof value[0]; k++)
        um_output_csv_number(file, value[k]);
      fputc('\n', file);
    }
}

static bool has_limit(const struct um_model_case_place *place)
{
  return !isnan(place->minimum) || !isnan(place->maximum);
}

bool um_output_case_shows(const struct um_model_cases *cases,
                          const struct um_model_case_place *place)
{
  for (size_t i = 0; i < cases->count; i++)
    for (size_t p = 0; p < cases->item[i].nplace; p++)
      if (has_limit(&cases->item[i].place[p])) return has_limit(place);
  const char *dot = strchr(place->name, '.');
  return dot == NULL || strcmp(dot, ".interior") == 0;
}

/* Lowest and highest of what is drawn [K]. */
static void extent(const struct um_model_cases *cases, double *low, double *high)
{
  *low = INFINITY;
  *high = -INFINITY;
  for (size_t i = 0; i < cases->count; i++)
    for (size_t p = 0; p < cases->item[i].nplace; p++) {
      const struct um_model_case_place *place = &cases->item[i].place[p];
      if (!um_output_case_shows(cases, place)) continue;
      *low = fmin(*low, fmin(place->lowest, place->minimum));
      *high = fmax(*high, fmax(place->highest, place->maximum));
    }
}

/* Rows of a picture: places of the first case that are shown, and below each a bar per case. */
static void draw(struct um_plot *plot, const struct um_model_cases *cases, size_t nrow)
{
  static const char *const colour[] = {"#b2182b", "#2166ac", "#1b7837", "#762a83", "#8c510a"};
  const size_t ncolour = sizeof colour / sizeof colour[0];
  double low, high;
  extent(cases, &low, &high);
  double least = 0.002 * (high - low); /* a bar of one temperature is seen */
  um_plot_add(plot, "$bars << EOD\n");
  size_t row = 0;
  for (size_t p = 0; p < cases->item[0].nplace && row < nrow; p++) {
    if (!um_output_case_shows(cases, &cases->item[0].place[p])) continue;
    for (size_t i = 0; i < cases->count; i++) {
      const struct um_model_case_place *place = &cases->item[i].place[p];
      double y = (double)row + ((double)i + 0.5) / (double)cases->count * 0.8 + 0.1;
      um_plot_add(plot, "%zu,%.4f,%.4f,%.4f,%.4f,%.4f\n", i, y, place->lowest - least,
                  place->highest + least, place->minimum, place->maximum);
    }
    row++;
  }
  um_plot_add(plot, "EOD\n");
  double space = fmax(2.0, 0.05 * (high - low));
  um_plot_add(plot, "set yrange [%.1f:0]\nset xrange [%.2f:%.2f]\nunset ytics\n", (double)row,
              low - space, high + space);
  um_plot_add(plot, "set xlabel 'temperature [K]'\nset key above\n");
  row = 0;
  for (size_t p = 0; p < cases->item[0].nplace && row < nrow; p++) {
    if (!um_output_case_shows(cases, &cases->item[0].place[p])) continue;
    um_plot_add(plot, "set label %s at graph -0.01, first %.2f right\n",
                cases->item[0].place[p].name, (double)row + 0.5);
    if (row > 0)
      um_plot_add(plot,
                  "set arrow from graph 0, first %.1f to graph 1, first %.1f nohead "
                  "linecolor rgb '#dddddd' back\n",
                  (double)row, (double)row);
    row++;
  }
  double half = 0.3 / (double)cases->count;
  um_plot_add(plot, "plot ");
  for (size_t i = 0; i < cases->count; i++)
    um_plot_add(plot,
                "$bars using ($1==%zu ? 0.5*($3+$4) : NaN):2:3:4:($2-%.4f):($2+%.4f) with "
                "boxxyerror fillstyle solid noborder linecolor rgb %s title %s, ",
                i, half, half, colour[i % ncolour], cases->item[i].name);
  um_plot_add(plot,
              "$bars using 5:2:(0.0):(%.4f) with vectors nohead linewidth 2 linecolor rgb 'black' "
              "title 'limits', $bars using 5:2:(0.0):(-%.4f) with vectors nohead linewidth 2 "
              "linecolor rgb 'black' notitle, $bars using 6:2:(0.0):(%.4f) with vectors nohead "
              "linewidth 2 linecolor rgb 'black' notitle, $bars using 6:2:(0.0):(-%.4f) with "
              "vectors nohead linewidth 2 linecolor rgb 'black' notitle\n",
              1.4 * half, 1.4 * half, 1.4 * half, 1.4 * half);
}

enum um_status um_output_plot_cases(struct um_context *context, const struct um_model_cases *cases,
                                    const char *folder)
{
  struct um_plot *plot = NULL;
  size_t nrow = 0;
  for (size_t p = 0; p < cases->item[0].nplace; p++)
    nrow += um_output_case_shows(cases, &cases->item[0].place[p]) ? 1 : 0;
  for (size_t i = 1; i < cases->count; i++) /* a case that changes the parts has its own places */
    if (cases->item[i].nplace != cases->item[0].nplace) nrow = 0;
  if (nrow == 0) return UM_OK;
  if (nrow > ROWS) nrow = ROWS;
  int height = 2 * MARGIN + (int)(nrow * cases->count) * ROW;
  UM_TRY(um_plot_create(context, folder, "limits.gp", &plot));
  um_plot_picture(plot, "limits", WIDTH, height);
  um_plot_title(plot, cases->scenario, "lowest to highest temperature of each case");
  um_plot_panel(plot, LEFT, MARGIN, WIDTH - 40, height - MARGIN);
  draw(plot, cases, nrow);
  return um_plot_draw(context, &plot);
}
