/* Heat of parameters that are moved one at a time, by forward sensitivities. Private to
 * evidence/sensitivity/. */
#ifndef UMBRA_SENSITIVITY_MOVES_IMPL_H
#define UMBRA_SENSITIVITY_MOVES_IMPL_H

#include "evidence/sensitivity/forward_impl.h"

/* What temperatures answer to the moves [n], at the scenario as it stands, many in one run: into
 * the forward's cache. Moves that heat does not feel, that are refused or that
 * um_model_thermal_sensitivity_is_applicable does not let pass are left to runs of their own. Their
 * targets live until _clear. */
enum um_status um_sensitivity_moves_find(struct um_context *context,
                                         struct um_sensitivity_forward *forward,
                                         const struct um_sensitivity_move *move, size_t n);
void um_sensitivity_moves_clear(struct um_context *context, struct um_sensitivity_forward *forward);

#endif
