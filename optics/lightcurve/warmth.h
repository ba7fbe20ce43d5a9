/* Light curves of surfaces that grow warmer: what they send is linear in what black bodies send, so
 * that one pass over points and paths serves any number of changes of the temperatures. */
#ifndef UMBRA_OPTICS_WARMTH_H
#define UMBRA_OPTICS_WARMTH_H

#include "optics/radiance/optics.h"

/* Changes of the temperatures, and of the light with them. */
struct um_optics_warmth {
  size_t n;
  /* dT/dp of change k at an instant, out [nsurface] [K per unit of p]; called by many threads */
  void (*warming)(const void *user, size_t k, size_t time, double *out);
  const void *user;
  double *spectral; /* [n][ntime][nbin] out, d(spectral)/dp at the bins of the light curve, emitted
                       straight and by way of other surfaces [W/sr/m per unit of p] */
};
/* The light curve of the scene, as um_optics_lightcurve_compute, and these beside it. */
enum um_status um_optics_lightcurve_warmth(struct um_context *context,
                                           const struct um_optics_scene *scene,
                                           const struct um_optics_band *bands, size_t nband,
                                           const struct um_optics_warmth *warmth,
                                           struct um_optics_lightcurve **out);
/* The light curve that a change [ntime][nbin] of p by `step` makes of one, to first order: all of
 * it stands with what the first material emits. Errors stay. The caller destroys. */
enum um_status um_optics_lightcurve_warmed(struct um_context *context,
                                           const struct um_optics_lightcurve *curve,
                                           const double *spectral, double step,
                                           struct um_optics_lightcurve **out);

#endif
