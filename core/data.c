/* Where the program's own files lie. */
#include "core/data.h"

#include <limits.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/listing.h"
#include "core/words.h"

static bool is_folder(const char *path)
{
  struct stat info;
  return stat(path, &info) == 0 && S_ISDIR(info.st_mode);
}

/* The folder of the running program, links resolved; false where the system does not say. */
static bool program_folder(char out[PATH_MAX])
{
  ssize_t n = readlink("/proc/self/exe", out, PATH_MAX);
  if (n <= 0 || n >= PATH_MAX) return false;
  out[n] = '\0';
  char *slash = strrchr(out, '/');
  if (slash == NULL) return false;
  *slash = '\0';
  return true;
}

/* Does the program stand in the folder that it was built in, or below? */
static bool runs_from_build(const char *program)
{
  char *build = realpath(UMBRA_BUILD_FOLDER, NULL);
  size_t n = build == NULL ? 0 : strlen(build);
  bool inside =
      n > 0 && strncmp(program, build, n) == 0 && (program[n] == '/' || program[n] == '\0');
  free(build);
  return inside;
}

/* In the source tree the folders of the installed tree have other names. */
static const char *source_name(const char *name)
{
  if (strcmp(name, "materials") == 0) return "materials/library";
  if (strcmp(name, "sensors") == 0) return "instrument/sensors";
  return strcmp(name, "filters") == 0 ? "instrument/filters" : name;
}

static enum um_status of_variable(struct um_context *context, const char *data, const char *name,
                                  char **out)
{
  UM_TRY(um_core_asprintf(context, out, "%s/%s", data, name));
  if (is_folder(*out)) return UM_OK;
  enum um_status status = um_core_fail(
      context, UM_ERR_IO, "%s: no such folder; accepted: UMBRA_DATA names a folder that holds %s/",
      *out, name);
  um_core_free(context, *out);
  *out = NULL;
  return status;
}

/* "folder/name" without "..", where it is a folder; *out stays NULL where it is not. */
static enum um_status try_folder(struct um_context *context, const char *folder, const char *name,
                                 char **out)
{
  char *path, *whole;
  UM_TRY(um_core_asprintf(context, &path, "%s/%s", folder, name));
  whole = realpath(path, NULL);
  um_core_free(context, path);
  enum um_status status = UM_OK;
  if (whole != NULL && is_folder(whole)) status = um_core_strdup(context, whole, out);
  free(whole);
  return status;
}

enum um_status um_core_data_folder(struct um_context *context, const char *name, char **out)
{
  char program[PATH_MAX] = "", *share;
  const char *data = getenv("UMBRA_DATA");
  *out = NULL;
  if (data != NULL && data[0] != '\0') return of_variable(context, data, name, out);
  if (!program_folder(program))
    return um_core_fail(context, UM_ERR_IO,
                        "/proc/self/exe cannot be read; accepted: UMBRA_DATA names a folder that "
                        "holds %s/",
                        name);
  UM_TRY(um_core_asprintf(context, &share, "%s/" UMBRA_DATA_FROM_PROGRAM, program));
  enum um_status status = try_folder(context, share, name, out);
  if (status == UM_OK && *out == NULL && runs_from_build(program))
    status = try_folder(context, UMBRA_SOURCE_FOLDER, source_name(name), out);
  if (status == UM_OK && *out == NULL)
    status = um_core_fail(context, UM_ERR_IO,
                          "%s/%s: no such folder; accepted: an installed tree, or UMBRA_DATA names "
                          "a folder that holds %s/",
                          share, name, name);
  um_core_free(context, share);
  return status;
}

enum um_status um_core_data_names(struct um_context *context, const char *folder, const char *tail,
                                  char ***names, size_t *count)
{
  char *path;
  *names = NULL;
  *count = 0;
  UM_TRY(um_core_data_folder(context, folder, &path));
  enum um_status status = um_core_listing(context, path, tail, folder, names, count);
  um_core_free(context, path);
  for (size_t i = 0; i < *count; i++) (*names)[i][strlen((*names)[i]) - strlen(tail)] = '\0';
  return status;
}

static enum um_status refuse_name(struct um_context *context, const char *kind, const char *name,
                                  char *const *names, size_t count)
{
  struct um_core_words_guess guess = {.written = name};
  char accepted[640] = "", hint[UM_CORE_WORDS_HINT];
  for (size_t i = 0; i < count; i++) {
    um_core_words_append(accepted, sizeof accepted, names[i]);
    um_core_words_consider(&guess, names[i]);
  }
  return um_core_fail(context, UM_ERR_INPUT, "no %s '%s'%s; accepted: %s", kind, name,
                      um_core_words_hint(&guess, hint), accepted);
}

enum um_status um_core_data_find(struct um_context *context, const char *kind, const char *folder,
                                 const char *tail, const char *name, char **out)
{
  enum um_status status;
  char **names = NULL, *path = NULL;
  size_t count = 0, at = 0;
  *out = NULL;
  UM_CHECK(um_core_data_names(context, folder, tail, &names, &count));
  while (at < count && strcmp(names[at], name) != 0) at++;
  if (at == count) {
    status = refuse_name(context, kind, name, names, count);
    goto done;
  }
  UM_CHECK(um_core_data_folder(context, folder, &path));
  status = um_core_asprintf(context, out, "%s/%s%s", path, name, tail);
done:
  um_core_free(context, path);
  um_core_listing_free(context, names, count);
  return status;
}
