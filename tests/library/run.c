/* A run by the library: the same bytes as the command's, arrays of the same numbers, errors,
 * callbacks, ownership. */
#include <math.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "library/umbra.h"
#include "tests/app/command.h"

static const char *const tables[] = {"lightcurve.csv", "materials.csv", "temperatures.csv",
                                     "heat.csv", NULL};
static const char sphere[] = UMBRA_SOURCE_DIR "/scenarios/sphere";

static struct umbra *umbra;

static int enter(void **state)
{
  if (command_enter(state) != 0) return -1;
  return umbra_open(NULL, &umbra) == UMBRA_OK ? 0 : -1;
}

static int leave(void **state)
{
  umbra_close(&umbra);
  return command_leave(state);
}

#define ok(call)                                                                                   \
  do {                                                                                             \
    if ((call) != UMBRA_OK) fail_msg("%s: %s", #call, umbra_message(umbra));                       \
  } while (0)

/* The call is refused, with these words. */
#define refused(call, expected, words)                                                             \
  do {                                                                                             \
    assert_int_equal(call, expected);                                                              \
    if (strstr(umbra_message(umbra), words) == NULL)                                               \
      fail_msg("'%s' does not say '%s'", umbra_message(umbra), words);                             \
  } while (0)

static struct umbra_result *run(struct umbra_scenario *scenario)
{
  struct umbra_model *model;
  struct umbra_result *result;
  ok(umbra_model_build(umbra, scenario, &model));
  ok(umbra_run(umbra, model, &result));
  umbra_model_close(&model); /* the result keeps it */
  return result;
}

static struct umbra_result *run_box(void)
{
  struct umbra_scenario *scenario;
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  struct umbra_result *result = run(scenario);
  umbra_scenario_close(&scenario);
  return result;
}

static void test_sphere_as_the_command(void **state)
{
  (void)state;
  struct umbra_scenario *scenario;
  ok(umbra_scenario_read(umbra, sphere, NULL, &scenario));
  struct umbra_result *result = run(scenario);
  ok(umbra_result_write(umbra, result, "ours", NULL));
  command_expect(0, "run", sphere, "--no-plots", "--out", "theirs", NULL);
  command_expect_same("ours", "theirs", tables);
  umbra_result_close(&result);
  umbra_scenario_close(&scenario);
}

static size_t lines_with(const char *path, const char *words)
{
  char *text = command_read(path);
  size_t n = 0;
  for (const char *at = text; (at = strstr(at, words)) != NULL; at++) n++;
  free(text);
  return n;
}

/* What a run logged is its own and its model's, whatever the session did before and after. */
static void test_log_of_a_run(void **state)
{
  (void)state;
  struct umbra_scenario *scenario;
  struct umbra_result *box = run_box();
  ok(umbra_scenario_read(umbra, sphere, NULL, &scenario));
  struct umbra_result *ball = run(scenario);
  ok(umbra_result_write(umbra, box, "box", NULL));
  ok(umbra_result_write(umbra, ball, "ball", NULL));
  assert_int_equal(lines_with("box/log.txt", "Earth orientation not given"), 1);
  assert_int_equal(lines_with("box/log.txt", "of 5 observations"), 1);
  assert_int_equal(lines_with("box/log.txt", "of 602 observations"), 0);
  assert_int_equal(lines_with("ball/log.txt", "of 602 observations"), 1);
  assert_int_equal(lines_with("ball/log.txt", "of 5 observations"), 0);
  umbra_result_close(&box);
  umbra_result_close(&ball);
  umbra_scenario_close(&scenario);
}

/* Changes mean what the options of the command do; one text and one file are one scenario. */
static void test_changes_as_the_command(void **state)
{
  (void)state;
  static const char *const name[] = {"emittance_factor"};
  static const double value[] = {0.7};
  struct umbra_scenario *scenario;
  struct umbra_effect_change emittance = UMBRA_EFFECT_CHANGE, albedo = UMBRA_EFFECT_CHANGE;
  command_copy_data("box.yaml");
  char *text = command_read("box.yaml");
  ok(umbra_scenario_read(umbra, NULL, text, &scenario));
  free(text);
  ok(umbra_scenario_set_number(umbra, scenario, "parts.bus.shell.areal_heat_capacity_J_m2_K",
                               3000.0 / 7.0));
  ok(umbra_scenario_set(umbra, scenario, "time.step_s", "40"));
  ok(umbra_scenario_set(umbra, scenario, "time.step_s", "30"));
  emittance.effect = "emittance";
  emittance.target = "grey_white";
  emittance.parameter = name;
  emittance.value = value;
  emittance.nparameter = 1;
  ok(umbra_scenario_effect(umbra, scenario, &emittance));
  albedo.effect = "albedo";
  albedo.off = 1;
  ok(umbra_scenario_effect(umbra, scenario, &albedo));
  struct umbra_result *result = run(scenario);
  ok(umbra_result_write(umbra, result, "ours", NULL));
  command_expect(0, "run", "box.yaml", "--no-plots", "--out", "theirs", "--set",
                 "parts.bus.shell.areal_heat_capacity_J_m2_K=428.57142857142856", "--set",
                 "time.step_s=30", "--with", "emittance:grey_white,emittance_factor=0.7",
                 "--without", "albedo", NULL);
  command_expect_same("ours", "theirs", tables);
  umbra_result_close(&result);
  umbra_scenario_close(&scenario);
}

static double column(const char *table, size_t row, const char *name)
{
  size_t at = 0;
  const char *header = table, *found = strstr(table, name);
  assert_non_null(found);
  for (; header < found; header++) at += *header == ',';
  for (size_t i = 0; i <= row; i++) table = strchr(table, '\n') + 1;
  for (; at > 0; at--) table = strchr(table, ',') + 1;
  return *table == ',' ? (double)NAN : strtod(table, NULL);
}

/* Arrays beside the tables, which state ten digits. */
static void test_arrays(void **state)
{
  (void)state;
  static const struct {
    const char *array, *column;
    size_t offset;
  } pairs[] = {{"irradiance", "vis_irradiance_W_m2", 0},  {"intensity", "lwir_intensity_W_sr", 1},
               {"intensity_error", "vis_stderr_W_sr", 0}, {"magnitude_ab", "vis_mag_ab", 0},
               {"magnitude_vega", "vis_mag_vega", 0},     {"sunlit", "sunlit_fraction", 0}};
  struct umbra_result *result = run_box();
  ok(umbra_result_write(umbra, result, "out", NULL));
  char *light = command_read("out/lightcurve.csv"), *heat = command_read("out/temperatures.csv");
  const struct umbra_array *time = umbra_result_array(result, "time_unix_s");
  assert_int_equal(time->dimensions, 1);
  assert_int_equal(time->shape[0], 5);
  assert_close(time->data[1], 1473185280.0, 1e-6); /* 2016-09-06T18:08:00Z */
  for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
    const struct umbra_array *a = umbra_result_array(result, pairs[i].array);
    for (size_t k = 0; k < 5; k++) {
      double value = a->data[k * (a->dimensions == 2 ? a->shape[1] : 1) + pairs[i].offset];
      double expected = column(light, k, pairs[i].column);
      if (isnan(expected) || isinf(expected)) continue;
      assert_close(value, expected, 1e-8 * fabs(expected));
    }
  }
  const struct umbra_array *range = umbra_result_array(result, "range_m");
  assert_close(range->data[2], 1e3 * column(light, 2, "range_km"), 1.0);
  const struct umbra_array *phase = umbra_result_array(result, "phase_angle_rad");
  assert_close(phase->data[2] * 57.29577951308232, column(light, 2, "phase_angle_deg"), 1e-5);
  const struct umbra_array *hidden = umbra_result_array(result, "hidden");
  assert_true(hidden->data[0] == 1.0 && hidden->data[4] == 0.0);
  const struct umbra_array *place = umbra_result_array(result, "temperature");
  assert_string_equal(place->unit, "K");
  assert_string_equal(place->axis[0], "place");
  assert_close(place->data[3], column(heat, 3, "bus.mean_K"), 1e-4);
  place = umbra_result_array(result, "temperature_lowest");
  assert_close(place->data[3], column(heat, 3, "bus.min_K"), 1e-4);
  place = umbra_result_array(result, "temperature_highest");
  assert_close(place->data[3], column(heat, 3, "bus.max_K"), 1e-4);
  free(light);
  free(heat);
  umbra_result_close(&result);
}

