/* umbra: the command. Options are parsed once; each verb is a file of its own. */
#include <errno.h>
#include <getopt.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "app/app.h"
#include "app/terminal.h"
#include "core/csv.h"

static const struct um_app_verb verbs[] = {
    {"run",
     "umbra run SCENARIO [--out DIR] [--set KEY=VALUE]... [--with EFFECT]... [--without EFFECT]..."
     " [--effect-file FILE]... [--force] [--no-plots] [--json]",
     "light curves and temperatures of a scenario", 1, 1,
     "out set with without effect-file force no-plots json", um_app_run},
    {"check",
     "umbra check SCENARIO [--set KEY=VALUE]... [--with EFFECT]... [--without EFFECT]..."
     " [--effect-file FILE]... [--json]",
     "read a scenario and report what was understood", 1, 1, "set with without effect-file json",
     um_app_check},
    {"passes", "umbra passes SCENARIO [--set KEY=VALUE]... [--json]",
     "when the satellite rises over the station, and what is sunlit", 1, 1, "set json",
     um_app_passes},
    {"render",
     "umbra render SCENARIO --time UTC --band B -o image.exr [--width N] [--samples N] [--force]",
     "one picture, every wavelength, as OpenEXR", 1, 1,
     "out set with without effect-file time band width samples force", um_app_render},
    {"compare",
     "umbra compare SCENARIO MEASURED [--out DIR] [--set KEY=VALUE]... [--with EFFECT]..."
     " [--without EFFECT]... [--effect-file FILE]... [--force] [--no-plots] [--json]",
     "a scenario beside measurements: how far off, when, and what the residual goes with", 2, 2,
     "out set with without effect-file force no-plots json", um_app_compare},
    {"synth",
     "umbra synth SCENARIO --noise REL[,FLOOR] --seed N -o measured.csv [--temperatures PLACE,...]"
     " [--temperature-sigma K] [--set KEY=VALUE]... [--with EFFECT]... [--without EFFECT]..."
     " [--effect-file FILE]... [--force]",
     "measurements made from a scenario, with noise", 1, 1,
     "out set with without effect-file noise seed temperatures temperature-sigma force",
     um_app_synth},
    {"period", "umbra period MEASURED [--band B] [--out DIR] [--force] [--no-plots] [--json]",
     "the period of measured light curves by Lomb-Scargle, and the curves folded at it", 1, 1,
     "out band force no-plots json", um_app_period},
    {"import", "umbra import TRACK.txt -o measured.csv [--noise REL[,FLOOR]] [--force]",
     "tracks of Mini-MegaTORTORA as a measurement file; noise of the flux, floor in magnitudes", 1,
     1, "out noise force", um_app_import},
    {"materials", "umbra materials [NAME] [--json]", "materials with their integrated properties",
     0, 1, "json", um_app_materials},
    {"effects", "umbra effects [NAME] [--effect-file FILE]... [--json]",
     "physical effects and their parameters", 0, 1, "effect-file json", um_app_effects},
    {"schema", "umbra schema [--json]", "reference of scenario.yaml, or its JSON Schema", 0, 0,
     "json", um_app_schema},
    {"validate", "umbra validate [--thermal] [--optics] [--json]",
     "analytic and published cases, expected and computed", 0, 0, "thermal optics json",
     um_app_validate},
};
#define NVERB (sizeof verbs / sizeof verbs[0])

int um_app_fail(struct um_context *context)
{
  um_app_terminal_clear();
  fprintf(stderr, "umbra: %s\n", um_core_message(context));
  return UM_APP_FAILED;
}

struct um_model_options um_app_model_options(const struct um_app_options *options)
{
  return (struct um_model_options){.overrides = options->set,
                                   .noverride = options->nset,
                                   .with = options->with,
                                   .nwith = options->nwith,
                                   .without = options->without,
                                   .nwithout = options->nwithout,
                                   .effect_files = options->effect_file,
                                   .neffect_file = options->neffect_file};
}

static void print_help(FILE *file)
{
  fputs("umbra " UM_APP_VERSION
        ": light curves of satellites in the visible and the thermal infrared\n\n",
        file);
  for (size_t i = 0; i < NVERB; i++)
    fprintf(file, "  %s\n      %s\n", verbs[i].usage, verbs[i].summary);
  fputs("\n  --threads N   worker threads; results do not depend on it\n"
        "  --version, --help\n",
        file);
}

