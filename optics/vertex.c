/* A turn of a path: directions by importance, and spectra of what is reflected.
 *
 *   f_r = (rho_d - <M>)/pi + M(i) M(o)/(pi <M>) + F(cos_d) f(i, o)
 *
 * (materials.h); surfaces without a lobe have rho_d below 2.5 um and 1 - eps(cos_o) above. A
 * direction is that of the lobe, one by the cosine, or one from which a flat mirror throws
 * sunlight: i = -(2 (s.h) h - s) with h drawn from the mirror's facets, which does not depend on
 * where the mirror stands, as the Sun is far. Shares are fixed, not fitted to the materials: a
 * parameter that is moved moves paths smoothly. */
#include <math.h>

#include "core/constants.h"
#include "core/sampling.h"
#include "optics/paths_impl.h"

#define THERMAL_FROM 2.5e-6 /* [m] */
#define WIDE         0.6    /* alpha of lobes that need no looking for */
#define BEHIND       0.3    /* cosine beyond which no light of a mirror's lobe reaches a surface */
#define NARROW       0.15   /* alpha below which a lobe is a mirror to paths */
#define SOFT         0.01   /* slope variance that widens a mirror behind another [1] */
/* share of ways that look for mirrors: nothing is known, one shines, none does */
#define GLINT        0.25
#define GLINT_SEEN   0.5
#define GLINT_UNSEEN 0.1
#define UNSEEN       0.05 /* weight of a mirror that does not shine, of one that does */

static struct um_vec3 to_body(struct um_vec3 along, struct um_vec3 across, struct um_vec3 normal,
                              struct um_vec3 v)
{
  struct um_vec3 out = um_vec3_scale(along, v.x);
  out = um_vec3_axpy(out, v.y, across);
  return um_vec3_axpy(out, v.z, normal);
}

static struct um_vec3 from_body(struct um_vec3 along, struct um_vec3 across, struct um_vec3 normal,
                                struct um_vec3 v)
{
  return um_vec3(um_vec3_dot(along, v), um_vec3_dot(across, v), um_vec3_dot(normal, v));
}

/* Axes in a surface: its grain where its lobe has one. */
static void axes(const struct um_optics_paths *paths, size_t surface, size_t skin,
                 struct um_vec3 normal, struct um_vec3 *along, struct um_vec3 *across)
{
  if (um_materials_lobe_is_anisotropic(&paths->spectra->lobe[skin]))
    um_geometry_surface_grain(paths->scene->geometry, paths->work->rotation, surface, along,
                              across);
  else
    um_core_vec3_frame(normal, along, across);
}

void um_optics_paths_glints(struct um_optics_paths *paths)
{
  const struct um_optics_exchange *e = paths->set->exchange;
  struct um_vec3 sun = paths->instant->sun_body;
  double angle = paths->instant->sun_radius, half = sin(0.5 * angle);
  paths->nglint = 0;
  if (!(paths->instant->sun > 0.0)) return;
  for (size_t k = 0; k < e->nplane; k++) {
    struct um_optics_glint *g = &paths->glint[paths->nglint];
    size_t skin = um_optics_skin(paths->spectra, e->mesh, e->plane[k].surface);
    g->lobe = paths->spectra->lobe[skin];
    g->normal = e->plane[k].normal;
    if (g->lobe.kind == NULL || !(um_vec3_dot(g->normal, sun) > 0.0)) continue;
    if (!g->lobe.kind->delta &&
        (!g->lobe.kind->rough || !(fmax(g->lobe.alpha, g->lobe.alpha_across) < WIDE)))
      continue;
    g->lobe.alpha = hypot(g->lobe.alpha, 0.5 * angle);
    g->lobe.alpha_across = hypot(g->lobe.alpha_across, 0.5 * angle);
    axes(paths, e->plane[k].surface, skin, g->normal, &g->along, &g->across);
    g->sun = from_body(g->along, g->across, g->normal, sun);
    g->mirrored = um_vec3_axpy(um_vec3_scale(sun, -1.0), 2.0 * g->sun.z, g->normal);
    g->toward = um_materials_lobe_toward(&g->lobe, g->sun);
    g->radius = 2.0 * half * half;
    paths->nglint++;
  }
}

