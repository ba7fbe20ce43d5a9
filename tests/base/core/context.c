/* The context: memory, messages, log, progress. */
#include "base/core/context.h"

#include <stdio.h>
#include <string.h>

#include "tests/support/allocator.h"
#include "tests/support/cmocka_all.h"

static struct um_test_memory memory; /* counts what is alive */
static struct um_context *context;

static int set_up(void **state)
{
  (void)state;
  struct um_core_allocator counting = um_test_memory_allocator(&memory);
  return um_core_context_create(&counting, &context) == UM_OK ? 0 : -1;
}

static int tear_down(void **state)
{
  (void)state;
  um_core_context_destroy(&context);
  um_core_context_destroy(&context);
  um_core_context_destroy(NULL);
  return context == NULL && memory.alive == 0 ? 0 : -1;
}

static void test_status_texts(void **state)
{
  (void)state;
  for (int i = 0; i < UM_STATUS_COUNT; i++)
    assert_true(strlen(um_core_status_text((enum um_status)i)) > 0);
  assert_string_equal(um_core_status_text(UM_OK), "success");
  assert_string_equal(um_core_status_text((enum um_status)UM_STATUS_COUNT), "unknown status");
  assert_string_equal(um_core_status_text((enum um_status) - 1), "unknown status");
}

/* The first message stays; line breaks in data do not break the line; long texts are cut. */
static void test_messages(void **state)
{
  (void)state;
  assert_string_equal(um_core_message(context), "");
  assert_int_equal(um_core_fail(context, UM_ERR_IO, "a %d\nb\x7f", 5), UM_ERR_IO);
  assert_string_equal(um_core_message(context), "a 5 b ");
  assert_int_equal(um_core_fail(context, UM_ERR_INPUT, "later"), UM_ERR_INPUT);
  assert_string_equal(um_core_message(context), "a 5 b ");
  um_core_message_prefix(context, "part '%s'", "bus");
  assert_string_equal(um_core_message(context), "part 'bus': a 5 b ");
  um_core_message_clear(context);
  assert_string_equal(um_core_message(context), "");
  char *text;
  assert_int_equal(um_core_allocate(context, 5000, 1, &text), UM_OK);
  memset(text, 'x', 4999);
  (void)um_core_fail(context, UM_ERR_INPUT, "%s", text);
  size_t n = strlen(um_core_message(context));
  assert_true(n > 500 && n < 5000);
  um_core_message_prefix(context, "file");
  assert_memory_equal(um_core_message(context), "file: xxx", 9);
  um_core_free(context, text);
  assert_int_equal(um_core_fail(NULL, UM_ERR_IO, "lost"), UM_ERR_IO);
}

static void test_memory(void **state)
{
  (void)state;
  long before = memory.alive;
  double *block;
  assert_int_equal(um_core_allocate(context, 100, sizeof *block, &block), UM_OK);
  for (int i = 0; i < 100; i++) assert_true(block[i] == 0.0);
  block[99] = 7.0;
  assert_int_equal(um_core_reallocate(context, 1000, sizeof *block, &block), UM_OK);
  assert_true(block[99] == 7.0);
  double *kept = block;
  assert_int_equal(um_core_reallocate(context, SIZE_MAX / 4, sizeof *block, &block), UM_ERR_MEMORY);
  assert_ptr_equal(block, kept);
  um_core_free(context, block);
  um_core_message_clear(context);
  assert_int_equal(um_core_allocate(context, SIZE_MAX / 2, 3, &block), UM_ERR_MEMORY);
  assert_null(block);
  assert_true(strlen(um_core_message(context)) > 0);
  assert_int_equal(um_core_allocate(context, 0, sizeof *block, &block), UM_OK);
  assert_non_null(block);
  um_core_free(context, block);
  um_core_free(context, NULL);
  char *text;
  assert_int_equal(um_core_strdup(context, "abc", &text), UM_OK);
  assert_string_equal(text, "abc");
  um_core_free(context, text);
  assert_int_equal(um_core_asprintf(context, &text, "%s-%03d", "x", 7), UM_OK);
  assert_string_equal(text, "x-007");
  um_core_free(context, text);
  assert_int_equal(memory.alive, before);
}

static char sink_text[256];
static void log_sink(void *self, enum um_core_log_level level, const char *line)
{
  assert_ptr_equal(self, sink_text);
  size_t used = strlen(sink_text);
  snprintf(sink_text + used, sizeof sink_text - used, "%d:%s|", (int)level, line);
}

