/* What patches absorb of each other's emission, and that anew for temperatures that are known. */
#include <math.h>
#include <string.h>

#include "thermal/exchange/exchange_group.h"
#include "thermal/exchange/exchange_maker_impl.h"
#include "thermal/network/network_group.h"
#include "thermal/network/surface_aging_group.h"

/* What infrared of the satellite itself meets at surface s, once it is known what arrives there. */
static double emittance_of(const struct um_thermal_exchange_maker *m, size_t s)
{
  const struct um_thermal_surface *surface = &m->network->surface[s];
  double slope, aged = surface->inside ? 1.0 : um_thermal_aged_emittance(m->aging, 0, s);
  if (m->arriving == NULL) return surface->emittance * aged;
  return surface->emittance * aged *
         um_thermal_surface_law_emittance(surface->law, m->arriving[s], &slope);
}

/* Means over the patches, by area, of what comes from all sides; surfaces that are not attached
 * reflect all. */
void um_thermal_exchange_take_emittances(struct um_thermal_exchange_maker *m, double *of_surface)
{
  memset(m->emittance, 0, m->out->npatch * sizeof *m->emittance);
  for (size_t s = 0; s < m->network->nsurface; s++) {
    uint32_t p = m->out->patch[s];
    of_surface[s] = m->network->attached[s] ? emittance_of(m, s) : 0.0;
    if (p != UM_THERMAL_NO_PATCH && m->network->attached[s])
      m->emittance[p] += of_surface[s] * m->network->surface[s].area / m->out->area[p];
  }
}

/* Room for what both bands need. */
enum um_status um_thermal_exchange_maker_create(struct um_thermal_exchange_maker *m)
{
  size_t n = m->out->npatch;
  double **const of_patch[5] = {&m->emittance, &m->reflectance, &m->absorbed, &m->mirror, &m->open};
  for (int k = 0; k < 5; k++) UM_TRY(um_core_allocate(m->context, n, sizeof(double), of_patch[k]));
  size_t nclass = m->table->mirrors != NULL ? m->table->mirrors->nclass : 0;
  return um_core_allocate(m->context, nclass, sizeof *m->of_class, &m->of_class);
}

enum um_status um_thermal_exchange_make_infrared(struct um_thermal_exchange_maker *m, size_t pose)
{
  struct um_thermal_exchange *x = m->out;
  UM_TRY(um_thermal_exchange_make_pose(m, pose, m->emittance, m->lobe_infrared));
  UM_TRY(um_thermal_exchange_keep(m, &x->between[pose], &x->strong[pose]));
  UM_TRY(um_thermal_between_block(m->context, m->n, &x->between[pose]));
  return um_thermal_between_block(m->context, m->n, &x->strong[pose]);
}

/* Rooms one after the other in the same rows: no sunlight, no Earth, no pose. */
enum um_status um_thermal_exchange_make_inside(struct um_thermal_exchange_maker *m)
{
  struct um_thermal_exchange *x = m->out;
  for (size_t k = 0; k < m->table->nroom; k++) {
    const struct um_geometry_room *room = &m->table->room[k];
    UM_TRY(um_thermal_exchange_make_reflections(m, room->factors, room->first, m->emittance));
    UM_TRY(um_thermal_exchange_keep(m, &x->between[x->npose], &x->strong[x->npose]));
  }
  return UM_OK;
}

void um_thermal_exchange_maker_destroy(struct um_thermal_exchange_maker *m)
{
  UM_FREE(m->context, m->emittance, m->planet, m->absorptance, m->reflectance, m->absorbed,
          m->mirror, m->of_class, m->open);
  um_thermal_reflections_destroy(m->context, &m->reflections);
  um_geometry_view_factors_destroy(m->context, &m->mirrored_factors);
}

void um_thermal_between_clear(struct um_context *context, struct um_thermal_between *between,
                              size_t npose)
{
  for (size_t k = 0; k < npose && between != NULL; k++) {
    UM_FREE(context, between[k].begin, between[k].other, between[k].area, between[k].first,
            between[k].at, between[k].value, between[k].own);
    between[k] = (struct um_thermal_between){0};
  }
}

/* Largest relative change of an emittance of the outside [1]. */
static double change_of(const struct um_thermal_exchange_maker *m, const double *of_surface)
{
  double largest = 0.0;
  for (size_t s = 0; s < m->network->noutside; s++) {
    double before = m->out->emittance[s];
    if (m->out->patch[s] != UM_THERMAL_NO_PATCH && before > 0.0)
      largest = fmax(largest, fabs(of_surface[s] / before - 1.0));
  }
  return largest;
}

enum um_status um_thermal_exchange_renew(struct um_context *context,
                                         const struct um_thermal_network *network,
                                         const struct um_geometry_view_factor_table *table,
                                         const struct um_thermal_aging *aging,
                                         const double *temperature, double tolerance,
                                         struct um_thermal_exchange *exchange, double *change)
{
  enum um_status status;
  struct um_thermal_exchange_maker m = {
      .context = context, .network = network, .table = table, .aging = aging, .out = exchange};
  double *arriving = NULL, *of_surface = NULL;
  *change = 0.0;
  if (exchange == NULL || exchange->between == NULL) return UM_OK;
  UM_CHECK(um_core_allocate(context, exchange->nsurface, sizeof *arriving, &arriving));
  UM_CHECK(um_core_allocate(context, exchange->nsurface, sizeof *of_surface, &of_surface));
  UM_CHECK(um_thermal_exchange_arriving(context, exchange, network, temperature, arriving));
  UM_CHECK(um_thermal_exchange_maker_create(&m));
  m.arriving = arriving;
  m.lobe_infrared = exchange->lobe;
  um_thermal_exchange_take_emittances(&m, of_surface);
  *change = change_of(&m, of_surface);
  if (!(*change > tolerance)) goto done;
  UM_FREE(context, exchange->arriving, exchange->emittance);
  exchange->arriving = arriving;
  exchange->emittance = of_surface;
  arriving = of_surface = NULL;
  um_thermal_between_clear(context, exchange->between, exchange->npose);
  um_thermal_between_clear(context, exchange->strong, exchange->npose);
  for (size_t pose = 0; pose < exchange->npose; pose++)
    UM_CHECK(um_thermal_exchange_make_infrared(&m, pose));
done:
  UM_FREE(context, arriving, of_surface);
  um_thermal_exchange_maker_destroy(&m);
  return status;
}
