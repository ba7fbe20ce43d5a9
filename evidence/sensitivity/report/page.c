/* report.html of a matrix of sensitivities: sliders that move the curves, and what moves most. */
#include <math.h>
#include <string.h>

#include "evidence/comparison/shade.h"
#include "evidence/sensitivity/report/rank.h"
#include "evidence/sensitivity/report/write.h"
#include "orbit/time.h"

#define BARS    15      /* parameters of a picture */
#define NUMBERS 1000000 /* derivatives of a page, at most: temperatures stay away beyond that */

struct work {
  struct um_page_writer *p;
  struct um_page *page; /* the writer's */
  const struct um_sensitivity_matrix *m;
};

/* Rows with a column, the strongest in light first: *out [*count] of the arena. */
static enum um_status order(struct work *w, size_t **out, size_t *count)
{
  const struct um_sensitivity_matrix *m = w->m;
  double *strength;
  *count = 0;
  UM_TRY(UM_PAGE_ROOM(w->p, m->nrow, out));
  UM_TRY(UM_PAGE_ROOM(w->p, m->nrow, &strength));
  for (size_t i = 0; i < m->nrow; i++) {
    if (m->row[i].column == NULL) continue;
    double most = 0.0;
    for (size_t c = 0; c < (m->nlight > 0 ? m->nlight : m->ncurve); c++)
      most = fmax(most,
                  um_sensitivity_matrix_strength(m, &m->row[i], c, 0, m->ntime, m->row[i].width));
    size_t at = (*count)++;
    for (; at > 0 && strength[at - 1] < most; at--) {
      strength[at] = strength[at - 1];
      (*out)[at] = (*out)[at - 1];
    }
    strength[at] = most;
    (*out)[at] = i;
  }
  return UM_OK;
}

static enum um_status sliders(struct work *w, const size_t *row, size_t nrow)
{
  static const struct um_page_figure figure = {
      .id = "what-if",
      .title = "What if?",
      .text = "Move a parameter: the curves follow their derivatives. Within the marked interval "
              "the answer is within 1 % of each curve's size."};
  const struct um_sensitivity_matrix *m = w->m;
  size_t ncurve = nrow * m->ncurve * m->ntime <= NUMBERS ? m->ncurve : m->nlight;
  struct um_page_slider *slider;
  struct um_page_curve *curve;
  UM_TRY(UM_PAGE_ROOM(w->p, nrow, &slider));
  UM_TRY(UM_PAGE_ROOM(w->p, ncurve, &curve));
  for (size_t i = 0; i < nrow; i++) {
    const struct um_sensitivity_row *r = &m->row[row[i]];
    bool on = r->quality.way == UM_SENSITIVITY_BY_SWITCH;
    const char *label;
    UM_TRY(um_page_words(w->p, &label, "%s%s%s", r->candidate->name, on ? "" : ", ",
                         on ? "" : r->candidate->effect->parameters[r->parameter].name));
    slider[i] = (struct um_page_slider){
        .name = r->name,
        .label = label,
        .unit = r->unit,
        .null_value = r->null_value,
        .minimum = r->minimum,
        .maximum = r->maximum,
        .reach = r->quality.reach,
        .width = r->width,
        .is_switch = on,
        .logarithmic = !on && r->candidate->effect->parameters[r->parameter].logarithmic,
        .text = r->why};
  }
  for (size_t c = 0; c < ncurve; c++) {
    const double **derivative;
    double *error;
    UM_TRY(UM_PAGE_ROOM(w->p, nrow, &derivative));
    UM_TRY(UM_PAGE_ROOM(w->p, nrow, &error));
    for (size_t i = 0; i < nrow; i++) {
      derivative[i] = m->row[row[i]].column + c * m->ntime;
      error[i] = m->row[row[i]].quality.error;
    }
    curve[c] =
        (struct um_page_curve){.name = m->curve[c].name,
                               .unit = m->curve[c].unit,
                               .panel = m->curve[c].temperature ? "temperature" : m->curve[c].name,
                               .base = m->value + c * m->ntime,
                               .derivative = derivative,
                               .error = error};
  }
  um_page_section(w->page, "what-if", "What if a value were another?", UM_PAGE_PLAIN);
  um_page_sliders(w->page, &figure, &w->p->time, w->p->shade, w->p->nshade, slider, nrow, curve,
                  ncurve);
  return UM_OK;
}

