/* Parts of pictures as the command line names them, and what a picture will cost. */
#include "app/picture.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/statvfs.h>

#include "app/target.h"
#include "base/core/number.h"
#include "model/geometry/precompute.h"
#include "orbit/time.h"

#define FILE_MOST     68719476736.0 /* of an OpenEXR file, 64 GiB */
#define ROOM_LEFT     0.95          /* of the disk's free space that a file may take */
#define PREVIEW       3             /* channels beside the spectral ones */
#define EXR_RATE      40e6 /* bytes of channels that a thread expands and compresses [1/s] */
#define CUBE_RATE     40e6 /* bytes of factors that are compressed [1/s] */
#define CHANNEL_BYTES 4.0
#define COPIES        3.0  /* of a line: expanded, packed, compressed */
#define SPAN_ROUNDING 1e-3 /* [s]: the ends of a span are said to a millisecond */

enum um_status um_app_instant(struct um_context *context, const char *option, const char *text,
                              double *t)
{
  enum um_status status = um_orbit_time_parse(context, text, t);
  if (status != UM_OK) um_core_message_prefix(context, "%s", option);
  return status;
}

enum um_status um_app_instant_within(struct um_context *context, const char *option,
                                     const char *text, double t, const struct um_model *model,
                                     const char *more)
{
  const struct um_scenario_time *time = model->scenario->time;
  char from[32], to[32];
  if (t >= time->start - SPAN_ROUNDING && t <= time->stop + SPAN_ROUNDING) return UM_OK;
  um_orbit_time_format(time->start, from);
  um_orbit_time_format(time->stop, to);
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s %s; accepted: %s to %s, the scenario's start_utc and stop_utc%s", option,
                      text, from, to, more);
}

enum um_status um_app_instant_precompute(struct um_context *context, const struct um_model *model,
                                         double t, struct um_model_tables **out)
{
  const struct um_scenario_time *time = model->scenario->time;
  const double times[] = {time->start, t}, exposures[] = {0.0, time->exposure_s};
  size_t from = t - time->start > 2.0 * time->exposure_s + SPAN_ROUNDING ? 0 : 1;
  return um_model_precompute_at(context, model, times + from, exposures + from, 2 - from,
                                (struct um_model_sampling){0}, out);
}

/* "8-8.1um", "8-8.1" or, for a bin whose centre it is, "8.05" [um]. */
static bool parse_wavelengths(const char *text, double *from, double *to)
{
  char word[64], *second, *unit;
  if (strlen(text) >= sizeof word) return false;
  strcpy(word, text);
  unit = strstr(word, "um");
  if (unit != NULL && unit[2] == '\0') *unit = '\0';
  second = strchr(word, '-');
  if (second != NULL) *second++ = '\0';
  if (!um_core_number_parse(word, from)) return false;
  *to = *from;
  if (second != NULL && !um_core_number_parse(second, to)) return false;
  bool well = *from > 0.0 && *to >= *from;
  *from *= 1e-6;
  *to *= 1e-6;
  return well;
}

/* "X,Y,WIDTH,HEIGHT" [pixels] */
static bool parse_tile(const char *text, struct um_output_cube_part *out)
{
  int *const to[] = {&out->x, &out->y, &out->width, &out->height};
  char word[64], *at = word;
  if (strlen(text) >= sizeof word) return false;
  strcpy(word, text);
  for (int k = 0; k < 4; k++) {
    double number;
    char *comma = strchr(at, ',');
    if ((comma == NULL) != (k == 3)) return false;
    if (comma != NULL) *comma = '\0';
    if (!um_core_number_parse(at, &number) || number != floor(number) ||
        number < (k < 2 ? 0.0 : 1.0) || number > UM_OPTICS_IMAGE_WIDTH)
      return false;
    *to[k] = (int)number;
    if (comma != NULL) at = comma + 1;
  }
  return true;
}

enum um_status um_app_picture_part(struct um_context *context, const struct um_app_options *options,
                                   struct um_output_cube_part *out)
{
  *out = (struct um_output_cube_part){.to = INFINITY};
  if (options->wavelengths != NULL &&
      !parse_wavelengths(options->wavelengths, &out->from, &out->to))
    return um_core_fail(context, UM_ERR_INPUT,
                        "--wavelengths %s; accepted: FROM-TO in um, as 8-8.1um",
                        options->wavelengths);
  if (options->tile == NULL) return UM_OK;
  if (parse_tile(options->tile, out)) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "--tile %s; accepted: X,Y,WIDTH,HEIGHT in pixels, from the upper left corner",
                      options->tile);
}

