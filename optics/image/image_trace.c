/* What the pixels of a picture see: samples by surface, lit or not. Lines are traced in blocks, one
 * line a thread at a time; a sample is numbered by pixel, so the bytes do not depend on threads. */
#include <math.h>
#include <omp.h>
#include <string.h>

#include "optics/image/image_impl.h"
#include "optics/paths/sampling_group.h"

#define BLOCK_BYTES 67108864.0 /* of the shares of a block of lines */
#define BLOCK_MOST  256        /* lines */

enum { KEY_PIXEL = 0x70697865 };

/* Scratch of one thread: the rays of a pixel. */
struct pencil {
  struct um_geometry_ray *ray;
  struct um_geometry_hit *hit;
  uint8_t *occluded;
};

struct um_optics_tracer {
  const struct um_optics_exposure *frame;
  size_t nthread, nrow;                /* lines of a block */
  struct pencil *pencil;               /* [nthread] */
  uint32_t *end;                       /* [nrow][width] shares up to the pixel's end */
  struct um_optics_image_share *share; /* [nrow][width * samples] */
  double bytes;
  size_t covered;
};

static size_t rows_of(const struct um_context *context, const struct um_optics_exposure *frame)
{
  double row = (double)frame->camera.width * frame->samples * sizeof(struct um_optics_image_share);
  double n = fmax(floor(BLOCK_BYTES / row), um_core_context_threads(context));
  return (size_t)fmin(fmin(n, BLOCK_MOST), frame->camera.height);
}

double um_optics_tracer_bytes(const struct um_context *context,
                              const struct um_optics_exposure *frame)
{
  double row = (double)frame->camera.width *
               (4.0 + (double)frame->samples * (double)sizeof(struct um_optics_image_share));
  return row * (double)rows_of(context, frame);
}

static enum um_status tracer_fill(struct um_context *context, struct um_optics_tracer *t)
{
  size_t width = (size_t)t->frame->camera.width, n = (size_t)t->frame->samples;
  UM_TRY(um_core_allocate(context, t->nrow * width, sizeof *t->end, &t->end));
  UM_TRY(um_core_allocate(context, t->nrow * width * n, sizeof *t->share, &t->share));
  UM_TRY(um_core_allocate(context, t->nthread, sizeof *t->pencil, &t->pencil));
  for (size_t i = 0; i < t->nthread; i++) {
    struct pencil *p = &t->pencil[i];
    UM_TRY(um_core_allocate(context, n, sizeof *p->ray, &p->ray));
    UM_TRY(um_core_allocate(context, n, sizeof *p->hit, &p->hit));
    UM_TRY(um_core_allocate(context, n, 1, &p->occluded));
  }
  return UM_OK;
}

enum um_status um_optics_tracer_create(struct um_context *context,
                                       const struct um_optics_exposure *frame,
                                       struct um_optics_tracer **out)
{
  UM_TRY(um_core_allocate(context, 1, sizeof **out, out));
  struct um_optics_tracer *t = *out;
  t->frame = frame;
  t->nthread = (size_t)um_core_context_threads(context);
  t->nrow = rows_of(context, frame);
  enum um_status status = tracer_fill(context, t);
  if (status != UM_OK) um_optics_tracer_destroy(context, out);
  return status;
}

void um_optics_tracer_destroy(struct um_context *context, struct um_optics_tracer **tracer)
{
  if (*tracer == NULL) return;
  struct um_optics_tracer *t = *tracer;
  for (size_t i = 0; t->pencil != NULL && i < t->nthread; i++) {
    UM_FREE(context, t->pencil[i].ray, t->pencil[i].hit, t->pencil[i].occluded);
  }
  UM_FREE(context, t->pencil, t->end, t->share, t);
  *tracer = NULL;
}

/* Turn the hits into shadow rays; samples that saw no surface get a ray that is ignored. */
static void shadow_rays(const struct um_optics_exposure *frame, uint64_t key, size_t n,
                        struct pencil *pencil)
{
  const struct um_optics_lamp *lamp = &frame->now.lamp;
  struct um_vec3 t, b;
  um_core_vec3_frame(lamp->body, &t, &b);
  double size = tan(lamp->radius);
  for (size_t i = 0; i < n; i++) {
    const struct um_geometry_hit *hit = &pencil->hit[i];
    struct um_vec3 p = um_vec3(0.0, 0.0, 0.0);
    for (int k = 0; k < 3 && hit->facet != UM_GEOMETRY_NONE; k++)
      p = um_vec3_axpy(p, hit->weight[k],
                       frame->posed->pose->vertex[frame->mesh->corner[hit->facet][k]]);
    double u[4], xy[2];
    um_optics_sample_4d(key, i, u);
    um_core_sample_disc(u + 2, xy);
    struct um_vec3 d = um_vec3_axpy(lamp->body, size * xy[0], t);
    d = um_vec3_unit(um_vec3_axpy(d, size * xy[1], b));
    pencil->ray[i] = (struct um_geometry_ray){p, d, INFINITY, hit->facet};
  }
}

