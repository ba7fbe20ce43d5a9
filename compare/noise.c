/* Linear flux and the noise model.
 *
 *   F = 10^(-0.4 m),  dF = 0.4 ln 10 F dm                      (Pogson 1856)
 *   sigma^2 = (relative x value)^2 + floor^2 */
#include <math.h>

#include "compare/series.h"

static const double LN10 = 2.30258509299404568402;

static bool is_magnitude(enum um_compare_quantity quantity)
{
  return quantity == UM_QUANTITY_MAGNITUDE_AB || quantity == UM_QUANTITY_MAGNITUDE_VEGA;
}

void um_compare_linear(enum um_compare_quantity quantity, double value, double sigma, double *flux,
                       double *flux_sigma)
{
  *flux = value;
  *flux_sigma = sigma;
  if (!is_magnitude(quantity)) return;
  *flux = exp(-0.4 * LN10 * value);
  *flux_sigma = 0.4 * LN10 * *flux * sigma;
}

double um_compare_noise_sigma(enum um_compare_quantity quantity,
                              const struct um_compare_noise *noise, double value)
{
  double scale = is_magnitude(quantity) ? 2.5 / LN10 : value;
  return hypot(noise->relative * scale, noise->floor);
}

enum um_status um_compare_noise_fill(struct um_context *context,
                                     struct um_compare_measurements *measurements, size_t channel,
                                     const struct um_compare_noise *noise, const double *model)
{
  struct um_compare_measurements *m = measurements;
  enum um_compare_quantity quantity = m->channel[channel].quantity;
  const char *unit = um_compare_quantity_unit(quantity);
  bool good = noise->relative >= 0.0 && noise->floor >= 0.0 && isfinite(noise->relative) &&
              isfinite(noise->floor) && noise->relative + noise->floor > 0.0;
  if (!good)
    return um_core_fail(context, UM_ERR_INPUT,
                        "noise of %s '%s': relative %g, floor %g %s; accepted: both 0 or more, not "
                        "both 0",
                        um_compare_quantity_name(quantity), m->channel[channel].of, noise->relative,
                        noise->floor, unit);
  for (int pass = 0; pass < 2; pass++) /* check all, then fill */
    for (size_t i = 0; i < m->count; i++) {
      struct um_compare_measurement *row = &m->row[i];
      if (row->channel != channel || !isnan(row->sigma)) continue;
      double value = model == NULL ? row->value : model[i];
      double sigma = um_compare_noise_sigma(quantity, noise, value);
      if (!(sigma > 0.0) || !isfinite(sigma))
        return um_core_fail(context, UM_ERR_INPUT,
                            "%s:%d: the noise model gives %s '%s' of %g %s a sigma of %g %s; "
                            "accepted: above 0 (give the noise a floor)",
                            m->path, row->line, um_compare_quantity_name(quantity),
                            m->channel[channel].of, value, unit, sigma, unit);
      if (pass == 1) row->sigma = sigma;
    }
  return UM_OK;
}
