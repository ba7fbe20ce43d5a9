/* Surfaces that mirror what they do not absorb, against closed forms that tell a mirror from a
 * diffuse surface: Siegel and Howell, Thermal Radiation Heat Transfer, 4th ed., ch. 9. */
#include "thermal/exchange/exchange.h"

#include "tests/support/allocator.h"
#include "tests/support/temporary.h"
#include "tests/thermal/exchange/room_help.h"

#define SUN 1361.0

/* A room of which some parts mirror: one class for each part that does, all of what it reflects. */
struct hall {
  struct room r;
  double share[8]; /* by class, for both bands */
  struct um_thermal_lobes lobes;
  struct um_irradiation_mirrored *mirrored;
};

/* mirror[npart]: share of what a part reflects that goes on as from a mirror; back: so does its
 * back in place of its front. */
static enum um_status table_make(struct um_context *small, const struct um_geometry *geometry,
                                 size_t limit, size_t rays, const double *mirror, bool back,
                                 double *share, struct um_geometry_view_factor_table **out)
{
  struct um_geometry_view_factor_options options;
  struct um_geometry_mirrors *mirrors = NULL;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(geometry);
  um_geometry_view_factor_defaults(&options);
  options.rays = rays;
  UM_TRY(um_geometry_mirrors_create(small, mesh->nsurface, &mirrors));
  for (size_t s = 0; s < mesh->nsurface; s++) {
    uint32_t part = mesh->surface[s].part;
    if (mesh->surface[s].back != back || !(mirror[part] > 0.0)) continue;
    mirrors->of[s] = (uint16_t)part;
    mirrors->nclass = part + 1 > mirrors->nclass ? part + 1 : mirrors->nclass;
    share[part] = mirror[part];
  }
  options.mirrors = mirrors;
  enum um_status status =
      um_geometry_view_factor_table_create(small, geometry, NULL, 1, limit, &options, out);
  um_geometry_mirrors_destroy(small, &mirrors);
  return status;
}

static void hall_open(struct hall *h, const struct um_geometry_part_spec *part, size_t npart,
                      size_t limit, size_t rays, const double *mirror, bool back)
{
  *h = (struct hall){0};
  OK(um_geometry_create(context, part, npart, &h->r.geometry));
  OK(table_make(context, h->r.geometry, limit, rays, mirror, back, h->share, &h->r.table));
  OK(um_thermal_network_create(context, &h->r.network));
  um_thermal_solve_defaults(&h->r.options);
  h->lobes = (struct um_thermal_lobes){h->share, h->share};
}

static void hall_exchange(struct hall *h, bool mirrors)
{
  struct um_thermal_exchange_options options = {.infrared = true,
                                                .lobes = mirrors ? &h->lobes : NULL};
  um_thermal_exchange_destroy(context, &h->r.exchange);
  OK(um_thermal_exchange_create(context, h->r.network, NULL, h->r.table, &options, &h->r.exchange));
  assert_non_null(h->r.exchange);
  h->r.options.exchange = h->r.exchange;
}

static void hall_close(struct hall *h)
{
  um_irradiation_mirrored_destroy(context, &h->mirrored);
  room_close(&h->r);
}

/* Two square plates at distance 1 whose gap is closed by four perfect mirrors are endless plates:
 * 276.92526 W/m2 for emittances 0.8 and 0.3 at 400 and 300 K. Walls that scatter what they
 * reflect, and so send half of it back, leave less. */
static void mirrors_make_plates_endless(void **state)
{
  (void)state;
  static const double mirror[6] = {1, 1, 1, 1, 0, 0}, temperature[6] = {0, 0, 0, 0, 400, 300};
  struct um_geometry_part_spec part[6];
  struct hall h;
  double loss[2][6];
  cube(part, 0.6);
  hall_open(&h, part, 6, 6, 65536, mirror, false);
  for (uint32_t k = 0; k < 6; k++) /* mirrors absorb and emit nothing */
    room_node(&h.r, k, k < 4 ? 0.0 : k == 4 ? 0.8 : 0.3, 0.5, temperature[k], NAN);
  for (int mirrors = 0; mirrors < 2; mirrors++) {
    hall_exchange(&h, mirrors);
    losses(&h.r, temperature, loss[mirrors]);
    print_message("plates between %s: %.3f and %.3f W, endless ones 276.925\n",
                  mirrors ? "mirrors" : "white walls", loss[mirrors][4], loss[mirrors][5]);
    assert_close(loss[mirrors][4] + loss[mirrors][5], 0.0, 1e-4); /* white is 1 - 1e-9 */
  }
  /* 0.1 % of what a mirror reflects is scattered; 16 of them are followed */
  assert_close(loss[1][4], 276.92526, 1e-3 * 276.92526);
  assert_true(loss[0][4] < 0.95 * 276.92526);
  hall_close(&h);
}

