/* Poses on a lattice of joint angles.
 *
 * An angle a is i + u steps, i whole and 0 <= u < 1. With several moving joints the cube between
 * 2^m lattice points is cut into simplices by the order of the u (Kuhn 1960): with u_1 >= u_2 >=
 * ... the corners are i, i + e_1, i + e_1 + e_2, ... with the weights 1 - u_1, u_1 - u_2, ..., u_m.
 * It is linear, continuous, and wings that turn together ask for few poses. */
#include "geometry/view_factor_table.h"

#include <string.h>

#include "base/core/constants.h"
#include "geometry/view_factor_file.h"

#define FINEST   24   /* poses in a turn of a joint: 15 deg */
#define MOST     64   /* poses */
#define UNUSED   1e-9 /* weights below are none */
#define MOVING   8    /* joints that may move; a simplex has one corner more */
#define NO_PLACE UINT32_MAX

struct lattice {
  struct um_context *context;
  const struct um_geometry *geometry;
  const double *angles; /* [ntime][njoint] */
  size_t ntime, njoint;
  size_t moving[MOVING]; /* joints */
  size_t nmoving;
  int turn;   /* poses in a turn */
  int *place; /* [room][nmoving] of the poses, in steps, 0 <= place < turn */
  size_t npose;
  struct um_geometry_view_factor_table *table;
};

static enum um_status find_moving(struct lattice *l)
{
  for (size_t j = 0; j < l->njoint; j++) {
    bool moves = false;
    for (size_t k = 1; k < l->ntime && !moves; k++)
      moves = l->angles[k * l->njoint + j] != l->angles[j];
    if (!moves) continue;
    if (l->nmoving == MOVING)
      return um_core_fail(l->context, UM_ERR_INPUT, "more than %d joints move; accepted: up to %d",
                          MOVING, MOVING);
    l->moving[l->nmoving++] = j;
  }
  return UM_OK;
}

/* Index of a lattice point, added where there is room for it; NO_PLACE: there is none. */
static uint32_t pose_at(struct lattice *l, const int *place)
{
  for (size_t k = 0; k < l->npose; k++)
    if (memcmp(l->place + k * MOVING, place, l->nmoving * sizeof *place) == 0) return (uint32_t)k;
  if (l->npose == MOST) return NO_PLACE;
  memcpy(l->place + l->npose * MOVING, place, l->nmoving * sizeof *place);
  return (uint32_t)l->npose++;
}

/* Corners and weights of one time; false when there are too many poses. */
static bool place_time(struct lattice *l, size_t k)
{
  int place[MOVING];
  double part[MOVING];
  size_t order[MOVING];
  uint32_t *corner = l->table->corner + k * l->table->ncorner;
  double *weight = l->table->weight + k * l->table->ncorner, step = 2.0 * UM_PI / l->turn;
  for (size_t m = 0; m < l->nmoving; m++) {
    double steps = l->angles[k * l->njoint + l->moving[m]] / step, whole = floor(steps);
    part[m] = steps - whole;
    place[m] = (int)fmod(fmod(whole, l->turn) + l->turn, l->turn);
    size_t at = m; /* descending by part */
    for (; at > 0 && part[order[at - 1]] < part[m]; at--) order[at] = order[at - 1];
    order[at] = m;
  }
  for (size_t c = 0; c <= l->nmoving; c++) {
    double above = c == 0 ? 1.0 : part[order[c - 1]];
    double below = c == l->nmoving ? 0.0 : part[order[c]];
    if (c > 0) place[order[c - 1]] = (place[order[c - 1]] + 1) % l->turn;
    weight[c] = above - below > UNUSED ? above - below : 0.0;
    corner[c] = c == 0 ? 0 : corner[0];
    if (weight[c] == 0.0) continue;
    corner[c] = pose_at(l, place);
    if (corner[c] == NO_PLACE) return false;
  }
  return true;
}