/* By number every array comes once, and parts of the intensity add to it. */
static void test_arrays_by_number(void **state)
{
  (void)state;
  struct umbra_result *result = run_box();
  size_t n = 0;
  for (const struct umbra_array *a; (a = umbra_result_array_at(result, n)) != NULL; n++) {
    assert_ptr_equal(umbra_result_array(result, a->name), a);
    assert_true(a->dimensions >= 1 && a->unit != NULL && a->axis[a->dimensions - 1] != NULL);
  }
  assert_true(n >= 17);
  assert_null(umbra_result_array(result, "colour"));
  const struct umbra_array *parts = umbra_result_array(result, "intensity_parts");
  const struct umbra_array *whole = umbra_result_array(result, "intensity");
  size_t each = parts->shape[2] * parts->shape[3];
  for (size_t i = 0; i < whole->shape[0] * whole->shape[1]; i++) {
    double sum = 0.0;
    for (size_t j = 0; j < each; j++) sum += parts->data[i * each + j];
    assert_close(sum, whole->data[i], 1e-12 * fabs(whole->data[i]));
  }
  umbra_result_close(&result);
}

static void test_names(void **state)
{
  (void)state;
  static const char *const expected[] = {"bus", "bus.interior", "grey_white", "vis", NULL};
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  const char *const *name;
  size_t n;
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  ok(umbra_model_build(umbra, scenario, &model));
  umbra_scenario_close(&scenario);
  for (int kind = UMBRA_PARTS; kind <= UMBRA_SENSORS; kind++) {
    ok(umbra_model_names(umbra, model, (enum umbra_names)kind, &name, &n));
    if (kind == UMBRA_SENSORS) assert_int_equal(n, 0);
    if (kind == UMBRA_PLACES) {
      assert_string_equal(name[0], "bus");
      assert_string_equal(name[n - 1], "material:grey_white");
    } else if (n > 0) {
      assert_string_equal(name[0], expected[kind]);
    }
  }
  refused(umbra_model_names(umbra, model, (enum umbra_names)9, &name, &n), UMBRA_ERR_INPUT,
          "accepted: 0 to 4");
  umbra_model_close(&model);
}

