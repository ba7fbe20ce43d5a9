/* Answers by hand, judged: what each figure of the benchmark of diagnosis counts. */
#include <math.h>
#include <string.h>

#include "tests/bench/worlds.h"
#include "tests/support/cmocka_all.h"

static struct worlds_answer answer(const char *verdict, const char *certain, const char *groups,
                                   const char *values)
{
  struct worlds_answer a = {.world = "x", .method = "hand", .probability = NAN};
  strcpy(a.verdict, verdict);
  strcpy(a.certain, certain);
  strcpy(a.groups, groups);
  strcpy(a.values, values);
  return a;
}

static struct worlds_judgement judge(const struct worlds_world *world, struct worlds_answer a)
{
  struct worlds_judgement j;
  worlds_judge(world, &a, &j);
  return j;
}

static const struct worlds_world power = {
    .good = WORLDS_FOUND,
    .also = "stored_heat:bus",
    .nhidden = 1,
    .hidden = {
        {.names = "internal_power:bus*", .nvalue = 1, .parameter = {"power_W"}, .value = {25.0}}}};
static const struct worlds_world nothing = {.good = WORLDS_COMPLETE};

static void test_names(void **state)
{
  (void)state;
  assert_true(worlds_names_match("albedo|heater:bus*", "heater:bus.interior"));
  assert_true(worlds_names_match("albedo|heater:bus*", "albedo"));
  assert_false(worlds_names_match("albedo|heater:bus*", "albedo_level"));
  assert_false(worlds_names_match("albedo|heater:bus*", "heater:array"));
  assert_false(worlds_names_match("", "albedo"));
}

static void test_named(void **state)
{
  (void)state;
  struct worlds_judgement j =
      judge(&power, answer("found", "internal_power:bus", "", "internal_power:bus power_W 24 0.5"));
  assert_true(j.detected && j.right && !j.false_certain && !j.abstained);
  assert_close(j.isolation, 1.0, 0.0);
  assert_int_equal(j.nvalue, 1);
  assert_int_equal(j.nwithin, 1);
  /* two sigmas off are within three, four are not */
  j = judge(&power, answer("found", "internal_power:bus", "", "internal_power:bus power_W 23 0.5"));
  assert_int_equal(j.nwithin, 0);
}

static void test_one_of_a_group(void **state)
{
  (void)state;
  struct worlds_judgement j = judge(
      &power, answer("not_identifiable", "", "albedo_level+internal_power:bus+emittance:a", ""));
  assert_true(j.right && j.abstained && j.detected);
  assert_close(j.isolation, 1.0 / 3.0, 1e-15);
  /* what looks like it counts as right, and is given no probability */
  j = judge(&power, answer("not_identifiable", "", "stored_heat:bus+area:bus", ""));
  assert_true(j.right);
  assert_close(j.isolation, 0.0, 0.0);
  /* to be certain of it does not */
  j = judge(&power, answer("found", "stored_heat:bus", "", ""));
  assert_true(!j.right && j.false_certain);
}

static void test_false_beside_true(void **state)
{
  (void)state;
  struct worlds_judgement j =
      judge(&power, answer("found", "internal_power:bus albedo_level", "", ""));
  assert_true(j.false_certain && !j.right);
  assert_close(j.isolation, 1.0, 0.0);
}

static void test_missed(void **state)
{
  (void)state;
  struct worlds_judgement j = judge(&power, answer("unexplained", "", "", ""));
  assert_true(j.detected && j.abstained && !j.right);
  assert_close(j.isolation, 0.0, 0.0);
  j = judge(&power, answer("complete", "", "", ""));
  assert_true(!j.detected && !j.right);
  j = judge(&power, answer("error", "", "", ""));
  assert_true(!j.detected && !j.right);
}

static void test_nothing(void **state)
{
  (void)state;
  struct worlds_world noise = {.good = WORLDS_NOBODY};
  struct worlds_judgement j = judge(&nothing, answer("complete", "", "", ""));
  assert_true(j.right && j.is_null && !j.accused && isnan(j.isolation));
  j = judge(&nothing, answer("unexplained", "", "", ""));
  assert_true(!j.right && !j.accused);
  j = judge(&noise, answer("unexplained", "", "", ""));
  assert_true(j.right);
  j = judge(&noise, answer("not_identifiable", "", "a+b", ""));
  assert_true(!j.right && j.accused && !j.false_certain);
}

static void test_unexplained(void **state)
{
  (void)state;
  struct worlds_world pulse = {
      .good = WORLDS_UNEXPLAINED, .nhidden = 1, .hidden = {{.names = "pulse:bus.-y"}}};
  struct worlds_judgement j = judge(&pulse, answer("unexplained", "", "pulse:bus.-y", ""));
  assert_true(j.right);
  assert_close(j.isolation, 1.0, 0.0);
  /* the wrong place */
  j = judge(&pulse, answer("unexplained", "", "pulse:bus.+y", ""));
  assert_false(j.right);
  j = judge(&pulse, answer("found", "albedo_level", "", ""));
  assert_true(!j.right && j.false_certain);
  assert_close(j.isolation, 0.0, 0.0);
}

