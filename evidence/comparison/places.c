/* Places by name. */
#include "evidence/comparison/places_group.h"

#include <stdint.h>
#include <string.h>

#include "base/core/suggestions.h"

#define MATERIAL "material:"

static size_t find_material(const struct um_model *model, const char *name)
{
  size_t n = um_geometry_material_count(model->geometry);
  for (size_t k = 0; k < n; k++)
    if (strcmp(um_geometry_material_name(model->geometry, k), name) == 0)
      return model->body->nplace + k;
  return SIZE_MAX;
}

enum um_status um_compare_place_find(struct um_context *context, const struct um_model *model,
                                     const char *name, size_t *place)
{
  const struct um_thermal_body *body = model->body;
  struct um_core_words_guess guess = {.written = name};
  char accepted[640] = "", alike[320] = "", hint[UM_CORE_WORDS_HINT];
  size_t found = 0;
  bool material = strncmp(name, MATERIAL, sizeof MATERIAL - 1) == 0;
  *place = material ? find_material(model, name + sizeof MATERIAL - 1)
                    : um_thermal_body_place_find(body, name);
  if (*place != SIZE_MAX) return UM_OK;
  for (size_t p = 0; p < body->nplace; p++) {
    const char *known = body->place[p].name, *dot = strchr(known, '.');
    um_core_words_append(accepted, sizeof accepted, known);
    um_core_words_consider(&guess, known);
    if (dot == NULL) continue;
    um_core_words_consider(&guess, dot + 1);
    if (strcmp(dot + 1, name) != 0) continue;
    um_core_words_append(alike, sizeof alike, known);
    *place = p;
    found++;
  }
  if (found == 1) return UM_OK;
  *place = SIZE_MAX;
  if (found > 1)
    return um_core_fail(context, UM_ERR_INPUT, "'%s' stands for more than one place; accepted: %s",
                        name, alike);
  return um_core_fail(context, UM_ERR_INPUT,
                      "the scenario has no place '%s'%s; accepted: %s, " MATERIAL "NAME", name,
                      um_core_words_hint(&guess, hint), accepted);
}
