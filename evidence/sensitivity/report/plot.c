/* The strongest parameters over the times of a matrix, one panel a curve. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "evidence/comparison/shade.h"
#include "evidence/sensitivity/report/rank.h"
#include "evidence/sensitivity/report/write.h"
#include "orbit/time.h"

#define STRONGEST 6 /* parameters of a panel */
#define CURVES    4 /* panels at most */

/* Pixels. */
#define WIDTH   1000
#define LEFT    100
#define RIGHT   720
#define TOP     74
#define PANEL   280
#define BETWEEN 26
#define BELOW   58

/* A parameter has one colour in all panels. */
static const char *const colour[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                     "#e69f00", "#56b4e9", "#7b3294", "#8c6d31",
                                     "#333333", "#e7298a", "#66a61e", "#999999"};
#define COLOURS (sizeof colour / sizeof colour[0])

/* What is drawn: leaders of each panel. */
struct shown {
  struct um_sensitivity_report_leader leader[CURVES][STRONGEST];
  size_t n[CURVES], panels, first; /* first: group of panel 0 */
};

/* The number of a row among all that are shown, in the order of panels. */
static size_t colour_of(const struct shown *s, size_t row)
{
  size_t seen[CURVES * STRONGEST], n = 0;
  for (size_t i = 0; i < s->panels; i++)
    for (size_t k = 0; k < s->n[i]; k++) {
      size_t at = 0;
      while (at < n && seen[at] != s->leader[i][k].row) at++;
      if (at == n) seen[n++] = s->leader[i][k].row;
      if (s->leader[i][k].row == row) return at % COLOURS;
    }
  return 0;
}

/* "shift +0.03", of a switch "turned on". */
static void width_text(const struct um_sensitivity_row *row, char out[160])
{
  if (row->quality.way == UM_SENSITIVITY_BY_SWITCH) {
    snprintf(out, 160, "turned on");
    return;
  }
  bool plain = strcmp(row->unit, "1") == 0;
  snprintf(out, 160, "%.80s +%.3g%s%.40s", row->candidate->effect->parameters[row->parameter].name,
           row->width, plain ? "" : " ", plain ? "" : row->unit);
}

/* Curve of a leader as table `number`, in percent of the size, or kelvin. */
static enum um_status put_curve(struct um_context *context, const struct um_sensitivity_matrix *m,
                                const struct um_sensitivity_report_leader *l, size_t number,
                                const struct um_plot_time *time, struct um_plot *plot)
{
  const struct um_sensitivity_row *row = &m->row[l->row];
  const struct um_sensitivity_curve *curve = &m->curve[l->curve];
  double gap, *value, scale = row->width * (curve->temperature ? 1.0 : 100.0 / curve->size);
  UM_TRY(um_plot_gap(context, m->ntime, m->time, &gap));
  UM_TRY(um_core_allocate(context, m->ntime, sizeof *value, &value));
  for (size_t k = 0; k < m->ntime; k++) value[k] = row->column[l->curve * m->ntime + k] * scale;
  um_plot_curve(plot, time, number, m->ntime, m->time, value, gap);
  um_core_free(context, value);
  return UM_OK;
}

/* Names in their colours, beside the panel. */
static void put_labels(const struct um_sensitivity_matrix *m, const struct shown *s, size_t panel,
                       struct um_plot *plot)
{
  for (size_t i = 0; i < s->n[panel]; i++) {
    const struct um_sensitivity_report_leader *l = &s->leader[panel][i];
    const struct um_sensitivity_row *row = &m->row[l->row];
    double y = 0.97 - 0.165 * (double)i;
    char words[160], where[300];
    width_text(row, words);
    snprintf(where, sizeof where, "%s%s%.80s", words, m->curve[l->curve].temperature ? ", " : "",
             m->curve[l->curve].temperature ? m->curve[l->curve].name : "");
    um_plot_add(plot,
                "set label %zu %s at graph 1.025, graph %g left noenhanced textcolor rgb %s\n"
                "set label %zu %s at graph 1.025, graph %g left noenhanced textcolor rgb "
                "'#666666'\n",
                2 * i + 1, row->candidate->name, y, colour[colour_of(s, l->row)], 2 * i + 2, where,
                y - 0.07);
  }
}

