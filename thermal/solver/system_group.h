/* Private to the rooms of thermal/: the network as equations, ready to be evaluated fast.
 *
 * Nodes are split into unknowns (diffusive; in a steady system also arithmetic), eliminated
 * (arithmetic: their temperatures follow from the unknowns at every instant) and fixed (boundary).
 * Parallel conductors and radiators are merged into one symmetric list in rows per node. */
#ifndef UMBRA_THERMAL_SYSTEM_GROUP_H
#define UMBRA_THERMAL_SYSTEM_GROUP_H

#include "thermal/exchange/exchange_group.h"
#include "thermal/exchange/thread_tuning_group.h"
#include "thermal/loads/loads.h"
#include "thermal/network/link_law_group.h"
#include "thermal/network/network_group.h"
#include "thermal/network/solve_options.h"

#define UM_THERMAL_NONE UINT32_MAX

struct um_thermal_load_near; /* load_sums_impl.h */

/* Loads of one grid time summed onto nodes. */
struct um_thermal_load_row {
  size_t row;    /* of the table; (size_t)-1: empty */
  double *sun;   /* [n] absorbed per unit of irradiance in full sunlight [m^2] */
  double *earth; /* [n] absorbed albedo and planet, switches applied [W] */
  double *space; /* emission of this row, as system->emission_held; NULL where nothing ages */
  double sun_total, albedo_total, planet_total; /* over nodes that are not boundary [m^2], [W] */
};

/* Loads at one instant. */
struct um_thermal_load_now {
  double t;                     /* [s]; NaN: none yet */
  double *q;                    /* [n] absorbed [W] */
  double solar, albedo, planet; /* over nodes that are not boundary [W] */
};

/* A connected group of eliminated nodes; small and dense. */
struct um_thermal_cluster {
  uint32_t *node;      /* [m] */
  uint32_t *neighbour; /* [p] unknown indices that it touches */
  double *matrix;      /* [m][m] derivative of the balance, then its LU factors */
  double *response;    /* [m][p] dT_node / dT_neighbour */
  double *balance;     /* [m] */
  uint32_t *pivot;     /* [m] */
  size_t *slot;        /* [p][p] place of (row, column) in the Jacobian, column-major */
  size_t m, p;
};

/* A power history in force. Rows passed: 0 before the first, nrow from the last on. */
struct um_thermal_system_source {
  const struct um_thermal_network_source *source; /* borrowed */
  size_t low, high;                               /* rows passed between two stops */
  size_t passed;                                  /* last one used */
};

/* A thermostat in force. */
struct um_thermal_system_thermostat {
  const struct um_thermal_network_thermostat *thermostat; /* borrowed */
  bool on;
  double power; /* at the last state [W] */
  double slope; /* of it over the sensor's temperature [W/K]; where heaters are taken as means */
  /* [ceil(sensor.n / every)][at.n] places in the Jacobian; NULL: has no slope. A large block has
   * every so many-th node of the sensor stand for all, with its weight times `share`. */
  size_t *slot;
  size_t every;
  double share;
};

/* Width of the transition of a mean thermostat, of its band [1]. */
#define UM_THERMAL_TRANSITION 0.1

/* Exchange between patches in force; NULL in a system without infrared exchange. gain and slope are
 * of nodes: what patches receive is shared among their nodes by area. */
