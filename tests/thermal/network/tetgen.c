/* TetGen in its child: what it makes is whole, what it cannot stand is refused by name, and no
 * child stays behind. */
#include <errno.h>
#include <stdlib.h>
#include <sys/wait.h>

#include "tests/thermal/network_help.h"
#include "thermal/network/tetgen_impl.h"

static const uint32_t box_facet[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6},
                                          {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7},
                                          {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};

struct surface {
  struct um_vec3 vertex[64];
  uint32_t facet[64][3];
  size_t nvertex, nfacet;
};

/* A box of edge a from `corner`; inward: it bounds a cavity. */
static void add_box(struct surface *s, struct um_vec3 corner, double a, bool inward)
{
  uint32_t first = (uint32_t)s->nvertex;
  for (int i = 0; i < 8; i++)
    s->vertex[s->nvertex++] = um_vec3_axpy(corner, a, um_vec3(i & 1, (i >> 1) & 1, (i >> 2) & 1));
  for (int f = 0; f < 12; f++, s->nfacet++)
    for (int c = 0; c < 3; c++) s->facet[s->nfacet][inward ? 2 - c : c] = first + box_facet[f][c];
}

/* Every child has been waited for: waitpid finds none. */
static void assert_no_child(void)
{
  int state;
  assert_int_equal(waitpid(-1, &state, WNOHANG), -1);
  assert_int_equal(errno, ECHILD);
}

static enum um_status fill(const struct surface *s, double edge, struct um_thermal_tetrahedra **t)
{
  um_core_message_clear(help_context);
  enum um_status status =
      um_thermal_tetgen_fill(help_context, "tank", s->vertex, s->nvertex,
                             (const uint32_t(*)[3])s->facet, s->nfacet, edge, t);
  assert_no_child();
  return status;
}

/* The fill fails, the message names the part and says `words`. */
static void refused(const struct surface *s, enum um_status expected, const char *words)
{
  struct um_thermal_tetrahedra *t = NULL;
  enum um_status status = fill(s, 0.5, &t);
  print_message("  %s\n", um_core_message(help_context));
  assert_int_equal(status, expected);
  assert_null(t);
  assert_non_null(strstr(um_core_message(help_context), "part tank"));
  if (strstr(um_core_message(help_context), words) == NULL)
    fail_msg("'%s' is not in '%s'", words, um_core_message(help_context));
}

/* Volume of all tetrahedra; every one positive. */
static double volume_of(const struct um_thermal_tetrahedra *t)
{
  double volume = 0.0;
  for (size_t e = 0; e < t->ntetrahedron; e++) {
    const struct um_vec3 *v = t->vertex;
    const uint32_t *c = t->corner[e];
    struct um_vec3 a = um_vec3_sub(v[c[1]], v[c[0]]), b = um_vec3_sub(v[c[2]], v[c[0]]);
    double six = um_vec3_dot(um_vec3_cross(a, b), um_vec3_sub(v[c[3]], v[c[0]]));
    assert_true(six > 0.0);
    volume += six / 6.0;
  }
  return volume;
}

/* Volumes are sums of exact determinants: rounding only. The surface vertices come first, in
 * order, bit for bit. Every input facet is the face of one tetrahedron. */
static void test_box(void **state)
{
  (void)state;
  struct surface s = {.nvertex = 0};
  struct um_thermal_tetrahedra *t = NULL;
  add_box(&s, um_vec3(-1, 2, 3), 2.0, false);
  OK(fill(&s, 0.0, &t));
  NEAR("box", volume_of(t), 8.0, 1e-12);
  assert_memory_equal(t->vertex, s.vertex, 8 * sizeof s.vertex[0]);
  for (size_t f = 0; f < s.nfacet; f++) {
    int owners = 0;
    for (size_t e = 0; e < t->ntetrahedron; e++) {
      int shared = 0;
      for (int i = 0; i < 4; i++)
        for (int j = 0; j < 3; j++) shared += t->corner[e][i] == s.facet[f][j];
      owners += shared == 3;
    }
    assert_int_equal(owners, 1);
  }
  um_thermal_tetrahedra_destroy(help_context, &t);
  assert_null(t);
}

/* A cavity stays empty: 27 - 1. */
static void test_cavity(void **state)
{
  (void)state;
  struct surface s = {.nvertex = 0};
  struct um_thermal_tetrahedra *t = NULL;
  add_box(&s, um_vec3(0, 0, 0), 3.0, false);
  add_box(&s, um_vec3(1, 1, 1), 1.0, true);
  OK(fill(&s, 0.0, &t));
  NEAR("box with a cavity", volume_of(t), 26.0, 1e-11);
  um_thermal_tetrahedra_destroy(help_context, &t);
}

