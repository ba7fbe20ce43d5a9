/* Pictures of a run: axes that several share, and the counts of sensors. */
#include <math.h>
#include <stdio.h>

#include "base/core/constants.h"
#include "orbit/time.h"
#include "output/csv_impl.h"
#include "output/plot_impl.h"

#define SEEN          0.01 /* of the highest, on an axis that is not logarithmic */
#define PEAK_CONTRAST 5.0  /* highest over mean in sunlight that asks for a logarithmic axis */

/* Columns of counts.csv as gnuplot counts them, of the first sensor. */
#define RATE 2
#define SNR  8

struct um_plot_time um_output_plot_time(const struct um_output_run *run)
{
  char start[32];
  const struct um_model_tables *t = run->tables;
  um_orbit_time_format(t->t_obs[0], start);
  return um_plot_time(t->t_obs[0], t->t_obs[t->nobs - 1], start);
}

double um_output_plot_ordinate(struct um_plot *plot, const char *name, const char *what,
                               const char *unit, double largest, double mean)
{
  char scaled[80], words[120];
  bool wide = largest > PEAK_CONTRAST * mean;
  double power = um_plot_power(wide ? 1.0 : largest, unit, scaled);
  double least = wide ? UM_PLOT_LOG_FLOOR * largest : 0.0;
  snprintf(words, sizeof words, "%s [%s]", what, scaled);
  um_plot_ylabel(plot, name, words);
  if (wide)
    um_plot_add(plot, "set logscale y\nset yrange [%.3g:%.3g]\nset format y '10^{%%T}'\n", least,
                2.0 * largest);
  else
    um_plot_add(plot, "unset logscale y\nset yrange [0:%.6g]\nset format y '%%g'\n",
                largest > 0.0 ? 1.06 * largest / power : 1.0);
  um_plot_add(plot, "v(i) = column(i) / %g\nup(v) = v > %g ? v : %g\n", power, least, least);
  return wide ? least : SEEN * largest;
}

static void panel(struct um_plot *plot, const struct um_output_run *run, size_t s)
{
  const struct um_model_result *r = run->result;
  double largest = 0.0, sum = 0.0, lit = 0.0;
  for (size_t k = 0; k < r->nobs; k++) {
    double rate = r->count_rate[k * r->nsensor + s];
    largest = fmax(largest, rate); /* NaN where hidden */
    if (!(run->tables->sunlit[k] > UM_UMBRA_MOST) || isnan(rate)) continue;
    sum += rate;
    lit += 1.0;
  }
  size_t c = RATE + UM_OUTPUT_COUNTS_COLUMNS * s, snr = SNR + UM_OUTPUT_COUNTS_COLUMNS * s;
  um_output_plot_ordinate(plot, run->model->sensor[s].name, "counts", "1/s", largest,
                          lit > 0.0 ? sum / lit : largest);
  um_plot_add(plot,
              "plot 'counts.csv' every ::1 using (x(1)):(up(v(%zu)*(1-1/column(%zu)))):"
              "(up(v(%zu)*(1+1/column(%zu)))) with filledcurves fillcolor rgb '#1f4e9c' fillstyle "
              "transparent solid 0.3 noborder title '± signal / SNR', '' every ::1 using "
              "(x(1)):(v(%zu)) with lines linewidth 2 linecolor rgb '#1f4e9c' title 'counts'\n",
              c, snr, c, snr, c);
}

void um_output_plot_counts(struct um_plot *plot, const struct um_output_run *run)
{
  size_t n = run->model->nsensor;
  struct um_plot_time time = um_output_plot_time(run);
  int step = UM_PLOT_PANEL + UM_PLOT_KEY;
  um_plot_picture(plot, "counts", UM_PLOT_WIDTH,
                  UM_PLOT_TOP - UM_PLOT_KEY + (int)n * step + UM_PLOT_BELOW);
  um_plot_title(plot, run->model->scenario->name, "");
  um_plot_time_axis(plot, &time);
  um_plot_shade(plot, &time, run->tables->nobs, run->tables->t_obs, run->tables->sunlit);
  um_plot_xnumbers(plot, false);
  for (size_t s = 0; s < n; s++) {
    int top = UM_PLOT_TOP + (int)s * step;
    um_plot_panel(plot, UM_PLOT_LEFT, top, UM_PLOT_RIGHT, top + UM_PLOT_PANEL);
    if (s + 1 == n) {
      um_plot_xnumbers(plot, true);
      um_plot_time_label(plot, &time);
    }
    panel(plot, run, s);
  }
}
