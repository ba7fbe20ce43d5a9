/* Heat that a body makes itself: powers and power histories of its walls and interiors, thermostat
 * heaters, power by a course in time. In a wall it is spread by area over its structure, which lies
 * under MLI; a wall that MLI leaves out cannot take any. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "thermal/network/builder_impl.h"

/* Nodes of a place with their shares, sum 1. */
struct share {
  uint32_t *node;
  double *weight;
  size_t n;
};

static void share_free(struct um_context *context, struct share *share)
{
  UM_FREE(context, share->node, share->weight);
}

/* "part NAME, group G" for messages, or of another place of it. */
static const char *place_label(const struct um_thermal_builder *b,
                               const struct um_thermal_where *where, char *text, size_t size)
{
  const char *part = um_thermal_builder_part_name(b, where->part);
  if (where->group != UM_GEOMETRY_NONE)
    snprintf(text, size, "part %s, group %s", part,
             um_geometry_group(b->geometry, where->group)->name);
  else
    snprintf(text, size, "part %s", part);
  return text;
}

static void layer_add(const uint32_t node[3], double area, double *weight)
{
  for (int c = 0; c < 3; c++)
    if (node[c] != UM_THERMAL_SPACE) weight[node[c]] += area / 3.0;
}

static enum um_status share_fill(const struct um_thermal_builder *b, const double *weight,
                                 size_t nnode, struct share *out)
{
  double sum = 0.0;
  for (size_t i = 0; i < nnode; i++) {
    sum += weight[i];
    out->n += weight[i] > 0.0;
  }
  UM_TRY(um_core_allocate(b->context, out->n, sizeof *out->node, &out->node));
  UM_TRY(um_core_allocate(b->context, out->n, sizeof *out->weight, &out->weight));
  size_t n = 0;
  for (size_t i = 0; i < nnode; i++) {
    if (!(weight[i] > 0.0)) continue;
    out->node[n] = (uint32_t)i;
    out->weight[n++] = weight[i] / sum;
  }
  return UM_OK;
}

/* The structure of a place by area; both layers alike where it is both. The caller frees. */
static enum um_status share_of(const struct um_thermal_builder *b,
                               const struct um_thermal_where *where, const char *what,
                               struct share *out)
{
  double *weight = NULL;
  size_t nnode = um_thermal_network_nodes(b->network);
  UM_TRY(um_core_allocate(b->context, nnode, sizeof *weight, &weight));
  bool inside = where->interior != UM_THERMAL_SPACE;
  if (inside) um_thermal_interior_shares(b, where->interior, weight);
  for (size_t f = 0; f < b->mesh->nfacet && !inside; f++) {
    if (b->mesh->facet_part[f] != where->part) continue;
    if (where->group != UM_GEOMETRY_NONE && b->mesh->facet_group[f] != where->group) continue;
    bool two = um_thermal_builder_two_layers(b, f);
    if (where->front || !two) layer_add(b->front[f], b->mesh->area[f], weight);
    if (where->back && two) layer_add(b->back[f], b->mesh->area[f], weight);
  }
  enum um_status status = share_fill(b, weight, nnode, out);
  um_core_free(b->context, weight);
  if (status == UM_OK && out->n == 0) {
    char label[512];
    status = um_core_fail(b->context, UM_ERR_INPUT,
                          "%s: no wall that could take the heat of its %s; accepted: the interior, "
                          "which its MLI wraps",
                          place_label(b, where, label, sizeof label), what);
  }
  return status;
}

static enum um_status history_add(const struct um_thermal_builder *b, const struct share *share,
                                  const struct um_thermal_power_history *history)
{
  const struct um_thermal_source source = {.node = share->node,
                                           .weight = share->weight,
                                           .nnode = share->n,
                                           .t = history->t,
                                           .power = history->power,
                                           .nrow = history->nrow};
  return um_thermal_network_source_add(b->network, &source);
}

/* Constant power and history of a group's wall. */
static enum um_status group_heat(const struct um_thermal_builder *b, size_t part,
                                 const struct um_thermal_group_spec *spec)
{
  enum um_status status;
  struct share share = {0};
  const struct um_thermal_where where = {.part = (uint32_t)part,
                                         .group = spec->group,
                                         .front = true,
                                         .back = true,
                                         .interior = UM_THERMAL_SPACE};
  if (spec->power == 0.0 && spec->history == NULL) return UM_OK;
  UM_CHECK(share_of(b, &where, "power", &share));
  for (size_t i = 0; i < share.n; i++)
    um_thermal_network_power_add(b->network, share.node[i], share.weight[i] * spec->power);
  if (spec->history != NULL) UM_CHECK(history_add(b, &share, spec->history));
done:
  share_free(b->context, &share);
  return status;
}

