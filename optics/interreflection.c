/* Inter-reflection, one bounce:
 *
 *   L_s(o) = rho_s(lambda) <L_h(lambda)>
 *
 * the mean over points of surface s and cosine-weighted directions of the radiance that leaves the
 * surface h met there (0 where none is). h sends Lambert-reflected direct sunlight (shadow rays to
 * points of the disc), earthshine, reflected Earth radiation and its own emission; s reflects it
 * diffusely with rho_d below 2.5 um and with 1 - eps(cos_o) above. Lobes of both surfaces and
 * further bounces are left out. The variance of the mean is that of independent samples; the points
 * are of low discrepancy, so it is an upper estimate. */
#include "optics/interreflection_impl.h"

#include <math.h>
#include <string.h>

#include "core/constants.h"
#include "optics/sampling_impl.h"

#define CHUNK        256    /* surfaces traced between two growths of the list */
#define MEMORY_MOST  8e9    /* of the rays that met a surface [bytes] */
#define THERMAL_FROM 2.5e-6 /* [m] */

/* Keys that keep the point sequences of different uses apart. */
enum { KEY_RAY = 0x726179, KEY_DISC = 0x64697363 };

struct bounce {
  uint32_t sample;      /* which point of the first surface */
  uint32_t surface;     /* the one that is met */
  double cosine;        /* there, between its normal and the way back [1] */
  struct um_vec3 point; /* [m] */
};

struct um_optics_exchange {
  const struct um_geometry_mesh *mesh;
  int nsample;
  size_t *first;         /* [nsurface + 1] */
  struct bounce *bounce; /* [first[nsurface]] */
};

static struct um_vec3 facet_point(const struct um_geometry_mesh *mesh,
                                  const struct um_geometry_pose *pose, uint32_t facet,
                                  const double weight[3])
{
  const uint32_t *corner = mesh->corner[facet];
  struct um_vec3 p = um_vec3_scale(pose->vertex[corner[0]], weight[0]);
  p = um_vec3_axpy(p, weight[1], pose->vertex[corner[1]]);
  return um_vec3_axpy(p, weight[2], pose->vertex[corner[2]]);
}

/* Origin and direction of a sample of a surface. */
static struct um_geometry_ray sample_ray(const struct um_geometry_mesh *mesh,
                                         const struct um_geometry_pose *pose, size_t surface,
                                         uint32_t sample)
{
  double u[4], weight[3];
  uint32_t facet = mesh->surface[surface].facet;
  um_optics_sample_4d(um_core_hash(KEY_RAY, surface), sample, u);
  um_core_sample_triangle(u, weight);
  struct um_vec3 normal = um_geometry_surface_normal(mesh, pose, surface);
  return (struct um_geometry_ray){facet_point(mesh, pose, facet, weight),
                                  um_core_sample_cosine(u + 2, normal), INFINITY, facet};
}

/* Rays of one surface; bounce[nsample], returns how many met a surface. */
static size_t trace_surface(const struct um_geometry_mesh *mesh, const struct um_optics_set *set,
                            size_t surface, int nsample, struct um_geometry_ray *ray,
                            struct um_geometry_hit *hit, struct bounce *bounce)
{
  if (um_geometry_visibility_is_open(set->visibility, surface)) return 0;
  for (int i = 0; i < nsample; i++) ray[i] = sample_ray(mesh, set->pose, surface, (uint32_t)i);
  um_geometry_visibility_closest(set->visibility, ray, (size_t)nsample, hit);
  size_t count = 0;
  for (int i = 0; i < nsample; i++) {
    if (hit[i].facet == UM_GEOMETRY_NONE || hit[i].surface == UM_GEOMETRY_NONE) continue;
    struct um_vec3 other = um_geometry_surface_normal(mesh, set->pose, hit[i].surface);
    double cosine = -um_vec3_dot(ray[i].direction, other);
    if (!(cosine > 0.0)) continue;
    bounce[count++] = (struct bounce){(uint32_t)i, hit[i].surface, cosine,
                                      facet_point(mesh, set->pose, hit[i].facet, hit[i].weight)};
  }
  return count;
}

/* Scratch of a chunk of surfaces. */
struct chunk {
  struct um_geometry_ray *ray;
  struct um_geometry_hit *hit;
  struct bounce *bounce; /* all [CHUNK][nsample] */
  size_t count[CHUNK];
};

