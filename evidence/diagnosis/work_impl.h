/* The work that every step is part of. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_WORK_IMPL_H
#define UMBRA_DIAGNOSIS_WORK_IMPL_H

#include "evidence/diagnosis/options.h"
#include "evidence/sensitivity/forward.h"

/* What became of a candidate. */
enum um_diagnosis_fate { UM_FATE_NOT_FITTED, UM_FATE_FITTED, UM_FATE_REFUSED };

/* What is diagnosed, and how; passed around. */
struct um_diagnosis_work {
  struct um_sensitivity_forward *forward;
  const struct um_sensitivity_candidates *candidates;
  const struct um_diagnosis_options *options;
  double level;
  size_t steps_max, alternatives;
  size_t *fold; /* [nobservation] blocks of time that are held out in turn */
  size_t nfold;
  enum um_diagnosis_fate *fate; /* [count of candidates] */
};

#endif
