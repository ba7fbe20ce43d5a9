/* See load_sums.h, load_sums_impl.h. */
#include <string.h>

#include "thermal/solver/load_sums_impl.h"

#define MOST ((size_t)256 << 20) /* [byte] */

struct um_thermal_load_sums {
  const struct um_thermal_network *network;
  const struct um_irradiation_loads *loads;
  double *sun, *albedo, *planet; /* [nrow][nnode] of um_thermal_load_row_sum, nothing reflected */
};

/* A share of a surface and the patch that others shine on. */
struct um_thermal_load_entry {
  uint32_t node, patch;
  double absorbs, receives; /* of sunlight and of infrared from all sides [m^2] */
};

/* Surfaces with other optics, and where what others reflect goes. */
struct um_thermal_load_near {
  const struct um_thermal_load_sums *sums;
  uint32_t *changed; /* [nchanged] surfaces */
  size_t nchanged, nentry;
  struct um_thermal_load_entry *entry; /* [nentry] */
};

enum um_status um_thermal_load_sums_create(struct um_context *context,
                                           const struct um_thermal_network *network,
                                           const struct um_irradiation_loads *loads,
                                           struct um_thermal_load_sums **out)
{
  enum um_status status;
  struct um_thermal_load_sums *s = NULL;
  size_t n = network->nnode, all = n * loads->ntime;
  *out = NULL;
  if (loads->nsurface < network->noutside)
    return um_core_fail(context, UM_ERR_INPUT,
                        "heat loads of %zu surfaces for a network with %zu; accepted: as many",
                        loads->nsurface, network->noutside);
  if (loads->gas != NULL || all > MOST / (3 * sizeof(double))) return UM_OK;
  UM_CHECK(um_core_allocate(context, 1, sizeof *s, &s));
  *s = (struct um_thermal_load_sums){.network = network, .loads = loads};
  UM_CHECK(um_core_allocate(context, all, sizeof *s->sun, &s->sun));
  UM_CHECK(um_core_allocate(context, all, sizeof *s->albedo, &s->albedo));
  UM_CHECK(um_core_allocate(context, all, sizeof *s->planet, &s->planet));
#pragma omp parallel for schedule(static) num_threads(um_core_context_threads(context))
  for (size_t row = 0; row < loads->ntime; row++)
    if (!um_core_stopped(context))
      um_thermal_load_row_sum(network, loads, NULL, NULL, row, s->sun + row * n,
                              s->albedo + row * n, s->planet + row * n, NULL);
  UM_CHECK(um_core_stop_check(context, "heat loads were added up"));
  *out = s;
  s = NULL;
done:
  um_thermal_load_sums_destroy(context, &s);
  return status;
}

void um_thermal_load_sums_destroy(struct um_context *context, struct um_thermal_load_sums **sums)
{
  if (*sums == NULL) return;
  UM_FREE(context, (*sums)->sun, (*sums)->albedo, (*sums)->planet, *sums);
  *sums = NULL;
}

/* --- another network ------------------------------------------------------------------------- */

static bool same_place(const struct um_thermal_surface *a, const struct um_thermal_surface *b)
{
  for (int k = 0; k < 3; k++)
    if (a->node[k] != b->node[k] || a->weight[k] != b->weight[k]) return false;
  return a->area == b->area;
}

/* Is every surface on the same nodes? */
static bool serve(const struct um_thermal_network *a, const struct um_thermal_network *b)
{
  if (a->nnode != b->nnode || a->noutside != b->noutside) return false;
  for (size_t s = 0; s < a->noutside; s++)
    if (a->attached[s] != b->attached[s] ||
        (a->attached[s] && !same_place(&a->surface[s], &b->surface[s])))
      return false;
  return true;
}

static enum um_status find_changed(struct um_context *context,
                                   const struct um_thermal_network *network,
                                   struct um_thermal_load_near *near)
{
  const struct um_thermal_network *of = near->sums->network;
  UM_TRY(um_core_allocate(context, network->noutside, sizeof *near->changed, &near->changed));
  for (size_t s = 0; s < network->noutside; s++)
    if (network->attached[s] &&
        !um_thermal_surface_loads_equal(&of->surface[s], &network->surface[s]))
      near->changed[near->nchanged++] = (uint32_t)s;
  return UM_OK;
}

