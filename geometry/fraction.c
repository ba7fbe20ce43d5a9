/* Which fraction of a surface is free toward a direction, and which also sees the Sun.
 *
 * Points on a facet are those of the R2 sequence keyed by the facet, mapped to the triangle; the
 * points on the Sun's disc, of a sequence independent of it, are keyed by facet too, so that a
 * fraction is a smooth function of pose and direction and repeated calls agree. A point of the disc
 * below the surface's own horizon is mirrored through the disc's centre to one above: the cosine at
 * the centre, which callers use, is the mean over the disc, the part below counted negative.
 *
 * Standard error of a fraction f of n > 1 points: sample deviation over sqrt(n),
 * e = sqrt(f (1 - f) / (n - 1)), that of independent points and above the true error of these
 * evenly spread ones. A single point tells nothing of its error: e = 1/2, the largest that a 0-1
 * variable can have. */
#include <assert.h>

#include "core/sampling.h"
#include "geometry/visibility_impl.h"

/* Rays traced at a time; on the stack. */
#define BATCH 256

/* Keys that keep the sequences of facet and disc apart. */
#define KEY_POINT UINT64_C(0x706f696e74)
#define KEY_DISC  UINT64_C(0x64697363)

struct um_vec3 um_geometry_sample_point(const struct um_geometry_visibility *visibility,
                                        uint32_t facet, uint64_t sample)
{
  double u[2], w[3];
  const uint32_t *c = visibility->mesh->corner[facet];
  const struct um_vec3 *vertex = visibility->pose->vertex;
  um_core_sample_2d(um_core_hash(KEY_POINT, facet), sample, u);
  um_core_sample_triangle(u, w);
  struct um_vec3 a = vertex[c[0]];
  /* from corner a, so that points of a plane facet lie in it to the last place */
  struct um_vec3 p = um_vec3_axpy(a, w[1], um_vec3_sub(vertex[c[1]], a));
  return um_vec3_axpy(p, w[2], um_vec3_sub(vertex[c[2]], a));
}

/* Kronecker sequence with the steps sqrt 2 and sqrt 3 modulo 1 (64-bit fixed point), shifted by
 * key. With those of R2, which lie in a cubic field, they are independent over the rationals: all
 * four together fill the cube evenly (Weyl 1916). */
void um_geometry_sample_second(uint64_t key, uint64_t index, double out[2])
{
  const uint64_t step_x = UINT64_C(0x6a09e667f3bcc908), step_y = UINT64_C(0xbb67ae8584caa73b);
  out[0] = um_core_hash_uniform((index + 1) * step_x + um_core_hash(key, 1));
  out[1] = um_core_hash_uniform((index + 1) * step_y + um_core_hash(key, 2));
}

/* Rays on their way to be traced, with the surface and sample that each belongs to. */
struct batch {
  struct um_geometry_ray ray[BATCH];
  size_t surface[BATCH];
  int sample[BATCH];
  size_t n;
};

/* One evaluation: counts go into seen and lit, divided at the end. */
struct task {
  const struct um_geometry_visibility *visibility;
  struct um_vec3 o;    /* toward the observer */
  struct um_vec3 s;    /* toward the Sun's centre */
  struct um_vec3 t, b; /* complete s to a frame */
  double tangent;      /* of the disc's angular radius */
  double *seen, *lit;  /* [nsurface]; lit NULL: not asked */
  struct batch view, sun;
};

static void push(struct batch *batch, struct um_vec3 origin, struct um_vec3 direction,
                 uint32_t facet, size_t surface, int sample)
{
  size_t i = batch->n++;
  batch->ray[i] = (struct um_geometry_ray){origin, direction, INFINITY, facet};
  batch->surface[i] = surface;
  batch->sample[i] = sample;
}

static struct um_vec3 sun_direction(const struct task *task, uint32_t facet, int sample,
                                    struct um_vec3 normal)
{
  if (!(task->tangent > 0.0)) return task->s;
  double u[2], xy[2];
  um_geometry_sample_second(um_core_hash(KEY_DISC, facet), (uint64_t)sample, u);
  um_core_sample_disc(u, xy);
  struct um_vec3 across =
      um_vec3_axpy(um_vec3_scale(task->t, task->tangent * xy[0]), task->tangent * xy[1], task->b);
  if (um_vec3_dot(normal, task->s) + um_vec3_dot(normal, across) <= 0.0)
    across = um_vec3_scale(across, -1.0);
  return um_vec3_unit(um_vec3_add(task->s, across));
}

