/* The steps of the method. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_STEPS_IMPL_H
#define UMBRA_DIAGNOSIS_STEPS_IMPL_H

#include "base/inference/fit.h"
#include "evidence/diagnosis/diagnosis.h"
#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/state_impl.h"
#include "evidence/missing_heat/unexplained.h"

/* What is asked, and an empty diagnosis of it, the caller's after a failure too, as what work holds
 * is (um_diagnosis_end). */
enum um_status um_diagnosis_begin(struct um_context *context,
                                  struct um_sensitivity_forward *forward,
                                  const struct um_sensitivity_candidates *candidates,
                                  const struct um_diagnosis_options *options,
                                  struct um_diagnosis_work *work, struct um_diagnosis **d);
void um_diagnosis_end(struct um_context *context, struct um_diagnosis_work *work);
/* The scenario as it is, with its nuisances fitted, into an empty state. */
enum um_status um_diagnosis_baseline(struct um_context *context,
                                     const struct um_diagnosis_work *work,
                                     struct um_diagnosis_state *state, struct um_diagnosis *d);
/* The state is what d ends with. */
enum um_status um_diagnosis_keep_end(struct um_context *context,
                                     const struct um_diagnosis_work *work,
                                     const struct um_diagnosis_state *state,
                                     struct um_diagnosis *d);

/* A block of a use with all its parameters free, starting at its values; prior about the
 * scenario's values of width sigma (INFINITY: the effect's own). UM_ERR_INPUT: an effect without
 * parameters that is no core switch. */
enum um_status um_diagnosis_block_wanted(struct um_context *context,
                                         const struct um_diagnosis_work *work,
                                         const struct um_model_addition *wanted, double sigma,
                                         struct um_diagnosis_block *out);
/* UM_ERR_INPUT: one that is free per observation. */
enum um_status um_diagnosis_nuisance_check(struct um_context *context,
                                           const struct um_diagnosis_nuisance_effect *nuisance);
/* The nuisances of the options, into an empty state. UM_ERR_INPUT: one that is free per
 * observation. */
enum um_status um_diagnosis_nuisances(struct um_context *context,
                                      const struct um_diagnosis_work *work,
                                      struct um_diagnosis_state *state);

/* Directions of the candidates, and the memory they point into. */
struct um_diagnosis_directions {
  struct um_inference_direction *direction; /* [count of candidates] */
  double *column;                           /* whitened signatures, one after another */
  double *bound;                            /* [3][columns] lowest, highest step, prior sigma */
  struct um_inference_nuisance nuisance;
  double *nuisance_sigma;  /* [nparameter of the state] */
  double *nuisance_column; /* [nparameter][nobservation] */
};

enum um_status um_diagnosis_directions_make(struct um_context *context,
                                            const struct um_diagnosis_work *work,
                                            const struct um_diagnosis_state *state,
                                            struct um_diagnosis_directions *d);
void um_diagnosis_directions_release(struct um_context *context, struct um_diagnosis_directions *d);
/* The unit of a column of a candidate [transformed]: the step of its difference. So the length of a
 * column is the effect of a step, whatever the unit of the parameter. */
double um_diagnosis_unit(const struct um_sensitivity_candidate *c, size_t k);
/* Residual [n] with the parameters of the state at the means of their priors:
 *   r0 = r + sum_k J_k (x_k - m_k), so that the prior of a nuisance is a pseudo-row of value 0;
 * over the noise of the work. */
void um_diagnosis_residual_at_means(const struct um_diagnosis_work *work,
                                    const struct um_diagnosis_state *state, size_t n, double *out);
/* Two variants of one effect on one target, as the two discs of the Sun. */
bool um_diagnosis_is_same_effect(const struct um_sensitivity_candidate *a,
                                 const struct um_sensitivity_candidate *b);
/* An effect on a target that is fitted already. */
bool um_diagnosis_is_taken(const struct um_diagnosis_state *state,
                           const struct um_sensitivity_candidate *c);

