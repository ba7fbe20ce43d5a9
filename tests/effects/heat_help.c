/* A small satellite in steady state: see heat_help.h. */
#include "heat_help.h"
#include "model/build/bands.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"

static const char *const scenario =
    "schema: 1\n"
    "name: heat\n"
    "time: {start_utc: 2020-03-20T12:00:00Z, stop_utc: 2020-03-20T12:01:00Z, step_s: 60}\n"
    "orbit: {fixed: {position_gcrs_km: [7000, 0, 0]}}\n"
    "attitude: [{fixed: {q_gcrs: [1, 0, 0, 0]}}]\n"
    "observer: {direction: {unit_gcrs: [0.8, 0.6, 0], range_km: 1000}}\n"
    "environment: {sun: frozen, sun_distance_au: 1}\n"
    "parts:\n"
    "  - {name: panel, plate: {size_m: [2, 1]}, pose: {rotation_deg: [0, 90, 0]},\n"
    "     front: grey_panel, back: grey_white, lumped: true,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000, through_conductance_W_m2_K: 50}}\n"
    "  - {name: bus, box: {size_m: [1, 1, 1]}, pose: {position_m: [-2, 0, 0]},\n"
    "     outside: grey_mli, lumped: true, shell: {areal_heat_capacity_J_m2_K: 5000},\n"
    "     mli: {effective_emittance: 0.02, areal_heat_capacity_J_m2_K: 60},\n"
    "     interior: {capacity_J_K: 20000, power_W: 20, conductance_W_K: 6}}\n"
    "contacts: [{a: panel.back, b: bus.+x, conductance_W_K: 2}]\n"
    "effects:\n"
    "  - {effect: mutual_radiation, off: true}\n"
    "  - {effect: solar_multiple_reflection, off: true}\n"
    "  - {effect: specular_exchange, off: true}\n"
    "  - {effect: shadow_refraction, off: true}\n"
    "  - {effect: earthlight_lobe, off: true}\n"
    "thermal: {relative_tolerance: 1.0e-9, absolute_tolerance_K: 1.0e-7}\n"
    "bands:\n"
    "  vis: {from_um: 0.38, to_um: 0.78, bins: 4}\n"
    "  lwir: {from_um: 8, to_um: 12, bins: 4}\n";

static const char *file_name;

int heat_setup(const char *file)
{
  file_name = file;
  FILE *f = fopen(file, "w");
  if (f == NULL) return -1;
  fputs(scenario, f);
  return fclose(f);
}

int heat_teardown(void) { return remove(file_name); }

static size_t count(const char *const *list)
{
  size_t n = 0;
  while (list[n] != NULL) n++;
  return n;
}

static void need(const struct heat_run *run, enum um_status status)
{
  if (status != UM_OK) fail_msg("%s", um_core_message(run->context));
}

struct heat_run heat_compute(const char *const *overrides, const char *const *with,
                             const char *const *without)
{
  struct heat_run run = {0};
  const struct um_model_options options = {.overrides = overrides,
                                           .noverride = count(overrides),
                                           .with = with,
                                           .nwith = count(with),
                                           .without = without,
                                           .nwithout = count(without)};
  assert_int_equal(um_core_context_create(NULL, &run.context), UM_OK);
  need(&run, um_model_create(run.context, file_name, &options, &run.model));
  need(&run, um_model_precompute(run.context, run.model, &run.tables));
  need(&run, um_model_run(run.context, run.model, run.tables, &run.result));
  return run;
}

void heat_release(struct heat_run *run)
{
  um_model_result_destroy(run->context, &run->result);
  um_model_tables_destroy(run->context, &run->tables);
  um_model_destroy(run->context, &run->model);
  um_core_context_destroy(&run->context);
}

void heat_refused(const char *const *overrides, const char *const *with, char *out, size_t size)
{
  struct heat_run run = {0};
  const struct um_model_options options = {
      .overrides = overrides, .noverride = count(overrides), .with = with, .nwith = count(with)};
  assert_int_equal(um_core_context_create(NULL, &run.context), UM_OK);
  enum um_status status = um_model_create(run.context, file_name, &options, &run.model);
  if (status == UM_OK) status = um_model_precompute(run.context, run.model, &run.tables);
  if (status == UM_OK) status = um_model_run(run.context, run.model, run.tables, &run.result);
  snprintf(out, size, "%s", um_core_message(run.context));
  heat_release(&run);
  assert_int_equal(status, UM_ERR_INPUT);
  assert_null(strchr(out, '\n'));
}

