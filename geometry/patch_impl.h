/* Patches of a part in the making, and who makes them. Private to geometry/. */
#ifndef UMBRA_GEOMETRY_PATCH_IMPL_H
#define UMBRA_GEOMETRY_PATCH_IMPL_H

#include "geometry/geometry.h"

/* More facets than this in one part are refused: a facet size typed in the wrong unit. */
#define UM_GEOMETRY_MAX_FACETS ((size_t)4000000)

/* More groups than this in one mesh are refused: each is a place with temperatures of its own. */
#define UM_GEOMETRY_MAX_GROUPS 2000

/* Sizes and coordinates above this are refused, before squares of squares overflow [m]. */
#define UM_GEOMETRY_MAX_LENGTH 1e7 /* [m] */

/* Points closer than this times the diagonal of the part are one vertex [1]. */
#define UM_GEOMETRY_WELD 1e-9

/* A facet is degenerate when twice its area is below this times its longest edge squared [1]. */
#define UM_GEOMETRY_DEGENERATE 1e-10

/* Growing mesh in part frame. `source` is what messages call it (file path or part name). */
struct um_geometry_patch {
  struct um_context *context;
  const char *source;
  struct um_vec3 *vertex; /* [nvertex] [m] */
  size_t nvertex, vertex_capacity;
  uint32_t (*corner)[3]; /* [nfacet] */
  uint32_t *group;       /* [nfacet] index into group_name */
  int *line;             /* [nfacet] line of the file; 0 for primitives */
  uint32_t *root;        /* [nfacet] the facet that it is a piece of, while facets are cut */
  size_t nfacet, facet_capacity;
  char **group_name; /* [ngroup] */
  size_t ngroup, group_capacity;
  uint32_t *group_slot; /* [group_slots] hash table of indices, UM_GEOMETRY_NONE where free */
  size_t group_slots;   /* power of 2, at least twice ngroup */
};

void um_geometry_patch_begin(struct um_geometry_patch *patch, struct um_context *context,
                             const char *source);
void um_geometry_patch_end(struct um_geometry_patch *patch);
enum um_status um_geometry_patch_vertex(struct um_geometry_patch *patch, struct um_vec3 v,
                                        uint32_t *index);
enum um_status um_geometry_patch_facet(struct um_geometry_patch *patch, uint32_t a, uint32_t b,
                                       uint32_t c, uint32_t group, int line);
/* Index of the group of that name, added when new. */
enum um_status um_geometry_patch_group(struct um_geometry_patch *patch, const char *name,
                                       uint32_t *group);
/* Index of the group of that name, or UM_GEOMETRY_NONE. */
uint32_t um_geometry_patch_group_find(const struct um_geometry_patch *patch, const char *name);
/* Merge coincident vertices, drop unused ones and groups without facets. */
enum um_status um_geometry_patch_weld(struct um_geometry_patch *patch);
/* UM_ERR_INPUT naming the first degenerate facet and its line. */
enum um_status um_geometry_patch_check(const struct um_geometry_patch *patch);

/* Box, plate, sphere; hands the round ones on. Sizes have been checked. */
enum um_status um_geometry_primitive_build(const struct um_geometry_part_spec *spec,
                                           struct um_geometry_patch *patch);

/* Disc, cylinder, cone, paraboloid. */
enum um_status um_geometry_round_build(const struct um_geometry_part_spec *spec,
                                       struct um_geometry_patch *patch);

/* What is wanted of an OBJ file. */
struct um_geometry_obj_wish {
  double scale;              /* metres per unit of the file [m] */
  const char *const *groups; /* [ngroup] these groups alone; all where ngroup is 0 */
  size_t ngroup;
  /* NULL, or takes [patch->ngroup] the materials that the first face of each group names; grows
   * with the groups, so that it is to be freed after a failure, too */
  struct um_geometry_obj_material **material;
};
/* NULL where none is named; a back only by formats that have one. */
struct um_geometry_obj_material {
  char *front, *back;
};
/* Reads an OBJ file, or a mesh of another format by way of OBJ (geometry/foreign_mesh.c).
 * UM_ERR_INPUT with file and line; a wished group without faces. */
enum um_status um_geometry_obj_read(struct um_geometry_patch *patch, const char *path,
                                    const struct um_geometry_obj_wish *wish);

/* Bisect longest edges until none is longer than facet_size [m]; conforming. */
enum um_status um_geometry_refine(struct um_geometry_patch *patch, const char *part,
                                  double facet_size);
/* Bisect until no piece of a halved facet has an edge longer than half the facet's longest;
 * conforming, so that facets beside it may be cut, too. UM_ERR_INPUT: the patch has another number
 * of facets, or a facet is none of them. */
enum um_status um_geometry_halve(struct um_geometry_patch *patch, const char *part,
                                 const struct um_geometry_halving *halving);

#endif
