/* umbra export --as temperatures: temperatures of materials, for STK and SIRIUS. */
#include "app/export.h"
#include "output/material_temperatures.h"

static int export_temperatures(struct um_context *context, const struct um_app_options *options)
{
  return um_app_export_run(context, options, "temperatures", false,
                           um_output_write_material_temperatures);
}

const struct um_app_export um_app_export_temperatures = {
    .name = "temperatures",
    .target = "FOLDER",
    .summary =
        "mean temperatures of materials, a profile of STK each (.tsf), and all for SIRIUS (.cic)",
    .run = export_temperatures};
