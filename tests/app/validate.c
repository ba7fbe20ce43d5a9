/* Exit status of umbra validate: 0 where all cases are met, 4 where one misses its tolerance, 1
 * where they could not be computed. The cases are made here. */
#include "app/validate/validate.h"

#include <math.h>

#include "app/app.h"
#include "tests/support/cmocka_all.h"

static double computed;
static enum um_status outcome;

static enum um_status fill(struct um_context *context, struct um_validate_report *report)
{
  um_validate_report_add(report, "a case", "K", 300.0, computed, 0.5, "this test");
  if (outcome != UM_OK) return um_core_fail(context, outcome, "no answer");
  return UM_OK;
}

enum um_status um_validate_orbit(struct um_context *context, struct um_validate_report *report)
{
  return fill(context, report);
}
enum um_status um_validate_environment(struct um_context *context,
                                       struct um_validate_report *report)
{
  return fill(context, report);
}
enum um_status um_validate_thermal(struct um_context *context, struct um_validate_report *report)
{
  return fill(context, report);
}
enum um_status um_validate_optics(struct um_context *context, struct um_validate_report *report)
{
  return fill(context, report);
}
int um_app_fail(struct um_context *context)
{
  um_core_message_clear(context);
  return UM_APP_FAILED;
}

static void test_codes(void **state)
{
  static const struct {
    double computed;
    enum um_status outcome;
    int code;
  } row[] = {{300.5, UM_OK, 0},          {300.6, UM_OK, 4},          {NAN, UM_OK, 4},
             {300.0, UM_ERR_NUMERIC, 1}, {300.6, UM_ERR_NUMERIC, 1}, {300.0, UM_OK, 0}};
  struct um_context *context;
  (void)state;
  assert_int_equal(um_core_context_create(NULL, &context), UM_OK);
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++)
    for (int json = 0; json < 2; json++) {
      const struct um_app_options options = {.thermal = true, .json = json == 1};
      computed = row[i].computed;
      outcome = row[i].outcome;
      assert_int_equal(um_app_validate(context, &options), row[i].code);
    }
  um_core_context_destroy(&context);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_codes)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
