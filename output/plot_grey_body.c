/* Picture of what an infrared observer concludes from a run: characteristic temperature and
 * infrared cross-section over time. */
#include <math.h>

#include "output/lightcurve_impl.h"
#include "output/plot_impl.h"

#define MARGIN 0.06 /* of the range, above and below the curve */

/* Columns of grey bodies. */
enum { TEMPERATURE = 0, AREA = 2, COLD = 5, HOT = 7 };

/* The axis from the lowest to the highest value of the n columns `what`. */
static void ordinate(struct um_plot *plot, const struct um_model_result *r, const size_t *what,
                     size_t n, const char *name)
{
  double value[UM_LIGHTCURVE_GREY], low = INFINITY, high = -INFINITY;
  for (size_t k = 0; k < r->nobs; k++) {
    um_output_grey_values(&r->grey_body[k], value);
    for (size_t i = 0; i < n; i++) {
      low = fmin(low, value[what[i]]);
      high = fmax(high, value[what[i]]);
    }
  }
  if (!(low <= high)) low = high = 0.0; /* none at all */
  double margin = fmax(MARGIN * (high - low), 1e-3 * fabs(high) + 1e-9);
  um_plot_ylabel(plot, "", name);
  um_plot_add(plot, "unset logscale y\nset format y '%%g'\nset yrange [%.6g:%.6g]\n", low - margin,
              high + margin);
}

static void curves(struct um_plot *plot, size_t first, size_t one, const size_t *two, size_t n)
{
  static const char *const title[] = {"colder of two", "hotter of two"};
  static const char *const colour[] = {"#1f4e9c", "#b3261e"};
  size_t c = first + one, e = c + 1;
  um_plot_add(plot,
              "plot 'lightcurve.csv' every ::1 using (x(1)):(column(%zu)-column(%zu)):"
              "(column(%zu)+column(%zu)) with filledcurves fillcolor rgb '#333333' fillstyle "
              "transparent solid 0.3 noborder title '± 1σ', '' every ::1 using (x(1)):%zu with "
              "lines linewidth 2 linecolor rgb '#333333' title 'one grey body'",
              c, e, c, e, c);
  for (size_t i = 0; i < n; i++)
    um_plot_add(plot,
                ", '' every ::1 using (x(1)):%zu with points pointtype 7 pointsize 0.4 linecolor "
                "rgb %s title %s",
                first + two[i], colour[i], title[i]);
  um_plot_add(plot, "\n");
}

void um_output_plot_grey_body(struct um_plot *plot, const struct um_output_run *run)
{
  static const size_t temperature[] = {TEMPERATURE, COLD, HOT}, area[] = {AREA, COLD + 1, HOT + 1};
  size_t columns = um_output_grey_columns(run->model), n = columns > UM_LIGHTCURVE_GREY_ONE ? 3 : 1;
  size_t first = 1 + UM_LIGHTCURVE_BEFORE + UM_LIGHTCURVE_COLUMNS * run->model->nband;
  struct um_plot_time time = um_output_plot_time(run);
  int step = UM_PLOT_PANEL + UM_PLOT_KEY;
  if (columns == 0) return;
  um_plot_picture(plot, "grey_body", UM_PLOT_WIDTH,
                  UM_PLOT_TOP - UM_PLOT_KEY + 2 * step + UM_PLOT_BELOW);
  um_plot_title(plot, run->model->scenario->name, "");
  um_plot_time_axis(plot, &time);
  um_plot_shade(plot, &time, run->tables->nobs, run->tables->t_obs, run->tables->sunlit);
  um_plot_xnumbers(plot, false);
  um_plot_panel(plot, UM_PLOT_LEFT, UM_PLOT_TOP, UM_PLOT_RIGHT, UM_PLOT_TOP + UM_PLOT_PANEL);
  ordinate(plot, run->result, temperature, n, "characteristic temperature [K]");
  curves(plot, first, TEMPERATURE, temperature + 1, n - 1);
  um_plot_panel(plot, UM_PLOT_LEFT, UM_PLOT_TOP + step, UM_PLOT_RIGHT,
                UM_PLOT_TOP + step + UM_PLOT_PANEL);
  um_plot_xnumbers(plot, true);
  um_plot_time_label(plot, &time);
  ordinate(plot, run->result, area, n, "infrared cross-section [m^2]");
  curves(plot, first, AREA, area + 1, n - 1);
}
