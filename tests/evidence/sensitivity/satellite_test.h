/* A satellite on which every effect has a target. */
#ifndef UMBRA_TESTS_SENSITIVITY_SATELLITE_TEST_H
#define UMBRA_TESTS_SENSITIVITY_SATELLITE_TEST_H

#include "tests/evidence/sensitivity/forward_test.h"

/* The small satellite with a box in MLI, a wing on a joint and a camera whose pixels fill, so that
 * everything has a target. */
#define MORE                                                                                       \
  "  - name: box\n"                                                                                \
  "    box: {size_m: [0.5, 0.5, 0.5]}\n"                                                           \
  "    pose: {position_m: [0, -2, 0]}\n"                                                           \
  "    outside: mli_kapton\n"                                                                      \
  "    shell: {material: aluminium_bare, thickness_mm: 1.2}\n"                                     \
  "    mli: {effective_emittance: 0.02, areal_heat_capacity_J_m2_K: 50}\n"                         \
  "    creases: {tilt_rms_deg: 2, patch_m: 0.1}\n"                                                 \
  "    lumped: true\n"                                                                             \
  "  - name: wing\n"                                                                               \
  "    plate: {size_m: [1, 1]}\n"                                                                  \
  "    pose: {position_m: [3, 0, 0]}\n"                                                            \
  "    joint: {axis: [0, 1, 0], angle_deg: 20}\n"                                                  \
  "    front: grey_panel\n"                                                                        \
  "    back: aluminium_bare\n"                                                                     \
  "    flatness: {tilt_rms_deg: 2, patch_m: 0.3}\n"                                                \
  "    shell: {areal_heat_capacity_J_m2_K: 2000, through_conductance_W_m2_K: 50}\n"                \
  "    lumped: true\n"                                                                             \
  "thermal:"

#define CAMERA                                                                                     \
  "sensors:\n"                                                                                     \
  "  camera: {band: vis, aperture_m: 0.3, pixel_arcsec: 1, exposure_s: 1, saturation_e: 300}\n"

static inline void put_satellite(void)
{
  char text[8192];
  const char *thermal = strstr(scenario_text, "thermal:");
  put_world("");
  snprintf(text, sizeof text, "%.*s" MORE "%s" CONTACTS CAMERA, (int)(thermal - scenario_text),
           scenario_text, thermal + strlen("thermal:"));
  put(SCENARIO, text);
  put_measured("count_rate,camera,1e5,1e5,0");
}

#endif
