/* ENVISAT in Mitsuba 3: the light curve of sunlight held against a path tracer that was written by
 * others, on the same facets, at twelve instants of the pass over Graz.
 *
 * Every surface is of one material, so that nothing but geometry and lobe decides: Lambert of
 * reflectance 1/2, and a Beckmann lobe of constant reflectance 0.3 and roughness 0.2. Mitsuba gets
 * the facets as they stand at an instant, the direction of the Sun and an orthographic camera in
 * that of the observer; both sides sum radiance to intensity over irradiance [m^2/sr]. Direct
 * light, for Lambert that of two surfaces together, and all reflections of both materials.
 *
 * tests/bench/render_mitsuba.py runs in an environment of its own below the build folder; without
 * it the benchmark says so and fails. Goal: the root mean square of the twelve differences is at
 * most twice that of both standard errors together. Mitsuba approximates Smith's masking of a
 * Beckmann surface by a rational function (Walter et al. 2007, good to 0.35 %), ours is exact. Our
 * Sun is a disc, theirs a direction: edges of shadows are blurred alike on both sides. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/core/constants.h"
#include "model/build/build.h"
#include "model/build/model.h"
#include "model/geometry/precompute.h"
#include "tests/bench/bench.h"

#define SCENARIO UMBRA_SOURCE_DIR "/scenarios/envisat-graz-2016"
#define INSTANTS 12
#define SAMPLES  256
#define RAYS     256    /* paths between surfaces */
#define MASKING  3.5e-3 /* of Mitsuba's rational function (Walter et al. 2007) [1] */

enum { LAMBERT, BECKMANN, BOUNCE, ALL, LOBES, CASES };
static const char *const case_name[CASES] = {"lambert", "beckmann", "bounce", "all", "lobes"};

#define GREY "  solar_absorptance: 0.5\n  vis_reflectance_diffuse: 0.5\n"
#define LOBE                                                                                       \
  "  solar_absorptance: 0.7\n  vis_reflectance_diffuse: 0\n  specular_reflectance: 0.3\n"          \
  "  beckmann_alpha: 0.2\n"

/* What the two find at an instant [m^2/sr]. */
struct pair {
  double ours, our_error, theirs, their_error;
};

static const struct um_materials_record *record_make(const struct bench *bench, const char *folder,
                                                     struct um_materials_library *library,
                                                     const char *name, const char *body)
{
  char path[BENCH_FOLDER + 32];
  snprintf(path, sizeof path, "%s/material.yaml", folder);
  FILE *f = fopen(path, "w");
  if (f == NULL)
    bench_must(bench, um_core_fail(bench->context, UM_ERR_INPUT, "%s cannot be written", path));
  fprintf(f, "name: %s\nsummary: bench\ncitation: bench\ngrey:\n  emittance: 0.5\n%s", name, body);
  fclose(f);
  bench_must(bench, um_materials_library_read_file(bench->context, library, path, NULL, 0));
  unlink(path);
  return um_materials_library_find(library, name);
}

/* Directions, then the corners of facets, each with 1 where the facet has two sides. */
static void instant_write(const struct bench *bench, const char *folder,
                          const struct um_geometry *geometry,
                          const struct um_environment_sample *sample, int k)
{
  char path[BENCH_FOLDER + 32];
  struct um_geometry_pose *pose = NULL;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(geometry);
  double angle[64];
  struct um_vec3 o = um_quat_apply(sample->q, sample->to_observer);
  struct um_vec3 s = um_quat_apply(sample->q, sample->sun);
  bool joints = um_geometry_joint_count(geometry) > 0;
  um_geometry_joint_angles(geometry, s, 0.0, angle);
  bench_must(bench,
             um_geometry_pose_create(bench->context, geometry, joints ? angle : NULL, &pose));
  snprintf(path, sizeof path, "%s/instant-%d.txt", folder, k);
  FILE *f = fopen(path, "w");
  if (f == NULL)
    bench_must(bench, um_core_fail(bench->context, UM_ERR_INPUT, "%s cannot be written", path));
  fprintf(f, "%.17g %.17g %.17g 0\n%.17g %.17g %.17g 0\n", o.x, o.y, o.z, s.x, s.y, s.z);
  for (size_t i = 0; i < mesh->nfacet; i++)
    for (size_t c = 0; c < 3; c++) {
      struct um_vec3 p = pose->vertex[mesh->corner[i][c]];
      fprintf(f, "%.9g %.9g %.9g %d\n", p.x, p.y, p.z,
              mesh->surface_of_back[i] != UM_GEOMETRY_NONE);
    }
  fclose(f);
  um_geometry_pose_destroy(bench->context, &pose);
}

