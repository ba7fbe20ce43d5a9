/* Reading records: the product's folder, a scenario's own files, overrides, and what is refused. */
#include "check.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "materials/bsdf.h"
#include "materials/lobe.h"
#include "materials/materials.h"
#include "tests/support/allocator.h"
#include "tests/support/temporary.h"

static struct um_context *context;
static struct um_materials_library *library;
static char folder[UM_TEST_PATH];
static char path[UM_TEST_PATH + 8];
static char logged[1024];

static void keep_log(void *self, enum um_core_log_level level, const char *line)
{
  (void)self;
  if (level >= UM_LOG_WARNING) snprintf(logged, sizeof logged, "%s", line);
}

static int group_setup(void **state)
{
  (void)state;
  if (um_test_folder_create(folder) != 0) return 1;
  snprintf(path, sizeof path, "%s/m.yaml", folder);
  return 0;
}

static int group_teardown(void **state)
{
  (void)state;
  unlink(path);
  return um_test_folder_remove(folder);
}

static int setup(void **state)
{
  (void)state;
  logged[0] = '\0';
  if (um_core_context_create(NULL, &context) != UM_OK) return 1;
  um_core_log_set_sink(context, keep_log, NULL);
  return library_under_e490(context, &library) == UM_OK ? 0 : 1;
}

static int teardown(void **state)
{
  (void)state;
  um_materials_library_destroy(&library);
  um_core_context_destroy(&context);
  return 0;
}

static void write_file(const char *text)
{
  FILE *file = fopen(path, "w");
  assert_non_null(file);
  fputs(text, file);
  fclose(file);
}

#define HEAD "name: m\nsummary: s\ncitation: c\n"

static enum um_status read_text(const char *text)
{
  write_file(text);
  um_core_message_clear(context);
  return um_materials_library_read_file(context, library, path, NULL, 0);
}

/* The file is refused with a message that holds its name, every piece, and one line only. */
static void refused(const char *text, const char *line, const char *a, const char *b)
{
  assert_int_equal(read_text(text), UM_ERR_INPUT);
  const char *message = um_core_message(context);
  const char *pieces[] = {"m.yaml", line, a, b};
  for (size_t i = 0; i < 4; i++)
    if (strstr(message, pieces[i]) == NULL) fail_msg("'%s' lacks '%s'", message, pieces[i]);
  assert_null(strchr(message, '\n'));
  assert_int_equal(um_materials_library_count(library), 0);
}

#define SHINY HEAD "grey: {solar_absorptance: 0.3, emittance: 0.8, specular_reflectance: 0.1}\n"

