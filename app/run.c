/* umbra run: light curves and temperatures of a scenario into a folder. */
#include <math.h>
#include <string.h>
#include <time.h>

#include "app/app.h"
#include "app/run_bands.h"
#include "app/run_pictures.h"
#include "app/space_error.h"
#include "app/terminal.h"
#include "base/core/constants.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/mesh_error.h"
#include "model/run/run.h"
#include "output/output.h"

/* Mean, lowest and highest temperature of a place over the run [K]. */
static void place_summary(const struct um_model_result *r, size_t place, double out[3])
{
  const struct um_model_place_history *h = &r->place[place];
  out[0] = 0.0;
  out[1] = INFINITY;
  out[2] = -INFINITY;
  for (size_t k = 0; k < r->nobs; k++) {
    out[0] += h->mean[k] / (double)r->nobs;
    out[1] = fmin(out[1], h->minimum[k]);
    out[2] = fmax(out[2], h->maximum[k]);
  }
}

static double orbits_of(const struct um_model_tables *tables)
{
  return (tables->loads->t[tables->loads->ntime - 1] - tables->t_start) / tables->period;
}

static void print_heat(const struct um_model_tables *tables, const struct um_model_result *r)
{
  printf("%-24s %10s %10s %10s %14s\n", "temperatures [K]", "mean", "lowest", "highest",
         "drift/orbit");
  for (size_t p = 0; p < r->nplace; p++) {
    double t[3];
    place_summary(r, p, t);
    printf("%-24s %10.2f %10.2f %10.2f ", r->place[p].name, t[0], t[1], t[2]);
    if (isnan(r->place[p].drift))
      printf("%14s\n", "-");
    else
      printf("%+14.3f\n", r->place[p].drift);
  }
  const struct um_thermal_heat *a = &r->audit;
  printf("energy audit");
  if (!isnan(tables->period)) printf(" over %.2f orbits", orbits_of(tables));
  printf(": in %.6g J, out %.6g J, stored %.6g J, error %.1e of the turnover (limit %.0e)\n",
         a->solar + a->albedo + a->planet + a->internal, -a->radiated, a->stored, r->audit_error,
         r->audit_limit);
}

static void json_heat(const struct um_model_result *r)
{
  printf(",\n  \"places\": [");
  for (size_t p = 0; p < r->nplace; p++) {
    double t[3];
    place_summary(r, p, t);
    um_core_json_text(stdout, p > 0 ? ",\n    {" : "\n    {", "name", r->place[p].name);
    um_core_json_field(stdout, ", ", "mean_K", t[0]);
    um_core_json_field(stdout, ", ", "lowest_K", t[1]);
    um_core_json_field(stdout, ", ", "highest_K", t[2]);
    um_core_json_field(stdout, ", ", "drift_K_per_orbit", r->place[p].drift);
    printf("}");
  }
  printf("],\n  ");
  um_core_json_field(stdout, "", "energy_audit_error", r->audit_error);
}

static void json_mesh(const struct um_model *model, const struct um_model_mesh_error *mesh)
{
  char place[UM_MODEL_MESH_SIDE];
  printf(",\n  \"finer_facets\": {\"place\": ");
  if (mesh->temperature != 0.0)
    um_core_json_string(stdout, um_model_mesh_side(model, mesh->group, mesh->back, place));
  else
    printf("null");
  um_core_json_field(stdout, ", ", "place_K", -mesh->temperature);
  um_core_json_field(stdout, ", ", "mean_K", mesh->temperature_mean);
  printf("}");
}

static size_t hidden_count(const struct um_model_tables *tables)
{
  size_t n = 0;
  for (size_t k = 0; k < tables->nobs; k++) n += tables->hidden[k];
  return n;
}

static void print_run(const struct um_output_run *run, const char *folder, double *work)
{
  const struct um_model_result *r = run->result;
  printf("%s: %zu observations, %zu surfaces, %zu heat nodes, %zu integrator steps\n",
         run->model->scenario->name, r->nobs, r->nsurface, r->nnode, r->steps);
  print_heat(run->tables, r);
  for (size_t b = 0; r->nmaterial > 0 && b < r->nband; b++) um_app_run_print_band(run, b, work);
  const struct um_model *model = run->model;
  if (!isnan(model->orbit_error))
    printf("elements %.1f days %s: %.2g km, %.2g s of error along the track expected "
           "(1 sigma)\n",
           fabs(model->orbit_age) / 86400.0, model->orbit_age >= 0.0 ? "old" : "ahead",
           1e-3 * model->orbit_error, model->orbit_delay);
  size_t hidden = hidden_count(run->tables);
  if (hidden > 0)
    printf("%zu of %zu observations are not seen, %s: no irradiance and no magnitude is given\n",
           hidden, r->nobs,
           run->model->observer.kind == UM_OBSERVER_STATION
               ? "the satellite being below the horizon"
               : "the Earth being in between");
  um_app_tell_results(folder);
}

