/* Whitened observations as they are after the best fit of nuisance directions. */
#ifndef UMBRA_INFERENCE_PROJECTION_H
#define UMBRA_INFERENCE_PROJECTION_H

#include "base/inference/direction.h"
#include "base/inference/policy.h"

struct um_inference_qr;

struct um_inference_projection {
  size_t nrow, nprior;
  size_t nleft;               /* rows after the projection: nrow + nprior - rank of the nuisances */
  struct um_inference_qr *qr; /* NULL: no nuisance */
  double *work;               /* [nrow + nprior] */
};

/* UM_ERR_INPUT: nuisances without prior as many as the observations or more. UM_ERR_NUMERIC: one is
 * not finite. UM_ERR_MEMORY. The caller destroys what was begun, after an error too. */
enum um_status um_inference_projection_create(struct um_context *context, size_t nrow,
                                              const struct um_inference_nuisance *nuisance,
                                              struct um_inference_projection *out);
void um_inference_projection_destroy(struct um_context *context,
                                     struct um_inference_projection *projection);
/* v [nrow] in other coordinates without what the nuisances explain: out [nleft]. Lengths of and
 * angles between such vectors are those of what is left. */
void um_inference_projection_apply(struct um_inference_projection *projection, const double *v,
                                   double *out);

/* Columns of a direction after the projection: left [ncolumn][nleft]; one that is absorbed is
 * all 0. kept: the largest share that is left of any, 0 when the observations see none. */
void um_inference_projection_direction(struct um_inference_projection *projection,
                                       const struct um_inference_direction *direction, double *left,
                                       double *kept);

#endif