static void what_is_refused(void **state)
{
  (void)state;
  refused(HEAD "grey: {solar_absorptance: 0.3, emittance: 0.8, colour: 1}\n", ":4:", "colour",
          "accepted");
  refused(HEAD "grey: {solar_absorptance: 0.3}\n", ":4:", "emittance", "missing");
  refused("name: m\nsummary: s\ngrey: {solar_absorptance: 0.3, emittance: 0.8}\n",
          ":1:", "citation", "missing");
  refused(HEAD "grey: {solar_absorptance: nan, emittance: 0.8}\n", ":4:", "solar_absorptance",
          "accepted");
  refused(HEAD "grey: {solar_absorptance: 1.3, emittance: 0.8}\n", ":4:", "1.3", "accepted");
  refused(HEAD, ":1:", "grey", "accepted");
  refused(HEAD "grey: {solar_absorptance: 0.3, emittance: 0.8}\n"
               "reflectance: {wavelength_um: [1, 2], diffuse: [0.1, 0.1]}\n",
          ":5:", "exclude", "reflectance");
  refused(HEAD "grey: {solar_absorptance: 0.3, emittance: 0.8, specular_reflectance: 0.1}\n",
          ":4:", "beckmann_alpha", "missing");
  refused(HEAD "grey: {solar_absorptance: 0.3, emittance: 0.8, specular_reflectance: 0.6,\n"
               "  vis_reflectance_diffuse: 0.5, beckmann_alpha: 0.1}\n",
          ":4:", "1.1", "at most 1");
  refused(SHINY "lobe: {kind: ggz, alpha: 0.1}\n", ":5:", "ggz", "ggx");
  refused(SHINY "lobe: {kind: ggx}\n", ":5:", "roughness", "missing");
  refused(SHINY "lobe: {kind: ggx, exponent: 20}\n", ":5:", "exponent", "alpha");
  refused(SHINY "lobe: {kind: mirror, alpha: 0.1}\n", ":5:", "mirror", "no roughness");
  refused(SHINY "lobe: {kind: phong, exponent: 20, masking: separable}\n", ":5:", "masking",
          "beckmann or ggx");
  refused(SHINY "lobe: {kind: phong, alpha: 0.1, alpha_across: 0.2}\n", ":5:", "one roughness",
          "ashikhmin_shirley");
  refused(SHINY "lobe: {kind: ashikhmin_shirley, alpha: 0.1, exponent_across: 20}\n",
          ":5:", "exponent_across", "both");
  refused(SHINY "lobe: {kind: phong, alpha: 0.1, exponent: 20}\n", ":5:", "exponent", "exclude");
  refused(HEAD "grey: {solar_absorptance: 0.3, emittance: 0.8, specular_reflectance: 0.1,\n"
               "  beckmann_alpha: 0.2}\nlobe: {alpha: 0.3}\n",
          ":6:", "twice", "beckmann_alpha");
  refused(HEAD "grey: {solar_absorptance: 0.3, emittance: 0.8, specular_reflectance: 0.1,\n"
               "  beckmann_alpha: 0.2}\nlobe: mirror\n",
          ":6:", "no roughness", "beckmann_alpha");
  refused(HEAD "grey:\n  solar_absorptance: 0.3\n  emittance: 0.8\n  band_emissivity:\n"
               "    - {from_um: 8, to_um: 12, value: 0.9}\n"
               "    - {from_um: 11, to_um: 13, value: 0.9}\n",
          ":9:", "from_um 11", "without overlap");
  refused(HEAD "reflectance: {wavelength_um: [1, 2, 2], diffuse: [0.1, 0.1, 0.1]}\n",
          ":4:", "wavelength_um: 2 follows 2", "ascending");
  refused(HEAD "reflectance: {wavelength_um: [1, 2], diffuse: [0.1]}\n",
          ":4:", "diffuse has 1 values", "accepted: 2");
  refused(HEAD "reflectance: {wavelength_um: [1, 2], diffuse: [0.6, 0.1], specular: [0.5, 0]}\n",
          ":4:", "diffuse + specular is 1.1", "wavelength_um 1");
  refused(HEAD "reflectance: {wavelength_um: [1, 2], diffuse: [0.1, 0.1], specular: [0.5, 0]}\n",
          ":1:", "roughness", "beckmann_alpha");
  refused(HEAD "reflectance: {wavelength_um: [1, 2], diffuse: [0.1, 0.1]}\n"
               "surface: {diffuse_fraction: 0.1}\n",
          ":5:", "diffuse_fraction", "substrate");
  refused(HEAD "substrate: {wavelength_um: [1, 2], n: [1.5, 1.5], k: [0.1]}\n", ":4:", "k has 1",
          "accepted: 2");
  refused(HEAD "substrate: {wavelength_um: [1, 2], n: [1.5, -1.5], k: [0.1, 0.1]}\n", ":4:", "-1.5",
          "accepted");
  refused(HEAD "substrate: {wavelength_um: [1, 2], n: [1.5, 1.5], k: [0.1, 0.1]}\n"
               "surface: {rq_um: 2.0}\n",
          ":5:", "roughness", "tau_um");
  refused(HEAD "substrate: {wavelength_um: [1, 2], n: [1.5, 1.5], k: [0.1, 0.1]}\n"
               "surface: {rq_um: 2.0, tau_um: 1.0}\n",
          ":5:", "2.8", "at most 1.5");
  refused(HEAD "grey: {solar_absorptance: 0.3, emittance: 0.8}\n"
               "sheet: {thickness_um: 1, wavelength_um: [1, 2], n: [1.5, 1.5], k: [0, 0]}\n",
          ":5:", "sheet", "substrate");
  refused("name: a b\nsummary: s\ncitation: c\ngrey: {solar_absorptance: 0.3, emittance: 0.8}\n",
          ":1:", "a b", "letters");
  refused(HEAD "grey: {solar_absorptance: 0.3, emittance: 0.8}\nthermal: {density_kg_m3: 0}\n",
          ":5:", "density_kg_m3", "accepted");
}