/* Our intensities, and what Mitsuba is to be given. */
static void ours(const struct bench *bench, const char *folder, struct pair all[CASES][INSTANTS])
{
  static const char *const overrides[] = {"time.start_utc=2016-09-21T20:37:30Z",
                                          "time.stop_utc=2016-09-21T20:43:05Z", "time.step_s=30",
                                          "thermal.facets=''", "thermal.facet_size_m=2"};
  static const char *const body[CASES] = {GREY, LOBE, GREY, GREY, LOBE};
  const struct um_model_options options = {.overrides = overrides, .noverride = 5};
  const struct um_optics_band band = {"vis", 0.38e-6, 0.78e-6, 1, NULL};
  struct um_context *context = bench->context;
  struct um_model *model = NULL;
  struct um_environment_sample sample[INSTANTS];
  struct um_optics_view *view = NULL;
  struct um_materials_library *library = NULL;
  struct um_materials_sun sun;
  bench_must(bench, um_model_create(context, SCENARIO, &options, &model));
  struct um_model_tables *tables = NULL;
  bench_must(bench, um_model_precompute(context, model, &tables));
  if (tables->nobs != INSTANTS)
    bench_must(bench, um_core_fail(context, UM_ERR_INPUT, "%zu instants", tables->nobs));
  memcpy(sample, tables->sample, sizeof sample);
  for (int k = 0; k < INSTANTS; k++) {
    sample[k].sunlit_fraction = 1.0;
    instant_write(bench, folder, model->geometry, &sample[k], k);
  }
  um_environment_sun_shares(&model->environment, &sun);
  bench_must(bench, um_materials_library_create(context, &sun, &library));
  bench_must(bench,
             um_optics_view_trace(context, model->geometry, sample, INSTANTS, SAMPLES, 0, &view));
  size_t n = view->nsurface, nmaterial = um_geometry_material_count(model->geometry);
  double *temperature = bench_allocate(bench, INSTANTS * n, sizeof *temperature);
  float *none = bench_allocate(bench, INSTANTS * n, sizeof *none);
  const struct um_materials_record **record = bench_allocate(bench, nmaterial, sizeof *record);
  for (size_t i = 0; i < INSTANTS * n; i++) temperature[i] = 3.0;
  for (int c = 0; c < CASES; c++) {
    struct um_optics_lightcurve *curve = NULL;
    const struct um_materials_record *one =
        record_make(bench, folder, library, case_name[c], body[c]);
    for (size_t m = 0; m < nmaterial; m++) record[m] = one;
    struct um_environment dark = model->environment;
    dark.earthshine_on = dark.earth_reflection_on = false;
    dark.limb = NULL; /* the Sun as it is above the air */
    const struct um_optics_scene scene = {.geometry = model->geometry,
                                          .environment = &dark,
                                          .samples = sample,
                                          .view = view,
                                          .material = record,
                                          .temperature = temperature,
                                          .albedo = none,
                                          .view_factor = none,
                                          .interreflection_samples = c >= BOUNCE ? RAYS : 0,
                                          .interreflection_most = c == BOUNCE ? 1 : 0};
    bench_must(bench, um_optics_lightcurve_compute(context, &scene, &band, 1, &curve));
    for (int k = 0; k < INSTANTS; k++) {
      double au = UM_AU / sample[k].sun_distance;
      double e = um_environment_solar_band(&dark, band.from, band.to) * au * au;
      const double *of = curve->intensity + (size_t)k * curve->nmaterial * UM_MECHANISM_COUNT;
      for (size_t m = 0; m < curve->nmaterial; m++)
        all[c][k].ours += (of[m * UM_MECHANISM_COUNT + UM_MECHANISM_SUN] +
                           of[m * UM_MECHANISM_COUNT + UM_MECHANISM_INTERREFLECTED]) /
                          e;
      all[c][k].our_error = curve->stderr_[k] / e;
    }
    um_optics_lightcurve_destroy(context, &curve);
  }
  free((void *)record);
  um_core_free(context, temperature);
  um_core_free(context, none);
  um_optics_view_destroy(context, &view);
  um_materials_library_destroy(&library);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
}

