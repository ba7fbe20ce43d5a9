/* Products of exchange areas on one and on several threads: the same bits, through trials of both
 * and what is kept between them. */
#include "tests/thermal/network_help.h"
#include "thermal/exchange/exchange_group.h"
#include "thermal/exchange/thread_tuning_group.h"

#define PATCHES 160 /* 25,600 entries: enough to be worth threads */
#define CALLS   2000

static double value_of(size_t i) { return 1.0 + (double)(i * 7919 % 1000) / 997.0; }

static void test_same_bits(void **state)
{
  (void)state;
  static size_t begin[PATCHES + 1];
  static uint32_t other[PATCHES * PATCHES];
  static double area[PATCHES * PATCHES], x[PATCHES], one[PATCHES], many[PATCHES];
  for (size_t p = 0; p < PATCHES; p++) {
    begin[p + 1] = begin[p] + PATCHES;
    for (size_t q = 0; q < PATCHES; q++) {
      other[begin[p] + q] = (uint32_t)q;
      area[begin[p] + q] = value_of(p * PATCHES + q);
    }
  }
  const struct um_thermal_between between = {.begin = begin, .other = other, .area = area};
  const struct um_thermal_exchange exchange = {.npatch = PATCHES, .noutside = PATCHES, .npose = 1};
  const struct um_thermal_mix mix = {.n = 1, .pose = {0}, .weight = {1.0}};
  bool together = false;
  struct um_thermal_thread_tuning tuning = {.threads = 3};
  for (size_t call = 0; call < CALLS; call++) {
    for (size_t p = 0; p < PATCHES; p++) x[p] = value_of(p + call);
    um_thermal_exchange_apply(&exchange, &between, &mix, 1, x, one);
    um_thermal_thread_tuning_apply(&tuning, &exchange, &between, &mix, x, many);
    assert_memory_equal(one, many, sizeof one);
    um_thermal_exchange_apply(&exchange, &between, &mix, 3, x, many);
    assert_memory_equal(one, many, sizeof one);
    together = together || tuning.shared > 0.0;
  }
  assert_true(together); /* the trials were made */
  double sum = 0.0;
  for (size_t q = 0; q < PATCHES; q++) sum += area[q] * x[q];
  NEAR("first row", one[0], UM_STEFAN_BOLTZMANN * sum, 1e-13 * UM_STEFAN_BOLTZMANN * sum);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_same_bits)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
