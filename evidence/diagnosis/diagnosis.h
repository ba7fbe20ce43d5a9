/* The result of a diagnosis: the verdict, its steps with their alternatives, the effects that were
 * added, the residual. */
#ifndef UMBRA_DIAGNOSIS_DIAGNOSIS_H
#define UMBRA_DIAGNOSIS_DIAGNOSIS_H

#include "base/inference/score.h"
#include "effects/half.h"
#include "evidence/comparison/segments.h"
#include "evidence/diagnosis/fitted.h"
#include "evidence/diagnosis/policy.h"
#include "evidence/missing_heat/residual.h"
#include "evidence/missing_heat/unexplained.h"
#include "evidence/missing_light/light.h"
#include "evidence/sensitivity/candidates.h"

/* A candidate in a step: always tested, and fitted where its score was among the best. */
struct um_diagnosis_alternative {
  size_t candidate; /* of the candidates */
  struct um_inference_score score;
  bool fitted;
  bool converged; /* false: the fit was pruned, and its BIC might have become less */
  double value[UM_EFFECT_PARAMETERS_MAX],
      sigma[UM_EFFECT_PARAMETERS_MAX]; /* of the effect's parameters */
  double chi2, bic, held_out;          /* with it added; NaN when not fitted */
  double chi2_prior;                   /* of all priors, within bic */
  double probability;     /* among the fitted ones of its step and none of them; 0: not fitted */
  double chi2_difference; /* expected chi-square between the winner and it */
  bool indistinguishable; /* from the winner: fitted, and within the evidence of it */
  bool not_tried;   /* the linear model rates it as good as the winner, but it was not fitted */
  bool refused;     /* not fitted: the model refuses its values */
  bool implausible; /* further than 3 prior widths from its null value */
  bool same_effect; /* the winner's effect on its target, with another value of a switch, or: */
  /* a heater that is on all the time is the winner, and that it switches explains no more */
  bool contains_winner;
  /* It would fit as well as the winner without its prior, or beyond the end of its range. Its BIC
   * is within UM_DIAGNOSIS_NEXT_BEST, but not within the evidence. */
  bool excluded_by_prior, excluded_by_range;
};

/* How well an effect of a step is known. */
enum um_diagnosis_confidence {
  UM_CONFIDENCE_CERTAIN,      /* no other comes within UM_DIAGNOSIS_EVIDENCE of its BIC */
  UM_CONFIDENCE_ONE_OF_GROUP, /* it or one of those that do as well */
  UM_CONFIDENCE_SMALL,        /* one of several, and the step explains too little to decide */
  UM_CONFIDENCE_UNCERTAIN     /* no other comes near, but there is a doubt (doubt.h) */
};
const char *um_diagnosis_confidence_name(enum um_diagnosis_confidence confidence);

struct um_diagnosis_step {
  size_t candidate;
  struct um_model_addition addition; /* as of this step, all effects fitted together */
  double sigma[UM_EFFECT_PARAMETERS_MAX];
  double p_value;   /* corrected */
  double delta_bic; /* below 0: better */
  double held_out_before, held_out;
  double chi2, dof, chi2_reduced;
  double *value; /* [nobservation] model values as of this step, linear unit; NULL: not kept */
  size_t nalternative;
  struct um_diagnosis_alternative *alternative; /* by BIC, then by score; [0] is the winner */
  bool by_prior; /* only the priors tell the winner from its alternatives */
  bool removed;  /* by the backward check */
  enum um_diagnosis_confidence confidence; /* once the verdict is made */
};

/* An effect of an earlier step that others replaced. */
struct um_diagnosis_superseded {
  struct um_model_addition addition; /* as fitted then */
  double sigma[UM_EFFECT_PARAMETERS_MAX];
  double chi2, bic; /* with it and what was there before it */
  bool alone;       /* it was the only effect then */
};

enum um_diagnosis_verdict {
  UM_VERDICT_COMPLETE,
  UM_VERDICT_FOUND,
  UM_VERDICT_NOT_IDENTIFIABLE,
  UM_VERDICT_UNEXPLAINED
};
const char *um_diagnosis_verdict_name(enum um_diagnosis_verdict verdict);

/* A pass to come, and how well it would tell the winner of a step from an alternative: in the band
 * that tells most, by values as far apart in time as those that were measured, against noise alone.
 */
struct um_diagnosis_pass {
  const char *station;           /* name; "": it has none; borrowed from the scenario */
  size_t which;                  /* of the model's stations */
  double rise, culmination, set; /* above observer.minimum_elevation_deg, t_tai [s] */
  double elevation;              /* at culmination, airless [rad] */
  double sun_elevation;          /* of the station's Sun then [rad] */
  const char *of;                /* band; NULL: none shows anything; borrowed from the model */
  double sigmas;                 /* by all values of the pass [1] */
  double from, seconds; /* the shortest stretch of it that is worth 5 sigma: its begin, t_tai [s],
                           and length [s]; NaN: all of it is worth less */
};

/* The observation that would tell the winner of a step from one of its alternatives. */
struct um_diagnosis_next {
  char *what; /* "temperature of body.+y in the umbra"; NULL: nothing that this scenario has */
  enum um_compare_quantity quantity;
  char *of; /* band or place */
  enum um_compare_segment segment;
  double airmass;         /* the observations lie above it; NaN: any does */
  double sigma;           /* of the measurement, assumed of one observation, unit of the quantity */
  double chi2_difference; /* expected chi-square per observation */
  double cadence; /* from one value to the next, as measured, else as the scenario has it [s] */
  double phase_from, phase_to; /* angles Sun, satellite, observer of those observations [rad]; NaN:
                                  of a temperature */
  double from, to;             /* t_tai of the window of the scenario it was computed in */
  size_t step, candidate;      /* the step, and the candidate that is told from its winner */
  const char *told_apart_by; /* in the words of the effects, where nothing of the scenario helps; or
                                NULL; borrowed */
  struct um_diagnosis_pass
      *pass; /* [npass] to come, by rise; none: not asked for, or not looked at */
  size_t npass;
};

