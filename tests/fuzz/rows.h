/* Measurements that were read are written and read again, and their periods are looked for. */
#ifndef UMBRA_TESTS_FUZZ_ROWS_H
#define UMBRA_TESTS_FUZZ_ROWS_H

#include "evidence/inversion/period_report.h"
#include "evidence/measurements/measurements.h"
#include "evidence/measurements/write.h"
#include "tests/fuzz/fuzz.h"

#define ROWS_FREQUENCIES 2000.0 /* of a period search that is tried */

/* Does the search stay small? Its grid is the span over the step. */
static inline bool rows_are_few(const struct um_compare_measurements *m)
{
  double low = m->row[0].t_tai, high = low, step = 1e30;
  if (m->count > 200) return false;
  for (size_t i = 1; i < m->count; i++) {
    double gap = m->row[i].t_tai - m->row[i - 1].t_tai;
    if (gap < 0.0) gap = -gap;
    if (gap > 0.0 && gap < step) step = gap;
    if (m->row[i].t_tai < low) low = m->row[i].t_tai;
    if (m->row[i].t_tai > high) high = m->row[i].t_tai;
  }
  return (high - low) / step < ROWS_FREQUENCIES;
}

static inline void rows_try(struct um_context *context, struct um_compare_measurements *rows)
{
  const struct um_compare_period_options options = {0};
  struct um_compare_period_report *report = NULL;
  struct um_compare_measurements *again = NULL;
  for (size_t i = 0; i < rows->count; i++) {
    um_fuzz_finite(rows->row[i].t_tai, "a time");
    um_fuzz_finite(rows->row[i].value, "a value");
    if (rows->row[i].channel >= rows->nchannel || rows->row[i].track >= rows->ntrack)
      um_fuzz_finding("row %zu belongs to nothing", i);
  }
  if (rows_are_few(rows) && um_fuzz_good(context, um_compare_period_report_create(
                                                      context, rows, NULL, &options, &report)))
    for (size_t i = 0; i < report->count; i++)
      um_fuzz_finite(report->entry[i].period->period, "a period");
  um_compare_period_report_destroy(context, &report);
  if (um_fuzz_good(context, um_compare_measurements_write(context, rows, um_fuzz_out()))) {
    enum um_status status = um_compare_measurements_read(context, um_fuzz_out(), &again);
    if (status != UM_OK && !um_fuzz_memory_is_short())
      um_fuzz_finding("what was written does not read back: %s", um_core_message(context));
    if (um_fuzz_good(context, status) && again->count != rows->count)
      um_fuzz_finding("%zu rows were written, %zu read back", rows->count, again->count);
    um_compare_measurements_destroy(context, &again);
  }
}

#endif
