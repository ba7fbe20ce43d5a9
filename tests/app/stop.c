/* SIGTERM and SIGINT are heard within two seconds wherever the program works long. Seconds of
 * processor time count, so that other work of the machine fails no test; and ten times as many of
 * the wall clock, in which a program that waits is found. Each stage has an input that keeps it
 * busy for minutes. The signal is sent after longer and longer times until the stage itself says
 * that it was cancelled, and whatever it meets before that must end as soon.
 */
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/app/command.h"

#define HEARD    2.0  /* [s] */
#define FIRST    0.25 /* after which the first signal is sent [s] */
#define ATTEMPTS 9    /* each with twice the time of the one before */

#define HEAD                                                                                       \
  "schema: 1\nname: h\norbit: {circular: {altitude_km: 765, beta_deg: 0}}\n"                       \
  "attitude:\n  - fixed: {q_gcrs: [1, 0, 0, 0]}\n"                                                 \
  "observer: {direction: {unit_gcrs: [0.48, 0.6, 0.64], range_km: 1000}}\n"                        \
  "bands: {vis: {from_um: 0.38, to_um: 0.78, bins: 4}}\n"
#define MINUTE                                                                                     \
  "time: {start_utc: 2016-03-20T04:30:00Z, stop_utc: 2016-03-20T04:31:00Z, step_s: 10}\n"
#define SECONDS                                                                                    \
  "time: {start_utc: 2016-03-20T04:30:00Z, stop_utc: 2016-03-20T04:31:00Z, step_s: 0.2}\n"
#define WALL "    shell: {areal_heat_capacity_J_m2_K: 1000, conductance_W_K: 1}\n"
#define BOX  "parts:\n  - name: b\n    box: {size_m: [1, 1, 1]}\n    outside: grey_white\n" WALL
/* a plate that hides much of the box from the observer, so that rays are traced */
#define PLATE                                                                                      \
  "  - name: p\n    plate: {size_m: [1, 1]}\n    front: grey_white\n    back: grey_white\n"        \
  "    pose: {position_m: [0, 0, 1]}\n" WALL
#define SMALL "    facet_size_m: 0.01\n"
#define START "thermal: {start: isothermal, orbits_before: 0.01, step_s: 30}\n"

struct stage {
  const char *name, *scenario; /* text of s.yaml, NULL: not written */
  const char *said;            /* when the stage itself was cancelled; NULL: it cannot say so */
  const char *arguments[16];
  int signal;
  void (*prepare)(void);
  double only; /* the one moment at which it is sent [s]; 0: later and later ones */
};

static int enter(void **state)
{
  void *unused = NULL;
  (void)state;
  return command_enter(&unused);
}

static void expect_stop(const struct stage *s, const struct command *c)
{
  if (c->code != 128 + s->signal)
    fail_msg("%s: exit %d, expected %d; it said:\n%s%s", s->name, c->code, 128 + s->signal, c->out,
             c->err);
  if (!(c->worked <= HEARD && c->seconds <= 10.0 * HEARD))
    fail_msg("%s: ended %.2f s after the signal, having worked for %.2f s", s->name, c->seconds,
             c->worked);
  if (command_exists("out")) fail_msg("%s: there are results", s->name);
}

static void check_stage(void **state)
{
  const struct stage *s = *state;
  bool reached = false;
  char last[256] = "";
  double after = s->only > 0.0 ? s->only : FIRST;
  if (s->scenario != NULL) command_write("s.yaml", s->scenario);
  if (s->prepare != NULL) s->prepare();
  for (int i = 0; i < ATTEMPTS && !reached; i++, after *= 2.0) {
    struct command c = command_run_for(after, s->signal, s->arguments);
    expect_stop(s, &c);
    reached = s->only > 0.0 ? true : s->said == NULL ? i == 3 : strstr(c.err, s->said) != NULL;
    if (reached) printf("%s: heard after %.2f s\n", s->name, c.seconds);
    snprintf(last, sizeof last, "%.200s", c.err);
    command_release(&c);
  }
  if (!reached)
    fail_msg("%s: the stage was not reached within %.0f s, last it said: %s", s->name, after / 2.0,
             last);
}

/* A mapping of as many keys as a file may hold. */
static void many_keys(void)
{
  FILE *file = fopen("s.yaml", "w");
  assert_non_null(file);
  fputs("schema: 1\n", file);
  for (int i = 0; i < 180000; i++) fprintf(file, "k%d: 1\n", i);
  assert_int_equal(fclose(file), 0);
}

/* A gnuplot that never ends, before the one of the system. */
static void slow_gnuplot(void)
{
  char path[8192], here[4096];
  assert_non_null(getcwd(here, sizeof here));
  assert_int_equal(mkdir("bin", 0777), 0);
  command_write("bin/gnuplot", "#!/bin/sh\nexec sleep 1000\n");
  assert_int_equal(chmod("bin/gnuplot", 0755), 0);
  const char *before = getenv("PATH");
  if (strncmp(before, here, strlen(here)) == 0) return;
  snprintf(path, sizeof path, "%s/bin:%s", here, before);
  assert_int_equal(setenv("PATH", path, 1), 0);
}