/* Values that are worth 5 sigma; NaN: what is not known. */
double um_diagnosis_next_values(const struct um_diagnosis_next *next);

/* A candidate that was not fitted, and why. */
struct um_diagnosis_missed {
  const char *name; /* borrowed from the candidates */
  char why[160];
  bool tested; /* by the linear model, at the values where its search begins */
};

/* How observations of a channel scatter about the model, where that is more than their sigma. */
struct um_diagnosis_scatter {
  size_t channel; /* of the measurements */
  double scale;   /* on sigma, 1 or more */
  const char
      *along; /* the coordinate that a discrepancy is correlated along; NULL: there is none */
  double sigmas, rms, share; /* of the discrepancy, rms: over sigma [1], linear unit of the channel,
                                over the rms of the measurements [1] */
  double of_before;          /* over the residual of the scenario, both over sigma [1] */
};

/* What convinces a sceptic of the effect that explains most. */
struct um_diagnosis_sceptic {
  bool asked;    /* an effect is named */
  size_t step;   /* its step */
  double frozen; /* what it explains in one half with its values from the other, both ways [sigma];
                    NaN: neither half sees it */
  double search_p; /* of noise, that the search among all candidates finds as much */
  size_t variations,
      flips; /* a row, a channel, a prior, the noise changed; those that alter the verdict */
  const char *flips_by; /* what changes it first; NULL: nothing; borrowed */
  bool has_else;        /* were it not in the catalogue, another would be next: */
  size_t else_candidate;
  double else_behind;  /* in BIC */
  double else_reduced; /* chi-square that it leaves, by degree of freedom */
};

/* Of what is missing; they sum to 1. */
struct um_diagnosis_probability {
  double nothing, one, several; /* effects of the catalogue */
  double none;                  /* something that the catalogue has not */
};

struct um_diagnosis {
  enum um_diagnosis_verdict verdict;
  char *summary;                                /* the verdict in words, for a person */
  double level;                                 /* family-wise false-alarm rate that was used */
  struct um_sensitivity_forward *forward;       /* borrowed */
  struct um_sensitivity_candidates *candidates; /* borrowed */
  double chi2, dof, chi2_reduced;               /* of the baseline, nuisances at their values */
  struct um_inference_whiteness baseline_whiteness, final_whiteness;
  size_t nstep;
  struct um_diagnosis_step *step; /* [nstep] */
  size_t naddition;
  struct um_model_addition *addition;                 /* what stayed, final values */
  double (*addition_sigma)[UM_EFFECT_PARAMETERS_MAX]; /* [naddition] */
  size_t nnuisance;
  struct um_model_addition *nuisance; /* as fitted at the end */
  double (*nuisance_sigma)[UM_EFFECT_PARAMETERS_MAX];
  double *value_before, *value_after; /* [nobservation] linear unit */
  double chi2_after, dof_after, chi2_reduced_after;
  struct um_diagnosis_alternative *ranking; /* [nranking] of all candidates on the baseline, by p */
  size_t nranking;
  double bic_after;
  size_t nscatter;
  struct um_diagnosis_scatter *scatter; /* [nscatter] */
  size_t noutlier;
  size_t *outlier; /* [noutlier] rows of the measurements that were set aside */
  struct um_diagnosis_probability probability;
  struct um_diagnosis_sceptic sceptic;
  bool weighed;   /* by a noise that was estimated */
  bool allowance; /* the residual is not quite noise, and was accepted all the same */
  struct um_missing_heat_residual residual; /* of the baseline, what it looks like; not of a fit,
                                               nor where the model is complete */
  bool chosen;                              /* the user said which effects to look for */
  size_t nasked;                            /* candidates, and what was asked for and is none */
  size_t nmissed;
  struct um_diagnosis_missed *missed; /* [nmissed] those that could not be tested, and where the
                                         user said which, those that no fit was worth */
  size_t nsuperseded;
  struct um_diagnosis_superseded *superseded; /* [nsuperseded] */
  size_t nnext;
  struct um_diagnosis_next *next_of; /* [nnext] one per alternative of a step with a group */
  struct um_diagnosis_next *next; /* the one of those hardest to tell; NULL: nothing is ambiguous */
  struct um_missing_heat_unexplained *unexplained; /* NULL: nothing is */
  /* of chosen effects alone: */
  size_t nfitted;
  struct um_diagnosis_fitted *fitted; /* [nfitted] */
  size_t ntie;
  struct um_diagnosis_tie *tie;             /* [ntie] by the draws, where there are some */
  struct um_diagnosis_posterior *posterior; /* NULL: not asked for */
  struct um_missing_light light; /* of the same residual; any false: nothing is, or there is none */
  double half[UM_HALVES]; /* probability that it is what is wrong; they sum to 1; NaN: nothing is */
  /* where a draft was asked for: what explains the scenario with its nuisances alone */
  struct um_missing_heat_unexplained *heat_asked; /* NULL: no heat can be looked for */
  struct um_missing_light light_asked;
};

/* The step that added an effect of these; NULL: it was chosen, not found. */
const struct um_diagnosis_step *um_diagnosis_step_of(const struct um_diagnosis *d,
                                                     const struct um_model_addition *addition);
/* Accepts NULL, sets NULL. */
void um_diagnosis_destroy(struct um_context *context, struct um_diagnosis **diagnosis);

#endif
