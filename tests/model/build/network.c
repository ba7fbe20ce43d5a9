/* A part that is stated as nodes and conductors in two tables: the same satellite as its lumped
 * walls, and what is refused, with file and line. The satellite of tests/effects/heat_help.h. */
#include <stdlib.h>

#include "tests/effects/heat_help.h"
#include "thermal/network/body.h"

#define FILE_NAME  "network-scenario.yaml"
#define NODES      "network-nodes.csv"
#define CONDUCTORS "network-conductors.csv"

#define SHAPE                                                                                      \
  "parts.bus={name: bus, box: {size_m: [1, 1, 1]}, pose: {position_m: [-2, 0, 0]}, outside: "      \
  "grey_white, "
#define LUMPED                                                                                     \
  SHAPE                                                                                            \
  "lumped: true, shell: {areal_heat_capacity_J_m2_K: 5000}, interior: {capacity_J_K: 2e4, "        \
  "power_W: 20, conductance_W_K: 6}, interiors: {room: {temperature_K: 293}}, groups: {+x: "       \
  "{conductances_W_K: {room: 0.5}}}}"
#define NETWORK SHAPE "network: {nodes: " NODES ", conductors: " CONDUCTORS "}}"

#define HEADER "name,kind,capacity_J_K,T0_K,power_W\n"
#define SIDES                                                                                      \
  "+x,diffusive,5000,280,\n-x,diffusive,5000,280,\n+y,diffusive,5000,280,\n-y,diffusive,5000,"     \
  "280,\n+z,diffusive,5000,280,\n-z,diffusive,5000,280,\n"
#define INSIDE "interior,diffusive,2e4,280,20\nroom,boundary,,293,\n"
#define LINKS                                                                                      \
  "kind,a,b,value\nGL,interior,+x,1\nGL,interior,-x,1\nGL,interior,+y,1\nGL,interior,-y,1\n"       \
  "GL,interior,+z,1\nGL,interior,-z,1\nGL,room,+x,0.5\n"

static void put(const char *name, const char *text)
{
  FILE *file = fopen(name, "w");
  assert_non_null(file);
  fputs(text, file);
  assert_int_equal(fclose(file), 0);
}

static const char *const places[] = {"bus.+x",       "bus.-x",   "bus.+y",      "bus.-z",
                                     "bus.interior", "bus.room", "panel.front", "panel.back"};

static void same(const struct heat_run *a, const struct heat_run *b)
{
  for (size_t k = 0; k < a->result->nobs; k++)
    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++)
      heat_close(places[i], heat_temperature(b, places[i], k), heat_temperature(a, places[i], k),
                 1e-12);
}

/* Nodes and conductors with the numbers of the walls: steady, and cooling in the dark from the 280
 * K that the tables state; the contact with the panel and what changes the surfaces act alike. */
static void tables_are_the_lumped_walls(void **state)
{
  (void)state;
  const char *const dark[] = {"orbit={fixed: {position_gcrs_km: [-7000, 0, 0]}}",
                              "thermal.start=isothermal", "thermal.orbits_before=0",
                              "thermal.start_temperature_K=280"};
  put(NODES, HEADER SIDES INSIDE);
  put(CONDUCTORS, LINKS);
  struct heat_run steady[] = {heat_compute(LIST(LUMPED), NONE, NONE),
                              heat_compute(LIST(NETWORK), NONE, NONE)};
  struct heat_run cooling[] = {
      heat_compute(LIST(LUMPED, dark[0], dark[1], dark[2], dark[3]), NONE, NONE),
      heat_compute(LIST(NETWORK, dark[0], dark[1], dark[2], "thermal.start_temperature_K=250",
                        "parts.panel.start_temperature_K=280"),
                   NONE, NONE)};
  struct heat_run white[] = {
      heat_compute(LIST(LUMPED), LIST("solar_absorptance:grey_white,shift=0.2"), NONE),
      heat_compute(LIST(NETWORK), LIST("solar_absorptance:grey_white,shift=0.2"), NONE)};
  same(&steady[0], &steady[1]);
  same(&cooling[0], &cooling[1]);
  same(&white[0], &white[1]);
  assert_true(heat_same_band(&steady[0], &steady[1], "vis"));
  assert_true(280.0 - heat_temperature(&cooling[1], "bus.-x", 1) > 1.0);
  for (int i = 0; i < 2; i++) {
    heat_release(&steady[i]);
    heat_release(&cooling[i]);
    heat_release(&white[i]);
  }
}

/* The same from one file of ESATAN, nodes by label; `room` is held. */
static void esatan_is_the_tables(void **state)
{
  (void)state;
  put(NODES, HEADER SIDES INSIDE);
  put(CONDUCTORS, LINKS);
  put("network.d", "$MODEL BUS\n$LOCALS\nT0 = 6.85; C0 = 5000;\n$NODES\n"
                   "D1 = '+x', T = T0, C = C0; D2 = '-x', T = T0, C = C0;\n"
                   "D3 = '+y', T = T0, C = C0; D4 = '-y', T = T0, C = C0;\n"
                   "D5 = '+z', T = T0, C = C0; D6 = '-z', T = T0, C = C0;\n"
                   "D7 = 'interior', T = T0, C = 2E4, QI = 20;\nB8 = 'room', T = 19.85;\n"
                   "$CONDUCTORS\nGL(7,1) = 1; GL(7,2) = 1; GL(7,3) = 1; GL(7,4) = 1;\n"
                   "GL(7,5) = 1; GL(7,6) = 1; GL(8,1) = 0.5;\n$ENDMODEL\n");
  struct heat_run tables = heat_compute(LIST(NETWORK), NONE, NONE);
  struct heat_run esatan = heat_compute(LIST(SHAPE "network: {nodes: network.d}}"), NONE, NONE);
  same(&tables, &esatan);
  heat_release(&tables);
  heat_release(&esatan);
  assert_int_equal(remove("network.d"), 0);
}

