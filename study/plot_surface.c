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

static void put_row(FILE *file, const struct um_study_result *r, const struct surface *s, double x,
                    double y, double value)
{
  um_core_csv_put(file, s->quantity->name, "");
  um_core_csv_put_text(file, r->parameter_name[s->x], "");
  um_core_csv_put_text(file, r->parameter_name[s->y], "");
  um_core_csv_put_exact(file, x);
  um_core_csv_put_exact(file, y);
  um_core_csv_put_exact(file, value);
  fputs("\n", file);
}

/* Rows of one line of the grid. value [GRID][nvalue]. */
static enum um_status grid_line(struct um_context *context, const struct um_study_result *r,
                                const struct surface *s, size_t j, double *place, double *value,
                                FILE *file)
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
    put_row(file, r, s, at[0][i], at[1][i],
            um_study_statistic_of(s->quantity,
                                  value + i * um_uncertainty_surrogate_values(r->surrogate) +
                                      s->quantity->first,
                                  UM_STUDY_MEAN));
  return UM_OK;
}

static enum um_status on_grid(struct um_context *context, const struct um_study_result *r,
                              struct surface *s, FILE *file)
{
  enum um_status status;
  double *place = NULL, *value = NULL;
  UM_CHECK(um_core_allocate(context, GRID, r->nparameter * sizeof *place, &place));
  UM_CHECK(um_core_allocate(context, GRID,
                            um_uncertainty_surrogate_values(r->surrogate) * sizeof *value, &value));
  for (size_t j = 0; j < GRID; j++) UM_CHECK(grid_line(context, r, s, j, place, value, file));
  s->last = s->first + (size_t)GRID * GRID - 1;
done:
  UM_FREE(context, place, value);
  return status;
}

static void at_points(const struct um_study_result *r, struct surface *s, FILE *file)
{
  for (size_t i = 0; i < r->npoint; i++)
    put_row(file, r, s, r->parameter[i * r->nparameter + s->x],
            r->parameter[i * r->nparameter + s->y],
            um_study_statistic_of(s->quantity, um_study_result_values(r, i, s->quantity),
                                  UM_STUDY_MEAN));
  s->last = s->first + r->npoint - 1;
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

static enum um_status write(struct um_context *context, const struct um_study_result *r,
                            const struct um_study_statistics *l, struct surface *s, size_t *n,
                            FILE *file)
{
  size_t row = 1, x = 0, y = 0;
  bool any_light = false;
  for (size_t q = 0; q < r->nquantity; q++)
    any_light = any_light || (r->quantity[q].light && um_study_is_curve(r, &r->quantity[q]));
  fputs("quantity,x_parameter,y_parameter,x,y,mean\n", file);
  *n = 0;
  for (size_t q = 0; q < r->nquantity; q++) {
    const struct um_study_quantity *of = &r->quantity[q];
    if (!um_study_is_curve(r, of) || of->light != any_light || !rulers(r, l, q, &x, &y)) continue;
    struct surface *at = &s[(*n)++];
    *at = (struct surface){.quantity = of, .x = x, .y = y, .first = row};
    if (r->surrogate != NULL && r->distribution != NULL)
      UM_TRY(on_grid(context, r, at, file));
    else
      at_points(r, at, file);
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
  struct surface *s = NULL;
  size_t n = 0;
  FILE *file = NULL;
  if (statistics->over_curve == NULL || result->nparameter < 2) return UM_OK;
  UM_TRY(um_core_allocate(context, result->nquantity, sizeof *s, &s));
  UM_CHECK(um_core_folder_open(context, folder, "surface.csv", &file));
  status = write(context, result, statistics, s, &n, file);
  enum um_status closed = um_core_file_close(context, "surface.csv", &file);
  if (status == UM_OK) status = closed;
  for (size_t i = 0; i < n && status == UM_OK; i++) {
    double largest = 0.0;
    size_t q = (size_t)(s[i].quantity - result->quantity);
    for (size_t k = 0; k < result->quantity[q].count; k++) {
      double v = fabs(statistics->mean[result->quantity[q].first + k]);
      largest = fmax(largest, v);
    }
    picture(plot, result, &s[i], 0.5 * largest);
  }
done:
  um_core_free(context, s);
  return status;
}
