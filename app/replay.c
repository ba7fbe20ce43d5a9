/* umbra replay: a command again, from the record beside its results. The record is somebody's file:
 * it can only name a verb of this program with options that this program understands, its results
 * go where the user of now says, and it loads no code unless that user allows it. */
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "app/app.h"
#include "app/replay_read.h"
#include "base/core/file_snapshot.h"
#include "base/core/replay.h"
#include "base/core/text.h"

/* Options of the record that do not count: where results go is said anew, nothing is gone on with,
 * threads are those of this machine. */
#define LEFT_OUT "out spectra file target force resume share record threads"

struct work {
  struct um_context *context;
  const struct um_app_options *options;
  char *folder; /* that was named, absolute; NULL: a file was */
  char *path;   /* of the record */
  struct um_document *document;
  struct um_app_replay_record *record;
  const struct um_app_verb *verb;
  char *out;   /* absolute; NULL: the verb writes nothing */
  char **argv; /* [argc] with NULL behind */
  int argc;
};

static enum um_status fail(const struct work *w, const char *what, const char *accepted)
{
  return um_core_fail(w->context, UM_ERR_INPUT, "%s: %.200s; accepted: %s", w->path, what,
                      accepted);
}

/* The path with all its folders named, itself there or not. */
static enum um_status absolute(struct um_context *context, const char *path, char **out)
{
  char here[PATH_MAX];
  if (path[0] == '/') return um_core_strdup(context, path, out);
  if (getcwd(here, sizeof here) == NULL)
    return um_core_fail(context, UM_ERR_IO, "the working folder cannot be named");
  return um_core_asprintf(context, out, "%s/%s", here, path);
}

static enum um_status find_record(struct work *w)
{
  const char *name = w->options->positional[0];
  struct stat st;
  if (stat(name, &st) != 0 || !S_ISDIR(st.st_mode))
    return um_core_strdup(w->context, name, &w->path);
  char *real = realpath(name, NULL);
  enum um_status status = um_core_strdup(w->context, real != NULL ? real : name, &w->folder);
  free(real);
  if (status != UM_OK) return status;
  return um_core_asprintf(w->context, &w->path, "%s/" UM_CORE_REPLAY_FILE, w->folder);
}

/* ---- the command ---- */

static const char *argument(const struct work *w, size_t i)
{
  return ((const char *const *)w->record->arguments.items)[i];
}

/* The arguments as a command line, [argc] with room for three more. */
static enum um_status make_line(struct work *w)
{
  size_t n = w->record->arguments.count;
  if (n == 0) return fail(w, "arguments: is empty", "a command of umbra");
  UM_TRY(um_core_allocate(w->context, n + 5, sizeof *w->argv, &w->argv));
  w->argv[w->argc++] = (char *)"umbra";
  for (size_t i = 0; i < n; i++) w->argv[w->argc++] = (char *)argument(w, i);
  w->verb = um_app_verb_find(w->argv[1]);
  char unknown[UM_APP_UNKNOWN];
  if (w->verb == NULL) {
    um_app_verb_unknown(w->argv[1], unknown);
    return fail(w, unknown, "a command of umbra");
  }
  if (!w->verb->unrecorded) return UM_OK;
  return um_core_fail(w->context, UM_ERR_INPUT,
                      "%s: umbra %s is not replayed; accepted: a command with results", w->path,
                      w->verb->name);
}

/* The verb's own -o; NULL: it has none. */
static const struct um_app_option *out_option(const struct um_app_verb *verb)
{
  const char *const list[] = {verb->needs, verb->accepts};
  for (size_t k = 0; k < 2; k++) {
    const struct um_app_option *o;
    for (const char *ids = list[k]; (o = um_app_option_next(&ids)) != NULL;)
      if (o->letter == 'o') return o;
  }
  return NULL;
}

static bool is_left_out(const struct um_app_option *option)
{
  const struct um_app_option *o;
  for (const char *ids = LEFT_OUT; (o = um_app_option_next(&ids)) != NULL;)
    if (o == option) return true;
  return false;
}

