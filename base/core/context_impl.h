/* What other files of core keep in the context. */
#ifndef UMBRA_CORE_CONTEXT_IMPL_H
#define UMBRA_CORE_CONTEXT_IMPL_H

#include "base/core/context.h"

/* Where file_snapshot.c keeps its list; NULL in it: there is no snapshot. */
struct um_core_snapshot;
struct um_core_snapshot **um_core_context_snapshot(struct um_context *context);
/* Where replay.c keeps its record; NULL in it: there is none. */
struct um_core_replay;
struct um_core_replay **um_core_context_replay(struct um_context *context);

#endif
