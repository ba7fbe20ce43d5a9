/* What a parameter study gives: the values of every point, and where the points lie. */
#ifndef UMBRA_STUDY_RESULT_H
#define UMBRA_STUDY_RESULT_H

#include <stdbool.h>
#include <stddef.h>

#include "base/core/context.h"

struct um_uncertainty_distribution;
struct um_uncertainty_surrogate;

/* One output over the values of a point. */
struct um_study_quantity {
  char *name;          /* "irradiance:vis", "temperature:bus", "rms:lwir" */
  char *unit;          /* "W/m2", "K", "mag", "1" */
  char *of;            /* band or place */
  size_t first, count; /* of the values of a point; count: ntime of a curve, 1 of a metric */
  bool light;          /* of a band: its error is relative */
  bool withheld; /* the surrogate does not bear it: only solved points have it, NaN at others */
  double asked;  /* error that was asked, as `error` of the result; 0: not known */
  /* Of its standard deviation over the points, summed over the curve, what the surrogate leaves
   * open at most (95 %), by points that had no say; 0: no surrogate */
  double unexplained;
};

/* A surrogate that falls short of the asked error bears a quantity of which it leaves at most this
 * share of the standard deviation unexplained, 1 % of the variance; and any index of an instant
 * only there. */
#define UM_STUDY_BORNE 0.1

/* Of the largest of a curve of light: below that an error is relative to it. */
#define UM_STUDY_FLOOR 0.01

/* A limit that a curve may be above, or of a magnitude brighter than. */
struct um_study_limit {
  size_t quantity; /* of the result */
  double value;    /* in its unit */
};

/* How the points lie to each other; indices are computed from those that are made for them. */
enum um_study_design {
  UM_STUDY_GRID,
  UM_STUDY_LIST,
  UM_STUDY_LATIN_HYPERCUBE,
  UM_STUDY_SOBOL,
  UM_STUDY_ONE_AT_A_TIME,
  UM_STUDY_SALTELLI, /* points of um_uncertainty_saltelli in its order, `base` groups of nparameter
                        + 2 */
  UM_STUDY_MORRIS    /* of um_uncertainty_morris_trajectories, `base` groups of nparameter + 1 */
};

/* Released by um_study_result_destroy; what points are of is owned. */
struct um_study_result {
  char *name, *scenario;
  size_t nparameter, npoint, nvalue, nquantity, ntime;
  char **parameter_name, **parameter_unit; /* [nparameter]; a unit may be "" */
  /* [nparameter], or NULL: not known, and no indices are had from a surrogate; values of its lists
   * are owned */
  struct um_uncertainty_distribution *distribution;
  double *time;       /* [ntime] t_tai, mid-exposure at the observer [s] */
  double *sunlit;     /* [ntime] sunlit fraction, for the shades of pictures; NULL: not known */
  double *coordinate; /* [npoint][nparameter] in the unit cube: the parameter's probability */
  double *parameter;  /* [npoint][nparameter] in the parameter's unit */
  double *value;      /* [npoint][nvalue]; NaN of a point that failed, and where nothing is seen */
  char **reason;      /* [npoint] why a point failed; NULL: it did not */
  double *nominal;    /* [nvalue] of the scenario as it stands */
  double *at_nominal; /* [nparameter] values that the scenario as it stands has; NaN: unknown */
  struct um_study_quantity *quantity; /* [nquantity] */
  enum um_study_design design;
  size_t base; /* rows of a Saltelli matrix, or Morris trajectories; 0 of other designs */
  /* [nquantity] stated error: of light relative to the value, or to UM_STUDY_FLOOR of the curve's
   * largest where that is more, else in the unit; NaN: the surrogate was not asked to get it right
   */
  double *error;
  struct um_study_limit *limit; /* [nlimit] */
  size_t nlimit;
  struct um_uncertainty_surrogate *surrogate; /* NULL in exact mode; owned */
  double *unexplained; /* [values of the surrogate] as of quantities, of each instant; NULL: none */
  size_t exact;        /* points that were solved, surrogate's included */
  size_t nsolved;      /* of npoint those that were solved, each with its own values */
  size_t wanted;       /* points of the design; fewer may be left where no surrogate bears them */
  char *falls_short;   /* why the surrogate does, or there is none that was asked; NULL: it holds */
};

/* The quantity of that name; NULL: none. */
const struct um_study_quantity *um_study_result_quantity(const struct um_study_result *result,
                                                         const char *name);
/* Values of a quantity at a point [quantity->count]. */
const double *um_study_result_values(const struct um_study_result *result, size_t point,
                                     const struct um_study_quantity *quantity);
/* Accepts NULL, sets NULL. */
void um_study_result_destroy(struct um_context *context, struct um_study_result **result);

#endif
