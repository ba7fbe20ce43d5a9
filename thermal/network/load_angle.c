/* See load_angle_group.h. */
#include "thermal/network/load_angle_group.h"

double um_thermal_load_angle(const struct um_thermal_surface_law *law,
                             const struct um_irradiation_loads *loads, size_t at)
{
  double sum = 0.0, sun = (double)loads->sun[at];
  const size_t apart = (UM_THERMAL_LAW_ANGLES - 1) / (UM_IRRADIATION_COSINES - 1);
  _Static_assert((UM_THERMAL_LAW_ANGLES - 1) % (UM_IRRADIATION_COSINES - 1) == 0,
                 "cosines of a turn are nodes of the law");
  if (sun == 0.0) return law->absorptance[0]; /* of nothing */
  if (loads->by_cosine == NULL)
    return um_thermal_surface_law_absorptance(law, (double)loads->incidence[at]);
  for (size_t b = 0; b < UM_IRRADIATION_COSINES; b++)
    sum += law->absorptance[apart * b] * (double)loads->by_cosine[at * UM_IRRADIATION_COSINES + b];
  return sum / sun;
}

/* sum_k a_k E_k */
static double by_angle(const double a[UM_ANGULAR_MOMENTS], const float *moments, size_t at)
{
  double sum = 0.0;
  for (size_t k = 0; k < UM_ANGULAR_MOMENTS; k++)
    sum += a[k] * (double)moments[at * UM_ANGULAR_MOMENTS + k];
  return sum;
}

double um_thermal_load_albedo(const struct um_thermal_surface *surface,
                              const struct um_irradiation_loads *loads, size_t at,
                              double absorptance)
{
  const struct um_thermal_surface_law *law = surface->law;
  if (law == NULL) return absorptance * (double)loads->albedo[at];
  double sum = absorptance * law->albedo * (double)loads->albedo[at];
  if (!law->by_angle || loads->albedo_moments == NULL || loads->albedo[at] == 0.0f) return sum;
  return sum + surface->absorptance * by_angle(law->albedo_angle, loads->albedo_moments, at);
}

double um_thermal_load_planet(const struct um_thermal_surface *surface,
                              const struct um_irradiation_loads *loads, size_t at, double emittance)
{
  const struct um_thermal_surface_law *law = surface->law;
  if (law == NULL) return emittance * (double)loads->planet[at];
  double sum = emittance * law->planet * (double)loads->planet[at];
  if (!law->by_angle || loads->planet_moments == NULL || loads->planet[at] == 0.0f) return sum;
  return sum + emittance * by_angle(law->planet_angle, loads->planet_moments, at);
}
