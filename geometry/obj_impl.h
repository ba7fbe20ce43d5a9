/* Meshes of files. Private to geometry/. */
#ifndef UMBRA_GEOMETRY_OBJ_IMPL_H
#define UMBRA_GEOMETRY_OBJ_IMPL_H

#include "geometry/patch_impl.h"

/* Reads an OBJ file; positions are multiplied by `scale`. */
enum um_status um_geometry_obj_read(struct um_geometry_patch *patch, const char *path,
                                    double scale);

#endif
