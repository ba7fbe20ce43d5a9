/* What a diagnosis may look for and what it takes as uncertain. */
#ifndef UMBRA_DIAGNOSIS_OPTIONS_H
#define UMBRA_DIAGNOSIS_OPTIONS_H

#include "sensitivity/candidates.h"

/* Something that is uncertain anyway: its direction is projected out and it is fitted along. */
struct um_diagnosis_nuisance_effect {
  const struct um_effect *effect;
  const char *target;
  double sigma;    /* prior width of its parameters about the scenario's values; INFINITY: free */
  const char *per; /* NULL or "set"; "observation" is refused: it fits anything */
};

struct um_diagnosis_options {
  struct um_sensitivity_candidates_options candidates;
  const struct um_diagnosis_nuisance_effect *nuisance; /* [nnuisance] */
  size_t nnuisance;
  double level;        /* family-wise false-alarm rate; 0: 0.01 */
  size_t steps_max;    /* effects added at most; 0: 4 */
  size_t alternatives; /* candidates fitted at each step at most; 0: 8 */
  bool no_next;        /* do not look for the next measurement */
  bool no_heat;        /* do not reconstruct heat */
};

#endif
