/* View factors in files: what is written is read bit by bit, with joints and rooms; what was made
 * of another satellite is refused and says what differs; a cache gives what rays give, and makes
 * anew what is not good; rows of other programs are closed where they nearly do. */
#include "geometry/view_factor_file.h"

#include <dirent.h>
#include <inttypes.h>
#include <stdlib.h>
#include <unistd.h>

#include "base/core/csv.h"
#include "base/core/file.h"
#include "base/core/file_snapshot.h"
#include "geometry/inside.h"
#include "tests/geometry/support.h"
#include "tests/support/allocator.h"
#include "tests/support/temporary.h"

static size_t satellite(struct um_geometry_part_spec part[2])
{
  part[0] = support_box("bus", 1, 1, 1);
  part[0].facet_size = 0.6;
  part[1] = support_plate("wing", 1.2, 1, um_vec3(0, 1.1, 0));
  part[1].joint = UM_JOINT_SUN;
  part[1].joint_axis = um_vec3(0, 1, 0);
  part[1].joint_normal = um_vec3(0, 0, 1);
  part[1].facet_size = 0.6;
  return 2;
}

static const double angles[3] = {0.0, 0.3, 0.6};

static enum um_status try_table(const struct support *s, const double *angle, size_t rays,
                                const char *cache, const char *import,
                                struct um_geometry_view_factor_table **out)
{
  struct um_geometry_view_factor_options options;
  um_geometry_view_factor_defaults(&options);
  options.rays = rays;
  options.cache = cache;
  options.import = import;
  UM_TRY(
      um_geometry_view_factor_table_create(s->context, s->geometry, angle, 3, 40, &options, out));
  enum um_status status = um_geometry_inside_add(s->context, s->geometry, 0, 0, &options, *out);
  if (status != UM_OK) um_geometry_view_factor_table_destroy(s->context, out);
  return status;
}

static struct um_geometry_view_factor_table *table_of(const struct support *s, const char *cache,
                                                      const char *import)
{
  struct um_geometry_view_factor_table *t = NULL;
  if (try_table(s, angles, 256, cache, import, &t) != UM_OK)
    fail_msg("%s", um_core_message(s->context));
  return t;
}

static void assert_factors_same(const struct um_geometry_view_factors *a,
                                const struct um_geometry_view_factors *b)
{
  size_t n = a->npatch, entries = a->begin[n];
  assert_int_equal(n, b->npatch);
  assert_memory_equal(a->begin, b->begin, (n + 1) * sizeof *a->begin);
  assert_memory_equal(a->other, b->other, entries * sizeof *a->other);
  assert_memory_equal(a->area, b->area, entries * sizeof *a->area);
  assert_memory_equal(a->space, b->space, n * sizeof *a->space);
  assert_int_equal(a->rays, b->rays);
  assert_close(a->cut, b->cut, 0.0);
  assert_close(a->unclosed, b->unclosed, 0.0);
  assert_close(a->residual, b->residual, 0.0);
}

static void assert_same(const struct um_geometry_view_factor_table *a,
                        const struct um_geometry_view_factor_table *b)
{
  const struct um_geometry_patches *p = a->patches, *q = b->patches;
  assert_int_equal(p->npatch, q->npatch);
  assert_int_equal(p->nsurface, q->nsurface);
  assert_memory_equal(p->patch, q->patch, p->nsurface * sizeof *p->patch);
  assert_memory_equal(p->begin, q->begin, (p->npatch + 1) * sizeof *p->begin);
  assert_memory_equal(p->surface, q->surface, p->begin[p->npatch] * sizeof *p->surface);
  assert_memory_equal(p->area, q->area, p->npatch * sizeof *p->area);
  assert_int_equal(a->npose, b->npose);
  assert_close(a->interpolation, b->interpolation, 0.0);
  for (size_t k = 0; k < a->npose; k++) assert_factors_same(a->pose[k], b->pose[k]);
  for (size_t k = 0; k < a->nroom; k++) assert_factors_same(a->room[k].factors, b->room[k].factors);
  assert_memory_equal(a->weight, b->weight, a->ntime * a->ncorner * sizeof *a->weight);
}

