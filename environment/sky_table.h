/* Air between telescope and space as another program computed it. */
#ifndef UMBRA_ENVIRONMENT_SKY_TABLE_H
#define UMBRA_ENVIRONMENT_SKY_TABLE_H

#include <stdbool.h>

#include "base/core/context.h"

struct um_environment_sky_table;

/* CSV with columns zenith_deg, wavelength_um, transmission and, if it is known,
 * radiance_W_m2_sr_um, as written from LOWTRAN, MODTRAN, libRadtran or SkyCalc: rows of one zenith
 * angle together, angles and wavelengths ascending, the same wavelengths at every angle; from the
 * telescope's height. UM_ERR_INPUT with file, line and what is accepted; UM_ERR_IO, UM_ERR_MEMORY.
 * The caller destroys. */
enum um_status um_environment_sky_table_read(struct um_context *context, const char *path,
                                             struct um_environment_sky_table **out);
void um_environment_sky_table_destroy(struct um_context *context,
                                      struct um_environment_sky_table **table);
bool um_environment_sky_table_covers(const struct um_environment_sky_table *table, double from,
                                     double to);
/* Means between two wavelengths [m]: rows are linear in wavelength, optical depth and radiance in
 * the airmass between the table's angles, proportional to it beyond them. */
double um_environment_sky_table_transmission(const struct um_environment_sky_table *table,
                                             double from, double to, double airmass);
double um_environment_sky_table_radiance(const struct um_environment_sky_table *table, double from,
                                         double to, double airmass);

#endif
