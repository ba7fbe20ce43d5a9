/* The air between telescope and satellite, as tables. */
#include "output/sky.h"

#include <math.h>
#include <stdlib.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "environment/airmass.h"
#include "environment/clear_sky.h"
#include "model/run/sky_light.h"
#include "output/csv_impl.h"

#define PER_UM 1e-6 /* of a radiance per metre of wavelength */
#define PARTS  8    /* of a bin, at whose ends air.csv has rows */

static const double zeniths[] = {0, 30, 45, 55, 62, 67, 71, 74, 76.5, 79, 81, 83, 85}; /* [deg] */
#define ZENITHS (sizeof zeniths / sizeof *zeniths)

/* A wavelength of air.csv, and the range of which its row has the mean [m]. */
struct node {
  double at, from, to;
};

static int compare_nodes(const void *a, const void *b)
{
  double x = ((const struct node *)a)->at, y = ((const struct node *)b)->at;
  return (x > y) - (x < y);
}

/* Wavelengths of all bands, ascending; one that two bands have counts once. */
static enum um_status make_nodes(struct um_context *context, const struct um_model *model,
                                 struct node **out, size_t *count)
{
  size_t most = 0, n = 0, kept = 0;
  for (size_t b = 0; b < model->nband; b++) most += (size_t)model->band[b].bins * PARTS + 1;
  UM_TRY(um_core_allocate(context, most, sizeof **out, out));
  for (size_t b = 0; b < model->nband; b++) {
    const struct um_optics_band *band = &model->band[b];
    int parts = band->bins * PARTS;
    double half = 0.5 * (band->to - band->from) / parts;
    for (int i = 0; i <= parts; i++) {
      double at = band->from + (band->to - band->from) * i / parts;
      (*out)[n++] = (struct node){at, fmax(band->from, at - half), fmin(band->to, at + half)};
    }
  }
  qsort(*out, n, sizeof **out, compare_nodes);
  for (size_t i = 0; i < n; i++)
    if (kept == 0 || (*out)[i].at > (*out)[kept - 1].at * (1.0 + 1e-6)) (*out)[kept++] = (*out)[i];
  *count = kept;
  return UM_OK;
}

static enum um_status write_air(struct um_context *context, const struct um_output_run *run,
                                FILE *file)
{
  enum um_status status;
  const struct um_environment_clear_sky *sky = &run->model->environment.sky;
  struct node *node = NULL;
  size_t count;
  UM_CHECK(make_nodes(context, run->model, &node, &count));
  fputs("zenith_deg,wavelength_um,transmission,radiance_W_m2_sr_um\n", file);
  for (size_t z = 0; z < ZENITHS; z++) {
    double airmass = um_environment_airmass((90.0 - zeniths[z]) * UM_DEG);
    for (size_t i = 0; i < count; i++) {
      double from = node[i].from, to = node[i].to;
      if (i % 256 == 0) UM_CHECK(um_core_stop_check(context, "the sky was written"));
      fprintf(file, "%g", zeniths[z]);
      um_core_csv_put_number(file, 1e6 * node[i].at);
      um_core_csv_put_number(file, um_environment_clear_sky_transmission(sky, from, to, airmass));
      um_core_csv_put_number(file,
                             PER_UM * um_environment_clear_sky_radiance(sky, from, to, airmass));
      fputc('\n', file);
    }
  }
done:
  um_core_free(context, node);
  return status;
}

/* What the line of sight of observation k has in the bins of a band. */
static void put_band(const struct um_output_run *run, size_t k, const struct um_optics_band *band,
                     FILE *file)
{
  const struct um_model_tables *tables = run->tables;
  const struct um_environment_clear_sky *sky = &run->model->environment.sky;
  double airmass =
      um_environment_airmass_toward(tables->look[k * tables->nsub + tables->nsub / 2].elevation);
  struct um_model_sky scattered;
  um_model_sky(run->model, tables, k, band->from, band->to, &scattered);
  for (int i = 0; i < band->bins; i++) {
    double from = um_optics_band_edge(band, i), to = um_optics_band_edge(band, i + 1);
    um_output_csv_time(file, tables->t_obs[k]);
    um_core_csv_put_text(file, band->name, "");
    um_core_csv_put_number(file, 0.5e6 * (from + to));
    um_core_csv_put_number(file, um_environment_clear_sky_transmission(sky, from, to, airmass));
    um_core_csv_put_number(file,
                           PER_UM * (um_environment_clear_sky_radiance(sky, from, to, airmass) +
                                     um_model_sky_radiance(&scattered, from, to)));
    fputc('\n', file);
  }
}

static enum um_status write_lines_of_sight(struct um_context *context,
                                           const struct um_output_run *run, FILE *file)
{
  const struct um_model_tables *tables = run->tables;
  fputs("time_utc,band,wavelength_um,transmission,radiance_W_m2_sr_um\n", file);
  for (size_t k = 0; k < tables->nobs; k++) {
    double elevation = tables->look[k * tables->nsub + tables->nsub / 2].elevation;
    UM_TRY(um_core_stop_check(context, "the sky was written"));
    if (tables->hidden[k] || isnan(um_environment_airmass_toward(elevation))) continue;
    for (size_t b = 0; b < run->model->nband; b++) put_band(run, k, &run->model->band[b], file);
  }
  return UM_OK;
}

enum um_status um_output_write_sky(struct um_context *context, const struct um_output_run *run,
                                   struct um_core_folder *folder)
{
  static enum um_status (*const write[])(struct um_context *, const struct um_output_run *,
                                         FILE *) = {write_air, write_lines_of_sight};
  static const char *const name[] = {"air.csv", "sky.csv"};
  const struct um_scenario *scenario = run->model->scenario;
  if (!run->model->environment.sky.on)
    return um_core_fail(
        context, UM_ERR_INPUT,
        "%s: no air before the satellite; accepted: observer.air at a station, with "
        "the effect atmosphere on",
        scenario->at.file);
  for (size_t i = 0; i < 2; i++) {
    FILE *file = NULL;
    UM_TRY(um_core_folder_open(context, folder, name[i], &file));
    enum um_status status = write[i](context, run, file);
    enum um_status closed = um_core_file_close(context, name[i], &file);
    UM_TRY(status);
    UM_TRY(closed);
  }
  return UM_OK;
}
