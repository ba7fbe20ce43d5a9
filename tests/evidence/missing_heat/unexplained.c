/* Heat that no catalogue has: of known place, shape, start and energy, put into a small world by
 * power_file, with noise. The model that looks for them has the same parts, so what is tested is
 * the linear response, the search and the history; the laboratory has other meshes. */
#include "evidence/missing_heat/unexplained.h"

#include "evidence/missing_heat/observations_impl.h"
#include "evidence/missing_heat/policy.h"
#include "tests/base/inference/observations_test.h"
#include "tests/evidence/sensitivity/forward_test.h"
#include "tests/support/allocator.h"

#define STEP 6.0 /* between observations of light [s] */
#define ROWS 90
#define DAY0 "2016-09-06T18:09:00Z"

struct hidden {
  const char *key, *place;
  enum um_thermal_course_shape shape;
  double from, last, period, power; /* [s] after DAY0, [s], [s], [W] */
};

static void time_text(double seconds, char out[32])
{
  int s = 9 * 60 + (int)seconds;
  snprintf(out, 32, DAY "%02d:%02dZ", s / 60, s % 60);
}

/* A set with light at every step and two temperatures at every fifth. value NULL: any. */
static void put_rows(const double *value, const double *noise)
{
  FILE *file = fopen("m.csv", "w");
  size_t n = 0;
  assert_non_null(file);
  fputs("time_utc,quantity,of,value,sigma\n", file);
  for (int k = 0; k < ROWS; k++) {
    const char *const rows[] = {"band_irradiance,lwir", "temperature,panel.front",
                                "temperature,bus.interior"};
    const double sigma[] = {3e-14, 0.3, 0.3};
    char text[32];
    time_text(k * STEP, text);
    for (size_t i = 0; i < (k % 5 == 0 ? 3 : 1); i++, n++)
      fprintf(file, "%s,%s,%.17g,%g\n", text, rows[i],
              value == NULL ? (i == 0 ? 1.0 : 300.0) : value[n] + sigma[i] * noise[n], sigma[i]);
  }
  assert_int_equal(fclose(file), 0);
}

static void put_jump(FILE *file, double t, double from, double to)
{
  char text[32];
  time_text(t, text);
  fprintf(file, "%s,%.9g\n%s,%.9g\n", text, from, text, to);
}

/* A decay has a row a second. */
static void put_power(const struct hidden *p)
{
  FILE *file = fopen("power.csv", "w");
  double until = 15.0 * 60.0;
  assert_non_null(file);
  fputs("time_utc,power_W\n" DAY "00:00Z,0\n", file);
  if (p->shape == UM_HEAT_DECAY) put_jump(file, p->from, 0.0, p->power);
  for (double t = p->from + 1.0; p->shape == UM_HEAT_DECAY && t < until; t += 1.0) {
    double power = p->power * exp(-(t - p->from) / p->last);
    put_jump(file, t, power, power);
  }
  if (p->shape == UM_HEAT_STEP || p->shape == UM_HEAT_PULSE) {
    put_jump(file, p->from, 0.0, p->power);
    put_jump(file, p->shape == UM_HEAT_STEP ? until : p->from + p->last, p->power, 0.0);
  }
  for (double t = p->from; p->shape == UM_HEAT_PERIODIC && t < until; t += p->period) {
    put_jump(file, t, 0.0, p->power);
    put_jump(file, t + p->last, p->power, 0.0);
  }
  fputs(DAY "30:00Z,0\n", file);
  assert_int_equal(fclose(file), 0);
}

/* Energy until the last observation [J], by small steps. */
static double energy_of(const struct hidden *p)
{
  double sum = 0.0, end = (ROWS - 1) * STEP, step = 0.01;
  for (double t = p->from + 0.5 * step; t < end; t += step) {
    double since = t - p->from;
    if (p->shape == UM_HEAT_DECAY)
      sum += step * exp(-since / p->last);
    else if (p->shape == UM_HEAT_STEP || fmod(since, p->period) < p->last)
      sum += step;
  }
  return p->power * sum;
}