static void test_errors(void **state)
{
  (void)state;
  struct umbra_scenario *scenario;
  struct umbra_settings settings = UMBRA_SETTINGS;
  struct umbra *other;
  settings.size -= 8;
  assert_int_equal(umbra_open(&settings, &other), UMBRA_ERR_INPUT);
  assert_null(other);
  refused(umbra_scenario_read(umbra, "no-such", NULL, &scenario), UMBRA_ERR_IO, "no-such");
  assert_null(scenario);
  refused(umbra_scenario_read(umbra, NULL, NULL, &scenario), UMBRA_ERR_INPUT, "no scenario");
  refused(umbra_scenario_read(umbra, NULL, "schema: 1\nname: x\ncolour: red\n", &scenario),
          UMBRA_ERR_INPUT, "colour");
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  refused(umbra_scenario_set(umbra, scenario, "time.step", "3"), UMBRA_ERR_INPUT, "time.step");
  refused(umbra_scenario_set(umbra, scenario, "a=b", "3"), UMBRA_ERR_INPUT, "'='");
  refused(umbra_scenario_set_number(umbra, scenario, "time.step_s", -1.0), UMBRA_ERR_INPUT,
          "time.step_s");
  refused(umbra_scenario_set_number(umbra, scenario, "time.step_s", (double)NAN), UMBRA_ERR_INPUT,
          "finite");
  ok(umbra_scenario_set(umbra, scenario, "time.step_s", "120")); /* none of them stayed */
  struct umbra_result *result = run(scenario);
  assert_int_equal(umbra_result_array(result, "time_unix_s")->shape[0], 3);
  assert_string_equal(umbra_message(umbra), "");
  command_write("file", "not a folder of Umbra");
  refused(umbra_result_write(umbra, result, "file", NULL), UMBRA_ERR_IO, "file");
  struct umbra_write write = UMBRA_WRITE;
  write.size++;
  refused(umbra_result_write(umbra, result, "out", &write), UMBRA_ERR_INPUT, "size");
  umbra_result_close(&result);
  umbra_scenario_close(&scenario);
}

