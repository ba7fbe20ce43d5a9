/* The folder of a study's results. */
#include "study/folder.h"

#include <string.h>

#include "base/core/file.h"
#include "study/measured.h"
#include "study/plot.h"
#include "study/report.h"
#include "study/shortfall.h"
#include "study/study.h"

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
                            const struct um_study_measured *fit, const struct um_study_folder *how,
                            struct um_core_folder *folder)
{
  enum um_status status;
  struct um_study_statistics *statistics = NULL;
  UM_CHECK(um_study_statistics_create(context, result, NULL, &statistics));
  UM_CHECK(um_study_report_write(context, result, statistics, folder));
  if (fit != NULL) UM_CHECK(um_study_measured_write(context, result, fit, folder));
  if (how->pictures)
    UM_CHECK(um_study_plot(context, result, statistics, fit != NULL ? fit->weight : NULL, folder));
  if (how->words == NULL) goto done;
  UM_CHECK(um_study_report_print(context, result, statistics, how->words));
  if (fit != NULL) UM_CHECK(um_study_measured_print(context, result, fit, how->words));
done:
  um_study_statistics_destroy(context, &statistics);
  return status;
}

enum um_status um_study_folder_write(struct um_context *context, struct um_study_result *result,
                                     const struct um_study_folder *how, const char *path)
{
  struct um_core_folder *folder = NULL;
  struct um_study_measured *fit = NULL;
  FILE *file = NULL;
  enum um_status status;
  size_t done = 0;
  for (size_t i = 0; i < result->npoint; i++) done += result->reason[i] == NULL ? 1 : 0;
  UM_CHECK(warn(context, result));
  if (how->measured != NULL && done > 1)
    UM_CHECK(um_study_measured_create(context, result, how->measured, &fit));
  UM_CHECK(um_core_folder_begin(context, path, how->force, &folder));
  UM_CHECK(um_core_folder_open(context, folder, "study.nc", &file));
  UM_CHECK(um_study_write_netcdf(context, result, file));
  UM_CHECK(um_core_file_close(context, "study.nc", &file));
  UM_CHECK(um_core_folder_open(context, folder, "points.csv", &file));
  um_study_write_points(result, file);
  UM_CHECK(um_core_file_close(context, "points.csv", &file));
  if (done > 1)
    UM_CHECK(learn(context, result, fit, how, folder));
  else
    um_core_log(context, UM_LOG_WARNING, "nothing is learnt from %zu points", done);
  UM_CHECK(um_core_folder_commit(context, &folder));
done:
  if (file != NULL) fclose(file);
  um_study_measured_destroy(context, &fit);
  um_core_folder_abort(&folder);
  return status;
}

enum um_status um_study_folder_try(struct um_context *context, const char *path, bool force)
{
  struct um_core_folder *folder = NULL;
  UM_TRY(um_core_folder_begin(context, path, force, &folder));
  um_core_folder_abort(&folder);
  return UM_OK;
}
