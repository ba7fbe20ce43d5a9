/* --step, --phase-angles, --planes and --tolerance. */
#include "app/map_options.h"

#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/number.h"

#define STEP_LEAST      0.1 /* [deg] */
#define TOLERANCE_LEAST 1e-3

static int misuse(const char *what)
{
  fprintf(stderr, "umbra: %s\n", what);
  return UM_APP_MISUSE;
}

/* "0,30,60" into radians, rising; false for anything else. */
static bool phase_angles(const char *text, struct um_app_map_options *out)
{
  const char *at = text;
  for (out->grid.nphase = 0; out->grid.nphase < UM_APP_MAP_PHASES;) {
    char number[32];
    double degrees, last = -1.0;
    size_t n = strcspn(at, ",");
    if (n >= sizeof number) return false;
    memcpy(number, at, n);
    number[n] = '\0';
    if (out->grid.nphase > 0) last = out->phase_angle[out->grid.nphase - 1] / UM_DEG;
    if (!um_core_number_parse(number, &degrees) || !(degrees >= 0.0 && degrees < 180.0) ||
        !(degrees > last))
      return false;
    out->phase_angle[out->grid.nphase++] = degrees * UM_DEG;
    if (at[n] == '\0') return true;
    at += n + 1;
  }
  return false;
}

int um_app_map_options_parse(const struct um_app_options *options, double default_step,
                             struct um_app_map_options *out)
{
  double step = default_step, tolerance = UM_APP_MAP_TOLERANCE;
  if (options->step != NULL && !um_core_number_parse(options->step, &step))
    return misuse("--step takes a number [deg]");
  if (!(step >= STEP_LEAST && step <= 90.0 && fabs(90.0 / step - round(90.0 / step)) < 1e-6))
    return misuse("--step takes a part of 90 deg, from 0.1 to 90");
  if (!phase_angles(options->phase_angles != NULL ? options->phase_angles : UM_APP_MAP_PHASE_ANGLES,
                    out))
    return misuse("--phase-angles takes up to 64 numbers with commas between, from 0 to below 180 "
                  "deg, rising");
  if (options->map_tolerance != NULL && !um_core_number_parse(options->map_tolerance, &tolerance))
    return misuse("--tolerance takes a number [1]");
  if (!(tolerance == 0.0 || (tolerance >= TOLERANCE_LEAST && tolerance <= 1.0)))
    return misuse("--tolerance takes 0, which refines nothing, or 0.001 to 1");
  out->grid.tolerance = tolerance;
  out->grid.step = step * UM_DEG;
  out->grid.phase_angle = out->phase_angle;
  out->grid.nplane = options->planes > 0 ? (size_t)options->planes : UM_APP_MAP_PLANES;
  return UM_APP_DONE;
}
