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

/* step_tas.c: is it STEP with tas_arm for its schema? By the header alone. */
bool um_geometry_step_tas_is(const char *bytes, size_t length);
/* Surfaces of the file as OBJ in metres: *obj text of *n bytes, the caller frees. A group is a
 * surface; usemtl is the material of its front, usemtl_back, a word of our own, that of its back.
 * UM_ERR_INPUT with file and line; UM_ERR_MEMORY, UM_ERR_CANCELLED. A warning: surfaces without an
 * active side, which are left out. Source: ESA STEP-TAS 6.0, tas_arm; what attribute is what: as
 * pycanha's reader takes it. */
enum um_status um_geometry_step_tas_read(struct um_context *context, const char *path,
                                         const char *bytes, size_t length, char **obj, size_t *n);

/* A name as a line of OBJ takes it, in place: '_' where foreign characters stand. */
void um_geometry_foreign_name(char *name);

#endif
