/* A map of the Earth as netCDF. */
#include <string.h>

#include "tests/fuzz/earth.h"

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  /* what begins otherwise is a table, another target's */
  if (size < 8 || (memcmp(data, "CDF", 3) != 0 && memcmp(data, "\211HDF\r\n\032\n", 8) != 0))
    return;
  um_fuzz_children_watch();
  earth_try(context, um_fuzz_out_file(data, size));
  um_fuzz_children_judge();
}