struct um_thermal_system_exchange {
  const struct um_thermal_exchange *exchange; /* borrowed */
  size_t *start;                              /* [n + 1] shares of a node */
  uint32_t *patch;                            /* [nshare] */
  double *share;                              /* [nshare] of the patch's area [1] */
  size_t *patch_start;                        /* [npatch + 1] the same in rows per patch */
  uint32_t *patch_node;                       /* [nshare] */
  double *patch_share;                        /* [nshare] */
  double *power4;                             /* [npatch] mean of T^4 - T_space^4 [K^4] */
  double *heat;                               /* [npatch] absorbed of the others' emission [W] */
  double *gain;                               /* [n] the same at the last state [W] */
  double *slope;                              /* [n] 4 |T|^3 of the last linearisation [K^3] */
  double *made;                               /* [n] emitted over sigma eps of gain [K^4] */
  double *made_inside, *slope_inside;         /* [n] the same of surfaces inside, whose emittance is
                                                 constant; NULL: there are none */
  double *stated;                             /* [n] emission of outer surfaces as the exchange has
                                                 it; system->space has the one now [W/K^4] */
  double *rest;                               /* [n] other emission in system->space [W/K^4] */
  bool strong;                                /* the tangent has the larger areas alone */
  bool fresh;                                 /* gain is of `made` and mix */
  const struct um_thermal_system_exchange *twin; /* of the same areas: its gain serves where it has
                                                    the same `made` and mix; borrowed; NULL */
  double *change, *follow, *warm, *warm_inside;  /* [n] scratch of the tangent */
  double *cluster;                               /* [n] the same, of an eliminated group */
  /* the same of UM_THERMAL_LOT answers side by side, reserved where they are wanted */
  double (*lot)[UM_THERMAL_LOT];                                     /* [n] */
  double (*lot_power4)[UM_THERMAL_LOT], (*lot_heat)[UM_THERMAL_LOT]; /* [npatch] */
  struct um_thermal_thread_tuning tuning;                            /* of the products */
  struct um_thermal_mix mix, held; /* poses at the last state; of the linearisation */
  double t;                        /* [s] of mix; NaN: none yet */
};

/* A part of a node's capacity that goes with temperature. */
struct um_thermal_system_share {
  const struct um_thermal_ratio *ratio; /* of the network; NULL: an unused entry, the last ones */
  const double *content; /* [UM_THERMAL_LAW_TEMPERATURES] its integral, 300 K at 300 K [K] */
  double share;          /* of the capacity stated [1] */
};
struct um_thermal_system_store {
  size_t *start;                         /* [n + 1] shares of a node */
  struct um_thermal_system_share *share; /* [nshare] */
  double *content;                       /* [nlaw][UM_THERMAL_LAW_TEMPERATURES] */
};

/* What a system is made for. */
enum um_thermal_system_kind {
  UM_SYSTEM_RUN,      /* in time, thermostats switch */
  UM_SYSTEM_PERIODIC, /* in time, thermostats by their mean power */
  UM_SYSTEM_STEADY    /* arithmetic nodes are unknowns, capacities 1, thermostats by their mean */
};

struct um_thermal_system {
  struct um_context *context;
  const struct um_thermal_network *network; /* borrowed */
  const struct um_irradiation_loads *loads; /* borrowed, or NULL */
  struct um_thermal_solve_options options;
  double from;   /* origin of the system's own time [s]: keeps the digits of small steps */
  double space4; /* T_space^4 [K^4] */

  size_t n;          /* nodes */
  size_t nunknown;   /* of them integrated */
  uint32_t *node;    /* [nunknown] node of an unknown */
  uint32_t *unknown; /* [n] unknown of a node, or UM_THERMAL_NONE */
  double *capacity;  /* [n] [J/K]; 1 in a steady system */
  double *power;     /* [n] [W] */
  bool *fixed;       /* [n] boundary */

  size_t *start;                               /* [n + 1] rows of the links */
  uint32_t *other;                             /* [nlink] */
  double *linear;                              /* [nlink] [W/K] */
  double *fourth;                              /* [nlink] sigma R [W/K^4] */
  const struct um_thermal_link_law **link_law; /* [nlink] NULL: constant; NULL: all are */
  double *space;       /* [n] sigma R to space at the present state [W/K^4] (system_emission.c) */
  double *space_slope; /* [n] its derivative over the node's temperature [W/K^5]; NULL: 0 */

  struct um_thermal_system_store
      *store;      /* capacities by temperature (system_store.c); NULL: none */
  double *warming; /* [n] dT over the change of a node's unknown [1]; NULL: 1 */

  /* what nodes emit to space under laws, an entry for each law of a node; NULL: no laws */
  const struct um_thermal_surface_law **emission; /* [nemission], borrowed; NULL: an unused entry */
  size_t *emission_start;                         /* [n + 1] entries per node */
  size_t nemission;
  uint32_t *emission_of; /* [3 nsurface] entry of a share, or UM_THERMAL_NONE */
  double *emission_held; /* [n + nemission] sigma R before laws; NULL: space never changes */

