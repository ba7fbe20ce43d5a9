/* Embree behind occlusion and closest hit; versions 3 and 4.
 *
 * Embree works in float, so it proposes and double precision disposes: its filter hands every
 * candidate facet to hit_is_real(), which refuses
 *  - the facet that the ray leaves;
 *  - every facet that does not rise above the plane of that facet on the ray's side: such a facet
 *    cannot be met, so that neighbours in one plane or behind it never shadow each other, however
 *    grazing the ray;
 *  - a candidate that the ray misses in double precision by more than float can blur, or that lies
 *    beyond the limit or behind the origin.
 * No epsilon moves an origin. A candidate costs as much as a ray, and nearly all would be the facet
 * that the ray leaves: Embree is asked from where the ray has come SKIN above it. Rays go in
 * packets of eight whatever their number, in the order in which they come; scenes are robust
 * (watertight at shared edges). */
#include "geometry/visibility_impl.h"

#if UM_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#include <stdio.h>
#include <string.h>

#include "geometry/shades_impl.h"
#include "geometry/visibility_data_impl.h"

#define PACKET 8

/* Height above the facet that a ray leaves below which nothing is met, relative to the model size
 * [1]: 0.4 um of 20 m, what float rounds coordinates by. At most SHALLOW^-1 as far along the ray.
 */
#define SKIN    2e-8
#define SHALLOW 0.05

#if RTC_VERSION_MAJOR >= 4
typedef struct RTCRayQueryContext embree_context;
#else
typedef struct RTCIntersectContext embree_context;
#endif

/* What the filter needs of the packet in flight; Embree's part comes first. */
struct query {
  embree_context embree;
  const struct um_geometry_visibility *visibility;
  const struct um_geometry_ray *rays; /* of this packet; a ray's id is its index */
};

struct triangle {
  struct um_vec3 a, ab, ac;
};

static struct triangle triangle_of(const struct um_geometry_visibility *v, uint32_t facet)
{
  const uint32_t *c = v->mesh->corner[facet];
  struct um_vec3 a = v->pose->vertex[c[0]];
  return (struct triangle){a, um_vec3_sub(v->pose->vertex[c[1]], a),
                           um_vec3_sub(v->pose->vertex[c[2]], a)};
}

/* Moeller & Trumbore 1997: origin + t d = a + u ab + w ac; false when the ray is parallel. */
static bool intersect(const struct triangle *tri, const struct um_geometry_ray *ray, double *t,
                      double *u, double *w)
{
  struct um_vec3 p = um_vec3_cross(ray->direction, tri->ac);
  double det = um_vec3_dot(tri->ab, p);
  if (!(fabs(det) > 1e-12 * um_vec3_norm(tri->ab) * um_vec3_norm(tri->ac))) return false;
  struct um_vec3 s = um_vec3_sub(ray->origin, tri->a), q = um_vec3_cross(s, tri->ab);
  *u = um_vec3_dot(s, p) / det;
  *w = um_vec3_dot(ray->direction, q) / det;
  *t = um_vec3_dot(tri->ac, q) / det;
  return true;
}

/* True when a corner of `facet` stands above the plane of `from`, seen along the ray. */
static bool rises_above(const struct um_geometry_visibility *v, uint32_t facet, uint32_t from,
                        struct um_vec3 direction)
{
  struct um_vec3 n = v->pose->facet_normal[from];
  if (um_vec3_dot(n, direction) < 0.0) n = um_vec3_scale(n, -1.0);
  struct um_vec3 base = v->pose->vertex[v->mesh->corner[from][0]];
  for (int k = 0; k < 3; k++) {
    struct um_vec3 p = v->pose->vertex[v->mesh->corner[facet][k]];
    if (um_vec3_dot(um_vec3_sub(p, base), n) > UM_GEOMETRY_PLANE * v->size) return true;
  }
  return false;
}

static bool hit_is_real(const struct um_geometry_visibility *v, const struct um_geometry_ray *ray,
                        uint32_t facet)
{
  if (ray->from_facet != UM_GEOMETRY_NONE &&
      (facet == ray->from_facet || !rises_above(v, facet, ray->from_facet, ray->direction)))
    return false;
  struct triangle tri = triangle_of(v, facet);
  double t, u, w;
  if (!intersect(&tri, ray, &t, &u, &w)) return true; /* seen edge-on: Embree's word */
  if (!(t >= 0.0 && t <= ray->limit)) return false;
  /* blur of the barycentric weights: that of the hit point over the smallest height */
  struct um_vec3 bc = um_vec3_sub(tri.ac, tri.ab);
  double longest = sqrt(
      fmax(um_vec3_dot(bc, bc), fmax(um_vec3_dot(tri.ab, tri.ab), um_vec3_dot(tri.ac, tri.ac))));
  double blur = UM_GEOMETRY_BLUR * v->size * longest / (2.0 * v->mesh->area[facet]);
  return u >= -blur && w >= -blur && u + w <= 1.0 + blur;
}

