/* The benchmark of diagnosis (bench/worlds/README.md): all worlds, one after the other, each in a
 * process of its own, so that one that fails or takes too long costs only itself. What is known is
 * in the journal; a run that was stopped goes on with the rest. */
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/bench/bench.h"
#include "tests/bench/worlds.h"

#define FOLDER  UMBRA_SOURCE_DIR "/bench/worlds"
#define JOURNAL "out/bench/worlds.csv"
#define WORDS   128
#define LIMIT_S 3600 /* of processor time for a world */
#define METHODS (WORLDS_BASELINES + 1)

static const char usage[] =
    "usage: bench_worlds [OUT.json] [--journal FILE] [--worlds A,B] [--candidates A,B]\n"
    "                    [--folder DIR] [--open-set] [--limit SECONDS] [--tables [METHOD]]\n"
    "                    [--again] [--all-right]\n"
    "  --journal     answers, a row each; those that stand there are kept (" JOURNAL ")\n"
    "  --again       forget those that stand there\n"
    "  --worlds      these alone, in this order\n"
    "  --candidates  effects that are looked for; all of them without\n"
    "  --folder      with worlds.csv and the worlds that it lists (bench/worlds)\n"
    "  --open-set    what is hidden is taken out of the catalogue: is anything certain then?\n"
    "  --limit       processor time that a world may take\n"
    "  --tables      compute nothing; METHOD: of another program whose answers stand there\n"
    "  --all-right   fail unless every method is right in every world\n";

struct arguments {
  const char *json, *journal, *folder, *method;
  const char *world[WORDS], *candidate[WORDS];
  size_t nworld, ncandidate;
  rlim_t limit;
  bool tables, again, all_right, open_set;
};

static size_t split(char *text, const char *word[WORDS])
{
  size_t n = 0;
  char *rest = NULL;
  for (char *w = strtok_r(text, ",", &rest); w != NULL && n < WORDS; w = strtok_r(NULL, ",", &rest))
    word[n++] = w;
  return n;
}

static bool parse(int argc, char **argv, struct arguments *a)
{
  *a = (struct arguments){.journal = JOURNAL, .folder = FOLDER, .limit = LIMIT_S};
  for (int i = 1; i < argc; i++) {
    char *value = i + 1 < argc ? argv[i + 1] : NULL;
    if (argv[i][0] != '-') {
      a->json = argv[i];
    } else if (strcmp(argv[i], "--all-right") == 0) {
      a->all_right = true;
    } else if (strcmp(argv[i], "--open-set") == 0) {
      a->open_set = true;
    } else if (strcmp(argv[i], "--again") == 0) {
      a->again = true;
    } else if (strcmp(argv[i], "--tables") == 0) {
      a->tables = true;
      if (value != NULL && value[0] != '-') a->method = argv[++i];
    } else if (value == NULL) {
      return false;
    } else {
      if (strcmp(argv[i], "--journal") == 0)
        a->journal = value;
      else if (strcmp(argv[i], "--folder") == 0)
        a->folder = value;
      else if (strcmp(argv[i], "--worlds") == 0)
        a->nworld = split(value, a->world);
      else if (strcmp(argv[i], "--candidates") == 0)
        a->ncandidate = split(value, a->candidate);
      else if (strcmp(argv[i], "--limit") == 0)
        a->limit = (rlim_t)strtoul(value, NULL, 10);
      else
        return false;
      i++;
    }
  }
  return true;
}

static enum um_status read_answers(struct um_context *context, const char *journal,
                                   struct worlds_answer **out, size_t *count)
{
  *out = NULL;
  *count = 0;
  return access(journal, F_OK) == 0 ? worlds_journal_read(context, journal, out, count) : UM_OK;
}

