/* Times of observations. Private to model/. */
#ifndef UMBRA_MODEL_PRECOMPUTE_IMPL_H
#define UMBRA_MODEL_PRECOMPUTE_IMPL_H

#include "model/model.h"

/* The time at which an observation of that tag was really made. */
double um_model_true_time(const struct um_model *model, double tag);

#endif
