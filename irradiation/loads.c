/* Loads on every surface along a timeline, before any optical property acts:
 *
 *   sun      free fraction * max(n . s, 0)                       rays, pose of each sample
 *   planet   pi F M_IR / pi of the unobstructed plate (exact) * free share of the visible cap
 *   albedo   the same with the reflected radiance of the cap
 *
 * The free share is sum(w L cos free) / sum(w L cos) over the directions of the cap. A rigid body
 * asks its sky, made once in body frame; where joints move, every sample has its own pose and rays
 * go from points of the facet toward the cap. Surfaces before which nothing stands need neither.
 * The solar factor is geometric (the shadow of the Earth is in `sunlit`); in deep eclipse, farther
 * than 120 s and one sample from sunlight, it is left 0. */
#include "irradiation/loads.h"

#include <math.h>
#include <string.h>

#include "irradiation/loads_impl.h"

#define DARK_MARGIN 120.0 /* [s] */
#define SKY_SAMPLES 4
#define BATCH       32 /* times whose scenes are alive together */

struct tracer {
  struct um_context *context;
  const struct um_geometry *geometry;
  const struct um_geometry_mesh *mesh;
  const struct um_environment *environment;
  const struct um_environment_sample *samples;
  const struct um_irradiation_turn *turn;   /* NULL: every sample has its own attitude alone */
  struct um_irradiation_loads *loads, *one; /* one: [BATCH] rows of single attitudes, with turn */
  struct um_quat *attitude;                 /* [BATCH][turn->n] scratch */
  int nsample;
  size_t njoint;
  bool moves;
  bool earth;          /* there is something of it to be traced */
  uint32_t *normal_of; /* [nsurface] class of surfaces of one part that share a normal */
  uint32_t *example;   /* [nnormal] a surface of each class */
  uint32_t *order;     /* [nsurface] surfaces, class by class */
  size_t nnormal;
  bool *bright;                  /* [ntime] solar rays are wanted */
  struct um_thermal_scene fixed; /* when nothing moves; else the pose of the first sample */
  double *angles;                /* [njoint] scratch */
  double *fraction;              /* [BATCH][nsurface] scratch */
  struct um_vec3 *normal;        /* [BATCH][nnormal] scratch */
  struct um_environment_earth_flux *flux;       /* [BATCH][nnormal] scratch */
  struct um_environment_earth_moments *moments; /* [BATCH][nnormal] scratch; NULL: not asked for */
};
static void scene_destroy(struct tracer *t, struct um_thermal_scene *s)
{
  um_core_free(t->context, s->row);
  um_core_free(t->context, s->freedom);
  um_geometry_visibility_destroy(&s->visibility);
  um_geometry_pose_destroy(t->context, &s->pose);
}

static enum um_status scene_create(struct tracer *t, const double *angles, bool sky,
                                   struct um_thermal_scene *s)
{
  UM_TRY(um_geometry_pose_create(t->context, t->geometry, angles, &s->pose));
  UM_TRY(um_geometry_visibility_create(t->context, t->mesh, s->pose, &s->visibility));
  return sky ? um_irradiation_scene_tabulate(t->context, t->mesh, SKY_SAMPLES, s) : UM_OK;
}

static struct um_vec3 sun_body(const struct um_environment_sample *sample)
{
  return um_quat_apply(sample->q, sample->sun);
}

/* Surfaces of one rigid part with the same normal share their unobstructed Earth loads. */
static enum um_status classify_normals(struct tracer *t, const struct um_geometry_pose *pose)
{
  size_t nslot = 16;
  while (nslot < 2 * t->mesh->nsurface) nslot *= 2;
  uint32_t *slot = NULL; /* open-addressing table of classes */
  UM_TRY(um_core_allocate(t->context, nslot, sizeof *slot, &slot));
  for (size_t i = 0; i < nslot; i++) slot[i] = UINT32_MAX;
  for (size_t s = 0; s < t->mesh->nsurface; s++) {
    struct um_vec3 n = um_geometry_surface_normal(t->mesh, pose, s);
    int64_t key[3] = {llround(n.x * 1e12), llround(n.y * 1e12), llround(n.z * 1e12)};
    uint32_t part = t->mesh->surface[s].part;
    uint64_t hash = part;
    for (int c = 0; c < 3; c++) hash = (hash ^ (uint64_t)key[c]) * 0x9e3779b97f4a7c15u;
    for (size_t i = (hash >> 20) & (nslot - 1);; i = (i + 1) & (nslot - 1)) {
      if (slot[i] == UINT32_MAX) {
        slot[i] = (uint32_t)t->nnormal;
        t->example[t->nnormal++] = (uint32_t)s;
      }
      uint32_t e = t->example[slot[i]];
      struct um_vec3 m = um_geometry_surface_normal(t->mesh, pose, e);
      t->normal_of[s] = slot[i];
      if (t->mesh->surface[e].part == part && llround(m.x * 1e12) == key[0] &&
          llround(m.y * 1e12) == key[1] && llround(m.z * 1e12) == key[2])
        break;
    }
  }
  um_core_free(t->context, slot);
  return UM_OK;
}

