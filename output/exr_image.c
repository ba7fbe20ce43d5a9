/* Spectral image as OpenEXR, one channel per wavelength in the layout of Fichet, Pacanowski &
 * Wilkie 2021 (JCGT 10:3): "S0.<nm with a decimal comma>nm" [W/m^2/sr/nm], and R, G, B for viewers:
 * the means of the longest, middle and shortest third of the wavelengths, 1 being what a hundredth
 * of the picture exceeds. A tile's data window tells where it lies in the whole. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "output/exr.h"
#include "output/exr_impl.h"

#define NM_PER_M 1e9
#define QUANTILE 0.99
#define DARKEST  1e-8 /* a hundredth of the darkest night sky [W/m^2/sr/m]: black is black */
#define PREVIEW  3    /* R, G, B */
#define NAME     48   /* [bytes] of a channel's */

struct source {
  const struct um_optics_image *image;
  struct um_output_cut cut;
  double (*preview[PREVIEW])[2]; /* [nspectrum], scaled */
  double white;                  /* radiance that is 1 in the preview [W/m^2/sr/m] */
};

struct um_output_cut um_output_cut_whole(const struct um_optics_image *image)
{
  return (struct um_output_cut){
      .width = image->width, .height = image->height, .nbin = image->nbin};
}

/* Weights of the three channels: means over thirds of the cut, R the longest wavelengths. */
static enum um_status preview_create(struct um_context *context, struct source *s)
{
  const struct um_optics_image *image = s->image;
  size_t n = s->cut.nbin;
  double *weight = NULL, white;
  enum um_status status;
  UM_TRY(um_core_allocate(context, image->nbin, sizeof *weight, &weight));
  for (size_t c = 0; c < PREVIEW; c++)
    UM_CHECK(um_core_allocate(context, image->nspectrum, sizeof *s->preview[c], &s->preview[c]));
  for (size_t b = 0; b < n; b++) weight[s->cut.bin + b] = 1.0 / (double)n;
  um_optics_image_weigh(image, weight, s->preview[0]);
  UM_CHECK(um_optics_image_quantile(context, image, (const double(*)[2])s->preview[0], QUANTILE,
                                    &white));
  s->white = fmax(white, DARKEST);
  for (size_t c = 0; c < PREVIEW; c++) {
    size_t third = PREVIEW - 1 - c, from = n < PREVIEW ? 0 : third * n / PREVIEW;
    size_t to = n < PREVIEW ? n : (third + 1) * n / PREVIEW;
    memset(weight, 0, image->nbin * sizeof *weight);
    for (size_t b = from; b < to; b++)
      weight[s->cut.bin + b] = 1.0 / (s->white * (double)(to - from));
    um_optics_image_weigh(image, weight, s->preview[c]);
  }
done:
  um_core_free(context, weight);
  return status;
}

/* Line of every plane, expanded from the factored picture: R, G, B, then the bins. */
static void row(const void *self, int y, float *value)
{
  const struct source *s = self;
  const struct um_output_cut *cut = &s->cut;
  size_t stride = PREVIEW + cut->nbin;
  const struct um_optics_image_span span = {y, cut->x, cut->width, cut->bin, cut->nbin, stride};
  um_optics_image_expand(s->image, &span, value + PREVIEW);
  for (int x = 0; x < cut->width; x++) {
    float *to = value + (size_t)x * stride;
    for (size_t b = 0; b < cut->nbin; b++) to[PREVIEW + b] /= (float)NM_PER_M;
    for (size_t c = 0; c < PREVIEW; c++)
      to[c] =
          (float)um_optics_image_pixel(s->image, (const double(*)[2])s->preview[c], cut->x + x, y);
  }
}

static void fill_names(const struct source *s, char *text, char **name)
{
  for (size_t i = 0; i < PREVIEW + s->cut.nbin; i++) {
    name[i] = text + i * NAME;
    if (i < PREVIEW) {
      name[i][0] = "RGB"[i];
      continue;
    }
    snprintf(name[i], NAME, "S0.%.3fnm", s->image->wavelength[s->cut.bin + i - PREVIEW] * NM_PER_M);
    *strchr(name[i] + 3, '.') = ',';
  }
}

static enum um_status write_source(struct um_context *context, const struct source *s, char **name,
                                   const char *path)
{
  const struct um_output_cut *cut = &s->cut;
  const char *const text[][2] = {{"spectralLayoutVersion", "1.0"},
                                 {"emissiveUnits", "W.m^-2.sr^-1.nm^-1"},
                                 {"comments", cut->comments}};
  static const char *const names[] = {"pixelSizeM", "previewWhite"};
  const double number[] = {s->image->pixel_size, s->white / NM_PER_M};
  const struct um_output_planes planes = {.whole_width = s->image->width,
                                          .whole_height = s->image->height,
                                          .x = cut->x,
                                          .y = cut->y,
                                          .width = cut->width,
                                          .height = cut->height,
                                          .part = "spectrum",
                                          .nplane = PREVIEW + cut->nbin,
                                          .name = name,
                                          .row = row,
                                          .self = s,
                                          .ntext = cut->comments[0] != '\0' ? 3 : 2,
                                          .text = text,
                                          .nnumber = 2,
                                          .number_name = names,
                                          .number = number};
  return um_output_write_planes(context, &planes, path);
}

enum um_status um_output_write_exr(struct um_context *context, const struct um_optics_image *image,
                                   const struct um_output_cut *cut, const char *path)
{
  enum um_status status;
  struct source s = {.image = image, .cut = cut != NULL ? *cut : um_output_cut_whole(image)};
  char *names = NULL, **name = NULL;
  UM_CHECK(preview_create(context, &s));
  UM_CHECK(um_core_allocate(context, PREVIEW + s.cut.nbin, NAME, &names));
  UM_CHECK(um_core_allocate(context, PREVIEW + s.cut.nbin, sizeof *name, &name));
  fill_names(&s, names, name);
  UM_CHECK(write_source(context, &s, name, path));
done:
  for (size_t c = 0; c < PREVIEW; c++) um_core_free(context, s.preview[c]);
  UM_FREE(context, names, name);
  return status;
}
