/* Rays: um_geometry_visibility_occluded against what Embree does with eight rays at a time when
 * nothing else is asked of it, on the same rays in the same run, one thread.
 *
 * A bus, a two-sided array, a dish and a boom that shadow each other, in 12838 facets.
 * Coherent rays leave points of the facets toward the Sun, incoherent ones are cosine-weighted and
 * shuffled. Raw Embree gets packets that are ready, origins 1e-5 of the model off the facet, no
 * filter and the hint that fits; Umbra converts double to float, excludes the facet that a ray
 * leaves and its plane, and checks every hit in double precision. `toward` makes the rays too.
 *
 * Raw rates of packets of 4, 8 and 16 stand beside each other; ours is held against the best of
 * them that the machine has (16 wants AVX-512 to be one).
 *
 * Goals. Twice the raw cost: a double-precision ray of 64 bytes is read and turned, each candidate
 * calls back; most of those were the facet that the ray leaves, before it was spared. `toward`
 * thrice: it computes points as well. Wrong answers: none in 4000 against Moeller & Trumbore 1997
 * in double precision over all facets. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "geometry/visibility.h"
#include "tests/bench/bench.h"

#if UM_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#define RUNS    9
#define WIDTHS  3
#define SAMPLES 16
#define CHECKED 4000
#define OFFSET  1e-5 /* of the model size, for raw Embree's origins [1] */

struct model {
  struct um_geometry *geometry;
  const struct um_geometry_mesh *mesh;
  struct um_geometry_pose *pose;
  struct um_geometry_visibility *visibility;
  struct um_vec3 sun;
};

/* Rays in Umbra's and in Embree's form. */
struct rays {
  size_t n; /* a multiple of 16 */
  struct um_geometry_ray *ray;
  struct RTCRay8 *packet; /* [n / 8] */
  uint8_t *occluded, *raw;
};

static struct model model_create(const struct bench *bench)
{
  static const struct um_geometry_skin closed = {NULL, "mli", NULL}, open = {NULL, "cell", "cfrp"};
  const struct um_quat straight = {1, 0, 0, 0};
  const struct um_geometry_part_spec part[] = {{.name = "bus",
                                                .shape = UM_SHAPE_BOX,
                                                .size = {10.0, 2.8, 2.1},
                                                .rotation = straight,
                                                .skins = &closed,
                                                .nskin = 1,
                                                .facet_size = 0.3},
                                               {.name = "array",
                                                .shape = UM_SHAPE_PLATE,
                                                .size = {14.0, 5.0},
                                                .rotation = straight,
                                                .position = {-13.0, 0.0, 0.0},
                                                .skins = &open,
                                                .nskin = 1,
                                                .facet_size = 0.3},
                                               {.name = "dish",
                                                .shape = UM_SHAPE_PARABOLOID,
                                                .radius = 1.5,
                                                .focal_length = 1.0,
                                                .rotation = straight,
                                                .position = {2.0, 0.0, 1.3},
                                                .skins = &open,
                                                .nskin = 1,
                                                .facet_size = 0.15},
                                               {.name = "boom",
                                                .shape = UM_SHAPE_CYLINDER,
                                                .radius = 0.1,
                                                .height = 4.0,
                                                .rotation = straight,
                                                .position = {4.5, 0.0, 3.1},
                                                .skins = &closed,
                                                .nskin = 1,
                                                .facet_size = 0.1}};
  struct model m = {.sun = um_vec3_unit(um_vec3(0.55, 0.3, 0.78))};
  struct um_context *context = bench->context;
  bench_must(bench, um_geometry_create(context, part, sizeof part / sizeof part[0], &m.geometry));
  m.mesh = um_geometry_mesh(m.geometry);
  bench_must(bench, um_geometry_pose_create(context, m.geometry, NULL, &m.pose));
  bench_must(bench, um_geometry_visibility_create(context, m.mesh, m.pose, &m.visibility));
  return m;
}

