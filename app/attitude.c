/* umbra attitude: spins that agree with measured light. */
#include <math.h>
#include <string.h>

#include "app/app.h"
#include "app/map_options.h"
#include "app/terminal.h"
#include "base/core/constants.h"
#include "base/core/file.h"
#include "base/core/number.h"
#include "evidence/inversion/spin.h"
#include "evidence/measurements/measurements.h"
#include "evidence/measurements/time_text.h"
#include "model/build/build.h"

#define COARSE_STEP  3.0 /* of the map [deg] */
#define PHASES       4   /* of the map, where none are stated */
#define PERIOD_RANGE 0.1 /* to both sides of the scenario's [1] */
#define TOLD_APART   3.0 /* [sigma] */
#define AGREES       4.0 /* reduced chi-square of the best, at most */

struct work {
  struct um_model *model;
  struct um_model_map *map;
  struct um_compare_measurements *measurements;
  struct um_compare_on_map *on_map;
  struct um_compare_spins *spins;
  struct um_core_folder *folder;
  char *out;
};

/* ---- options ---- */

static int misuse(const char *what)
{
  fprintf(stderr, "umbra: %s\n", what);
  return UM_APP_MISUSE;
}

/* "200" or "200,220". */
static bool range(const char *text, double out[2])
{
  char first[64];
  size_t n = strcspn(text, ",");
  if (n >= sizeof first) return false;
  memcpy(first, text, n);
  first[n] = '\0';
  if (!um_core_number_parse(first, &out[0])) return false;
  out[1] = out[0];
  if (text[n] == ',' && !um_core_number_parse(text + n + 1, &out[1])) return false;
  return out[0] > 0.0 && out[1] >= out[0];
}

/* period_least 0: the scenario's. */
static int options_parse(const struct um_app_options *options, struct um_compare_spin_search *s)
{
  double step = UM_APP_AXIS_STEP, period[2] = {0.0, 0.0};
  if (options->axis_step != NULL && !um_core_number_parse(options->axis_step, &step))
    return misuse("--axis-step takes a number [deg]");
  if (!(step >= 1.0 && step <= 45.0)) return misuse("--axis-step takes 1 to 45 deg");
  if (options->period != NULL && !range(options->period, period))
    return misuse("--period takes one number above 0, or two with a comma between, rising [s]");
  *s = (struct um_compare_spin_search){.axis_step = step * UM_DEG,
                                       .turn_step = 0.5 * step * UM_DEG,
                                       .period_least = period[0],
                                       .period_most = period[1],
                                       .keep = options->solutions > 0 ? (size_t)options->solutions
                                                                      : UM_APP_SOLUTIONS};
  return UM_APP_DONE;
}

static void period_of_scenario(const struct um_model *model, struct um_compare_spin_search *s)
{
  const struct um_schema_list *list = &model->scenario->attitude;
  const struct um_scenario_attitude *law = list->items;
  if (s->period_least > 0.0 || list->count == 0 || law->spin == NULL) return;
  double period = fabs(law->spin->period_s);
  s->period_least = (1.0 - PERIOD_RANGE) * period;
  s->period_most = (1.0 + PERIOD_RANGE) * period;
}

/* Phase angles of a map that holds all measurements. */
static void phases_of_rows(const struct um_compare_on_map *on_map, struct um_app_map_options *o)
{
  double least = UM_PI, most = 0.0;
  for (size_t i = 0; i < on_map->count; i++) {
    const struct um_environment_sample *s = &on_map->sample[on_map->row[i].observation];
    double angle = um_vec3_angle(s->sun, s->to_observer);
    least = fmin(least, angle);
    most = fmax(most, angle);
  }
  most = fmin(most, 179.0 * UM_DEG);
  least = fmin(least, most);
  size_t n = most - least > 1.0 * UM_DEG ? PHASES : 1;
  for (size_t i = 0; i < n; i++)
    o->phase_angle[i] =
        n == 1 ? 0.5 * (least + most) : least + (most - least) * (double)i / (double)(n - 1);
  o->grid.nphase = n;
}

/* ---- what is said ---- */

static double reduced(const struct um_compare_spins *spins, size_t i)
{
  return spins->spin[i].chi2 / ((double)spins->nobservation - 4.0);
}

/* Solutions that agree with the measurements and cannot be told apart. */
static size_t agreeing(const struct um_compare_spins *spins)
{
  size_t n = 0;
  if (reduced(spins, 0) > AGREES) return 0;
  while (n < spins->count && spins->spin[n].apart < TOLD_APART) n++;
  return n;
}