/* Walls that mirror, scatter and absorb, in any shares, at one temperature lose nothing. */
static void isothermal_enclosure(void **state)
{
  (void)state;
  static const double mirror[6] = {1, 0.95, 0.5, 0, 0.9, 0},
                      same[6] = {350, 350, 350, 350, 350, 350};
  static const double emittance[6] = {0.8, 0.05, 0.3, 0.3, 0.02, 0.9};
  for (size_t limit = 6; limit <= 100; limit *= 8) {
    struct um_geometry_part_spec part[6];
    struct hall h;
    double loss[6], most = 0.0;
    cube(part, 0.4);
    hall_open(&h, part, 6, limit, 4096, mirror, false);
    for (uint32_t k = 0; k < 6; k++) room_node(&h.r, k, emittance[k], 0.5, 350, NAN);
    hall_exchange(&h, true);
    losses(&h.r, same, loss);
    for (int k = 0; k < 6; k++) assert_close(loss[k], 0.0, 1e-9);
    for (size_t p = 0; p < h.r.table->noutside; p++)
      for (size_t q = 0; q < p; q++) {
        double there = um_thermal_exchange_area(h.r.exchange, 0, p, q);
        most = fmax(most, fabs(there - um_thermal_exchange_area(h.r.exchange, 0, q, p)));
      }
    print_message("%zu patches: total exchange areas differ by %.1e m2 there and back\n",
                  h.r.table->noutside, most);
    assert_true(most < 1e-15);
    hall_close(&h);
  }
}

/* Half a sphere, open, seen from inside by its back: `rings` bands of latitude. */
static void hemisphere_write(const char *path, double side, int rings)
{
  FILE *file = fopen(path, "w");
  assert_non_null(file);
  int around = 4 * rings;
  for (int i = 0; i <= rings; i++)
    for (int k = 0; k < around; k++) {
      double up = 0.5 * UM_PI * i / rings, east = 2.0 * UM_PI * k / around;
      fprintf(file, "v %.17g %.17g %.17g\n", cos(up) * cos(east), side * cos(up) * sin(east),
              side * sin(up));
    }
  for (int i = 0; i < rings; i++)
    for (int k = 0; k < around; k++) {
      int a = i * around + k + 1, b = i * around + (k + 1) % around + 1;
      fprintf(file, "f %d %d %d\n", a, b, b + around);
      if (i + 1 < rings) fprintf(file, "f %d %d %d\n", a, b + around, a + around);
    }
  fclose(file);
}

/* A ball inside a sphere that mirrors: what the sphere sends back meets the ball again, so that its
 * size does not matter, q = s A1 (T1^4 - T2^4) / (1/e1 + 1/e2 - 1) (Siegel and Howell 9-3), while a
 * sphere that scatters gives A1/A2 (1/e2 - 1). Facets turn rays by up to their own half angle, and
 * past the ball: an error of first order in their size, so that two sizes tell what none would. */
