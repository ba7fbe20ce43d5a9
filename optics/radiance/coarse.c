/* Bands in few bins. */
#include "optics/radiance/coarse_group.h"

#include <math.h>
#include <string.h>

void um_optics_coarse_bands(const struct um_optics_band *bands, size_t nband,
                            struct um_optics_band *coarse, double *transmission)
{
  enum { MOST = UM_OPTICS_COARSE_BINS };
  for (size_t k = 0; k < nband; k++, transmission += MOST) {
    coarse[k] = bands[k];
    if (bands[k].bins <= MOST) continue;
    coarse[k].bins = MOST;
    if (bands[k].transmission == NULL) continue;
    for (int i = 0; i < MOST; i++) {
      int from = i * bands[k].bins / MOST, to = (i + 1) * bands[k].bins / MOST;
      transmission[i] = 0.0;
      for (int b = from; b < to; b++) transmission[i] += bands[k].transmission[b] / (to - from);
    }
    coarse[k].transmission = transmission;
  }
}

enum um_status um_optics_coarse_create(struct um_context *context,
                                       const struct um_optics_scene *scene, size_t first,
                                       size_t count, const struct um_optics_band *bands,
                                       size_t nband, struct um_optics_spectra **out)
{
  enum um_status status;
  struct um_optics_band *coarse = NULL;
  double *transmission = NULL;
  UM_CHECK(um_core_allocate(context, nband, sizeof *coarse, &coarse));
  UM_CHECK(um_core_allocate(context, nband * UM_OPTICS_COARSE_BINS, sizeof *transmission,
                            &transmission));
  um_optics_coarse_bands(bands, nband, coarse, transmission);
  UM_CHECK(um_optics_spectra_create(context, scene, first, count, coarse, nband, out));
done:
  UM_FREE(context, coarse, transmission);
  return status;
}

/* The fine structure of light between surfaces. */
static double light(const struct um_optics_spectra *s, size_t bin)
{
  return s->sun[bin] + s->earth[bin];
}

void um_optics_coarse_expand(const struct um_optics_spectra *few,
                             const struct um_optics_spectra *all, const double *coarse,
                             double *fine)
{
  for (size_t k = 0; k < all->nband; k++) {
    size_t from = few->first[k], n = few->first[k + 1] - from;
    if (n == all->first[k + 1] - all->first[k]) {
      memcpy(fine + all->first[k], coarse + from, n * sizeof *fine);
      continue;
    }
    const double *at = few->wavelength + from, *value = coarse + from;
    size_t low = 0;
    for (size_t b = all->first[k]; b < all->first[k + 1]; b++) {
      double wavelength = all->wavelength[b];
      while (low + 2 < n && at[low + 1] < wavelength) low++;
      double u = (wavelength - at[low]) / (at[low + 1] - at[low]);
      u = fmin(fmax(u, 0.0), 1.0);
      double share = (1.0 - u) * value[low] / light(few, from + low) +
                     u * value[low + 1] / light(few, from + low + 1);
      fine[b] = share * light(all, b);
    }
  }
}
