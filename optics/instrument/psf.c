/* Point spread functions and their integrals over cells. */
#include "optics/instrument/psf.h"

#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "base/core/interpolation.h"

#define HALF_MOST      512  /* cells */
#define RING_STEP      0.05 /* of v in the quadrature of an obstructed aperture [1] */
#define POINTS_MOST    1000000
#define INTEGRAL_LEAST 1e-290 /* of a table in its own unit */
#define INTEGRAL_MOST  1e290
#define RADIUS_LEAST   1e-6 /* of the second point of a table [arcsec] */
#define RADIUS_MOST    1e9
#define SEEING_REF     5e-7 /* wavelength at which r0 is stated [m] */

/* 2 J_1(x)/x */
static double somb(double x) { return fabs(x) < 1e-6 ? 1.0 - 0.125 * x * x : 2.0 * j1(x) / x; }

/* Amplitude of an annular aperture over that in the middle (Born & Wolf 8.6.2). */
static double annular(double v, double o)
{
  return (somb(v) - o * o * somb(o * v)) / (1.0 - o * o);
}

static double moffat_scale(const struct um_instrument_psf *psf)
{
  return psf->fwhm / (2.0 * sqrt(exp2(1.0 / psf->beta) - 1.0));
}

double um_instrument_psf_at(const struct um_instrument_psf *psf, double radius)
{
  double a = psf->fwhm;
  switch (psf->kind) {
  case UM_PSF_GAUSSIAN:
    return 4.0 * log(2.0) / (UM_PI * a * a) * exp2(-4.0 * radius * radius / (a * a));
  case UM_PSF_MOFFAT:
    a = moffat_scale(psf);
    return (psf->beta - 1.0) / (UM_PI * a * a) * pow(1.0 + radius * radius / (a * a), -psf->beta);
  case UM_PSF_AIRY: {
    double o = psf->obstruction, f = annular(UM_PI * radius / psf->diffraction, o);
    return 0.25 * UM_PI * (1.0 - o * o) / (psf->diffraction * psf->diffraction) * f * f;
  }
  case UM_PSF_TABLE:
    break;
  }
  if (radius >= psf->radius[psf->n - 1]) return 0.0;
  size_t i = um_core_interval_find(psf->radius, psf->n, radius);
  double f = (radius - psf->radius[i]) / (psf->radius[i + 1] - psf->radius[i]);
  return psf->value[i] + f * (psf->value[i + 1] - psf->value[i]);
}

/* 1 - J_0^2 - J_1^2 for a full aperture; else (1 - o^2)/2 int f^2 v dv by Simpson's rule. */
static double airy_encircled(double v, double o)
{
  double j = j0(v), k = j1(v), sum = 0.0;
  if (!(o > 0.0)) return 1.0 - j * j - k * k;
  int n = 2 * (int)ceil(v / RING_STEP / 2.0) + 2;
  double h = v / n;
  for (int i = 0; i <= n; i++) {
    double x = i * h, f = annular(x, o), w = i == 0 || i == n ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    sum += w * f * f * x;
  }
  return 0.5 * (1.0 - o * o) * sum * h / 3.0;
}

/* 2 pi int r v dr over the pieces up to a radius; of one from (a, v) to (b, w) that is
 * pi (b - a) (a (2 v + w) + b (v + 2 w))/3, a sum of what is not negative. */
static double table_encircled(const struct um_instrument_psf *psf, double radius)
{
  double sum = 0.0;
  for (size_t i = 0; i + 1 < psf->n && psf->radius[i] < radius; i++) {
    double a = psf->radius[i], b = psf->radius[i + 1], v = psf->value[i], w = psf->value[i + 1];
    if (b > radius) {
      w = v + (w - v) * ((radius - a) / (b - a));
      b = radius;
    }
    sum += UM_PI / 3.0 * (b - a) * (a * (2.0 * v + w) + b * (v + 2.0 * w));
  }
  return sum;
}

double um_instrument_psf_encircled(const struct um_instrument_psf *psf, double radius)
{
  double q = radius / psf->fwhm;
  switch (psf->kind) {
  case UM_PSF_GAUSSIAN:
    return 1.0 - exp2(-4.0 * q * q);
  case UM_PSF_MOFFAT:
    q = radius / moffat_scale(psf);
    return 1.0 - pow(1.0 + q * q, 1.0 - psf->beta);
  case UM_PSF_AIRY:
    return airy_encircled(UM_PI * radius / psf->diffraction, psf->obstruction);
  case UM_PSF_TABLE:
    break;
  }
  return table_encircled(psf, radius);
}

double um_instrument_seeing_fwhm(double r0, double wavelength, double airmass)
{
  double here = r0 * pow(wavelength / SEEING_REF, 1.2) * pow(airmass, -0.6);
  return 0.976 * wavelength / here / UM_DEG * 3600.0;
}

