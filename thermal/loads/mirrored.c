/* Sunlight by way of mirrors: from points spread over every mirror that has something before it,
 * where the Sun is seen from there, along the mirrored ray, on from mirror to mirror. Every time
 * has rays of its own, so threads do not matter. */
#include "thermal/loads/mirrored.h"

#include <math.h>
#include <string.h>

#include "base/core/sampling.h"
#include "base/core/sort.h"
#include "geometry/cube.h"
#include "thermal/loads/loads_impl.h"
#include "thermal/loads/mirrored_impl.h"

#define BATCH  32 /* times on their way together */
#define BUNDLE 256
#define FEW    4096 /* rays that one thread traces sooner than several meet */
#define KEY    UINT64_C(0x6d6972726f72)

/* What a time's rays come upon. */
struct end {
  uint32_t row, from, to, sets; /* row: within the batch */
  double weight;                /* cosine times area of the ray [m^2] */
};

/* Rays of one time. */
struct slot {
  struct um_geometry_pose *pose;
  struct um_geometry_visibility *visibility;
  struct um_geometry_ray *ray; /* all [nray] */
  struct um_geometry_hit *hit;
  struct um_geometry_mirrored_path *path; /* tag: number of the ray */
  struct um_vec3 *on;                     /* its direction behind the mirror */
  uint32_t *from;                         /* patch that it left */
  double *weight;                         /* [m^2] */
  double *lit;                            /* [npatch] sum of weights */
  size_t n;                               /* rays on their way */
  bool bright;
};

struct tracer {
  struct um_context *context;
  const struct um_geometry *geometry;
  const struct um_geometry_mesh *mesh;
  const struct um_environment *environment;
  const struct um_environment_sample *samples;
  const struct um_irradiation_loads *loads;
  const struct um_geometry_patches *patches;
  const struct um_geometry_mirrors *mirrors;
  const struct um_irradiation_spin *spin;
  bool moves, earth;
  uint32_t *surface;              /* [nsurface] of the mirrors that are looked at */
  size_t *count, nsurface, nray;  /* [nsurface] rays of each */
  struct um_quat *attitude;       /* [BATCH][spin->n] */
  double *angles;                 /* [njoint] */
  struct um_vec3 *middle;         /* [UM_GEOMETRY_SKY_CELLS] directions */
  struct um_geometry_pose *fixed; /* where nothing moves */
  struct um_geometry_visibility *scene;
  struct slot slot[BATCH];
  struct end *end; /* [room] of the batch */
  size_t nend, room, written, space;
  struct um_irradiation_mirrored *out;
};

static enum um_status surfaces_find(struct tracer *t, size_t points)
{
  const struct um_geometry_patches *patches = t->patches;
  size_t n = t->mesh->nsurface;
  UM_TRY(um_core_allocate(t->context, n, sizeof *t->surface, &t->surface));
  UM_TRY(um_core_allocate(t->context, n, sizeof *t->count, &t->count));
  for (uint32_t s = 0; s < n; s++) {
    uint32_t p = patches->patch[s];
    if (p == UM_GEOMETRY_NONE || t->mirrors->of[s] == UM_GEOMETRY_NO_MIRROR) continue;
    double share = t->mesh->area[t->mesh->surface[s].facet] / patches->area[p];
    t->surface[t->nsurface] = s;
    t->count[t->nsurface] = (size_t)fmax(1.0, ceil((double)points * share * (1.0 - 1e-12)));
    t->nray += t->count[t->nsurface++];
  }
  return UM_OK;
}

