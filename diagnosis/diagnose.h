/* From a scenario and measurements to the effect that is missing: signatures, score test, fit of
 * rivals, forward selection, backward check, what cannot be told apart, what to measure next. */
#ifndef UMBRA_DIAGNOSIS_DIAGNOSE_H
#define UMBRA_DIAGNOSIS_DIAGNOSE_H

#include "compare/compare.h"
#include "diagnosis/candidates.h"
#include "diagnosis/score.h"
#include "diagnosis/unexplained.h"

/* Something that is uncertain anyway: its direction is projected out and it is fitted along. */
struct um_diagnosis_nuisance_effect {
  const struct um_effect *effect;
  const char *target;
  double sigma;    /* prior width of its parameters about the scenario's values; INFINITY: free */
  const char *per; /* NULL or "set"; "observation" is refused: it fits anything */
};

struct um_diagnosis_options {
  struct um_diagnosis_candidates_options candidates;
  const struct um_diagnosis_nuisance_effect *nuisance; /* [nnuisance] */
  size_t nnuisance;
  double level;     /* family-wise false-alarm rate; 0: 0.01 */
  size_t steps_max; /* effects added at most; 0: 4 */
  size_t rivals;    /* candidates fitted at each step at most; 0: 8 */
  bool no_next;     /* do not look for the next measurement */
  bool no_heat;     /* do not reconstruct heat */
};

/* A candidate that was tested, and fitted where its score was among the best. */
struct um_diagnosis_rival {
  size_t candidate; /* of the candidates */
  struct um_diagnosis_score score;
  bool fitted;
  double value[UM_EFFECT_PARAMETERS_MAX],
      sigma[UM_EFFECT_PARAMETERS_MAX]; /* of the effect's parameters */
  double chi2, bic, held_out;          /* with it added; NaN when not fitted */
  double separation;                   /* expected chi-square between the winner and it */
  bool indistinguishable;              /* from the winner, by evidence or by separation */
  bool incredible;                     /* further than 3 prior widths from its null value */
};

struct um_diagnosis_step {
  size_t candidate;
  struct um_diagnosis_addition addition; /* as of this step, all effects fitted together */
  double sigma[UM_EFFECT_PARAMETERS_MAX];
  double p_value;   /* corrected */
  double delta_bic; /* below 0: better */
  double held_out_before, held_out;
  double chi2, dof, chi2_reduced;
  double *value; /* [nrow] model values as of this step, linear unit; NULL: not kept */
  size_t nrival;
  struct um_diagnosis_rival *rival; /* by BIC, then by score; [0] is the winner */
  bool by_prior;                    /* only the priors tell the winner from its rivals */
  bool removed;                     /* by the backward check */
};

enum um_diagnosis_verdict {
  UM_VERDICT_COMPLETE,
  UM_VERDICT_FOUND,
  UM_VERDICT_NOT_IDENTIFIABLE,
  UM_VERDICT_UNEXPLAINED
};
const char *um_diagnosis_verdict_name(enum um_diagnosis_verdict verdict);

/* What would tell the winner of the last ambiguous step from its rivals. */
struct um_diagnosis_next {
  char *what; /* "temperature of body.+y in the umbra"; NULL: nothing that this scenario has */
  enum um_compare_quantity quantity;
  char *of; /* band or place */
  enum um_compare_segment segment;
  double sigma;      /* assumed of one row, unit of the quantity */
  double separation; /* expected chi-square per row, against the nearest rival */
  double from, to;   /* t_tai of the window of the scenario it was computed in */
};

struct um_diagnosis {
  enum um_diagnosis_verdict verdict;
  char *sentence;                             /* the verdict in words, for a person */
  double level;                               /* family-wise false-alarm rate that was used */
  struct um_diagnosis_forward *forward;       /* borrowed */
  struct um_diagnosis_candidates *candidates; /* borrowed */
  double chi2, dof, chi2_reduced;             /* of the baseline, nuisances at their values */
  struct um_diagnosis_whiteness baseline_whiteness, final_whiteness;
  size_t nstep;
  struct um_diagnosis_step *step; /* [nstep] */
  size_t naddition;
  struct um_diagnosis_addition *addition;             /* what stayed, final values */
  double (*addition_sigma)[UM_EFFECT_PARAMETERS_MAX]; /* [naddition] */
  size_t nnuisance;
  struct um_diagnosis_addition *nuisance; /* as fitted at the end */
  double (*nuisance_sigma)[UM_EFFECT_PARAMETERS_MAX];
  double *value_before, *value_after; /* [nrow] linear unit */
  double chi2_after, dof_after, chi2_reduced_after;
  struct um_diagnosis_rival *ranking; /* [nranking] of all candidates on the baseline, by p */
  size_t nranking;
  struct um_diagnosis_next *next;               /* NULL: nothing is ambiguous */
  struct um_diagnosis_unexplained *unexplained; /* NULL: nothing is */
};

/* candidates: made once by um_diagnosis_candidates_create without additions, may serve many sets
 * of the same times. UM_ERR_INPUT: fewer rows than free parameters, a nuisance per observation.
 * Progress is reported. The caller destroys. */
enum um_status um_diagnosis_create(struct um_context *context, struct um_diagnosis_forward *forward,
                                   struct um_diagnosis_candidates *candidates,
                                   const struct um_diagnosis_options *options,
                                   struct um_diagnosis **out);
void um_diagnosis_destroy(struct um_context *context, struct um_diagnosis **diagnosis);

/* Only the fit of chosen effects (umbra fit): one step without tests. value of each: start. */
enum um_status um_diagnosis_fit_effects(struct um_context *context,
                                        struct um_diagnosis_forward *forward,
                                        const struct um_diagnosis_addition *wanted, size_t nwanted,
                                        const struct um_diagnosis_options *options,
                                        struct um_diagnosis **out);

/* diagnosis.json, ranking.csv, fit.csv (rows: time_utc, quantity, of, measured, sigma, before,
 * after), improved/scenario.yaml (runs in place: the user's scenario with its paths made to fit and
 * the effects added), heat.csv where heat was reconstructed, into a folder in the making. */
enum um_status um_diagnosis_write(struct um_context *context, const struct um_diagnosis *diagnosis,
                                  const char *command, const char *version,
                                  struct um_core_folder *folder);
/* diagnosis.json to a stream; the caller looks for its errors. UM_ERR_MEMORY. */
enum um_status um_diagnosis_write_json(struct um_context *context,
                                       const struct um_diagnosis *diagnosis, const char *command,
                                       const char *version, FILE *file);
/* Pictures by gnuplot: per channel data with model before and after and residuals of both below;
 * the ranking; heat where reconstructed. */
enum um_status um_diagnosis_plot(struct um_context *context, const struct um_diagnosis *diagnosis,
                                 const char *folder);

#endif
