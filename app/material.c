/* umbra material: a record of a material, or what it needs, from measurements. */
#include "app/app.h"

int um_app_material(struct um_context *context, const struct um_app_options *options)
{
  if (options->from_reflectance != NULL) return um_app_materials_reflectance(context, options);
  if (options->from_profile != NULL) return um_app_materials_profile(context, options);
  if (options->from_brdf != NULL) return um_app_materials_fit(context, options);
  fputs("umbra: measurements are missing; accepted: --from-brdf FILE, --from-profile FILE, "
        "--from-reflectance FILE\n",
        stderr);
  return UM_APP_MISUSE;
}
