/* The Earth of a scenario: keys of environment.earth, the effects on it, and what both halves make
 * of it. A map whose every place is the uniform Earth must heat and light as that does; what heats
 * must light; and what cannot be is refused by file, line and key. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "tests/effects/case.h"
#include "tests/support/cmocka_all.h"

#define KNOCKE "environment.earth=knocke"
#define SAME   1e-3 /* [K] */

#define RELATIVE "thermal.relative_tolerance=1e-8"
#define ABSOLUTE "thermal.absolute_tolerance_K=1e-6"

static struct case_run with_set(const char *a, const char *b, const char *with)
{
  const char *const set[] = {a, b, NULL}, *const effects[] = {with, NULL};
  return case_compute(case_satellite, effects, NULL, set);
}

/* Without what the temperature of the Earth does to absorptances: a level changes it, a part of the
 * Earth does not. */
static struct case_run with_one_emittance(const char *set_key, const char *with)
{
  const char *const set[] = {set_key, NULL}, *const effects[] = {with, NULL};
  const char *const without[] = {"emittance_temperature", NULL};
  return case_compute(case_satellite, effects, without, set);
}

static double largest(const struct case_run *a, const struct case_run *b)
{
  double worst = 0.0;
  for (size_t i = 0; i < a->result->nobs * a->result->nsurface; i++)
    worst =
        fmax(worst, fabs(a->result->surface_temperature[i] - b->result->surface_temperature[i]));
  print_message("largest difference of temperature %.1e K\n", worst);
  return worst;
}

static void write_map(const char *path, double albedo, double longwave, double brightness)
{
  FILE *f = fopen(path, "w");
  assert_non_null(f);
  fprintf(f, "latitude_deg,albedo,olr_W_m2,brightness_temperature_K\n-45,%g,%g,%g\n45,%g,%g,%g\n",
          albedo, longwave, brightness, albedo, longwave, brightness);
  fclose(f);
}

/* 0.30, 237 W/m^2 and 270 K everywhere, in single precision, which the steps of the integrator turn
 * into its tolerance, here far below the usual 0.01 K: 1e-3 K, 1e-5 of the light. */
static void map_of_one_value_is_uniform(void **state)
{
  (void)state;
  char path[96], set[160], here[512];
  assert_non_null(getcwd(here, sizeof here));
  snprintf(path, sizeof path, "earth_map_%ld.csv", (long)getpid());
  snprintf(set, sizeof set, "environment.earth.file=%s", path);
  write_map(path, 0.30, 237.0, 270.0);
  const char *const from[] = {RELATIVE, ABSOLUTE, NULL};
  const char *const key[] = {set, "environment.earth.model=map", RELATIVE, ABSOLUTE, NULL};
  struct case_run one = case_compute(case_satellite, NULL, NULL, from);
  const char *const without[] = {"earth_spectrum", "earth_anisotropy", NULL};
  struct case_run mapped = case_compute(case_satellite, NULL, without, key);
  struct case_run a = case_with(case_satellite, NULL);
  struct case_run b = with_set(set, "environment.earth.model=map", NULL);
  struct case_run c = with_set(set, NULL, NULL); /* a file alone changes nothing */
  struct case_run d = with_set(set, NULL, "earth_map");
  remove(path);
  assert_true(largest(&one, &mapped) < SAME);
  for (size_t i = 0; i < one.result->nobs * one.result->nband; i++)
    case_near("irradiance", mapped.result->irradiance[i], one.result->irradiance[i], 1e-5);
  case_release(&one);
  case_release(&mapped);
  assert_true(case_same(&a, &c));
  assert_true(case_same(&b, &d));
  case_release(&a);
  case_release(&b);
  case_release(&c);
  case_release(&d);
}

/* The switch is the key, both ways; and Knocke's Earth is not the uniform one, in heat and in both
 * bands. */
static void switch_is_the_key(void **state)
{
  (void)state;
  const char *const set[] = {KNOCKE, NULL}, *const without[] = {"earth_map", NULL};
  struct case_run uniform = case_with(case_satellite, NULL);
  struct case_run key = with_set(KNOCKE, NULL, NULL);
  struct case_run effect = case_with(case_satellite, "earth_map");
  struct case_run off = case_compute(case_satellite, NULL, without, set);
  assert_true(case_same(&key, &effect));
  assert_true(case_same(&off, &uniform));
  assert_true(largest(&uniform, &key) > 0.01);
  for (size_t i = 0; i < key.result->nobs * key.result->nband; i++)
    assert_true(key.result->irradiance[i] != uniform.result->irradiance[i]);
  case_release(&uniform);
  case_release(&key);
  case_release(&effect);
  case_release(&off);
}