  struct um_thermal_cluster *cluster; /* [ncluster] */
  size_t ncluster;

  /* Jacobian d(dT/dt)/dT of the unknowns, compressed columns; pattern fixed */
  int64_t *column; /* [nunknown + 1] */
  int64_t *row;    /* [nnonzero], ascending within a column */
  size_t nnonzero;
  size_t *link_slot; /* [nlink] place of (node, other); only between unknowns */
  size_t *diagonal;  /* [nunknown] */

  /* loads */
  double *grid;                                /* [ntime] loads->t - from [s] */
  size_t row_low, row_high;                    /* rows in force between two stops */
  size_t interval;                             /* last one used */
  size_t smooth_low, smooth_high, smooth_rows; /* last answer of smooth; rows 0: none */
  struct um_thermal_load_near *near;           /* rows that are kept; NULL: none that serve */
  struct um_thermal_load_row load_row[2];
  double *planet; /* [n] workspace of a row [W] */
  double *gas;    /* [n] the same; NULL: none */
  struct um_thermal_load_now now;

  /* heat made inside (system_heat.c) */
  enum um_thermal_system_kind kind;
  struct um_thermal_system_source *source;         /* [nsource] */
  struct um_thermal_system_thermostat *thermostat; /* [nthermostat] */
  size_t nsource, nthermostat;
  double *made;    /* [n] by sources and thermostats at the last state [W]; NULL: there are none */
  double softness; /* of mean thermostats: factor on the width of their transition [1] */

  struct um_thermal_system_exchange *exchange; /* NULL: none (system_exchange.c) */

  /* workspace */
  double *first;       /* [n] at the start [K] */
  double *temperature; /* [n] of the last evaluation [K]; eliminated nodes start from it */
  double *power4;      /* [n] T^4 [K^4] */
  double *cube;        /* [n] |T|^3 [K^3] */
};

/* Heat from node `from` into node `into` through link e [W], at the present state; with cubes as in
 * the Jacobian -dH_into/dT_into and dH_into/dT_from [W/K]. A link by temperature has the slopes of
 * the present state. */
static inline bool um_thermal_system_link_varies(const struct um_thermal_system *system, size_t e)
{
  return system->link_law != NULL && system->link_law[e] != NULL;
}
static inline double um_thermal_system_link_heat(const struct um_thermal_system *system, size_t e,
                                                 size_t into, size_t from)
{
  const double *t = system->temperature, *p = system->power4;
  double out, in;
  if (um_thermal_system_link_varies(system, e))
    return um_thermal_link_law_heat(system->link_law[e], system->linear[e], system->fourth[e],
                                    t[into], t[from], &out, &in);
  return system->linear[e] * (t[from] - t[into]) + system->fourth[e] * (p[from] - p[into]);
}
static inline double um_thermal_system_link_out(const struct um_thermal_system *system, size_t e,
                                                size_t into, size_t from, const double *cube)
{
  double out, in;
  if (!um_thermal_system_link_varies(system, e))
    return system->linear[e] + 4.0 * system->fourth[e] * cube[into];
  um_thermal_link_law_heat(system->link_law[e], system->linear[e], system->fourth[e],
                           system->temperature[into], system->temperature[from], &out, &in);
  return out;
}
static inline double um_thermal_system_link_in(const struct um_thermal_system *system, size_t e,
                                               size_t into, size_t from, const double *cube)
{
  double out, in;
  if (!um_thermal_system_link_varies(system, e))
    return system->linear[e] + 4.0 * system->fourth[e] * cube[from];
  um_thermal_link_law_heat(system->link_law[e], system->linear[e], system->fourth[e],
                           system->temperature[into], system->temperature[from], &out, &in);
  return in;
}

/* loads NULL: none; start NULL: the temperatures of the network. Refuses NaN loads, tables in the
 * wrong order, diffusive nodes without capacity, arithmetic nodes without links. */
enum um_status um_thermal_system_create(struct um_context *context,
                                        const struct um_thermal_network *network,
                                        const struct um_irradiation_loads *loads,
                                        const struct um_thermal_solve_options *options,
                                        const double *start, double from,
                                        enum um_thermal_system_kind kind,
                                        struct um_thermal_system **out);
