/* The scene of a model at an instant. */
#ifndef UMBRA_MODEL_TIMELINE_H
#define UMBRA_MODEL_TIMELINE_H

#include "model/build/model.h"

/* The scene at a satellite time. to_observer is zero and range NaN. */
enum um_status um_model_sample_at(struct um_context *context, const struct um_model *model,
                                  double t_tai, struct um_environment_sample *out);
/* What attitude laws look at, at a satellite time. */
enum um_status um_model_attitude_input(struct um_context *context, const struct um_model *model,
                                       double t_tai, struct um_orbit_attitude_input *out);
/* The attitude `before` [s] ahead of a scene, with place, motion and Sun as they are there: what a
 * law that turns makes of the body alone. */
enum um_status um_model_sample_turned(struct um_context *context, const struct um_model *model,
                                      const struct um_environment_sample *sample, double before,
                                      struct um_quat *q);
/* The scene as seen at an observer time (light received), with light time where the scenario has
 * it. UM_ERR_INPUT without an observer. */
enum um_status um_model_sample_seen(struct um_context *context, const struct um_model *model,
                                    double t_observer, struct um_environment_sample *out,
                                    struct um_orbit_look *look);
/* The same as seen from one of the model's stations. */
enum um_status um_model_sample_from(struct um_context *context, const struct um_model *model,
                                    size_t station, double t_observer,
                                    struct um_environment_sample *out, struct um_orbit_look *look);
/* Eclipse events between two satellite times; the caller frees *out. */
enum um_status um_model_events(struct um_context *context, const struct um_model *model,
                               double from, double to, struct um_environment_event **out,
                               size_t *count);

/* An observation that stands alone (orbit.points): where the satellite was seen. */
struct um_model_point {
  double t;                  /* t_tai [s], light received */
  double height;             /* of the satellite above the WGS-84 ellipsoid [m] */
  double azimuth, elevation; /* [rad], airless, north over east */
  size_t station;            /* of the model's stations */
};
/* The scene at a point, at the time of emission where the scenario has light time; the place, and
 * with it the range, is that of emission. v is 0. UM_ERR_INPUT for a scenario with an orbit, or
 * errors of um_orbit_observer_locate. */
enum um_status um_model_sample_point(struct um_context *context, const struct um_model *model,
                                     const struct um_model_point *point,
                                     struct um_environment_sample *out, struct um_orbit_look *look);

#endif
