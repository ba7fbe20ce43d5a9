/* umbra retrieve: temperature and infrared cross-section of what was measured in several thermal
 * bands. */
#include <math.h>

#include "app/app.h"
#include "app/terminal.h"
#include "base/core/file.h"
#include "evidence/inversion/retrieve.h"
#include "evidence/measurements/measurements.h"
#include "model/build/build.h"
#include "orbit/time.h"

#define SHOWN 10 /* times, the rest stands in the table */

static void print_row(const struct um_compare_retrieved_row *row)
{
  const struct um_instrument_grey_body *b = &row->one;
  char time[32], temperature[40], area[40];
  um_orbit_time_format(row->t_tai, time);
  snprintf(temperature, sizeof temperature, "%.2f +- %.2g", b->temperature[0],
           b->temperature_sigma[0]);
  snprintf(area, sizeof area, "%.4g +- %.2g", b->area[0], b->area_sigma[0]);
  printf("%-24s%6zu%24s%30s\n", time, row->nband, temperature, area);
}

static void json_bodies(const char *key, const struct um_instrument_grey_body *b)
{
  printf(", \"%s\": [", key);
  for (size_t i = 0; i < b->n; i++) {
    um_core_json_field(stdout, i > 0 ? ", {" : "{", "temperature_K", b->temperature[i]);
    um_core_json_field(stdout, ", ", "temperature_sigma_K", b->temperature_sigma[i]);
    um_core_json_field(stdout, ", ", "cross_section_m2", b->area[i]);
    um_core_json_field(stdout, ", ", "cross_section_sigma_m2", b->area_sigma[i]);
    printf("}");
  }
  printf("]");
}

static void json_summary(const struct um_compare_retrieved *retrieved, const char *folder)
{
  um_core_json_text(stdout, "{", "folder", folder);
  printf(",\n  \"times\": [");
  for (size_t k = 0; k < retrieved->count; k++) {
    const struct um_compare_retrieved_row *row = &retrieved->row[k];
    char time[32];
    um_orbit_time_format(row->t_tai, time);
    um_core_json_text(stdout, k > 0 ? ",\n    {" : "\n    {", "time_utc", time);
    um_core_json_count(stdout, ", ", "bands", row->nband);
    json_bodies("one", &row->one);
    json_bodies("two", &row->two);
    um_core_json_bool(stdout, ", ", "two_preferred", um_compare_retrieved_prefers_two(row));
    printf("}");
  }
  printf("]}\n");
}

static void print_summary(const struct um_compare_retrieved *retrieved, const char *folder)
{
  size_t fits = 0, twos = 0, better = 0;
  double low = INFINITY, high = -INFINITY;
  printf("%-24s%6s%24s%30s\n", "UTC", "bands", "temperature [K]", "cross-section [m2]");
  for (size_t k = 0; k < retrieved->count; k++) {
    const struct um_compare_retrieved_row *row = &retrieved->row[k];
    twos += row->two.n > 0;
    better += um_compare_retrieved_prefers_two(row);
    if (row->one.n == 0) continue;
    low = fmin(low, row->one.temperature[0]);
    high = fmax(high, row->one.temperature[0]);
    if (++fits <= SHOWN) print_row(row);
  }
  if (fits > SHOWN) printf("... %zu times in all\n", fits);
  printf("one grey body: %.2f to %.2f K\n", low, high);
  if (twos > 0)
    printf("two grey bodies explain more than their two parameters at %zu of %zu times\n", better,
           twos);
  um_app_tell_results(folder);
}

static enum um_status write_folder(struct um_context *context,
                                   const struct um_compare_retrieved *retrieved,
                                   struct um_core_folder **folder)
{
  FILE *file = NULL;
  UM_TRY(um_core_folder_open(context, *folder, "retrieved.csv", &file));
  um_compare_retrieved_write(retrieved, file);
  UM_TRY(um_core_file_close(context, "retrieved.csv", &file));
  return um_core_folder_commit(context, folder);
}

int um_app_retrieve(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_model *model = NULL;
  struct um_compare_measurements *measurements = NULL;
  struct um_compare_retrieved *retrieved = NULL;
  struct um_core_folder *folder = NULL;
  struct um_model_options changes = um_app_model_options(options);
  char *out = NULL;
  UM_CHECK(um_compare_measurements_read(context, options->positional[1], &measurements));
  UM_CHECK(um_model_create(context, options->positional[0], &changes, &model));
  UM_CHECK(um_app_out_folder(context, options, model->scenario->name, &out));
  UM_CHECK(um_core_folder_begin(context, out, options->force, &folder));
  UM_CHECK(um_compare_retrieve(context, model, measurements, &retrieved));
  UM_CHECK(write_folder(context, retrieved, &folder));
  um_app_terminal_clear();
  if (options->json)
    json_summary(retrieved, out);
  else
    print_summary(retrieved, out);
done:
  um_core_folder_abort(&folder);
  um_compare_retrieved_destroy(context, &retrieved);
  um_compare_measurements_destroy(context, &measurements);
  um_model_destroy(context, &model);
  um_core_free(context, out);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
