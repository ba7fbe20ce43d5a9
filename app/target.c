/* Where a command may write. */
#include "app/target.h"

#include <string.h>
#include <strings.h>
#include <sys/stat.h>

const char *um_app_ending(const char *path)
{
  const char *slash = strrchr(path, '/'), *name = slash == NULL ? path : slash + 1;
  const char *dot = strrchr(name, '.');
  return dot == NULL || dot == name ? "" : dot;
}

/* list: endings with ", " between. */
static bool is_among(const char *ending, const char *list)
{
  size_t n = strlen(ending);
  for (const char *at = strchr(list, '.'); at != NULL; at = strchr(at + 1, '.'))
    if (strncasecmp(at, ending, n) == 0 && (at[n] == ',' || at[n] == '\0')) return true;
  return false;
}

bool um_app_ends_in(const char *path, const char *endings)
{
  const char *ending = um_app_ending(path);
  return ending[0] != '\0' && is_among(ending, endings);
}

bool um_app_is_cube(const char *path) { return um_app_ends_in(path, ".nc"); }

enum um_status um_app_check_target(struct um_context *context, const char *out, bool force)
{
  struct stat st;
  if (stat(out, &st) != 0 || !S_ISREG(st.st_mode) || force) return UM_OK;
  return um_core_fail(context, UM_ERR_IO, "%s: exists; accepted: a new name, or --force", out);
}

enum um_status um_app_check_table(struct um_context *context, const struct um_app_options *options)
{
  const char *out = options->out, *ending = um_app_ending(out);
  UM_TRY(um_app_check_target(context, out, options->force));
  if (!um_app_ends_in(out, UM_APP_PICTURES ", " UM_APP_FRAMES ", .png")) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "%s: a table is CSV, not %s; accepted: a name in .csv",
                      out, ending);
}

enum um_status um_app_check_picture(struct um_context *context,
                                    const struct um_app_options *options, const char *endings)
{
  return um_app_check_whole(context, options->out, options->force, endings);
}

enum um_status um_app_check_whole(struct um_context *context, const char *out, bool force,
                                  const char *endings)
{
  struct stat st;
  char *folder = NULL;
  const char *slash = strrchr(out, '/'), *ending = um_app_ending(out);
  if (lstat(out, &st) == 0) {
    if (!S_ISREG(st.st_mode))
      return um_core_fail(context, UM_ERR_IO, "%s: is not a file; accepted: a file name", out);
    if (!force)
      return um_core_fail(context, UM_ERR_IO, "%s: exists; accepted: a new name, or --force", out);
  }
  if (ending[0] != '\0' && !um_app_ends_in(out, endings))
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: no '%s' is written here; accepted: a name in %s", out, ending,
                        endings);
  if (slash == NULL) return UM_OK;
  UM_TRY(um_core_asprintf(context, &folder, "%.*s", (int)(slash - out) + 1, out));
  bool there = stat(folder, &st) == 0 && S_ISDIR(st.st_mode);
  um_core_free(context, folder);
  if (there && slash[1] != '\0') return UM_OK;
  return um_core_fail(context, UM_ERR_IO, "%s: %s; accepted: a file name in a folder that exists",
                      out, there ? "is a folder" : "there is no such folder");
}
