/* Geometry of sight: what the observer sees of each surface and what of that the Sun lights. */
#include <math.h>
#include <omp.h>

#include "base/core/constants.h"
#include "optics/paths/posed_scenes_group.h"
#include "optics/radiance/radiance_group.h"

static enum um_status check_number(struct um_context *context, int nsample)
{
  if (nsample >= 1 && nsample <= UM_OPTICS_SAMPLES_MAX) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "%d points per facet; accepted: 1 to %d", nsample,
                      UM_OPTICS_SAMPLES_MAX);
}

static enum um_status check(struct um_context *context, const struct um_environment_sample *samples,
                            size_t ntime, int nsample)
{
  UM_TRY(check_number(context, nsample));
  for (size_t t = 0; t < ntime; t++) {
    double observer = um_vec3_norm(samples[t].to_observer), sun = um_vec3_norm(samples[t].sun);
    if (!(fabs(observer - 1.0) < 1e-6))
      return um_core_fail(context, UM_ERR_INPUT,
                          "sample %zu: direction to the observer has length %g; accepted: 1", t,
                          observer);
    if (!(fabs(sun - 1.0) < 1e-6))
      return um_core_fail(context, UM_ERR_INPUT,
                          "sample %zu: direction to the Sun has length %g; accepted: 1", t, sun);
    if (!(samples[t].sun_distance > UM_SOLAR_RADIUS))
      return um_core_fail(context, UM_ERR_INPUT,
                          "sample %zu: distance to the Sun %g m; accepted: above %g m", t,
                          samples[t].sun_distance, UM_SOLAR_RADIUS);
  }
  return UM_OK;
}

static enum um_status lit_create(struct um_context *context, size_t nrow, size_t nsurface,
                                 struct um_optics_lit *lit)
{
  size_t all = nrow * nsurface;
  lit->nrow = nrow;
  UM_TRY(um_core_allocate(context, all, sizeof *lit->share, &lit->share));
  UM_TRY(um_core_allocate(context, all, sizeof *lit->error, &lit->error));
  UM_TRY(um_core_allocate(context, all, sizeof *lit->cosine, &lit->cosine));
  return um_core_allocate(context, all, sizeof *lit->cos_half, &lit->cos_half);
}

/* Rows of the instants that have a Moon. */
static enum um_status moon_create(struct um_context *context,
                                  const struct um_environment_sample *samples,
                                  struct um_optics_view *view)
{
  size_t nrow = 0;
  UM_TRY(um_core_allocate(context, view->ntime, sizeof *view->moon_row, &view->moon_row));
  for (size_t t = 0; t < view->ntime; t++)
    view->moon_row[t] = samples[t].moon_distance > 0.0 ? nrow++ : SIZE_MAX;
  return lit_create(context, nrow, view->nsurface, &view->moon);
}

static enum um_status view_create(struct um_context *context, const struct um_geometry_mesh *mesh,
                                  const struct um_environment_sample *samples, size_t ntime,
                                  uint64_t seed, struct um_optics_view *view)
{
  size_t n = mesh->nsurface, all = ntime * n;
  if (n != 0 && ntime > SIZE_MAX / n)
    return um_core_fail(context, UM_ERR_MEMORY, "out of memory: %zu times of %zu surfaces", ntime,
                        n);
  view->ntime = ntime;
  view->nsurface = n;
  view->seed = seed;
  UM_TRY(um_core_allocate(context, ntime, sizeof *view->nsample, &view->nsample));
  UM_TRY(um_core_allocate(context, ntime, sizeof *view->path_factor, &view->path_factor));
  for (size_t t = 0; t < ntime; t++) view->path_factor[t] = 1;
  UM_TRY(um_core_allocate(context, all, sizeof *view->seen, &view->seen));
  UM_TRY(um_core_allocate(context, all, sizeof *view->seen_error, &view->seen_error));
  UM_TRY(um_core_allocate(context, all, sizeof *view->cos_observer, &view->cos_observer));
  UM_TRY(lit_create(context, ntime, n, &view->sun));
  UM_TRY(moon_create(context, samples, view));
  UM_TRY(um_core_allocate(context, all, sizeof *view->cos_nadir, &view->cos_nadir));
  UM_TRY(um_core_allocate(context, n, sizeof *view->area, &view->area));
  UM_TRY(um_core_allocate(context, n, sizeof *view->material, &view->material));
  UM_TRY(um_core_allocate(context, n, sizeof *view->part, &view->part));
  for (size_t s = 0; s < n; s++) {
    view->area[s] = mesh->area[mesh->surface[s].facet];
    view->material[s] = mesh->surface[s].material;
    view->part[s] = mesh->surface[s].part;
  }
  return UM_OK;
}

