/* See surface_reflectance_group.h. */
#include "thermal/network/surface_reflectance_group.h"

#include "thermal/network/load_angle_group.h"
#include "thermal/network/surface_aging_group.h"

/* 1 - absorbed / incident, where something falls in, kept within 0 and 1. */
static double reflected(double absorbed, double incident, double otherwise)
{
  return incident > 0.0 ? fmax(0.0, fmin(1.0, 1.0 - absorbed / incident)) : otherwise;
}

static double of_sun(const struct um_thermal_surface *at, const struct um_irradiation_loads *loads,
                     size_t entry, double absorptance)
{
  if (at->law == NULL) return 1.0 - absorptance;
  return 1.0 - absorptance * um_thermal_load_angle(at->law, loads, entry);
}

static double of_albedo(const struct um_thermal_surface *at,
                        const struct um_irradiation_loads *loads, size_t entry, double absorptance)
{
  if (at->law == NULL) return 1.0 - absorptance;
  double mean = 1.0 - absorptance * at->law->albedo;
  if (!at->law->by_angle || loads->planet_moments == NULL) return mean;
  return reflected(um_thermal_load_albedo(at, loads, entry, absorptance),
                   (double)loads->albedo[entry], mean);
}

static double of_planet(const struct um_thermal_surface *at,
                        const struct um_irradiation_loads *loads, size_t entry, double emittance)
{
  if (at->law == NULL) return 1.0 - emittance;
  double mean = 1.0 - emittance * at->law->planet;
  if (!at->law->by_angle || loads->planet_moments == NULL) return mean;
  return reflected(um_thermal_load_planet(at, loads, entry, emittance),
                   (double)loads->planet[entry], mean);
}

double um_thermal_surface_reflectance(const struct um_thermal_network *network,
                                      const struct um_irradiation_loads *loads,
                                      const struct um_thermal_aging *aging, size_t row,
                                      size_t surface, enum um_thermal_load load)
{
  const struct um_thermal_surface *at = &network->surface[surface];
  size_t entry = row * loads->nsurface + surface;
  if (load == UM_THERMAL_PLANET)
    return of_planet(at, loads, entry,
                     at->emittance * um_thermal_aged_emittance(aging, row, surface));
  double absorptance = um_thermal_aged_absorptance(network, aging, row, surface);
  return load == UM_THERMAL_SUN ? of_sun(at, loads, entry, absorptance)
                                : of_albedo(at, loads, entry, absorptance);
}
