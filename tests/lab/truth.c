/* What really happens: the world's scenario with what is hidden, on a finer mesh with a node per
 * facet, more samples, finer bins and tolerances than the analyst has. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "evidence/inversion/synth.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "orbit/time.h"
#include "tests/lab/lab.h"

static void put_jump(FILE *file, double t, double from, double to)
{
  char text[32];
  um_orbit_time_format(t, text);
  fprintf(file, "%s,%.9g\n%s,%.9g\n", text, from, text, to);
}

/* The heat alone, added to what the scenario states: a jump is two rows of one time, a decay has a
 * row a second. */
static enum um_status write_power(struct um_context *context, double start,
                                  const struct lab_pulse *pulse, const char *path)
{
  double from = start + pulse->from_s, end = start + LAB_PULSE_END + 60.0;
  FILE *file = fopen(path, "w");
  if (file == NULL) return um_core_fail(context, UM_ERR_IO, "%s: cannot be written", path);
  fputs("time_utc,power_W\n", file);
  put_jump(file, start - 86400.0, 0.0, 0.0);
  if (pulse->shape == UM_HEAT_DECAY) put_jump(file, from, 0.0, pulse->power);
  for (double t = 1.0; pulse->shape == UM_HEAT_DECAY && from + t < end; t += 1.0) {
    double power = pulse->power * exp(-t / pulse->last_s);
    put_jump(file, from + t, power, power);
  }
  for (double t = from; pulse->shape != UM_HEAT_DECAY && t < end; t += pulse->period_s) {
    put_jump(file, t, 0.0, pulse->power);
    put_jump(file, pulse->shape == UM_HEAT_STEP ? end : t + pulse->last_s, pulse->power, 0.0);
    if (pulse->shape != UM_HEAT_PERIODIC) break;
  }
  put_jump(file, start + 86400.0, 0.0, 0.0);
  bool failed = ferror(file) != 0;
  failed |= fclose(file) != 0;
  return failed ? um_core_fail(context, UM_ERR_IO, "%s: writing failed", path) : UM_OK;
}

static enum um_status build(struct um_context *context, const struct lab_case *c, bool plain,
                            const char *power, struct lab_truth *out)
{
  const char *override[LAB_FINE + LAB_KEYS + 1];
  char path[LAB_TEXT * 4], with[LAB_HIDDEN][LAB_TEXT], key[LAB_TEXT * 6];
  const char *withs[LAB_HIDDEN];
  size_t n = 0;
  for (size_t i = 0; i < LAB_KEYS && c->world->set[i] != NULL; i++)
    override[n++] = c->world->set[i];
  for (size_t i = 0; i < LAB_FINE && !plain; i++) override[n++] = lab_fine[i];
  if (power != NULL) {
    snprintf(key, sizeof key, "%s=%s", c->pulse->key, power);
    override[n++] = key;
  }
  for (size_t i = 0; i < c->nhidden; i++) {
    if (!lab_hidden_with(c->world, &c->hidden[i], with[i], sizeof with[i]))
      return um_core_fail(context, UM_ERR_INPUT, "lab: no effect '%s'", c->hidden[i].effect);
    withs[i] = with[i];
  }
  struct um_model_options options = {
      .overrides = override, .noverride = n, .with = withs, .nwith = c->nhidden};
  if (plain && c->world->without != NULL) {
    options.without = &c->world->without;
    options.nwithout = 1;
  }
  lab_world_path(c->world, path);
  return um_model_create(context, path, &options, &out->model);
}

