/* A channel of measurements on a page. */
#include "evidence/comparison/channel_page.h"

#include <math.h>

#include "evidence/comparison/figures.h"

enum um_status um_compare_page_put_channel(struct um_page_writer *w,
                                           const struct um_compare_page_channel *c, size_t number)
{
  struct um_page_series value[1 + UM_COMPARE_PAGE_MODELS], residual[UM_COMPARE_PAGE_MODELS];
  char *words, id[40];
  UM_TRY(UM_PAGE_ROOM(w, 200, &words));
  um_compare_channel_words(c->channel, words, 200);
  snprintf(id, sizeof id, "channel-%zu", number + 1);
  value[0] = (struct um_page_series){.name = "measured",
                                     .role = "measured",
                                     .mark = UM_PAGE_POINTS,
                                     .value = c->value,
                                     .error = c->sigma};
  for (size_t m = 0; m < c->nmodel; m++) {
    const struct um_compare_page_model *model = &c->model[m];
    value[1 + m] =
        (struct um_page_series){.name = model->name, .role = model->role, .value = model->value};
    residual[m] = (struct um_page_series){
        .name = model->name, .role = model->role, .mark = UM_PAGE_POINTS, .value = model->residual};
  }
  const struct um_page_panel panel[] = {
      {.name = words,
       .unit = um_compare_quantity_unit(c->channel->quantity),
       .scale = um_compare_is_magnitude(c->channel->quantity) ? UM_PAGE_MAGNITUDE : UM_PAGE_LINEAR,
       .series = value,
       .nseries = 1 + c->nmodel},
      {.name = "measured \xe2\x88\x92 model",
       .unit = c->weighted ? "sigma" : um_compare_residual_unit(c->channel->quantity),
       .zero = true,
       .series = residual,
       .nseries = c->nmodel}};
  const struct um_page_axis time = {"time", "UTC", UM_PAGE_TIME, c->time, c->count};
  const struct um_page_figure figure = {.id = id, .title = words};
  um_page_axes(w->page, &figure, &time, w->shade, w->nshade, panel, 2);
  return UM_OK;
}

void um_compare_page_put_chi2(struct um_page *page, const char *of, double chi2, double dof)
{
  if (isfinite(chi2) && dof > 0.0)
    um_page_text(page,
                 "%s: chi-square %.5g at %.5g degrees of freedom, %.4g each; noise alone "
                 "leaves about 1.",
                 of, chi2, dof, chi2 / dof);
}
