/* Sessions of the library: callbacks, ownership, folders, threads. */
#include <pthread.h>
#include <time.h>

#include "tests/library/session_test.h"

struct heard {
  int lines, steps, asked, limit;
};

static void hear_line(void *self, enum umbra_log_level level, const char *line)
{
  assert_true(level <= UMBRA_LOG_ERROR && strlen(line) > 0);
  ((struct heard *)self)->lines++;
}

static int hear_progress(void *self, const char *task, size_t done, size_t total)
{
  assert_non_null(task);
  assert_true(done <= total || total == 0);
  struct heard *h = self;
  return ++h->steps < h->limit;
}

static int hear_stop(void *self)
{
  ((struct heard *)self)->asked = 1;
  return 1;
}

/* What the callbacks are told, and that they end the work. */
static void test_callbacks(void **state)
{
  (void)state;
  struct heard heard = {.limit = 1000000};
  struct umbra_settings settings = UMBRA_SETTINGS;
  settings.threads = 1;
  settings.self = &heard;
  settings.log = hear_line;
  settings.progress = hear_progress;
  umbra_close(&umbra);
  assert_int_equal(umbra_open(&settings, &umbra), UMBRA_OK);
  struct umbra_result *result = session_run_box();
  umbra_result_close(&result);
  assert_true(heard.lines > 3 && heard.steps > 3);
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  ok(umbra_model_build(umbra, scenario, &model));
  heard.limit = 0;
  refused(umbra_run(umbra, model, &result), UMBRA_ERR_CANCELLED, "cancelled");
  assert_null(result);
  umbra_model_close(&model);
  umbra_scenario_close(&scenario);
  settings.stop = hear_stop;
  umbra_close(&umbra);
  assert_int_equal(umbra_open(&settings, &umbra), UMBRA_OK);
  refused(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario), UMBRA_ERR_CANCELLED,
          "cancelled");
  assert_int_equal(heard.asked, 1);
}

static void *interrupt_soon(void *self)
{
  (void)self;
  struct timespec tenth = {.tv_nsec = 100000000};
  nanosleep(&tenth, NULL);
  umbra_interrupt(umbra);
  return NULL;
}

/* Another thread ends a call; the next call works. */
static void test_interrupt(void **state)
{
  (void)state;
  pthread_t thread;
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  struct umbra_result *result;
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  umbra_interrupt(umbra); /* nothing is under way */
  ok(umbra_scenario_set(umbra, scenario, "time.stop_utc", "2016-09-07T18:11:00Z"));
  ok(umbra_scenario_set(umbra, scenario, "time.step_s", "2"));
  ok(umbra_model_build(umbra, scenario, &model));
  assert_int_equal(pthread_create(&thread, NULL, interrupt_soon, NULL), 0);
  refused(umbra_run(umbra, model, &result), UMBRA_ERR_CANCELLED, "cancelled");
  assert_int_equal(pthread_join(thread, NULL), 0);
  umbra_model_close(&model);
  umbra_scenario_close(&scenario);
  result = session_run_box();
  umbra_result_close(&result);
}

/* Objects are closed in any order, the session first. */
static void test_ownership(void **state)
{
  (void)state;
  struct umbra *own;
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  struct umbra_result *result;
  command_copy_data("box.yaml");
  assert_int_equal(umbra_open(NULL, &own), UMBRA_OK);
  ok(umbra_scenario_read(own, "box.yaml", NULL, &scenario));
  ok(umbra_model_build(own, scenario, &model));
  ok(umbra_run(own, model, &result));
  umbra_close(&own);
  assert_null(own);
  umbra_scenario_close(&scenario);
  umbra_model_close(&model);
  assert_null(model);
  assert_true(umbra_result_array(result, "irradiance")->shape[1] == 2);
  umbra_result_close(&result);
  assert_null(result);
  umbra_close(NULL);
  umbra_scenario_close(&scenario);
  umbra_model_close(&model);
  umbra_result_close(&result);
}

/* View factors are kept where the session says, and taken from there. */
static void test_cache_folder(void **state)
{
  (void)state;
  struct umbra_settings settings = UMBRA_SETTINGS;
  struct umbra_scenario *scenario;
  settings.cache = "kept";
  umbra_close(&umbra);
  assert_int_equal(umbra_open(&settings, &umbra), UMBRA_OK);
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  ok(umbra_scenario_set_number(umbra, scenario, "parts.bus.inside_emittance", 0.8));
  assert_false(command_exists("kept"));
  struct umbra_result *first = session_run(scenario), *second = session_run(scenario);
  assert_true(command_exists("kept"));
  const struct umbra_array *a = umbra_result_array(first, "temperature");
  const struct umbra_array *b = umbra_result_array(second, "temperature");
  assert_memory_equal(a->data, b->data, a->shape[0] * a->shape[1] * sizeof *a->data);
  umbra_result_close(&first);
  umbra_result_close(&second);
  umbra_scenario_close(&scenario);
}

