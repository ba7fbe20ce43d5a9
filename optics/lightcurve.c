/* Light curve: sums of surfaces by material, multiplied by spectra (radiance.c has the equations).
 * One time is one unit of work: its sums run in the order of surfaces and materials, so the bytes
 * do not depend on threads. */
#include <math.h>
#include <omp.h>
#include <string.h>

#include "optics/interreflection_impl.h"
#include "optics/stage_impl.h"

struct job {
  const struct um_optics_scene *scene;
  const struct um_optics_spectra *spectra;
  struct um_optics_lightcurve *curve;
  struct um_optics_spectra *aged; /* [nthread], NULL where surfaces do not age */
};

static enum um_status curve_create(struct um_context *context,
                                   const struct um_optics_spectra *spectra, size_t ntime,
                                   struct um_optics_lightcurve *c)
{
  c->ntime = ntime;
  c->nband = spectra->nband;
  c->nbin = spectra->nbin;
  c->nmaterial = spectra->nmaterial;
  UM_TRY(um_core_allocate(context, c->nbin, sizeof *c->wavelength, &c->wavelength));
  UM_TRY(um_core_allocate(context, c->nbin, sizeof *c->width, &c->width));
  UM_TRY(um_core_allocate(context, c->nbin, sizeof *c->transmission, &c->transmission));
  UM_TRY(um_core_allocate(context, c->nbin, sizeof *c->band, &c->band));
  UM_TRY(um_core_allocate(context, ntime * c->nbin * UM_MECHANISM_COUNT, sizeof *c->spectral,
                          &c->spectral));
  UM_TRY(um_core_allocate(context, ntime * c->nband * c->nmaterial * UM_MECHANISM_COUNT,
                          sizeof *c->intensity, &c->intensity));
  UM_TRY(um_core_allocate(context, ntime * c->nband, sizeof *c->stderr_, &c->stderr_));
  memcpy(c->wavelength, spectra->wavelength, c->nbin * sizeof *c->wavelength);
  memcpy(c->width, spectra->width, c->nbin * sizeof *c->width);
  memcpy(c->transmission, spectra->transmission, c->nbin * sizeof *c->transmission);
  memcpy(c->band, spectra->band, c->nbin * sizeof *c->band);
  return UM_OK;
}

/* Add one material's spectrum to the total of the bins and to its band sums. */
static void spectrum_keep(const struct job *job, size_t time, size_t material,
                          const double *spectral)
{
  const struct um_optics_lightcurve *c = job->curve;
  for (size_t b = 0; b < c->nbin; b++) {
    double *total = c->spectral + (time * c->nbin + b) * UM_MECHANISM_COUNT;
    double *band = c->intensity +
                   ((time * c->nband + c->band[b]) * c->nmaterial + material) * UM_MECHANISM_COUNT;
    for (int k = 0; k < UM_MECHANISM_COUNT; k++) {
      total[k] += spectral[b * UM_MECHANISM_COUNT + (size_t)k];
      band[k] += spectral[b * UM_MECHANISM_COUNT + (size_t)k] * c->transmission[b] * c->width[b];
    }
  }
}

static struct um_optics_sight sight_of(const struct um_optics_scene *scene, size_t at, size_t s)
{
  const struct um_optics_view *view = scene->view;
  return (struct um_optics_sight){
      .area_seen = view->area[s] * (double)view->seen[at],
      .area_lit = view->area[s] * (double)view->lit[at],
      .cos_observer = (double)view->cos_observer[at],
      .cos_sun = (double)view->cos_sun[at],
      .cos_half = view->cos_half[at],
      .cos_nadir = (double)view->cos_nadir[at],
      .temperature = scene->temperature[at],
      .albedo = (double)scene->albedo[at],
      .view_factor = (double)scene->view_factor[at],
      .brightness = scene->brightness != NULL ? (double)scene->brightness[at] : 0.0};
}