static void put_panel(const struct um_sensitivity_matrix *m, const struct shown *s, size_t panel,
                      struct um_plot *plot)
{
  const struct um_sensitivity_report_group g = um_sensitivity_report_group(m, s->first + panel);
  bool heat = g.first >= m->nlight;
  um_plot_ylabel(plot, heat ? "temperatures" : g.name, heat ? "change [K]" : "change [% of peak]");
  put_labels(m, s, panel, plot);
  um_plot_add(plot, "unset key\nset yrange [*:*]\nplot 0 with lines linecolor rgb '#888888'");
  for (size_t i = 0; i < s->n[panel]; i++)
    um_plot_add(plot, ", $curve%zu using 1:2 with lines linewidth 2 linecolor rgb %s",
                STRONGEST * panel + i, colour[colour_of(s, s->leader[panel][i].row)]);
  um_plot_add(plot, "\n");
  for (size_t i = 0; i < 2 * s->n[panel]; i++) um_plot_add(plot, "unset label %zu\n", i + 1);
}

/* Leaders of every panel, and their curves. */
static enum um_status choose(struct um_context *context, const struct um_sensitivity_matrix *m,
                             const struct um_plot_time *time, struct shown *s, struct um_plot *plot)
{
  size_t groups = um_sensitivity_report_groups(m);
  s->first = m->nlight > 0 ? 0 : groups - 1;
  s->panels = m->nlight > 0 ? m->nlight : 1;
  if (s->panels > CURVES) s->panels = CURVES;
  for (size_t i = 0; i < s->panels; i++) {
    const struct um_sensitivity_report_group g = um_sensitivity_report_group(m, s->first + i);
    s->n[i] = um_sensitivity_report_leaders(m, &g, 0, m->ntime, false, STRONGEST, s->leader[i]);
    for (size_t k = 0; k < s->n[i]; k++)
      UM_TRY(put_curve(context, m, &s->leader[i][k], STRONGEST * i + k, time, plot));
  }
  return UM_OK;
}

static enum um_status put_script(struct um_context *context, const struct um_sensitivity_matrix *m,
                                 struct um_plot *plot)
{
  char start[32], title[300];
  struct shown shown = {.panels = 0};
  if (m->ncurve == 0) return UM_OK;
  um_orbit_time_format(m->time[0], start);
  const struct um_plot_time time = um_plot_time(m->time[0], m->time[m->ntime - 1], start);
  UM_TRY(choose(context, m, &time, &shown, plot));
  um_plot_picture(plot, "sensitivity", WIDTH,
                  TOP + (int)shown.panels * (PANEL + BETWEEN) - BETWEEN + BELOW);
  snprintf(title, sizeof title, "%.100s: what moves it most", m->forward->model->scenario->name);
  um_plot_title(
      plot, title,
      "linear answer to one width of each parameter's prior; calibration and air left out");
  um_plot_time_axis(plot, &time);
  UM_TRY(um_compare_plot_shade(context, m->forward->model, &time, plot));
  for (size_t i = 0; i < shown.panels; i++) {
    int top = TOP + (int)i * (PANEL + BETWEEN);
    um_plot_xnumbers(plot, i + 1 == shown.panels);
    um_plot_panel(plot, LEFT, top, RIGHT, top + PANEL);
    if (i + 1 == shown.panels) um_plot_time_label(plot, &time);
    put_panel(m, &shown, i, plot);
  }
  return UM_OK;
}

enum um_status um_sensitivity_report_plot(struct um_context *context,
                                          const struct um_sensitivity_matrix *matrix,
                                          const char *folder)
{
  struct um_plot *plot;
  UM_TRY(um_plot_create(context, folder, "plots.gp", &plot));
  enum um_status status = put_script(context, matrix, plot);
  if (status == UM_OK) status = um_plot_draw(context, &plot);
  um_plot_destroy(context, &plot);
  return status;
}
