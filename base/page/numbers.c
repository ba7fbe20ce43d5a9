/* The numbers of a page: arrays behind each other, packed (format.md). */
#include <math.h>
#include <string.h>
#include <zlib.h>

#include "base/core/json.h"
#include "base/page/page_impl.h"

#define ALIGN 8     /* [bytes] */
#define STEPS 65534 /* 65535 is NaN */

/* Bytes are written as they stand in memory. */
_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "numbers of pages are little-endian");

/* Describe the next array, up to its closing brace. */
static void begin(struct um_page *page, FILE *file, const char *type, size_t count)
{
  FILE *bytes = page->numbers.file;
  long at = ftell(bytes);
  for (; at % ALIGN != 0; at++) fputc(0, bytes);
  fprintf(page->arrays.file, "%s{\"type\": \"%s\", \"count\": %zu, \"at\": %ld",
          page->narray > 0 ? ",\n" : "", type, count, at);
  fprintf(file, "%zu", page->narray++);
}

static void end(struct um_page *page) { fputc('}', page->arrays.file); }

void um_page_put_doubles(struct um_page *page, FILE *file, const double *value, size_t count)
{
  begin(page, file, "f64", count);
  fwrite(value, sizeof *value, count, page->numbers.file);
  end(page);
}

void um_page_put_floats(struct um_page *page, FILE *file, const double *value, size_t count)
{
  begin(page, file, "f32", count);
  for (size_t i = 0; i < count; i++) {
    float f = (float)value[i];
    fwrite(&f, sizeof f, 1, page->numbers.file);
  }
  end(page);
}

void um_page_put_integers(struct um_page *page, FILE *file, const uint32_t *value, size_t count)
{
  begin(page, file, "u32", count);
  fwrite(value, sizeof *value, count, page->numbers.file);
  end(page);
}

void um_page_put_steps(struct um_page *page, FILE *file, const double *value, size_t count)
{
  double least = INFINITY, most = -INFINITY;
  for (size_t i = 0; i < count; i++) {
    if (!isfinite(value[i])) continue;
    least = fmin(least, value[i]);
    most = fmax(most, value[i]);
  }
  double scale = most > least ? (most - least) / STEPS : 1.0, offset = least <= most ? least : 0.0;
  begin(page, file, "u16", count);
  fprintf(page->arrays.file, ", \"scale\": %.9g, \"offset\": %.9g", scale, offset);
  for (size_t i = 0; i < count; i++) {
    uint16_t step = UINT16_MAX;
    if (isfinite(value[i])) step = (uint16_t)lround((value[i] - offset) / scale);
    fwrite(&step, sizeof step, 1, page->numbers.file);
  }
  end(page);
}

/* RFC 4648 */
static void put_base64(const unsigned char *byte, size_t n, FILE *file)
{
  static const char letter[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (size_t i = 0; i < n; i += 3) {
    size_t left = n - i;
    uint32_t group = (uint32_t)byte[i] << 16;
    if (left > 1) group |= (uint32_t)byte[i + 1] << 8;
    if (left > 2) group |= byte[i + 2];
    fputc(letter[group >> 18 & 63], file);
    fputc(letter[group >> 12 & 63], file);
    fputc(left > 1 ? letter[group >> 6 & 63] : '=', file);
    fputc(left > 2 ? letter[group & 63] : '=', file);
  }
}

enum um_status um_page_write_packed(struct um_context *context, const char *bytes, size_t n,
                                    FILE *file)
{
  unsigned char *packed = NULL;
  uLongf length = compressBound((uLong)n);
  UM_TRY(um_core_allocate(context, length, 1, &packed));
  int code = compress2(packed, &length, (const Bytef *)bytes, (uLong)n, Z_BEST_COMPRESSION);
  if (code == Z_OK) put_base64(packed, length, file);
  um_core_free(context, packed);
  return code == Z_OK ? UM_OK : um_core_fail(context, UM_ERR_LIBRARY, "zlib: code %d", code);
}

void um_page_plain_picture(FILE *file, const char *path)
{
  unsigned char buffer[3 * 4096];
  size_t n;
  FILE *picture = fopen(path, "rb");
  if (picture == NULL) return;
  fputs("<p><img alt=\"\" src=\"data:image/svg+xml;base64,", file);
  while ((n = fread(buffer, 1, sizeof buffer, picture)) > 0) put_base64(buffer, n, file);
  fputs("\"></p>\n", file);
  (void)fclose(picture);
}
