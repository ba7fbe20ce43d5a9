/* Contacts: a conductance G [W/K] between two places (Gilmore 2002, ch. 8), joined where they
 * touch.
 *
 * Every structural node of one place is paired with the nearest point on a facet of the other;
 * the pairs whose gap is within the smallest gap plus half a facet edge take part. So faces lying
 * on each other exchange all over, and a hinge or bracket acts on the edge next to it only. Each
 * direction of pairing carries G/2 in shares of area,
 *
 *   K(i, c) = G/2 A_i / sum(A) lambda_c,
 *
 * lambda_c the barycentric weights of the foot on the facet: linear, symmetric, conservative, sum
 * of all K exactly G. A lumped or interior node is one node wherever it is met; a place of an
 * interior is met everywhere, in shares of area, unless it is a solid, whose surface is met.
 * Structure is the wall under MLI, and the interior where the wall is left out: a bracket goes
 * through the blanket.
 *
 * A radiative contact carries sigma E (T_a^4 - T_b^4), E an exchange area [m^2]. It is shared in
 * the same way, but all of both places takes part, every node with the nearest point of the other.
 */
#include "base/core/sort.h"
#include "thermal/network/builder_impl.h"

#include <stdio.h>
#include <string.h>

#include "base/core/suggestions.h"

struct sample {
  uint32_t vertex, node;
  struct um_vec3 position; /* [m] */
  double area;             /* [m^2] */
  double gap;              /* [m] to the other place */
  uint32_t patch;          /* nearest one of the other place */
  double weight[3];        /* barycentric, of its foot there */
};
struct patch {
  struct um_vec3 corner[3], centre; /* [m] */
  double radius, area;              /* [m], [m^2] */
  uint32_t node[2][3];              /* of the layers that belong to the place */
  int layers;
};
struct side {
  const char *name;
  struct um_thermal_where at;
  struct sample *sample;
  size_t nsample;
  struct patch *patch;
  size_t npatch;
  double edge; /* typical facet edge [m] */
};

/* An interior that is one node is met everywhere. */
static bool is_node(const struct um_thermal_builder *b, const struct side *s)
{
  return s->at.interior != UM_THERMAL_SPACE && um_thermal_filled_find(b, s->at.interior) == NULL;
}

static bool resolve(const struct um_thermal_builder *b, struct side *s)
{
  for (uint32_t p = 0; p < b->npart; p++) {
    const char *part = um_thermal_builder_part_name(b, p);
    size_t n = strlen(part);
    s->at.part = p;
    if (strncmp(s->name, part, n) == 0 && um_thermal_where_find(b, s->name + n, &s->at))
      return true;
  }
  return false;
}

static void node_or_interior(const struct um_thermal_builder *b, size_t facet,
                             const uint32_t layer[3], uint32_t out[3])
{
  uint32_t inside = um_thermal_builder_wrapped(b, b->mesh->facet_group[facet]);
  for (int c = 0; c < 3; c++)
    out[c] = layer[c] != UM_THERMAL_SPACE ? layer[c] : um_thermal_interior_met(b, inside, facet, c);
}

static void patch_fill(const struct um_thermal_builder *b, size_t facet, const struct side *s,
                       struct patch *p)
{
  p->centre = um_vec3(0, 0, 0);
  p->area = b->mesh->area[facet];
  p->radius = 0.0;
  for (int c = 0; c < 3; c++) {
    p->corner[c] = b->pose->vertex[b->mesh->corner[facet][c]];
    p->centre = um_vec3_axpy(p->centre, 1.0 / 3.0, p->corner[c]);
  }
  for (int c = 0; c < 3; c++)
    p->radius = fmax(p->radius, um_vec3_norm(um_vec3_sub(p->corner[c], p->centre)));
  p->layers = 0;
  if (s->at.interior != UM_THERMAL_SPACE) { /* a solid inside, at its surface */
    for (int c = 0; c < 3; c++)
      p->node[0][c] = um_thermal_interior_met(b, s->at.interior, facet, c);
    p->layers = 1;
    return;
  }
  if (s->at.front || !um_thermal_builder_two_layers(b, facet))
    node_or_interior(b, facet, b->front[facet], p->node[p->layers++]);
  if (s->at.back && um_thermal_builder_two_layers(b, facet))
    node_or_interior(b, facet, b->back[facet], p->node[p->layers++]);
}

static int sample_order(const void *a, const void *b)
{
  const struct sample *x = a, *y = b;
  if (x->vertex != y->vertex) return x->vertex < y->vertex ? -1 : 1;
  return x->node < y->node ? -1 : x->node > y->node;
}

