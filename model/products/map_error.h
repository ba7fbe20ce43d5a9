/* How far looking up on a map is off, measured. */
#ifndef UMBRA_MODEL_MAP_ERROR_H
#define UMBRA_MODEL_MAP_ERROR_H

#include "model/products/reflectivity_map.h"

/* Where: over all directions, or within 5 deg of normals of the body, where its glints are. */
enum um_model_map_where { UM_MAP_EVERYWHERE, UM_MAP_AT_NORMALS, UM_MAP_WHERES };
/* "everywhere", "at_normals"; borrowed for good. */
const char *um_model_map_where_name(enum um_model_map_where where);

/* Of one band there, looked up less computed. */
struct um_model_map_off {
  double mean;                     /* computed [m^2/sr] */
  double rms, largest;             /* of the difference; largest: of its amount [m^2/sr] */
  struct um_model_phase_vector at; /* where it is largest */
};
struct um_model_map_error {
  size_t n[UM_MAP_WHERES];      /* places; 0 at normals where joints move */
  struct um_model_map_off *off; /* [UM_MAP_WHERES][nband] */
};

/* At places that are no nodes: evenly over the sphere, or about normals as many as their area asks
 * for; planes all round; phase angles evenly from the smallest of the map to its largest. Places
 * are drawn by their number: a map has always the same. Errors of um_model_reflectivity. The caller
 * destroys. Test: tests/model/products/map_refine.c. */
enum um_status um_model_map_error_measure(struct um_context *context, const struct um_model *model,
                                          const struct um_model_map *map,
                                          struct um_model_map_error **out);
void um_model_map_error_destroy(struct um_context *context, struct um_model_map_error **error);

#endif
