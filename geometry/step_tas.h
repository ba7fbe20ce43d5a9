/* What a STEP-TAS file says beside geometry. */
#ifndef UMBRA_GEOMETRY_STEP_TAS_H
#define UMBRA_GEOMETRY_STEP_TAS_H

#include "base/core/context.h"

/* Optical properties of a surface material: shares [1] of what arrives, and of what is reflected
 * the share that is specular. */
struct um_geometry_step_tas_optical {
  char name[256]; /* as the groups of a look name it */
  double solar_absorptance, solar_transmittance, solar_specularity;
  double emittance, infrared_transmittance, infrared_specularity;
};

/* Those of a file's first environment: out[*n], the caller frees; none, and *is false, of a file
 * that is no STEP-TAS. Materials with no optical value are left out. UM_ERR_IO, UM_ERR_MEMORY;
 * UM_ERR_INPUT with file and line. Source: ESA STEP-TAS 6.0, tas_arm, as pycanha's reader takes it.
 */
enum um_status um_geometry_step_tas_materials(struct um_context *context, const char *path,
                                              struct um_geometry_step_tas_optical **out, size_t *n,
                                              bool *is);

#endif
