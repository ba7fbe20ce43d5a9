/* From material records to how surfaces depend on angle and temperature: ratios of the record's
 * absorptance and emittance, effects included, to those that the heat network states (normal
 * incidence, 300 K). Grey records and withheld effects have none. */
#include "model/build/steps_impl.h"

#include <math.h>

#include "base/core/constants.h"

/* The Earth's own radiation is taken as that of a black body of `earth` [K]; all that is absorbed
 * of it by angle is over what is absorbed of light from all sides, times law->planet. */
static void planet_by_angle(const struct um_materials_record *record,
                            const struct um_materials_adjustment *adjustment, double earth,
                            struct um_thermal_surface_law *law)
{
  double value[UM_THERMAL_LAW_ANGLES];
  double mean = um_materials_emittance(record, adjustment, earth);
  if (!(mean > 0.0)) return;
  um_materials_emittance_by_angle(record, adjustment, earth, UM_THERMAL_LAW_ANGLES, value);
  for (size_t i = 0; i < UM_THERMAL_LAW_ANGLES; i++) value[i] *= law->planet / mean;
  um_environment_angular_project(value, UM_THERMAL_LAW_ANGLES, law->planet_angle);
}

static void by_angle(const struct um_materials_record *record,
                     const struct um_materials_adjustment *adjustment,
                     struct um_thermal_surface_law *law)
{
  double normal = um_materials_solar_absorptance(record, adjustment);
  if (!(normal > 0.0)) return;
  for (size_t i = 0; i < UM_THERMAL_LAW_ANGLES; i++) {
    double u = (double)i / (UM_THERMAL_LAW_ANGLES - 1);
    law->absorptance[i] = um_materials_solar_absorptance_toward(record, adjustment, u * u) / normal;
  }
  law->albedo = um_materials_solar_absorptance_diffuse(record, adjustment) / normal;
  um_environment_angular_project(law->absorptance, UM_THERMAL_LAW_ANGLES, law->albedo_angle);
  law->by_angle = true;
}

static void by_temperature(const struct um_materials_record *record,
                           const struct um_materials_adjustment *adjustment, double earth,
                           struct um_thermal_surface_law *law)
{
  const double step = UM_THERMAL_LAW_HOTTEST / (UM_THERMAL_LAW_TEMPERATURES - 1);
  double stated = um_materials_emittance(record, adjustment, UM_REFERENCE_TEMPERATURE);
  if (!(stated > 0.0)) return;
  for (size_t i = 0; i < UM_THERMAL_LAW_TEMPERATURES; i++)
    law->emittance[i] =
        um_materials_emittance(record, adjustment, fmax((double)i, 0.5) * step) / stated;
  law->planet = um_materials_emittance(record, adjustment, earth) / stated;
}

enum um_status um_model_build_surface_laws(struct um_context *context, struct um_model *model)
{
  const struct um_environment *environment = &model->environment;
  size_t n = um_geometry_material_count(model->geometry);
  /* the Earth radiates as a black body of (OLR / sigma)^(1/4) */
  double earth = environment->emittance_by_temperature
                     ? sqrt(sqrt(environment->outgoing_longwave / UM_STEFAN_BOLTZMANN))
                     : UM_REFERENCE_TEMPERATURE;
  UM_TRY(um_core_arena_allocate(context, &model->memory, n, sizeof *model->surface_law,
                                &model->surface_law));
  for (size_t m = 0; m < n; m++) {
    const struct um_materials_record *record = model->material[m];
    struct um_thermal_surface_law *law = NULL;
    bool temperature = environment->emittance_by_temperature;
    if (um_materials_is_grey(record) || !(environment->absorptance_by_angle || temperature))
      continue;
    UM_TRY(um_core_arena_allocate(context, &model->memory, 1, sizeof *law, &law));
    law->albedo = law->planet = 1.0;
    for (size_t i = 0; i < UM_THERMAL_LAW_ANGLES; i++) law->absorptance[i] = 1.0;
    for (size_t i = 0; i < UM_THERMAL_LAW_TEMPERATURES; i++) law->emittance[i] = 1.0;
    if (environment->absorptance_by_angle) by_angle(record, &model->adjustment[m], law);
    if (temperature) by_temperature(record, &model->adjustment[m], earth, law);
    if (law->by_angle) planet_by_angle(record, &model->adjustment[m], earth, law);
    model->surface_law[m] = law;
  }
  return UM_OK;
}
