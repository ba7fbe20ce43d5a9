/* Libraries under a Sun, for tests. */
#ifndef UMBRA_TESTS_MATERIALS_SUN_H
#define UMBRA_TESTS_MATERIALS_SUN_H

#include "environment/environment.h"
#include "materials/materials.h"

/* An empty library under a black body of 5772 K, or under E490 as by default. */
static inline enum um_status library_under(struct um_context *context,
                                           enum um_environment_spectrum spectrum,
                                           struct um_materials_library **library)
{
  struct um_environment environment;
  struct um_materials_sun sun;
  um_environment_defaults(&environment);
  environment.spectrum = spectrum;
  environment.solar_temperature = 5772.0;
  um_environment_sun_shares(&environment, &sun);
  return um_materials_library_create(context, &sun, library);
}
#define library_under_e490(context, library) library_under(context, UM_SPECTRUM_E490, library)

#endif
