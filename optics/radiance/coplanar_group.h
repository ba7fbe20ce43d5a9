/* Surfaces that an instant sees, in coplanar groups. */
#ifndef UMBRA_OPTICS_COPLANAR_GROUP_H
#define UMBRA_OPTICS_COPLANAR_GROUP_H

#include "optics/radiance/radiance_group.h"

/* Coplanar groups: surfaces of one skin whose normals make the same angles with observer, lamp,
 * their bisector and nadir, and whose grain runs the same way: on the facets of a wall all that
 * depends on directions is the same. Surfaces with patches stand alone. */
struct um_optics_coplanar {
  size_t count, ngroup;
  struct um_optics_sight *sight; /* [count] group after group */
  uint32_t *surface;             /* [count] */
  float *lit_error;              /* [count] standard error of the share that the lamp lights */
  size_t *first;                 /* [ngroup + 1] */
  uint32_t *of, *seen;           /* [count] group of each surface seen, in the order of surfaces */
};
enum um_status um_optics_coplanar_create(struct um_context *context, size_t nsurface,
                                         struct um_optics_coplanar *coplanar);
void um_optics_coplanar_clear(struct um_context *context, struct um_optics_coplanar *coplanar);
/* Those of the view that are seen at an instant, or may be within the error of what was traced, and
 * what its lamp lights of them; a Moon that does not shine is not asked for. */
void um_optics_coplanar_fill(const struct um_optics_spectra *spectra,
                             const struct um_optics_scene *scene,
                             const struct um_optics_instant *now, const struct um_optics_work *work,
                             struct um_optics_coplanar *coplanar);

#endif
