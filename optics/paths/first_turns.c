/* Where paths begin, and which of them meet something. */
#include "optics/paths/first_turns_group.h"

#include <math.h>
#include <string.h>

#include "base/core/golden.h"
#include "optics/paths/bundle_impl.h"
#include "optics/paths/exchange_impl.h"
#include "optics/paths/sampling_group.h"

enum { BY_COSINE = 1, BY_LOBE = 2 };

uint64_t um_optics_path_key(const struct um_optics_paths *paths, size_t surface)
{
  uint64_t seed = paths->scene->view != NULL ? paths->scene->view->seed : 0;
  return um_core_hash(um_core_hash(um_core_hash(UM_OPTICS_KEY_RAY, seed), surface),
                      paths->instant->time);
}

double um_optics_bundle_first(const struct um_optics_bundle *p, uint32_t sample, double u[2])
{
  double place[4];
  um_optics_sample_4d(p->key, sample, place);
  u[0] = place[2];
  u[1] = place[3];
  double which = um_core_hash_uniform(um_core_hash(p->key, UM_OPTICS_KEY_WAY)) + UM_GOLDEN * sample;
  return which - floor(which);
}

/* Do kept bits say which paths of the surface meet something? */
static bool serve(const struct um_optics_paths *paths, size_t skin)
{
  return paths->turns != NULL &&
         um_optics_same_lobe(&paths->turns->lobe[skin], &paths->spectra->lobe[skin]);
}

static bool meets(const struct um_optics_bundle *p, double share, uint32_t sample)
{
  size_t at = p->paths.turn + sample;
  double u[2];
  int both = p->paths.turns->bits[at / 4] >> (2 * (at % 4)) & 3;
  if (both == 0 || both == (BY_COSINE | BY_LOBE)) return both != 0;
  return (both & (um_optics_bundle_first(p, sample, u) < share ? BY_LOBE : BY_COSINE)) != 0;
}

bool um_optics_bundle_fill(struct um_optics_bundle *p, size_t surface, uint32_t *next,
                           uint32_t nsample)
{
  size_t skin = um_optics_skin(p->paths.spectra, p->paths.posed->exchange->mesh, surface);
  double share = p->paths.spectra->lobe_share[skin];
  p->known = serve(&p->paths, skin);
  p->n = 0;
  for (; p->n < UM_OPTICS_PATHS && *next < nsample; ++*next)
    if (!p->known || meets(p, share, *next)) p->sample[p->n++] = *next;
  return p->n > 0;
}

void um_optics_bundle_begin(struct um_optics_bundle *p, size_t surface, double seen)
{
  const struct um_optics_posed_scene *posed = p->paths.posed;
  struct um_vec3 observer = p->paths.instant->observer_body;
  struct um_optics_work *work = p->paths.work;
  p->alive = 0;
  for (int i = 0; i < p->n; i++) {
    double place[4];
    um_optics_sample_4d(p->key, p->sample[i], place);
    work->ray[i] = um_optics_path_begin(posed->exchange->mesh, posed->pose, surface, place);
    work->ray[i].direction = observer;
  }
  memset(work->hidden, 0, (size_t)p->n);
  if (seen < 1.0 && !p->known)
    um_geometry_visibility_occluded(posed->visibility, work->ray, (size_t)p->n, work->hidden);
  for (int i = 0; i < p->n; i++) {
    if (work->hidden[i]) continue;
    um_optics_vertex_place(&p->paths, surface, work->ray[i].origin, observer, &p->vertex[i]);
    p->mirrors[i] = true;
    p->of[p->alive++] = i;
  }
}

/* --- tracing --------------------------------------------------------------------------------- */

size_t um_optics_first_turns_of(const struct um_optics_paths *paths, size_t surface)
{
  const struct um_optics_view *view = paths->scene->view;
  bool toward = view->cos_observer[paths->instant->time * view->nsurface + surface] > 0.0F;
  return toward ? (size_t)(paths->posed->exchange->count[surface] * paths->factor) : 0;
}

enum um_status um_optics_first_turns_create(struct um_context *context,
                                            const struct um_optics_paths *paths, size_t *bytes,
                                            struct um_optics_first_turns *out)
{
  size_t n = 0;
  for (size_t s = 0; s < paths->scene->view->nsurface; s++) n += um_optics_first_turns_of(paths, s);
  *bytes = n / 4 + 1;
  return um_core_allocate(context, *bytes, sizeof *out->bits, &out->bits);
}

void um_optics_first_turns_clear(struct um_context *context, struct um_optics_first_turns *turns)
{
  um_core_free(context, turns->bits);
  *turns = (struct um_optics_first_turns){0};
}

/* Paths of a bundle by the lobe or by the cosine, into `way` of the bits. All of a closed surface
 * count: what leaves it is told apart. */
static void trace_way(struct um_optics_bundle *p, size_t surface, int way, uint8_t *bits)
{
  const struct um_optics_posed_scene *posed = p->paths.posed;
  struct um_geometry_ray *ray = p->paths.work->ray;
  bool closed = posed->exchange->closed[surface] != 0;
  int of[UM_OPTICS_PATHS], n = 0;
  for (int a = 0; a < p->alive; a++) {
    int i = p->of[a];
    struct um_vec3 direction = {0.0, 0.0, 0.0};
    double u[2];
    um_optics_bundle_first(p, p->sample[i], u);
    if (!closed &&
        !um_optics_vertex_direction(&p->paths, &p->vertex[i], way == BY_LOBE, u, &direction))
      continue;
    ray[n] = (struct um_geometry_ray){p->vertex[i].point, direction, INFINITY,
                                      posed->exchange->mesh->surface[surface].facet};
    of[n++] = i;
  }
  if (!closed) um_geometry_visibility_closest(posed->visibility, ray, (size_t)n, p->hit);
  for (int k = 0; k < n; k++) {
    size_t at = p->paths.turn + p->sample[of[k]];
    if (closed || p->hit[k].facet != UM_GEOMETRY_NONE)
      bits[at / 4] = (uint8_t)(bits[at / 4] | way << (2 * (at % 4)));
  }
}

void um_optics_first_turns_trace(const struct um_optics_paths *paths,
                                 struct um_optics_first_turns *turns)
{
  const struct um_optics_view *view = paths->scene->view;
  size_t from = paths->instant->time * view->nsurface;
  struct um_optics_bundle p = {.paths = *paths};
  for (size_t s = 0; s < view->nsurface; s++) {
    uint32_t n = (uint32_t)um_optics_first_turns_of(paths, s), next = 0;
    p.key = um_optics_path_key(paths, s);
    while (um_optics_bundle_fill(&p, s, &next, n)) {
      um_optics_bundle_begin(&p, s, (double)view->seen[from + s]);
      trace_way(&p, s, BY_COSINE, turns->bits);
      trace_way(&p, s, BY_LOBE, turns->bits);
    }
    p.paths.turn += n;
  }
}
