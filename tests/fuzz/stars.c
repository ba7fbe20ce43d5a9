/* A table of stars, of which a small scenario's sensor is calibrated. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "evidence/inversion/photometry.h"
#include "model/build/build.h"
#include "tests/fuzz/fuzz.h"

static const char text[] =
    "schema: 1\n"
    "name: stars\n"
    "time: {start_utc: 2016-03-20T04:30:00Z, stop_utc: 2016-03-20T04:30:20Z, step_s: 10}\n"
    "orbit: {fixed: {position_gcrs_km: [42000, 0, 0]}}\n"
    "attitude: [{fixed: {q_gcrs: [1, 0, 0, 0]}}]\n"
    "observer: {station: {latitude_deg: 47, longitude_deg: 15}, air: {profile: us_standard}}\n"
    "parts:\n"
    "  - {name: wing, plate: {size_m: [2, 1]}, front: grey, back: grey, lumped: true,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000}}\n"
    "thermal: {orbits_before: 0, start: isothermal}\n"
    "bands: {vis: {from_um: 0.4, to_um: 0.7, bins: 3}}\n"
    "sensors: {eye: {band: vis, aperture_m: 0.3}}\n";

/* Built once, of memory that no allocation of an input counts. */
static const struct um_model *scenario(void)
{
  static struct um_context *own;
  static struct um_model *model;
  const struct um_model_options options = {0};
  if (model != NULL) return model;
  setenv("UMBRA_DATA", UMBRA_SOURCE_DIR "/tests/fuzz/data", 1);
  if (um_core_context_create(NULL, &own) != UM_OK ||
      um_model_create(own, um_fuzz_file(1, text, strlen(text)), &options, &model) != UM_OK) {
    fprintf(stderr, "fuzz: %s\n", own != NULL ? um_core_message(own) : "no context");
    exit(EXIT_FAILURE);
  }
  return model;
}

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  const struct um_model *model = scenario();
  for (int known = 0; known < 2; known++) {
    struct um_instrument_calibration c;
    const char *path = um_fuzz_file(0, data, size);
    if (!um_fuzz_good(context, um_compare_calibration_read(context, model, 0, path,
                                                           known ? 0.2 : (double)NAN, &c)))
      continue;
    double relative, factor = um_instrument_calibration_factor(&c, 1.0, &relative);
    if (!(c.kappa > 0.0)) um_fuzz_finding("a factor of %g", c.kappa);
    um_fuzz_finite(c.kappa, "a factor");
    um_fuzz_finite(c.kappa_sigma, "the error of a factor");
    um_fuzz_finite(c.extinction, "an extinction");
    um_fuzz_finite(c.extinction_sigma, "the error of an extinction");
    um_fuzz_finite(c.chi2, "a chi-square");
    um_fuzz_finite(factor + relative, "a factor at an airmass");
  }
}
