/* What surfaces that have aged reflect of the Sun, of the albedo and of the Earth's heat, in a cube
 * with a lid and without, against its balance. */
#include "tests/thermal/exchange/room_help.h"
#include "thermal/network/network_group.h"

/* Ageing of the six walls over rows [2]. */
static struct um_thermal_aging aging_of(size_t nsurface, const struct um_geometry_mesh *mesh,
                                        uint32_t *material, const double *absorptance,
                                        const double *emittance)
{
  for (size_t s = 0; s < nsurface; s++) material[s] = mesh->surface[s].part;
  return (struct um_thermal_aging){.ntime = 2,
                                   .nmaterial = 6,
                                   .material = material,
                                   .absorptance = absorptance,
                                   .emittance = emittance};
}

/* What falls on the floor of the walls of a room: of the Sun, the albedo, the Earth [W/m^2]. */
static const double falls[3] = {1000.0, 300.0, 200.0};
#define FLOOR 4

static struct um_irradiation_loads *floor_lit(const struct um_geometry_mesh *mesh)
{
  struct um_irradiation_loads *loads = NULL;
  OK(um_irradiation_loads_create(context, 2, mesh->nsurface, 0, &loads));
  loads->t[1] = 100.0;
  for (size_t row = 0; row < 2; row++) {
    loads->sunlit[row] = 1.0;
    loads->irradiance[row] = falls[0];
    for (uint32_t s = 0; s < mesh->nsurface; s++) {
      size_t at = row * mesh->nsurface + s;
      if (mesh->surface[s].part != FLOOR || mesh->surface[s].back) continue;
      loads->sun[at] = loads->incidence[at] = 1.0f;
      loads->albedo[at] = (float)falls[1];
      loads->planet[at] = (float)falls[2];
    }
  }
  return loads;
}

/* Absorbed by wall k of a load (0 to 2, as above), of what falls in first and of what is
 * reflected. */
struct taken {
  double first, later;
};

/* heat[k] of walls of 1 m2 each: in the room and out of its open side, all of what falls in. */
static void check_balance(const struct room *r, size_t nwall, int load, const double *heat,
                          const struct taken *taken)
{
  double in = 0.0, out = 0.0;
  for (size_t k = 0; k < nwall; k++) {
    double direct = k == FLOOR ? falls[load] : 0.0;
    double reflected = (heat[k] - taken[k].first * direct) / taken[k].later;
    in += heat[k];
    out += ((1.0 - taken[k].first) * direct + (1.0 - taken[k].later) * reflected) *
           r->table->pose[0]->space[k];
    assert_true(reflected > 0.01 * falls[load]);
  }
  print_message("%zu walls, load %d: %.6f W absorbed, %.6f W leave\n", nwall, load, in, out);
  assert_close(in + out, falls[load], 1e-6);
}

/* Of walls of absorptance 0.3 and emittance 0.6 that have aged by these; laws NULL: none. */
static void taken_by(const struct um_thermal_surface_law *laws, const double *absorptance,
                     const double *emittance, struct taken out[3][6])
{
  for (int k = 0; k < 6; k++) {
    const struct um_thermal_surface_law *law = laws != NULL ? &laws[k % 2] : NULL;
    double a = 0.3 + absorptance[k], e = 0.6 * emittance[k];
    out[0][k] = (struct taken){law ? law->absorptance[0] * a : a, law ? law->albedo * a : a};
    out[1][k] = (struct taken){out[0][k].later, out[0][k].later};
    out[2][k] = (struct taken){law ? law->planet * e : e, law ? law->planet * e : e};
  }
}

static void loads_taken(const struct room *r, const struct um_irradiation_loads *loads, int row,
                        double out[3][6])
{
  static const double same[6] = {280, 280, 280, 280, 280, 280};
  struct um_thermal_heat heat[6];
  size_t n = um_thermal_network_nodes(r->network);
  OK(um_thermal_heat_of_nodes(context, r->network, loads, &r->options, loads->t[row], same, heat));
  for (size_t k = 0; k < n; k++) {
    out[0][k] = heat[k].solar;
    out[1][k] = heat[k].albedo;
    out[2][k] = heat[k].planet;
    if (n == 6 && row == 0) /* emittances between surfaces are those of the start */
      assert_close(heat[k].exchanged + heat[k].radiated, 0.0, 1e-9);
  }
}

/* Walls that have aged: a room of one temperature is in balance, and of what falls on the floor of
 * a cube, with a lid or without, the walls absorb what does not leave, each its own share of what
 * is reflected, which is another one where surfaces follow a law. Later, when the floor alone has
 * aged further, all others get what it reflects then. */
static void aged_walls(void **state)
{
  (void)state;
  static const double absorptance[12] = {0.1, 0.2, 0.0, 0.3, 0.25, 0.0,
                                         0.1, 0.2, 0.0, 0.3, 0.45, 0.0};
  static const double emittance[12] = {0.5, 1.0, 0.7, 0.9, 1.1, 0.8, 0.5, 1.0, 0.7, 0.9, 0.9, 0.8};
  struct um_thermal_surface_law laws[2] = {{.albedo = 0.7, .planet = 0.95},
                                           {.albedo = 0.8, .planet = 0.85}};
  for (int k = 0; k < 2; k++) {
    for (int i = 0; i < UM_THERMAL_LAW_ANGLES; i++) laws[k].absorptance[i] = 0.9;
    for (int i = 0; i < UM_THERMAL_LAW_TEMPERATURES; i++) laws[k].emittance[i] = 1.0;
  }
  for (int c = 0; c < 4; c++) {
    uint32_t nwall = c % 2 == 0 ? 5 : 6, material[256];
    struct room r;
    struct um_geometry_part_spec part[6];
    struct taken taken[2][3][6];
    double at[2][3][6];
    cube(part, 0.6);
    room_open(&r, part, nwall, nwall, 16384);
    for (uint32_t k = 0; k < nwall; k++) room_node(&r, k, 0.6, 0.3, 280, NAN);
    const struct um_geometry_mesh *mesh = um_geometry_mesh(r.geometry);
    for (size_t s = 0; s < r.network->nsurface && c > 1; s++)
      if (r.network->attached[s]) r.network->surface[s].law = &laws[mesh->surface[s].part % 2];
    assert_true(mesh->nsurface <= 256);
    const struct um_thermal_aging aging =
        aging_of(mesh->nsurface, mesh, material, absorptance, emittance);
    struct um_thermal_exchange_options options = {.infrared = true, .solar = true, .aging = &aging};
    struct um_irradiation_loads *loads = floor_lit(mesh);
    OK(um_thermal_exchange_create(context, r.network, loads, r.table, &options, &r.exchange));
    r.options.exchange = r.exchange;
    r.options.aging = &aging;
    for (int row = 0; row < 2; row++) {
      taken_by(c > 1 ? laws : NULL, absorptance + 6 * row, emittance + 6 * row, taken[row]);
      loads_taken(&r, loads, row, at[row]);
    }
    for (int l = 0; l < 3; l++) {
      check_balance(&r, nwall, l, at[0][l], taken[0][l]);
      double then = (1.0 - taken[1][l][FLOOR].first) / (1.0 - taken[0][l][FLOOR].first);
      for (size_t k = 0; k < nwall; k++)
        if (k != FLOOR) assert_close(at[1][l][k] / at[0][l][k], then, 1e-9);
    }
    um_irradiation_loads_destroy(context, &loads);
    room_close(&r);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(aged_walls)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
