/* Draws from a posterior: each parameter alone on the diagonal, each pair below it. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "evidence/diagnosis/report/report_impl.h"

#define MOST   7 /* parameters that are drawn: the effects' come first */
#define BINS   30
#define LEFT   112
#define TOP    96
#define GAP    14
#define BELOW  84
#define LARGE  230 /* side of a panel at most */
#define COLOUR "#1f4e9c"

/* The axis of a parameter: what 95 % of the draws hold, and two thirds of that to both sides as far
 * as there are draws, in units of `power`. */
struct axis {
  double low, high, power;
  char name[120], words[160]; /* "path_radiance:lwir", "irradiance_W_m2 [10^-13 W/m2]" */
};

/* A name for gnuplot's marked-up text, in which "_" lowers what follows. */
static void escaped(const char *name, char out[120])
{
  size_t n = 0;
  for (; *name != '\0' && n + 3 < 120; name++) {
    if (*name == '_') out[n++] = '\\';
    out[n++] = *name;
  }
  out[n] = '\0';
}

static struct axis axis_of(const struct um_diagnosis *d, size_t k)
{
  const struct um_diagnosis_posterior *p = d->posterior;
  const struct um_effect_parameter *of = &d->fitted[k].effect->parameters[d->fitted[k].parameter];
  double low = p->quantile[k], high = p->quantile[(UM_DIAGNOSIS_QUANTILES - 1) * p->nfitted + k];
  double room = high > low ? 0.66 * (high - low) : 0.1 * fabs(high) + 1e-9;
  bool plain = strcmp(of->unit, "1") == 0;
  struct axis out = {.low = low - room, .high = high + room};
  double least = INFINITY, most = -INFINITY;
  char unit[80], name[120];
  for (size_t i = 0; i < p->n; i++) {
    least = fmin(least, p->value[i * p->nfitted + k]);
    most = fmax(most, p->value[i * p->nfitted + k]);
  }
  out.low = fmax(out.low, least - 0.05 * room);
  out.high = fmin(out.high, most + 0.05 * room);
  out.power = um_plot_power(fmax(fabs(low), fabs(high)), plain ? "" : of->unit, unit);
  bool targeted = d->fitted[k].target != NULL;
  snprintf(out.name, sizeof out.name, "%.50s%s%.60s", d->fitted[k].effect->name,
           targeted ? ":" : "", targeted ? d->fitted[k].target : "");
  escaped(of->name, name);
  snprintf(out.words, sizeof out.words, "%.60s%s%s%s", name, unit[0] != '\0' ? " [" : "", unit,
           unit[0] != '\0' ? "]" : "");
  return out;
}

/* $alone0, $alone1 ..: middle of a bin, its share of the weight over that of the largest. */
static void put_histogram(struct um_plot *plot, const struct um_diagnosis_posterior *p, size_t k,
                          const struct axis *axis)
{
  double share[BINS] = {0}, most = 0.0, width = (axis->high - axis->low) / BINS;
  for (size_t i = 0; i < p->n; i++) {
    double at = (p->value[i * p->nfitted + k] - axis->low) / width;
    if (at >= 0.0 && at < BINS) share[(size_t)at] += p->weight[i];
  }
  for (size_t b = 0; b < BINS; b++) most = fmax(most, share[b]);
  um_plot_add(plot, "$alone%zu << EOD\n", k);
  for (size_t b = 0; b < BINS; b++)
    um_plot_add(plot, "%.9g,%.6g\n", (axis->low + ((double)b + 0.5) * width) / axis->power,
                most > 0.0 ? share[b] / most : 0.0);
  um_plot_add(plot, "EOD\n");
}

/* Histogram, with lines at 16, 50 and 84 %. */
static void put_alone(struct um_plot *plot, const struct um_diagnosis_posterior *p, size_t k,
                      const struct axis *axis)
{
  um_plot_add(plot, "set yrange [0:1.1]\nset ytics 2\n");
  for (size_t q = 1; q + 1 < UM_DIAGNOSIS_QUANTILES; q++)
    um_plot_add(plot,
                "set arrow %zu from %.9g, graph 0 to %.9g, graph 1 nohead dashtype %d linecolor "
                "rgb '#333333'\n",
                q, p->quantile[q * p->nfitted + k] / axis->power,
                p->quantile[q * p->nfitted + k] / axis->power, q == 2 ? 1 : 3);
  um_plot_add(plot,
              "plot $alone%zu using 1:2 with boxes fillstyle solid 0.35 noborder linecolor rgb %s "
              "notitle\n",
              k, COLOUR);
  for (size_t q = 1; q + 1 < UM_DIAGNOSIS_QUANTILES; q++) um_plot_add(plot, "unset arrow %zu\n", q);
}

