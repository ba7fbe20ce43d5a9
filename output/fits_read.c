/* Pictures of FITS, and what stands in their headers: cards of 80 characters. */
#include <math.h>
#include <string.h>

#include "base/core/file.h"
#include "base/core/number.h"
#include "output/fits.h"
#include "output/fits_library.h"

#define CARD  80
#define BYTES ((size_t)1 << 30) /* of a file */

static const char *card_of(const struct um_output_fits *f, const char *key)
{
  char name[9];
  snprintf(name, sizeof name, "%-8.8s", key);
  for (size_t i = 0; i < f->ncard; i++) {
    const char *card = f->header + i * CARD;
    if (strncmp(card, name, 8) == 0 && card[8] == '=') return card;
  }
  return NULL;
}

/* The value of a card as a text of its own: behind "= ", before the comment. */
static void value_of(const char *card, char out[72])
{
  size_t n = 0;
  const char *at = card + 9, *end = card + CARD;
  while (at < end && *at == ' ') at++;
  bool quoted = at < end && *at == '\'';
  if (quoted) at++;
  for (; at < end && n < 71; at++) {
    if (quoted && *at == '\'') {
      if (at + 1 >= end || at[1] != '\'') break;
      at++; /* two for one */
    }
    if (!quoted && *at == '/') break;
    out[n++] = *at;
  }
  while (n > 0 && out[n - 1] == ' ') n--;
  out[n] = '\0';
}

double um_output_fits_number(const struct um_output_fits *fits, const char *key)
{
  const char *card = card_of(fits, key);
  char text[72];
  double value;
  if (card == NULL) return NAN;
  value_of(card, text);
  for (char *c = text; *c != '\0'; c++)
    if (*c == 'D' || *c == 'd') *c = 'E'; /* Fortran's double */
  return um_core_number_parse(text, &value) ? value : (double)NAN;
}

void um_output_fits_text(const struct um_output_fits *fits, const char *key, char out[72])
{
  const char *card = card_of(fits, key);
  out[0] = '\0';
  if (card != NULL) value_of(card, out);
}

enum um_status um_output_read_fits(struct um_context *context, const char *path,
                                   struct um_output_fits **out)
{
  enum um_status status;
  struct um_output_fits *f = NULL;
  struct um_output_fits_picture picture = {0};
  char *bytes = NULL;
  size_t size;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *f, &f));
  UM_CHECK(um_core_strdup(context, path, &f->path));
  UM_CHECK(um_core_file_read(context, path, BYTES, &bytes, &size));
  status = um_output_fits_picture(context, path, bytes, size, &picture);
  f->width = picture.width;
  f->height = picture.height;
  f->value = picture.value;
  f->header = picture.header;
  f->ncard = picture.ncard;
  UM_CHECK(status);
  *out = f;
  f = NULL;
done:
  um_core_free(context, bytes);
  um_output_fits_destroy(context, &f);
  return status;
}

void um_output_fits_destroy(struct um_context *context, struct um_output_fits **fits)
{
  if (*fits == NULL) return;
  UM_FREE(context, (*fits)->path, (*fits)->value, (*fits)->header, *fits);
  *fits = NULL;
}
