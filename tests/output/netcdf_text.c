/* Attributes of text: what the library reads back is what was put, whatever its length, up to a
 * scenario's 2 MiB and beyond HDF5's 64 KiB; short ones stay characters. */
#include "output/netcdf_text.h"

#include <netcdf.h>
#include <netcdf_mem.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/support/cmocka_all.h"

#define NC(call) assert_int_equal((call), NC_NOERR)

/* `length` bytes that differ, lines among them; the caller frees. */
static char *text_of(size_t length)
{
  char *text = malloc(length + 1);
  assert_non_null(text);
  for (size_t i = 0; i < length; i++) text[i] = i % 71 == 70 ? '\n' : (char)('!' + i * i % 90);
  text[length] = '\0';
  return text;
}

static void expect(int file, int variable, const char *name, nc_type kind, const char *text)
{
  nc_type type;
  size_t n;
  NC(nc_inq_att(file, variable, name, &type, &n));
  assert_int_equal(type, kind);
  if (type == NC_STRING) {
    char *found = NULL;
    assert_int_equal(n, 1);
    NC(nc_get_att_string(file, variable, name, &found));
    assert_string_equal(found, text);
    NC(nc_free_string(1, &found));
    return;
  }
  char *found = calloc(n + 1, 1);
  assert_non_null(found);
  assert_int_equal(n, strlen(text));
  NC(nc_get_att_text(file, variable, name, found));
  assert_string_equal(found, text);
  free(found);
}

static void lengths(void **state)
{
  (void)state;
  static const struct {
    size_t length;
    nc_type kind;
  } cases[] = {{1, NC_CHAR},       {60000, NC_CHAR},    {60001, NC_STRING},
               {65535, NC_STRING}, {100000, NC_STRING}, {2097152, NC_STRING}};
  enum { N = sizeof cases / sizeof cases[0] };
  char name[N][32];
  int file, variable[2] = {NC_GLOBAL};
  NC_memio image = {0};
  NC(nc_create_mem("text.nc", NC_NETCDF4, 65536, &file));
  NC(nc_def_var(file, "v", NC_INT, 0, NULL, &variable[1]));
  for (int i = 0; i < N; i++) { /* all in one file, some on a variable */
    char *text = text_of(cases[i].length);
    snprintf(name[i], sizeof name[i], "text%d", i);
    NC(um_output_netcdf_text(file, variable[i % 2], name[i], text));
    free(text);
  }
  NC(nc_close_memio(file, &image));
  NC(nc_open_mem("text.nc", NC_NOWRITE, image.size, image.memory, &file));
  for (int i = 0; i < N; i++) {
    char *text = text_of(cases[i].length);
    expect(file, variable[i % 2], name[i], cases[i].kind, text);
    free(text);
  }
  NC(nc_close(file));
  free(image.memory);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(lengths)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
