/* See asteroid.h. The ball is a cube of cells^2 squares a side, in two triangles each, drawn out to
 * radii of 400 m (1 + 0.12 sin(4 x) sin(5 y) cos(3 z)), x to z of the unit vector: it has valleys
 * that shade and heat themselves. It turns in 7.6 h, its skin of 13 kJ/m2/K does not conduct along
 * it; Sun at 1 au, 30 deg from the equator. */
#include "tests/bench/asteroid.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <unistd.h>

#include "base/core/constants.h"
#include "thermal/exchange/exchange.h"
#include "thermal/loads/loads.h"
#include "thermal/network/body.h"
#include "thermal/solver/solve.h"

#define RADIUS  400.0
#define PERIOD  (7.6 * 3600.0)
#define STEPS   72
#define PATCHES 512

struct body {
  struct um_geometry *geometry;
  struct um_thermal_body *thermal;
  struct um_irradiation_loads *loads;
  struct um_geometry_view_factor_table *table;
  struct um_thermal_exchange *exchange;
  struct um_thermal_solve_options options;
};

/* Corner (i, j) of a side of the cube. */
static struct um_vec3 corner_of(int side, size_t i, size_t j, size_t cells)
{
  double u = tan(0.25 * UM_PI * (2.0 * (double)i / (double)cells - 1.0));
  double v = tan(0.25 * UM_PI * (2.0 * (double)j / (double)cells - 1.0));
  double s = side % 2 == 0 ? 1.0 : -1.0, c[3];
  c[side / 2] = s;
  c[(side / 2 + 1) % 3] = s * u;
  c[(side / 2 + 2) % 3] = v;
  struct um_vec3 d = um_vec3_unit(um_vec3(c[0], c[1], c[2]));
  return um_vec3_scale(d, RADIUS * (1.0 + 0.12 * sin(4.0 * d.x) * sin(5.0 * d.y) * cos(3.0 * d.z)));
}

static void write_obj(const struct bench *bench, size_t cells, const char *path)
{
  FILE *f = fopen(path, "w");
  if (f == NULL)
    bench_must(bench, um_core_fail(bench->context, UM_ERR_INPUT, "%s cannot be written", path));
  for (int side = 0; side < 6; side++)
    for (size_t j = 0; j <= cells; j++)
      for (size_t i = 0; i <= cells; i++) {
        struct um_vec3 p = corner_of(side, i, j, cells);
        fprintf(f, "v %.9g %.9g %.9g\n", p.x, p.y, p.z);
      }
  for (size_t side = 0; side < 6; side++)
    for (size_t j = 0; j < cells; j++)
      for (size_t i = 0; i < cells; i++) {
        size_t a = side * (cells + 1) * (cells + 1) + j * (cells + 1) + i + 1, b = a + cells + 1;
        fprintf(f, "f %zu %zu %zu\nf %zu %zu %zu\n", a, a + 1, b + 1, a, b + 1, b);
      }
  fclose(f);
}

static void body_make(const struct bench *bench, size_t cells, struct body *b)
{
  static const struct um_geometry_skin skin = {NULL, "regolith", NULL};
  char folder[BENCH_FOLDER], path[BENCH_FOLDER + 16];
  bench_folder(folder);
  snprintf(path, sizeof path, "%s/body.obj", folder);
  write_obj(bench, cells, path);
  const struct um_geometry_part_spec shape = {.name = "body",
                                              .shape = UM_SHAPE_MESH,
                                              .mesh_path = path,
                                              .rotation = {1, 0, 0, 0},
                                              .skins = &skin,
                                              .nskin = 1};
  enum um_status status = um_geometry_create(bench->context, &shape, 1, &b->geometry);
  unlink(path);
  rmdir(folder);
  bench_must(bench, status);
  struct um_thermal_group_spec group = {
      .group = 0, .absorptance_front = 0.95, .emittance_front = 0.9};
  const struct um_thermal_part_spec part = {.kind = UM_THERMAL_SHELL,
                                            .start_temperature = 280.0,
                                            .shell = {13000.0, 1.0, 0.0, INFINITY},
                                            .groups = &group,
                                            .ngroup = 1};
  bench_must(bench,
             um_thermal_body_create(bench->context, b->geometry, &part, 1, NULL, 0, &b->thermal));
  um_thermal_solve_defaults(&b->options);
  b->options.relative_tolerance = 1e-5; /* of thermal.accuracy_K 0.1 */
  b->options.absolute_tolerance = 1e-3;
}

