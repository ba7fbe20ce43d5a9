/* From heat of a place to the observations. Temperatures of nodes answer by the linear response
 * along the model's own history (thermal/tangent/sensitivity.h); from them
 *
 *   a temperature      mean of the place, as its observations are made,
 *   light              sum over regions g of  dI/dT_g  sum_s w_s dT_s / sum_s w_s,
 *
 * dI/dT_g by a run of the optics with the region WARMER by a tenth of a kelvin, which holds
 * inter-reflection, directional emissivity and all that is done to the light behind it; w_s the
 * projected area that the observer sees. That is exact where a region has one temperature or its
 * dB/dT varies little. A surface at the fourth-power mean of its nodes answers by
 * dT_s = sum w_n (T_n / T_s)^3 dT_n. */
#include "evidence/missing_heat/observations_impl.h"

#include <math.h>
#include <string.h>

#include "evidence/comparison/residual.h"
#include "model/products/run_response.h"
#include "model/run/run.h"

#define TOLERANCE 1e-3 /* of a step of heat [1]; leaves 2e-4 of a place's largest answer */
#define WARMER    0.1  /* [K]; dB/dT of 10 um at 250 K changes by 0.2 % */

/* --- the base -------------------------------------------------------------------------------- */

enum um_status um_missing_heat_predict(struct um_context *context,
                                       const struct um_missing_heat_base *base,
                                       const struct um_model_result *result, double *out)
{
  enum um_status status;
  const struct um_sensitivity_forward *f = base->forward;
  const struct um_compare_measurements *m = f->measurements;
  double *whole = NULL;
  UM_CHECK(um_core_allocate(context, m->count, sizeof *whole, &whole));
  UM_CHECK(um_compare_predict(context, f->plan, base->variant.tables, result, whole));
  um_compare_modelled(m, f->observations.count, f->observations.row, whole, out);
  for (size_t j = 0; j < f->observations.count; j++) out[j] /= f->observations.sigma[j];
done:
  um_core_free(context, whole);
  return status;
}

static bool is_light(const struct um_sensitivity_forward *f, size_t row)
{
  return f->measurements->channel[f->observations.channel[row]].quantity != UM_QUANTITY_TEMPERATURE;
}

/* Number of the region of every surface. */
static enum um_status find_regions(struct um_context *context, struct um_missing_heat_base *base)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(base->variant.model->geometry);
  bool means = base->variant.model->scenario->thermal->temperature_in_optics == 1;
  base->nregion = means ? um_geometry_material_count(base->variant.model->geometry)
                        : 2 * um_geometry_group_count(base->variant.model->geometry);
  UM_TRY(um_core_allocate(context, mesh->nsurface, sizeof *base->region, &base->region));
  for (size_t s = 0; s < mesh->nsurface; s++) {
    const struct um_geometry_surface *surface = &mesh->surface[s];
    base->region[s] = means ? surface->material : 2 * surface->group + surface->back;
  }
  return UM_OK;
}

/* One region; a region without surfaces is left at 0. */
static enum um_status find_slope(struct um_context *context, struct um_missing_heat_base *base,
                                 size_t region, double *offset, const double *cold)
{
  size_t nsurface = um_geometry_mesh(base->variant.model->geometry)->nsurface, n = 0;
  double *slope = base->slope + region * base->forward->observations.count;
  struct um_model_result *result = NULL;
  for (size_t s = 0; s < nsurface; s++) {
    offset[s] = base->region[s] == region ? WARMER : 0.0;
    if (base->region[s] == region) n++;
  }
  if (n == 0) return UM_OK;
  UM_TRY(um_model_run_warmer(context, base->variant.model, base->variant.tables, base->variant.heat,
                             offset, &result));
  base->forward->evaluations++;
  enum um_status status = um_missing_heat_predict(context, base, result, slope);
  um_model_result_destroy(context, &result);
  for (size_t j = 0; j < base->forward->observations.count; j++)
    slope[j] = is_light(base->forward, j) ? (slope[j] - cold[j]) / WARMER : 0.0;
  return status;
}

static enum um_status find_slopes(struct um_context *context, struct um_missing_heat_base *base)
{
  enum um_status status = UM_OK;
  const struct um_sensitivity_forward *f = base->forward;
  double *cold = NULL, *offset = NULL;
  bool light = false;
  for (size_t j = 0; j < f->observations.count; j++) light |= is_light(f, j);
  UM_CHECK(um_core_allocate(context, base->nregion * f->observations.count, sizeof *base->slope,
                            &base->slope));
  if (!light || base->variant.tables->view == NULL) goto done;
  UM_CHECK(um_core_allocate(context, f->observations.count, sizeof *cold, &cold));
  UM_CHECK(um_core_allocate(context, um_geometry_mesh(base->variant.model->geometry)->nsurface,
                            sizeof *offset, &offset));
  UM_CHECK(um_missing_heat_predict(context, base, base->result, cold));
  for (size_t g = 0; g < base->nregion; g++) UM_CHECK(find_slope(context, base, g, offset, cold));
done:
  UM_FREE(context, cold, offset);
  return status;
}

