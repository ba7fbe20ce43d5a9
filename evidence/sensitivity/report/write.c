/* Tables and JSON of a matrix of sensitivities. */
#include "evidence/sensitivity/report/write.h"

#include <math.h>

#include "base/core/csv.h"
#include "base/core/json.h"
#include "evidence/measurements/time_text.h"
#include "evidence/sensitivity/report/rank.h"

#define MINUTE  60.0 /* [s] */
#define LEADERS 5    /* of a minute */

/* --- parameters.csv --------------------------------------------------------------------------- */

static void write_parameter(const struct um_sensitivity_report *r, size_t which, FILE *file)
{
  const struct um_sensitivity_matrix *m = r->matrix;
  const struct um_sensitivity_row *row = &m->row[which];
  const struct um_sensitivity_quality *q = &row->quality;
  const double numbers[] = {row->null_value, row->width, row->minimum, row->maximum,
                            q->step,         q->error,   q->reach};
  um_core_csv_put(file, row->name, "");
  um_core_csv_put_text(file, row->unit, "");
  for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++)
    um_core_csv_put_number(file, numbers[i]);
  um_core_csv_put_text(file, um_sensitivity_way_name(q->way), "");
  um_core_csv_put_text(file, row->why != NULL ? row->why : "", "");
  for (size_t i = 0; i < um_sensitivity_report_groups(m); i++) {
    const struct um_sensitivity_report_group g = um_sensitivity_report_group(m, i);
    const struct um_sensitivity_report_leader l =
        um_sensitivity_report_strongest(m, which, &g, 0, m->ntime);
    bool heat = g.first >= m->nlight, none = row->column == NULL;
    double unit = heat ? m->curve[l.curve].size : 100.0; /* of a share: [K], [%] */
    um_core_csv_put_number(file, none ? (double)NAN : l.share * unit);
    if (r->elasticity)
      um_core_csv_put_number(file,
                             none ? (double)NAN : um_sensitivity_report_by_percent(m, &l) * unit);
    if (heat) um_core_csv_put_text(file, l.share > 0.0 ? m->curve[l.curve].name : "", "");
  }
  fputc('\n', file);
}

static void write_parameters(const struct um_sensitivity_report *r, FILE *file)
{
  const struct um_sensitivity_matrix *m = r->matrix;
  fputs("parameter,unit,null_value,width,minimum,maximum,step,error,reach,method,not_smooth", file);
  for (size_t i = 0; i < um_sensitivity_report_groups(m); i++) {
    const struct um_sensitivity_report_group g = um_sensitivity_report_group(m, i);
    bool heat = g.first >= m->nlight;
    um_core_csv_put_text(file, g.name, heat ? "_K_per_width" : "_percent_per_width");
    if (r->elasticity)
      um_core_csv_put_text(file, g.name, heat ? "_K_per_percent" : "_percent_per_percent");
    if (heat) fputs(",place", file);
  }
  fputc('\n', file);
  for (size_t i = 0; i < m->nrow; i++) write_parameter(r, i, file);
}

/* --- sensitivity.csv -------------------------------------------------------------------------- */

static void write_minute(const struct um_sensitivity_matrix *m, size_t from, size_t to, FILE *file)
{
  struct um_sensitivity_report_leader l[LEADERS];
  for (size_t i = 0; i < um_sensitivity_report_groups(m); i++) {
    const struct um_sensitivity_report_group g = um_sensitivity_report_group(m, i);
    size_t n = um_sensitivity_report_leaders(m, &g, from, to, false, LEADERS, l);
    for (size_t k = 0; k < n; k++) {
      const struct um_sensitivity_curve *curve = &m->curve[l[k].curve];
      char time[40];
      um_compare_time_text(m->time[from], time);
      fputs(time, file);
      um_core_csv_put_text(file, curve->name, "");
      fprintf(file, ",%zu", k + 1);
      um_core_csv_put_text(file, m->row[l[k].row].name, "");
      um_core_csv_put_number(file, l[k].share * curve->size);
      um_core_csv_put_text(file, curve->unit, "");
      um_core_csv_put_number(file, curve->temperature ? (double)NAN : 100.0 * l[k].share);
      fputc('\n', file);
    }
  }
}

static void write_minutes(const struct um_sensitivity_matrix *m, FILE *file)
{
  fputs("from_utc,curve,rank,parameter,change_per_width,unit,percent_of_curve\n", file);
  for (size_t from = 0, to; from < m->ntime; from = to) {
    to = um_sensitivity_report_piece(m, from, MINUTE);
    write_minute(m, from, to, file);
  }
}

/* --- what_if.csv ------------------------------------------------------------------------------ */

static void write_what_if(const struct um_sensitivity_report *r, FILE *file)
{
  const struct um_sensitivity_matrix *m = r->matrix;
  fputs("what_if,time_utc,curve,unit,as_stated,linear,true\n", file);
  for (size_t w = 0; w < r->nwhat_if; w++)
    for (size_t c = 0; c < m->ncurve; c++)
      for (size_t k = 0; k < m->ntime; k++) {
        size_t at = c * m->ntime + k;
        char time[40];
        if (isnan(m->value[at])) continue;
        um_compare_time_text(m->time[k], time);
        fprintf(file, "%zu,%s", w + 1, time);
        um_core_csv_put_text(file, m->curve[c].name, "");
        um_core_csv_put_text(file, m->curve[c].unit, "");
        um_core_csv_put_number(file, m->value[at]);
        um_core_csv_put_number(file, r->what_if[w].linear[at]);
        um_core_csv_put_number(file, r->what_if[w].exact[at]);
        fputc('\n', file);
      }
}

