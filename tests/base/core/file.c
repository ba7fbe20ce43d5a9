/* Whole files, names, and output folders that appear whole or not at all. Everything happens in a
 * fresh folder below the working folder of the test. */
#define _GNU_SOURCE /* flock */
#include "base/core/file.h"
#include "base/core/file_snapshot.h"

#include <dirent.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/cmocka_all.h"

static struct um_context *context;
static char base[] = "umbra-test-XXXXXX";

static int set_up(void **state)
{
  (void)state;
  if (mkdtemp(base) == NULL || chdir(base) != 0) return -1;
  return um_core_context_create(NULL, &context) == UM_OK ? 0 : -1;
}

static int tear_down(void **state)
{
  (void)state;
  um_core_context_destroy(&context);
  return chdir("..") == 0 && rmdir(base) == 0 ? 0 : -1;
}

static bool exists(const char *path)
{
  struct stat st;
  return lstat(path, &st) == 0;
}

static void write_file(const char *path, const char *text)
{
  FILE *file = fopen(path, "wb");
  assert_non_null(file);
  fputs(text, file);
  assert_int_equal(fclose(file), 0);
}

/* Number of entries of a folder, hidden ones included. */
static int entries(const char *path)
{
  int count = 0;
  DIR *dir = opendir(path);
  assert_non_null(dir);
  struct dirent *e;
  while ((e = readdir(dir)) != NULL)
    if (strcmp(e->d_name, ".") != 0 && strcmp(e->d_name, "..") != 0) count++;
  closedir(dir);
  return count;
}

/* Begin, write one file, commit. */
static void make_folder(const char *path, bool force, const char *name, const char *text)
{
  struct um_core_folder *folder;
  FILE *file;
  assert_int_equal(um_core_folder_begin(context, path, force, &folder), UM_OK);
  assert_int_equal(um_core_folder_open(context, folder, name, &file), UM_OK);
  fputs(text, file);
  assert_int_equal(um_core_file_close(context, name, &file), UM_OK);
  assert_null(file);
  assert_int_equal(um_core_folder_commit(context, &folder), UM_OK);
  assert_null(folder);
}

static void refused(const char *path, bool force, const char *message)
{
  struct um_core_folder *folder;
  um_core_message_clear(context);
  assert_int_equal(um_core_folder_begin(context, path, force, &folder), UM_ERR_IO);
  assert_null(folder);
  assert_string_equal(um_core_message(context), message);
}

static void test_read(void **state)
{
  (void)state;
  char *text;
  size_t length;
  write_file("a.txt", "hello");
  assert_int_equal(um_core_file_read(context, "a.txt", 5, &text, &length), UM_OK);
  assert_int_equal(length, 5);
  assert_string_equal(text, "hello");
  um_core_free(context, text);
  um_core_message_clear(context);
  assert_int_equal(um_core_file_read(context, "a.txt", 4, &text, &length), UM_ERR_IO);
  assert_string_equal(um_core_message(context), "a.txt: larger than the 4 bytes accepted");
  assert_null(text);
  write_file("a.txt", "");
  assert_int_equal(um_core_file_read(context, "a.txt", 4, &text, &length), UM_OK);
  assert_int_equal(length, 0);
  assert_string_equal(text, "");
  um_core_free(context, text);
  /* a file whose size is not known beforehand and which exceeds the limit */
  um_core_message_clear(context);
  assert_int_equal(um_core_file_read(context, "/proc/self/smaps", 5000, &text, &length), UM_ERR_IO);
  assert_string_equal(um_core_message(context),
                      "/proc/self/smaps: larger than the 5000 bytes accepted");
  remove("a.txt");
}

static void make_socket(const char *path)
{
  struct sockaddr_un address = {.sun_family = AF_UNIX};
  int descriptor = socket(AF_UNIX, SOCK_STREAM, 0);
  snprintf(address.sun_path, sizeof address.sun_path, "%s", path);
  assert_int_equal(bind(descriptor, (void *)&address, sizeof address), 0);
  close(descriptor);
}