/* Facets and nodes of a side; corners of neighbouring facets that are one node are merged. */
static enum um_status collect(const struct um_thermal_builder *b, struct side *s)
{
  if (is_node(b, s)) return UM_OK;
  size_t n = 0;
  UM_TRY(um_core_allocate(b->context, b->mesh->nfacet, sizeof *s->patch, &s->patch));
  UM_TRY(um_core_allocate(b->context, 6 * b->mesh->nfacet, sizeof *s->sample, &s->sample));
  double area = 0.0;
  for (size_t f = 0; f < b->mesh->nfacet; f++) {
    if (b->mesh->facet_part[f] != s->at.part) continue;
    if (s->at.group != UM_GEOMETRY_NONE && b->mesh->facet_group[f] != s->at.group) continue;
    struct patch *p = &s->patch[s->npatch++];
    patch_fill(b, f, s, p);
    area += p->area;
    for (int layer = 0; layer < p->layers; layer++)
      for (int c = 0; c < 3; c++)
        s->sample[n++] = (struct sample){.vertex = b->mesh->corner[f][c],
                                         .node = p->node[layer][c],
                                         .position = p->corner[c],
                                         .area = p->area / 3.0};
  }
  if (s->npatch == 0) return UM_OK;
  s->edge = sqrt(2.0 * area / (double)s->npatch);
  UM_TRY(um_core_sort(b->context, s->sample, n, sizeof *s->sample, sample_order));
  for (size_t i = 0; i < n; i++) {
    if (s->nsample > 0 && sample_order(&s->sample[s->nsample - 1], &s->sample[i]) == 0)
      s->sample[s->nsample - 1].area += s->sample[i].area;
    else
      s->sample[s->nsample++] = s->sample[i];
  }
  return UM_OK;
}

/* Nearest point of the segment a + u (b - a), u in [0, 1]. */
static double segment_foot(struct um_vec3 p, struct um_vec3 a, struct um_vec3 b)
{
  struct um_vec3 d = um_vec3_sub(b, a);
  double u = um_vec3_dot(um_vec3_sub(p, a), d) / um_vec3_dot(d, d);
  return fmin(fmax(u, 0.0), 1.0);
}

/* Distance from p to a triangle; barycentric weights of the nearest point. */
static double triangle_distance(struct um_vec3 p, const struct um_vec3 v[3], double weight[3])
{
  struct um_vec3 n = um_vec3_cross(um_vec3_sub(v[1], v[0]), um_vec3_sub(v[2], v[0]));
  double nn = um_vec3_dot(n, n);
  bool inside = true;
  for (int c = 0; c < 3; c++) {
    struct um_vec3 a = um_vec3_sub(v[(c + 1) % 3], p), b = um_vec3_sub(v[(c + 2) % 3], p);
    weight[c] = um_vec3_dot(um_vec3_cross(a, b), n) / nn;
    inside = inside && weight[c] >= 0.0;
  }
  if (inside) return fabs(um_vec3_dot(um_vec3_sub(p, v[0]), n)) / sqrt(nn);
  double best = INFINITY;
  for (int e = 0; e < 3; e++) {
    int i = e, j = (e + 1) % 3;
    double u = segment_foot(p, v[i], v[j]);
    struct um_vec3 foot = um_vec3_axpy(v[i], u, um_vec3_sub(v[j], v[i]));
    double d = um_vec3_norm(um_vec3_sub(p, foot));
    if (!(d < best)) continue;
    best = d;
    weight[0] = weight[1] = weight[2] = 0.0;
    weight[i] = 1.0 - u;
    weight[j] = u;
  }
  return best;
}

/* The nearest foot of every sample of `from` on `to`; returns the smallest gap. */
static double find_feet(const struct um_context *context, struct side *from, const struct side *to)
{
  double smallest = INFINITY;
  for (size_t i = 0; i < from->nsample && !um_core_stopped(context); i++) {
    struct sample *s = &from->sample[i];
    s->gap = INFINITY;
    for (size_t p = 0; p < to->npatch; p++) {
      double reach = s->gap + to->patch[p].radius; /* a facet farther than that cannot win */
      struct um_vec3 d = um_vec3_sub(s->position, to->patch[p].centre);
      if (um_vec3_dot(d, d) > reach * reach) continue;
      double weight[3], gap = triangle_distance(s->position, to->patch[p].corner, weight);
      if (!(gap < s->gap)) continue;
      s->gap = gap;
      s->patch = (uint32_t)p;
      memcpy(s->weight, weight, sizeof weight);
    }
    smallest = fmin(smallest, s->gap);
  }
  return smallest;
}

static double area_within(const struct side *s, double gap)
{
  double area = 0.0;
  for (size_t i = 0; i < s->nsample; i++)
    if (s->sample[i].gap <= gap) area += s->sample[i].area;
  return area;
}

/* What is shared among nodes, and how much has been. */
struct flow {
  bool radiates;
  double size, joined; /* [W/K], or [m^2] */
};

static enum um_status join(struct um_thermal_builder *b, uint32_t i, uint32_t j, double k,
                           struct flow *flow)
{
  if (i == j || !(k > 0.0)) return UM_OK;
  flow->joined += k;
  if (flow->radiates) return um_thermal_network_radiator_add(b->network, i, j, k);
  return um_thermal_network_conductor_add(b->network, i, j, k);
}

