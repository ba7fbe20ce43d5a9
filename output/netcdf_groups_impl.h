/* Private to the writers of run.nc: its groups of variables, one per file. */
#ifndef UMBRA_OUTPUT_NETCDF_GROUPS_IMPL_H
#define UMBRA_OUTPUT_NETCDF_GROUPS_IMPL_H

#include "output/netcdf_impl.h"

enum um_status um_output_netcdf_times(const struct um_output_netcdf *w);
enum um_status um_output_netcdf_geometry(const struct um_output_netcdf *w);
enum um_status um_output_netcdf_heat(const struct um_output_netcdf *w);
enum um_status um_output_netcdf_solids(const struct um_output_netcdf *w);
enum um_status um_output_netcdf_light(const struct um_output_netcdf *w);

#endif
