/* The cases on several processes. A process per world makes its candidates; its cases then wait in
 * a queue for its helpers, each of which runs one job at a time in a child, so that a crash costs
 * one job. So many tokens as there are workers go round in a pipe: who computes holds one. */
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "base/core/suggestions.h"
#include "tests/lab/lab.h"

#define CHUNK 25 /* seeds that share one truth */

struct shop {
  const struct lab_options *options;
  int token[2], progress[2]; /* read end, write end */
};

static void take(const struct shop *shop)
{
  char token;
  if (read(shop->token[0], &token, 1) != 1) _exit(1);
}
static void give(const struct shop *shop)
{
  if (write(shop->token[1], "t", 1) != 1) _exit(1);
}

/* Do two cases of a world have one truth? */
static bool same_truth(const struct lab_case *a, const struct lab_case *b)
{
  if (a->nhidden != b->nhidden || a->pulse != b->pulse || strcmp(a->part, b->part) != 0)
    return false;
  for (size_t i = 0; i < a->nhidden; i++) {
    const struct lab_hidden *x = &a->hidden[i], *y = &b->hidden[i];
    if (x->parameter != y->parameter || x->value != y->value ||
        !um_core_words_same(x->effect, y->effect) || !um_core_words_same(x->target, y->target))
      return false;
  }
  return true;
}

static size_t job_length(const struct lab_case *cases, size_t count)
{
  size_t n = 1;
  while (n < count && n < CHUNK && same_truth(&cases[0], &cases[n])) n++;
  return n;
}

/* In a child: one truth, many noises. */
static int run_job(struct um_context *context, const struct shop *shop, const struct lab_desk *desk,
                   const struct lab_case *cases, size_t count)
{
  struct lab_truth truth = {0};
  if (lab_truth_create(context, &cases[0], false, shop->options->folder, &truth) != UM_OK) {
    char hidden[LAB_TEXT];
    lab_case_hidden(&cases[0], hidden);
    fprintf(stderr, "lab: truth of %s in %s: %s\n", hidden, desk->world->name,
            um_core_message(context));
    return 1;
  }
  for (size_t i = 0; i < count; i++) {
    struct lab_row row;
    lab_examine(context, desk, &truth, &cases[i], &row);
    if (!lab_journal_append(shop->options->folder, &row)) return 1;
    if (write(shop->progress[1], "p", 1) != 1) return 1;
  }
  lab_truth_release(context, &truth);
  return 0;
}

static int help(struct um_context *context, const struct shop *shop, const struct lab_desk *desk,
                const struct lab_case *cases, size_t count, int queue)
{
  int code = 0;
  for (size_t from; read(queue, &from, sizeof from) == (ssize_t)sizeof from;) {
    int status = 0;
    take(shop);
    pid_t child = fork();
    if (child == 0)
      _exit(run_job(context, shop, desk, cases + from, job_length(cases + from, count - from)));
    if (child < 0 || waitpid(child, &status, 0) != child || status != 0) {
      fprintf(stderr, "lab: a job of world '%s' failed\n", desk->world->name);
      code = 1;
    }
    give(shop);
  }
  return code;
}

static int wait_all(void)
{
  int status, code = 0;
  while (wait(&status) > 0) code |= status != 0;
  return code;
}

/* In a child: all cases of one world. */
static int run_world(const struct shop *shop, const struct lab_case *cases, size_t count)
{
  struct um_context *context = NULL;
  struct lab_desk desk = {0};
  int queue[2];
  close(shop->progress[0]);
  if (um_core_context_create(NULL, &context) != UM_OK || pipe(queue) != 0) return 1;
  um_core_context_set_threads(context, 1);
  take(shop);
  if (lab_desk_create(context, cases[0].world, shop->options->folder, &desk) != UM_OK) {
    fprintf(stderr, "lab: world '%s': %s\n", cases[0].world->name, um_core_message(context));
    give(shop);
    return 1;
  }
  fprintf(stderr, "world '%s': %zu candidates, %zu observations, %zu models in %.0f s\n",
          cases[0].world->name, desk.candidates->count, desk.forward->observations.count,
          desk.forward->evaluations, desk.forward->seconds);
  give(shop);
  for (size_t from = 0; from < count; from += job_length(cases + from, count - from))
    if (write(queue[1], &from, sizeof from) != (ssize_t)sizeof from) return 1;
  close(queue[1]);
  for (int i = 0; i < shop->options->workers; i++) {
    pid_t child = fork();
    if (child == 0) _exit(help(context, shop, &desk, cases, count, queue[0]));
    if (child < 0) return 1;
  }
  close(queue[0]);
  int code = wait_all();
  lab_desk_release(context, &desk);
  um_core_context_destroy(&context);
  return code;
}

static void show(size_t done, size_t total, time_t begun)
{
  double spent = difftime(time(NULL), begun);
  bool terminal = isatty(STDERR_FILENO) != 0;
  if (!terminal && done % (total / 20 + 1) != 0 && done != total) return;
  fprintf(stderr, "%s%zu of %zu cases, %.0f min spent, %.0f min left%s", terminal ? "\r" : "", done,
          total, spent / 60.0,
          done == 0 ? 0.0 : spent / 60.0 * (double)(total - done) / (double)done,
          terminal && done != total ? "   " : "\n");
}

static bool open_shop(const struct lab_options *options, struct shop *shop)
{
  *shop = (struct shop){.options = options};
  if (pipe(shop->token) != 0 || pipe(shop->progress) != 0) return false;
  for (int i = 0; i < options->workers; i++)
    if (write(shop->token[1], "t", 1) != 1) return false;
  return true;
}

bool lab_work(const struct lab_options *options, const struct lab_case *cases, size_t count)
{
  struct shop shop;
  time_t begun = time(NULL);
  size_t worlds, done = 0;
  char mark;
  const struct lab_world *world = lab_worlds(&worlds);
  if (!open_shop(options, &shop)) return false;
  struct lab_case *sorted = calloc(count + 1, sizeof *sorted);
  if (sorted == NULL) return false;
  fflush(NULL); /* or children print it again */
  for (size_t w = 0, from = 0; w < worlds; w++) {
    size_t n = 0;
    for (size_t i = 0; i < count; i++)
      if (cases[i].world == &world[w]) sorted[from + n++] = cases[i];
    if (n > 0) {
      pid_t child = fork();
      if (child == 0) _exit(run_world(&shop, sorted + from, n));
      if (child < 0) return false;
    }
    from += n;
  }
  close(shop.progress[1]);
  while (read(shop.progress[0], &mark, 1) == 1) show(++done, count, begun);
  int code = wait_all();
  free(sorted);
  for (int i = 0; i < 2; i++) close(shop.token[i]);
  close(shop.progress[0]);
  return code == 0;
}
