/* Private to thermal/network/: the pieces around TetGen. Read by C and C++. */
#ifndef UMBRA_THERMAL_TETGEN_IMPL_H
#define UMBRA_THERMAL_TETGEN_IMPL_H

#ifdef __cplusplus
extern "C" {
#endif

/* What TetGen gave; the memory is TetGen's and is never released (the child exits). */
struct um_thermal_tetgen_result {
  int npoint, ntetrahedron, nface;
  const double *point;    /* [npoint][3] */
  const int *tetrahedron; /* [ntetrahedron][4] */
  const int *face_marker; /* [nface] 1 + index of the input facet */
};
enum {
  UM_TETGEN_OK = 0, /* > 0: the code that TetGen threw; 3: self-intersection */
  UM_TETGEN_MEMORY = 1,
  UM_TETGEN_CROSSING = 3,
  UM_TETGEN_ABSENT = -2,
  UM_TETGEN_UNKNOWN = -1
};
/* Run TetGen with switches on a triangle surface: point [npoint][3], facet [nfacet][3], hole seeds
 * [nhole][3]. May crash or not return: call in a child process. */
int um_thermal_tetgen_call(const char *switches, const double *point, int npoint, const int *facet,
                           int nfacet, const double *hole, int nhole,
                           struct um_thermal_tetgen_result *out);
/* 1 when TetGen is compiled in. */
int um_thermal_tetgen_present(void);

#ifdef __cplusplus
}
#else

#include "thermal/network/tetgen.h"

struct um_thermal_tetgen_limits {
  double seconds;  /* of processor and of wall clock */
  size_t megabyte; /* beyond what this process has */
};
/* um_thermal_tetgen_fill with limits of one's own. */
enum um_status um_thermal_tetgen_fill_limited(struct um_context *context, const char *name,
                                              const struct um_vec3 *vertex, size_t nvertex,
                                              const uint32_t (*facet)[3], size_t nfacet,
                                              double edge,
                                              const struct um_thermal_tetgen_limits *limits,
                                              struct um_thermal_tetrahedra **out);
#endif

#endif
