/* The heat balance as a network, whatever it was built from (finite elements, shells, lumps):
 *
 *   C_i dT_i/dt = P_i + Q_i(t) + sum_j K_ij (T_j - T_i) + sigma sum_j R_ij (T_j^4 - T_i^4)
 *                 - sigma R_i,space (T_i^4 - T_space^4)
 *
 * Q_i: loads on the surfaces attached to node i. C > 0: diffusive; C = 0: arithmetic (balances at
 * every instant, eliminated before integration); boundary: T given. */
#ifndef UMBRA_THERMAL_NETWORK_H
#define UMBRA_THERMAL_NETWORK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/context.h"

enum um_thermal_node_kind { UM_NODE_DIFFUSIVE, UM_NODE_ARITHMETIC, UM_NODE_BOUNDARY };

#define UM_THERMAL_SPACE UINT32_MAX

struct um_thermal_network;

enum um_status um_thermal_network_create(struct um_context *context,
                                         struct um_thermal_network **out);
void um_thermal_network_destroy(struct um_thermal_network **network);

/* name: NULL for the nodes of a finite-element field. capacity [J/K], temperature [K] at the start
 * (or always, for a boundary), power [W]. */
enum um_status um_thermal_network_node_add(struct um_thermal_network *network, const char *name,
                                           enum um_thermal_node_kind kind, double capacity,
                                           double temperature, double power, uint32_t *index);
/* Add to what is there. capacity [J/K]. */
void um_thermal_network_capacity_add(struct um_thermal_network *network, uint32_t node,
                                     double capacity);
void um_thermal_network_power_set(struct um_thermal_network *network, uint32_t node, double power);
/* Linear conductance K [W/K]; finite elements may add negative ones. */
enum um_status um_thermal_network_conductor_add(struct um_thermal_network *network, uint32_t a,
                                                uint32_t b, double conductance);
/* Radiative conductance R [m^2] (emittance included); b may be UM_THERMAL_SPACE. */
enum um_status um_thermal_network_radiator_add(struct um_thermal_network *network, uint32_t a,
                                               uint32_t b, double radiator);
/* Surface number `surface` [0, nsurface) lies on up to three nodes with weights of sum 1. It
 * absorbs area * (absorptance * (sun + albedo) + emittance * planet) and emits
 * area * emittance * sigma T^4 per node share. extraction: fraction of *direct* incident sunlight
 * turned into electricity. blocked: cosine-weighted share of the hemisphere that the satellite
 * itself covers; what is radiated there is taken to come back, so emission to space is 1 - blocked
 * of the above (incident loads have their own free shares). Each surface is attached once. */
struct um_thermal_surface {
  uint32_t node[3]; /* unused entries UM_THERMAL_SPACE */
  double weight[3];
  double area;                               /* [m^2] */
  double absorptance, emittance, extraction; /* [1] */
  double blocked;                            /* [1] */
};
/* Emission to space [m^2]: times sigma T^4. */
static inline double um_thermal_surface_emission(const struct um_thermal_surface *surface)
{
  return surface->area * surface->emittance * (1.0 - surface->blocked);
}
enum um_status um_thermal_network_surface_attach(struct um_thermal_network *network,
                                                 uint32_t surface,
                                                 const struct um_thermal_surface *attachment);

/* Set `blocked` of an attached surface. UM_ERR_INPUT outside 0..1 or for no such surface. */
enum um_status um_thermal_network_surface_block(struct um_thermal_network *network,
                                                uint32_t surface, double blocked);

size_t um_thermal_network_nodes(const struct um_thermal_network *network);
size_t um_thermal_network_surfaces(const struct um_thermal_network *network);
const char *um_thermal_network_name(const struct um_thermal_network *network, uint32_t node);
/* Index of the first node of that name, or (size_t)-1. */
size_t um_thermal_network_find(const struct um_thermal_network *network, const char *name);
enum um_thermal_node_kind um_thermal_network_kind(const struct um_thermal_network *network,
                                                  uint32_t node);
/* [J/K]; [K] at the start. */
double um_thermal_network_capacity(const struct um_thermal_network *network, uint32_t node);
double um_thermal_network_temperature(const struct um_thermal_network *network, uint32_t node);
/* Borrowed; NULL when no such surface was attached (numbers may have gaps). */
const struct um_thermal_surface *
um_thermal_network_surface(const struct um_thermal_network *network, uint32_t surface);
/* Set all start temperatures [nnode] [K]. */
void um_thermal_network_temperatures_set(struct um_thermal_network *network,
                                         const double *temperature);
/* Read nodes.csv and conductors.csv (see the scenario reference). Errors name file and line. */
enum um_status um_thermal_network_read(struct um_context *context, const char *nodes_csv,
                                       const char *conductors_csv, struct um_thermal_network **out);

#endif
