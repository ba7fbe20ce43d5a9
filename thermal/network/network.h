/* The heat balance as a network, whatever it was built from (finite elements, shells, lumps):
 *
 *   C_i dT_i/dt = P_i + Q_i(t) + sum_j K_ij (T_j - T_i) + sigma sum_j R_ij (T_j^4 - T_i^4)
 *                 - sigma R_i,space (T_i^4 - T_space^4)
 *
 * Q_i: loads on the surfaces attached to node i. C > 0: diffusive; C = 0: arithmetic (balances at
 * every instant, eliminated before integration); boundary: T given. Timed sources and thermostats
 * add to P_i; see below. */
#ifndef UMBRA_THERMAL_NETWORK_H
#define UMBRA_THERMAL_NETWORK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/core/context.h"
#include "thermal/network/surface_law.h"
#include "thermal/network/temperature_law.h"

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
/* Nodes added from now on belong to this part, for messages. */
enum um_status um_thermal_network_section_begin(struct um_thermal_network *network,
                                                const char *part);
void um_thermal_network_power_set(struct um_thermal_network *network, uint32_t node, double power);
/* The power of a node [W]; sources and thermostats not counted. */
double um_thermal_network_power(const struct um_thermal_network *network, uint32_t node);
/* Add to what is there. power [W]. */
void um_thermal_network_power_add(struct um_thermal_network *network, uint32_t node, double power);

/* A power history spread over nodes: node i gets weight[i] P(t), weights of sum 1. Rows in
 * ascending t_tai [s]; equal times are a jump. P is linear between rows or, stepwise, that of the
 * last row passed. Outside the rows it is 0: nothing is held, so the last row of a stepwise history
 * only says when it ends. It acts at the times it states in a periodic solution too: in that one
 * orbit. */
struct um_thermal_source {
  const uint32_t *node; /* [nnode] */
  const double *weight; /* [nnode], 0 or more */
  size_t nnode;
  const double *t, *power; /* [nrow] [s], [W] */
  size_t nrow;
  bool stepwise;
};
/* Copies. UM_ERR_INPUT: unknown nodes, weights that do not add to 1, times that descend, values
 * that are not finite. */
enum um_status um_thermal_network_source_add(struct um_thermal_network *network,
                                             const struct um_thermal_source *source);

/* How a thermostat begins a run. */
enum um_thermal_thermostat_start {
  UM_THERMOSTAT_BY_SENSOR, /* on where its sensor is below the middle of the band */
  UM_THERMOSTAT_ON, /* as in um_thermal_history.heating where an earlier run ended; outside of
                       the band the sensor decides */
  UM_THERMOSTAT_OFF
};

/* A heater with hysteresis: releases `power` over nodes, is switched on when the mean over its
 * sensor nodes falls to `on` and off when it rises to `off`, on < off. A run begins with those on
 * whose sensor is below the middle of the two, or, where the sensor lies between them and a phase
 * is stated, there in the cycle: all sensor nodes are moved by what the sensor then lacks, and the
 * phase decides whether it is on. Less than a band above `off` the sensor is lower by what it would
 * lack of `off` there, times the share of the band that is left. Steady and periodic solutions take
 * its mean power, which falls from full to nothing around the middle (see system_heat.c); where a
 * heater of that power cannot hold the middle it is simply on. */
struct um_thermal_thermostat {
  const uint32_t *node; /* [nnode] diffusive */
  const double *weight; /* [nnode], sum 1 */
  size_t nnode;
  const uint32_t *sensor;      /* [nsensor] diffusive; NULL: the heated nodes */
  const double *sensor_weight; /* [nsensor], sum 1 */
  size_t nsensor;
  double power;   /* [W] */
  double on, off; /* [K] */
  enum um_thermal_thermostat_start start;
  /* Where in its cycle a run begins [1]: below 0.5 it is on and the sensor has passed twice that
   * share of the way from `on` to `off`, from 0.5 it is off and on the way back; 1 is that of 0. 0:
   * not stated. */
  double phase;
};
/* Copies. UM_ERR_INPUT as above, nodes that are not diffusive, thresholds out of order,
 * a phase outside 0 to 1. */
enum um_status um_thermal_network_thermostat_add(struct um_thermal_network *network,
                                                 const struct um_thermal_thermostat *thermostat);
