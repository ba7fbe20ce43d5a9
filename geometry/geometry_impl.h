/* Private to geometry/: the mesh of one part while it is being made, and its edges. */
#ifndef UMBRA_GEOMETRY_GEOMETRY_IMPL_H
#define UMBRA_GEOMETRY_GEOMETRY_IMPL_H

#include "geometry/geometry.h"

/* More facets than this in one part are refused: a facet size typed in the wrong unit. */
#define UM_GEOMETRY_MAX_FACETS ((size_t)4000000)

/* More groups than this in one mesh are refused: each is a place with temperatures of its own. */
#define UM_GEOMETRY_MAX_GROUPS 2000

/* Sizes and coordinates above this are refused, before squares of squares overflow [m]. */
#define UM_GEOMETRY_MAX_LENGTH 1e7

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

/* One undirected edge, a < b. */
struct um_geometry_edge {
  uint32_t a, b;
  uint32_t uses;    /* facets at this edge */
  uint32_t forward; /* of them, those that run from a to b */
};
struct um_geometry_edges {
  struct um_geometry_edge *edge; /* [nedge], in order of first use */
  size_t nedge;
  uint32_t (*of_facet)[3]; /* [nfacet]: edge from corner k to corner k + 1 */
};
enum um_status um_geometry_edges_create(struct um_context *context, const uint32_t (*corner)[3],
                                        size_t nfacet, struct um_geometry_edges *edges);
void um_geometry_edges_destroy(struct um_context *context, struct um_geometry_edges *edges);
/* closed[nfacet] = 1 where the connected piece that the facet belongs to is watertight and
 * consistently oriented. */
enum um_status um_geometry_edges_closed(struct um_context *context, const uint32_t (*corner)[3],
                                        size_t nfacet, size_t nvertex,
                                        const struct um_geometry_edges *edges, uint8_t *closed);

/* Box, plate, sphere; hands the round ones on. Sizes have been checked. */
enum um_status um_geometry_primitive_build(const struct um_geometry_part_spec *spec,
                                           struct um_geometry_patch *patch);
/* Disc, cylinder, cone, paraboloid. */
enum um_status um_geometry_round_build(const struct um_geometry_part_spec *spec,
                                       struct um_geometry_patch *patch);

/* Reads an OBJ file; positions are multiplied by `scale`. */
enum um_status um_geometry_obj_read(struct um_geometry_patch *patch, const char *path,
                                    double scale);
/* n - 2 triangles of a simple polygon, as indices into p; false when it crosses itself or has no
 * area. work is [n]. */
bool um_geometry_polygon_triangulate(const struct um_vec3 *p, size_t n, uint32_t *work,
                                     uint32_t (*triangle)[3]);

/* Bisect longest edges until none is longer than facet_size [m]; conforming. */
enum um_status um_geometry_refine(struct um_geometry_patch *patch, const char *part,
                                  double facet_size);

struct um_geometry_report um_geometry_report_compute(const struct um_geometry_patch *patch,
                                                     const struct um_geometry_edges *edges);

/* A part as it is kept. */
struct um_geometry_part {
  char *name;
  size_t parent; /* (size_t)-1: the body */
  struct um_vec3 position;
  struct um_quat rotation;
  enum um_geometry_joint_kind joint_kind;
  struct um_vec3 joint_axis, joint_normal;
  double joint_angle;
  size_t joint; /* index of its joint, or (size_t)-1 */
  size_t vertex_begin, vertex_end, facet_begin, facet_end;
  struct um_geometry_report report;
};

struct um_geometry {
  struct um_context *context;
  struct um_geometry_part *part; /* [npart] */
  size_t npart, njoint;
  size_t *order; /* [npart] parents before children */
  struct um_geometry_group *group;
  size_t ngroup;
  char **material;
  size_t nmaterial;
  struct um_geometry_mesh mesh;
  struct um_vec3 *vertex; /* [nvertex], part frame [m] */
  struct um_vec3 *normal; /* [nfacet], part frame */
};

/* Take over groups and materials of one part whose facets are in `patch`; closed[nfacet]. */
enum um_status um_geometry_skin_apply(struct um_geometry *geometry,
                                      const struct um_geometry_part_spec *spec, uint32_t part,
                                      const struct um_geometry_patch *patch, const uint8_t *closed);

static inline struct um_vec3 um_geometry_cross_of(const struct um_vec3 *vertex,
                                                  const uint32_t corner[3])
{
  struct um_vec3 a = vertex[corner[0]];
  return um_vec3_cross(um_vec3_sub(vertex[corner[1]], a), um_vec3_sub(vertex[corner[2]], a));
}

#endif
