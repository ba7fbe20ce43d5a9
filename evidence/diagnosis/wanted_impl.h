/* Effects that a person chose, added to a state. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_WANTED_IMPL_H
#define UMBRA_DIAGNOSIS_WANTED_IMPL_H

#include "evidence/diagnosis/state_impl.h"

/* Add them and fit all; candidate i of the work is of wanted[i]. Where values are NAN, no start is
 * said. UM_ERR_INPUT: nothing to fit, too many free parameters. */
enum um_status um_diagnosis_add_wanted(struct um_context *context,
                                       const struct um_diagnosis_work *work,
                                       const struct um_model_addition *wanted, size_t nwanted,
                                       struct um_diagnosis_state *state);

#endif