static void test_log(void **state)
{
  (void)state;
  assert_string_equal(um_core_log_text(context), "");
  um_core_log_set_sink(context, log_sink, sink_text);
  um_core_log(context, UM_LOG_DEBUG, "detail");
  um_core_log(context, UM_LOG_INFO, "step %d", 1);
  um_core_log(context, UM_LOG_WARNING, "two\nlines");
  assert_string_equal(sink_text, "0:detail|1:step 1|2:two lines|");
  assert_string_equal(um_core_log_text(context), "step 1\nwarning: two lines\n");
  for (int i = 0; i < 200; i++) um_core_log(context, UM_LOG_ERROR, "line %d", i);
  assert_non_null(strstr(um_core_log_text(context), "error: line 199\n"));
  um_core_log_clear(context);
  assert_string_equal(um_core_log_text(context), "");
  um_core_log_set_sink(context, NULL, NULL);
}

struct progress {
  size_t calls, last, stop_at;
};
static bool progress_sink(void *self, const char *task, size_t done, size_t total)
{
  struct progress *p = self;
  assert_string_equal(task, "tracing");
  assert_true((done <= total || total == 0) && done >= p->last);
  p->calls++;
  p->last = done;
  return done < p->stop_at;
}

static void test_progress(void **state)
{
  (void)state;
  struct progress p = {0, 0, 100};
  assert_int_equal(um_core_progress_step(context, 1), UM_OK); /* no sink, no task */
  um_core_progress_set_sink(context, progress_sink, &p);
  um_core_progress_begin(context, "tracing", 10);
  assert_int_equal(um_core_progress_step(context, 4), UM_OK);
  assert_int_equal(p.last, 4);
  assert_int_equal(um_core_progress_step(context, 40), UM_OK);
  assert_int_equal(p.last, 10);
  um_core_progress_end(context);
  assert_int_equal(p.calls, 4);
  um_core_progress_end(context);
  assert_int_equal(p.calls, 4);
  p = (struct progress){0, 0, 100};
  um_core_progress_begin(context, "tracing", 0); /* nobody knows how many */
  assert_int_equal(um_core_progress_step(context, 7), UM_OK);
  assert_int_equal(p.last, 7);
  um_core_progress_end(context);
  assert_int_equal(p.last, 7);
  p = (struct progress){0, 0, 3};
  um_core_progress_begin(context, "tracing", 10);
  um_core_message_clear(context);
  assert_int_equal(um_core_progress_step(context, 3), UM_ERR_CANCELLED);
  assert_string_equal(um_core_message(context), "cancelled while tracing");
  um_core_progress_end(context);
  um_core_progress_set_sink(context, NULL, NULL);
}

/* Inner work is not reported and does not log, but may be cancelled as part of the outer. */
static void test_quiet(void **state)
{
  (void)state;
  struct progress p = {0, 0, 100};
  um_core_progress_set_sink(context, progress_sink, &p);
  um_core_progress_begin(context, "tracing", 10);
  assert_int_equal(um_core_progress_step(context, 4), UM_OK);
  um_core_quiet_begin(context);
  um_core_quiet_begin(context);
  um_core_progress_begin(context, "inner", 1000);
  assert_int_equal(um_core_progress_step(context, 500), UM_OK);
  um_core_progress_end(context);
  um_core_log(context, UM_LOG_WARNING, "hidden");
  um_core_log(context, UM_LOG_ERROR, "shown");
  um_core_quiet_end(context);
  um_core_log(context, UM_LOG_INFO, "hidden");
  um_core_quiet_end(context);
  assert_int_equal(p.last, 4);
  assert_null(strstr(um_core_log_text(context), "hidden"));
  assert_non_null(strstr(um_core_log_text(context), "error: shown\n"));
  assert_int_equal(um_core_progress_step(context, 2), UM_OK);
  assert_int_equal(p.last, 6);
  p.stop_at = 0;
  um_core_quiet_begin(context);
  um_core_message_clear(context);
  assert_int_equal(um_core_progress_step(context, 1), UM_ERR_CANCELLED);
  um_core_quiet_end(context);
  um_core_progress_end(context);
  um_core_progress_set_sink(context, NULL, NULL);
}

static void test_threads(void **state)
{
  (void)state;
  assert_true(um_core_context_threads(context) >= 1);
  um_core_context_set_threads(context, 3);
  assert_int_equal(um_core_context_threads(context), 3);
  um_core_context_set_threads(context, -2);
  assert_int_equal(um_core_context_threads(context), 1);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_status_texts), cmocka_unit_test(test_messages),
      cmocka_unit_test(test_memory),       cmocka_unit_test(test_log),
      cmocka_unit_test(test_progress),     cmocka_unit_test(test_quiet),
      cmocka_unit_test(test_threads),
  };
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
