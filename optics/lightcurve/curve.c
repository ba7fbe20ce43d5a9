/* A light curve as arrays: made, moved to first order, freed. */
#include "optics/lightcurve/curve_impl.h"

#include <string.h>

#include "optics/lightcurve/warmth.h"

static enum um_status curve_allocate(struct um_context *context, struct um_optics_lightcurve *c)
{
  size_t ntime = c->ntime;
  UM_TRY(um_core_allocate(context, c->nbin, sizeof *c->wavelength, &c->wavelength));
  UM_TRY(um_core_allocate(context, c->nbin, sizeof *c->width, &c->width));
  UM_TRY(um_core_allocate(context, c->nbin, sizeof *c->transmission, &c->transmission));
  UM_TRY(um_core_allocate(context, c->nbin, sizeof *c->band, &c->band));
  UM_TRY(um_core_allocate(context, ntime * c->nbin * UM_MECHANISM_COUNT, sizeof *c->spectral,
                          &c->spectral));
  UM_TRY(um_core_allocate(context, ntime * c->nband * c->nmaterial * UM_MECHANISM_COUNT,
                          sizeof *c->intensity, &c->intensity));
  UM_TRY(um_core_allocate(context, ntime * c->nband, sizeof *c->stderr_, &c->stderr_));
  UM_TRY(
      um_core_allocate(context, ntime * c->nband, sizeof *c->between_stderr, &c->between_stderr));
  return UM_OK;
}

enum um_status um_optics_curve_create(struct um_context *context,
                                      const struct um_optics_spectra *spectra, size_t ntime,
                                      struct um_optics_lightcurve *c)
{
  *c = (struct um_optics_lightcurve){.ntime = ntime,
                                     .nband = spectra->nband,
                                     .nbin = spectra->nbin,
                                     .nmaterial = spectra->nmaterial};
  UM_TRY(curve_allocate(context, c));
  memcpy(c->wavelength, spectra->wavelength, c->nbin * sizeof *c->wavelength);
  memcpy(c->width, spectra->width, c->nbin * sizeof *c->width);
  memcpy(c->transmission, spectra->transmission, c->nbin * sizeof *c->transmission);
  memcpy(c->band, spectra->band, c->nbin * sizeof *c->band);
  return UM_OK;
}

enum um_status um_optics_lightcurve_warmed(struct um_context *context,
                                           const struct um_optics_lightcurve *curve,
                                           const double *spectral, double step,
                                           struct um_optics_lightcurve **out)
{
  struct um_optics_lightcurve *c = NULL;
  size_t n = curve->ntime * curve->nbin, per_band = curve->nmaterial * UM_MECHANISM_COUNT,
         nvalue = curve->ntime * curve->nband;
  enum um_status status;
  UM_CHECK(um_core_allocate(context, 1, sizeof *c, &c));
  *c = (struct um_optics_lightcurve){.ntime = curve->ntime,
                                     .nband = curve->nband,
                                     .nbin = curve->nbin,
                                     .nmaterial = curve->nmaterial};
  UM_CHECK(curve_allocate(context, c));
  memcpy(c->wavelength, curve->wavelength, c->nbin * sizeof *c->wavelength);
  memcpy(c->width, curve->width, c->nbin * sizeof *c->width);
  memcpy(c->transmission, curve->transmission, c->nbin * sizeof *c->transmission);
  memcpy(c->band, curve->band, c->nbin * sizeof *c->band);
  memcpy(c->spectral, curve->spectral, n * UM_MECHANISM_COUNT * sizeof *c->spectral);
  memcpy(c->intensity, curve->intensity, nvalue * per_band * sizeof *c->intensity);
  memcpy(c->stderr_, curve->stderr_, nvalue * sizeof *c->stderr_);
  memcpy(c->between_stderr, curve->between_stderr, nvalue * sizeof *c->between_stderr);
  for (size_t i = 0; i < n; i++) {
    size_t time = i / c->nbin, b = i % c->nbin;
    double change = step * spectral[i];
    c->spectral[i * UM_MECHANISM_COUNT + UM_MECHANISM_EMITTED] += change;
    c->intensity[(time * c->nband + c->band[b]) * per_band + UM_MECHANISM_EMITTED] +=
        change * c->transmission[b] * c->width[b];
  }
  *out = c;
  c = NULL;
done:
  um_optics_lightcurve_destroy(context, &c);
  return status;
}

void um_optics_lightcurve_destroy(struct um_context *context, struct um_optics_lightcurve **curve)
{
  if (curve == NULL || *curve == NULL) return;
  struct um_optics_lightcurve *c = *curve;
  void *const blocks[] = {c->wavelength, c->width,     c->transmission, c->band,
                          c->spectral,   c->intensity, c->stderr_,      c->between_stderr};
  for (size_t i = 0; i < sizeof blocks / sizeof blocks[0]; i++) um_core_free(context, blocks[i]);
  um_core_free(context, c);
  *curve = NULL;
}