/* What is no plain file is refused, and not waited for: the alarm would end this program. */
static void test_plain_only(void **state)
{
  (void)state;
  static const struct {
    const char *path, *says;
  } cases[] = {{"pipe", "pipe: is not a plain file but a pipe"},
               {"link", "link: is not a plain file but a pipe"},
               {"socket", "socket: is not a plain file but a socket"},
               {"/dev/zero", "/dev/zero: is not a plain file but a device"},
               {".", ".: is not a plain file but a folder"},
               {"none", "none: No such file or directory"}};
  assert_int_equal(mkfifo("pipe", 0666), 0);
  assert_int_equal(symlink("pipe", "link"), 0);
  make_socket("socket");
  alarm(10);
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    char *text;
    size_t length;
    FILE *file;
    int descriptor;
    um_core_message_clear(context);
    assert_int_equal(um_core_file_read(context, cases[i].path, 100, &text, &length), UM_ERR_IO);
    assert_null(text);
    assert_string_equal(um_core_message(context), cases[i].says);
    assert_int_equal(um_core_file_open(context, cases[i].path, &file), UM_ERR_IO);
    assert_null(file);
    assert_int_equal(um_core_file_check(context, cases[i].path), UM_ERR_IO);
    assert_int_equal(um_core_descriptor_open(context, cases[i].path, O_RDWR, &descriptor),
                     UM_ERR_IO);
    assert_int_equal(descriptor, -1);
  }
  /* what a dead process left, its marker a pipe */
  assert_int_equal(mkdir(".out.partial-2147483647", 0777), 0);
  assert_int_equal(rename("pipe", ".out.partial-2147483647/.umbra"), 0);
  make_folder("out", false, "a", "b");
  assert_false(exists(".out.partial-2147483647"));
  alarm(0);
  remove("link");
  remove("socket");
  remove("out/a");
  remove("out/.umbra");
  remove("out");
}

struct listed {
  size_t n;
  const char *path[4];
  uint64_t digest[4];
};

static void list(void *self, const char *path, uint64_t digest)
{
  struct listed *l = self;
  assert_in_range(l->n, 0, 3);
  l->path[l->n] = path;
  l->digest[l->n++] = digest;
}

/* Held files: what was read stays as it was, what others read must; digests are those of the
 * published table of FNV-1a, 64 bits (Noll, test vectors: "", "foobar", "a"). */
static void test_held(void **state)
{
  (void)state;
  static const struct {
    const char *path, *text;
    uint64_t digest;
  } file[] = {{"a.txt", "foobar", 0x85944171f73967e8u},
              {"b.so", "a", 0xaf63dc4c8601ec8cu},
              {"c.txt", "", 0xcbf29ce484222325u}};
  struct listed listed = {0};
  char *text;
  size_t length;
  for (size_t i = 0; i < 3; i++) write_file(file[i].path, file[i].text);
  assert_int_equal(um_core_snapshot_note(context, "b.so"), UM_OK); /* nothing is held */
  assert_int_equal(um_core_snapshot_begin(context), UM_OK);
  for (int again = 0; again < 2; again++) {
    for (size_t i = 0; i < 3; i++) {
      if (i == 1) {
        assert_int_equal(um_core_snapshot_note(context, "b.so"), UM_OK);
        continue;
      }
      assert_int_equal(um_core_file_read(context, file[i].path, 9, &text, &length), UM_OK);
      assert_string_equal(text, file[i].text);
      um_core_free(context, text);
    }
    write_file("a.txt", "others");
  }
  um_core_snapshot_each(context, list, &listed);
  assert_int_equal(listed.n, 3);
  for (size_t i = 0; i < 3; i++) {
    assert_string_equal(listed.path[i], file[i].path);
    assert_true(listed.digest[i] == file[i].digest);
  }
  /* a second holder lists what it uses itself */
  assert_int_equal(um_core_snapshot_begin(context), UM_OK);
  assert_int_equal(um_core_snapshot_note(context, "b.so"), UM_OK);
  assert_int_equal(um_core_file_read(context, "a.txt", 9, &text, &length), UM_OK);
  um_core_free(context, text);
  listed.n = 0;
  um_core_snapshot_each(context, list, &listed);
  assert_int_equal(listed.n, 2);
  assert_string_equal(listed.path[0], "b.so");
  assert_string_equal(listed.path[1], "a.txt");
  um_core_snapshot_end(context);
  write_file("b.so", "ab");
  um_core_message_clear(context);
  assert_int_equal(um_core_snapshot_note(context, "b.so"), UM_ERR_IO);
  assert_non_null(strstr(um_core_message(context), "b.so: has changed since it was read first"));
  /* a map that was a table and is a netCDF file now, or the other way round */
  um_core_message_clear(context);
  assert_int_equal(um_core_snapshot_note(context, "a.txt"), UM_ERR_IO);
  assert_non_null(strstr(um_core_message(context), "a.txt: has changed since it was read first"));
  um_core_message_clear(context);
  assert_int_equal(um_core_file_read(context, "b.so", 9, &text, &length), UM_ERR_IO);
  assert_null(text);
  assert_non_null(strstr(um_core_message(context), "b.so: has changed since it was read first"));
  um_core_message_clear(context);
  um_core_snapshot_end(context);
  assert_int_equal(um_core_file_read(context, "a.txt", 9, &text, &length), UM_OK);
  assert_string_equal(text, "others");
  um_core_free(context, text);
  for (size_t i = 0; i < 3; i++) remove(file[i].path);
}