enum um_status lab_truth_create(struct um_context *context, const struct lab_case *c, bool plain,
                                const char *folder, struct lab_truth *out)
{
  enum um_status status;
  *out = (struct lab_truth){.world = c->world};
  UM_CHECK(build(context, c, plain, NULL, out));
  if (c->pulse != NULL && !plain) { /* the table needs the times of the scenario */
    char path[LAB_TEXT * 4], *absolute = NULL;
    snprintf(path, sizeof path, "%s/power-%s-%s-%llu.csv", folder,
             um_thermal_course_name(c->pulse->shape), c->pulse->place, (unsigned long long)c->seed);
    UM_CHECK(write_power(context, out->model->scenario->time->start, c->pulse, path));
    absolute = realpath(path, NULL);
    um_model_destroy(context, &out->model);
    status = build(context, c, plain, absolute, out);
    free(absolute);
    if (status != UM_OK) goto done;
  }
  UM_CHECK(um_model_precompute(context, out->model, &out->tables));
  UM_CHECK(um_model_run(context, out->model, out->tables, &out->result));
done:
  if (status != UM_OK) lab_truth_release(context, out);
  return status;
}

void lab_truth_release(struct um_context *context, struct lab_truth *truth)
{
  um_model_result_destroy(context, &truth->result);
  um_model_tables_destroy(context, &truth->tables);
  um_model_destroy(context, &truth->model);
}

static bool is_listed(const char *list, const char *name)
{
  size_t n = strlen(name);
  if (list == NULL) return true;
  for (const char *at = list; *at != '\0';) {
    size_t length = strcspn(at, ",");
    if (length == n && strncmp(at, name, n) == 0) return true;
    at += length + (at[length] == ',' ? 1 : 0);
  }
  return false;
}

static bool is_kept(const struct lab_truth *truth, const struct um_compare_channel *channel,
                    size_t k, double t)
{
  const struct lab_filter *f = &truth->world->filter;
  const struct um_model_tables *tables = truth->tables;
  double since = t - tables->t_obs[0], sunlit = tables->sunlit[k];
  double elevation = tables->look[k * tables->nsub + tables->nsub / 2].elevation / UM_DEG;
  bool heat = channel->quantity == UM_QUANTITY_TEMPERATURE;
  if (!is_listed(f->channels, channel->of)) return false;
  if (f->every > 1 && k % f->every != 0) return false;
  if (heat && f->temperatures_every > 1 && k % f->temperatures_every != 0) return false;
  if (f->sunlit_to > 0.0 && !(sunlit >= f->sunlit_from && sunlit <= f->sunlit_to)) return false;
  if (f->to_s > 0.0 && !(since >= f->from_s && since <= f->to_s)) return false;
  return !(elevation < f->elevation_from_deg);
}

/* A noise of its own for every case: 53 bits, as seeds of files have. */
static uint64_t noise_of(const struct lab_case *c)
{
  char hidden[LAB_TEXT];
  uint64_t key = um_core_hash(c->seed, c->nhidden);
  lab_case_hidden(c, hidden);
  for (const char *at = hidden; *at != '\0'; at++) key = um_core_hash(key, (unsigned char)*at);
  for (const char *at = c->world->name; *at != '\0'; at++)
    key = um_core_hash(key, (unsigned char)*at);
  return key >> 11;
}

enum um_status lab_truth_measure(struct um_context *context, const struct lab_truth *truth,
                                 const struct lab_case *c, struct um_compare_measurements **out)
{
  const struct lab_world *w = truth->world;
  struct um_compare_synth options = {.relative = w->relative,
                                     .floor = w->floor,
                                     .seed = noise_of(c),
                                     .place = w->place,
                                     .temperature_sigma = w->kelvin};
  while (options.nplace < LAB_PLACES && w->place[options.nplace] != NULL) options.nplace++;
  UM_TRY(um_compare_synth_create(context, truth->model, truth->tables, truth->result, &options,
                                 w->name, out));
  for (size_t i = 0, k = 0; i < (*out)->count; i++) {
    struct um_compare_measurement *row = &(*out)->row[i];
    while (k + 1 < truth->tables->nobs && truth->tables->t_obs[k] < row->t_tai) k++;
    row->flag = is_kept(truth, &(*out)->channel[row->channel], k, row->t_tai) ? 0 : 1;
  }
  return UM_OK;
}
