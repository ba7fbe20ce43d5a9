/* Loads that patches send on to each other: by way of mirrors M, and scattered, in all orders,
 *
 *   H - E = M + A'^-1 B (r_d (E + M)) / (1 - rho),   A' = (1 - rho) A,
 *
 * E what falls in from outside, r_d scattered, rho mirrored. What falls in first is scattered and
 * mirrored by its own reflectance, at its angle and time, in the proportion r_d : rho. */
#include <math.h>
#include <omp.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/wide.h"
#include "thermal/exchange/exchange_group.h"
#include "thermal/exchange/exchange_maker_impl.h"

/* What is incident by way of mirrors, of the band in hand. */
struct mirrored_incident {
  double *set;     /* [sets of mirrored] weights of mirrors met by the Sun [1] */
  size_t *begin;   /* [noutside + 1] cells of the sky that a patch sees in mirrors */
  uint32_t *cell;  /* of the body's cube */
  double *per_sky; /* irradiance per radiance of the cell [sr] */
};

static void mirrored_incident_free(struct um_context *context, struct mirrored_incident *a)
{
  UM_FREE(context, a->set, a->begin, a->cell, a->per_sky);
}

/* Rays of patch p to the sky, those of a cell added up, each with what its mirrors send on. */
static size_t sky_take(const struct um_thermal_exchange_maker *m,
                       const struct um_geometry_mirror_paths *paths, const double *weight, size_t p,
                       size_t at, struct mirrored_incident *a)
{
  double unit = UM_PI / m->out->area[p];
  size_t first = at;
  for (size_t k = paths->sky_begin[p]; k < paths->sky_begin[p + 1]; k++) {
    const struct um_geometry_mirror_path *path = &paths->sky[k];
    if (at == first || a->cell[at - 1] != path->to) {
      a->cell[at] = path->to;
      a->per_sky[at++] = 0.0;
    }
    a->per_sky[at - 1] += unit * weight[path->sets] * path->area;
  }
  return at;
}

