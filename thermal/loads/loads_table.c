/* Storage of a table of incident loads; loads.c fills it by rays. */
#include <string.h>

#include "base/core/interpolation.h"
#include "thermal/loads/loads_impl.h"

enum um_status um_irradiation_loads_create(struct um_context *context, size_t ntime,
                                           size_t nsurface, size_t nedge,
                                           struct um_irradiation_loads **out)
{
  enum um_status status;
  struct um_irradiation_loads *loads = NULL;
  *out = NULL;
  if (ntime == 0)
    return um_core_fail(context, UM_ERR_INPUT,
                        "a table of loads without times; accepted: 1 or more");
  if (nsurface != 0 && ntime > (size_t)-1 / sizeof(float) / 2 / nsurface)
    return um_core_fail(context, UM_ERR_MEMORY, "out of memory: loads of %zu surfaces at %zu times",
                        nsurface, ntime);
  UM_CHECK(um_core_allocate(context, 1, sizeof *loads, &loads));
  loads->ntime = ntime;
  loads->nsurface = nsurface;
  loads->nedge = nedge;
  UM_CHECK(um_core_allocate(context, ntime, sizeof(double), &loads->t));
  UM_CHECK(um_core_allocate(context, ntime, sizeof(double), &loads->sunlit));
  UM_CHECK(um_core_allocate(context, ntime, sizeof(double), &loads->irradiance));
  UM_CHECK(um_core_allocate(context, ntime * nsurface, sizeof(float), &loads->sun));
  UM_CHECK(um_core_allocate(context, ntime * nsurface, sizeof(float), &loads->incidence));
  UM_CHECK(um_core_allocate(context, ntime * nsurface, sizeof(float), &loads->albedo));
  UM_CHECK(um_core_allocate(context, ntime * nsurface, sizeof(float), &loads->planet));
  UM_CHECK(um_core_allocate(context, ntime * nsurface, sizeof(float), &loads->view_factor));
  UM_CHECK(um_core_allocate(context, nedge, sizeof(double), &loads->edge));
  *out = loads;
  return UM_OK;
done:
  um_irradiation_loads_destroy(context, &loads);
  return status;
}

struct um_irradiation_row um_irradiation_row_of(const struct um_irradiation_loads *l, size_t k)
{
  size_t at = k * l->nsurface, moments = at * UM_ANGULAR_MOMENTS;
  return (struct um_irradiation_row){l->sun + at,
                                     l->incidence + at,
                                     l->albedo + at,
                                     l->planet + at,
                                     l->view_factor + at,
                                     l->brightness != NULL ? l->brightness + at : NULL,
                                     l->gas != NULL ? l->gas + at : NULL,
                                     l->albedo_moments != NULL ? l->albedo_moments + moments : NULL,
                                     l->planet_moments != NULL ? l->planet_moments + moments
                                                               : NULL};
}

/* Columns that not every table has, of those that `from` has. */
static enum um_status columns_like(struct um_context *context,
                                   const struct um_irradiation_loads *from,
                                   struct um_irradiation_loads *l)
{
  const struct {
    const float *from;
    float **to;
    size_t width;
  } column[] = {{from->brightness, &l->brightness, 1},
                {from->gas, &l->gas, 1},
                {from->by_cosine, &l->by_cosine, UM_IRRADIATION_COSINES},
                {from->albedo_moments, &l->albedo_moments, UM_ANGULAR_MOMENTS},
                {from->planet_moments, &l->planet_moments, UM_ANGULAR_MOMENTS}};
  for (size_t i = 0; i < sizeof column / sizeof *column; i++)
    if (column[i].from != NULL)
      UM_TRY(um_core_allocate(context, l->ntime * l->nsurface, column[i].width * sizeof(float),
                              column[i].to));
  return UM_OK;
}

/* Row k of `to`, u of the way from row `low` of `from` to row `high`. */
static void row_between(const struct um_irradiation_loads *from, size_t low, size_t high, double u,
                        const struct um_irradiation_loads *to, size_t k)
{
  enum { COLUMNS = 9 };
  const struct um_irradiation_loads *const table[3] = {from, from, to};
  const size_t row[3] = {low, high, k};
  float *column[3][COLUMNS];
  for (int i = 0; i < 3; i++) {
    struct um_irradiation_row r = um_irradiation_row_of(table[i], row[i]);
    float *const of[COLUMNS] = {r.sun,    r.incidence,      r.albedo,
                                r.planet, r.view_factor,    r.brightness,
                                r.gas,    r.albedo_moments, r.planet_moments};
    for (int c = 0; c < COLUMNS; c++) column[i][c] = of[c];
  }
  for (int c = 0; c < COLUMNS; c++) {
    size_t n = to->nsurface * (c < COLUMNS - 2 ? 1 : UM_ANGULAR_MOMENTS);
    for (size_t s = 0; column[2][c] != NULL && s < n; s++)
      column[2][c][s] = (float)((1.0 - u) * (double)column[0][c][s] + u * (double)column[1][c][s]);
  }
}

