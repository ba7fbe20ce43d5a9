/* Bands in few bins. */
#include "optics/coarse_impl.h"

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
