/* Unstructured grids of VTK (XML, "File Formats for VTK Version 4.2"): arrays in base64, a length
 * of 32 bits before the bytes. */
#include "output/vtu.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/core/csv.h"
#include "output/bodies_impl.h"

#define TRIANGLE    5 /* cell types of VTK */
#define TETRAHEDRON 10

/* Bytes on their way into base64, three by three. */
struct base64 {
  FILE *file;
  unsigned char waiting[3];
  int n;
};

static void put_three(struct base64 *to)
{
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const unsigned char *w = to->waiting;
  char text[4] = {digits[w[0] >> 2], digits[(w[0] & 3) << 4 | w[1] >> 4],
                  digits[(w[1] & 15) << 2 | w[2] >> 6], digits[w[2] & 63]};
  if (to->n < 3) text[3] = '=';
  if (to->n < 2) text[2] = '=';
  fwrite(text, 1, sizeof text, to->file);
  memset(to->waiting, 0, sizeof to->waiting);
  to->n = 0;
}

static void put_bytes(struct base64 *to, const void *bytes, size_t n)
{
  const unsigned char *at = bytes;
  for (size_t i = 0; i < n; i++) {
    to->waiting[to->n++] = at[i];
    if (to->n == 3) put_three(to);
  }
}

static void put_array(FILE *file, const char *type, const char *name, int components,
                      const void *data, size_t bytes)
{
  struct base64 to = {.file = file};
  uint32_t length = (uint32_t)bytes;
  fprintf(file, "<DataArray type=\"%s\" Name=\"%s\"", type, name);
  if (components > 1) fprintf(file, " NumberOfComponents=\"%d\"", components);
  fputs(" format=\"binary\">", file);
  put_bytes(&to, &length, sizeof length);
  put_bytes(&to, data, bytes);
  if (to.n > 0) put_three(&to);
  fputs("</DataArray>\n", file);
}

/* A grid of cells with equally many corners. */
struct grid {
  const double *point; /* [npoint][3] */
  const int *corner;   /* [ncell][corners] */
  size_t npoint, ncell;
  int corners;
  unsigned char type;
};

static enum um_status put_grid(struct um_context *context, const struct grid *grid, FILE *file)
{
  enum um_status status;
  int *offset = NULL;
  unsigned char *type = NULL;
  UM_CHECK(um_core_allocate(context, grid->ncell, sizeof *offset, &offset));
  UM_CHECK(um_core_allocate(context, grid->ncell, sizeof *type, &type));
  for (size_t i = 0; i < grid->ncell; i++) {
    offset[i] = (int)(i + 1) * grid->corners;
    type[i] = grid->type;
  }
  fprintf(file,
          "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
          "byte_order=\"%s\" header_type=\"UInt32\">\n<UnstructuredGrid>\n"
          "<Piece NumberOfPoints=\"%zu\" NumberOfCells=\"%zu\">\n<Points>\n",
          __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ ? "LittleEndian" : "BigEndian", grid->npoint,
          grid->ncell);
  put_array(file, "Float64", "Points", 3, grid->point, 3 * grid->npoint * sizeof(double));
  fputs("</Points>\n<Cells>\n", file);
  put_array(file, "Int32", "connectivity", 1, grid->corner,
            grid->ncell * (size_t)grid->corners * sizeof(int));
  put_array(file, "Int32", "offsets", 1, offset, grid->ncell * sizeof(int));
  put_array(file, "UInt8", "types", 1, type, grid->ncell);
  fputs("</Cells>\n", file);
done:
  UM_FREE(context, offset, type);
  return status;
}

static void put_tail(FILE *file) { fputs("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n", file); }

/* --- the outside ----------------------------------------------------------------------------- */

/* Numbers and temperatures of the facets; one array serves all. */
struct outside {
  int *corner, *number; /* [3 nfacet], [nfacet] */
  double *point, *t;    /* [3 nvertex], [nfacet] */
};