size_t um_thermal_network_thermostats(const struct um_thermal_network *network);
/* True where none of them lacks a phase. */
bool um_thermal_network_phases_stated(const struct um_thermal_network *network);

/* Linear conductance K [W/K]; finite elements may add negative ones. */
enum um_status um_thermal_network_conductor_add(struct um_thermal_network *network, uint32_t a,
                                                uint32_t b, double conductance);
/* Radiative conductance R [m^2] (emittance included); b may be UM_THERMAL_SPACE. */
enum um_status um_thermal_network_radiator_add(struct um_thermal_network *network, uint32_t a,
                                               uint32_t b, double radiator);
/* --- by temperature (network_law.c) ---------------------------------------------------------- */

/* A law that links or capacities of the network may follow, copied; one that is there already gets
 * the same index. UM_ERR_INPUT: ratios that are not finite and above 0, powers below 1. */
enum um_status um_thermal_network_link_law_add(struct um_thermal_network *network,
                                               const struct um_thermal_link_law *law,
                                               uint32_t *index);
enum um_status um_thermal_network_capacity_law_add(struct um_thermal_network *network,
                                                   const struct um_thermal_ratio *ratio,
                                                   uint32_t *index);
/* The link that was added last follows a law. */
void um_thermal_network_conductor_follow(struct um_thermal_network *network, uint32_t law);
void um_thermal_network_radiator_follow(struct um_thermal_network *network, uint32_t law);
/* `capacity` [J/K] of what a diffusive node holds, stated at 300 K, goes with temperature:
 *
 *   C(T) = C + sum_s capacity_s (ratio_s(T) - 1). */
enum um_status um_thermal_network_capacity_follow(struct um_thermal_network *network, uint32_t node,
                                                  double capacity, uint32_t law);

/* Surface number `surface` [0, nsurface) lies on up to three nodes with weights of sum 1. It
 * absorbs area * (absorptance * (sun + albedo) + emittance * planet) and emits
 * area * emittance * sigma T^4 per node share, each times what its law says of angle and
 * temperature (the extraction goes with the absorptance). extraction: fraction of *direct* incident
 * sunlight turned into electricity. blocked: cosine-weighted share of the hemisphere that the
 * satellite itself covers; what is radiated there is taken to come back, so emission to space is 1
 * - blocked of the above (incident loads have their own free shares). Each surface is attached
 * once. */
struct um_thermal_surface {
  uint32_t node[3]; /* unused entries UM_THERMAL_SPACE */
  double weight[3];
  double area;                               /* [m^2] */
  double absorptance, emittance, extraction; /* [1] */
  double blocked;                            /* [1] */
  bool inside; /* turned to the inside of a closed part: no load reaches it, all of its emission
                  other surfaces of the room; numbered behind those that loads are for */
  const struct um_thermal_surface_law *law; /* by angle and temperature; borrowed; NULL: constant */
  double in_plane; /* what the wall under it conducts in plane, kt at 300 K [W/K]; 0: it lies on no
                      wall of linear triangles. For mesh_error.h alone */
};
/* Emission to space [m^2]: times sigma T^4, and what the law says at T. */
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
/* Numbers of surfaces that loads are for. */
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
/* True when both say the same, number for number: nodes with their start temperatures, conductors,
 * radiators, surfaces, laws, power histories and thermostats in the same order. Names do not count.
 * The same loads then give the same temperatures, bit by bit. */
bool um_thermal_network_equal(const struct um_thermal_network *a,
                              const struct um_thermal_network *b);
/* True when values alone differ: the same kinds of nodes, as many thermostats, power histories of
 * the same times. */
bool um_thermal_network_structure_equal(const struct um_thermal_network *a,
                                        const struct um_thermal_network *b);
/* True when surfaces take and give radiation alike: areas, absorptances, emittances and their laws,
 * what exchange between them is made of. */
bool um_thermal_network_optics_equal(const struct um_thermal_network *a,
                                     const struct um_thermal_network *b);
/* The same of what they do to sunlight. */
bool um_thermal_network_solar_equal(const struct um_thermal_network *a,
                                    const struct um_thermal_network *b);
/* Read nodes.csv and conductors.csv (see the scenario reference), or a file .d of ESATAN and no
 * conductors (NULL): its nodes have the labels that no other has, else their numbers, as names.
 * Errors name file and line. */
enum um_status um_thermal_network_read(struct um_context *context, const char *nodes,
                                       const char *conductors, struct um_thermal_network **out);

#endif
