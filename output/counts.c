/* counts.csv: what the sensors of a scenario count. */
#include <math.h>

#include "model/run/counts.h"
#include "output/csv_impl.h"

static const char *const columns[UM_OUTPUT_COUNTS_COLUMNS] = {"_count_rate_1_s",
                                                              "_count_rate_error_1_s",
                                                              "_signal_e",
                                                              "_background_e",
                                                              "_peak_e",
                                                              "_saturated",
                                                              "_snr",
                                                              "_scintillation",
                                                              "_limit_ab"};

enum um_status um_output_write_counts(const struct um_output_run *run, FILE *file)
{
  const struct um_model *model = run->model;
  const struct um_model_result *r = run->result;
  fputs("time_utc", file);
  for (size_t s = 0; s < model->nsensor; s++)
    for (size_t c = 0; c < UM_OUTPUT_COUNTS_COLUMNS; c++)
      um_core_csv_put_text(file, model->sensor[s].name, columns[c]);
  fputc('\n', file);
  for (size_t k = 0; k < r->nobs; k++) {
    UM_TRY(um_output_stop(run));
    um_output_csv_time(file, run->tables->t_obs[k]);
    for (size_t s = 0; s < model->nsensor; s++) {
      struct um_instrument_exposure e = um_model_expose(model, run->tables, r, k, s);
      um_core_csv_put_number(file, r->count_rate[k * r->nsensor + s]);
      um_core_csv_put_number(file, r->count_rate_error[k * r->nsensor + s]);
      um_core_csv_put_number(file, e.signal);
      um_core_csv_put_number(file, e.background);
      um_core_csv_put_number(file, e.peak);
      um_core_csv_put_number(file, isnan(e.peak) ? (double)NAN : e.saturated);
      um_core_csv_put_number(file, e.snr);
      um_core_csv_put_number(file, um_model_scintillation(model, run->tables, k, s));
      um_core_csv_put_number(file, e.limit_ab);
    }
    fputc('\n', file);
  }
  return UM_OK;
}