/* Word i of row `row` of Embree's packet layout (rows of N words). */
static uint32_t packet_word(const void *packet, size_t row, size_t n, size_t i)
{
  uint32_t word;
  memcpy(&word, (const char *)packet + 4 * (row * n + i), sizeof word);
  return word;
}

/* Rows of RTCRayN and RTCHitN that the filter reads. */
#define RAY_ROW_ID        10
#define HIT_ROW_PRIMITIVE 5

static void filter(const struct RTCFilterFunctionNArguments *arguments)
{
  const struct query *query = (const struct query *)(const void *)arguments->context;
  for (size_t i = 0; i < arguments->N; i++) {
    if (arguments->valid[i] == 0) continue;
    uint32_t id = packet_word(arguments->ray, RAY_ROW_ID, arguments->N, i);
    uint32_t facet = packet_word(arguments->hit, HIT_ROW_PRIMITIVE, arguments->N, i);
    if (!hit_is_real(query->visibility, &query->rays[id], facet)) arguments->valid[i] = 0;
  }
}

/* First error that Embree reported, kept by the callback. */
struct embree_error {
  int code; /* enum RTCError, 0: none */
  char text[256];
};

static void keep_error(void *self, enum RTCError code, const char *text)
{
  struct embree_error *error = self;
  if (error->code != 0 || code == RTC_ERROR_NONE) return;
  error->code = (int)code;
  snprintf(error->text, sizeof error->text, "%s", text == NULL ? "no text" : text);
}

static enum um_status embree_status(struct um_context *context, const struct embree_error *error)
{
  if (error->code == 0) return UM_OK;
  if (error->code == RTC_ERROR_OUT_OF_MEMORY)
    return um_core_fail(context, UM_ERR_MEMORY, "Embree: out of memory: %s", error->text);
  return um_core_fail(context, UM_ERR_LIBRARY, "Embree error %d: %s", error->code, error->text);
}

/* Triangles about the centre, in float. */
static void fill_geometry(const struct um_geometry_visibility *v, RTCGeometry geometry)
{
  const struct um_geometry_mesh *mesh = v->mesh;
  float *xyz = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                       3 * sizeof(float), mesh->nvertex);
  unsigned *corner = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                             3 * sizeof(unsigned), mesh->nfacet);
  if (xyz == NULL || corner == NULL) return; /* the device has the error */
  for (size_t i = 0; i < mesh->nvertex; i++) {
    struct um_vec3 p = um_vec3_sub(v->pose->vertex[i], v->centre);
    xyz[3 * i] = (float)p.x;
    xyz[3 * i + 1] = (float)p.y;
    xyz[3 * i + 2] = (float)p.z;
  }
  for (size_t f = 0; f < mesh->nfacet; f++)
    for (size_t k = 0; k < 3; k++) corner[3 * f + k] = mesh->corner[f][k];
  rtcSetGeometryIntersectFilterFunction(geometry, filter);
  rtcSetGeometryOccludedFilterFunction(geometry, filter);
  rtcCommitGeometry(geometry);
}

/* Embree asks while it builds its tree. */
static bool goes_on(void *self, double done)
{
  (void)done;
  return !um_core_stopped(self);
}

static enum um_status create_scene(struct um_geometry_visibility *v)
{
  struct embree_error error = {0, ""};
  /* one build thread: the tree, and so the order of candidates, does not depend on the machine */
  RTCDevice device = rtcNewDevice("threads=1,set_affinity=0");
  if (device == NULL) {
    keep_error(&error, rtcGetDeviceError(NULL), "no device");
    return um_core_fail(v->context, UM_ERR_LIBRARY, "Embree error %d: no device", error.code);
  }
  v->device = device;
  rtcSetDeviceErrorFunction(device, keep_error, &error);
  if (rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_FILTER_FUNCTION_SUPPORTED) == 0)
    return um_core_fail(v->context, UM_ERR_LIBRARY,
                        "Embree was built without filter functions, which exclude self-hits");
  RTCScene scene = rtcNewScene(device);
  v->scene = scene;
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  if (scene != NULL && geometry != NULL) {
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    fill_geometry(v, geometry);
    rtcAttachGeometry(scene, geometry);
    rtcSetSceneProgressMonitorFunction(scene, goes_on, v->context);
    rtcCommitScene(scene);
  }
  if (geometry != NULL) rtcReleaseGeometry(geometry);
  rtcSetDeviceErrorFunction(device, NULL, NULL);
  UM_TRY(um_core_stop_check(v->context, "rays were prepared"));
  return embree_status(v->context, &error);
}

