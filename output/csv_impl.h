/* How numbers and times are printed in CSV files, once. */
#ifndef UMBRA_OUTPUT_CSV_IMPL_H
#define UMBRA_OUTPUT_CSV_IMPL_H

#include <math.h>
#include <stdio.h>

#include "orbit/time.h"

/* ",value" with nine significant digits; an empty field for NaN. */
static inline void um_output_csv_number(FILE *file, double value)
{
  if (isnan(value))
    fputc(',', file);
  else
    fprintf(file, ",%.9g", value == 0.0 ? 0.0 : value); /* no "-0" */
}

/* The first field of a row: UTC to the millisecond. */
static inline void um_output_csv_time(FILE *file, double t_tai)
{
  char text[32];
  um_orbit_time_format(t_tai, text);
  fputs(text, file);
}

#endif
