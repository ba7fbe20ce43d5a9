/* Pictures of a finished folder by gnuplot, from the CSV files that lie in it. The script is kept
 * beside them, so that a user can change a picture without computing again. */
#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "model/build/bands.h"
#include "output/lightcurve_impl.h"
#include "output/plot_impl.h"

#define MAGNITUDES 12.5 /* below the brightest: UM_PLOT_LOG_FLOOR */

/* Pixels. */
#define MAGNITUDE    170
#define GAP          22
#define TEMPERATURES 380
#define NAMES        760 /* right of it the names of the curves stand */

/* Column of lightcurve.csv as gnuplot counts them, from 1. */
static size_t column_of(size_t band, size_t what)
{
  return 1 + UM_LIGHTCURVE_BEFORE + UM_LIGHTCURVE_COLUMNS * band + what;
}

/* ---- light ---- */

struct extent {
  double largest, mean_lit;        /* intensity [W/sr] */
  double part[UM_MECHANISM_COUNT]; /* largest of each mechanism [W/sr] */
  double brightest, faintest;      /* magnitudes of the band's system; INFINITY, -INFINITY: none */
  bool vega;                       /* that system is relative to Vega, else AB */
};

static struct extent extent_of(const struct um_output_run *run, size_t band)
{
  const struct um_model_result *r = run->result;
  struct extent e = {.brightest = INFINITY, .faintest = -INFINITY};
  size_t lit = 0;
  e.vega = um_model_band_is_vega(run->model, band);
  for (size_t k = 0; k < r->nobs; k++) {
    double total = um_model_result_intensity(r, k, band, -1);
    double magnitude = r->magnitude_ab[k * r->nband + band] - (e.vega ? r->vega_ab[band] : 0.0);
    e.largest = fmax(e.largest, total);
    for (int m = 0; m < UM_MECHANISM_COUNT; m++)
      e.part[m] = fmax(e.part[m], um_model_result_intensity(r, k, band, m));
    if (isfinite(magnitude)) {
      e.brightest = fmin(e.brightest, magnitude);
      e.faintest = fmax(e.faintest, magnitude);
    }
    if (!(run->tables->sunlit[k] > UM_UMBRA_MOST)) continue;
    e.mean_lit += total;
    lit++;
  }
  e.mean_lit = lit > 0 ? e.mean_lit / (double)lit : e.largest;
  return e;
}

static bool has_magnitudes(const struct um_output_run *run, size_t band, const struct extent *e)
{
  return run->model->band[band].to <= UM_INFRARED_FROM && e->brightest <= e->faintest;
}

/* Returns the least that the panel shows [W/sr]. */
static double band_ordinate(struct um_plot *plot, const struct um_optics_band *band,
                            const struct extent *e)
{
  char name[200];
  snprintf(name, sizeof name, "%.150s %g–%g µm", band->name, band->from * 1e6, band->to * 1e6);
  return um_output_plot_ordinate(plot, name, "radiant intensity", "W/sr", e->largest, e->mean_lit);
}

/* Every mechanism that is seen beside the total has its curve and its name. */
static void intensity(struct um_plot *plot, size_t band, const struct extent *e, double least)
{
  static const struct {
    const char *title, *colour;
  } curve[] = {[UM_MECHANISM_SUN] = {"Sun", "#e69f00"},
               [UM_MECHANISM_EARTH] = {"Earth", "#009e73"},
               [UM_MECHANISM_EMITTED] = {"emitted", "#777777"},
               [UM_MECHANISM_INTERREFLECTED] = {"interreflected", "#cc79a7"},
               [UM_MECHANISM_OTHER] = {"Moon", "#56b4e9"}};
  static_assert(sizeof curve / sizeof curve[0] == UM_MECHANISM_COUNT, "a mechanism has no name");
  static const char *const total[] = {"#1f4e9c", "#b3261e", "#3a7d34", "#7b3fa0"};
  size_t t = column_of(band, UM_LIGHTCURVE_TOTAL), s = column_of(band, UM_LIGHTCURVE_STDERR);
  um_plot_add(
      plot,
      "plot 'lightcurve.csv' every ::1 using (x(1)):(up(v(%zu)-v(%zu))):(up(v(%zu)+v(%zu))) "
      "with filledcurves fillcolor rgb %s fillstyle transparent solid 0.3 noborder title "
      "'± 1σ', '' every ::1 using (x(1)):(v(%zu)) with lines linewidth 2 "
      "linecolor rgb %s title 'total'",
      t, s, t, s, total[band % 4], t, total[band % 4]);
  for (size_t m = 0; m < UM_MECHANISM_COUNT; m++) {
    if (!(e->part[m] > least)) continue;
    um_plot_add(plot, ", '' every ::1 using (x(1)):(v(%zu)) with lines linewidth 1.3 ",
                column_of(band, UM_LIGHTCURVE_MECHANISM + m));
    if (m == UM_MECHANISM_SUN || m == UM_MECHANISM_OTHER) um_plot_add(plot, "dashtype (8,5) ");
    um_plot_add(plot, "linecolor rgb %s title %s", curve[m].colour, curve[m].title);
  }
  um_plot_add(plot, "\n");
}

