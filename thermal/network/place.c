/* Named places of a body: what temperature means on a part, side, group, interior or wall.
 *
 *   part, part.front, part.back   the radiating surfaces, area weighted (MLI where there is MLI)
 *   part.group, part.group.back   the same of one group and side
 *   part.wall, part.group.wall    the wall under MLI, where there is one
 *   part.sheets, part.group.sheets  the sheets of MLI under its outer layer, where they store heat
 *   part.inside, part.group.inside  the inner layer of a wall that radiates inside and has one
 *   part.core, part.group.core    what lies between the layers of a wall, where it has nodes
 *   part.NAME                     the interior of that name */
#include "thermal/network/builder_impl.h"

#include <string.h>

/* The inner layer has two names where it radiates inside. */
static bool is_back(const struct um_thermal_builder *b, uint32_t part, const char *word)
{
  return strcmp(word, "back") == 0 || (b->part[part]->inside && strcmp(word, "inside") == 0);
}

bool um_thermal_where_find(const struct um_thermal_builder *b, const char *suffix,
                           struct um_thermal_where *where)
{
  where->group = UM_GEOMETRY_NONE;
  where->front = where->back = true;
  where->interior = UM_THERMAL_SPACE;
  if (*suffix == '\0') return true;
  if (*suffix != '.') return false;
  suffix++;
  for (uint32_t g = 0; g < b->ngroup; g++) {
    const struct um_geometry_group *group = um_geometry_group(b->geometry, g);
    size_t n = strlen(group->name);
    if (group->part != where->part || strncmp(suffix, group->name, n) != 0) continue;
    where->group = g;
    where->front = suffix[n] == '\0';
    where->back = suffix[n] == '.' && is_back(b, where->part, suffix + n + 1);
    if (where->front || where->back) return true;
  }
  where->group = UM_GEOMETRY_NONE;
  where->front = strcmp(suffix, "front") == 0;
  where->back = is_back(b, where->part, suffix);
  for (size_t i = 0; i < b->part[where->part]->ninterior; i++)
    if (strcmp(suffix, b->part[where->part]->interior[i].name) == 0)
      where->interior = um_thermal_builder_interiors(b, where->part)[i];
  return where->front || where->back || where->interior != UM_THERMAL_SPACE;
}

struct selection {
  uint32_t part, group; /* group UM_GEOMETRY_NONE: all */
  int side;             /* 0 front, 1 back, -1 both */
  bool wall;            /* the wall under MLI instead of the surfaces */
  bool inside;          /* the inner layer, where it radiates inside */
  bool sheets;          /* the sheets of MLI */
  bool core;            /* what lies between the layers of a wall */
  size_t from, to;      /* surfaces of the part, which stand together */
};

/* Nodes that have area now lie in [low, high). */
struct reach {
  size_t low, high;
};

static bool selected(const struct selection *w, uint32_t part, uint32_t group, int back)
{
  return part == w->part && (w->group == UM_GEOMETRY_NONE || group == w->group) &&
         (w->side < 0 || back == w->side);
}

static void put(double *area, struct reach *reach, uint32_t node, double a)
{
  area[node] += a;
  if (node < reach->low) reach->low = node;
  if (node >= reach->high) reach->high = (size_t)node + 1;
}

/* A facet has rows of nodes at its corners, a lump one for all of them. */
static void put_core(const struct um_thermal_builder *b, size_t facet, double *area,
                     struct reach *reach)
{
  size_t n = um_thermal_core_nodes(b, b->mesh->facet_group[facet]);
  if (b->part[b->mesh->facet_part[facet]]->kind != UM_THERMAL_LUMPED) n *= 3;
  for (uint32_t k = 0; k < n; k++)
    put(area, reach, b->core[facet] + k, b->mesh->area[facet] / (double)n);
}

