/* The whole of `umbra run scenarios/envisat-graz-2016`: wall clock against 60 s, peak memory
 * against 2 GiB, energy audit against the limit that the run prints.
 *
 * 60 s: somebody who has just built the program waits for the first picture. 2 GiB: a laptop or a
 * CI machine. The last figure holds the wall clock against what it would be if all processors
 * worked all the time; the rest is serial work and waiting. One run: it takes half a minute. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/bench/bench.h"

#define SCENARIO   "envisat-graz-2016"
#define TIME_LIMIT 60.0   /* [s] */
#define MEMORY     2048.0 /* [MiB] */
#define AUDIT      1e-6   /* [1] */

struct run {
  double wall, processor; /* [s] */
  double memory;          /* [MiB] */
  double audit;           /* [1] */
};

/* "energy audit ... error 1.6e-09 of the turnover" among the lines of the run [1]. */
static double audit_read(FILE *stream)
{
  char line[1024];
  double audit = NAN;
  while (fgets(line, sizeof line, stream) != NULL) {
    const char *error = strstr(line, "error ");
    if (strncmp(line, "energy audit", 12) == 0 && error != NULL)
      audit = strtod(error + strlen("error "), NULL);
  }
  return audit;
}

static void child(int to_parent, const char *out)
{
  dup2(to_parent, STDOUT_FILENO);
  close(to_parent);
  execl(UMBRA_PROGRAM, UMBRA_PROGRAM, "run", UMBRA_SOURCE_DIR "/scenarios/" SCENARIO, "--out", out,
        "--force", (char *)NULL);
  perror(UMBRA_PROGRAM);
  _exit(127);
}

static bool run_once(const char *out, struct run *run)
{
  int end[2], code = 0;
  struct rusage before, after;
  if (pipe(end) != 0 || getrusage(RUSAGE_CHILDREN, &before) != 0) return false;
  double began = bench_wall();
  fflush(NULL);
  pid_t pid = fork();
  if (pid < 0) return false;
  if (pid == 0) {
    close(end[0]);
    child(end[1], out);
  }
  close(end[1]);
  FILE *stream = fdopen(end[0], "r");
  run->audit = stream == NULL ? NAN : audit_read(stream);
  if (stream != NULL) fclose(stream);
  if (waitpid(pid, &code, 0) != pid || getrusage(RUSAGE_CHILDREN, &after) != 0) return false;
  run->wall = bench_wall() - began;
  run->processor = (double)(after.ru_utime.tv_sec - before.ru_utime.tv_sec) +
                   1e-6 * (double)(after.ru_utime.tv_usec - before.ru_utime.tv_usec) +
                   (double)(after.ru_stime.tv_sec - before.ru_stime.tv_sec) +
                   1e-6 * (double)(after.ru_stime.tv_usec - before.ru_stime.tv_usec);
  run->memory = (double)after.ru_maxrss / 1024.0; /* Linux counts kibibytes */
  return WIFEXITED(code) && WEXITSTATUS(code) == 0;
}

int main(int argc, char **argv)
{
  struct bench bench;
  bench_begin(&bench, argc, argv, "demo: umbra run scenarios/" SCENARIO);
  struct run run = {0};
  if (!run_once("out/bench/" SCENARIO, &run)) {
    fprintf(stderr, "bench: the run failed\n");
    return 1;
  }
  bench_number(&bench, "wall clock", "s", run.wall, TIME_LIMIT, 1.0);
  bench_number(&bench, "peak memory", "MiB", run.memory, MEMORY, 1.0);
  bench_number(&bench, "energy audit error", "1", run.audit, AUDIT, 1.0);
  bench_number(&bench, "processor time", "s", run.processor, NAN, NAN);
  bench_number(&bench, "wall clock over processor time shared by all", "s", run.wall,
               run.processor / bench.processors, NAN);
  return bench_end(&bench);
}
