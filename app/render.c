/* umbra render: one picture of one instant, every wavelength of a band, as OpenEXR. */
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "app/app.h"
#include "model/bands.h"
#include "model/build.h"
#include "model/picture.h"
#include "model/precompute.h"
#include "model/run.h"
#include "orbit/time.h"
#include "output/output.h"

/* The scenario's overrides plus the one instant that is wanted. */
static enum um_status overrides_of(struct um_context *context, const struct um_app_options *options,
                                   const char ***out, char *at[2])
{
  UM_TRY(um_core_allocate(context, options->nset + 2, sizeof **out, out));
  UM_TRY(um_core_asprintf(context, &at[0], "time.start_utc=%s", options->time_utc));
  UM_TRY(um_core_asprintf(context, &at[1], "time.stop_utc=%s", options->time_utc));
  for (size_t i = 0; i < options->nset; i++) (*out)[i] = options->set[i];
  (*out)[options->nset] = at[0];
  (*out)[options->nset + 1] = at[1];
  return UM_OK;
}

static enum um_status render(struct um_context *context, const struct um_app_options *options,
                             struct um_model *model)
{
  enum um_status status;
  struct um_model_precomputed *precomputed = NULL;
  struct um_model_result *result = NULL;
  struct um_optics_image *image = NULL;
  size_t band;
  if (um_model_band_require(context, model, options->band, &band) != UM_OK) {
    um_core_message_prefix(context, "--band %s", options->band);
    return UM_ERR_INPUT;
  }
  UM_CHECK(um_model_precompute(context, model, &precomputed));
  UM_CHECK(um_model_run(context, model, precomputed, &result));
  UM_CHECK(um_model_picture(context, model, precomputed, result, 0, band,
                            options->width > 0 ? options->width : UM_APP_RENDER_WIDTH,
                            options->samples > 0 ? options->samples : UM_APP_RENDER_SAMPLES,
                            &image));
  UM_CHECK(um_output_write_exr(context, image, options->out));
  printf("%s: %d x %d pixels of %.4g m, %zu wavelengths\n", options->out, image->width,
         image->height, image->pixel_size, image->nbin);
done:
  um_optics_image_destroy(context, &image);
  um_model_result_destroy(context, &result);
  um_model_precomputed_destroy(context, &precomputed);
  return status;
}

/* Said before the computing begins: what cannot be written, or is not ours to replace. The picture
 * is renamed into place, which must not hit a device. */
static enum um_status check_target(struct um_context *context, const struct um_app_options *options)
{
  struct stat st;
  char *folder = NULL;
  const char *out = options->out, *slash = strrchr(out, '/');
  if (lstat(out, &st) == 0) {
    if (!S_ISREG(st.st_mode))
      return um_core_fail(context, UM_ERR_IO, "%s: is not a file; accepted: a file name", out);
    if (!options->force)
      return um_core_fail(context, UM_ERR_IO, "%s: exists; accepted: a new name, or --force", out);
  }
  if (slash == NULL) return UM_OK;
  UM_TRY(um_core_asprintf(context, &folder, "%.*s", (int)(slash - out) + 1, out));
  bool there = stat(folder, &st) == 0 && S_ISDIR(st.st_mode);
  um_core_free(context, folder);
  if (there && slash[1] != '\0') return UM_OK;
  return um_core_fail(context, UM_ERR_IO, "%s: %s; accepted: a file name in a folder that exists",
                      out, there ? "is a folder" : "there is no such folder");
}

static enum um_status check_time(struct um_context *context, const char *utc)
{
  double unused;
  enum um_status status = um_orbit_time_parse(context, utc, &unused);
  if (status == UM_ERR_INPUT) um_core_message_prefix(context, "--time");
  return status;
}

int um_app_render(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_model *model = NULL;
  const char **overrides = NULL;
  char *at[2] = {NULL, NULL};
  UM_CHECK(check_time(context, options->time_utc));
  UM_CHECK(check_target(context, options));
  struct um_model_options changes = um_app_model_options(options);
  UM_CHECK(overrides_of(context, options, &overrides, at));
  changes.overrides = overrides;
  changes.noverride = options->nset + 2;
  UM_CHECK(um_model_create(context, options->positional[0], &changes, &model));
  UM_CHECK(render(context, options, model));
done:
  um_model_destroy(context, &model);
  um_core_free(context, (void *)overrides);
  um_core_free(context, at[0]);
  um_core_free(context, at[1]);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
