/* Spectra of the surfaces that a picture sees. Facets are flat and far from everything, so each has
 * one radiance in shadow and one in sunlight. */
#include <math.h>
#include <omp.h>
#include <string.h>

#include "optics/image/image_impl.h"
#include "optics/paths/interreflection_group.h"
#include "optics/paths/photons_group.h"
#include "optics/radiance/coarse_group.h"

struct palette {
  const struct um_optics_scene *scene;
  const struct um_optics_exposure *frame;
  size_t time, nthread;
  struct um_optics_spectra *spectra;
  struct um_optics_work *work;     /* [nthread] */
  struct um_optics_spectra *few;   /* light between surfaces: in few bins */
  struct um_optics_work *few_work; /* [nthread] */
  struct um_optics_photons photons;
  const double *seen; /* [nspectrum] share of each surface that is seen [1] */
};

/* Radiances of one surface: a share of it that is as large as 1 m^2 seen from the observer. */
static void fill(struct palette *p, size_t k, size_t thread, struct um_optics_image *image)
{
  struct um_optics_work *work = &p->work[thread];
  const struct um_geometry_mesh *mesh = p->frame->mesh;
  const struct um_optics_instant *now = &p->frame->now;
  const struct um_optics_scene *scene = p->scene;
  size_t n = image->nbin, surface = image->surface[k], at = p->time * mesh->nsurface + surface;
  size_t skin = um_optics_skin(p->spectra, mesh, surface);
  struct um_vec3 normal = um_geometry_surface_normal(mesh, p->frame->posed->pose, surface);
  float *dark = image->dark + k * n, *sun = image->sun + k * n;
  double cos_o = um_vec3_dot(normal, now->observer_body);
  if (!(cos_o > 0.0)) return;
  struct um_optics_sight sight = {
      .area_seen = 1.0 / cos_o,
      .area_lit = 1.0 / cos_o,
      .cos_observer = cos_o,
      .cos_lamp = um_vec3_dot(normal, now->lamp.body),
      .cos_half = um_vec3_dot(normal, now->lamp.half),
      .cos_sun = um_vec3_dot(normal, now->sun_body),
      .cos_nadir = um_vec3_dot(normal, now->nadir_body),
      .temperature = scene->temperature[at],
      .albedo = (double)scene->albedo[at],
      .view_factor = (double)scene->view_factor[at],
      .brightness = scene->brightness != NULL ? (double)scene->brightness[at] : 0.0};
  struct um_optics_earth_shares shares;
  um_optics_sight_turn(p->spectra, scene, surface, work, &sight);
  um_optics_sum_clear(p->spectra, &work->single);
  um_optics_earth_shares(p->spectra, now, skin, &sight, &shares);
  um_optics_sum_add(p->spectra, now, skin, &sight, 1, &shares, work, &work->single);
  um_optics_sum_spectrum(p->spectra, scene, now, skin, &work->single, work, work->spectral);
  for (size_t b = 0; b < n; b++) {
    const double *from = work->spectral + b * UM_MECHANISM_COUNT;
    sun[b] = (float)(from[UM_MECHANISM_SUN] + from[UM_MECHANISM_OTHER]);
    dark[b] = (float)(from[UM_MECHANISM_EARTH] + from[UM_MECHANISM_EMITTED]);
  }
  if (p->frame->posed->exchange == NULL) return;
  /* of a surface that something hides in part, the mean over the part that is seen */
  double seen = p->seen[k];
  const struct um_optics_paths paths = {.spectra = p->few,
                                        .scene = scene,
                                        .instant = now,
                                        .posed = p->frame->posed,
                                        .work = &p->few_work[thread],
                                        .factor = 1};
  if (!um_optics_interreflection(&paths, &p->photons, surface, seen)) return;
  um_optics_coarse_expand(p->few, p->spectra, paths.work->reflected, work->row);
  for (size_t b = 0; b < n; b++) dark[b] += (float)(work->row[b] / seen);
}

