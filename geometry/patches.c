/* Gathering of surfaces: sides of groups, halved at the middle of their members along the longest
 * edge of the box around them, where extent and exchange are large. What a patch sends and receives
 * is spread evenly over it, so that its error grows with both. */
#include "geometry/patches.h"

#include <string.h>

#include "base/core/sort.h"

#define LEAST 1e-3 /* share seen that all have at least: few rays see little */

/* A surface on its way into a patch. */
struct member {
  struct um_vec3 centre; /* of its facet [m] */
  double along;          /* centre along the edge that is halved [m] */
  double exchange;       /* area times share seen [m^2] */
  uint32_t surface, part, group;
  uint8_t back;
};

/* A run of members that may be halved. */
struct run {
  size_t begin, end;
  double edge;  /* longest of the box around the centres [m]; 0: cannot be halved */
  double worth; /* edge times exchange of all [m^3] */
  int axis;     /* of that edge */
};

static int compare_place(const void *pa, const void *pb)
{
  const struct member *a = pa, *b = pb;
  if (a->part != b->part) return a->part < b->part ? -1 : 1;
  if (a->group != b->group) return a->group < b->group ? -1 : 1;
  if (a->back != b->back) return a->back < b->back ? -1 : 1;
  return (a->surface > b->surface) - (a->surface < b->surface);
}

static int compare_along(const void *pa, const void *pb)
{
  const struct member *a = pa, *b = pb;
  if (a->along != b->along) return a->along < b->along ? -1 : 1;
  return (a->surface > b->surface) - (a->surface < b->surface);
}

static int compare_runs(const void *pa, const void *pb)
{
  const struct run *a = pa, *b = pb;
  return (a->begin > b->begin) - (a->begin < b->begin);
}