/* Worlds that were asked for, in the order that was. */
static enum um_status choose(struct um_context *context, const struct arguments *a,
                             const struct worlds_world *all, size_t count,
                             const struct worlds_world *chosen[], size_t *n)
{
  *n = 0;
  for (size_t i = 0; i < (a->nworld > 0 ? a->nworld : count); i++) {
    size_t w = a->nworld > 0 ? 0 : i;
    while (a->nworld > 0 && w < count && strcmp(all[w].name, a->world[i]) != 0) w++;
    if (w == count) return um_core_fail(context, UM_ERR_INPUT, "no world '%s'", a->world[i]);
    chosen[(*n)++] = &all[w];
  }
  return UM_OK;
}

static const char *method_of(const struct arguments *a)
{
  return a->open_set ? WORLDS_OPEN : WORLDS_PROGRAM;
}

static bool keep_failure(const struct arguments *a, const struct worlds_world *world,
                         const char *why, double seconds)
{
  struct worlds_answer *failure = calloc(1, sizeof *failure);
  if (failure == NULL) return false;
  snprintf(failure->world, sizeof failure->world, "%s", world->name);
  snprintf(failure->method, sizeof failure->method, "%s", method_of(a));
  snprintf(failure->verdict, sizeof failure->verdict, "error");
  snprintf(failure->note, sizeof failure->note, "%s", why);
  failure->probability = NAN;
  failure->seconds = seconds;
  bool kept = worlds_journal_append(a->journal, failure);
  free(failure);
  return kept;
}

static int in_child(struct um_context *context, const struct arguments *a,
                    const struct worlds_world *world)
{
  const struct worlds_options options = {a->folder, a->journal, a->candidate, a->ncandidate,
                                         a->open_set};
  const struct rlimit limit = {a->limit, a->limit + 5};
  double start = bench_cpu();
  if (setrlimit(RLIMIT_CPU, &limit) != 0) return 1;
  if (worlds_diagnose(context, &options, world) == UM_OK) return 0;
  return keep_failure(a, world, um_core_message(context), bench_cpu() - start) ? 0 : 1;
}

static enum um_status answer(struct um_context *context, const struct arguments *a,
                             const struct worlds_world *world)
{
  int code = 0;
  double start = bench_wall();
  fflush(NULL);
  pid_t child = fork();
  if (child == 0) _exit(in_child(context, a, world));
  if (child < 0 || waitpid(child, &code, 0) != child)
    return um_core_fail(context, UM_ERR_IO, "no process for world '%s'", world->name);
  if (WIFSIGNALED(code)) {
    bool slow = WTERMSIG(code) == SIGXCPU || WTERMSIG(code) == SIGKILL;
    if (!keep_failure(a, world, slow ? "no answer in the time it had" : "a crash",
                      (double)a->limit))
      return um_core_fail(context, UM_ERR_IO, "%s: cannot be written", a->journal);
  } else if (code != 0) {
    return um_core_fail(context, UM_ERR_IO, "%s: cannot be written", a->journal);
  }
  fprintf(stderr, "%s: %.0f s\n", world->name, bench_wall() - start);
  return UM_OK;
}

/* --- tables ----------------------------------------------------------------------------------- */

struct tally {
  size_t world, hidden, null, detected, quiet, abstained, right, false_certain, value, within;
  double isolation;
};

static void add(struct tally *t, const struct worlds_judgement *j)
{
  t->world++;
  t->hidden += !j->is_null;
  t->null += j->is_null;
  t->detected += !j->is_null && j->detected;
  t->quiet += j->is_null && !j->accused;
  t->abstained += !j->is_null && j->abstained;
  t->right += j->right;
  t->false_certain += j->false_certain;
  t->value += j->nvalue;
  t->within += j->nwithin;
  t->isolation += isnan(j->isolation) ? 0.0 : j->isolation;
}

/* A share of errors, held against what is wanted; NaN: nothing is. */
static void figure(struct bench *bench, const char *what, double part, size_t all, double wanted)
{
  if (all > 0)
    bench_number(bench, what, "1", part / (double)all, wanted, isnan(wanted) ? (double)NAN : 1.0);
}

