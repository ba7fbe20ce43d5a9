/* run.xdmf: opens run.nc in ParaView, the mesh with the temperatures of both sides over time;
 * NaN where a side does not radiate. */
#include "output/output.h"

enum um_status um_output_write_xdmf(const struct um_output_run *run, FILE *file)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(run->model->geometry);
  const struct um_model_result *r = run->result;
  static const char *const sides[2] = {"front", "back"};
  fputs("<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
        "<Grid Name=\"satellite\" GridType=\"Collection\" CollectionType=\"Temporal\">\n",
        file);
  for (size_t k = 0; k < r->nobs; k++) {
    fprintf(file, "<Grid Name=\"t%zu\"><Time Value=\"%.3f\"/>\n", k,
            run->precomputed->t_obs[k] - run->precomputed->t_obs[0]);
    fprintf(file,
            "<Topology TopologyType=\"Triangle\" NumberOfElements=\"%zu\"><DataItem "
            "Dimensions=\"%zu 3\" NumberType=\"UInt\" Format=\"HDF\">run.nc:/facet_vertex"
            "</DataItem></Topology>\n",
            mesh->nfacet, mesh->nfacet);
    fprintf(file,
            "<Geometry GeometryType=\"XYZ\"><DataItem Dimensions=\"%zu 3\" NumberType=\"Float\" "
            "Precision=\"8\" Format=\"HDF\">run.nc:/vertex_position</DataItem></Geometry>\n",
            mesh->nvertex);
    for (int side = 0; side < 2; side++)
      fprintf(file,
              "<Attribute Name=\"%s_temperature_K\" Center=\"Cell\"><DataItem "
              "ItemType=\"HyperSlab\" Dimensions=\"%zu\"><DataItem Dimensions=\"3 2\" "
              "Format=\"XML\">%zu 0 1 1 1 %zu</DataItem><DataItem Dimensions=\"%zu %zu\" "
              "NumberType=\"Float\" Precision=\"8\" Format=\"HDF\">run.nc:/%s_temperature"
              "</DataItem></DataItem></Attribute>\n",
              sides[side], mesh->nfacet, k, mesh->nfacet, r->nobs, mesh->nfacet, sides[side]);
    fputs("</Grid>\n", file);
  }
  fputs("</Grid>\n</Domain>\n</Xdmf>\n", file);
  return UM_OK;
}