static void test_errors_of_effects(void **state)
{
  (void)state;
  static const char *const name[] = {"emittance_factor"}, *const wrong[] = {"emitance_factor"};
  static const double value[] = {0.7}, large[] = {70.0};
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  struct umbra_effect_change change = UMBRA_EFFECT_CHANGE;
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  refused(umbra_scenario_effect(umbra, scenario, &change), UMBRA_ERR_INPUT, "names no effect");
  change.effect = "emitance";
  refused(umbra_scenario_effect(umbra, scenario, &change), UMBRA_ERR_INPUT, "emittance");
  change.effect = "emittance";
  refused(umbra_scenario_effect(umbra, scenario, &change), UMBRA_ERR_INPUT, "needs a target");
  change.target = "paint";
  change.parameter = wrong;
  change.value = value;
  change.nparameter = 1;
  refused(umbra_scenario_effect(umbra, scenario, &change), UMBRA_ERR_INPUT, "emittance_factor");
  change.parameter = name;
  change.value = large;
  refused(umbra_scenario_effect(umbra, scenario, &change), UMBRA_ERR_INPUT, "0.1 to 10");
  change.value = value;
  change.size = 1;
  refused(umbra_scenario_effect(umbra, scenario, &change), UMBRA_ERR_INPUT, "size");
  change.size = sizeof change;
  ok(umbra_scenario_effect(umbra, scenario, &change)); /* whether there is a paint is seen here: */
  refused(umbra_model_build(umbra, scenario, &model), UMBRA_ERR_INPUT, "'paint'");
  assert_null(model);
  change = (struct umbra_effect_change)UMBRA_EFFECT_CHANGE;
  change.effect = "albedo";
  change.target = "grey_white";
  refused(umbra_scenario_effect(umbra, scenario, &change), UMBRA_ERR_INPUT, "no target");
  umbra_scenario_close(&scenario);
}

struct heard {
  int lines, steps, asked, limit;
};

static void hear_line(void *self, enum umbra_log_level level, const char *line)
{
  assert_true(level <= UMBRA_LOG_ERROR && strlen(line) > 0);
  ((struct heard *)self)->lines++;
}

static int hear_progress(void *self, const char *task, size_t done, size_t total)
{
  assert_non_null(task);
  assert_true(done <= total || total == 0);
  struct heard *h = self;
  return ++h->steps < h->limit;
}

static int hear_stop(void *self)
{
  ((struct heard *)self)->asked = 1;
  return 1;
}

/* What the callbacks are told, and that they end the work. */
static void test_callbacks(void **state)
{
  (void)state;
  struct heard heard = {.limit = 1000000};
  struct umbra_settings settings = UMBRA_SETTINGS;
  settings.threads = 1;
  settings.self = &heard;
  settings.log = hear_line;
  settings.progress = hear_progress;
  umbra_close(&umbra);
  assert_int_equal(umbra_open(&settings, &umbra), UMBRA_OK);
  struct umbra_result *result = run_box();
  umbra_result_close(&result);
  assert_true(heard.lines > 3 && heard.steps > 3);
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  ok(umbra_model_build(umbra, scenario, &model));
  heard.limit = 0;
  refused(umbra_run(umbra, model, &result), UMBRA_ERR_CANCELLED, "cancelled");
  assert_null(result);
  umbra_model_close(&model);
  umbra_scenario_close(&scenario);
  settings.stop = hear_stop;
  umbra_close(&umbra);
  assert_int_equal(umbra_open(&settings, &umbra), UMBRA_OK);
  refused(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario), UMBRA_ERR_CANCELLED,
          "cancelled");
  assert_int_equal(heard.asked, 1);
}