void um_optics_vertex_place(const struct um_optics_paths *paths, size_t surface,
                            struct um_vec3 point, struct um_vec3 from, const bool *shines,
                            struct um_optics_vertex *v)
{
  const struct um_geometry_mesh *mesh = paths->set->exchange->mesh;
  v->surface = surface;
  v->skin = um_optics_skin(paths->spectra, mesh, surface);
  v->at = paths->instant->time * mesh->nsurface + surface;
  v->point = point;
  v->normal = um_geometry_surface_normal(mesh, paths->set->pose, surface);
  axes(paths, surface, v->skin, v->normal, &v->along, &v->across);
  v->o = from_body(v->along, v->across, v->normal, from);
  const struct um_materials_lobe *lobe = &paths->spectra->lobe[v->skin];
  bool has = lobe->kind != NULL;
  v->toward = has ? um_materials_lobe_toward(lobe, v->o) : 0.0;
  v->soft = false;
  v->nglint = 0;
  double sum = 0.0;
  bool any = false;
  for (size_t k = 0; k < paths->nglint; k++) {
    if (!(um_vec3_dot(v->normal, paths->glint[k].mirrored) < BEHIND)) continue;
    bool shining = shines != NULL && shines[k];
    v->share[v->nglint] = shining || shines == NULL ? 1.0 : UNSEEN;
    sum += v->share[v->nglint];
    v->glint[v->nglint++] = (uint8_t)k;
    any = any || shining;
  }
  for (int k = 0; k < v->nglint; k++) v->share[k] /= sum;
  v->p_glint = v->nglint == 0 ? 0.0 : (shines == NULL ? GLINT : (any ? GLINT_SEEN : GLINT_UNSEEN));
  v->p_lobe = has ? 0.5 * (1.0 - v->p_glint) : 0.0;
  v->p_flat = 1.0 - v->p_glint - v->p_lobe;
}

/* Density of directions [1/sr] in which a mirror throws sunlight. */
static double glint_density(const struct um_optics_glint *g, struct um_vec3 direction)
{
  struct um_vec3 out = from_body(g->along, g->across, g->normal, um_vec3_scale(direction, -1.0));
  if (!(out.z > 0.0)) return 0.0;
  struct um_materials_pair pair = um_materials_pair(out, g->sun);
  if (!g->lobe.kind->delta) return g->lobe.kind->density(&g->lobe, &pair);
  return um_materials_pair_offset(&pair) < g->radius ? 1.0 / (2.0 * UM_PI * g->radius) : 0.0;
}

static struct um_vec3 glint_direction(const struct um_optics_glint *g, const double u[2])
{
  struct um_vec3 out;
  if (g->lobe.kind->delta) { /* the Sun's disc, mirrored */
    struct um_vec3 t, b;
    double low = u[0] * g->radius, sine = sqrt(low * (2.0 - low)), phi = 2.0 * UM_PI * u[1];
    um_core_vec3_frame(g->mirrored, &t, &b);
    out = um_vec3_axpy(um_vec3_scale(g->mirrored, 1.0 - low), sine * cos(phi), t);
    return um_vec3_scale(um_vec3_axpy(out, sine * sin(phi), b), -1.0);
  }
  struct um_vec3 drawn = g->lobe.kind->draw(&g->lobe, u[0], u[1]);
  struct um_materials_reflected r;
  g->lobe.kind->reflect(&g->lobe, &drawn, 1, g->sun, g->toward, &r);
  if (!(r.weight > 0.0)) return um_vec3(0.0, 0.0, 0.0);
  return um_vec3_scale(to_body(g->along, g->across, g->normal, r.i), -1.0);
}

