/* View factors between the surfaces of the satellite, for heat that they exchange, at the joint
 * angles of the loads. */
#include "model/geometry/precompute_exchange_impl.h"

#include <math.h>

#include "base/core/constants.h"
#include "base/core/file.h"
#include "base/core/suggestions.h"
#include "geometry/inside.h"
#include "model/build/view_factors_group.h"
#include "model/geometry/body_tables.h"
#include "model/geometry/mirrors.h"
#include "model/scenario/fail_group.h"

/* [ntime][njoint] angles; one row where no joint moves. */
static enum um_status angles_make(struct um_context *context, const struct um_model *model,
                                  const struct um_environment_sample *samples, size_t ntime,
                                  double **out)
{
  size_t njoint = um_geometry_joint_count(model->geometry);
  UM_TRY(um_core_allocate(context, ntime * njoint, sizeof **out, out));
  for (size_t k = 0; k < ntime; k++)
    um_geometry_joint_angles(model->geometry, um_quat_apply(samples[k].q, samples[k].sun),
                             samples[k].t_tai, *out + k * njoint);
  return UM_OK;
}

/* Share of what a group's side emits that goes to space, mean over the poses. */
static void say_leaks(struct um_context *context, const struct um_model *model,
                      const struct um_geometry_view_factor_table *table)
{
  const struct um_geometry_patches *patches = table->patches;
  const struct um_geometry_surface *surface = um_geometry_mesh(model->geometry)->surface;
  for (size_t p = 0, end = 0; p < table->noutside; p = end) {
    const struct um_geometry_surface *first = &surface[patches->surface[patches->begin[p]]];
    double area = 0.0, space = 0.0, itself = 0.0;
    for (end = p; end < table->noutside; end++) {
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

/* What sees what inside. */
static void say_rooms(struct um_context *context, const struct um_model *model,
                      const struct um_geometry_view_factor_table *table)
{
  for (size_t k = 0; k < table->nroom; k++) {
    const struct um_geometry_room *room = &table->room[k];
    const struct um_geometry_view_factors *f = room->factors;
    const size_t *begin = table->patches->begin + room->first;
    um_core_log(
        context, UM_LOG_INFO,
        "view factors inside %s: %zu facets in %zu patches, %zu pairs by %zu rays; row sums "
        "within %.2g of 1 as sampled, %.1g closed; nothing leaks to space",
        um_geometry_part_name(model->geometry, room->part), begin[f->npatch] - begin[0], f->npatch,
        f->begin[f->npatch], f->rays, f->unclosed, f->residual);
  }
}

static void say(struct um_context *context, const struct um_model *model,
                const struct um_geometry_view_factor_table *table)
{
  const struct um_geometry_patches *patches = table->patches;
  size_t entries = 0, rays = 0;
  double unclosed = 0.0, residual = 0.0, cut = 0.0;
  say_rooms(context, model, table);
  if (table->noutside == 0) return;
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
      patches->begin[table->noutside], table->noutside, entries, table->npose,
      table->npose == 1 ? "" : "s", rays, unclosed, residual, cut);
  if (table->step > 0.0)
    um_core_log(
        context, UM_LOG_INFO,
        "view factors: poses %.3g deg apart; between them the largest error of one is about "
        "%.2g",
        table->step / UM_DEG, table->interpolation);
  say_leaks(context, model, table);
}

bool um_model_room(const struct um_model *model, uint32_t part, size_t *limit)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  const struct um_scenario_part *parts = model->scenario->parts.items;
  size_t f = 0;
  while (f < mesh->nfacet && mesh->facet_part[f] != part) f++;
  if (f == mesh->nfacet ||
      um_thermal_network_surface(model->body->network, um_geometry_inner_surface(mesh, f)) == NULL)
    return false;
  *limit = parts[part].lumped ? 0 : (size_t)model->scenario->thermal->exchange_patches;
  return true;
}

static bool rooms_equal(const struct um_model *a, const struct um_model *b)
{
  if (a->scenario->parts.count != b->scenario->parts.count) return false;
  for (uint32_t p = 0; p < a->scenario->parts.count; p++) {
    size_t x = 0, y = 0;
    if (um_model_room(a, p, &x) != um_model_room(b, p, &y) || x != y) return false;
  }
  return true;
}

bool um_model_exchange_options_equal(const struct um_model *a, const struct um_model *b)
{
  const struct um_scenario_thermal *x = a->scenario->thermal, *y = b->scenario->thermal;
  return x->view_factor_rays == y->view_factor_rays && x->exchange_patches == y->exchange_patches &&
         um_core_words_same(x->view_factors, y->view_factors) &&
         um_core_words_same(a->scenario->at.file, b->scenario->at.file) && rooms_equal(a, b);
}

/* Parts whose network has inner surfaces. */
static enum um_status add_rooms(struct um_context *context, const struct um_model *model,
                                const struct um_geometry_view_factor_options *options,
                                struct um_geometry_view_factor_table *table)
{
  for (uint32_t p = 0; p < model->scenario->parts.count; p++) {
    size_t limit;
    if (um_model_room(model, p, &limit))
      UM_TRY(um_geometry_inside_add(context, model->geometry, p, limit, options, table));
  }
  return UM_OK;
}

/* The outside at joint angles, and the rooms. */
static enum um_status make_table(struct um_context *context, const struct um_model *model,
                                 const double *angles, size_t ntime,
                                 struct um_geometry_view_factor_table **out)
{
  const struct um_scenario_thermal *thermal = model->scenario->thermal;
  struct um_geometry_view_factor_options options = um_model_view_factor_options(context, model);
  char *import = NULL;
  enum um_status status = UM_OK;
  if (thermal->view_factors != NULL)
    UM_TRY(um_core_path_resolve(context, model->scenario->at.file, thermal->view_factors, &import));
  struct um_geometry_mirrors *mirrors = NULL;
  options.import = import;
  UM_CHECK(um_model_mirrors_create(context, model, &mirrors));
  options.mirrors = mirrors;
  UM_CHECK(um_geometry_view_factor_table_create(context, model->geometry, angles, ntime,
                                                (size_t)thermal->exchange_patches, &options, out));
  /* whether mutual radiation is on or not: a variant of the model may switch it */
  UM_CHECK(add_rooms(context, model, &options, *out));
done:
  um_geometry_mirrors_destroy(context, &mirrors);
  um_core_free(context, import);
  if (status == UM_OK || thermal->view_factors == NULL) return status;
  return um_model_blame(context, &thermal->at, "view_factors", status);
}

enum um_status um_model_precompute_view_factors(struct um_context *context,
                                                const struct um_model *model,
                                                const struct um_environment_sample *samples,
                                                size_t n, struct um_model_tables *tables)
{
  enum um_status status = UM_OK;
  size_t ntime = um_geometry_joint_moves(model->geometry) ? n : 1;
  struct um_geometry_view_factor_table **table = &tables->body->view_factors;
  double *angles = NULL;
  if (*table == NULL) {
    UM_CHECK(angles_make(context, model, samples, ntime, &angles));
    UM_CHECK(make_table(context, model, angles, ntime, table));
    say(context, model, *table);
  }
  tables->view_factors = *table;
done:
  um_core_free(context, angles);
  return status;
}
