/* A heat network as nodes.csv and conductors.csv, a line of "%%" between the two. */
#include "thermal/network/network.h"

#include <string.h>

#include "tests/fuzz/fuzz.h"

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  static const char mark[] = "%%\n";
  size_t end = size, begin = size;
  for (size_t i = 0; i + 3 <= size; i++)
    if (memcmp(data + i, mark, 3) == 0) {
      end = i;
      begin = i + 3;
      break;
    }
  const char *nodes = um_fuzz_file(0, data, end);
  const char *conductors = um_fuzz_file(1, data + begin, size - begin);
  struct um_thermal_network *network = NULL;
  if (!um_fuzz_good(context, um_thermal_network_read(context, nodes, conductors, &network))) {
    if (network != NULL) um_fuzz_finding("a network in spite of the failure");
    return;
  }
  for (uint32_t i = 0; i < um_thermal_network_nodes(network); i++) {
    const char *name = um_thermal_network_name(network, i);
    um_fuzz_finite(um_thermal_network_temperature(network, i), "a temperature");
    um_fuzz_finite(um_thermal_network_capacity(network, i), "a capacity");
    if (name == NULL || um_thermal_network_find(network, name) != i)
      um_fuzz_finding("node %u is not found by its name", i);
  }
  um_thermal_network_destroy(&network);
}
