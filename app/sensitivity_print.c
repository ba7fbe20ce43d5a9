/* A matrix of sensitivities as tables for a person. */
#include "app/sensitivity.h"

#include <math.h>
#include <string.h>

#include "evidence/sensitivity/report/rank.h"

#define STRONGEST 10   /* of a curve */
#define CALIBRATE 3    /* that act behind the satellite */
#define LINES     16   /* pieces of the pass, at most */
#define MINUTE    60.0 /* [s] */
#define NAME      44   /* characters */

static const char *unit_of(const struct um_sensitivity_row *row)
{
  return strcmp(row->unit, "1") == 0 ? "" : row->unit;
}

/* "+0.03 K", or "turned on". */
static void print_width(const struct um_sensitivity_row *row)
{
  char text[96];
  if (row->quality.way == UM_SENSITIVITY_BY_SWITCH)
    snprintf(text, sizeof text, "turned on");
  else
    snprintf(text, sizeof text, "+%.3g %s", row->width, unit_of(row));
  printf(" %-18s", text);
}

static void print_leader(const struct um_sensitivity_report *r,
                         const struct um_sensitivity_report_leader *l)
{
  const struct um_sensitivity_matrix *m = r->matrix;
  const struct um_sensitivity_row *row = &m->row[l->row];
  const struct um_sensitivity_curve *curve = &m->curve[l->curve];
  double unit = curve->temperature ? curve->size : 100.0;
  printf("  %-*s", NAME, row->name);
  print_width(row);
  printf(" %9.3g %s", l->share * unit, curve->temperature ? "K" : "%");
  if (r->elasticity) {
    double by = um_sensitivity_report_by_percent(m, l) * unit;
    if (isfinite(by))
      printf(" %10.3g", by);
    else
      printf(" %10s", "");
  }
  printf("  %-8s", um_sensitivity_way_name(row->quality.way));
  if (row->quality.way != UM_SENSITIVITY_BY_SWITCH) printf(" %8.1e", row->quality.error);
  if (curve->temperature) printf("  %s", curve->name);
  printf("%s\n", row->smooth || row->quality.way == UM_SENSITIVITY_BY_SWITCH ? "" : "  not smooth");
}

static void print_group(const struct um_sensitivity_report *r, size_t index)
{
  const struct um_sensitivity_matrix *m = r->matrix;
  const struct um_sensitivity_report_group g = um_sensitivity_report_group(m, index);
  struct um_sensitivity_report_leader l[STRONGEST];
  size_t n = um_sensitivity_report_leaders(m, &g, 0, m->ntime, false, STRONGEST, l);
  printf("%-*s   %-18s %11s%s  %-8s %8s\n", NAME, g.name, "by", "at most",
         r->elasticity ? "  per 1 %   " : "", "method", "error");
  for (size_t i = 0; i < n; i++) print_leader(r, &l[i]);
  n = um_sensitivity_report_leaders(m, &g, 0, m->ntime, true, CALIBRATE, l);
  for (size_t i = 0; i < n; i++) print_leader(r, &l[i]);
}

/* Who leads each curve of light, and the temperatures, piece by piece. */
static void print_pieces(const struct um_sensitivity_matrix *m)
{
  size_t groups = um_sensitivity_report_groups(m);
  double span = m->ntime > 0 ? m->time[m->ntime - 1] - m->time[0] : 0.0;
  double piece = MINUTE * fmax(1.0, ceil(span / MINUTE / LINES));
  printf("%-8s", "minute");
  for (size_t i = 0; i < groups && i < 3; i++)
    printf(" %-*s", NAME, um_sensitivity_report_group(m, i).name);
  printf("\n");
  for (size_t from = 0, to; from < m->ntime; from = to) {
    to = um_sensitivity_report_piece(m, from, piece);
    printf("%-8.3g", (m->time[from] - m->time[0]) / MINUTE);
    for (size_t i = 0; i < groups && i < 3; i++) {
      const struct um_sensitivity_report_group g = um_sensitivity_report_group(m, i);
      struct um_sensitivity_report_leader l;
      char text[160] = "";
      if (um_sensitivity_report_leaders(m, &g, from, to, false, 1, &l) > 0) {
        bool heat = m->curve[l.curve].temperature;
        snprintf(text, sizeof text, "%.100s %.2g %s", m->row[l.row].name,
                 l.share * (heat ? m->curve[l.curve].size : 100.0), heat ? "K" : "%");
      }
      printf(" %-*s", NAME, text);
    }
    printf("\n");
  }
}

