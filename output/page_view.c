/* report.html of a scenario before anything is solved. */
#include <math.h>

#include "base/core/constants.h"
#include "model/build/timeline.h"
#include "orbit/time.h"
#include "output/page_scene.h"

#define INSTANTS 60

struct view {
  struct um_page_writer *w;
  struct um_page *page;
  const struct um_model *model;
};

/* Even instants over the window, as the observer sees them where there is one. */
static enum um_status sample_all(struct view *v, struct um_output_scene *scene)
{
  const struct um_scenario_time *window = v->model->scenario->time;
  size_t n = v->model->points || !(window->stop > window->start) ? 1 : INSTANTS;
  struct um_environment_sample *sample;
  struct um_orbit_look look;
  double *time;
  UM_TRY(UM_PAGE_ROOM(v->w, n, &sample));
  UM_TRY(UM_PAGE_ROOM(v->w, n, &time));
  for (size_t i = 0; i < n; i++) {
    double t = window->start;
    if (n > 1) t += (window->stop - window->start) * (double)i / (double)(n - 1);
    time[i] = um_orbit_time_unix(t);
    if (v->model->points) { /* nothing is known between measurements: the body alone */
      sample[i].q = (struct um_quat){1.0, 0.0, 0.0, 0.0};
      sample[i].sun = um_vec3(1.0, 0.0, 0.0);
    } else if (v->model->has_observer) {
      UM_TRY(um_model_sample_seen(v->w->context, v->model, t, &sample[i], &look));
    } else {
      UM_TRY(um_model_sample_at(v->w->context, v->model, t, &sample[i]));
    }
  }
  *scene = (struct um_output_scene){.ntime = n, .time = time, .sample = sample};
  return UM_OK;
}

static enum um_status parts(struct view *v)
{
  static const struct um_page_figure figure = {.id = "parts", .title = "Parts"};
  const struct um_geometry *g = v->model->geometry;
  size_t n = um_geometry_part_count(g);
  const char **name, **closed;
  double *facets, *area, *volume;
  UM_TRY(UM_PAGE_ROOM(v->w, n, &name));
  UM_TRY(UM_PAGE_ROOM(v->w, n, &closed));
  UM_TRY(UM_PAGE_ROOM(v->w, n, &facets));
  UM_TRY(UM_PAGE_ROOM(v->w, n, &area));
  UM_TRY(UM_PAGE_ROOM(v->w, n, &volume));
  for (size_t i = 0; i < n; i++) {
    struct um_geometry_report r = um_geometry_report(g, i);
    name[i] = r.part;
    closed[i] = r.closed ? "closed" : "open";
    facets[i] = (double)r.nfacet;
    area[i] = r.area;
    volume[i] = r.volume;
  }
  const struct um_page_column column[] = {{.name = "part", .text = name},
                                          {.name = "facets", .value = facets},
                                          {.name = "area", .unit = "m^2", .value = area},
                                          {.name = "volume", .unit = "m^3", .value = volume},
                                          {.name = "surface", .text = closed}};
  um_page_table(v->page, &figure, column, 5, n);
  return UM_OK;
}

static enum um_status materials(struct view *v)
{
  static const struct um_page_figure figure = {.id = "materials", .title = "Materials"};
  const struct um_geometry *g = v->model->geometry;
  size_t n = um_geometry_material_count(g);
  const char **name;
  double *absorptance, *emittance, *area;
  UM_TRY(UM_PAGE_ROOM(v->w, n, &name));
  UM_TRY(UM_PAGE_ROOM(v->w, n, &area));
  UM_TRY(UM_PAGE_ROOM(v->w, n, &absorptance));
  UM_TRY(UM_PAGE_ROOM(v->w, n, &emittance));
  for (size_t i = 0; i < n; i++) {
    name[i] = um_geometry_material_name(g, i);
    area[i] = um_geometry_material_area(g, i);
    absorptance[i] = um_materials_solar_absorptance(v->model->material[i], NULL);
    emittance[i] = um_materials_emittance(v->model->material[i], NULL, UM_REFERENCE_TEMPERATURE);
  }
  const struct um_page_column column[] = {{.name = "material", .text = name},
                                          {.name = "area", .unit = "m^2", .value = area},
                                          {.name = "solar absorptance", .value = absorptance},
                                          {.name = "emittance", .value = emittance}};
  um_page_table(v->page, &figure, column, 4, n);
  return UM_OK;
}

static enum um_status fill(struct um_page_writer *w, const void *of)
{
  struct view whole = {.w = w, .page = w->page, .model = of}, *v = &whole;
  static const struct um_page_figure figure = {.id = "satellite", .title = "The satellite"};
  struct um_output_scene scene;
  if (v->model->scenario->summary != NULL) um_page_lead(v->page, "%s", v->model->scenario->summary);
  um_page_lead(v->page, "Nothing is computed yet: this is what was understood.");
  um_page_fact(v->page, "model", "%zu surfaces, %zu heat nodes, %zu bands",
               um_geometry_mesh(v->model->geometry)->nsurface,
               um_thermal_network_nodes(v->model->body->network), v->model->nband);
  UM_TRY(sample_all(v, &scene));
  um_page_section(v->page, "satellite", "How does it look, and how does it turn?", UM_PAGE_PLAIN);
  UM_TRY(um_output_page_put_scene(v->w, v->model, &scene, &figure));
  um_page_section(v->page, "made-of", "What is it made of?", UM_PAGE_PLAIN);
  UM_TRY(parts(v));
  return materials(v);
}

enum um_status um_output_write_view(struct um_context *context, const struct um_model *model,
                                    const char *command, struct um_core_folder *folder)
{
  const struct um_page_head head = {
      .command = command, .kind = "scenario", .title = model->scenario->name};
  return um_page_report(context, &head, fill, model, folder);
}
