/* points.csv: a row for every point. */
#include <math.h>

#include "base/core/csv.h"
#include "study/study.h"

/* Least, mean and largest of what is seen. */
static void extremes(const double *value, size_t n, double out[3])
{
  size_t seen = 0;
  out[0] = INFINITY, out[1] = 0.0, out[2] = -INFINITY;
  for (size_t k = 0; k < n; k++) {
    if (isnan(value[k])) continue;
    out[0] = fmin(out[0], value[k]);
    out[2] = fmax(out[2], value[k]);
    out[1] += value[k];
    seen++;
  }
  out[1] = seen > 0 ? out[1] / (double)seen : (double)NAN;
}

void um_study_write_points(const struct um_study_result *r, FILE *file)
{
  static const char *const tail[] = {":least", ":mean", ":largest"};
  fputs("point", file);
  for (size_t j = 0; j < r->nparameter; j++) um_core_csv_put_text(file, r->parameter_name[j], "");
  for (size_t q = 0; q < r->nquantity; q++)
    for (int e = 0; e < (r->quantity[q].count > 1 ? 3 : 1); e++)
      um_core_csv_put_text(file, r->quantity[q].name, r->quantity[q].count > 1 ? tail[e] : "");
  fputs(",reason\n", file);
  for (size_t i = 0; i < r->npoint; i++) {
    fprintf(file, "%zu", i);
    for (size_t j = 0; j < r->nparameter; j++)
      um_core_csv_put_number(file, r->parameter[i * r->nparameter + j]);
    for (size_t q = 0; q < r->nquantity; q++) {
      double of[3];
      extremes(um_study_result_values(r, i, &r->quantity[q]), r->quantity[q].count, of);
      for (int e = 0; e < (r->quantity[q].count > 1 ? 3 : 1); e++)
        um_core_csv_put_number(file, of[e]);
    }
    um_core_csv_put_text(file, r->reason[i] != NULL ? r->reason[i] : "", "");
    fputc('\n', file);
  }
}
