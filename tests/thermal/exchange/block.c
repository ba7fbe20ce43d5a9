/* Products of long rows by blocks of columns in single precision: what they leave out is rounding,
 * and nothing of the sum of a row. */
#include "tests/thermal/network_help.h"
#include "thermal/exchange/exchange_group.h"
#include "thermal/exchange/exchange_maker_impl.h"

#define PATCHES 1003 /* the last block overlaps another */
#define ENTRIES ((size_t)PATCHES * PATCHES)

static double value_of(size_t low, size_t high)
{
  return 1.0 + (double)((low * 7919 + high * 104729) % 1000) / 997.0;
}

/* Rows without the pairs for which low + high is a multiple of `gap`. */
static size_t rows_fill(size_t gap, size_t *begin, uint32_t *other, double *area)
{
  size_t at = 0;
  for (size_t p = 0; p < PATCHES; p++) {
    for (size_t q = 0; q < PATCHES; q++) {
      if (p != q && (p + q) % gap == 0) continue;
      other[at] = (uint32_t)q;
      area[at++] = value_of(p < q ? p : q, p < q ? q : p);
    }
    begin[p + 1] = at;
  }
  return at;
}

/* Products side by side, of x times 1, 2 .., are those of x, added with their weight. */
static void lots_compare(const struct um_thermal_between *between, const double *x)
{
  static double lot[PATCHES][UM_THERMAL_LOT];
  for (size_t p = 0; p < PATCHES; p++)
    for (size_t k = 0; k < UM_THERMAL_LOT; k++) lot[p][k] = (double)(k + 1) * x[p];
  for (size_t p = 0; p < PATCHES; p += 101) {
    double sum[UM_THERMAL_LOT], one = um_thermal_between_row(between, p, x);
    for (size_t k = 0; k < UM_THERMAL_LOT; k++) sum[k] = 7.0;
    um_thermal_between_row_lot(between, p, 0.25, (const double(*)[UM_THERMAL_LOT])lot, sum);
    for (size_t k = 0; k < UM_THERMAL_LOT; k++)
      assert_true(fabs(sum[k] - 7.0 - 0.25 * (double)(k + 1) * one) <= 1e-9);
  }
}

/* Of numbers near 1 single precision rounds each to 6e-8 of it: the product of a row with x off by
 * less than that, a row's sum by rounding of double precision alone. */
static void test_rows(void **state)
{
  (void)state;
  static size_t begin[PATCHES + 1];
  static uint32_t other[ENTRIES];
  static double area[ENTRIES], x[PATCHES], one[PATCHES];
  size_t nentry = rows_fill(5, begin, other, area);
  struct um_thermal_between plain = {.begin = begin, .other = other, .area = area}, fast = plain;
  OK(um_thermal_between_block(help_context, PATCHES, &fast));
  assert_non_null(fast.first);
  assert_true(nentry > ENTRIES / 2);
  for (size_t p = 0; p < PATCHES; p++) {
    x[p] = value_of(p, 3) - 1.5;
    one[p] = 1.0;
  }
  double worst = 0.0;
  for (size_t p = 0; p < PATCHES; p++) {
    double sum = 0.0, size = 0.0, wanted = 0.0;
    for (size_t e = begin[p]; e < begin[p + 1]; e++) {
      sum += area[e];
      size += area[e] * fabs(x[other[e]]);
      wanted += area[e] * x[other[e]];
    }
    assert_true(fabs(um_thermal_between_row(&fast, p, one) - sum) <= 1e-13 * sum);
    assert_true(fabs(um_thermal_between_row(&plain, p, x) - wanted) <= 1e-13 * size);
    worst = fmax(worst, fabs(um_thermal_between_row(&fast, p, x) - wanted) / size);
  }
  print_message("%zu entries, rows off by %.2g\n", nentry, worst);
  lots_compare(&plain, x);
  lots_compare(&fast, x);
  assert_true(worst > 0.0 && worst <= 6e-8);
  fast.begin = NULL; /* static, of `plain` */
  fast.other = NULL;
  fast.area = NULL;
  um_thermal_between_clear(help_context, &fast, 1);
}

/* Rows of few entries stay as they are. */
static void test_few(void **state)
{
  (void)state;
  static size_t begin[PATCHES + 1];
  struct um_thermal_between between = {.begin = begin};
  OK(um_thermal_between_block(help_context, PATCHES, &between));
  assert_null(between.first);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_rows), cmocka_unit_test(test_few)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