/* The model is off in more than is hidden: what is there may be named, and need not be. */
static void test_open(void **state)
{
  (void)state;
  struct worlds_world world = {
      .good = WORLDS_NOT_ALL,
      .nhidden = 2,
      .hidden = {{.names = "time_tag"}, {.names = "area:*", .optional = true}}};
  struct worlds_judgement j = judge(&world, answer("unexplained", "", "", ""));
  assert_true(j.right && j.abstained && !j.is_null);
  j = judge(&world, answer("not_identifiable", "area:bus", "", ""));
  assert_true(j.right && !j.false_certain && !j.accused);
  assert_close(j.isolation, 0.0, 0.0);
  /* that this is all is wrong, as is what is not there */
  assert_false(judge(&world, answer("found", "area:bus", "", "")).right);
  j = judge(&world, answer("not_identifiable", "area:bus albedo_level", "", ""));
  assert_true(!j.right && j.false_certain && j.accused);
  assert_true(judge(&world, answer("found", "area:bus time_tag", "", "")).right);
  /* nothing else is hidden */
  world.hidden[0] = world.hidden[1];
  world.nhidden = 1;
  j = judge(&world, answer("found", "area:bus", "", ""));
  assert_true(j.right && j.is_null && !j.accused && isnan(j.isolation));
  assert_true(judge(&world, answer("not_identifiable", "", "time_tag+x", "")).accused);
}

/* Of two effects one is found; the other need not be. A stated probability takes the group's place.
 */
static void test_two_and_stated(void **state)
{
  (void)state;
  struct worlds_world two = {.good = WORLDS_FOUND,
                             .nhidden = 3,
                             .hidden = {{.names = "background:vis"},
                                        {.names = "nonlinearity:vis"},
                                        {.names = "extinction:lwir", .optional = true}}};
  struct worlds_answer a = answer("found", "background:vis extinction:lwir", "", "");
  struct worlds_judgement j = judge(&two, a);
  assert_true(!j.right && !j.false_certain);
  assert_close(j.isolation, 0.5, 0.0);
  a.probability = 0.9;
  j = judge(&two, a);
  assert_close(j.isolation, 0.9, 0.0);
}

/* A sine of 40 points a period and amplitude 3 is a discrepancy, unit noise is none. The noise is a
 * fixed sequence, alternating, of mean square 1, that no smooth process explains. */
static void test_discrepancy(void **state)
{
  (void)state;
  enum { N = 80 };
  double t[N], r[N], out[N], rms = 0.0;
  size_t channel[N];
  bool found;
  struct um_context *context = NULL;
  assert_int_equal(um_core_context_create(NULL, &context), UM_OK);
  for (size_t i = 0; i < N; i++) {
    t[i] = 5.0 * (double)i;
    channel[i] = 0;
    r[i] = i % 2 == 0 ? 1.0 : -1.0;
  }
  assert_int_equal(worlds_discrepancy(context, N, t, channel, 1, r, out, &found), UM_OK);
  assert_false(found);
  assert_close(out[7], 0.0, 0.0);
  for (size_t i = 0; i < N; i++) r[i] += 3.0 * sin(0.157079632679 * (double)i);
  assert_int_equal(worlds_discrepancy(context, N, t, channel, 1, r, out, &found), UM_OK);
  assert_true(found);
  for (size_t i = 0; i < N; i++) rms += pow(out[i] - 3.0 * sin(0.157079632679 * (double)i), 2.0);
  assert_true(sqrt(rms / N) < 0.5);
  um_core_context_destroy(&context);
}

static void test_reliability(void **state)
{
  struct worlds_reliability r = {.count = {0}};
  struct worlds_world world = {.nhidden = 1, .hidden = {{.names = "internal_power:bus*"}}};
  struct worlds_answer a = answer("not_identifiable", "", "", "");
  (void)state;
  strcpy(a.stated, "internal_power:bus 0.950000 + albedo_level 0.050000");
  worlds_reliability_add(&world, &a, &r);
  strcpy(a.stated, "albedo_level 0.920000");
  worlds_reliability_add(&world, &a, &r);
  assert_int_equal(r.count[0], 1);
  assert_int_equal(r.right[0], 0);
  assert_int_equal(r.count[4], 2);
  assert_int_equal(r.right[4], 1);
  assert_close(r.sum[4], 1.87, 1e-12);
}

/* Taken out are effects, once each, on every target; a pulse of heat is in no catalogue. */
static void test_open_set(void **state)
{
  char out[WORLDS_LEFT_OUT][WORLDS_TEXT];
  size_t n;
  struct worlds_world world = {
      .also = "stored_heat:bus|albedo_level",
      .nhidden = 2,
      .hidden = {{.names = "internal_power:bus*|heater:bus.interior"}, {.names = "heater:array"}}};
  const struct worlds_world pulse = {.nhidden = 1, .hidden = {{.names = "pulse:bus.-y"}}};
  (void)state;
  worlds_left_out(&world, out, &n);
  assert_int_equal(n, 4);
  assert_string_equal(out[0], "internal_power");
  assert_string_equal(out[1], "heater");
  assert_string_equal(out[2], "stored_heat");
  assert_string_equal(out[3], "albedo_level");
  /* what only looks like it need not be of the same half */
  assert_true(worlds_half_is_right(&world, "heat"));
  assert_false(worlds_half_is_right(&world, "earth_shadow"));
  assert_false(worlds_half_is_right(&world, ""));
  worlds_left_out(&pulse, out, &n);
  assert_int_equal(n, 0);
  assert_true(worlds_half_is_right(&pulse, "heat"));
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_names),          cmocka_unit_test(test_named),
      cmocka_unit_test(test_one_of_a_group), cmocka_unit_test(test_false_beside_true),
      cmocka_unit_test(test_missed),         cmocka_unit_test(test_nothing),
      cmocka_unit_test(test_open),           cmocka_unit_test(test_unexplained),
      cmocka_unit_test(test_two_and_stated), cmocka_unit_test(test_discrepancy),
      cmocka_unit_test(test_open_set),       cmocka_unit_test(test_reliability)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
