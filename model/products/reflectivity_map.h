/* Reflectivity map: what a body sends of sunlight, over the phase vector in body axes. */
#ifndef UMBRA_MODEL_REFLECTIVITY_MAP_H
#define UMBRA_MODEL_REFLECTIVITY_MAP_H

#include "model/build/model.h"
#include "model/products/map_nodes.h"
#include "model/products/phase_vector.h"

/* Where the middle of a cell, or the normal of a flat surface in it, is off by more than
 * tolerance x max(value, mean of the phase angle), by interpolation of the value and of its
 * logarithm alike, the cell is halved across its longer side, until it is 0.1 deg small or the map
 * has four times the nodes of its grid. UM_ERR_INPUT: a grid that is none, or above 2e7 nodes (the
 * message says of what). Others as um_model_reflectivity. The caller destroys. Tests:
 * tests/model/products/map_refine.c. */
enum um_status um_model_map_create(struct um_context *context, const struct um_model *model,
                                   const struct um_model_map_grid *grid, struct um_model_map **out);
/* A grid without values, for what else lies on the directions of a body: planes share `turn`, and
 * phase_angle is then any ascending coordinate above 0. UM_ERR_MEMORY. The caller destroys. */
enum um_status um_model_map_allocate(struct um_context *context,
                                     const struct um_model_map_grid *grid, double turn,
                                     size_t nband, struct um_model_map **out);
/* The place of a node. */
struct um_model_phase_vector um_model_map_place(const struct um_model_map *map, size_t phase,
                                                size_t plane, size_t latitude, size_t longitude);
void um_model_map_destroy(struct um_context *context, struct um_model_map **map);

/* A node over its planes: mean, spread (standard deviation over the planes) and the standard error
 * of the mean, the errors of planes taken as fully correlated [m^2/sr]. */
struct um_model_map_node {
  double mean, spread, error;
};
struct um_model_map_node um_model_map_node(const struct um_model_map *map, size_t phase,
                                           size_t latitude, size_t longitude, size_t band);

/* Reflectivity at a place by interpolation [m^2/sr]: linear in latitude and longitude (within
 * refined cells as each says), in the plane, and in the phase angle; beyond the largest and before
 * the smallest phase angle of the map that of these. out[nband]. NaN for a place that is none (Sun
 * and observer opposite). */
void um_model_map_look_up(const struct um_model_map *map, const struct um_model_phase_vector *at,
                          double *out);

#endif