static void sun_trace(const struct bench *bench, struct body *b)
{
  struct um_environment environment;
  struct um_environment_sample sample[STEPS + 1];
  um_environment_defaults(&environment);
  environment.shadow = UM_SHADOW_NONE;
  environment.albedo = environment.outgoing_longwave = environment.brightness_temperature = 0.0;
  for (int k = 0; k <= STEPS; k++) {
    double turn = 2.0 * UM_PI * k / STEPS, tilt = UM_PI / 6.0;
    sample[k] = (struct um_environment_sample){
        .t_tai = PERIOD * k / STEPS,
        .r = {UM_AU, 0.0, 0.0},
        .sun = {cos(tilt) * cos(turn), cos(tilt) * sin(turn), sin(tilt)},
        .sun_distance = UM_AU,
        .pole = {0.0, 0.0, 1.0},
        .greenwich = {1.0, 0.0, 0.0},
        .sunlit_fraction = 1.0,
        .q = {1.0, 0.0, 0.0, 0.0}};
  }
  bench_must(bench, um_irradiation_loads_trace(bench->context, b->geometry, &environment, sample,
                                               STEPS + 1, NULL, 0, 1, &b->loads));
}

static void factors_make(const struct bench *bench, const char *cache, struct body *b)
{
  struct um_geometry_view_factor_options options;
  um_geometry_view_factor_defaults(&options);
  options.cache = cache;
  bench_must(bench, um_geometry_view_factor_table_create(bench->context, b->geometry, NULL, 1,
                                                         PATCHES, &options, &b->table));
}

static void exchange_make(const struct bench *bench, struct body *b)
{
  const struct um_thermal_exchange_options both = {.infrared = true, .solar = true};
  bench_must(bench, um_thermal_exchange_create(bench->context, b->thermal->network, b->loads,
                                               b->table, &both, &b->exchange));
  b->options.exchange = b->exchange;
}

static void body_free(const struct bench *bench, struct body *b)
{
  um_thermal_exchange_destroy(bench->context, &b->exchange);
  um_geometry_view_factor_table_destroy(bench->context, &b->table);
  um_irradiation_loads_destroy(bench->context, &b->loads);
  um_thermal_body_destroy(bench->context, &b->thermal);
  um_geometry_destroy(&b->geometry);
}

static double turn_follow(const struct bench *bench, const struct body *b, size_t *steps)
{
  struct um_thermal_history *history = NULL;
  double sum = 0.0, capacity = 0.0;
  bench_must(bench, um_thermal_solve(bench->context, b->thermal->network, b->loads, &b->options,
                                     NULL, 0.0, b->loads->t + 1, STEPS, &history));
  const double *t = history->temperature + (STEPS - 1) * history->nnode;
  for (uint32_t i = 0; i < history->nnode; i++) {
    double own = um_thermal_network_capacity(b->thermal->network, i);
    sum += own * t[i];
    capacity += own;
  }
  *steps = history->steps;
  um_thermal_history_destroy(bench->context, &history);
  return sum / capacity;
}

/* Others on the machine do not count where one thread works. */
static double now(const struct bench *bench)
{
  return um_core_context_threads(bench->context) > 1 ? bench_wall() : bench_cpu();
}

struct asteroid_cost asteroid_run(const struct bench *bench, size_t cells, const char *cache,
                                  double tighter)
{
  struct body b = {0};
  struct rusage usage;
  double t[5];
  size_t steps;
  body_make(bench, cells, &b);
  b.options.relative_tolerance /= tighter;
  b.options.absolute_tolerance /= tighter;
  t[0] = now(bench);
  sun_trace(bench, &b);
  t[1] = now(bench);
  factors_make(bench, cache, &b);
  t[2] = now(bench);
  exchange_make(bench, &b);
  t[3] = now(bench);
  double mean = turn_follow(bench, &b, &steps);
  t[4] = now(bench);
  getrusage(RUSAGE_SELF, &usage);
  const struct um_geometry_view_factors *factors = b.table->pose[0];
  struct asteroid_cost cost = {.facets = um_geometry_mesh(b.geometry)->nfacet,
                               .pairs = factors->begin[factors->npatch],
                               .steps = steps,
                               .sun = t[1] - t[0],
                               .factors = t[2] - t[1],
                               .exchange = t[3] - t[2],
                               .heat = t[4] - t[3],
                               .mean = mean,
                               .memory = 1024.0 * (double)usage.ru_maxrss};
  body_free(bench, &b);
  return cost;
}

double asteroid_periodic(const struct bench *bench, size_t cells, size_t *turns)
{
  struct body b = {0};
  struct um_thermal_periodic report;
  body_make(bench, cells, &b);
  sun_trace(bench, &b);
  factors_make(bench, NULL, &b);
  exchange_make(bench, &b);
  size_t n = um_thermal_network_nodes(b.thermal->network);
  double *temperature = bench_allocate(bench, n, sizeof *temperature);
  double begin = now(bench);
  bench_must(bench, um_thermal_solve_periodic_report(bench->context, b.thermal->network, b.loads,
                                                     &b.options, NULL, 0.0, PERIOD, 0.01,
                                                     temperature, NULL, NULL, &report));
  double seconds = now(bench) - begin;
  *turns = report.orbits;
  free(temperature);
  body_free(bench, &b);
  return seconds;
}
