/* Measurements as reflectivity: linear flux over that of a body of 1 m^2/sr. */
#include "evidence/inversion/on_map.h"

#include <math.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "environment/airmass.h"
#include "evidence/comparison/residual.h"
#include "evidence/measurements/time_text.h"

/* ---- light of a body of 1 m^2/sr ---- */

/* Scratch of one row, all [bins of the largest band]. */
struct light {
  double *wavelength, *width, *sun, *above, *below;
};

static void light_release(struct um_context *context, struct light *l)
{
  UM_FREE(context, l->wavelength, l->width, l->sun, l->above, l->below);
}

static enum um_status light_make(struct um_context *context, const struct um_model *model,
                                 struct light *l)
{
  size_t n = 1;
  *l = (struct light){0};
  for (size_t b = 0; b < model->nband; b++)
    if ((size_t)model->band[b].bins > n) n = (size_t)model->band[b].bins;
  UM_TRY(um_core_allocate(context, n, sizeof(double), &l->wavelength));
  UM_TRY(um_core_allocate(context, n, sizeof(double), &l->width));
  UM_TRY(um_core_allocate(context, n, sizeof(double), &l->sun));
  UM_TRY(um_core_allocate(context, n, sizeof(double), &l->above));
  return um_core_allocate(context, n, sizeof(double), &l->below);
}

/* Sunlight that a body of 1 m^2/sr sends to the observer, above and below the air, per bin. */
static void light_fill(const struct um_model *model, const struct um_environment_sample *sample,
                       double elevation, size_t band, struct light *l)
{
  const struct um_optics_band *b = &model->band[band];
  const struct um_environment_clear_sky *sky = &model->environment.sky;
  double airmass = sky->on ? um_environment_airmass_toward(elevation) : (double)NAN;
  double apart = sample->range * sample->range;
  um_model_sunlight(model, sample, band, l->sun);
  for (int i = 0; i < b->bins; i++) {
    double from = um_optics_band_edge(b, i), to = um_optics_band_edge(b, i + 1);
    l->wavelength[i] = 0.5 * (from + to);
    l->width[i] = to - from;
    l->above[i] = l->sun[i] / apart;
    l->below[i] = l->above[i];
    if (!isnan(airmass))
      l->below[i] *= um_environment_clear_sky_transmission(sky, from, to, airmass);
  }
}

/* In linear flux of the quantity, as um_compare_linear has it. */
static double light_of(const struct um_model *model, enum um_compare_quantity quantity,
                       size_t source, size_t band, const struct light *l)
{
  const struct um_optics_band *b = &model->band[band];
  struct um_instrument_bins bins = {(size_t)b->bins, l->wavelength, l->width, b->transmission};
  double magnitude;
  switch (quantity) {
  case UM_QUANTITY_RADIANT_INTENSITY:
    return um_instrument_irradiance(&bins, l->sun);
  case UM_QUANTITY_BAND_IRRADIANCE:
    return um_instrument_irradiance(&bins, l->below);
  case UM_QUANTITY_COUNT_RATE:
    bins.transmission = model->sensor[source].efficiency;
    return um_instrument_count_rate(&model->sensor[source].optics, &bins, l->below);
  default:
    magnitude = um_instrument_magnitude_ab(&bins, l->above);
    if (quantity == UM_QUANTITY_MAGNITUDE_VEGA) magnitude -= model->vega_ab[band];
    return pow(10.0, -0.4 * magnitude);
  }
}

/* ---- rows ---- */

static enum um_status look_at(struct um_context *context, const struct um_model *model,
                              const struct um_compare_plan *plan, size_t k,
                              struct um_environment_sample *sample, double *elevation)
{
  struct um_orbit_look look;
  enum um_status status = um_compare_plan_sample(context, model, plan, k, sample, &look);
  *elevation = look.elevation;
  return status;
}

