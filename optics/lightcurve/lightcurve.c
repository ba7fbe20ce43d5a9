/* Light curve: sums of surfaces by material, multiplied by spectra (radiance.c has the equations).
 * One time is one unit of work: its sums run in the order of surfaces and materials, so the bytes
 * do not depend on threads. */
#include <math.h>
#include <omp.h>
#include <string.h>

#include "optics/lightcurve/curve_impl.h"
#include "optics/lightcurve/warmth.h"
#include "optics/paths/between_group.h"
#include "optics/paths/photon_maps_group.h"
#include "optics/radiance/coarse_group.h"
#include "optics/radiance/coplanar_group.h"

/* Tables in some bins, and scratch for them. */
struct resolution {
  struct um_optics_spectra *spectra;
  struct um_optics_spectra *aged; /* [nthread], NULL where surfaces do not age */
  struct um_optics_work *work;    /* [nthread] */
};

struct job {
  const struct um_optics_scene *scene;
  struct um_optics_lightcurve *curve;
  struct resolution full, coarse; /* that of the bands; for errors and light between surfaces */
  struct um_optics_coplanar *coplanar;         /* [nthread] */
  struct um_optics_between *between;           /* [nthread] */
  const struct um_optics_photon_maps *photons; /* NULL: none that serve */
  const struct um_optics_warmth *warmth;       /* NULL: not asked */
  struct um_optics_glow *glow, *coarse_glow;   /* [nthread] where it is asked */
};

/* One time of it, on one thread. */
struct task {
  const struct job *job;
  struct um_optics_instant now;
  const struct um_optics_spectra *spectra, *coarse;
  struct um_optics_work *work, *coarse_work;
  struct um_optics_between *between;
  struct um_optics_glow *glow, *coarse_glow; /* NULL: not asked */
};

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

/* Variance from the traced fractions: the intensity that a standard error of area would add. */
static void error_add(const struct task *task, const struct um_optics_coplanar *coplanar, size_t i,
                      const struct um_optics_earth_shares *shares)
{
  size_t surface = coplanar->surface[i];
  const struct um_optics_scene *scene = task->job->scene;
  const struct um_optics_view *view = scene->view;
  const struct um_optics_spectra *spectra = task->coarse;
  struct um_optics_work *work = task->coarse_work;
  size_t time = task->now.time, at = time * view->nsurface + surface,
         skin = um_optics_skin(spectra, um_geometry_mesh(scene->geometry), surface);
  if (!(view->seen_error[at] > 0.0F || coplanar->lit_error[i] > 0.0F)) return;
  struct um_optics_sight error = coplanar->sight[i];
  error.area_seen = view->area[surface] * (double)view->seen_error[at];
  error.area_lit = view->area[surface] * (double)coplanar->lit_error[i];
  um_optics_sum_clear(spectra, &work->single);
  um_optics_sum_add(spectra, &task->now, skin, &error, 1, shares, work, &work->single);
  um_optics_sum_spectrum(spectra, scene, &task->now, skin, &work->single, work, work->spectral);
  for (size_t k = 0; k < spectra->nband; k++) {
    double sum = 0.0;
    for (size_t b = spectra->first[k]; b < spectra->first[k + 1]; b++)
      for (size_t m = 0; m < UM_MECHANISM_COUNT; m++)
        sum += work->spectral[b * UM_MECHANISM_COUNT + m] * spectra->transmission[b] *
               spectra->width[b];
    task->job->curve->stderr_[time * spectra->nband + k] += sum * sum;
  }
}

/* Light between all surfaces that are seen. */
static void between_add(const struct um_context *context, const struct task *task,
                        const struct um_optics_posed_scene *posed)
{
  const struct um_optics_spectra *few = task->coarse, *all = task->spectra;
  struct um_optics_work *work = task->work;
  const struct um_optics_paths paths = {.spectra = few,
                                        .scene = task->job->scene,
                                        .instant = &task->now,
                                        .posed = posed,
                                        .work = task->coarse_work,
                                        .photons = task->job->photons,
                                        .glow = task->coarse_glow,
                                        .factor =
                                            task->job->scene->view->path_factor[task->now.time]};
  um_optics_between_compute(context, &paths, task->between);
  memset(work->spectral, 0, all->nbin * UM_MECHANISM_COUNT * sizeof *work->spectral);
  for (size_t m = 0; m < all->nmaterial; m++) {
    um_optics_coarse_expand(few, all, task->between->sum + m * few->nbin, work->row);
    for (size_t b = 0; b < all->nbin; b++)
      work->spectral[b * UM_MECHANISM_COUNT + UM_MECHANISM_INTERREFLECTED] = work->row[b];
    spectrum_keep(task->job, task->now.time, m, work->spectral);
  }
  for (size_t k = 0; k < all->nband; k++) {
    size_t at = task->now.time * all->nband + k;
    task->job->curve->stderr_[at] += task->between->variance[k];
    task->job->curve->between_stderr[at] = sqrt(task->between->variance[k]);
  }
}

