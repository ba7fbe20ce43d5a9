/* Paths by way of mirrors against images: what a patch sees in a flat mirror it would see of the
 * image behind it. Two unit squares face each other at distance 1, a mirror stands at right angles
 * on their edges:
 *
 *          +-----+ above        image of above +-----+
 *   mirror |                                         |
 *          +-----+ below                             +-----+ below
 *
 * and two squares side by side see 0.285875 of two at distance 1, one sees 0.199825 of one (Howell
 * C-11), so of the image 0.086050. */
#include "geometry/mirror_paths.h"

#include "geometry/view_factor_table.h"
#include "tests/geometry/support.h"
#include "tests/support/allocator.h"

#define BELOW  0
#define ABOVE  1
#define MIRROR 2

struct corner {
  struct um_geometry_part_spec part[3];
  struct support s;
};

/* The plates' fronts look inward. */
static void corner_open(struct corner *c)
{
  c->part[BELOW] = support_plate("below", 1, 1, um_vec3(0.5, 0, 0));
  c->part[ABOVE] = support_plate("above", 1, 1, um_vec3(0.5, 0, 1));
  c->part[ABOVE].rotation = um_quat_from_axis(um_vec3(1, 0, 0), UM_PI);
  c->part[MIRROR] = support_plate("mirror", 1, 1, um_vec3(0, 0, 0.5));
  c->part[MIRROR].rotation = um_quat_from_axis(um_vec3(0, 1, 0), 0.5 * UM_PI);
  c->s = support_create(c->part, 3);
}

static enum um_status table_make(struct um_context *context, const struct corner *c, size_t rays,
                                 struct um_geometry_view_factor_table **out)
{
  struct um_geometry_view_factor_options options;
  struct um_geometry_mirrors *mirrors = NULL;
  um_geometry_view_factor_defaults(&options);
  options.rays = rays;
  UM_TRY(um_geometry_mirrors_create(context, c->s.mesh->nsurface, &mirrors));
  mirrors->nclass = 1;
  for (size_t i = 0; i < c->s.mesh->nsurface; i++)
    if (c->s.mesh->surface[i].part == MIRROR) mirrors->of[i] = 0;
  options.mirrors = mirrors;
  enum um_status status = um_geometry_view_factor_table_create(context, c->s.geometry, NULL, 1,
                                                               SIZE_MAX, &options, out);
  um_geometry_mirrors_destroy(context, &mirrors);
  return status;
}

/* The patch of a part's front that something stands before. */
static size_t patch_of(const struct corner *c, const struct um_geometry_view_factor_table *table,
                       uint32_t part)
{
  for (size_t p = 0; p < table->noutside; p++) {
    const struct um_geometry_surface *s =
        &c->s.mesh->surface[table->patches->surface[table->patches->begin[p]]];
    if (s->part == part && table->pose[0]->space[p] < 0.99 * table->patches->area[p]) return p;
  }
  fail_msg("no patch");
  return 0;
}

static double path_area(const struct um_geometry_mirror_paths *paths, size_t p, size_t q,
                        uint16_t mirrors)
{
  double sum = 0.0;
  for (size_t k = paths->begin[p]; k < paths->begin[p + 1]; k++)
    if (paths->path[k].to == q && paths->sets.set[paths->path[k].sets].n == mirrors)
      sum += paths->path[k].area;
  return sum;
}

static void image_of_a_square(void **state)
{
  (void)state;
  struct corner c;
  struct um_geometry_view_factor_table *table = NULL;
  corner_open(&c);
  assert_int_equal(table_make(c.s.context, &c, 65536, &table), UM_OK);
  const struct um_geometry_mirror_paths *paths = table->mirrored[0];
  size_t below = 0, above = 0;
  double whole = 0.0, there = 0.0, back = 0.0;
  for (size_t p = 0; p < table->noutside; p++) { /* plates are of two facets */
    uint32_t from = c.s.mesh->surface[table->patches->surface[table->patches->begin[p]]].part;
    for (size_t q = 0; q < table->noutside; q++) {
      uint32_t to = c.s.mesh->surface[table->patches->surface[table->patches->begin[q]]].part;
      assert_true(path_area(paths, p, q, 1) == path_area(paths, q, p, 1)); /* bit by bit */
      assert_true(path_area(paths, p, q, 2) == 0.0); /* one flat mirror is met once */
      if (from == BELOW && to == ABOVE) there += path_area(paths, p, q, 1);
      if (from == ABOVE && to == BELOW) back += path_area(paths, p, q, 1);
      if (from == BELOW && to == BELOW) whole += path_area(paths, p, q, 1);
    }
    below += from == BELOW;
    above += from == ABOVE;
  }
  double f = 0.285875 - 0.199825, sigma = sqrt(f * (1.0 - f) / 131072.0);
  print_message("image: %.6f, expected %.6f, %+.2f standard errors\n", there, f,
                (there - f) / sigma);
  assert_true(below > 0 && above > 0);
  assert_close(there, f, 4.0 * sigma);
  assert_close(there, back, 0.0);
  assert_close(whole, 0.0, 0.0); /* it lies in the plane of its own image */
  assert_int_equal(paths->deepest, 0);
  um_geometry_view_factor_table_destroy(c.s.context, &table);
  support_destroy(&c.s);
}

