/* Solid parts by linear tetrahedra (Lewis, Nithiarasu & Seetharamu 2004, ch. 3):
 *
 *   rho c dT/dt = div(k grad T),  K_ij = k V grad(N_i) . grad(N_j),  C_i = rho c V / 4 (lumped)
 *
 * The surface keeps its facets, so loads and emission lie on the surface vertices as on a shell.
 * A linear field is reproduced exactly (test thermal/solid). */
#include "thermal/bulk_law_impl.h"
#include "thermal/solid_impl.h"
#include "thermal/tetgen.h"

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
  um_core_free(context, s->local);
  um_core_free(context, s->vertex);
  um_core_free(context, s->facet);
}

/* Nodes with their lumped capacity, then the stiffness of every tetrahedron. */
static enum um_status add_tetrahedra(struct um_thermal_builder *b, size_t part,
                                     const struct um_thermal_tetrahedra *t, double *capacity,
                                     uint32_t *node)
{
  static const int edge[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  const struct um_thermal_part_spec *spec = b->part[part];
  double k[6];
  struct um_thermal_bulk_index law;
  UM_TRY(um_thermal_bulk_laws(b, &spec->law, &law));
  for (int pass = 0; pass < 2; pass++) {
    for (size_t e = 0; e < t->ntetrahedron; e++) {
      const uint32_t *v = t->corner[e];
      struct um_vec3 corner[4] = {t->vertex[v[0]], t->vertex[v[1]], t->vertex[v[2]],
                                  t->vertex[v[3]]};
      double volume = um_thermal_solid_element(corner, spec->conductivity, k);
      for (int c = 0; c < 4 && pass == 0; c++)
        capacity[v[c]] += spec->density * spec->specific_heat * volume / 4.0;
      for (int i = 0; i < 6 && pass == 1; i++)
        UM_TRY(um_thermal_bulk_conductor(b, &law, node[v[edge[i][0]]], node[v[edge[i][1]]], k[i]));
    }
    for (size_t v = 0; v < t->nvertex && pass == 0; v++) {
      UM_TRY(um_thermal_builder_node(b, NULL, capacity[v], spec->start_temperature, 0.0, &node[v]));
      UM_TRY(um_thermal_bulk_capacity(b, &law, node[v], capacity[v]));
    }
  }
  b->ntetrahedron += t->ntetrahedron;
  return UM_OK;
}

enum um_status um_thermal_solid_assemble(struct um_thermal_builder *b, size_t part)
{
  const struct um_thermal_part_spec *spec = b->part[part];
  struct surface s;
  struct um_thermal_tetrahedra *t = NULL;
  double *capacity = NULL;
  uint32_t *node = NULL;
  enum um_status status;
  UM_CHECK(gather(b, part, &s));
  double size = spec->tetrahedron_size > 0.0 ? spec->tetrahedron_size : s.longest_edge;
  UM_CHECK(um_thermal_tetgen_fill(b->context, um_thermal_builder_part_name(b, part), s.vertex,
                                  s.nvertex, (const uint32_t(*)[3])s.facet, s.nfacet, size, &t));
  UM_CHECK(um_core_allocate(b->context, t->nvertex, sizeof *capacity, &capacity));
  UM_CHECK(um_core_allocate(b->context, t->nvertex, sizeof *node, &node));
  UM_CHECK(add_tetrahedra(b, part, t, capacity, node));
  for (size_t f = 0; f < b->mesh->nfacet; f++) {
    if (b->mesh->facet_part[f] != part) continue;
    for (int c = 0; c < 3; c++)
      b->front[f][c] = b->back[f][c] = node[s.local[b->mesh->corner[f][c]]];
  }
  status = UM_OK;
done:
  um_core_free(b->context, capacity);
  um_core_free(b->context, node);
  um_thermal_tetrahedra_destroy(b->context, &t);
  surface_free(b->context, &s);
  return status;
}