/* What absorbs 90 % cannot reflect 90 %, not even in the visible alone, which is half of sunlight;
 * nor can 40 % be lost. What is possible but does not add up is said with both numbers, unless the
 * record says how far off it may be. */
static void absorptance_and_reflectance(void **state)
{
  (void)state;
  refused(HEAD "grey: {solar_absorptance: 0.9, emittance: 0.9, vis_reflectance_diffuse: 0.9}\n",
          ":4: grey: ", "solar_absorptance is 0.9, while", "reflectance is 0.9: more than all");
  refused(HEAD "grey: {solar_absorptance: 0.9, emittance: 0.9, specular_reflectance: 0.9,\n"
               "  beckmann_alpha: 0.1}\n",
          ":4: grey: ", "solar_absorptance is 0.9, while", "reflectance is 0.9: more than all");
  refused(HEAD "grey: {solar_absorptance: 0.1, emittance: 0.9, vis_reflectance_diffuse: 0.5}\n",
          ":4: grey: ", "solar_absorptance is 0.1, while", "reflectance is 0.5: more than all");
  logged[0] = '\0';
  assert_int_equal(read_text(HEAD "grey: {solar_absorptance: 0.3, emittance: 0.9,\n"
                                  "  vis_reflectance_diffuse: 0.75}\n"),
                   UM_OK);
  assert_non_null(strstr(logged, "m.yaml:4: grey: material m absorbs 0.300 of sunlight by "
                                 "solar_absorptance, 0.250 by its reflectances"));
  logged[0] = '\0';
  assert_int_equal(read_text(HEAD "grey: {solar_absorptance: 0.3, emittance: 0.9,\n"
                                  "  vis_reflectance_diffuse: 0.75, balance_tolerance: 0.05}\n"),
                   UM_OK);
  assert_int_equal(read_text(HEAD "grey: {solar_absorptance: 0.3, emittance: 0.9}\n"), UM_OK);
  assert_int_equal(read_text(HEAD "grey: {solar_absorptance: 0.3, emittance: 0.9,\n"
                                  "  vis_reflectance_diffuse: 0.71}\n"),
                   UM_OK);
  assert_string_equal(logged, "");
}

static void missing_file_and_folder(void **state)
{
  (void)state;
  enum um_status status =
      um_materials_library_read_file(context, library, "/nonexistent/m.yaml", NULL, 0);
  assert_int_equal(status, UM_ERR_IO);
  um_core_message_clear(context);
  assert_int_equal(um_materials_library_read_folder(context, library, "/nonexistent"), UM_ERR_IO);
  assert_non_null(strstr(um_core_message(context), "/nonexistent"));
}

/* A lobe by kind: what its keys say is what comes back, exponents as the alpha of the same peak. */
static void lobes(void **state)
{
  static const struct {
    const char *text, *kind;
    double alpha, across;
    bool correlated;
  } rows[] = {{"lobe: {alpha: 0.2}\n", "beckmann", 0.2, 0.2, false},
              {"lobe: {kind: ggx, alpha: 0.2, masking: height_correlated, alpha_across: 0.5}\n",
               "ggx", 0.2, 0.5, true},
              {"lobe: {kind: phong, exponent: 50}\n", "phong", 0.1, 0.1, false},
              {"lobe: {kind: ashikhmin_shirley, exponent: 200, exponent_across: 50}\n",
               "ashikhmin_shirley", 0.1, 0.2, false},
              {"lobe: mirror\n", "mirror", 0.0, 0.0, false}};
  (void)state;
  for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
    char text[1024];
    snprintf(text, sizeof text, SHINY "%s", rows[k].text);
    assert_int_equal(read_text(text), UM_OK);
    const struct um_materials_record *r = um_materials_library_find(library, "m");
    struct um_materials_lobe lobe = um_materials_lobe(r, NULL);
    assert_string_equal(lobe.kind->name, rows[k].kind);
    check_near("alpha", lobe.alpha, rows[k].alpha, 1e-15);
    check_near("across", lobe.alpha_across, rows[k].across, 1e-15);
    assert_true(lobe.correlated == rows[k].correlated);
    struct um_materials_adjustment rougher = um_materials_no_adjustment;
    rougher.roughness_scale = 2.0;
    check_near("rougher", um_materials_lobe(r, &rougher).alpha_across, 2.0 * rows[k].across, 1e-15);
  }
}

