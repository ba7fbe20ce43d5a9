/* A run of both halves, and its arrays. */
#include <math.h>

#include "library/model_impl.h"
#include "library/result_impl.h"
#include "library/run_impl.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "orbit/time.h"
#include "output/output.h"

struct run {
  struct umbra_model *model; /* shared */
  struct um_model_tables *tables;
  struct um_model_result *result;
  char *log; /* what was said while it was built and run */
};

static void run_release(struct um_context *context, void *work)
{
  struct run *run = work;
  um_model_result_destroy(context, &run->result);
  um_model_tables_destroy(context, &run->tables);
  um_library_model_drop(&run->model);
  UM_FREE(context, run->log, run);
}

static enum um_status run_write(struct um_context *context, const struct umbra_result *result,
                                const struct umbra_write *write, struct um_core_folder *folder)
{
  const struct run *run = result->work;
  const struct um_output_run files = {.model = run->model->model,
                                      .tables = run->tables,
                                      .result = run->result,
                                      .command = write->command,
                                      .version = UM_LIBRARY_VERSION,
                                      .options = &run->model->options,
                                      .log = run->log,
                                      .context = context};
  return um_output_write_run(context, &files, write->pictures != 0, folder);
}

static const struct um_model *run_model(const void *work)
{
  return ((const struct run *)work)->model->model;
}

static const struct um_library_kind kind = {run_write, run_release, run_model};

/* --- arrays that are as they were computed ------------------------------------------------------
 */

static enum um_status show_light(struct um_context *context, const struct um_model_result *r,
                                 struct umbra_result *to)
{
  const struct umbra_array arrays[] = {
      {"irradiance", "W/m^2", 0, {r->nobs, r->nband}, {"time", "band"}, r->irradiance},
      {"magnitude_ab", "mag", 0, {r->nobs, r->nband}, {"time", "band"}, r->magnitude_ab},
      {"intensity_error", "W/sr", 0, {r->nobs, r->nband}, {"time", "band"}, r->standard_error},
      {"intensity_parts",
       "W/sr",
       0,
       {r->nobs, r->nband, r->nmaterial, UM_MECHANISM_COUNT},
       {"time", "band", "material", "mechanism"},
       r->intensity},
      {"spectral_intensity",
       "W/(sr m)",
       0,
       {r->nobs, r->nbin, UM_MECHANISM_COUNT},
       {"time", "bin", "mechanism"},
       r->spectral},
      {"wavelength_m", "m", 0, {r->nbin}, {"bin"}, r->wavelength},
      {"count_rate", "1/s", 0, {r->nobs, r->nsensor}, {"time", "sensor"}, r->count_rate},
      {"count_rate_error",
       "1/s",
       0,
       {r->nobs, r->nsensor},
       {"time", "sensor"},
       r->count_rate_error}};
  for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++)
    UM_TRY(um_library_result_show(context, to, &arrays[i]));
  return UM_OK;
}

static enum um_status show_heat(struct um_context *context, const struct um_model_result *r,
                                struct umbra_result *to)
{
  const struct umbra_array arrays[] = {
      {"surface_temperature",
       "K",
       0,
       {r->nobs, r->nsurface},
       {"time", "surface"},
       r->surface_temperature},
      {"node_temperature", "K", 0, {r->nobs, r->nnode}, {"time", "node"}, r->node_temperature},
      {"facet_error", "K", 0, {r->nsurface}, {"surface"}, r->mesh.surface},
      {"facet_error_light", "1", 0, {r->mesh.nband}, {"band"}, r->mesh.light}};
  for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++)
    UM_TRY(um_library_result_show(context, to, &arrays[i]));
  return UM_OK;
}

/* --- arrays that are made ---------------------------------------------------------------------
 */