/* Area [m^2] on every node; returns the sum. */
static double accumulate(const struct um_thermal_builder *b, const struct selection *w,
                         double *area, struct reach *reach)
{
  double sum = 0.0;
  for (size_t s = w->from; s < w->to; s++) {
    const struct um_geometry_surface *g = &b->mesh->surface[s];
    if (!selected(w, g->part, g->group, g->back)) continue;
    if (w->core) {
      if (b->core[g->facet] == UM_THERMAL_SPACE || g->back != 0) continue;
      put_core(b, g->facet, area, reach);
    } else if (w->sheets) {
      size_t n = b->group[g->group]->mli == NULL ? 0 : b->group[g->group]->mli->sheets;
      if (g->back != 0 || n == 0) continue;
      for (uint32_t k = 0; k < n; k++)
        put(area, reach, b->sheet[g->facet] + k, b->mesh->area[g->facet] / (double)n);
    } else if (w->inside) {
      if (!um_thermal_builder_radiates_inside(b, g->facet) ||
          !um_thermal_builder_two_layers(b, g->facet))
        continue;
      for (int c = 0; c < 3; c++)
        put(area, reach, b->back[g->facet][c], b->mesh->area[g->facet] / 3.0);
    } else if (w->wall) {
      if (g->back != 0 || b->skin[g->facet] == UM_THERMAL_SPACE ||
          b->front[g->facet][0] == UM_THERMAL_SPACE)
        continue;
      for (int c = 0; c < 3; c++)
        put(area, reach, b->front[g->facet][c], b->mesh->area[g->facet] / 3.0);
    } else {
      const struct um_thermal_surface *at = um_thermal_network_surface(b->network, (uint32_t)s);
      for (int c = 0; c < 3; c++)
        if (at->node[c] != UM_THERMAL_SPACE)
          put(area, reach, at->node[c], at->weight[c] * at->area);
    }
    sum += b->mesh->area[g->facet];
  }
  return sum;
}

static enum um_status place_new(struct um_context *context, struct um_thermal_body *body,
                                enum um_thermal_place_kind kind, size_t nnode,
                                struct um_thermal_place **out)
{
  UM_TRY(um_core_reallocate(context, body->nplace + 1, sizeof *body->place, &body->place));
  struct um_thermal_place *p = &body->place[body->nplace++];
  *p = (struct um_thermal_place){.kind = kind};
  UM_TRY(um_core_allocate(context, nnode, sizeof *p->node, &p->node));
  UM_TRY(um_core_allocate(context, nnode, sizeof *p->weight, &p->weight));
  p->nnode = nnode;
  *out = p;
  return UM_OK;
}

/* A place of that name unless nothing is selected. area: zeroed scratch [nnode], left zeroed. */
static enum um_status place_add(const struct um_thermal_builder *b, struct um_thermal_body *body,
                                const struct selection *w, double *area, const char *group,
                                const char *suffix)
{
  enum um_thermal_place_kind whole = w->wall       ? UM_PLACE_WALL
                                     : w->side < 0 ? UM_PLACE_PART
                                                   : UM_PLACE_SIDE;
  enum um_thermal_place_kind kind = group == NULL ? whole
                                    : w->wall     ? UM_PLACE_GROUP_WALL
                                                  : UM_PLACE_GROUP;
  UM_TRY(um_core_stop_check(b->context, "places were listed"));
  struct reach reach = {um_thermal_network_nodes(b->network), 0};
  double sum = accumulate(b, w, area, &reach);
  size_t n = 0;
  for (size_t i = reach.low; i < reach.high; i++)
    if (area[i] > 0.0) n++;
  if (n == 0) return UM_OK;
  struct um_thermal_place *place;
  UM_TRY(place_new(b->context, body, kind, n, &place));
  place->area = sum;
  n = 0;
  for (size_t i = reach.low; i < reach.high; i++) {
    if (area[i] > 0.0) {
      place->node[n] = (uint32_t)i;
      place->weight[n++] = area[i] / sum;
    }
    area[i] = 0.0;
  }
  const char *part = um_thermal_builder_part_name(b, w->part);
  return um_core_asprintf(b->context, &place->name, "%s%s%s%s", part, group == NULL ? "" : ".",
                          group == NULL ? "" : group, suffix);
}

static bool part_has_back(const struct um_thermal_builder *b, uint32_t part)
{
  for (size_t g = 0; g < b->ngroup; g++) {
    const struct um_geometry_group *group = um_geometry_group(b->geometry, g);
    if (group->part == part && group->back_material != UM_GEOMETRY_NONE) return true;
  }
  return false;
}

