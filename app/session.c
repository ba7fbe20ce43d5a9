/* Sessions of verbs that are clients of library/umbra.h. */
#include <stdlib.h>

#include "app/client.h"
#include "app/terminal.h"

static void log_line(void *self, enum umbra_log_level level, const char *line)
{
  (void)self;
  um_app_terminal_log((int)level, line);
}

int um_app_session_open(struct umbra **out)
{
  struct umbra_settings settings = UMBRA_SETTINGS;
  settings.cache = getenv("UMBRA_CACHE");
  settings.log = log_line;
  if (umbra_open(&settings, out) == UMBRA_OK) return UM_APP_DONE;
  fputs("umbra: out of memory\n", stderr);
  return UM_APP_FAILED;
}

int um_app_session_fail(const struct umbra *umbra)
{
  um_app_terminal_clear();
  fprintf(stderr, "umbra: %s\n", umbra_message(umbra));
  return UM_APP_FAILED;
}
