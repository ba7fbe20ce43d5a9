/* Work in a child process: fork, limits, a pipe for the answer, and an end in every case. */
#define _GNU_SOURCE /* pipe2 */
#include "base/core/child.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <poll.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ADDRESS_LIMIT 0 /* the sanitizer's shadow memory would break it */
#else
#define ADDRESS_LIMIT 1
#endif

#define DYING 5.0  /* longest wait for a child that was killed [s] */
#define LOOK  0.05 /* between two looks at time and stop [s] */
#define NAP   1e-3 /* first look at a child that has said all [s] */

static double now(void)
{
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Address space of this process [bytes]; the child inherits it. */
static size_t address_space(void)
{
  size_t pages = 0;
  FILE *file = fopen("/proc/self/statm", "re");
  if (file == NULL) return 0;
  /* NOLINTNEXTLINE(cert-err34-c): a number of the kernel's */
  if (fscanf(file, "%zu", &pages) != 1) pages = 0;
  fclose(file);
  return pages * (size_t)sysconf(_SC_PAGESIZE);
}

bool um_core_child_write(int pipe_end, const void *data, size_t bytes)
{
  const char *at = data;
  while (bytes > 0) {
    ssize_t n = write(pipe_end, at, bytes);
    if (n < 0 && errno == EINTR) continue; /* a signal to the child kills it: this ends */
    if (n <= 0) return false;
    at += n;
    bytes -= (size_t)n;
  }
  return true;
}

/* A pipe that an exec closes and whose ends are above stderr. */
static bool pipe_make(int ends[2])
{
  int made[2];
  if (pipe2(made, O_CLOEXEC) != 0) return false;
  bool good = true;
  for (int i = 0; i < 2; i++) {
    ends[i] = made[i];
    if (made[i] > STDERR_FILENO) continue;
    ends[i] = fcntl(made[i], F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    close(made[i]);
    good = good && ends[i] >= 0;
  }
  if (good) return true;
  for (int i = 0; i < 2; i++)
    if (ends[i] >= 0) close(ends[i]);
  return false;
}

/* In the child: signals as at the start of a process, limits, nothing to read or to print to. */
static void child_prepare(const struct um_core_child_limits *limits, size_t inherited, pid_t parent)
{
  static const int restored[] = {SIGINT, SIGTERM, SIGALRM, SIGPIPE, SIGXFSZ};
  for (size_t i = 0; i < sizeof restored / sizeof *restored; i++) signal(restored[i], SIG_DFL);
  if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || getppid() != parent) _exit(1);
  rlim_t seconds = (rlim_t)ceil(limits->seconds);
  setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
  setrlimit(RLIMIT_CPU, &(struct rlimit){seconds, seconds + 1});
  if (ADDRESS_LIMIT && limits->megabyte < SIZE_MAX && inherited > 0) {
    rlim_t bytes = (rlim_t)(inherited + limits->megabyte * 1048576);
    setrlimit(RLIMIT_AS, &(struct rlimit){bytes, bytes});
  }
  int null = open("/dev/null", O_RDWR);
  for (int fd = STDIN_FILENO; null >= 0 && fd <= STDERR_FILENO; fd++) dup2(null, fd);
  if (null > STDERR_FILENO) close(null);
}

/* Take what there is to read; *open: the child may write more. */
static enum um_status take(struct um_context *context, int pipe_end, size_t *room,
                           struct um_core_child_result *out, bool *open)
{
  struct pollfd wait = {.fd = pipe_end, .events = POLLIN};
  if (poll(&wait, 1, (int)(1e3 * LOOK)) <= 0) return UM_OK;
  if (out->count == *room) {
    size_t grown = 2 * *room + 65536;
    UM_TRY(um_core_reallocate(context, grown, 1, &out->answer));
    *room = grown;
  }
  ssize_t n = read(pipe_end, out->answer + out->count, *room - out->count);
  if (n > 0) out->count += (size_t)n;
  if (n == 0 || (n < 0 && errno != EINTR)) *open = false;
  return UM_OK;
}

void um_core_child_end(pid_t child, int *state)
{
  double until = now() + DYING;
  kill(child, SIGKILL);
  while (now() < until) {
    pid_t done = waitpid(child, state, WNOHANG);
    if (done == child || (done < 0 && errno != EINTR)) return;
    nanosleep(&(struct timespec){0, 500000}, NULL);
  }
}

/* Does a thread run, by its line of /proc: "number (name) state"? The name may hold anything. */
static bool runs(const char *thread)
{
  char path[64], line[256];
  snprintf(path, sizeof path, "/proc/self/task/%.20s/stat", thread);
  FILE *file = fopen(path, "re");
  if (file == NULL) return false; /* it has ended */
  size_t n = fread(line, 1, sizeof line - 1, file);
  fclose(file);
  line[n] = '\0';
  const char *behind = strrchr(line, ')');
  return behind != NULL && strncmp(behind, ") R", 3) == 0;
}

static bool others_run(void)
{
  bool any = false;
  char own[24];
  DIR *dir = opendir("/proc/self/task");
  if (dir == NULL) return false;
  snprintf(own, sizeof own, "%ld", (long)syscall(SYS_gettid));
  for (const struct dirent *entry; !any && (entry = readdir(dir)) != NULL;)
    any = entry->d_name[0] != '.' && strcmp(entry->d_name, own) != 0 && runs(entry->d_name);
  closedir(dir);
  return any;
}

void um_core_child_settle(double seconds)
{
  double until = now() + seconds;
  while (others_run() && now() < until) nanosleep(&(struct timespec){0, 200000}, NULL);
}

/* Until the child has ended, is out of time, or is not wanted any more. *state: of waitpid. */
static enum um_status watch(struct um_context *context, pid_t child, int pipe_end, double deadline,
                            const char *doing, struct um_core_child_result *out, int *state)
{
  bool open = true, ended = false, late = false;
  size_t room = 0;
  enum um_status status = UM_OK;
  for (double nap = NAP; !ended; nap = open ? NAP : fmin(2.0 * nap, LOOK)) {
    if (status == UM_OK && open) status = take(context, pipe_end, &room, out, &open);
    if (status == UM_OK) status = um_core_stop_check(context, doing);
    late = !(now() < deadline);
    if (status != UM_OK || late) break;
    if (open) continue;
    pid_t done = waitpid(child, state, WNOHANG);
    ended = done == child || (done < 0 && errno != EINTR);
    if (!ended) nanosleep(&(struct timespec){0, (long)(1e9 * nap)}, NULL);
  }
  if (!ended) um_core_child_end(child, state);
  bool processor = WIFSIGNALED(*state) && WTERMSIG(*state) == SIGXCPU;
  out->end = (!ended && late) || processor ? UM_CHILD_TIMED_OUT
             : WIFSIGNALED(*state)         ? UM_CHILD_SIGNALLED
                                           : UM_CHILD_EXITED;
  out->code = WIFSIGNALED(*state) ? WTERMSIG(*state) : WEXITSTATUS(*state);
  return status;
}

enum um_status um_core_child_run(struct um_context *context, const char *name,
                                 um_core_child_work work, void *self,
                                 const struct um_core_child_limits *limits,
                                 struct um_core_child_result *out)
{
  int ends[2], state = 0;
  char doing[96];
  size_t inherited = address_space();
  pid_t parent = getpid();
  *out = (struct um_core_child_result){0};
  snprintf(doing, sizeof doing, "%s worked", name);
  if (!pipe_make(ends))
    return um_core_fail(context, UM_ERR_LIBRARY, "no pipe to %s: %s", name, strerror(errno));
  fflush(NULL);
  pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    child_prepare(limits, inherited, parent);
    _exit(work(self, ends[1]));
  }
  int why = errno;
  close(ends[1]);
  enum um_status status =
      child < 0
          ? um_core_fail(context, UM_ERR_LIBRARY, "no process for %s: %s", name, strerror(why))
          : watch(context, child, ends[0], now() + limits->seconds, doing, out, &state);
  close(ends[0]);
  if (status == UM_OK) return UM_OK;
  um_core_free(context, out->answer);
  *out = (struct um_core_child_result){0};
  return status;
}