static enum um_status place_find(const struct um_thermal_builder *b, size_t part, const char *place,
                                 struct um_thermal_where *where)
{
  char suffix[512];
  const char *name = um_thermal_builder_part_name(b, part);
  where->part = (uint32_t)part;
  snprintf(suffix, sizeof suffix, "%s%s", *place == '\0' ? "" : ".", place);
  if (um_thermal_where_find(b, suffix, where)) return UM_OK;
  return um_core_fail(
      b->context, UM_ERR_INPUT,
      "part %s: a heater on '%.100s', which it has not; accepted: one of its groups, "
      "GROUP.back, front, back, an interior where it has one",
      name, place);
}

static enum um_status heater_add(const struct um_thermal_builder *b, size_t part,
                                 const struct um_thermal_heater *heater)
{
  enum um_status status;
  struct share share = {0};
  struct um_thermal_where where;
  char label[512];
  if (heater->power == 0.0) return UM_OK;
  UM_CHECK(place_find(b, part, heater->place, &where));
  UM_CHECK(share_of(b, &where, "heater", &share));
  const struct um_thermal_thermostat thermostat = {.node = share.node,
                                                   .weight = share.weight,
                                                   .nnode = share.n,
                                                   .power = heater->power,
                                                   .on = heater->on,
                                                   .off = heater->off,
                                                   .phase = heater->phase};
  status = um_thermal_network_thermostat_add(b->network, &thermostat);
  if (status == UM_ERR_INPUT)
    um_core_message_prefix(b->context, "%s%s%s", place_label(b, &where, label, sizeof label),
                           where.interior != UM_THERMAL_SPACE ? ", " : "",
                           where.interior != UM_THERMAL_SPACE ? heater->place : "");
done:
  share_free(b->context, &share);
  return status;
}

/* The last instant of the rows of a course: they are finite. */
static double timed_end(const struct um_thermal_course *course)
{
  double lasts = UM_THERMAL_TIMED_LASTS;
  if (course->shape == UM_HEAT_PERIODIC)
    lasts = fmin(lasts, UM_THERMAL_TIMED_TURNS * course->period);
  return course->start + lasts;
}

static enum um_status timed_add(const struct um_thermal_builder *b, size_t part,
                                const struct um_thermal_timed *timed)
{
  enum um_status status;
  struct share share = {0};
  struct um_thermal_where where;
  double *t = NULL, *power = NULL, end = timed_end(&timed->course);
  if (timed->power == 0.0) return UM_OK;
  size_t n = um_thermal_course_rows(&timed->course, end, NULL, NULL);
  UM_CHECK(place_find(b, part, timed->place, &where));
  UM_CHECK(share_of(b, &where, "heat", &share));
  UM_CHECK(um_core_allocate(b->context, n, sizeof *t, &t));
  UM_CHECK(um_core_allocate(b->context, n, sizeof *power, &power));
  um_thermal_course_rows(&timed->course, end, t, power);
  for (size_t i = 0; i < n; i++) power[i] *= timed->power;
  const struct um_thermal_power_history history = {t, power, n};
  status = history_add(b, &share, &history);
done:
  UM_FREE(b->context, t, power);
  share_free(b->context, &share);
  return status;
}

enum um_status um_thermal_heat_assemble(struct um_thermal_builder *b, size_t part)
{
  const struct um_thermal_part_spec *spec = b->part[part];
  for (size_t g = 0; g < spec->ngroup; g++) UM_TRY(group_heat(b, part, &spec->groups[g]));
  for (size_t h = 0; h < spec->nheater; h++) UM_TRY(heater_add(b, part, &spec->heater[h]));
  for (size_t i = 0; i < spec->ntimed; i++) UM_TRY(timed_add(b, part, &spec->timed[i]));
  for (size_t i = 0; i < spec->ninterior; i++) {
    uint32_t node[2];
    double weight[2];
    const struct share share = {node, weight, um_thermal_interior_nodes(b, part, i, node, weight)};
    if (spec->interior[i].history != NULL && !(spec->interior[i].conductivity > 0.0)) /* solid.c */
      UM_TRY(history_add(b, &share, spec->interior[i].history));
  }
  return UM_OK;
}
