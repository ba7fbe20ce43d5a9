/* Names that are commands, in every place that the user names, through every verb: refused or
 * drawn, never run. A canary in a name would make a file of that name below the working folder, or
 * beside it. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/app/command.h"

#define CANARY "canary"

static const char *const hostile[] = {
    "n `touch " CANARY "` $(touch " CANARY ") \\",
    "x\"; system(\"touch " CANARY "; touch ../" CANARY "\"); o = \"y",
    "x'; system('touch " CANARY "'); o = 'y, z",
    "EOD\nsystem(\"touch " CANARY "\")\n!touch " CANARY "\n",
};

/* In double quotes of YAML or CSV; names that differ only in `mark` are two names. */
static void put_yaml(FILE *f, char mark, const char *text)
{
  fprintf(f, "\"%c ", mark);
  for (; *text != '\0'; text++) {
    if (*text == '\n')
      fputs("\\n", f);
    else
      fprintf(f, "%s%c", *text == '"' || *text == '\\' ? "\\" : "", *text);
  }
  fputc('"', f);
}

static void put_csv(FILE *f, char mark, const char *text)
{
  fprintf(f, "\"%c ", mark);
  for (; *text != '\0'; text++) fprintf(f, "%s%c", *text == '"' ? "\"" : "", *text);
  fputc('"', f);
}

/* The scenario, a group and a material among what is named; a box in sunlight. */
static void write_scenario(const char *name)
{
  FILE *f = fopen("s.yaml", "w");
  assert_non_null(f);
  fputs("schema: 1\nname: ", f);
  put_yaml(f, 'n', name);
  fputs("\ntime: {start_utc: 2016-03-20T04:30:00Z, stop_utc: 2016-03-20T04:31:00Z, step_s: 6}\n"
        "orbit: {circular: {altitude_km: 765, beta_deg: 0}}\n"
        "attitude:\n  - fixed: {q_gcrs: [1, 0, 0, 0]}\n"
        "observer: {direction: {unit_gcrs: [0.5, 0.8660254, 0], range_km: 1000}}\n"
        "thermal: {start: isothermal, orbits_before: 0.05, step_s: 30}\nparts:\n  - name: ",
        f);
  put_yaml(f, 'p', name);
  fputs("\n    box: {size_m: [1, 1, 1]}\n    outside: grey_white\n"
        "    shell: {areal_heat_capacity_J_m2_K: 3000}\n    lumped: true\nbands:\n  ",
        f);
  put_yaml(f, 'b', name);
  fputs(": {from_um: 0.38, to_um: 0.78, bins: 2}\n", f);
  fclose(f);
}

static void write_measurements(const char *name)
{
  FILE *f = fopen("m.csv", "w");
  assert_non_null(f);
  fputs("time_utc,quantity,of,value,sigma\n", f);
  for (int i = 0; i < 10; i++) {
    fprintf(f, "2016-03-20T04:30:%02dZ,radiant_intensity,", 6 * i);
    put_csv(f, 'b', name);
    fprintf(f, ",%d,1\n", 30 + i % 3);
    fprintf(f, "2016-03-20T04:30:%02dZ,temperature,", 6 * i);
    put_csv(f, 'p', name);
    fprintf(f, ",%d,1\n", 280 + i % 3);
  }
  fclose(f);
}

/* A set for umbra period, and the raw track of a survey, whose names cannot hold blanks. */
static void write_curve(const char *name)
{
  FILE *f = fopen("curve.csv", "w"), *track = fopen("track.txt", "w");
  assert_non_null(f);
  assert_non_null(track);
  fputs("time_utc,quantity,of,value,sigma\n", f);
  fputs("# track: 1\n# Date Time Mag Filter\n", track);
  for (int i = 0; i < 50; i++) {
    fprintf(f, "2016-09-21T20:30:%02dZ,magnitude_ab,", i);
    put_csv(f, 'c', name);
    fprintf(f, ",%d.5,0.1\n", 5 + i % 4);
    fprintf(track, "2016-09-21 20:30:%02d %d.5 V", i, 5 + i % 4);
    for (const char *c = name; *c != '\0' && *c != '\n'; c++)
      fputs((char[]){*c == ' ' ? '\0' : *c, '\0'}, track);
    fputs("\";system(\"touch${IFS}" CANARY "\");o=\"`touch${IFS}" CANARY "`\n", track);
  }
  fclose(f);
  fclose(track);
}

/* Drawn (0) or refused (1); never run. picture: what there is where it was drawn, or NULL. A table
 * whose fields hold ends of lines is one that gnuplot cannot read: a warning stands for the
 * picture. Whether it was not refused. */
static bool attempt(const char *name, const char *picture, const char *const *arguments)
{
  struct command c = command_run_list(arguments);
  if (c.code != 0 && c.code != 1)
    fail_msg("%s: exit %d of %s: %s", arguments[0], c.code, name, c.err);
  if (c.code == 1 && c.err[0] == '\0')
    fail_msg("%s: refused without a word: %s", arguments[0], name);
  bool drawn = c.code == 0;
  command_release(&c);
  char *all = command_snapshot(".");
  if (command_exists(CANARY) || command_exists("../" CANARY) || command_exists("out/" CANARY) ||
      strstr(all, "/" CANARY "\n") != NULL)
    fail_msg("%s ran a command: %s", arguments[0], name);
  free(all);
  bool torn = strchr(name, '\n') != NULL;
  if (!torn && command_exists("out/gnuplot.log"))
    fail_msg("%s: gnuplot stopped at %s", arguments[0], name);
  if (drawn && picture != NULL && !command_exists(picture))
    fail_msg("%s: no %s of %s", arguments[0], picture, name);
  return drawn;
}

#define TRY(name, picture, ...) attempt(name, picture, (const char *const[]){__VA_ARGS__, NULL})
#define OUT                     "--out", "out", "--force"

static void test_verbs(void **state)
{
  (void)state;
  for (size_t i = 0; i < sizeof hostile / sizeof hostile[0]; i++) {
    const char *name = hostile[i];
    write_scenario(name);
    write_measurements(name);
    write_curve(name);
    TRY(name, NULL, "check", "s.yaml");
    TRY(name, "out/lightcurve.png", "run", "s.yaml", OUT);
    TRY(name, "out/plots.gp", "compare", "s.yaml", "m.csv", OUT);
    TRY(name, "out/plots.gp", "fit", "s.yaml", "m.csv", "--add", "albedo_level", OUT);
    TRY(name, "out/plots.gp", "diagnose", "s.yaml", "m.csv", "--only", "albedo_level", "--only",
        "emittance", OUT);
    char band[256];
    snprintf(band, sizeof band, "b %s", name);
    TRY(name, "image.exr", "render", "s.yaml", "--time", "2016-03-20T04:30:00Z", "--band", band,
        "--width", "16", "--samples", "1", "-o", "image.exr", "--force");
    TRY(name, "out/period.gp", "period", "curve.csv", OUT);
    if (TRY(name, "curve.csv", "import", "track.txt", "-o", "curve.csv", "--force", "--noise",
            "0.1"))
      TRY(name, "out/period.gp", "period", "curve.csv", OUT);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_verbs, command_enter, command_leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