/* How surfaces stand to a lamp, into a row. */
static void turn_to(const struct um_geometry_mesh *mesh, const struct um_optics_posed_scene *posed,
                    struct um_vec3 observer, struct um_vec3 lamp, size_t row,
                    struct um_optics_lit *out)
{
  struct um_vec3 half = um_vec3_add(observer, lamp);
  double length = um_vec3_norm(half);
  half = um_vec3_scale(half, length > 1e-9 ? 1.0 / length : 0.0);
  for (size_t i = 0; i < mesh->nsurface; i++) {
    struct um_vec3 normal = um_geometry_surface_normal(mesh, posed->pose, i);
    out->cosine[row * mesh->nsurface + i] = (float)um_vec3_dot(normal, lamp);
    out->cos_half[row * mesh->nsurface + i] = um_vec3_dot(normal, half);
  }
}

/* What a lamp lights, into a row, and with it what the observer sees. scratch [4][nsurface]. */
static void trace_lamp(const struct um_optics_posed_scene *posed, struct um_vec3 observer,
                       struct um_vec3 lamp, double radius, size_t time, size_t row, double *scratch,
                       const struct um_optics_view *view, struct um_optics_lit *out)
{
  size_t n = view->nsurface;
  double *seen = scratch, *lit = seen + n, *seen_error = lit + n, *lit_error = seen_error + n;
  um_geometry_visibility_toward_both(posed->visibility, observer, lamp, radius, view->nsample[time],
                                     view->seed, seen, lit, seen_error, lit_error);
  for (size_t i = 0; i < n; i++) {
    out->share[row * n + i] = (float)lit[i];
    out->error[row * n + i] = (float)lit_error[i];
    view->seen[time * n + i] = (float)seen[i];
    view->seen_error[time * n + i] = (float)seen_error[i];
  }
}

/* scratch [4][nsurface]; once for each time */
static void trace_time(const struct um_geometry_mesh *mesh,
                       const struct um_optics_posed_scene *posed,
                       const struct um_environment_sample *sample, int nsample, double *scratch,
                       size_t time, struct um_optics_view *view)
{
  size_t n = mesh->nsurface, row = view->moon_row[time];
  view->nsample[time] = nsample;
  struct um_vec3 o = um_quat_apply(sample->q, sample->to_observer);
  struct um_vec3 sun = um_quat_apply(sample->q, sample->sun);
  struct um_vec3 moon = um_quat_apply(sample->q, sample->moon);
  struct um_vec3 nadir = um_optics_nadir(sample);
  turn_to(mesh, posed, o, sun, time, &view->sun);
  for (size_t i = 0; i < n; i++) {
    struct um_vec3 normal = um_geometry_surface_normal(mesh, posed->pose, i);
    view->cos_observer[time * n + i] = (float)um_vec3_dot(normal, o);
    view->cos_nadir[time * n + i] = (float)um_vec3_dot(normal, nadir);
  }
  if (row != SIZE_MAX) {
    turn_to(mesh, posed, o, moon, row, &view->moon);
    trace_lamp(posed, o, moon, um_environment_moon_radius(sample->moon_distance), time, row,
               scratch, view, &view->moon);
    if (!(sample->sunlit_fraction > 0.0 || sample->scattered > 0.0))
      return; /* a Sun that does not shine needs no rays */
  }
  trace_lamp(posed, o, sun, asin(UM_SOLAR_RADIUS / sample->sun_distance), time, time, scratch, view,
             &view->sun);
}

