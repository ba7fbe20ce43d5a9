/* Mean temperatures of materials, as other programs take them: a data message of CNES (CIC MEM),
 * which has a value a material in a row, and profiles of STK. */
#include "output/material_temperatures.h"

#include <stdio.h>
#include <string.h>

#include "orbit/time.h"
#include "output/csv_impl.h"

static const char prefix[] = "material:";

/* The material of a place; NULL: the place is none. */
static const char *material_of(const struct um_output_run *run, size_t place)
{
  const char *name = run->result->place[place].name;
  return strncmp(name, prefix, sizeof prefix - 1) == 0 ? name + sizeof prefix - 1 : NULL;
}

/* The message is dated by its first row: one scenario gives the same bytes. */
static void put_head(const struct um_output_run *run, FILE *file)
{
  const struct um_model_result *r = run->result;
  const char *object = run->model->scenario->name;
  char start[32], stop[32];
  size_t n = 0;
  um_orbit_time_format(run->tables->t_obs[0], start);
  um_orbit_time_format(run->tables->t_obs[r->nobs - 1], stop);
  fprintf(file,
          "CIC_MEM_VERS = 1.0\nCREATION_DATE = %.19s\nORIGINATOR = UMBRA %s\n\nMETA_START\n\n",
          start, run->version != NULL ? run->version : "");
  fprintf(file, "OBJECT_NAME = %s\nOBJECT_ID = %s\n\nUSER_DEFINED_PROTOCOL = CIC\n", object,
          object);
  fputs("USER_DEFINED_CONTENT = MATERIAL_TEMPERATURES\n", file);
  for (size_t p = 0; p < r->nplace; p++)
    if (material_of(run, p) != NULL)
      fprintf(file, "COMMENT column %zu: mean temperature of %s\n", ++n, material_of(run, p));
  fprintf(file, "USER_DEFINED_SIZE = %zu\nUSER_DEFINED_TYPE = REAL\nUSER_DEFINED_UNIT = [K]\n\n",
          n);
  fprintf(file, "TIME_SYSTEM = UTC\nCOMMENT from %s to %s\n\nMETA_STOP\n\n", start, stop);
}

enum um_status um_output_write_cic(const struct um_output_run *run, FILE *file)
{
  const struct um_model_result *r = run->result;
  put_head(run, file);
  for (size_t k = 0; k < r->nobs; k++) {
    UM_TRY(um_output_stop(run));
    double days, seconds;
    um_orbit_time_utc_clock(run->tables->t_obs[k], &days, &seconds);
    fprintf(file, "%.0f %.3f", days, seconds);
    for (size_t p = 0; p < r->nplace; p++)
      if (material_of(run, p) != NULL) fprintf(file, " %.4f", r->place[p].mean[k]);
    fputc('\n', file);
  }
  return UM_OK;
}

static enum um_status write_profile(const struct um_output_run *run, size_t place, FILE *file)
{
  const struct um_model_result *r = run->result;
  char start[32];
  um_orbit_time_format(run->tables->t_obs[0], start);
  fprintf(file,
          "# mean temperature of %s [K]\n# seconds since %s, which the scenario of STK has as its "
          "epoch\n",
          material_of(run, place), start);
  for (size_t k = 0; k < r->nobs; k++) {
    UM_TRY(um_output_stop(run));
    fprintf(file, "%.3f\t%.4f\n", run->tables->t_obs[k] - run->tables->t_obs[0],
            r->place[place].mean[k]);
  }
  return UM_OK;
}

enum um_status um_output_write_material_temperatures(struct um_context *context,
                                                     const struct um_output_run *run,
                                                     struct um_core_folder *folder)
{
  FILE *file = NULL;
  char *name = NULL;
  enum um_status status;
  UM_TRY(um_core_folder_open(context, folder, "temperatures.cic", &file));
  status = um_output_write_cic(run, file);
  UM_TRY(um_core_file_close(context, "temperatures.cic", &file));
  for (size_t p = 0; p < run->result->nplace && status == UM_OK; p++) {
    if (material_of(run, p) == NULL) continue;
    UM_CHECK(um_core_asprintf(context, &name, "%s.tsf", material_of(run, p)));
    UM_CHECK(um_core_folder_open(context, folder, name, &file));
    status = write_profile(run, p, file);
    UM_CHECK(um_core_file_close(context, name, &file));
    um_core_free(context, name);
    name = NULL;
  }
done:
  um_core_free(context, name);
  return status;
}
