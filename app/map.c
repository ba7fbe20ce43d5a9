/* umbra map: the reflectivity map of the satellite, the pass and measurements on it. */
#include <math.h>
#include <string.h>

#include "app/app.h"
#include "app/map_options.h"
#include "app/terminal.h"
#include "base/core/constants.h"
#include "evidence/inversion/on_map.h"
#include "evidence/measurements/measurements.h"
#include "model/build/build.h"
#include "output/map.h"

/* What one run of the command holds. */
struct work {
  struct um_model *model;
  struct um_model_map *map;
  struct um_model_map_error *error;
  struct um_model_map_pass *pass; /* NULL: no observer, or orbit.points without measurements */
  struct um_compare_measurements *measurements;
  struct um_compare_on_map *on_map;
  struct um_model_map_pass *at_measured;
  struct um_core_folder *folder;
  char *out;
};

/* ---- what is said ---- */

/* The highest node of the grid, and where it is [deg]. */
static struct um_model_map_node highest(const struct work *w, size_t band, double at[2])
{
  const struct um_model_map *map = w->map;
  struct um_model_map_node high = {0.0, 0.0, 0.0};
  at[0] = at[1] = 0.0;
  for (size_t i = 0; i < map->nlatitude; i++)
    for (size_t j = 0; j < map->nlongitude; j++) {
      struct um_model_map_node node = um_model_map_node(map, 0, i, j, band);
      if (!(node.mean > high.mean)) continue;
      high = node;
      at[0] = -90.0 + (double)i * map->step / UM_DEG;
      at[1] = -180.0 + (double)j * map->step / UM_DEG;
    }
  return high;
}

/* How far looking up is off, over all directions and where glints are. */
static void print_off(const struct work *w, size_t b)
{
  static const char *const where[UM_MAP_WHERES] = {"over all directions",
                                                   "within 5 deg of normals"};
  for (int k = 0; k < UM_MAP_WHERES; k++) {
    const struct um_model_map_off *off = &w->error->off[(size_t)k * w->map->nband + b];
    if (w->error->n[k] > 0 && off->mean > 0.0)
      printf("      looking up is off %s by %.2g %% rms and %.2g %% at most, of %.4g m2/sr in the "
             "mean of %zu places\n",
             where[k], 100.0 * off->rms / off->mean, 100.0 * off->largest / off->mean, off->mean,
             w->error->n[k]);
  }
}

static void print_band(const struct work *w, size_t b)
{
  double at[2], mean = um_model_map_mean(w->map, 0, b);
  struct um_model_map_node high = highest(w, b, at);
  printf("%-5s at %g deg: %.4g m2/sr in the mean, %.4g at most, at latitude %.4g, longitude %.4g "
         "deg\n",
         w->model->band[b].name, w->map->phase_angle[0] / UM_DEG, mean, high.mean, at[0], at[1]);
  print_off(w, b);
  if (w->pass == NULL) return;
  struct um_model_map_difference d = um_model_map_difference(w->pass, b);
  if (d.count == 0 || !(d.mean > 0.0)) return;
  printf("      along the pass %.4g W/sr in the mean of %zu instants in sunlight; looked up: bias "
         "%+.2g %%, rms %.2g %%; at %g deg alone: %+.2g %%, %.2g %%\n",
         d.mean, d.count, 100.0 * d.bias / d.mean, 100.0 * d.rms / d.mean,
         w->map->phase_angle[0] / UM_DEG, 100.0 * d.bias_0 / d.mean, 100.0 * d.rms_0 / d.mean);
}