double heat_temperature(const struct heat_run *run, const char *place, size_t k)
{
  for (size_t p = 0; p < run->result->nplace; p++)
    if (strcmp(run->result->place[p].name, place) == 0) return run->result->place[p].mean[k];
  fail_msg("no place is called '%s'", place);
  return NAN;
}

static bool selected(const struct heat_run *run, size_t s, const char *part, bool back)
{
  const struct um_geometry_surface *surface = &um_geometry_mesh(run->model->geometry)->surface[s];
  if (part == NULL) return true;
  return strcmp(um_geometry_part_name(run->model->geometry, surface->part), part) == 0 &&
         (surface->back != 0) == back;
}

struct heat_budget heat_budget(const struct heat_run *run, const char *part, bool back)
{
  const struct um_irradiation_loads *loads = run->tables->seen;
  size_t nsurface = loads->nsurface, row = run->tables->load_row[0] * nsurface;
  double space = run->model->scenario->thermal->space_temperature_K;
  double sun =
      loads->irradiance[run->tables->load_row[0]] * loads->sunlit[run->tables->load_row[0]];
  struct heat_budget b = {0};
  for (size_t s = 0; s < nsurface; s++) {
    if (!selected(run, s, part, back)) continue;
    const struct um_thermal_surface *surface =
        um_thermal_network_surface(run->model->body->network, (uint32_t)s);
    double t = run->result->surface_temperature[s];
    double direct = surface->area * sun * (double)loads->sun[row + s];
    double albedo = surface->area * (double)loads->albedo[row + s];
    double planet = surface->area * (double)loads->planet[row + s];
    b.absorptance = surface->absorptance;
    b.emittance = surface->emittance;
    b.area += surface->area;
    b.emitted += um_thermal_surface_emission(surface) * UM_STEFAN_BOLTZMANN *
                 (pow(t, 4.0) - pow(space, 4.0));
    b.absorbed += (surface->absorptance - surface->extraction) * direct +
                  surface->absorptance * albedo + surface->emittance * planet;
    b.sun += direct;
    b.albedo += albedo;
    b.planet += planet;
  }
  assert_true(b.area > 0.0);
  return b;
}

double heat_intensity(const struct heat_run *run, const char *band, int mechanism,
                      const char *material)
{
  const struct um_model_result *r = run->result;
  size_t k = um_model_band_find(run->model, band);
  double sum = 0.0;
  for (size_t m = 0; m < r->nmaterial; m++)
    if (material == NULL ||
        strcmp(um_geometry_material_name(run->model->geometry, m), material) == 0)
      sum += r->intensity[(k * r->nmaterial + m) * UM_MECHANISM_COUNT + (size_t)mechanism];
  return sum;
}

void heat_close(const char *what, double value, double expected, double relative)
{
  double error = fabs(value - expected);
  if (!(error <= relative * fabs(expected)))
    fail_msg("%s: %.12g, expected %.12g, off by %.2g, accepted %.2g of it", what, value, expected,
             error, relative);
}

static bool same(const double *a, const double *b, size_t n)
{
  return memcmp(a, b, n * sizeof *a) == 0;
}

bool heat_same_temperatures(const struct heat_run *a, const struct heat_run *b)
{
  const struct um_model_result *x = a->result, *y = b->result;
  assert_int_equal(x->nobs, y->nobs);
  assert_int_equal(x->nnode, y->nnode);
  return same(x->node_temperature, y->node_temperature, x->nobs * x->nnode) &&
         same(x->surface_temperature, y->surface_temperature, x->nobs * x->nsurface);
}

static bool same_band(const struct heat_run *a, const struct heat_run *b, const char *band,
                      bool emitted)
{
  const struct um_model_result *x = a->result, *y = b->result;
  size_t k = um_model_band_find(a->model, band), n = x->nmaterial * UM_MECHANISM_COUNT;
  assert_true(k < x->nband);
  for (size_t i = 0; i < x->nobs; i++) {
    size_t at = i * x->nband + k;
    if (!same(&x->irradiance[at], &y->irradiance[at], 1)) return false;
    for (size_t m = 0; m < n; m++)
      if ((emitted || m % UM_MECHANISM_COUNT != UM_MECHANISM_EMITTED) &&
          !same(&x->intensity[at * n + m], &y->intensity[at * n + m], 1))
        return false;
  }
  return true;
}

bool heat_same_band(const struct heat_run *a, const struct heat_run *b, const char *band)
{
  return same_band(a, b, band, true);
}

bool heat_same_reflected(const struct heat_run *a, const struct heat_run *b, const char *band)
{
  return same_band(a, b, band, false);
}
