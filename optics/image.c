/* Picture of one instant, orthographic. Facets are flat and far from everything, so each has one
 * radiance in shadow and one in sunlight; pixels count samples of either. */
#include <math.h>
#include <omp.h>
#include <string.h>

#include "optics/interreflection_impl.h"
#include "optics/sampling_impl.h"
#include "optics/stage_impl.h"

#define WIDTH_MAX   16384
#define SAMPLES_MAX 4096
#define MEMORY_MOST 8e9  /* [bytes] */
#define MARGIN      0.03 /* of the body's larger extent, on each side */

enum { KEY_PIXEL = 0x70697865 };

struct camera {
  struct um_vec3 right, up, toward; /* unit, body frame; toward the observer */
  struct um_vec3 corner;            /* upper left corner of the picture, before the body [m] */
};

struct palette {
  double *dark; /* [nsurface][nbin] radiance without direct sunlight [W/m^2/sr/m] */
  double *sun;  /* [nsurface][nbin] what direct sunlight adds */
};

static enum um_status camera_create(struct um_context *context,
                                    const struct um_optics_image_options *options,
                                    const struct um_geometry_mesh *mesh,
                                    const struct um_geometry_pose *pose, struct um_quat q,
                                    struct um_vec3 toward, struct camera *camera,
                                    struct um_optics_image *image)
{
  struct um_vec3 up = um_quat_apply(q, options->up_gcrs);
  up = um_vec3_axpy(up, -um_vec3_dot(up, toward), toward);
  if (!(um_vec3_norm(up) > 1e-6 * um_vec3_norm(options->up_gcrs)))
    return um_core_fail(context, UM_ERR_INPUT,
                        "image: the upward direction lies along the line of sight");
  camera->toward = toward;
  camera->up = um_vec3_unit(up);
  camera->right = um_vec3_cross(camera->up, toward);
  double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
  for (size_t i = 0; i < mesh->nvertex; i++) {
    struct um_vec3 v = pose->vertex[i];
    double at[3] = {um_vec3_dot(v, camera->right), um_vec3_dot(v, camera->up),
                    um_vec3_dot(v, toward)};
    for (int k = 0; k < 3; k++) {
      low[k] = fmin(low[k], at[k]);
      high[k] = fmax(high[k], at[k]);
    }
  }
  double size_x = high[0] - low[0], size_y = high[1] - low[1];
  double margin = MARGIN * fmax(size_x, size_y);
  if (!(margin > 0.0)) return um_core_fail(context, UM_ERR_INPUT, "image: the body has no extent");
  image->width = options->width;
  image->pixel_size = (size_x + 2.0 * margin) / options->width;
  double rows = ceil((size_y + 2.0 * margin) / image->pixel_size);
  if (!(rows <= WIDTH_MAX))
    return um_core_fail(context, UM_ERR_INPUT, "image: %g rows for width %d; accepted: up to %d",
                        rows, options->width, WIDTH_MAX);
  image->height = (int)rows;
  /* centred; in front of everything by the body's own extent */
  double left = 0.5 * (low[0] + high[0]) - 0.5 * image->width * image->pixel_size;
  double top = 0.5 * (low[1] + high[1]) + 0.5 * image->height * image->pixel_size;
  camera->corner = um_vec3_scale(camera->right, left);
  camera->corner = um_vec3_axpy(camera->corner, top, camera->up);
  camera->corner = um_vec3_axpy(camera->corner, high[2] + 10.0 * margin, toward);
  return UM_OK;
}

/* Ray through the point (x, y) of the picture [pixels], y downward. */
static struct um_geometry_ray camera_ray(const struct camera *camera, double pixel_size, double x,
                                         double y)
{
  struct um_vec3 p = um_vec3_axpy(camera->corner, x * pixel_size, camera->right);
  p = um_vec3_axpy(p, -y * pixel_size, camera->up);
  return (struct um_geometry_ray){p, um_vec3_scale(camera->toward, -1.0), INFINITY,
                                  UM_GEOMETRY_NONE};
}

