/* umbra run: light curves and temperatures of a scenario into a folder. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "app/app.h"
#include "app/run_pictures.h"
#include "app/space_error.h"
#include "app/terminal.h"
#include "core/constants.h"
#include "model/build.h"
#include "model/precompute.h"
#include "model/run.h"
#include "orbit/time.h"
#include "output/output.h"

/* Radiant energy toward the observer per material over the run, one band [W s/sr]. */
static void material_energy(const struct um_model_result *r, size_t band, double *out)
{
  for (size_t m = 0; m < r->nmaterial; m++) out[m] = 0.0;
  for (size_t k = 0; k < r->nobs; k++)
    for (size_t m = 0; m < r->nmaterial; m++)
      for (int i = 0; i < UM_MECHANISM_COUNT; i++)
        out[m] += r->intensity[((k * r->nband + band) * r->nmaterial + m) * UM_MECHANISM_COUNT +
                               (size_t)i];
}

/* What a run says of one band. */
struct band_summary {
  double low, high; /* intensity [W/sr] */
  double error;     /* Monte-Carlo error of a total at most [1] */
  size_t umbra;     /* instants in it, core/constants.h */
  double umbra_sun; /* largest Sun term of those [W/sr] */
  double umbra_low; /* their lowest total [W/sr] */
};

static struct band_summary band_summary(const struct um_model_precomputed *precomputed,
                                        const struct um_model_result *r, size_t band)
{
  struct band_summary s = {INFINITY, 0.0, 0.0, 0, 0.0, INFINITY};
  for (size_t k = 0; k < r->nobs; k++) {
    double total = um_model_result_intensity(r, k, band, -1);
    s.low = fmin(s.low, total);
    s.high = fmax(s.high, total);
    if (total > 0.0) s.error = fmax(s.error, r->standard_error[k * r->nband + band] / total);
    if (precomputed->sunlit[k] > UM_UMBRA_MOST) continue;
    s.umbra++;
    s.umbra_sun = fmax(s.umbra_sun, um_model_result_intensity(r, k, band, UM_MECHANISM_SUN));
    s.umbra_low = fmin(s.umbra_low, total);
  }
  return s;
}

static void print_band(const struct um_output_run *run, size_t band, double *energy)
{
  const struct um_model_result *r = run->result;
  struct band_summary s = band_summary(run->precomputed, r, band);
  double sum = 0.0;
  size_t best = 0;
  printf("%-5s %.4g to %.4g W/sr", run->model->band[band].name, s.low, s.high);
  if (s.umbra > 0)
    printf(
        "; %zu of %zu instants in the umbra: Sun term at most %.3g W/sr, total at least %.4g W/sr",
        s.umbra, r->nobs, s.umbra_sun, s.umbra_low);
  printf("; Monte-Carlo error at most %.2g %%\n", 100.0 * s.error);
  material_energy(r, band, energy);
  for (size_t m = 0; m < r->nmaterial; m++) {
    sum += energy[m];
    if (energy[m] > energy[best]) best = m;
  }
  printf("      most of it over the run: %s,",
         um_geometry_material_name(run->model->geometry, best));
  for (size_t m = 0; m < r->nmaterial; m++)
    printf(" %s %.1f %%", um_geometry_material_name(run->model->geometry, m),
           sum > 0.0 ? 100.0 * energy[m] / sum : 0.0);
  printf("\n");
}

