/* Integrals of the spectral reflectance that the thermal half needs.
 *
 * Solar absorptance at normal incidence by selected ordinates (ASTM E903-12, 8.3.4 and appendix):
 * the mean of the spectral absorptance over 100 wavelengths that stand in the middle of 100 parts
 * of equal energy of the ASTM E490-00a spectrum (0.1195-1000 um). The list is a property of the
 * spectrum; the spectrum itself belongs to `environment`. Against the full table the library's
 * records differ by less than 0.004 (tests/materials/library.c).
 *
 * Total emittance at T, from the piecewise linear spectral one (ends held constant):
 *   eps(T) = sum_j (eps_j + eps_j+1)/2 (F(lambda_j+1 T) - F(lambda_j T)) + the two ends
 * with F Planck's fraction, tabulated at load over log T and interpolated by cubics. */
#include <math.h>

#include "core/planck.h"
#include "materials/record_impl.h"

#define TEMPERATURES UM_MATERIALS_TEMPERATURES

/* [um] middle of each hundredth of the energy of E490. */
static const double solar_ordinates[] = {
    0.2810, 0.3104, 0.3288, 0.3432, 0.3576, 0.3708, 0.3837, 0.3970, 0.4056, 0.4137, 0.4215, 0.4298,
    0.4381, 0.4455, 0.4522, 0.4590, 0.4657, 0.4726, 0.4794, 0.4863, 0.4935, 0.5005, 0.5076, 0.5148,
    0.5224, 0.5297, 0.5369, 0.5443, 0.5516, 0.5589, 0.5664, 0.5738, 0.5812, 0.5887, 0.5964, 0.6041,
    0.6120, 0.6200, 0.6281, 0.6363, 0.6447, 0.6533, 0.6623, 0.6711, 0.6802, 0.6895, 0.6990, 0.7087,
    0.7187, 0.7289, 0.7393, 0.7500, 0.7609, 0.7722, 0.7837, 0.7954, 0.8075, 0.8199, 0.8327, 0.8458,
    0.8597, 0.8739, 0.8881, 0.9028, 0.9179, 0.9336, 0.9498, 0.9666, 0.9840, 1.0021, 1.0210, 1.0408,
    1.0615, 1.0832, 1.1058, 1.1293, 1.1539, 1.1796, 1.2064, 1.2346, 1.2643, 1.2957, 1.3294, 1.3657,
    1.4043, 1.4455, 1.4896, 1.5368, 1.5881, 1.6445, 1.7076, 1.7799, 1.8642, 1.9649, 2.0884, 2.2464,
    2.4593, 2.7707, 3.3082, 4.8110};

static double temperature_node(size_t i)
{
  double u = (double)i / (TEMPERATURES - 1);
  return UM_MATERIALS_COLDEST * pow(UM_MATERIALS_HOTTEST / UM_MATERIALS_COLDEST, u);
}

static void emittance_at(const struct um_materials_record *record, double temperature,
                         double *hemispherical, double *normal)
{
  const struct um_materials_spectrum *s = &record->spectrum;
  double h = 0.0, n = 0.0, before_h = 0.0, before_n = 0.0, before = 0.0;
  for (size_t i = 0; i < s->n; i++) {
    double fraction = um_core_planck_fraction(s->wavelength[i] * temperature);
    double at_h = 1.0 - s->diffuse[i] - s->lobe_mean[i];
    double at_n = 1.0 - s->diffuse[i] - s->lobe[(i + 1) * s->ncos - 1];
    if (i == 0) {
      before_h = at_h;
      before_n = at_n;
    }
    double width = fraction - before;
    h += 0.5 * (before_h + at_h) * width;
    n += 0.5 * (before_n + at_n) * width;
    before_h = at_h;
    before_n = at_n;
    before = fraction;
  }
  *hemispherical = h + before_h * (1.0 - before);
  *normal = n + before_n * (1.0 - before);
}

void um_materials_integrals_build(struct um_materials_record *record)
{
  if (record->grey) {
    record->solar_absorptance = record->explicit_values.solar_absorptance;
    for (size_t i = 0; i < TEMPERATURES; i++)
      record->emittance[i] = record->normal_emittance[i] = record->explicit_values.emittance;
    return;
  }
  const size_t count = sizeof solar_ordinates / sizeof solar_ordinates[0];
  double sum = 0.0;
  for (size_t i = 0; i < count; i++)
    sum += um_materials_emissivity(record, NULL, solar_ordinates[i] * 1e-6, 1.0);
  record->solar_absorptance = sum / (double)count;
  for (size_t i = 0; i < TEMPERATURES; i++)
    emittance_at(record, temperature_node(i), &record->emittance[i], &record->normal_emittance[i]);
}

/* Cubic Lagrange in log T. */
static double table_at(const double *table, double temperature)
{
  double x = log(temperature / UM_MATERIALS_COLDEST) /
             log(UM_MATERIALS_HOTTEST / UM_MATERIALS_COLDEST) * (TEMPERATURES - 1);
  if (!(x > 0.0)) return table[0];
  if (x >= TEMPERATURES - 1) return table[TEMPERATURES - 1];
  size_t j = (size_t)x;
  j = j < 1 ? 1 : (j > TEMPERATURES - 3 ? TEMPERATURES - 3 : j);
  double s = x - (double)j;
  double w0 = -s * (s - 1.0) * (s - 2.0) / 6.0, w1 = (s + 1.0) * (s - 1.0) * (s - 2.0) / 2.0;
  double w2 = -(s + 1.0) * s * (s - 2.0) / 2.0, w3 = (s + 1.0) * s * (s - 1.0) / 6.0;
  return w0 * table[j - 1] + w1 * table[j] + w2 * table[j + 1] + w3 * table[j + 2];
}

static double scaled(double emittance, const struct um_materials_adjustment *adjustment)
{
  if (adjustment == NULL || adjustment->emittance_scale == 1.0) return emittance;
  return fmax(0.0, fmin(1.0, emittance * adjustment->emittance_scale));
}

double um_materials_solar_absorptance(const struct um_materials_record *record,
                                      const struct um_materials_adjustment *adjustment)
{
  if (adjustment == NULL || adjustment->absorptance_shift == 0.0) return record->solar_absorptance;
  return fmax(0.0, fmin(1.0, record->solar_absorptance + adjustment->absorptance_shift));
}

double um_materials_emittance(const struct um_materials_record *record,
                              const struct um_materials_adjustment *adjustment, double temperature)
{
  double value = record->grey ? record->emittance[0] : table_at(record->emittance, temperature);
  return scaled(value, adjustment);
}

double um_materials_normal_emittance(const struct um_materials_record *record,
                                     const struct um_materials_adjustment *adjustment,
                                     double temperature)
{
  double value =
      record->grey ? record->emittance[0] : table_at(record->normal_emittance, temperature);
  value = scaled(value, adjustment);
  if (adjustment == NULL || adjustment->emissivity_tilt == 0.0) return value;
  double hemispherical = um_materials_emittance(record, adjustment, temperature);
  return fmax(0.0, fmin(1.0, value + adjustment->emissivity_tilt * hemispherical / 20.0));
}