/* Objects are closed in any order, the session first. */
static void test_ownership(void **state)
{
  (void)state;
  struct umbra *own;
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  struct umbra_result *result;
  command_copy_data("box.yaml");
  assert_int_equal(umbra_open(NULL, &own), UMBRA_OK);
  ok(umbra_scenario_read(own, "box.yaml", NULL, &scenario));
  ok(umbra_model_build(own, scenario, &model));
  ok(umbra_run(own, model, &result));
  umbra_close(&own);
  assert_null(own);
  umbra_scenario_close(&scenario);
  umbra_model_close(&model);
  assert_null(model);
  assert_true(umbra_result_array(result, "irradiance")->shape[1] == 2);
  umbra_result_close(&result);
  assert_null(result);
  umbra_close(NULL);
  umbra_scenario_close(&scenario);
  umbra_model_close(&model);
  umbra_result_close(&result);
}

/* View factors are kept where the session says, and taken from there. */
static void test_cache_folder(void **state)
{
  (void)state;
  struct umbra_settings settings = UMBRA_SETTINGS;
  struct umbra_scenario *scenario;
  settings.cache = "kept";
  umbra_close(&umbra);
  assert_int_equal(umbra_open(&settings, &umbra), UMBRA_OK);
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  ok(umbra_scenario_set_number(umbra, scenario, "parts.bus.inside_emittance", 0.8));
  assert_false(command_exists("kept"));
  struct umbra_result *first = run(scenario), *second = run(scenario);
  assert_true(command_exists("kept"));
  const struct umbra_array *a = umbra_result_array(first, "temperature");
  const struct umbra_array *b = umbra_result_array(second, "temperature");
  assert_memory_equal(a->data, b->data, a->shape[0] * a->shape[1] * sizeof *a->data);
  umbra_result_close(&first);
  umbra_result_close(&second);
  umbra_scenario_close(&scenario);
}

struct lane {
  pthread_t thread;
  double sum;
  bool good;
};

static void *run_lane(void *self)
{
  struct lane *lane = self;
  struct umbra_settings settings = UMBRA_SETTINGS;
  struct umbra *own;
  struct umbra_scenario *scenario = NULL;
  struct umbra_model *model = NULL;
  struct umbra_result *result = NULL;
  settings.threads = 1;
  lane->good = umbra_open(&settings, &own) == UMBRA_OK &&
               umbra_scenario_read(own, "box.yaml", NULL, &scenario) == UMBRA_OK &&
               umbra_model_build(own, scenario, &model) == UMBRA_OK &&
               umbra_run(own, model, &result) == UMBRA_OK;
  for (size_t i = 0; lane->good && i < 10; i++)
    lane->sum += umbra_result_array(result, "intensity")->data[i];
  umbra_result_close(&result);
  umbra_model_close(&model);
  umbra_scenario_close(&scenario);
  umbra_close(&own);
  return NULL;
}

/* Sessions work side by side: the same bits. */
static void test_threads(void **state)
{
  (void)state;
  struct lane lane[4] = {0};
  struct umbra_result *result = run_box();
  double expected = 0.0;
  for (size_t i = 0; i < 10; i++) expected += umbra_result_array(result, "intensity")->data[i];
  umbra_result_close(&result);
  for (size_t i = 0; i < 4; i++)
    assert_int_equal(pthread_create(&lane[i].thread, NULL, run_lane, &lane[i]), 0);
  for (size_t i = 0; i < 4; i++) {
    assert_int_equal(pthread_join(lane[i].thread, NULL), 0);
    assert_true(lane[i].good && lane[i].sum == expected);
  }
}

struct guest {
  pthread_t thread;
  struct umbra_model *model;
  struct umbra *own;
  struct umbra_result *result;
};

static void *run_guest(void *self)
{
  struct guest *guest = self;
  struct umbra_settings settings = UMBRA_SETTINGS;
  settings.threads = 1;
  if (umbra_open(&settings, &guest->own) == UMBRA_OK)
    (void)umbra_run(guest->own, guest->model, &guest->result);
  return NULL;
}

static void expect_same_result(const struct umbra_result *a, const struct umbra_result *b)
{
  for (size_t i = 0; umbra_result_array_at(a, i) != NULL; i++) {
    const struct umbra_array *x = umbra_result_array_at(a, i), *y = umbra_result_array_at(b, i);
    size_t n = 1;
    assert_string_equal(x->name, y->name);
    for (size_t k = 0; k < x->dimensions; k++) n *= x->shape[k];
    assert_memory_equal(x->data, y->data, n * sizeof *x->data);
  }
}

