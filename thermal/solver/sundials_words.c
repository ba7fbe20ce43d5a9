/* What SUNDIALS says when it fails. Version 6 has a handler in each solver, 7 a stack of them in
 * the context, all of which are called. */
#include <cvodes/cvodes.h>
#include <kinsol/kinsol.h>
#include <stdio.h>

#include "thermal/solver/sundials_impl.h"

static void keep(struct um_thermal_words *words, const char *function, const char *message)
{
  snprintf(words->text, sizeof words->text, "%s: %s", function, message);
}

#if SUNDIALS_VERSION_MAJOR < 7

static void listen(int code, const char *module, const char *function, char *message, void *words)
{
  (void)code, (void)module;
  keep(words, function, message);
}

int um_thermal_words_of_cvodes(void *memory, SUNContext sun, struct um_thermal_words *words)
{
  (void)sun;
  return CVodeSetErrHandlerFn(memory, listen, words);
}

int um_thermal_words_of_kinsol(void *memory, SUNContext sun, struct um_thermal_words *words)
{
  (void)sun;
  return KINSetErrHandlerFn(memory, listen, words);
}

#else

static void listen(int line, const char *function, const char *file, const char *message,
                   SUNErrCode code, void *words, SUNContext sun)
{
  (void)line, (void)file, (void)code, (void)sun;
  keep(words, function, message);
}

int um_thermal_words_of_cvodes(void *memory, SUNContext sun, struct um_thermal_words *words)
{
  (void)memory;
  SUNErrCode code = SUNContext_ClearErrHandlers(sun);
  return code < 0 ? code : SUNContext_PushErrHandler(sun, listen, words);
}

int um_thermal_words_of_kinsol(void *memory, SUNContext sun, struct um_thermal_words *words)
{
  return um_thermal_words_of_cvodes(memory, sun, words);
}

#endif
