/* From a command line to its verb, and the record of what was run. */
#include <stdlib.h>
#include <string.h>

#include "app/app.h"
#include "app/target.h"
#include "base/core/file.h"
#include "base/core/replay.h"
#include "base/core/text.h"

/* The command as it can be typed again; NULL: no memory. */
static char *join(int argc, char **argv)
{
  char *text = NULL;
  size_t n;
  FILE *file = open_memstream(&text, &n);
  if (file == NULL) return NULL;
  fputs("umbra", file);
  for (int i = 1; i < argc; i++) {
    fputc(' ', file);
    um_core_text_put_word(file, argv[i]);
  }
  if (fclose(file) == 0) return text;
  free(text);
  return NULL;
}

static enum um_status write_record(struct um_context *context, const char *path)
{
  struct um_core_whole_file whole;
  UM_TRY(um_core_whole_begin(context, path, &whole));
  um_core_replay_write(context, whole.file);
  return um_core_whole_end(context, &whole, UM_OK);
}

/* The verb at work, its inputs on record; --replay writes the record where there are results. */
static int run(struct um_context *context, const struct um_app_verb *verb,
               const struct um_app_options *o, int argc, char **argv)
{
  enum um_status status;
  if (!verb->unrecorded) {
    UM_CHECK(um_core_replay_begin(context, UM_APP_VERSION, o->command, argv + 1, (size_t)argc - 1));
    if (o->replay != NULL)
      UM_CHECK(um_app_check_whole(context, o->replay, o->force, UM_APP_RECORDS));
  }
  int code = verb->run(context, o);
  if ((code == UM_APP_DONE || code == UM_APP_EXCEEDED) && o->replay != NULL)
    UM_CHECK(write_record(context, o->replay));
  um_core_replay_end(context);
  return code;
done:
  um_core_replay_end(context);
  return um_app_fail(context);
}

static int parse_and_run(struct um_context *context, const struct um_app_verb *verb, int argc,
                         char **argv)
{
  struct um_app_options o = {.command = join(argc, argv)};
  int code = UM_APP_FAILED;
  if (o.command == NULL || !um_app_options_allocate(&o, argc)) {
    fputs("umbra: out of memory\n", stderr);
  } else {
    code = um_app_options_parse(context, verb, argc, argv, &o);
    if (code == UM_APP_DONE) {
      code = run(context, verb, &o, argc, argv);
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

int um_app_dispatch(struct um_context *context, int argc, char **argv)
{
  struct um_app_old_name *old = um_app_old_name_find(argv[1], argc - 2, argv + 2);
  char **renamed = NULL;
  if (old != NULL && (renamed = um_app_old_name_translate(old, &argc, argv)) == NULL) {
    fputs("umbra: out of memory\n", stderr);
    return UM_APP_FAILED;
  }
  if (renamed != NULL) argv = renamed;
  const struct um_app_verb *verb = um_app_verb_find(argv[1]);
  char unknown[UM_APP_UNKNOWN];
  int code;
  if (verb != NULL) {
    code = parse_and_run(context, verb, argc, argv);
  } else {
    um_app_verb_unknown(argv[1], unknown);
    code = um_app_misuse(NULL, "%s", unknown);
  }
  free(renamed);
  return code;
}