static void ball_in_a_mirror(void **state)
{
  (void)state;
  static const struct um_geometry_skin inner = {NULL, "in", NULL}, outer = {NULL, "out", "in"};
  const double mirror[3] = {0, 1, 1}, temperature[3] = {400, 300, 300};
  char folder[UM_TEST_PATH], path[2][UM_TEST_PATH + 16];
  assert_int_equal(um_test_folder_create(folder), 0);
  for (int k = 0; k < 2; k++) snprintf(path[k], sizeof path[k], "%s/%d.obj", folder, k);
  double error[2], limit = 0.0;
  for (int fine = 0; fine < 2; fine++) {
    struct um_geometry_part_spec part[3] = {{.name = "ball",
                                             .shape = UM_SHAPE_SPHERE,
                                             .radius = 0.5,
                                             .rotation = {1, 0, 0, 0},
                                             .skins = &inner,
                                             .nskin = 1,
                                             .facet_size = 0.06}};
    for (int k = 0; k < 2; k++) {
      hemisphere_write(path[k], k == 0 ? 1.0 : -1.0, fine ? 24 : 12);
      part[1 + k] = (struct um_geometry_part_spec){.name = k == 0 ? "north" : "south",
                                                   .shape = UM_SHAPE_MESH,
                                                   .mesh_path = path[k],
                                                   .rotation = {1, 0, 0, 0},
                                                   .skins = &outer,
                                                   .nskin = 1};
    }
    struct hall h;
    double loss[2][3], area[3] = {0, 0, 0};
    hall_open(&h, part, 3, 3, 65536, mirror, true);
    const struct um_geometry_mesh *mesh = um_geometry_mesh(h.r.geometry);
    room_node(&h.r, 0, 0.8, 0.5, 400, NAN);
    for (uint32_t k = 1; k < 3; k++) {
      uint32_t node;
      OK(um_thermal_network_node_add(h.r.network, part[k].name, UM_NODE_BOUNDARY, 0, 300, 0,
                                     &node));
      for (uint32_t s = 0; s < mesh->nsurface; s++) {
        if (mesh->surface[s].part != k || !mesh->surface[s].back) continue;
        struct um_thermal_surface at = {.node = {node, UM_THERMAL_SPACE, UM_THERMAL_SPACE},
                                        .weight = {1, 0, 0},
                                        .area = mesh->area[mesh->surface[s].facet],
                                        .emittance = 0.3};
        OK(um_thermal_network_surface_attach(h.r.network, s, &at));
      }
    }
    for (size_t f = 0; f < mesh->nfacet; f++) area[mesh->facet_part[f]] += mesh->area[f];
    for (int mirrors = 0; mirrors < 2; mirrors++) {
      hall_exchange(&h, mirrors);
      losses(&h.r, temperature, loss[mirrors]);
    }
    double black = UM_STEFAN_BOLTZMANN * area[0] * (pow(400, 4) - pow(300, 4));
    double specular = black / (1 / 0.8 + 1 / 0.3 - 1);
    double diffuse = black / (1 / 0.8 + area[0] / (area[1] + area[2]) * (1 / 0.3 - 1));
    error[fine] = loss[1][0] / specular - 1.0;
    print_message("ball in a sphere, %zu facets: %.3f W (specular %.3f), %.3f W (diffuse %.3f)\n",
                  mesh->nfacet, loss[1][0], specular, loss[0][0], diffuse);
    assert_close(loss[0][0], diffuse, 2e-3 * diffuse);
    assert_true(diffuse > 1.5 * specular);
    hall_close(&h);
  }
  for (int k = 0; k < 2; k++) remove(path[k]);
  assert_int_equal(um_test_folder_remove(folder), 0);
  limit = 2.0 * error[1] - error[0];
  print_message("errors of the mirror: %.4f, %.4f, of facets without size %.4f\n", error[0],
                error[1], limit);
  assert_close(error[0] / error[1], 2.0, 0.1);
  assert_close(limit, 0.0, 0.005);
}

/* --- loads by way of mirrors ---------------------------------------------------------------- */

struct lit {
  struct hall h;
  struct um_irradiation_loads *loads;
  struct um_environment environment;
  struct um_environment_sample sample;
};

/* Sunlight from a direction of the body, or the Earth below, on what is there. */
static void lit_open(struct lit *l, const struct um_geometry_part_spec *part, size_t npart,
                     size_t limit, size_t rays, const double *mirror, struct um_vec3 sun,
                     double radius)
{
  *l = (struct lit){0};
  hall_open(&l->h, part, npart, limit, rays, mirror, false);
  um_environment_defaults(&l->environment);
  l->environment.solar_irradiance = SUN;
  if (!(radius > 0.0))
    l->environment.albedo = l->environment.outgoing_longwave =
        l->environment.brightness_temperature = 0.0;
  l->sample = (struct um_environment_sample){.r = {0, 0, radius > 0.0 ? radius : 7e6},
                                             .v = {7e3, 0, 0},
                                             .sun = um_vec3_unit(sun),
                                             .sun_distance = UM_AU,
                                             .pole = {0, 0, 1},
                                             .greenwich = {1, 0, 0},
                                             .sunlit_fraction = 1.0,
                                             .q = {1, 0, 0, 0}};
  OK(um_irradiation_loads_trace(context, l->h.r.geometry, &l->environment, &l->sample, 1, NULL, 0,
                                256, &l->loads));
  struct um_irradiation_mirrored_options options = {.points = 4096};
  OK(um_irradiation_mirrored_trace(context, l->h.r.geometry, &l->environment, &l->sample, l->loads,
                                   l->h.r.table->patches, l->h.r.table->mirrors, &options,
                                   &l->h.mirrored));
}

