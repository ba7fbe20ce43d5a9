/* Decimal numbers as texts. */
#ifndef UMBRA_CORE_NUMBER_H
#define UMBRA_CORE_NUMBER_H

#include <stdbool.h>

/* Strict number: the whole text, finite, decimal point; false otherwise. Locale-independent. */
bool um_core_number_parse(const char *text, double *out);

#endif
