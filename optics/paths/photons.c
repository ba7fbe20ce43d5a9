/* Sunlight from mirror to mirror (photons_group.h). Photon paths begin at points of sunlit mirrors
 * that others can see, each with flux
 *
 *   A cos_i/N f(s, o) cos_o/p(o),
 *
 * f the mean of the lobe over the Sun's disc, and go on with f cos_o/p at each further mirror.
 * After ROULETTE of them a path goes on as often as the mirror reflects, SURVIVAL_LIMIT at most,
 * and then counts for those that do not (Arvo & Kirk 1990): few photons hold all paths. */
#include "optics/paths/photons_group.h"

#include <math.h>
#include <string.h>

#include "optics/paths/exchange_impl.h"
#include "optics/paths/sampling_group.h"

#define EACH           2    /* photon paths of a mirror, per path of a surface */
#define ROULETTE       2    /* mirrors */
#define SURVIVAL_LIMIT 0.75 /* 2 + 0.75/(1 - 0.75) = 5 photons of a path in the mean, at most */
#define ROOM           6    /* photons of a path, and SPARE for all: beyond that paths end */
#define SPARE          256
#define LONGEST        256 /* mirrors of a path */

enum { KEY_PHOTON = 0x70686f74, KEY_DISC = 0x64697363, KEY_STAY = 0x73746179 };

/* Ways of one mirror that are traced together. */
struct bundle {
  const struct um_optics_paths *paths;
  struct um_optics_photons *photons;
  uint64_t key;
  uint32_t root, sample; /* of the first */
  int alive;
  int of[UM_OPTICS_PATHS];          /* [alive] */
  uint32_t before[UM_OPTICS_PATHS]; /* [alive] and what follows */
  double area[UM_OPTICS_PATHS];
  struct um_optics_vertex vertex[UM_OPTICS_PATHS];
  struct um_optics_turn turn[UM_OPTICS_PATHS];
};

static bool is_mirror(const struct um_optics_paths *paths, size_t surface)
{
  return um_optics_is_mirror(
      &paths->spectra->lobe[um_optics_skin(paths->spectra, paths->posed->exchange->mesh, surface)]);
}

enum um_status um_optics_photons_reserve(struct um_context *context,
                                         const struct um_optics_spectra *spectra,
                                         const struct um_optics_posed_scene *posed, int factor,
                                         size_t nband, struct um_optics_photons *photons)
{
  const struct um_optics_paths paths = {.spectra = spectra, .posed = posed};
  size_t nsurface = posed->exchange->mesh->nsurface, nroot = 0;
  for (size_t s = 0; s < nsurface; s++)
    if (is_mirror(&paths, s)) nroot += EACH * (size_t)(posed->exchange->count[s] * factor);
  if (photons->first == NULL) {
    photons->nband = nband;
    photons->nsurface = nsurface;
    UM_TRY(um_core_allocate(context, nsurface + 1, sizeof *photons->first, &photons->first));
    UM_TRY(um_core_allocate(context, nsurface, sizeof *photons->beam, &photons->beam));
  }
  if (nroot <= photons->root_room) return UM_OK;
  UM_FREE(context, photons->photon, photons->order, photons->brought);
  photons->photon = NULL;
  photons->order = NULL;
  photons->brought = NULL;
  photons->root_room = nroot;
  photons->room = ROOM * nroot + SPARE;
  UM_TRY(um_core_allocate(context, photons->room, sizeof *photons->photon, &photons->photon));
  UM_TRY(um_core_allocate(context, photons->room, sizeof *photons->order, &photons->order));
  return um_core_allocate(context, nroot * nband, sizeof *photons->brought, &photons->brought);
}

void um_optics_photons_clear(struct um_context *context, struct um_optics_photons *photons)
{
  UM_FREE(context, photons->photon, photons->first, photons->order, photons->beam,
          photons->brought);
  *photons = (struct um_optics_photons){0};
}

static double number(const struct bundle *b, int i, int mirror, uint64_t use)
{
  uint64_t key = um_core_hash(um_core_hash(b->key, b->sample + (uint32_t)i), (uint64_t)mirror);
  return um_core_hash_uniform(um_core_hash(key, use));
}

/* F of a lobe, the largest of some wavelengths [1]. */
static double largest_f(const struct um_optics_spectra *s, size_t skin, double cos_d)
{
  double weight[4], largest = 0.0;
  size_t n = s->nbin, some = n / 16 + 1;
  const double *node = um_optics_fresnel_at(s, skin, cos_d, weight);
  for (size_t b = 0; b < n; b += some)
    largest = fmax(largest, weight[0] * node[b] + weight[1] * node[n + b] +
                                weight[2] * node[2 * n + b] + weight[3] * node[3 * n + b]);
  return largest;
}

