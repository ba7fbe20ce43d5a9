/* What of a network goes with temperature: the laws of its links and capacities. */
#include <assert.h>
#include <math.h>
#include <string.h>

#include "thermal/network/network_group.h"

static enum um_status ratio_check(struct um_context *context, const char *of,
                                  const struct um_thermal_ratio *ratio)
{
  for (size_t k = 0; k < UM_THERMAL_LAW_TEMPERATURES; k++)
    if (!(ratio->at[k] > 0.0) || !isfinite(ratio->at[k]))
      return um_core_fail(context, UM_ERR_INPUT,
                          "%s law: ratio %g at %g K; accepted: finite, more than 0", of,
                          ratio->at[k], (double)k * UM_THERMAL_LAW_STEP);
  return UM_OK;
}

static bool ratios_equal(const struct um_thermal_ratio *a, const struct um_thermal_ratio *b)
{
  if (a == NULL || b == NULL) return a == b;
  for (size_t k = 0; k < UM_THERMAL_LAW_TEMPERATURES; k++)
    if (a->at[k] != b->at[k]) return false;
  return true;
}

static bool link_laws_equal(const struct um_thermal_link_law *a,
                            const struct um_thermal_link_law *b)
{
  if (a->power != b->power || !ratios_equal(a->table, b->table)) return false;
  for (int k = 0; k < UM_THERMAL_LAW_TERMS; k++)
    if (a->factor[k] != b->factor[k] || a->exponent[k] != b->exponent[k]) return false;
  return true;
}

static enum um_status ratio_copy(struct um_context *context, const struct um_thermal_ratio *from,
                                 struct um_thermal_ratio **to)
{
  UM_TRY(um_core_allocate(context, 1, sizeof **to, to));
  **to = *from;
  return UM_OK;
}

enum um_status um_thermal_network_link_law_add(struct um_thermal_network *network,
                                               const struct um_thermal_link_law *law,
                                               uint32_t *index)
{
  struct um_context *context = network->context;
  bool good = law->power >= 1.0 && isfinite(law->power);
  for (int k = 0; k < UM_THERMAL_LAW_TERMS; k++)
    good = good && law->factor[k] >= 0.0 && isfinite(law->factor[k]) && isfinite(law->exponent[k]);
  if (!good)
    return um_core_fail(context, UM_ERR_INPUT,
                        "link law: power %g, factors %g and %g, exponents %g and %g; accepted: "
                        "finite, power 1 or more, factors 0 or more",
                        law->power, law->factor[0], law->factor[1], law->exponent[0],
                        law->exponent[1]);
  if (law->table != NULL) UM_TRY(ratio_check(context, "link", law->table));
  for (*index = 0; *index < network->nlink_law; ++*index)
    if (link_laws_equal(&network->link_law[*index], law)) return UM_OK;
  UM_TRY(um_core_reallocate(context, network->nlink_law + 1, sizeof *network->link_law,
                            &network->link_law));
  UM_TRY(um_core_reallocate(context, network->nlink_law + 1, sizeof *network->link_table,
                            &network->link_table));
  struct um_thermal_ratio *table = NULL;
  if (law->table != NULL) UM_TRY(ratio_copy(context, law->table, &table));
  network->link_table[network->nlink_law] = table;
  network->link_law[network->nlink_law] = *law;
  network->link_law[network->nlink_law++].table = table;
  return UM_OK;
}

enum um_status um_thermal_network_capacity_law_add(struct um_thermal_network *network,
                                                   const struct um_thermal_ratio *ratio,
                                                   uint32_t *index)
{
  UM_TRY(ratio_check(network->context, "capacity", ratio));
  for (*index = 0; *index < network->ncapacity_law; ++*index)
    if (ratios_equal(network->capacity_law[*index], ratio)) return UM_OK;
  UM_TRY(um_core_reallocate(network->context, network->ncapacity_law + 1,
                            sizeof *network->capacity_law, &network->capacity_law));
  UM_TRY(ratio_copy(network->context, ratio, &network->capacity_law[network->ncapacity_law]));
  network->ncapacity_law++;
  return UM_OK;
}

void um_thermal_network_conductor_follow(struct um_thermal_network *network, uint32_t law)
{
  assert(network->nconductor > 0 && law < network->nlink_law);
  network->conductor[network->nconductor - 1].law = law;
}

void um_thermal_network_radiator_follow(struct um_thermal_network *network, uint32_t law)
{
  assert(network->nradiator > 0 && law < network->nlink_law);
  network->radiator[network->nradiator - 1].law = law;
}

enum um_status um_thermal_network_capacity_follow(struct um_thermal_network *network, uint32_t node,
                                                  double capacity, uint32_t law)
{
  char label[96];
  bool known = node < network->nnode && law < network->ncapacity_law;
  if (!known || network->node[node].kind != UM_NODE_DIFFUSIVE || !(capacity >= 0.0) ||
      !isfinite(capacity))
    return um_core_fail(network->context, UM_ERR_INPUT,
                        "%s: %g J/K by temperature; accepted: finite, 0 or more, of a diffusive "
                        "node",
                        um_thermal_network_label(network, node, label, sizeof label), capacity);
  UM_TRY(um_thermal_network_grow(network->context, &network->store, network->nstore,
                                 &network->store_room, sizeof *network->store));
  network->store[network->nstore++] = (struct um_thermal_store){node, law, capacity};
  return UM_OK;
}

void um_thermal_network_laws_free(struct um_thermal_network *network)
{
  struct um_context *context = network->context;
  for (size_t k = 0; k < network->nlink_law; k++) um_core_free(context, network->link_table[k]);
  for (size_t k = 0; k < network->ncapacity_law; k++)
    um_core_free(context, network->capacity_law[k]);
  UM_FREE(context, network->link_law, network->link_table, network->capacity_law, network->store);
}

bool um_thermal_network_laws_equal(const struct um_thermal_network *a,
                                   const struct um_thermal_network *b)
{
  if (a->nlink_law != b->nlink_law || a->ncapacity_law != b->ncapacity_law ||
      a->nstore != b->nstore)
    return false;
  for (size_t k = 0; k < a->nlink_law; k++)
    if (!link_laws_equal(&a->link_law[k], &b->link_law[k])) return false;
  for (size_t k = 0; k < a->ncapacity_law; k++)
    if (!ratios_equal(a->capacity_law[k], b->capacity_law[k])) return false;
  for (size_t k = 0; k < a->nstore; k++) {
    const struct um_thermal_store *x = &a->store[k], *y = &b->store[k];
    if (x->node != y->node || x->law != y->law || x->capacity != y->capacity) return false;
  }
  return true;
}
