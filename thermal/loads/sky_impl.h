/* Private to thermal/loads/: what a sky holds. */
#ifndef UMBRA_IRRADIATION_SKY_IMPL_H
#define UMBRA_IRRADIATION_SKY_IMPL_H

#include "thermal/loads/normals_impl.h"
#include "thermal/loads/sky.h"

#define UM_IRRADIATION_CUBE_SIDE  32 /* 2.8 deg: cells of the sky have 6.3 deg */
#define UM_IRRADIATION_CUBE_CELLS (6 * UM_IRRADIATION_CUBE_SIDE * UM_IRRADIATION_CUBE_SIDE)
#define UM_IRRADIATION_LANES      4 /* surfaces of one normal in a word */
#define UM_IRRADIATION_BLOCKS     4 /* blocks of as many that are looked at together, at most */

struct um_irradiation_sky {
  struct um_irradiation_normals normals;
  size_t *word;      /* [normals.n + 1] first word of every cell of a class: its surfaces that are
                        not open, in their order; one word, or a multiple of UM_IRRADIATION_BLOCKS */
  uint16_t *cell;    /* [CUBE_CELLS] of the sky in the middle of each of a cube: found without
                        angles; NULL: all surfaces are open */
  uint32_t *freedom; /* [OPEN_CELLS][words] of each class. Free fraction times 255 in the bits from
                        8 i on: of a class of one word, surface i; of words that are looked at
                        together, surface LANES i + place of the word. 0 behind the last surface */
};

/* Blocks of surfaces of a class that are looked at together. */
static inline size_t um_irradiation_sky_blocks(const struct um_irradiation_sky *sky, size_t class)
{
  return sky->word[class + 1] - sky->word[class] > 1 ? UM_IRRADIATION_BLOCKS : 1;
}

#endif
