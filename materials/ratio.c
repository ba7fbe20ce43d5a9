/* From reflectance relative to a reference mirror to absolute reflectance: what the Flying Laptop
 * light-curve paper does with its gold standard, which absorbs below 0.6 um. */
#include "materials/ratio.h"

#include <math.h>

#include "base/core/csv.h"

static enum um_status read_row(struct um_context *context, const struct um_core_csv *csv,
                               const size_t column[2], size_t row,
                               const struct um_materials_record *reference, double cosine,
                               struct um_materials_measured_reflectance *out)
{
  double um, ratio, from, to;
  UM_TRY(um_core_csv_number(context, csv, row, column[0], &um));
  UM_TRY(um_core_csv_number(context, csv, row, column[1], &ratio));
  um_materials_constants_range(reference, &from, &to);
  if (!(um * 1e-6 >= from * (1.0 - 1e-9) && um * 1e-6 <= to * (1.0 + 1e-9)))
    return um_core_csv_fail(context, csv, row, column[0],
                            "%g; accepted: %g to %g [um], where %s has optical constants", um,
                            from * 1e6, to * 1e6, um_materials_name(reference));
  if (row > 0 && !(um * 1e-6 > out->wavelength[row - 1]))
    return um_core_csv_fail(context, csv, row, column[0],
                            "%g follows %g [um]; accepted: ascending values", um,
                            out->wavelength[row - 1] * 1e6);
  if (!(ratio >= 0.0))
    return um_core_csv_fail(context, csv, row, column[1], "%g; accepted: 0 or more", ratio);
  double r = ratio * um_materials_interface_reflectance(reference, um * 1e-6, cosine);
  if (r > 1.0) {
    out->nabove++;
    if (r > out->largest) {
      out->largest = r;
      out->largest_at = um * 1e-6;
    }
  }
  out->wavelength[row] = um * 1e-6;
  out->reflectance[row] = fmin(r, 1.0);
  return UM_OK;
}

static enum um_status read_rows(struct um_context *context, const struct um_core_csv *csv,
                                const struct um_materials_record *reference, double cosine,
                                struct um_materials_measured_reflectance *out)
{
  size_t column[2];
  UM_TRY(um_core_csv_require(context, csv, "wavelength_um", &column[0]));
  UM_TRY(um_core_csv_require(context, csv, "ratio", &column[1]));
  out->n = um_core_csv_rows(csv);
  if (out->n < 2)
    return um_core_fail(context, UM_ERR_INPUT, "%s: %zu rows; accepted: at least 2 wavelengths",
                        um_core_csv_name(csv), out->n);
  UM_TRY(um_core_allocate(context, out->n, sizeof(double), &out->wavelength));
  UM_TRY(um_core_allocate(context, out->n, sizeof(double), &out->reflectance));
  for (size_t row = 0; row < out->n; row++)
    UM_TRY(read_row(context, csv, column, row, reference, cosine, out));
  return UM_OK;
}

enum um_status um_materials_ratio_read(struct um_context *context, const char *path,
                                       const struct um_materials_record *reference, double cosine,
                                       struct um_materials_measured_reflectance *out)
{
  double from, to;
  struct um_core_csv *csv;
  *out = (struct um_materials_measured_reflectance){0};
  um_materials_constants_range(reference, &from, &to);
  if (isnan(from))
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s has no optical constants; accepted as a reference: a record with a "
                        "substrate, such as gold",
                        um_materials_name(reference));
  UM_TRY(um_core_csv_read(context, path, &csv));
  enum um_status status = read_rows(context, csv, reference, cosine, out);
  um_core_csv_destroy(&csv);
  if (status != UM_OK) um_materials_ratio_free(context, out);
  return status;
}

void um_materials_ratio_free(struct um_context *context,
                             struct um_materials_measured_reflectance *measured)
{
  UM_FREE(context, measured->wavelength, measured->reflectance);
  *measured = (struct um_materials_measured_reflectance){0};
}
