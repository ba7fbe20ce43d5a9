/* Messages with file, line and key, and what a name may be. */
#include "model/scenario/fail_group.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum um_status um_model_blame(struct um_context *context, const struct um_mark *at, const char *key,
                              enum um_status status)
{
  if (status == UM_OK || status == UM_ERR_MEMORY || status == UM_ERR_CANCELLED) return status;
  const char *dot = at->path[0] != '\0' && key != NULL ? "." : "";
  const struct um_mark *place = um_document_mark_key(at, key);
  if (key == NULL) key = "";
  if (at->path[0] != '\0' || key[0] != '\0')
    um_core_message_prefix(context, "%s%s%s", at->path, dot, key);
  if (place->line > 0)
    um_core_message_prefix(context, "%s:%d", place->file, place->line);
  else
    um_core_message_prefix(context, "%s", place->file);
  return status;
}

enum um_status um_model_fail(struct um_context *context, const struct um_mark *at, const char *key,
                             const char *format, ...)
{
  char text[1024];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return um_model_blame(context, at, key, um_core_fail(context, UM_ERR_INPUT, "%s", text));
}

bool um_model_name_is_plain(const char *name)
{
  for (const char *c = name; *c != '\0'; c++)
    if ((unsigned char)*c < 0x20 || *c == 0x7f || strchr("./:,;'\"\\", *c) != NULL) return false;
  return name[0] != '\0';
}
