/* Picture of one instant, orthographic: lines are traced, then the surfaces that they saw get their
 * spectra. */
#include "optics/image/image.h"

#include <math.h>
#include <string.h>
#include <time.h>

#include "optics/image/image_impl.h"
#include "optics/paths/posed_scenes_group.h"

#define PROBE       24  /* lines that tell what the whole will cost, at most */
#define PROBE_RAYS  4e6 /* of them together */
#define PROBE_LEAST 3

struct render {
  const struct um_optics_scene *scene;
  const struct um_optics_image_options *options;
  size_t time;
  struct um_optics_posed_scenes *scenes;
  struct um_optics_tracer *tracer;
  struct um_optics_exposure frame;
};

static void rows_destroy(struct um_context *context, size_t n, struct um_optics_image_row *row)
{
  for (size_t i = 0; row != NULL && i < n; i++) {
    UM_FREE(context, row[i].first, row[i].share);
  }
  um_core_free(context, row);
}

static void render_clear(struct um_context *context, struct render *r)
{
  um_optics_tracer_destroy(context, &r->tracer);
  if (r->scenes != NULL) um_optics_posed_scenes_clear(context, r->scenes);
  um_core_free(context, r->scenes);
}

/* Everything that stands before the first ray. */
static enum um_status render_begin(struct um_context *context, struct render *r)
{
  const struct um_optics_scene *scene = r->scene;
  const struct um_environment_sample *sample = &scene->samples[r->time];
  struct um_optics_exposure *frame = &r->frame;
  int width = r->options->width, samples = r->options->samples_per_pixel;
  if (width < 1 || width > UM_OPTICS_IMAGE_WIDTH)
    return um_core_fail(context, UM_ERR_INPUT, "image: width %d pixels; accepted: 1 to %d", width,
                        UM_OPTICS_IMAGE_WIDTH);
  if (samples < 1 || samples > UM_OPTICS_IMAGE_SAMPLES)
    return um_core_fail(context, UM_ERR_INPUT, "image: %d samples per pixel; accepted: 1 to %d",
                        samples, UM_OPTICS_IMAGE_SAMPLES);
  UM_TRY(um_core_allocate(context, 1, sizeof *r->scenes, &r->scenes));
  UM_TRY(um_optics_posed_scenes_prepare(context, scene->geometry, sample, 1,
                                        scene->interreflection_samples, r->scenes));
  frame->mesh = um_geometry_mesh(scene->geometry);
  frame->posed = &r->scenes->posed[0];
  frame->now = um_optics_instant(scene, r->time);
  if (um_optics_moon_is_brighter(scene, &frame->now)) um_optics_instant_moon(scene, &frame->now);
  frame->samples = samples;
  UM_TRY(um_optics_camera_create(context, width, r->options->up_gcrs, frame->mesh,
                                 frame->posed->pose, sample->q, frame->now.observer_body,
                                 &frame->camera));
  double bytes = um_optics_tracer_bytes(context, frame);
  if (!(bytes <= UM_OPTICS_IMAGE_BYTES))
    return um_core_fail(context, UM_ERR_INPUT,
                        "image: lines of %d pixels with %d samples take %.3g GB while they are "
                        "traced; accepted: up to %.3g GB, by a smaller --width or fewer --samples",
                        width, samples, bytes * 1e-9, UM_OPTICS_IMAGE_BYTES * 1e-9);
  return um_optics_tracer_create(context, frame, &r->tracer);
}

static enum um_status trace_all(struct um_context *context, struct render *r,
                                struct um_optics_image *image)
{
  size_t n = (size_t)image->height;
  int *y = NULL;
  UM_TRY(um_core_allocate(context, n, sizeof *image->row, &image->row));
  UM_TRY(um_core_allocate(context, n, sizeof *y, &y));
  for (size_t i = 0; i < n; i++) y[i] = (int)i;
  um_core_progress_begin(context, "tracing the picture", n);
  enum um_status status = um_optics_tracer_run(context, r->tracer, y, n, image->row);
  um_core_progress_end(context);
  um_core_free(context, y);
  return status;
}

