/* The product's library as people may trust it: every record says where its numbers come from, over
 * which wavelengths they are measured, and gives what catalogues say; how they are read on demand.
 */
#include "check.h"

#include <ctype.h>
#include <string.h>
#include <unistd.h>

#include "base/core/listing.h"
#include "tests/support/temporary.h"
#include "tests/support/with_context.h"

#define TRUSTED 60 /* records that are measured over sunlight and into heat */

static struct um_materials_library *library;
static char folder[UM_TEST_PATH], path[UM_TEST_PATH + 8], logged[1024];

static void keep_log(void *self, enum um_core_log_level level, const char *line)
{
  (void)self;
  if (level >= UM_LOG_WARNING) snprintf(logged, sizeof logged, "%s", line);
}

static int group_setup(void **state)
{
  if (context_set_up(state) != 0 || um_test_folder_create(folder) != 0) return -1;
  snprintf(path, sizeof path, "%s/m.yaml", folder);
  um_core_log_set_sink(context, keep_log, NULL);
  return 0;
}

static int group_teardown(void **state)
{
  unlink(path);
  return um_test_folder_remove(folder) == 0 ? context_tear_down(state) : -1;
}

static int setup(void **state)
{
  (void)state;
  logged[0] = '\0';
  return library_under_e490(context, &library) == UM_OK ? 0 : -1;
}

static int teardown(void **state)
{
  (void)state;
  um_materials_library_destroy(&library);
  return 0;
}

static void read_all(void)
{
  assert_int_equal(um_materials_library_read_folder(context, library, UM_TEST_LIBRARY), UM_OK);
}

static enum um_status read_text(const char *text)
{
  FILE *file = fopen(path, "w");
  assert_non_null(file);
  fputs(text, file);
  fclose(file);
  um_core_message_clear(context);
  return um_materials_library_read_file(context, library, path, NULL, 0);
}

/* "(1995)": a year of a publication, or a date. */
static bool has_year(const char *text)
{
  for (const char *c = text; *c != '\0'; c++)
    if ((strncmp(c, "19", 2) == 0 || strncmp(c, "20", 2) == 0) && isdigit((unsigned char)c[2]) &&
        isdigit((unsigned char)c[3]))
      return true;
  return false;
}

/* A record is called as its file, which is how a run finds it, and is read without a warning. */
static void records_load(void **state)
{
  (void)state;
  char **names, file[1024];
  size_t n;
  assert_int_equal(um_core_listing(context, UM_TEST_LIBRARY, ".yaml", "records", &names, &n),
                   UM_OK);
  for (size_t i = 0; i < n; i++) {
    snprintf(file, sizeof file, UM_TEST_LIBRARY "/%s", names[i]);
    if (um_materials_library_read_file(context, library, file, NULL, 0) != UM_OK)
      fail_msg("%s", um_core_message(context));
    if (logged[0] != '\0') fail_msg("%s: %s", names[i], logged);
    const char *name = um_materials_name(um_materials_library_at(library, i));
    if (strncmp(names[i], name, strlen(name)) != 0 || strcmp(names[i] + strlen(name), ".yaml") != 0)
      fail_msg("%s holds %s", names[i], name);
  }
  um_core_listing_free(context, names, n);
}

static void check_range(const struct um_materials_record *r)
{
  struct um_materials_measured_range m = um_materials_measured_range(r);
  const char *name = um_materials_name(r);
  if (isnan(m.from)) {
    assert_true(isnan(m.to) && isnan(m.solar_outside) && isnan(m.heat_outside));
    return;
  }
  if (!(m.from >= 0.2e-6 && m.from <= 0.45e-6 && m.to >= 2e-6 && m.to <= 100.1e-6))
    fail_msg("%s: measured from %g to %g m", name, m.from, m.to);
  assert_true(m.solar_outside >= 0.0 && m.solar_outside < 0.15);
  assert_true(m.heat_outside >= 0.0 && m.heat_outside <= 1.0);
  if (!has_year(um_materials_citation(r))) fail_msg("%s: measured, and nothing is cited", name);
}

