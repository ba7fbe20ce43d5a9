/* A body as it is kept: its network and its places. */
#include "thermal/network/body.h"

#include <string.h>

void um_thermal_body_destroy(struct um_context *context, struct um_thermal_body **body)
{
  if (body == NULL || *body == NULL) return;
  for (size_t p = 0; p < (*body)->nplace; p++) {
    UM_FREE(context, (*body)->place[p].name, (*body)->place[p].node, (*body)->place[p].weight);
  }
  um_core_free(context, (*body)->place);
  um_thermal_solids_destroy(context, &(*body)->solid, (*body)->nsolid);
  um_thermal_network_destroy(&(*body)->network);
  um_core_free(context, *body);
  *body = NULL;
}

size_t um_thermal_body_place_find(const struct um_thermal_body *body, const char *name)
{
  for (size_t p = 0; p < body->nplace; p++)
    if (strcmp(body->place[p].name, name) == 0) return p;
  return (size_t)-1;
}
