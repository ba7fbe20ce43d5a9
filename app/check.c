/* umbra check: read a scenario and report what was understood, without computing light curves. */
#include <math.h>
#include <string.h>

#include "app/app.h"
#include "base/core/constants.h"
#include "model/build/build.h"
#include "model/build/timeline.h"
#include "orbit/time.h"
#include "output/page_scene.h"

static double altitude_km(const struct um_model *model, const struct um_environment_sample *s)
{
  return (um_vec3_norm(s->r) - model->environment.earth_radius) * 1e-3;
}

static void print_parts(const struct um_model *model)
{
  const struct um_geometry *g = model->geometry;
  printf("%-16s %8s %8s %11s %11s  %s\n", "part", "facets", "vertices", "area m2", "volume m3",
         "surface");
  for (size_t i = 0; i < um_geometry_part_count(g); i++) {
    struct um_geometry_report r = um_geometry_report(g, i);
    printf("%-16s %8zu %8zu %11.4f ", r.part, r.nfacet, r.nvertex, r.area);
    if (isnan(r.volume))
      printf("%11s", "-");
    else
      printf("%11.4f", r.volume);
    printf("  %s", r.closed ? "closed" : "open");
    if (r.ndegenerate > 0) printf(", %zu degenerate facets", r.ndegenerate);
    if (r.nonmanifold_edge > 0) printf(", %zu edges of more than two facets", r.nonmanifold_edge);
    if (r.sharpest_angle < 2.0 * UM_DEG)
      printf(", sharpest angle %.2f deg", r.sharpest_angle / UM_DEG);
    printf("\n");
  }
}

static void print_materials(const struct um_model *model)
{
  const struct um_geometry *g = model->geometry;
  printf("\n%-26s %11s %10s %10s\n", "material", "area m2", "solar abs.", "emittance");
  for (size_t m = 0; m < um_geometry_material_count(g); m++) {
    printf("%-26s %11.4f %10.3f %10.3f\n", um_geometry_material_name(g, m),
           um_geometry_material_area(model->geometry, m),
           um_materials_solar_absorptance(model->material[m], NULL),
           um_materials_emittance(model->material[m], NULL, UM_REFERENCE_TEMPERATURE));
  }
}

static void json_parts(const struct um_geometry *g)
{
  printf(",\n  \"parts\": [");
  for (size_t i = 0; i < um_geometry_part_count(g); i++) {
    struct um_geometry_report r = um_geometry_report(g, i);
    um_core_json_text(stdout, i > 0 ? ",\n    {" : "\n    {", "name", r.part);
    printf(", \"facets\": %zu, \"vertices\": %zu", r.nfacet, r.nvertex);
    um_core_json_field(stdout, ", ", "area_m2", r.area);
    um_core_json_field(stdout, ", ", "volume_m3", r.volume);
    printf(", \"closed\": %s, \"degenerate_facets\": %zu}", r.closed ? "true" : "false",
           r.ndegenerate);
  }
  printf("]");
}

static void json_materials(const struct um_model *model)
{
  printf(",\n  \"materials\": [");
  for (size_t m = 0; m < um_geometry_material_count(model->geometry); m++) {
    um_core_json_text(stdout, m > 0 ? ",\n    {" : "\n    {", "name",
                      um_geometry_material_name(model->geometry, m));
    um_core_json_field(stdout, ", ", "area_m2", um_geometry_material_area(model->geometry, m));
    um_core_json_field(stdout, ", ", "solar_absorptance",
                       um_materials_solar_absorptance(model->material[m], NULL));
    um_core_json_field(stdout, ", ", "emittance",
                       um_materials_emittance(model->material[m], NULL, UM_REFERENCE_TEMPERATURE));
    printf("}");
  }
  printf("]");
}

/* s: NULL where nothing is known between the measurements. */
static void print_json(const struct um_model *model, const struct um_environment_sample *s,
                       const char *start, const char *stop, const char *view)
{
  um_core_json_text(stdout, "{", "name", model->scenario->name);
  printf(",\n  \"start_utc\": \"%s\", \"stop_utc\": \"%s\"", start, stop);
  um_core_json_field(stdout, ", ", "step_s", model->scenario->time->step_s);
  um_core_json_field(stdout, ",\n  ", "altitude_km",
                     s == NULL ? (double)NAN : altitude_km(model, s));
  um_core_json_field(stdout, ", ", "sunlit_fraction", s == NULL ? (double)NAN : s->sunlit_fraction);
  um_core_json_field(stdout, ", ", "period_s", um_orbit_trajectory_period(model->trajectory));
  json_parts(model->geometry);
  json_materials(model);
  printf(",\n  \"surfaces\": %zu, \"heat_nodes\": %zu, \"tetrahedra\": %zu,\n  \"bands\": [",
         um_geometry_mesh(model->geometry)->nsurface,
         um_thermal_network_nodes(model->body->network), model->body->ntetrahedron);
  for (size_t b = 0; b < model->nband; b++) {
    printf("%s", b > 0 ? ", " : "");
    um_core_json_string(stdout, model->band[b].name);
  }
  um_core_json_text(stdout, "], ", "view", view);
  printf("}\n");
}

/* A page of the satellite, before anything is solved. */
static enum um_status write_view(struct um_context *context, const struct um_app_options *options,
                                 const struct um_model *model, char **out)
{
  enum um_status status;
  struct um_core_folder *folder = NULL;
  char *name = NULL;
  UM_CHECK(um_core_asprintf(context, &name, "%s-view", model->scenario->name));
  UM_CHECK(um_app_out_folder(context, options, name, out));
  UM_CHECK(um_core_folder_begin(context, *out, options->force, &folder));
  UM_CHECK(um_output_write_view(context, model, options->command, folder));
  UM_CHECK(um_core_folder_commit(context, &folder));
done:
  um_core_folder_abort(&folder);
  um_core_free(context, name);
  return status;
}

int um_app_check(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_model *model = NULL;
  char start[32], stop[32], *view = NULL;
  struct um_model_options changes = um_app_model_options(options);
  UM_CHECK(um_model_create(context, options->positional[0], &changes, &model));
  const struct um_scenario_time *time = model->scenario->time;
  struct um_environment_sample s = {0};
  if (!model->points) UM_CHECK(um_model_sample_at(context, model, time->start, &s));
  um_orbit_time_format(time->start, start);
  um_orbit_time_format(time->stop, stop);
  if (options->view) UM_CHECK(write_view(context, options, model, &view));
  if (options->json) {
    print_json(model, model->points ? NULL : &s, start, stop, view);
    goto done;
  }
  if (model->points) {
    printf("%s: %s to %s, observations that stand alone\n", model->scenario->name, start, stop);
  } else {
    printf("%s: %s to %s every %g s\n", model->scenario->name, start, stop, time->step_s);
    printf("at the start: altitude %.1f km, sunlit fraction %.3f, period %.1f s\n",
           altitude_km(model, &s), s.sunlit_fraction,
           um_orbit_trajectory_period(model->trajectory));
  }
  printf("\n");
  print_parts(model);
  print_materials(model);
  printf("\n%zu surfaces, %zu heat nodes, %zu tetrahedra, %zu bands\n",
         um_geometry_mesh(model->geometry)->nsurface,
         um_thermal_network_nodes(model->body->network), model->body->ntetrahedron, model->nband);
  if (view != NULL) printf("to look at: %s/" UM_PAGE_FILE "\n", view);
done:
  um_core_free(context, view);
  um_model_destroy(context, &model);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