static void check_catalogue(const struct um_materials_record *r)
{
  struct um_materials_catalogue c = um_materials_catalogue(r);
  if (c.source == NULL) return;
  double e = c.emittance_is_normal ? um_materials_normal_emittance(r, NULL, 300.0)
                                   : um_materials_emittance(r, NULL, 300.0);
  check_near(um_materials_name(r), um_materials_solar_absorptance(r, NULL), c.solar_absorptance,
             c.solar_absorptance_tolerance);
  check_near(um_materials_name(r), e, c.emittance, c.emittance_tolerance);
  assert_true(c.solar_absorptance_tolerance <= 0.06 && c.emittance_tolerance <= 0.06);
  assert_true(strlen(c.source) > 20);
}

static void check_reflectance(const struct um_materials_record *r)
{
  for (double l = 0.25e-6; l < 25e-6; l *= 1.004) {
    double e = um_materials_emissivity(r, NULL, l, 1.0);
    double h = um_materials_hemispherical_reflectance(r, NULL, l);
    if (!(e >= 0.0 && e <= 1.0 && h >= 0.0 && h <= 1.0))
      fail_msg("%s: emissivity %g, reflectance %g at %g m", um_materials_name(r), e, h, l);
  }
}

static void check_ageing(const struct um_materials_record *r)
{
  for (size_t i = 0; i < um_materials_ageing_count(r); i++) {
    struct um_materials_ageing a = um_materials_ageing_at(r, i);
    double aged = um_materials_solar_absorptance(r, NULL) + a.solar_absorptance;
    assert_true(isnan(aged) || (aged >= 0.0 && aged <= 1.0));
    assert_true(strlen(a.after) > 5 && strlen(a.source) > 20);
  }
}

static bool is_trusted(const struct um_materials_record *r)
{
  struct um_materials_measured_range m = um_materials_measured_range(r);
  return m.solar_outside < 0.1 && m.to >= 10e-6 * (1.0 - 1e-9); /* false of NaN */
}

static void records_can_be_trusted(void **state)
{
  (void)state;
  size_t trusted = 0, aged = 0;
  read_all();
  for (size_t i = 0; i < um_materials_library_count(library); i++) {
    const struct um_materials_record *r = um_materials_library_at(library, i);
    if (strlen(um_materials_citation(r)) < 20 && !um_materials_is_grey(r))
      fail_msg("%s: no citation", um_materials_name(r));
    check_range(r);
    check_catalogue(r);
    check_reflectance(r);
    check_ageing(r);
    assert_false(um_materials_is_grey(r) && is_trusted(r));
    trusted += is_trusted(r);
    aged += um_materials_ageing_count(r) > 0;
  }
  print_message("%zu records, %zu of them measured, %zu with ageing\n",
                um_materials_library_count(library), trusted, aged);
  assert_true(trusted >= TRUSTED && aged >= 2);
}

#define TABLE                                                                                      \
  "name: m\nsummary: s\ncitation: c\nreflectance: {wavelength_um: [0.3, 20], diffuse: [0.5, "      \
  "0.5]}\n"

/* Shares outside: of heat by the table of black-body fractions, F(3000 um K) = 0.273232, F(1200
 * um K) = 0.002134 (Incropera and DeWitt, table 12.1); of sunlight by the bands of the spectrum. */
static void outside_of_the_range(void **state)
{
  (void)state;
  struct um_environment environment;
  um_environment_defaults(&environment);
  assert_int_equal(read_text(TABLE "measured_um: [4, 10]\n"), UM_OK);
  struct um_materials_measured_range m =
      um_materials_measured_range(um_materials_library_find(library, "m"));
  check_near("from", m.from, 4e-6, 1e-18);
  check_near("to", m.to, 10e-6, 1e-18);
  check_near("heat", m.heat_outside, 1.0 - 0.273232 + 0.002134, 1e-5);
  assert_int_equal(read_text(TABLE "measured_um: [0.5, 1]\n"), UM_OK);
  m = um_materials_measured_range(um_materials_library_find(library, "m"));
  double inside = um_environment_solar_band(&environment, 0.5e-6, 1e-6);
  check_near("sunlight", m.solar_outside, 1.0 - inside / environment.solar_irradiance, 2e-3);
  assert_int_equal(read_text(TABLE), UM_OK);
  m = um_materials_measured_range(um_materials_library_find(library, "m"));
  assert_true(isnan(m.from) && isnan(m.heat_outside));
}

