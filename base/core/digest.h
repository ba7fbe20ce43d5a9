/* A number that bytes make (Fowler, Noll and Vo, FNV-1a of 64 bits): the same bytes the same one,
 * others another but by chance. Of names, of what records are of; nothing secret. */
#ifndef UMBRA_CORE_DIGEST_H
#define UMBRA_CORE_DIGEST_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* Of no bytes. */
#define UM_CORE_DIGEST_BEGIN UINT64_C(14695981039346656037)

/* On from a digest. */
static inline uint64_t um_core_digest(uint64_t digest, const void *bytes, size_t n)
{
  const unsigned char *byte = bytes;
  for (size_t i = 0; i < n; i++) digest = (digest ^ byte[i]) * UINT64_C(1099511628211);
  return digest;
}

/* The same of texts, their ends and number included: "a" "b" is not "ab". */
static inline uint64_t um_core_digest_texts(uint64_t digest, const char *const *text, size_t n)
{
  for (size_t i = 0; i < n; i++) digest = um_core_digest(digest, text[i], strlen(text[i]) + 1);
  return um_core_digest(digest, &n, sizeof n);
}

#endif
