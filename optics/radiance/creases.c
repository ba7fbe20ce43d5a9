/* Skins of creased surfaces, and which of them are drawn patch by patch. */
#include "optics/radiance/creases.h"

#include "base/core/constants.h"
#include "materials/lobe.h"

/* Patches of a surface that mirror at once, N_eff: the mean of N patches varies by 1/sqrt(N_eff) of
 * itself where it is largest. With the variances v of a patch's own slopes, v = alpha^2/2, and s^2
 * of the tilts, the variance of one patch over the square of its mean is s^4/(v (v + 2 s^2)), for
 * wide tilts s^2/alpha^2 (docs/physics/creases.md). */
static double patches_in_beam(const struct um_materials_record *record, double area,
                              const struct um_geometry_creasing *creasing)
{
  struct um_materials_lobe lobe = um_materials_lobe(record, NULL);
  double sun = UM_SOLAR_RADIUS / UM_AU, s2 = um_geometry_slope_variance(creasing);
  double v = 0.5 * lobe.alpha * lobe.alpha_across + sun * sun / 16.0;
  return area / (creasing->patch * creasing->patch) * v * (v + 2.0 * s2) / (s2 * s2);
}

/* The skin of a material with a slope variance, new where there is none yet. */
static uint32_t skin_of(struct um_optics_creases *c, size_t nmaterial, uint32_t material,
                        double slope_variance)
{
  for (size_t k = nmaterial; k < c->nskin; k++)
    if (c->material[k] == material && c->slope_variance[k] == slope_variance) return (uint32_t)k;
  c->material[c->nskin] = material;
  c->slope_variance[c->nskin] = slope_variance;
  return (uint32_t)c->nskin++;
}

static bool widens(const struct um_materials_record *record)
{
  struct um_materials_lobe lobe = um_materials_lobe(record, NULL);
  return lobe.kind != NULL && (lobe.kind->rough || lobe.kind->delta);
}

static enum um_status skins_create(struct um_context *context, const struct um_geometry *geometry,
                                   const struct um_geometry_creasing *creasing,
                                   const struct um_materials_record *const *material, bool *wanted,
                                   struct um_optics_creases *c)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(geometry);
  size_t nmaterial = um_geometry_material_count(geometry);
  size_t most = nmaterial + 2 * um_geometry_group_count(geometry); /* both sides of each group */
  UM_TRY(um_core_allocate(context, mesh->nsurface, sizeof *c->skin, &c->skin));
  UM_TRY(um_core_allocate(context, most, sizeof *c->material, &c->material));
  UM_TRY(um_core_allocate(context, most, sizeof *c->slope_variance, &c->slope_variance));
  c->nskin = nmaterial;
  for (size_t m = 0; m < nmaterial; m++) c->material[m] = (uint32_t)m;
  for (size_t s = 0; s < mesh->nsurface; s++) {
    const struct um_geometry_surface *surface = &mesh->surface[s];
    const struct um_geometry_creasing *of = &creasing[surface->group];
    const struct um_materials_record *record = material[surface->material];
    c->skin[s] = surface->material;
    if (!(of->tilt_square > 0.0) || !widens(record)) continue;
    c->skin[s] = skin_of(c, nmaterial, surface->material, um_geometry_slope_variance(of));
    wanted[s] = of->patch > 0.0 &&
                patches_in_beam(record, mesh->area[surface->facet], of) < UM_OPTICS_PATCHES_MANY;
  }
  return UM_OK;
}

enum um_status um_optics_creases_create(struct um_context *context,
                                        const struct um_geometry *geometry,
                                        const struct um_geometry_creasing *creasing,
                                        const struct um_materials_record *const *material,
                                        struct um_optics_creases **out)
{
  enum um_status status;
  struct um_optics_creases *c = NULL;
  bool *wanted = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *c, &c));
  UM_CHECK(
      um_core_allocate(context, um_geometry_mesh(geometry)->nsurface, sizeof *wanted, &wanted));
  UM_CHECK(skins_create(context, geometry, creasing, material, wanted, c));
  if (c->nskin == um_geometry_material_count(geometry)) goto done; /* all flat */
  UM_CHECK(um_geometry_creases_create(context, geometry, creasing, wanted, &c->patches));
  *out = c;
  c = NULL;
done:
  um_core_free(context, wanted);
  um_optics_creases_destroy(context, &c);
  return status;
}

void um_optics_creases_destroy(struct um_context *context, struct um_optics_creases **creases)
{
  if (creases == NULL || *creases == NULL) return;
  um_geometry_creases_destroy(context, &(*creases)->patches);
  UM_FREE(context, (*creases)->skin, (*creases)->material, (*creases)->slope_variance, *creases);
  *creases = NULL;
}
