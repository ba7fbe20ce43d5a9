/* What the run begins with beside the periodic or isothermal state: interiors that are warmer or
 * colder, by effects. */
#include <stdio.h>
#include <string.h>

#include "model/build/start_offset_group.h"

enum um_status um_model_build_start_offset(struct um_context *context, struct um_model *model,
                                           const struct um_thermal_part_spec *parts, size_t npart)
{
  struct um_thermal_network *network = model->body->network;
  for (size_t i = 0; i < npart; i++) {
    const char *part = um_geometry_part_name(model->geometry, parts[i].part);
    for (size_t k = 0; k < parts[i].ninterior; k++) {
      char name[512];
      const struct um_thermal_interior_spec *interior = &parts[i].interior[k];
      if (interior->offset == 0.0) continue;
      if (model->start_offset == NULL)
        UM_TRY(um_core_allocate(context, um_thermal_network_nodes(network), sizeof(double),
                                &model->start_offset));
      snprintf(name, sizeof name, "%s.%s", part, interior->name);
      const struct um_thermal_place *place =
          &model->body->place[um_thermal_body_place_find(model->body, name)];
      for (size_t j = 0; j < place->nnode; j++)
        model->start_offset[place->node[j]] = interior->offset;
    }
  }
  return UM_OK;
}

enum um_status um_model_start_offset_add(struct um_context *context, const struct um_model *model,
                                         double *temperature)
{
  const struct um_thermal_network *network = model->body->network;
  for (size_t i = 0; model->start_offset != NULL && i < um_thermal_network_nodes(network); i++) {
    temperature[i] += model->start_offset[i];
    if (!(temperature[i] > 0.0))
      return um_core_fail(
          context, UM_ERR_INPUT, "node '%s' begins at %g K, %g K off; accepted: above 0 K",
          um_thermal_network_name(network, (uint32_t)i), temperature[i], model->start_offset[i]);
  }
  return UM_OK;
}

bool um_model_start_offset_equal(const struct um_model *a, const struct um_model *b)
{
  size_t n = um_thermal_network_nodes(a->body->network);
  for (size_t i = 0; (a->start_offset != NULL || b->start_offset != NULL) && i < n; i++)
    if ((a->start_offset != NULL ? a->start_offset[i] : 0.0) !=
        (b->start_offset != NULL ? b->start_offset[i] : 0.0))
      return false;
  return true;
}