/* A plate of two sides as nodes "front" and "back", or by its group's name with one node for both;
 * a radiative conductance inside: docs/physics/conduction.md's panel has U = 50 W/m2/K through it.
 */
static void two_sides(void **state)
{
  (void)state;
  static const char plate[] =
      "parts.panel={name: panel, plate: {size_m: [2, 1]}, pose: {rotation_deg: [0, 90, 0]}, "
      "front: grey_panel, back: grey_white, network: {nodes: " NODES ", conductors: " CONDUCTORS
      "}}";
  put(NODES, HEADER "front,diffusive,3000,280,\nback,diffusive,3000,280,\nhub,arithmetic,,280,\n");
  put(CONDUCTORS, "kind,a,b,value\nGL,front,back,100\nGR,hub,front,0.1\nGR,hub,space,0.02\n");
  struct heat_run walls = heat_compute(LIST("contacts=[]"), NONE, NONE);
  struct heat_run run = heat_compute(LIST(plate, "contacts=[]"), NONE, NONE);
  double front = heat_temperature(&run, "panel.front", 0),
         hub = heat_temperature(&run, "panel.hub", 0);
  double space = run.model->scenario->thermal->space_temperature_K;
  /* 0.1 (T_f^4 - T^4) = 0.02 (T^4 - T_space^4) */
  heat_close("hub", pow(hub, 4), (0.1 * pow(front, 4) + 0.02 * pow(space, 4)) / 0.12, 1e-8);
  assert_true(front < heat_temperature(&walls, "panel.front", 0) - 0.1);
  put(CONDUCTORS, "kind,a,b,value\nGL,front,back,100\nGL,hub,front,1\n");
  struct heat_run idle = heat_compute(LIST(plate, "contacts=[]"), NONE, NONE);
  heat_close("front", heat_temperature(&idle, "panel.front", 0),
             heat_temperature(&walls, "panel.front", 0), 1e-9);
  heat_close("back", heat_temperature(&idle, "panel.back", 0),
             heat_temperature(&walls, "panel.back", 0), 1e-9);
  heat_release(&walls);
  heat_release(&run);
  heat_release(&idle);
}

static void what_is_refused(void **state)
{
  (void)state;
  static const struct {
    const char *bus, *nodes, *conductors, *says[2];
  } rows[] = {
      {NETWORK,
       HEADER "+x,diffusive,5000,280,\n",
       LINKS,
       {CONDUCTORS ":2: column 'a': ", "'interior' is not a node"}},
      {NETWORK,
       HEADER "+x,diffusive,5000,280,\n",
       "kind,a,b,value\n",
       {"parts.bus.network: ", NODES ": no node '-x', which is a group of the part 'bus'"}},
      {NETWORK,
       HEADER SIDES "a.b,diffusive,5,280,\n",
       "kind,a,b,value\n",
       {NODES ":8: column 'name': 'a.b' is no group of the part", "accepted: a group, GROUP.back"}},
      {NETWORK,
       HEADER SIDES "wall,diffusive,5,280,\n",
       "kind,a,b,value\n",
       {NODES ":8: column 'name': 'wall' is a side of the part", "accepted: its groups"}},
      {NETWORK,
       HEADER SIDES "+x.back,diffusive,5,280,\n",
       "kind,a,b,value\n",
       {NODES ":8: column 'name': '+x.back' is the back of a group that has none", "accepted"}},
      {NETWORK,
       HEADER SIDES "hub,diffusive,5,0,\n",
       "kind,a,b,value\n",
       {NODES ":8: column 'name': 'hub' begins at 0 K", "accepted: above 0 K"}},
      {NETWORK,
       HEADER SIDES "hub,difusive,5,280,\n",
       "kind,a,b,value\n",
       {NODES ":8: column 'kind': 'difusive'", "accepted: diffusive, arithmetic, boundary"}},
      {NETWORK,
       HEADER SIDES "hub,arithmetic,,280,\n",
       "kind,a,b,value\n",
       {"node 'bus.hub' has no steady temperature", "nothing conducts or radiates from it"}},
      {SHAPE "lumped: true, network: {nodes: " NODES ", conductors: " CONDUCTORS "}}",
       HEADER SIDES,
       "kind,a,b,value\n",
       {"parts.bus.lumped: beside network", "accepted: one of the two"}},
      {SHAPE "groups: {+x: {mli: {effective_emittance: 0.1, areal_heat_capacity_J_m2_K: 9}}}, "
             "network: {nodes: " NODES ", conductors: " CONDUCTORS "}}",
       HEADER SIDES,
       "kind,a,b,value\n",
       {"parts.bus.groups.+x.mli: beside network", "accepted: power_W"}},
  };
  for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
    char message[1024];
    put(NODES, rows[i].nodes);
    put(CONDUCTORS, rows[i].conductors);
    heat_refused(LIST(rows[i].bus), NONE, message, sizeof message);
    for (int k = 0; k < 2; k++)
      if (strstr(message, rows[i].says[k]) == NULL)
        fail_msg("%zu: '%s' is not in '%s'", i, rows[i].says[k], message);
  }
}

static int setup(void **state)
{
  (void)state;
  return heat_setup(FILE_NAME);
}
static int teardown(void **state)
{
  (void)state;
  remove(NODES);
  remove(CONDUCTORS);
  return heat_teardown();
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(tables_are_the_lumped_walls), cmocka_unit_test(esatan_is_the_tables),
      cmocka_unit_test(two_sides), cmocka_unit_test(what_is_refused)};
  return cmocka_run_group_tests(tests, setup, teardown);
}
