/* Pictures: rendered, kept factored, expanded, left by a run; read back with OpenEXR's own library.
 */
#include <math.h>
#include <openexr.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/app/command.h"
#include "tests/app/failure.h"
#include "tests/app/table.h"

#define RENDER "render", "box.yaml", "--width", "16", "--samples", "1"
#define MOMENT "--time", "2016-09-06T18:10:30Z"

/* One channel of a picture and its data window; the caller frees. */
static float *read_channel(const char *path, const char *name, exr_attr_box2i_t *window)
{
  exr_context_t file;
  exr_context_initializer_t start = EXR_DEFAULT_CONTEXT_INITIALIZER;
  assert_int_equal(exr_start_read(&file, path, &start), EXR_ERR_SUCCESS);
  assert_int_equal(exr_get_data_window(file, 0, window), EXR_ERR_SUCCESS);
  int rows = window->max.y - window->min.y + 1, width = window->max.x - window->min.x + 1,
      found = 0;
  float *pixels = calloc((size_t)(rows * width), sizeof *pixels);
  assert_non_null(pixels);
  exr_decode_pipeline_t decoder = EXR_DECODE_PIPELINE_INITIALIZER;
  for (int y = window->min.y; y <= window->max.y; y++) {
    exr_chunk_info_t chunk;
    assert_int_equal(exr_read_scanline_chunk_info(file, 0, y, &chunk), EXR_ERR_SUCCESS);
    assert_int_equal(y == window->min.y ? exr_decoding_initialize(file, 0, &chunk, &decoder)
                                        : exr_decoding_update(file, 0, &chunk, &decoder),
                     EXR_ERR_SUCCESS);
    for (int c = 0; c < decoder.channel_count; c++) {
      exr_coding_channel_info_t *channel = &decoder.channels[c];
      bool wanted = strcmp(channel->channel_name, name) == 0;
      found += wanted;
      channel->decode_to_ptr =
          wanted ? (uint8_t *)(pixels + (size_t)((y - window->min.y) * width)) : NULL;
      channel->user_pixel_stride = sizeof(float);
      channel->user_line_stride = width * (int)sizeof(float);
      channel->user_bytes_per_element = sizeof(float);
      channel->user_data_type = EXR_PIXEL_FLOAT;
    }
    if (y == window->min.y)
      assert_int_equal(exr_decoding_choose_default_routines(file, 0, &decoder), EXR_ERR_SUCCESS);
    assert_int_equal(exr_decoding_run(file, 0, &decoder), EXR_ERR_SUCCESS);
  }
  assert_int_equal(found, rows);
  exr_decoding_destroy(file, &decoder);
  assert_int_equal(exr_finish(&file), EXR_ERR_SUCCESS);
  return pixels;
}

/* The channels of a picture, sorted by name, NULL behind the last, and its units. */
static void expect_channels(const char *path, const char *const *names)
{
  exr_context_t file;
  exr_context_initializer_t start = EXR_DEFAULT_CONTEXT_INITIALIZER;
  const exr_attr_chlist_t *channels = NULL;
  const char *units = NULL;
  exr_storage_t storage;
  int parts = 0, length = 0;
  assert_int_equal(exr_start_read(&file, path, &start), EXR_ERR_SUCCESS);
  assert_int_equal(exr_get_count(file, &parts), EXR_ERR_SUCCESS);
  assert_int_equal(parts, 1);
  assert_int_equal(exr_get_storage(file, 0, &storage), EXR_ERR_SUCCESS);
  assert_int_equal(exr_get_channels(file, 0, &channels), EXR_ERR_SUCCESS);
  for (int i = 0; names[i] != NULL || i < channels->num_channels; i++) {
    assert_true(i < channels->num_channels && names[i] != NULL);
    assert_string_equal(channels->entries[i].name.str, names[i]);
  }
  assert_int_equal(exr_attr_get_string(file, 0, "emissiveUnits", &length, &units), EXR_ERR_SUCCESS);
  assert_string_equal(units, "W.m^-2.sr^-1.nm^-1");
  assert_int_equal(exr_finish(&file), EXR_ERR_SUCCESS);
}

