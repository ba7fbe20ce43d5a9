/* Surfaces that mirror, by classes of one reflectance: what of a ray's way depends on geometry is
 * traced once, with the mirrors that it met, and weighed with any reflectances afterwards. */
#ifndef UMBRA_GEOMETRY_MIRRORS_H
#define UMBRA_GEOMETRY_MIRRORS_H

#include "geometry/patches.h"
#include "geometry/visibility.h"

#define UM_GEOMETRY_NO_MIRROR       UINT16_MAX
#define UM_GEOMETRY_MIRRORS_DEEPEST 16 /* mirrors that a path meets, at most */

struct um_geometry_mirrors {
  size_t nsurface, nclass;
  uint16_t *of; /* [nsurface] class, or UM_GEOMETRY_NO_MIRROR; one for all surfaces of a patch */
};
/* nclass 0, no surface a mirror. The caller destroys. */
enum um_status um_geometry_mirrors_create(struct um_context *context, size_t nsurface,
                                          struct um_geometry_mirrors **out);
void um_geometry_mirrors_destroy(struct um_context *context, struct um_geometry_mirrors **mirrors);
/* Class of a patch, or UM_GEOMETRY_NO_MIRROR; mirrors NULL: none. */
uint16_t um_geometry_mirrors_patch(const struct um_geometry_mirrors *mirrors,
                                   const struct um_geometry_patches *patches, size_t p);

/* The mirrors that a path met, ascending: its weight does not go with their order, and a path and
 * its way back are one. */
struct um_geometry_mirror_set {
  uint16_t n, mirror[UM_GEOMETRY_MIRRORS_DEEPEST]; /* classes; the rest 0 */
};
/* Add one; false: there are UM_GEOMETRY_MIRRORS_DEEPEST already. */
bool um_geometry_mirror_set_add(struct um_geometry_mirror_set *set, uint16_t mirror);
/* Product of reflectances [nclass] of its mirrors [1]. */
double um_geometry_mirror_set_weight(const struct um_geometry_mirror_set *set,
                                     const double *reflectance);

/* Sets by number, each once. Zeroed: empty. */
struct um_geometry_mirror_sets {
  struct um_geometry_mirror_set *set; /* [n] */
  uint32_t *slot;                     /* [nslot] number, of a table by hash */
  size_t n, room, nslot;
};
/* Number of a set, which is added where it is new. UM_ERR_MEMORY. */
enum um_status um_geometry_mirror_sets_find(struct um_context *context,
                                            struct um_geometry_mirror_sets *sets,
                                            const struct um_geometry_mirror_set *set,
                                            uint32_t *out);
void um_geometry_mirror_sets_clear(struct um_context *context,
                                   struct um_geometry_mirror_sets *sets);

/* What goes with a ray on its way from mirror to mirror. */
struct um_geometry_mirrored_path {
  struct um_geometry_mirror_set met;
  uint32_t tag; /* the caller's */
};
/* Of rays[n] that ended at hit[n], those that met a mirror go on from there along
 * d - 2 (d . n) n, in their order; the others, and those that have met as many mirrors as are
 * followed, are left out. Returns how many are left. A ray that is on its way to space, or slipped
 * into a closed part, ends. */
size_t um_geometry_mirrored_turn(const struct um_geometry_mesh *mesh,
                                 const struct um_geometry_pose *pose,
                                 const struct um_geometry_mirrors *mirrors,
                                 struct um_geometry_ray *ray,
                                 struct um_geometry_mirrored_path *path,
                                 const struct um_geometry_hit *hit, size_t n);

#endif
