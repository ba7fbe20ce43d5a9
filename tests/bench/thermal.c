/* Heat by size: what an integration costs as the mesh grows, error beside time, one thread.
 *
 *   block    a solid that cools to space, 1 m by 0.5 m by 0.25 m in tetrahedra, 700 to 30,000
 *            nodes, 7200 s; the exponent of the time over nodes; CalculiX on the same tetrahedra
 *            at 9,500 and 30,000 nodes, with steps of at most 10 K: its mean temperature is then
 *            2.6 K off, with steps of 0.3 K 0.1 K, in 15 times the time
 *
 *   shell    a box of walls whose six sides differ in emittance and power, 800 to 70,000 nodes,
 *            7200 s from 300 K
 *
 *   self     a body of 1,200 to 49,152 facets that shades and heats itself, 72 instants of one
 * turn; the stages one by one, the most memory, and the largest once more with view factors kept
 * (cached), on both threads, and its repeating state
 *
 * Goals. A tenth of CalculiX's time at equal nodes: it takes a step of order 1 with a factorisation
 * each; ours are of order up to 5 and share factors. Exponents 1.5 for solids and 1.3 for shells:
 * triangular solutions with the factors of nested dissection grow as n^(4/3) and n log n, and are
 * most of the work. Errors: of the mean temperature against the same mesh integrated a thousand
 * times tighter, 1e-3 K. Self: 4 GiB; 5 s for 49,152 facets with mutual radiation, 1.5 s cached.
 * AsteroidThermoPhysicalModels.jl published 4.8 s with self-heating on an M4: not run here. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/bench/asteroid.h"
#include "tests/bench/block.h"
#include "thermal/network/body.h"

#define SOLIDS      5
#define SHELLS      5
#define ERROR       1e-3 /* [K] */
#define PEER_CHANGE 10.0 /* [K] a step of CalculiX */

static const size_t solid_cells[SOLIDS] = {4, 6, 8, 10, 15};
static const double shell_facet[SHELLS] = {0.17, 0.095, 0.054, 0.031, 0.0170}; /* [m] */

/* Exponent of a power law through the points, by least squares of logarithms. */
static double exponent(const double *x, const double *y, size_t n)
{
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (size_t i = 0; i < n; i++) {
    sx += log(x[i]) / (double)n;
    sy += log(y[i]) / (double)n;
  }
  for (size_t i = 0; i < n; i++) {
    sxx += (log(x[i]) - sx) * (log(x[i]) - sx);
    sxy += (log(x[i]) - sx) * (log(y[i]) - sy);
  }
  return sxy / sxx;
}

struct outcome {
  double seconds, mean; /* [s], [K] by capacity */
  size_t steps, factorisations;
};

static struct outcome integrate(const struct bench *bench, const struct um_thermal_network *network,
                                double duration, double tighter)
{
  struct um_thermal_solve_options options;
  struct um_thermal_history *history = NULL;
  um_thermal_solve_defaults(&options);
  options.relative_tolerance /= tighter;
  options.absolute_tolerance /= tighter;
  double begin = bench_wall(), sum = 0.0, total = 0.0;
  bench_must(bench, um_thermal_solve(bench->context, network, NULL, &options, NULL, 0.0, &duration,
                                     1, &history));
  struct outcome out = {bench_wall() - begin, 0.0, history->steps, history->jacobians};
  for (uint32_t i = 0; i < history->nnode; i++) {
    double capacity = um_thermal_network_capacity(network, i);
    sum += capacity * history->temperature[i];
    total += capacity;
  }
  out.mean = sum / total;
  um_thermal_history_destroy(bench->context, &history);
  return out;
}

static void figures(struct bench *bench, const char *name, const struct outcome *usual)
{
  char text[80];
  snprintf(text, sizeof text, "%s: time", name);
  bench_number(bench, text, "s", usual->seconds, NAN, NAN);
  snprintf(text, sizeof text, "%s: steps", name);
  bench_number(bench, text, "1", (double)usual->steps, NAN, NAN);
  snprintf(text, sizeof text, "%s: factorisations", name);
  bench_number(bench, text, "1", (double)usual->factorisations, NAN, NAN);
}

static void error_figure(struct bench *bench, const char *name, double mean, double exact,
                         double goal)
{
  char text[80];
  snprintf(text, sizeof text, "%s: error of the mean temperature", name);
  bench_number(bench, text, "K", fabs(mean - exact), goal, isnan(goal) ? NAN : 1.0);
}

static void peer_figures(struct bench *bench, const char *name, const struct block *block,
                         const struct outcome *own)
{
  char text[80];
  struct block_peer peer = block_calculix(bench, block, PEER_CHANGE);
  if (isnan(peer.seconds)) return;
  snprintf(text, sizeof text, "%s: time, to CalculiX", name);
  bench_number(bench, text, "s", own->seconds, peer.seconds, 0.1);
  snprintf(text, sizeof text, "%s: CalculiX's mean from ours", name);
  bench_number(bench, text, "K", fabs(peer.mean - own->mean), NAN, NAN);
}

static void solids(struct bench *bench)
{
  double n[SOLIDS], seconds[SOLIDS];
  for (size_t i = 0; i < SOLIDS; i++) {
    struct block block;
    char name[40];
    block_create(bench, solid_cells[i], &block);
    struct um_thermal_network *network = block_network(bench, &block);
    struct outcome usual = integrate(bench, network, BLOCK_DURATION, 1.0);
    snprintf(name, sizeof name, "block, %zu nodes", block.nvertex);
    figures(bench, name, &usual);
    if (i < 3)
      error_figure(bench, name, usual.mean, integrate(bench, network, BLOCK_DURATION, 1000.0).mean,
                   ERROR);
    n[i] = (double)block.nvertex;
    seconds[i] = usual.seconds;
    if (i >= 3) peer_figures(bench, name, &block, &usual);
    um_thermal_network_destroy(&network);
    block_free(bench, &block);
  }
  bench_number(bench, "block: exponent of time over nodes", "1", exponent(n, seconds, SOLIDS), 1.5,
               1.0);
}

