/* What the tests of reflectivity maps share: a scenario of given parts, about the Earth at 765 km
 * through its shadow, seen along a fixed direction, in sunlight alone. */
#ifndef UMBRA_TESTS_MODEL_MAP_HELP_H
#define UMBRA_TESTS_MODEL_MAP_HELP_H

#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "model/build/build.h"
#include "model/products/reflectivity.h"
#include "model/products/reflectivity_pass.h"
#include "tests/support/cmocka_all.h"

#define MAP_SCENARIO "map_scenario.yaml"

/* Grey: rho_d 0.2; the same under a lobe of F 0.6 and alpha 0.05. */
static const char *const map_records[][2] = {
    {"map_lambert.yaml",
     "name: lambert\nsummary: s\ncitation: c\n"
     "grey: {solar_absorptance: 0.8, emittance: 0.8, vis_reflectance_diffuse: 0.2}\n"},
    {"map_glossy.yaml",
     "name: glossy\nsummary: s\ncitation: c\n"
     "grey: {solar_absorptance: 0.2, emittance: 0.2, vis_reflectance_diffuse: 0.2, "
     "specular_reflectance: 0.6, beckmann_alpha: 0.05}\n"}};

static inline void map_put(const char *name, const char *text)
{
  FILE *f = fopen(name, "w");
  assert_non_null(f);
  fputs(text, f);
  assert_int_equal(fclose(f), 0);
}

/* A scenario with these lines under `parts:`; attitude: a law, or NULL for body axes in GCRS. */
static inline struct um_model *map_model(struct um_context *context, const char *parts,
                                         const char *attitude)
{
  struct um_model *model = NULL;
  char text[4096];
  snprintf(text, sizeof text,
           "schema: 1\nname: map\n"
           "time: {start_utc: 2016-03-20T04:30:00Z, stop_utc: 2016-03-20T06:10:00Z, step_s: 60, "
           "light_time: false}\n"
           "orbit: {circular: {altitude_km: 765, beta_deg: 20}}\n"
           "attitude: [%s]\n"
           "observer: {direction: {unit_gcrs: [0.5, 0.7, 0.51], range_km: 1000}}\n"
           "environment: {sun: frozen, sun_distance_au: 1}\n"
           "material_files: [map_lambert.yaml, map_glossy.yaml]\n"
           "parts:\n%s"
           "thermal: {start: isothermal, orbits_before: 0}\n"
           "bands: {vis: {from_um: 0.38, to_um: 0.78, bins: 8}, red: {from_um: 0.6, to_um: 0.7, "
           "bins: 2}}\n"
           "effects: [{effect: earthshine, off: true}, {effect: reflected_earth_ir, off: true}]\n",
           attitude != NULL ? attitude : "{fixed: {q_gcrs: [1, 0, 0, 0]}}", parts);
  for (size_t i = 0; i < 2; i++) map_put(map_records[i][0], map_records[i][1]);
  map_put(MAP_SCENARIO, text);
  if (um_model_create(context, MAP_SCENARIO, NULL, &model) != UM_OK)
    fail_msg("%s", um_core_message(context));
  remove(MAP_SCENARIO);
  for (size_t i = 0; i < 2; i++) remove(map_records[i][0]);
  return model;
}

#define MAP_SHELL "shell: {areal_heat_capacity_J_m2_K: 3000}, lumped: true"

#endif