/* Rows of S' add up to (1 - rho) A, S' is the same both ways, and for rho = 0 it is S. */
static void closure_and_reciprocity(void **state)
{
  (void)state;
  struct corner c;
  struct um_geometry_view_factor_table *table = NULL;
  corner_open(&c);
  assert_int_equal(table_make(c.s.context, &c, 4096, &table), UM_OK);
  size_t n = table->noutside;
  for (int k = 0; k < 3; k++) {
    double rho = 0.45 * k, of_patch[16] = {0};
    struct um_geometry_view_factors *f = NULL;
    assert_true(n <= 16);
    for (size_t p = 0; p < n; p++)
      if (um_geometry_mirrors_patch(table->mirrors, table->patches, p) == 0) of_patch[p] = rho;
    assert_int_equal(um_geometry_view_factors_mirrored(c.s.context, table->pose[0],
                                                       table->mirrored[0], table->patches->area,
                                                       &rho, of_patch, &f),
                     UM_OK);
    for (size_t p = 0; p < n; p++) {
      double sum = f->space[p], area = table->patches->area[p];
      for (size_t q = 0; q < n; q++) {
        double s = um_geometry_view_factors_area(f, p, q);
        assert_true(s >= 0.0 && s == um_geometry_view_factors_area(f, q, p));
        if (k == 0) assert_true(s == um_geometry_view_factors_area(table->pose[0], p, q));
        sum += s;
      }
      assert_close(sum, (1.0 - of_patch[p]) * area, 1e-12 * area);
    }
    size_t from = patch_of(&c, table, BELOW);
    print_message("rho %.2f: row sums to %.1e as sampled, %.4f of a row is space\n", rho,
                  f->unclosed, f->space[from] / table->patches->area[from]);
    assert_true(f->unclosed < 0.02);
    um_geometry_view_factors_destroy(c.s.context, &f);
  }
  um_geometry_view_factor_table_destroy(c.s.context, &table);
  support_destroy(&c.s);
}

/* Any number of threads gives the same bits. */
static void threads(void **state)
{
  (void)state;
  struct corner c;
  struct um_geometry_view_factor_table *table[2] = {NULL, NULL};
  corner_open(&c);
  for (int k = 0; k < 2; k++) {
    um_core_context_set_threads(c.s.context, 1 + 2 * k);
    assert_int_equal(table_make(c.s.context, &c, 4096, &table[k]), UM_OK);
  }
  const struct um_geometry_mirror_paths *a = table[0]->mirrored[0], *b = table[1]->mirrored[0];
  size_t n = table[0]->noutside;
  assert_memory_equal(a->begin, b->begin, (n + 1) * sizeof *a->begin);
  assert_memory_equal(a->sky_begin, b->sky_begin, (n + 1) * sizeof *a->begin);
  for (size_t k = 0; k < a->begin[n]; k++)
    assert_true(a->path[k].to == b->path[k].to && a->path[k].sets == b->path[k].sets &&
                a->path[k].area == b->path[k].area);
  for (size_t k = 0; k < a->sky_begin[n]; k++)
    assert_true(a->sky[k].to == b->sky[k].to && a->sky[k].sets == b->sky[k].sets &&
                a->sky[k].area == b->sky[k].area);
  for (int k = 0; k < 2; k++) um_geometry_view_factor_table_destroy(c.s.context, &table[k]);
  support_destroy(&c.s);
}

static void out_of_memory(void **state)
{
  (void)state;
  struct corner c;
  struct um_test_memory memory = {0};
  struct um_core_allocator allocator = um_test_memory_allocator(&memory);
  struct um_context *small = NULL;
  struct um_geometry_view_factor_table *table = NULL;
  corner_open(&c);
  assert_int_equal(um_core_context_create(&allocator, &small), UM_OK);
  um_core_context_set_threads(small, 1);
  long live = memory.alive, tries = 0;
  enum um_status status = UM_ERR_MEMORY;
  while (status != UM_OK) {
    memory.calls = 0;
    memory.fail_call = ++tries;
    um_core_message_clear(small);
    status = table_make(small, &c, 64, &table);
    if (status == UM_OK) break;
    assert_null(table);
    assert_int_equal(memory.alive, live);
  }
  assert_true(tries > 40);
  um_geometry_view_factor_table_destroy(small, &table);
  assert_int_equal(memory.alive, live);
  um_core_context_destroy(&small);
  support_destroy(&c.s);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(image_of_a_square),
      cmocka_unit_test(closure_and_reciprocity),
      cmocka_unit_test(threads),
      cmocka_unit_test(out_of_memory),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
