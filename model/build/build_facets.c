/* thermal.facets: which facets are cut beyond their size, by a CSV of round, part, facets, facet.
 */
#include <string.h>

#include "base/core/csv.h"
#include "base/core/suggestions.h"
#include "model/build/messages_group.h"
#include "model/build/steps_impl.h"

#define ROUNDS_MAX 32
#define FACETS_MAX 4e6

struct reader {
  const struct um_core_csv *csv;
  size_t round, part, facets, facet; /* columns */
  uint32_t *number;                  /* [rows] facets of all rows, in order */
  struct um_geometry_halving *of;    /* [parts][ROUNDS_MAX] */
  struct um_geometry_halvings *parts;
};

static enum um_status whole(struct um_context *context, const struct um_core_csv *csv, size_t row,
                            size_t column, double low, double high, size_t *out)
{
  double value;
  UM_TRY(um_core_csv_number(context, csv, row, column, &value));
  if (!(value >= low && value <= high && value == (double)(size_t)value))
    return um_core_csv_fail(context, csv, row, column, "%g; accepted: a whole number, %g to %g",
                            value, low, high);
  *out = (size_t)value;
  return UM_OK;
}

static enum um_status part_named(struct um_context *context, const struct um_model *model,
                                 const struct reader *r, size_t row, size_t *out)
{
  const struct um_scenario_part *part = model->scenario->parts.items;
  const char *name = um_core_csv_text(r->csv, row, r->part);
  char names[512] = "";
  for (*out = 0; *out < model->scenario->parts.count; (*out)++) {
    if (strcmp(part[*out].name, name) == 0) return UM_OK;
    um_core_words_append(names, sizeof names, part[*out].name);
  }
  return um_core_csv_fail(context, r->csv, row, r->part, "'%.80s' is not a part; accepted: %s",
                          name, names);
}

/* Rows of a round of a part stand together, facets ascending; rounds of a part ascend from 1. */
static enum um_status row_read(struct um_context *context, const struct um_model *model,
                               struct reader *r, size_t row)
{
  size_t round = 0, part = 0, facets = 0, facet = 0;
  UM_TRY(part_named(context, model, r, row, &part));
  UM_TRY(whole(context, r->csv, row, r->round, 1.0, ROUNDS_MAX, &round));
  UM_TRY(whole(context, r->csv, row, r->facets, 1.0, FACETS_MAX, &facets));
  UM_TRY(whole(context, r->csv, row, r->facet, 0.0, (double)facets - 1.0, &facet));
  struct um_geometry_halvings *to = &r->parts[part];
  struct um_geometry_halving *of = &r->of[part * ROUNDS_MAX + round - 1];
  r->number[row] = (uint32_t)facet;
  if (to->nround == round && of->facet + of->nhalved == &r->number[row] && of->nfacet == facets &&
      of->facet[of->nhalved - 1] < facet) {
    of->nhalved++;
    return UM_OK;
  }
  if (round != to->nround + 1)
    return um_core_csv_fail(context, r->csv, row, r->round,
                            "facet %zu of round %zu of a part with %zu facets; accepted: rows of a "
                            "round together with one number of facets, facets ascending, rounds of "
                            "a part from 1",
                            facet, round, facets);
  *of = (struct um_geometry_halving){facets, &r->number[row], 1};
  to->round = &r->of[part * ROUNDS_MAX];
  to->nround = round;
  return UM_OK;
}

static enum um_status rows_read(struct um_context *context, struct um_model *model,
                                const struct um_core_csv *csv)
{
  struct reader r = {.csv = csv};
  size_t rows = um_core_csv_rows(csv), n = model->scenario->parts.count;
  UM_TRY(um_core_csv_require(context, csv, "round", &r.round));
  UM_TRY(um_core_csv_require(context, csv, "part", &r.part));
  UM_TRY(um_core_csv_require(context, csv, "facets", &r.facets));
  UM_TRY(um_core_csv_require(context, csv, "facet", &r.facet));
  UM_TRY(um_core_arena_allocate(context, &model->memory, rows, sizeof *r.number, &r.number));
  UM_TRY(um_core_arena_allocate(context, &model->memory, n * ROUNDS_MAX, sizeof *r.of, &r.of));
  UM_TRY(um_core_arena_allocate(context, &model->memory, n, sizeof *r.parts, &r.parts));
  for (size_t i = 0; i < rows; i++) UM_TRY(row_read(context, model, &r, i));
  model->halvings = r.parts;
  return UM_OK;
}

enum um_status um_model_build_facets(struct um_context *context, struct um_model *model)
{
  enum um_status status;
  const struct um_scenario_thermal *thermal = model->scenario->thermal;
  const char *path = NULL;
  struct um_core_csv *csv = NULL;
  if (thermal->facets == NULL || thermal->facets[0] == '\0') return UM_OK;
  UM_CHECK(um_model_resolve(context, model, &thermal->at, thermal->facets, &path));
  UM_CHECK(um_core_csv_read(context, path, &csv));
  UM_CHECK(rows_read(context, model, csv));
done:
  um_core_csv_destroy(&csv);
  return um_model_blame(context, &thermal->at, "facets", status);
}