/* M(o) = Fbar(o) (1 - E(o)) with E of the lobe as an effect leaves it, tabulated to 1e-3 at
 * roughnesses beside the record's and 2e-4 at its own; the emissivity of a substrate without a
 * diffuse part is 1 - Fbar. Cubic between the tables' roughnesses, 2e-3 in all; alike for a grain,
 * to its mean over azimuths. */
static void masked_at_other_roughness(void **state)
{
  static const char *const texts[] = {
      "{kind: ggx, alpha: 0.3}", "{kind: ashikhmin_shirley, alpha: 0.4}",
      "{alpha: 0.3, alpha_across: 0.6, masking: height_correlated}"};
  static const double scales[] = {1.0, 1.3, 0.5, 1.9};
  (void)state;
  for (size_t k = 0; k < sizeof texts / sizeof texts[0]; k++) {
    char text[512];
    snprintf(text, sizeof text,
             HEAD "substrate: {wavelength_um: [0.3, 10], n: [0.2, 0.2], k: [4, 4]}\nlobe: %s\n",
             texts[k]);
    assert_int_equal(read_text(text), UM_OK);
    const struct um_materials_record *r = um_materials_library_find(library, "m");
    for (size_t s = 0; s < sizeof scales / sizeof scales[0]; s++) {
      struct um_materials_adjustment a = um_materials_no_adjustment;
      a.roughness_scale = scales[s];
      struct um_materials_lobe lobe = um_materials_lobe(r, &a);
      for (double c = 0.1; c <= 1.0; c += 0.3) {
        double f = 1.0 - um_materials_emissivity(r, &a, 1e-6, c);
        double e = 1.0 - um_materials_masked_reflectance(r, &a, 1e-6, c) / f;
        check_near("albedo", e, um_materials_lobe_albedo(&lobe, c), s == 0 ? 5e-4 : 2e-3);
      }
    }
  }
}

/* A film of 1 um of index 1.7 on metal: emissivity is one minus Airy's reflectance, at any
 * wavelength and angle (a smooth lobe). Cubic between angles 1.1e-3, linear between 96 nodes of a
 * fringe 1.6e-3 at 78 deg, where resonances are sharpest: together 3e-3. */
static void coherent_film(void **state)
{
#define FILM(thickness, more)                                                                      \
  HEAD                                                                                             \
      "substrate: {wavelength_um: [0.2, 50], n: [1, 1], k: [6, 6]}\nsheet: {wavelength_um: [0.2, " \
      "50], n: [1.7, 1.7], k: [1.0e-9, 1.0e-9], thickness_um: " thickness ", " more "}\n"          \
      "surface: {beckmann_alpha: 0.0005}\n"
  (void)state;
  refused(FILM("6", "coherent: true"), ":5:", "thickness_um 6", "at most 5");
  assert_int_equal(read_text(FILM("1", "coherent: true")), UM_OK);
  const struct um_materials_record *r = um_materials_library_find(library, "m");
  double least = 1.0, most = 0.0;
  for (double l = 0.4e-6; l < 12e-6; l *= 1.0037)
    for (double c = 0.2; c <= 1.0; c += 0.2) {
      double exact = um_materials_fresnel_film(1.7, 1e-9, 1e-6, 1.0, 6.0, l, c);
      check_near("film", um_materials_emissivity(r, NULL, l, c), 1.0 - exact, 3e-3);
      least = fmin(least, exact);
      most = fmax(most, exact);
    }
  assert_true(most - least > 0.1);
}