/* Shares of a pixel, in the order in which its samples met the surfaces; returns how many. */
static size_t trace_pixel(const struct um_optics_exposure *frame, int x, int y,
                          struct pencil *pencil, struct um_optics_image_share *share)
{
  size_t pixel = (size_t)y * (size_t)frame->camera.width + (size_t)x, n = (size_t)frame->samples;
  uint64_t key = um_core_hash(KEY_PIXEL, pixel);
  for (size_t i = 0; i < n; i++) {
    double u[4];
    um_optics_sample_4d(key, i, u);
    pencil->ray[i] = um_optics_camera_ray(&frame->camera, x + u[0], y + u[1]);
  }
  um_geometry_visibility_closest(frame->posed->visibility, pencil->ray, n, pencil->hit);
  bool any = false;
  for (size_t i = 0; i < n; i++) {
    /* a face without a side that radiates, met through a seam of the mesh, is no surface */
    if (pencil->hit[i].facet == UM_GEOMETRY_NONE) pencil->hit[i].surface = UM_GEOMETRY_NONE;
    any = any || pencil->hit[i].surface != UM_GEOMETRY_NONE;
  }
  if (!any) return 0;
  memset(pencil->occluded, 1, n);
  if (frame->now.lamp.shines) {
    shadow_rays(frame, key, n, pencil);
    um_geometry_visibility_occluded(frame->posed->visibility, pencil->ray, n, pencil->occluded);
  }
  size_t count = 0;
  for (size_t i = 0; i < n; i++) {
    if (pencil->hit[i].surface == UM_GEOMETRY_NONE) continue;
    uint32_t surface = pencil->hit[i].surface;
    size_t at = 0;
    while (at < count && share[at].spectrum != surface) at++;
    if (at == count) share[count++] = (struct um_optics_image_share){surface, 0, 0};
    share[at].seen++;
    if (!pencil->occluded[i]) share[at].lit++;
  }
  return count;
}

static void trace_row(const struct um_optics_tracer *t, size_t slot, int y, struct pencil *pencil)
{
  size_t width = (size_t)t->frame->camera.width, used = 0;
  uint32_t *end = t->end + slot * width;
  struct um_optics_image_share *share = t->share + slot * width * (size_t)t->frame->samples;
  for (size_t x = 0; x < width; x++) {
    used += trace_pixel(t->frame, (int)x, y, pencil, share + used);
    end[x] = (uint32_t)used;
  }
}

/* A traced line without its margins of sky, as small as it is. */
static enum um_status keep_row(struct um_context *context, struct um_optics_tracer *t, size_t slot,
                               struct um_optics_image_row *row)
{
  size_t width = (size_t)t->frame->camera.width, from = 0, to = width;
  const uint32_t *end = t->end + slot * width;
  uint32_t used = end[width - 1];
  if (used == 0) return UM_OK;
  while (end[from] == 0) from++;
  while (to - 1 > from && end[to - 2] == used) to--;
  size_t count = to - from;
  t->bytes += (double)(count + 1) * sizeof *row->first + (double)used * sizeof *row->share;
  if (!(t->bytes <= UM_OPTICS_IMAGE_BYTES))
    return um_core_fail(context, UM_ERR_INPUT,
                        "image: %d x %d pixels of %d samples take more than %.3g GB; accepted: up "
                        "to that, by a smaller --width or fewer --samples",
                        t->frame->camera.width, t->frame->camera.height, t->frame->samples,
                        UM_OPTICS_IMAGE_BYTES * 1e-9);
  UM_TRY(um_core_allocate(context, count + 1, sizeof *row->first, &row->first));
  UM_TRY(um_core_allocate(context, used, sizeof *row->share, &row->share));
  row->from = (uint32_t)from;
  row->count = (uint32_t)count;
  memcpy(row->first + 1, end + from, count * sizeof *row->first);
  memcpy(row->share, t->share + slot * width * (size_t)t->frame->samples,
         used * sizeof *row->share);
  for (size_t i = 0; i < count; i++) t->covered += row->first[i + 1] > row->first[i];
  return UM_OK;
}

enum um_status um_optics_tracer_run(struct um_context *context, struct um_optics_tracer *t,
                                    const int *y, size_t n, struct um_optics_image_row *row)
{
  int threads = (int)t->nthread;
  for (size_t from = 0; from < n; from += t->nrow) {
    size_t count = n - from < t->nrow ? n - from : t->nrow;
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
    for (size_t i = 0; i < count; i++)
      if (!um_core_stopped(context)) trace_row(t, i, y[from + i], &t->pencil[omp_get_thread_num()]);
    UM_TRY(um_core_stop_check(context, "a picture was rendered"));
    for (size_t i = 0; i < count; i++) UM_TRY(keep_row(context, t, i, &row[from + i]));
    UM_TRY(um_core_progress_step(context, count));
  }
  return UM_OK;
}

double um_optics_tracer_row_bytes(const struct um_optics_tracer *tracer) { return tracer->bytes; }

size_t um_optics_tracer_covered(const struct um_optics_tracer *tracer) { return tracer->covered; }
