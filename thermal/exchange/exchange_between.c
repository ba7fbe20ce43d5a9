/* What patches absorb of each other's emission, and that anew for temperatures that are known. */
#include <math.h>
#include <string.h>

#include "thermal/exchange/exchange_group.h"
#include "thermal/exchange/exchange_maker_impl.h"
#include "thermal/network/network_group.h"
#include "thermal/network/surface_aging_group.h"

/* Of what a patch emits, in small exchange areas: below 10 mK at 300 K [1]; and in Newton's matrix,
 * whose iteration converges by so much a round. */
#define LEFT_OUT        1e-4
#define LEFT_OUT_STRONG 0.03

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
  size_t n = m->out->npatch, largest = m->table->noutside; /* of the outside, or of a room */
  for (size_t k = 0; k < m->table->nroom; k++)
    if (m->table->room[k].factors->npatch > largest) largest = m->table->room[k].factors->npatch;
  double **const of_patch[5] = {&m->emittance, &m->reflectance, &m->absorbed, &m->mirror, &m->open};
  for (int k = 0; k < 5; k++) UM_TRY(um_core_allocate(m->context, n, sizeof(double), of_patch[k]));
  size_t nclass = m->table->mirrors != NULL ? m->table->mirrors->nclass : 0;
  UM_TRY(um_core_allocate(m->context, nclass, sizeof *m->of_class, &m->of_class));
  return um_core_allocate(m->context, largest * largest, sizeof *m->b, &m->b);
}

/* Of patches p and q of those in hand. */
static double area_between(const struct um_thermal_exchange_maker *m, size_t p, size_t q)
{
  return m->b[p * m->n + q] * (m->absorbed[p] * m->absorbed[q]);
}

/* Exchange areas of patch p below which all together are left_out of its emission [m^2]: the
 * largest of a few. */
static double small_of(const struct um_thermal_exchange_maker *m, double left_out, size_t p)
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
static void keep_row(const struct um_thermal_exchange_maker *m, const double *small, size_t p,
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
static enum um_status keep_between(struct um_thermal_exchange_maker *m, double left_out,
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

enum um_status um_thermal_exchange_make_infrared(struct um_thermal_exchange_maker *m, size_t pose)
{
  struct um_thermal_exchange *x = m->out;
  UM_TRY(um_thermal_exchange_make_pose(m, pose, m->emittance, m->lobe_infrared));
  UM_TRY(keep_between(m, LEFT_OUT, &x->between[pose]));
  return keep_between(m, LEFT_OUT_STRONG, &x->strong[pose]);
}

/* Rooms one after the other in the same rows: no sunlight, no Earth, no pose. */
enum um_status um_thermal_exchange_make_inside(struct um_thermal_exchange_maker *m)
{
  struct um_thermal_exchange *x = m->out;
  for (size_t k = 0; k < m->table->nroom; k++) {
    const struct um_geometry_room *room = &m->table->room[k];
    UM_TRY(um_thermal_exchange_make_reflections(m, room->factors, room->first, m->emittance));
    UM_TRY(keep_between(m, LEFT_OUT, &x->between[x->npose]));
    UM_TRY(keep_between(m, LEFT_OUT_STRONG, &x->strong[x->npose]));
  }
  return UM_OK;
}

void um_thermal_exchange_maker_destroy(struct um_thermal_exchange_maker *m)
{
  UM_FREE(m->context, m->emittance, m->planet, m->absorptance, m->reflectance, m->absorbed,
          m->mirror, m->of_class, m->open, m->b);
}

void um_thermal_between_clear(struct um_context *context, struct um_thermal_between *between,
                              size_t npose)
{
  for (size_t k = 0; k < npose && between != NULL; k++) {
    UM_FREE(context, between[k].begin, between[k].other, between[k].area);
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
