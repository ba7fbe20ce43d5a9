/* umbra render -o FILE.fits: what a sensor's detector records at an instant, as FITS. */
#include "model/products/frame.h"

#include <math.h>
#include <string.h>

#include "app/app.h"
#include "app/frame_options.h"
#include "app/picture.h"
#include "app/target.h"
#include "base/core/constants.h"
#include "environment/airmass.h"
#include "model/build/bands.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/products/frame_sky.h"
#include "model/products/star.h"
#include "model/run/run.h"
#include "output/fits.h"
#include "output/frame_plot.h"

#define SKY_CARDS 13 /* of the projection */

/* A star of --star where it stands, and its pixel as FITS counts them. */
struct star {
  double asked[3]; /* AB magnitude, right and up of the middle [arcsec] */
  struct um_instrument_frame_star light;
  char key[3][9]; /* of its cards */
};
/* What is drawn. */
struct scene {
  const struct um_model *model;
  const struct um_model_tables *tables;
  size_t sensor;
  struct um_model_frame frame;
  struct star *star; /* [nstar] */
  struct um_output_frame_star *marked;
  size_t nstar;
  double airmass; /* NAN: none */
  float *counts;
  size_t saturated;
};

/* Middle of the image in pixels, plus arcsec to the right or up. */
static double at_pixel(int side, double arcsec, double pixel)
{
  return 0.5 * (side + 1) + arcsec / pixel;
}

/* What stars count through the scenario's telescope. */
static enum um_status make_stars(struct um_context *context, const struct um_app_options *options,
                                 struct scene *scene, struct um_instrument_frame_star *light)
{
  const struct um_model_tables *t = scene->tables;
  size_t instant = t->nobs - 1;
  const struct um_instrument_sensor *optics = &scene->model->sensor[scene->sensor].optics;
  scene->airmass = um_environment_airmass(t->look[instant * t->nsub + t->nsub / 2].elevation);
  for (size_t i = 0; i < scene->nstar; i++) {
    struct star *s = &scene->star[i];
    double rate;
    if (!um_app_star_parse(options->star[i], s->asked))
      return um_core_fail(context, UM_ERR_INPUT,
                          "--star %s; accepted: MAG,RIGHT,UP, AB magnitude and arcsec",
                          options->star[i]);
    UM_TRY(um_model_star_rate(context, scene->model, scene->sensor, s->asked[0], scene->airmass,
                              t->t_obs[instant], &rate));
    s->light = (struct um_instrument_frame_star){s->asked[1], s->asked[2], rate * optics->gain};
    light[i] = s->light;
  }
  return UM_OK;
}

static void read_out(struct scene *scene, const uint64_t *seed)
{
  const struct um_instrument_sensor *optics = &scene->model->sensor[scene->sensor].optics;
  const struct um_instrument_readout readout = {.background = scene->frame.background,
                                                .read_noise = optics->read_noise,
                                                .gain = optics->gain,
                                                .saturation = optics->saturation,
                                                .seed = seed != NULL ? *seed : 0,
                                                .noiseless = seed == NULL};
  scene->saturated = um_instrument_frame_read(&scene->frame.frame, &readout, scene->counts);
}

/* Cards of the stars: STARM1, STARX1, STARY1 and so on. Returns how many cards there are. */
static size_t star_cards(struct scene *scene, struct um_output_card *cards, size_t n)
{
  static const char *const key[] = {"STARM", "STARX", "STARY"};
  static const char *const meaning[] = {"AB magnitude of a star", "its pixel, 1 the first",
                                        "likewise"};
  const struct um_instrument_frame *f = &scene->frame.frame;
  for (size_t i = 0; i < scene->nstar; i++) {
    struct star *s = &scene->star[i];
    double value[] = {s->asked[0], at_pixel(f->width, s->asked[1], f->pixel),
                      at_pixel(f->height, s->asked[2], f->pixel)};
    scene->marked[i] = (struct um_output_frame_star){value[1], value[2], value[0]};
    for (int c = 0; c < 3; c++) {
      snprintf(s->key[c], sizeof s->key[c], "%s%zu", key[c], (i + 1) % 1000);
      cards[n++] = (struct um_output_card){s->key[c], value[c], NULL, meaning[c]};
    }
  }
  return n;
}