/* Density [1/sr] and lobe of a direction that any of the ways may have found. */
static void weigh(const struct um_optics_paths *paths, const struct um_optics_vertex *v,
                  struct um_vec3 i, struct um_optics_turn *turn)
{
  const struct um_materials_lobe *lobe = &paths->spectra->lobe[v->skin];
  bool has = lobe->kind != NULL && !lobe->kind->delta;
  double p = v->p_flat * i.z / UM_PI, f = 0.0;
  turn->cos_i = i.z;
  turn->cos_d = 1.0;
  if (has) {
    struct um_materials_pair pair = um_materials_pair(i, v->o);
    f = lobe->kind->evaluate(lobe, &pair);
    p += v->p_lobe * lobe->kind->density(lobe, &pair);
    turn->cos_d = pair.cos_d;
  }
  for (int k = 0; k < v->nglint; k++)
    p += v->p_glint * v->share[k] * glint_density(&paths->glint[v->glint[k]], turn->direction);
  turn->flat = i.z / p;
  turn->lobe = f * i.z / p;
}

bool um_optics_vertex_sample(const struct um_optics_paths *paths, const struct um_optics_vertex *v,
                             double which, const double u[2], struct um_optics_turn *turn)
{
  const struct um_materials_lobe *lobe = &paths->spectra->lobe[v->skin];
  struct um_vec3 i;
  if (which < v->p_lobe) {
    struct um_vec3 drawn = lobe->kind->draw(lobe, u[0], u[1]);
    struct um_materials_reflected r;
    lobe->kind->reflect(lobe, &drawn, 1, v->o, v->toward, &r);
    if (!(r.weight > 0.0)) return false;
    i = r.i;
    turn->direction = um_vec3_unit(to_body(v->along, v->across, v->normal, i));
    if (lobe->kind->delta) {
      turn->cos_i = i.z;
      turn->cos_d = r.cos_d;
      turn->flat = 0.0;
      turn->lobe = r.weight / v->p_lobe;
      return true;
    }
  } else if (which < v->p_lobe + v->p_glint) {
    double place = (which - v->p_lobe) / v->p_glint;
    int k = 0;
    while (k + 1 < v->nglint && place >= v->share[k]) place -= v->share[k++];
    turn->direction = glint_direction(&paths->glint[v->glint[k]], u);
    i = from_body(v->along, v->across, v->normal, turn->direction);
  } else {
    turn->direction = um_core_sample_cosine(u, v->normal);
    i = from_body(v->along, v->across, v->normal, turn->direction);
  }
  if (!(i.z > 0.0)) return false;
  weigh(paths, v, i, turn);
  return true;
}

bool um_optics_vertex_is_narrow(const struct um_optics_paths *paths,
                                const struct um_optics_vertex *v, double which)
{
  const struct um_materials_lobe *lobe = &paths->spectra->lobe[v->skin];
  return which < v->p_lobe && (lobe->kind->delta || lobe->alpha < NARROW);
}

bool um_optics_vertex_sun(const struct um_optics_paths *paths, const struct um_optics_vertex *v,
                          struct um_optics_turn *turn)
{
  const struct um_materials_lobe *lobe = &paths->spectra->lobe[v->skin];
  turn->direction = paths->instant->sun_body;
  struct um_vec3 i = from_body(v->along, v->across, v->normal, turn->direction);
  if (!(i.z > 0.0)) return false;
  turn->cos_i = turn->flat = i.z;
  turn->cos_d = 1.0;
  turn->lobe = 0.0;
  if (lobe->kind == NULL) return true;
  struct um_materials_pair pair = um_materials_pair(i, v->o);
  turn->cos_d = pair.cos_d;
  struct um_materials_lobe wide = v->soft ? um_materials_lobe_tilted(lobe, SOFT) : *lobe;
  turn->lobe = i.z * wide.kind->sunlit(&wide, &pair, paths->instant->sun_radius);
  return true;
}