static void test_names(void **state)
{
  (void)state;
  static const struct {
    const char *base, *relative, *expected;
  } cases[] = {{"dir/s.yaml", "mesh.obj", "dir/mesh.obj"},
               {"s.yaml", "mesh.obj", "mesh.obj"},
               {"/a/b/s.yaml", "../m.csv", "/a/b/../m.csv"},
               {"/s.yaml", "m.csv", "/m.csv"},
               {"dir/s.yaml", "/abs/m.csv", "/abs/m.csv"}};
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    char *out;
    assert_int_equal(um_core_path_resolve(context, cases[i].base, cases[i].relative, &out), UM_OK);
    assert_string_equal(out, cases[i].expected);
    um_core_free(context, out);
  }
  assert_true(um_core_path_is_plain("run.nc"));
  assert_true(um_core_path_is_plain("..."));
  assert_false(um_core_path_is_plain(""));
  assert_false(um_core_path_is_plain("."));
  assert_false(um_core_path_is_plain(".."));
  assert_false(um_core_path_is_plain("a/b"));
}

static void test_commit_and_replace(void **state)
{
  (void)state;
  make_folder("deep/er/out//", false, "one.csv", "1");
  assert_true(exists("deep/er/out/one.csv"));
  assert_true(exists("deep/er/out/.umbra"));
  assert_int_equal(entries("deep/er"), 1);
  /* a later run replaces it: what the first wrote is gone */
  make_folder("deep/er/out", false, "two.csv", "2");
  assert_false(exists("deep/er/out/one.csv"));
  assert_true(exists("deep/er/out/two.csv"));
  assert_int_equal(entries("deep/er"), 1);
  assert_int_equal(entries("deep/er/out"), 2);
  remove("deep/er/out/two.csv");
  remove("deep/er/out/.umbra");
  rmdir("deep/er/out");
  rmdir("deep/er");
  rmdir("deep");
}

