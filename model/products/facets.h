/* Facets as small as temperatures ask for, where they ask for it. */
#ifndef UMBRA_MODEL_FACETS_H
#define UMBRA_MODEL_FACETS_H

#include "model/build/model.h"

#define UM_MODEL_FACETS_ROUNDS 10

/* What one satellite said. */
struct um_model_facets_round {
  size_t nfacet;
  double error; /* of the mean temperature of a group's side, the largest [K] */
  size_t group; /* that group, of the geometry */
  bool back;    /* its side */
};

struct um_model_facets {
  struct um_geometry_halvings *part; /* [npart] */
  size_t npart;
  struct um_model_facets_round round[UM_MODEL_FACETS_ROUNDS + 1];
  size_t nround; /* the first is of facets by their size alone, the last of those of `part` */
  bool reached;  /* every group is within the error asked for */
};

/* From the facets of the model's sizes alone, cut until the mean temperature of every group's
 * side is off by at most thermal.facet_error_K: the heat of the scenario is solved in each round,
 * and where a group is off by more, the facets that hold most of its error are halved
 * (model/run/mesh_error.h). It ends unreached after UM_MODEL_FACETS_ROUNDS halvings, or where there
 * are more than 40,000 facets. Errors of building and of the heat; the caller destroys. */
enum um_status um_model_facets_adapt(struct um_context *context, const struct um_model *model,
                                     struct um_model_facets **out);
void um_model_facets_destroy(struct um_context *context, struct um_model_facets **facets);

#endif