/* Where the frame lies on the sky, and from where it was taken. Returns how many cards there are.
 */
static size_t sky_cards(const struct scene *scene, struct um_output_card *cards, size_t n)
{
  const struct um_instrument_frame *f = &scene->frame.frame;
  const struct um_orbit_observer *site = &scene->model->observer;
  const struct um_model_frame_sky sky =
      um_model_frame_sky(scene->tables, scene->tables->nobs - 1, f->pixel);
  const struct um_output_card projection[SKY_CARDS] = {
      {"RADESYS", 0.0, "ICRS", "without aberration and refraction"},
      {"CTYPE1", 0.0, "RA---TAN", "gnomonic"},
      {"CTYPE2", 0.0, "DEC--TAN", "gnomonic"},
      {"CUNIT1", 0.0, "deg", ""},
      {"CUNIT2", 0.0, "deg", ""},
      {"CRPIX1", at_pixel(f->width, 0.0, f->pixel), NULL, "middle of the frame"},
      {"CRPIX2", at_pixel(f->height, 0.0, f->pixel), NULL, "likewise"},
      {"CRVAL1", sky.ra, NULL, "satellite from the observer [deg]"},
      {"CRVAL2", sky.dec, NULL, "likewise"},
      {"CD1_1", sky.cd[0][0], NULL, "[deg]"},
      {"CD1_2", sky.cd[0][1], NULL, "[deg]"},
      {"CD2_1", sky.cd[1][0], NULL, "[deg]"},
      {"CD2_2", sky.cd[1][1], NULL, "[deg]"}};
  memcpy(cards + n, projection, sizeof projection);
  n += SKY_CARDS;
  if (site->kind != UM_OBSERVER_STATION) return n;
  cards[n++] =
      (struct um_output_card){"SITELAT", site->latitude / UM_DEG, NULL, "geodetic, WGS-84 [deg]"};
  cards[n++] = (struct um_output_card){"SITELONG", site->longitude / UM_DEG, NULL, "east [deg]"};
  cards[n++] = (struct um_output_card){"SITEELEV", site->height, NULL, "above WGS-84 [m]"};
  return n;
}

static enum um_status write_fits(struct um_context *context, const struct um_app_options *options,
                                 struct scene *scene)
{
  const struct um_model_sensor *sensor = &scene->model->sensor[scene->sensor];
  const struct um_model_frame *f = &scene->frame;
  double gain = sensor->optics.gain;
  struct um_output_card *cards = NULL;
  const struct um_output_card first[] = {
      {"BUNIT", 0.0, "adu", "counts of a pixel"},
      {"OBJECT", 0.0, scene->model->scenario->name, "scenario"},
      {"INSTRUME", 0.0, sensor->name, "sensor"},
      {"FILTER", 0.0, scene->model->band[sensor->band].name, "band"},
      {"DATE-OBS", 0.0, options->time_utc, "UTC, mid-exposure"},
      {"DATE-AVG", 0.0, options->time_utc, "UTC, mid-exposure"},
      {"EXPTIME", sensor->exposure, NULL, "[s]"},
      {"GAIN", gain, NULL, "[e/adu]"},
      {"RDNOISE", sensor->optics.read_noise, NULL, "[e]"},
      {"PIXSCALE", sensor->optics.pixel, NULL, "[arcsec]"},
      {"BACKGRND", f->background / gain, NULL, "expected, of a pixel [adu]"},
      {"SRCCOUNT", f->frame.source / gain, NULL, "expected, of the whole source [adu]"},
      {"OUTSIDE", f->frame.outside / gain, NULL, "expected, beside the frame [adu]"},
      {"NSATUR", (double)scene->saturated, NULL, "saturated pixels"}};
  size_t n = sizeof first / sizeof first[0];
  UM_TRY(
      um_core_allocate(context, n + 2 + SKY_CARDS + 3 + 3 * scene->nstar, sizeof *cards, &cards));
  memcpy(cards, first, sizeof first);
  if (isfinite(sensor->optics.saturation))
    cards[n++] = (struct um_output_card){"SATURATE", sensor->optics.saturation / gain, NULL,
                                         "a pixel holds no more [adu]"};
  if (isfinite(scene->airmass))
    cards[n++] = (struct um_output_card){"AIRMASS", scene->airmass, NULL, "Kasten and Young 1989"};
  n = sky_cards(scene, cards, n);
  n = star_cards(scene, cards, n);
  enum um_status status = um_output_write_fits(context, scene->counts, f->frame.width,
                                               f->frame.height, cards, n, options->out);
  um_core_free(context, cards);
  return status;
}

