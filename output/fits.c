/* FITS: a header of cards of 80 characters, then big-endian numbers, both in blocks of 2880 bytes.
 * It is so little that no library is needed for it. */
#include "output/fits.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/core/file.h"

#define BLOCK 2880
#define CARD  80

struct writer {
  FILE *file;
  size_t bytes;
};

static void put(struct writer *w, const void *data, size_t bytes)
{
  (void)fwrite(data, 1, bytes, w->file);
  w->bytes += bytes;
}

static void put_card(struct writer *w, const char *text)
{
  char card[CARD + 1];
  snprintf(card, sizeof card, "%-80.80s", text);
  put(w, card, CARD);
}

static void fill(struct writer *w, char with)
{
  while (w->bytes % BLOCK != 0) put(w, &with, 1);
}

static void put_integer(struct writer *w, const char *key, int value)
{
  char text[CARD + 1];
  snprintf(text, sizeof text, "%-8.8s= %20d", key, value);
  put_card(w, text);
}

/* A text in quotes, those inside doubled, at least 8 characters; what is not ASCII becomes '?'. */
static void put_text(struct writer *w, const struct um_output_card *c)
{
  char inside[64], text[2 * CARD];
  size_t n = 0;
  for (const char *from = c->text; *from != '\0' && n + 3 < sizeof inside; from++) {
    inside[n++] = *from >= ' ' && *from <= '~' ? *from : '?';
    if (*from == '\'') inside[n++] = '\'';
  }
  inside[n] = '\0';
  snprintf(text, sizeof text, "%-8.8s= '%-8s' / %s", c->key, inside, c->comment);
  put_card(w, text);
}

static void put_header(struct writer *w, int width, int height, const struct um_output_card *cards,
                       size_t ncard)
{
  char text[2 * CARD];
  put_card(w, "SIMPLE  =                    T");
  put_integer(w, "BITPIX", -32);
  put_integer(w, "NAXIS", 2);
  put_integer(w, "NAXIS1", width);
  put_integer(w, "NAXIS2", height);
  for (size_t i = 0; i < ncard; i++) {
    if (cards[i].text != NULL) {
      put_text(w, &cards[i]);
      continue;
    }
    snprintf(text, sizeof text, "%-8.8s= %20.12G / %s", cards[i].key, cards[i].number,
             cards[i].comment);
    put_card(w, text);
  }
  put_card(w, "END");
  fill(w, ' ');
}

static void put_values(struct writer *w, const float *value, int width, int height)
{
  for (int y = height - 1; y >= 0; y--)
    for (int x = 0; x < width; x++) {
      uint32_t bits;
      memcpy(&bits, &value[(size_t)y * (size_t)width + (size_t)x], sizeof bits);
      const unsigned char big[] = {(unsigned char)(bits >> 24), (unsigned char)(bits >> 16),
                                   (unsigned char)(bits >> 8), (unsigned char)bits};
      put(w, big, sizeof big);
    }
  fill(w, '\0');
}

enum um_status um_output_write_fits(struct um_context *context, const float *value, int width,
                                    int height, const struct um_output_card *cards, size_t ncard,
                                    const char *path)
{
  struct um_core_whole_file whole;
  UM_TRY(um_core_whole_begin(context, path, &whole));
  struct writer w = {.file = whole.file};
  put_header(&w, width, height, cards, ncard);
  put_values(&w, value, width, height);
  return um_core_whole_end(context, &whole, UM_OK);
}
