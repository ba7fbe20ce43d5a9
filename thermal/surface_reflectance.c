/* See surface_reflectance_impl.h. */
#include "thermal/surface_reflectance_impl.h"

#include "thermal/load_angle_impl.h"
#include "thermal/surface_aging_impl.h"

/* 1 - absorbed / incident, where something falls in, kept within 0 and 1. */
static double reflected(double absorbed, double incident, double otherwise)
{
  return incident > 0.0 ? fmax(0.0, fmin(1.0, 1.0 - absorbed / incident)) : otherwise;
}

struct um_thermal_reflectances
um_thermal_surface_reflectances(const struct um_thermal_network *network,
                                const struct um_irradiation_loads *loads,
                                const struct um_thermal_aging *aging, size_t row, size_t surface)
{
  const struct um_thermal_surface *at = &network->surface[surface];
  double absorptance = um_thermal_aged_absorptance(network, aging, row, surface);
  double emittance = at->emittance * um_thermal_aged_emittance(aging, row, surface);
  struct um_thermal_reflectances r = {1.0 - absorptance, 1.0 - absorptance, 1.0 - emittance};
  if (at->law == NULL) return r;
  r.sun =
      1.0 - absorptance * um_thermal_load_angle(at->law, loads, row * loads->nsurface + surface);
  r.albedo = 1.0 - absorptance * at->law->albedo;
  r.planet = 1.0 - emittance * at->law->planet;
  if (!at->law->by_angle || loads->planet_moments == NULL) return r;
  size_t entry = row * loads->nsurface + surface;
  r.albedo = reflected(um_thermal_load_albedo(at, loads, entry, absorptance),
                       (double)loads->albedo[entry], r.albedo);
  r.planet = reflected(um_thermal_load_planet(at, loads, entry, emittance),
                       (double)loads->planet[entry], r.planet);
  return r;
}
