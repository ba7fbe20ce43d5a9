/* The names of files in a document, rewritten for another folder. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/file.h"
#include "base/document/document_impl.h"

struct move {
  struct um_context *context;
  struct um_document *document;
  const char *folder; /* real path, without a slash at its end unless it is the root */
};

static enum um_status move_object(struct move *m, const struct um_schema_object *object,
                                  struct um_node *node);

/* Real path of the folder that a path leads through, free() frees; NULL: there is none. */
static char *folder_of(const char *path)
{
  const char *slash = strrchr(path, '/');
  if (slash == NULL) return realpath(".", NULL);
  char *cut = strndup(path, (size_t)(slash - path) + 1);
  char *real = cut == NULL ? NULL : realpath(cut, NULL);
  free(cut);
  return real;
}

/* Real path of a file's folder, then the file's own name, which may be a link; where there is no
 * such folder, the whole name from the document's. */
static enum um_status find_file(struct move *m, const char *name, char **out)
{
  char *path = NULL;
  enum um_status status = UM_OK;
  *out = NULL;
  UM_TRY(um_core_path_resolve(m->context, m->document->path, name, &path));
  const char *slash = strrchr(path, '/'), *file = slash == NULL ? path : slash + 1;
  char *real = folder_of(path);
  if (real == NULL && (real = folder_of(m->document->path)) != NULL) file = name;
  if (real == NULL)
    status = um_core_fail(m->context, UM_ERR_IO, "%s: %s", name, strerror(errno));
  else
    status = um_core_asprintf(m->context, out, "%s/%s", strcmp(real, "/") == 0 ? "" : real, file);
  free(real);
  um_core_free(m->context, path);
  return status;
}

/* How `path` is reached from `folder`, both absolute; the caller frees. */
static enum um_status relative_path(struct um_context *context, const char *folder,
                                    const char *path, char **out)
{
  size_t common = 0; /* bytes of whole names that both begin with, up to a slash of `path` */
  for (size_t i = 0; folder[i] == path[i] || (folder[i] == '\0' && path[i] == '/'); i++) {
    if (path[i] == '/') common = i;
    if (folder[i] == '\0' || path[i] == '\0') break;
  }
  if (common == 0) return um_core_strdup(context, path, out);
  size_t up = 0;
  for (const char *c = folder + common; *c != '\0'; c++) up += *c == '/';
  char *text;
  UM_TRY(um_core_allocate(context, 3 * up + strlen(path + common) + 1, 1, &text));
  for (size_t i = 0; i < up; i++) memcpy(text + 3 * i, "../", 3);
  strcpy(text + 3 * up, path + common + 1);
  *out = text;
  return UM_OK;
}

static enum um_status move_name(struct move *m, struct um_node *node)
{
  if (node->kind != UM_NODE_SCALAR || node->text[0] == '/' || node->text[0] == '\0') return UM_OK;
  char *path = NULL, *text = NULL;
  enum um_status status;
  UM_CHECK(find_file(m, node->text, &path));
  UM_CHECK(relative_path(m->context, m->folder, path, &text));
  if (strcmp(text, node->text) == 0) goto done;
  UM_CHECK(um_document_copy_text(m->document, text, strlen(text), &node->text));
  node->plain = node->plain && strpbrk(text, " :#,[]{}&*!|>'\"%@`") == NULL;
  m->document->set_count++;
done:
  UM_FREE(m->context, path, text);
  return status;
}

static enum um_status move_field(struct move *m, const struct um_schema_field *field,
                                 struct um_node *node)
{
  if (field->file && field->type == UM_SCHEMA_TEXT) return move_name(m, node);
  if (field->file)
    for (struct um_node *n = node->first; n != NULL; n = n->next) UM_TRY(move_name(m, n));
  if (field->type == UM_SCHEMA_MAP) return move_object(m, field->object, node);
  if (field->type == UM_SCHEMA_LIST || field->type == UM_SCHEMA_DICT)
    for (struct um_node *n = node->first; n != NULL; n = n->next)
      UM_TRY(move_object(m, field->object, n));
  return UM_OK;
}

static enum um_status move_object(struct move *m, const struct um_schema_object *object,
                                  struct um_node *node)
{
  if (node->kind == UM_NODE_SCALAR && object->scalar_key != NULL)
    return move_field(m, um_document_schema_find(object, object->scalar_key), node);
  for (struct um_node *n = node->first; n != NULL; n = n->next) {
    const struct um_schema_field *field =
        n->key == NULL ? NULL : um_document_schema_find(object, n->key);
    if (field != NULL) UM_TRY(move_field(m, field, n));
  }
  return UM_OK;
}

enum um_status um_document_move(struct um_context *context, struct um_document *document,
                                const struct um_schema_object *schema, const char *folder)
{
  char *real = realpath(folder, NULL);
  if (real == NULL) return um_core_fail(context, UM_ERR_IO, "%s: %s", folder, strerror(errno));
  struct move m = {context, document, real};
  enum um_status status = move_object(&m, schema, document->root);
  free(real);
  return status;
}
