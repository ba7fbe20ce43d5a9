/* A network of nodes and conductors alone (thermal/solver/flat.h) for other programs. */
#ifndef UMBRA_THERMAL_NETWORK_WRITE_H
#define UMBRA_THERMAL_NETWORK_WRITE_H

#include <stdio.h>

#include "thermal/network/network.h"

/* What stands in such a file beside the network. */
struct um_thermal_network_note {
  const char *title; /* one line */
  double space;      /* temperature of space [K] */
};

/* Numbers read back the same; nodes are numbered from 1 in their order, space is the number behind
 * the last. Surfaces, laws, histories and thermostats are not in them. Errors of writing are the
 * stream's. Tests: output/network,
 * thermal/network/esatan. */

/* nodes.csv and conductors.csv, as um_thermal_network_read takes them. */
void um_thermal_network_write_nodes(const struct um_thermal_network *network, FILE *file);
void um_thermal_network_write_conductors(const struct um_thermal_network *network, FILE *file);
/* A file .d of ESATAN: degrees Celsius, TABS 273.15, STEFAN ours. */
void um_thermal_network_write_esatan(const struct um_thermal_network *network,
                                     const struct um_thermal_network_note *note, FILE *file);
/* An input file of SINDA/FLUINT: kelvins, ABSZRO 0, SIGMA ours. */
void um_thermal_network_write_sinda(const struct um_thermal_network *network,
                                    const struct um_thermal_network_note *note, FILE *file);

#endif
