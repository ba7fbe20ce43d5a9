/* Observations as corrections of light see them. Private to evidence/missing_light/. */
#ifndef UMBRA_MISSING_LIGHT_OBSERVATIONS_IMPL_H
#define UMBRA_MISSING_LIGHT_OBSERVATIONS_IMPL_H

#include "base/inference/projection.h"
#include "evidence/missing_light/light.h"

struct um_missing_light_observations {
  size_t nobservation, nleft;
  struct um_sensitivity_forward_run run;
  struct um_inference_projection projection;
  double *residual; /* [nleft] */
  double square;    /* of the residual */
  size_t nband;
  const char **band; /* [nband] that are measured; borrowed from the model of the forward */
  bool *thermal;     /* [nband] beyond 2.5 um: light that does not ask where the Sun is */
  size_t *of;        /* [nobservation] its band of those; nband: no light */
  size_t nmaterial;
  const char **material; /* [nmaterial] */
  /* [nmaterial + 3][nobservation] what 1 of a curve does to each, over sigma: a factor on the light
   * of a material, on all light; 1 W/sr of the satellite; 1 W/m^2 */
  double *unit;
  double *coordinate; /* [UM_COORDINATES][nobservation]; NaN: none */
};
/* The caller releases what was begun, after an error too. */
enum um_status um_missing_light_observations_create(struct um_context *context,
                                                    struct um_sensitivity_forward *forward,
                                                    const struct um_model_addition *addition,
                                                    size_t naddition, const double *value,
                                                    const double *nuisance, size_t nnuisance,
                                                    struct um_missing_light_observations *out);
void um_missing_light_observations_release(struct um_context *context,
                                           struct um_missing_light_observations *o);
/* The scales of a kind and material: a row of `unit`. */
size_t um_missing_light_unit(const struct um_missing_light_observations *o,
                             enum um_missing_light_kind kind, size_t material);

#endif
