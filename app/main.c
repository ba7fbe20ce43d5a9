/* umbra: the command. Each verb is a file of its own. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "app/app.h"
#include "app/terminal.h"

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
                                   .neffect_file = options->neffect_file,
                                   .allow_effects = options->allow_effects};
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
      if (code == UM_APP_MISUSE) {
        fputs("usage: ", stderr);
        um_app_usage(stderr, verb);
        fputc('\n', stderr);
      }
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
  return code == UM_APP_MISUSE ? code : UM_APP_FAILED;
}

/* Work that a signal ended says so, as a shell does. */
static int exit_code(int code)
{
  int signal_number = um_app_terminal_signal();
  return code == UM_APP_FAILED && signal_number != 0 ? UM_APP_SIGNAL + signal_number : code;
}

/* The command line under the verb's name of now; a new one is freed at exit. */
static bool rename_verb(int *argc, char ***argv)
{
  static char **renamed;
  struct um_app_old_name *old = um_app_old_name_find((*argv)[1], *argc - 2, *argv + 2);
  if (old == NULL) return true;
  renamed = um_app_old_name_translate(old, argc, *argv);
  if (renamed == NULL) return false;
  *argv = renamed;
  return true;
}

int main(int argc, char **argv)
{
  um_app_terminal_open_standard();
  if (argc < 2) {
    um_app_help(stderr);
    return UM_APP_MISUSE;
  }
  if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0) {
    um_app_help(stdout);
    return flush(UM_APP_DONE);
  }
  if (strcmp(argv[1], "--version") == 0) {
    printf("umbra %s\n", umbra_version());
    return flush(UM_APP_DONE);
  }
  if (!rename_verb(&argc, &argv)) {
    fputs("umbra: out of memory\n", stderr);
    return UM_APP_FAILED;
  }
  const struct um_app_verb *verb = um_app_verb_find(argv[1]);
  if (verb == NULL) {
    char unknown[UM_APP_UNKNOWN];
    um_app_verb_unknown(argv[1], unknown);
    return um_app_misuse(NULL, "%s", unknown);
  }
  struct um_context *context = NULL;
  if (um_core_context_create(NULL, &context) != UM_OK) {
    fputs("umbra: out of memory\n", stderr);
    return UM_APP_FAILED;
  }
  if (um_core_context_set_cache(context, getenv("UMBRA_CACHE")) != UM_OK) {
    um_core_context_destroy(&context);
    fputs("umbra: out of memory\n", stderr);
    return UM_APP_FAILED;
  }
  um_app_terminal_attach(context);
  int code = dispatch(context, verb, argc, argv);
  um_app_terminal_clear();
  um_core_context_destroy(&context);
  return exit_code(flush(code));
}