/* The photon that a path becomes where it meets a surface; false: no room. */
static bool fall(struct bundle *b, int i, int mirror, const struct um_geometry_hit *hit)
{
  struct um_optics_photons *all = b->photons;
  if (all->count == all->room) return false;
  all->photon[all->count] = (struct um_optics_photon){
      .surface = hit->surface,
      .before = b->before[i],
      .root = b->root + (uint32_t)i,
      .mirrors = (uint16_t)(mirror + 1),
      .skin = (uint16_t)b->vertex[i].skin,
      .cos_d = (float)b->turn[i].cos_d,
      .area = (float)b->area[i],
      .point = um_optics_facet_point(b->paths->posed->exchange->mesh, b->paths->posed->pose,
                                     hit->facet, hit->weight),
      .from = um_vec3_scale(b->turn[i].direction, -1.0)};
  b->before[i] = (uint32_t)all->count++;
  return true;
}

/* Does a path go on from the mirror that it has come to? */
static bool goes_on(struct bundle *b, int i, int mirror)
{
  if (!(b->area[i] > 0.0) || mirror == LONGEST) return false;
  if (mirror < ROULETTE) return true;
  double share =
      fmin(SURVIVAL_LIMIT, largest_f(b->paths->spectra, b->vertex[i].skin, b->vertex[i].o.z));
  if (!(number(b, i, mirror, KEY_STAY) < share)) return false;
  b->area[i] /= share;
  return true;
}

/* All paths by one more mirror. */
static void step(struct bundle *b, int mirror)
{
  const struct um_optics_posed_scene *posed = b->paths->posed;
  const struct um_geometry_mesh *mesh = posed->exchange->mesh;
  struct um_optics_work *work = b->paths->work;
  struct um_geometry_hit hit[UM_OPTICS_PATHS];
  int went = 0, stays = 0;
  for (int a = 0; a < b->alive; a++) {
    int i = b->of[a];
    double u[4];
    if (mirror == 0) {
      um_optics_sample_4d(b->key, b->sample + (uint32_t)i, u);
    } else {
      u[2] = number(b, i, mirror, KEY_PHOTON);
      u[3] = number(b, i, mirror, KEY_PHOTON + 1);
    }
    if (!um_optics_vertex_mirror(b->paths, &b->vertex[i], mirror == 0, u + 2, &b->turn[i]))
      continue;
    b->area[i] *= b->turn[i].lobe;
    work->ray[went] = (struct um_geometry_ray){b->vertex[i].point, b->turn[i].direction, INFINITY,
                                               mesh->surface[b->vertex[i].surface].facet};
    b->of[went++] = i;
  }
  um_geometry_visibility_closest(posed->visibility, work->ray, (size_t)went, hit);
  for (int a = 0; a < went; a++) {
    int i = b->of[a];
    if (hit[a].facet == UM_GEOMETRY_NONE || hit[a].surface == UM_GEOMETRY_NONE) continue;
    if (!fall(b, i, mirror, &hit[a]) || !is_mirror(b->paths, hit[a].surface)) continue;
    const struct um_optics_photon *at = &b->photons->photon[b->before[i]];
    um_optics_vertex_place(b->paths, at->surface, at->point, at->from, &b->vertex[i]);
    if (b->vertex[i].o.z > 0.0 && goes_on(b, i, mirror + 1)) b->of[stays++] = i;
  }
  b->alive = stays;
}

/* Photon paths from sample `b->sample` on that begin in sunlight, n of them of `count` in all. */
static void begin(struct bundle *b, size_t surface, int n, uint32_t count)
{
  const struct um_optics_posed_scene *posed = b->paths->posed;
  const struct um_optics_instant *now = b->paths->instant;
  const struct um_geometry_mesh *mesh = posed->exchange->mesh;
  struct um_optics_work *work = b->paths->work;
  size_t skin = um_optics_skin(b->paths->spectra, mesh, surface);
  bool delta = b->paths->spectra->lobe[skin].kind->delta;
  for (int i = 0; i < n; i++) {
    double u[4], disc[2] = {number(b, i, 0, KEY_DISC), number(b, i, 0, KEY_DISC + 1)};
    um_optics_sample_4d(b->key, b->sample + (uint32_t)i, u);
    work->ray[i] = um_optics_path_begin(mesh, posed->pose, surface, u);
    work->ray[i].direction = um_optics_disc_direction(now, disc);
  }
  um_geometry_visibility_occluded(posed->visibility, work->ray, (size_t)n, work->occluded);
  b->alive = 0;
  for (int i = 0; i < n; i++) {
    if (work->occluded[i]) continue;
    um_optics_vertex_place(b->paths, surface, work->ray[i].origin,
                           delta ? work->ray[i].direction : now->sun_body, &b->vertex[i]);
    if (!(b->vertex[i].o.z > 0.0)) continue;
    b->before[i] = UM_GEOMETRY_NONE;
    b->area[i] = mesh->area[mesh->surface[surface].facet] * b->vertex[i].o.z / count;
    b->of[b->alive++] = i;
  }
}