static void ageing(void **state)
{
  (void)state;
  assert_int_equal(read_text(TABLE "ageing:\n"
                                   "  - {after: a year, solar_absorptance_change: 0.1, source: s}\n"
                                   "  - {after: two, emittance_change: -0.2, source: t}\n"),
                   UM_OK);
  const struct um_materials_record *r = um_materials_library_find(library, "m");
  assert_int_equal(um_materials_ageing_count(r), 2);
  struct um_materials_ageing a = um_materials_ageing_at(r, 0), b = um_materials_ageing_at(r, 1);
  assert_string_equal(a.after, "a year");
  assert_string_equal(b.source, "t");
  assert_true(a.solar_absorptance == 0.1 && isnan(a.emittance));
  assert_true(isnan(b.solar_absorptance) && b.emittance == -0.2);
  check_near("nothing is applied", um_materials_solar_absorptance(r, NULL), 0.5, 1e-12);
}

static void refused(const char *text, const char *piece)
{
  assert_int_equal(read_text(text), UM_ERR_INPUT);
  if (strstr(um_core_message(context), piece) == NULL) fail_msg("%s", um_core_message(context));
}

static void what_is_refused(void **state)
{
  (void)state;
  refused(TABLE "measured_um: [1]\n", "ascending");
  refused(TABLE "measured_um: [2, 1]\n", "ascending");
  refused(TABLE "measured_um: [0.29, 1]\n", "0.3 to 20");
  refused(TABLE "measured_um: [0.3, 21]\n", "0.3 to 20");
  refused(TABLE "ageing: [{after: a year, source: s}]\n", "says of no change");
  refused(TABLE "ageing: [{after: a year, emittance_change: 0.1}]\n", "source");
}

/* Nothing is read but what is wanted, once; what the library has goes before what is offered. */
static void on_demand(void **state)
{
  (void)state;
  const struct um_materials_record *gold, *again, *own;
  char **names;
  size_t n;
  assert_int_equal(um_materials_library_offer_folder(context, library, UM_TEST_LIBRARY), UM_OK);
  assert_int_equal(um_materials_library_count(library), 0);
  assert_int_equal(um_materials_library_want(context, library, "gold", &gold), UM_OK);
  assert_int_equal(um_materials_library_want(context, library, "gold", &again), UM_OK);
  assert_string_equal(um_materials_name(gold), "gold");
  assert_ptr_equal(gold, again);
  assert_int_equal(um_materials_library_count(library), 1);
  assert_int_equal(read_text("name: osr\nsummary: own\ncitation: c\n"
                             "grey: {solar_absorptance: 0.1, emittance: 0.8}\n"),
                   UM_OK);
  assert_int_equal(um_materials_library_want(context, library, "nothing", &own), UM_OK);
  assert_null(own);
  assert_int_equal(um_core_listing(context, UM_TEST_LIBRARY, ".yaml", "records", &names, &n),
                   UM_OK);
  um_core_listing_free(context, names, n);
  assert_int_equal(um_materials_library_count(library), n); /* each name once */
  assert_int_equal(um_materials_library_want(context, library, "osr", &own), UM_OK);
  assert_string_equal(um_materials_summary(own), "own");
  assert_ptr_equal(um_materials_library_find(library, "gold"), gold);
}

/* A record in a file of another name is found, too; a folder that is not there is an error. */
static void offered_by_another_name(void **state)
{
  (void)state;
  const struct um_materials_record *record;
  assert_int_equal(read_text("name: other\nsummary: s\ncitation: c\n"
                             "grey: {solar_absorptance: 0.1, emittance: 0.8}\n"),
                   UM_OK);
  um_materials_library_destroy(&library);
  assert_int_equal(library_under_e490(context, &library), UM_OK);
  assert_int_equal(um_materials_library_offer_folder(context, library, folder), UM_OK);
  assert_int_equal(um_materials_library_want(context, library, "other", &record), UM_OK);
  assert_non_null(record);
  assert_int_equal(um_materials_library_offer_folder(context, library, "/nonexistent"), UM_ERR_IO);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(records_load, setup, teardown),
      cmocka_unit_test_setup_teardown(records_can_be_trusted, setup, teardown),
      cmocka_unit_test_setup_teardown(outside_of_the_range, setup, teardown),
      cmocka_unit_test_setup_teardown(ageing, setup, teardown),
      cmocka_unit_test_setup_teardown(what_is_refused, setup, teardown),
      cmocka_unit_test_setup_teardown(on_demand, setup, teardown),
      cmocka_unit_test_setup_teardown(offered_by_another_name, setup, teardown),
  };
  return cmocka_run_group_tests(tests, group_setup, group_teardown);
}
