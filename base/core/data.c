/* Where the program's own files lie. */
#define _GNU_SOURCE /* dladdr1 */
#include "base/core/data.h"

#include <dlfcn.h>
#include <limits.h>
#include <link.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/core/listing.h"
#include "base/core/replay.h"
#include "base/core/suggestions.h"

static bool is_folder(const char *path)
{
  struct stat info;
  return stat(path, &info) == 0 && S_ISDIR(info.st_mode);
}

/* Cut behind the folder; false where there is none. */
static bool cut_name(char path[PATH_MAX])
{
  char *slash = strrchr(path, '/');
  if (slash != NULL) *slash = '\0';
  return slash != NULL;
}

/* The running program, links resolved; false where the system does not say. */
static bool program_file(char out[PATH_MAX])
{
  ssize_t n = readlink("/proc/self/exe", out, PATH_MAX);
  if (n <= 0 || n >= PATH_MAX) return false;
  out[n] = '\0';
  return true;
}

/* The shared library that this code is part of, links resolved; false: of none, it is part of the
 * program. */
static bool library_file(char out[PATH_MAX])
{
  static const char here; /* an address of this code */
  Dl_info info;
  void *map = NULL;
  if (dladdr1(&here, &info, &map, RTLD_DL_LINKMAP) == 0 || map == NULL) return false;
  const struct link_map *object = map;
  if (object->l_name == NULL || object->l_name[0] == '\0') return false;
  return realpath(object->l_name, out) != NULL;
}

/* Their folders. */
static bool program_folder(char out[PATH_MAX]) { return program_file(out) && cut_name(out); }
static bool library_folder(char out[PATH_MAX]) { return library_file(out) && cut_name(out); }

enum um_status um_core_data_program(struct um_context *context, char **out)
{
  char path[PATH_MAX];
  *out = NULL;
  if (!library_file(path) && !program_file(path))
    return um_core_fail(context, UM_ERR_IO, "/proc/self/exe cannot be read; accepted: a /proc");
  return um_core_strdup(context, path, out);
}

/* Does the folder lie in the one that this was built in, or below? */
static bool is_in_build(const char *folder)
{
  char *build = realpath(UMBRA_BUILD_FOLDER, NULL);
  size_t n = build == NULL ? 0 : strlen(build);
  bool inside = n > 0 && strncmp(folder, build, n) == 0 && (folder[n] == '/' || folder[n] == '\0');
  free(build);
  return inside;
}

/* In the source tree the folders of the installed tree have other names. */
static const char *source_name(const char *name)
{
  if (strcmp(name, "materials") == 0) return "materials/library";
  if (strcmp(name, "sensors") == 0) return "optics/instrument/sensors";
  return strcmp(name, "filters") == 0 ? "optics/instrument/filters" : name;
}

/* said: what names `data`. */
static enum um_status of_folder(struct um_context *context, const char *said, const char *data,
                                const char *name, char **out)
{
  UM_TRY(um_core_asprintf(context, out, "%s/%s", data, name));
  if (is_folder(*out)) return UM_OK;
  enum um_status status =
      um_core_fail(context, UM_ERR_IO, "%s: no such folder; accepted: %s a folder that holds %s/",
                   *out, said, name);
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

/* From the folder `from`, in which program or library stand: share/umbra by the way of the
 * installed tree, else the source tree. */
static enum um_status beside(struct um_context *context, const char *from, const char *way,
                             const char *name, char **out)
{
  char *share;
  UM_TRY(um_core_asprintf(context, &share, "%s/%s", from, way));
  enum um_status status = try_folder(context, share, name, out);
  if (status == UM_OK && *out == NULL && is_in_build(from))
    status = try_folder(context, UMBRA_SOURCE_FOLDER, source_name(name), out);
  if (status == UM_OK && *out == NULL)
    status = um_core_fail(context, UM_ERR_IO,
                          "%s/%s: no such folder; accepted: an installed tree, or UMBRA_DATA names "
                          "a folder that holds %s/",
                          share, name, name);
  if (status == UM_OK) status = um_core_replay_leave_out(context, *out);
  if (status != UM_OK) {
    um_core_free(context, *out);
    *out = NULL;
  }
  um_core_free(context, share);
  return status;
}

enum um_status um_core_data_folder(struct um_context *context, const char *name, char **out)
{
  char folder[PATH_MAX] = "";
  const char *given = um_core_context_data(context), *data = getenv("UMBRA_DATA");
  *out = NULL;
  if (given != NULL) return of_folder(context, "the data folder is", given, name, out);
  if (data != NULL && data[0] != '\0')
    return of_folder(context, "UMBRA_DATA names", data, name, out);
  if (library_folder(folder)) return beside(context, folder, UMBRA_DATA_FROM_LIBRARY, name, out);
  if (program_folder(folder)) return beside(context, folder, UMBRA_DATA_FROM_PROGRAM, name, out);
  return um_core_fail(context, UM_ERR_IO,
                      "/proc/self/exe cannot be read; accepted: UMBRA_DATA names a folder that "
                      "holds %s/",
                      name);
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
