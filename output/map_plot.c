/* map.png and pass.png from map.csv, pass.csv and measured.csv. */
#include <math.h>
#include <stdio.h>

#include "base/core/constants.h"
#include "orbit/time.h"
#include "output/map.h"
#include "output/plot_impl.h"

#define COLUMNS 3
#define DECADES 1e-5 /* lower end of the scale, of the largest of a band */
#define FLAT    0.2  /* smallest over largest of a band above which the scale is linear, from 0 */

/* Pixels. */
#define LEFT   96
#define TOP    88
#define WIDE   400
#define HIGH   200
#define GAP    14
#define SCALE  16 /* width of the colour bar */
#define RIGHT  128
#define BOTTOM 58

static size_t shown_count(const struct um_model_map *map)
{
  return map->nphase < COLUMNS ? map->nphase : COLUMNS;
}

/* Phase angle of a column: all of them, or the first, the middle and the last. */
static size_t shown_at(const struct um_model_map *map, size_t column)
{
  size_t n = shown_count(map);
  return n < 2 ? 0 : (column * (map->nphase - 1) + (n - 1) / 2) / (n - 1);
}

/* Phase angles to which a column is the nearest of those shown [deg]. */
static void nearest(const struct um_model_map *map, size_t column, double out[2])
{
  double own = map->phase_angle[shown_at(map, column)] / UM_DEG;
  out[0] = -1.0;
  out[1] = 181.0;
  if (column > 0) out[0] = 0.5 * (own + map->phase_angle[shown_at(map, column - 1)] / UM_DEG);
  if (column + 1 < shown_count(map))
    out[1] = 0.5 * (own + map->phase_angle[shown_at(map, column + 1)] / UM_DEG);
}

/* Colours of a band over the phase angles that are drawn [m^2/sr]: from the smallest to the
 * largest, at most five decades. */
struct scale {
  double low, high;
  bool logarithmic;
};

static struct scale scale_of(const struct um_model_map *map, size_t band)
{
  struct scale s = {.low = INFINITY};
  for (size_t c = 0; c < shown_count(map); c++)
    for (size_t i = 0; i < map->nlatitude; i++)
      for (size_t j = 0; j < map->nlongitude; j++) {
        double mean = um_model_map_node(map, shown_at(map, c), i, j, band).mean;
        s.low = fmin(s.low, mean);
        s.high = fmax(s.high, mean);
      }
  if (!(s.high > 0.0)) s.high = 1.0;
  s.logarithmic = !(s.low > FLAT * s.high);
  s.low = s.logarithmic ? fmax(s.low, DECADES * s.high) : 0.0;
  return s;
}

/* ---- the map ---- */

static void overlay(struct um_plot *plot, const struct um_output_map *of, size_t band,
                    size_t column)
{
  double range[2];
  nearest(of->map, column, range);
  if (of->pass != NULL)
    um_plot_add(plot,
                ", 'pass.csv' every ::1 using ($4>=%g && $4<%g ? $3 : NaN):2 with points "
                "pointtype 7 pointsize 0.22 linecolor rgb %s notitle",
                range[0], range[1], "#7fd4ff");
  if (!of->measured) return;
  size_t value = UM_OUTPUT_MEASURED_FIRST + UM_OUTPUT_MEASURED_BAND * band + 1;
  for (int filled = 0; filled < 2; filled++) { /* a disc in the map's colours on a white one */
    um_plot_add(plot,
                ", 'measured.csv' every ::1 using ($7>=%g && $7<%g ? $6 : NaN):5:(bound($%zu)) "
                "with points pointtype 7 ",
                range[0], range[1], value);
    um_plot_add(plot, filled ? "pointsize 0.75 linecolor palette notitle"
                             : "pointsize 1.0 linecolor '#ffffff' notitle");
  }
}