/* Sunlight by angle acts on an Earth that is not uniform, and on no other; on heat and on light. */
static void anisotropy_is_of_places(void **state)
{
  (void)state;
  const char *const set[] = {KNOCKE, NULL}, *const without[] = {"earth_anisotropy", NULL};
  struct case_run uniform = case_with(case_satellite, NULL);
  struct case_run same = case_compute(case_satellite, NULL, without, NULL);
  struct case_run key = with_set(KNOCKE, NULL, NULL);
  struct case_run off = case_compute(case_satellite, NULL, without, set);
  assert_true(case_same(&uniform, &same));
  assert_true(largest(&off, &key) > 0.01);
  for (size_t i = 0; i < key.result->nobs * key.result->nband; i++)
    assert_true(key.result->irradiance[i] != off.result->irradiance[i]);
  case_release(&uniform);
  case_release(&same);
  case_release(&key);
  case_release(&off);
}

/* All of the Earth at all times is a level; a place that is never seen is nothing. */
static void region_is_a_level_where_it_is(void **state)
{
  (void)state;
  const char *const always = "environment.earth.local={from_utc: 1990-01-01T00:00:00Z}";
  struct case_run level = case_with(case_satellite, "albedo_level,factor=1.5");
  struct case_run all = with_set(always, NULL, "local_albedo,factor=1.5");
  assert_true(largest(&level, &all) < SAME);
  struct case_run warm = with_one_emittance(NULL, "earth_ir_level,factor=0.8");
  struct case_run cold = with_one_emittance(always, "local_earth_ir,factor=0.8");
  assert_true(largest(&warm, &cold) < SAME);
  struct case_run plain = case_with(case_satellite, NULL);
  struct case_run never = with_set("environment.earth.local={to_utc: 1990-01-01T00:00:00Z, "
                                   "from_utc: 1989-01-01T00:00:00Z, albedo_factor: 0}",
                                   NULL, NULL);
  assert_true(largest(&plain, &never) < SAME);
  struct case_run now = case_with(case_satellite, "local_earth_ir,factor=1,shift_K=-30");
  assert_true(largest(&plain, &now) < SAME);
  assert_true(case_intensity(&now, 1, "lwir", "mli_kapton", UM_MECHANISM_EARTH) <
              0.9 * case_intensity(&plain, 1, "lwir", "mli_kapton", UM_MECHANISM_EARTH));
  struct case_run *all_runs[] = {&level, &all, &warm, &cold, &plain, &never, &now};
  for (size_t i = 0; i < sizeof all_runs / sizeof all_runs[0]; i++) case_release(all_runs[i]);
}

/* Effects on levels act on an Earth that is not uniform. */
static void levels_scale_knocke(void **state)
{
  (void)state;
  struct case_run a = with_set(KNOCKE, NULL, NULL);
  struct case_run b = with_set(KNOCKE, NULL, "albedo_level,factor=0.5");
  struct case_run c = with_set(KNOCKE, NULL, "earth_brightness,shift_K=-40");
  double vis = case_intensity(&a, 1, "vis", "grey_panel", UM_MECHANISM_EARTH);
  if (vis > 0.0)
    case_near("earthshine", case_intensity(&b, 1, "vis", "grey_panel", UM_MECHANISM_EARTH),
              0.5 * vis, 1e-6);
  assert_false(case_same(&a, &b));
  assert_true(case_same_temperatures(&a, &c));
  assert_false(case_same_intensities(&a, &c));
  case_release(&a);
  case_release(&b);
  case_release(&c);
}

static void refused_key(const char *set, const char *part)
{
  char text[4096];
  const char *at = strstr(case_satellite, "parts:\n");
  snprintf(text, sizeof text, "%.*senvironment: {earth: %s}\n%s", (int)(at - case_satellite),
           case_satellite, set, at);
  case_refused(text, NULL, part);
  um_core_message_clear(case_context());
}

static void what_cannot_be(void **state)
{
  (void)state;
  refused_key("mars", "environment.earth: 'mars' is not accepted; accepted: uniform, knocke, map");
  refused_key("{model: map}", "environment.earth.model: map wants a file; accepted: file");
  refused_key("{model: map, file: nowhere.csv}", "environment.earth.file: ");
  refused_key("{local: {latitude_deg: 3}}", "accepted: all three, or none for all of the Earth");
  refused_key("{local: {latitude_deg: 95, longitude_deg: 0, radius_km: 100}}", "latitude_deg");
  refused_key("{local: {from_utc: 2020-01-02T00:00:00Z, to_utc: 2020-01-01T00:00:00Z}}",
              "to_utc: accepted: a time later than from_utc");
  refused_key("{model: knocke, clouds: 3}", "clouds");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(map_of_one_value_is_uniform),
      cmocka_unit_test(anisotropy_is_of_places),
      cmocka_unit_test(switch_is_the_key),
      cmocka_unit_test(region_is_a_level_where_it_is),
      cmocka_unit_test(levels_scale_knocke),
      cmocka_unit_test(what_cannot_be),
  };
  return cmocka_run_group_tests(tests, case_begin, case_end);
}