/* Rays are wanted in sunlight, within DARK_MARGIN of it or of an eclipse edge, and at the samples
 * next to those in sunlight. */
static void find_bright(struct tracer *t)
{
  const struct um_irradiation_loads *l = t->loads;
  double last = -INFINITY, next = INFINITY;
  for (size_t k = 0; k < l->ntime; k++) {
    if (l->sunlit[k] > 0.0) last = l->t[k];
    t->bright[k] = l->t[k] - last <= DARK_MARGIN || (k > 0 && l->sunlit[k - 1] > 0.0);
  }
  for (size_t k = l->ntime; k-- > 0;) {
    if (l->sunlit[k] > 0.0) next = l->t[k];
    if (next - l->t[k] <= DARK_MARGIN || (k + 1 < l->ntime && l->sunlit[k + 1] > 0.0))
      t->bright[k] = true;
    for (size_t e = 0; e < l->nedge; e++)
      if (fabs(l->edge[e] - l->t[k]) <= DARK_MARGIN) t->bright[k] = true;
  }
}

/* After classify_normals. */
static enum um_status order_by_normal(struct tracer *t)
{
  size_t nsurface = t->mesh->nsurface, *next = NULL;
  UM_TRY(um_core_allocate(t->context, t->nnormal + 1, sizeof *next, &next));
  for (size_t s = 0; s < nsurface; s++) next[t->normal_of[s] + 1]++;
  for (size_t i = 0; i < t->nnormal; i++) next[i + 1] += next[i];
  for (size_t s = 0; s < nsurface; s++) t->order[next[t->normal_of[s]]++] = (uint32_t)s;
  um_core_free(t->context, next);
  return UM_OK;
}

static enum um_status tracer_prepare(struct tracer *t)
{
  size_t nsurface = t->mesh->nsurface;
  UM_TRY(um_core_allocate(t->context, nsurface, sizeof *t->normal_of, &t->normal_of));
  UM_TRY(um_core_allocate(t->context, nsurface, sizeof *t->example, &t->example));
  UM_TRY(um_core_allocate(t->context, nsurface, sizeof *t->order, &t->order));
  UM_TRY(um_core_allocate(t->context, t->loads->ntime, sizeof *t->bright, &t->bright));
  UM_TRY(um_core_allocate(t->context, t->njoint, sizeof *t->angles, &t->angles));
  UM_TRY(um_core_allocate(t->context, BATCH * nsurface, sizeof *t->fraction, &t->fraction));
  find_bright(t);
  um_geometry_joint_angles(t->geometry, sun_body(&t->samples[0]), t->angles);
  UM_TRY(scene_create(t, t->njoint == 0 ? NULL : t->angles, t->earth && !t->moves, &t->fixed));
  UM_TRY(classify_normals(t, t->fixed.pose));
  UM_TRY(order_by_normal(t));
  UM_TRY(um_core_allocate(t->context, BATCH * t->nnormal, sizeof *t->normal, &t->normal));
  if (t->loads->planet_moments != NULL)
    UM_TRY(um_core_allocate(t->context, BATCH * t->nnormal, sizeof *t->moments, &t->moments));
  return um_core_allocate(t->context, BATCH * t->nnormal, sizeof *t->flux, &t->flux);
}

static void trace_sun(const struct tracer *t, const struct um_environment_sample *sample,
                      const struct um_thermal_scene *scene, double *fraction,
                      const struct um_irradiation_row *out)
{
  size_t nsurface = t->mesh->nsurface;
  struct um_vec3 sun = sun_body(sample);
  um_geometry_visibility_toward(scene->visibility, sun, t->nsample, fraction);
  for (size_t s = 0; s < nsurface; s++) {
    struct um_vec3 n = um_geometry_surface_normal(t->mesh, scene->pose, s);
    double cosine = fmax(um_vec3_dot(n, sun), 0.0);
    out->sun[s] = (float)(fraction[s] * cosine);
    out->incidence[s] = (float)cosine;
  }
}

