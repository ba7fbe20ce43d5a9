/* Meshes by Assimp, as Wavefront OBJ, which is what we read: so a name, a corner and a size are
 * looked at in one place. In a child process, as importers meet files of any origin: with limits on
 * memory and time, and it can open no file, so that names within a mesh lead nowhere.
 *
 * A group is a node that has a mesh; where it has several, NODE.MATERIAL. */
#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>

#include "base/core/child.h"
#include "base/core/text.h"
#include "geometry/foreign_mesh_impl.h"

#define SECONDS  10.0  /* and one for every so many bytes: */
#define BYTES    1.0e6 /* a tenth of what is read in one */
#define MEGABYTE 4096
#define DEEPEST  64 /* nodes below nodes */
#define SAYS     400

/* What the child is given, and its state. */
struct work {
  const char *bytes, *hint;
  size_t length;
  int pipe;
  char buffer[1 << 16]; /* on its way to the pipe */
  size_t used;
  bool broken;
  unsigned long vertices; /* written so far */
};

static void flush(struct work *w)
{
  w->broken = w->broken || !um_core_child_write(w->pipe, w->buffer, w->used);
  w->used = 0;
}

static void put(struct work *w, const char *format, ...) UM_PRINTF(2, 3);
static void put(struct work *w, const char *format, ...)
{
  va_list arguments;
  if (sizeof w->buffer - w->used < 1024) flush(w);
  va_start(arguments, format);
  int n = vsnprintf(w->buffer + w->used, sizeof w->buffer - w->used, format, arguments);
  va_end(arguments);
  if (n > 0) w->used += (size_t)n;
}

/* A name as one line of OBJ. */
static void put_name(struct work *w, const char *statement, const char *name, const char *of)
{
  char text[2 * UM_CORE_NAME_LONGEST + 2];
  if (snprintf(text, UM_CORE_NAME_LONGEST, "%s%s%s", name, of[0] != '\0' ? "." : "", of) < 0)
    text[0] = '\0';
  um_geometry_foreign_name(text);
  put(w, "%s %s\n", statement, text[0] != '\0' ? text : "mesh");
}

/* p in the frame of the scene. */
static struct aiVector3D moved(const struct aiMatrix4x4 *m, const struct aiVector3D *p)
{
  return (struct aiVector3D){m->a1 * p->x + m->a2 * p->y + m->a3 * p->z + m->a4,
                             m->b1 * p->x + m->b2 * p->y + m->b3 * p->z + m->b4,
                             m->c1 * p->x + m->c2 * p->y + m->c3 * p->z + m->c4};
}

static bool is_turned(const struct aiMatrix4x4 *m)
{
  return m->a1 * (m->b2 * m->c3 - m->b3 * m->c2) - m->a2 * (m->b1 * m->c3 - m->b3 * m->c1) +
             m->a3 * (m->b1 * m->c2 - m->b2 * m->c1) <
         0.0F;
}

static void put_mesh(struct work *w, const struct aiMesh *mesh, const struct aiMatrix4x4 *frame)
{
  bool turned = is_turned(frame); /* a mirrored node turns its faces */
  for (unsigned i = 0; i < mesh->mNumVertices; i++) {
    struct aiVector3D p = moved(frame, &mesh->mVertices[i]);
    put(w, "v %.9g %.9g %.9g\n", (double)p.x, (double)p.y, (double)p.z);
  }
  for (unsigned f = 0; f < mesh->mNumFaces; f++) {
    const struct aiFace *face = &mesh->mFaces[f];
    if (face->mNumIndices < 3) continue; /* points and lines */
    put(w, "f");
    for (unsigned k = 0; k < face->mNumIndices; k++) {
      unsigned corner = face->mIndices[turned ? face->mNumIndices - 1 - k : k];
      put(w, " %lu", w->vertices + corner + 1);
    }
    put(w, "\n");
  }
  w->vertices += mesh->mNumVertices;
}

