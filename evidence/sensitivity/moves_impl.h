/* Heat of parameters that are moved one at a time, by forward sensitivities. Private to
 * evidence/sensitivity/. */
#ifndef UMBRA_SENSITIVITY_MOVES_IMPL_H
#define UMBRA_SENSITIVITY_MOVES_IMPL_H

#include "evidence/sensitivity/forward_impl.h"

/* Might heat's answer to an effect's parameters be a sensitivity, by what it declares? */
bool um_sensitivity_moves_heat(const struct um_effect *effect);
/* *out: does the scenario as it stands let them be? Does not fail but for memory. */
enum um_status um_sensitivity_moves_possible(struct um_context *context,
                                             const struct um_sensitivity_forward *forward,
                                             bool *out);
/* *out: have the loads to be traced or scaled for it? Not for one that is refused. UM_ERR_MEMORY.
 */
enum um_status um_sensitivity_moves_loads(struct um_context *context,
                                          const struct um_sensitivity_forward *forward,
                                          const struct um_sensitivity_move *move, bool *out);
/* How many geometries beside the scenario's, of its size, may be open for one run, at most `most`.
 */
size_t um_sensitivity_moves_open(const struct um_sensitivity_forward *forward, size_t most);
/* What temperatures, and light by them alone, answer to the moves [n], at the scenario as it
 * stands, all in one run: into the forward's cache. Moves that heat does not feel, that are refused
 * or that um_model_thermal_sensitivity_is_applicable does not let pass are left to runs of their
 * own. Heaters that come are found together, in a run of theirs. Targets live until _clear.
 * tolerance: of um_model_thermal_sensitivity_create. */
enum um_status um_sensitivity_moves_find(struct um_context *context,
                                         struct um_sensitivity_forward *forward,
                                         const struct um_sensitivity_move *move, size_t n,
                                         double tolerance);
void um_sensitivity_moves_clear(struct um_context *context, struct um_sensitivity_forward *forward);

#endif
