/* The atmosphere between satellite and station. */
#ifndef UMBRA_ENVIRONMENT_AIRMASS_H
#define UMBRA_ENVIRONMENT_AIRMASS_H

/* Relative optical airmass [1] of an airless elevation [rad]: Kasten & Young 1989, Appl. Opt.
 * 28:4735. NaN below the horizon and for NaN. */
double um_environment_airmass(double elevation);

#endif
