/* What stays of geometry tables while the body stays: for every key below tracing with
 * the tables of another gives what tracing anew gives, number for number, and the tables are shared
 * where they hang on nothing that was changed. */
#include <stdio.h>

#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "tests/model/traced_help.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

#define FILE_NAME "precompute_like_scenario.yaml"

/* Nothing moves; the wing hides part of the Earth from the box, and mirrors it. */
static const char *const scenario =
    "schema: 1\n"
    "name: like\n"
    "time: {start_utc: 2020-03-20T12:00:00Z, stop_utc: 2020-03-20T12:04:00Z, step_s: 60}\n"
    "orbit:\n"
    "  circular: {altitude_km: 600, beta_deg: 20}\n"
    "attitude: [{spin: {axis_lvlh: [0, 1, 0], axis_body: [0, 0, 1], period_s: 200, phase_deg: 0,\n"
    "                   at_utc: 2020-03-20T12:00:00Z}}]\n"
    "observer: {direction: {unit_gcrs: [0.5, 0.7, 0.1], range_km: 1000}}\n"
    "parts:\n"
    "  - {name: box, box: {size_m: [1, 1, 1]}, outside: aluminium_anodised, facet_size_m: 0.6,\n"
    "     interior: {capacity_J_K: 1000, power_W: 5, conductance_W_K: 1},\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000, conductance_W_K: 0.3}}\n"
    "  - {name: wing, plate: {size_m: [2, 1]}, pose: {position_m: [0, 1.2, 0]},\n"
    "     front: cell_silicon, back: cfrp, facet_size_m: 0.6,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000, conductance_W_K: 0.03,\n"
    "             through_conductance_W_m2_K: 50}}\n"
    "contacts:\n"
    "  - {a: box, b: wing, conductance_W_K: 0.5}\n"
    "thermal: {start: isothermal, start_temperature_K: 290, orbits_before: 0.02,\n"
    "          view_factor_rays: 64}\n"
    "environment: {albedo: 0.3}\n"
    "optics: {samples: 4}\n"
    "bands:\n"
    "  vis: {from_um: 0.38, to_um: 0.78, bins: 4}\n"
    "  lwir: {from_um: 8, to_um: 12, bins: 4}\n";

#define MOST 3
static const struct {
  const char *set[MOST], *with, *without;
  bool shared;
} changes[] = {
    {{"attitude.0.spin.period_s=150"}, NULL, NULL, true},
    {{"attitude.0.spin.phase_deg=30"}, NULL, NULL, true},
    {{"orbit.circular.altitude_km=700", "orbit.circular.beta_deg=70"}, NULL, NULL, true},
    {{"time.stop_utc=2020-03-20T12:05:00Z", "thermal.orbits_before=0.03"}, NULL, NULL, true},
    {{"thermal.spin_loads=averaged"}, NULL, NULL, true},
    {{"thermal.samples=3"}, NULL, NULL, true}, /* of rays to the Sun alone */
    {{"environment.albedo=0.5"}, NULL, NULL, true},
    {{"parts.box.interior.power_W=50"}, NULL, NULL, true},
    {{NULL}, "attitude_offset,x_deg=1", NULL, true},
    {{"parts.wing.pose.position_m=[0,1.3,0]"}, NULL, NULL, false},
    {{"thermal.view_factor_rays=512"}, NULL, NULL, false},
    {{"thermal.exchange_patches=12"}, NULL, NULL, false},
    {{NULL}, NULL, "specular_exchange", false},
};
#define CHANGES (sizeof changes / sizeof changes[0])

static void need(enum um_status status)
{
  if (status != UM_OK) fail_msg("%s", um_core_message(context));
}

static struct um_model *build(size_t i)
{
  struct um_model *model = NULL;
  struct um_model_options options = {.overrides = changes[i].set,
                                     .with = &changes[i].with,
                                     .nwith = changes[i].with != NULL,
                                     .without = &changes[i].without,
                                     .nwithout = changes[i].without != NULL};
  while (options.noverride < MOST && changes[i].set[options.noverride] != NULL) options.noverride++;
  need(um_model_create(context, FILE_NAME, &options, &model));
  return model;
}

static void test_like_is_as_traced(void **state)
{
  (void)state;
  struct um_model *made = NULL;
  struct um_model_tables *own = NULL;
  need(um_model_create(context, FILE_NAME, NULL, &made));
  need(um_model_precompute(context, made, &own));
  assert_non_null(own->mirrored);
  for (size_t i = 0; i < CHANGES; i++) {
    struct um_model *model = build(i);
    struct um_model_tables *anew = NULL, *like = NULL;
    need(um_model_precompute(context, model, &anew));
    need(um_model_precompute_like(context, made, own, model, NULL, &like));
    if ((like->body == own->body) != changes[i].shared) fail_msg("change %zu: shared", i);
    if (!traced_equal(like, anew)) fail_msg("change %zu: not as traced", i);
    um_model_tables_destroy(context, &anew);
    um_model_tables_destroy(context, &like);
    um_model_destroy(context, &model);
  }
  um_model_tables_destroy(context, &own);
  um_model_destroy(context, &made);
}

/* Whoever goes last frees the tables; nothing of a model that is gone is looked at. */
static void test_like_outlives(void **state)
{
  (void)state;
  struct um_model *model[3];
  struct um_model_tables *p[3] = {NULL}, *anew = NULL;
  for (size_t i = 0; i < 3; i++) model[i] = build(i);
  need(um_model_precompute(context, model[0], &p[0]));
  need(um_model_precompute_like(context, model[0], p[0], model[1], NULL, &p[1]));
  um_model_tables_destroy(context, &p[0]);
  um_model_destroy(context, &model[0]);
  need(um_model_precompute_like(context, model[1], p[1], model[2], NULL, &p[2]));
  assert_ptr_equal(p[1]->body, p[2]->body);
  um_model_tables_destroy(context, &p[1]);
  um_model_destroy(context, &model[1]);
  need(um_model_precompute(context, model[2], &anew));
  assert_true(traced_equal(p[2], anew));
  um_model_tables_destroy(context, &anew);
  um_model_tables_destroy(context, &p[2]);
  um_model_destroy(context, &model[2]);
}

static int set_up(void **state)
{
  FILE *file = fopen(FILE_NAME, "w");
  if (file == NULL) return -1;
  fputs(scenario, file);
  fclose(file);
  return context_set_up(state);
}

static int tear_down(void **state)
{
  return remove(FILE_NAME) == 0 ? context_tear_down(state) : -1;
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_like_is_as_traced),
                                     cmocka_unit_test(test_like_outlives)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