/* Heat of the nodes with both bands on. */
static void lit_heat(struct lit *l, struct um_thermal_heat *heat)
{
  struct um_thermal_exchange_options options = {
      .infrared = true, .solar = true, .lobes = &l->h.lobes, .mirrored = l->h.mirrored};
  double temperature[16];
  size_t n = um_thermal_network_nodes(l->h.r.network);
  for (size_t i = 0; i < n; i++) temperature[i] = UM_SPACE_TEMPERATURE;
  um_thermal_exchange_destroy(context, &l->h.r.exchange);
  OK(um_thermal_exchange_create(context, l->h.r.network, l->loads, l->h.r.table, &options,
                                &l->h.r.exchange));
  l->h.r.options.exchange = l->h.r.exchange;
  OK(um_thermal_heat_of_nodes(context, l->h.r.network, l->loads, &l->h.r.options, 0.0, temperature,
                              heat));
}

static void lit_close(struct lit *l)
{
  um_irradiation_loads_destroy(context, &l->loads);
  hall_close(&l->h);
}

/* Light along the middle of a groove of 90 deg meets both of its mirrors and goes back where it
 * came from: 1 - (1 - a)^2 of it is absorbed, half by each. Exact, ray by ray. */
static void groove_of_mirrors(void **state)
{
  (void)state;
  static const double mirror[2] = {1, 1}, absorptance[3] = {0.1, 0.3, 0.8};
  struct um_geometry_part_spec part[2] = {
      plate("floor", 1, 2, 0.6, um_vec3(-0.5, 0, 0), (struct um_quat){1, 0, 0, 0}),
      plate("wall", 1, 2, 0.6, um_vec3(0, 0, 0.5),
            um_quat_from_axis(um_vec3(0, 1, 0), -0.5 * UM_PI))};
  for (int k = 0; k < 3; k++) {
    struct lit l;
    struct um_thermal_heat heat[2];
    double a = absorptance[k], aperture = 2.0 * sqrt(2.0);
    lit_open(&l, part, 2, 2, 1024, mirror, um_vec3(-1, 0, 1), 0.0);
    for (uint32_t p = 0; p < 2; p++) room_node(&l.h.r, p, 0.5, a, 300, NAN);
    lit_heat(&l, heat);
    double expected = 0.5 * aperture * SUN * (1.0 - (1.0 - a) * (1.0 - a));
    print_message("groove, absorptance %.1f: %.4f and %.4f W, expected %.4f\n", a, heat[0].solar,
                  heat[1].solar, expected);
    for (int i = 0; i < 2; i++) assert_close(heat[i].solar, expected, 1e-5 * expected);
    lit_close(&l);
  }
}

/* A mirror of 1 m2 at 45 deg under the Sun lights an upright plate: a spot as wide as the mirror
 * and cos 45 of it high, as bright as the Sun times what the mirror reflects.
 *
 *            Sun
 *       |     |
 *    spot <-- /  mirror       the spot is 1 m wide, 0.707 m high, 3 m away
 *       |
 */