/* A mixture is read as its two lobes; what is no mixture is refused with file and line. */
static void mixtures(void **state)
{
#define MIX(of)                                                                                    \
  HEAD "reflectance: {wavelength_um: [0.3, 20], diffuse: [0.05, 0.05], specular: [0.5, 0.5]}\n" of
  (void)state;
  refused(MIX("lobe: mixture\n"), ":5:", "of has 0", "two lobes");
  refused(MIX("lobe: {kind: mixture, of: [{share: 0.5, alpha: 0.1}, {share: 0.4, alpha: 0.2}]}\n"),
          ":5:", "0.9", "accepted: 1");
  refused(
      MIX("lobe: {kind: mixture, of: [{share: 0.5, alpha: 0.1}, {share: 0.5, kind: mirror}]}\n"),
      ":5:", "mirror", "part of a mixture");
  refused(MIX("lobe: {kind: mixture, of: [{share: 0.5, alpha: 0.1}, {share: 0.5, kind: ggx}]}\n"),
          ":5:", "roughness of kind ggx", "alpha");
  refused(MIX("lobe: {kind: mixture, of: [{share: 0.5, kind: lambert}, {share: 0.5, kind: "
              "lambert}]}\n"),
          ":5:", "lambert alone", "one lobe");
  refused(MIX("lobe: {kind: mixture, of: [{share: 0.5, alpha: 0.1, exponent: 9}, {share: 0.5, "
              "alpha: 0.3}]}\n"),
          ":5:", "exponent", "alpha");
  refused(
      MIX("lobe: {kind: mixture, alpha: 0.1, of: [{share: 0.5, alpha: 0.1}, {share: 0.5, alpha: "
          "0.3}]}\n"),
      ":5:", "roughness each", "alone");
  refused(MIX("lobe: {kind: ggx, alpha: 0.1, of: [{share: 0.5, alpha: 0.1}]}\n"), ":5:", "mixture",
          "without it");
  assert_int_equal(read_text(MIX("lobe:\n  kind: mixture\n  of:\n    - {share: 0.7, alpha: 0.05}\n"
                                 "    - {share: 0.3, kind: ggx, alpha: 0.4, masking: "
                                 "height_correlated}\n")),
                   UM_OK);
  const struct um_materials_record *r = um_materials_library_find(library, "m");
  struct um_materials_lobe lobe = um_materials_lobe(r, NULL);
  struct um_materials_pair pair =
      um_materials_pair(um_vec3(0.6, 0.0, 0.8), um_vec3(-0.5, 0.1, 0.86));
  struct um_materials_lobe one = {.kind = um_materials_lobe_kind_find("beckmann"),
                                  .alpha = 0.05,
                                  .alpha_across = 0.05,
                                  .compensated = true},
                           two = {.kind = um_materials_lobe_kind_find("ggx"),
                                  .alpha = 0.4,
                                  .alpha_across = 0.4,
                                  .correlated = true,
                                  .compensated = true};
  check_near("mixture", lobe.kind->evaluate(&lobe, &pair),
             0.7 * one.kind->evaluate(&one, &pair) + 0.3 * two.kind->evaluate(&two, &pair), 1e-12);
  check_near("no mirror", um_materials_mirror(r).solar, 0.0, 0.0);
  check_near("emissivity", um_materials_emissivity(r, NULL, 10e-6, 0.5), 0.45, 1e-12);
  struct um_materials_adjustment rougher = um_materials_no_adjustment;
  rougher.roughness_scale = 2.0;
  lobe = um_materials_lobe(r, &rougher);
  one.alpha = one.alpha_across = 0.1;
  two.alpha = two.alpha_across = 0.8;
  check_near("rougher", lobe.kind->evaluate(&lobe, &pair),
             0.7 * one.kind->evaluate(&one, &pair) + 0.3 * two.kind->evaluate(&two, &pair), 1e-12);
}