/* Surfaces whose rays `toward` traces: not open, facing the Sun. */
static bool is_asked(const struct model *m, size_t s)
{
  return !um_geometry_visibility_is_open(m->visibility, s) &&
         um_vec3_dot(um_geometry_surface_normal(m->mesh, m->pose, s), m->sun) > 0.0;
}

static struct rays rays_create(const struct bench *bench, const struct model *m, bool coherent)
{
  size_t n = 0, room = m->mesh->nsurface * SAMPLES;
  struct rays r = {.ray = bench_allocate(bench, room, sizeof *r.ray)};
  for (size_t s = 0; s < m->mesh->nsurface; s++) {
    if (!is_asked(m, s)) continue;
    uint32_t facet = m->mesh->surface[s].facet;
    struct um_vec3 normal = um_geometry_surface_normal(m->mesh, m->pose, s);
    for (uint64_t k = 0; k < SAMPLES; k++, n++) {
      double u[2], w[3];
      struct um_vec3 origin = um_vec3(0, 0, 0);
      um_core_sample_2d(facet, k, u);
      um_core_sample_triangle(u, w);
      for (int c = 0; c < 3; c++)
        origin = um_vec3_axpy(origin, w[c], m->pose->vertex[m->mesh->corner[facet][c]]);
      um_core_sample_2d(~(uint64_t)facet, k, u);
      struct um_vec3 d = coherent ? m->sun : um_core_sample_cosine(u, normal);
      r.ray[n] = (struct um_geometry_ray){origin, d, INFINITY, facet};
    }
  }
  r.n = n - n % 16;
  for (size_t i = r.n; i-- > 1 && !coherent;) { /* Fisher & Yates, keyed */
    size_t j = um_core_hash(7, i) % (i + 1);
    struct um_geometry_ray swap = r.ray[i];
    r.ray[i] = r.ray[j];
    r.ray[j] = swap;
  }
  r.packet = bench_allocate(bench, r.n / 8 + 1, sizeof *r.packet + 32);
  r.packet = (struct RTCRay8 *)(void *)(((uintptr_t)r.packet + 31) & ~(uintptr_t)31);
  r.occluded = bench_allocate(bench, r.n, 1);
  r.raw = bench_allocate(bench, r.n, 1);
  return r;
}

/* Diagonal of the bounding box [m]. */
static double size_of(const struct model *m)
{
  struct um_vec3 low = m->pose->vertex[0], high = low;
  for (size_t i = 1; i < m->mesh->nvertex; i++) {
    struct um_vec3 p = m->pose->vertex[i];
    low = um_vec3(fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z));
    high = um_vec3(fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z));
  }
  return um_vec3_norm(um_vec3_sub(high, low));
}

/* Packets that Embree can take as they are. */
static void packets_fill(const struct model *m, struct rays *r)
{
  double offset = OFFSET * size_of(m);
  for (size_t i = 0; i < r->n; i++) {
    const struct um_geometry_ray *ray = &r->ray[i];
    struct um_vec3 n = m->pose->facet_normal[ray->from_facet];
    double side = um_vec3_dot(n, ray->direction) < 0.0 ? -offset : offset;
    struct um_vec3 o = um_vec3_axpy(ray->origin, side, n);
    struct RTCRay8 *p = &r->packet[i / 8];
    size_t k = i % 8;
    p->org_x[k] = (float)o.x;
    p->org_y[k] = (float)o.y;
    p->org_z[k] = (float)o.z;
    p->dir_x[k] = (float)ray->direction.x;
    p->dir_y[k] = (float)ray->direction.y;
    p->dir_z[k] = (float)ray->direction.z;
    p->tfar[k] = INFINITY;
    p->mask[k] = 0xffffffffU;
    p->id[k] = (unsigned)k;
  }
}

