/* Light by way of mirrors under an Earth of other levels. */
#include <string.h>

#include "thermal/loads/mirrored.h"

static enum um_status fill(struct um_context *context, const struct um_irradiation_mirrored *from,
                           const struct um_irradiation_levels *by,
                           struct um_irradiation_mirrored *to)
{
  size_t n = from->begin[from->ntime], ncell = from->ntime * UM_GEOMETRY_SKY_CELLS;
  UM_TRY(um_core_allocate(context, from->ntime + 1, sizeof *to->begin, &to->begin));
  if (n > 0) UM_TRY(um_core_allocate(context, n, sizeof *to->sun, &to->sun));
  UM_TRY(um_core_allocate(context, ncell, sizeof *to->albedo, &to->albedo));
  UM_TRY(um_core_allocate(context, ncell, sizeof *to->planet, &to->planet));
  for (uint32_t i = 0; i < from->sets.n; i++) { /* in their order, so that numbers are the same */
    uint32_t number;
    UM_TRY(um_geometry_mirror_sets_find(context, &to->sets, &from->sets.set[i], &number));
  }
  to->ntime = from->ntime;
  memcpy(to->begin, from->begin, (from->ntime + 1) * sizeof *to->begin);
  if (n > 0) memcpy(to->sun, from->sun, n * sizeof *to->sun);
  for (size_t i = 0; i < ncell; i++) {
    to->albedo[i] = (float)((double)from->albedo[i] * by->albedo);
    to->planet[i] = (float)((double)from->planet[i] * by->planet);
  }
  return UM_OK;
}

enum um_status um_irradiation_mirrored_scaled(struct um_context *context,
                                              const struct um_irradiation_mirrored *mirrored,
                                              const struct um_irradiation_levels *by,
                                              struct um_irradiation_mirrored **out)
{
  struct um_irradiation_mirrored *own = NULL;
  *out = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *own, &own));
  enum um_status status = fill(context, mirrored, by, own);
  if (status != UM_OK) um_irradiation_mirrored_destroy(context, &own);
  *out = own;
  return status;
}
