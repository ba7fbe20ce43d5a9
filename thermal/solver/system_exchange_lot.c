/* The tangent of the exchange for UM_THERMAL_LOT answers side by side: what is read of the areas
 * between patches serves all of them (system_exchange.c has the equation). */
#include <string.h>

#include "base/core/wide.h"
#include "thermal/solver/system_group.h"

#define LOT UM_THERMAL_LOT

enum um_status um_thermal_system_exchange_reserve_lot(struct um_thermal_system *system)
{
  struct um_thermal_system_exchange *x = system->exchange;
  struct um_context *context = system->context;
  if (x->lot != NULL) return UM_OK;
  UM_TRY(um_core_allocate(context, x->exchange->npatch, sizeof *x->lot_power4, &x->lot_power4));
  UM_TRY(um_core_allocate(context, x->exchange->npatch, sizeof *x->lot_heat, &x->lot_heat));
  return um_core_allocate(context, system->n, sizeof *x->lot, &x->lot);
}

/* Means over patches [first, end) of what nodes have. */
UM_WIDE_VECTORS static void means(const struct um_thermal_system_exchange *x, size_t first,
                                  size_t end, const double (*of)[LOT], double (*out)[LOT])
{
  for (size_t p = first; p < end; p++) {
    double sum[LOT] = {0.0};
    for (size_t e = x->patch_start[p]; e < x->patch_start[p + 1]; e++) {
      const double *node = of[x->patch_node[e]];
      for (size_t k = 0; k < LOT; k++) sum[k] += x->patch_share[e] * node[k];
    }
    memcpy(out[p], sum, sizeof sum);
  }
}

/* of[n] = slope times the warming of the unknowns, 0 of the other nodes. */
static void warm(const struct um_thermal_system *system, const double *slope,
                 const double (*x)[LOT], double (*of)[LOT])
{
  memset(of, 0, system->n * sizeof *of);
  for (size_t j = 0; j < system->nunknown; j++) {
    size_t i = system->node[j];
    double factor = slope[i] * um_thermal_system_warming(system, i);
    for (size_t k = 0; k < LOT; k++) of[i][k] = factor * x[j][k];
  }
}

/* What unknowns receive. */
UM_WIDE_VECTORS static void pass_on(const struct um_thermal_system *system, double factor,
                                    const double (*heat)[LOT], double (*out)[LOT])
{
  const struct um_thermal_system_exchange *x = system->exchange;
  for (size_t j = 0; j < system->nunknown; j++) {
    size_t i = system->node[j];
    double by = factor / system->capacity[i], sum[LOT] = {0.0};
    for (size_t e = x->start[i]; e < x->start[i + 1]; e++)
      for (size_t k = 0; k < LOT; k++) sum[k] += x->share[e] * heat[x->patch[e]][k];
    for (size_t k = 0; k < LOT; k++) out[j][k] += by * sum[k];
  }
}

/* One by one: eliminated nodes follow each in rounds of its own. */
static void one_by_one(struct um_thermal_system *system, double factor, const double (*x)[LOT],
                       double (*out)[LOT])
{
  size_t n = system->nunknown;
  double *own = &system->exchange->lot[0][0], *made = own + n; /* [n] each, of LOT that there are */
  for (size_t k = 0; k < LOT; k++) {
    for (size_t j = 0; j < n; j++) own[j] = x[j][k];
    memset(made, 0, n * sizeof *made);
    um_thermal_system_exchange_tangent(system, factor, own, made);
    for (size_t j = 0; j < n; j++) out[j][k] += made[j];
  }
}

void um_thermal_system_exchange_tangent_lot(struct um_thermal_system *system, double factor,
                                            const double (*x)[LOT], double (*out)[LOT])
{
  struct um_thermal_system_exchange *own = system->exchange;
  const struct um_thermal_exchange *exchange = own->exchange;
  if (system->ncluster > 0) {
    one_by_one(system, factor, x, out);
    return;
  }
  warm(system, own->slope, x, own->lot);
  means(own, 0, exchange->noutside, (const double(*)[LOT])own->lot, own->lot_power4);
  if (own->slope_inside != NULL) {
    warm(system, own->slope_inside, x, own->lot);
    means(own, exchange->noutside, exchange->npatch, (const double(*)[LOT])own->lot,
          own->lot_power4);
  }
  um_thermal_exchange_apply_lot(exchange, own->strong ? exchange->strong : exchange->between,
                                &own->held, (const double(*)[LOT])own->lot_power4, own->lot_heat);
  pass_on(system, factor, (const double(*)[LOT])own->lot_heat, out);
}
