/* The context: allocator, message, log, progress. */
#include "base/core/context_impl.h"
#include "base/core/text.h"

#include <omp.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MESSAGE_SIZE 1024

struct um_context {
  struct um_core_allocator allocator;
  int threads;
  char message[MESSAGE_SIZE];
  um_core_log_sink log_sink;
  void *log_self;
  char *log; /* all lines so far, newline-terminated */
  size_t log_length, log_capacity;
  um_core_progress_sink progress_sink;
  void *progress_self;
  const char *task;
  size_t done, total;
  int quiet; /* um_core_quiet_begin less um_core_quiet_end */
  struct um_core_snapshot *snapshot;
  struct um_core_replay *replay;
  um_core_stop_source stop_source;
  void *stop_self;
  char *data, *cache; /* folders; NULL: none */
};

static void *default_allocate(void *self, size_t bytes)
{
  (void)self;
  return malloc(bytes);
}
static void *default_reallocate(void *self, void *block, size_t bytes)
{
  (void)self;
  return realloc(block, bytes);
}
static void default_release(void *self, void *block)
{
  (void)self;
  free(block);
}

enum um_status um_core_context_create(const struct um_core_allocator *allocator,
                                      struct um_context **out)
{
  struct um_core_allocator a = {NULL, default_allocate, default_reallocate, default_release};
  if (allocator != NULL) a = *allocator;
  *out = NULL;
  struct um_context *context = a.allocate(a.self, sizeof *context);
  if (context == NULL) return UM_ERR_MEMORY;
  memset(context, 0, sizeof *context);
  context->allocator = a;
  context->threads = omp_get_max_threads();
  *out = context;
  return UM_OK;
}

void um_core_context_destroy(struct um_context **context)
{
  if (context == NULL || *context == NULL) return;
  struct um_core_allocator a = (*context)->allocator;
  a.release(a.self, (*context)->log);
  a.release(a.self, (*context)->data);
  a.release(a.self, (*context)->cache);
  a.release(a.self, *context);
  *context = NULL;
}

struct um_core_snapshot **um_core_context_snapshot(struct um_context *context)
{
  return &context->snapshot;
}

struct um_core_replay **um_core_context_replay(struct um_context *context)
{
  return &context->replay;
}

void um_core_context_set_threads(struct um_context *context, int threads)
{
  context->threads = threads < 1 ? 1 : threads;
}

int um_core_context_threads(const struct um_context *context) { return context->threads; }

static enum um_status set_folder(struct um_context *context, const char *folder, char **out)
{
  char *copy = NULL;
  if (folder != NULL && folder[0] != '\0') UM_TRY(um_core_strdup(context, folder, &copy));
  um_core_free(context, *out);
  *out = copy;
  return UM_OK;
}

enum um_status um_core_context_set_data(struct um_context *context, const char *folder)
{
  return set_folder(context, folder, &context->data);
}

enum um_status um_core_context_set_cache(struct um_context *context, const char *folder)
{
  return set_folder(context, folder, &context->cache);
}

const char *um_core_context_data(const struct um_context *context) { return context->data; }

const char *um_core_context_cache(const struct um_context *context) { return context->cache; }

const char *um_core_message(const struct um_context *context) { return context->message; }

void um_core_message_clear(struct um_context *context) { context->message[0] = '\0'; }

enum um_status um_core_fail(struct um_context *context, enum um_status status, const char *format,
                            ...)
{
  if (context == NULL) return status;
  char text[MESSAGE_SIZE];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  um_core_text_make_line(text);
#pragma omp critical(um_core_message)
  {
    if (context->message[0] == '\0') memcpy(context->message, text, sizeof text);
  }
  return status;
}

void um_core_message_prefix(struct um_context *context, const char *format, ...)
{
  char text[MESSAGE_SIZE];
  va_list arguments;
  va_start(arguments, format);
  int n = vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  if (n < 0 || (size_t)n >= sizeof text) return;
  /* what does not fit is cut: the prefix names the place, which matters more than the tail */
  int room = (int)(sizeof text - (size_t)n) - 3;
  snprintf(text + n, sizeof text - (size_t)n, ": %.*s", room < 0 ? 0 : room, context->message);
  um_core_text_make_line(text);
  memcpy(context->message, text, sizeof text);
}

enum um_status um_core_allocate(struct um_context *context, size_t count, size_t size, void *out)
{
  void *block = NULL;
  memcpy(out, &block, sizeof block);
  if (size != 0 && count > SIZE_MAX / 2 / size)
    return um_core_fail(context, UM_ERR_MEMORY, "out of memory: %zu objects of %zu bytes", count,
                        size);
  size_t bytes = count * size == 0 ? 1 : count * size;
  const struct um_core_allocator *from = &context->allocator;
  /* pages that the system gives are zero already; those of a table that is not written stay so */
  bool zeroed = from->allocate == default_allocate;
  block = zeroed ? calloc(1, bytes) : from->allocate(from->self, bytes);
  if (block == NULL)
    return um_core_fail(context, UM_ERR_MEMORY, "out of memory: %zu bytes", count * size);
  if (!zeroed) memset(block, 0, bytes);
  memcpy(out, &block, sizeof block);
  return UM_OK;
}

