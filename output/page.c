/* report.html: what a run says, in the order in which a reader asks. */
#include "output/page.h"

#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "model/run/mesh_error.h"
#include "model/run/run.h"
#include "orbit/time.h"
#include "output/band_summary.h"
#include "output/page_impl.h"

enum um_status um_output_page_column(struct um_output_page *p, double **out)
{
  return UM_PAGE_ROOM(p->w, p->run->result->nobs, out);
}

static enum um_status times(struct um_output_page *p)
{
  const struct um_model_tables *tables = p->run->tables;
  double *t;
  UM_TRY(um_output_page_column(p, &t));
  for (size_t k = 0; k < tables->nobs; k++) t[k] = um_orbit_time_unix(tables->t_obs[k]);
  return um_page_writer_times(p->w, tables->nobs, t, tables->sunlit);
}

static void lead(struct um_output_page *p)
{
  const struct um_model *model = p->run->model;
  const struct um_model_tables *tables = p->run->tables;
  char first[32], last[32];
  size_t umbra = 0, hidden = 0;
  for (size_t k = 0; k < tables->nobs; k++) {
    umbra += tables->sunlit[k] <= UM_UMBRA_MOST;
    hidden += tables->hidden[k];
  }
  if (model->scenario->summary != NULL) um_page_lead(p->page, "%s", model->scenario->summary);
  um_orbit_time_format(tables->t_obs[0], first);
  um_orbit_time_format(tables->t_obs[tables->nobs - 1], last);
  um_page_fact(p->page, "window", "%.10s %.8s to %.10s %.8s UTC, %zu instants", first, first + 11,
               last, last + 11, tables->nobs);
  if (umbra > 0) um_page_fact(p->page, "in the umbra", "%zu of %zu instants", umbra, tables->nobs);
  if (hidden > 0)
    um_page_fact(p->page, "not visible",
                 "%zu of %zu instants: below the horizon or behind the Earth", hidden,
                 tables->nobs);
  um_page_fact(p->page, "model", "%zu surfaces, %zu heat nodes, %zu time steps",
               p->run->result->nsurface, p->run->result->nnode, p->run->result->steps);
}

enum um_status um_output_page_sky(struct um_output_page *p)
{
  static const struct um_page_figure sky_figure = {.id = "sky", .title = "Path over the station"};
  static const struct um_page_figure geometry = {.id = "geometry", .title = "Geometry"};
  const struct um_model_tables *tables = p->run->tables;
  double *column[5];
  if (!p->run->model->has_observer) return UM_OK;
  for (int i = 0; i < 5; i++) UM_TRY(um_output_page_column(p, &column[i]));
  for (size_t k = 0; k < tables->nobs; k++) {
    size_t at = k * tables->nsub + tables->nsub / 2;
    const struct um_orbit_look *look = &tables->look[at];
    column[0][k] = look->azimuth / UM_DEG;
    column[1][k] = look->elevation / UM_DEG;
    column[2][k] = look->range * 1e-3;
    column[3][k] = um_vec3_angle(tables->sample[at].sun, tables->sample[at].to_observer) / UM_DEG;
    column[4][k] = look->sun_elevation / UM_DEG;
  }
  bool station = p->run->model->observer.kind == UM_OBSERVER_STATION;
  const struct um_page_series series[] = {{.name = "range", .value = column[2]},
                                          {.name = "phase angle", .value = column[3]},
                                          {.name = "elevation", .value = column[1]},
                                          {.name = "Sun's elevation", .value = column[4]}};
  const struct um_page_panel panel[] = {
      {.name = "range", .unit = "km", .series = &series[0], .nseries = 1},
      {.name = "angle",
       .unit = "deg",
       .zero = true,
       .series = &series[1],
       .nseries = station ? 3 : 1}};
  um_page_section(p->page, "sky", "Where does it stand?", UM_PAGE_PLAIN);
  um_page_text(p->page, "The phase angle is that at the satellite between Sun and observer.");
  const struct um_page_mark_at mark[] = {{p->w->time.value[0], "start"},
                                         {p->w->time.value[tables->nobs - 1], "end"}};
  const struct um_page_sky sky = {p->w->time.value, column[0], column[1], tables->sunlit,
                                  tables->nobs,     mark,      2};
  if (station) um_page_sky(p->page, &sky_figure, &sky);
  um_page_axes(p->page, &geometry, &p->w->time, p->w->shade, p->w->nshade, panel, 2);
  return UM_OK;
}

