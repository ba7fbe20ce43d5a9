/* Paths by way of mirrors, by rays.
 *
 * A ray of patch p that ends on a mirror goes on; every patch that it comes upon on the way is an
 * end of a path with the mirrors before it. As with view factors a_pq, areas of rays from p, and
 * a_qp estimate the same s_pq, and both together, by densities d of rays,
 *
 *   s_pq = (d_p a_pq + d_q a_qp) / (d_p + d_q).
 */
#include "geometry/mirror_paths.h"

#include <string.h>

#include "base/core/sort.h"
#include "geometry/cube.h"
#include "geometry/view_factor_rays_impl.h"

#define BATCH  ((size_t)1 << 16) /* rays on their way at a time */
#define BUNDLE 256               /* rays traced at a time */
#define FEWEST 4                 /* as view factors have it */

/* End of a ray behind mirrors. */
struct end {
  uint32_t from, to, sets;
  bool sky, back; /* back: of a ray from `to` to `from` */
  double area;    /* of the ray [m^2], of a patch's end times the density of rays [1] */
};

struct trace {
  struct um_context *context;
  const struct um_geometry_mesh *mesh;
  const struct um_geometry_pose *pose;
  const struct um_geometry_visibility *visibility;
  const struct um_geometry_patches *patches;
  const struct um_geometry_mirrors *mirrors;
  struct um_geometry_ray_counts counts;
  double *density, *each; /* [npatch] rays per area, [nmember] area of a ray */
  struct um_geometry_ray *ray;
  struct um_geometry_hit *hit;
  struct um_geometry_mirrored_path *path; /* tag: member */
  struct end *end;
  size_t nend, room;
  struct um_geometry_mirror_paths *out;
};

/* Does patch p see a mirror? */
static bool sees_mirror(const struct trace *t, const struct um_geometry_view_factors *f, size_t p)
{
  for (size_t e = f->begin[p]; e < f->begin[p + 1]; e++)
    if (f->area[e] > 0.0 &&
        um_geometry_mirrors_patch(t->mirrors, t->patches, f->other[e]) != UM_GEOMETRY_NO_MIRROR)
      return true;
  return false;
}

static void closest(const struct trace *t, size_t n)
{
  long bundles = (long)((n + BUNDLE - 1) / BUNDLE);
#pragma omp parallel for schedule(dynamic, 4)                                                      \
    num_threads(um_core_context_threads(t->context)) if (bundles > 8)
  for (long b = 0; b < bundles; b++) {
    size_t from = (size_t)b * BUNDLE, many = n - from < BUNDLE ? n - from : BUNDLE;
    if (!um_core_stopped(t->context))
      um_geometry_visibility_closest(t->visibility, t->ray + from, many, t->hit + from);
  }
}

/* Space last; by patch, end and mirrors; there before back. */
static int compare_ends(const void *pa, const void *pb)
{
  const struct end *a = pa, *b = pb;
  if (a->sky != b->sky) return a->sky - b->sky;
  if (a->from != b->from) return a->from < b->from ? -1 : 1;
  if (a->to != b->to) return a->to < b->to ? -1 : 1;
  if (a->sets != b->sets) return a->sets < b->sets ? -1 : 1;
  if (a->back != b->back) return a->back - b->back;
  return (a->area > b->area) - (a->area < b->area);
}

static bool same_path(const struct end *a, const struct end *b)
{
  return a->sky == b->sky && a->from == b->from && a->to == b->to && a->sets == b->sets;
}

/* Ends sorted, those of one path and direction added up. */
static enum um_status ends_join(struct trace *t)
{
  size_t n = 0;
  UM_TRY(um_core_sort(t->context, t->end, t->nend, sizeof *t->end, compare_ends));
  for (size_t k = 0; k < t->nend; k++) {
    if (n > 0 && same_path(&t->end[n - 1], &t->end[k]) && t->end[n - 1].back == t->end[k].back)
      t->end[n - 1].area += t->end[k].area;
    else
      t->end[n++] = t->end[k];
  }
  t->nend = n;
  return UM_OK;
}

static enum um_status end_put(struct trace *t, struct end end)
{
  if (t->nend == t->room) {
    UM_TRY(ends_join(t));
    size_t room = 2 * t->room + 65536;
    if (2 * t->nend > t->room || t->room == 0) {
      UM_TRY(um_core_reallocate(t->context, room, sizeof *t->end, &t->end));
      t->room = room;
    }
  }
  t->end[t->nend++] = end;
  return UM_OK;
}

