/* Exchange between patches from view factors, optics and loads; equations in exchange.h. */
#include "thermal/exchange.h"

#include <math.h>
#include <string.h>

#include "core/constants.h"
#include "core/interpolation.h"
#include "thermal/exchange_impl.h"
#include "thermal/network_impl.h"
#include "thermal/surface_reflectance_impl.h"

/* Of what a patch emits, in small exchange areas: below 10 mK at 300 K [1]; and in Newton's matrix,
 * whose iteration converges by so much a round. */
#define LEFT_OUT        1e-4
#define LEFT_OUT_STRONG 0.03

/* While it is made. */
struct maker {
  struct um_context *context;
  const struct um_thermal_network *network;
  const struct um_irradiation_loads *loads;
  const struct um_geometry_view_factor_table *table;
  double *emittance, *absorptance; /* [npatch] */
  double *reflectance;             /* [npatch] of the band in hand */
  double *b;                       /* [n][n] of pose, or room, and band in hand */
  size_t first, n;                 /* patches in hand */
  struct um_thermal_exchange *out;
};

static enum um_status sizes_check(const struct maker *m)
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
static enum um_status take_table(struct maker *m)
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

/* Means over the patches, by area, of what comes from all sides; surfaces that are not attached
 * reflect all. */
static enum um_status take_optics(struct maker *m)
{
  size_t n = m->out->npatch;
  UM_TRY(um_core_allocate(m->context, n, sizeof(double), &m->emittance));
  UM_TRY(um_core_allocate(m->context, n, sizeof(double), &m->absorptance));
  UM_TRY(um_core_allocate(m->context, n, sizeof(double), &m->reflectance));
  for (size_t s = 0; s < m->network->nsurface; s++) {
    uint32_t p = m->out->patch[s];
    if (p == UM_THERMAL_NO_PATCH || !m->network->attached[s]) continue;
    const struct um_thermal_surface *surface = &m->network->surface[s];
    m->emittance[p] += surface->emittance * surface->area / m->out->area[p];
    double hemispherical = surface->law != NULL ? surface->law->albedo : 1.0;
    m->absorptance[p] += surface->absorptance * hemispherical * surface->area / m->out->area[p];
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
static double reflected_of(const struct maker *m, enum load load, size_t row, size_t s)
{
  const struct um_irradiation_loads *loads = m->loads;
  size_t at = row * loads->nsurface + s;
  struct um_thermal_reflectances r = um_thermal_surface_reflectances(m->network, loads, row, s);
  if (load == SUN) return r.sun * (double)loads->sun[at];
  return load == ALBEDO ? r.albedo * (double)loads->albedo[at]
                        : r.planet * (double)loads->planet[at];
}

/* out[row] += w A^-1 B r E of one load, r E its mean over each patch. scratch [npatch]. */
static void reflect_row(const struct maker *m, size_t row, double weight, enum load load,
                        double *scratch, double *out)
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
static enum um_status reflect(struct maker *m, size_t pose, enum load load, double *out)
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

/* B of view factors whose patches stand from `first` on, which are then in hand. */
static enum um_status reflections_of(struct maker *m,
                                     const struct um_geometry_view_factors *factors, size_t first,
                                     const double *absorbed)
{
  m->first = first;
  m->n = factors->npatch;
  for (size_t p = 0; p < m->n; p++) m->reflectance[p] = 1.0 - absorbed[first + p];
  return um_thermal_reflections(m->context, factors, m->out->area + first, m->reflectance, m->b);
}

/* Of patches p and q of those in hand. */
static double area_between(const struct maker *m, size_t p, size_t q)
{
  return m->b[p * m->n + q] * (m->emittance[m->first + p] * m->emittance[m->first + q]);
}

/* Exchange areas of patch p below which all together are left_out of its emission [m^2]: the
 * largest of a few. */
static double small_of(const struct maker *m, double left_out, size_t p)
{
  double emitted = m->emittance[m->first + p] * m->out->area[m->first + p];
  for (double limit = 0.1 * emitted; limit > 1e-12 * emitted; limit *= 0.25) {
    double sum = 0.0;
    for (size_t q = 0; q < m->n; q++) {
      double g = area_between(m, p, q);
      if (q != p && g < limit) sum += g;
    }
    if (sum <= left_out * emitted) return limit;
  }
  return 0.0;
}

/* Row p of those in hand into `between`, or with between->other NULL only its end. small [n]. */
static void keep_row(const struct maker *m, const double *small, size_t p,
                     struct um_thermal_between *between)
{
  size_t row = m->first + p, at = between->begin[row], own = at;
  double rest = 0.0;
  for (size_t q = 0; q < m->n; q++) {
    double g = area_between(m, p, q);
    if (q != p && g < fmin(small[p], small[q])) {
      rest += g;
      continue;
    }
    if (q == p) own = at;
    if (between->other != NULL) {
      between->other[at] = (uint32_t)(m->first + q);
      between->area[at] = g;
    }
    at++;
  }
  if (between->other != NULL) between->area[own] += rest;
  between->begin[row + 1] = at;
}

/* Rows of eps B eps without what is small for both patches: that is taken to come back to where it
 * left, which keeps sums of rows and symmetry, and is nothing in a room of one temperature. */
static enum um_status keep_between(struct maker *m, double left_out,
                                   struct um_thermal_between *between)
{
  size_t all = m->first + m->n;
  double *small = m->reflectance; /* [n], free until the next band */
  for (size_t p = 0; p < m->n; p++) small[p] = small_of(m, left_out, p);
  if (between->begin == NULL) /* rows of a room's first patch begin where nothing is */
    UM_TRY(
        um_core_allocate(m->context, m->out->npatch + 1, sizeof *between->begin, &between->begin));
  uint32_t *other = between->other;
  between->other = NULL; /* ends first */
  for (size_t p = 0; p < m->n; p++) keep_row(m, small, p, between);
  between->other = other;
  size_t nentry = between->begin[all];
  UM_TRY(um_core_reallocate(m->context, nentry, sizeof *between->area, &between->area));
  UM_TRY(um_core_reallocate(m->context, nentry, sizeof *between->other, &between->other));
  for (size_t p = 0; p < m->n; p++) keep_row(m, small, p, between);
  return UM_OK;
}

static enum um_status make_infrared(struct maker *m, size_t pose)
{
  struct um_thermal_exchange *x = m->out;
  UM_TRY(reflections_of(m, m->table->pose[pose], 0, m->emittance));
  if (m->loads != NULL) UM_TRY(reflect(m, pose, PLANET, x->reflected.planet));
  UM_TRY(keep_between(m, LEFT_OUT, &x->between[pose]));
  return keep_between(m, LEFT_OUT_STRONG, &x->strong[pose]);
}

/* Rooms one after the other in the same rows: no sunlight, no Earth, no pose. */
static enum um_status make_inside(struct maker *m)
{
  struct um_thermal_exchange *x = m->out;
  for (size_t k = 0; k < m->table->nroom; k++) {
    const struct um_geometry_room *room = &m->table->room[k];
    UM_TRY(reflections_of(m, room->factors, room->first, m->emittance));
    UM_TRY(keep_between(m, LEFT_OUT, &x->between[x->npose]));
    UM_TRY(keep_between(m, LEFT_OUT_STRONG, &x->strong[x->npose]));
  }
  return UM_OK;
}

static enum um_status make_solar(struct maker *m, size_t pose)
{
  struct um_thermal_exchange *x = m->out;
  UM_TRY(reflections_of(m, m->table->pose[pose], 0, m->absorptance));
  UM_TRY(reflect(m, pose, SUN, x->reflected.sun));
  return reflect(m, pose, ALBEDO, x->reflected.albedo);
}

static enum um_status make(struct maker *m, const struct um_thermal_exchange_options *options)
{
  struct um_thermal_exchange *x = m->out;
  size_t ntime = m->loads != NULL ? m->loads->ntime : 0, n = m->table->patches->npatch;
  bool solar = options->solar && m->loads != NULL;
  UM_TRY(take_table(m));
  UM_TRY(take_optics(m));
  size_t largest = m->table->noutside; /* patches of the outside, or of a room */
  for (size_t k = 0; k < m->table->nroom; k++)
    if (m->table->room[k].factors->npatch > largest) largest = m->table->room[k].factors->npatch;
  UM_TRY(um_core_allocate(m->context, largest * largest, sizeof *m->b, &m->b));
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
    if (options->infrared) UM_TRY(make_infrared(m, pose));
    if (solar) UM_TRY(make_solar(m, pose));
  }
  if (options->infrared) UM_TRY(make_inside(m));
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
  struct maker m = {.context = context, .network = network, .loads = loads, .table = table};
  *out = NULL;
  if (table->patches->npatch == 0 || !(options->infrared || (options->solar && loads != NULL)))
    return UM_OK;
  UM_TRY(sizes_check(&m));
  UM_CHECK(um_core_allocate(context, 1, sizeof *m.out, &m.out));
  UM_CHECK(make(&m, options));
  *out = m.out;
  m.out = NULL;
done:
  um_core_free(context, m.emittance);
  um_core_free(context, m.absorptance);
  um_core_free(context, m.reflectance);
  um_core_free(context, m.b);
  um_thermal_exchange_destroy(context, &m.out);
  return status;
}

static void between_free(struct um_context *context, struct um_thermal_between *between,
                         size_t npose)
{
  for (size_t k = 0; k < npose && between != NULL; k++) {
    um_core_free(context, between[k].begin);
    um_core_free(context, between[k].other);
    um_core_free(context, between[k].area);
  }
  um_core_free(context, between);
}

void um_thermal_exchange_destroy(struct um_context *context, struct um_thermal_exchange **exchange)
{
  if (exchange == NULL || *exchange == NULL) return;
  struct um_thermal_exchange *x = *exchange;
  um_core_free(context, x->patch);
  um_core_free(context, x->area);
  between_free(context, x->between, x->npose + 1);
  between_free(context, x->strong, x->npose + 1);
  um_core_free(context, x->t);
  um_core_free(context, x->corner);
  um_core_free(context, x->weight);
  um_core_free(context, x->reflected.sun);
  um_core_free(context, x->reflected.albedo);
  um_core_free(context, x->reflected.planet);
  um_core_free(context, x);
  *exchange = NULL;
}

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

/* sum_q of a row. */
static double row_product(const struct um_thermal_between *between, size_t p, const double *x)
{
  double part[4] = {0.0, 0.0, 0.0, 0.0}; /* one strand would wait for itself */
  size_t e = between->begin[p], end = between->begin[p + 1];
  for (; e + 4 <= end; e += 4)
    for (size_t s = 0; s < 4; s++) part[s] += between->area[e + s] * x[between->other[e + s]];
  for (; e < end; e++) part[0] += between->area[e] * x[between->other[e]];
  return part[0] + part[1] + part[2] + part[3];
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
      sum += mix->weight[k] * row_product(&between[mix->pose[k]], p, x);
    heat[p] = UM_STEFAN_BOLTZMANN * sum;
  }
  for (size_t p = exchange->noutside; p < exchange->npatch; p++)
    heat[p] = UM_STEFAN_BOLTZMANN * row_product(&between[exchange->npose], p, x);
}
