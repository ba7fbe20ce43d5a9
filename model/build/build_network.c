/* A part whose heat is stated as nodes and conductors in two tables, or as a network of ESATAN; its
 * shape and its materials stay for light and radiation. */
#include "model/build/steps_impl.h"

#include <string.h>

#include "base/core/csv.h"
#include "model/build/messages_group.h"

#define NONE ((size_t)-1)

/* What walls and insides are stated by otherwise. */
static enum um_status check_keys(struct um_context *context, const struct um_scenario_part *part)
{
  const struct {
    const char *key;
    bool there;
  } keys[] = {{"lumped", part->lumped},
              {"solid", part->solid != NULL},
              {"shell", part->shell != NULL},
              {"mli", part->mli != NULL},
              {"interior", part->interior != NULL},
              {"interiors", part->interiors.count > 0}};
  for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++)
    if (keys[i].there)
      return um_model_fail(context, &part->at, keys[i].key,
                           "beside network, which says it all; accepted: one of the two");
  const struct um_scenario_group *group = part->groups.items;
  for (size_t i = 0; i < part->groups.count; i++)
    if (group[i].shell != NULL || group[i].mli != NULL)
      return um_model_fail(context, &group[i].at, group[i].shell != NULL ? "shell" : "mli",
                           "beside network, whose node '%s' says it; accepted: power_W, power_file",
                           group[i].name);
  return UM_OK;
}

/* Where a network stands. */
struct stated {
  const char *nodes, *conductors; /* conductors NULL: a file of ESATAN */
};

/* The line of a node, for what is wrong with its name. */
static enum um_status refuse_name(struct um_context *context, const struct stated *in,
                                  const char *name, const char *why)
{
  enum um_status status;
  struct um_core_csv *csv = NULL;
  size_t column = 0, row = 0;
  if (in->conductors == NULL)
    return um_core_fail(context, UM_ERR_INPUT, "%s: node '%.100s' %s", in->nodes, name, why);
  UM_CHECK(um_core_csv_read(context, in->nodes, &csv));
  UM_CHECK(um_core_csv_require(context, csv, "name", &column));
  while (row + 1 < um_core_csv_rows(csv) && strcmp(um_core_csv_text(csv, row, column), name) != 0)
    row++;
  status = um_core_csv_fail(context, csv, row, column, "'%.100s' %s", name, why);
done:
  um_core_csv_destroy(&csv);
  return status;
}

static enum um_status check_inside(struct um_context *context, const struct stated *in,
                                   const char *name)
{
  static const char *const taken[] = {"front", "back", "wall", "inside"};
  if (!um_model_name_is_plain(name))
    return refuse_name(
        context, in, name,
        "is no group of the part, and no name for a place inside; accepted: a group, "
        "GROUP.back, or a name without . / : , ; and quotes");
  for (size_t i = 0; i < sizeof taken / sizeof taken[0]; i++)
    if (strcmp(name, taken[i]) == 0)
      return refuse_name(context, in, name,
                         "is a side of the part; accepted: its groups, GROUP.back, other names");
  return UM_OK;
}

/* Every group has its node; a back without a radiating surface has none. */
static enum um_status check_groups(struct um_context *context, const struct um_model *model,
                                   const struct um_thermal_network *network,
                                   const struct stated *in, uint32_t part, bool *outside)
{
  const struct um_geometry *geometry = model->geometry;
  for (uint32_t g = 0; g < um_geometry_group_count(geometry); g++) {
    const struct um_geometry_group *group = um_geometry_group(geometry, g);
    if (group->part != part) continue;
    size_t front = um_thermal_body_group_node(geometry, network, g, false);
    size_t back = um_thermal_body_group_node(geometry, network, g, true);
    if (front == NONE)
      return um_core_fail(
          context, UM_ERR_INPUT,
          "%s: no node '%s', which is a group of the part '%s'; accepted: a node of "
          "the name of each group",
          in->nodes, group->name, um_geometry_part_name(geometry, part));
    outside[front] = true;
    if (back == NONE) continue;
    if (group->back_material == UM_GEOMETRY_NONE)
      return refuse_name(
          context, in, um_thermal_network_name(network, (uint32_t)back),
          "is the back of a group that has none; accepted: its front, which is both");
    outside[back] = true;
  }
  return UM_OK;
}

static enum um_status fill(struct um_context *context, struct um_model *model,
                           const struct stated *in, const bool *outside,
                           struct um_thermal_part_spec *to)
{
  const struct um_thermal_network *network = to->network;
  size_t n = um_thermal_network_nodes(network);
  UM_TRY(um_core_arena_allocate(context, &model->memory, n, sizeof *to->interior, &to->interior));
  to->ninterior = 0;
  for (uint32_t i = 0; i < n; i++) {
    if (outside[i]) continue;
    const char *name = um_thermal_network_name(network, i);
    double temperature = um_thermal_network_temperature(network, i);
    bool held = um_thermal_network_kind(network, i) == UM_NODE_BOUNDARY;
    UM_TRY(check_inside(context, in, name));
    if (!(temperature > 0.0))
      return refuse_name(context, in, name, "begins at 0 K; accepted: above 0 K");
    to->interior[to->ninterior++] =
        (struct um_thermal_interior_spec){.name = name,
                                          .capacity = um_thermal_network_capacity(network, i),
                                          .power = um_thermal_network_power(network, i),
                                          .start = temperature,
                                          .held = held ? temperature : 0.0};
  }
  return UM_OK;
}

enum um_status um_model_build_network(struct um_context *context, struct um_model *model,
                                      const struct um_scenario_part *part, uint32_t index,
                                      struct um_thermal_part_spec *to)
{
  enum um_status status;
  struct stated in = {NULL, NULL};
  bool *outside = NULL;
  UM_TRY(check_keys(context, part));
  UM_CHECK(um_model_resolve(context, model, &part->network->at, part->network->nodes, &in.nodes));
  if (part->network->conductors != NULL)
    UM_CHECK(um_model_resolve(context, model, &part->network->at, part->network->conductors,
                              &in.conductors));
  UM_CHECK(um_thermal_network_read(context, in.nodes, in.conductors, &to->network));
  to->kind = UM_THERMAL_NODES;
  UM_CHECK(
      um_core_allocate(context, um_thermal_network_nodes(to->network), sizeof *outside, &outside));
  UM_CHECK(check_groups(context, model, to->network, &in, index, outside));
  UM_CHECK(fill(context, model, &in, outside, to));
done:
  um_core_free(context, outside);
  return um_model_blame(context, &part->network->at, NULL, status);
}