/* The tables for a time, of this thread where materials age; what is the same for all surfaces into
 * the scratch. */
static const struct um_optics_spectra *spectra_at(const struct um_context *context,
                                                  const struct job *job,
                                                  const struct resolution *resolution,
                                                  const struct um_optics_instant *now, int thread)
{
  struct um_optics_spectra *spectra = resolution->spectra;
  struct um_optics_work *work = &resolution->work[thread];
  if (resolution->aged != NULL) {
    spectra = &resolution->aged[thread];
    um_optics_spectra_materials(context, job->scene, now->time, spectra);
  }
  um_optics_light(spectra, job->scene, now, work);
  return spectra;
}

/* What surfaces of a group emit grows with their temperatures. */
static void glow_add(const struct task *task, size_t skin,
                     const struct um_optics_coplanar *coplanar, size_t first, size_t end)
{
  double cos_o = coplanar->sight[first].cos_observer;
  if (task->glow == NULL || task->now.sunlight_only || !(cos_o > 0.0)) return;
  const double *emissivity =
      um_optics_spectra_emissivity(task->spectra, skin, cos_o, task->work->emissivity);
  for (size_t i = first; i < end; i++) {
    double area = coplanar->sight[i].area_seen * cos_o;
    if (!(area > 0.0)) continue;
    double *to = um_optics_glow_of(task->glow, coplanar->surface[i]);
    for (size_t b = 0; b < task->glow->nbin; b++) to[b] += area * emissivity[b];
  }
}

/* Of every change of the temperatures what both glows make of it, into its spectrum. */
static void warmth_add(const struct task *task)
{
  const struct um_optics_warmth *warmth = task->job->warmth;
  struct um_optics_glow *glow = task->glow, *coarse = task->coarse_glow;
  size_t nsurface = glow->nsurface, nbin = glow->nbin, time = task->now.time,
         ntime = task->job->scene->view->ntime;
  const double *temperature = task->job->scene->temperature + time * nsurface;
  um_optics_glow_warm(glow, task->spectra, temperature);
  um_optics_glow_warm(coarse, task->coarse, temperature);
  for (size_t k = 0; k < warmth->n; k++) {
    double *out = warmth->spectral + (k * ntime + time) * nbin, *few = coarse->row;
    warmth->warming(warmth->user, k, time, glow->warming);
    memset(out, 0, nbin * sizeof *out);
    memset(few, 0, coarse->nbin * sizeof *few);
    for (size_t s = 0; s < nsurface; s++) {
      double t = glow->warming[s];
      const double *direct = glow->weight + s * nbin, *by = coarse->weight + s * coarse->nbin;
      for (size_t b = 0; b < nbin && glow->has[s]; b++) out[b] += t * direct[b];
      for (size_t b = 0; b < coarse->nbin && coarse->has[s]; b++) few[b] += t * by[b];
    }
    um_optics_coarse_expand(task->coarse, task->spectra, few, task->work->row);
    for (size_t b = 0; b < nbin; b++) out[b] += task->work->row[b];
  }
}

static void surfaces_add(const struct um_context *context, const struct task *task,
                         const struct um_optics_posed_scene *posed,
                         struct um_optics_coplanar *coplanar)
{
  const struct um_optics_scene *scene = task->job->scene;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(scene->geometry);
  struct um_optics_earth_shares shares;
  um_optics_coplanar_fill(task->spectra, scene, &task->now, task->work, coplanar);
  for (size_t g = 0; g < coplanar->ngroup && !um_core_stopped(context); g++) {
    size_t first = coplanar->first[g], end = coplanar->first[g + 1];
    size_t skin = um_optics_skin(task->spectra, mesh, coplanar->surface[first]);
    um_optics_earth_shares(task->spectra, &task->now, skin, &coplanar->sight[first], &shares);
    um_optics_sum_add(task->spectra, &task->now, skin, &coplanar->sight[first], end - first,
                      &shares, task->work, &task->work->sum[skin]);
    glow_add(task, skin, coplanar, first, end);
    for (size_t i = first; i < end; i++) error_add(task, coplanar, i, &shares);
  }
  if (posed != NULL) between_add(context, task, posed);
}

