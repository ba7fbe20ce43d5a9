/* The whole model: each line of the input is one --set on a small scenario (a line "0", "1", "2"
 * chooses which), which is then built, traced, run and written. model_mutate.c makes the lines from
 * the scenario's own schema, so that most get past it. */
#include "model/build/model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/constants.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "model/scenario/scenario_read.h"
#include "model/scenario/tolerances.h"
#include "output/output.h"
#include "tests/fuzz/fuzz.h"

#define LINES_MAX 16
#define WORK_MAX  2000.0 /* surfaces times instants times rays */

#define HEAD                                                                                       \
  "schema: 1\n"                                                                                    \
  "name: small\n"                                                                                  \
  "time: {start_utc: 2016-03-20T04:30:00Z, stop_utc: 2016-03-20T04:30:20Z, step_s: 10}\n"
#define BANDS                                                                                      \
  "bands: {vis: {from_um: 0.4, to_um: 0.7, bins: 3}, lwir: {from_um: 8, to_um: 12, bins: 2}}\n"

static const char *const scenarios[] = {
    /* a bus with an interior and a turned wing */
    HEAD "orbit: {circular: {altitude_km: 765, beta_deg: 0}}\n"
         "attitude: [{lvlh: {}}]\n"
         "observer: {direction: {unit_gcrs: [0.5, 0.8660254, 0], range_km: 1000}}\n"
         "parts:\n"
         "  - {name: bus, box: {size_m: [1, 1, 1]}, outside: grey, lumped: true,\n"
         "     interior: {capacity_J_K: 1000, power_W: 5}, inside_emittance: 0.8,\n"
         "     interiors: {frame: {capacity_J_K: 0, conductance_W_K: 1}, base: {temperature_K: "
         "290}},\n"
         "     groups: {\"+x\": {interior_conductance_W_K: 5, conductances_W_K: {frame: 2}, "
         "inside_emittance: 0.3}},\n"
         "     shell: {areal_heat_capacity_J_m2_K: 1000, through_conductance_W_m2_K: 50}}\n"
         "  - {name: wing, plate: {size_m: [1, 1]}, pose: {position_m: [1.5, 0, 0]},\n"
         "     joint: {axis: [1, 0, 0], angle_deg: 30}, front: coated, back: black,\n"
         "     shell: {areal_heat_capacity_J_m2_K: 1000, conductance_W_K: 0.03, "
         "through_conductance_W_m2_K: 100}}\n"
         "contacts: [{a: bus.interior, b: wing, conductance_W_K: 0.5},\n"
         "  {a: bus.interior, b: bus.inside, area_m2: 0.5, exchange_factor: 0.4},\n"
         "  {a: bus.frame, b: bus.base, conductance_W_K: 0.1}]\n"
         "thermal: {orbits_before: 0, start: isothermal, step_s: 600, samples: 1,\n"
         "          view_factor_rays: 64}\n" BANDS
         "optics: {samples: 2, interreflection_samples: 2}\n",
    /* a cylinder behind MLI that spins, seen from a station, in its periodic state */
    HEAD "orbit:\n"
         "  tle: |\n"
         "    1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"
         "    2 27386  98.2747 295.0853 0001239  84.4040 275.7304 14.37876998760072\n"
         "attitude: [{spin: {axis_gcrs: [0, 0, 1], axis_body: [0, 0, 1], period_s: 600}}]\n"
         "observer: {station: {latitude_deg: 47, longitude_deg: 15}}\n"
         "parts:\n"
         "  - {name: bus, cylinder: {radius_m: 0.5, height_m: 1}, outside: grey, facet_size_m: 2,\n"
         "     mli: {effective_emittance: 0.02, areal_heat_capacity_J_m2_K: 300},\n"
         "     shell: {areal_heat_capacity_J_m2_K: 5000, conductance_W_K: 0.1}}\n"
         "thermal: {orbits_before: 0.2, step_s: 300, samples: 1, relative_tolerance: 1e-4,\n"
         "          absolute_tolerance_K: 1e-2}\n" BANDS "optics: {samples: 2}\n",
    /* a plate at a fixed point */
    HEAD "orbit: {fixed: {position_gcrs_km: [42000, 0, 0]}}\n"
         "attitude: [{fixed: {q_gcrs: [1, 0, 0, 0]}}]\n"
         "observer: {direction: {unit_gcrs: [0, 0, 1], range_km: 36000}}\n"
         "parts:\n"
         "  - {name: wing, plate: {size_m: [2, 1]}, front: coated, back: grey, lumped: true,\n"
         "     electrical_extraction: 0.1, shell: {areal_heat_capacity_J_m2_K: 3000}}\n"
         "thermal: {orbits_before: 0, start: isothermal}\n" BANDS "optics: {samples: 2}\n",
};

static bool is_coarse(double size, double facet_size)
{
  return isnan(facet_size) || facet_size >= 0.2 * size;
}

static double largest_extent(const struct um_scenario_part *part)
{
  const struct um_scenario_round *round[] = {part->disc, part->cylinder, part->cone, part->sphere,
                                             part->paraboloid};
  double largest = 0.0;
  if (part->box != NULL)
    for (int i = 0; i < 3; i++) largest = fmax(largest, part->box->size_m[i]);
  if (part->plate != NULL) largest = fmax(part->plate->size_m[0], part->plate->size_m[1]);
  for (int i = 0; i < 5; i++)
    if (round[i] != NULL) largest = fmax(2.0 * round[i]->radius_m, round[i]->height_m);
  return largest;
}

