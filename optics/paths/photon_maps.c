/* Photons of every instant, kept, and which paths meet something (first_turns_group.h). Photons
 * hang on poses, the Sun and the lobes of mirrors; how much mirrors reflect of which wavelength is
 * multiplied in when photons are looked up. One thing else does: a path of several mirrors goes on
 * as often as they reflect. Kept paths have gone on as those of the scene that they were traced in,
 * and count for those that have not: of other reflectances light has the same mean, and moves
 * smoothly with them. */
#include "optics/paths/photon_maps.h"

#include <omp.h>
#include <string.h>

#include "optics/paths/photon_maps_group.h"
#include "optics/paths/posed_scenes_group.h"
#include "optics/radiance/coarse_group.h"

#define MOST ((size_t)256 << 20) /* [byte] */

/* Of one instant. */
struct kept {
  size_t count, nbeam, nroot;
  struct um_optics_photon *photon; /* [count] */
  struct um_optics_beam *beam;     /* [nbeam] */
  struct um_optics_first_turns turns;
};

struct um_optics_photon_maps {
  size_t ntime, nskin, bytes;
  int samples;                    /* of the scene, between surfaces */
  int *factor;                    /* [ntime] times these */
  struct um_materials_lobe *lobe; /* [nskin] */
  struct kept *at;                /* [ntime] */
};

/* --- tracing --------------------------------------------------------------------------------- */

struct tracing {
  const struct um_optics_scene *scene;
  struct um_optics_spectra *spectra; /* in the bins of light between surfaces */
  struct um_optics_work *work;       /* [nthread] */
  struct um_optics_posed_scenes *scenes;
  struct um_optics_photons photons; /* of the current instant */
};

static enum um_status tracing_begin(struct um_context *context, const struct um_optics_scene *scene,
                                    const struct um_optics_band *bands, size_t nband,
                                    struct tracing *t)
{
  t->scene = scene;
  UM_TRY(um_optics_coarse_create(context, scene, 0, 0, bands, nband, &t->spectra));
  UM_TRY(um_optics_work_create(context, t->spectra, UM_OPTICS_PATHS,
                               (size_t)um_core_context_threads(context), &t->work));
  return um_core_allocate(context, 1, sizeof *t->scenes, &t->scenes);
}

static void tracing_end(struct um_context *context, struct tracing *t)
{
  um_optics_photons_clear(context, &t->photons);
  if (t->scenes != NULL) um_optics_posed_scenes_clear(context, t->scenes);
  um_core_free(context, t->scenes);
  um_optics_work_destroy(context, (size_t)um_core_context_threads(context), &t->work);
  um_optics_spectra_destroy(context, &t->spectra);
}

static enum um_status keep(struct um_context *context, const struct um_optics_photons *p,
                           struct kept *kept)
{
  UM_TRY(um_core_allocate(context, p->count, sizeof *kept->photon, &kept->photon));
  UM_TRY(um_core_allocate(context, p->nbeam, sizeof *kept->beam, &kept->beam));
  if (p->count > 0) memcpy(kept->photon, p->photon, p->count * sizeof *kept->photon);
  if (p->nbeam > 0) memcpy(kept->beam, p->beam, p->nbeam * sizeof *kept->beam);
  kept->count = p->count;
  kept->nbeam = p->nbeam;
  kept->nroot = p->nroot;
  return UM_OK;
}

static struct um_optics_paths paths_at(const struct tracing *t,
                                       const struct um_optics_posed_scene *posed,
                                       const struct um_optics_instant *now,
                                       struct um_optics_work *work)
{
  return (struct um_optics_paths){.spectra = t->spectra,
                                  .scene = t->scene,
                                  .instant = now,
                                  .posed = posed,
                                  .work = work,
                                  .factor = t->scene->view->path_factor[now->time]};
}

/* Photons of an instant, and room for its first turns. */
static enum um_status trace(struct um_context *context, struct tracing *t,
                            const struct um_optics_posed_scene *posed, size_t time,
                            struct um_optics_photon_maps *maps)
{
  struct um_optics_instant now = um_optics_instant(t->scene, time);
  const struct um_optics_paths paths = paths_at(t, posed, &now, t->work);
  size_t bytes;
  UM_TRY(um_optics_photons_reserve(context, t->spectra, posed, paths.factor, t->spectra->nband,
                                   &t->photons));
  um_optics_turn(t->spectra, t->scene, &now, t->work);
  um_optics_photons_trace(&paths, t->scene->view->seed, &t->photons);
  UM_TRY(um_optics_first_turns_create(context, &paths, &bytes, &maps->at[time].turns));
  maps->at[time].turns.lobe = maps->lobe;
  maps->factor[time] = paths.factor;
  maps->bytes += t->photons.count * sizeof *t->photons.photon + bytes;
  return keep(context, &t->photons, &maps->at[time]);
}