static double brightest(const struct scene *scene)
{
  const struct um_instrument_frame *f = &scene->frame.frame;
  double peak = 0.0;
  for (size_t i = 0; i < (size_t)f->width * (size_t)f->height; i++)
    peak = fmax(peak, (double)scene->counts[i]);
  return peak;
}

/* Expected counts of star i [adu]. */
static double star_counts(const struct scene *scene, size_t i)
{
  const struct um_model_sensor *sensor = &scene->model->sensor[scene->sensor];
  return scene->star[i].light.rate * sensor->exposure / sensor->optics.gain;
}

static void json_frame(const struct um_app_options *options, const struct scene *scene)
{
  const struct um_model_sensor *sensor = &scene->model->sensor[scene->sensor];
  const struct um_instrument_frame *f = &scene->frame.frame;
  double gain = sensor->optics.gain;
  um_core_json_text(stdout, "{", "file", options->out);
  printf(", \"width\": %d, \"height\": %d", f->width, f->height);
  um_core_json_field(stdout, ", ", "pixel_arcsec", sensor->optics.pixel);
  um_core_json_field(stdout, ", ", "source_adu", f->source / gain);
  um_core_json_field(stdout, ", ", "sky_adu", scene->frame.background / gain);
  um_core_json_field(stdout, ", ", "brightest_adu", brightest(scene));
  um_core_json_count(stdout, ", ", "saturated_pixels", scene->saturated);
  printf(", \"stars\": [");
  for (size_t i = 0; i < scene->nstar; i++) {
    um_core_json_field(stdout, i > 0 ? ", {" : "{", "magnitude_ab", scene->star[i].asked[0]);
    um_core_json_field(stdout, ", ", "star_adu", star_counts(scene, i));
    um_core_json_field(stdout, ", ", "x_pixel", scene->marked[i].x);
    um_core_json_field(stdout, ", ", "y_pixel", scene->marked[i].y);
    printf("}");
  }
  printf("]}\n");
}

static void print_frame(const struct um_app_options *options, const struct scene *scene)
{
  const struct um_model_sensor *sensor = &scene->model->sensor[scene->sensor];
  const struct um_instrument_frame *f = &scene->frame.frame;
  double gain = sensor->optics.gain;
  printf("%s: %d x %d pixels of %g arcsec, %.6g counts of the source, %.4g of the sky in each "
         "pixel, brightest pixel %.6g, %zu saturated\n",
         options->out, f->width, f->height, sensor->optics.pixel, f->source / gain,
         scene->frame.background / gain, brightest(scene), scene->saturated);
  for (size_t i = 0; i < scene->nstar; i++)
    printf("star of %g mag: %.6g counts at pixel %.2f,%.2f\n", scene->star[i].asked[0],
           star_counts(scene, i), scene->marked[i].x, scene->marked[i].y);
}

/* FILE.fits is drawn as FILE.png; the caller frees. */
static enum um_status png_name(struct um_context *context, const char *fits, char **out)
{
  size_t n = strlen(fits) - strlen(um_app_ending(fits));
  return um_core_asprintf(context, out, "%.*s.png", (int)n, fits);
}