/* Radiances of one surface: a share of it that is as large as 1 m^2 seen from the observer. */
static void palette_fill(const struct um_optics_spectra *spectra,
                         const struct um_optics_scene *scene, const struct um_optics_instant *now,
                         const struct um_optics_set *set, size_t time, size_t surface,
                         struct um_optics_work *work, struct palette *palette)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(scene->geometry);
  size_t n = spectra->nbin, at = time * mesh->nsurface + surface;
  size_t material = mesh->surface[surface].material;
  struct um_vec3 normal = um_geometry_surface_normal(mesh, set->pose, surface);
  double *dark = palette->dark + surface * n, *sun = palette->sun + surface * n;
  double cos_o = um_vec3_dot(normal, now->observer_body);
  if (!(cos_o > 0.0)) return;
  struct um_optics_sight sight = {
      .area_seen = 1.0 / cos_o,
      .area_lit = 1.0 / cos_o,
      .cos_observer = cos_o,
      .cos_sun = um_vec3_dot(normal, now->sun_body),
      .cos_half = um_vec3_dot(normal, now->half_body),
      .cos_nadir = um_vec3_dot(normal, now->nadir_body),
      .temperature = scene->temperature[at],
      .albedo = (double)scene->albedo[at],
      .view_factor = (double)scene->view_factor[at],
      .brightness = scene->brightness != NULL ? (double)scene->brightness[at] : 0.0};
  um_optics_sight_turn(spectra, scene, surface, work, &sight);
  um_optics_sum_clear(spectra, &work->single);
  um_optics_sum_add(spectra, now, material, &sight, work, &work->single);
  um_optics_sum_spectrum(spectra, scene, now, material, &work->single, work, work->spectral);
  for (size_t b = 0; b < n; b++) {
    const double *from = work->spectral + b * UM_MECHANISM_COUNT;
    sun[b] = from[UM_MECHANISM_SUN];
    dark[b] = from[UM_MECHANISM_EARTH] + from[UM_MECHANISM_EMITTED];
  }
  if (!um_optics_exchange_has(set->exchange, surface)) return;
  um_optics_interreflection(spectra, scene, now, set, time, surface, 1.0, work);
  for (size_t b = 0; b < n; b++) dark[b] += work->reflected[b];
}

/* Scratch of one thread: the rays of a pixel, the last one through its centre. */
struct pencil {
  struct um_geometry_ray *ray;
  struct um_geometry_hit *hit;
  uint8_t *occluded;
  double *sum; /* [nbin] */
};

/* Turn the hits into shadow rays; samples that saw no surface get a ray that is ignored. */
static void shadow_rays(const struct um_geometry_mesh *mesh, const struct um_geometry_pose *pose,
                        const struct um_optics_instant *now, uint64_t key, size_t n,
                        struct pencil *pencil)
{
  struct um_vec3 t, b;
  um_core_vec3_frame(now->sun_body, &t, &b);
  double size = tan(now->sun_radius);
  for (size_t i = 0; i < n; i++) {
    const struct um_geometry_hit *hit = &pencil->hit[i];
    struct um_vec3 p = um_vec3(0.0, 0.0, 0.0);
    for (int k = 0; k < 3 && hit->facet != UM_GEOMETRY_NONE; k++)
      p = um_vec3_axpy(p, hit->weight[k], pose->vertex[mesh->corner[hit->facet][k]]);
    double u[4], xy[2];
    um_optics_sample_4d(key, i, u);
    um_core_sample_disc(u + 2, xy);
    struct um_vec3 d = um_vec3_axpy(now->sun_body, size * xy[0], t);
    d = um_vec3_unit(um_vec3_axpy(d, size * xy[1], b));
    pencil->ray[i] = (struct um_geometry_ray){p, d, INFINITY, hit->facet};
  }
}

