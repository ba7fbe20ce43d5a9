/* Reading of view factors; the format stands in the header. What was read keeps the laws that view
 * factors have whoever made them: none is negative, both ways are one number, the rows of a patch
 * add up to its area, and a room has no way out. */
#include "geometry/view_factor_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/csv.h"
#include "geometry/view_factor_file_impl.h"
#include "geometry/view_factors_impl.h"

#define CLOSABLE 0.05 /* error of a row that closure may mend [1] */

static const char *const key_says[4] = {"facets, groups or parts differ", "shapes or places differ",
                                        "angles of joints differ",
                                        "view_factor_rays or exchange_patches differ"};

enum column { RECORD, POSE, FROM, TO, VALUE, COLUMNS };

struct reader {
  struct um_context *context;
  const struct um_core_csv *csv;
  struct um_geometry_view_factor_set *set;
  size_t column[COLUMNS];
  size_t row, rows;
};

static const char *text_of(const struct reader *r, enum column column)
{
  return um_core_csv_text(r->csv, r->row, r->column[column]);
}

static bool is(const struct reader *r, const char *record)
{
  return r->row < r->rows && strcmp(text_of(r, RECORD), record) == 0;
}

static enum um_status refuse(const struct reader *r, enum column column, const char *accepted)
{
  size_t row = r->row < r->rows ? r->row : r->rows - 1;
  return um_core_csv_fail(r->context, r->csv, row, r->column[column], "'%s'; accepted: %s",
                          um_core_csv_text(r->csv, row, r->column[column]), accepted);
}

/* A whole number below `end`. */
static enum um_status index_of(const struct reader *r, enum column column, size_t end, size_t *out)
{
  double value = 0.0;
  UM_TRY(um_core_csv_number(r->context, r->csv, r->row, r->column[column], &value));
  if (!(value >= 0.0 && value < (double)end && value == floor(value)))
    return um_core_csv_fail(r->context, r->csv, r->row, r->column[column],
                            "%g; accepted: a whole number below %zu", value, end);
  *out = (size_t)value;
  return UM_OK;
}

/* 0 or more. */
static enum um_status number_of(const struct reader *r, double *out)
{
  UM_TRY(um_core_csv_number(r->context, r->csv, r->row, r->column[VALUE], out));
  if (*out >= 0.0) return UM_OK;
  return refuse(r, VALUE, "0 or more");
}

static enum um_status read_key(struct reader *r, bool own)
{
  uint64_t key[4];
  um_geometry_view_factor_key_values(&r->set->key, key);
  for (int k = 0; k < 4; k++, r->row++) {
    if (!is(r, um_geometry_view_factor_key_name[k]))
      return refuse(r, RECORD, um_geometry_view_factor_key_name[k]);
    char *end = NULL;
    uint64_t value = strtoull(text_of(r, VALUE), &end, 16);
    if (value == key[k] && *end == '\0') continue;
    if (k == 3 && !own) continue; /* whatever rays they were made with */
    return um_core_fail(r->context, UM_ERR_INPUT, "%s: made of another satellite: %s",
                        um_core_csv_name(r->csv), key_says[k]);
  }
  return UM_OK;
}

static enum um_status read_count(struct reader *r, const char *record, size_t end, size_t *out)
{
  if (!is(r, record)) return refuse(r, RECORD, record);
  UM_TRY(index_of(r, VALUE, end, out));
  r->row++;
  return UM_OK;
}

/* One number of a pose. */
static enum um_status read_number(struct reader *r, const char *record, size_t pose, double *out)
{
  size_t own = 0;
  if (!is(r, record)) return refuse(r, RECORD, record);
  UM_TRY(index_of(r, POSE, pose + 1, &own));
  if (own != pose) return refuse(r, POSE, "poses in their order");
  UM_TRY(number_of(r, out));
  r->row++;
  return UM_OK;
}

