/* Records of the materials that a thermal model brings. */
#include <ctype.h>
#include <string.h>

#include "app/new.h"
#include "geometry/step_tas.h"

#define MIRROR 0.01 /* roughness of what is called specular [1] */

void um_app_new_materials_clear(struct um_context *context, struct um_app_new_materials *materials)
{
  for (size_t i = 0; i < materials->n; i++)
    UM_FREE(context, materials->name[i], materials->file[i], materials->stands[i]);
  UM_FREE(context, (void *)materials->name, (void *)materials->file, (void *)materials->stands);
  *materials = (struct um_app_new_materials){0};
}

static bool is_among(char *const *name, size_t n, const char *wanted)
{
  for (size_t i = 0; i < n; i++)
    if (strcmp(name[i], wanted) == 0) return true;
  return false;
}

/* Letters, digits and '_' of a name, as records are called; a number where another has it. */
static enum um_status name_record(struct um_context *context, const char *stands,
                                  char *const *record, size_t nrecord,
                                  const struct um_app_new_materials *own, char **out)
{
  char plain[80];
  snprintf(plain, sizeof plain, "%.60s", stands);
  for (char *c = plain; *c != '\0'; c++)
    if (isalnum((unsigned char)*c) == 0) *c = '_';
  bool taken = is_among(record, nrecord, plain) || is_among(own->name, own->n, plain);
  return taken ? um_core_asprintf(context, out, "%s_%zu", plain, own->n + 1)
               : um_core_strdup(context, plain, out);
}

static void put_record(FILE *file, const char *name, const char *from,
                       const struct um_geometry_step_tas_optical *o)
{
  double reflected = 1.0 - o->solar_absorptance - o->solar_transmittance;
  double specular = reflected > 0.0 ? reflected * o->solar_specularity : 0.0;
  fprintf(file,
          "name: \"%s\"\nsummary: >-\n  \"%s\" of a thermal model.\ncitation: >-\n  \"%s\", its "
          "first environment.\n",
          name, o->name, from);
  if (o->solar_transmittance > 0.0 || o->infrared_transmittance > 0.0)
    fprintf(file, "# lets %g of sunlight and %g of heat through, which is not followed\n",
            o->solar_transmittance, o->infrared_transmittance);
  fprintf(file, "grey:\n  solar_absorptance: %.9g\n  emittance: %.9g\n", o->solar_absorptance,
          o->emittance);
  if (specular > 0.0 || o->solar_transmittance > 0.0)
    fprintf(file, "  vis_reflectance_diffuse: %.9g\n",
            reflected > specular ? reflected - specular : 0.0);
  if (specular > 0.0)
    fprintf(file, "  specular_reflectance: %.9g\n  beckmann_alpha: %g\n", specular, MIRROR);
  if (o->solar_transmittance > 0.0)
    fprintf(file, "  balance_tolerance: %.9g\n",
            o->solar_transmittance < 0.99 ? o->solar_transmittance + 0.01 : 1.0);
}

static enum um_status put_material(struct um_context *context, struct um_core_folder *folder,
                                   const char *from, const struct um_geometry_step_tas_optical *o,
                                   char *const *record, size_t nrecord,
                                   struct um_app_new_materials *out)
{
  char *name = NULL, *file = NULL, *stands = NULL;
  FILE *stream = NULL;
  enum um_status status;
  UM_CHECK(name_record(context, o->name, record, nrecord, out, &name));
  UM_CHECK(um_core_asprintf(context, &file, "material_%s.yaml", name));
  UM_CHECK(um_core_strdup(context, o->name, &stands));
  UM_CHECK(um_core_reallocate(context, out->n + 1, sizeof *out->name, &out->name));
  UM_CHECK(um_core_reallocate(context, out->n + 1, sizeof *out->file, &out->file));
  UM_CHECK(um_core_reallocate(context, out->n + 1, sizeof *out->stands, &out->stands));
  UM_CHECK(um_core_folder_open(context, folder, file, &stream));
  put_record(stream, name, from, o);
  UM_CHECK(um_core_file_close(context, file, &stream));
  out->name[out->n] = name;
  out->stands[out->n] = stands;
  out->file[out->n++] = file;
  return UM_OK;
done:
  UM_FREE(context, name, file, stands);
  return status;
}

enum um_status um_app_new_materials(struct um_context *context, struct um_core_folder *folder,
                                    const char *path, const char *from, char *const *record,
                                    size_t nrecord, struct um_app_new_materials *out)
{
  struct um_geometry_step_tas_optical *optical = NULL;
  size_t n = 0;
  *out = (struct um_app_new_materials){0};
  enum um_status status = um_geometry_step_tas_materials(context, path, &optical, &n, &out->metres);
  for (size_t i = 0; i < n && status == UM_OK; i++)
    if (!is_among(record, nrecord, optical[i].name) &&
        !is_among(out->stands, out->n, optical[i].name))
      status = put_material(context, folder, from, &optical[i], record, nrecord, out);
  um_core_free(context, optical);
  if (status != UM_OK) um_app_new_materials_clear(context, out);
  return status;
}
