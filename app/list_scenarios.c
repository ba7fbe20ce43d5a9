/* umbra list scenarios: those that come with the program, and where they lie. */
#include <string.h>
#include <sys/stat.h>

#include "app/app.h"
#include "base/core/data.h"
#include "base/core/listing.h"
#include "base/core/suggestions.h"
#include "model/scenario/scenario_read.h"

/* Names of scenarios, "cube", "hidden-effect/dawn", in the order of strcmp. */
struct shipped {
  char *folder; /* that holds them */
  char **name;
  size_t count;
};

static enum um_status add(struct um_context *context, struct shipped *s, const char *name,
                          bool *is_one)
{
  struct stat info;
  char *file;
  UM_TRY(um_core_asprintf(context, &file, "%s/%s/scenario.yaml", s->folder, name));
  *is_one = stat(file, &info) == 0;
  um_core_free(context, file);
  if (!*is_one) return UM_OK;
  UM_TRY(um_core_reallocate(context, s->count + 1, sizeof *s->name, &s->name));
  UM_TRY(um_core_strdup(context, name, &s->name[s->count]));
  s->count++;
  return UM_OK;
}

/* Scenarios one folder further down. */
static enum um_status add_below(struct um_context *context, struct shipped *s, const char *name)
{
  enum um_status status;
  struct stat info;
  char *folder = NULL, **entry = NULL;
  size_t n = 0;
  bool is_one;
  UM_CHECK(um_core_asprintf(context, &folder, "%s/%s", s->folder, name));
  if (stat(folder, &info) != 0 || !S_ISDIR(info.st_mode)) goto done;
  UM_CHECK(um_core_listing(context, folder, "", "scenarios", &entry, &n));
  for (size_t i = 0; i < n; i++) {
    char *below;
    UM_CHECK(um_core_asprintf(context, &below, "%s/%s", name, entry[i]));
    status = add(context, s, below, &is_one);
    um_core_free(context, below);
    UM_CHECK(status);
  }
done:
  um_core_listing_free(context, entry, n);
  um_core_free(context, folder);
  return status;
}

static void shipped_release(struct um_context *context, struct shipped *s)
{
  um_core_listing_free(context, s->name, s->count);
  um_core_free(context, s->folder);
}

static enum um_status shipped_find(struct um_context *context, struct shipped *s)
{
  enum um_status status;
  char **entry = NULL;
  size_t n = 0;
  bool is_one;
  *s = (struct shipped){.count = 0};
  UM_CHECK(um_core_data_folder(context, "scenarios", &s->folder));
  UM_CHECK(um_core_listing(context, s->folder, "", "scenarios", &entry, &n));
  for (size_t i = 0; i < n; i++) {
    UM_CHECK(add(context, s, entry[i], &is_one));
    if (!is_one) UM_CHECK(add_below(context, s, entry[i]));
  }
done:
  um_core_listing_free(context, entry, n);
  return status;
}

void um_app_scenarios_put(struct um_context *context, FILE *file)
{
  struct shipped s;
  if (shipped_find(context, &s) == UM_OK)
    for (size_t i = 0; i < s.count; i++) fprintf(file, "%s%s", i > 0 ? " " : "", s.name[i]);
  shipped_release(context, &s);
}

/* "cube            what it is"; the page of one says where it lies, too. */
static enum um_status print_row(struct um_context *context, const struct shipped *s, size_t i,
                                bool json, bool page)
{
  enum um_status status;
  char *path = NULL;
  struct um_document *document = NULL;
  const struct um_scenario *scenario;
  UM_CHECK(um_core_asprintf(context, &path, "%s/%s", s->folder, s->name[i]));
  UM_CHECK(um_model_scenario_read(context, path, NULL, NULL, 0, NULL, 0, &document, &scenario));
  const char *summary = scenario->summary != NULL ? scenario->summary : "";
  if (json) {
    um_core_json_text(stdout, "{", "name", s->name[i]);
    um_core_json_text(stdout, ", ", "summary", summary);
    um_core_json_text(stdout, ", ", "folder", path);
    printf("}");
  } else if (page) {
    printf("%s: %s\n  folder: %s\n  look at it: umbra check %s\n  compute it: umbra run %s\n",
           s->name[i], summary, path, path, path);
  } else {
    printf("%-20s%s\n", s->name[i], summary);
  }
done:
  um_document_destroy(&document);
  um_core_free(context, path);
  return status;
}

static enum um_status print_one(struct um_context *context, const struct shipped *s,
                                const char *name, bool json)
{
  struct um_core_words_guess guess = {.written = name};
  char hint[UM_CORE_WORDS_HINT], accepted[1024] = "";
  for (size_t i = 0; i < s->count; i++) {
    if (strcmp(s->name[i], name) == 0) {
      UM_TRY(print_row(context, s, i, json, true));
      if (json) printf("\n");
      return UM_OK;
    }
    um_core_words_consider(&guess, s->name[i]);
    um_core_words_append(accepted, sizeof accepted, s->name[i]);
  }
  return um_core_fail(context, UM_ERR_INPUT,
                      "no scenario '%s' comes with the program%s; accepted: %s", name,
                      um_core_words_hint(&guess, hint), accepted);
}

static enum um_status print_all(struct um_context *context, const struct shipped *s, bool json)
{
  if (json) puts("[");
  for (size_t i = 0; i < s->count; i++) {
    if (json) printf("  ");
    UM_TRY(print_row(context, s, i, json, false));
    if (json) puts(i + 1 < s->count ? "," : "");
  }
  if (json)
    puts("]");
  else
    printf("They lie in %s; umbra run %s/NAME computes one.\n", s->folder, s->folder);
  return UM_OK;
}

int um_app_scenarios(struct um_context *context, const struct um_app_options *options)
{
  struct shipped s;
  enum um_status status = shipped_find(context, &s);
  if (status == UM_OK && options->npositional == 1)
    status = print_one(context, &s, options->positional[0], options->json);
  else if (status == UM_OK)
    status = print_all(context, &s, options->json);
  shipped_release(context, &s);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
