/* The inside of a solid in run.nc, read back, and what run.xdmf says of it. */
#include <netcdf.h>
#include <stdlib.h>

#include "model/build/build.h"
#include "output/output.h"
#include "tests/effects/heat_help.h"
#include "thermal/network/tetgen_impl.h"

#define FILE_NAME "output_solids.nc"
#define TEXT      65536

#define NC(call) assert_int_equal(call, NC_NOERR)

static const char *const solid[] = {"parts.bus.lumped=false",
                                    "parts.bus.solid.density_kg_m3=100",
                                    "parts.bus.solid.specific_heat_J_kg_K=900",
                                    "parts.bus.solid.conductivity_W_m_K=3",
                                    "parts.bus.solid.power_W=30",
                                    "thermal.facet_size_m=0.5",
                                    NULL};

static size_t length_of(int file, const char *name)
{
  int id;
  size_t n;
  NC(nc_inq_dimid(file, name, &id));
  NC(nc_inq_dimlen(file, id, &n));
  return n;
}

/* The caller frees; n values of 8 bytes. */
static void *values_of(int file, const char *name, size_t n, bool integers)
{
  int id;
  void *v = calloc(n, 8);
  assert_non_null(v);
  NC(nc_inq_varid(file, name, &id));
  if (integers)
    NC(nc_get_var_int(file, id, v));
  else
    NC(nc_get_var_double(file, id, v));
  return v;
}

/* Six times the volume of tetrahedra, each of them positive. */
static double six_volumes(double (*x)[3], int (*corner)[4], size_t n, size_t nvertex)
{
  double sum = 0.0;
  for (size_t e = 0; e < n; e++) {
    struct um_vec3 v[4];
    for (int c = 0; c < 4; c++) {
      assert_true(corner[e][c] >= 0 && (size_t)corner[e][c] < nvertex);
      const double *at = x[corner[e][c]];
      v[c] = um_vec3(at[0], at[1], at[2]);
    }
    struct um_vec3 a = um_vec3_sub(v[1], v[0]), b = um_vec3_sub(v[2], v[0]);
    double six = um_vec3_dot(um_vec3_cross(a, b), um_vec3_sub(v[3], v[0]));
    assert_true(six > 0.0);
    sum += six;
  }
  return sum;
}

/* The bus is the cube of 1 m at x = -2 m: its tetrahedra fill it (sums of determinants, rounding
 * only); every vertex is as warm as its node, and warmer inside than the mean of the surface, since
 * heat is made in the volume. */
static void check_netcdf(const struct heat_run *run)
{
  int file;
  NC(nc_open(FILE_NAME, NC_NOWRITE, &file));
  size_t nv = length_of(file, "solid_vertex"), n = length_of(file, "tetrahedron");
  size_t nnode = length_of(file, "node"), ntime = length_of(file, "time");
  assert_int_equal(n, run->model->body->ntetrahedron);
  double(*x)[3] = values_of(file, "solid_vertex_position", 3 * nv, false);
  int(*corner)[4] = values_of(file, "tetrahedron_vertex", 4 * n, true);
  int *node = values_of(file, "solid_vertex_node", nv, true);
  double *t = values_of(file, "solid_vertex_temperature", ntime * nv, false);
  double *all = values_of(file, "node_temperature", ntime * nnode, false);
  heat_close("volume", six_volumes(x, corner, n, nv) / 6.0, 1.0, 1e-12);
  double outside = heat_temperature(run, "bus.wall", 0), inside = 0.0;
  for (size_t v = 0; v < nv; v++) {
    assert_true(fabs(x[v][0] + 2.0) <= 0.5 + 1e-12 && fabs(x[v][1]) <= 0.5 + 1e-12);
    inside = fmax(inside, t[v]);
    for (size_t k = 0; k < ntime; k++)
      assert_true(t[k * nv + v] == all[k * nnode + (size_t)node[v]]);
  }
  print_message("%zu tetrahedra, %zu vertices: wall %.3f K, warmest %.3f K\n", n, nv, outside,
                inside);
  assert_true(inside > outside + 0.5);
  free(x);
  free(corner);
  free(node);
  free(t);
  free(all);
  NC(nc_close(file));
}

static void check_xdmf(const struct um_output_run *out)
{
  const struct um_thermal_body *body = out->model->body;
  char *text = calloc(TEXT, 1), words[256];
  FILE *file = tmpfile();
  assert_true(text != NULL && file != NULL);
  assert_int_equal(um_output_write_xdmf(out, file), UM_OK);
  rewind(file);
  assert_true(fread(text, 1, TEXT - 1, file) > 0);
  assert_int_equal(fclose(file), 0);
  snprintf(words, sizeof words,
           "TopologyType=\"Tetrahedron\" NumberOfElements=\"%zu\"><DataItem Dimensions=\"%zu 4\" "
           "NumberType=\"UInt\" Format=\"HDF\">run.nc:/tetrahedron_vertex<",
           body->ntetrahedron, body->ntetrahedron);
  assert_non_null(strstr(text, words));
  assert_non_null(strstr(text, "run.nc:/solid_vertex_position<"));
  assert_non_null(strstr(text, "run.nc:/solid_vertex_temperature<"));
  free(text);
}

static void test_inside(void **state)
{
  (void)state;
  struct heat_run run = heat_compute(solid, NONE, NONE);
  const struct um_output_run out = {.model = run.model,
                                    .tables = run.tables,
                                    .result = run.result,
                                    .command = "test",
                                    .version = "test"};
  FILE *file = fopen(FILE_NAME, "wb");
  assert_non_null(file);
  assert_int_equal(um_output_write_netcdf(run.context, &out, file), UM_OK);
  assert_int_equal(fclose(file), 0);
  check_netcdf(&run);
  check_xdmf(&out);
  assert_int_equal(remove(FILE_NAME), 0);
  heat_release(&run);
}

/* Without TetGen the scenario is refused, with what is needed. */
static void test_without_tetgen(void **state)
{
  (void)state;
  struct um_context *context = NULL;
  struct um_model *model = NULL;
  const struct um_model_options options = {.overrides = solid, .noverride = 6};
  assert_int_equal(um_core_context_create(NULL, &context), UM_OK);
  assert_int_equal(um_model_create(context, "output_solids.yaml", &options, &model),
                   UM_ERR_LIBRARY);
  print_message("%s\n", um_core_message(context));
  assert_non_null(strstr(um_core_message(context), "UMBRA_TETGEN"));
  um_core_context_destroy(&context);
}

static int setup(void **state)
{
  (void)state;
  return heat_setup("output_solids.yaml");
}
static int teardown(void **state)
{
  (void)state;
  return heat_teardown();
}

int main(void)
{
  const struct CMUnitTest with[] = {cmocka_unit_test(test_inside)},
                          without[] = {cmocka_unit_test(test_without_tetgen)};
  return um_thermal_tetgen_present() ? cmocka_run_group_tests(with, setup, teardown)
                                     : cmocka_run_group_tests(without, setup, teardown);
}