/* Nodes of an interior with their shares of it; area: zeroed scratch [nnode], left zeroed. */
static enum um_status interior_nodes(const struct um_thermal_builder *b,
                                     struct um_thermal_body *body, uint32_t node, double *area,
                                     struct um_thermal_place **out)
{
  size_t nnode = um_thermal_network_nodes(b->network), n = 0;
  um_thermal_interior_shares(b, node, area);
  for (size_t i = 0; i < nnode; i++) n += area[i] > 0.0;
  UM_TRY(place_new(b->context, body, UM_PLACE_INTERIOR, n, out));
  n = 0;
  for (size_t i = 0; i < nnode; i++) {
    if (area[i] > 0.0) {
      (*out)->node[n] = (uint32_t)i;
      (*out)->weight[n++] = area[i];
    }
    area[i] = 0.0;
  }
  return UM_OK;
}

static enum um_status places_of_interiors(const struct um_thermal_builder *b,
                                          struct um_thermal_body *body, uint32_t part, double *area)
{
  for (size_t i = 0; i < b->part[part]->ninterior; i++) {
    struct um_thermal_place *place;
    uint32_t first = um_thermal_builder_interiors(b, part)[i];
    if (um_thermal_filled_find(b, first) != NULL) {
      UM_TRY(interior_nodes(b, body, first, area, &place));
    } else {
      uint32_t node[2];
      double share[2];
      size_t n = um_thermal_interior_nodes(b, part, i, node, share);
      UM_TRY(place_new(b->context, body, UM_PLACE_INTERIOR, n, &place));
      memcpy(place->node, node, n * sizeof *node);
      memcpy(place->weight, share, n * sizeof *share);
    }
    UM_TRY(um_core_asprintf(b->context, &place->name, "%s.%s",
                            um_thermal_builder_part_name(b, part),
                            b->part[part]->interior[i].name));
  }
  return UM_OK;
}

static enum um_status places_of_part(const struct um_thermal_builder *b,
                                     struct um_thermal_body *body, uint32_t part, size_t from,
                                     size_t to, double *area)
{
  struct selection w = {
      .part = part, .group = UM_GEOMETRY_NONE, .side = -1, .from = from, .to = to};
  UM_TRY(place_add(b, body, &w, area, NULL, ""));
  if (part_has_back(b, part)) {
    w.side = 0;
    UM_TRY(place_add(b, body, &w, area, NULL, ".front"));
    w.side = 1;
    UM_TRY(place_add(b, body, &w, area, NULL, ".back"));
  }
  w.side = -1;
  w.wall = true;
  UM_TRY(place_add(b, body, &w, area, NULL, ".wall"));
  w.inside = true;
  UM_TRY(place_add(b, body, &w, area, NULL, ".inside"));
  w.sheets = true;
  UM_TRY(place_add(b, body, &w, area, NULL, ".sheets"));
  w.core = true;
  UM_TRY(place_add(b, body, &w, area, NULL, ".core"));
  for (uint32_t g = 0; g < b->ngroup; g++) {
    const struct um_geometry_group *group = um_geometry_group(b->geometry, g);
    if (group->part != part) continue;
    w = (struct selection){.part = part, .group = g, .side = 0, .from = from, .to = to};
    UM_TRY(place_add(b, body, &w, area, group->name, ""));
    w.side = 1;
    UM_TRY(place_add(b, body, &w, area, group->name, ".back"));
    w.side = -1;
    w.wall = true;
    UM_TRY(place_add(b, body, &w, area, group->name, ".wall"));
    w.inside = true;
    UM_TRY(place_add(b, body, &w, area, group->name, ".inside"));
    w.sheets = true;
    UM_TRY(place_add(b, body, &w, area, group->name, ".sheets"));
    w.core = true;
    UM_TRY(place_add(b, body, &w, area, group->name, ".core"));
  }
  return places_of_interiors(b, body, part, area);
}

enum um_status um_thermal_places_build(struct um_thermal_builder *b, struct um_thermal_body *body)
{
  double *area = NULL;
  UM_TRY(um_core_allocate(b->context, um_thermal_network_nodes(b->network), sizeof *area, &area));
  enum um_status status = UM_OK;
  size_t from = 0;
  for (uint32_t p = 0; p < b->npart && status == UM_OK; p++) {
    size_t to = from;
    while (to < b->mesh->nsurface && b->mesh->surface[to].part == p) to++;
    status = places_of_part(b, body, p, from, to, area);
    from = to;
  }
  um_core_free(b->context, area);
  return status;
}
