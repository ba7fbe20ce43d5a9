/* Directions in cells of a cube around the origin. */
#ifndef UMBRA_GEOMETRY_CUBE_H
#define UMBRA_GEOMETRY_CUBE_H

#include <stddef.h>

#include "base/core/vec.h"

#define UM_GEOMETRY_CUBE_CELLS(side) (6 * (size_t)(side) * (size_t)(side))

/* Cell that a direction meets, `side` by `side` of them on each face: the face of the largest
 * component. */
size_t um_geometry_cube_cell(size_t side, struct um_vec3 direction);
/* Unit direction through the point (u, v) of a cell, each in [0, 1]; 0.5 is its middle. */
struct um_vec3 um_geometry_cube_direction(size_t side, size_t cell, double u, double v);

#endif