/* Four bins of 0.38 to 0.78 um: centres 430, 530, 630, 730 nm; channels are sorted by name. The
 * preview: green is the mean of the second bin alone (a third of four), and a hundredth of the lit
 * picture and no more is above white. */
static void check_picture(const char *path)
{
  static const char *const names[] = {
      "B", "G", "R", "S0.430,000nm", "S0.530,000nm", "S0.630,000nm", "S0.730,000nm", NULL};
  exr_attr_box2i_t window;
  expect_channels(path, names);
  float *green = read_channel(path, "G", &window), *pixels = read_channel(path, names[4], &window);
  int n = (window.max.y - window.min.y + 1) * 16, lit = 0;
  assert_int_equal(window.max.x - window.min.x + 1, 16);
  double scale = 0.0;
  for (int i = 0; i < n; i++) {
    assert_true(pixels[i] >= 0.0f && green[i] >= 0.0f);
    if (pixels[i] == 0.0f) continue;
    lit++;
    if (scale == 0.0) scale = (double)(green[i] / pixels[i]);
    assert_true(fabs((double)(green[i] / pixels[i]) - scale) <= 1e-5 * scale);
  }
  assert_true(lit > 0); /* the box stands in sunlight */
  free(pixels);
  free(green);
}

/* A factored picture expands to the bytes of the picture that is rendered at once, and a part of it
 * to the numbers of that part. */
static void test_expand(void **state)
{
  (void)state;
  size_t n[2];
  command_copy_data("box.yaml");
  command_expect(0, RENDER, MOMENT, "--band", "vis", "-o", "a.exr", NULL);
  command_expect(0, RENDER, MOMENT, "--band", "vis", "-o", "a.nc", NULL);
  command_expect(0, "render", "a.nc", "-o", "b.exr", NULL);
  char *a = command_read_bytes("a.exr", &n[0]), *b = command_read_bytes("b.exr", &n[1]);
  assert_int_equal(n[0], n[1]);
  assert_memory_equal(a, b, n[0]);
  free(a);
  free(b);
  command_expect(0, "render", "a.nc", "--wavelengths", "0.5-0.7um", "--tile", "3,2,8,6", "-o",
                 "c.exr", NULL);
  expect_channels("c.exr",
                  (const char *const[]){"B", "G", "R", "S0.530,000nm", "S0.630,000nm", NULL});
  exr_attr_box2i_t whole, part;
  float *all = read_channel("a.exr", "S0.630,000nm", &whole);
  float *cut = read_channel("c.exr", "S0.630,000nm", &part);
  assert_int_equal(part.min.x, 3);
  assert_int_equal(part.min.y, 2);
  assert_int_equal(part.max.x, 10);
  assert_int_equal(part.max.y, 7);
  for (int y = 0; y < 6; y++)
    for (int x = 0; x < 8; x++) assert_true(cut[y * 8 + x] == all[(y + 2) * 16 + x + 3]);
  free(all);
  free(cut);
}

/* Files that are none, or no longer whole. */
static void test_expand_refuses(void **state)
{
  (void)state;
  static const struct failure cases[] = {
      {{"render", "none.nc", "-o", "x.exr"}, "none.nc: No such file"},
      {{"render", "text.nc", "-o", "x.exr"}, "text.nc: netCDF: "},
      {{"render", "half.nc", "-o", "x.exr"}, "half.nc: "},
      {{"render", "other.nc", "-o", "x.exr"}, "other.nc: is not a factored picture; accepted: "},
      {{"render", "a.nc", "--tile", "3,2,8", "-o", "x.exr"}, "--tile 3,2,8; accepted: X,Y,WIDTH"},
      {{"render", "a.nc", "--tile", "12,0,8,2", "-o", "x.exr"}, "accepted: inside 16 x "},
      {{"render", "a.nc", "--wavelengths", "2um-8", "-o", "x.exr"}, "accepted: FROM-TO in um"},
      {{"render", "a.nc", "--wavelengths", "8-12um", "-o", "x.exr"}, "accepted: 0.43 to 0.73 um"},
      {{RENDER, MOMENT, "--band", "vis", "--wavelengths", "8-12", "-o", "x.exr"},
       "accepted: 0.43-0.73um"},
      {{RENDER, MOMENT, "--band", "vis", "--tile", "0,0,1,1", "-o", "x.nc"},
       "with umbra render FILE.nc -o FILE.exr"},
  };
  size_t n;
  command_copy_data("box.yaml");
  command_write("text.nc", "schema: 1\n");
  command_expect(0, RENDER, MOMENT, "--band", "vis", "-o", "a.nc", NULL);
  char *bytes = command_read_bytes("a.nc", &n), *title = NULL;
  FILE *file = fopen("half.nc", "wb");
  assert_non_null(file);
  assert_int_equal(fwrite(bytes, 1, n / 2, file), n / 2);
  fclose(file);
  for (size_t i = 0; i + 22 < n && title == NULL; i++)
    if (memcmp(bytes + i, "Umbra factored picture", 22) == 0) title = bytes + i;
  assert_non_null(title);
  title[0] = 'u';
  file = fopen("other.nc", "wb");
  assert_non_null(file);
  assert_int_equal(fwrite(bytes, 1, n, file), n);
  fclose(file);
  free(bytes);
  failures_expect(cases, sizeof cases / sizeof cases[0]);
}

