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
#include "thermal/loads/loads.h"

#include <math.h>
#include <string.h>

#include "thermal/loads/loads_impl.h"

#define DARK_MARGIN 120.0 /* [s] */
#define BATCH       32    /* times whose scenes are alive together */

struct tracer {
  struct um_context *context;
  const struct um_geometry *geometry;
  const struct um_geometry_mesh *mesh;
  const struct um_environment *environment;
  const struct um_environment_sample *samples;
  const struct um_irradiation_spin *spin;   /* NULL: every sample has its own attitude alone */
  struct um_irradiation_loads *loads, *one; /* one: [BATCH] rows of single attitudes, with turn */
  struct um_quat *attitude;                 /* [BATCH][spin->n] scratch */
  int nsample;
  size_t njoint;
  bool moves, earth_alone;
  bool earth;                                   /* there is something of it to be traced */
  const struct um_irradiation_sky *sky;         /* where nothing moves, with earth */
  struct um_irradiation_sky *own_sky;           /* it, if it was not given */
  const struct um_irradiation_normals *normals; /* with earth; those of the sky, or */
  struct um_irradiation_normals own_normals;    /* by the pose of the first sample */
  bool *bright;                                 /* [ntime] solar rays are wanted */
  struct um_thermal_scene fixed; /* when nothing moves; else the pose of the first sample */
  double *angles;                /* [njoint] scratch */
  double *fraction;              /* [BATCH][nsurface] scratch */
  struct um_vec3 *normal;        /* [BATCH][normals->n] scratch */
  struct um_environment_earth_flux *flux;       /* the same */
  struct um_environment_earth_moments *moments; /* the same; NULL: not asked for */
};

static void scene_destroy(struct tracer *t, struct um_thermal_scene *s)
{
  um_geometry_visibility_destroy(&s->visibility);
  um_geometry_pose_destroy(t->context, &s->pose);
}

static enum um_status scene_create(struct tracer *t, const double *angles,
                                   struct um_thermal_scene *s)
{
  UM_TRY(um_geometry_pose_create(t->context, t->geometry, angles, &s->pose));
  return um_geometry_visibility_create(t->context, t->mesh, s->pose, &s->visibility);
}

static struct um_vec3 sun_body(const struct um_environment_sample *sample)
{
  return um_quat_apply(sample->q, sample->sun);
}

/* Rays are wanted in sunlight, within DARK_MARGIN of it or of an eclipse edge, and at the samples
 * next to those in sunlight. */
