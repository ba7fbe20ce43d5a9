/* Looking for heat place by place. Private to evidence/missing_heat/. */
#ifndef UMBRA_MISSING_HEAT_LOOK_IMPL_H
#define UMBRA_MISSING_HEAT_LOOK_IMPL_H

#include "evidence/missing_heat/change_impl.h"
#include "evidence/missing_heat/heat.h"

struct um_missing_heat_look {
  struct um_missing_heat_base base;
  struct um_missing_heat_place *place;
  size_t nplace;
  struct um_inference_projection projection;
  double *residual; /* [nleft] */
  double *column;   /* [UM_MISSING_HEAT_TOGETHER][nbin][nobservation] */
  size_t nobs;
  double *t;                             /* [nobs] at the satellite */
  size_t *edge;                          /* [nbin + 1] of the observations */
  size_t nbin;                           /* of the first look */
  double *time;                          /* [nobs] scratch of edges */
  bool *wanted;                          /* [nobs] scratch */
  size_t *origin;                        /* [heat] place of each result */
  struct um_missing_heat_choice *choice; /* [place] of the first look */
};

/* Places, times and edges; base and projection are there. Errors of memory. */
enum um_status um_missing_heat_look_begin(struct um_context *context,
                                          struct um_missing_heat_look *look);
void um_missing_heat_look_release(struct um_context *context, struct um_missing_heat_look *look);

/* The first look at every place: heat [nplace], which fills as *nheat grows. UM_ERR_CANCELLED, and
 * errors of the thermal solution. */
enum um_status um_missing_heat_look_everywhere(struct um_context *context,
                                               struct um_missing_heat_look *look,
                                               struct um_missing_heat *heat, size_t *nheat);
/* A second look at one, with all times near its edges, and by runs of the model. */
enum um_status um_missing_heat_look_again(struct um_context *context,
                                          struct um_missing_heat_look *look, size_t place,
                                          struct um_missing_heat *heat);

#endif
