/* The air between telescope and satellite: what it lets through, and how it glows. */
#ifndef UMBRA_OUTPUT_SKY_H
#define UMBRA_OUTPUT_SKY_H

#include "base/core/file.h"
#include "output/output.h"

/* Two tables in the wavelengths of the scenario's bands [um], radiance in W/m^2/sr/um:
 * air.csv    zenith_deg, wavelength_um, transmission, radiance_W_m2_sr_um: what observer.air.file
 *            takes (environment/sky_table.h). Radiance is heat alone.
 * sky.csv    time_utc, band, wavelength_um, transmission, radiance_W_m2_sr_um: means over the bins
 *            of each band along the line of sight of every observation, with the sunlight and
 *            moonlight that the air scatters. Rows of hidden observations are left out.
 * run->result is not read. UM_ERR_INPUT where no air is stated or its effect is off; UM_ERR_IO,
 * UM_ERR_MEMORY. Tests: cli_app_formats, verify_output_sky. */
enum um_status um_output_write_sky(struct um_context *context, const struct um_output_run *run,
                                   struct um_core_folder *folder);

#endif