/* 40000 rows over years: as many frequencies as are accepted. */
static void long_series(void)
{
  FILE *file = fopen("m.csv", "w");
  assert_non_null(file);
  fputs("time_utc,quantity,of,value,sigma\n", file);
  for (int i = 0; i < 40000; i++)
    fprintf(file, "2016-09-%02dT%02d:%02d:%02dZ,magnitude_ab,vis,%.4f,0.01\n", 1 + i / 8640,
            i / 360 % 24, i / 6 % 60, i % 6 * 10, 5.0 + sin(0.37 * i));
  assert_int_equal(fclose(file), 0);
}

/* Temperatures of a box of many nodes: every candidate costs a run. */
static void box_measured(void)
{
  FILE *file = fopen("m.csv", "w");
  assert_non_null(file);
  fputs("time_utc,quantity,of,value,sigma\n", file);
  for (int i = 0; i < 6; i++)
    fprintf(file, "2016-03-20T04:30:%02dZ,temperature,b,%d,0.5\n", i * 10, 280 + 3 * i);
  assert_int_equal(fclose(file), 0);
}

#define RUN "run", "s.yaml", "--no-plots", "--out", "out", "--threads", "1"

static const struct stage stages[] = {
    {"event search",
     HEAD BOX "time: {start_utc: 2016-03-20T04:30:00Z, stop_utc: 2099-03-20T04:31:00Z, step_s: "
              "1e7}\nthermal: {start: isothermal, orbits_before: 0, step_s: 10000}\n",
     "eclipses were looked for",
     {RUN},
     SIGTERM,
     NULL,
     0.0},
#ifdef UMBRA_TETGEN
    {"TetGen",
     HEAD MINUTE "parts:\n  - name: b\n    box: {size_m: [1, 1, 1]}\n    facet_size_m: 0.03\n"
                 "    outside: grey_white\n    solid: {density_kg_m3: 2700, specific_heat_J_kg_K: "
                 "900, conductivity_W_m_K: "
                 "150, tetrahedron_size_m: 0.01}\n" START,
     "TetGen worked",
     {RUN},
     SIGTERM,
     NULL,
     0.0},
#endif
    {"gnuplot",
     HEAD MINUTE BOX START,
     "gnuplot worked",
     {"run", "s.yaml", "--out", "out"},
     SIGINT,
     slow_gnuplot,
     0.0},
    {"YAML", NULL, NULL, {RUN}, SIGTERM, many_keys, 0.1},
    {"contacts between parts of many facets",
     HEAD MINUTE BOX SMALL PLATE SMALL START "contacts: [{a: b, b: p, conductance_W_K: 1}]\n",
     "contacts were joined",
     {RUN},
     SIGTERM,
     NULL,
     0.0},
    {"loads of many instants",
     HEAD MINUTE BOX "    facet_size_m: 0.1\n" PLATE
                     "thermal: {start: isothermal, orbits_before: 20, samples: 4096}\n",
     "loads",
     {RUN},
     SIGINT,
     NULL,
     0.0},
    {"heat of a fine mesh",
     HEAD MINUTE BOX "    facet_size_m: 0.1\nthermal: {start: periodic, orbits_before: 20, "
                     "relative_tolerance: 1e-12, absolute_tolerance_K: 1e-9}\n",
     "heat was integrated",
     {RUN},
     SIGTERM,
     NULL,
     0.0},
    {"lines of sight",
     HEAD SECONDS BOX "    facet_size_m: 0.05\n    lumped: true\n" PLATE START
                      "optics: {samples: 65536}\n",
     "lines of sight",
     {RUN},
     SIGTERM,
     NULL,
     0.0},
    {"picture",
     HEAD MINUTE BOX PLATE START,
     "a picture was rendered",
     {"render", "s.yaml", "--time", "2016-03-20T04:30:10Z", "--band", "vis", "-o", "out", "--width",
      "8000", "--samples", "4000"},
     SIGINT,
     NULL,
     0.0},
    {"period search",
     NULL,
     "periods were searched",
     {"period", "m.csv", "--out", "out", "--no-plots", "--threads", "1"},
     SIGTERM,
     long_series,
     0.0},
    {"diagnosis",
     HEAD MINUTE BOX "    facet_size_m: 0.06\nthermal: {start: periodic, orbits_before: 1}\n",
     NULL,
     {"diagnose", "s.yaml", "m.csv", "--out", "out", "--no-plots", "--threads", "1"},
     SIGTERM,
     box_measured,
     0.0},
    {"passes of decades",
     "schema: 1\nname: h\n"
     "time: {start_utc: 2016-03-20T04:30:00Z, stop_utc: 2024-03-20T04:31:00Z, step_s: 1e5}\n"
     "orbit: {circular: {altitude_km: 765, beta_deg: 0}}\n"
     "attitude:\n  - fixed: {q_gcrs: [1, 0, 0, 0]}\n"
     "observer: {station: {name: Graz, latitude_deg: 47, longitude_deg: 15, height_m: 0}}\n" BOX,
     "passes were looked for",
     {"forecast", "s.yaml", "--times"},
     SIGTERM,
     NULL,
     0.0},
};
#define NSTAGE (sizeof stages / sizeof stages[0])

int main(void)
{
  struct CMUnitTest tests[NSTAGE];
  for (size_t i = 0; i < NSTAGE; i++)
    tests[i] = (struct CMUnitTest){stages[i].name, check_stage, enter, command_leave,
                                   (void *)(size_t)&stages[i]};
  return _cmocka_run_group_tests("stop", tests, NSTAGE, NULL, NULL);
}
