/* The reflectances of the daylit Earth, made once for all tests of a program. */
#ifndef UMBRA_TESTS_ENVIRONMENT_DAYLIGHT_HELP_H
#define UMBRA_TESTS_ENVIRONMENT_DAYLIGHT_HELP_H

#include "environment/daylight.h"
#include "tests/support/with_context.h"

static struct um_environment_daylight *daylight;

static int daylight_set_up(void **state)
{
  if (context_set_up(state) != 0) return -1;
  return um_environment_daylight_make(context, &daylight) == UM_OK ? 0 : -1;
}

static int daylight_tear_down(void **state)
{
  um_core_free(context, daylight);
  return context_tear_down(state);
}

#endif
