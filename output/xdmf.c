/* run.xdmf: opens run.nc in ParaView, the mesh with its surface temperatures over time. Values are
 * given for the fronts: a facet shows its front's temperature. */
#include "output/output.h"

enum um_status um_output_write_xdmf(const struct um_output_run *run, FILE *file)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(run->model->geometry);
  const struct um_model_result *r = run->result;
  bool one_to_one = mesh->nsurface == mesh->nfacet;
  fputs("<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
        "<Grid Name=\"satellite\" GridType=\"Collection\" CollectionType=\"Temporal\">\n",
        file);
  for (size_t k = 0; k < r->nobs; k++) {
    fprintf(file, "<Grid Name=\"t%zu\"><Time Value=\"%.3f\"/>\n", k,
            run->trace->t_obs[k] - run->trace->t_obs[0]);
    fprintf(file,
            "<Topology TopologyType=\"Triangle\" NumberOfElements=\"%zu\"><DataItem "
            "Dimensions=\"%zu 3\" NumberType=\"UInt\" Format=\"HDF\">run.nc:/facet_vertex"
            "</DataItem></Topology>\n",
            mesh->nfacet, mesh->nfacet);
    fprintf(file,
            "<Geometry GeometryType=\"XYZ\"><DataItem Dimensions=\"%zu 3\" NumberType=\"Float\" "
            "Precision=\"8\" Format=\"HDF\">run.nc:/vertex_position</DataItem></Geometry>\n",
            mesh->nvertex);
    if (one_to_one) {
      fprintf(file,
              "<Attribute Name=\"temperature_K\" Center=\"Cell\"><DataItem ItemType=\"HyperSlab\" "
              "Dimensions=\"1 %zu\"><DataItem Dimensions=\"3 2\" Format=\"XML\">%zu 0 1 1 1 "
              "%zu</DataItem><DataItem Dimensions=\"%zu %zu\" NumberType=\"Float\" Precision=\"8\" "
              "Format=\"HDF\">run.nc:/surface_temperature</DataItem></DataItem></Attribute>\n",
              mesh->nsurface, k, mesh->nsurface, r->nobs, mesh->nsurface);
    } else {
      fprintf(file,
              "<Attribute Name=\"temperature_K\" Center=\"Cell\"><DataItem "
              "ItemType=\"Coordinates\" Dimensions=\"%zu\"><DataItem Dimensions=\"%zu 2\" "
              "Format=\"XML\">",
              mesh->nfacet, mesh->nfacet);
      for (size_t f = 0; f < mesh->nfacet; f++) {
        uint32_t s = mesh->surface_of_front[f] != UM_GEOMETRY_NONE ? mesh->surface_of_front[f]
                                                                   : mesh->surface_of_back[f];
        fprintf(file, "%zu %u ", k, s);
      }
      fprintf(file,
              "</DataItem><DataItem Dimensions=\"%zu %zu\" NumberType=\"Float\" Precision=\"8\" "
              "Format=\"HDF\">run.nc:/surface_temperature</DataItem></DataItem></Attribute>\n",
              r->nobs, mesh->nsurface);
    }
    fputs("</Grid>\n", file);
  }
  fputs("</Grid>\n</Domain>\n</Xdmf>\n", file);
  return UM_OK;
}
