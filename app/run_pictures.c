/* Pictures of a run: the panels of satellite.png, and views that were asked for as OpenEXR. Rays do
 * not depend on wavelength, so all bands of an instant share one factored picture. */
#include "app/run_pictures.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "app/picture.h"
#include "base/core/constants.h"
#include "model/products/picture.h"
#include "orbit/time.h"
#include "output/exr.h"

#define PANEL_COLUMNS 3
#define PANEL_WIDTH   320 /* pixels */
#define VIEW_WIDTH    384 /* pixels */
#define CAPTION       64  /* [bytes] of a panel's, its end included */
#define FIRST_LIGHT   "first-light"

/* Instants worth a picture: the middle of the longest darkness, the brightest of the first and of
 * the last band; where these coincide, the middle of a third of the run. In order of time. */
static void choose_instants(const struct um_model_tables *tables, const struct um_model_result *r,
                            size_t k[PANEL_COLUMNS])
{
  size_t longest = 0, n = r->nobs;
  for (size_t c = 0; c < PANEL_COLUMNS; c++) k[c] = n * (2 * c + 1) / (2 * PANEL_COLUMNS);
  for (size_t i = 0; i < n; i++) {
    size_t end = i;
    while (end < n && !(tables->sunlit[end] > UM_UMBRA_MOST)) end++;
    if (end - i > longest) {
      longest = end - i;
      k[0] = i + longest / 2;
    }
    if (end > i) i = end;
  }
  for (size_t c = 1; c < PANEL_COLUMNS; c++) {
    size_t band = c == 1 ? 0 : r->nband - 1, best = 0;
    for (size_t i = 1; i < n; i++)
      if (um_model_result_intensity(r, i, band, -1) > um_model_result_intensity(r, best, band, -1))
        best = i;
    bool taken = false;
    for (size_t d = 0; d < c; d++) taken = taken || k[d] == best;
    if (!taken) k[c] = best;
  }
  for (size_t a = 0; a < PANEL_COLUMNS; a++)
    for (size_t b = a + 1; b < PANEL_COLUMNS; b++)
      if (k[b] < k[a]) {
        size_t swap = k[a];
        k[a] = k[b];
        k[b] = swap;
      }
}

/* "2016-09-21 20:36:59 UTC, in shadow" */
static void caption(const struct um_model_tables *tables, size_t k, char out[CAPTION])
{
  char time[32];
  um_orbit_time_format(tables->t_obs[k], time);
  snprintf(out, CAPTION, "%.10s %.8s UTC%s", time, time + 11,
           tables->sunlit[k] > UM_UMBRA_MOST ? "" : ", in shadow");
}

enum um_status um_app_run_panels(struct um_context *context, const struct um_output_run *run,
                                 const char *folder)
{
  enum um_status status;
  size_t nband = run->model->nband, instant[PANEL_COLUMNS];
  struct um_output_panel *panels = NULL;
  struct um_optics_image *image[PANEL_COLUMNS] = {NULL};
  char captions[PANEL_COLUMNS][CAPTION];
  UM_TRY(um_core_allocate(context, nband * PANEL_COLUMNS, sizeof *panels, &panels));
  choose_instants(run->tables, run->result, instant);
  for (size_t c = 0; c < PANEL_COLUMNS; c++) {
    size_t k = instant[c];
    caption(run->tables, k, captions[c]);
    UM_CHECK(um_model_picture(context, run->model, run->tables, run->result, k, 0, nband,
                              PANEL_WIDTH, 4, &image[c]));
    for (size_t b = 0; b < nband; b++)
      panels[b * PANEL_COLUMNS + c] = (struct um_output_panel){
          image[c], &run->tables->sample[k * run->tables->nsub + run->tables->nsub / 2],
          &run->model->band[b], b, captions[c]};
  }
  UM_CHECK(um_output_plot_panels(context, panels, nband, PANEL_COLUMNS, folder));
done:
  for (size_t c = 0; c < PANEL_COLUMNS; c++) um_optics_image_destroy(context, &image[c]);
  um_core_free(context, panels);
  return status;
}

/* The observation nearest to a time, or the one at which sunlight begins. */
static enum um_status find_view(struct um_context *context, const struct um_model *model,
                                const struct um_model_tables *tables, const char *text, size_t *out)
{
  size_t n = tables->nobs;
  const double *t = tables->t_obs;
  if (strcmp(text, FIRST_LIGHT) == 0) {
    for (size_t k = 1; k < n; k++)
      if (tables->sunlit[k] > UM_UMBRA_MOST && !(tables->sunlit[k - 1] > UM_UMBRA_MOST)) {
        *out = k;
        return UM_OK;
      }
    return um_core_fail(context, UM_ERR_INPUT,
                        "--picture " FIRST_LIGHT ": the satellite does not leave the shadow in "
                        "this run; accepted: an instant of it");
  }
  double wanted;
  UM_TRY(um_app_instant(context, "--picture", text, &wanted));
  UM_TRY(um_app_instant_within(context, "--picture", text, wanted, model, ", or " FIRST_LIGHT));
  *out = 0;
  for (size_t k = 1; k < n; k++)
    if (fabs(t[k] - wanted) < fabs(t[*out] - wanted)) *out = k;
  return UM_OK;
}

/* "view-20160921T203300Z-lwir.exr" of each band. */
static enum um_status write_view(struct um_context *context, const struct um_output_run *run,
                                 size_t k, const char *folder)
{
  struct um_optics_image *image = NULL;
  char *path = NULL, time[32], name[32];
  enum um_status status;
  um_orbit_time_format(run->tables->t_obs[k], time);
  snprintf(name, sizeof name, "%.4s%.2s%.2sT%.2s%.2s%.2sZ", time, time + 5, time + 8, time + 11,
           time + 14, time + 17);
  UM_CHECK(um_model_picture(context, run->model, run->tables, run->result, k, 0, run->model->nband,
                            VIEW_WIDTH, UM_APP_RENDER_SAMPLES, &image));
  for (size_t b = 0; b < run->model->nband; b++) {
    struct um_output_cut cut = um_output_cut_whole(image);
    cut.bin = image->first[b];
    cut.nbin = image->first[b + 1] - cut.bin;
    um_core_free(context, path);
    path = NULL;
    snprintf(cut.comments, sizeof cut.comments, "%.100s at %s, band %.50s",
             run->model->scenario->name, time, run->model->band[b].name);
    UM_CHECK(um_core_asprintf(context, &path, "%s/view-%s-%s.exr", folder, name,
                              run->model->band[b].name));
    UM_CHECK(um_output_write_exr(context, image, &cut, path));
  }
done:
  um_core_free(context, path);
  um_optics_image_destroy(context, &image);
  return status;
}

enum um_status um_app_run_views(struct um_context *context, const struct um_output_run *run,
                                const struct um_app_options *options, const char *folder)
{
  for (size_t i = 0; i < options->npicture; i++) {
    size_t k = 0;
    UM_TRY(find_view(context, run->model, run->tables, options->picture[i], &k));
    UM_TRY(write_view(context, run, k, folder));
  }
  return UM_OK;
}

enum um_status um_app_run_views_check(struct um_context *context, const struct um_model *model,
                                      const struct um_model_tables *tables,
                                      const struct um_app_options *options)
{
  size_t unused = 0;
  if (options->npicture > 0 && !model->has_observer)
    return um_core_fail(context, UM_ERR_INPUT, "--picture %s: a picture needs an observer",
                        options->picture[0]);
  for (size_t i = 0; i < options->npicture; i++)
    UM_TRY(find_view(context, model, tables, options->picture[i], &unused));
  return UM_OK;
}