static void render_pixel(const struct um_optics_set *set, const struct um_geometry_mesh *mesh,
                         const struct um_optics_instant *now, const struct camera *camera,
                         const struct palette *palette, int x, int y, size_t nsample,
                         struct pencil *pencil, struct um_optics_image *image)
{
  size_t nbin = image->nbin, pixel = (size_t)y * (size_t)image->width + (size_t)x;
  uint64_t key = um_core_hash(KEY_PIXEL, pixel);
  pencil->ray[nsample] = camera_ray(camera, image->pixel_size, x + 0.5, y + 0.5);
  for (size_t i = 0; i < nsample; i++) {
    double u[4];
    um_optics_sample_4d(key, i, u);
    pencil->ray[i] = camera_ray(camera, image->pixel_size, x + u[0], y + u[1]);
  }
  um_geometry_visibility_closest(set->visibility, pencil->ray, nsample + 1, pencil->hit);
  image->surface[pixel] = pencil->hit[nsample].facet == UM_GEOMETRY_NONE
                              ? UM_GEOMETRY_NONE
                              : pencil->hit[nsample].surface;
  bool any = false;
  for (size_t i = 0; i < nsample; i++) {
    if (pencil->hit[i].facet == UM_GEOMETRY_NONE) pencil->hit[i].surface = UM_GEOMETRY_NONE;
    any = any || pencil->hit[i].surface != UM_GEOMETRY_NONE;
  }
  if (!any) return;
  if (now->sun > 0.0) {
    shadow_rays(mesh, set->pose, now, key, nsample, pencil);
    um_geometry_visibility_occluded(set->visibility, pencil->ray, nsample, pencil->occluded);
  } else {
    memset(pencil->occluded, 1, nsample);
  }
  memset(pencil->sum, 0, nbin * sizeof *pencil->sum);
  for (size_t i = 0; i < nsample; i++) {
    if (pencil->hit[i].surface == UM_GEOMETRY_NONE) continue;
    const double *dark = palette->dark + pencil->hit[i].surface * nbin;
    const double *sun = palette->sun + pencil->hit[i].surface * nbin;
    double lit = pencil->occluded[i] ? 0.0 : 1.0;
    for (size_t b = 0; b < nbin; b++) pencil->sum[b] += dark[b] + lit * sun[b];
  }
  for (size_t b = 0; b < nbin; b++)
    image->radiance[pixel * nbin + b] = (float)(pencil->sum[b] / (double)nsample);
}

struct render {
  const struct um_optics_scene *scene;
  const struct um_optics_image_options *options;
  size_t time, nthread;
  struct um_optics_spectra *spectra;
  struct um_optics_stage *stage;
  struct um_optics_work *work; /* [nthread] */
  struct palette palette;
  struct pencil *pencil; /* [nthread] */
};

static enum um_status image_create(struct um_context *context, const struct render *r,
                                   struct um_optics_image *image)
{
  const struct um_optics_spectra *spectra = r->spectra;
  size_t npixel = (size_t)image->width * (size_t)image->height;
  double nsurface = (double)um_geometry_mesh(r->scene->geometry)->nsurface;
  double bytes = (double)spectra->nbin * (4.0 * (double)npixel + 16.0 * nsurface);
  image->nbin = spectra->nbin;
  if (!(bytes <= MEMORY_MOST))
    return um_core_fail(context, UM_ERR_INPUT,
                        "image: %d x %d pixels and %g surfaces at %zu wavelengths take %.3g GB; "
                        "accepted: up to %g GB, by a smaller width or fewer bins of the band",
                        image->width, image->height, nsurface, spectra->nbin, bytes * 1e-9,
                        MEMORY_MOST * 1e-9);
  UM_TRY(um_core_allocate(context, image->nbin, sizeof(double), &image->wavelength));
  UM_TRY(um_core_allocate(context, image->nbin, sizeof(double), &image->bin_width));
  UM_TRY(um_core_allocate(context, image->nbin, sizeof(double), &image->transmission));
  UM_TRY(um_core_allocate(context, npixel * image->nbin, sizeof(float), &image->radiance));
  UM_TRY(um_core_allocate(context, npixel, sizeof(uint32_t), &image->surface));
  memcpy(image->wavelength, spectra->wavelength, image->nbin * sizeof(double));
  memcpy(image->bin_width, spectra->width, image->nbin * sizeof(double));
  memcpy(image->transmission, spectra->transmission, image->nbin * sizeof(double));
  return UM_OK;
}

static enum um_status scratch_create(struct um_context *context, struct render *r)
{
  size_t nsurface = um_geometry_mesh(r->scene->geometry)->nsurface, nbin = r->spectra->nbin;
  size_t nray = (size_t)r->options->samples_per_pixel + 1;
  int nexchange = r->scene->interreflection_samples;
  UM_TRY(um_core_allocate(context, nsurface * nbin, sizeof(double), &r->palette.dark));
  UM_TRY(um_core_allocate(context, nsurface * nbin, sizeof(double), &r->palette.sun));
  UM_TRY(um_optics_work_create(context, r->spectra, nexchange > 0 ? (size_t)nexchange : 0,
                               r->nthread, &r->work));
  UM_TRY(um_core_allocate(context, r->nthread, sizeof *r->pencil, &r->pencil));
  for (size_t i = 0; i < r->nthread; i++) {
    struct pencil *p = &r->pencil[i];
    UM_TRY(um_core_allocate(context, nray, sizeof *p->ray, &p->ray));
    UM_TRY(um_core_allocate(context, nray, sizeof *p->hit, &p->hit));
    UM_TRY(um_core_allocate(context, nray, 1, &p->occluded));
    UM_TRY(um_core_allocate(context, nbin, sizeof *p->sum, &p->sum));
  }
  return UM_OK;
}