/* Variance from the traced fractions: the intensity that a standard error of area would add. */
static void error_add(const struct job *job, const struct um_optics_instant *now, size_t time,
                      size_t s, const struct um_optics_sight *sight, struct um_optics_work *work)
{
  const struct um_optics_view *view = job->scene->view;
  const struct um_optics_spectra *spectra = job->spectra;
  size_t at = time * view->nsurface + s,
         skin = um_optics_skin(spectra, um_geometry_mesh(job->scene->geometry), s);
  struct um_optics_sight error = *sight;
  error.area_seen = view->area[s] * (double)view->seen_error[at];
  error.area_lit = view->area[s] * (double)view->lit_error[at];
  um_optics_sum_clear(spectra, &work->single);
  um_optics_sum_add(spectra, now, skin, &error, work, &work->single);
  um_optics_sum_spectrum(spectra, job->scene, now, skin, &work->single, work, work->spectral);
  for (size_t k = 0; k < spectra->nband; k++) {
    double sum = 0.0;
    for (size_t b = spectra->first[k]; b < spectra->first[k + 1]; b++)
      for (size_t m = 0; m < UM_MECHANISM_COUNT; m++)
        sum += work->spectral[b * UM_MECHANISM_COUNT + m] * spectra->transmission[b] *
               spectra->width[b];
    job->curve->stderr_[time * spectra->nband + k] += sum * sum;
  }
}

static void interreflection_add(const struct job *job, const struct um_optics_instant *now,
                                const struct um_optics_set *set, size_t time, size_t s,
                                struct um_optics_work *work)
{
  const struct um_optics_view *view = job->scene->view;
  const struct um_optics_spectra *spectra = job->spectra;
  size_t at = time * view->nsurface + s;
  um_optics_interreflection(spectra, job->scene, now, set, time, s, (double)view->seen[at], work);
  double projected = view->area[s] * (double)view->cos_observer[at];
  memset(work->spectral, 0, spectra->nbin * UM_MECHANISM_COUNT * sizeof *work->spectral);
  for (size_t b = 0; b < spectra->nbin; b++)
    work->spectral[b * UM_MECHANISM_COUNT + UM_MECHANISM_INTERREFLECTED] =
        projected * work->reflected[b];
  spectrum_keep(job, time, view->material[s], work->spectral);
  for (size_t k = 0; k < spectra->nband; k++)
    job->curve->stderr_[time * spectra->nband + k] +=
        projected * projected * work->band_variance[k];
}

/* The job with the materials as they are at a time, in the tables of this thread. */
static struct job job_at(const struct um_context *context, const struct job *job, size_t time)
{
  struct job now = *job;
  if (job->aged == NULL) return now;
  struct um_optics_spectra *own = &job->aged[omp_get_thread_num()];
  um_optics_spectra_materials(context, job->scene, time, own);
  now.spectra = own;
  return now;
}

static void compute_time(const struct um_context *context, const struct job *all,
                         const struct um_optics_set *set, size_t time, struct um_optics_work *work)
{
  const struct job now_job = job_at(context, all, time), *job = &now_job;
  const struct um_optics_view *view = job->scene->view;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(job->scene->geometry);
  const struct um_optics_spectra *spectra = job->spectra;
  struct um_optics_instant now = um_optics_instant(job->scene, time);
  memset(work->specular_known, 0, spectra->nskin * sizeof *work->specular_known);
  um_optics_light(spectra, job->scene, &now, work);
  um_optics_turn(spectra, job->scene, &now, work);
  for (size_t m = 0; m < spectra->nskin; m++) um_optics_sum_clear(spectra, &work->sum[m]);
  for (size_t s = 0; s < view->nsurface && !um_core_stopped(context); s++) {
    size_t at = time * view->nsurface + s, skin = um_optics_skin(spectra, mesh, s);
    bool uncertain = view->seen_error[at] > 0.0F || view->lit_error[at] > 0.0F;
    if (!(view->cos_observer[at] > 0.0F) || !(view->seen[at] > 0.0F || uncertain)) continue;
    struct um_optics_sight sight = sight_of(job->scene, at, s);
    um_optics_sight_turn(spectra, job->scene, s, work, &sight);
    um_optics_sum_add(spectra, &now, skin, &sight, work, &work->sum[skin]);
    if (uncertain) error_add(job, &now, time, s, &sight, work);
    if (set != NULL && view->seen[at] > 0.0F && um_optics_exchange_has(set->exchange, s))
      interreflection_add(job, &now, set, time, s, work);
  }
  for (size_t m = 0; m < spectra->nskin; m++) {
    um_optics_sum_spectrum(spectra, job->scene, &now, m, &work->sum[m], work, work->spectral);
    spectrum_keep(job, time, um_optics_material(spectra, m), work->spectral);
  }
  for (size_t k = 0; k < spectra->nband; k++) {
    double *variance = &job->curve->stderr_[time * spectra->nband + k];
    *variance = sqrt(*variance);
  }
}

