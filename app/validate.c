/* umbra validate: analytic and published cases, computed now, beside what is expected. */
#include "app/validate.h"

#include <math.h>
#include <stdlib.h>

#include "app/app.h"

struct row {
  const char *group, *name, *unit, *source;
  double expected, computed, tolerance;
};

struct um_app_report {
  struct um_context *context;
  const char *group;
  struct row *row;
  size_t count, capacity;
  enum um_status status;
};

void um_app_report_add(struct um_app_report *report, const char *name, const char *unit,
                       double expected, double computed, double tolerance, const char *source)
{
  if (report->status != UM_OK) return;
  if (report->count == report->capacity) {
    report->capacity = 2 * report->capacity + 64;
    report->status =
        um_core_reallocate(report->context, report->capacity, sizeof *report->row, &report->row);
    if (report->status != UM_OK) return;
  }
  report->row[report->count++] =
      (struct row){report->group, name, unit, source, expected, computed, tolerance};
}

static bool is_met(const struct row *r)
{
  return fabs(r->computed - r->expected) <= r->tolerance; /* NaN is not met */
}

static void print_table(const struct um_app_report *report)
{
  const char *group = "";
  for (size_t i = 0; i < report->count; i++) {
    const struct row *r = &report->row[i];
    if (r->group != group)
      printf("\n%-52s %-12s %16s %16s %10s       source\n", r->group, "unit", "expected",
             "computed", "tolerance");
    group = r->group;
    printf("%-52s %-12s %16.9g %16.9g %10.2g %-5s %s\n", r->name, r->unit, r->expected, r->computed,
           r->tolerance, is_met(r) ? "ok" : "MISS", r->source);
  }
}

static void print_json(const struct um_app_report *report)
{
  puts("[");
  for (size_t i = 0; i < report->count; i++) {
    const struct row *r = &report->row[i];
    printf("  {\"group\": \"%s\", \"name\": ", r->group);
    um_core_json_string(stdout, r->name);
    printf(", \"unit\": ");
    um_core_json_string(stdout, r->unit);
    printf(", \"expected\": %.17g, ", r->expected);
    if (isfinite(r->computed))
      printf("\"computed\": %.17g", r->computed);
    else
      printf("\"computed\": null");
    printf(", \"tolerance\": %.17g, \"met\": %s, \"source\": ", r->tolerance,
           is_met(r) ? "true" : "false");
    um_core_json_string(stdout, r->source);
    printf("}%s\n", i + 1 < report->count ? "," : "");
  }
  puts("]");
}

typedef enum um_status (*fill)(struct um_context *, struct um_app_report *);

int um_app_validate(struct um_context *context, const struct um_app_options *options)
{
  static const struct {
    const char *name;
    fill fill;
    bool thermal, optics;
  } groups[] = {{"orbit", um_app_validate_orbit, false, false},
                {"environment", um_app_validate_environment, true, true},
                {"thermal", um_app_validate_thermal, true, false},
                {"optics", um_app_validate_optics, false, true}};
  struct um_app_report report = {.context = context, .status = UM_OK};
  bool all = !options->thermal && !options->optics;
  enum um_status status = UM_OK;
  for (size_t i = 0; i < sizeof groups / sizeof groups[0]; i++) {
    if (!(all || (options->thermal && groups[i].thermal) || (options->optics && groups[i].optics)))
      continue;
    report.group = groups[i].name;
    UM_CHECK(groups[i].fill(context, &report));
    UM_CHECK(report.status);
  }
  size_t missed = 0;
  for (size_t i = 0; i < report.count; i++) missed += !is_met(&report.row[i]);
  if (options->json)
    print_json(&report);
  else
    print_table(&report);
  if (!options->json)
    printf("\n%zu of %zu cases within tolerance\n", report.count - missed, report.count);
  um_core_free(context, report.row);
  return missed == 0 ? UM_APP_DONE : UM_APP_FAILED;
done:
  um_core_free(context, report.row);
  (void)status;
  return um_app_fail(context);
}
