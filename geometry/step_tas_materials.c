/* Optical properties of STEP-TAS, by ESA STEP-TAS 6.0, tas_arm, as pycanha's reader takes it.
 *
 * Attributes (from 0) of the model: 15 its materials, 17 of each environment, of each material the
 * quantities: 0 solar absorptance, 1 2 direct and diffuse transmittance, 3 specularity (4 index),
 * 5 to 8 the same of infrared, emittance first. A quantity has its number in a list, attribute 1.
 */
#include "geometry/step_tas.h"

#include <string.h>

#include "base/core/file.h"
#include "geometry/foreign_mesh_impl.h"
#include "geometry/step_tas_impl.h"

#define MODEL      "MGM_MESHED_GEOMETRIC_MODEL"
#define MATERIALS  15
#define PROPERTIES 17
#define QUANTITIES 9
#define BYTES_MAX  ((size_t)1 << 30)

static bool is_wanted(struct um_geometry_part21_text name)
{
  return um_geometry_part21_is(name, MODEL) || um_geometry_part21_is(name, "NRF_MATERIAL") ||
         um_geometry_part21_is(name, "NRF_REAL_QUANTITY_VALUE_LITERAL");
}

/* The share that value `at` of a row refers to. */
static enum um_status read_share(const struct um_geometry_tas *t, um_geometry_tas_item material,
                                 um_geometry_tas_item model, uint32_t at, double *out)
{
  um_geometry_tas_item quantity;
  uint32_t next, end;
  UM_TRY(um_geometry_tas_listed(t, model, at, &quantity));
  UM_TRY(um_geometry_tas_list(t, quantity, 1, &next, &end));
  um_geometry_tas_value v = &t->file.value[next];
  if (next >= end || v->kind != UM_PART21_NUMBER || !(v->number >= 0.0 && v->number <= 1.0))
    return um_geometry_tas_fail(t, material, "its optical properties; accepted: shares, 0 to 1");
  *out = v->number;
  return UM_OK;
}

/* A row of quantities; of one that is shorter, what it has not is 0. */
static enum um_status read_row(const struct um_geometry_tas *t, um_geometry_tas_item material,
                               um_geometry_tas_item model, uint32_t row,
                               struct um_geometry_step_tas_optical *out)
{
  double q[QUANTITIES] = {0.0};
  uint32_t at = row + 1, end = t->file.value[row].end;
  if (t->file.value[row].kind != UM_PART21_LIST)
    return um_geometry_tas_fail(t, material, "accepted: a list of its properties");
  for (int i = 0; i < QUANTITIES && at < end; i++, at = t->file.value[at].end)
    if (i != 4) UM_TRY(read_share(t, material, model, at, &q[i]));
  *out = (struct um_geometry_step_tas_optical){.solar_absorptance = q[0],
                                               .solar_transmittance = q[1] + q[2],
                                               .solar_specularity = q[3],
                                               .emittance = q[5],
                                               .infrared_transmittance = q[6] + q[7],
                                               .infrared_specularity = q[8]};
  if (!(q[0] + q[1] + q[2] <= 1.0 + 1e-9 && q[5] + q[6] + q[7] <= 1.0 + 1e-9))
    return um_geometry_tas_fail(t, material,
                                "absorbs and lets through more than arrives; accepted: at most 1 "
                                "together");
  um_geometry_tas_text(t, material, 0, out->name);
  return UM_OK;
}

/* Rows of the first environment, one a material. */
static enum um_status read_model(const struct um_geometry_tas *t, um_geometry_tas_item model,
                                 struct um_geometry_step_tas_optical **out, size_t *n)
{
  uint32_t next, end, environment, last;
  if (um_geometry_tas_attribute(t, model, MATERIALS) == NULL ||
      um_geometry_tas_attribute(t, model, PROPERTIES) == NULL)
    return UM_OK;
  UM_TRY(um_geometry_tas_list(t, model, MATERIALS, &next, &end));
  UM_TRY(um_geometry_tas_list(t, model, PROPERTIES, &environment, &last));
  if (next >= end || environment >= last) return UM_OK;
  uint32_t row = environment + 1, rows = t->file.value[environment].end;
  for (; next < end && row < rows; next = t->file.value[next].end, row = t->file.value[row].end) {
    um_geometry_tas_item material;
    struct um_geometry_step_tas_optical optical;
    UM_TRY(um_geometry_tas_listed(t, model, next, &material));
    UM_TRY(read_row(t, material, model, row, &optical));
    if (optical.name[0] == '\0' ||
        !(optical.solar_absorptance + optical.solar_transmittance + optical.emittance +
              optical.infrared_transmittance + optical.solar_specularity >
          0.0))
      continue;
    UM_TRY(um_core_reallocate(t->context, *n + 1, sizeof **out, out));
    (*out)[(*n)++] = optical;
  }
  return UM_OK;
}

enum um_status um_geometry_step_tas_materials(struct um_context *context, const char *path,
                                              struct um_geometry_step_tas_optical **out, size_t *n,
                                              bool *is)
{
  enum um_status status;
  char *text = NULL;
  size_t length;
  struct um_geometry_tas t = {.context = context, .path = path};
  *out = NULL;
  *n = 0;
  *is = false;
  UM_CHECK(um_core_file_read(context, path, BYTES_MAX, &text, &length));
  *is = um_geometry_step_tas_is(text, length);
  if (!*is) goto done;
  UM_CHECK(um_geometry_part21_read(context, path, text, length, is_wanted, &t.file));
  for (size_t i = 0; i < t.file.ninstance; i++)
    if (um_geometry_part21_is(t.file.instance[i].name, MODEL))
      UM_CHECK(read_model(&t, &t.file.instance[i], out, n));
done:
  um_geometry_part21_clear(context, &t.file);
  um_core_free(context, text);
  if (status != UM_OK) {
    um_core_free(context, *out);
    *out = NULL;
    *n = 0;
  }
  return status;
}