/* Observations by observation. */
static enum um_status sort_rows(struct um_context *context, struct um_missing_heat_base *base)
{
  const struct um_sensitivity_forward *f = base->forward;
  size_t nobs = base->variant.tables->nobs, *first;
  UM_TRY(um_core_allocate(context, nobs + 2, sizeof *base->first, &base->first));
  UM_TRY(um_core_allocate(context, f->observations.count, sizeof *base->row, &base->row));
  first = base->first; /* counts two places on, starts one place on, then ends there */
  for (size_t j = 0; j < f->observations.count; j++)
    first[f->plan->observation[f->observations.row[j]] + 2]++;
  for (size_t k = 2; k < nobs + 2; k++) first[k] += first[k - 1];
  for (size_t j = 0; j < f->observations.count; j++)
    base->row[first[f->plan->observation[f->observations.row[j]] + 1]++] = j;
  return UM_OK;
}

enum um_status um_missing_heat_base_create(struct um_context *context,
                                           struct um_sensitivity_forward *forward,
                                           const struct um_model_addition *addition,
                                           size_t naddition, struct um_missing_heat_base *out)
{
  const struct um_model_changes changes = {.addition = addition, .naddition = naddition};
  const struct um_variant_heat heat = um_sensitivity_forward_heat(forward);
  const struct um_variant *v = &out->variant;
  *out = (struct um_missing_heat_base){
      .forward = forward, .addition = addition, .naddition = naddition, .variant = forward->base};
  if (naddition > 0)
    UM_TRY(um_variant_open(context, forward->evaluator, &changes, &heat, &out->variant));
  UM_TRY(um_model_run_with(context, v->model, v->tables, v->heat, &out->result));
  forward->evaluations++;
  if (v->tables->points) return UM_OK; /* heat is not followed */
  UM_TRY(sort_rows(context, out));
  UM_TRY(find_regions(context, out));
  return find_slopes(context, out);
}

void um_missing_heat_base_release(struct um_context *context, struct um_missing_heat_base *base)
{
  um_model_result_destroy(context, &base->result);
  um_variant_close(context, &base->variant);
  UM_FREE(context, base->first, base->row, base->region, base->slope);
  *base = (struct um_missing_heat_base){0};
}

/* --- columns --------------------------------------------------------------------------------- */

struct taker {
  const struct um_missing_heat_base *base;
  size_t nnode, nplace, nbin;
  const double *edge; /* [nbin + 1] */
  double *column;     /* [nplace][nbin][nobservation] */
  double *weight;     /* [nsurface] of the surfaces in their regions, sum 1, or 0 */
  double *sum;        /* [nregion] */
  double *gradient;   /* [nregion][nnode] d(mean of the region)/d(node) at this instant */
};

/* Projected visible areas; areas where nothing of a region is seen (its light then comes by
 * reflection), and where the optics take means by area. */
static void weigh(struct taker *t, size_t instant)
{
  const struct um_missing_heat_base *base = t->base;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(base->variant.model->geometry);
  const struct um_optics_view *view = base->variant.tables->view;
  bool means = base->variant.model->scenario->thermal->temperature_in_optics == 1;
  memset(t->sum, 0, base->nregion * sizeof *t->sum);
  for (size_t s = 0; s < mesh->nsurface && !means; s++) {
    size_t at = instant * mesh->nsurface + s;
    t->weight[s] = mesh->area[mesh->surface[s].facet] * (double)view->seen[at] *
                   fmax(0.0, (double)view->cos_observer[at]);
    t->sum[base->region[s]] += t->weight[s];
  }
  for (size_t s = 0; s < mesh->nsurface; s++)
    if (!(t->sum[base->region[s]] > 0.0)) t->weight[s] = mesh->area[mesh->surface[s].facet];
  memset(t->sum, 0, base->nregion * sizeof *t->sum);
  for (size_t s = 0; s < mesh->nsurface; s++) t->sum[base->region[s]] += t->weight[s];
}

/* d(mean of each region)/d(node). */
static void differentiate(struct taker *t, const double *temperature)
{
  const struct um_missing_heat_base *base = t->base;
  size_t nsurface = um_geometry_mesh(base->variant.model->geometry)->nsurface;
  memset(t->gradient, 0, base->nregion * t->nnode * sizeof *t->gradient);
  for (size_t s = 0; s < nsurface; s++) {
    const struct um_thermal_surface *surface =
        um_thermal_network_surface(base->variant.model->body->network, (uint32_t)s);
    if (surface == NULL || !(t->weight[s] > 0.0)) continue;
    double fourth = 0.0, own = t->weight[s] / t->sum[base->region[s]];
    for (int c = 0; c < 3; c++)
      if (surface->node[c] != UM_THERMAL_SPACE)
        fourth += surface->weight[c] * pow(temperature[surface->node[c]], 4);
    double mean = sqrt(sqrt(fourth));
    for (int c = 0; c < 3; c++) {
      if (surface->node[c] == UM_THERMAL_SPACE) continue;
      t->gradient[base->region[s] * t->nnode + surface->node[c]] +=
          own * surface->weight[c] * pow(temperature[surface->node[c]] / mean, 3);
    }
  }
}

