/* What a folder in the making needs of the file system, and what dead processes left of theirs. */
#define _GNU_SOURCE /* flock */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/core/file.h"
#include "base/core/stale_temporaries_impl.h"

static int remove_entry(const char *path, const struct stat *st, int kind, struct FTW *ftw)
{
  (void)st;
  (void)kind;
  (void)ftw;
  return remove(path);
}

int um_core_tree_remove(const char *path)
{
  return nftw(path, remove_entry, 16, FTW_DEPTH | FTW_PHYS);
}

/* 0, or -1 with errno. A file system that cannot is no error. */
static int sync_path(const char *path)
{
  int fd = open(path, O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  if (fd < 0) return -1;
  int code = fsync(fd), why = errno;
  if (code != 0 && (why == EINVAL || why == ENOTSUP)) code = 0;
  close(fd);
  errno = why;
  return code;
}

static int sync_entry(const char *path, const struct stat *st, int kind, struct FTW *ftw)
{
  (void)ftw;
  bool ours = kind == FTW_DP || (kind == FTW_F && S_ISREG(st->st_mode));
  return ours ? sync_path(path) : 0;
}

enum um_status um_core_tree_sync(struct um_context *context, const char *path)
{
  if (nftw(path, sync_entry, 16, FTW_DEPTH | FTW_PHYS) == 0) return UM_OK;
  return um_core_fail(context, UM_ERR_IO, "%s: cannot be written: %s", path, strerror(errno));
}

void um_core_folder_sync_parent(const char *path)
{
  const char *slash = strrchr(path, '/');
  char *folder = slash == NULL   ? strdup(".")
                 : slash == path ? strdup("/")
                                 : strndup(path, (size_t)(slash - path));
  if (folder != NULL) (void)sync_path(folder);
  free(folder);
}

/* The number behind `prefix`, which ends there or at a '-'; 0: the name is another. */
static pid_t writer_of(const char *name, const char *prefix)
{
  size_t n = strlen(prefix);
  if (strncmp(name, prefix, n) != 0) return 0;
  char *end;
  long pid = strtol(name + n, &end, 10);
  if (end == name + n || (*end != '\0' && *end != '-') || pid <= 0 || name[n] == '-') return 0;
  return (pid_t)pid;
}

/* Its writer's number is free, or ours, who has nothing here yet; and a marker is not locked, which
 * tells of writers on other machines and in other containers, whose numbers mean nothing here. */
static bool is_dead(const char *path, pid_t writer)
{
  char marker[4096];
  if (writer != getpid() && (kill(writer, 0) == 0 || errno != ESRCH)) return false;
  int n = snprintf(marker, sizeof marker, "%s/" UM_CORE_FOLDER_MARKER, path);
  int fd =
      n < (int)sizeof marker ? open(marker, O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK) : -1;
  if (fd < 0) return true;
  bool unlocked = flock(fd, LOCK_EX | LOCK_NB) == 0;
  close(fd);
  return unlocked;
}

static void take_away(struct um_context *context, const char *target, const char *path, bool old)
{
  struct stat st;
  if (old && lstat(target, &st) != 0 && errno == ENOENT && rename(path, target) == 0) {
    um_core_log(context, UM_LOG_WARNING, "%s: put back after a run that was ended", target);
    return;
  }
  if (um_core_tree_remove(path) == 0)
    um_core_log(context, UM_LOG_INFO, "%s: left by a run that was ended, removed", path);
}

void um_core_stale_temporaries_remove(struct um_context *context, const char *target)
{
  const char *slash = strrchr(target, '/'), *name = slash == NULL ? target : slash + 1;
  int n = (int)(name - target);
  char folder[4096], prefix[2][300], path[4096 + 300];
  if (snprintf(folder, sizeof folder, "%.*s", n, target) >= (int)sizeof folder) return;
  if (snprintf(prefix[0], sizeof prefix[0], ".%s.partial-", name) >= (int)sizeof prefix[0]) return;
  snprintf(prefix[1], sizeof prefix[1], ".%s.old-", name);
  DIR *all = opendir(n == 0 ? "." : folder);
  if (all == NULL) return;
  for (struct dirent *entry; (entry = readdir(all)) != NULL;)
    for (int old = 0; old < 2; old++) {
      pid_t writer = writer_of(entry->d_name, prefix[old]);
      if (writer == 0) continue;
      snprintf(path, sizeof path, "%s%s", folder, entry->d_name);
      if (is_dead(path, writer)) take_away(context, target, path, old == 1);
    }
  closedir(all);
}

void um_core_file_stale_temporaries_remove(struct um_context *context, const char *path)
{
  um_core_stale_temporaries_remove(context, path);
}

enum um_status um_core_file_sync(struct um_context *context, const char *name, FILE *file)
{
  int code = fflush(file) != 0 ? -1 : fsync(fileno(file));
  if (code == 0 || errno == EINVAL || errno == ENOTSUP) return UM_OK;
  return um_core_fail(context, UM_ERR_IO, "%s: cannot be written: %s", name, strerror(errno));
}
