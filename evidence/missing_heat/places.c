/* Places that heat may be missing in: the wall of every group and every interior. A wall takes heat
 * as power_W of a group does, by area over its structure: the wall under MLI, else what radiates,
 * both layers alike where it has two. Where MLI wraps the interior there is no wall; the place is
 * then the MLI's skin, since heat may be missing there as well. */
#include "evidence/missing_heat/places_impl.h"

#include <string.h>

/* Nodes of a body's place "part.group<suffix>", with their weights times `fraction`. */
static void append(const struct um_thermal_place *from, double fraction,
                   struct um_missing_heat_place *to)
{
  for (size_t i = 0; from != NULL && i < from->nnode; i++) {
    to->node[to->nnode] = from->node[i];
    to->weight[to->nnode++] = fraction * from->weight[i];
  }
}

static enum um_status find(struct um_context *context, const struct um_thermal_body *body,
                           const char *stem, const char *suffix,
                           const struct um_thermal_place **out)
{
  char *name = NULL;
  UM_TRY(um_core_asprintf(context, &name, "%s%s", stem, suffix));
  size_t index = um_thermal_body_place_find(body, name);
  *out = index == (size_t)-1 ? NULL : &body->place[index];
  um_core_free(context, name);
  return UM_OK;
}

/* Front, if any, and back, if any. */
static enum um_status fill(struct um_context *context, const struct um_thermal_place *front,
                           const struct um_thermal_place *back, struct um_missing_heat_place *out)
{
  size_t n = (front != NULL ? front->nnode : 0) + (back != NULL ? back->nnode : 0);
  double fraction = front != NULL && back != NULL ? 0.5 : 1.0;
  UM_TRY(um_core_allocate(context, n, sizeof *out->node, &out->node));
  UM_TRY(um_core_allocate(context, n, sizeof *out->weight, &out->weight));
  append(front, fraction, out);
  append(back, fraction, out);
  return UM_OK;
}

static size_t groups_of(const struct um_geometry *geometry, uint32_t part)
{
  size_t n = 0;
  for (size_t g = 0; g < um_geometry_group_count(geometry); g++)
    if (um_geometry_group(geometry, g)->part == part) n++;
  return n;
}

static enum um_status wall_add(struct um_context *context, const struct um_model *model,
                               size_t group, struct um_missing_heat_place *out, size_t *nplace)
{
  enum um_status status;
  const struct um_geometry_group *g = um_geometry_group(model->geometry, group);
  const char *part = um_geometry_part_name(model->geometry, g->part);
  const struct um_thermal_place *front, *wall, *back;
  struct um_missing_heat_place *place = &out[*nplace];
  char *stem = NULL;
  UM_CHECK(um_core_asprintf(context, &stem, "%s.%s", part, g->name));
  UM_CHECK(find(context, model->body, stem, "", &front));
  UM_CHECK(find(context, model->body, stem, ".wall", &wall));
  UM_CHECK(find(context, model->body, stem, ".back", &back));
  if (wall != NULL) front = wall;
  if (front == NULL && back == NULL) goto done;
  (*nplace)++;
  UM_CHECK(
      um_core_strdup(context, groups_of(model->geometry, g->part) > 1 ? stem : part, &place->name));
  UM_CHECK(fill(context, front, back, place));
done:
  um_core_free(context, stem);
  return status;
}

/* Interiors of a part whose temperatures are computed. */
static enum um_status interiors_add(struct um_context *context, const struct um_model *model,
                                    size_t part, struct um_missing_heat_place *out, size_t *nplace)
{
  const char *name = um_geometry_part_name(model->geometry, part);
  size_t n = strlen(name);
  for (size_t i = 0; i < model->body->nplace; i++) {
    const struct um_thermal_place *interior = &model->body->place[i];
    bool inside =
        interior->kind == UM_PLACE_INTERIOR &&
        um_thermal_network_kind(model->body->network, interior->node[0]) != UM_NODE_BOUNDARY;
    if (!inside || strncmp(interior->name, name, n) != 0 || interior->name[n] != '.') continue;
    struct um_missing_heat_place *place = &out[(*nplace)++];
    UM_TRY(um_core_strdup(context, interior->name, &place->name));
    UM_TRY(fill(context, interior, NULL, place));
  }
  return UM_OK;
}

enum um_status um_missing_heat_places_create(struct um_context *context,
                                             const struct um_model *model,
                                             struct um_missing_heat_place **out, size_t *nplace)
{
  size_t ngroup = um_geometry_group_count(model->geometry);
  size_t npart = um_geometry_part_count(model->geometry);
  *nplace = 0;
  UM_TRY(um_core_allocate(context, ngroup + model->body->nplace, sizeof **out, out));
  for (size_t p = 0; p < npart; p++) {
    UM_TRY(interiors_add(context, model, p, *out, nplace));
    for (size_t g = 0; g < ngroup; g++)
      if (um_geometry_group(model->geometry, g)->part == p)
        UM_TRY(wall_add(context, model, g, *out, nplace));
  }
  return UM_OK;
}

void um_missing_heat_places_destroy(struct um_context *context,
                                    struct um_missing_heat_place **place, size_t nplace)
{
  for (size_t i = 0; *place != NULL && i < nplace; i++) {
    UM_FREE(context, (*place)[i].name, (*place)[i].node, (*place)[i].weight);
  }
  um_core_free(context, *place);
  *place = NULL;
}
