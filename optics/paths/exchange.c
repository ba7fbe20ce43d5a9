/* What of a pose paths of light go by: from which surfaces none leaves, and how many each gets. */
#include <math.h>

#include "base/core/sampling.h"
#include "optics/paths/exchange_impl.h"
#include "optics/paths/paths_impl.h"
#include "optics/paths/sampling_group.h"

#define RAYS           64   /* that all meet something: a surface inside a closed body */
#define TOGETHER       8    /* of them; most surfaces are decided by the first */
#define LEAST          2    /* paths of a surface */
#define TOGETHER_LEAST 1024 /* of all: few paths do not know their own error */
#define MOST           16.0 /* of the mean number */
#define KEY_CLOSE      0x636c6f7365

struct um_geometry_ray um_optics_path_begin(const struct um_geometry_mesh *mesh,
                                            const struct um_geometry_pose *pose, size_t surface,
                                            const double place[2])
{
  uint32_t facet = mesh->surface[surface].facet;
  double weight[3];
  um_core_sample_triangle(place, weight);
  return (struct um_geometry_ray){.origin = um_optics_facet_point(mesh, pose, facet, weight),
                                  .limit = INFINITY,
                                  .from_facet = facet};
}

struct um_vec3 um_optics_facet_point(const struct um_geometry_mesh *mesh,
                                     const struct um_geometry_pose *pose, uint32_t facet,
                                     const double weight[3])
{
  const uint32_t *corner = mesh->corner[facet];
  struct um_vec3 p = um_vec3_scale(pose->vertex[corner[0]], weight[0]);
  p = um_vec3_axpy(p, weight[1], pose->vertex[corner[1]]);
  return um_vec3_axpy(p, weight[2], pose->vertex[corner[2]]);
}

/* Does no ray leave? hits: of the first, that meet something. */
static bool is_closed(const struct um_geometry_mesh *mesh,
                      const struct um_optics_posed_scene *posed, size_t surface, int *hits)
{
  struct um_geometry_ray ray[TOGETHER];
  struct um_geometry_hit hit[TOGETHER];
  struct um_vec3 normal = um_geometry_surface_normal(mesh, posed->pose, surface);
  for (uint64_t first = 0; first < RAYS; first += TOGETHER) {
    for (uint64_t k = 0; k < TOGETHER; k++) {
      double u[4];
      um_optics_sample_4d(um_core_hash(KEY_CLOSE, surface), first + k, u);
      ray[k] = um_optics_path_begin(mesh, posed->pose, surface, u);
      ray[k].direction = um_core_sample_cosine(u + 2, normal);
    }
    um_geometry_visibility_closest(posed->visibility, ray, TOGETHER, hit);
    int met = 0;
    for (int k = 0; k < TOGETHER; k++) met += hit[k].facet != UM_GEOMETRY_NONE;
    if (first == 0) *hits = met;
    if (met < TOGETHER) return false;
  }
  return true;
}

/* Paths by area and by what stands before a surface, nsample in the mean or more where few surfaces
 * would have too few together, two at least each: the
 * standard error of a sum is least where each part has points by its own spread, which goes as
 * A sqrt(h) of the share h of a surface's sky that is taken. */
static void share_out(const struct um_geometry_mesh *mesh, int nsample, int *count)
{
  double sum = 0.0, n = 0.0;
  for (size_t s = 0; s < mesh->nsurface; s++) {
    if (count[s] == 0) continue;
    sum += mesh->area[mesh->surface[s].facet] * sqrt((double)count[s]);
    n += 1.0;
  }
  double mean = fmax(nsample, ceil(TOGETHER_LEAST / fmax(n, 1.0)));
  for (size_t s = 0; s < mesh->nsurface; s++) {
    if (count[s] == 0) continue;
    double share = mesh->area[mesh->surface[s].facet] * sqrt((double)count[s]) / sum;
    count[s] = (int)fmin(fmax(nearbyint(mean * n * share), LEAST), mean * MOST);
  }
}

enum um_status um_optics_exchange_create(struct um_context *context,
                                         const struct um_geometry_mesh *mesh,
                                         const struct um_optics_posed_scene *posed, int nsample,
                                         struct um_optics_exchange **out)
{
  enum um_status status;
  struct um_optics_exchange *e = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *e, &e));
  e->mesh = mesh;
  UM_CHECK(um_core_allocate(context, mesh->nsurface, sizeof *e->closed, &e->closed));
  UM_CHECK(um_core_allocate(context, mesh->nsurface, sizeof *e->count, &e->count));
#pragma omp parallel for schedule(dynamic, 8) num_threads(um_core_context_threads(context))
  for (size_t s = 0; s < mesh->nsurface; s++)
    if (!um_geometry_visibility_is_open(posed->visibility, s)) {
      e->closed[s] = is_closed(mesh, posed, s, &e->count[s]);
      e->count[s]++; /* what the rays missed is there, too */
    }
  share_out(mesh, nsample, e->count);
  *out = e;
  e = NULL;
done:
  um_optics_exchange_destroy(context, &e);
  return status;
}

void um_optics_exchange_destroy(struct um_context *context, struct um_optics_exchange **exchange)
{
  if (exchange == NULL || *exchange == NULL) return;
  UM_FREE(context, (*exchange)->closed, (*exchange)->count, *exchange);
  *exchange = NULL;
}
