/* From parts to a network: shells and solids by linear finite elements (lumped capacity), MLI,
 * lumps, interiors, contacts. */
#ifndef UMBRA_THERMAL_BODY_H
#define UMBRA_THERMAL_BODY_H

#include "geometry/geometry.h"
#include "thermal/network/course.h"
#include "thermal/network/mli_law.h"
#include "thermal/network/network.h"
#include "thermal/network/solids.h"

struct um_thermal_body;

/* What a wall or solid is made of goes with temperature; the ratios outlive the body. */
struct um_thermal_bulk_law {
  const struct um_thermal_ratio *capacity, *conductivity; /* over those at 300 K; NULL: constant */
  double capacity_slope; /* of the capacity beside that, per K from 300 K [1/K]; 0: none */
};

/* Nodes in the thickness of a wall of two layers, front to back. */
struct um_thermal_core {
  size_t n;
  double *capacity;   /* [n] of each, share of the wall's [1] */
  double *resistance; /* [n + 1] from the front layer to the first, ..., from the last to the back
                         layer, share of the whole [1]; sum 1 */
};

/* A wall: thin sheet with two faces. Capacities are per face node layer.
 * rho c t dT/dt = div(k t grad T) + loads + through (T_other - T). A wall has two layers where both
 * sides radiate: the back of an open part, the inside of a closed one that radiates inside. */
struct um_thermal_shell {
  double areal_heat_capacity; /* of the whole wall [J/m^2/K] */
  double front_share;         /* of it on the front layer [1], default 0.5 (1 when one layer) */
  double conductance; /* k t of the whole wall, in plane [W/K]; split like the layers' capacity */
  double through_conductance;         /* between the layers [W/m^2/K]; INFINITY: one layer */
  const struct um_thermal_core *core; /* what lies between them; outlives the body; NULL: nothing */
  struct um_thermal_bulk_law law;     /* of capacity and in-plane conductance */
};
/* MLI on the outside of a wall, or of an interior when mounted on none: a skin node per facet of
 * areal capacity, coupled to what it wraps by e* sigma (T^4 - T^4), or as a law has it, and through
 * its seams. */
struct um_thermal_mli {
  double effective_emittance; /* e*; at 300 K where it goes with temperature [1] */
  double areal_heat_capacity; /* of the outer layer [J/m^2/K] */
  bool wraps_interior;        /* couples to an interior of the part, and the wall is left out */
  size_t interior;            /* which one of the part's */
  enum um_thermal_mli_law law;
  double conducted;        /* share of e* at 300 K that spacers conduct, under a law [1] */
  double exponent;         /* e* is times (T_m / 300 K)^exponent beside that; 0: it is not */
  double seam_conductance; /* over the blanket's area [W/m^2/K] */
  /* Sheets under the outer layer that store heat, alike, in a row; e* is shared evenly by the gaps
   * on the way in, one more than sheets. 0: the outer layer alone stores heat. */
  size_t sheets;
  double sheet_heat_capacity; /* of all of them [J/m^2/K] */
};
/* Heat of a place over time: linear between rows, equal times are jumps, 0 outside. */
struct um_thermal_power_history {
  double *t, *power; /* [nrow] t_tai [s], [W] */
  size_t nrow;
};
/* What is inside a part: frame, boards, battery; one node. C dT/dt = P + sum G (T_j - T); with C =
 * 0 it balances at every instant (an arithmetic node). */
struct um_thermal_interior_spec {
  const char *name;                               /* of the place "part.NAME" */
  double capacity;                                /* [J/K] */
  double power;                                   /* [W] */
  const struct um_thermal_power_history *history; /* added to it; NULL: none */
  double start;     /* [K] of an isothermal run; 0: that of the part */
  double held;      /* [K] given and kept, whatever flows (a boundary node); 0: it is computed */
  double offset;    /* [K] of its start over the state a run begins with; not for the body */
  double lag;       /* [s] by which a share of capacity and power follows the rest; 0: one node */
  double lag_share; /* [1] of capacity and power */
  /* above 0: it is no node but a solid that fills the part (closed): capacity and power are spread
   * by volume, walls, blankets and contacts meet it where they lie [W/m/K] */
  double conductivity;
  double tetrahedron_size; /* of that solid: longest edge wanted [m]; 0: facet size */
};
/* A thermostat heater on the wall of a place, spread and sensed by area, or in an interior: see
 * um_thermal_network_thermostat_add. */
