/* Corrections that are tried. Private to evidence/missing_light/. */
#ifndef UMBRA_MISSING_LIGHT_SEARCH_IMPL_H
#define UMBRA_MISSING_LIGHT_SEARCH_IMPL_H

#include "evidence/missing_light/observations_impl.h"

#define UM_MISSING_LIGHT_OWN  SIZE_MAX       /* all bands, each with numbers of its own */
#define UM_MISSING_LIGHT_GREY (SIZE_MAX - 1) /* all bands alike */

struct um_missing_light_attempt {
  enum um_missing_light_kind kind;
  size_t material; /* of the observations; their nmaterial: all light */
  enum um_effect_coordinate coordinate;
  struct um_effect_curve curve;
  size_t band; /* of the observations, or one of the above */
  double chi2; /* explained; 0: nothing was tried */
  size_t nvalue;
  double value[UM_MISSING_LIGHT_NUMBERS], sigma[UM_MISSING_LIGHT_NUMBERS]; /* sigma by scale 1 */
};

struct um_missing_light_search {
  struct um_missing_light_observations *o;
  size_t nslot; /* of unit and coordinate */
  /* [nslot][UM_MISSING_LIGHT_NUMBERS + 3] the best of each count of numbers */
  struct um_missing_light_attempt *best;
  double *column, *left; /* [UM_MISSING_LIGHT_NUMBERS][nobservation] [..][nleft] scratch */
  double *sorted;        /* [nsorted] values of the coordinate that is tried */
  size_t nsorted;
  size_t tried;
};
#define UM_MISSING_LIGHT_COUNTS (UM_MISSING_LIGHT_NUMBERS + 3)

/* Try everything. UM_ERR_CANCELLED. The caller releases what was begun. */
enum um_status um_missing_light_search_create(struct um_context *context,
                                              struct um_missing_light_observations *o,
                                              struct um_missing_light_search *out);
void um_missing_light_search_release(struct um_context *context,
                                     struct um_missing_light_search *search);
/* Numbers that an attempt fits: values, and where and how wide its curve is. */
size_t um_missing_light_numbers(const struct um_missing_light_attempt *a);
/* BIC that it is worth where chi-square counts as divided by scale, less what is unusual about it.
 */
double um_missing_light_worth(const struct um_missing_light_observations *o,
                              const struct um_missing_light_attempt *a, double scale);
/* Least squares of its values; chi2 0 where it rests on too few observations. */
void um_missing_light_fit(struct um_missing_light_search *search,
                          struct um_missing_light_attempt *a);
/* Better places and widths of a bump or an edge, a better length of a fall. */
void um_missing_light_refine(struct um_missing_light_search *search,
                             struct um_missing_light_attempt *a);
/* Range of a coordinate where light was measured; false: it does not vary. */
bool um_missing_light_range(const struct um_missing_light_observations *o,
                            enum um_effect_coordinate coordinate, double *from, double *to);

#endif
