/* Parts that are filled with tetrahedra, as a body keeps them. */
#include "thermal/network/solids.h"

#include "thermal/network/tetgen.h"

void um_thermal_solids_destroy(struct um_context *context, struct um_thermal_solid **solid,
                               size_t nsolid)
{
  for (size_t i = 0; *solid != NULL && i < nsolid; i++) {
    um_thermal_tetrahedra_destroy(context, &(*solid)[i].mesh);
    um_core_free(context, (*solid)[i].node);
  }
  um_core_free(context, *solid);
  *solid = NULL;
}
