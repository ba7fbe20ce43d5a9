/* Cases of the thermal half: conduction, radiation, networks, insides, orbits, view factors by
 * rays. */
#include "app/validate/cases_impl.h"

enum um_status um_validate_thermal(struct um_context *context, struct um_validate_report *report)
{
  UM_TRY(um_validate_conduction(context, report));
  UM_TRY(um_validate_radiation(context, report));
  UM_TRY(um_validate_networks(context, report));
  UM_TRY(um_validate_inside(context, report));
  UM_TRY(um_validate_orbiting(context, report));
  return um_validate_view_factors(context, report);
}
