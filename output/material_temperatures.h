/* Mean temperatures of materials for other programs. */
#ifndef UMBRA_OUTPUT_MATERIAL_TEMPERATURES_H
#define UMBRA_OUTPUT_MATERIAL_TEMPERATURES_H

#include "base/core/file.h"
#include "output/output.h"

/* temperatures.cic (um_output_write_cic), and of every material MATERIAL.tsf: seconds since the
 * first observation, a tab, kelvins; '#' before comments. That is the time dynamic temperature
 * profile of STK EOIR (help of STK 12, externalTPF). UM_ERR_IO, UM_ERR_MEMORY. Test:
 * cli_app_formats. */
enum um_status um_output_write_material_temperatures(struct um_context *context,
                                                     const struct um_output_run *run,
                                                     struct um_core_folder *folder);

#endif
