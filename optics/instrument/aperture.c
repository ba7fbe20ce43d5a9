/* Aperture photometry of a frame. */
#include "optics/instrument/aperture.h"

#include <math.h>
#include <stdlib.h>

#include "base/core/constants.h"
#include "base/core/order.h"

#define FEWEST   8   /* pixels of an annulus */
#define SATURATE 5.0 /* sigma of the read noise below the saturation that counts as saturated */

/* int sqrt(r^2 - u^2) du from 0 to u */
static double half_moon(double u, double r)
{
  double v = fmin(fmax(u / r, -1.0), 1.0);
  return 0.5 * r * r * (v * sqrt(1.0 - v * v) + asin(v));
}

/* Area of the disc about 0 that lies to the left of x and below y: the height of a column is
 * min(y, h) + h where that is above 0, h = sqrt(r^2 - u^2), and y parts the columns at
 * u = +-sqrt(r^2 - y^2). */
static double corner(double x, double y, double r)
{
  double right = fmin(x, r);
  if (right <= -r || y <= -r) return 0.0;
  double full = half_moon(right, r) - half_moon(-r, r);
  if (y >= r) return 2.0 * full;
  double c = sqrt(r * r - y * y), from = fmin(fmax(-c, -r), right), to = fmin(c, right);
  double middle = half_moon(to, r) - half_moon(from, r), width = to - from;
  return y >= 0.0 ? 2.0 * full - middle + y * width : middle + y * width;
}

double um_instrument_pixel_share(double i, double j, double x, double y, double r)
{
  double left = i - 0.5 - x, right = left + 1.0, low = j - 0.5 - y, high = low + 1.0;
  double share =
      corner(right, high, r) - corner(left, high, r) - corner(right, low, r) + corner(left, low, r);
  return fmin(fmax(share, 0.0), 1.0);
}

static enum um_status check(struct um_context *context, const struct um_instrument_counts *c,
                            const struct um_instrument_aperture *a)
{
  if (!(a->radius > 0.0 && a->inside >= a->radius && a->beyond > a->inside) || isinf(a->beyond))
    return um_core_fail(context, UM_ERR_INPUT,
                        "aperture of %g, sky from %g to %g pixels; accepted: above 0, and the "
                        "annulus beyond the circle",
                        a->radius, a->inside, a->beyond);
  if (!(a->x - a->beyond >= -0.5 && a->x + a->beyond <= c->width - 0.5 &&
        a->y - a->beyond >= -0.5 && a->y + a->beyond <= c->height - 0.5))
    return um_core_fail(context, UM_ERR_INPUT,
                        "the annulus of %g pixels about %g,%g leaves the frame of %d x %d pixels "
                        "(1,1 is the middle of the first); accepted: all of it within",
                        a->beyond, a->x + 1.0, a->y + 1.0, c->width, c->height);
  if (!(c->gain > 0.0 && c->read_noise >= 0.0) || isinf(c->gain) || isinf(c->read_noise))
    return um_core_fail(context, UM_ERR_INPUT,
                        "gain %g e per count, read noise %g e; accepted: above 0, 0 or above",
                        c->gain, c->read_noise);
  return UM_OK;
}

/* Values of the annulus, ascending; the caller frees. */
static enum um_status annulus(struct um_context *context, const struct um_instrument_counts *c,
                              const struct um_instrument_aperture *a, double **out, size_t *n)
{
  size_t side = (size_t)(2.0 * a->beyond) + 3;
  double *value;
  *n = 0;
  UM_TRY(um_core_allocate(context, side * side, sizeof *value, &value));
  for (int j = (int)fmax(floor(a->y - a->beyond), 0.0);
       j <= (int)ceil(a->y + a->beyond) && j < c->height; j++)
    for (int i = (int)fmax(floor(a->x - a->beyond), 0.0);
         i <= (int)ceil(a->x + a->beyond) && i < c->width; i++) {
      double distance = hypot(i - a->x, j - a->y);
      float v = c->value[(size_t)j * (size_t)c->width + (size_t)i];
      if (distance >= a->inside && distance <= a->beyond && isfinite(v)) value[(*n)++] = (double)v;
    }
  if (*n < FEWEST) {
    um_core_free(context, value);
    return um_core_fail(context, UM_ERR_INPUT,
                        "sky annulus of %zu pixels from %g to %g; accepted: %d or more", *n,
                        a->inside, a->beyond, FEWEST);
  }
  qsort(value, *n, sizeof *value, um_core_order_double);
  *out = value;
  return UM_OK;
}

