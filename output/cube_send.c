/* The child process that opens a factored picture and sends the part that is wanted, as plain
 * arrays behind a header. What it allocates goes with it. */
#include "output/cube_send_impl.h"

#include <math.h>
#include <netcdf.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/core/child.h"
#include "output/cube_impl.h"

#define SPECTRA_MAX 100000000
#define BINS_MAX    100000
#define RATIO_MAX   1100.0 /* arrays to what a file stores: deflate does not exceed 1032 [1] */

struct reader {
  int file;
  struct um_cube_header h;
  size_t bins_of_file;
  double bytes; /* of the file */
};

#define FAIL(r, ...) (snprintf((r)->h.message, UM_CUBE_MESSAGE, __VA_ARGS__), false)

static bool check(struct reader *r, int code)
{
  return code == NC_NOERR || FAIL(r, "netCDF: %s", nc_strerror(code));
}

static bool dimension(struct reader *r, const char *name, size_t *length)
{
  int id;
  return check(r, nc_inq_dimid(r->file, name, &id)) && check(r, nc_inq_dimlen(r->file, id, length));
}

/* A variable with its number of axes and their lengths. */
static bool variable(struct reader *r, const char *name, int naxis, const size_t *length, int *id)
{
  int n, axis[NC_MAX_VAR_DIMS];
  if (nc_inq_varid(r->file, name, id) != NC_NOERR) return FAIL(r, "no variable '%s'", name);
  if (!check(r, nc_inq_varndims(r->file, *id, &n))) return false;
  if (n != naxis) return FAIL(r, "variable '%s' has %d axes; accepted: %d", name, n, naxis);
  if (!check(r, nc_inq_vardimid(r->file, *id, axis))) return false;
  for (int i = 0; i < n; i++) {
    size_t found;
    if (!check(r, nc_inq_dimlen(r->file, axis[i], &found))) return false;
    if (found != length[i])
      return FAIL(r, "variable '%s' has %zu values on an axis; accepted: %zu", name, found,
                  length[i]);
  }
  return true;
}

static bool open_header(struct reader *r)
{
  char title[sizeof UM_CUBE_TITLE] = "";
  size_t length = 0;
  int size[3];
  static const char *const names[] = {"width", "height", "samples"};
  if (nc_inq_attlen(r->file, NC_GLOBAL, "title", &length) != NC_NOERR ||
      length != sizeof UM_CUBE_TITLE - 1 ||
      nc_get_att_text(r->file, NC_GLOBAL, "title", title) != NC_NOERR ||
      strcmp(title, UM_CUBE_TITLE) != 0)
    return FAIL(r, "is not a factored picture; accepted: what umbra render wrote to a name in .nc");
  for (int i = 0; i < 3; i++) {
    if (nc_inq_attlen(r->file, NC_GLOBAL, names[i], &length) != NC_NOERR || length != 1 ||
        nc_get_att_int(r->file, NC_GLOBAL, names[i], &size[i]) != NC_NOERR)
      return FAIL(r, "no attribute '%s'", names[i]);
    int most = i == 2 ? UM_OPTICS_IMAGE_SAMPLES : UM_OPTICS_IMAGE_WIDTH;
    if (size[i] < 1 || size[i] > most)
      return FAIL(r, "%s %d; accepted: 1 to %d", names[i], size[i], most);
  }
  if (nc_inq_attlen(r->file, NC_GLOBAL, "pixel_size_m", &length) != NC_NOERR || length != 1 ||
      nc_get_att_double(r->file, NC_GLOBAL, "pixel_size_m", &r->h.pixel_size) != NC_NOERR ||
      !(r->h.pixel_size > 0.0 && isfinite(r->h.pixel_size)))
    return FAIL(r, "no attribute 'pixel_size_m' above 0");
  if (nc_inq_attlen(r->file, NC_GLOBAL, "comments", &length) == NC_NOERR &&
      length < sizeof r->h.comments &&
      nc_get_att_text(r->file, NC_GLOBAL, "comments", r->h.comments) != NC_NOERR)
    r->h.comments[0] = '\0';
  r->h.width = size[0];
  r->h.height = size[1];
  r->h.samples = size[2];
  return true;
}

