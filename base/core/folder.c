/* An output folder that appears whole: written beside its place under a temporary name, brought to
 * the disk, then renamed; where a folder stands there already, the two change places in one step if
 * the file system can. A folder of Umbra carries the marker file ".umbra", which its writer keeps
 * locked: what a dead process left is known by the free lock (stale_temporaries.c). */
#define _GNU_SOURCE /* renameat2 */
#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/core/file.h"
#include "base/core/replay.h"
#include "base/core/stale_temporaries_impl.h"

#define MARKER     UM_CORE_FOLDER_MARKER
#define NAME_TRIES 100

struct um_core_folder {
  struct um_context *context;
  char *target;       /* without trailing slashes */
  char *partial;      /* the temporary folder; NULL: not made */
  size_t parent_made; /* number of parent folders that begin made */
  bool given;         /* to the user: nothing is replaced, no marker stays */
  int lock;           /* descriptor of the marker in `partial`, locked; -1: none */
  bool force;
};

static enum um_status fail_errno(struct um_context *context, const char *path, const char *what)
{
  return um_core_fail(context, UM_ERR_IO, "%s: %s: %s", path, what, strerror(errno));
}

/* "dir/.name.<kind>-<pid>" beside `path`, with "-<attempt>" behind when attempt > 0. */
static enum um_status name_beside(struct um_context *context, const char *path, const char *kind,
                                  int attempt, char **out)
{
  const char *slash = strrchr(path, '/');
  const char *name = slash == NULL ? path : slash + 1;
  char suffix[16] = "";
  if (attempt > 0) snprintf(suffix, sizeof suffix, "-%d", attempt);
  return um_core_asprintf(context, out, "%.*s.%s.%s-%ld%s", (int)(name - path), path, name, kind,
                          (long)getpid(), suffix);
}

/* A copy of `path` without trailing slashes whose last part is a plain name. */
static enum um_status clean_target(struct um_context *context, const char *path, char **out)
{
  UM_TRY(um_core_strdup(context, path, out));
  char *text = *out;
  size_t n = strlen(text);
  while (n > 1 && text[n - 1] == '/') text[--n] = '\0';
  const char *slash = strrchr(text, '/');
  if (um_core_path_is_plain(slash == NULL ? text : slash + 1)) return UM_OK;
  enum um_status status =
      um_core_fail(context, UM_ERR_IO,
                   "%s: cannot be an output folder; accepted: a path that ends in a name", path);
  um_core_free(context, text);
  *out = NULL;
  return status;
}

static enum um_status has_marker(struct um_context *context, const char *folder, bool *out)
{
  char *marker;
  struct stat st;
  UM_TRY(um_core_asprintf(context, &marker, "%s/" MARKER, folder));
  *out = lstat(marker, &st) == 0 && S_ISREG(st.st_mode);
  um_core_free(context, marker);
  return UM_OK;
}

/* True when the working folder is `path` or lies inside it. */
static bool holds_working_folder(const char *path)
{
  char *there = realpath(path, NULL), *here = realpath(".", NULL);
  bool inside = true;
  if (there != NULL && here != NULL) {
    size_t n = strlen(there);
    inside = strncmp(here, there, n) == 0 &&
             (here[n] == '\0' || here[n] == '/' || strcmp(there, "/") == 0);
  }
  free(there);
  free(here);
  return inside;
}

/* May `target` be replaced? UM_ERR_IO when not; *exists tells whether there is something. */
static enum um_status check_target(struct um_context *context, const char *target, bool force,
                                   bool *exists)
{
  struct stat st;
  *exists = lstat(target, &st) == 0;
  if (!*exists) {
    if (errno == ENOENT) return UM_OK;
    return fail_errno(context, target, "cannot be an output folder");
  }
  if (!S_ISDIR(st.st_mode))
    return um_core_fail(context, UM_ERR_IO,
                        "%s: exists and is not a folder; accepted: a new name or an Umbra folder",
                        target);
  bool marked;
  UM_TRY(has_marker(context, target, &marked));
  if (marked) return UM_OK;
  if (!force)
    return um_core_fail(context, UM_ERR_IO,
                        "%s: exists and was not written by Umbra; accepted: a new name, an Umbra "
                        "folder, or --force to replace it",
                        target);
  if (holds_working_folder(target))
    return um_core_fail(context, UM_ERR_IO,
                        "%s: holds the working folder and is not replaced, even with --force",
                        target);
  return UM_OK;
}

