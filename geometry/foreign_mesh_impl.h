/* Meshes of other formats, given where OBJ is expected. Private to geometry/. */
#ifndef UMBRA_GEOMETRY_FOREIGN_MESH_IMPL_H
#define UMBRA_GEOMETRY_FOREIGN_MESH_IMPL_H

#include "base/core/context.h"

/* A mesh in STL, PLY, OFF, glTF or STEP-TAS as Wavefront OBJ: *obj text of *n bytes, the caller
 * frees; NULL: the bytes are none of these. UM_ERR_INPUT: a drawing of another format, named with
 * how it becomes one that is read; what the importer says of a broken file. UM_ERR_LIBRARY: it
 * crashed. */
enum um_status um_geometry_foreign_read(struct um_context *context, const char *path,
                                        const char *bytes, size_t length, char **obj, size_t *n);

/* assimp_mesh.c: the same of bytes whose format is known; hint: its ending, "stl". */
enum um_status um_geometry_assimp_read(struct um_context *context, const char *path,
                                       const char *format, const char *hint, const char *bytes,
                                       size_t length, char **obj, size_t *n);

/* A name as a line of OBJ takes it, in place: '_' where foreign characters stand. */
void um_geometry_foreign_name(char *name);

#endif
