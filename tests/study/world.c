#include "tests/study/world.h"

#include <stdio.h>
#include <stdlib.h>

#include "study/identity.h"
#include "tests/support/cmocka_all.h"

static const char *const scenario =
    "schema: 1\n"
    "name: world\n"
    "time: {start_utc: 2020-03-20T12:00:00Z, stop_utc: 2020-03-20T12:20:00Z, step_s: 120}\n"
    "orbit:\n"
    "  circular: {altitude_km: 600, beta_deg: 20}\n"
    "attitude: [{lvlh: {}}]\n"
    "observer: {direction: {unit_gcrs: [0.5, 0.7, 0.1], range_km: 1000}}\n"
    "parts:\n"
    "  - {name: box, box: {size_m: [1, 1, 1]}, outside: grey_white, lumped: true,\n"
    "     interior: {capacity_J_K: 20000, power_W: 5, conductance_W_K: 1},\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000}}\n"
    "  - {name: wing, plate: {size_m: [2, 1]}, pose: {position_m: [0, 1.6, 0]}, lumped: true,\n"
    "     front: grey_panel, back: grey_white,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000, through_conductance_W_m2_K: 50}}\n"
    "contacts:\n"
    "  - {a: box, b: wing, conductance_W_K: 0.5}\n"
    "thermal: {start: periodic, orbits_before: 1, view_factor_rays: 256}\n"
    "bands:\n"
    "  vis: {from_um: 0.38, to_um: 0.78, bins: 4}\n"
    "  lwir: {from_um: 8, to_um: 12, bins: 4}\n";

static void put(const char *path, const char *head, const char *text)
{
  FILE *file = fopen(path, "w");
  if (file == NULL) abort();
  fputs(head, file);
  fputs(text, file);
  fclose(file);
}

void world_put(const char *study)
{
  put(WORLD_SCENARIO, "", scenario);
  put(WORLD_STUDY, "schema: 1\nname: test\nscenario: " WORLD_SCENARIO "\n", study);
}

void world_clear(struct um_context *context)
{
  um_study_records_remove(context, WORLD_RECORDS);
  remove(WORLD_SCENARIO);
  remove(WORLD_STUDY);
}

struct um_study_run_options world_options(int workers, bool resume)
{
  return (struct um_study_run_options){
      .version = "test",
      .batch = {.folder = WORLD_RECORDS, .work.workers = workers, .resume = resume}};
}

struct um_study_result *world_run(struct um_context *context, const char *text, int workers,
                                  bool resume, struct um_study **study)
{
  struct um_study_result *result = NULL;
  const struct um_study_run_options options = world_options(workers, resume);
  world_put(text);
  if (um_study_create(context, WORLD_STUDY, &options, study) != UM_OK ||
      um_study_run(context, *study, &result) != UM_OK)
    fail_msg("%s", um_core_message(context));
  assert_non_null(result);
  return result;
}