/* Runs `each` on every file of a folder; how many there are. */
static size_t for_files(const char *folder, void (*each)(const char *path))
{
  size_t n = 0;
  DIR *d = opendir(folder);
  assert_non_null(d);
  for (struct dirent *e; (e = readdir(d)) != NULL;) {
    char path[UM_TEST_PATH + 300];
    if (e->d_name[0] == '.') continue;
    snprintf(path, sizeof path, "%s/%s", folder, e->d_name);
    if (each != NULL) each(path);
    n++;
  }
  closedir(d);
  return n;
}

static void drop(const char *path) { assert_int_equal(remove(path), 0); }
static void cut_short(const char *path) { assert_int_equal(truncate(path, 700), 0); }
/* One exchange area a little larger: rows no longer close. */
static void spoil(const char *path)
{
  FILE *file = fopen(path, "r+");
  assert_non_null(file);
  char line[256];
  long at = 0;
  while (fgets(line, sizeof line, file) != NULL && strncmp(line, "exchange,", 9) != 0)
    at = ftell(file);
  char *value = strrchr(line, ',');
  assert_non_null(value);
  assert_int_equal(fseek(file, at, SEEK_SET), 0);
  line[strcspn(line, "\n")] = '\0';
  for (char *c = line; *c != '\0'; c++)
    if (*c == '.') c[1] = c[1] == '9' ? '1' : '9';
  assert_true(fputs(line, file) >= 0);
  assert_int_equal(fclose(file), 0);
}

/* --- files of a cache that somebody changed --- */

/* The checksum of the changed bytes behind them, by the published offset and prime of FNV-1a. */
static void seal(char *text)
{
  uint64_t digest = 0xcbf29ce484222325u;
  char *end = strstr(text, "# checksum");
  assert_non_null(end);
  for (const char *c = text; c < end; c++) digest = (digest ^ (unsigned char)*c) * 0x100000001b3u;
  char *number = strrchr(end, ' ');
  assert_int_equal(strlen(number + 1), 17);
  snprintf(number + 1, 18, "%016" PRIx64 "\n", digest);
}

/* The last row of a record before `end`; where its value begins. */
static char *value_of(char *text, const char *end, const char *row)
{
  char *found = NULL;
  for (char *c = text; (c = strstr(c, row)) != NULL && c < end; c++) found = c;
  return found == NULL ? NULL : found + strlen(row);
}

/* `add` to the value of a row, in a text that has room. */
static void add_to(char *value, double add)
{
  char *end, rest[1 << 16], number[32];
  double old = strtod(value, &end);
  assert_true(strlen(end) < sizeof rest);
  strcpy(rest, end);
  um_core_number_text(old + add, number);
  strcpy(value, number);
  strcat(value, rest);
}

/* 30 % of the last exchange of two patches goes to space: both rows still add up. */
static void give_to_space(char *text)
{
  char row[64], *at = text, *last = NULL;
  unsigned pose, p, q, from = 0, to = 0, of = 0;
  while ((at = strstr(at, "\nexchange,")) != NULL) {
    assert_int_equal(sscanf(++at, "exchange,%u,%u,%u,", &pose, &p, &q), 3);
    if (p != q && strncmp(at, "exchange,0,", 11) == 0) last = at, of = pose, from = p, to = q;
  }
  assert_non_null(last);
  snprintf(row, sizeof row, "exchange,%u,%u,%u,", of, from, to);
  double share = 0.3 * strtod(last + strlen(row), NULL);
  add_to(last + strlen(row), -share);
  const unsigned patch[2] = {from, to};
  for (int k = 0; k < 2; k++) {
    snprintf(row, sizeof row, "\nspace,%u,%u,,", of, patch[k]);
    char *space = strstr(text, row);
    assert_non_null(space);
    add_to(space + strlen(row), share);
  }
}

/* The last digit of the last exchange area is another. */
static void change_digit(char *text)
{
  char *value = value_of(text, text + strlen(text), "\nexchange,");
  char *end = strchr(value, '\n') - 2;
  *end = *end == '4' ? '5' : '4';
}
static void drop_checksum(char *text) { *strstr(text, "# checksum") = '\0'; }
static void give_and_seal(char *text)
{
  give_to_space(text);
  seal(text);
}
static void no_longer_closed(char *text)
{
  add_to(strchr(value_of(text, text + strlen(text), "\nspace,0,0,"), ',') + 1, 1e-3);
  seal(text);
}

