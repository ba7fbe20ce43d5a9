/* A diagnosis that was stopped, at many moments, goes on from its records: the same bits as one
 * that was not, by one process or two, and nothing that is on record is computed again. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/batch/each.h"
#include "base/batch/records.h"
#include "tests/support/temporary.h"

#define PLATE_STEP "24" /* [s] */
#include "tests/evidence/diagnosis/plate_diagnosis_test.h"

#define PIECES 6

static char folder[UM_TEST_PATH];

/* What came of one, and of its records: those at hand when it began, those written. */
struct answer {
  enum um_status status;
  char *said; /* the end of the diagnosis; freed by who asked */
  size_t before, written;
  size_t calls; /* of its progress */
};

struct calls {
  size_t count, stop_at; /* stop_at 0: never */
};

static bool progress(void *self, const char *task, size_t done, size_t total)
{
  struct calls *calls = self;
  (void)task, (void)done, (void)total;
  return ++calls->count != calls->stop_at;
}

static void put(char **text, size_t *length, const void *data, size_t n)
{
  *text = realloc(*text, *length + n);
  assert_non_null(*text);
  memcpy(*text + *length, data, n);
  *length += n;
}

/* All numbers of the verdict, in order, as bytes; then the summary. */
static char *bytes_of(const struct diagnosed *c, size_t *length)
{
  const struct um_diagnosis *d = c->d;
  char *text = NULL;
  size_t n = c->forward->observations.count;
  const double of[] = {d->chi2,
                       d->chi2_after,
                       d->bic_after,
                       (double)c->forward->evaluations,
                       (double)c->forward->heat_runs,
                       (double)d->nstep};
  put(&text, length, of, sizeof of);
  put(&text, length, d->value_after, n * sizeof *d->value_after);
  for (size_t i = 0; i < d->naddition; i++) {
    put(&text, length, d->addition[i].value, sizeof d->addition[i].value);
    put(&text, length, d->addition_sigma[i], sizeof d->addition_sigma[i]);
  }
  for (size_t s = 0; s < d->nstep; s++)
    for (size_t i = 0; i < d->step[s].nalternative; i++) {
      const struct um_diagnosis_alternative *a = &d->step[s].alternative[i];
      const double is[] = {(double)a->candidate, a->score.statistic, a->chi2, a->bic, a->held_out};
      put(&text, length, is, sizeof is);
      put(&text, length, a->value, sizeof a->value);
    }
  for (size_t i = 0; i < c->candidates->count; i++) {
    const struct um_sensitivity_candidate *of_list = &c->candidates->candidate[i];
    put(&text, length, of_list->signature, of_list->ncolumn * n * sizeof *of_list->signature);
  }
  put(&text, length, d->summary, strlen(d->summary));
  return text;
}

/* records: false: none are kept. */
static struct answer ask(struct um_compare_measurements *measured, bool records, bool resume,
                         size_t stop_at, size_t *length)
{
  static const char *const only[] = {"zero_point",   "emittance",         "area",
                                     "albedo_level", "solar_absorptance", "attitude_offset"};
  const struct um_diagnosis_options options = {
      .candidates = {.only = only, .nonly = sizeof only / sizeof *only}};
  struct um_batch_task task = um_batch_each_task();
  struct um_batch *batch = NULL;
  struct diagnosed c = {.measured = NULL};
  struct calls calls = {0, 0};
  struct answer answer = {.status = UM_OK};
  task.folder = folder;
  task.resume = resume;
  if (records) OK(um_batch_open(context, &task, &batch));
  if (records) answer.before = um_batch_recorded(batch);
  OK(um_sensitivity_forward_create(context, path, NULL, measured, UM_VARIANT_TIGHT, &c.forward));
  c.forward->records = batch;
  calls.stop_at = stop_at;
  um_core_progress_set_sink(context, progress, &calls);
  answer.status = um_sensitivity_candidates_create(context, c.forward, NULL, 0, &options.candidates,
                                                   &c.candidates);
  if (answer.status == UM_OK)
    answer.status = um_diagnosis_create(context, c.forward, c.candidates, &options, &c.d);
  um_core_progress_set_sink(context, NULL, NULL);
  um_core_message_clear(context);
  answer.calls = calls.count;
  *length = 0;
  if (answer.status == UM_OK) answer.said = bytes_of(&c, length);
  if (records) answer.written = um_batch_recorded(batch) - answer.before;
  um_batch_close(context, &batch);
  end(&c);
  return answer;
}

static void expect_same(const struct answer *a, const char *whole, size_t length, size_t is)
{
  assert_int_equal(a->status, UM_OK);
  assert_int_equal(is, length);
  assert_memory_equal(a->said, whole, length);
  free(a->said);
}

static void test_resumed(void **state)
{
  (void)state;
  const struct lists lists = {
      .with = LIST("zero_point:vis,factor=0.9", "emittance:grey_panel,factor=0.8")};
  struct um_compare_measurements *measured;
  size_t length, is;
  assert_int_equal(um_test_folder_create(folder), 0);
  measure(&lists, &measured);
  struct answer plain = ask(measured, false, false, 0, &length);
  struct answer whole = ask(measured, true, false, 0, &is);
  expect_same(&whole, plain.said, length, is);
  struct answer again = ask(measured, true, true, 0, &is);
  expect_same(&again, plain.said, length, is);
  assert_int_equal(again.before, whole.written);
  assert_int_equal(again.written, 0); /* nothing is computed again */
  for (size_t i = 1; i < PIECES; i++) {
    um_batch_records_remove(context, folder);
    um_core_context_set_threads(context, 1);
    struct answer part = ask(measured, true, false, i * whole.calls / PIECES, &is);
    free(part.said); /* there is nothing */
    assert_int_equal(part.status, UM_ERR_CANCELLED);
    assert_true(part.written < whole.written);
    um_core_context_set_threads(context, 1 + (int)(i % 2));
    struct answer rest = ask(measured, true, true, 0, &is);
    expect_same(&rest, plain.said, length, is);
    assert_int_equal(rest.before, part.written);
    assert_int_equal(rest.written, whole.written - part.written);
    print_message("  %zu of %zu on record\n", part.written, whole.written);
  }
  um_core_context_set_threads(context, 1);
  free(plain.said);
  um_compare_measurements_destroy(context, &measured);
  um_batch_records_remove(context, folder);
  assert_int_not_equal(access(folder, F_OK), 0);
}

int main(void)
{
  static const struct CMUnitTest tests[] = {cmocka_unit_test(test_resumed)};
  return cmocka_run_group_tests_name("resume", tests, set_up, tear_down);
}