static const char *material_of(const struct aiScene *scene, const struct aiMesh *mesh,
                               struct aiString *name)
{
  name->data[0] = '\0';
  if (mesh->mMaterialIndex < scene->mNumMaterials)
    (void)aiGetMaterialString(scene->mMaterials[mesh->mMaterialIndex], AI_MATKEY_NAME, name);
  return name->data;
}

static void put_node(struct work *w, const struct aiScene *scene, const struct aiNode *node,
                     const struct aiMatrix4x4 *above, int depth)
{
  struct aiMatrix4x4 frame = *above;
  aiMultiplyMatrix4(&frame, &node->mTransformation);
  for (unsigned i = 0; i < node->mNumMeshes; i++) {
    const struct aiMesh *mesh = scene->mMeshes[node->mMeshes[i]];
    struct aiString material;
    /* "<STL_BINARY>" and the like are Assimp's own */
    const char *name =
        node->mName.data[0] == '<' || node->mName.length == 0 ? mesh->mName.data : node->mName.data;
    (void)material_of(scene, mesh, &material);
    put_name(w, "g", name, node->mNumMeshes > 1 ? material.data : "");
    put_name(w, "usemtl", material.data, "");
    put_mesh(w, mesh, &frame);
  }
  for (unsigned i = 0; i < node->mNumChildren && depth < DEEPEST; i++)
    put_node(w, scene, node->mChildren[i], &frame, depth + 1);
}

/* The child's life. The first byte is '+', or '-' with what Assimp says behind it. */
static int child_work(void *self, int pipe_end)
{
  struct work *w = self;
  const struct rlimit none = {0, 0};
  struct aiMatrix4x4 frame;
  w->pipe = pipe_end;
  if (setrlimit(RLIMIT_NOFILE, &none) != 0) return 1;
  const struct aiScene *scene = aiImportFileFromMemory(
      w->bytes, (unsigned)w->length,
      aiProcess_Triangulate | aiProcess_FindInvalidData | aiProcess_ValidateDataStructure, w->hint);
  if (scene == NULL || scene->mRootNode == NULL) {
    put(w, "-%.300s", aiGetErrorString());
  } else {
    put(w, "+");
    aiIdentityMatrix4(&frame);
    put_node(w, scene, scene->mRootNode, &frame, 0);
  }
  flush(w);
  return w->broken ? 1 : 0;
}

enum um_status um_geometry_assimp_read(struct um_context *context, const char *path,
                                       const char *format, const char *hint, const char *bytes,
                                       size_t length, char **obj, size_t *n)
{
  enum um_status status;
  struct work *work = NULL;
  struct um_core_child_result in = {0};
  const struct um_core_child_limits limits = {SECONDS + (double)length / BYTES, MEGABYTE};
  UM_CHECK(um_core_allocate(context, 1, sizeof *work, &work));
  *work = (struct work){.bytes = bytes, .hint = hint, .length = length};
  UM_CHECK(um_core_child_run(context, "Assimp", child_work, work, &limits, &in));
  if (in.end == UM_CHILD_TIMED_OUT)
    status = um_core_fail(context, UM_ERR_INPUT,
                          "%s: this %s was not read within %.0f s: is the file whole?", path,
                          format, limits.seconds);
  else if (in.end == UM_CHILD_SIGNALLED || in.code != 0 || in.count == 0)
    status = um_core_fail(context, UM_ERR_INPUT,
                          "%s: the importer crashed on this %s (%s %d): is the file whole?", path,
                          format, in.end == UM_CHILD_SIGNALLED ? "signal" : "exit", in.code);
  else if (in.answer[0] != '+') {
    char says[SAYS];
    snprintf(says, sizeof says, "%.*s", (int)(in.count < SAYS ? in.count - 1 : SAYS - 1),
             in.answer + 1);
    um_core_text_make_line(says);
    status = um_core_fail(context, UM_ERR_INPUT,
                          "%s: this %s is not read: %s; accepted: a whole file, all in one", path,
                          format, says);
  } else {
    *n = in.count - 1;
    UM_CHECK(um_core_allocate(context, *n + 1, 1, obj));
    memcpy(*obj, in.answer + 1, *n);
  }
done:
  UM_FREE(context, work, in.answer);
  return status;
}
