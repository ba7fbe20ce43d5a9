/* Heat: the orbit of a spinning satellite of 1000, 4000 and 10000 nodes, one thread.
 *
 * A box under MLI (a skin node per facet) around a slow interior, and a two-sided array beside it;
 * finite-element shells of ever smaller facets; 765 km, beta 0, eight turns an orbit, so that the
 * loads never rest; a shadow with hard edges; tolerance 1e-6 and 1e-4 K, the defaults.
 *
 *   rate          dT/dt of all nodes once, at a new time, against a copy that moves as many bytes
 *                 as it reads and writes when every array passes once
 *   orbit         an integration with the audit, against its own evaluations of the rate alone:
 *                 what solving and factoring, error control and the audit add; a whole orbit at
 *                 1000 nodes, its first half and quarter above
 *   per node      its step per node, against the same at 1000 nodes: growth beyond linear
 *   periodic      the repeating state to 0.01 K, in orbits of integration, at 1000 nodes (the
 *                 number does not depend on the size)
 *   sensitivities of twenty parameters along a quarter orbit, to its own integration; how far three
 *                 are from central differences; at 1000 nodes
 *
 * Goals. rate 4 copies: it gathers neighbours and rounds chains of additions, which a copy does
 * not. orbit 8: each evaluation has a triangular solve over factors of three to five times the
 * entries of the matrix, and every eighth a factorisation. per node 2: factors of a shell grow as n
 * log n. periodic 5 orbits: four spin-up orbits and one more are what others spend and do not get
 * there (an interior under MLI then stands 88-99 % unconverged). Errors: audit 1e-6 of the
 * turnover, and 0.01 K from a run with tolerances a thousand times tighter, at 1000 nodes. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/constants.h"
#include "tests/bench/bench.h"
#include "thermal/network/body.h"
#include "thermal/solver/solve.h"
#include "thermal/solver/system_group.h"
#include "thermal/tangent/sensitivity.h"

#define ROWS       632 /* of the loads: 0.08 rad of spin apart */
#define TURNS      8.0
#define ALTITUDE   765e3 /* [m] */
#define SIZES      3
#define QUARTER    0.25 /* of an orbit, for sensitivities */
#define PARAMETERS 20   /* of sensitivities */
#define RATE_RUNS  15   /* one orbit is run three times at 1000 nodes, once above */
#define AUDIT      1e-6 /* [1] */
#define DISTANCE   0.01 /* [K] */

struct size {
  const char *name;
  double facet_size; /* [m] */
  double share;      /* of an orbit that is integrated [1] */
};
static const struct size sizes[SIZES] = {
    {"1000 nodes", 0.42, 1.0}, {"4000 nodes", 0.21, 0.5}, {"10000 nodes", 0.132, 0.25}};

struct satellite {
  struct um_geometry *geometry;
  struct um_thermal_body *body;
  struct um_irradiation_loads *loads;
  double period; /* [s] */
};

