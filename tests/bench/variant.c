/* What a change of ENVISAT's pass costs over a run of its own from the model on, what passes of a
 * forecast do, and what looser tolerances leave over what is stated of them, in processor time of
 * one thread. Some five minutes. */
#include <math.h>
#include <stdio.h>

#include "effects/effects.h"
#include "model/build/bands.h"
#include "model/build/build.h"
#include "tests/bench/bench.h"
#include "tests/bench/own_run.h"
#include "variant/evaluator.h"
#include "variant/tolerance_impl.h"

#define SCENARIO UMBRA_SOURCE_DIR "/scenarios/envisat-graz-2016"
#define DAY      86400.0
#define RUNS     3
#define PASSES   21 /* of three days over Graz */

/* As the points of a study. */
static const struct um_variant_heat how = {.start = UM_VARIANT_WARM, .tolerance = {3.0, 0.05}};

struct cost {
  const char *name;
  double goal; /* of a run [1] */
  const char *effect, *target;
  double value;
};
static const struct cost costs[] = {
    {"zero point of a band", 0.01, "zero_point", "vis", 1.01},
    {"constant light in what is measured", 0.01, "background", "vis", 1e-14},
    {"time tag", 0.01, "time_tag", NULL, 0.1},
    {"reflectance in VIS alone", 0.08, "diffuse_level", "aluminium_anodised", 1.05},
    {"emittance", 0.10, "emittance", "cell_silicon", 1.02},
    {"power inside", 0.10, "internal_power", "bus", 20.0},
    {"attitude", 0.5, "attitude_offset", NULL, 1.0},
    {"spin period", 0.5, "spin_period", NULL, 0.001},
};
#define COSTS (sizeof costs / sizeof *costs)

static double observe(const struct bench *bench, struct um_variant_evaluator *evaluator,
                      struct um_variant *v, double begin)
{
  struct um_model_result *result = NULL;
  bench_must(bench, um_variant_observe(bench->context, evaluator, v, &result));
  double seconds = bench_cpu() - begin;
  um_model_result_destroy(bench->context, &result);
  um_variant_close(bench->context, v);
  return seconds;
}

static double change(const struct bench *bench, struct um_variant_evaluator *evaluator,
                     const struct cost *c, int run)
{
  struct um_model_addition addition = {.effect = um_effects_find(c->effect), .target = c->target};
  const struct um_model_changes changes = {.addition = &addition, .naddition = 1};
  struct um_variant v;
  for (size_t p = 0; p < addition.effect->nparameter; p++)
    addition.value[p] = addition.effect->parameters[p].null_value;
  addition.value[0] = c->value * (1.0 + 1e-3 * run); /* nothing of the run before serves */
  double begin = bench_cpu();
  bench_must(bench, um_variant_open(bench->context, evaluator, &changes, &how, &v));
  return observe(bench, evaluator, &v, begin);
}

/* Another pass of the body as a forecast computes it: sparse loads, heat from that of one instant.
 * *base: cost of that instant's, once. */
static double pass(const struct bench *bench, const struct um_model *model, int run, double *base)
{
  static const struct um_model_instants window = {.sparse = true};
  const struct um_scenario_time *time = model->scenario->time;
  const struct um_model_instants instant = {.time = &time->start, .count = 1, .sparse = true};
  const struct um_variant_settings settings = {.instants = &instant, .base = {1.0, 0.02}};
  const double later = DAY + 100.0 * run;
  const struct um_document_change key[] = {{.key = "time.start_utc", .number = time->start + later},
                                           {.key = "time.stop_utc", .number = time->stop + later}};
  const struct um_model_changes changes = {.key = key, .nkey = 2};
  struct um_variant_evaluator *evaluator = NULL;
  struct um_variant v;
  double begin = bench_cpu();
  bench_must(bench, um_variant_evaluator_create(bench->context, model, &settings, &evaluator));
  bench_must(bench, um_variant_base(bench->context, evaluator, &v));
  *base = bench_cpu() - begin;
  begin = bench_cpu();
  bench_must(bench, um_variant_open_over(bench->context, evaluator, &window, &changes, &how, &v));
  double seconds = observe(bench, evaluator, &v, begin);
  um_variant_evaluator_destroy(bench->context, &evaluator);
  return seconds;
}

