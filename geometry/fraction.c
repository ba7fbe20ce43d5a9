/* Which fraction of a surface is free toward a direction, and which also sees the Sun.
 *
 * Of a body of few facets shades.c says what is hidden toward the observer, and that nothing stands
 * before the Sun; rays say the rest.
 *
 * Points on facets and on the Sun's disc are keyed by facet and sample (points.c), so that a
 * fraction is a smooth function of pose and direction and repeated calls agree. A point of the disc
 * below the surface's own horizon is mirrored through the disc's centre to one above: the cosine at
 * the centre, which callers use, is the mean over the disc, the part below counted negative.
 *
 * Standard error of a fraction f of n > 1 points: e = sqrt(f (1 - f) q(n)), with q what evenly
 * spread points do where a straight edge cuts a facet (scatter.c), 1/(n - 1) for independent ones.
 * A single point tells nothing of its error: e = 1/2, the largest that a 0-1 variable can have. */
#include <assert.h>

#include "geometry/scatter.h"
#include "geometry/shades_impl.h"
#include "geometry/visibility_data_impl.h"
#include "geometry/visibility_impl.h"

/* Rays traced at a time; on the stack. */
#define BATCH 256

/* Rays on their way to be traced, with the surface and sample that each belongs to. */
struct batch {
  struct um_geometry_ray ray[BATCH];
  size_t surface[BATCH];
  int sample[BATCH];
  double sun_cosine[BATCH]; /* of the surface's normal and the Sun; not above 0: not asked */
  size_t n;
};

/* One evaluation: counts go into seen and lit, divided at the end. */
struct task {
  const struct um_geometry_visibility *visibility;
  struct um_vec3 o;    /* toward the observer */
  struct um_vec3 s;    /* toward the Sun's centre */
  struct um_vec3 t, b; /* complete s to a frame */
  double tangent;      /* of the disc's angular radius */
  uint64_t seed;       /* of the points */
  double *seen, *lit;  /* [nsurface]; lit NULL: not asked */
  /* the body toward both, where it has few facets */
  struct um_geometry_shades_look toward_observer, toward_sun;
  bool few, few_sun;
  struct batch view, sun;
};

/* Toward a point of the disc; not unit, which a ray without limit need not be. */
static struct um_vec3 sun_direction(const struct task *task, const struct batch *view, size_t i)
{
  if (!(task->tangent > 0.0)) return task->s;
  const struct um_geometry_visibility *v = task->visibility;
  double xy[2];
  um_geometry_points_disc(v, task->seed, view->ray[i].from_facet, (uint64_t)view->sample[i], xy);
  struct um_vec3 across =
      um_vec3_axpy(um_vec3_scale(task->t, task->tangent * xy[0]), task->tangent * xy[1], task->b);
  if (view->sun_cosine[i] <= task->tangent) { /* the disc may cross the surface's horizon */
    struct um_vec3 normal = um_geometry_surface_normal(v->mesh, v->pose, view->surface[i]);
    if (view->sun_cosine[i] + um_vec3_dot(normal, across) <= 0.0)
      across = um_vec3_scale(across, -1.0);
  }
  return um_vec3_add(task->s, across);
}

static void trace_sun(struct task *task)
{
  uint8_t occluded[BATCH];
  struct batch *sun = &task->sun;
  um_geometry_visibility_occluded_coherent(task->visibility, sun->ray, sun->n, occluded);
  for (size_t i = 0; i < sun->n; i++) task->lit[sun->surface[i]] += occluded[i] ? 0.0 : 1.0;
  sun->n = 0;
}

/* Rays of the view that are free go on to the Sun where the surface faces it. */
static void look_on(struct task *task, const uint8_t *hidden)
{
  struct batch *view = &task->view, *sun = &task->sun;
  for (size_t i = 0; i < view->n; i++) {
    if (hidden[i]) continue;
    task->seen[view->surface[i]] += 1.0;
    if (!(view->sun_cosine[i] > 0.0)) continue;
    if (sun->n == BATCH) trace_sun(task);
    sun->ray[sun->n] = view->ray[i];
    sun->ray[sun->n].direction = sun_direction(task, view, i);
    sun->surface[sun->n++] = view->surface[i];
  }
  view->n = 0;
}

static void trace_view(struct task *task)
{
  uint8_t occluded[BATCH];
  struct batch *view = &task->view;
  um_geometry_visibility_occluded_coherent(task->visibility, view->ray, view->n, occluded);
  look_on(task, occluded);
}

static void add_sample(struct task *task, size_t surface, double sun_cosine, int sample)
{
  const struct um_geometry_visibility *v = task->visibility;
  struct batch *view = &task->view;
  uint32_t facet = v->mesh->surface[surface].facet;
  struct um_vec3 origin = um_geometry_points_facet(v, task->seed, facet, (uint64_t)sample);
  view->ray[view->n] = (struct um_geometry_ray){origin, task->o, INFINITY, facet};
  view->surface[view->n] = surface;
  view->sample[view->n] = sample;
  view->sun_cosine[view->n++] = sun_cosine;
}

static void add_samples(struct task *task, size_t surface, double sun_cosine, int nsample)
{
  for (int k = 0; k < nsample; k++) {
    if (task->view.n == BATCH) trace_view(task);
    add_sample(task, surface, sun_cosine, k);
  }
}