enum um_status um_app_cut(struct um_context *context, const struct um_app_options *options,
                          const struct um_optics_image *image, struct um_output_cut *cut)
{
  struct um_output_cube_part part;
  UM_TRY(um_app_picture_part(context, options, &part));
  *cut = um_output_cut_whole(image);
  if (part.width > 0) {
    if (part.width > image->width - part.x || part.height > image->height - part.y)
      return um_core_fail(context, UM_ERR_INPUT, "--tile %s; accepted: inside %d x %d pixels",
                          options->tile, image->width, image->height);
    cut->x = part.x;
    cut->y = part.y;
    cut->width = part.width;
    cut->height = part.height;
  }
  size_t n = image->nbin;
  cut->nbin = 0;
  while (cut->bin < n && image->wavelength[cut->bin] < part.from) cut->bin++;
  while (cut->bin + cut->nbin < n && image->wavelength[cut->bin + cut->nbin] <= part.to)
    cut->nbin++;
  if (cut->nbin > 0) return UM_OK;
  return um_core_fail(
      context, UM_ERR_INPUT, "--wavelengths %s: the centre of no bin lies there; accepted: %g-%gum",
      options->wavelengths, image->wavelength[0] * 1e6, image->wavelength[n - 1] * 1e6);
}

/* Room for a file beside its name [bytes]; NaN: not known. */
static double free_bytes(struct um_context *context, const char *path)
{
  struct statvfs disk;
  char *folder = NULL;
  const char *slash = strrchr(path, '/');
  double out = NAN;
  if (slash == NULL) {
    if (statvfs(".", &disk) == 0) out = (double)disk.f_bavail * (double)disk.f_frsize;
    return out;
  }
  if (um_core_asprintf(context, &folder, "%.*s", (int)(slash - path) + 1, path) != UM_OK)
    return out;
  if (statvfs(folder, &disk) == 0) out = (double)disk.f_bavail * (double)disk.f_frsize;
  um_core_free(context, folder);
  return out;
}

static enum um_status check_file(struct um_context *context, const struct um_app_options *options,
                                 double bytes)
{
  const char *help = um_app_is_cube(options->out)
                         ? "a smaller --width"
                         : "fewer --wavelengths, a --tile, or a name in .nc, which keeps the "
                           "picture factored";
  if (!(bytes <= FILE_MOST))
    return um_core_fail(context, UM_ERR_INPUT, "%s: up to %.3g GB; accepted: up to %.3g GB, by %s",
                        options->out, bytes * 1e-9, FILE_MOST * 1e-9, help);
  double room = free_bytes(context, options->out);
  if (bytes > ROOM_LEFT * room)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: up to %.3g GB, and its folder has room for %.3g GB; accepted: %s",
                        options->out, bytes * 1e-9, room * 1e-9, help);
  return UM_OK;
}

/* Memory of the lines that are on their way into the file. */
static double exr_bytes(const struct um_context *context, int width, size_t nbin)
{
  return COPIES * CHANNEL_BYTES * width * (double)(nbin + PREVIEW) *
         um_core_context_threads(context);
}

static double exr_file(double covered, size_t nbin)
{
  return CHANNEL_BYTES * covered * (double)(nbin + PREVIEW);
}

void um_app_picture_print(const struct um_app_options *options, int width, int height,
                          double pixel_m, size_t nbin, double mean)
{
  if (options->json) {
    um_core_json_text(stdout, "{", "file", options->out);
    printf(", \"width\": %d, \"height\": %d", width, height);
    um_core_json_field(stdout, ", ", "pixel_m", pixel_m);
    um_core_json_count(stdout, ", ", "wavelengths", nbin);
    um_core_json_field(stdout, ", ", "mean_radiance_W_m2_sr", mean);
    printf("}\n");
    return;
  }
  printf("%s: %d x %d pixels of %.4g m, %zu wavelengths", options->out, width, height, pixel_m,
         nbin);
  if (!isnan(mean)) printf(", mean radiance %.6g W/m2/sr", mean);
  printf("\n");
}

