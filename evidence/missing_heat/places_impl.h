/* Where heat may be missing. Private to evidence/missing_heat/. */
#ifndef UMBRA_MISSING_HEAT_PLACES_IMPL_H
#define UMBRA_MISSING_HEAT_PLACES_IMPL_H

#include "model/build/model.h"

/* Where heat may be: nodes with weights of sum 1. */
struct um_missing_heat_place {
  char *name;
  uint32_t *node;
  double *weight;
  size_t nnode;
};
/* The wall of every group ("part.group", "part" where it has one group) and every interior. */
enum um_status um_missing_heat_places_create(struct um_context *context,
                                             const struct um_model *model,
                                             struct um_missing_heat_place **out, size_t *nplace);
void um_missing_heat_places_destroy(struct um_context *context,
                                    struct um_missing_heat_place **place, size_t nplace);

#endif