/* Surfaces by the instant's lamp, into the curve. */
static void lamp_add(const struct um_context *context, const struct task *task,
                     const struct um_optics_posed_scene *posed, struct um_optics_coplanar *coplanar)
{
  const struct um_optics_spectra *spectra = task->spectra;
  struct um_optics_work *work = task->work;
  for (size_t m = 0; m < spectra->nskin; m++) um_optics_sum_clear(spectra, &work->sum[m]);
  surfaces_add(context, task, posed, coplanar);
  for (size_t m = 0; m < spectra->nskin; m++) {
    um_optics_sum_spectrum(spectra, task->job->scene, &task->now, m, &work->sum[m], work,
                           work->spectral);
    spectrum_keep(task->job, task->now.time, um_optics_material(spectra, m), work->spectral);
  }
}

static void compute_time(const struct um_context *context, const struct job *job,
                         const struct um_optics_posed_scene *posed, size_t time)
{
  int thread = omp_get_thread_num();
  struct task task = {.job = job,
                      .now = um_optics_instant(job->scene, time),
                      .work = &job->full.work[thread],
                      .coarse_work = &job->coarse.work[thread],
                      .between = &job->between[thread]};
  if (job->warmth != NULL) {
    task.glow = &job->glow[thread];
    task.coarse_glow = &job->coarse_glow[thread];
    um_optics_glow_reset(task.glow);
    um_optics_glow_reset(task.coarse_glow);
  }
  task.spectra = spectra_at(context, job, &job->full, &task.now, thread);
  task.coarse = spectra_at(context, job, &job->coarse, &task.now, thread);
  const struct um_optics_spectra *spectra = task.spectra;
  struct um_optics_work *work = task.work;
  um_optics_turn(spectra, job->scene, &task.now, work);
  lamp_add(context, &task, posed, &job->coplanar[thread]);
  if (job->scene->view->moon_row[time] != SIZE_MAX && !job->scene->sunlight_only) {
    um_optics_instant_moon(job->scene, &task.now);
    task.now.sunlight_only = true;
    um_optics_light(spectra, job->scene, &task.now, work);
    um_optics_light(task.coarse, job->scene, &task.now, task.coarse_work);
    lamp_add(context, &task, NULL, &job->coplanar[thread]);
  }
  if (job->warmth != NULL) warmth_add(&task);
  for (size_t k = 0; k < spectra->nband; k++) {
    double *variance = &job->curve->stderr_[time * spectra->nband + k];
    *variance = sqrt(*variance);
  }
}

static enum um_status compute_all(struct um_context *context, const struct job *job,
                                  struct um_optics_posed_scenes *scenes)
{
  const struct um_optics_scene *scene = job->scene;
  size_t ntime = scene->view->ntime;
  int nray = scene->interreflection_samples;
  for (size_t from = 0; from < ntime; from += UM_OPTICS_BLOCK) {
    size_t count = ntime - from < UM_OPTICS_BLOCK ? ntime - from : UM_OPTICS_BLOCK;
    if (nray > 0) {
      UM_TRY(um_optics_posed_scenes_prepare(context, scene->geometry, scene->samples + from, count,
                                            nray, scenes));
      UM_TRY(um_optics_between_reserve(context, job->coarse.spectra, scenes,
                                       scene->view->path_factor, scene->view->ntime,
                                       (size_t)um_core_context_threads(context), job->between));
    }
#pragma omp parallel for schedule(dynamic, 1) num_threads(um_core_context_threads(context))
    for (size_t i = 0; i < count; i++)
      compute_time(context, job, nray > 0 ? &scenes->posed[scenes->of_time[i]] : NULL, from + i);
    UM_TRY(um_core_progress_step(context, count));
    UM_TRY(um_core_stop_check(context, "light curves were computed"));
  }
  return UM_OK;
}

/* Scratch beside the spectra, which are there. */
static enum um_status resolution_fill(struct um_context *context,
                                      const struct um_optics_scene *scene, size_t nray,
                                      struct resolution *out)
{
  size_t nthread = (size_t)um_core_context_threads(context);
  UM_TRY(um_optics_work_create(context, out->spectra, nray, nthread, &out->work));
  if (!scene->ages) return UM_OK;
  UM_TRY(um_core_allocate(context, nthread, sizeof *out->aged, &out->aged));
  for (size_t k = 0; k < nthread; k++)
    UM_TRY(um_optics_spectra_share(context, out->spectra, &out->aged[k]));
  return UM_OK;
}

static void resolution_clear(struct um_context *context, struct resolution *resolution)
{
  size_t nthread = (size_t)um_core_context_threads(context);
  um_optics_work_destroy(context, nthread, &resolution->work);
  for (size_t k = 0; resolution->aged != NULL && k < nthread; k++)
    um_optics_spectra_share_clear(context, &resolution->aged[k]);
  um_core_free(context, resolution->aged);
  um_optics_spectra_destroy(context, &resolution->spectra);
}

