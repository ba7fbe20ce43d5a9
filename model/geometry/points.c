/* Observations without a track (orbit.points): every measurement says where the satellite is. */
#include "model/geometry/points.h"
#include "model/geometry/points_impl.h"
#include "model/geometry/posed.h"

#include <math.h>

#include "model/build/messages_group.h"
#include "model/geometry/body_tables.h"
#include "model/geometry/line_of_sight_impl.h"
#include "model/geometry/precompute.h"
#include "model/geometry/precompute_group.h"

static enum um_status check_points(struct um_context *context, const struct um_model *model,
                                   const struct um_model_point *points, size_t n)
{
  if (!model->points)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: the scenario has an orbit; accepted: orbit.points for observations "
                        "that stand alone",
                        model->scenario->at.file);
  if (n == 0) return um_core_fail(context, UM_ERR_INPUT, "no observations");
  for (size_t k = 1; k < n; k++)
    if (!(points[k].t >= points[k - 1].t))
      return um_core_fail(context, UM_ERR_INPUT,
                          "observation %zu is earlier than the one before it", k + 1);
  return UM_OK;
}

static enum um_status trace_points(struct um_context *context, const struct um_model *model,
                                   const struct um_model_instants *instants,
                                   struct um_model_tables *tables)
{
  const struct um_model_point *points = instants->point;
  size_t n = tables->nobs;
  UM_TRY(um_model_tables_keep_sets(context, instants, tables));
  UM_TRY(um_core_allocate(context, n, sizeof(double), &tables->t_obs));
  UM_TRY(um_core_allocate(context, n, sizeof(double), &tables->sunlit));
  UM_TRY(um_core_allocate(context, n, sizeof *tables->look, &tables->look));
  UM_TRY(um_core_allocate(context, n, sizeof *tables->sample, &tables->sample));
  UM_TRY(um_core_allocate(context, n, sizeof *tables->station, &tables->station));
  for (size_t k = 0; k < n; k++) {
    struct um_model_point point = points[k];
    point.t = um_model_true_time(model, um_model_instant_set(instants, k), point.t);
    UM_TRY(um_model_sample_point(context, model, &point, &tables->sample[k], &tables->look[k]));
    tables->t_obs[k] = points[k].t;
    tables->station[k] = points[k].station;
    tables->sunlit[k] = tables->sample[k].sunlit_fraction;
  }
  tables->t_first = tables->t_start = tables->t_periodic_end = tables->sample[0].t_tai;
  return UM_OK;
}

enum um_status um_model_points_plan(struct um_context *context, const struct um_model *model,
                                    const struct um_model_instants *instants,
                                    struct um_model_tables **out)
{
  enum um_status status;
  struct um_model_tables *tables = NULL;
  *out = NULL;
  UM_TRY(check_points(context, model, instants->point, instants->count));
  UM_TRY(um_core_allocate(context, 1, sizeof *tables, &tables));
  *tables =
      (struct um_model_tables){.nobs = instants->count, .nsub = 1, .points = true, .period = NAN};
  UM_CHECK(trace_points(context, model, instants, tables));
  UM_CHECK(um_model_tables_hide(context, model, tables));
done:
  if (status != UM_OK) um_model_tables_destroy(context, &tables);
  *out = tables;
  return status;
}

enum um_status um_model_precompute_points_with(struct um_context *context,
                                               const struct um_model *model,
                                               const struct um_model_instants *instants,
                                               struct um_model_body_tables *body,
                                               struct um_model_tables **out)
{
  enum um_status status;
  struct um_model_tables *tables = NULL;
  *out = NULL;
  UM_CHECK(um_model_points_plan(context, model, instants, &tables));
  tables->body = um_model_body_tables_share(body);
  UM_CHECK(um_model_precompute_posed(context, model, instants->sampling, false, tables));
done:
  status = um_model_blame_table(context, model, status);
  if (status != UM_OK) um_model_tables_destroy(context, &tables);
  *out = tables;
  return status;
}

enum um_status um_model_precompute_points(struct um_context *context, const struct um_model *model,
                                          const struct um_model_point *points, size_t npoint,
                                          struct um_model_sampling sampling,
                                          struct um_model_tables **out)
{
  const struct um_model_instants instants = {
      .point = points, .count = npoint, .sampling = sampling};
  return um_model_precompute_points_with(context, model, &instants, NULL, out);
}