/* " memory up to 12 MB,", " file up to 3.4 GB," */
static void put_bytes(FILE *file, const char *what, double bytes)
{
  if (bytes < 1e9)
    fprintf(file, " %s up to %.0f MB,", what, fmax(bytes * 1e-6, 1.0));
  else
    fprintf(file, " %s up to %.3g GB,", what, bytes * 1e-9);
}

/* Beside JSON the words go to standard error. */
static void print_cost(bool json, int width, int height, size_t nbin, double memory, double file,
                       double seconds)
{
  FILE *words = json ? stderr : stdout;
  fprintf(words, "%d x %d pixels, %zu wavelengths:", width, height, nbin);
  put_bytes(words, "memory", memory);
  put_bytes(words, "file", file);
  fprintf(words, " about %.0f s\n", fmax(seconds, 1.0));
  fflush(words);
}

enum um_status um_app_picture_cost(struct um_context *context, const struct um_app_options *options,
                                   const struct um_optics_image_cost *cost,
                                   const struct um_optics_band *band)
{
  bool cube = um_app_is_cube(options->out);
  struct um_output_cube_part part;
  UM_TRY(um_app_picture_part(context, options, &part));
  if (cube && (options->wavelengths != NULL || options->tile != NULL))
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: a factored picture is written whole; accepted: --wavelengths and "
                        "--tile with umbra render FILE.nc -o FILE.exr",
                        options->out);
  size_t nbin = 0;
  for (int b = 0; b < band->bins; b++) {
    double centre = 0.5 * (um_optics_band_edge(band, b) + um_optics_band_edge(band, b + 1));
    nbin += centre >= part.from && centre <= part.to;
  }
  if (nbin == 0)
    return um_core_fail(context, UM_ERR_INPUT,
                        "--wavelengths %s: the centre of no bin lies there; accepted: %g-%gum",
                        options->wavelengths,
                        (band->from + 0.5 * (band->to - band->from) / band->bins) * 1e6,
                        (band->to - 0.5 * (band->to - band->from) / band->bins) * 1e6);
  if (part.width > 0 && (part.width > cost->width - part.x || part.height > cost->height - part.y))
    return um_core_fail(context, UM_ERR_INPUT, "--tile %s; accepted: inside %d x %d pixels",
                        options->tile, cost->width, cost->height);
  int width = part.width > 0 ? part.width : cost->width;
  int height = part.height > 0 ? part.height : cost->height;
  double pixels = part.width > 0 ? (double)width * height
                                 : cost->covered * (double)cost->width * (double)cost->height;
  double file = cube ? cost->bytes : exr_file(pixels, nbin);
  double memory = cost->bytes + (cube ? file : exr_bytes(context, width, nbin));
  double rate = cube ? CUBE_RATE : EXR_RATE * um_core_context_threads(context);
  print_cost(options->json, width, height, nbin, memory, file, cost->seconds + file / rate);
  if (!(memory <= UM_OPTICS_IMAGE_BYTES))
    return um_core_fail(context, UM_ERR_INPUT,
                        "--width %d: %d x %d pixels at %d wavelengths take %.3g GB; accepted: up "
                        "to %.3g GB, by a smaller --width, fewer --samples or fewer bins of the "
                        "band",
                        cost->width, cost->width, cost->height, band->bins, memory * 1e-9,
                        UM_OPTICS_IMAGE_BYTES * 1e-9);
  return check_file(context, options, file);
}

enum um_status um_app_cut_cost(struct um_context *context, const struct um_app_options *options,
                               const struct um_optics_image *image, const struct um_output_cut *cut)
{
  double covered = 0.0;
  for (int y = cut->y; y < cut->y + cut->height; y++) {
    int64_t from = image->row[y].from, to = from + image->row[y].count;
    if (from < cut->x) from = cut->x;
    if (to > cut->x + cut->width) to = cut->x + cut->width;
    covered += to > from ? (double)(to - from) : 0.0;
  }
  double file = exr_file(covered, cut->nbin);
  double memory = exr_bytes(context, cut->width, cut->nbin) +
                  CHANNEL_BYTES * 4.0 * (double)image->nspectrum * (double)image->nbin;
  print_cost(options->json, cut->width, cut->height, cut->nbin, memory, file,
             file / (EXR_RATE * um_core_context_threads(context)));
  return check_file(context, options, file);
}
