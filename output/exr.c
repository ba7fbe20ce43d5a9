/* Planes of floats as an OpenEXR file of scan lines. The only file that knows OpenEXR.
 *
 * Lines are made, packed and compressed in threads, some at a time, then written in order. */
#include <openexr.h>
#include <string.h>

#include "output/exr_impl.h"

/* zlib's level: 1 takes half of the time of the library's 4, for files a fifth larger */
#define ZIP_LEVEL 1

struct exr {
  struct um_context *context;
  const char *path;
  const struct um_output_planes *planes;
  exr_context_t file;
  int part;
  size_t *plane; /* [channels of the file, sorted by name] which of ours each is */
};

/* One line on its way. */
struct line {
  int y;
  float *value; /* [width][nplane] */
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

static enum um_status describe_window(struct exr *e)
{
  const struct um_output_planes *p = e->planes;
  exr_attr_box2i_t whole, data;
  exr_attr_v2f_t centre;
  whole.min.x = whole.min.y = 0;
  whole.max.x = p->whole_width - 1;
  whole.max.y = p->whole_height - 1;
  data.min.x = p->x;
  data.min.y = p->y;
  data.max.x = p->x + p->width - 1;
  data.max.y = p->y + p->height - 1;
  centre.x = centre.y = 0.0F;
  UM_TRY(check(e, exr_add_part(e->file, p->part, EXR_STORAGE_SCANLINE, &e->part)));
  UM_TRY(check(e, exr_set_zip_compression_level(e->file, e->part, ZIP_LEVEL)));
  return check(e, exr_initialize_required_attr(e->file, e->part, &whole, &data, 1.0F, &centre, 1.0F,
                                               EXR_LINEORDER_INCREASING_Y, EXR_COMPRESSION_ZIPS));
}

static enum um_status describe(struct exr *e)
{
  const struct um_output_planes *p = e->planes;
  UM_TRY(describe_window(e));
  for (size_t i = 0; i < p->ntext; i++)
    UM_TRY(check(e, exr_attr_set_string(e->file, e->part, p->text[i][0], p->text[i][1])));
  for (size_t i = 0; i < p->nnumber; i++)
    UM_TRY(check(e, exr_attr_set_double(e->file, e->part, p->number_name[i], p->number[i])));
  for (size_t i = 0; i < p->nplane; i++)
    UM_TRY(check(e, exr_add_channel(e->file, e->part, p->name[i], EXR_PIXEL_FLOAT,
                                    EXR_PERCEPTUALLY_LINEAR, 1, 1)));
  return check(e, exr_write_header(e->file));
}

/* Channels are stored sorted by name; each is found again by it, from where the last one was: names
 * that come sorted are found at once. */
static enum um_status find_planes(struct exr *e)
{
  const struct um_output_planes *p = e->planes;
  const exr_attr_chlist_t *channels = NULL;
  size_t at = 0;
  UM_TRY(check(e, exr_get_channels(e->file, e->part, &channels)));
  UM_TRY(um_core_allocate(e->context, (size_t)channels->num_channels, sizeof *e->plane, &e->plane));
  for (int c = 0; c < channels->num_channels; c++) {
    for (size_t tried = 0; tried < p->nplane; tried++, at = (at + 1) % p->nplane)
      if (strcmp(p->name[at], channels->entries[c].name.str) == 0) break;
    e->plane[c] = at;
  }
  return UM_OK;
}

static void point_channels(const struct exr *e, struct line *line)
{
  size_t stride = e->planes->nplane * sizeof(float);
  for (int c = 0; c < line->encoder.channel_count; c++) {
    exr_coding_channel_info_t *channel = &line->encoder.channels[c];
    channel->encode_from_ptr = (const uint8_t *)(line->value + e->plane[c]);
    channel->user_pixel_stride = (int32_t)stride;
    channel->user_line_stride = (int32_t)stride * e->planes->width;
    channel->user_bytes_per_element = sizeof(float);
    channel->user_data_type = EXR_PIXEL_FLOAT;
  }
}

/* Everything of a line but its writing. */
static exr_result_t pack(const struct exr *e, struct line *line)
{
  exr_chunk_info_t chunk;
  e->planes->row(e->planes->self, line->y, line->value);
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
  const struct um_output_planes *p = e->planes;
  int n = um_core_context_threads(e->context);
  struct line *line = NULL;
  UM_TRY(um_core_allocate(e->context, (size_t)n, sizeof *line, &line));
  um_core_progress_begin(e->context, "writing the picture", (size_t)p->height);
  for (int i = 0; i < n; i++) {
    line[i].encoder = (exr_encode_pipeline_t)EXR_ENCODE_PIPELINE_INITIALIZER;
    UM_CHECK(
        um_core_allocate(e->context, (size_t)p->width * p->nplane, sizeof(float), &line[i].value));
  }
  for (int y = 0; y < p->height; y += n)
    UM_CHECK(write_block(e, line, p->y + y, p->height - y < n ? p->height - y : n));
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

enum um_status um_output_write_planes(struct um_context *context,
                                      const struct um_output_planes *planes, const char *path)
{
  struct exr e = {.context = context, .path = path, .planes = planes};
  exr_context_initializer_t start = EXR_DEFAULT_CONTEXT_INITIALIZER;
  enum um_status status;
  start.error_handler_fn = silent;
  UM_TRY(check(&e, exr_start_write(&e.file, path, EXR_INTERMEDIATE_TEMP_FILE, &start)));
  UM_CHECK(describe(&e));
  UM_CHECK(find_planes(&e));
  UM_CHECK(write_lines(&e));
done:;
  enum um_status closed = check(&e, exr_finish(&e.file));
  um_core_free(context, e.plane);
  return status != UM_OK ? status : closed;
}
