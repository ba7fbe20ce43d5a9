/* Nuisances as blocks of a state. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_NUISANCE_IMPL_H
#define UMBRA_DIAGNOSIS_NUISANCE_IMPL_H

#include "evidence/diagnosis/state_impl.h"

/* A block of a use with all its parameters free, starting at its values; prior about the
 * scenario's values of width sigma (INFINITY: the effect's own). UM_ERR_INPUT: an effect without
 * parameters that is no core switch. */
enum um_status um_diagnosis_block_wanted(struct um_context *context,
                                         const struct um_diagnosis_work *work,
                                         const struct um_model_addition *wanted, double sigma,
                                         struct um_diagnosis_block *out);
/* UM_ERR_INPUT: one that is free per observation. */
enum um_status um_diagnosis_nuisance_check(struct um_context *context,
                                           const struct um_diagnosis_nuisance_effect *nuisance);
/* The nuisances of the options, into an empty state. UM_ERR_INPUT: one that is free per
 * observation. */
enum um_status um_diagnosis_nuisances(struct um_context *context,
                                      const struct um_diagnosis_work *work,
                                      struct um_diagnosis_state *state);

#endif
