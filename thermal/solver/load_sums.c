/* Rows of heat loads on nodes, kept of one network (load_sums.h) and taken for another with other
 * optics on the same surfaces (load_sums_impl.h): at a row, node i absorbs
 *
 *   q_i = kept_i + sum_s w_si A_s (a_s - a_s,kept) E_s + sum_s w_si A_s a_s R_p(s),
 *
 * s over surfaces whose optics differ, then over all that others shine on; w_si the share of s that
 * node i has, a absorptance or emittance, E what arrives from outside, R what patch p is sent by
 * other surfaces. */
#include <string.h>

#include "base/core/sort.h"
#include "thermal/network/load_angle_group.h"
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
  uint32_t *changed; /* [nchanged] surfaces; the first nsolar take other sunlight, too */
  size_t nchanged, nsolar, nentry;
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
  for (int pass = 0; pass < 2; pass++) {
    for (size_t s = 0; s < network->noutside; s++) {
      const struct um_thermal_surface *a = &of->surface[s], *b = &network->surface[s];
      if (!network->attached[s] || um_thermal_surface_loads_equal(a, b)) continue;
      if (um_thermal_surface_sunlight_equal(a, b) == (pass == 1))
        near->changed[near->nchanged++] = (uint32_t)s;
    }
    if (pass == 0) near->nsolar = near->nchanged;
  }
  return UM_OK;
}

static int compare_entries(const void *a, const void *b)
{
  const struct um_thermal_load_entry *x = a, *y = b;
  if (x->node != y->node) return x->node < y->node ? -1 : 1;
  return (x->patch > y->patch) - (x->patch < y->patch);
}

/* Those of a node and patch become one, in the order of nodes. */
static enum um_status merge_entries(struct um_context *context, struct um_thermal_load_near *near)
{
  size_t kept = 0;
  UM_TRY(um_core_sort(context, near->entry, near->nentry, sizeof *near->entry, compare_entries));
  for (size_t e = 0; e < near->nentry; e++) {
    struct um_thermal_load_entry *to = &near->entry[kept > 0 ? kept - 1 : 0];
    if (kept == 0 || compare_entries(to, &near->entry[e]) != 0) {
      near->entry[kept++] = near->entry[e];
      continue;
    }
    to->absorbs += near->entry[e].absorbs;
    to->receives += near->entry[e].receives;
  }
  near->nentry = kept;
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
  return merge_entries(context, near);
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

/* What a surface takes more than before: of the Earth's infrared, and of sunlight where it may. */
static void add_change(const struct um_thermal_load_near *near,
                       const struct um_thermal_network *network, size_t row, size_t s, bool solar,
                       double *sun, double *albedo, double *planet)
{
  const struct um_irradiation_loads *loads = near->sums->loads;
  const struct um_thermal_surface *own = &network->surface[s],
                                  *before = &near->sums->network->surface[s];
  size_t at = row * loads->nsurface + s;
  struct um_thermal_load_taken more = {0}, less = {0};
  more.planet = um_thermal_load_planet(own, loads, at, own->emittance);
  less.planet = um_thermal_load_planet(before, loads, at, before->emittance);
  if (solar) um_thermal_load_row_take(network, loads, NULL, row, s, &more);
  if (solar) um_thermal_load_row_take(near->sums->network, loads, NULL, row, s, &less);
  for (int k = 0; k < 3; k++) {
    uint32_t node = own->node[k];
    double area = own->weight[k] * own->area;
    if (node == UM_THERMAL_SPACE) continue;
    planet[node] += area * (more.planet - less.planet);
    if (!solar) continue;
    sun[node] += area * (more.sun - less.sun);
    albedo[node] += area * (more.albedo - less.albedo);
  }
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
  for (size_t i = 0; i < near->nchanged; i++)
    add_change(near, network, row, near->changed[i], i < near->nsolar, sun, albedo, planet);
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
