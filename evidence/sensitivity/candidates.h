/* The list of candidates for what a scenario lacks, each with its signature. */
#ifndef UMBRA_SENSITIVITY_CANDIDATES_H
#define UMBRA_SENSITIVITY_CANDIDATES_H

#include "evidence/sensitivity/candidate.h"
#include "evidence/sensitivity/forward.h"

/* An effect that was asked for and is no candidate. */
struct um_sensitivity_dropped {
  char *name, *why; /* owned */
};

struct um_sensitivity_candidates {
  size_t count, nobservation;
  struct um_sensitivity_candidate
      *candidate; /* [count], in the order of effects, then of targets */
  double *base;   /* [nobservation] model values without them */
  size_t ndropped;
  struct um_sensitivity_dropped *dropped; /* [ndropped] of those that `only` named */
};

struct um_sensitivity_candidates_options {
  const char *const *only; /* [nonly] "effect" or "effect:target"; none: every effect */
  size_t nonly;
  const char *const *exclude; /* [nexclude] likewise; taken out of what is left */
  size_t nexclude;
  const struct um_model_addition
      *wanted;    /* [nwanted] exactly these uses in their order, whatever */
  size_t nwanted; /* their targets and values; none: as said above */
  /* Columns are derivatives, good to the error that is said of each: a thousandth where the model
   * is smooth. Otherwise differences over a step that a fit takes, good to some per cent. */
  bool derivatives;
};

/* Every effect of the model on every target it may have there (parts, sides, materials, bands, or
 * everything), and core switches that are off. A parameter that does nothing while the others are
 * null stays at its default, or, where it is a temperature, at one that the target has. Two targets
 * that are the same thing (a part of one side) appear once. Steps are one-sided into the allowed
 * range, of the order of a fifth of the prior width, halved or doubled until the change of the
 * observations stands above the noise of the integration. additions: what the model already has
 * beside the scenario; they are not listed again. A switch that has values is listed with each of
 * them at its null value and at either end of its range. UM_ERR_INPUT: `only` or `exclude` name no
 * effect, `only` a target that the effect cannot have. Progress is reported. The caller destroys.
 */
enum um_status
um_sensitivity_candidates_create(struct um_context *context, struct um_sensitivity_forward *forward,
                                 const struct um_model_addition *addition, size_t naddition,
                                 const struct um_sensitivity_candidates_options *options,
                                 struct um_sensitivity_candidates **out);
void um_sensitivity_candidates_destroy(struct um_context *context,
                                       struct um_sensitivity_candidates **candidates);

/* Is it on by default, and on in the scenario? A candidate of it turns it off. */
bool um_sensitivity_is_on(const struct um_sensitivity_forward *forward,
                          const struct um_effect *effect);

#endif
