/* A node model from two tables in place of a mesh, or from one file .d of ESATAN
 * (thermal/network/esatan.c):
 *
 *   nodes.csv       name,kind,capacity_J_K,T0_K,power_W     kind diffusive, arithmetic or boundary
 *   conductors.csv  kind,a,b,value                          GL [W/K] or GR [m2]; GR also to `space`
 *
 * An empty capacity or power is 0; a diffusive node needs a capacity. */
#include <stdlib.h>
#include <string.h>

#include "base/core/csv.h"
#include "base/core/file.h"
#include "base/core/sort.h"
#include "base/core/suggestions.h"
#include "thermal/network/esatan_impl.h"
#include "thermal/network/network_group.h"

#define ESATAN_BYTES ((size_t)64 << 20) /* most of a file .d */

/* Column or 0 when the field is empty. */
static enum um_status number_or_zero(struct um_context *context, const struct um_core_csv *csv,
                                     size_t row, size_t column, double *out)
{
  *out = 0.0;
  if (um_core_csv_text(csv, row, column)[0] == '\0') return UM_OK;
  return um_core_csv_number(context, csv, row, column, out);
}

struct node_columns {
  size_t name, kind, capacity, temperature, power;
};

static enum um_status kind_read(struct um_context *context, const struct um_core_csv *csv,
                                size_t row, size_t column, enum um_thermal_node_kind *out)
{
  static const char *const words[3] = {"diffusive", "arithmetic", "boundary"};
  const char *text = um_core_csv_text(csv, row, column);
  for (int k = 0; k < 3; k++)
    if (strcmp(text, words[k]) == 0) {
      *out = (enum um_thermal_node_kind)k;
      return UM_OK;
    }
  return um_core_csv_fail(context, csv, row, column,
                          "'%s'; accepted: diffusive, arithmetic, boundary", text);
}

static enum um_status node_read(struct um_context *context, const struct um_core_csv *csv,
                                size_t row, const struct node_columns *at,
                                struct um_thermal_network *network)
{
  const char *name = um_core_csv_text(csv, row, at->name);
  enum um_thermal_node_kind kind = UM_NODE_DIFFUSIVE;
  double capacity, temperature, power;
  if (name[0] == '\0' || strcmp(name, "space") == 0)
    return um_core_csv_fail(context, csv, row, at->name, "'%s'; accepted: a name other than space",
                            name);
  if (!um_core_name_is_safe_behind(name))
    return um_core_csv_fail(context, csv, row, at->name,
                            "'%.100s'; accepted: " UM_CORE_NAME_ACCEPTED_BEHIND, name);
  UM_TRY(kind_read(context, csv, row, at->kind, &kind));
  UM_TRY(number_or_zero(context, csv, row, at->capacity, &capacity));
  UM_TRY(um_core_csv_number(context, csv, row, at->temperature, &temperature));
  UM_TRY(number_or_zero(context, csv, row, at->power, &power));
  if (kind == UM_NODE_DIFFUSIVE && !(capacity > 0.0))
    return um_core_csv_fail(context, csv, row, at->capacity,
                            "%g J/K; accepted: more than 0 for a diffusive node", capacity);
  if (kind == UM_NODE_ARITHMETIC && capacity != 0.0)
    return um_core_csv_fail(context, csv, row, at->capacity,
                            "%g J/K; accepted: 0 or empty for an arithmetic node", capacity);
  if (!(capacity >= 0.0))
    return um_core_csv_fail(context, csv, row, at->capacity, "%g J/K; accepted: 0 or more",
                            capacity);
  if (!(temperature >= 0.0))
    return um_core_csv_fail(context, csv, row, at->temperature, "%g K; accepted: 0 or more",
                            temperature);
  uint32_t index;
  return um_thermal_network_node_add(network, name, kind, capacity, temperature, power, &index);
}

static enum um_status nodes_read(struct um_context *context, const struct um_core_csv *csv,
                                 struct um_thermal_network *network)
{
  struct node_columns at;
  UM_TRY(um_core_csv_require(context, csv, "name", &at.name));
  UM_TRY(um_core_csv_require(context, csv, "kind", &at.kind));
  UM_TRY(um_core_csv_require(context, csv, "capacity_J_K", &at.capacity));
  UM_TRY(um_core_csv_require(context, csv, "T0_K", &at.temperature));
  UM_TRY(um_core_csv_require(context, csv, "power_W", &at.power));
  for (size_t row = 0; row < um_core_csv_rows(csv); row++)
    UM_TRY(node_read(context, csv, row, &at, network));
  return UM_OK;
}

/* Names sorted, to find nodes of large models fast. */
struct entry {
  const char *name;
  uint32_t node;
};
static int entry_compare(const void *a, const void *b)
{
  return strcmp(((const struct entry *)a)->name, ((const struct entry *)b)->name);
}

static enum um_status index_build(struct um_context *context, const struct um_core_csv *nodes,
                                  const struct um_thermal_network *network, struct entry **out)
{
  size_t n = network->nnode;
  UM_TRY(um_core_allocate(context, n, sizeof **out, out));
  for (size_t i = 0; i < n; i++) (*out)[i] = (struct entry){network->node[i].name, (uint32_t)i};
  UM_TRY(um_core_sort(context, *out, n, sizeof **out, entry_compare));
  for (size_t i = 1; i < n; i++)
    if (strcmp((*out)[i].name, (*out)[i - 1].name) == 0)
      return um_core_fail(context, UM_ERR_INPUT,
                          "%s: node '%s' stands there twice; accepted: names used once",
                          um_core_csv_name(nodes), (*out)[i].name);
  return UM_OK;
}