/* Score test of all candidates on the residual of the state. alternative: [count of candidates],
 * filled with the *nalternative that observations change with, the largest predicted reduction
 * first. */
enum um_status um_diagnosis_rank(struct um_context *context, const struct um_diagnosis_work *work,
                                 const struct um_diagnosis_state *state,
                                 struct um_diagnosis_alternative *alternative,
                                 size_t *nalternative);
/* Mark the alternatives that cannot be told from the winner, which is alternative[0]. signal:
 * [nobservation] whitened change of the model values by the winner. */
enum um_status um_diagnosis_rank_groups(struct um_context *context,
                                        const struct um_diagnosis_work *work,
                                        const struct um_diagnosis_state *state,
                                        const double *signal, struct um_diagnosis_step *step);

/* Start values of block b of a state, a candidate that was added to the fitted state `before`, by
 * the linear model: where rates begin to matter. */
enum um_status um_diagnosis_start_along(struct um_context *context,
                                        const struct um_diagnosis_work *work,
                                        const struct um_diagnosis_state *before,
                                        struct um_diagnosis_state *state, size_t b);

/* The amplitude, beyond nothing, that the linear model wants of a candidate beside a fitted state.
 */
double um_diagnosis_linear_amplitude(const struct um_diagnosis_work *work,
                                     const struct um_diagnosis_state *state,
                                     const struct um_sensitivity_candidate *c);

/* always_on.c: values of a candidate with temperatures between which it switches, out of reach of
 * them: it is on all the time. */
void um_diagnosis_always_on(const struct um_sensitivity_candidate *c, double *value);
/* Whether the cycle of block b of a state, a candidate that was added to the fitted state `before`,
 * can be seen. It takes one run of a thermostat; what is none is always seen. */
enum um_status um_diagnosis_cycle_is_seen(struct um_context *context,
                                          const struct um_diagnosis_work *work,
                                          const struct um_diagnosis_state *before,
                                          const struct um_diagnosis_state *state, size_t b,
                                          bool *out);
/* Block b, which is not fitted yet, is on all the time, and its amplitude alone is free. */
void um_diagnosis_hold_on(const struct um_diagnosis_work *work, struct um_diagnosis_state *state,
                          size_t b);
/* Whether a candidate at these values is a thermostat that is out of reach of where it switches. */
bool um_diagnosis_is_held_on(const struct um_sensitivity_candidate *c,
                             const struct um_model_addition *addition);

/* Start values of block b of a state, a candidate with parameters unidentified under the null that
 * was added to the fitted state `before`: the best of a small scan. */
enum um_status um_diagnosis_start(struct um_context *context, const struct um_diagnosis_work *work,
                                  const struct um_diagnosis_state *before,
                                  struct um_diagnosis_state *state, size_t b);

/* Block b of a fitted state, with parameters unidentified under the null, searched for better
 * values beyond the next discontinuity of chi-square; the state, fitted anew, is the better one of
 * both. */
enum um_status um_diagnosis_simplex_refine(struct um_context *context,
                                           const struct um_diagnosis_work *work,
                                           struct um_diagnosis_state *state, size_t b);

/* Chi-square of the observations, white noise of their sigma, with the state at the values in its
 * blocks; INFINITY where the model refuses them. */
enum um_status um_diagnosis_chi2(struct um_context *context, const struct um_diagnosis_work *work,
                                 const struct um_diagnosis_state *state, double *out);

/* The parameter of an effect that is the phase of a cycle; nparameter: none is. */
size_t um_diagnosis_phase_of(const struct um_effect *effect);
/* Whether an addition of a candidate has a phase that was freed. */
bool um_diagnosis_phase_is_free(const struct um_sensitivity_candidate *c,
                                const struct um_model_addition *addition);