static enum um_status prepare(struct tracer *t, size_t points)
{
  struct um_context *context = t->context;
  struct um_irradiation_mirrored *out = t->out;
  size_t ntime = out->ntime, ncell = UM_GEOMETRY_SKY_CELLS;
  UM_TRY(surfaces_find(t, points));
  UM_TRY(
      um_core_allocate(context, um_geometry_joint_count(t->geometry), sizeof(double), &t->angles));
  UM_TRY(um_core_allocate(context, ntime + 1, sizeof *out->begin, &out->begin));
  UM_TRY(um_core_allocate(context, ntime * ncell, sizeof *out->albedo, &out->albedo));
  UM_TRY(um_core_allocate(context, ntime * ncell, sizeof *out->planet, &out->planet));
  UM_TRY(um_core_allocate(context, ncell, sizeof *t->middle, &t->middle));
  for (size_t c = 0; c < ncell; c++)
    t->middle[c] = um_geometry_cube_direction(UM_GEOMETRY_SKY_SIDE, c, 0.5, 0.5);
  if (t->spin != NULL)
    UM_TRY(um_core_allocate(context, BATCH * t->spin->n, sizeof *t->attitude, &t->attitude));
  for (size_t k = 0; k < BATCH; k++) {
    struct slot *s = &t->slot[k];
    UM_TRY(um_core_allocate(context, t->nray, sizeof *s->ray, &s->ray));
    UM_TRY(um_core_allocate(context, t->nray, sizeof *s->hit, &s->hit));
    UM_TRY(um_core_allocate(context, t->nray, sizeof *s->path, &s->path));
    UM_TRY(um_core_allocate(context, t->nray, sizeof *s->on, &s->on));
    UM_TRY(um_core_allocate(context, t->nray, sizeof *s->from, &s->from));
    UM_TRY(um_core_allocate(context, t->nray, sizeof *s->weight, &s->weight));
    UM_TRY(um_core_allocate(context, t->patches->npatch, sizeof *s->lit, &s->lit));
  }
  if (t->moves) return UM_OK;
  um_geometry_joint_angles(t->geometry, um_quat_apply(t->samples[0].q, t->samples[0].sun),
                           t->samples[0].t_tai, t->angles);
  UM_TRY(um_geometry_pose_create(context, t->geometry,
                                 um_geometry_joint_count(t->geometry) == 0 ? NULL : t->angles,
                                 &t->fixed));
  return um_geometry_visibility_create(context, t->mesh, t->fixed, &t->scene);
}

static void slot_clear(struct tracer *t, struct slot *s)
{
  if (s->visibility != t->scene) um_geometry_visibility_destroy(&s->visibility);
  if (s->pose != t->fixed) um_geometry_pose_destroy(t->context, &s->pose);
  s->visibility = NULL;
  s->pose = NULL;
}

/* Scene and what shines of a time. */
static enum um_status slot_begin(struct tracer *t, size_t row, struct slot *s)
{
  const float *sun = t->loads->sun + row * t->loads->nsurface;
  memset(s->lit, 0, t->patches->npatch * sizeof *s->lit);
  s->bright = false;
  for (size_t i = 0; i < t->nsurface; i++) s->bright = s->bright || sun[t->surface[i]] > 0.0f;
  s->pose = t->fixed;
  s->visibility = t->scene;
  if (!t->moves || !s->bright) return UM_OK;
  um_geometry_joint_angles(t->geometry, um_quat_apply(t->samples[row].q, t->samples[row].sun),
                           t->samples[row].t_tai, t->angles);
  UM_TRY(um_geometry_pose_create(t->context, t->geometry, t->angles, &s->pose));
  return um_geometry_visibility_create(t->context, t->mesh, s->pose, &s->visibility);
}

static void closest(struct slot *s)
{
  for (size_t k = 0; k < s->n; k += BUNDLE)
    um_geometry_visibility_closest(s->visibility, s->ray + k, s->n - k < BUNDLE ? s->n - k : BUNDLE,
                                   s->hit + k);
}

/* Rays toward the Sun from points of surface i, and where they come from when it has turned them;
 * new points in every row. */
static void surface_begin(const struct tracer *t, size_t i, size_t row, struct um_vec3 sun,
                          struct slot *s)
{
  uint32_t surface = t->surface[i], facet = t->mesh->surface[surface].facet;
  struct um_vec3 normal = um_geometry_surface_normal(t->mesh, s->pose, surface);
  double cosine = um_vec3_dot(normal, sun);
  if (!(cosine > 0.0)) return;
  const uint32_t *c = t->mesh->corner[facet];
  struct um_vec3 a = s->pose->vertex[c[0]], ab = um_vec3_sub(s->pose->vertex[c[1]], a);
  struct um_vec3 ac = um_vec3_sub(s->pose->vertex[c[2]], a);
  struct um_vec3 on = um_vec3_unit(um_vec3_axpy(um_vec3_scale(sun, -1.0), 2.0 * cosine, normal));
  double weight = cosine * t->mesh->area[facet] / (double)t->count[i];
  uint64_t key = um_core_hash(KEY, surface);
  for (size_t k = 0; k < t->count[i]; k++) {
    double u[2], w[3];
    um_core_sample_2d(key, row * t->count[i] + k, u);
    um_core_sample_triangle(u, w);
    s->ray[s->n] = (struct um_geometry_ray){um_vec3_axpy(um_vec3_axpy(a, w[1], ab), w[2], ac), sun,
                                            INFINITY, facet};
    s->on[s->n] = on;
    s->from[s->n] = t->patches->patch[surface];
    s->weight[s->n++] = weight;
  }
}

