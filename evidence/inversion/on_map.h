/* Measurements on a reflectivity map: what each row says of the body's reflectivity. */
#ifndef UMBRA_COMPARE_ON_MAP_H
#define UMBRA_COMPARE_ON_MAP_H

#include <stdio.h>

#include "evidence/comparison/predict.h"
#include "model/products/reflectivity.h"
#include "model/products/reflectivity_pass.h"

/* A row of light, as reflectivity. */
struct um_compare_map_row {
  size_t row;         /* of the set */
  size_t observation; /* of the pass */
  size_t band;
  double value, sigma; /* reflectivity [m^2/sr]; sigma NaN where the file gives none */
  double light;        /* what a body of 1 m^2/sr would give, in linear flux of the quantity */
};
struct um_compare_on_map {
  const struct um_compare_measurements *measurements; /* borrowed */
  struct um_compare_plan *plan;
  struct um_environment_sample *sample; /* [ntime of the plan] */
  struct um_compare_map_row *row;       /* [count] */
  size_t count;
  size_t dark; /* rows left out: no sunlight there */
};

/* Every row of light with flag 0 that was made in sunlight, over what a body of reflectivity 1
 * m^2/sr would have given there and then, with the shadow's edge, the range, and where the scenario
 * states it the air. Exposures count as their middle; temperatures are left out; what the Earth
 * lights and heat is in the values, so the map is for bands that sunlight rules. UM_ERR_INPUT: as
 * um_compare_plan_create; no row of light in sunlight. The caller destroys. */
enum um_status um_compare_on_map_create(struct um_context *context, const struct um_model *model,
                                        const struct um_compare_measurements *measurements,
                                        struct um_compare_on_map **out);
void um_compare_on_map_destroy(struct um_context *context, struct um_compare_on_map **on_map);

/* measured.csv: where each row lies, its reflectivity and that of the map. */
enum um_status um_compare_on_map_write(struct um_context *context,
                                       const struct um_compare_on_map *on_map,
                                       const struct um_model *model,
                                       const struct um_model_map_pass *pass, FILE *file);

#endif