enum um_status um_core_parents_make(struct um_context *context, char *path, size_t *made)
{
  for (char *p = path + 1; *p != '\0'; p++) {
    if (*p != '/') continue;
    *p = '\0';
    struct stat st;
    enum um_status status = UM_OK;
    if (mkdir(path, 0777) == 0)
      (*made)++;
    else if (stat(path, &st) != 0)
      status = fail_errno(context, path, "cannot make the folder");
    else if (!S_ISDIR(st.st_mode))
      status = um_core_fail(context, UM_ERR_IO, "%s: is not a folder", path);
    *p = '/';
    if (status != UM_OK) return status;
  }
  return UM_OK;
}

/* Remove the parents that begin made, innermost first, as far as they are empty. */
static void remove_parents(struct um_core_folder *folder)
{
  for (; folder->parent_made > 0; folder->parent_made--) {
    char *slash = strrchr(folder->target, '/');
    if (slash == NULL) return;
    while (slash > folder->target && slash[-1] == '/') slash--;
    *slash = '\0';
    if (rmdir(folder->target) != 0) return;
  }
}

static enum um_status make_partial(struct um_context *context, struct um_core_folder *folder)
{
  for (int attempt = 0; attempt < NAME_TRIES; attempt++) {
    char *name;
    UM_TRY(name_beside(context, folder->target, "partial", attempt, &name));
    if (mkdir(name, 0777) == 0) {
      folder->partial = name;
      return UM_OK;
    }
    enum um_status status = UM_OK;
    if (errno != EEXIST) status = fail_errno(context, folder->target, "cannot make the folder");
    um_core_free(context, name);
    if (status != UM_OK) return status;
  }
  return um_core_fail(context, UM_ERR_IO, "%s: no free temporary name beside it", folder->target);
}

static enum um_status write_marker(struct um_context *context, struct um_core_folder *folder)
{
  FILE *file;
  UM_TRY(um_core_folder_open(context, folder, MARKER, &file));
  fputs("This folder was written by Umbra; a later run may replace it.\n", file);
  UM_TRY(um_core_file_close(context, MARKER, &file));
  char *path;
  UM_TRY(um_core_asprintf(context, &path, "%s/" MARKER, folder->partial));
  folder->lock = open(path, O_RDONLY | O_CLOEXEC);
  if (folder->lock >= 0) (void)flock(folder->lock, LOCK_EX | LOCK_NB);
  um_core_free(context, path);
  return UM_OK;
}

enum um_status um_core_folder_begin(struct um_context *context, const char *path, bool force,
                                    struct um_core_folder **out)
{
  struct um_core_folder *folder;
  bool exists;
  *out = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *folder, &folder));
  folder->context = context;
  folder->force = force;
  folder->lock = -1;
  enum um_status status;
  UM_CHECK(clean_target(context, path, &folder->target));
  UM_CHECK(check_target(context, folder->target, force, &exists));
  UM_CHECK(um_core_parents_make(context, folder->target, &folder->parent_made));
  um_core_stale_temporaries_remove(context, folder->target);
  UM_CHECK(make_partial(context, folder));
  UM_CHECK(write_marker(context, folder));
  *out = folder;
  folder = NULL;
done:
  um_core_folder_abort(&folder);
  return status;
}

const char *um_core_folder_path(const struct um_core_folder *folder) { return folder->partial; }

enum um_status um_core_folder_open(struct um_context *context, struct um_core_folder *folder,
                                   const char *name, FILE **out)
{
  *out = NULL;
  if (!um_core_path_is_plain(name))
    return um_core_fail(context, UM_ERR_INPUT,
                        "'%s' cannot name an output file; accepted: a name without '/'", name);
  char *path;
  UM_TRY(um_core_asprintf(context, &path, "%s/%s", folder->partial, name));
  enum um_status status = um_core_file_create(context, path, out);
  um_core_free(context, path);
  return status;
}