static enum um_status fill(struct um_context *context, const struct um_model *model,
                           struct um_compare_on_map *m, double *elevation, struct light *light)
{
  const struct um_compare_measurements *set = m->measurements;
  for (size_t k = 0; k < m->plan->ntime; k++)
    UM_TRY(look_at(context, model, m->plan, k, &m->sample[k], &elevation[k]));
  for (size_t i = 0; i < set->count; i++) {
    const struct um_compare_measurement *from = &set->row[i];
    enum um_compare_quantity quantity = set->channel[from->channel].quantity;
    size_t k = m->plan->observation[i];
    if (k == UM_COMPARE_NOWHERE || quantity == UM_QUANTITY_TEMPERATURE ||
        um_compare_is_grey_body(quantity))
      continue;
    if (!(m->sample[k].sunlit_fraction > 0.0)) {
      m->dark++;
      continue;
    }
    size_t band = um_compare_band(m->plan, model, from->channel);
    light_fill(model, &m->sample[k], elevation[k], band, light);
    double unit = light_of(model, quantity, m->plan->source[from->channel], band, light);
    struct um_compare_linear of = um_compare_measured(set, i, from->sigma);
    m->row[m->count++] =
        (struct um_compare_map_row){i, k, band, of.value / unit, of.sigma / unit, unit};
  }
  if (m->count > 0) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s: no row of light in sunlight, %zu in the shadow; accepted: one or more",
                      set->path, m->dark);
}

enum um_status um_compare_on_map_create(struct um_context *context, const struct um_model *model,
                                        const struct um_compare_measurements *measurements,
                                        struct um_compare_on_map **out)
{
  enum um_status status;
  struct um_compare_on_map *m = NULL;
  struct light light = {0};
  double *elevation = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *m, &m));
  m->measurements = measurements;
  UM_CHECK(um_compare_plan_create(context, model, measurements, &m->plan));
  UM_CHECK(um_core_allocate(context, m->plan->ntime, sizeof *m->sample, &m->sample));
  UM_CHECK(um_core_allocate(context, m->plan->ntime, sizeof *elevation, &elevation));
  UM_CHECK(um_core_allocate(context, measurements->count, sizeof *m->row, &m->row));
  UM_CHECK(light_make(context, model, &light));
  UM_CHECK(fill(context, model, m, elevation, &light));
  *out = m;
  m = NULL;
done:
  light_release(context, &light);
  um_core_free(context, elevation);
  um_compare_on_map_destroy(context, &m);
  return status;
}

void um_compare_on_map_destroy(struct um_context *context, struct um_compare_on_map **on_map)
{
  if (on_map == NULL || *on_map == NULL) return;
  um_compare_plan_destroy(context, &(*on_map)->plan);
  UM_FREE(context, (*on_map)->sample, (*on_map)->row, *on_map);
  *on_map = NULL;
}

/* ---- measured.csv ---- */

enum um_status um_compare_on_map_write(struct um_context *context,
                                       const struct um_compare_on_map *on_map,
                                       const struct um_model *model,
                                       const struct um_model_map_pass *pass, FILE *file)
{
  const struct um_compare_measurements *m = on_map->measurements;
  fputs("time_utc,quantity,of,value,latitude_deg,longitude_deg,phase_angle_deg,plane_deg", file);
  for (size_t b = 0; b < model->nband; b++) {
    um_core_csv_put_text(file, model->band[b].name, "_m2_sr");
    um_core_csv_put_text(file, model->band[b].name, "_sigma_m2_sr");
    um_core_csv_put_text(file, model->band[b].name, "_looked_up_m2_sr");
  }
  fputc('\n', file);
  for (size_t i = 0; i < on_map->count; i++) {
    const struct um_compare_map_row *row = &on_map->row[i];
    const struct um_compare_measurement *from = &m->row[row->row];
    const struct um_compare_channel *channel = &m->channel[from->channel];
    const struct um_model_phase_vector *at = &pass->at[row->observation];
    char time[40];
    UM_TRY(um_core_stop_check(context, "measurements were written"));
    um_compare_time_text(from->t_tai, time);
    fputs(time, file);
    um_core_csv_put_text(file, um_compare_quantity_name(channel->quantity), "");
    um_core_csv_put_text(file, channel->of, "");
    um_core_csv_put_number(file, from->value);
    um_core_csv_put_number(file, at->latitude / UM_DEG);
    um_core_csv_put_number(file, at->longitude / UM_DEG);
    um_core_csv_put_number(file, at->phase_angle / UM_DEG);
    um_core_csv_put_number(file, at->plane / UM_DEG);
    for (size_t b = 0; b < model->nband; b++) {
      if (b != row->band) {
        fputs(",,,", file);
        continue;
      }
      um_core_csv_put_number(file, row->value);
      um_core_csv_put_number(file, row->sigma);
      um_core_csv_put_number(file, pass->looked_up[row->observation * pass->nband + b]);
    }
    fputc('\n', file);
  }
  return UM_OK;
}
