/* What a forward keeps between evaluations, and the models it builds. Private to
 * evidence/sensitivity/. */
#ifndef UMBRA_SENSITIVITY_FORWARD_IMPL_H
#define UMBRA_SENSITIVITY_FORWARD_IMPL_H

#include "evidence/sensitivity/forward.h"
#include "evidence/sensitivity/moved_impl.h"

struct um_sensitivity_forward_cache {
  double *predicted; /* [observations of the set] in the unit of the quantity */
  double *base;      /* [nobservation] of the scenario as it stands, linear unit */
  double *few;       /* the same by as few paths as the scenario has; NULL: there are no fewer */
  double noise;      /* um_sensitivity_forward_noise; NaN: not yet known */
  bool fresh_heat; /* the last evaluation had heat of its own, which an integration gives with noise
                    */
  bool moved_heat; /* and it came by a sensitivity, without */
  struct um_sensitivity_moves *moves; /* NULL: none are known */
};

/* Largest change of an observation [sigma] when the scenario's own heat is integrated anew from
 * where it ended: how well heat that is integrated repeats. Computed once. */
enum um_status um_sensitivity_forward_noise(struct um_context *context,
                                            struct um_sensitivity_forward *forward, double *out);
/* By how many paths light between surfaces goes in evaluations from now on: as few as the scenario
 * has, or as many as the observations want. What few paths make of the scenario as it stands is
 * known beside the true one, and what they make of a variant is corrected by that: a difference has
 * the sampling error of few as a share of itself. That holds where both see the same surfaces along
 * the same paths. */
enum um_sensitivity_paths {
  UM_SENSITIVITY_VALUES,     /* few with the scenario's own geometry, many with another: a forward
                                begins so */
  UM_SENSITIVITY_SIGNATURES, /* few: a hundredth of a signature is small beside its score */
  UM_SENSITIVITY_DERIVATIVES /* many: what is promised of them holds */
};
enum um_status um_sensitivity_forward_paths(struct um_context *context,
                                            struct um_sensitivity_forward *forward,
                                            enum um_sensitivity_paths paths);
/* Values [n] by few paths, corrected by what few paths and all make of the scenario as it stands,
 * few [n] and base [n]. Where few are right within a tenth, what they miss is a share of the light;
 * else light is faint, and what is added behind it may be most of a value: an amount. The scenario
 * itself keeps its bits. */
void um_sensitivity_forward_correct(const double *few, const double *base, size_t n, double *value);
/* um_sensitivity_forward_evaluate of the move, at its step, with heat by the answer that was found.
 */
enum um_status um_sensitivity_forward_evaluate_move(struct um_context *context,
                                                    struct um_sensitivity_forward *forward,
                                                    const struct um_sensitivity_move *move,
                                                    double *value);

/* What of a variant is moved, by the chain rule dm/dp = dm/dp at given temperatures + dm/dT dT/dp.
 */
enum um_sensitivity_part {
  UM_SENSITIVITY_WHOLE,
  UM_SENSITIVITY_HELD, /* everything but temperatures, which are those of the scenario */
  UM_SENSITIVITY_HEAT  /* temperatures alone */
};
/* um_sensitivity_forward_evaluate of one addition, of a part of it. *apart: it can be taken apart,
 * as it has the scenario's surfaces, nodes and instants; without that nothing is evaluated. Of
 * the whole always true. */
enum um_status um_sensitivity_forward_evaluate_part(struct um_context *context,
                                                    struct um_sensitivity_forward *forward,
                                                    const struct um_model_addition *addition,
                                                    enum um_sensitivity_part part, bool *apart,
                                                    double *value);
/* Values of the scenario as it stands with the body turned by a rotation vector in its own axes
 * [rad] at every instant, with its heat and loads (um_model_run_turned). */
enum um_status um_sensitivity_forward_evaluate_turned(struct um_context *context,
                                                      struct um_sensitivity_forward *forward,
                                                      struct um_vec3 turn, double *value);
#endif
