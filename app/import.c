/* umbra import: tracks of a survey as a measurement file. */
#include <string.h>

#include "app/app.h"
#include "app/target.h"
#include "app/terminal.h"
#include "evidence/measurements/mmt.h"
#include "evidence/measurements/noise.h"
#include "evidence/measurements/write.h"

int um_app_import(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_compare_measurements *m = NULL;
  struct um_compare_noise noise = {0};
  if (options->noise != NULL &&
      !um_app_noise_parse(options->noise, 0.0, &noise.relative, &noise.floor)) {
    fputs("umbra: --noise takes one number, or two with a comma between them\n", stderr);
    return UM_APP_MISUSE;
  }
  UM_CHECK(um_app_check_table(context, options));
  UM_CHECK(um_compare_mmt_read(context, options->positional[0], &m, NULL));
  for (size_t c = 0; c < m->nchannel && options->noise != NULL; c++)
    UM_CHECK(um_compare_noise_fill(context, m, c, &noise, NULL));
  UM_CHECK(um_compare_measurements_write(context, m, options->out));
  um_app_terminal_clear();
  printf("%s: %zu observations, %zu tracks%s\n", options->out, m->count, m->ntrack,
         options->noise == NULL ? ", without sigma: --noise or the scenario's noise gives one"
                                : "");
done:
  um_compare_measurements_destroy(context, &m);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
