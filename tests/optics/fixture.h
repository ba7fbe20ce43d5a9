/* A small scene for the optics tests: grey materials, parts, samples, and the two calls. */
#ifndef UMBRA_TESTS_OPTICS_FIXTURE_H
#define UMBRA_TESTS_OPTICS_FIXTURE_H

#include "optics/radiance/optics.h"
#include "tests/support/cmocka_all.h"

#define FIXTURE_MATERIALS 16
#define FIXTURE_RANGE     1.0e6 /* [m] */

struct fixture {
  struct um_context *context;
  struct um_materials_library *library;
  struct um_geometry *geometry;
  struct um_environment environment;
  struct um_environment_sample *samples; /* [ntime] */
  size_t ntime;
  uint64_t seed; /* of the points that look */
  const struct um_materials_record *record[FIXTURE_MATERIALS];
  double *temperature; /* [ntime][nsurface] */
  float *albedo, *view_factor;
  struct um_optics_view *view;
  struct um_optics_lightcurve *curve;
  struct um_optics_scene scene;
};

extern const struct um_optics_band fixture_vis;  /* 0.38-0.78 um, 20 bins */
extern const struct um_optics_band fixture_lwir; /* 8-12 um, 40 bins */

/* Fails the test with Umbra's message unless the call succeeds. */
#define FIXTURE_OK(fixture, call)                                                                  \
  do {                                                                                             \
    if ((call) != UM_OK) fail_msg("%s", um_core_message((fixture)->context));                      \
  } while (0)

void fixture_create(struct fixture *f);
void fixture_destroy(struct fixture *f);
/* A grey record: rho_d and constant F of a lobe of `alpha` (0: no lobe) in VIS, emissivity in LWIR.
 */
void fixture_material(struct fixture *f, const char *name, double diffuse, double specular,
                      double alpha, double emissivity);
/* An opaque body of index n + i k at all wavelengths, with a lobe of `alpha`. */
void fixture_metal(struct fixture *f, const char *name, double n, double k, double alpha);
/* A record as it stands in a file. */
void fixture_record(struct fixture *f, const char *text);
/* A record of the same reflectances at all wavelengths; lobe: lines of YAML, or "". */
void fixture_reflector(struct fixture *f, const char *name, double diffuse, double specular,
                       const char *lobe);
/* A record of a measured table, 0.15/pi + 0.5 f of GGX of alpha 0.3 every 2.5 deg, which absorbs
 * the rest, at all wavelengths. */
void fixture_measured(struct fixture *f, const char *name);
/* Spec of a part with one material on both sides (back only where the shape is open). */
struct um_geometry_part_spec fixture_part(const char *name, enum um_geometry_shape shape,
                                          const struct um_geometry_skin *skin);
/* Geometry of the parts and ntime samples: identity attitude, 1 au, full sunlight, observer and Sun
 * toward +z, range 1000 km; all at 300 K without light from the Earth. */
void fixture_scene(struct fixture *f, const struct um_geometry_part_spec *parts, size_t npart,
                   size_t ntime);
/* Scene number c of many: a box and a plate of drawn sizes, the plate at least `apart` away [m] in
 * a drawn direction and turned at random; materials with lobes. */
void fixture_pair(struct fixture *f, uint64_t c, double apart, size_t ntime);
/* Draw k of scene c: in [0, 1); a direction of two of them, k and k + 1. */
double fixture_uniform(uint64_t c, uint64_t k);
struct um_vec3 fixture_direction(uint64_t c, uint64_t k);
/* Trace and compute, replacing earlier results. */
void fixture_run(struct fixture *f, int nsample, const struct um_optics_band *bands, size_t nband);
/* Band intensity of a mechanism summed over materials [W/sr]. */
double fixture_intensity(const struct fixture *f, size_t time, size_t band,
                         enum um_optics_mechanism mechanism);
/* Exact solar irradiance of a band at 1 au [W/m^2]. */
double fixture_sun(const struct fixture *f, const struct um_optics_band *band);
/* Fails unless |value - expected| <= relative * |expected|; prints both. */
void fixture_close(const char *what, double value, double expected, double relative);
/* Within four standard errors, false alarm 6e-5 if the error is Gaussian, the error above 0 and at
 * most largest * |expected|; prints all. */
void fixture_within(const char *what, double value, double expected, double error, double largest);

#endif
