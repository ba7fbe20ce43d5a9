/* FITS read by the standard's own words (Pence et al. 2010, A&A 524:A42): cards of 80 characters up
 * to END, big-endian numbers behind the next block of 2880 bytes. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/file.h"
#include "base/core/number.h"
#include "output/fits.h"

#define BLOCK 2880
#define CARD  80
#define SIDE  8192
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

static enum um_status refuse(struct um_context *context, const struct um_output_fits *f,
                             const char *what)
{
  return um_core_fail(context, UM_ERR_INPUT, "%s: %s", f->path, what);
}

/* The header, and where the numbers begin. */
static enum um_status read_header(struct um_context *context, const char *bytes, size_t size,
                                  struct um_output_fits *f, size_t *data)
{
  static const char first[] = "SIMPLE  =";
  if (size < CARD || memcmp(bytes, first, sizeof first - 1) != 0)
    return refuse(context, f, "is no FITS file: it does not begin with SIMPLE");
  size_t end = 0;
  while ((end + 1) * CARD <= size && memcmp(bytes + end * CARD, "END     ", 8) != 0) end++;
  if ((end + 1) * CARD > size) return refuse(context, f, "its header has no END");
  *data = ((end + 1) * CARD + BLOCK - 1) / BLOCK * BLOCK;
  UM_TRY(um_core_allocate(context, end * CARD, 1, &f->header));
  memcpy(f->header, bytes, end * CARD);
  f->ncard = end;
  return UM_OK;
}

/* Length of an axis. */
static enum um_status axis(struct um_context *context, const struct um_output_fits *f,
                           const char *key, int *out)
{
  double n = um_output_fits_number(f, key);
  if (!(n >= 1.0 && n <= SIDE) || n != floor(n))
    return um_core_fail(context, UM_ERR_INPUT, "%s: %s = %g; accepted: 1 to %d", f->path, key, n,
                        SIDE);
  *out = (int)n;
  return UM_OK;
}

static enum um_status read_axes(struct um_context *context, struct um_output_fits *f)
{
  double n = um_output_fits_number(f, "NAXIS");
  if (!(n >= 2.0 && n <= 9.0))
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: NAXIS = %g; accepted: a picture of two axes in the first part of the "
                        "file",
                        f->path, n);
  for (int i = 3; i <= (int)n; i++) {
    char key[24];
    snprintf(key, sizeof key, "NAXIS%d", i);
    if (um_output_fits_number(f, key) != 1.0)
      return refuse(context, f, "has more than two axes; accepted: one picture");
  }
  UM_TRY(axis(context, f, "NAXIS1", &f->width));
  return axis(context, f, "NAXIS2", &f->height);
}

/* One number of `size` bytes, big-endian. */
static double number_at(const unsigned char *b, int bitpix)
{
  uint64_t bits = 0;
  int size = abs(bitpix) / 8;
  float f;
  double d;
  for (int i = 0; i < size; i++) bits = bits << 8 | b[i];
  switch (bitpix) {
  case 8:
    return (double)bits;
  case 16:
    return (double)(int16_t)(uint16_t)bits;
  case 32:
    return (double)(int32_t)(uint32_t)bits;
  case -32: {
    uint32_t half = (uint32_t)bits;
    memcpy(&f, &half, sizeof f);
    return (double)f;
  }
  default:
    memcpy(&d, &bits, sizeof d);
    return d;
  }
}

static enum um_status read_values(struct um_context *context, const char *bytes, size_t size,
                                  size_t data, struct um_output_fits *f)
{
  double kind = um_output_fits_number(f, "BITPIX"), scale = um_output_fits_number(f, "BSCALE");
  double zero = um_output_fits_number(f, "BZERO"), blank = um_output_fits_number(f, "BLANK");
  size_t n = (size_t)f->width * (size_t)f->height;
  int bitpix =
      kind == 8.0 || kind == 16.0 || kind == 32.0 || kind == -32.0 || kind == -64.0 ? (int)kind : 0;
  if (bitpix == 0)
    return um_core_fail(context, UM_ERR_INPUT, "%s: BITPIX = %g; accepted: 8, 16, 32, -32, -64",
                        f->path, kind);
  size_t each = (size_t)abs(bitpix) / 8;
  if (data > size || size - data < n * each)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: ends before its %d x %d pixels; accepted: a whole file", f->path,
                        f->width, f->height);
  if (isnan(scale)) scale = 1.0;
  if (isnan(zero)) zero = 0.0;
  UM_TRY(um_core_allocate(context, n, sizeof *f->value, &f->value));
  for (size_t i = 0; i < n; i++) {
    double v = number_at((const unsigned char *)bytes + data + i * each, bitpix);
    bool none = bitpix > 0 && v == blank;
    f->value[i] = none ? NAN : (float)(zero + scale * v);
  }
  return UM_OK;
}

enum um_status um_output_read_fits(struct um_context *context, const char *path,
                                   struct um_output_fits **out)
{
  enum um_status status;
  struct um_output_fits *f = NULL;
  char *bytes = NULL;
  size_t size, data = 0;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *f, &f));
  UM_CHECK(um_core_strdup(context, path, &f->path));
  UM_CHECK(um_core_file_read(context, path, BYTES, &bytes, &size));
  UM_CHECK(read_header(context, bytes, size, f, &data));
  UM_CHECK(read_axes(context, f));
  UM_CHECK(read_values(context, bytes, size, data, f));
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
