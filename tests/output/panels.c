/* Directions in the pictures of the satellite, told by hand from a set-up with round numbers. A
 * stand-in for gnuplot keeps the script, which is removed after drawing.
 *
 *        up = x (away from the Earth)
 *        |
 *        o---- right = -y          the observer is at z, out of the picture */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "output/output.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"

#define SIDE 10 /* pixels */

static char folder[UM_TEST_PATH], *search; /* of programs, as it was */
static struct um_context *context;

static int enter(void **state)
{
  (void)state;
  char path[UM_TEST_PATH + 16];
  if (um_test_folder_create(folder) != 0) return -1;
  snprintf(path, sizeof path, "%s/gnuplot", folder);
  FILE *file = fopen(path, "w");
  if (file == NULL) return -1;
  fputs("#!/bin/sh\nexec /bin/cp satellite.gp kept.gp\n", file);
  if (fclose(file) != 0 || chmod(path, 0755) != 0) return -1;
  search = getenv("PATH") == NULL ? NULL : strdup(getenv("PATH"));
  setenv("PATH", folder, 1);
  return um_core_context_create(NULL, &context) == UM_OK ? 0 : -1;
}

static int leave(void **state)
{
  (void)state;
  static const char *const made[] = {"gnuplot", "kept.gp"};
  um_core_context_destroy(&context);
  if (search != NULL) setenv("PATH", search, 1);
  free(search);
  for (size_t i = 0; i < 2; i++) {
    char path[UM_TEST_PATH + 16];
    snprintf(path, sizeof path, "%s/%s", folder, made[i]);
    remove(path);
  }
  return um_test_folder_remove(folder); /* raw pictures and script are gone */
}

/* The script of one picture, its lower right corner covered; the caller frees. */
static const char *draw(const struct um_environment_sample *sample)
{
  /* lines of the lower half see one surface on their right half */
  struct um_optics_image_share share[SIDE / 2];
  uint32_t first[SIDE / 2 + 1], surface = 0;
  struct um_optics_image_row row[SIDE];
  float dark = 1e6f, sun = 0.0f;
  double wavelength = 5.5e-7, width = 4e-7, transmission = 1.0;
  size_t bins[] = {0, 1};
  memset(row, 0, sizeof row);
  for (uint32_t i = 0; i < SIDE / 2; i++) {
    share[i] = (struct um_optics_image_share){0, 4, 0};
    first[i] = i;
    row[SIDE / 2 + i] = (struct um_optics_image_row){SIDE / 2, SIDE / 2, first, share};
  }
  first[SIDE / 2] = SIDE / 2;
  const struct um_optics_image image = {.width = SIDE,
                                        .height = SIDE,
                                        .samples = 4,
                                        .pixel_size = 0.1,
                                        .nbin = 1,
                                        .nband = 1,
                                        .first = bins,
                                        .wavelength = &wavelength,
                                        .bin_width = &width,
                                        .transmission = &transmission,
                                        .nspectrum = 1,
                                        .surface = &surface,
                                        .dark = &dark,
                                        .sun = &sun,
                                        .row = row};
  const struct um_optics_band band = {.name = "vis", .from = 3.8e-7, .to = 7.8e-7};
  const struct um_output_panel panel = {&image, sample, &band, 0, "now"};
  assert_int_equal(um_output_plot_panels(context, &panel, 1, 1, folder), UM_OK);
  static char text[1 << 16]; /* of the last picture */
  char path[UM_TEST_PATH + 16];
  snprintf(path, sizeof path, "%s/kept.gp", folder);
  FILE *file = fopen(path, "rb");
  assert_non_null(file);
  memset(text, 0, sizeof text);
  assert_true(fread(text, 1, sizeof text - 1, file) > 0);
  fclose(file);
  return text;
}

static void expect(const char *text, const char *part)
{
  if (strstr(text, part) != NULL) return;
  fputs(text, stderr);
  fputs("\nlacks:\n", stderr);
  fputs(part, stderr);
  fail();
}

static void test_directions(void **state)
{
  (void)state;
  const struct um_environment_sample sample = {.r = {7e6, 0.0, 0.0},
                                               .sun = {0.0, -1.0, 0.0},
                                               .pole = {0.6, 0.0, 0.8},
                                               .sunlit_fraction = 1.0,
                                               .to_observer = {0.0, 0.0, 1.0}};
  const char *text = draw(&sample);
  /* lower left, the first that is as empty as others; arrows are a tenth of the side */
  expect(text, "set arrow 1 from graph 0.2000,0.2000 rto graph 0.0000,-0.1000 ");
  expect(text, "set label 1 'nadir' at ");
  expect(text, "set arrow 2 from graph 0.2000,0.2000 rto graph 0.0000,0.0600 ");
  expect(text, "set label 2 'N' at ");
  expect(text, "set arrow 3 from graph 0.2000,0.2000 rto graph 0.1000,0.0000 ");
  expect(text, "set label 3 'Sun' at ");
  expect(text, "vis 0.38–0.78 µm");
}

/* Along the line of sight there is a mark and no arrow; a Sun that is hidden stands in brackets. */
static void test_line_of_sight(void **state)
{
  (void)state;
  const struct um_environment_sample sample = {.r = {7e6, 0.0, 7e6}, /* up is still x */
                                               .sun = {0.0, 0.0, -1.0},
                                               .pole = {0.0, 0.0, 1.0},
                                               .sunlit_fraction = 0.0,
                                               .to_observer = {0.0, 0.0, 1.0}};
  const char *text = draw(&sample);
  expect(text, "set arrow 1 from graph 0.2000,0.2000 rto graph 0.0000,-0.0707 ");
  expect(text, "set label 2 '⊙ N' at ");
  expect(text, "set label 3 '⊗ (Sun)' at ");
  assert_null(strstr(text, "set arrow 2"));
  assert_null(strstr(text, "set arrow 3"));
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_directions, enter, leave),
      cmocka_unit_test_setup_teardown(test_line_of_sight, enter, leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