/* Values of a grey record come back as given; defaults as documented. */
static void grey_record(void **state)
{
  (void)state;
  assert_int_equal(
      read_text(HEAD
                "grey:\n  solar_absorptance: 0.3\n  emittance: 0.8\n  specular_reflectance: 0.1\n"
                "  beckmann_alpha: 0.2\n"
                "  band_emissivity: [{from_um: 8, to_um: 12, value: 0.6}]\n"
                "thermal: {density_kg_m3: 2000, specific_heat_J_kg_K: 900, thickness_mm: 2}\n"),
      UM_OK);
  const struct um_materials_record *r = um_materials_library_find(library, "m");
  assert_non_null(r);
  assert_true(um_materials_is_grey(r) && um_materials_has_lobe(r));
  check_near("alpha", um_materials_roughness(r, NULL), 0.2, 0.0);
  check_near("diffuse", um_materials_diffuse_reflectance(r, NULL, 0.5e-6), 0.6, 1e-15);
  check_near("specular", um_materials_specular_reflectance(r, NULL, 0.5e-6, 0.3), 0.1, 0.0);
  check_near("no lobe", um_materials_specular_reflectance(r, NULL, 10e-6, 0.3), 0.0, 0.0);
  check_near("band", um_materials_emissivity(r, NULL, 10e-6, 0.3), 0.6, 0.0);
  check_near("outside", um_materials_emissivity(r, NULL, 15e-6, 0.3), 0.8, 0.0);
  check_near("scattered", um_materials_diffuse_reflectance(r, NULL, 10e-6), 0.4, 1e-15);
  check_near("absorptance", um_materials_solar_absorptance(r, NULL), 0.3, 0.0);
  check_near("emittance", um_materials_emittance(r, NULL, 200.0), 0.8, 0.0);
  struct um_materials_bulk bulk = um_materials_bulk(r);
  check_near("areal", bulk.areal_heat_capacity, 2000.0 * 900.0 * 2e-3, 1e-9);
  assert_true(isnan(bulk.conductivity));
  assert_true(isnan(um_materials_catalogue(r).emittance));
}

#define BULK HEAD "grey: {solar_absorptance: 0.3, emittance: 0.8}\n"

/* Ratios over 300 K, linear between rows, constant beyond; without a table 1. */
static void bulk_by_temperature(void **state)
{
  (void)state;
  assert_int_equal(read_text(BULK
                             "thermal: {specific_heat_J_kg_K: 900, by_temperature: {temperature_K: "
                             "[100, 200, 400], specific_heat_J_kg_K: [400, 800, 1000]}}\n"),
                   UM_OK);
  const struct um_materials_record *r = um_materials_library_find(library, "m");
  assert_non_null(r);
  assert_true(um_materials_bulk_varies(r, UM_BULK_SPECIFIC_HEAT));
  assert_false(um_materials_bulk_varies(r, UM_BULK_CONDUCTIVITY));
  static const double at[][2] = {{0, 400}, {100, 400}, {150, 600}, {300, 900}, {500, 1000}};
  for (size_t k = 0; k < 5; k++)
    check_near("ratio", um_materials_bulk_ratio(r, UM_BULK_SPECIFIC_HEAT, at[k][0]),
               at[k][1] / 900.0, 1e-15);
  check_near("conductivity", um_materials_bulk_ratio(r, UM_BULK_CONDUCTIVITY, 100.0), 1.0, 0.0);
}

static void bulk_tables_refused(void **state)
{
  (void)state;
#define TABLES BULK "thermal: {by_temperature: "
  refused(TABLES "{temperature_K: [100], specific_heat_J_kg_K: [1]}}\n", "5", "1 values",
          "accepted: at least 2");
  refused(TABLES "{temperature_K: [100, 100], specific_heat_J_kg_K: [1, 2]}}\n", "5",
          "100 follows 100", "ascending");
  refused(TABLES "{temperature_K: [100, 200], specific_heat_J_kg_K: [1, 2, 3]}}\n", "5",
          "specific_heat_J_kg_K has 3 values", "accepted: 2");
  refused(TABLES "{temperature_K: [100, 200]}}\n", "5", "says nothing of the temperatures",
          "accepted: specific_heat_J_kg_K, conductivity_W_m_K");
}