/* The strongest of a group, by what one width of their prior does. */
static enum um_status leaders(struct work *w, size_t group)
{
  const struct um_sensitivity_matrix *m = w->m;
  const struct um_sensitivity_report_group g = um_sensitivity_report_group(m, group);
  struct um_sensitivity_report_leader leader[BARS];
  struct um_page_bar *bar;
  const char *title;
  char id[40];
  size_t n = um_sensitivity_report_leaders(m, &g, 0, m->ntime, false, BARS, leader);
  UM_TRY(UM_PAGE_ROOM(w->p, BARS, &bar));
  UM_TRY(um_page_words(w->p, &title, "What moves %s most", g.name));
  snprintf(id, sizeof id, "leaders-%zu", group + 1);
  for (size_t i = 0; i < n; i++) {
    const struct um_sensitivity_row *r = &m->row[leader[i].row];
    bool on = r->quality.way == UM_SENSITIVITY_BY_SWITCH;
    const char *text = "turned on";
    if (!on)
      UM_TRY(um_page_words(
          w->p, &text, "by +%.3g%s%s%s%s", r->width, strcmp(r->unit, "1") == 0 ? "" : " ",
          strcmp(r->unit, "1") == 0 ? "" : r->unit,
          m->curve[leader[i].curve].temperature ? ", in " : "",
          m->curve[leader[i].curve].temperature ? m->curve[leader[i].curve].name : ""));
    bool heat = m->curve[leader[i].curve].temperature;
    bar[i] = (struct um_page_bar){
        r->name, text,
        heat ? leader[i].share * m->curve[leader[i].curve].size : 100.0 * leader[i].share, NAN};
  }
  bool heat = n > 0 && m->curve[leader[0].curve].temperature;
  const struct um_page_figure figure = {.id = id, .title = title};
  const struct um_page_axis value = {.name = "largest change by one width of its prior",
                                     .unit = heat ? "K" : "% of the curve's size"};
  if (n > 0) um_page_bars(w->page, &figure, &value, bar, n);
  return UM_OK;
}

static enum um_status errors(struct work *w, const size_t *row, size_t nrow)
{
  static const struct um_page_figure figure = {.id = "parameters", .title = "Parameters"};
  enum { NULL_VALUE, WIDTH, REACH, ERROR, COLUMNS };
  const struct um_sensitivity_matrix *m = w->m;
  const char **name, **unit, **way;
  double *value[COLUMNS];
  UM_TRY(UM_PAGE_ROOM(w->p, nrow, &name));
  UM_TRY(UM_PAGE_ROOM(w->p, nrow, &unit));
  UM_TRY(UM_PAGE_ROOM(w->p, nrow, &way));
  for (int i = 0; i < COLUMNS; i++) UM_TRY(UM_PAGE_ROOM(w->p, nrow, &value[i]));
  for (size_t i = 0; i < nrow; i++) {
    const struct um_sensitivity_row *r = &m->row[row[i]];
    name[i] = r->name;
    unit[i] = r->unit;
    way[i] = um_sensitivity_way_name(r->quality.way);
    value[NULL_VALUE][i] = r->null_value;
    value[WIDTH][i] = r->width;
    value[REACH][i] = r->quality.reach;
    value[ERROR][i] = r->quality.error;
  }
  const struct um_page_column column[] = {
      {.name = "parameter", .text = name},
      {.name = "unit", .text = unit},
      {.name = "value in the scenario", .value = value[NULL_VALUE]},
      {.name = "width of its prior", .value = value[WIDTH]},
      {.name = "way within which the line is good to 1 %", .value = value[REACH]},
      {.name = "error of the derivative, of its largest", .value = value[ERROR]},
      {.name = "found by", .text = way}};
  um_page_section(w->page, "trust", "How far can it be trusted?", UM_PAGE_PLAIN);
  um_page_table(w->page, &figure, column, 7, nrow);
  return UM_OK;
}

static enum um_status fill(struct um_page_writer *p, const void *of)
{
  const struct um_sensitivity_matrix *m = of;
  struct work whole = {.p = p, .page = p->page, .m = m}, *w = &whole;
  size_t *row, nrow;
  double *t;
  UM_TRY(UM_PAGE_ROOM(w->p, m->ntime, &t));
  for (size_t k = 0; k < m->ntime; k++) t[k] = um_orbit_time_unix(m->time[k]);
  UM_TRY(um_page_writer_times(p, m->ntime, t, NULL));
  if (m->ntime > 0)
    UM_TRY(um_compare_page_shade(p, m->forward->model, m->time[0], m->time[m->ntime - 1]));
  UM_TRY(order(w, &row, &nrow));
  um_page_lead(w->page, "How light and temperatures change with %zu parameters, at %zu instants.",
               nrow, m->ntime);
  um_page_fact(w->page, "scenario", "%s", m->forward->model->scenario->name);
  UM_TRY(sliders(w, row, nrow));
  um_page_section(w->page, "leaders", "What moves it most?", UM_PAGE_PLAIN);
  um_page_text(w->page, "Calibration and air, which act behind the satellite, are left out here.");
  um_page_writer_picture(w->p, "sensitivity.svg");
  for (size_t g = 0; g < um_sensitivity_report_groups(m); g++) UM_TRY(leaders(w, g));
  return errors(w, row, nrow);
}

static struct um_page_head head_of(const struct um_sensitivity_report *report, const char *token)
{
  return (struct um_page_head){.command = report->command,
                               .kind = "sensitivity",
                               .title = report->matrix->forward->model->scenario->name,
                               .about = ": what moves it",
                               .token = token};
}

enum um_status um_sensitivity_report_write_page(struct um_context *context,
                                                const struct um_sensitivity_report *report,
                                                struct um_core_folder *folder)
{
  const struct um_page_head head = head_of(report, NULL);
  return um_page_report(context, &head, fill, report->matrix, folder);
}

enum um_status um_sensitivity_report_serve_page(struct um_context *context,
                                                const struct um_sensitivity_report *report,
                                                const char *token, FILE *file)
{
  const struct um_page_head head = head_of(report, token);
  return um_page_put(context, &head, fill, report->matrix, file);
}
