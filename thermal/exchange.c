/* Exchange between patches from view factors, optics and loads; equations in exchange.h. */
#include "thermal/exchange.h"

#include <math.h>
#include <string.h>

#include "thermal/exchange_impl.h"
#include "thermal/exchange_maker_impl.h"
#include "thermal/network_impl.h"
#include "thermal/surface_aging_impl.h"
#include "thermal/surface_reflectance_impl.h"

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

/* Weight of a pose at a row of the loads. */
static double weight_of(const struct um_thermal_exchange *x, size_t row, size_t pose)
{
  double sum = 0.0;
  size_t at = x->ntime > 1 ? row * x->ncorner : 0;
  for (size_t c = 0; c < x->ncorner; c++)
    if (x->corner[at + c] == pose) sum += x->weight[at + c];
  return sum;
}

/* The loads that are reflected. */
enum load { SUN, ALBEDO, PLANET };

/* What surface s reflects of a load at a row, per area. */
static double reflected_of(const struct um_thermal_exchange_maker *m, enum load load, size_t row,
                           size_t s)
{
  const struct um_irradiation_loads *loads = m->loads;
  size_t at = row * loads->nsurface + s;
  struct um_thermal_reflectances r =
      um_thermal_surface_reflectances(m->network, loads, m->aging, row, s);
  if (load == SUN) return r.sun * (double)loads->sun[at];
  return load == ALBEDO ? r.albedo * (double)loads->albedo[at]
                        : r.planet * (double)loads->planet[at];
}

/* out[row] += w A^-1 B r E of one load, r E its mean over each patch. scratch [npatch]. */
static void reflect_row(const struct um_thermal_exchange_maker *m, size_t row, double weight,
                        enum load load, double *scratch, double *out)
{
  const struct um_geometry_patches *patches = m->table->patches;
  size_t n = m->table->noutside, stride = patches->npatch;
  bool any = false;
  for (size_t p = 0; p < n; p++) {
    double sum = 0.0;
    for (size_t i = patches->begin[p]; i < patches->begin[p + 1]; i++) {
      uint32_t s = patches->surface[i];
      if (s < m->network->nsurface && m->network->attached[s])
        sum += m->network->surface[s].area * reflected_of(m, load, row, s);
    }
    scratch[p] = sum / patches->area[p];
    any = any || scratch[p] != 0.0;
  }
  for (size_t p = 0; any && p < n; p++) {
    const double *b = m->b + p * n;
    double sum = 0.0;
    for (size_t q = 0; q < n; q++) sum += b[q] * scratch[q];
    out[row * stride + p] += weight * sum / patches->area[p];
  }
}

/* What the pose in hand adds to the reflected load of all rows. */
static enum um_status reflect(struct um_thermal_exchange_maker *m, size_t pose, enum load load,
                              double *out)
{
  double *scratch = NULL;
  size_t n = m->out->npatch;
  int threads = um_core_context_threads(m->context);
  UM_TRY(um_core_allocate(m->context, m->loads->ntime * n, sizeof *scratch, &scratch));
  long ntime = (long)m->loads->ntime;
#pragma omp parallel for schedule(static) num_threads(threads)
  for (long k = 0; k < ntime; k++) {
    size_t row = (size_t)k;
    double weight = weight_of(m->out, row, pose);
    if (weight != 0.0) reflect_row(m, row, weight, load, scratch + row * n, out);
  }
  um_core_free(m->context, scratch);
  return um_core_stop_check(m->context, "reflected loads were added up");
}

/* After make_infrared of that pose: where the Earth's infrared meets the same numbers B stands. */
static enum um_status make_planet(struct um_thermal_exchange_maker *m, size_t pose)
{
  size_t n = m->table->noutside;
  if (n > 0 && memcmp(m->planet, m->emittance, n * sizeof *m->planet) != 0)
    UM_TRY(um_thermal_exchange_make_reflections(m, m->table->pose[pose], 0, m->planet));
  else /* keep_between took what it is made of */
    m->n = n;
  return reflect(m, pose, PLANET, m->out->reflected.planet);
}

static enum um_status make_solar(struct um_thermal_exchange_maker *m, size_t pose)
{
  struct um_thermal_exchange *x = m->out;
  UM_TRY(um_thermal_exchange_make_reflections(m, m->table->pose[pose], 0, m->absorptance));
  UM_TRY(reflect(m, pose, SUN, x->reflected.sun));
  return reflect(m, pose, ALBEDO, x->reflected.albedo);
}

static enum um_status make(struct um_thermal_exchange_maker *m,
                           const struct um_thermal_exchange_options *options)
{
  struct um_thermal_exchange *x = m->out;
  size_t ntime = m->loads != NULL ? m->loads->ntime : 0, n = m->table->patches->npatch;
  bool solar = options->solar && m->loads != NULL;
  UM_TRY(take_table(m));
  if (options->like != NULL && options->like->arriving != NULL &&
      options->like->nsurface == x->nsurface)
    UM_TRY(
        copy(m->context, options->like->arriving, x->nsurface, sizeof *x->arriving, &x->arriving));
  m->arriving = x->arriving;
  UM_TRY(um_core_allocate(m->context, x->nsurface, sizeof *x->emittance, &x->emittance));
  UM_TRY(um_thermal_exchange_maker_create(m));
  UM_TRY(take_optics(m));
  struct um_thermal_reflected *r = &x->reflected;
  if (options->infrared) {
    UM_TRY(um_core_allocate(m->context, x->npose + 1, sizeof *x->between, &x->between));
    UM_TRY(um_core_allocate(m->context, x->npose + 1, sizeof *x->strong, &x->strong));
    if (ntime > 0) UM_TRY(um_core_allocate(m->context, ntime * n, sizeof(double), &r->planet));
  }
  if (solar) {
    UM_TRY(um_core_allocate(m->context, ntime * n, sizeof(double), &r->sun));
    UM_TRY(um_core_allocate(m->context, ntime * n, sizeof(double), &r->albedo));
  }
  for (size_t pose = 0; pose < x->npose; pose++) {
    if (options->infrared) UM_TRY(um_thermal_exchange_make_infrared(m, pose));
    if (options->infrared && ntime > 0) UM_TRY(make_planet(m, pose));
    if (solar) UM_TRY(make_solar(m, pose));
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
  *out = NULL;
  if (table->patches->npatch == 0 || !(options->infrared || (options->solar && loads != NULL)))
    return UM_OK;
  UM_TRY(sizes_check(&m));
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
  um_core_free(context, x->patch);
  um_core_free(context, x->area);
  um_thermal_between_clear(context, x->between, x->npose + 1);
  um_thermal_between_clear(context, x->strong, x->npose + 1);
  um_core_free(context, x->between);
  um_core_free(context, x->strong);
  um_core_free(context, x->arriving);
  um_core_free(context, x->emittance);
  um_core_free(context, x->t);
  um_core_free(context, x->corner);
  um_core_free(context, x->weight);
  um_core_free(context, x->reflected.sun);
  um_core_free(context, x->reflected.albedo);
  um_core_free(context, x->reflected.planet);
  um_core_free(context, x);
  *exchange = NULL;
}
