/* Sunlight: irradiance at a distance, spectrum and band integrals scaled to the irradiance at 1 au.
 *
 *   S(d) = S_1au (1 au / d)^2
 *   E_lambda = S_1au f(lambda) / integral of f,  f = ASTM E490 or pi B_lambda(T) */
#include <math.h>

#include "base/core/constants.h"
#include "base/core/planck.h"
#include "environment/environment.h"
#include "environment/solar_e490_impl.h"

double um_environment_solar_irradiance(const struct um_environment *environment, double distance)
{
  double au_over_d = UM_AU / distance;
  return environment->solar_irradiance * au_over_d * au_over_d;
}

/* Scale that makes the integral of pi B_lambda(T), sigma T^4, equal to the irradiance. [1] */
static double black_body_scale(const struct um_environment *environment)
{
  double t2 = environment->solar_temperature * environment->solar_temperature;
  return environment->solar_irradiance / (UM_STEFAN_BOLTZMANN * t2 * t2);
}

double um_environment_solar_spectrum(const struct um_environment *environment, double wavelength)
{
  if (!(wavelength > 0.0)) return 0.0;
  if (environment->spectrum == UM_SPECTRUM_BLACK_BODY)
    return black_body_scale(environment) * UM_PI *
           um_core_planck_radiance(wavelength, environment->solar_temperature);
  return environment->solar_irradiance / um_environment_e490_total() *
         um_environment_e490_spectrum(wavelength);
}

double um_environment_solar_band(const struct um_environment *environment, double from, double to)
{
  if (!(from < to)) return 0.0;
  if (environment->spectrum == UM_SPECTRUM_BLACK_BODY) {
    double t = environment->solar_temperature;
    double s = environment->solar_irradiance;
    /* a band from 0 has no finite z = C2/(lambda T): take the fraction below */
    if (!(from > 0.0)) return s * um_core_planck_fraction(to * t);
    return black_body_scale(environment) * UM_PI * um_core_planck_band(from, to, t);
  }
  return environment->solar_irradiance / um_environment_e490_total() *
         um_environment_e490_band(from, to);
}

void um_environment_sun_shares(const struct um_environment *environment,
                               struct um_materials_sun *out)
{
  const double first = 0.1195e-6, last = 1e-3; /* where E490 begins and ends [m] */
  const double step = log(last / first) / UM_MATERIALS_SUN;
  double total = 0.0;
  struct um_environment sun = *environment; /* shares of its energy, which may be none */
  if (!(sun.solar_irradiance > 0.0)) sun.solar_irradiance = 1.0;
  for (size_t i = 0; i < UM_MATERIALS_SUN; i++) {
    double from = first * exp(step * (double)i), to = first * exp(step * (double)(i + 1));
    out->wavelength[i] = sqrt(from * to);
    out->share[i] = um_environment_solar_band(&sun, from, to);
    total += out->share[i];
  }
  for (size_t i = 0; i < UM_MATERIALS_SUN; i++) out->share[i] /= total;
  out->measured = environment->spectrum == UM_SPECTRUM_E490;
}

enum um_status um_environment_library_create(struct um_context *context, bool records,
                                             struct um_materials_library **out)
{
  struct um_environment environment;
  struct um_materials_sun sun;
  char *folder = NULL;
  um_environment_defaults(&environment);
  um_environment_sun_shares(&environment, &sun);
  UM_TRY(um_materials_library_create(context, &sun, out));
  if (!records) return UM_OK;
  enum um_status status = um_materials_library_folder(context, &folder);
  if (status == UM_OK) status = um_materials_library_read_folder(context, *out, folder);
  if (status != UM_OK) um_materials_library_destroy(out);
  um_core_free(context, folder);
  return status;
}