/* The phase of block b, which has one, becomes its last free parameter. */
void um_diagnosis_phase_free(struct um_diagnosis_state *state, size_t b);
/* Block b of a fitted state: its phase is freed where that lowers BIC, by UM_DIAGNOSIS_EVIDENCE
 * where the state is below `lead` without, and the state fitted anew. Nothing is done for an effect
 * without a phase, or with one that the scenario states, nor where the state would not come near
 * the BIC `lead`. */
enum um_status um_diagnosis_phase_refine(struct um_context *context,
                                         const struct um_diagnosis_work *work,
                                         struct um_diagnosis_state *state, size_t b, double lead);

/* Whether a candidate with parameters unidentified under the null cannot come within the evidence
 * of the winner's BIC, for what its parameters cost: it is not tied, though nobody fitted it. */
bool um_diagnosis_cannot_tie(const struct um_diagnosis_work *work,
                             const struct um_diagnosis_state *state,
                             const struct um_sensitivity_candidate *c,
                             const struct um_diagnosis_alternative *winner);
/* Whether the winner is an alternative of unknown shape that is on all the time, beside the state,
 * within UM_DIAGNOSIS_SETTLED of chi-square, and has the lower BIC. */
enum um_status um_diagnosis_contains_winner(struct um_context *context,
                                            const struct um_diagnosis_work *work,
                                            const struct um_diagnosis_state *state,
                                            const struct um_diagnosis_alternative *winner,
                                            const struct um_diagnosis_alternative *r, bool *out);

/* Fill a step from the state before it and the best state after it, with the winner's group. */
enum um_status um_diagnosis_step_fill(struct um_context *context,
                                      const struct um_diagnosis_work *work,
                                      const struct um_diagnosis_state *state,
                                      const struct um_diagnosis_state *best,
                                      struct um_diagnosis_step *step);
/* One step of forward selection: rank, fit alternatives, add the winner to the state. *added: false
 * when nothing is significant or nothing helps. */
enum um_status um_diagnosis_select(struct um_context *context, const struct um_diagnosis_work *work,
                                   struct um_diagnosis_state *state, struct um_diagnosis_step *step,
                                   bool *added);

/* Fit the alternatives of a step in their order, until the scores of those left are too low; sort
 * them by BIC. best: the state with the best of those fitted here; unchanged where none was. */
enum um_status um_diagnosis_fit_alternatives(struct um_context *context,
                                             const struct um_diagnosis_work *work,
                                             const struct um_diagnosis_state *state,
                                             struct um_diagnosis_step *step,
                                             struct um_diagnosis_state *best);

struct um_diagnosis_pair {
  size_t candidate[2];
  double worth; /* chi-square that both explain, less ln n per column */
};
/* The best pairs by the linear model, the best first. Two variants of one effect on one target,
 * such as the two discs of the Sun, are no pair. */
enum um_status um_diagnosis_pairs_find(struct um_context *context,
                                       const struct um_diagnosis_work *work,
                                       const struct um_diagnosis_state *state,
                                       struct um_diagnosis_pair best[UM_DIAGNOSIS_PAIRS],
                                       size_t *count);
/* Try pairs instead of the effect that was added last and each one before it. A better pair
 * replaces them in the state. */
enum um_status um_diagnosis_pair_swap(struct um_context *context,
                                      const struct um_diagnosis_work *work,
                                      struct um_diagnosis_state *state);

/* Make the steps anew, each for one effect added last to the others: its alternatives, its group,
 * its p. An effect is replaced where an alternative does better. Steps are sorted by what their
 * effects explain, falling. */
enum um_status um_diagnosis_leave_one_out(struct um_context *context,
                                          const struct um_diagnosis_work *work,
                                          struct um_diagnosis_state *state, struct um_diagnosis *d);
/* Put a candidate first among the alternatives of a step; the others keep their order. false: it is
 * not among them. */
bool um_diagnosis_put_first(struct um_diagnosis_step *step, size_t candidate);

/* Remove effects that are no longer needed, and mark their steps as removed. */
enum um_status um_diagnosis_backward(struct um_context *context,
                                     const struct um_diagnosis_work *work,
                                     struct um_diagnosis_state *state, struct um_diagnosis *d);

