/* The satellite with its temperatures as unstructured grids of VTK. */
#ifndef UMBRA_OUTPUT_VTU_H
#define UMBRA_OUTPUT_VTU_H

#include "base/core/file.h"
#include "output/output.h"

/* satellite.pvd, times in seconds from the first observation, and of each observation
 * satellite-0000.vtu: facets as they stand then, joints turned, in body axes [m], with
 * front_temperature_K and back_temperature_K (NaN where a side does not radiate) and part, group,
 * front_material and back_material (-1: none), numbers of names.csv. Where there are solids,
 * solids.pvd and solids-0000.vtu: their tetrahedra with temperature_K at the corners, joints that
 * follow the Sun at angle 0. UM_ERR_IO, UM_ERR_MEMORY. Test: cli_app_formats. */
enum um_status um_output_write_vtu(struct um_context *context, const struct um_output_run *run,
                                   struct um_core_folder *folder);

#endif