/* Can the file hold arrays of so many bytes, and a picture too? What was never written reads as if
 * it were there, so that a small file may claim any length. */
static bool can_hold(const struct reader *r, double bytes)
{
  return bytes <= UM_OPTICS_IMAGE_BYTES && bytes <= RATIO_MAX * r->bytes;
}

/* Which pixels and bins are wanted. */
static bool choose(struct reader *r, const struct um_output_cube_part *part, double **wavelength)
{
  struct um_cube_header *h = &r->h;
  int id;
  bool all = part->width == 0;
  h->x = all ? 0 : part->x;
  h->y = all ? 0 : part->y;
  h->columns = all ? h->width : part->width;
  h->lines = all ? h->height : part->height;
  if (!um_cube_part_fits(h))
    return FAIL(r, "tile of %d x %d pixels at %d, %d; accepted: inside %d x %d pixels", h->columns,
                h->lines, h->x, h->y, h->width, h->height);
  size_t n, nspectrum;
  if (!dimension(r, "wavelength", &n) || !dimension(r, "spectrum", &nspectrum)) return false;
  if (n < 1 || n > BINS_MAX || nspectrum < 1 || nspectrum > SPECTRA_MAX)
    return FAIL(r, "%zu spectra of %zu wavelengths; accepted: 1 to %d of 1 to %d", nspectrum, n,
                SPECTRA_MAX, BINS_MAX);
  if (!can_hold(r, 2.0 * sizeof(float) * (double)nspectrum * (double)n))
    return FAIL(r, "%zu spectra of %zu wavelengths do not fit into its %.0f bytes: damaged",
                nspectrum, n, r->bytes);
  r->bins_of_file = n;
  h->nspectrum = nspectrum;
  *wavelength = malloc(n * sizeof **wavelength);
  if (*wavelength == NULL) return FAIL(r, "out of memory");
  if (!variable(r, UM_CUBE_WAVELENGTH, 1, &n, &id) ||
      !check(r, nc_get_var_double(r->file, id, *wavelength)))
    return false;
  while (h->bin < n && (*wavelength)[h->bin] < part->from) h->bin++;
  while (h->bin + h->nbin < n && (*wavelength)[h->bin + h->nbin] <= part->to) h->nbin++;
  if (h->nbin == 0)
    return FAIL(r, "no wavelength within %g to %g um; accepted: %g to %g um", part->from * 1e6,
                part->to * 1e6, (*wavelength)[0] * 1e6, (*wavelength)[n - 1] * 1e6);
  return true;
}

static bool send_bins(struct reader *r, const double *wavelength, int pipe_end)
{
  static const char *const names[] = {UM_CUBE_WIDTH, UM_CUBE_TRANSMISSION};
  const struct um_cube_header *h = &r->h;
  size_t start = h->bin, n = h->nbin;
  double *value = malloc(n * sizeof *value);
  if (value == NULL || !um_core_child_write(pipe_end, wavelength + start, n * sizeof *value))
    return false;
  for (int k = 0; k < 2; k++) {
    int id;
    if (!variable(r, names[k], 1, &r->bins_of_file, &id) ||
        nc_get_vara_double(r->file, id, &start, &n, value) != NC_NOERR ||
        !um_core_child_write(pipe_end, value, n * sizeof *value))
      return false;
  }
  return true;
}

