/* umbra render -o FILE.exr, FILE.nc: one picture of one instant, every wavelength of a band, as
 * OpenEXR or factored as netCDF. */
#include "app/app.h"
#include "app/picture.h"
#include "app/target.h"
#include "model/build/bands.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/products/picture.h"
#include "model/run/run.h"
#include "output/cube.h"
#include "output/exr.h"

static enum um_status write_picture(struct um_context *context,
                                    const struct um_app_options *options,
                                    const struct um_model *model,
                                    const struct um_optics_image *image, size_t band)
{
  struct um_output_cut cut;
  UM_TRY(um_app_cut(context, options, image, &cut));
  snprintf(cut.comments, sizeof cut.comments, "%.100s at %.40s, band %.50s", model->scenario->name,
           options->time_utc, model->band[band].name);
  if (um_app_is_cube(options->out))
    return um_output_write_cube(context, image, cut.comments, options->out);
  return um_output_write_exr(context, image, &cut, options->out);
}

static int width_of(const struct um_app_options *options)
{
  return options->width > 0 ? options->width : UM_APP_RENDER_WIDTH;
}

static int samples_of(const struct um_app_options *options)
{
  return options->samples > 0 ? options->samples : UM_APP_RENDER_SAMPLES;
}

/* Said before the computing begins, and refused here where it is too much. */
static enum um_status estimate(struct um_context *context, const struct um_app_options *options,
                               const struct um_model *model, double t, size_t band)
{
  struct um_optics_image_cost cost;
  const struct um_optics_band *bins = &model->band[band];
  UM_TRY(um_model_picture_estimate(context, model, t, band, width_of(options), samples_of(options),
                                   &cost));
  return um_app_picture_cost(context, options, &cost, bins);
}

/* Of the band, through its filter, over all pixels of the picture, sky included: E = L N Omega, as
 * others plot it. */
static enum um_status mean_radiance(struct um_context *context, const struct um_optics_image *image,
                                    double *out)
{
  double *weight = NULL, (*weighed)[2] = NULL, sum = 0.0;
  enum um_status status;
  UM_CHECK(um_core_allocate(context, image->nbin, sizeof *weight, &weight));
  UM_CHECK(um_core_allocate(context, image->nspectrum, sizeof *weighed, &weighed));
  for (size_t b = 0; b < image->nbin; b++) weight[b] = image->transmission[b] * image->bin_width[b];
  um_optics_image_weigh(image, weight, weighed);
  for (int y = 0; y < image->height; y++)
    for (int x = 0; x < image->width; x++)
      sum += um_optics_image_pixel(image, (const double(*)[2])weighed, x, y);
  *out = sum / ((double)image->width * (double)image->height);
done:
  UM_FREE(context, weight, weighed);
  return status;
}

static enum um_status render(struct um_context *context, const struct um_app_options *options,
                             struct um_model *model, double t)
{
  enum um_status status;
  struct um_model_tables *tables = NULL;
  struct um_model_result *result = NULL;
  struct um_optics_image *image = NULL;
  size_t band;
  double mean;
  if (um_model_band_require(context, model, options->band, &band) != UM_OK) {
    um_core_message_prefix(context, "--band %s", options->band);
    return UM_ERR_INPUT;
  }
  UM_CHECK(um_app_instant_within(context, "--time", options->time_utc, t, model, ""));
  UM_CHECK(estimate(context, options, model, t, band));
  UM_CHECK(um_app_instant_precompute(context, model, t, &tables));
  UM_CHECK(um_model_run(context, model, tables, &result));
  UM_CHECK(um_model_picture(context, model, tables, result, tables->nobs - 1, band, 1,
                            width_of(options), samples_of(options), &image));
  UM_CHECK(write_picture(context, options, model, image, band));
  UM_CHECK(mean_radiance(context, image, &mean));
  um_app_picture_print(options, image->width, image->height, image->pixel_size, image->nbin, mean);
done:
  um_optics_image_destroy(context, &image);
  um_model_result_destroy(context, &result);
  um_model_tables_destroy(context, &tables);
  return status;
}

int um_app_render_picture(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_model *model = NULL;
  struct um_model_options changes = um_app_model_options(options);
  double t;
  UM_CHECK(um_app_check_picture(context, options, UM_APP_PICTURES));
  UM_CHECK(um_app_instant(context, "--time", options->time_utc, &t));
  UM_CHECK(um_model_create(context, options->positional[0], &changes, &model));
  UM_CHECK(render(context, options, model, t));
done:
  um_model_destroy(context, &model);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