static enum um_status read_rows(struct um_context *context, const struct um_core_csv *csv,
                                struct um_instrument_psf *out)
{
  size_t r, v;
  UM_TRY(um_core_csv_require(context, csv, "radius_arcsec", &r));
  UM_TRY(um_core_csv_require(context, csv, "value", &v));
  for (size_t i = 0; i < out->n; i++) {
    UM_TRY(um_core_csv_number(context, csv, i, r, &out->radius[i]));
    UM_TRY(um_core_csv_number(context, csv, i, v, &out->value[i]));
    double last = i == 0 ? 0.0 : out->radius[i - 1], here = out->radius[i];
    bool well = i == 0 ? here == 0.0 : here > last && here >= RADIUS_LEAST && here <= RADIUS_MOST;
    if (!well)
      return um_core_csv_fail(context, csv, i, r,
                              "%g arcsec; accepted: 0 first, then ascending from %g to %g", here,
                              RADIUS_LEAST, RADIUS_MOST);
    if (!(out->value[i] >= 0.0))
      return um_core_csv_fail(context, csv, i, v, "%g; accepted: 0 or above", out->value[i]);
  }
  return UM_OK;
}

enum um_status um_instrument_psf_read(struct um_context *context, const char *path,
                                      struct um_instrument_psf *out)
{
  struct um_core_csv *csv = NULL;
  enum um_status status;
  *out = (struct um_instrument_psf){.kind = UM_PSF_TABLE};
  UM_CHECK(um_core_csv_read(context, path, &csv));
  out->n = um_core_csv_rows(csv);
  if (out->n < 2 || out->n > POINTS_MOST) {
    status = um_core_fail(context, UM_ERR_INPUT, "%s: %zu rows; accepted: 2 to %d", path, out->n,
                          POINTS_MOST);
    goto done;
  }
  UM_CHECK(um_core_allocate(context, out->n, sizeof(double), &out->radius));
  UM_CHECK(um_core_allocate(context, out->n, sizeof(double), &out->value));
  UM_CHECK(read_rows(context, csv, out));
  double all = table_encircled(out, INFINITY);
  if (!(all >= INTEGRAL_LEAST && all <= INTEGRAL_MOST))
    status = um_core_fail(context, UM_ERR_INPUT, "%s: its integral is %g; accepted: %g to %g", path,
                          all, INTEGRAL_LEAST, INTEGRAL_MOST);
  for (size_t i = 0; i < out->n; i++) out->value[i] /= all;
done:
  um_core_csv_destroy(&csv);
  if (status != UM_OK) um_instrument_psf_clear(context, out);
  return status;
}

void um_instrument_psf_clear(struct um_context *context, struct um_instrument_psf *psf)
{
  UM_FREE(context, psf->radius, psf->value);
  psf->radius = psf->value = NULL;
  psf->n = 0;
}

/* Integral over a cell whose middle lies at (x, y) [cells]: Gauss-Legendre, 8 points an axis; of a
 * Gaussian exactly. */
static double cell_share(const struct um_instrument_psf *psf, double cell, int x, int y)
{
  static const double at[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                               0.9602898564975363};
  static const double weight[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                   0.1012285362903763};
  if (psf->kind == UM_PSF_GAUSSIAN) {
    double s = 2.0 * sqrt(log(2.0)) * cell / psf->fwhm; /* erf is of x sqrt(4 ln 2)/FWHM */
    return 0.25 * (erf(s * (x + 0.5)) - erf(s * (x - 0.5))) *
           (erf(s * (y + 0.5)) - erf(s * (y - 0.5)));
  }
  double sum = 0.0;
  for (int i = 0; i < 8; i++)
    for (int k = 0; k < 8; k++) {
      double u = x + (i < 4 ? 0.5 : -0.5) * at[i % 4], v = y + (k < 4 ? 0.5 : -0.5) * at[k % 4];
      sum += 0.25 * weight[i % 4] * weight[k % 4] * um_instrument_psf_at(psf, cell * hypot(u, v));
    }
  return sum * cell * cell;
}

/* Width of the middle, to be resolved by cells [arcsec]. */
static double width_of(const struct um_instrument_psf *psf)
{
  if (psf->kind == UM_PSF_AIRY) return 1.028 * psf->diffraction;
  return psf->kind == UM_PSF_TABLE ? INFINITY : psf->fwhm;
}

enum um_status um_instrument_kernel_create(struct um_context *context,
                                           const struct um_instrument_psf *psf, double cell,
                                           double enclosed, struct um_instrument_kernel *out)
{
  *out = (struct um_instrument_kernel){.cell = cell};
  if (!(width_of(psf) >= 0.5 * cell))
    return um_core_fail(context, UM_ERR_INPUT,
                        "point spread function of FWHM %g arcsec on cells of %g; accepted: cells "
                        "of twice that at most",
                        width_of(psf), cell);
  while (out->half < HALF_MOST &&
         um_instrument_psf_encircled(psf, (out->half + 0.5) * cell) < enclosed)
    out->half++;
  size_t side = 2 * (size_t)out->half + 1;
  UM_TRY(um_core_allocate(context, side * side, sizeof *out->share, &out->share));
  for (int y = 0; y <= out->half; y++)
    for (int x = 0; x <= y; x++) { /* eight cells are alike */
      double share = cell_share(psf, cell, x, y);
      for (int k = 0; k < 8; k++) {
        int u = k & 4 ? y : x, v = k & 4 ? x : y;
        u = k & 1 ? -u : u;
        v = k & 2 ? -v : v;
        out->share[(size_t)(v + out->half) * side + (size_t)(u + out->half)] = share;
      }
    }
  for (size_t i = 0; i < side * side; i++) out->sum += out->share[i];
  return UM_OK;
}

void um_instrument_kernel_clear(struct um_context *context, struct um_instrument_kernel *kernel)
{
  um_core_free(context, kernel->share);
  kernel->share = NULL;
}
