/* Studies, and what they have in common with forecasts. */
#include "library/points_impl.h"

#include <string.h>

#include "study/folder.h"
#include "study/identity.h"
#include "study/study.h"

enum um_status um_library_points(struct um_context *context, const struct umbra_points *points,
                                 struct um_batch_task *task, char **records)
{
  UM_TRY(um_library_check_size(context, "struct umbra_points", points->size, sizeof *points));
  size_t n = points->folder != NULL ? strlen(points->folder) : 0;
  while (n > 1 && points->folder[n - 1] == '/') n--;
  if (n == 0)
    return um_core_fail(context, UM_ERR_INPUT, "no folder; accepted: one for the results");
  if (points->nshare > 0 && (points->share < 1 || points->share > points->nshare))
    return um_core_fail(context, UM_ERR_INPUT, "share %zu of %zu; accepted: 1 to %zu",
                        points->share, points->nshare, points->nshare);
  UM_TRY(um_core_asprintf(context, records, "%.*s.points", (int)n, points->folder));
  task->folder = *records;
  task->resume = points->resume != 0;
  task->alone = true;
  task->work.workers = points->workers > 0 ? points->workers : um_core_context_threads(context);
  task->share = points->nshare > 0 ? points->share - 1 : 0;
  task->nshare = points->nshare;
  return UM_OK;
}

static enum um_status run_study(struct um_context *context, const char *path,
                                const struct um_study_run_options *options,
                                const struct umbra_points *points, size_t *missing)
{
  enum um_status status;
  struct um_study *study = NULL;
  struct um_study_result *result = NULL;
  UM_CHECK(um_study_create(context, path, options, &study));
  UM_CHECK(um_study_run(context, study, &result));
  *missing = um_study_lost(study);
  if (result == NULL) goto done; /* a share */
  const struct um_study_folder how = {.measured = um_study_measurements(study),
                                      .force = points->force != 0,
                                      .pictures = points->pictures != 0};
  UM_CHECK(um_study_folder_write(context, result, &how, points->folder));
  if (*missing == 0) um_study_records_remove(context, options->batch.folder);
done:
  um_study_result_destroy(context, &result);
  um_study_destroy(context, &study);
  return status;
}

enum umbra_status umbra_study(struct umbra *umbra, const char *path, const char *measured,
                              const struct umbra_points *points, size_t *missing)
{
  struct um_context *context = um_library_begin(umbra);
  struct um_study_run_options options = {
      .model = {.effect_files = umbra->effect_file, .neffect_file = umbra->neffect_file},
      .version = UM_LIBRARY_VERSION,
      .measured = measured};
  char *records = NULL;
  enum um_status status;
  *missing = 0;
  UM_CHECK(um_library_points(context, points, &options.batch, &records));
  UM_CHECK(um_study_folder_try(context, points->folder, points->force != 0));
  UM_CHECK(run_study(context, path, &options, points, missing));
done:
  um_core_free(context, records);
  return um_library_status(status);
}
