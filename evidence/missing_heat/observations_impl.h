/* From heat to observations. Private to evidence/missing_heat/. */
#ifndef UMBRA_MISSING_HEAT_OBSERVATIONS_IMPL_H
#define UMBRA_MISSING_HEAT_OBSERVATIONS_IMPL_H

#include "evidence/missing_heat/places_impl.h"
#include "evidence/sensitivity/forward.h"

/* A scenario with its additions, run, and the answer of its light to temperatures. */
struct um_missing_heat_base {
  struct um_sensitivity_forward *forward;   /* borrowed */
  const struct um_model_addition *addition; /* [naddition] borrowed */
  size_t naddition;
  struct um_variant variant; /* that scenario */
  struct um_model_result *result;
  size_t *first, *row; /* observations of observation k: observation[first[k]] ..
                          observation[first[k + 1] - 1] */
  /* Regions: surfaces whose light is taken to answer to the mean of their temperatures, weighted by
   * what the observer sees of them; groups and sides, materials where the optics take their means
   */
  size_t nregion;
  uint32_t *region; /* [nsurface] */
  double *slope; /* [nregion][nobservation] d(observation / sigma)/dT [1/K]; 0 for temperatures */
};
/* Errors of the runs. The caller releases what was begun, after an error too. */
enum um_status um_missing_heat_base_create(struct um_context *context,
                                           struct um_sensitivity_forward *forward,
                                           const struct um_model_addition *addition,
                                           size_t naddition, struct um_missing_heat_base *out);
void um_missing_heat_base_release(struct um_context *context, struct um_missing_heat_base *base);

/* Values over sigma of the observations in use of a run on the base's geometry tables. */
enum um_status um_missing_heat_predict(struct um_context *context,
                                       const struct um_missing_heat_base *base,
                                       const struct um_model_result *result, double *out);

/* Change of the observations per watt in each bin of places[nplace], together along one run of
 * heat: column [nplace][nbin][nobservation] [sigma/W]; edge: [nbin + 1] t_tai. */
enum um_status um_missing_heat_columns(struct um_context *context,
                                       const struct um_missing_heat_base *base,
                                       const struct um_missing_heat_place *place, size_t nplace,
                                       size_t nbin, const double *edge, double *column);

#endif