/* Eight sessions run one model at once: the same bits. */
static void test_one_model(void **state)
{
  (void)state;
  struct guest guest[8] = {0};
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  struct umbra_result *alone;
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  ok(umbra_model_build(umbra, scenario, &model));
  ok(umbra_run(umbra, model, &alone));
  for (size_t i = 0; i < 8; i++) {
    guest[i].model = model;
    assert_int_equal(pthread_create(&guest[i].thread, NULL, run_guest, &guest[i]), 0);
  }
  for (size_t i = 0; i < 8; i++) {
    assert_int_equal(pthread_join(guest[i].thread, NULL), 0);
    assert_non_null(guest[i].result);
    expect_same_result(alone, guest[i].result);
    umbra_result_close(&guest[i].result);
    umbra_close(&guest[i].own);
  }
  umbra_result_close(&alone);
  umbra_model_close(&model);
  umbra_scenario_close(&scenario);
}

/* The data folder that is given goes before the others. */
static void test_data_folder(void **state)
{
  (void)state;
  struct umbra_settings settings = UMBRA_SETTINGS;
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  settings.data = "nowhere";
  umbra_close(&umbra);
  assert_int_equal(umbra_open(&settings, &umbra), UMBRA_OK);
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  refused(umbra_model_build(umbra, scenario, &model), UMBRA_ERR_IO, "nowhere");
  umbra_scenario_close(&scenario);
}

static double last(const struct umbra_result *result, const char *name)
{
  const struct umbra_array *a = umbra_result_array(result, name);
  assert_non_null(a);
  return a->data[a->shape[0] * a->shape[1] - 1];
}

static struct umbra_result *variant(struct umbra_variants *variants,
                                    const struct umbra_change *change, size_t n)
{
  struct umbra_result *result;
  ok(umbra_variant_run(umbra, variants, change, n, &result));
  return result;
}

/* A variant has the bits of a scenario with its changes where that is asked for, and is near
 * otherwise; the model stays; objects are closed in any order. */
static void test_variants(void **state)
{
  (void)state;
  static const char *const name[] = {"emittance_factor"};
  static const double value[] = {0.7};
  struct umbra_effect_change emittance = UMBRA_EFFECT_CHANGE;
  struct umbra_variants_settings exact = UMBRA_VARIANTS_SETTINGS;
  struct umbra_change change[2] = {UMBRA_CHANGE, UMBRA_CHANGE};
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  struct umbra_variants *cold, *warm;
  emittance.effect = "emittance";
  emittance.target = "grey_white";
  emittance.parameter = name;
  emittance.value = value;
  emittance.nparameter = 1;
  change[0].effect = &emittance;
  change[1].key = "environment.albedo";
  change[1].number = 0.2;
  exact.exact = 1;
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  ok(umbra_model_build(umbra, scenario, &model));
  ok(umbra_variants_open(umbra, model, &exact, &cold));
  ok(umbra_variants_open(umbra, model, NULL, &warm));
  struct umbra_result *nominal = variant(cold, NULL, 0), *a = variant(cold, change, 2),
                      *b = variant(warm, change, 2), *again = variant(cold, NULL, 0);
  umbra_variants_close(&cold);
  umbra_variants_close(&warm);
  ok(umbra_scenario_set_number(umbra, scenario, change[1].key, change[1].number));
  ok(umbra_scenario_effect(umbra, scenario, &emittance));
  struct umbra_result *own = run(scenario);
  const char *const of[] = {"intensity", "temperature"};
  for (size_t i = 0; i < 2; i++) {
    assert_true(last(a, of[i]) == last(own, of[i]));
    assert_true(last(nominal, of[i]) == last(again, of[i]));
    assert_true(last(nominal, of[i]) != last(own, of[i]));
  }
  assert_close(last(b, "temperature"), last(own, "temperature"), 0.1);
  refused(umbra_result_write(umbra, a, "variant", NULL), UMBRA_ERR_INPUT,
          "a variant is not written");
  umbra_model_close(&model);
  umbra_result_close(&nominal);
  umbra_result_close(&a);
  umbra_result_close(&b);
  umbra_result_close(&again);
  umbra_result_close(&own);
  umbra_scenario_close(&scenario);
}

