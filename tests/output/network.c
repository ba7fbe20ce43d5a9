/* The heat balance of a scenario as a network: read again from each of its files and solved, it has
 * the temperatures of the balance that it was made of. */
#include "output/network.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/core/constants.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/balance.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/in_folder.h"
#include "thermal/solver/solve.h"

#define SAME 1e-6 /* [K] */

#define HEAD                                                                                       \
  "schema: 1\nname: s\n"                                                                           \
  "time: {start_utc: 2016-09-06T18:08:00Z, stop_utc: 2016-09-06T18:12:00Z, step_s: 60}\n"          \
  "observer:\n  station: {latitude_deg: 47.067, longitude_deg: 15.493, height_m: 495}\n"

#define ORBIT                                                                                      \
  "orbit: {kepler: {epoch_utc: 2016-09-06T18:00:00Z, a_km: 7143, e: 0.001, i_deg: 98.3, "          \
  "raan_deg: 300, argp_deg: 80, mean_anomaly_deg: 10}}\nattitude: [{lvlh: {}}]\n"                  \
  "thermal: {start: periodic}\n"
#define FIXED                                                                                      \
  "orbit: {fixed: {position_gcrs_km: [-7000, 0, 0]}}\nattitude: [{fixed: {q_gcrs: [1, 0, 0, "      \
  "0]}}]\n"

/* Lumps with an interior that a heater holds, MLI by a law of temperature. */
#define LUMPS                                                                                      \
  "parts:\n  - {name: box, box: {size_m: [1, 1, 1]}, outside: grey_white, lumped: true,\n"         \
  "     shell: {areal_heat_capacity_J_m2_K: 3000}, interior: {capacity_J_K: 2e4, power_W: 20,\n"   \
  "     conductance_W_K: 2}, mli: {law: doenecke, areal_heat_capacity_J_m2_K: 30}}\n"              \
  "effects:\n  - {effect: heater, target: box.interior, power_W: 200, on_K: 293, band_K: 2}\n"

/* Walls of finite elements that radiate to each other, outside and inside, and conduct. */
#define WALL "facet_size_m: 0.6, shell: {areal_heat_capacity_J_m2_K: 3000, conductance_W_K: 0.2}"
#define WALLS                                                                                      \
  "parts:\n  - {name: box, box: {size_m: [1, 1, 1]}, outside: grey_white, inside_emittance: "      \
  "0.8,\n"                                                                                         \
  "     " WALL ", interior: {capacity_J_K: 2e4, power_W: 30, conductance_W_K: 3}}\n"               \
  "  - {name: wing, plate: {size_m: [1, 2]}, pose: {position_m: [1.2, 0, 0]}, front: grey_panel,"  \
  "\n     back: grey_white, " WALL "}\n"

/* The same with emittances that depend on temperature, on other triangles. */
#define RECORDS                                                                                    \
  "parts:\n  - {name: box, box: {size_m: [1, 1, 0.2]}, outside: osr, facet_size_m: 0.5,\n"         \
  "     shell: {areal_heat_capacity_J_m2_K: 3000, conductance_W_K: 0.2},\n"                        \
  "     interior: {capacity_J_K: 2e4, power_W: 300, conductance_W_K: 3}}\n"                        \
  "  - {name: wing, plate: {size_m: [1, 2]}, pose: {position_m: [1.2, 0, 0]}, front: mli_kapton,"  \
  "\n     back: white_paint, " WALL "}\n"

static struct um_model *model_of(const char *text)
{
  struct um_model *model;
  FILE *file = fopen("s.yaml", "w");
  assert_non_null(file);
  fputs(text, file);
  assert_int_equal(fclose(file), 0);
  if (um_model_create(context, "s.yaml", NULL, &model) != UM_OK)
    fail_msg("%s", um_core_message(context));
  remove("s.yaml");
  return model;
}

static struct um_thermal_network *export_network(const char *text, double **balance, size_t *n)
{
  struct um_model *model = model_of(text);
  struct um_model_tables *tables = NULL;
  struct um_thermal_network *flat = NULL;
  struct um_core_folder *folder = NULL;
  if (um_model_precompute(context, model, &tables) != UM_OK ||
      um_model_balance_network(context, model, tables, &flat) != UM_OK ||
      um_core_folder_begin(context, "net", false, &folder) != UM_OK ||
      um_output_write_network(context, model, flat, folder) != UM_OK ||
      um_core_folder_commit(context, &folder) != UM_OK)
    fail_msg("%s", um_core_message(context));
  *n = um_thermal_network_nodes(model->body->network);
  *balance = calloc(*n, sizeof **balance);
  enum um_status status = strstr(text, "fixed") != NULL
                              ? um_model_balance_steady(context, model, tables, *balance)
                              : um_model_balance_orbit(context, model, tables, *balance);
  if (status != UM_OK) fail_msg("%s", um_core_message(context));
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
  return flat;
}

