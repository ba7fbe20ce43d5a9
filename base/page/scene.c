/* The satellite of a page in three dimensions (format.md). */
#include <math.h>

#include "base/core/json.h"
#include "base/page/page_impl.h"

static void put_names(FILE *file, const char *key, const char *const *name, size_t count)
{
  fprintf(file, ",\n\"%s\": [", key);
  for (size_t i = 0; i < count; i++) {
    if (i > 0) fputs(", ", file);
    um_core_json_string(file, name[i]);
  }
  fputc(']', file);
}

static void integers(struct um_page *page, FILE *file, const char *before, const char *key,
                     const uint32_t *value, size_t count)
{
  if (value == NULL) return;
  fprintf(file, "%s\"%s\": ", before, key);
  um_page_put_integers(page, file, value, count);
}

static void floats(struct um_page *page, FILE *file, const char *key, const double *value,
                   size_t count)
{
  if (value == NULL) return;
  fprintf(file, ",\n\"%s\": ", key);
  um_page_put_floats(page, file, value, count);
}

static void put_quantities(struct um_page *page, FILE *file, const struct um_page_scene *s)
{
  fputs(",\n\"quantities\": [", file);
  for (size_t i = 0; i < s->nquantity; i++) {
    const struct um_page_quantity *q = &s->quantity[i];
    um_core_json_text(file, i > 0 ? ",\n{" : "\n{", "id", q->id);
    um_page_key(file, "name", q->name);
    um_page_key(file, "unit", q->unit);
    um_page_key(file, "scale", q->scale == UM_PAGE_LOG ? "log" : "linear");
    fputs(", \"data\": ", file);
    um_page_put_steps(page, file, q->value, s->ntime * s->nsurface);
    fputc('}', file);
  }
  fputc(']', file);
}

static void put_scene(struct um_page *page, FILE *file, const struct um_page_scene *s)
{
  fputs("{\"vertices\": ", file);
  um_page_put_floats(page, file, s->vertex, 3 * s->nvertex);
  integers(page, file, ",\n", "triangles", s->triangle, 3 * s->ntriangle);
  integers(page, file, ",\n", "surface", s->surface, s->ntriangle);
  integers(page, file, ",\n", "body", s->body, s->ntriangle);
  fprintf(file, ",\n\"surfaces\": {\"count\": %zu", s->nsurface);
  integers(page, file, ", ", "part", s->part, s->nsurface);
  integers(page, file, ", ", "material", s->material, s->nsurface);
  fputc('}', file);
  put_names(file, "parts", s->part_name, s->npart);
  put_names(file, "materials", s->material_name, s->nmaterial);
  if (s->time != NULL) {
    fputs(",\n\"time\": ", file);
    um_page_put_doubles(page, file, s->time, s->ntime);
  }
  floats(page, file, "observer", s->observer, 3 * s->ntime);
  floats(page, file, "sun", s->sun, 3 * s->ntime);
  floats(page, file, "nadir", s->nadir, 3 * s->ntime);
  floats(page, file, "velocity", s->velocity, 3 * s->ntime);
  floats(page, file, "up", s->up, 3 * s->ntime);
  floats(page, file, "sunlit", s->sunlit, s->ntime);
  fputs(",\n\"bodies\": [", file);
  for (size_t i = 0; i < s->nbody; i++) {
    um_core_json_text(file, i > 0 ? ", {" : "{", "name", s->bodies[i].name);
    floats(page, file, "pose", s->bodies[i].pose, 7 * s->ntime);
    fputc('}', file);
  }
  fputc(']', file);
  put_quantities(page, file, s);
  fputc('}', file);
}

void um_page_scene(struct um_page *page, const struct um_page_figure *figure,
                   const struct um_page_scene *scene)
{
  FILE *file = um_page_figure_begin(page, figure, "scene");
  um_page_key(file, "quantity", scene->nquantity > 0 ? scene->quantity[0].id : "material");
  fputc('}', file);
  put_scene(page, page->scene.file, scene);
}