static enum um_status mirrored_incident_make(const struct um_thermal_exchange_maker *m, size_t pose,
                                             bool of_sun, struct mirrored_incident *a)
{
  enum um_status status = UM_OK;
  const struct um_geometry_mirror_paths *paths = m->table->mirrored[pose];
  double *weight = NULL;
  size_t n = m->table->noutside;
  if (of_sun) {
    const struct um_geometry_mirror_sets *sets = &m->mirrored->sets;
    UM_TRY(um_core_allocate(m->context, sets->n, sizeof *a->set, &a->set));
    for (size_t k = 0; k < sets->n; k++)
      a->set[k] = um_geometry_mirror_set_weight(&sets->set[k], m->of_class);
    return UM_OK;
  }
  UM_CHECK(um_core_allocate(m->context, n + 1, sizeof *a->begin, &a->begin));
  if (paths == NULL) return UM_OK;
  UM_CHECK(um_core_allocate(m->context, paths->sky_begin[n], sizeof *a->cell, &a->cell));
  UM_CHECK(um_core_allocate(m->context, paths->sky_begin[n], sizeof(double), &a->per_sky));
  UM_CHECK(um_core_allocate(m->context, paths->sets.n, sizeof *weight, &weight));
  for (size_t k = 0; k < paths->sets.n; k++)
    weight[k] = um_geometry_mirror_set_weight(&paths->sets.set[k], m->of_class);
  for (size_t p = 0; p < n; p++) a->begin[p + 1] = sky_take(m, paths, weight, p, a->begin[p], a);
done:
  um_core_free(m->context, weight);
  return status;
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

/* What surface s reflects of a load at a row, per area. */
static double reflected_of(const struct um_thermal_exchange_maker *m, enum um_thermal_load load,
                           size_t row, size_t s)
{
  const struct um_irradiation_loads *loads = m->loads;
  size_t at = row * loads->nsurface + s;
  const float *of = load == UM_THERMAL_SUN      ? loads->sun
                    : load == UM_THERMAL_ALBEDO ? loads->albedo
                                                : loads->planet;
  if (of[at] == 0.0f) return 0.0; /* turned away, or in shadow */
  return um_thermal_surface_reflectance(m->network, loads, m->aging, row, s, load) * (double)of[at];
}

/* Share of what patch p reflects that goes on as from a mirror. */
static double mirrored_share(const struct um_thermal_exchange_maker *m, size_t p)
{
  double scattered = (1.0 - m->mirror[p]) * (1.0 - m->absorbed[p]);
  return m->mirror[p] > 0.0 ? m->mirror[p] / (m->mirror[p] + fmax(scattered, 0.0)) : 0.0;
}

/* arriving[n] of the Sun by way of mirrors, per area, at a row; reflected[n]: by each patch. */
static void take_mirrored_sun(const struct um_thermal_exchange_maker *m,
                              const struct mirrored_incident *a, size_t row,
                              const double *reflected, double *arriving)
{
  const struct um_irradiation_mirrored *mirrored = m->mirrored;
  const double *area = m->out->area;
  memset(arriving, 0, m->n * sizeof *arriving);
  for (size_t k = mirrored->begin[row]; k < mirrored->begin[row + 1]; k++) {
    const struct um_irradiation_mirrored_sun *e = &mirrored->sun[k];
    arriving[e->to] += (double)e->share * a->set[e->sets] * mirrored_share(m, e->from) *
                       reflected[e->from] * area[e->from] / area[e->to];
  }
}

/* A row of the loads: out[row] += w M, and reflected[n] that is scattered, for spread_rows. false:
 * nothing shines. arriving[n]: by way of mirrors, of the Sun found here. */
static bool take_row(const struct um_thermal_exchange_maker *m, const struct mirrored_incident *a,
                     size_t row, double weight, enum um_thermal_load load, double *reflected,
                     double *arriving, double *out)
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
    reflected[p] = sum / patches->area[p];
    any = any || reflected[p] != 0.0;
  }
  if (!any) return false; /* then nothing shines on mirrors either */
  if (a != NULL && load == UM_THERMAL_SUN) take_mirrored_sun(m, a, row, reflected, arriving);
  for (size_t p = 0; p < n; p++) {
    reflected[p] /= 1.0 - m->mirror[p];
    if (a == NULL) continue; /* all is scattered */
    out[row * stride + p] += weight * arriving[p];
    reflected[p] *= 1.0 - mirrored_share(m, p);
    reflected[p] += (1.0 - m->absorbed[p]) * arriving[p];
  }
  return true;
}

/* Rows of the loads that go through B together. */
#define TOGETHER UM_THERMAL_TOGETHER
struct rows {
  size_t n, row[TOGETHER];
  double weight[TOGETHER];
  double *reflected; /* [noutside][TOGETHER], 0 behind n */
};

/* sum[TOGETHER]: of what cells of the sky send, times their weight. */
UM_WIDE_VECTORS static void sky_gather(const double *per_sky, const uint32_t *cell, size_t n,
                                       const double *sky, double *sum)
{
  for (size_t k = 0; k < TOGETHER; k++) sum[k] = 0.0;
  for (size_t e = 0; e < n; e++) {
    const double *of = sky + (size_t)cell[e] * TOGETHER;
    for (size_t k = 0; k < TOGETHER; k++) sum[k] += per_sky[e] * of[k];
  }
}

/* arriving[TOGETHER][noutside] of the Earth by way of mirrors, per area, at rows first, first + 1,
 * ..; sky: scratch [UM_GEOMETRY_SKY_CELLS][TOGETHER]. */
static void take_mirrored_sky(const struct um_thermal_exchange_maker *m,
                              const struct mirrored_incident *a, size_t first,
                              enum um_thermal_load load, double *sky, double *arriving)
{
  const float *table = load == UM_THERMAL_ALBEDO ? m->mirrored->albedo : m->mirrored->planet;
  size_t n = m->table->noutside;
  for (size_t k = 0; k < TOGETHER; k++)
    for (size_t c = 0; c < UM_GEOMETRY_SKY_CELLS; c++)
      sky[c * TOGETHER + k] = first + k < m->loads->ntime
                                  ? (double)table[(first + k) * UM_GEOMETRY_SKY_CELLS + c]
                                  : 0.0;
  for (size_t p = 0; p < n; p++) {
    double sum[TOGETHER];
    size_t begin = a->begin[p];
    sky_gather(a->per_sky + begin, a->cell + begin, a->begin[p + 1] - begin, sky, sum);
    for (size_t k = 0; k < TOGETHER; k++) arriving[k * n + p] = sum[k];
  }
}