static void test_nothing_before_commit(void **state)
{
  (void)state;
  make_folder("out", false, "old.csv", "1");
  struct um_core_folder *folder, *other;
  FILE *file;
  assert_int_equal(um_core_folder_begin(context, "out", false, &folder), UM_OK);
  assert_int_equal(um_core_folder_begin(context, "out", false, &other), UM_OK);
  assert_string_not_equal(um_core_folder_path(folder), um_core_folder_path(other));
  assert_int_equal(um_core_folder_open(context, folder, "new.csv", &file), UM_OK);
  assert_int_equal(um_core_file_close(context, "new.csv", &file), UM_OK);
  assert_true(exists("out/old.csv"));
  assert_false(exists("out/new.csv"));
  /* names inside cannot lead outside */
  um_core_message_clear(context);
  assert_int_equal(um_core_folder_open(context, folder, "../x", &file), UM_ERR_INPUT);
  assert_string_equal(um_core_message(context),
                      "'../x' cannot name an output file; accepted: a name without '/'");
  um_core_folder_abort(&folder);
  assert_null(folder);
  um_core_folder_abort(&folder);
  um_core_folder_abort(NULL);
  um_core_folder_abort(&other);
  assert_int_equal(entries("."), 1);
  assert_true(exists("out/old.csv"));
  remove("out/old.csv");
  remove("out/.umbra");
  rmdir("out");
}

static void test_abort_removes_parents_made(void **state)
{
  (void)state;
  struct um_core_folder *folder;
  mkdir("kept", 0777);
  assert_int_equal(um_core_folder_begin(context, "kept/a/b/out", false, &folder), UM_OK);
  assert_true(exists("kept/a/b"));
  um_core_folder_abort(&folder);
  assert_true(exists("kept"));
  assert_false(exists("kept/a"));
  rmdir("kept");
}

static void test_refusals(void **state)
{
  (void)state;
  mkdir("mine", 0777);
  write_file("mine/thesis.txt", "x");
  refused("mine", false,
          "mine: exists and was not written by Umbra; accepted: a new name, an Umbra folder, or "
          "--force to replace it");
  assert_true(exists("mine/thesis.txt"));
  refused("mine/thesis.txt", true,
          "mine/thesis.txt: exists and is not a folder; accepted: a new name or an Umbra folder");
  refused("mine/thesis.txt/out", false,
          "mine/thesis.txt/out: cannot be an output folder: Not a directory");
  refused("", false, ": cannot be an output folder; accepted: a path that ends in a name");
  refused("..", true, "..: cannot be an output folder; accepted: a path that ends in a name");
  refused("mine/.", true,
          "mine/.: cannot be an output folder; accepted: a path that ends in a name");
  refused("/", true, "/: cannot be an output folder; accepted: a path that ends in a name");
  assert_int_equal(entries("."), 1);
  /* a folder that holds the working folder is not replaced even with force */
  char here[4096], above[4200];
  assert_non_null(getcwd(here, sizeof here));
  snprintf(above, sizeof above, "../%s", strrchr(here, '/') + 1);
  struct um_core_folder *folder;
  assert_int_equal(um_core_folder_begin(context, above, true, &folder), UM_ERR_IO);
  assert_true(exists("mine/thesis.txt"));
  make_folder("mine", true, "run.nc", "1");
  assert_false(exists("mine/thesis.txt"));
  remove("mine/run.nc");
  remove("mine/.umbra");
  rmdir("mine");
}

/* What stood in the way appeared after begin: commit must not destroy it. */
static void test_target_appears_meanwhile(void **state)
{
  (void)state;
  struct um_core_folder *folder;
  assert_int_equal(um_core_folder_begin(context, "out", false, &folder), UM_OK);
  mkdir("out", 0777);
  write_file("out/precious.txt", "x");
  assert_int_equal(um_core_folder_commit(context, &folder), UM_ERR_IO);
  assert_null(folder);
  assert_true(exists("out/precious.txt"));
  assert_int_equal(entries("."), 1);
  remove("out/precious.txt");
  rmdir("out");
}

/* /dev/full refuses every write when the buffer is flushed. */
static void test_disk_full(void **state)
{
  (void)state;
  FILE *file = fopen("/dev/full", "wb");
  if (file == NULL) {
    print_message("skipped: this system has no /dev/full\n");
    skip();
  }
  fputs("data", file);
  um_core_message_clear(context);
  assert_int_equal(um_core_file_close(context, "run.nc", &file), UM_ERR_IO);
  assert_null(file);
  assert_string_equal(um_core_message(context),
                      "run.nc: cannot be written: No space left on device");
  assert_int_equal(um_core_file_close(context, "run.nc", &file), UM_OK);
}

