/* A network as the two tables that are read again (network_read.c). */
#include "thermal/network/network_write.h"

#include "base/core/csv.h"
#include "thermal/network/network_group.h"

void um_thermal_network_write_nodes(const struct um_thermal_network *network, FILE *file)
{
  static const char *const kinds[] = {"diffusive", "arithmetic", "boundary"};
  fprintf(file, "name,kind,capacity_J_K,T0_K,power_W\n");
  for (size_t i = 0; i < network->nnode; i++) {
    const struct um_thermal_network_node *node = &network->node[i];
    um_core_csv_put(file, node->name, "");
    fprintf(file, ",%s", kinds[node->kind]);
    um_core_csv_put_exact(file, node->capacity);
    um_core_csv_put_exact(file, node->temperature);
    um_core_csv_put_exact(file, node->power);
    fputc('\n', file);
  }
}

static void write_links(const struct um_thermal_network *network, const char *kind,
                        const struct um_thermal_link *link, size_t n, FILE *file)
{
  for (size_t k = 0; k < n; k++) {
    fprintf(file, "%s", kind);
    um_core_csv_put_text(file, network->node[link[k].a].name, "");
    um_core_csv_put_text(
        file, link[k].b == UM_THERMAL_SPACE ? "space" : network->node[link[k].b].name, "");
    um_core_csv_put_exact(file, link[k].value);
    fputc('\n', file);
  }
}

void um_thermal_network_write_conductors(const struct um_thermal_network *network, FILE *file)
{
  fprintf(file, "kind,a,b,value\n");
  write_links(network, "GL", network->conductor, network->nconductor, file);
  write_links(network, "GR", network->radiator, network->nradiator, file);
}
