/* How a parameter's values are spread: from a coordinate in the unit cube to a value and back. All
 * have finite ends, so that the ends of the cube are values too. */
#ifndef UMBRA_UNCERTAINTY_DISTRIBUTION_H
#define UMBRA_UNCERTAINTY_DISTRIBUTION_H

#include "base/core/context.h"

enum um_uncertainty_kind {
  UM_UNCERTAINTY_UNIFORM, /* from .. to */
  UM_UNCERTAINTY_NORMAL,  /* mean, sigma; cut at from and to where these are finite, otherwise at
                           * UM_UNCERTAINTY_CUT sigma */
  UM_UNCERTAINTY_LOG_UNIFORM, /* the logarithm is uniform; 0 < from */
  UM_UNCERTAINTY_LOG_NORMAL, /* the natural logarithm is normal with mean ln(median) and sigma; from
                              * and to cut the value */
  UM_UNCERTAINTY_TRIANGULAR, /* from .. to, likeliest at `mode` */
  UM_UNCERTAINTY_LIST        /* nvalue values, all as likely, in the order of the list */
};
#define UM_UNCERTAINTY_CUT 4.0 /* [sigma] at either side: 6e-5 of a normal distribution */

struct um_uncertainty_distribution {
  enum um_uncertainty_kind kind;
  double from, to;     /* -INFINITY, INFINITY: not cut (normal, log-normal) */
  double mean, sigma;  /* normal; sigma also of log-normal, of the logarithm */
  double median, mode; /* of log-normal; of triangular */
  const double *value; /* [nvalue] of a list; borrowed */
  size_t nvalue;
};

/* Whether it has a width and its numbers belong together. UM_ERR_INPUT with a message that begins
 * with `name`, the user's word for the parameter. The functions below want one that passed. */
enum um_status
um_uncertainty_distribution_check(struct um_context *context, const char *name,
                                  const struct um_uncertainty_distribution *distribution);

/* Its ends: least and largest value. */
void um_uncertainty_distribution_ends(const struct um_uncertainty_distribution *distribution,
                                      double *least, double *largest);
/* Quantile function by GSL: the value below which a share u in [0, 1] lies; outside it is held at
 * the ends. Of a list value i for u in [i, i + 1) / nvalue. Relative error 1e-12. */
double um_uncertainty_distribution_value(const struct um_uncertainty_distribution *distribution,
                                         double u);

/* Place of a value between its ends on a scale on which a smooth model stays smooth: linear, or in
 * the logarithm for the two logarithmic ones; 0 at the least, 1 at the largest value. This, not u,
 * is the axis of a surrogate: by u a normal distribution's ends would be infinitely steep. */
double um_uncertainty_distribution_place(const struct um_uncertainty_distribution *distribution,
                                         double value);
/* And back, the ends exactly. */
double um_uncertainty_distribution_at_place(const struct um_uncertainty_distribution *distribution,
                                            double place);

#endif
