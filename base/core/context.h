/* The context: allocator, last message, log, progress, threads. It replaces globals; every fallible
 * function takes it first. One context belongs to one thread of control; worker threads that a
 * function starts itself may call um_core_fail (the first message wins) and nothing else here. */
#ifndef UMBRA_CORE_CONTEXT_H
#define UMBRA_CORE_CONTEXT_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/core/status.h"

#if defined(__GNUC__)
#define UM_PRINTF(text_at, first_at) __attribute__((format(printf, text_at, first_at)))
#else
#define UM_PRINTF(text_at, first_at)
#endif

struct um_context;

/* Memory source; all three or the default (malloc, realloc, free). `self` is handed through. */
struct um_core_allocator {
  void *self;
  void *(*allocate)(void *self, size_t bytes);
  void *(*reallocate)(void *self, void *block, size_t bytes);
  void (*release)(void *self, void *block);
};

enum um_core_log_level { UM_LOG_DEBUG, UM_LOG_INFO, UM_LOG_WARNING, UM_LOG_ERROR };

/* Receives each log line without newline; borrowed for the call. */
typedef void (*um_core_log_sink)(void *self, enum um_core_log_level level, const char *line);

/* Receives progress of a named task: done of total steps, 0 <= done <= total, or of nobody knows
 * how many, total 0, until the task ends with total = done. Returns false to cancel, which makes
 * um_core_progress_step return UM_ERR_CANCELLED. */
typedef bool (*um_core_progress_sink)(void *self, const char *task, size_t done, size_t total);

/* allocator: NULL for malloc. Out: the caller destroys. UM_ERR_MEMORY. */
enum um_status um_core_context_create(const struct um_core_allocator *allocator,
                                      struct um_context **out);
/* Accepts NULL, sets NULL. */
void um_core_context_destroy(struct um_context **context);

/* Number of worker threads, >= 1; default: OpenMP's own default. Results do not depend on it. */
void um_core_context_set_threads(struct um_context *context, int threads);
int um_core_context_threads(const struct um_context *context);

/* Folder that holds materials/, filters/, sensors/ and scenarios/ in place of those that come with
 * the program (base/core/data.h), and folder where view factors are kept between runs. Copied; NULL
 * or "": none, which is the default. UM_ERR_MEMORY leaves what was set. */
enum um_status um_core_context_set_data(struct um_context *context, const char *folder);
enum um_status um_core_context_set_cache(struct um_context *context, const char *folder);
/* NULL: none; borrowed until the next setting. */
const char *um_core_context_data(const struct um_context *context);
const char *um_core_context_cache(const struct um_context *context);

/* Message of the last failure, "" when none; one line; borrowed until the next failure. */
const char *um_core_message(const struct um_context *context);
/* Record a one-line message (no newline) for `status` and return `status`. Thread-safe; the first
 * message since um_core_message_clear is kept. Context NULL is allowed and loses the message. */
enum um_status um_core_fail(struct um_context *context, enum um_status status, const char *format,
                            ...) UM_PRINTF(3, 4);
/* Put "prefix: " before the recorded message; used by callers that know the user's name for it. */
void um_core_message_prefix(struct um_context *context, const char *format, ...) UM_PRINTF(2, 3);
void um_core_message_clear(struct um_context *context);

/* Zeroed memory for count objects of `size` bytes; overflow is checked. UM_ERR_MEMORY sets *out to
 * NULL. A count of 0 gives a block that may be freed. `out` is the address of a pointer. */
enum um_status um_core_allocate(struct um_context *context, size_t count, size_t size, void *out);
/* Grow or shrink *block to count objects; the old block stays valid on failure; new bytes are not
 * cleared. `block` is the address of a pointer. */
enum um_status um_core_reallocate(struct um_context *context, size_t count, size_t size,
                                  void *block);
/* Accepts NULL. */
void um_core_free(struct um_context *context, void *block);
void um_core_free_blocks(struct um_context *context, size_t n, void *const *block);
/* um_core_free of each pointer behind `context`; all are read before the first is freed. */
#define UM_FREE(context, ...)                                                                      \
  um_core_free_blocks(context, sizeof((void *[]){__VA_ARGS__}) / sizeof(void *),                   \
                      (void *[]){__VA_ARGS__})
/* Copy of a string; the caller frees. */
enum um_status um_core_strdup(struct um_context *context, const char *text, char **out);
/* printf into new memory; the caller frees. */
enum um_status um_core_asprintf(struct um_context *context, char **out, const char *format, ...)
    UM_PRINTF(3, 4);

/* Logging. Default sink: none. Every line is also kept for log.txt. */
void um_core_log_set_sink(struct um_context *context, um_core_log_sink sink, void *self);
void um_core_log(struct um_context *context, enum um_core_log_level level, const char *format, ...)
    UM_PRINTF(3, 4);
/* All lines so far of level >= INFO, joined by newlines; borrowed until the next log call. */
const char *um_core_log_text(const struct um_context *context);
/* Forget them. */
void um_core_log_clear(struct um_context *context);

/* Between the two, which nest: log lines below an error are dropped, and inner work does not report
 * its own progress, though the sink is still asked whether to go on. For work that is done many
 * times as a step of something larger. */
void um_core_quiet_begin(struct um_context *context);
void um_core_quiet_end(struct um_context *context);

/* Asked whether to stop: true ends the work, from then on for good. Called from worker threads too;
 * must be cheap. */
typedef bool (*um_core_stop_source)(void *self);
/* Default: none, nothing stops. */
void um_core_context_set_stop(struct um_context *context, um_core_stop_source source, void *self);
/* Has a stop been asked for? Thread-safe; for loops that leave by themselves. NULL: false. */
bool um_core_stopped(const struct um_context *context);
/* UM_ERR_CANCELLED with "cancelled while <what>" once a stop has been asked for; every loop that
 * may last calls it at least every few tenths of a second. Thread-safe. Context NULL: UM_OK. */
enum um_status um_core_stop_check(struct um_context *context, const char *what);

/* Progress of long work. begin/step/end around a loop; steps are counted, never timed here. */
void um_core_progress_set_sink(struct um_context *context, um_core_progress_sink sink, void *self);
void um_core_progress_begin(struct um_context *context, const char *task, size_t total);
enum um_status um_core_progress_step(struct um_context *context, size_t steps);
void um_core_progress_end(struct um_context *context);

#endif
