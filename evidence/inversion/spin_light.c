/* The whole model of a spin: what a run says of every row, with the body turned as the law has it
 * and no history of heat, which does not show below 2.5 um. */
#include <math.h>

#include "evidence/comparison/residual.h"
#include "evidence/inversion/spin_impl.h"
#include "model/geometry/posed.h"
#include "model/run/run.h"

struct um_compare_spin_light {
  struct um_model_tables *tables;
  struct um_quat *frame; /* [instants] GCRS to the frame of the axis */
  size_t *row;           /* [count of the data] row of the set */
  double *value;         /* [count of the set] scratch, in the quantities' units */
};

enum um_status um_compare_spin_frames(struct um_context *context, bool lvlh,
                                      const struct um_environment_sample *sample, size_t n,
                                      struct um_quat *out)
{
  enum um_status status = UM_OK;
  struct um_orbit_attitude *frame = NULL;
  struct um_orbit_attitude_law law = {.kind = lvlh ? UM_ATTITUDE_LVLH : UM_ATTITUDE_FIXED,
                                      .from_tai = -INFINITY,
                                      .q = {1.0, 0.0, 0.0, 0.0}};
  UM_TRY(um_orbit_attitude_create(context, &law, 1, &frame));
  for (size_t i = 0; i < n; i++) {
    const struct um_environment_sample *s = &sample[i];
    struct um_orbit_attitude_input in = {s->t_tai, s->r, s->v, s->sun, s->to_observer, NULL};
    UM_CHECK(um_orbit_attitude_at(context, frame, &in, &out[i]));
  }
done:
  um_orbit_attitude_destroy(&frame);
  return status;
}

/* Only a radiant intensity is the satellite's own. */
static enum um_status check_rows(struct um_context *context,
                                 const struct um_compare_spin_data *data,
                                 const struct um_model_tables *tables)
{
  const struct um_compare_on_map *on_map = data->on_map;
  const struct um_compare_measurements *m = on_map->measurements;
  for (size_t i = 0; i < data->count; i++) {
    const struct um_compare_map_row *row = &on_map->row[data->row[i].on_map];
    const struct um_compare_measurement *from = &m->row[row->row];
    if (m->channel[from->channel].quantity == UM_QUANTITY_RADIANT_INTENSITY ||
        !tables->hidden[row->observation])
      continue;
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s:%d: column 'time_utc': the satellite is below the horizon then; "
                        "accepted: radiant_intensity, or a flag that leaves the row out",
                        m->path, from->line);
  }
  return UM_OK;
}

enum um_status um_compare_spin_light_create(struct um_context *context,
                                            const struct um_compare_spin_data *data,
                                            struct um_compare_spin_light **out)
{
  enum um_status status;
  struct um_compare_spin_light *light = NULL;
  struct um_model_instants instants = um_compare_plan_instants(data->on_map->plan);
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *light, &light));
  UM_CHECK(um_model_precompute_unposed(context, data->model, &instants, &light->tables));
  size_t n = light->tables->nobs * light->tables->nsub;
  UM_CHECK(um_core_allocate(context, n, sizeof *light->frame, &light->frame));
  UM_CHECK(um_compare_spin_frames(context, data->lvlh, light->tables->sample, n, light->frame));
  UM_CHECK(um_core_allocate(context, data->count, sizeof *light->row, &light->row));
  for (size_t i = 0; i < data->count; i++)
    light->row[i] = data->on_map->row[data->row[i].on_map].row;
  UM_CHECK(um_core_allocate(context, data->on_map->measurements->count, sizeof *light->value,
                            &light->value));
  UM_CHECK(check_rows(context, data, light->tables));
  *out = light;
  light = NULL;
done:
  um_compare_spin_light_destroy(context, &light);
  return status;
}

void um_compare_spin_light_destroy(struct um_context *context, struct um_compare_spin_light **light)
{
  if (light == NULL || *light == NULL) return;
  um_model_tables_destroy(context, &(*light)->tables);
  UM_FREE(context, (*light)->frame, (*light)->row, (*light)->value, *light);
  *light = NULL;
}

bool um_compare_spin_has_between(const struct um_model *model)
{
  return model->environment.inter_reflection_on &&
         model->scenario->optics->interreflection_samples > 0;
}

/* From a run to reflectivities of the rows. */
static void read_rows(const struct um_compare_spin_data *data, const struct um_model_result *result,
                      double *value)
{
  const struct um_compare_spin_light *light = data->light;
  const struct um_compare_on_map *on_map = data->on_map;
  for (size_t i = 0; i < data->count; i++) {
    const struct um_compare_map_row *row = &on_map->row[data->row[i].on_map];
    size_t channel = on_map->measurements->row[row->row].channel;
    light->value[row->row] =
        um_compare_predict_at(on_map->plan, light->tables, result, channel, row->observation);
  }
  um_compare_modelled(on_map->measurements, data->count, light->row, light->value, value);
  for (size_t i = 0; i < data->count; i++) value[i] /= on_map->row[data->row[i].on_map].light;
}

enum um_status um_compare_spin_light_of(struct um_context *context,
                                        const struct um_compare_spin_data *data,
                                        const struct um_compare_spin_law *law, bool between,
                                        double *value)
{
  struct um_compare_spin_light *light = data->light;
  struct um_model_tables *tables = light->tables;
  struct um_model model = *data->model;
  struct um_model_result *result = NULL;
  model.environment.inter_reflection_on = between && model.environment.inter_reflection_on;
  for (size_t i = 0; i < tables->nobs * tables->nsub; i++) {
    double t = tables->sample[i].t_tai - data->at_tai;
    tables->sample[i].q = um_quat_then(light->frame[i], um_compare_spin_attitude(data, law, t));
  }
  um_core_quiet_begin(context);
  enum um_status status =
      um_model_precompute_posed(context, &model, (struct um_model_sampling){0, 0}, true, tables);
  if (status == UM_OK) status = um_model_run_cold(context, &model, tables, &result);
  um_core_quiet_end(context);
  if (status == UM_OK) read_rows(data, result, value);
  um_model_result_destroy(context, &result);
  return status;
}