static void panel(struct um_plot *plot, const struct um_output_map *of, size_t band, size_t column)
{
  const struct um_model_map *map = of->map;
  const struct um_optics_band *b = &of->model->band[band];
  size_t columns = shown_count(map), g = shown_at(map, column);
  size_t nodes = map->nlatitude * map->nlongitude;
  int left = LEFT + (int)column * (WIDE + GAP), top = TOP + (int)band * (HIGH + GAP);
  char text[200];
  snprintf(text, sizeof text, "phase angle %g°%s", map->phase_angle[g] / UM_DEG,
           map->nplane[g] > 1 ? ", mean over its planes" : "");
  um_plot_panel(plot, left, top, left + WIDE, top + HIGH);
  if (band == 0)
    um_plot_add(plot, "set label 10 %s at graph 0.5,1.07 center font ',10'\n", text);
  else
    um_plot_add(plot, "unset label 10\n");
  um_plot_add(plot, column == 0 ? "set format y '%%g°'\n" : "set format y ''\n");
  um_plot_add(plot, band + 1 == map->nband
                        ? "set format x '%%g°'\nset xlabel 'longitude of the phase vector'\n"
                        : "set format x ''\nunset xlabel\n");
  snprintf(text, sizeof text, "%.150s %g–%g µm", b->name, b->from * 1e6, b->to * 1e6);
  um_plot_ylabel(plot, column == 0 ? text : "", column == 0 ? "latitude" : "");
  if (column + 1 == columns) {
    double width = LEFT + (double)columns * (WIDE + GAP) + RIGHT;
    double height = TOP + (double)map->nband * (HIGH + GAP) + BOTTOM;
    um_plot_add(plot,
                "set colorbox user origin screen %.5f,%.5f size screen %.5f,%.5f\n"
                "set cblabel 'reflectivity [m^2/sr]' offset 1,0\n",
                (left + WIDE + GAP) / width, 1.0 - (top + HIGH) / height, SCALE / width,
                HIGH / height);
  } else {
    um_plot_add(plot, "unset colorbox\n");
  }
  um_plot_add(plot, "plot 'map.csv' every ::%zu::%zu using 3:2:(bound($%zu)) with image notitle",
              1 + g * nodes, (g + 1) * nodes, 4 + 3 * band);
  overlay(plot, of, band, column);
  um_plot_add(plot, "\n");
}

/* What lies on the map. */
static const char *words_of(const struct um_output_map *of)
{
  if (of->pass != NULL && of->measured)
    return "light blue: the pass; discs in white: measured, in the map’s colours";
  if (of->pass != NULL) return "light blue: the pass";
  return of->measured ? "discs in white: measured, in the map’s colours" : "";
}

static void maps(struct um_plot *plot, const struct um_output_map *of)
{
  const struct um_model_map *map = of->map;
  size_t columns = shown_count(map);
  double step = map->step / UM_DEG;
  um_plot_picture(plot, "map", LEFT + (int)columns * (WIDE + GAP) + RIGHT,
                  TOP + (int)map->nband * (HIGH + GAP) + BOTTOM);
  um_plot_title(plot, of->model->scenario->name, words_of(of));
  um_plot_add(plot,
              "set xtics 60\nset ytics 30\nset xrange [%g:%g]\nset yrange [%g:%g]\n"
              "set grid xtics ytics front linetype 1 linewidth 0.4 linecolor '#60888888'\n"
              "set palette defined (0 '#000004', 0.15 '#2b0b57', 0.4 '#982766', 0.65 '#e65d2f', "
              "0.85 '#fcb519', 1 '#fcffa4')\n",
              -180.0 - 0.5 * step, 180.0 - 0.5 * step, -90.0 - 0.5 * step, 90.0 + 0.5 * step);
  for (size_t b = 0; b < map->nband; b++) {
    struct scale scale = scale_of(map, b);
    um_plot_add(plot, scale.logarithmic ? "set logscale cb\nset format cb '10^{%%T}'\n"
                                        : "unset logscale cb\nset format cb '%%g'\n");
    um_plot_add(plot, "low = %.6g\nbound(v) = v > low ? v : low\nset cbrange [low:%.6g]\n",
                scale.low, scale.high);
    for (size_t c = 0; c < columns; c++) panel(plot, of, b, c);
  }
}

/* ---- the light curve ---- */