/* Number the surfaces that were seen; shares name them from now on by that number. */
static enum um_status name_spectra(struct um_context *context, const struct um_geometry_mesh *mesh,
                                   struct um_optics_image *image)
{
  uint32_t *number = NULL;
  enum um_status status;
  UM_TRY(um_core_allocate(context, mesh->nsurface, sizeof *number, &number));
  for (int y = 0; y < image->height; y++) {
    const struct um_optics_image_row *row = &image->row[y];
    for (uint32_t i = 0; row->count > 0 && i < row->first[row->count]; i++)
      number[row->share[i].spectrum] = 1;
  }
  for (size_t s = 0; s < mesh->nsurface; s++) image->nspectrum += number[s];
  UM_CHECK(um_core_allocate(context, image->nspectrum, sizeof *image->surface, &image->surface));
  uint32_t next = 0;
  for (size_t s = 0; s < mesh->nsurface; s++)
    if (number[s] != 0) {
      image->surface[next] = (uint32_t)s;
      number[s] = next++;
    }
  for (int y = 0; y < image->height; y++) {
    const struct um_optics_image_row *row = &image->row[y];
    for (uint32_t i = 0; row->count > 0 && i < row->first[row->count]; i++)
      row->share[i].spectrum = number[row->share[i].spectrum];
  }
done:
  um_core_free(context, number);
  return status;
}

/* Area that samples saw over the projected area. What is nearly whole counts as whole: outlines are
 * sampled. */
static enum um_status seen_create(struct um_context *context,
                                  const struct um_optics_exposure *frame,
                                  const struct um_optics_image *image, double **out)
{
  double sample = image->pixel_size * image->pixel_size / image->samples;
  double *seen;
  UM_TRY(um_core_allocate(context, image->nspectrum, sizeof *seen, out));
  seen = *out;
  for (int y = 0; y < image->height; y++) {
    const struct um_optics_image_row *row = &image->row[y];
    for (uint32_t i = 0; row->count > 0 && i < row->first[row->count]; i++)
      seen[row->share[i].spectrum] += sample * row->share[i].seen;
  }
  for (size_t k = 0; k < image->nspectrum; k++) {
    size_t surface = image->surface[k];
    double cosine =
        um_vec3_dot(um_geometry_surface_normal(frame->mesh, frame->posed->pose, surface),
                    frame->now.observer_body);
    double area = frame->mesh->area[frame->mesh->surface[surface].facet] * cosine;
    double share = area > 0.0 ? seen[k] / area : 1.0;
    seen[k] = share > UM_OPTICS_SEEN_WHOLE ? 1.0 : fmax(share, UM_OPTICS_SEEN_LEAST);
  }
  return UM_OK;
}

static size_t bins_of(const struct um_optics_band *bands, size_t nband)
{
  size_t n = 0;
  for (size_t k = 0; k < nband; k++) n += bands[k].bins > 0 ? (size_t)bands[k].bins : 0;
  return n;
}

static double spectra_bytes(size_t nspectrum, size_t bins)
{
  return 2.0 * sizeof(float) * (double)nspectrum * (double)bins;
}

static enum um_status check_bytes(struct um_context *context, const struct um_optics_image *image,
                                  size_t bins, double rows)
{
  double bytes = rows + spectra_bytes(image->nspectrum, bins);
  if (bytes <= UM_OPTICS_IMAGE_BYTES) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "image: %d x %d pixels and %zu surfaces at %zu wavelengths take %.3g GB; "
                      "accepted: up to %.3g GB, by a smaller --width or fewer bins of the band",
                      image->width, image->height, image->nspectrum, bins, bytes * 1e-9,
                      UM_OPTICS_IMAGE_BYTES * 1e-9);
}

