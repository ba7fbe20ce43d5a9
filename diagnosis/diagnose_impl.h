/* Steps of a diagnosis. Private to diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_DIAGNOSE_IMPL_H
#define UMBRA_DIAGNOSIS_DIAGNOSE_IMPL_H

#include <math.h>

#include "diagnosis/diagnose.h"
#include "diagnosis/fit.h"

#define UM_DIAGNOSIS_EVIDENCE 10.0 /* difference of BIC that decides: odds of 150 to 1 */

/* Parameters are fitted, and their priors stand, in the unit of their prior: the logarithm of a
 * logarithmic one, else the value itself. */
static inline double um_diagnosis_inner(const struct um_effect_parameter *parameter, double value)
{
  return parameter->logarithmic ? log(value) : value;
}
static inline double um_diagnosis_outer(const struct um_effect_parameter *parameter, double inner)
{
  return parameter->logarithmic ? exp(inner) : inner;
}
/* d(value) / d(inner) */
static inline double um_diagnosis_slope(const struct um_effect_parameter *parameter, double value)
{
  return parameter->logarithmic ? value : 1.0;
}

/* An effect whose parameters are fitted: a nuisance, an accepted effect or a rival. */
struct um_diagnosis_block {
  struct um_diagnosis_addition addition; /* parameters that are not free stay as they are here */
  size_t candidate;                      /* of the candidates; UM_COMPARE_NOWHERE: a nuisance */
  size_t nfree;                          /* 0 for a switch */
  size_t parameter[UM_EFFECT_PARAMETERS_MAX];   /* [nfree] of the effect's */
  double prior_mean[UM_EFFECT_PARAMETERS_MAX];  /* [nfree] inner, as are the next two */
  double prior_sigma[UM_EFFECT_PARAMETERS_MAX]; /* [nfree] */
  double step[UM_EFFECT_PARAMETERS_MAX];        /* [nfree] */
};

/* What is fitted together, and its fit: nuisances first, then effects in the order they came. */
struct um_diagnosis_state {
  size_t nblock, nnuisance; /* blocks of which the first are nuisances */
  struct um_diagnosis_block *block;
  size_t nparameter;
  double beaten; /* BIC that its next fit has to come below to be of use; 0: any is */
  struct um_diagnosis_fit *fit;
};

/* The whole work, passed around. */
struct um_diagnosis_work {
  struct um_diagnosis_forward *forward;
  const struct um_diagnosis_candidates *candidates;
  const struct um_diagnosis_options *options;
  double level;
  size_t steps_max, rivals;
  size_t *fold; /* [nrow] blocks of time that are held out in turn */
  size_t nfold;
};

/* --- state.c */
/* A block of a candidate at its null values. */
struct um_diagnosis_block um_diagnosis_block_of(const struct um_diagnosis_work *work,
                                                size_t candidate);
/* Append a copy; the fit of the state is no longer its own (the caller makes one). */
enum um_status um_diagnosis_state_append(struct um_context *context,
                                         struct um_diagnosis_state *state,
                                         const struct um_diagnosis_block *block);
/* A copy of the blocks without number `omit` (nblock or more: all), without a fit. */
enum um_status um_diagnosis_state_copy(struct um_context *context,
                                       const struct um_diagnosis_state *state, size_t omit,
                                       struct um_diagnosis_state *out);
void um_diagnosis_state_release(struct um_context *context, struct um_diagnosis_state *state);
/* Fit all free parameters of the state from the values in its blocks, which take the result. value
 * [nrow] and jacobian [nparameter][nrow] (by inner parameters) at the start, or NULL. Replaces
 * state->fit.
 */
enum um_status um_diagnosis_state_fit(struct um_context *context,
                                      const struct um_diagnosis_work *work,
                                      struct um_diagnosis_state *state, const double *value,
                                      const double *jacobian);
/* Additions of all blocks; out: [nblock]. */
void um_diagnosis_state_additions(const struct um_diagnosis_state *state,
                                  struct um_diagnosis_addition *out);
/* Sigma of the parameters of a block after the fit, by the effect's parameters; NaN for those that
 * were not free. */
void um_diagnosis_state_sigma(const struct um_diagnosis_state *state, size_t block, double *sigma);
/* Chi-square of held-out rows. */
enum um_status um_diagnosis_state_held_out(struct um_context *context,
                                           const struct um_diagnosis_work *work,
                                           const struct um_diagnosis_state *state, double *out);

/* Parameters that have no prior. */
double um_diagnosis_free_parameters(const struct um_diagnosis_state *state);
/* Whether the residual of the fit is white noise. */
enum um_status um_diagnosis_state_whiteness(struct um_context *context,
                                            const struct um_diagnosis_work *work,
                                            const struct um_diagnosis_state *state,
                                            struct um_diagnosis_whiteness *out);

/* --- rank.c */
/* Test all candidates on the residual of the state; rival: [count of candidates], by what they
 * promise, falling; nrival: those alive. */
enum um_status um_diagnosis_rank(struct um_context *context, const struct um_diagnosis_work *work,
                                 const struct um_diagnosis_state *state,
                                 struct um_diagnosis_rival *rival, size_t *nrival);
