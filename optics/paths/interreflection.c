/* Inter-reflection by paths (Kajiya 1986; next-event estimation, Veach 1997):
 *
 *   L(o) = sum_k T_k (S_k + G_k),  T_k = r_0 r_1 ... r_(k-1),  r = f_r(i, o) cos_i/p(i)
 *
 * from points of a surface that the observer sees. At each further surface a path takes up the
 * sunlight S that goes its way (path_sun.c), and the glow G, what the surface emits and what of the
 * Earth its flat parts reflect. Directions are drawn
 * as vertex.c says. What leaves into space brings nothing, into the Earth what a lobe reflects of
 * it; at the first surface neither, as radiance.c has counted both.
 *
 * Inside a closed body emission telescopes: where no ray leaves, eps B + r L is taken as
 *
 *   eps B + (1 - eps) B + r (L - B),
 *
 * which has the same mean, and is B to the last digit where all have one temperature, whatever r.
 *
 * A path ends where less than LEAST of any wavelength is left, or at its LONGEST. Numbers depend on
 * seed, surface, instant and sample alone. The variance of the mean is that of independent samples;
 * the points are of low discrepancy, so it is an upper estimate. */
#include "optics/paths/interreflection_group.h"

#include <math.h>
#include <string.h>

#include "optics/paths/bundle_impl.h"
#include "optics/paths/exchange_impl.h"

#define LEAST   1e-5 /* [1] */
#define LONGEST 256  /* surfaces of a path */

/* Way on from a vertex; false: none. */
static bool go_on(struct um_optics_bundle *p, int i, int vertex)
{
  double which, u[2];
  if (vertex == 0) {
    which = um_optics_bundle_first(p, p->sample[i], u);
  } else {
    u[0] = um_optics_bundle_number(p, i, vertex, UM_OPTICS_KEY_RAY);
    u[1] = um_optics_bundle_number(p, i, vertex, UM_OPTICS_KEY_RAY + 1);
    which = um_optics_bundle_number(p, i, vertex, UM_OPTICS_KEY_WAY);
  }
  return um_optics_vertex_sample(&p->paths, &p->vertex[i], which, u, &p->turn[i]);
}

/* B of a vertex' surface, into the scratch. */
static const double *black_body(const struct um_optics_bundle *p, int i)
{
  um_optics_spectra_planck(p->paths.spectra, p->paths.scene->temperature[p->vertex[i].at],
                           p->paths.work->planck);
  return p->paths.work->planck;
}

/* What a path's place sends to the observer by its own temperature: the share [nbin] of its black
 * body, NULL: all of it. */
static void keep_glow(const struct um_optics_bundle *p, int i, double sign, const double *share)
{
  struct um_optics_glow *glow = p->paths.glow;
  const double *left = um_optics_bundle_throughput(p, i);
  if (glow == NULL) return;
  double *to = um_optics_glow_of(glow, p->vertex[i].surface), worth = sign * p->worth;
  for (size_t b = 0; b < glow->nbin; b++)
    to[b] += worth * left[b] * (share != NULL ? share[b] : 1.0);
}

static bool telescopes(const struct um_optics_bundle *p, int i)
{
  return !p->paths.instant->sunlight_only &&
         p->paths.posed->exchange->closed[p->vertex[i].surface] != 0;
}

/* (1 - eps) B where a path arrives at a closed place, emissivity and B in the scratch. */
static void add_closed(const struct um_optics_bundle *p, int i, const double *emissivity,
                       const double *planck)
{
  double *sum = um_optics_bundle_gathered(p, i), *left = um_optics_bundle_throughput(p, i);
  keep_glow(p, i, 1.0, NULL);
  keep_glow(p, i, -1.0, emissivity);
  for (size_t b = 0; b < p->paths.spectra->nbin; b++)
    sum[b] += left[b] * (1.0 - emissivity[b]) * planck[b];
}

