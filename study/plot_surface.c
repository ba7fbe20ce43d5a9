/* Response surfaces: the mean of a curve over the two parameters that rule it. With a surrogate on
 * a grid, the others at their medians; without one, the points themselves. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/csv.h"
#include "base/uncertainty/design.h"
#include "base/uncertainty/surrogate.h"
#include "study/per_point.h"
#include "study/plot_impl.h"

#define GRID   61 /* points of an axis */
#define WIDTH  760
#define HEIGHT 560
#define LEFT   104
#define RIGHT  600
#define TOP    84
#define BOTTOM 490

struct surface {
  const struct um_study_quantity *quantity;
  size_t x, y;        /* parameters */
  size_t first, last; /* rows of surface.csv */
  bool grid;          /* [GRID of y][GRID of x]; else a row a point */
  size_t count;
  double *row; /* [count][3] x, y and mean */
};

/* The two parameters with the largest shares, the first the larger; false: there are no two. */
static bool rulers(const struct um_study_result *r, const struct um_study_statistics *l, size_t q,
                   size_t *x, size_t *y)
{
  double best = -INFINITY, second = -INFINITY;
  for (size_t i = 0; i < r->nparameter; i++) {
    double share = l->over_curve[i * r->nquantity + q];
    if (!isfinite(share)) return false;
    if (share > best) {
      *y = *x;
      second = best;
      *x = i;
      best = share;
    } else if (share > second) {
      *y = i;
      second = share;
    }
  }
  return r->nparameter > 1;
}

static void put_row(struct surface *s, double x, double y, double value)
{
  double *row = s->row + 3 * s->count++;
  row[0] = x;
  row[1] = y;
  row[2] = value;
}

static void write_rows(FILE *file, const struct um_study_result *r, const struct surface *s)
{
  for (size_t i = 0; i < s->count; i++) {
    um_core_csv_put(file, s->quantity->name, "");
    um_core_csv_put_text(file, r->parameter_name[s->x], "");
    um_core_csv_put_text(file, r->parameter_name[s->y], "");
    for (size_t k = 0; k < 3; k++) um_core_csv_put_exact(file, s->row[3 * i + k]);
    fputs("\n", file);
  }
}

/* Rows of one line of the grid. value [GRID][nvalue]. */
static enum um_status grid_line(struct um_context *context, const struct um_study_result *r,
                                struct surface *s, size_t j, double *place, double *value)
{
  const struct um_uncertainty_distribution *law = r->distribution;
  double least[2], largest[2], at[2][GRID];
  um_uncertainty_distribution_ends(&law[s->x], &least[0], &largest[0]);
  um_uncertainty_distribution_ends(&law[s->y], &least[1], &largest[1]);
  for (size_t i = 0; i < GRID; i++) {
    at[0][i] = least[0] + (largest[0] - least[0]) * um_uncertainty_level(i, GRID, true);
    at[1][i] = least[1] + (largest[1] - least[1]) * um_uncertainty_level(j, GRID, true);
    for (size_t k = 0; k < r->nparameter; k++)
      place[i * r->nparameter + k] = um_uncertainty_distribution_place(
          &law[k], k == s->x   ? at[0][i]
                   : k == s->y ? at[1][i]
                               : um_uncertainty_distribution_value(&law[k], 0.5));
    for (size_t k = 0; k < r->nparameter; k++) /* rounding at the ends */
      place[i * r->nparameter + k] = fmin(fmax(place[i * r->nparameter + k], 0.0), 1.0);
  }
  UM_TRY(um_uncertainty_surrogate_at(context, r->surrogate, place, GRID, value));
  for (size_t i = 0; i < GRID; i++)
    put_row(s, at[0][i], at[1][i],
            um_study_statistic_of(s->quantity,
                                  value + i * um_uncertainty_surrogate_values(r->surrogate) +
                                      s->quantity->first,
                                  UM_STUDY_MEAN));
  return UM_OK;
}

static enum um_status on_grid(struct um_context *context, const struct um_study_result *r,
                              struct surface *s)
{
  enum um_status status;
  double *place = NULL, *value = NULL;
  UM_CHECK(um_core_allocate(context, GRID, r->nparameter * sizeof *place, &place));
  UM_CHECK(um_core_allocate(context, GRID,
                            um_uncertainty_surrogate_values(r->surrogate) * sizeof *value, &value));
  for (size_t j = 0; j < GRID; j++) UM_CHECK(grid_line(context, r, s, j, place, value));
done:
  UM_FREE(context, place, value);
  return status;
}

