/* The outside of the satellite: parts (primitives or OBJ meshes), poses, joints -> one triangle
 * mesh in body frame. A facet is seen from its front when counter-clockwise. */
#ifndef UMBRA_GEOMETRY_GEOMETRY_H
#define UMBRA_GEOMETRY_GEOMETRY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/core/context.h"
#include "base/core/vec.h"

#define UM_GEOMETRY_NONE UINT32_MAX

enum um_geometry_shape {
  UM_SHAPE_BOX,        /* size x y z, centred; groups +x -x +y -y +z -z */
  UM_SHAPE_PLATE,      /* size x y in the xy plane, centred, front +z; group "plate"; open */
  UM_SHAPE_DISC,       /* radius, front +z; group "disc"; open */
  UM_SHAPE_CYLINDER,   /* radius, height along z, centred; groups side top bottom */
  UM_SHAPE_CONE,       /* radius at z=-h/2, radius_top at +h/2 (0: apex); groups side top bottom */
  UM_SHAPE_SPHERE,     /* radius; group "sphere"; icosphere scaled so that its area is 4 pi r^2 */
  UM_SHAPE_PARABOLOID, /* dish z = r^2/(4 f), radius, focal_length; front is the concave side +z;
                          group "dish"; open */
  UM_SHAPE_MESH /* OBJ file; group of a face: its `g`, without one its usemtl, without that its
                   `o`, else "mesh" */
};

/* What a part is made of on one group: names of materials; NULL where the shape has no such side.
 */
struct um_geometry_skin {
  const char *group;        /* NULL: every group not named elsewhere */
  const char *front, *back; /* material names; back NULL: the back is not a surface (closed body) */
};

enum um_geometry_joint_kind { UM_JOINT_NONE, UM_JOINT_FIXED, UM_JOINT_SUN, UM_JOINT_SCHEDULE };

/* Angles of a joint by time: linear between rows, a jump where two rows have one time, held before
 * the first and after the last. */
struct um_geometry_schedule {
  size_t nrow;
  const double *t;     /* [nrow] ascending, t_tai [s] */
  const double *angle; /* [nrow] [rad] */
};

/* Facets that are cut beyond facet_size, round after round: those of a round by their number in the
 * part's mesh after the rounds before it. A halving halves the longest edge wanted of a facet. */
struct um_geometry_halving {
  size_t nfacet;         /* the part has before the round */
  const uint32_t *facet; /* [nhalved] that are halved, ascending */
  size_t nhalved;
};
struct um_geometry_halvings {
  const struct um_geometry_halving *round; /* [nround] */
  size_t nround;
};

/* Description of one part; strings are copied. */
struct um_geometry_part_spec {
  const char *name;
  enum um_geometry_shape shape;
  double size[3];                                  /* [m] */
  double radius, radius_top, height, focal_length; /* [m] */
  const char *mesh_path;
  double mesh_scale;              /* metres per file unit; 0 means 1 [m] */
  const char *const *mesh_groups; /* [nmesh_group] of the file, these alone; none: all */
  size_t nmesh_group;
  const char *parent;      /* NULL: the body frame */
  struct um_vec3 position; /* of the part's origin in the parent's frame [m] */
  struct um_quat rotation; /* parent frame to part frame, passive; all zero: not turned */
  enum um_geometry_joint_kind joint;
  struct um_vec3 joint_axis; /* unit, in the part frame, through its origin [1] */
  struct um_vec3
      joint_normal;   /* SUN: this unit vector of the part frame is turned toward the Sun */
  double joint_angle; /* [rad], FIXED; offset of SUN and SCHEDULE */
  struct um_geometry_schedule schedule; /* SCHEDULE */
  struct um_vec3 grain; /* direction of brushing or tows, in the part frame; all zero: x [1] */
  const struct um_geometry_skin *skins; /* [nskin] */
  size_t nskin;
  double facet_size; /* longest edge wanted [m]; 0: only what the shape needs */
  struct um_geometry_halvings halvings;
  bool solid; /* declared solid: must be closed, is meshed with tetrahedra */
};

/* A surface is one radiating side of one facet. Index order is fixed by part, facet, side. */
struct um_geometry_surface {
  uint32_t facet;
  uint32_t part;
  uint32_t group;    /* index into the model's group list */
  uint32_t material; /* index into the model's material names */
  uint8_t back;      /* 0 front, 1 back: the outward normal is then the negated facet normal */
};

struct um_geometry_group {
  const char *name; /* e.g. "+x" */
  uint32_t part;
  uint32_t front_material, back_material; /* UM_GEOMETRY_NONE: not a surface */
};

