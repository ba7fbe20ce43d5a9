/* Sessions: settings, callbacks, the message. */
#include "library/session_impl.h"

#include <stdlib.h>
#include <string.h>

/* The public statuses are those of the program, by number. */
#define SAME(ours, theirs)                                                                         \
  _Static_assert((int)UMBRA_##ours == (int)UM_##theirs, "a status of its own: " #ours)
SAME(OK, OK);
SAME(ERR_INPUT, ERR_INPUT);
SAME(ERR_IO, ERR_IO);
SAME(ERR_MEMORY, ERR_MEMORY);
SAME(ERR_NUMERIC, ERR_NUMERIC);
SAME(ERR_LIBRARY, ERR_LIBRARY);
SAME(ERR_CANCELLED, ERR_CANCELLED);
SAME(ERR_REFUSED, ERR_REFUSED);
_Static_assert(UM_STATUS_COUNT == UM_ERR_REFUSED + 1, "a status that the header has not");
SAME(LOG_DEBUG, LOG_DEBUG);
SAME(LOG_ERROR, LOG_ERROR);

const char *umbra_version(void) { return UM_LIBRARY_VERSION; }

enum umbra_status um_library_status(enum um_status status) { return (enum umbra_status)status; }

struct um_context *um_library_begin(struct umbra *umbra)
{
  um_core_message_clear(umbra->context);
  um_core_log_clear(umbra->context);
  atomic_store(&umbra->interrupted, 0);
  return umbra->context;
}

enum um_status um_library_check_size(struct um_context *context, const char *name, size_t size,
                                     size_t known)
{
  if (size == known) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s: size is %zu bytes; accepted: %zu, as the macro beside it sets", name,
                      size, known);
}

static void log_line(void *self, enum um_core_log_level level, const char *line)
{
  const struct umbra *umbra = self;
  umbra->settings.log(umbra->settings.self, (enum umbra_log_level)level, line);
}

static bool progress(void *self, const char *task, size_t done, size_t total)
{
  const struct umbra *umbra = self;
  return umbra->settings.progress(umbra->settings.self, task, done, total) != 0;
}

static bool stop(void *self)
{
  struct umbra *umbra = self;
  if (atomic_load_explicit(&umbra->interrupted, memory_order_relaxed) != 0) return true;
  return umbra->settings.stop != NULL && umbra->settings.stop(umbra->settings.self) != 0;
}

void umbra_interrupt(struct umbra *umbra) { atomic_store(&umbra->interrupted, 1); }

static enum um_status apply(struct umbra *umbra, const struct umbra_settings *settings)
{
  struct um_context *context = umbra->context;
  UM_TRY(um_core_context_set_data(context, settings->data));
  UM_TRY(um_core_context_set_cache(context, settings->cache));
  if (settings->threads > 0) um_core_context_set_threads(context, settings->threads);
  umbra->settings = *settings;
  umbra->settings.data = umbra->settings.cache = NULL;
  if (settings->log != NULL) um_core_log_set_sink(context, log_line, umbra);
  if (settings->progress != NULL) um_core_progress_set_sink(context, progress, umbra);
  um_core_context_set_stop(context, stop, umbra);
  return UM_OK;
}

enum umbra_status umbra_open(const struct umbra_settings *settings, struct umbra **out)
{
  static const struct umbra_settings defaults = UMBRA_SETTINGS;
  *out = NULL;
  if (settings == NULL) settings = &defaults;
  if (settings->size != sizeof *settings) return UMBRA_ERR_INPUT;
  struct umbra *umbra = calloc(1, sizeof *umbra);
  if (umbra == NULL) return UMBRA_ERR_MEMORY;
  atomic_init(&umbra->users, 1);
  atomic_init(&umbra->interrupted, 0);
  enum um_status status = um_core_context_create(NULL, &umbra->context);
  if (status == UM_OK) status = apply(umbra, settings);
  if (status == UM_OK) status = um_library_catalogue(umbra);
  if (status != UM_OK) um_library_session_drop(&umbra);
  *out = umbra;
  return um_library_status(status);
}

struct umbra *um_library_session_share(struct umbra *umbra)
{
  atomic_fetch_add(&umbra->users, 1);
  return umbra;
}

void um_library_session_drop(struct umbra **umbra)
{
  if (umbra == NULL || *umbra == NULL) return;
  if (atomic_fetch_sub(&(*umbra)->users, 1) == 1) {
    if ((*umbra)->context != NULL)
      um_effects_registry_destroy((*umbra)->context, &(*umbra)->registry);
    if ((*umbra)->context != NULL) um_core_arena_release((*umbra)->context, &(*umbra)->memory);
    um_core_context_destroy(&(*umbra)->context);
    free(*umbra);
  }
  *umbra = NULL;
}

void umbra_close(struct umbra **umbra) { um_library_session_drop(umbra); }

const char *umbra_message(const struct umbra *umbra) { return um_core_message(umbra->context); }