static enum um_status read_patches(struct reader *r, size_t npatch)
{
  struct um_context *context = r->context;
  const struct um_geometry_mesh *mesh = r->set->mesh;
  struct um_geometry_patches *patches = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *patches, &patches));
  r->set->patches = patches;
  patches->nsurface = mesh->nsurface;
  patches->npatch = npatch;
  UM_TRY(um_core_allocate(context, mesh->nsurface, sizeof *patches->patch, &patches->patch));
  memset(patches->patch, 0xff, mesh->nsurface * sizeof *patches->patch);
  UM_TRY(um_core_allocate(context, mesh->nsurface, sizeof(uint32_t), &patches->surface));
  UM_TRY(um_core_allocate(context, npatch + 1, sizeof(size_t), &patches->begin));
  UM_TRY(um_core_allocate(context, npatch, sizeof(double), &patches->area));
  size_t n = 0, last = 0;
  for (; is(r, "patch"); r->row++, n++) {
    size_t p = 0, s = 0;
    UM_TRY(index_of(r, FROM, npatch, &p));
    UM_TRY(index_of(r, TO, mesh->nsurface, &s));
    if (p != last && p != last + 1) return refuse(r, FROM, "patches in their order, none left out");
    if (n == 0 && p != 0) return refuse(r, FROM, "0, the first patch");
    if (patches->patch[s] != UM_GEOMETRY_NONE) return refuse(r, TO, "each surface once");
    last = p;
    patches->patch[s] = (uint32_t)p;
    patches->surface[n] = (uint32_t)s;
    patches->area[p] += mesh->area[mesh->surface[s].facet];
    patches->begin[p + 1] = n + 1;
  }
  if (npatch == 0 ? n == 0 : n > 0 && last + 1 == npatch) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "%s: surfaces of %zu patches; accepted: of all %zu",
                      um_core_csv_name(r->csv), n == 0 ? 0 : last + 1, npatch);
}

/* Exchange rows of a pose from here on, counted into the rows of both patches, or put there. */
static enum um_status read_areas(struct reader *r, size_t pose, struct um_geometry_view_factors *f,
                                 size_t *at)
{
  size_t from = r->row, p = 0, q = 0, before = 0, own = 0;
  bool first = true;
  for (size_t n = 0; n < f->npatch || is(r, "exchange"); r->row++) {
    if (r->row >= r->rows) return refuse(r, FROM, "more patches");
    UM_TRY(index_of(r, POSE, pose + 1, &own));
    if (own != pose) return refuse(r, POSE, "poses in their order");
    if (is(r, "space")) {
      UM_TRY(index_of(r, FROM, f->npatch, &p));
      if (p != n++) return refuse(r, FROM, "patches in their order, none left out");
      UM_TRY(number_of(r, &f->space[p]));
      if (r->set->closed && f->space[p] > 0.0) return refuse(r, VALUE, "0, it is inside");
      first = true;
      continue;
    }
    if (!is(r, "exchange") || n == 0) return refuse(r, RECORD, "space or exchange");
    double area;
    UM_TRY(index_of(r, FROM, f->npatch, &own));
    UM_TRY(index_of(r, TO, f->npatch, &q));
    UM_TRY(number_of(r, &area));
    if (own != p) return refuse(r, FROM, "the patch of the row of space above");
    if (q < p || (!first && q <= before))
      return refuse(r, TO, "patches ascending, from its own on");
    before = q;
    first = false;
    for (int way = 0; way < (q == p ? 1 : 2); way++) {
      size_t row = way == 0 ? p : q;
      if (f->other != NULL) {
        f->other[at[row]] = (uint32_t)(way == 0 ? q : p);
        f->area[at[row]] = area;
      }
      at[row]++;
    }
  }
  if (f->other == NULL) r->row = from; /* counted */
  return UM_OK;
}

/* Rows close, or nearly. */
static enum um_status close_rows(struct reader *r, bool own, struct um_geometry_view_factors *f)
{
  const struct um_geometry_patches *patches = r->set->patches;
  double worst = 0.0;
  size_t at = 0;
  for (size_t p = 0; p < f->npatch; p++) {
    double sum = f->space[p];
    for (size_t e = f->begin[p]; e < f->begin[p + 1]; e++) sum += f->area[e];
    double error = fabs(sum / patches->area[p] - 1.0);
    if (!(error <= worst)) {
      worst = error;
      at = p;
    }
  }
  if (worst <= UM_GEOMETRY_VIEW_FACTORS_CLOSED) return UM_OK;
  if (!own && worst <= CLOSABLE)
    return um_geometry_view_factors_close(r->context, f, patches->area);
  return um_core_fail(r->context, UM_ERR_INPUT,
                      "%s: exchange areas of patch %zu add up to its area but for a share of %.3g; "
                      "accepted: %g",
                      um_core_csv_name(r->csv), at, worst,
                      own ? UM_GEOMETRY_VIEW_FACTORS_CLOSED : CLOSABLE);
}

