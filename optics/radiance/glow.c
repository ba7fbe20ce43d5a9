/* Emission is linear in dB/dT times a weight that no temperature is in. */
#include "optics/radiance/glow_group.h"

#include <string.h>

#define HALF 0.25 /* of the step in temperature [K] */

enum um_status um_optics_glow_create(struct um_context *context, size_t nsurface,
                                     const struct um_optics_spectra *spectra,
                                     struct um_optics_glow *out)
{
  *out = (struct um_optics_glow){.nsurface = nsurface, .nbin = spectra->nbin};
  UM_TRY(um_core_allocate(context, nsurface, out->nbin * sizeof *out->slope, &out->slope));
  UM_TRY(um_core_allocate(context, nsurface, sizeof *out->has, &out->has));
  UM_TRY(um_core_allocate(context, out->nbin, sizeof *out->share, &out->share));
  return um_core_allocate(context, 2 * out->nbin, sizeof *out->row, &out->row);
}

void um_optics_glow_clear(struct um_context *context, struct um_optics_glow *glow)
{
  UM_FREE(context, glow->slope, glow->has, glow->row, glow->share);
}

void um_optics_glow_reset(struct um_optics_glow *glow)
{
  for (size_t s = 0; s < glow->nsurface; s++) {
    if (glow->has[s]) memset(glow->slope + s * glow->nbin, 0, glow->nbin * sizeof *glow->slope);
    glow->has[s] = false;
  }
}

void um_optics_glow_add(struct um_optics_glow *glow, const struct um_optics_spectra *spectra,
                        size_t surface, double temperature, double area, const double *share)
{
  double *to = glow->slope + surface * glow->nbin, *low = glow->row, *high = low + glow->nbin;
  um_optics_spectra_planck(spectra, temperature - HALF, low);
  um_optics_spectra_planck(spectra, temperature + HALF, high);
  area /= 2.0 * HALF;
  for (size_t b = 0; b < glow->nbin; b++)
    to[b] += area * (share != NULL ? share[b] : 1.0) * (high[b] - low[b]);
  glow->has[surface] = true;
}
