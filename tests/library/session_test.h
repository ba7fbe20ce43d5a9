/* A session of the library, and runs by it. */
#ifndef UMBRA_TESTS_LIBRARY_SESSION_TEST_H
#define UMBRA_TESTS_LIBRARY_SESSION_TEST_H

#include <string.h>

#include "library/umbra.h"
#include "tests/app/command.h"

static struct umbra *umbra;

static inline int session_enter(void **state)
{
  if (command_enter(state) != 0) return -1;
  return umbra_open(NULL, &umbra) == UMBRA_OK ? 0 : -1;
}

static inline int session_leave(void **state)
{
  umbra_close(&umbra);
  return command_leave(state);
}

#define ok(call)                                                                                   \
  do {                                                                                             \
    if ((call) != UMBRA_OK) fail_msg("%s: %s", #call, umbra_message(umbra));                       \
  } while (0)

/* The call is refused, with these words. */
#define refused(call, expected, words)                                                             \
  do {                                                                                             \
    assert_int_equal(call, expected);                                                              \
    if (strstr(umbra_message(umbra), words) == NULL)                                               \
      fail_msg("'%s' does not say '%s'", umbra_message(umbra), words);                             \
  } while (0)

static inline struct umbra_result *session_run(struct umbra_scenario *scenario)
{
  struct umbra_model *model;
  struct umbra_result *result;
  ok(umbra_model_build(umbra, scenario, &model));
  ok(umbra_run(umbra, model, &result));
  umbra_model_close(&model); /* the result keeps it */
  return result;
}

static inline struct umbra_result *session_run_box(void)
{
  struct umbra_scenario *scenario;
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  struct umbra_result *result = session_run(scenario);
  umbra_scenario_close(&scenario);
  return result;
}

#endif