/* Of these, the points from which the Sun is seen, as rays that a mirror has turned. */
static void rays_turn(struct slot *s)
{
  uint8_t occluded[BUNDLE];
  size_t all = s->n;
  s->n = 0;
  for (size_t begin = 0; begin < all; begin += BUNDLE) {
    size_t n = all - begin < BUNDLE ? all - begin : BUNDLE;
    um_geometry_visibility_occluded(s->visibility, s->ray + begin, n, occluded);
    for (size_t i = 0, k = begin; i < n; i++, k++) {
      if (occluded[i]) continue;
      s->ray[s->n] = s->ray[k];
      s->ray[s->n].direction = s->on[k];
      s->path[s->n] = (struct um_geometry_mirrored_path){.tag = (uint32_t)s->n};
      s->from[s->n] = s->from[k];
      s->weight[s->n] = s->weight[k];
      s->lit[s->from[k]] += s->weight[k];
      s->n++;
    }
  }
}

/* Attitude j of a row: its Earth, and its rays on their way to what they come upon first. */
static void attitude_begin(const struct tracer *t, size_t row, size_t j, struct slot *s, size_t at)
{
  struct um_environment_sample sample = t->samples[row];
  double weight = 1.0, before;
  if (t->spin != NULL) {
    um_irradiation_spin_node(t->spin, row, j, &before, &weight);
    sample.q = t->attitude[at * t->spin->n + j];
  }
  if (t->earth)
    um_irradiation_mirrored_earth(t->environment, &sample, weight, t->middle,
                                  t->out->albedo + row * UM_GEOMETRY_SKY_CELLS,
                                  t->out->planet + row * UM_GEOMETRY_SKY_CELLS);
  s->n = 0;
  if (!s->bright) return;
  struct um_vec3 sun = um_quat_apply(sample.q, sample.sun);
  for (size_t i = 0; i < t->nsurface; i++) surface_begin(t, i, row, sun, s);
  rays_turn(s);
  closest(s);
}

static enum um_status ends_take(struct tracer *t, size_t at)
{
  const struct slot *s = &t->slot[at];
  for (size_t k = 0; k < s->n; k++) {
    if (s->hit[k].facet == UM_GEOMETRY_NONE || s->hit[k].surface == UM_GEOMETRY_NONE) continue;
    uint32_t to = t->patches->patch[s->hit[k].surface], sets, tag = s->path[k].tag;
    if (to == UM_GEOMETRY_NONE) continue;
    UM_TRY(um_geometry_mirror_sets_find(t->context, &t->out->sets, &s->path[k].met, &sets));
    if (t->nend == t->room) {
      size_t room = 2 * t->room + 4096;
      UM_TRY(um_core_reallocate(t->context, room, sizeof *t->end, &t->end));
      t->room = room;
    }
    t->end[t->nend++] = (struct end){(uint32_t)at, s->from[tag], to, sets, s->weight[tag]};
  }
  return UM_OK;
}

static int compare_ends(const void *pa, const void *pb)
{
  const struct end *a = pa, *b = pb;
  if (a->row != b->row) return a->row < b->row ? -1 : 1;
  if (a->from != b->from) return a->from < b->from ? -1 : 1;
  if (a->to != b->to) return a->to < b->to ? -1 : 1;
  if (a->sets != b->sets) return a->sets < b->sets ? -1 : 1;
  return (a->weight > b->weight) - (a->weight < b->weight);
}

/* Ends of the batch of rows from `from` on, as shares of what each patch gets of the Sun. */
static enum um_status batch_write(struct tracer *t, size_t from, size_t n)
{
  struct um_irradiation_mirrored *out = t->out;
  UM_TRY(um_core_sort(t->context, t->end, t->nend, sizeof *t->end, compare_ends));
  size_t k = 0;
  for (size_t i = 0; i < n; i++) {
    while (k < t->nend && t->end[k].row == i) {
      const struct end first = t->end[k];
      double sum = 0.0;
      for (; k < t->nend && t->end[k].row == i && t->end[k].from == first.from &&
             t->end[k].to == first.to && t->end[k].sets == first.sets;
           k++)
        sum += t->end[k].weight;
      if (t->written == t->space) {
        t->space = 2 * t->space + 65536;
        UM_TRY(um_core_reallocate(t->context, t->space, sizeof *out->sun, &out->sun));
      }
      out->sun[t->written++] = (struct um_irradiation_mirrored_sun){
          first.from, first.to, first.sets, (float)(sum / t->slot[i].lit[first.from])};
    }
    out->begin[from + i + 1] = t->written;
  }
  t->nend = 0;
  return UM_OK;
}

static enum um_status attitudes_ask(struct tracer *t, size_t from, size_t n)
{
  for (size_t i = 0; i < n && t->spin != NULL; i++)
    for (size_t j = 0; j < t->spin->n; j++) {
      double u, weight;
      um_irradiation_spin_node(t->spin, from + i, j, &u, &weight);
      UM_TRY(t->spin->attitude(t->spin->self, from + i, t->spin->period - u,
                               &t->attitude[i * t->spin->n + j]));
    }
  return UM_OK;
}

