/* Files of the radiation that surfaces exchange. */
#ifndef UMBRA_OUTPUT_EXCHANGE_H
#define UMBRA_OUTPUT_EXCHANGE_H

#include "base/core/file.h"
#include "geometry/view_factor_table.h"
#include "model/build/model.h"
#include "thermal/exchange/exchange.h"

/* outside.csv and inside-PART.csv, view factors (geometry/view_factor_file.h), and couplings.csv:
 * total exchange areas eps_p B_pq eps_q of patches, of which sigma (T_p^4 - T_q^4) flows, and what
 * goes to space, at the network's emittances, those of 300 K where a record has them by
 * temperature: two surfaces share one number only while each has one emittance. exchange NULL: no
 * couplings. UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_output_write_exchange(struct um_context *context, const struct um_model *model,
                                        const struct um_geometry_view_factor_table *table,
                                        const struct um_thermal_exchange *exchange,
                                        struct um_core_folder *folder);

#endif
