/* Cases of the optical half: radiometry, surfaces, bodies. */
#include "app/validate_optics_impl.h"

enum um_status um_app_validate_optics(struct um_context *context, struct um_app_report *report)
{
  UM_TRY(um_app_validate_radiometry(context, report));
  UM_TRY(um_app_validate_surfaces(context, report));
  return um_app_validate_bodies(context, report);
}
