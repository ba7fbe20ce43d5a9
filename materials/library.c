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
  char **offered; /* [noffered] paths of files that were not read; NULL: it was */
  size_t noffered;
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
  um_core_listing_free(context, (*library)->offered, (*library)->noffered);
  UM_FREE(context, (*library)->records, *library);
  *library = NULL;
}

/* Takes the record; destroys it on failure. */
static enum um_status add(struct um_context *context, struct um_materials_library *library,
                          struct um_materials_record *record)
{
  enum um_status status =
      um_core_reallocate(context, library->count + 1, sizeof *library->records, &library->records);
  if (status != UM_OK) {
    um_materials_record_destroy(&record);
    return status;
  }
  library->records[library->count++] = record;
  return UM_OK;
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
  return add(context, library, record);
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

/* ---- on demand ---- */

enum um_status um_materials_library_offer_folder(struct um_context *context,
                                                 struct um_materials_library *library,
                                                 const char *folder)
{
  enum um_status status = UM_OK;
  char **names;
  size_t count, n = library->noffered;
  UM_TRY(um_core_listing(context, folder, ".yaml", "material records", &names, &count));
  UM_CHECK(um_core_reallocate(context, n + count, sizeof *library->offered, &library->offered));
  for (size_t i = 0; i < count; i++) {
    UM_CHECK(
        um_core_asprintf(context, &library->offered[library->noffered], "%s/%s", folder, names[i]));
    library->noffered++;
  }
done:
  um_core_listing_free(context, names, count);
  return status;
}

/* Is "folder/NAME.yaml" the file of that name? */
static bool is_file_of(const char *path, const char *name)
{
  const char *slash = strrchr(path, '/');
  const char *file = slash != NULL ? slash + 1 : path;
  size_t n = strlen(name);
  return strncmp(file, name, n) == 0 && strcmp(file + n, ".yaml") == 0;
}

/* Read one that was offered, unless the library has its name from elsewhere. */
static enum um_status take(struct um_context *context, struct um_materials_library *library,
                           size_t index)
{
  char *path = library->offered[index];
  struct um_materials_record *record = NULL;
  if (path == NULL) return UM_OK;
  enum um_status status = um_materials_record_read(context, &library->sun, path, NULL, 0, &record);
  library->offered[index] = NULL;
  um_core_free(context, path);
  if (status != UM_OK) return status;
  if (um_materials_library_find(library, record->name) == NULL)
    return add(context, library, record);
  um_materials_record_destroy(&record);
  return UM_OK;
}

enum um_status um_materials_library_want(struct um_context *context,
                                         struct um_materials_library *library, const char *name,
                                         const struct um_materials_record **out)
{
  *out = um_materials_library_find(library, name);
  for (size_t i = 0; i < library->noffered && *out == NULL; i++) {
    if (library->offered[i] == NULL || !is_file_of(library->offered[i], name)) continue;
    UM_TRY(take(context, library, i));
    *out = um_materials_library_find(library, name);
  }
  for (size_t i = 0; i < library->noffered && *out == NULL; i++) UM_TRY(take(context, library, i));
  if (*out == NULL) *out = um_materials_library_find(library, name);
  return UM_OK;
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
