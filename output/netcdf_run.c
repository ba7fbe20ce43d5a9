/* run.nc: everything of a run with units and axes, netCDF-4 (HDF5), CF conventions 1.8.
 *
 * Dimensions carry coordinates of the same name where they have one: `time` as a UTC clock shows
 * it, `wavelength`, and names for part, node, material, band, mechanism and axes. A stock reader
 * then selects by them: ds.irradiance.sel(band="lwir") in xarray. */
#include "output/netcdf_impl.h"

static enum um_status put_attributes(const struct um_output_netcdf *w)
{
  const struct um_output_run *run = w->run;
  char *scenario = NULL;
  UM_TRY(um_document_text(w->context, run->model->document, &scenario));
  const char *text[][2] = {{"Conventions", "CF-1.8"}, {"title", run->model->scenario->name},
                           {"source", "umbra"},       {"version", run->version},
                           {"command", run->command}, {"scenario", scenario}};
  enum um_status status = UM_OK;
  for (size_t i = 0; status == UM_OK && i < sizeof text / sizeof text[0]; i++)
    status = um_output_netcdf_note(w, NULL, text[i][0], text[i][1]);
  um_core_free(w->context, scenario);
  return status;
}

/* Names of materials and of axes, which several groups share. */
static enum um_status put_names(const struct um_output_netcdf *w)
{
  static const char *const axes[3] = {"x", "y", "z"};
  static const char *const elements[4] = {"w", "x", "y", "z"};
  const char **names = NULL;
  size_t n = w->length[UM_NC_MATERIAL];
  UM_TRY(um_core_allocate(w->context, n, sizeof *names, &names));
  for (size_t i = 0; i < n; i++) names[i] = um_geometry_material_name(w->run->model->geometry, i);
  enum um_status status = um_output_netcdf_names(w, UM_NC_MATERIAL, "materials", names);
  um_core_free(w->context, names);
  UM_TRY(status);
  UM_TRY(um_output_netcdf_names(w, UM_NC_XYZ, "axes of a frame", axes));
  return um_output_netcdf_names(w, UM_NC_QUATERNION, "elements of a quaternion", elements);
}

enum um_status um_output_write_netcdf(struct um_context *context, const struct um_output_run *run,
                                      FILE *file)
{
  struct um_output_netcdf w = {.context = context, .run = run};
  enum um_status status;
  UM_TRY(um_output_netcdf_open(&w));
  UM_CHECK(put_attributes(&w));
  UM_CHECK(put_names(&w));
  UM_CHECK(um_output_netcdf_times(&w));
  UM_CHECK(um_output_netcdf_geometry(&w));
  UM_CHECK(um_output_netcdf_heat(&w));
  UM_CHECK(um_output_netcdf_solids(&w));
  UM_CHECK(um_output_netcdf_light(&w));
done:;
  enum um_status closed = um_output_netcdf_close(&w, status == UM_OK ? file : NULL);
  return status != UM_OK ? status : closed;
}
