/* Spectral image as OpenEXR, one channel per wavelength in the layout of Fichet, Pacanowski &
 * Wilkie 2021 (JCGT 10:3): "S0.<nm with a decimal comma>nm", and R, G, B as a grey preview scaled
 * to its maximum. Values are spectral radiance [W/m^2/sr/nm]. */
#include <math.h>
#include <openexr.h>
#include <stdlib.h>
#include <string.h>

#include "output/output.h"

#define NM_PER_M 1e9

struct exr {
  struct um_context *context;
  const char *path;
  exr_context_t file;
  int part;
  size_t nchannel;
};

static enum um_status check(const struct exr *e, exr_result_t code)
{
  if (code == EXR_ERR_SUCCESS) return UM_OK;
  return um_core_fail(e->context, UM_ERR_IO, "%s: OpenEXR: %s", e->path,
                      exr_get_default_error_message(code));
}

/* Errors come back as codes; the library is not to print. */
static void silent(exr_const_context_t file, exr_result_t code, const char *message)
{
  (void)file;
  (void)code;
  (void)message;
}

static enum um_status describe(struct exr *e, const struct um_optics_image *image)
{
  UM_TRY(check(e, exr_add_part(e->file, "spectrum", EXR_STORAGE_SCANLINE, &e->part)));
  UM_TRY(check(e, exr_initialize_required_attr_simple(e->file, e->part, image->width, image->height,
                                                      EXR_COMPRESSION_ZIPS)));
  UM_TRY(check(e, exr_attr_set_string(e->file, e->part, "spectralLayoutVersion", "1.0")));
  UM_TRY(check(e, exr_attr_set_string(e->file, e->part, "emissiveUnits", "W.m^-2.sr^-1.nm^-1")));
  UM_TRY(check(e, exr_attr_set_double(e->file, e->part, "pixelSizeM", image->pixel_size)));
  for (int c = 0; c < 3; c++)
    UM_TRY(check(e, exr_add_channel(e->file, e->part, &"R\0G\0B"[2 * c], EXR_PIXEL_FLOAT,
                                    EXR_PERCEPTUALLY_LINEAR, 1, 1)));
  for (size_t b = 0; b < image->nbin; b++) {
    char name[48];
    snprintf(name, sizeof name, "S0.%.3fnm", image->wavelength[b] * NM_PER_M);
    *strchr(name + 3, '.') = ',';
    UM_TRY(check(e, exr_add_channel(e->file, e->part, name, EXR_PIXEL_FLOAT,
                                    EXR_PERCEPTUALLY_LINEAR, 1, 1)));
  }
  return check(e, exr_write_header(e->file));
}

/* Channels are stored sorted by name, so that each is found again by the wavelength in its name:
 * planes are R, G, B, then the bins. */
static size_t plane_of(const struct um_optics_image *image, const char *name)
{
  static const char preview[] = "RGB";
  char text[48];
  size_t nearest = 0;
  if (name[1] == '\0') return (size_t)(strchr(preview, name[0]) - preview);
  snprintf(text, sizeof text, "%s", name + 3); /* behind "S0." */
  char *comma = strchr(text, ',');
  if (comma != NULL) *comma = '.';
  double nm = strtod(text, NULL);
  for (size_t b = 1; b < image->nbin; b++)
    if (fabs(image->wavelength[b] * NM_PER_M - nm) <
        fabs(image->wavelength[nearest] * NM_PER_M - nm))
      nearest = b;
  return 3 + nearest;
}

static float band_sum(const struct um_optics_image *image, size_t pixel)
{
  float sum = 0.0f;
  for (size_t b = 0; b < image->nbin; b++) sum += image->radiance[pixel * image->nbin + b];
  return sum;
}

/* One row of every plane. */
static void fill_planes(const struct um_optics_image *image, int y, float largest, float *plane)
{
  size_t w = (size_t)image->width, n = image->nbin;
  for (size_t x = 0; x < w; x++) {
    size_t pixel = (size_t)y * w + x;
    for (size_t b = 0; b < n; b++)
      plane[(3 + b) * w + x] = image->radiance[pixel * n + b] / (float)NM_PER_M;
    for (size_t c = 0; c < 3; c++)
      plane[c * w + x] = largest > 0.0f ? band_sum(image, pixel) / largest : 0.0f;
  }
}

static void point_channels(const struct um_optics_image *image, const float *plane,
                           exr_encode_pipeline_t *encoder)
{
  size_t w = (size_t)image->width;
  for (int c = 0; c < encoder->channel_count; c++) {
    exr_coding_channel_info_t *channel = &encoder->channels[c];
    const float *from = plane + plane_of(image, channel->channel_name) * w;
    channel->encode_from_ptr = (const uint8_t *)from;
    channel->user_pixel_stride = sizeof(float);
    channel->user_line_stride = (int32_t)(w * sizeof(float));
    channel->user_bytes_per_element = sizeof(float);
    channel->user_data_type = EXR_PIXEL_FLOAT;
  }
}

static enum um_status write_rows(struct exr *e, const struct um_optics_image *image)
{
  enum um_status status = UM_OK;
  float *plane = NULL, largest = 0.0f;
  exr_encode_pipeline_t encoder = EXR_ENCODE_PIPELINE_INITIALIZER;
  for (size_t i = 0; i < (size_t)image->width * (size_t)image->height; i++)
    largest = fmaxf(largest, band_sum(image, i));
  UM_TRY(um_core_allocate(e->context, (image->nbin + 3) * (size_t)image->width, sizeof *plane,
                          &plane));
  for (int y = 0; y < image->height; y++) {
    exr_chunk_info_t chunk;
    fill_planes(image, y, largest, plane);
    UM_CHECK(check(e, exr_write_scanline_chunk_info(e->file, e->part, y, &chunk)));
    UM_CHECK(check(e, y == 0 ? exr_encoding_initialize(e->file, e->part, &chunk, &encoder)
                             : exr_encoding_update(e->file, e->part, &chunk, &encoder)));
    point_channels(image, plane, &encoder);
    if (y == 0)
      UM_CHECK(check(e, exr_encoding_choose_default_routines(e->file, e->part, &encoder)));
    UM_CHECK(check(e, exr_encoding_run(e->file, e->part, &encoder)));
  }
done:
  exr_encoding_destroy(e->file, &encoder);
  um_core_free(e->context, plane);
  return status;
}

enum um_status um_output_write_exr(struct um_context *context, const struct um_optics_image *image,
                                   const char *path)
{
  struct exr e = {.context = context, .path = path};
  exr_context_initializer_t start = EXR_DEFAULT_CONTEXT_INITIALIZER;
  enum um_status status;
  start.error_handler_fn = silent;
  UM_TRY(check(&e, exr_start_write(&e.file, path, EXR_INTERMEDIATE_TEMP_FILE, &start)));
  UM_CHECK(describe(&e, image));
  UM_CHECK(write_rows(&e, image));
done:;
  enum um_status closed = check(&e, exr_finish(&e.file));
  return status != UM_OK ? status : closed;
}
