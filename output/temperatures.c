/* temperatures.csv and heat.csv. */
#include <string.h>

#include "output/csv_impl.h"
#include "output/output.h"

enum um_status um_output_write_temperatures(const struct um_output_run *run, FILE *file)
{
  const struct um_model_result *r = run->result;
  fputs("time_utc", file);
  for (size_t p = 0; p < r->nplace; p++) {
    const char *name = r->place[p].name;
    um_core_csv_put_text(file, name, ".mean_K");
    um_core_csv_put_text(file, name, ".min_K");
    um_core_csv_put_text(file, name, ".max_K");
  }
  fputc('\n', file);
  for (size_t k = 0; k < r->nobs; k++) {
    UM_TRY(um_output_stop(run));
    um_output_csv_time(file, run->tables->t_obs[k]);
    for (size_t p = 0; p < r->nplace; p++) {
      um_core_csv_put_number(file, r->place[p].mean[k]);
      um_core_csv_put_number(file, r->place[p].minimum[k]);
      um_core_csv_put_number(file, r->place[p].maximum[k]);
    }
    fputc('\n', file);
  }
  return UM_OK;
}

/* Is the group of this place the only one of its part? */
static bool is_alone(const struct um_output_run *run, size_t place)
{
  const struct um_geometry *geometry = run->model->geometry;
  const char *name = run->model->body->place[place].name;
  size_t groups = 0, length = strcspn(name, ".");
  for (size_t g = 0; g < um_geometry_group_count(geometry); g++) {
    const char *part = um_geometry_part_name(geometry, um_geometry_group(geometry, g)->part);
    groups += strlen(part) == length && strncmp(part, name, length) == 0;
  }
  return groups < 2;
}

/* Whole parts (what radiates), walls under MLI, inner layers that radiate inside and interiors,
 * whose heats add up to the satellite's; groups and their walls, whose heats add up to those of
 * their part and its wall. A part of one group is that group. */
static bool has_row(const struct um_output_run *run, size_t place)
{
  const struct um_thermal_body *body = run->model->body;
  if (place >= body->nplace) return false; /* of a material */
  enum um_thermal_place_kind kind = body->place[place].kind;
  if (kind == UM_PLACE_GROUP || kind == UM_PLACE_GROUP_WALL) return !is_alone(run, place);
  return kind != UM_PLACE_SIDE;
}

enum um_status um_output_write_heat(const struct um_output_run *run, FILE *file)
{
  const struct um_model_result *r = run->result;
  fputs("time_utc,node,solar,albedo,planet,internal,conducted,radiated,exchanged,stored\n", file);
  for (size_t k = 0; k < r->nobs; k++)
    for (size_t p = 0; p < r->nplace; p++) {
      if (!has_row(run, p)) continue;
      UM_TRY(um_output_stop(run));
      const struct um_thermal_heat *h = &r->heat[k * r->nplace + p];
      um_output_csv_time(file, run->tables->t_obs[k]);
      um_core_csv_put_text(file, r->place[p].name, "");
      const double value[] = {h->solar,     h->albedo,   h->planet,    h->internal,
                              h->conducted, h->radiated, h->exchanged, h->stored};
      for (size_t i = 0; i < sizeof value / sizeof value[0]; i++)
        um_core_csv_put_number(file, value[i]);
      fputc('\n', file);
    }
  return UM_OK;
}