static void body_build(const struct bench *bench, double facet_size, struct satellite *s)
{
  static const struct um_geometry_skin closed = {NULL, "mli", NULL}, open = {NULL, "cell", "cfrp"};
  const struct um_geometry_part_spec shape[2] = {{.name = "bus",
                                                  .shape = UM_SHAPE_BOX,
                                                  .size = {2.0, 2.0, 2.0},
                                                  .rotation = {1, 0, 0, 0},
                                                  .skins = &closed,
                                                  .nskin = 1,
                                                  .facet_size = facet_size},
                                                 {.name = "array",
                                                  .shape = UM_SHAPE_PLATE,
                                                  .size = {4.0, 2.0},
                                                  .rotation = {1, 0, 0, 0},
                                                  .position = {3.5, 0.0, 0.0},
                                                  .skins = &open,
                                                  .nskin = 1,
                                                  .facet_size = facet_size}};
  struct um_thermal_mli mli = {.effective_emittance = 0.02, .areal_heat_capacity = 77.4};
  struct um_thermal_interior_spec inside = {.name = "interior", .capacity = 2e6, .power = 60.0};
  double held = 4.0; /* [W/K] of a group */
  struct um_thermal_group_spec group[16];
  struct um_thermal_part_spec part[2] = {{.part = 0,
                                          .kind = UM_THERMAL_SHELL,
                                          .interior = &inside,
                                          .ninterior = 1,
                                          .start_temperature = 285.0,
                                          .shell = {4860.0, 1.0, 0.33, INFINITY}},
                                         {.part = 1,
                                          .kind = UM_THERMAL_SHELL,
                                          .start_temperature = 285.0,
                                          .shell = {3240.0, 0.5, 0.03, 100.0}}};
  const struct um_thermal_contact contact = {"bus.interior", "array", 0.5, 0.0};
  bench_must(bench, um_geometry_create(bench->context, shape, 2, &s->geometry));
  for (uint32_t g = 0; g < um_geometry_group_count(s->geometry); g++) { /* in order of parts */
    uint32_t p = um_geometry_group(s->geometry, g)->part;
    if (part[p].ngroup++ == 0) part[p].groups = &group[g];
    group[g] = (struct um_thermal_group_spec){.group = g,
                                              .mli = p == 0 ? &mli : NULL,
                                              .interior_conductance = p == 0 ? &held : NULL,
                                              .absorptance_front = p == 0 ? 0.38 : 0.80,
                                              .emittance_front = p == 0 ? 0.78 : 0.85,
                                              .absorptance_back = 0.60,
                                              .emittance_back = 0.85};
  }
  bench_must(bench,
             um_thermal_body_create(bench->context, s->geometry, part, 2, &contact, 1, &s->body));
}

static int ascending(const void *pa, const void *pb)
{
  double a = *(const double *)pa, b = *(const double *)pb;
  return (a > b) - (a < b);
}

static void loads_trace(const struct bench *bench, struct satellite *s)
{
  struct um_environment environment;
  um_environment_defaults(&environment);
  environment.shadow = UM_SHADOW_CYLINDER;
  environment.disc = UM_DISC_POINT;
  double a = UM_EARTH_RADIUS + ALTITUDE, half = asin(UM_EARTH_RADIUS / a) / (2.0 * UM_PI);
  s->period = 2.0 * UM_PI * sqrt(a * a * a / UM_EARTH_GM);
  double edge[2] = {s->period * (0.5 - half), s->period * (0.5 + half)}, t[ROWS + 4];
  struct um_environment_sample sample[ROWS + 4];
  size_t n = 0;
  for (int k = 0; k < ROWS; k++) t[n++] = s->period * k / (ROWS - 1);
  for (int e = 0; e < 2; e++) { /* both sides of the jump */
    t[n++] = edge[e] - 1e-3;
    t[n++] = edge[e] + 1e-3;
  }
  qsort(t, n, sizeof t[0], ascending);
  for (size_t k = 0; k < n; k++) {
    double u = 2.0 * UM_PI * t[k] / s->period;
    struct um_vec3 axis = um_vec3_unit(um_vec3(0.3, 0.2, 1.0));
    sample[k] = (struct um_environment_sample){.t_tai = t[k],
                                               .r = {a * cos(u), a * sin(u), 0.0},
                                               .sun = {1, 0, 0},
                                               .sun_distance = UM_AU,
                                               .pole = {0, 0, 1},
                                               .q = um_quat_from_axis(axis, TURNS * u)};
    sample[k].sunlit_fraction = um_environment_sunlit_fraction(
        &environment, sample[k].r, sample[k].sun, UM_AU, sample[k].pole);
  }
  bench_must(bench, um_irradiation_loads_trace(bench->context, s->geometry, &environment, sample, n,
                                               edge, 2, 1, &s->loads));
}

/* Bytes of an evaluation of the rate when every array passes once. */
static size_t rate_bytes(const struct um_thermal_system *system)
{
  /* y, T, T^3, T^4, Q, two rows of Sun and Earth, P, space, C, start, rate; node */
  size_t per_node = 14 * sizeof(double) + sizeof(uint32_t);
  size_t per_link = 2 * sizeof(double) + sizeof(uint32_t);
  return system->n * per_node + system->start[system->n] * per_link;
}