static bool send_spectra(struct reader *r, int pipe_end)
{
  static const char *const names[] = {UM_CUBE_DARK, UM_CUBE_SUN};
  const struct um_cube_header *h = &r->h;
  const size_t length[] = {h->nspectrum, r->bins_of_file};
  float *value = malloc(h->nbin * sizeof *value);
  uint32_t *surface = malloc(length[0] * sizeof *surface);
  int id;
  if (value == NULL || surface == NULL || !variable(r, UM_CUBE_SURFACE, 1, length, &id) ||
      nc_get_var_uint(r->file, id, surface) != NC_NOERR ||
      !um_core_child_write(pipe_end, surface, length[0] * sizeof *surface))
    return false;
  for (int k = 0; k < 2; k++) {
    if (!variable(r, names[k], 2, length, &id)) return false;
    for (size_t s = 0; s < length[0]; s++) {
      const size_t start[] = {s, h->bin}, count[] = {1, h->nbin};
      if (nc_get_vara_float(r->file, id, start, count, value) != NC_NOERR ||
          !um_core_child_write(pipe_end, value, h->nbin * sizeof *value))
        return false;
    }
  }
  return true;
}

static bool read_uint(struct reader *r, const char *name, size_t length, uint32_t **out)
{
  int id;
  *out = malloc(length * sizeof **out);
  return *out != NULL && variable(r, name, 1, &length, &id) &&
         nc_get_var_uint(r->file, id, *out) == NC_NOERR;
}

/* Values [start, start + n) of a variable along one axis. */
static bool send_range(struct reader *r, const char *name, size_t start, size_t n, bool wide,
                       void *scratch, int pipe_end)
{
  int id;
  if (nc_inq_varid(r->file, name, &id) != NC_NOERR) return false;
  int code = wide ? nc_get_vara_uint(r->file, id, &start, &n, scratch)
                  : nc_get_vara_ushort(r->file, id, &start, &n, scratch);
  return code == NC_NOERR &&
         um_core_child_write(pipe_end, scratch, n * (wide ? sizeof(uint32_t) : sizeof(uint16_t)));
}

static bool send_lines(struct reader *r, int pipe_end)
{
  const struct um_cube_header *h = &r->h;
  size_t height = (size_t)h->height, pixel = 0, share = 0;
  size_t most = (size_t)h->width * (size_t)h->samples;
  uint32_t *from, *pixels, *shares, *scratch = malloc(most * sizeof *scratch);
  if (scratch == NULL || !read_uint(r, UM_CUBE_FROM, height, &from) ||
      !read_uint(r, UM_CUBE_PIXELS, height, &pixels) ||
      !read_uint(r, UM_CUBE_LINE_SHARES, height, &shares))
    return false;
  for (size_t y = 0; y < (size_t)h->y + (size_t)h->lines; y++) {
    const struct um_cube_line line = {from[y], pixels[y], shares[y]};
    double bytes = sizeof(uint32_t) * ((double)share + (double)line.shares);
    if (line.pixels > (uint32_t)h->width || line.shares > most || !can_hold(r, bytes)) return false;
    if (y >= (size_t)h->y &&
        (!um_core_child_write(pipe_end, &line, sizeof line) ||
         !send_range(r, UM_CUBE_SHARES, pixel, line.pixels, false, scratch, pipe_end) ||
         !send_range(r, UM_CUBE_SPECTRUM, share, line.shares, true, scratch, pipe_end) ||
         !send_range(r, UM_CUBE_SEEN, share, line.shares, false, scratch, pipe_end) ||
         !send_range(r, UM_CUBE_LIT, share, line.shares, false, scratch, pipe_end)))
      return false;
    pixel += line.pixels;
    share += line.shares;
  }
  return true;
}

int um_output_cube_send(void *self, int pipe_end)
{
  const struct um_cube_wanted *w = self;
  struct reader r = {0};
  struct stat file = {0};
  double *wavelength = NULL;
  if (stat(w->path, &file) == 0) r.bytes = (double)file.st_size;
  bool well = check(&r, nc_open(w->path, NC_NOWRITE, &r.file)) && open_header(&r) &&
              choose(&r, &w->part, &wavelength);
  if (!um_core_child_write(pipe_end, &r.h, sizeof r.h)) return 1;
  if (!well) return 0;
  return send_bins(&r, wavelength, pipe_end) && send_spectra(&r, pipe_end) &&
                 send_lines(&r, pipe_end)
             ? 0
             : 2;
}
