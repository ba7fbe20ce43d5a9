/* How a run grows: with the parts of a body, and with the bins of its bands. Processor time of
 * `umbra run` on one thread, from reading to writing.
 *
 *   parts  boxes of 0.5 m, 1 m apart: in a plane, where each sees its neighbours, and in a cube,
 *          where each sees most of the others, so that pairs grow as parts^2; three materials,
 *          an orbit and a half. The exponent of the time between two numbers of parts against 1.
 *   bins   ENVISAT's pass without the orbit before it, 2 x 2000 bins against 2 x 1.
 *
 * Some four minutes. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/bench/bench.h"

#define SPACING 1.0 /* [m] */
#define OUT     "out/bench/scale"
#define ENVISAT UMBRA_SOURCE_DIR "/scenarios/envisat-graz-2016"

static const struct {
  bool cube;
  int few, many;
  double goal; /* exponent [1] */
} bodies[] = {{false, 100, 400, 1.3}, {false, 400, 1000, 1.3}, {true, 100, 300, 1.3}};
#define BODIES (sizeof bodies / sizeof *bodies)

/* Processor time of a run of the program [s]. */
static double run(char *const *arguments)
{
  struct rusage before, after;
  int code = 0;
  fflush(NULL);
  if (getrusage(RUSAGE_CHILDREN, &before) != 0) exit(1);
  pid_t pid = fork();
  if (pid == 0) {
    if (freopen("/dev/null", "w", stdout) != NULL && freopen("/dev/null", "w", stderr) != NULL)
      execv(UMBRA_PROGRAM, arguments);
    _exit(127);
  }
  if (pid < 0 || waitpid(pid, &code, 0) != pid || getrusage(RUSAGE_CHILDREN, &after) != 0 ||
      !WIFEXITED(code) || WEXITSTATUS(code) != 0) {
    fprintf(stderr, "bench: a run of " UMBRA_PROGRAM " failed\n");
    exit(1);
  }
  return (double)(after.ru_utime.tv_sec - before.ru_utime.tv_sec) +
         1e-6 * (double)(after.ru_utime.tv_usec - before.ru_utime.tv_usec) +
         (double)(after.ru_stime.tv_sec - before.ru_stime.tv_sec) +
         1e-6 * (double)(after.ru_stime.tv_usec - before.ru_stime.tv_usec);
}

static void body_write(FILE *file, bool cube, int n)
{
  static const char *const material[] = {"aluminium_anodised", "cell_silicon", "cfrp"};
  int side = 1;
  while ((cube ? side * side : side) * side < n) side++;
  fprintf(file, "schema: 1\nname: boxes\nsummary: Boxes.\n"
                "time: {start_utc: 2016-09-21T20:31:02Z, stop_utc: 2016-09-21T20:31:32Z, "
                "step_s: 10}\n"
                "orbit: {circular: {altitude_km: 700, beta_deg: 30}}\nattitude: [lvlh: {}]\n"
                "observer: {direction: {unit_gcrs: [0.5, 0.8660254, 0], range_km: 1000}}\n"
                "thermal: {orbits_before: 1, start: periodic}\nparts:\n");
  for (int i = 0; i < n; i++)
    fprintf(file,
            "  - {name: p%d, box: {size_m: [0.5, 0.5, 0.5]}, outside: %s,\n"
            "     pose: {position_m: [%g, %g, %g]},\n"
            "     shell: {areal_heat_capacity_J_m2_K: 4860, conductance_W_K: 0.33}}\n",
            i, material[i % 3], SPACING * (i % side - side / 2),
            SPACING * (i / side % side - side / 2),
            cube ? SPACING * (i / side / side - side / 2) : 0.0);
}

static double boxes(const char *folder, bool cube, int n)
{
  char path[BENCH_FOLDER + 16];
  snprintf(path, sizeof path, "%s/boxes.yaml", folder);
  FILE *file = fopen(path, "w");
  if (file == NULL) exit(1);
  body_write(file, cube, n);
  fclose(file);
  char *const arguments[] = {UMBRA_PROGRAM, "run",     path,    "--threads", "1",
                             "--no-plots",  "--force", "--out", OUT,         NULL};
  double seconds = run(arguments);
  unlink(path);
  return seconds;
}

static double bins(const char *vis, const char *lwir)
{
  char set[2][64];
  snprintf(set[0], sizeof set[0], "bands.vis.bins=%s", vis);
  snprintf(set[1], sizeof set[1], "bands.lwir.bins=%s", lwir);
  char *const arguments[] = {UMBRA_PROGRAM,
                             "run",
                             ENVISAT,
                             "--threads",
                             "1",
                             "--no-plots",
                             "--force",
                             "--out",
                             OUT,
                             "--set",
                             set[0],
                             "--set",
                             set[1],
                             "--set",
                             "thermal.start=isothermal",
                             "--set",
                             "thermal.orbits_before=0",
                             NULL};
  return run(arguments);
}

int main(int argc, char **argv)
{
  struct bench bench;
  char folder[BENCH_FOLDER], name[80];
  double last = NAN;
  bench_begin(&bench, argc, argv, "scale: how a run grows with parts and bins");
  bench_folder(folder);
  for (size_t b = 0; b < BODIES; b++) {
    const char *where = bodies[b].cube ? "a cube" : "a plane";
    bool known =
        b > 0 && bodies[b - 1].cube == bodies[b].cube && bodies[b - 1].many == bodies[b].few;
    double few = known ? last : boxes(folder, bodies[b].cube, bodies[b].few);
    last = boxes(folder, bodies[b].cube, bodies[b].many);
    snprintf(name, sizeof name, "%d boxes in %s", bodies[b].many, where);
    bench_number(&bench, name, "s", last, few, NAN);
    snprintf(name, sizeof name, "exponent, %d to %d boxes in %s", bodies[b].few, bodies[b].many,
             where);
    bench_number(&bench, name, "1", log(last / few) / log((double)bodies[b].many / bodies[b].few),
                 1.0, bodies[b].goal);
  }
  rmdir(folder);
  struct bench_series few = {.n = 0}, many = {.n = 0};
  for (int k = 0; k < 3; k++) {
    bench_add(&few, bins("1", "1"));
    bench_add(&many, bins("2000", "2000"));
  }
  bench_time(&bench, "2 x 2000 bins against 2 x 1", "s", &many, &few, 1.3);
  return bench_end(&bench);
}