static void warnings(struct um_output_page *p)
{
  const char *line = um_core_log_text(p->w->context);
  for (size_t n; *line != '\0'; line += n + (line[n] == '\n')) {
    n = strcspn(line, "\n");
    if (strncmp(line, "warning: ", 9) == 0)
      um_page_text(p->page, "Warning: %.*s", (int)n - 9, line + 9);
  }
}

static enum um_status trust(struct um_output_page *p)
{
  static const struct um_page_figure figure = {.id = "errors", .title = "Stated errors"};
  const struct um_model_result *r = p->run->result;
  const struct um_model *model = p->run->model;
  size_t n = 0;
  char mesh[UM_MODEL_MESH_SENTENCE];
  const char **name, **unit;
  double *value, *work;
  UM_TRY(um_output_page_column(p, &work));
  UM_TRY(UM_PAGE_ROOM(p->w, r->nband + 4, &name));
  UM_TRY(UM_PAGE_ROOM(p->w, r->nband + 4, &unit));
  UM_TRY(UM_PAGE_ROOM(p->w, r->nband + 4, &value));
  for (size_t b = 0; model->has_observer && b < r->nband; b++) {
    UM_TRY(um_page_words(p->w, &name[n], "ray tracing, %s, median", model->band[b].name));
    value[n] = 100.0 * um_output_band_summary(p->run->tables, r, b, work).median;
    unit[n++] = "%";
  }
  UM_TRY(um_page_words(p->w, &name[n], "energy audit of the heat, of the turnover (limit %.0e)",
                       r->audit_limit));
  unit[n] = "1";
  value[n++] = r->audit_error;
  if (!isnan(model->orbit_error)) {
    name[n] = "orbit along the track, one standard deviation";
    unit[n] = "km";
    value[n++] = 1e-3 * model->orbit_error;
  }
  um_page_section(p->page, "trust", "How far can it be trusted?", UM_PAGE_PLAIN);
  warnings(p);
  if (r->mesh.surface != NULL)
    um_page_text(p->page, "Mesh: %s.", um_model_mesh_sentence(model, &r->mesh, mesh));
  const struct um_page_column column[] = {{.name = "error", .text = name},
                                          {.name = "value", .value = value},
                                          {.name = "unit", .text = unit}};
  um_page_table(p->page, &figure, column, 3, n);
  return UM_OK;
}

static void files(struct um_output_page *p)
{
  static const struct um_page_figure figure = {.id = "files", .title = "Files beside this page"};
  static const char *const name[] = {"lightcurve.csv", "materials.csv", "temperatures.csv",
                                     "heat.csv",       "run.nc",        "run.xdmf",
                                     "scenario.yaml",  "log.txt"};
  static const char *const holds[] = {"light of every band, by mechanism, with geometry",
                                      "light by material and mechanism",
                                      "mean, lowest and highest temperature of every place",
                                      "heat flows of every place",
                                      "everything, surface by surface (netCDF)",
                                      "opens run.nc in ParaView",
                                      "the scenario as it was run: umbra run takes it again",
                                      "what was logged"};
  const struct um_page_column column[] = {{.name = "file", .text = name},
                                          {.name = "holds", .text = holds}};
  um_page_section(p->page, "files", "Where are the numbers?", UM_PAGE_PLAIN);
  um_page_text(p->page, "Every figure has its table, and saves it as CSV.");
  um_page_table(p->page, &figure, column, 2, sizeof name / sizeof name[0]);
}

static enum um_status fill(struct um_page_writer *w, const void *of)
{
  struct um_output_page whole = {.w = w, .page = w->page, .run = of}, *p = &whole;
  UM_TRY(times(p));
  lead(p);
  UM_TRY(um_output_page_light(p));
  UM_TRY(um_output_page_scene(p));
  UM_TRY(um_output_page_split(p));
  UM_TRY(um_output_page_counts(p));
  UM_TRY(um_output_page_temperatures(p));
  UM_TRY(um_output_page_heat(p));
  UM_TRY(um_output_page_sky(p));
  UM_TRY(trust(p));
  files(p);
  return UM_OK;
}

enum um_status um_output_write_page(struct um_context *context, const struct um_output_run *run,
                                    struct um_core_folder *folder)
{
  const struct um_page_head head = {
      .command = run->command, .kind = "run", .title = run->model->scenario->name};
  return um_page_report(context, &head, fill, run, folder);
}