static void (*change)(char *text);
static void change_file(const char *path)
{
  char text[1 << 16] = "";
  FILE *file = fopen(path, "r");
  assert_non_null(file);
  size_t n = fread(text, 1, sizeof text - 200, file);
  assert_true(n > 0 && n < sizeof text - 200);
  assert_int_equal(fclose(file), 0);
  change(text);
  file = fopen(path, "w");
  assert_non_null(file);
  assert_true(fputs(text, file) >= 0);
  assert_int_equal(fclose(file), 0);
}

/* How often the log says it. */
static size_t warnings(const struct support *s)
{
  size_t n = 0;
  for (const char *c = um_core_log_text(s->context);
       (c = strstr(c, "of the cache are made anew: ")) != NULL; c++)
    n++;
  return n;
}

static void no_file(void *self, const char *path, uint64_t digest)
{
  (void)self;
  (void)digest;
  fail_msg("%s counts as a file of the user's", path);
}

/* One digit, an exchange given to space, no checksum as in files of old: by the checksum. Space
 * inside a room and rows that do not add up, with the checksum of these bytes: by the laws. All is
 * made anew, with a warning a file, once. */
static void cache_changed(void **state)
{
  (void)state;
  struct um_geometry_part_spec part[2];
  struct support s = support_create(part, satellite(part));
  char folder[UM_TEST_PATH], room[UM_TEST_PATH + 300] = "";
  static void (*const changes[])(char *text) = {change_digit, give_to_space, drop_checksum,
                                                give_and_seal, no_longer_closed};
  assert_int_equal(um_test_folder_create(folder), 0);
  struct um_geometry_view_factor_table *rays = table_of(&s, folder, NULL), *t;
  assert_int_equal(warnings(&s), 0);
  for (size_t k = 0; k < sizeof changes / sizeof changes[0]; k++) {
    size_t before = warnings(&s);
    change = changes[k];
    if (change == give_and_seal) { /* which the outside may do */
      DIR *d = opendir(folder);
      assert_non_null(d);
      for (struct dirent *e; (e = readdir(d)) != NULL;)
        if (strstr(e->d_name, "-inside-") != NULL)
          snprintf(room, sizeof room, "%s/%s", folder, e->d_name);
      closedir(d);
      change_file(room);
    } else {
      for_files(folder, change_file);
    }
    assert_int_equal(um_core_snapshot_begin(s.context), UM_OK);
    for (int again = 0; again < 2; again++) { /* a second time it is good, though files are held */
      t = table_of(&s, folder, NULL);
      assert_same(rays, t);
      um_geometry_view_factor_table_destroy(s.context, &t);
      assert_int_equal(warnings(&s) - before, change == give_and_seal ? 1 : 2);
    }
    um_core_snapshot_each(s.context, no_file, NULL); /* it is no input of the user's */
    um_core_snapshot_end(s.context);
  }
  for_files(folder, drop);
  assert_int_equal(um_test_folder_remove(folder), 0);
  um_geometry_view_factor_table_destroy(s.context, &rays);
  support_destroy(&s);
}

static void cache(void **state)
{
  (void)state;
  struct um_geometry_part_spec part[2];
  struct support s = support_create(part, satellite(part));
  char folder[UM_TEST_PATH];
  assert_int_equal(um_test_folder_create(folder), 0);
  struct um_geometry_view_factor_table *rays = table_of(&s, NULL, NULL), *t[5];
  assert_true(rays->npose > 1 && rays->noutside > 2 && rays->nroom == 1);
  t[0] = table_of(&s, folder, NULL);
  assert_int_equal(for_files(folder, NULL), 2); /* outside and the room */
  t[1] = table_of(&s, folder, NULL);
  for_files(folder, cut_short);
  t[2] = table_of(&s, folder, NULL); /* made anew and mended */
  for_files(folder, spoil);
  t[3] = table_of(&s, folder, NULL);
  t[4] = table_of(&s, folder, NULL);
  assert_int_equal(for_files(folder, NULL), 2);
  for (int k = 0; k < 5; k++) {
    assert_same(rays, t[k]);
    um_geometry_view_factor_table_destroy(s.context, &t[k]);
  }
  /* other rays are other files */
  assert_int_equal(try_table(&s, angles, 300, folder, NULL, &t[0]), UM_OK);
  assert_int_equal(for_files(folder, NULL), 4);
  um_geometry_view_factor_table_destroy(s.context, &t[0]);
  for_files(folder, drop);
  assert_int_equal(um_test_folder_remove(folder), 0);
  /* a folder that cannot be made keeps nothing and harms nothing */
  t[0] = table_of(&s, "/dev/null/nowhere", NULL);
  assert_same(rays, t[0]);
  um_geometry_view_factor_table_destroy(s.context, &t[0]);
  um_geometry_view_factor_table_destroy(s.context, &rays);
  support_destroy(&s);
}

