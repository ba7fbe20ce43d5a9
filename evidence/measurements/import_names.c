/* What names of columns say: bands and their systems. */
#include <math.h>
#include <string.h>
#include <strings.h>

#include "base/core/text.h"
#include "evidence/measurements/import_impl.h"

#define MAGNITUDE_MAX 40.0 /* [mag] */

const char *um_compare_import_system(const char *name)
{
  static const char *const vega[] = {"U", "B", "V",  "R",  "I",  "J",  "H",  "K",  "L",  "M", "N",
                                     "Q", "G", "BP", "RP", "Rc", "Ic", "W1", "W2", "W3", "W4"};
  static const char *const ab[] = {"u", "g", "r", "i", "z", "y"};
  for (size_t i = 0; name != NULL && i < sizeof vega / sizeof *vega; i++)
    if (strcmp(name, vega[i]) == 0) return "vega";
  for (size_t i = 0; name != NULL && i < sizeof ab / sizeof *ab; i++)
    if (strcmp(name, ab[i]) == 0) return "ab";
  return NULL;
}

/* Behind the word at the beginning, else NULL. */
static const char *behind(const char *text, const char *word)
{
  size_t n = strlen(word);
  return strncasecmp(text, word, n) == 0 ? text + n : NULL;
}

bool um_compare_import_band(const char *column, char *out, size_t size)
{
  static const char *const before[] = {"magnitude_", "mag_", "m_", "mag"};
  static const char *const after[] = {"_magnitude", "_mag", "mag"};
  const char *from = column;
  for (size_t i = 0; i < sizeof before / sizeof *before; i++) {
    const char *rest = behind(column, before[i]);
    if (rest == NULL) continue;
    from = rest;
    break;
  }
  size_t n = strlen(from);
  for (size_t i = 0; i < sizeof after / sizeof *after; i++) {
    size_t k = strlen(after[i]);
    if (n < k || strcasecmp(from + n - k, after[i]) != 0) continue;
    n -= k;
    break;
  }
  bool plain = n > 0 && n < size && strcasecmp(from, "nitude") != 0;
  for (size_t i = 0; i < n; i++) plain = plain && strchr(" .,;:/()[]{}'\"\\$`", from[i]) == NULL;
  if (!plain) return false;
  memcpy(out, from, n);
  out[n] = '\0';
  return um_core_name_is_safe(out);
}

enum um_status um_compare_import_check(struct um_context *context, const struct um_core_csv *csv,
                                       size_t row, size_t column, enum um_compare_quantity quantity,
                                       double value)
{
  const char *text = um_core_csv_text(csv, row, column);
  if (um_compare_is_magnitude(quantity) && !(fabs(value) <= MAGNITUDE_MAX))
    return um_core_csv_fail(context, csv, row, column,
                            "magnitude %s mag; accepted: -40 to 40 mag, or empty", text);
  if (quantity == UM_QUANTITY_TEMPERATURE && !(value > 0.0))
    return um_core_csv_fail(context, csv, row, column,
                            "%s is %g K; accepted: above 0 K (--unit C where it is Celsius)", text,
                            value);
  return UM_OK;
}
