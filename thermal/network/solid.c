/* Solid parts by linear tetrahedra (Lewis, Nithiarasu & Seetharamu 2004, ch. 3):
 *
 *   rho c dT/dt = div(k grad T),  K_ij = k V grad(N_i) . grad(N_j),  C_i = rho c V / 4 (lumped)
 *
 * The surface keeps its facets, so loads and emission lie on the surface vertices as on a shell.
 * A linear field is reproduced exactly (test thermal/network/solid). Heat made inside is a volume
 * source, spread by volume: node i takes V_i / V of it. */
#include "thermal/network/builder_impl.h"
#include "thermal/network/tetgen.h"

#include <string.h>

double um_thermal_solid_element(const struct um_vec3 corner[4], double k, double out[6])
{
  static const int edge[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  struct um_vec3 a = um_vec3_sub(corner[1], corner[0]);
  struct um_vec3 b = um_vec3_sub(corner[2], corner[0]);
  struct um_vec3 c = um_vec3_sub(corner[3], corner[0]);
  struct um_vec3 g[4]; /* 6 V grad(N_i) */
  g[1] = um_vec3_cross(b, c);
  g[2] = um_vec3_cross(c, a);
  g[3] = um_vec3_cross(a, b);
  g[0] = um_vec3_scale(um_vec3_add(um_vec3_add(g[1], g[2]), g[3]), -1.0);
  double volume = um_vec3_dot(a, g[1]) / 6.0;
  /* -K_ij = -k (6 V grad N_i) . (6 V grad N_j) / (36 V) */
  for (int e = 0; e < 6; e++)
    out[e] = -k * um_vec3_dot(g[edge[e][0]], g[edge[e][1]]) / (36.0 * volume);
  return volume;
}

struct surface {
  size_t nvertex, nfacet;
  uint32_t *local;        /* [mesh nvertex] */
  struct um_vec3 *vertex; /* [nvertex] */
  uint32_t (*facet)[3];   /* [nfacet] local indices */
  double longest_edge;    /* [m] */
};

/* The part's own closed surface with vertices counted from 0. */
static enum um_status gather(const struct um_thermal_builder *b, size_t part, struct surface *s)
{
  const struct um_geometry_mesh *mesh = b->mesh;
  *s = (struct surface){0};
  UM_TRY(um_core_allocate(b->context, mesh->nvertex, sizeof *s->local, &s->local));
  UM_TRY(um_core_allocate(b->context, mesh->nvertex, sizeof *s->vertex, &s->vertex));
  UM_TRY(um_core_allocate(b->context, mesh->nfacet, sizeof *s->facet, &s->facet));
  for (size_t v = 0; v < mesh->nvertex; v++) s->local[v] = UM_GEOMETRY_NONE;
  for (size_t f = 0; f < mesh->nfacet; f++) {
    if (mesh->facet_part[f] != part) continue;
    for (int c = 0; c < 3; c++) {
      uint32_t v = mesh->corner[f][c];
      if (s->local[v] == UM_GEOMETRY_NONE) {
        s->local[v] = (uint32_t)s->nvertex;
        s->vertex[s->nvertex++] = b->pose->vertex[v];
      }
      s->facet[s->nfacet][c] = s->local[v];
      struct um_vec3 edge =
          um_vec3_sub(b->pose->vertex[mesh->corner[f][(c + 1) % 3]], b->pose->vertex[v]);
      s->longest_edge = fmax(s->longest_edge, um_vec3_norm(edge));
    }
    s->nfacet++;
  }
  return UM_OK;
}

static void surface_free(struct um_context *context, struct surface *s)
{
  UM_FREE(context, s->local, s->vertex, s->facet);
}

/* The volume of every vertex: a quarter of that of its tetrahedra [m^3]; returns their sum. */
static double vertex_volumes(const struct um_thermal_tetrahedra *t, double *volume)
{
  double k[6], sum = 0.0;
  for (size_t e = 0; e < t->ntetrahedron; e++) {
    const uint32_t *v = t->corner[e];
    const struct um_vec3 corner[4] = {t->vertex[v[0]], t->vertex[v[1]], t->vertex[v[2]],
                                      t->vertex[v[3]]};
    double all = um_thermal_solid_element(corner, 1.0, k);
    for (int c = 0; c < 4; c++) volume[v[c]] += all / 4.0;
    sum += all;
  }
  return sum;
}

static enum um_status add_stiffness(struct um_thermal_builder *b,
                                    const struct um_thermal_solid *solid, double conductivity,
                                    const struct um_thermal_bulk_index *law)
{
  static const int edge[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  const struct um_thermal_tetrahedra *t = solid->mesh;
  double k[6];
  for (size_t e = 0; e < t->ntetrahedron; e++) {
    const uint32_t *v = t->corner[e];
    const struct um_vec3 corner[4] = {t->vertex[v[0]], t->vertex[v[1]], t->vertex[v[2]],
                                      t->vertex[v[3]]};
    um_thermal_solid_element(corner, conductivity, k);
    for (int i = 0; i < 6; i++)
      UM_TRY(um_thermal_bulk_conductor(b, law, solid->node[v[edge[i][0]]],
                                       solid->node[v[edge[i][1]]], k[i]));
  }
  return UM_OK;
}

/* Nodes of the vertices with their capacities, shares of the volume into share[nvertex]. */
static enum um_status add_nodes(struct um_thermal_builder *b, struct um_thermal_solid *solid,
                                const struct um_thermal_solid_matter *matter, double start,
                                const struct um_thermal_bulk_index *law, double *share)
{
  size_t n = solid->mesh->nvertex;
  double volume = vertex_volumes(solid->mesh, share);
  double density = isnan(matter->capacity) ? matter->capacity_density : matter->capacity / volume;
  for (size_t v = 0; v < n; v++) {
    UM_TRY(um_thermal_builder_node(b, NULL, density * share[v], start, 0.0, &solid->node[v]));
    UM_TRY(um_thermal_bulk_capacity(b, law, solid->node[v], density * share[v]));
    share[v] /= volume;
    um_thermal_network_power_add(b->network, solid->node[v], share[v] * matter->power);
  }
  return UM_OK;
}

/* Tetrahedra of a part's surface: those of a body at hand, where they fill the same, or TetGen's.
 */
static enum um_status fill(const struct um_thermal_builder *b, size_t part, const struct surface *s,
                           double size, struct um_thermal_tetrahedra **out)
{
  const struct um_thermal_body *like = b->part[part]->like;
  const uint32_t(*facet)[3] = (const uint32_t(*)[3])s->facet;
  for (size_t i = 0; like != NULL && i < like->nsolid; i++)
    if (um_thermal_tetrahedra_fill(like->solid[i].mesh, s->vertex, s->nvertex, facet, s->nfacet,
                                   size))
      return um_thermal_tetrahedra_copy(b->context, like->solid[i].mesh, out);
  return um_thermal_tetgen_fill(b->context, um_thermal_builder_part_name(b, part), s->vertex,
                                s->nvertex, facet, s->nfacet, size, out);
}

enum um_status um_thermal_solid_fill(struct um_thermal_builder *b, size_t part,
                                     const struct um_thermal_solid_matter *matter,
                                     uint32_t (*corner)[3])
{
  static const struct um_thermal_bulk_law constant;
  struct surface s = {0};
  struct um_thermal_bulk_index law;
  double *share = NULL;
  enum um_status status;
  UM_TRY(um_thermal_bulk_laws(b, matter->law == NULL ? &constant : matter->law, &law));
  UM_TRY(um_core_reallocate(b->context, b->nsolid + 1, sizeof *b->solid, &b->solid));
  struct um_thermal_solid *solid = &b->solid[b->nsolid++];
  *solid = (struct um_thermal_solid){.part = (uint32_t)part};
  UM_CHECK(gather(b, part, &s));
  double size = matter->tetrahedron_size > 0.0 ? matter->tetrahedron_size : s.longest_edge;
  UM_CHECK(fill(b, part, &s, size, &solid->mesh));
  UM_CHECK(um_core_allocate(b->context, solid->mesh->nvertex, sizeof *share, &share));
  UM_CHECK(um_core_allocate(b->context, solid->mesh->nvertex, sizeof *solid->node, &solid->node));
  UM_CHECK(add_nodes(b, solid, matter, b->part[part]->start_temperature, &law, share));
  UM_CHECK(add_stiffness(b, solid, matter->conductivity, &law));
  if (matter->history != NULL) {
    const struct um_thermal_source source = {.node = solid->node,
                                             .weight = share,
                                             .nnode = solid->mesh->nvertex,
                                             .t = matter->history->t,
                                             .power = matter->history->power,
                                             .nrow = matter->history->nrow};
    UM_CHECK(um_thermal_network_source_add(b->network, &source));
  }
  for (size_t f = 0; f < b->mesh->nfacet; f++)
    for (int c = 0; c < 3 && b->mesh->facet_part[f] == part; c++)
      corner[f][c] = solid->node[s.local[b->mesh->corner[f][c]]];
done:
  um_core_free(b->context, share);
  surface_free(b->context, &s);
  return status;
}

enum um_status um_thermal_solid_assemble(struct um_thermal_builder *b, size_t part)
{
  const struct um_thermal_part_spec *spec = b->part[part];
  const struct um_thermal_solid_matter matter = {.capacity = NAN,
                                                 .capacity_density =
                                                     spec->density * spec->specific_heat,
                                                 .conductivity = spec->conductivity,
                                                 .tetrahedron_size = spec->tetrahedron_size,
                                                 .power = spec->volume_power,
                                                 .history = spec->volume_history,
                                                 .law = &spec->law};
  UM_TRY(um_thermal_solid_fill(b, part, &matter, b->front));
  for (size_t f = 0; f < b->mesh->nfacet; f++)
    if (b->mesh->facet_part[f] == part) memcpy(b->back[f], b->front[f], sizeof b->back[f]);
  return UM_OK;
}

enum um_status um_thermal_solid_interior(struct um_thermal_builder *b, size_t part,
                                         const struct um_thermal_interior_spec *spec,
                                         uint32_t *first)
{
  const struct um_thermal_solid_matter matter = {.capacity = spec->capacity,
                                                 .conductivity = spec->conductivity,
                                                 .tetrahedron_size = spec->tetrahedron_size,
                                                 .power = spec->power,
                                                 .history = spec->history};
  UM_TRY(um_core_reallocate(b->context, b->nfilled + 1, sizeof *b->filled, &b->filled));
  struct um_thermal_filled *filled = &b->filled[b->nfilled++];
  *filled = (struct um_thermal_filled){.solid = b->nsolid};
  UM_TRY(um_core_allocate(b->context, b->mesh->nfacet, sizeof *filled->corner, &filled->corner));
  UM_TRY(um_thermal_solid_fill(b, part, &matter, filled->corner));
  *first = filled->first = b->solid[filled->solid].node[0];
  return UM_OK;
}

const struct um_thermal_filled *um_thermal_filled_find(const struct um_thermal_builder *b,
                                                       uint32_t node)
{
  for (size_t i = 0; i < b->nfilled; i++)
    if (b->filled[i].first == node) return &b->filled[i];
  return NULL;
}

uint32_t um_thermal_interior_met(const struct um_thermal_builder *b, uint32_t node, size_t facet,
                                 int c)
{
  const struct um_thermal_filled *filled = um_thermal_filled_find(b, node);
  return filled == NULL ? node : filled->corner[facet][c];
}

void um_thermal_interior_shares(const struct um_thermal_builder *b, uint32_t node, double *out)
{
  const struct um_thermal_filled *filled = um_thermal_filled_find(b, node);
  double all = 0.0;
  if (filled == NULL) {
    out[node] += 1.0;
    return;
  }
  const struct um_thermal_solid *solid = &b->solid[filled->solid];
  for (size_t v = 0; v < solid->mesh->nvertex; v++)
    all += um_thermal_network_capacity(b->network, solid->node[v]);
  for (size_t v = 0; v < solid->mesh->nvertex; v++)
    out[solid->node[v]] += um_thermal_network_capacity(b->network, solid->node[v]) / all;
}