/* Ends of the rays on their way. */
static enum um_status ends_take(struct trace *t, size_t n)
{
  for (size_t k = 0; k < n; k++) {
    size_t member = t->path[k].tag;
    uint32_t from = t->patches->patch[t->patches->surface[member]], sets;
    bool sky = t->hit[k].facet == UM_GEOMETRY_NONE;
    uint32_t surface = sky ? UM_GEOMETRY_NONE : t->hit[k].surface;
    if (!sky && surface == UM_GEOMETRY_NONE) continue; /* slipped into a closed part */
    uint32_t to = sky ? (uint32_t)um_geometry_cube_cell(UM_GEOMETRY_SKY_SIDE, t->ray[k].direction)
                      : t->patches->patch[surface];
    if (to == UM_GEOMETRY_NONE) continue; /* grazed within the rounding of a plane */
    UM_TRY(um_geometry_mirror_sets_find(t->context, &t->out->sets, &t->path[k].met, &sets));
    double area = t->each[member];
    if (sky) {
      UM_TRY(end_put(t, (struct end){from, to, sets, true, false, area}));
      continue;
    }
    if (t->path[k].met.n == UM_GEOMETRY_MIRRORS_DEEPEST &&
        t->mirrors->of[surface] != UM_GEOMETRY_NO_MIRROR)
      t->out->deepest++;
    area *= t->density[from];
    UM_TRY(end_put(t, (struct end){from, to, sets, false, false, area}));
    UM_TRY(end_put(t, (struct end){to, from, sets, false, true, area}));
  }
  return UM_OK;
}

/* Rays of a batch, from mirror to mirror until none is left. */
static enum um_status batch_run(struct trace *t, size_t n)
{
  closest(t, n);
  n = um_geometry_mirrored_turn(t->mesh, t->pose, t->mirrors, t->ray, t->path, t->hit, n);
  t->out->rays += n;
  while (n > 0) {
    closest(t, n);
    UM_TRY(um_core_stop_check(t->context, "paths by way of mirrors were traced"));
    UM_TRY(ends_take(t, n));
    n = um_geometry_mirrored_turn(t->mesh, t->pose, t->mirrors, t->ray, t->path, t->hit, n);
  }
  return um_core_stop_check(t->context, "paths by way of mirrors were traced");
}

static enum um_status trace_all(struct trace *t, const struct um_geometry_view_factors *factors)
{
  size_t n = 0;
  for (size_t p = 0; p < t->patches->npatch; p++) {
    if (!sees_mirror(t, factors, p)) continue;
    for (size_t i = t->patches->begin[p]; i < t->patches->begin[p + 1]; i++)
      for (size_t begin = 0; begin < t->counts.count[i];) {
        size_t many = t->counts.count[i] - begin;
        if (many > BATCH - n) many = BATCH - n;
        um_geometry_view_factor_rays(t->mesh, t->pose, t->patches, &t->counts, i, begin, many,
                                     t->ray + n);
        for (size_t k = 0; k < many; k++)
          t->path[n + k] = (struct um_geometry_mirrored_path){.tag = (uint32_t)i};
        begin += many;
        n += many;
        if (n < BATCH) continue;
        UM_TRY(batch_run(t, n));
        n = 0;
      }
  }
  return batch_run(t, n);
}

/* Sorted ends [from, end) of one patch, end and mirrors as a path. */
static double area_of(const struct trace *t, size_t from, size_t end)
{
  const struct end *e = &t->end[from];
  double there = 0.0, back = 0.0;
  for (size_t k = from; k < end; k++) *(t->end[k].back ? &back : &there) += t->end[k].area;
  if (e->sky) return there;
  /* the smaller index first, so that both rows get the same number */
  double sum = e->from <= e->to ? there + back : back + there;
  return sum / (e->from <= e->to ? t->density[e->from] + t->density[e->to]
                                 : t->density[e->to] + t->density[e->from]);
}

