/* The heat balance of a scenario as a network, for other thermal programs. */
#ifndef UMBRA_OUTPUT_NETWORK_H
#define UMBRA_OUTPUT_NETWORK_H

#include "base/core/file.h"
#include "model/build/model.h"

/* nodes.csv and conductors.csv (as a part's `network` takes them), network.d of ESATAN, network.inp
 * of SINDA/FLUINT, of a network of nodes and conductors alone. UM_ERR_IO. */
enum um_status um_output_write_network(struct um_context *context, const struct um_model *model,
                                       const struct um_thermal_network *network,
                                       struct um_core_folder *folder);

#endif