void um_thermal_system_destroy(struct um_thermal_system **system);

/* system_links.c, cluster.c, jacobian.c, system_loads.c: parts of create. */
enum um_status um_thermal_system_links_build(struct um_thermal_system *system);
enum um_status um_thermal_system_clusters_build(struct um_thermal_system *system);
void um_thermal_system_clusters_destroy(struct um_thermal_system *system);
enum um_status um_thermal_system_pattern_build(struct um_thermal_system *system);
/* The last entry of a column of the pattern whose row is at most this one. */
size_t um_thermal_system_slot(const struct um_thermal_system *system, size_t row, size_t column);
enum um_status um_thermal_system_loads_check(struct um_context *context,
                                             const struct um_thermal_network *network,
                                             const struct um_irradiation_loads *loads,
                                             const struct um_thermal_aging *aging);
enum um_status um_thermal_system_loads_build(struct um_thermal_system *system);
/* system_emission.c. set: space and its slope of node i at its temperature. row: emission_held of a
 * grid row. */
enum um_status um_thermal_system_emission_build(struct um_thermal_system *system);
void um_thermal_system_emission_set(struct um_thermal_system *system, size_t i);
void um_thermal_system_emission_row(const struct um_thermal_system *system, size_t row,
                                    double *held);
/* Derivative of what node i emits to space over its temperature [W/K]; cube as in the Jacobian. */
static inline double um_thermal_system_space_loss(const struct um_thermal_system *system, size_t i,
                                                  const double *cube)
{
  double loss = 4.0 * system->space[i] * cube[i];
  if (system->space_slope == NULL) return loss;
  return loss + system->space_slope[i] * (system->power4[i] - system->space4);
}
enum um_status um_thermal_system_heat_build(struct um_thermal_system *system);
void um_thermal_system_heat_destroy(struct um_thermal_system *system);

/* Only grid rows valid strictly between the two times are used from now on: of rows at the same
 * time (a jump) the last one before, the first one after. [s from `from`] */
void um_thermal_system_window(struct um_thermal_system *system, double begin, double end);
/* Use grid row `row` alone. */
void um_thermal_system_hold(struct um_thermal_system *system, size_t row);
/* Rows of the window that a step may count as one interval, for what the loads are
 * (system_smooth.c); SIZE_MAX: all of it. UM_ERR_MEMORY. */
enum um_status um_thermal_system_smooth(struct um_thermal_system *system, size_t *rows);
/* The same for the rows of power histories (called by both). */
void um_thermal_system_heat_window(struct um_thermal_system *system, double begin, double end);
/* Times at which histories jump or are sampled anew, not sorted; stop NULL: only counts. */
size_t um_thermal_system_heat_stops(const struct um_thermal_system *system, double *stop);
/* Shortest interval of a history with rows between the stops of the window [s]; INFINITY: none. */
double um_thermal_system_heat_interval(const struct um_thermal_system *system);
/* Heat made at t and system->temperature into system->made. */
void um_thermal_system_heat_make(struct um_thermal_system *system, double t);
/* Heat made at t by one power history [W]. */
double um_thermal_source_power(const struct um_thermal_network_source *source, double t);
double um_thermal_thermostat_sensor(const struct um_thermal_network_thermostat *thermostat,
                                    const double *temperature);
/* Switch by the temperatures of the state: at the start by the middle of the band, or, in a run, by
 * the phase that is stated, to which system->temperature of its sensor moves; later where a
 * threshold is passed. */
void um_thermal_system_thermostats_set(struct um_thermal_system *system, bool start);

/* --- system_store.c -------------------------------------------------------------------------- */
/* What is integrated is each unknown's heat content over its stated capacity [K], the temperature
 * where the capacity is constant. */
enum um_status um_thermal_system_store_build(struct um_thermal_system *system);
void um_thermal_system_store_destroy(struct um_thermal_system *system);
/* From a temperature [K] of node i to its unknown and back; warming: dT over its change [1]. */
double um_thermal_system_unknown_of(const struct um_thermal_system *system, size_t i,
                                    double temperature);
double um_thermal_system_temperature_of(const struct um_thermal_system *system, size_t i, double y,
                                        double *warming);
