/* How every band's light and every place's temperature, at every instant, move with every parameter
 * of every effect on every target: a matrix of derivatives, once computed, good for every small
 * change. */
#ifndef UMBRA_SENSITIVITY_MATRIX_H
#define UMBRA_SENSITIVITY_MATRIX_H

#include "evidence/sensitivity/candidates.h"

/* A curve: what is observed of one band or place. */
struct um_sensitivity_curve {
  char *name; /* "lwir", "bus.+x"; of other quantities "magnitude_ab:vis"; owned */
  bool temperature;
  const char *unit; /* of its linear value; static */
  double size;      /* largest value of light; of temperatures 100 K */
};

/* A parameter of an effect on a target. */
struct um_sensitivity_row {
  char *name; /* "emittance:mli.factor"; a switch "albedo"; owned */
  const struct um_sensitivity_candidate *candidate; /* of the list */
  size_t parameter;                    /* of the effect's; SIZE_MAX: a switch, turned on */
  const char *unit;                    /* of the parameter; "1" of a switch; borrowed */
  double null_value, minimum, maximum; /* in the scenario, and where it may go */
  double width;                        /* of its prior, or a step as a fit begins with [unit] */
  double log_scale; /* d(parameter)/d ln(what it changes) [unit], of elasticities; NaN: nothing is
                       stated that is one number, or it is 0 */
  struct um_sensitivity_quality quality;
  bool smooth;          /* a derivative says what a small step does */
  const char *why;      /* not smooth, or no column: a few words; NULL: there is nothing to say */
  const double *column; /* [ntime of curve 0, then 1 ..] d(curve)/d(parameter), NaN where a curve is
                           not observed; NULL: none */
};

struct um_sensitivity_matrix {
  struct um_sensitivity_forward *forward; /* borrowed */
  struct um_sensitivity_candidates *list; /* owned */
  size_t ncurve, nlight, ntime;
  size_t *curve_of;                   /* [channels of the measurements] */
  struct um_sensitivity_curve *curve; /* [ncurve] the nlight of light, then temperatures */
  const double *time;                 /* [ntime] t_tai [s]; borrowed from the forward */
  double *value;                      /* [ncurve][ntime] of the scenario as it stands; NaN */
  struct um_sensitivity_row *row;     /* [nrow] in the order of candidates and parameters */
  size_t nrow;
  double *columns;    /* [of rows] */
  double seconds;     /* wall time of the matrix, the scenario's own run not counted [s] */
  double seconds_run; /* of that run [s] */
};

/* Tolerances of heat that derivatives want: a tenth of the scenario's, since differences of runs
 * have their noise, and a periodic state that is found well enough for the slowest nodes [1, K]. */
#define UM_SENSITIVITY_MATRIX_TOLERANCE ((struct um_variant_tolerance){0.1, 1e-4})

/* The matrix of a forward, of which sigmas are set to a thousandth of the curves' sizes
 * (um_sensitivity_own_weigh). own: its observations are the scenario's own. options: which effects
 * and targets; `derivatives` is set. Errors of um_sensitivity_candidates_create. The forward
 * outlives the matrix; the caller destroys. */
enum um_status um_sensitivity_matrix_create(struct um_context *context,
                                            struct um_sensitivity_forward *forward, bool own,
                                            const struct um_sensitivity_candidates_options *options,
                                            struct um_sensitivity_matrix **out);
void um_sensitivity_matrix_destroy(struct um_context *context,
                                   struct um_sensitivity_matrix **matrix);

/* "tangent": a word for how a column was found. */
const char *um_sensitivity_way_name(enum um_sensitivity_way way);
/* Largest change of a curve at instants [from, to) by a step of the row [its unit], of the curve's
 * size [1]; 0 without a column. */
double um_sensitivity_matrix_strength(const struct um_sensitivity_matrix *matrix,
                                      const struct um_sensitivity_row *row, size_t curve,
                                      size_t from, size_t to, double step);

/* Values [ncurve][ntime] by the matrix when rows [n] take values: value + sum of columns times the
 * way from the null value. NaN stays. Does not fail. */
void um_sensitivity_matrix_apply(const struct um_sensitivity_matrix *matrix, const size_t *row,
                                 const double *to, size_t n, double *out);

/* Values of observations [forward's count] as curves [ncurve][ntime], NaN where there is none. */
void um_sensitivity_matrix_spread(const struct um_sensitivity_matrix *matrix, const double *value,
                                  double *out);

#endif