static uint32_t side_of(const struct um_geometry_mesh *mesh, size_t facet, bool back)
{
  return back ? mesh->surface_of_back[facet] : mesh->surface_of_front[facet];
}

static void put_sides(const struct um_output_run *run, size_t k, struct outside *o, FILE *file)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(run->model->geometry);
  const struct um_model_result *r = run->result;
  size_t n = mesh->nfacet;
  for (int back = 0; back < 2; back++) {
    for (size_t f = 0; f < n; f++) {
      uint32_t s = side_of(mesh, f, back == 1);
      o->number[f] = s == UM_GEOMETRY_NONE ? -1 : (int)mesh->surface[s].material;
      o->t[f] = s == UM_GEOMETRY_NONE ? (double)NAN : r->surface_temperature[k * r->nsurface + s];
    }
    put_array(file, "Float64", back ? "back_temperature_K" : "front_temperature_K", 1, o->t,
              n * sizeof *o->t);
    put_array(file, "Int32", back ? "back_material" : "front_material", 1, o->number,
              n * sizeof *o->number);
  }
  for (size_t f = 0; f < n; f++) o->number[f] = (int)mesh->facet_part[f];
  put_array(file, "Int32", "part", 1, o->number, n * sizeof *o->number);
  for (size_t f = 0; f < n; f++) o->number[f] = (int)mesh->facet_group[f];
  put_array(file, "Int32", "group", 1, o->number, n * sizeof *o->number);
}

static enum um_status write_outside(struct um_context *context, const struct um_output_run *run,
                                    size_t k, struct outside *o, FILE *file)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(run->model->geometry);
  UM_TRY(um_output_vertices(context, run, k, o->point));
  const struct grid grid = {o->point, o->corner, mesh->nvertex, mesh->nfacet, 3, TRIANGLE};
  UM_TRY(put_grid(context, &grid, file));
  fputs("<CellData>\n", file);
  put_sides(run, k, o, file);
  fputs("</CellData>\n", file);
  put_tail(file);
  return UM_OK;
}

/* --- the inside of solids -------------------------------------------------------------------- */

struct inside {
  int *corner, *node; /* [4 ntetrahedron], [nvertex] */
  double *point, *t;  /* [3 nvertex], [nvertex] */
  size_t npoint;
};

static enum um_status write_inside(struct um_context *context, const struct um_output_run *run,
                                   size_t k, struct inside *in, FILE *file)
{
  const struct um_thermal_body *body = run->model->body;
  const struct um_model_result *r = run->result;
  const struct grid grid = {in->point, in->corner, in->npoint, body->ntetrahedron, 4, TETRAHEDRON};
  for (size_t v = 0; v < in->npoint; v++)
    in->t[v] = r->node_temperature[k * r->nnode + (size_t)in->node[v]];
  UM_TRY(put_grid(context, &grid, file));
  fputs("<PointData>\n", file);
  put_array(file, "Float64", "temperature_K", 1, in->t, in->npoint * sizeof *in->t);
  fputs("</PointData>\n", file);
  put_tail(file);
  return UM_OK;
}

/* --- files ----------------------------------------------------------------------------------- */

static void put_name(FILE *file, const char *array, size_t number, const char *name)
{
  fprintf(file, "%s,%zu", array, number);
  um_core_csv_put_text(file, name, "");
  fputc('\n', file);
}

static enum um_status write_names(struct um_context *context, const struct um_output_run *run,
                                  struct um_core_folder *folder)
{
  const struct um_geometry *g = run->model->geometry;
  FILE *file = NULL;
  UM_TRY(um_core_folder_open(context, folder, "names.csv", &file));
  fputs("array,number,name\n", file);
  for (size_t i = 0; i < um_geometry_part_count(g); i++)
    put_name(file, "part", i, um_geometry_part_name(g, i));
  for (uint32_t i = 0; i < um_geometry_group_count(g); i++) {
    const struct um_geometry_group *group = um_geometry_group(g, i);
    char name[1024];
    snprintf(name, sizeof name, "%s.%s", um_geometry_part_name(g, group->part), group->name);
    put_name(file, "group", i, name);
  }
  for (size_t i = 0; i < um_geometry_material_count(g); i++)
    put_name(file, "material", i, um_geometry_material_name(g, i));
  return um_core_file_close(context, "names.csv", &file);
}

