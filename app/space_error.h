/* What one refinement in space changes of a run. */
#ifndef UMBRA_APP_SPACE_ERROR_H
#define UMBRA_APP_SPACE_ERROR_H

#include "model/build/build.h"
#include "model/run/result.h"

struct um_app_space_error {
  size_t nsurface;          /* of the refined run */
  const char *place;        /* changed most; of the result */
  double temperature;       /* largest change of a place's mean temperature over the run [K] */
  double temperature_mean;  /* mean over places and times [K] */
  const char *band;         /* the band of longest waves above 2.5 um; NULL: none */
  double light, light_mean; /* largest and mean change of its intensity, of itself [1] */
};
/* Run the variant of `model` with facets and tetrahedra of half the size, and compare with the
 * model's result. What a run fails with. */
enum um_status um_app_space_error(struct um_context *context, const struct um_model *model,
                                  const struct um_model_result *result,
                                  struct um_app_space_error *out);

#endif
