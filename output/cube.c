/* Factored pictures as netCDF-4, written line by line from the picture. */
#include "output/cube.h"

#include <netcdf.h>
#include <netcdf_mem.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/file.h"
#include "output/cube_impl.h"
#include "output/netcdf_text.h"

#define FIRST_SIZE  65536 /* of the file in memory, which grows [bytes] */
#define CHUNK       262144
#define CHUNK_ROWS  64
#define CHUNK_BINS  256
#define DEFLATE     4
#define LINES_AHEAD 64 /* lines between two reports of progress */

enum { LINE, PIXEL, SHARE, SPECTRUM, BIN, NDIMENSION };

struct cube {
  struct um_context *context;
  const char *path;
  const struct um_optics_image *image;
  int file, dimension[NDIMENSION];
  size_t length[NDIMENSION];
};

static enum um_status check(const struct cube *c, int code)
{
  if (code == NC_NOERR) return UM_OK;
  return um_core_fail(c->context, UM_ERR_IO, "%s: netCDF: %s", c->path, nc_strerror(code));
}

static enum um_status define(const struct cube *c, const char *name, nc_type type, int naxis,
                             const int *axis, const char *units, const char *long_name, int *id)
{
  int dimension[2];
  size_t chunk[2];
  for (int i = 0; i < naxis; i++) {
    size_t most = naxis == 1 ? CHUNK : i == 0 ? CHUNK_ROWS : CHUNK_BINS, n = c->length[axis[i]];
    dimension[i] = c->dimension[axis[i]];
    chunk[i] = n < most ? n : most;
  }
  UM_TRY(check(c, nc_def_var(c->file, name, type, naxis, dimension, id)));
  UM_TRY(check(c, nc_def_var_chunking(c->file, *id, NC_CHUNKED, chunk)));
  UM_TRY(check(c, nc_def_var_deflate(c->file, *id, 1, 1, DEFLATE)));
  UM_TRY(check(c, um_output_netcdf_text(c->file, *id, "units", units)));
  return check(c, um_output_netcdf_text(c->file, *id, "long_name", long_name));
}

static enum um_status note(const struct cube *c, const char *name, const char *text)
{
  return check(c, um_output_netcdf_text(c->file, NC_GLOBAL, name, text));
}

static enum um_status describe(struct cube *c, const char *comments)
{
  static const char *const names[] = {"line", "pixel", "share", "spectrum", "wavelength"};
  const struct um_optics_image *image = c->image;
  const int size[] = {image->width, image->height, image->samples};
  c->length[LINE] = (size_t)image->height;
  c->length[SPECTRUM] = image->nspectrum;
  c->length[BIN] = image->nbin;
  for (int y = 0; y < image->height; y++) {
    const struct um_optics_image_row *row = &image->row[y];
    c->length[PIXEL] += row->count;
    c->length[SHARE] += row->count > 0 ? row->first[row->count] : 0;
  }
  if (c->length[SHARE] == 0)
    return um_core_fail(c->context, UM_ERR_INPUT, "%s: the picture shows nothing", c->path);
  for (int i = 0; i < NDIMENSION; i++)
    UM_TRY(check(c, nc_def_dim(c->file, names[i], c->length[i], &c->dimension[i])));
  UM_TRY(note(c, "title", UM_CUBE_TITLE));
  UM_TRY(note(c, "description",
              "Radiance of a pixel: sum over its shares of (share_seen radiance_dark + share_lit "
              "radiance_sun) / samples, the spectra being those of share_spectrum. Shares follow "
              "one another by line, within a line by pixel, from pixel line_from on."));
  if (comments[0] != '\0') UM_TRY(note(c, "comments", comments));
  UM_TRY(check(c, nc_put_att_int(c->file, NC_GLOBAL, "width", NC_INT, 1, &size[0])));
  UM_TRY(check(c, nc_put_att_int(c->file, NC_GLOBAL, "height", NC_INT, 1, &size[1])));
  UM_TRY(check(c, nc_put_att_int(c->file, NC_GLOBAL, "samples", NC_INT, 1, &size[2])));
  return check(
      c, nc_put_att_double(c->file, NC_GLOBAL, "pixel_size_m", NC_DOUBLE, 1, &image->pixel_size));
}