struct um_thermal_heater {
  const char *place; /* "": all walls of the part; "GROUP", "GROUP.back", "front", "back",
                        "interior" or the name of another; as in contacts */
  double power;      /* [W] */
  double on, off;    /* [K] */
  double phase;      /* where in its cycle a run begins, as there [1]; 0: not stated */
};
#define UM_THERMAL_HEATERS_MAX 16 /* of one part */
/* Power by a course in time, spread over a place as a heater's is; below 0: heat that goes. What
 * has no end, and what repeats, goes on for UM_THERMAL_TIMED_LASTS, and UM_THERMAL_TIMED_TURNS at
 * most. */
struct um_thermal_timed {
  const char *place; /* as of a heater */
  double power;      /* [W] of the course's 1 W */
  struct um_thermal_course course;
};
#define UM_THERMAL_TIMED_MAX   8     /* of one part */
#define UM_THERMAL_TIMED_LASTS 3.2e7 /* [s] a year */
#define UM_THERMAL_TIMED_TURNS 10000 /* [1] */
struct um_thermal_group_spec {
  uint32_t group;                       /* geometry group index */
  const struct um_thermal_shell *shell; /* NULL: the part's */
  const struct um_thermal_mli *mli;     /* NULL: none (front side only) */
  double *interior_conductance; /* [ninterior] [W/K] of the group to each interior; NULL: none */
  double heat_pipe_conductance, heat_pipe_capacity; /* [W/K] wall to vapour, 0: none; [J/K] */
  double power;                                     /* released in the wall [W] */
  const struct um_thermal_power_history *history;   /* added to it; NULL: none */
  double absorptance_front, emittance_front, extraction_front; /* from the material records */
  double absorptance_back, emittance_back, extraction_back;
  const struct um_thermal_surface_law *law_front, *law_back; /* outlive the body; NULL: constant */
  double inside_emittance; /* of the inner face of a part that radiates inside [1] */
};
enum um_thermal_part_kind {
  UM_THERMAL_SHELL,  /* FE shell, vertices shared within the part */
  UM_THERMAL_SOLID,  /* TetGen tetrahedra */
  UM_THERMAL_LUMPED, /* one isothermal node per group and side */
  UM_THERMAL_NODES   /* the nodes and conductors of a network of its own */
};
/* Where a closed part radiates inside, every facet has an inner surface (geometry/inside.h), on its
 * inner layer. It comes blocked, all that it emits comes back: who makes the exchange of the room
 * (um_geometry_inside_add, thermal/exchange/exchange.h) takes that off
 * (um_thermal_network_surface_block). The interior has no surface and takes part by contacts only.
 */