/* NAME.pvd: which file is of which time. */
static enum um_status write_collection(struct um_context *context, const struct um_output_run *run,
                                       const char *grid, struct um_core_folder *folder)
{
  FILE *file = NULL;
  char name[64];
  snprintf(name, sizeof name, "%s.pvd", grid);
  UM_TRY(um_core_folder_open(context, folder, name, &file));
  fputs("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n",
        file);
  for (size_t k = 0; k < run->result->nobs; k++)
    fprintf(file, "<DataSet timestep=\"%.3f\" file=\"%s-%04zu.vtu\"/>\n",
            run->tables->t_obs[k] - run->tables->t_obs[0], grid, k);
  fputs("</Collection>\n</VTKFile>\n", file);
  return um_core_file_close(context, name, &file);
}

static enum um_status write_observations(struct um_context *context,
                                         const struct um_output_run *run, struct outside *outside,
                                         struct inside *inside, struct um_core_folder *folder)
{
  FILE *file = NULL;
  char name[64];
  for (size_t k = 0; k < run->result->nobs; k++) {
    UM_TRY(um_core_stop_check(context, "grids were written"));
    snprintf(name, sizeof name, "satellite-%04zu.vtu", k);
    UM_TRY(um_core_folder_open(context, folder, name, &file));
    enum um_status status = write_outside(context, run, k, outside, file);
    enum um_status closed = um_core_file_close(context, name, &file);
    UM_TRY(status);
    UM_TRY(closed);
    if (inside->npoint == 0) continue;
    snprintf(name, sizeof name, "solids-%04zu.vtu", k);
    UM_TRY(um_core_folder_open(context, folder, name, &file));
    status = write_inside(context, run, k, inside, file);
    closed = um_core_file_close(context, name, &file);
    UM_TRY(status);
    UM_TRY(closed);
  }
  return UM_OK;
}

enum um_status um_output_write_vtu(struct um_context *context, const struct um_output_run *run,
                                   struct um_core_folder *folder)
{
  enum um_status status;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(run->model->geometry);
  const struct um_thermal_body *body = run->model->body;
  struct outside o = {0};
  struct inside in = {.npoint = um_output_solid_vertices(body)};
  UM_CHECK(um_core_allocate(context, 3 * mesh->nfacet, sizeof *o.corner, &o.corner));
  UM_CHECK(um_core_allocate(context, mesh->nfacet, sizeof *o.number, &o.number));
  UM_CHECK(um_core_allocate(context, mesh->nfacet, sizeof *o.t, &o.t));
  UM_CHECK(um_core_allocate(context, 3 * mesh->nvertex, sizeof *o.point, &o.point));
  UM_CHECK(um_core_allocate(context, 4 * body->ntetrahedron, sizeof *in.corner, &in.corner));
  UM_CHECK(um_core_allocate(context, 3 * in.npoint, sizeof *in.point, &in.point));
  UM_CHECK(um_core_allocate(context, in.npoint, sizeof *in.t, &in.t));
  UM_CHECK(um_core_allocate(context, in.npoint, sizeof *in.node, &in.node));
  for (size_t i = 0; i < 3 * mesh->nfacet; i++) o.corner[i] = (int)mesh->corner[i / 3][i % 3];
  um_output_solids(body, in.point, in.node, in.corner);
  UM_CHECK(write_names(context, run, folder));
  UM_CHECK(write_collection(context, run, "satellite", folder));
  if (in.npoint > 0) UM_CHECK(write_collection(context, run, "solids", folder));
  UM_CHECK(write_observations(context, run, &o, &in, folder));
done:
  UM_FREE(context, o.corner, o.number, o.point, o.t, in.corner, in.point, in.t, in.node);
  return status;
}
