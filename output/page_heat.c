/* Temperatures and heat on the page of a run. */
#include <math.h>
#include <string.h>

#include "output/page_impl.h"

/* Parts and interiors are shown at first; their groups and the means of materials can be. */
static bool is_shown(const struct um_output_run *run, size_t place)
{
  const struct um_thermal_body *body = run->model->body;
  return place < body->nplace &&
         (body->place[place].kind == UM_PLACE_PART || body->place[place].kind == UM_PLACE_INTERIOR);
}

enum um_status um_output_page_temperatures(struct um_output_page *p)
{
  static const struct um_page_figure figure = {
      .id = "temperatures",
      .title = "Temperatures",
      .text = "Means over the area of each place. The band of a curve reaches from the coldest to "
              "the hottest point of the place."};
  const struct um_model_result *r = p->run->result;
  struct um_page_series *series;
  if (r->nplace == 0) return UM_OK;
  UM_TRY(UM_PAGE_ROOM(p->w, r->nplace, &series));
  for (size_t i = 0; i < r->nplace; i++) {
    const char *column;
    UM_TRY(um_page_words(p->w, &column, "%s.mean_K", r->place[i].name));
    series[i] = (struct um_page_series){.name = r->place[i].name,
                                        .role = "model",
                                        .column = column,
                                        .hidden = !is_shown(p->run, i),
                                        .value = r->place[i].mean,
                                        .low = r->place[i].minimum,
                                        .high = r->place[i].maximum};
  }
  const struct um_page_panel panel = {
      .name = "temperature", .unit = "K", .series = series, .nseries = r->nplace};
  um_page_section(p->page, "temperatures", "How warm is it?", UM_PAGE_PLAIN);
  um_page_writer_picture(p->w, "temperatures.svg");
  um_page_axes(p->page, &figure, &p->w->time, p->w->shade, p->w->nshade, &panel, 1);
  return UM_OK;
}

/* Places whose heats add up to the satellite's. */
static bool is_whole(enum um_thermal_place_kind kind)
{
  return kind == UM_PLACE_PART || kind == UM_PLACE_WALL || kind == UM_PLACE_INTERIOR;
}

enum um_status um_output_page_heat(struct um_output_page *p)
{
  static const struct um_page_figure figure = {
      .id = "heat",
      .title = "Heat of the whole satellite",
      .text = "Above zero: heat that comes in or is made inside. Below: heat that is radiated. "
              "Stored: what remains and warms it."};
  enum { SUN, ALBEDO, PLANET, INTERNAL, RADIATED, STORED, FLOWS };
  static const char *const names[FLOWS] = {
      "sunlight absorbed", "albedo absorbed", "Earth infrared absorbed",
      "internal power",    "radiated",        "stored"};
  const struct um_output_run *run = p->run;
  const struct um_model_result *r = run->result;
  const struct um_thermal_body *body = run->model->body;
  double *flow[FLOWS];
  struct um_page_series series[FLOWS];
  if (r->heat == NULL) return UM_OK;
  for (int f = 0; f < FLOWS; f++) {
    UM_TRY(um_output_page_column(p, &flow[f]));
    series[f] = (struct um_page_series){.name = names[f], .role = "model", .value = flow[f]};
  }
  for (size_t k = 0; k < r->nobs; k++)
    for (size_t i = 0; i < body->nplace; i++) {
      const struct um_thermal_heat *h = &r->heat[k * r->nplace + i];
      if (!is_whole(body->place[i].kind)) continue;
      flow[SUN][k] += h->solar;
      flow[ALBEDO][k] += h->albedo;
      flow[PLANET][k] += h->planet;
      flow[INTERNAL][k] += h->internal;
      flow[RADIATED][k] += h->radiated;
      flow[STORED][k] += h->stored;
    }
  const struct um_page_panel panel = {
      .name = "heat flow", .unit = "W", .zero = true, .series = series, .nseries = FLOWS};
  um_page_section(p->page, "heat", "Where does the heat come from, and where does it go?",
                  UM_PAGE_PLAIN);
  um_page_axes(p->page, &figure, &p->w->time, p->w->shade, p->w->nshade, &panel, 1);
  return UM_OK;
}
