/* The heat of one place: every shape fitted, and the choice among them. Private to
 * evidence/missing_heat/. */
#ifndef UMBRA_MISSING_HEAT_FIT_IMPL_H
#define UMBRA_MISSING_HEAT_FIT_IMPL_H

#include "evidence/missing_heat/bins_impl.h"

struct um_missing_heat_fit {
  struct um_thermal_course course; /* with the largest chi-square */
  double chi2, power;              /* that it explains, and at which power [W] */
  double energy;                   /* [J] until the last edge */
  double start_sigma, last_sigma, period_sigma, energy_sigma; /* marginal over all that is fitted */
  double bic;                                                 /* -chi2 / scale + parameters ln n */
};
struct um_missing_heat_choice {
  struct um_missing_heat_fit of[UM_HEAT_SHAPES];
  enum um_thermal_course_shape shape; /* of the least bic */
  double start_sigma, energy_sigma;   /* of that, with what the choice of the shape leaves open */
  double scale;                       /* reduced chi-square that is left, at least 1 */
  size_t tried;                       /* courses of the search */
};

/* The best course of every shape on a grid. Sigmas stay 0. */
void um_missing_heat_search(const struct um_missing_heat_bins *bins,
                            struct um_missing_heat_choice *choice);
/* Sigmas, and better courses between those of the grid; begins where `choice` is, which bins that
 * are finer, or another residual, may have found. The same numbers every time. */
void um_missing_heat_improve(const struct um_missing_heat_bins *bins,
                             struct um_missing_heat_choice *choice);

/* ---- numbers that make a course (fit.c) ---- */

#define UM_MISSING_HEAT_NUMBERS 3
size_t um_missing_heat_numbers(enum um_thermal_course_shape shape);
struct um_thermal_course um_missing_heat_course_of(enum um_thermal_course_shape shape,
                                                   const double *x);
void um_missing_heat_numbers_of(const struct um_thermal_course *course, double *x);
/* Whether the bins can hold such a course. */
bool um_missing_heat_course_allowed(const struct um_missing_heat_bins *bins,
                                    const struct um_thermal_course *course);

#endif