void um_optics_vertex_row(const struct um_optics_paths *paths, const struct um_optics_vertex *v,
                          const struct um_optics_turn *turn, bool lobe_only, double *row)
{
  const struct um_optics_spectra *s = paths->spectra;
  struct um_optics_work *work = paths->work;
  size_t n = s->nbin;
  const double *diffuse = s->diffuse + v->skin * n, *mean = s->masked_mean + v->skin * n;
  double flat = lobe_only ? 0.0 : turn->flat / UM_PI;
  if (s->lobe[v->skin].kind == NULL) {
    const double *emissivity = um_optics_spectra_emissivity(s, v->skin, v->o.z, work->emissivity);
    for (size_t b = 0; b < n; b++)
      row[b] = flat * (s->wavelength[b] > THERMAL_FROM ? 1.0 - emissivity[b] : diffuse[b]);
    return;
  }
  for (size_t b = 0; b < n; b++) row[b] = flat * (diffuse[b] - mean[b]);
  if (flat > 0.0 && s->masks[v->skin]) {
    um_optics_spectra_masked(s, v->skin, turn->cos_i, work->masked_sun);
    um_optics_spectra_masked(s, v->skin, v->o.z, work->masked_observer);
    for (size_t b = 0; b < n; b++)
      if (mean[b] > 0.0) row[b] += flat * work->masked_sun[b] * work->masked_observer[b] / mean[b];
  }
  if (!(turn->lobe > 0.0)) return;
  double weight[4];
  const double *node = s->fresnel + (v->skin * UM_OPTICS_FRESNEL_NODES +
                                     (size_t)um_optics_fresnel_weights(turn->cos_d, weight)) *
                                        n;
  for (int k = 0; k < 4; k++) weight[k] *= turn->lobe;
  for (size_t b = 0; b < n; b++)
    row[b] += weight[0] * node[b] + weight[1] * node[n + b] + weight[2] * node[2 * n + b] +
              weight[3] * node[3 * n + b];
}

void um_optics_vertex_glow(const struct um_optics_paths *paths, const struct um_optics_vertex *v,
                           double *row)
{
  const struct um_optics_spectra *s = paths->spectra;
  const struct um_optics_scene *scene = paths->scene;
  const struct um_optics_instant *now = paths->instant;
  struct um_optics_work *work = paths->work;
  size_t n = s->nbin;
  const double *diffuse = s->diffuse + v->skin * n, *mean = s->masked_mean + v->skin * n;
  bool lobe = now->earth_lobe && s->lobe[v->skin].kind != NULL;
  double albedo = now->earthshine * (double)scene->albedo[v->at] / UM_PI;
  double factor = now->earth_reflection * (double)scene->view_factor[v->at];
  const double *earth = s->earth;
  um_optics_spectra_planck(s, scene->temperature[v->at], work->planck);
  const double *emissivity = um_optics_spectra_emissivity(s, v->skin, v->o.z, work->emissivity);
  if (factor > 0.0 && now->earth_varies) {
    um_optics_spectra_planck(s, (double)scene->brightness[v->at], work->earth);
    earth = work->earth;
  }
  if (factor > 0.0 && lobe && s->masks[v->skin])
    um_optics_spectra_masked(s, v->skin, v->o.z, work->masked_observer);
  for (size_t b = 0; b < n; b++) {
    row[b] = emissivity[b] * work->planck[b] + diffuse[b] * albedo * s->share[b];
    if (!(factor > 0.0)) continue;
    double flat = 1.0 - emissivity[b];
    if (lobe) {
      double rough = diffuse[b] - mean[b];
      if (s->masks[v->skin]) rough += work->masked_observer[b];
      flat = fmin(flat, rough);
    }
    row[b] += factor * flat * earth[b];
  }
}

bool um_optics_vertex_earth(const struct um_optics_paths *paths, const struct um_optics_vertex *v,
                            struct um_vec3 direction, double *row)
{
  const struct um_optics_spectra *s = paths->spectra;
  const struct um_optics_instant *now = paths->instant;
  if (!now->earth_lobe || now->sunlight_only) return false;
  double h = fmax(now->h_ratio, 1.0), cos_eta = um_vec3_dot(direction, now->nadir_body);
  if (!(cos_eta > sqrt(fmax(0.0, 1.0 - 1.0 / (h * h))))) return false;
  const double *earth = s->earth;
  double lit = now->earthshine * now->earth_radiance;
  if (lit > 0.0) lit *= um_optics_earth_lit(now->nadir_body, now->sun_body, h, direction, cos_eta);
  if (now->earth_varies) {
    um_optics_spectra_planck(s, (double)paths->scene->brightness[v->at], paths->work->earth);
    earth = paths->work->earth;
  }
  for (size_t b = 0; b < s->nbin; b++)
    row[b] = now->earth_reflection * earth[b] + lit * s->share[b];
  return true;
}
