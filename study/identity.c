/* The list of what points are made of: "digest kind name", a line each. Its digests in their order
 * are the identity; its names are for people. */
#include "study/identity.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/batch/records.h"
#include "base/core/data.h"
#include "base/core/digest.h"
#include "base/core/file.h"
#include "base/core/file_snapshot.h"
#include "base/core/listing.h"
#include "base/core/text.h"
#include "model/scenario/scenario.h"

#define LIST  "made-of.txt"
#define LINE  4608 /* longest line, names cut to it [byte] */
#define LARGE ((size_t)1 << 30)

struct um_study_identity {
  char *text; /* lines, each ended */
  uint64_t digest;
  size_t nline;
};

/* Paths as every working folder has them. */
static void whole_name(const char *name, char out[LINE])
{
  char *whole = realpath(name, NULL);
  snprintf(out, LINE, "%.4000s", whole != NULL ? whole : name);
  free(whole);
  um_core_text_make_line(out);
}

static enum um_status add(struct um_context *context, struct um_study_identity *identity,
                          const char *kind, const char *name, uint64_t digest)
{
  char *more;
  UM_TRY(um_core_asprintf(context, &more, "%s%016" PRIx64 " %s %s\n", identity->text, digest, kind,
                          name));
  um_core_free(context, identity->text);
  identity->text = more;
  identity->digest = um_core_digest(identity->digest, &digest, sizeof digest);
  identity->nline++;
  return UM_OK;
}

enum um_status um_study_identity_add(struct um_context *context, struct um_study_identity *identity,
                                     const char *name, uint64_t digest)
{
  return add(context, identity, "asked", name, digest);
}

/* --- the program and files ------------------------------------------------------------------- */

static enum um_status add_program(struct um_context *context, struct um_study_identity *identity,
                                  const char *version)
{
  uint64_t digest;
  char *file;
  UM_TRY(um_core_data_program(context, &file));
  enum um_status status = um_core_file_digest(context, file, &digest);
  um_core_free(context, file);
  UM_TRY(status);
  if (version != NULL) digest = um_core_digest_texts(digest, &version, 1);
  return add(context, identity, "program", "umbra", digest);
}

struct adding {
  struct um_context *context;
  struct um_study_identity *identity;
  enum um_status status;
};

static void add_file(void *self, const char *path, uint64_t digest)
{
  struct adding *a = self;
  char name[LINE];
  whole_name(path, name);
  if (a->status == UM_OK) a->status = add(a->context, a->identity, "file", name, digest);
}

/* View factors that the scenario gives are read when they are wanted, not when a model is made:
 * here they join what is held. A folder that is not there is refused by who wants it. */
static enum um_status hold_view_factors(struct um_context *context, const struct um_model *model)
{
  const struct um_scenario_thermal *thermal = model->scenario->thermal;
  enum um_status status;
  char *folder = NULL, *path = NULL, *text = NULL, **names = NULL;
  size_t n = 0, length;
  if (thermal->view_factors == NULL) return UM_OK;
  UM_CHECK(um_core_path_resolve(context, thermal->at.file, thermal->view_factors, &folder));
  if (access(folder, R_OK) == 0)
    UM_CHECK(um_core_listing(context, folder, ".csv", "view factors", &names, &n));
  for (size_t i = 0; i < n; i++) {
    UM_CHECK(um_core_asprintf(context, &path, "%s/%s", folder, names[i]));
    UM_CHECK(um_core_file_read(context, path, LARGE, &text, &length));
    UM_FREE(context, text, path);
    path = NULL;
  }
done:
  um_core_listing_free(context, names, n);
  UM_FREE(context, path, folder);
  return status;
}

static enum um_status add_options(struct um_context *context, struct um_study_identity *identity,
                                  const struct um_model_options *o)
{
  uint64_t set = um_core_digest_texts(UM_CORE_DIGEST_BEGIN, o->overrides, o->noverride);
  uint64_t effects = um_core_digest_texts(UM_CORE_DIGEST_BEGIN, o->with, o->nwith);
  effects = um_core_digest_texts(effects, o->without, o->nwithout);
  UM_TRY(um_study_identity_add(context, identity, "the changes by --set", set));
  return um_study_identity_add(context, identity, "the effects of --with and --without", effects);
}

enum um_status um_study_identity_create(struct um_context *context, const char *version,
                                        const struct um_model *model,
                                        const struct um_model_options *options,
                                        struct um_study_identity **out)
{
  enum um_status status;
  struct um_study_identity *identity;
  *out = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *identity, &identity));
  struct adding adding = {context, identity, UM_OK};
  identity->digest = UM_CORE_DIGEST_BEGIN;
  UM_CHECK(um_core_strdup(context, "", &identity->text));
  UM_CHECK(add_program(context, identity, version));
  UM_CHECK(hold_view_factors(context, model));
  um_core_snapshot_each(context, add_file, &adding);
  UM_CHECK(adding.status);
  UM_CHECK(add_options(context, identity, options));
  *out = identity;
  identity = NULL;
done:
  um_study_identity_destroy(context, &identity);
  return status;
}

void um_study_identity_destroy(struct um_context *context, struct um_study_identity **identity)
{
  if (identity == NULL || *identity == NULL) return;
  UM_FREE(context, (*identity)->text, *identity);
  *identity = NULL;
}

/* --- what has changed ------------------------------------------------------------------------ */

/* A line of a list: its parts, and where the next one begins. */
struct line {
  char digest[20], kind[12], name[LINE];
};

