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
  struct um_context *context;
  const struct um_sensitivity_matrix *m;
  struct um_page *page;
  struct um_core_arena memory;
  struct um_page_axis time;
  struct um_page_shade *shade;
  size_t nshade;
};

/* Rows with a column, the strongest in light first: *out [*count] of the arena. */
static enum um_status order(struct work *w, size_t **out, size_t *count)
{
  const struct um_sensitivity_matrix *m = w->m;
  double *strength;
  *count = 0;
  UM_TRY(um_core_arena_allocate(w->context, &w->memory, m->nrow, sizeof **out, out));
  UM_TRY(um_core_arena_allocate(w->context, &w->memory, m->nrow, sizeof *strength, &strength));
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
  UM_TRY(um_core_arena_allocate(w->context, &w->memory, nrow, sizeof *slider, &slider));
  UM_TRY(um_core_arena_allocate(w->context, &w->memory, ncurve, sizeof *curve, &curve));
  for (size_t i = 0; i < nrow; i++) {
    const struct um_sensitivity_row *r = &m->row[row[i]];
    bool on = r->quality.way == UM_SENSITIVITY_BY_SWITCH;
    char *label;
    UM_TRY(um_core_arena_allocate(w->context, &w->memory, 300, 1, &label));
    snprintf(label, 300, "%.100s%s%.100s", r->candidate->name, on ? "" : ", ",
             on ? "" : r->candidate->effect->parameters[r->parameter].name);
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
    UM_TRY(um_core_arena_allocate(w->context, &w->memory, nrow, sizeof *derivative, &derivative));
    UM_TRY(um_core_arena_allocate(w->context, &w->memory, nrow, sizeof *error, &error));
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
  um_page_sliders(w->page, &figure, &w->time, w->shade, w->nshade, slider, nrow, curve, ncurve);
  return UM_OK;
}

/* The strongest of a group, by what one width of their prior does. */
static enum um_status leaders(struct work *w, size_t group)
{
  const struct um_sensitivity_matrix *m = w->m;
  const struct um_sensitivity_report_group g = um_sensitivity_report_group(m, group);
  struct um_sensitivity_report_leader leader[BARS];
  struct um_page_bar *bar;
  char *title, id[40];
  size_t n = um_sensitivity_report_leaders(m, &g, 0, m->ntime, false, BARS, leader);
  UM_TRY(um_core_arena_allocate(w->context, &w->memory, BARS, sizeof *bar, &bar));
  UM_TRY(um_core_arena_allocate(w->context, &w->memory, 160, 1, &title));
  snprintf(title, 160, "What moves %.100s most", g.name);
  snprintf(id, sizeof id, "leaders-%zu", group + 1);
  for (size_t i = 0; i < n; i++) {
    const struct um_sensitivity_row *r = &m->row[leader[i].row];
    bool on = r->quality.way == UM_SENSITIVITY_BY_SWITCH;
    char *text;
    UM_TRY(um_core_arena_allocate(w->context, &w->memory, 160, 1, &text));
    if (on)
      snprintf(text, 160, "turned on");
    else
      snprintf(text, 160, "by +%.3g%s%.60s%s%.60s", r->width, strcmp(r->unit, "1") == 0 ? "" : " ",
               strcmp(r->unit, "1") == 0 ? "" : r->unit,
               m->curve[leader[i].curve].temperature ? ", in " : "",
               m->curve[leader[i].curve].temperature ? m->curve[leader[i].curve].name : "");
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
  UM_TRY(um_core_arena_allocate(w->context, &w->memory, nrow, sizeof *name, &name));
  UM_TRY(um_core_arena_allocate(w->context, &w->memory, nrow, sizeof *unit, &unit));
  UM_TRY(um_core_arena_allocate(w->context, &w->memory, nrow, sizeof *way, &way));
  for (int i = 0; i < COLUMNS; i++)
    UM_TRY(um_core_arena_allocate(w->context, &w->memory, nrow, sizeof *value[i], &value[i]));
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

static enum um_status sections(struct work *w)
{
  const struct um_sensitivity_matrix *m = w->m;
  size_t *row, nrow;
  double *t;
  UM_TRY(um_core_arena_allocate(w->context, &w->memory, m->ntime, sizeof *t, &t));
  for (size_t k = 0; k < m->ntime; k++) t[k] = um_orbit_time_unix(m->time[k]);
  w->time = (struct um_page_axis){"time", "UTC", UM_PAGE_TIME, t, m->ntime};
  if (m->ntime > 0)
    UM_TRY(um_compare_page_shade(w->context, m->forward->model, m->time[0], m->time[m->ntime - 1],
                                 &w->memory, &w->shade, &w->nshade));
  UM_TRY(order(w, &row, &nrow));
  um_page_lead(w->page, "How light and temperatures change with %zu parameters, at %zu instants.",
               nrow, m->ntime);
  um_page_fact(w->page, "scenario", "%s", m->forward->model->scenario->name);
  UM_TRY(sliders(w, row, nrow));
  um_page_section(w->page, "leaders", "What moves it most?", UM_PAGE_PLAIN);
  um_page_text(w->page, "Calibration and air, which act behind the satellite, are left out here.");
  um_page_picture(w->page, "sensitivity.svg");
  for (size_t g = 0; g < um_sensitivity_report_groups(m); g++) UM_TRY(leaders(w, g));
  return errors(w, row, nrow);
}

/* The page in memory; the caller destroys. */
static enum um_status make(struct um_context *context, const struct um_sensitivity_report *report,
                           const char *token, struct um_page **out)
{
  enum um_status status;
  struct work w = {.context = context, .m = report->matrix};
  char *title = NULL;
  *out = NULL;
  UM_CHECK(um_core_asprintf(context, &title, "%s: what moves it",
                            report->matrix->forward->model->scenario->name));
  const struct um_page_head head = {report->command, "sensitivity", title, token};
  UM_CHECK(um_page_create(context, &head, &w.page));
  UM_CHECK(sections(&w));
  *out = w.page;
  w.page = NULL;
done:
  um_page_destroy(context, &w.page);
  um_core_arena_release(context, &w.memory);
  um_core_free(context, title);
  return status;
}

enum um_status um_sensitivity_report_write_page(struct um_context *context,
                                                const struct um_sensitivity_report *report,
                                                struct um_core_folder *folder)
{
  struct um_page *page;
  UM_TRY(make(context, report, NULL, &page));
  enum um_status status = um_page_write_report(context, page, folder);
  um_page_destroy(context, &page);
  return status;
}

enum um_status um_sensitivity_report_serve_page(struct um_context *context,
                                                const struct um_sensitivity_report *report,
                                                const char *token, FILE *file)
{
  struct um_page *page;
  UM_TRY(make(context, report, token, &page));
  enum um_status status = um_page_write(context, page, file);
  um_page_destroy(context, &page);
  return status;
}
