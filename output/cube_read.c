/* Reading a factored picture. A child process opens the file and sends the part that is wanted
 * (cube_send.c); what it sent is checked here before it is believed. */
#include "output/cube.h"

#include <math.h>
#include <string.h>

#include "base/core/child.h"
#include "base/core/file.h"
#include "output/cube_send_impl.h"

#define SECONDS  600.0
#define MEGABYTE 4096
#define RADIANCE 1e30 /* largest [W/m^2/sr/m] */

struct stream {
  const char *at;
  size_t left;
};

/* The next bytes, borrowed; NULL: there are no more so many. */
static const void *next(struct stream *s, size_t bytes)
{
  if (bytes > s->left) return NULL;
  const void *out = s->at;
  s->at += bytes;
  s->left -= bytes;
  return out;
}

static enum um_status damaged(struct um_context *context)
{
  return um_core_fail(context, UM_ERR_INPUT, "its arrays do not fit together: damaged");
}

static enum um_status take(struct um_context *context, struct stream *s, size_t count, size_t size,
                           void *out)
{
  const void *from = count <= s->left / size ? next(s, count * size) : NULL;
  if (from == NULL) return damaged(context);
  void *copy;
  UM_TRY(um_core_allocate(context, count, size, &copy));
  memcpy(copy, from, count * size);
  memcpy(out, &copy, sizeof copy);
  return UM_OK;
}

static enum um_status take_line(struct um_context *context, const struct um_optics_image *image,
                                struct stream *s, struct um_optics_image_row *row)
{
  struct um_cube_line line;
  const void *head = next(s, sizeof line);
  if (head == NULL) return damaged(context);
  memcpy(&line, head, sizeof line);
  const char *shares = next(s, line.pixels * sizeof(uint16_t));
  const char *spectrum = next(s, line.shares * sizeof(uint32_t));
  const char *seen = next(s, line.shares * sizeof(uint16_t));
  const char *lit = next(s, line.shares * sizeof(uint16_t));
  size_t width = (size_t)image->width;
  bool whole = shares != NULL && spectrum != NULL && seen != NULL && lit != NULL;
  if (!whole || line.from > width || line.pixels > width - line.from) return damaged(context);
  if (line.pixels == 0) return line.shares == 0 ? UM_OK : damaged(context);
  UM_TRY(um_core_allocate(context, (size_t)line.pixels + 1, sizeof *row->first, &row->first));
  UM_TRY(um_core_allocate(context, line.shares, sizeof *row->share, &row->share));
  row->from = line.from;
  row->count = line.pixels;
  for (size_t i = 0; i < line.pixels; i++) {
    uint16_t n;
    memcpy(&n, shares + i * sizeof n, sizeof n);
    if (n > line.shares - row->first[i]) return damaged(context);
    row->first[i + 1] = row->first[i] + n;
  }
  for (size_t i = 0; i < line.shares; i++) {
    struct um_optics_image_share *share = &row->share[i];
    memcpy(&share->spectrum, spectrum + i * sizeof share->spectrum, sizeof share->spectrum);
    memcpy(&share->seen, seen + i * sizeof share->seen, sizeof share->seen);
    memcpy(&share->lit, lit + i * sizeof share->lit, sizeof share->lit);
    if (share->spectrum >= image->nspectrum || share->lit > share->seen ||
        share->seen > image->samples)
      return damaged(context);
  }
  return row->first[line.pixels] == line.shares ? UM_OK : damaged(context);
}

/* Wavelengths ascend, and everything is a number. */
static enum um_status check_values(struct um_context *context, const struct um_optics_image *image)
{
  const double *wavelength = image->wavelength, *width = image->bin_width;
  const float *radiance[] = {image->dark, image->sun};
  for (size_t b = 0; b < image->nbin; b++)
    if (!(wavelength[b] > (b > 0 ? wavelength[b - 1] : 0.0) && wavelength[b] < 1.0 &&
          width[b] > 0.0 && width[b] < 1.0 && image->transmission[b] >= 0.0 &&
          image->transmission[b] <= 1.0))
      return um_core_fail(context, UM_ERR_INPUT,
                          "bin %zu of %g m, %g m wide, transmission %g: damaged; accepted: "
                          "ascending wavelengths, widths above 0, transmissions from 0 to 1",
                          b + 1, wavelength[b], width[b], image->transmission[b]);
  for (int k = 0; k < 2; k++)
    for (size_t i = 0; i < image->nspectrum * image->nbin; i++)
      if (!(fabs((double)radiance[k][i]) <= RADIANCE))
        return um_core_fail(context, UM_ERR_INPUT,
                            "radiance %g W/m2/sr/m of spectrum %zu: damaged; accepted: up to %g",
                            (double)radiance[k][i], i / image->nbin + 1, RADIANCE);
  return UM_OK;
}

