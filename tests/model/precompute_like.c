/* What stays of geometry tables while the body stays: for every key below tracing with
 * the tables of another gives what tracing anew gives, number for number, and the tables are shared
 * where they hang on nothing that was changed. */
#include <math.h>
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

/* What a number may be off by, of the largest: nothing where it is traced, so that it differs in
 * the last of 24 bits alone; the rounding of 64 of them where it is a mean over a turn. */
static double of_largest;

static void near(const char *what, const float *a, const float *b, size_t n)
{
  double most = 0.0;
  assert_true((a == NULL) == (b == NULL));
  for (size_t i = 0; a != NULL && i < n; i++) most = fmax(most, fabs((double)b[i]));
  for (size_t i = 0; a != NULL && i < n; i++) {
    double off = fabs((double)a[i] - (double)b[i]);
    if (!(off <= 2e-7 * fabs((double)b[i]) + of_largest * most))
      fail_msg("%s %zu: %.9g, traced %.9g", what, i, (double)a[i], (double)b[i]);
  }
}

static void loads_near(const struct um_irradiation_loads *a, const struct um_irradiation_loads *b)
{
  if (a == NULL || b == NULL) {
    assert_true(a == b);
    return;
  }
  size_t n = b->ntime * b->nsurface;
  assert_true(a->ntime == b->ntime && a->nsurface == b->nsurface && a->nedge == b->nedge);
  assert_true(same(a->t, b->t, a->ntime, sizeof *a->t));
  assert_true(same(a->sunlit, b->sunlit, a->ntime, sizeof *a->sunlit));
  assert_true(same(a->edge, b->edge, a->nedge, sizeof *a->edge));
  assert_true(same(a->sun, b->sun, n, sizeof *a->sun));
  assert_true(same(a->incidence, b->incidence, n, sizeof *a->incidence));
  assert_true(same(a->by_cosine, b->by_cosine, n * UM_IRRADIATION_COSINES, sizeof(float)));
  assert_true(same(a->gas, b->gas, n, sizeof(float)));
  for (size_t k = 0; k < a->ntime; k++) assert_close(a->irradiance[k], b->irradiance[k], 1e-9);
  near("view factor", a->view_factor, b->view_factor, n);
  near("albedo", a->albedo, b->albedo, n);
  near("planet", a->planet, b->planet, n);
  near("moments of albedo", a->albedo_moments, b->albedo_moments, n * UM_ANGULAR_MOMENTS);
  near("moments of planet", a->planet_moments, b->planet_moments, n * UM_ANGULAR_MOMENTS);
}

static void tables_near(const struct um_model_tables *a, const struct um_model_tables *b)
{
  size_t n = b->mirrored->ntime * UM_GEOMETRY_SKY_CELLS,
         nsun = b->mirrored->begin[b->mirrored->ntime];
  assert_true(um_model_times_equal(a, b) && views_equal(a->view, b->view));
  assert_true(um_model_view_factors_equal(a->view_factors, b->view_factors));
  assert_true((a->seen == a->loads) == (b->seen == b->loads));
  loads_near(a->loads, b->loads);
  loads_near(a->seen, b->seen);
  loads_near(a->spin_variation, b->spin_variation);
  near("mirrored albedo", a->mirrored->albedo, b->mirrored->albedo, n);
  near("mirrored planet", a->mirrored->planet, b->mirrored->planet, n);
  assert_true(nsun > 0 && a->mirrored->sets.n == b->mirrored->sets.n);
  assert_true(same(a->mirrored->sun, b->mirrored->sun, nsun, sizeof *a->mirrored->sun));
}

/* What is not in proportion is not scaled. */
static const struct {
  const char *set[MOST], *with;
  bool scales;
} levels[] = {
    {{"environment.albedo=0"}, NULL, true},
    {{"environment.olr_W_m2=200", "environment.albedo=0.4"}, "solar_irradiance,factor=0.9", true},
    {{"environment.albedo=0.5", "thermal.samples=3"}, NULL, false},
    {{"environment.albedo=0.5", "environment.earth=knocke"}, NULL, false},
    {{"environment.earth=knocke"}, NULL, false},
    {{"environment.albedo=0.5", "orbit.circular.beta_deg=21"}, NULL, false},
    {{"environment.albedo=0.5", "parts.wing.pose.position_m=[0,1.3,0]"}, NULL, false},
    {{NULL}, "free_molecular_heating", false},
};

