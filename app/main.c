/* umbra: the command. Each verb is a file of its own. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "app/app.h"
#include "app/terminal.h"

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
    {"diagnose",
     "umbra diagnose SCENARIO MEASURED [--out DIR] [--set KEY=VALUE]... [--with EFFECT]..."
     " [--without EFFECT]... [--effect-file FILE]... [--only EFFECT[:TARGET]]..."
     " [--exclude EFFECT[:TARGET]]... [--nuisance EFFECT[:TARGET][,sigma=S]]... [--level P]"
     " [--steps N] [--force] [--no-plots] [--json]",
     "which physical effect the scenario lacks, or that the measurements cannot tell", 2, 2,
     "out set with without effect-file only exclude nuisance level steps force no-plots json",
     um_app_diagnose},
    {"fit",
     "umbra fit SCENARIO MEASURED --add EFFECT[:TARGET][,NAME=START]... [--out DIR]"
     " [--set KEY=VALUE]... [--with EFFECT]... [--without EFFECT]... [--effect-file FILE]..."
     " [--nuisance EFFECT[:TARGET][,sigma=S]]... [--force] [--no-plots] [--json]",
     "parameters of chosen effects, fitted to measurements", 2, 2,
     "out set with without effect-file add nuisance force no-plots json", um_app_fit},
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
  struct um_app_options o = {.command = join(argc, argv)};
  int code = UM_APP_FAILED;
  if (o.command == NULL || !um_app_options_allocate(&o, argc)) {
    fputs("umbra: out of memory\n", stderr);
  } else {
    code = um_app_options_parse(context, verb, argc, argv, &o);
    if (code == UM_APP_DONE) {
      code = verb->run(context, &o);
      if (code == UM_APP_MISUSE) fprintf(stderr, "usage: %s\n", verb->usage);
    }
    if (code == -1) code = UM_APP_DONE;
  }
  um_app_options_release(&o);
  free(o.command);
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
  return um_app_misuse(NULL, "unknown command '%s'", argv[1]);
}
