/* Optics of the materials as effects have them at a time, and what that means for the heat of a
 * run. A surface that no effect ages costs nothing: its optics are those of the start. */
#include "model/build/aging_group.h"

#include <string.h>

#include "base/core/constants.h"
#include "model/build/effects_group.h"

enum um_status um_model_materials_at(struct um_context *context, const struct um_model *model,
                                     double t_tai, struct um_materials_adjustment *out)
{
  for (size_t m = 0; m < um_geometry_material_count(model->geometry); m++) {
    const char *name = um_geometry_material_name(model->geometry, m);
    struct um_effect_use use;
    out[m] = um_materials_no_adjustment;
    for (size_t i = 0; um_model_effect_next(model, &i, &use);)
      if (use.effect->hooks.material != NULL)
        UM_TRY(use.effect->hooks.material(context, &use, name, t_tai, &out[m]));
  }
  return UM_OK;
}

static bool any_material_effect(const struct um_model *model)
{
  struct um_effect_use use;
  for (size_t i = 0; um_model_effect_next(model, &i, &use);)
    if (use.effect->hooks.material != NULL) return true;
  return false;
}

enum um_status um_model_materials_over(struct um_context *context, const struct um_model *model,
                                       const struct um_environment_sample *sample, size_t n,
                                       struct um_materials_adjustment **out)
{
  enum um_status status = UM_OK;
  size_t nmaterial = um_geometry_material_count(model->geometry), size = nmaterial * sizeof **out;
  struct um_materials_adjustment *all = NULL;
  bool changes = false;
  *out = NULL;
  if (!any_material_effect(model)) return UM_OK;
  UM_TRY(um_core_allocate(context, n * nmaterial, sizeof *all, &all));
  for (size_t i = 0; i < n; i++) {
    UM_CHECK(um_model_materials_at(context, model, sample[i].t_tai, all + i * nmaterial));
    changes = changes || memcmp(all + i * nmaterial, model->adjustment, size) != 0;
  }
  if (changes) {
    *out = all;
    all = NULL;
  }
done:
  um_core_free(context, all);
  return status;
}

/* One row: what differs from the network's own. */
static enum um_status aging_row(struct um_context *context, const struct um_model *model, double t,
                                struct um_materials_adjustment *now, double *absorptance,
                                double *emittance)
{
  UM_TRY(um_model_materials_at(context, model, t, now));
  for (size_t m = 0; m < um_geometry_material_count(model->geometry); m++) {
    const struct um_materials_record *record = model->material[m];
    const struct um_materials_adjustment *then = &model->adjustment[m];
    double at_start = um_materials_emittance(record, then, UM_REFERENCE_TEMPERATURE);
    double emitted = um_materials_emittance(record, &now[m], UM_REFERENCE_TEMPERATURE);
    absorptance[m] = um_materials_solar_absorptance(record, &now[m]) -
                     um_materials_solar_absorptance(record, then);
    emittance[m] = emitted == at_start ? 1.0 : emitted / at_start;
  }
  return UM_OK;
}

enum um_status um_model_aging_create(struct um_context *context, const struct um_model *model,
                                     const struct um_irradiation_loads *loads,
                                     struct um_model_aging **out)
{
  enum um_status status;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  size_t n = um_geometry_material_count(model->geometry), ntime = loads->ntime;
  struct um_model_aging *aging = NULL;
  struct um_materials_adjustment *now = NULL;
  bool changes = false;
  *out = NULL;
  if (!any_material_effect(model)) return UM_OK;
  UM_TRY(um_core_allocate(context, n, sizeof *now, &now));
  UM_CHECK(um_core_allocate(context, 1, sizeof *aging, &aging));
  UM_CHECK(um_core_allocate(context, ntime * n, sizeof(double), &aging->absorptance));
  UM_CHECK(um_core_allocate(context, ntime * n, sizeof(double), &aging->emittance));
  UM_CHECK(um_core_allocate(context, mesh->nsurface, sizeof(uint32_t), &aging->material));
  for (size_t s = 0; s < mesh->nsurface; s++) aging->material[s] = mesh->surface[s].material;
  for (size_t k = 0; k < ntime; k++) {
    double *absorptance = aging->absorptance + k * n, *emittance = aging->emittance + k * n;
    UM_CHECK(aging_row(context, model, loads->t[k], now, absorptance, emittance));
    for (size_t m = 0; m < n; m++)
      changes = changes || absorptance[m] != 0.0 || emittance[m] != 1.0;
  }
  aging->table = (struct um_thermal_aging){.ntime = ntime,
                                           .nmaterial = n,
                                           .material = aging->material,
                                           .absorptance = aging->absorptance,
                                           .emittance = aging->emittance};
  if (changes) {
    *out = aging;
    aging = NULL;
  }
done:
  um_core_free(context, now);
  um_model_aging_destroy(context, &aging);
  return status;
}

bool um_model_aging_equal(const struct um_model_aging *a, const struct um_model_aging *b)
{
  if (a == NULL || b == NULL) return a == b;
  size_t n = a->table.ntime * a->table.nmaterial;
  return a->table.ntime == b->table.ntime && a->table.nmaterial == b->table.nmaterial &&
         memcmp(a->absorptance, b->absorptance, n * sizeof *a->absorptance) == 0 &&
         memcmp(a->emittance, b->emittance, n * sizeof *a->emittance) == 0;
}

void um_model_aging_destroy(struct um_context *context, struct um_model_aging **aging)
{
  if (aging == NULL || *aging == NULL) return;
  UM_FREE(context, (*aging)->absorptance, (*aging)->emittance, (*aging)->material, *aging);
  *aging = NULL;
}
