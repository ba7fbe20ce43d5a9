/* umbra study: many points of one scenario. */
#include "study/study.h"

#include <string.h>

#include "app/app.h"
#include "app/batch.h"
#include "study/folder.h"
#include "study/identity.h"

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
  um_app_tell_results(folder);
}

static void json_result(const struct um_study_result *r, const char *folder)
{
  size_t failed = 0;
  for (size_t i = 0; i < r->npoint; i++) failed += r->reason[i] != NULL ? 1 : 0;
  um_core_json_text(stdout, "{", "name", r->name);
  um_core_json_text(stdout, ", ", "folder", folder);
  um_core_json_text(stdout, ", ", "scenario", r->scenario);
  um_core_json_count(stdout, ", ", "points", r->npoint);
  um_core_json_count(stdout, ", ", "solved", r->exact);
  um_core_json_count(stdout, ", ", "failed", failed);
  um_core_json_text(stdout, ", ", "falls_short", r->falls_short);
  printf(",\n  \"quantities\": [");
  for (size_t q = 0; q < r->nquantity; q++) {
    const struct um_study_quantity *of = &r->quantity[q];
    um_core_json_text(stdout, q > 0 ? ",\n    {" : "\n    {", "name", of->name);
    um_core_json_text(stdout, ", ", "unit", of->unit);
    um_core_json_field(stdout, ", ", "largest_error", r->error[q]);
    um_core_json_field(stdout, ", ", "asked_error", of->asked);
    um_core_json_bool(stdout, ", ", "of_solved_points_alone", of->withheld);
    printf("}");
  }
  printf("]}\n");
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
  if (!options->study_check) UM_CHECK(um_study_folder_try(context, folder, options->force));
  struct um_study_run_options run = {.model = um_app_model_options(options),
                                     .version = UM_APP_VERSION,
                                     .measured = options->measured,
                                     .batch = {.folder = records}};
  UM_CHECK(um_app_batch_options(context, options, &run.batch));
  UM_CHECK(um_study_create(context, path, &run, &study));
  if (options->study_check) {
    status = um_study_print_check(context, study, options->json, stdout);
    goto done;
  }
  UM_CHECK(um_study_run(context, study, &result));
  code = um_app_batch_end(um_study_lost(study), records);
  if (result == NULL) goto done;
  const struct um_study_folder how = {.measured = um_study_measurements(study),
                                      .force = options->force,
                                      .pictures = true,
                                      .words = options->json ? NULL : stdout};
  status = um_study_folder_write(context, result, &how, folder);
  if (status != UM_OK) {
    um_core_log(context, UM_LOG_WARNING, "all points stay on record in %s: --resume takes them",
                records);
    goto done;
  }
  if (code == UM_APP_DONE) um_study_records_remove(context, records);
  if (options->json)
    json_result(result, folder);
  else
    print_result(result, folder);
done:
  um_study_result_destroy(context, &result);
  um_study_destroy(context, &study);
  UM_FREE(context, folder, records);
  return status == UM_OK ? code : um_app_fail(context);
}