/* Median of ascending values; equal ones are spread evenly over the step of whole counts. */
static double median_of(const double *value, size_t n)
{
  double middle = value[n / 2];
  size_t first = 0, equal = 0;
  while (value[first] < middle) first++;
  while (first + equal < n && value[first + equal] == middle) equal++;
  if (equal == 1) return n % 2 == 1 ? middle : 0.5 * (value[n / 2 - 1] + value[n / 2]);
  return middle - 0.5 + (0.5 * (double)n - (double)first) / (double)equal;
}

/* Level of the sky, counts. */
static void read_sky(const struct um_instrument_counts *c, const struct um_instrument_aperture *a,
                     const double *value, size_t n, struct um_instrument_aperture_sum *out)
{
  double sum = 0.0, g = c->gain, read2 = c->read_noise * c->read_noise;
  for (size_t i = 0; i < n; i++) sum += value[i];
  out->annulus = n;
  out->sky = a->median ? median_of(value, n) : sum / (double)n;
  double electrons = fmax(out->sky * g, 0.0);
  double skew = electrons + read2 > 0.0 ? electrons / (6.0 * (electrons + read2)) : 0.0;
  if (a->median) out->sky += skew / g;
  out->sky_error =
      sqrt((a->median ? 0.5 * UM_PI : 1.0) * (electrons + read2 + g * g / 12.0) / (double)n) / g;
}

static enum um_status sum_circle(struct um_context *context, const struct um_instrument_counts *c,
                                 const struct um_instrument_aperture *a,
                                 struct um_instrument_aperture_sum *out)
{
  double full = c->saturation - SATURATE * c->read_noise / c->gain;
  for (int j = (int)floor(a->y - a->radius); j <= (int)ceil(a->y + a->radius); j++)
    for (int i = (int)floor(a->x - a->radius); i <= (int)ceil(a->x + a->radius); i++) {
      if (i < 0 || j < 0 || i >= c->width || j >= c->height) continue;
      double share = um_instrument_pixel_share(i, j, a->x, a->y, a->radius);
      double v = (double)c->value[(size_t)j * (size_t)c->width + (size_t)i];
      if (!(share > 0.0)) continue;
      if (!isfinite(v))
        return um_core_fail(context, UM_ERR_INPUT,
                            "pixel %d,%d in the aperture has no number; accepted: a number", i + 1,
                            j + 1);
      out->sum += share * v;
      out->saturated += v >= full;
    }
  return UM_OK;
}

enum um_status um_instrument_aperture_sum(struct um_context *context,
                                          const struct um_instrument_counts *counts,
                                          const struct um_instrument_aperture *aperture,
                                          struct um_instrument_aperture_sum *out)
{
  double *value = NULL, g = counts->gain;
  size_t n = 0;
  *out = (struct um_instrument_aperture_sum){.pixels = UM_PI * aperture->radius * aperture->radius};
  UM_TRY(check(context, counts, aperture));
  UM_TRY(sum_circle(context, counts, aperture, out));
  UM_TRY(annulus(context, counts, aperture, &value, &n));
  read_sky(counts, aperture, value, n, out);
  um_core_free(context, value);
  out->net = out->sum - out->pixels * out->sky;
  double pixel = fmax(out->sky * g, 0.0) + counts->read_noise * counts->read_noise + g * g / 12.0;
  double read = out->pixels * out->sky_error * g;
  out->error = sqrt(fmax(out->net * g, 0.0) + out->pixels * pixel + read * read) / g;
  out->snr = out->net / out->error;
  return UM_OK;
}
