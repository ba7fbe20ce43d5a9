/* What an OBJ file holds, before anybody has said what its groups are made of. */
#ifndef UMBRA_GEOMETRY_OBJ_LOOK_H
#define UMBRA_GEOMETRY_OBJ_LOOK_H

#include "geometry/geometry.h"

/* Groups that share edges are one part: sides of one body. */
struct um_geometry_obj_group {
  char *name;
  char *usemtl, *usemtl_back; /* materials that its first face names; NULL: none */
  size_t part; /* number of the part that it belongs to, from 0, in the order of the file */
  size_t nfacet, nclosed; /* triangles, and those of closed pieces of its part */
};
struct um_geometry_obj_look {
  struct um_geometry_obj_group *group; /* [ngroup] in the order of the file */
  size_t ngroup, npart;
  struct um_vec3 low, high; /* corners of the box about all vertices [units of the file] */
};

/* Read the file as it is drawn, 1 unit being 1 m. Two groups are of one part where an edge has one
 * triangle of each and no third. UM_ERR_IO, UM_ERR_INPUT as building a part of it, UM_ERR_MEMORY.
 * The caller clears. Test: geometry/obj. */
enum um_status um_geometry_obj_look(struct um_context *context, const char *path,
                                    struct um_geometry_obj_look *out);
void um_geometry_obj_look_clear(struct um_context *context, struct um_geometry_obj_look *look);

#endif
