/* Reading a factored picture: radiances of pixels, sums over bins. */
#include <stdlib.h>
#include <string.h>

#include "optics/image/image.h"

const struct um_optics_image_share *um_optics_image_shares(const struct um_optics_image *image,
                                                           int x, int y, size_t *count)
{
  const struct um_optics_image_row *row = &image->row[y];
  uint32_t at = (uint32_t)x - row->from;
  *count = 0;
  if ((uint32_t)x < row->from || at >= row->count) return NULL;
  *count = row->first[at + 1] - row->first[at];
  return row->share + row->first[at];
}

bool um_optics_image_covered(const struct um_optics_image *image, int x, int y)
{
  size_t n;
  const struct um_optics_image_share *share = um_optics_image_shares(image, x, y, &n);
  int seen = 0;
  for (size_t i = 0; i < n; i++) seen += share[i].seen;
  return seen > 0 && 2 * seen >= image->samples;
}

void um_optics_image_expand(const struct um_optics_image *image,
                            const struct um_optics_image_span *span, float *out)
{
  float scale = 1.0F / (float)image->samples;
  for (int i = 0; i < span->count; i++) {
    float *to = out + (size_t)i * span->stride;
    size_t n;
    const struct um_optics_image_share *share =
        um_optics_image_shares(image, span->from + i, span->y, &n);
    memset(to, 0, span->nbin * sizeof *to);
    for (size_t k = 0; k < n; k++) {
      size_t at = share[k].spectrum * image->nbin + span->bin;
      const float *dark = image->dark + at, *sun = image->sun + at;
      float seen = scale * (float)share[k].seen, lit = scale * (float)share[k].lit;
      for (size_t b = 0; b < span->nbin; b++) to[b] += seen * dark[b] + lit * sun[b];
    }
  }
}

void um_optics_image_weigh(const struct um_optics_image *image, const double *weight,
                           double (*out)[2])
{
  for (size_t s = 0; s < image->nspectrum; s++) {
    const float *dark = image->dark + s * image->nbin, *sun = image->sun + s * image->nbin;
    out[s][0] = out[s][1] = 0.0;
    for (size_t b = 0; b < image->nbin; b++) {
      out[s][0] += weight[b] * (double)dark[b];
      out[s][1] += weight[b] * (double)sun[b];
    }
  }
}

double um_optics_image_pixel(const struct um_optics_image *image, const double (*weighed)[2], int x,
                             int y)
{
  size_t n;
  const struct um_optics_image_share *share = um_optics_image_shares(image, x, y, &n);
  double sum = 0.0;
  for (size_t k = 0; k < n; k++)
    sum += share[k].seen * weighed[share[k].spectrum][0] +
           share[k].lit * weighed[share[k].spectrum][1];
  return sum / image->samples;
}

/* A value and how many samples have it. */
struct level {
  double value, count;
};

static int by_value(const void *a, const void *b)
{
  const struct level *x = a, *y = b;
  return (x->value > y->value) - (x->value < y->value);
}

enum um_status um_optics_image_quantile(struct um_context *context,
                                        const struct um_optics_image *image,
                                        const double (*weighed)[2], double q, double *out)
{
  size_t n = 2 * image->nspectrum;
  struct level *level = NULL;
  double total = 0.0, below = 0.0;
  *out = 0.0;
  UM_TRY(um_core_allocate(context, n, sizeof *level, &level));
  for (size_t s = 0; s < image->nspectrum; s++) {
    level[2 * s].value = weighed[s][0];
    level[2 * s + 1].value = weighed[s][0] + weighed[s][1];
  }
  for (int y = 0; y < image->height; y++) {
    const struct um_optics_image_row *row = &image->row[y];
    for (uint32_t i = 0; row->count > 0 && i < row->first[row->count]; i++) {
      const struct um_optics_image_share *share = &row->share[i];
      level[2 * share->spectrum].count += share->seen - share->lit;
      level[2 * share->spectrum + 1].count += share->lit;
      total += share->seen;
    }
  }
  qsort(level, n, sizeof *level, by_value);
  for (size_t i = 0; i < n && below < q * total; i++) {
    below += level[i].count;
    *out = level[i].value;
  }
  um_core_free(context, level);
  return UM_OK;
}
