/* umbra export --as vtu: the satellite with its temperatures, for ParaView, VTK and meshio. */
#include "app/export.h"
#include "output/vtu.h"

static int export_vtu(struct um_context *context, const struct um_app_options *options)
{
  return um_app_export_run(context, options, "vtu", false, um_output_write_vtu);
}

const struct um_app_export um_app_export_vtu = {
    .name = "vtu",
    .target = "FOLDER",
    .summary = "the satellite with its temperatures at every instant, for ParaView and meshio",
    .run = export_vtu};
