/* What a diagnosis costs: processor time of `umbra diagnose` on ENVISAT's pass over that of `umbra
 * run` of the same, which is one forward run at the scenario's own tolerance and step. Measurements
 * are made from the scenario with a worse MLI, every 10 s with 1 % noise. Asked for: all candidates
 * and the verdict in the time of 10 runs; before that, 60 candidates in the time of 30. Both on one
 * thread, so that the work is compared, not how well it is shared. Memory is that of the largest
 * process of the diagnosis, beside that of the run.
 *
 * `--without heater` leaves thermostats out of the catalogue: more than half of the time goes to
 * those whose cycle may be seen, each a scan of runs and a fit. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/bench/bench.h"

#define SCENARIO UMBRA_SOURCE_DIR "/scenarios/envisat-graz-2016"
#define OUT      "out/bench/diagnosis"
#define RUNS     30.0 /* forward runs that 60 candidates may take */
#define ASKED    60.0
#define WHOLE    10.0   /* forward runs that all candidates and the verdict may take */
#define MEMORY   1536.0 /* of the largest process [MiB] */

static double children(void)
{
  struct rusage usage;
  if (getrusage(RUSAGE_CHILDREN, &usage) != 0) return NAN;
  return (double)(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * (double)(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

/* Processor time of the program with these arguments [s]; ends the benchmark when it fails. */
static double spend(char *const arguments[])
{
  int code = 0;
  double before = children();
  fflush(NULL);
  pid_t pid = fork();
  if (pid == 0) {
    if (freopen("/dev/null", "w", stdout) != NULL) execv(UMBRA_PROGRAM, arguments);
    perror(UMBRA_PROGRAM);
    _exit(127);
  }
  if (pid < 0 || waitpid(pid, &code, 0) != pid || !WIFEXITED(code) || WEXITSTATUS(code) != 0) {
    fprintf(stderr, "bench: umbra %s failed\n", arguments[1]);
    exit(1);
  }
  return children() - before;
}

/* Largest memory of a process so far [MiB]. */
static double memory(void)
{
  struct rusage usage;
  return getrusage(RUSAGE_CHILDREN, &usage) == 0 ? (double)usage.ru_maxrss / 1024.0 : (double)NAN;
}

/* The number under a key of diagnosis.json, `"candidates": ` 119. */
static double number(const char *key)
{
  char line[4096];
  double count = NAN;
  FILE *file = fopen(OUT "/diagnosis.json", "r");
  if (file == NULL) return NAN;
  while (fgets(line, sizeof line, file) != NULL) {
    const char *at = strstr(line, key);
    if (at != NULL) count = strtod(at + strlen(key), NULL);
  }
  fclose(file);
  return count;
}

/* An option and its value behind the others. */
static void put(char **arguments, char *option, char *value)
{
  while (*arguments != NULL) arguments++;
  arguments[0] = option;
  arguments[1] = value;
}

int main(int argc, char **argv)
{
  struct bench bench;
  char *const synth[] = {UMBRA_PROGRAM,
                         "synth",
                         SCENARIO,
                         "--noise",
                         "0.01",
                         "--seed",
                         "3",
                         "--set",
                         "time.step_s=10",
                         "--with",
                         "mli_emittance:bus,factor=1.5",
                         "--threads",
                         "1",
                         "-o",
                         OUT ".csv",
                         "--force",
                         NULL};
  char *const run[] = {UMBRA_PROGRAM, "run",      SCENARIO,  "--threads",  "1",
                       "--out",       OUT "-run", "--force", "--no-plots", NULL};
  char *diagnose[] = {UMBRA_PROGRAM, "diagnose", SCENARIO, OUT ".csv", "--threads",
                      "1",           "--out",    OUT,      "--force",  "--no-plots",
                      NULL,          NULL,       NULL};
  if (argc > 2 && strcmp(argv[argc - 2], "--without") == 0) {
    put(diagnose, "--exclude", argv[argc - 1]);
    argc -= 2;
  }
  bench_begin(&bench, argc, argv, "diagnosis: umbra diagnose on ENVISAT's pass");
  spend(synth);
  double one = spend(run), before = memory();
  double all = spend(diagnose), count = number("\"candidates\": ");
  bench_number(&bench, "one forward run", "s", one, NAN, NAN);
  bench_number(&bench, "candidates, effect x target", "1", count, NAN, NAN);
  bench_number(&bench, "a diagnosis over all of them, in 30 forward runs", "s", all, RUNS * one,
               1.0);
  bench_number(&bench, "a diagnosis over one forward run", "1", all / one, WHOLE, 1.0);
  bench_number(&bench, "memory of that run", "MiB", before, NAN, NAN);
  bench_number(&bench, "memory of its largest process", "MiB", memory(), MEMORY, 1.0);
  bench_number(&bench, "its share for 60 candidates, in 30 forward runs", "s", all * ASKED / count,
               RUNS * one, 1.0);
  bench_number(&bench, "heat integrations of variants", "1", number("\"heat_integrations\": "), NAN,
               NAN);
  bench_number(&bench, "forward sensitivities in place of more", "1",
               number("\"heat_sensitivities\": "), NAN, NAN);
  bench_number(&bench, "runs that gave them", "1", number("\"heat_batches\": "), NAN, NAN);
  return bench_end(&bench);
}