static void find_size(struct um_geometry_visibility *v)
{
  struct um_vec3 low = v->pose->vertex[0], high = low;
  for (size_t i = 1; i < v->mesh->nvertex; i++) {
    struct um_vec3 p = v->pose->vertex[i];
    low = um_vec3(fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z));
    high = um_vec3(fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z));
  }
  v->centre = um_vec3_scale(um_vec3_add(low, high), 0.5);
  v->size = um_vec3_norm(um_vec3_sub(high, low));
}

enum um_status um_geometry_visibility_create(struct um_context *context,
                                             const struct um_geometry_mesh *mesh,
                                             const struct um_geometry_pose *pose,
                                             struct um_geometry_visibility **out)
{
  enum um_status status;
  struct um_geometry_visibility *v = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *v, (void *)&v));
  v->context = context;
  v->mesh = mesh;
  v->pose = pose;
  find_size(v);
  um_geometry_points_fill(v);
  UM_CHECK(um_core_allocate(context, mesh->nsurface, 1, (void *)&v->open));
  UM_CHECK(um_geometry_horizon_find(v));
  UM_CHECK(um_geometry_shades_find(v));
  UM_CHECK(create_scene(v));
  *out = v;
  v = NULL;
done:
  um_geometry_visibility_destroy(&v);
  return status;
}

void um_geometry_visibility_destroy(struct um_geometry_visibility **visibility)
{
  if (visibility == NULL || *visibility == NULL) return;
  struct um_geometry_visibility *v = *visibility;
  if (v->scene != NULL) rtcReleaseScene(v->scene);
  if (v->device != NULL) rtcReleaseDevice(v->device);
  UM_FREE(v->context, v->open, v->before, v->before_begin, v);
  *visibility = NULL;
}

bool um_geometry_visibility_is_open(const struct um_geometry_visibility *visibility, size_t surface)
{
  return visibility->open[surface] != 0;
}

/* Where on a ray Embree is asked from [lengths of its direction]. */
static double nearest(const struct um_geometry_visibility *v, const struct um_geometry_ray *ray)
{
  if (ray->from_facet == UM_GEOMETRY_NONE) return 0.0;
  double rise = fabs(um_vec3_dot(v->pose->facet_normal[ray->from_facet], ray->direction));
  return SKIN * v->size / (rise > SHALLOW ? rise : SHALLOW);
}

/* Up to eight rays into a packet; the double-precision limit is kept by the filter. */
static void fill_packet(const struct um_geometry_visibility *v, const struct um_geometry_ray *rays,
                        size_t n, int valid[PACKET], struct RTCRay8 *packet)
{
  for (size_t i = 0; i < PACKET; i++) {
    const struct um_geometry_ray *ray = &rays[i < n ? i : 0];
    struct um_vec3 o = um_vec3_sub(ray->origin, v->centre);
    valid[i] = i < n ? -1 : 0;
    packet->org_x[i] = (float)o.x;
    packet->org_y[i] = (float)o.y;
    packet->org_z[i] = (float)o.z;
    packet->dir_x[i] = (float)ray->direction.x;
    packet->dir_y[i] = (float)ray->direction.y;
    packet->dir_z[i] = (float)ray->direction.z;
    packet->tnear[i] = (float)nearest(v, ray);
    packet->tfar[i] = (float)(ray->limit * (1.0 + UM_GEOMETRY_BLUR) + UM_GEOMETRY_BLUR * v->size);
    packet->time[i] = 0.0f;
    packet->mask[i] = 0xffffffffu;
    packet->id[i] = (unsigned)i;
    packet->flags[i] = 0;
  }
}

static void occluded_packet(const struct um_geometry_visibility *v,
                            const struct um_geometry_ray *rays, size_t n, bool coherent,
                            uint8_t *occluded)
{
  _Alignas(32) int valid[PACKET];
  struct RTCRay8 packet;
  struct query query = {.visibility = v, .rays = rays};
  fill_packet(v, rays, n, valid, &packet);
#if RTC_VERSION_MAJOR >= 4
  struct RTCOccludedArguments arguments;
  rtcInitRayQueryContext(&query.embree);
  rtcInitOccludedArguments(&arguments);
  arguments.context = &query.embree;
  if (coherent) arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  rtcOccluded8(valid, v->scene, &packet, &arguments);
#else
  rtcInitIntersectContext(&query.embree);
  if (coherent) query.embree.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcOccluded8(valid, v->scene, &query.embree, &packet);
#endif
  for (size_t i = 0; i < n; i++) occluded[i] = packet.tfar[i] < 0.0f; /* -inf: something is hit */
}

