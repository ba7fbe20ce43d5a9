/* Ground and cloud by latitude and month. */
#ifndef UMBRA_ENVIRONMENT_ZONES_H
#define UMBRA_ENVIRONMENT_ZONES_H

/* Temperature of the air near the ground [K] and share of the sky that cloud covers [1], means of
 * all longitudes, at a latitude [rad] and a month as of um_environment_month_of. Linear between
 * the middles of months and of belts of 10 deg; constant beyond the last belts. */
void um_environment_zones(double latitude, double month, double *surface, double *cloud);
/* Share of the ground that is land, between the middles of belts as above [1]. */
double um_environment_zone_land(double latitude);

#endif