static void magnitudes(struct um_plot *plot, size_t band, const struct extent *e)
{
  double faintest = fmin(e->faintest, e->brightest + MAGNITUDES);
  double margin = fmax(0.06 * (faintest - e->brightest), 0.1);
  um_plot_ylabel(plot, "", e->vega ? "magnitude (Vega)" : "AB magnitude");
  um_plot_add(plot,
              "unset logscale y\nset format y '%%g'\nset yrange [%.4f:%.4f]\nplot 'lightcurve.csv' "
              "every ::1 using (x(1)):%zu with lines linewidth 2 linecolor rgb '#333333' notitle\n",
              faintest + margin, e->brightest - margin,
              column_of(band, e->vega ? UM_LIGHTCURVE_MAG_VEGA : UM_LIGHTCURVE_MAG_AB));
}

static void lightcurve(struct um_plot *plot, const struct um_output_run *run)
{
  size_t n = run->model->nband;
  int height = UM_PLOT_TOP - UM_PLOT_KEY + UM_PLOT_BELOW, at = UM_PLOT_TOP;
  struct um_plot_time time = um_output_plot_time(run);
  for (size_t b = 0; b < n; b++) {
    struct extent e = extent_of(run, b);
    height += UM_PLOT_KEY + UM_PLOT_PANEL + (has_magnitudes(run, b, &e) ? GAP + MAGNITUDE : 0);
  }
  um_plot_picture(plot, "lightcurve", UM_PLOT_WIDTH, height);
  um_plot_title(plot, run->model->scenario->name, "");
  um_plot_time_axis(plot, &time);
  um_plot_shade(plot, &time, run->tables->nobs, run->tables->t_obs, run->tables->sunlit);
  um_plot_xnumbers(plot, false);
  for (size_t b = 0; b < n; b++) {
    struct extent e = extent_of(run, b);
    bool faint = has_magnitudes(run, b, &e);
    um_plot_panel(plot, UM_PLOT_LEFT, at, UM_PLOT_RIGHT, at + UM_PLOT_PANEL);
    double least = band_ordinate(plot, &run->model->band[b], &e);
    if (b + 1 == n && !faint) {
      um_plot_xnumbers(plot, true);
      um_plot_time_label(plot, &time);
    }
    intensity(plot, b, &e, least);
    at += UM_PLOT_PANEL + UM_PLOT_KEY;
    if (!faint) continue;
    um_plot_panel(plot, UM_PLOT_LEFT, at - UM_PLOT_KEY + GAP, UM_PLOT_RIGHT,
                  at - UM_PLOT_KEY + GAP + MAGNITUDE);
    if (b + 1 == n) {
      um_plot_xnumbers(plot, true);
      um_plot_time_label(plot, &time);
    }
    magnitudes(plot, b, &e);
    at += GAP + MAGNITUDE;
  }
}

/* ---- temperatures ---- */

static void temperatures(struct um_plot *plot, const struct um_output_run *run)
{
  struct um_plot_time time = um_output_plot_time(run);
  int style = 1;
  um_plot_picture(plot, "temperatures", UM_PLOT_WIDTH,
                  UM_PLOT_TOP - GAP + TEMPERATURES + UM_PLOT_BELOW);
  um_plot_title(plot, run->model->scenario->name,
                "mean temperatures; shaded: lowest to highest of each material");
  um_plot_time_axis(plot, &time);
  um_plot_shade(plot, &time, run->tables->nobs, run->tables->t_obs, run->tables->sunlit);
  um_plot_time_label(plot, &time);
  um_plot_ylabel(plot, "", "temperature [K]");
  um_plot_panel(plot, UM_PLOT_LEFT, UM_PLOT_TOP - GAP, NAMES, UM_PLOT_TOP - GAP + TEMPERATURES);
  um_plot_add(plot,
              "set key at screen %.4f, graph 1 left top vertical maxrows auto Left "
              "reverse noenhanced\nplot ",
              (NAMES + 12.0) / UM_PLOT_WIDTH);
  for (size_t p = 0; p < run->result->nplace; p++) {
    const char *name = run->result->place[p].name;
    bool material = strncmp(name, "material:", 9) == 0;
    const struct um_thermal_body *body = run->model->body;
    bool interior = p < body->nplace && body->place[p].kind == UM_PLACE_INTERIOR;
    if (!material && !interior) continue;
    if (style > 1) um_plot_add(plot, ", ");
    if (material)
      um_plot_add(plot,
                  "'temperatures.csv' every ::1 using (x(1)):%zu:%zu with filledcurves linetype %d "
                  "fillstyle transparent solid 0.12 noborder notitle, ",
                  3 + 3 * p, 4 + 3 * p, style);
    um_plot_add(plot,
                "'temperatures.csv' every ::1 using (x(1)):%zu with lines linewidth 2 linetype %d ",
                2 + 3 * p, style);
    if (interior) um_plot_add(plot, "dashtype (8,5) ");
    um_plot_add(plot, "title %s noenhanced", material ? name + 9 : name);
    style++;
  }
  um_plot_add(plot, style == 1 ? "NaN notitle\n" : "\n");
}

enum um_status um_output_plot_run(struct um_context *context, const char *folder,
                                  const struct um_output_run *run)
{
  struct um_plot *plot = NULL;
  UM_TRY(um_plot_create(context, folder, "plots.gp", &plot));
  if (run->model->has_observer) lightcurve(plot, run);
  if (run->model->has_observer && run->model->nsensor > 0) um_output_plot_counts(plot, run);
  if (run->model->has_observer) um_output_plot_grey_body(plot, run);
  temperatures(plot, run);
  return um_plot_draw(context, &plot);
}
