/* Reflectance as a spectrometer gives it: relative to a reference mirror. */
#ifndef UMBRA_MATERIALS_RATIO_H
#define UMBRA_MATERIALS_RATIO_H

#include "materials/materials.h"

struct um_materials_measured_reflectance {
  double *wavelength, *reflectance; /* [n] [m] ascending, absolute [1] */
  size_t n;
  size_t nabove;              /* rows that came out above 1 and are 1 here */
  double largest, largest_at; /* the most of them, before [1], [m]; 0: none */
};
/* CSV of the columns wavelength_um, ascending, and ratio, sample over reference, not negative. The
 * absolute reflectance is
 *   R(lambda) = ratio(lambda) R_ref(lambda, theta)
 * with R_ref Fresnel's of the reference's optical constants at the angle at which both were
 * measured (cosine), no finish of a library record. UM_ERR_INPUT with file, line and column, also
 * where the constants do not reach; for a reference without constants. UM_ERR_IO, UM_ERR_MEMORY.
 * The caller frees. Test: materials/ratio. */
enum um_status um_materials_ratio_read(struct um_context *context, const char *path,
                                       const struct um_materials_record *reference, double cosine,
                                       struct um_materials_measured_reflectance *out);
void um_materials_ratio_free(struct um_context *context,
                             struct um_materials_measured_reflectance *measured);

#endif
