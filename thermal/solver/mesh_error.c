/* An error of temperatures from what the heat balance leaves on each facet.
 *
 * Walls are linear triangles. In a wall of in-plane conductance kt the temperature obeys
 *
 *   kt lap T = stored - gained - other
 *
 * per area; gained is what the surface absorbs less what it emits. Nodes satisfy this in the mean
 * over the facets around them. A facet does not: what it gains differs from what its corners' nodes
 * gain, and that difference has to be conducted within it. With G, P the heat per area that a node
 * gains by its surfaces and by conduction in plane,
 *
 *   s = kt lap T = sum_k w_k (G_k + P_k) - gained.
 *
 * The mean over a triangle of a linear interpolant lies (1/24) sum_e e'He above that of a field of
 * Hessian H. H = (lap T / 2) I makes it L^2 lap T with L^2 = sum_e l_e^2 / 48; a facet of height h
 * over its longest edge conducts across, and L^2 is h^2 / 6 where that is less. Where a facet is
 * larger than the length over which a wall conducts, what it gains is radiated: its temperature is
 * off by s over the slope of its emission. Both in parallel:
 *
 *   shift = s / (kt / L^2 + 4 eps sigma T^3).
 *
 * A residual of the equation in each element is the classical measure of a mesh (Babuska &
 * Rheinboldt 1978, Int. J. Numer. Methods Eng. 12:1597).
 *
 * Spread: of the linear field between a facet's corners, sum_e (T_a - T_b)^2 / 36; where a surface
 * has a node of its own, by the temperatures of the facets around it, sum_e (T - T_e)^2 / 12, which
 * is the same for a linear field on right triangles. Finer facets with nodes of their own radiate
 * what the coarse one does, so that the mean of T^4 stays and that of T falls by 3 spread / (2 T).
 */
#include "thermal/solver/mesh_error.h"

#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "thermal/network/network_group.h"
#include "thermal/network/shell_element_group.h"
#include "thermal/solver/solve.h"

struct work {
  struct um_thermal_surface *surface;   /* [nsurface] each on a node of its own */
  struct um_thermal_network_node *node; /* [nsurface] */
  struct um_thermal_heat *heat;         /* [nsurface] [W] */
  double *shown;                        /* [nsurface] [K] */
  double *area, *gained;                /* [nnode] [m^2], [W] by surfaces and in plane */
  uint32_t *surfaces;                   /* [nnode] surfaces on it */
};

static void work_free(struct um_context *context, struct work *w)
{
  UM_FREE(context, w->surface, w->node, w->heat, w->shown, w->area, w->gained, w->surfaces);
}

static enum um_status work_make(struct um_context *context,
                                const struct um_thermal_network *network, struct work *w)
{
  size_t n = network->nsurface;
  UM_TRY(um_core_allocate(context, n, sizeof *w->surface, &w->surface));
  UM_TRY(um_core_allocate(context, n, sizeof *w->node, &w->node));
  UM_TRY(um_core_allocate(context, n, sizeof *w->heat, &w->heat));
  UM_TRY(um_core_allocate(context, n, sizeof *w->shown, &w->shown));
  UM_TRY(um_core_allocate(context, network->nnode, sizeof *w->area, &w->area));
  UM_TRY(um_core_allocate(context, network->nnode, sizeof *w->gained, &w->gained));
  return um_core_allocate(context, network->nnode, sizeof *w->surfaces, &w->surfaces);
}

/* What each surface gains [W]: the balance of a network of which every surface has a node of its
 * own and nothing else. */
static enum um_status gains(struct um_context *context, const struct um_thermal_network *network,
                            const struct um_irradiation_loads *loads,
                            const struct um_thermal_solve_options *options, double t,
                            const double *temperature, struct work *w)
{
  struct um_thermal_network apart = *network;
  apart.nnode = network->nsurface;
  apart.nconductor = apart.nradiator = apart.nsource = apart.nthermostat = apart.nstore = 0;
  apart.node = w->node;
  apart.surface = w->surface;
  for (size_t s = 0; s < network->nsurface; s++) {
    w->surface[s] = network->surface[s];
    w->shown[s] = 1.0; /* of a surface that is attached to nothing */
    if (!network->attached[s]) continue;
    w->shown[s] = um_thermal_surface_temperature(&network->surface[s], temperature);
    for (int k = 0; k < 3; k++) {
      w->surface[s].node[k] = k == 0 ? (uint32_t)s : UM_THERMAL_SPACE;
      w->surface[s].weight[k] = k == 0 ? 1.0 : 0.0;
    }
  }
  return um_thermal_heat_of_nodes(context, &apart, loads, options, t, w->shown, w->heat);
}

static bool on_corners(const struct um_thermal_surface *surface)
{
  return surface->node[2] != UM_THERMAL_SPACE;
}

static void corners_of(const struct um_geometry_pose *pose, const uint32_t corner[3],
                       struct um_vec3 at[3])
{
  for (int c = 0; c < 3; c++) at[c] = pose->vertex[corner[c]];
}

/* L^2 of a facet [m^2]. */
static double length2_of(const struct um_vec3 at[3], double area)
{
  double squares = 0.0, longest2 = 0.0;
  for (int e = 0; e < 3; e++) {
    struct um_vec3 edge = um_vec3_sub(at[(e + 1) % 3], at[e]);
    squares += um_vec3_dot(edge, edge);
    longest2 = fmax(longest2, um_vec3_dot(edge, edge));
  }
  return fmin(squares / 48.0, 4.0 * area * area / longest2 / 6.0);
}

