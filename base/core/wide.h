/* Loops on registers as wide as the machine has them: the same operations in the same order, hence
 * the same bits. ThreadSanitizer cannot have them: the loader chooses before it has begun. For
 * static functions alone: what clang names the choice is not what another file asks for. */
#ifndef UMBRA_CORE_WIDE_H
#define UMBRA_CORE_WIDE_H

#include <limits.h> /* says whose library it is */

#if defined __x86_64__ && defined __GLIBC__ && !defined __SANITIZE_THREAD__
#define UM_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define UM_WIDE_VECTORS
#endif

#endif