/* Times whose number of points is not nsample[time] yet. */
static enum um_status trace_all(struct um_context *context, const struct um_geometry *geometry,
                                const struct um_environment_sample *samples, const int *nsample,
                                struct um_optics_posed_scenes *scenes, double *scratch,
                                struct um_optics_view *view)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(geometry);
  for (size_t from = 0; from < view->ntime; from += UM_OPTICS_BLOCK) {
    size_t count = view->ntime - from < UM_OPTICS_BLOCK ? view->ntime - from : UM_OPTICS_BLOCK;
    UM_TRY(um_optics_posed_scenes_prepare(context, geometry, samples + from, count, 0, scenes));
#pragma omp parallel for schedule(dynamic, 1) num_threads(um_core_context_threads(context))
    for (size_t i = 0; i < count; i++)
      if (nsample[from + i] != view->nsample[from + i])
        trace_time(mesh, &scenes->posed[scenes->of_time[i]], &samples[from + i], nsample[from + i],
                   scratch + (size_t)omp_get_thread_num() * 4 * mesh->nsurface, from + i, view);
    UM_TRY(um_core_progress_step(context, count));
    UM_TRY(um_core_stop_check(context, "lines of sight were traced"));
  }
  return UM_OK;
}

enum um_status um_optics_view_trace(struct um_context *context, const struct um_geometry *geometry,
                                    const struct um_environment_sample *samples, size_t ntime,
                                    int nsample, uint64_t seed, struct um_optics_view **out)
{
  enum um_status status;
  struct um_optics_view *view = NULL;
  int *all = NULL;
  *out = NULL;
  UM_TRY(check(context, samples, ntime, nsample));
  UM_CHECK(um_core_allocate(context, ntime, sizeof *all, &all));
  for (size_t t = 0; t < ntime; t++) all[t] = nsample;
  UM_CHECK(um_core_allocate(context, 1, sizeof *view, &view));
  UM_CHECK(view_create(context, um_geometry_mesh(geometry), samples, ntime, seed, view));
  UM_CHECK(um_optics_view_retrace(context, geometry, samples, all, view));
  *out = view;
  view = NULL;
done:
  um_core_free(context, all);
  um_optics_view_destroy(context, &view);
  return status;
}

enum um_status um_optics_view_retrace(struct um_context *context,
                                      const struct um_geometry *geometry,
                                      const struct um_environment_sample *samples,
                                      const int *nsample, struct um_optics_view *view)
{
  enum um_status status;
  struct um_optics_posed_scenes *scenes = NULL;
  double *scratch = NULL;
  size_t nthread = (size_t)um_core_context_threads(context);
  for (size_t t = 0; t < view->ntime; t++) UM_TRY(check_number(context, nsample[t]));
  UM_CHECK(um_core_allocate(context, 1, sizeof *scenes, &scenes));
  UM_CHECK(um_core_allocate(context, nthread * 4 * view->nsurface, sizeof *scratch, &scratch));
  um_core_progress_begin(context, "tracing lines of sight", view->ntime);
  status = trace_all(context, geometry, samples, nsample, scenes, scratch, view);
  um_core_progress_end(context);
done:
  if (scenes != NULL) um_optics_posed_scenes_clear(context, scenes);
  UM_FREE(context, scenes, scratch);
  return status;
}

void um_optics_view_destroy(struct um_context *context, struct um_optics_view **view)
{
  if (view == NULL || *view == NULL) return;
  struct um_optics_view *v = *view;
  void *const blocks[] = {v->seen,        v->seen_error,   v->cos_observer, v->cos_nadir,
                          v->area,        v->material,     v->part,         v->nsample,
                          v->path_factor, v->moon_row,     v->sun.share,    v->sun.error,
                          v->sun.cosine,  v->sun.cos_half, v->moon.share,   v->moon.error,
                          v->moon.cosine, v->moon.cos_half};
  for (size_t i = 0; i < sizeof blocks / sizeof blocks[0]; i++) um_core_free(context, blocks[i]);
  um_core_free(context, v);
  *view = NULL;
}