enum um_status um_irradiation_loads_between(struct um_context *context,
                                            const struct um_irradiation_loads *loads,
                                            const double *times, size_t n,
                                            struct um_irradiation_loads **out)
{
  struct um_irradiation_loads *l = NULL;
  *out = NULL;
  UM_TRY(um_irradiation_loads_create(context, n, loads->nsurface, 0, &l));
  enum um_status status = columns_like(context, loads, l);
  for (size_t k = 0; k < n && status == UM_OK; k++) {
    size_t low = loads->ntime > 1 ? um_core_interval_find(loads->t, loads->ntime, times[k]) : 0;
    size_t high = low + 1 < loads->ntime ? low + 1 : low;
    double width = loads->t[high] - loads->t[low];
    double u = width > 0.0 ? (times[k] - loads->t[low]) / width : 0.0;
    u = u < 0.0 ? 0.0 : u > 1.0 ? 1.0 : u;
    l->t[k] = times[k];
    l->sunlit[k] = (1.0 - u) * loads->sunlit[low] + u * loads->sunlit[high];
    l->irradiance[k] = (1.0 - u) * loads->irradiance[low] + u * loads->irradiance[high];
    row_between(loads, low, high, u, l, k);
  }
  if (status != UM_OK) um_irradiation_loads_destroy(context, &l);
  *out = l;
  return status;
}

static void scale(const float *from, double by, size_t n, float *to)
{
  for (size_t i = 0; to != NULL && i < n; i++) to[i] = (float)((double)from[i] * by);
}

enum um_status um_irradiation_loads_scaled(struct um_context *context,
                                           const struct um_irradiation_loads *loads,
                                           const struct um_irradiation_levels *by,
                                           struct um_irradiation_loads **out)
{
  struct um_irradiation_loads *l = NULL;
  size_t n = loads->ntime * loads->nsurface;
  *out = NULL;
  UM_TRY(um_irradiation_loads_create(context, loads->ntime, loads->nsurface, loads->nedge, &l));
  enum um_status status = columns_like(context, loads, l);
  if (status != UM_OK) {
    um_irradiation_loads_destroy(context, &l);
    return status;
  }
  memcpy(l->t, loads->t, l->ntime * sizeof *l->t);
  memcpy(l->sunlit, loads->sunlit, l->ntime * sizeof *l->sunlit);
  if (l->nedge > 0) memcpy(l->edge, loads->edge, l->nedge * sizeof *l->edge);
  for (size_t k = 0; k < l->ntime; k++) l->irradiance[k] = loads->irradiance[k] * by->irradiance;
  scale(loads->sun, 1.0, n, l->sun);
  scale(loads->incidence, 1.0, n, l->incidence);
  scale(loads->by_cosine, 1.0, n * UM_IRRADIATION_COSINES, l->by_cosine);
  scale(loads->view_factor, 1.0, n, l->view_factor);
  scale(loads->brightness, 1.0, n, l->brightness);
  scale(loads->gas, 1.0, n, l->gas);
  scale(loads->albedo, by->albedo, n, l->albedo);
  scale(loads->planet, by->planet, n, l->planet);
  scale(loads->albedo_moments, by->albedo, n * UM_ANGULAR_MOMENTS, l->albedo_moments);
  scale(loads->planet_moments, by->planet, n * UM_ANGULAR_MOMENTS, l->planet_moments);
  *out = l;
  return UM_OK;
}

void um_irradiation_loads_destroy(struct um_context *context, struct um_irradiation_loads **loads)
{
  if (loads == NULL || *loads == NULL) return;
  struct um_irradiation_loads *l = *loads;
  UM_FREE(context, l->t, l->sunlit, l->irradiance, l->sun, l->incidence, l->by_cosine, l->albedo,
          l->planet, l->view_factor, l->brightness, l->gas, l->albedo_moments, l->planet_moments,
          l->edge, l);
  *loads = NULL;
}
