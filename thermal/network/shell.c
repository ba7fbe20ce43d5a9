/* Thin walls by linear triangles on the welded vertices of a part, one temperature per vertex and
 * layer (Lewis, Nithiarasu & Seetharamu 2004, ch. 3):
 *
 *   rho c t dT/dt = div_s(k t grad_s T) + loads + U (T_other - T)
 *
 * The stiffness of a triangle couples the corners i, j by kt cot(theta_k) / 2, theta_k the angle
 * opposite the edge ij; capacity, loads, emission and the conductance through the wall are lumped,
 * a third of the facet to each corner (a consistent mass would violate the maximum principle at
 * short steps). Negative conductances at obtuse angles are part of the method. A linear field is
 * reproduced exactly (test thermal/network/shell). */
#include "thermal/network/builder_impl.h"

void um_thermal_shell_element(const struct um_vec3 corner[3], double kt, double out[3])
{
  for (int e = 0; e < 3; e++) {
    struct um_vec3 a = um_vec3_sub(corner[(e + 1) % 3], corner[e]);
    struct um_vec3 b = um_vec3_sub(corner[(e + 2) % 3], corner[e]);
    /* cot(theta) = a . b / |a x b| */
    out[e] = 0.5 * kt * um_vec3_dot(a, b) / um_vec3_norm(um_vec3_cross(a, b));
  }
}

/* Share of the outer layer in capacity and in-plane conductance. */
static double front_share(const struct um_thermal_builder *b, size_t facet)
{
  if (!um_thermal_builder_two_layers(b, facet)) return 1.0;
  return um_thermal_builder_shell(b, b->mesh->facet_group[facet])->front_share;
}

double um_thermal_shell_in_plane(const struct um_thermal_builder *b, size_t facet, bool back)
{
  uint32_t group = b->mesh->facet_group[facet];
  double share = front_share(b, facet) / (1.0 - um_thermal_core_share(b, group));
  if (b->part[b->mesh->facet_part[facet]]->kind != UM_THERMAL_SHELL ||
      um_thermal_builder_wall_left_out(b, group))
    return 0.0;
  if (back && um_thermal_builder_two_layers(b, facet)) share = 1.0 - share;
  return share * um_thermal_builder_shell(b, group)->conductance;
}

/* Share of the inner layer in the capacity. */
static double back_share(const struct um_thermal_builder *b, size_t facet)
{
  return 1.0 - front_share(b, facet) - um_thermal_core_share(b, b->mesh->facet_group[facet]);
}

static bool has_wall(const struct um_thermal_builder *b, size_t facet, size_t part)
{
  return b->mesh->facet_part[facet] == part &&
         !um_thermal_builder_wall_left_out(b, b->mesh->facet_group[facet]);
}

/* Add the facet's capacity to its corners and mark the layers that it needs (node 0 = wanted). */
static void collect(struct um_thermal_builder *b, size_t facet)
{
  const struct um_thermal_shell *shell = um_thermal_builder_shell(b, b->mesh->facet_group[facet]);
  double share = front_share(b, facet);
  double third = shell->areal_heat_capacity * b->mesh->area[facet] / 3.0; /* [J/K] */
  int layers = um_thermal_builder_two_layers(b, facet) ? 2 : 1;
  for (int c = 0; c < 3; c++) {
    uint32_t v = b->mesh->corner[facet][c];
    for (int layer = 0; layer < layers; layer++) {
      b->vertex_node[layer][v] = 0;
      b->vertex_capacity[layer][v] += third * (layer == 0 ? share : back_share(b, facet));
    }
  }
}