static enum um_status exchange_trace(struct um_context *context, const struct um_optics_set *set,
                                     struct um_optics_exchange *e, struct chunk *chunk)
{
  size_t nsurface = e->mesh->nsurface, nsample = (size_t)e->nsample, capacity = 0, used = 0;
  for (size_t from = 0; from < nsurface; from += CHUNK) {
    size_t n = nsurface - from < CHUNK ? nsurface - from : CHUNK;
#pragma omp parallel for schedule(dynamic, 8) num_threads(um_core_context_threads(context))
    for (size_t i = 0; i < n; i++)
      chunk->count[i] = trace_surface(e->mesh, set, from + i, e->nsample, chunk->ray + i * nsample,
                                      chunk->hit + i * nsample, chunk->bounce + i * nsample);
    UM_TRY(um_core_stop_check(context, "light between surfaces was traced"));
    for (size_t i = 0; i < n; i++) {
      size_t count = chunk->count[i];
      if (used + count > capacity) {
        capacity = 2 * (used + count);
        if ((double)used * (double)sizeof *e->bounce > MEMORY_MOST)
          return um_core_fail(context, UM_ERR_INPUT,
                              "light between surfaces: %d rays per point of %zu surfaces take more "
                              "than %g GB; accepted: fewer optics.interreflection_samples, or "
                              "coarser facets",
                              e->nsample, nsurface, MEMORY_MOST * 1e-9);
        UM_TRY(um_core_reallocate(context, capacity, sizeof *e->bounce, &e->bounce));
      }
      if (count > 0) /* nothing to copy, and perhaps nothing allocated */
        memcpy(e->bounce + used, chunk->bounce + i * nsample, count * sizeof *e->bounce);
      used += count;
      e->first[from + i + 1] = used;
    }
  }
  return UM_OK;
}

enum um_status um_optics_exchange_create(struct um_context *context,
                                         const struct um_geometry_mesh *mesh,
                                         const struct um_optics_set *set, int nsample,
                                         struct um_optics_exchange **out)
{
  enum um_status status = UM_OK;
  struct um_optics_exchange *e = NULL;
  struct chunk chunk = {0};
  size_t n = (size_t)nsample;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *e, &e));
  e->mesh = mesh;
  e->nsample = nsample;
  UM_CHECK(um_core_allocate(context, mesh->nsurface + 1, sizeof *e->first, &e->first));
  UM_CHECK(um_core_allocate(context, CHUNK * n, sizeof *chunk.ray, &chunk.ray));
  UM_CHECK(um_core_allocate(context, CHUNK * n, sizeof *chunk.hit, &chunk.hit));
  UM_CHECK(um_core_allocate(context, CHUNK * n, sizeof *chunk.bounce, &chunk.bounce));
  UM_CHECK(exchange_trace(context, set, e, &chunk));
  *out = e;
  e = NULL;
done:
  um_core_free(context, chunk.ray);
  um_core_free(context, chunk.hit);
  um_core_free(context, chunk.bounce);
  um_optics_exchange_destroy(context, &e);
  return status;
}

void um_optics_exchange_destroy(struct um_context *context, struct um_optics_exchange **exchange)
{
  if (exchange == NULL || *exchange == NULL) return;
  um_core_free(context, (*exchange)->first);
  um_core_free(context, (*exchange)->bounce);
  um_core_free(context, *exchange);
  *exchange = NULL;
}

bool um_optics_exchange_has(const struct um_optics_exchange *exchange, size_t surface)
{
  return exchange != NULL && exchange->first[surface + 1] > exchange->first[surface];
}

/* A direction into the Sun's disc, keyed by surface and sample; hashed, independent of the ray. */
static struct um_vec3 disc_direction(const struct um_optics_instant *instant, size_t surface,
                                     uint32_t sample)
{
  double u[2], xy[2];
  struct um_vec3 t, b;
  uint64_t key = um_core_hash(um_core_hash(KEY_DISC, surface), sample);
  u[0] = um_core_hash_uniform(um_core_hash(key, 1));
  u[1] = um_core_hash_uniform(um_core_hash(key, 2));
  um_core_sample_disc(u, xy);
  um_core_vec3_frame(instant->sun_body, &t, &b);
  double size = tan(instant->sun_radius);
  struct um_vec3 d = um_vec3_axpy(instant->sun_body, size * xy[0], t);
  return um_vec3_unit(um_vec3_axpy(d, size * xy[1], b));
}

/* hidden[i]: the observer does not see the first point; occluded[i]: the Sun does not reach the
 * second. */
static void trace_ends(const struct um_optics_instant *instant, const struct um_optics_set *set,
                       size_t surface, double seen, const struct bounce *bounce, size_t n,
                       struct um_optics_work *work)
{
  const struct um_geometry_mesh *mesh = set->exchange->mesh;
  memset(work->hidden, 0, n);
  memset(work->occluded, 1, n);
  if (seen < 1.0) {
    for (size_t i = 0; i < n; i++) {
      work->ray[i] = sample_ray(mesh, set->pose, surface, bounce[i].sample);
      work->ray[i].direction = instant->observer_body;
    }
    um_geometry_visibility_occluded(set->visibility, work->ray, n, work->hidden);
  }
  if (!(instant->sun > 0.0)) return;
  for (size_t i = 0; i < n; i++)
    work->ray[i] = (struct um_geometry_ray){bounce[i].point,
                                            disc_direction(instant, surface, bounce[i].sample),
                                            INFINITY, mesh->surface[bounce[i].surface].facet};
  um_geometry_visibility_occluded(set->visibility, work->ray, n, work->occluded);
}