static enum um_status write_bins(const struct cube *c)
{
  const struct um_optics_image *image = c->image;
  const struct {
    const char *name, *units, *long_name;
    const double *value;
  } table[] = {{UM_CUBE_WAVELENGTH, "m", "centre of the bin", image->wavelength},
               {UM_CUBE_WIDTH, "m", "width of the bin", image->bin_width},
               {UM_CUBE_TRANSMISSION, "1", "transmission of the band's filter, not in the radiance",
                image->transmission}};
  int id;
  for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
    UM_TRY(define(c, table[i].name, NC_DOUBLE, 1, (const int[]){BIN}, table[i].units,
                  table[i].long_name, &id));
    UM_TRY(check(c, nc_put_var_double(c->file, id, table[i].value)));
  }
  UM_TRY(define(c, UM_CUBE_SURFACE, NC_UINT, 1, (const int[]){SPECTRUM}, "1",
                "surface of the geometry", &id));
  return check(c, nc_put_var_uint(c->file, id, image->surface));
}

static enum um_status write_spectra(const struct cube *c)
{
  static const char *const names[] = {UM_CUBE_DARK, UM_CUBE_SUN};
  static const char *const meaning[] = {"spectral radiance without direct sunlight",
                                        "spectral radiance that direct sunlight adds"};
  const float *value[] = {c->image->dark, c->image->sun};
  for (int k = 0; k < 2; k++) {
    int id;
    UM_TRY(define(c, names[k], NC_FLOAT, 2, (const int[]){SPECTRUM, BIN}, "W m-2 sr-1 m-1",
                  meaning[k], &id));
    for (size_t from = 0; from < c->length[SPECTRUM]; from += CHUNK_ROWS) {
      size_t left = c->length[SPECTRUM] - from, n = left < CHUNK_ROWS ? left : CHUNK_ROWS;
      const size_t start[] = {from, 0}, count[] = {n, c->length[BIN]};
      UM_TRY(um_core_stop_check(c->context, "a picture was written"));
      UM_TRY(
          check(c, nc_put_vara_float(c->file, id, start, count, value[k] + from * c->length[BIN])));
    }
  }
  return UM_OK;
}

/* Variables of lines, pixels and shares. */
struct columns {
  int from, pixels, line_shares, shares, spectrum, seen, lit;
};

static enum um_status define_lines(const struct cube *c, struct columns *v)
{
  static const int line[] = {LINE}, pixel[] = {PIXEL}, share[] = {SHARE};
  UM_TRY(
      define(c, UM_CUBE_FROM, NC_UINT, 1, line, "1", "first pixel that sees something", &v->from));
  UM_TRY(define(c, UM_CUBE_PIXELS, NC_UINT, 1, line, "1", "pixels from there to the last one",
                &v->pixels));
  UM_TRY(
      define(c, UM_CUBE_LINE_SHARES, NC_UINT, 1, line, "1", "shares of the line", &v->line_shares));
  UM_TRY(define(c, UM_CUBE_SHARES, NC_USHORT, 1, pixel, "1", "shares of the pixel", &v->shares));
  UM_TRY(define(c, UM_CUBE_SPECTRUM, NC_UINT, 1, share, "1", "spectrum of what is seen",
                &v->spectrum));
  UM_TRY(define(c, UM_CUBE_SEEN, NC_USHORT, 1, share, "1", "samples that see it", &v->seen));
  return define(c, UM_CUBE_LIT, NC_USHORT, 1, share, "1", "of these, samples that the Sun lights",
                &v->lit);
}