static void print_all(const struct work *w)
{
  size_t grid = w->map->planes * w->map->nlatitude * w->map->nlongitude;
  printf("%s: map of %zu x %zu nodes, %zu phase angles, %zu planes in all\n",
         w->model->scenario->name, w->map->nlongitude, w->map->nlatitude, w->map->nphase,
         w->map->planes);
  if (w->map->tolerance > 0.0)
    printf("%zu nodes of the grid, %zu more where cells are off by more than %g of the larger of "
           "value and mean; %zu cells stay so\n",
           grid, w->map->nnode - grid, w->map->tolerance, w->map->unfinished);
  for (size_t b = 0; b < w->model->nband; b++) print_band(w, b);
  if (w->on_map != NULL)
    printf("%s: %zu rows on the map, %zu in the shadow left out\n", w->measurements->path,
           w->on_map->count, w->on_map->dark);
  um_app_tell_results(w->out);
}

static void json_band(const struct work *w, size_t b)
{
  double at[2], mean = um_model_map_mean(w->map, 0, b);
  struct um_model_map_node high = highest(w, b, at);
  um_core_json_text(stdout, "{", "name", w->model->band[b].name);
  um_core_json_field(stdout, ", ", "mean_m2_sr", mean);
  um_core_json_field(stdout, ", ", "highest_m2_sr", high.mean);
  um_core_json_field(stdout, ", ", "highest_latitude_deg", at[0]);
  um_core_json_field(stdout, ", ", "highest_longitude_deg", at[1]);
  printf(", \"look_up\": [");
  for (int k = 0, n = 0; k < UM_MAP_WHERES; k++) {
    const struct um_model_map_off *off = &w->error->off[(size_t)k * w->map->nband + b];
    if (w->error->n[k] == 0) continue;
    um_core_json_text(stdout, n++ > 0 ? ", {" : "{", "where",
                      um_model_map_where_name((enum um_model_map_where)k));
    printf(", \"places\": %zu", w->error->n[k]);
    um_core_json_field(stdout, ", ", "mean_m2_sr", off->mean);
    um_core_json_field(stdout, ", ", "rms_m2_sr", off->rms);
    um_core_json_field(stdout, ", ", "largest_m2_sr", off->largest);
    printf("}");
  }
  printf("]");
  if (w->pass != NULL) {
    struct um_model_map_difference d = um_model_map_difference(w->pass, b);
    printf(", \"pass_instants\": %zu", d.count);
    um_core_json_field(stdout, ", ", "pass_mean_W_sr", d.mean);
    um_core_json_field(stdout, ", ", "looked_up_bias_W_sr", d.bias);
    um_core_json_field(stdout, ", ", "looked_up_rms_W_sr", d.rms);
    um_core_json_field(stdout, ", ", "smallest_phase_angle_bias_W_sr", d.bias_0);
    um_core_json_field(stdout, ", ", "smallest_phase_angle_rms_W_sr", d.rms_0);
  }
  printf("}");
}

static void json_all(const struct work *w)
{
  um_core_json_text(stdout, "{", "name", w->model->scenario->name);
  um_core_json_text(stdout, ", ", "folder", w->out);
  printf(", \"phase_angles_deg\": [");
  for (size_t g = 0; g < w->map->nphase; g++)
    printf("%s%.9g", g > 0 ? ", " : "", w->map->phase_angle[g] / UM_DEG);
  printf("], \"nodes\": %zu, \"unfinished_cells\": %zu", w->map->nnode, w->map->unfinished);
  if (w->on_map != NULL)
    printf(", \"measured_rows\": %zu, \"rows_in_shadow\": %zu", w->on_map->count, w->on_map->dark);
  printf(",\n  \"bands\": [");
  for (size_t b = 0; b < w->model->nband; b++) {
    printf("%s\n    ", b > 0 ? "," : "");
    json_band(w, b);
  }
  printf("]}\n");
}

/* ---- files ---- */

typedef enum um_status (*writer)(struct um_context *context, const struct um_output_map *of,
                                 FILE *file);

static enum um_status table(struct um_context *context, const struct um_output_map *of,
                            struct um_core_folder *folder, const char *name, writer write)
{
  FILE *file = NULL;
  UM_TRY(um_core_folder_open(context, folder, name, &file));
  enum um_status status = write(context, of, file);
  enum um_status closed = um_core_file_close(context, name, &file);
  return status != UM_OK ? status : closed;
}