/* Times of the rate and of the copy, alternating [us]. */
static void rate_time(const struct bench *bench, const struct satellite *s,
                      struct bench_series *rate, struct bench_series *copy)
{
  struct um_thermal_solve_options options;
  struct um_thermal_system *system = NULL;
  um_thermal_solve_defaults(&options);
  bench_must(bench, um_thermal_system_create(bench->context, s->body->network, s->loads, &options,
                                             NULL, 0.0, false, &system));
  um_thermal_system_window(system, 0.0, s->period);
  size_t half = rate_bytes(system) / 2, repeats = 20000000 / half + 1;
  char *from = bench_allocate(bench, half, 1), *to = bench_allocate(bench, half, 1);
  double *y = bench_allocate(bench, system->nunknown, sizeof *y);
  double *out = bench_allocate(bench, system->nunknown, sizeof *out);
  for (size_t k = 0; k < system->nunknown; k++) y[k] = system->temperature[system->node[k]];
  for (int run = 0; run < RATE_RUNS; run++) {
    double a = bench_cpu();
    for (size_t i = 0; i < repeats; i++) {
      from[i % half]++; /* or the copies would be one */
      memcpy(to, from, half);
      __asm__ volatile("" : : "r"(to) : "memory");
    }
    double b = bench_cpu();
    for (size_t i = 0; i < repeats; i++) {
      /* within two rows of the loads, whose sums over surfaces are kept */
      um_thermal_system_state_set(system, 1.0 + 1e-6 * (double)i, y);
      um_thermal_system_rate(system, out);
    }
    double c = bench_cpu();
    bench_add(copy, 1e6 * (b - a) / (double)repeats);
    bench_add(rate, 1e6 * (c - b) / (double)repeats);
  }
  um_core_free(bench->context, from);
  um_core_free(bench->context, to);
  um_core_free(bench->context, y);
  um_core_free(bench->context, out);
  um_thermal_system_destroy(&system);
}

static struct um_thermal_history *orbit(const struct bench *bench, const struct satellite *s,
                                        double share, double tighter)
{
  struct um_thermal_solve_options options;
  struct um_thermal_history *history = NULL;
  um_thermal_solve_defaults(&options);
  options.relative_tolerance /= tighter;
  options.absolute_tolerance /= tighter;
  double t[4];
  for (int k = 0; k < 4; k++) t[k] = share * s->period * (k + 1) / 4.0;
  bench_must(bench, um_thermal_solve(bench->context, s->body->network, s->loads, &options, NULL,
                                     0.0, t, 4, &history));
  return history;
}

static void error_figure(struct bench *bench, const struct satellite *s)
{
  struct um_thermal_history *usual = orbit(bench, s, 1.0, 1.0),
                            *tight = orbit(bench, s, 1.0, 1000.0);
  double worst = 0.0;
  for (size_t i = 0; i < usual->ntime * usual->nnode; i++)
    worst = fmax(worst, fabs(usual->temperature[i] - tight->temperature[i]));
  bench_number(bench, "1000 nodes: error of a temperature", "K", worst, DISTANCE, 1.0);
  um_thermal_history_destroy(bench->context, &usual);
  um_thermal_history_destroy(bench->context, &tight);
}

/* Time [s] and orbits of the repeating state; empty figures and a line when none is found. */
static void periodic_figures(struct bench *bench, const struct satellite *s, double orbit_time)
{
  struct um_thermal_solve_options options;
  struct um_thermal_periodic report;
  um_thermal_solve_defaults(&options);
  double *t = bench_allocate(bench, um_thermal_network_nodes(s->body->network), sizeof *t);
  double began = bench_cpu();
  enum um_status status =
      um_thermal_solve_periodic_report(bench->context, s->body->network, s->loads, &options, NULL,
                                       0.0, s->period, DISTANCE, t, NULL, NULL, &report);
  double time = bench_cpu() - began;
  um_core_free(bench->context, t);
  bool found = status == UM_OK;
  if (status == UM_ERR_NUMERIC) {
    printf("after %.3g s: %s\n", time, um_core_message(bench->context));
    um_core_message_clear(bench->context);
  } else {
    bench_must(bench, status);
  }
  bench_number(bench, "1000 nodes: periodic state, to one orbit", "s", found ? time : NAN,
               orbit_time, 5.0);
  bench_number(bench, "1000 nodes: periodic state, orbits, rough and full", "1",
               found ? (double)report.orbits : NAN, NAN, NAN);
  bench_number(bench, "1000 nodes: periodic state, distance left", "K",
               found ? report.distance : NAN, DISTANCE, 1.0);
}