static RTCScene raw_scene(const struct model *m, RTCDevice device)
{
  RTCScene scene = rtcNewScene(device);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  float *xyz = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                       3 * sizeof(float), m->mesh->nvertex);
  unsigned *corner = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                             3 * sizeof(unsigned), m->mesh->nfacet);
  for (size_t i = 0; i < m->mesh->nvertex; i++) {
    xyz[3 * i] = (float)m->pose->vertex[i].x;
    xyz[3 * i + 1] = (float)m->pose->vertex[i].y;
    xyz[3 * i + 2] = (float)m->pose->vertex[i].z;
  }
  for (size_t f = 0; f < m->mesh->nfacet; f++)
    for (size_t k = 0; k < 3; k++) corner[3 * f + k] = m->mesh->corner[f][k];
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  return scene;
}

/* Rays [from, from + width) of those in packets of eight into one of another width, whose rows are
 * words: an RTCRayN of that width. */
static void packet_take(const struct rays *r, size_t from, size_t width, void *to)
{
  const size_t rows = sizeof(struct RTCRay8) / (8 * sizeof(float));
  for (size_t i = 0; i < width; i += 8) {
    const char *packet = (const char *)&r->packet[(from + i) / 8];
    size_t n = width < 8 ? width : 8;
    for (size_t row = 0; row < rows; row++)
      memcpy((char *)to + sizeof(float) * (row * width + i),
             packet + sizeof(float) * (row * 8 + (from + i) % 8), n * sizeof(float));
  }
}

