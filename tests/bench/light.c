/* Light: the three ideas that make studies cheap, on ENVISAT's pass (scenarios/envisat-graz-2016,
 * one observation in four seconds, facets of 2 m).
 *
 *   spectra factor out     the light curve in 2000 bins against the same in one bin, alone and with
 *                          the tracing of the view that both need; with inter-reflection too,
 *                          whose paths do carry spectra
 *   geometry once          heat and light after the geometry tables against both
 *   threads                view and light curve on two threads against one; the same bytes
 *
 *   stated error           of the light curve, against the scatter of DRAWS draws of the points
 *
 * Goals. Stated and true error within 10 % of each other. 2000 bins: with the view 1.3 times one
 * bin and 3 times with inter-reflection, alone 20 times, a hundredth of 2000 runs. Rerun a fifth of
 * geometry tables and run, so that a study of a thousand points is a study of heat
 * balances; light alone a fiftieth. Two threads 0.6 of one, 0.5 being the best there is. Error:
 * bands of 80 bins, as the scenario has them, within 0.1 % of 1000. Time of this thread where there
 * is one; the wall clock of two says little on a busy machine. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "model/build/build.h"
#include "model/build/model.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "tests/bench/bench.h"

#define SCENARIO UMBRA_SOURCE_DIR "/scenarios/envisat-graz-2016"
#define RUNS     5
#define BINS     2000
#define SAMPLES  16 /* points per facet, rays of inter-reflection */
#define DRAWS    12 /* of points per facet */
#define TRUTH    2048

/* Everything computed once, the time it took, and the scene for the optics. */
struct pass {
  double trace_time, run_time; /* [s] */
  struct um_model *model;
  struct um_model_tables *tables;
  struct um_model_result *result;
  float *albedo, *view_factor; /* [nobs][nsurface] */
  struct um_optics_scene scene;
};

/* Wall clock where several threads work, else the time of this one [s]. */
static double now(const struct bench *bench)
{
  return um_core_context_threads(bench->context) > 1 ? bench_wall() : bench_cpu();
}

static void pass_create(const struct bench *bench, struct pass *pass)
{
  static const char *const overrides[] = {"time.step_s=4", "thermal.facets=''",
                                          "thermal.facet_size_m=2"};
  const struct um_model_options options = {.overrides = overrides, .noverride = 3};
  struct um_context *context = bench->context;
  bench_must(bench, um_model_create(context, SCENARIO, &options, &pass->model));
  double a = now(bench);
  bench_must(bench, um_model_precompute(context, pass->model, &pass->tables));
  double b = now(bench);
  bench_must(bench, um_model_run(context, pass->model, pass->tables, &pass->result));
  pass->trace_time = b - a;
  pass->run_time = now(bench) - b;
  const struct um_model_tables *tables = pass->tables;
  size_t n = tables->nobs, nsurface = tables->seen->nsurface;
  pass->albedo = bench_allocate(bench, n * nsurface, sizeof(float));
  pass->view_factor = bench_allocate(bench, n * nsurface, sizeof(float));
  for (size_t k = 0; k < n; k++) {
    size_t row = tables->load_row[k] * nsurface;
    memcpy(pass->albedo + k * nsurface, tables->seen->albedo + row, nsurface * sizeof(float));
    memcpy(pass->view_factor + k * nsurface, tables->seen->view_factor + row,
           nsurface * sizeof(float));
  }
  pass->scene = (struct um_optics_scene){.geometry = pass->model->geometry,
                                         .environment = &pass->model->environment,
                                         .samples = tables->sample,
                                         .view = tables->view,
                                         .material = pass->model->material,
                                         .temperature = pass->result->surface_temperature,
                                         .albedo = pass->albedo,
                                         .view_factor = pass->view_factor};
}

static void pass_destroy(const struct bench *bench, struct pass *pass)
{
  struct um_context *context = bench->context;
  um_core_free(context, pass->albedo);
  um_core_free(context, pass->view_factor);
  um_model_result_destroy(context, &pass->result);
  um_model_tables_destroy(context, &pass->tables);
  um_model_destroy(context, &pass->model);
}

/* The scenario's two bands in `bins` bins together. */
static struct um_optics_lightcurve *curve(const struct bench *bench, const struct pass *pass,
                                          int bins, int interreflection, double *time)
{
  struct um_optics_scene scene = pass->scene;
  scene.interreflection_samples = interreflection;
  const struct um_optics_band two[2] = {{"vis", 0.380e-6, 0.780e-6, bins / 2, NULL},
                                        {"lwir", 8e-6, 12e-6, bins / 2, NULL}};
  const struct um_optics_band one = {"all", 0.380e-6, 12e-6, 1, NULL};
  struct um_optics_lightcurve *out = NULL;
  double began = now(bench);
  bench_must(bench, um_optics_lightcurve_compute(bench->context, &scene, bins == 1 ? &one : two,
                                                 bins == 1 ? 1 : 2, &out));
  *time = now(bench) - began;
  return out;
}

