/* Geometry precomputations by the instants that are asked for, and what they take. */
#include "geometry/mirror_paths.h"
#include "model/points.h"
#include "model/precompute.h"

enum um_status um_model_precompute_over(struct um_context *context, const struct um_model *model,
                                        const struct um_model_instants *instants,
                                        struct um_model_precomputed **out)
{
  double *times = NULL;
  size_t n = 0;
  if (instants == NULL) return um_model_precompute(context, model, out);
  if (instants->point != NULL)
    return um_model_precompute_points(context, model, instants->point, instants->count,
                                      instants->sampling, out);
  if (instants->time != NULL)
    return um_model_precompute_at(context, model, instants->time, instants->exposure,
                                  instants->count, instants->sampling, out);
  *out = NULL;
  UM_TRY(um_model_scenario_times(context, model, &times, &n));
  enum um_status status =
      um_model_precompute_at(context, model, times, NULL, n, instants->sampling, out);
  um_core_free(context, times);
  return status;
}

/* Tables of a row and surface. */
static size_t loads_bytes(const struct um_irradiation_loads *l)
{
  if (l == NULL) return 0;
  size_t columns = 5;
  if (l->brightness != NULL) columns += 1;
  if (l->gas != NULL) columns += 1;
  if (l->by_cosine != NULL) columns += UM_IRRADIATION_COSINES;
  if (l->planet_moments != NULL) columns += 2 * (size_t)UM_ANGULAR_MOMENTS;
  return l->ntime * l->nsurface * columns * sizeof(float);
}

static size_t view_bytes(const struct um_optics_view *v)
{
  if (v == NULL) return 0;
  size_t lit = v->sun.nrow + v->moon.nrow;
  return v->nsurface * (v->ntime * 4 * sizeof(float) + lit * (2 * sizeof(float) + sizeof(double)));
}

static size_t factors_bytes(const struct um_geometry_view_factor_table *t)
{
  size_t bytes = 0;
  if (t == NULL) return 0;
  for (size_t k = 0; k < t->npose; k++)
    bytes += t->pose[k]->begin[t->pose[k]->npatch] * (sizeof(uint32_t) + sizeof(double));
  return bytes + t->ntime * t->ncorner * (sizeof(uint32_t) + sizeof(double));
}

size_t um_model_precomputed_bytes(const struct um_model_precomputed *p)
{
  size_t mirrored = p->mirrored == NULL
                        ? 0
                        : p->mirrored->begin[p->mirrored->ntime] * sizeof *p->mirrored->sun +
                              p->mirrored->ntime * UM_GEOMETRY_SKY_CELLS * 2 * sizeof(float);
  size_t seen = p->seen != p->loads ? loads_bytes(p->seen) : 0;
  return p->nobs * p->nsub * (sizeof *p->sample + sizeof *p->look) + loads_bytes(p->loads) + seen +
         loads_bytes(p->ripple) + factors_bytes(p->view_factors) + mirrored + view_bytes(p->view) +
         (p->loads != NULL ? p->loads->ntime * sizeof *p->load_sample : 0);
}