/* Embree writes into the packets, so each is a copy. */
static void raw_trace(RTCScene scene, const struct rays *r, bool coherent, size_t width)
{
  _Alignas(64) int valid[16];
  union {
    struct RTCRay4 four;
    struct RTCRay8 eight;
    struct RTCRay16 sixteen;
    float word[sizeof(struct RTCRay16) / sizeof(float)];
  } ray;
  for (int k = 0; k < 16; k++) valid[k] = -1;
#if RTC_VERSION_MAJOR >= 4
  struct RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  if (coherent) arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
#define HOW            &arguments
#define ASK(n, packet) rtcOccluded##n(valid, scene, packet, HOW)
#else
  struct RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  if (coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
#define ASK(n, packet) rtcOccluded##n(valid, scene, &context, packet)
#endif
  const size_t limit = 8 * width; /* tfar is row 8 of a packet */
  for (size_t i = 0; i + width <= r->n; i += width) {
    packet_take(r, i, width, &ray);
    if (width == 4)
      ASK(4, &ray.four);
    else if (width == 8)
      ASK(8, &ray.eight);
    else
      ASK(16, &ray.sixteen);
    for (size_t k = 0; k < width; k++) r->raw[i + k] = ray.word[limit + k] < 0.0f;
  }
#undef ASK
}

/* Does a ray meet a facet other than its own, by more than rounding away from its own plane? */
static bool meets(const struct model *m, const struct um_geometry_ray *ray, uint32_t facet)
{
  const uint32_t *c = m->mesh->corner[facet];
  struct um_vec3 a = m->pose->vertex[c[0]];
  struct um_vec3 ab = um_vec3_sub(m->pose->vertex[c[1]], a);
  struct um_vec3 ac = um_vec3_sub(m->pose->vertex[c[2]], a);
  struct um_vec3 p = um_vec3_cross(ray->direction, ac), s = um_vec3_sub(ray->origin, a);
  struct um_vec3 q = um_vec3_cross(s, ab);
  double det = um_vec3_dot(ab, p);
  if (facet == ray->from_facet || det == 0.0) return false;
  double u = um_vec3_dot(s, p) / det, v = um_vec3_dot(ray->direction, q) / det;
  double t = um_vec3_dot(ac, q) / det;
  double rise = um_vec3_dot(ray->direction, m->pose->facet_normal[ray->from_facet]) * t;
  return t > 0.0 && fabs(rise) > 1e-9 && u >= 0.0 && v >= 0.0 && u + v <= 1.0;
}

/* Answers that differ from all facets in double precision, per ray checked [1]. */
static void check(const struct model *m, const struct rays *r, double *wrong, double *raw_wrong)
{
  size_t bad = 0, raw_bad = 0, n = r->n < CHECKED ? r->n : CHECKED;
  for (size_t k = 0; k < n; k++) {
    size_t i = k * (r->n / n);
    uint8_t expected = 0;
    for (uint32_t f = 0; f < m->mesh->nfacet && !expected; f++) expected = meets(m, &r->ray[i], f);
    bad += r->occluded[i] != expected;
    raw_bad += r->raw[i] != expected;
  }
  *wrong = (double)bad / (double)n;
  *raw_wrong = (double)raw_bad / (double)n;
}

static void kind(struct bench *bench, const struct model *m, RTCScene scene, const char *word,
                 bool coherent)
{
  struct rays r = rays_create(bench, m, coherent);
  static const size_t width[WIDTHS] = {4, 8, 16};
  struct bench_series mine = {.n = 0}, raw[WIDTHS] = {{.n = 0}}, toward = {.n = 0};
  double *fraction = bench_allocate(bench, m->mesh->nsurface, sizeof *fraction);
  double nanosecond = 1e9 / (double)r.n, wrong, raw_wrong;
  char name[80];
  packets_fill(m, &r);
  for (int i = 0; i < RUNS; i++) {
    for (size_t w = 0; w < WIDTHS; w++) {
      double a = bench_cpu();
      raw_trace(scene, &r, coherent, width[w]);
      bench_add(&raw[w], (bench_cpu() - a) * nanosecond);
    }
    double b = bench_cpu();
    um_geometry_visibility_occluded(m->visibility, r.ray, r.n, r.occluded);
    double c = bench_cpu();
    if (coherent) um_geometry_visibility_toward(m->visibility, m->sun, SAMPLES, fraction);
    double d = bench_cpu();
    bench_add(&mine, (c - b) * nanosecond);
    bench_add(&toward, (d - c) * nanosecond);
  }
  check(m, &r, &wrong, &raw_wrong);
  size_t hit = 0;
  for (size_t i = 0; i < r.n; i++) hit += r.occluded[i];
  snprintf(name, sizeof name, "%s: rays", word);
  bench_number(bench, name, "1", (double)r.n, NAN, NAN);
  snprintf(name, sizeof name, "%s: share that is occluded", word);
  bench_number(bench, name, "1", (double)hit / (double)r.n, NAN, NAN);
  const struct bench_series *best = &raw[0];
  for (size_t w = 0; w < WIDTHS; w++) {
    if (bench_median(&raw[w]) < bench_median(best)) best = &raw[w];
    snprintf(name, sizeof name, "%s: raw Embree, packets of %zu, per ray", word, width[w]);
    bench_time(bench, name, "ns", &raw[w], NULL, NAN);
  }
  snprintf(name, sizeof name, "%s: occluded, per ray, to the best of raw Embree", word);
  bench_time(bench, name, "ns", &mine, best, 2.0);
  if (coherent)
    bench_time(bench, "coherent: toward, per ray, to the best of raw Embree", "ns", &toward, best,
               3.0);
  snprintf(name, sizeof name, "%s: wrong answers", word);
  bench_number(bench, name, "1", wrong, 1.0 / CHECKED, 0.0);
  snprintf(name, sizeof name, "%s: wrong answers of raw Embree", word);
  bench_number(bench, name, "1", raw_wrong, NAN, NAN);
}

int main(int argc, char **argv)
{
  struct bench bench;
  bench_begin(&bench, argc, argv, "rays: occlusion of a satellite by itself, one thread");
  struct model m = model_create(&bench);
  bench_number(&bench, "facets", "1", (double)m.mesh->nfacet, NAN, NAN);
  RTCDevice device = rtcNewDevice("threads=1,set_affinity=0");
  RTCScene scene = raw_scene(&m, device);
  kind(&bench, &m, scene, "coherent", true);
  kind(&bench, &m, scene, "incoherent", false);
  rtcReleaseScene(scene);
  rtcReleaseDevice(device);
  um_geometry_visibility_destroy(&m.visibility);
  um_geometry_pose_destroy(bench.context, &m.pose);
  um_geometry_destroy(&m.geometry);
  return bench_end(&bench);
}
