/* Cases of the optical half: radiometry, surfaces, bodies. */
#include "app/validate/cases_impl.h"

enum um_status um_validate_optics(struct um_context *context, struct um_validate_report *report)
{
  UM_TRY(um_validate_radiometry(context, report));
  UM_TRY(um_validate_surfaces(context, report));
  return um_validate_bodies(context, report);
}