/* Parameter `which` of twenty, times `factor`: absorptances, emittances, capacities, conductances
 * and MLI of one quarter of the nodes each. */
static void parameter_move(struct um_thermal_network *network, size_t which, double factor)
{
  size_t kind = which % 5, quarter = which / 5, n = network->nnode;
  for (size_t k = 0; k < network->nsurface; k++) {
    struct um_thermal_surface *surface = &network->surface[k];
    if (4 * k / network->nsurface != quarter) continue;
    if (kind == 0) surface->absorptance *= factor;
    if (kind == 1) surface->emittance *= factor;
  }
  for (size_t i = 0; i < n; i++)
    if (kind == 2 && 4 * i / n == quarter) network->node[i].capacity *= factor;
  for (size_t k = 0; k < network->nconductor; k++)
    if (kind == 3 && 4 * k / network->nconductor == quarter) network->conductor[k].value *= factor;
  for (size_t k = 0; k < network->nradiator; k++)
    if (kind == 4 && 4 * k / network->nradiator == quarter) network->radiator[k].value *= factor;
}

static enum um_status keep(void *user, size_t k, const double *temperature, const double *s)
{
  size_t count = *(const size_t *)user;
  double *out = (double *)((size_t *)user + 1);
  (void)temperature;
  memcpy(out + k * count, s, count * sizeof *s);
  return UM_OK;
}

/* Largest difference of one parameter's answers from central differences of runs ten times tighter,
 * over the largest answer. */
static double sensitivity_error(const struct bench *bench, struct satellite *s, size_t which,
                                const double *got)
{
  struct um_thermal_history *h[2];
  size_t n = s->body->network->nnode;
  double largest = 0.0, worst = 0.0;
  for (int side = 0; side < 2; side++) {
    double factor = side == 0 ? 1.01 : 0.99;
    parameter_move(s->body->network, which, factor);
    h[side] = orbit(bench, s, QUARTER, 10.0);
    parameter_move(s->body->network, which, 1.0 / factor);
  }
  for (size_t k = 0; k < 4; k++)
    for (size_t i = 0; i < n; i++) {
      double d = (h[0]->temperature[k * n + i] - h[1]->temperature[k * n + i]) / 0.02;
      largest = fmax(largest, fabs(d));
      worst = fmax(worst, fabs(d - got[k * PARAMETERS * n + which * n + i]));
    }
  um_thermal_history_destroy(bench->context, &h[0]);
  um_thermal_history_destroy(bench->context, &h[1]);
  return worst / largest;
}

static void sensitivity_figures(struct bench *bench, struct satellite *s)
{
  struct um_thermal_variant variant[PARAMETERS];
  struct satellite moved[PARAMETERS];
  struct um_thermal_solve_options options;
  um_thermal_solve_defaults(&options);
  size_t count = PARAMETERS * s->body->network->nnode;
  size_t *kept = bench_allocate(bench, 4 * count + 1, sizeof(double));
  double t[4], worst = 0.0;
  kept[0] = count;
  for (int k = 0; k < 4; k++) t[k] = QUARTER * s->period * (k + 1) / 4.0;
  for (size_t p = 0; p < PARAMETERS; p++) {
    body_build(bench, sizes[0].facet_size, &moved[p]);
    parameter_move(moved[p].body->network, p, 1.0 + 1e-5);
    variant[p] = (struct um_thermal_variant){moved[p].body->network, s->loads, NULL, 1e-5, NULL};
  }
  double began = bench_cpu();
  struct um_thermal_history *plain = orbit(bench, s, QUARTER, 1.0);
  double run_time = bench_cpu() - began;
  um_thermal_history_destroy(bench->context, &plain);
  began = bench_cpu();
  const struct um_thermal_forcings forcings = {.variant = variant, .nvariant = PARAMETERS};
  bench_must(bench, um_thermal_sensitivity(bench->context, s->body->network, s->loads, &options,
                                           NULL, 0.0, t, 4, &forcings, NULL, keep, kept));
  double time = bench_cpu() - began;
  for (size_t p = 0; p < 5; p += 2) /* absorptance, capacity, MLI */
    worst = fmax(worst, sensitivity_error(bench, s, p, (const double *)(kept + 1)));
  for (size_t p = 0; p < PARAMETERS; p++) {
    um_thermal_body_destroy(bench->context, &moved[p].body);
    um_geometry_destroy(&moved[p].geometry);
  }
  um_core_free(bench->context, kept);
  bench_number(bench, "1000 nodes: 20 sensitivities, to one run", "s", time, run_time, 8.0);
  bench_number(bench, "1000 nodes: sensitivities from central differences", "1", worst, 1e-3, 1.0);
}

