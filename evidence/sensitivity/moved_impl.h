/* Parameters that are moved one at a time, and what is known of their heat. Private to
 * evidence/sensitivity/. */
#ifndef UMBRA_SENSITIVITY_MOVED_IMPL_H
#define UMBRA_SENSITIVITY_MOVED_IMPL_H

#include "model/products/light_sensitivity.h"

/* An effect beside those of the scenario that leaves every temperature as it is, and one of its
 * parameters moved from there. */
struct um_sensitivity_move {
  const struct um_effect *effect;
  const char *target;                  /* borrowed; NULL: global */
  double at[UM_EFFECT_PARAMETERS_MAX]; /* [nparameter] */
  size_t parameter;
  double step; /* [its unit], signed, not 0 */
};

/* A move whose heat is known. */
struct um_sensitivity_moved {
  struct um_sensitivity_move move;
  const struct um_model_thermal_sensitivity *sensitivity; /* NULL: not by that */
  const struct um_model_light_sensitivity
      *light;   /* where it moves nothing but temperatures; NULL */
  size_t which; /* of both */
};
/* Answers of the moves of one run. */
struct um_sensitivity_answers {
  struct um_model_thermal_sensitivity *thermal;
  struct um_model_light_sensitivity *light;
};
struct um_sensitivity_moves {
  struct um_sensitivity_moved *moved; /* [count] */
  size_t count;
  struct um_sensitivity_answers *run; /* [nrun] owned */
  size_t nrun;
};

/* Accepts NULL, sets NULL. */
void um_sensitivity_moves_destroy(struct um_context *context, struct um_sensitivity_moves **moves);

/* The one of the same effect, place and parameter, whatever the step, whose answer is known; NULL:
 * none, also where moves or move are. */
const struct um_sensitivity_moved *um_sensitivity_moves_of(const struct um_sensitivity_moves *moves,
                                                           const struct um_sensitivity_move *move);

#endif
