/* Sums of inter-reflection over surfaces: each sends the radiance of interreflection.c. */
#include "optics/paths/between_group.h"

#include <string.h>

#include "optics/paths/first_turns_group.h"
#include "optics/paths/interreflection_group.h"
#include "optics/paths/photon_maps_group.h"

enum um_status um_optics_between_create(struct um_context *context,
                                        const struct um_optics_spectra *spectra, size_t n,
                                        struct um_optics_between **out)
{
  UM_TRY(um_core_allocate(context, n, sizeof **out, out));
  for (size_t i = 0; i < n; i++) {
    struct um_optics_between *b = &(*out)[i];
    UM_TRY(um_core_allocate(context, spectra->nmaterial * spectra->nbin, sizeof *b->sum, &b->sum));
    UM_TRY(um_core_allocate(context, spectra->nband, sizeof *b->variance, &b->variance));
  }
  return UM_OK;
}

void um_optics_between_destroy(struct um_context *context, size_t n,
                               struct um_optics_between **between)
{
  for (size_t i = 0; *between != NULL && i < n; i++) {
    um_optics_photons_clear(context, &(*between)[i].photons);
    UM_FREE(context, (*between)[i].sum, (*between)[i].variance);
  }
  um_core_free(context, *between);
  *between = NULL;
}

enum um_status um_optics_between_reserve(struct um_context *context,
                                         const struct um_optics_spectra *spectra,
                                         const struct um_optics_posed_scenes *scenes,
                                         const int *factor, size_t ntime, size_t n,
                                         struct um_optics_between *between)
{
  int largest = 1;
  for (size_t t = 0; t < ntime; t++) largest = factor[t] > largest ? factor[t] : largest;
  for (size_t i = 0; i < n; i++)
    for (size_t k = 0; k < scenes->nposed; k++)
      UM_TRY(um_optics_photons_reserve(context, spectra, &scenes->posed[k], largest, spectra->nband,
                                       &between[i].photons));
  return UM_OK;
}

/* What a surface sends, from the scratch. */
static void add(const struct um_optics_paths *paths, size_t surface,
                struct um_optics_between *between)
{
  const struct um_optics_view *view = paths->scene->view;
  const struct um_optics_spectra *spectra = paths->spectra;
  const struct um_optics_work *work = paths->work;
  size_t n = spectra->nbin, at = paths->instant->time * view->nsurface + surface;
  double projected = view->area[surface] * (double)view->cos_observer[at];
  double *sum = between->sum + view->material[surface] * n;
  for (size_t b = 0; b < n; b++) sum[b] += projected * work->reflected[b];
  for (size_t k = 0; k < spectra->nband; k++)
    between->variance[k] += projected * projected * work->band_variance[k];
}

void um_optics_between_compute(const struct um_context *context,
                               const struct um_optics_paths *paths,
                               struct um_optics_between *between)
{
  const struct um_optics_view *view = paths->scene->view;
  const struct um_optics_spectra *spectra = paths->spectra;
  struct um_optics_paths now = *paths;
  size_t from = paths->instant->time * view->nsurface;
  memset(between->sum, 0, spectra->nmaterial * spectra->nbin * sizeof *between->sum);
  memset(between->variance, 0, spectra->nband * sizeof *between->variance);
  um_optics_turn(spectra, paths->scene, paths->instant, paths->work);
  if (now.photons != NULL) {
    um_optics_photon_maps_take(now.photons, paths->instant->time, &between->photons);
    now.turns = um_optics_photon_maps_turns(now.photons, paths->instant->time);
  } else {
    um_optics_photons_trace(paths, view->seed, &between->photons);
  }
  /* surfaces of which the view's points saw nothing, too: paths look for themselves */
  for (size_t s = 0; s < view->nsurface && !um_core_stopped(context); s++) {
    if (view->cos_observer[from + s] > 0.0F &&
        um_optics_interreflection(&now, &between->photons, s, (double)view->seen[from + s]))
      add(&now, s, between);
    now.turn += um_optics_first_turns_of(paths, s);
  }
  for (size_t k = 0; k < spectra->nband; k++)
    between->variance[k] += um_optics_photons_variance(&between->photons, k);
}
