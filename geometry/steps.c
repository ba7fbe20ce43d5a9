/* How finely a shape is divided. */
#include "geometry/steps_impl.h"

#include <math.h>

#include "geometry/patch_impl.h"

double um_geometry_step_count(double length, double step, double least)
{
  if (step <= 0.0) return least;
  /* the allowance keeps 1.0 / 0.1 at ten steps */
  return fmax(least, ceil(length / step * (1.0 - 1e-12)));
}

enum um_status um_geometry_count_check(const struct um_geometry_part_spec *spec,
                                       struct um_context *context, double count)
{
  if (count <= (double)UM_GEOMETRY_MAX_FACETS) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "part '%s': a facet size of %g m needs about %.3g facets; at most %zu are "
                      "accepted",
                      spec->name, spec->facet_size, count, UM_GEOMETRY_MAX_FACETS);
}
