/* A network as SINDA/FLUINT reads it: arithmetic nodes have a capacitance of -1, boundary nodes and
 * radiation conductors a negative number. */
#include "base/core/constants.h"
#include "base/core/csv.h"
#include "thermal/network/network_group.h"
#include "thermal/network/network_write.h"

static void write_node(const struct um_thermal_network_node *node, size_t number, FILE *file)
{
  fprintf(file, "  %s%zu", node->kind == UM_NODE_BOUNDARY ? "-" : "", number);
  um_core_csv_put_behind(file, ", ", node->temperature);
  um_core_csv_put_behind(file, ", ", node->kind == UM_NODE_ARITHMETIC ? -1.0 : node->capacity);
  fprintf(file, " $ %s\n", node->name);
}

static void write_links(const char *sign, const struct um_thermal_link *link, size_t n,
                        size_t space, size_t *number, FILE *file)
{
  for (size_t k = 0; k < n; k++) {
    size_t b = link[k].b == UM_THERMAL_SPACE ? space : link[k].b + (size_t)1;
    fprintf(file, "  %s%zu, %zu, %zu", sign, ++*number, link[k].a + (size_t)1, b);
    um_core_csv_put_behind(file, ", ", link[k].value);
    fputc('\n', file);
  }
}

void um_thermal_network_write_sinda(const struct um_thermal_network *network,
                                    const struct um_thermal_network_note *note, FILE *file)
{
  size_t space = network->nnode + 1, number = 0;
  fprintf(file, "HEADER OPTIONS DATA\nTITLE %s\nHEADER CONTROL DATA, GLOBAL\n  UID = SI\n",
          note->title);
  fprintf(file, "  ABSZRO = 0.0\n");
  um_core_csv_put_behind(file, "  SIGMA = ", UM_STEFAN_BOLTZMANN);
  fprintf(file, "\n  NLOOPS = 1000\nHEADER NODE DATA, UMBRA\n");
  for (size_t i = 0; i < network->nnode; i++) write_node(&network->node[i], i + 1, file);
  fprintf(file, "  -%zu", space);
  um_core_csv_put_behind(file, ", ", note->space);
  fprintf(file, ", 0.0 $ space\nHEADER CONDUCTOR DATA, UMBRA\n");
  write_links("", network->conductor, network->nconductor, space, &number, file);
  write_links("-", network->radiator, network->nradiator, space, &number, file);
  fprintf(file, "HEADER SOURCE DATA, UMBRA\n");
  for (size_t i = 0; i < network->nnode; i++) {
    if (network->node[i].power == 0.0) continue;
    fprintf(file, "  %zu", i + 1);
    um_core_csv_put_behind(file, ", ", network->node[i].power);
    fputc('\n', file);
  }
  fprintf(file, "HEADER OPERATIONS\nBUILD UMBRA, UMBRA\nDEFMOD UMBRA\n      CALL STEADY\n"
                "HEADER OUTPUT CALLS, UMBRA\n      CALL TPRINT('UMBRA')\nEND OF DATA\n");
}
