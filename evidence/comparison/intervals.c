/* Where in time a channel is worst, and what the model's value is made of there.
 *
 * Windows of a tenth of the channel's observations, at least three; the one with the largest
 * chi-square, then the next that does not overlap it, and so on. */
#include <math.h>

#include "evidence/comparison/intervals_impl.h"

#include "evidence/comparison/residual.h"

#define WINDOWS  10
#define SHORTEST 3 /* observations */

#define FLOWS 8
static const char *const flows[FLOWS] = {"solar",     "albedo",   "planet",    "internal",
                                         "conducted", "radiated", "exchanged", "stored"};

static double flow(const struct um_thermal_heat *heat, size_t i)
{
  const double all[FLOWS] = {heat->solar,     heat->albedo,   heat->planet,    heat->internal,
                             heat->conducted, heat->radiated, heat->exchanged, heat->stored};
  return all[i];
}

/* --- shares ---------------------------------------------------------------------------------- */

static enum um_status light_shares(struct um_context *context,
                                   const struct um_compare_comparison *c, size_t band,
                                   const size_t *row, struct um_compare_interval *w)
{
  const struct um_model_result *r = c->run.result;
  UM_TRY(um_core_allocate(context, UM_MECHANISM_COUNT, sizeof *w->mechanism, &w->mechanism));
  UM_TRY(um_core_allocate(context, r->nmaterial, sizeof *w->material, &w->material));
  w->nmechanism = UM_MECHANISM_COUNT;
  w->nmaterial = r->nmaterial;
  for (size_t j = 0; j < w->nmechanism; j++)
    w->mechanism[j].name = um_optics_mechanism_name((enum um_optics_mechanism)j);
  for (size_t m = 0; m < r->nmaterial; m++)
    w->material[m].name = um_geometry_material_name(c->run.model->geometry, m);
  for (size_t i = 0; i < w->count; i++) {
    size_t k = c->run.plan->observation[row[i]];
    for (size_t m = 0; m < r->nmaterial; m++)
      for (size_t j = 0; j < UM_MECHANISM_COUNT; j++) {
        double part =
            r->intensity[((k * r->nband + band) * r->nmaterial + m) * UM_MECHANISM_COUNT + j] /
            (double)w->count;
        w->mechanism[j].value += part;
        w->material[m].value += part;
      }
  }
  return UM_OK;
}

static enum um_status heat_shares(struct um_context *context, const struct um_compare_comparison *c,
                                  size_t place, const size_t *row, struct um_compare_interval *w)
{
  const struct um_model_result *r = c->run.result;
  if (place >= c->run.model->body->nplace) return UM_OK; /* a material has no nodes of its own */
  UM_TRY(um_core_allocate(context, FLOWS, sizeof *w->mechanism, &w->mechanism));
  w->nmechanism = FLOWS;
  for (size_t j = 0; j < FLOWS; j++) {
    w->mechanism[j].name = flows[j];
    for (size_t i = 0; i < w->count; i++)
      w->mechanism[j].value +=
          flow(&r->heat[c->run.plan->observation[row[i]] * r->nplace + place], j) /
          (double)w->count;
  }
  return UM_OK;
}

/* --- windows --------------------------------------------------------------------------------- */

static bool overlaps(const struct um_compare_channel_comparison *channel, size_t first, size_t n)
{
  for (size_t w = 0; w < channel->nworst; w++) {
    const struct um_compare_interval *other = &channel->worst[w];
    if (first < other->first + other->count && other->first < first + n) return true;
  }
  return false;
}

/* The worst window of n observations that overlaps none before it; false when there is none. */
static bool next_worst(const struct um_compare_comparison *c,
                       const struct um_compare_channel_comparison *channel, size_t n, size_t *first,
                       double *chi2)
{
  bool found = false;
  for (size_t a = 0; a + n <= channel->count; a++) {
    double sum = 0.0;
    if (overlaps(channel, a, n)) continue;
    for (size_t i = a; i < a + n; i++) {
      double z = um_compare_residual_normalised(&c->residual[channel->row[i]]);
      sum += z * z;
    }
    if (found && !(sum > *chi2)) continue;
    found = true;
    *first = a;
    *chi2 = sum;
  }
  return found;
}

static void describe(const struct um_compare_comparison *c, const size_t *row,
                     struct um_compare_interval *w)
{
  const struct um_compare_measurements *m = c->run.plan->measurements;
  w->from = m->row[row[0]].t_tai;
  w->to = m->row[row[w->count - 1]].t_tai;
  for (size_t i = 0; i < w->count; i++) {
    const struct um_compare_residual *r = &c->residual[row[i]];
    w->bias += (r->measured - r->model) / (double)w->count;
    w->mean_measured += r->measured / (double)w->count;
    w->sunlit += c->run.tables->sunlit[c->run.plan->observation[row[i]]] / (double)w->count;
  }
}

/* Chi-square where the observations have sigmas; else in units of the channel's mean square. */
static double scale_of(const struct um_compare_comparison *c,
                       const struct um_compare_channel_comparison *channel)
{
  double squares = 0.0;
  size_t bare = 0;
  for (size_t i = 0; i < channel->count; i++) {
    double z = um_compare_residual_normalised(&c->residual[channel->row[i]]);
    squares += z * z / (double)channel->count;
    if (isnan(c->residual[channel->row[i]].sigma)) bare++;
  }
  return bare > 0 && squares > 0.0 ? squares : 1.0;
}

enum um_status um_compare_intervals_find(struct um_context *context,
                                         const struct um_compare_comparison *comparison,
                                         struct um_compare_channel_comparison *channel)
{
  const struct um_compare_comparison *c = comparison;
  const struct um_compare_plan *plan = c->run.plan;
  size_t n = channel->count / WINDOWS, source = plan->source[channel->channel];
  bool heat = plan->measurements->channel[channel->channel].quantity == UM_QUANTITY_TEMPERATURE;
  size_t band = heat ? 0 : um_compare_band(plan, c->run.model, channel->channel);
  double scale = scale_of(c, channel);
  if (n < SHORTEST) n = SHORTEST;
  if (n > channel->count) n = channel->count;
  while (n > 0 && channel->nworst < UM_COMPARE_WORST) {
    size_t first = 0;
    double chi2 = 0.0;
    if (!next_worst(c, channel, n, &first, &chi2)) break;
    struct um_compare_interval *w = &channel->worst[channel->nworst++];
    *w = (struct um_compare_interval){.first = first, .count = n, .chi2 = chi2 / scale};
    const size_t *row = channel->row + first;
    describe(c, row, w);
    UM_TRY(heat ? heat_shares(context, c, source, row, w) : light_shares(context, c, band, row, w));
  }
  return UM_OK;
}