/* Samples of which is known whether they are hidden; `free_sun`: nothing stands before the Sun. */
static void add_known(struct task *task, size_t surface, double sun_cosine, bool free_sun,
                      const uint8_t *hidden, int nsample)
{
  static const uint8_t none[BATCH] = {0};
  double seen = 0.0;
  for (int k = 0; k < nsample; k++) seen += hidden[k] ? 0.0 : 1.0;
  if (!(sun_cosine > 0.0) || free_sun) {
    task->seen[surface] = seen;
    if (sun_cosine > 0.0) task->lit[surface] = seen;
    return;
  }
  trace_view(task);
  for (int k = 0; k < nsample; k++) {
    if (hidden[k]) continue;
    if (task->view.n == BATCH) look_on(task, none);
    add_sample(task, surface, sun_cosine, k);
  }
  look_on(task, none);
}

/* A surface of a body of few facets; false: rays have to say. */
static bool look_at(struct task *task, size_t surface, double sun_cosine, int nsample)
{
  const struct um_geometry_visibility *v = task->visibility;
  struct um_geometry_shade shade[UM_GEOMETRY_SHADES_MOST];
  uint8_t hidden[UM_GEOMETRY_POINTS];
  double blur = UM_GEOMETRY_BLUR * v->size;
  size_t n = um_geometry_shades_before(&task->toward_observer, surface, blur, shade);
  if (n == SIZE_MAX) return false;
  um_geometry_shades_on(v, task->seed, v->mesh->surface[surface].facet, shade, n, (size_t)nsample,
                        hidden);
  bool free_sun = sun_cosine > 0.0 && task->few_sun &&
                  um_geometry_shades_before(&task->toward_sun, surface,
                                            blur + task->tangent * v->size, NULL) == 0;
  add_known(task, surface, sun_cosine, free_sun, hidden, nsample);
  return true;
}

static void run(struct task *task, int nsample)
{
  const struct um_geometry_visibility *v = task->visibility;
  size_t nsurface = v->mesh->nsurface;
  task->few = nsample <= UM_GEOMETRY_POINTS &&
              um_geometry_shades_toward(v, task->o, &task->toward_observer);
  task->few_sun =
      task->few && task->lit != NULL && um_geometry_shades_toward(v, task->s, &task->toward_sun);
  for (size_t s = 0; s < nsurface && !um_core_stopped(v->context); s++) {
    struct um_vec3 normal = um_geometry_surface_normal(v->mesh, v->pose, s);
    double sun_cosine = task->lit == NULL ? 0.0 : um_vec3_dot(normal, task->s);
    task->seen[s] = 0.0;
    if (task->lit != NULL) task->lit[s] = 0.0;
    if (!(um_vec3_dot(normal, task->o) > 0.0)) continue;
    if (v->open[s]) {
      task->seen[s] = nsample;
      if (sun_cosine > 0.0) task->lit[s] = nsample;
    } else if (!task->few || !look_at(task, s, sun_cosine, nsample)) {
      add_samples(task, s, sun_cosine, nsample);
    }
  }
  trace_view(task);
  trace_sun(task);
  for (size_t s = 0; s < nsurface; s++) {
    task->seen[s] /= nsample;
    if (task->lit != NULL) task->lit[s] /= nsample;
  }
}

/* Members one by one: clearing the batches would cost more than a small model. */
static void begin(struct task *task, const struct um_geometry_visibility *visibility,
                  struct um_vec3 o, double *seen)
{
  task->visibility = visibility;
  task->o = task->s = o;
  task->tangent = 0.0;
  task->seed = 0;
  task->seen = seen;
  task->lit = NULL;
  task->view.n = task->sun.n = 0;
}

void um_geometry_visibility_toward(const struct um_geometry_visibility *visibility,
                                   struct um_vec3 d, int nsample, double *fraction)
{
  assert(nsample >= 1);
  struct task task;
  begin(&task, visibility, d, fraction);
  run(&task, nsample < 1 ? 1 : nsample);
}

/* Standard error of a fraction; `exact` where no ray was needed. */
static double standard_error(double f, int nsample, bool exact)
{
  if (exact) return 0.0;
  if (nsample < 2) return 0.5;
  return sqrt(fmax(0.0, f * (1.0 - f)) * um_geometry_scatter(nsample));
}

void um_geometry_visibility_toward_both(const struct um_geometry_visibility *visibility,
                                        struct um_vec3 o, struct um_vec3 s, double radius,
                                        int nsample, uint64_t seed, double *seen, double *lit,
                                        double *seen_error, double *lit_error)
{
  assert(nsample >= 1);
  if (nsample < 1) nsample = 1;
  struct task task;
  begin(&task, visibility, o, seen);
  task.seed = seed;
  task.s = s;
  task.lit = lit;
  task.tangent = tan(radius);
  um_core_vec3_frame(s, &task.t, &task.b);
  run(&task, nsample);
  const struct um_geometry_mesh *mesh = visibility->mesh;
  for (size_t i = 0; i < mesh->nsurface; i++) {
    struct um_vec3 normal = um_geometry_surface_normal(mesh, visibility->pose, i);
    bool no_view = visibility->open[i] || !(um_vec3_dot(normal, o) > 0.0);
    bool no_sun = no_view || !(um_vec3_dot(normal, s) > 0.0);
    if (seen_error != NULL) seen_error[i] = standard_error(seen[i], nsample, no_view);
    if (lit_error != NULL) lit_error[i] = standard_error(lit[i], nsample, no_sun);
  }
}
