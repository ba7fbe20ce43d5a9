/* See load_angle_impl.h. */
#include "thermal/load_angle_impl.h"

double um_thermal_load_angle(const struct um_thermal_surface_law *law,
                             const struct um_irradiation_loads *loads, size_t at)
{
  double sum = 0.0, sun = (double)loads->sun[at];
  const size_t apart = (UM_THERMAL_LAW_ANGLES - 1) / (UM_IRRADIATION_COSINES - 1);
  _Static_assert((UM_THERMAL_LAW_ANGLES - 1) % (UM_IRRADIATION_COSINES - 1) == 0,
                 "cosines of a turn are nodes of the law");
  if (loads->by_cosine == NULL)
    return um_thermal_surface_law_absorptance(law, (double)loads->incidence[at]);
  for (size_t b = 0; b < UM_IRRADIATION_COSINES; b++)
    sum += law->absorptance[apart * b] * (double)loads->by_cosine[at * UM_IRRADIATION_COSINES + b];
  return sun != 0.0 ? sum / sun : 1.0;
}
