/* The change of the observations with one parameter of a candidate. Private to
 * evidence/sensitivity/. */
#ifndef UMBRA_SENSITIVITY_DIFFERENCE_IMPL_H
#define UMBRA_SENSITIVITY_DIFFERENCE_IMPL_H

#include "evidence/sensitivity/candidate.h"
#include "evidence/sensitivity/forward_impl.h"

/* The model at which signatures are taken. */
struct um_sensitivity_point {
  struct um_sensitivity_forward *forward;
  const struct um_model_addition *addition; /* [naddition] */
  size_t naddition;
  const double *base; /* [nobservation] values with the additions */
  double noise;     /* largest change of an observation, in its sigma, that a new integration of the
                       same heat makes */
  bool derivatives; /* columns are derivatives, with their errors, not differences for a fit */
};

/* Changes of the observations that one step makes. */
struct um_sensitivity_change {
  double largest, rms; /* [sigma] */
  double length;       /* root of their chi-square */
  bool fresh;          /* heat differs: integrated anew, with its noise .. */
  bool smooth;         /* .. or found by a sensitivity, without */
  double taken;        /* the step that makes them [parameter unit] */
};

/* Change of the observations when the candidate has these values [nparameter]; difference:
 * [nobservation]. move: the single move from the scenario's values to these; NULL: there are
 * several, or it is not known. */
enum um_status um_sensitivity_step_to(struct um_context *context,
                                      const struct um_sensitivity_point *point,
                                      const struct um_sensitivity_candidate *candidate,
                                      const double *values, const struct um_sensitivity_move *move,
                                      double *difference, struct um_sensitivity_change *out);

/* The first step of a parameter [its unit], signed, into the range. */
double um_sensitivity_first_step(const struct um_sensitivity_candidate *candidate, size_t which,
                                 double null);

/* Which derivative is taken: by parameter p, at these values. */
struct um_sensitivity_mover {
  struct um_context *context;
  const struct um_sensitivity_point *point;
  const struct um_sensitivity_candidate *candidate;
  const double *at; /* [nparameter] */
  size_t p;
  double *column; /* [nobservation] the derivative */
};
/* Changes of the observations into the column when the parameter moves by a step. */
enum um_status um_sensitivity_move(const struct um_sensitivity_mover *mover, double step,
                                   struct um_sensitivity_change *change);
/* Does an effect act on observations alone? */
bool um_sensitivity_acts_behind(const struct um_effect *effect);
/* The derivative, by a difference that begins with *step. Out: a step that a fit may take, whose
 * change stands above the noise of an integration, and that change. */
enum um_status um_sensitivity_difference(const struct um_sensitivity_mover *mover, double *step,
                                         struct um_sensitivity_change *change);
/* The same, and where the change is seen the column is a derivative of that quality; without
 * point->derivatives nothing more, and quality stays. (derivative.c) */
enum um_status um_sensitivity_derivative(const struct um_sensitivity_mover *mover, double *step,
                                         struct um_sensitivity_change *change,
                                         struct um_sensitivity_quality *quality);
/* Whether a change is seen above the noise of an integration. */
bool um_sensitivity_alive(const struct um_sensitivity_change *change, double noise);
/* Whether nothing changes at all. */
bool um_sensitivity_is_nothing(const struct um_sensitivity_change *change);

#endif
