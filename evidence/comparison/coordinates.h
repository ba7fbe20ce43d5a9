/* Physical coordinates of observations: what a residual may depend on. */
#ifndef UMBRA_COMPARE_COORDINATES_H
#define UMBRA_COMPARE_COORDINATES_H

#include "model/build/model.h"
#include "model/geometry/tables.h"

struct um_compare_coordinate {
  char *name;    /* with unit, as in the header of residuals.csv: "elevation_deg" */
  bool circular; /* 0 and 1 are the same */
  double *value; /* [nobs]; NaN where it has no meaning */
};
struct um_compare_coordinates {
  size_t nobs, count;
  struct um_compare_coordinate *coordinate; /* [count] */
};

/* Of the instant nearest mid-exposure, as far as the scenario has them:
 *   time_s                     since the first observation
 *   azimuth_deg, elevation_deg, range_km, airmass, sun_elevation_deg (twilight, background)
 *   phase_angle_deg            Sun - satellite - observer
 *   moon_separation_deg        between satellite and Moon in the observer's sky (background)
 *   sunlit_fraction
 *   since_shadow_entry_s, since_shadow_exit_s
 *                              since the centre of the Sun's disc last crossed the limb, in the
 *                              satellite's time; NaN before the first crossing that is known
 *   spin_phase                 of the spin law that holds, turns since its at_utc plus its
 *                              phase_deg, in [0, 1); of the scenario's law, without its effects
 *   albedo_W_m2, earth_view    incident reflected sunlight and view factor to the Earth, mean over
 *                              the surfaces
 *   sun_on.MATERIAL_W_m2       incident direct sunlight, mean over the material's surfaces
 * UM_ERR_MEMORY. The caller destroys. */
enum um_status um_compare_coordinates_create(struct um_context *context,
                                             const struct um_model *model,
                                             const struct um_model_tables *tables,
                                             struct um_compare_coordinates **out);
void um_compare_coordinates_destroy(struct um_context *context,
                                    struct um_compare_coordinates **coordinates);

#endif
