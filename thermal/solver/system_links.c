/* Conductors and radiators merged into one symmetric list, rows per node, neighbours ascending;
 * what goes with temperature by its law. */
#include "thermal/solver/system_group.h"

#include <stdlib.h>

#include "base/core/constants.h"
#include "base/core/sort.h"

struct half_link {
  uint32_t node, other;
  uint32_t law;   /* UM_THERMAL_NO_LAW: none */
  uint32_t order; /* of addition: sums do not depend on the sort */
  double linear, fourth;
};

static int half_compare(const void *pa, const void *pb)
{
  const struct half_link *a = pa, *b = pb;
  if (a->node != b->node) return a->node < b->node ? -1 : 1;
  if (a->other != b->other) return a->other < b->other ? -1 : 1;
  if (a->law != b->law) return a->law < b->law ? -1 : 1;
  return (a->order > b->order) - (a->order < b->order);
}

/* Both directions of every link between nodes; returns their number. */
static size_t halves_list(const struct um_thermal_network *network, struct half_link *half)
{
  size_t count = 0;
  uint32_t order = 0;
  for (size_t k = 0; k < network->nconductor; k++, order++) {
    const struct um_thermal_link *l = &network->conductor[k];
    half[count++] = (struct half_link){l->a, l->b, l->law, order, l->value, 0.0};
    half[count++] = (struct half_link){l->b, l->a, l->law, order, l->value, 0.0};
  }
  for (size_t k = 0; k < network->nradiator; k++, order++) {
    const struct um_thermal_link *l = &network->radiator[k];
    if (l->b == UM_THERMAL_SPACE) continue;
    double fourth = UM_STEFAN_BOLTZMANN * l->value;
    half[count++] = (struct half_link){l->a, l->b, l->law, order, 0.0, fourth};
    half[count++] = (struct half_link){l->b, l->a, l->law, order, 0.0, fourth};
  }
  return count;
}

enum um_status um_thermal_system_links_build(struct um_thermal_system *system)
{
  enum um_status status;
  struct um_context *context = system->context;
  const struct um_thermal_network *network = system->network;
  struct half_link *half = NULL;
  size_t room = 2 * (network->nconductor + network->nradiator);
  if (room >= UINT32_MAX)
    return um_core_fail(context, UM_ERR_INPUT, "more than %lu thermal links",
                        (unsigned long)(UINT32_MAX / 2));
  UM_CHECK(um_core_allocate(context, room, sizeof *half, &half));
  size_t count = halves_list(network, half);
  UM_CHECK(um_core_sort(context, half, count, sizeof *half, half_compare));
  UM_CHECK(um_core_allocate(context, system->n + 1, sizeof(size_t), &system->start));
  UM_CHECK(um_core_allocate(context, count, sizeof(uint32_t), &system->other));
  UM_CHECK(um_core_allocate(context, count, sizeof(double), &system->linear));
  UM_CHECK(um_core_allocate(context, count, sizeof(double), &system->fourth));
  if (network->nlink_law > 0)
    UM_CHECK(um_core_allocate(context, count, sizeof *system->link_law, &system->link_law));
  size_t at = 0;
  for (size_t k = 0; k < count; k++) {
    bool same = k > 0 && half[k].node == half[k - 1].node && half[k].other == half[k - 1].other &&
                half[k].law == half[k - 1].law;
    if (!same && half[k].law != UM_THERMAL_NO_LAW)
      system->link_law[at] = &network->link_law[half[k].law];
    if (!same) {
      system->other[at++] = half[k].other;
      system->start[half[k].node + 1] = at;
    }
    system->linear[at - 1] += half[k].linear;
    system->fourth[at - 1] += half[k].fourth;
  }
  /* nodes without links end where the one before ends */
  for (size_t i = 0; i < system->n; i++)
    if (system->start[i + 1] < system->start[i]) system->start[i + 1] = system->start[i];
  status = UM_OK;
done:
  um_core_free(context, half);
  return status;
}