static enum um_status unpack(struct um_context *context, const struct um_cube_header *h,
                             struct stream *s, struct um_optics_image *image)
{
  if (h->width < 1 || h->height < 1 || h->width > UM_OPTICS_IMAGE_WIDTH ||
      h->height > UM_OPTICS_IMAGE_WIDTH || !um_cube_part_fits(h))
    return damaged(context);
  image->width = h->width;
  image->height = h->height;
  image->samples = h->samples;
  image->pixel_size = h->pixel_size;
  image->nbin = h->nbin;
  image->nspectrum = h->nspectrum;
  UM_TRY(um_core_allocate(context, (size_t)h->height, sizeof *image->row, &image->row));
  UM_TRY(um_core_allocate(context, 2, sizeof *image->first, &image->first));
  image->nband = 1;
  image->first[1] = image->nbin;
  UM_TRY(take(context, s, image->nbin, sizeof(double), &image->wavelength));
  UM_TRY(take(context, s, image->nbin, sizeof(double), &image->bin_width));
  UM_TRY(take(context, s, image->nbin, sizeof(double), &image->transmission));
  UM_TRY(take(context, s, image->nspectrum, sizeof(uint32_t), &image->surface));
  UM_TRY(take(context, s, image->nspectrum * image->nbin, sizeof(float), &image->dark));
  UM_TRY(take(context, s, image->nspectrum * image->nbin, sizeof(float), &image->sun));
  for (int y = h->y; y < h->y + h->lines; y++) UM_TRY(take_line(context, image, s, &image->row[y]));
  return check_values(context, image);
}

static enum um_status judge(struct um_context *context, const struct um_core_child_result *in,
                            struct um_cube_header *h)
{
  bool told = in->count >= sizeof *h && in->end == UM_CHILD_EXITED;
  if (told) memcpy(h, in->answer, sizeof *h);
  if (told && h->message[0] != '\0') {
    h->message[UM_CUBE_MESSAGE - 1] = '\0';
    return um_core_fail(context, UM_ERR_INPUT, "%s", h->message);
  }
  if (told && in->code == 0) return UM_OK;
  if (in->end == UM_CHILD_TIMED_OUT)
    return um_core_fail(context, UM_ERR_LIBRARY, "the netCDF library did not finish within %g s",
                        SECONDS);
  if (told) return damaged(context);
  return um_core_fail(context, UM_ERR_LIBRARY, "the netCDF library crashed; check the file");
}

enum um_status um_output_read_cube(struct um_context *context, const char *path,
                                   const struct um_output_cube_part *part,
                                   struct um_optics_image **out, struct um_output_cut *cut)
{
  struct um_cube_wanted work = {path, *part};
  const struct um_core_child_limits limits = {SECONDS, MEGABYTE};
  struct um_core_child_result in = {0};
  struct um_cube_header h = {0};
  struct um_optics_image *image = NULL;
  enum um_status status;
  *out = NULL;
  UM_TRY(um_core_file_check(context, path));
  UM_CHECK(um_core_child_run(context, "netCDF", um_output_cube_send, &work, &limits, &in));
  UM_CHECK(judge(context, &in, &h));
  struct stream s = {in.answer + sizeof h, in.count - sizeof h};
  UM_CHECK(um_core_allocate(context, 1, sizeof *image, &image));
  UM_CHECK(unpack(context, &h, &s, image));
  *cut = (struct um_output_cut){h.x, h.y, h.columns, h.lines, 0, image->nbin, ""};
  for (size_t i = 0; i + 1 < sizeof cut->comments && h.comments[i] >= ' '; i++)
    cut->comments[i] = h.comments[i];
  *out = image;
  image = NULL;
done:
  if (status == UM_ERR_INPUT || status == UM_ERR_LIBRARY)
    um_core_message_prefix(context, "%s", path);
  um_core_free(context, in.answer);
  um_optics_image_destroy(context, &image);
  return status;
}
