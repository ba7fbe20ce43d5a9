/* The parts of a new scenario from the groups of an OBJ. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "app/app.h"
#include "app/new.h"

#define MILLIMETRES 100.0 /* a satellite that is longer than this is drawn in millimetres [m] */
#define MATERIAL    "aluminium_anodised" /* of a group that names none */
#define EDGES       12.0                 /* facets along the diagonal */

/* A text that grows. */
struct page {
  char *text;
  size_t length;
  FILE *file;
};

/* Records that there are. */
struct records {
  char *const *record; /* [n] of the library */
  size_t n;
  const struct um_app_new_materials *own;
};

/* Material of a group: what its usemtl names where there is such a record, else `other`. */
static const char *material_of(const char *usemtl, const char *other, const struct records *r)
{
  for (size_t i = 0; i < r->n && usemtl != NULL; i++)
    if (strcmp(r->record[i], usemtl) == 0) return usemtl;
  for (size_t i = 0; i < r->own->n && usemtl != NULL; i++)
    if (strcmp(r->own->stands[i], usemtl) == 0) return r->own->name[i];
  return usemtl != NULL ? MATERIAL : other;
}

/* "bus" of "bus.sides" where all groups of the part begin so, else the name of its first group; a
 * name of a part has none of . / : , ; quotes and blanks. */
static void name_part(const struct um_geometry_obj_look *look, size_t part, char name[64])
{
  const char *first = NULL;
  size_t n = 0;
  for (size_t g = 0; g < look->ngroup; g++) {
    if (look->group[g].part != part) continue;
    const char *of = look->group[g].name;
    if (first == NULL) n = strcspn(first = of, ".");
    if (strncmp(of, first, n) != 0 || (of[n] != '.' && of[n] != '\0')) n = strlen(first);
  }
  if (first == NULL || n == 0) n = strlen(first = "part");
  snprintf(name, 64, "%.*s", (int)(n < 60 ? n : 60), first);
  for (char *c = name; *c != '\0'; c++)
    if (strchr("./:,;'\"= +-@{}[]#&*!|>%`?", *c) != NULL) *c = '_';
}

/* The same with a number where an earlier part has it. */
static void name_uniquely(char (*name)[80], size_t part)
{
  char wanted[64];
  snprintf(wanted, sizeof wanted, "%.60s", name[part]);
  int number = 2;
  for (size_t i = 0; i < part; i++)
    if (strcmp(name[i], name[part]) == 0) {
      snprintf(name[part], 80, "%s_%d", wanted, number++);
      i = (size_t)-1; /* from the beginning */
    }
}

static enum um_status check_groups(struct um_context *context, const char *name,
                                   const struct um_geometry_obj_look *look)
{
  for (size_t g = 0; g < look->ngroup; g++) {
    const struct um_geometry_obj_group *group = &look->group[g];
    if (group->nclosed == 0 || group->nclosed == group->nfacet) continue;
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: group '%.80s' holds %zu triangles of closed bodies and %zu of open "
                        "surfaces, which have two sides; accepted: groups of one kind",
                        name, group->name, group->nclosed, group->nfacet - group->nclosed);
  }
  return UM_OK;
}

static void put_part(FILE *file, const char *mesh, double scale, const char *name,
                     const struct um_geometry_obj_look *look, size_t part,
                     const struct records *records)
{
  bool closed = true;
  const char *comma = "";
  fprintf(file, "  - name: \"%s\"\n    mesh: {file: \"%s\", scale: %g", name, mesh, scale);
  if (look->npart > 1) {
    fputs(", groups: [", file);
    for (size_t g = 0; g < look->ngroup; g++) {
      if (look->group[g].part != part) continue;
      fprintf(file, "%s\"%s\"", comma, look->group[g].name);
      comma = ", ";
    }
    fputc(']', file);
  }
  fputs("}\n    materials:\n", file);
  for (size_t g = 0; g < look->ngroup; g++) {
    const struct um_geometry_obj_group *group = &look->group[g];
    if (group->part != part) continue;
    const char *front = material_of(group->usemtl, MATERIAL, records);
    closed = closed && group->nclosed > 0;
    if (group->nclosed > 0)
      fprintf(file, "      \"%s\": %s\n", group->name, front);
    else
      fprintf(file, "      \"%s\": {front: %s, back: %s}   # open: both of its sides\n",
              group->name, front, material_of(group->usemtl_back, front, records));
  }
  fputs("    # heat capacity of the walls by their area: 1.5 mm of aluminium\n"
        "    shell: {areal_heat_capacity_J_m2_K: 3600}\n",
        file);
  if (closed)
    fputs("    # what is inside: heat capacity, electric power that becomes heat, conductance to "
          "the walls\n"
          "    # interior: {capacity_J_K: 2400, power_W: 4, conductance_W_K: 2}\n",
          file);
}

