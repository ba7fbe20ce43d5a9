/* A heat balance as nodes and conductors alone, for programs that know no surfaces. */
#ifndef UMBRA_THERMAL_FLAT_H
#define UMBRA_THERMAL_FLAT_H

#include "thermal/network/network.h"
#include "thermal/network/solve_options.h"

/* A network of the same nodes without surfaces, laws, histories and thermostats, whose balance at
 * temperature[nnode] [K] under power[nnode] [W], as in um_thermal_solve_powered, is that of
 * `network`: emission to space and between surfaces as radiators, what depends on temperature as it
 * is there, thermostats at their mean power. So both have the same steady state where `temperature`
 * is it; elsewhere where nothing depends on temperature. Moving parts stand as at the beginning. A
 * node begins at its temperature and is named as in messages where it has no name, "bus-12".
 * UM_ERR_INPUT: more than 20 million couplings between surfaces. The
 * caller destroys. Test: output/network. */
enum um_status um_thermal_flatten(struct um_context *context,
                                  const struct um_thermal_network *network, const double *power,
                                  const struct um_thermal_solve_options *options,
                                  const double *temperature, struct um_thermal_network **out);

#endif
