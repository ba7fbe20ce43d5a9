/* Facets whose boxes touch. Private to geometry/. */
#ifndef UMBRA_GEOMETRY_FACET_TREE_IMPL_H
#define UMBRA_GEOMETRY_FACET_TREE_IMPL_H

#include "geometry/geometry.h"

struct um_geometry_facet_tree;

/* Of the facets of one pose. UM_ERR_MEMORY, UM_ERR_CANCELLED. */
enum um_status um_geometry_facet_tree_create(struct um_context *context,
                                             const struct um_geometry_mesh *mesh,
                                             const struct um_geometry_pose *pose,
                                             struct um_geometry_facet_tree **out);
void um_geometry_facet_tree_destroy(struct um_context *context,
                                    struct um_geometry_facet_tree **tree);
/* Diagonal of the box of all [m]. */
double um_geometry_facet_tree_size(const struct um_geometry_facet_tree *tree);
/* Calls visit for every facet, `facet` itself too, whose box comes within `margin` [m] of that of
 * `facet`, in an order of the tree's own, until it returns false; false where it did. */
bool um_geometry_facet_tree_visit(const struct um_geometry_facet_tree *tree, uint32_t facet,
                                  double margin, bool (*visit)(void *user, uint32_t other),
                                  void *user);

#endif