static void append(struct work *w, int *n, const char *text) { w->argv[(*n)++] = (char *)text; }

static void append_own(struct work *w, int *n)
{
  if (w->out != NULL) append(w, n, "--out");
  if (w->out != NULL) append(w, n, w->out);
  if (w->options->force) append(w, n, "--force");
}

/* The command line without what is left out, with what is said now, before any "--". */
static enum um_status rewrite(struct work *w, const struct um_app_options *was)
{
  char **old = w->argv;
  int n = 0, count = w->argc;
  w->argv = NULL;
  enum um_status status =
      um_core_allocate(w->context, (size_t)count + 5, sizeof *w->argv, &w->argv);
  for (int i = 0; status == UM_OK && i < count; i++) {
    if (was->literal > 0 && i == was->literal) append_own(w, &n);
    if (!is_left_out(was->token[i])) append(w, &n, old[i]);
  }
  if (status == UM_OK && was->literal == 0) append_own(w, &n);
  w->argc = n;
  um_core_free(w->context, old);
  return status;
}

/* ---- where the results go ---- */

static bool same_place(const char *a, const char *b)
{
  struct stat of_a, of_b;
  return stat(a, &of_a) == 0 && stat(b, &of_b) == 0 && of_a.st_dev == of_b.st_dev &&
         of_a.st_ino == of_b.st_ino;
}

/* The folder that the record stands in is what is replayed. */
static enum um_status check_place(const struct work *w)
{
  char *folder = NULL;
  const char *slash = strrchr(w->path, '/');
  UM_TRY(um_core_asprintf(w->context, &folder, "%.*s", slash == NULL ? 1 : (int)(slash - w->path),
                          slash == NULL ? "." : w->path));
  bool same = same_place(folder[0] != '\0' ? folder : "/", w->out);
  um_core_free(w->context, folder);
  if (!same) return UM_OK;
  return um_core_fail(w->context, UM_ERR_INPUT,
                      "-o %s: holds the results that are replayed; accepted: another name", w->out);
}

/* Commands that write something, and do not as they are asked. */
static bool only_prints(const struct um_app_verb *verb, const struct um_app_options *was)
{
  return was->times || was->study_check || (verb->run == um_app_check && !was->view) ||
         (verb->run == um_app_list && was->out == NULL);
}

/* UM_APP_MISUSE: said what is wrong. */
static int choose_place(struct work *w, const struct um_app_options *was)
{
  const char *out = w->options->out;
  bool writes = out_option(w->verb) != NULL && !only_prints(w->verb, was);
  enum um_status status = UM_OK;
  if (!writes && out != NULL) {
    fprintf(stderr, "umbra: what is replayed writes nothing: -o does not go with it\n");
    return UM_APP_MISUSE;
  }
  if (writes && out == NULL && w->folder == NULL) {
    fputs("umbra: -o is missing: where the results go\n", stderr);
    return UM_APP_MISUSE;
  }
  if (writes && out != NULL)
    status = absolute(w->context, out, &w->out);
  else if (writes)
    status = um_core_asprintf(w->context, &w->out, "%s--replayed", w->folder);
  if (status == UM_OK && writes) status = check_place(w);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(w->context);
}

/* ---- is it understood, and may it be run? ---- */

static enum um_status check_code(const struct work *w, const struct um_app_options *was)
{
  if (w->options->allow_effects || !(was->allow_effects || was->neffect_file > 0)) return UM_OK;
  return fail(w, "its command loads code (--effect-file, --allow-effects)",
              "umbra replay with --allow-effects, where you trust it");
}