static void tell_figures(struct bench *bench, const struct tally *t)
{
  figure(bench, "hidden effects missed", (double)(t->hidden - t->detected), t->hidden, NAN);
  figure(bench, "false alarms", (double)(t->null - t->quiet), t->null, NAN);
  figure(bench, "probability not given to the truth", (double)t->hidden - t->isolation, t->hidden,
         0.20);
  figure(bench, "neither right nor rightly abstaining", (double)(t->world - t->right), t->world,
         0.05);
  figure(bench, "false certainty", (double)t->false_certain, t->world, 0.02);
  figure(bench, "values beyond 3 stated sigmas", (double)(t->value - t->within), t->value, 0.05);
}

static void tell(const char *method, const struct tally *t)
{
  if (t->world == 0) return;
  printf("| %s | %zu of %zu | %zu of %zu | %.2f | %zu of %zu | %zu of %zu | %zu of %zu | %zu of "
         "%zu |\n",
         method, t->detected, t->hidden, t->quiet, t->null,
         t->hidden > 0 ? t->isolation / (double)t->hidden : (double)NAN, t->abstained, t->hidden,
         t->right, t->world, t->false_certain, t->world, t->within, t->value);
}

static void tell_world(const struct worlds_world *world, const struct worlds_answer *a,
                       const struct worlds_judgement *j)
{
  char hidden[WORLDS_HIDDEN * WORLDS_TEXT] = "";
  for (size_t i = 0; i < world->nhidden; i++)
    worlds_append(hidden, sizeof hidden, ", ", world->hidden[i].names);
  for (char *bar = hidden; (bar = strchr(bar, '|')) != NULL;) *bar = '/'; /* a table has its own */
  printf("| %s | %s | %s | %s%s | %s | %.60s | %.2f | %zu/%zu | %.0f |\n", world->name,
         world->nhidden > 0 ? hidden : "nothing", worlds_good_name[world->good], a->verdict,
         j->right ? "" : " **wrong**", a->certain, a->groups, j->isolation, j->nwithin, j->nvalue,
         a->seconds);
}

/* Tables of what stands in the journal; all_right: every method is, everywhere. */
static enum um_status report(struct bench *bench, const struct arguments *a,
                             const struct worlds_world *chosen[], size_t n, bool *all_right)
{
  enum um_status status;
  struct worlds_answer *answer = NULL;
  size_t count;
  const char *method[METHODS] = {a->method != NULL ? a->method : WORLDS_PROGRAM};
  struct tally tally[METHODS] = {{0}};
  struct worlds_reliability reliability = {.count = {0}};
  *all_right = true;
  for (size_t b = 0; b < WORLDS_BASELINES; b++) method[b + 1] = worlds_baselines[b];
  UM_TRY(read_answers(bench->context, a->journal, &answer, &count));
  printf("\n| world | hidden | good is | verdict | certain | one of | isolation | values | s |\n"
         "|---|---|---|---|---|---|---|---|---|\n");
  for (size_t i = 0; i < n; i++)
    for (size_t m = 0; m < METHODS; m++) {
      const struct worlds_answer *of =
          worlds_journal_find(answer, count, chosen[i]->name, method[m]);
      struct worlds_judgement j = {0};
      if (of != NULL) worlds_judge(chosen[i], of, &j);
      *all_right &= j.right && j.nwithin == j.nvalue;
      if (of == NULL && m == 0) break; /* a world that is not answered yet counts for nobody */
      if (of == NULL) continue;
      if (m == 0) tell_world(chosen[i], of, &j);
      if (m == 0) worlds_reliability_add(chosen[i], of, &reliability);
      add(&tally[m], &j);
    }
  printf("\n| method | detection | 1 - false alarms | isolation | abstention | right or rightly "
         "abstaining | false certainty | values within 3 sigma "
         "|\n|---|---|---|---|---|---|---|---|\n");
  for (size_t m = 0; m < METHODS; m++) tell(method[m], &tally[m]);
  worlds_reliability_print(&reliability);
  tell_figures(bench, &tally[0]);
  printf("\n");
  status = UM_OK;
  um_core_free(bench->context, answer);
  return status;
}

