/* Surfaces in coplanar groups. */
#include "optics/radiance/coplanar_group.h"

#include <math.h>

#define LOOK_BACK                                                                                  \
  64 /* groups: walls stand together in a mesh, and a dish has no two facets alike */
#define SAME       3e-7F /* difference of cosines, of what a float tells apart */
#define SAME_GRAIN 1e-9
#define SAME_HALF  1e-12 /* narrow lobes depend on 1 - cos */

enum um_status um_optics_coplanar_create(struct um_context *context, size_t nsurface,
                                         struct um_optics_coplanar *coplanar)
{
  UM_TRY(um_core_allocate(context, nsurface, sizeof *coplanar->sight, &coplanar->sight));
  UM_TRY(um_core_allocate(context, nsurface, sizeof *coplanar->surface, &coplanar->surface));
  UM_TRY(um_core_allocate(context, nsurface, sizeof *coplanar->lit_error, &coplanar->lit_error));
  UM_TRY(um_core_allocate(context, nsurface + 1, sizeof *coplanar->first, &coplanar->first));
  UM_TRY(um_core_allocate(context, nsurface, sizeof *coplanar->of, &coplanar->of));
  return um_core_allocate(context, nsurface, sizeof *coplanar->seen, &coplanar->seen);
}

void um_optics_coplanar_clear(struct um_context *context, struct um_optics_coplanar *coplanar)
{
  UM_FREE(context, coplanar->sight, coplanar->surface, coplanar->lit_error, coplanar->first,
          coplanar->of, coplanar->seen);
}

/* Where an instant stands in the arrays of a view. */
struct rows {
  const struct um_optics_lit *by;
  size_t view, lit; /* of its first surface */
};

static struct rows rows_of(const struct um_optics_view *view, const struct um_optics_instant *now)
{
  size_t n = view->nsurface;
  if (now->lamp.name == UM_LAMP_MOON)
    return (struct rows){&view->moon, now->time * n, view->moon_row[now->time] * n};
  return (struct rows){&view->sun, now->time * n, now->time * n};
}

static bool alone(const struct um_optics_spectra *spectra, size_t surface)
{
  const struct um_optics_creases *c = spectra->creases;
  return c != NULL && c->patches->first[surface + 1] > c->patches->first[surface];
}

static bool same(const struct um_optics_view *view, const struct rows *rows, size_t surface,
                 size_t other)
{
  size_t a = rows->view + surface, b = rows->view + other;
  size_t i = rows->lit + surface, j = rows->lit + other;
  return fabsf(view->cos_observer[a] - view->cos_observer[b]) <= SAME &&
         fabsf(rows->by->cosine[i] - rows->by->cosine[j]) <= SAME &&
         fabsf(view->cos_nadir[a] - view->cos_nadir[b]) <= SAME &&
         fabs(rows->by->cos_half[i] - rows->by->cos_half[j]) <= SAME_HALF;
}

/* Of surfaces of an anisotropic lobe, or before an Earth that varies. */
static bool same_grain(const struct um_optics_spectra *spectra, const struct um_optics_scene *scene,
                       size_t a, size_t b, const struct um_optics_work *work)
{
  struct um_optics_sight of[2] = {0};
  um_optics_sight_turn(spectra, scene, a, work, &of[0]);
  um_optics_sight_turn(spectra, scene, b, work, &of[1]);
  return um_vec3_norm(um_vec3_sub(of[0].grain, of[1].grain)) <= SAME_GRAIN &&
         um_vec3_norm(um_vec3_sub(of[0].across, of[1].across)) <= SAME_GRAIN;
}

static struct um_optics_sight sight_of(const struct um_optics_scene *scene, const struct rows *rows,
                                       size_t s)
{
  const struct um_optics_view *view = scene->view;
  size_t at = rows->view + s, lit = rows->lit + s;
  return (struct um_optics_sight){
      .area_seen = view->area[s] * (double)view->seen[at],
      .area_lit = view->area[s] * (double)rows->by->share[lit],
      .cos_observer = (double)view->cos_observer[at],
      .cos_lamp = (double)rows->by->cosine[lit],
      .cos_half = rows->by->cos_half[lit],
      .cos_sun = (double)view->sun.cosine[at],
      .cos_nadir = (double)view->cos_nadir[at],
      .temperature = scene->temperature[at],
      .albedo = (double)scene->albedo[at],
      .view_factor = (double)scene->view_factor[at],
      .brightness = scene->brightness != NULL ? (double)scene->brightness[at] : 0.0};
}

/* The group of a surface among the last of them, each known by its first member. */
static size_t group_of(const struct um_optics_spectra *spectra, const struct um_optics_scene *scene,
                       const struct rows *rows, size_t surface, const struct um_optics_work *work,
                       struct um_optics_coplanar *f)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(scene->geometry);
  size_t skin = um_optics_skin(spectra, mesh, surface);
  size_t down_to = f->ngroup > LOOK_BACK ? f->ngroup - LOOK_BACK : 0;
  bool single = alone(spectra, surface);
  bool grain = spectra->varies || um_materials_lobe_is_anisotropic(&spectra->lobe[skin]);
  for (size_t g = f->ngroup; !single && g-- > down_to;) {
    size_t other = f->first[g]; /* a surface, until all groups are known */
    if (um_optics_skin(spectra, mesh, other) == skin && !alone(spectra, other) &&
        same(scene->view, rows, surface, other) &&
        (!grain || same_grain(spectra, scene, surface, other, work)))
      return g;
  }
  f->first[f->ngroup] = surface;
  return f->ngroup++;
}

void um_optics_coplanar_fill(const struct um_optics_spectra *spectra,
                             const struct um_optics_scene *scene,
                             const struct um_optics_instant *now, const struct um_optics_work *work,
                             struct um_optics_coplanar *f)
{
  const struct um_optics_view *view = scene->view;
  struct rows rows = rows_of(view, now);
  f->count = f->ngroup = 0;
  for (size_t s = 0; s < view->nsurface; s++) {
    size_t at = rows.view + s;
    bool uncertain = view->seen_error[at] > 0.0F || rows.by->error[rows.lit + s] > 0.0F;
    if (!(view->cos_observer[at] > 0.0F) || !(view->seen[at] > 0.0F || uncertain)) continue;
    f->of[f->count] = (uint32_t)group_of(spectra, scene, &rows, s, work, f);
    f->seen[f->count++] = (uint32_t)s;
  }
  for (size_t g = 0; g <= f->ngroup; g++) f->first[g] = 0;
  for (size_t i = 0; i < f->count; i++) f->first[f->of[i] + 1]++;
  for (size_t g = 0; g < f->ngroup; g++) f->first[g + 1] += f->first[g];
  for (size_t i = 0; i < f->count; i++) {
    size_t s = f->seen[i], place = f->first[f->of[i]]++; /* moves to where the next group begins */
    f->surface[place] = (uint32_t)s;
    f->sight[place] = sight_of(scene, &rows, s);
    f->lit_error[place] = rows.by->error[rows.lit + s];
    um_optics_sight_turn(spectra, scene, s, work, &f->sight[place]);
  }
  for (size_t g = f->ngroup; g > 0; g--) f->first[g] = f->first[g - 1];
  f->first[0] = 0;
}
