/* Texts of the status codes. */
#include "base/core/status.h"

const char *um_core_status_text(enum um_status status)
{
#define UM_STATUS_TEXT(code, text) [code] = text,
  static const char *const texts[] = {UM_STATUS_LIST(UM_STATUS_TEXT)};
#undef UM_STATUS_TEXT
  if ((int)status < 0 || status >= UM_STATUS_COUNT) return "unknown status";
  return texts[status];
}
