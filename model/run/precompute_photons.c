/* Sunlight from mirror to mirror, once for many runs. */
#include "model/geometry/precompute.h"
#include "model/run/run_optics_group.h"
#include "optics/paths/photon_maps.h"

enum um_status um_model_precompute_photons(struct um_context *context, const struct um_model *model,
                                           struct um_model_tables *tables)
{
  struct um_optics_scene scene = {0};
  um_optics_photon_maps_destroy(context, &tables->photons);
  if (tables->view == NULL) return UM_OK;
  UM_TRY(um_model_scene_make(context, model, tables, NULL, &scene));
  enum um_status status =
      um_optics_photon_maps_create(context, &scene, model->band, model->nband, &tables->photons);
  um_model_scene_release(context, &scene);
  return status;
}
