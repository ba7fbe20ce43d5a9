/* A map of the Earth as a table. */
#include <string.h>

#include "tests/fuzz/earth.h"

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  /* what begins like netCDF is another target's */
  if (size >= 4 && (memcmp(data, "CDF", 3) == 0 || memcmp(data, "\211HDF", 4) == 0)) return;
  earth_try(context, um_fuzz_file(0, data, size));
}
