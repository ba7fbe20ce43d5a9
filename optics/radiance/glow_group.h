/* How what surfaces send to the observer grows with their temperatures, at one instant. Private to
 * the rooms of optics/. */
#ifndef UMBRA_OPTICS_GLOW_GROUP_H
#define UMBRA_OPTICS_GLOW_GROUP_H

#include "optics/radiance/radiance_group.h"

/* What the observer sees of every surface's black body, straight and by way of others, in some
 * bins. Of one thread. */
struct um_optics_glow {
  double *weight;  /* [nsurface][nbin] emissivity, area and throughput [m^2] */
  bool *has;       /* [nsurface] is any of its row not 0? */
  double *row;     /* [2][nbin] scratch */
  double *warming; /* [nsurface] scratch of who sums */
  size_t nsurface, nbin;
};
enum um_status um_optics_glow_create(struct um_context *context, size_t nsurface,
                                     const struct um_optics_spectra *spectra,
                                     struct um_optics_glow *out);
/* After a failure of create, too. */
void um_optics_glow_clear(struct um_context *context, struct um_optics_glow *glow);
/* All rows become 0. */
void um_optics_glow_reset(struct um_optics_glow *glow);
/* The row of a surface, for who adds to it. */
static inline double *um_optics_glow_of(struct um_optics_glow *glow, size_t surface)
{
  glow->has[surface] = true;
  return glow->weight + surface * glow->nbin;
}
/* The weights become those of a kelvin, times dB/dT at temperature[nsurface], in steps of half a
 * kelvin: 1e-4 of it at 150 K and 8 um [W/sr/m/K]. */
void um_optics_glow_warm(struct um_optics_glow *glow, const struct um_optics_spectra *spectra,
                         const double *temperature);

#endif