static void test_render(void **state)
{
  (void)state;
  command_copy_data("box.yaml");
  command_expect(0, RENDER, MOMENT, "--band", "vis", "-o", "a.exr", NULL);
  check_picture("a.exr");
  char *first = command_snapshot("a.exr");
  command_expect(1, RENDER, MOMENT, "--band", "lwir", "-o", "a.exr", NULL);
  char *second = command_snapshot("a.exr");
  assert_string_equal(second, first);
  command_expect(0, RENDER, MOMENT, "--band", "lwir", "--force", "-o", "a.exr", NULL);
  char *third = command_snapshot("a.exr");
  assert_string_not_equal(third, first);
  free(first);
  free(second);
  free(third);
}

/* Sum over a view's pixels of spectral radiance per nm, times bin [nm] and pixel [W/sr]. */
static double view_intensity(const char *path, const char *const *names, double bin, int *rows,
                             double *pixel)
{
  exr_context_t file;
  exr_context_initializer_t start = EXR_DEFAULT_CONTEXT_INITIALIZER;
  double sum = 0.0;
  assert_int_equal(exr_start_read(&file, path, &start), EXR_ERR_SUCCESS);
  assert_int_equal(exr_attr_get_double(file, 0, "pixelSizeM", pixel), EXR_ERR_SUCCESS);
  assert_int_equal(exr_finish(&file), EXR_ERR_SUCCESS);
  for (int k = 0; k < 4; k++) {
    exr_attr_box2i_t window;
    float *value = read_channel(path, names[k], &window);
    *rows = window.max.y - window.min.y + 1;
    int n = *rows * (window.max.x - window.min.x + 1);
    for (int i = 0; i < n; i++) sum += (double)value[i];
    free(value);
  }
  return sum * bin * *pixel * *pixel;
}

/* The sum over a view's pixels of spectral radiance per nm, times bin and pixel, is the light
 * curve's intensity at that instant: units and scale, within its standard error and a hundredth of
 * the box's outline (384 pixels across, 16 samples each). */
