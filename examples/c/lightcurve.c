/* Reads a scenario, runs it, prints its light curve: POSIX time [s], radiant intensity of each band
 * [W/sr].
 *
 *   cc lightcurve.c $(pkg-config --cflags --libs umbra) -o lightcurve
 *   ./lightcurve PREFIX/share/umbra/scenarios/sphere */
#include <stdio.h>
#include <umbra.h>

static enum umbra_status print_light(struct umbra *umbra, const struct umbra_model *model,
                                     const struct umbra_result *result)
{
  const struct umbra_array *time = umbra_result_array(result, "time_unix_s");
  const struct umbra_array *intensity = umbra_result_array(result, "intensity");
  const char *const *band;
  size_t nband;
  enum umbra_status status = umbra_model_names(umbra, model, UMBRA_BANDS, &band, &nband);
  if (status != UMBRA_OK || intensity == NULL) return status;
  printf("%s", time->name);
  for (size_t b = 0; b < nband; b++) printf(",%s_intensity [%s]", band[b], intensity->unit);
  for (size_t k = 0; k < time->shape[0]; k++) {
    printf("\n%.3f", time->data[k]);
    for (size_t b = 0; b < nband; b++) printf(",%.9g", intensity->data[k * nband + b]);
  }
  printf("\n");
  return UMBRA_OK;
}

int main(int argc, char **argv)
{
  struct umbra *umbra = NULL;
  struct umbra_scenario *scenario = NULL;
  struct umbra_model *model = NULL;
  struct umbra_result *result = NULL;
  if (argc != 2) return 2;
  enum umbra_status status = umbra_open(NULL, &umbra);
  if (status == UMBRA_OK) status = umbra_scenario_read(umbra, argv[1], NULL, &scenario);
  if (status == UMBRA_OK) status = umbra_model_build(umbra, scenario, &model);
  if (status == UMBRA_OK) status = umbra_run(umbra, model, &result);
  if (status == UMBRA_OK) status = print_light(umbra, model, result);
  if (status != UMBRA_OK) fprintf(stderr, "%s\n", umbra != NULL ? umbra_message(umbra) : "");
  umbra_result_close(&result);
  umbra_model_close(&model);
  umbra_scenario_close(&scenario);
  umbra_close(&umbra);
  return status == UMBRA_OK ? 0 : 1;
}