/* One number of every observation. */
static enum um_status make_times(struct um_context *context, const struct um_model_tables *tables,
                                 bool observer, struct umbra_result *to)
{
  const struct umbra_array a = {.shape = {tables->nobs}, .axis = {"time"}};
  double *time, *sunlit, *hidden, *range, *phase;
  UM_TRY(um_library_result_make(context, to, a, "time_unix_s", "s", &time));
  UM_TRY(um_library_result_make(context, to, a, "sunlit", "1", &sunlit));
  UM_TRY(um_library_result_make(context, to, a, "hidden", "1", &hidden));
  for (size_t k = 0; k < tables->nobs; k++) {
    time[k] = um_orbit_time_unix(tables->t_obs[k]);
    sunlit[k] = tables->sunlit[k];
    hidden[k] = tables->hidden[k] ? 1.0 : 0.0;
  }
  if (!observer) return UM_OK;
  UM_TRY(um_library_result_make(context, to, a, "range_m", "m", &range));
  UM_TRY(um_library_result_make(context, to, a, "phase_angle_rad", "rad", &phase));
  for (size_t k = 0; k < tables->nobs; k++) {
    size_t middle = k * tables->nsub + tables->nsub / 2;
    const struct um_environment_sample *s = &tables->sample[middle];
    range[k] = tables->look[middle].range;
    phase[k] = um_vec3_angle(s->sun, s->to_observer);
  }
  return UM_OK;
}

static enum um_status make_light(struct um_context *context, const struct um_model_result *r,
                                 struct umbra_result *to)
{
  const struct umbra_array a = {.shape = {r->nobs, r->nband}, .axis = {"time", "band"}};
  double *intensity, *vega;
  UM_TRY(um_library_result_make(context, to, a, "intensity", "W/sr", &intensity));
  UM_TRY(um_library_result_make(context, to, a, "magnitude_vega", "mag", &vega));
  for (size_t k = 0; k < r->nobs; k++)
    for (size_t b = 0; b < r->nband; b++) {
      intensity[k * r->nband + b] = um_model_result_intensity(r, k, b, -1);
      vega[k * r->nband + b] = r->magnitude_ab[k * r->nband + b] - r->vega_ab[b];
    }
  return UM_OK;
}

static enum um_status make_places(struct um_context *context, const struct um_model_result *r,
                                  struct umbra_result *to)
{
  static const char *const name[] = {"temperature", "temperature_lowest", "temperature_highest"};
  for (size_t i = 0; i < sizeof name / sizeof *name; i++) {
    const struct umbra_array a = {.shape = {r->nplace, r->nobs}, .axis = {"place", "time"}};
    double *data;
    UM_TRY(um_library_result_make(context, to, a, name[i], "K", &data));
    for (size_t p = 0; p < r->nplace; p++) {
      const struct um_model_place_history *h = &r->place[p];
      const double *of[] = {h->mean, h->minimum, h->maximum};
      for (size_t k = 0; k < r->nobs; k++) data[p * r->nobs + k] = of[i][k];
    }
  }
  return UM_OK;
}

enum um_status um_library_run_arrays(struct um_context *context, const struct um_model *model,
                                     const struct um_model_tables *tables,
                                     const struct um_model_result *r, struct umbra_result *to)
{
  UM_TRY(make_times(context, tables, model->has_observer, to));
  if (model->has_observer) {
    UM_TRY(make_light(context, r, to));
    UM_TRY(show_light(context, r, to));
  }
  UM_TRY(make_places(context, r, to));
  return show_heat(context, r, to);
}

enum umbra_status umbra_run(struct umbra *umbra, struct umbra_model *model,
                            struct umbra_result **out)
{
  struct um_context *context = um_library_begin(umbra);
  struct umbra_result *result = NULL;
  struct run *run = NULL;
  enum um_status status;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *run, &run));
  run->model = um_library_model_share(model);
  UM_CHECK(um_model_precompute(context, model->model, &run->tables));
  UM_CHECK(um_model_run_stated(context, model->model, run->tables, &run->result));
  UM_CHECK(um_core_asprintf(context, &run->log, "%s%s", model->log, um_core_log_text(context)));
  UM_CHECK(um_library_result_create(context, umbra, &kind, run, &result));
  run = NULL;
  const struct run *of = result->work;
  UM_CHECK(um_library_run_arrays(context, model->model, of->tables, of->result, result));
  *out = result;
done:
  if (run != NULL) run_release(context, run);
  if (status != UM_OK) umbra_result_close(&result);
  return um_library_status(status);
}
