/* run.xdmf: opens run.nc in ParaView: the mesh with the temperatures of both sides over time, NaN
 * where a side does not radiate; where there are solids, their tetrahedra with the temperatures
 * inside. */
#include "output/bodies_impl.h"
#include "output/output.h"

static void begin(const struct um_output_run *run, const char *grid, size_t k, FILE *file)
{
  fprintf(file, "<Grid Name=\"%s%zu\"><Time Value=\"%.3f\"/>\n", grid, k,
          run->tables->t_obs[k] - run->tables->t_obs[0]);
}

static void mesh_of(const char *topology, size_t n, int corners, const char *corner, size_t nvertex,
                    const char *vertex, FILE *file)
{
  fprintf(file,
          "<Topology TopologyType=\"%s\" NumberOfElements=\"%zu\"><DataItem "
          "Dimensions=\"%zu %d\" NumberType=\"UInt\" Format=\"HDF\">run.nc:/%s"
          "</DataItem></Topology>\n",
          topology, n, n, corners, corner);
  fprintf(file,
          "<Geometry GeometryType=\"XYZ\"><DataItem Dimensions=\"%zu 3\" NumberType=\"Float\" "
          "Precision=\"8\" Format=\"HDF\">run.nc:/%s</DataItem></Geometry>\n",
          nvertex, vertex);
}

/* Row k of a variable [nobs][n]. */
static void values_of(const char *name, const char *centre, size_t k, size_t nobs, size_t n,
                      const char *variable, FILE *file)
{
  fprintf(file,
          "<Attribute Name=\"%s\" Center=\"%s\"><DataItem "
          "ItemType=\"HyperSlab\" Dimensions=\"%zu\"><DataItem Dimensions=\"3 2\" "
          "Format=\"XML\">%zu 0 1 1 1 %zu</DataItem><DataItem Dimensions=\"%zu %zu\" "
          "NumberType=\"Float\" Precision=\"8\" Format=\"HDF\">run.nc:/%s"
          "</DataItem></DataItem></Attribute>\n",
          name, centre, n, k, n, nobs, n, variable);
}

static void solids(const struct um_output_run *run, FILE *file)
{
  const struct um_thermal_body *body = run->model->body;
  const struct um_model_result *r = run->result;
  size_t n = um_output_solid_vertices(body);
  if (n == 0) return;
  fputs("<Grid Name=\"solids\" GridType=\"Collection\" CollectionType=\"Temporal\">\n", file);
  for (size_t k = 0; k < r->nobs; k++) {
    begin(run, "inside", k, file);
    mesh_of("Tetrahedron", body->ntetrahedron, 4, "tetrahedron_vertex", n, "solid_vertex_position",
            file);
    values_of("temperature_K", "Node", k, r->nobs, n, "solid_vertex_temperature", file);
    fputs("</Grid>\n", file);
  }
  fputs("</Grid>\n", file);
}

enum um_status um_output_write_xdmf(const struct um_output_run *run, FILE *file)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(run->model->geometry);
  const struct um_model_result *r = run->result;
  fputs("<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
        "<Grid Name=\"satellite\" GridType=\"Collection\" CollectionType=\"Temporal\">\n",
        file);
  for (size_t k = 0; k < r->nobs; k++) {
    begin(run, "t", k, file);
    mesh_of("Triangle", mesh->nfacet, 3, "facet_vertex", mesh->nvertex, "vertex_position", file);
    values_of("front_temperature_K", "Cell", k, r->nobs, mesh->nfacet, "front_temperature", file);
    values_of("back_temperature_K", "Cell", k, r->nobs, mesh->nfacet, "back_temperature", file);
    fputs("</Grid>\n", file);
  }
  fputs("</Grid>\n", file);
  solids(run, file);
  fputs("</Domain>\n</Xdmf>\n", file);
  return UM_OK;
}