/* Of worlds with a hidden effect that is in no catalogue: is anything certain, and which half of
 * the model is said to be wrong? */
static enum um_status report_open(struct bench *bench, const struct arguments *a,
                                  const struct worlds_world *chosen[], size_t n)
{
  struct worlds_answer *answer = NULL;
  size_t count, all = 0, certain = 0, wrong = 0;
  UM_TRY(read_answers(bench->context, a->journal, &answer, &count));
  printf("\n| world | left out | verdict | certain | half |\n|---|---|---|---|---|\n");
  for (size_t i = 0; i < n; i++) {
    char out[WORLDS_LEFT_OUT][WORLDS_TEXT], list[WORLDS_LONG] = "";
    size_t nout;
    const struct worlds_answer *of =
        worlds_journal_find(answer, count, chosen[i]->name, WORLDS_OPEN);
    if (of == NULL) continue;
    worlds_left_out(chosen[i], out, &nout);
    for (size_t k = 0; k < nout; k++) worlds_append(list, sizeof list, ", ", out[k]);
    bool right = worlds_half_is_right(chosen[i], of->half);
    printf("| %s | %s | %s | %s | %s%s |\n", chosen[i]->name, list, of->verdict, of->certain,
           of->half, right ? "" : " **wrong**");
    all++;
    certain += of->certain[0] != '\0' || strcmp(of->verdict, "error") == 0;
    wrong += !right;
  }
  figure(bench, "open set: something is certain", (double)certain, all, 1.0 / 40.0);
  figure(bench, "open set: wrong half", (double)wrong, all, 4.0 / 40.0);
  um_core_free(bench->context, answer);
  return UM_OK;
}

static bool is_asked(const struct arguments *a, const struct worlds_world *world)
{
  return !a->open_set || world->nhidden > 0;
}

static enum um_status run(struct bench *bench, const struct arguments *a, bool *all_right)
{
  enum um_status status;
  struct worlds_world *all = NULL;
  struct worlds_answer *known = NULL;
  const struct worlds_world *chosen[WORDS];
  size_t count, n, nknown;
  char path[4 * WORLDS_TEXT];
  snprintf(path, sizeof path, "%s/worlds.csv", a->folder);
  UM_CHECK(worlds_read(bench->context, path, &all, &count));
  UM_CHECK(choose(bench->context, a, all, count, chosen, &n));
  UM_CHECK(read_answers(bench->context, a->journal, &known, &nknown));
  for (size_t i = 0; i < n && !a->tables; i++) {
    const struct worlds_answer *of =
        worlds_journal_find(known, nknown, chosen[i]->name, method_of(a));
    if (!is_asked(a, chosen[i])) continue;
    if (of == NULL || strcmp(of->verdict, "error") == 0)
      UM_CHECK(answer(bench->context, a, chosen[i]));
  }
  if (a->open_set)
    UM_CHECK(report_open(bench, a, chosen, n));
  else
    UM_CHECK(report(bench, a, chosen, n, all_right));
done:
  um_core_free(bench->context, all);
  um_core_free(bench->context, known);
  return status;
}

int main(int argc, char **argv)
{
  struct arguments a;
  struct bench bench;
  bool all_right = true;
  if (!parse(argc, argv, &a)) {
    fputs(usage, stderr);
    return 2;
  }
  char *of_bench[] = {argv[0], (char *)a.json, NULL};
  bench_begin(&bench, a.json != NULL ? 2 : 1, of_bench, "worlds: diagnosis against known truths");
  if (a.again) remove(a.journal);
  bench_must(&bench, run(&bench, &a, &all_right));
  int code = bench_end(&bench);
  return code != 0 || (a.all_right && !all_right) ? 1 : 0;
}
