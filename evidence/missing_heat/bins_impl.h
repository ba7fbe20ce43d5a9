/* Responses of the observations to heat in bins of time, with the nuisances projected out. Private
 * to evidence/missing_heat/. */
#ifndef UMBRA_MISSING_HEAT_BINS_IMPL_H
#define UMBRA_MISSING_HEAT_BINS_IMPL_H

#include "base/inference/projection.h"
#include "thermal/network/course.h"

struct um_missing_heat_bins {
  size_t nbin, nleft, nobservation;
  double *edge;   /* [nbin + 1] t_tai [s] */
  double *column; /* [nbin][nleft] [sigma/W] */
  double *gram;   /* [nbin][nbin] products of projected columns */
  double *whole;  /* [nbin][nbin] of those before the projection */
  double *with;   /* [nbin] products with the residual */
  double square;  /* of the residual */
  double *weight; /* [nbin] scratch of um_missing_heat_bins_weigh */
};
/* column: [nbin][nobservation], taken as it is; residual: [nleft] projected. */
enum um_status um_missing_heat_bins_create(struct um_context *context,
                                           struct um_inference_projection *projection,
                                           const double *residual, size_t nbin, const double *edge,
                                           const double *column, struct um_missing_heat_bins *out);
void um_missing_heat_bins_release(struct um_context *context, struct um_missing_heat_bins *bins);

/* Take another residual. */
void um_missing_heat_bins_meet(struct um_missing_heat_bins *bins, const double *residual);

/* What a course explains at its best power. */
struct um_missing_heat_weighed {
  double chi2;   /* 0 where the observations cannot see it or the nuisances absorb it */
  double power;  /* [W] */
  double sigma;  /* [W] of the power, the course known */
  double length; /* [s] energy at 1 W until the last edge */
};
/* Heat in a bin is the mean of the course there. Writes bins->weight. */
struct um_missing_heat_weighed um_missing_heat_bins_weigh(const struct um_missing_heat_bins *bins,
                                                          const struct um_thermal_course *course);

/* out[nleft] = what a power of that course does by the linear response. */
void um_missing_heat_bins_respond(const struct um_missing_heat_bins *bins,
                                  const struct um_thermal_course *course, double power,
                                  double *out);

#endif