/* Topology is constant; positions depend on joint angles (see um_geometry_pose). */
struct um_geometry_mesh {
  size_t nvertex, nfacet, nsurface;
  uint32_t (*corner)[3];                        /* [nfacet] vertex indices */
  uint32_t *facet_part, *facet_group;           /* [nfacet] */
  uint32_t *surface_of_front, *surface_of_back; /* [nfacet], UM_GEOMETRY_NONE where none */
  struct um_geometry_surface *surface;          /* [nsurface] */
  double *area;                                 /* [nfacet] [m^2] */
};

/* Positions of one configuration of the joints, body frame. */
struct um_geometry_pose {
  struct um_vec3 *vertex;       /* [nvertex] [m] */
  struct um_vec3 *facet_normal; /* [nfacet] unit, of the front [1] */
};

struct um_geometry; /* opaque: parts, groups, materials, mesh */

/* Build from specs. Refuses (UM_ERR_INPUT): unknown parent or cycle, duplicate names, sizes not
 * positive, unknown group in a skin, a group without material, a closed body with open edges
 * declared solid, degenerate (zero-area) facets in a file (with its line). Vertices are welded per
 * part. Opposite-side materials: refused are an open facet without one, and a facet of a closed
 * connected piece with one. */
enum um_status um_geometry_create(struct um_context *context,
                                  const struct um_geometry_part_spec *parts, size_t npart,
                                  struct um_geometry **out);
void um_geometry_destroy(struct um_geometry **geometry);

const struct um_geometry_mesh *um_geometry_mesh(const struct um_geometry *geometry);
size_t um_geometry_part_count(const struct um_geometry *geometry);
const char *um_geometry_part_name(const struct um_geometry *geometry, size_t part);
size_t um_geometry_part_find(const struct um_geometry *geometry, const char *name); /* (size_t)-1 */
size_t um_geometry_group_count(const struct um_geometry *geometry);
const struct um_geometry_group *um_geometry_group(const struct um_geometry *geometry, size_t group);
size_t um_geometry_material_count(const struct um_geometry *geometry);
const char *um_geometry_material_name(const struct um_geometry *geometry, size_t material);

/* Do both have the same surfaces at the same places at any joint angles, number for number: parts
 * and their joints, vertices, facets, groups, and which material by its index? Names and grain are
 * not looked at. */
bool um_geometry_equal(const struct um_geometry *a, const struct um_geometry *b);

/* Joints: angles are [njoint], one per part that has a joint, in part order. */
size_t um_geometry_joint_count(const struct um_geometry *geometry);
bool um_geometry_joint_moves(const struct um_geometry *geometry); /* any SUN or SCHEDULE */
/* Angles [rad] for a Sun direction in body frame (unit) at t_tai [s], which may be infinite. FIXED
 * joints give their constant. A Sun along the axis gives 0. Outermost parents are turned first. */
void um_geometry_joint_angles(const struct um_geometry *geometry, struct um_vec3 sun_body,
                              double t_tai, double *angles);
/* Positions at those angles (NULL when there is no joint). The caller destroys. */
enum um_status um_geometry_pose_create(struct um_context *context,
                                       const struct um_geometry *geometry, const double *angles,
                                       struct um_geometry_pose **out);
void um_geometry_pose_destroy(struct um_context *context, struct um_geometry_pose **pose);
/* Outward unit normal of a surface. */
struct um_vec3 um_geometry_surface_normal(const struct um_geometry_mesh *mesh,
                                          const struct um_geometry_pose *pose, size_t surface);

/* Body frame to each part's, [npart], at those angles (NULL when there is no joint). */
void um_geometry_part_rotations(const struct um_geometry *geometry, const double *angles,
                                struct um_quat *rotation);
/* Unit vectors in the surface, body frame: its part's grain projected on it, and across it, so that
 * grain, across and outward normal are right-handed. A surface that the grain stands upright on
 * takes the axis that follows it: of (x, y, z) the direction (z, x, y). */
void um_geometry_surface_grain(const struct um_geometry *geometry, const struct um_quat *rotation,
                               size_t surface, struct um_vec3 *grain, struct um_vec3 *across);

/* What a user wants to know of a part before trusting it. */
struct um_geometry_report {
  const char *part;
  size_t nvertex, nfacet, ndegenerate, nboundary_edge, nonmanifold_edge;
  double area;           /* of the facets, one side [m^2] */
  double volume;         /* [m^3]; NaN unless closed */
  bool closed;           /* watertight and consistently oriented */
  double sharpest_angle; /* smallest facet angle [rad] */
};
struct um_geometry_report um_geometry_report(const struct um_geometry *geometry, size_t part);
/* Area of all surfaces of a material [m^2]. */
double um_geometry_material_area(const struct um_geometry *geometry, size_t material);

#endif
