/* A turn of a path: directions by importance, and spectra of what is reflected.
 *
 *   f_r = (rho_d - <M>)/pi + M(i) M(o)/(pi <M>) + F(cos_d) f(i, o)
 *
 * (materials.h), at every wavelength; where an emissivity is tilted, scaled so that both make 1. A
 * direction is that of the lobe or one by the cosine. Shares come in steps (spectra.c), so that a
 * parameter that is moved moves paths smoothly. */
#include <math.h>

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "optics/paths/paths_impl.h"

#define NARROW 0.15 /* alpha below which a lobe is a mirror to paths */

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

void um_optics_vertex_place(const struct um_optics_paths *paths, size_t surface,
                            struct um_vec3 point, struct um_vec3 from, struct um_optics_vertex *v)
{
  const struct um_geometry_mesh *mesh = paths->posed->exchange->mesh;
  v->surface = surface;
  v->skin = um_optics_skin(paths->spectra, mesh, surface);
  v->at = paths->instant->time * mesh->nsurface + surface;
  v->point = point;
  v->normal = um_geometry_surface_normal(mesh, paths->posed->pose, surface);
  axes(paths, surface, v->skin, v->normal, &v->along, &v->across);
  v->o = from_body(v->along, v->across, v->normal, from);
  const struct um_materials_lobe *lobe = &paths->spectra->lobe[v->skin];
  bool has = lobe->kind != NULL;
  v->toward = has ? um_materials_lobe_toward(lobe, v->o) : 0.0;
  v->mirror = um_optics_is_mirror(lobe);
}

bool um_optics_is_mirror(const struct um_materials_lobe *lobe)
{
  return lobe->kind != NULL && (lobe->kind->delta || (lobe->kind->rough && lobe->alpha < NARROW));
}

static bool same_mixture(const struct um_materials_mixture *a, const struct um_materials_mixture *b)
{
  if (a == NULL || b == NULL || a == b) return a == b;
  for (int k = 0; k < 2; k++)
    if (a->of[k].kind != b->of[k].kind || a->of[k].ratio != b->of[k].ratio ||
        a->of[k].correlated != b->of[k].correlated)
      return false;
  return a->share == b->share;
}

bool um_optics_same_lobe(const struct um_materials_lobe *a, const struct um_materials_lobe *b)
{
  return a->kind == b->kind && a->alpha == b->alpha && a->alpha_across == b->alpha_across &&
         a->correlated == b->correlated && a->tilted == b->tilted &&
         a->compensated == b->compensated && a->measured == b->measured &&
         same_mixture(a->mixture, b->mixture);
}

/* Density [1/sr] and lobe of a direction that either way may have found. */
static void weigh(const struct um_optics_paths *paths, const struct um_optics_vertex *v,
                  struct um_vec3 i, struct um_optics_turn *turn)
{
  const struct um_materials_lobe *lobe = &paths->spectra->lobe[v->skin];
  double share = paths->spectra->lobe_share[v->skin], p = (1.0 - share) * i.z / UM_PI, f = 0.0;
  turn->cos_i = i.z;
  turn->cos_d = 1.0;
  if (lobe->kind != NULL && !lobe->kind->delta) {
    struct um_materials_pair pair = um_materials_pair(i, v->o);
    f = lobe->kind->evaluate(lobe, &pair);
    p += share * lobe->kind->density(lobe, &pair);
    turn->cos_d = pair.cos_d;
  }
  turn->flat = i.z / p;
  turn->lobe = f * i.z / p;
}

/* A direction i that a lobe reflects to o, body frame into the turn; false: none. */
static bool draw(const struct um_materials_lobe *lobe, const struct um_optics_vertex *v,
                 double toward, const double u[2], struct um_materials_reflected *r,
                 struct um_optics_turn *turn)
{
  struct um_vec3 drawn = lobe->kind->draw(lobe, u[0], u[1]);
  lobe->kind->reflect(lobe, &drawn, 1, v->o, toward, r);
  if (!(r->weight > 0.0)) return false;
  turn->direction = um_vec3_unit(to_body(v->along, v->across, v->normal, r->i));
  turn->cos_i = r->i.z;
  turn->cos_d = r->cos_d;
  turn->flat = 0.0;
  turn->lobe = r->weight;
  return true;
}

