/* Measured BRDFs from a table. */
#include <string.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "materials/brdf_fit.h"

#define NONE ((size_t)-1)

static enum um_status read_angle(struct um_context *context, const struct um_core_csv *csv,
                                 size_t row, size_t column, double least, double most, double *out)
{
  double deg;
  UM_TRY(um_core_csv_number(context, csv, row, column, &deg));
  if (!(deg >= least && deg <= most))
    return um_core_csv_fail(context, csv, row, column, "%g; accepted: %g to %g [deg]", deg, least,
                            most);
  *out = deg * UM_DEG;
  return UM_OK;
}

static enum um_status surface_of(struct um_context *context, const char *name,
                                 struct um_materials_brdf *brdf, size_t *out)
{
  for (*out = 0; *out < brdf->nsurface; (*out)++)
    if (strcmp(brdf->surface[*out], name) == 0) return UM_OK;
  UM_TRY(um_core_reallocate(context, brdf->nsurface + 1, sizeof *brdf->surface, &brdf->surface));
  UM_TRY(um_core_strdup(context, name, &brdf->surface[brdf->nsurface]));
  brdf->nsurface++;
  return UM_OK;
}

static enum um_status read_row(struct um_context *context, const struct um_core_csv *csv,
                               const size_t column[5], size_t r, struct um_materials_brdf *brdf)
{
  struct um_materials_brdf_row *row = &brdf->row[r];
  UM_TRY(read_angle(context, csv, r, column[0], 0.0, 90.0, &row->incidence));
  UM_TRY(read_angle(context, csv, r, column[1], -90.0, 90.0, &row->scattering));
  UM_TRY(um_core_csv_number(context, csv, r, column[2], &row->brdf));
  if (!(row->brdf > 0.0))
    return um_core_csv_fail(context, csv, r, column[2], "%g; accepted: above 0 [1/sr]", row->brdf);
  if (column[3] != NONE)
    UM_TRY(read_angle(context, csv, r, column[3], -180.0, 180.0, &row->azimuth));
  const char *name = column[4] != NONE ? um_core_csv_text(csv, r, column[4]) : "surface";
  return surface_of(context, name, brdf, &row->surface);
}

enum um_status um_materials_brdf_read(struct um_context *context, const char *path,
                                      struct um_materials_brdf **out)
{
  static const char *const names[5] = {"incidence_deg", "scattering_deg", "brdf_1_sr",
                                       "azimuth_deg", "surface"};
  enum um_status status = UM_OK;
  struct um_core_csv *csv = NULL;
  struct um_materials_brdf *brdf = NULL;
  size_t column[5];
  *out = NULL;
  UM_CHECK(um_core_csv_read(context, path, &csv));
  for (size_t k = 0; k < 3; k++) UM_CHECK(um_core_csv_require(context, csv, names[k], &column[k]));
  for (size_t k = 3; k < 5; k++) column[k] = um_core_csv_find(csv, names[k]);
  UM_CHECK(um_core_allocate(context, 1, sizeof *brdf, &brdf));
  brdf->nrow = um_core_csv_rows(csv);
  if (brdf->nrow == 0) {
    status = um_core_fail(context, UM_ERR_INPUT, "%s: no rows; accepted: measured BRDFs", path);
    goto done;
  }
  UM_CHECK(um_core_allocate(context, brdf->nrow, sizeof *brdf->row, &brdf->row));
  for (size_t r = 0; r < brdf->nrow; r++) UM_CHECK(read_row(context, csv, column, r, brdf));
  *out = brdf;
  brdf = NULL;
done:
  um_core_csv_destroy(&csv);
  um_materials_brdf_destroy(context, &brdf);
  return status;
}

void um_materials_brdf_destroy(struct um_context *context, struct um_materials_brdf **brdf)
{
  if (brdf == NULL || *brdf == NULL) return;
  for (size_t k = 0; k < (*brdf)->nsurface; k++) um_core_free(context, (*brdf)->surface[k]);
  UM_FREE(context, (*brdf)->surface, (*brdf)->row, *brdf);
  *brdf = NULL;
}