static void trace_sun(struct task *task)
{
  uint8_t occluded[BATCH];
  struct batch *sun = &task->sun;
  um_geometry_visibility_occluded_coherent(task->visibility, sun->ray, sun->n, occluded);
  for (size_t i = 0; i < sun->n; i++) task->lit[sun->surface[i]] += occluded[i] ? 0.0 : 1.0;
  sun->n = 0;
}

/* Traces the view rays; those that are free go on to the Sun where the surface faces it. */
static void trace_view(struct task *task)
{
  uint8_t occluded[BATCH];
  struct batch *view = &task->view;
  const struct um_geometry_visibility *v = task->visibility;
  um_geometry_visibility_occluded_coherent(v, view->ray, view->n, occluded);
  for (size_t i = 0; i < view->n; i++) {
    size_t surface = view->surface[i];
    if (occluded[i]) continue;
    task->seen[surface] += 1.0;
    if (task->lit == NULL) continue;
    struct um_vec3 normal = um_geometry_surface_normal(v->mesh, v->pose, surface);
    if (!(um_vec3_dot(normal, task->s) > 0.0)) continue;
    uint32_t facet = view->ray[i].from_facet;
    if (task->sun.n == BATCH) trace_sun(task);
    push(&task->sun, view->ray[i].origin, sun_direction(task, facet, view->sample[i], normal),
         facet, surface, view->sample[i]);
  }
  view->n = 0;
}

static void run(struct task *task, int nsample)
{
  const struct um_geometry_visibility *v = task->visibility;
  const struct um_geometry_mesh *mesh = v->mesh;
  for (size_t s = 0; s < mesh->nsurface; s++) {
    struct um_vec3 normal = um_geometry_surface_normal(mesh, v->pose, s);
    bool faces = um_vec3_dot(normal, task->o) > 0.0;
    bool faces_sun = task->lit != NULL && um_vec3_dot(normal, task->s) > 0.0;
    task->seen[s] = 0.0;
    if (task->lit != NULL) task->lit[s] = 0.0;
    if (!faces) continue;
    if (v->open[s]) {
      task->seen[s] = nsample;
      if (faces_sun) task->lit[s] = nsample;
      continue;
    }
    uint32_t facet = mesh->surface[s].facet;
    for (int k = 0; k < nsample; k++) {
      if (task->view.n == BATCH) trace_view(task);
      push(&task->view, um_geometry_sample_point(v, facet, (uint64_t)k), task->o, facet, s, k);
    }
  }
  trace_view(task);
  if (task->lit != NULL) trace_sun(task);
  for (size_t s = 0; s < mesh->nsurface; s++) {
    task->seen[s] /= nsample;
    if (task->lit != NULL) task->lit[s] /= nsample;
  }
}

void um_geometry_visibility_toward(const struct um_geometry_visibility *visibility,
                                   struct um_vec3 d, int nsample, double *fraction)
{
  assert(nsample >= 1);
  struct task task = {.visibility = visibility, .o = d, .seen = fraction};
  run(&task, nsample < 1 ? 1 : nsample);
}

/* Standard error of a fraction; `exact` where no ray was needed. */
static double standard_error(double f, int nsample, bool exact)
{
  if (exact) return 0.0;
  if (nsample < 2) return 0.5;
  /* e = sqrt(f (1 - f) / (n - 1)) */
  return sqrt(fmax(0.0, f * (1.0 - f)) / (double)(nsample - 1));
}

void um_geometry_visibility_toward_both(const struct um_geometry_visibility *visibility,
                                        struct um_vec3 o, struct um_vec3 s, double radius,
                                        int nsample, double *seen, double *lit, double *seen_error,
                                        double *lit_error)
{
  assert(nsample >= 1);
  if (nsample < 1) nsample = 1;
  struct task task = {.visibility = visibility, .o = o, .s = s, .seen = seen, .lit = lit};
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
