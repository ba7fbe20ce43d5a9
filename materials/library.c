/* The named records of a run: the product's own folder, then the scenario's files. */
#include <stdio.h>
#include <string.h>

#include "base/core/data.h"
#include "base/core/listing.h"
#include "base/core/suggestions.h"
#include "materials/record_impl.h"

struct um_materials_library {
  struct um_context *context;
  struct um_materials_sun sun;
  struct um_materials_record **records; /* [count], in order of first appearance */
  size_t count;
};

enum um_status um_materials_library_create(struct um_context *context,
                                           const struct um_materials_sun *sun,
                                           struct um_materials_library **out)
{
  UM_TRY(um_core_allocate(context, 1, sizeof **out, out));
  (*out)->context = context;
  (*out)->sun = *sun;
  return UM_OK;
}

bool um_materials_library_is_of(const struct um_materials_library *library,
                                const struct um_materials_sun *sun)
{
  const struct um_materials_sun *own = &library->sun;
  bool same = own->measured == sun->measured;
  for (size_t i = 0; i < UM_MATERIALS_SUN && same; i++)
    same = own->wavelength[i] == sun->wavelength[i] && own->share[i] == sun->share[i];
  return same;
}

void um_materials_library_destroy(struct um_materials_library **library)
{
  if (library == NULL || *library == NULL) return;
  struct um_context *context = (*library)->context;
  for (size_t i = 0; i < (*library)->count; i++)
    um_materials_record_destroy(&(*library)->records[i]);
  UM_FREE(context, (*library)->records, *library);
  *library = NULL;
}

enum um_status um_materials_library_read_file(struct um_context *context,
                                              struct um_materials_library *library,
                                              const char *path, const char *const *overrides,
                                              size_t noverride)
{
  struct um_materials_record *record;
  UM_TRY(um_materials_record_read(context, &library->sun, path, overrides, noverride, &record));
  for (size_t i = 0; i < library->count; i++)
    if (strcmp(library->records[i]->name, record->name) == 0) {
      um_materials_record_destroy(&library->records[i]);
      library->records[i] = record;
      return UM_OK;
    }
  enum um_status status =
      um_core_reallocate(context, library->count + 1, sizeof *library->records, &library->records);
  if (status != UM_OK) {
    um_materials_record_destroy(&record);
    return status;
  }
  library->records[library->count++] = record;
  return UM_OK;
}

enum um_status um_materials_library_read_folder(struct um_context *context,
                                                struct um_materials_library *library,
                                                const char *folder)
{
  enum um_status status = UM_OK;
  char **names, *path = NULL;
  size_t count;
  UM_TRY(um_core_listing(context, folder, ".yaml", "material records", &names, &count));
  for (size_t i = 0; i < count; i++) {
    UM_CHECK(um_core_asprintf(context, &path, "%s/%s", folder, names[i]));
    UM_CHECK(um_materials_library_read_file(context, library, path, NULL, 0));
    um_core_free(context, path);
    path = NULL;
  }
done:
  um_core_free(context, path);
  um_core_listing_free(context, names, count);
  return status;
}

enum um_status um_materials_library_folder(struct um_context *context, char **out)
{
  return um_core_data_folder(context, "materials", out);
}

enum um_status um_materials_library_thickened(struct um_context *context,
                                              const struct um_materials_library *library,
                                              const struct um_materials_record *record,
                                              double factor, struct um_materials_record **out)
{
  return um_materials_record_thickened(context, &library->sun, record, factor, out);
}

size_t um_materials_library_count(const struct um_materials_library *library)
{
  return library->count;
}

const struct um_materials_record *
um_materials_library_at(const struct um_materials_library *library, size_t index)
{
  return library->records[index];
}

const struct um_materials_record *
um_materials_library_find(const struct um_materials_library *library, const char *name)
{
  for (size_t i = 0; i < library->count; i++)
    if (strcmp(library->records[i]->name, name) == 0) return library->records[i];
  return NULL;
}

void um_materials_library_suggest(const struct um_materials_library *library, const char *name,
                                  char *out, size_t size)
{
  char near[512] = "", all[512] = "";
  for (size_t i = 0; i < library->count; i++) {
    const char *known = library->records[i]->name;
    um_core_words_append(all, sizeof all, known);
    if (um_core_words_are_near(name, known) || strstr(known, name) != NULL)
      um_core_words_append(near, sizeof near, known);
  }
  if (near[0] != '\0')
    snprintf(out, size, "did you mean %s?", near);
  else
    snprintf(out, size, "accepted: %s", all);
}