/* out[row] += w A'^-1 B (scattered) of each; sums [noutside][TOGETHER]. */
static bool spread_rows(const struct um_thermal_exchange_maker *m, const struct rows *rows,
                        double *sums, double *scratch, double *out)
{
  size_t n = m->table->noutside, stride = m->table->patches->npatch;
  if (rows->n == 0) return true;
  if (!um_thermal_reflections_apply(m->reflections, rows->reflected, scratch, sums)) return false;
  for (size_t k = 0; k < rows->n; k++) {
    double *row = out + rows->row[k] * stride, weight = rows->weight[k];
    for (size_t p = 0; p < n; p++) row[p] += weight * sums[p * TOGETHER + k] / m->open[p];
  }
  return true;
}

/* Rows first, first + 1, .. of one load, TOGETHER of them at most. scratch: [SCRATCH noutside], the
 * sky, and what reflections want. false: they find no end. */
#define SCRATCH (3 * TOGETHER + 1)
static bool reflect_rows(const struct um_thermal_exchange_maker *m,
                         const struct mirrored_incident *a, size_t first, size_t pose,
                         enum um_thermal_load load, double *scratch, double *out)
{
  size_t n = m->table->noutside;
  struct rows rows = {.reflected = scratch};
  double *arriving = scratch + TOGETHER * n, *sums = arriving + TOGETHER * n,
         *reflected = sums + TOGETHER * n, *sky = reflected + n,
         *rest = sky + UM_GEOMETRY_SKY_CELLS * TOGETHER;
  memset(scratch, 0, TOGETHER * n * sizeof *scratch);
  if (a != NULL && load != UM_THERMAL_SUN) take_mirrored_sky(m, a, first, load, sky, arriving);
  for (size_t row = first; row < first + TOGETHER && row < m->loads->ntime; row++) {
    double weight = weight_of(m->out, row, pose);
    if (weight == 0.0 ||
        !take_row(m, a, row, weight, load, reflected, arriving + (row - first) * n, out))
      continue;
    for (size_t p = 0; p < n; p++) rows.reflected[p * TOGETHER + rows.n] = reflected[p];
    rows.row[rows.n] = row;
    rows.weight[rows.n++] = weight;
  }
  return spread_rows(m, &rows, sums, rest, out);
}

enum um_status um_thermal_exchange_reflect(struct um_thermal_exchange_maker *m, size_t pose,
                                           enum um_thermal_load load, double *out)
{
  enum um_status status;
  struct mirrored_incident incident = {0};
  double *scratch = NULL;
  size_t n = m->out->npatch, each = SCRATCH * n + UM_GEOMETRY_SKY_CELLS * TOGETHER +
                                    um_thermal_reflections_scratch(m->reflections);
  int threads = um_core_context_threads(m->context);
  bool mirrored = m->mirrored != NULL, ends = true;
  long nblock = (long)((m->loads->ntime + TOGETHER - 1) / TOGETHER);
  UM_CHECK(um_core_allocate(m->context, (size_t)threads * each, sizeof *scratch, &scratch));
  if (mirrored) UM_CHECK(mirrored_incident_make(m, pose, load == UM_THERMAL_SUN, &incident));
#pragma omp parallel for schedule(static) num_threads(threads) reduction(&& : ends)
  for (long k = 0; k < nblock; k++)
    if (!um_core_stopped(m->context))
      ends = reflect_rows(m, mirrored ? &incident : NULL, TOGETHER * (size_t)k, pose, load,
                          scratch + (size_t)omp_get_thread_num() * each, out) &&
             ends;
  UM_CHECK(um_core_stop_check(m->context, "reflected loads were added up"));
  if (!ends) status = um_thermal_reflections_fail(m->context);
done:
  mirrored_incident_free(m->context, &incident);
  um_core_free(m->context, scratch);
  return status;
}