enum um_status um_sensitivity_report_write(struct um_context *context,
                                           const struct um_sensitivity_report *report,
                                           bool pictures, struct um_core_folder *folder)
{
  FILE *file;
  UM_TRY(um_core_folder_open(context, folder, "parameters.csv", &file));
  write_parameters(report, file);
  UM_TRY(um_core_file_close(context, "parameters.csv", &file));
  UM_TRY(um_core_folder_open(context, folder, "sensitivity.csv", &file));
  write_minutes(report->matrix, file);
  UM_TRY(um_core_file_close(context, "sensitivity.csv", &file));
  if (report->nwhat_if > 0) {
    UM_TRY(um_core_folder_open(context, folder, "what_if.csv", &file));
    write_what_if(report, file);
    UM_TRY(um_core_file_close(context, "what_if.csv", &file));
  }
  UM_TRY(um_core_folder_open(context, folder, "sensitivity.nc", &file));
  enum um_status status = um_sensitivity_report_write_netcdf(context, report, file);
  enum um_status closed = um_core_file_close(context, "sensitivity.nc", &file);
  UM_TRY(status != UM_OK ? status : closed);
  if (pictures)
    UM_TRY(um_sensitivity_report_plot(context, report->matrix, um_core_folder_path(folder)));
  return um_sensitivity_report_write_page(context, report, folder);
}

/* --- JSON ------------------------------------------------------------------------------------- */

static void json_row(const struct um_sensitivity_report *r, const struct um_sensitivity_row *row,
                     FILE *file)
{
  const struct um_sensitivity_matrix *m = r->matrix;
  um_core_json_text(file, "    {", "parameter", row->name);
  um_core_json_text(file, ", ", "unit", row->unit);
  um_core_json_field(file, ", ", "null_value", row->null_value);
  um_core_json_field(file, ", ", "width", row->width);
  um_core_json_text(file, ", ", "method", um_sensitivity_way_name(row->quality.way));
  um_core_json_field(file, ", ", "step", row->quality.step);
  um_core_json_field(file, ", ", "error", row->quality.error);
  um_core_json_field(file, ", ", "reach", row->quality.reach);
  um_core_json_text(file, ", ", "not_smooth", row->why);
  fputs(", \"largest\": {", file);
  for (size_t c = 0; c < m->ncurve && row->column != NULL; c++) {
    fputs(c > 0 ? ", " : "", file);
    um_core_json_string(file, m->curve[c].name);
    fputs(": ", file);
    um_core_json_number(file, um_sensitivity_matrix_strength(m, row, c, 0, m->ntime, 1.0) *
                                  m->curve[c].size);
  }
  fputs("}}", file);
}

static void json_what_if(const struct um_sensitivity_report *r,
                         const struct um_sensitivity_what_if *w, FILE *file)
{
  const struct um_sensitivity_matrix *m = r->matrix;
  fputs("    {\"values\": {", file);
  for (size_t i = 0; i < w->nrow; i++) {
    fputs(i > 0 ? ", " : "", file);
    um_core_json_string(file, m->row[w->row[i]].name);
    fputs(": ", file);
    um_core_json_number(file, w->to[i]);
  }
  fputs("}", file);
  um_core_json_field(file, ", ", "within_share_of_way", w->within);
  um_core_json_field(file, ", ", "seconds_linear", w->seconds);
  um_core_json_field(file, ", ", "seconds_true", w->seconds_exact);
  fputs(", \"error_of_size\": {", file);
  for (size_t c = 0; c < m->ncurve; c++) {
    fputs(c > 0 ? ", " : "", file);
    um_core_json_string(file, m->curve[c].name);
    um_core_json_field(file, ": {", "largest", w->error[c].largest);
    um_core_json_field(file, ", ", "rms", w->error[c].rms);
    fputs("}", file);
  }
  fputs("}}", file);
}

void um_sensitivity_report_write_json(const struct um_sensitivity_report *r, FILE *file)
{
  const struct um_sensitivity_matrix *m = r->matrix;
  um_core_json_text(file, "{\n  ", "scenario", m->forward->model->scenario->name);
  um_core_json_text(file, ",\n  ", "version", r->version);
  um_core_json_text(file, ",\n  ", "command", r->command);
  um_core_json_field(file, ",\n  ", "instants", (double)m->ntime);
  um_core_json_field(file, ",\n  ", "seconds", m->seconds);
  um_core_json_field(file, ",\n  ", "seconds_of_a_run", m->seconds_run);
  fputs(",\n  \"curves\": [", file);
  for (size_t c = 0; c < m->ncurve; c++) {
    um_core_json_text(file, c > 0 ? ", {" : "{", "name", m->curve[c].name);
    um_core_json_text(file, ", ", "unit", m->curve[c].unit);
    um_core_json_field(file, ", ", "size", m->curve[c].size);
    fputs("}", file);
  }
  fputs("],\n  \"parameters\": [\n", file);
  for (size_t i = 0; i < m->nrow; i++) {
    json_row(r, &m->row[i], file);
    fputs(i + 1 < m->nrow ? ",\n" : "\n", file);
  }
  fputs("  ],\n  \"what_if\": [", file);
  for (size_t i = 0; i < r->nwhat_if; i++) {
    fputs(i > 0 ? ",\n" : "\n", file);
    json_what_if(r, &r->what_if[i], file);
  }
  fputs(r->nwhat_if > 0 ? "\n  ]\n}\n" : "]\n}\n", file);
}
