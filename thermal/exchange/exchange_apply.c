/* What patches receive of each other's emission, and how warm it is. */
#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/interpolation.h"
#include "thermal/exchange/exchange_group.h"
#include "thermal/network/network_group.h"

double um_thermal_exchange_area(const struct um_thermal_exchange *exchange, size_t pose, size_t p,
                                size_t q)
{
  if (exchange->between == NULL) return NAN;
  if (p >= exchange->noutside) pose = exchange->npose;
  const struct um_thermal_between *between = &exchange->between[pose];
  for (size_t e = between->begin[p]; e < between->begin[p + 1]; e++)
    if (between->other[e] == q) return between->area[e];
  return 0.0;
}

struct um_thermal_exchange_row um_thermal_exchange_row(const struct um_thermal_exchange *exchange,
                                                       size_t pose, size_t p)
{
  const struct um_thermal_between *between =
      &exchange->between[p >= exchange->noutside ? exchange->npose : pose];
  size_t begin = between->begin[p];
  return (struct um_thermal_exchange_row){between->begin[p + 1] - begin, between->other + begin,
                                          between->area + begin};
}

static void mix_add(const struct um_thermal_exchange *x, size_t row, double weight,
                    struct um_thermal_mix *mix)
{
  for (size_t c = 0; c < x->ncorner; c++) {
    double w = weight * x->weight[row * x->ncorner + c];
    if (!(w > 0.0)) continue;
    size_t k = 0;
    while (k < mix->n && mix->pose[k] != x->corner[row * x->ncorner + c]) k++;
    if (k == mix->n) {
      mix->pose[mix->n] = x->corner[row * x->ncorner + c];
      mix->weight[mix->n++] = 0.0;
    }
    mix->weight[k] += w;
  }
}

void um_thermal_exchange_mix(const struct um_thermal_exchange *exchange, double t,
                             struct um_thermal_mix *mix)
{
  mix->n = 0;
  if (exchange->npose == 1) {
    *mix = (struct um_thermal_mix){.n = 1, .pose = {0}, .weight = {1.0}};
    return;
  }
  size_t last = exchange->ntime - 1;
  size_t k = last > 0 ? um_core_interval_find(exchange->t, exchange->ntime, t) : 0;
  size_t next = k < last ? k + 1 : k;
  double width = exchange->t[next] - exchange->t[k];
  double u = width > 0.0 ? (t - exchange->t[k]) / width : 0.0;
  u = u < 0.0 ? 0.0 : u > 1.0 ? 1.0 : u;
  mix_add(exchange, k, 1.0 - u, mix);
  mix_add(exchange, next, u, mix);
}

void um_thermal_exchange_apply(const struct um_thermal_exchange *exchange,
                               const struct um_thermal_between *between,
                               const struct um_thermal_mix *mix, int threads, const double *x,
                               double *heat)
{
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
  for (size_t p = 0; p < exchange->noutside; p++) {
    double sum = 0.0;
    for (size_t k = 0; k < mix->n; k++)
      sum += mix->weight[k] * um_thermal_between_row(&between[mix->pose[k]], p, x);
    heat[p] = UM_STEFAN_BOLTZMANN * sum;
  }
  for (size_t p = exchange->noutside; p < exchange->npatch; p++)
    heat[p] = UM_STEFAN_BOLTZMANN * um_thermal_between_row(&between[exchange->npose], p, x);
}

void um_thermal_exchange_apply_lot(const struct um_thermal_exchange *exchange,
                                   const struct um_thermal_between *between,
                                   const struct um_thermal_mix *mix,
                                   const double (*x)[UM_THERMAL_LOT],
                                   double (*heat)[UM_THERMAL_LOT])
{
  for (size_t p = 0; p < exchange->npatch; p++) {
    memset(heat[p], 0, sizeof heat[p]);
    if (p >= exchange->noutside)
      um_thermal_between_row_lot(&between[exchange->npose], p, UM_STEFAN_BOLTZMANN, x, heat[p]);
    for (size_t k = 0; k < mix->n && p < exchange->noutside; k++)
      um_thermal_between_row_lot(&between[mix->pose[k]], p, UM_STEFAN_BOLTZMANN * mix->weight[k], x,
                                 heat[p]);
  }
}

/* T^4 of a surface [K^4]. */
static double power4_of(const struct um_thermal_surface *surface, const double *temperature)
{
  double sum = 0.0;
  for (int k = 0; k < 3; k++)
    if (surface->node[k] != UM_THERMAL_SPACE)
      sum += surface->weight[k] * pow(temperature[surface->node[k]], 4);
  return sum;
}

/* What patch p receives, over the poses: sum_q (eps B eps)_pq x_q. */
static double received_by(const struct um_thermal_exchange *x, size_t p, const double *of_patch)
{
  if (p >= x->noutside) return um_thermal_between_row(&x->between[x->npose], p, of_patch);
  double sum = 0.0;
  for (size_t k = 0; k < x->npose; k++) sum += um_thermal_between_row(&x->between[k], p, of_patch);
  return sum;
}

enum um_status um_thermal_exchange_arriving(struct um_context *context,
                                            const struct um_thermal_exchange *exchange,
                                            const struct um_thermal_network *network,
                                            const double *temperature, double *arriving)
{
  size_t n = exchange->npatch;
  double *work = NULL;
  UM_TRY(um_core_allocate(context, 3 * n, sizeof *work, &work));
  double *power4 = work, *one = work + n, *mean = work + 2 * n;
  for (size_t s = 0; s < network->nsurface; s++) {
    uint32_t p = exchange->patch[s];
    if (p != UM_THERMAL_NO_PATCH && network->attached[s])
      power4[p] += network->surface[s].area / exchange->area[p] *
                   power4_of(&network->surface[s], temperature);
  }
  for (size_t p = 0; p < n; p++) one[p] = 1.0;
  for (size_t p = 0; p < n; p++) {
    double weight = received_by(exchange, p, one);
    mean[p] = weight > 0.0 ? received_by(exchange, p, power4) / weight : NAN;
  }
  for (size_t s = 0; s < network->nsurface; s++) {
    uint32_t p = exchange->patch[s];
    if (!network->attached[s]) continue;
    double own = power4_of(&network->surface[s], temperature);
    arriving[s] = pow(p != UM_THERMAL_NO_PATCH && mean[p] >= 0.0 ? mean[p] : own, 0.25);
  }
  um_core_free(context, work);
  return UM_OK;
}