/* Reflection at the vertex by its turn; the largest of what is left. */
static double reflect(struct um_optics_bundle *p, int i)
{
  struct um_optics_work *work = p->paths.work;
  double *left = um_optics_bundle_throughput(p, i), largest = 0.0;
  size_t n = p->paths.spectra->nbin;
  um_optics_vertex_row(&p->paths, &p->vertex[i], &p->turn[i], UM_OPTICS_WHOLE, work->incoming);
  for (size_t b = 0; b < n; b++) {
    left[b] *= work->incoming[b];
    largest = fmax(largest, left[b]);
  }
  p->mirrors[i] = p->mirrors[i] && p->vertex[i].mirror;
  if (p->mirrors[i]) {
    double *shown = um_optics_bundle_mirrored(p, i);
    um_optics_vertex_row(&p->paths, &p->vertex[i], &p->turn[i], UM_OPTICS_LOBE, work->incoming);
    for (size_t b = 0; b < n; b++) shown[b] *= work->incoming[b];
  }
  if (!telescopes(p, i) || largest < LEAST) return largest; /* it ends: L = B */
  double *sum = um_optics_bundle_gathered(p, i);
  const double *planck = black_body(p, i);
  keep_glow(p, i, -1.0, NULL);
  for (size_t b = 0; b < n; b++) sum[b] -= left[b] * planck[b];
  return largest;
}

/* A path that leaves the satellite. */
static void leave(struct um_optics_bundle *p, int i, int vertex)
{
  struct um_optics_work *work = p->paths.work;
  size_t n = p->paths.spectra->nbin;
  if (telescopes(p, i)) reflect(p, i);
  if (vertex == 0 || !(p->turn[i].lobe > 0.0)) return;
  if (!um_optics_vertex_earth(&p->paths, p->turn[i].direction, work->incoming)) return;
  double *sum = um_optics_bundle_gathered(p, i), *left = um_optics_bundle_throughput(p, i);
  if (telescopes(p, i)) return; /* nothing but a leak between facets */
  um_optics_vertex_row(&p->paths, &p->vertex[i], &p->turn[i], UM_OPTICS_LOBE, work->row);
  for (size_t b = 0; b < n; b++) sum[b] += left[b] * work->row[b] * work->incoming[b];
}

/* Glow of a vertex that a path has come to. */
static void arrive(struct um_optics_bundle *p, int i)
{
  struct um_optics_work *work = p->paths.work;
  double *sum = um_optics_bundle_gathered(p, i), *left = um_optics_bundle_throughput(p, i);
  if (p->paths.instant->sunlight_only) return;
  um_optics_vertex_glow(&p->paths, &p->vertex[i], work->incoming);
  for (size_t b = 0; b < p->paths.spectra->nbin; b++) sum[b] += left[b] * work->incoming[b];
  if (p->paths.glow != NULL)
    keep_glow(p, i, 1.0,
              um_optics_spectra_emissivity(p->paths.spectra, p->vertex[i].skin, p->vertex[i].o.z,
                                           work->emissivity));
  if (telescopes(p, i))
    add_closed(p, i,
               um_optics_spectra_emissivity(p->paths.spectra, p->vertex[i].skin, p->vertex[i].o.z,
                                            work->emissivity),
               work->planck);
}

/* Rays on from all vertices; what meets a surface stays. */
static void step(struct um_optics_bundle *p, int vertex)
{
  const struct um_optics_posed_scene *posed = p->paths.posed;
  const struct um_geometry_mesh *mesh = posed->exchange->mesh;
  struct um_optics_work *work = p->paths.work;
  int went = 0, stays = 0;
  for (int a = 0; a < p->alive; a++) {
    int i = p->of[a];
    if (!go_on(p, i, vertex)) continue;
    work->ray[went] = (struct um_geometry_ray){p->vertex[i].point, p->turn[i].direction, INFINITY,
                                               mesh->surface[p->vertex[i].surface].facet};
    p->of[went++] = i;
  }
  um_geometry_visibility_closest(posed->visibility, work->ray, (size_t)went, p->hit);
  for (int a = 0; a < went; a++) {
    const struct um_geometry_hit *hit = &p->hit[a];
    int i = p->of[a];
    if (hit->facet == UM_GEOMETRY_NONE) {
      leave(p, i, vertex);
      continue;
    }
    if (!(reflect(p, i) >= LEAST) || hit->surface == UM_GEOMETRY_NONE) continue;
    um_optics_vertex_place(&p->paths, hit->surface,
                           um_optics_facet_point(mesh, posed->pose, hit->facet, hit->weight),
                           um_vec3_scale(p->turn[i].direction, -1.0), &p->vertex[i]);
    if (!(p->vertex[i].o.z > 0.0)) continue;
    arrive(p, i);
    p->of[stays++] = i;
  }
  p->alive = stays;
}

