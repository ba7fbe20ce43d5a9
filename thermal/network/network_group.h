/* Private to the rooms of thermal/: what a network holds while it is being built. */
#ifndef UMBRA_THERMAL_NETWORK_GROUP_H
#define UMBRA_THERMAL_NETWORK_GROUP_H

#include "thermal/network/network.h"

struct um_thermal_link {
  uint32_t a, b; /* nodes; of a radiator b may be UM_THERMAL_SPACE */
  double value;  /* [W/K] or [m^2] */
  uint32_t law;  /* of the network's link laws, or UM_THERMAL_NO_LAW */
};

struct um_thermal_network_node {
  char *name; /* NULL for the nodes of a field */
  enum um_thermal_node_kind kind;
  double capacity;    /* [J/K] */
  double temperature; /* [K] */
  double power;       /* [W] */
};

/* Owned copies of what network.h describes. */
struct um_thermal_spread {
  uint32_t *node; /* [n] */
  double *weight; /* [n] */
  size_t n;
};
struct um_thermal_network_source {
  struct um_thermal_spread at;
  double *t, *power; /* [nrow] [s], [W] */
  size_t nrow;
  bool stepwise;
};
struct um_thermal_network_thermostat {
  struct um_thermal_spread at, sensor;
  double power, on, off; /* [W], [K], [K] */
  enum um_thermal_thermostat_start start;
  double phase; /* [1], 0: not stated */
};

/* What of a node's capacity goes with temperature. */
struct um_thermal_store {
  uint32_t node, law; /* of the network's capacity laws */
  double capacity;    /* at 300 K [J/K] */
};

/* Nodes from `first` on, up to the next section, belong to a part. */
struct um_thermal_section {
  char *name;
  uint32_t first;
};

struct um_thermal_network {
  struct um_context *context;
  struct um_thermal_section *section; /* [nsection] */
  size_t nsection;
  struct um_thermal_network_node *node; /* [nnode] */
  struct um_thermal_link *conductor;    /* [nconductor], duplicates add */
  struct um_thermal_link *radiator;     /* [nradiator], duplicates add */
  struct um_thermal_surface *surface;   /* [nsurface] */
  bool *attached;                       /* [nsurface] */
  size_t nnode, nconductor, nradiator, nsurface;
  size_t noutside; /* surfaces that loads are for: those behind are inside */
  size_t node_room, conductor_room, radiator_room, surface_room; /* allocated */
  struct um_thermal_network_source *source;                      /* [nsource] */
  struct um_thermal_network_thermostat *thermostat;              /* [nthermostat] */
  size_t nsource, nthermostat;
  struct um_thermal_link_law *link_law;   /* [nlink_law] */
  struct um_thermal_ratio **link_table;   /* [nlink_law] their tables, owned, or NULL */
  struct um_thermal_ratio **capacity_law; /* [ncapacity_law] owned */
  struct um_thermal_store *store;         /* [nstore] */
  size_t nlink_law, ncapacity_law, nstore, store_room;
};

/* network_law.c */
void um_thermal_network_laws_free(struct um_thermal_network *network);
bool um_thermal_network_laws_equal(const struct um_thermal_network *a,
                                   const struct um_thermal_network *b);

/* network.c: room for one more of `size` bytes in *block. */
enum um_status um_thermal_network_grow(struct um_context *context, void *block, size_t count,
                                       size_t *room, size_t size);

/* "node 'name'", "node 12 of part 'bus'" or "node 12", for messages; written into text. */
const char *um_thermal_network_label(const struct um_thermal_network *network, uint32_t node,
                                     char *text, size_t size);

/* Do two surfaces on the same nodes take the same of sunlight, of every load? network_equal.c. */
bool um_thermal_surface_sunlight_equal(const struct um_thermal_surface *a,
                                       const struct um_thermal_surface *b);
bool um_thermal_surface_loads_equal(const struct um_thermal_surface *a,
                                    const struct um_thermal_surface *b);

#endif