/* Spread `share` of the flow over the pairs of `from` within the gap. */
static enum um_status pair(struct um_thermal_builder *b, const struct side *from,
                           const struct side *to, double gap, double share, struct flow *flow)
{
  double area = area_within(from, gap);
  if (!(area > 0.0)) return UM_OK;
  for (size_t i = 0; i < from->nsample; i++) {
    const struct sample *s = &from->sample[i];
    if (!(s->gap <= gap)) continue;
    const struct patch *p = &to->patch[s->patch];
    double k = share * flow->size * s->area / area / p->layers;
    for (int layer = 0; layer < p->layers; layer++)
      for (int c = 0; c < 3; c++)
        UM_TRY(join(b, s->node, p->node[layer][c], k * s->weight[c], flow));
  }
  return UM_OK;
}

/* An interior is met everywhere on the other place. */
static enum um_status spread(struct um_thermal_builder *b, uint32_t node, const struct side *over,
                             struct flow *flow)
{
  if (is_node(b, over)) return join(b, node, over->at.interior, flow->size, flow);
  double area = 0.0;
  for (size_t i = 0; i < over->nsample; i++) area += over->sample[i].area;
  for (size_t i = 0; i < over->nsample; i++)
    UM_TRY(join(b, node, over->sample[i].node, flow->size * over->sample[i].area / area, flow));
  return UM_OK;
}

static enum um_status connect(struct um_thermal_builder *b, struct side *x, struct side *y,
                              struct flow *flow)
{
  if (is_node(b, x)) return spread(b, x->at.interior, y, flow);
  if (is_node(b, y)) return spread(b, y->at.interior, x, flow);
  double gap = fmin(find_feet(b->context, x, y), find_feet(b->context, y, x));
  UM_TRY(um_core_stop_check(b->context, "contacts were joined"));
  gap += flow->radiates ? INFINITY : 0.5 * fmin(x->edge, y->edge);
  bool both = area_within(x, gap) > 0.0 && area_within(y, gap) > 0.0;
  double each = both ? 0.5 : 1.0;
  UM_TRY(pair(b, x, y, gap, each, flow));
  return pair(b, y, x, gap, each, flow);
}

static enum um_status refuse_place(const struct um_thermal_builder *b,
                                   const struct um_thermal_contact *contact, const char *name)
{
  char part[64], hint[UM_CORE_WORDS_HINT];
  struct um_core_words_guess guess = {.written = part};
  snprintf(part, sizeof part, "%.*s", (int)strcspn(name, "."), name);
  for (uint32_t p = 0; p < b->npart; p++)
    if (strcmp(um_thermal_builder_part_name(b, p), part) != 0)
      um_core_words_consider(&guess, um_thermal_builder_part_name(b, p));
  return um_core_fail(b->context, UM_ERR_INPUT,
                      "contact %s - %s: there is no place '%s'%s; accepted: PART, PART.GROUP, "
                      "PART.front, PART.back, PART.INTERIOR",
                      contact->a, contact->b, name, um_core_words_hint(&guess, hint));
}

static enum um_status check_size(const struct um_thermal_builder *b,
                                 const struct um_thermal_contact *contact)
{
  double g = contact->conductance, e = contact->exchange_area;
  if (!(g >= 0.0 && isfinite(g)))
    return um_core_fail(b->context, UM_ERR_INPUT,
                        "contact %s - %s: conductance %g W/K; accepted: finite, not negative",
                        contact->a, contact->b, g);
  if (!(e >= 0.0 && isfinite(e)))
    return um_core_fail(b->context, UM_ERR_INPUT,
                        "contact %s - %s: exchange area %g m2; accepted: finite, not negative",
                        contact->a, contact->b, e);
  if (g > 0.0 && e > 0.0)
    return um_core_fail(
        b->context, UM_ERR_INPUT,
        "contact %s - %s: conducts %g W/K and radiates over %g m2; accepted: one of "
        "the two",
        contact->a, contact->b, g, e);
  return UM_OK;
}

enum um_status um_thermal_contact_assemble(struct um_thermal_builder *b,
                                           const struct um_thermal_contact *contact)
{
  struct side side[2] = {{.name = contact->a}, {.name = contact->b}};
  struct flow flow = {.size = contact->conductance};
  UM_TRY(check_size(b, contact));
  if (contact->exchange_area > 0.0) flow = (struct flow){true, contact->exchange_area, 0.0};
  enum um_status status = UM_OK;
  for (int i = 0; i < 2; i++) {
    if (!resolve(b, &side[i])) {
      status = refuse_place(b, contact, side[i].name);
      goto done;
    }
    UM_CHECK(collect(b, &side[i]));
  }
  UM_CHECK(connect(b, &side[0], &side[1], &flow));
  if (flow.size > 0.0 && !(flow.joined > 0.0))
    status = um_core_fail(b->context, UM_ERR_INPUT,
                          "contact %s - %s: joins a place to itself; accepted: two places",
                          contact->a, contact->b);
done:
  for (int i = 0; i < 2; i++) {
    UM_FREE(b->context, side[i].sample, side[i].patch);
  }
  return status;
}