static void warn_left(struct um_context *context, const char *old)
{
  um_core_log(context, UM_LOG_WARNING, "%s: the replaced folder could not be removed: %s", old,
              strerror(errno));
}

/* Where the two cannot change places: the old folder away, the new one in. */
static enum um_status replace_in_steps(struct um_context *context, struct um_core_folder *folder)
{
  char *old;
  UM_TRY(name_beside(context, folder->target, "old", 0, &old));
  enum um_status status = UM_OK;
  if (rename(folder->target, old) != 0) {
    status = fail_errno(context, folder->target, "cannot be replaced");
  } else if (rename(folder->partial, folder->target) != 0) {
    status = fail_errno(context, folder->target, "cannot be replaced");
    (void)rename(old, folder->target);
  } else if (um_core_tree_remove(old) != 0) {
    warn_left(context, old);
  }
  um_core_free(context, old);
  return status;
}

static enum um_status replace_target(struct um_context *context, struct um_core_folder *folder)
{
  if (renameat2(AT_FDCWD, folder->partial, AT_FDCWD, folder->target, RENAME_EXCHANGE) != 0)
    return replace_in_steps(context, folder);
  if (um_core_tree_remove(folder->partial) != 0) warn_left(context, folder->partial);
  return UM_OK;
}

/* Nothing may stand at the place of a folder that is given to the user; the marker goes. */
static enum um_status prepare_given(struct um_context *context, struct um_core_folder *f)
{
  char *marker;
  struct stat st;
  if (lstat(f->target, &st) == 0)
    return um_core_fail(context, UM_ERR_IO, "%s: exists; accepted: a new name", f->target);
  UM_TRY(um_core_asprintf(context, &marker, "%s/" MARKER, f->partial));
  enum um_status status = UM_OK;
  if (unlink(marker) != 0) status = fail_errno(context, f->target, "cannot be made");
  um_core_free(context, marker);
  return status;
}

/* What was run to make it. */
static enum um_status write_replay(struct um_context *context, struct um_core_folder *f)
{
  FILE *file;
  if (um_core_replay_command(context) == NULL) return UM_OK;
  UM_TRY(um_core_folder_open(context, f, UM_CORE_REPLAY_FILE, &file));
  um_core_replay_write(context, file);
  return um_core_file_close(context, UM_CORE_REPLAY_FILE, &file);
}

enum um_status um_core_folder_give(struct um_context *context, struct um_core_folder **folder)
{
  (*folder)->given = true;
  return um_core_folder_commit(context, folder);
}

enum um_status um_core_folder_commit(struct um_context *context, struct um_core_folder **folder)
{
  struct um_core_folder *f = *folder;
  enum um_status status;
  bool exists;
  *folder = NULL;
  UM_CHECK(check_target(context, f->target, f->force, &exists));
  UM_CHECK(f->given ? prepare_given(context, f) : write_replay(context, f));
  UM_CHECK(um_core_tree_sync(context, f->partial));
  /* nothing of a run that was asked to stop is published, whoever overheard the stop */
  UM_CHECK(um_core_stop_check(context, "the results were written"));
  if (exists)
    UM_CHECK(replace_target(context, f));
  else if (rename(f->partial, f->target) != 0)
    UM_CHECK(fail_errno(context, f->target, "cannot be made"));
  um_core_free(context, f->partial);
  f->partial = NULL;
  f->parent_made = 0;
  um_core_folder_sync_parent(f->target);
done:
  um_core_folder_abort(&f);
  return status;
}

void um_core_folder_abort(struct um_core_folder **folder)
{
  if (folder == NULL || *folder == NULL) return;
  struct um_core_folder *f = *folder;
  if (f->partial != NULL) (void)um_core_tree_remove(f->partial);
  if (f->lock >= 0) close(f->lock);
  if (f->target != NULL) remove_parents(f);
  UM_FREE(f->context, f->partial, f->target, f);
  *folder = NULL;
}
