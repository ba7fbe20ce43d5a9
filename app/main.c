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
  int code = um_app_dispatch(context, argc, argv);
  um_app_terminal_clear();
  um_core_context_destroy(&context);
  return exit_code(flush(code));
}
