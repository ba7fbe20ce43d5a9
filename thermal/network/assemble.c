/* Assembly of the heat balance of a satellite from its parts: walls (shell.c, solid.c, lump.c),
 * interiors (interior.c), blankets (mli.c), heat made inside (heater.c), radiating surfaces,
 * contacts (contact.c), places (place.c).
 *
 * The inner side of the walls of a closed body radiates where its part says so; else heat crosses a
 * body only through conduction, its interiors and contacts. */
#include "geometry/inside.h"
#include "thermal/network/builder_impl.h"
#include "thermal/network/tetgen.h"

/* The pose in which parts touch: FIXED joints at their angle, scheduled ones at their
 * first, Sun-following joints at 0. A joint
 * whose angle is the same for three Sun directions does not follow the Sun. */
static enum um_status rest_pose(struct um_thermal_builder *b)
{
  size_t n = um_geometry_joint_count(b->geometry);
  if (n == 0) return um_geometry_pose_create(b->context, b->geometry, NULL, &b->pose);
  double *angles = NULL, *other = NULL;
  enum um_status status;
  UM_CHECK(um_core_allocate(b->context, n, sizeof *angles, &angles));
  UM_CHECK(um_core_allocate(b->context, 2 * n, sizeof *other, &other));
  um_geometry_joint_angles(b->geometry, um_vec3(1, 0, 0), -INFINITY, angles);
  um_geometry_joint_angles(b->geometry, um_vec3(0, 1, 0), -INFINITY, other);
  um_geometry_joint_angles(b->geometry, um_vec3(0, 0, 1), -INFINITY, other + n);
  for (size_t j = 0; j < n; j++)
    if (!(angles[j] == other[j] && angles[j] == other[n + j])) angles[j] = 0.0;
  UM_CHECK(um_geometry_pose_create(b->context, b->geometry, angles, &b->pose));
done:
  UM_FREE(b->context, angles, other);
  return status;
}

static void fill_none(uint32_t *index, size_t n)
{
  for (size_t i = 0; i < n; i++) index[i] = UM_THERMAL_SPACE;
}

static enum um_status builder_allocate(struct um_thermal_builder *b)
{
  struct um_context *context = b->context;
  size_t nfacet = b->mesh->nfacet, nvertex = b->mesh->nvertex;
  UM_TRY(um_core_allocate(context, b->npart, sizeof *b->part, &b->part));
  UM_TRY(um_core_allocate(context, b->ngroup, sizeof *b->group, &b->group));
  UM_TRY(um_core_allocate(context, b->ngroup, sizeof *b->group_area, &b->group_area));
  UM_TRY(um_core_allocate(context, b->ngroup, sizeof *b->group_law, &b->group_law));
  UM_TRY(um_core_allocate(context, b->ngroup, sizeof *b->group_front, &b->group_front));
  UM_TRY(um_core_allocate(context, b->ngroup, sizeof *b->group_back, &b->group_back));
  UM_TRY(um_core_allocate(context, nfacet, sizeof *b->front, &b->front));
  UM_TRY(um_core_allocate(context, nfacet, sizeof *b->back, &b->back));
  UM_TRY(um_core_allocate(context, nfacet, sizeof *b->skin, &b->skin));
  UM_TRY(um_core_allocate(context, nfacet, sizeof *b->sheet, &b->sheet));
  UM_TRY(um_core_allocate(context, nfacet, sizeof *b->core, &b->core));
  for (int layer = 0; layer < 2; layer++) {
    UM_TRY(um_core_allocate(context, nvertex, sizeof **b->vertex_node, &b->vertex_node[layer]));
    UM_TRY(um_core_allocate(context, nvertex, sizeof **b->vertex_capacity,
                            &b->vertex_capacity[layer]));
    fill_none(b->vertex_node[layer], nvertex);
  }
  fill_none(b->group_front, b->ngroup);
  fill_none(b->group_back, b->ngroup);
  fill_none(b->skin, nfacet);
  fill_none(b->sheet, nfacet);
  fill_none(b->core, nfacet);
  for (size_t f = 0; f < nfacet; f++) {
    fill_none(b->front[f], 3);
    fill_none(b->back[f], 3);
    b->group_area[b->mesh->facet_group[f]] += b->mesh->area[f];
  }
  return UM_OK;
}

static void builder_free(struct um_thermal_builder *b)
{
  struct um_context *context = b->context;
  UM_FREE(context, b->part, b->group, b->group_area, b->group_law, b->group_front, b->group_back,
          b->front, b->back, b->skin, b->sheet, b->core, b->first_interior, b->interior, b->behind);
  for (int layer = 0; layer < 2; layer++) {
    UM_FREE(context, b->vertex_node[layer], b->vertex_capacity[layer]);
  }
  um_geometry_pose_destroy(context, &b->pose);
  um_thermal_solids_destroy(context, &b->solid, b->nsolid);
  for (size_t i = 0; i < b->nfilled; i++) um_core_free(context, b->filled[i].corner);
  um_core_free(context, b->filled);
}

/* On one node, or on the three corners of a facet. */
static void place_on(const uint32_t wall[3], struct um_thermal_surface *at)
{
  if (wall[0] == wall[1] && wall[0] == wall[2]) {
    at->node[0] = wall[0];
    at->weight[0] = 1.0;
    return;
  }
  for (int c = 0; c < 3; c++) {
    at->node[c] = wall[c];
    at->weight[c] = 1.0 / 3.0;
  }
}