/* Solved from 280 K everywhere, so that nothing of the answer is in the start. */
static void expect(const char *what, struct um_thermal_network *network, double space,
                   const double *balance, size_t n)
{
  struct um_thermal_solve_options options;
  um_thermal_solve_defaults(&options);
  options.space_temperature = space;
  size_t all = um_thermal_network_nodes(network);
  double *t = calloc(all, sizeof *t), *start = calloc(all, sizeof *start), worst = 0.0;
  assert_true(all >= n);
  for (uint32_t i = 0; i < all; i++)
    start[i] = um_thermal_network_kind(network, i) == UM_NODE_BOUNDARY
                   ? um_thermal_network_temperature(network, i)
                   : 280.0;
  if (um_thermal_solve_steady(context, network, NULL, 0, &options, start, t) != UM_OK)
    fail_msg("%s: %s", what, um_core_message(context));
  for (size_t i = 0; i < n; i++) worst = fmax(worst, fabs(t[i] - balance[i]));
  if (!(worst < SAME)) fail_msg("%s: a node is off by %g K", what, worst);
  free(t);
  free(start);
}

/* The next number of a line. */
static double next(char **at)
{
  double value = strtod(*at, at);
  *at += strspn(*at, ", ");
  return value;
}

/* SINDA's file, read as its manual says and no more. */
static struct um_thermal_network *read_sinda(const char *path)
{
  struct um_thermal_network *network = NULL;
  char line[400], block = ' ';
  uint32_t index;
  FILE *file = fopen(path, "r");
  assert_non_null(file);
  assert_int_equal(um_thermal_network_create(context, &network), UM_OK);
  while (fgets(line, sizeof line, file) != NULL) {
    if (strncmp(line, "HEADER ", 7) == 0 && strstr(line, "DATA, UMBRA") != NULL) {
      block = line[7];
      continue;
    }
    if (strncmp(line, "HEADER ", 7) == 0) block = ' ';
    if (block == ' ') continue;
    char *at = line + strspn(line, " ");
    double first = next(&at), second = next(&at), third = block == 'S' ? 0.0 : next(&at);
    enum um_status status = UM_OK;
    if (block == 'N')
      status = um_thermal_network_node_add(network, NULL,
                                           first < 0.0   ? UM_NODE_BOUNDARY
                                           : third < 0.0 ? UM_NODE_ARITHMETIC
                                                         : UM_NODE_DIFFUSIVE,
                                           fmax(third, 0.0), second, 0.0, &index);
    if (block == 'C' && first > 0.0)
      status = um_thermal_network_conductor_add(network, (uint32_t)second - 1, (uint32_t)third - 1,
                                                next(&at));
    if (block == 'C' && first < 0.0)
      status = um_thermal_network_radiator_add(network, (uint32_t)second - 1, (uint32_t)third - 1,
                                               next(&at));
    if (block == 'S') um_thermal_network_power_add(network, (uint32_t)first - 1, second);
    assert_int_equal(status, UM_OK);
  }
  fclose(file);
  return network;
}

static void test_same_balance(void **state)
{
  (void)state;
  static const char *const scenarios[] = {HEAD ORBIT LUMPS, HEAD ORBIT WALLS, HEAD FIXED WALLS,
                                          HEAD ORBIT RECORDS};
  for (size_t i = 0; i < sizeof scenarios / sizeof *scenarios; i++) {
    double *balance;
    size_t n;
    struct um_thermal_network *flat = export_network(scenarios[i], &balance, &n), *read[3];
    if (um_thermal_network_read(context, "net/network.d", NULL, &read[0]) != UM_OK ||
        um_thermal_network_read(context, "net/nodes.csv", "net/conductors.csv", &read[1]) != UM_OK)
      fail_msg("%s", um_core_message(context));
    read[2] = read_sinda("net/network.inp");
    expect("the network", flat, UM_SPACE_TEMPERATURE, balance, n);
    expect("ESATAN", read[0], 0.0, balance, n);
    expect("tables", read[1], UM_SPACE_TEMPERATURE, balance, n);
    expect("SINDA", read[2], 0.0, balance, n);
    for (int k = 0; k < 3; k++) um_thermal_network_destroy(&read[k]);
    um_thermal_network_destroy(&flat);
    free(balance);
    static const char *const files[] = {"net/network.d", "net/network.inp", "net/nodes.csv",
                                        "net/conductors.csv", "net/.umbra"};
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) remove(files[k]);
    rmdir("net");
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_same_balance)};
  return cmocka_run_group_tests(tests, folder_enter, folder_leave);
}
