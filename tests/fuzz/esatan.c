/* A heat network of ESATAN. */
#include "tests/fuzz/fuzz.h"
#include "thermal/network/network.h"

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  const char *path = um_fuzz_file(0, data, size);
  struct um_thermal_network *network = NULL;
  if (!um_fuzz_good(context, um_thermal_network_read(context, path, NULL, &network))) {
    if (network != NULL) um_fuzz_finding("a network in spite of the failure");
    return;
  }
  for (uint32_t i = 0; i < um_thermal_network_nodes(network); i++) {
    const char *name = um_thermal_network_name(network, i);
    um_fuzz_finite(um_thermal_network_temperature(network, i), "a temperature");
    um_fuzz_finite(um_thermal_network_capacity(network, i), "a capacity");
    um_fuzz_finite(um_thermal_network_power(network, i), "a power");
    if (name == NULL || name[0] == '\0') um_fuzz_finding("node %u has no name", i);
  }
  um_thermal_network_destroy(&network);
}