static void extent(const struct um_model_map_pass *p, size_t band, double *largest, double *mean)
{
  size_t n = 0;
  *largest = *mean = 0.0;
  for (size_t i = 0; i < p->n; i++) {
    size_t at = i * p->nband + band;
    double direct = p->light[at] * p->direct[at];
    double looked_up = p->light[at] * fmax(p->looked_up[at], p->smallest[at]);
    if (isfinite(looked_up)) *largest = fmax(*largest, fmax(direct, looked_up));
    if (!(p->light[at] > 0.0)) continue;
    *mean += direct;
    n++;
  }
  if (n > 0) *mean /= (double)n;
}

static void curves(struct um_plot *plot, const struct um_output_map *of, size_t band)
{
  const struct um_optics_band *b = &of->model->band[band];
  size_t first = 14 + 4 * band;
  double largest, mean;
  char name[200], zero[80];
  extent(of->pass, band, &largest, &mean);
  snprintf(name, sizeof name, "%.150s %g–%g µm", b->name, b->from * 1e6, b->to * 1e6);
  snprintf(zero, sizeof zero, "looked up at %g°", of->map->phase_angle[0] / UM_DEG);
  um_output_plot_ordinate(plot, name, "sunlight reflected", "W/sr", largest, mean);
  um_plot_add(
      plot,
      "plot 'pass.csv' every ::1 using (x(1)):(v(%zu)) with lines linewidth 3 linecolor rgb "
      "%s title 'direct', '' every ::1 using (x(1)):(v(%zu)) with lines linewidth 1.6 "
      "linecolor rgb %s title 'looked up', '' every ::1 using (x(1)):(v(%zu)) with lines "
      "linewidth 1.2 dashtype (8,5) linecolor rgb %s title %s\n",
      first + 2, "#b9c4d6", first, "#b3261e", first + 1, "#2f855a", zero);
}

static enum um_status pass(struct um_context *context, struct um_plot *plot,
                           const struct um_output_map *of)
{
  const struct um_model_map_pass *p = of->pass;
  char start[32];
  double *sunlit = NULL;
  UM_TRY(um_core_allocate(context, p->n, sizeof *sunlit, &sunlit));
  for (size_t i = 0; i < p->n; i++) sunlit[i] = p->sample[i].sunlit_fraction;
  um_orbit_time_format(p->t[0], start);
  struct um_plot_time time = um_plot_time(p->t[0], p->t[p->n - 1], start);
  int n = (int)p->nband, at = UM_PLOT_TOP;
  um_plot_picture(plot, "pass", UM_PLOT_WIDTH,
                  UM_PLOT_TOP + n * (UM_PLOT_PANEL + UM_PLOT_KEY) - UM_PLOT_KEY + UM_PLOT_BELOW);
  um_plot_title(plot, of->model->scenario->name, "sunlight by the reflectivity map and without it");
  um_plot_time_axis(plot, &time);
  um_plot_shade(plot, &time, p->n, p->t, sunlit);
  um_core_free(context, sunlit);
  um_plot_xnumbers(plot, false);
  for (int b = 0; b < n; b++) {
    um_plot_panel(plot, UM_PLOT_LEFT, at, UM_PLOT_RIGHT, at + UM_PLOT_PANEL);
    if (b + 1 == n) {
      um_plot_xnumbers(plot, true);
      um_plot_time_label(plot, &time);
    }
    curves(plot, of, (size_t)b);
    at += UM_PLOT_PANEL + UM_PLOT_KEY;
  }
  return UM_OK;
}

enum um_status um_output_plot_map(struct um_context *context, const struct um_output_map *of,
                                  const char *folder)
{
  struct um_plot *plot = NULL;
  UM_TRY(um_plot_create(context, folder, "map.gp", &plot));
  maps(plot, of);
  if (of->pass != NULL && of->pass->n > 0) {
    enum um_status status = pass(context, plot, of);
    if (status != UM_OK) {
      um_plot_destroy(context, &plot);
      return status;
    }
  }
  return um_plot_draw(context, &plot);
}