static enum um_status bins_create(struct um_context *context,
                                  const struct um_optics_spectra *spectra,
                                  struct um_optics_image *image)
{
  size_t n = spectra->nbin, count = image->nspectrum * n;
  image->nbin = n;
  image->nband = spectra->nband;
  UM_TRY(um_core_allocate(context, image->nband + 1, sizeof *image->first, &image->first));
  UM_TRY(um_core_allocate(context, n, sizeof(double), &image->wavelength));
  UM_TRY(um_core_allocate(context, n, sizeof(double), &image->bin_width));
  UM_TRY(um_core_allocate(context, n, sizeof(double), &image->transmission));
  UM_TRY(um_core_allocate(context, count, sizeof(float), &image->dark));
  UM_TRY(um_core_allocate(context, count, sizeof(float), &image->sun));
  memcpy(image->first, spectra->first, (image->nband + 1) * sizeof *image->first);
  memcpy(image->wavelength, spectra->wavelength, n * sizeof(double));
  memcpy(image->bin_width, spectra->width, n * sizeof(double));
  memcpy(image->transmission, spectra->transmission, n * sizeof(double));
  return UM_OK;
}

static void works_set(const struct palette *p, const struct um_optics_spectra *spectra,
                      struct um_optics_work *work)
{
  for (size_t i = 0; i < p->nthread; i++) {
    um_optics_light(spectra, p->scene, &p->frame->now, &work[i]);
    um_optics_turn(spectra, p->scene, &p->frame->now, &work[i]);
  }
}

/* What light between surfaces goes by. */
static enum um_status between_create(struct um_context *context, const struct um_optics_band *bands,
                                     size_t nband, struct palette *p)
{
  UM_TRY(um_optics_coarse_create(context, p->scene, p->time, 1, bands, nband, &p->few));
  UM_TRY(um_optics_work_create(context, p->few, UM_OPTICS_PATHS, p->nthread, &p->few_work));
  UM_TRY(um_optics_photons_reserve(context, p->few, p->frame->posed, 1, 0, &p->photons));
  works_set(p, p->few, p->few_work);
  const struct um_optics_paths paths = {.spectra = p->few,
                                        .scene = p->scene,
                                        .instant = &p->frame->now,
                                        .posed = p->frame->posed,
                                        .work = &p->few_work[0],
                                        .factor = 1};
  um_optics_photons_trace(&paths, p->scene->view != NULL ? p->scene->view->seed : 0, &p->photons);
  return UM_OK;
}

static enum um_status fill_all(struct um_context *context, struct palette *p,
                               struct um_optics_image *image)
{
  int threads = (int)p->nthread;
  works_set(p, p->spectra, p->work);
#pragma omp parallel for schedule(dynamic, 16) num_threads(threads)
  for (size_t k = 0; k < image->nspectrum; k++)
    if (!um_core_stopped(context)) fill(p, k, (size_t)omp_get_thread_num(), image);
  return um_core_stop_check(context, "a picture was rendered");
}

enum um_status um_optics_image_spectra(struct um_context *context,
                                       const struct um_optics_scene *scene, size_t time,
                                       const struct um_optics_band *bands, size_t nband,
                                       const struct um_optics_exposure *frame, const double *seen,
                                       struct um_optics_image *image)
{
  enum um_status status;
  struct palette p = {.scene = scene,
                      .frame = frame,
                      .time = time,
                      .seen = seen,
                      .nthread = (size_t)um_core_context_threads(context)};
  UM_CHECK(um_optics_spectra_create(context, scene, time, 1, bands, nband, &p.spectra));
  UM_CHECK(bins_create(context, p.spectra, image));
  UM_CHECK(um_optics_work_create(context, p.spectra, 0, p.nthread, &p.work));
  if (frame->posed->exchange != NULL) UM_CHECK(between_create(context, bands, nband, &p));
  UM_CHECK(fill_all(context, &p, image));
done:
  um_optics_photons_clear(context, &p.photons);
  um_optics_work_destroy(context, p.nthread, &p.work);
  um_optics_work_destroy(context, p.nthread, &p.few_work);
  um_optics_spectra_destroy(context, &p.spectra);
  um_optics_spectra_destroy(context, &p.few);
  return status;
}
