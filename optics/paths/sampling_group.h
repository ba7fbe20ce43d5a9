/* Points in more dimensions than core offers, for rays that need a place and a direction at once.
 */
#ifndef UMBRA_OPTICS_SAMPLING_GROUP_H
#define UMBRA_OPTICS_SAMPLING_GROUP_H

#include "base/core/sampling.h"

/* Point `index` of the four-dimensional additive sequence (Roberts 2018: steps 1/g^k, g^5 = g + 1),
 * shifted modulo 1 by values hashed from `key`; in [0, 1)^4. Two two-dimensional sequences with the
 * same index would lie on a surface in the four dimensions and bias what depends on both. */
static inline void um_optics_sample_4d(uint64_t key, uint64_t index, double out[4])
{
  static const uint64_t step[4] = {UINT64_C(0xdb4f0b9175ae2165), UINT64_C(0xbbe0563303a4615f),
                                   UINT64_C(0xa0f2ec75a1fe1575), UINT64_C(0x89e182857d9ed689)};
  for (uint64_t k = 0; k < 4; k++)
    out[k] = um_core_hash_uniform((index + 1) * step[k] + um_core_hash(key, k + 1));
}

#endif