static void find_bright(struct tracer *t)
{
  const struct um_irradiation_loads *l = t->loads;
  double last = -INFINITY, next = INFINITY;
  if (t->earth_alone) return;
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

/* What the Earth's loads are traced with. */
static enum um_status earth_prepare(struct tracer *t)
{
  if (!t->earth) return UM_OK;
  if (!t->moves && t->sky == NULL) {
    UM_TRY(um_irradiation_sky_create(t->context, t->geometry, &t->own_sky));
    t->sky = t->own_sky;
  }
  if (t->moves)
    UM_TRY(um_irradiation_normals_find(t->context, t->mesh, t->fixed.pose, &t->own_normals));
  t->normals = t->moves ? &t->own_normals : &t->sky->normals;
  size_t n = BATCH * t->normals->n;
  UM_TRY(um_core_allocate(t->context, n, sizeof *t->normal, &t->normal));
  if (t->loads->planet_moments != NULL)
    UM_TRY(um_core_allocate(t->context, n, sizeof *t->moments, &t->moments));
  return um_core_allocate(t->context, n, sizeof *t->flux, &t->flux);
}

static enum um_status tracer_prepare(struct tracer *t)
{
  UM_TRY(um_core_allocate(t->context, t->loads->ntime, sizeof *t->bright, &t->bright));
  UM_TRY(um_core_allocate(t->context, t->njoint, sizeof *t->angles, &t->angles));
  UM_TRY(
      um_core_allocate(t->context, BATCH * t->mesh->nsurface, sizeof *t->fraction, &t->fraction));
  find_bright(t);
  um_geometry_joint_angles(t->geometry, sun_body(&t->samples[0]), t->samples[0].t_tai, t->angles);
  UM_TRY(scene_create(t, t->njoint == 0 ? NULL : t->angles, &t->fixed));
  return earth_prepare(t);
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

/* Earth loads of a surface from those of its class, at slot and class `at`. */
static void earth_set(const struct tracer *t, size_t at, size_t s,
                      const struct um_thermal_shares *share, const struct um_irradiation_row *out)
{
  const struct um_environment_earth_flux *f = &t->flux[at];
  out->albedo[s] = (float)(f->albedo * share->albedo);
  out->planet[s] = (float)(f->planet * share->planet);
  out->view_factor[s] = (float)(f->view_factor * share->view_factor);
  if (out->brightness != NULL) out->brightness[s] = (float)f->brightness;
  if (t->moments == NULL) return;
  const struct um_environment_earth_moments *whole = &t->moments[at];
  size_t m = s * UM_ANGULAR_MOMENTS;
  um_irradiation_moments_set(whole->albedo, f->albedo, share->albedo, share->moved_albedo,
                             &out->albedo_moments[m]);
  um_irradiation_moments_set(whole->planet, f->planet, share->planet, share->moved_planet,
                             &out->planet_moments[m]);
}

/* Surfaces of a class that are not open, side by side. */
struct group {
  size_t n, surface[UM_IRRADIATION_BLOCKS * UM_IRRADIATION_LANES];
  size_t done; /* surfaces of the class in groups before it */
};

static void group_trace(const struct tracer *t, const struct um_thermal_scene *scene, size_t at,
                        const struct um_thermal_cap *cap, const struct um_thermal_half *half,
                        struct group *group, const struct um_irradiation_row *out)
{
  struct um_thermal_free free_of;
  struct um_thermal_shares share[UM_IRRADIATION_LANES];
  if (group->n == 0) return;
  if (t->sky != NULL) {
    um_irradiation_look_at_sky(t->sky, at % t->normals->n, group->done, half, &free_of);
  } else {
    memset(&free_of.block[0], 0, sizeof free_of.block[0]);
    for (size_t l = 0; l < group->n; l++)
      um_irradiation_look_by_rays(t->mesh, scene, group->surface[l], cap, half, l,
                                  &free_of.block[0]);
  }
  for (size_t first = 0; first < group->n; first += UM_IRRADIATION_LANES) {
    um_irradiation_cap_shares(half, &free_of.block[first / UM_IRRADIATION_LANES], share);
    for (size_t l = 0; l < UM_IRRADIATION_LANES && first + l < group->n; l++)
      earth_set(t, at, group->surface[first + l], &share[l], out);
  }
  group->done += group->n;
  group->n = 0;
}

/* All surfaces of a class. */
static void class_trace(const struct tracer *t, const struct um_thermal_scene *scene, size_t at,
                        const struct um_thermal_cap *cap, const struct um_irradiation_row *out)
{
  static const struct um_thermal_shares whole = {.albedo = 1.0, .planet = 1.0, .view_factor = 1.0};
  struct um_thermal_half half;
  struct group group = {0};
  size_t class = at % t->normals->n, blocks = 1;
  if (t->sky != NULL) blocks = um_irradiation_sky_blocks(t->sky, class);
  for (size_t k = t->normals->begin[class]; k < t->normals->begin[class + 1]; k++) {
    size_t s = t->normals->order[k];
    if (!(t->flux[at].view_factor > 0.0) || um_geometry_visibility_is_open(scene->visibility, s)) {
      earth_set(t, at, s, &whole, out);
      continue;
    }
    if (group.n == 0 && group.done == 0)
      um_irradiation_cap_halve(cap, t->normal[at], t->sky != NULL, t->moments != NULL, &half);
    group.surface[group.n++] = s;
    if (group.n == blocks * UM_IRRADIATION_LANES)
      group_trace(t, scene, at, cap, &half, &group, out);
  }
  group_trace(t, scene, at, cap, &half, &group, out);
}

static void trace_earth(const struct tracer *t, const struct um_environment_sample *sample,
                        const struct um_thermal_scene *scene, size_t slot,
                        const struct um_irradiation_row *out)
{
  struct um_vec3 r = um_quat_apply(sample->q, sample->r), sun = sun_body(sample);
  size_t n = t->normals->n, first = slot * n;
  struct um_environment_globe globe = {.t_tai = sample->t_tai,
                                       .pole = um_quat_apply(sample->q, sample->pole),
                                       .greenwich = um_quat_apply(sample->q, sample->greenwich)};
  for (size_t i = 0; i < n; i++)
    t->normal[first + i] = um_geometry_surface_normal(t->mesh, scene->pose, t->normals->example[i]);
  um_environment_earth_flux_by_angle(t->environment, &globe, r, sun, sample->sun_distance,
                                     &t->normal[first], n, &t->flux[first],
                                     t->moments != NULL ? &t->moments[first] : NULL);
  struct um_thermal_cap cap;
  cap.n = um_environment_earth_cap(t->environment, &globe, r, sun, sample->sun_distance, cap.point);
  cap.varies = um_environment_earth_varies(t->environment);
  um_irradiation_cap_spread(&cap, t->sky != NULL ? t->sky->cell : NULL);
  for (size_t i = 0; i < n && !um_core_stopped(t->context); i++)
    class_trace(t, scene, first + i, &cap, out);
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
  for (size_t j = 0; j < t->spin->n && !um_core_stopped(t->context); j++) {
    double u, weight;
    um_irradiation_spin_node(t->spin, k, j, &u, &weight);
    sample.q = t->attitude[slot * t->spin->n + j];
    memset(one.sun, 0, t->mesh->nsurface * sizeof *one.sun);
    if (one.gas != NULL) memset(one.gas, 0, t->mesh->nsurface * sizeof *one.gas);
    trace_row(t, &sample, &t->fixed, slot, t->bright[k], &one);
    um_irradiation_spin_add(t->loads, k, weight, &one);
  }
}

static enum um_status attitudes_ask(struct tracer *t, size_t from, size_t n)
{
  for (size_t i = 0; i < n; i++)
    for (size_t j = 0; j < t->spin->n; j++) {
      double u, weight;
      um_irradiation_spin_node(t->spin, from + i, j, &u, &weight);
      UM_TRY(t->spin->attitude(t->spin->self, from + i, t->spin->period - u,
                               &t->attitude[i * t->spin->n + j]));
    }
  return UM_OK;
}

/* Times [from, from + n) in parallel; every time is its own, so threads do not matter. */
static enum um_status trace_batch(struct tracer *t, size_t from, size_t n)
{
  struct um_thermal_scene own[BATCH] = {{0}};
  enum um_status status = t->spin != NULL ? attitudes_ask(t, from, n) : UM_OK;
  for (size_t i = 0; i < n && t->moves && status == UM_OK; i++) {
    um_geometry_joint_angles(t->geometry, sun_body(&t->samples[from + i]),
                             t->samples[from + i].t_tai, t->angles);
    status = scene_create(t, t->angles, &own[i]);
  }
  if (status == UM_OK) {
    long count = (long)n;
#pragma omp parallel for schedule(dynamic, 1) num_threads(um_core_context_threads(t->context))
    for (long i = 0; i < count; i++) {
      size_t slot = (size_t)i;
      if (um_core_stopped(t->context)) continue; /* progress_step says so */
      const struct um_thermal_scene *scene = t->moves ? &own[slot] : &t->fixed;
      struct um_irradiation_row row = um_irradiation_row_of(t->loads, from + slot);
      if (t->spin != NULL)
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
  um_irradiation_normals_clear(t->context, &t->own_normals);
  um_irradiation_sky_destroy(t->context, &t->own_sky);
  UM_FREE(t->context, t->bright, t->angles, t->fraction, t->normal, t->flux, t->moments,
          t->attitude);
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

bool um_irradiation_earth_shines(const struct um_environment *e)
{
  return um_environment_earth_varies(e) || e->albedo > 0.0 || e->outgoing_longwave > 0.0 ||
         e->brightness_temperature > 0.0;
}

bool um_irradiation_wants_sky(const struct um_geometry *geometry,
                              const struct um_environment *environment)
{
  return um_irradiation_earth_shines(environment) && !um_geometry_joint_moves(geometry);
}

/* What a table holds beside that of um_irradiation_loads_create. */
static enum um_status columns_add(const struct tracer *t, struct um_irradiation_loads *loads)
{
  size_t n = loads->ntime * loads->nsurface;
  if (t->spin == NULL && um_environment_earth_varies(t->environment))
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
  if (t->spin == NULL) return UM_OK;
  if (t->moves || t->spin->n < 1 || !(t->spin->period > 0.0))
    return um_core_fail(t->context, UM_ERR_INPUT,
                        "loads over a turn of %g s by %zu attitudes%s; accepted: above 0 s, 1 or "
                        "more, no joint that moves",
                        t->spin->period, t->spin->n, t->moves ? " of joints that move" : "");
  UM_TRY(um_core_allocate(t->context, BATCH * t->spin->n, sizeof *t->attitude, &t->attitude));
  UM_TRY(um_core_allocate(t->context, n, UM_IRRADIATION_COSINES * sizeof(float),
                          &t->loads->by_cosine));
  UM_TRY(um_irradiation_loads_create(t->context, BATCH, t->loads->nsurface, 0, &t->one));
  return columns_add(t, t->one);
}

enum um_status um_irradiation_loads_make(struct um_context *context,
                                         const struct um_geometry *geometry,
                                         const struct um_environment *environment,
                                         const struct um_environment_sample *samples, size_t ntime,
                                         const double *edges, size_t nedge,
                                         const struct um_irradiation_loads_options *options,
                                         struct um_irradiation_loads **out)
{
  *out = NULL;
  UM_TRY(check_samples(context, samples, ntime, options->nsample));
  struct tracer t = {.context = context,
                     .geometry = geometry,
                     .mesh = um_geometry_mesh(geometry),
                     .environment = environment,
                     .samples = samples,
                     .spin = options->spin,
                     .sky = options->sky,
                     .nsample = options->nsample,
                     .njoint = um_geometry_joint_count(geometry),
                     .moves = um_geometry_joint_moves(geometry),
                     .earth_alone = options->earth_alone,
                     .earth = um_irradiation_earth_shines(environment)};
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
  const struct um_irradiation_loads_options options = {.nsample = nsample};
  return um_irradiation_loads_make(context, geometry, environment, samples, ntime, edges, nedge,
                                   &options, out);
}
