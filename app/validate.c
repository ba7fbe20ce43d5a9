/* umbra validate: analytic and published cases, computed now, beside what is expected. */
#include "app/validate/validate.h"

#include "app/app.h"

int um_app_validate(struct um_context *context, const struct um_app_options *options)
{
  static const struct {
    const char *name;
    um_validate_cases *fill;
    bool thermal, optics;
  } groups[] = {{"orbit", um_validate_orbit, false, false},
                {"environment", um_validate_environment, true, true},
                {"thermal", um_validate_thermal, true, false},
                {"optics", um_validate_optics, false, true}};
  struct um_validate_report *report = NULL;
  bool all = !options->thermal && !options->optics;
  enum um_status status = UM_OK;
  size_t missed = 0;
  UM_CHECK(um_validate_report_create(context, &report));
  for (size_t i = 0; i < sizeof groups / sizeof groups[0]; i++) {
    if (!(all || (options->thermal && groups[i].thermal) || (options->optics && groups[i].optics)))
      continue;
    UM_CHECK(um_core_stop_check(context, "cases were computed"));
    UM_CHECK(um_validate_report_fill(report, groups[i].name, groups[i].fill));
  }
  missed = um_validate_report_print(report, options->json);
done:
  um_validate_report_destroy(context, &report);
  if (status != UM_OK) return um_app_fail(context);
  return missed == 0 ? UM_APP_DONE : UM_APP_EXCEEDED;
}
