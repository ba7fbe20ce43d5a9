/* What the thermal cases share. */
#include "app/validate/thermal_case_impl.h"

struct um_thermal_solve_options um_validate_tight(double space)
{
  struct um_thermal_solve_options options;
  um_thermal_solve_defaults(&options);
  options.relative_tolerance = 1e-10;
  options.absolute_tolerance = 1e-9;
  options.space_temperature = space;
  return options;
}

enum um_status um_validate_surface(struct um_thermal_network *network, uint32_t surface,
                                   uint32_t node, double area, double absorptance, double emittance)
{
  struct um_thermal_surface s = {.node = {node, UM_THERMAL_SPACE, UM_THERMAL_SPACE},
                                 .weight = {1.0, 0.0, 0.0},
                                 .area = area,
                                 .absorptance = absorptance,
                                 .emittance = emittance};
  return um_thermal_network_surface_attach(network, surface, &s);
}

enum um_status um_validate_loads(struct um_context *context, size_t nsurface, double irradiance,
                                 const double *sun, const double *planet,
                                 struct um_irradiation_loads **out)
{
  UM_TRY(um_irradiation_loads_create(context, 1, nsurface, 0, out));
  (*out)->sunlit[0] = 1.0;
  (*out)->irradiance[0] = irradiance;
  for (size_t i = 0; i < nsurface; i++) {
    (*out)->sun[i] = (float)sun[i];
    (*out)->planet[i] = planet == NULL ? 0.0F : (float)planet[i];
  }
  return UM_OK;
}
