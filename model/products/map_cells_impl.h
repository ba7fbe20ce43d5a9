/* Cells of a refined map. Private to model/products/. */
#ifndef UMBRA_MODEL_MAP_CELLS_IMPL_H
#define UMBRA_MODEL_MAP_CELLS_IMPL_H

#include "model/build/model.h"
#include "model/products/map_nodes.h"

/* Refine the cells of a map whose grid has values, to its tolerance. Errors of
 * um_model_reflectivity. */
enum um_status um_model_map_refine(struct um_context *context, const struct um_model *model,
                                   struct um_model_map *map);

/* The cell of the grid at a plane (of all), a row and a column. */
static inline const struct um_model_map_cell *um_model_map_cell_of(const struct um_model_map *map,
                                                                   size_t plane, size_t i, size_t j)
{
  return &map->cell[(plane * (map->nlatitude - 1) + i) * map->nlongitude + j];
}
/* Value of a band between the corners of one cell; f: shares to the north and to the east. */
double um_model_map_between(const struct um_model_map *map, size_t phase, const uint32_t corner[4],
                            bool logarithmic, const double f[2], size_t band);
/* Add weight times the values [nband] in a cell, wherever it is split. */
void um_model_map_cell_add(const struct um_model_map *map, size_t phase,
                           const struct um_model_map_cell *cell, const double f[2], double weight,
                           double *out);

#endif