/* What absorbs reflected light as um_thermal_load_row_sum has it. */
static enum um_status find_entries(struct um_context *context,
                                   const struct um_thermal_network *network,
                                   const struct um_thermal_exchange *exchange,
                                   struct um_thermal_load_near *near)
{
  if (exchange == NULL) return UM_OK;
  UM_TRY(um_core_allocate(context, 3 * network->noutside, sizeof *near->entry, &near->entry));
  for (size_t s = 0; s < network->noutside; s++) {
    const struct um_thermal_surface *surface = &network->surface[s];
    uint32_t patch = exchange->patch[s];
    if (!network->attached[s] || patch == UM_THERMAL_NO_PATCH) continue;
    const struct um_thermal_surface_law *law = surface->law;
    double absorbs = surface->absorptance * (law != NULL ? law->albedo : 1.0);
    double receives = surface->emittance * (law != NULL ? law->planet : 1.0);
    for (int k = 0; k < 3; k++) {
      double area = surface->weight[k] * surface->area;
      if (surface->node[k] != UM_THERMAL_SPACE)
        near->entry[near->nentry++] = (struct um_thermal_load_entry){
            surface->node[k], patch, area * absorbs, area * receives};
    }
  }
  return UM_OK;
}

enum um_status um_thermal_load_near_make(struct um_context *context,
                                         const struct um_thermal_load_sums *sums,
                                         const struct um_thermal_network *network,
                                         const struct um_irradiation_loads *loads,
                                         const struct um_thermal_aging *aging,
                                         const struct um_thermal_exchange *exchange,
                                         struct um_thermal_load_near **out)
{
  enum um_status status;
  struct um_thermal_load_near *near = NULL;
  *out = NULL;
  if (sums == NULL || sums->loads != loads || aging != NULL || !serve(sums->network, network))
    return UM_OK;
  UM_CHECK(um_core_allocate(context, 1, sizeof *near, &near));
  near->sums = sums;
  UM_CHECK(find_changed(context, network, near));
  UM_CHECK(find_entries(context, network, exchange, near));
  *out = near;
  near = NULL;
done:
  um_thermal_load_near_destroy(context, &near);
  return status;
}

void um_thermal_load_near_destroy(struct um_context *context, struct um_thermal_load_near **near)
{
  if (*near == NULL) return;
  UM_FREE(context, (*near)->changed, (*near)->entry, *near);
  *near = NULL;
}

void um_thermal_load_near_row(const struct um_thermal_load_near *near,
                              const struct um_thermal_network *network,
                              const struct um_thermal_exchange *exchange, size_t row, double *sun,
                              double *albedo, double *planet)
{
  const struct um_thermal_load_sums *sums = near->sums;
  size_t n = network->nnode;
  memcpy(sun, sums->sun + row * n, n * sizeof *sun);
  memcpy(albedo, sums->albedo + row * n, n * sizeof *albedo);
  memcpy(planet, sums->planet + row * n, n * sizeof *planet);
  for (size_t i = 0; i < near->nchanged; i++) {
    size_t s = near->changed[i];
    const struct um_thermal_surface *surface = &network->surface[s];
    struct um_thermal_load_taken own, before;
    um_thermal_load_row_take(network, sums->loads, NULL, row, s, &own);
    um_thermal_load_row_take(sums->network, sums->loads, NULL, row, s, &before);
    for (int k = 0; k < 3; k++) {
      uint32_t node = surface->node[k];
      double area = surface->weight[k] * surface->area;
      if (node == UM_THERMAL_SPACE) continue;
      sun[node] += area * (own.sun - before.sun);
      albedo[node] += area * (own.albedo - before.albedo);
      planet[node] += area * (own.planet - before.planet);
    }
  }
  if (near->nentry == 0) return;
  const struct um_thermal_reflected *r = &exchange->reflected;
  size_t at = row * exchange->npatch;
  for (size_t e = 0; e < near->nentry; e++) {
    const struct um_thermal_load_entry *entry = &near->entry[e];
    if (r->sun != NULL) sun[entry->node] += entry->absorbs * r->sun[at + entry->patch];
    if (r->albedo != NULL) albedo[entry->node] += entry->absorbs * r->albedo[at + entry->patch];
    if (r->planet != NULL) planet[entry->node] += entry->receives * r->planet[at + entry->patch];
  }
}
