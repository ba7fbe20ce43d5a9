/* Exchange between patches from view factors, optics and loads; equations in exchange.h. */
#include "thermal/exchange/exchange.h"

#include <string.h>

#include "thermal/exchange/exchange_group.h"
#include "thermal/exchange/exchange_maker_impl.h"
#include "thermal/network/network_group.h"
#include "thermal/network/surface_aging_group.h"

static enum um_status mirrored_check(const struct um_thermal_exchange_maker *m)
{
  if (m->mirrored == NULL || (m->loads != NULL && m->loads->ntime == m->mirrored->ntime))
    return UM_OK;
  return um_core_fail(m->context, UM_ERR_INPUT,
                      "mirrored sunlight at %zu times for loads at %zu; accepted: as many",
                      m->mirrored->ntime, m->loads != NULL ? m->loads->ntime : 0);
}

static enum um_status sizes_check(const struct um_thermal_exchange_maker *m)
{
  const struct um_geometry_view_factor_table *table = m->table;
  size_t nsurface = table->patches->nsurface, outside = m->network->noutside;
  bool few = m->loads != NULL && m->loads->nsurface < table->nsurface;
  if (outside > nsurface || few || (table->nroom > 0 && m->network->nsurface > nsurface))
    return um_core_fail(m->context, UM_ERR_INPUT,
                        "exchange between %zu surfaces, of a network with %zu and loads of %zu; "
                        "accepted: as many",
                        nsurface, outside, m->loads != NULL ? m->loads->nsurface : 0);
  if (table->ntime == 1 || (m->loads != NULL && m->loads->ntime == table->ntime)) return UM_OK;
  return um_core_fail(m->context, UM_ERR_INPUT,
                      "view factors at %zu times for loads at %zu; accepted: as many, or 1",
                      table->ntime, m->loads != NULL ? m->loads->ntime : 0);
}

static enum um_status copy(struct um_context *context, const void *from, size_t count, size_t size,
                           void *out)
{
  UM_TRY(um_core_allocate(context, count, size, out));
  if (count > 0) memcpy(*(void **)out, from, count * size);
  return UM_OK;
}

/* Patches and poses as the table has them. */
static enum um_status take_table(struct um_thermal_exchange_maker *m)
{
  const struct um_geometry_view_factor_table *table = m->table;
  struct um_thermal_exchange *x = m->out;
  size_t given = table->patches->nsurface;
  x->nsurface = m->network->nsurface > given ? m->network->nsurface : given;
  x->npatch = table->patches->npatch;
  x->noutside = table->noutside;
  x->npose = table->npose;
  x->ntime = table->ntime;
  x->ncorner = table->ncorner;
  size_t n = x->ntime * x->ncorner;
  UM_TRY(um_core_allocate(m->context, x->nsurface, sizeof *x->patch, &x->patch));
  memset(x->patch, 0xff, x->nsurface * sizeof *x->patch);
  if (given > 0) memcpy(x->patch, table->patches->patch, given * sizeof *x->patch);
  UM_TRY(copy(m->context, table->patches->area, x->npatch, sizeof *x->area, &x->area));
  UM_TRY(copy(m->context, table->corner, n, sizeof *x->corner, &x->corner));
  UM_TRY(copy(m->context, table->weight, n, sizeof *x->weight, &x->weight));
  if (m->loads != NULL && x->ntime > 1)
    UM_TRY(copy(m->context, m->loads->t, x->ntime, sizeof *x->t, &x->t));
  return UM_OK;
}

static enum um_status take_optics(struct um_thermal_exchange_maker *m)
{
  size_t n = m->out->npatch;
  UM_TRY(um_core_allocate(m->context, n, sizeof(double), &m->planet));
  UM_TRY(um_core_allocate(m->context, n, sizeof(double), &m->absorptance));
  um_thermal_exchange_take_emittances(m, m->out->emittance);
  for (size_t s = 0; s < m->network->nsurface; s++) {
    uint32_t p = m->out->patch[s];
    if (p == UM_THERMAL_NO_PATCH || !m->network->attached[s]) continue;
    const struct um_thermal_surface *surface = &m->network->surface[s];
    double share = surface->area / m->out->area[p];
    double absorptance = um_thermal_aged_absorptance(m->network, m->aging, 0, s);
    double planet = surface->emittance * um_thermal_aged_emittance(m->aging, 0, s);
    m->planet[p] += share * planet * (surface->law != NULL ? surface->law->planet : 1.0);
    m->absorptance[p] += share * absorptance * (surface->law != NULL ? surface->law->albedo : 1.0);
  }
  return UM_OK;
}

/* After make_infrared of that pose: where the Earth's infrared meets the same numbers B stands. */
static enum um_status make_planet(struct um_thermal_exchange_maker *m, size_t pose)
{
  size_t n = m->table->noutside;
  if (n > 0 && memcmp(m->planet, m->emittance, n * sizeof *m->planet) != 0)
    UM_TRY(um_thermal_exchange_make_pose(m, pose, m->planet, m->lobe_infrared));
  else /* keep_between took what it is made of */
    m->n = n;
  return um_thermal_exchange_reflect(m, pose, UM_THERMAL_PLANET, m->out->reflected.planet);
}