/* All rays of one attitude of the rows of a batch. */
static enum um_status attitude_run(struct tracer *t, size_t from, long n, size_t j)
{
  int threads = um_core_context_threads(t->context);
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
  for (long i = 0; i < n; i++)
    if (!um_core_stopped(t->context))
      attitude_begin(t, from + (size_t)i, j, &t->slot[i], (size_t)i);
  for (size_t left = 1; left > 0;) {
    UM_TRY(um_core_stop_check(t->context, "mirrored sunlight was traced"));
    for (long i = 0; i < n; i++) UM_TRY(ends_take(t, (size_t)i));
    left = 0;
    for (long i = 0; i < n; i++) {
      struct slot *s = &t->slot[i];
      s->n = um_geometry_mirrored_turn(t->mesh, s->pose, t->mirrors, s->ray, s->path, s->hit, s->n);
      left += s->n;
    }
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads) if (left > FEW)
    for (long i = 0; i < n; i++) closest(&t->slot[i]);
  }
  return UM_OK;
}

static enum um_status batch_run(struct tracer *t, size_t from, size_t n)
{
  UM_TRY(attitudes_ask(t, from, n));
  for (size_t i = 0; i < n; i++) UM_TRY(slot_begin(t, from + i, &t->slot[i]));
  for (size_t j = 0; j < (t->spin != NULL ? t->spin->n : 1); j++)
    UM_TRY(attitude_run(t, from, (long)n, j));
  UM_TRY(batch_write(t, from, n));
  for (size_t i = 0; i < n; i++) slot_clear(t, &t->slot[i]);
  return um_core_progress_step(t->context, n);
}

static void tracer_free(struct tracer *t)
{
  for (size_t k = 0; k < BATCH; k++) {
    struct slot *s = &t->slot[k];
    slot_clear(t, s);
    UM_FREE(t->context, s->ray, s->hit, s->path, s->on, s->from, s->weight, s->lit);
  }
  um_geometry_visibility_destroy(&t->scene);
  um_geometry_pose_destroy(t->context, &t->fixed);
  UM_FREE(t->context, t->surface, t->count, t->attitude, t->angles, t->middle, t->end);
}

enum um_status um_irradiation_mirrored_trace(
    struct um_context *context, const struct um_geometry *geometry,
    const struct um_environment *environment, const struct um_environment_sample *samples,
    const struct um_irradiation_loads *loads, const struct um_geometry_patches *patches,
    const struct um_geometry_mirrors *mirrors,
    const struct um_irradiation_mirrored_options *options, struct um_irradiation_mirrored **out)
{
  enum um_status status;
  struct um_irradiation_mirrored *mirrored = NULL;
  struct tracer t = {.context = context,
                     .geometry = geometry,
                     .mesh = um_geometry_mesh(geometry),
                     .environment = environment,
                     .samples = samples,
                     .loads = loads,
                     .patches = patches,
                     .mirrors = mirrors,
                     .spin = options->spin,
                     .moves = um_geometry_joint_moves(geometry)};
  *out = NULL;
  if (options->points < 1)
    return um_core_fail(context, UM_ERR_INPUT,
                        "mirrored sunlight from %zu points of each patch; accepted: 1 or more",
                        options->points);
  t.earth = um_environment_earth_varies(environment) || environment->albedo > 0.0 ||
            environment->outgoing_longwave > 0.0;
  um_core_progress_begin(context, "mirrored sunlight", loads->ntime);
  UM_CHECK(um_core_allocate(context, 1, sizeof *mirrored, &mirrored));
  t.out = mirrored;
  mirrored->ntime = loads->ntime;
  UM_CHECK(prepare(&t, options->points));
  for (size_t k = 0; k < loads->ntime; k += BATCH)
    UM_CHECK(batch_run(&t, k, loads->ntime - k < BATCH ? loads->ntime - k : BATCH));
  *out = mirrored;
  mirrored = NULL;
done:
  um_core_progress_end(context);
  tracer_free(&t);
  um_irradiation_mirrored_destroy(context, &mirrored);
  return status;
}

void um_irradiation_mirrored_destroy(struct um_context *context,
                                     struct um_irradiation_mirrored **mirrored)
{
  if (mirrored == NULL || *mirrored == NULL) return;
  um_geometry_mirror_sets_clear(context, &(*mirrored)->sets);
  UM_FREE(context, (*mirrored)->begin, (*mirrored)->sun, (*mirrored)->albedo, (*mirrored)->planet,
          *mirrored);
  *mirrored = NULL;
}