static void test_refused(void **state)
{
  (void)state;
  struct surface s = {.nvertex = 0}, bad;
  add_box(&s, um_vec3(0, 0, 0), 1.0, false);
  bad = s;
  bad.nfacet--;
  refused(&bad, UM_ERR_INPUT, "is open");
  bad = s;
  bad.vertex[3].y = NAN;
  refused(&bad, UM_ERR_INPUT, "vertex 3");
  bad.vertex[3].y = INFINITY;
  refused(&bad, UM_ERR_INPUT, "finite");
  bad = s;
  bad.facet[5][1] = 99;
  refused(&bad, UM_ERR_INPUT, "vertex 1 99 4");
  bad = s;
  bad.vertex[7] = um_vec3(1, 1, 1e-13);
  refused(&bad, UM_ERR_INPUT, "no area");
  bad = s;
  add_box(&bad, um_vec3(1, 1, 1), 1.0, false); /* touches in one corner */
  refused(&bad, UM_ERR_INPUT, "vertices 7 and 8 coincide");
  bad = s;
  bad.facet[0][0] = bad.facet[0][1];
  refused(&bad, UM_ERR_INPUT, "no area");
  bad = s;
  bad.facet[4][1] = s.facet[4][2];
  bad.facet[4][2] = s.facet[4][1];
  refused(&bad, UM_ERR_INPUT, "face opposite ways");
  bad = (struct surface){.nvertex = 0};
  add_box(&bad, um_vec3(0, 0, 0), 1.0, true);
  refused(&bad, UM_ERR_INPUT, "face inward");
  bad = s;
  bad.vertex[bad.nvertex++] = um_vec3(0.5, 0.4, 0.3);
  refused(&bad, UM_ERR_INPUT, "belongs to no facet");
  bad = s;
  bad.nfacet = 0;
  refused(&bad, UM_ERR_INPUT, "do not enclose");
}

/* Two boxes through each other; and a box whose corner is pushed through the opposite face. */
static void test_crossing(void **state)
{
  (void)state;
  struct surface s = {.nvertex = 0};
  add_box(&s, um_vec3(0, 0, 0), 1.0, false);
  struct surface bad = s;
  add_box(&bad, um_vec3(0.37, 0.47, 0.57), 1.0, false);
  refused(&bad, UM_ERR_INPUT, "crosses itself: facet ");
  /* one facet of each box: below and above 12 */
  unsigned a = 99, b = 99;
  const char *at = strstr(um_core_message(help_context), "facet ");
  assert_int_equal(sscanf(at, "facet %u", &a), 1);
  at = strstr(at + 1, "and facet ");
  assert_non_null(at);
  assert_int_equal(sscanf(at, "and facet %u", &b), 1);
  assert_true(a < 12 && b >= 12 && b < 24);
  bad = s;
  bad.vertex[7] = um_vec3(0.3, 0.4, -0.5);
  refused(&bad, UM_ERR_INPUT, "crosses itself");
}

/* Limits: no time, no memory; the parent lives and says so. */
static void test_limits(void **state)
{
  (void)state;
  struct surface s = {.nvertex = 0};
  struct um_thermal_tetrahedra *t = NULL;
  add_box(&s, um_vec3(0, 0, 0), 1.0, false);
  struct um_thermal_tetgen_limits no_time = {.seconds = 0.0, .megabyte = 8192};
  um_core_message_clear(help_context);
  assert_int_equal(um_thermal_tetgen_fill_limited(help_context, "tank", s.vertex, s.nvertex,
                                                  (const uint32_t(*)[3])s.facet, s.nfacet, 0.1,
                                                  &no_time, &t),
                   UM_ERR_LIBRARY);
  print_message("  %s\n", um_core_message(help_context));
  assert_non_null(strstr(um_core_message(help_context), "part tank: TetGen did not finish"));
  assert_no_child();
#if !defined(__SANITIZE_ADDRESS__)
  struct um_thermal_tetgen_limits no_memory = {.seconds = 60.0, .megabyte = 0};
  um_core_message_clear(help_context);
  assert_int_equal(um_thermal_tetgen_fill_limited(help_context, "tank", s.vertex, s.nvertex,
                                                  (const uint32_t(*)[3])s.facet, s.nfacet, 0.1,
                                                  &no_memory, &t),
                   UM_ERR_LIBRARY);
  print_message("  %s\n", um_core_message(help_context));
  assert_no_child();
#endif
  assert_null(t);
}

static void test_absent(void **state)
{
  (void)state;
  struct surface s = {.nvertex = 0};
  add_box(&s, um_vec3(0, 0, 0), 1.0, false);
  refused(&s, UM_ERR_LIBRARY, "UMBRA_TETGEN=OFF");
}

int main(void)
{
  const struct CMUnitTest with[] = {cmocka_unit_test(test_box), cmocka_unit_test(test_cavity),
                                    cmocka_unit_test(test_refused), cmocka_unit_test(test_crossing),
                                    cmocka_unit_test(test_limits)};
  const struct CMUnitTest without[] = {cmocka_unit_test(test_refused),
                                       cmocka_unit_test(test_absent)};
  if (um_thermal_tetgen_present()) return cmocka_run_group_tests(with, help_setup, help_teardown);
  return cmocka_run_group_tests(without, help_setup, help_teardown);
}
