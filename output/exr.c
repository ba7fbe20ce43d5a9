/* Spectral image as OpenEXR, one channel per wavelength in the layout of Fichet, Pacanowski &
 * Wilkie 2021 (JCGT 10:3): "S0.<nm with a decimal comma>nm" [W/m^2/sr/nm], and R, G, B for viewers:
 * the means of the longest, middle and shortest third of the wavelengths, 1 being what a hundredth
 * of the lit picture exceeds. A tile's data window tells where it lies in the whole.
 *
 * Lines are expanded from the factored picture as they are written, some at a time: packed and
 * compressed in threads, then written in order. */
#include <math.h>
#include <openexr.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "output/exr.h"

#define NM_PER_M 1e9
#define QUANTILE 0.99
#define PREVIEW  3 /* R, G, B */

struct exr {
  struct um_context *context;
  const char *path;
  const struct um_optics_image *image;
  struct um_output_cut cut;
  exr_context_t file;
  int part;
  double (*preview[PREVIEW])[2]; /* [nspectrum], scaled */
  double white;                  /* radiance that is 1 in the preview [W/m^2/sr/m] */
  size_t *plane;                 /* [channels of the file, sorted by name] which of ours each is */
};

/* One line on its way. */
struct line {
  int y;
  float *value; /* [width][PREVIEW + nbin] */
  exr_encode_pipeline_t encoder;
  exr_result_t (*write)(exr_encode_pipeline_t *);
  exr_result_t code;
  bool ready; /* the encoder is */
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

struct um_output_cut um_output_cut_whole(const struct um_optics_image *image)
{
  return (struct um_output_cut){
      .width = image->width, .height = image->height, .nbin = image->nbin};
}

/* Weights of the three channels: means over thirds of the cut, R the longest wavelengths. */
static enum um_status preview_create(struct exr *e)
{
  const struct um_optics_image *image = e->image;
  size_t n = e->cut.nbin;
  double *weight = NULL, white;
  enum um_status status;
  UM_TRY(um_core_allocate(e->context, image->nbin, sizeof *weight, &weight));
  for (size_t c = 0; c < PREVIEW; c++)
    UM_CHECK(um_core_allocate(e->context, image->nspectrum, sizeof *e->preview[c], &e->preview[c]));
  for (size_t b = 0; b < n; b++) weight[e->cut.bin + b] = 1.0 / (double)n;
  um_optics_image_weigh(image, weight, e->preview[0]);
  UM_CHECK(um_optics_image_quantile(e->context, image, (const double(*)[2])e->preview[0], QUANTILE,
                                    &white));
  e->white = white;
  for (size_t c = 0; c < PREVIEW; c++) {
    size_t third = PREVIEW - 1 - c, from = n < PREVIEW ? 0 : third * n / PREVIEW;
    size_t to = n < PREVIEW ? n : (third + 1) * n / PREVIEW;
    memset(weight, 0, image->nbin * sizeof *weight);
    for (size_t b = from; b < to && white > 0.0; b++)
      weight[e->cut.bin + b] = 1.0 / (white * (double)(to - from));
    um_optics_image_weigh(image, weight, e->preview[c]);
  }
done:
  um_core_free(e->context, weight);
  return status;
}

static enum um_status describe_window(struct exr *e)
{
  const struct um_output_cut *cut = &e->cut;
  exr_attr_box2i_t whole, data;
  exr_attr_v2f_t centre;
  whole.min.x = whole.min.y = 0;
  whole.max.x = e->image->width - 1;
  whole.max.y = e->image->height - 1;
  data.min.x = cut->x;
  data.min.y = cut->y;
  data.max.x = cut->x + cut->width - 1;
  data.max.y = cut->y + cut->height - 1;
  centre.x = centre.y = 0.0F;
  UM_TRY(check(e, exr_add_part(e->file, "spectrum", EXR_STORAGE_SCANLINE, &e->part)));
  return check(e, exr_initialize_required_attr(e->file, e->part, &whole, &data, 1.0F, &centre, 1.0F,
                                               EXR_LINEORDER_INCREASING_Y, EXR_COMPRESSION_ZIPS));
}

static enum um_status describe(struct exr *e)
{
  const struct um_optics_image *image = e->image;
  UM_TRY(describe_window(e));
  UM_TRY(check(e, exr_attr_set_string(e->file, e->part, "spectralLayoutVersion", "1.0")));
  UM_TRY(check(e, exr_attr_set_string(e->file, e->part, "emissiveUnits", "W.m^-2.sr^-1.nm^-1")));
  UM_TRY(check(e, exr_attr_set_double(e->file, e->part, "pixelSizeM", image->pixel_size)));
  UM_TRY(check(e, exr_attr_set_double(e->file, e->part, "previewWhite", e->white / NM_PER_M)));
  if (e->cut.comments[0] != '\0')
    UM_TRY(check(e, exr_attr_set_string(e->file, e->part, "comments", e->cut.comments)));
  for (int c = 0; c < PREVIEW; c++)
    UM_TRY(check(e, exr_add_channel(e->file, e->part, &"R\0G\0B"[2 * c], EXR_PIXEL_FLOAT,
                                    EXR_PERCEPTUALLY_LINEAR, 1, 1)));
  for (size_t b = 0; b < e->cut.nbin; b++) {
    char name[48];
    snprintf(name, sizeof name, "S0.%.3fnm", image->wavelength[e->cut.bin + b] * NM_PER_M);
    *strchr(name + 3, '.') = ',';
    UM_TRY(check(e, exr_add_channel(e->file, e->part, name, EXR_PIXEL_FLOAT,
                                    EXR_PERCEPTUALLY_LINEAR, 1, 1)));
  }
  return check(e, exr_write_header(e->file));
}

/* Channels are stored sorted by name, so that each is found again by the wavelength in its name:
 * planes are R, G, B, then the bins. */
static size_t plane_of(const struct exr *e, const char *name)
{
  static const char preview[] = "RGB";
  const double *wavelength = e->image->wavelength + e->cut.bin;
  char text[48];
  size_t nearest = 0;
  if (name[1] == '\0') return (size_t)(strchr(preview, name[0]) - preview);
  snprintf(text, sizeof text, "%s", name + 3); /* behind "S0." */
  char *comma = strchr(text, ',');
  if (comma != NULL) *comma = '.';
  double nm = strtod(text, NULL);
  for (size_t b = 1; b < e->cut.nbin; b++)
    if (fabs(wavelength[b] * NM_PER_M - nm) < fabs(wavelength[nearest] * NM_PER_M - nm))
      nearest = b;
  return PREVIEW + nearest;
}

static enum um_status find_planes(struct exr *e)
{
  const exr_attr_chlist_t *channels = NULL;
  UM_TRY(check(e, exr_get_channels(e->file, e->part, &channels)));
  UM_TRY(um_core_allocate(e->context, (size_t)channels->num_channels, sizeof *e->plane, &e->plane));
  for (int c = 0; c < channels->num_channels; c++)
    e->plane[c] = plane_of(e, channels->entries[c].name.str);
  return UM_OK;
}

static void fill(const struct exr *e, const struct line *line)
{
  const struct um_output_cut *cut = &e->cut;
  size_t stride = PREVIEW + cut->nbin;
  const struct um_optics_image_span span = {line->y,  cut->x,    cut->width,
                                            cut->bin, cut->nbin, stride};
  um_optics_image_expand(e->image, &span, line->value + PREVIEW);
  for (int x = 0; x < cut->width; x++) {
    float *to = line->value + (size_t)x * stride;
    for (size_t b = 0; b < cut->nbin; b++) to[PREVIEW + b] /= (float)NM_PER_M;
    for (size_t c = 0; c < PREVIEW; c++)
      to[c] = (float)um_optics_image_pixel(e->image, (const double(*)[2])e->preview[c], cut->x + x,
                                           line->y);
  }
}

static void point_channels(const struct exr *e, struct line *line)
{
  size_t stride = PREVIEW + e->cut.nbin;
  for (int c = 0; c < line->encoder.channel_count; c++) {
    exr_coding_channel_info_t *channel = &line->encoder.channels[c];
    channel->encode_from_ptr = (const uint8_t *)(line->value + e->plane[c]);
    channel->user_pixel_stride = (int32_t)(stride * sizeof(float));
    channel->user_line_stride = (int32_t)(stride * sizeof(float)) * e->cut.width;
    channel->user_bytes_per_element = sizeof(float);
    channel->user_data_type = EXR_PIXEL_FLOAT;
  }
}

/* Everything of a line but its writing. */
static exr_result_t pack(const struct exr *e, struct line *line)
{
  exr_chunk_info_t chunk;
  fill(e, line);
  exr_result_t code = exr_write_scanline_chunk_info(e->file, e->part, line->y, &chunk);
  if (code != EXR_ERR_SUCCESS) return code;
  code = line->ready ? exr_encoding_update(e->file, e->part, &chunk, &line->encoder)
                     : exr_encoding_initialize(e->file, e->part, &chunk, &line->encoder);
  if (code != EXR_ERR_SUCCESS) return code;
  point_channels(e, line);
  if (!line->ready) {
    line->ready = true;
    code = exr_encoding_choose_default_routines(e->file, e->part, &line->encoder);
    if (code != EXR_ERR_SUCCESS) return code;
    line->write = line->encoder.write_fn;
    line->encoder.write_fn = NULL; /* and nobody waits for its turn */
    line->encoder.yield_until_ready_fn = NULL;
  }
  return exr_encoding_run(e->file, e->part, &line->encoder);
}

static enum um_status write_block(struct exr *e, struct line *line, int y, int count)
{
#pragma omp parallel for schedule(static, 1) num_threads(um_core_context_threads(e->context))
  for (int i = 0; i < count; i++) {
    line[i].y = y + i;
    line[i].code = pack(e, &line[i]);
  }
  for (int i = 0; i < count; i++) {
    UM_TRY(check(e, line[i].code));
    UM_TRY(check(e, line[i].write(&line[i].encoder)));
  }
  UM_TRY(um_core_progress_step(e->context, (size_t)count));
  return um_core_stop_check(e->context, "a picture was written");
}

static enum um_status write_lines(struct exr *e)
{
  enum um_status status;
  const struct um_output_cut *cut = &e->cut;
  int n = um_core_context_threads(e->context);
  struct line *line = NULL;
  UM_TRY(um_core_allocate(e->context, (size_t)n, sizeof *line, &line));
  um_core_progress_begin(e->context, "writing the picture", (size_t)cut->height);
  for (int i = 0; i < n; i++) {
    line[i].encoder = (exr_encode_pipeline_t)EXR_ENCODE_PIPELINE_INITIALIZER;
    UM_CHECK(um_core_allocate(e->context, (size_t)cut->width * (PREVIEW + cut->nbin), sizeof(float),
                              &line[i].value));
  }
  for (int y = 0; y < cut->height; y += n)
    UM_CHECK(write_block(e, line, cut->y + y, cut->height - y < n ? cut->height - y : n));
  status = UM_OK;
done:
  um_core_progress_end(e->context);
  for (int i = 0; i < n; i++) {
    if (line[i].ready) exr_encoding_destroy(e->file, &line[i].encoder);
    um_core_free(e->context, line[i].value);
  }
  um_core_free(e->context, line);
  return status;
}

enum um_status um_output_write_exr(struct um_context *context, const struct um_optics_image *image,
                                   const struct um_output_cut *cut, const char *path)
{
  struct exr e = {.context = context, .path = path, .image = image};
  exr_context_initializer_t start = EXR_DEFAULT_CONTEXT_INITIALIZER;
  enum um_status status, closed = UM_OK;
  bool open = false;
  e.cut = cut != NULL ? *cut : um_output_cut_whole(image);
  start.error_handler_fn = silent;
  UM_CHECK(preview_create(&e));
  UM_CHECK(check(&e, exr_start_write(&e.file, path, EXR_INTERMEDIATE_TEMP_FILE, &start)));
  open = true;
  UM_CHECK(describe(&e));
  UM_CHECK(find_planes(&e));
  UM_CHECK(write_lines(&e));
done:
  if (open) closed = check(&e, exr_finish(&e.file));
  for (size_t c = 0; c < PREVIEW; c++) um_core_free(context, e.preview[c]);
  um_core_free(context, e.plane);
  return status != UM_OK ? status : closed;
}