/* The command line as it will be run; the exit status of what is wrong is said, -1: help was. */
static int prepare(struct work *w)
{
  struct um_app_options was = {.replay = NULL};
  int threads = um_core_context_threads(w->context), code = UM_APP_FAILED;
  if (!um_app_options_allocate(&was, w->argc)) {
    (void)um_core_fail(w->context, UM_ERR_MEMORY, "out of memory");
    code = um_app_fail(w->context);
  } else {
    code = um_app_options_parse(w->context, w->verb, w->argc, w->argv, &was);
    um_core_context_set_threads(w->context, threads);
    if (code == UM_APP_DONE && check_code(w, &was) != UM_OK) code = um_app_fail(w->context);
    if (code == UM_APP_DONE) code = choose_place(w, &was);
    if (code == UM_APP_DONE && rewrite(w, &was) != UM_OK) code = um_app_fail(w->context);
  }
  um_app_options_release(&was);
  return code;
}

/* ---- what is another than it was ---- */

static void warn(const struct work *w, const char *path, const char *what)
{
  um_core_log(w->context, UM_LOG_WARNING, "%s: %s", path, what);
}

static enum um_status compare_input(const struct work *w, const struct um_app_replay_input *input)
{
  uint64_t digest;
  char text[UM_CORE_REPLAY_DIGEST];
  struct stat st;
  if (stat(input->path, &st) != 0) {
    warn(w, input->path, "was read then and is missing now");
    return UM_OK;
  }
  enum um_status status = um_core_file_digest(w->context, input->path, &digest);
  if (status == UM_ERR_IO) {
    warn(w, input->path, "was read then and cannot be read now");
    um_core_message_clear(w->context);
    return UM_OK;
  }
  UM_TRY(status);
  um_core_replay_digest_text(digest, text);
  if (strcmp(text, input->digest) != 0) warn(w, input->path, "has changed since it was read");
  return UM_OK;
}

/* A cache and data that the environment names from here are the same from elsewhere. */
static enum um_status keep_folders(struct um_context *context)
{
  const char *cache = um_core_context_cache(context), *data = getenv("UMBRA_DATA");
  char *path = NULL;
  enum um_status status;
  if (cache != NULL) {
    UM_CHECK(absolute(context, cache, &path));
    UM_CHECK(um_core_context_set_cache(context, path));
    um_core_free(context, path);
    path = NULL;
  }
  if (data != NULL && data[0] != '\0') {
    UM_CHECK(absolute(context, data, &path));
    UM_CHECK(um_core_context_set_data(context, path));
  }
  status = UM_OK;
done:
  um_core_free(context, path);
  return status;
}

static enum um_status compare(const struct work *w)
{
  const struct um_app_replay_record *r = w->record;
  const struct um_app_replay_input *input = r->inputs.items;
  UM_TRY(keep_folders(w->context));
  if (strcmp(r->version, UM_APP_VERSION) != 0)
    um_core_log(w->context, UM_LOG_WARNING,
                "the results are of umbra %.40s; this is " UM_APP_VERSION, r->version);
  if (chdir(r->folder) != 0)
    warn(w, r->folder, "the command was run there and it cannot be entered; run here");
  for (size_t i = 0; i < r->inputs.count; i++) UM_TRY(compare_input(w, &input[i]));
  return UM_OK;
}

static void say(const struct work *w)
{
  fputs("replays:", stderr);
  for (int i = 0; i < w->argc; i++) {
    fputc(' ', stderr);
    um_core_text_put(stderr, w->argv[i]);
  }
  fputc('\n', stderr);
}

static enum um_status read_record(struct work *w)
{
  UM_TRY(find_record(w));
  UM_TRY(um_app_replay_read(w->context, w->path, &w->document, &w->record));
  return make_line(w);
}

int um_app_replay(struct um_context *context, const struct um_app_options *options)
{
  struct work w = {.context = context, .options = options};
  int code = UM_APP_FAILED;
  if (read_record(&w) != UM_OK) {
    code = um_app_fail(context);
  } else if ((code = prepare(&w)) == UM_APP_DONE) {
    say(&w);
    code = compare(&w) == UM_OK ? um_app_dispatch(context, w.argc, w.argv) : um_app_fail(context);
  }
  um_document_destroy(&w.document);
  UM_FREE(context, w.folder, w.path, w.out, w.argv);
  return code == -1 ? UM_APP_DONE : code;
}