static void trace(struct um_optics_bundle *p, size_t surface, double seen)
{
  const struct um_optics_spectra *spectra = p->paths.spectra;
  struct um_optics_work *work = p->paths.work;
  size_t n = spectra->nbin;
  int most = p->paths.scene->interreflection_most;
  memset(work->gathered, 0, (size_t)p->n * n * sizeof *work->gathered);
  for (size_t b = 0; b < (size_t)p->n * n; b++) work->throughput[b] = work->mirrored[b] = 1.0;
  um_optics_bundle_begin(p, surface, seen);
  for (int a = 0; a < p->alive && telescopes(p, p->of[a]); a++) {
    int i = p->of[a];
    const double *planck = black_body(p, i);
    add_closed(p, i,
               um_optics_spectra_emissivity(spectra, p->vertex[i].skin, p->vertex[i].o.z,
                                            work->emissivity),
               planck);
  }
  for (int k = 0; k < (most > 0 ? most : LONGEST) && p->alive > 0; k++) {
    step(p, k);
    um_optics_bundle_add_sun(p, k + 1);
    um_optics_bundle_add_photons(p, k + 1);
  }
}

/* Sums of the paths and of their squares by band. */
static void add_paths(const struct um_optics_bundle *p, double share)
{
  const struct um_optics_spectra *spectra = p->paths.spectra;
  struct um_optics_work *work = p->paths.work;
  for (int i = 0; i < p->n; i++) {
    const double *of = um_optics_bundle_gathered(p, i);
    for (size_t k = 0; k < spectra->nband; k++) {
      double sum = um_optics_band_sum(spectra, k, of);
      for (size_t b = spectra->first[k]; b < spectra->first[k + 1]; b++)
        work->reflected[b] += share * of[b];
      work->band[k] += share * sum;
      work->band_variance[k] += share * sum * sum;
    }
  }
}

bool um_optics_interreflection(const struct um_optics_paths *paths,
                               struct um_optics_photons *photons, size_t surface, double seen)
{
  const struct um_optics_spectra *spectra = paths->spectra;
  const struct um_optics_instant *instant = paths->instant;
  const struct um_optics_posed_scene *posed = paths->posed;
  struct um_optics_work *work = paths->work;
  struct um_optics_bundle p = {.paths = *paths, .photons = photons};
  const struct um_geometry_mesh *mesh = posed->exchange->mesh;
  int nsample = posed->exchange->count[surface] * paths->factor;
  if (nsample == 0) return false;
  p.key = um_optics_path_key(paths, surface);
  p.worth =
      mesh->area[mesh->surface[surface].facet] / nsample *
      um_vec3_dot(um_geometry_surface_normal(mesh, posed->pose, surface), instant->observer_body);
  memset(work->reflected, 0, spectra->nbin * sizeof *work->reflected);
  memset(work->band_variance, 0, spectra->nband * sizeof *work->band_variance);
  memset(work->band, 0, spectra->nband * sizeof *work->band);
  for (uint32_t next = 0; um_optics_bundle_fill(&p, surface, &next, (uint32_t)nsample);) {
    trace(&p, surface, seen);
    add_paths(&p, 1.0 / nsample);
  }
  um_optics_bundle_add_seen_photons(&p, surface, seen);
  /* variance of the mean: (<x^2> - <x>^2)/(N - 1); a single sample is as uncertain as it is large
   */
  if (nsample == 1) return true;
  for (size_t k = 0; k < spectra->nband; k++) {
    double spread = work->band_variance[k] - work->band[k] * work->band[k];
    work->band_variance[k] = fmax(0.0, spread) / (nsample - 1);
  }
  return true;
}
