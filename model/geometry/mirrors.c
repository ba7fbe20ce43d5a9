/* Classes of mirrors: the sides of groups, which are of one material. Paths are traced as if all
 * were flat, so that a model with other creases shares them; how much goes along them is said here,
 * creases included. */
#include "model/geometry/mirrors.h"

#include "model/geometry/thermal_equal_group.h"

static struct um_materials_mirror mirror_of(const struct um_model *model, uint32_t material)
{
  if (material == UM_GEOMETRY_NONE || !model->environment.specular_exchange_on)
    return (struct um_materials_mirror){0.0, 0.0};
  return um_materials_mirror(model->material[material]);
}

/* The same as it hangs. */
static struct um_materials_mirror mirror_creased(const struct um_model *model,
                                                 const struct um_geometry_surface *surface)
{
  if (!model->environment.specular_exchange_on) return (struct um_materials_mirror){0.0, 0.0};
  return um_materials_mirror_creased(model->material[surface->material],
                                     um_geometry_slope_variance(&model->creasing[surface->group]));
}

static bool mirrors(struct um_materials_mirror mirror)
{
  return mirror.solar > 0.0 || mirror.infrared > 0.0;
}

enum um_status um_model_mirrors_create(struct um_context *context, const struct um_model *model,
                                       struct um_geometry_mirrors **out)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  size_t ngroup = um_geometry_group_count(model->geometry), n = 0;
  uint16_t *of_side = NULL; /* [ngroup][2] */
  enum um_status status;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 2 * ngroup, sizeof *of_side, &of_side));
  UM_CHECK(um_geometry_mirrors_create(context, mesh->nsurface, out));
  for (size_t g = 0; g < ngroup; g++) {
    const struct um_geometry_group *group = um_geometry_group(model->geometry, (uint32_t)g);
    const uint32_t material[2] = {group->front_material, group->back_material};
    for (int side = 0; side < 2; side++) {
      bool own = mirrors(mirror_of(model, material[side])) && n < UM_GEOMETRY_NO_MIRROR;
      of_side[2 * g + (size_t)side] = own ? (uint16_t)n++ : UM_GEOMETRY_NO_MIRROR;
    }
  }
  for (size_t s = 0; s < mesh->nsurface; s++)
    (*out)->of[s] = of_side[2 * mesh->surface[s].group + (mesh->surface[s].back != 0)];
  (*out)->nclass = n;
  if (n == 0) um_geometry_mirrors_destroy(context, out);
done:
  um_core_free(context, of_side);
  if (status != UM_OK) um_geometry_mirrors_destroy(context, out);
  return status;
}

enum um_status um_model_mirror_classes_are_compatible(struct um_context *context,
                                                      const struct um_model *made,
                                                      const struct um_model *model, bool *out)
{
  enum um_status status;
  struct um_geometry_mirrors *a = NULL, *b = NULL;
  UM_CHECK(um_model_mirrors_create(context, made, &a));
  UM_CHECK(um_model_mirrors_create(context, model, &b));
  *out = um_model_mirror_classes_equal(a, b);
done:
  um_geometry_mirrors_destroy(context, &a);
  um_geometry_mirrors_destroy(context, &b);
  return status;
}

enum um_status um_model_lobes_make(struct um_context *context, const struct um_model *model,
                                   const struct um_geometry_mirrors *mirrors_of,
                                   struct um_model_lobes *out)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  *out = (struct um_model_lobes){0};
  UM_TRY(um_core_allocate(context, 2 * mirrors_of->nclass, sizeof *out->share, &out->share));
  double *solar = out->share, *infrared = out->share + mirrors_of->nclass;
  for (size_t s = 0; s < mesh->nsurface && s < mirrors_of->nsurface; s++) {
    if (mirrors_of->of[s] == UM_GEOMETRY_NO_MIRROR) continue;
    struct um_materials_mirror mirror = mirror_creased(model, &mesh->surface[s]);
    solar[mirrors_of->of[s]] = mirror.solar;
    infrared[mirrors_of->of[s]] = mirror.infrared;
  }
  out->lobes = (struct um_thermal_lobes){solar, infrared};
  return UM_OK;
}

void um_model_lobes_clear(struct um_context *context, struct um_model_lobes *lobes)
{
  um_core_free(context, lobes->share);
  *lobes = (struct um_model_lobes){0};
}

static bool mirrors_equal(const struct um_model *a, const struct um_model *b, bool in_infrared)
{
  const struct um_geometry_mesh *own = um_geometry_mesh(a->geometry),
                                *other = um_geometry_mesh(b->geometry);
  if (own->nsurface != other->nsurface) return false;
  for (size_t s = 0; s < own->nsurface; s++) {
    struct um_materials_mirror m = mirror_creased(a, &own->surface[s]),
                               n = mirror_creased(b, &other->surface[s]);
    if (m.solar != n.solar || (in_infrared && m.infrared != n.infrared)) return false;
  }
  return true;
}

bool um_model_mirrors_equal(const struct um_model *a, const struct um_model *b)
{
  return mirrors_equal(a, b, true);
}

bool um_model_mirrors_equal_in_sunlight(const struct um_model *a, const struct um_model *b)
{
  return mirrors_equal(a, b, false);
}
