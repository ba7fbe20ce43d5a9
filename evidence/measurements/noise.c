/* The noise model.
 *
 *   sigma^2 = (relative x value)^2 + floor^2 */
#include "evidence/measurements/noise.h"

#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "model/scenario/scenario.h"

_Static_assert((int)UM_SCENARIO_BAND_IRRADIANCE == (int)UM_QUANTITY_BAND_IRRADIANCE &&
                   (int)UM_SCENARIO_RADIANT_INTENSITY == (int)UM_QUANTITY_RADIANT_INTENSITY,
               "what the model knows of quantities");

double um_compare_noise_sigma(enum um_compare_quantity quantity,
                              const struct um_compare_noise *noise, double value)
{
  double scale = um_compare_is_magnitude(quantity) ? UM_POGSON : value;
  return hypot(noise->relative * scale, noise->floor);
}

static enum um_status check(struct um_context *context, const struct um_compare_noise *noise,
                            enum um_compare_quantity quantity, const char *of)
{
  if (noise->relative >= 0.0 && noise->floor >= 0.0 && isfinite(noise->relative) &&
      isfinite(noise->floor) && noise->relative + noise->floor > 0.0)
    return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "noise of %s '%s': relative %g, floor %g %s; accepted: both 0 or more, not "
                      "both 0",
                      um_compare_quantity_name(quantity), of, noise->relative, noise->floor,
                      um_compare_quantity_unit(quantity));
}

/* Sigma of one row of a value. */
static enum um_status sigma_of(struct um_context *context, const struct um_compare_measurements *m,
                               size_t row, const struct um_compare_noise *noise, double value,
                               double *out)
{
  const struct um_compare_channel *c = &m->channel[m->row[row].channel];
  const char *unit = um_compare_quantity_unit(c->quantity);
  *out = um_compare_noise_sigma(c->quantity, noise, value);
  if (*out > 0.0 && isfinite(*out)) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s:%d: the noise model gives %s '%s' of %g %s a sigma of %g %s; "
                      "accepted: above 0 (give the noise a floor)",
                      um_compare_row_path(m, row), m->row[row].line,
                      um_compare_quantity_name(c->quantity), c->of, value, unit, *out, unit);
}

enum um_status um_compare_noise_fill(struct um_context *context,
                                     struct um_compare_measurements *measurements, size_t channel,
                                     const struct um_compare_noise *noise, const double *model)
{
  struct um_compare_measurements *m = measurements;
  UM_TRY(check(context, noise, m->channel[channel].quantity, m->channel[channel].of));
  for (int pass = 0; pass < 2; pass++) /* check all, then fill */
    for (size_t i = 0; i < m->count; i++) {
      struct um_compare_measurement *row = &m->row[i];
      double sigma;
      if (row->channel != channel || !isnan(row->sigma)) continue;
      UM_TRY(sigma_of(context, m, i, noise, model == NULL ? row->value : model[i], &sigma));
      if (pass == 1) row->sigma = sigma;
    }
  return UM_OK;
}

/* --- noise of a scenario --------------------------------------------------------------------- */

static bool same_name(const char *a, const char *b)
{
  return a == NULL || b == NULL ? a == b : strcmp(a, b) == 0;
}

static enum um_status check_entries(struct um_context *context, const struct um_scenario_noise *n,
                                    size_t count)
{
  for (size_t k = 0; k < count; k++) {
    const struct um_compare_noise noise = {n[k].relative, n[k].floor};
    enum um_status status = check(context, &noise, (enum um_compare_quantity)n[k].quantity,
                                  n[k].of == NULL ? "" : n[k].of);
    for (size_t i = 0; i < k && status == UM_OK; i++)
      if (n[i].quantity == n[k].quantity && same_name(n[i].of, n[k].of))
        status = um_core_fail(context, UM_ERR_INPUT,
                              "the same rows are on line %d; accepted: each once", n[i].at.line);
    if (status == UM_OK) continue;
    um_core_message_prefix(context, "%s:%d: %s", n[k].at.file, n[k].at.line, n[k].at.path);
    return status;
  }
  return UM_OK;
}

/* The entry for a channel; NULL: none. */
static const struct um_scenario_noise *entry_of(const struct um_scenario_noise *n, size_t count,
                                                const struct um_compare_channel *channel)
{
  const struct um_scenario_noise *found = NULL;
  for (size_t k = 0; k < count; k++) {
    if (n[k].quantity != (int)channel->quantity) continue;
    if (n[k].of != NULL && strcmp(n[k].of, channel->of) == 0) return &n[k];
    if (n[k].of == NULL) found = &n[k];
  }
  return found;
}

enum um_status um_compare_noise_sigmas(struct um_context *context,
                                       const struct um_scenario *scenario,
                                       const struct um_compare_measurements *measurements,
                                       const double *model, double *sigma)
{
  const struct um_compare_measurements *m = measurements;
  size_t count = scenario->measurements == NULL ? 0 : scenario->measurements->noise.count;
  const struct um_scenario_noise *entries = count == 0 ? NULL : scenario->measurements->noise.items;
  UM_TRY(check_entries(context, entries, count));
  for (size_t i = 0; i < m->count; i++) {
    sigma[i] = m->row[i].sigma;
    if (!isnan(sigma[i]) || isnan(model[i])) continue;
    const struct um_scenario_noise *entry =
        entry_of(entries, count, &m->channel[m->row[i].channel]);
    if (entry == NULL) continue;
    const struct um_compare_noise noise = {entry->relative, entry->floor};
    UM_TRY(sigma_of(context, m, i, &noise, model[i], &sigma[i]));
  }
  return UM_OK;
}