/* Mark who cannot be told from the winner, which is rival[0]; signal: [nrow] whitened change that
 * the winner made. */
enum um_status um_diagnosis_rank_groups(struct um_context *context,
                                        const struct um_diagnosis_work *work,
                                        const struct um_diagnosis_state *state,
                                        const double *signal, struct um_diagnosis_step *step);

/* --- jagged.c */
/* Start values of block b of a state, a candidate with parameters of shape that was added to the
 * fitted state `before`: the best of a small scan. */
enum um_status um_diagnosis_start(struct um_context *context, const struct um_diagnosis_work *work,
                                  const struct um_diagnosis_state *before,
                                  struct um_diagnosis_state *state, size_t b);

/* Block b of a fitted state, with parameters of shape, searched for better values beyond the next
 * jag of chi-square; the state, fitted anew, is the better one of both. */
enum um_status um_diagnosis_polish(struct um_context *context, const struct um_diagnosis_work *work,
                                   struct um_diagnosis_state *state, size_t b);

/* --- rivals.c */
/* The state with candidates added at their null values and all fitted, given up where it is far
 * from a BIC below `beaten` (INFINITY: never). UM_ERR_INPUT, UM_ERR_NUMERIC: an effect refuses such
 * values. */
enum um_status um_diagnosis_with(struct um_context *context, const struct um_diagnosis_work *work,
                                 const struct um_diagnosis_state *state, const size_t *candidate,
                                 size_t ncandidate, double beaten, struct um_diagnosis_state *out);
/* Fit rivals of a step in their order until those left are out of reach; sort them by evidence.
 * best: the state with the best of those fitted here, or as it was. */
enum um_status um_diagnosis_fit_rivals(struct um_context *context,
                                       const struct um_diagnosis_work *work,
                                       const struct um_diagnosis_state *state,
                                       struct um_diagnosis_step *step,
                                       struct um_diagnosis_state *best);

/* --- select.c */
/* Figures of a step from the state before it to the best one after, and the winner's group. */
enum um_status um_diagnosis_step_fill(struct um_context *context,
                                      const struct um_diagnosis_work *work,
                                      const struct um_diagnosis_state *state,
                                      const struct um_diagnosis_state *best,
                                      struct um_diagnosis_step *step);
/* One step of forward selection: rank, fit rivals, add the winner to the state. *added: false when
 * nothing is significant or nothing helps. */
enum um_status um_diagnosis_select(struct um_context *context, const struct um_diagnosis_work *work,
                                   struct um_diagnosis_state *state, struct um_diagnosis_step *step,
                                   bool *added);
/* --- exchange.c */
/* Two effects may explain together what the best single one only resembles: try pairs in place of
 * the effect added last and one before it; the better pair stays. */
enum um_status um_diagnosis_exchange(struct um_context *context,
                                     const struct um_diagnosis_work *work,
                                     struct um_diagnosis_state *state);

/* --- conditional.c */
/* Steps anew, each effect as the last one beside the others that stayed: its rivals, its group, its
 * p; an effect that a rival betters is replaced. In falling order of what they explain. */
enum um_status um_diagnosis_conditional(struct um_context *context,
                                        const struct um_diagnosis_work *work,
                                        struct um_diagnosis_state *state, struct um_diagnosis *d);
/* The state without a block, fitted. */
enum um_status um_diagnosis_without(struct um_context *context,
                                    const struct um_diagnosis_work *work,
                                    const struct um_diagnosis_state *state, size_t b,
                                    struct um_diagnosis_state *out);

/* No steps any more. */
void um_diagnosis_steps_clear(struct um_context *context, struct um_diagnosis *d);

/* --- backward.c */
/* Take out effects that are no longer needed; marks their steps. */
enum um_status um_diagnosis_backward(struct um_context *context,
                                     const struct um_diagnosis_work *work,
                                     struct um_diagnosis_state *state, struct um_diagnosis *d);

/* --- next.c */
/* What would tell the winner of a step from its rivals; NULL-what when nothing would. */
enum um_status um_diagnosis_next_find(struct um_context *context,
                                      const struct um_diagnosis_work *work,
                                      const struct um_diagnosis_state *state,
                                      const struct um_diagnosis_step *step,
                                      struct um_diagnosis_next **out);
void um_diagnosis_next_destroy(struct um_context *context, struct um_diagnosis_next **next);

/* --- verdict.c */
/* White noise of the stated sigma. */
bool um_diagnosis_is_noise(const struct um_diagnosis_whiteness *whiteness);
/* Rivals that the data cannot tell from the winner of a step that stayed, priors apart. */
bool um_diagnosis_has_group(const struct um_diagnosis_step *step);
/* Of a diagnosis whose end is kept; state: the nuisances as they were fitted. */
enum um_diagnosis_verdict um_diagnosis_judge(const struct um_diagnosis_state *state,
                                             const struct um_diagnosis *d);

/* --- sentence.c */
enum um_status um_diagnosis_sentence(struct um_context *context, const struct um_diagnosis *d,
                                     char **out);

#endif
