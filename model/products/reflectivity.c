/* Reflectivity by the renderer of light curves: a body in its own axes, a Sun at 1 au, nothing else
 * that shines. */
#include "model/products/reflectivity.h"

#include "base/core/constants.h"
#include "model/run/run_light.h"

#define BLOCK_BYTES 1e8 /* of lines of sight that are held at once */
#define ROW_BYTES   64  /* of a surface at an instant: um_optics_view and the scene's arrays */
#define BLOCK_LEAST 32

/* Everything of a block that does not depend on its directions. */
struct block {
  size_t size; /* pairs at most */
  struct um_environment dark;
  struct um_environment_sample *sample; /* [size] */
  double *temperature;                  /* [size][nsurface] */
  float *nothing;                       /* [size][nsurface] */
};

static void block_release(struct um_context *context, struct block *b)
{
  UM_FREE(context, b->sample, b->temperature, b->nothing);
}

static enum um_status block_make(struct um_context *context, const struct um_model *model, size_t n,
                                 struct block *b)
{
  size_t nsurface = um_geometry_mesh(model->geometry)->nsurface;
  double fit = BLOCK_BYTES / (ROW_BYTES * (double)(nsurface > 0 ? nsurface : 1));
  *b = (struct block){.size = fit > BLOCK_LEAST ? (size_t)fit : BLOCK_LEAST,
                      .dark = model->environment};
  if (b->size > n) b->size = n;
  b->dark.earthshine_on = b->dark.earth_reflection_on = b->dark.earthlight_lobe_on = false;
  b->dark.limb = NULL;
  UM_TRY(um_core_allocate(context, b->size, sizeof *b->sample, &b->sample));
  UM_TRY(um_core_allocate(context, b->size * nsurface, sizeof *b->temperature, &b->temperature));
  UM_TRY(um_core_allocate(context, b->size * nsurface, sizeof *b->nothing, &b->nothing));
  for (size_t i = 0; i < b->size * nsurface; i++) b->temperature[i] = UM_MODEL_COLD;
  return UM_OK;
}

/* Body axes stand for GCRS; the Earth is far away. */
static struct um_environment_sample sample_of(struct um_vec3 sun, struct um_vec3 observer)
{
  return (struct um_environment_sample){.sun = sun,
                                        .sun_distance = UM_AU,
                                        .pole = {0.0, 0.0, 1.0},
                                        .greenwich = {1.0, 0.0, 0.0},
                                        .sunlit_fraction = 1.0,
                                        .q = {1.0, 0.0, 0.0, 0.0},
                                        .to_observer = observer,
                                        .range = 1.0};
}

/* Sunlight of the first `count` samples of a block, by band. */
static enum um_status render(struct um_context *context, const struct um_model *model,
                             const struct block *b, size_t count, double *value, double *error)
{
  enum um_status status;
  struct um_optics_view *view = NULL;
  struct um_optics_lightcurve *curve = NULL;
  UM_CHECK(um_optics_view_trace(context, model->geometry, b->sample, count,
                                model->scenario->optics->samples,
                                (uint64_t)model->scenario->optics->seed, &view));
  struct um_optics_scene scene = {.geometry = model->geometry,
                                  .creases = model->creases,
                                  .environment = &b->dark,
                                  .samples = b->sample,
                                  .view = view,
                                  .material = model->material,
                                  .adjustment = model->adjustment,
                                  .temperature = b->temperature,
                                  .albedo = b->nothing,
                                  .view_factor = b->nothing,
                                  .sunlight_only = true};
  UM_CHECK(um_optics_lightcurve_compute(context, &scene, model->band, model->nband, &curve));
  for (size_t i = 0; i < count; i++)
    for (size_t k = 0; k < model->nband; k++) {
      double sum = 0.0, solar = um_model_solar_irradiance(model, k);
      for (size_t m = 0; m < curve->nmaterial; m++)
        sum +=
            curve->intensity[((i * curve->nband + k) * curve->nmaterial + m) * UM_MECHANISM_COUNT +
                             UM_MECHANISM_SUN];
      value[i * model->nband + k] = sum / solar;
      if (error != NULL) error[i * model->nband + k] = curve->stderr_[i * curve->nband + k] / solar;
    }
done:
  um_optics_lightcurve_destroy(context, &curve);
  um_optics_view_destroy(context, &view);
  return status;
}

enum um_status um_model_reflectivity(struct um_context *context, const struct um_model *model,
                                     const char *task, const struct um_vec3 *sun,
                                     const struct um_vec3 *observer, size_t n, double *value,
                                     double *error)
{
  enum um_status status;
  struct block b = {0};
  if (n == 0) return UM_OK;
  um_core_progress_begin(context, task, n);
  UM_CHECK(block_make(context, model, n, &b));
  for (size_t from = 0; from < n; from += b.size) {
    size_t count = n - from < b.size ? n - from : b.size;
    for (size_t i = 0; i < count; i++) b.sample[i] = sample_of(sun[from + i], observer[from + i]);
    um_core_quiet_begin(context);
    status = render(context, model, &b, count, value + from * model->nband,
                    error != NULL ? error + from * model->nband : NULL);
    um_core_quiet_end(context);
    if (status != UM_OK) goto done;
    UM_CHECK(um_core_progress_step(context, count));
    UM_CHECK(um_core_stop_check(context, "reflectivities were computed"));
  }
done:
  um_core_progress_end(context);
  block_release(context, &b);
  return status;
}

double um_model_solar_irradiance(const struct um_model *model, size_t band)
{
  const struct um_optics_band *b = &model->band[band];
  double sum = 0.0;
  for (int i = 0; i < b->bins; i++)
    sum += (b->transmission != NULL ? b->transmission[i] : 1.0) *
           um_environment_solar_band(&model->environment, um_optics_band_edge(b, i),
                                     um_optics_band_edge(b, i + 1));
  return sum;
}

void um_model_sunlight(const struct um_model *model, const struct um_environment_sample *sample,
                       size_t band, double *out)
{
  const struct um_optics_band *b = &model->band[band];
  struct um_optics_sunlight light;
  um_optics_sunlight_at(&model->environment, sample, &light);
  for (int i = 0; i < b->bins; i++) {
    double from = um_optics_band_edge(b, i), to = um_optics_band_edge(b, i + 1);
    double mean = um_environment_solar_band(&model->environment, from, to) / (to - from);
    out[i] = um_optics_sunlight(&light, mean, 0.5 * (from + to));
  }
}

double um_model_sunlight_band(const struct um_model *model,
                              const struct um_environment_sample *sample, size_t band,
                              double *scratch)
{
  const struct um_optics_band *b = &model->band[band];
  double sum = 0.0;
  um_model_sunlight(model, sample, band, scratch);
  for (int i = 0; i < b->bins; i++)
    sum += (b->transmission != NULL ? b->transmission[i] : 1.0) * scratch[i] *
           (um_optics_band_edge(b, i + 1) - um_optics_band_edge(b, i));
  return sum;
}