static enum um_status compute_all(struct um_context *context, const struct job *job,
                                  struct um_optics_stage *stage, struct um_optics_work *work)
{
  const struct um_optics_scene *scene = job->scene;
  size_t ntime = scene->view->ntime;
  int nray = scene->interreflection_samples;
  for (size_t from = 0; from < ntime; from += UM_OPTICS_BLOCK) {
    size_t count = ntime - from < UM_OPTICS_BLOCK ? ntime - from : UM_OPTICS_BLOCK;
    if (nray > 0)
      UM_TRY(um_optics_stage_prepare(context, scene->geometry, scene->samples + from, count, nray,
                                     stage));
#pragma omp parallel for schedule(dynamic, 1) num_threads(um_core_context_threads(context))
    for (size_t i = 0; i < count; i++)
      compute_time(context, job, nray > 0 ? &stage->set[stage->of_time[i]] : NULL, from + i,
                   &work[omp_get_thread_num()]);
    UM_TRY(um_core_progress_step(context, count));
    UM_TRY(um_core_stop_check(context, "light curves were computed"));
  }
  return UM_OK;
}

enum um_status um_optics_lightcurve_compute(struct um_context *context,
                                            const struct um_optics_scene *scene,
                                            const struct um_optics_band *bands, size_t nband,
                                            struct um_optics_lightcurve **out)
{
  enum um_status status = UM_OK;
  struct um_optics_spectra *spectra = NULL;
  struct um_optics_lightcurve *curve = NULL;
  struct um_optics_stage *stage = NULL;
  struct um_optics_work *work = NULL;
  struct um_optics_spectra *aged = NULL;
  size_t nthread = (size_t)um_core_context_threads(context), ntime = scene->view->ntime;
  size_t nray = scene->interreflection_samples > 0 ? (size_t)scene->interreflection_samples : 0;
  size_t nsurface = um_geometry_mesh(scene->geometry)->nsurface;
  *out = NULL;
  if (scene->view->nsurface != nsurface)
    return um_core_fail(context, UM_ERR_INPUT, "view of %zu surfaces for a geometry of %zu",
                        scene->view->nsurface, nsurface);
  UM_CHECK(um_optics_spectra_create(context, scene, 0, ntime, bands, nband, &spectra));
  UM_CHECK(um_core_allocate(context, 1, sizeof *curve, &curve));
  UM_CHECK(curve_create(context, spectra, ntime, curve));
  UM_CHECK(um_core_allocate(context, 1, sizeof *stage, &stage));
  UM_CHECK(um_optics_work_create(context, spectra, nray, nthread, &work));
  struct job job = {.scene = scene, .spectra = spectra, .curve = curve};
  if (scene->ages) {
    UM_CHECK(um_core_allocate(context, nthread, sizeof *aged, &aged));
    for (size_t k = 0; k < nthread; k++)
      UM_CHECK(um_optics_spectra_share(context, spectra, &aged[k]));
    job.aged = aged;
  }
  um_core_progress_begin(context, "computing light curves", ntime);
  status = compute_all(context, &job, stage, work);
  um_core_progress_end(context);
  if (status == UM_OK) {
    *out = curve;
    curve = NULL;
  }
done:
  um_optics_work_destroy(context, nthread, &work);
  if (stage != NULL) um_optics_stage_clear(context, stage);
  um_core_free(context, stage);
  for (size_t k = 0; aged != NULL && k < nthread; k++)
    um_optics_spectra_share_clear(context, &aged[k]);
  um_core_free(context, aged);
  um_optics_spectra_destroy(context, &spectra);
  um_optics_lightcurve_destroy(context, &curve);
  return status;
}

void um_optics_lightcurve_destroy(struct um_context *context, struct um_optics_lightcurve **curve)
{
  if (curve == NULL || *curve == NULL) return;
  struct um_optics_lightcurve *c = *curve;
  void *const blocks[] = {c->wavelength, c->width,     c->transmission, c->band,
                          c->spectral,   c->intensity, c->stderr_};
  for (size_t i = 0; i < sizeof blocks / sizeof blocks[0]; i++) um_core_free(context, blocks[i]);
  um_core_free(context, c);
  *curve = NULL;
}
