/* Loads of a body that spins, far apart before it is observed: fewer rows, and still the
 * temperatures and the light of rows that all stand as the turn asks for. */
#include <stdio.h>
#include <unistd.h>

#include "base/core/interpolation.h"
#include "model/build/build.h"
#include "model/geometry/compatible.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"
#include "tests/support/with_context.h"

/* It turns by 0.08 rad in 2 s, half of the time behind its wing. The wing, of which a turn is a
 * third of its time constant, forgets slowest what it missed. */
static const char scenario[] =
    "schema: 1\n"
    "name: sparse\n"
    "time: {start_utc: 2020-03-20T12:00:00Z, stop_utc: 2020-03-20T12:05:00Z, step_s: 3}\n"
    "orbit:\n"
    "  circular: {altitude_km: 600, beta_deg: 20}\n"
    "attitude: [{spin: {axis_lvlh: [0, 0.8, 0.6], axis_body: [0, 0, 1], period_s: 157}}]\n"
    "observer: {direction: {unit_gcrs: [0.5, 0.7, 0.1], range_km: 1000}}\n"
    "parts:\n"
    "  - {name: bus, box: {size_m: [1, 1, 1]}, outside: grey_white, lumped: true,\n"
    "     interior: {capacity_J_K: 50000, power_W: 5, conductance_W_K: 1},\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000}}\n"
    "  - {name: wing, plate: {size_m: [2, 1]}, pose: {position_m: [0, 1.1, 0.3]}, lumped: true,\n"
    "     front: grey_panel, back: grey_white,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000, through_conductance_W_m2_K: 50}}\n"
    "environment: {albedo: 0.3}\n"
    "optics: {samples: 4}\n"
    "thermal: {start: periodic, view_factor_rays: 64}\n"
    "bands:\n"
    "  vis: {from_um: 0.38, to_um: 0.78, bins: 4}\n"
    "  lwir: {from_um: 8, to_um: 12, bins: 4}\n";

static const struct um_model_instants sparse = {.sparse = true};
static char path[UM_TEST_PATH];
static struct um_model *model, *stated; /* stated: with thermal.step_s */
static struct um_model_tables *dense;   /* of `stated`: no row is left out */
static struct um_model_tables *own, *few;

static void need(enum um_status status)
{
  if (status != UM_OK) fail_msg("%s", um_core_message(context));
}

static int set_up(void **state)
{
  int failed = context_set_up(state);
  const char *const step[] = {"thermal.step_s=1.95"};
  const struct um_model_options options = {.overrides = step, .noverride = 1};
  um_test_file_create(path, scenario, sizeof scenario - 1);
  need(um_model_create(context, path, NULL, &model));
  need(um_model_create(context, path, &options, &stated));
  need(um_model_precompute(context, stated, &dense));
  need(um_model_precompute(context, model, &own));
  need(um_model_precompute_over(context, model, &sparse, &few));
  return failed;
}

static int tear_down(void **state)
{
  um_model_tables_destroy(context, &dense);
  um_model_tables_destroy(context, &own);
  um_model_tables_destroy(context, &few);
  um_model_destroy(context, &model);
  um_model_destroy(context, &stated);
  unlink(path);
  return context_tear_down(state);
}

/* Rows stand some 2 s apart in the five minutes before what is observed, and while it is; before,
 * three times as far. */
static void check_rows(const struct um_model_tables *tables)
{
  const struct um_irradiation_loads *l = tables->loads;
  double recent = tables->t_first - 300.0, longest[2] = {0.0, 0.0};
  for (size_t k = 1; k < l->ntime; k++) {
    double *to = &longest[l->t[k - 1] > recent - 1.0];
    *to = fmax(*to, l->t[k] - l->t[k - 1]);
  }
  print_message("%zu rows of %zu: up to %.3f s apart, then %.3f s\n", l->ntime, dense->loads->ntime,
                longest[0], longest[1]);
  assert_close(longest[1], 1.95, 0.05); /* the orbit turns, too */
  assert_close(longest[0] / longest[1], 3.0, 0.03);
  assert_close(l->t[0], dense->loads->t[0], 0.0);
  assert_close(l->t[l->ntime - 1], dense->loads->t[dense->loads->ntime - 1], 0.0);
}

/* Observed instants are rows, or, of sparse loads, none. */
static void test_rows(void **state)
{
  (void)state;
  check_rows(own);
  check_rows(few);
  assert_true(few->sparse && !own->sparse && !dense->sparse);
  assert_true(own->loads->ntime < dense->loads->ntime * 55 / 100);
  assert_true(few->loads->ntime < own->loads->ntime - own->nobs / 2);
  for (size_t k = 0; k < own->nobs; k++)
    assert_close(own->seen->t[own->load_row[k]], own->sample[k].t_tai, 0.0);
}

/* Where observed instants stand closer than rows need to, there are no others. */
static void test_close_instants(void **state)
{
  (void)state;
  struct um_model_tables *tables;
  double time[8];
  for (int k = 0; k < 8; k++) time[k] = own->t_first + 60.0 + k;
  const struct um_model_instants instants = {.time = time, .count = 8};
  need(um_model_precompute_over(context, model, &instants, &tables));
  const struct um_irradiation_loads *l = tables->loads;
  size_t first = l->ntime - 8;
  for (size_t k = 0; k < 8; k++) assert_close(l->t[first + k], tables->sample[k].t_tai, 0.0);
  um_model_tables_destroy(context, &tables);
}

