/* Geometry of sight: what the observer sees of each surface and what of that the Sun lights. */
#include <math.h>
#include <omp.h>

#include "core/constants.h"
#include "optics/stage_impl.h"

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

static enum um_status view_create(struct um_context *context, const struct um_geometry_mesh *mesh,
                                  size_t ntime, uint64_t seed, struct um_optics_view *view)
{
  size_t n = mesh->nsurface, all = ntime * n;
  if (n != 0 && ntime > SIZE_MAX / n)
    return um_core_fail(context, UM_ERR_MEMORY, "out of memory: %zu times of %zu surfaces", ntime,
                        n);
  view->ntime = ntime;
  view->nsurface = n;
  view->seed = seed;
  UM_TRY(um_core_allocate(context, ntime, sizeof *view->nsample, &view->nsample));
  UM_TRY(um_core_allocate(context, all, sizeof *view->seen, &view->seen));
  UM_TRY(um_core_allocate(context, all, sizeof *view->lit, &view->lit));
  UM_TRY(um_core_allocate(context, all, sizeof *view->seen_error, &view->seen_error));
  UM_TRY(um_core_allocate(context, all, sizeof *view->lit_error, &view->lit_error));
  UM_TRY(um_core_allocate(context, all, sizeof *view->cos_observer, &view->cos_observer));
  UM_TRY(um_core_allocate(context, all, sizeof *view->cos_sun, &view->cos_sun));
  UM_TRY(um_core_allocate(context, all, sizeof *view->cos_half, &view->cos_half));
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

struct um_vec3 um_optics_nadir(const struct um_environment_sample *sample)
{
  double r = um_vec3_norm(sample->r);
  if (!(r > 0.0)) return um_vec3(0.0, 0.0, 0.0);
  return um_quat_apply(sample->q, um_vec3_scale(sample->r, -1.0 / r));
}

/* scratch [4][nsurface]; once for each time */
static void trace_time(const struct um_geometry_mesh *mesh, const struct um_optics_set *set,
                       const struct um_environment_sample *sample, int nsample, double *scratch,
                       size_t time, struct um_optics_view *view)
{
  size_t n = mesh->nsurface;
  view->nsample[time] = nsample;
  struct um_vec3 o = um_quat_apply(sample->q, sample->to_observer);
  struct um_vec3 s = um_quat_apply(sample->q, sample->sun);
  struct um_vec3 half = um_vec3_add(o, s);
  struct um_vec3 nadir = um_optics_nadir(sample);
  double length = um_vec3_norm(half);
  half = um_vec3_scale(half, length > 1e-9 ? 1.0 / length : 0.0);
  double *seen = scratch, *lit = seen + n, *seen_error = lit + n, *lit_error = seen_error + n;
  um_geometry_visibility_toward_both(set->visibility, o, s,
                                     asin(UM_SOLAR_RADIUS / sample->sun_distance), nsample,
                                     view->seed, seen, lit, seen_error, lit_error);
  for (size_t i = 0; i < n; i++) {
    size_t at = time * n + i;
    struct um_vec3 normal = um_geometry_surface_normal(mesh, set->pose, i);
    view->seen[at] = (float)seen[i];
    view->lit[at] = (float)lit[i];
    view->seen_error[at] = (float)seen_error[i];
    view->lit_error[at] = (float)lit_error[i];
    view->cos_observer[at] = (float)um_vec3_dot(normal, o);
    view->cos_sun[at] = (float)um_vec3_dot(normal, s);
    view->cos_half[at] = um_vec3_dot(normal, half);
    view->cos_nadir[at] = (float)um_vec3_dot(normal, nadir);
  }
}

/* Times whose number of points is not nsample[time] yet. */
static enum um_status trace_all(struct um_context *context, const struct um_geometry *geometry,
                                const struct um_environment_sample *samples, const int *nsample,
                                struct um_optics_stage *stage, double *scratch,
                                struct um_optics_view *view)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(geometry);
  for (size_t from = 0; from < view->ntime; from += UM_OPTICS_BLOCK) {
    size_t count = view->ntime - from < UM_OPTICS_BLOCK ? view->ntime - from : UM_OPTICS_BLOCK;
    UM_TRY(um_optics_stage_prepare(context, geometry, samples + from, count, 0, stage));
#pragma omp parallel for schedule(dynamic, 1) num_threads(um_core_context_threads(context))
    for (size_t i = 0; i < count; i++)
      if (nsample[from + i] != view->nsample[from + i])
        trace_time(mesh, &stage->set[stage->of_time[i]], &samples[from + i], nsample[from + i],
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
  UM_CHECK(view_create(context, um_geometry_mesh(geometry), ntime, seed, view));
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
  struct um_optics_stage *stage = NULL;
  double *scratch = NULL;
  size_t nthread = (size_t)um_core_context_threads(context);
  for (size_t t = 0; t < view->ntime; t++) UM_TRY(check_number(context, nsample[t]));
  UM_CHECK(um_core_allocate(context, 1, sizeof *stage, &stage));
  UM_CHECK(um_core_allocate(context, nthread * 4 * view->nsurface, sizeof *scratch, &scratch));
  um_core_progress_begin(context, "tracing lines of sight", view->ntime);
  status = trace_all(context, geometry, samples, nsample, stage, scratch, view);
  um_core_progress_end(context);
done:
  if (stage != NULL) um_optics_stage_clear(context, stage);
  um_core_free(context, stage);
  um_core_free(context, scratch);
  return status;
}

void um_optics_view_destroy(struct um_context *context, struct um_optics_view **view)
{
  if (view == NULL || *view == NULL) return;
  struct um_optics_view *v = *view;
  void *const blocks[] = {v->seen,         v->lit,     v->seen_error, v->lit_error,
                          v->cos_observer, v->cos_sun, v->cos_half,   v->area,
                          v->material,     v->part,    v->cos_nadir,  v->nsample};
  for (size_t i = 0; i < sizeof blocks / sizeof blocks[0]; i++) um_core_free(context, blocks[i]);
  um_core_free(context, v);
  *view = NULL;
}