/* Small enough to build: the mesh. TetGen's child would be most of the time. */
static bool builds_fast(const struct um_scenario *s)
{
  const struct um_scenario_part *part = s->parts.items;
  if (s->effect_files.count > 0 || s->parts.count > 8) return false;
  for (size_t i = 0; i < s->parts.count; i++) {
    double size = largest_extent(&part[i]);
    if (part[i].solid != NULL || !is_coarse(size, part[i].facet_size_m) ||
        !is_coarse(size, s->thermal->facet_size_m))
      return false;
  }
  return true;
}

/* Small enough to run: instants, samples, bins, and the loads, which always reach over a period. */
static bool runs_fast(const struct um_model *model)
{
  const struct um_scenario *s = model->scenario;
  double period = um_orbit_trajectory_period(model->trajectory), nobs, span, rate, step;
  double nsurface = (double)um_geometry_mesh(model->geometry)->nsurface;
  double relative, absolute;
  int bins = 0;
  um_model_tolerances(s->thermal, &relative, &absolute);
  for (size_t b = 0; b < s->bands.count; b++)
    bins += ((const struct um_scenario_band *)s->bands.items)[b].bins;
  nobs = (s->time->stop - s->time->start) / s->time->step_s + 1.0;
  if (s->time->exposure_s > 0.0) nobs *= s->time->exposure_samples;
  if (isnan(period)) period = 0.0;
  span = s->time->stop - s->time->start + s->time->exposure_s +
         (s->thermal->orbits_before + 1.0) * period;
  rate = um_orbit_attitude_rate(model->attitude, period > 0.0 ? 2.0 * UM_PI / period : 0.0);
  step = isnan(s->thermal->step_s) ? fmin(10.0, 0.08 / rate) : s->thermal->step_s;
  return !model->points && bins <= 80 &&
         nobs * nsurface * s->optics->samples * (1.0 + s->optics->interreflection_samples) <
             WORK_MAX &&
         (nobs + span / step) * nsurface * s->thermal->samples < WORK_MAX && relative >= 1e-9;
}

static void look(const struct um_model_result *r)
{
  for (size_t i = 0; i < r->nobs * r->nnode; i++)
    um_fuzz_finite(r->node_temperature[i], "the temperature of a node");
  for (size_t i = 0; i < r->nobs * r->nsurface; i++)
    um_fuzz_finite(r->surface_temperature[i], "the temperature of a surface");
  if (r->nmaterial == 0) return;
  for (size_t k = 0; k < r->nobs; k++)
    for (size_t b = 0; b < r->nband; b++)
      um_fuzz_finite(um_model_result_intensity(r, k, b, -1), "a radiant intensity");
}

static void write_all(struct um_context *context, const struct um_output_run *run)
{
  FILE *file = fopen("/dev/null", "w");
  if (file == NULL) abort();
  if (run->model->has_observer) {
    (void)um_fuzz_good(context, um_output_write_lightcurve(run, file));
    (void)um_fuzz_good(context, um_output_write_materials(run, file));
  }
  (void)um_fuzz_good(context, um_output_write_temperatures(run, file));
  (void)um_fuzz_good(context, um_output_write_heat(run, file));
  (void)um_fuzz_good(context, um_output_write_cic(run, file));
  (void)um_fuzz_good(context, um_output_write_netcdf(context, run, file));
  (void)um_fuzz_good(context, um_output_write_xdmf(run, file));
  (void)fclose(file);
}

static void run_model(struct um_context *context, const struct um_model *model)
{
  struct um_model_tables *tables = NULL;
  struct um_model_result *result = NULL;
  if (um_fuzz_good(context, um_model_precompute(context, model, &tables)) &&
      um_fuzz_good(context, um_model_run(context, model, tables, &result))) {
    look(result);
    write_all(context, &(struct um_output_run){.model = model,
                                               .tables = tables,
                                               .result = result,
                                               .command = "fuzz",
                                               .version = "0",
                                               .context = context});
  }
  um_model_result_destroy(context, &result);
  um_model_tables_destroy(context, &tables);
}

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  const char *set[LINES_MAX];
  size_t n = 0, base = 0;
  char *text = um_fuzz_text(data, size), *rest = text, *line;
  setenv("UMBRA_DATA", UMBRA_SOURCE_DIR "/tests/fuzz/data", 1);
  while ((line = strtok_r(rest, "\n", &rest)) != NULL && n < LINES_MAX)
    if (line[0] >= '0' && line[0] <= '2' && line[1] == '\0')
      base = (size_t)(line[0] - '0');
    else
      set[n++] = line;
  const char *path = um_fuzz_file(0, scenarios[base], strlen(scenarios[base]));
  const struct um_model_options options = {.overrides = set, .noverride = n};
  struct um_document *document = NULL;
  const struct um_scenario *scenario;
  struct um_model *model = NULL;
  if (um_fuzz_good(context, um_model_scenario_read(context, path, NULL, set, n, NULL, 0, &document,
                                                   &scenario)) &&
      builds_fast(scenario) &&
      um_fuzz_good(context, um_model_create(context, path, &options, &model)) && runs_fast(model))
    run_model(context, model);
  um_model_destroy(context, &model);
  um_document_destroy(&document);
  free(text);
}