struct lane {
  pthread_t thread;
  double sum;
  bool good;
};

static void *run_lane(void *self)
{
  struct lane *lane = self;
  struct umbra_settings settings = UMBRA_SETTINGS;
  struct umbra *own;
  struct umbra_scenario *scenario = NULL;
  struct umbra_model *model = NULL;
  struct umbra_result *result = NULL;
  settings.threads = 1;
  lane->good = umbra_open(&settings, &own) == UMBRA_OK &&
               umbra_scenario_read(own, "box.yaml", NULL, &scenario) == UMBRA_OK &&
               umbra_model_build(own, scenario, &model) == UMBRA_OK &&
               umbra_run(own, model, &result) == UMBRA_OK;
  for (size_t i = 0; lane->good && i < 10; i++)
    lane->sum += umbra_result_array(result, "intensity")->data[i];
  umbra_result_close(&result);
  umbra_model_close(&model);
  umbra_scenario_close(&scenario);
  umbra_close(&own);
  return NULL;
}

/* Sessions work side by side: the same bits. */
static void test_threads(void **state)
{
  (void)state;
  struct lane lane[4] = {0};
  struct umbra_result *result = session_run_box();
  double expected = 0.0;
  for (size_t i = 0; i < 10; i++) expected += umbra_result_array(result, "intensity")->data[i];
  umbra_result_close(&result);
  for (size_t i = 0; i < 4; i++)
    assert_int_equal(pthread_create(&lane[i].thread, NULL, run_lane, &lane[i]), 0);
  for (size_t i = 0; i < 4; i++) {
    assert_int_equal(pthread_join(lane[i].thread, NULL), 0);
    assert_true(lane[i].good && lane[i].sum == expected);
  }
}

struct guest {
  pthread_t thread;
  struct umbra_model *model;
  struct umbra *own;
  struct umbra_result *result;
};

static void *run_guest(void *self)
{
  struct guest *guest = self;
  struct umbra_settings settings = UMBRA_SETTINGS;
  settings.threads = 1;
  if (umbra_open(&settings, &guest->own) == UMBRA_OK)
    (void)umbra_run(guest->own, guest->model, &guest->result);
  return NULL;
}

static void expect_same_result(const struct umbra_result *a, const struct umbra_result *b)
{
  for (size_t i = 0; umbra_result_array_at(a, i) != NULL; i++) {
    const struct umbra_array *x = umbra_result_array_at(a, i), *y = umbra_result_array_at(b, i);
    size_t n = 1;
    assert_string_equal(x->name, y->name);
    for (size_t k = 0; k < x->dimensions; k++) n *= x->shape[k];
    assert_memory_equal(x->data, y->data, n * sizeof *x->data);
  }
}

/* Eight sessions run one model at once: the same bits. */
static void test_one_model(void **state)
{
  (void)state;
  struct guest guest[8] = {0};
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  struct umbra_result *alone;
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  ok(umbra_model_build(umbra, scenario, &model));
  ok(umbra_run(umbra, model, &alone));
  for (size_t i = 0; i < 8; i++) {
    guest[i].model = model;
    assert_int_equal(pthread_create(&guest[i].thread, NULL, run_guest, &guest[i]), 0);
  }
  for (size_t i = 0; i < 8; i++) {
    assert_int_equal(pthread_join(guest[i].thread, NULL), 0);
    assert_non_null(guest[i].result);
    expect_same_result(alone, guest[i].result);
    umbra_result_close(&guest[i].result);
    umbra_close(&guest[i].own);
  }
  umbra_result_close(&alone);
  umbra_model_close(&model);
  umbra_scenario_close(&scenario);
}

/* The data folder that is given goes before the others. */
static void test_data_folder(void **state)
{
  (void)state;
  struct umbra_settings settings = UMBRA_SETTINGS;
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  settings.data = "nowhere";
  umbra_close(&umbra);
  assert_int_equal(umbra_open(&settings, &umbra), UMBRA_OK);
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  refused(umbra_model_build(umbra, scenario, &model), UMBRA_ERR_IO, "nowhere");
  umbra_scenario_close(&scenario);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_callbacks, session_enter, session_leave),
      cmocka_unit_test_setup_teardown(test_interrupt, session_enter, session_leave),
      cmocka_unit_test_setup_teardown(test_ownership, session_enter, session_leave),
      cmocka_unit_test_setup_teardown(test_cache_folder, session_enter, session_leave),
      cmocka_unit_test_setup_teardown(test_threads, session_enter, session_leave),
      cmocka_unit_test_setup_teardown(test_one_model, session_enter, session_leave),
      cmocka_unit_test_setup_teardown(test_data_folder, session_enter, session_leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
