/* A residual that no effect of the catalogue explains: the physical coordinate that it correlates
 * with, and for each place the heat that would explain it, with shape, start, energy and history.
 */
#ifndef UMBRA_MISSING_HEAT_UNEXPLAINED_H
#define UMBRA_MISSING_HEAT_UNEXPLAINED_H

#include "evidence/missing_heat/heat.h"
#include "evidence/sensitivity/forward.h"

struct um_missing_heat_unexplained {
  char *coordinate; /* that the residual correlates with most, "time_s"; NULL: none */
  char *channel;    /* "temperature body.+y" where the residual is worst */
  double p;         /* of that correlation */
  size_t nheat;
  struct um_missing_heat *heat;   /* [nheat] by BIC, the best first */
  double chi2_before, chi2_after; /* after the nuisances; with heat[0] */
  /* the best heat is significant (1 % over all places and courses) and leaves no more than a
   * twentieth of chi-square above its expectation, or three sigmas of that */
  bool found;
};

/* value: [nobservation] model values of the observations with the additions. nuisance:
 * [nnuisance][nobservation] whitened columns as in score.h, taken as free. The search
 * uses the linear response to heat along the model's history. The best three places are then
 * corrected by runs of the model with their heat. For each group and side it costs as much as the
 * light of a run, and up to nine runs in all. With orbit.points heat is not computed, and none is
 * looked for. Errors of the runs. The caller destroys. */
enum um_status um_missing_heat_unexplained_create(struct um_context *context,
                                                  struct um_sensitivity_forward *forward,
                                                  const struct um_model_addition *addition,
                                                  size_t naddition, const double *value,
                                                  const double *nuisance, size_t nnuisance,
                                                  struct um_missing_heat_unexplained **out);
void um_missing_heat_unexplained_destroy(struct um_context *context,
                                         struct um_missing_heat_unexplained **unexplained);

#endif