/* Figures of one size; returns the step's cost per node [s]. reference: that of 1000 nodes, NaN for
 * them. */
static double size_figures(struct bench *bench, const struct size *size, double reference)
{
  struct satellite s = {0};
  struct bench_series rate = {.n = 0}, copy = {.n = 0}, time = {.n = 0}, bare = {.n = 0};
  struct um_thermal_history *history = NULL;
  bool first = isnan(reference);
  char name[80];
  body_build(bench, size->facet_size, &s);
  loads_trace(bench, &s);
  double nnode = (double)um_thermal_network_nodes(s.body->network);
  rate_time(bench, &s, &rate, &copy);
  for (int run = 0; run < (first ? 3 : 1); run++) {
    um_thermal_history_destroy(bench->context, &history);
    double began = bench_cpu();
    history = orbit(bench, &s, size->share, 1.0);
    bench_add(&time, bench_cpu() - began);
    bench_add(&bare, (double)history->rhs_evaluations * 1e-6 * bench_median(&rate));
  }
  double steps = (double)history->steps;
  double per_node = bench_median(&time) / steps / nnode;
  snprintf(name, sizeof name, "%s: exact number", size->name);
  bench_number(bench, name, "1", nnode, NAN, NAN);
  snprintf(name, sizeof name, "%s: rate, to a copy of its bytes", size->name);
  bench_time(bench, name, "us", &rate, &copy, 4.0);
  snprintf(name, sizeof name, "%s: %g orbit, to its rates alone", size->name, size->share);
  bench_time(bench, name, "s", &time, &bare, 8.0);
  snprintf(name, sizeof name, "%s: step per node, to 1000 nodes", size->name);
  bench_number(bench, name, "ns", 1e9 * per_node, 1e9 * reference, first ? NAN : 2.0);
  snprintf(name, sizeof name, "%s: steps", size->name);
  bench_number(bench, name, "1", steps, NAN, NAN);
  snprintf(name, sizeof name, "%s: rates per step", size->name);
  bench_number(bench, name, "1", (double)history->rhs_evaluations / steps, NAN, NAN);
  snprintf(name, sizeof name, "%s: factorisations per step", size->name);
  bench_number(bench, name, "1", (double)history->jacobians / steps, NAN, NAN);
  snprintf(name, sizeof name, "%s: energy audit error", size->name);
  bench_number(bench, name, "1", history->audit_error, AUDIT, 1.0);
  um_thermal_history_destroy(bench->context, &history);
  if (first) error_figure(bench, &s);
  if (first) periodic_figures(bench, &s, bench_median(&time));
  if (first) sensitivity_figures(bench, &s);
  um_irradiation_loads_destroy(bench->context, &s.loads);
  um_thermal_body_destroy(bench->context, &s.body);
  um_geometry_destroy(&s.geometry);
  return per_node;
}

int main(int argc, char **argv)
{
  struct bench bench;
  bench_begin(&bench, argc, argv, "heat: an orbit of a spinning satellite, one thread");
  double per_node = size_figures(&bench, &sizes[0], NAN);
  for (int i = 1; i < SIZES; i++) size_figures(&bench, &sizes[i], per_node);
  return bench_end(&bench);
}
