/* refined.csv and error.csv of a map. */
#include <math.h>

#include "base/core/constants.h"
#include "output/csv_impl.h"
#include "output/map.h"

enum um_status um_output_write_map_refined(struct um_context *context,
                                           const struct um_output_map *of, FILE *file)
{
  const struct um_model_map *map = of->map;
  size_t grid = map->planes * map->nlatitude * map->nlongitude;
  fputs("phase_angle_deg,plane_deg,latitude_deg,longitude_deg", file);
  for (size_t b = 0; b < map->nband; b++) {
    um_core_csv_put_text(file, of->model->band[b].name, "_m2_sr");
    um_core_csv_put_text(file, of->model->band[b].name, "_stderr_m2_sr");
  }
  fputc('\n', file);
  for (size_t i = grid; i < map->nnode; i++) {
    const struct um_model_map_added *at = &map->added[i - grid];
    if (i % 4096 == 0) UM_TRY(um_core_stop_check(context, "the map was written"));
    fprintf(file, "%.9g", map->phase_angle[at->phase] / UM_DEG);
    um_core_csv_put_number(file, map->turn * at->plane / (double)map->nplane[at->phase] / UM_DEG);
    um_core_csv_put_number(file, at->latitude / UM_DEG);
    um_core_csv_put_number(file, at->longitude / UM_DEG);
    for (size_t b = 0; b < map->nband; b++) {
      um_core_csv_put_number(file, map->value[i * map->nband + b]);
      um_core_csv_put_number(file, map->error[i * map->nband + b]);
    }
    fputc('\n', file);
  }
  return UM_OK;
}

enum um_status um_output_write_map_error(struct um_context *context, const struct um_output_map *of,
                                         FILE *file)
{
  size_t nband = of->map->nband;
  (void)context;
  fputs("band,where,places,mean_m2_sr,rms_m2_sr,largest_m2_sr,latitude_deg,longitude_deg,"
        "phase_angle_deg,plane_deg\n",
        file);
  for (size_t b = 0; b < nband; b++)
    for (int where = 0; where < UM_MAP_WHERES; where++) {
      const struct um_model_map_off *off = &of->error->off[(size_t)where * nband + b];
      if (of->error->n[where] == 0) continue;
      fprintf(file, "%s,%s,%zu", of->model->band[b].name,
              um_model_map_where_name((enum um_model_map_where)where), of->error->n[where]);
      um_core_csv_put_number(file, off->mean);
      um_core_csv_put_number(file, off->rms);
      um_core_csv_put_number(file, off->largest);
      um_core_csv_put_number(file, off->at.latitude / UM_DEG);
      um_core_csv_put_number(file, off->at.longitude / UM_DEG);
      um_core_csv_put_number(file, off->at.phase_angle / UM_DEG);
      um_core_csv_put_number(file, off->at.plane / UM_DEG);
      fputc('\n', file);
    }
  return UM_OK;
}