/* The finest lattice of few enough poses. */
static enum um_status place_all(struct lattice *l)
{
  struct um_geometry_view_factor_table *table = l->table;
  table->ntime = l->ntime;
  table->ncorner = l->nmoving + 1;
  UM_TRY(um_core_allocate(l->context, l->ntime * table->ncorner, sizeof *table->corner,
                          &table->corner));
  UM_TRY(um_core_allocate(l->context, l->ntime * table->ncorner, sizeof *table->weight,
                          &table->weight));
  UM_TRY(um_core_allocate(l->context, (size_t)MOST * MOVING, sizeof *l->place, &l->place));
  for (l->turn = FINEST; l->turn >= 1; l->turn--) {
    size_t k = 0;
    l->npose = 0;
    while (k < l->ntime && place_time(l, k)) k++;
    if (k == l->ntime) break;
  }
  table->npose = l->npose;
  table->step = l->nmoving > 0 ? 2.0 * UM_PI / l->turn : 0.0;
  return um_core_allocate(l->context, l->npose, sizeof(void *), (void *)&table->pose);
}

struct scene {
  struct um_geometry_pose *pose;
  struct um_geometry_visibility *visibility;
};

static void scene_destroy(struct lattice *l, struct scene *scene)
{
  um_geometry_visibility_destroy(&scene->visibility);
  um_geometry_pose_destroy(l->context, &scene->pose);
}

/* Joints of a pose of the lattice, [njoint] [rad]. */
static void pose_angles(const struct lattice *l, size_t pose, double *angles)
{
  if (l->njoint > 0) memcpy(angles, l->angles, l->njoint * sizeof *angles);
  for (size_t m = 0; m < l->nmoving; m++)
    angles[l->moving[m]] = 2.0 * UM_PI * l->place[pose * MOVING + m] / l->turn;
}

static enum um_status scene_create(struct lattice *l, size_t pose, struct scene *scene)
{
  enum um_status status;
  double *angles = NULL;
  *scene = (struct scene){0};
  UM_CHECK(um_core_allocate(l->context, l->njoint, sizeof *angles, &angles));
  pose_angles(l, pose, angles);
  UM_CHECK(um_geometry_pose_create(l->context, l->geometry, l->njoint > 0 ? angles : NULL,
                                   &scene->pose));
  UM_CHECK(um_geometry_visibility_create(l->context, um_geometry_mesh(l->geometry), scene->pose,
                                         &scene->visibility));
done:
  um_core_free(l->context, angles);
  if (status != UM_OK) scene_destroy(l, scene);
  return status;
}

/* Patches of all that is covered in some pose, gathered as they stand in the first. */
static enum um_status gather(struct lattice *l, size_t limit)
{
  enum um_status status;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(l->geometry);
  struct scene scene = {0}, first = {0};
  double *seen = NULL;
  UM_CHECK(um_core_allocate(l->context, mesh->nsurface, sizeof *seen, &seen));
  for (size_t s = 0; s < mesh->nsurface; s++) seen[s] = -1.0;
  for (size_t k = l->npose; k-- > 0;) {
    UM_CHECK(scene_create(l, k, &scene));
    for (size_t s = 0; s < mesh->nsurface; s++)
      if (seen[s] < 0.0 && !um_geometry_visibility_is_open(scene.visibility, s)) seen[s] = 0.0;
    UM_CHECK(um_geometry_view_factors_seen(l->context, mesh, scene.pose, scene.visibility, seen));
    if (k == 0)
      first = scene;
    else
      scene_destroy(l, &scene);
  }
  UM_CHECK(
      um_geometry_patches_create(l->context, mesh, first.pose, seen, limit, &l->table->patches));
done:
  if (first.pose == NULL) scene_destroy(l, &scene);
  scene_destroy(l, &first);
  um_core_free(l->context, seen);
  return status;
}

static enum um_status trace(struct lattice *l,
                            const struct um_geometry_view_factor_options *options)
{
  struct um_geometry_view_factor_table *table = l->table;
  for (size_t k = 0; k < l->npose; k++) {
    struct scene scene;
    UM_TRY(scene_create(l, k, &scene));
    enum um_status status =
        um_geometry_view_factors_create(l->context, um_geometry_mesh(l->geometry), scene.pose,
                                        scene.visibility, table->patches, options, &table->pose[k]);
    scene_destroy(l, &scene);
    UM_TRY(status);
  }
  return UM_OK;
}