/* Add the heat that a facet's wall conducts in plane to its corners [W]. */
static void conduct(const struct um_thermal_surface *surface, const struct um_vec3 at[3],
                    const double *temperature, double *gained)
{
  double k[3];
  um_thermal_shell_element(at, surface->in_plane, k);
  for (int e = 0; e < 3; e++) {
    uint32_t i = surface->node[(e + 1) % 3], j = surface->node[(e + 2) % 3];
    double flow = k[e] * (temperature[j] - temperature[i]);
    gained[i] += flow;
    gained[j] -= flow;
  }
}

/* Does it lie on a wall that conducts in plane? */
static bool conducts(const struct um_thermal_surface *surface)
{
  return surface->in_plane > 0.0 && on_corners(surface);
}

/* What nodes gain by their surfaces and by conduction in plane. */
static void gather(const struct um_thermal_network *network, const struct um_geometry_mesh *mesh,
                   const struct um_geometry_pose *pose, const double *temperature, struct work *w)
{
  for (size_t s = 0; s < network->nsurface; s++) {
    const struct um_thermal_surface *surface = &network->surface[s];
    if (!network->attached[s]) continue;
    for (int k = 0; k < 3 && surface->node[k] != UM_THERMAL_SPACE; k++) {
      w->area[surface->node[k]] += surface->weight[k] * surface->area;
      w->gained[surface->node[k]] += surface->weight[k] * w->heat[s].stored;
      w->surfaces[surface->node[k]]++;
    }
    if (s >= network->noutside || !conducts(surface)) continue;
    struct um_vec3 at[3];
    corners_of(pose, mesh->corner[mesh->surface[s].facet], at);
    conduct(surface, at, temperature, w->gained);
  }
}

static double shift_of(const struct um_thermal_surface *surface, const struct um_vec3 at[3],
                       const struct work *w, size_t s)
{
  double left = -w->heat[s].stored / surface->area, t = w->shown[s];
  if (!conducts(surface)) return 0.0;
  for (int k = 0; k < 3; k++)
    left += surface->weight[k] * w->gained[surface->node[k]] / w->area[surface->node[k]];
  return left / (surface->in_plane / length2_of(at, surface->area) +
                 4.0 * UM_STEFAN_BOLTZMANN * surface->emittance * t * t * t);
}

static double spread_between(const struct um_thermal_surface *surface, const double *temperature)
{
  double sum = 0.0;
  for (int k = 0; k < 3; k++) {
    double d = temperature[surface->node[k]] - temperature[surface->node[(k + 1) % 3]];
    sum += d * d / 36.0;
  }
  return sum;
}

/* By the facets beside it, of the same group and side. */
static double spread_around(const struct um_geometry_mesh *mesh, const uint32_t (*beside)[3],
                            const struct work *w, size_t s)
{
  const struct um_geometry_surface *at = &mesh->surface[s];
  double sum = 0.0;
  for (int e = 0; e < 3; e++) {
    uint32_t f = beside[at->facet][e];
    if (f == UM_GEOMETRY_NONE || mesh->facet_group[f] != at->group) continue;
    uint32_t other = at->back ? mesh->surface_of_back[f] : mesh->surface_of_front[f];
    if (other == UM_GEOMETRY_NONE) continue;
    double d = w->shown[other] - w->shown[s];
    sum += d * d / 12.0;
  }
  return sum;
}

enum um_status
um_thermal_mesh_error_at(struct um_context *context, const struct um_thermal_network *network,
                         const struct um_geometry_mesh *mesh, const uint32_t (*beside)[3],
                         const struct um_geometry_pose *pose,
                         const struct um_irradiation_loads *loads,
                         const struct um_thermal_solve_options *options, double t,
                         const double *temperature, struct um_thermal_mesh_error *out)
{
  enum um_status status;
  struct work w = {0};
  size_t n = network->noutside;
  memset(out, 0, sizeof *out);
  UM_CHECK(um_core_allocate(context, n, sizeof *out->shift, &out->shift));
  UM_CHECK(um_core_allocate(context, n, sizeof *out->spread, &out->spread));
  UM_CHECK(um_core_allocate(context, n, sizeof *out->lone, &out->lone));
  UM_CHECK(work_make(context, network, &w));
  UM_CHECK(gains(context, network, loads, options, t, temperature, &w));
  gather(network, mesh, pose, temperature, &w);
  for (size_t s = 0; s < n; s++) {
    const struct um_thermal_surface *surface = &network->surface[s];
    if (!network->attached[s]) continue;
    if (on_corners(surface)) {
      out->spread[s] = spread_between(surface, temperature);
      struct um_vec3 at[3];
      corners_of(pose, mesh->corner[mesh->surface[s].facet], at);
      out->shift[s] = shift_of(surface, at, &w, s);
    } else if (w.surfaces[surface->node[0]] == 1) {
      out->lone[s] = true;
      out->spread[s] = spread_around(mesh, beside, &w, s);
      out->shift[s] = 1.5 * out->spread[s] / w.shown[s];
    }
  }
done:
  work_free(context, &w);
  return status;
}

void um_thermal_mesh_error_release(struct um_context *context, struct um_thermal_mesh_error *error)
{
  UM_FREE(context, error->shift, error->spread, error->lone);
}