static double curve_time(const struct bench *bench, const struct pass *pass, int bins,
                         int interreflection)
{
  double time;
  struct um_optics_lightcurve *c = curve(bench, pass, bins, interreflection, &time);
  um_optics_lightcurve_destroy(bench->context, &c);
  return time;
}

static double view_time(const struct bench *bench, const struct pass *pass)
{
  struct um_optics_view *view = NULL;
  double began = now(bench);
  bench_must(bench,
             um_optics_view_trace(bench->context, pass->model->geometry, pass->tables->sample,
                                  pass->tables->nobs, SAMPLES, 0, &view));
  double time = now(bench) - began;
  um_optics_view_destroy(bench->context, &view);
  return time;
}

static void spectra_figures(struct bench *bench, const struct pass *pass)
{
  struct bench_series many = {.n = 0}, one = {.n = 0}, many_view = {.n = 0}, one_view = {.n = 0};
  struct bench_series many_bounce = {.n = 0}, one_bounce = {.n = 0};
  for (int i = 0; i < RUNS; i++) {
    double view = view_time(bench, pass);
    double a = curve_time(bench, pass, 1, 0), b = curve_time(bench, pass, BINS, 0);
    bench_add(&one, a);
    bench_add(&many, b);
    bench_add(&one_view, view + a);
    bench_add(&many_view, view + b);
    if (i >= 3) continue;
    bench_add(&one_bounce, curve_time(bench, pass, 1, SAMPLES));
    bench_add(&many_bounce, curve_time(bench, pass, BINS, SAMPLES));
  }
  bench_time(bench, "2000 bins to one, light curve alone", "s", &many, &one, 20.0);
  bench_time(bench, "2000 bins to one, with the view", "s", &many_view, &one_view, 1.3);
  bench_time(bench, "2000 bins to one, with inter-reflection", "s", &many_bounce, &one_bounce, 3.0);
}

/* Largest relative difference of a band's intensity between few and many bins. */
static void error_figure(struct bench *bench, const struct pass *pass)
{
  static const char *const name[2] = {"80 bins to 1000, vis: error",
                                      "80 bins to 1000, lwir: error"};
  double time, worst[2] = {0.0, 0.0};
  struct um_optics_lightcurve *few = curve(bench, pass, 160, 0, &time);
  struct um_optics_lightcurve *many = curve(bench, pass, BINS, 0, &time);
  size_t per_band = few->nmaterial * UM_MECHANISM_COUNT;
  for (size_t k = 0; k < few->ntime * 2; k++) {
    double a = 0.0, b = 0.0;
    for (size_t i = 0; i < per_band; i++) {
      a += few->intensity[k * per_band + i];
      b += many->intensity[k * per_band + i];
    }
    if (b > 0.0) worst[k % 2] = fmax(worst[k % 2], fabs(a / b - 1.0));
  }
  for (size_t band = 0; band < 2; band++)
    bench_number(bench, name[band], "1", worst[band], 1e-3, 1.0);
  um_optics_lightcurve_destroy(bench->context, &few);
  um_optics_lightcurve_destroy(bench->context, &many);
}

/* Intensity of a band at each observation, and its stated error, with other points. */
static void draw(const struct bench *bench, const struct pass *pass, int samples, uint64_t seed,
                 double *value, double *error)
{
  static const struct um_optics_band two[2] = {{"vis", 0.380e-6, 0.780e-6, 4, NULL},
                                               {"lwir", 8e-6, 12e-6, 4, NULL}};
  struct um_optics_scene scene = pass->scene;
  struct um_optics_view *view = NULL;
  struct um_optics_lightcurve *c = NULL;
  size_t n = pass->tables->nobs;
  bench_must(bench, um_optics_view_trace(bench->context, pass->model->geometry, scene.samples, n,
                                         samples, seed, &view));
  scene.view = view;
  bench_must(bench, um_optics_lightcurve_compute(bench->context, &scene, two, 2, &c));
  size_t per_band = c->nmaterial * UM_MECHANISM_COUNT;
  for (size_t k = 0; k < 2 * n; k++) {
    value[k] = 0.0;
    for (size_t i = 0; i < per_band; i++) value[k] += c->intensity[k * per_band + i];
    error[k] = c->stderr_[k];
  }
  um_optics_lightcurve_destroy(bench->context, &c);
  um_optics_view_destroy(bench->context, &view);
}

