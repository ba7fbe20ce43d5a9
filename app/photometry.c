/* umbra photometry: counts of an object, or of stars, on frames. */
#include "evidence/inversion/photometry.h"

#include <math.h>
#include <string.h>

#include "app/app.h"
#include "app/target.h"
#include "base/core/file.h"
#include "base/core/number.h"
#include "base/core/text.h"
#include "evidence/measurements/write.h"
#include "orbit/time.h"

/* Numbers with a comma between them, just so many. */
static bool numbers(const char *text, double *out, int n)
{
  char word[128], *at = word;
  if (strlen(text) >= sizeof word) return false;
  strcpy(word, text);
  for (int i = 0; i < n; i++) {
    char *comma = strchr(at, ',');
    if ((comma == NULL) != (i == n - 1)) return false;
    if (comma != NULL) *comma = '\0';
    if (!um_core_number_parse(at, &out[i])) return false;
    at = comma + 1;
  }
  return true;
}

bool um_app_star_parse(const char *text, double out[3]) { return numbers(text, out, 3); }

static enum um_status parse(struct um_context *context, const struct um_app_options *options,
                            struct um_instrument_aperture *a)
{
  double radii[3], at[2] = {NAN, NAN};
  const char *sky = options->sky != NULL ? options->sky : "mean";
  if (!numbers(options->aperture, radii, 3))
    return um_core_fail(context, UM_ERR_INPUT, "--aperture %s; accepted: R,IN,OUT in pixels",
                        options->aperture);
  if (options->at != NULL && !numbers(options->at, at, 2))
    return um_core_fail(context, UM_ERR_INPUT, "--at %s; accepted: X,Y in pixels, 1,1 the first",
                        options->at);
  if (strcmp(sky, "mean") != 0 && strcmp(sky, "median") != 0)
    return um_core_fail(context, UM_ERR_INPUT, "--sky %s; accepted: mean, median", sky);
  *a = (struct um_instrument_aperture){.x = at[0],
                                       .y = at[1],
                                       .radius = radii[0],
                                       .inside = radii[1],
                                       .beyond = radii[2],
                                       .median = strcmp(sky, "median") == 0};
  return UM_OK;
}

static void print_row(const char *path, const struct um_compare_photometry *p)
{
  char time[32];
  um_orbit_time_format(p->t_tai, time);
  printf("%-24s %12.6g +- %-9.3g %10.5g %9.4g %6zu%s  ", time, p->rate, p->sigma, p->sum.sky,
         p->sum.snr, p->sum.annulus, p->sum.saturated > 0 ? "  saturated" : "");
  um_core_text_put(stdout, path);
  putchar('\n');
}

static void json_row(const char *path, const struct um_compare_photometry *p)
{
  char time[32];
  um_orbit_time_format(p->t_tai, time);
  um_core_json_text(stdout, "{", "frame", path);
  um_core_json_text(stdout, ", ", "time_utc", time);
  um_core_json_text(stdout, ", ", "sensor", p->sensor);
  um_core_json_field(stdout, ", ", "exposure_s", p->exposure);
  um_core_json_field(stdout, ", ", "airmass", p->airmass);
  um_core_json_field(stdout, ", ", "count_rate_1_s", p->rate);
  um_core_json_field(stdout, ", ", "sigma_1_s", p->sigma);
  um_core_json_field(stdout, ", ", "sky_adu", p->sum.sky);
  um_core_json_field(stdout, ", ", "signal_to_noise", p->sum.snr);
  um_core_json_count(stdout, ", ", "ring_pixels", p->sum.annulus);
  um_core_json_count(stdout, ", ", "saturated_pixels", p->sum.saturated);
  printf("}");
}

static void print_head(void)
{
  printf("%-24s %25s %10s %9s %6s\n", "UTC", "counts per second", "sky [adu]", "SNR", "ring");
}

static size_t frames(const struct um_app_options *options) { return 1 + options->nmore; }

static const char *frame_at(const struct um_app_options *options, size_t i)
{
  return i == 0 ? options->positional[0] : options->more[i - 1];
}

/* Of n objects, `each` of them in every frame. */
static void print_rows(const struct um_app_options *options, const struct um_compare_photometry *p,
                       size_t n, size_t each)
{
  if (!options->json) {
    print_head();
    for (size_t i = 0; i < n; i++) print_row(frame_at(options, i / each), &p[i]);
    printf("%s: %zu rows\n", options->out, n);
    return;
  }
  um_core_json_text(stdout, "{", "file", options->out);
  printf(",\n  \"rows\": [");
  for (size_t i = 0; i < n; i++) {
    fputs(i > 0 ? ",\n    " : "\n    ", stdout);
    json_row(frame_at(options, i / each), &p[i]);
  }
  printf("]}\n");
}