static enum um_status gather(struct trace *t)
{
  struct um_geometry_mirror_paths *out = t->out;
  size_t n[2] = {0, 0}, npatch = out->npatch;
  UM_TRY(ends_join(t));
  UM_TRY(um_core_allocate(t->context, npatch + 1, sizeof *out->begin, &out->begin));
  UM_TRY(um_core_allocate(t->context, npatch + 1, sizeof *out->sky_begin, &out->sky_begin));
  for (int pass = 0; pass < 2; pass++) {
    n[0] = n[1] = 0;
    for (size_t k = 0, end = 0; k < t->nend; k = end) {
      const struct end *e = &t->end[k];
      for (end = k + 1; end < t->nend && same_path(e, &t->end[end]);) end++;
      size_t at = n[e->sky]++;
      (e->sky ? out->sky_begin : out->begin)[e->from + 1] = n[e->sky];
      if (pass == 1)
        (e->sky ? out->sky : out->path)[at] =
            (struct um_geometry_mirror_path){e->to, e->sets, area_of(t, k, end)};
    }
    if (pass == 1) break;
    UM_TRY(um_core_allocate(t->context, n[0], sizeof *out->path, &out->path));
    UM_TRY(um_core_allocate(t->context, n[1], sizeof *out->sky, &out->sky));
  }
  for (size_t p = 0; p < npatch; p++) { /* rows without an entry */
    if (out->begin[p + 1] < out->begin[p]) out->begin[p + 1] = out->begin[p];
    if (out->sky_begin[p + 1] < out->sky_begin[p]) out->sky_begin[p + 1] = out->sky_begin[p];
  }
  return UM_OK;
}

static enum um_status prepare(struct trace *t, size_t rays)
{
  const struct um_geometry_patches *patches = t->patches;
  UM_TRY(um_geometry_ray_counts_create(t->context, t->mesh, patches, rays, FEWEST, &t->counts));
  UM_TRY(um_core_allocate(t->context, patches->npatch, sizeof *t->density, &t->density));
  UM_TRY(um_core_allocate(t->context, patches->begin[patches->npatch], sizeof *t->each, &t->each));
  UM_TRY(um_core_allocate(t->context, BATCH, sizeof *t->ray, &t->ray));
  UM_TRY(um_core_allocate(t->context, BATCH, sizeof *t->hit, &t->hit));
  UM_TRY(um_core_allocate(t->context, BATCH, sizeof *t->path, &t->path));
  for (size_t p = 0; p < patches->npatch; p++)
    for (size_t i = patches->begin[p]; i < patches->begin[p + 1]; i++) {
      t->density[p] += (double)t->counts.count[i] / patches->area[p];
      t->each[i] =
          t->mesh->area[t->mesh->surface[patches->surface[i]].facet] / (double)t->counts.count[i];
    }
  return UM_OK;
}

enum um_status um_geometry_mirror_paths_create(
    struct um_context *context, const struct um_geometry_mesh *mesh,
    const struct um_geometry_pose *pose, const struct um_geometry_visibility *visibility,
    const struct um_geometry_patches *patches, const struct um_geometry_view_factors *factors,
    const struct um_geometry_mirrors *mirrors,
    const struct um_geometry_view_factor_options *options, struct um_geometry_mirror_paths **out)
{
  enum um_status status;
  struct um_geometry_mirror_paths *paths = NULL;
  struct trace t = {.context = context,
                    .mesh = mesh,
                    .pose = pose,
                    .visibility = visibility,
                    .patches = patches,
                    .mirrors = mirrors};
  bool any = false;
  *out = NULL;
  for (size_t p = 0; p < patches->npatch && !any; p++) any = sees_mirror(&t, factors, p);
  if (!any) return UM_OK;
  UM_CHECK(um_core_allocate(context, 1, sizeof *paths, &paths));
  paths->npatch = patches->npatch;
  t.out = paths;
  UM_CHECK(prepare(&t, options->rays));
  UM_CHECK(trace_all(&t, factors));
  UM_CHECK(gather(&t));
  *out = paths;
  paths = NULL;
done:
  um_geometry_ray_counts_clear(context, &t.counts);
  UM_FREE(context, t.density, t.each, t.ray, t.hit, t.path, t.end);
  um_geometry_mirror_paths_destroy(context, &paths);
  return status;
}

void um_geometry_mirror_paths_destroy(struct um_context *context,
                                      struct um_geometry_mirror_paths **paths)
{
  if (paths == NULL || *paths == NULL) return;
  um_geometry_mirror_sets_clear(context, &(*paths)->sets);
  UM_FREE(context, (*paths)->begin, (*paths)->path, (*paths)->sky_begin, (*paths)->sky, *paths);
  *paths = NULL;
}