enum um_status um_core_reallocate(struct um_context *context, size_t count, size_t size,
                                  void *block)
{
  if (size != 0 && count > SIZE_MAX / 2 / size)
    return um_core_fail(context, UM_ERR_MEMORY, "out of memory: %zu objects of %zu bytes", count,
                        size);
  void *old;
  memcpy(&old, block, sizeof old);
  size_t bytes = count * size == 0 ? 1 : count * size;
  void *grown = context->allocator.reallocate(context->allocator.self, old, bytes);
  if (grown == NULL) return um_core_fail(context, UM_ERR_MEMORY, "out of memory: %zu bytes", bytes);
  memcpy(block, &grown, sizeof grown);
  return UM_OK;
}

void um_core_free(struct um_context *context, void *block)
{
  if (block != NULL) context->allocator.release(context->allocator.self, block);
}

void um_core_free_blocks(struct um_context *context, size_t n, void *const *block)
{
  for (size_t i = 0; i < n; i++) um_core_free(context, block[i]);
}

enum um_status um_core_strdup(struct um_context *context, const char *text, char **out)
{
  size_t n = strlen(text) + 1;
  UM_TRY(um_core_allocate(context, n, 1, out));
  memcpy(*out, text, n);
  return UM_OK;
}

enum um_status um_core_asprintf(struct um_context *context, char **out, const char *format, ...)
{
  if (format == NULL) format = ""; /* lets the checks of sanitizers and compiler agree */
  va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  int n = vsnprintf(NULL, 0, format, arguments);
  va_end(arguments);
  enum um_status status = um_core_allocate(context, (size_t)(n < 0 ? 0 : n) + 1, 1, out);
  if (status == UM_OK && n >= 0) vsnprintf(*out, (size_t)n + 1, format, again);
  va_end(again);
  return status;
}

void um_core_log_set_sink(struct um_context *context, um_core_log_sink sink, void *self)
{
  context->log_sink = sink;
  context->log_self = self;
}

/* Keep a line for log.txt; when memory is short the line is lost, the run goes on. */
static void log_keep(struct um_context *context, const char *line)
{
  size_t n = strlen(line) + 1;
  if (context->log_length + n + 1 > context->log_capacity) {
    size_t capacity = 2 * (context->log_length + n + 1) + 256;
    char *grown = context->allocator.reallocate(context->allocator.self, context->log, capacity);
    if (grown == NULL) return;
    context->log = grown;
    context->log_capacity = capacity;
  }
  memcpy(context->log + context->log_length, line, n - 1);
  context->log[context->log_length + n - 1] = '\n';
  context->log_length += n;
  context->log[context->log_length] = '\0';
}

void um_core_log(struct um_context *context, enum um_core_log_level level, const char *format, ...)
{
  static const char *const prefix[] = {"debug: ", "", "warning: ", "error: "};
  char text[2 * MESSAGE_SIZE];
  va_list arguments;
  if (context->quiet > 0 && level < UM_LOG_ERROR) return;
  va_start(arguments, format);
  int n = snprintf(text, sizeof text, "%s", prefix[level]);
  vsnprintf(text + n, sizeof text - (size_t)n, format, arguments);
  va_end(arguments);
  um_core_text_make_line(text);
  if (level >= UM_LOG_INFO) log_keep(context, text);
  if (context->log_sink != NULL) context->log_sink(context->log_self, level, text + n);
}

const char *um_core_log_text(const struct um_context *context)
{
  return context->log == NULL ? "" : context->log;
}

void um_core_log_clear(struct um_context *context)
{
  context->log_length = 0;
  if (context->log != NULL) context->log[0] = '\0';
}

void um_core_quiet_begin(struct um_context *context) { context->quiet++; }
void um_core_quiet_end(struct um_context *context) { context->quiet--; }

void um_core_context_set_stop(struct um_context *context, um_core_stop_source source, void *self)
{
  context->stop_source = source;
  context->stop_self = self;
}

bool um_core_stopped(const struct um_context *context)
{
  return context != NULL && context->stop_source != NULL &&
         context->stop_source(context->stop_self);
}

enum um_status um_core_stop_check(struct um_context *context, const char *what)
{
  if (!um_core_stopped(context)) return UM_OK;
  return um_core_fail(context, UM_ERR_CANCELLED, "cancelled while %s", what);
}

void um_core_progress_set_sink(struct um_context *context, um_core_progress_sink sink, void *self)
{
  context->progress_sink = sink;
  context->progress_self = self;
}

void um_core_progress_begin(struct um_context *context, const char *task, size_t total)
{
  if (context->quiet > 0) return;
  context->task = task;
  context->done = 0;
  context->total = total;
  if (context->progress_sink != NULL)
    (void)context->progress_sink(context->progress_self, task, 0, total);
}

enum um_status um_core_progress_step(struct um_context *context, size_t steps)
{
  if (context->quiet == 0) context->done += steps;
  if (context->total > 0 && context->done > context->total) context->done = context->total;
  UM_TRY(um_core_stop_check(context, context->task != NULL ? context->task : "computing"));
  if (context->task == NULL) return UM_OK; /* quiet, and nothing larger reports */
  if (context->progress_sink == NULL ||
      context->progress_sink(context->progress_self, context->task, context->done, context->total))
    return UM_OK;
  return um_core_fail(context, UM_ERR_CANCELLED, "cancelled while %s", context->task);
}

void um_core_progress_end(struct um_context *context)
{
  if (context->task == NULL || context->quiet > 0) return;
  size_t all = context->total > 0 ? context->total : context->done;
  if (context->progress_sink != NULL)
    (void)context->progress_sink(context->progress_self, context->task, all, all);
  context->task = NULL;
}