static void json_band(const struct um_output_run *run, size_t band, double *energy)
{
  const struct um_model_result *r = run->result;
  struct band_summary s = band_summary(run->precomputed, r, band);
  double sum = 0.0;
  printf("{\"name\": ");
  um_core_json_string(stdout, run->model->band[band].name);
  um_core_json_field(stdout, ", ", "lowest_W_sr", s.low);
  um_core_json_field(stdout, ", ", "highest_W_sr", s.high);
  um_core_json_field(stdout, ", ", "relative_error", s.error);
  printf(", \"umbra_instants\": %zu", s.umbra);
  um_core_json_field(stdout, ", ", "umbra_sun_W_sr", s.umbra > 0 ? s.umbra_sun : (double)NAN);
  um_core_json_field(stdout, ", ", "umbra_lowest_W_sr", s.umbra_low);
  printf(", \"share_by_material\": {");
  material_energy(r, band, energy);
  for (size_t m = 0; m < r->nmaterial; m++) sum += energy[m];
  for (size_t m = 0; m < r->nmaterial; m++) {
    printf("%s", m > 0 ? ", " : "");
    um_core_json_string(stdout, um_geometry_material_name(run->model->geometry, m));
    printf(": ");
    um_core_json_number(stdout, sum > 0.0 ? energy[m] / sum : 0.0);
  }
  printf("}}");
}

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

static double orbits_of(const struct um_model_precomputed *precomputed)
{
  return (precomputed->loads->t[precomputed->loads->ntime - 1] - precomputed->t_start) /
         precomputed->period;
}

static void print_heat(const struct um_model_precomputed *precomputed,
                       const struct um_model_result *r)
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
  if (!isnan(precomputed->period)) printf(" over %.2f orbits", orbits_of(precomputed));
  printf(": in %.6g J, out %.6g J, stored %.6g J, error %.1e of the turnover (limit 1e-6)\n",
         a->solar + a->albedo + a->planet + a->internal, -a->radiated, a->stored, r->audit_error);
}

static void json_heat(const struct um_model_result *r)
{
  printf(",\n  \"places\": [");
  for (size_t p = 0; p < r->nplace; p++) {
    double t[3];
    place_summary(r, p, t);
    printf("%s\n    {\"name\": ", p > 0 ? "," : "");
    um_core_json_string(stdout, r->place[p].name);
    um_core_json_field(stdout, ", ", "mean_K", t[0]);
    um_core_json_field(stdout, ", ", "lowest_K", t[1]);
    um_core_json_field(stdout, ", ", "highest_K", t[2]);
    um_core_json_field(stdout, ", ", "drift_K_per_orbit", r->place[p].drift);
    printf("}");
  }
  printf("],\n  ");
  um_core_json_field(stdout, "", "energy_audit_error", r->audit_error);
}

static size_t hidden_count(const struct um_model_precomputed *precomputed)
{
  size_t n = 0;
  for (size_t k = 0; k < precomputed->nobs; k++) n += precomputed->hidden[k];
  return n;
}

static void print_run(const struct um_output_run *run, const char *folder, double *energy)
{
  const struct um_model_result *r = run->result;
  printf("%s: %zu observations, %zu surfaces, %zu heat nodes, %zu integrator steps\n",
         run->model->scenario->name, r->nobs, r->nsurface, r->nnode, r->steps);
  print_heat(run->precomputed, r);
  for (size_t b = 0; r->nmaterial > 0 && b < r->nband; b++) print_band(run, b, energy);
  const struct um_model *model = run->model;
  if (!isnan(model->orbit_error))
    printf("two-line elements %.1f days %s: %.2g km, %.2g s of error along the track expected "
           "(1 sigma)\n",
           fabs(model->orbit_age) / 86400.0, model->orbit_age >= 0.0 ? "old" : "ahead",
           1e-3 * model->orbit_error, model->orbit_delay);
  size_t hidden = hidden_count(run->precomputed);
  if (hidden > 0)
    printf("%zu of %zu observations are not seen, %s: no irradiance and no magnitude is given\n",
           hidden, r->nobs,
           run->model->observer.kind == UM_OBSERVER_STATION
               ? "the satellite being below the horizon"
               : "the Earth being in between");
  printf("results in %s\n", folder);
}