static void trace_earth(const struct tracer *t, const struct um_environment_sample *sample,
                        const struct um_thermal_scene *scene, size_t slot,
                        const struct um_irradiation_row *out)
{
  struct um_vec3 r = um_quat_apply(sample->q, sample->r), sun = sun_body(sample);
  struct um_vec3 *normal = &t->normal[slot * t->nnormal];
  struct um_environment_earth_flux *flux = &t->flux[slot * t->nnormal];
  for (size_t i = 0; i < t->nnormal; i++)
    normal[i] = um_geometry_surface_normal(t->mesh, scene->pose, t->example[i]);
  struct um_environment_globe globe = {.t_tai = sample->t_tai,
                                       .pole = um_quat_apply(sample->q, sample->pole),
                                       .greenwich = um_quat_apply(sample->q, sample->greenwich)};
  bool by_angle = t->moments != NULL;
  struct um_environment_earth_moments *moments = by_angle ? &t->moments[slot * t->nnormal] : NULL;
  um_environment_earth_flux_by_angle(t->environment, &globe, r, sun, sample->sun_distance, normal,
                                     t->nnormal, flux, moments);
  struct um_thermal_cap cap;
  cap.n = um_environment_earth_cap(t->environment, &globe, r, sun, sample->sun_distance, cap.point);
  cap.varies = um_environment_earth_varies(t->environment);
  if (scene->row != NULL) um_irradiation_cap_spread(&cap);
  struct um_thermal_half half;
  size_t halved = SIZE_MAX; /* normal of `half` */
  for (size_t i = 0; i < t->mesh->nsurface && !um_core_stopped(t->context); i++) {
    size_t s = t->order[i], of = t->normal_of[s];
    const struct um_environment_earth_flux *f = &flux[of];
    struct um_thermal_shares share = {1.0, 1.0, 1.0, {0.0}, {0.0}};
    if (f->view_factor > 0.0 && !um_geometry_visibility_is_open(scene->visibility, s)) {
      if (of != halved)
        um_irradiation_cap_halve(&cap, normal[of], scene->row != NULL, by_angle, &half);
      halved = of;
      um_irradiation_cap_shares(t->mesh, scene, s, normal[of], &cap, &half, &share);
    }
    out->albedo[s] = (float)(f->albedo * share.albedo);
    out->planet[s] = (float)(f->planet * share.planet);
    out->view_factor[s] = (float)(f->view_factor * share.view_factor);
    if (out->brightness != NULL) out->brightness[s] = (float)f->brightness;
    if (!by_angle) continue;
    size_t m = s * UM_ANGULAR_MOMENTS;
    um_irradiation_moments_set(moments[of].albedo, f->albedo, share.albedo, share.moved_albedo,
                               &out->albedo_moments[m]);
    um_irradiation_moments_set(moments[of].planet, f->planet, share.planet, share.moved_planet,
                               &out->planet_moments[m]);
  }
}

/* All loads of a sample into a row. bright: those of the Sun too. */
static void trace_row(const struct tracer *t, const struct um_environment_sample *sample,
                      const struct um_thermal_scene *scene, size_t slot, bool bright,
                      const struct um_irradiation_row *out)
{
  double *fraction = &t->fraction[slot * t->mesh->nsurface];
  if (bright) trace_sun(t, sample, scene, fraction, out);
  if (t->earth) trace_earth(t, sample, scene, slot, out);
  if (out->gas != NULL)
    um_irradiation_gas_trace(t->environment, sample, t->mesh, scene, t->nsample, fraction,
                             out->gas);
}

/* Row k as a sum over the attitudes of its turn. */
static void trace_turn(const struct tracer *t, size_t k, size_t slot)
{
  struct um_irradiation_row one = um_irradiation_row_of(t->one, slot);
  struct um_environment_sample sample = t->samples[k];
  for (size_t j = 0; j < t->turn->n && !um_core_stopped(t->context); j++) {
    double u, weight;
    um_irradiation_turn_node(t->turn, k, j, &u, &weight);
    sample.q = t->attitude[slot * t->turn->n + j];
    memset(one.sun, 0, t->mesh->nsurface * sizeof *one.sun);
    if (one.gas != NULL) memset(one.gas, 0, t->mesh->nsurface * sizeof *one.gas);
    trace_row(t, &sample, &t->fixed, slot, t->bright[k], &one);
    um_irradiation_turn_add(t->loads, k, weight, &one);
  }
}

