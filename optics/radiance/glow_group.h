/* How what surfaces send to the observer grows with their temperatures, at one instant. Private to
 * the rooms of optics/. */
#ifndef UMBRA_OPTICS_GLOW_GROUP_H
#define UMBRA_OPTICS_GLOW_GROUP_H

#include "optics/radiance/radiance_group.h"

/* d(intensity)/dT of every surface [W/sr/m/K] in some bins. Of one thread. */
struct um_optics_glow {
  double *slope; /* [nsurface][nbin] */
  bool *has;     /* [nsurface] is any of its row not 0? */
  double *row;   /* [2][nbin] scratch */
  double *share; /* [nbin] scratch of who adds */
  size_t nsurface, nbin;
};
enum um_status um_optics_glow_create(struct um_context *context, size_t nsurface,
                                     const struct um_optics_spectra *spectra,
                                     struct um_optics_glow *out);
/* After a failure of create, too. */
void um_optics_glow_clear(struct um_context *context, struct um_optics_glow *glow);
/* All rows become 0. */
void um_optics_glow_reset(struct um_optics_glow *glow);
/* The row of `surface` grows by `area` [m^2] times share[nbin] (NULL: 1) times dB/dT at its
 * temperature, in steps of half a kelvin: 1e-4 of it at 150 K and 8 um. */
void um_optics_glow_add(struct um_optics_glow *glow, const struct um_optics_spectra *spectra,
                        size_t surface, double temperature, double area, const double *share);

#endif
