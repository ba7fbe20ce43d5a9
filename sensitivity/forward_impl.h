/* What a forward keeps between evaluations, and the models it builds. Private to sensitivity/. */
#ifndef UMBRA_SENSITIVITY_FORWARD_IMPL_H
#define UMBRA_SENSITIVITY_FORWARD_IMPL_H

#include "sensitivity/forward.h"

/* Geometry precomputations kept beside the scenario's own: one iteration of a fit moves several
 * parameters that each want another. */
#define UM_SENSITIVITY_CACHED 3

/* One geometry precomputation with heat on it, and the model they were made from. */
struct um_sensitivity_cached {
  struct um_model_addition *key; /* [nkey] additions that it stands for; 0 of the scenario */
  size_t nkey;
  struct um_model *model; /* owned, but the scenario's own */
  struct um_model_precomputed *precomputed;
  struct um_model_thermal_solution *heat; /* NULL: that of the scenario serves */
  size_t used;                            /* number of the evaluation that used it last */
};

struct um_sensitivity_forward_cache {
  struct um_sensitivity_cached own; /* of the scenario as it stands */
  struct um_sensitivity_cached kept[UM_SENSITIVITY_CACHED];
  double *predicted; /* [observations of the set] in the unit of the quantity */
  double *base;      /* [nobservation] of the scenario as it stands, linear unit */
  double noise;      /* um_sensitivity_forward_noise; NaN: not yet known */
  bool fresh_heat;   /* the last evaluation integrated heat of its own */
};

/* Largest change of an observation [sigma] when the scenario's own heat is integrated anew from
 * where it ended: how well heat that is integrated repeats. Computed once. */
enum um_status um_sensitivity_forward_noise(struct um_context *context,
                                            struct um_sensitivity_forward *forward, double *out);
#endif