static void json_run(const struct um_output_run *run, const char *folder, double *energy)
{
  const struct um_model_result *r = run->result;
  printf("{\"name\": ");
  um_core_json_string(stdout, run->model->scenario->name);
  printf(", \"folder\": ");
  um_core_json_string(stdout, folder);
  printf(",\n  \"observations\": %zu, \"hidden_observations\": %zu, \"surfaces\": %zu, "
         "\"heat_nodes\": %zu, \"integrator_steps\": %zu",
         r->nobs, hidden_count(run->precomputed), r->nsurface, r->nnode, r->steps);
  um_core_json_field(stdout, ",\n  ", "orbit_age_days", run->model->orbit_age / 86400.0);
  um_core_json_field(stdout, ", ", "orbit_error_km", 1e-3 * run->model->orbit_error);
  um_core_json_field(stdout, ", ", "orbit_error_s", run->model->orbit_delay);
  json_heat(r);
  printf(",\n  \"bands\": [");
  for (size_t b = 0; r->nmaterial > 0 && b < r->nband; b++) {
    printf("%s\n    ", b > 0 ? "," : "");
    json_band(run, b, energy);
  }
  printf("]}\n");
}

static enum um_status summarise(struct um_context *context, const struct um_output_run *run,
                                const char *folder, bool json)
{
  double *energy = NULL;
  UM_TRY(um_core_allocate(context, run->result->nmaterial, sizeof *energy, &energy));
  if (json)
    json_run(run, folder, energy);
  else
    print_run(run, folder, energy);
  um_core_free(context, energy);
  return UM_OK;
}

/* What the error in space is, or how to know it. */
static enum um_status estimate(struct um_context *context, const struct um_app_options *options,
                               const struct um_model *model, const struct um_model_result *result)
{
  struct um_app_space_error e;
  struct um_model_options changes = um_app_model_options(options);
  char light[160] = "";
  if (!model->scenario->thermal->error_estimate) {
    um_core_log(context, UM_LOG_INFO,
                "error in space: not estimated; thermal.error_estimate: true computes it");
    return UM_OK;
  }
  UM_TRY(um_app_space_error(context, options->positional[0], &changes, model, result, &e));
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
  struct um_model_precomputed *precomputed = NULL;
  struct um_model_result *result = NULL;
  struct um_core_folder *folder = NULL;
  struct um_model_options changes = um_app_model_options(options);
  char *out = NULL;
  double began = seconds(), traced, computed;
  UM_CHECK(um_model_create(context, options->positional[0], &changes, &model));
  UM_CHECK(um_app_out_folder(context, options, model->scenario->name, &out));
  UM_CHECK(um_core_folder_begin(context, out, options->force, &folder));
  UM_CHECK(um_model_precompute(context, model, &precomputed));
  UM_CHECK(um_app_run_views_check(context, model, precomputed, options));
  traced = seconds();
  UM_CHECK(um_model_run(context, model, precomputed, &result));
  UM_CHECK(estimate(context, options, model, result));
  computed = seconds();
  run.options = &changes;
  run.context = context;
  run.model = model;
  run.precomputed = precomputed;
  run.result = result;
  if (!options->no_plots && model->has_observer)
    UM_CHECK(um_app_run_panels(context, &run, um_core_folder_path(folder)));
  UM_CHECK(um_app_run_views(context, &run, options, um_core_folder_path(folder)));
  um_core_log(context, UM_LOG_INFO, "geometry %.1f s, heat and light %.1f s, pictures %.1f s",
              traced - began, computed - traced, seconds() - computed);
  UM_CHECK(um_output_write_run(context, &run, folder));
  if (!options->no_plots) UM_CHECK(um_output_plot_run(context, um_core_folder_path(folder), &run));
  UM_CHECK(um_core_folder_commit(context, &folder));
  um_app_terminal_clear();
  UM_CHECK(summarise(context, &run, out, options->json));
done:
  um_core_folder_abort(&folder);
  um_model_result_destroy(context, &result);
  um_model_precomputed_destroy(context, &precomputed);
  um_model_destroy(context, &model);
  um_core_free(context, out);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
