/* Which material each side of each group has, and the surfaces that follow from it. */
#include "geometry/skin_impl.h"

#include <string.h>

/* Index of a material name, added when new. NULL gives UM_GEOMETRY_NONE. */
static enum um_status find_material(struct um_geometry *geometry, const char *name,
                                    uint32_t *material)
{
  *material = UM_GEOMETRY_NONE;
  if (name == NULL) return UM_OK;
  for (size_t i = 0; i < geometry->nmaterial; i++)
    if (strcmp(geometry->material[i], name) == 0) {
      *material = (uint32_t)i;
      return UM_OK;
    }
  UM_TRY(um_core_reallocate(geometry->context, geometry->nmaterial + 1, sizeof *geometry->material,
                            (void *)&geometry->material));
  UM_TRY(um_core_strdup(geometry->context, name, &geometry->material[geometry->nmaterial]));
  *material = (uint32_t)geometry->nmaterial++;
  return UM_OK;
}

/* skin[ngroup]: of each group, by its name, else the one without a name, else NULL. */
static void find_skins(const struct um_geometry_part_spec *spec,
                       const struct um_geometry_patch *patch, const struct um_geometry_skin **skin)
{
  for (size_t i = 0; i < spec->nskin; i++)
    if (spec->skins[i].group == NULL)
      for (size_t g = 0; g < patch->ngroup; g++) skin[g] = &spec->skins[i];
  for (size_t i = 0; i < spec->nskin; i++)
    if (spec->skins[i].group != NULL)
      skin[um_geometry_patch_group_find(patch, spec->skins[i].group)] = &spec->skins[i];
}

/* "a, b, c" of the groups, cut when long. */
static void list_groups(const struct um_geometry_patch *patch, char *text, size_t size)
{
  size_t n = 0;
  text[0] = '\0';
  for (size_t i = 0; i < patch->ngroup; i++) {
    const char *name = patch->group_name[i];
    if (n + strlen(name) + 8 > size) {
      memcpy(text + n, ", ...", 6);
      return;
    }
    if (i > 0) {
      memcpy(text + n, ", ", 2);
      n += 2;
    }
    memcpy(text + n, name, strlen(name) + 1);
    n += strlen(name);
  }
}

/* Skins that name no group of the part, or one twice. */
static enum um_status check_skins(const struct um_geometry_part_spec *spec,
                                  const struct um_geometry_patch *patch)
{
  for (size_t i = 0; i < spec->nskin; i++) {
    const char *name = spec->skins[i].group;
    for (size_t j = 0; j < i; j++) {
      const char *other = spec->skins[j].group;
      if (name == NULL ? other == NULL : other != NULL && strcmp(name, other) == 0)
        return um_core_fail(patch->context, UM_ERR_INPUT, "part '%s': materials of %s given twice",
                            spec->name, name == NULL ? "all other groups" : name);
    }
    if (name == NULL || um_geometry_patch_group_find(patch, name) != UM_GEOMETRY_NONE) continue;
    char list[400];
    list_groups(patch, list, sizeof list);
    return um_core_fail(patch->context, UM_ERR_INPUT,
                        "part '%s': there is no group '%s'; its groups are: %s", spec->name, name,
                        list);
  }
  return UM_OK;
}

static enum um_status add_group(struct um_geometry *geometry,
                                const struct um_geometry_part_spec *spec, uint32_t part,
                                const struct um_geometry_patch *patch, uint32_t group,
                                const struct um_geometry_skin *skin, bool open, bool closed)
{
  const char *name = patch->group_name[group];
  if (skin == NULL || skin->front == NULL || skin->front[0] == '\0')
    return um_core_fail(patch->context, UM_ERR_INPUT, "part '%s': group '%s' has no %smaterial",
                        spec->name, name, skin == NULL ? "" : "front ");
  if (open && (skin->back == NULL || skin->back[0] == '\0'))
    return um_core_fail(patch->context, UM_ERR_INPUT,
                        "part '%s': group '%s' has no back material, which its open surface needs "
                        "because it is seen from both sides",
                        spec->name, name);
  /* a back inside a closed piece would radiate its heat into the body, which counts as space */
  if (closed && skin->back != NULL && skin->back[0] != '\0')
    return um_core_fail(patch->context, UM_ERR_INPUT,
                        "part '%s': group '%s' has the back material '%s', but %s; accepted: %s",
                        spec->name, name, skin->back,
                        open ? "some of its facets enclose a body and some are open"
                             : "its facets enclose a body, whose inside is no surface",
                        open ? "closed and open facets in groups of their own"
                             : "outside, or front without back");
  struct um_geometry_group *g = &geometry->group[geometry->ngroup];
  char *copy;
  UM_TRY(um_core_strdup(geometry->context, name, &copy));
  *g = (struct um_geometry_group){copy, part, 0, 0};
  geometry->ngroup++;
  const char *back = skin->back != NULL && skin->back[0] != '\0' ? skin->back : NULL;
  UM_TRY(find_material(geometry, skin->front, &g->front_material));
  return find_material(geometry, back, &g->back_material);
}

enum um_status um_geometry_skin_apply(struct um_geometry *geometry,
                                      const struct um_geometry_part_spec *spec, uint32_t part,
                                      const struct um_geometry_patch *patch, const uint8_t *closed)
{
  enum um_status status;
  const struct um_geometry_skin **skin = NULL;
  bool(*has)[2] = NULL; /* [ngroup] open, closed facets */
  UM_TRY(check_skins(spec, patch));
  UM_CHECK(um_core_allocate(geometry->context, patch->ngroup, sizeof *skin, (void *)&skin));
  UM_CHECK(um_core_allocate(geometry->context, patch->ngroup, sizeof *has, (void *)&has));
  UM_CHECK(um_core_reallocate(geometry->context, geometry->ngroup + patch->ngroup,
                              sizeof *geometry->group, (void *)&geometry->group));
  find_skins(spec, patch, skin);
  for (size_t f = 0; f < patch->nfacet; f++) has[patch->group[f]][closed[f] != 0] = true;
  for (uint32_t g = 0; g < patch->ngroup; g++)
    UM_CHECK(add_group(geometry, spec, part, patch, g, skin[g], has[g][0], has[g][1]));
done:
  UM_FREE(geometry->context, (void *)skin, (void *)has);
  return status;
}
