/* Emission is linear in what black bodies send, times a weight that no temperature is in. */
#include "optics/radiance/glow_group.h"

#include <string.h>

#define HALF 0.25 /* of the step in temperature [K] */

enum um_status um_optics_glow_create(struct um_context *context, size_t nsurface,
                                     const struct um_optics_spectra *spectra,
                                     struct um_optics_glow *out)
{
  *out = (struct um_optics_glow){.nsurface = nsurface, .nbin = spectra->nbin};
  UM_TRY(um_core_allocate(context, nsurface, out->nbin * sizeof *out->weight, &out->weight));
  UM_TRY(um_core_allocate(context, nsurface, sizeof *out->has, &out->has));
  UM_TRY(um_core_allocate(context, nsurface, sizeof *out->warming, &out->warming));
  return um_core_allocate(context, 2 * out->nbin, sizeof *out->row, &out->row);
}

void um_optics_glow_clear(struct um_context *context, struct um_optics_glow *glow)
{
  UM_FREE(context, glow->weight, glow->has, glow->row, glow->warming);
}

void um_optics_glow_reset(struct um_optics_glow *glow)
{
  for (size_t s = 0; s < glow->nsurface; s++) {
    if (glow->has[s]) memset(glow->weight + s * glow->nbin, 0, glow->nbin * sizeof *glow->weight);
    glow->has[s] = false;
  }
}

void um_optics_glow_warm(struct um_optics_glow *glow, const struct um_optics_spectra *spectra,
                         const double *temperature)
{
  double *low = glow->row, *high = low + glow->nbin;
  for (size_t s = 0; s < glow->nsurface; s++) {
    double *to = glow->weight + s * glow->nbin;
    if (!glow->has[s]) continue;
    um_optics_spectra_planck(spectra, temperature[s] - HALF, low);
    um_optics_spectra_planck(spectra, temperature[s] + HALF, high);
    for (size_t b = 0; b < glow->nbin; b++) to[b] *= (high[b] - low[b]) / (2.0 * HALF);
  }
}