static void box_build(const struct bench *bench, double facet_size, struct um_geometry **geometry,
                      struct um_thermal_body **body)
{
  static const struct um_geometry_skin skin = {NULL, "wall", NULL};
  const struct um_geometry_part_spec shape = {.name = "box",
                                              .shape = UM_SHAPE_BOX,
                                              .size = {2.0, 1.0, 1.0},
                                              .rotation = {1, 0, 0, 0},
                                              .skins = &skin,
                                              .nskin = 1,
                                              .facet_size = facet_size};
  struct um_thermal_group_spec group[6];
  struct um_thermal_part_spec part = {.kind = UM_THERMAL_SHELL,
                                      .start_temperature = 300.0,
                                      .shell = {4860.0, 1.0, 0.33, INFINITY},
                                      .groups = group};
  bench_must(bench, um_geometry_create(bench->context, &shape, 1, geometry));
  part.ngroup = um_geometry_group_count(*geometry);
  for (uint32_t g = 0; g < part.ngroup && g < 6; g++)
    group[g] = (struct um_thermal_group_spec){
        .group = g, .emittance_front = 0.1 + 0.15 * g, .power = 100.0 * (g % 3)};
  bench_must(bench, um_thermal_body_create(bench->context, *geometry, &part, 1, NULL, 0, body));
}

static void shells(struct bench *bench)
{
  double n[SHELLS], seconds[SHELLS];
  for (size_t i = 0; i < SHELLS; i++) {
    struct um_geometry *geometry = NULL;
    struct um_thermal_body *body = NULL;
    char name[40];
    box_build(bench, shell_facet[i], &geometry, &body);
    struct outcome usual = integrate(bench, body->network, BLOCK_DURATION, 1.0);
    n[i] = (double)um_thermal_network_nodes(body->network);
    seconds[i] = usual.seconds;
    snprintf(name, sizeof name, "shell, %.0f nodes", n[i]);
    figures(bench, name, &usual);
    if (i < 3)
      error_figure(bench, name, usual.mean,
                   integrate(bench, body->network, BLOCK_DURATION, 1000.0).mean, ERROR);
    um_thermal_body_destroy(bench->context, &body);
    um_geometry_destroy(&geometry);
  }
  bench_number(bench, "shell: exponent of time over nodes", "1", exponent(n, seconds, SHELLS), 1.3,
               1.0);
}

static void self_figures(struct bench *bench, const char *name, const struct asteroid_cost *c,
                         double goal)
{
  const double stage[] = {c->sun, c->factors, c->exchange, c->heat};
  static const char *const word[] = {"rays to the Sun", "view factors", "exchange", "heat"};
  char text[80];
  double sum = 0.0;
  for (int k = 0; k < 4; k++) {
    snprintf(text, sizeof text, "%s: %s", name, word[k]);
    bench_number(bench, text, "s", stage[k], NAN, NAN);
    sum += stage[k];
  }
  snprintf(text, sizeof text, "%s: all", name);
  bench_number(bench, text, "s", sum, goal, isnan(goal) ? NAN : 1.0);
}

/* Folder for view factors, emptied by its owner. */
static void self(struct bench *bench)
{
  static const size_t cells[] = {10, 22, 45, 64};
  char folder[BENCH_FOLDER], name[48], command[BENCH_FOLDER + 16];
  size_t turns;
  bench_folder(folder);
  for (int k = 0; k < 4; k++) {
    struct asteroid_cost c = asteroid_run(bench, cells[k], k == 3 ? folder : NULL, 1.0);
    snprintf(name, sizeof name, "self, %zu facets", c.facets);
    self_figures(bench, name, &c, k == 3 ? 5.0 : (double)NAN);
    if (k == 1)
      error_figure(bench, name, c.mean, asteroid_run(bench, cells[k], NULL, 10.0).mean, 0.1);
    if (k < 3) continue;
    bench_number(bench, "self: memory", "bytes", c.memory, 4.294967296e9, 1.0);
    for (int threads = 1; threads <= 2; threads++) {
      um_core_context_set_threads(bench->context, threads);
      c = asteroid_run(bench, cells[k], folder, 1.0);
      snprintf(name, sizeof name, "self, %zu facets, cached, threads %d", c.facets, threads);
      self_figures(bench, name, &c, 1.5);
    }
    um_core_context_set_threads(bench->context, 1);
  }
  double seconds = asteroid_periodic(bench, cells[0], &turns);
  bench_number(bench, "self, 1200 facets: repeating state", "s", seconds, NAN, NAN);
  bench_number(bench, "self, 1200 facets: turns for it", "1", (double)turns, 5.0, 1.0);
  snprintf(command, sizeof command, "rm -r '%s'", folder);
  if (system(command) != 0) fprintf(stderr, "%s stays\n", folder);
}

int main(int argc, char **argv)
{
  struct bench bench;
  const char *only = argc > 2 ? argv[2] : NULL; /* FILE.json self | shell | block */
  bench_begin(&bench, argc > 2 ? 2 : argc, argv, "thermal: heat by size, one thread");
  if (only == NULL || strcmp(only, "self") == 0) self(&bench);
  if (only == NULL || strcmp(only, "shell") == 0) shells(&bench);
  if (only == NULL || strcmp(only, "block") == 0) solids(&bench);
  return bench_end(&bench);
}
