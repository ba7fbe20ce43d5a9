/* The named records of a run: the product's own folder, then the scenario's files. */
#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/data.h"
#include "core/words.h"
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
  um_core_free(context, (*library)->records);
  um_core_free(context, *library);
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

static int compare_names(const void *a, const void *b)
{
  const char *const *x = a, *const *y = b;
  return strcmp(*x, *y);
}

static void free_names(struct um_context *context, char **names, size_t count)
{
  for (size_t i = 0; i < count; i++) um_core_free(context, names[i]);
  um_core_free(context, names);
}

static bool is_yaml(const char *name)
{
  size_t n = strlen(name);
  return n > 5 && name[0] != '.' && strcmp(name + n - 5, ".yaml") == 0;
}

/* Names of the *.yaml files of a folder in the order of strcmp. */
static enum um_status list_folder(struct um_context *context, const char *folder, char ***out,
                                  size_t *count)
{
  enum um_status status = UM_OK;
  char **names = NULL;
  size_t n = 0;
  *out = NULL;
  *count = 0;
  DIR *directory = opendir(folder);
  if (directory == NULL)
    return um_core_fail(context, UM_ERR_IO, "%s: %s; accepted: a folder of material records",
                        folder, strerror(errno));
  for (struct dirent *entry = readdir(directory); entry != NULL; entry = readdir(directory)) {
    if (!is_yaml(entry->d_name)) continue;
    UM_CHECK(um_core_reallocate(context, n + 1, sizeof *names, &names));
    UM_CHECK(um_core_strdup(context, entry->d_name, &names[n]));
    n++;
  }
  if (n > 1) qsort(names, n, sizeof *names, compare_names);
  *out = names;
  *count = n;
  names = NULL;
done:
  closedir(directory);
  if (status != UM_OK) free_names(context, names, n);
  return status;
}

enum um_status um_materials_library_read_folder(struct um_context *context,
                                                struct um_materials_library *library,
                                                const char *folder)
{
  enum um_status status = UM_OK;
  char **names, *path = NULL;
  size_t count;
  UM_TRY(list_folder(context, folder, &names, &count));
  for (size_t i = 0; i < count; i++) {
    UM_CHECK(um_core_asprintf(context, &path, "%s/%s", folder, names[i]));
    UM_CHECK(um_materials_library_read_file(context, library, path, NULL, 0));
    um_core_free(context, path);
    path = NULL;
  }
done:
  um_core_free(context, path);
  free_names(context, names, count);
  return status;
}

enum um_status um_materials_library_folder(struct um_context *context, char **out)
{
  return um_core_data_folder(context, "materials", out);
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
