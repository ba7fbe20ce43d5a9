/* heat.csv: parts, walls and interiors own their nodes, so that their rows add up to the satellite:
 * power is what was put in, what one node gives another takes. Groups add up to their part. */
#include <stdlib.h>

#include "output/output.h"
#include "tests/effects/heat_help.h"

#define TEXT    65536
#define COLUMNS 8 /* solar, albedo, planet, internal, conducted, radiated, exchanged, stored */
#define ROWS    32

struct table {
  char name[ROWS][32];
  double value[ROWS][COLUMNS]; /* [W] of the first observation */
  size_t nrow;
};

static void read_table(const struct heat_run *run, struct table *table)
{
  const struct um_output_run out = {
      .model = run->model, .tables = run->tables, .result = run->result};
  char *text = calloc(TEXT, 1), *rest, first[32] = "";
  FILE *file = tmpfile();
  table->nrow = 0;
  assert_non_null(text);
  assert_non_null(file);
  assert_int_equal(um_output_write_heat(&out, file), UM_OK);
  rewind(file);
  assert_true(fread(text, 1, TEXT - 1, file) > 0);
  assert_int_equal(fclose(file), 0);
  strtok_r(text, "\n", &rest); /* the header */
  for (char *line; (line = strtok_r(NULL, "\n", &rest)) != NULL;) {
    char *at = strchr(line, ','), *end = strchr(at + 1, ',');
    if (first[0] == '\0') snprintf(first, sizeof first, "%.*s", (int)(at - line), line);
    if (strncmp(line, first, strlen(first)) != 0) break; /* of the first observation */
    assert_true(table->nrow < ROWS);
    *end = '\0';
    snprintf(table->name[table->nrow], sizeof table->name[0], "%s", at + 1);
    for (size_t c = 0; c < COLUMNS; c++) table->value[table->nrow][c] = strtod(end + 1, &end);
    table->nrow++;
  }
  free(text);
}

static const double *row_of(const struct table *table, const char *name)
{
  for (size_t r = 0; r < table->nrow; r++)
    if (strcmp(table->name[r], name) == 0) return table->value[r];
  fail_msg("no row of '%s'", name);
  return NULL;
}

/* Nine digits of each row are written. */
static void adds_up(const struct table *table, const char *const *names, size_t n, size_t column,
                    double expected)
{
  double sum = 0.0, gross = fabs(expected);
  for (size_t i = 0; i < n; i++) {
    sum += row_of(table, names[i])[column];
    gross += fabs(row_of(table, names[i])[column]);
  }
  if (!(fabs(sum - expected) <= 1e-8 * gross + 1e-12))
    fail_msg("%s...: column %zu adds up to %.9g W, expected %.9g W", names[0], column, sum,
             expected);
}

static const char *const groups[] = {"bus.+x", "bus.-x", "bus.+y", "bus.-y", "bus.+z", "bus.-z"};
static const char *const walls[] = {"bus.+x.wall", "bus.-x.wall", "bus.+y.wall",
                                    "bus.-y.wall", "bus.+z.wall", "bus.-z.wall"};

static void check(const char *inside, const char *const *owners, size_t nowner, const char *mesh)
{
  struct table table;
  struct heat_run run = heat_compute(LIST(inside, mesh), NONE, NONE);
  read_table(&run, &table);
  /* every group, its wall and its inner layer, and nothing else */
  assert_int_equal(table.nrow, nowner + 12 + (strstr(inside, "inside_emittance") ? 6 : 0));
  adds_up(&table, owners, nowner, 3, 20.0);
  adds_up(&table, owners, nowner, 4, 0.0);
  adds_up(&table, owners, nowner, 6, 0.0);
  assert_true(fabs(row_of(&table, "panel")[4]) > 1.0 && fabs(row_of(&table, "bus.wall")[6]) > 1.0);
  for (size_t c = 0; c < COLUMNS; c++) {
    adds_up(&table, groups, 6, c, row_of(&table, "bus")[c]);
    adds_up(&table, walls, 6, c, row_of(&table, "bus.wall")[c]);
  }
  for (size_t r = 0; r < table.nrow; r++) {
    double sum = 0.0, gross = 0.0;
    for (size_t c = 0; c < COLUMNS - 1; c++) {
      sum += table.value[r][c];
      gross += fabs(table.value[r][c]);
    }
    if (!(fabs(sum - table.value[r][COLUMNS - 1]) <= 1e-8 * gross + 1e-12))
      fail_msg("%s stores %.9g W, its flows are %.9g W", table.name[r], table.value[r][COLUMNS - 1],
               sum);
  }
  heat_release(&run);
}

static void rows_add_up_to_the_satellite(void **state)
{
  (void)state;
  static const char *const owners[] = {"panel", "bus", "bus.wall", "bus.interior"};
  check("parts.bus.interior.power_W=20", owners, 4, NULL);
}

/* A node on an edge belongs to its faces by area. */
static void nodes_between_groups_are_shared(void **state)
{
  (void)state;
  static const char *const owners[] = {"panel", "bus", "bus.wall", "bus.interior"};
  check("parts.bus.lumped=false", owners, 4, "parts.bus.facet_size_m=0.5");
}

static void interiors_have_rows(void **state)
{
  (void)state;
  static const char *const owners[] = {"panel",        "bus",       "bus.wall",
                                       "bus.interior", "bus.frame", "bus.boards"};
  check("parts.bus.interiors={frame: {capacity_J_K: 150, conductance_W_K: 2}, boards: "
        "{capacity_J_K: 0, conductance_W_K: 1}}",
        owners, 6, NULL);
}

/* Inner layers have a row of their own. */
static void insides_have_rows(void **state)
{
  (void)state;
  static const char *const owners[] = {"panel", "bus", "bus.wall", "bus.interior", "bus.inside"};
  check("parts.bus.inside_emittance=0.8", owners, 5,
        "parts.bus.shell.through_conductance_W_m2_K=30");
}

static int setup(void **state)
{
  (void)state;
  return heat_setup("output_heat_table.yaml");
}
static int teardown(void **state)
{
  (void)state;
  return heat_teardown();
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(rows_add_up_to_the_satellite),
                                     cmocka_unit_test(nodes_between_groups_are_shared),
                                     cmocka_unit_test(interiors_have_rows),
                                     cmocka_unit_test(insides_have_rows)};
  return cmocka_run_group_tests(tests, setup, teardown);
}
