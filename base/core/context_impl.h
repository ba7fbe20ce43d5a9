/* What other files of core keep in the context. */
#ifndef UMBRA_CORE_CONTEXT_IMPL_H
#define UMBRA_CORE_CONTEXT_IMPL_H

#include "base/core/context.h"

/* Where held_files.c keeps its list; NULL in it: nothing is held. */
struct um_core_held_files;
struct um_core_held_files **um_core_context_held_files(struct um_context *context);

#endif
