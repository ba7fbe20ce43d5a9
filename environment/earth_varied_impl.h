/* An Earth that differs from place to place, as it is seen from one place above it; private to the
 * environment. */
#ifndef UMBRA_ENVIRONMENT_EARTH_VARIED_IMPL_H
#define UMBRA_ENVIRONMENT_EARTH_VARIED_IMPL_H

#include "environment/earth_view_impl.h"
#include "environment/ground_view.h"

#define UM_EARTH_VARIED_RINGS  16
#define UM_EARTH_VARIED_AROUND 32
#define UM_EARTH_VARIED_CELLS  (UM_EARTH_VARIED_RINGS * UM_EARTH_VARIED_AROUND)

struct um_environment_varied {
  double albedo, longwave; /* means over the cap, as a plate that faces nadir sees them */
  double brightness;       /* the same [K] */
  /* of a cell */
  double x[UM_EARTH_VARIED_CELLS], y[UM_EARTH_VARIED_CELLS], z[UM_EARTH_VARIED_CELLS]; /* unit, from
                                                                            the satellite */
  double solid_angle[UM_EARTH_VARIED_CELLS];                                           /* [sr] */
  double of_albedo[UM_EARTH_VARIED_CELLS]; /* (a - mean) max(cos SZA, 0) dOmega [sr] */
  double of_planet[UM_EARTH_VARIED_CELLS]; /* (M - mean)/pi dOmega [W/m^2] */
  double window[UM_EARTH_VARIED_CELLS];    /* spectral radiance at UM_EARTH_WINDOW, times dOmega
                                              [W/m^2/m] */
};

/* view: of the same place. */
void um_environment_varied_make(const struct um_environment_earth_view *view,
                                const struct um_environment_ground_view *ground,
                                struct um_environment_varied *out);
/* What a plate gets beyond what the uniform Earth of the means would send: albedo in units of S/pi
 * [sr], planet [W/m^2]; and the brightness temperature of what it sees [K]. */
void um_environment_varied_plate(const struct um_environment_varied *varied, struct um_vec3 normal,
                                 double *albedo, double *planet, double *brightness);
/* Adds to moments what differs from the uniform Earth of the means, in those units. */
void um_environment_varied_moments(const struct um_environment_varied *varied,
                                   struct um_vec3 normal,
                                   struct um_environment_earth_moments *moments);

#endif