struct link_columns {
  size_t kind, a, b, value;
};

static enum um_status end_find(struct um_context *context, const struct um_core_csv *csv,
                               size_t row, size_t column, const struct um_thermal_network *network,
                               const struct entry *index, uint32_t *out)
{
  struct entry wanted = {um_core_csv_text(csv, row, column), 0};
  *out = UM_THERMAL_SPACE;
  if (strcmp(wanted.name, "space") == 0) return UM_OK;
  const struct entry *found = bsearch(&wanted, index, network->nnode, sizeof *index, entry_compare);
  if (found == NULL)
    return um_core_csv_fail(context, csv, row, column,
                            "'%s' is not a node; accepted: a name of the node table or space",
                            wanted.name);
  *out = found->node;
  return UM_OK;
}

static enum um_status link_read(struct um_context *context, const struct um_core_csv *csv,
                                size_t row, const struct link_columns *at,
                                struct um_thermal_network *network, const struct entry *index)
{
  const char *kind = um_core_csv_text(csv, row, at->kind);
  bool linear = strcmp(kind, "GL") == 0;
  uint32_t a, b;
  double value;
  if (!linear && strcmp(kind, "GR") != 0)
    return um_core_csv_fail(context, csv, row, at->kind, "'%s'; accepted: GL (W/K), GR (m2)", kind);
  UM_TRY(end_find(context, csv, row, at->a, network, index, &a));
  UM_TRY(end_find(context, csv, row, at->b, network, index, &b));
  UM_TRY(um_core_csv_number(context, csv, row, at->value, &value));
  if (!(value >= 0.0))
    return um_core_csv_fail(context, csv, row, at->value, "%g %s; accepted: 0 or more", value,
                            linear ? "W/K" : "m2");
  if (a == UM_THERMAL_SPACE) {
    a = b;
    b = UM_THERMAL_SPACE;
  }
  if (a == b)
    return um_core_csv_fail(context, csv, row, at->b, "the same as a; accepted: another node");
  if (linear && b == UM_THERMAL_SPACE)
    return um_core_csv_fail(context, csv, row, at->kind,
                            "GL to space; accepted: GR (heat leaves to space by radiation)");
  if (linear) return um_thermal_network_conductor_add(network, a, b, value);
  return um_thermal_network_radiator_add(network, a, b, value);
}

static enum um_status links_read(struct um_context *context, const struct um_core_csv *csv,
                                 struct um_thermal_network *network, const struct entry *index)
{
  struct link_columns at;
  UM_TRY(um_core_csv_require(context, csv, "kind", &at.kind));
  UM_TRY(um_core_csv_require(context, csv, "a", &at.a));
  UM_TRY(um_core_csv_require(context, csv, "b", &at.b));
  UM_TRY(um_core_csv_require(context, csv, "value", &at.value));
  for (size_t row = 0; row < um_core_csv_rows(csv); row++)
    UM_TRY(link_read(context, csv, row, &at, network, index));
  return UM_OK;
}

static enum um_status tables_read(struct um_context *context, const char *nodes_csv,
                                  const char *conductors_csv, struct um_thermal_network **out)
{
  enum um_status status;
  struct um_core_csv *nodes = NULL, *links = NULL;
  struct um_thermal_network *network = NULL;
  struct entry *index = NULL;
  *out = NULL;
  UM_CHECK(um_core_csv_read(context, nodes_csv, &nodes));
  UM_CHECK(um_core_csv_read(context, conductors_csv, &links));
  UM_CHECK(um_thermal_network_create(context, &network));
  UM_CHECK(nodes_read(context, nodes, network));
  UM_CHECK(index_build(context, nodes, network, &index));
  UM_CHECK(links_read(context, links, network, index));
  *out = network;
  network = NULL;
done:
  um_core_free(context, index);
  um_thermal_network_destroy(&network);
  um_core_csv_destroy(&links);
  um_core_csv_destroy(&nodes);
  return status;
}

enum um_status um_thermal_network_read(struct um_context *context, const char *nodes,
                                       const char *conductors, struct um_thermal_network **out)
{
  enum um_status status;
  char *text = NULL;
  size_t length = 0;
  *out = NULL;
  UM_CHECK(um_core_file_read(context, nodes, ESATAN_BYTES, &text, &length));
  bool esatan = um_thermal_esatan_is(text);
  if (esatan && conductors != NULL)
    status = um_core_fail(context, UM_ERR_INPUT,
                          "%s: this is a network of ESATAN, which has its conductors; accepted: no "
                          "conductors beside it",
                          nodes);
  else if (esatan)
    status = um_thermal_esatan_read(context, nodes, text, out);
  else if (conductors == NULL)
    status = um_core_fail(context, UM_ERR_INPUT,
                          "%s: a table of nodes wants a table of conductors; accepted: conductors "
                          "beside it, or a file .d of ESATAN, which begins with $MODEL",
                          nodes);
  else
    status = tables_read(context, nodes, conductors, out);
done:
  um_core_free(context, text);
  return status;
}