static double coordinate(struct um_vec3 v, int axis)
{
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

static struct run run_of(const struct member *member, size_t begin, size_t end)
{
  struct run run = {begin, end, 0.0, 0.0, 0};
  for (int axis = 0; axis < 3; axis++) {
    double low = INFINITY, high = -INFINITY;
    for (size_t i = begin; i < end; i++) {
      low = fmin(low, coordinate(member[i].centre, axis));
      high = fmax(high, coordinate(member[i].centre, axis));
    }
    if (high - low > run.edge) {
      run.edge = high - low;
      run.axis = axis;
    }
  }
  for (size_t i = begin; i < end; i++) run.worth += run.edge * member[i].exchange;
  return run;
}

static void fill_members(const struct um_geometry_mesh *mesh, const struct um_geometry_pose *pose,
                         const double *seen, struct member *member)
{
  size_t n = 0;
  for (size_t s = 0; s < mesh->nsurface; s++) {
    if (!(seen[s] >= 0.0)) continue;
    const struct um_geometry_surface *surface = &mesh->surface[s];
    const uint32_t *c = mesh->corner[surface->facet];
    struct um_vec3 sum =
        um_vec3_add(um_vec3_add(pose->vertex[c[0]], pose->vertex[c[1]]), pose->vertex[c[2]]);
    member[n++] = (struct member){.centre = um_vec3_scale(sum, 1.0 / 3.0),
                                  .surface = (uint32_t)s,
                                  .exchange = mesh->area[surface->facet] * fmax(seen[s], LEAST),
                                  .part = surface->part,
                                  .group = surface->group,
                                  .back = surface->back};
  }
}

/* Halve run `at`; the upper half is the new last one. */
static enum um_status halve(struct um_context *context, struct member *member, struct run *run,
                            size_t at, size_t *nrun)
{
  struct run whole = run[at];
  size_t n = whole.end - whole.begin, middle = whole.begin + n / 2;
  for (size_t i = whole.begin; i < whole.end; i++)
    member[i].along = coordinate(member[i].centre, whole.axis);
  UM_TRY(um_core_sort(context, member + whole.begin, n, sizeof *member, compare_along));
  run[at] = run_of(member, whole.begin, middle);
  run[(*nrun)++] = run_of(member, middle, whole.end);
  return UM_OK;
}

static enum um_status split(struct um_context *context, struct member *member, size_t nmember,
                            size_t limit, struct run *run, size_t *nrun)
{
  UM_TRY(um_core_sort(context, member, nmember, sizeof *member, compare_place));
  for (size_t begin = 0, end = 0; begin < nmember; begin = end) {
    for (end = begin + 1; end < nmember && member[end].part == member[begin].part &&
                          member[end].group == member[begin].group &&
                          member[end].back == member[begin].back;)
      end++;
    run[(*nrun)++] = run_of(member, begin, end);
  }
  while (*nrun < limit && *nrun < nmember) {
    size_t best = 0;
    for (size_t k = 1; k < *nrun; k++)
      if (run[k].worth > run[best].worth) best = k;
    if (!(run[best].worth > 0.0)) break;
    UM_TRY(halve(context, member, run, best, nrun));
    UM_TRY(um_core_stop_check(context, "surfaces were gathered"));
  }
  return um_core_sort(context, run, *nrun, sizeof *run, compare_runs);
}

static enum um_status fill_patches(struct um_context *context, const struct um_geometry_mesh *mesh,
                                   const struct member *member, size_t nmember,
                                   const struct run *run, struct um_geometry_patches *patches)
{
  size_t n = patches->npatch;
  UM_TRY(um_core_allocate(context, nmember, sizeof *patches->surface, &patches->surface));
  UM_TRY(um_core_allocate(context, n + 1, sizeof *patches->begin, &patches->begin));
  UM_TRY(um_core_allocate(context, n, sizeof *patches->area, &patches->area));
  for (size_t p = 0, at = 0; p < n; p++) {
    for (size_t i = run[p].begin; i < run[p].end; i++) {
      uint32_t s = member[i].surface;
      patches->surface[at++] = s;
      patches->patch[s] = (uint32_t)p;
      patches->area[p] += mesh->area[mesh->surface[s].facet];
    }
    patches->begin[p + 1] = at;
  }
  return UM_OK;
}

enum um_status um_geometry_patches_create(struct um_context *context,
                                          const struct um_geometry_mesh *mesh,
                                          const struct um_geometry_pose *pose, const double *seen,
                                          size_t limit, struct um_geometry_patches **out)
{
  enum um_status status;
  struct um_geometry_patches *patches = NULL;
  struct member *member = NULL;
  struct run *run = NULL;
  size_t nmember = 0;
  *out = NULL;
  for (size_t s = 0; s < mesh->nsurface; s++) nmember += seen[s] >= 0.0;
  UM_CHECK(um_core_allocate(context, 1, sizeof *patches, &patches));
  patches->nsurface = mesh->nsurface;
  UM_CHECK(um_core_allocate(context, mesh->nsurface, sizeof *patches->patch, &patches->patch));
  memset(patches->patch, 0xff, mesh->nsurface * sizeof *patches->patch);
  UM_CHECK(um_core_allocate(context, nmember, sizeof *member, &member));
  UM_CHECK(um_core_allocate(context, nmember, sizeof *run, &run));
  fill_members(mesh, pose, seen, member);
  UM_CHECK(split(context, member, nmember, limit, run, &patches->npatch));
  if (patches->npatch > UM_GEOMETRY_PATCHES_MAX) {
    status = um_core_fail(context, UM_ERR_INPUT,
                          "%zu sides of groups stand before each other; accepted: up to %d, put "
                          "faces of one kind into one group",
                          patches->npatch, UM_GEOMETRY_PATCHES_MAX);
    goto done;
  }
  UM_CHECK(fill_patches(context, mesh, member, nmember, run, patches));
  *out = patches;
  patches = NULL;
done:
  UM_FREE(context, member, run);
  um_geometry_patches_destroy(context, &patches);
  return status;
}

void um_geometry_patches_destroy(struct um_context *context, struct um_geometry_patches **patches)
{
  if (patches == NULL || *patches == NULL) return;
  UM_FREE(context, (*patches)->patch, (*patches)->surface, (*patches)->begin, (*patches)->area,
          *patches);
  *patches = NULL;
}
