/* Growth of a surrogate: points, surpluses, what held-out points say. Private to base/uncertainty/.
 */
#ifndef UMBRA_UNCERTAINTY_SURROGATE_GROWTH_IMPL_H
#define UMBRA_UNCERTAINTY_SURROGATE_GROWTH_IMPL_H

#include "base/uncertainty/surrogate_impl.h"

/* What is known while it grows. */
struct um_uncertainty_growth {
  const struct um_uncertainty_surrogate_request *request;
  struct um_uncertainty_surrogate *s;
  double *largest;           /* [ngroup] |f| at the middle */
  double *held, *held_value; /* [nheld][d] places, [nheld][nvalue] */
  double *left;              /* [nheld][nvalue] of them what the terms so far do not say */
  double *basis;             /* [room] */
  size_t evaluations, evaluations_max, looked_at, searches;
  size_t looks, stated_by; /* times that its error was stated, places of the request used for it */
  double before;           /* share of the asked error at that number of evaluations */
};

/* The middle and nheld held-out points. */
enum um_status um_uncertainty_growth_begin(struct um_context *context,
                                           struct um_uncertainty_growth *g, size_t nheld);
/* State the errors by n more held-out points, which had no say so far. *share: the largest that is
 * stated, of what is asked. */
enum um_status um_uncertainty_growth_state(struct um_context *context,
                                           struct um_uncertainty_growth *g, size_t n,
                                           double *share);
/* n more held-out points at these places [n][d]. */
enum um_status um_uncertainty_growth_hold(struct um_context *context,
                                          struct um_uncertainty_growth *g, const double *place,
                                          size_t n);
/* The error that is asked of a value of that size. */
double um_uncertainty_growth_asked(const struct um_uncertainty_growth *g, size_t group,
                                   double value);
/* Terms of these degrees [n][d], none of which is above another and all of whose lower neighbours
 * are there. */
enum um_status um_uncertainty_growth_add(struct um_context *context,
                                         struct um_uncertainty_growth *g,
                                         const unsigned char *degree, size_t n);
/* Errors at the held-out points, into the surrogate; the largest share of what is asked. */
double um_uncertainty_growth_judge(struct um_uncertainty_growth *g);
/* Degrees of the next terms, list [*n][d], reallocated; none when what was looked beyond admits
 * none. */
enum um_status um_uncertainty_growth_choose(struct um_context *context,
                                            struct um_uncertainty_growth *g, unsigned char **list,
                                            size_t *n);

#endif