/* What is left [nobservation] after as many effects of a search through white noise as it should
 * have added, were the rest work->discrepancy; *whole: all of them. depth.c has how.
 * UM_ERR_MEMORY. */
enum um_status um_diagnosis_depth_find(struct um_context *context,
                                       const struct um_diagnosis_work *work,
                                       const struct um_diagnosis_state *state,
                                       const struct um_diagnosis *d, double *residual, bool *whole);

/* Record every step so far, before they are judged anew. */
enum um_status um_diagnosis_superseded_take(struct um_context *context, struct um_diagnosis *d);
/* Keep on record those that are neither in the final state nor in a step. */
void um_diagnosis_superseded_keep(const struct um_diagnosis_state *state, struct um_diagnosis *d);

/* BIC of a fitted state with the best missing heat added, each number of its shape counted. */
double um_diagnosis_pulse_bic(const struct um_missing_heat_unexplained *heat,
                              const struct um_inference_fit *fit);
/* The same with the best correction of light, and the noise that it leaves. */
double um_diagnosis_light_bic(const struct um_missing_light *light,
                              const struct um_inference_fit *fit);
/* Heat in place of the effects that were added, or of a discrepancy, where it does better; else, of
 * an unexplained residual, heat beside them. bare: the scenario with its nuisances. d: its verdict
 * is judged; where it becomes unexplained state and d end without effects. */
enum um_status um_diagnosis_weigh_heat(struct um_context *context,
                                       const struct um_diagnosis_work *work,
                                       struct um_diagnosis_state *state,
                                       const struct um_diagnosis_state *bare,
                                       struct um_diagnosis *d);
/* The same of light, after heat: also where a discrepancy of light above UM_DIAGNOSIS_LARGE_SIGMAS
 * was called one and light that explains all does better. */
enum um_status um_diagnosis_weigh_light(struct um_context *context,
                                        const struct um_diagnosis_work *work,
                                        struct um_diagnosis_state *state,
                                        const struct um_diagnosis_state *bare,
                                        struct um_diagnosis *d);
/* What a draft is made of, where one is asked for: heat and light of the scenario as it is. */
enum um_status um_diagnosis_look_as_asked(struct um_context *context,
                                          const struct um_diagnosis_work *work,
                                          const struct um_diagnosis_state *bare,
                                          struct um_diagnosis *d);
/* By how much an explanation of that BIC is better than the scenario with its nuisances alone
 * (bare), comparable with the worth of missing light: where no noise was estimated, over the
 * reduced chi-square that is left. */
double um_diagnosis_gain(const struct um_diagnosis *d, const struct um_diagnosis_state *bare,
                         double bic);
/* ". A correction of light explains it: ...", "" where there is none worth a word. */
#define UM_DIAGNOSIS_LIGHT_TEXT (UM_MISSING_LIGHT_TEXT + 80)
void um_diagnosis_light_text(const struct um_diagnosis *d, char out[UM_DIAGNOSIS_LIGHT_TEXT]);
/* ". What is wrong is most likely the air (probability 0.9)", "" where nothing is. */
#define UM_DIAGNOSIS_HALF_TEXT 120
void um_diagnosis_half_text(const struct um_diagnosis *d, char out[UM_DIAGNOSIS_HALF_TEXT]);
/* Which half is wrong; bare: the scenario with its nuisances, fitted. */
void um_diagnosis_halves_assign(const struct um_diagnosis_state *bare, struct um_diagnosis *d);

/* Add them and fit all; candidate i of the work is of wanted[i]. Where values are NAN, no start is
 * said. UM_ERR_INPUT: nothing to fit, too many free parameters. */
enum um_status um_diagnosis_add_wanted(struct um_context *context,
                                       const struct um_diagnosis_work *work,
                                       const struct um_model_addition *wanted, size_t nwanted,
                                       struct um_diagnosis_state *state);

