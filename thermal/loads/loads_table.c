/* Storage of a table of incident loads; loads.c fills it by rays. */
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

void um_irradiation_loads_destroy(struct um_context *context, struct um_irradiation_loads **loads)
{
  if (loads == NULL || *loads == NULL) return;
  struct um_irradiation_loads *l = *loads;
  UM_FREE(context, l->t, l->sunlit, l->irradiance, l->sun, l->incidence, l->by_cosine, l->albedo,
          l->planet, l->view_factor, l->brightness, l->gas, l->albedo_moments, l->planet_moments,
          l->edge, l);
  *loads = NULL;
}
