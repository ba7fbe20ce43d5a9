/* The report of validated cases: rows, table, JSON. */
#include "app/validate/validate.h"

#include <math.h>
#include <stdio.h>

#include "base/core/json.h"

struct row {
  const char *group, *name, *unit, *source;
  double expected, computed, tolerance;
};

struct um_validate_report {
  struct um_context *context;
  const char *group;
  struct row *row;
  size_t count, capacity;
  enum um_status status;
};

void um_validate_report_add(struct um_validate_report *report, const char *name, const char *unit,
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

static void print_table(const struct um_validate_report *report)
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

static void print_json(const struct um_validate_report *report)
{
  puts("[");
  for (size_t i = 0; i < report->count; i++) {
    const struct row *r = &report->row[i];
    printf("  {\"group\": \"%s\", \"name\": ", r->group);
    um_core_json_string(stdout, r->name);
    um_core_json_text(stdout, ", ", "unit", r->unit);
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

enum um_status um_validate_report_create(struct um_context *context,
                                         struct um_validate_report **out)
{
  UM_TRY(um_core_allocate(context, 1, sizeof **out, out));
  (*out)->context = context;
  (*out)->group = "";
  (*out)->status = UM_OK;
  return UM_OK;
}

void um_validate_report_destroy(struct um_context *context, struct um_validate_report **report)
{
  if (report == NULL || *report == NULL) return;
  UM_FREE(context, (*report)->row, *report);
  *report = NULL;
}

enum um_status um_validate_report_fill(struct um_validate_report *report, const char *group,
                                       um_validate_cases *fill)
{
  report->group = group;
  UM_TRY(fill(report->context, report));
  return report->status;
}

size_t um_validate_report_print(const struct um_validate_report *report, bool json)
{
  size_t missed = 0;
  for (size_t i = 0; i < report->count; i++) missed += !is_met(&report->row[i]);
  if (json)
    print_json(report);
  else {
    print_table(report);
    printf("\n%zu of %zu cases within tolerance\n", report->count - missed, report->count);
  }
  return missed;
}