/* The object in every frame, as a measurement file. */
static enum um_status measure_object(struct um_context *context,
                                     const struct um_app_options *options,
                                     const struct um_instrument_aperture *aperture)
{
  enum um_status status;
  struct um_compare_photometry *p = NULL;
  struct um_compare_measurements *set = NULL;
  size_t n = frames(options);
  UM_CHECK(um_core_allocate(context, n, sizeof *p, &p));
  for (size_t i = 0; i < n; i++) {
    UM_CHECK(um_core_stop_check(context, "frames were measured"));
    UM_CHECK(um_compare_photometry_measure(context, frame_at(options, i), aperture, &p[i]));
  }
  UM_CHECK(um_compare_photometry_set(context, p, n, options->out, &set));
  UM_CHECK(um_compare_measurements_write(context, set, options->out));
  print_rows(options, p, n, 1);
done:
  um_core_free(context, p);
  um_compare_measurements_destroy(context, &set);
  return status;
}

struct stars {
  size_t n;
  double (*asked)[3];               /* [n] magnitude, x, y */
  struct um_compare_photometry *of; /* [frames][n] */
};

static enum um_status parse_stars(struct um_context *context, const struct um_app_options *options,
                                  struct stars *stars)
{
  for (size_t s = 0; s < stars->n; s++)
    if (!um_app_star_parse(options->star[s], stars->asked[s]))
      return um_core_fail(context, UM_ERR_INPUT,
                          "--star %s; accepted: MAG,X,Y, AB magnitude and pixels",
                          options->star[s]);
  return UM_OK;
}

static enum um_status measure_star(struct um_context *context, const char *path,
                                   const double asked[3],
                                   const struct um_instrument_aperture *aperture,
                                   struct um_compare_photometry *out)
{
  struct um_instrument_aperture a = *aperture;
  a.x = asked[1];
  a.y = asked[2];
  UM_TRY(um_core_stop_check(context, "stars were measured"));
  UM_TRY(um_compare_photometry_measure(context, path, &a, out));
  if (!isnan(out->airmass)) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "%s: header has no AIRMASS; accepted: a number", path);
}

static enum um_status write_stars(struct um_context *context, const struct um_app_options *options,
                                  const struct stars *stars)
{
  struct um_core_whole_file whole;
  UM_TRY(um_core_whole_begin(context, options->out, &whole));
  fputs("magnitude_ab,airmass,count_rate,sigma,flag\n", whole.file);
  for (size_t i = 0; i < frames(options) * stars->n; i++) {
    const struct um_compare_photometry *p = &stars->of[i];
    fprintf(whole.file, "%.9g,%.9g,%.9g,%.9g,%d\n", stars->asked[i % stars->n][0], p->airmass,
            p->rate, p->sigma, p->sum.saturated > 0);
  }
  return um_core_whole_end(context, &whole, UM_OK);
}

/* Every star in every frame, as a table for umbra calibrate. */
static enum um_status measure_stars(struct um_context *context,
                                    const struct um_app_options *options,
                                    const struct um_instrument_aperture *aperture)
{
  enum um_status status;
  struct stars stars = {.n = options->nstar};
  size_t n = frames(options) * stars.n;
  UM_CHECK(um_core_allocate(context, stars.n, sizeof *stars.asked, &stars.asked));
  UM_CHECK(um_core_allocate(context, n, sizeof *stars.of, &stars.of));
  UM_CHECK(parse_stars(context, options, &stars));
  for (size_t i = 0; i < n; i++)
    UM_CHECK(measure_star(context, frame_at(options, i / stars.n), stars.asked[i % stars.n],
                          aperture, &stars.of[i]));
  UM_CHECK(write_stars(context, options, &stars));
  print_rows(options, stars.of, n, stars.n);
done:
  UM_FREE(context, stars.asked, stars.of);
  return status;
}

int um_app_photometry(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_instrument_aperture aperture;
  UM_CHECK(parse(context, options, &aperture));
  UM_CHECK(um_app_check_table(context, options));
  UM_CHECK(options->nstar > 0 ? measure_stars(context, options, &aperture)
                              : measure_object(context, options, &aperture));
done:
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