/* Pose `steps` from another along moving joint m, or NO_PLACE. */
static uint32_t neighbour(struct lattice *l, size_t pose, size_t m, int steps)
{
  int place[MOVING];
  memcpy(place, l->place + pose * MOVING, sizeof place);
  place[m] = (place[m] + steps + l->turn) % l->turn;
  for (size_t k = 0; k < l->npose; k++)
    if (memcmp(l->place + k * MOVING, place, l->nmoving * sizeof *place) == 0) return (uint32_t)k;
  return NO_PLACE;
}

/* Largest |F(a - h) - 2 F(a) + F(a + h)| / 8 of pairs that see each other in the middle pose. */
static double second_difference(const struct um_geometry_view_factor_table *table, size_t before,
                                size_t middle, size_t after)
{
  const struct um_geometry_view_factors *f = table->pose[middle];
  double worst = 0.0;
  for (size_t p = 0; p < f->npatch; p++)
    for (size_t e = f->begin[p]; e < f->begin[p + 1]; e++) {
      double sum = um_geometry_view_factors_area(table->pose[before], p, f->other[e]) +
                   um_geometry_view_factors_area(table->pose[after], p, f->other[e]);
      worst = fmax(worst, fabs(sum - 2.0 * f->area[e]) / (8.0 * table->patches->area[p]));
    }
  return worst;
}

static enum um_status judge(struct lattice *l)
{
  for (size_t k = 0; k < l->npose; k++)
    for (size_t m = 0; m < l->nmoving; m++) {
      uint32_t before = neighbour(l, k, m, -1), after = neighbour(l, k, m, 1);
      UM_TRY(um_core_stop_check(l->context, "view factors of poses were compared"));
      if (before == NO_PLACE || after == NO_PLACE) continue;
      l->table->interpolation =
          fmax(l->table->interpolation, second_difference(l->table, before, k, after));
    }
  return UM_OK;
}

/* What all of it is made of. */
static enum um_status key_make(struct lattice *l, size_t limit,
                               const struct um_geometry_view_factor_options *options,
                               struct um_geometry_view_factor_key *key)
{
  enum um_status status;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(l->geometry);
  struct um_geometry_pose *pose = NULL;
  double *angles = NULL;
  UM_CHECK(um_core_allocate(l->context, l->njoint, sizeof *angles, &angles));
  UM_CHECK(um_geometry_pose_create(l->context, l->geometry, l->njoint > 0 ? angles : NULL, &pose));
  um_geometry_view_factor_key_begin(mesh, pose, limit, options, key);
  for (size_t k = 0; k < l->npose; k++) {
    um_geometry_pose_destroy(l->context, &pose);
    pose_angles(l, k, angles);
    UM_CHECK(
        um_geometry_pose_create(l->context, l->geometry, l->njoint > 0 ? angles : NULL, &pose));
    um_geometry_view_factor_key_pose(mesh, pose, key);
  }
done:
  um_geometry_pose_destroy(l->context, &pose);
  um_core_free(l->context, angles);
  return status;
}

/* From a file, or by rays. */
static enum um_status fill(struct lattice *l, size_t limit,
                           const struct um_geometry_view_factor_options *options)
{
  struct um_geometry_view_factor_table *table = l->table;
  struct um_geometry_view_factor_set set = {.geometry = l->geometry,
                                            .mesh = um_geometry_mesh(l->geometry),
                                            .npose = l->npose,
                                            .pose = table->pose};
  bool found = false;
  UM_TRY(key_make(l, limit, options, &set.key));
  table->key = set.key;
  UM_TRY(um_geometry_view_factor_find(l->context, "outside", options, &set, &found));
  if (found) {
    table->patches = set.patches;
    table->interpolation = set.interpolation;
    return UM_OK;
  }
  UM_TRY(gather(l, limit));
  UM_TRY(trace(l, options));
  UM_TRY(judge(l));
  set.patches = table->patches;
  set.interpolation = table->interpolation;
  return um_geometry_view_factor_keep(l->context, "outside", options, &set);
}