static int misuse(const struct um_app_verb *verb, const char *format, const char *what)
{
  fputs("umbra: ", stderr);
  fprintf(stderr, format, what); /* NOLINT: formats are literals of this file */
  fputc('\n', stderr);
  if (verb != NULL)
    fprintf(stderr, "usage: %s\n", verb->usage);
  else
    fputs("umbra --help lists the commands\n", stderr);
  return UM_APP_MISUSE;
}

enum option_id {
  OUT = 256,
  SET,
  WITH,
  WITHOUT,
  EFFECT_FILE,
  TIME,
  BAND,
  WIDTH,
  SAMPLES,
  NOISE,
  SEED,
  TEMPERATURES,
  TEMPERATURE_SIGMA,
  FORCE,
  JSON,
  THERMAL,
  OPTICS,
  NO_PLOTS,
  THREADS,
  HELP
};
static const struct option long_options[] = {
    {"out", required_argument, NULL, OUT},
    {"set", required_argument, NULL, SET},
    {"with", required_argument, NULL, WITH},
    {"without", required_argument, NULL, WITHOUT},
    {"effect-file", required_argument, NULL, EFFECT_FILE},
    {"time", required_argument, NULL, TIME},
    {"band", required_argument, NULL, BAND},
    {"width", required_argument, NULL, WIDTH},
    {"samples", required_argument, NULL, SAMPLES},
    {"noise", required_argument, NULL, NOISE},
    {"seed", required_argument, NULL, SEED},
    {"temperatures", required_argument, NULL, TEMPERATURES},
    {"temperature-sigma", required_argument, NULL, TEMPERATURE_SIGMA},
    {"force", no_argument, NULL, FORCE},
    {"json", no_argument, NULL, JSON},
    {"thermal", no_argument, NULL, THERMAL},
    {"optics", no_argument, NULL, OPTICS},
    {"no-plots", no_argument, NULL, NO_PLOTS},
    {"threads", required_argument, NULL, THREADS},
    {"help", no_argument, NULL, HELP},
    {NULL, 0, NULL, 0}};

static bool accepted(const struct um_app_verb *verb, const char *name)
{
  size_t n = strlen(name);
  for (const char *at = verb->accepts; (at = strstr(at, name)) != NULL; at += n)
    if ((at == verb->accepts || at[-1] == ' ') && (at[n] == ' ' || at[n] == '\0')) return true;
  return strcmp(name, "threads") == 0 || strcmp(name, "help") == 0;
}

static bool positive_integer(const char *text, int limit, int *out)
{
  double value;
  if (!um_core_number_parse(text, &value) || !(value >= 1.0 && value <= limit) ||
      value != (double)(int)value)
    return false;
  *out = (int)value;
  return true;
}

/* One option into the struct; false when its value is refused. */
static bool take(struct um_context *context, struct um_app_options *o, int id, const char *value)
{
  int threads = 0;
  switch (id) {
  case OUT:
    o->out = value;
    return true;
  case SET:
    o->set[o->nset++] = value;
    return strchr(value, '=') != NULL;
  case WITH:
    o->with[o->nwith++] = value;
    return true;
  case WITHOUT:
    o->without[o->nwithout++] = value;
    return true;
  case EFFECT_FILE:
    o->effect_file[o->neffect_file++] = value;
    return true;
  case TIME:
    o->time_utc = value;
    return true;
  case BAND:
    o->band = value;
    return true;
  case WIDTH:
    return positive_integer(value, 8192, &o->width);
  case SAMPLES:
    return positive_integer(value, 65536, &o->samples);
  case NOISE:
    o->noise = value;
    return true;
  case SEED:
    o->seed = value;
    return true;
  case TEMPERATURES:
    o->temperatures = value;
    return true;
  case TEMPERATURE_SIGMA:
    o->temperature_sigma = value;
    return true;
  case FORCE:
    o->force = true;
    return true;
  case JSON:
    o->json = true;
    return true;
  case THERMAL:
    o->thermal = true;
    return true;
  case OPTICS:
    o->optics = true;
    return true;
  case NO_PLOTS:
    o->no_plots = true;
    return true;
  case THREADS:
    if (!positive_integer(value, 4096, &threads)) return false;
    um_core_context_set_threads(context, threads);
    return true;
  default:
    return true;
  }
}

/* The next option, -1 for a positional argument at optind; behind "--" there are only those. */
static int next_option(int argc, char **argv, bool *literal, int *index)
{
  if (!*literal && optind < argc && strcmp(argv[optind], "--") == 0) {
    *literal = true;
    optind++;
  }
  return *literal ? -1 : getopt_long(argc, argv, "+o:h", long_options, index);
}

