/* The air as it is exported, read again as observer.air.file reads it. */
#include "output/sky.h"

#include <math.h>
#include <stdio.h>
#include <unistd.h>

#include "environment/clear_sky.h"
#include "environment/sky_table.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/in_folder.h"

static struct um_model *model_of(const char *air)
{
  struct um_model *model;
  FILE *file = fopen("s.yaml", "w");
  assert_non_null(file);
  fprintf(
      file,
      "schema: 1\nname: s\n"
      "time: {start_utc: 2016-09-06T18:08:00Z, stop_utc: 2016-09-06T18:12:00Z, step_s: 60}\n"
      "orbit: {kepler: {epoch_utc: 2016-09-06T18:00:00Z, a_km: 7143, e: 0.001, i_deg: 98.3, "
      "raan_deg: 300, argp_deg: 80, mean_anomaly_deg: 10}}\n"
      "attitude: [{lvlh: {}}]\nobserver:\n  station: {latitude_deg: 47.067, longitude_deg: 15.493, "
      "height_m: 495}\n%s"
      "parts:\n  - {name: box, box: {size_m: [1, 1, 1]}, outside: grey_white, lumped: true,\n"
      "     shell: {areal_heat_capacity_J_m2_K: 3000}}\n"
      "thermal: {start: isothermal, orbits_before: 0}\n"
      "bands:\n  vis: {from_um: 0.38, to_um: 0.78, bins: 8}\n  red: {from_um: 0.6, to_um: 0.7, "
      "bins: 1}\n"
      "  lwir: {from_um: 8, to_um: 12, bins: 8}\n",
      air);
  assert_int_equal(fclose(file), 0);
  if (um_model_create(context, "s.yaml", NULL, &model) != UM_OK)
    fail_msg("%s", um_core_message(context));
  remove("s.yaml");
  return model;
}

static enum um_status write_sky(const struct um_model *model)
{
  struct um_model_tables *tables;
  struct um_core_folder *folder;
  assert_int_equal(um_model_precompute(context, model, &tables), UM_OK);
  assert_int_equal(um_core_folder_begin(context, "t", false, &folder), UM_OK);
  const struct um_output_run run = {.model = model, .tables = tables};
  enum um_status status = um_output_write_sky(context, &run, folder);
  if (status == UM_OK) status = um_core_folder_commit(context, &folder);
  um_core_folder_abort(&folder);
  um_model_tables_destroy(context, &tables);
  return status;
}

/* Rows are means over an eighth of a bin, which straight lines join, at angles other than those of
 * the table, too. What lines smooth may be a tenth of what the profile itself is uncertain by
 * (environment/clear_sky.h): 0.0023 of transmission, 0.7 % of heat. */
static void test_air_is_read_again(void **state)
{
  static const double angles[] = {0, 20, 50, 65, 75};
  struct um_environment_sky_table *table;
  struct um_model *model = model_of("  air: {profile: mid_latitude_summer, aerosol: 0.1}\n");
  const struct um_environment_clear_sky *sky = &model->environment.sky;
  double worst = 0.0, warm = 0.0;
  (void)state;
  assert_int_equal(write_sky(model), UM_OK);
  assert_int_equal(um_environment_sky_table_read(context, "t/air.csv", &table), UM_OK);
  for (size_t a = 0; a < sizeof angles / sizeof *angles; a++)
    for (size_t b = 0; b < model->nband; b++) {
      const struct um_optics_band *band = &model->band[b];
      double airmass = 1.0 / cos(angles[a] * 3.14159265358979 / 180.0);
      assert_true(um_environment_sky_table_covers(table, band->from, band->to));
      for (int i = 0; i < band->bins; i++) {
        double from = um_optics_band_edge(band, i), to = um_optics_band_edge(band, i + 1);
        double passes = um_environment_clear_sky_transmission(sky, from, to, airmass);
        double glow = um_environment_clear_sky_radiance(sky, from, to, airmass);
        worst = fmax(
            worst, fabs(um_environment_sky_table_transmission(table, from, to, airmass) - passes));
        if (from > 7e-6)
          warm = fmax(
              warm, fabs(um_environment_sky_table_radiance(table, from, to, airmass) / glow - 1.0));
      }
    }
  print_message("transmission %.4f, heat %.4f\n", worst, warm);
  assert_true(worst < 0.0023);
  assert_true(warm < 0.007);
  um_environment_sky_table_destroy(context, &table);
  um_model_destroy(context, &model);
  remove("t/air.csv");
  remove("t/sky.csv");
  rmdir("t");
}

static void test_without_air(void **state)
{
  struct um_model *model = model_of("");
  (void)state;
  assert_int_equal(write_sky(model), UM_ERR_INPUT);
  assert_string_equal(um_core_message(context),
                      "s.yaml: no air before the satellite; accepted: observer.air at a station, "
                      "with the effect atmosphere on");
  um_model_destroy(context, &model);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_air_is_read_again),
                                     cmocka_unit_test(test_without_air)};
  return cmocka_run_group_tests(tests, folder_enter, folder_leave);
}