enum um_status um_optics_image_render(struct um_context *context,
                                      const struct um_optics_scene *scene, size_t time,
                                      const struct um_optics_band *bands, size_t nband,
                                      const struct um_optics_image_options *options,
                                      struct um_optics_image **out)
{
  enum um_status status;
  struct um_optics_image *image = NULL;
  struct render r = {.scene = scene, .options = options, .time = time};
  double *seen = NULL;
  *out = NULL;
  UM_CHECK(render_begin(context, &r));
  UM_CHECK(um_core_allocate(context, 1, sizeof *image, &image));
  image->width = r.frame.camera.width;
  image->height = r.frame.camera.height;
  image->pixel_size = r.frame.camera.pixel_size;
  image->samples = options->samples_per_pixel;
  UM_CHECK(trace_all(context, &r, image));
  double rows = um_optics_tracer_row_bytes(r.tracer);
  um_optics_tracer_destroy(context, &r.tracer);
  UM_CHECK(name_spectra(context, r.frame.mesh, image));
  UM_CHECK(check_bytes(context, image, bins_of(bands, nband), rows));
  UM_CHECK(seen_create(context, &r.frame, image, &seen));
  UM_CHECK(um_optics_image_spectra(context, scene, time, bands, nband, &r.frame, seen, image));
  *out = image;
  image = NULL;
done:
  um_core_free(context, seen);
  render_clear(context, &r);
  um_optics_image_destroy(context, &image);
  return status;
}

void um_optics_image_destroy(struct um_context *context, struct um_optics_image **image)
{
  if (image == NULL || *image == NULL) return;
  struct um_optics_image *i = *image;
  rows_destroy(context, (size_t)i->height, i->row);
  UM_FREE(context, i->first, i->wavelength, i->bin_width, i->transmission, i->surface, i->dark,
          i->sun, i);
  *image = NULL;
}

static double seconds_now(void)
{
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Surfaces that look toward the observer: no more are seen. */
static size_t facing(const struct um_optics_exposure *frame)
{
  size_t n = 0;
  for (size_t s = 0; s < frame->mesh->nsurface; s++) {
    struct um_vec3 normal = um_geometry_surface_normal(frame->mesh, frame->posed->pose, s);
    n += um_vec3_dot(normal, frame->now.observer_body) > 0.0;
  }
  return n;
}

enum um_status um_optics_image_estimate(struct um_context *context,
                                        const struct um_optics_scene *scene, size_t time,
                                        const struct um_optics_band *bands, size_t nband,
                                        const struct um_optics_image_options *options,
                                        struct um_optics_image_cost *out)
{
  enum um_status status;
  struct um_optics_scene bare = *scene; /* without the rays between its surfaces */
  struct render r = {.scene = &bare, .options = options, .time = time};
  struct um_optics_image_row row[PROBE] = {{0}};
  int y[PROBE];
  bare.interreflection_samples = 0;
  UM_CHECK(render_begin(context, &r));
  const struct um_optics_camera *camera = &r.frame.camera;
  double rays = (double)camera->width * options->samples_per_pixel;
  double lines = fmin(fmin(fmax(PROBE_RAYS / rays, PROBE_LEAST), PROBE), camera->height);
  size_t n = (size_t)lines;
  for (size_t i = 0; i < n; i++) y[i] = (int)((2 * i + 1) * (size_t)camera->height / (2 * n));
  double before = seconds_now(), share = (double)camera->height / (double)n;
  UM_CHECK(um_optics_tracer_run(context, r.tracer, y, n, row));
  *out = (struct um_optics_image_cost){
      .width = camera->width,
      .height = camera->height,
      .pixel_size = camera->pixel_size,
      .covered = (double)um_optics_tracer_covered(r.tracer) / (double)n / camera->width,
      .bytes = share * um_optics_tracer_row_bytes(r.tracer) +
               um_optics_tracer_bytes(context, &r.frame) +
               spectra_bytes(facing(&r.frame), bins_of(bands, nband)),
      .seconds = share * (seconds_now() - before)};
done:
  for (size_t i = 0; i < PROBE; i++) {
    UM_FREE(context, row[i].first, row[i].share);
  }
  render_clear(context, &r);
  return status;
}