static void at_points(const struct um_study_result *r, struct surface *s)
{
  for (size_t i = 0; i < r->npoint; i++)
    put_row(s, r->parameter[i * r->nparameter + s->x], r->parameter[i * r->nparameter + s->y],
            um_study_statistic_of(s->quantity, um_study_result_values(r, i, s->quantity),
                                  UM_STUDY_MEAN));
}

static void axes(struct um_plot *plot, const struct um_study_result *r, const struct surface *s)
{
  char words[300];
  double least[2], largest[2];
  um_study_plot_xaxis(plot, r, s->x, RIGHT - LEFT);
  for (size_t i = 0; i < 2; i++) {
    size_t parameter = i == 0 ? s->x : s->y;
    if (r->distribution != NULL && r->surrogate != NULL)
      um_uncertainty_distribution_ends(&r->distribution[parameter], &least[i], &largest[i]);
    else
      um_study_extent(r, parameter, &least[i], &largest[i]);
  }
  um_plot_add(plot, "set xrange [%.9g:%.9g]\nset yrange [%.9g:%.9g]\n", least[0], largest[0],
              least[1], largest[1]);
  um_study_axis_words(r, s->y, words, sizeof words);
  um_plot_ylabel(plot, words, "");
}

static void picture(struct um_plot *plot, const struct um_study_result *r, const struct surface *s,
                    double largest)
{
  char name[200], unit[100], below[300];
  bool grid = r->surrogate != NULL && r->distribution != NULL;
  snprintf(name, sizeof name, "surface_%s", s->quantity->name);
  double power = um_study_axis_unit(s->quantity, largest, unit);
  um_plot_picture(plot, name, WIDTH, HEIGHT);
  snprintf(below, sizeof below, "mean of %s over time%s", s->quantity->name,
           r->nparameter < 3 ? ""
           : grid            ? "; other parameters at their medians"
                             : "; other parameters vary too");
  um_plot_title(plot, r->name, below);
  um_plot_panel(plot, LEFT, TOP, RIGHT, BOTTOM);
  axes(plot, r, s);
  /* cividis: rising lightness, told apart by colour-blind readers; in steps that read as contours
   */
  um_plot_add(plot,
              "set palette defined (0 '#00224e', 0.25 '#35456c', 0.5 '#7c7b78', 0.75 '#bcae6c', 1 "
              "'#fee838') maxcolors 16\nset colorbox user origin screen %.4f,%.4f size screen "
              "%.4f,%.4f\nset format cb '%%g'\nset cblabel %s offset 1,0\nset cbrange [*:*]\n",
              (RIGHT + 18.0) / WIDTH, 1.0 - (double)BOTTOM / HEIGHT, 18.0 / WIDTH,
              (double)(BOTTOM - TOP) / HEIGHT, unit);
  um_plot_add(plot, "plot 'surface.csv' every ::%zu::%zu using 4:5:(column(6) / %g) with ",
              s->first, s->last, power);
  um_plot_add(plot, grid ? "image notitle" : "points pointtype 7 pointsize 0.9 palette notitle");
  if (isfinite(r->at_nominal[s->x]) && isfinite(r->at_nominal[s->y])) {
    um_plot_add(plot,
                ", '+' every ::0::0 using (%.9g):(%.9g) with points pointtype 6 pointsize 1.6 "
                "linewidth 3 linecolor rgb '#ffffff' notitle",
                r->at_nominal[s->x], r->at_nominal[s->y]);
    um_plot_add(plot,
                ", '+' every ::0::0 using (%.9g):(%.9g) with points pointtype 6 pointsize 1.6 "
                "linewidth 1.5 linecolor rgb '#d55e00' title 'as the scenario stands'",
                r->at_nominal[s->x], r->at_nominal[s->y]);
  }
  um_plot_add(plot, "\n");
}