static void write_all(const struct support *s, const struct um_geometry_view_factor_table *t,
                      const char *folder)
{
  char path[UM_TEST_PATH + 32];
  snprintf(path, sizeof path, "%s/outside.csv", folder);
  FILE *file = fopen(path, "w");
  assert_non_null(file);
  um_geometry_view_factor_table_write(s->geometry, t, file);
  assert_int_equal(fclose(file), 0);
  snprintf(path, sizeof path, "%s/inside-bus.csv", folder);
  file = fopen(path, "w");
  assert_non_null(file);
  assert_int_equal(um_geometry_inside_write(s->context, s->geometry, t, 0, file), UM_OK);
  assert_int_equal(fclose(file), 0);
}

static void refused(const struct support *s, const double *angle, const char *folder,
                    const char *says)
{
  struct um_geometry_view_factor_table *t = NULL;
  assert_int_equal(try_table(s, angle, 256, NULL, folder, &t), UM_ERR_INPUT);
  assert_null(t);
  if (strstr(um_core_message(s->context), says) == NULL)
    fail_msg("'%s' does not say '%s'", um_core_message(s->context), says);
  um_core_message_clear(s->context);
}

static void import(void **state)
{
  (void)state;
  struct um_geometry_part_spec part[2];
  struct support s = support_create(part, satellite(part));
  char folder[UM_TEST_PATH], path[UM_TEST_PATH + 32];
  static const double other[3] = {0.0, 0.3, 1.0};
  assert_int_equal(um_test_folder_create(folder), 0);
  struct um_geometry_view_factor_table *rays = table_of(&s, NULL, NULL), *t = NULL;
  write_all(&s, rays, folder);
  t = table_of(&s, NULL, folder);
  assert_same(rays, t);
  um_geometry_view_factor_table_destroy(s.context, &t);
  /* whatever rays are asked for */
  assert_int_equal(try_table(&s, angles, 999, NULL, folder, &t), UM_OK);
  assert_same(rays, t);
  um_geometry_view_factor_table_destroy(s.context, &t);
  refused(&s, other, folder, "angles of joints differ");
  static const double shifted[3] = {2.0, 2.3, 2.6};
  refused(&s, shifted, folder, "outside.csv: made of another satellite: angles of joints differ");
  struct support moved = {0};
  part[1].position = um_vec3(0, 1.2, 0);
  moved = support_create(part, 2);
  refused(&moved, angles, folder, "made of another satellite: shapes or places differ");
  support_destroy(&moved);
  part[1].facet_size = 0.3;
  moved = support_create(part, 2);
  refused(&moved, angles, folder, "made of another satellite: facets, groups or parts differ");
  support_destroy(&moved);
  change = give_to_space;
  snprintf(path, sizeof path, "%s/inside-bus.csv", folder);
  change_file(path);
  refused(&s, angles, folder, "accepted: 0, it is inside");
  for_files(folder, spoil);
  refused(&s, angles, folder, "add up to its area but for a share of");
  for_files(folder, drop);
  assert_int_equal(try_table(&s, angles, 256, NULL, "/dev/null", &t), UM_ERR_IO);
  um_core_message_clear(s.context);
  assert_int_equal(um_test_folder_remove(folder), 0);
  um_geometry_view_factor_table_destroy(s.context, &rays);
  support_destroy(&s);
}

/* Two plates and factors of another program, two digits good: 0.198 in place of 0.199825 and rows 1
 * % short are closed, the same both ways; a share of space alone is not enough. */
