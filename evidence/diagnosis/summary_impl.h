/* Parts of a summary. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_SUMMARY_IMPL_H
#define UMBRA_DIAGNOSIS_SUMMARY_IMPL_H

#include "evidence/diagnosis/summary.h"

/* Text that grows up to `size` bytes, and is cut there. */
struct um_diagnosis_words {
  char *at;
  size_t size, used;
};
void um_diagnosis_words_add(struct um_diagnosis_words *words, const char *format, ...)
    UM_PRINTF(2, 3);

/* How sure an effect is: as um_diagnosis_confidence has it, or that the user chose it. */
#define UM_DIAGNOSIS_CHOSEN (UM_CONFIDENCE_UNCERTAIN + 1)
/* A sentence for each effect of a class, the largest first, behind `first`, then `again`; *left:
 * how many may still be said, which goes down. Returns how many were left out. */
size_t um_diagnosis_words_class(struct um_diagnosis_words *words, const struct um_diagnosis *d,
                                int confidence, const char *first, const char *again, size_t *left);

#endif