/* The Sun from below, so that it is mirrored, too. */
static struct um_model *build_level(const char *spin, const char *const set[MOST], const char *with)
{
  const char *all[MOST + 2] = {"orbit.circular.beta_deg=-20", spin};
  struct um_model *model = NULL;
  struct um_model_options options = {
      .overrides = all, .noverride = 2, .with = &with, .nwith = with != NULL};
  for (size_t k = 0; k < MOST && set[k] != NULL; k++) all[options.noverride++] = set[k];
  need(um_model_create(context, FILE_NAME, &options, &model));
  return model;
}

/* An Earth that differs from place to place goes by the Sun alone. */
static void test_places_go_by_the_sun(void **state)
{
  (void)state;
  static const char *const set[MOST] = {"environment.earth=knocke"};
  static const char *const albedo[MOST] = {"environment.earth=knocke", "environment.albedo=0.5"};
  const char *spin = "thermal.spin_loads=resolved";
  struct um_model *made = build_level(spin, set, NULL), *other = build_level(spin, albedo, NULL);
  struct um_model *model = build_level(spin, set, "solar_irradiance,factor=0.9");
  struct um_model_tables *own = NULL, *scaled = NULL, *anew = NULL;
  of_largest = 1e-6; /* what differs from the mean is a sum of its own */
  need(um_model_precompute(context, made, &own));
  need(um_model_precompute_scaled(context, made, own, other, NULL, &scaled));
  assert_null(scaled);
  need(um_model_precompute_scaled(context, made, own, model, NULL, &scaled));
  need(um_model_precompute(context, model, &anew));
  assert_non_null(scaled);
  tables_near(scaled, anew);
  near("brightness", scaled->loads->brightness, anew->loads->brightness,
       anew->loads->ntime * anew->loads->nsurface);
  um_model_tables_destroy(context, &own);
  um_model_tables_destroy(context, &scaled);
  um_model_tables_destroy(context, &anew);
  um_model_destroy(context, &made);
  um_model_destroy(context, &other);
  um_model_destroy(context, &model);
}

static void test_scaled_is_nearly_as_traced(void **state)
{
  (void)state;
  static const char *const spin[] = {"thermal.spin_loads=resolved", "thermal.spin_loads=averaged"};
  static const char *const none[MOST] = {NULL};
  for (int s = 0; s < 2; s++) {
    struct um_model *made = build_level(spin[s], none, NULL);
    struct um_model_tables *own = NULL;
    of_largest = s == 1 ? 64.0 * 6e-8 : 1e-12;
    need(um_model_precompute(context, made, &own));
    for (size_t i = s == 0 ? 0 : 1; i < (s == 0 ? sizeof levels / sizeof *levels : 2); i++) {
      struct um_model *model = build_level(spin[s], levels[i].set, levels[i].with);
      struct um_model_tables *scaled = NULL, *anew = NULL;
      need(um_model_precompute_scaled(context, made, own, model, NULL, &scaled));
      if ((scaled != NULL) != levels[i].scales) fail_msg("levels %zu: scaled", i);
      if (scaled != NULL) {
        need(um_model_precompute(context, model, &anew));
        tables_near(scaled, anew);
      }
      um_model_tables_destroy(context, &scaled);
      um_model_tables_destroy(context, &anew);
      um_model_destroy(context, &model);
    }
    um_model_tables_destroy(context, &own);
    um_model_destroy(context, &made);
  }
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
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_like_is_as_traced), cmocka_unit_test(test_scaled_is_nearly_as_traced),
      cmocka_unit_test(test_places_go_by_the_sun), cmocka_unit_test(test_like_outlives)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
