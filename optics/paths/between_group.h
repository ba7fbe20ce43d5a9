/* Light between surfaces as a light curve adds it up, of one instant after the other. */
#ifndef UMBRA_OPTICS_BETWEEN_GROUP_H
#define UMBRA_OPTICS_BETWEEN_GROUP_H

#include "optics/paths/photons_group.h"
#include "optics/paths/posed_scenes_group.h"

/* Of one thread. */
struct um_optics_between {
  struct um_optics_photons photons;
  double *sum;      /* [nmaterial][nbin] toward the observer [W/sr/m] */
  double *variance; /* [nband] of its band sums [W^2/sr^2] */
};
/* [n]; clear is for what create left, after a failure too. */
enum um_status um_optics_between_create(struct um_context *context,
                                        const struct um_optics_spectra *spectra, size_t n,
                                        struct um_optics_between **out);
void um_optics_between_destroy(struct um_context *context, size_t n,
                               struct um_optics_between **between);
/* Room for every pose of the scenes and the largest factor[ntime], each [n]. */
enum um_status um_optics_between_reserve(struct um_context *context,
                                         const struct um_optics_spectra *spectra,
                                         const struct um_optics_posed_scenes *scenes,
                                         const int *factor, size_t ntime, size_t n,
                                         struct um_optics_between *between);

/* Sums of an instant; of the paths' work um_optics_light has been called. */
void um_optics_between_compute(const struct um_context *context,
                               const struct um_optics_paths *paths,
                               struct um_optics_between *between);

#endif
