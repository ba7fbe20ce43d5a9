/* What a diagnosis looks for, and its nuisances. */
#ifndef UMBRA_DIAGNOSIS_OPTIONS_H
#define UMBRA_DIAGNOSIS_OPTIONS_H

#include <stdint.h>

#include "evidence/sensitivity/candidates.h"

/* A nuisance: its direction is projected out of the tests, and it is fitted with the effects. */
struct um_diagnosis_nuisance_effect {
  const struct um_effect *effect;
  const char *target;
  double sigma;    /* prior width of its parameters about the scenario's values; INFINITY: free */
  const char *per; /* NULL, "set" or "all", which the request has made of it; "observation" is
                      refused: it fits anything */
};

struct um_diagnosis_options {
  struct um_sensitivity_candidates_options candidates;
  const struct um_diagnosis_nuisance_effect *nuisance; /* [nnuisance] */
  size_t nnuisance;
  double level;        /* family-wise false-alarm rate; 0: 0.01 */
  size_t steps_max;    /* effects added at most; 0: 4 */
  size_t alternatives; /* candidates fitted at each step at most; 0: 8 */
  bool no_next;        /* do not look for the next measurement */
  size_t passes;       /* to come over each station, of which each is looked at as such; each costs
                          two runs of heat from the first measurement to it */
  bool no_heat;        /* do not reconstruct heat */
  size_t draws;        /* from the posterior of chosen effects, each a run; 0: none */
  uint64_t seed;       /* of them */
  bool no_light;       /* do not look for a correction of light */
  bool draft; /* whatever the verdict, say which heat and which correction of light explain the
                 scenario without additions: heat_asked, light_asked */
};

#endif
