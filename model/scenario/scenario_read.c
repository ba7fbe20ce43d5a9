/* Reading a scenario: folder or file, overrides, and checks across mappings. */
#include "model/scenario/scenario_read.h"

#include "model/scenario/scenario.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>

#include "base/core/data.h"
#include "base/core/file.h"
#include "model/scenario/fail_group.h"
#include "model/scenario/scenario_schema.h"
#include "orbit/time.h"

static enum um_status check_time(struct um_context *context, const struct um_scenario *scenario)
{
  const struct um_scenario_time *time = scenario->time;
  char start[32], stop[32];
  um_orbit_time_format(time->start, start);
  um_orbit_time_format(time->stop, stop);
  if (!(time->stop >= time->start))
    return um_model_fail(context, &time->at, "stop_utc",
                         "%s is before start_utc %s; accepted: that time or later", stop, start);
  double n = (time->stop - time->start) / time->step_s;
  if (!(n < 1e6))
    return um_model_fail(context, &time->at, "step_s",
                         "%.3g observations from %s to %s every %g s; at most 1e6 are accepted", n,
                         start, stop, time->step_s);
  return UM_OK;
}

/* The name becomes a folder. */
static enum um_status check_name(struct um_context *context, const struct um_scenario *scenario)
{
  bool control = false;
  for (const char *c = scenario->name; *c != '\0'; c++)
    control = control || (unsigned char)*c < 0x20 || *c == 0x7f;
  if (um_core_path_is_plain(scenario->name) && !control) return UM_OK;
  return um_model_fail(context, &scenario->at, "name",
                       "'%s' cannot name a folder; accepted: a word without slashes and control "
                       "characters, not . or ..",
                       scenario->name);
}

static enum um_status check_parts(struct um_context *context, const struct um_scenario *scenario)
{
  const struct um_scenario_part *part = scenario->parts.items;
  for (size_t i = 0; i < scenario->parts.count; i++)
    for (size_t k = 0; k < i; k++)
      if (strcmp(part[i].name, part[k].name) == 0)
        return um_model_fail(context, &part[i].at, "name",
                             "'%s' is taken by the part on line %d; accepted: names used once",
                             part[i].name, part[k].at.line);
  return UM_OK;
}

/* What one mapping cannot know of another. */
static enum um_status check_scenario(struct um_context *context, const struct um_scenario *scenario)
{
  UM_TRY(check_name(context, scenario));
  UM_TRY(check_time(context, scenario));
  return check_parts(context, scenario);
}

/* A name that is not here but is one of the scenarios that come with the program. */
static enum um_status point_to_shipped(struct um_context *context, const char *path)
{
  char *folder, *shipped;
  struct stat info;
  if (stat(path, &info) == 0 || errno != ENOENT || strchr(path, '/') != NULL) return UM_OK;
  enum um_status status = um_core_data_folder(context, "scenarios", &folder);
  if (status != UM_OK) return status == UM_ERR_MEMORY ? status : UM_OK;
  status = um_core_asprintf(context, &shipped, "%s/%s", folder, path);
  if (status == UM_OK) {
    if (path[0] != '\0' && path[0] != '.' && stat(shipped, &info) == 0 && S_ISDIR(info.st_mode))
      status = um_core_fail(context, UM_ERR_IO,
                            "%s: No such file or directory; did you mean '%s', which comes with "
                            "the program?",
                            path, shipped);
    um_core_free(context, shipped);
  }
  um_core_free(context, folder);
  return status;
}

static enum um_status read_plain(struct um_context *context, const char *path, const char *text,
                                 const char *const *overrides, size_t noverride,
                                 struct um_document **document, const struct um_scenario **out)
{
  struct stat info;
  char *file = NULL;
  void *root = NULL;
  enum um_status status;
  *document = NULL;
  *out = NULL;
  if (text == NULL) UM_TRY(point_to_shipped(context, path));
  if (text == NULL && stat(path, &info) == 0 && S_ISDIR(info.st_mode))
    UM_TRY(um_core_asprintf(context, &file, "%s/scenario.yaml", path));
  else
    UM_TRY(um_core_strdup(context, path, &file));
  if (text != NULL)
    UM_CHECK(um_document_parse(context, file, text, &um_model_scenario_schema, overrides, noverride,
                               document, &root));
  else
    UM_CHECK(um_document_read(context, file, &um_model_scenario_schema, overrides, noverride,
                              document, &root));
  UM_CHECK(check_scenario(context, root));
  *out = root;
done:
  um_core_free(context, file);
  if (status != UM_OK) um_document_destroy(document);
  return status;
}

enum um_status um_model_scenario_change(struct um_context *context,
                                        const struct um_document *origin,
                                        const struct um_document_change *change, size_t nchange,
                                        struct um_document **document,
                                        const struct um_scenario **out)
{
  void *root = NULL;
  *out = NULL;
  UM_TRY(um_document_change(context, origin, &um_model_scenario_schema, change, nchange, document,
                            &root));
  enum um_status status = check_scenario(context, root);
  if (status == UM_OK)
    *out = root;
  else
    um_document_destroy(document);
  return status;
}

enum um_status um_model_scenario_read(struct um_context *context, const char *path,
                                      const char *text, const char *const *overrides,
                                      size_t noverride, const struct um_document_change *change,
                                      size_t nchange, struct um_document **document,
                                      const struct um_scenario **out)
{
  struct um_document *origin;
  UM_TRY(read_plain(context, path, text, overrides, noverride, document, out));
  if (nchange == 0) return UM_OK;
  origin = *document;
  enum um_status status = um_model_scenario_change(context, origin, change, nchange, document, out);
  if (status == UM_OK) um_document_keep_origin(*document, &origin);
  um_document_destroy(&origin);
  return status;
}