/* First turns of instants from `from` on, `count` of them; their bits are there. */
static void trace_turns(const struct um_context *context, struct tracing *t, size_t from,
                        size_t count, struct um_optics_photon_maps *maps)
{
#pragma omp parallel for schedule(dynamic, 1) num_threads(um_core_context_threads(context))
  for (size_t i = 0; i < count; i++) {
    struct um_optics_instant now = um_optics_instant(t->scene, from + i);
    struct um_optics_work *work = &t->work[omp_get_thread_num()];
    const struct um_optics_paths paths =
        paths_at(t, &t->scenes->posed[t->scenes->of_time[i]], &now, work);
    if (maps->at[from + i].turns.bits == NULL || um_core_stopped(context)) continue;
    um_optics_turn(t->spectra, t->scene, &now, work);
    um_optics_first_turns_trace(&paths, &maps->at[from + i].turns);
  }
}

static enum um_status trace_all(struct um_context *context, struct tracing *t,
                                struct um_optics_photon_maps *maps)
{
  const struct um_optics_scene *scene = t->scene;
  for (size_t from = 0; from < maps->ntime; from += UM_OPTICS_BLOCK) {
    size_t left = maps->ntime - from, count = left < UM_OPTICS_BLOCK ? left : UM_OPTICS_BLOCK;
    UM_TRY(um_core_stop_check(context, "sunlight was followed between mirrors"));
    UM_TRY(um_optics_posed_scenes_prepare(context, scene->geometry, scene->samples + from, count,
                                          maps->samples, t->scenes));
    for (size_t i = 0; i < count && maps->bytes <= MOST; i++)
      UM_TRY(trace(context, t, &t->scenes->posed[t->scenes->of_time[i]], from + i, maps));
    if (maps->bytes <= MOST) trace_turns(context, t, from, count, maps);
  }
  return UM_OK;
}

enum um_status um_optics_photon_maps_create(struct um_context *context,
                                            const struct um_optics_scene *scene,
                                            const struct um_optics_band *bands, size_t nband,
                                            struct um_optics_photon_maps **out)
{
  enum um_status status;
  struct tracing t = {0};
  struct um_optics_photon_maps *maps = NULL;
  *out = NULL;
  if (scene->ages || scene->interreflection_samples == 0) return UM_OK;
  UM_CHECK(um_core_allocate(context, 1, sizeof *maps, &maps));
  maps->ntime = scene->view->ntime;
  maps->samples = scene->interreflection_samples;
  UM_CHECK(um_core_allocate(context, maps->ntime, sizeof *maps->factor, &maps->factor));
  UM_CHECK(um_core_allocate(context, maps->ntime, sizeof *maps->at, &maps->at));
  UM_CHECK(tracing_begin(context, scene, bands, nband, &t));
  maps->nskin = t.spectra->nskin;
  UM_CHECK(um_core_allocate(context, maps->nskin, sizeof *maps->lobe, &maps->lobe));
  memcpy(maps->lobe, t.spectra->lobe, maps->nskin * sizeof *maps->lobe);
  UM_CHECK(trace_all(context, &t, maps));
  if (maps->bytes > MOST) goto done;
  *out = maps;
  maps = NULL;
done:
  tracing_end(context, &t);
  um_optics_photon_maps_destroy(context, &maps);
  return status;
}

void um_optics_photon_maps_destroy(struct um_context *context, struct um_optics_photon_maps **maps)
{
  if (maps == NULL || *maps == NULL) return;
  struct um_optics_photon_maps *m = *maps;
  for (size_t t = 0; m->at != NULL && t < m->ntime; t++) {
    UM_FREE(context, m->at[t].photon, m->at[t].beam);
    um_optics_first_turns_clear(context, &m->at[t].turns);
  }
  UM_FREE(context, m->at, m->factor, m->lobe, m);
  *maps = NULL;
}

/* --- taking ---------------------------------------------------------------------------------- */

/* Do two lobes send photons alike? What is no mirror ends them. */
static bool same_mirror(const struct um_materials_lobe *a, const struct um_materials_lobe *b)
{
  if (!um_optics_is_mirror(a) || !um_optics_is_mirror(b))
    return um_optics_is_mirror(a) == um_optics_is_mirror(b);
  return um_optics_same_lobe(a, b);
}

bool um_optics_photon_maps_are_compatible(const struct um_optics_photon_maps *maps,
                                          const struct um_optics_scene *scene,
                                          const struct um_optics_spectra *spectra)
{
  if (maps == NULL || scene->ages || maps->ntime != scene->view->ntime ||
      maps->samples != scene->interreflection_samples || maps->nskin != spectra->nskin)
    return false;
  for (size_t t = 0; t < maps->ntime; t++)
    if (maps->factor[t] != scene->view->path_factor[t]) return false;
  for (size_t s = 0; s < maps->nskin; s++)
    if (!same_mirror(&maps->lobe[s], &spectra->lobe[s])) return false;
  return true;
}

void um_optics_photon_maps_take(const struct um_optics_photon_maps *maps, size_t time,
                                struct um_optics_photons *photons)
{
  const struct kept *kept = &maps->at[time];
  if (kept->count > 0) memcpy(photons->photon, kept->photon, kept->count * sizeof *kept->photon);
  if (kept->nbeam > 0) memcpy(photons->beam, kept->beam, kept->nbeam * sizeof *kept->beam);
  photons->count = kept->count;
  photons->nbeam = kept->nbeam;
  photons->nroot = kept->nroot;
  um_optics_photons_begin(photons);
}

const struct um_optics_first_turns *
um_optics_photon_maps_turns(const struct um_optics_photon_maps *maps, size_t time)
{
  return &maps->at[time].turns;
}