/* One line, by way of scratch[width * samples]. */
static enum um_status write_line(const struct cube *c, const struct columns *v, size_t y,
                                 size_t *pixel, size_t *share, uint16_t *narrow, uint32_t *wide)
{
  const struct um_optics_image_row *row = &c->image->row[y];
  size_t n = row->count, total = n > 0 ? row->first[n] : 0, one = 1;
  uint32_t shares = (uint32_t)total;
  UM_TRY(check(c, nc_put_vara_uint(c->file, v->from, &y, &one, &row->from)));
  UM_TRY(check(c, nc_put_vara_uint(c->file, v->pixels, &y, &one, &row->count)));
  UM_TRY(check(c, nc_put_vara_uint(c->file, v->line_shares, &y, &one, &shares)));
  if (n == 0) return UM_OK;
  for (size_t i = 0; i < n; i++) narrow[i] = (uint16_t)(row->first[i + 1] - row->first[i]);
  UM_TRY(check(c, nc_put_vara_ushort(c->file, v->shares, pixel, &n, narrow)));
  for (size_t i = 0; i < total; i++) wide[i] = row->share[i].spectrum;
  UM_TRY(check(c, nc_put_vara_uint(c->file, v->spectrum, share, &total, wide)));
  for (size_t i = 0; i < total; i++) narrow[i] = row->share[i].seen;
  UM_TRY(check(c, nc_put_vara_ushort(c->file, v->seen, share, &total, narrow)));
  for (size_t i = 0; i < total; i++) narrow[i] = row->share[i].lit;
  UM_TRY(check(c, nc_put_vara_ushort(c->file, v->lit, share, &total, narrow)));
  *pixel += n;
  *share += total;
  return UM_OK;
}

static enum um_status write_lines(const struct cube *c)
{
  const struct um_optics_image *image = c->image;
  size_t most = (size_t)image->width, pixel = 0, share = 0, height = c->length[LINE];
  struct columns v;
  uint16_t *narrow = NULL;
  uint32_t *wide = NULL;
  enum um_status status;
  UM_TRY(define_lines(c, &v));
  for (size_t y = 0; y < height; y++) {
    const struct um_optics_image_row *row = &image->row[y];
    if (row->count > 0 && row->first[row->count] > most) most = row->first[row->count];
  }
  UM_CHECK(um_core_allocate(c->context, most, sizeof *narrow, &narrow));
  UM_CHECK(um_core_allocate(c->context, most, sizeof *wide, &wide));
  for (size_t y = 0; y < height; y++) {
    UM_CHECK(write_line(c, &v, y, &pixel, &share, narrow, wide));
    if ((y + 1) % LINES_AHEAD == 0) UM_CHECK(um_core_progress_step(c->context, LINES_AHEAD));
    UM_CHECK(um_core_stop_check(c->context, "a picture was written"));
  }
  status = UM_OK;
done:
  UM_FREE(c->context, narrow, wide);
  return status;
}

static enum um_status save(const struct cube *c, const NC_memio *memory)
{
  struct um_core_whole_file whole;
  UM_TRY(um_core_whole_begin(c->context, c->path, &whole));
  (void)fwrite(memory->memory, 1, memory->size, whole.file);
  return um_core_whole_end(c->context, &whole, UM_OK);
}

enum um_status um_output_write_cube(struct um_context *context, const struct um_optics_image *image,
                                    const char *comments, const char *path)
{
  struct cube c = {.context = context, .path = path, .image = image};
  NC_memio memory = {0};
  enum um_status status;
  UM_TRY(check(&c, nc_create_mem("cube.nc", NC_NETCDF4, FIRST_SIZE, &c.file)));
  um_core_progress_begin(context, "writing the picture", (size_t)image->height);
  UM_CHECK(describe(&c, comments));
  UM_CHECK(write_bins(&c));
  UM_CHECK(write_spectra(&c));
  UM_CHECK(write_lines(&c));
done:
  um_core_progress_end(context);
  enum um_status closed = check(&c, nc_close_memio(c.file, &memory));
  if (status == UM_OK) status = closed;
  if (status == UM_OK) status = save(&c, &memory);
  free(memory.memory);
  return status;
}