/* A direction i by the lobe or by the cosine, both frames; false: none. Of the turn the rest is the
 * lobe's own. */
static bool direct(const struct um_materials_lobe *lobe, const struct um_optics_vertex *v,
                   bool by_lobe, const double u[2], struct um_vec3 *i, struct um_optics_turn *turn)
{
  if (by_lobe) {
    struct um_materials_reflected r;
    if (!draw(lobe, v, v->toward, u, &r, turn)) return false;
    *i = r.i;
    return true;
  }
  turn->direction = um_core_sample_cosine(u, v->normal);
  *i = from_body(v->along, v->across, v->normal, turn->direction);
  return true;
}

bool um_optics_vertex_direction(const struct um_optics_paths *paths,
                                const struct um_optics_vertex *v, bool by_lobe, const double u[2],
                                struct um_vec3 *direction)
{
  const struct um_materials_lobe *lobe = &paths->spectra->lobe[v->skin];
  struct um_optics_turn turn;
  struct um_vec3 i;
  if ((by_lobe && lobe->kind == NULL) || !direct(lobe, v, by_lobe, u, &i, &turn)) return false;
  *direction = turn.direction;
  return i.z > 0.0;
}

bool um_optics_vertex_sample(const struct um_optics_paths *paths, const struct um_optics_vertex *v,
                             double which, const double u[2], struct um_optics_turn *turn)
{
  const struct um_materials_lobe *lobe = &paths->spectra->lobe[v->skin];
  double share = paths->spectra->lobe_share[v->skin];
  bool by_lobe = which < share;
  struct um_vec3 i;
  if (!direct(lobe, v, by_lobe, u, &i, turn)) return false;
  if (by_lobe) turn->lobe /= share;
  if (by_lobe && lobe->kind->delta) return true;
  if (!(i.z > 0.0)) return false;
  weigh(paths, v, i, turn);
  return true;
}

bool um_optics_vertex_mirror(const struct um_optics_paths *paths, const struct um_optics_vertex *v,
                             bool sunlight, const double u[2], struct um_optics_turn *turn)
{
  const struct um_materials_lobe *lobe = &paths->spectra->lobe[v->skin];
  struct um_materials_reflected r;
  if (lobe->kind->delta) return draw(lobe, v, v->toward, u, &r, turn);
  double radius = sunlight ? paths->instant->sun_radius : 0.0;
  struct um_materials_lobe wide = *lobe; /* as the Sun's disc makes it */
  wide.alpha = hypot(lobe->alpha, 0.5 * radius);
  wide.alpha_across = hypot(lobe->alpha_across, 0.5 * radius);
  if (!draw(&wide, v, sunlight ? um_materials_lobe_toward(&wide, v->o) : v->toward, u, &r, turn))
    return false;
  struct um_materials_pair pair = um_materials_pair(v->o, r.i);
  double f = sunlight ? lobe->kind->sunlit(lobe, &pair, radius) : lobe->kind->evaluate(lobe, &pair);
  turn->lobe = f * r.i.z / wide.kind->density(&wide, &pair);
  return true;
}

bool um_optics_vertex_lit(const struct um_optics_paths *paths, const struct um_optics_vertex *v,
                          struct um_vec3 direction, struct um_optics_turn *turn)
{
  const struct um_materials_lobe *lobe = &paths->spectra->lobe[v->skin];
  struct um_vec3 i = from_body(v->along, v->across, v->normal, direction);
  if (!(i.z > 0.0)) return false;
  *turn = (struct um_optics_turn){.direction = direction, .cos_i = i.z, .cos_d = 1.0, .flat = 1.0};
  if (lobe->kind == NULL || v->mirror) return true;
  struct um_materials_pair pair = um_materials_pair(i, v->o);
  turn->cos_d = pair.cos_d;
  turn->lobe = lobe->kind->evaluate(lobe, &pair);
  return true;
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
  turn->lobe = i.z * lobe->kind->sunlit(lobe, &pair, paths->instant->sun_radius);
  return true;
}

/* Where the emissivity toward o is tilted, what is reflected to there is scaled to 1 - eps
 * (Kirchhoff). A black surface has nothing to scale: it scatters 1 - eps times `flat`. */
