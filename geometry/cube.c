/* See cube.h. */
#include "geometry/cube.h"

#include <math.h>

size_t um_geometry_cube_cell(size_t side, struct um_vec3 direction)
{
  double c[3] = {direction.x, direction.y, direction.z};
  int axis = fabs(c[0]) >= fabs(c[1]) ? 0 : 1;
  if (fabs(c[2]) > fabs(c[axis])) axis = 2;
  double half = 0.5 * (double)side, scale = half / fabs(c[axis]);
  size_t u = (size_t)(c[(axis + 1) % 3] * scale + half);
  size_t v = (size_t)(c[(axis + 2) % 3] * scale + half);
  if (u >= side) u = side - 1;
  if (v >= side) v = side - 1;
  size_t face = 2 * (size_t)axis + (c[axis] < 0.0);
  return (face * side + v) * side + u;
}

struct um_vec3 um_geometry_cube_direction(size_t side, size_t cell, double u, double v)
{
  size_t column = cell % side, row = cell / side % side;
  size_t face = cell / (side * side), axis = face / 2;
  double c[3];
  c[axis] = face % 2 != 0 ? -1.0 : 1.0;
  c[(axis + 1) % 3] = 2.0 * ((double)column + u) / (double)side - 1.0;
  c[(axis + 2) % 3] = 2.0 * ((double)row + v) / (double)side - 1.0;
  return um_vec3_unit(um_vec3(c[0], c[1], c[2]));
}
