/* Surfaces that mirror when they exchange heat. */
#ifndef UMBRA_MODEL_MIRRORS_H
#define UMBRA_MODEL_MIRRORS_H

#include "geometry/mirrors.h"
#include "model/build/model.h"
#include "thermal/exchange/exchange.h"

/* One class for a side of a group whose record mirrors (um_materials_mirror). *out NULL: there is
 * none, or the effect specular_exchange is off. The caller destroys. */
enum um_status um_model_mirrors_create(struct um_context *context, const struct um_model *model,
                                       struct um_geometry_mirrors **out);

/* *out: have surfaces of both models, of equal geometry, the same classes? */
enum um_status um_model_mirror_classes_are_compatible(struct um_context *context,
                                                      const struct um_model *made,
                                                      const struct um_model *model, bool *out);

/* What classes mirror of what they reflect, by the records that the model has now. */
struct um_model_lobes {
  double *share; /* [2][nclass] */
  struct um_thermal_lobes lobes;
};
/* Cleared by the caller, after a failure too. */
enum um_status um_model_lobes_make(struct um_context *context, const struct um_model *model,
                                   const struct um_geometry_mirrors *mirrors,
                                   struct um_model_lobes *out);
void um_model_lobes_clear(struct um_context *context, struct um_model_lobes *lobes);
/* Do surfaces of both models mirror the same shares, number for number? */
bool um_model_mirrors_equal(const struct um_model *a, const struct um_model *b);
bool um_model_mirrors_equal_in_sunlight(const struct um_model *a, const struct um_model *b);

#endif