static void print_what_if(const struct um_sensitivity_matrix *m,
                          const struct um_sensitivity_what_if *w)
{
  printf("what if");
  for (size_t i = 0; i < w->nrow; i++) {
    const struct um_sensitivity_row *row = &m->row[w->row[i]];
    if (row->quality.way == UM_SENSITIVITY_BY_SWITCH)
      printf(" %s is turned on", row->name);
    else
      printf("%s %s is %g%s%s (now %g)", i > 0 ? "," : "", row->name, w->to[i],
             unit_of(row)[0] != '\0' ? " " : "", unit_of(row), row->null_value);
  }
  printf(": by the matrix in %.2g ms, by the model in %.2g s\n", 1e3 * w->seconds,
         w->seconds_exact);
  struct um_sensitivity_what_if_error heat = {0.0, 0.0};
  size_t hottest = m->nlight;
  for (size_t c = 0; c < m->ncurve; c++) {
    if (!m->curve[c].temperature)
      printf("  %-12s linear - true at most %.2g %%, rms %.2g %% of the largest\n",
             m->curve[c].name, 100.0 * w->error[c].largest, 100.0 * w->error[c].rms);
    else if (w->error[c].largest >= heat.largest)
      heat = w->error[c], hottest = c;
  }
  if (m->ncurve > m->nlight)
    printf("  %-12s linear - true at most %.2g K, rms %.2g K (%s)\n", "temperature",
           heat.largest * m->curve[hottest].size, heat.rms * m->curve[hottest].size,
           m->curve[hottest].name);
  for (size_t i = 0; i < w->nrow && isfinite(w->within); i++) {
    const struct um_sensitivity_row *row = &m->row[w->row[i]];
    double way = fabs(w->to[i] - row->null_value) * w->within;
    if (row->quality.way == UM_SENSITIVITY_BY_SWITCH) continue;
    printf("  the matrix is within 1 %% of every curve's size (1 K) for %s from %.4g to %.4g %s\n",
           row->name, fmax(row->minimum, row->null_value - way),
           fmin(row->maximum, row->null_value + way), unit_of(row));
  }
}

/* Rows without a derivative, in few words. */
static void print_rest(const struct um_sensitivity_matrix *m)
{
  size_t none = 0, shown = 0;
  for (size_t i = 0; i < m->nrow; i++) {
    const struct um_sensitivity_row *row = &m->row[i];
    none += row->column == NULL;
    if (row->column == NULL || row->smooth) continue;
    printf(shown++ == 0 ? "not smooth, so that a small step says little of a larger one:\n" : "");
    printf("  %-*s %s\n", NAME, row->name, row->why);
  }
  if (none > 0)
    printf("%zu parameters change nothing here, or are refused: parameters.csv says why\n", none);
}

void um_app_sensitivity_print(const struct um_sensitivity_report *r, const char *folder)
{
  const struct um_sensitivity_matrix *m = r->matrix;
  size_t columns = 0;
  for (size_t i = 0; i < m->nrow; i++) columns += m->row[i].column != NULL;
  printf("%s: %zu parameters, %zu instants, %zu curves of light, %zu of temperature; %.3g s, of "
         "which a run of the scenario %.2g s\n",
         m->forward->model->scenario->name, columns, m->ntime, m->nlight, m->ncurve - m->nlight,
         m->seconds + m->seconds_run, m->seconds_run);
  printf("largest changes by one width of each prior; light in percent of its largest value\n");
  for (size_t i = 0; i < um_sensitivity_report_groups(m); i++) print_group(r, i);
  if (columns > 0) print_pieces(m);
  for (size_t i = 0; i < r->nwhat_if; i++) print_what_if(m, &r->what_if[i]);
  print_rest(m);
  um_app_tell_results(folder);
}
