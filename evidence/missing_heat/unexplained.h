/* A residual that no effect of the catalogue explains: the physical coordinate that it correlates
 * with, and for each place the heat that would explain it, with start, energy and history. */
#ifndef UMBRA_MISSING_HEAT_UNEXPLAINED_H
#define UMBRA_MISSING_HEAT_UNEXPLAINED_H

#include "evidence/sensitivity/forward.h"

/* Missing heat of one place: the wall of a group ("bus.+y"; "panel" where a part has one group) or
 * an interior. Pulses begin and end at times of observation, at the satellite; heat before the
 * first is not looked for. */
struct um_missing_heat {
  char *place;           /* "bus.+y", "bus.interior" */
  double chi2_explained; /* by the best pulse; falls along the list */
  double start, stop;    /* t_tai of the best pulse [s] */
  double start_sigma;    /* [s] from the chi-square of its neighbours */
  double power, energy;  /* [W], [J] of the best pulse; below 0: heat that goes */
  double energy_sigma;   /* [J] over all pulses that fit, with the error of the linear response */
  /* regularised history: second differences damped until chi-square meets its expectation */
  size_t nbin;
  double *t;     /* [nbin + 1] edges, t_tai [s] */
  double *heat;  /* [nbin] [W] */
  double *sigma; /* [nbin] [W] */
};
struct um_missing_heat_unexplained {
  char *coordinate; /* that the residual correlates with most, "time_s"; NULL: none */
  char *channel;    /* "temperature body.+y" where the residual is worst */
  double p;         /* of that correlation */
  size_t nheat;
  struct um_missing_heat *heat;   /* [nheat] by chi2_explained, falling */
  double chi2_before, chi2_after; /* after the nuisances; with the best pulse of heat[0] */
  /* the best pulse is significant (1 % over all places and times) and leaves no more than a
   * twentieth of chi-square above its expectation, or three sigmas of that */
  bool found;
};

/* value: [nobservation] model values of the observations with the additions. nuisance:
 * [nnuisance][nobservation] whitened columns as in score.h, taken as free. The search
 * uses the linear response to heat along the model's history. The powers of the best three pulses
 * are then found with the model itself. For each group and side it costs as much as the light of a
 * run, and up to nine runs in all. With orbit.points heat is not computed, and none is looked for.
 * Errors of the runs. The caller destroys. */
enum um_status um_missing_heat_unexplained_create(struct um_context *context,
                                                  struct um_sensitivity_forward *forward,
                                                  const struct um_model_addition *addition,
                                                  size_t naddition, const double *value,
                                                  const double *nuisance, size_t nnuisance,
                                                  struct um_missing_heat_unexplained **out);
void um_missing_heat_unexplained_destroy(struct um_context *context,
                                         struct um_missing_heat_unexplained **unexplained);

#endif