static void tilt(const struct um_optics_paths *paths, const struct um_optics_vertex *v, double flat,
                 double *row)
{
  const struct um_optics_spectra *s = paths->spectra;
  if (!s->tilts[v->skin]) return;
  const double *of = s->tilt + v->skin * s->nbin;
  const double *upright = um_optics_spectra_untilted(s, v->skin, v->o.z, paths->work->upright);
  for (size_t b = 0; b < s->nbin; b++) {
    if (of[b] == 0.0) continue;
    double left = 1.0 - um_materials_emissivity_tilted(upright[b], of[b], v->o.z);
    row[b] = upright[b] < 1.0 ? row[b] * left / (1.0 - upright[b]) : flat * left;
  }
}

void um_optics_vertex_row(const struct um_optics_paths *paths, const struct um_optics_vertex *v,
                          const struct um_optics_turn *turn, enum um_optics_parts parts,
                          double *row)
{
  const struct um_optics_spectra *s = paths->spectra;
  struct um_optics_work *work = paths->work;
  size_t n = s->nbin;
  const double *diffuse = s->diffuse + v->skin * n, *mean = s->masked_mean + v->skin * n;
  double flat = (parts & UM_OPTICS_FLAT) != 0 ? turn->flat / UM_PI : 0.0;
  for (size_t b = 0; b < n; b++) row[b] = flat * (diffuse[b] - mean[b]);
  if (flat > 0.0 && s->masks[v->skin]) {
    um_optics_spectra_masked(s, v->skin, turn->cos_i, work->masked_sun);
    um_optics_spectra_masked(s, v->skin, v->o.z, work->masked_observer);
    for (size_t b = 0; b < n; b++)
      if (mean[b] > 0.0) row[b] += flat * work->masked_sun[b] * work->masked_observer[b] / mean[b];
  }
  if ((parts & UM_OPTICS_LOBE) != 0 && turn->lobe > 0.0) {
    double weight[4];
    const double *node = um_optics_fresnel_at(s, v->skin, turn->cos_d, weight);
    for (int k = 0; k < 4; k++) weight[k] *= turn->lobe;
    for (size_t b = 0; b < n; b++)
      row[b] += weight[0] * node[b] + weight[1] * node[n + b] + weight[2] * node[2 * n + b] +
                weight[3] * node[3 * n + b];
  }
  tilt(paths, v, flat, row);
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
  double albedo = now->earthshine * (double)scene->albedo[v->at] / UM_PI;
  double factor = now->earth_reflection * (double)scene->view_factor[v->at];
  bool lobe = factor > 0.0 && now->earth_lobe && s->lobe[v->skin].kind != NULL;
  const double *earth = s->earth;
  um_optics_spectra_planck(s, scene->temperature[v->at], work->planck);
  const double *emissivity = um_optics_spectra_emissivity(s, v->skin, v->o.z, work->emissivity);
  if (factor > 0.0 && now->earth_varies) {
    um_optics_spectra_planck(s, (double)scene->brightness[v->at], work->earth);
    for (size_t b = 0; b < n; b++) work->earth[b] *= work->earth_ratio[b];
    earth = work->earth;
  }
  if (lobe && s->masks[v->skin])
    um_optics_spectra_masked(s, v->skin, v->o.z, work->masked_observer);
  double *rough = work->row; /* what reflects the Earth by its view factor */
  for (size_t b = 0; b < n && lobe; b++)
    rough[b] = diffuse[b] - mean[b] + (s->masks[v->skin] ? work->masked_observer[b] : 0.0);
  if (lobe) tilt(paths, v, 1.0, rough);
  for (size_t b = 0; b < n; b++) {
    row[b] = emissivity[b] * work->planck[b] + diffuse[b] * albedo * s->share[b];
    if (!(factor > 0.0)) continue;
    double flat = 1.0 - emissivity[b];
    row[b] += factor * (lobe ? fmin(flat, rough[b]) : flat) * earth[b];
  }
}

bool um_optics_vertex_earth(const struct um_optics_paths *paths, struct um_vec3 direction,
                            double *row)
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
    double albedo;
    um_optics_earth_toward(s, now, direction, paths->work, paths->work->earth, &albedo);
    earth = paths->work->earth;
    lit *= albedo;
  }
  for (size_t b = 0; b < s->nbin; b++)
    row[b] = now->earth_reflection * earth[b] + lit * s->share[b];
  return true;
}
