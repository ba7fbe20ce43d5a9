/* The heat balance of a scenario as a network, for other thermal programs. */
#include "output/network.h"

#include "thermal/network/network_write.h"

enum um_status um_output_write_network(struct um_context *context, const struct um_model *model,
                                       const struct um_thermal_network *network,
                                       struct um_core_folder *folder)
{
  enum um_status status;
  FILE *file = NULL;
  char *title = NULL;
  UM_TRY(um_core_asprintf(context, &title, "%s: powers and the temperatures of their balance",
                          model->scenario->name));
  struct um_thermal_network_note note = {title, model->scenario->thermal->space_temperature_K};
  UM_CHECK(um_core_folder_open(context, folder, "nodes.csv", &file));
  um_thermal_network_write_nodes(network, file);
  UM_CHECK(um_core_file_close(context, "nodes.csv", &file));
  UM_CHECK(um_core_folder_open(context, folder, "conductors.csv", &file));
  um_thermal_network_write_conductors(network, file);
  UM_CHECK(um_core_file_close(context, "conductors.csv", &file));
  UM_CHECK(um_core_folder_open(context, folder, "network.d", &file));
  um_thermal_network_write_esatan(network, &note, file);
  UM_CHECK(um_core_file_close(context, "network.d", &file));
  UM_CHECK(um_core_folder_open(context, folder, "network.inp", &file));
  um_thermal_network_write_sinda(network, &note, file);
  UM_CHECK(um_core_file_close(context, "network.inp", &file));
done:
  if (file != NULL) fclose(file);
  um_core_free(context, title);
  return status;
}