/* The draws by their weight, and a cross at the fit. */
static void put_pair(struct um_plot *plot, const struct um_diagnosis *d, size_t x, size_t y,
                     const struct axis *axis, double heaviest)
{
  um_plot_add(plot, "set yrange [%.9g:%.9g]\nset ytics %.9g\n", axis[y].low / axis[y].power,
              axis[y].high / axis[y].power,
              um_plot_spacing((axis[y].high - axis[y].low) / axis[y].power));
  um_plot_add(plot,
              "plot 'posterior.csv' every ::1 using "
              "(column(%zu)/%g):(column(%zu)/%g):(0.55*sqrt(column(1)/%g)) with points pointtype 7 "
              "pointsize variable linecolor rgb '#901f4e9c' notitle, '+' every ::0::0 using "
              "(%.9g):(%.9g) with points pointtype 1 pointsize 1.6 linewidth 2 linecolor rgb "
              "'#d9480f' notitle\n",
              x + 2, axis[x].power, y + 2, axis[y].power, heaviest,
              d->fitted[x].value / axis[x].power, d->fitted[y].value / axis[y].power);
}

static void put_panels(struct um_plot *plot, const struct um_diagnosis *d, size_t n, int side,
                       const struct axis *axis)
{
  const struct um_diagnosis_posterior *p = d->posterior;
  double heaviest = 0.0;
  for (size_t i = 0; i < p->n; i++) heaviest = fmax(heaviest, p->weight[i]);
  for (size_t y = 0; y < n; y++)
    for (size_t x = 0; x <= y; x++) {
      int left = LEFT + (int)x * (side + GAP), top = TOP + (int)y * (side + GAP);
      um_plot_panel(plot, left, top, left + side, top + side);
      um_plot_ylabel(plot, x == 0 && y > 0 ? axis[y].name : "",
                     x == 0 && y > 0 ? axis[y].words : "");
      um_plot_xnumbers(plot, y + 1 == n);
      um_plot_add(plot, "set format y %s\nset xrange [%.9g:%.9g]\nset xtics %.9g font ',9'\n",
                  x == 0 && y > 0 ? "%g" : "", axis[x].low / axis[x].power,
                  axis[x].high / axis[x].power,
                  um_plot_spacing(2.0 * (axis[x].high - axis[x].low) / axis[x].power));
      if (y + 1 == n)
        um_plot_add(plot,
                    "set label 905 %s at graph 0.5, graph 0 center noenhanced font ',%d' offset 0, "
                    "-2.4\nset label 906 %s at graph 0.5, graph 0 center font ',%d' offset 0, "
                    "-3.7\n",
                    axis[x].name, n > 4 ? 8 : 10, axis[x].words, n > 4 ? 8 : 10);
      if (x == y)
        put_alone(plot, p, x, &axis[x]);
      else
        put_pair(plot, d, x, y, axis, heaviest);
      um_plot_add(plot, "unset label 905\nunset label 906\n");
    }
}

enum um_status um_diagnosis_report_plot_posterior(struct um_context *context,
                                                  const struct um_diagnosis *d,
                                                  struct um_plot *plot)
{
  const struct um_diagnosis_posterior *p = d->posterior;
  struct axis axis[MOST];
  size_t n = p->nfitted < MOST ? p->nfitted : MOST;
  int side = (UM_DIAGNOSIS_PLOT_WIDTH - LEFT - 24 - ((int)n - 1) * GAP) / (int)n;
  char title[200], below[240];
  (void)context;
  if (side > LARGE) side = LARGE;
  um_plot_picture(plot, "posterior", UM_DIAGNOSIS_PLOT_WIDTH,
                  TOP + (int)n * (side + GAP) - GAP + BELOW);
  snprintf(title, sizeof title, "%.100s: what is known of the fitted values",
           d->forward->model->scenario->name);
  snprintf(below, sizeof below,
           "%zu draws, effective number %.0f%s; lines at 16, 50 and 84 %%, cross: the fit%s", p->n,
           p->effective, p->sound ? "" : ", too few to be trusted",
           n < p->nfitted ? "; the first of them" : "");
  um_plot_title(plot, title, below);
  for (size_t k = 0; k < n; k++) {
    axis[k] = axis_of(d, k);
    put_histogram(plot, p, k, &axis[k]);
  }
  put_panels(plot, d, n, side, axis);
  return UM_OK;
}