static enum um_status measured_table(struct um_context *context, const struct work *w)
{
  FILE *file = NULL;
  UM_TRY(um_core_folder_open(context, w->folder, "measured.csv", &file));
  enum um_status status =
      um_compare_on_map_write(context, w->on_map, w->model, w->at_measured, file);
  enum um_status closed = um_core_file_close(context, "measured.csv", &file);
  return status != UM_OK ? status : closed;
}

static enum um_status write_all(struct um_context *context, const struct um_app_options *options,
                                struct work *w)
{
  struct um_output_map of = {w->model, w->map, w->error, w->pass, w->on_map != NULL};
  const char *folder = um_core_folder_path(w->folder);
  char *exr = NULL;
  UM_TRY(table(context, &of, w->folder, "map.csv", um_output_write_map));
  UM_TRY(table(context, &of, w->folder, "error.csv", um_output_write_map_error));
  if (w->map->tolerance > 0.0)
    UM_TRY(table(context, &of, w->folder, "refined.csv", um_output_write_map_refined));
  if (w->pass != NULL) UM_TRY(table(context, &of, w->folder, "pass.csv", um_output_write_map_pass));
  if (w->on_map != NULL) UM_TRY(measured_table(context, w));
  UM_TRY(um_core_asprintf(context, &exr, "%s/map.exr", folder));
  enum um_status status = um_output_write_map_exr(context, &of, exr);
  um_core_free(context, exr);
  if (status == UM_OK && !options->no_plots) status = um_output_plot_map(context, &of, folder);
  return status == UM_OK ? um_core_folder_commit(context, &w->folder) : status;
}

/* ---- the command ---- */

static enum um_status compute(struct um_context *context, const struct um_app_options *options,
                              const struct um_model_map_grid *grid, struct work *w)
{
  struct um_model_options changes = um_app_model_options(options);
  if (options->npositional > 1)
    UM_TRY(um_compare_measurements_read(context, options->positional[1], &w->measurements));
  UM_TRY(um_model_create(context, options->positional[0], &changes, &w->model));
  if (w->measurements != NULL)
    UM_TRY(um_compare_on_map_create(context, w->model, w->measurements, &w->on_map));
  UM_TRY(um_app_out_folder(context, options, w->model->scenario->name, &w->out));
  UM_TRY(um_core_folder_begin(context, w->out, options->force, &w->folder));
  UM_TRY(um_model_map_create(context, w->model, grid, &w->map));
  UM_TRY(um_model_map_error_measure(context, w->model, w->map, &w->error));
  if (w->model->has_observer && !w->model->points)
    UM_TRY(um_model_map_pass_create(context, w->model, w->map, &w->pass));
  if (w->on_map != NULL)
    UM_TRY(um_model_map_pass_of(context, w->model, w->map, w->on_map->sample, w->on_map->plan->time,
                                w->on_map->plan->ntime, &w->at_measured));
  return UM_OK;
}

int um_app_map(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct work w = {0};
  struct um_app_map_options o;
  int code = um_app_map_options_parse(options, UM_APP_MAP_STEP, &o);
  if (code != UM_APP_DONE) return code;
  UM_CHECK(compute(context, options, &o.grid, &w));
  UM_CHECK(write_all(context, options, &w));
  um_app_terminal_clear();
  if (options->json)
    json_all(&w);
  else
    print_all(&w);
done:
  um_core_folder_abort(&w.folder);
  um_model_map_pass_destroy(context, &w.at_measured);
  um_model_map_pass_destroy(context, &w.pass);
  um_model_map_error_destroy(context, &w.error);
  um_model_map_destroy(context, &w.map);
  um_compare_on_map_destroy(context, &w.on_map);
  um_compare_measurements_destroy(context, &w.measurements);
  um_model_destroy(context, &w.model);
  um_core_free(context, w.out);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