static enum um_status attitudes_ask(struct tracer *t, size_t from, size_t n)
{
  for (size_t i = 0; i < n; i++)
    for (size_t j = 0; j < t->turn->n; j++) {
      double u, weight;
      um_irradiation_turn_node(t->turn, from + i, j, &u, &weight);
      UM_TRY(t->turn->attitude(t->turn->self, from + i, t->turn->period - u,
                               &t->attitude[i * t->turn->n + j]));
    }
  return UM_OK;
}

/* Times [from, from + n) in parallel; every time is its own, so threads do not matter. */
static enum um_status trace_batch(struct tracer *t, size_t from, size_t n)
{
  struct um_thermal_scene own[BATCH] = {{0}};
  enum um_status status = t->turn != NULL ? attitudes_ask(t, from, n) : UM_OK;
  for (size_t i = 0; i < n && t->moves && status == UM_OK; i++) {
    um_geometry_joint_angles(t->geometry, sun_body(&t->samples[from + i]), t->angles);
    status = scene_create(t, t->angles, false, &own[i]);
  }
  if (status == UM_OK) {
    long count = (long)n;
#pragma omp parallel for schedule(dynamic, 1) num_threads(um_core_context_threads(t->context))
    for (long i = 0; i < count; i++) {
      size_t slot = (size_t)i;
      if (um_core_stopped(t->context)) continue; /* progress_step says so */
      const struct um_thermal_scene *scene = t->moves ? &own[slot] : &t->fixed;
      struct um_irradiation_row row = um_irradiation_row_of(t->loads, from + slot);
      if (t->turn != NULL)
        trace_turn(t, from + slot, slot);
      else
        trace_row(t, &t->samples[from + slot], scene, slot, t->bright[from + slot], &row);
    }
  }
  for (size_t i = 0; i < n; i++) scene_destroy(t, &own[i]);
  return status;
}

static void tracer_free(struct tracer *t)
{
  scene_destroy(t, &t->fixed);
  um_core_free(t->context, t->normal_of);
  um_core_free(t->context, t->example);
  um_core_free(t->context, t->order);
  um_core_free(t->context, t->bright);
  um_core_free(t->context, t->angles);
  um_core_free(t->context, t->fraction);
  um_core_free(t->context, t->normal);
  um_core_free(t->context, t->flux);
  um_core_free(t->context, t->moments);
  um_core_free(t->context, t->attitude);
  um_irradiation_loads_destroy(t->context, &t->one);
}

static enum um_status check_samples(struct um_context *context,
                                    const struct um_environment_sample *samples, size_t ntime,
                                    int nsample)
{
  if (ntime == 0 || nsample < 1)
    return um_core_fail(context, UM_ERR_INPUT,
                        "loads of %zu times with %d points per facet; accepted: 1 or more of both",
                        ntime, nsample);
  for (size_t k = 0; k < ntime; k++) {
    const struct um_environment_sample *s = &samples[k];
    if (!isfinite(s->t_tai) || !isfinite(um_vec3_norm(s->r)) || !isfinite(um_vec3_norm(s->sun)) ||
        !(s->sun_distance > 0.0) || !(s->sunlit_fraction >= 0.0 && s->sunlit_fraction <= 1.0) ||
        !(fabs(s->q.w * s->q.w + s->q.x * s->q.x + s->q.y * s->q.y + s->q.z * s->q.z - 1.0) < 1e-6))
      return um_core_fail(context, UM_ERR_INPUT,
                          "sample %zu of the timeline (t_tai %.3f s): position, Sun, sunlit "
                          "fraction or attitude is not a valid number",
                          k, s->t_tai);
    if (k > 0 && !(s->t_tai > samples[k - 1].t_tai))
      return um_core_fail(context, UM_ERR_INPUT,
                          "sample %zu of the timeline: time %.3f s is not after %.3f s", k,
                          s->t_tai, samples[k - 1].t_tai);
  }
  return UM_OK;
}

/* Does the Earth shine at all? */
static bool earth_shines(const struct um_environment *e)
{
  return um_environment_earth_varies(e) || e->albedo > 0.0 || e->outgoing_longwave > 0.0 ||
         e->brightness_temperature > 0.0;
}

