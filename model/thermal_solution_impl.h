/* Temperatures of a run. Private to model/. */
#ifndef UMBRA_MODEL_THERMAL_SOLUTION_IMPL_H
#define UMBRA_MODEL_THERMAL_SOLUTION_IMPL_H

#include "model/heat_setting_impl.h"
#include "model/model.h"
#include "model/precomputed.h"
#include "thermal/solve.h"

/* Temperatures at every instant of the geometry precomputation. history: rows
 * are an instant one orbit before the first (when `before`), then the geometry precomputation's
 * instants. */
struct um_model_heat_run {
  struct um_thermal_history *history;
  bool before;
  double *surface; /* [ninstant][nsurface] [K] */
};
struct um_model_thermal_solution {
  const struct um_model *model;                   /* borrowed */
  const struct um_model_precomputed *precomputed; /* borrowed */
  struct um_model_heat_setting setting;
  double *start;         /* [nnode] start temperatures [K] */
  double periodic_drift; /* what the periodic start left [K]; NaN when isothermal */
  struct um_model_heat_run run;
};

#endif
