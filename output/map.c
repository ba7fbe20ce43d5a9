/* map.csv, pass.csv and map.exr. */
#include "output/map.h"

#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "output/csv_impl.h"
#include "output/exr_impl.h"

#define NAME 200 /* [bytes] of a channel's */

static double latitude_at(const struct um_model_map *map, size_t i)
{
  return -90.0 + (double)i * map->step / UM_DEG;
}

static double longitude_at(const struct um_model_map *map, size_t j)
{
  return -180.0 + (double)j * map->step / UM_DEG;
}

enum um_status um_output_write_map(struct um_context *context, const struct um_output_map *of,
                                   FILE *file)
{
  const struct um_model_map *map = of->map;
  fputs("phase_angle_deg,latitude_deg,longitude_deg", file);
  for (size_t b = 0; b < map->nband; b++) {
    um_core_csv_put_text(file, of->model->band[b].name, "_m2_sr");
    um_core_csv_put_text(file, of->model->band[b].name, "_spread_m2_sr");
    um_core_csv_put_text(file, of->model->band[b].name, "_stderr_m2_sr");
  }
  fputc('\n', file);
  for (size_t g = 0; g < map->nphase; g++)
    for (size_t i = 0; i < map->nlatitude; i++) {
      UM_TRY(um_core_stop_check(context, "the map was written"));
      for (size_t j = 0; j < map->nlongitude; j++) {
        fprintf(file, "%.9g", map->phase_angle[g] / UM_DEG);
        um_core_csv_put_number(file, latitude_at(map, i));
        um_core_csv_put_number(file, longitude_at(map, j));
        for (size_t b = 0; b < map->nband; b++) {
          struct um_model_map_node node = um_model_map_node(map, g, i, j, b);
          um_core_csv_put_number(file, node.mean);
          um_core_csv_put_number(file, node.spread);
          um_core_csv_put_number(file, node.error);
        }
        fputc('\n', file);
      }
    }
  return UM_OK;
}

static void vector(FILE *file, struct um_vec3 v)
{
  um_core_csv_put_number(file, v.x);
  um_core_csv_put_number(file, v.y);
  um_core_csv_put_number(file, v.z);
}

enum um_status um_output_write_map_pass(struct um_context *context, const struct um_output_map *of,
                                        FILE *file)
{
  const struct um_model_map_pass *p = of->pass;
  fputs("time_utc,latitude_deg,longitude_deg,phase_angle_deg,plane_deg,sunlit_fraction,range_km,"
        "sun_x,sun_y,sun_z,observer_x,observer_y,observer_z",
        file);
  for (size_t b = 0; b < p->nband; b++) {
    const char *name = of->model->band[b].name;
    um_core_csv_put_text(file, name, "_looked_up_W_sr");
    um_core_csv_put_text(file, name, "_smallest_phase_angle_W_sr");
    um_core_csv_put_text(file, name, "_direct_W_sr");
    um_core_csv_put_text(file, name, "_stderr_W_sr");
  }
  fputc('\n', file);
  for (size_t i = 0; i < p->n; i++) {
    UM_TRY(um_core_stop_check(context, "the map was written"));
    um_output_csv_time(file, p->t[i]);
    um_core_csv_put_number(file, p->at[i].latitude / UM_DEG);
    um_core_csv_put_number(file, p->at[i].longitude / UM_DEG);
    um_core_csv_put_number(file, p->at[i].phase_angle / UM_DEG);
    um_core_csv_put_number(file, p->at[i].plane / UM_DEG);
    um_core_csv_put_number(file, p->sample[i].sunlit_fraction);
    um_core_csv_put_number(file, 1e-3 * p->sample[i].range);
    vector(file, p->sun[i]);
    vector(file, p->observer[i]);
    for (size_t b = 0; b < p->nband; b++) {
      size_t at = i * p->nband + b;
      um_core_csv_put_number(file, p->light[at] * p->looked_up[at]);
      um_core_csv_put_number(file, p->light[at] * p->smallest[at]);
      um_core_csv_put_number(file, p->light[at] * p->direct[at]);
      um_core_csv_put_number(file, p->light[at] * p->error[at]);
    }
    fputc('\n', file);
  }
  return UM_OK;
}

/* ---- OpenEXR ---- */

struct source {
  const struct um_model_map *map;
  double largest; /* of the first plane [m^2/sr] */
};

/* R, G, B, then mean and spread of every phase angle of every band. */
static void row(const void *self, int y, float *value)
{
  const struct source *source = self;
  const struct um_model_map *map = source->map;
  size_t i = map->nlatitude - 1 - (size_t)y;
  for (size_t x = 0; x < map->nlongitude; x++) {
    float *grey = value, *first = value + 3;
    value += 3;
    for (size_t b = 0; b < map->nband; b++)
      for (size_t g = 0; g < map->nphase; g++, value += 2) {
        struct um_model_map_node node = um_model_map_node(map, g, i, x, b);
        value[0] = (float)node.mean;
        value[1] = (float)node.spread;
      }
    for (size_t c = 0; c < 3; c++)
      grey[c] = source->largest > 0.0 ? *first / (float)source->largest : 0.0f;
  }
}

static void fill_names(const struct um_output_map *of, char *text, char **name)
{
  size_t n = 3;
  for (size_t i = 0; i < 3; i++) {
    name[i] = text + i * NAME;
    name[i][0] = "RGB"[i];
  }
  for (size_t b = 0; b < of->map->nband; b++)
    for (size_t g = 0; g < of->map->nphase; g++)
      for (int spread = 0; spread < 2; spread++, n++) {
        char angle[32], *dot;
        snprintf(angle, sizeof angle, "%g", of->map->phase_angle[g] / UM_DEG);
        if ((dot = strchr(angle, '.')) != NULL) *dot = ',';
        name[n] = text + n * NAME;
        snprintf(name[n], NAME, "%.150s.%sdeg.%s", of->model->band[b].name, angle,
                 spread ? "spread" : "mean");
      }
}

enum um_status um_output_write_map_exr(struct um_context *context, const struct um_output_map *of,
                                       const char *path)
{
  static const char *const text[][2] = {
      {"units", "m^2/sr"},
      {"projection", "equirectangular: latitude 90 to -90 deg downward, longitude -180 deg at the "
                     "left, pixel centres at the nodes"}};
  static const char *const number_name[] = {"stepDeg"};
  enum um_status status;
  const struct um_model_map *map = of->map;
  struct source source = {map, 0.0};
  double step = map->step / UM_DEG;
  size_t n = 3 + 2 * map->nband * map->nphase;
  char *names = NULL, **name = NULL;
  for (size_t i = 0; i < map->nlatitude; i++)
    for (size_t j = 0; j < map->nlongitude; j++)
      source.largest = fmax(source.largest, um_model_map_node(map, 0, i, j, 0).mean);
  UM_CHECK(um_core_allocate(context, n, NAME, &names));
  UM_CHECK(um_core_allocate(context, n, sizeof *name, &name));
  fill_names(of, names, name);
  struct um_output_planes planes = {.whole_width = (int)map->nlongitude,
                                    .whole_height = (int)map->nlatitude,
                                    .width = (int)map->nlongitude,
                                    .height = (int)map->nlatitude,
                                    .part = "reflectivity",
                                    .nplane = n,
                                    .name = name,
                                    .row = row,
                                    .self = &source,
                                    .ntext = 2,
                                    .text = text,
                                    .nnumber = 1,
                                    .number_name = number_name,
                                    .number = &step};
  UM_CHECK(um_output_write_planes(context, &planes, path));
done:
  UM_FREE(context, names, name);
  return status;
}