/* Values of the true world (linear = unit of the observations: no magnitudes). */
static size_t true_values(const struct um_model_options *options, double *value)
{
  put_rows(NULL, NULL);
  struct um_compare_measurements *m = measured();
  struct um_sensitivity_forward *f = forward_of(options, m);
  assert_ok(um_sensitivity_forward_evaluate(context, f, NULL, 0, value));
  size_t n = f->observations.count;
  um_sensitivity_forward_destroy(context, &f);
  um_compare_measurements_destroy(context, &m);
  return n;
}

/* Integration that leaves less than what a small pulse does. */
static const char *const fine[] = {"thermal.relative_tolerance=1e-9",
                                   "thermal.absolute_tolerance_K=1e-7"};
static const struct um_model_options fine_options = {.overrides = fine, .noverride = 2};

#define ONCE 1e9 /* a period after which nothing is observed */
static const struct hidden hiddens[] = {
    {"parts.bus.interior.power_file", "bus.interior", UM_HEAT_PULSE, 150, 120, ONCE, 120.0},
    {"parts.panel.groups.plate.power_file", "panel", UM_HEAT_PULSE, 120, 60, ONCE, 300.0},
    {"parts.bus.groups.+z.power_file", "bus.+z", UM_HEAT_PULSE, 200, 120, ONCE, 250.0},
    {"parts.bus.interior.power_file", "bus.interior", UM_HEAT_STEP, 185, ONCE, ONCE, 60.0},
    {"parts.panel.groups.plate.power_file", "panel", UM_HEAT_DECAY, 130, 80, ONCE, 300.0},
    {"parts.panel.groups.plate.power_file", "panel", UM_HEAT_PERIODIC, 95, 40, 110, 250.0},
};

/* The world with a pulse of a power, and measurements of it with `noise` sigma; false light: times
 * this factor. */
static void put_hidden(const struct hidden *p, double noise, uint64_t seed, double light)
{
  double value[3 * ROWS], normal[3 * ROWS];
  char key[128];
  const char *const set[] = {fine[0], fine[1], key};
  struct um_model_options options = {.overrides = set, .noverride = p != NULL ? 3 : 2};
  put_world("");
  if (p != NULL) {
    put_power(p);
    snprintf(key, sizeof key, "%s=power.csv", p->key);
  }
  size_t n = true_values(&options, value);
  for (size_t i = 0; i < n; i++) {
    normal[i] = noise * rows_normal(seed, i);
    if (value[i] < 1.0) value[i] *= light;
  }
  put_rows(value, normal);
  remove("power.csv");
}

/* What is missing in those measurements; nuisance: the level of the light, free. */
static struct um_missing_heat_unexplained *look(bool nuisance)
{
  double value[3 * ROWS], column[3 * ROWS];
  struct um_compare_measurements *m = measured();
  struct um_sensitivity_forward *f = forward_of(NULL, m);
  struct um_missing_heat_unexplained *u;
  assert_ok(um_sensitivity_forward_evaluate(context, f, NULL, 0, value));
  for (size_t i = 0; i < f->observations.count; i++)
    column[i] = value[i] < 1.0 ? value[i] / f->observations.sigma[i] : 0.0;
  assert_ok(
      um_missing_heat_unexplained_create(context, f, NULL, 0, value, column, nuisance ? 1 : 0, &u));
  um_sensitivity_forward_destroy(context, &f);
  um_compare_measurements_destroy(context, &m);
  return u;
}

static double day0(void)
{
  struct um_compare_measurements *m = measured();
  double t = m->row[0].t_tai;
  um_compare_measurements_destroy(context, &m);
  return t;
}

/* Observations per watt against the model itself with 2 W, without noise: what differs is the bend,
 * 2 W warm by a tenth of a kelvin at most, 0.2 % of the radiance's slope, and the integration of
 * heat (5 mK in an orbit, far less in a window; 1e-3 sigma here). */