static bool next_line(const char **at, struct line *line)
{
  size_t n = strcspn(*at, "\n");
  int used = 0;
  char text[LINE + 64];
  if (**at == '\0') return false;
  snprintf(text, sizeof text, "%.*s", (int)(n < LINE ? n : LINE), *at);
  line->digest[0] = line->kind[0] = line->name[0] = '\0';
  if (sscanf(text, "%16s %11s %n", line->digest, line->kind, &used) == 2 && used > 0)
    snprintf(line->name, sizeof line->name, "%s", text + used);
  *at += n + ((*at)[n] == '\n' ? 1 : 0);
  return true;
}

static const char *last_part(const char *path)
{
  const char *slash = strrchr(path, '/');
  return slash == NULL ? path : slash + 1;
}

/* The line of the same thing; on another machine a file may stand elsewhere. */
static bool find_line(const char *text, const struct line *like, bool elsewhere, struct line *out)
{
  while (next_line(&text, out))
    if (strcmp(out->kind, like->kind) == 0 &&
        (strcmp(out->name, like->name) == 0 ||
         (elsewhere && strcmp(last_part(out->name), last_part(like->name)) == 0)))
      return true;
  return false;
}

/* The first line of `text` that `other` has otherwise, or not at all; of files alone where asked.
 */
static bool find_change(const char *text, const char *other, bool files, struct line *line,
                        bool *missing)
{
  struct line like;
  while (next_line(&text, line)) {
    if (files && strcmp(line->kind, "file") != 0) continue;
    *missing = !find_line(other, line, false, &like) && !find_line(other, line, true, &like);
    if (*missing || strcmp(line->digest, like.digest) != 0) return true;
  }
  return false;
}

/* What is not as the list says, in words. */
static void describe_change(const char *was, const char *is, char *out, size_t size)
{
  struct line line;
  bool missing;
  const char *what = "has other bytes than when this was computed";
  if (find_change(is, was, false, &line, &missing)) {
    if (strcmp(line.kind, "program") == 0)
      snprintf(out, size, "the program %s", what);
    else if (strcmp(line.kind, "file") != 0)
      snprintf(out, size, "%.700s are others than when this was computed", line.name);
    else
      snprintf(out, size, "%.700s %s", line.name,
               missing ? "was not read when this was computed" : what);
  } else if (find_change(was, is, true, &line, &missing)) {
    snprintf(out, size, "%.700s was read when this was computed, and is not now", line.name);
  } else {
    snprintf(out, size, "this was computed from the same in another order");
  }
}

/* Digest of a list's first lines; *nline: how many it has. */
static uint64_t digest_of(const char *list, size_t first, size_t *nline)
{
  uint64_t digest = UM_CORE_DIGEST_BEGIN;
  struct line line;
  for (*nline = 0; next_line(&list, &line); ++*nline) {
    uint64_t one = strtoull(line.digest, NULL, 16);
    if (*nline < first) digest = um_core_digest(digest, &one, sizeof one);
  }
  return digest;
}

/* Before anything in the folder is touched. The records themselves say of what they are, too, but
 * not what has changed. whole: nothing will be added to the identity. */
static enum um_status check_list(struct um_context *context,
                                 const struct um_study_identity *identity, const char *folder,
                                 bool whole)
{
  char what[900], *path = NULL, *was = NULL;
  size_t length, nline;
  enum um_status status = UM_OK;
  UM_TRY(um_core_asprintf(context, &path, "%s/" LIST, folder));
  if (access(path, F_OK) != 0) goto done;
  status = um_core_file_read(context, path, LARGE, &was, &length);
  um_core_snapshot_forget(context, path); /* other shares write it, too */
  UM_CHECK(status);
  if (digest_of(was, identity->nline, &nline) == identity->digest &&
      (nline == identity->nline || (nline > identity->nline && !whole)))
    goto done;
  describe_change(was, identity->text, what, sizeof what);
  status =
      um_core_fail(context, UM_ERR_IO,
                   "%s: %s; accepted: that as it was, or another -o, or this folder removed and "
                   "no --resume",
                   folder, what);
done:
  UM_FREE(context, path, was);
  return status;
}

enum um_status um_study_identity_check(struct um_context *context,
                                       const struct um_study_identity *identity, const char *folder)
{
  return check_list(context, identity, folder, false);
}

/* --- the list beside the records ------------------------------------------------------------- */

static enum um_status write_list(struct um_context *context, const char *path, const char *text)
{
  struct um_core_whole_file whole;
  UM_TRY(um_core_whole_begin(context, path, &whole));
  return um_core_whole_end(context, &whole,
                           um_core_file_write(context, path, text, strlen(text), whole.file));
}

enum um_status um_study_identity_open(struct um_context *context,
                                      const struct um_study_identity *identity,
                                      const struct um_batch_task *task, struct um_batch **out)
{
  struct um_batch_task own = *task;
  char *path = NULL;
  enum um_status status = UM_OK;
  own.identity = identity->digest;
  *out = NULL;
  if (task->resume || task->nshare > 1) /* or other shares are at work there */
    UM_TRY(check_list(context, identity, task->folder, true));
  UM_TRY(um_batch_open(context, &own, out));
  if (!um_batch_leads(*out)) return UM_OK;
  UM_CHECK(um_core_asprintf(context, &path, "%s/" LIST, task->folder));
  UM_CHECK(write_list(context, path, identity->text));
done:
  um_core_free(context, path);
  if (status != UM_OK) um_batch_close(context, out);
  return status;
}

void um_study_records_remove(struct um_context *context, const char *folder)
{
  char *path;
  if (um_core_asprintf(context, &path, "%s/" LIST, folder) == UM_OK) {
    um_core_file_stale_temporaries_remove(context, path);
    (void)unlink(path);
    um_core_free(context, path);
  }
  um_batch_records_remove(context, folder);
}
