/* Quantities, and their values in linear flux.
 *
 *   F = 10^(-0.4 m),  dF = 0.4 ln 10 F dm                      (Pogson 1856) */
#include "evidence/measurements/quantity.h"

#include <math.h>

#include "base/core/constants.h"

static const char *const quantity_names[UM_QUANTITY_COUNT] = {
    [UM_QUANTITY_BAND_IRRADIANCE] = "band_irradiance",
    [UM_QUANTITY_RADIANT_INTENSITY] = "radiant_intensity",
    [UM_QUANTITY_MAGNITUDE_AB] = "magnitude_ab",
    [UM_QUANTITY_MAGNITUDE_VEGA] = "magnitude_vega",
    [UM_QUANTITY_COUNT_RATE] = "count_rate",
    [UM_QUANTITY_TEMPERATURE] = "temperature",
    [UM_QUANTITY_CHARACTERISTIC_TEMPERATURE] = "characteristic_temperature",
    [UM_QUANTITY_INFRARED_CROSS_SECTION] = "infrared_cross_section"};

static const char *const quantity_units[UM_QUANTITY_COUNT] = {
    [UM_QUANTITY_BAND_IRRADIANCE] = "W/m^2",
    [UM_QUANTITY_RADIANT_INTENSITY] = "W/sr",
    [UM_QUANTITY_MAGNITUDE_AB] = "mag",
    [UM_QUANTITY_MAGNITUDE_VEGA] = "mag",
    [UM_QUANTITY_COUNT_RATE] = "1/s",
    [UM_QUANTITY_TEMPERATURE] = "K",
    [UM_QUANTITY_CHARACTERISTIC_TEMPERATURE] = "K",
    [UM_QUANTITY_INFRARED_CROSS_SECTION] = "m^2"};

const char *um_compare_quantity_name(enum um_compare_quantity quantity)
{
  return (unsigned)quantity < UM_QUANTITY_COUNT ? quantity_names[quantity] : "unknown quantity";
}

const char *um_compare_quantity_unit(enum um_compare_quantity quantity)
{
  return (unsigned)quantity < UM_QUANTITY_COUNT ? quantity_units[quantity] : "";
}

bool um_compare_is_grey_body(enum um_compare_quantity quantity)
{
  return quantity == UM_QUANTITY_CHARACTERISTIC_TEMPERATURE ||
         quantity == UM_QUANTITY_INFRARED_CROSS_SECTION;
}

bool um_compare_is_magnitude(enum um_compare_quantity quantity)
{
  return quantity == UM_QUANTITY_MAGNITUDE_AB || quantity == UM_QUANTITY_MAGNITUDE_VEGA;
}

const char *um_compare_residual_unit(enum um_compare_quantity quantity)
{
  return um_compare_is_magnitude(quantity) ? "flux of magnitude 0"
                                           : um_compare_quantity_unit(quantity);
}

struct um_compare_linear um_compare_linear(enum um_compare_quantity quantity, double value,
                                           double sigma)
{
  if (!um_compare_is_magnitude(quantity)) return (struct um_compare_linear){value, sigma};
  double flux = exp(-0.4 * UM_LN10 * value);
  return (struct um_compare_linear){flux, 0.4 * UM_LN10 * flux * sigma};
}