static void print_all(const struct work *w)
{
  const struct um_compare_spins *s = w->spins;
  char at[40];
  um_compare_time_text(s->at_tai, at);
  printf("%s against %s: %zu observations of sunlight, %zu in the shadow left out; %zu laws "
         "looked up, %zu solutions fitted\n",
         w->model->scenario->name, w->measurements->path, s->nobservation, w->on_map->dark, s->nlaw,
         s->count);
  printf("axis in %s, phase at %s; apart from the best [sigma]: below %g not told apart, %zu\n",
         s->lvlh ? "the orbital frame (axis_lvlh)" : "GCRS (axis_gcrs)", at, TOLD_APART,
         agreeing(s));
  printf("%4s %28s %12s %11s %11s %9s %22s\n", "", "axis", "period [s]", "phase [deg]", "chi2/dof",
         "apart", "sigma of axis, phase");
  for (size_t i = 0; i < s->count; i++) {
    const struct um_compare_spin *p = &s->spin[i];
    printf("%4zu   %8.5f %8.5f %8.5f %12.3f %11.2f %11.4g %9.3g %12.2g %5.2g deg\n", i + 1,
           p->axis.x, p->axis.y, p->axis.z, p->period, p->phase / UM_DEG, reduced(s, i), p->apart,
           p->axis_sigma / UM_DEG, p->phase_sigma / UM_DEG);
  }
  if (agreeing(s) == 0)
    printf(
        "no solution agrees: reduced chi-square of the best %.3g. The right one lies between the "
        "axes and periods that were tried, or outside them, or the scenario lacks what the light "
        "shows; a finer --axis-step and --step look closer\n",
        reduced(s, 0));
  const struct um_compare_spin *best = &s->spin[0];
  printf("the best as keys: --set attitude.0.spin.axis_%s=[%.6f,%.6f,%.6f] --set "
         "attitude.0.spin.period_s=%.6g --set attitude.0.spin.phase_deg=%.4f --set "
         "attitude.0.spin.at_utc=%s\n",
         s->lvlh ? "lvlh" : "gcrs", best->axis.x, best->axis.y, best->axis.z, best->period,
         best->phase / UM_DEG, at);
  um_app_tell_results(w->out);
}

static void json_all(const struct work *w)
{
  const struct um_compare_spins *s = w->spins;
  char at[40];
  um_compare_time_text(s->at_tai, at);
  um_core_json_text(stdout, "{", "name", w->model->scenario->name);
  um_core_json_text(stdout, ", ", "folder", w->out);
  printf(", \"observations\": %zu, \"rows_in_shadow\": %zu, \"laws\": %zu, \"at_utc\": \"%s\", "
         "\"frame\": \"%s\", \"not_told_apart\": %zu,\n  \"solutions\": [",
         s->nobservation, w->on_map->dark, s->nlaw, at, s->lvlh ? "lvlh" : "gcrs", agreeing(s));
  for (size_t i = 0; i < s->count; i++) {
    const struct um_compare_spin *p = &s->spin[i];
    printf("%s\n    {\"axis\": [%.9g, %.9g, %.9g]", i > 0 ? "," : "", p->axis.x, p->axis.y,
           p->axis.z);
    um_core_json_field(stdout, ", ", "period_s", p->period);
    um_core_json_field(stdout, ", ", "phase_deg", p->phase / UM_DEG);
    um_core_json_field(stdout, ", ", "chi2", p->chi2);
    um_core_json_field(stdout, ", ", "reduced_chi2", reduced(s, i));
    um_core_json_field(stdout, ", ", "apart_sigma", p->apart);
    um_core_json_field(stdout, ", ", "axis_sigma_deg", p->axis_sigma / UM_DEG);
    um_core_json_field(stdout, ", ", "period_sigma_s", p->period_sigma);
    um_core_json_field(stdout, ", ", "phase_sigma_deg", p->phase_sigma / UM_DEG);
    printf("}");
  }
  printf("]}\n");
}

/* ---- the command ---- */

static enum um_status write_all(struct um_context *context, struct work *w)
{
  FILE *file = NULL;
  UM_TRY(um_core_folder_open(context, w->folder, "attitude.csv", &file));
  um_compare_spins_write(w->spins, file);
  UM_TRY(um_core_file_close(context, "attitude.csv", &file));
  return um_core_folder_commit(context, &w->folder);
}

static enum um_status compute(struct um_context *context, const struct um_app_options *options,
                              struct um_compare_spin_search *search, struct um_app_map_options *o,
                              struct work *w)
{
  struct um_model_options changes = um_app_model_options(options);
  UM_TRY(um_compare_measurements_read(context, options->positional[1], &w->measurements));
  UM_TRY(um_model_create(context, options->positional[0], &changes, &w->model));
  UM_TRY(um_compare_on_map_create(context, w->model, w->measurements, &w->on_map));
  UM_TRY(um_app_out_folder(context, options, w->model->scenario->name, &w->out));
  UM_TRY(um_core_folder_begin(context, w->out, options->force, &w->folder));
  period_of_scenario(w->model, search);
  if (options->phase_angles == NULL) phases_of_rows(w->on_map, o);
  UM_TRY(um_compare_spins_check(context, w->model, w->on_map, search));
  UM_TRY(um_model_map_create(context, w->model, &o->grid, &w->map));
  UM_TRY(um_compare_spins_find(context, w->model, w->on_map, w->map, search, &w->spins));
  return write_all(context, w);
}

int um_app_attitude(struct um_context *context, const struct um_app_options *options)
{
  struct work w = {0};
  struct um_app_map_options o;
  struct um_compare_spin_search search;
  int code = um_app_map_options_parse(options, COARSE_STEP, &o);
  if (code == UM_APP_DONE) code = options_parse(options, &search);
  if (code != UM_APP_DONE) return code;
  enum um_status status = compute(context, options, &search, &o, &w);
  um_app_terminal_clear();
  if (status == UM_OK && options->json)
    json_all(&w);
  else if (status == UM_OK)
    print_all(&w);
  um_core_folder_abort(&w.folder);
  um_compare_spins_destroy(context, &w.spins);
  um_model_map_destroy(context, &w.map);
  um_compare_on_map_destroy(context, &w.on_map);
  um_compare_measurements_destroy(context, &w.measurements);
  um_model_destroy(context, &w.model);
  um_core_free(context, w.out);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
