/* Effects on the surfaces of materials: what they absorb, reflect and emit. */
#include "base/core/planck.h"
#include "heat_help.h"

/* The panel's back is white paint, Lambert with rho_d = 1 - alpha = 0.8, lit by the Earth alone and
 * seen from below: alpha + 0.1 leaves 0.7/0.8 of the light. Other materials keep theirs. */
static void absorptance_darkens_the_visible(void **state)
{
  (void)state;
  const char *const *below = LIST("observer.direction.unit_gcrs=[-0.8, 0.6, 0]");
  struct heat_run a = heat_compute(below, NONE, NONE);
  struct heat_run b = heat_compute(below, LIST("solar_absorptance:grey_white,shift=0.1"), NONE);
  double before = heat_intensity(&a, "vis", UM_MECHANISM_EARTH, "grey_white");
  assert_true(before > 0.0);
  heat_close("earthshine", heat_intensity(&b, "vis", UM_MECHANISM_EARTH, "grey_white"),
             0.875 * before, 1e-12);
  assert_true(heat_intensity(&b, "vis", UM_MECHANISM_EARTH, "grey_mli") ==
              heat_intensity(&a, "vis", UM_MECHANISM_EARTH, "grey_mli"));
  heat_release(&a);
  heat_release(&b);
}

/* The diffuse part of the panel's front, 0.06, falls by the shift; its lobe stays: sunlight is
 * linear in the shift until 0.06 is spent. */
static void absorptance_leaves_the_lobe(void **state)
{
  (void)state;
  struct heat_run run[3] = {
      heat_compute(NONE, NONE, NONE),
      heat_compute(NONE, LIST("solar_absorptance:grey_panel,shift=0.02"), NONE),
      heat_compute(NONE, LIST("solar_absorptance:grey_panel,shift=0.06"), NONE)};
  double sun[3];
  for (size_t i = 0; i < 3; i++)
    sun[i] = heat_intensity(&run[i], "vis", UM_MECHANISM_SUN, "grey_panel");
  heat_close("a third", sun[0] - sun[1], (sun[0] - sun[2]) / 3.0, 1e-9);
  assert_true(sun[2] > 0.0 && sun[0] > sun[2]);
  for (size_t i = 0; i < 3; i++) heat_release(&run[i]);
}

/* More of sunlight and albedo is absorbed, by the shift times what falls in; it is radiated. */
static void absorptance_heats(void **state)
{
  (void)state;
  struct heat_run a = heat_compute(NONE, NONE, NONE);
  struct heat_run b = heat_compute(NONE, LIST("solar_absorptance:grey_panel,shift=0.05"), NONE);
  struct heat_budget front = heat_budget(&a, "panel", false);
  heat_close("absorptance", heat_budget(&b, "panel", false).absorptance, 0.95, 1e-15);
  heat_close("emission", heat_budget(&b, NULL, false).emitted,
             heat_budget(&a, NULL, false).emitted + 0.05 * (front.sun + front.albedo), 1e-6);
  assert_true(heat_temperature(&b, "panel.front", 0) > heat_temperature(&a, "panel.front", 0));
  heat_release(&a);
  heat_release(&b);
}

/* The front faces away from the Earth: what it absorbs stays, and so does what is radiated in all;
 * it is hotter, and its band radiance changes by 0.9 B(T')/B(T). The renderer interpolates B to
 * 1e-6. The visible stays bit for bit. */
static void emittance_scales_emission(void **state)
{
  (void)state;
  struct heat_run a = heat_compute(NONE, NONE, NONE);
  struct heat_run b = heat_compute(NONE, LIST("emittance:grey_panel,factor=0.9"), NONE);
  double cool = heat_temperature(&a, "panel.front", 0),
         hot = heat_temperature(&b, "panel.front", 0);
  heat_close("emittance", heat_budget(&b, "panel", false).emittance, 0.9 * 0.85, 1e-15);
  heat_close("emission", heat_budget(&b, NULL, false).emitted, heat_budget(&a, NULL, false).emitted,
             1e-6);
  assert_true(hot > cool);
  heat_close("band radiance", heat_intensity(&b, "lwir", UM_MECHANISM_EMITTED, "grey_panel"),
             heat_intensity(&a, "lwir", UM_MECHANISM_EMITTED, "grey_panel") * 0.9 *
                 um_core_planck_band(8e-6, 12e-6, hot) / um_core_planck_band(8e-6, 12e-6, cool),
             1e-6);
  assert_true(heat_same_reflected(&a, &b, "vis"));
  heat_release(&a);
  heat_release(&b);
}