/* A reflectance table is what it says at its nodes and between them, constant outside. */
static void table_record(void **state)
{
  (void)state;
  assert_int_equal(
      read_text(HEAD "reflectance: {wavelength_um: [0.5, 1, 20], diffuse: [0.2, 0.6, 0.1]}\n"),
      UM_OK);
  const struct um_materials_record *r = um_materials_library_find(library, "m");
  assert_false(um_materials_is_grey(r) || um_materials_has_lobe(r));
  assert_true(um_materials_emissivity_is_diffuse(r, NULL));
  static const double rows[][2] = {{0.1, 0.2},  {0.5, 0.2},   {0.75, 0.4}, {1.0, 0.6},
                                   {2.9, 0.55}, {10.5, 0.35}, {20.0, 0.1}, {500.0, 0.1}};
  for (size_t i = 0; i < 8; i++) {
    double l = rows[i][0] * 1e-6;
    check_near("diffuse", um_materials_diffuse_reflectance(r, NULL, l), rows[i][1], 1e-12);
    check_near("emissivity", um_materials_emissivity(r, NULL, l, 0.2), 1.0 - rows[i][1], 1e-12);
  }
}

static void overrides_and_replacement(void **state)
{
  (void)state;
  const char *text = HEAD "grey: {solar_absorptance: 0.3, emittance: 0.8}\n";
  assert_int_equal(read_text(text), UM_OK);
  static const char *const set[] = {"grey.emittance=0.5"};
  assert_int_equal(um_materials_library_read_file(context, library, path, set, 1), UM_OK);
  assert_int_equal(um_materials_library_count(library), 1);
  const struct um_materials_record *r = um_materials_library_find(library, "m");
  check_near("emittance", um_materials_emittance(r, NULL, 300.0), 0.5, 0.0);
}

/* A record whose integrals leave its catalogue is read, with both numbers in a warning. */
static void catalogue_warning(void **state)
{
  (void)state;
  assert_int_equal(
      read_text(HEAD "grey: {solar_absorptance: 0.3, emittance: 0.8}\n"
                     "catalogue: {solar_absorptance: 0.4, solar_absorptance_tolerance: 0.05,\n"
                     "  emittance: 0.8, emittance_tolerance: 0.05, source: a book}\n"),
      UM_OK);
  assert_non_null(strstr(logged, "solar absorptance 0.300"));
  assert_non_null(strstr(logged, "0.400"));
  assert_non_null(strstr(logged, "a book"));
}

/* Whichever allocation fails, reading says so, nothing leaks, and the library stays usable. */
static void out_of_memory(void **state)
{
  (void)state;
  write_file(HEAD "reflectance: {wavelength_um: [0.5, 1, 20], diffuse: [0.2, 0.6, 0.1],\n"
                  "  specular: [0.1, 0.1, 0.1]}\nsurface: {beckmann_alpha: 0.1}\n"
                  "catalogue: {solar_absorptance: 0.5, solar_absorptance_tolerance: 0.5,\n"
                  "  emittance: 0.5, emittance_tolerance: 0.5, source: a book}\n");
  enum um_status status = UM_ERR_MEMORY;
  long n = 0;
  for (; status == UM_ERR_MEMORY && n < 2000; n++) {
    struct um_test_memory memory = {0};
    const struct um_core_allocator allocator = um_test_memory_allocator(&memory);
    struct um_context *own;
    struct um_materials_library *records;
    assert_int_equal(um_core_context_create(&allocator, &own), UM_OK);
    assert_int_equal(library_under_e490(own, &records), UM_OK);
    memory.calls = 0;
    memory.fail_call = n + 1;
    status = um_materials_library_read_file(own, records, path, NULL, 0);
    assert_int_equal(um_materials_library_count(records), status == UM_OK ? 1 : 0);
    um_materials_library_destroy(&records);
    um_core_context_destroy(&own);
    assert_int_equal(memory.alive, 0);
  }
  assert_int_equal(status, UM_OK);
  print_message("reading makes %ld allocations\n", n - 1);
  assert_true(n > 10);
}