/* Change of a temperature observation by the nodes' [K]: a place of the network, or a material by
 * area. */
static double temperature_change(const struct um_missing_heat_base *base, size_t row,
                                 const double *response)
{
  const struct um_sensitivity_forward *f = base->forward;
  const struct um_thermal_body *body = base->variant.model->body;
  size_t source = f->plan->source[f->observations.channel[row]];
  double sum = 0.0, area = 0.0;
  if (source < body->nplace) {
    const struct um_thermal_place *place = &body->place[source];
    for (size_t i = 0; i < place->nnode; i++) sum += place->weight[i] * response[place->node[i]];
    return sum;
  }
  const struct um_geometry_mesh *mesh = um_geometry_mesh(base->variant.model->geometry);
  for (size_t s = 0; s < mesh->nsurface; s++) {
    const struct um_thermal_surface *surface =
        um_thermal_network_surface(body->network, (uint32_t)s);
    if (mesh->surface[s].material != source - body->nplace || surface == NULL) continue;
    double a = mesh->area[mesh->surface[s].facet];
    area += a;
    for (int c = 0; c < 3; c++)
      if (surface->node[c] != UM_THERMAL_SPACE)
        sum += a * surface->weight[c] * response[surface->node[c]];
  }
  return area > 0.0 ? sum / area : 0.0;
}

static double light_change(const struct taker *t, size_t row, const double *region)
{
  double sum = 0.0;
  for (size_t g = 0; g < t->base->nregion; g++)
    sum += t->base->slope[g * t->base->forward->observations.count + row] * region[g];
  return sum;
}

/* The observations of one instant by the nodes' changes s[nnode], to column[nobservation]. */
static void take_bin(struct taker *t, size_t observation, bool light, const double *s,
                     double *column)
{
  const struct um_missing_heat_base *base = t->base;
  const struct um_sensitivity_forward *f = base->forward;
  double share = 1.0 / (double)base->variant.tables->nsub, *mean = t->sum;
  for (size_t g = 0; g < base->nregion && light; g++) {
    mean[g] = 0.0;
    for (size_t i = 0; i < t->nnode; i++) mean[g] += t->gradient[g * t->nnode + i] * s[i];
  }
  for (size_t i = base->first[observation]; i < base->first[observation + 1]; i++) {
    size_t row = base->row[i];
    column[row] +=
        share * (is_light(f, row) ? light_change(t, row, mean)
                                  : temperature_change(base, row, s) / f->observations.sigma[row]);
  }
}

static enum um_status take(void *user, size_t k, const double *temperature, const double *response)
{
  struct taker *t = user;
  const struct um_missing_heat_base *base = t->base;
  const struct um_sensitivity_forward *f = base->forward;
  size_t observation = k / base->variant.tables->nsub;
  bool light = false;
  for (size_t i = base->first[observation]; i < base->first[observation + 1]; i++)
    light |= is_light(f, base->row[i]);
  if (light) {
    weigh(t, k);
    differentiate(t, temperature);
  }
  for (size_t p = 0; p < t->nplace; p++)
    for (size_t b = 0; b < t->nbin && t->edge[b] < base->variant.tables->sample[k].t_tai; b++)
      take_bin(t, observation, light, response + (p * t->nbin + b) * t->nnode,
               t->column + (p * t->nbin + b) * base->forward->observations.count);
  return UM_OK;
}

enum um_status um_missing_heat_columns(struct um_context *context,
                                       const struct um_missing_heat_base *base,
                                       const struct um_missing_heat_place *place, size_t nplace,
                                       size_t nbin, const double *edge, double *column)
{
  enum um_status status;
  struct taker t = {.base = base,
                    .nnode = um_thermal_network_nodes(base->variant.model->body->network),
                    .nplace = nplace,
                    .nbin = nbin,
                    .edge = edge,
                    .column = column};
  struct um_thermal_pulse *pulse = NULL;
  memset(column, 0, nplace * nbin * base->forward->observations.count * sizeof *column);
  UM_CHECK(um_core_allocate(context, um_geometry_mesh(base->variant.model->geometry)->nsurface,
                            sizeof *t.weight, &t.weight));
  UM_CHECK(um_core_allocate(context, base->nregion, sizeof *t.sum, &t.sum));
  UM_CHECK(um_core_allocate(context, base->nregion * t.nnode, sizeof *t.gradient, &t.gradient));
  UM_CHECK(um_core_allocate(context, nplace * nbin, sizeof *pulse, &pulse));
  for (size_t k = 0; k < nplace * nbin; k++)
    pulse[k] = (struct um_thermal_pulse){.node = place[k / nbin].node,
                                         .weight = place[k / nbin].weight,
                                         .nnode = place[k / nbin].nnode,
                                         .t_from = edge[k % nbin],
                                         .t_to = edge[k % nbin + 1]};
  UM_CHECK(um_model_thermal_solution_response(context, base->variant.heat, pulse, nplace * nbin,
                                              TOLERANCE, take, &t));
done:
  UM_FREE(context, t.weight, t.sum, t.gradient, pulse);
  return status;
}
