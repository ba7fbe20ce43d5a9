/* View factors between the surfaces of the satellite, for heat that they exchange, at the joint
 * angles of the loads. */
#include "model/precompute_exchange_impl.h"

#include <math.h>

#include "core/constants.h"

/* [ntime][njoint] angles; one row where no joint moves. */
static enum um_status angles_make(struct um_context *context, const struct um_model *model,
                                  const struct um_environment_sample *samples, size_t ntime,
                                  double **out)
{
  size_t njoint = um_geometry_joint_count(model->geometry);
  UM_TRY(um_core_allocate(context, ntime * njoint, sizeof **out, out));
  for (size_t k = 0; k < ntime; k++)
    um_geometry_joint_angles(model->geometry, um_quat_apply(samples[k].q, samples[k].sun),
                             *out + k * njoint);
  return UM_OK;
}

/* Share of what a group's side emits that goes to space, mean over the poses. */
static void say_leaks(struct um_context *context, const struct um_model *model,
                      const struct um_geometry_view_factor_table *table)
{
  const struct um_geometry_patches *patches = table->patches;
  const struct um_geometry_surface *surface = um_geometry_mesh(model->geometry)->surface;
  for (size_t p = 0, end = 0; p < patches->npatch; p = end) {
    const struct um_geometry_surface *first = &surface[patches->surface[patches->begin[p]]];
    double area = 0.0, space = 0.0, itself = 0.0;
    for (end = p; end < patches->npatch; end++) {
      const struct um_geometry_surface *own = &surface[patches->surface[patches->begin[end]]];
      if (own->group != first->group || own->back != first->back) break;
      area += patches->area[end];
      for (size_t k = 0; k < table->npose; k++) {
        space += table->pose[k]->space[end] / (double)table->npose;
        itself += um_geometry_view_factors_area(table->pose[k], end, end) / (double)table->npose;
      }
    }
    const struct um_geometry_group *group = um_geometry_group(model->geometry, first->group);
    um_core_log(context, UM_LOG_INFO,
                "  %s.%s%s: %.4g m2 before which something stands; of its view %.2f %% is space, "
                "%.2f %% other surfaces, %.2f %% itself",
                um_geometry_part_name(model->geometry, first->part), group->name,
                first->back ? ".back" : "", area, 100.0 * space / area,
                100.0 * (area - space - itself) / area, 100.0 * itself / area);
  }
}

static void say(struct um_context *context, const struct um_model *model,
                const struct um_geometry_view_factor_table *table)
{
  const struct um_geometry_patches *patches = table->patches;
  size_t entries = 0, rays = 0;
  double unclosed = 0.0, residual = 0.0, cut = 0.0;
  if (patches->npatch == 0) return;
  for (size_t k = 0; k < table->npose; k++) {
    const struct um_geometry_view_factors *f = table->pose[k];
    entries += f->begin[f->npatch];
    rays += f->rays;
    unclosed = fmax(unclosed, f->unclosed);
    residual = fmax(residual, f->residual);
    cut = fmax(cut, f->cut);
  }
  um_core_log(
      context, UM_LOG_INFO,
      "view factors: %zu surfaces in %zu patches, %zu pairs in %zu pose%s by %zu rays; row "
      "sums within %.2g of 1 as sampled, %.1g closed; the cut-off leaves out at most %.1g of "
      "a row",
      patches->begin[patches->npatch], patches->npatch, entries, table->npose,
      table->npose == 1 ? "" : "s", rays, unclosed, residual, cut);
  if (table->step > 0.0)
    um_core_log(
        context, UM_LOG_INFO,
        "view factors: poses %.3g deg apart; between them the largest error of one is about "
        "%.2g",
        table->step / UM_DEG, table->interpolation);
  say_leaks(context, model, table);
}

enum um_status um_model_view_factors(struct um_context *context, const struct um_model *model,
                                     const double *angles, size_t ntime,
                                     struct um_geometry_view_factor_table **out)
{
  const struct um_scenario_thermal *thermal = model->scenario->thermal;
  struct um_geometry_view_factor_options options;
  um_geometry_view_factor_defaults(&options);
  options.rays = (size_t)thermal->view_factor_rays;
  return um_geometry_view_factor_table_create(context, model->geometry, angles, ntime,
                                              (size_t)thermal->exchange_patches, &options, out);
}

enum um_status um_model_precompute_view_factors(struct um_context *context,
                                                const struct um_model *model,
                                                const struct um_environment_sample *samples,
                                                size_t n, struct um_model_precomputed *precomputed)
{
  enum um_status status;
  size_t ntime = um_geometry_joint_moves(model->geometry) ? n : 1;
  double *angles = NULL;
  UM_CHECK(angles_make(context, model, samples, ntime, &angles));
  UM_CHECK(um_model_view_factors(context, model, angles, ntime, &precomputed->view_factors));
  say(context, model, precomputed->view_factors);
done:
  um_core_free(context, angles);
  return status;
}
