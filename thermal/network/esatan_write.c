/* A network as ESATAN reads it; esatan.c reads it again. */
#include "base/core/constants.h"
#include "base/core/csv.h"
#include "thermal/network/network_group.h"
#include "thermal/network/network_write.h"

#define ZERO_CELSIUS 273.15 /* [K] */

static void write_node(const struct um_thermal_network_node *node, size_t number, FILE *file)
{
  fprintf(file, "    %c%zu = '%s'", node->kind == UM_NODE_BOUNDARY ? 'B' : "DA"[node->kind], number,
          node -> name);
  um_core_csv_put_behind(file, ", T = ", node->temperature - ZERO_CELSIUS);
  if (node->kind == UM_NODE_DIFFUSIVE) um_core_csv_put_behind(file, ", C = ", node->capacity);
  if (node->power != 0.0) um_core_csv_put_behind(file, ", QI = ", node->power);
  fprintf(file, ";\n");
}

static void write_links(const char *kind, const struct um_thermal_link *link, size_t n,
                        size_t space, FILE *file)
{
  for (size_t k = 0; k < n; k++) {
    size_t b = link[k].b == UM_THERMAL_SPACE ? space : link[k].b + (size_t)1;
    fprintf(file, "    %s(%zu, %zu)", kind, link[k].a + (size_t)1, b);
    um_core_csv_put_behind(file, " = ", link[k].value);
    fprintf(file, ";\n");
  }
}

void um_thermal_network_write_esatan(const struct um_thermal_network *network,
                                     const struct um_thermal_network_note *note, FILE *file)
{
  size_t space = network->nnode + 1;
  fprintf(file, "$MODEL UMBRA\n# %s\n#\n  $NODES\n", note->title);
  for (size_t i = 0; i < network->nnode; i++) write_node(&network->node[i], i + 1, file);
  fprintf(file, "    B%zu = 'space'", space);
  um_core_csv_put_behind(file, ", T = ", note->space - ZERO_CELSIUS);
  fprintf(file, ";\n#\n  $CONDUCTORS\n");
  write_links("GL", network->conductor, network->nconductor, space, file);
  write_links("GR", network->radiator, network->nradiator, space, file);
  fprintf(file, "#\n  $CONSTANTS\n    $CONTROL\n");
  um_core_csv_put_behind(file, "      STEFAN = ", UM_STEFAN_BOLTZMANN);
  um_core_csv_put_behind(file, ";\n      TABS = ", ZERO_CELSIUS);
  fprintf(file, ";\n      RELXCA = 1.0E-8;\n      NLOOP = 1000;\n#\n  $EXECUTION\n"
                "      CALL SOLVFM\n#\n  $OUTPUTS\n"
                "      CALL PRNDTB(' ', 'L, T, QI, C', CURRENT)\n#\n$ENDMODEL UMBRA\n");
}