static enum um_status put_parts(struct um_context *context, FILE *file, const char *mesh,
                                double scale, const struct um_geometry_obj_look *look,
                                const struct records *records)
{
  char(*name)[80] = NULL;
  UM_TRY(um_core_allocate(context, look->npart, sizeof *name, &name));
  fputs("parts:\n", file);
  for (size_t part = 0; part < look->npart; part++) {
    name_part(look, part, name[part]);
    name_uniquely(name, part);
    if (part > 0) fputs("\n", file);
    put_part(file, mesh, scale, name[part], look, part, records);
  }
  if (records->own->n > 0) fputs("\nmaterial_files:\n", file);
  for (size_t i = 0; i < records->own->n; i++) fprintf(file, "  - %s\n", records->own->file[i]);
  um_core_free(context, name);
  return UM_OK;
}

/* One digit: 0.0437 becomes 0.04. */
static double rounded(double x)
{
  double unit = pow(10.0, floor(log10(x)));
  return unit * round(x / unit);
}

static enum um_status put_blocks(struct um_context *context, char **text, const char *parts,
                                 double size, double scale)
{
  char thermal[160], comment[700];
  snprintf(
      comment, sizeof comment,
      "# What it is made of: the parts of the mesh. Groups that share edges are one part; its "
      "sides are called by the\n# names of the groups. Change the materials behind the colons: "
      "`umbra list materials`. scale is metres per unit\n# of the file: the mesh is %.3g m long "
      "with %g. How meshes are read: docs/obj.md.\n",
      size * scale, scale);
  UM_TRY(um_app_new_put(context, text, "parts", comment, parts));
  UM_TRY(um_app_new_put(context, text, "contacts",
                        "# Heat that flows between parts by conduction [W/K]: none until it is "
                        "stated, as\n#   contacts:\n#     - {a: ONE, b: OTHER, conductance_W_K: "
                        "0.1}\n",
                        ""));
  snprintf(thermal, sizeof thermal,
           "thermal: {start: periodic, orbits_before: 1, facet_size_m: %g}\n",
           rounded(size * scale / EDGES));
  return um_app_new_put(context, text, "thermal",
                        "# How heat is computed: from the temperatures that repeat orbit after "
                        "orbit. facet_size_m is the longest\n# edge of a facet; smaller ones are "
                        "finer and slower.\n",
                        thermal);
}

enum um_status um_app_new_parts(struct um_context *context, char **text, const char *name,
                                const struct um_geometry_obj_look *look, char *const *record,
                                size_t nrecord, const struct um_app_new_materials *own,
                                double *scale)
{
  const struct records records = {record, nrecord, own};
  enum um_status status;
  struct page page = {NULL, 0, NULL};
  double size = um_vec3_norm(um_vec3_sub(look->high, look->low)); /* [units of the file] */
  *scale = size > MILLIMETRES && !own->metres ? 0.001 : 1.0;
  UM_TRY(check_groups(context, name, look));
  page.file = open_memstream(&page.text, &page.length);
  if (page.file == NULL) return um_core_fail(context, UM_ERR_MEMORY, "out of memory");
  status = put_parts(context, page.file, name, *scale, look, &records);
  if (fclose(page.file) != 0 && status == UM_OK)
    status = um_core_fail(context, UM_ERR_MEMORY, "out of memory");
  if (status == UM_OK) status = put_blocks(context, text, page.text, size, *scale);
  free(page.text);
  return status;
}