/* What is observed has loads linear between rows, column by column. */
static void test_between(void **state)
{
  (void)state;
  const struct um_irradiation_loads *l = few->loads, *seen = few->seen;
  assert_true(seen != l && seen->ntime == few->nobs && seen->nedge == 0);
  const float *const from[] = {l->sun, l->incidence, l->albedo, l->planet, l->view_factor};
  const float *const to[] = {seen->sun, seen->incidence, seen->albedo, seen->planet,
                             seen->view_factor};
  for (size_t k = 0; k < few->nobs; k++) {
    double t = few->sample[k].t_tai;
    size_t i = um_core_interval_find(l->t, l->ntime, t);
    double u = (t - l->t[i]) / (l->t[i + 1] - l->t[i]);
    assert_int_equal(few->load_row[k], k);
    assert_close(seen->t[k], t, 0.0);
    assert_close(seen->irradiance[k], l->irradiance[i], 1e-4);
    for (size_t s = 0; s < l->nsurface; s++)
      for (int c = 0; c < 5; c++) {
        double a = (double)from[c][i * l->nsurface + s],
               b = (double)from[c][(i + 1) * l->nsurface + s];
        assert_close((double)to[c][k * l->nsurface + s], a + u * (b - a), 1e-4);
      }
  }
}

/* Loads of an atmosphere and angles go the same way, and what the Earth shows place by place. */
static void test_columns(void **state)
{
  (void)state;
  struct um_irradiation_loads *l, *out;
  const double times[] = {1.0, 2.0, 2.75, 9.0};
  need(um_irradiation_loads_create(context, 2, 1, 1, &l));
  need(um_core_allocate(context, 2, sizeof(float), &l->gas));
  need(um_core_allocate(context, 2, sizeof(float), &l->brightness));
  need(um_core_allocate(context, 2 * UM_ANGULAR_MOMENTS, sizeof(float), &l->planet_moments));
  for (size_t k = 0; k < 2; k++) {
    l->t[k] = 2.0 + (double)k;
    l->sunlit[k] = (double)k;
    l->gas[k] = l->brightness[k] = 4.0F * (float)k;
    for (size_t m = 0; m < UM_ANGULAR_MOMENTS; m++)
      l->planet_moments[k * UM_ANGULAR_MOMENTS + m] = (float)(k * (m + 1));
  }
  need(um_irradiation_loads_between(context, l, times, 4, &out));
  assert_true(out->albedo_moments == NULL && out->nedge == 0);
  const double want[] = {0.0, 0.0, 0.75, 1.0};
  for (size_t k = 0; k < 4; k++) {
    assert_close(out->sunlit[k], want[k], 1e-12);
    assert_close((double)out->gas[k], 4.0 * want[k], 1e-6);
    assert_close((double)out->brightness[k], 4.0 * want[k], 1e-6);
    for (size_t m = 0; m < UM_ANGULAR_MOMENTS; m++)
      assert_close((double)out->planet_moments[k * UM_ANGULAR_MOMENTS + m],
                   want[k] * (double)(m + 1), 1e-6);
  }
  um_irradiation_loads_destroy(context, &out);
  um_irradiation_loads_destroy(context, &l);
}

/* Places agree to 0.1 K over what is observed, and the brightest light to 1e-3: what an answer
 * needs. Sunlight comes and goes within one row of either; no more is asked of an instant. */
static void check_run(const struct um_model_result *whole, struct um_model_tables *tables)
{
  struct um_model_result *r;
  need(um_model_run(context, model, tables, &r));
  for (size_t p = 0; p < whole->nplace; p++) {
    double mean = 0.0;
    for (size_t k = 0; k < whole->nobs; k++)
      mean += (r->place[p].mean[k] - whole->place[p].mean[k]) / (double)whole->nobs;
    print_message("place %zu: %.2g K\n", p, mean);
    assert_close(mean, 0.0, 0.1);
  }
  for (size_t b = 0; b < whole->nband; b++) {
    double most[2] = {0.0, 0.0};
    for (size_t k = 0; k < whole->nobs; k++) {
      most[0] = fmax(most[0], um_model_result_intensity(whole, k, b, -1));
      most[1] = fmax(most[1], um_model_result_intensity(r, k, b, -1));
    }
    print_message("band %zu: %.2g\n", b, most[1] / most[0] - 1.0);
    assert_true(b == 0 || most[1] != most[0]); /* it is another solution */
    assert_close(most[1] / most[0], 1.0, 1e-3);
  }
  um_model_result_destroy(context, &r);
}

static void test_run(void **state)
{
  (void)state;
  struct um_model_result *whole;
  need(um_model_run(context, stated, dense, &whole));
  check_run(whole, own);
  check_run(whole, few);
  um_model_result_destroy(context, &whole);
}

/* One does not serve for the other; where a step is stated there is but one. */
static void test_compatible(void **state)
{
  (void)state;
  bool compatible;
  need(um_model_tables_are_compatible(context, model, few, &sparse, model, &compatible));
  assert_true(compatible);
  need(um_model_tables_are_compatible(context, model, few, NULL, model, &compatible));
  assert_false(compatible);
  need(um_model_tables_are_compatible(context, model, own, &sparse, model, &compatible));
  assert_false(compatible);
  struct um_model_tables *p;
  need(um_model_precompute_over(context, stated, &sparse, &p));
  assert_true(!p->sparse && p->seen == p->loads);
  um_model_tables_destroy(context, &p);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_rows),    cmocka_unit_test(test_close_instants),
      cmocka_unit_test(test_between), cmocka_unit_test(test_columns),
      cmocka_unit_test(test_run),     cmocka_unit_test(test_compatible)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
