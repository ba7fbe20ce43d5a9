/* What heat must obey in every scenario that comes with the program, whatever it is made of: the
 * second law without Sun and power, and the balance of energy with everything on. */
#include <string.h>

#include "base/core/constants.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "tests/scenarios/support.h"

/* Coarse facets, few rows: the laws hold on any mesh. ten: followed over ten orbits; the others are
 * of the same kind. */
static const struct {
  const char *name;
  const char *coarse[8];
  bool ten;
} scenarios[] = {
    {"cube", {NULL}, true},
    {"sphere", {"time.step_s=120", NULL}, true},
    {"funcube-1", {"time.step_s=300", "time.stop_utc=2016-02-04T03:00:00Z", NULL}, true},
    {"envisat-graz-2016",
     {"time.step_s=60", "thermal.facets=''", "thermal.facet_size_m=4",
      "thermal.exchange_patches=64", "thermal.samples=1", "optics.samples=1",
      "thermal.accuracy_K=0.03", NULL},
     true},
    {"envisat-paper",
     {"time.step_s=60", "thermal.facet_size_m=4", "thermal.exchange_patches=64",
      "thermal.samples=1", "optics.samples=1", "thermal.accuracy_K=0.03", NULL},
     false},
    {"hidden-effect/dawn", {"time.step_s=60", "optics.samples=1", NULL}, false},
    {"hidden-effect/dusk", {"time.step_s=60", "optics.samples=1", NULL}, false},
    {"blind/a", {"time.step_s=60", "optics.samples=1", NULL}, false},
    {"blind/d", {"time.step_s=60", "optics.samples=1", NULL}, false},
};
#define NSCENARIO (sizeof scenarios / sizeof scenarios[0])

static void need(struct um_context *context, enum um_status status)
{
  if (status != UM_OK) fail_msg("%s", um_core_message(context));
}

static size_t overrides_of(size_t which, const char *const *more, const char *out[16])
{
  size_t n = 0;
  for (size_t i = 0; scenarios[which].coarse[i] != NULL; i++) out[n++] = scenarios[which].coarse[i];
  for (; *more != NULL; more++) out[n++] = *more;
  return n;
}

/* Nothing is made inside: what parts, groups and interiors release. */
static void switch_off(const struct um_model *model)
{
  struct um_thermal_network *network = model->body->network;
  for (uint32_t i = 0; i < um_thermal_network_nodes(network); i++)
    um_thermal_network_power_set(network, i, 0.0);
}

/* Without Sun and power a satellite lies between deep space and the Earth, whose 237 W/m2 (more
 * where the scenario says so) are those of a black body: no node is warmer than (M / sigma)^(1/4),
 * 254.3 K, nor colder than space. The repeating state is found to 0.01 K, tables of optics by
 * temperature and what exchange leaves out are worth less. */
static void second_law(void **state)
{
  (void)state;
  static const char *const dark[] = {"environment.solar_irradiance_W_m2=0", "environment.albedo=0",
                                     "thermal.start=periodic", "thermal.orbits_before=1", NULL};
  for (size_t which = 0; which < NSCENARIO; which++) {
    char path[512];
    const char *overrides[16];
    struct support_run run = {0};
    snprintf(path, sizeof path, UMBRA_SOURCE_DIR "/scenarios/%s", scenarios[which].name);
    size_t n = overrides_of(which, dark, overrides);
    const struct um_model_options options = {.overrides = overrides, .noverride = n};
    need(NULL, um_core_context_create(NULL, &run.context));
    need(run.context, um_model_create(run.context, path, &options, &run.model));
    switch_off(run.model);
    need(run.context, um_model_precompute(run.context, run.model, &run.tables));
    need(run.context, um_model_run(run.context, run.model, run.tables, &run.result));
    double warmest = 0.0, coldest = INFINITY;
    for (size_t k = 0; k < run.result->nobs * run.result->nnode; k++) {
      warmest = fmax(warmest, run.result->node_temperature[k]);
      coldest = fmin(coldest, run.result->node_temperature[k]);
    }
    double earth = pow(run.model->environment.outgoing_longwave / UM_STEFAN_BOLTZMANN, 0.25);
    print_message("%-20s %8.3f to %8.3f K, the Earth %8.3f K\n", scenarios[which].name, coldest,
                  warmest, earth);
    if (!(warmest <= earth + 0.02)) fail_msg("%s: %.3f K", scenarios[which].name, warmest);
    double space = run.model->scenario->thermal->space_temperature_K;
    if (!(coldest >= space - 0.02)) fail_msg("%s: %.3f K", scenarios[which].name, coldest);
    support_release(&run);
  }
}

/* Ten orbits from 280 K with all that each scenario has: what comes in less what goes out is what
 * is stored, to 1e-6 of both. */
static void energy_over_ten_orbits(void **state)
{
  (void)state;
  static const char *const long_run[] = {"thermal.start=isothermal", "thermal.orbits_before=10",
                                         "thermal.step_s=20", NULL};
  for (size_t which = 0; which < NSCENARIO; which++) {
    char path[512];
    const char *overrides[16];
    struct support_run run;
    if (!scenarios[which].ten) continue;
    snprintf(path, sizeof path, UMBRA_SOURCE_DIR "/scenarios/%s", scenarios[which].name);
    size_t n = overrides_of(which, long_run, overrides);
    support_compute(path, overrides, n, &run);
    print_message("%-20s audit %.1e\n", scenarios[which].name, run.result->audit_error);
    if (!(run.result->audit_error <= 1e-6))
      fail_msg("%s: %.2e", scenarios[which].name, run.result->audit_error);
    support_release(&run);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(second_law),
      cmocka_unit_test(energy_over_ten_orbits),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
