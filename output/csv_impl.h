/* How numbers and times are printed in CSV files, once. */
#ifndef UMBRA_OUTPUT_CSV_IMPL_H
#define UMBRA_OUTPUT_CSV_IMPL_H

#include <math.h>
#include <stdio.h>

#include "base/core/csv.h"
#include "orbit/time.h"
#include "output/output.h"

#define UM_OUTPUT_COUNTS_COLUMNS 9 /* of each sensor in counts.csv, behind the time */

/* Rows look at the stop. */
static inline enum um_status um_output_stop(const struct um_output_run *run)
{
  return um_core_stop_check(run->context, "the results were written");
}

/* The first field of a row: UTC to the millisecond. */
static inline void um_output_csv_time(FILE *file, double t_tai)
{
  char text[32];
  um_orbit_time_format(t_tai, text);
  fputs(text, file);
}

#endif
