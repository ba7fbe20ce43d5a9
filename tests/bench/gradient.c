/* What heat's tangent costs on ENVISAT's pass, all parameters of one run together, over a run of
 * the scenario, in processor time of one thread; and how far it is from central differences of
 * integrations of their own. More than eight minutes. */
#include <math.h>
#include <stdio.h>

#include "effects/effects.h"
#include "model/build/build.h"
#include "model/run/thermal_solution_group.h"
#include "tests/bench/bench.h"
#include "tests/bench/own_run.h"
#include "variant/evaluator.h"

#define SCENARIO UMBRA_SOURCE_DIR "/scenarios/envisat-graz-2016"
#define SMALL    1e-3 /* of a step, for the tangent */

/* Steps of central differences, from the effect's null value. */
struct parameter {
  const char *effect, *target;
  double step;
  bool compared;
};
static const struct parameter parameters[] = {
    {"emittance", "cell_silicon", 0.02, true},
    {"internal_power", "bus", 20.0, false}, /* has no other side */
    {"heat_capacity", "solar_array", 0.05, true},
    {"mli_emittance", "bus", 0.1, false},
    {"emittance", "mli_kapton", 0.02, false},
    {"emittance", "aluminium_anodised", 0.02, false},
    {"emittance", "cfrp", 0.02, false},
    {"heat_capacity", "bus", 0.05, false},
    {"heat_capacity", "asar", 0.05, false},
    {"interior_capacity", "bus", 0.05, false},
    {"through_conductance", "solar_array", 0.05, false},
    {"solar_absorptance", "mli_kapton", 0.05, true},
    {"solar_absorptance", "cell_silicon", 0.05, false},
    {"solar_absorptance", "aluminium_anodised", 0.05, false},
    {"solar_absorptance", "cfrp", 0.05, false},
};
#define PARAMETERS (sizeof parameters / sizeof *parameters)
#define SMOOTH     11 /* the first of them: those behind move loads, which are kinked at every row */
static const size_t counts[] = {1, SMOOTH, PARAMETERS};

static void open_moved(const struct bench *bench, struct um_variant_evaluator *evaluator,
                       const struct parameter *p, double share, const struct um_variant_heat *how,
                       struct um_variant *out)
{
  struct um_model_addition addition = {.effect = um_effects_find(p->effect), .target = p->target};
  const struct um_model_changes changes = {.addition = &addition, .naddition = 1};
  for (size_t k = 0; k < addition.effect->nparameter; k++)
    addition.value[k] = addition.effect->parameters[k].null_value;
  addition.value[0] += share * p->step;
  bench_must(bench, um_variant_open(bench->context, evaluator, &changes, how, out));
}

static struct um_model_thermal_sensitivity *tangent(const struct bench *bench,
                                                    struct um_variant_evaluator *evaluator,
                                                    const struct um_variant *base, size_t n,
                                                    double *seconds)
{
  struct um_variant variant[PARAMETERS];
  struct um_model_thermal_move move[PARAMETERS];
  struct um_model_thermal_sensitivity *found = NULL;
  double begin = bench_cpu();
  for (size_t k = 0; k < n; k++) {
    open_moved(bench, evaluator, &parameters[k], SMALL, NULL, &variant[k]);
    move[k] = (struct um_model_thermal_move){
        .model = variant[k].model, .tables = variant[k].tables, .step = SMALL * parameters[k].step};
  }
  bench_must(bench,
             um_model_thermal_sensitivity_create(bench->context, base->heat, move, n, 0.0, &found));
  *seconds = bench_cpu() - begin;
  for (size_t k = 0; k < n; k++) um_variant_close(bench->context, &variant[k]);
  return found;
}

static double place_mean(const struct um_thermal_place *place, const double *temperature)
{
  double mean = 0.0;
  for (size_t j = 0; j < place->nnode; j++) mean += place->weight[j] * temperature[place->node[j]];
  return mean;
}

/* Largest distance of the means of places from a central difference, over its largest value, of all
 * instants and places. */
