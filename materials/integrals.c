/* Integrals of the spectral reflectance that the thermal half needs.
 *
 * Solar absorptance by angle of incidence: the spectral absorptance summed with the shares of the
 * Sun's energy that the library was given, so that what the renderer reflects of that Sun is what
 * the heat network does not absorb.
 *
 * Total emittance at T, from the piecewise linear spectral one (ends held constant):
 *   eps(T) = sum_j (eps_j + eps_j+1)/2 (F(lambda_j+1 T) - F(lambda_j T)) + the two ends
 * with F Planck's fraction, tabulated at load over log T and interpolated by cubics. */
#include <math.h>

#include "base/core/planck.h"
#include "materials/record_impl.h"

#define TEMPERATURES UM_MATERIALS_TEMPERATURES

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

static double absorptance_toward(const struct um_materials_sun *sun,
                                 const struct um_materials_record *record, double cosine)
{
  double sum = 0.0;
  for (size_t i = 0; i < UM_MATERIALS_SUN; i++)
    if (sun->share[i] > 0.0)
      sum += sun->share[i] * um_materials_emissivity(record, NULL, sun->wavelength[i], cosine);
  return sum;
}

/* At the nodes; 2 int alpha mu d mu = 4 int alpha u^3 du by Simpson's rule on them. */
static void absorptance_build(const struct um_materials_sun *sun,
                              struct um_materials_record *record)
{
  const int n = UM_MATERIALS_INCIDENCES;
  double sum = 0.0, h = 1.0 / (n - 1);
  bool diffuse = um_materials_emissivity_is_diffuse(record, NULL);
  record->solar_absorptance = absorptance_toward(sun, record, 1.0);
  for (int i = 0; i < n; i++) {
    double u = i * h, weight = (i == 0 || i == n - 1 ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * h / 3.0;
    record->absorptance[i] =
        diffuse || i == n - 1 ? record->solar_absorptance : absorptance_toward(sun, record, u * u);
    sum += weight * 4.0 * u * u * u * record->absorptance[i];
  }
  record->diffuse_absorptance = diffuse ? record->solar_absorptance : sum;
}

void um_materials_integrals_build(const struct um_materials_sun *sun,
                                  struct um_materials_record *record)
{
  if (record->grey) {
    record->solar_absorptance = record->explicit_values.solar_absorptance;
    record->diffuse_absorptance = record->solar_absorptance;
    for (size_t i = 0; i < UM_MATERIALS_INCIDENCES; i++)
      record->absorptance[i] = record->solar_absorptance;
    for (size_t i = 0; i < TEMPERATURES; i++)
      record->emittance[i] = record->normal_emittance[i] = record->explicit_values.emittance;
    return;
  }
  absorptance_build(sun, record);
  for (size_t i = 0; i < TEMPERATURES; i++)
    emittance_at(record, temperature_node(i), &record->emittance[i], &record->normal_emittance[i]);
}

/* Cubic Lagrange at the place x of n nodes, constant outside. */
static double cubic(const double *table, size_t n, double x)
{
  if (!(x > 0.0)) return table[0];
  if (x >= (double)(n - 1)) return table[n - 1];
  size_t j = (size_t)x;
  j = j < 1 ? 1 : (j > n - 3 ? n - 3 : j);
  double s = x - (double)j;
  double w0 = -s * (s - 1.0) * (s - 2.0) / 6.0, w1 = (s + 1.0) * (s - 1.0) * (s - 2.0) / 2.0;
  double w2 = -(s + 1.0) * s * (s - 2.0) / 2.0, w3 = (s + 1.0) * s * (s - 1.0) / 6.0;
  return w0 * table[j - 1] + w1 * table[j] + w2 * table[j + 1] + w3 * table[j + 2];
}

/* In log T. */
static double table_at(const double *table, double temperature)
{
  return cubic(table, TEMPERATURES,
               log(temperature / UM_MATERIALS_COLDEST) /
                   log(UM_MATERIALS_HOTTEST / UM_MATERIALS_COLDEST) * (TEMPERATURES - 1));
}

static double scaled(double emittance, const struct um_materials_adjustment *adjustment)
{
  if (adjustment == NULL || adjustment->emittance_scale == 1.0) return emittance;
  return fmax(0.0, fmin(1.0, emittance * adjustment->emittance_scale));
}

static double shifted(double absorptance, const struct um_materials_adjustment *adjustment)
{
  if (adjustment == NULL || adjustment->absorptance_shift == 0.0) return absorptance;
  return fmax(0.0, fmin(1.0, absorptance + adjustment->absorptance_shift));
}

double um_materials_solar_absorptance(const struct um_materials_record *record,
                                      const struct um_materials_adjustment *adjustment)
{
  return shifted(record->solar_absorptance, adjustment);
}

double um_materials_solar_absorptance_toward(const struct um_materials_record *record,
                                             const struct um_materials_adjustment *adjustment,
                                             double cosine)
{
  double u = sqrt(fmax(0.0, fmin(1.0, cosine)));
  return shifted(
      cubic(record->absorptance, UM_MATERIALS_INCIDENCES, u * (UM_MATERIALS_INCIDENCES - 1)),
      adjustment);
}

double um_materials_solar_absorptance_diffuse(const struct um_materials_record *record,
                                              const struct um_materials_adjustment *adjustment)
{
  return shifted(record->diffuse_absorptance, adjustment);
}

double um_materials_emittance(const struct um_materials_record *record,
                              const struct um_materials_adjustment *adjustment, double temperature)
{
  double value = record->grey ? record->emittance[0] : table_at(record->emittance, temperature);
  return scaled(value, adjustment);
}

/* eps(theta, T) over wavelengths as eps(T) is (emittance_at), at the nodes of the record's angles.
 */
static void directional_emittance(const struct um_materials_spectrum *s, double temperature,
                                  double at[UM_MATERIALS_COSINES])
{
  double before = 0.0;
  for (size_t j = 0; j < s->ncos; j++) at[j] = 0.0;
  for (size_t i = 0; i <= s->n; i++) {
    bool end = i == s->n;
    double fraction = end ? 1.0 : um_core_planck_fraction(s->wavelength[i] * temperature);
    size_t high = end ? i - 1 : i, low = i > 0 ? i - 1 : 0;
    for (size_t j = 0; j < s->ncos; j++)
      at[j] += (fraction - before) * (1.0 - 0.5 * (s->diffuse[low] + s->lobe[low * s->ncos + j] +
                                                   s->diffuse[high] + s->lobe[high * s->ncos + j]));
    before = fraction;
  }
}

void um_materials_emittance_by_angle(const struct um_materials_record *record,
                                     const struct um_materials_adjustment *adjustment,
                                     double temperature, size_t n, double *out)
{
  double at[UM_MATERIALS_COSINES];
  size_t ncos = record->grey ? 1 : record->spectrum.ncos;
  if (ncos > 1)
    directional_emittance(&record->spectrum, temperature, at);
  else
    at[0] = um_materials_emittance(record, NULL, temperature);
  double tilt = adjustment != NULL ? adjustment->emissivity_tilt : 0.0;
  double mean = um_materials_emittance(record, adjustment, temperature);
  for (size_t k = 0; k < n; k++) {
    double u = (double)k / (double)(n - 1);
    double value = ncos > 1 ? cubic(at, ncos, u * (double)(ncos - 1)) : at[0];
    value = scaled(value, adjustment);
    if (tilt != 0.0) value += tilt * mean * (1.0 - 21.0 * pow(1.0 - u * u, 5.0)) / 20.0;
    out[k] = fmax(0.0, fmin(1.0, value));
  }
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