static void trace_from(const struct um_optics_paths *paths, size_t surface, uint64_t key,
                       struct um_optics_photons *photons)
{
  struct um_vec3 normal =
      um_geometry_surface_normal(paths->posed->exchange->mesh, paths->posed->pose, surface);
  uint32_t count = EACH * (uint32_t)(paths->posed->exchange->count[surface] * paths->factor);
  if (count == 0 || !is_mirror(paths, surface) ||
      !(um_vec3_dot(normal, paths->instant->sun_body) > 0.0))
    return;
  struct um_optics_beam *beam = &photons->beam[photons->nbeam++];
  *beam = (struct um_optics_beam){(uint32_t)surface, (uint32_t)photons->nroot, count};
  photons->nroot += count;
  struct bundle b = {.paths = paths, .photons = photons, .key = um_core_hash(key, surface)};
  for (b.sample = 0; b.sample < count; b.sample += UM_OPTICS_PATHS) {
    uint32_t left = count - b.sample;
    b.root = beam->first + b.sample;
    begin(&b, surface, left < UM_OPTICS_PATHS ? (int)left : UM_OPTICS_PATHS, count);
    for (int mirror = 0; b.alive > 0; mirror++) step(&b, mirror);
  }
}

void um_optics_photons_begin(struct um_optics_photons *p)
{
  /* counting sort */
  memset(p->first, 0, (p->nsurface + 1) * sizeof *p->first);
  for (size_t i = 0; i < p->count; i++) p->first[p->photon[i].surface + 1]++;
  for (size_t s = 0; s < p->nsurface; s++) p->first[s + 1] += p->first[s];
  for (size_t i = 0; i < p->count; i++) p->order[p->first[p->photon[i].surface]++] = (uint32_t)i;
  for (size_t s = p->nsurface; s > 0; s--) p->first[s] = p->first[s - 1];
  p->first[0] = 0;
  if (p->nband > 0 && p->nroot > 0) memset(p->brought, 0, p->nroot * p->nband * sizeof *p->brought);
}

void um_optics_photons_trace(const struct um_optics_paths *paths, uint64_t seed,
                             struct um_optics_photons *photons)
{
  uint64_t key = um_core_hash(um_core_hash(KEY_PHOTON, seed), paths->instant->time);
  photons->count = photons->nbeam = photons->nroot = 0;
  for (size_t s = 0; paths->instant->sun > 0.0 && s < photons->nsurface; s++)
    trace_from(paths, s, key, photons);
  um_optics_photons_begin(photons);
}

void um_optics_photon_row(const struct um_optics_paths *paths,
                          const struct um_optics_photons *photons,
                          const struct um_optics_photon *photon, double *row)
{
  const struct um_optics_spectra *s = paths->spectra;
  size_t n = s->nbin;
  memcpy(row, paths->work->sunlight, n * sizeof *row);
  for (;;) {
    double weight[4];
    const double *node = um_optics_fresnel_at(s, photon->skin, (double)photon->cos_d, weight);
    for (size_t b = 0; b < n; b++)
      row[b] *= weight[0] * node[b] + weight[1] * node[n + b] + weight[2] * node[2 * n + b] +
                weight[3] * node[3 * n + b];
    if (photon->before == UM_GEOMETRY_NONE) return;
    photon = &photons->photon[photon->before];
  }
}

/* Of each mirror's paths as of independent samples: n/(n - 1) (sum x^2 - (sum x)^2/n). */
double um_optics_photons_variance(const struct um_optics_photons *photons, size_t k)
{
  double variance = 0.0;
  for (size_t i = 0; i < photons->nbeam; i++) {
    const struct um_optics_beam *beam = &photons->beam[i];
    double sum = 0.0, squares = 0.0, n = beam->count;
    for (uint32_t r = beam->first; r < beam->first + beam->count; r++) {
      double x = photons->brought[r * photons->nband + k];
      sum += x;
      squares += x * x;
    }
    variance += n / (n - 1.0) * fmax(0.0, squares - sum * sum / n);
  }
  return variance;
}
