/* umbra export --as sky: the air before the satellite. */
#include "app/export.h"
#include "output/sky.h"

static int export_sky(struct um_context *context, const struct um_app_options *options)
{
  return um_app_export_run(context, options, "sky", true, um_output_write_sky);
}

const struct um_app_export um_app_export_sky = {
    .name = "sky",
    .target = "FOLDER",
    .summary =
        "transmission and radiance of the air [W/m2/sr/um]: by zenith angle, and at every instant",
    .run = export_sky};