static void product_folder(void **state)
{
  (void)state;
  char *found;
  char inside[UM_TEST_PATH + 16];
  unsetenv("UMBRA_DATA");
  assert_int_equal(um_materials_library_folder(context, &found), UM_OK);
  assert_int_equal(um_materials_library_read_folder(context, library, found), UM_OK);
  um_core_free(context, found);
  static const char *const required[] = {"mli_kapton",
                                         "mli_kapton_ito",
                                         "cell_triple_junction",
                                         "cell_silicon",
                                         "cell_silicon_layers",
                                         "cfrp",
                                         "osr",
                                         "aluminium_bare",
                                         "aluminium_anodised",
                                         "copper",
                                         "fep_silver",
                                         "white_paint",
                                         "black_paint",
                                         "grey_mli",
                                         "grey_panel",
                                         "black"};
  for (size_t i = 0; i < sizeof required / sizeof required[0]; i++)
    if (um_materials_library_find(library, required[i]) == NULL) fail_msg("no %s", required[i]);
  assert_null(um_materials_library_find(library, "mli_capton"));
  char words[512];
  um_materials_library_suggest(library, "mli_capton", words, sizeof words);
  assert_non_null(strstr(words, "mli_kapton"));
  um_materials_library_suggest(library, "zzzzzz", words, sizeof words);
  assert_non_null(strstr(words, "accepted"));

  snprintf(inside, sizeof inside, "%s/materials", folder);
  setenv("UMBRA_DATA", folder, 1);
  assert_int_equal(um_materials_library_folder(context, &found), UM_ERR_IO);
  assert_non_null(strstr(um_core_message(context), inside));
  mkdir(inside, 0700);
  assert_int_equal(um_materials_library_folder(context, &found), UM_OK);
  assert_string_equal(found, inside);
  um_core_free(context, found);
  rmdir(inside);

  /* the context's own goes before the variable */
  setenv("UMBRA_DATA", UMBRA_SOURCE_DIR "/tests/fuzz/data", 1);
  assert_int_equal(um_core_context_set_data(context, folder), UM_OK);
  assert_int_equal(um_materials_library_folder(context, &found), UM_ERR_IO);
  assert_non_null(strstr(um_core_message(context), inside));
  assert_int_equal(um_core_context_set_data(context, ""), UM_OK);
  assert_null(um_core_context_data(context));
  um_core_message_clear(context);
  assert_int_equal(um_materials_library_folder(context, &found), UM_OK);
  assert_string_equal(found, UMBRA_SOURCE_DIR "/tests/fuzz/data/materials");
  um_core_free(context, found);
  unsetenv("UMBRA_DATA");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(what_is_refused, setup, teardown),
      cmocka_unit_test_setup_teardown(absorptance_and_reflectance, setup, teardown),
      cmocka_unit_test_setup_teardown(missing_file_and_folder, setup, teardown),
      cmocka_unit_test_setup_teardown(lobes, setup, teardown),
      cmocka_unit_test_setup_teardown(masked_at_other_roughness, setup, teardown),
      cmocka_unit_test_setup_teardown(coherent_film, setup, teardown),
      cmocka_unit_test_setup_teardown(mixtures, setup, teardown),
      cmocka_unit_test_setup_teardown(grey_record, setup, teardown),
      cmocka_unit_test_setup_teardown(bulk_by_temperature, setup, teardown),
      cmocka_unit_test_setup_teardown(bulk_tables_refused, setup, teardown),
      cmocka_unit_test_setup_teardown(table_record, setup, teardown),
      cmocka_unit_test_setup_teardown(overrides_and_replacement, setup, teardown),
      cmocka_unit_test_setup_teardown(catalogue_warning, setup, teardown),
      cmocka_unit_test_setup_teardown(out_of_memory, setup, teardown),
      cmocka_unit_test_setup_teardown(product_folder, setup, teardown),
  };
  return cmocka_run_group_tests(tests, group_setup, group_teardown);
}