static enum um_status make_nodes(struct um_thermal_builder *b, size_t part)
{
  double start = b->part[part]->start_temperature;
  for (size_t f = 0; f < b->mesh->nfacet; f++)
    if (has_wall(b, f, part)) collect(b, f);
  /* nodes in the order of facets, layers and corners */
  for (size_t f = 0; f < b->mesh->nfacet; f++) {
    if (!has_wall(b, f, part)) continue;
    for (int layer = 0; layer < 2; layer++)
      for (int c = 0; c < 3; c++) {
        uint32_t v = b->mesh->corner[f][c];
        if (b->vertex_node[layer][v] != 0) continue;
        uint32_t node;
        UM_TRY(um_thermal_builder_node(b, NULL, b->vertex_capacity[layer][v], start, 0.0, &node));
        b->vertex_node[layer][v] = node + 1; /* 1-based while building, so that 0 means wanted */
      }
  }
  for (size_t f = 0; f < b->mesh->nfacet; f++) {
    if (!has_wall(b, f, part)) continue;
    int back = um_thermal_builder_two_layers(b, f) ? 1 : 0;
    for (int c = 0; c < 3; c++) {
      uint32_t v = b->mesh->corner[f][c];
      b->front[f][c] = b->vertex_node[0][v] - 1;
      b->back[f][c] = b->vertex_node[back][v] - 1;
    }
  }
  return UM_OK;
}

/* The facet's capacity at its corners follows the law of its group. */
static enum um_status capacity_follow(struct um_thermal_builder *b, size_t facet)
{
  uint32_t group = b->mesh->facet_group[facet];
  double share = front_share(b, facet);
  double third = um_thermal_builder_shell(b, group)->areal_heat_capacity * b->mesh->area[facet] /
                 3.0; /* [J/K] */
  bool two = um_thermal_builder_two_layers(b, facet);
  for (int c = 0; c < 3; c++) {
    UM_TRY(um_thermal_bulk_capacity(b, &b->group_law[group], b->front[facet][c], third * share));
    if (two)
      UM_TRY(um_thermal_bulk_capacity(b, &b->group_law[group], b->back[facet][c],
                                      third * back_share(b, facet)));
  }
  return UM_OK;
}

static enum um_status conduct(struct um_thermal_builder *b, size_t facet)
{
  const struct um_thermal_shell *shell = um_thermal_builder_shell(b, b->mesh->facet_group[facet]);
  const uint32_t *v = b->mesh->corner[facet];
  struct um_vec3 corner[3] = {b->pose->vertex[v[0]], b->pose->vertex[v[1]], b->pose->vertex[v[2]]};
  double k[3], share = front_share(b, facet);
  share /= 1.0 - um_thermal_core_share(b, b->mesh->facet_group[facet]);
  um_thermal_shell_element(corner, shell->conductance, k);
  const struct um_thermal_bulk_index *law = &b->group_law[b->mesh->facet_group[facet]];
  bool two = um_thermal_builder_two_layers(b, facet);
  for (int e = 0; e < 3 && shell->conductance > 0.0; e++) {
    int i = (e + 1) % 3, j = (e + 2) % 3;
    UM_TRY(um_thermal_bulk_conductor(b, law, b->front[facet][i], b->front[facet][j], share * k[e]));
    if (two)
      UM_TRY(um_thermal_bulk_conductor(b, law, b->back[facet][i], b->back[facet][j],
                                       (1.0 - share) * k[e]));
  }
  /* through the wall: U A / 3 at each corner */
  for (int c = 0; c < 3 && two; c++)
    UM_TRY(um_thermal_core_join(b, b->mesh->facet_group[facet], NULL, b->front[facet][c],
                                b->back[facet][c], b->mesh->area[facet] / 3.0,
                                shell->through_conductance * b->mesh->area[facet] / 3.0,
                                c == 0 ? &b->core[facet] : NULL));
  return UM_OK;
}

enum um_status um_thermal_shell_assemble(struct um_thermal_builder *b, size_t part)
{
  UM_TRY(make_nodes(b, part));
  for (size_t f = 0; f < b->mesh->nfacet; f++)
    if (has_wall(b, f, part)) {
      UM_TRY(um_thermal_core_check(b, f));
      UM_TRY(capacity_follow(b, f));
      UM_TRY(conduct(b, f));
    }
  return UM_OK;
}
