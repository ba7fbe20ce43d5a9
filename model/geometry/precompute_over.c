/* Geometry tables by the instants that are asked for, and what they take. */
#include "geometry/mirror_paths.h"
#include "model/geometry/body_tables.h"
#include "model/geometry/bounds_impl.h"
#include "model/geometry/compatible.h"
#include "model/geometry/points_impl.h"
#include "model/geometry/precompute.h"
#include "model/geometry/precompute_group.h"

enum um_status um_model_precompute_at(struct um_context *context, const struct um_model *model,
                                      const double *times, const double *exposures, size_t ntime,
                                      struct um_model_sampling sampling,
                                      struct um_model_tables **out)
{
  const struct um_model_instants instants = {
      .time = times, .exposure = exposures, .count = ntime, .sampling = sampling};
  return um_model_precompute_with(context, model, &instants, NULL, out);
}

enum um_status um_model_precompute(struct um_context *context, const struct um_model *model,
                                   struct um_model_tables **out)
{
  return um_model_precompute_with(context, model, NULL, NULL, out);
}

static enum um_status trace(struct um_context *context, const struct um_model *model,
                            const struct um_model_instants *instants,
                            struct um_model_body_tables *body, struct um_model_tables **out)
{
  if (instants != NULL && instants->point != NULL)
    return um_model_precompute_points_with(context, model, instants, body, out);
  return um_model_precompute_with(context, model, instants, body, out);
}

enum um_status um_model_precompute_over(struct um_context *context, const struct um_model *model,
                                        const struct um_model_instants *instants,
                                        struct um_model_tables **out)
{
  return trace(context, model, instants, NULL, out);
}

enum um_status um_model_precompute_unposed(struct um_context *context, const struct um_model *model,
                                           const struct um_model_instants *instants,
                                           struct um_model_tables **out)
{
  if (instants->point != NULL) return um_model_points_plan(context, model, instants, out);
  return um_model_precompute_observed(context, model, instants, out);
}

enum um_status um_model_precompute_like(struct um_context *context, const struct um_model *made,
                                        const struct um_model_tables *like,
                                        const struct um_model *model,
                                        const struct um_model_instants *instants,
                                        struct um_model_tables **out)
{
  bool compatible;
  *out = NULL;
  UM_TRY(um_model_body_is_compatible(context, made, model, &compatible));
  return trace(context, model, instants, compatible ? like->body : NULL, out);
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

size_t um_model_tables_bytes(const struct um_model_tables *p, const struct um_model_tables *like)
{
  bool shared = like != NULL && like->body == p->body;
  size_t mirrored = p->mirrored == NULL
                        ? 0
                        : p->mirrored->begin[p->mirrored->ntime] * sizeof *p->mirrored->sun +
                              p->mirrored->ntime * UM_GEOMETRY_SKY_CELLS * 2 * sizeof(float);
  size_t seen = p->seen != p->loads ? loads_bytes(p->seen) : 0;
  return p->nobs * p->nsub * (sizeof *p->sample + sizeof *p->look) + loads_bytes(p->loads) + seen +
         loads_bytes(p->spin_variation) + mirrored + view_bytes(p->view) +
         (shared ? 0 : um_irradiation_sky_bytes(p->body->sky) + factors_bytes(p->view_factors)) +
         (p->loads != NULL ? p->loads->ntime * sizeof *p->load_sample : 0);
}