/* The positional argument of that number, as the usage line calls it: behind "umbra verb ". */
static int missing(const struct um_app_verb *verb, int number)
{
  char name[64];
  const char *at = verb->usage + strlen("umbra ") + strlen(verb->name) + 1;
  for (int i = 0; i < number; i++) at += strcspn(at, " ") + 1;
  snprintf(name, sizeof name, "%.*s", (int)strcspn(at, " "), at);
  return misuse(verb, "%s is missing", name);
}

static int parse(struct um_context *context, const struct um_app_verb *verb, int argc, char **argv,
                 struct um_app_options *o)
{
  int id, index = 0;
  bool literal = false;
  opterr = 0;
  optind = 2;
  while ((id = next_option(argc, argv, &literal, &index)) != -1 || optind < argc) {
    if (id == -1) { /* options may follow it */
      if (o->npositional == verb->npositional_max)
        return misuse(verb, "too many arguments: '%s'", argv[optind]);
      o->positional[o->npositional++] = argv[optind++];
      continue;
    }
    if (id == '?') return misuse(verb, "unknown option or missing value: '%s'", argv[optind - 1]);
    const char *name = id == 'o' ? "out" : id == 'h' ? "help" : long_options[index].name;
    if (id == 'h' || id == HELP) {
      printf("%s\n  %s\n", verb->usage, verb->summary);
      return -1;
    }
    if (!accepted(verb, name)) return misuse(verb, "this command does not take --%s", name);
    if (!take(context, o, id == 'o' ? OUT : id, optarg))
      return misuse(verb, "value of an option not understood: '%s'", optarg);
  }
  if (o->npositional < verb->npositional_min) return missing(verb, o->npositional);
  return UM_APP_DONE;
}

static char *join(int argc, char **argv)
{
  size_t n = 16;
  for (int i = 1; i < argc; i++) n += strlen(argv[i]) + 1;
  char *text = calloc(n, 1);
  if (text == NULL) return NULL;
  strcpy(text, "umbra");
  for (int i = 1; i < argc; i++) {
    strcat(text, " ");
    strcat(text, argv[i]);
  }
  return text;
}

static int dispatch(struct um_context *context, const struct um_app_verb *verb, int argc,
                    char **argv)
{
  struct um_app_options o = {0};
  o.set = calloc((size_t)argc * 4, sizeof *o.set);
  o.command = join(argc, argv);
  int code = UM_APP_FAILED;
  if (o.set == NULL || o.command == NULL) {
    fputs("umbra: out of memory\n", stderr);
  } else {
    o.with = o.set + argc;
    o.without = o.with + argc;
    o.effect_file = o.without + argc;
    code = parse(context, verb, argc, argv, &o);
    if (code == UM_APP_DONE) {
      code = verb->run(context, &o);
      if (code == UM_APP_MISUSE) fprintf(stderr, "usage: %s\n", verb->usage);
    }
    if (code == -1) code = UM_APP_DONE;
  }
  free(o.command);
  free((void *)o.set);
  return code;
}

/* What was printed has arrived, else the command has failed. */
static int flush(int code)
{
  if (fflush(stdout) == 0 && ferror(stdout) == 0) return code;
  fprintf(stderr, "umbra: standard output: %s\n", strerror(errno));
  return code == UM_APP_DONE ? UM_APP_FAILED : code;
}

int main(int argc, char **argv)
{
  if (argc < 2) {
    print_help(stderr);
    return UM_APP_MISUSE;
  }
  if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0 ||
      strcmp(argv[1], "help") == 0) {
    print_help(stdout);
    return flush(UM_APP_DONE);
  }
  if (strcmp(argv[1], "--version") == 0) {
    puts("umbra " UM_APP_VERSION);
    return flush(UM_APP_DONE);
  }
  for (size_t i = 0; i < NVERB; i++) {
    if (strcmp(argv[1], verbs[i].name) != 0) continue;
    struct um_context *context = NULL;
    if (um_core_context_create(NULL, &context) != UM_OK) {
      fputs("umbra: out of memory\n", stderr);
      return UM_APP_FAILED;
    }
    um_app_terminal_attach(context);
    int code = dispatch(context, &verbs[i], argc, argv);
    um_app_terminal_clear();
    um_core_context_destroy(&context);
    return flush(code);
  }
  return misuse(NULL, "unknown command '%s'", argv[1]);
}