static void test_views(void **state)
{
  (void)state;
  static const char *const names[] = {"S0.430,000nm", "S0.530,000nm", "S0.630,000nm",
                                      "S0.730,000nm"};
  command_copy_data("box.yaml");
  command_expect(0, "run", "box.yaml", "--no-plots", "--out", "out", "--picture",
                 "2016-09-06T18:10:10Z", "--picture", "first-light", NULL);
  const char *path = "out/view-20160906T181000Z-vis.exr";
  assert_true(command_exists("out/view-20160906T181000Z-lwir.exr"));
  double pixel = 0.0;
  int rows = 0;
  double sum = view_intensity(path, names, 100.0, &rows, &pixel);
  struct table t = table_read("out/lightcurve.csv");
  assert_string_equal(table_text(&t, 3, "time_utc"), "2016-09-06T18:10:00.000Z");
  double wanted = table_number(&t, 3, "vis_intensity_W_sr");
  /* the mean radiance that render states: E = L N Omega of its frame, box and sky */
  struct command c = command_run("render", "box.yaml", "--time", "2016-09-06T18:10:00Z", "--band",
                                 "vis", "--width", "384", "-o", "r.exr", NULL);
  const char *said = strstr(c.out, "mean radiance ");
  assert_non_null(said);
  double frame = strtod(said + 14, NULL) * 384.0 * rows * pixel * pixel;
  print_message("frame %.6g, ", frame);
  assert_true(fabs(frame - sum) <= 1e-4 * sum);
  command_release(&c);
  print_message("view %.6g, light curve %.6g W/sr\n", sum, wanted);
  assert_true(wanted > 0.0 && fabs(sum - wanted) <= 0.01 * wanted);
  table_release(&t);
  failure_expect(
      (const char *[]){"run", "box.yaml", "--out", "no", "--picture", "2016-09-06T19:10:10Z", NULL},
      "--picture 2016-09-06T19:10:10Z; accepted: 2016-09-06T18:07:00.000Z to ");
  failure_expect((const char *[]){"run", "box.yaml", "--out", "no", "--picture", "noon", NULL},
                 "--picture");
  failure_expect((const char *[]){"run", "box.yaml", "--out", "no", "--picture", "first-light",
                                  "--set", "time.stop_utc=2016-09-06T18:08:00Z", NULL},
                 "does not leave the shadow");
}

/* A picture shows the instant of the scenario, not a scenario that begins there: a body that turns
 * since the start and is not yet as warm as its orbit has the light curve's intensity, E = L N
 * Omega. The outline of 128 pixels across leaves 1 %; a spin that began at the instant is 20 % off
 * in sunlight, a body that began to cool there 23 % in the infrared. */
static void test_instant(void **state)
{
  (void)state;
  static const char *const bands[] = {"vis", "lwir"};
  char *text = command_edit(command_data("box.yaml"), "- lvlh: {}",
                            "- spin: {axis_gcrs: [0, 0, 1], axis_body: [1, 1, 0], period_s: 400}");
  text = command_edit(text, "[1, 1, 1]", "[1, 2, 3]");
  command_write("spin.yaml", text);
  free(text);
  command_expect(0, "run", "spin.yaml", "--no-plots", "--set", "time.step_s=30", "--out", "out",
                 NULL);
  struct table t = table_read("out/lightcurve.csv");
  assert_string_equal(table_text(&t, 7, "time_utc"), "2016-09-06T18:10:30.000Z");
  for (int b = 0; b < 2; b++) {
    char column[32];
    int width = 0, height = 0;
    double side = 0.0, mean = 0.0;
    snprintf(column, sizeof column, "%s_intensity_W_sr", bands[b]);
    struct command c = command_run("render", "spin.yaml", MOMENT, "--band", bands[b], "--width",
                                   "128", "--samples", "8", "--force", "-o", "r.exr", NULL);
    const char *said = strstr(c.out, "r.exr: ");
    assert_non_null(said);
    assert_int_equal(sscanf(said,
                            "r.exr: %d x %d pixels of %lf m, 4 wavelengths, mean radiance %lf",
                            &width, &height, &side, &mean),
                     4);
    double drawn = mean * width * height * side * side, wanted = table_number(&t, 7, column);
    print_message("%s: drawn %.5g, light curve %.5g W/sr\n", bands[b], drawn, wanted);
    assert_true(wanted > 0.0 && fabs(drawn - wanted) <= 0.01 * wanted);
    command_release(&c);
  }
  table_release(&t);
}

#define VIEW "run", "box.yaml", "--out", "no", "--picture"
#define PART "render", "p.nc", "-o"

/* Instants that the scenario does not reach, and names of another format, are refused before
 * anything is computed or written. */