/* Once a stop has been asked for no ray is traced any more: what comes back is hidden, and whoever
 * asked for the rays finds the stop when it looks. */
static bool stopped(const struct um_geometry_visibility *v, size_t n, uint8_t *occluded)
{
  if (!um_core_stopped(v->context)) return false;
  memset(occluded, 1, n);
  return true;
}

void um_geometry_visibility_occluded(const struct um_geometry_visibility *visibility,
                                     const struct um_geometry_ray *rays, size_t n,
                                     uint8_t *occluded)
{
  if (stopped(visibility, n, occluded)) return;
  for (size_t i = 0; i < n; i += PACKET)
    occluded_packet(visibility, rays + i, n - i < PACKET ? n - i : PACKET, false, occluded + i);
}

void um_geometry_visibility_occluded_coherent(const struct um_geometry_visibility *visibility,
                                              const struct um_geometry_ray *rays, size_t n,
                                              uint8_t *occluded)
{
  if (stopped(visibility, n, occluded)) return;
  for (size_t i = 0; i < n; i += PACKET)
    occluded_packet(visibility, rays + i, n - i < PACKET ? n - i : PACKET, true, occluded + i);
}

/* Distance and weights of a hit in double precision; Embree's own where the facet is edge-on. */
static struct um_geometry_hit refine_hit(const struct um_geometry_visibility *v,
                                         const struct um_geometry_ray *ray, uint32_t facet,
                                         double t, double u, double w)
{
  struct triangle tri = triangle_of(v, facet);
  double exact_t, exact_u, exact_w;
  if (intersect(&tri, ray, &exact_t, &exact_u, &exact_w)) {
    t = exact_t;
    u = exact_u;
    w = exact_w;
  }
  u = fmin(fmax(u, 0.0), 1.0);
  w = fmin(fmax(w, 0.0), 1.0 - u);
  bool back = um_vec3_dot(v->pose->facet_normal[facet], ray->direction) > 0.0;
  uint32_t surface = back ? v->mesh->surface_of_back[facet] : v->mesh->surface_of_front[facet];
  return (struct um_geometry_hit){facet, surface, t, {1.0 - u - w, u, w}};
}

static void closest_packet(const struct um_geometry_visibility *v,
                           const struct um_geometry_ray *rays, size_t n,
                           struct um_geometry_hit *hits)
{
  _Alignas(32) int valid[PACKET];
  struct RTCRayHit8 packet;
  struct query query = {.visibility = v, .rays = rays};
  fill_packet(v, rays, n, valid, &packet.ray);
  for (size_t i = 0; i < PACKET; i++) {
    packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.primID[i] = RTC_INVALID_GEOMETRY_ID;
  }
#if RTC_VERSION_MAJOR >= 4
  struct RTCIntersectArguments arguments;
  rtcInitRayQueryContext(&query.embree);
  rtcInitIntersectArguments(&arguments);
  arguments.context = &query.embree;
  rtcIntersect8(valid, v->scene, &packet, &arguments);
#else
  rtcInitIntersectContext(&query.embree);
  rtcIntersect8(valid, v->scene, &query.embree, &packet);
#endif
  for (size_t i = 0; i < n; i++) {
    if (packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID)
      hits[i] = (struct um_geometry_hit){UM_GEOMETRY_NONE, UM_GEOMETRY_NONE, INFINITY, {0, 0, 0}};
    else
      hits[i] = refine_hit(v, &rays[i], packet.hit.primID[i], (double)packet.ray.tfar[i],
                           (double)packet.hit.u[i], (double)packet.hit.v[i]);
  }
}

void um_geometry_visibility_closest(const struct um_geometry_visibility *visibility,
                                    const struct um_geometry_ray *rays, size_t n,
                                    struct um_geometry_hit *hits)
{
  bool stop = um_core_stopped(visibility->context);
  for (size_t i = 0; stop && i < n; i++)
    hits[i] = (struct um_geometry_hit){UM_GEOMETRY_NONE, UM_GEOMETRY_NONE, INFINITY, {0, 0, 0}};
  for (size_t i = 0; !stop && i < n; i += PACKET)
    closest_packet(visibility, rays + i, n - i < PACKET ? n - i : PACKET, hits + i);
}