/* Largest differences of temperatures and of LWIR, of its value or a hundredth of the largest. */
static void difference(const struct um_model_result *a, const struct um_model_result *b,
                       size_t band, double *temperature, double *lwir)
{
  double most = 0.0;
  for (size_t p = 0; p < a->nplace; p++)
    for (size_t k = 0; k < a->nobs; k++)
      *temperature = fmax(*temperature, fabs(a->place[p].mean[k] - b->place[p].mean[k]));
  for (size_t k = band; k < a->nobs * a->nband; k += a->nband) most = fmax(most, b->irradiance[k]);
  for (size_t k = band; k < a->nobs * a->nband; k += a->nband)
    *lwir = fmax(*lwir,
                 fabs(a->irradiance[k] - b->irradiance[k]) / fmax(b->irradiance[k], 0.01 * most));
}

/* The scenario as it stands by each choice of tolerances. */
static void tolerance_figures(struct bench *bench, struct um_variant_evaluator *evaluator,
                              const struct um_variant *base)
{
  struct um_model_result *exact = NULL;
  size_t band = um_model_band_find(base->model, "lwir");
  bench_must(bench, um_variant_observe(bench->context, evaluator, base, &exact));
  for (size_t i = 0; i < UM_VARIANT_CHOICES; i++) {
    const struct um_variant_tolerance_choice *choice = &um_variant_tolerance_choices[i];
    const struct um_variant_heat loose = {.start = UM_VARIANT_WARM, .tolerance = choice->tolerance};
    struct um_variant v = *base;
    struct um_model_result *result = NULL;
    double temperature = 0.0, lwir = 0.0;
    char name[80];
    bench_must(bench, um_variant_heat_again(bench->context, evaluator, &loose, &v));
    bench_must(bench, um_variant_observe(bench->context, evaluator, &v, &result));
    difference(result, exact, band, &temperature, &lwir);
    snprintf(name, sizeof name, "temperatures by %g times the tolerances",
             choice->tolerance.factor);
    bench_number(bench, name, "K", temperature, choice->leaves.temperature, 1.0);
    snprintf(name, sizeof name, "LWIR by %g times the tolerances", choice->tolerance.factor);
    bench_number(bench, name, "1", lwir, choice->leaves.lwir, 1.0);
    um_model_result_destroy(bench->context, &result);
    um_variant_close(bench->context, &v);
  }
  um_model_result_destroy(bench->context, &exact);
}

int main(int argc, char **argv)
{
  struct bench bench;
  struct bench_series run = {{0}, 0}, cost[COSTS] = {{{0}, 0}}, later = {{0}, 0}, forecast = later;
  const struct um_variant_settings settings = {.base = UM_VARIANT_TIGHT, .photons = true};
  struct um_model *model = NULL;
  struct um_variant_evaluator *evaluator = NULL;
  struct um_variant base;
  bench_begin(&bench, argc, argv, "a change of ENVISAT's pass over a run of its own");
  bench_must(&bench, um_model_create(bench.context, SCENARIO, NULL, &model));
  bench_must(&bench, um_variant_evaluator_create(bench.context, model, &settings, &evaluator));
  bench_must(&bench, um_variant_base(bench.context, evaluator, &base));
  for (int i = 0; i < RUNS; i++) {
    bench_add(&run, bench_own_run(&bench, model));
    for (size_t k = 0; k < COSTS; k++) bench_add(&cost[k], change(&bench, evaluator, &costs[k], i));
    double base_seconds, pass_seconds = pass(&bench, model, i, &base_seconds);
    bench_add(&later, pass_seconds);
    bench_add(&forecast, base_seconds + PASSES * pass_seconds);
  }
  for (size_t k = 0; k < COSTS; k++)
    bench_time(&bench, costs[k].name, "s", &cost[k], &run, costs[k].goal);
  bench_time(&bench, "the pass a day later", "s", &later, &run, 0.25);
  bench_time(&bench, "a forecast of 21 such passes", "s", &forecast, &run, 5.0);
  tolerance_figures(&bench, evaluator, &base);
  um_variant_evaluator_destroy(bench.context, &evaluator);
  um_model_destroy(bench.context, &model);
  return bench_end(&bench);
}