static void test_columns(void **state)
{
  (void)state;
  for (size_t i = 0; i < 3; i += 2) {
    struct hidden p = hiddens[i];
    double value[3 * ROWS], column[3 * ROWS], most = 0.0, off = 0.0;
    p.power = 2.0;
    put_hidden(&p, 0.0, 0, 1.0);
    struct um_compare_measurements *m = measured();
    struct um_sensitivity_forward *f = forward_of(&fine_options, m);
    struct um_missing_heat_base base;
    struct um_missing_heat_place *place;
    size_t nplace, at = 0;
    assert_ok(um_sensitivity_forward_evaluate(context, f, NULL, 0, value));
    assert_ok(um_missing_heat_base_create(context, f, NULL, 0, &base));
    assert_ok(um_missing_heat_places_create(context, base.variant.model, &place, &nplace));
    assert_int_equal(nplace, 8); /* six walls, an interior, a panel */
    while (strcmp(place[at].name, p.place) != 0) assert_true(++at < nplace);
    const double edge[2] = {day0() + p.from, day0() + p.from + p.last};
    assert_ok(um_missing_heat_columns(context, &base, &place[at], 1, 1, edge, column));
    for (size_t j = 0; j < f->observations.count; j++) {
      double change = (f->observations.measured[j] - value[j]) / f->observations.sigma[j];
      most = fmax(most, fabs(change));
      off = fmax(off, fabs(change - p.power * column[j]));
    }
    print_message("%s: 2 W change a row by %.3g sigma at most, the response misses %.2g\n", p.place,
                  most, off);
    assert_true(most > 0.05);
    assert_close(off, 0.0, 0.005 * most + 2e-3);
    um_missing_heat_places_destroy(context, &place, nplace);
    um_missing_heat_base_release(context, &base);
    um_sensitivity_forward_destroy(context, &f);
    um_compare_measurements_destroy(context, &m);
  }
}

/* The band of the history holds the truth of a bin in 19 of 20, its sum the energy to as much as
 * noise and small changes may hide. */
static void check_history(const struct um_missing_heat *h, const struct hidden *p, double start)
{
  const struct um_thermal_course truth = {p->shape, start, p->last, p->period};
  double sum = 0.0, energy = energy_of(p);
  size_t held = 0;
  for (size_t b = 0; b < h->nbin; b++) {
    double length = h->t[b + 1] - h->t[b];
    double mean = p->power *
                  (um_thermal_course_energy(&truth, h->t[b + 1]) -
                   um_thermal_course_energy(&truth, h->t[b])) /
                  length;
    sum += h->heat[b] * length;
    held += h->low[b] <= mean && mean <= h->high[b];
    assert_true(h->sigma[b] >= 0.0 && isfinite(h->sigma[b]));
    assert_true(h->low[b] <= h->heat[b] && h->heat[b] <= h->high[b]);
  }
  print_message("  history %.4g of %.4g J; the band holds %zu of %zu bins\n", sum, energy, held,
                h->nbin);
  if (strcmp(p->place, "bus.+z") != 0) /* it turns out of sight, and then nothing is known */
    assert_close(sum, energy, 0.2 * energy);
  assert_true((double)held >= 0.85 * (double)h->nbin);
}

/* Place right, start and energy within three of their sigmas, the shape the best or nearly: a wall
 * that turns out of sight cannot tell. The level of the light is free in the second. */
