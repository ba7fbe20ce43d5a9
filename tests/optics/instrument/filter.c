/* Curves of filters: what is read, what is refused and how, means over bins, and those that come
 * with the program. */
#include "optics/instrument/filter.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/core/listing.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"
#include "tests/support/with_context.h"

static enum um_status read_text(const char *text, char path[UM_TEST_PATH],
                                struct um_instrument_filter **out)
{
  um_test_file_create(path, text, strlen(text));
  um_core_message_clear(context);
  enum um_status status = um_instrument_filter_read(context, path, out);
  unlink(path);
  return status;
}

static void test_read(void **state)
{
  (void)state;
  char path[UM_TEST_PATH];
  struct um_instrument_filter *f;
  assert_int_equal(read_text("# a trapezium\nwavelength_nm,transmission\n500,0\n510,0.8\n590,0.8\n"
                             "600,0\n",
                             path, &f),
                   UM_OK);
  assert_int_equal(f->n, 4);
  assert_close(f->wavelength[3], 0.6e-6, 1e-21);
  assert_close(um_instrument_filter_mean(f, 0.5e-6, 0.51e-6), 0.4, 1e-12);
  assert_close(um_instrument_filter_mean(f, 0.52e-6, 0.58e-6), 0.8, 1e-12);
  assert_close(um_instrument_filter_mean(f, 0.4e-6, 0.7e-6), 0.8 * 90.0 / 300.0, 1e-12);
  assert_close(um_instrument_filter_mean(f, 0.7e-6, 0.8e-6), 0.0, 0.0);
  um_instrument_filter_destroy(context, &f);
  assert_null(f);
  um_instrument_filter_destroy(context, &f);
  assert_int_equal(read_text("transmission,wavelength_um\n1,0.5\n1,0.7\n", path, &f), UM_OK);
  /* of a top hat a..b: sqrt((b^2 - a^2)/2 / ln(b/a)) */
  assert_close(um_instrument_filter_pivot(f) * 1e6, sqrt(0.12 / log(1.4)), 1e-12);
  um_instrument_filter_destroy(context, &f);
  /* a line: the pivot of a triangle a..b that rises lies at a + 2 (b - a)/3, but for (b - a)^2/a */
  assert_int_equal(read_text("transmission,wavelength_nm\n0,500\n1,500.000003\n", path, &f), UM_OK);
  assert_close(um_instrument_filter_pivot(f) * 1e9, 500.000002, 1e-12 * 500.0);
  um_instrument_filter_destroy(context, &f);
}

static void refused(const char *text, const char *tail)
{
  char path[UM_TEST_PATH], expected[UM_TEST_PATH + 300];
  struct um_instrument_filter *f;
  assert_int_equal(read_text(text, path, &f), UM_ERR_INPUT);
  assert_null(f);
  snprintf(expected, sizeof expected, "%s%s", path, tail);
  assert_string_equal(um_core_message(context), expected);
}

static void test_refused(void **state)
{
  (void)state;
#define HEAD "wavelength_nm,transmission\n"
  refused("wavelength,transmission\n500,1\n600,1\n",
          ": no column of wavelengths; accepted: one of the columns wavelength_um and "
          "wavelength_nm");
  refused("wavelength_nm,wavelength_um,transmission\n500,0.5,1\n600,0.6,1\n",
          ": wavelengths twice; accepted: one of the columns wavelength_um and wavelength_nm");
  refused(HEAD "500,1\n", ": 1 rows; accepted: 2 or more");
  refused(HEAD "500,1\n490,1\n",
          ":3: column 'wavelength_nm': 490 follows 500; accepted: ascending values");
  refused(HEAD "500,1\n500,1\n",
          ":3: column 'wavelength_nm': 500 follows 500; accepted: ascending values");
  refused(HEAD "0.5,1\n0.6,1\n", ":2: column 'wavelength_nm': 0.5; accepted: 100 to 100000");
  refused(HEAD "500,0\n600,80\n",
          ":3: column 'transmission': 80; accepted: 0 to 1, not in percent");
  refused(HEAD "500,0\n600,-0.1\n",
          ":3: column 'transmission': -0.1; accepted: 0 to 1, not in percent");
  refused(
      HEAD "500,0\n600,0\n",
      ": column 'transmission': 0 in every row, or less; accepted: a filter through which light "
      "passes, 1e-12 or more in one row");
  refused(HEAD "500,1e-300\n600,0\n",
          ": column 'transmission': 1e-300 in every row, or less; accepted: a filter through which "
          "light passes, 1e-12 or more in one row");
  char path[UM_TEST_PATH];
  struct um_instrument_filter *f;
  static const char *const broken[] = {HEAD "500,0\n600,\n", HEAD "500,nan\n600,1\n",
                                       HEAD "500,0\ninf,1\n", HEAD "500\n600\n"};
  for (size_t i = 0; i < sizeof broken / sizeof broken[0]; i++) {
    assert_int_equal(read_text(broken[i], path, &f), UM_ERR_INPUT);
    assert_non_null(strstr(um_core_message(context), path));
  }
  assert_int_equal(um_instrument_filter_read(context, "/nowhere.csv", &f), UM_ERR_IO);
}

static void test_own(void **state)
{
  (void)state;
  char **names;
  size_t count;
  struct um_instrument_filter *f;
  assert_int_equal(um_instrument_filter_names(context, &names, &count), UM_OK);
  assert_true(count >= 20);
  for (size_t i = 0; i < count; i++) {
    if (um_instrument_filter_find(context, names[i], &f) != UM_OK)
      fail_msg("%s", um_core_message(context));
    double p = um_instrument_filter_pivot(f);
    assert_true(p > f->wavelength[0] && p < f->wavelength[f->n - 1]);
    um_instrument_filter_destroy(context, &f);
  }
  um_core_listing_free(context, names, count);
  um_core_message_clear(context);
  assert_int_equal(um_instrument_filter_find(context, "jonson_v", &f), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(context), "no filter 'jonson_v'"));
  assert_non_null(strstr(um_core_message(context), "did you mean 'johnson_v'"));
  assert_int_equal(um_instrument_filter_find(context, "../filters/johnson_v", &f), UM_ERR_INPUT);
}

/* Pivot wavelengths that are published: Gaia EDR3 (Riello et al. 2021) 621.79, 510.97, 776.91 nm;
 * SDSS of Doi et al. 2010: g 470.2, r 617.6, i 749.0 nm; WISE W3 (Jarrett et al. 2011) 12.082 um,
 * each to 0.3 %. */
static void test_pivots(void **state)
{
  (void)state;
  static const struct {
    const char *name;
    double um;
  } c[] = {{"gaia_g", 0.62179}, {"gaia_bp", 0.51097}, {"gaia_rp", 0.77691}, {"sdss_g", 0.4702},
           {"sdss_r", 0.6176},  {"sdss_i", 0.7490},   {"wise_w3", 12.082}};
  for (size_t i = 0; i < sizeof c / sizeof c[0]; i++) {
    struct um_instrument_filter *f;
    assert_int_equal(um_instrument_filter_find(context, c[i].name, &f), UM_OK);
    print_message("%s: %.4f um\n", c[i].name, um_instrument_filter_pivot(f) * 1e6);
    assert_close(um_instrument_filter_pivot(f) * 1e6 / c[i].um, 1.0, 3e-3);
    um_instrument_filter_destroy(context, &f);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_read),
      cmocka_unit_test(test_refused),
      cmocka_unit_test(test_own),
      cmocka_unit_test(test_pivots),
  };
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