/* Radiance that leaves the met surface toward the first: work->incoming. */
static void bounce_radiance(const struct um_optics_spectra *spectra,
                            const struct um_optics_scene *scene,
                            const struct um_optics_instant *instant,
                            const struct um_optics_set *set, size_t time,
                            const struct bounce *bounce, bool sunlit, struct um_optics_work *work)
{
  const struct um_geometry_mesh *mesh = set->exchange->mesh;
  size_t n = spectra->nbin, at = time * mesh->nsurface + bounce->surface;
  size_t skin = um_optics_skin(spectra, mesh, bounce->surface);
  struct um_vec3 normal = um_geometry_surface_normal(mesh, set->pose, bounce->surface);
  double cos_i = um_vec3_dot(normal, instant->sun_body);
  double sun = sunlit && cos_i > 0.0 ? cos_i / UM_PI : 0.0;
  double albedo = instant->earthshine * (double)scene->albedo[at] / UM_PI;
  double earth = instant->earth_reflection * (double)scene->view_factor[at];
  um_optics_spectra_planck(spectra, scene->temperature[at], work->planck);
  const double *emissivity =
      um_optics_spectra_emissivity(spectra, skin, bounce->cosine, work->emissivity);
  const double *diffuse = spectra->diffuse + skin * n;
  const double *earthlight = spectra->earth;
  if (instant->earth_varies) {
    um_optics_spectra_planck(spectra, (double)scene->brightness[at], work->earth);
    earthlight = work->earth;
  }
  for (size_t b = 0; b < n; b++)
    work->incoming[b] = diffuse[b] * (sun * work->sunlight[b] + albedo * spectra->share[b]) +
                        (1.0 - emissivity[b]) * earth * earthlight[b] +
                        emissivity[b] * work->planck[b];
}

void um_optics_interreflection(const struct um_optics_spectra *spectra,
                               const struct um_optics_scene *scene,
                               const struct um_optics_instant *instant,
                               const struct um_optics_set *set, size_t time, size_t surface,
                               double seen, struct um_optics_work *work)
{
  const struct um_optics_exchange *e = set->exchange;
  const struct bounce *bounce = e->bounce + e->first[surface];
  size_t n = e->first[surface + 1] - e->first[surface], nbin = spectra->nbin;
  size_t skin = um_optics_skin(spectra, e->mesh, surface);
  double cos_o =
      um_vec3_dot(um_geometry_surface_normal(e->mesh, set->pose, surface), instant->observer_body);
  double *reflectance = work->spectral; /* [nbin], free between two spectra */
  const double *emissivity = um_optics_spectra_emissivity(spectra, skin, cos_o, work->emissivity);
  for (size_t b = 0; b < nbin; b++)
    reflectance[b] = spectra->wavelength[b] > THERMAL_FROM ? 1.0 - emissivity[b]
                                                           : spectra->diffuse[skin * nbin + b];
  memset(work->reflected, 0, nbin * sizeof *work->reflected);
  memset(work->band_variance, 0, spectra->nband * sizeof *work->band_variance);
  memset(work->band, 0, spectra->nband * sizeof *work->band);
  trace_ends(instant, set, surface, seen, bounce, n, work);
  double share = 1.0 / e->nsample;
  for (size_t i = 0; i < n; i++) {
    if (work->hidden[i]) continue;
    bounce_radiance(spectra, scene, instant, set, time, &bounce[i], !work->occluded[i], work);
    for (size_t k = 0; k < spectra->nband; k++) {
      double sum = 0.0;
      for (size_t b = spectra->first[k]; b < spectra->first[k + 1]; b++) {
        double radiance = reflectance[b] * work->incoming[b];
        work->reflected[b] += share * radiance;
        sum += radiance * spectra->transmission[b] * spectra->width[b];
      }
      work->band[k] += share * sum;
      work->band_variance[k] += share * sum * sum;
    }
  }
  /* variance of the mean: (<x^2> - <x>^2) / (N - 1); a single sample is as uncertain as it is large
   */
  if (e->nsample == 1) return;
  for (size_t k = 0; k < spectra->nband; k++) {
    double spread = work->band_variance[k] - work->band[k] * work->band[k];
    work->band_variance[k] = fmax(0.0, spread) / (e->nsample - 1);
  }
}