static enum um_status job_create(struct um_context *context, const struct um_optics_band *bands,
                                 size_t nband, struct job *job)
{
  const struct um_optics_scene *scene = job->scene;
  size_t nthread = (size_t)um_core_context_threads(context), ntime = scene->view->ntime;
  size_t nray = scene->interreflection_samples > 0 ? UM_OPTICS_PATHS : 0;
  UM_TRY(um_optics_spectra_create(context, scene, 0, ntime, bands, nband, &job->full.spectra));
  UM_TRY(um_optics_coarse_create(context, scene, 0, ntime, bands, nband, &job->coarse.spectra));
  UM_TRY(resolution_fill(context, scene, 0, &job->full));
  UM_TRY(resolution_fill(context, scene, nray, &job->coarse));
  UM_TRY(um_core_allocate(context, nthread, sizeof *job->coplanar, &job->coplanar));
  UM_TRY(um_optics_between_create(context, job->coarse.spectra, nthread, &job->between));
  for (size_t k = 0; k < nthread; k++)
    UM_TRY(um_optics_coplanar_create(context, scene->view->nsurface, &job->coplanar[k]));
  if (job->warmth != NULL) {
    UM_TRY(um_core_allocate(context, nthread, sizeof *job->glow, &job->glow));
    UM_TRY(um_core_allocate(context, nthread, sizeof *job->coarse_glow, &job->coarse_glow));
  }
  for (size_t k = 0; k < nthread && job->warmth != NULL; k++) {
    size_t nsurface = scene->view->nsurface;
    UM_TRY(um_optics_glow_create(context, nsurface, job->full.spectra, &job->glow[k]));
    UM_TRY(um_optics_glow_create(context, nsurface, job->coarse.spectra, &job->coarse_glow[k]));
  }
  UM_TRY(um_core_allocate(context, 1, sizeof *job->curve, &job->curve));
  return um_optics_curve_create(context, job->full.spectra, ntime, job->curve);
}

static void job_clear(struct um_context *context, struct job *job)
{
  size_t nthread = (size_t)um_core_context_threads(context);
  for (size_t k = 0; k < nthread; k++) {
    if (job->glow != NULL) um_optics_glow_clear(context, &job->glow[k]);
    if (job->coarse_glow != NULL) um_optics_glow_clear(context, &job->coarse_glow[k]);
  }
  UM_FREE(context, job->glow, job->coarse_glow);
  resolution_clear(context, &job->full);
  resolution_clear(context, &job->coarse);
  for (size_t k = 0; job->coplanar != NULL && k < nthread; k++)
    um_optics_coplanar_clear(context, &job->coplanar[k]);
  um_core_free(context, job->coplanar);
  um_optics_between_destroy(context, nthread, &job->between);
  um_optics_lightcurve_destroy(context, &job->curve);
}

enum um_status um_optics_lightcurve_compute(struct um_context *context,
                                            const struct um_optics_scene *scene,
                                            const struct um_optics_band *bands, size_t nband,
                                            struct um_optics_lightcurve **out)
{
  return um_optics_lightcurve_warmth(context, scene, bands, nband, NULL, out);
}

enum um_status um_optics_lightcurve_warmth(struct um_context *context,
                                           const struct um_optics_scene *scene,
                                           const struct um_optics_band *bands, size_t nband,
                                           const struct um_optics_warmth *warmth,
                                           struct um_optics_lightcurve **out)
{
  enum um_status status;
  struct um_optics_posed_scenes *scenes = NULL;
  struct job job = {.scene = scene, .warmth = warmth};
  size_t ntime = scene->view->ntime, nsurface = um_geometry_mesh(scene->geometry)->nsurface;
  *out = NULL;
  if (scene->view->nsurface != nsurface)
    return um_core_fail(context, UM_ERR_INPUT, "view of %zu surfaces for a geometry of %zu",
                        scene->view->nsurface, nsurface);
  UM_CHECK(job_create(context, bands, nband, &job));
  if (um_optics_photon_maps_are_compatible(scene->photons, scene, job.coarse.spectra))
    job.photons = scene->photons;
  UM_CHECK(um_core_allocate(context, 1, sizeof *scenes, &scenes));
  um_core_progress_begin(context, "computing light curves", ntime);
  status = compute_all(context, &job, scenes);
  um_core_progress_end(context);
  if (status == UM_OK) {
    *out = job.curve;
    job.curve = NULL;
  }
done:
  if (scenes != NULL) um_optics_posed_scenes_clear(context, scenes);
  um_core_free(context, scenes);
  job_clear(context, &job);
  return status;
}
