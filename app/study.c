/* umbra study: many points of one scenario. */
#include "study/study.h"

#include <string.h>

#include "app/app.h"
#include "app/batch.h"
#include "base/core/file.h"
#include "study/identity.h"
#include "study/measured.h"
#include "study/plot.h"
#include "study/report.h"
#include "study/shortfall.h"

static void print_result(const struct um_study_result *r, const char *folder)
{
  bool short_of = r->falls_short != NULL;
  size_t failed = 0;
  for (size_t i = 0; i < r->npoint; i++) failed += r->reason[i] != NULL ? 1 : 0;
  printf("%s: %zu points of %s, %zu solved", r->name, r->npoint, r->scenario, r->exact);
  if (failed > 0) printf(", %zu could not be computed (points.csv says why)", failed);
  printf("\n");
  for (size_t q = 0; q < r->nquantity; q++) {
    if (!(r->error[q] >= 0.0)) continue; /* metrics, whose error nobody states */
    const struct um_study_quantity *of = &r->quantity[q];
    bool relative = of->light && of->unit[0] == 'W';
    double scale = relative ? 100.0 : 1.0;
    const char *unit = relative ? "%" : strcmp(of->unit, "1") == 0 ? "" : of->unit;
    printf("  %-28s error at most %.2g %s", of->name, scale * r->error[q], unit);
    if (short_of || r->error[q] > of->asked) printf(", asked %.2g %s", scale * of->asked, unit);
    printf("%s\n", of->withheld ? ", of solved points alone" : "");
  }
  printf("results in %s\n", folder);
}

/* A warning of all that falls short of what was asked. */
static enum um_status warn(struct um_context *context, const struct um_study_result *result)
{
  char *text = NULL;
  UM_TRY(um_study_shortfall(context, result, &text));
  for (char *line = text, *end; line != NULL && *line != '\0'; line = end) {
    end = line + strcspn(line, "\n");
    if (*end == '\n') *end++ = '\0';
    um_core_log(context, UM_LOG_WARNING, "%s", line);
  }
  um_core_free(context, text);
  return UM_OK;
}

/* Statistics, where two points or more succeeded; fit NULL: no measurements. */
static enum um_status learn(struct um_context *context, struct um_study_result *result,
                            const struct um_study_measured *fit, struct um_core_folder *folder)
{
  enum um_status status;
  struct um_study_statistics *statistics = NULL;
  UM_CHECK(um_study_statistics_create(context, result, NULL, &statistics));
  UM_CHECK(um_study_report_write(context, result, statistics, folder));
  if (fit != NULL) UM_CHECK(um_study_measured_write(context, result, fit, folder));
  UM_CHECK(um_study_plot(context, result, statistics, fit != NULL ? fit->weight : NULL, folder));
  UM_CHECK(um_study_report_print(context, result, statistics, stdout));
  if (fit != NULL) UM_CHECK(um_study_measured_print(context, result, fit, stdout));
done:
  um_study_statistics_destroy(context, &statistics);
  return status;
}

static enum um_status write_folder(struct um_context *context, struct um_study_result *result,
                                   const char *measured, const char *path, bool force)
{
  struct um_core_folder *folder = NULL;
  struct um_study_measured *fit = NULL;
  FILE *file = NULL;
  enum um_status status;
  size_t done = 0;
  for (size_t i = 0; i < result->npoint; i++) done += result->reason[i] == NULL ? 1 : 0;
  if (measured != NULL && done > 1)
    UM_CHECK(um_study_measured_create(context, result, measured, &fit));
  UM_CHECK(um_core_folder_begin(context, path, force, &folder));
  UM_CHECK(um_core_folder_open(context, folder, "study.nc", &file));
  UM_CHECK(um_study_write_netcdf(context, result, file));
  UM_CHECK(um_core_file_close(context, "study.nc", &file));
  UM_CHECK(um_core_folder_open(context, folder, "points.csv", &file));
  um_study_write_points(result, file);
  UM_CHECK(um_core_file_close(context, "points.csv", &file));
  if (done > 1)
    UM_CHECK(learn(context, result, fit, folder));
  else
    um_core_log(context, UM_LOG_WARNING, "nothing is learnt from %zu points", done);
  UM_CHECK(um_core_folder_commit(context, &folder));
done:
  if (file != NULL) fclose(file);
  um_study_measured_destroy(context, &fit);
  um_core_folder_abort(&folder);
  return status;
}

/* Before hours of work: a folder that may not be replaced. */
static enum um_status try_folder(struct um_context *context, const char *path, bool force)
{
  struct um_core_folder *folder = NULL;
  UM_TRY(um_core_folder_begin(context, path, force, &folder));
  um_core_folder_abort(&folder);
  return UM_OK;
}

int um_app_study(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  int code = UM_APP_DONE;
  struct um_study *study = NULL;
  struct um_study_result *result = NULL;
  char *folder = NULL, *records = NULL;
  const char *path = options->positional[0];
  if (!options->study_check && options->out == NULL) {
    UM_CHECK(um_core_strdup(context, "out/study", &folder));
  } else if (options->out != NULL) {
    UM_CHECK(um_core_strdup(context, options->out, &folder));
  }
  if (folder != NULL) UM_CHECK(um_core_asprintf(context, &records, "%s.points", folder));
  if (!options->study_check) UM_CHECK(try_folder(context, folder, options->force));
  struct um_study_run_options run = {.model = um_app_model_options(options),
                                     .version = UM_APP_VERSION,
                                     .measured = options->measured,
                                     .batch = {.folder = records}};
  UM_CHECK(um_app_batch_options(context, options, &run.batch));
  UM_CHECK(um_study_create(context, path, &run, &study));
  if (options->study_check) {
    status = um_study_print_check(context, study, stdout);
    goto done;
  }
  UM_CHECK(um_study_run(context, study, &result));
  code = um_app_batch_end(um_study_lost(study), records);
  if (result == NULL) goto done;
  UM_CHECK(warn(context, result));
  status = write_folder(context, result, um_study_measurements(study), folder, options->force);
  if (status != UM_OK) {
    um_core_log(context, UM_LOG_WARNING, "all points stay on record in %s: --resume takes them",
                records);
    goto done;
  }
  if (code == UM_APP_DONE) um_study_records_remove(context, records);
  print_result(result, folder);
done:
  um_study_result_destroy(context, &result);
  um_study_destroy(context, &study);
  UM_FREE(context, folder, records);
  return status == UM_OK ? code : um_app_fail(context);
}