static void heliostat(void **state)
{
  (void)state;
  static const double mirror[2] = {1, 0};
  struct um_geometry_part_spec part[2] = {plate("mirror", 1, 1, 0.8, um_vec3(0, 0, 0),
                                                um_quat_from_axis(um_vec3(0, 1, 0), -0.25 * UM_PI)),
                                          plate("wall", 3, 3, 0.2, um_vec3(-3, 0, 0),
                                                um_quat_from_axis(um_vec3(0, 1, 0), 0.5 * UM_PI))};
  struct lit l;
  lit_open(&l, part, 2, 4000, 16, mirror, um_vec3(0, 0, 1), 0.0);
  const struct um_geometry_mesh *mesh = um_geometry_mesh(l.h.r.geometry);
  const struct um_geometry_patches *patches = l.h.r.table->patches;
  struct um_geometry_pose *pose = NULL;
  OK(um_geometry_pose_create(context, l.h.r.geometry, NULL, &pose));
  double sum = 0.0, half = 0.5 * sqrt(0.5), whole = 0.0;
  double *power = calloc(patches->npatch, sizeof *power);
  assert_non_null(power);
  for (size_t k = 0; k < l.h.mirrored->begin[1]; k++) {
    const struct um_irradiation_mirrored_sun *e = &l.h.mirrored->sun[k];
    assert_int_equal(l.h.mirrored->sets.set[e->sets].n, 0);
    assert_int_equal(mesh->surface[patches->surface[patches->begin[e->to]]].part, 1);
    power[e->to] += (double)e->share * patches->area[e->from] * sqrt(0.5);
  }
  for (size_t p = 0; p < patches->npatch; p++) {
    double high[2] = {0, 0}, low[2] = {INFINITY, INFINITY};
    uint32_t s = patches->surface[patches->begin[p]];
    assert_true(patches->begin[p + 1] == patches->begin[p] + 1); /* a facet each */
    sum += power[p];
    for (int c = 0; c < 3; c++) {
      struct um_vec3 v = pose->vertex[mesh->corner[mesh->surface[s].facet][c]];
      high[0] = fmax(high[0], fabs(v.y));
      high[1] = fmax(high[1], fabs(v.z));
      low[0] = fmin(low[0], fabs(v.y));
      low[1] = fmin(low[1], fabs(v.z));
    }
    if (power[p] > 0.0) assert_true(low[0] < 0.5 && low[1] < half); /* none outside of the spot */
    if (mesh->surface[s].part != 1 || mesh->surface[s].back || high[0] > 0.5 || high[1] > half)
      continue;
    whole += patches->area[p];
    /* about 100 points on each facet, evenly spread */
    assert_close(power[p], patches->area[p], 0.1 * patches->area[p]);
  }
  print_message("heliostat: %.5f m2 of the Sun sent on, expected %.5f; %.3f m2 of whole facets in "
                "the spot, each as bright as the Sun\n",
                sum, sqrt(0.5), whole);
  assert_close(sum, sqrt(0.5), 1e-6);
  assert_true(whole > 0.3);
  free(power);
  um_geometry_pose_destroy(context, &pose);
  lit_close(&l);
}

/* Power of the same spot as heat: the mirror absorbs a_m of E cos 45, the wall a_w of what is left,
 * and what the wall scatters comes back to a mirror that absorbs a_m of it: less than 1 %. */
static void heliostat_heat(void **state)
{
  (void)state;
  static const double mirror[2] = {1, 0};
  struct um_thermal_heat heat[2];
  struct lit l;
  struct um_geometry_part_spec part[2] = {plate("mirror", 1, 1, 0.8, um_vec3(0, 0, 0),
                                                um_quat_from_axis(um_vec3(0, 1, 0), -0.25 * UM_PI)),
                                          plate("wall", 3, 3, 0.8, um_vec3(-3, 0, 0),
                                                um_quat_from_axis(um_vec3(0, 1, 0), 0.5 * UM_PI))};
  lit_open(&l, part, 2, 40, 16384, mirror, um_vec3(0, 0, 1), 0.0);
  room_node(&l.h.r, 0, 0.5, 0.2, 300, NAN);
  room_node(&l.h.r, 1, 0.5, 1.0, 300, NAN); /* black: nothing comes back */
  lit_heat(&l, heat);
  double power = SUN * sqrt(0.5);
  print_message("heliostat: mirror %.3f W of %.3f, wall %.3f W of %.3f\n", heat[0].solar,
                0.2 * power, heat[1].solar, 0.8 * power);
  assert_close(heat[0].solar, 0.2 * power, 1e-5 * power);
  assert_close(heat[1].solar, 0.8 * power, 1e-5 * power);
  lit_close(&l);
}

/* A plate that faces away from the Earth sees it in a mirror above: what its rays meet there is the
 * ground, wherever they pass the plate. Of an Earth that fills the lower half of the sky it takes
 * rho M (F_pm - F_pp'), F_pp' = 0.068590 its own image at distance 2. */
