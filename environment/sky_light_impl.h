/* Air that scatters, for first and later orders. Private to environment/. */
#ifndef UMBRA_ENVIRONMENT_SKY_LIGHT_IMPL_H
#define UMBRA_ENVIRONMENT_SKY_LIGHT_IMPL_H

#include "environment/sky_light.h"

#define UM_SKY_AEROSOL_ALBEDO    0.95
#define UM_SKY_AEROSOL_ASYMMETRY 0.70

/* How much of each constituent stands above sea level: air of one atmosphere, ozone [DU], aerosols
 * of depth at 0.55 um. */
void um_environment_sky_amounts(const struct um_environment *environment,
                                const struct um_environment_slant *slant, double height,
                                double amount[UM_LIMB_CONSTITUENTS]);
/* Vertical optical depths of them [1]. */
void um_environment_sky_depths(const double amount[UM_LIMB_CONSTITUENTS], double angstrom,
                               double wavelength, double depth[UM_LIMB_CONSTITUENTS]);

/* Phase function of air [1/sr], 1/(4 pi) in the mean. */
double um_environment_sky_rayleigh(double cosine);
/* The same of aerosol. */
double um_environment_sky_aerosol(double cosine);

/* Wavelengths of the table [m]. */
extern const double um_environment_sky_wavelengths[UM_SKY_LIGHT_WAVELENGTHS];
/* Fill out->again for out->first and out->count. */
enum um_status um_environment_sky_orders(struct um_context *context,
                                         const struct um_environment *environment,
                                         struct um_environment_sky_light *out);
/* Place in it. */
double um_environment_sky_row(double height);
double um_environment_sky_col(double zenith_angle);
/* ln of it. */
double um_environment_sky_again(const double table[UM_SKY_LIGHT_HEIGHTS][UM_SKY_LIGHT_ANGLES],
                                double row, double col);

#endif