static void other_program(void **state)
{
  (void)state;
  struct um_geometry_part_spec part[2] = {support_plate("below", 1, 1, um_vec3(0, 0, 0)),
                                          support_plate("above", 1, 1, um_vec3(0, 0, 1))};
  struct support s = support_create(part, 2);
  struct um_geometry_view_factors *pose[1] = {NULL};
  struct um_geometry_view_factor_set set = {
      .geometry = s.geometry, .mesh = s.mesh, .key = {1, 2, 3, 4}, .npose = 1, .pose = pose};
  static const char *const text[2] = {
      "record,pose,from,to,value,of\nsurfaces,,,,1,\npositions,,,,2,\nangles,,,,3,\n"
      "sampling,,,,ff,\npatches,,,,2,\nposes,,,,1,\ninterpolation,0,,,0,\npatch,,0,0,0.5,\n"
      "patch,,0,2,0.5,\npatch,,1,5,0.5,\npatch,,1,7,0.5,\nrays,0,,,0,\ncut,0,,,0,\n"
      "unclosed,0,,,0,\nresidual,0,,,0,\nspace,0,0,,0.792,\nexchange,0,0,1,0.198,\n"
      "space,0,1,,0.792,\n",
      "record,pose,from,to,value,of\nsurfaces,,,,1,\npositions,,,,2,\nangles,,,,3,\n"
      "sampling,,,,ff,\npatches,,,,2,\nposes,,,,1,\ninterpolation,0,,,0,\npatch,,0,0,0.5,\n"
      "patch,,0,2,0.5,\npatch,,1,5,0.5,\npatch,,1,7,0.5,\nrays,0,,,0,\ncut,0,,,0,\n"
      "unclosed,0,,,0,\nresidual,0,,,0,\nspace,0,0,,0.9,\nspace,0,1,,0.9,\n"};
  char path[UM_TEST_PATH];
  um_test_file_create(path, text[0], strlen(text[0]));
  assert_int_equal(um_geometry_view_factor_file_read(s.context, path, true, &set), UM_ERR_INPUT);
  assert_null(set.patches);
  um_core_message_clear(s.context);
  if (um_geometry_view_factor_file_read(s.context, path, false, &set) != UM_OK)
    fail_msg("%s", um_core_message(s.context));
  double f = um_geometry_view_factors_area(pose[0], 0, 1);
  assert_close(f, um_geometry_view_factors_area(pose[0], 1, 0), 0.0);
  assert_close(f + pose[0]->space[0], 1.0, 1e-12);
  assert_close(f, 0.2, 2e-3);
  um_geometry_view_factors_destroy(s.context, &pose[0]);
  um_geometry_patches_destroy(s.context, &set.patches);
  drop(path);
  um_test_file_create(path, text[1], strlen(text[1]));
  assert_int_equal(um_geometry_view_factor_file_read(s.context, path, false, &set), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(s.context),
                         "patch 0 add up to its area but for a share of "
                         "0.1; accepted: 0.05"));
  drop(path);
  support_destroy(&s);
}

static void out_of_memory(void **state)
{
  (void)state;
  struct um_geometry_part_spec part[2];
  struct support s = support_create(part, satellite(part));
  char folder[UM_TEST_PATH];
  assert_int_equal(um_test_folder_create(folder), 0);
  struct um_geometry_view_factor_table *t = table_of(&s, NULL, NULL);
  write_all(&s, t, folder);
  um_geometry_view_factor_table_destroy(s.context, &t);
  struct um_test_memory memory = {0};
  struct um_core_allocator allocator = um_test_memory_allocator(&memory);
  struct support small = s;
  assert_int_equal(um_core_context_create(&allocator, &small.context), UM_OK);
  um_core_context_set_threads(small.context, 1);
  long live = memory.alive, tries = 0;
  enum um_status status = UM_ERR_MEMORY;
  while (status != UM_OK) {
    memory.calls = 0;
    memory.fail_call = ++tries;
    um_core_message_clear(small.context);
    status = try_table(&small, angles, 256, NULL, folder, &t);
    if (status != UM_OK) assert_int_equal(status, UM_ERR_MEMORY);
    um_geometry_view_factor_table_destroy(small.context, &t);
    assert_int_equal(memory.alive, live);
  }
  assert_true(tries > 30);
  um_core_context_destroy(&small.context);
  for_files(folder, drop);
  assert_int_equal(um_test_folder_remove(folder), 0);
  support_destroy(&s);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(cache), cmocka_unit_test(cache_changed),
                                     cmocka_unit_test(import), cmocka_unit_test(other_program),
                                     cmocka_unit_test(out_of_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