static enum um_status mirrors_copy(struct um_context *context,
                                   const struct um_geometry_mirrors *from,
                                   struct um_geometry_mirrors **out)
{
  UM_TRY(um_geometry_mirrors_create(context, from->nsurface, out));
  (*out)->nclass = from->nclass;
  memcpy((*out)->of, from->of, from->nsurface * sizeof *from->of);
  return UM_OK;
}

/* Paths by way of mirrors, in every pose. */
static enum um_status fill_mirrored(struct lattice *l,
                                    const struct um_geometry_view_factor_options *options)
{
  struct um_geometry_view_factor_table *table = l->table;
  const struct um_geometry_mirrors *mirrors = options->mirrors;
  bool any = false;
  for (size_t p = 0; p < table->patches->npatch && !any; p++)
    any = um_geometry_mirrors_patch(mirrors, table->patches, p) != UM_GEOMETRY_NO_MIRROR;
  if (!any) return UM_OK;
  UM_TRY(um_core_allocate(l->context, l->npose, sizeof(void *), (void *)&table->mirrored));
  for (size_t k = 0; k < l->npose; k++) {
    struct scene scene;
    UM_TRY(scene_create(l, k, &scene));
    enum um_status status = um_geometry_mirror_paths_create(
        l->context, um_geometry_mesh(l->geometry), scene.pose, scene.visibility, table->patches,
        table->pose[k], mirrors, options, &table->mirrored[k]);
    scene_destroy(l, &scene);
    UM_TRY(status);
  }
  return mirrors_copy(l->context, mirrors, &table->mirrors);
}

enum um_status
um_geometry_view_factor_table_create(struct um_context *context, const struct um_geometry *geometry,
                                     const double *angles, size_t ntime, size_t limit,
                                     const struct um_geometry_view_factor_options *options,
                                     struct um_geometry_view_factor_table **out)
{
  enum um_status status;
  struct lattice l = {.context = context,
                      .geometry = geometry,
                      .angles = angles,
                      .ntime = ntime,
                      .njoint = um_geometry_joint_count(geometry)};
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *l.table, &l.table));
  UM_CHECK(find_moving(&l));
  UM_CHECK(place_all(&l));
  UM_CHECK(fill(&l, limit, options));
  if (options->mirrors != NULL) UM_CHECK(fill_mirrored(&l, options));
  l.table->nsurface = l.table->patches->nsurface;
  l.table->noutside = l.table->patches->npatch;
  *out = l.table;
  l.table = NULL;
done:
  um_core_free(context, l.place);
  um_geometry_view_factor_table_destroy(context, &l.table);
  return status;
}

void um_geometry_view_factor_table_write(const struct um_geometry *geometry,
                                         const struct um_geometry_view_factor_table *table,
                                         FILE *file)
{
  struct um_geometry_patches outside = *table->patches;
  outside.npatch = table->noutside;
  const struct um_geometry_view_factor_set set = {.geometry = geometry,
                                                  .mesh = um_geometry_mesh(geometry),
                                                  .key = table->key,
                                                  .npose = table->npose,
                                                  .patches = &outside,
                                                  .pose = table->pose,
                                                  .interpolation = table->interpolation};
  um_geometry_view_factor_file_write(&set, file);
}

void um_geometry_view_factor_table_destroy(struct um_context *context,
                                           struct um_geometry_view_factor_table **table)
{
  if (table == NULL || *table == NULL) return;
  struct um_geometry_view_factor_table *t = *table;
  for (size_t k = 0; k < t->npose && t->pose != NULL; k++)
    um_geometry_view_factors_destroy(context, &t->pose[k]);
  for (size_t k = 0; k < t->nroom; k++)
    um_geometry_view_factors_destroy(context, &t->room[k].factors);
  um_core_free(context, t->room);
  um_geometry_patches_destroy(context, &t->patches);
  for (size_t k = 0; k < t->npose && t->mirrored != NULL; k++)
    um_geometry_mirror_paths_destroy(context, &t->mirrored[k]);
  um_core_free(context, (void *)t->mirrored);
  um_geometry_mirrors_destroy(context, &t->mirrors);
  UM_FREE(context, (void *)t->pose, t->corner, t->weight, t);
  *table = NULL;
}