/* A number that no process has: that of a child that has ended. */
static long dead_process(void)
{
  pid_t child = fork();
  assert_true(child >= 0);
  if (child == 0) _exit(0);
  assert_int_equal(waitpid(child, NULL, 0), child);
  return (long)child;
}

static void make_left(const char *kind, long writer, char *path)
{
  char marker[128];
  snprintf(path, 100, ".out.%s-%ld", kind, writer);
  assert_int_equal(mkdir(path, 0777), 0);
  snprintf(marker, sizeof marker, "%s/.umbra", path);
  write_file(marker, "x");
}

static void remove_left(const char *path)
{
  char marker[128];
  snprintf(marker, sizeof marker, "%s/.umbra", path);
  assert_int_equal(remove(marker), 0);
  assert_int_equal(rmdir(path), 0);
}

/* Of the folders beside a new one those of dead processes go; those of living ones, of others who
 * hold the lock, and what only looks like them stay. */
static void test_stale_temporaries(void **state)
{
  (void)state;
  char dead[100], old[100], living[100], locked[100], marker[128];
  long writer = dead_process();
  make_folder("out", false, "a", "1");
  make_left("partial", writer, dead);
  make_left("old", writer, old);
  make_left("partial", (long)getppid(), living);
  make_left("partial", dead_process(), locked);
  snprintf(marker, sizeof marker, "%s/.umbra", locked);
  int lock = open(marker, O_RDONLY);
  assert_true(lock >= 0 && flock(lock, LOCK_EX | LOCK_NB) == 0);
  assert_int_equal(mkdir(".out.partial-x", 0777), 0);
  assert_int_equal(mkdir(".outer.partial-1", 0777), 0);
  make_folder("out", false, "a", "2");
  assert_false(exists(dead) || exists(old));
  assert_true(exists(living) && exists(locked));
  assert_true(exists(".out.partial-x") && exists(".outer.partial-1"));
  close(lock);
  make_folder("out", false, "a", "3");
  assert_false(exists(locked));
  remove_left(living);
  assert_int_equal(rmdir(".out.partial-x"), 0);
  assert_int_equal(rmdir(".outer.partial-1"), 0);
  assert_int_equal(remove("out/a"), 0);
  remove_left("out");
}

/* Ended between the two renames of a replacement: the earlier results come back. */
static void test_old_is_put_back(void **state)
{
  (void)state;
  char old[100];
  struct um_core_folder *folder = NULL;
  make_left("old", dead_process(), old);
  assert_int_equal(um_core_folder_begin(context, "out", false, &folder), UM_OK);
  assert_true(exists("out/.umbra"));
  assert_false(exists(old));
  um_core_folder_abort(&folder);
  remove_left("out");
}

static bool always(void *self)
{
  (void)self;
  return true;
}

static void test_stop_publishes_nothing(void **state)
{
  (void)state;
  struct um_core_folder *folder = NULL;
  assert_int_equal(um_core_folder_begin(context, "out", false, &folder), UM_OK);
  um_core_context_set_stop(context, always, NULL);
  assert_int_equal(um_core_folder_commit(context, &folder), UM_ERR_CANCELLED);
  um_core_context_set_stop(context, NULL, NULL);
  um_core_message_clear(context);
  assert_false(exists("out"));
  assert_int_equal(entries("."), 0);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_read),
      cmocka_unit_test(test_plain_only),
      cmocka_unit_test(test_held),
      cmocka_unit_test(test_names),
      cmocka_unit_test(test_commit_and_replace),
      cmocka_unit_test(test_nothing_before_commit),
      cmocka_unit_test(test_abort_removes_parents_made),
      cmocka_unit_test(test_refusals),
      cmocka_unit_test(test_target_appears_meanwhile),
      cmocka_unit_test(test_disk_full),
      cmocka_unit_test(test_stale_temporaries),
      cmocka_unit_test(test_old_is_put_back),
      cmocka_unit_test(test_stop_publishes_nothing),
  };
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
