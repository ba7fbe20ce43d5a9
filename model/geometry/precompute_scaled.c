/* Geometry tables of a model under sunlight and an Earth of other levels. */
#include <string.h>

#include "model/geometry/body_tables.h"
#include "model/geometry/compatible.h"
#include "model/geometry/precompute.h"
#include "model/geometry/precompute_group.h"

/* What stands at the observed instants and rows. */
static enum um_status rows_copy(struct um_context *context, const struct um_model_tables *like,
                                struct um_model_tables *tables)
{
  size_t n = like->nobs * like->nsub, ntime = like->loads->ntime;
  UM_TRY(um_core_allocate(context, n, sizeof *tables->load_row, &tables->load_row));
  UM_TRY(um_core_allocate(context, ntime, sizeof *tables->load_sample, &tables->load_sample));
  memcpy(tables->load_row, like->load_row, n * sizeof *tables->load_row);
  memcpy(tables->load_sample, like->load_sample, ntime * sizeof *tables->load_sample);
  return UM_OK;
}

static enum um_status loads_scale(struct um_context *context, const struct um_model_tables *like,
                                  const struct um_irradiation_levels *by,
                                  struct um_model_tables *tables)
{
  UM_TRY(um_irradiation_loads_scaled(context, like->loads, by, &tables->loads));
  if (like->seen == like->loads)
    tables->seen = tables->loads;
  else
    UM_TRY(um_irradiation_loads_scaled(context, like->seen, by, &tables->seen));
  if (like->spin_variation != NULL)
    UM_TRY(um_irradiation_loads_scaled(context, like->spin_variation, by, &tables->spin_variation));
  if (like->mirrored != NULL)
    UM_TRY(um_irradiation_mirrored_scaled(context, like->mirrored, by, &tables->mirrored));
  return rows_copy(context, like, tables);
}

enum um_status um_model_precompute_scaled(struct um_context *context, const struct um_model *made,
                                          const struct um_model_tables *like,
                                          const struct um_model *model,
                                          const struct um_model_instants *instants,
                                          struct um_model_tables **out)
{
  enum um_status status;
  struct um_model_precompute_plan plan = {0};
  struct um_model_sampling sampling = {0, 0};
  struct um_irradiation_levels levels;
  bool proportional;
  *out = NULL;
  UM_TRY(um_model_loads_are_proportional(context, made, like, instants, model, &levels,
                                         &proportional));
  if (!proportional) return UM_OK;
  if (instants != NULL) sampling = instants->sampling;
  UM_CHECK(um_model_precompute_plan(context, model, instants, &plan));
  plan.tables->body = um_model_body_tables_share(like->body);
  plan.tables->view_factors = like->view_factors;
  UM_CHECK(loads_scale(context, like, &levels, plan.tables));
  UM_CHECK(um_model_precompute_view(context, model, sampling, plan.tables));
  *out = plan.tables;
  plan.tables = NULL;
done:
  um_model_precompute_plan_clear(context, &plan);
  return status;
}