static enum um_status draw(struct um_context *context, const struct um_app_options *options,
                           const struct scene *scene)
{
  const struct um_model_sensor *sensor = &scene->model->sensor[scene->sensor];
  const struct um_instrument_frame *f = &scene->frame.frame;
  char below[160], *png = NULL;
  snprintf(below, sizeof below, "%.60s, %.60s, %g s", sensor->name, options->time_utc,
           sensor->exposure);
  const struct um_output_frame drawn = {.width = f->width,
                                        .height = f->height,
                                        .counts = scene->counts,
                                        .sky = scene->frame.background / sensor->optics.gain,
                                        .title = scene->model->scenario->name,
                                        .below = below,
                                        .star = scene->marked,
                                        .nstar = scene->nstar};
  if (options->no_plots) return UM_OK;
  UM_TRY(png_name(context, options->out, &png));
  enum um_status status = um_output_plot_frame(context, &drawn, png);
  um_core_free(context, png);
  return status;
}

static enum um_status compute(struct um_context *context, const struct um_app_options *options,
                              const struct um_model_result *result,
                              struct um_model_frame_options *o, struct scene *scene)
{
  struct um_instrument_frame_star *light = NULL;
  UM_TRY(um_core_allocate(context, options->nstar, sizeof *light, &light));
  enum um_status status = make_stars(context, options, scene, light);
  o->star = light;
  o->nstar = options->nstar;
  if (status == UM_OK)
    status = um_model_frame_create(context, scene->model, scene->tables, result,
                                   scene->tables->nobs - 1, scene->sensor, o, &scene->frame);
  um_core_free(context, light);
  if (status != UM_OK) return status;
  size_t n = (size_t)scene->frame.frame.width * (size_t)scene->frame.frame.height;
  return um_core_allocate(context, n, sizeof *scene->counts, &scene->counts);
}

static enum um_status frame(struct um_context *context, const struct um_app_options *options,
                            const struct um_model *model, double t,
                            struct um_model_frame_options *o, const uint64_t *seed)
{
  enum um_status status;
  struct um_model_tables *tables = NULL;
  struct um_model_result *result = NULL;
  struct scene scene = {.model = model, .nstar = options->nstar, .airmass = NAN};
  status = um_model_sensor_require(context, model, options->sensor, &scene.sensor);
  if (status != UM_OK) um_core_message_prefix(context, "--sensor");
  if (status != UM_OK) return status;
  UM_TRY(um_app_instant_within(context, "--time", options->time_utc, t, model, ""));
  UM_CHECK(um_core_allocate(context, scene.nstar, sizeof *scene.star, &scene.star));
  UM_CHECK(um_core_allocate(context, scene.nstar, sizeof *scene.marked, &scene.marked));
  UM_CHECK(um_app_instant_precompute(context, model, t, &tables));
  UM_CHECK(um_model_run(context, model, tables, &result));
  scene.tables = tables;
  UM_CHECK(compute(context, options, result, o, &scene));
  read_out(&scene, seed);
  UM_CHECK(write_fits(context, options, &scene));
  UM_CHECK(draw(context, options, &scene));
  if (options->json)
    json_frame(options, &scene);
  else
    print_frame(options, &scene);
done:
  UM_FREE(context, scene.counts, scene.star, scene.marked);
  um_model_frame_clear(context, &scene.frame);
  um_model_result_destroy(context, &result);
  um_model_tables_destroy(context, &tables);
  return status;
}

/* The picture beside the frame must not take the place of another file. */
static enum um_status check_png(struct um_context *context, const struct um_app_options *options)
{
  char *png = NULL;
  if (options->no_plots) return UM_OK;
  UM_TRY(png_name(context, options->out, &png));
  enum um_status status = um_app_check_target(context, png, options->force);
  um_core_free(context, png);
  return status;
}

int um_app_frame(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_model *model = NULL;
  struct um_model_options changes = um_app_model_options(options);
  struct um_model_frame_options o;
  double t;
  uint64_t seed = 0;
  UM_CHECK(um_app_frame_options(context, options, &o, &seed));
  UM_CHECK(um_app_check_picture(context, options, UM_APP_FRAMES));
  UM_CHECK(check_png(context, options));
  UM_CHECK(um_app_instant(context, "--time", options->time_utc, &t));
  UM_CHECK(um_model_create(context, options->positional[0], &changes, &model));
  UM_CHECK(frame(context, options, model, t, &o, options->seed != NULL ? &seed : NULL));
done:
  um_model_destroy(context, &model);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