static void test_refused(void **state)
{
  (void)state;
  static const struct failure cases[] = {
      {{RENDER, "--time", "2016-09-06T18:11:01Z", "--band", "vis", "-o", "a.exr"},
       "--time 2016-09-06T18:11:01Z; accepted: 2016-09-06T18:07:00.000Z to "
       "2016-09-06T18:11:00.000Z, the scenario's start_utc and stop_utc"},
      {{RENDER, "--time", "2016-09-06T18:06:59Z", "--band", "vis", "-o", "a.nc"},
       "--time 2016-09-06T18:06:59Z; accepted: 2016-09-06T18:07:00.000Z to "},
      {{RENDER, "--time", "2016-09-06T18:10:30Z", "--set", "time.stop_utc=2016-09-06T18:10:00Z",
        "--band", "vis", "-o", "a.nc"},
       "accepted: 2016-09-06T18:07:00.000Z to 2016-09-06T18:10:00.000Z"},
      {{VIEW, "2016-09-06T18:11:30Z"},
       "--picture 2016-09-06T18:11:30Z; accepted: 2016-09-06T18:07:00.000Z to "
       "2016-09-06T18:11:00.000Z, the scenario's start_utc and stop_utc, or first-light"},
      {{VIEW, "2016-09-06T18:06:30Z"}, "--picture 2016-09-06T18:06:30Z; accepted: "},
      {{RENDER, MOMENT, "--band", "vis", "-o", "a.png"},
       "a.png: no '.png' is written here; accepted: a name in .exr, .nc"},
      {{RENDER, MOMENT, "--band", "vis", "-o", "./a.ex"}, "accepted: a name in .exr, .nc"},
      {{RENDER, MOMENT, "--band", "vis", "-o", "a.exr.jpg"}, "a.exr.jpg: no '.jpg' is written"},
      {{RENDER, MOMENT, "--band", "vis", "--force", "-o", "box.yaml"}, "no '.yaml' is written"},
      {{PART, "b.nc"}, "b.nc: no '.nc' is written here; accepted: a name in .exr"},
      {{PART, "b.png"}, "accepted: a name in .exr"},
      {{"synth", "box.yaml", "--noise", "0.1", "--seed", "1", "-o", "m.png"},
       "m.png: a table is CSV, not .png; accepted: a name in .csv"},
      {{"synth", "box.yaml", "--noise", "0.1", "--seed", "1", "-o", "m.FITS"}, "a name in .csv"},
      {{"import", "box.yaml", "-o", "m.nc"}, "m.nc: a table is CSV, not .nc"},
  };
  command_copy_data("box.yaml");
  command_write("p.nc", "");
  failures_expect(cases, sizeof cases / sizeof cases[0]);
  /* the ends themselves, and capitals; a name without an ending is OpenEXR */
  command_expect(0, RENDER, "--time", "2016-09-06T18:07:00Z", "--band", "lwir", "-o", "A.EXR",
                 NULL);
  command_expect(0, RENDER, "--time", "2016-09-06T18:11:00Z", "--band", "lwir", "-o", "d", NULL);
}

/* Light between surfaces is in pictures as in light curves: with the panel's light on the bus the
 * view has the light curve's intensity within its standard error and 0.2 % of outline, and without
 * it the difference is several times that. */
static void test_views_between(void **state)
{
  (void)state;
  static const char *const names[] = {"S0.8500,000nm", "S0.9500,000nm", "S0.10500,000nm",
                                      "S0.11500,000nm"};
  double pixel;
  int rows;
  command_copy_data("two_parts.yaml");
  command_expect(0, "run", "two_parts.yaml", "--no-plots", "--out", "out", "--set",
                 "optics.interreflection_samples=256", "--set", "optics.samples=256", "--picture",
                 "2016-09-06T18:10:06Z", NULL);
  double sum = view_intensity("out/view-20160906T181006Z-lwir.exr", names, 1000.0, &rows, &pixel);
  struct table t = table_read("out/lightcurve.csv");
  double wanted = table_number(&t, 3, "lwir_intensity_W_sr");
  double error = table_number(&t, 3, "lwir_stderr_W_sr");
  double between = table_number(&t, 3, "lwir_interreflected_W_sr");
  print_message("view %.6g, light curve %.6g +- %.2g, %.3g between surfaces W/sr\n", sum, wanted,
                error, between);
  assert_true(between > 4.0 * error + 0.002 * wanted);
  assert_true(fabs(sum - wanted) <= 4.0 * error + 0.002 * wanted);
  table_release(&t);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_render, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_expand, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_expand_refuses, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_views, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_instant, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_refused, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_views_between, command_enter, command_leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
