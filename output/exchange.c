/* Exchange between surfaces as tables, for those who check it or take it elsewhere. */
#include "output/exchange.h"

#include <math.h>
#include <stdio.h>

#include "base/core/csv.h"
#include "geometry/inside.h"

static enum um_status write_room(struct um_context *context, const struct um_model *model,
                                 const struct um_geometry_view_factor_table *table, size_t room,
                                 struct um_core_folder *folder)
{
  char *name = NULL;
  FILE *file = NULL;
  UM_TRY(um_core_asprintf(context, &name, "inside-%s.csv",
                          um_geometry_part_name(model->geometry, table->room[room].part)));
  enum um_status status = um_core_folder_open(context, folder, name, &file);
  if (status == UM_OK) {
    status = um_geometry_inside_write(context, model->geometry, table, room, file);
    enum um_status closed = um_core_file_close(context, name, &file);
    if (status == UM_OK) status = closed;
  }
  um_core_free(context, name);
  return status;
}

/* "bus.+x", "array.plate.back", "bus.+x.inside": of a patch's first surface. */
static void put_place(const struct um_model *model,
                      const struct um_geometry_view_factor_table *table, size_t p, FILE *file)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  uint32_t s = table->patches->surface[table->patches->begin[p]];
  bool inside = s >= mesh->nsurface;
  size_t facet = inside ? s - mesh->nsurface : mesh->surface[s].facet;
  char name[1024];
  snprintf(name, sizeof name, "%s.%s",
           um_geometry_part_name(model->geometry, mesh->facet_part[facet]),
           um_geometry_group(model->geometry, mesh->facet_group[facet])->name);
  um_core_csv_put(file, name, inside ? ".inside" : mesh->surface[s].back ? ".back" : "");
}

/* Emittance times area [m^2]. */
static double emission_of(const struct um_model *model,
                          const struct um_geometry_view_factor_table *table, size_t p)
{
  double sum = 0.0;
  for (size_t i = table->patches->begin[p]; i < table->patches->begin[p + 1]; i++) {
    const struct um_thermal_surface *s =
        um_thermal_network_surface(model->body->network, table->patches->surface[i]);
    if (s != NULL) sum += s->area * s->emittance;
  }
  return sum;
}

static void put_row(const struct um_model *model, const struct um_geometry_view_factor_table *table,
                    const struct um_thermal_exchange *exchange, size_t pose, size_t p, FILE *file)
{
  struct um_thermal_exchange_row row = um_thermal_exchange_row(exchange, pose, p);
  double space = emission_of(model, table, p);
  char text[32];
  for (size_t e = 0; e < row.n; e++) {
    space -= row.area[e];
    if (row.other[e] <= p) continue; /* both ways are one number, oneself is none */
    um_core_number_text(row.area[e], text);
    fprintf(file, "%zu,%zu,%u,%s,", pose, p, (unsigned)row.other[e], text);
    put_place(model, table, p, file);
    fputc(',', file);
    put_place(model, table, row.other[e], file);
    fputc('\n', file);
  }
  if (p >= table->noutside) return; /* a room has no way out */
  um_core_number_text(fmax(space, 0.0), text);
  fprintf(file, "%zu,%zu,space,%s,", pose, p, text);
  put_place(model, table, p, file);
  fprintf(file, ",space\n");
}

static enum um_status write_couplings(struct um_context *context, const struct um_model *model,
                                      const struct um_geometry_view_factor_table *table,
                                      const struct um_thermal_exchange *exchange,
                                      struct um_core_folder *folder)
{
  FILE *file = NULL;
  UM_TRY(um_core_folder_open(context, folder, "couplings.csv", &file));
  fprintf(file,
          "# total exchange areas [m2] between patches, emittances (of records: at 300 K) and "
          "all reflections included: sigma times it times (T_from^4 - T_to^4) flows; patches are "
          "those of "
          "outside.csv, then those of inside-*.csv\n"
          "pose,from,to,exchange_area_m2,from_place,to_place\n");
  for (size_t k = 0; k < table->npose; k++)
    for (size_t p = 0; p < table->patches->npatch; p++)
      if (k == 0 || p < table->noutside) put_row(model, table, exchange, k, p, file);
  return um_core_file_close(context, "couplings.csv", &file);
}

enum um_status um_output_write_exchange(struct um_context *context, const struct um_model *model,
                                        const struct um_geometry_view_factor_table *table,
                                        const struct um_thermal_exchange *exchange,
                                        struct um_core_folder *folder)
{
  FILE *file = NULL;
  UM_TRY(um_core_folder_open(context, folder, "outside.csv", &file));
  um_geometry_view_factor_table_write(model->geometry, table, file);
  UM_TRY(um_core_file_close(context, "outside.csv", &file));
  for (size_t k = 0; k < table->nroom; k++) UM_TRY(write_room(context, model, table, k, folder));
  if (exchange == NULL) return UM_OK;
  return write_couplings(context, model, table, exchange, folder);
}
