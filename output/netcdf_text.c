/* Attributes of text; why there are two kinds stands in the header. */
#include "output/netcdf_text.h"

#include <netcdf.h>
#include <string.h>

#define CHARACTERS_MAX 60000 /* HDF5 takes 65535 with what describes them [bytes] */

int um_output_netcdf_text(int file, int variable, const char *name, const char *text)
{
  size_t length = strlen(text);
  if (length <= CHARACTERS_MAX) return nc_put_att_text(file, variable, name, length, text);
  return nc_put_att_string(file, variable, name, 1, &text);
}