/* Root mean squares over observations and draws, relative. */
static void draw_figures(struct bench *bench, const struct pass *pass)
{
  static const char *const name[2] = {"true error to the stated one, vis",
                                      "true error to the stated one, lwir"};
  size_t n = 2 * pass->tables->nobs;
  double *truth = bench_allocate(bench, 4 * n, sizeof *truth);
  double *value = truth + n, *error = value + n, is[2] = {0.0, 0.0}, said[2] = {0.0, 0.0};
  draw(bench, pass, TRUTH, 1000, truth, error);
  for (uint64_t s = 0; s < DRAWS; s++) {
    draw(bench, pass, SAMPLES, s, value, error);
    for (size_t k = 0; k < n; k++) {
      if (!(truth[k] > 0.0)) continue;
      double off = value[k] / truth[k] - 1.0, stated = error[k] / truth[k];
      is[k % 2] += off * off * 2.0 / (double)(n * DRAWS);
      said[k % 2] += stated * stated * 2.0 / (double)(n * DRAWS);
    }
  }
  for (size_t b = 0; b < 2; b++) bench_number(bench, name[b], "1", sqrt(is[b]), sqrt(said[b]), 1.1);
  um_core_free(bench->context, truth);
}

static void rerun_figures(struct bench *bench, const struct pass *pass)
{
  struct bench_series again = {.n = 0}, all = {.n = 0}, light = {.n = 0};
  for (int i = 0; i < 2; i++) {
    struct um_model_result *result = NULL;
    double run = pass->run_time;
    if (i > 0) {
      double began = now(bench);
      bench_must(bench, um_model_run(bench->context, pass->model, pass->tables, &result));
      run = now(bench) - began;
      um_model_result_destroy(bench->context, &result);
    }
    bench_add(&again, run);
    bench_add(&all, pass->trace_time + run);
    for (int k = 0; k < 2; k++) bench_add(&light, curve_time(bench, pass, 120, 0));
  }
  bench_time(bench, "heat and light after the geometry, to geometry and run", "s", &again, &all,
             0.2);
  bench_time(bench, "light alone after the geometry, to geometry and run", "s", &light, &all, 0.02);
}

/* Both by wall clock, alternating. */
static void thread_figures(struct bench *bench, const struct pass *pass)
{
  struct bench_series view[2] = {{.n = 0}, {.n = 0}}, light[2] = {{.n = 0}, {.n = 0}};
  struct um_optics_lightcurve *c[2] = {NULL, NULL};
  for (int i = 0; i < RUNS; i++)
    for (int t = 0; t < 2; t++) {
      double time;
      um_core_context_set_threads(bench->context, t + 1);
      double a = bench_wall();
      view_time(bench, pass);
      double b = bench_wall();
      um_optics_lightcurve_destroy(bench->context, &c[t]);
      c[t] = curve(bench, pass, BINS, 0, &time);
      bench_add(&view[t], b - a);
      bench_add(&light[t], bench_wall() - b);
    }
  um_core_context_set_threads(bench->context, 1);
  size_t n = c[0]->ntime * c[0]->nbin * UM_MECHANISM_COUNT, other = 0;
  for (size_t i = 0; i < n; i++)
    other += memcmp(&c[0]->spectral[i], &c[1]->spectral[i], sizeof(double)) != 0;
  bench_time(bench, "view on two threads to one", "s", &view[1], &view[0], 0.6);
  bench_time(bench, "light curve in 2000 bins on two threads to one", "s", &light[1], &light[0],
             0.6);
  bench_number(bench, "values that two threads change", "1", (double)other, 1.0, 0.0);
  for (int t = 0; t < 2; t++) um_optics_lightcurve_destroy(bench->context, &c[t]);
}

int main(int argc, char **argv)
{
  struct bench bench;
  struct pass pass = {0};
  bench_begin(&bench, argc, argv, "light: ENVISAT's pass, one thread where none are named");
  pass_create(&bench, &pass);
  bench_number(&bench, "observations", "1", (double)pass.tables->nobs, NAN, NAN);
  bench_number(&bench, "surfaces", "1", (double)pass.tables->seen->nsurface, NAN, NAN);
  bench_number(&bench, "rows of the heat loads", "1", (double)pass.tables->seen->ntime, NAN, NAN);
  spectra_figures(&bench, &pass);
  error_figure(&bench, &pass);
  draw_figures(&bench, &pass);
  rerun_figures(&bench, &pass);
  thread_figures(&bench, &pass);
  pass_destroy(&bench, &pass);
  return bench_end(&bench);
}