static void theirs(const struct bench *bench, const char *folder, struct pair all[CASES][INSTANTS])
{
  char path[BENCH_FOLDER + 32], name[32];
  snprintf(path, sizeof path, "%s/out.txt", folder);
  pid_t child = fork();
  if (child == 0) {
    execl(UMBRA_MITSUBA "/bin/python", UMBRA_MITSUBA "/bin/python",
          UMBRA_SOURCE_DIR "/tests/bench/render_mitsuba.py", folder, path, (char *)NULL);
    _exit(127);
  }
  int end = 0;
  if (child < 0 || waitpid(child, &end, 0) != child || end != 0)
    bench_must(
        bench,
        um_core_fail(bench->context, UM_ERR_INPUT,
                     "Mitsuba did not run (" UMBRA_MITSUBA
                     "/bin/python tests/bench/render_mitsuba.py); tools/bench installs it there"));
  FILE *f = fopen(path, "r");
  int k;
  double value, error;
  while (f != NULL && fscanf(f, "%31s %d %lf %lf", name, &k, &value, &error) == 4)
    for (int c = 0; c < CASES; c++)
      if (strcmp(name, case_name[c]) == 0 && k >= 0 && k < INSTANTS) {
        all[c][k].theirs = value;
        all[c][k].their_error = error;
      }
  if (f != NULL) fclose(f);
  unlink(path);
}

/* Sums over the instants, so that dark ones count as little as they shine. */
static bool report(struct bench *bench, struct pair all[CASES][INSTANTS])
{
  static const char *const title[CASES] = {
      "Lambert", "Beckmann lobe", "Lambert, two surfaces together", "Lambert, all reflections",
      "Beckmann lobe, all reflections"};
  bool agree = true;
  char name[80];
  for (int c = 0; c < CASES; c++) {
    double square = 0.0, error = 0.0, value = 0.0;
    for (int k = 0; k < INSTANTS; k++) {
      const struct pair *p = &all[c][k];
      double masking = c == BECKMANN || c == LOBES ? MASKING * p->theirs : 0.0;
      printf("%-30s instant %2d: %10.6f +- %.6f, Mitsuba %10.6f +- %.6f m2/sr, %+.6f\n", title[c],
             k, p->ours, p->our_error, p->theirs, p->their_error, p->ours - p->theirs);
      square += (p->ours - p->theirs) * (p->ours - p->theirs);
      error += p->our_error * p->our_error + p->their_error * p->their_error + masking * masking;
      value += p->theirs * p->theirs;
    }
    snprintf(name, sizeof name, "%s: rms difference, to both errors", title[c]);
    bench_number(bench, name, "%", 100.0 * sqrt(square / value), 100.0 * sqrt(error / value), 2.0);
    agree = agree && square <= 4.0 * error;
  }
  return agree;
}

int main(int argc, char **argv)
{
  struct bench bench;
  struct pair all[CASES][INSTANTS] = {{{0.0, 0.0, 0.0, 0.0}}};
  char folder[BENCH_FOLDER], path[BENCH_FOLDER + 32];
  bench_begin(&bench, argc, argv, "mitsuba: ENVISAT's sunlight in Mitsuba 3");
  bench_folder(folder);
  ours(&bench, folder, all);
  theirs(&bench, folder, all);
  for (int k = 0; k < INSTANTS; k++) {
    snprintf(path, sizeof path, "%s/instant-%d.txt", folder, k);
    unlink(path);
  }
  rmdir(folder);
  bool agree = report(&bench, all);
  int code = bench_end(&bench);
  if (!agree) fprintf(stderr, "bench: Umbra and Mitsuba differ by more than twice their errors\n");
  return agree ? code : 1;
}