static void test_variants_refused(void **state)
{
  (void)state;
  struct umbra_variants_settings settings = UMBRA_VARIANTS_SETTINGS;
  struct umbra_change change = UMBRA_CHANGE;
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  struct umbra_variants *variants;
  struct umbra_result *result;
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  ok(umbra_model_build(umbra, scenario, &model));
  settings.temperature_K = -1.0;
  refused(umbra_variants_open(umbra, model, &settings, &variants), UMBRA_ERR_INPUT, "0 to 10 K");
  ok(umbra_variants_open(umbra, model, NULL, &variants));
  refused(umbra_variant_run(umbra, variants, &change, 1, &result), UMBRA_ERR_INPUT,
          "a key or an effect");
  change.key = "parts.bus.no_such_key";
  refused(umbra_variant_run(umbra, variants, &change, 1, &result), UMBRA_ERR_INPUT, "no_such_key");
  assert_null(result);
  change.key = "environment.albedo";
  change.number = 2.0;
  refused(umbra_variant_run(umbra, variants, &change, 1, &result), UMBRA_ERR_INPUT, "out of range");
  change.key = "time.start_utc"; /* no clock that counts seconds is meant */
  refused(umbra_variant_run(umbra, variants, &change, 1, &result), UMBRA_ERR_INPUT, "a UTC time");
  umbra_variants_close(&variants);
  umbra_model_close(&model);
  umbra_scenario_close(&scenario);
}

/* A set of one key. */
static void put(struct umbra_change *change, struct umbra_changes *set, const char *key, double to)
{
  *change = (struct umbra_change)UMBRA_CHANGE;
  change->key = key;
  change->number = to;
  *set = (struct umbra_changes){change, 1};
}

/* Numbers of a set are those of the same variant alone, for any number of processes, and NaN where
 * the model refuses it. */
static void expect_sets(const struct umbra_result *many, struct umbra_variants *variants,
                        const struct umbra_changes *set, size_t nset)
{
  for (size_t a = 0; a < 2; a++) {
    const struct umbra_array *all = umbra_result_array_at(many, a);
    assert_int_equal(all->shape[0], nset);
    assert_string_equal(all->axis[0], "set");
    for (size_t i = 0; i < nset; i++) {
      struct umbra_result *one = NULL;
      enum umbra_status status =
          umbra_variant_run(umbra, variants, set[i].change, set[i].nchange, &one);
      size_t n = all->shape[1] * all->shape[2];
      if (status == UMBRA_OK) {
        const struct umbra_array *alone = umbra_result_array(one, all->name);
        assert_null(umbra_result_refusal(many, i));
        assert_int_equal(alone->dimensions + 1, all->dimensions);
        assert_memory_equal(alone->data, all->data + i * n, n * sizeof *all->data);
      } else {
        assert_string_equal(umbra_result_refusal(many, i), umbra_message(umbra));
        assert_true(isnan(all->data[i * n]));
      }
      umbra_result_close(&one);
    }
  }
}

static void test_many(void **state)
{
  (void)state;
  static const char *const wanted[] = {"intensity", "temperature"};
  struct umbra_variants_settings exact = UMBRA_VARIANTS_SETTINGS;
  struct umbra_many how = UMBRA_MANY;
  struct umbra_change change[6];
  struct umbra_changes set[6];
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  struct umbra_variants *variants;
  struct umbra_result *result;
  put(&change[0], &set[0], "environment.albedo", 2.0); /* out of range */
  put(&change[1], &set[1], "environment.albedo", 0.2);
  put(&change[2], &set[2], "parts.box.no_such_key", 1.0);
  put(&change[3], &set[3], "environment.olr_W_m2", 200.0);
  put(&change[4], &set[4], "time.step_s", 5.0); /* has more rows */
  put(&change[5], &set[5], "environment.albedo", 0.4);
  how.array = wanted;
  how.narray = 2;
  exact.exact = 1;
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  ok(umbra_model_build(umbra, scenario, &model));
  for (int i = 0; i < 2; i++) {
    ok(umbra_variants_open(umbra, model, i == 0 ? &exact : NULL, &variants));
    for (how.workers = 1; how.workers < 4; how.workers += 2) {
      ok(umbra_evaluate_many(umbra, variants, set, 4, &how, &result));
      expect_sets(result, variants, set, 4);
      umbra_result_close(&result);
    }
    ok(umbra_evaluate_many(umbra, variants, set + 3, 3, &how, &result));
    assert_non_null(strstr(umbra_result_refusal(result, 1), "not as large"));
    assert_null(umbra_result_refusal(result, 2));
    umbra_variants_close(&variants); /* the result keeps it */
    refused(umbra_result_write(umbra, result, "many", NULL), UMBRA_ERR_INPUT, "are not written");
    umbra_result_close(&result);
  }
  umbra_model_close(&model);
  umbra_scenario_close(&scenario);
}