static double error_of(const struct bench *bench, struct um_variant_evaluator *evaluator,
                       const struct um_variant *base,
                       const struct um_model_thermal_sensitivity *found, size_t which)
{
  const struct parameter *p = &parameters[which];
  const struct um_variant_heat how = {.start = UM_VARIANT_WARM, .tolerance = {1.0, 1e-4}};
  struct um_model_thermal_solution *moved = NULL;
  struct um_variant side[2];
  double largest = 0.0, worst = 0.0;
  for (int s = 0; s < 2; s++) open_moved(bench, evaluator, p, s == 0 ? 0.5 : -0.5, &how, &side[s]);
  bench_must(bench, um_model_thermal_solution_move(bench->context, base->heat, found, which,
                                                   p->step, side[0].model, side[0].tables, &moved));
  const struct um_thermal_history *h[4] = {side[0].heat->run.history, side[1].heat->run.history,
                                           moved->run.history, base->heat->run.history};
  for (size_t l = 0; l < base->model->body->nplace; l++)
    for (size_t i = 0; i < h[0]->ntime; i++) {
      double t[4];
      for (int k = 0; k < 4; k++)
        t[k] = place_mean(&base->model->body->place[l], h[k]->temperature + i * h[k]->nnode);
      largest = fmax(largest, fabs(t[0] - t[1]));
      worst = fmax(worst, fabs(t[2] - t[3] - (t[0] - t[1])));
    }
  um_model_thermal_solution_destroy(bench->context, &moved);
  for (int s = 0; s < 2; s++) um_variant_close(bench->context, &side[s]);
  return worst / largest;
}

/* Against integrations with a tenth of the tolerances. */
static void errors(struct bench *bench, const struct um_model_thermal_sensitivity *found)
{
  static const char *const accuracy[] = {"thermal.accuracy_K=0.001"};
  const struct um_model_options tight = {.overrides = accuracy, .noverride = 1};
  const struct um_variant_settings exact = {.base = {1.0, 1e-4}};
  struct um_model *model = NULL;
  struct um_variant_evaluator *evaluator = NULL;
  struct um_variant base;
  char name[80];
  bench_must(bench, um_model_create(bench->context, SCENARIO, &tight, &model));
  bench_must(bench, um_variant_evaluator_create(bench->context, model, &exact, &evaluator));
  bench_must(bench, um_variant_base(bench->context, evaluator, &base));
  for (size_t k = 0; k < PARAMETERS; k++) {
    if (!parameters[k].compared) continue;
    double error = error_of(bench, evaluator, &base, found, k);
    snprintf(name, sizeof name, "error of %s:%s", parameters[k].effect, parameters[k].target);
    bench_number(bench, name, "1", error, 1e-3, 1.0);
  }
  um_variant_evaluator_destroy(bench->context, &evaluator);
  um_model_destroy(bench->context, &model);
}

int main(int argc, char **argv)
{
  struct bench bench;
  const struct um_variant_settings settings = {.base = {6.0, 0.02}};
  struct um_model *model = NULL;
  struct um_variant_evaluator *evaluator = NULL;
  struct um_variant base;
  struct bench_series run = {{0}, 0};
  struct um_model_thermal_sensitivity *found = NULL;
  struct um_model_light_sensitivity *light = NULL;
  char name[80];
  bench_begin(&bench, argc, argv, "heat's tangent on ENVISAT's pass over a run");
  bench_must(&bench, um_model_create(bench.context, SCENARIO, NULL, &model));
  bench_add(&run, bench_own_run(&bench, model));
  bench_must(&bench, um_variant_evaluator_create(bench.context, model, &settings, &evaluator));
  bench_must(&bench, um_variant_base(bench.context, evaluator, &base));
  for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
    struct bench_series cost = {{0}, 0};
    double seconds;
    um_model_thermal_sensitivity_destroy(bench.context, &found);
    found = tangent(&bench, evaluator, &base, counts[i], &seconds);
    bench_add(&cost, seconds);
    snprintf(name, sizeof name, "tangent of %zu parameters", counts[i]);
    bench_time(&bench, name, "s", &cost, &run, NAN);
  }
  struct bench_series cost = {{0}, 0};
  double begin = bench_cpu();
  bench_must(&bench, um_model_light_sensitivity_create(bench.context, found, &light));
  bench_add(&cost, bench_cpu() - begin);
  snprintf(name, sizeof name, "light by %zu such temperatures", PARAMETERS);
  bench_time(&bench, name, "s", &cost, &run, NAN);
  errors(&bench, found);
  um_model_light_sensitivity_destroy(bench.context, &light);
  um_model_thermal_sensitivity_destroy(bench.context, &found);
  um_variant_evaluator_destroy(bench.context, &evaluator);
  um_model_destroy(bench.context, &model);
  return bench_end(&bench);
}
