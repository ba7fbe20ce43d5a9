/* What is done in child processes: what a child covers counts as covered, and what a sanitizer says
 * there is told to the parent. */
#define _GNU_SOURCE /* MAP_ANONYMOUS */
#include <pthread.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "tests/fuzz/fuzz.h"

/* Shared with the children. */
struct children {
  pid_t parent;
  int died; /* a sanitizer ended a child */
  char report[16384];
  uint8_t counter[]; /* of coverage, the largest that children had */
};
static struct children *children;

/* Of the sanitizers and of libFuzzer, where the build has them. */
extern uint8_t __start___sancov_cntrs[] __attribute__((weak, visibility("hidden")));
extern uint8_t __stop___sancov_cntrs[] __attribute__((weak, visibility("hidden")));
void __sanitizer_set_death_callback(void (*callback)(void)) __attribute__((weak));
void __asan_set_error_report_callback(void (*callback)(const char *)) __attribute__((weak));

static size_t counters(void) { return (size_t)(__stop___sancov_cntrs - __start___sancov_cntrs); }

static void largest(uint8_t *to, const uint8_t *from)
{
  for (size_t i = 0; i < counters(); i++)
    if (from[i] > to[i]) to[i] = from[i];
}

/* In place of the system's, by which children end. */
void _exit(int code)
{
  if (children != NULL && getpid() != children->parent)
    largest(children->counter, __start___sancov_cntrs);
  for (;;) (void)syscall(SYS_exit_group, code);
}

static void reported(const char *text)
{
  snprintf(children->report, sizeof children->report, "%s", text);
}

static void died(void) { children->died = 1; }

/* In a child: an end is told to the parent, not written as libFuzzer's finding. */
static void child_begin(void)
{
  if (__sanitizer_set_death_callback != NULL) __sanitizer_set_death_callback(died);
  if (__asan_set_error_report_callback != NULL) __asan_set_error_report_callback(reported);
}

void um_fuzz_children_watch(void)
{
  if (children == NULL) {
    children = mmap(NULL, sizeof *children + counters(), PROT_READ | PROT_WRITE,
                    MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (children == MAP_FAILED || pthread_atfork(NULL, NULL, child_begin) != 0)
      um_fuzz_finding("no memory to share");
    children->parent = getpid();
  }
  children->died = 0;
  children->report[0] = '\0';
  memset(children->counter, 0, counters());
}

/* Does a stack of the report begin in a foreign library? Frames of the sanitizer come first. */
static bool begins_foreign(const char *stack)
{
  const char *foreign = strstr(stack, ".so"), *ours = strstr(stack, ".c:");
  return foreign != NULL && (ours == NULL || foreign < ours);
}

/* Foreign: what went wrong, and the memory it concerns, where the report has some. */
static bool is_foreign(const char *report)
{
  const char *allocated = strstr(report, "allocated by");
  return begins_foreign(report) && (allocated == NULL || begins_foreign(allocated));
}

void um_fuzz_children_judge(void)
{
  largest(__start___sancov_cntrs, children->counter);
  if (children->died && !is_foreign(children->report))
    um_fuzz_finding("in a child process: %s",
                    children->report[0] != '\0' ? children->report : "undefined behaviour");
}