static void test_shapes(void **state)
{
  (void)state;
  for (size_t i = 0; i < sizeof hiddens / sizeof *hiddens; i++) {
    const struct hidden *p = &hiddens[i];
    put_hidden(p, 1.0, 41 + i, 1.0);
    struct um_missing_heat_unexplained *u = look(i == 1);
    double energy = energy_of(p), start = day0() + p->from;
    const struct um_missing_heat *h = &u->heat[0];
    char text[UM_MISSING_HEAT_TEXT];
    um_missing_heat_text(h, text);
    print_message("%s %s: %s, start %+.1f +- %.1f s, %.4g +- %.2g of %.4g J%s; chi-square %.4g of "
                  "%.4g, next %s with %.4g; %s with %s (%.2g)\n",
                  p->place, um_thermal_course_name(p->shape), h->place, h->course.start - start,
                  h->start_sigma, h->energy, h->energy_sigma, energy, text, h->chi2_explained,
                  u->chi2_before, u->heat[1].place, u->heat[1].chi2_explained, u->channel,
                  u->coordinate, u->p);
    assert_true(u->found);
    assert_string_equal(h->place, p->place);
    assert_true(h->behind[p->shape] < UM_MISSING_HEAT_RIVAL);
    if (i > 2) assert_int_equal(h->course.shape, p->shape);
    assert_close(h->course.start, start, 3.0 * h->start_sigma);
    assert_close(h->energy, energy, 0.2 * energy);
    assert_close(h->energy, energy, 3.0 * h->energy_sigma);
    assert_close(h->energy, h->power * um_thermal_course_energy(&h->course, h->stop),
                 1e-9 * energy);
    assert_close(u->chi2_after, u->chi2_before - h->chi2_explained, 1e-9);
    check_history(h, p, start);
    um_missing_heat_unexplained_destroy(context, &u);
  }
}

/* Neither noise nor light that is a tenth too bright is heat; the latter is named by its channel.
 */
static void test_no_pulse(void **state)
{
  (void)state;
  put_hidden(NULL, 1.0, 51, 1.0);
  struct um_missing_heat_unexplained *u = look(false);
  assert_int_equal(u->nheat, 8);
  assert_false(u->found);
  um_missing_heat_unexplained_destroy(context, &u);
  put_hidden(NULL, 1.0, 52, 1.1);
  u = look(false);
  print_message("a tenth brighter: %s, %s; heat explains %.4g of %.4g\n", u->channel, u->coordinate,
                u->heat[0].chi2_explained, u->chi2_before);
  assert_string_equal(u->channel, "band_irradiance lwir");
  assert_false(u->found);
  um_missing_heat_unexplained_destroy(context, &u);
}

/* Memory that runs out at one of many places all along: the call says so and leaves nothing. */
static void test_memory(void **state)
{
  struct um_test_memory memory = {0};
  struct um_core_allocator allocator = um_test_memory_allocator(&memory);
  struct um_context *kept = context;
  struct um_missing_heat_unexplained *u;
  double value[3 * ROWS];
  (void)state;
  assert_int_equal(um_core_context_create(&allocator, &context), UM_OK);
  put_world(""); /* with a small set of its own */
  struct um_compare_measurements *m = measured();
  struct um_sensitivity_forward *f = forward_of(NULL, m);
  assert_ok(um_sensitivity_forward_evaluate(context, f, NULL, 0, value));
  long alive = memory.alive, first = memory.calls;
  assert_ok(um_missing_heat_unexplained_create(context, f, NULL, 0, value, NULL, 0, &u));
  um_missing_heat_unexplained_destroy(context, &u);
  assert_int_equal(memory.alive, alive);
  long calls = memory.calls - first;
  for (long i = 1; i <= calls; i += 1 + calls / 11) {
    um_core_message_clear(context);
    memory.calls = 0;
    memory.fail_call = i;
    assert_int_equal(um_missing_heat_unexplained_create(context, f, NULL, 0, value, NULL, 0, &u),
                     UM_ERR_MEMORY);
    memory.fail_call = 0;
    assert_null(u);
    assert_int_equal(memory.alive, alive);
  }
  um_sensitivity_forward_destroy(context, &f);
  um_compare_measurements_destroy(context, &m);
  um_core_context_destroy(&context);
  assert_int_equal(memory.alive, 0);
  context = kept;
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_columns), cmocka_unit_test(test_shapes),
                                     cmocka_unit_test(test_no_pulse),
                                     cmocka_unit_test(test_memory)};
  return cmocka_run_group_tests(tests, model_set_up, model_tear_down);
}