/* Inner faces of the parts that radiate inside, on the inner layer of their walls. */
static enum um_status attach_inside(struct um_thermal_builder *b)
{
  for (size_t f = 0; f < b->mesh->nfacet; f++) {
    if (!um_thermal_builder_radiates_inside(b, f)) continue;
    struct um_thermal_surface at = {.node = {UM_THERMAL_SPACE, UM_THERMAL_SPACE, UM_THERMAL_SPACE},
                                    .area = b->mesh->area[f],
                                    .emittance =
                                        b->group[b->mesh->facet_group[f]]->inside_emittance,
                                    .blocked = 1.0,
                                    .inside = true};
    place_on(b->back[f], &at);
    UM_TRY(
        um_thermal_network_surface_attach(b->network, um_geometry_inner_surface(b->mesh, f), &at));
  }
  return UM_OK;
}

/* Where each radiating side sits: on its blanket, or on its wall. */
static enum um_status attach_surfaces(struct um_thermal_builder *b)
{
  for (size_t s = 0; s < b->mesh->nsurface; s++) {
    const struct um_geometry_surface *surface = &b->mesh->surface[s];
    const struct um_thermal_group_spec *g = b->group[surface->group];
    bool back = surface->back != 0;
    struct um_thermal_surface at = {.node = {UM_THERMAL_SPACE, UM_THERMAL_SPACE, UM_THERMAL_SPACE},
                                    .area = b->mesh->area[surface->facet],
                                    .absorptance =
                                        back ? g->absorptance_back : g->absorptance_front,
                                    .emittance = back ? g->emittance_back : g->emittance_front,
                                    .extraction = back ? g->extraction_back : g->extraction_front,
                                    .law = back ? g->law_back : g->law_front};
    const uint32_t *wall = back ? b->back[surface->facet] : b->front[surface->facet];
    uint32_t skin = back ? UM_THERMAL_SPACE : b->skin[surface->facet];
    place_on(skin != UM_THERMAL_SPACE ? (uint32_t[3]){skin, skin, skin} : wall, &at);
    if (skin == UM_THERMAL_SPACE) at.in_plane = um_thermal_shell_in_plane(b, surface->facet, back);
    UM_TRY(um_thermal_network_surface_attach(b->network, (uint32_t)s, &at));
  }
  return UM_OK;
}

static enum um_status assemble_part(struct um_thermal_builder *b, size_t part)
{
  UM_TRY(um_thermal_network_section_begin(b->network, um_thermal_builder_part_name(b, part)));
  switch (b->part[part]->kind) {
  case UM_THERMAL_SHELL:
    UM_TRY(um_thermal_shell_assemble(b, part));
    break;
  case UM_THERMAL_SOLID:
    UM_TRY(um_thermal_solid_assemble(b, part));
    break;
  case UM_THERMAL_LUMPED:
    UM_TRY(um_thermal_lump_assemble(b, part));
    break;
  case UM_THERMAL_NODES:
    UM_TRY(um_thermal_node_model_assemble(b, part));
    break;
  }
  UM_TRY(um_thermal_interiors_add(b, part));
  UM_TRY(um_thermal_node_model_links(b, part));
  UM_TRY(um_thermal_mli_assemble(b, part));
  UM_TRY(um_thermal_interiors_couple(b, part));
  UM_TRY(um_thermal_heat_pipes_assemble(b, part));
  return um_thermal_heat_assemble(b, part);
}

static enum um_status assemble(struct um_thermal_builder *b, struct um_thermal_body *body,
                               const struct um_thermal_part_spec *parts, size_t npart,
                               const struct um_thermal_contact *contacts, size_t ncontact)
{
  UM_TRY(builder_allocate(b));
  UM_TRY(um_thermal_body_check(b, parts, npart));
  UM_TRY(um_thermal_interiors_allocate(b));
  UM_TRY(rest_pose(b));
  UM_TRY(um_thermal_network_create(b->context, &body->network));
  b->network = body->network;
  for (uint32_t g = 0; g < b->ngroup; g++)
    UM_TRY(um_thermal_bulk_laws(b, &um_thermal_builder_shell(b, g)->law, &b->group_law[g]));
  for (size_t p = 0; p < b->npart; p++) {
    UM_TRY(um_core_stop_check(b->context, "the heat network was built"));
    UM_TRY(assemble_part(b, p));
  }
  UM_TRY(attach_surfaces(b));
  UM_TRY(attach_inside(b));
  for (size_t c = 0; c < ncontact; c++) UM_TRY(um_thermal_contact_assemble(b, &contacts[c]));
  UM_TRY(um_thermal_places_build(b, body));
  for (size_t i = 0; i < b->nsolid; i++) body->ntetrahedron += b->solid[i].mesh->ntetrahedron;
  body->solid = b->solid;
  body->nsolid = b->nsolid;
  b->solid = NULL;
  return UM_OK;
}

enum um_status um_thermal_body_create(struct um_context *context,
                                      const struct um_geometry *geometry,
                                      const struct um_thermal_part_spec *parts, size_t npart,
                                      const struct um_thermal_contact *contacts, size_t ncontact,
                                      struct um_thermal_body **out)
{
  *out = NULL;
  struct um_thermal_body *body = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *body, &body));
  struct um_thermal_builder b = {.context = context,
                                 .geometry = geometry,
                                 .mesh = um_geometry_mesh(geometry),
                                 .npart = um_geometry_part_count(geometry),
                                 .ngroup = um_geometry_group_count(geometry)};
  enum um_status status = assemble(&b, body, parts, npart, contacts, ncontact);
  builder_free(&b);
  if (status != UM_OK)
    um_thermal_body_destroy(context, &body);
  else
    *out = body;
  return status;
}
