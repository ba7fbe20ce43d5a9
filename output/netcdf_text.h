/* Attributes of text in netCDF files, of any length. */
#ifndef UMBRA_OUTPUT_NETCDF_TEXT_H
#define UMBRA_OUTPUT_NETCDF_TEXT_H

/* Put an attribute on a variable (NC_GLOBAL: on the file); a code of the library. Characters
 * (NC_CHAR) as readers expect them; of more than 60000 bytes one string (NC_STRING), which readers
 * find under the same name and HDF5 keeps outside the header, where 64 KiB are the most.
 * Test: output/netcdf_text. */
int um_output_netcdf_text(int file, int variable, const char *name, const char *text);

#endif
