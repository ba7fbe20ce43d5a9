/* Honeycomb panels as walls: two faces of thickness f, a core of height L between them,
 *
 *   C = 2 f rho c + rho_c c_c L,   k t = 2 f k + 0.47 (rho_c / rho_f) k_f L,
 *   U = (rho_c / rho_f) k_f / L,
 *
 * rho_c density of the core, rho_f and k_f of its foil: heat crosses a core along its foils, whose
 * share of the area is the ratio of the densities (Swann and Pittman 1961, NASA TN D-714; the
 * radiation from cell to cell that they add is 1 % in aluminium and left out). Of hexagonal cells
 * with doubled walls along the ribbon the conduction is as 8/3 through, 3/2 along and 1 across
 * (Gilmore 2002, ch. 8), in the mean 0.47 of that through. */
#include "model/build/steps_impl.h"

#include <math.h>

#include "model/scenario/fail_group.h"

#define IN_PLANE (1.25 / (8.0 / 3.0))

static enum um_status bulk_of(struct um_context *context, const struct um_model *model,
                              const struct um_scenario_honeycomb *from, const char *name,
                              struct um_materials_bulk *out)
{
  *out = um_materials_bulk(um_materials_library_find(model->library, name));
  if (!isnan(out->density) && !isnan(out->specific_heat) && !isnan(out->conductivity)) return UM_OK;
  return um_document_mark_fail(context, &from->at,
                               "material '%s' has no density, specific heat or conductivity; "
                               "accepted: a material that has them",
                               name);
}

/* Numbers that the shell states itself stay. */
enum um_status um_model_build_honeycomb(struct um_context *context, struct um_model *model,
                                        const struct um_scenario_shell *shell,
                                        struct um_thermal_shell *to)
{
  const struct um_scenario_honeycomb *from = shell->honeycomb;
  const char *foil = from->core_material != NULL ? from->core_material : from->material;
  struct um_materials_bulk face, core;
  if (shell->material != NULL || !isnan(shell->thickness_mm))
    return um_model_fail(context, &shell->at, shell->material != NULL ? "material" : "thickness_mm",
                         "excludes honeycomb; accepted: one of the two");
  UM_TRY(bulk_of(context, model, from, from->material, &face));
  UM_TRY(bulk_of(context, model, from, foil, &core));
  double f = from->face_mm * 1e-3, height = from->core_mm * 1e-3;
  double solid = from->core_density_kg_m3 / core.density; /* share of foil in the core [1] */
  if (!(solid < 1.0))
    return um_model_fail(context, &from->at, "core_density_kg_m3",
                         "%g is not below that of the foil, %g; accepted: less",
                         from->core_density_kg_m3, core.density);
  bool heat = isnan(to->areal_heat_capacity), plane = isnan(to->conductance);
  if (heat)
    to->areal_heat_capacity = 2.0 * f * face.density * face.specific_heat +
                              from->core_density_kg_m3 * core.specific_heat * height;
  if (plane)
    to->conductance = 2.0 * f * face.conductivity + IN_PLANE * solid * core.conductivity * height;
  if (isnan(shell->through_conductance_W_m2_K))
    to->through_conductance = solid * core.conductivity / height;
  if (from->core_material != NULL) return UM_OK; /* of two materials: as at 300 K */
  const struct um_materials_record *record =
      um_materials_library_find(model->library, from->material);
  if (heat)
    UM_TRY(um_model_bulk_ratio(context, model, record, UM_BULK_SPECIFIC_HEAT, &to->law.capacity));
  if (!plane) return UM_OK;
  return um_model_bulk_ratio(context, model, record, UM_BULK_CONDUCTIVITY, &to->law.conductivity);
}
