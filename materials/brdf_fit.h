/* Measured BRDFs, and the reciprocal model that fits them best. */
#ifndef UMBRA_MATERIALS_BRDF_FIT_H
#define UMBRA_MATERIALS_BRDF_FIT_H

#include "base/core/context.h"
#include "materials/lobe.h"

struct um_materials_brdf_row {
  double incidence, scattering; /* zenith angles [rad]; scattering below 0 is backward */
  double azimuth;               /* out of the plane of incidence, 0 in it [rad] */
  double brdf;                  /* [1/sr] above 0 */
  size_t surface;
};
struct um_materials_brdf {
  struct um_materials_brdf_row *row; /* [nrow] */
  char **surface;                    /* [nsurface], in order of first appearance */
  size_t nrow, nsurface;
};

/* CSV of the columns incidence_deg, scattering_deg, brdf_1_sr, and where there are, azimuth_deg and
 * surface. UM_ERR_INPUT with file, line and column: angles beyond 90 deg, a BRDF that is not above
 * 0, missing or other than finite numbers, no rows. UM_ERR_IO, UM_ERR_MEMORY. The caller destroys.
 */
enum um_status um_materials_brdf_read(struct um_context *context, const char *path,
                                      struct um_materials_brdf **out);
void um_materials_brdf_destroy(struct um_context *context, struct um_materials_brdf **brdf);

/* f = rho/pi + F f_lobe, by least squares of ln f. */
struct um_materials_brdf_fit {
  struct um_materials_lobe lobe;
  double diffuse, specular; /* rho, F [1] */
  double rms, largest;      /* of ln f: root of the mean square, largest difference [1] */
  double albedo; /* directional-hemispherical reflectance, the largest of 0 to 80 deg [1] */
  size_t nrow;   /* rows fitted */
};
/* Fits kind and masking of `lobe` to a surface's rows at half angles of at least `from` [rad] and
 * zenith angles of at most 85 deg; its roughness is between 0.003 and 1.4, to 1e-6 of it.
 * UM_ERR_INPUT: fewer than 6 such rows, a kind without a roughness; UM_ERR_NUMERIC: no
 * convergence. Test: materials/brdf_fit. */
enum um_status um_materials_brdf_fit(struct um_context *context,
                                     const struct um_materials_brdf *brdf, size_t surface,
                                     double from, struct um_materials_lobe lobe,
                                     struct um_materials_brdf_fit *out);

#endif