static void earth_in_a_mirror(void **state)
{
  (void)state;
  static const double mirror[2] = {0, 1};
  struct um_geometry_part_spec part[2] = {
      plate("plate", 1, 1, 1.5, um_vec3(0, 0, 0), (struct um_quat){1, 0, 0, 0}),
      plate("mirror", 12, 12, 3, um_vec3(0, 0, 1), um_quat_from_axis(um_vec3(1, 0, 0), UM_PI))};
  struct lit l;
  struct um_thermal_heat heat[2];
  lit_open(&l, part, 2, 2, 65536, mirror, um_vec3(0, 0, 1), 1.0000001 * UM_EARTH_RADIUS);
  room_node(&l.h.r, 0, 1.0, 1.0, 300, NAN);
  room_node(&l.h.r, 1, 0.4, 0.4, 300, NAN);
  lit_heat(&l, heat);
  double f =
      um_geometry_view_factors_area(l.h.r.table->pose[0], 0, 1) / l.h.r.table->patches->area[0];
  double expected = 0.6 * l.environment.outgoing_longwave * (f - 0.068590);
  print_message("the Earth in a mirror: %.4f W/m2 on a plate that faces away, expected %.4f\n",
                heat[0].planet, expected);
  assert_close(heat[0].planet, expected, 0.01 * expected);
  assert_true(l.loads->planet[0] < 1e-3);
  lit_close(&l);
}

static void out_of_memory(void **state)
{
  (void)state;
  static const double mirror[2] = {1, 1};
  struct um_geometry_part_spec part[2] = {
      plate("floor", 1, 2, 0.8, um_vec3(-0.5, 0, 0), (struct um_quat){1, 0, 0, 0}),
      plate("wall", 1, 2, 0.8, um_vec3(0, 0, 0.5),
            um_quat_from_axis(um_vec3(0, 1, 0), -0.5 * UM_PI))};
  struct lit l;
  struct um_test_memory memory = {0};
  struct um_core_allocator allocator = um_test_memory_allocator(&memory);
  struct um_context *small = NULL;
  struct um_thermal_exchange *x = NULL;
  struct um_irradiation_mirrored *mirrored = NULL;
  lit_open(&l, part, 2, 8, 256, mirror, um_vec3(-1, 0, 1), 0.0);
  for (uint32_t p = 0; p < 2; p++) room_node(&l.h.r, p, 0.5, 0.3, 300, NAN);
  assert_int_equal(um_core_context_create(&allocator, &small), UM_OK);
  um_core_context_set_threads(small, 1);
  long live = memory.alive;
  const struct um_thermal_exchange_options options = {
      .infrared = true, .solar = true, .lobes = &l.h.lobes, .mirrored = l.h.mirrored};
  const struct um_irradiation_mirrored_options how = {.points = 4};
  for (int what = 0; what < 2; what++) {
    long tries = 0;
    for (enum um_status status = UM_ERR_MEMORY; status != UM_OK;) {
      memory.calls = 0;
      memory.fail_call = ++tries;
      um_core_message_clear(small);
      status = what == 0 ? um_thermal_exchange_create(small, l.h.r.network, l.loads, l.h.r.table,
                                                      &options, &x)
                         : um_irradiation_mirrored_trace(small, l.h.r.geometry, &l.environment,
                                                         &l.sample, l.loads, l.h.r.table->patches,
                                                         l.h.r.table->mirrors, &how, &mirrored);
      if (status == UM_OK) break;
      assert_int_equal(status, UM_ERR_MEMORY);
      assert_true(x == NULL && mirrored == NULL);
      assert_int_equal(memory.alive, live);
    }
    assert_true(tries > 20);
    um_thermal_exchange_destroy(small, &x);
    um_irradiation_mirrored_destroy(small, &mirrored);
    assert_int_equal(memory.alive, live);
  }
  um_core_context_destroy(&small);
  lit_close(&l);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(mirrors_make_plates_endless),
      cmocka_unit_test(isothermal_enclosure),
      cmocka_unit_test(ball_in_a_mirror),
      cmocka_unit_test(groove_of_mirrors),
      cmocka_unit_test(heliostat),
      cmocka_unit_test(heliostat_heat),
      cmocka_unit_test(earth_in_a_mirror),
      cmocka_unit_test(out_of_memory),
  };
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
