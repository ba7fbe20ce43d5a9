/* CHOLMOD is opened when a solid first wants it, not linked. Through it comes the BLAS that the
 * system has chosen. OpenBLAS, as most systems choose it, starts a thread for every core before
 * main, waits at the end of the process for each, and its buffer of 128 MiB is asked for again and
 * again where memory is short: a process that never ends. Here it is told beforehand to have no
 * threads, and gets its buffer only where there is one. */
#define _DEFAULT_SOURCE /* setenv, MAP_ANONYMOUS */
#include "thermal/solver/cholmod_library_impl.h"

#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#define BUFFER    ((size_t)160 << 20) /* OpenBLAS's buffer with room for what is beside it [byte] */
#define LIBRARIES ((size_t)64 << 20)  /* CHOLMOD and its BLAS, which may take the buffer at once */

/* POSIX lets a pointer to data become one to a function; C does not. */
static bool find(void *handle, const char *name, void *function)
{
  void *address = dlsym(handle, name);
  memcpy(function, &address, sizeof address);
  return address != NULL;
}

static bool is_there(size_t bytes)
{
  void *probe = mmap(NULL, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (probe == MAP_FAILED) return false;
  munmap(probe, bytes);
  return true;
}

/* Is there memory for the buffer? Then it is taken: by a product of one number, through the first
 * routine that CHOLMOD would call. */
static bool make_buffer(void *handle)
{
  void (*update)(const char *, const char *, const int *, const int *, const double *,
                 const double *, const int *, const double *, double *, const int *);
  if (dlsym(handle, "openblas_get_config") == NULL) return true;
  if (!is_there(BUFFER)) return false;
  const int one = 1;
  const double a = 1.0, zero = 0.0;
  double c = 0.0;
  if (find(handle, "dsyrk_", &update)) update("L", "N", &one, &one, &a, &a, &one, &zero, &c, &one);
  return true;
}

static enum um_status no_room(struct um_context *context)
{
  return um_core_fail(context, UM_ERR_MEMORY,
                      "out of memory: the linear algebra of solids wants %zu MiB", BUFFER >> 20);
}

static enum um_status open_library(struct um_context *context, struct um_thermal_cholmod_library *l)
{
  (void)setenv("OPENBLAS_NUM_THREADS", "1", 1);
  if (!is_there(BUFFER + LIBRARIES)) return no_room(context);
  void *handle = dlopen(UMBRA_CHOLMOD, RTLD_NOW | RTLD_LOCAL);
  if (handle == NULL)
    return um_core_fail(context, UM_ERR_LIBRARY, "CHOLMOD cannot be opened: %s", dlerror());
  bool whole = true;
#define FIND(name) whole = find(handle, "cholmod_l_" #name, &l->name) && whole;
  UM_THERMAL_CHOLMOD_LIST(FIND)
#undef FIND
  if (!whole) {
    dlclose(handle);
    return um_core_fail(context, UM_ERR_LIBRARY, UMBRA_CHOLMOD " is no CHOLMOD");
  }
  return make_buffer(handle) ? UM_OK : no_room(context);
}

enum um_status um_thermal_cholmod_open(struct um_context *context,
                                       const struct um_thermal_cholmod_library **out)
{
  static struct um_thermal_cholmod_library library;
  static bool there;
  enum um_status status = UM_OK;
#pragma omp critical(um_thermal_cholmod)
  {
    if (!there) status = open_library(context, &library);
    there = status == UM_OK;
  }
  *out = &library;
  return status;
}
