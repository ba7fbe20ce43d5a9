/* Private to thermal/: what a network holds while it is being built. */
#ifndef UMBRA_THERMAL_NETWORK_IMPL_H
#define UMBRA_THERMAL_NETWORK_IMPL_H

#include "thermal/network.h"

struct um_thermal_link {
  uint32_t a, b; /* nodes; of a radiator b may be UM_THERMAL_SPACE */
  double value;  /* [W/K] or [m^2] */
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
};

/* "node 'name'", "node 12 of part 'bus'" or "node 12", for messages; written into text. */
const char *um_thermal_network_label(const struct um_thermal_network *network, uint32_t node,
                                     char *text, size_t size);

#endif
