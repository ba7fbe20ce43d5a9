/* The atmosphere between satellite and station. */
#ifndef UMBRA_OPTICS_ATMOSPHERE_H
#define UMBRA_OPTICS_ATMOSPHERE_H

/* Relative optical airmass [1] of an airless elevation [rad]: Kasten & Young 1989, Appl. Opt.
 * 28:4735. NaN below the horizon and for NaN. */
double um_optics_airmass(double elevation);

#endif