/* What the panel's back takes of the Earth below it, over the cap,
 *
 *   2 M int eps(mu) mu dmu,   2 a S cos(sigma) int alpha(mu) mu cos(psi) dmu,   mu from cos(rho) to
 * 1
 *
 * of an optical solar reflector, whose glass takes 4 % less at 60 deg. [W] */
static void of_the_earth(const struct heat_run *run, double tilt, double *albedo, double *planet)
{
  const struct um_environment *e = &run->model->environment;
  const struct um_environment_sample *sample = &run->tables->sample[0];
  const struct um_materials_record *osr = um_materials_library_find(run->model->library, "osr");
  struct um_materials_adjustment tilted = um_materials_no_adjustment;
  double h = um_vec3_norm(sample->r) / e->earth_radius, low = sqrt(1.0 - 1.0 / (h * h));
  double earth = sqrt(sqrt(e->outgoing_longwave / UM_STEFAN_BOLTZMANN)), value[201];
  double lit = um_vec3_dot(sample->sun, sample->r) / um_vec3_norm(sample->r) * e->albedo *
               um_environment_solar_irradiance(e, sample->sun_distance);
  const int n = 4000;
  assert_non_null(osr);
  tilted.emissivity_tilt = tilt;
  um_materials_emittance_by_angle(osr, &tilted, earth, 201, value);
  *albedo = *planet = 0.0;
  for (int i = 0; i < n; i++) {
    double mu = low + (1.0 - low) * (i + 0.5) / n, x = 200.0 * sqrt(mu), sine = sqrt(1.0 - mu * mu);
    int j = (int)fmin(x, 199.0);
    double epsilon = value[j] + (x - j) * (value[j + 1] - value[j]);
    double psi = asin(fmin(h * sine, 1.0)) - asin(sine), share = 2.0 * mu * (1.0 - low) / n;
    *planet += 2.0 * share * e->outgoing_longwave * epsilon; /* 2 m^2 */
    *albedo += 2.0 * share * lit * cos(psi) * um_materials_solar_absorptance_toward(osr, NULL, mu);
  }
}

static const struct um_thermal_heat *heat_of(const struct heat_run *run, const char *place)
{
  for (size_t p = 0; p < run->result->nplace; p++)
    if (strcmp(run->result->place[p].name, place) == 0) return &run->result->heat[p];
  fail_msg("no place is called '%s'", place);
  return NULL;
}

/* The bus stands aside. Without the effect a surface takes the albedo as at normal incidence and
 * the Earth's radiation as from all sides; an absorptance that grows grows at all angles; an
 * emissivity that tilts tilts for what comes from the Earth too. */
static void the_earth_is_absorbed_by_angle(void **state)
{
  (void)state;
  const char *const *set = LIST("parts.panel.back=osr", "parts.bus.pose.position_m=[20, 0, 0]");
  struct heat_run on = heat_compute(set, NONE, NONE);
  struct heat_run off = heat_compute(set, NONE, LIST("absorptance_angle"));
  struct heat_run darker = heat_compute(set, LIST("solar_absorptance:osr,shift=0.1"), NONE);
  struct heat_run tilted = heat_compute(set, LIST("directional_emissivity:osr,tilt=-0.3"), NONE);
  const struct um_materials_record *osr = um_materials_library_find(on.model->library, "osr");
  double albedo, planet, more, unused, falls = heat_budget(&on, "panel", true).albedo;
  of_the_earth(&on, 0.0, &albedo, &planet);
  of_the_earth(&tilted, -0.3, &unused, &more);
  heat_close("albedo", heat_of(&on, "panel.back")->albedo, albedo, 1e-4);
  heat_close("planet", heat_of(&on, "panel.back")->planet, planet, 1e-4);
  heat_close("darker", heat_of(&darker, "panel.back")->albedo, albedo + 0.1 * falls, 1e-4);
  heat_close("tilted", heat_of(&tilted, "panel.back")->planet, more, 1e-4);
  heat_close("off", heat_of(&off, "panel.back")->albedo,
             falls * um_materials_solar_absorptance(osr, NULL), 1e-6);
  assert_true(planet > 1.01 * heat_of(&off, "panel.back")->planet);
  heat_release(&on);
  heat_release(&off);
  heat_release(&darker);
  heat_release(&tilted);
}

static int setup(void **state)
{
  (void)state;
  return heat_setup("effects_heat_surfaces.yaml");
}
static int teardown(void **state)
{
  (void)state;
  return heat_teardown();
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(absorptance_darkens_the_visible),
      cmocka_unit_test(absorptance_leaves_the_lobe),
      cmocka_unit_test(absorptance_heats),
      cmocka_unit_test(emittance_scales_emission),
      cmocka_unit_test(the_earth_is_absorbed_by_angle),
  };
  return cmocka_run_group_tests(tests, setup, teardown);
}