/* dT over the change of an unknown at the present state [1]. */
static inline double um_thermal_system_warming(const struct um_thermal_system *system, size_t i)
{
  return system->warming == NULL ? 1.0 : system->warming[i];
}
/* warming at system->temperature, which was not set by state_set. */
void um_thermal_system_store_at(struct um_thermal_system *system);

/* Loads at t [s from `from`] into system->now. */
void um_thermal_system_loads_at(struct um_thermal_system *system, double t);

/* Put unknowns y[nunknown] and whatever follows from them at time t into system->temperature and
 * its powers. false: the eliminated nodes found no balance. */
bool um_thermal_system_state_set(struct um_thermal_system *system, double t, const double *y);
/* The same for who asks for system->cube and power4 alone: what else stands in the system is not of
 * that state. */
bool um_thermal_system_powers_set(struct um_thermal_system *system, double t, const double *y);
/* T^4 and |T|^3 of system->temperature, and what it emits to space; the odd extension |T|^3 T keeps
 * Newton monotone. Of one node, of all. */
void um_thermal_system_node_powers(struct um_thermal_system *system, size_t i);
void um_thermal_system_powers(struct um_thermal_system *system);
/* Net heat into one node at the present state without its capacity [W]. */
double um_thermal_system_node_heat(const struct um_thermal_system *system, size_t node);
/* dT/dt of the unknowns [K/s], after state_set. */
void um_thermal_system_rate(const struct um_thermal_system *system, double *rate);
/* Values [nnonzero] of the Jacobian [1/s] at system->cube (of the state, or a mean over time). */
bool um_thermal_system_jacobian(struct um_thermal_system *system, double *value);
/* Heat content over unknowns [J], from 0 K. */
double um_thermal_system_content(const struct um_thermal_system *system, const double *y);

/* --- system_exchange.c; all but build and destroy want system->exchange ---------------------- */
enum um_status um_thermal_system_exchange_build(struct um_thermal_system *system);
void um_thermal_system_exchange_destroy(struct um_thermal_system *system);
/* Poses at t [s from `from`]. */
void um_thermal_system_exchange_at(struct um_thermal_system *system, double t);
/* gain at the poses set and system->power4; the largest change of it [W]. */
double um_thermal_system_exchange_make(struct um_thermal_system *system);
/* Take poses and system->cube for the tangent, as the Jacobian takes them at the same moment;
 * strong: the larger exchange areas do, for iterations that correct themselves. */
void um_thermal_system_exchange_hold(struct um_thermal_system *system, bool strong);
/* out[nunknown] += factor times what the Jacobian's pattern leaves out, d(gain_i / C_i)/dT_j x_j
 * [1/s] [K], x[nunknown]. */
void um_thermal_system_exchange_tangent(struct um_thermal_system *system, double factor,
                                        const double *x, double *out);

/* The same of UM_THERMAL_LOT answers, x and out [nunknown]; storage for it. */
enum um_status um_thermal_system_exchange_reserve_lot(struct um_thermal_system *system);
void um_thermal_system_exchange_tangent_lot(struct um_thermal_system *system, double factor,
                                            const double (*x)[UM_THERMAL_LOT],
                                            double (*out)[UM_THERMAL_LOT]);

/* Change of an eliminated node by the last product [K]. */
static inline double um_thermal_system_exchange_followed(const struct um_thermal_system *system,
                                                         size_t node)
{
  return system->exchange->change[node] + system->exchange->follow[node];
}

/* Solve the balance of all clusters, temperatures of the unknowns given. */
bool um_thermal_system_clusters_solve(struct um_thermal_system *system);
/* Factor at system->cube and compute response. */
bool um_thermal_system_cluster_linearize(struct um_thermal_system *system,
                                         struct um_thermal_cluster *cluster);
/* After that: heat into its nodes x[m] [W] becomes their change of temperature [K]. */
void um_thermal_system_cluster_answer(const struct um_thermal_cluster *cluster, double *x);
/* Its nodes are warmer by change[m] [K]: out[nunknown] += factor times what the unknowns that they
 * touch gain [K/s]. */
void um_thermal_system_cluster_pass(const struct um_thermal_system *system,
                                    const struct um_thermal_cluster *cluster, double factor,
                                    const double *change, double *out);

#endif
