/* Radiance of surfaces toward the observer: the spectra of a picture without its pixels,
 *   L = sum over bins of T (dark + lit / seen sun) dlambda. */
#include "optics/image/surfaces.h"

#include <math.h>

#include "optics/image/image_impl.h"
#include "optics/paths/posed_scenes_group.h"

/* Surfaces of which enough is seen, and how much. */
static enum um_status name_seen(struct um_context *context, const float *seen, size_t nsurface,
                                struct um_optics_image *image, double **share)
{
  UM_TRY(um_core_allocate(context, nsurface, sizeof *image->surface, &image->surface));
  UM_TRY(um_core_allocate(context, nsurface, sizeof **share, share));
  for (size_t s = 0; s < nsurface; s++) {
    if (!((double)seen[s] >= UM_OPTICS_SEEN_LEAST)) continue;
    (*share)[image->nspectrum] = fmin((double)seen[s], 1.0);
    image->surface[image->nspectrum++] = (uint32_t)s;
  }
  return UM_OK;
}

/* Share of each surface that is seen and lit by the lamp of the instant; NULL: none shines. */
static const float *lit_of(const struct um_optics_view *view, size_t at,
                           const struct um_optics_lamp *lamp)
{
  if (!lamp->shines) return NULL;
  if (lamp->name == UM_LAMP_SUN) return view->sun.share + at * view->nsurface;
  return view->moon_row[at] == SIZE_MAX ? NULL
                                        : view->moon.share + view->moon_row[at] * view->nsurface;
}

static void sum_bands(const struct um_optics_image *image, const float *lit, const double *seen,
                      size_t nsurface, double *out)
{
  for (size_t i = 0; i < image->nband * nsurface; i++) out[i] = NAN;
  for (size_t k = 0; k < image->nspectrum; k++) {
    size_t s = image->surface[k];
    double share = lit == NULL ? 0.0 : fmin((double)lit[s] / seen[k], 1.0);
    for (size_t b = 0; b < image->nband; b++) {
      double sum = 0.0;
      for (size_t i = image->first[b]; i < image->first[b + 1]; i++) {
        double radiance = (double)image->dark[k * image->nbin + i] +
                          share * (double)image->sun[k * image->nbin + i];
        sum += radiance * image->transmission[i] * image->bin_width[i];
      }
      out[b * nsurface + s] = sum;
    }
  }
}

enum um_status um_optics_surface_radiance(struct um_context *context,
                                          const struct um_optics_scene *scene, size_t time,
                                          const struct um_optics_view *view, size_t view_time,
                                          const struct um_optics_band *bands, size_t nband,
                                          double *out)
{
  enum um_status status;
  struct um_optics_posed_scenes *scenes = NULL;
  struct um_optics_image *image = NULL;
  struct um_optics_exposure frame = {0};
  double *seen = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *scenes, &scenes));
  UM_CHECK(um_core_allocate(context, 1, sizeof *image, &image));
  UM_CHECK(um_optics_posed_scenes_prepare(context, scene->geometry, &scene->samples[time], 1,
                                          scene->interreflection_samples, scenes));
  frame.mesh = um_geometry_mesh(scene->geometry);
  frame.posed = &scenes->posed[0];
  frame.now = um_optics_instant(scene, time);
  if (um_optics_moon_is_brighter(scene, &frame.now)) um_optics_instant_moon(scene, &frame.now);
  UM_CHECK(
      name_seen(context, view->seen + view_time * view->nsurface, view->nsurface, image, &seen));
  UM_CHECK(um_optics_image_spectra(context, scene, time, bands, nband, &frame, seen, image));
  sum_bands(image, lit_of(view, view_time, &frame.now.lamp), seen, view->nsurface, out);
done:
  if (scenes != NULL) um_optics_posed_scenes_clear(context, scenes);
  UM_FREE(context, scenes, seen);
  um_optics_image_destroy(context, &image);
  return status;
}