/* What a table holds beside that of um_irradiation_loads_create. */
static enum um_status columns_add(const struct tracer *t, struct um_irradiation_loads *loads)
{
  size_t n = loads->ntime * loads->nsurface;
  if (t->turn == NULL && um_environment_earth_varies(t->environment))
    UM_TRY(um_core_allocate(t->context, n, sizeof(float), &loads->brightness));
  if (t->environment->gas_density_factor > 0.0)
    UM_TRY(um_core_allocate(t->context, n, sizeof(float), &loads->gas));
  if (t->environment->absorptance_by_angle && t->earth) {
    n *= UM_ANGULAR_MOMENTS;
    UM_TRY(um_core_allocate(t->context, n, sizeof(float), &loads->albedo_moments));
    UM_TRY(um_core_allocate(t->context, n, sizeof(float), &loads->planet_moments));
  }
  return UM_OK;
}

static enum um_status turn_prepare(struct tracer *t)
{
  size_t n = t->loads->ntime * t->loads->nsurface;
  if (t->turn == NULL) return UM_OK;
  if (t->moves || t->turn->n < 1 || !(t->turn->period > 0.0))
    return um_core_fail(t->context, UM_ERR_INPUT,
                        "loads over a turn of %g s by %zu attitudes%s; accepted: above 0 s, 1 or "
                        "more, no joint that moves",
                        t->turn->period, t->turn->n, t->moves ? " of joints that move" : "");
  UM_TRY(um_core_allocate(t->context, BATCH * t->turn->n, sizeof *t->attitude, &t->attitude));
  UM_TRY(um_core_allocate(t->context, n, UM_IRRADIATION_COSINES * sizeof(float),
                          &t->loads->by_cosine));
  UM_TRY(um_irradiation_loads_create(t->context, BATCH, t->loads->nsurface, 0, &t->one));
  return columns_add(t, t->one);
}

static enum um_status trace(struct um_context *context, const struct um_geometry *geometry,
                            const struct um_environment *environment,
                            const struct um_environment_sample *samples, size_t ntime,
                            const double *edges, size_t nedge, int nsample,
                            const struct um_irradiation_turn *turn,
                            struct um_irradiation_loads **out)
{
  *out = NULL;
  UM_TRY(check_samples(context, samples, ntime, nsample));
  struct tracer t = {.context = context,
                     .geometry = geometry,
                     .mesh = um_geometry_mesh(geometry),
                     .environment = environment,
                     .samples = samples,
                     .turn = turn,
                     .nsample = nsample,
                     .njoint = um_geometry_joint_count(geometry),
                     .moves = um_geometry_joint_moves(geometry),
                     .earth = earth_shines(environment)};
  UM_TRY(um_irradiation_loads_create(context, ntime, t.mesh->nsurface, nedge, &t.loads));
  um_core_progress_begin(context, "orbital loads", ntime);
  enum um_status status;
  for (size_t k = 0; k < ntime; k++) {
    t.loads->t[k] = samples[k].t_tai;
    t.loads->sunlit[k] = samples[k].sunlit_fraction;
    t.loads->irradiance[k] = um_environment_solar_irradiance(environment, samples[k].sun_distance);
  }
  UM_CHECK(columns_add(&t, t.loads));
  UM_CHECK(turn_prepare(&t));
  if (nedge > 0) memcpy(t.loads->edge, edges, nedge * sizeof *edges);
  UM_CHECK(tracer_prepare(&t));
  for (size_t k = 0; k < ntime; k += BATCH) {
    size_t n = ntime - k < BATCH ? ntime - k : BATCH;
    UM_CHECK(trace_batch(&t, k, n));
    UM_CHECK(um_core_progress_step(context, n));
    UM_CHECK(um_core_stop_check(context, "orbital loads were traced"));
  }
  *out = t.loads;
  t.loads = NULL;
done:
  um_core_progress_end(context);
  tracer_free(&t);
  um_irradiation_loads_destroy(context, &t.loads);
  return status;
}

enum um_status um_irradiation_loads_trace(struct um_context *context,
                                          const struct um_geometry *geometry,
                                          const struct um_environment *environment,
                                          const struct um_environment_sample *samples, size_t ntime,
                                          const double *edges, size_t nedge, int nsample,
                                          struct um_irradiation_loads **out)
{
  return trace(context, geometry, environment, samples, ntime, edges, nedge, nsample, NULL, out);
}

enum um_status um_irradiation_loads_turn(struct um_context *context,
                                         const struct um_geometry *geometry,
                                         const struct um_environment *environment,
                                         const struct um_environment_sample *samples, size_t ntime,
                                         const double *edges, size_t nedge, int nsample,
                                         const struct um_irradiation_turn *turn,
                                         struct um_irradiation_loads **out)
{
  return trace(context, geometry, environment, samples, ntime, edges, nedge, nsample, turn, out);
}
