/* umbra render PICTURE.nc -o FILE.exr: a factored picture, or a part of it, as OpenEXR. */
#include "app/app.h"
#include "app/picture.h"
#include "app/target.h"

int um_app_expand(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_output_cube_part part;
  struct um_output_cut cut;
  struct um_optics_image *image = NULL;
  UM_CHECK(um_app_picture_part(context, options, &part));
  UM_CHECK(um_app_check_picture(context, options, UM_APP_EXR));
  UM_CHECK(um_output_read_cube(context, options->positional[0], &part, &image, &cut));
  UM_CHECK(um_app_cut_cost(context, options, image, &cut));
  UM_CHECK(um_output_write_exr(context, image, &cut, options->out));
  um_app_picture_print(options, cut.width, cut.height, image->pixel_size, cut.nbin, NAN);
done:
  um_optics_image_destroy(context, &image);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
