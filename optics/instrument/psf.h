/* Point spread functions: how light of a point is spread over the sky by optics and air. */
#ifndef UMBRA_INSTRUMENT_PSF_H
#define UMBRA_INSTRUMENT_PSF_H

#include <stddef.h>

#include "base/core/context.h"

#define UM_INSTRUMENT_SEEING_BETA 4.765 /* of the Moffat function nearest to turbulence */

enum um_instrument_psf_kind {
  UM_PSF_GAUSSIAN, /* fwhm */
  UM_PSF_MOFFAT,   /* fwhm, beta */
  UM_PSF_AIRY,     /* diffraction of a round aperture: diffraction, obstruction */
  UM_PSF_TABLE     /* radius, value: piecewise linear, 0 beyond */
};
struct um_instrument_psf {
  enum um_instrument_psf_kind kind;
  double fwhm;        /* [arcsec] */
  double beta;        /* above 1 [1] */
  double diffraction; /* lambda/D [arcsec] */
  double obstruction; /* diameter, of the aperture's [1] */
  size_t n;
  double *radius, *value; /* [n] [arcsec], [1/arcsec^2] with an integral of 1 */
};

/* Per solid angle at a distance from the middle [arcsec], integral 1 [1/arcsec^2]. */
double um_instrument_psf_at(const struct um_instrument_psf *psf, double radius);
/* Share of the light within a circle [arcsec]: Gaussian 1 - 2^(-4 q^2) for a radius of q FWHM;
 * Moffat 1 - (1 + r^2/a^2)^(1-beta); Airy 1 - J_0^2(v) - J_1^2(v), v = pi r D/lambda (Rayleigh
 * 1881), with an obstruction by quadrature to 1e-7. */
double um_instrument_psf_encircled(const struct um_instrument_psf *psf, double radius);

/* FWHM of a long exposure through turbulence [arcsec]: 0.976 lambda/r0 (Fried 1966; Tokovinin 2002,
 * PASP 114:1156), r0 [m] being stated at 500 nm and the zenith and growing as lambda^(6/5)
 * X^(-3/5). wavelength [m]. */
double um_instrument_seeing_fwhm(double r0, double wavelength, double airmass);

/* CSV with columns radius_arcsec, ascending from 0, and value, in any unit, not negative.
 * UM_ERR_INPUT with file, line and reason; the caller clears. */
enum um_status um_instrument_psf_read(struct um_context *context, const char *path,
                                      struct um_instrument_psf *out);
void um_instrument_psf_clear(struct um_context *context, struct um_instrument_psf *psf);

/* Shares of a point's light in square cells about it, (2 half + 1)^2 of them, row by row; the point
 * lies in the middle of the middle cell. They are integrals of the function and are not scaled to
 * add up to 1: what falls beside them is lost to the frame. */
struct um_instrument_kernel {
  int half;
  double cell;   /* [arcsec] */
  double *share; /* [2 half + 1][2 half + 1] [1] */
  double sum;    /* [1] */
};
/* half: chosen so that a share of at least `enclosed` of the light lies within, up to 512 cells.
 * UM_ERR_INPUT: cells that do not resolve the function (a FWHM below half a cell); UM_ERR_MEMORY.
 */
enum um_status um_instrument_kernel_create(struct um_context *context,
                                           const struct um_instrument_psf *psf, double cell,
                                           double enclosed, struct um_instrument_kernel *out);
void um_instrument_kernel_clear(struct um_context *context, struct um_instrument_kernel *kernel);

#endif
