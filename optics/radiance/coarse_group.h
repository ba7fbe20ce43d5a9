/* Bands in few bins, for what then does not cost by theirs: 0.5 % of an error, and light between
 * surfaces. */
#ifndef UMBRA_OPTICS_COARSE_GROUP_H
#define UMBRA_OPTICS_COARSE_GROUP_H

#include "optics/radiance/spectra_impl.h"

#define UM_OPTICS_COARSE_BINS 16 /* of a band, at most */

/* coarse[nband], whose filters stand in transmission[nband][UM_OPTICS_COARSE_BINS]. */
void um_optics_coarse_bands(const struct um_optics_band *bands, size_t nband,
                            struct um_optics_band *coarse, double *transmission);
/* um_optics_spectra_create in few bins of each band. */
enum um_status um_optics_coarse_create(struct um_context *context,
                                       const struct um_optics_scene *scene, size_t first,
                                       size_t count, const struct um_optics_band *bands,
                                       size_t nband, struct um_optics_spectra **out);

/* A spectrum in the bins of the bands, fine[nbin], of one in few: what lies between these goes with
 * sunlight and the Earth's radiation. The same to the last digit where the bins are the same. */
void um_optics_coarse_expand(const struct um_optics_spectra *few,
                             const struct um_optics_spectra *all, const double *coarse,
                             double *fine);

#endif