/* The surfaces of a study, of its arena: *out [*n]; none where nobody knows who rules. */
static enum um_status find(struct um_context *context, const struct um_study_result *r,
                           const struct um_study_statistics *l, struct um_core_arena *memory,
                           struct surface **out, size_t *n)
{
  size_t row = 1, x = 0, y = 0;
  bool any_light = false, grid = r->surrogate != NULL && r->distribution != NULL;
  *n = 0;
  UM_TRY(um_core_arena_allocate(context, memory, r->nquantity, sizeof **out, out));
  if (l->over_curve == NULL || r->nparameter < 2) return UM_OK;
  for (size_t q = 0; q < r->nquantity; q++)
    any_light = any_light || (r->quantity[q].light && um_study_is_curve(r, &r->quantity[q]));
  for (size_t q = 0; q < r->nquantity; q++) {
    const struct um_study_quantity *of = &r->quantity[q];
    if (!um_study_is_curve(r, of) || of->light != any_light || !rulers(r, l, q, &x, &y)) continue;
    struct surface *at = &(*out)[(*n)++];
    *at = (struct surface){.quantity = of, .x = x, .y = y, .first = row, .grid = grid};
    UM_TRY(um_core_arena_allocate(context, memory, 3 * (grid ? (size_t)GRID * GRID : r->npoint),
                                  sizeof *at->row, &at->row));
    if (grid)
      UM_TRY(on_grid(context, r, at));
    else
      at_points(r, at);
    at->last = at->first + at->count - 1;
    row = at->last + 1;
  }
  return UM_OK;
}

enum um_status um_study_plot_surfaces(struct um_context *context, struct um_plot *plot,
                                      const struct um_study_result *result,
                                      const struct um_study_statistics *statistics,
                                      struct um_core_folder *folder)
{
  enum um_status status;
  struct um_core_arena memory = {0};
  struct surface *s;
  size_t n = 0;
  FILE *file = NULL;
  UM_CHECK(find(context, result, statistics, &memory, &s, &n));
  if (statistics->over_curve == NULL || result->nparameter < 2) goto done;
  UM_CHECK(um_core_folder_open(context, folder, "surface.csv", &file));
  fputs("quantity,x_parameter,y_parameter,x,y,mean\n", file);
  for (size_t i = 0; i < n; i++) write_rows(file, result, &s[i]);
  UM_CHECK(um_core_file_close(context, "surface.csv", &file));
  for (size_t i = 0; i < n; i++) {
    double largest = 0.0;
    size_t q = (size_t)(s[i].quantity - result->quantity);
    for (size_t k = 0; k < result->quantity[q].count; k++) {
      double v = fabs(statistics->mean[result->quantity[q].first + k]);
      largest = fmax(largest, v);
    }
    picture(plot, result, &s[i], 0.5 * largest);
  }
done:
  um_core_arena_release(context, &memory);
  return status;
}

/* A grid as a map; places of its axes are those of its first row and column. */
static enum um_status put_map(struct um_page_writer *w, const struct um_study_result *r,
                              const struct surface *s, size_t index)
{
  double *x, *y, *z;
  char id[40], title[300];
  const char *unit[2] = {r->parameter_unit[s->x], r->parameter_unit[s->y]};
  UM_TRY(UM_PAGE_ROOM(w, GRID, &x));
  UM_TRY(UM_PAGE_ROOM(w, GRID, &y));
  UM_TRY(UM_PAGE_ROOM(w, s->count, &z));
  for (size_t i = 0; i < GRID; i++) {
    x[i] = s->row[3 * i];
    y[i] = s->row[3 * i * GRID + 1];
  }
  for (size_t i = 0; i < s->count; i++) z[i] = s->row[3 * i + 2];
  snprintf(id, sizeof id, "surface-%zu", index + 1);
  snprintf(title, sizeof title, "Mean of %.200s over time", s->quantity->name);
  const struct um_page_figure figure = {
      .id = id,
      .title = title,
      .text = r->nparameter > 2 ? "Other parameters stand at their medians." : NULL};
  const struct um_page_axis across = {r->parameter_name[s->x], unit[0][0] != '\0' ? unit[0] : "1",
                                      UM_PAGE_LINEAR, x, GRID};
  const struct um_page_axis up = {r->parameter_name[s->y], unit[1][0] != '\0' ? unit[1] : "1",
                                  UM_PAGE_LINEAR, y, GRID};
  um_page_map(w->page, &figure, &across, &up, s->quantity->name, s->quantity->unit, z, false);
  return UM_OK;
}

enum um_status um_study_page_surfaces(struct um_page_writer *w,
                                      const struct um_study_result *result,
                                      const struct um_study_statistics *statistics)
{
  struct surface *s;
  size_t n = 0;
  UM_TRY(find(w->context, result, statistics, &w->memory, &s, &n));
  if (n == 0 || !s[0].grid) return UM_OK; /* points alone are shown one by one */
  um_page_section(w->page, "surfaces", "How do the two strongest parameters act together?",
                  UM_PAGE_PLAIN);
  for (size_t i = 0; i < n; i++) UM_TRY(put_map(w, result, &s[i], i));
  return UM_OK;
}