static void json_run(const struct um_output_run *run, const char *folder, double *work)
{
  const struct um_model_result *r = run->result;
  um_core_json_text(stdout, "{", "name", run->model->scenario->name);
  um_core_json_text(stdout, ", ", "folder", folder);
  printf(",\n  \"observations\": %zu, \"hidden_observations\": %zu, \"surfaces\": %zu, "
         "\"heat_nodes\": %zu, \"integrator_steps\": %zu",
         r->nobs, hidden_count(run->tables), r->nsurface, r->nnode, r->steps);
  um_core_json_field(stdout, ",\n  ", "orbit_age_days", run->model->orbit_age / 86400.0);
  um_core_json_field(stdout, ", ", "orbit_error_km", 1e-3 * run->model->orbit_error);
  um_core_json_field(stdout, ", ", "orbit_error_s", run->model->orbit_delay);
  json_heat(r);
  json_mesh(run->model, &r->mesh);
  printf(",\n  \"bands\": [");
  for (size_t b = 0; r->nmaterial > 0 && b < r->nband; b++) {
    printf("%s\n    ", b > 0 ? "," : "");
    um_app_run_json_band(run, b, work);
  }
  printf("]}\n");
}

static enum um_status summarise(struct um_context *context, const struct um_output_run *run,
                                const char *folder, bool json)
{
  const struct um_model_result *r = run->result;
  size_t n = r->nmaterial > r->nobs ? r->nmaterial : r->nobs;
  double *work = NULL;
  UM_TRY(um_core_allocate(context, n, sizeof *work, &work));
  if (json)
    json_run(run, folder, work);
  else
    print_run(run, folder, work);
  um_core_free(context, work);
  return UM_OK;
}

/* What finer facets would change, by the run's own temperatures. */
static void tell_mesh(struct um_context *context, const struct um_model *model,
                      const struct um_model_mesh_error *mesh)
{
  char text[UM_MODEL_MESH_SENTENCE];
  um_core_log(context, UM_LOG_INFO, "mesh: %s", um_model_mesh_sentence(model, mesh, text));
}

/* What the error in space is, or how to know it. */
static enum um_status estimate(struct um_context *context, const struct um_model *model,
                               const struct um_model_result *result)
{
  struct um_app_space_error e;
  char light[160] = "";
  tell_mesh(context, model, &result->mesh);
  if (!model->scenario->thermal->error_estimate) return UM_OK;
  UM_TRY(um_app_space_error(context, model, result, &e));
  if (e.band != NULL)
    snprintf(light, sizeof light, "; %.32s by %.2g %% at most, %.2g %% in the mean", e.band,
             100.0 * e.light, 100.0 * e.light_mean);
  um_core_log(
      context, UM_LOG_INFO,
      "error in space: %zu surfaces in place of %zu change temperatures of places by %.2g K "
      "at most (%s), %.2g K in the mean%s",
      e.nsurface, result->nsurface, e.temperature, e.place, e.temperature_mean, light);
  return UM_OK;
}

static double seconds(void)
{
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int um_app_run(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_output_run run = {.command = options->command, .version = UM_APP_VERSION};
  struct um_model *model = NULL;
  struct um_model_tables *tables = NULL;
  struct um_model_result *result = NULL;
  struct um_core_folder *folder = NULL;
  char *out = NULL;
  struct um_model_options changes = um_app_model_options(options);
  double began = seconds(), traced, computed;
  UM_CHECK(um_model_create(context, options->positional[0], &changes, &model));
  UM_CHECK(um_app_out_folder(context, options, model->scenario->name, &out));
  UM_CHECK(um_core_folder_begin(context, out, options->force, &folder));
  UM_CHECK(um_model_precompute(context, model, &tables));
  UM_CHECK(um_app_run_views_check(context, model, tables, options));
  traced = seconds();
  UM_CHECK(um_model_run_stated(context, model, tables, &result));
  UM_CHECK(estimate(context, model, result));
  computed = seconds();
  run.options = &changes;
  run.context = context;
  run.model = model;
  run.tables = tables;
  run.result = result;
  if (!options->no_plots && model->has_observer)
    UM_CHECK(um_app_run_panels(context, &run, um_core_folder_path(folder)));
  UM_CHECK(um_app_run_views(context, &run, options, um_core_folder_path(folder)));
  um_core_log(context, UM_LOG_INFO, "geometry %.1f s, heat and light %.1f s, pictures %.1f s",
              traced - began, computed - traced, seconds() - computed);
  UM_CHECK(um_output_write_run(context, &run, !options->no_plots, folder));
  UM_CHECK(um_core_folder_commit(context, &folder));
  um_app_terminal_clear();
  UM_CHECK(summarise(context, &run, out, options->json));
done:
  um_core_folder_abort(&folder);
  um_model_result_destroy(context, &result);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
  um_core_free(context, out);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
