// The only place that knows TetGen 1.5 (Si 2015, ACM TOMS 41, 11), which has no C interface.
// Compiled without UMBRA_TETGEN it says that TetGen is absent.
#include "thermal/network/tetgen_impl.h"

#ifdef UMBRA_TETGEN

#define TETLIBRARY
#include <cstddef>
#include <cstring>
#include <new>
#include <string>
#include <tetgen.h>

static void fill(tetgenio &in, const double *point, int npoint, const int *facet, int nfacet,
                 const double *hole, int nhole)
{
  in.firstnumber = 0;
  in.numberofpoints = npoint;
  in.pointlist = new REAL[3 * static_cast<size_t>(npoint)];
  std::memcpy(in.pointlist, point, 3 * sizeof(double) * static_cast<size_t>(npoint));
  in.numberoffacets = nfacet;
  in.facetlist = new tetgenio::facet[static_cast<size_t>(nfacet)];
  in.facetmarkerlist = new int[static_cast<size_t>(nfacet)];
  for (int f = 0; f < nfacet; f++) {
    tetgenio::init(&in.facetlist[f]);
    in.facetmarkerlist[f] = f + 1;
    in.facetlist[f].numberofpolygons = 1;
    in.facetlist[f].polygonlist = new tetgenio::polygon[1];
    tetgenio::polygon &polygon = in.facetlist[f].polygonlist[0];
    polygon.numberofvertices = 3;
    polygon.vertexlist = new int[3];
    std::memcpy(polygon.vertexlist, facet + 3 * static_cast<std::ptrdiff_t>(f), 3 * sizeof(int));
  }
  in.numberofholes = nhole;
  if (nhole == 0) return;
  in.holelist = new REAL[3 * static_cast<size_t>(nhole)];
  std::memcpy(in.holelist, hole, 3 * sizeof(double) * static_cast<size_t>(nhole));
}

int um_thermal_tetgen_call(const char *switches, const double *point, int npoint, const int *facet,
                           int nfacet, const double *hole, int nhole,
                           struct um_thermal_tetgen_result *out)
{
  try {
    tetgenio *in = new tetgenio, *result = new tetgenio; // kept: the child process exits
    fill(*in, point, npoint, facet, nfacet, hole, nhole);
    std::string text(switches);
    tetrahedralize(&text[0], in, result);
    out->npoint = result->numberofpoints;
    out->ntetrahedron = result->numberoftetrahedra;
    out->nface = result->trifacemarkerlist != nullptr ? result->numberoftrifaces : 0;
    out->point = result->pointlist;
    out->tetrahedron = result->tetrahedronlist;
    out->face_marker = result->trifacemarkerlist;
    return UM_TETGEN_OK;
  } catch (int code) {
    return code > 0 ? code : UM_TETGEN_UNKNOWN;
  } catch (const std::bad_alloc &) {
    return UM_TETGEN_MEMORY;
  } catch (...) {
    return UM_TETGEN_UNKNOWN;
  }
}

int um_thermal_tetgen_present(void) { return 1; }

#else

int um_thermal_tetgen_call(const char *, const double *, int, const int *, int, const double *, int,
                           struct um_thermal_tetgen_result *)
{
  return UM_TETGEN_ABSENT;
}

int um_thermal_tetgen_present(void) { return 0; }

#endif