static void test_many_refused(void **state)
{
  (void)state;
  static const char *const wanted[] = {"intensity_parts", "brightness"};
  struct umbra_effect_change effect = UMBRA_EFFECT_CHANGE;
  struct umbra_many how = UMBRA_MANY;
  struct umbra_change change[2];
  struct umbra_changes set[2];
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  struct umbra_variants *variants;
  struct umbra_result *result;
  put(&change[0], &set[0], "environment.albedo", 2.0);
  put(&change[1], &set[1], "environment.albedo", 0.2);
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  ok(umbra_model_build(umbra, scenario, &model));
  ok(umbra_variants_open(umbra, model, NULL, &variants));
  refused(umbra_evaluate_many(umbra, variants, set, 0, NULL, &result), UMBRA_ERR_INPUT, "no set");
  refused(umbra_evaluate_many(umbra, variants, set, 1, NULL, &result), UMBRA_ERR_INPUT,
          "out of range");
  assert_null(result);
  how.narray = 1;
  for (size_t i = 0; i < 2; i++) {
    how.array = &wanted[i];
    refused(umbra_evaluate_many(umbra, variants, set, 2, &how, &result), UMBRA_ERR_INPUT,
            wanted[i]);
  }
  ok(umbra_evaluate_many(umbra, variants, set, 2, NULL, &result));
  assert_string_equal(umbra_result_array_at(result, 0)->name, "irradiance");
  assert_null(umbra_result_array_at(result, 1));
  umbra_result_close(&result);
  effect.effect = "no_such_effect";
  change[1] = (struct umbra_change)UMBRA_CHANGE;
  change[1].effect = &effect;
  refused(umbra_evaluate_many(umbra, variants, set, 2, NULL, &result), UMBRA_ERR_INPUT, "set 2: ");
  umbra_variants_close(&variants);
  umbra_model_close(&model);
  umbra_scenario_close(&scenario);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_sphere_as_the_command, enter, leave),
      cmocka_unit_test_setup_teardown(test_log_of_a_run, enter, leave),
      cmocka_unit_test_setup_teardown(test_changes_as_the_command, enter, leave),
      cmocka_unit_test_setup_teardown(test_arrays, enter, leave),
      cmocka_unit_test_setup_teardown(test_arrays_by_number, enter, leave),
      cmocka_unit_test_setup_teardown(test_names, enter, leave),
      cmocka_unit_test_setup_teardown(test_errors, enter, leave),
      cmocka_unit_test_setup_teardown(test_errors_of_effects, enter, leave),
      cmocka_unit_test_setup_teardown(test_callbacks, enter, leave),
      cmocka_unit_test_setup_teardown(test_ownership, enter, leave),
      cmocka_unit_test_setup_teardown(test_variants, enter, leave),
      cmocka_unit_test_setup_teardown(test_variants_refused, enter, leave),
      cmocka_unit_test_setup_teardown(test_many, enter, leave),
      cmocka_unit_test_setup_teardown(test_many_refused, enter, leave),
      cmocka_unit_test_setup_teardown(test_cache_folder, enter, leave),
      cmocka_unit_test_setup_teardown(test_threads, enter, leave),
      cmocka_unit_test_setup_teardown(test_one_model, enter, leave),
      cmocka_unit_test_setup_teardown(test_data_folder, enter, leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