static enum um_status read_pose(struct reader *r, bool own, size_t pose)
{
  enum um_status status;
  struct um_context *context = r->context;
  struct um_geometry_view_factors *f = NULL;
  size_t n = r->set->patches->npatch, *at = NULL;
  double rays;
  UM_CHECK(um_core_allocate(context, 1, sizeof *f, &f));
  r->set->pose[pose] = f;
  f->npatch = n;
  UM_CHECK(read_number(r, "rays", pose, &rays));
  f->rays = rays < 1e18 ? (size_t)rays : 0;
  UM_CHECK(read_number(r, "cut", pose, &f->cut));
  UM_CHECK(read_number(r, "unclosed", pose, &f->unclosed));
  UM_CHECK(read_number(r, "residual", pose, &f->residual));
  UM_CHECK(um_core_allocate(context, n, sizeof(double), &f->space));
  UM_CHECK(um_core_allocate(context, n + 1, sizeof *at, &at));
  UM_CHECK(read_areas(r, pose, f, at));
  UM_CHECK(um_core_allocate(context, n + 1, sizeof(size_t), &f->begin));
  for (size_t p = 0; p < n; p++) {
    f->begin[p + 1] = f->begin[p] + at[p];
    at[p] = f->begin[p];
  }
  UM_CHECK(um_core_allocate(context, f->begin[n], sizeof(uint32_t), &f->other));
  UM_CHECK(um_core_allocate(context, f->begin[n], sizeof(double), &f->area));
  UM_CHECK(read_areas(r, pose, f, at));
  status = close_rows(r, own, f);
done:
  um_core_free(context, at);
  return status;
}

static enum um_status read_all(struct reader *r, bool own)
{
  static const char *const name[COLUMNS] = {"record", "pose", "from", "to", "value"};
  size_t npatch = 0, npose = 0;
  for (int c = 0; c < COLUMNS; c++)
    UM_TRY(um_core_csv_require(r->context, r->csv, name[c], &r->column[c]));
  r->rows = um_core_csv_rows(r->csv);
  if (r->rows == 0)
    return um_core_fail(r->context, UM_ERR_INPUT, "%s: no rows", um_core_csv_name(r->csv));
  UM_TRY(read_key(r, own));
  UM_TRY(read_count(r, "patches", UM_GEOMETRY_PATCHES_MAX + 1, &npatch));
  UM_TRY(read_count(r, "poses", r->set->npose + 1, &npose));
  if (npose != r->set->npose)
    return um_core_fail(r->context, UM_ERR_INPUT, "%s: %zu poses; accepted: %zu",
                        um_core_csv_name(r->csv), npose, r->set->npose);
  UM_TRY(read_number(r, "interpolation", 0, &r->set->interpolation));
  UM_TRY(read_patches(r, npatch));
  for (size_t k = 0; k < npose; k++) {
    UM_TRY(um_core_stop_check(r->context, "view factors were read"));
    UM_TRY(read_pose(r, own, k));
  }
  return r->row == r->rows ? UM_OK : refuse(r, RECORD, "the end of the file");
}

/* What the table says, whole or not at all. */
static enum um_status take(struct um_context *context, const struct um_core_csv *csv, bool own,
                           struct um_geometry_view_factor_set *set)
{
  struct reader r = {.context = context, .csv = csv, .set = set};
  enum um_status status = read_all(&r, own);
  if (status == UM_OK) return UM_OK;
  for (size_t k = 0; k < set->npose; k++) um_geometry_view_factors_destroy(context, &set->pose[k]);
  um_geometry_patches_destroy(context, &set->patches);
  return status;
}

enum um_status um_geometry_view_factor_file_read(struct um_context *context, const char *path,
                                                 bool own, struct um_geometry_view_factor_set *set)
{
  struct um_core_csv *csv = NULL;
  UM_TRY(um_core_csv_read(context, path, &csv));
  enum um_status status = take(context, csv, own, set);
  um_core_csv_destroy(&csv);
  return status;
}

enum um_status um_geometry_view_factor_file_parse(struct um_context *context, const char *path,
                                                  const char *text, size_t length,
                                                  struct um_geometry_view_factor_set *set)
{
  struct um_core_csv *csv = NULL;
  UM_TRY(um_core_csv_parse(context, path, text, length, &csv));
  enum um_status status = take(context, csv, true, set);
  um_core_csv_destroy(&csv);
  return status;
}
