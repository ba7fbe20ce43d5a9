/* Roughness from measured heights, as an interferometer gives them. */
#ifndef UMBRA_MATERIALS_PROFILE_H
#define UMBRA_MATERIALS_PROFILE_H

#include "base/core/context.h"

struct um_materials_heights {
  double *height; /* [ny][nx] [m], the mean plane taken off */
  size_t nx, ny;  /* ny 1: a profile */
  double dx, dy;  /* [m] */
};
/* CSV of the columns x_um, height_um, and y_um of a map: rows by y, then by x, both ascending in
 * even steps (1e-3 of one) without a gap. UM_ERR_INPUT with file, line and column; UM_ERR_IO,
 * UM_ERR_MEMORY. The caller frees with um_materials_heights_free. */
enum um_status um_materials_heights_read(struct um_context *context, const char *path,
                                         struct um_materials_heights *out);
void um_materials_heights_free(struct um_context *context, struct um_materials_heights *heights);

struct um_materials_slope {
  double rq;             /* root of the mean square height [m] */
  double tau;            /* shortest shift at which the autocorrelation falls to 0.2 [m] */
  double alpha;          /* sqrt(2) Rq/tau, of Table 1 of the Flying Laptop paper [1] */
  double alpha_gaussian; /* 2 sqrt(ln 5) Rq/tau: root of the mean square slope where the
                            autocorrelation is Gaussian, which is Beckmann's alpha [1] */
  double samples;        /* of tau: steps along the direction it was found in [1] */
};
/* Along x, and for maps along y, both diagonals and the four directions between; linear between
 * steps. UM_ERR_INPUT: flat, or nowhere as low as 0.2 within half of what was measured. Test:
 * materials/profile. */
enum um_status um_materials_heights_roughness(struct um_context *context,
                                              const struct um_materials_heights *heights,
                                              struct um_materials_slope *out);

#endif
