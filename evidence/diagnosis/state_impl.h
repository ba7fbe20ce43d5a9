/* What a diagnosis works with, and where it stands. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_STATE_IMPL_H
#define UMBRA_DIAGNOSIS_STATE_IMPL_H

#include "base/inference/fit.h"
#include "base/inference/noise.h"
#include "base/inference/score.h"
#include "evidence/diagnosis/discrepancy_impl.h"
#include "evidence/diagnosis/options.h"
#include "evidence/sensitivity/forward.h"

/* What became of a candidate. */
enum um_diagnosis_fate { UM_FATE_NOT_FITTED, UM_FATE_FITTED, UM_FATE_REFUSED };

/* What is known of a candidate whose chi-square is rough (um_diagnosis_is_rough). */
struct um_diagnosis_shape {
  double chi2; /* the least of its fits; 0: none yet */
  double value[UM_EFFECT_PARAMETERS_MAX];
  /* An earlier search named it: its score before another noise says little, and it is fitted
   * whatever that is. */
  bool named;
};

/* What is diagnosed, and how; passed around. */
struct um_diagnosis_work {
  struct um_sensitivity_forward *forward;
  const struct um_sensitivity_candidates *candidates;
  const struct um_diagnosis_options *options;
  double level;
  size_t steps_max, alternatives;
  size_t *fold; /* [nobservation] blocks of time that are held out in turn */
  size_t nfold;
  enum um_diagnosis_fate *fate;     /* [count of candidates] */
  struct um_diagnosis_shape *shape; /* [count of candidates] */
  /* NULL: residuals are white noise of the stated sigma. Else what fits are weighted by; each state
   * is judged by the noise that its own residual has the largest likelihood with */
  struct um_inference_noise *noise;
  /* what it points to, and along what it may be correlated: made where it is first estimated */
  struct um_inference_noise estimated;
  struct um_diagnosis_discrepancy discrepancy;
};

/* An effect whose parameters are fitted: a nuisance, an accepted effect or an alternative. */
struct um_diagnosis_block {
  struct um_model_addition addition; /* parameters that are not free stay as they are here */
  size_t candidate;                  /* of the candidates; UM_COMPARE_NOWHERE: a nuisance */
  size_t nfree;                      /* 0 for a switch */
  size_t nheld; /* more numbers that BIC counts, though nothing tells of them (always_on.c) */
  size_t parameter[UM_EFFECT_PARAMETERS_MAX];   /* [nfree] of the effect's */
  double prior_mean[UM_EFFECT_PARAMETERS_MAX];  /* [nfree] transformed, as are the next two */
  double prior_sigma[UM_EFFECT_PARAMETERS_MAX]; /* [nfree] */
  double step[UM_EFFECT_PARAMETERS_MAX];        /* [nfree] */
  double minimum[UM_EFFECT_PARAMETERS_MAX],
      maximum[UM_EFFECT_PARAMETERS_MAX]; /* [nfree] physical */
};

/* Blocks of equal time, of each observation: block [count], below nblock. */
void um_diagnosis_time_blocks(const struct um_sensitivity_observations *observations, size_t nblock,
                              size_t *block);

/* Weigh the fits to come by the noise of a residual [nobservation]. *white: it is noise of the
 * stated sigma, and nothing changes. work->discrepancy is made before. UM_ERR_MEMORY. */
enum um_status um_diagnosis_noise_take(struct um_context *context, struct um_diagnosis_work *work,
                                       const double *residual, bool *white);
/* BIC of a fit with the noise that its own residual has the largest likelihood with. outliers:
 * whose rows are set aside; NULL: they are looked for. */
enum um_status um_diagnosis_noise_bic(struct um_context *context,
                                      const struct um_inference_noise_family *family,
                                      const struct um_inference_noise *outliers,
                                      const struct um_inference_fit *fit, double *out);

/* What is fitted together, and its fit: nuisances first, then effects in the order they came. */
struct um_diagnosis_state {
  size_t nblock, nnuisance; /* blocks of which the first are nuisances */
  struct um_diagnosis_block *block;
  size_t nparameter;
  struct um_inference_fit *fit;
};

/* Has a candidate parameters unidentified under the null that chi-square does not follow smoothly,
 * so that it takes a scan of runs and a simplex? Of rates that were looked for (scan_rates.c) it
 * has not. */
bool um_diagnosis_is_rough(const struct um_sensitivity_candidate *candidate);
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
 * [nobservation] and jacobian [nparameter][nobservation] (by transformed parameters) at the start,
 * or NULL. Replaces state->fit. prune_above: BIC that the fit has to come below to be of use;
 * INFINITY: any is. */
enum um_status um_diagnosis_state_fit(struct um_context *context,
                                      const struct um_diagnosis_work *work,
                                      struct um_diagnosis_state *state, const double *value,
                                      const double *jacobian, double prune_above);
/* Start, range, prior and step of all that is free; out: [nparameter]. */
void um_diagnosis_state_parameters(const struct um_diagnosis_state *state,
                                   struct um_inference_fit_parameter *out);
/* Additions of all blocks; out: [nblock]. */
void um_diagnosis_state_additions(const struct um_diagnosis_state *state,
                                  struct um_model_addition *out);
/* Sigma of the parameters of a block after the fit, by the effect's parameters; NaN for those that
 * were not free. */
void um_diagnosis_state_sigma(const struct um_diagnosis_state *state, size_t block, double *sigma);
/* Chi-square of held-out observations. */
enum um_status um_diagnosis_state_held_out(struct um_context *context,
                                           const struct um_diagnosis_work *work,
                                           const struct um_diagnosis_state *state, double *out);

/* Parameters that have no prior. */
double um_diagnosis_free_parameters(const struct um_diagnosis_state *state);
/* UM_ERR_INPUT: as many of them as observations. */
enum um_status um_diagnosis_check_free(struct um_context *context,
                                       const struct um_diagnosis_work *work, double nfree);
/* Whether the residual of the fit is white noise. */
enum um_status um_diagnosis_state_whiteness(struct um_context *context,
                                            const struct um_diagnosis_work *work,
                                            const struct um_diagnosis_state *state,
                                            struct um_inference_whiteness *out);
/* The state without a block, fitted. */
enum um_status um_diagnosis_without(struct um_context *context,
                                    const struct um_diagnosis_work *work,
                                    const struct um_diagnosis_state *state, size_t b,
                                    struct um_diagnosis_state *out);

/* The model as a fit asks for it (evaluation.c). */
struct um_diagnosis_evaluation {
  const struct um_diagnosis_work *work;
  const struct um_diagnosis_state *state;
  struct um_model_addition *addition; /* [nblock] room for one evaluation */
};

/* Additions [nblock] of a state at x [nparameter], by transformed parameters. */
void um_diagnosis_additions_at(const struct um_diagnosis_state *state, const double *x,
                               struct um_model_addition *addition);
/* As a um_inference_fit_problem wants them; user: a um_diagnosis_evaluation. Several are computed
 * by as many processes as the context has threads. */
enum um_status um_diagnosis_evaluate(struct um_context *context, void *user, const double *x,
                                     double *value);
enum um_status um_diagnosis_evaluate_all(struct um_context *context, void *user, size_t n,
                                         const double *x, double *value);

#endif