static void render_clear(struct um_context *context, struct render *r)
{
  for (size_t i = 0; r->pencil != NULL && i < r->nthread; i++) {
    um_core_free(context, r->pencil[i].ray);
    um_core_free(context, r->pencil[i].hit);
    um_core_free(context, r->pencil[i].occluded);
    um_core_free(context, r->pencil[i].sum);
  }
  um_core_free(context, r->pencil);
  um_core_free(context, r->palette.dark);
  um_core_free(context, r->palette.sun);
  um_optics_work_destroy(context, r->nthread, &r->work);
  if (r->stage != NULL) um_optics_stage_clear(context, r->stage);
  um_core_free(context, r->stage);
  um_optics_spectra_destroy(context, &r->spectra);
}

static enum um_status render_all(struct um_context *context, struct render *r,
                                 struct um_optics_image *image)
{
  const struct um_optics_scene *scene = r->scene;
  const struct um_environment_sample *sample = &scene->samples[r->time];
  const struct um_geometry_mesh *mesh = um_geometry_mesh(scene->geometry);
  UM_TRY(um_optics_stage_prepare(context, scene->geometry, sample, 1,
                                 scene->interreflection_samples, r->stage));
  const struct um_optics_set *set = &r->stage->set[0];
  struct um_optics_instant now = um_optics_instant(scene, r->time);
  struct camera camera;
  UM_TRY(camera_create(context, r->options, mesh, set->pose, sample->q, now.observer_body, &camera,
                       image));
  UM_TRY(image_create(context, r, image));
  UM_TRY(scratch_create(context, r));
  for (size_t i = 0; i < r->nthread; i++) {
    um_optics_light(r->spectra, scene, &now, &r->work[i]);
    um_optics_turn(r->spectra, scene, &now, &r->work[i]);
  }
  int threads = (int)r->nthread;
#pragma omp parallel for schedule(dynamic, 16) num_threads(threads)
  for (size_t s = 0; s < mesh->nsurface; s++)
    if (!um_core_stopped(context))
      palette_fill(r->spectra, scene, &now, set, r->time, s, &r->work[omp_get_thread_num()],
                   &r->palette);
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
  for (int y = 0; y < image->height; y++)
    for (int x = 0; x < image->width && !um_core_stopped(context); x++)
      render_pixel(set, mesh, &now, &camera, &r->palette, x, y,
                   (size_t)r->options->samples_per_pixel, &r->pencil[omp_get_thread_num()], image);
  return um_core_stop_check(context, "a picture was rendered");
}

enum um_status um_optics_image_render(struct um_context *context,
                                      const struct um_optics_scene *scene, size_t time,
                                      const struct um_optics_band *band,
                                      const struct um_optics_image_options *options,
                                      struct um_optics_image **out)
{
  enum um_status status = UM_OK;
  struct um_optics_image *image = NULL;
  struct render r = {.scene = scene,
                     .options = options,
                     .time = time,
                     .nthread = (size_t)um_core_context_threads(context)};
  *out = NULL;
  if (options->width < 1 || options->width > WIDTH_MAX)
    return um_core_fail(context, UM_ERR_INPUT, "image: width %d pixels; accepted: 1 to %d",
                        options->width, WIDTH_MAX);
  if (options->samples_per_pixel < 1 || options->samples_per_pixel > SAMPLES_MAX)
    return um_core_fail(context, UM_ERR_INPUT, "image: %d samples per pixel; accepted: 1 to %d",
                        options->samples_per_pixel, SAMPLES_MAX);
  UM_CHECK(um_core_allocate(context, 1, sizeof *image, &image));
  UM_CHECK(um_core_allocate(context, 1, sizeof *r.stage, &r.stage));
  UM_CHECK(um_optics_spectra_create(context, scene, time, 1, band, 1, &r.spectra));
  UM_CHECK(render_all(context, &r, image));
  *out = image;
  image = NULL;
done:
  render_clear(context, &r);
  um_optics_image_destroy(context, &image);
  return status;
}

void um_optics_image_destroy(struct um_context *context, struct um_optics_image **image)
{
  if (image == NULL || *image == NULL) return;
  struct um_optics_image *i = *image;
  um_core_free(context, i->wavelength);
  um_core_free(context, i->bin_width);
  um_core_free(context, i->transmission);
  um_core_free(context, i->radiance);
  um_core_free(context, i->surface);
  um_core_free(context, i);
  *image = NULL;
}