static enum um_status make_solar(struct um_thermal_exchange_maker *m, size_t pose)
{
  struct um_thermal_exchange *x = m->out;
  UM_TRY(um_thermal_exchange_make_pose(m, pose, m->absorptance, m->lobe_solar));
  UM_TRY(um_thermal_exchange_reflect(m, pose, UM_THERMAL_SUN, x->reflected.sun));
  return um_thermal_exchange_reflect(m, pose, UM_THERMAL_ALBEDO, x->reflected.albedo);
}

static enum um_status make(struct um_thermal_exchange_maker *m,
                           const struct um_thermal_exchange_options *options)
{
  struct um_thermal_exchange *x = m->out;
  size_t ntime = m->loads != NULL ? m->loads->ntime : 0, n = m->table->patches->npatch;
  bool solar = options->solar && m->loads != NULL;
  const struct um_thermal_reflected *like =
      options->like_sunlight && options->like->reflected.sun != NULL ? &options->like->reflected
                                                                     : NULL;
  UM_TRY(take_table(m));
  if (options->like != NULL && options->like->arriving != NULL &&
      options->like->nsurface == x->nsurface)
    UM_TRY(
        copy(m->context, options->like->arriving, x->nsurface, sizeof *x->arriving, &x->arriving));
  m->arriving = x->arriving;
  UM_TRY(um_core_allocate(m->context, x->nsurface, sizeof *x->emittance, &x->emittance));
  if (options->infrared && m->lobe_infrared != NULL) {
    UM_TRY(
        copy(m->context, m->lobe_infrared, m->table->mirrors->nclass, sizeof *x->lobe, &x->lobe));
    m->lobe_infrared = x->lobe;
  }
  UM_TRY(um_thermal_exchange_maker_create(m));
  UM_TRY(take_optics(m));
  struct um_thermal_reflected *r = &x->reflected;
  if (options->infrared) {
    UM_TRY(um_core_allocate(m->context, x->npose + 1, sizeof *x->between, &x->between));
    UM_TRY(um_core_allocate(m->context, x->npose + 1, sizeof *x->strong, &x->strong));
    if (ntime > 0) UM_TRY(um_core_allocate(m->context, ntime * n, sizeof(double), &r->planet));
  }
  if (solar && like != NULL) {
    UM_TRY(copy(m->context, like->sun, ntime * n, sizeof(double), &r->sun));
    UM_TRY(copy(m->context, like->albedo, ntime * n, sizeof(double), &r->albedo));
  } else if (solar) {
    UM_TRY(um_core_allocate(m->context, ntime * n, sizeof(double), &r->sun));
    UM_TRY(um_core_allocate(m->context, ntime * n, sizeof(double), &r->albedo));
  }
  for (size_t pose = 0; pose < x->npose; pose++) {
    if (options->infrared) UM_TRY(um_thermal_exchange_make_infrared(m, pose));
    if (options->infrared && ntime > 0) UM_TRY(make_planet(m, pose));
    if (solar && like == NULL) UM_TRY(make_solar(m, pose));
  }
  if (options->infrared) UM_TRY(um_thermal_exchange_make_inside(m));
  return UM_OK;
}

enum um_status um_thermal_exchange_create(struct um_context *context,
                                          const struct um_thermal_network *network,
                                          const struct um_irradiation_loads *loads,
                                          const struct um_geometry_view_factor_table *table,
                                          const struct um_thermal_exchange_options *options,
                                          struct um_thermal_exchange **out)
{
  enum um_status status;
  struct um_thermal_exchange_maker m = {.context = context,
                                        .network = network,
                                        .loads = loads,
                                        .table = table,
                                        .aging = options->aging};
  if (options->lobes != NULL && table->mirrors != NULL) {
    m.lobe_solar = options->lobes->solar;
    m.lobe_infrared = options->lobes->infrared;
    m.mirrored = options->mirrored;
  }
  *out = NULL;
  if (table->patches->npatch == 0 || !(options->infrared || (options->solar && loads != NULL)))
    return UM_OK;
  UM_TRY(sizes_check(&m));
  UM_TRY(mirrored_check(&m));
  UM_CHECK(um_core_allocate(context, 1, sizeof *m.out, &m.out));
  UM_CHECK(make(&m, options));
  *out = m.out;
  m.out = NULL;
done:
  um_thermal_exchange_maker_destroy(&m);
  um_thermal_exchange_destroy(context, &m.out);
  return status;
}

void um_thermal_exchange_destroy(struct um_context *context, struct um_thermal_exchange **exchange)
{
  if (exchange == NULL || *exchange == NULL) return;
  struct um_thermal_exchange *x = *exchange;
  UM_FREE(context, x->patch, x->area);
  um_thermal_between_clear(context, x->between, x->npose + 1);
  um_thermal_between_clear(context, x->strong, x->npose + 1);
  UM_FREE(context, x->between, x->strong, x->arriving, x->lobe, x->emittance, x->t, x->corner,
          x->weight, x->reflected.sun, x->reflected.albedo, x->reflected.planet, x);
  *exchange = NULL;
}