struct um_thermal_part_spec {
  uint32_t part;
  enum um_thermal_part_kind kind;
  bool inside; /* radiates inside; else heat crosses it by conduction, contacts and interior */
  struct um_thermal_shell shell;
  double density, specific_heat, conductivity; /* SOLID */
  struct um_thermal_bulk_law law;              /* SOLID */
  double tetrahedron_size;                     /* SOLID: longest edge wanted [m]; 0: facet size */
  double volume_power;                         /* SOLID: heat made in it, by volume [W] */
  const struct um_thermal_power_history *volume_history; /* added to it; NULL: none */
  /* NODES: a node of the name of each group carries its surfaces ("front" and "back" where the part
   * has one group), one of "GROUP.back" those of its back; all others are interiors of that name,
   * which `interior` lists in the order of the network with what they hold. */
  struct um_thermal_network *network;
  struct um_thermal_interior_spec *interior; /* [ninterior] nodes inside; names differ */
  size_t ninterior;
  struct um_thermal_heater heater[UM_THERMAL_HEATERS_MAX];
  size_t nheater;
  struct um_thermal_timed timed[UM_THERMAL_TIMED_MAX];
  size_t ntimed;
  double start_temperature;                   /* [K] */
  const struct um_thermal_group_spec *groups; /* one for every group of the part */
  size_t ngroup;
  const struct um_thermal_body *like; /* whose tetrahedra serve where they fill the same; NULL */
};
/* a, b: "part", "part.group", "part.group.back", "part.front", "part.back" or the interior
 * "part.NAME". The
 * conductance acts where the two places are nearest (their facets within the smallest gap plus half
 * a facet edge), by area: faces lying on each other exchange all over, a hinge or bracket at the
 * edge next to it. An interior is met everywhere by area. Under MLI the wall is met; where MLI
 * wraps an interior, that interior. Sun-following joints stand at angle 0. See contact.c. */
struct um_thermal_contact {
  const char *a, *b;
  double conductance; /* [W/K] */
  double
      exchange_area; /* [m^2]: sigma times it times T_a^4 - T_b^4 is radiated from a to b; all of
                        both places takes part, wherever they are. One of the two may be above 0 */
};

/* Names of places to report: parts, sides, groups, interiors; see place.c. A surface place is what
 * radiates (the skin where there is MLI); "part.wall" and "part.group.wall" are what lies under it,
 * "part.sheets" and "part.group.sheets" the sheets of MLI between, "part.core" and
 * "part.group.core" what lies between the layers of a wall.
 */
enum um_thermal_place_kind {
  UM_PLACE_PART,       /* all surfaces of a part */
  UM_PLACE_SIDE,       /* its fronts or backs */
  UM_PLACE_WALL,       /* all walls under MLI, inner layers that radiate inside, sheets of MLI, or
                          what lies between the layers */
  UM_PLACE_GROUP,      /* surfaces of one group and side */
  UM_PLACE_GROUP_WALL, /* its wall under MLI, its inner layer, the sheets of its MLI, its core */
  UM_PLACE_INTERIOR
};
struct um_thermal_place {
  enum um_thermal_place_kind kind;
  char *name;     /* "bus", "bus.+x", "solar_array.front", "bus.interior" */
  uint32_t *node; /* [nnode] */
  double *weight; /* [nnode], sum 1: area (surface places) or capacity (interior) */
  size_t nnode;
  double area; /* [m^2] of a surface place or its wall; 0: an interior */
};
struct um_thermal_body {
  struct um_thermal_network *network;
  struct um_thermal_place *place;
  size_t nplace;
  struct um_thermal_solid *solid;
  size_t nsolid;
  size_t ntetrahedron; /* of all solids */
};
/* Name of the node of a network that carries a side of a group: "GROUP", "GROUP.back", for the only
 * group of its part also "front", "back". (size_t)-1: there is none; a back without one lies on the
 * node of the front. */
size_t um_thermal_body_group_node(const struct um_geometry *geometry,
                                  const struct um_thermal_network *network, uint32_t group,
                                  bool back);
/* UM_ERR_INPUT: a part or group without spec or with two, a value out of range, MLI or conductance
 * to an interior that is not there, interiors of one name, heat in a wall that is not there, an
 * inside without walls all around, an unknown place in a contact; and what TetGen's wrapper
 * refuses. specs and contacts are borrowed for the call. */
enum um_status um_thermal_body_create(struct um_context *context,
                                      const struct um_geometry *geometry,
                                      const struct um_thermal_part_spec *parts, size_t npart,
                                      const struct um_thermal_contact *contacts, size_t ncontact,
                                      struct um_thermal_body **out);
void um_thermal_body_destroy(struct um_context *context, struct um_thermal_body **body);
/* (size_t)-1 when there is none. */
size_t um_thermal_body_place_find(const struct um_thermal_body *body, const char *name);

#endif