/* d->fitted of the final state, once its effects stand in d. */
enum um_status um_diagnosis_fitted_list(struct um_context *context,
                                        const struct um_diagnosis_state *state,
                                        struct um_diagnosis *d);
/* A value of a fitted parameter as it adds: of a factor its logarithm. */
double um_diagnosis_fitted_additive(const struct um_diagnosis_fitted *fitted, double value);
/* d->tie by mean x [nfitted] and covariance [nfitted][nfitted] of the fitted as they add. */
enum um_status um_diagnosis_ties_find(struct um_context *context, const double *x,
                                      const double *covariance, struct um_diagnosis *d);
/* The same by the curvature of the state's fit. */
enum um_status um_diagnosis_ties_of_fit(struct um_context *context,
                                        const struct um_diagnosis_state *state,
                                        struct um_diagnosis *d);
/* d->posterior, and d->tie where it is sound, by as many draws as the options ask for, once
 * d->fitted is there; nothing where they ask for none. UM_ERR_INPUT: nothing is free, more draws
 * than memory is kept for. UM_ERR_NUMERIC: as um_uncertainty_posterior_create. */
enum um_status um_diagnosis_posterior_draw(struct um_context *context,
                                           const struct um_diagnosis_work *work,
                                           const struct um_diagnosis_state *state,
                                           struct um_diagnosis *d);

/* d->scatter and d->outlier of the final state, once value_before is there; nothing without a
 * noise.
 */
enum um_status um_diagnosis_scatter_describe(struct um_context *context,
                                             const struct um_diagnosis_work *work,
                                             const struct um_diagnosis_state *state,
                                             struct um_diagnosis *d);
/* Whether a discrepancy or a scatter is too large to be called one: something is missing. */
bool um_diagnosis_discrepancy_is_large(const struct um_diagnosis *d);

/* Whether a residual is white noise of the stated sigma. */
bool um_diagnosis_is_noise(const struct um_inference_whiteness *whiteness);
/* Whether a step that was not removed has alternatives that the observations, without priors,
 * cannot tell from its winner. */
bool um_diagnosis_has_group(const struct um_diagnosis_step *step);
/* The verdict, once the final state is kept in d and the sceptic was asked. state: with the fitted
 * nuisances. Sets d->allowance.
 */
enum um_diagnosis_verdict um_diagnosis_judge(const struct um_diagnosis_state *state,
                                             struct um_diagnosis *d);
/* Set the class of confidence of each step, after the verdict. */
void um_diagnosis_confidence_assign(struct um_diagnosis *d);

/* Fill d->sceptic, once the steps are final. */
enum um_status um_diagnosis_sceptic_ask(struct um_context *context,
                                        const struct um_diagnosis_work *work,
                                        const struct um_diagnosis_state *state,
                                        struct um_diagnosis *d);

/* Candidates that the observations can see beside the nuisances, 1 at least. */
size_t um_diagnosis_tested(const struct um_diagnosis *d);
/* Set d->probability and that of each step's alternatives, after the verdict. bare: the scenario
 * with its nuisances. */
void um_diagnosis_probabilities_assign(const struct um_diagnosis_state *bare,
                                       struct um_diagnosis *d);

/* Fill d->missed, after all fits are made and the baseline is ranked. */
enum um_status um_diagnosis_missed_find(struct um_context *context,
                                        const struct um_diagnosis_work *work,
                                        struct um_diagnosis *d);

/* Fill d->next_of: for each alternative of each step with a group, the observation that would tell
 * it from the winner; and d->next, the hardest of them. Small steps count only where there are no
 * others. */
enum um_status um_diagnosis_next_find(struct um_context *context,
                                      const struct um_diagnosis_work *work,
                                      const struct um_diagnosis_state *state,
                                      struct um_diagnosis *d);

enum um_status um_diagnosis_summary_write(struct um_context *context, const struct um_diagnosis *d,
                                          char **out);

#endif
