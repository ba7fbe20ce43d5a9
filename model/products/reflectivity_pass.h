/* A pass on a reflectivity map: where the phase vector goes, what the map says there, and what the
 * renderer says of the same directions. */
#ifndef UMBRA_MODEL_REFLECTIVITY_PASS_H
#define UMBRA_MODEL_REFLECTIVITY_PASS_H

#include "model/products/reflectivity_map.h"

struct um_model_map_pass {
  size_t n, nband;
  double *t;                            /* [n] t_tai, light received [s] */
  struct um_environment_sample *sample; /* [n] */
  struct um_vec3 *sun, *observer;       /* [n] unit, body axes */
  struct um_model_phase_vector *at;     /* [n] */
  double *light;                        /* [n][nband] sunlight there, through the filter [W/m^2] */
  /* reflectivity [n][nband] [m^2/sr]: looked up, looked up at the smallest phase angle alone,
   * computed for the directions themselves, and the standard error of that */
  double *looked_up, *smallest, *direct, *error;
};

/* Of given scenes, which have an observer: samples[n] and their times t[n], copied. */
enum um_status um_model_map_pass_of(struct um_context *context, const struct um_model *model,
                                    const struct um_model_map *map,
                                    const struct um_environment_sample *samples, const double *t,
                                    size_t n, struct um_model_map_pass **out);
/* At the scenario's own times. UM_ERR_INPUT without an observer or with orbit.points. The caller
 * destroys. */
enum um_status um_model_map_pass_create(struct um_context *context, const struct um_model *model,
                                        const struct um_model_map *map,
                                        struct um_model_map_pass **out);
void um_model_map_pass_destroy(struct um_context *context, struct um_model_map_pass **pass);

/* How the look-up differs from the direct simulation over a pass: sums of intensities in sunlight
 * [W/sr], every instant alike. */
struct um_model_map_difference {
  size_t count;         /* instants in sunlight */
  double mean;          /* direct */
  double bias, rms;     /* of what is looked up */
  double bias_0, rms_0; /* of what is looked up at the smallest phase angle alone */
};
struct um_model_map_difference um_model_map_difference(const struct um_model_map_pass *pass,
                                                       size_t band);

#endif
